<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>Suture</name>
    <message>
      <location filename="InitGui.py" />
      <source>Close holes with smooth faces, and check how smooth</source>
      <translation>Löcher mit glatten Flächen schließen und prüfen, wie glatt sie sind</translation>
    </message>
    <message>
      <location filename="suture_workbench/api.py" />
      <source>Sew faces</source>
      <translation>Flächen nähen</translation>
    </message>
    <message>
      <location filename="suture_workbench/api.py" />
      <source>{} sewn</source>
      <translation>{} genäht</translation>
    </message>
    <message>
      <location filename="suture_workbench/api.py" />
      <source>No hole lies beside {}.</source>
      <translation>Neben {} liegt kein Loch.</translation>
    </message>
    <message>
      <location filename="suture_workbench/compat.py" />
      <source>{} is no longer there after the object has changed: choose it again.</source>
      <translation>{} gibt es nach der Änderung des Objekts nicht mehr: bitte neu wählen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/exchange.py" />
      <source>The shape that the program has written cannot be read: {}.</source>
      <translation>Die vom Programm geschriebene Form ist nicht lesbar: {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/exchange.py" />
      <source>there is no face in it</source>
      <translation>sie enthält keine Fläche</translation>
    </message>
    <message>
      <location filename="suture_workbench/exporter.py" />
      <source>There is no hole.</source>
      <translation>Es gibt kein Loch.</translation>
    </message>
    <message>
      <location filename="suture_workbench/exporting.py" />
      <source>Export stopped: {} was not written.</source>
      <translation>Export abgebrochen: {} wurde nicht geschrieben.</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Make new faces one with neighbours on the same surface</source>
      <translation>Neue Flächen mit Nachbarn auf derselben Fläche zu einer vereinigen</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Let the neighbours of the holes grow together, where they can, instead of a fill</source>
      <translation>Die Nachbarn der Löcher zusammenwachsen lassen, wo sie das können, statt zu füllen</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Cut a hole in two: auto, or pairs of vertices as 3,7 with blanks between them</source>
      <translation>Ein Loch in zwei teilen: auto, oder Paare von Eckpunkten wie 3,7 mit Leerzeichen dazwischen</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>How far a bridge, and curves over gaps, go on straight: 1 as the gap is wide</source>
      <translation>Wie weit eine Brücke und Kurven über Lücken geradeaus weiterlaufen: 1 wie die Lücke breit ist</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Where no edge names a hole: only holes whose border lies in a plane</source>
      <translation>Wo keine Kante ein Loch nennt: nur Löcher, deren Rand in einer Ebene liegt</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Where no edge names a hole: only holes of a larger diameter; 0: all</source>
      <translation>Wo keine Kante ein Loch nennt: nur Löcher von größerem Durchmesser; 0: alle</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Where no edge names a hole: only holes of a smaller diameter; 0: all</source>
      <translation>Wo keine Kante ein Loch nennt: nur Löcher von kleinerem Durchmesser; 0: alle</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Where no edge names a hole: only holes with so many sides; 0: all</source>
      <translation>Wo keine Kante ein Loch nennt: nur Löcher mit so vielen Seiten; 0: alle</translation>
    </message>
    <message>
      <location filename="suture_workbench/extras.py" />
      <source>Edges, and the face to be tangent to there: Edge3=Face7</source>
      <translation>Kanten, und die Fläche, die dort berührt werden soll: Edge3=Face7</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>{} filled</source>
      <translation>{} gefüllt</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>{} has no base: choose one in its property Base.</source>
      <translation>{} hat keine Basis: wählen Sie eine in der Eigenschaft Base.</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>{} bridged</source>
      <translation>{} überbrückt</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>{} with new faces</source>
      <translation>{} mit neuen Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>{} without faces</source>
      <translation>{} ohne Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>The shape is the last one, not up to date: {}</source>
      <translation>Die Form ist die letzte und nicht auf dem neuesten Stand: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Check continuity</source>
      <translation>Stetigkeit prüfen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>From this angle on an edge is meant to be sharp</source>
      <translation>Ab diesem Winkel ist eine Kante als scharf gemeint</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Export report</source>
      <translation>Bericht exportieren</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Report to look at (*.html);;Table (*.csv);;For programs (*.json)</source>
      <translation>Bericht zum Ansehen (*.html);;Tabelle (*.csv);;Für Programme (*.json)</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>own limits</source>
      <translation>eigene Grenzen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>A report ends in .html, .csv or .json, not {}.</source>
      <translation>Ein Bericht endet auf .html, .csv oder .json, nicht auf {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Finish the open task first.</source>
      <translation>Beenden Sie zuerst die offene Aufgabe.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>Convert files</source>
      <translation>Dateien umwandeln</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>Files to convert</source>
      <translation>Umzuwandelnde Dateien</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>Stopped.</source>
      <translation>Abgebrochen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>Models</source>
      <translation>Modelle</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>{} of {} files written.</source>
      <translation>{} von {} Dateien geschrieben.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>(see tooltip)</source>
      <translation>(siehe Tooltip)</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>near miss</source>
      <translation>knapp verfehlt</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>not measured</source>
      <translation>nicht gemessen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>free edge</source>
      <translation>freie Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>G1 tangent</source>
      <translation>G1 tangential</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>G2 curvature</source>
      <translation>G2 krümmungsstetig</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>G3 change of curvature</source>
      <translation>G3 stetige Krümmungsänderung</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>sharp</source>
      <translation>scharf</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>Edge</source>
      <translation>Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>Class</source>
      <translation>Klasse</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>Gap</source>
      <translation>Spalt</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>Angle</source>
      <translation>Winkel</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>Curvature</source>
      <translation>Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/edges_table.py" />
      <source>Faces</source>
      <translation>Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_list.py" />
      <source>Take away</source>
      <translation>Wegnehmen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_list.py" />
      <source>Takes the rows that are selected out of the list</source>
      <translation>Nimmt die gewählten Zeilen aus der Liste</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_list.py" />
      <source>Bridge gaps by curves</source>
      <translation>Lücken mit Kurven überbrücken</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_list.py" />
      <source>Where edges do not meet, a smooth curve from one to the next closes the border</source>
      <translation>Wo Kanten sich nicht treffen, schließt eine glatte Kurve von einer zur nächsten den Rand</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_list.py" />
      <source>curve</source>
      <translation>Kurve</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_list.py" />
      <source>{}, tangent to {}</source>
      <translation>{}, berührt {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_panel.py" />
      <source>Click the edges around the new face, in any order; with an edge's row selected, a face to be tangent to there.</source>
      <translation>Klicken Sie die Kanten um die neue Fläche an, in beliebiger Reihenfolge; ist die Zeile einer Kante gewählt, eine Fläche, die dort berührt werden soll.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_panel.py" />
      <source>Click the edges of both sides, in any order.</source>
      <translation>Klicken Sie die Kanten beider Seiten an, in beliebiger Reihenfolge.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_panel.py" />
      <source>Click the faces that are to be made anew.</source>
      <translation>Klicken Sie die Flächen an, die neu gemacht werden sollen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/elements_panel.py" />
      <source>Click the faces that are to go.</source>
      <translation>Klicken Sie die Flächen an, die verschwinden sollen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/extras_box.py" />
      <source>any</source>
      <translation>beliebig</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>Keep it</source>
      <translation>Behalten</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>Change something</source>
      <translation>Etwas ändern</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>Replace</source>
      <translation>Ersetzen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>Something went wrong inside Suture: {}. Please report it.</source>
      <translation>In Suture ist etwas schiefgegangen: {}. Bitte melden Sie es.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>Get the program…</source>
      <translation>Programm beschaffen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>The result is far from what was asked for:</source>
      <translation>Das Ergebnis ist weit von dem entfernt, was verlangt war:</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/failures.py" />
      <source>These files are there already:</source>
      <translation>Diese Dateien gibt es schon:</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Tick a hole to fill.</source>
      <translation>Haken Sie ein Loch an.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Looking for holes…</source>
      <translation>Suche nach Löchern…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Working…</source>
      <translation>Wird berechnet…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>No preview.</source>
      <translation>Keine Vorschau.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Hole {} has no edge of the object.</source>
      <translation>Loch {} hat keine Kante des Objekts.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_panel.py" />
      <source>Find holes</source>
      <translation>Löcher finden</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>smooth at every corner</source>
      <translation>glatt an jeder Ecke</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Face{} and Face{} meet at {:.3g}°</source>
      <translation>Face{} und Face{} treffen sich unter {:.3g}°</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Holes</source>
      <translation>Löcher</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Rims, seams and others: no holes</source>
      <translation>Ränder, Nähte und anderes: keine Löcher</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Hole</source>
      <translation>Loch</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Rim</source>
      <translation>Rand</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Seam</source>
      <translation>Naht</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Slit</source>
      <translation>Schlitz</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Doubtful</source>
      <translation>Zweifelhaft</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Sides</source>
      <translation>Seiten</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Size</source>
      <translation>Größe</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Neighbours</source>
      <translation>Nachbarn</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>edge {} (sewn)</source>
      <translation>Kante {} (genäht)</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>There is no shape to work on: open or make one first.</source>
      <translation>Es gibt keine Form zum Bearbeiten: erst eine öffnen oder erzeugen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>{} has no shape. Select a solid, a surface or one of its edges.</source>
      <translation>{} hat keine Form. Einen Körper, eine Fläche oder eine ihrer Kanten wählen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>Several objects are shown: {}. Select the one to work on.</source>
      <translation>Mehrere Objekte sind sichtbar: {}. Das gemeinte auswählen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>{} is a mesh; Suture works on surfaces. Part &gt; Create shape from mesh makes one, which can be selected then.</source>
      <translation>{} ist ein Netz; Suture arbeitet auf Flächen. Part &gt; Form aus Netz erzeugen macht daraus eine, die dann gewählt werden kann.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>{} is a cloud of points: it has no surface to work on.</source>
      <translation>{} ist eine Punktwolke: Sie hat keine Fläche, die bearbeitet werden kann.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>{} has lines only, no face. Select the solid or the surface whose hole they bound.</source>
      <translation>{} hat nur Linien, keine Fläche. Den Körper oder die Fläche wählen, deren Loch sie beranden.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/pick.py" />
      <source>Several objects are selected: {}. Select one of them.</source>
      <translation>Mehrere Objekte sind gewählt: {}. Eines davon wählen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>searched in the usual places</source>
      <translation>an den üblichen Stellen gesucht</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Program suture</source>
      <translation>Programm suture</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>found: {}</source>
      <translation>gefunden: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>The program suture</source>
      <translation>Das Programm suture</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>Bundle or wheel of Suture</source>
      <translation>Bündel oder Wheel von Suture</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>Suture (*.tar.xz *.tar.gz *.zip *.whl)</source>
      <translation>Suture (*.tar.xz *.tar.gz *.zip *.whl)</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>Copied. Paste it into a terminal.</source>
      <translation>Kopiert. In ein Terminal einfügen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>Building…</source>
      <translation>Wird gebaut…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>This addon has no source with it.</source>
      <translation>Bei dieser Erweiterung ist kein Quelltext.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>Found: {} ({}).</source>
      <translation>Gefunden: {} ({}).</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/program_dialog.py" />
      <source>Building failed (exit code {}); the last lines say why.</source>
      <translation>Das Bauen ist gescheitert (Rückgabewert {}); die letzten Zeilen sagen, warum.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/progress.py" />
      <source>Stop</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/progress.py" />
      <source>Stopping…</source>
      <translation>Wird abgebrochen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>How the new face joins at this edge</source>
      <translation>Wie die neue Fläche an dieser Kante anschließt</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>Side</source>
      <translation>Seite</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>Joins</source>
      <translation>Anschluss</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>Reached</source>
      <translation>Erreicht</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>In brackets: not asked for, so no fault.</source>
      <translation>In Klammern: nicht verlangt, also kein Fehler.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>as above</source>
      <translation>wie oben</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>Asked for {}: {}</source>
      <translation>Verlangt {}: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/sides_table.py" />
      <source>as above: {}</source>
      <translation>wie oben: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_box.py" />
      <source>Radius that is red</source>
      <translation>Radius, der rot ist</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_box.py" />
      <source>Own colours</source>
      <translation>Eigene Farben</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_box.py" />
      <source>Zebra stripes</source>
      <translation>Zebrastreifen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>Choose the file.</source>
      <translation>Wählen Sie die Datei.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>Wait until the surface is there.</source>
      <translation>Warten Sie, bis die Fläche da ist.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>The mesh: layers of quads around a hole of three or more sides, in an OBJ file. The surface follows it as a B-spline follows its control points.</source>
      <translation>Das Netz: Schichten von Vierecken um ein Loch mit drei oder mehr Seiten, in einer OBJ-Datei. Die Fläche folgt ihm wie ein B-Spline seinen Kontrollpunkten.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>The problem: polynomials and planes around a hole, in a JSON file. The surface joins them, computed in exact arithmetic.</source>
      <translation>Die Aufgabe: Polynome und Ebenen um ein Loch, in einer JSON-Datei. Die Fläche verbindet sie, in exakter Arithmetik gerechnet.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>quads, or exact where these do not do</source>
      <translation>Vierecke, oder exakt, wo diese nicht genügen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>fitted quads</source>
      <translation>angepasste Vierecke</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/surface_panel.py" />
      <source>exact cells</source>
      <translation>exakte Zellen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Points to pass through</source>
      <translation>Punkte, durch die es gehen soll</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Text (*.csv *.txt *.xyz);;All files (*)</source>
      <translation>Text (*.csv *.txt *.xyz);;Alle Dateien (*)</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>{} holds no point x, y, z.</source>
      <translation>{} enthält keinen Punkt x, y, z.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Select vertices or edges first.</source>
      <translation>Erst Punkte oder Kanten auswählen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>{} points</source>
      <translation>{} Punkte</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Line {} of {} is no point x, y, z: {}</source>
      <translation>Zeile {} von {} ist kein Punkt x, y, z: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/widgets.py" />
      <source>Largest gap</source>
      <translation>Größter Spalt</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/widgets.py" />
      <source>Largest angle of tangent joins</source>
      <translation>Größter Winkel tangentialer Anschlüsse</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/widgets.py" />
      <source>Largest curvature mismatch of G2 joins</source>
      <translation>Größte Krümmungsabweichung von G2-Anschlüssen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/zebra_panel.py" />
      <source>Zebra and curvature</source>
      <translation>Zebra und Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/install.py" />
      <source>{} is neither a bundle (.tar.xz) nor a wheel (.whl).</source>
      <translation>{} ist weder ein Bündel (.tar.xz) noch ein Wheel (.whl).</translation>
    </message>
    <message>
      <location filename="suture_workbench/install.py" />
      <source>{} is not Suture, or does not run here: {}</source>
      <translation>{} ist nicht Suture oder läuft hier nicht: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/install.py" />
      <source>{} holds no program bin/{}.</source>
      <translation>{} enthält kein Programm bin/{}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/install.py" />
      <source>{} does not run: {}</source>
      <translation>{} läuft nicht: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/install.py" />
      <source>{} cannot be unpacked: {}</source>
      <translation>{} lässt sich nicht entpacken: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/job.py" />
      <source>it said nothing</source>
      <translation>es sagte nichts</translation>
    </message>
    <message>
      <location filename="suture_workbench/job.py" />
      <source>The program's answer cannot be read (exit code {}: {}). Is {} really Suture?</source>
      <translation>Die Antwort des Programms ist nicht lesbar (Exitcode {}: {}). Ist {} wirklich Suture?</translation>
    </message>
    <message>
      <location filename="suture_workbench/job.py" />
      <source>The program crashed ({}). FreeCAD and your model are unharmed.</source>
      <translation>Das Programm ist abgestürzt ({}). FreeCAD und Ihr Modell sind unversehrt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/job.py" />
      <source>The program {} could not be started: {}.</source>
      <translation>Das Programm {} ließ sich nicht starten: {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/places.py" />
      <source>Points to pass through are vertices and edges, not faces.</source>
      <translation>Hindurch geht es durch Punkte und Kanten, nicht durch Flächen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/places.py" />
      <source>{} has no shape.</source>
      <translation>{} hat keine Form.</translation>
    </message>
    <message>
      <location filename="suture_workbench/program.py" />
      <source>Install it, or say where it is: Edit &gt; Preferences &gt; Suture &gt; Get the program.</source>
      <translation>Installieren oder angeben, wo es ist: Bearbeiten &gt; Einstellungen &gt; Suture &gt; Programm beschaffen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/program.py" />
      <source>The program 'suture', which does the work, was not found.</source>
      <translation>Das Programm 'suture', das die Arbeit macht, wurde nicht gefunden.</translation>
    </message>
    <message>
      <location filename="suture_workbench/program.py" />
      <source>Build it by running this in a terminal:
    {} --version
or install it, or say where it is: Edit &gt; Preferences &gt; Suture &gt; Get the program.</source>
      <translation>Zum Bauen in einem Terminal ausführen:
    {} --version
oder installieren oder angeben, wo es ist: Bearbeiten &gt; Einstellungen &gt; Suture &gt; Programm beschaffen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/program.py" />
      <source>There is no program {}. Correct the path in Edit &gt; Preferences &gt; Suture, or clear it to have the usual places searched.</source>
      <translation>Es gibt kein Programm {}. Berichtigen Sie den Pfad unter Bearbeiten &gt; Einstellungen &gt; Suture, oder leeren Sie ihn, damit an den üblichen Orten gesucht wird.</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>The shape, and an edge of each hole to fill; no edge: all holes</source>
      <translation>Die Form und je eine Kante der zu füllenden Löcher; ohne Kante: alle Löcher</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>What is filled: holes, a border of chosen edges, a bridge, faces that go</source>
      <translation>Was gefüllt wird: Löcher, ein Rand aus gewählten Kanten, eine Brücke, entfernte Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Edges of other objects that belong to the border or the bridge, and faces to be tangent to</source>
      <translation>Kanten anderer Objekte, die zum Rand oder zur Brücke gehören, und Flächen, die berührt werden sollen</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Bridge gaps between the edges of a border by curves</source>
      <translation>Lücken zwischen den Kanten eines Randes mit Kurven überbrücken</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>The fill method; auto tries what applies and keeps the best</source>
      <translation>Das Füllverfahren; auto probiert, was infrage kommt, und behält das beste</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Options of the method's own, key=value each</source>
      <translation>Eigene Einstellungen des Verfahrens, je Schlüssel=Wert</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>How the new faces join: G0 position, G1 tangent, G2 curvature</source>
      <translation>Wie die neuen Flächen anschließen: G0 Position, G1 Tangente, G2 Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Where the very surface that was lost is looked for: all faces, the neighbours, nowhere</source>
      <translation>Wo genau die verlorene Fläche gesucht wird: auf allen Flächen, auf den Nachbarn, nirgends</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>How much auto tries: what is quick, some seconds more, or all that may come nearer</source>
      <translation>Wie viel auto versucht: was schnell geht, einige Sekunden mehr, oder alles, was näher kommen kann</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Edges that are to be met in position only</source>
      <translation>Kanten, an denen nur die Position stimmen soll</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Edges that are to be met tangentially</source>
      <translation>Kanten, an denen tangential angeschlossen wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Edges that are to be met with equal curvature</source>
      <translation>Kanten, an denen mit gleicher Krümmung angeschlossen wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>The chosen loops bound one face: the others are islands in the first</source>
      <translation>Die gewählten Schleifen begrenzen eine Fläche: die übrigen sind Inseln in der ersten</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Fill the rims of open sheets and doubtful loops too</source>
      <translation>Auch die Ränder offener Flächen und zweifelhafte Schleifen füllen</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Keep a fill that is bad: folded, clashing, far off</source>
      <translation>Eine schlechte Füllung behalten: gefaltet, durchdringend, weit daneben</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Vertices and edges that the new face passes through, and faces to be tangent to there</source>
      <translation>Punkte und Kanten, durch die die neue Fläche geht, und Flächen, die dort berührt werden sollen</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Points that the new face passes through, seen from the placement of the base</source>
      <translation>Punkte, durch die die neue Fläche geht, von der Platzierung der Basis aus gesehen</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Largest curvature mismatch of G2 joins in percent</source>
      <translation>Größte Krümmungsabweichung von G2-Anschlüssen in Prozent</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>What came of it</source>
      <translation>Was daraus wurde</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>No free edge is left</source>
      <translation>Keine freie Kante ist übrig</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>All holes are filled and meet the tolerances</source>
      <translation>Alle Löcher sind gefüllt und halten die Toleranzen ein</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>The numbers of the new faces</source>
      <translation>Die Nummern der neuen Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>The whole report of the program (JSON)</source>
      <translation>Der ganze Bericht des Programms (JSON)</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>A point on each edge and face that is named, to know it by when numbers change</source>
      <translation>Ein Punkt auf jeder genannten Kante und Fläche, an dem sie zu erkennen ist, wenn Nummern sich ändern</translation>
    </message>
    <message>
      <location filename="suture_workbench/properties.py" />
      <source>Tells whether the shape is up to date</source>
      <translation>Sagt, ob die Form auf dem neuesten Stand ist</translation>
    </message>
    <message>
      <location filename="suture_workbench/readout.py" />
      <source>flat</source>
      <translation>eben</translation>
    </message>
    <message>
      <location filename="suture_workbench/readout.py" />
      <source>{}{}: nothing can be measured at this point.</source>
      <translation>{}{}: An diesem Punkt lässt sich nichts messen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/readout.py" />
      <source>Edge{} here: gap {:.2g} mm</source>
      <translation>Edge{} hier: Spalt {:.2g} mm</translation>
    </message>
    <message>
      <location filename="suture_workbench/readout.py" />
      <source>Face{} here: radii {}</source>
      <translation>Face{} hier: Radien {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/readout.py" />
      <source>, angle {:.3g}°</source>
      <translation>, Winkel {:.3g}°</translation>
    </message>
    <message>
      <location filename="suture_workbench/readout.py" />
      <source>, radii across {}</source>
      <translation>, Radien quer dazu {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>proven: nowhere above {:.3g} {}</source>
      <translation>bewiesen: nirgends über {:.3g} {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>not proven: {}</source>
      <translation>nicht bewiesen: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>The program's answer is not as expected ({}: {}). Is it too old?</source>
      <translation>Die Antwort des Programms ist anders als erwartet ({}: {}). Ist es zu alt?</translation>
    </message>
    <message>
      <location filename="suture_workbench/tasks.py" />
      <source>There is no loose face to sew.</source>
      <translation>Es gibt keine lose Fläche zum Nähen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/tasks.py" />
      <source>Edge{} is gone after the loose faces were sewn.</source>
      <translation>Edge{} ist weg, seit die losen Flächen zusammengenäht wurden.</translation>
    </message>
    <message>
      <location filename="suture_workbench/tasks.py" />
      <source>Edge{} bounds no hole.</source>
      <translation>Edge{} begrenzt kein Loch.</translation>
    </message>
    <message>
      <location filename="suture_workbench/tasks.py" />
      <source>Given up after {} s, the limit set in the preferences.</source>
      <translation>Nach {} s aufgegeben, der Grenze aus den Einstellungen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Fill holes</source>
      <translation>Löcher füllen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Your own limits, below.</source>
      <translation>Eigene Grenzen, siehe unten.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The shape is not valid (Part &gt; Check geometry says where).</source>
      <translation>Die Form ist ungültig (Part &gt; Geometrie prüfen sagt, wo).</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The shape is closed and valid.</source>
      <translation>Die Form ist geschlossen und gültig.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The shape is open: {} free edge is left.</source>
      <translation>Die Form ist offen: {} freie Kante bleibt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The shape is open: {} free edges are left.</source>
      <translation>Die Form ist offen: {} freie Kanten bleiben.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {}, Edge{}: {}.</source>
      <translation>Loch {}, Edge{}: {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {}: {}.</source>
      <translation>Loch {}: {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Patch from a mesh</source>
      <translation>Fläche aus einem Netz</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Algebraic surface</source>
      <translation>Algebraische Fläche</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Tangent wherever the neighbours allow it, else in position only.</source>
      <translation>Tangential, wo die Nachbarn es erlauben, sonst nur in der Lage.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Position: no gap, but a visible edge.</source>
      <translation>Lage: kein Spalt, aber eine sichtbare Kante.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Tangent: no edge is seen; reflections have a kink.</source>
      <translation>Tangential: keine sichtbare Kante; Spiegelungen haben einen Knick.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Equal curvature: reflections run on smoothly.</source>
      <translation>Gleiche Krümmung: Spiegelungen laufen glatt weiter.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Among the surfaces of all faces, their offsets and copies.</source>
      <translation>Unter den Flächen des ganzen Modells, ihren Abstandsflächen und Kopien.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>On the surfaces around the hole only.</source>
      <translation>Nur auf den Flächen rings um das Loch.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Nowhere: each hole is filled smoothly.</source>
      <translation>Nirgends: Jedes Loch wird glatt gefüllt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>in the whole model</source>
      <translation>im ganzen Modell</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>around the hole</source>
      <translation>um das Loch herum</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>not at all</source>
      <translation>gar nicht</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>auto tries what is quick only.</source>
      <translation>auto versucht nur, was schnell geht.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>auto takes some seconds more for a hole where it has to.</source>
      <translation>auto nimmt sich einige Sekunden mehr für ein Loch, wo es nötig ist.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>auto tries all that can come nearer, however long it takes.</source>
      <translation>auto versucht alles, was näher kommen kann, wie lange es auch dauert.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>quick</source>
      <translation>schnell</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>normal</source>
      <translation>normal</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>thorough</source>
      <translation>gründlich</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Click a row to see it.</source>
      <translation>Eine Zeile anklicken, um es zu sehen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Edge numbers are those after the loose faces were sewn.</source>
      <translation>Die Kantennummern gelten nach dem Zusammennähen der losen Flächen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The tolerances are not met.</source>
      <translation>Die Toleranzen sind nicht eingehalten.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Merge with equal neighbours</source>
      <translation>Mit gleichen Nachbarn vereinigen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Let the neighbours grow together</source>
      <translation>Nachbarn zusammenwachsen lassen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Cut in two</source>
      <translation>In zwei teilen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Tension</source>
      <translation>Spannung</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Planar holes only</source>
      <translation>Nur ebene Löcher</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Larger than</source>
      <translation>Größer als</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Smaller than</source>
      <translation>Kleiner als</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>With so many sides</source>
      <translation>Mit so vielen Seiten</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} loose faces sewn, gaps up to {:.2g} mm; {} free edges are left.</source>
      <translation>{} lose Flächen genäht, Spalte bis {:.2g} mm; {} freie Kanten bleiben.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Tries what applies, measures each result, and keeps the best.</source>
      <translation>Versucht, was in Frage kommt, misst jedes Ergebnis und behält das beste.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Continues the surface on which all neighbours lie. Exact.</source>
      <translation>Setzt die Fläche fort, auf der alle Nachbarn liegen. Exakt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Gives back the very face that was lost: cylinder, torus, copy of another…</source>
      <translation>Gibt genau die verlorene Fläche zurück: Zylinder, Torus, Kopie einer anderen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Closes a hole that lies in a plane by a flat face. Exact.</source>
      <translation>Schließt ein ebenes Loch durch eine ebene Fläche. Exakt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The surface whose curvature varies least, as one freeform face.</source>
      <translation>Die Fläche, deren Krümmung sich am wenigsten ändert, als eine Freiformfläche.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Surfaces given by polynomials, between planes, quadrics and tori.</source>
      <translation>Durch Polynome gegebene Flächen zwischen Ebenen, Quadriken und Tori.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>A disc-like surface whose spokes run from the rim to the middle.</source>
      <translation>Eine scheibenartige Fläche, deren Speichen vom Rand zur Mitte laufen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>A tube around the hole that closes in a point, as one face.</source>
      <translation>Ein Schlauch um das Loch, der sich in einem Punkt schließt, als eine Fläche.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>A patch of many sides: strips along the rim, a star in the middle.</source>
      <translation>Ein Flicken mit vielen Seiten: Streifen am Rand, ein Stern in der Mitte.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>OpenCASCADE's own filling, as FreeCAD's Surface &gt; Filling uses it.</source>
      <translation>Die Füllung von OpenCASCADE, wie sie Surface &gt; Füllen in FreeCAD benutzt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Fill from edges</source>
      <translation>Aus Kanten füllen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Bridge</source>
      <translation>Überbrücken</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Replace faces</source>
      <translation>Flächen ersetzen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Remove faces</source>
      <translation>Flächen entfernen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The limits of CATIA's Connect Checker; the strictest.</source>
      <translation>Die Grenzen des Connect Checkers von CATIA; die strengsten.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>VDA 4955, the car makers' rule for freeform surfaces.</source>
      <translation>VDA 4955, die Regel der Autobauer für Freiformflächen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Autodesk Alias: below 0.1° a break in tangency is not seen.</source>
      <translation>Autodesk Alias: Unter 0,1° sieht man keinen Knick.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Rhino's tolerances of a new document.</source>
      <translation>Die Toleranzen eines neuen Dokuments von Rhino.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The limits that OpenCASCADE itself uses.</source>
      <translation>Die Grenzen, die OpenCASCADE selbst benutzt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} hole.</source>
      <translation>{} Loch.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} holes.</source>
      <translation>{} Löcher.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} other open border, which is no hole.</source>
      <translation>{} anderer offener Rand, der kein Loch ist.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} other open borders, which are no holes.</source>
      <translation>{} andere offene Ränder, die keine Löcher sind.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} hole filled.</source>
      <translation>{} Loch gefüllt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} holes filled.</source>
      <translation>{} Löcher gefüllt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Largest gap {:.2g} mm</source>
      <translation>Größter Spalt {:.2g} mm</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {} recognised: {}.</source>
      <translation>Loch {} wiedererkannt: {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>gap</source>
      <translation>Spalt</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>angle</source>
      <translation>Winkel</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>curvature mismatch</source>
      <translation>Unterschied der Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>crease inside the new face</source>
      <translation>Knick in der neuen Fläche</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>the new face cuts another one, to a depth of</source>
      <translation>die neue Fläche schneidet eine andere, Tiefe</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>bulges: times the area of a stretched surface</source>
      <translation>bläht sich auf: das Vielfache der Fläche einer gespannten Haut</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>tolerance of the edge grown to</source>
      <translation>Toleranz der Kante gewachsen auf</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>tangency given up, angle</source>
      <translation>Tangentialität aufgegeben, Winkel</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>distance of a point to be passed</source>
      <translation>Abstand eines Punktes, durch den sie gehen soll</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>angle to the normal wanted at a point,</source>
      <translation>Winkel zur gewünschten Normalen in einem Punkt,</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} {:.3g}{} (at most {:.3g})</source>
      <translation>{} {:.3g}{} (höchstens {:.3g})</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>the new face folds</source>
      <translation>die neue Fläche faltet sich</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>the new face lies on another one</source>
      <translation>die neue Fläche liegt auf einer anderen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>an edge of the new face is open</source>
      <translation>eine Kante der neuen Fläche ist offen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>could not be measured</source>
      <translation>konnte nicht gemessen werden</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>the shape is not valid</source>
      <translation>die Form ist ungültig</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>the tolerances are not met</source>
      <translation>die Toleranzen sind nicht eingehalten</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} edge is neither smooth nor sharp: a near miss.</source>
      <translation>{} Kante ist weder glatt noch scharf: knapp verfehlt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} edges are neither smooth nor sharp: near misses.</source>
      <translation>{} Kanten sind weder glatt noch scharf: knapp verfehlt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} edge could not be measured.</source>
      <translation>{} Kante konnte nicht gemessen werden.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} edges could not be measured.</source>
      <translation>{} Kanten konnten nicht gemessen werden.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The shape is open: {} free edge.</source>
      <translation>Die Form ist offen: {} freie Kante.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The shape is open: {} free edges.</source>
      <translation>Die Form ist offen: {} freie Kanten.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} faces, largest gap {:.2g} mm, largest angle {:.2g}°.</source>
      <translation>{} Flächen, größter Spalt {:.2g} mm, größter Winkel {:.2g}°.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Closing point</source>
      <translation>Schlusspunkt</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Normal there</source>
      <translation>Normale dort</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Fairness</source>
      <translation>Glattheit</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Tangents there</source>
      <translation>Tangenten dort</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Let it move</source>
      <translation>Beweglich</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Curvature there</source>
      <translation>Krümmung dort</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Border</source>
      <translation>Rand</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Border's joins</source>
      <translation>Randanschluss</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Layers</source>
      <translation>Lagen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Smoothness inside</source>
      <translation>Glattheit innen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Size of middle</source>
      <translation>Größe der Mitte</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Middle</source>
      <translation>Mitte</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Degree</source>
      <translation>Grad</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Cells</source>
      <translation>Zellen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Axis</source>
      <translation>Achse</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Cut branches</source>
      <translation>Äste kappen</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Drop flat nodes</source>
      <translation>Flache Knoten weg</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>gap {:.3g} mm (at most {:.3g})</source>
      <translation>Spalt {:.3g} mm (höchstens {:.3g})</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>angle {:.3g}° (at most {:.3g})</source>
      <translation>Winkel {:.3g}° (höchstens {:.3g})</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>curvature differs by {:.3g} % (at most {:.3g})</source>
      <translation>Krümmung weicht um {:.3g} % ab (höchstens {:.3g})</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>, largest angle where tangent was asked for {:.2g}°</source>
      <translation>, größter Winkel, wo tangential verlangt war, {:.2g}°</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {}, inside: {}.</source>
      <translation>Loch {}, innen: {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} edge measured: it is smooth or sharp.</source>
      <translation>{} Kante gemessen: Sie ist glatt oder scharf.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} edges measured: all are smooth or sharp.</source>
      <translation>{} Kanten gemessen: Alle sind glatt oder scharf.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Proven bounds for {} of {} edges.</source>
      <translation>Bewiesene Schranken für {} von {} Kanten.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>{} sides, {} layers of quads, smooth of order {} inside.</source>
      <translation>{} Seiten, {} Schichten von Vierecken, innen glatt von der Ordnung {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Polynomials of degree {} in {} cells, smooth of order {}.</source>
      <translation>Polynome vom Grad {} in {} Zellen, glatt von der Ordnung {}.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The faces lie within {:.2g} mm and {:.2g}° of them.</source>
      <translation>Die Flächen weichen davon höchstens {:.2g} mm und {:.2g}° ab.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {} passes {} points within {:.2g} mm.</source>
      <translation>Loch {}: {} Punkte auf {:.2g} mm genau getroffen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {}{} was refused: {}</source>
      <translation>Loch {}{} wurde abgelehnt: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>Hole {} was refused and stays open.</source>
      <translation>Loch {} wurde abgelehnt und bleibt offen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/words.py" />
      <source>The middle is fitted to within {:.2g} of the mesh's size.</source>
      <translation>Die Mitte ist bis auf {:.2g} der Größe des Netzes angepasst.</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Limits</source>
      <translation>Grenzen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Whose limits decide what counts as smooth</source>
      <translation>Wessen Grenzen entscheiden, was als glatt gilt</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Own limits</source>
      <translation>Eigene Grenzen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Largest angle</source>
      <translation>Größter Winkel</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Largest difference of curvature at G2 joins, in percent of the larger one</source>
      <translation>Größter Unterschied der Krümmung an G2-Anschlüssen, in Prozent der größeren</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Sharp from</source>
      <translation>Scharf ab</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Selected edges only</source>
      <translation>Nur die gewählten Kanten</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Certified bounds</source>
      <translation>Bewiesene Schranken</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Bound gap and angle along the whole edge by interval arithmetic instead of sampling it. Takes longer</source>
      <translation>Spalt und Winkel entlang der ganzen Kante durch Intervallrechnung begrenzen, statt an Stellen zu messen. Dauert länger</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Click an edge or a face in the view to read off gap, angle and radius there.</source>
      <translation>Eine Kante oder Fläche in der Ansicht anklicken, um dort Spalt, Winkel und Radius abzulesen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Curvature combs</source>
      <translation>Krümmungskämme</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Show how both faces bend across the chosen edge</source>
      <translation>Zeigen, wie sich beide Flächen quer zur gewählten Kante krümmen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/check.ui" />
      <source>Export report…</source>
      <translation>Bericht exportieren…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/convert.ui" />
      <source>Choose files…</source>
      <translation>Dateien wählen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/convert.ui" />
      <source>To</source>
      <translation>Nach</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/convert.ui" />
      <source>Sew loose faces</source>
      <translation>Lose Flächen zusammennähen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/convert.ui" />
      <source>Convert</source>
      <translation>Umwandeln</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Method</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>How the new face is made. auto tries what applies and keeps the best</source>
      <translation>Wie die neue Fläche entsteht. auto versucht, was in Frage kommt, und behält das beste</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>How smoothly the new face meets its neighbours</source>
      <translation>Wie glatt die neue Fläche an ihre Nachbarn anschließt</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Preview</source>
      <translation>Vorschau</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Show the new faces before they are made</source>
      <translation>Die neuen Flächen zeigen, bevor sie erzeugt werden</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Tolerances</source>
      <translation>Toleranzen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>More</source>
      <translation>Mehr</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>One face with islands</source>
      <translation>Eine Fläche mit Inseln</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>The ticked loops bound one face: the first is its rim, the others are islands in it</source>
      <translation>Die angehakten Ränder begrenzen eine Fläche: Der erste ist ihr Rand, die anderen sind Inseln darin</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Recognise the lost face</source>
      <translation>Verlorene Fläche erkennen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Where the very surface that was lost is looked for</source>
      <translation>Wo genau die verlorene Fläche gesucht wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Effort of auto</source>
      <translation>Aufwand von auto</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>How much auto tries where nothing is within tolerance at once</source>
      <translation>Wie viel auto versucht, wo nicht sogleich etwas in der Toleranz ist</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/fill.ui" />
      <source>Of this method</source>
      <translation>Von diesem Verfahren</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/holes.ui" />
      <source>Fill ticked holes…</source>
      <translation>Angehakte Löcher füllen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>Largest curvature mismatch</source>
      <translation>Größte Krümmungsabweichung</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>Default method</source>
      <translation>Übliches Verfahren</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>The fill method to begin with</source>
      <translation>Das Füllverfahren, mit dem begonnen wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>Show a preview unasked</source>
      <translation>Vorschau ungefragt zeigen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>Time limit</source>
      <translation>Zeitgrenze</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/preferences.ui" />
      <source>Give a run up after so long</source>
      <translation>Einen Lauf nach so langer Zeit aufgeben</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>The workbench needs the program suture, which does the work. It is free and comes from the same project.</source>
      <translation>Der Arbeitsbereich braucht das Programm suture, das die Arbeit tut. Es ist frei und stammt aus demselben Projekt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>Install…</source>
      <translation>Installieren…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>From a downloaded bundle (.tar.xz) or wheel (.whl)</source>
      <translation>Aus einem heruntergeladenen Bündel (.tar.xz) oder Wheel (.whl)</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>a downloaded bundle or wheel; no root, no network</source>
      <translation>ein heruntergeladenes Bündel oder Wheel; ohne Root, ohne Netz</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>Locate…</source>
      <translation>Suchen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>If it is somewhere on this computer</source>
      <translation>Wenn es irgendwo auf diesem Rechner ist</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>a program that is there already</source>
      <translation>ein Programm, das schon da ist</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>Build</source>
      <translation>Bauen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>Runs the script suture of the addon</source>
      <translation>Führt das Skript suture der Erweiterung aus</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>from this addon's source: some minutes, installs Debian packages</source>
      <translation>aus dem Quelltext dieser Erweiterung: einige Minuten, installiert Debian-Pakete</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/program.ui" />
      <source>Copy command</source>
      <translation>Befehl kopieren</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>Show</source>
      <translation>Anzeige</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>Stripes</source>
      <translation>Streifen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>How many stripes: more are narrower</source>
      <translation>Wie viele Streifen: mehr sind schmaler</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>Direction</source>
      <translation>Richtung</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>Turns the stripes</source>
      <translation>Dreht die Streifen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>Red from radius</source>
      <translation>Rot ab Radius</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface.ui" />
      <source>Blue is flat; red is bent to this radius or more tightly.</source>
      <translation>Blau ist eben; Rot ist mit diesem Radius oder enger gekrümmt.</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface_file.ui" />
      <source>Choose the file…</source>
      <translation>Datei wählen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface_file.ui" />
      <source>How many derivatives agree: 1 tangent, 2 curvature</source>
      <translation>Wie viele Ableitungen übereinstimmen: 1 Tangente, 2 Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface_file.ui" />
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/surface_file.ui" />
      <source>How far the innermost control points reach in the parameters</source>
      <translation>Wie weit die innersten Kontrollpunkte in den Parametern reichen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/through.ui" />
      <source>The new face passes through</source>
      <translation>Die neue Fläche geht durch</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/through.ui" />
      <source>Add selected</source>
      <translation>Gewählte hinzufügen</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/through.ui" />
      <source>Select vertices or edges, of a sketch for example, then click here</source>
      <translation>Wählen Sie Punkte oder Kanten, etwa einer Skizze, und klicken Sie dann hier</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/through.ui" />
      <source>From file…</source>
      <translation>Aus Datei…</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/through.ui" />
      <source>Points from a text file with x, y, z on each line</source>
      <translation>Punkte aus einer Textdatei mit x, y, z auf jeder Zeile</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/through.ui" />
      <source>Clear</source>
      <translation>Leeren</translation>
    </message>
    <message>
      <location filename="suture_workbench/resources/ui/zebra.ui" />
      <source>What is shown stays when this panel is closed. The command takes it away again.</source>
      <translation>Was gezeigt wird, bleibt, wenn dieses Feld geschlossen wird. Der Befehl nimmt es wieder weg.</translation>
    </message>
  </context>
  <context>
    <name>Suture_FindHoles</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Find holes…</source>
      <translation>Löcher finden…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>List the holes of a shape, show them, choose which to fill</source>
      <translation>Die Löcher einer Form auflisten, zeigen und zum Füllen auswählen</translation>
    </message>
  </context>
  <context>
    <name>Suture_Fill</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Fill holes…</source>
      <translation>Löcher füllen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Fill holes with smooth faces: at the selected edges or faces, or all of the shape</source>
      <translation>Löcher mit glatten Flächen füllen: an den gewählten Kanten oder Flächen, oder alle der Form</translation>
    </message>
  </context>
  <context>
    <name>Suture_FillEdges</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Fill from edges…</source>
      <translation>Aus Kanten füllen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Make a smooth face over the selected edges: rims of one or more objects, sketches, wires</source>
      <translation>Macht eine glatte Fläche über den gewählten Kanten: Ränder eines oder mehrerer Objekte, Skizzen, Drähte</translation>
    </message>
  </context>
  <context>
    <name>Suture_Bridge</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Bridge…</source>
      <translation>Überbrücken…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Join two edges, rims or bodies by a smooth face</source>
      <translation>Verbindet zwei Kanten, Ränder oder Körper durch eine glatte Fläche</translation>
    </message>
  </context>
  <context>
    <name>Suture_ReplaceFaces</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Replace faces…</source>
      <translation>Flächen ersetzen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Take the selected faces away, and fill what they leave anew</source>
      <translation>Nimmt die gewählten Flächen weg und füllt neu, was sie hinterlassen</translation>
    </message>
  </context>
  <context>
    <name>Suture_RemoveFaces</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Remove faces…</source>
      <translation>Flächen entfernen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Take the selected faces away, and let their neighbours grow together: an edge where a fillet was</source>
      <translation>Nimmt die gewählten Flächen weg und lässt ihre Nachbarn zusammenwachsen: eine Kante, wo eine Rundung war</translation>
    </message>
  </context>
  <context>
    <name>Suture_Sew</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Sew faces</source>
      <translation>Flächen nähen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Join the loose faces of a shape along their common edges</source>
      <translation>Die losen Flächen einer Form an ihren gemeinsamen Kanten verbinden</translation>
    </message>
  </context>
  <context>
    <name>Suture_Check</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Check continuity…</source>
      <translation>Stetigkeit prüfen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Measure gap, angle and curvature along every edge of a shape</source>
      <translation>Spalt, Winkel und Krümmung an jeder Kante einer Form messen</translation>
    </message>
  </context>
  <context>
    <name>Suture_Zebra</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Zebra stripes</source>
      <translation>Zebrastreifen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Show reflected stripes on the selected shape, or take them away</source>
      <translation>Gespiegelte Streifen auf der gewählten Form zeigen oder wegnehmen</translation>
    </message>
  </context>
  <context>
    <name>Suture_Combs</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Curvature combs</source>
      <translation>Krümmungskämme</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Show how both faces bend at the selected edges, or take the combs away</source>
      <translation>Zeigen, wie sich beide Flächen an den gewählten Kanten krümmen, oder die Kämme wegnehmen</translation>
    </message>
  </context>
  <context>
    <name>Suture_Patch</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Patch from a mesh…</source>
      <translation>Fläche aus einem Netz…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Make a smooth many-sided surface from a control mesh of quads, an OBJ file</source>
      <translation>Eine glatte vielseitige Fläche aus einem Kontrollnetz von Vierecken machen, einer OBJ-Datei</translation>
    </message>
  </context>
  <context>
    <name>Suture_Algebraic</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Algebraic surface…</source>
      <translation>Algebraische Fläche…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Make the surface that joins others given by polynomials, in a JSON file</source>
      <translation>Die Fläche machen, die andere, durch Polynome gegebene verbindet, in einer JSON-Datei</translation>
    </message>
  </context>
  <context>
    <name>Suture_Convert</name>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Convert files…</source>
      <translation>Dateien umwandeln…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Fill the holes of files on disk, or convert them, without opening them</source>
      <translation>Die Löcher von Dateien füllen oder sie umwandeln, ohne sie zu öffnen</translation>
    </message>
  </context>
  <context>
    <name>Suture_program</name>
    <message>
      <location filename="program.txt" />
      <source>its edges lie on each other and belong to one face</source>
      <translation>seine Kanten liegen aufeinander und gehören zu einer Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>all its edges lie on edges of other faces within {0}</source>
      <translation>alle seine Kanten liegen auf Kanten anderer Flächen, bis auf {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} of its {1} edges lie on edges of the same shell within {2}: sew these first</source>
      <translation>{0} seiner {1} Kanten liegen auf Kanten derselben Schale, bis auf {2}: nähen Sie diese zuerst</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the shell turns {0} degrees along it, a flat sheet 360: the shell lies around it or closes up behind it</source>
      <translation>die Schale dreht sich daran um {0} Grad, ein flaches Blech um 360: sie liegt darum herum oder schließt sich dahinter</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the shell turns {0} degrees along it, a flat sheet 360, and has {1} times the area that it spans: it bounds an open sheet</source>
      <translation>die Schale dreht sich daran um {0} Grad, ein flaches Blech um 360, und hat das {1}-fache der umspannten Fläche: es begrenzt ein offenes Blech</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the shell turns {0} degrees along it, a flat sheet 360, and has {1} times the area that it spans: a body with an opening</source>
      <translation>die Schale dreht sich daran um {0} Grad, ein flaches Blech um 360, und hat das {1}-fache der umspannten Fläche: ein Körper mit einer Öffnung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>its edges share no vertex where it should go on</source>
      <translation>seine Kanten haben keinen gemeinsamen Punkt, wo es weitergehen sollte</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>it runs along an edge that an odd number of faces share, or along half a seam</source>
      <translation>es läuft an einer Kante entlang, die eine ungerade Zahl von Flächen teilt, oder an einer halben Naht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>its shell has only one side, like a Moebius band</source>
      <translation>seine Schale hat nur eine Seite, wie ein Möbiusband</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>but the file says that its shell bounds a solid</source>
      <translation>doch die Datei sagt, dass seine Schale einen Körper begrenzt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} of its edges lie on another shell</source>
      <translation>{0} seiner Kanten liegen auf einer anderen Schale</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the file turns the faces of {0} of its edges against the rest of the shell</source>
      <translation>die Datei dreht die Flächen an {0} seiner Kanten gegen den Rest der Schale</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no shape to find holes in</source>
      <translation>es gibt keine Form, in der Löcher zu finden wären</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>finding holes</source>
      <translation>sucht Löcher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the loops lie in one plane, one inside the other, and turn against each other: they bound one missing plane face</source>
      <translation>die Ränder liegen in einer Ebene, einer im anderen, und laufen gegeneinander: sie begrenzen eine fehlende ebene Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two circles about one axis whose neighbours meet equally far from both: the fillet between them is missing</source>
      <translation>zwei Kreise um eine Achse, deren Nachbarn sich gleich weit von beiden treffen: die Rundung dazwischen fehlt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two circles about one axis: one band between them or a disc in each would close the shape</source>
      <translation>zwei Kreise um eine Achse: ein Band dazwischen oder eine Scheibe in jedem würde die Form schließen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: within tolerance</source>
      <translation>{0}: in der Toleranz</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: {1} times the tolerance</source>
      <translation>{0}: das {1}-fache der Toleranz</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>gap {0}, angle {1} deg, curvature {2} %</source>
      <translation>Spalt {0}, Winkel {1} Grad, Krümmung {2} %</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} x {1} poles</source>
      <translation>{0} x {1} Pole</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a finer net would take too much computing: --effort thorough may come nearer</source>
      <translation>ein feineres Netz würde zu viel rechnen: mit Aufwand „thorough“ kommt sie vielleicht näher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the lifted faces miss their guide by {0} times what is wanted: they may meet at larger angles</source>
      <translation>die angehobenen Flächen verfehlen ihre Leitfläche um das {0}-Fache des Gewünschten: sie können sich unter größeren Winkeln treffen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the net of {0} x {1} poles is not finite after {2} steps</source>
      <translation>das Netz mit {0} x {1} Polen ist nach {2} Schritten nicht endlich</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: no finite point, normal, tangent across and curvature at {1}</source>
      <translation>{0}: bei {1} sind Punkt, Normale, Quertangente und Krümmung nicht alle endlich</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no method '{0}'; the methods are {1}</source>
      <translation>es gibt keine Methode '{0}'; die Methoden sind {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>stopped while filling</source>
      <translation>beim Füllen angehalten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>worse in the written file</source>
      <translation>schlechter in der geschriebenen Datei</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>not tried</source>
      <translation>nicht versucht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>as asked</source>
      <translation>wie verlangt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>not asked for</source>
      <translation>nicht verlangt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>left open</source>
      <translation>offen gelassen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no hole {0}: the model's loops are 1 to {1}</source>
      <translation>es gibt kein Loch {0}: die Ränder des Modells sind 1 bis {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} lies on no boundary loop</source>
      <translation>Edge{0} liegt auf keinem Rand</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the model has no hole: every shell is closed</source>
      <translation>das Modell hat kein Loch: jede Schale ist geschlossen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the model has no hole</source>
      <translation>das Modell hat kein Loch</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the model has no boundary loop</source>
      <translation>das Modell hat keinen offenen Rand</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: position only, for tangency was tried: {0}</source>
      <translation>auto: nur Lage, denn tangential wurde versucht: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: position only, for at both ends the neighbour's normal is not the others'</source>
      <translation>auto: nur Lage, denn an beiden Enden hat der Nachbar eine andere Normale als die übrigen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: continuous curvature was tried, and is reached to {0} %</source>
      <translation>auto: stetige Krümmung wurde versucht und auf {0} % erreicht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: continuous curvature was tried: {0}</source>
      <translation>auto: stetige Krümmung wurde versucht: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: with continuous curvature gap, angle or the face inside are out of tolerance</source>
      <translation>auto: mit stetiger Krümmung sind Spalt, Winkel oder das Innere der Fläche außer Toleranz</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: tangent to the neighbour</source>
      <translation>auto: tangential zum Nachbarn</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: tangent only, for {0}</source>
      <translation>auto: nur tangential, denn {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: the neighbours' curvatures agree at both ends</source>
      <translation>auto: die Krümmungen der Nachbarn stimmen an beiden Enden überein</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: {0}</source>
      <translation>auto: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>trying the new face</source>
      <translation>probiert die neue Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's check finds the new face invalid ({0})</source>
      <translation>die Prüfung von OCCT findet die neue Fläche ungültig ({0})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the curve beside it, whose own curvature no face has to have</source>
      <translation>die Kurve daneben, deren eigene Krümmung keine Fläche haben muss</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the normals of faces {0} and {1} differ by {2} deg where they meet</source>
      <translation>die Normalen von Face{0} und Face{1} weichen um {2}° ab, wo sie sich treffen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the curvatures of faces {0} and {1} differ by {2} % where they meet</source>
      <translation>die Krümmungen von Face{0} und Face{1} weichen um {2} % ab, wo sie sich treffen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0} leads away from the hole by {1} deg and meets its neighbours at {2} deg</source>
      <translation>Face{0} führt um {1}° vom Loch weg und trifft seine Nachbarn unter {2}°</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>at both ends of it the border leaves the plane of face {0} by {1} deg or more: no face within it is tangent there</source>
      <translation>An beiden Enden der Seite verlässt der Rand die Ebene von Face{0} um {1}° oder mehr: keine Fläche darin ist dort tangential</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the neighbours stand on the opening at {0} deg or more, as walls do</source>
      <translation>die Nachbarn stehen unter {0}° oder mehr auf der Öffnung, wie Wände</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0} lies in the planar opening itself</source>
      <translation>Face{0} liegt selbst in der ebenen Öffnung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a curve that was made to close the border</source>
      <translation>eine Kurve, die den Rand schließen soll</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} has no face</source>
      <translation>Edge{0} hat keine Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>as asked for this edge</source>
      <translation>wie für diese Kante verlangt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the method joins in position only</source>
      <translation>die Methode schließt nur in der Lage an</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} (face {1})</source>
      <translation>Edge{0} (Face{1})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} (no face)</source>
      <translation>Edge{0} (ohne Fläche)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a connecting curve</source>
      <translation>eine Verbindungskurve</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a boundary needs edges</source>
      <translation>ein Rand braucht Kanten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} is named twice in one boundary</source>
      <translation>Edge{0} kommt in einem Rand zweimal vor</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no edge {0}: the model has {1} edges</source>
      <translation>es gibt keine Edge{0}: das Modell hat {1} Kanten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no edge {0}</source>
      <translation>es gibt keine Edge{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} does not belong to this part of the model</source>
      <translation>Edge{0} gehört nicht zu diesem Teil des Modells</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} has no length: it bounds no face</source>
      <translation>Edge{0} hat keine Länge: sie begrenzt keine Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} lies inside face {1}: no further face can be joined there</source>
      <translation>Edge{0} liegt innerhalb von Face{1}: dort lässt sich keine weitere Fläche anschließen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} lies between the faces {1}: no further face can be joined there</source>
      <translation>Edge{0} liegt zwischen den Flächen {1}: dort lässt sich keine weitere Fläche anschließen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a bridge stands on two chains of edges or on two closed rims, and these edges form {0} open and {1} closed</source>
      <translation>eine Brücke steht auf zwei Ketten von Kanten oder zwei geschlossenen Rändern, und diese Kanten bilden {0} offene und {1} geschlossene</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edges {0} all meet in {1}: a border passes a point once</source>
      <translation>die Kanten {0} treffen sich alle in {1}: ein Rand geht nur einmal durch einen Punkt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} has no end to connect</source>
      <translation>Edge{0} hat kein Ende, an das etwas anschließen kann</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edges {0} form no closed chain: between the ends at {1} and {2} is a gap of {3}, wider than the {4} that closes by itself; --connect bridges it</source>
      <translation>die Kanten {0} bilden keine geschlossene Kette: zwischen den Enden bei {1} und {2} ist eine Lücke von {3}, breiter als die {4}, die sich von selbst schließt; „Lücken überbrücken“ hilft</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} forms no closed chain: between the ends at {1} and {2} is a gap of {3}, wider than the {4} that closes by itself; --connect bridges it</source>
      <translation>Edge{0} bildet keine geschlossene Kette: zwischen den Enden bei {1} und {2} ist eine Lücke von {3}, breiter als die {4}, die sich von selbst schließt; „Lücken überbrücken“ hilft</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>its edges were chosen</source>
      <translation>seine Kanten wurden gewählt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>all faces would go: nothing would be left around them</source>
      <translation>alle Flächen gingen weg: um sie herum bliebe nichts</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>all faces that hang together would go: nothing would be left around them</source>
      <translation>alle zusammenhängenden Flächen gingen weg: um sie herum bliebe nichts</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>letting the neighbours grow</source>
      <translation>lässt die Nachbarn zusammenwachsen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>merging faces</source>
      <translation>vereinigt Flächen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT finds no way to let the neighbours meet</source>
      <translation>OCCT findet keinen Weg, die Nachbarn zusammenzuführen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT leaves one of the faces where it is</source>
      <translation>OCCT lässt eine der Flächen stehen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, cut in two</source>
      <translation>{0}, in zwei geteilt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} runs straight between the two vertices: nothing lies between it and the cut</source>
      <translation>Edge{0} läuft gerade zwischen den beiden Punkten: zwischen ihr und dem Schnitt liegt nichts</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>sewing the new faces in</source>
      <translation>näht die neuen Flächen ein</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>making the new face</source>
      <translation>macht die neue Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the tolerance of {0} edges had to grow, at most to {1}</source>
      <translation>die Toleranz von {0} Kanten musste wachsen, höchstens auf {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the best fill is bad and stays out of the model (--keep-bad puts it in): {0}</source>
      <translation>die beste Füllung ist schlecht und bleibt draußen: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>filling holes, {0} of {1} done</source>
      <translation>füllt Löcher, {0} von {1} fertig</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>filling holes</source>
      <translation>füllt Löcher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>auto: position only, the neighbours are facets; the face follows the curved shape that they mean</source>
      <translation>auto: nur Lage, die Nachbarn sind Facetten; die Fläche folgt der gekrümmten Form, die sie meinen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edges {0} are chosen for two faces</source>
      <translation>die Kanten {0} sind für zwei Flächen gewählt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>points to pass through belong to one hole, not to {0}: choose it with --hole</source>
      <translation>Punkte, durch die es gehen soll, gehören zu einem Loch, nicht zu {0}: wählen Sie eines</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the side was not found again</source>
      <translation>die Seite wurde nicht wiedergefunden</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>its surface runs against its border</source>
      <translation>die Fläche läuft gegen ihren Rand</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two of its normals are {0} deg apart there</source>
      <translation>zwei ihrer Normalen liegen dort {0}° auseinander</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>one face uses it</source>
      <translation>eine Fläche benutzt sie</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>more than two faces use it</source>
      <translation>mehr als zwei Flächen benutzen sie</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a new face was not found again in the output</source>
      <translation>eine neue Fläche wurde in der Ausgabe nicht wiedergefunden</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} (face {1}) has no 3D curve</source>
      <translation>Edge{0} (Face{1}) hat keine Kurve im Raum</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} has no curve on the surface of face {1}</source>
      <translation>Edge{0} hat keine Kurve auf der Fläche von Face{1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0} has no surface</source>
      <translation>Face{0} hat keine Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: the neighbour has no normal at s = {1}</source>
      <translation>{0}: der Nachbar hat bei s = {1} keine Normale</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has no length</source>
      <translation>{0} hat keine Länge</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>reading the hole's neighbours</source>
      <translation>liest die Nachbarn des Lochs</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} has no 3D curve</source>
      <translation>Edge{0} hat keine Kurve im Raum</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the gap is wider than {0}, a quarter of the smallest feature</source>
      <translation>der Spalt ist breiter als {0}, ein Viertel des kleinsten Merkmals</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>both faces leave it to the same side: a thin wall</source>
      <translation>beide Flächen gehen nach derselben Seite weg: eine dünne Wand</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no single edge or row of edges runs along it</source>
      <translation>keine einzelne Kante oder Reihe von Kanten läuft daran entlang</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no shape to sew</source>
      <translation>es gibt keine Form zum Nähen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>looking for the lost surface in the model</source>
      <translation>sucht die verlorene Fläche im Modell</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>degree {0} x {1} is above OCCT's limit of {2}</source>
      <translation>der Grad {0} x {1} liegt über der Grenze von OCCT, {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} crashed ({1})</source>
      <translation>{0} ist abgestürzt ({1})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} ended without an answer</source>
      <translation>{0} endete ohne Antwort</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: {1} could not be started: {2}</source>
      <translation>{0}: {1} konnte nicht gestartet werden: {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} gave no answer within {1} s</source>
      <translation>{0} gab in {1} s keine Antwort</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} was stopped</source>
      <translation>{0} wurde angehalten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: OCCT returned no shape</source>
      <translation>{0}: OCCT gab keine Form zurück</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: OCCT raised {1}</source>
      <translation>{0}: OCCT meldete {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: out of memory</source>
      <translation>{0}: zu wenig Speicher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling found no surface</source>
      <translation>die Füllung von OCCT fand keine Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling made no face</source>
      <translation>die Füllung von OCCT gab keine Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling lost {0}</source>
      <translation>die Füllung von OCCT verlor {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling has no curve for {0}</source>
      <translation>die Füllung von OCCT hat keine Kurve für {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling takes one loop, and this hole has {0}: it would close the wrong one</source>
      <translation>die Füllung von OCCT nimmt einen Rand, und dieses Loch hat {0}: sie würde den falschen schließen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's G2 constraints come out worse than its G1: G1 was asked for</source>
      <translation>mit G2 wird OCCT schlechter als mit G1: G1 wurde verlangt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling</source>
      <translation>die Füllung von OCCT</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the installation is broken: {0}</source>
      <translation>die Installation ist beschädigt: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the length tolerance must be a positive number, not {0}</source>
      <translation>die Längentoleranz muss positiv sein, nicht {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the angular tolerance must lie between 0 and 180 degrees, not at {0}</source>
      <translation>die Winkeltoleranz muss zwischen 0 und 180 Grad liegen, nicht bei {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the curvature tolerance must be a positive number, not {0}</source>
      <translation>die Krümmungstoleranz muss positiv sein, nicht {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>self-intersecting wire</source>
      <translation>sich selbst schneidender Rand</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>intersecting wires</source>
      <translation>sich schneidende Ränder</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>bad orientation of a subshape</source>
      <translation>falsche Richtung eines Teils</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no bound at this length</source>
      <translation>keine Schranke auf dieser Länge</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} has no normal</source>
      <translation>Face{0} hat keine Normale</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edge has no curve in space</source>
      <translation>die Kante hat keine Kurve im Raum</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>its curve is none of line, circle, ellipse and B-spline</source>
      <translation>ihre Kurve ist weder Gerade noch Kreis, Ellipse oder B-Spline</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} is a surface of revolution</source>
      <translation>Face{0} ist eine Drehfläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} is a surface of extrusion</source>
      <translation>Face{0} ist eine Zugfläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} is an offset surface</source>
      <translation>Face{0} ist eine Parallelfläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} is of a kind that is not treated</source>
      <translation>Face{0} ist von einer Art, die nicht behandelt wird</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0}: {1}</source>
      <translation>Face{0}: {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the nearest point is not unique, or the surface is singular</source>
      <translation>der nächste Punkt ist nicht eindeutig, oder die Fläche ist singulär</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edge leaves the surface's parameter range</source>
      <translation>die Kante verlässt den Parameterbereich der Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edge runs along or across a knot at which the surface is only C0</source>
      <translation>die Kante läuft an oder über einen Knoten, an dem die Fläche nur C0 ist</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>looking for clashes</source>
      <translation>sucht Durchdringungen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no shape to check</source>
      <translation>es gibt keine Form zu prüfen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>check stopped after {0} of {1} edges</source>
      <translation>die Prüfung wurde nach {0} von {1} Kanten angehalten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>looking for folds</source>
      <translation>sucht Falten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT could not evaluate {0} of {1} samples</source>
      <translation>OCCT konnte {0} von {1} Stellen nicht auswerten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no normal at {0} of {1} samples: singular surface</source>
      <translation>keine Normale an {0} von {1} Stellen: singuläre Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no curvature at any sample</source>
      <translation>nirgends eine Krümmung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the two faces are oriented inconsistently: both use the edge in the same direction</source>
      <translation>die beiden Flächen sind uneinig gerichtet: beide durchlaufen die Kante in derselben Richtung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>knife edge: the faces fold back onto each other</source>
      <translation>Schneide: die Flächen falten sich aufeinander zurück</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>measuring edges</source>
      <translation>misst Kanten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>certifying edges</source>
      <translation>beweist Schranken an Kanten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>measuring the result</source>
      <translation>misst das Ergebnis</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>measuring the merged faces</source>
      <translation>misst die vereinigten Flächen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>fitting faces</source>
      <translation>passt Flächen an</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>writing {0}</source>
      <translation>schreibt {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>reading {0} again</source>
      <translation>liest {0} noch einmal</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>reading {0}</source>
      <translation>liest {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>drawing the model</source>
      <translation>zeichnet das Modell</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>making a shell</source>
      <translation>macht eine Schale</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no surface that is regular in the corner of sides {0} and {1} is G^{2} with both: their curvatures differ there by {3} % of the larger; G^1 can do</source>
      <translation>keine Fläche, die in der Ecke der Seiten {0} und {1} regulär ist, ist G^{2} mit beiden: ihre Krümmungen weichen dort um {3} % der größeren ab; G^1 geht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} sides and {1} corners: at least 3, and as many of both</source>
      <translation>{0} Seiten und {1} Ecken: mindestens 3, und von beiden gleich viele</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>plane {0} does not go through the centre</source>
      <translation>die Ebene {0} geht nicht durch die Mitte</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>corner {0} does not lie on surface and plane {1}</source>
      <translation>die Ecke {0} liegt nicht auf Fläche und Ebene {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the curve of side {0} does not lead to the next corner</source>
      <translation>die Kurve der Seite {0} führt nicht zur nächsten Ecke</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no surface to go by: {0}</source>
      <translation>keine Fläche als Anhalt: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>'{0}{1}': expected {2} at character {3}</source>
      <translation>'{0}{1}': {2} erwartet an Stelle {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a polynomial of {0} characters is longer than the {1} allowed</source>
      <translation>ein Polynom mit {0} Zeichen ist länger als die erlaubten {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the sheet of {0} ends inside its sector</source>
      <translation>das Blatt von {0} endet in seinem Sektor</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the patch of {0} folds</source>
      <translation>das Flächenstück von {0} faltet sich</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no solution</source>
      <translation>keine Lösung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no member with a provably single sheet</source>
      <translation>keine Fläche mit beweisbar einem Blatt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the sheet could not be proven single</source>
      <translation>dass es ein einziges Blatt ist, ließ sich nicht beweisen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no member near the hole ({0} off)</source>
      <translation>keine Fläche in der Nähe des Lochs ({0} entfernt)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no member nearer to the sides than {0} deg and {1} of the radius</source>
      <translation>keine Fläche näher an den Seiten als {0}° und {1} des Radius</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>rays meet the sheet more than once, or not at all ({0} off)</source>
      <translation>Strahlen treffen das Blatt mehrmals oder gar nicht ({0} entfernt)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>degree {0} in {1} cells: {2}</source>
      <translation>Grad {0} in {1} Zellen: {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no piecewise polynomial of degree {0} to {1} joins: {2}</source>
      <translation>kein stückweises Polynom vom Grad {0} bis {1} schließt an: {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the normals spread so far that from every centre tried rays meet the surface at {0} deg or less, at least {1} are needed</source>
      <translation>die Normalen gehen so weit auseinander, dass Strahlen aus jeder versuchten Mitte die Fläche unter {0}° oder weniger treffen; mindestens {1} sind nötig</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no point inside sees all of the boundary, so that cells around an axis overlap</source>
      <translation>kein Punkt im Innern sieht den ganzen Rand, so dass Zellen um eine Achse sich überdecken</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has {0} islands; space is divided around one loop</source>
      <translation>das Loch hat {0} Inseln; der Raum wird um einen Rand geteilt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: the hole has {1} sides; cells around an axis need 3</source>
      <translation>{0}: das Loch hat {1} Seiten; Zellen um eine Achse brauchen 3</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>points to pass through are not part of this method</source>
      <translation>Punkte, durch die es gehen soll, gehören nicht zu dieser Methode</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the normals of the neighbours differ by {0} deg where {1} and {2} meet, more than {3}</source>
      <translation>die Normalen der Nachbarn weichen um {0}° ab, wo {1} und {2} sich treffen, mehr als {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: G^{1} asks for a neighbour with an equation: a plane, cylinder, cone, sphere or torus</source>
      <translation>{0}: G^{1} verlangt einen Nachbarn mit einer Gleichung: Ebene, Zylinder, Kegel, Kugel oder Torus</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is not planar, which G^{1} asks for</source>
      <translation>{0} ist nicht eben, was G^{1} verlangt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is no smooth curve: a B-spline comes within {1} only</source>
      <translation>{0} ist keine glatte Kurve: ein B-Spline kommt nur bis auf {1} heran</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has {0} islands, the first at {1}: a disc-like surface has none</source>
      <translation>das Loch hat {0} Inseln, die erste bei {1}: eine scheibenartige Fläche hat keine</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} leaves the tangent plane of the neighbour at {1} by {2} deg where they meet (limit {3}): no surface is tangent there</source>
      <translation>{0} verlässt die Tangentialebene des Nachbarn an {1} um {2}°, wo sie sich treffen (Grenze {3}): keine Fläche ist dort tangential</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the map folds {0}</source>
      <translation>die Abbildung faltet sich {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the paper's map folds between s = {0} and {1}</source>
      <translation>die Abbildung der Veröffentlichung faltet sich zwischen s = {0} und {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the paper's map folds between s = {0} and {1} and at {2} other places</source>
      <translation>die Abbildung der Veröffentlichung faltet sich zwischen s = {0} und {1} und an {2} anderen Stellen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the boundary has no extent</source>
      <translation>der Rand hat keine Ausdehnung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the boundary encloses no area</source>
      <translation>der Rand umschließt keine Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the control polygon meets itself: its sides at s = {0} and {1}, near ({2}, {3})</source>
      <translation>das Kontrollpolygon trifft sich selbst: seine Seiten bei s = {0} und {1}, nahe ({2}, {3})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the Voronoi diagram of the control polygon is not connected near s = {0}</source>
      <translation>das Voronoi-Diagramm des Kontrollpolygons hängt nahe s = {0} nicht zusammen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the medial axis is no tree near ({0}, {1}): two parts of the boundary nearly touch</source>
      <translation>die Mittelachse ist nahe ({0}, {1}) kein Baum: zwei Teile des Randes berühren sich fast</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}; s counts the sides from {1} on</source>
      <translation>{0}; s zählt die Seiten ab {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there are {0} points to pass through: the spokes leave no freedom for them</source>
      <translation>es soll durch {0} Punkte gehen: die Speichen lassen dafür keine Freiheit</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole goes all the way around the {0}, and no straight line from corner to corner cuts it open</source>
      <translation>das Loch geht ganz um {0} herum, und keine gerade Linie von Ecke zu Ecke schneidet es auf</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no loop encloses a part of the {0}: all around is missing</source>
      <translation>kein Rand umschließt einen Teil von {0}: ringsum fehlt alles</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} loops enclose a part of the {1} each: they are as many holes</source>
      <translation>{0} Ränder umschließen je einen Teil von {1}: es sind ebenso viele Löcher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole overlaps itself around the axis of the {0}</source>
      <translation>das Loch überdeckt sich selbst um die Achse von {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a loop winds {0} times around the {1} one way and {2} times the other</source>
      <translation>ein Rand windet sich {0}-mal so und {2}-mal anders um {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two loops go the same way around the {0}</source>
      <translation>zwei Ränder gehen in derselben Richtung um {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two loops cross on the {0}</source>
      <translation>zwei Ränder kreuzen sich auf {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the material lies between the two loops: the {0} goes on to both sides</source>
      <translation>das Material liegt zwischen den beiden Rändern: {0} geht nach beiden Seiten weiter</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole goes all the way around the {0} and nothing ends it on the other side</source>
      <translation>das Loch geht ganz um {0} herum, und auf der anderen Seite endet es nicht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} of the {1} sides have their neighbour oriented against the others'</source>
      <translation>an {0} der {1} Seiten ist der Nachbar gegen die anderen gerichtet</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has no surface to continue</source>
      <translation>{0} hat keine Fläche zum Fortsetzen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0} lies on a surface without a closed form</source>
      <translation>Face{0} liegt auf einer Fläche ohne geschlossene Form</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the neighbours lie on different surfaces: face {0} ({1}) and face {2} ({3})</source>
      <translation>die Nachbarn liegen auf verschiedenen Flächen: Face{0} ({1}) und Face{2} ({3})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the rims have {0} and {1} corners: no patch runs from corner to corner</source>
      <translation>die Ränder haben {0} und {1} Ecken: kein Flächenstück läuft von Ecke zu Ecke</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole is no bridge: it needs two closed rims, or two chains of sides and a curve without a face between each two ends of them</source>
      <translation>das Loch ist keine Brücke: dafür braucht es zwei geschlossene Ränder, oder zwei Ketten von Seiten und zwischen ihren Enden je eine Kurve ohne Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the chains have {0} and {1} corners: no patch runs from corner to corner</source>
      <translation>die Ketten haben {0} und {1} Ecken: kein Flächenstück läuft von Ecke zu Ecke</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is {1} from the cubic that is tangent to both neighbours</source>
      <translation>{0} ist {1} von der kubischen Kurve entfernt, die zu beiden Nachbarn tangential ist</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a loft passes no inner points: {0} were given</source>
      <translation>loft geht durch keine inneren Punkte: {0} wurden angegeben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the border folds at {0}: its normal is {1} deg off the neighbour's</source>
      <translation>der Rand faltet sich bei {0}: seine Normale weicht um {1}° von der des Nachbarn ab</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the surface folds at ({0}, {1}, {2}), on the side of {3}: its normal turns by {4} deg from one sample to the next</source>
      <translation>die Fläche faltet sich bei ({0}, {1}, {2}), auf der Seite von {3}: ihre Normale dreht sich von einer Stelle zur nächsten um {4}°</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>manifold takes one loop, this hole has {0}</source>
      <translation>manifold nimmt einen Rand, dieses Loch hat {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>without a guide: {0}</source>
      <translation>ohne Leitfläche: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} from the surface of least variation</source>
      <translation>{0} von der Fläche der geringsten Krümmungsänderung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>towards the surface of least variation {0}</source>
      <translation>hin zur Fläche der geringsten Krümmungsänderung {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has a length of {1}, no more than {2}</source>
      <translation>{0} hat die Länge {1}, nicht mehr als {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the corner between {0} and {1} has an interior angle of {2} deg: above {3} deg a border of B-splines would fold there</source>
      <translation>die Ecke zwischen {0} und {1} hat innen {2}°: über {3}° würde sich ein Rand aus B-Splines dort falten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} and {1} have normals that differ by {2} deg where they meet: no smooth surface meets both there</source>
      <translation>{0} und {1} haben Normalen, die um {2}° abweichen, wo sie sich treffen: keine glatte Fläche passt dort zu beiden</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the loop that begins with {0} has {1} corners of less than {2} deg: a patch has at least 3, a ring none</source>
      <translation>der Rand, der mit {0} beginnt, hat {1} Ecken unter {2}°: eine Fläche hat mindestens 3, ein Ring keine</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has no corner: a ring needs k of at least {0}</source>
      <translation>das Loch hat keine Ecke: ein Ring braucht k von mindestens {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>manifold passes through no inner points, {0} are given</source>
      <translation>manifold geht durch keine inneren Punkte, {0} sind angegeben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the aperture {0} is not between 0 and {1}, its bound for k = {2} and {3} sides</source>
      <translation>die Größe der Mitte {0} liegt nicht zwischen 0 und {1}, ihrer Grenze für k = {2} und {3} Seiten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} layers are too few: k = {1} with {2} sides needs {3}</source>
      <translation>{0} Schichten sind zu wenige: k = {1} mit {2} Seiten braucht {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>side {0} has no interval in its middle</source>
      <translation>die Seite {0} hat in ihrer Mitte kein Intervall</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the denominator varies more than {0}-fold around the cell at ({1}, {2}) of the parameters: a smaller aperture helps</source>
      <translation>der Nenner ändert sich um die Zelle bei ({1}, {2}) der Parameter um mehr als das {0}-fache: eine kleinere Mitte hilft</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>knot curves meet {0} from each other at ({1}, {2}) of the parameters, nearer than {3}: another aperture parts them</source>
      <translation>Knotenkurven treffen sich bei ({1}, {2}) der Parameter im Abstand {0}, näher als {3}: eine andere Größe der Mitte trennt sie</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>k = {0}: the exact middle has cells of degree {1}; it is written for k up to {2}</source>
      <translation>k = {0}: die exakte Mitte hat Zellen vom Grad {1}; sie wird für k bis {2} geschrieben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two faces run along the edge of vertices {0} and {1} in the same sense: turn one of them over</source>
      <translation>zwei Flächen laufen im selben Sinn an der Kante der Punkte {0} und {1} entlang: drehen Sie eine um</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>two borders of the mesh touch at vertex {0}</source>
      <translation>zwei Ränder des Netzes berühren sich im Punkt {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>faces {0} and {1} have {2} and {3} sides: all but the one in the hole have 4</source>
      <translation>die Netzflächen {0} und {1} haben {2} und {3} Seiten: alle außer der im Loch haben 4</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the mesh has no face of four sides</source>
      <translation>das Netz hat kein Viereck</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the mesh has {0} borders, not 2: the hole in the middle and the outer one (leave the central face away if it is a quad)</source>
      <translation>das Netz hat {0} Ränder, nicht 2: das Loch in der Mitte und den äußeren (lassen Sie die mittlere Fläche weg, wenn sie ein Viereck ist)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>vertex {0} has valence {1}: inside it has to be 4</source>
      <translation>der Punkt {0} hat die Valenz {1}: im Innern muss sie 4 sein</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>vertex {0} has valence {1}: along the hole it has to be 3, or 4 at the hole's corners</source>
      <translation>der Punkt {0} hat die Valenz {1}: am Loch muss sie 3 sein, an dessen Ecken 4</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>vertex {0} has valence {1}: along the outer border it has to be 3, or 2 at the corners</source>
      <translation>der Punkt {0} hat die Valenz {1}: am äußeren Rand muss sie 3 sein, an den Ecken 2</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has {0} corners (vertices of valence 4), fewer than 3</source>
      <translation>das Loch hat {0} Ecken (Punkte der Valenz 4), weniger als 3</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has {0} corners (valence 4), the outer border {1} (valence 2)</source>
      <translation>das Loch hat {0} Ecken (Valenz 4), der äußere Rand {1} (Valenz 2)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: no finite point, tangent and unit normal at {1}</source>
      <translation>{0}: kein endlicher Punkt mit Tangente und Normale bei {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: its length {1} is less than {2}, no direction</source>
      <translation>{0}: ihre Länge {1} ist kleiner als {2}, ohne Richtung</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the boundary from {0} on crosses itself</source>
      <translation>der Rand kreuzt sich selbst, von {0} an</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>where {0} meets {1}, at ({2}, {3}, {4}), the neighbours' normals differ by {5} deg: no face is tangent to both there</source>
      <translation>wo {0} auf {1} trifft, bei ({2}, {3}, {4}), weichen die Normalen der Nachbarn um {5}° ab: keine Fläche ist dort zu beiden tangential</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the surface folds: its area element falls to {0} of the mean (limit {1})</source>
      <translation>die Fläche faltet sich: ihr Flächenelement fällt auf {0} des Mittels (Grenze {1})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the surface meets a neighbour at {0} deg (limit {1})</source>
      <translation>die Fläche trifft einen Nachbarn unter {0}° (Grenze {1})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>method '{0}' has no option '{1}', nor any other</source>
      <translation>die Methode '{0}' hat keine Option '{1}' und auch keine andere</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>method '{0}' has no option '{1}'; its options are {2}</source>
      <translation>die Methode '{0}' hat keine Option '{1}'; ihre Optionen sind {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>option '{0}' takes {1} ({2}), not '{3}'</source>
      <translation>die Option '{0}' nimmt {1} ({2}), nicht '{3}'</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a number</source>
      <translation>eine Zahl</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a whole number</source>
      <translation>eine ganze Zahl</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>numbers separated by commas</source>
      <translation>Zahlen, durch Kommas getrennt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a point x,y,z</source>
      <translation>einen Punkt x,y,z</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a direction x,y,z that is not zero</source>
      <translation>eine Richtung x,y,z, die nicht null ist</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>one of these words</source>
      <translation>eines dieser Wörter</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole is not planar: {0} leaves the best plane by {1}, more than {2}</source>
      <translation>das Loch ist nicht eben: {0} verlässt die beste Ebene um {1}, mehr als {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a patch of four sides has no islands or inner points</source>
      <translation>eine Fläche mit vier Seiten hat keine Inseln und keine inneren Punkte</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has {0} sides, not 4</source>
      <translation>das Loch hat {0} Seiten, nicht 4</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} and {1} meet at {2} deg: no corner of a patch (limits {3}, {4})</source>
      <translation>{0} und {1} treffen sich unter {2}°: keine Ecke einer Fläche (Grenzen {3}, {4})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the patch between its four sides folds</source>
      <translation>die Fläche zwischen ihren vier Seiten faltet sich</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: tangency is asked for, and the patch meets it at {1} deg (limit {2})</source>
      <translation>{0}: tangential ist verlangt, und die Fläche trifft sie unter {1}° (Grenze {2})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the border lies off by {0} of the hole's diameter, limit {1}</source>
      <translation>der Rand liegt um {0} des Lochdurchmessers daneben, Grenze {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} % of the border is tangent to its neighbours, limit {1} %</source>
      <translation>{0} % des Randes sind tangential zu den Nachbarn, Grenze {1} %</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the border lies off by {0} of the hole's diameter</source>
      <translation>der Rand liegt um {0} des Lochdurchmessers daneben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the border is so nearly flat ({0} of its diameter) that the fit says nothing</source>
      <translation>der Rand ist so eben ({0} seines Durchmessers), dass die Anpassung nichts besagt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no ball of radius {0} touches {1} and {2}</source>
      <translation>keine Kugel vom Radius {0} berührt {1} und {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>only position is asked for along a flat rim: it has a lid, and normals say nothing</source>
      <translation>nur die Lage ist an einem ebenen Rand verlangt: er hat einen Deckel, und Normalen besagen nichts</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no surface is recognised: {0}</source>
      <translation>keine Fläche erkannt: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no fit</source>
      <translation>passt nicht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, tangent to face {1}</source>
      <translation>{0}, tangential zu Face{1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, tangent to faces {1}</source>
      <translation>{0}, tangential zu faces {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>torus R = {0}, r = {1}</source>
      <translation>Torus R = {0}, r = {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>cylinder r = {0}</source>
      <translation>Zylinder r = {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>sphere r = {0}</source>
      <translation>Kugel r = {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the curvatures asked for at the closing point are not reached: off by {0} after {1} steps</source>
      <translation>die am Schließpunkt verlangten Krümmungen sind nicht erreicht: {0} daneben nach {1} Schritten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the rays from the closing point to the border turn back: no fairest surface over them is found</source>
      <translation>die Strahlen vom Schließpunkt zum Rand kehren um: keine glatteste Fläche darüber gefunden</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>no plane for the closing point is found: give it with its normal</source>
      <translation>keine Ebene für den Schließpunkt gefunden: geben Sie ihn mit seiner Normale an</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>seen along the normal ({0}, {1}, {2}) of the closing point, the border does not go around it once</source>
      <translation>entlang der Normale ({0}, {1}, {2}) des Schließpunkts gesehen geht der Rand nicht einmal um ihn herum</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole is not star-shaped: {0} sees the closing point at {1} deg from its inside (limit {2})</source>
      <translation>das Loch ist nicht sternförmig: {0} sieht den Schließpunkt unter {1}° von innen (Grenze {2})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the surface folds: its normal turns by {0} deg within a patch (limit {1}), near ({2}, {3}, {4})</source>
      <translation>die Fläche faltet sich: ihre Normale dreht sich in einem Stück um {0}° (Grenze {1}), nahe ({2}, {3}, {4})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the hole has {0} loops: a tube closes one</source>
      <translation>das Loch hat {0} Ränder: tube schließt einen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the tube passes no inner points: {0} were given</source>
      <translation>tube geht durch keine inneren Punkte: {0} wurden angegeben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is {1} long, {2} of the diameter (limit {3})</source>
      <translation>{0} ist {1} lang, {2} des Durchmessers (Grenze {3})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} layers were asked for, at most {1} can be told apart</source>
      <translation>{0} Schichten wurden verlangt, höchstens {1} sind unterscheidbar</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} curvatures were given for {1} sides</source>
      <translation>{0} Krümmungen wurden für {1} Seiten angegeben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>how far the tangents at both sides reach: 1 (default) as far as the gap is wide</source>
      <translation>wie weit die Tangenten beider Seiten reichen: 1 (Vorgabe) so weit wie die Lücke</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>order of continuity inside (default 2)</source>
      <translation>Ordnung der Stetigkeit im Innern (Vorgabe 2)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>size of the central face in the parameters (default: even knots)</source>
      <translation>Größe der mittleren Fläche in den Parametern (Vorgabe: gleichmäßige Knoten)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>layers of the control mesh (default: as many as the tolerance needs)</source>
      <translation>Schichten des Kontrollnetzes (Vorgabe: so viele, wie die Toleranz braucht)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>n fitted faces, or for k = 0 and 1 exact cells (default: quads; for k = 0 and 1 exact where quads do not do)</source>
      <translation>n angepasste Flächen, oder für k = 0 und 1 exakte Zellen (Vorgabe: Vierecke; für k = 0 und 1 exakt, wo diese nicht genügen)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the closing point (default: found)</source>
      <translation>der Schließpunkt (Vorgabe: gefunden)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the outward normal at the closing point (default: found)</source>
      <translation>die Normale nach außen am Schließpunkt (Vorgabe: gefunden)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the fairness functional that is least (default plate)</source>
      <translation>das Glattheitsmaß, das am kleinsten wird (Vorgabe plate)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>of all tangents at the closing point (default: as the functional wants them)</source>
      <translation>aller Tangenten am Schließpunkt (Vorgabe: wie das Maß sie will)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>let the functional move the closing point; the weight holds it back, 1 with the functional's own stiffness (default: it stays)</source>
      <translation>lässt das Maß den Schließpunkt verschieben; das Gewicht hält ihn zurück, 1 mit der Steifigkeit des Maßes (Vorgabe: er bleibt)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>normal curvatures at the closing point, 1/length, positive towards the normal: one, or one for each side (default: free)</source>
      <translation>Normalkrümmungen am Schließpunkt, 1/Länge, positiv zur Normale hin: eine, oder eine je Seite (Vorgabe: frei)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the border as a spline through its points, or as one near quadratic pieces</source>
      <translation>der Rand als Spline durch seine Punkte, oder als einer nahe quadratischen Stücken</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>such pieces by least squares, or each in its turn</source>
      <translation>solche Stücke nach kleinsten Quadraten, oder eins nach dem andern</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>rows of patches beside the border, each half as wide as the one before (default: as many as keep creases within the angle tolerance)</source>
      <translation>Reihen von Stücken neben dem Rand, jede halb so breit wie die vorige (Vorgabe: so viele, dass Knicke in der Winkeltoleranz bleiben)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>G^k with all neighbours and between cells (default: as each side asks for)</source>
      <translation>G^k mit allen Nachbarn und zwischen den Zellen (Vorgabe: wie jede Seite verlangt)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>degree of the polynomials (default: the lowest that works)</source>
      <translation>Grad der Polynome (Vorgabe: der kleinste, der geht)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>cells around an axis, or with inner cells (default: the fewest that work)</source>
      <translation>Zellen um eine Achse, oder mit inneren Zellen (Vorgabe: die wenigsten, die gehen)</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>one face for each side of the hole, or one for all; default regions</source>
      <translation>eine Fläche für jede Seite des Lochs, oder eine für alle; Vorgabe regions</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the axis: one whose map is proved not to fold; the paper's own; the paper's, moved onto that of a refined control polygon; default certified</source>
      <translation>die Achse: eine, deren Abbildung sich nachweislich nicht faltet; die der Veröffentlichung; diese, auf die eines verfeinerten Kontrollpolygons geschoben; Vorgabe certified</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>cut branches of the axis that stand out less, as a share of the largest inscribed circle's radius; default 0.1</source>
      <translation>Äste der Achse abschneiden, die weniger herausragen, als Anteil am Radius des größten Inkreises; Vorgabe 0.1</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>drop nodes of the axis that bend it less, likewise; default 0.02</source>
      <translation>Knoten der Achse weglassen, die sie weniger biegen, ebenso; Vorgabe 0.02</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} bounds no hole: two faces share it, or it lies in another instance of its part; `suture inspect` lists the edges of every hole</source>
      <translation>Edge{0} begrenzt kein Loch: zwei Flächen teilen sie, oder sie liegt in einem anderen Exemplar ihres Teils; „Löcher finden“ zeigt die Kanten aller Löcher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no hole {0}: {1}; `suture inspect` lists them</source>
      <translation>es gibt kein Loch {0}: {1}; „Löcher finden“ zeigt sie</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the boundary loops have the numbers 1 to {0}</source>
      <translation>die offenen Ränder haben die Nummern 1 bis {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>loops {0} and {1} belong to different parts</source>
      <translation>die Ränder {0} und {1} gehören zu verschiedenen Teilen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} has no length: no face can follow it</source>
      <translation>Edge{0} hat keine Länge: keine Fläche kann ihr folgen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the merged faces do not survive the file, which has them as they were: {0}</source>
      <translation>die vereinigten Flächen überstehen die Datei nicht, die sie hat, wie sie waren: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>new faces and their neighbours on the same surface have become one: {0} fewer</source>
      <translation>neue Flächen und ihre Nachbarn auf derselben Fläche sind eins geworden: {0} weniger</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>not merged: no new face lies on one surface with a neighbour</source>
      <translation>nicht vereinigt: keine neue Fläche liegt mit einem Nachbarn auf einer Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>not merged: {0}</source>
      <translation>nicht vereinigt: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the neighbours of {0} have grown together</source>
      <translation>die Nachbarn von {0} sind zusammengewachsen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} does not exist</source>
      <translation>{0} gibt es nicht</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is a folder, not a file</source>
      <translation>{0} ist ein Ordner, keine Datei</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is no ordinary file</source>
      <translation>{0} ist keine gewöhnliche Datei</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} cannot be opened: {1}</source>
      <translation>{0} lässt sich nicht öffnen: {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is empty</source>
      <translation>{0} ist leer</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} cannot be read: {1}</source>
      <translation>{0} lässt sich nicht lesen: {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} cannot be written: there is no folder {1}</source>
      <translation>{0} lässt sich nicht schreiben: es gibt keinen Ordner {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} cannot be written: it is a folder</source>
      <translation>{0} lässt sich nicht schreiben: es ist ein Ordner</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} cannot be written: {1}</source>
      <translation>{0} lässt sich nicht schreiben: {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has {1} bytes, more than the {2} allowed</source>
      <translation>{0} hat {1} Bytes, mehr als die erlaubten {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is damaged: OCCT makes no shape of it</source>
      <translation>{0} ist beschädigt: OCCT macht keine Form daraus</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is damaged: {1}</source>
      <translation>{0} ist beschädigt: {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is cut off: its last line, which names the shape, is missing</source>
      <translation>{0} ist abgeschnitten: die letzte Zeile, die die Form nennt, fehlt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is cut off: its last line, of section T, is missing</source>
      <translation>{0} ist abgeschnitten: die letzte Zeile, von Abschnitt T, fehlt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is of no known type: neither STEP, IGES, BREP nor FCStd</source>
      <translation>{0} ist von keinem bekannten Typ: weder STEP, IGES, BREP noch FCStd</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: cannot tell the type to write from '{1}'; known are {2}</source>
      <translation>{0}: '{1}' sagt nicht, welcher Typ zu schreiben ist; bekannt sind {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: it is no JSON document</source>
      <translation>{0}: es ist kein JSON-Dokument</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: no JSON object with "sides"</source>
      <translation>{0}: kein JSON-Objekt mit "sides"</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a side needs "{0}", a polynomial as text</source>
      <translation>eine Seite braucht "{0}", ein Polynom als Text</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>a side needs "from"</source>
      <translation>eine Seite braucht "from"</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>interrupted while {0}</source>
      <translation>unterbrochen: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>nothing was written</source>
      <translation>nichts wurde geschrieben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0} removed, the neighbours grown together</source>
      <translation>Face{0} entfernt, die Nachbarn zusammengewachsen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>faces {0} removed, the neighbours grown together</source>
      <translation>faces {0} entfernt, die Nachbarn zusammengewachsen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>half angle {0} deg</source>
      <translation>halber Winkel {0}°</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, allowed {1}, at {2}: {3}</source>
      <translation>{0}, erlaubt {1}, bei {2}: {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, allowed {1}, at {2}</source>
      <translation>{0}, erlaubt {1}, bei {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, allowed {1}, edge {2}, at {3}</source>
      <translation>{0}, erlaubt {1}, Edge{2}, bei {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, allowed {1}, edge {2}</source>
      <translation>{0}, erlaubt {1}, Edge{2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}, allowed {1}</source>
      <translation>{0}, erlaubt {1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>gap {0}</source>
      <translation>Spalt {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>angle {0}</source>
      <translation>Winkel {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>curvature mismatch {0}</source>
      <translation>Krümmungsabweichung {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>crease inside the new face of {0}</source>
      <translation>Knick in der neuen Fläche von {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the new face folds</source>
      <translation>die neue Fläche faltet sich</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the new face folds, at {0}</source>
      <translation>die neue Fläche faltet sich, bei {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the new face cuts another one, to a depth of {0}</source>
      <translation>die neue Fläche schneidet eine andere, bis zur Tiefe {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the new face lies on another one, with a share of {0}</source>
      <translation>die neue Fläche liegt auf einer anderen, zum Anteil {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>area over that of a surface stretched across the hole: {0}</source>
      <translation>Verhältnis zur Größe einer über das Loch gespannten Fläche: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the edge's tolerance grew to {0}</source>
      <translation>die Toleranz der Kante wuchs auf {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>tangency given up, angle {0}</source>
      <translation>nicht mehr tangential, Winkel {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>distance of a point to be passed {0}</source>
      <translation>Abstand eines Punktes, durch den es gehen soll: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>an edge of the new face does not belong to two faces</source>
      <translation>eine Kante der neuen Fläche gehört nicht zu zwei Flächen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>could not be measured</source>
      <translation>konnte nicht gemessen werden</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the shape is not valid</source>
      <translation>die Form ist nicht gültig</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>inside the face</source>
      <translation>in der Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>cylinder</source>
      <translation>Zylinder</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>plane</source>
      <translation>Ebene</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>cone</source>
      <translation>Kegel</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>sphere</source>
      <translation>Kugel</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>B-spline surface</source>
      <translation>B-Spline-Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the surface of face {0}</source>
      <translation>die Fläche von Face{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0}, offset by {1}</source>
      <translation>Face{0}, um {1} versetzt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} as of face {1}</source>
      <translation>{0} wie bei Face{1}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>axis that of face {0}</source>
      <translation>Achse die von Face{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>axis parallel to face {0}'s</source>
      <translation>Achse parallel zu der von Face{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>axis at right angles to face {0}</source>
      <translation>Achse rechtwinklig zu Face{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>mirrored twin of face {0}</source>
      <translation>Spiegelbild von Face{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>copy of face {0}</source>
      <translation>Kopie von Face{0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>rolling ball r = {0}</source>
      <translation>rollende Kugel r = {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>cone half angle = {0} deg</source>
      <translation>Kegel mit halbem Winkel {0}°</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} between the rims</source>
      <translation>{0} zwischen den Rändern</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} does not lie on face {1}: it is {2} away, more than {3}</source>
      <translation>Edge{0} liegt nicht auf Face{1}: sie ist {2} davon entfernt, mehr als {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} runs inside face {1}, which stands across the opening: on which side of the edge the new face lies cannot be told</source>
      <translation>Edge{0} verläuft im Inneren von Face{1}, die quer zur Öffnung steht: auf welcher Seite der Kante die neue Fläche liegt, kann man nicht sagen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>there is no face {0}: the model has {1} faces</source>
      <translation>es gibt keine Face{0}: das Modell hat {1} Flächen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>tangent to face {0}, its support</source>
      <translation>tangential zu Face{0}, auf der sie liegt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's filling takes points, but no normals at them</source>
      <translation>die Füllung von OCCT nimmt Punkte, aber keine Normalen in ihnen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>--planar, --larger, --smaller and --sides choose among all holes: name none besides</source>
      <translation>die Auswahl nach Art und Größe gilt unter allen Löchern: nennen Sie keines daneben</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>none of the model's {0} is as --planar, --larger, --smaller and --sides say</source>
      <translation>keines von {0} des Modells ist so, wie die Auswahl nach Art und Größe es will</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the neighbours of the holes have grown together</source>
      <translation>die Nachbarn der Löcher sind zusammengewachsen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} is a sweep of a curve that is no line, conic or B-spline</source>
      <translation>Face{0} ist aus einer Kurve gezogen, die weder Gerade noch Kegelschnitt oder B-Spline ist</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>Face{0} is an offset of a surface that is no B-spline</source>
      <translation>Face{0} liegt parallel zu einer Fläche, die kein B-Spline ist</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>its curve is no line, conic or B-spline</source>
      <translation>ihre Kurve ist weder Gerade noch Kegelschnitt oder B-Spline</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>angle to the normal wanted at a point, {0}</source>
      <translation>Winkel zur Normale, die an einem Punkt verlangt ist: {0}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>OCCT's merging of faces gave nothing</source>
      <translation>die Vereinigung von Flächen durch OCCT gab nichts</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} is given two supports</source>
      <translation>Edge{0} hat zwei Stützflächen bekommen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>--support: edge {0} is no edge of the border</source>
      <translation>Stützfläche: Edge{0} ist keine Kante des Randes</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>measuring the edge against its support</source>
      <translation>misst die Kante an ihrer Stützfläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>taking a face's normals</source>
      <translation>nimmt die Normalen einer Fläche</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>following an edge</source>
      <translation>folgt einer Kante</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>looking for holes</source>
      <translation>sucht Löcher</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the model has no hole, only {0} other boundary loop(s), the first a {1} ({2}); --all-loops or --hole fills them</source>
      <translation>das Modell hat kein Loch, nur {0} andere offene Ränder, der erste: {1} ({2})</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>the model has no hole; it has {0} of open sheets (--all-loops fills them)</source>
      <translation>das Modell hat kein Loch; es hat {0} von offenen Blechen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} lies in another instance of its part: choose that of the first</source>
      <translation>Edge{0} liegt in einem anderen Exemplar ihres Teils: wählen Sie die des ersten</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: OCCT's reader crashed ({1}) while {2}: the file is damaged, or hits a bug in OCCT</source>
      <translation>{0}: der Leser von OCCT ist abgestürzt ({1}), {2}: die Datei ist beschädigt oder trifft einen Fehler in OCCT</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: the program crashed ({1}) while {2}</source>
      <translation>{0}: das Programm ist abgestürzt ({1}), {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: stopped after {1} s while {2}; --timeout gives more time</source>
      <translation>{0}: nach {1} s angehalten, {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0}: {1} GB of memory are not enough for {2}; --memory gives more</source>
      <translation>{0}: {1} GB Speicher reichen nicht, {2}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has no colours and layers: they are lost</source>
      <translation>{0} hat keine Farben und Layer: sie gehen verloren</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has no assembly tree: all parts become one model, and {1} names of assemblies, parts and instances are lost</source>
      <translation>{0} hat keinen Baum der Baugruppe: alle Teile werden ein Modell, und {1} Namen von Baugruppen, Teilen und Exemplaren gehen verloren</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>face {0} could not be meshed</source>
      <translation>Face{0} ließ sich nicht vernetzen</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>edge {0} of face {1} was not meshed</source>
      <translation>Edge{0} von Face{1} wurde nicht vernetzt</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is damaged: section {1} has {2} lines, and its last line states {3}</source>
      <translation>{0} ist beschädigt: Abschnitt {1} hat {2} Zeilen, und die letzte Zeile nennt {3}</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} is a folder: name a file in it</source>
      <translation>{0} ist ein Ordner: nennen Sie eine Datei darin</translation>
    </message>
    <message>
      <location filename="program.txt" />
      <source>{0} has {1} sides, more than {2}</source>
      <translation>{0} hat {1} Seiten, mehr als {2}</translation>
    </message>
  </context>
</TS>
