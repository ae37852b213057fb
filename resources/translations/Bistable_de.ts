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
