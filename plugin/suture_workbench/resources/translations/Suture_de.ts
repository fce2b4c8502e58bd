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
      <source>Fill holes</source>
      <translation>Löcher füllen</translation>
    </message>
    <message>
      <location filename="suture_workbench/api.py" />
      <source>No hole lies beside {}.</source>
      <translation>Neben {} liegt kein Loch.</translation>
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
      <source>The shape, and an edge of each hole to fill; no edge: all holes</source>
      <translation>Die Form und je eine Kante der zu füllenden Löcher; ohne Kante: alle Löcher</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>The fill method; auto tries what applies and keeps the best</source>
      <translation>Das Füllverfahren; auto probiert, was infrage kommt, und behält das beste</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Options of the method's own, key=value each</source>
      <translation>Eigene Einstellungen des Verfahrens, je Schlüssel=Wert</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>How the new faces join: G0 position, G1 tangent, G2 curvature</source>
      <translation>Wie die neuen Flächen anschließen: G0 Position, G1 Tangente, G2 Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Edges that are to be met in position only</source>
      <translation>Kanten, an denen nur die Position stimmen soll</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Edges that are to be met tangentially</source>
      <translation>Kanten, an denen tangential angeschlossen wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Edges that are to be met with equal curvature</source>
      <translation>Kanten, an denen mit gleicher Krümmung angeschlossen wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>The chosen loops bound one face: the others are islands in the first</source>
      <translation>Die gewählten Schleifen begrenzen eine Fläche: die übrigen sind Inseln in der ersten</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Fill the rims of open sheets and doubtful loops too</source>
      <translation>Auch die Ränder offener Flächen und zweifelhafte Schleifen füllen</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Vertices and edges that the new face passes through</source>
      <translation>Punkte und Kanten, durch die die neue Fläche geht</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Points that the new face passes through, seen from the placement of the base</source>
      <translation>Punkte, durch die die neue Fläche geht, von der Platzierung der Basis aus gesehen</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Largest gap</source>
      <translation>Größter Spalt</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Largest angle of tangent joins</source>
      <translation>Größter Winkel tangentialer Anschlüsse</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Largest curvature mismatch of G2 joins in percent</source>
      <translation>Größte Krümmungsabweichung von G2-Anschlüssen in Prozent</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>What came of it</source>
      <translation>Was daraus wurde</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>No free edge is left</source>
      <translation>Keine freie Kante ist übrig</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>All holes are filled and meet the tolerances</source>
      <translation>Alle Löcher sind gefüllt und halten die Toleranzen ein</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>The numbers of the new faces</source>
      <translation>Die Nummern der neuen Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>The whole report of the program (JSON)</source>
      <translation>Der ganze Bericht des Programms (JSON)</translation>
    </message>
    <message>
      <location filename="suture_workbench/feature.py" />
      <source>Tells whether the shape is up to date</source>
      <translation>Sagt, ob die Form auf dem neuesten Stand ist</translation>
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
      <source>near miss</source>
      <translation>knapp verfehlt</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>not measured</source>
      <translation>nicht gemessen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>free edge</source>
      <translation>freie Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>G1 tangent</source>
      <translation>G1 tangential</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>G2 curvature</source>
      <translation>G2 krümmungsstetig</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>G3 change of curvature</source>
      <translation>G3 stetige Krümmungsänderung</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>sharp</source>
      <translation>scharf</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Selected edges only</source>
      <translation>Nur die gewählten Kanten</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Zebra stripes</source>
      <translation>Zebrastreifen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Curvature combs at the chosen edge</source>
      <translation>Krümmungskämme an der gewählten Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Export report…</source>
      <translation>Bericht exportieren…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Profile</source>
      <translation>Profil</translation>
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
      <source>Largest gap between two faces</source>
      <translation>Größter Spalt zwischen zwei Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Largest angle of a tangent edge</source>
      <translation>Größter Winkel einer tangentialen Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Largest curvature mismatch of a G2 edge</source>
      <translation>Größte Krümmungsabweichung einer G2-Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>From this angle on an edge is meant to be sharp</source>
      <translation>Ab diesem Winkel ist eine Kante als scharf gemeint</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Edge</source>
      <translation>Kante</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Class</source>
      <translation>Klasse</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Gap</source>
      <translation>Spalt</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Angle</source>
      <translation>Winkel</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Curvature</source>
      <translation>Krümmung</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>Faces</source>
      <translation>Flächen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/check_panel.py" />
      <source>A report ends in .html, .csv or .json, not {}.</source>
      <translation>Ein Bericht endet auf .html, .csv oder .json, nicht auf {}.</translation>
    </message>
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
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Show reflected stripes on the selected shape, or take them away</source>
      <translation>Gespiegelte Streifen auf der gewählten Form zeigen oder wegnehmen</translation>
    </message>
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
    <message>
      <location filename="suture_workbench/gui/commands.py" />
      <source>Select the object to work on, or one of its edges or faces.</source>
      <translation>Wählen Sie das Objekt, um das es geht, oder eine seiner Kanten oder Flächen.</translation>
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
      <source>Choose files…</source>
      <translation>Dateien wählen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>Sew loose faces</source>
      <translation>Lose Flächen zusammennähen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>Convert</source>
      <translation>Umwandeln</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/convert_panel.py" />
      <source>To</source>
      <translation>Nach</translation>
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
      <location filename="suture_workbench/gui/failures.py" />
      <source>Something went wrong inside Suture: {}. Please report it.</source>
      <translation>In Suture ist etwas schiefgegangen: {}. Bitte melden Sie es.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Looking for holes…</source>
      <translation>Suche nach Löchern…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Largest curvature mismatch of G2 joins</source>
      <translation>Größte Krümmungsabweichung von G2-Anschlüssen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>The ticked loops bound one face (islands)</source>
      <translation>Die angehakten Schleifen begrenzen eine Fläche (Inseln)</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Preview</source>
      <translation>Vorschau</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Method</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Continuity</source>
      <translation>Stetigkeit</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>Tick a hole to fill.</source>
      <translation>Haken Sie ein Loch an.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>No preview.</source>
      <translation>Keine Vorschau.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/fill_panel.py" />
      <source>There is no hole: {}.</source>
      <translation>Es gibt kein Loch: {}.</translation>
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
      <location filename="suture_workbench/gui/holes_panel.py" />
      <source>Fill ticked holes…</source>
      <translation>Angehakte Löcher füllen…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_panel.py" />
      <source>There is no hole.</source>
      <translation>Es gibt kein Loch.</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_panel.py" />
      <source>Click one to see it.</source>
      <translation>Ein Klick zeigt es.</translation>
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
      <source>hole</source>
      <translation>Loch</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>rim</source>
      <translation>Rand</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>seam</source>
      <translation>Naht</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>slit</source>
      <translation>Schlitz</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>doubtful</source>
      <translation>zweifelhaft</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Hole</source>
      <translation>Loch</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Kind</source>
      <translation>Art</translation>
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
      <location filename="suture_workbench/gui/holes_tree.py" />
      <source>Hole {}</source>
      <translation>Loch {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>searched: the addon's own build, then the PATH</source>
      <translation>gesucht: im Addon gebaut, dann im PATH</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Largest gap between a new face and its neighbours</source>
      <translation>Größter Spalt zwischen einer neuen Fläche und ihren Nachbarn</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>The fill method to begin with</source>
      <translation>Das Füllverfahren, mit dem begonnen wird</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Show a preview unasked</source>
      <translation>Vorschau ungefragt zeigen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Give a run up after so long</source>
      <translation>Einen Lauf nach so langer Zeit aufgeben</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Program suture</source>
      <translation>Programm suture</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Largest angle</source>
      <translation>Größter Winkel</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Largest curvature mismatch</source>
      <translation>Größte Krümmungsabweichung</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Default method</source>
      <translation>Übliches Verfahren</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>Time limit</source>
      <translation>Zeitgrenze</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/preferences_page.py" />
      <source>found: {}</source>
      <translation>gefunden: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/progress.py" />
      <source>Working…</source>
      <translation>Wird berechnet…</translation>
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
      <source>as above</source>
      <translation>wie oben</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Pass through</source>
      <translation>Hindurch durch</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Add selected</source>
      <translation>Gewählte hinzufügen</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Select vertices or edges, of a sketch for example, then click here</source>
      <translation>Wählen Sie Punkte oder Kanten, etwa einer Skizze, und klicken Sie dann hier</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>From file…</source>
      <translation>Aus Datei…</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Points from a text file with x, y, z on each line</source>
      <translation>Punkte aus einer Textdatei mit x, y, z auf jeder Zeile</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Clear</source>
      <translation>Leeren</translation>
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
      <source>{} points</source>
      <translation>{} Punkte</translation>
    </message>
    <message>
      <location filename="suture_workbench/gui/through_list.py" />
      <source>Line {} of {} is no point x, y, z: {}</source>
      <translation>Zeile {} von {} ist kein Punkt x, y, z: {}</translation>
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
      <source>Install it (see README.md of Suture), and enter its path in Edit &gt; Preferences &gt; Suture.</source>
      <translation>Installieren Sie es (siehe README.md von Suture) und tragen Sie seinen Pfad unter Bearbeiten &gt; Einstellungen &gt; Suture ein.</translation>
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
or, if you have it, enter its path in Edit &gt; Preferences &gt; Suture.</source>
      <translation>Bauen Sie es, indem Sie in einem Terminal dies aufrufen:
    {} --version
oder tragen Sie, wenn es schon da ist, seinen Pfad unter Bearbeiten &gt; Einstellungen &gt; Suture ein.</translation>
    </message>
    <message>
      <location filename="suture_workbench/program.py" />
      <source>There is no program {}. Correct the path in Edit &gt; Preferences &gt; Suture, or clear it to have the usual places searched.</source>
      <translation>Es gibt kein Programm {}. Berichtigen Sie den Pfad unter Bearbeiten &gt; Einstellungen &gt; Suture, oder leeren Sie ihn, damit an den üblichen Orten gesucht wird.</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>Edge numbers are those after the loose faces were sewn.</source>
      <translation>Die Kantennummern gelten nach dem Zusammennähen der losen Flächen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>Hole {} passes {} points within {:.2g} mm.</source>
      <translation>Loch {}: {} Punkte auf {:.2g} mm genau getroffen.</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>Hole {}{} was refused: {}</source>
      <translation>Loch {}{} wurde abgelehnt: {}</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>The program's answer is not as expected ({}: {}). Is it too old?</source>
      <translation>Die Antwort des Programms ist anders als erwartet ({}: {}). Ist es zu alt?</translation>
    </message>
    <message>
      <location filename="suture_workbench/reports.py" />
      <source>Hole {}: Edge{} has a gap of {:.3g} mm and an angle of {:.3g}°.</source>
      <translation>Loch {}: Edge{} hat einen Spalt von {:.3g} mm und einen Winkel von {:.3g}°.</translation>
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
  </context>
</TS>
