<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>Bistable</name>
  <message>
   <source>{}: cancelled, the document is as it was.</source>
   <translation>{}: abgebrochen, das Dokument ist wie zuvor.</translation>
  </message>
 </context>
 <context>
  <name>BistableAutoFit</name>
  <message>
   <source>Angle by which the first segment leans forward</source>
   <translation>Winkel, um den sich die erste Strecke nach vorn neigt</translation>
  </message>
  <message>
   <source>Auto-fit</source>
   <translation>Automatisch anpassen</translation>
  </message>
  <message>
   <source>Bed, mm</source>
   <translation>Druckbett, mm</translation>
  </message>
  <message>
   <source>Edge length, mm: the width of the tube</source>
   <translation>Kantenlänge, mm: die Breite des Schlauchs</translation>
  </message>
  <message>
   <source>Height of the print (mm)</source>
   <translation>Höhe des Drucks (mm)</translation>
  </message>
  <message>
   <source>How the ratio of every unit is chosen</source>
   <translation>Wie das Verhältnis jeder Einheit gewählt wird</translation>
  </message>
  <message>
   <source>Largest distance of the curve from the tube's blocks, mm</source>
   <translation>Größter Abstand der Kurve von den Blöcken des Schlauchs, mm</translation>
  </message>
  <message>
   <source>Length, width and height of the flat-folded print</source>
   <translation>Länge, Breite und Höhe des flach gefalteten Drucks</translation>
  </message>
  <message>
   <source>Number of units</source>
   <translation>Anzahl der Einheiten</translation>
  </message>
  <message>
   <source>Search</source>
   <translation>Suchen</translation>
  </message>
  <message>
   <source>Search, then choose one of the proposals.</source>
   <translation>Erst suchen, dann einen der Vorschläge wählen.</translation>
  </message>
  <message>
   <source>Smallest snap margin; below 1 is floppy</source>
   <translation>Kleinste Schnappreserve; unter 1 schlaff</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stopped.</source>
   <translation>Angehalten.</translation>
  </message>
  <message>
   <source>Wanted</source>
   <translation>Gewünscht</translation>
  </message>
  <message>
   <source>off</source>
   <translation>daneben</translation>
  </message>
  <message>
   <source>off the curve (mm)</source>
   <translation>neben der Kurve (mm)</translation>
  </message>
  <message>
   <source>print, mm</source>
   <translation>Druck, mm</translation>
  </message>
  <message>
   <source>ratio rule</source>
   <translation>Verhältnisregel</translation>
  </message>
  <message>
   <source>snap</source>
   <translation>Reserve</translation>
  </message>
  <message>
   <source>{n} units, θ {low:.0f}° … {high:.0f}°, ratio rule {rule}: snap margin {margin:.2f} or more (weakest: unit {weakest}); print {size} mm; at most {off:.1f} mm off the curve, {covered:.0%} of it followed.</source>
   <translation>{n} Einheiten, θ {low:.0f}° … {high:.0f}°, Verhältnisregel {rule}: Schnappreserve mindestens {margin:.2f} (am schwächsten: Einheit {weakest}); Druck {size} mm; höchstens {off:.1f} mm neben der Kurve, der sie zu {covered:.0%} folgen.</translation>
  </message>
 </context>
 <context>
  <name>BistableCalibration</name>
  <message>
   <source>When it is printed</source>
   <translation>Wenn sie gedruckt ist</translation>
  </message>
  <message>
   <source>Which is the tightest hinge that turns?</source>
   <translation>Welches ist das engste Scharnier, das sich dreht?</translation>
  </message>
  <message>
   <source>Which pair of plates came apart? (the lower number)</source>
   <translation>Welches Plattenpaar ging auseinander? (die kleinere Zahl)</translation>
  </message>
  <message>
   <source>none of them</source>
   <translation>keines davon</translation>
  </message>
  <message>
   <source>not tried yet</source>
   <translation>noch nicht versucht</translation>
  </message>
  <message>
   <source>the pair with the number {}</source>
   <translation>das Paar mit der Zahl {}</translation>
  </message>
 </context>
 <context>
  <name>BistableCheck</name>
  <message>
   <source>Ask OpenSCAD too (about {} min)</source>
   <translation>OpenSCAD fragen (etwa {} min)</translation>
  </message>
  <message>
   <source>Check for this printer</source>
   <translation>Für diesen Drucker prüfen</translation>
  </message>
  <message>
   <source>Check {}</source>
   <translation>{} prüfen</translation>
  </message>
  <message>
   <source>Clearances in the flat print…</source>
   <translation>Abstände im flachen Druck …</translation>
  </message>
  <message>
   <source>Closed solids…</source>
   <translation>Geschlossene Körper …</translation>
  </message>
  <message>
   <source>Do it: {}. Then everything is checked anew</source>
   <translation>Das tun: {}. Danach wird alles neu geprüft</translation>
  </message>
  <message>
   <source>Errors: {}. Correct them first.</source>
   <translation>Fehler: {}. Zuerst beheben.</translation>
  </message>
  <message>
   <source>Fix</source>
   <translation>Beheben</translation>
  </message>
  <message>
   <source>Layer height</source>
   <translation>Schichthöhe</translation>
  </message>
  <message>
   <source>Layers and overhangs…</source>
   <translation>Schichten und Überhänge …</translation>
  </message>
  <message>
   <source>Looks whether the toolpaths keep bodies that move apart.</source>
   <translation>Sieht nach, ob die Werkzeugwege bewegliche Körper getrennt lassen.</translation>
  </message>
  <message>
   <source>Making the meshes…</source>
   <translation>Netze werden erstellt …</translation>
  </message>
  <message>
   <source>No errors. Warnings to read before you print: {}.</source>
   <translation>Keine Fehler. Warnungen, die vor dem Druck zu lesen sind: {}.</translation>
  </message>
  <message>
   <source>Nothing speaks against printing.</source>
   <translation>Nichts spricht gegen den Druck.</translation>
  </message>
  <message>
   <source>Nozzle</source>
   <translation>Düse</translation>
  </message>
  <message>
   <source>OpenSCAD renders the mesh with exact numbers.</source>
   <translation>OpenSCAD berechnet das Netz mit exakten Zahlen.</translation>
  </message>
  <message>
   <source>Overlaps when opened to {}…</source>
   <translation>Durchdringungen bei Öffnung {} …</translation>
  </message>
  <message>
   <source>Show: select and mark it in the 3D view</source>
   <translation>Zeigen: in der 3D-Ansicht auswählen und markieren</translation>
  </message>
  <message>
   <source>Size of the print…</source>
   <translation>Größe des Drucks …</translation>
  </message>
  <message>
   <source>Slice it too (PrusaSlicer, about {} min)</source>
   <translation>Slicen (PrusaSlicer, etwa {} min)</translation>
  </message>
  <message>
   <source>Snap of the units…</source>
   <translation>Schnappen der Einheiten …</translation>
  </message>
  <message>
   <source>Ties…</source>
   <translation>Haltestege…</translation>
  </message>
  <message>
   <source>Walls and cones…</source>
   <translation>Wände und Kegel …</translation>
  </message>
  <message>
   <source>… and {} more.</source>
   <translation>… und {} weitere.</translation>
  </message>
 </context>
 <context>
  <name>BistableDeploy</name>
  <message>
   <source>Colour: misfit</source>
   <translation>Farbe: Passfehler</translation>
  </message>
  <message>
   <source>Colour: panels</source>
   <translation>Farbe: Flächenarten</translation>
  </message>
  <message>
   <source>Colour: strain</source>
   <translation>Farbe: Dehnung</translation>
  </message>
  <message>
   <source>Deploy</source>
   <translation>Entfalten</translation>
  </message>
  <message>
   <source>Deploy {}</source>
   <translation>{} entfalten</translation>
  </message>
  <message>
   <source>Every recording makes a folder of its own in this one</source>
   <translation>Jede Aufnahme legt in diesem einen eigenen Ordner an</translation>
  </message>
  <message>
   <source>Folder for recordings</source>
   <translation>Ordner für Aufnahmen</translation>
  </message>
  <message>
   <source>Ghost of its play</source>
   <translation>Geist seines Spiels</translation>
  </message>
  <message>
   <source>How far the deployed tube moves before anything bears</source>
   <translation>Wie weit sich die entfaltete Röhre bewegt, bevor etwas trägt</translation>
  </message>
  <message>
   <source>Loop</source>
   <translation>Wiederholen</translation>
  </message>
  <message>
   <source>Making the film…</source>
   <translation>Der Film wird gemacht …</translation>
  </message>
  <message>
   <source>Picture {} of {}</source>
   <translation>Bild {} von {}</translation>
  </message>
  <message>
   <source>Play</source>
   <translation>Abspielen</translation>
  </message>
  <message>
   <source>Record</source>
   <translation>Aufnehmen</translation>
  </message>
  <message>
   <source>Record {}</source>
   <translation>{} aufnehmen</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>The film is {}.</source>
   <translation>Der Film ist {}.</translation>
  </message>
  <message>
   <source>The picture {} was not written: is the disk full?</source>
   <translation>Das Bild {} wurde nicht geschrieben: Ist die Festplatte voll?</translation>
  </message>
  <message>
   <source>all units move on by themselves here</source>
   <translation>alle Einheiten bewegen sich hier von selbst weiter</translation>
  </message>
  <message>
   <source>deployed</source>
   <translation>entfaltet</translation>
  </message>
  <message>
   <source>flat</source>
   <translation>flach</translation>
  </message>
  <message>
   <source>free end ± {:.1f} mm before anything bears</source>
   <translation>freies Ende ± {:.1f} mm, bevor etwas trägt</translation>
  </message>
  <message>
   <source>misfit up to {} mm (full colour: {} mm)</source>
   <translation>Fehlpassung bis {} mm (volle Farbe: {} mm)</translation>
  </message>
  <message>
   <source>strain up to {:.1%} (full colour: {:.1%}, what {} bears)</source>
   <translation>Dehnung bis {:.1%} (volle Farbe: {:.1%}, was {} aushält)</translation>
  </message>
  <message>
   <source>unit {} moves on by itself here</source>
   <translation>Einheit {} bewegt sich hier von selbst weiter</translation>
  </message>
  <message>
   <source>units {} move on by themselves here</source>
   <translation>Einheiten {} bewegen sich hier von selbst weiter</translation>
  </message>
  <message>
   <source>{:.0%} open</source>
   <translation>{:.0%} offen</translation>
  </message>
  <message>
   <source>{} pictures were written to {}.</source>
   <translation>{} Bilder wurden nach {} geschrieben.</translation>
  </message>
 </context>
 <context>
  <name>BistableExport</name>
  <message>
   <source>A tab along every seam</source>
   <translation>Eine Lasche an jeder Naht</translation>
  </message>
  <message>
   <source>Author</source>
   <translation>Verfasser</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>Farben</translation>
  </message>
  <message>
   <source>Depth of tabs</source>
   <translation>Tiefe der Laschen</translation>
  </message>
  <message>
   <source>Export {}</source>
   <translation>{} exportieren</translation>
  </message>
  <message>
   <source>Fill the panels in the colours of their kinds</source>
   <translation>Die Flächen in den Farben ihrer Art füllen</translation>
  </message>
  <message>
   <source>Gap at the edges</source>
   <translation>Spalt an den Kanten</translation>
  </message>
  <message>
   <source>Glue tabs</source>
   <translation>Klebelaschen</translation>
  </message>
  <message>
   <source>Hinges</source>
   <translation>Scharniere</translation>
  </message>
  <message>
   <source>How far panels end before the axes of their hinges</source>
   <translation>Wie weit Flächen vor den Achsen ihrer Scharniere enden</translation>
  </message>
  <message>
   <source>Kerf</source>
   <translation>Schnittbreite</translation>
  </message>
  <message>
   <source>Sheet</source>
   <translation>Bogen</translation>
  </message>
  <message>
   <source>Sheets to cut from, mm</source>
   <translation>Tafeln zum Zuschneiden, mm</translation>
  </message>
  <message>
   <source>States between flat and deployed, as a series of frames</source>
   <translation>Zustände zwischen flach und entfaltet, als Bilderreihe</translation>
  </message>
  <message>
   <source>States on the way</source>
   <translation>Zwischenzustände</translation>
  </message>
  <message>
   <source>Thickness of panels</source>
   <translation>Dicke der Flächen</translation>
  </message>
  <message>
   <source>Thickness of the sheets that panels are cut from</source>
   <translation>Dicke der Tafeln, aus denen Flächen geschnitten werden</translation>
  </message>
  <message>
   <source>Title</source>
   <translation>Titel</translation>
  </message>
  <message>
   <source>Width of the cut: paths run half of it outside the panels</source>
   <translation>Breite des Schnitts: die Wege laufen um die Hälfte davon außerhalb der Flächen</translation>
  </message>
  <message>
   <source>Width x height of a sheet</source>
   <translation>Breite x Höhe einer Tafel</translation>
  </message>
  <message>
   <source>none</source>
   <translation>keine</translation>
  </message>
  <message>
   <source>the smallest that will do</source>
   <translation>der kleinste, der reicht</translation>
  </message>
  <message>
   <source>{} was not written: the report view says why.</source>
   <translation>{} wurde nicht geschrieben: Die Ausgabeansicht sagt, warum.</translation>
  </message>
 </context>
 <context>
  <name>BistableFirstStart</name>
  <message>
   <source>Another one</source>
   <translation>Ein anderer</translation>
  </message>
  <message>
   <source>New tubes are made for this printer: its bed, nozzle and layers. You can change it under Edit → Preferences → Bistable.</source>
   <translation>Neue Röhren werden für diesen Drucker gemacht: sein Bett, seine Düse und seine Schichten. Ändern lässt es sich unter Bearbeiten → Einstellungen → Bistable.</translation>
  </message>
  <message>
   <source>Not now</source>
   <translation>Jetzt nicht</translation>
  </message>
  <message>
   <source>Use it</source>
   <translation>Verwenden</translation>
  </message>
  <message>
   <source>Your printer</source>
   <translation>Ihr Drucker</translation>
  </message>
 </context>
 <context>
  <name>BistableImport</name>
  <message>
   <source>All lengths are multiplied by this</source>
   <translation>Alle Längen werden damit multipliziert</translation>
  </message>
  <message>
   <source>Choose a curve.</source>
   <translation>Wähle eine Kurve.</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <translation>Eckenradius</translation>
  </message>
  <message>
   <source>Curve</source>
   <translation>Kurve</translation>
  </message>
  <message>
   <source>Ends of pieces that are so near each other are joined</source>
   <translation>Enden von Stücken, die so nah beieinander liegen, werden verbunden</translation>
  </message>
  <message>
   <source>Import {}</source>
   <translation>{} importieren</translation>
  </message>
  <message>
   <source>Join gaps up to</source>
   <translation>Lücken schließen bis</translation>
  </message>
  <message>
   <source>Layer</source>
   <translation>Ebene</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>Maßstab</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Größe</translation>
  </message>
 </context>
 <context>
  <name>BistableLive</name>
  <message>
   <source>Make solids</source>
   <translation>Körper erstellen</translation>
  </message>
  <message>
   <source>Make solids (Enter)</source>
   <translation>Körper erstellen (Eingabe)</translation>
  </message>
  <message>
   <source>Making solids</source>
   <translation>Körper werden erstellt</translation>
  </message>
  <message>
   <source>Stop (Esc)</source>
   <translation>Anhalten (Esc)</translation>
  </message>
  <message>
   <source>{}: solids not up to date</source>
   <translation>{}: Körper nicht aktuell</translation>
  </message>
 </context>
 <context>
  <name>BistablePanel</name>
  <message>
   <source>(none)</source>
   <translation>(keine)</translation>
  </message>
  <message>
   <source>Add in view</source>
   <translation>In der Ansicht</translation>
  </message>
  <message>
   <source>Apply</source>
   <translation>Anwenden</translation>
  </message>
  <message>
   <source>Cancelled: the solids are as they were.</source>
   <translation>Abgebrochen: die Körper sind wie zuvor.</translation>
  </message>
  <message>
   <source>Click points into the 3D view: the tube follows.</source>
   <translation>Punkte in die 3D-Ansicht klicken: der Schlauch folgt.</translation>
  </message>
  <message>
   <source>Close the open task first.</source>
   <translation>Zuerst die offene Aufgabe schließen.</translation>
  </message>
  <message>
   <source>Edit {}</source>
   <translation>{} bearbeiten</translation>
  </message>
  <message>
   <source>Every click into the 3D view adds a point at the end</source>
   <translation>Jeder Klick in die 3D-Ansicht hängt einen Punkt an</translation>
  </message>
  <message>
   <source>Follow the control points instead</source>
   <translation>Stattdessen den Kontrollpunkten folgen</translation>
  </message>
  <message>
   <source>Press Apply or OK to make the solids anew.</source>
   <translation>Anwenden oder OK erstellt die Körper neu.</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Entfernen</translation>
  </message>
  <message>
   <source>Remove the chosen point (or right-click it)</source>
   <translation>Den gewählten Punkt entfernen (oder Rechtsklick darauf)</translation>
  </message>
  <message>
   <source>Select a sketch, a wire or edges first.</source>
   <translation>Zuerst eine Skizze, einen Draht oder Kanten auswählen.</translation>
  </message>
  <message>
   <source>The preview is slow: it follows when you pause.</source>
   <translation>Die Vorschau ist langsam: sie folgt, wenn du innehältst.</translation>
  </message>
  <message>
   <source>Use selection</source>
   <translation>Auswahl nehmen</translation>
  </message>
  <message>
   <source>no</source>
   <translation>nein</translation>
  </message>
  <message>
   <source>none: the points count</source>
   <translation>keine: die Punkte zählen</translation>
  </message>
  <message>
   <source>yes</source>
   <translation>ja</translation>
  </message>
  <message>
   <source>… and {} more</source>
   <translation>… und {} weitere</translation>
  </message>
 </context>
 <context>
  <name>BistablePlots</name>
  <message>
   <source>Aim</source>
   <translation>Zielen</translation>
  </message>
  <message>
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>Energy that opening takes, N·mm</source>
   <translation>Energie, die das Öffnen braucht, N·mm</translation>
  </message>
  <message>
   <source>Energy, {} EA·‖AB‖</source>
   <translation>Energie, {} EA·‖AB‖</translation>
  </message>
  <message>
   <source>Every unit carries what hangs on it so many times, whatever way the tube is turned; or hands that pull ‖AB‖ from the leg at B open it with this force</source>
   <translation>Jede Einheit trägt so viele Male, was an ihr hängt, wie der Schlauch auch gedreht wird; oder Hände, die ‖AB‖ vom Bein bei B ziehen, öffnen sie mit dieser Kraft</translation>
  </message>
  <message>
   <source>How hard does it snap, does it stand?</source>
   <translation>Wie stark schnappt es, steht es?</translation>
  </message>
  <message>
   <source>Opening angle θ</source>
   <translation>Öffnungswinkel θ</translation>
  </message>
  <message>
   <source>Ratio c; line: limit sin(θ/2)</source>
   <translation>Verhältnis c; Linie: Grenze sin(θ/2)</translation>
  </message>
  <message>
   <source>Safety under its own weight; folds below 1</source>
   <translation>Sicherheit unter dem Eigengewicht; klappt unter 1</translation>
  </message>
  <message>
   <source>Select a tube to see its numbers.</source>
   <translation>Einen Schlauch auswählen, um seine Zahlen zu sehen.</translation>
  </message>
  <message>
   <source>Snap margin; floppy below 1</source>
   <translation>Schnappreserve; unter 1 schlaff</translation>
  </message>
  <message>
   <source>Stop ({:.0%})</source>
   <translation>Anhalten ({:.0%})</translation>
  </message>
  <message>
   <source>Stop measuring ({:.0%})</source>
   <translation>Messung abbrechen ({:.0%})</translation>
  </message>
  <message>
   <source>Tube charts</source>
   <translation>Schlauch-Diagramme</translation>
  </message>
  <message>
   <source>Unit {unit} gives way first, at {factor:.1f} times its load.</source>
   <translation>Einheit {unit} gibt zuerst nach, beim {factor:.1f}-fachen ihrer Last.</translation>
  </message>
  <message>
   <source>Unit {unit} gives way first, at {factor:.1f} times its load: aim at more, make edges longer, the tube shorter, or hold both ends.</source>
   <translation>Einheit {unit} gibt zuerst nach, beim {factor:.1f}-fachen ihrer Last: auf mehr zielen, Kanten länger machen, den Schlauch kürzer, oder beide Enden halten.</translation>
  </message>
  <message>
   <source>Units open in this order: {order}; {force:.1f} N the first.</source>
   <translation>Die Einheiten öffnen sich in dieser Reihenfolge: {order}; die erste mit {force:.1f} N.</translation>
  </message>
  <message>
   <source>carries itself, times</source>
   <translation>trägt sich, mal</translation>
  </message>
  <message>
   <source>force of a hand, N</source>
   <translation>Kraft einer Hand, N</translation>
  </message>
  <message>
   <source>opening: flat to deployed</source>
   <translation>Öffnung: flach bis entfaltet</translation>
  </message>
  <message>
   <source>snap margin only</source>
   <translation>nur Schnappreserve</translation>
  </message>
  <message>
   <source>unit {}</source>
   <translation>Einheit {}</translation>
  </message>
  <message>
   <source>weakest: unit {}</source>
   <translation>schwächste: Einheit {}</translation>
  </message>
 </context>
 <context>
  <name>BistablePreferences</name>
  <message>
   <source>Colours of new objects</source>
   <translation>Farben neuer Objekte</translation>
  </message>
  <message>
   <source>Custom</source>
   <translation>Eigene Werte</translation>
  </message>
  <message>
   <source>Default colours</source>
   <translation>Voreingestellte Farben</translation>
  </message>
  <message>
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <source>Hinges of new objects</source>
   <translation>Scharniere neuer Objekte</translation>
  </message>
  <message>
   <source>Printer</source>
   <translation>Drucker</translation>
  </message>
  <message>
   <source>These values count for new objects and for checks; existing files stay as they are.</source>
   <translation>Diese Werte gelten für neue Objekte und für Prüfungen; vorhandene Dateien bleiben, wie sie sind.</translation>
  </message>
 </context>
 <context>
  <name>BistablePrintable</name>
  <message>
   <source>Compare other designs (Auto-fit)…</source>
   <translation>Andere Entwürfe vergleichen (automatisch anpassen)…</translation>
  </message>
  <message>
   <source>It is printable as it is.</source>
   <translation>Es ist druckbar, wie es ist.</translation>
  </message>
  <message>
   <source>Make it printable</source>
   <translation>Druckbar machen</translation>
  </message>
  <message>
   <source>Nearest design that can be made. In the way: {why}.</source>
   <translation>Der nächste Entwurf, der sich machen lässt. Im Weg steht: {why}.</translation>
  </message>
  <message>
   <source>No tube can be made: {why}.</source>
   <translation>Es lässt sich kein Schlauch machen: {why}.</translation>
  </message>
  <message>
   <source>Nothing has been found yet.</source>
   <translation>Noch ist nichts gefunden.</translation>
  </message>
  <message>
   <source>Search again</source>
   <translation>Neu suchen</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stopped: nothing is changed.</source>
   <translation>Angehalten: nichts ist geändert.</translation>
  </message>
  <message>
   <source>new</source>
   <translation>neu</translation>
  </message>
  <message>
   <source>{units} units in {prints} print(s), ‖AB‖ {edge} mm: the weakest has a snap margin of {margin}, and the tube ends {gap} mm from the curve's end.</source>
   <translation>{units} Einheiten in {prints} Druck(en), ‖AB‖ {edge} mm: die schwächste hat eine Schnappreserve von {margin}, und der Schlauch endet {gap} mm vor dem Ende der Kurve.</translation>
  </message>
 </context>
 <context>
  <name>BistableProperty</name>
  <message>
   <source>0 is flat-folded, 1 is deployed; both exact, between them the state of least misfit</source>
   <translation>0 ist flach gefaltet, 1 entfaltet; beide genau, dazwischen der Zustand mit kleinstem Passfehler</translation>
  </message>
  <message>
   <source>0 is the flat-folded print on the bed, 1 is deployed along the curve</source>
   <translation>0 ist der flach gefaltete Druck auf dem Bett, 1 ist entlang der Kurve entfaltet</translation>
  </message>
  <message>
   <source>A point of the plane on which feet stand when the tube is deployed</source>
   <translation>Ein Punkt der Ebene, auf der Füße stehen, wenn die Röhre entfaltet ist</translation>
  </message>
  <message>
   <source>Adaptive</source>
   <translation>Angepasst</translation>
  </message>
  <message>
   <source>Air layers</source>
   <translation>Luftschichten</translation>
  </message>
  <message>
   <source>Alphas</source>
   <translation>Alpha</translation>
  </message>
  <message>
   <source>Angle alpha of every unit, degrees</source>
   <translation>Winkel alpha jeder Einheit, Grad</translation>
  </message>
  <message>
   <source>Angle at which a dihedral is printed, 0° is folded flat; tubes and vertices are always printed flat</source>
   <translation>Winkel, unter dem zwei Platten gedruckt werden, 0° ist flach gefaltet; Schläuche und Ecken werden immer flach gedruckt</translation>
  </message>
  <message>
   <source>Angle beta of every unit, degrees</source>
   <translation>Winkel beta jeder Einheit, Grad</translation>
  </message>
  <message>
   <source>Angle beta' of every unit, degrees</source>
   <translation>Winkel beta′ jeder Einheit, Grad</translation>
  </message>
  <message>
   <source>Angle by which the first segment leans forward; larger opens all units wider</source>
   <translation>Winkel, um den sich die erste Strecke nach vorn neigt; größer öffnet alle Einheiten weiter</translation>
  </message>
  <message>
   <source>Angle of the cones' surface against their base, 45° to 60°: steeper has less play</source>
   <translation>Winkel des Kegelmantels zur Grundfläche, 45° bis 60°: steiler hat weniger Spiel</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Automatic: hinges of every deployed unit take up as much play as it needs for its cones to bear and hold it; none where hinges have three knuckles: their cones are far from the ends of hinges, and panels would press into each other. Given: Preload says how much</source>
   <translation>Automatic: die Scharniere jeder entfalteten Einheit nehmen so viel Spiel auf, wie sie braucht, damit ihre Kegel tragen und sie halten; keines, wo Scharniere drei Glieder haben: deren Kegel liegen weit von den Enden der Scharniere, und Platten würden sich ineinander drücken. Given: so viel, wie Preload sagt</translation>
  </message>
  <message>
   <source>Automatic: the direction or viewpoint from which the curve is seen most openly. Direction, Viewpoint: as given by Ruling</source>
   <translation>Automatisch: die Richtung oder der Blickpunkt, aus dem die Kurve am offensten zu sehen ist. Richtung, Blickpunkt: wie unter Erzeugende angegeben</translation>
  </message>
  <message>
   <source>Automatic: what the curve is found to be, see FoundKind. Plane: any plane in space. Sphere: on the sphere of SphereRadius about SphereCenter. General: any space curve, see Ruling</source>
   <translation>Automatic: als was die Kurve erkannt wird, siehe FoundKind. Plane: irgendeine Ebene im Raum. Sphere: auf der Kugel vom SphereRadius um SphereCenter. General: beliebige Raumkurve, siehe Ruling</translation>
  </message>
  <message>
   <source>Axial gap between knuckles and clearance around them</source>
   <translation>Axialer Spalt zwischen den Gliedern und Luft um sie herum</translation>
  </message>
  <message>
   <source>Barriers</source>
   <translation>Energieschwellen</translation>
  </message>
  <message>
   <source>Base angle ω of every unit's contact trapezoids, degrees; 90 where the legs are parallel</source>
   <translation>Basiswinkel ω der Kontakttrapeze jeder Einheit in Grad; 90, wo die Schenkel parallel sind</translation>
  </message>
  <message>
   <source>Base angle ω of the single unit's contact trapezoids; 90° is a plane unit, less is a unit on a sphere</source>
   <translation>Basiswinkel ω der Kontakttrapeze der einzelnen Einheit; 90° ist eine ebene Einheit, weniger eine auf einer Kugel</translation>
  </message>
  <message>
   <source>Base angle ω that the contact trapezoids shall have: sets SphereRadius to OmegaEdgeLength / 2 · tan ω. 0: SphereRadius is given</source>
   <translation>Basiswinkel ω, den die Kontakttrapeze haben sollen: setzt SphereRadius auf OmegaEdgeLength / 2 · tan ω. 0: SphereRadius ist gegeben</translation>
  </message>
  <message>
   <source>Bed</source>
   <translation>Druckraum</translation>
  </message>
  <message>
   <source>Bed depth</source>
   <translation>Druckbett-Tiefe</translation>
  </message>
  <message>
   <source>Bed height</source>
   <translation>Bauhöhe</translation>
  </message>
  <message>
   <source>Bed width</source>
   <translation>Druckbett-Breite</translation>
  </message>
  <message>
   <source>Beta primes</source>
   <translation>Beta′</translation>
  </message>
  <message>
   <source>Betas</source>
   <translation>Beta</translation>
  </message>
  <message>
   <source>Between the ribs that hold up the panel above in the print, both ways</source>
   <translation>Zwischen den Rippen, die im Druck das Paneel darüber tragen, in beiden Richtungen</translation>
  </message>
  <message>
   <source>BistableUnit whose panels become thick</source>
   <translation>Bistabile Einheiten, deren Flächen dick werden</translation>
  </message>
  <message>
   <source>Body count</source>
   <translation>Anzahl Körper</translation>
  </message>
  <message>
   <source>Body kinds</source>
   <translation>Arten der Körper</translation>
  </message>
  <message>
   <source>Body names</source>
   <translation>Namen der Körper</translation>
  </message>
  <message>
   <source>Body units</source>
   <translation>Einheiten der Körper</translation>
  </message>
  <message>
   <source>Border panels</source>
   <translation>Randflächen</translation>
  </message>
  <message>
   <source>Both</source>
   <translation>Beide</translation>
  </message>
  <message>
   <source>Calibration</source>
   <translation>Kalibrierung</translation>
  </message>
  <message>
   <source>Centre of the sphere; all legs of the strips point to it</source>
   <translation>Mitte der Kugel; alle Schenkel der Streifen zeigen auf sie</translation>
  </message>
  <message>
   <source>Clearance of the tightest hinge</source>
   <translation>Spiel des engsten Scharniers</translation>
  </message>
  <message>
   <source>Clearance with which a unit would open freely / clearance of its hinges, for every unit, measured where its cones or pins are; below 1 a unit is floppy. Infinite for strips, which have no play: Barriers tell</source>
   <translation>Spiel, mit dem eine Einheit sich frei öffnen würde / Spiel ihrer Scharniere, für jede Einheit, gemessen, wo ihre Kegel oder Stifte sind; unter 1 ist eine Einheit schlaff. Unendlich bei Streifen, die kein Spiel haben: Barriers sagt es</translation>
  </message>
  <message>
   <source>Clearances</source>
   <translation>Spiele</translation>
  </message>
  <message>
   <source>Clearances of the plate's hinges, mm; their hundredths are engraved</source>
   <translation>Spiele der Scharniere der Platte, mm; ihre Hundertstel sind eingraviert</translation>
  </message>
  <message>
   <source>Clip</source>
   <translation>Schnapper</translation>
  </message>
  <message>
   <source>Closed</source>
   <translation>Geschlossen</translation>
  </message>
  <message>
   <source>Closing barriers</source>
   <translation>Schließbarrieren</translation>
  </message>
  <message>
   <source>Coarse</source>
   <translation>Grob</translation>
  </message>
  <message>
   <source>Column of the paper's Tables 1 and 2 to take the hinge inputs from; Custom leaves them as they are</source>
   <translation>Spalte der Tabellen 1 und 2 des Aufsatzes, aus der die Scharnierwerte kommen; Eigene Werte lässt sie, wie sie sind</translation>
  </message>
  <message>
   <source>Compensate</source>
   <translation>Kompensieren</translation>
  </message>
  <message>
   <source>Cone</source>
   <translation>Kegel</translation>
  </message>
  <message>
   <source>Cone angle</source>
   <translation>Kegelwinkel</translation>
  </message>
  <message>
   <source>Cone: each knuckle turns on a cone. Pin: a continuous pin, for thick panels</source>
   <translation>Kegel: jedes Glied dreht sich auf einem Kegel. Stift: ein durchgehender Stift, für dicke Platten</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>Berührung</translation>
  </message>
  <message>
   <source>Contact panels</source>
   <translation>Kontaktflächen</translation>
  </message>
  <message>
   <source>Control points of the Bézier curve, two or more. On a sphere: plan coordinates, wrapped from the top (see SphereCenter)</source>
   <translation>Kontrollpunkte der Bézierkurve, zwei oder mehr. Auf einer Kugel: Plankoordinaten, von oben herumgelegt (siehe Kugelmitte)</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <translation>Eckenradius</translation>
  </message>
  <message>
   <source>Count</source>
   <translation>Anzahl</translation>
  </message>
  <message>
   <source>Coupon</source>
   <translation>Probestück</translation>
  </message>
  <message>
   <source>Coverage</source>
   <translation>Abdeckung</translation>
  </message>
  <message>
   <source>Crease</source>
   <translation>Faltlinie</translation>
  </message>
  <message>
   <source>Curve</source>
   <translation>Kurve</translation>
  </message>
  <message>
   <source>Curve deviation</source>
   <translation>Abweichung von der Kurve</translation>
  </message>
  <message>
   <source>Curve that the tube follows</source>
   <translation>Kurve, der der Schlauch folgt</translation>
  </message>
  <message>
   <source>Custom</source>
   <translation>Eigene Werte</translation>
  </message>
  <message>
   <source>Density</source>
   <translation>Dichte</translation>
  </message>
  <message>
   <source>Density of your own material, g/cm³; 0: that of Material</source>
   <translation>Dichte des eigenen Werkstoffs, g/cm³; 0: die von Werkstoff</translation>
  </message>
  <message>
   <source>Deployed misfit</source>
   <translation>Passfehler entfaltet</translation>
  </message>
  <message>
   <source>Deployed size</source>
   <translation>Größe entfaltet</translation>
  </message>
  <message>
   <source>Deployment</source>
   <translation>Entfaltung</translation>
  </message>
  <message>
   <source>Diameter of the dowels; holes are 0.2 mm wider</source>
   <translation>Durchmesser der Dübel; die Löcher sind 0,2 mm weiter</translation>
  </message>
  <message>
   <source>Diameter of the magnets; pockets are 0.2 mm wider</source>
   <translation>Durchmesser der Magnete; die Taschen sind 0,2 mm weiter</translation>
  </message>
  <message>
   <source>Dihedral</source>
   <translation>Zwei Platten</translation>
  </message>
  <message>
   <source>Dihedral: two hinged plates. Vertex: four plates about a developable vertex; NonDevelopableVertex: about one that is not</source>
   <translation>Zwei Platten: mit einem Scharnier. Ecke: vier Platten um eine abwickelbare Ecke; nicht abwickelbare Ecke: um eine, die es nicht ist</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>Richtung</translation>
  </message>
  <message>
   <source>Direction from the plane of the feet to the tube: feet stand square on it</source>
   <translation>Richtung von der Ebene der Füße zur Röhre: Füße stehen rechtwinklig auf ihr</translation>
  </message>
  <message>
   <source>Direction of all legs of the strips, or the point that they all pass (setting it turns Automatic off)</source>
   <translation>Richtung aller Schenkel der Streifen oder der Punkt, durch den sie alle gehen (wer sie setzt, schaltet Automatisch aus)</translation>
  </message>
  <message>
   <source>Direction of gravity for the deployed tube, in the frame of the flat print with its first block at rest</source>
   <translation>Richtung der Schwerkraft für die entfaltete Röhre, im Bezug des flachen Drucks, dessen erster Block ruht</translation>
  </message>
  <message>
   <source>Distance of the last midpoint from the curve's end</source>
   <translation>Abstand des letzten Mittelpunkts vom Ende der Kurve</translation>
  </message>
  <message>
   <source>Dowel</source>
   <translation>Dübel</translation>
  </message>
  <message>
   <source>Dowel diameter</source>
   <translation>Dübeldurchmesser</translation>
  </message>
  <message>
   <source>Edge length</source>
   <translation>Kantenlänge</translation>
  </message>
  <message>
   <source>Edge, wire, sketch or Draft curve to follow instead of Points</source>
   <translation>Kante, Draht, Skizze oder Draft-Kurve, der statt der Punkte gefolgt wird</translation>
  </message>
  <message>
   <source>EdgeLength ‖AB‖ of the units that Omega is wanted for</source>
   <translation>EdgeLength ‖AB‖ der Einheiten, für die Omega gewünscht ist</translation>
  </message>
  <message>
   <source>End direction</source>
   <translation>Richtung am Ende</translation>
  </message>
  <message>
   <source>End gap</source>
   <translation>Lücke am Ende</translation>
  </message>
  <message>
   <source>End part</source>
   <translation>Endstück</translation>
  </message>
  <message>
   <source>End slop</source>
   <translation>Spiel am Ende</translation>
  </message>
  <message>
   <source>EndFit</source>
   <translation>Bis zum Ende</translation>
  </message>
  <message>
   <source>EndFit: Gamma is taken near the wanted one, so that the tube ends at the curve's end. Steered: the tube may leave the curve by Tolerance, meets both ends and opens evenly. Paper: by Gamma alone, as far as it goes. Closed curves are closed by EndFit and Steered</source>
   <translation>EndFit: Gamma wird nahe dem gewünschten so gewählt, dass die Röhre am Ende der Kurve endet. Steered: die Röhre darf um Tolerance von der Kurve abweichen, trifft beide Enden und öffnet sich gleichmäßig. Paper: nach Gamma allein, so weit es reicht. Geschlossene Kurven werden von EndFit und Steered geschlossen</translation>
  </message>
  <message>
   <source>Ends</source>
   <translation>Enden</translation>
  </message>
  <message>
   <source>Energy barrier between the two states of every unit without thickness, in EA·‖AB‖ (symmetric unit of its theta and ratio)</source>
   <translation>Energieschwelle zwischen den beiden Zuständen jeder Einheit ohne Dicke, in EA·‖AB‖ (symmetrische Einheit mit ihrem Theta und Verhältnis)</translation>
  </message>
  <message>
   <source>Energy that folding back takes, N·mm, of every unit</source>
   <translation>Energie, die das Zurückfalten braucht, N·mm, für jede Einheit</translation>
  </message>
  <message>
   <source>Energy that opening takes, N·mm, of every unit</source>
   <translation>Energie, die das Öffnen braucht, N·mm, für jede Einheit</translation>
  </message>
  <message>
   <source>Exact</source>
   <translation>Genau</translation>
  </message>
  <message>
   <source>Export a body of soluble support that fills the gaps between the panels</source>
   <translation>Einen Körper aus löslicher Stütze mit exportieren, der die Spalte zwischen den Platten füllt</translation>
  </message>
  <message>
   <source>Extra load at the free end that the deployed tube bears, in the direction of gravity, N</source>
   <translation>Zusätzliche Last am freien Ende, die die entfaltete Röhre trägt, in Richtung der Schwerkraft, N</translation>
  </message>
  <message>
   <source>FDM, soluble</source>
   <translation>FDM, löslich</translation>
  </message>
  <message>
   <source>FDM, stand-offs</source>
   <translation>FDM, Abstandsrippen</translation>
  </message>
  <message>
   <source>FDM, ties</source>
   <translation>FDM, Stege</translation>
  </message>
  <message>
   <source>Face thickness</source>
   <translation>Plattendicke</translation>
  </message>
  <message>
   <source>First unit</source>
   <translation>Erste Einheit</translation>
  </message>
  <message>
   <source>First unit of this print, counted from 1: a long tube is printed in parts that are joined at their contact blocks</source>
   <translation>Erste Einheit dieses Drucks, ab 1 gezählt: ein langer Schlauch wird in Teilen gedruckt, die an ihren Kontaktblöcken verbunden werden</translation>
  </message>
  <message>
   <source>Fixed</source>
   <translation>Fest</translation>
  </message>
  <message>
   <source>Fixed at</source>
   <translation>Gehalten an</translation>
  </message>
  <message>
   <source>Flange</source>
   <translation>Flansch</translation>
  </message>
  <message>
   <source>Flat</source>
   <translation>Flach</translation>
  </message>
  <message>
   <source>Flat: layers horizontal, gaps filled with soluble support. OnEdge: layers vertical</source>
   <translation>Flach: Schichten waagerecht, Spalte mit löslicher Stütze gefüllt. Hochkant: Schichten senkrecht</translation>
  </message>
  <message>
   <source>Flexible</source>
   <translation>Flexibel</translation>
  </message>
  <message>
   <source>Flip side</source>
   <translation>Seite wechseln</translation>
  </message>
  <message>
   <source>Foot</source>
   <translation>Fuß</translation>
  </message>
  <message>
   <source>Foot normal</source>
   <translation>Fußnormale</translation>
  </message>
  <message>
   <source>Foot point</source>
   <translation>Fußpunkt</translation>
  </message>
  <message>
   <source>For curves of kind General with a direction as Ruling: keep the segments from tilting along the way (long helices)</source>
   <translation>Für allgemeine Kurven mit einer Richtung als Erzeugende: die Strecken unterwegs nicht kippen lassen (lange Schrauben)</translation>
  </message>
  <message>
   <source>For the rule Adaptive: where the ratio lies between the least one (0; sin(theta/2), more where contact panels lean) and 1; smaller snaps harder</source>
   <translation>Für die Regel Angepasst: wo das Verhältnis zwischen dem kleinsten (0; sin(theta/2), mehr bei geneigten Kontaktflächen) und 1 liegt; kleiner schnappt härter</translation>
  </message>
  <message>
   <source>Force of a hand that opens a unit, N, ‖AB‖ from the leg at B</source>
   <translation>Kraft einer Hand, die eine Einheit öffnet, N, ‖AB‖ vom Schenkel bei B entfernt</translation>
  </message>
  <message>
   <source>Found kind</source>
   <translation>Erkannte Art</translation>
  </message>
  <message>
   <source>Free</source>
   <translation>Frei</translation>
  </message>
  <message>
   <source>Free bends</source>
   <translation>Freie Biegungen</translation>
  </message>
  <message>
   <source>Free load</source>
   <translation>Freie Last</translation>
  </message>
  <message>
   <source>Free turn of every deployed unit about its leg at B to either side, degrees</source>
   <translation>Freie Drehung jeder entfalteten Einheit um ihren Schenkel bei B nach jeder Seite, Grad</translation>
  </message>
  <message>
   <source>Free twist of every deployed unit to either side, degrees</source>
   <translation>Freie Verdrehung jeder entfalteten Einheit nach jeder Seite, Grad</translation>
  </message>
  <message>
   <source>Free twists</source>
   <translation>Freie Verdrehungen</translation>
  </message>
  <message>
   <source>Gamma</source>
   <translation>Gamma</translation>
  </message>
  <message>
   <source>Gamma of the first segment as it was taken</source>
   <translation>Gamma des ersten Segments, wie es gewählt wurde</translation>
  </message>
  <message>
   <source>Gap between planes</source>
   <translation>Abstand der Ebenen</translation>
  </message>
  <message>
   <source>Gap between stacked panels</source>
   <translation>Spalt zwischen gestapelten Platten</translation>
  </message>
  <message>
   <source>Gap length</source>
   <translation>Spaltlänge</translation>
  </message>
  <message>
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <source>Given</source>
   <translation>Vorgegeben</translation>
  </message>
  <message>
   <source>Gravity</source>
   <translation>Schwerkraft</translation>
  </message>
  <message>
   <source>Hand forces</source>
   <translation>Handkräfte</translation>
  </message>
  <message>
   <source>Height ratio</source>
   <translation>Höhenverhältnis</translation>
  </message>
  <message>
   <source>Hinge</source>
   <translation>Scharnier</translation>
  </message>
  <message>
   <source>Hinge play</source>
   <translation>Scharnierspiel</translation>
  </message>
  <message>
   <source>Hinge type</source>
   <translation>Scharnierart</translation>
  </message>
  <message>
   <source>How far a steered tube may leave its curve; 1 % of EdgeLength until you set it</source>
   <translation>Wie weit eine gesteuerte Röhre von ihrer Kurve abweichen darf; 1 % von EdgeLength, bis du etwas anderes setzt</translation>
  </message>
  <message>
   <source>How far the deployed tube's free end moves before anything bears</source>
   <translation>Wie weit sich das freie Ende der entfalteten Röhre bewegt, bevor etwas trägt</translation>
  </message>
  <message>
   <source>How it is printed. Setting it sets gaps, thickness, layers, cones, orientation and material to what suits; change them afterwards</source>
   <translation>Wie gedruckt wird. Die Wahl setzt Spalte, Dicke, Schichten, Kegel, Lage und Werkstoff auf das, was passt; danach kann alles geändert werden</translation>
  </message>
  <message>
   <source>How much looser every next hinge is</source>
   <translation>Um wie viel jedes weitere Scharnier loser ist</translation>
  </message>
  <message>
   <source>How much of their play hinges of a deployed unit take up: 0 none, it wobbles; 1 about all (setting it sets PreloadRule to Given)</source>
   <translation>Wie viel ihres Spiels die Scharniere einer entfalteten Einheit aufnehmen: 0 nichts, sie wackelt; 1 etwa alles (wird es gesetzt, wird PreloadRule zu Given)</translation>
  </message>
  <message>
   <source>How the ratio ‖A'C'‖/‖AB‖ is chosen. Adaptive: by RatioShare, for every unit anew. Fixed: by Ratio. Exact: the ratio that closes on a sphere. Paper: 1/2. TargetSnap: by TargetMargin, for every unit anew</source>
   <translation>Wie das Verhältnis ‖A'C'‖/‖AB‖ gewählt wird. Angepasst: nach dem Verhältnisanteil, für jede Einheit neu. Fest: nach dem Verhältnis. Genau: das Verhältnis, das sich auf einer Kugel schließt. Aufsatz: 1/2. Nach Schnappziel: nach der Ziel-Schnappreserve, für jede Einheit neu</translation>
  </message>
  <message>
   <source>How two halves of a contact block are joined, where the tube is cut into parts and where a closed one meets itself when deployed. Dowel: pieces of filament. Clip: posts that snap behind tongues. Magnet: pockets. Screw: through holes. None: plain faces to glue</source>
   <translation>Wie zwei Hälften eines Kontaktblocks verbunden werden, wo der Schlauch in Teile geschnitten ist und wo ein geschlossener sich entfaltet selbst trifft. Dübel: Filamentstücke. Schnapper: Pfosten, die hinter Zungen schnappen. Magnet: Taschen. Schraube: durchgehende Löcher. Keine: glatte Flächen zum Kleben</translation>
  </message>
  <message>
   <source>Instead of a margin: wanted energy barrier of the zero-thickness units, in EA·‖AB‖; 0 aims for TargetMargin</source>
   <translation>Statt einer Reserve: gewünschte Energieschwelle der Einheiten ohne Dicke, in EA·‖AB‖; 0 zielt auf die Ziel-Schnappreserve</translation>
  </message>
  <message>
   <source>Isometry error</source>
   <translation>Isometriefehler</translation>
  </message>
  <message>
   <source>Joint</source>
   <translation>Verbindung</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>Art</translation>
  </message>
  <message>
   <source>Largest distance of a deployed contact block from its place on the curve</source>
   <translation>Größter Abstand eines entfalteten Kontaktblocks von seinem Platz auf der Kurve</translation>
  </message>
  <message>
   <source>Largest distance of a midpoint from the curve</source>
   <translation>Größter Abstand eines Mittelpunkts von der Kurve</translation>
  </message>
  <message>
   <source>Largest misfit of a hinge when deployed, apart from its preload</source>
   <translation>Größte Fehlpassung eines Gelenks im entfalteten Zustand, ohne die Vorspannung</translation>
  </message>
  <message>
   <source>Largest misfit of hinges / ‖AB‖ that ratios may lead to; 0: none. What breaks is told by Stresses of the hinge set</source>
   <translation>Größter Fehler der Scharniere / ‖AB‖, zu dem Verhältnisse führen dürfen; 0: keine Grenze. Was bricht, sagt Stresses des Scharniersatzes</translation>
  </message>
  <message>
   <source>Largest opening angle</source>
   <translation>Größter Öffnungswinkel</translation>
  </message>
  <message>
   <source>Largest relative change of a panel edge: what the ratio rule leaves unclosed</source>
   <translation>Größte relative Änderung einer Flächenkante: was die Verhältnisregel offen lässt</translation>
  </message>
  <message>
   <source>Largest relative change of any edge or diagonal of a panel between flat and deployed</source>
   <translation>Größte relative Änderung einer Kante oder Diagonale einer Fläche zwischen flach und entfaltet</translation>
  </message>
  <message>
   <source>Largest stress in a knuckle's root on the way, as a share of what the material bears, of every unit; above 1 it breaks</source>
   <translation>Größte Spannung an der Wurzel eines Gelenkglieds unterwegs, als Anteil dessen, was der Werkstoff trägt, für jede Einheit; über 1 bricht es</translation>
  </message>
  <message>
   <source>Last unit</source>
   <translation>Letzte Einheit</translation>
  </message>
  <message>
   <source>Last unit of this print; 0: the last of the tube</source>
   <translation>Letzte Einheit dieses Drucks; 0: die letzte des Schlauchs</translation>
  </message>
  <message>
   <source>Layer height</source>
   <translation>Schichthöhe</translation>
  </message>
  <message>
   <source>Layer height (the paper's profile)</source>
   <translation>Schichthöhe (das Profil im Aufsatz)</translation>
  </message>
  <message>
   <source>Layers of air between a rib and what it holds up, so that it comes free; 0: about 0.2 mm</source>
   <translation>Schichten Luft zwischen einer Rippe und dem, was sie trägt, damit es sich löst; 0: etwa 0,2 mm</translation>
  </message>
  <message>
   <source>Least</source>
   <translation>Kleinstes</translation>
  </message>
  <message>
   <source>Least safety</source>
   <translation>Kleinste Sicherheit</translation>
  </message>
  <message>
   <source>Least safety of all units, whatever way the deployed tube is turned</source>
   <translation>Kleinste Sicherheit aller Einheiten, wie auch immer der entfaltete Schlauch gedreht wird</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Length of curve that the tube follows / length of the curve</source>
   <translation>Länge der Kurve, der der Schlauch folgt / Länge der Kurve</translation>
  </message>
  <message>
   <source>Length of the coupon along the hinge</source>
   <translation>Länge des Probestücks entlang des Scharniers</translation>
  </message>
  <message>
   <source>Length of the curve</source>
   <translation>Länge der Kurve</translation>
  </message>
  <message>
   <source>Length x</source>
   <translation>Länge x</translation>
  </message>
  <message>
   <source>Length y</source>
   <translation>Länge y</translation>
  </message>
  <message>
   <source>Length ‖AB‖ of the single unit</source>
   <translation>Länge ‖AB‖ der einzelnen Einheit</translation>
  </message>
  <message>
   <source>Length ‖AB‖ of the units' long edge: the width of the tube</source>
   <translation>Länge ‖AB‖ der langen Kante der Einheiten: die Breite des Schlauchs</translation>
  </message>
  <message>
   <source>Length, width and height of the print, mm</source>
   <translation>Länge, Breite und Höhe des Drucks, mm</translation>
  </message>
  <message>
   <source>Length, width and height when deployed, mm</source>
   <translation>Länge, Breite und Höhe entfaltet, mm</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>Waagerecht</translation>
  </message>
  <message>
   <source>Live</source>
   <translation>Sofort</translation>
  </message>
  <message>
   <source>Loose posts under what no rib can hold in the flat print; they fall out when the tube is opened</source>
   <translation>Lose Pfosten unter dem, was im flachen Druck keine Rippe halten kann; sie fallen heraus, wenn die Röhre geöffnet wird</translation>
  </message>
  <message>
   <source>Magnet</source>
   <translation>Magnet</translation>
  </message>
  <message>
   <source>Magnet depth</source>
   <translation>Magnetdicke</translation>
  </message>
  <message>
   <source>Magnet diameter</source>
   <translation>Magnetdurchmesser</translation>
  </message>
  <message>
   <source>Margin measure</source>
   <translation>Maß der Reserve</translation>
  </message>
  <message>
   <source>Material</source>
   <translation>Werkstoff</translation>
  </message>
  <message>
   <source>Midpoint deviation</source>
   <translation>Abweichung der Mittelpunkte</translation>
  </message>
  <message>
   <source>Names of the bodies, in the order of the solids</source>
   <translation>Namen der Körper, in der Reihenfolge der Volumen</translation>
  </message>
  <message>
   <source>Nominal diameter of the screws of joints and flanges; holes clear them as ISO 273 has it</source>
   <translation>Nenndurchmesser der Schrauben von Verbindungen und Flanschen; Durchgangslöcher nach ISO 273</translation>
  </message>
  <message>
   <source>NonDevelopableVertex</source>
   <translation>Nicht abwickelbare Ecke</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>Nozzle diameter</source>
   <translation>Düsendurchmesser</translation>
  </message>
  <message>
   <source>Nozzle diameter: the thinnest wall</source>
   <translation>Düsendurchmesser: die dünnste Wand</translation>
  </message>
  <message>
   <source>Number of each body's unit; of a block the first of its two</source>
   <translation>Nummer der Einheit jedes Körpers; bei einem Block die erste seiner beiden</translation>
  </message>
  <message>
   <source>Number of hinges, 5 or more</source>
   <translation>Anzahl der Scharniere, 5 oder mehr</translation>
  </message>
  <message>
   <source>Number of knuckles along a hinge, odd; fewer where a hinge is short (setting it sets SegmentWidth to 0)</source>
   <translation>Zahl der Glieder entlang eines Scharniers, ungerade; weniger, wo ein Scharnier kurz ist (wird sie gesetzt, wird SegmentWidth 0)</translation>
  </message>
  <message>
   <source>Number of separate moving bodies</source>
   <translation>Anzahl der einzeln beweglichen Körper</translation>
  </message>
  <message>
   <source>Number of units</source>
   <translation>Anzahl der Einheiten</translation>
  </message>
  <message>
   <source>Omega</source>
   <translation>Omega</translation>
  </message>
  <message>
   <source>Omega edge length</source>
   <translation>Kantenlänge zu Omega</translation>
  </message>
  <message>
   <source>Omegas</source>
   <translation>Omegas</translation>
  </message>
  <message>
   <source>OnDemand</source>
   <translation>Auf Wunsch</translation>
  </message>
  <message>
   <source>OnEdge</source>
   <translation>Hochkant</translation>
  </message>
  <message>
   <source>Opening angle of every unit, degrees</source>
   <translation>Öffnungswinkel jeder Einheit, Grad</translation>
  </message>
  <message>
   <source>Opening angle of the single unit</source>
   <translation>Öffnungswinkel der einzelnen Einheit</translation>
  </message>
  <message>
   <source>Orientation</source>
   <translation>Ausrichtung</translation>
  </message>
  <message>
   <source>Paper</source>
   <translation>Aufsatz</translation>
  </message>
  <message>
   <source>Part of the tube</source>
   <translation>Teil des Schlauchs</translation>
  </message>
  <message>
   <source>Piano</source>
   <translation>Klavierband</translation>
  </message>
  <message>
   <source>Pillars</source>
   <translation>Pfeiler</translation>
  </message>
  <message>
   <source>Pin</source>
   <translation>Stift</translation>
  </message>
  <message>
   <source>Pitch of the single unit's thick panels (face thickness + gap between planes), 1.8 mm for example; a tube takes it from its triangles</source>
   <translation>Ebenenabstand der dicken Platten der einzelnen Einheit (Plattendicke + Abstand der Ebenen), zum Beispiel 1,8 mm; ein Schlauch nimmt ihn von seinen Dreiecken</translation>
  </message>
  <message>
   <source>Pitch of the thick panels (face thickness + gap between planes) to allow for; 0 is the paper's zero-thickness rule</source>
   <translation>Ebenenabstand der dicken Platten (Plattendicke + Abstand der Ebenen), für den Platz bleibt; 0 ist die Regel des Aufsatzes ohne Dicke</translation>
  </message>
  <message>
   <source>Pivot</source>
   <translation>Drehlager</translation>
  </message>
  <message>
   <source>Placement</source>
   <translation>Platzierung</translation>
  </message>
  <message>
   <source>Placement rule</source>
   <translation>Anordnungsregel</translation>
  </message>
  <message>
   <source>Plain</source>
   <translation>Glatt</translation>
  </message>
  <message>
   <source>Plane</source>
   <translation>Ebene</translation>
  </message>
  <message>
   <source>Plate</source>
   <translation>Platte</translation>
  </message>
  <message>
   <source>Plate thickness</source>
   <translation>Plattendicke</translation>
  </message>
  <message>
   <source>Play of one hinge; 0.28 mm is that of the hinges' defaults, 0 that of flexible hinges</source>
   <translation>Spiel eines Scharniers; 0,28 mm ist das der voreingestellten Scharniere, 0 das flexibler Scharniere</translation>
  </message>
  <message>
   <source>Play that hinges of every deployed unit take up, in gap lengths: what Preload says, or what was found</source>
   <translation>Spiel, das die Scharniere jeder entfalteten Einheit aufnehmen, in Spaltlängen: was Preload sagt, oder was gefunden wurde</translation>
  </message>
  <message>
   <source>Points</source>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>Powder</source>
   <translation>Pulver</translation>
  </message>
  <message>
   <source>Preload</source>
   <translation>Vorspannung</translation>
  </message>
  <message>
   <source>Preload rule</source>
   <translation>Regel der Vorspannung</translation>
  </message>
  <message>
   <source>Preloads</source>
   <translation>Vorspannungen</translation>
  </message>
  <message>
   <source>Preset</source>
   <translation>Vorgabe</translation>
  </message>
  <message>
   <source>Primary triangles</source>
   <translation>Hauptdreiecke</translation>
  </message>
  <message>
   <source>Print size</source>
   <translation>Druckgröße</translation>
  </message>
  <message>
   <source>Printer</source>
   <translation>Drucker</translation>
  </message>
  <message>
   <source>Process</source>
   <translation>Verfahren</translation>
  </message>
  <message>
   <source>Radius by which kinks are rounded, so that the units can follow; 0: as much as units of the usual size ask for and fits</source>
   <translation>Radius, mit dem Knicke gerundet werden, damit die Einheiten folgen können; 0: so viel, wie Einheiten üblicher Größe brauchen und wie Platz ist</translation>
  </message>
  <message>
   <source>Radius of the sphere that carries the curve</source>
   <translation>Radius der Kugel, die die Kurve trägt</translation>
  </message>
  <message>
   <source>Ratio</source>
   <translation>Verhältnis</translation>
  </message>
  <message>
   <source>Ratio rule</source>
   <translation>Verhältnisregel</translation>
  </message>
  <message>
   <source>Ratio share</source>
   <translation>Verhältnisanteil</translation>
  </message>
  <message>
   <source>Ratio ‖A'C'‖/‖AB‖ of all units (setting it chooses the rule Fixed): at least sin(theta/2) and below 1; nearer to sin(theta/2) snaps harder</source>
   <translation>Verhältnis ‖A'C'‖/‖AB‖ aller Einheiten (wer es setzt, wählt die Regel Fest): mindestens sin(theta/2) und unter 1; näher an sin(theta/2) schnappt es härter</translation>
  </message>
  <message>
   <source>Ratio ‖A'C'‖/‖AB‖ of every unit</source>
   <translation>Verhältnis ‖A'C'‖/‖AB‖ jeder Einheit</translation>
  </message>
  <message>
   <source>Ratios</source>
   <translation>Verhältnisse</translation>
  </message>
  <message>
   <source>Recommended</source>
   <translation>Empfohlen</translation>
  </message>
  <message>
   <source>RecommendedVertex</source>
   <translation>Empfohlen (Ecke)</translation>
  </message>
  <message>
   <source>Residual</source>
   <translation>Restfehler</translation>
  </message>
  <message>
   <source>Resin</source>
   <translation>Harz</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>Ergebnisse</translation>
  </message>
  <message>
   <source>Ribs along the panels' edges too</source>
   <translation>Rippen auch entlang der Paneelkanten</translation>
  </message>
  <message>
   <source>Room of the printer (width, depth, height in mm), to refuse a print that is too large; 0, 0, 0: not checked</source>
   <translation>Raum des Druckers (Breite, Tiefe, Höhe in mm), um einen zu großen Druck abzulehnen; 0, 0, 0: nicht geprüft</translation>
  </message>
  <message>
   <source>Rotation angle</source>
   <translation>Drehwinkel</translation>
  </message>
  <message>
   <source>Rotational</source>
   <translation>Drehend</translation>
  </message>
  <message>
   <source>Rotational: print-in-place knuckles. Flexible: a strip of soft material (TPU) along every crease</source>
   <translation>Drehend: fertig gedruckte Gelenke. Flexibel: ein Streifen aus weichem Material (TPU) entlang jeder Falte</translation>
  </message>
  <message>
   <source>Ruling</source>
   <translation>Erzeugende</translation>
  </message>
  <message>
   <source>Ruling kind</source>
   <translation>Art der Erzeugenden</translation>
  </message>
  <message>
   <source>Safety factors</source>
   <translation>Sicherheiten</translation>
  </message>
  <message>
   <source>Safety of every deployed unit against folding under the tube's weight; below 1 it folds</source>
   <translation>Sicherheit jeder entfalteten Einheit gegen das Zusammenklappen unter dem Gewicht der Röhre; unter 1 klappt sie</translation>
  </message>
  <message>
   <source>Screw</source>
   <translation>Schraube</translation>
  </message>
  <message>
   <source>Screw diameter</source>
   <translation>Schraubendurchmesser</translation>
  </message>
  <message>
   <source>Secondary triangles</source>
   <translation>Nebendreiecke</translation>
  </message>
  <message>
   <source>Segment width</source>
   <translation>Gliedbreite</translation>
  </message>
  <message>
   <source>Segmentations</source>
   <translation>Unterteilungen</translation>
  </message>
  <message>
   <source>Shift the hinge axes so that the thick panels close exactly when deployed; without it they do not snap</source>
   <translation>Die Scharnierachsen verschieben, damit die dicken Platten entfaltet genau schließen; ohne das schnappen sie nicht</translation>
  </message>
  <message>
   <source>Smallest opening angle</source>
   <translation>Kleinster Öffnungswinkel</translation>
  </message>
  <message>
   <source>Snap margins</source>
   <translation>Schnappreserven</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Vorlage</translation>
  </message>
  <message>
   <source>Sphere</source>
   <translation>Kugel</translation>
  </message>
  <message>
   <source>Sphere center</source>
   <translation>Kugelmitte</translation>
  </message>
  <message>
   <source>Sphere radius</source>
   <translation>Kugelradius</translation>
  </message>
  <message>
   <source>Square</source>
   <translation>Rechtwinklig</translation>
  </message>
  <message>
   <source>Stand off rim</source>
   <translation>Randrippen</translation>
  </message>
  <message>
   <source>Stand off spacing</source>
   <translation>Rippenabstand</translation>
  </message>
  <message>
   <source>Stand off width</source>
   <translation>Rippenbreite</translation>
  </message>
  <message>
   <source>Stand-offs</source>
   <translation>Abstandsrippen</translation>
  </message>
  <message>
   <source>Start</source>
   <translation>Anfang</translation>
  </message>
  <message>
   <source>Start direction</source>
   <translation>Richtung am Anfang</translation>
  </message>
  <message>
   <source>Start part</source>
   <translation>Anfangsstück</translation>
  </message>
  <message>
   <source>Start with the unit on the other side of the curve</source>
   <translation>Mit der Einheit auf der anderen Seite der Kurve beginnen</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Zustand</translation>
  </message>
  <message>
   <source>Steered</source>
   <translation>Gesteuert</translation>
  </message>
  <message>
   <source>Steered along a symmetric curve: the tube is the same from both ends</source>
   <translation>Gesteuert entlang einer symmetrischen Kurve: die Röhre ist von beiden Enden her gleich</translation>
  </message>
  <message>
   <source>Steered: whether the first block stands square on the curve</source>
   <translation>Gesteuert: ob der erste Block rechtwinklig auf der Kurve steht</translation>
  </message>
  <message>
   <source>Steered: whether the last block stands square on the curve</source>
   <translation>Gesteuert: ob der letzte Block rechtwinklig auf der Kurve steht</translation>
  </message>
  <message>
   <source>Step</source>
   <translation>Schritt</translation>
  </message>
  <message>
   <source>Strain limit</source>
   <translation>Dehngrenze</translation>
  </message>
  <message>
   <source>Strength</source>
   <translation>Festigkeit</translation>
  </message>
  <message>
   <source>Strength results</source>
   <translation>Ergebnisse zur Festigkeit</translation>
  </message>
  <message>
   <source>Stresses</source>
   <translation>Spannungen</translation>
  </message>
  <message>
   <source>Support</source>
   <translation>Stützkörper</translation>
  </message>
  <message>
   <source>Symmetric</source>
   <translation>Symmetrisch</translation>
  </message>
  <message>
   <source>Taken gamma</source>
   <translation>Gewähltes Gamma</translation>
  </message>
  <message>
   <source>Tape</source>
   <translation>Klebeband</translation>
  </message>
  <message>
   <source>Target barrier</source>
   <translation>Ziel-Energieschwelle</translation>
  </message>
  <message>
   <source>Target margin</source>
   <translation>Ziel-Schnappreserve</translation>
  </message>
  <message>
   <source>Target snap</source>
   <translation>Ziel beim Schnappen</translation>
  </message>
  <message>
   <source>TargetSnap</source>
   <translation>Nach Schnappziel</translation>
  </message>
  <message>
   <source>Tensile strength of your own material along its layers, MPa; 0: that of Material</source>
   <translation>Zugfestigkeit des eigenen Werkstoffs längs seiner Schichten, MPa; 0: die von Werkstoff</translation>
  </message>
  <message>
   <source>Textile</source>
   <translation>Gewebe</translation>
  </message>
  <message>
   <source>The ends of the curve coincide: its tube is printed flat as an open chain and joined when deployed</source>
   <translation>Die Enden der Kurve fallen zusammen: die Röhre wird flach als offene Kette gedruckt und aufgeklappt verbunden</translation>
  </message>
  <message>
   <source>Theta</source>
   <translation>Theta</translation>
  </message>
  <message>
   <source>Theta max</source>
   <translation>Theta max.</translation>
  </message>
  <message>
   <source>Theta min</source>
   <translation>Theta min.</translation>
  </message>
  <message>
   <source>Thetas</source>
   <translation>Theta</translation>
  </message>
  <message>
   <source>Thickness</source>
   <translation>Dicke</translation>
  </message>
  <message>
   <source>Thickness of plates and flanges; 0: twice the panels'</source>
   <translation>Dicke von Platten und Flanschen; 0: das Doppelte der Flächen</translation>
  </message>
  <message>
   <source>Thickness of the magnets; pockets are 0.1 mm deeper</source>
   <translation>Dicke der Magnete; die Taschen sind 0,1 mm tiefer</translation>
  </message>
  <message>
   <source>Thickness of the panels</source>
   <translation>Dicke der Platten</translation>
  </message>
  <message>
   <source>Tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <source>TrianglePlacement whose whole tube is made; empty: one unit by itself from Theta and EdgeLength</source>
   <translation>Dreiecke, deren ganzer Schlauch erstellt wird; leer: eine einzelne Einheit aus Theta und Kantenlänge</translation>
  </message>
  <message>
   <source>Triangles</source>
   <translation>Dreiecke</translation>
  </message>
  <message>
   <source>Unit</source>
   <translation>Einheit</translation>
  </message>
  <message>
   <source>Unit margins</source>
   <translation>Reserven der Einheiten</translation>
  </message>
  <message>
   <source>Up to date</source>
   <translation>Aktuell</translation>
  </message>
  <message>
   <source>Update</source>
   <translation>Aktualisierung</translation>
  </message>
  <message>
   <source>Vertex</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <source>Viewpoint</source>
   <translation>Blickpunkt</translation>
  </message>
  <message>
   <source>Wanted snap margin of each unit, as aiming at a force or a load finds them; empty: TargetMargin for all</source>
   <translation>Gewünschte Schnappreserve jeder Einheit, wie das Zielen auf eine Kraft oder Last sie findet; leer: TargetMargin für alle</translation>
  </message>
  <message>
   <source>Wanted snap margin: needed play / play of the hinges. 1.8 carries a usual tube, below 1 is floppy</source>
   <translation>Gewünschte Schnapp-Reserve: nötiges Spiel / Spiel der Scharniere. 1.8 trägt einen üblichen Schlauch, unter 1 ist schlaff</translation>
  </message>
  <message>
   <source>Wanted width of the knuckles, with short ones at the ends of each hinge, which hold it best; 0: equal knuckles by their number, Segmentations</source>
   <translation>Gewünschte Breite der Glieder, mit kurzen an den Enden jedes Scharniers, die es am besten halten; 0: gleiche Glieder nach ihrer Zahl, Segmentations</translation>
  </message>
  <message>
   <source>Warnings</source>
   <translation>Warnungen</translation>
  </message>
  <message>
   <source>Weight</source>
   <translation>Gewicht</translation>
  </message>
  <message>
   <source>Weight of the tube, g</source>
   <translation>Gewicht der Röhre, g</translation>
  </message>
  <message>
   <source>What TargetMargin counts. Contact: play where the hinges' cones are, as the hinge set measures it. Crease: play at the creases' ends, as up to version 0.1, which takes for firm what is floppy</source>
   <translation>Was TargetMargin zählt. Contact: Spiel dort, wo die Kegel der Scharniere sind, wie es der Scharniersatz misst. Crease: Spiel an den Enden der Falten, wie bis Version 0.1, das Schlaffes für straff hält</translation>
  </message>
  <message>
   <source>What each body is: a panel of one of four kinds, a block, a link, a flexure</source>
   <translation>Was jeder Körper ist: ein Paneel einer von vier Arten, ein Block, ein Glied, ein Biegegelenk</translation>
  </message>
  <message>
   <source>What the curve is taken for: Plane, Sphere or General</source>
   <translation>Wofür die Kurve genommen wird: Plane, Sphere oder General</translation>
  </message>
  <message>
   <source>What the first end of an open tube has. Plate: closed all over. Flange: a wider plate with four screw holes. Foot: a flange and a foot for it, printed beside, that stands square on the plane of FootPoint and FootNormal</source>
   <translation>Was das erste Ende einer offenen Röhre hat. Plate: ganz geschlossen. Flange: eine breitere Platte mit vier Schraubenlöchern. Foot: ein Flansch und ein Fuß dazu, der daneben gedruckt wird und rechtwinklig auf der Ebene von FootPoint und FootNormal steht</translation>
  </message>
  <message>
   <source>What the last end of an open tube has, as StartPart</source>
   <translation>Was das letzte Ende eines offenen Schlauchs hat, wie beim Anfangsstück</translation>
  </message>
  <message>
   <source>What the panels are made of: stiffness, weight and strength</source>
   <translation>Woraus die Flächen sind: Steifigkeit, Gewicht und Festigkeit</translation>
  </message>
  <message>
   <source>What to look at before printing</source>
   <translation>Worauf vor dem Druck zu achten ist</translation>
  </message>
  <message>
   <source>What was wished and cannot be along this curve</source>
   <translation>Was gewünscht war und entlang dieser Kurve nicht geht</translation>
  </message>
  <message>
   <source>When solids follow in the window. Live: beside it, as soon as anything changes. OnDemand: the old ones stay, grey, until they are asked for; without a window they always follow</source>
   <translation>Wann Körper im Fenster folgen. Live: nebenher, sobald sich etwas ändert. OnDemand: die alten bleiben, grau, bis man sie verlangt; ohne Fenster folgen sie immer</translation>
  </message>
  <message>
   <source>Where the deployed tube is held: at its first block, or at both ends</source>
   <translation>Wo die entfaltete Röhre gehalten wird: am ersten Block oder an beiden Enden</translation>
  </message>
  <message>
   <source>Whether the solids are those of the inputs</source>
   <translation>Ob die Körper die der Eingaben sind</translation>
  </message>
  <message>
   <source>Which units are floppy (thick ones, with hinges of HingePlay) or cannot reach the target, and what would help</source>
   <translation>Welche Einheiten schlaff sind (dick, mit Scharnieren vom Scharnierspiel) oder das Ziel nicht erreichen, und was helfen würde</translation>
  </message>
  <message>
   <source>Width of the coupon</source>
   <translation>Breite des Probestücks</translation>
  </message>
  <message>
   <source>Width of the ribs; 0: one line of the nozzle</source>
   <translation>Breite der Rippen; 0: eine Linie der Düse</translation>
  </message>
  <message>
   <source>Young's modulus of your own material, MPa; 0: that of Material</source>
   <translation>Elastizitätsmodul des eigenen Werkstoffs, MPa; 0: der von Werkstoff</translation>
  </message>
  <message>
   <source>Youngs modulus</source>
   <translation>Elastizitätsmodul</translation>
  </message>
  <message>
   <source>‖AB‖ / h: edge length to height of the strip</source>
   <translation>‖AB‖ / h: Kantenlänge zu Höhe des Streifens</translation>
  </message>
 </context>
 <context>
  <name>BistableSentence</name>
  <message>
   <source> (and of {count} other bodies)</source>
   <translation> (und von {count} anderen Körpern)</translation>
  </message>
  <message>
   <source> (and of {count} other body)</source>
   <translation> (und von {count} anderen Körper)</translation>
  </message>
  <message>
   <source> (and of {count} other pair)</source>
   <translation> (und bei {count} anderen Paar)</translation>
  </message>
  <message>
   <source> (and of {count} other pairs)</source>
   <translation> (und bei {count} anderen Paaren)</translation>
  </message>
  <message>
   <source> (and {count} other pair less)</source>
   <translation> (und {count} anderes Paar weniger)</translation>
  </message>
  <message>
   <source> (and {count} other pairs less)</source>
   <translation> (und {count} andere Paare weniger)</translation>
  </message>
  <message>
   <source> (the smallest gap is {gap:.3g} mm at ({at}) mm)</source>
   <translation> (die kleinste Lücke ist {gap:.3g} mm bei ({at}) mm)</translation>
  </message>
  <message>
   <source> and are floppy</source>
   <translation> und damit schlaff</translation>
  </message>
  <message>
   <source> and bears {force:.2f} N more at its free end</source>
   <translation> und trägt {force:.2f} N mehr an seinem freien Ende</translation>
  </message>
  <message>
   <source> and {count} more</source>
   <translation> und {count} weitere</translation>
  </message>
  <message>
   <source> of unit {unit}</source>
   <translation> von Einheit {unit}</translation>
  </message>
  <message>
   <source> of {count}</source>
   <translation> von {count}</translation>
  </message>
  <message>
   <source>$INSUNITS of the file is {code}</source>
   <translation>$INSUNITS der Datei ist {code}</translation>
  </message>
  <message>
   <source>, but for {area:.2g} mm²</source>
   <translation>, bis auf {area:.2g} mm²</translation>
  </message>
  <message>
   <source>, its ratio as near to sin(theta/2) as can be made</source>
   <translation>, ihr Verhältnis so nah an sin(theta/2), wie es geht</translation>
  </message>
  <message>
   <source>, layer {name}</source>
   <translation>, Ebene {name}</translation>
  </message>
  <message>
   <source>, one of {body} first</source>
   <translation>, zuerst eine von {body}</translation>
  </message>
  <message>
   <source>, only {held}</source>
   <translation>, nur {held}</translation>
  </message>
  <message>
   <source>, or {ConeAngle} to 60°</source>
   <translation>, oder {ConeAngle} auf 60° einstellen</translation>
  </message>
  <message>
   <source>, turned by {angle:.0f}°</source>
   <translation>, um {angle:.0f}° gedreht</translation>
  </message>
  <message>
   <source>: compensate</source>
   <translation>: Compensate einschalten</translation>
  </message>
  <message>
   <source>; set {Thickness} of {label} to {pitch:.4g} mm</source>
   <translation>; {Thickness} von {label} auf {pitch:.4g} mm einstellen</translation>
  </message>
  <message>
   <source>; the ends of curves {one} and {other} are {gap:.3g} mm apart at ({x:.4g}, {y:.4g}, {z:.4g}) mm, which a larger “join gaps up to” closes</source>
   <translation>; die Enden der Kurven {one} und {other} sind {gap:.3g} mm voneinander entfernt bei ({x:.4g}, {y:.4g}, {z:.4g}) mm, was ein größeres „Lücken schließen bis“ schließt</translation>
  </message>
  <message>
   <source>A bistable, flat-foldable tube.</source>
   <translation>Ein bistabiler, flach faltbarer Schlauch.</translation>
  </message>
  <message>
   <source>A contact quadrilateral{at} has an edge of length {value:.3g}: corners coincide; give four different corners (A_upper, B_upper, B_lower, A_lower).</source>
   <translation>Ein Kontaktviereck{at} hat eine Kante der Länge {value:.3g}: Ecken fallen zusammen; vier verschiedene Ecken angeben (A_upper, B_upper, B_lower, A_lower).</translation>
  </message>
  <message>
   <source>A contact quadrilateral{at} is not convex: its legs cross or its corners are out of order; make the strip lower (raise {HeightRatio}) or move {Ruling}'s viewpoint away.</source>
   <translation>Ein Kontaktviereck{at} ist nicht konvex: seine Schenkel kreuzen sich oder seine Ecken sind vertauscht; den Streifen niedriger machen ({HeightRatio} erhöhen) oder den Blickpunkt von {Ruling} weiter weg setzen.</translation>
  </message>
  <message>
   <source>A contact quadrilateral{at} is not planar (by {value:.2g} of its size): move its corners into one plane.</source>
   <translation>Ein Kontaktviereck{at} ist nicht eben (um {value:.2g} seiner Größe): seine Ecken in eine Ebene legen.</translation>
  </message>
  <message>
   <source>A design file cannot turn a plan on a sphere: set the rotation of {label} to 0, or give its points heights.</source>
   <translation>Eine Entwurfsdatei kann keinen Plan auf einer Kugel drehen: die Drehung von {label} auf 0 stellen oder den Punkten Höhen geben.</translation>
  </message>
  <message>
   <source>A floor of {body}{more} is {thickness:.2f} mm thick, less than the layer of {limit:g} mm, and would be left out.</source>
   <translation>Ein Boden von {body}{more} ist {thickness:.2f} mm dick, weniger als die Schicht von {limit:g} mm, und würde weggelassen.</translation>
  </message>
  <message>
   <source>A fold{at} would turn inside out (sine {value:.2g}): make {EdgeLength} shorter, move {Ruling} nearer to square with the curve, or raise {Ratio}.</source>
   <translation>Eine Falte{at} würde sich nach innen kehren (Sinus {value:.2g}): {EdgeLength} verkürzen, {Ruling} mehr quer zur Kurve stellen oder {Ratio} erhöhen.</translation>
  </message>
  <message>
   <source>A four-degree vertex is made as it is printed; set {Kind} to Dihedral for one that opens.</source>
   <translation>Eine Ecke vom Grad vier wird gemacht, wie sie gedruckt wird; {Kind} für einen Probedruck, der sich öffnet, auf Zwei Platten setzen.</translation>
  </message>
  <message>
   <source>A hinge close up, and cut along its axis</source>
   <translation>Ein Scharnier aus der Nähe, und entlang seiner Achse geschnitten</translation>
  </message>
  <message>
   <source>A panel{at} would be flipped or have no area (sine of its corner {value:.2g}): make {EdgeLength} shorter, move {Ruling} nearer to square with the curve, or change {Ratio}.</source>
   <translation>Eine Fläche{at} wäre umgeklappt oder ohne Inhalt (Sinus ihrer Ecke {value:.2g}): {EdgeLength} verkürzen, {Ruling} mehr quer zur Kurve stellen oder {Ratio} ändern.</translation>
  </message>
  <message>
   <source>A path has more than {most} pieces, far more than a curve for a tube needs</source>
   <translation>Ein Pfad hat mehr als {most} Stücke, viel mehr als die Kurve eines Rohrs braucht</translation>
  </message>
  <message>
   <source>A wall of {body}{more} is {thickness:.2f} mm thick, less than the nozzle of {limit:g} mm, and would be left out.</source>
   <translation>Eine Wand von {body}{more} ist {thickness:.2f} mm dick, weniger als die Düse von {limit:g} mm, und würde weggelassen.</translation>
  </message>
  <message>
   <source>Against {other}, the {name} print needs {needs}.</source>
   <translation>Gegen {other} braucht der Druck ({name}) {needs}.</translation>
  </message>
  <message>
   <source>Aim: nothing that can be aimed at</source>
   <translation>Zielen: nichts, worauf gezielt werden kann</translation>
  </message>
  <message>
   <source>All {count} units snap</source>
   <translation>Alle {count} Einheiten schnappen</translation>
  </message>
  <message>
   <source>Angle alpha{at} is {value:.6g}°: it must lie between 0° and 90°.</source>
   <translation>Winkel alpha{at} ist {value:.6g}°: er muss zwischen 0° und 90° liegen.</translation>
  </message>
  <message>
   <source>Angle beta{at} is {value:.6g}°: for alpha {0:.4g}° it must be at least 45° - alpha/2 = {1:.6g}° and below 90° - alpha = {2:.6g}°.</source>
   <translation>Winkel beta{at} ist {value:.6g}°: für alpha {0:.4g}° muss er mindestens 45° - alpha/2 = {1:.6g}° und unter 90° - alpha = {2:.6g}° sein.</translation>
  </message>
  <message>
   <source>As PrusaSlicer reckons; soluble support, changes of the material take no time here.</source>
   <translation>So rechnet PrusaSlicer; lösliche Stützen, Wechsel des Materials kosten hier keine Zeit.</translation>
  </message>
  <message>
   <source>At fast speeds, as PrusaSlicer reckons.</source>
   <translation>Bei hohen Geschwindigkeiten, wie PrusaSlicer rechnet.</translation>
  </message>
  <message>
   <source>At fast speeds, estimated, without a slicer.</source>
   <translation>Bei hohen Geschwindigkeiten, geschätzt, ohne Slicer.</translation>
  </message>
  <message>
   <source>At quality speeds, as PrusaSlicer reckons.</source>
   <translation>Bei den Geschwindigkeiten für gute Qualität, wie PrusaSlicer rechnet.</translation>
  </message>
  <message>
   <source>At quality speeds, estimated, without a slicer.</source>
   <translation>Bei den Geschwindigkeiten für gute Qualität, geschätzt, ohne Slicer.</translation>
  </message>
  <message>
   <source>Auto-fit: choose the TrianglePlacement, or the Curve, that is to be followed.</source>
   <translation>Automatisch anpassen: die TrianglePlacement oder die Curve wählen, der gefolgt werden soll.</translation>
  </message>
  <message>
   <source>Base angle omega is {value:.6g}°: it must lie between 0° and 90°.</source>
   <translation>Basiswinkel omega ist {value:.6g}°: er muss zwischen 0° und 90° liegen.</translation>
  </message>
  <message>
   <source>Between any two moving bodies lies a layer of air{rest}.</source>
   <translation>Zwischen je zwei beweglichen Körpern liegt eine Schicht Luft{rest}.</translation>
  </message>
  <message>
   <source>Bodies {overlap} when opened to {opening:.0%}.</source>
   <translation>Bei einer Öffnung von {opening:.0%}: Körper {overlap}.</translation>
  </message>
  <message>
   <source>C'{at} would leave its place between A and B: make {EdgeLength} shorter, move {Ruling} nearer to square with the curve, or lower {Ratio}.</source>
   <translation>C'{at} würde seinen Platz zwischen A und B verlassen: {EdgeLength} verkürzen, {Ruling} mehr quer zur Kurve stellen oder {Ratio} verkleinern.</translation>
  </message>
  <message>
   <source>Cones are {clearance:.3g} mm apart, less than a layer of {layer:.4g} mm: raise {GapLength} to {gap:.4g} mm or lower {ConeAngle} towards 45°.</source>
   <translation>Kegel haben {clearance:.3g} mm Abstand, weniger als eine Schicht von {layer:.4g} mm: {GapLength} auf {gap:.4g} mm erhöhen oder {ConeAngle} in Richtung 45° senken.</translation>
  </message>
  <message>
   <source>Contacts: give two arrays of shape (4, 3) or (n, 4, 3) with the corners A_upper, B_upper, B_lower, A_lower; these have shapes {left} and {right}.</source>
   <translation>Contacts: zwei Felder der Form (4, 3) oder (n, 4, 3) mit den Ecken A_upper, B_upper, B_lower, A_lower angeben; diese haben die Formen {left} und {right}.</translation>
  </message>
  <message>
   <source>Contacts: there is no unit; give at least one pair of quadrilaterals.</source>
   <translation>Contacts: es gibt keine Einheit; mindestens ein Paar von Vierecken angeben.</translation>
  </message>
  <message>
   <source>Contacts{at} have coordinates that are not finite numbers; give them numbers in mm.</source>
   <translation>Contacts{at} haben Koordinaten, die keine endlichen Zahlen sind; Zahlen in mm angeben.</translation>
  </message>
  <message>
   <source>Coupon of {length_x:.4g} x {length_y:.4g} mm leaves nothing of {name}; set {LengthX} and {LengthY} to {longer_x:.4g} and {longer_y:.4g} mm.</source>
   <translation>Vom Probestück mit {length_x:.4g} x {length_y:.4g} mm bleibt nichts von {name} übrig; {LengthX} und {LengthY} auf {longer_x:.4g} und {longer_y:.4g} mm einstellen.</translation>
  </message>
  <message>
   <source>Curve is closed at {place}: the paper's rule cannot follow it</source>
   <translation>Die Kurve ist bei {place} geschlossen: die Regel des Aufsatzes kann ihr nicht folgen</translation>
  </message>
  <message>
   <source>Curve is not on the sphere: at ({at}) mm it is {distance:.4g} mm from {SphereCenter}, {SphereRadius} is {radius:.4g} mm; correct {SphereRadius} and {SphereCenter}, or bring the curve within a quarter of the radius.</source>
   <translation>Die Kurve liegt nicht auf der Kugel: bei ({at}) mm ist sie {distance:.4g} mm von {SphereCenter} entfernt, {SphereRadius} ist {radius:.4g} mm; {SphereRadius} und {SphereCenter} berichtigen oder die Kurve auf ein Viertel des Radius heranbringen.</translation>
  </message>
  <message>
   <source>Curve is not on the sphere: near midpoint {number} it is {reach:.6g} mm from the centre instead of {SphereRadius} {radius:.6g} mm; project the curve onto the sphere or correct {SphereRadius} and {SphereCenter}.</source>
   <translation>Die Kurve liegt nicht auf der Kugel: nahe Mittelpunkt {number} ist sie {reach:.6g} mm von der Mitte entfernt statt {SphereRadius} {radius:.6g} mm; die Kurve auf die Kugel projizieren oder {SphereRadius} und {SphereCenter} berichtigen.</translation>
  </message>
  <message>
   <source>Curve is not planar: near {place} it lies {off:.4g} mm off its best plane</source>
   <translation>Die Kurve ist nicht eben: nahe {place} liegt sie {off:.4g} mm neben ihrer besten Ebene</translation>
  </message>
  <message>
   <source>Curve {number}: {length:.6g} mm long, {size} mm{layer}</source>
   <translation>Kurve {number}: {length:.6g} mm lang, {size} mm{layer}</translation>
  </message>
  <message>
   <source>Curve: it has no length or points that are not finite; check it.</source>
   <translation>Kurve: sie hat keine Länge oder Punkte, die nicht endlich sind; sie prüfen.</translation>
  </message>
  <message>
   <source>Curve: it has points that are not finite; check its control points.</source>
   <translation>Kurve: sie hat Punkte, die nicht endlich sind; ihre Kontrollpunkte prüfen.</translation>
  </message>
  <message>
   <source>Curve: it turns back on itself by {value:.4g}° at {place}, no radius rounds that</source>
   <translation>Kurve: bei {place} kehrt sie um {value:.4g}° auf sich selbst zurück, das rundet kein Radius</translation>
  </message>
  <message>
   <source>Curve: the radius of curvature is too small near {point} (about {radius:.4g} mm, {EdgeLength} {edge_length:.6g} mm needs more than {least:.4g} mm); make {EdgeLength} shorter or the bend wider.</source>
   <translation>Kurve: der Krümmungsradius ist nahe {point} zu klein (etwa {radius:.4g} mm, {EdgeLength} {edge_length:.6g} mm braucht mehr als {least:.4g} mm); {EdgeLength} verkürzen oder den Bogen weiter machen.</translation>
  </message>
  <message>
   <source>Curve: the tube meets itself: unit {first} near {place} overlaps unit {second} near {other_place}; move these parts of the curve further apart or make {EdgeLength} shorter.</source>
   <translation>Kurve: der Schlauch trifft auf sich selbst: Einheit {first} nahe {place} überdeckt Einheit {second} nahe {other_place}; diese Teile der Kurve weiter auseinanderrücken oder {EdgeLength} verkürzen.</translation>
  </message>
  <message>
   <source>Curve: units run into each other near {point}, where they tilt too much; make {EdgeLength} shorter or {Gamma} smaller, or along a General curve move {Ruling} nearer to square with the curve or switch {Level} on.</source>
   <translation>Kurve: Einheiten laufen nahe {point} ineinander, wo sie zu stark kippen; {EdgeLength} verkürzen oder {Gamma} verkleinern, oder entlang einer allgemeinen Kurve {Ruling} mehr quer zur Kurve stellen oder {Level} einschalten.</translation>
  </message>
  <message>
   <source>Deployed it does not fit the printer.</source>
   <translation>Entfaltet passt er nicht in den Drucker.</translation>
  </message>
  <message>
   <source>Deployed, before anything bears, the free end moves by up to {end:.1f} mm ({share:.1%} of the length; {usual:.1f} mm as a rule).</source>
   <translation>Entfaltet bewegt sich das freie Ende, bevor etwas trägt, um bis zu {end:.1f} mm ({share:.1%} der Länge; {usual:.1f} mm in der Regel).</translation>
  </message>
  <message>
   <source>Deployed, before anything bears, the free end moves by up to {end:.1f} mm ({share:.1%} of the length; {usual:.1f} mm as a rule): {cure}, or make {GapLength} smaller.</source>
   <translation>Entfaltet bewegt sich das freie Ende um bis zu {end:.1f} mm ({share:.1%} der Länge; in der Regel {usual:.1f} mm), bevor etwas trägt: {cure}, oder {GapLength} verkleinern.</translation>
  </message>
  <message>
   <source>Deployed, the tube strays up to {off:.3g} mm from its curve{cure}.</source>
   <translation>Entfaltet weicht der Schlauch bis zu {off:.3g} mm von seiner Kurve ab{cure}.</translation>
  </message>
  <message>
   <source>Deployment, 0 flat to 1</source>
   <translation>Entfaltung, von 0 (flach) bis 1</translation>
  </message>
  <message>
   <source>Drag to turn it, roll to come nearer; the slider opens and folds it</source>
   <translation>Ziehen dreht, das Rad holt näher; der Schieber öffnet und faltet</translation>
  </message>
  <message>
   <source>Energy of the units, without thickness, on the way</source>
   <translation>Energie der Einheiten, ohne Dicke, auf dem Weg</translation>
  </message>
  <message>
   <source>Every hinge: cones are {height:.3g} mm high and must exceed two gap lengths, or they disengage; set {FaceThickness} to {thicker:.4g} mm or more{steeper}.</source>
   <translation>Jedes Scharnier: Kegel sind {height:.3g} mm hoch und müssen höher als zwei Spalte sein, sonst rasten sie aus; {FaceThickness} auf {thicker:.4g} mm oder mehr einstellen{steeper}.</translation>
  </message>
  <message>
   <source>Every hinge: the pin is {pin:.3g} mm thick, less than two nozzle widths.</source>
   <translation>Jedes Scharnier: der Stift ist {pin:.3g} mm dick, weniger als zwei Düsenbreiten.</translation>
  </message>
  <message>
   <source>Every hinge: the wall around the pin is {wall:.3g} mm thick, less than one nozzle width.</source>
   <translation>Jedes Scharnier: die Wand um den Stift ist {wall:.3g} mm dick, weniger als eine Düsenbreite.</translation>
  </message>
  <message>
   <source>Every unit snaps. Hands that pull ‖AB‖ = {lever:.0f} mm from the leg at B open the weakest, unit {unit}, with {force:.1f} N; units open one after another, the weakest first: {order}.</source>
   <translation>Jede Einheit schnappt. Hände, die ‖AB‖ = {lever:.0f} mm vom Schenkel bei B ziehen, öffnen die schwächste, Einheit {unit}, mit {force:.1f} N; die Einheiten öffnen sich nacheinander, die schwächste zuerst: {order}.</translation>
  </message>
  <message>
   <source>Files</source>
   <translation>Dateien</translation>
  </message>
  <message>
   <source>Flat-folded or deployed</source>
   <translation>Flach gefaltet oder entfaltet</translation>
  </message>
  <message>
   <source>Flexible hinges have no cones or pins.</source>
   <translation>Biegsame Scharniere haben keine Kegel oder Stifte.</translation>
  </message>
  <message>
   <source>Flexible hinges have no cones: their force cannot be aimed at</source>
   <translation>Biegsame Scharniere haben keine Kegel: auf ihre Kraft kann nicht gezielt werden</translation>
  </message>
  <message>
   <source>Geometry</source>
   <translation>Geometrie</translation>
  </message>
  <message>
   <source>Give the hinges less play (steeper cones, smaller {GapLength}, or flexible hinges, which have none), ask for a smaller margin, or use a bed that holds longer edges.</source>
   <translation>Den Scharnieren weniger Spiel geben (steilere Kegel, kleinere {GapLength} oder biegsame Scharniere, die keines haben), eine kleinere Reserve verlangen oder ein Bett verwenden, auf das längere Kanten passen.</translation>
  </message>
  <message>
   <source>Give the hinges less play, ask for a smaller margin, or use a tougher material.</source>
   <translation>Den Scharnieren weniger Spiel geben, eine kleinere Reserve verlangen oder ein zäheres Material verwenden.</translation>
  </message>
  <message>
   <source>Hinge {hinge!r} is unknown: choose one of {names}.</source>
   <translation>Das Scharnier {hinge!r} ist unbekannt: eines von {names} wählen.</translation>
  </message>
  <message>
   <source>Hinge {hinge} has room for {count} segments instead of {wanted}.</source>
   <translation>Scharnier {hinge} hat Platz für {count} Glieder statt {wanted}.</translation>
  </message>
  <message>
   <source>Hinge {hinge}: no finger of {bond_width:.3g} mm fits into panel {panel}; set BondWidth to {narrower:.3g} mm, or {larger}.</source>
   <translation>Scharnier {hinge}: kein Finger von {bond_width:.3g} mm passt in Platte {panel}; BondWidth auf {narrower:.3g} mm oder {larger} einstellen.</translation>
  </message>
  <message>
   <source>Hinge {hinge}: {left} left between its vertices and {needed}</source>
   <translation>Scharnier {hinge}: {left} zwischen seinen Ecken, und {needed}</translation>
  </message>
  <message>
   <source>Hinges{at} cannot be shifted so that the unit closes when deployed (at {value:.0f}°): make {FaceThickness} and {GapBetweenPlanes} smaller (their sum is {pitch:.4g} mm), {EdgeLength} longer than {edge:.4g} mm, or {Ratio} larger; beyond 110° only less {Gamma} or a {Ratio} nearer to sin(theta/2) helps.</source>
   <translation>Scharniere{at} lassen sich nicht so verschieben, dass die Einheit entfaltet schließt (bei {value:.0f}°): {FaceThickness} und {GapBetweenPlanes} verkleinern (ihre Summe ist {pitch:.4g} mm), {EdgeLength} länger als {edge:.4g} mm machen oder {Ratio} vergrößern; jenseits von 110° hilft nur weniger {Gamma} oder ein {Ratio} näher an sin(theta/2).</translation>
  </message>
  <message>
   <source>Illustrator draws in points: if the size is too small, the scale is 1.3333</source>
   <translation>Illustrator zeichnet in Punkten: Ist die Größe zu klein, ist der Maßstab 1.3333</translation>
  </message>
  <message>
   <source>It folds back at {closing:.0f} N·mm and needs {wanted:.1f} times that: aim at it (fitting.aim, carry=1.5), make {TargetMargin} or {EdgeLength} larger, the tube shorter, or hold both ends ({FixedAt}).</source>
   <translation>Sie faltet bei {closing:.0f} N·mm zurück und braucht {wanted:.1f}-mal so viel: darauf zielen (fitting.aim, carry=1.5), {TargetMargin} oder {EdgeLength} vergrößern, den Schlauch kürzen oder beide Enden halten ({FixedAt}).</translation>
  </message>
  <message>
   <source>It is bent open, beyond its stop: a larger {EdgeLength} or both ends held ({FixedAt}) help.</source>
   <translation>Sie wird über ihren Anschlag hinaus aufgebogen: es hilft, {EdgeLength} zu vergrößern oder beide Enden zu halten ({FixedAt}).</translation>
  </message>
  <message>
   <source>It weighs {weight:.0f} g; its free end gives way elastically by {sag}. Held at both ends, gravity along {gravity},</source>
   <translation>Er wiegt {weight:.0f} g; sein freies Ende gibt elastisch um {sag} nach. An beiden Enden gehalten, Schwerkraft entlang {gravity}:</translation>
  </message>
  <message>
   <source>It weighs {weight:.0f} g; its free end gives way elastically by {sag}. Held by its first block, gravity along {gravity},</source>
   <translation>Er wiegt {weight:.0f} g; sein freies Ende gibt elastisch um {sag} nach. Am ersten Block gehalten, Schwerkraft entlang {gravity}:</translation>
  </message>
  <message>
   <source>It would break where it snaps: {where} bears {stress:.0f} MPa, {share:.1f} times what {material} bears printed flat; a larger ratio, thicker panels or another orientation help.</source>
   <translation>Er würde beim Schnappen brechen: {where} trägt {stress:.0f} MPa, {share:.1f}-mal so viel, wie {material} flach gedruckt trägt; ein größeres Verhältnis, dickere Platten oder eine andere Ausrichtung helfen.</translation>
  </message>
  <message>
   <source>It would break where it snaps: {where} bears {stress:.0f} MPa, {share:.1f} times what {material} bears printed on edge; a larger ratio, thicker panels or another orientation help.</source>
   <translation>Er würde beim Schnappen brechen: {where} trägt {stress:.0f} MPa, {share:.1f}-mal so viel, wie {material} hochkant gedruckt trägt; ein größeres Verhältnis, dickere Platten oder eine andere Ausrichtung helfen.</translation>
  </message>
  <message>
   <source>Layers of {height:g} mm give every body its volume to {share:.1%}.</source>
   <translation>Schichten von {height:g} mm geben jedem Körper sein Volumen auf {share:.1%} genau.</translation>
  </message>
  <message>
   <source>Layers of {height:g} mm lay {area:.2g} mm² of {upper} directly on {lower}{more}, {result}.</source>
   <translation>Schichten von {height:g} mm legen {area:.2g} mm² von {upper} direkt auf {lower}{more}, {result}.</translation>
  </message>
  <message>
   <source>Layers of {height:g} mm make {body} {share:.0%} of its volume: its flat faces lie up to {off:.2g} mm off the layers.</source>
   <translation>Schichten von {height:g} mm geben {body} {share:.0%} seines Volumens: seine flachen Seiten liegen bis zu {off:.2g} mm neben den Schichten.</translation>
  </message>
  <message>
   <source>Left out, clearance {clearance:.2f} mm: {refused}</source>
   <translation>Weggelassen, Spiel {clearance:.2f} mm: {refused}</translation>
  </message>
  <message>
   <source>Left out: {count} × {what} ({why})</source>
   <translation>Ausgelassen: {count} × {what} ({why})</translation>
  </message>
  <message>
   <source>Loose pillars</source>
   <translation>Lose Pfeiler</translation>
  </message>
  <message>
   <source>MJCF is the mechanism of one print</source>
   <translation>MJCF ist der Mechanismus eines Drucks</translation>
  </message>
  <message>
   <source>Make it again</source>
   <translation>Noch einmal machen</translation>
  </message>
  <message>
   <source>Make it printable: choose the Curve that the tube is to follow.</source>
   <translation>Druckbar machen: wähle die Kurve, der die Röhre folgen soll.</translation>
  </message>
  <message>
   <source>Make the curve gentler or longer.</source>
   <translation>Die Kurve sanfter oder länger machen.</translation>
  </message>
  <message>
   <source>Make the curve gentler, or the panels thinner.</source>
   <translation>Die Kurve sanfter oder die Platten dünner machen.</translation>
  </message>
  <message>
   <source>Make the curve gentler.</source>
   <translation>Die Kurve sanfter machen.</translation>
  </message>
  <message>
   <source>Make the curve longer, or the bed higher so that more, shorter units stack up.</source>
   <translation>Die Kurve länger machen oder das Bett höher, damit sich mehr, kürzere Einheiten stapeln.</translation>
  </message>
  <message>
   <source>Make the panels thinner, the curve shorter (or cut it into parts), or use a higher bed.</source>
   <translation>Die Platten dünner oder die Kurve kürzer machen (oder sie in Teile schneiden) oder ein höheres Bett verwenden.</translation>
  </message>
  <message>
   <source>No isometric unit was found for the contacts{at} (residual {value:.2g}): make {EdgeLength} shorter, move {Ruling} nearer to square with the curve, or raise {Ratio}.</source>
   <translation>Keine isometrische Einheit gefunden für die Kontakte{at} (Restfehler {value:.2g}): {EdgeLength} verkürzen, {Ruling} mehr quer zur Kurve stellen oder {Ratio} erhöhen.</translation>
  </message>
  <message>
   <source>No wall is thinner than the nozzle, no floor thinner than a layer.</source>
   <translation>Keine Wand ist dünner als die Düse, kein Boden dünner als eine Schicht.</translation>
  </message>
  <message>
   <source>Not even one unit, {extent} large, fits the bed of {room}.</source>
   <translation>Nicht einmal eine Einheit, {extent} groß, passt auf das Bett von {room}.</translation>
  </message>
  <message>
   <source>Note: {note}</source>
   <translation>Hinweis: {note}</translation>
  </message>
  <message>
   <source>Nothing fits. {tried} combinations tried; {reasons}. {furthest}</source>
   <translation>Nichts passt. {tried} Kombinationen versucht; {reasons}. {furthest}</translation>
  </message>
  <message>
   <source>Nothing is laid over air.</source>
   <translation>Nichts liegt über Luft.</translation>
  </message>
  <message>
   <source>Nothing is selected to export: choose one or more objects.</source>
   <translation>Nichts zum Exportieren ausgewählt: ein oder mehrere Objekte wählen.</translation>
  </message>
  <message>
   <source>Nothing is selected to report on: choose one or more prints or tubes.</source>
   <translation>Für den Bericht ist nichts ausgewählt: Wähle einen oder mehrere Drucke oder Rohre.</translation>
  </message>
  <message>
   <source>On the toolpaths of the slicer the {count} bodies {touch}.</source>
   <translation>Auf den Werkzeugwegen des Slicers: {count} Körper {touch}.</translation>
  </message>
  <message>
   <source>Open</source>
   <translation>Öffnen</translation>
  </message>
  <message>
   <source>OpenSCAD agrees: {bodies} closed bodies of {volume:.6g} mm³ ({off:.3%} off ours).</source>
   <translation>OpenSCAD stimmt zu: {bodies} geschlossene Körper von {volume:.6g} mm³ ({off:.3%} Abweichung von unseren).</translation>
  </message>
  <message>
   <source>OpenSCAD does not accept the mesh: {complaint}.</source>
   <translation>OpenSCAD nimmt das Netz nicht an: {complaint}.</translation>
  </message>
  <message>
   <source>OpenSCAD finds {found} separate bodies where there are {bodies}.</source>
   <translation>OpenSCAD findet {found} getrennte Körper, wo es {bodies} sind.</translation>
  </message>
  <message>
   <source>OpenSCAD made nothing: {reason}.</source>
   <translation>OpenSCAD hat nichts erzeugt: {reason}.</translation>
  </message>
  <message>
   <source>OpenSCAD measures {found:.6g} mm³, {off:.2%} off our {volume:.6g} mm³.</source>
   <translation>OpenSCAD misst {found:.6g} mm³, {off:.2%} neben unseren {volume:.6g} mm³.</translation>
  </message>
  <message>
   <source>OpenSCAD was not found: install it (openscad.org), or put its path into the environment variable OPENSCAD.</source>
   <translation>OpenSCAD wurde nicht gefunden: es installieren (openscad.org) oder seinen Pfad in die Umgebungsvariable OPENSCAD schreiben.</translation>
  </message>
  <message>
   <source>Opening angle and ratio of every unit</source>
   <translation>Öffnungswinkel und Verhältnis jeder Einheit</translation>
  </message>
  <message>
   <source>Opening angle theta{at} is {value:.6g}°: it must lie between 0° and 180°.</source>
   <translation>Öffnungswinkel theta{at} ist {value:.6g}°: er muss zwischen 0° und 180° liegen.</translation>
  </message>
  <message>
   <source>Opening angle theta{at} is {value:.6g}°: on a sphere it must be above 0° and below 60°; use a smaller {Gamma}, a shorter {EdgeLength} or a gentler curve.</source>
   <translation>Öffnungswinkel theta{at} ist {value:.6g}°: auf einer Kugel muss er über 0° und unter 60° liegen; ein kleineres {Gamma}, eine kürzere {EdgeLength} oder eine sanftere Kurve verwenden.</translation>
  </message>
  <message>
   <source>Panel {body} is too large for the sheet: choose a larger sheet.</source>
   <translation>Fläche {body} ist zu groß für den Bogen: einen größeren Bogen wählen.</translation>
  </message>
  <message>
   <source>Panel {label} is {long:.0f} × {short:.0f} mm, larger than a sheet of {width:g} × {height:g} mm with its margins: make {EdgeLength} {most:.0f} mm or less, or take sheets that hold it.</source>
   <translation>Die Fläche {label} ist {long:.0f} × {short:.0f} mm groß, größer als eine Tafel von {width:g} × {height:g} mm mit ihren Rändern: {EdgeLength} auf höchstens {most:.0f} mm setzen oder Tafeln nehmen, auf die sie passt.</translation>
  </message>
  <message>
   <source>Panel {panel}: cut back by {cut_back:.3g} mm at every edge, no edge is left at hinge {hinge}</source>
   <translation>Platte {panel}: an jeder Kante um {cut_back:.3g} mm gekürzt, bleibt an Scharnier {hinge} keine Kante übrig</translation>
  </message>
  <message>
   <source>Panels{at} would open inside out, through one another: swap its left and right contact panels.</source>
   <translation>Platten{at} würden sich verkehrt herum öffnen, durcheinander hindurch: linke und rechte Kontaktplatten vertauschen.</translation>
  </message>
  <message>
   <source>Parameters</source>
   <translation>Parameter</translation>
  </message>
  <message>
   <source>Pictures need matplotlib, which is not installed</source>
   <translation>Bilder brauchen matplotlib, und das ist nicht installiert</translation>
  </message>
  <message>
   <source>Plates are {clearance:.2g} mm apart beside the hinge, less than a layer: raise {GapBetweenPlanes} to {layer:.4g} mm, or {RotationAngle}.</source>
   <translation>Platten haben neben dem Scharnier {clearance:.2g} mm Abstand, weniger als eine Schicht: {GapBetweenPlanes} auf {layer:.4g} mm erhöhen, oder {RotationAngle} erhöhen.</translation>
  </message>
  <message>
   <source>Poisson's ratio of {material} is {value:.6g}</source>
   <translation>Die Querkontraktionszahl von {material} ist {value:.6g}</translation>
  </message>
  <message>
   <source>Poses{at} cannot be found at {value:.0%} of its opening: make {FaceThickness} and {GapBetweenPlanes} smaller (their sum is {pitch:.4g} mm), {EdgeLength} longer than {edge:.4g} mm, or {Ratio} larger.</source>
   <translation>Lagen{at} lassen sich bei {value:.0%} der Öffnung nicht finden: {FaceThickness} und {GapBetweenPlanes} verkleinern (ihre Summe ist {pitch:.4g} mm), {EdgeLength} länger als {edge:.4g} mm machen oder {Ratio} vergrößern.</translation>
  </message>
  <message>
   <source>PrusaSlicer made no toolpaths, it says {said!r}: change that, or slice the exported STL by hand to see more.</source>
   <translation>PrusaSlicer hat keine Werkzeugwege erzeugt, es sagt {said!r}: das ändern, oder das exportierte STL von Hand slicen, um mehr zu sehen.</translation>
  </message>
  <message>
   <source>PrusaSlicer was not found: install it (Debian: apt install prusa-slicer), or set the environment variable {variable} to its path.</source>
   <translation>PrusaSlicer wurde nicht gefunden: es installieren (Debian: apt install prusa-slicer) oder die Umgebungsvariable {variable} auf seinen Pfad setzen.</translation>
  </message>
  <message>
   <source>Ratio rule {rule!r} is unknown on a sphere: use 'exact' or 'paper'.</source>
   <translation>Verhältnisregel {rule!r} ist auf einer Kugel unbekannt: 'exact' oder 'paper' verwenden.</translation>
  </message>
  <message>
   <source>Safety of every deployed unit against folding under the tube's weight</source>
   <translation>Sicherheit jeder entfalteten Einheit dagegen, unter dem Gewicht des Schlauchs zuzufalten</translation>
  </message>
  <message>
   <source>Save this as {name}, and run {command}.</source>
   <translation>Dies als {name} speichern und {command} ausführen.</translation>
  </message>
  <message>
   <source>Save this as {name}, {files} beside it, and run {command}.</source>
   <translation>Dies als {name} speichern, {files} daneben, und {command} ausführen.</translation>
  </message>
  <message>
   <source>Scaled by {scale:g}</source>
   <translation>Skaliert mit {scale:g}</translation>
  </message>
  <message>
   <source>Sheet {sheet!r} is unknown: use {names}, or width x height in mm such as 600x400, at least {width} x {height}.</source>
   <translation>Bogen {sheet!r} ist unbekannt: {names} verwenden, oder Breite x Höhe in mm wie 600x400, mindestens {width} x {height}.</translation>
  </message>
  <message>
   <source>Snap margin of every unit: below 1 it is floppy</source>
   <translation>Schnappreserve jeder Einheit: unter 1 ist sie schlaff</translation>
  </message>
  <message>
   <source>Stand-offs are for knuckles: set {Process} to {soluble}, so that the gaps of flexible hinges are filled.</source>
   <translation>Abstandsrippen gibt es nur bei Gelenkgliedern: stelle {Process} auf {soluble}, damit die Spalte biegsamer Gelenke gefüllt werden.</translation>
  </message>
  <message>
   <source>Stock {stock!r} is no sheet: give its width x height in mm, such as 2500x1250.</source>
   <translation>{stock!r} ist keine Tafel: Breite x Höhe in mm angeben, etwa 2500x1250.</translation>
  </message>
  <message>
   <source>Strip height h = {0:.6g}{at} does not fit between the curve and the point where the legs of its thick panels meet, {value:.6g} away: raise {HeightRatio}, make the panels thinner ({FaceThickness}, {GapBetweenPlanes}) or {Gamma} larger.</source>
   <translation>Streifenhöhe h = {0:.6g}{at} passt nicht zwischen die Kurve und den Punkt, in dem sich die Schenkel ihrer dicken Platten treffen, {value:.6g} entfernt: {HeightRatio} erhöhen, die Platten dünner machen ({FaceThickness}, {GapBetweenPlanes}) oder {Gamma} vergrößern.</translation>
  </message>
  <message>
   <source>Strip height h = {0:.6g}{at} does not fit between the curve and the viewpoint, which is {value:.6g} away: raise {HeightRatio} or move {Ruling}'s viewpoint away.</source>
   <translation>Streifenhöhe h = {0:.6g}{at} passt nicht zwischen die Kurve und den Blickpunkt, der {value:.6g} entfernt ist: {HeightRatio} erhöhen oder den Blickpunkt von {Ruling} weiter weg setzen.</translation>
  </message>
  <message>
   <source>Strip height h = {value:.6g} is too large for omega {0:.4g}°: the inner base vanishes at {1:.6g}; raise {HeightRatio} or omega (a larger sphere).</source>
   <translation>Streifenhöhe h = {value:.6g} ist zu groß für omega {0:.4g}°: die innere Grundseite verschwindet bei {1:.6g}; {HeightRatio} oder omega erhöhen (eine größere Kugel).</translation>
  </message>
  <message>
   <source>Strip height h is {value:.6g}: set {HeightRatio} ‖AB‖/h to a number above 0.</source>
   <translation>Streifenhöhe h ist {value:.6g}: {HeightRatio} ‖AB‖/h auf eine Zahl über 0 einstellen.</translation>
  </message>
  <message>
   <source>Strips have no play: deployed, nothing moves before something bears.</source>
   <translation>Streifen haben kein Spiel: entfaltet bewegt sich nichts, bevor etwas trägt.</translation>
  </message>
  <message>
   <source>Tabs are {tab_depth:.4g} mm deep: give 0 for none, or 4 to 10 mm.</source>
   <translation>Laschen sind {tab_depth:.4g} mm tief: 0 für keine oder 4 bis 10 mm angeben.</translation>
  </message>
  <message>
   <source>The blocks{at} lean so much that their planes meet on the wrong side: make {EdgeLength} shorter or move {Ruling}'s viewpoint nearer to square with the curve.</source>
   <translation>Die Blöcke{at} neigen sich so stark, dass sich ihre Ebenen auf der falschen Seite treffen: {EdgeLength} verkürzen oder den Blickpunkt von {Ruling} mehr quer zur Kurve stellen.</translation>
  </message>
  <message>
   <source>The calibration plate</source>
   <translation>Die Kalibrierplatte</translation>
  </message>
  <message>
   <source>The cones hang over by {angle:.0f}° from the vertical and print without support.</source>
   <translation>Die Kegel hängen um {angle:.0f}° aus der Senkrechten über und lassen sich ohne Stütze drucken.</translation>
  </message>
  <message>
   <source>The cones of {name} hang over by {angle:.0f}° from the vertical, more than the {steepest:g}° that print without support.</source>
   <translation>Die Kegel von {name} hängen um {angle:.0f}° aus der Senkrechten über, mehr als die {steepest:g}°, die sich ohne Stütze drucken lassen.</translation>
  </message>
  <message>
   <source>The contacts{at} open by {value:.4g}° about the leg at B: the opening must lie between 0° and 180°; use a larger {Gamma} or {EdgeLength}.</source>
   <translation>Die Kontakte{at} öffnen sich um {value:.4g}° um den Schenkel bei B: die Öffnung muss zwischen 0° und 180° liegen; ein größeres {Gamma} oder eine größere {EdgeLength} verwenden.</translation>
  </message>
  <message>
   <source>The curve and its triangles, seen along the legs of the strips</source>
   <translation>Die Kurve und ihre Dreiecke, entlang der Schenkel der Streifen gesehen</translation>
  </message>
  <message>
   <source>The curve has {count} {kind}, more than {most}</source>
   <translation>Die Kurve hat {count} {kind}, mehr als {most}</translation>
  </message>
  <message>
   <source>The deployed state{at} does not fold flat: its panels are too thick and lock on the way; make {FaceThickness} and {GapBetweenPlanes} smaller (their sum is {pitch:.4g} mm), {EdgeLength} longer than {edge:.4g} mm, or {Ratio} larger.</source>
   <translation>Der entfaltete Zustand{at} lässt sich nicht flach falten: seine Platten sind zu dick und verklemmen unterwegs; {FaceThickness} und {GapBetweenPlanes} verkleinern (ihre Summe ist {pitch:.4g} mm), {EdgeLength} länger als {edge:.4g} mm machen oder {Ratio} vergrößern.</translation>
  </message>
  <message>
   <source>The deployed tube, and as ghosts how far its play lets it go</source>
   <translation>Der entfaltete Schlauch, und als Schatten, wie weit sein Spiel ihn gehen lässt</translation>
  </message>
  <message>
   <source>The drawing has numbers that are not finite, or far too large</source>
   <translation>Die Zeichnung hat Zahlen, die nicht endlich oder viel zu groß sind</translation>
  </message>
  <message>
   <source>The first unit on its way from flat to deployed</source>
   <translation>Die erste Einheit auf dem Weg von flach zu entfaltet</translation>
  </message>
  <message>
   <source>The flat-folded print and the deployed tube, in one light, at one scale</source>
   <translation>Der flach gefaltete Druck und der entfaltete Schlauch, in einem Licht, in einem Maßstab</translation>
  </message>
  <message>
   <source>The folder {folder} cannot be written: choose another one.</source>
   <translation>In den Ordner {folder} kann nicht geschrieben werden: einen anderen wählen.</translation>
  </message>
  <message>
   <source>The foot's plane is too near to the {end} of the tube, or cuts it: move {FootPoint} by {missing:.3g} mm against {FootNormal}, or more.</source>
   <translation>Die Ebene des Fußes ist dem {end} der Röhre zu nahe oder schneidet es: verschiebe {FootPoint} um {missing:.3g} mm oder mehr gegen {FootNormal}.</translation>
  </message>
  <message>
   <source>The foot's plane misses the {end} of the tube: that looks {angle:.0f}° away from it, 60° at most; set {FootNormal} to about ({x:.2f}, {y:.2f}, {z:.2f}).</source>
   <translation>Die Ebene des Fußes verfehlt das {end} der Röhre: es schaut {angle:.0f}° an ihr vorbei, höchstens 60° gehen; setze {FootNormal} auf etwa ({x:.2f}, {y:.2f}, {z:.2f}).</translation>
  </message>
  <message>
   <source>The hardest worked place, {where}, bears {stress:.0f} MPa of {material}, {share:.0%} of its strength.</source>
   <translation>Die am stärksten beanspruchte Stelle, {where}, trägt {stress:.0f} MPa aus {material}, {share:.0%} der Festigkeit.</translation>
  </message>
  <message>
   <source>The hinges are strips without play, so no snap margin tells whether units stay open: strips of usual walls take more to bend than panels resist, and fold the print back.</source>
   <translation>Die Scharniere sind Streifen ohne Spiel, darum sagt keine Schnappreserve, ob Einheiten offen bleiben: Streifen üblicher Wandstärke zu biegen braucht mehr, als die Platten entgegensetzen, und sie falten den Druck zurück.</translation>
  </message>
  <message>
   <source>The last row of the table is its first point again: the curve closes, and a closed tube cannot be folded flat</source>
   <translation>Die letzte Zeile der Tabelle ist wieder ihr erster Punkt: Die Kurve schließt sich, und ein geschlossenes Rohr lässt sich nicht flach falten</translation>
  </message>
  <message>
   <source>The legs{at} are neither parallel nor all through one point (by {value:.2g}): a flat-foldable unit needs one {Ruling}, a direction or a viewpoint, for both contacts.</source>
   <translation>Die Schenkel{at} sind weder parallel noch gehen sie alle durch einen Punkt (um {value:.2g}): eine flach faltbare Einheit braucht ein {Ruling}, eine Richtung oder einen Blickpunkt, für beide Kontakte.</translation>
  </message>
  <message>
   <source>The mesh of {body} has {volume:.5g} mm³, {off:.1%} off its solid's {solid:.5g} mm³.</source>
   <translation>Das Netz von {body} hat {volume:.5g} mm³, {off:.1%} neben den {solid:.5g} mm³ seines Körpers.</translation>
  </message>
  <message>
   <source>The mesh of {body} {fault}.</source>
   <translation>Das Netz von {body} {fault}.</translation>
  </message>
  <message>
   <source>The nearest two moving bodies are {distance} apart in the flat print.</source>
   <translation>Die nächsten zwei beweglichen Körper haben im flachen Druck {distance} Abstand.</translation>
  </message>
  <message>
   <source>The print</source>
   <translation>Der Druck</translation>
  </message>
  <message>
   <source>The print has {parts} separate parts instead of {expected} bodies.</source>
   <translation>Der Druck hat {parts} getrennte Teile statt {expected} Körper.</translation>
  </message>
  <message>
   <source>The print is {extent} large and fits the bed of {room}{turned}.</source>
   <translation>Der Druck ist {extent} groß und passt auf das Bett von {room}{turned}.</translation>
  </message>
  <message>
   <source>The print of {count} units is {extent} large, too large for the bed of {room}: {most} units fit.</source>
   <translation>Der Druck von {count} Einheiten ist {extent} groß, zu groß für das Bett von {room}: {most} Einheiten passen.</translation>
  </message>
  <message>
   <source>The print on edge with its ties, green: where to cut</source>
   <translation>Der Druck hochkant mit seinen Stegen, grün: wo zu schneiden ist</translation>
  </message>
  <message>
   <source>The style sheet of the drawing has far too many rules</source>
   <translation>Das Stylesheet der Zeichnung hat viel zu viele Regeln</translation>
  </message>
  <message>
   <source>The test print</source>
   <translation>Der Probedruck</translation>
  </message>
  <message>
   <source>The test print on its bed</source>
   <translation>Der Probedruck auf seinem Druckbett</translation>
  </message>
  <message>
   <source>The transform “{text}” is of no kind that SVG knows in a plane</source>
   <translation>Die Transformation „{text}“ ist von keiner Art, die SVG in der Ebene kennt</translation>
  </message>
  <message>
   <source>The tube of {count} units is printed in {parts} parts.</source>
   <translation>Der Schlauch aus {count} Einheiten wird in {parts} Teilen gedruckt.</translation>
  </message>
  <message>
   <source>The two contact quadrilaterals{at} do not share the leg at B: give both with the corners A_upper, B_upper, B_lower, A_lower and the same B_upper and B_lower.</source>
   <translation>Die beiden Kontaktvierecke{at} haben nicht denselben Schenkel bei B: beide mit den Ecken A_upper, B_upper, B_lower, A_lower und denselben B_upper und B_lower angeben.</translation>
  </message>
  <message>
   <source>The two stable states at one scale</source>
   <translation>Die beiden stabilen Zustände in einem Maßstab</translation>
  </message>
  <message>
   <source>The unit</source>
   <translation>Die Einheit</translation>
  </message>
  <message>
   <source>The unit snaps</source>
   <translation>Die Einheit schnappt</translation>
  </message>
  <message>
   <source>The unit's pitch is {pitch:.6g} mm and the hinges' {hinges:.6g} mm: give both the same {FaceThickness} and {GapBetweenPlanes}.</source>
   <translation>Der Ebenenabstand der Einheit ist {pitch:.6g} mm und der der Scharniere {hinges:.6g} mm: beiden dieselben {FaceThickness} und {GapBetweenPlanes} geben.</translation>
  </message>
  <message>
   <source>The {name} print does not fit the printer.</source>
   <translation>Der Druck ({name}) passt nicht in den Drucker.</translation>
  </message>
  <message>
   <source>There is no document (.FCStd) in {folder}</source>
   <translation>In {folder} ist kein Dokument (.FCStd)</translation>
  </message>
  <message>
   <source>There is no file {path}</source>
   <translation>Es gibt keine Datei {path}</translation>
  </message>
  <message>
   <source>There is no folder {folder}: make it, or choose another one.</source>
   <translation>Es gibt keinen Ordner {folder}: ihn anlegen oder einen anderen wählen.</translation>
  </message>
  <message>
   <source>There is no sheet {page}: choose page 1 to {count}, or none.</source>
   <translation>Es gibt keinen Bogen {page}: Seite 1 bis {count} wählen, oder keine.</translation>
  </message>
  <message>
   <source>This browser has no WebGL 2: see the pictures below.</source>
   <translation>Dieser Browser hat kein WebGL 2: siehe die Bilder unten.</translation>
  </message>
  <message>
   <source>Torque about the leg at B that opening and folding back take</source>
   <translation>Drehmoment um den Schenkel bei B, das Öffnen und Zurückfalten brauchen</translation>
  </message>
  <message>
   <source>Turned the worst way, unit {unit} would fold at {factor:.2f} times its load.</source>
   <translation>In der ungünstigsten Lage würde Einheit {unit} beim {factor:.2f}fachen ihrer Last zuklappen.</translation>
  </message>
  <message>
   <source>Turned whatever way, no unit folds below {factor:.1f} times its load (unit {unit}).</source>
   <translation>Wie auch immer gedreht, klappt keine Einheit unter dem {factor:.1f}fachen ihrer Last zu (Einheit {unit}).</translation>
  </message>
  <message>
   <source>Unit {numbers}{more}</source>
   <translation>Einheit {numbers}{more}</translation>
  </message>
  <message>
   <source>Unit {units} does not snap: {why}</source>
   <translation>Einheit {units} schnappt nicht: {why}</translation>
  </message>
  <message>
   <source>Unit {unit}</source>
   <translation>Einheit {unit}</translation>
  </message>
  <message>
   <source>Unit {unit} cannot be computed exactly enough: between flat and deployed its panels change by {change:.1g} of their size</source>
   <translation>Einheit {unit} lässt sich nicht genau genug berechnen: Zwischen flach und entfaltet ändern sich ihre Flächen um {change:.1g} ihrer Größe</translation>
  </message>
  <message>
   <source>Unit {unit} cannot be computed: some of its corners are nowhere</source>
   <translation>Einheit {unit} lässt sich nicht berechnen: Einige ihrer Ecken liegen nirgends</translation>
  </message>
  <message>
   <source>Unit {unit} would break where it snaps: its hardest worked knuckle bears {share:.0%} of what {material} bears. Make {EdgeLength} longer or {FaceThickness} larger, or choose a tougher {Material}.</source>
   <translation>Einheit {unit} bräche, wo sie schnappt: ihr am stärksten belastetes Scharnierglied trägt {share:.0%} dessen, was {material} trägt. {EdgeLength} länger oder {FaceThickness} größer machen, oder ein zäheres {Material} wählen.</translation>
  </message>
  <message>
   <source>Unit {unit}: hinge {hinge} is {whole:.0f} mm long, too short for leaves that reach {leaf:g} mm onto the panels: make {EdgeLength} {factor:.1f} times longer, or take another hinge.</source>
   <translation>Einheit {unit}: Das Scharnier {hinge} ist {whole:.0f} mm lang, zu kurz für Lappen, die {leaf:g} mm auf die Flächen reichen: {EdgeLength} {factor:.1f}-mal so lang machen oder ein anderes Scharnier nehmen.</translation>
  </message>
  <message>
   <source>Unit {unit}: nothing is left of panel {panel} {gap:.3g} mm inside its hinge axes: make {EdgeLength} longer, or the gap at the edges smaller.</source>
   <translation>Einheit {unit}: Von der Fläche {panel} bleibt {gap:.3g} mm innerhalb ihrer Scharnierachsen nichts übrig: {EdgeLength} länger oder den Spalt an den Kanten kleiner machen.</translation>
  </message>
  <message>
   <source>Unit {unit}: {note}</source>
   <translation>Einheit {unit}: {note}</translation>
  </message>
  <message>
   <source>Unit {unit}: {refused}</source>
   <translation>Einheit {unit}: {refused}</translation>
  </message>
  <message>
   <source>Unit {unit}: {refused} It is {width:g} x {height:g} mm.</source>
   <translation>Einheit {unit}: {refused} Er hat {width:g} x {height:g} mm.</translation>
  </message>
  <message>
   <source>Unit: {unit} ({source})</source>
   <translation>Einheit: {unit} ({source})</translation>
  </message>
  <message>
   <source>Units</source>
   <translation>Einheiten</translation>
  </message>
  <message>
   <source>Units {numbers}{more}</source>
   <translation>Einheiten {numbers}{more}</translation>
  </message>
  <message>
   <source>Units {units} do not snap: {why}</source>
   <translation>Die Einheiten {units} schnappen nicht: {why}</translation>
  </message>
  <message>
   <source>Units {unit} and {after} do not join: their contact panels are {gap:.3g} mm apart, as the curve turns back on itself there</source>
   <translation>Die Einheiten {unit} und {after} treffen sich nicht: ihre Kontaktflächen liegen {gap:.3g} mm auseinander, denn die Kurve kehrt dort um</translation>
  </message>
  <message>
   <source>Units {unit} and {following} have no common contact panel: make {EdgeLength} larger.</source>
   <translation>Die Einheiten {unit} und {following} haben keine gemeinsame Kontaktplatte: {EdgeLength} vergrößern.</translation>
  </message>
  <message>
   <source>Use a larger bed, a larger {HeightRatio} or a shorter curve.</source>
   <translation>Ein größeres Bett, ein größeres {HeightRatio} oder eine kürzere Kurve verwenden.</translation>
  </message>
  <message>
   <source>Ways to print it</source>
   <translation>Wege, sie zu drucken</translation>
  </message>
  <message>
   <source>What went wrong:</source>
   <translation>Was nicht gelang:</translation>
  </message>
  <message>
   <source>Where to cut</source>
   <translation>Wo zu schneiden ist</translation>
  </message>
  <message>
   <source>Will it snap, will it stand?</source>
   <translation>Schnappt er, steht er?</translation>
  </message>
  <message>
   <source>With its feet beside the stack the print takes {x:.0f} × {y:.0f} mm, and the bed has {length:.4g} × {width:.4g} mm: choose Flange instead of Foot, or a smaller {EdgeLength}.</source>
   <translation>Mit den Füßen neben dem Stapel braucht der Druck {x:.0f} × {y:.0f} mm, und das Druckbett hat {length:.4g} × {width:.4g} mm: wähle Flansch statt Fuß oder eine kleinere {EdgeLength}.</translation>
  </message>
  <message>
   <source>a checksum is wrong</source>
   <translation>eine Prüfsumme stimmt nicht</translation>
  </message>
  <message>
   <source>a cover</source>
   <translation>eine Abdeckung</translation>
  </message>
  <message>
   <source>a filling</source>
   <translation>eine Füllung</translation>
  </message>
  <message>
   <source>a gentler curve</source>
   <translation>eine sanftere Kurve</translation>
  </message>
  <message>
   <source>a higher strip has room for its hinges where the curve climbs</source>
   <translation>ein höherer Streifen hat Platz für seine Scharniere, wo die Kurve steigt</translation>
  </message>
  <message>
   <source>a little above the wanted {margin:.3g}</source>
   <translation>ein wenig über den gewünschten {margin:.3g}</translation>
  </message>
  <message>
   <source>a picture</source>
   <translation>ein Bild</translation>
  </message>
  <message>
   <source>a solid</source>
   <translation>ein Körper</translation>
  </message>
  <message>
   <source>a strip with fingers needs {need:.3g} mm</source>
   <translation>ein Streifen mit Fingern braucht {need:.3g} mm</translation>
  </message>
  <message>
   <source>a surface</source>
   <translation>eine Fläche</translation>
  </message>
  <message>
   <source>a tie joins them by {area:.2f} mm², more than the {limit:.2f} mm² that come off</source>
   <translation>ein Haltesteg verbindet sie mit {area:.2f} mm², mehr als die {limit:.2f} mm², die sich lösen lassen</translation>
  </message>
  <message>
   <source>a tie joins {count} of them</source>
   <translation>ein Haltesteg verbindet {count} davon</translation>
  </message>
  <message>
   <source>a view</source>
   <translation>eine Ansicht</translation>
  </message>
  <message>
   <source>about {sag:.1f} mm</source>
   <translation>etwa {sag:.1f} mm</translation>
  </message>
  <message>
   <source>about {time}</source>
   <translation>etwa {time}</translation>
  </message>
  <message>
   <source>all others snap too weakly: margin {best:.2f} at best, {wanted:.2f} wanted</source>
   <translation>alle anderen schnappen zu schwach: Reserve bestenfalls {best:.2f}, gewünscht {wanted:.2f}</translation>
  </message>
  <message>
   <source>all units fit one print</source>
   <translation>alle Einheiten passen in einen Druck</translation>
  </message>
  <message>
   <source>apply or remove the transforms of the shape in the drawing program</source>
   <translation>wende die Transformationen der Form im Zeichenprogramm an oder entferne sie</translation>
  </message>
  <message>
   <source>are</source>
   <translation>sind</translation>
  </message>
  <message>
   <source>are welded</source>
   <translation>sind verschweißt</translation>
  </message>
  <message>
   <source>area on the bed</source>
   <translation>Fläche auf dem Druckbett</translation>
  </message>
  <message>
   <source>as drawn</source>
   <translation>wie gezeichnet</translation>
  </message>
  <message>
   <source>as in your hinges, which margins were measured with</source>
   <translation>wie in deinen Scharnieren, mit denen die Reserven gemessen sind</translation>
  </message>
  <message>
   <source>at least {distance:.3f} mm</source>
   <translation>mindestens {distance:.3f} mm</translation>
  </message>
  <message>
   <source>at rest</source>
   <translation>in Ruhe</translation>
  </message>
  <message>
   <source>barrier</source>
   <translation>Schwelle</translation>
  </message>
  <message>
   <source>below 0.001 mm</source>
   <translation>unter 0.001 mm</translation>
  </message>
  <message>
   <source>bends freely</source>
   <translation>biegt sich frei</translation>
  </message>
  <message>
   <source>block</source>
   <translation>Block</translation>
  </message>
  <message>
   <source>block {name}</source>
   <translation>Block {name}</translation>
  </message>
  <message>
   <source>by</source>
   <translation>von</translation>
  </message>
  <message>
   <source>cannot follow the curve: {count}, as “{error}”</source>
   <translation>können der Kurve nicht folgen: {count}, wie „{error}“</translation>
  </message>
  <message>
   <source>check it</source>
   <translation>prüfe sie</translation>
  </message>
  <message>
   <source>check it, or save it again</source>
   <translation>prüfe sie oder speichere sie neu</translation>
  </message>
  <message>
   <source>check its name and folder</source>
   <translation>prüfe Namen und Ordner</translation>
  </message>
  <message>
   <source>choose EndFit or Steered as {PlacementRule}, which close the tube, or open the curve by a gap of a few {EdgeLength}</source>
   <translation>als {PlacementRule} Bis zum Ende oder Gesteuert wählen, die den Schlauch schließen, oder die Kurve um einige {EdgeLength} öffnen</translation>
  </message>
  <message>
   <source>choose Steered or Paper as {PlacementRule}, or change {EdgeLength}</source>
   <translation>als {PlacementRule} Gesteuert oder Aufsatz wählen oder {EdgeLength} ändern</translation>
  </message>
  <message>
   <source>choose a BistableUnit</source>
   <translation>eine BistableUnit wählen</translation>
  </message>
  <message>
   <source>choose a Curve of this workbench</source>
   <translation>eine Curve dieses Arbeitsbereichs wählen</translation>
  </message>
  <message>
   <source>choose a DXF file</source>
   <translation>wähle eine DXF-Datei</translation>
  </message>
  <message>
   <source>choose a TrianglePlacement of this workbench, or none for a single unit</source>
   <translation>eine TrianglePlacement dieses Arbeitsbereichs wählen, oder keine für eine einzelne Einheit</translation>
  </message>
  <message>
   <source>choose a {kind} file</source>
   <translation>wähle eine {kind}-Datei</translation>
  </message>
  <message>
   <source>choose an SVG file, or save it again as plain SVG</source>
   <translation>wähle eine SVG-Datei oder speichere sie neu als einfaches SVG</translation>
  </message>
  <message>
   <source>choose another folder</source>
   <translation>einen anderen Ordner wählen</translation>
  </message>
  <message>
   <source>choose geometry that does not depend on {label}</source>
   <translation>wähle Geometrie, die nicht von {label} abhängt</translation>
  </message>
  <message>
   <source>choose one HingeSet</source>
   <translation>ein HingeSet wählen</translation>
  </message>
  <message>
   <source>choose one of {known}</source>
   <translation>wähle eines von {known}</translation>
  </message>
  <message>
   <source>choose one of {layers}</source>
   <translation>wähle eines von {layers}</translation>
  </message>
  <message>
   <source>choose one, or another suffix</source>
   <translation>wähle eine, oder eine andere Endung</translation>
  </message>
  <message>
   <source>choose {RatioRule} TargetSnap or a smaller ratio, or </source>
   <translation>{RatioRule} Nach Schnappziel oder ein kleineres Verhältnis wählen, oder </translation>
  </message>
  <message>
   <source>closure is {value!r}</source>
   <translation>closure ist {value!r}</translation>
  </message>
  <message>
   <source>cones of fine hinges are nearer to each other than thicker layers</source>
   <translation>die Kegel feiner Scharniere liegen näher beieinander als dickere Schichten</translation>
  </message>
  <message>
   <source>convert it to mm, and write (mm) or nothing behind</source>
   <translation>rechne sie in mm um und schreibe (mm) oder nichts dahinter</translation>
  </message>
  <message>
   <source>convert them all to mm</source>
   <translation>rechne alle in mm um</translation>
  </message>
  <message>
   <source>convert them to coordinates in mm or m (a projection such as UTM for a map)</source>
   <translation>rechne sie in Koordinaten in mm oder m um (für eine Karte eine Projektion wie UTM)</translation>
  </message>
  <message>
   <source>copy it into {own} first, or make an App::Link to it there</source>
   <translation>kopiere es zuerst nach {own}, oder lege dort einen App::Link darauf an</translation>
  </message>
  <message>
   <source>corners</source>
   <translation>Ecken</translation>
  </message>
  <message>
   <source>correct it</source>
   <translation>berichtige es</translation>
  </message>
  <message>
   <source>correct it, or the unit in the head of the table</source>
   <translation>berichtige ihn, oder die Einheit im Kopf der Tabelle</translation>
  </message>
  <message>
   <source>crosses itself at {count} places</source>
   <translation>durchdringt sich selbst an {count} Stellen</translation>
  </message>
  <message>
   <source>cut at heights, mm</source>
   <translation>Schnitte auf den Höhen, mm</translation>
  </message>
  <message>
   <source>deployed</source>
   <translation>entfaltet</translation>
  </message>
  <message>
   <source>deployed {number}</source>
   <translation>entfaltet {number}</translation>
  </message>
  <message>
   <source>deployed, way {number}</source>
   <translation>entfaltet, Lage {number}</translation>
  </message>
  <message>
   <source>deployment_frames is {deployment_frames}: give a number of states from 0 to 10000.</source>
   <translation>deployment_frames ist {deployment_frames}: eine Anzahl von Zuständen von 0 bis 10000 angeben.</translation>
  </message>
  <message>
   <source>do not overlap</source>
   <translation>überlappen sich nicht</translation>
  </message>
  <message>
   <source>do not touch anywhere</source>
   <translation>berühren sich nirgends</translation>
  </message>
  <message>
   <source>do not use it, or save the drawing again as plain SVG</source>
   <translation>benutze sie nicht, oder speichere die Zeichnung neu als einfaches SVG</translation>
  </message>
  <message>
   <source>draw it again</source>
   <translation>zeichne es neu</translation>
  </message>
  <message>
   <source>draw one path, or turn text and surfaces to paths, and export it again</source>
   <translation>zeichne einen Pfad, oder wandle Text und Flächen in Pfade um, und exportiere neu</translation>
  </message>
  <message>
   <source>drawn {scale:.3g} times as large, {more:.3g} mm longer, the curve would do</source>
   <translation>{scale:.3g}-mal so groß gezeichnet, {more:.3g} mm länger, ginge die Kurve</translation>
  </message>
  <message>
   <source>edge</source>
   <translation>Kante</translation>
  </message>
  <message>
   <source>empty it, so that {TargetMargin} counts for all, or aim again</source>
   <translation>leeren, dann gilt {TargetMargin} für alle, oder neu zielen</translation>
  </message>
  <message>
   <source>en</source>
   <translation>de</translation>
  </message>
  <message>
   <source>end</source>
   <translation>Endstück</translation>
  </message>
  <message>
   <source>entity</source>
   <translation>Element</translation>
  </message>
  <message>
   <source>every unit aims for a margin of its own</source>
   <translation>jede Einheit zielt auf ihre eigene Reserve</translation>
  </message>
  <message>
   <source>explode it, or remove it from itself</source>
   <translation>löse ihn auf, oder entferne ihn aus sich selbst</translation>
  </message>
  <message>
   <source>explode the block</source>
   <translation>löse den Block auf</translation>
  </message>
  <message>
   <source>export it again with plain attributes instead of CSS</source>
   <translation>exportiere sie neu mit einfachen Attributen statt CSS</translation>
  </message>
  <message>
   <source>export it again, as DXF R12 to 2018</source>
   <translation>exportiere sie neu, als DXF R12 bis 2018</translation>
  </message>
  <message>
   <source>export it with one decimal mark and no thousands separators</source>
   <translation>exportiere sie mit einem Dezimalzeichen und ohne Tausendertrennzeichen</translation>
  </message>
  <message>
   <source>export it without thousands separators</source>
   <translation>exportiere sie ohne Tausendertrennzeichen</translation>
  </message>
  <message>
   <source>export the curve again</source>
   <translation>exportiere die Kurve neu</translation>
  </message>
  <message>
   <source>export the selected curve by itself</source>
   <translation>exportiere die ausgewählte Kurve für sich</translation>
  </message>
  <message>
   <source>ffmpeg made no film: {reason}.</source>
   <translation>ffmpeg hat keinen Film gemacht: {reason}.</translation>
  </message>
  <message>
   <source>finer hinges have less play, and fit round tighter bends</source>
   <translation>feinere Scharniere haben weniger Spiel und passen um engere Bögen</translation>
  </message>
  <message>
   <source>flat</source>
   <translation>flach</translation>
  </message>
  <message>
   <source>flat-folded</source>
   <translation>flach gefaltet</translation>
  </message>
  <message>
   <source>flat-folded, on edge</source>
   <translation>flach gefaltet, hochkant</translation>
  </message>
  <message>
   <source>folded back by</source>
   <translation>zurückgefaltet durch</translation>
  </message>
  <message>
   <source>foreign content</source>
   <translation>fremder Inhalt</translation>
  </message>
  <message>
   <source>free some space there</source>
   <translation>dort Platz schaffen</translation>
  </message>
  <message>
   <source>gaps of up to {gap:.4g} mm are closed</source>
   <translation>Lücken bis {gap:.4g} mm sind geschlossen</translation>
  </message>
  <message>
   <source>give a factor above 0 that units carry with, 1.5 for example, or a force above 0 of a hand in N, not both</source>
   <translation>einen Faktor über 0 angeben, mit dem Einheiten tragen, 1.5 zum Beispiel, oder eine Kraft einer Hand über 0 in N, nicht beides</translation>
  </message>
  <message>
   <source>give it a number above 0</source>
   <translation>gib eine Zahl über 0</translation>
  </message>
  <message>
   <source>give it a number with mm, cm, in, pt or px, with a point for its decimals</source>
   <translation>gib eine Zahl mit mm, cm, in, pt oder px und mit Dezimalpunkt</translation>
  </message>
  <message>
   <source>give one point a row</source>
   <translation>gib einen Punkt je Zeile</translation>
  </message>
  <message>
   <source>give one point a row, x, y and perhaps z in mm, two rows or more</source>
   <translation>gib einen Punkt je Zeile, x, y und vielleicht z in mm, zwei Zeilen oder mehr</translation>
  </message>
  <message>
   <source>give the document a size in mm in the drawing program</source>
   <translation>gib dem Dokument im Zeichenprogramm eine Größe in mm</translation>
  </message>
  <message>
   <source>give the folder that --out named</source>
   <translation>gib den Ordner an, den --out nannte</translation>
  </message>
  <message>
   <source>give x, y or x, y, z (with a semicolon between them where numbers have commas), or name the columns in the first row</source>
   <translation>gib x, y oder x, y, z (mit Semikolon dazwischen, wo Zahlen Kommas haben), oder benenne die Spalten in der ersten Zeile</translation>
  </message>
  <message>
   <source>give {Ruling} a direction, or choose EndFit as {PlacementRule}</source>
   <translation>{Ruling} eine Richtung geben oder als {PlacementRule} Bis zum Ende wählen</translation>
  </message>
  <message>
   <source>give {name} a number up to {most:.0e}</source>
   <translation>gib {name} eine Zahl bis {most:.0e}</translation>
  </message>
  <message>
   <source>group</source>
   <translation>Gruppe</translation>
  </message>
  <message>
   <source>has triangles that face the wrong way</source>
   <translation>hat Dreiecke, die nach der falschen Seite zeigen</translation>
  </message>
  <message>
   <source>has {count} separate parts instead of one</source>
   <translation>hat {count} getrennte Teile statt eines</translation>
  </message>
  <message>
   <source>has {count} triangles without area</source>
   <translation>hat {count} Dreiecke ohne Fläche</translation>
  </message>
  <message>
   <source>height</source>
   <translation>Höhe</translation>
  </message>
  <message>
   <source>held</source>
   <translation>gehalten</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>ausgeblendet</translation>
  </message>
  <message>
   <source>holds</source>
   <translation>hält</translation>
  </message>
  <message>
   <source>how the segments are held on a climbing curve</source>
   <translation>wie die Strecken auf einer steigenden Kurve gehalten werden</translation>
  </message>
  <message>
   <source>in contact</source>
   <translation>in Berührung</translation>
  </message>
  <message>
   <source>in paper space</source>
   <translation>im Papierbereich</translation>
  </message>
  <message>
   <source>install ezdxf (FreeCAD's Addon Manager offers it with this workbench; on Debian python3-ezdxf), or save the curve as SVG</source>
   <translation>installiere ezdxf (FreeCADs Addon-Manager bietet es mit diesem Arbeitsbereich an; in Debian python3-ezdxf), oder speichere die Kurve als SVG</translation>
  </message>
  <message>
   <source>install it (Debian: apt install python3-matplotlib)</source>
   <translation>es installieren (Debian: apt install python3-matplotlib)</translation>
  </message>
  <message>
   <source>install rhino3dm (FreeCAD's Addon Manager offers it with this workbench), or export the curve from Rhino as STEP</source>
   <translation>installiere rhino3dm (FreeCADs Addon-Manager bietet es mit diesem Arbeitsbereich an), oder exportiere die Kurve aus Rhino als STEP</translation>
  </message>
  <message>
   <source>invisible</source>
   <translation>unsichtbar</translation>
  </message>
  <message>
   <source>is</source>
   <translation>ist</translation>
  </message>
  <message>
   <source>is inside out</source>
   <translation>ist von innen nach außen gekehrt</translation>
  </message>
  <message>
   <source>is not closed at {count} edges</source>
   <translation>ist an {count} Kanten nicht geschlossen</translation>
  </message>
  <message>
   <source>isometry error</source>
   <translation>Isometriefehler</translation>
  </message>
  <message>
   <source>it cannot be opened ({error})</source>
   <translation>lässt sich nicht öffnen ({error})</translation>
  </message>
  <message>
   <source>it carries itself, barely: unit {unit} would give way first, at {factor:.1f} times its load{more}.</source>
   <translation>er trägt sich selbst, gerade noch: Einheit {unit} gäbe zuerst nach, bei der {factor:.1f}-fachen Last{more}.</translation>
  </message>
  <message>
   <source>it carries itself: unit {unit} would give way first, at {factor:.1f} times its load{more}.</source>
   <translation>er trägt sich selbst: Einheit {unit} gäbe zuerst nach, bei der {factor:.1f}-fachen Last{more}.</translation>
  </message>
  <message>
   <source>it does not begin as a picture</source>
   <translation>es beginnt nicht wie ein Bild</translation>
  </message>
  <message>
   <source>it does not carry itself: unit {unit} folds at {factor:.2f} times the weight.</source>
   <translation>er trägt sich nicht selbst: Einheit {unit} faltet sich beim {factor:.2f}-fachen Gewicht zu.</translation>
  </message>
  <message>
   <source>it ends early</source>
   <translation>es endet zu früh</translation>
  </message>
  <message>
   <source>it has none</source>
   <translation>er hat keine</translation>
  </message>
  <message>
   <source>it has {options}</source>
   <translation>er hat {options}</translation>
  </message>
  <message>
   <source>it holds no finite points</source>
   <translation>es enthält keine endlichen Punkte</translation>
  </message>
  <message>
   <source>it holds no object of this workbench</source>
   <translation>enthält kein Objekt dieses Arbeitsbereichs</translation>
  </message>
  <message>
   <source>it is none of what the document holds</source>
   <translation>ist nichts von dem, was das Dokument enthält</translation>
  </message>
  <message>
   <source>it is not in the file</source>
   <translation>fehlt in der Datei</translation>
  </message>
  <message>
   <source>it is not whole ({error})</source>
   <translation>ist nicht ganz ({error})</translation>
  </message>
  <message>
   <source>it lies far from the origin and is moved by ({x:.0f}, {y:.0f}, {z:.0f}) mm</source>
   <translation>sie liegt weit vom Ursprung und ist um ({x:.0f}, {y:.0f}, {z:.0f}) mm verschoben</translation>
  </message>
  <message>
   <source>it lies in another file (xref): bind it</source>
   <translation>liegt in einer anderen Datei (XRef): einbinden</translation>
  </message>
  <message>
   <source>it says {count} triangles and holds {there:.6g}</source>
   <translation>es nennt {count} Dreiecke und enthält {there:.6g}</translation>
  </message>
  <message>
   <source>it was measured without</source>
   <translation>ohne das ist gemessen worden</translation>
  </message>
  <message>
   <source>its brackets do not match</source>
   <translation>seine Klammern passen nicht zueinander</translation>
  </message>
  <message>
   <source>its data end early</source>
   <translation>seine Daten enden zu früh</translation>
  </message>
  <message>
   <source>its head is not that of a whole GLB file</source>
   <translation>sein Kopf ist nicht der einer ganzen GLB-Datei</translation>
  </message>
  <message>
   <source>its original is not in the file</source>
   <translation>das Original fehlt in der Datei</translation>
  </message>
  <message>
   <source>its packing is broken</source>
   <translation>seine Verpackung ist beschädigt</translation>
  </message>
  <message>
   <source>join them, or choose one by its number</source>
   <translation>verbinde sie, oder wähle eine durch ihre Nummer</translation>
  </message>
  <message>
   <source>keep every {step}th row: a tube follows a smooth curve</source>
   <translation>behalte jede {step}. Zeile: Ein Rohr folgt einer glatten Kurve</translation>
  </message>
  <message>
   <source>keep those of one curve</source>
   <translation>behalte die einer Kurve</translation>
  </message>
  <message>
   <source>keep {Gamma} further away from 90°</source>
   <translation>halte {Gamma} weiter von 90° entfernt</translation>
  </message>
  <message>
   <source>knuckle {knuckle} of {body} on hinge {hinge} of unit {unit}</source>
   <translation>Glied {knuckle} von {body} am Scharnier {hinge} der Einheit {unit}</translation>
  </message>
  <message>
   <source>layer {layer} is frozen</source>
   <translation>Ebene {layer} ist gefroren</translation>
  </message>
  <message>
   <source>layer {layer} is off</source>
   <translation>Ebene {layer} ist ausgeschaltet</translation>
  </message>
  <message>
   <source>layers</source>
   <translation>Schichten</translation>
  </message>
  <message>
   <source>leave more than a quarter of the curve uncovered: {count}</source>
   <translation>lassen mehr als ein Viertel der Kurve frei: {count}</translation>
  </message>
  <message>
   <source>length of the curve</source>
   <translation>Länge der Kurve</translation>
  </message>
  <message>
   <source>less {less}</source>
   <translation>weniger {less}</translation>
  </message>
  <message>
   <source>less {less}, and more {more}</source>
   <translation>weniger {less}, und mehr {more}</translation>
  </message>
  <message>
   <source>let the slicer add support there</source>
   <translation>den Slicer dort Stützen ergänzen lassen</translation>
  </message>
  <message>
   <source>let the slicer add support there too</source>
   <translation>den Slicer auch dort Stützen ergänzen lassen</translation>
  </message>
  <message>
   <source>live view</source>
   <translation>bewegte Ansicht</translation>
  </message>
  <message>
   <source>lower {CornerRadius}, or move the corners apart</source>
   <translation>{CornerRadius} verkleinern oder die Ecken auseinanderrücken</translation>
  </message>
  <message>
   <source>make the linear and angular deflection smaller</source>
   <translation>die lineare und die Winkelabweichung verkleinern</translation>
  </message>
  <message>
   <source>make {ConeAngle} {steepest:g}° or less</source>
   <translation>{ConeAngle} auf {steepest:g}° oder weniger einstellen</translation>
  </message>
  <message>
   <source>make {EdgeLength} at least {over:.2f} times shorter</source>
   <translation>{EdgeLength} mindestens {over:.2f}-mal kürzer machen</translation>
  </message>
  <message>
   <source>make {EdgeLength} larger, {Ratio} nearer to sin(theta/2), or {GapLength} smaller</source>
   <translation>{EdgeLength} vergrößern, {Ratio} näher an sin(theta/2) bringen oder {GapLength} verkleinern</translation>
  </message>
  <message>
   <source>make {EdgeLength} longer, choose a {Material} that bears more strain, or set {Joint} to Dowel, Magnet or Screw</source>
   <translation>{EdgeLength} länger machen, ein {Material} wählen, das mehr Dehnung erträgt, oder {Joint} auf Dübel, Magnet oder Schraube setzen</translation>
  </message>
  <message>
   <source>make {EdgeLength} or {Gamma} larger, the curve shorter, or ask for less</source>
   <translation>{EdgeLength} oder {Gamma} größer machen, die Kurve kürzer, oder weniger verlangen</translation>
  </message>
  <message>
   <source>make {EdgeLength} shorter or the curve longer</source>
   <translation>{EdgeLength} verkürzen oder die Kurve verlängern</translation>
  </message>
  <message>
   <source>make {EdgeLength} shorter or the curve smoother</source>
   <translation>mache {EdgeLength} kürzer oder die Kurve glatter</translation>
  </message>
  <message>
   <source>make {EdgeLength} shorter or {Gamma} smaller</source>
   <translation>mache {EdgeLength} kürzer oder {Gamma} kleiner</translation>
  </message>
  <message>
   <source>make {FaceThickness} and {GapBetweenPlanes} multiples of {height:g} mm</source>
   <translation>{FaceThickness} und {GapBetweenPlanes} auf Vielfache von {height:g} mm einstellen</translation>
  </message>
  <message>
   <source>make {FaceThickness} larger</source>
   <translation>{FaceThickness} vergrößern</translation>
  </message>
  <message>
   <source>make {GapBetweenPlanes} and {GapLength} larger</source>
   <translation>{GapBetweenPlanes} und {GapLength} größer machen</translation>
  </message>
  <message>
   <source>make {GapBetweenPlanes} larger than {gap:.3g} mm, or {EdgeLength} longer</source>
   <translation>{GapBetweenPlanes} über {gap:.3g} mm vergrößern oder {EdgeLength} verlängern</translation>
  </message>
  <message>
   <source>make {GapLength} larger than {gap:.3g} mm</source>
   <translation>{GapLength} über {gap:.3g} mm vergrößern</translation>
  </message>
  <message>
   <source>make {GapLength} {known:.3g} mm or more</source>
   <translation>{GapLength} auf {known:.3g} mm oder mehr setzen</translation>
  </message>
  <message>
   <source>make {LayerHeight} smaller, or {GapLength} and {GapBetweenPlanes} larger</source>
   <translation>{LayerHeight} verkleinern oder {GapLength} und {GapBetweenPlanes} vergrößern</translation>
  </message>
  <message>
   <source>make {StandOffSpacing} smaller or {GapBetweenPlanes} larger, or choose another {Process}</source>
   <translation>{StandOffSpacing} kleiner oder {GapBetweenPlanes} größer machen oder ein anderes {Process} wählen</translation>
  </message>
  <message>
   <source>margin {least:.2f} at the least</source>
   <translation>Reserve mindestens {least:.2f}</translation>
  </message>
  <message>
   <source>margins are those of knuckles: flexible hinges have no play to measure</source>
   <translation>Reserven sind die von Scharniergliedern: biegsame Scharniere haben kein Spiel zu messen</translation>
  </message>
  <message>
   <source>margins were measured with it</source>
   <translation>mit ihr sind die Reserven gemessen</translation>
  </message>
  <message>
   <source>material</source>
   <translation>Material</translation>
  </message>
  <message>
   <source>material changes</source>
   <translation>Materialwechsel</translation>
  </message>
  <message>
   <source>measure how hard it snaps (Tube charts); thinner strips ({NozzleDiameter}) bend more easily</source>
   <translation>messen, wie fest es schnappt (Schlauch-Diagramme); dünnere Streifen ({NozzleDiameter}) biegen sich leichter</translation>
  </message>
  <message>
   <source>might not come free</source>
   <translation>lösen sich womöglich nicht</translation>
  </message>
  <message>
   <source>misfit as made</source>
   <translation>Passfehler, wie gemacht</translation>
  </message>
  <message>
   <source>misfit without compensation</source>
   <translation>Passfehler ohne Ausgleich</translation>
  </message>
  <message>
   <source>model</source>
   <translation>Modell</translation>
  </message>
  <message>
   <source>more than {limit:.3g} mm of play and snap</source>
   <translation>mehr als {limit:.3g} mm Spiel und Schnappen</translation>
  </message>
  <message>
   <source>more than {most:.0f} mm (further than a linear law tells)</source>
   <translation>mehr als {most:.0f} mm (weiter, als ein lineares Gesetz sagt)</translation>
  </message>
  <message>
   <source>more would pass the {StrainLimit} of {limit:.1%}</source>
   <translation>mehr überschritte {StrainLimit} von {limit:.1%}</translation>
  </message>
  <message>
   <source>more {more}</source>
   <translation>mehr {more}</translation>
  </message>
  <message>
   <source>moving bodies</source>
   <translation>bewegte Körper</translation>
  </message>
  <message>
   <source>near the least ratio, as the narrow units need it for {margin:.3g}</source>
   <translation>nahe am kleinsten Verhältnis, wie es die schmalen Einheiten für {margin:.3g} brauchen</translation>
  </message>
  <message>
   <source>needed clearance</source>
   <translation>nötiges Spiel</translation>
  </message>
  <message>
   <source>neither stroke nor fill</source>
   <translation>weder Linie noch Füllung</translation>
  </message>
  <message>
   <source>no</source>
   <translation>nein</translation>
  </message>
  <message>
   <source>no curve</source>
   <translation>keine Kurve</translation>
  </message>
  <message>
   <source>no length is</source>
   <translation>keine Länge bleibt</translation>
  </message>
  <message>
   <source>no path: convert it to one</source>
   <translation>kein Pfad: in einen Pfad umwandeln</translation>
  </message>
  <message>
   <source>no play</source>
   <translation>kein Spiel</translation>
  </message>
  <message>
   <source>no print is left for it</source>
   <translation>für ihn bleibt kein Druck übrig</translation>
  </message>
  <message>
   <source>no size given: 96 px an inch</source>
   <translation>keine Größe angegeben: 96 px je Zoll</translation>
  </message>
  <message>
   <source>no suffix</source>
   <translation>keine Endung</translation>
  </message>
  <message>
   <source>no unit given: taken as mm</source>
   <translation>keine Einheit angegeben: als mm gelesen</translation>
  </message>
  <message>
   <source>no viewBox: 96 px an inch</source>
   <translation>keine viewBox: 96 px je Zoll</translation>
  </message>
  <message>
   <source>not displayed</source>
   <translation>nicht angezeigt</translation>
  </message>
  <message>
   <source>of a surface</source>
   <translation>einer Fläche</translation>
  </message>
  <message>
   <source>of it followed</source>
   <translation>davon verfolgt</translation>
  </message>
  <message>
   <source>off the curve</source>
   <translation>neben der Kurve</translation>
  </message>
  <message>
   <source>on the bed</source>
   <translation>auf dem Druckbett</translation>
  </message>
  <message>
   <source>one place is</source>
   <translation>eine Stelle</translation>
  </message>
  <message>
   <source>one unit with {EdgeLength} {edge:.3g} mm is larger than the bed of {x:.4g} × {y:.4g} mm</source>
   <translation>eine Einheit mit {EdgeLength} {edge:.3g} mm ist größer als das Druckbett von {x:.4g} × {y:.4g} mm</translation>
  </message>
  <message>
   <source>only {length:.3g} mm are</source>
   <translation>nur {length:.3g} mm bleiben</translation>
  </message>
  <message>
   <source>open it in Inkscape of today and let it convert the file, or give a scale (1.0667 for 90 px an inch, 1 for 96)</source>
   <translation>öffne sie im heutigen Inkscape und lass die Datei umrechnen, oder gib einen Maßstab (1.0667 für 90 px je Zoll, 1 für 96)</translation>
  </message>
  <message>
   <source>open this corner</source>
   <translation>diese Ecke öffnen</translation>
  </message>
  <message>
   <source>open wider than the 60° that a sphere allows: {count}</source>
   <translation>öffnen weiter als die 60°, die eine Kugel erlaubt: {count}</translation>
  </message>
  <message>
   <source>opened by</source>
   <translation>geöffnet durch</translation>
  </message>
  <message>
   <source>opening angle θ</source>
   <translation>Öffnungswinkel θ</translation>
  </message>
  <message>
   <source>overlap by at most {depth:.3f} mm</source>
   <translation>überlappen sich um höchstens {depth:.3f} mm</translation>
  </message>
  <message>
   <source>picture</source>
   <translation>Bild</translation>
  </message>
  <message>
   <source>pictures</source>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>pieces</source>
   <translation>Stücke</translation>
  </message>
  <message>
   <source>plastic</source>
   <translation>Kunststoff</translation>
  </message>
  <message>
   <source>press into each other by at most {depth:.3f} mm, their preload,</source>
   <translation>drücken höchstens {depth:.3f} mm ineinander, ihre Vorspannung,</translation>
  </message>
  <message>
   <source>print</source>
   <translation>Druck</translation>
  </message>
  <message>
   <source>print higher than {height:.4g} mm: {count}, the lowest {lowest:.4g} mm</source>
   <translation>im Druck höher als {height:.4g} mm: {count}, die niedrigste {lowest:.4g} mm</translation>
  </message>
  <message>
   <source>print {number} of {count}: the bed is {height:.4g} mm high</source>
   <translation>Druck {number} von {count}: das Druckbett ist {height:.4g} mm hoch</translation>
  </message>
  <message>
   <source>printed</source>
   <translation>gedruckt</translation>
  </message>
  <message>
   <source>process</source>
   <translation>Verfahren</translation>
  </message>
  <message>
   <source>property</source>
   <translation>Eigenschaft</translation>
  </message>
  <message>
   <source>raise {Tolerance}, make {EdgeLength} shorter or the bend wider</source>
   <translation>{Tolerance} erhöhen, {EdgeLength} verkürzen oder den Bogen weiter machen</translation>
  </message>
  <message>
   <source>ratio c</source>
   <translation>Verhältnis c</translation>
  </message>
  <message>
   <source>rebuild the solids, and report it if it stays so</source>
   <translation>die Körper neu erstellen, und es melden, wenn es so bleibt</translation>
  </message>
  <message>
   <source>recompute the document first</source>
   <translation>berechne zuerst das Dokument neu</translation>
  </message>
  <message>
   <source>remove the last rows, so that a gap stays open</source>
   <translation>entferne die letzten Zeilen, damit eine Lücke bleibt</translation>
  </message>
  <message>
   <source>remove the shape that is not on the sheet</source>
   <translation>entferne die Form, die nicht auf dem Blatt liegt</translation>
  </message>
  <message>
   <source>removed</source>
   <translation>entfernt</translation>
  </message>
  <message>
   <source>report</source>
   <translation>Bericht</translation>
  </message>
  <message>
   <source>residual of the rule</source>
   <translation>Restfehler der Regel</translation>
  </message>
  <message>
   <source>room for the thick panels</source>
   <translation>Platz für die dicken Platten</translation>
  </message>
  <message>
   <source>run AUDIT in the CAD program, or draw it again, and export once more</source>
   <translation>rufe im CAD-Programm PRÜFUNG auf, oder zeichne es neu, und exportiere noch einmal</translation>
  </message>
  <message>
   <source>safety</source>
   <translation>Sicherheit</translation>
  </message>
  <message>
   <source>save it again as plain SVG</source>
   <translation>speichere sie neu als einfaches SVG</translation>
  </message>
  <message>
   <source>save it again from Rhino, as version 5 or later</source>
   <translation>speichere sie neu aus Rhino, als Version 5 oder später</translation>
  </message>
  <message>
   <source>save it as plain SVG</source>
   <translation>speichere sie als einfaches SVG</translation>
  </message>
  <message>
   <source>save the one curve by itself</source>
   <translation>speichere die eine Kurve für sich</translation>
  </message>
  <message>
   <source>save the one curve by itself (WBLOCK)</source>
   <translation>speichere die eine Kurve für sich (WBLOCK)</translation>
  </message>
  <message>
   <source>see what the check of closed solids finds</source>
   <translation>sehen, was die Prüfung der geschlossenen Körper findet</translation>
  </message>
  <message>
   <source>see which bodies touch in the check of clearances</source>
   <translation>in der Prüfung der Abstände sehen, welche Körper sich berühren</translation>
  </message>
  <message>
   <source>seen from there, the weakest unit is firmest</source>
   <translation>von dort gesehen ist die schwächste Einheit am festesten</translation>
  </message>
  <message>
   <source>set it above 0; 1.5 is firm, below 1 is floppy</source>
   <translation>über 0 einstellen; 1.5 ist straff, unter 1 schlaff</translation>
  </message>
  <message>
   <source>set it from 0 to below 0.5</source>
   <translation>setze es auf 0 bis unter 0,5</translation>
  </message>
  <message>
   <source>set it to 0 for no limit, or to the largest misfit / ‖AB‖ that may be</source>
   <translation>auf 0 setzen, dann gibt es keine Grenze, oder auf den größten Fehler / ‖AB‖, der sein darf</translation>
  </message>
  <message>
   <source>set it to 0, 0, -1 for example</source>
   <translation>setze es zum Beispiel auf 0, 0, -1</translation>
  </message>
  <message>
   <source>set it to Start or Both</source>
   <translation>setze es auf Anfang oder Beide</translation>
  </message>
  <message>
   <source>set it to a length above 0</source>
   <translation>eine Länge über 0 einstellen</translation>
  </message>
  <message>
   <source>set it to a number above 0</source>
   <translation>setze es auf eine Zahl über 0</translation>
  </message>
  <message>
   <source>set it to what one hinge's clearance allows, 0.28 mm by default; hinges without play never turn floppy and need no target</source>
   <translation>auf das einstellen, was die Luft eines Scharniers zulässt, normalerweise 0.28 mm; Scharniere ohne Spiel werden nie schlaff und brauchen kein Ziel</translation>
  </message>
  <message>
   <source>set the page size again and save it</source>
   <translation>stelle die Seitengröße neu ein und speichere</translation>
  </message>
  <message>
   <source>set {FaceThickness} to {thicker:.4g} mm or more, or {Pivot} to Cone</source>
   <translation>{FaceThickness} auf {thicker:.4g} mm oder mehr einstellen, oder {Pivot} auf Kegel</translation>
  </message>
  <message>
   <source>set {FirstUnit} and {LastUnit} to print the parts {parts}</source>
   <translation>mit {FirstUnit} und {LastUnit} die Teile {parts} drucken</translation>
  </message>
  <message>
   <source>set {HingeType} to Rotational</source>
   <translation>{HingeType} auf Drehend stellen</translation>
  </message>
  <message>
   <source>set {Kind} to General, or to Automatic, which finds it, or flatten the curve</source>
   <translation>{Kind} auf Allgemein stellen, oder auf Automatisch, das es findet, oder die Kurve eben machen</translation>
  </message>
  <message>
   <source>set {Orientation} to Flat: on edge, slanted hinges lean their cones</source>
   <translation>{Orientation} auf Flach stellen: hochkant neigen schräge Scharniere ihre Kegel</translation>
  </message>
  <message>
   <source>set {PreloadRule} to Automatic</source>
   <translation>{PreloadRule} auf Automatisch stellen</translation>
  </message>
  <message>
   <source>set {Preload} to less than was found ({Preloads}), or {SegmentWidth} to 5 mm, so that cones at the ends of the hinges hold them</source>
   <translation>{Preload} auf weniger setzen, als gefunden wurde ({Preloads}), oder {SegmentWidth} auf 5 mm, damit Kegel an den Enden der Scharniere sie halten</translation>
  </message>
  <message>
   <source>set {Process} to FDM, ties, or let the slicer add support there</source>
   <translation>{Process} auf FDM, Stege setzen oder den Slicer dort stützen lassen</translation>
  </message>
  <message>
   <source>set {SegmentWidth} to 5 mm and {PreloadRule} to Automatic (three knuckles have their cones too far from the ends of a hinge for that)</source>
   <translation>{SegmentWidth} auf 5 mm und {PreloadRule} auf Automatisch stellen (bei drei Gliedern liegen die Kegel dafür zu weit von den Enden eines Scharniers)</translation>
  </message>
  <message>
   <source>set {Tolerance} above 0 (1 % of {EdgeLength} is {usual:.3g} mm), or choose EndFit as {PlacementRule}</source>
   <translation>{Tolerance} über 0 einstellen (1 % von {EdgeLength} sind {usual:.3g} mm) oder als {PlacementRule} Bis zum Ende wählen</translation>
  </message>
  <message>
   <source>set {name} to {most:.3g} mm or less, make {EdgeLength} longer, or set {Joint} to None</source>
   <translation>{name} auf höchstens {most:.3g} mm setzen, {EdgeLength} länger machen oder {Joint} auf Keine setzen</translation>
  </message>
  <message>
   <source>shape</source>
   <translation>Form</translation>
  </message>
  <message>
   <source>simplify it (Path &gt; Simplify in Inkscape)</source>
   <translation>vereinfache ihn (Pfad &gt; Vereinfachen in Inkscape)</translation>
  </message>
  <message>
   <source>simplify it in the drawing program</source>
   <translation>vereinfache sie im Zeichenprogramm</translation>
  </message>
  <message>
   <source>simplify the curve</source>
   <translation>vereinfache die Kurve</translation>
  </message>
  <message>
   <source>slicer</source>
   <translation>Slicer</translation>
  </message>
  <message>
   <source>snap margin</source>
   <translation>Schnappreserve</translation>
  </message>
  <message>
   <source>split the tube at contact blocks into {count} prints of units {prints}</source>
   <translation>den Schlauch an Kontaktblöcken in {count} Drucke der Einheiten {prints} teilen</translation>
  </message>
  <message>
   <source>start</source>
   <translation>Anfangsstück</translation>
  </message>
  <message>
   <source>state is {state!r}: choose one of {names}.</source>
   <translation>state ist {state!r}: eines von {names} wählen.</translation>
  </message>
  <message>
   <source>stress</source>
   <translation>Spannung</translation>
  </message>
  <message>
   <source>strips of TPU take more to bend than the panels resist.</source>
   <translation>Streifen aus TPU brauchen mehr zum Biegen, als die Platten widerstehen.</translation>
  </message>
  <message>
   <source>support</source>
   <translation>Stützen</translation>
  </message>
  <message>
   <source>switch {Compensate} on</source>
   <translation>{Compensate} einschalten</translation>
  </message>
  <message>
   <source>switch {Compensate} on, so that the hinges close</source>
   <translation>{Compensate} einschalten, damit die Scharniere schließen</translation>
  </message>
  <message>
   <source>switch {Support} on, or let the slicer fill the gaps with soluble support</source>
   <translation>{Support} einschalten oder den Slicer die Spalte mit löslicher Stütze füllen lassen</translation>
  </message>
  <message>
   <source>tan(alpha)*tan(beta){at} is {value:.6g}: it must be below 1/2, or the second triangle has no dart; make alpha or beta smaller.</source>
   <translation>tan(alpha)*tan(beta){at} ist {value:.6g}: es muss unter 1/2 sein, sonst hat das zweite Dreieck keine Pfeilform; alpha oder beta verkleinern.</translation>
  </message>
  <message>
   <source>text</source>
   <translation>Text</translation>
  </message>
  <message>
   <source>text or drawing aid</source>
   <translation>Text oder Zeichenhilfe</translation>
  </message>
  <message>
   <source>the Rhino model has no unit: taken as mm</source>
   <translation>das Rhino-Modell hat keine Einheit: als mm gelesen</translation>
  </message>
  <message>
   <source>the bed</source>
   <translation>dem Druckbett</translation>
  </message>
  <message>
   <source>the curve is too short, or too tight, for two units with hinges</source>
   <translation>die Kurve ist zu kurz oder zu eng für zwei Einheiten mit Scharnieren</translation>
  </message>
  <message>
   <source>the deployed one</source>
   <translation>den entfalteten</translation>
  </message>
  <message>
   <source>the drawn one bends too tightly for units with a margin of {margin:.3g}: up to {change:.3g} mm beside it they have that</source>
   <translation>die gezeichnete ist zu eng für Einheiten mit einer Reserve von {margin:.3g}: bis zu {change:.3g} mm daneben haben sie die</translation>
  </message>
  <message>
   <source>the file gives no unit ($INSUNITS): taken as mm</source>
   <translation>die Datei gibt keine Einheit ($INSUNITS): als mm gelesen</translation>
  </message>
  <message>
   <source>the file; shapes without a unit are in mm</source>
   <translation>die Datei; Formen ohne Einheit sind in mm</translation>
  </message>
  <message>
   <source>the first column only names or counts the rows and is left out</source>
   <translation>die erste Spalte benennt oder zählt nur die Zeilen und ist ausgelassen</translation>
  </message>
  <message>
   <source>the head of the table</source>
   <translation>der Kopf der Tabelle</translation>
  </message>
  <message>
   <source>the hinges' play swallows it. A smaller {GapLength} or ratio, or a larger {EdgeLength} help.</source>
   <translation>das Spiel der Scharniere schluckt es. Es hilft, {GapLength} oder das Verhältnis zu verkleinern oder {EdgeLength} zu vergrößern.</translation>
  </message>
  <message>
   <source>the play of these hinges</source>
   <translation>das Spiel dieser Scharniere</translation>
  </message>
  <message>
   <source>the quickest of {ways} deployed ones</source>
   <translation>den schnellsten von {ways} entfalteten</translation>
  </message>
  <message>
   <source>the rows are sorted by the column {name}</source>
   <translation>die Zeilen sind nach der Spalte {name} sortiert</translation>
  </message>
  <message>
   <source>the same</source>
   <translation>dasselbe</translation>
  </message>
  <message>
   <source>the shapes have neither stroke nor fill</source>
   <translation>die Formen haben weder Strich noch Füllung</translation>
  </message>
  <message>
   <source>the strip height h ({HeightRatio}) so that h is {height:.3g} mm</source>
   <translation>die Streifenhöhe h ({HeightRatio}) auf {height:.3g} mm</translation>
  </message>
  <message>
   <source>the strip of hinge {hinge} of unit {unit}</source>
   <translation>der Streifen des Scharniers {hinge} der Einheit {unit}</translation>
  </message>
  <message>
   <source>the suffix {suffix}</source>
   <translation>die Endung {suffix}</translation>
  </message>
  <message>
   <source>the tube ends where the curve does</source>
   <translation>der Schlauch endet, wo die Kurve endet</translation>
  </message>
  <message>
   <source>the tube ends {gap:.3g} mm from the curve's end</source>
   <translation>die Röhre endet {gap:.3g} mm vor dem Ende der Kurve</translation>
  </message>
  <message>
   <source>the unit of the Rhino model</source>
   <translation>die Einheit des Rhino-Modells</translation>
  </message>
  <message>
   <source>the usual height of the strip</source>
   <translation>die übliche Höhe des Streifens</translation>
  </message>
  <message>
   <source>the usual panels are fine enough</source>
   <translation>die üblichen Platten sind fein genug</translation>
  </message>
  <message>
   <source>the {name} {id} has an error and is read up to it, as a browser does</source>
   <translation>{name} {id} hat einen Fehler und ist bis dahin gelesen, wie ein Browser es tut</translation>
  </message>
  <message>
   <source>their ratio is as near to sin(theta/2) as can be made (share {share:.2g})</source>
   <translation>ihr Verhältnis ist so nah an sin(theta/2), wie es geht (Anteil {share:.2g})</translation>
  </message>
  <message>
   <source>those that snap hard enough strain by {least:.2%} or more, beyond {limit:.2%}</source>
   <translation>die, die hart genug schnappen, dehnen sich um {least:.2%} oder mehr, über {limit:.2%} hinaus</translation>
  </message>
  <message>
   <source>three segments need {need:.3g} mm</source>
   <translation>drei Glieder brauchen {need:.3g} mm</translation>
  </message>
  <message>
   <source>ties</source>
   <translation>Stege</translation>
  </message>
  <message>
   <source>time</source>
   <translation>Zeit</translation>
  </message>
  <message>
   <source>too large for the bed of {width:.4g} × {depth:.4g} mm: {count}, from {EdgeLength} {shortest:.4g} mm on</source>
   <translation>zu groß für das Bett von {width:.4g} × {depth:.4g} mm: {count}, ab {EdgeLength} {shortest:.4g} mm</translation>
  </message>
  <message>
   <source>touch by at most {area:.2f} mm²</source>
   <translation>berühren sich mit höchstens {area:.2f} mm²</translation>
  </message>
  <message>
   <source>twists freely</source>
   <translation>verdreht sich frei</translation>
  </message>
  <message>
   <source>undo that, or choose another {link}</source>
   <translation>mache das rückgängig, oder wähle {link} neu</translation>
  </message>
  <message>
   <source>ungroup the curve</source>
   <translation>löse die Gruppen der Kurve auf</translation>
  </message>
  <message>
   <source>unit {unit} snaps with a margin of {margin:.3g} where {wanted:.3g} is wanted</source>
   <translation>Einheit {unit} schnappt mit einer Schnappreserve von {margin:.3g}, gewünscht sind {wanted:.3g}</translation>
  </message>
  <message>
   <source>units</source>
   <translation>Einheiten</translation>
  </message>
  <message>
   <source>units cannot be made: {count}, as “{error}”</source>
   <translation>Einheiten lassen sich nicht erstellen: {count}, wie „{error}“</translation>
  </message>
  <message>
   <source>units follow the bends better from this side</source>
   <translation>von dieser Seite folgen die Einheiten den Bögen besser</translation>
  </message>
  <message>
   <source>units open by {low:.0f}° to {high:.0f}°, the weakest has a margin of {margin:.3g}</source>
   <translation>Einheiten öffnen um {low:.0f}° bis {high:.0f}°, die schwächste hat eine Reserve von {margin:.3g}</translation>
  </message>
  <message>
   <source>units open more evenly behind bends, and both ends are met</source>
   <translation>hinter Bögen öffnen die Einheiten gleichmäßiger, und beide Enden werden getroffen</translation>
  </message>
  <message>
   <source>unlink the clone</source>
   <translation>löse den Klon von seinem Original</translation>
  </message>
  <message>
   <source>use</source>
   <translation>Verweis</translation>
  </message>
  <message>
   <source>value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>waste</source>
   <translation>Abfall</translation>
  </message>
  <message>
   <source>what the tube may leave the curve by, to open evenly</source>
   <translation>um so viel darf der Schlauch die Kurve verlassen, um gleichmäßig zu öffnen</translation>
  </message>
  <message>
   <source>which has to break free at the first opening</source>
   <translation>was sich beim ersten Öffnen losbrechen muss</translation>
  </message>
  <message>
   <source>which welds them</source>
   <translation>was sie verschweißt</translation>
  </message>
  <message>
   <source>width, height and viewBox of the picture</source>
   <translation>width, height und viewBox des Bildes</translation>
  </message>
  <message>
   <source>without a second stable state</source>
   <translation>ohne zweiten stabilen Zustand</translation>
  </message>
  <message>
   <source>without end</source>
   <translation>ohne Ende</translation>
  </message>
  <message>
   <source>without it thick panels do not snap</source>
   <translation>ohne sie schnappen dicke Platten nicht</translation>
  </message>
  <message>
   <source>without matplotlib</source>
   <translation>ohne matplotlib</translation>
  </message>
  <message>
   <source>without thickness there is no snap margin: set it to face thickness + gap between planes, 1.8 mm for example, or aim for a {TargetBarrier}</source>
   <translation>ohne Dicke gibt es keine Schnappreserve: auf Plattendicke + Abstand der Ebenen einstellen, zum Beispiel 1.8 mm, oder {TargetBarrier} als Ziel nehmen</translation>
  </message>
  <message>
   <source>yes</source>
   <translation>ja</translation>
  </message>
  <message>
   <source>your printer's room</source>
   <translation>Dein Druckbett</translation>
  </message>
  <message>
   <source>{AirLayers} is {air}: in a gap of {layers:.3g} layers set it between 1 and {most:.0f}, or {GapBetweenPlanes} to {gap:.4g} mm or more.</source>
   <translation>{AirLayers} ist {air}: setze es in einem Spalt von {layers:.3g} Schichten zwischen 1 und {most:.0f}, oder {GapBetweenPlanes} auf {gap:.4g} mm oder mehr.</translation>
  </message>
  <message>
   <source>{Bed}: {finding} Cure: {help}.</source>
   <translation>{Bed}: {finding} Abhilfe: {help}.</translation>
  </message>
  <message>
   <source>{ConeAngle} is {cone_angle:.4g}°: set it between 45° and 60°, so that cones print without support.</source>
   <translation>{ConeAngle} ist {cone_angle:.4g}°: zwischen 45° und 60° einstellen, damit Kegel ohne Stütze gedruckt werden.</translation>
  </message>
  <message>
   <source>{CornerRadius} {value:.4g} mm does not fit at the corner of {turn:.3g}° at {place}, where {room:.4g} mm at most does</source>
   <translation>{CornerRadius} {value:.4g} mm passt nicht in die Ecke von {turn:.3g}° bei {place}, wo höchstens {room:.4g} mm passen</translation>
  </message>
  <message>
   <source>{Count} is {count}: set it between {fewest} and {most} hinges.</source>
   <translation>{Count} ist {count}: zwischen {fewest} und {most} Scharniere wählen.</translation>
  </message>
  <message>
   <source>{Deployment} is {opening:.6g}: it must lie between 0 and 1.</source>
   <translation>{Deployment} ist {opening:.6g}: es muss zwischen 0 und 1 liegen.</translation>
  </message>
  <message>
   <source>{Deployment} is {value:.6g}: it must lie between 0 (flat) and 1 (deployed), at most {0:.4g}.</source>
   <translation>{Deployment} ist {value:.6g}: es muss zwischen 0 (flach) und 1 (entfaltet) liegen, höchstens bei {0:.4g}.</translation>
  </message>
  <message>
   <source>{EdgeLength} {edge_length:.6g} mm with {Gamma} {gamma:.4g}° would need more than {most} units along {length:.6g} mm of curve; make {EdgeLength} longer.</source>
   <translation>{EdgeLength} {edge_length:.6g} mm mit {Gamma} {gamma:.4g}° bräuchte mehr als {most} Einheiten auf {length:.6g} mm Kurve; {EdgeLength} verlängern.</translation>
  </message>
  <message>
   <source>{EdgeLength} ‖AB‖ = {edge_length:.6g} mm is too long for this curve of length {length:.6g} mm: not even one unit fits; make {EdgeLength} shorter, the curve longer, or {Gamma} smaller.</source>
   <translation>{EdgeLength} ‖AB‖ = {edge_length:.6g} mm ist zu lang für diese Kurve der Länge {length:.6g} mm: nicht einmal eine Einheit passt; {EdgeLength} verkürzen, die Kurve verlängern oder {Gamma} verkleinern.</translation>
  </message>
  <message>
   <source>{EdgeLength} ‖AB‖ is {value:.6g} mm: set it to a length above 0.</source>
   <translation>{EdgeLength} ‖AB‖ ist {value:.6g} mm: eine Länge über 0 einstellen.</translation>
  </message>
  <message>
   <source>{EdgeLength} ‖AB‖ is {value:.6g}: set it to a length in mm above 0.</source>
   <translation>{EdgeLength} ‖AB‖ ist {value:.6g}: eine Länge in mm über 0 einstellen.</translation>
  </message>
  <message>
   <source>{EdgeLength} ‖AB‖ to {length:.3g} mm</source>
   <translation>{EdgeLength} ‖AB‖ auf {length:.3g} mm</translation>
  </message>
  <message>
   <source>{EdgeLength} ‖AB‖ {factor:.2f} times larger</source>
   <translation>{EdgeLength} ‖AB‖ {factor:.2f}-mal so groß</translation>
  </message>
  <message>
   <source>{EdgeLength}: {value:.4g} mm is too long to steer units along this curve of {length:.4g} mm</source>
   <translation>{EdgeLength}: {value:.4g} mm ist zu lang, um Einheiten entlang dieser Kurve von {length:.4g} mm zu steuern</translation>
  </message>
  <message>
   <source>{FirstUnit} {first} and {LastUnit} {last} do not name units of a tube of {count}: set {FirstUnit} to 1 or more and {LastUnit} to at most {count} (0: the last).</source>
   <translation>{FirstUnit} {first} und {LastUnit} {last} nennen keine Einheiten eines Schlauchs von {count}: {FirstUnit} auf 1 oder mehr und {LastUnit} auf höchstens {count} einstellen (0: die letzte).</translation>
  </message>
  <message>
   <source>{FixedAt} is {value}: the tube has no support</source>
   <translation>{FixedAt} ist {value}: der Schlauch hat keinen Halt</translation>
  </message>
  <message>
   <source>{FootNormal} has no direction: set it to one that points from the plane to the tube.</source>
   <translation>{FootNormal} hat keine Richtung: setze eine, die von der Ebene zur Röhre zeigt.</translation>
  </message>
  <message>
   <source>{Gamma} is {value:.6g}°: the first segment must lean forward; set {Gamma} above 0° and below 90° (10° to 30° is usual).</source>
   <translation>{Gamma} ist {value:.6g}°: die erste Strecke muss sich nach vorn neigen; {Gamma} über 0° und unter 90° einstellen (10° bis 30° ist üblich).</translation>
  </message>
  <message>
   <source>{Gamma}: no angle near {value:.4g}° ends the tube at the curve's end</source>
   <translation>{Gamma}: kein Winkel nahe {value:.4g}° lässt den Schlauch am Ende der Kurve enden</translation>
  </message>
  <message>
   <source>{GapBetweenPlanes} is {gap_between_planes:.6g} mm: set it to 0.6 mm or more.</source>
   <translation>{GapBetweenPlanes} ist {gap_between_planes:.6g} mm: auf 0.6 mm oder mehr einstellen.</translation>
  </message>
  <message>
   <source>{GapBetweenPlanes} {gap_between_planes:.4g} mm is below the layer height: stacked panels would fuse; set {GapBetweenPlanes} to {layer_height:.4g} mm or more.</source>
   <translation>{GapBetweenPlanes} {gap_between_planes:.4g} mm ist kleiner als die Schichthöhe: gestapelte Platten würden verschmelzen; {GapBetweenPlanes} auf {layer_height:.4g} mm oder mehr einstellen.</translation>
  </message>
  <message>
   <source>{GapLength} is {gap:.3g} mm, and on this printer's calibration plate nothing tighter than {known:.3g} mm turned.</source>
   <translation>{GapLength} ist {gap:.3g} mm, und auf der Kalibrierplatte dieses Druckers drehte sich nichts, was enger als {known:.3g} mm ist.</translation>
  </message>
  <message>
   <source>{GapLength} {gap_length:.4g} mm is below the layer height: the printer closes it; set {GapLength} to {layer_height:.4g} mm or more, or {LayerHeight} to {gap_length:.4g} mm or less.</source>
   <translation>{GapLength} {gap_length:.4g} mm ist kleiner als die Schichthöhe: der Drucker schließt den Spalt; {GapLength} auf {layer_height:.4g} mm oder mehr oder {LayerHeight} auf {gap_length:.4g} mm oder weniger einstellen.</translation>
  </message>
  <message>
   <source>{Gravity} has no direction</source>
   <translation>{Gravity} hat keine Richtung</translation>
  </message>
  <message>
   <source>{HeightRatio} ‖AB‖/h is {height_ratio:.6g}: it must be a number above 0, 2.5 is usual.</source>
   <translation>{HeightRatio} ‖AB‖/h ist {height_ratio:.6g}: es muss eine Zahl über 0 sein, 2.5 ist üblich.</translation>
  </message>
  <message>
   <source>{HingeType} is Flexible: strips have no clearance to find, set {HingeType} to Rotational.</source>
   <translation>{HingeType} ist Flexibel: Streifen haben kein Spiel, das zu finden wäre, {HingeType} auf Drehend setzen.</translation>
  </message>
  <message>
   <source>{HingeType} of {label} is Flexible: strips that bend have no deployed solid to slice, set {HingeType} to Rotational.</source>
   <translation>{HingeType} von {label} ist Flexibel: Streifen, die sich biegen, haben keinen entfalteten Körper zum Slicen; {HingeType} auf Drehend stellen.</translation>
  </message>
  <message>
   <source>{HingeType} {hinge_type!r} is unknown: use {known}.</source>
   <translation>{HingeType} {hinge_type!r} ist unbekannt: {known} verwenden.</translation>
  </message>
  <message>
   <source>{Joint} {kind} is unknown: choose one of {names}.</source>
   <translation>{Joint} {kind} ist unbekannt: eines von {names} wählen.</translation>
  </message>
  <message>
   <source>{Joint}: a hole of {diameter:.3g} mm leaves no wall in the contact blocks, whose joint is {length:.3g} × {width:.3g} mm</source>
   <translation>{Joint}: Ein Loch von {diameter:.3g} mm lässt in den Kontaktblöcken, deren Verbindung {length:.3g} × {width:.3g} mm groß ist, keine Wand stehen</translation>
  </message>
  <message>
   <source>{Joint}: two clips whose tongues are {tongue:.3g} mm long, so that they strain by {strain:.2%}, find no room in the joint of {length:.3g} × {width:.3g} mm</source>
   <translation>{Joint}: Zwei Schnapper, deren Zungen {tongue:.3g} mm lang sind, damit sie sich um {strain:.2%} dehnen, haben in der Verbindung von {length:.3g} × {width:.3g} mm keinen Platz</translation>
  </message>
  <message>
   <source>{Kind} {kind!r} is unknown: use Vertex or NonDevelopableVertex.</source>
   <translation>{Kind} {kind!r} ist unbekannt: Vertex oder NonDevelopableVertex verwenden.</translation>
  </message>
  <message>
   <source>{Least} is {least:.4g} mm: set it to a clearance above 0.</source>
   <translation>{Least} ist {least:.4g} mm: ein Spiel über 0 wählen.</translation>
  </message>
  <message>
   <source>{LengthX} and {LengthY} {factor:.2f} times larger</source>
   <translation>{LengthX} und {LengthY} {factor:.2f}-mal so groß</translation>
  </message>
  <message>
   <source>{Level}: legs through a viewpoint have no level; switch {Level} off.</source>
   <translation>{Level}: Schenkel durch einen Blickpunkt liegen nicht waagerecht; {Level} ausschalten.</translation>
  </message>
  <message>
   <source>{MagnetDepth} is {depth:.4g} mm and half a contact block {thickness:.4g} mm thick: set {MagnetDepth} to {most:.3g} mm or less, or {FaceThickness} to {thicker:.4g} mm.</source>
   <translation>{MagnetDepth} ist {depth:.4g} mm und ein halber Kontaktblock {thickness:.4g} mm dick: {MagnetDepth} auf höchstens {most:.3g} mm setzen oder {FaceThickness} auf {thicker:.4g} mm.</translation>
  </message>
  <message>
   <source>{Material} {name} is unknown</source>
   <translation>{Material} {name} ist unbekannt</translation>
  </message>
  <message>
   <source>{OmegaEdgeLength} is {edge:.6g} mm: set it to the {EdgeLength} of the units.</source>
   <translation>{OmegaEdgeLength} ist {edge:.6g} mm: setze es auf {EdgeLength} der Einheiten.</translation>
  </message>
  <message>
   <source>{Omega} is {omega:.6g}°: set it between 0° and 90°, or to 0 to give {SphereRadius}.</source>
   <translation>{Omega} ist {omega:.6g}°: setze es zwischen 0° und 90°, oder auf 0, um {SphereRadius} anzugeben.</translation>
  </message>
  <message>
   <source>{Omega} is {omega:.6g}°: set it to 90° for a plane unit, or above 0° and below 90° for a unit on a sphere.</source>
   <translation>{Omega} ist {omega:.6g}°: auf 90° für eine ebene Einheit einstellen, oder über 0° und unter 90° für eine Einheit auf einer Kugel.</translation>
  </message>
  <message>
   <source>{Pivot} {pivot!r} is unknown: use Cone or Pin.</source>
   <translation>{Pivot} {pivot!r} ist unbekannt: Cone oder Pin verwenden.</translation>
  </message>
  <message>
   <source>{PlateThickness} is {value:.6g} mm: set it to a length, or to 0 for twice the panels'.</source>
   <translation>{PlateThickness} ist {value:.6g} mm: auf eine Länge setzen, oder auf 0 für das Doppelte der Flächen.</translation>
  </message>
  <message>
   <source>{Points} reach {reach:.4g} mm from the top of the sphere, beyond its bottom at {furthest:.4g} mm: make {SphereRadius} larger or the curve smaller.</source>
   <translation>{Points} reichen {reach:.4g} mm von der Oberseite der Kugel weg, über ihre Unterseite bei {furthest:.4g} mm hinaus: {SphereRadius} vergrößern oder die Kurve verkleinern.</translation>
  </message>
  <message>
   <source>{Points}: a curve needs at least two control points of 2 or 3 coordinates each; add control points.</source>
   <translation>{Points}: eine Kurve braucht mindestens zwei Kontrollpunkte mit je 2 oder 3 Koordinaten; Kontrollpunkte hinzufügen.</translation>
  </message>
  <message>
   <source>{Points}: control point {number} has a coordinate that is not a finite number; give it numbers in mm.</source>
   <translation>{Points}: Kontrollpunkt {number} hat eine Koordinate, die keine endliche Zahl ist; Zahlen in mm angeben.</translation>
  </message>
  <message>
   <source>{Points}: control points {number} and {following} coincide; move one of them or remove it.</source>
   <translation>{Points}: die Kontrollpunkte {number} und {following} fallen zusammen; einen davon verschieben oder entfernen.</translation>
  </message>
  <message>
   <source>{Preload} is {value:.6g}: it must lie between 0 (none) and 1.5.</source>
   <translation>{Preload} ist {value:.6g}: es muss zwischen 0 (keine) und 1.5 liegen.</translation>
  </message>
  <message>
   <source>{Preset} {name!r} is unknown: choose one of {names}.</source>
   <translation>{Preset} {name!r} ist unbekannt: eines von {names} wählen.</translation>
  </message>
  <message>
   <source>{Process} {process!r} is unknown: use {known}.</source>
   <translation>{Process} {process!r} ist unbekannt: nimm {known}.</translation>
  </message>
  <message>
   <source>{RatioRule} {name!r} is unknown: choose one of {names}.</source>
   <translation>{RatioRule} {name!r} ist unbekannt: eine von {names} wählen.</translation>
  </message>
  <message>
   <source>{RatioRule} {name} does not close on a sphere, where theta leaves no choice of ratio: choose Exact (or Paper for the paper's 1/2).</source>
   <translation>{RatioRule} {name} schließt nicht auf einer Kugel, wo theta das Verhältnis festlegt: Genau wählen (oder Aufsatz für das 1/2 des Aufsatzes).</translation>
  </message>
  <message>
   <source>{RatioShare} is {share:.6g}: it must be at least 0 and below 1; 0.05 to 0.2 is usual, smaller snaps harder.</source>
   <translation>{RatioShare} ist {share:.6g}: es muss mindestens 0 und unter 1 sein; 0.05 bis 0.2 ist üblich, kleiner schnappt härter.</translation>
  </message>
  <message>
   <source>{Ratio}{at} is {value:.6g}: for theta {0:.4g}° it must be at least sin(theta/2) = {1:.6g} and below 1; change {Ratio} or make theta smaller (shorter edge or smaller {Gamma}).</source>
   <translation>{Ratio}{at} ist {value:.6g}: für theta {0:.4g}° muss es mindestens sin(theta/2) = {1:.6g} und unter 1 sein; {Ratio} ändern oder theta verkleinern (kürzere Kante oder kleineres {Gamma}).</translation>
  </message>
  <message>
   <source>{RotationAngle} is {angle:.6g}°: a tube is printed flat-folded, set it to 0°; coupons can be printed partly open.</source>
   <translation>{RotationAngle} ist {angle:.6g}°: ein Schlauch wird flach gefaltet gedruckt, auf 0° einstellen; Probestücke können teilweise geöffnet gedruckt werden.</translation>
  </message>
  <message>
   <source>{RotationAngle} is {rotation_angle:.6g}°: set it between 0° and 180°.</source>
   <translation>{RotationAngle} ist {rotation_angle:.6g}°: zwischen 0° und 180° einstellen.</translation>
  </message>
  <message>
   <source>{RotationAngle} must be 0° for a flexible hinge: it is printed folded.</source>
   <translation>{RotationAngle} muss für ein flexibles Scharnier 0° sein: es wird gefaltet gedruckt.</translation>
  </message>
  <message>
   <source>{RotationAngle} must be 0° for a four-degree vertex: it is printed flat-folded.</source>
   <translation>{RotationAngle} muss für eine Ecke aus vier Platten 0° sein: sie wird flach gefaltet gedruckt.</translation>
  </message>
  <message>
   <source>{Ruling}: along legs through a viewpoint a tube is steered, or closed, only on a sphere about it, and this curve is {low:.4g} to {high:.4g} mm away from it</source>
   <translation>{Ruling}: entlang Schenkeln durch einen Blickpunkt wird ein Schlauch nur auf einer Kugel um ihn gesteuert oder geschlossen, und diese Kurve ist {low:.4g} bis {high:.4g} mm von ihm entfernt</translation>
  </message>
  <message>
   <source>{Ruling}: give ('parallel', direction) or ('point', V) with 3 numbers.</source>
   <translation>{Ruling}: ('parallel', Richtung) oder ('point', V) mit 3 Zahlen angeben.</translation>
  </message>
  <message>
   <source>{Ruling}: seen along the legs the curve overlaps itself: {first} lies in front of {second}; choose another direction or viewpoint for {Ruling}, or move these parts of the curve apart.</source>
   <translation>{Ruling}: entlang der Schenkel gesehen überdeckt die Kurve sich selbst: {first} liegt vor {second}; eine andere Richtung oder einen anderen Blickpunkt für {Ruling} wählen oder diese Teile der Kurve auseinanderrücken.</translation>
  </message>
  <message>
   <source>{Ruling}: the direction or viewpoint must be finite and not zero.</source>
   <translation>{Ruling}: Richtung oder Blickpunkt müssen endlich und nicht null sein.</translation>
  </message>
  <message>
   <source>{Ruling}: the legs run along the curve at its start; choose another direction or viewpoint for {Ruling}.</source>
   <translation>{Ruling}: die Schenkel laufen am Anfang der Kurve entlang der Kurve; eine andere Richtung oder einen anderen Blickpunkt für {Ruling} wählen.</translation>
  </message>
  <message>
   <source>{Ruling}: the legs run along the curve near {place} (at {angle:.3g}°, {least:.3g}° is the least); choose another direction or viewpoint for {Ruling}.</source>
   <translation>{Ruling}: die Schenkel laufen nahe {place} entlang der Kurve (bei {angle:.3g}°, {least:.3g}° ist das Mindeste); eine andere Richtung oder einen anderen Blickpunkt für {Ruling} wählen.</translation>
  </message>
  <message>
   <source>{Ruling}: the viewpoint {viewpoint} lies on the curve, {distance:.3g} mm from {place}; move it away from the curve by more than {least:.4g} mm.</source>
   <translation>{Ruling}: der Blickpunkt {viewpoint} liegt auf der Kurve, {distance:.3g} mm von {place}; ihn um mehr als {least:.4g} mm von der Kurve wegrücken.</translation>
  </message>
  <message>
   <source>{SegmentWidth} is {width:.6g} mm: set it to {least:.3g} mm or more, or to 0 to go by {Segmentations}.</source>
   <translation>{SegmentWidth} ist {width:.6g} mm: auf {least:.3g} mm oder mehr setzen, oder auf 0, um nach {Segmentations} zu gehen.</translation>
  </message>
  <message>
   <source>{Segmentations} is {n}: knuckles alternate, so set it to an odd number, {odd} for example.</source>
   <translation>{Segmentations} ist {n}: die Glieder wechseln sich ab, darum eine ungerade Zahl einstellen, zum Beispiel {odd}.</translation>
  </message>
  <message>
   <source>{Source} {label} falls into {count} separate pieces{where}: link one connected curve, or choose one of its edges.</source>
   <translation>{Source} {label} zerfällt in {count} getrennte Stücke{where}: Verknüpfe eine zusammenhängende Kurve oder wähle eine ihrer Kanten.</translation>
  </message>
  <message>
   <source>{Source} {label} has no edge: link an edge, a wire, a sketch or a Draft curve.</source>
   <translation>{Source} {label} hat keine Kante: eine Kante, einen Draht, eine Skizze oder eine Draft-Kurve verknüpfen.</translation>
  </message>
  <message>
   <source>{Source} {label} has no element {name} any more: choose its edge again.</source>
   <translation>{Source} {label} hat kein Element {name} mehr: die Kante neu wählen.</translation>
  </message>
  <message>
   <source>{Source} {label}: {name} is not an edge; choose an edge or a wire.</source>
   <translation>{Source} {label}: {name} ist keine Kante; eine Kante oder einen Draht wählen.</translation>
  </message>
  <message>
   <source>{SphereRadius} is {radius:.6g} mm: give the sphere a radius above 0 and a finite {SphereCenter}.</source>
   <translation>{SphereRadius} ist {radius:.6g} mm: der Kugel einen Radius über 0 und ein endliches {SphereCenter} geben.</translation>
  </message>
  <message>
   <source>{StandOffSpacing} is {spacing:.4g} mm: a printer spans {most:.4g} mm from rib to rib; set {StandOffSpacing} between {least:.2g} and {most:.4g} mm.</source>
   <translation>{StandOffSpacing} ist {spacing:.4g} mm: ein Drucker überspannt {most:.4g} mm von Rippe zu Rippe; setze {StandOffSpacing} zwischen {least:.2g} und {most:.4g} mm.</translation>
  </message>
  <message>
   <source>{StandOffWidth} is {width:.4g} mm, less than the nozzle: set it to {least:.4g} mm or more, or to 0 for one line.</source>
   <translation>{StandOffWidth} ist {width:.4g} mm, weniger als die Düse: setze es auf {least:.4g} mm oder mehr, oder auf 0 für eine Linie.</translation>
  </message>
  <message>
   <source>{Step} is {step:.4g} mm: set it to 0.01 mm or more, the numbers are hundredths.</source>
   <translation>{Step} ist {step:.4g} mm: 0,01 mm oder mehr wählen, die Zahlen sind Hundertstel.</translation>
  </message>
  <message>
   <source>{Symmetric}: the curve is neither its own mirror image nor turned half round itself, it is off by {value:.3g} mm; the tube is steered without.</source>
   <translation>{Symmetric}: die Kurve ist weder ihr eigenes Spiegelbild noch halb um sich gedreht sie selbst, sie weicht um {value:.3g} mm ab; der Schlauch wird ohne das gelenkt.</translation>
  </message>
  <message>
   <source>{TargetBarrier} is {barrier:.6g}: set it above 0, in EA·‖AB‖; 1e-6 is weak, 1e-4 strong.</source>
   <translation>{TargetBarrier} ist {barrier:.6g}: über 0 einstellen, in EA·‖AB‖; 1e-6 ist schwach, 1e-4 stark.</translation>
  </message>
  <message>
   <source>{Thickness} of {label} is 0 mm, and without thickness there is no snap margin: set it to face thickness + gap between planes, 1.8 mm for example, or aim for a {TargetBarrier}.</source>
   <translation>{Thickness} von {label} ist 0 mm, und ohne Dicke gibt es keine Schnappreserve: auf Plattendicke + Abstand der Ebenen einstellen, zum Beispiel 1.8 mm, oder {TargetBarrier} als Ziel nehmen.</translation>
  </message>
  <message>
   <source>{Thickness}: panels of pitch {pitch:.4g} mm are too thick for the unit of theta {theta:.1f}° and {EdgeLength} {edge_length:.4g} mm; make {Thickness} smaller, {EdgeLength} longer or {Gamma} larger.</source>
   <translation>{Thickness}: Platten mit Ebenenabstand {pitch:.4g} mm sind zu dick für die Einheit mit theta {theta:.1f}° und {EdgeLength} {edge_length:.4g} mm; {Thickness} verkleinern, {EdgeLength} verlängern oder {Gamma} vergrößern.</translation>
  </message>
  <message>
   <source>{Thickness}: the pitch of the panels is {value:.6g} mm; it must be at least 0 and below a quarter of {EdgeLength} ({0:.6g} mm).</source>
   <translation>{Thickness}: der Ebenenabstand der Platten ist {value:.6g} mm; er muss mindestens 0 und kleiner als ein Viertel von {EdgeLength} sein ({0:.6g} mm).</translation>
  </message>
  <message>
   <source>{Tolerance} is {value:.4g} mm: midpoints exactly on the curve leave nothing to steer with, and both ends cannot be met</source>
   <translation>{Tolerance} ist {value:.4g} mm: Mittelpunkte genau auf der Kurve lassen nichts zum Steuern, und beide Enden lassen sich nicht treffen</translation>
  </message>
  <message>
   <source>{Tolerance}: with {value:.3g} mm the tube cannot be steered along the curve near ({at}) mm, {need:.3g} mm would do</source>
   <translation>{Tolerance}: mit {value:.3g} mm lässt sich der Schlauch nahe ({at}) mm nicht an der Kurve entlang steuern, {need:.3g} mm würden reichen</translation>
  </message>
  <message>
   <source>{UnitMargins} has {given} numbers and there are {count} units</source>
   <translation>{UnitMargins} hat {given} Zahlen, und es sind {count} Einheiten</translation>
  </message>
  <message>
   <source>{area:.0f} mm² of {body} at a height of {height:.1f} mm</source>
   <translation>{area:.0f} mm² von {body} in {height:.1f} mm Höhe</translation>
  </message>
  <message>
   <source>{area:.1f} mm² in {places} places begin in mid-air and no tie holds them, the largest {worst:.2f} mm² of {body} at a height of {height:.1f} mm.</source>
   <translation>{area:.1f} mm² an {places} Stellen beginnen in der Luft, und kein Haltesteg hält sie, die größte {worst:.2f} mm² von {body} in einer Höhe von {height:.1f} mm.</translation>
  </message>
  <message>
   <source>{at} has no second stable state: its hinges' misfit rises all the way, to {misfit:.2f} mm; switch {Compensate} on.</source>
   <translation>{at} hat keinen zweiten stabilen Zustand: der Passfehler der Scharniere steigt auf dem ganzen Weg, bis {misfit:.2f} mm; {Compensate} einschalten.</translation>
  </message>
  <message>
   <source>{at} is floppy: a clearance of {needed:.2f} mm in its hinges is enough to open it without strain, and they have {gap:.2f} mm (snap margin {margin:.2f}); make {EdgeLength} larger, {Ratio} nearer to sin(theta/2), the cones steeper, {GapLength} smaller, or use flexible hinges, which have no play.</source>
   <translation>{at} ist schlaff: Ein Spiel von {needed:.2f} mm in ihren Scharnieren genügt, um sie ohne Dehnung zu öffnen, und sie haben {gap:.2f} mm (Schnappreserve {margin:.2f}); {EdgeLength} größer, {Ratio} näher an sin(theta/2), die Kegel steiler oder {GapLength} kleiner machen, oder biegsame Scharniere nehmen, die kein Spiel haben.</translation>
  </message>
  <message>
   <source>{at} strains by {strain:.1%} of ‖AB‖ where it snaps, at hinge {hinge}, and {StrainLimit} is {limit:.1%}: make {Ratio} larger or the panels thinner.</source>
   <translation>{at} dehnt sich beim Schnappen um {strain:.1%} von ‖AB‖, am Scharnier {hinge}, und {StrainLimit} ist {limit:.1%}: {Ratio} größer oder die Platten dünner machen.</translation>
  </message>
  <message>
   <source>{body} starts</source>
   <translation>{body} beginnt</translation>
  </message>
  <message>
   <source>{compared} ({ours} against {theirs})</source>
   <translation>{compared} ({ours} gegen {theirs})</translation>
  </message>
  <message>
   <source>{count} edges of its triangles lack a partner</source>
   <translation>{count} Kanten seiner Dreiecke fehlt ein Gegenstück</translation>
  </message>
  <message>
   <source>{count} exact duplicates are left out</source>
   <translation>{count} genaue Doppelte sind ausgelassen</translation>
  </message>
  <message>
   <source>{count} loose pillars hold what reaches beyond the panels below, in {places} places; {left:.2f} mm² are left. They take {taken:.2f} cm³, {share:.1%} of the plastic, keep a layer of air from everything and fall out when the tube is opened for the first time: open it a little, and shake. {bed} stand on the bed.</source>
   <translation>{count} lose Pfeiler halten an {places} Stellen, was über die Platten darunter hinausragt; {left:.2f} mm² bleiben übrig. Sie brauchen {taken:.2f} cm³, {share:.1%} des Kunststoffs, halten von allem eine Schicht Luft und fallen heraus, wenn die Röhre zum ersten Mal geöffnet wird: etwas öffnen und schütteln. {bed} stehen auf dem Druckbett.</translation>
  </message>
  <message>
   <source>{count} loose pillars, {volume:.1f} cm³, hold what reaches beyond the panels below: they fall out when the tube is opened.</source>
   <translation>{count} lose Pfeiler, {volume:.1f} cm³, halten, was über die Platten darunter hinausragt: sie fallen heraus, wenn die Röhre geöffnet wird.</translation>
  </message>
  <message>
   <source>{count} pieces without length are left out</source>
   <translation>{count} Stücke ohne Länge sind ausgelassen</translation>
  </message>
  <message>
   <source>{count} places are</source>
   <translation>{count} Stellen</translation>
  </message>
  <message>
   <source>{count} places begin in mid-air; {ties} ties hold them, and {area:.2f} mm² are left.</source>
   <translation>{count} Stellen beginnen in der Luft; {ties} Haltestege halten sie, und {area:.2f} mm² bleiben übrig.</translation>
  </message>
  <message>
   <source>{count} places start, {area:.3g} mm² in all</source>
   <translation>{count} Stellen beginnen, zusammen {area:.3g} mm²,</translation>
  </message>
  <message>
   <source>{count} points that were there before are left out</source>
   <translation>{count} Punkte, die es schon gab, sind ausgelassen</translation>
  </message>
  <message>
   <source>{count} ties hold what begins in mid-air in {places} places; {left:.2f} mm² are left. They take {taken:.2f} cm³, {share:.1%} of the plastic. Each comes off at its necks, {neck:g} mm square, by {force:.1f} N at most; a knuckle bears {bears:.0f} N. They are the green ones in the picture: run a blade between the bodies below, from the outside inwards, before the first unit is opened.</source>
   <translation>{count} Stege halten, was an {places} Stellen in der Luft beginnt; {left:.2f} mm² bleiben übrig. Sie brauchen {taken:.2f} cm³, {share:.1%} des Kunststoffs. Jeder löst sich an seinen Hälsen, {neck:g} mm im Quadrat, mit höchstens {force:.1f} N; ein Gelenkglied trägt {bears:.0f} N. Im Bild sind es die grünen: führe eine Klinge zwischen den Körpern unten hindurch, von außen nach innen, bevor die erste Einheit geöffnet wird.</translation>
  </message>
  <message>
   <source>{count} tubes are chosen to cut: choose one.</source>
   <translation>{count} Schläuche sind zum Zuschneiden gewählt: einen wählen.</translation>
  </message>
  <message>
   <source>{count} units along {length:.4g} mm of curve</source>
   <translation>{count} Einheiten entlang von {length:.4g} mm Kurve</translation>
  </message>
  <message>
   <source>{distance:.3f} mm</source>
   <translation>{distance:.3f} mm</translation>
  </message>
  <message>
   <source>{distance:.3f} mm apart</source>
   <translation>{distance:.3f} mm voneinander entfernt</translation>
  </message>
  <message>
   <source>{each}: margin {least:.2f} or more.</source>
   <translation>{each}: Reserve {least:.2f} oder mehr.</translation>
  </message>
  <message>
   <source>{file} was drawn by Inkscape {version}, whose pixel is 1/90 inch, and gives no size in mm: read as today, at 96 px an inch, it would be 6 % too small</source>
   <translation>{file} wurde mit Inkscape {version} gezeichnet, dessen Pixel 1/90 Zoll ist, und gibt keine Größe in mm: Wie heute mit 96 px je Zoll gelesen, wäre sie 6 % zu klein</translation>
  </message>
  <message>
   <source>{file}: its {name} is {given} of a window, which has no size in mm</source>
   <translation>{file}: {name} ist {given} eines Fensters, das keine Größe in mm hat</translation>
  </message>
  <message>
   <source>{file}: the block {name} holds itself</source>
   <translation>{file}: Der Block {name} enthält sich selbst</translation>
  </message>
  <message>
   <source>{file}: the clone of {name} holds itself</source>
   <translation>{file}: Der Klon von {name} enthält sich selbst</translation>
  </message>
  <message>
   <source>{file}: the viewBox “{given}” is not x, y, and a width and a height above 0</source>
   <translation>{file}: Die viewBox „{given}“ ist nicht x, y und Breite und Höhe über 0</translation>
  </message>
  <message>
   <source>{height} (too large)</source>
   <translation>{height} (zu groß)</translation>
  </message>
  <message>
   <source>{label} cannot be {state}: export it without a state.</source>
   <translation>{label} kann nicht {state} sein: ohne Zustand exportieren.</translation>
  </message>
  <message>
   <source>{label} has faces but no solid, and OpenSCAD is for solids: choose a HingeSet or a HingeCoupon.</source>
   <translation>{label} hat Flächen, aber keinen Körper, und OpenSCAD ist für Körper: ein HingeSet oder einen HingeCoupon wählen.</translation>
  </message>
  <message>
   <source>{label} has flexible hinges, and MJCF has hinges that turn</source>
   <translation>{label} hat biegsame Scharniere, und MJCF hat Scharniere, die sich drehen</translation>
  </message>
  <message>
   <source>{label} has no faces to export: choose a unit, a tube or a solid.</source>
   <translation>{label} hat keine Flächen zum Exportieren: eine Einheit, einen Schlauch oder einen Körper wählen.</translation>
  </message>
  <message>
   <source>{label} has no panels of zero thickness to write: choose a BistableUnit, or a HingeSet on one.</source>
   <translation>{label} hat keine Flächen ohne Dicke zum Schreiben: eine BistableUnit wählen, oder ein HingeSet darauf.</translation>
  </message>
  <message>
   <source>{label} has no shape to export: choose a unit, a tube or a solid.</source>
   <translation>{label} hat keine Form zum Exportieren: eine Einheit, einen Schlauch oder einen Körper wählen.</translation>
  </message>
  <message>
   <source>{label} is another one when it is computed again</source>
   <translation>{label} ist ein anderes, wenn es neu berechnet wird</translation>
  </message>
  <message>
   <source>{label} is invalid, correct it first: {refused}</source>
   <translation>{label} ist ungültig, zuerst berichtigen: {refused}</translation>
  </message>
  <message>
   <source>{label} is no tube: choose a BistableUnit, a HingeSet or a HingeCoupon.</source>
   <translation>{label} ist kein Schlauch: eine BistableUnit, ein HingeSet oder einen HingeCoupon wählen.</translation>
  </message>
  <message>
   <source>{label} is not computed yet</source>
   <translation>{label} ist noch nicht berechnet</translation>
  </message>
  <message>
   <source>{label} was saved by a newer version of the workbench: what is new there is kept, but not heeded here.</source>
   <translation>{label} wurde mit einer neueren Version des Arbeitsbereichs gespeichert: Was dort neu ist, bleibt erhalten, wird hier aber nicht beachtet.</translation>
  </message>
  <message>
   <source>{least:.3g} mm asked for</source>
   <translation>verlangten {least:.3g} mm</translation>
  </message>
  <message>
   <source>{least:.3g} mm that a slicer keeps open</source>
   <translation>{least:.3g} mm, die ein Slicer offen hält</translation>
  </message>
  <message>
   <source>{link} of {label} is gone: it was deleted, or not copied along</source>
   <translation>{link} von {label} ist weg: Es wurde gelöscht oder nicht mitkopiert</translation>
  </message>
  <message>
   <source>{link}: {target} is in the document {other}, and links do not leave a document</source>
   <translation>{link}: {target} ist im Dokument {other}, und Verknüpfungen verlassen kein Dokument</translation>
  </message>
  <message>
   <source>{low:.4g} or {high:.4g}</source>
   <translation>{low:.4g} oder {high:.4g}</translation>
  </message>
  <message>
   <source>{margin:.2f} floppy</source>
   <translation>{margin:.2f} schlaff</translation>
  </message>
  <message>
   <source>{name} (too large)</source>
   <translation>{name} (zu groß)</translation>
  </message>
  <message>
   <source>{name} blows up when its entities are expanded, as files do that are made to do harm</source>
   <translation>{name} bläht sich beim Auflösen der Entities auf, wie Dateien, die Schaden anrichten sollen</translation>
  </message>
  <message>
   <source>{name} cannot be read ({error})</source>
   <translation>{name} lässt sich nicht lesen ({error})</translation>
  </message>
  <message>
   <source>{name} draws more than {most} entities</source>
   <translation>{name} zeichnet mehr als {most} Elemente</translation>
  </message>
  <message>
   <source>{name} draws more than {most} objects</source>
   <translation>{name} zeichnet mehr als {most} Objekte</translation>
  </message>
  <message>
   <source>{name} draws more than {most} shapes</source>
   <translation>{name} zeichnet mehr als {most} Formen</translation>
  </message>
  <message>
   <source>{name} has a block that holds itself</source>
   <translation>{name} hat einen Block, der sich selbst enthält</translation>
  </message>
  <message>
   <source>{name} has a broken {kind} (handle {handle})</source>
   <translation>{name} hat ein kaputtes {kind} (Handle {handle})</translation>
  </message>
  <message>
   <source>{name} has a {kind} whose numbers are not finite (handle {handle})</source>
   <translation>{name} hat ein {kind}, dessen Zahlen nicht endlich sind (Handle {handle})</translation>
  </message>
  <message>
   <source>{name} has groups in groups, more than {most} deep</source>
   <translation>{name} hat Gruppen in Gruppen, mehr als {most} tief</translation>
  </message>
  <message>
   <source>{name} has more than {most} pieces of curves</source>
   <translation>{name} hat mehr als {most} Kurvenstücke</translation>
  </message>
  <message>
   <source>{name} has no curve on a layer {layer}</source>
   <translation>{name} hat keine Kurve auf einer Ebene {layer}</translation>
  </message>
  <message>
   <source>{name} has no curve {number}: it holds {count} ({lengths} mm long)</source>
   <translation>{name} hat keine Kurve {number}: sie enthält {count} ({lengths} mm lang)</translation>
  </message>
  <message>
   <source>{name} has no edge that can be read</source>
   <translation>{name} hat keine lesbare Kante</translation>
  </message>
  <message>
   <source>{name} has no unit {number}: choose 1 to {count}.</source>
   <translation>{name} hat keine Einheit {number}: 1 bis {count} wählen.</translation>
  </message>
  <message>
   <source>{name} has {count} different points</source>
   <translation>{name} hat {count} verschiedene Punkte</translation>
  </message>
  <message>
   <source>{name} has {count} points, more than {most}</source>
   <translation>{name} hat {count} Punkte, mehr als {most}</translation>
  </message>
  <message>
   <source>{name} has {what}</source>
   <translation>{name} hat {what}</translation>
  </message>
  <message>
   <source>{name} has {what}: name the file with one of {suffixes}.</source>
   <translation>{name} hat {what}: der Datei eine der Endungen {suffixes} geben.</translation>
  </message>
  <message>
   <source>{name} holds no line or curve{rest}</source>
   <translation>{name} enthält keine Linie oder Kurve{rest}</translation>
  </message>
  <message>
   <source>{name} holds {count} separate curves ({lengths} mm long){gap}</source>
   <translation>{name} enthält {count} getrennte Kurven ({lengths} mm lang){gap}</translation>
  </message>
  <message>
   <source>{name} holds {count} units: say which, 1 to {count}.</source>
   <translation>{name} enthält {count} Einheiten: angeben, welche, 1 bis {count}.</translation>
  </message>
  <message>
   <source>{name} is empty: {hint}.</source>
   <translation>{name} ist leer: {hint}.</translation>
  </message>
  <message>
   <source>{name} is no name of a report: let it end in .html.</source>
   <translation>{name} ist kein Name für einen Bericht: auf .html enden lassen.</translation>
  </message>
  <message>
   <source>{name} is not a FOLD file: choose a file that is.</source>
   <translation>{name} ist keine FOLD-Datei: eine wählen, die es ist.</translation>
  </message>
  <message>
   <source>{name} is not a closed solid, which 3MF needs: choose the hinged solids, or export to STL, OBJ or STEP.</source>
   <translation>{name} ist kein geschlossener Körper, den 3MF braucht: die Körper mit Scharnieren wählen oder nach STL, OBJ oder STEP exportieren.</translation>
  </message>
  <message>
   <source>{name} is not a text file</source>
   <translation>{name} ist keine Textdatei</translation>
  </message>
  <message>
   <source>{name} is not a text file in the encoding that it names, {encoding}</source>
   <translation>{name} ist keine Textdatei in der Kodierung, die sie nennt, {encoding}</translation>
  </message>
  <message>
   <source>{name} is not a whole DXF file</source>
   <translation>{name} ist keine vollständige DXF-Datei</translation>
  </message>
  <message>
   <source>{name} is not a whole FOLD file ({error}): save it again.</source>
   <translation>{name} ist keine ganze FOLD-Datei ({error}): neu speichern.</translation>
  </message>
  <message>
   <source>{name} is not a whole Rhino file</source>
   <translation>{name} ist keine vollständige Rhino-Datei</translation>
  </message>
  <message>
   <source>{name} is not a whole SVG file ({error})</source>
   <translation>{name} ist keine vollständige SVG-Datei ({error})</translation>
  </message>
  <message>
   <source>{name} is not an SVG file</source>
   <translation>{name} ist keine SVG-Datei</translation>
  </message>
  <message>
   <source>{name} is unknown: choose one of {names}.</source>
   <translation>{name} ist unbekannt: eines von {names} wählen.</translation>
  </message>
  <message>
   <source>{name} is {gap:.4g} mm, and {process} keeps no gap below {least:.4g} mm open: set {name} to {least:.4g} mm or more, or choose another {Process}.</source>
   <translation>{name} ist {gap:.4g} mm, und {process} hält keinen Spalt unter {least:.4g} mm offen: setze {name} auf {least:.4g} mm oder mehr, oder wähle ein anderes {Process}.</translation>
  </message>
  <message>
   <source>{name} is {value:.3g}</source>
   <translation>{name} ist {value:.3g}</translation>
  </message>
  <message>
   <source>{name} is {value:.6g} mm: set it to a length above 0.</source>
   <translation>{name} ist {value:.6g} mm: eine Länge über 0 einstellen.</translation>
  </message>
  <message>
   <source>{name} is {value:.6g}: set it to a number above 0.</source>
   <translation>{name} ist {value:.6g}: eine Zahl über 0 einstellen.</translation>
  </message>
  <message>
   <source>{name} is {value:.6g}: {why}.</source>
   <translation>{name} ist {value:.6g}: {why}.</translation>
  </message>
  <message>
   <source>{name} is {value}</source>
   <translation>{name} ist {value}</translation>
  </message>
  <message>
   <source>{name} links to {label} ({found}): {hint}.</source>
   <translation>{name} verweist auf {label} ({found}): {hint}.</translation>
  </message>
  <message>
   <source>{name} needs the Python package ezdxf, which is not installed</source>
   <translation>{name} braucht das Python-Paket ezdxf, das nicht installiert ist</translation>
  </message>
  <message>
   <source>{name} needs the Python package rhino3dm, which is not installed</source>
   <translation>{name} braucht das Python-Paket rhino3dm, das nicht installiert ist</translation>
  </message>
  <message>
   <source>{name} of {material} is {value:.6g}{measure}</source>
   <translation>{name} von {material} ist {value:.6g}{measure}</translation>
  </message>
  <message>
   <source>{name} unpacks to more than {size} MB</source>
   <translation>{name} wird entpackt größer als {size} MB</translation>
  </message>
  <message>
   <source>{name} was made by {creator}: only FOLD files exported by Bistable Workbench hold the units that can be read back.</source>
   <translation>{name} stammt von {creator}: nur FOLD-Dateien aus diesem Arbeitsbereich enthalten die Einheiten, die sich zurücklesen lassen.</translation>
  </message>
  <message>
   <source>{name} was not written to {folder} ({reason})</source>
   <translation>{name} wurde nicht nach {folder} geschrieben ({reason})</translation>
  </message>
  <message>
   <source>{name} {value!r} is unknown</source>
   <translation>{name} {value!r} ist unbekannt</translation>
  </message>
  <message>
   <source>{name} {value!r} is unknown: choose one of {known}.</source>
   <translation>{name} {value!r} ist unbekannt: eines von {known} wählen.</translation>
  </message>
  <message>
   <source>{name} {value:.4g} mm is not a multiple of the layer height {layer:.4g} mm, so panels slice to different thicknesses: use {nearest} mm.</source>
   <translation>{name} {value:.4g} mm ist kein Vielfaches der Schichthöhe {layer:.4g} mm, darum werden die Platten verschieden dick geslict: {nearest} mm verwenden.</translation>
  </message>
  <message>
   <source>{name}, line {line} is longer than {most} characters: it is no table of points</source>
   <translation>{name}, Zeile {line} ist länger als {most} Zeichen: Das ist keine Punkttabelle</translation>
  </message>
  <message>
   <source>{name}, line {line}: the point lies {away:.3g} mm from the others, which is not a coordinate in mm</source>
   <translation>{name}, Zeile {line}: Der Punkt liegt {away:.3g} mm von den anderen, das ist keine Koordinate in mm</translation>
  </message>
  <message>
   <source>{name}, line {line}: {cell} is not a coordinate in mm</source>
   <translation>{name}, Zeile {line}: {cell} ist keine Koordinate in mm</translation>
  </message>
  <message>
   <source>{name}, line {line}: {count} columns</source>
   <translation>{name}, Zeile {line}: {count} Spalten</translation>
  </message>
  <message>
   <source>{name}: unit {number} has lengths that no unit has: export it again.</source>
   <translation>{name}: Einheit {number} hat Längen, die keine Einheit hat: exportiere sie neu.</translation>
  </message>
  <message>
   <source>{name}: unit {number} has no ten corners in space: export it again.</source>
   <translation>{name}: Einheit {number} hat keine zehn Ecken im Raum: neu exportieren.</translation>
  </message>
  <message>
   <source>{name}: unit {number} in {key} is broken ({error}): export the file again.</source>
   <translation>{name}: Einheit {number} in {key} ist beschädigt ({error}): die Datei neu exportieren.</translation>
  </message>
  <message>
   <source>{name}: unit {number} is not the symmetric unit of its angles (it is one of a general curve, or the file was changed): only plane and spherical units can be read back.</source>
   <translation>{name}: Einheit {number} ist nicht die symmetrische Einheit ihrer Winkel (sie gehört zu einer allgemeinen Kurve, oder die Datei wurde geändert): nur ebene und sphärische Einheiten lassen sich zurücklesen.</translation>
  </message>
  <message>
   <source>{one} and {other} are {state} in the flat print, less than the {least}, and would fuse.</source>
   <translation>{one} und {other}: im flachen Druck {state}, weniger als die {least}, und würden verschmelzen.</translation>
  </message>
  <message>
   <source>{one} and {other} run {depth:.3f} mm into each other when opened to {opening:.0%}, {asked}.</source>
   <translation>{one} und {other} dringen {depth:.3f} mm ineinander, bei Öffnung {opening:.0%}, {asked}.</translation>
  </message>
  <message>
   <source>{one} and {other} stay fused: {what} ({count} such ties).</source>
   <translation>{one} und {other} bleiben verschmolzen: {what} ({count} solche Haltestege).</translation>
  </message>
  <message>
   <source>{one} and {other} touch by {area:.2f} mm² on the toolpaths{others}, more than {limit:g} mm², and {state}.</source>
   <translation>{one} und {other} berühren sich auf den Werkzeugwegen mit {area:.2f} mm²{others}, mehr als {limit:g} mm², und {state}.</translation>
  </message>
  <message>
   <source>{path} has no lines or no printing time as PrusaSlicer writes them: slice with it.</source>
   <translation>{path} hat keine Linien oder keine Druckzeit, wie PrusaSlicer sie schreibt: damit slicen.</translation>
  </message>
  <message>
   <source>{path} is a folder: add a file name to it.</source>
   <translation>{path} ist ein Ordner: einen Dateinamen anhängen.</translation>
  </message>
  <message>
   <source>{preset}: the paper's table does not settle {name}; the value that was set stays.</source>
   <translation>{preset}: die Tabelle des Aufsatzes legt {name} nicht fest; der eingestellte Wert bleibt.</translation>
  </message>
  <message>
   <source>{process} (best)</source>
   <translation>{process} (am besten)</translation>
  </message>
  <message>
   <source>{said} (Also unit {units}.)</source>
   <translation>{said} (Auch Einheit {units}.)</translation>
  </message>
  <message>
   <source>{said} (Also units {units}.)</source>
   <translation>{said} (Auch Einheiten {units}.)</translation>
  </message>
  <message>
   <source>{several} and {last}</source>
   <translation>{several} und {last}</translation>
  </message>
  <message>
   <source>{stray:.0%} of the sliced lines lie in none of the bodies: slice the print that the bodies are of, without moving it on the bed.</source>
   <translation>{stray:.0%} der geslicten Linien liegen in keinem der Körper: den Druck slicen, zu dem die Körper gehören, ohne ihn auf dem Bett zu verschieben.</translation>
  </message>
  <message>
   <source>{suffix} export has no option {name!r}: {offers}.</source>
   <translation>Der Export nach {suffix} hat keine Option {name!r}: {offers}.</translation>
  </message>
  <message>
   <source>{target} is itself made of {label}, which therefore cannot follow it</source>
   <translation>{target} ist selbst aus {label} gemacht, das ihm deshalb nicht folgen kann</translation>
  </message>
  <message>
   <source>{total} are laid over air, all in strips narrower than the {span:g} mm that a printer spans; the largest are {most}.</source>
   <translation>{total} liegen über Luft, alle in Streifen schmaler als die {span:g} mm, die ein Drucker überbrückt; die größten sind {most}.</translation>
  </message>
  <message>
   <source>{total} are laid over air, where {many} wider than the {span:g} mm that a printer spans, the largest {most}.</source>
   <translation>{total} liegen über Luft, davon {many} breiter als die {span:g} mm, die ein Drucker überbrückt, am größten {most}.</translation>
  </message>
  <message>
   <source>{type_name!r} is not a type of the Bistable workbench.</source>
   <translation>{type_name!r} ist kein Typ des Arbeitsbereichs Bistable.</translation>
  </message>
  <message>
   <source>{units} cannot reach the energy barrier: {worst:.2g} instead of {wanted:.2g} EA·‖AB‖; make {Gamma} larger: wider units snap harder.</source>
   <translation>{units}: die Energieschwelle wird nicht erreicht, {worst:.2g} statt {wanted:.2g} EA·‖AB‖; {Gamma} vergrößern: weitere Einheiten schnappen härter.</translation>
  </message>
  <message>
   <source>{units} cannot reach the snap margin: {worst:.2f} instead of {wanted:.2f}{floppy}; {why}. Make {EdgeLength} about {longer:.3g} mm, {Gamma} larger (wider units snap harder), or the play of the hinges {less:.2g} mm (steeper cones, smaller {GapLength}).</source>
   <translation>{units}: die Schnappreserve wird nicht erreicht, {worst:.2f} statt {wanted:.2f}{floppy}; {why}. {EdgeLength} auf etwa {longer:.3g} mm einstellen, {Gamma} vergrößern (weitere Einheiten schnappen härter) oder das Spiel der Scharniere auf {less:.2g} mm verkleinern (steilere Kegel, kleinere {GapLength}).</translation>
  </message>
  <message>
   <source>{units} cannot reach what is aimed at: unit {worst} gets {share:.0%} of it{stuck}</source>
   <translation>{units} können nicht erreichen, worauf gezielt wird: Einheit {worst} kommt auf {share:.0%} davon{stuck}</translation>
  </message>
  <message>
   <source>{units} {are} floppy: hinges with a play of {play:.2g} mm swallow the snap (snap margin about {margin:.2g}, below 1); {ratios}make {EdgeLength} or {Gamma} larger.</source>
   <translation>{units} {are} schlaff: Scharniere mit einem Spiel von {play:.2g} mm schlucken das Schnappen (Schnappreserve etwa {margin:.2g}, unter 1); {ratios}{EdgeLength} oder {Gamma} vergrößern.</translation>
  </message>
  <message>
   <source>{units}{of} {are} floppy, {trouble}, and nothing but friction holds the deployed state.</source>
   <translation>{units}{of} {are} schlaff, {trouble}, und nur Reibung hält den entfalteten Zustand.</translation>
  </message>
  <message>
   <source>{variable} is {wanted!r}, which is no program: set it to the path of PrusaSlicer.</source>
   <translation>{variable} ist {wanted!r}, und das ist kein Programm: den Pfad von PrusaSlicer angeben.</translation>
  </message>
  <message>
   <source>{what} in mid-air{first}, {lowest:.1f} mm above the bed and more than {bridge:g} mm above anything else.</source>
   <translation>{what} mitten in der Luft{first}, {lowest:.1f} mm über dem Bett und mehr als {bridge:g} mm über allem anderen.</translation>
  </message>
  <message>
   <source>{what} is {value:.6g} mm: set it from {least:g} to 1000.</source>
   <translation>{what} ist {value:.6g} mm: auf {least:g} bis 1000 setzen.</translation>
  </message>
  <message>
   <source>{what} is “{text}”, which is no finite length</source>
   <translation>{what} ist „{text}“, was keine endliche Länge ist</translation>
  </message>
  <message>
   <source>{what} is “{text}”, which is no length</source>
   <translation>{what} ist „{text}“, was keine Länge ist</translation>
  </message>
  <message>
   <source>{what} needs FreeCAD: install it, and run python3 -m BistableWB {name}</source>
   <translation>{what} braucht FreeCAD: es installieren und python3 -m BistableWB {name} ausführen</translation>
  </message>
  <message>
   <source>{what}; set {size}, or make {FaceThickness} or {GapLength} smaller.</source>
   <translation>{what}; {size} einstellen, oder {FaceThickness} oder {GapLength} verkleinern.</translation>
  </message>
  <message>
   <source>{where} has a column {cell} in a unit that is not known</source>
   <translation>{where} hat eine Spalte {cell} in einer unbekannten Einheit</translation>
  </message>
  <message>
   <source>{where} has angles or pixels ({word}), not lengths</source>
   <translation>{where} hat Winkel oder Pixel ({word}), keine Längen</translation>
  </message>
  <message>
   <source>{where} has points and commas in its numbers, as {one} and {other}</source>
   <translation>{where} hat Punkte und Kommas in den Zahlen, wie {one} und {other}</translation>
  </message>
  <message>
   <source>{where} has rows in several units, or in one that is not known</source>
   <translation>{where} hat Zeilen in mehreren Einheiten, oder in einer unbekannten</translation>
  </message>
  <message>
   <source>{where} has two columns for one axis, {one} and {other}</source>
   <translation>{where} hat zwei Spalten für eine Achse, {one} und {other}</translation>
  </message>
  <message>
   <source>{where}: {cell} may be {large} or {small}</source>
   <translation>{where}: {cell} kann {large} oder {small} sein</translation>
  </message>
 </context>
 <context>
  <name>Bistable_AutoFit</name>
  <message>
   <source>Auto-fit</source>
   <translation>Automatisch anpassen</translation>
  </message>
  <message>
   <source>Propose edge length, gamma and ratio rule for a curve, so that its tube fits the printer and snaps</source>
   <translation>Kantenlänge, Gamma und Verhältnisregel für eine Kurve vorschlagen, sodass ihr Schlauch in den Drucker passt und schnappt</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Calibration</name>
  <message>
   <source>Calibration plate</source>
   <translation>Kalibrierplatte</translation>
  </message>
  <message>
   <source>Make one small print that tells which clearance your printer keeps open. When it is printed, edit the plate and say which hinges turn: new hinges and checks follow</source>
   <translation>Einen kleinen Druck machen, der zeigt, welches Spiel dein Drucker offen hält. Wenn er gedruckt ist, die Platte bearbeiten und sagen, welche Scharniere sich drehen: neue Scharniere und Prüfungen richten sich danach</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Check</name>
  <message>
   <source>Check print</source>
   <translation>Druck prüfen</translation>
  </message>
  <message>
   <source>Check the selected hinge set or coupon: size, snap, closed solids, clearances, walls, layers, overhangs, overlaps</source>
   <translation>Den gewählten Scharniersatz oder das Probestück prüfen: Größe, Schnappen, geschlossene Körper, Abstände, Wände, Schichten, Überhänge, Durchdringungen</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Curve</name>
  <message>
   <source>Curve</source>
   <translation>Kurve</translation>
  </message>
  <message>
   <source>Make a curve for a tube: along the selected sketch, wire or edges, else by example points</source>
   <translation>Eine Kurve für einen Schlauch erstellen: entlang der gewählten Skizze, des Drahts oder der Kanten, sonst mit Beispielpunkten</translation>
  </message>
 </context>
 <context>
  <name>Bistable_CurveOnSphere</name>
  <message>
   <source>Curve on sphere</source>
   <translation>Kurve auf Kugel</translation>
  </message>
  <message>
   <source>Make a curve on a sphere: the selected edges projected onto the selected sphere, else an example</source>
   <translation>Eine Kurve auf einer Kugel erstellen: die gewählten Kanten auf die gewählte Kugel projiziert, sonst ein Beispiel</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Deploy</name>
  <message>
   <source>Deploy</source>
   <translation>Entfalten</translation>
  </message>
  <message>
   <source>Open and fold the selected tube in the 3D view: slide, play, record; panels or thick bodies</source>
   <translation>Den gewählten Schlauch in der 3D-Ansicht öffnen und falten: schieben, abspielen, aufnehmen; Flächen oder dicke Körper</translation>
  </message>
 </context>
 <context>
  <name>Bistable_DrawCurve</name>
  <message>
   <source>Click the control points of a curve into the 3D view and drag them; the zigzag of the tube follows</source>
   <translation>Die Kontrollpunkte einer Kurve in die 3D-Ansicht klicken und ziehen; der Zickzack des Schlauchs folgt</translation>
  </message>
  <message>
   <source>Draw curve</source>
   <translation>Kurve zeichnen</translation>
  </message>
 </context>
 <context>
  <name>Bistable_ExportPrint</name>
  <message>
   <source>Export print</source>
   <translation>Druck exportieren</translation>
  </message>
  <message>
   <source>Write the flat-folded print to a file for the slicer (3MF, STL, STEP) or as a crease pattern (FOLD, SVG, DXF)</source>
   <translation>Den flach gefalteten Druck in eine Datei für den Slicer (3MF, STL, STEP) oder als Faltmuster (FOLD, SVG, DXF) schreiben</translation>
  </message>
  <message>
   <source>deployed</source>
   <translation>entfaltet</translation>
  </message>
  <message>
   <source>flat</source>
   <translation>flach</translation>
  </message>
  <message>
   <source>{} was written to {} ({} kB).</source>
   <translation>{} wurde nach {} geschrieben ({} kB).</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Help</name>
  <message>
   <source>Bistable help</source>
   <translation>Hilfe zu Bistable</translation>
  </message>
  <message>
   <source>Bistable workbench: help</source>
   <translation>Arbeitsbereich Bistable: Hilfe</translation>
  </message>
  <message>
   <source>Show how to get from a curve to a printed tube</source>
   <translation>Zeigen, wie aus einer Kurve ein gedruckter Schlauch wird</translation>
  </message>
  <message>
   <source>index.md</source>
   <translation>de/index.md</translation>
  </message>
 </context>
 <context>
  <name>Bistable_HingeCoupon</name>
  <message>
   <source>Hinge coupon</source>
   <translation>Scharnier-Probestück</translation>
  </message>
  <message>
   <source>Make a small test print of one hinge: try it on your printer before printing a tube</source>
   <translation>Einen kleinen Probedruck eines Scharniers erstellen: vor dem Schlauch auf dem eigenen Drucker ausprobieren</translation>
  </message>
 </context>
 <context>
  <name>Bistable_HingeSet</name>
  <message>
   <source>Hinge set</source>
   <translation>Scharniersatz</translation>
  </message>
  <message>
   <source>Turn the selected bistable units into thick panels with print-in-place hinges, flat-folded as they are printed</source>
   <translation>Aus den gewählten bistabilen Einheiten dicke Platten mit fertig gedruckten Scharnieren machen, flach gefaltet wie im Druck</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Import</name>
  <message>
   <source>Curves and units ({})</source>
   <translation>Kurven und Einheiten ({})</translation>
  </message>
  <message>
   <source>Import curve</source>
   <translation>Kurve importieren</translation>
  </message>
  <message>
   <source>Import units</source>
   <translation>Einheiten importieren</translation>
  </message>
  <message>
   <source>Make a curve from a drawing (SVG, DXF), a model (Rhino, STEP, IGES) or a table of points (CSV), or units from a FOLD file of this workbench</source>
   <translation>Eine Kurve aus einer Zeichnung (SVG, DXF), einem Modell (Rhino, STEP, IGES) oder einer Punkttabelle (CSV) machen, oder Einheiten aus einer FOLD-Datei dieses Arbeitsbereichs</translation>
  </message>
  <message>
   <source>{}: close the panel that is open, then import it.</source>
   <translation>{}: Schließe das offene Fenster und importiere dann.</translation>
  </message>
 </context>
 <context>
  <name>Bistable_MakePrintable</name>
  <message>
   <source>Make it printable</source>
   <translation>Druckbar machen</translation>
  </message>
  <message>
   <source>Search edge length, angles, hinges and parts for the selected curve, sketch or edges, so that the tube prints on your printer, snaps and ends where the curve does; shows what it changes and why</source>
   <translation>Sucht Kantenlänge, Winkel, Scharniere und Teile für die gewählte Kurve, Skizze oder Kanten, so dass der Schlauch auf deinem Drucker druckt, schnappt und endet, wo die Kurve endet; zeigt, was sich ändert und warum</translation>
  </message>
 </context>
 <context>
  <name>Bistable_NewTube</name>
  <message>
   <source>Make an example curve with triangles and bistable units along it, ready to be changed</source>
   <translation>Eine Beispielkurve mit Dreiecken und bistabilen Einheiten erstellen, bereit zum Ändern</translation>
  </message>
  <message>
   <source>New tube</source>
   <translation>Neuer Schlauch</translation>
  </message>
 </context>
 <context>
  <name>Bistable_OpenExample</name>
  <message>
   <source>Make one of the example tubes in a document of its own</source>
   <translation>Einen der Beispielschläuche in einem eigenen Dokument erstellen</translation>
  </message>
  <message>
   <source>Open example</source>
   <translation>Beispiel öffnen</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Plots</name>
  <message>
   <source>Show opening angles, ratios, snap margins and energies of all units; click a bar to see its unit</source>
   <translation>Öffnungswinkel, Verhältnisse, Schnappreserven und Energien aller Einheiten zeigen; ein Klick auf einen Balken zeigt seine Einheit</translation>
  </message>
  <message>
   <source>Tube charts</source>
   <translation>Schlauch-Diagramme</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Repair</name>
  <message>
   <source>Make objects of this workbench work again after the file was saved without it</source>
   <translation>Objekte dieses Arbeitsbereichs wiederherstellen, nachdem die Datei ohne ihn gespeichert wurde</translation>
  </message>
  <message>
   <source>Nothing to repair: all objects are whole.</source>
   <translation>Nichts zu reparieren: alle Objekte sind heil.</translation>
  </message>
  <message>
   <source>Repair objects</source>
   <translation>Objekte reparieren</translation>
  </message>
  <message>
   <source>Repaired: {}</source>
   <translation>Repariert: {}</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Report</name>
  <message>
   <source>No browser could be started: open {} yourself.</source>
   <translation>Kein Browser ließ sich starten: {} bitte selbst öffnen.</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Bericht</translation>
  </message>
  <message>
   <source>Write a report on the selected print or tube, one HTML file with pictures, numbers, checks and how to make it again, and open it in the browser</source>
   <translation>Einen Bericht über den gewählten Druck oder Schlauch schreiben, eine HTML-Datei mit Bildern, Zahlen, Prüfungen und wie man ihn wieder macht, und im Browser öffnen</translation>
  </message>
  <message>
   <source>with the slicer's comparison (minutes)</source>
   <translation>mit dem Vergleich des Slicers (Minuten)</translation>
  </message>
 </context>
 <context>
  <name>Bistable_TrianglePlacement</name>
  <message>
   <source>Place triangles along the selected curve, sketch, wire or edges: their angles are those of the units</source>
   <translation>Dreiecke entlang der gewählten Kurve, Skizze, des Drahts oder der Kanten platzieren: ihre Winkel sind die der Einheiten</translation>
  </message>
  <message>
   <source>Triangle placement</source>
   <translation>Dreiecke platzieren</translation>
  </message>
 </context>
 <context>
  <name>Bistable_Units</name>
  <message>
   <source>Bistable units</source>
   <translation>Bistabile Einheiten</translation>
  </message>
  <message>
   <source>Make the bistable units of the selected triangle placement (or curve); where there is none, one unit by itself</source>
   <translation>Die bistabilen Einheiten der gewählten Dreiecke (oder Kurve) erstellen; wo es keine gibt, eine einzelne Einheit</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>&amp;Bistable</source>
   <translation>&amp;Bistable</translation>
  </message>
  <message>
   <source>Bistable design</source>
   <translation>Bistable: Entwurf</translation>
  </message>
  <message>
   <source>Bistable print</source>
   <translation>Bistable: Druck</translation>
  </message>
 </context>
</TS>
