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
      <location filename="suture_workbench/exporting.py" />
      <source>Export stopped: {} was not written.</source>
      <translation>Export abgebrochen: {} wurde nicht geschrieben.</translation>
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
      <location filename="suture_workbench/gui/elements_panel.py" />
      <source>Click the edges around the new face, in any order.</source>
      <translation>Klicken Sie die Kanten rings um die neue Fläche an, in beliebiger Reihenfolge.</translation>
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
      <location filename="suture_workbench/gui/failures.py" />
      <source>There is no hole.</source>
      <translation>Es gibt kein Loch.</translation>
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
      <source>Edges of other objects that belong to the border or the bridge</source>
      <translation>Kanten anderer Objekte, die zum Rand oder zur Brücke gehören</translation>
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
      <source>Vertices and edges that the new face passes through</source>
      <translation>Punkte und Kanten, durch die die neue Fläche geht</translation>
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
      <source>Tension</source>
      <translation>Spannung</translation>
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
</TS>
