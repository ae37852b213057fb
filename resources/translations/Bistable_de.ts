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
   <source>Largest strain where it snaps</source>
   <translation>Größte Dehnung beim Umschnappen</translation>
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
   <source>strain</source>
   <translation>Dehnung</translation>
  </message>
  <message>
   <source>{n} units, θ {low:.0f}° … {high:.0f}°, ratio rule {rule}: snap margin {margin:.2f} or more (weakest: unit {weakest}), strain {strain:.1%} at most; print {size} mm; at most {off:.1f} mm off the curve, {covered:.0%} of it followed.</source>
   <translation>{n} Einheiten, θ {low:.0f}° … {high:.0f}°, Verhältnisregel {rule}: Schnappreserve mindestens {margin:.2f} (am schwächsten: Einheit {weakest}), Dehnung höchstens {strain:.1%}; Druck {size} mm; höchstens {off:.1f} mm neben der Kurve, der sie zu {covered:.0%} folgen.</translation>
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
   <source>Errors: {}. Correct them first.</source>
   <translation>Fehler: {}. Zuerst beheben.</translation>
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
   <source>Folder for the pictures</source>
   <translation>Ordner für die Bilder</translation>
  </message>
  <message>
   <source>Loop</source>
   <translation>Wiederholen</translation>
  </message>
  <message>
   <source>Picture {} of {}</source>
   <translation>Bild {} von {}</translation>
  </message>
  <message>
   <source>Pictures</source>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>Pictures and GIF</source>
   <translation>Bilder und GIF</translation>
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
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>The film is {}.</source>
   <translation>Der Film ist {}.</translation>
  </message>
  <message>
   <source>There is no folder {}: choose another one.</source>
   <translation>Es gibt keinen Ordner {}: einen anderen wählen.</translation>
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
   <source>misfit up to {:.2g} mm (full colour: {:.2g} mm)</source>
   <translation>Passfehler bis {:.2g} mm (volle Farbe: {:.2g} mm)</translation>
  </message>
  <message>
   <source>strain up to {:.2%} (full colour: {:.0%}, what PLA bears)</source>
   <translation>Dehnung bis {:.2%} (volle Farbe: {:.0%}, was PLA aushält)</translation>
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
   <source>Glue tabs</source>
   <translation>Klebelaschen</translation>
  </message>
  <message>
   <source>Sheet</source>
   <translation>Bogen</translation>
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
   <source>Title</source>
   <translation>Titel</translation>
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
   <source>The preview is slow: it follows on OK.</source>
   <translation>Die Vorschau ist langsam: sie folgt bei OK.</translation>
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
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>Energy, {} EA·‖AB‖</source>
   <translation>Energie, {} EA·‖AB‖</translation>
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
   <source>Select a tube to see its numbers.</source>
   <translation>Einen Schlauch auswählen, um seine Zahlen zu sehen.</translation>
  </message>
  <message>
   <source>Snap margin; floppy below 1</source>
   <translation>Schnappreserve; unter 1 schlaff</translation>
  </message>
  <message>
   <source>Tube charts</source>
   <translation>Schlauch-Diagramme</translation>
  </message>
  <message>
   <source>opening: flat to deployed</source>
   <translation>Öffnung: flach bis entfaltet</translation>
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
   <source>Adaptive</source>
   <translation>Angepasst</translation>
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
   <source>Automatic: the direction or viewpoint from which the curve is seen most openly. Direction, Viewpoint: as given by Ruling</source>
   <translation>Automatisch: die Richtung oder der Blickpunkt, aus dem die Kurve am offensten zu sehen ist. Richtung, Blickpunkt: wie unter Erzeugende angegeben</translation>
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
   <source>Base angle ω of the single unit's contact trapezoids; 90° is a plane unit, less is a unit on a sphere</source>
   <translation>Basiswinkel ω der Kontakttrapeze der einzelnen Einheit; 90° ist eine ebene Einheit, weniger eine auf einer Kugel</translation>
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
   <source>BistableUnit whose panels become thick</source>
   <translation>Bistabile Einheiten, deren Flächen dick werden</translation>
  </message>
  <message>
   <source>Body count</source>
   <translation>Anzahl Körper</translation>
  </message>
  <message>
   <source>Body names</source>
   <translation>Namen der Körper</translation>
  </message>
  <message>
   <source>Border panels</source>
   <translation>Randflächen</translation>
  </message>
  <message>
   <source>Centre of the sphere; all legs of the strips point to it</source>
   <translation>Mitte der Kugel; alle Schenkel der Streifen zeigen auf sie</translation>
  </message>
  <message>
   <source>Closed</source>
   <translation>Geschlossen</translation>
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
   <source>Contact panels</source>
   <translation>Kontaktflächen</translation>
  </message>
  <message>
   <source>Control points of the Bézier curve, two or more. On a sphere: plan coordinates, wrapped from the top (see SphereCenter)</source>
   <translation>Kontrollpunkte der Bézierkurve, zwei oder mehr. Auf einer Kugel: Plankoordinaten, von oben herumgelegt (siehe Kugelmitte)</translation>
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
   <source>Direction of all legs of the strips, or the point that they all pass (setting it turns Automatic off)</source>
   <translation>Richtung aller Schenkel der Streifen oder der Punkt, durch den sie alle gehen (wer sie setzt, schaltet Automatisch aus)</translation>
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
   <source>Energy barrier between the two states of every unit without thickness, in EA·‖AB‖ (symmetric unit of its theta and ratio)</source>
   <translation>Energieschwelle zwischen den beiden Zuständen jeder Einheit ohne Dicke, in EA·‖AB‖ (symmetrische Einheit mit ihrem Theta und Verhältnis)</translation>
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
   <source>For curves of kind General with a direction as Ruling: keep the segments from tilting along the way (long helices)</source>
   <translation>Für allgemeine Kurven mit einer Richtung als Erzeugende: die Strecken unterwegs nicht kippen lassen (lange Schrauben)</translation>
  </message>
  <message>
   <source>For the rule Adaptive: where the ratio lies between the least one (0; sin(theta/2), more where contact panels lean) and 1; smaller snaps harder</source>
   <translation>Für die Regel Angepasst: wo das Verhältnis zwischen dem kleinsten (0; sin(theta/2), mehr bei geneigten Kontaktflächen) und 1 liegt; kleiner schnappt härter</translation>
  </message>
  <message>
   <source>Gamma</source>
   <translation>Gamma</translation>
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
   <source>How the ratio ‖A'C'‖/‖AB‖ is chosen. Adaptive: by RatioShare, for every unit anew. Fixed: by Ratio. Exact: the ratio that closes on a sphere. Paper: 1/2. TargetSnap: by TargetMargin, for every unit anew</source>
   <translation>Wie das Verhältnis ‖A'C'‖/‖AB‖ gewählt wird. Angepasst: nach dem Verhältnisanteil, für jede Einheit neu. Fest: nach dem Verhältnis. Genau: das Verhältnis, das sich auf einer Kugel schließt. Aufsatz: 1/2. Nach Schnappziel: nach der Ziel-Schnappreserve, für jede Einheit neu</translation>
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
   <source>Kind</source>
   <translation>Art</translation>
  </message>
  <message>
   <source>Largest distance of a deployed contact block from its place on the curve</source>
   <translation>Größter Abstand eines entfalteten Kontaktblocks von seinem Platz auf der Kurve</translation>
  </message>
  <message>
   <source>Largest misfit of a hinge when deployed</source>
   <translation>Größter Passfehler eines Scharniers, entfaltet</translation>
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
   <source>Names of the bodies, in the order of the solids</source>
   <translation>Namen der Körper, in der Reihenfolge der Volumen</translation>
  </message>
  <message>
   <source>Needed play / play of the hinge, for every unit; below 1 a unit is floppy</source>
   <translation>Nötiges Spiel / Spiel des Scharniers, für jede Einheit; unter 1 ist eine Einheit schlaff</translation>
  </message>
  <message>
   <source>NonDevelopableVertex</source>
   <translation>Nicht abwickelbare Ecke</translation>
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
   <source>Number of knuckles along a hinge, odd; fewer where a hinge is short</source>
   <translation>Anzahl der Glieder entlang eines Scharniers, ungerade; weniger, wo ein Scharnier kurz ist</translation>
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
   <source>Peak strain that the material bears: 0.02 for PLA</source>
   <translation>Größte Dehnung, die das Material erträgt: 0,02 für PLA</translation>
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
   <source>Plane</source>
   <translation>Ebene</translation>
  </message>
  <message>
   <source>Plane: any plane in space. Sphere: on the sphere of SphereRadius about SphereCenter. General: any space curve, see Ruling</source>
   <translation>Ebene: eine beliebige Ebene im Raum. Kugel: auf der Kugel mit Kugelradius um die Kugelmitte. Allgemein: eine beliebige Raumkurve, siehe Erzeugende</translation>
  </message>
  <message>
   <source>Play of one hinge; 0.28 mm is that of the hinges' defaults, 0 that of flexible hinges</source>
   <translation>Spiel eines Scharniers; 0,28 mm ist das der voreingestellten Scharniere, 0 das flexibler Scharniere</translation>
  </message>
  <message>
   <source>Points</source>
   <translation>Punkte</translation>
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
   <source>Residual</source>
   <translation>Restfehler</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>Ergebnisse</translation>
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
   <source>Secondary triangles</source>
   <translation>Nebendreiecke</translation>
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
   <source>Start with the unit on the other side of the curve</source>
   <translation>Mit der Einheit auf der anderen Seite der Kurve beginnen</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Zustand</translation>
  </message>
  <message>
   <source>Strain limit</source>
   <translation>Dehngrenze</translation>
  </message>
  <message>
   <source>Support</source>
   <translation>Stützkörper</translation>
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
   <source>The ends of the curve coincide (not allowed)</source>
   <translation>Die Enden der Kurve fallen zusammen (nicht erlaubt)</translation>
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
   <source>Thickness of the panels</source>
   <translation>Dicke der Platten</translation>
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
   <source>Vertex</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <source>Viewpoint</source>
   <translation>Blickpunkt</translation>
  </message>
  <message>
   <source>Wanted snap margin: needed play / play of the hinges. 1.5 is firm, below 1 is floppy</source>
   <translation>Gewünschte Schnappreserve: nötiges Spiel / Spiel der Scharniere. 1,5 ist straff, unter 1 schlaff</translation>
  </message>
  <message>
   <source>Warnings</source>
   <translation>Warnungen</translation>
  </message>
  <message>
   <source>What to look at before printing</source>
   <translation>Worauf vor dem Druck zu achten ist</translation>
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
   <source>‖AB‖ / h: edge length to height of the strip</source>
   <translation>‖AB‖ / h: Kantenlänge zu Höhe des Streifens</translation>
  </message>
 </context>
 <context>
  <name>BistableSentence</name>
  <message>
   <source> (and of {0} other bodies)</source>
   <translation> (und von {0} anderen Körpern)</translation>
  </message>
  <message>
   <source> (and of {0} other body)</source>
   <translation> (und von {0} anderen Körper)</translation>
  </message>
  <message>
   <source> (and of {0} other pair)</source>
   <translation> (und bei {0} anderen Paar)</translation>
  </message>
  <message>
   <source> (and of {0} other pairs)</source>
   <translation> (und bei {0} anderen Paaren)</translation>
  </message>
  <message>
   <source> (and {0} other pair less)</source>
   <translation> (und {0} anderes Paar weniger)</translation>
  </message>
  <message>
   <source> (and {0} other pairs less)</source>
   <translation> (und {0} andere Paare weniger)</translation>
  </message>
  <message>
   <source> and are floppy</source>
   <translation> und damit schlaff</translation>
  </message>
  <message>
   <source> and {0} more</source>
   <translation> und {0} weitere</translation>
  </message>
  <message>
   <source> of unit {0}</source>
   <translation> von Einheit {0}</translation>
  </message>
  <message>
   <source> of {0}</source>
   <translation> von {0}</translation>
  </message>
  <message>
   <source>, but for {0} mm²</source>
   <translation>, bis auf {0} mm²</translation>
  </message>
  <message>
   <source>, or ConeAngle to 60°</source>
   <translation>, oder ConeAngle auf 60° einstellen</translation>
  </message>
  <message>
   <source>, turned by {0}°</source>
   <translation>, um {0}° gedreht</translation>
  </message>
  <message>
   <source>, {0} first</source>
   <translation>, zuerst {0}</translation>
  </message>
  <message>
   <source>: compensate</source>
   <translation>: Compensate einschalten</translation>
  </message>
  <message>
   <source>; set Thickness of {0} to {1} mm</source>
   <translation>; Thickness von {0} auf {1} mm einstellen</translation>
  </message>
  <message>
   <source>A contact quadrilateral{0} has an edge of length {1}: corners coincide; give four different corners (A_upper, B_upper, B_lower, A_lower).</source>
   <translation>Ein Kontaktviereck{0} hat eine Kante der Länge {1}: Ecken fallen zusammen; vier verschiedene Ecken angeben (A_upper, B_upper, B_lower, A_lower).</translation>
  </message>
  <message>
   <source>A contact quadrilateral{0} is not convex: its legs cross or its corners are out of order; make the strip lower (raise HeightRatio) or move Ruling's viewpoint away.</source>
   <translation>Ein Kontaktviereck{0} ist nicht konvex: seine Schenkel kreuzen sich oder seine Ecken sind vertauscht; den Streifen niedriger machen (HeightRatio erhöhen) oder den Blickpunkt von Ruling weiter weg setzen.</translation>
  </message>
  <message>
   <source>A contact quadrilateral{0} is not planar (by {1} of its size): move its corners into one plane.</source>
   <translation>Ein Kontaktviereck{0} ist nicht eben (um {1} seiner Größe): seine Ecken in eine Ebene legen.</translation>
  </message>
  <message>
   <source>A design file cannot turn a plan on a sphere: set the rotation of {0} to 0, or give its points heights.</source>
   <translation>Eine Entwurfsdatei kann keinen Plan auf einer Kugel drehen: die Drehung von {0} auf 0 stellen oder den Punkten Höhen geben.</translation>
  </message>
  <message>
   <source>A fold{0} would turn inside out (sine {1}): make EdgeLength shorter, move Ruling nearer to square with the curve, or raise Ratio.</source>
   <translation>Eine Falte{0} würde sich nach innen kehren (Sinus {1}): EdgeLength verkürzen, Ruling mehr quer zur Kurve stellen oder Ratio erhöhen.</translation>
  </message>
  <message>
   <source>A half block did not become one solid.</source>
   <translation>Ein halber Block wurde nicht zu einem Körper.</translation>
  </message>
  <message>
   <source>A panel{0} would be flipped or have no area (sine of its corner {1}): make EdgeLength shorter, move Ruling nearer to square with the curve, or change Ratio.</source>
   <translation>Eine Fläche{0} wäre umgeklappt oder ohne Inhalt (Sinus ihrer Ecke {1}): EdgeLength verkürzen, Ruling mehr quer zur Kurve stellen oder Ratio ändern.</translation>
  </message>
  <message>
   <source>A {0} of {1}{2} is {3} mm thick, less than the {4} of {5} mm, and would be left out.</source>
   <translation>{0} von {1}{2}: {3} mm dick, weniger als {4} mit {5} mm, und würde weggelassen.</translation>
  </message>
  <message>
   <source>All {0} units snap</source>
   <translation>Alle {0} Einheiten schnappen</translation>
  </message>
  <message>
   <source>Angle alpha{0} is {1}°: it must lie between 0° and 90°.</source>
   <translation>Winkel alpha{0} ist {1}°: er muss zwischen 0° und 90° liegen.</translation>
  </message>
  <message>
   <source>Angle beta{0} is {1}°: for alpha {2}° it must be at least 45° - alpha/2 = {3}° and below 90° - alpha = {4}°.</source>
   <translation>Winkel beta{0} ist {1}°: für alpha {2}° muss er mindestens 45° - alpha/2 = {3}° und unter 90° - alpha = {4}° sein.</translation>
  </message>
  <message>
   <source>Auto-fit: choose the TrianglePlacement, or the Curve, that is to be followed.</source>
   <translation>Automatisch anpassen: die TrianglePlacement oder die Curve wählen, der gefolgt werden soll.</translation>
  </message>
  <message>
   <source>Base angle omega is {0}°: it must lie between 0° and 90°.</source>
   <translation>Basiswinkel omega ist {0}°: er muss zwischen 0° und 90° liegen.</translation>
  </message>
  <message>
   <source>Bed: {0} Cure: {1}.</source>
   <translation>Druckbett: {0} Abhilfe: {1}.</translation>
  </message>
  <message>
   <source>Between any two moving bodies lies a layer of air{0}.</source>
   <translation>Zwischen je zwei beweglichen Körpern liegt eine Schicht Luft{0}.</translation>
  </message>
  <message>
   <source>Bodies {0} when opened to {1}.</source>
   <translation>Bei einer Öffnung von {1}: Körper {0}.</translation>
  </message>
  <message>
   <source>Body {0} has {1} mm³ instead of one solid of {2} mm³.</source>
   <translation>Körper {0} hat {1} mm³ statt eines Volumens von {2} mm³.</translation>
  </message>
  <message>
   <source>Body {0} has {1} mm³ instead of {2} mm³.</source>
   <translation>Körper {0} hat {1} mm³ statt {2} mm³.</translation>
  </message>
  <message>
   <source>C'{0} would leave its place between A and B: make EdgeLength shorter, move Ruling nearer to square with the curve, or lower Ratio.</source>
   <translation>C'{0} würde seinen Platz zwischen A und B verlassen: EdgeLength verkürzen, Ruling mehr quer zur Kurve stellen oder Ratio verkleinern.</translation>
  </message>
  <message>
   <source>ConeAngle is {0}°: set it between 45° and 60°, so that cones print without support.</source>
   <translation>ConeAngle ist {0}°: zwischen 45° und 60° einstellen, damit Kegel ohne Stütze gedruckt werden.</translation>
  </message>
  <message>
   <source>Cones are {0} mm apart, less than a layer of {1} mm: raise GapLength to {2} mm or lower ConeAngle towards 45°.</source>
   <translation>Kegel haben {0} mm Abstand, weniger als eine Schicht von {1} mm: GapLength auf {2} mm erhöhen oder ConeAngle in Richtung 45° senken.</translation>
  </message>
  <message>
   <source>Contacts: give two arrays of shape (4, 3) or (n, 4, 3) with the corners A_upper, B_upper, B_lower, A_lower; these have shapes {0} and {1}.</source>
   <translation>Contacts: zwei Felder der Form (4, 3) oder (n, 4, 3) mit den Ecken A_upper, B_upper, B_lower, A_lower angeben; diese haben die Formen {0} und {1}.</translation>
  </message>
  <message>
   <source>Contacts: there is no unit; give at least one pair of quadrilaterals.</source>
   <translation>Contacts: es gibt keine Einheit; mindestens ein Paar von Vierecken angeben.</translation>
  </message>
  <message>
   <source>Contacts{0} have coordinates that are not finite numbers; give them numbers in mm.</source>
   <translation>Contacts{0} haben Koordinaten, die keine endlichen Zahlen sind; Zahlen in mm angeben.</translation>
  </message>
  <message>
   <source>Coupon of {0} x {1} mm leaves nothing of {2}; set LengthX and LengthY to {3} and {4} mm.</source>
   <translation>Vom Probestück mit {0} x {1} mm bleibt nichts von {2} übrig; LengthX und LengthY auf {3} und {4} mm einstellen.</translation>
  </message>
  <message>
   <source>Curve is closed at ({0}) mm: a closed tube cannot be both bistable and flat-foldable; open it by a gap of a few EdgeLength.</source>
   <translation>Die Kurve ist bei ({0}) mm geschlossen: ein geschlossener Schlauch kann nicht zugleich bistabil und flach faltbar sein; die Kurve um einige EdgeLength öffnen.</translation>
  </message>
  <message>
   <source>Curve is closed at {0}: a closed tube cannot be both bistable and flat-foldable; open the curve by a gap of a few EdgeLength.</source>
   <translation>Die Kurve ist bei {0} geschlossen: ein geschlossener Schlauch kann nicht zugleich bistabil und flach faltbar sein; die Kurve um einige EdgeLength öffnen.</translation>
  </message>
  <message>
   <source>Curve is not on the sphere: at ({0}) mm it is {1} mm from SphereCenter, SphereRadius is {2} mm; correct SphereRadius and SphereCenter, or bring the curve within a quarter of the radius.</source>
   <translation>Die Kurve liegt nicht auf der Kugel: bei ({0}) mm ist sie {1} mm von SphereCenter entfernt, SphereRadius ist {2} mm; SphereRadius und SphereCenter berichtigen oder die Kurve auf ein Viertel des Radius heranbringen.</translation>
  </message>
  <message>
   <source>Curve is not on the sphere: near midpoint {0} it is {1} mm from the centre instead of SphereRadius {2} mm; project the curve onto the sphere or correct SphereRadius and SphereCenter.</source>
   <translation>Die Kurve liegt nicht auf der Kugel: nahe Mittelpunkt {0} ist sie {1} mm von der Mitte entfernt statt SphereRadius {2} mm; die Kurve auf die Kugel projizieren oder SphereRadius und SphereCenter berichtigen.</translation>
  </message>
  <message>
   <source>Curve is not planar: near ({0}) mm it lies {1} mm off its best plane; flatten it, or set Kind to Sphere if it lies on a sphere.</source>
   <translation>Die Kurve ist nicht eben: nahe ({0}) mm liegt sie {1} mm neben ihrer besten Ebene; sie eben machen oder Kind auf Sphere stellen, wenn sie auf einer Kugel liegt.</translation>
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
   <source>Curve: the radius of curvature is too small near {0} (about {1} mm, EdgeLength {2} mm needs more than {3} mm); make EdgeLength shorter or the bend wider.</source>
   <translation>Kurve: der Krümmungsradius ist nahe {0} zu klein (etwa {1} mm, EdgeLength {2} mm braucht mehr als {3} mm); EdgeLength verkürzen oder den Bogen weiter machen.</translation>
  </message>
  <message>
   <source>Curve: the tube meets itself: unit {0} near {1} overlaps unit {2} near {3}; move these parts of the curve further apart or make EdgeLength shorter.</source>
   <translation>Kurve: der Schlauch trifft auf sich selbst: Einheit {0} nahe {1} überdeckt Einheit {2} nahe {3}; diese Teile der Kurve weiter auseinanderrücken oder EdgeLength verkürzen.</translation>
  </message>
  <message>
   <source>Curve: units run into each other near {0}, where they tilt too much; make EdgeLength shorter or Gamma smaller, or along a General curve move Ruling nearer to square with the curve or switch Level on.</source>
   <translation>Kurve: Einheiten laufen nahe {0} ineinander, wo sie zu stark kippen; EdgeLength verkürzen oder Gamma verkleinern, oder entlang einer allgemeinen Kurve (General) Ruling mehr quer zur Kurve stellen oder Level einschalten.</translation>
  </message>
  <message>
   <source>DXF (as text, not binary)</source>
   <translation>DXF (als Text, nicht binär)</translation>
  </message>
  <message>
   <source>Deployed, the tube strays up to {0} mm from its curve{1}.</source>
   <translation>Entfaltet weicht der Schlauch bis zu {0} mm von seiner Kurve ab{1}.</translation>
  </message>
  <message>
   <source>Deployment is {0}: it must lie between 0 (flat) and 1 (deployed), at most {1}.</source>
   <translation>Deployment ist {0}: es muss zwischen 0 (flach) und 1 (entfaltet) liegen, höchstens bei {1}.</translation>
  </message>
  <message>
   <source>Deployment is {0}: it must lie between 0 and 1.</source>
   <translation>Deployment ist {0}: es muss zwischen 0 und 1 liegen.</translation>
  </message>
  <message>
   <source>EdgeLength {0} mm with Gamma {1}° would need more than {2} units along {3} mm of curve; make EdgeLength longer.</source>
   <translation>EdgeLength {0} mm mit Gamma {1}° bräuchte mehr als {2} Einheiten auf {3} mm Kurve; EdgeLength verlängern.</translation>
  </message>
  <message>
   <source>EdgeLength ‖AB‖</source>
   <translation>EdgeLength ‖AB‖</translation>
  </message>
  <message>
   <source>EdgeLength ‖AB‖ = {0} mm is too long for this curve of length {1} mm: not even one unit fits; make EdgeLength shorter, the curve longer, or Gamma smaller.</source>
   <translation>EdgeLength ‖AB‖ = {0} mm ist zu lang für diese Kurve der Länge {1} mm: nicht einmal eine Einheit passt; EdgeLength verkürzen, die Kurve verlängern oder Gamma verkleinern.</translation>
  </message>
  <message>
   <source>EdgeLength ‖AB‖ is {0} mm: set it to a length above 0.</source>
   <translation>EdgeLength ‖AB‖ ist {0} mm: eine Länge über 0 einstellen.</translation>
  </message>
  <message>
   <source>EdgeLength ‖AB‖ to {0} mm</source>
   <translation>EdgeLength ‖AB‖ auf {0} mm</translation>
  </message>
  <message>
   <source>EdgeLength ‖AB‖ {0} times larger</source>
   <translation>EdgeLength ‖AB‖ {0}-mal so groß</translation>
  </message>
  <message>
   <source>Every hinge: cones are {0} mm high and must exceed two gap lengths, or they disengage; set FaceThickness to {1} mm or more{2}.</source>
   <translation>Jedes Scharnier: Kegel sind {0} mm hoch und müssen höher als zwei Spalte sein, sonst rasten sie aus; FaceThickness auf {1} mm oder mehr einstellen{2}.</translation>
  </message>
  <message>
   <source>Every hinge: the pin is {0} mm thick, less than two nozzle widths; {1}.</source>
   <translation>Jedes Scharnier: der Stift ist {0} mm dick, weniger als zwei Düsenbreiten; {1}.</translation>
  </message>
  <message>
   <source>Every hinge: the wall around the pin is {0} mm thick, less than one nozzle width; {1}.</source>
   <translation>Jedes Scharnier: die Wand um den Stift ist {0} mm dick, weniger als eine Düsenbreite; {1}.</translation>
  </message>
  <message>
   <source>FirstUnit {0} and LastUnit {1} do not name units of a tube of {2}: set FirstUnit to 1 or more and LastUnit to at most {3} (0: the last).</source>
   <translation>FirstUnit {0} und LastUnit {1} nennen keine Einheiten eines Schlauchs von {2}: FirstUnit auf 1 oder mehr und LastUnit auf höchstens {3} einstellen (0: die letzte).</translation>
  </message>
  <message>
   <source>Gamma is {0}°: the first segment must lean forward; set Gamma above 0° and below 90° (10° to 30° is usual).</source>
   <translation>Gamma ist {0}°: die erste Strecke muss sich nach vorn neigen; Gamma über 0° und unter 90° einstellen (10° bis 30° ist üblich).</translation>
  </message>
  <message>
   <source>GapBetweenPlanes is {0} mm: set it to 0.6 mm or more.</source>
   <translation>GapBetweenPlanes ist {0} mm: auf 0.6 mm oder mehr einstellen.</translation>
  </message>
  <message>
   <source>GapBetweenPlanes {0} mm is below the layer height: stacked panels would fuse; set GapBetweenPlanes to {1} mm or more.</source>
   <translation>GapBetweenPlanes {0} mm ist kleiner als die Schichthöhe: gestapelte Platten würden verschmelzen; GapBetweenPlanes auf {1} mm oder mehr einstellen.</translation>
  </message>
  <message>
   <source>GapLength {0} mm is below the layer height: the printer closes it; set GapLength to {1} mm or more, or LayerHeight to {2} mm or less.</source>
   <translation>GapLength {0} mm ist kleiner als die Schichthöhe: der Drucker schließt den Spalt; GapLength auf {1} mm oder mehr oder LayerHeight auf {2} mm oder weniger einstellen.</translation>
  </message>
  <message>
   <source>Give the hinges less play (steeper cones, smaller GapLength, or flexible hinges, which have none), ask for a smaller margin, or use a bed that holds longer edges.</source>
   <translation>Den Scharnieren weniger Spiel geben (steilere Kegel, kleinere GapLength oder flexible Scharniere, die keines haben), eine kleinere Reserve verlangen oder ein Bett verwenden, auf das längere Kanten passen.</translation>
  </message>
  <message>
   <source>Give the hinges less play, ask for a smaller margin, or use a tougher material.</source>
   <translation>Den Scharnieren weniger Spiel geben, eine kleinere Reserve verlangen oder ein zäheres Material verwenden.</translation>
  </message>
  <message>
   <source>HeightRatio ‖AB‖/h is {0}: it must be a number above 0, 2.5 is usual.</source>
   <translation>HeightRatio ‖AB‖/h ist {0}: es muss eine Zahl über 0 sein, 2.5 ist üblich.</translation>
  </message>
  <message>
   <source>Hinge {0} has room for {1} segments instead of {2}.</source>
   <translation>Scharnier {0} hat Platz für {1} Glieder statt {2}.</translation>
  </message>
  <message>
   <source>Hinge {0}: no finger of {1} mm fits into panel {2}; set BondWidth to {3} mm, or {4}.</source>
   <translation>Scharnier {0}: kein Finger von {1} mm passt in Platte {2}; BondWidth auf {3} mm oder {4} einstellen.</translation>
  </message>
  <message>
   <source>Hinge {0}: {1} left between its vertices and {2}</source>
   <translation>Scharnier {0}: {1} zwischen seinen Ecken, und {2}</translation>
  </message>
  <message>
   <source>HingeType of {0} is Flexible: strips that bend have no deployed solid to slice, set HingeType to Rotational.</source>
   <translation>HingeType von {0} ist Flexible: Streifen, die sich biegen, haben keinen entfalteten Körper zum Slicen; HingeType auf Rotational stellen.</translation>
  </message>
  <message>
   <source>HingeType {0} is unknown: use Rotational or Flexible.</source>
   <translation>HingeType {0} ist unbekannt: Rotational oder Flexible verwenden.</translation>
  </message>
  <message>
   <source>Hinges{0} cannot be shifted so that the unit closes when deployed (at {1}°): make FaceThickness and GapBetweenPlanes smaller (their sum is {2} mm), EdgeLength longer than {3} mm, or Ratio larger; beyond 110° only less Gamma or a Ratio nearer to sin(theta/2) helps.</source>
   <translation>Scharniere{0} lassen sich nicht so verschieben, dass die Einheit entfaltet schließt (bei {1}°): FaceThickness und GapBetweenPlanes verkleinern (ihre Summe ist {2} mm), EdgeLength länger als {3} mm machen oder Ratio vergrößern; jenseits von 110° hilft nur weniger Gamma oder ein Ratio näher an sin(theta/2).</translation>
  </message>
  <message>
   <source>Kind {0} is unknown: use Vertex or NonDevelopableVertex.</source>
   <translation>Kind {0} ist unbekannt: Vertex oder NonDevelopableVertex verwenden.</translation>
  </message>
  <message>
   <source>Layers of {0} mm give every body its volume to {1}.</source>
   <translation>Schichten von {0} mm geben jedem Körper sein Volumen auf {1} genau.</translation>
  </message>
  <message>
   <source>Layers of {0} mm lay {1} mm² of {2} directly on {3}{4}, {5}.</source>
   <translation>Schichten von {0} mm legen {1} mm² von {2} direkt auf {3}{4}, {5}.</translation>
  </message>
  <message>
   <source>Layers of {0} mm make {1} {2} of its volume: its flat faces lie up to {3} mm off the layers.</source>
   <translation>Schichten von {0} mm geben {1} {2} seines Volumens: seine flachen Seiten liegen bis zu {3} mm neben den Schichten.</translation>
  </message>
  <message>
   <source>LengthX and LengthY {0} times larger</source>
   <translation>LengthX und LengthY {0}-mal so groß</translation>
  </message>
  <message>
   <source>Level: legs through a viewpoint have no level; switch Level off.</source>
   <translation>Level: Schenkel durch einen Blickpunkt liegen nicht waagerecht; Level ausschalten.</translation>
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
   <source>No isometric unit was found for the contacts{0} (residual {1}): make EdgeLength shorter, move Ruling nearer to square with the curve, or raise Ratio.</source>
   <translation>Keine isometrische Einheit gefunden für die Kontakte{0} (Restfehler {1}): EdgeLength verkürzen, Ruling mehr quer zur Kurve stellen oder Ratio erhöhen.</translation>
  </message>
  <message>
   <source>No smooth curve runs through these points: remove points that lie on each other.</source>
   <translation>Keine glatte Kurve läuft durch diese Punkte: Punkte entfernen, die aufeinander liegen.</translation>
  </message>
  <message>
   <source>No wall is thinner than the nozzle, no floor thinner than a layer.</source>
   <translation>Keine Wand ist dünner als die Düse, kein Boden dünner als eine Schicht.</translation>
  </message>
  <message>
   <source>Not even one unit, {0} × {1} × {2} mm large, fits the bed of {3}.</source>
   <translation>Nicht einmal eine Einheit, {0} × {1} × {2} mm groß, passt auf das Bett von {3}.</translation>
  </message>
  <message>
   <source>Nothing fits. {0} combinations tried; {1}. {2}</source>
   <translation>Nichts passt. {0} Kombinationen versucht; {1}. {2}</translation>
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
   <source>Omega is {0}°: set it to 90° for a plane unit, or above 0° and below 90° for a unit on a sphere.</source>
   <translation>Omega ist {0}°: auf 90° für eine ebene Einheit einstellen, oder über 0° und unter 90° für eine Einheit auf einer Kugel.</translation>
  </message>
  <message>
   <source>On the toolpaths of the slicer the {0} bodies {1}.</source>
   <translation>Auf den Werkzeugwegen des Slicers: {0} Körper {1}.</translation>
  </message>
  <message>
   <source>OpenSCAD agrees: {0} closed bodies of {1} mm³ ({2} off ours).</source>
   <translation>OpenSCAD stimmt zu: {0} geschlossene Körper von {1} mm³ ({2} Abweichung von unseren).</translation>
  </message>
  <message>
   <source>OpenSCAD does not accept the mesh: {0}</source>
   <translation>OpenSCAD nimmt das Netz nicht an: {0}</translation>
  </message>
  <message>
   <source>OpenSCAD finds {0} separate bodies where there are {1}.</source>
   <translation>OpenSCAD findet {0} getrennte Körper, wo es {1} sind.</translation>
  </message>
  <message>
   <source>OpenSCAD made nothing: {0}</source>
   <translation>OpenSCAD hat nichts erzeugt: {0}</translation>
  </message>
  <message>
   <source>OpenSCAD measures {0} mm³, {1} off our {2} mm³.</source>
   <translation>OpenSCAD misst {0} mm³, {1} neben unseren {2} mm³.</translation>
  </message>
  <message>
   <source>OpenSCAD was not found: install it (openscad.org), or put its path into the environment variable OPENSCAD.</source>
   <translation>OpenSCAD wurde nicht gefunden: es installieren (openscad.org) oder seinen Pfad in die Umgebungsvariable OPENSCAD schreiben.</translation>
  </message>
  <message>
   <source>Opening angle theta{0} is {1}°: it must lie between 0° and 180°.</source>
   <translation>Öffnungswinkel theta{0} ist {1}°: er muss zwischen 0° und 180° liegen.</translation>
  </message>
  <message>
   <source>Opening angle theta{0} is {1}°: on a sphere it must be above 0° and below 60°; use a smaller Gamma, a shorter EdgeLength or a gentler curve.</source>
   <translation>Öffnungswinkel theta{0} ist {1}°: auf einer Kugel muss er über 0° und unter 60° liegen; ein kleineres Gamma, eine kürzere EdgeLength oder eine sanftere Kurve verwenden.</translation>
  </message>
  <message>
   <source>Panel {0} is too large for the sheet: choose a larger sheet.</source>
   <translation>Fläche {0} ist zu groß für den Bogen: einen größeren Bogen wählen.</translation>
  </message>
  <message>
   <source>Panel {0}: cut back by {1} mm at every edge, no edge is left at hinge {2}</source>
   <translation>Platte {0}: an jeder Kante um {1} mm gekürzt, bleibt an Scharnier {2} keine Kante übrig</translation>
  </message>
  <message>
   <source>Panels{0} would open inside out, through one another: swap its left and right contact panels.</source>
   <translation>Platten{0} würden sich verkehrt herum öffnen, durcheinander hindurch: linke und rechte Kontaktplatten vertauschen.</translation>
  </message>
  <message>
   <source>Pivot {0} is unknown: use Cone or Pin.</source>
   <translation>Pivot {0} ist unbekannt: Cone oder Pin verwenden.</translation>
  </message>
  <message>
   <source>Plates are {0} mm apart beside the hinge, less than a layer: raise GapBetweenPlanes to {1} mm, or RotationAngle.</source>
   <translation>Platten haben neben dem Scharnier {0} mm Abstand, weniger als eine Schicht: GapBetweenPlanes auf {1} mm erhöhen, oder RotationAngle erhöhen.</translation>
  </message>
  <message>
   <source>Play of a hinge is {0} mm: it cannot be negative.</source>
   <translation>Das Spiel eines Scharniers ist {0} mm: es kann nicht negativ sein.</translation>
  </message>
  <message>
   <source>Points reach {0} mm from the top of the sphere, beyond its bottom at {1} mm: make SphereRadius larger or the curve smaller.</source>
   <translation>Points reichen {0} mm von der Oberseite der Kugel weg, über ihre Unterseite bei {1} mm hinaus: SphereRadius vergrößern oder die Kurve verkleinern.</translation>
  </message>
  <message>
   <source>Points: a curve needs at least two control points of 2 or 3 coordinates each; add control points.</source>
   <translation>Points: eine Kurve braucht mindestens zwei Kontrollpunkte mit je 2 oder 3 Koordinaten; Kontrollpunkte hinzufügen.</translation>
  </message>
  <message>
   <source>Points: control point {0} has a coordinate that is not a finite number; give it numbers in mm.</source>
   <translation>Points: Kontrollpunkt {0} hat eine Koordinate, die keine endliche Zahl ist; Zahlen in mm angeben.</translation>
  </message>
  <message>
   <source>Points: control points {0} and {1} coincide; move one of them or remove it.</source>
   <translation>Points: die Kontrollpunkte {0} und {1} fallen zusammen; einen davon verschieben oder entfernen.</translation>
  </message>
  <message>
   <source>Poses{0} cannot be found at {1} of its opening: make FaceThickness and GapBetweenPlanes smaller (their sum is {2} mm), EdgeLength longer than {3} mm, or Ratio larger.</source>
   <translation>Lagen{0} lassen sich bei {1} der Öffnung nicht finden: FaceThickness und GapBetweenPlanes verkleinern (ihre Summe ist {2} mm), EdgeLength länger als {3} mm machen oder Ratio vergrößern.</translation>
  </message>
  <message>
   <source>Preset {0} is unknown: choose one of {1}.</source>
   <translation>Preset {0} ist unbekannt: eines von {1} wählen.</translation>
  </message>
  <message>
   <source>PrusaSlicer made no toolpaths, it says {0}: change that, or slice the exported STL by hand to see more.</source>
   <translation>PrusaSlicer hat keine Werkzeugwege erzeugt, es sagt {0}: das ändern, oder das exportierte STL von Hand slicen, um mehr zu sehen.</translation>
  </message>
  <message>
   <source>PrusaSlicer was not found: install it (Debian: apt install prusa-slicer), or set the environment variable {0} to its path.</source>
   <translation>PrusaSlicer wurde nicht gefunden: es installieren (Debian: apt install prusa-slicer) oder die Umgebungsvariable {0} auf seinen Pfad setzen.</translation>
  </message>
  <message>
   <source>Ratio rule {0} is unknown on a sphere: use 'exact' or 'paper'.</source>
   <translation>Verhältnisregel {0} ist auf einer Kugel unbekannt: 'exact' oder 'paper' verwenden.</translation>
  </message>
  <message>
   <source>RatioRule {0} does not close on a sphere, where theta leaves no choice of ratio: choose Exact (or Paper for the paper's 1/2).</source>
   <translation>RatioRule {0} schließt nicht auf einer Kugel, wo theta das Verhältnis festlegt: Exact wählen (oder Paper für das 1/2 des Aufsatzes).</translation>
  </message>
  <message>
   <source>RatioRule {0} is unknown: choose one of {1}.</source>
   <translation>RatioRule {0} ist unbekannt: eine von {1} wählen.</translation>
  </message>
  <message>
   <source>RatioShare is {0}: it must be at least 0 and below 1; 0.05 to 0.2 is usual, smaller snaps harder.</source>
   <translation>RatioShare ist {0}: es muss mindestens 0 und unter 1 sein; 0.05 bis 0.2 ist üblich, kleiner schnappt härter.</translation>
  </message>
  <message>
   <source>Ratio{0} is {1}: for theta {2}° it must be at least sin(theta/2) = {3} and below 1; change Ratio or make theta smaller (shorter edge or smaller Gamma).</source>
   <translation>Ratio{0} ist {1}: für theta {2}° muss es mindestens sin(theta/2) = {3} und unter 1 sein; Ratio ändern oder theta verkleinern (kürzere Kante oder kleineres Gamma).</translation>
  </message>
  <message>
   <source>RotationAngle is {0}°: a tube is printed flat-folded, set it to 0°; coupons can be printed partly open.</source>
   <translation>RotationAngle ist {0}°: ein Schlauch wird flach gefaltet gedruckt, auf 0° einstellen; Probestücke können teilweise geöffnet gedruckt werden.</translation>
  </message>
  <message>
   <source>RotationAngle is {0}°: set it between 0° and 180°.</source>
   <translation>RotationAngle ist {0}°: zwischen 0° und 180° einstellen.</translation>
  </message>
  <message>
   <source>RotationAngle must be 0° for a flexible hinge: it is printed folded.</source>
   <translation>RotationAngle muss für ein flexibles Scharnier 0° sein: es wird gefaltet gedruckt.</translation>
  </message>
  <message>
   <source>RotationAngle must be 0° for a four-degree vertex: it is printed flat-folded.</source>
   <translation>RotationAngle muss für eine Ecke aus vier Platten 0° sein: sie wird flach gefaltet gedruckt.</translation>
  </message>
  <message>
   <source>Ruling: give ('parallel', direction) or ('point', V) with 3 numbers.</source>
   <translation>Ruling: ('parallel', Richtung) oder ('point', V) mit 3 Zahlen angeben.</translation>
  </message>
  <message>
   <source>Ruling: seen along the legs the curve overlaps itself: {0} lies in front of {1}; choose another direction or viewpoint for Ruling, or move these parts of the curve apart.</source>
   <translation>Ruling: entlang der Schenkel gesehen überdeckt die Kurve sich selbst: {0} liegt vor {1}; eine andere Richtung oder einen anderen Blickpunkt für Ruling wählen oder diese Teile der Kurve auseinanderrücken.</translation>
  </message>
  <message>
   <source>Ruling: the direction or viewpoint must be finite and not zero.</source>
   <translation>Ruling: Richtung oder Blickpunkt müssen endlich und nicht null sein.</translation>
  </message>
  <message>
   <source>Ruling: the legs run along the curve at its start; choose another direction or viewpoint for Ruling.</source>
   <translation>Ruling: die Schenkel laufen am Anfang der Kurve entlang der Kurve; eine andere Richtung oder einen anderen Blickpunkt für Ruling wählen.</translation>
  </message>
  <message>
   <source>Ruling: the legs run along the curve near {0} (at {1}°, {2}° is the least); choose another direction or viewpoint for Ruling.</source>
   <translation>Ruling: die Schenkel laufen nahe {0} entlang der Kurve (bei {1}°, {2}° ist das Mindeste); eine andere Richtung oder einen anderen Blickpunkt für Ruling wählen.</translation>
  </message>
  <message>
   <source>Ruling: the viewpoint {0} lies on the curve, {1} mm from {2}; move it away from the curve by more than {3} mm.</source>
   <translation>Ruling: der Blickpunkt {0} liegt auf der Kurve, {1} mm von {2}; ihn um mehr als {3} mm von der Kurve wegrücken.</translation>
  </message>
  <message>
   <source>Segmentations is {0}: knuckles alternate, so set it to an odd number, {1} for example.</source>
   <translation>Segmentations ist {0}: die Glieder wechseln sich ab, darum eine ungerade Zahl einstellen, zum Beispiel {1}.</translation>
  </message>
  <message>
   <source>Sheet {0} is unknown: use {1}, or width x height in mm such as 600x400, at least {2} x {3}.</source>
   <translation>Bogen {0} ist unbekannt: {1} verwenden, oder Breite x Höhe in mm wie 600x400, mindestens {2} x {3}.</translation>
  </message>
  <message>
   <source>Source {0} falls into {1} separate pieces: link one connected curve, or choose one of its edges.</source>
   <translation>Source {0} zerfällt in {1} getrennte Stücke: eine zusammenhängende Kurve verknüpfen oder eine ihrer Kanten wählen.</translation>
  </message>
  <message>
   <source>Source {0} has a kink of {1}° at ({2}) mm: round it with a fillet (or a tangent constraint), the units cannot follow a corner.</source>
   <translation>Source {0} hat einen Knick von {1}° bei ({2}) mm: ihn verrunden (oder tangential anschließen), die Einheiten können keiner Ecke folgen.</translation>
  </message>
  <message>
   <source>Source {0} has no edge: link an edge, a wire, a sketch or a Draft curve.</source>
   <translation>Source {0} hat keine Kante: eine Kante, einen Draht, eine Skizze oder eine Draft-Kurve verknüpfen.</translation>
  </message>
  <message>
   <source>Source {0} has no element {1} any more: choose its edge again.</source>
   <translation>Source {0} hat kein Element {1} mehr: die Kante neu wählen.</translation>
  </message>
  <message>
   <source>Source {0}: {1} is not an edge; choose an edge or a wire.</source>
   <translation>Source {0}: {1} ist keine Kante; eine Kante oder einen Draht wählen.</translation>
  </message>
  <message>
   <source>SphereRadius is {0} mm: give the sphere a radius above 0 and a finite SphereCenter.</source>
   <translation>SphereRadius ist {0} mm: der Kugel einen Radius über 0 und ein endliches SphereCenter geben.</translation>
  </message>
  <message>
   <source>Strip height h</source>
   <translation>Streifenhöhe h</translation>
  </message>
  <message>
   <source>Strip height h = {0} is too large for omega {1}°: the inner base vanishes at {2}; raise HeightRatio or omega (a larger sphere).</source>
   <translation>Streifenhöhe h = {0} ist zu groß für omega {1}°: die innere Grundseite verschwindet bei {2}; HeightRatio oder omega erhöhen (eine größere Kugel).</translation>
  </message>
  <message>
   <source>Strip height h = {0}{1} does not fit between the curve and the point where the legs of its thick panels meet, {2} away: raise HeightRatio, make the panels thinner (FaceThickness, GapBetweenPlanes) or Gamma larger.</source>
   <translation>Streifenhöhe h = {0}{1} passt nicht zwischen die Kurve und den Punkt, in dem sich die Schenkel ihrer dicken Platten treffen, {2} entfernt: HeightRatio erhöhen, die Platten dünner machen (FaceThickness, GapBetweenPlanes) oder Gamma vergrößern.</translation>
  </message>
  <message>
   <source>Strip height h = {0}{1} does not fit between the curve and the viewpoint, which is {2} away: raise HeightRatio or move Ruling's viewpoint away.</source>
   <translation>Streifenhöhe h = {0}{1} passt nicht zwischen die Kurve und den Blickpunkt, der {2} entfernt ist: HeightRatio erhöhen oder den Blickpunkt von Ruling weiter weg setzen.</translation>
  </message>
  <message>
   <source>Strip height h is {0}: set HeightRatio ‖AB‖/h to a number above 0.</source>
   <translation>Streifenhöhe h ist {0}: HeightRatio ‖AB‖/h auf eine Zahl über 0 einstellen.</translation>
  </message>
  <message>
   <source>Tabs are {0} mm deep: give 0 for none, or 4 to 10 mm.</source>
   <translation>Laschen sind {0} mm tief: 0 für keine oder 4 bis 10 mm angeben.</translation>
  </message>
  <message>
   <source>TargetBarrier is {0}: set it above 0, in EA·‖AB‖; 1e-6 is weak, 1e-4 strong.</source>
   <translation>TargetBarrier ist {0}: über 0 einstellen, in EA·‖AB‖; 1e-6 ist schwach, 1e-4 stark.</translation>
  </message>
  <message>
   <source>The blocks{0} lean so much that their planes meet on the wrong side: make EdgeLength shorter or move Ruling's viewpoint nearer to square with the curve.</source>
   <translation>Die Blöcke{0} neigen sich so stark, dass sich ihre Ebenen auf der falschen Seite treffen: EdgeLength verkürzen oder den Blickpunkt von Ruling mehr quer zur Kurve stellen.</translation>
  </message>
  <message>
   <source>The cones hang over by {0}° from the vertical and print without support.</source>
   <translation>Die Kegel hängen um {0}° aus der Senkrechten über und lassen sich ohne Stütze drucken.</translation>
  </message>
  <message>
   <source>The cones of {0} hang over by {1}° from the vertical, more than the {2}° that print without support.</source>
   <translation>Die Kegel von {0} hängen um {1}° aus der Senkrechten über, mehr als die {2}°, die sich ohne Stütze drucken lassen.</translation>
  </message>
  <message>
   <source>The contacts{0} open by {1}° about the leg at B: the opening must lie between 0° and 180°; use a larger Gamma or EdgeLength.</source>
   <translation>Die Kontakte{0} öffnen sich um {1}° um den Schenkel bei B: die Öffnung muss zwischen 0° und 180° liegen; ein größeres Gamma oder eine größere EdgeLength verwenden.</translation>
  </message>
  <message>
   <source>The deployed state{0} does not fold flat: its panels are too thick and lock on the way; make FaceThickness and GapBetweenPlanes smaller (their sum is {1} mm), EdgeLength longer than {2} mm, or Ratio larger.</source>
   <translation>Der entfaltete Zustand{0} lässt sich nicht flach falten: seine Platten sind zu dick und verklemmen unterwegs; FaceThickness und GapBetweenPlanes verkleinern (ihre Summe ist {1} mm), EdgeLength länger als {2} mm machen oder Ratio vergrößern.</translation>
  </message>
  <message>
   <source>The faces of body {0} do not close.</source>
   <translation>Die Flächen von Körper {0} schließen nicht.</translation>
  </message>
  <message>
   <source>The folder {0} cannot be written: choose another one.</source>
   <translation>In den Ordner {0} kann nicht geschrieben werden: einen anderen wählen.</translation>
  </message>
  <message>
   <source>The legs{0} are neither parallel nor all through one point (by {1}): a flat-foldable unit needs one Ruling, a direction or a viewpoint, for both contacts.</source>
   <translation>Die Schenkel{0} sind weder parallel noch gehen sie alle durch einen Punkt (um {1}): eine flach faltbare Einheit braucht ein Ruling, eine Richtung oder einen Blickpunkt, für beide Kontakte.</translation>
  </message>
  <message>
   <source>The mesh of {0} has {1} mm³, {2} off its solid's {3} mm³.</source>
   <translation>Das Netz von {0} hat {1} mm³, {2} neben den {3} mm³ seines Körpers.</translation>
  </message>
  <message>
   <source>The mesh of {0} {1}.</source>
   <translation>Das Netz von {0} {1}.</translation>
  </message>
  <message>
   <source>The nearest two moving bodies are {0} apart in the flat print.</source>
   <translation>Die nächsten zwei beweglichen Körper haben im flachen Druck {0} Abstand.</translation>
  </message>
  <message>
   <source>The print has {0} separate parts instead of {1} bodies.</source>
   <translation>Der Druck hat {0} getrennte Teile statt {1} Körper.</translation>
  </message>
  <message>
   <source>The print is {0} large and fits the bed of {1}{2}.</source>
   <translation>Der Druck ist {0} groß und passt auf das Bett von {1}{2}.</translation>
  </message>
  <message>
   <source>The print of {0} units is {1} large, too large for the bed of {2}: {3} units fit.</source>
   <translation>Der Druck von {0} Einheiten ist {1} groß, zu groß für das Bett von {2}: {3} Einheiten passen.</translation>
  </message>
  <message>
   <source>The two contact quadrilaterals{0} do not share the leg at B: give both with the corners A_upper, B_upper, B_lower, A_lower and the same B_upper and B_lower.</source>
   <translation>Die beiden Kontaktvierecke{0} haben nicht denselben Schenkel bei B: beide mit den Ecken A_upper, B_upper, B_lower, A_lower und denselben B_upper und B_lower angeben.</translation>
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
   <source>The unit's pitch is {0} mm and the hinges' {1} mm: give both the same FaceThickness and GapBetweenPlanes.</source>
   <translation>Der Ebenenabstand der Einheit ist {0} mm und der der Scharniere {1} mm: beiden dieselben FaceThickness und GapBetweenPlanes geben.</translation>
  </message>
  <message>
   <source>There is no file {0}: check its name and folder.</source>
   <translation>Es gibt keine Datei {0}: Namen und Ordner prüfen.</translation>
  </message>
  <message>
   <source>There is no folder {0}: make it, or choose another one.</source>
   <translation>Es gibt keinen Ordner {0}: ihn anlegen oder einen anderen wählen.</translation>
  </message>
  <message>
   <source>There is no sheet {0}: choose page 1 to {1}, or none.</source>
   <translation>Es gibt keinen Bogen {0}: Seite 1 bis {1} wählen, oder keine.</translation>
  </message>
  <message>
   <source>Thickness of {0} is 0 mm, and without thickness there is no snap margin: set it to face thickness + gap between planes, 1.8 mm for example, or aim for a TargetBarrier.</source>
   <translation>Thickness von {0} ist 0 mm, und ohne Dicke gibt es keine Schnappreserve: auf Plattendicke + Abstand der Ebenen einstellen, zum Beispiel 1.8 mm, oder TargetBarrier als Ziel nehmen.</translation>
  </message>
  <message>
   <source>Thickness: panels of pitch {0} mm are too thick for the unit of theta {1}° and EdgeLength {2} mm; make Thickness smaller, EdgeLength longer or Gamma larger.</source>
   <translation>Thickness: Platten mit Ebenenabstand {0} mm sind zu dick für die Einheit mit theta {1}° und EdgeLength {2} mm; Thickness verkleinern, EdgeLength verlängern oder Gamma vergrößern.</translation>
  </message>
  <message>
   <source>Thickness: the pitch of the panels is {0} mm; it must be at least 0 and below a quarter of EdgeLength ({1} mm).</source>
   <translation>Thickness: der Ebenenabstand der Platten ist {0} mm; er muss mindestens 0 und kleiner als ein Viertel von EdgeLength sein ({1} mm).</translation>
  </message>
  <message>
   <source>Unit {0}</source>
   <translation>Einheit {0}</translation>
  </message>
  <message>
   <source>Unit {0}: {1}</source>
   <translation>Einheit {0}: {1}</translation>
  </message>
  <message>
   <source>Unit {0}: {1} It is {2} x {3} mm.</source>
   <translation>Einheit {0}: {1} Er hat {2} x {3} mm.</translation>
  </message>
  <message>
   <source>Unit {0}{1}</source>
   <translation>Einheit {0}{1}</translation>
  </message>
  <message>
   <source>Units {0} and {1} have no common contact panel: make EdgeLength larger.</source>
   <translation>Die Einheiten {0} und {1} haben keine gemeinsame Kontaktplatte: EdgeLength vergrößern.</translation>
  </message>
  <message>
   <source>Units {0}{1}</source>
   <translation>Einheiten {0}{1}</translation>
  </message>
  <message>
   <source>Use a larger bed, a larger HeightRatio or a shorter curve.</source>
   <translation>Ein größeres Bett, ein größeres HeightRatio oder eine kürzere Kurve verwenden.</translation>
  </message>
  <message>
   <source>a strip with fingers needs {0} mm</source>
   <translation>ein Streifen mit Fingern braucht {0} mm</translation>
  </message>
  <message>
   <source>all others snap too weakly: margin {0} at best, {1} wanted</source>
   <translation>alle anderen schnappen zu schwach: Reserve bestenfalls {0}, gewünscht {1}</translation>
  </message>
  <message>
   <source>another program</source>
   <translation>einem anderen Programm</translation>
  </message>
  <message>
   <source>are welded</source>
   <translation>sind verschweißt</translation>
  </message>
  <message>
   <source>at least {0} mm</source>
   <translation>mindestens {0} mm</translation>
  </message>
  <message>
   <source>at rest</source>
   <translation>in Ruhe</translation>
  </message>
  <message>
   <source>cannot follow the curve: {0}, as “{1}”</source>
   <translation>können der Kurve nicht folgen: {0}, wie „{1}“</translation>
  </message>
  <message>
   <source>choose RatioRule TargetSnap or a smaller ratio, or </source>
   <translation>RatioRule TargetSnap oder ein kleineres Verhältnis wählen, oder </translation>
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
   <source>choose a TrianglePlacement of this workbench, or none for a single unit</source>
   <translation>eine TrianglePlacement dieses Arbeitsbereichs wählen, oder keine für eine einzelne Einheit</translation>
  </message>
  <message>
   <source>choose another folder</source>
   <translation>einen anderen Ordner wählen</translation>
  </message>
  <message>
   <source>crosses itself at {0} places</source>
   <translation>durchdringt sich selbst an {0} Stellen</translation>
  </message>
  <message>
   <source>deployed</source>
   <translation>entfaltet</translation>
  </message>
  <message>
   <source>deployment_frames is {0}: give a number of states from 0 to 10000.</source>
   <translation>deployment_frames ist {0}: eine Anzahl von Zuständen von 0 bis 10000 angeben.</translation>
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
   <source>exit code {0}</source>
   <translation>Rückgabewert {0}</translation>
  </message>
  <message>
   <source>flat</source>
   <translation>flach</translation>
  </message>
  <message>
   <source>floor</source>
   <translation>Boden</translation>
  </message>
  <message>
   <source>free some space there</source>
   <translation>dort Platz schaffen</translation>
  </message>
  <message>
   <source>has triangles that face the wrong way</source>
   <translation>hat Dreiecke, die nach der falschen Seite zeigen</translation>
  </message>
  <message>
   <source>has {0} separate parts instead of one</source>
   <translation>hat {0} getrennte Teile statt eines</translation>
  </message>
  <message>
   <source>has {0} triangles without area</source>
   <translation>hat {0} Dreiecke ohne Fläche</translation>
  </message>
  <message>
   <source>in contact</source>
   <translation>in Berührung</translation>
  </message>
  <message>
   <source>instead of {0}</source>
   <translation>statt {0}</translation>
  </message>
  <message>
   <source>is inside out</source>
   <translation>ist von innen nach außen gekehrt</translation>
  </message>
  <message>
   <source>is not closed at {0} edges</source>
   <translation>ist an {0} Kanten nicht geschlossen</translation>
  </message>
  <message>
   <source>it has none</source>
   <translation>er hat keine</translation>
  </message>
  <message>
   <source>it has {0}</source>
   <translation>er hat {0}</translation>
  </message>
  <message>
   <source>layer</source>
   <translation>eine Schicht</translation>
  </message>
  <message>
   <source>leave more than a quarter of the curve uncovered: {0}</source>
   <translation>lassen mehr als ein Viertel der Kurve frei: {0}</translation>
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
   <source>make ConeAngle {0}° or less</source>
   <translation>ConeAngle auf {0}° oder weniger einstellen</translation>
  </message>
  <message>
   <source>make EdgeLength at least {0} times shorter</source>
   <translation>EdgeLength mindestens {0}-mal kürzer machen</translation>
  </message>
  <message>
   <source>make EdgeLength larger, Ratio nearer to sin(theta/2), or GapLength smaller</source>
   <translation>EdgeLength vergrößern, Ratio näher an sin(theta/2) bringen oder GapLength verkleinern</translation>
  </message>
  <message>
   <source>make FaceThickness and GapBetweenPlanes multiples of {0} mm</source>
   <translation>FaceThickness und GapBetweenPlanes auf Vielfache von {0} mm einstellen</translation>
  </message>
  <message>
   <source>make FaceThickness and GapBetweenPlanes smaller (their sum is {0} mm), EdgeLength longer than {1} mm, or Ratio larger.</source>
   <translation>FaceThickness und GapBetweenPlanes verkleinern (ihre Summe ist {0} mm), EdgeLength länger als {1} mm machen oder Ratio vergrößern.</translation>
  </message>
  <message>
   <source>make FaceThickness larger</source>
   <translation>FaceThickness vergrößern</translation>
  </message>
  <message>
   <source>make GapBetweenPlanes larger than {0} mm, or EdgeLength longer</source>
   <translation>GapBetweenPlanes über {0} mm vergrößern oder EdgeLength verlängern</translation>
  </message>
  <message>
   <source>make GapLength larger than {0} mm</source>
   <translation>GapLength über {0} mm vergrößern</translation>
  </message>
  <message>
   <source>make LayerHeight smaller, or GapLength and GapBetweenPlanes larger</source>
   <translation>LayerHeight verkleinern oder GapLength und GapBetweenPlanes vergrößern</translation>
  </message>
  <message>
   <source>make the linear and angular deflection smaller</source>
   <translation>die lineare und die Winkelabweichung verkleinern</translation>
  </message>
  <message>
   <source>margin {0} at the least</source>
   <translation>Reserve mindestens {0}</translation>
  </message>
  <message>
   <source>might not come free</source>
   <translation>lösen sich womöglich nicht</translation>
  </message>
  <message>
   <source>more than {0} mm of play and snap</source>
   <translation>mehr als {0} mm Spiel und Schnappen</translation>
  </message>
  <message>
   <source>more would strain the panels beyond {0}</source>
   <translation>mehr würde die Platten über {0} dehnen</translation>
  </message>
  <message>
   <source>no length is</source>
   <translation>keine Länge bleibt</translation>
  </message>
  <message>
   <source>no suffix</source>
   <translation>keine Endung</translation>
  </message>
  <message>
   <source>nothing was written</source>
   <translation>nichts wurde geschrieben</translation>
  </message>
  <message>
   <source>nozzle</source>
   <translation>die Düse</translation>
  </message>
  <message>
   <source>one place is</source>
   <translation>eine Stelle</translation>
  </message>
  <message>
   <source>only {0} mm are</source>
   <translation>nur {0} mm bleiben</translation>
  </message>
  <message>
   <source>open wider than the 60° that a sphere allows: {0}</source>
   <translation>öffnen weiter als die 60°, die eine Kugel erlaubt: {0}</translation>
  </message>
  <message>
   <source>overlap by at most {0} mm</source>
   <translation>überlappen sich um höchstens {0} mm</translation>
  </message>
  <message>
   <source>print higher than {0} mm: {1}, the lowest {2} mm</source>
   <translation>im Druck höher als {0} mm: {1}, die niedrigste {2} mm</translation>
  </message>
  <message>
   <source>rebuild the solids, and report it if it stays so</source>
   <translation>die Körper neu erstellen, und es melden, wenn es so bleibt</translation>
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
   <source>set FaceThickness to {0} mm or more, or Pivot to Cone</source>
   <translation>FaceThickness auf {0} mm oder mehr oder Pivot auf Cone einstellen</translation>
  </message>
  <message>
   <source>set FirstUnit and LastUnit to print the parts {0}</source>
   <translation>mit FirstUnit und LastUnit die Teile {0} drucken</translation>
  </message>
  <message>
   <source>set HeightRatio ‖AB‖/h to a number above 0</source>
   <translation>HeightRatio ‖AB‖/h auf eine Zahl über 0 einstellen</translation>
  </message>
  <message>
   <source>set Orientation to Flat: on edge, slanted hinges lean their cones</source>
   <translation>Orientation auf Flat stellen: hochkant neigen schräge Scharniere ihre Kegel</translation>
  </message>
  <message>
   <source>set it above 0; 1.5 is firm, below 1 is floppy</source>
   <translation>über 0 einstellen; 1.5 ist straff, unter 1 schlaff</translation>
  </message>
  <message>
   <source>set it to a length above 0</source>
   <translation>eine Länge über 0 einstellen</translation>
  </message>
  <message>
   <source>set it to a length in mm above 0</source>
   <translation>eine Länge in mm über 0 einstellen</translation>
  </message>
  <message>
   <source>set it to what one hinge's clearance allows, 0.28 mm by default; hinges without play never turn floppy and need no target</source>
   <translation>auf das einstellen, was die Luft eines Scharniers zulässt, normalerweise 0.28 mm; Scharniere ohne Spiel werden nie schlaff und brauchen kein Ziel</translation>
  </message>
  <message>
   <source>set it to what the material bears, 0.02 for PLA</source>
   <translation>auf das einstellen, was das Material erträgt, 0.02 für PLA</translation>
  </message>
  <message>
   <source>split the tube at contact blocks into {0} prints of units {1}</source>
   <translation>den Schlauch an Kontaktblöcken in {0} Drucke der Einheiten {1} teilen</translation>
  </message>
  <message>
   <source>state is {0}: choose one of {1}.</source>
   <translation>state ist {0}: eines von {1} wählen.</translation>
  </message>
  <message>
   <source>switch Compensate on</source>
   <translation>Compensate einschalten</translation>
  </message>
  <message>
   <source>switch Compensate on, so that the hinges close</source>
   <translation>Compensate einschalten, damit die Scharniere schließen</translation>
  </message>
  <message>
   <source>switch Support on, or let the slicer fill the gaps with soluble support</source>
   <translation>Support einschalten oder den Slicer die Spalte mit löslicher Stütze füllen lassen</translation>
  </message>
  <message>
   <source>tan(alpha)*tan(beta){0} is {1}: it must be below 1/2, or the second triangle has no dart; make alpha or beta smaller.</source>
   <translation>tan(alpha)*tan(beta){0} ist {1}: es muss unter 1/2 sein, sonst hat das zweite Dreieck keine Pfeilform; alpha oder beta verkleinern.</translation>
  </message>
  <message>
   <source>the STEP writer did not finish</source>
   <translation>das Schreiben der STEP-Datei wurde nicht fertig</translation>
  </message>
  <message>
   <source>the strip height h (HeightRatio) so that h is {0} mm</source>
   <translation>die Streifenhöhe h (HeightRatio) auf {0} mm</translation>
  </message>
  <message>
   <source>the suffix {0}</source>
   <translation>die Endung {0}</translation>
  </message>
  <message>
   <source>their ratio is as near to sin(theta/2) as can be made (share {0})</source>
   <translation>ihr Verhältnis ist so nah an sin(theta/2), wie es geht (Anteil {0})</translation>
  </message>
  <message>
   <source>those that snap hard enough strain by {0} or more, beyond {1}</source>
   <translation>die, die hart genug schnappen, dehnen sich um {0} oder mehr, über {1} hinaus</translation>
  </message>
  <message>
   <source>three segments need {0} mm</source>
   <translation>drei Glieder brauchen {0} mm</translation>
  </message>
  <message>
   <source>too large for the bed of {0} × {1} mm: {2}, from EdgeLength {3} mm on</source>
   <translation>zu groß für das Bett von {0} × {1} mm: {2}, ab EdgeLength {3} mm</translation>
  </message>
  <message>
   <source>touch by at most {0} mm²</source>
   <translation>berühren sich mit höchstens {0} mm²</translation>
  </message>
  <message>
   <source>units cannot be made: {0}, as “{1}”</source>
   <translation>Einheiten lassen sich nicht erstellen: {0}, wie „{1}“</translation>
  </message>
  <message>
   <source>wall</source>
   <translation>Wand</translation>
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
   <source>without a second stable state</source>
   <translation>ohne zweiten stabilen Zustand</translation>
  </message>
  <message>
   <source>without thickness there is no snap margin: set it to face thickness + gap between planes, 1.8 mm for example, or aim for a TargetBarrier</source>
   <translation>ohne Dicke gibt es keine Schnappreserve: auf Plattendicke + Abstand der Ebenen einstellen, zum Beispiel 1.8 mm, oder TargetBarrier als Ziel nehmen</translation>
  </message>
  <message>
   <source>{0} (Also unit {1}.)</source>
   <translation>{0} (Auch Einheit {1}.)</translation>
  </message>
  <message>
   <source>{0} (Also units {1}.)</source>
   <translation>{0} (Auch Einheiten {1}.)</translation>
  </message>
  <message>
   <source>{0} and {1} are {2} in the flat print, less than the {3}, and would fuse.</source>
   <translation>{0} und {1}: im flachen Druck {2}, weniger als die {3}, und würden verschmelzen.</translation>
  </message>
  <message>
   <source>{0} and {1} run {2} mm into each other when opened to {3}, {4}.</source>
   <translation>{0} und {1} dringen {2} mm ineinander, bei Öffnung {3}, {4}.</translation>
  </message>
  <message>
   <source>{0} and {1} touch by {2} mm² on the toolpaths{3}, more than {4} mm², and {5}.</source>
   <translation>{0} und {1} berühren sich auf den Werkzeugwegen mit {2} mm²{3}, mehr als {4} mm², und {5}.</translation>
  </message>
  <message>
   <source>{0} are floppy: hinges with a play of {1} mm swallow the snap (snap margin about {2}, below 1); {3}make EdgeLength or Gamma larger.</source>
   <translation>{0} sind schlaff: Scharniere mit einem Spiel von {1} mm schlucken das Schnappen (Schnappreserve etwa {2}, unter 1); {3}EdgeLength oder Gamma vergrößern.</translation>
  </message>
  <message>
   <source>{0} are laid over air, all in strips narrower than the {1} mm that a printer spans; the largest are {2}.</source>
   <translation>{0} liegen über Luft, alle in Streifen schmaler als die {1} mm, die ein Drucker überbrückt; die größten sind {2}.</translation>
  </message>
  <message>
   <source>{0} are laid over air, where {1} wider than the {2} mm that a printer spans, the largest {3}.</source>
   <translation>{0} liegen über Luft, davon {1} breiter als die {2} mm, die ein Drucker überbrückt, am größten {3}.</translation>
  </message>
  <message>
   <source>{0} bodies start</source>
   <translation>{0} Körper beginnen</translation>
  </message>
  <message>
   <source>{0} cannot be read ({1}): check it.</source>
   <translation>{0} lässt sich nicht lesen ({1}): die Datei prüfen.</translation>
  </message>
  <message>
   <source>{0} cannot be read ({1}): export it again.</source>
   <translation>{0} lässt sich nicht lesen ({1}): die Datei neu exportieren.</translation>
  </message>
  <message>
   <source>{0} cannot be {1}: export it without a state.</source>
   <translation>{0} kann nicht {1} sein: ohne Zustand exportieren.</translation>
  </message>
  <message>
   <source>{0} cannot reach the energy barrier: {1} instead of {2} EA·‖AB‖; make Gamma larger: wider units snap harder.</source>
   <translation>{0}: die Energieschwelle wird nicht erreicht, {1} statt {2} EA·‖AB‖; Gamma vergrößern: weitere Einheiten schnappen härter.</translation>
  </message>
  <message>
   <source>{0} cannot reach the snap margin: {1} {2}{3}; {4}. Make EdgeLength about {5} mm, Gamma larger (wider units snap harder), or the play of the hinges {6} mm (steeper cones, smaller GapLength).</source>
   <translation>{0}: die Schnappreserve wird nicht erreicht, {1} {2}{3}; {4}. EdgeLength auf etwa {5} mm einstellen, Gamma vergrößern (weitere Einheiten schnappen härter) oder das Spiel der Scharniere auf {6} mm verkleinern (steilere Kegel, kleinere GapLength).</translation>
  </message>
  <message>
   <source>{0} export has no option {1}: {2}.</source>
   <translation>Der Export nach {0} hat keine Option {1}: {2}.</translation>
  </message>
  <message>
   <source>{0} has faces but no solid, and OpenSCAD is for solids: choose a HingeSet or a HingeCoupon.</source>
   <translation>{0} hat Flächen, aber keinen Körper, und OpenSCAD ist für Körper: ein HingeSet oder einen HingeCoupon wählen.</translation>
  </message>
  <message>
   <source>{0} has no curve {1}: it holds {2} ({3} mm long).</source>
   <translation>{0} hat keine Kurve {1}: es sind {2} ({3} mm lang).</translation>
  </message>
  <message>
   <source>{0} has no faces to export: choose a unit, a tube or a solid.</source>
   <translation>{0} hat keine Flächen zum Exportieren: eine Einheit, einen Schlauch oder einen Körper wählen.</translation>
  </message>
  <message>
   <source>{0} has no lines or no printing time as PrusaSlicer writes them: slice with it.</source>
   <translation>{0} hat keine Linien oder keine Druckzeit, wie PrusaSlicer sie schreibt: damit slicen.</translation>
  </message>
  <message>
   <source>{0} has no panels of zero thickness to write: choose a BistableUnit, or a HingeSet on one.</source>
   <translation>{0} hat keine Flächen ohne Dicke zum Schreiben: eine BistableUnit wählen, oder ein HingeSet darauf.</translation>
  </message>
  <message>
   <source>{0} has no second stable state: its hinges' misfit rises all the way, to {1} mm; switch Compensate on.</source>
   <translation>{0} hat keinen zweiten stabilen Zustand: der Passfehler der Scharniere steigt auf dem ganzen Weg, bis {1} mm; Compensate einschalten.</translation>
  </message>
  <message>
   <source>{0} has no shape to export: choose a unit, a tube or a solid.</source>
   <translation>{0} hat keine Form zum Exportieren: eine Einheit, einen Schlauch oder einen Körper wählen.</translation>
  </message>
  <message>
   <source>{0} has no unit {1}: choose 1 to {2}.</source>
   <translation>{0} hat keine Einheit {1}: 1 bis {2} wählen.</translation>
  </message>
  <message>
   <source>{0} has {1} different points: give one point a row, x, y and perhaps z in mm, two rows or more.</source>
   <translation>{0} hat {1} verschiedene Punkte: einen Punkt je Zeile angeben, x, y und eventuell z in mm, zwei Zeilen oder mehr.</translation>
  </message>
  <message>
   <source>{0} has {1}: choose one of {2}.</source>
   <translation>{0} hat {1}: eine von {2} wählen.</translation>
  </message>
  <message>
   <source>{0} has {1}: name the file with one of {2}.</source>
   <translation>{0} hat {1}: der Datei eine der Endungen {2} geben.</translation>
  </message>
  <message>
   <source>{0} holds no line or curve: draw one path, and export it again.</source>
   <translation>{0} enthält keine Linie oder Kurve: einen Pfad zeichnen und neu exportieren.</translation>
  </message>
  <message>
   <source>{0} holds {1} separate curves ({2} mm long): join them, or choose one by its number.</source>
   <translation>{0} enthält {1} getrennte Kurven ({2} mm lang): sie verbinden oder eine nach ihrer Nummer wählen.</translation>
  </message>
  <message>
   <source>{0} holds {1} units: say which, 1 to {2}.</source>
   <translation>{0} enthält {1} Einheiten: angeben, welche, 1 bis {2}.</translation>
  </message>
  <message>
   <source>{0} in mid-air{1}, {2} mm above the bed and more than {3} mm above anything else.</source>
   <translation>{0} mitten in der Luft{1}, {2} mm über dem Bett und mehr als {3} mm über allem anderen.</translation>
  </message>
  <message>
   <source>{0} is a folder: add a file name to it.</source>
   <translation>{0} ist ein Ordner: einen Dateinamen anhängen.</translation>
  </message>
  <message>
   <source>{0} is empty: {1}.</source>
   <translation>{0} ist leer: {1}.</translation>
  </message>
  <message>
   <source>{0} is floppy: hinges with a play of {1} mm swallow the snap (snap margin about {2}, below 1); {3}make EdgeLength or Gamma larger.</source>
   <translation>{0} ist schlaff: Scharniere mit einem Spiel von {1} mm schlucken das Schnappen (Schnappreserve etwa {2}, unter 1); {3}EdgeLength oder Gamma vergrößern.</translation>
  </message>
  <message>
   <source>{0} is floppy: its hinges play by {1} mm and {2} mm is enough to open it without strain (snap margin {3}); make EdgeLength larger, Ratio nearer to sin(theta/2), the cones steeper, GapLength smaller, or use flexible hinges, which have no play.</source>
   <translation>{0} ist schlaff: ihre Scharniere haben {1} mm Spiel, und {2} mm reichen, um sie ohne Dehnung zu öffnen (Schnappreserve {3}); EdgeLength vergrößern, Ratio näher an sin(theta/2) bringen, die Kegel steiler machen, GapLength verkleinern oder flexible Scharniere verwenden, die kein Spiel haben.</translation>
  </message>
  <message>
   <source>{0} is invalid, correct it first: {1}</source>
   <translation>{0} ist ungültig, zuerst berichtigen: {1}</translation>
  </message>
  <message>
   <source>{0} is no name of a report: let it end in .html.</source>
   <translation>{0} ist kein Name für einen Bericht: auf .html enden lassen.</translation>
  </message>
  <message>
   <source>{0} is no tube: choose a BistableUnit, a HingeSet or a HingeCoupon.</source>
   <translation>{0} ist kein Schlauch: eine BistableUnit, ein HingeSet oder einen HingeCoupon wählen.</translation>
  </message>
  <message>
   <source>{0} is not a FOLD file: choose a file that is.</source>
   <translation>{0} ist keine FOLD-Datei: eine wählen, die es ist.</translation>
  </message>
  <message>
   <source>{0} is not a closed solid, which 3MF needs: choose the hinged solids, or export to STL, OBJ or STEP.</source>
   <translation>{0} ist kein geschlossener Körper, den 3MF braucht: die Körper mit Scharnieren wählen oder nach STL, OBJ oder STEP exportieren.</translation>
  </message>
  <message>
   <source>{0} is not a text file: choose a {1} file.</source>
   <translation>{0} ist keine Textdatei: eine Datei der Art {1} wählen.</translation>
  </message>
  <message>
   <source>{0} is not a type of the Bistable workbench.</source>
   <translation>{0} ist kein Typ des Arbeitsbereichs Bistable.</translation>
  </message>
  <message>
   <source>{0} is not a whole DXF file: export it again, as DXF R12 to 2018.</source>
   <translation>{0} ist keine ganze DXF-Datei: neu exportieren, als DXF R12 bis 2018.</translation>
  </message>
  <message>
   <source>{0} is not a whole FOLD file ({1}): save it again.</source>
   <translation>{0} ist keine ganze FOLD-Datei ({1}): neu speichern.</translation>
  </message>
  <message>
   <source>{0} is not a whole SVG file ({1}): save it again.</source>
   <translation>{0} ist keine ganze SVG-Datei ({1}): neu speichern.</translation>
  </message>
  <message>
   <source>{0} is not an SVG file: choose one, or another suffix.</source>
   <translation>{0} ist keine SVG-Datei: eine wählen, oder eine andere Endung.</translation>
  </message>
  <message>
   <source>{0} is not computed yet: recompute the document first.</source>
   <translation>{0} ist noch nicht berechnet: zuerst das Dokument neu berechnen.</translation>
  </message>
  <message>
   <source>{0} is not computed yet: recompute the document, then export.</source>
   <translation>{0} ist noch nicht berechnet: das Dokument neu berechnen, dann exportieren.</translation>
  </message>
  <message>
   <source>{0} is not in mm (column {1}): convert it to mm first.</source>
   <translation>{0} ist nicht in mm (Spalte {1}): zuerst in mm umrechnen.</translation>
  </message>
  <message>
   <source>{0} is {1} mm: set it to a length above 0.</source>
   <translation>{0} ist {1} mm: eine Länge über 0 einstellen.</translation>
  </message>
  <message>
   <source>{0} is {1}, which is no program: set it to the path of PrusaSlicer.</source>
   <translation>{0} ist {1}, und das ist kein Programm: den Pfad von PrusaSlicer angeben.</translation>
  </message>
  <message>
   <source>{0} is {1}: set it to a number above 0.</source>
   <translation>{0} ist {1}: eine Zahl über 0 einstellen.</translation>
  </message>
  <message>
   <source>{0} is {1}: {2}.</source>
   <translation>{0} ist {1}: {2}.</translation>
  </message>
  <message>
   <source>{0} links to {1} ({2}): {3}.</source>
   <translation>{0} verweist auf {1} ({2}): {3}.</translation>
  </message>
  <message>
   <source>{0} mm apart</source>
   <translation>{0} mm voneinander entfernt</translation>
  </message>
  <message>
   <source>{0} mm asked for</source>
   <translation>verlangten {0} mm</translation>
  </message>
  <message>
   <source>{0} mm that a slicer keeps open</source>
   <translation>{0} mm, die ein Slicer offen hält</translation>
  </message>
  <message>
   <source>{0} mm² of {1} at a height of {2} mm</source>
   <translation>{0} mm² von {1} in {2} mm Höhe</translation>
  </message>
  <message>
   <source>{0} of the sliced lines lie in none of the bodies: slice the print that the bodies are of, without moving it on the bed.</source>
   <translation>{0} der geslicten Linien liegen in keinem der Körper: den Druck slicen, zu dem die Körper gehören, ohne ihn auf dem Bett zu verschieben.</translation>
  </message>
  <message>
   <source>{0} or {1}</source>
   <translation>{0} oder {1}</translation>
  </message>
  <message>
   <source>{0} places are</source>
   <translation>{0} Stellen</translation>
  </message>
  <message>
   <source>{0} starts</source>
   <translation>{0} beginnt</translation>
  </message>
  <message>
   <source>{0} strains by {1} where it snaps, at hinge {2}, and its material bears about {3}: make Ratio larger or the panels thinner.</source>
   <translation>{0} dehnt sich um {1}, wo sie schnappt, an Scharnier {2}, und ihr Material erträgt etwa {3}: Ratio vergrößern oder die Platten dünner machen.</translation>
  </message>
  <message>
   <source>{0} was made by {1}: only FOLD files exported by Bistable Workbench hold the units that can be read back.</source>
   <translation>{0} stammt von {1}: nur FOLD-Dateien aus diesem Arbeitsbereich enthalten die Einheiten, die sich zurücklesen lassen.</translation>
  </message>
  <message>
   <source>{0} was not written to {1} ({2}): {3}.</source>
   <translation>{0} wurde nicht nach {1} geschrieben ({2}): {3}.</translation>
  </message>
  <message>
   <source>{0} {1} is unknown: choose one of {2}.</source>
   <translation>{0} {1} ist unbekannt: eines von {2} wählen.</translation>
  </message>
  <message>
   <source>{0} {1} mm is not a multiple of the layer height {2} mm, so panels slice to different thicknesses: use {3} mm.</source>
   <translation>{0} {1} mm ist kein Vielfaches der Schichthöhe {2} mm, darum werden die Platten verschieden dick geslict: {3} mm verwenden.</translation>
  </message>
  <message>
   <source>{0}, line {1}: {2} columns; give x, y or x, y, z, or name the columns in the first row.</source>
   <translation>{0}, Zeile {1}: {2} Spalten; x, y oder x, y, z angeben oder die Spalten in der ersten Zeile benennen.</translation>
  </message>
  <message>
   <source>{0}, line {1}: {2} is not a coordinate in mm: correct it.</source>
   <translation>{0}, Zeile {1}: {2} ist keine Koordinate in mm: sie berichtigen.</translation>
  </message>
  <message>
   <source>{0}: its hinges have no play.</source>
   <translation>{0}: ihre Scharniere haben kein Spiel.</translation>
  </message>
  <message>
   <source>{0}: margin {1} or more.</source>
   <translation>{0}: Reserve {1} oder mehr.</translation>
  </message>
  <message>
   <source>{0}: the paper's table does not settle {1}; the value that was set stays.</source>
   <translation>{0}: die Tabelle des Aufsatzes legt {1} nicht fest; der eingestellte Wert bleibt.</translation>
  </message>
  <message>
   <source>{0}: unit {1} has lengths of 0 or less: export it again.</source>
   <translation>{0}: Einheit {1} hat Längen von 0 oder weniger: neu exportieren.</translation>
  </message>
  <message>
   <source>{0}: unit {1} has no ten corners in space: export it again.</source>
   <translation>{0}: Einheit {1} hat keine zehn Ecken im Raum: neu exportieren.</translation>
  </message>
  <message>
   <source>{0}: unit {1} in {2} is broken ({3}): export the file again.</source>
   <translation>{0}: Einheit {1} in {2} ist beschädigt ({3}): die Datei neu exportieren.</translation>
  </message>
  <message>
   <source>{0}: unit {1} is not the symmetric unit of its angles (it is one of a general curve, or the file was changed): only plane and spherical units can be read back.</source>
   <translation>{0}: Einheit {1} ist nicht die symmetrische Einheit ihrer Winkel (sie gehört zu einer allgemeinen Kurve, oder die Datei wurde geändert): nur ebene und sphärische Einheiten lassen sich zurücklesen.</translation>
  </message>
  <message>
   <source>{0}; set {1}, or make FaceThickness or GapLength smaller.</source>
   <translation>{0}; {1} einstellen, oder FaceThickness oder GapLength verkleinern.</translation>
  </message>
  <message>
   <source>{0}{1} are floppy, {2}, and nothing but friction holds the deployed state.</source>
   <translation>{0}{1} sind schlaff, {2}, und nur Reibung hält den entfalteten Zustand.</translation>
  </message>
  <message>
   <source>{0}{1} is floppy, {2}, and nothing but friction holds the deployed state.</source>
   <translation>{0}{1} ist schlaff, {2}, und nur Reibung hält den entfalteten Zustand.</translation>
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
   <source>Curve {}: {:.4g} mm</source>
   <translation>Kurve {}: {:.4g} mm</translation>
  </message>
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
   <source>Make a curve from an SVG, DXF or CSV file, or units from a FOLD file of this workbench</source>
   <translation>Eine Kurve aus einer SVG-, DXF- oder CSV-Datei machen, oder Einheiten aus einer FOLD-Datei dieses Arbeitsbereichs</translation>
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
