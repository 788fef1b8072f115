<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>GaugeRows</name>
    <message>
        <source>gauge is on</source>
        <translation>Messstelle</translation>
    </message>
    <message>
        <source>Bar used to convert strain to force</source>
        <translation>Deren E-Modul und Querschnitt machen aus einer Dehnung eine Kraft</translation>
    </message>
    <message>
        <source>the rod or string</source>
        <translation>Stange oder Strang</translation>
    </message>
    <message>
        <source>another bar</source>
        <translation>anderer Stab</translation>
    </message>
    <message>
        <source>E of the bar</source>
        <translation>E des Stabs</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Diameter of the solid bar at the gauge</source>
        <translation>Des vollen Stabs an der Messstelle</translation>
    </message>
    <message>
        <source>gauge factor k</source>
        <translation>k-Faktor</translation>
    </message>
    <message>
        <source>Relative resistance over strain</source>
        <translation>Relative Widerstandsänderung je Dehnung</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>The impedance of the bar is its area times √(E ρ)</source>
        <translation>Des Stabs: Seine Impedanz ist Fläche mal √(E ρ)</translation>
    </message>
    <message>
        <source>bridge factor</source>
        <translation>Brückenfaktor</translation>
    </message>
    <message>
        <source>Active gauges: 1 quarter, 2 half, 4 full bridge; 2.6 full bridge with two gauges across a bar of Poisson&apos;s ratio 0.3</source>
        <translation>Aktive Dehnungsmessstreifen: 1 Viertel-, 2 Halb-, 4 Vollbrücke; 2,6 Vollbrücke mit zwei Streifen quer an einem Stab mit der Querkontraktionszahl 0,3</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Volts out of the amplifier over volts in</source>
        <translation>Des Verstärkers: Volt am Ausgang durch Volt am Eingang</translation>
    </message>
    <message>
        <source>excitation in V</source>
        <translation>Speisung in V</translation>
    </message>
    <message>
        <source>Supply of the bridge</source>
        <translation>Speisespannung der Brücke</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>force per volt</source>
        <translation>Kraft je Volt</translation>
    </message>
    <message>
        <source>Result of a calibration; it overrides the bridge</source>
        <translation>Aus einer Kalibrierung; sie geht der Brücke vor</translation>
    </message>
    <message>
        <source>Volts are no forces: type the force per volt of a calibration, or the excitation of the bridge.</source>
        <translation>Volt sind keine Kräfte: Geben Sie die Kraft je Volt einer Kalibrierung ein oder die Speisung der Brücke.</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>Schritt &amp;höher</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>Schritt &amp;tiefer</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Undocks and re-attaches the dock widget</source>
        <translation>Löst das Feld vom Fenster und setzt es wieder ein</translation>
    </message>
    <message>
        <source>Closes the dock widget</source>
        <translation>Schließt das Feld</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Zum übergeordneten Ordner</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Einen neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Als Liste zeigen</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Mit Einzelheiten zeigen</translation>
    </message>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateien vom Typ:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Wählen</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Ordner suchen</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Zuletzt besucht</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Seitenleiste</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Liste von Orten und Lesezeichen</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Zeigen </translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>&amp;Verborgene Dateien zeigen</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Neuer Ordner</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>Der Ordner konnte nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 gibt es schon.
Ersetzen?</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Die Datei wurde nicht gefunden.
Ist der Dateiname richtig?</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Der Ordner wurde nicht gefunden.
Ist sein Name richtig?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>„%1“ ist schreibgeschützt.
Trotzdem löschen?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>„%1“ wirklich löschen?</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Computer</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mein Computer</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Aus&amp;schneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>Details zeigen ...</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Details verbergen ...</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Alle speichern</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Ja, &amp;alle</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;ein, keine</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Voreinstellungen wiederherstellen</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Hierher rollen</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Linker Rand</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Rechter Rand</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Seite nach oben</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Seite nach unten</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Seite nach links</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Seite nach rechts</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Nach oben rollen</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Nach unten rollen</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Nach links rollen</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Nach rechts rollen</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Meta</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Nach links rollen</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Nach rechts rollen</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederherstellen: %1</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Aus&amp;schneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>&amp;Link kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>UnitKind</name>
    <message>
        <source>length of the rod</source>
        <translation>Länge der Stange</translation>
    </message>
    <message>
        <source>penetration, gap, diameter</source>
        <translation>Eindringung, Spalt, Durchmesser</translation>
    </message>
    <message>
        <source>force, thrust</source>
        <translation>Kraft, Andruck</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>penetration rate</source>
        <translation>Bohrfortschritt</translation>
    </message>
    <message>
        <source>blow frequency</source>
        <translation>Schlagfrequenz</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>attenuation</source>
        <translation>Wellendämpfung</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Angle of the hole below the horizontal. With it, the weight of machine and rod along the hole adds to the feed force.</source>
        <translation>Neigung des Bohrlochs unter die Waagerechte. Damit kommt das Gewicht von Maschine und Stange längs des Lochs zum Andruck hinzu.</translation>
    </message>
    <message>
        <source>Blows per second of the rock drill</source>
        <translation>Schläge des Bohrhammers in einer Sekunde</translation>
    </message>
    <message>
        <source>Number of consecutive blows (default: 1000)</source>
        <translation>Zahl der aufeinander folgenden Schläge (Standard: 1000)</translation>
    </message>
    <message>
        <source>Cross-section of a cone at the end towards the rock; `area` is that of the rear end</source>
        <translation>Querschnitt am gesteinsseitigen Ende eines Kegels, dessen `area` die des hinteren Endes ist</translation>
    </message>
    <message>
        <source>Cross-section of the rod, instead of diameter and bore</source>
        <translation>Querschnitt der Stange, anstelle von Durchmesser und Bohrung</translation>
    </message>
    <message>
        <source>Cross-section, instead of diameter and bore</source>
        <translation>Querschnitt, anstelle von Durchmesser und Bohrung</translation>
    </message>
    <message>
        <source>Damping between machine and rear end of the string, for many blows; needs a machine mass</source>
        <translation>Dämpfung zwischen Maschine und hinterem Ende des Strangs, für viele Schläge; braucht eine Maschinenmasse</translation>
    </message>
    <message>
        <source>Decay of the amplitude of a wave per length</source>
        <translation>Abnahme der Amplitude einer Welle je Länge</translation>
    </message>
    <message>
        <source>Density of all sections without one of their own</source>
        <translation>Dichte jedes Abschnitts, der keine eigene hat</translation>
    </message>
    <message>
        <source>Density of the elastic hammer (default: that of the rod)</source>
        <translation>Dichte des elastischen Hammers, die der Stange, wenn nicht gegeben</translation>
    </message>
    <message>
        <source>Density of the rod</source>
        <translation>Dichte der Stange</translation>
    </message>
    <message>
        <source>Density (default: that of the material)</source>
        <translation>Dichte, die des Werkstoffs, wenn nicht gegeben</translation>
    </message>
    <message>
        <source>Diameter of the elastic hammer</source>
        <translation>Durchmesser des elastischen Hammers</translation>
    </message>
    <message>
        <source>Diameter of the flushing hole, less than the outer diameter</source>
        <translation>Durchmesser des Spüllochs, kleiner als der Außendurchmesser</translation>
    </message>
    <message>
        <source>Duration of the hammer force; time constant of an exponential one</source>
        <translation>Dauer der Hammerkraft; Zeitkonstante einer exponentiellen</translation>
    </message>
    <message>
        <source>Elasticity parameter: loading over unloading stiffness; 1 is elastic</source>
        <translation>Elastizitätsparameter: Steifigkeit der Belastung durch die der Entlastung; 1 ist elastisch</translation>
    </message>
    <message>
        <source>Exponent of a power law F = k U (U/U1)^(p - 1) of loading; 1 is a straight line</source>
        <translation>Exponent eines Potenzgesetzes F = k U (U/U1)^(p - 1) der Belastung; 1 ist eine Gerade</translation>
    </message>
    <message>
        <source>Feed force that the drill rig applies</source>
        <translation>Andruck, den das Bohrgerät aufbringt</translation>
    </message>
    <message>
        <source>Force at which the slope of the loading curve changes</source>
        <translation>Kraft, ab der die Belastungskurve eine andere Steigung hat</translation>
    </message>
    <message>
        <source>Gap between bit and rock when the hammer strikes</source>
        <translation>Spalt zwischen Bohrkrone und Gestein, wenn der Hammer schlägt</translation>
    </message>
    <message>
        <source>Gap over 2 I0/Z; in a scenario with units it changes the gap</source>
        <translation>Kennzahl des Spalts d/(2 I0/Z); in einem Szenario mit Einheiten verstellt sie den Spalt</translation>
    </message>
    <message>
        <source>Number of times the sections of the first repeat follow one another</source>
        <translation>Wie oft die Abschnitte der ersten Wiederholung des Strangs aufeinander folgen</translation>
    </message>
    <message>
        <source>Impedance of the elastic hammer over that of the rod</source>
        <translation>Impedanz des elastischen Hammers durch die der Stange</translation>
    </message>
    <message>
        <source>Impulse of the hammer force</source>
        <translation>Kraftstoß der Hammerkraft</translation>
    </message>
    <message>
        <source>Impulse of the impact force on the rock, (1 + e) times that of the hammer</source>
        <translation>Kraftstoß der Kraft auf das Gestein, das (1 + e)-Fache dessen des Hammers</translation>
    </message>
    <message>
        <source>Largest compressive stress of the residual waves after the blow; for drill strings, over one round trip. The model does not damp them, a real rod does.</source>
        <translation>Größte Druckspannung der Restwellen nach dem Schlag; bei Bohrsträngen über einen Hin- und Rücklauf. Das Modell dämpft sie nicht, eine wirkliche Stange schon.</translation>
    </message>
    <message>
        <source>Largest compressive stress of uniform sections during the blow, until one transit time after the last separation of bit and rock; threads and shoulders raise it locally</source>
        <translation>Größte Druckspannung gleichförmiger Abschnitte, solange der Schlag dauert, bis zur letzten Trennung von Bohrkrone und Gestein und eine Laufzeit länger; Gewinde und Absätze erhöhen sie örtlich</translation>
    </message>
    <message>
        <source>Largest impact force</source>
        <translation>Größte Kraft auf das Gestein</translation>
    </message>
    <message>
        <source>Largest penetration of the bit during the blow</source>
        <translation>Größte Eindringung der Bohrkrone während des Schlags</translation>
    </message>
    <message>
        <source>Largest tensile stress of the residual waves after the blow; for drill strings, over one round trip. The model does not damp them, a real rod does.</source>
        <translation>Größte Zugspannung der Restwellen nach dem Schlag; bei Bohrsträngen über einen Hin- und Rücklauf. Das Modell dämpft sie nicht, eine wirkliche Stange schon.</translation>
    </message>
    <message>
        <source>Largest tensile stress of uniform sections during the blow, until one transit time after the last separation of bit and rock; threads and shoulders raise it locally</source>
        <translation>Größte Zugspannung gleichförmiger Abschnitte, solange der Schlag dauert, bis zur letzten Trennung von Bohrkrone und Gestein und eine Laufzeit länger; Gewinde und Absätze erhöhen sie örtlich</translation>
    </message>
    <message>
        <source>Length of the elastic hammer; one step of the blow lasts one round trip in it</source>
        <translation>Länge des elastischen Hammers; ein Hin- und Rücklauf darin ist eine Stufe des Schlags</translation>
    </message>
    <message>
        <source>Length of the rod or rod string, from the hammer to the bit</source>
        <translation>Länge der Stange oder des Strangs, vom Hammer zur Bohrkrone</translation>
    </message>
    <message>
        <source>Length of the section</source>
        <translation>Länge des Abschnitts</translation>
    </message>
    <message>
        <source>Lumped mass at the end towards the rock; for the last section of a string, the mass of the bit</source>
        <translation>Masse am gesteinsseitigen Ende; beim letzten Abschnitt eines Strangs eine Masse der Bohrkrone</translation>
    </message>
    <message>
        <source>Mass that the feed moves besides the rod: its weight counts with an inclination, its inertia when consecutive blows are solved</source>
        <translation>Masse, die der Vorschub außer der Stange bewegt: Ihr Gewicht zählt bei einer Neigung, ihre Trägheit bei der Berechnung aufeinanderfolgender Schläge</translation>
    </message>
    <message>
        <source>Mean hammer force, impulse over duration</source>
        <translation>Mittlere Hammerkraft, Kraftstoß durch Dauer</translation>
    </message>
    <message>
        <source>Standard deviation of the time between two blows, as a share of its mean; cut off at three deviations</source>
        <translation>Standardabweichung der (normalverteilten) Zeit zwischen zwei Schlägen, als Anteil ihres Mittels; Werte außerhalb von drei Standardabweichungen kommen nicht vor</translation>
    </message>
    <message>
        <source>Number of peaks of the impact force above 1 % of the largest</source>
        <translation>Anzahl der Spitzen der Kraft auf das Gestein über 1 % der größten</translation>
    </message>
    <message>
        <source>Start of the random numbers for the scatter of the intervals</source>
        <translation>Startwert der Zufallszahlen für die Streuung der Abstände</translation>
    </message>
    <message>
        <source>Outer diameter of a cone at the end towards the rock; `diameter` is that of the rear end, and the bore is constant</source>
        <translation>Außendurchmesser am gesteinsseitigen Ende eines Kegels, dessen `diameter` der des hinteren Endes ist; die Bohrung ist gleichbleibend</translation>
    </message>
    <message>
        <source>Outer diameter of the rod</source>
        <translation>Außendurchmesser der Stange</translation>
    </message>
    <message>
        <source>Outer diameter of the section</source>
        <translation>Außendurchmesser des Abschnitts</translation>
    </message>
    <message>
        <source>Residual penetration after the blow</source>
        <translation>Eindringung, die nach dem Schlag bleibt</translation>
    </message>
    <message>
        <source>Residual penetration times blow frequency. It is an upper limit for blows from rest: indexing, flushing and lost contact reduce it. Residual waves may add to it (page Drilling).</source>
        <translation>Bleibende Eindringung mal Schlagfrequenz. Sie ist eine Obergrenze für Schläge aus der Ruhe: Umsetzen, Spülung und verlorener Kontakt verringern sie. Restwellen können sie vergrößern (Seite Bohren).</translation>
    </message>
    <message>
        <source>Share of the hammer energy that remains in the hammer as waves</source>
        <translation>Anteil seiner Energie, der im Hammer hin und her läuft</translation>
    </message>
    <message>
        <source>Share of the hammer energy that remains as motion of the hammer after the blow</source>
        <translation>Anteil seiner Energie, mit dem sich der Hammer nach dem Schlag bewegt</translation>
    </message>
    <message>
        <source>Share of the hammer energy stored in the stiffness of the faces while they touch</source>
        <translation>Anteil der Energie des Hammers in der Steifigkeit der Schlagflächen, wo sie sich noch berühren</translation>
    </message>
    <message>
        <source>Share of the hammer energy lost in joints</source>
        <translation>Anteil der Energie des Hammers, den die Verbindungen aufnehmen</translation>
    </message>
    <message>
        <source>Share of the hammer energy that waves lose along the sections</source>
        <translation>Anteil der Energie des Hammers, den Wellen unterwegs verlieren</translation>
    </message>
    <message>
        <source>Share of the energy that moves the rod or the string back as a whole</source>
        <translation>Anteil der Energie, der die Stange oder den Strang als Ganzes zurückbewegt</translation>
    </message>
    <message>
        <source>Share of the energy that remains in the rod or string as waves</source>
        <translation>Anteil der Energie, der in der Stange oder im Strang hin und her läuft</translation>
    </message>
    <message>
        <source>Share of the energy that remains in the rock: the efficiency</source>
        <translation>Anteil der Energie, der im Gestein bleibt: der Wirkungsgrad</translation>
    </message>
    <message>
        <source>Share of the residual waves lost per round trip, for many blows</source>
        <translation>Anteil der Restwellen, der je Hin- und Rücklauf verloren geht, für viele Schläge</translation>
    </message>
    <message>
        <source>Slope of the loading curve above that corner, as a multiple of the stiffness</source>
        <translation>Steigung der Belastungskurve ab dieser Ecke, als Vielfaches der Steifigkeit</translation>
    </message>
    <message>
        <source>Stiffness of the damper&apos;s spring between machine and rear end of the string, for many blows; needs a machine mass</source>
        <translation>Steifigkeit der Dämpferfeder zwischen Maschine und hinterem Ende des Strangs, für viele Schläge; braucht eine Maschinenmasse</translation>
    </message>
    <message>
        <source>Stiffness group k t0/Z; in a scenario with units it changes the stiffness</source>
        <translation>Kennzahl der Steifigkeit k t0/Z; in einem Szenario mit Einheiten verstellt sie die Steifigkeit</translation>
    </message>
    <message>
        <source>Stiffness of bit and rock in primary loading</source>
        <translation>Steifigkeit von Bohrkrone und Gestein bei Erstbelastung</translation>
    </message>
    <message>
        <source>Stiffness of the contact of hammer and string (default: rigid)</source>
        <translation>Steifigkeit des Kontakts von Hammer und Strang; starr, wenn nicht gegeben</translation>
    </message>
    <message>
        <source>Stress up to which the rod stays elastic; a larger one gives a warning</source>
        <translation>Spannung, bis zu der die Stange elastisch ist; ein Schlag darüber löst eine Warnung aus</translation>
    </message>
    <message>
        <source>Stress up to which the section stays elastic; a larger one gives a warning</source>
        <translation>Spannung, bis zu der der Abschnitt elastisch ist; ein Schlag darüber löst eine Warnung aus</translation>
    </message>
    <message>
        <source>Summed over all contacts</source>
        <translation>Über alle Kontakte summiert</translation>
    </message>
    <message>
        <source>Tensile stress that the rod endures blow after blow; a larger one gives a warning</source>
        <translation>Zugspannung, die die Stange Schlag für Schlag erträgt; mehr löst eine Warnung aus</translation>
    </message>
    <message>
        <source>Tensile stress that the section endures blow after blow; a larger one gives a warning</source>
        <translation>Zugspannung, die der Abschnitt Schlag für Schlag erträgt; mehr löst eine Warnung aus</translation>
    </message>
    <message>
        <source>Transient blows at the start, excluded from statistics (default: a fifth of all)</source>
        <translation>Schläge zum Einschwingen am Anfang, die nicht in die Statistik eingehen (Standard: ein Fünftel aller)</translation>
    </message>
    <message>
        <source>Time of the first separation of hammer and string</source>
        <translation>Zeit, zu der sich Hammer und Strang zuerst trennen</translation>
    </message>
    <message>
        <source>Time in which a trapezoid falls, as a fraction of the duration</source>
        <translation>Zeit, in der ein Trapez fällt, als Anteil der Dauer</translation>
    </message>
    <message>
        <source>Time in which a trapezoid rises, as a fraction of the duration</source>
        <translation>Zeit, in der ein Trapez steigt, als Anteil der Dauer</translation>
    </message>
    <message>
        <source>Time of the first contact</source>
        <translation>Zeit des ersten Kontakts</translation>
    </message>
    <message>
        <source>Time of the last separation</source>
        <translation>Zeit der letzten Trennung</translation>
    </message>
    <message>
        <source>Time until when the blow on a drill string is followed (default: to its end)</source>
        <translation>Zeit, bis zu der der Schlag eines Bohrstrangs verfolgt wird; bis zu seinem Ende, wenn nicht gegeben</translation>
    </message>
    <message>
        <source>Transit time of the rod over t0; in a scenario with units it changes the rod length</source>
        <translation>Laufzeit der Stange durch t0; in einem Szenario mit Einheiten verstellt sie die Länge der Stange</translation>
    </message>
    <message>
        <source>Velocity of the elastic hammer when it hits the rod</source>
        <translation>Geschwindigkeit des elastischen Hammers, wenn er die Stange trifft</translation>
    </message>
    <message>
        <source>Velocity of the hammer after the blow, away from the rock</source>
        <translation>Geschwindigkeit des Hammers nach dem Schlag, vom Gestein weg</translation>
    </message>
    <message>
        <source>Velocity of the hammer when it strikes the string</source>
        <translation>Geschwindigkeit des Hammers, wenn er den Strang trifft</translation>
    </message>
    <message>
        <source>Difference of all shares together from 1</source>
        <translation>Abweichung der Summe aller Anteile von 1</translation>
    </message>
    <message>
        <source>Work of the hammer on the rod</source>
        <translation>Arbeit des Hammers an der Stange</translation>
    </message>
    <message>
        <source>Work of the hammer on the rod times the blow frequency</source>
        <translation>Arbeit des Hammers an der Stange mal der Schlagfrequenz</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of all sections without one of their own</source>
        <translation>E-Modul jedes Abschnitts, der keinen eigenen hat</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the elastic hammer (default: that of the rod)</source>
        <translation>E-Modul des elastischen Hammers, der der Stange, wenn nicht gegeben</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the rod; sets its wave speed with the density</source>
        <translation>E-Modul der Stange; bestimmt mit der Dichte ihre Wellengeschwindigkeit</translation>
    </message>
    <message>
        <source>Young&apos;s modulus (default: that of the material)</source>
        <translation>E-Modul, der des Werkstoffs, wenn nicht gegeben</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>attenuation</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>balance error</source>
        <translation>Bilanzfehler</translation>
    </message>
    <message>
        <source>between the faces</source>
        <translation>zwischen den Flächen</translation>
    </message>
    <message>
        <source>blow frequency</source>
        <translation>Schlagfrequenz</translation>
    </message>
    <message>
        <source>blow frequency times impulse, N, if the scenario gives a frequency</source>
        <translation>Schlagfrequenz mal Kraftstoß, N, wenn das Szenario eine Frequenz hat</translation>
    </message>
    <message>
        <source>blows</source>
        <translation>Schläge</translation>
    </message>
    <message>
        <source>bore</source>
        <translation>Bohrung</translation>
    </message>
    <message>
        <source>bound on the numerical error of cor</source>
        <translation>Schranke des numerischen Fehlers von e</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>cells x nodes</source>
        <translation>Zellen x Knoten</translation>
    </message>
    <message>
        <source>coefficient of restitution e = -pf/p0</source>
        <translation>Stoßzahl e = -pf/p0</translation>
    </message>
    <message>
        <source>compression, after</source>
        <translation>Druck, danach</translation>
    </message>
    <message>
        <source>compression, blow</source>
        <translation>Druck, Schlag</translation>
    </message>
    <message>
        <source>cor</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>cor error</source>
        <translation>Fehler der Stoßzahl</translation>
    </message>
    <message>
        <source>dashpot</source>
        <translation>Dämpfer</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>efficiency error</source>
        <translation>Fehler des Wirkungsgrads</translation>
    </message>
    <message>
        <source>efficiency recovered</source>
        <translation>mit Rückgewinn</translation>
    </message>
    <message>
        <source>efficiency plus the energy that returns with the hammer, for drill strings</source>
        <translation>Wirkungsgrad und was der Hammer an Energie mit zurücknimmt, bei einem Bohrstrang</translation>
    </message>
    <message>
        <source>elasticity</source>
        <translation>Elastizität</translation>
    </message>
    <message>
        <source>end area</source>
        <translation>Endquerschnitt</translation>
    </message>
    <message>
        <source>end diameter</source>
        <translation>Enddurchmesser</translation>
    </message>
    <message>
        <source>end time</source>
        <translation>Endzeit</translation>
    </message>
    <message>
        <source>energy stored in the stiffness of the faces, fraction of the hammer energy</source>
        <translation>Energie in der Steifigkeit der Schlagflächen, Anteil an der des Hammers</translation>
    </message>
    <message>
        <source>energy remaining in the rock, fraction of the hammer work</source>
        <translation>Energie, die im Gestein bleibt, Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>energy remaining in waves of the hammer, fraction of the hammer energy</source>
        <translation>Energie, die in Wellen des Hammers bleibt, Anteil an seiner eigenen</translation>
    </message>
    <message>
        <source>energy remaining in waves, fraction of the hammer work</source>
        <translation>Energie, die in Wellen bleibt, Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>energy lost in joints, fraction of the hammer energy</source>
        <translation>Energie, die in Verbindungen verloren geht, Anteil an der des Hammers</translation>
    </message>
    <message>
        <source>energy lost along the sections, fraction of the hammer energy</source>
        <translation>Energie, die auf dem Weg durch Abschnitte verloren geht, Anteil an der des Hammers</translation>
    </message>
    <message>
        <source>energy of the hammer&apos;s motion after the blow, fraction of that before it</source>
        <translation>Energie des als Ganzes zurücklaufenden Hammers, Anteil an der beim Aufschlag</translation>
    </message>
    <message>
        <source>energy of the rebound, fraction of the hammer work</source>
        <translation>Energie des Rückpralls, Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>energy of the string after the blow, fraction of the hammer energy</source>
        <translation>Energie des Strangs nach dem Schlag, Anteil an der des Hammers</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>error of e</source>
        <translation>Fehler von e</translation>
    </message>
    <message>
        <source>error of the energy balance, fraction of the hammer work</source>
        <translation>Fehler der Energiebilanz, Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>error of the momentum balance, fraction of I0</source>
        <translation>Fehler der Impulsbilanz, Anteil an I0</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponentiell</translation>
    </message>
    <message>
        <source>contact stiffness</source>
        <translation>Kontaktsteifigkeit</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>fatigue strength</source>
        <translation>Dauerfestigkeit</translation>
    </message>
    <message>
        <source>first contact</source>
        <translation>erster Kontakt</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>force peaks</source>
        <translation>Kraftspitzen</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>half sine</source>
        <translation>Halbsinus</translation>
    </message>
    <message>
        <source>hammer Young&apos;s modulus</source>
        <translation>Hammer-E</translation>
    </message>
    <message>
        <source>hammer density</source>
        <translation>Hammerdichte</translation>
    </message>
    <message>
        <source>hammer diameter</source>
        <translation>Hammer-⌀</translation>
    </message>
    <message>
        <source>hammer separates</source>
        <translation>Hammer löst sich</translation>
    </message>
    <message>
        <source>hammer length</source>
        <translation>Hammerlänge</translation>
    </message>
    <message>
        <source>hammer rebound</source>
        <translation>Hammerrückprall</translation>
    </message>
    <message>
        <source>hammer velocity</source>
        <translation>Hammergeschw.</translation>
    </message>
    <message>
        <source>hammer work W</source>
        <translation>Hammerarbeit W</translation>
    </message>
    <message>
        <source>hammer work times blow frequency, W, if the scenario gives a frequency</source>
        <translation>Hammerarbeit mal Schlagfrequenz, W, wenn das Szenario eine Frequenz hat</translation>
    </message>
    <message>
        <source>impedance ratio</source>
        <translation>Impedanzverhältn.</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>impulse of the impact force, 1 + e</source>
        <translation>Kraftstoß auf das Gestein, 1 + e</translation>
    </message>
    <message>
        <source>impulse on the rock</source>
        <translation>Kraftstoß Gestein</translation>
    </message>
    <message>
        <source>inclination</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>installed feed force</source>
        <translation>install. Andruck</translation>
    </message>
    <message>
        <source>into the hammer</source>
        <translation>in den Hammer</translation>
    </message>
    <message>
        <source>into the rebound</source>
        <translation>in den Rückprall</translation>
    </message>
    <message>
        <source>into the rock</source>
        <translation>ins Gestein</translation>
    </message>
    <message>
        <source>largest compression in the rod during the blow</source>
        <translation>größter Druck in der Stange, solange der Schlag dauert</translation>
    </message>
    <message>
        <source>largest compression of the residual waves, undamped</source>
        <translation>größter Druck der Restwellen, ungedämpft</translation>
    </message>
    <message>
        <source>largest impact force</source>
        <translation>größte Kraft auf das Gestein</translation>
    </message>
    <message>
        <source>largest penetration</source>
        <translation>größte Eindringung</translation>
    </message>
    <message>
        <source>largest penetration of the bit</source>
        <translation>größte Eindringung der Bohrkrone</translation>
    </message>
    <message>
        <source>largest tension in the rod during the blow</source>
        <translation>größter Zug in der Stange, solange der Schlag dauert</translation>
    </message>
    <message>
        <source>largest tension of the residual waves, undamped</source>
        <translation>größter Zug der Restwellen, ungedämpft</translation>
    </message>
    <message>
        <source>last separation</source>
        <translation>letzte Trennung</translation>
    </message>
    <message>
        <source>remaining in waves</source>
        <translation>in Wellen</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>loading work</source>
        <translation>Belastungsarbeit</translation>
    </message>
    <message>
        <source>loss</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>lost in joints</source>
        <translation>in Verbindungen</translation>
    </message>
    <message>
        <source>lost in sections</source>
        <translation>in Abschnitten</translation>
    </message>
    <message>
        <source>machine mass</source>
        <translation>Maschinenmasse</translation>
    </message>
    <message>
        <source>machine pushed back</source>
        <translation>Maschine weicht zurück</translation>
    </message>
    <message>
        <source>attached mass</source>
        <translation>angehängte Masse</translation>
    </message>
    <message>
        <source>mean force</source>
        <translation>mittlere Kraft</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>mid-step</source>
        <translation>Schrittmitte</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>momentum of the string after the blow, towards the rock, over that of the hammer</source>
        <translation>Impuls des Strangs nach dem Schlag, zum Gestein hin, durch den des Hammers</translation>
    </message>
    <message>
        <source>momentum residual</source>
        <translation>Fehler der Impulsbilanz</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>peaks of the impact force above 1 % of the largest</source>
        <translation>Spitzen der Kraft auf das Gestein über 1 % der größten</translation>
    </message>
    <message>
        <source>penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>penetration per blow</source>
        <translation>Eindringung/Schlag</translation>
    </message>
    <message>
        <source>penetration rate</source>
        <translation>Bohrfortschritt</translation>
    </message>
    <message>
        <source>residual penetration after the blow</source>
        <translation>Eindringung, die nach dem Schlag bleibt</translation>
    </message>
    <message>
        <source>residual penetration times blow frequency, m/s, if the scenario gives a frequency: an upper limit</source>
        <translation>bleibende Eindringung mal Schlagfrequenz, m/s, wenn das Szenario eine Frequenz hat: eine obere Grenze</translation>
    </message>
    <message>
        <source>percussion power</source>
        <translation>Schlagleistung</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>piston</source>
        <translation>Kolben</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>reference penetration</source>
        <translation>Bezugseindringung</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>rigid body</source>
        <translation>starrer Körper</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>transient blows</source>
        <translation>Einschwingen</translation>
    </message>
    <message>
        <source>share of the hammer work that remains in the rock</source>
        <translation>Anteil der Hammerarbeit, der im Gestein bleibt</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>error bound of the efficiency, for drill strings</source>
        <translation>angegebener Fehler des Wirkungsgrads eines Bohrstrangs</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>string energy</source>
        <translation>Energie des Strangs</translation>
    </message>
    <message>
        <source>string momentum</source>
        <translation>Impuls des Strangs</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>tension, after</source>
        <translation>Zug, danach</translation>
    </message>
    <message>
        <source>tension, blow</source>
        <translation>Zug, Schlag</translation>
    </message>
    <message>
        <source>thrust</source>
        <translation>Andruck</translation>
    </message>
    <message>
        <source>thrust margin</source>
        <translation>Reserve des Andrucks</translation>
    </message>
    <message>
        <source>time of the first separation of hammer and string</source>
        <translation>Zeit, zu der sich Hammer und Strang zuerst trennen</translation>
    </message>
    <message>
        <source>time in contact</source>
        <translation>Zeit in Kontakt</translation>
    </message>
    <message>
        <source>time in contact, summed over contacts</source>
        <translation>Zeit in Kontakt, über die Kontakte summiert</translation>
    </message>
    <message>
        <source>time of the first contact</source>
        <translation>Zeit des ersten Kontakts</translation>
    </message>
    <message>
        <source>time of the last separation</source>
        <translation>Zeit der letzten Trennung</translation>
    </message>
    <message>
        <source>end of the computed time of the blow</source>
        <translation>Zeit, bis zu der der Schlag verfolgt wurde</translation>
    </message>
    <message>
        <source>transit time</source>
        <translation>Laufzeit</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>velocity of the hammer after the blow, away from the rock, over that of impact</source>
        <translation>Geschwindigkeit des Hammers nach dem Schlag, vom Gestein weg, durch die beim Aufschlag</translation>
    </message>
    <message>
        <source>wave loss</source>
        <translation>Wellenverlust</translation>
    </message>
    <message>
        <source>waves in the hammer</source>
        <translation>Wellen im Hammer</translation>
    </message>
    <message>
        <source>work of the hammer over m v0^2/2</source>
        <translation>Hammerarbeit durch m v0^2/2</translation>
    </message>
    <message>
        <source>work on the rock up to the largest force, fraction of the hammer work</source>
        <translation>Arbeit am Gestein bis zur größten Kraft, Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>yield strength</source>
        <translation>Streckgrenze</translation>
    </message>
    <message>
        <source>Penetration at which a power law gives F = k U1</source>
        <translation>Eindringung, bei der ein Potenzgesetz F = k U1 ergibt</translation>
    </message>
    <message>
        <source>Penetration at which a power law gives F = k U1, in d0</source>
        <translation>Eindringung, bei der ein Potenzgesetz F = k U1 ergibt, in d0</translation>
    </message>
    <message>
        <source>remaining in the string</source>
        <translation>im Strang verblieben</translation>
    </message>
    <message>
        <source>bound on the error of e</source>
        <translation>Schranke für den Fehler von e</translation>
    </message>
    <message>
        <source>bound on the error of the efficiency</source>
        <translation>Schranke für den Fehler des Wirkungsgrads</translation>
    </message>
    <message>
        <source>error of the energy balance</source>
        <translation>Fehler der Energiebilanz</translation>
    </message>
    <message>
        <source>error of the momentum balance</source>
        <translation>Fehler der Impulsbilanz</translation>
    </message>
    <message>
        <source>computed until</source>
        <translation>berechnet bis</translation>
    </message>
    <message>
        <source>feed force margin at every gap</source>
        <translation>Reserve des Andrucks bei jedem Spalt</translation>
    </message>
    <message>
        <source>momentum of the string to the rock</source>
        <translation>Impuls des Strangs zum Gestein hin</translation>
    </message>
    <message>
        <source>restitution e</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>rock, and energy returned with the hammer</source>
        <translation>Gestein und was der Hammer zurücknimmt</translation>
    </message>
    <message>
        <source>feed force required by this blow</source>
        <translation>für diesen Schlag nötiger Andruck</translation>
    </message>
    <message>
        <source>a law of one line</source>
        <translation>ein Gesetz aus einer Geraden</translation>
    </message>
    <message>
        <source>a law with corners</source>
        <translation>ein Gesetz mit Ecken</translation>
    </message>
    <message>
        <source>a power law</source>
        <translation>ein Potenzgesetz</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>not_solved</source>
        <translation>nicht gelöst</translation>
    </message>
    <message>
        <source>pushed_back</source>
        <translation>weicht zurück</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>0.7 kg: Mitsubishi Materials, type 23, second hand; the shape assumed, so that it has that mass</source>
        <translation>0,7 kg: Mitsubishi Materials, Typ 23, aus zweiter Hand; die Form so angenommen, dass sich diese Masse ergibt</translation>
    </message>
    <message>
        <source>11 kW over 110 J (press release of 2005, second hand)</source>
        <translation>11 kW durch 110 J (Pressemitteilung von 2005, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>110 J at 10 m/s (press release of 2005, second hand); uniform, its length and velocity assumed</source>
        <translation>110 J bei 10 m/s (Pressemitteilung von 2005, aus zweiter Hand); gleichförmig, Länge und Geschwindigkeit angenommen</translation>
    </message>
    <message>
        <source>200 J at 10 m/s: 12 kW at 60 Hz (brochure 9865 0024, second hand); uniform, its length and velocity assumed</source>
        <translation>200 J bei 10 m/s: 12 kW bei 60 Hz (Prospekt 9865 0024, aus zweiter Hand); gleichförmig, Länge und Geschwindigkeit angenommen</translation>
    </message>
    <message>
        <source>200 J at 10 m/s: of 180 to 220 J (specification of the HC drifters, second hand); uniform, its length and velocity assumed</source>
        <translation>200 J bei 10 m/s: aus dem Bereich 180 bis 220 J (Datenblatt der HC-Bohrhämmer, aus zweiter Hand); gleichförmig, Länge und Geschwindigkeit angenommen</translation>
    </message>
    <message>
        <source>25 mm across flats, less a flushing hole of 8.6 mm (Epiroc catalogue 9866 0424, Robit, second hand)</source>
        <translation>Schlüsselweite 25 mm, abzüglich eines Spüllochs von 8,6 mm (Epiroc-Katalog 9866 0424, Robit, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>28 mm across flats, less a flushing hole of 8.8 mm (Sandvik, Robit catalogues, second hand)</source>
        <translation>Schlüsselweite 28 mm, abzüglich eines Spüllochs von 8,8 mm (Kataloge von Sandvik und Robit, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>308 J at 10 m/s: 18.5 kW at 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 to 19 kW); uniform, its length and velocity assumed</source>
        <translation>308 J bei 10 m/s: 18,5 kW bei 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 bis 19 kW); gleichförmig, Länge und Geschwindigkeit angenommen</translation>
    </message>
    <message>
        <source>32 mm across flats, less a flushing hole of 9.6 mm (Epiroc, Sandvik, Robit catalogues, second hand)</source>
        <translation>Schlüsselweite 32 mm, abzüglich eines Spüllochs von 9,6 mm (Kataloge von Epiroc, Sandvik und Robit, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>35 mm across flats, less a flushing hole of 9.5 mm (Epiroc, Sandvik, Robit catalogues, second hand)</source>
        <translation>Schlüsselweite 35 mm, abzüglich eines Spüllochs von 9,5 mm (Kataloge von Epiroc, Sandvik und Robit, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>3500 blows a minute (Power &amp; Motion, Hydraulic valves make machines rock solid)</source>
        <translation>3500 Schläge je Minute (Power &amp; Motion, Hydraulic valves make machines rock solid)</translation>
    </message>
    <message>
        <source>380 J at 10 m/s: the most of 250 to 380 J (specification of the HC drifters, second hand); uniform, its length and velocity assumed</source>
        <translation>380 J bei 10 m/s: der größte Wert von 250 bis 380 J (Datenblatt der HC-Bohrhämmer, aus zweiter Hand); gleichförmig, Länge und Geschwindigkeit angenommen</translation>
    </message>
    <message>
        <source>380 to 390 mm, 3.1 to 3.3 kg, bore 10 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>380 bis 390 mm, 3,1 bis 3,3 kg, Bohrung 10 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>406 mm, 3.3 kg, bore 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>406 mm, 3,3 kg, Bohrung 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>41 x 160 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>41 × 160 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>435 mm, 4.7 to 5.0 kg, bore 9.6 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>435 mm, 4,7 bis 5,0 kg, Bohrung 9,6 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>447 mm, 5.0 kg, bore 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>447 mm, 5,0 kg, Bohrung 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>50 Hz with 5.5 kW, second hand</source>
        <translation>50 Hz bei 5,5 kW, aus zweiter Hand</translation>
    </message>
    <message>
        <source>54 x 170 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>54 × 170 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>55 x 190 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>55 × 190 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>605 mm, 9.3 kg, bore 11.3 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>605 mm, 9,3 kg, Bohrung 11,3 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>63 x 210 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>63 × 210 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>7.5 kW over 165 J (press release of 2005, second hand)</source>
        <translation>7,5 kW durch 165 J (Pressemitteilung von 2005, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>72 x 235 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>72 × 235 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>770 mm, 13.1 to 14.3 kg, bore 6.6 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>770 mm, 13,1 bis 14,3 kg, Bohrung 6,6 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>790 mm, 14.8 kg, bore 11.3 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>790 mm, 14,8 kg, Bohrung 11,3 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>840 mm, 15.8 kg, bore 6.2 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>840 mm, 15,8 kg, Bohrung 6,2 mm (Mitsubishi Materials, Top Hammer Tools 2024, aus zweiter Hand); als wäre es gleichförmig, der Durchmesser aus der Masse</translation>
    </message>
    <message>
        <source>A bench-drilling rod in medium rock: a good case to start with. Look at energy and feed force: three quarters of the blow energy remain in the rock, most of the rest remains in the rod as waves, and the rebound decides the required feed force. Drag stiffness or gap and watch both change.</source>
        <translation>Eine Stange zum Strossenbohren in mittelhartem Gestein: ein guter Einstieg. Auf die Energie und den Andruck achten: drei Viertel der Schlagenergie bleiben im Gestein, der größte Teil des Rests läuft als Wellen in der Stange hin und her, und der Rückprall bestimmt den erforderlichen Andruck. Den Regler der Steifigkeit oder des Spalts ziehen, um zu sehen, wie sich beide ändern.</translation>
    </message>
    <message>
        <source>A heavy string in soft rock, struck by an elastic piston a little stiffer than the rod. Look at the steps of the hammer blow, each as long as the piston&apos;s own round trip, and at the deep penetration: soft rock takes up the wave so slowly that the contact lasts longer than a round trip of the wave in the rod.</source>
        <translation>Ein schwerer Strang in weichem Gestein, geschlagen von einem elastischen Kolben, der etwas steifer ist als die Stange. Auf die Stufen des Hammerschlags achten, jede so lang wie ein Hin- und Rücklauf im Kolben, und auf die tiefe Eindringung: weiches Gestein nimmt die Welle so langsam auf, dass der Kontakt länger dauert als ein Hin- und Rücklauf der Welle in der Stange.</translation>
    </message>
    <message>
        <source>A light drifter on hard rock. Look at the peak force and at the thrust needed: stiff rock answers a short blow with a high, brief force and throws the string back harder than softer rock, so that more feed force is needed for each joule that stays in the rock. Compare with the T38 rod in medium rock.</source>
        <translation>Ein leichter Bohrhammer auf hartem Gestein. Auf die Spitzenkraft und den nötigen Andruck achten: steifes Gestein beantwortet einen kurzen Schlag mit einer hohen, kurzen Kraft und wirft den Strang heftiger zurück als weicheres Gestein, so dass für jedes Joule, das im Gestein bleibt, mehr Andruck nötig ist. Mit der T38-Stange in mittelhartem Gestein vergleichen.</translation>
    </message>
    <message>
        <source>A rod without waves before the impact: it flies as a rigid body against the same spring as in Fig. 4 (a). Look at the single long contact and compare e = 0.990 with 1.401 there: the super rebound is the work of the pre-impact waves. The scales are those of Fig. 4, the unit of time being the t0 that gives tau = 10.</source>
        <translation>Eine Stange ohne Wellen vor dem Stoß: sie fliegt als starrer Körper gegen dieselbe Feder wie in Abb. 4 (a). Auf den einen langen Kontakt achten und e = 0,990 mit 1,401 dort vergleichen: der Überrückprall ist das Werk der Wellen vor dem Stoß. Die Bezugsgrößen sind die von Abb. 4, wobei die Einheit der Zeit das t0 ist, das tau = 10 ergibt.</translation>
    </message>
    <message>
        <source>BBC 54, BBC 120</source>
        <translation>BBC 54, BBC 120</translation>
    </message>
    <message>
        <source>BBE 57</source>
        <translation>BBE 57</translation>
    </message>
    <message>
        <source>COP 131EB</source>
        <translation>COP 131EB</translation>
    </message>
    <message>
        <source>COP 2160EX, COP 2560EX</source>
        <translation>COP 2160EX, COP 2560EX</translation>
    </message>
    <message>
        <source>COP 3038, COP 4038</source>
        <translation>COP 3038, COP 4038</translation>
    </message>
    <message>
        <source>COP 3060MEX</source>
        <translation>COP 3060MEX</translation>
    </message>
    <message>
        <source>COP 4050EX</source>
        <translation>COP 4050EX</translation>
    </message>
    <message>
        <source>COP 4050L</source>
        <translation>COP 4050L</translation>
    </message>
    <message>
        <source>Epiroc COP 1028</source>
        <translation>Epiroc COP 1028</translation>
    </message>
    <message>
        <source>Epiroc COP 1032</source>
        <translation>Epiroc COP 1032</translation>
    </message>
    <message>
        <source>Epiroc COP 1132</source>
        <translation>Epiroc COP 1132</translation>
    </message>
    <message>
        <source>Epiroc COP 1238K</source>
        <translation>Epiroc COP 1238K</translation>
    </message>
    <message>
        <source>Epiroc COP 1838</source>
        <translation>Epiroc COP 1838</translation>
    </message>
    <message>
        <source>Epiroc COP 628</source>
        <translation>Epiroc COP 628</translation>
    </message>
    <message>
        <source>Epiroc COP SC14</source>
        <translation>Epiroc COP SC14</translation>
    </message>
    <message>
        <source>Epiroc catalogue 9866 0424, second hand</source>
        <translation>Epiroc-Katalog 9866 0424, aus zweiter Hand</translation>
    </message>
    <message>
        <source>Epiroc catalogue 9866 0424, second hand; the weights of Robit and Sandvik agree within 2 %</source>
        <translation>Epiroc-Katalog 9866 0424, aus zweiter Hand; die Gewichte von Robit und Sandvik stimmen auf 2&#xa0;% überein</translation>
    </message>
    <message>
        <source>Fig. 4 (a) of the paper, elastic spring</source>
        <translation>Abb. 4 (a) der Veröffentlichung, elastische Feder</translation>
    </message>
    <message>
        <source>Fig. 4 (b) of the paper, bilinear rock</source>
        <translation>Abb. 4 (b) der Veröffentlichung, bilineares Gestein</translation>
    </message>
    <message>
        <source>Fig. 8 of the paper, gap of the smallest rebound</source>
        <translation>Abb. 8 der Veröffentlichung, Spalt des kleinsten Rückpralls</translation>
    </message>
    <message>
        <source>GT60, round 60 mm</source>
        <translation>GT60, rund 60 mm</translation>
    </message>
    <message>
        <source>KLEMM KD 1011, 11.5 kg</source>
        <translation>KLEMM KD 1011, 11,5 kg</translation>
    </message>
    <message>
        <source>KLEMM KD 1215R, 14.3 kg</source>
        <translation>KLEMM KD 1215R, 14,3 kg</translation>
    </message>
    <message>
        <source>KLEMM KD 2117, 16.5 kg</source>
        <translation>KLEMM KD 2117, 16,5 kg</translation>
    </message>
    <message>
        <source>KLEMM KD 2524, 24 kg</source>
        <translation>KLEMM KD 2524, 24 kg</translation>
    </message>
    <message>
        <source>KLEMM KD 3428, 28 kg</source>
        <translation>KLEMM KD 3428, 28 kg</translation>
    </message>
    <message>
        <source>KLEMM KD 408, 6.8 kg</source>
        <translation>KLEMM KD 408, 6,8 kg</translation>
    </message>
    <message>
        <source>Mitsubishi R28, 160 mm</source>
        <translation>Mitsubishi R28, 160 mm</translation>
    </message>
    <message>
        <source>Mitsubishi R32, 45 mm</source>
        <translation>Mitsubishi R32, 45 mm</translation>
    </message>
    <message>
        <source>Mitsubishi R38, 170 mm</source>
        <translation>Mitsubishi R38, 170 mm</translation>
    </message>
    <message>
        <source>Mitsubishi T38, 190 mm</source>
        <translation>Mitsubishi T38, 190 mm</translation>
    </message>
    <message>
        <source>Mitsubishi T45, 210 mm</source>
        <translation>Mitsubishi T45, 210 mm</translation>
    </message>
    <message>
        <source>Mitsubishi T51, 235 mm</source>
        <translation>Mitsubishi T51, 235 mm</translation>
    </message>
    <message>
        <source>Montabert HC 110</source>
        <translation>Montabert HC 110</translation>
    </message>
    <message>
        <source>Montabert HC 25</source>
        <translation>Montabert HC 25</translation>
    </message>
    <message>
        <source>Montabert HC 28</source>
        <translation>Montabert HC 28</translation>
    </message>
    <message>
        <source>Montabert HC 50</source>
        <translation>Montabert HC 50</translation>
    </message>
    <message>
        <source>R25, hex 25 mm</source>
        <translation>R25, Sechskant 25 mm</translation>
    </message>
    <message>
        <source>R32 drifter, 42 and 34 mm</source>
        <translation>R32-Bohrhammer, 42 und 34 mm</translation>
    </message>
    <message>
        <source>R32 rod, hard rock</source>
        <translation>R32-Stange, hartes Gestein</translation>
    </message>
    <message>
        <source>R32 shank, 350 mm</source>
        <translation>R32-Einsteckende, 350 mm</translation>
    </message>
    <message>
        <source>R32 string, one rod, hard rock</source>
        <translation>R32-Strang, eine Stange, hartes Gestein</translation>
    </message>
    <message>
        <source>R32, 150 mm</source>
        <translation>R32, 150 mm</translation>
    </message>
    <message>
        <source>R32, 48 mm</source>
        <translation>R32, 48 mm</translation>
    </message>
    <message>
        <source>R32, hex 28 mm</source>
        <translation>R32, Sechskant 28 mm</translation>
    </message>
    <message>
        <source>R32, hex 32 mm</source>
        <translation>R32, Sechskant 32 mm</translation>
    </message>
    <message>
        <source>R32, round 32 mm</source>
        <translation>R32, rund 32 mm</translation>
    </message>
    <message>
        <source>R38, 170 mm</source>
        <translation>R38, 170 mm</translation>
    </message>
    <message>
        <source>Reference case, rod arriving without waves</source>
        <translation>Referenzfall, Stange kommt ohne Wellen an</translation>
    </message>
    <message>
        <source>Rock that yields: from 90 kN on it loads along a line of a third of the slope. Look at the rock, whose curve bends, and at the peak force, which stays low while the bit goes deeper; `--set bit_rock.law=bilinear` is the same rock without the corner.</source>
        <translation>Gestein, das nachgibt: ab 90 kN verläuft die Belastung entlang einer Geraden mit einem Drittel der Steigung. Auf das Gestein achten, dessen Kurve abknickt, und auf die Spitzenkraft, die niedrig bleibt, während die Bohrkrone tiefer eindringt; `--set bit_rock.law=bilinear` ist dasselbe Gestein ohne die Ecke.</translation>
    </message>
    <message>
        <source>Sandvik HL 820ST</source>
        <translation>Sandvik HL 820ST</translation>
    </message>
    <message>
        <source>Sandvik catalogue 2024, second hand</source>
        <translation>Sandvik-Katalog 2024, aus zweiter Hand</translation>
    </message>
    <message>
        <source>Sandvik catalogue 2024, second hand; the weights there are 7 % less; the rod of the R32 examples</source>
        <translation>Sandvik-Katalog 2024, aus zweiter Hand; die Gewichte dort sind 7&#xa0;% kleiner; die Stange der R32-Beispiele</translation>
    </message>
    <message>
        <source>Sandvik, Robit catalogues, second hand; weights agree within 2 %</source>
        <translation>Kataloge von Sandvik und Robit, aus zweiter Hand; die Gewichte stimmen auf 2&#xa0;% überein</translation>
    </message>
    <message>
        <source>T38 drifter, 50 and 38 mm</source>
        <translation>T38-Bohrhammer, 50 und 38 mm</translation>
    </message>
    <message>
        <source>T38 rod, medium rock</source>
        <translation>T38-Stange, mittelhartes Gestein</translation>
    </message>
    <message>
        <source>T38 rod, rock not measured</source>
        <translation>T38-Stange, Gestein nicht gemessen</translation>
    </message>
    <message>
        <source>T38 rod, rock that yields</source>
        <translation>T38-Stange, nachgebendes Gestein</translation>
    </message>
    <message>
        <source>T38 shank, 450 mm</source>
        <translation>T38-Einsteckende, 450 mm</translation>
    </message>
    <message>
        <source>T38 string, three rods</source>
        <translation>T38-Strang, drei Stangen</translation>
    </message>
    <message>
        <source>T38, 190 mm</source>
        <translation>T38, 190 mm</translation>
    </message>
    <message>
        <source>T38, 190 mm, worn</source>
        <translation>T38, 190 mm, verschlissen</translation>
    </message>
    <message>
        <source>T38, 76 mm</source>
        <translation>T38, 76 mm</translation>
    </message>
    <message>
        <source>T38, round 38 mm</source>
        <translation>T38, rund 38 mm</translation>
    </message>
    <message>
        <source>T38, round 39 mm</source>
        <translation>T38, rund 39 mm</translation>
    </message>
    <message>
        <source>T45, round 46 mm</source>
        <translation>T45, rund 46 mm</translation>
    </message>
    <message>
        <source>T51 bench drill, 62 and 52 mm</source>
        <translation>T51-Bohrhammer zum Strossenbohren, 62 und 52 mm</translation>
    </message>
    <message>
        <source>T51 rod, soft rock, piston blow</source>
        <translation>T51-Stange, weiches Gestein, Kolbenschlag</translation>
    </message>
    <message>
        <source>T51 shank, 550 mm</source>
        <translation>T51-Einsteckende, 550 mm</translation>
    </message>
    <message>
        <source>T51 string, five rods, bench drilling</source>
        <translation>T51-Strang, fünf Stangen, Strossenbohren</translation>
    </message>
    <message>
        <source>T51, 100 mm</source>
        <translation>T51, 100 mm</translation>
    </message>
    <message>
        <source>T51, 240 mm</source>
        <translation>T51, 240 mm</translation>
    </message>
    <message>
        <source>T51, round 52 mm</source>
        <translation>T51, rund 52 mm</translation>
    </message>
    <message>
        <source>TEI TE300</source>
        <translation>TEI TE300</translation>
    </message>
    <message>
        <source>The gap alone turns a super rebound into a weak one. Look at the first force peak: the front end crosses a gap of 0.521 d0 during the first half of the wave, which is reflected as if there were no rock, and only the second half meets the spring; the rest comes back a round trip later. So e falls from 1.401 to 0.842. Drag the gap towards 0 or 1 to see it rise again.</source>
        <translation>Der Spalt allein macht aus einem Überrückprall einen schwachen Rückprall. Auf die erste Kraftspitze achten: das vordere Ende durchquert einen Spalt von 0,521 d0 während der ersten Hälfte der Welle, die reflektiert wird, als gäbe es kein Gestein, und erst die zweite Hälfte trifft die Feder; der Rest kommt einen Hin- und Rücklauf später zurück. So fällt e von 1,401 auf 0,842. Den Spalt gegen 0 oder 1 ziehen, um e wieder steigen zu sehen.</translation>
    </message>
    <message>
        <source>The paper&apos;s elastic blow. Look at the two force peaks and the impulse: the incident wave gives the first peak, which alone would send the rod back as fast as it came (impulse 2, e = 1); the wave that comes back from the free rear end gives the second, which adds 0.4. So e = 1.401, a super rebound, although no energy was added.</source>
        <translation>Der elastische Schlag der Veröffentlichung. Auf die beiden Kraftspitzen und den Kraftstoß achten: die einlaufende Welle ergibt die erste Spitze, die allein die Stange so schnell zurückschicken würde, wie sie kam (Kraftstoß 2, e = 1); die Welle, die vom freien hinteren Ende zurückkommt, ergibt die zweite, die 0,4 hinzufügt. So ist e = 1,401, ein Überrückprall, obwohl keine Energie zugeführt wurde.</translation>
    </message>
    <message>
        <source>The same blow on rock that keeps most of the work done on it. Look at the force peaks: they rise as in Fig. 4 (a) but fall ten times faster (slope k/γ, γ = 0.1), so the rock pushes back for a shorter time and the rod rebounds slowly: e = 0.407. Three quarters of the work of the hammer stay in the rock.</source>
        <translation>Derselbe Schlag auf Gestein, das den größten Teil der an ihm geleisteten Arbeit behält. Auf die Kraftspitzen achten: sie steigen wie in Abb. 4 (a), fallen aber zehnmal so schnell (Steigung k/γ, γ = 0,1), so dass das Gestein kürzer zurückdrückt und die Stange langsam zurückprallt: e = 0,407. Drei Viertel der Hammerarbeit bleiben im Gestein.</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>assumed: 1.3 kg; bits of this thread are 43 to 76 mm wide</source>
        <translation>angenommen: 1,3 kg; Bohrkronen mit diesem Gewinde haben 43 bis 76 mm Durchmesser</translation>
    </message>
    <message>
        <source>assumed: 12.4 kg, 562 J; front about as thick as the shank</source>
        <translation>angenommen: 12,4 kg, 562 J; vorn etwa so dick wie das Einsteckende</translation>
    </message>
    <message>
        <source>assumed: 208 J a blow in steel</source>
        <translation>angenommen: bei Stahl 208 J je Schlag</translation>
    </message>
    <message>
        <source>assumed: 244 MPa in a round R32 rod</source>
        <translation>angenommen: 244 MPa in einer runden R32-Stange</translation>
    </message>
    <message>
        <source>assumed: 3.2 kg; bits of this thread are 64 to 89 mm wide</source>
        <translation>angenommen: 3,2 kg; Bohrkronen mit diesem Gewinde haben 64 bis 89 mm Durchmesser</translation>
    </message>
    <message>
        <source>assumed: 4.1 kg, 187 J; front about as thick as the shank</source>
        <translation>angenommen: 4,1 kg, 187 J; vorn etwa so dick wie das Einsteckende</translation>
    </message>
    <message>
        <source>assumed: 451 J a blow in steel</source>
        <translation>angenommen: bei Stahl 451 J je Schlag</translation>
    </message>
    <message>
        <source>assumed: 6.9 kg, 342 J; front about as thick as the shank</source>
        <translation>angenommen: 6,9 kg, 342 J; vorn etwa so dick wie das Einsteckende</translation>
    </message>
    <message>
        <source>assumed: 7.5 kg; bits of this thread are 89 to 127 mm wide</source>
        <translation>angenommen: 7,5 kg; Bohrkronen mit diesem Gewinde haben 89 bis 127 mm Durchmesser</translation>
    </message>
    <message>
        <source>assumed: a blow of about 200 us in steel</source>
        <translation>angenommen: bei Stahl ein Schlag von etwa 200 us</translation>
    </message>
    <message>
        <source>assumed: a little thicker than a T51 rod is in steel</source>
        <translation>angenommen: bei Stahl etwas dicker als eine T51-Stange</translation>
    </message>
    <message>
        <source>assumed: a stiff test stand</source>
        <translation>angenommen: ein steifer Prüfstand</translation>
    </message>
    <message>
        <source>assumed: about 10 kW of percussion</source>
        <translation>angenommen: etwa 10 kW Schlagleistung</translation>
    </message>
    <message>
        <source>assumed: about 12 kW of percussion</source>
        <translation>angenommen: etwa 12 kW Schlagleistung</translation>
    </message>
    <message>
        <source>assumed: about 20 kW of percussion</source>
        <translation>angenommen: etwa 20 kW Schlagleistung</translation>
    </message>
    <message>
        <source>assumed: about 4 kg at 10 m/s</source>
        <translation>angenommen: etwa 4 kg bei 10 m/s</translation>
    </message>
    <message>
        <source>assumed: about 4 kg on a T38 rod</source>
        <translation>angenommen: etwa 4 kg auf einer T38-Stange</translation>
    </message>
    <message>
        <source>assumed: about the cross-section of a T38 rod</source>
        <translation>angenommen: etwa der Querschnitt einer T38-Stange</translation>
    </message>
    <message>
        <source>assumed: as thick as a T38 rod is in steel, so that it is almost at rest after the first push</source>
        <translation>angenommen: bei Stahl so dick wie eine T38-Stange, so dass er nach dem ersten Schub fast ruht</translation>
    </message>
    <message>
        <source>assumed: beta = 0.27 with a T51 rod and a blow of 0.23 ms</source>
        <translation>angenommen: beta = 0,27 mit einer T51-Stange und einem Schlag von 0,23 ms</translation>
    </message>
    <message>
        <source>assumed: beta = 0.53 with a T38 rod (the paper: of the order of 1 in drilling)</source>
        <translation>angenommen: beta = 0,53 mit einer T38-Stange (die Veröffentlichung: beim Bohren in der Größenordnung von 1)</translation>
    </message>
    <message>
        <source>assumed: beta = 1.5 with an R32 rod (the paper: of the order of 1 in drilling)</source>
        <translation>angenommen: beta = 1,5 mit einer R32-Stange (die Veröffentlichung: beim Bohren in der Größenordnung von 1)</translation>
    </message>
    <message>
        <source>assumed: heat-treated drill steel</source>
        <translation>angenommen: vergüteter Bohrstahl</translation>
    </message>
    <message>
        <source>assumed: less than half of the yield strength, smooth rod, no corrosion</source>
        <translation>angenommen: weniger als die halbe Streckgrenze, glatte Stange, keine Korrosion</translation>
    </message>
    <message>
        <source>assumed: mean force 255 kN, 331 J a blow in a T38 rod</source>
        <translation>angenommen: mittlere Kraft 255 kN, 331 J je Schlag in einer T38-Stange</translation>
    </message>
    <message>
        <source>assumed: more elastic than the 0.1 the paper takes for drilling</source>
        <translation>angenommen: elastischer als die 0,1, die die Veröffentlichung für das Bohren nimmt</translation>
    </message>
    <message>
        <source>assumed: piston about as thick as the rod</source>
        <translation>angenommen: Kolben etwa so dick wie die Stange</translation>
    </message>
    <message>
        <source>assumed: piston of about 0.39 m</source>
        <translation>angenommen: Kolben von etwa 0,39 m</translation>
    </message>
    <message>
        <source>assumed: piston of about 0.52 m</source>
        <translation>angenommen: Kolben von etwa 0,52 m</translation>
    </message>
    <message>
        <source>assumed: the maker gives none</source>
        <translation>angenommen: der Hersteller gibt keine an</translation>
    </message>
    <message>
        <source>assumed: twice that of hard rock</source>
        <translation>angenommen: das Doppelte des Werts für hartes Gestein</translation>
    </message>
    <message>
        <source>assumed: uniform hammer</source>
        <translation>angenommen: gleichförmiger Hammer</translation>
    </message>
    <message>
        <source>assumed: usual</source>
        <translation>angenommen: üblich</translation>
    </message>
    <message>
        <source>brochure 9865 0009, second hand</source>
        <translation>Prospekt 9865 0009, aus zweiter Hand</translation>
    </message>
    <message>
        <source>brochure 9865 0122, second hand</source>
        <translation>Prospekt 9865 0122, aus zweiter Hand</translation>
    </message>
    <message>
        <source>elastic anvil</source>
        <translation>elastischer Amboss</translation>
    </message>
    <message>
        <source>hard rock</source>
        <translation>hartes Gestein</translation>
    </message>
    <message>
        <source>heavy drifter, piston</source>
        <translation>schwerer Bohrhammer, Kolben</translation>
    </message>
    <message>
        <source>hex 35 mm, T38 and R32</source>
        <translation>Sechskant 35 mm, T38 und R32</translation>
    </message>
    <message>
        <source>light drifter, short blow</source>
        <translation>leichter Bohrhammer, kurzer Schlag</translation>
    </message>
    <message>
        <source>linear elastic: what goes in comes out</source>
        <translation>linear elastisch: was hineingeht, kommt wieder heraus</translation>
    </message>
    <message>
        <source>mass: the maker&apos;s product range of 2025, second hand; uniform, its length and velocity assumed</source>
        <translation>Masse: Lieferprogramm 2025 des Herstellers, aus zweiter Hand; gleichförmig, Länge und Geschwindigkeit angenommen</translation>
    </message>
    <message>
        <source>medium drifter</source>
        <translation>mittlerer Bohrhammer</translation>
    </message>
    <message>
        <source>medium drifter, piston</source>
        <translation>mittlerer Bohrhammer, Kolben</translation>
    </message>
    <message>
        <source>medium rock</source>
        <translation>mittelhartes Gestein</translation>
    </message>
    <message>
        <source>model: hammer much shorter and thicker than the rod</source>
        <translation>Modell: Hammer viel kürzer und dicker als die Stange</translation>
    </message>
    <message>
        <source>narrow bore R32, round 32 mm</source>
        <translation>R32 mit enger Bohrung, rund 32 mm</translation>
    </message>
    <message>
        <source>nominal size of the thread; the rod of the T38 example</source>
        <translation>Nennmaß des Gewindes; die Stange des T38-Beispiels</translation>
    </message>
    <message>
        <source>nominal, from the name of the rod</source>
        <translation>Nennmaß, aus dem Namen der Stange</translation>
    </message>
    <message>
        <source>of 40 to 62.5 Hz (specification of the HC drifters, second hand)</source>
        <translation>aus dem Bereich 40 bis 62,5 Hz (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>of 47 to 55 Hz (specification of the HC drifters, second hand)</source>
        <translation>aus dem Bereich 47 bis 55 Hz (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>of 55 to 65 Hz (specification of the HC drifters, second hand)</source>
        <translation>aus dem Bereich 55 bis 65 Hz (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>rigid hammer</source>
        <translation>starrer Hammer</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 110 J (press release of 2005, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 110 J schlägt (Pressemitteilung von 2005, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 117 J (specification of the HC drifters, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 117 J schlägt (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 149 J: 110 foot-pounds (Power &amp; Motion, Hydraulic valves make machines rock solid)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 149 J schlägt: 110 foot-pounds (Power &amp; Motion, Hydraulic valves make machines rock solid)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 160 J (specification of the HC drifters, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 160 J schlägt (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 165 J (press release of 2005, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 165 J schlägt (Pressemitteilung von 2005, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 175 J: 14 kW at 80 Hz (brochure 9865 0009, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 175 J schlägt: 14 kW bei 80 Hz (Prospekt 9865 0009, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 200 J: 12 kW at 60 Hz (brochure 9865 0024, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 200 J schlägt: 12 kW bei 60 Hz (Prospekt 9865 0024, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 200 J: of 180 to 220 J (specification of the HC drifters, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 200 J schlägt: aus dem Bereich 180 bis 220 J (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 308 J: 18.5 kW at 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 to 19 kW)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 308 J schlägt: 18,5 kW bei 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 bis 19 kW)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 350 J: 21 kW (specification of the DL431, second hand) at 60 Hz, which is assumed</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 350 J schlägt: 21 kW (Datenblatt des DL431, aus zweiter Hand) bei 60 Hz, die angenommen sind</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 380 J: the most of 250 to 380 J (specification of the HC drifters, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 380 J schlägt: der größte Wert von 250 bis 380 J (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 60 J: 6 kW at 100 Hz (brochure 9865 0122, second hand)</source>
        <translation>so dass ein Hammer aus Stahl bei 10 m/s mit 60 J schlägt: 6 kW bei 100 Hz (Prospekt 9865 0122, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>soft rock</source>
        <translation>weiches Gestein</translation>
    </message>
    <message>
        <source>steel, usual value</source>
        <translation>Stahl, üblicher Wert</translation>
    </message>
    <message>
        <source>that of the examples; loss assumed: a tight joint loses a few per cent, a worn one several times as much</source>
        <translation>die der Beispiele; Verlust angenommen: eine feste Verbindung verliert wenige Prozent, eine verschlissene ein Mehrfaches davon</translation>
    </message>
    <message>
        <source>the coupling of the T38 examples, 1 mm thicker than catalogues have it; bore assumed: that of the rod, the joint being full</source>
        <translation>die Kupplungsmuffe der T38-Beispiele, 1 mm dicker als in Katalogen; Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>the coupling of the T51 example, 5 mm longer than catalogues have it; bore assumed: that of the rod, the joint being full</source>
        <translation>die Kupplungsmuffe des T51-Beispiels, 5 mm länger als in Katalogen; Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>the least of 63 to 72 Hz (specification of the HC drifters, second hand)</source>
        <translation>der kleinste Wert von 63 bis 72 Hz (Datenblatt der HC-Bohrhämmer, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>the most (E&amp;MJ, Hydraulic drills hammer through)</source>
        <translation>der größte Wert (E&amp;MJ, Hydraulic drills hammer through)</translation>
    </message>
    <message>
        <source>the most of 40 to 60 Hz (brochure 9865 0024, second hand)</source>
        <translation>der größte Wert von 40 bis 60 Hz (Prospekt 9865 0024, aus zweiter Hand)</translation>
    </message>
    <message>
        <source>the paper&apos;s value for percussive drilling</source>
        <translation>der Wert der Veröffentlichung für schlagendes Bohren</translation>
    </message>
    <message>
        <source>uniform, 36 mm</source>
        <translation>gleichförmig, 36 mm</translation>
    </message>
    <message>
        <source>usual size in catalogues (45 x 150 mm); bore assumed: that of the rod, the joint being full</source>
        <translation>übliche Größe in Katalogen (45 × 150 mm); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>usual size in catalogues (55 x 170 mm); bore assumed: that of the rod, the joint being full</source>
        <translation>übliche Größe in Katalogen (55 × 170 mm); Bohrung angenommen: die der Stange, da die Verbindung ausgefüllt ist</translation>
    </message>
    <message>
        <source>very hard rock</source>
        <translation>sehr hartes Gestein</translation>
    </message>
    <message>
        <source>5 % of the gaps</source>
        <translation>5&#xa0;% der Spalte</translation>
    </message>
    <message>
        <source>95 % of the gaps</source>
        <translation>95&#xa0;% der Spalte</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Ljapunow-Exponent</translation>
    </message>
    <message>
        <source>number of blows after which the motion repeats, 1 to 16; 0 if it does not repeat</source>
        <translation>Zahl der Schläge, nach denen sich die Bewegung wiederholt, 1 bis 16; 0, wenn sie sich nicht wiederholt</translation>
    </message>
    <message>
        <source>contact share: blows that start with the bit on the rock</source>
        <translation>Schläge, die auf dem Gestein beginnen</translation>
    </message>
    <message>
        <source>contacts of a blow</source>
        <translation>Kontakte je Schlag</translation>
    </message>
    <message>
        <source>mean number of contacts between bit and rock in a blow</source>
        <translation>mittlere Zahl der Kontakte zwischen Bohrkrone und Gestein in einem Schlag</translation>
    </message>
    <message>
        <source>deviation of the gap</source>
        <translation>Streuung des Spalts</translation>
    </message>
    <message>
        <source>error of the energy balance of all blows, as a share of the hammer work</source>
        <translation>Fehler der Energiebilanz aller Schläge, als Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>error of the momentum balance of all blows, relative to the impulse of the feed force</source>
        <translation>Fehler der Impulsbilanz aller Schläge, bezogen auf den Kraftstoß des Andrucks</translation>
    </message>
    <message>
        <source>error of the energy of many blows</source>
        <translation>Fehler der Energie vieler Schläge</translation>
    </message>
    <message>
        <source>error of the mean penetration</source>
        <translation>Fehler der mittleren Eindringung</translation>
    </message>
    <message>
        <source>error of the momentum of many blows</source>
        <translation>Fehler des Impulses vieler Schläge</translation>
    </message>
    <message>
        <source>gap between bit and rock that 95 % of the blows exceed</source>
        <translation>Spalt zwischen Bohrkrone und Gestein, den 95&#xa0;% der Schläge überschreiten</translation>
    </message>
    <message>
        <source>gap between bit and rock that 5 % of the blows exceed</source>
        <translation>Spalt zwischen Bohrkrone und Gestein, den 5&#xa0;% der Schläge überschreiten</translation>
    </message>
    <message>
        <source>median of the gap between bit and rock at the start of the blows</source>
        <translation>Median des Spalts zwischen Bohrkrone und Gestein zu Beginn der Schläge</translation>
    </message>
    <message>
        <source>Lyapunov exponent: growth of a small disturbance per blow; above 0, single blows are not reproducible and only mean values count. Needs a second simulation of all blows</source>
        <translation>Lyapunov-Exponent: Wachstum einer kleinen Störung je Schlag; über 0 sind einzelne Schläge nicht reproduzierbar, und nur Mittelwerte zählen. Braucht eine zweite Simulation aller Schläge</translation>
    </message>
    <message>
        <source>95 % error of drill_penetration, the mean penetration per blow. Needs a second simulation of all blows, with other time steps</source>
        <translation>95-%-Fehler von drill_penetration, der mittleren Eindringung je Schlag. Braucht eine zweite Simulation aller Schläge, mit anderen Zeitschritten</translation>
    </message>
    <message>
        <source>largest force in the damper between machine and rod</source>
        <translation>größte Kraft im Dämpfer zwischen Maschine und Stange</translation>
    </message>
    <message>
        <source>mean gap at the blow</source>
        <translation>mittlerer Spalt beim Schlag</translation>
    </message>
    <message>
        <source>mean gap between bit and rock at the start of the blows, from `drill`</source>
        <translation>mittlerer Spalt zwischen Bohrkrone und Gestein zu Beginn der Schläge, aus `drill`</translation>
    </message>
    <message>
        <source>mean impulse on the rock</source>
        <translation>mittlerer Kraftstoß auf das Gestein</translation>
    </message>
    <message>
        <source>mean impulse on the rock per blow: feed force over blow frequency</source>
        <translation>mittlerer Kraftstoß auf das Gestein je Schlag: Andruck durch Schlagfrequenz</translation>
    </message>
    <message>
        <source>mean over all blows of the largest force on the rock</source>
        <translation>Mittel der größten Kraft auf das Gestein über alle Schläge</translation>
    </message>
    <message>
        <source>mean peak force</source>
        <translation>mittlere Spitzenkraft</translation>
    </message>
    <message>
        <source>mean penetration of a blow</source>
        <translation>mittlere Eindringung je Schlag</translation>
    </message>
    <message>
        <source>mean penetration per blow; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>mittlere Eindringung je Schlag; eine obere Grenze, da alles Gestein unter der Krone als gebrochen gilt</translation>
    </message>
    <message>
        <source>penetration rate, m/s: mean penetration per blow times blow frequency; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>Bohrfortschritt, m/s: mittlere Eindringung je Schlag mal Schlagfrequenz; eine obere Grenze, da alles Gestein unter der Krone als gebrochen gilt</translation>
    </message>
    <message>
        <source>median of the gaps</source>
        <translation>Median der Spalte</translation>
    </message>
    <message>
        <source>number of round trips that a wave makes through rod or string between two blows (n_b)</source>
        <translation>Zahl der Hin- und Rückläufe einer Welle durch Stange oder Strang zwischen zwei Schlägen (n_b)</translation>
    </message>
    <message>
        <source>penetration rate of many blows</source>
        <translation>Bohrfortschritt vieler Schläge</translation>
    </message>
    <message>
        <source>period of the motion</source>
        <translation>Periode der Bewegung</translation>
    </message>
    <message>
        <source>effective feed force divided by the mean force of the blows (phi); below 1 the blows push the machine back</source>
        <translation>wirksamer Andruck durch die mittlere Kraft der Schläge (phi); unter 1 schieben die Schläge die Maschine zurück</translation>
    </message>
    <message>
        <source>round trips from blow to blow</source>
        <translation>Hin- und Rückläufe von Schlag zu Schlag</translation>
    </message>
    <message>
        <source>contact share: share of blows that start with the bit on the rock, or less than 0.05 d0 away from it. d0 = 2 I0/Z, with the impulse I0 of a blow and the impedance Z of the rod</source>
        <translation>Kontaktanteil: Anteil der Schläge, die mit der Bohrkrone am Gestein beginnen oder weniger als 0,05 d0 davon entfernt. d0 = 2 I0/Z, mit dem Kraftstoß I0 eines Schlags und der Impedanz Z der Stange</translation>
    </message>
    <message>
        <source>standard deviation of the gap between bit and rock at the start of the blows</source>
        <translation>Standardabweichung des Spalts zwischen Bohrkrone und Gestein zu Beginn der Schläge</translation>
    </message>
    <message>
        <source>thrust number</source>
        <translation>Andruckzahl</translation>
    </message>
    <message>
        <source>bound on the error of the stresses</source>
        <translation>Schranke für den Fehler der Spannungen</translation>
    </message>
    <message>
        <source>error bound of the largest stresses of a drill string, fraction of each</source>
        <translation>angegebener Fehler der größten Spannungen eines Bohrstrangs, als Anteil einer jeden</translation>
    </message>
    <message>
        <source>stress error</source>
        <translation>Fehler der Spannungen</translation>
    </message>
    <message>
        <source>95 % of all gaps</source>
        <translation>95 % aller Spalte</translation>
    </message>
    <message>
        <source>not enough</source>
        <translation>reicht nicht</translation>
    </message>
    <message>
        <source>fully elastic rock (gamma = 1), worst gap</source>
        <translation>vollelastisches Gestein (gamma = 1), ungünstigster Spalt</translation>
    </message>
    <message>
        <source>no estimate</source>
        <translation>keine Schätzung</translation>
    </message>
    <message>
        <source>enough in all cases</source>
        <translation>reicht in allen Fällen</translation>
    </message>
    <message>
        <source>returns the rod in time</source>
        <translation>Stange kehrt rechtzeitig zurück</translation>
    </message>
    <message>
        <source>rigid rock</source>
        <translation>starres Gestein</translation>
    </message>
    <message>
        <source>this blow</source>
        <translation>dieser Schlag</translation>
    </message>
    <message>
        <source>A T38 string of three rods with its hammer. Look at the efficiency, which the joints decide: 0.32 of the energy of the hammer stays in the rock. Each joint is assumed to lose 5 % of the energy that passes; without these losses 0.50 would stay. The couplings are of larger impedance than the rods and reflect part of every wave; as thin as the rod they would leave 0.41. Then look at the largest tension.</source>
        <translation>Ein T38-Strang aus drei Stangen mit seinem Hammer. Man beachte den Wirkungsgrad, über den die Verbindungen entscheiden: 0,32 der Energie des Hammers bleiben im Gestein. Jede Verbindung verliert nach Annahme 5&#xa0;% der Energie, die hindurchgeht; ohne diese Verluste blieben 0,50. Die Kupplungsmuffen haben eine größere Impedanz als die Stangen und werfen einen Teil jeder Welle zurück; so dünn wie die Stange ließen sie 0,41. Dann beachte man den größten Zug.</translation>
    </message>
    <message>
        <source>A bench drilling string of five T51 rods. Look at the efficiency, 0.24 where three T38 rods have 0.32, and set string.repeat to fewer and to more rods: the first joints of a string cost more than the last. Each is assumed to lose 5 % of the energy that passes; without these losses 0.46 would stay in the rock.</source>
        <translation>Ein Strang aus fünf T51-Stangen zum Strossenbohren. Man beachte den Wirkungsgrad, 0,24, wo drei T38-Stangen 0,32 haben, und setze string.repeat auf weniger und auf mehr Stangen: die ersten Verbindungen eines Strangs kosten mehr als die letzten. Jede verliert nach Annahme 5&#xa0;% der Energie, die hindurchgeht; ohne diese Verluste blieben 0,46 im Gestein.</translation>
    </message>
    <message>
        <source>A light drifter with one R32 rod on hard rock. Look at the efficiency: 0.56, where three T38 rods in softer rock have 0.32. Each joint is assumed to lose 5 % of the energy that passes, and a string of one rod has few of them; without these losses 0.67 would stay in the rock, and 8 % would move back with the hammer, not 0.7 %.</source>
        <translation>Ein leichter Bohrhammer mit einer R32-Stange auf hartem Gestein. Man beachte den Wirkungsgrad: 0,56, wo drei T38-Stangen in weicherem Gestein 0,32 haben. Jede Verbindung verliert nach Annahme 5&#xa0;% der Energie, die hindurchgeht, und ein Strang aus einer Stange hat wenige davon; ohne diese Verluste blieben 0,67 im Gestein, und 8&#xa0;% gingen mit dem Hammer zurück, nicht 0,7&#xa0;%.</translation>
    </message>
    <message>
        <source>assumed: case-hardened Cr-Ni-Mo steel; fatigue: the 400 MPa of a smooth bar over a notch factor of 1.6 for threads and splines</source>
        <translation>angenommen: einsatzgehärteter Cr-Ni-Mo-Stahl; Ermüdung: die 400 MPa eines glatten Stabs durch eine Kerbwirkungszahl von 1,6 für Gewinde und Verzahnung</translation>
    </message>
    <message>
        <source>hammer</source>
        <translation>Hammer</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>Stange</translation>
    </message>
    <message>
        <source>bit</source>
        <translation>Bohrkrone</translation>
    </message>
    <message>
        <source>adapter</source>
        <translation>Einsteckende</translation>
    </message>
    <message>
        <source>coupling</source>
        <translation>Kupplungsmuffe</translation>
    </message>
    <message>
        <source>bit skirt</source>
        <translation>Kronenschaft</translation>
    </message>
    <message>
        <source>bit head</source>
        <translation>Kronenkopf</translation>
    </message>
    <message>
        <source>Which blow for rock that nobody has measured? Look at the page Design: the blow that is best in this rock loses much in softer and springier rock, a longer one of the same energy less. The command is `drillwave design piston_for_unknown_rock`; the block design holds its set-up.</source>
        <translation>Welcher Schlag für Gestein, das niemand gemessen hat? Die Seite Auslegung ansehen: der Schlag, der in diesem Gestein am besten ist, verliert viel in weicherem und stärker federndem Gestein, ein längerer mit derselben Energie weniger. Der Befehl ist `drillwave design piston_for_unknown_rock`; der Block design enthält die Einstellungen dazu.</translation>
    </message>
    <message>
        <source>Share of the energy of a wave that is lost in the joint at the end towards the rock: 3 to 6 % with tight threads, 6 to 10 % with worn threads (trade texts, not measured)</source>
        <translation>Anteil der Energie einer Welle, der in der Verbindung am Ende zum Gestein hin verloren geht: 3 bis 6 % bei festem, 6 bis 10 % bei verschlissenem Gewinde (Fachtexte, nicht gemessen)</translation>
    </message>
    <message>
        <source>enough for this blow only</source>
        <translation>reicht nur für diesen Schlag</translation>
    </message>
    <message>
        <source>rock</source>
        <translation>Gestein</translation>
    </message>
    <message>
        <source>effective feed force over the largest of the four required ones, less 1, if the scenario gives them; takes a study of all gaps</source>
        <translation>wirksamer Andruck durch den größten der vier erforderlichen, weniger 1, wenn das Szenario sie hat; braucht eine Studie aller Spalte</translation>
    </message>
</context>
<context>
    <name>drillwave</name>
    <message>
        <source>it is damaged, or written by another version of the program</source>
        <translation>sie ist beschädigt oder von einer anderen Version des Programms geschrieben</translation>
    </message>
    <message>
        <source>No value has statistics.</source>
        <translation>Zu keinem Wert gibt es eine Statistik.</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>größer als %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source>%1 to below %2</source>
        <translation>%1 bis unter %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Range: %1; usual: %2 – %3.</source>
        <translation>Bereich: %1; üblich: %2 – %3.</translation>
    </message>
    <message>
        <source>F1: its place in the manual.</source>
        <translation>F1: die Stelle im Handbuch.</translation>
    </message>
    <message>
        <source>kept in the scenario itself</source>
        <translation>im Szenario selbst enthalten</translation>
    </message>
    <message>
        <source>%1 points, scaled to t₀ and I₀, %2</source>
        <translation>%1 Punkte, auf t₀ und I₀ skaliert, %2</translation>
    </message>
    <message>
        <source>%1 points, %2, %3, %4</source>
        <translation>%1 Punkte, %2, %3, %4</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>darf nicht negativ sein</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>muss größer als 0 sein</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>darf nicht 0 sein</translation>
    </message>
    <message>
        <source>%1: unit</source>
        <translation>%1: Einheit</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>um %1</translation>
    </message>
    <message>
        <source>by less than %1</source>
        <translation>um weniger als %1</translation>
    </message>
    <message>
        <source>With the present rod and rock this changes e = %1 %2.</source>
        <translation>Mit der gezeigten Stange und dem gezeigten Gestein ändert das e = %1 %2.</translation>
    </message>
    <message>
        <source>Impulse %1, peak %2 at %3 in the file.</source>
        <translation>Kraftstoß %1, Spitze %2 bei %3 in der Datei.</translation>
    </message>
    <message>
        <source>All of the %1 samples are kept, of %2 in the record.</source>
        <translation>Alle %1 Abtastwerte bleiben, von %2 der Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1 of %2 samples become %3 points: no sample is further than %4 (%5 of the peak) from the lines between the points; the impulse changes by %6.</source>
        <translation>Aus %1 von %2 Abtastwerten werden %3 Punkte: Kein übernommener Abtastwert ist weiter als %4 (%5 der Spitze) von den Linien dazwischen entfernt, der Kraftstoß ändert sich um %6.</translation>
    </message>
    <message>
        <source>%1 negative samples are clipped, which adds %2 to the impulse.</source>
        <translation>%1 negative Abtastwerte werden abgeschnitten, was %2 zum Kraftstoß hinzufügt.</translation>
    </message>
    <message>
        <source>This is a large change: use a shorter part of the record.</source>
        <translation>Das ist viel: weniger von der Aufzeichnung nehmen.</translation>
    </message>
    <message>
        <source>%1 rows without a number are skipped, the first is line %2.</source>
        <translation>%1 Zeilen ohne Zahl werden übergangen, die erste ist Zeile %2.</translation>
    </message>
    <message>
        <source>hammer blow</source>
        <translation>Hammerschlag</translation>
    </message>
    <message>
        <source>elastic hammer</source>
        <translation>elastischer Hammer</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>nothing differs</source>
        <translation>keine Unterschiede</translation>
    </message>
    <message>
        <source>results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>(%1) − (%2)</source>
        <translation>(%1) − (%2)</translation>
    </message>
    <message>
        <source>((%1) − (%2)) / |%2| [%]</source>
        <translation>((%1) − (%2)) / |%2| [%]</translation>
    </message>
    <message>
        <source>this scenario</source>
        <translation>dieses Szenario</translation>
    </message>
    <message>
        <source>COR e</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>not solved yet</source>
        <translation>noch nicht gelöst</translation>
    </message>
    <message>
        <source>not solved: %1</source>
        <translation>nicht gelöst: %1</translation>
    </message>
    <message>
        <source>no such result here</source>
        <translation>hier kein solches Ergebnis</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>yield strength %1</source>
        <translation>Streckgrenze %1</translation>
    </message>
    <message>
        <source>fatigue strength %1</source>
        <translation>Dauerfestigkeit %1</translation>
    </message>
    <message>
        <source>yield strengths</source>
        <translation>Streckgrenzen</translation>
    </message>
    <message>
        <source>fatigue strengths</source>
        <translation>Dauerfestigkeiten</translation>
    </message>
    <message>
        <source>hammer %1</source>
        <translation>Hammer %1</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>Abschnitt %1</translation>
    </message>
    <message>
        <source>No curve on this axis has positive values.</source>
        <translation>Keine Kurve an dieser Achse hat positive Werte.</translation>
    </message>
    <message>
        <source>Curves on this axis have negative values; hide them first.</source>
        <translation>Kurven an dieser Achse haben negative Werte; erst ausblenden.</translation>
    </message>
    <message>
        <source>%1 at A</source>
        <translation>%1 bei A</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>%1 at B</source>
        <translation>%1 bei B</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>%1 from A to B</source>
        <translation>%1 von A bis B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>i. M.</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>integral</source>
        <translation>Integral</translation>
    </message>
    <message>
        <source>∫</source>
        <translation>∫</translation>
    </message>
    <message>
        <source>least %1 in view</source>
        <translation>kleinstes %1 im Bild</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>%1 of the least</source>
        <translation>%1 des kleinsten</translation>
    </message>
    <message>
        <source>at</source>
        <translation>bei</translation>
    </message>
    <message>
        <source>largest %1 in view</source>
        <translation>größtes %1 im Bild</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>%1 of the largest</source>
        <translation>%1 des größten</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 ab</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 bis</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>mean in view</source>
        <translation>Mittel im Bild</translation>
    </message>
    <message>
        <source>integral in view</source>
        <translation>Integral im Bild</translation>
    </message>
    <message>
        <source>Width and height must be from %1 to %2 mm.</source>
        <translation>Breite und Höhe müssen zwischen %1 und %2 mm liegen.</translation>
    </message>
    <message>
        <source>The resolution must be from %1 to %2 dpi.</source>
        <translation>Die Auflösung muss zwischen %1 und %2 dpi liegen.</translation>
    </message>
    <message>
        <source>That is more than %1 million pixels: choose a smaller size or a lower resolution.</source>
        <translation>Das sind mehr als %1 Millionen Pixel: kleinere Maße oder geringere Auflösung wählen.</translation>
    </message>
    <message>
        <source>Scenarios (*.yaml *.yml);;All files (*)</source>
        <translation>Szenarien (*.yaml *.yml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Scenarios and results (*.yaml *.yml *.csv *.json *.html);;All files (*)</source>
        <translation>Szenarien und Ergebnisse (*.yaml *.yml *.csv *.json *.html);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Die Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation>Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>Drillwave</source>
        <translation>Drillwave</translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>Open a scenario</source>
        <translation>Szenario öffnen</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>Szenario speichern</translation>
    </message>
    <message>
        <source>Export everything into a folder</source>
        <translation>Alles in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Unsaved changes found</source>
        <translation>Nicht gespeicherte Änderungen gefunden</translation>
    </message>
    <message>
        <source>Restore the unsaved changes to “%1”?</source>
        <translation>Die nicht gespeicherten Änderungen an „%1“ wiederherstellen?</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Numerical error ± %1</source>
        <translation>Numerischer Fehler ± %1</translation>
    </message>
    <message>
        <source>in the hammer, %1</source>
        <translation>im Hammer, %1</translation>
    </message>
    <message>
        <source>at x/L = %1, t = %2</source>
        <translation>bei x/L = %1, t = %2</translation>
    </message>
    <message>
        <source>Place and time where this value is first reached: a click leads there</source>
        <translation>Wo in der Stange das zuerst so groß ist, und wann: ein Klick führt dorthin</translation>
    </message>
    <message>
        <source>margin, this blow</source>
        <translation>Reserve, Schlag</translation>
    </message>
    <message>
        <source>installed</source>
        <translation>installiert</translation>
    </message>
    <message>
        <source>Feed force of the drill rig</source>
        <translation>Andruck des Bohrgeräts</translation>
    </message>
    <message>
        <source>Coefficient of restitution: momentum after the blow over momentum before it, reversed, e = −pf/p0</source>
        <translation>Stoßzahl: Impuls nach dem Schlag durch Impuls davor, umgekehrt, e = −pf/p0</translation>
    </message>
    <message>
        <source>Difference from %1</source>
        <translation>So viel anders als %1</translation>
    </message>
    <message>
        <source>%1, against %2: %3</source>
        <translation>%1, gegenüber %2: %3</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>kein %1</translation>
    </message>
    <message>
        <source>divides by zero</source>
        <translation>teilt durch null</translation>
    </message>
    <message>
        <source>has no number where one is needed</source>
        <translation>hat keine Zahl, wo eine nötig ist</translation>
    </message>
    <message>
        <source>has too many brackets in each other</source>
        <translation>hat zu viele Klammern ineinander</translation>
    </message>
    <message>
        <source>lacks a closing bracket; a unit follows it</source>
        <translation>fehlt eine schließende Klammer; eine Einheit steht dahinter</translation>
    </message>
    <message>
        <source>is too large</source>
        <translation>ist zu groß</translation>
    </message>
    <message>
        <source>can mean %1 or %2: write it without the separator, or as %3</source>
        <translation>kann %1 oder %2 bedeuten: ohne das Trennzeichen schreiben, oder als %3</translation>
    </message>
    <message>
        <source>is not one number: remove the separators of its digits</source>
        <translation>ist nicht eine Zahl: die Trennzeichen ihrer Ziffern entfernen</translation>
    </message>
    <message>
        <source>has more than one line: give one value</source>
        <translation>ist mehr als eine Zeile: ein Wert ist nötig</translation>
    </message>
    <message>
        <source>The program ended unexpectedly; the last change was at %1.</source>
        <translation>Das Programm endete unerwartet; die letzte Änderung ist von %1.</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier run cannot be restored.</source>
        <translation>Nicht gespeicherte Änderungen eines früheren Laufs können nicht wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>%1
The file is kept as %2 and not offered again.</source>
        <translation>%1
Die Datei bleibt als %2 erhalten und wird nicht noch einmal angeboten.</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>dieser Bericht</translation>
    </message>
    <message>
        <source>what</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>peaks differ by</source>
        <translation>Spitzen weichen ab um</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>Verzug</translation>
    </message>
    <message>
        <source>force N at %1</source>
        <translation>Kraft N bei %1</translation>
    </message>
    <message>
        <source>impact force</source>
        <translation>Kraft auf das Gestein</translation>
    </message>
    <message>
        <source>where &quot;%1&quot; was measured</source>
        <translation>dort, wo „%1“ gemessen wurde,</translation>
    </message>
    <message>
        <source>Measured signals are dashed.</source>
        <translation>Gemessenes ist gestrichelt.</translation>
    </message>
    <message>
        <source>Force over penetration: the area inside stays in the rock as energy.</source>
        <translation>Kraft über der Eindringung: die Fläche darin bleibt als Energie im Gestein.</translation>
    </message>
    <message>
        <source>The force in the rod over place and time, tension positive; bars at the right show contact of bit and rock. On the colour scale, lines mark the smallest and largest force, triangles forces beyond the colours.</source>
        <translation>Die Kraft in der Stange über Ort und Zeit, Zug positiv; Balken rechts zeigen den Kontakt von Krone und Gestein. Auf der Farbskala ist ein Strich die kleinste oder größte Kraft, ein Dreieck eine jenseits der Farben.</translation>
    </message>
    <message>
        <source>Hammer (dark) and string, lengths and diameters each to scale, with the numbers of the sections; the bore is dashed, the rock is at the right.</source>
        <translation>Hammer (dunkel) und Strang maßstäblich, Längen und Durchmesser je für sich, mit den Nummern der Abschnitte; die Bohrung ist gestrichelt, das Gestein rechts.</translation>
    </message>
    <message>
        <source>Restitution over one period of the gap between bit and rock, and its distribution when all gaps are equally likely.</source>
        <translation>Stoßzahl über einer Periode des Spalts zwischen Krone und Gestein, und wie sie verteilt ist, wenn alle Spalte gleich wahrscheinlich sind.</translation>
    </message>
    <message>
        <source>Required and installed feed force over the blow frequency.</source>
        <translation>Bedarfe an Andruck und der installierte Andruck über der Schlagfrequenz.</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>feed force margin, this blow</source>
        <translation>Reserve des Andrucks, dieser Schlag</translation>
    </message>
    <message>
        <source>feed force required at every gap</source>
        <translation>Andruck, der bei jedem Spalt genügt</translation>
    </message>
    <message>
        <source>feed force margin at every gap</source>
        <translation>Reserve des Andrucks bei jedem Spalt</translation>
    </message>
    <message>
        <source>hammer energy E₀</source>
        <translation>Hammerenergie E₀</translation>
    </message>
    <message>
        <source>Energy of the hammer before the blow; all shares refer to it. Its work on the string is smaller.</source>
        <translation>Energie des Hammers vor dem Schlag; alle Anteile beziehen sich auf sie, seine Arbeit am Strang ist kleiner</translation>
    </message>
    <message>
        <source>Effective feed force minus the feed force required by this blow, also as a share of it</source>
        <translation>Wirksamer Andruck abzüglich dessen, was dieser Schlag erfordert, und als Anteil davon</translation>
    </message>
    <message>
        <source>required, this blow</source>
        <translation>erforderlich, dieser Schlag</translation>
    </message>
    <message>
        <source>Mean force that balances this blow, which starts at rest on the rock</source>
        <translation>Mittlere Kraft, die diesen Schlag ausgleicht, der in Ruhe auf dem Gestein beginnt</translation>
    </message>
    <message>
        <source>return in time</source>
        <translation>rechtzeitig zurück</translation>
    </message>
    <message>
        <source>At this feed an undamped rigid rod is back at the rock before the next blow</source>
        <translation>Bei diesem Andruck ist eine ungedämpfte starre Stange vor dem nächsten Schlag zurück am Gestein</translation>
    </message>
    <message>
        <source>required, every gap</source>
        <translation>erforderlich, jeder Spalt</translation>
    </message>
    <message>
        <source>The largest force required by this blow, by 95 % of all gaps, on rigid rock, and by the worst gap on elastic rock</source>
        <translation>Die größte erforderliche Kraft: für diesen Schlag, für 95 % aller Spalte, auf starrem Gestein und beim schlechtesten Spalt auf elastischem Gestein</translation>
    </message>
    <message>
        <source>Effective feed force minus the largest of the four, also as a share of it: thrust_margin in commands and files</source>
        <translation>Wirksamer Andruck abzüglich der größten der vier Kräfte, und als Anteil davon: thrust_margin in Befehlen und Dateien</translation>
    </message>
    <message>
        <source>They leave a gap of %1, which is filled by a straight line.</source>
        <translation>Sie hinterlassen eine Lücke von %1, die eine Gerade überbrückt.</translation>
    </message>
    <message>
        <source>NUL bytes end the table: the recorder did not fill its file.</source>
        <translation>NUL-Bytes beenden die Tabelle: Der Rekorder hat seine Datei nicht gefüllt.</translation>
    </message>
    <message>
        <source>Restart &amp;now</source>
        <translation>Jetzt &amp;neu starten</translation>
    </message>
    <message>
        <source>The changes were made to %1, which stays as it is until you save.</source>
        <translation>Sie wurden an %1 vorgenommen, das bis zum Speichern unverändert bleibt.</translation>
    </message>
    <message>
        <source>Some pinned runs cannot be restored.</source>
        <translation>Einige angeheftete Läufe lassen sich nicht wiederherstellen.</translation>
    </message>
    <message>
        <source>Table: separator, decimal sign, the first line with a sample and the columns are found out; change what is wrong. A unit or a sampling rate that the table does not state has to be chosen.
Signal: force, strain, output of a bridge, voltage, stress or velocity in the unit of the column. A strain becomes a force by E and the area of the rod, of the string where the gauge is, or of another bar; a voltage by a calibration, or by gain, excitation and bridge factor; a velocity by the impedance. Tension is positive in the rod; a blow presses.
Zero line: the mean of the first samples, in which nothing happens.
Range: “Peak” takes the stretch around the largest value, “View” what the plot shows (Ctrl+wheel and Shift+drag zoom there), “All” the whole record.
Points at most: a blow keeps as few samples as leave impulse and e the same to 1e-4, unless you choose a number; a curve keeps so many. The summary says how far the others are from the lines between them.</source>
        <translation>Tabelle: Trennzeichen, Dezimalzeichen, die erste Zeile mit einem Abtastwert und die Spalten werden erkannt; ändern Sie, was nicht stimmt. Was in der Tabelle nicht steht, etwa eine Einheit oder die Abtastrate, ist zu wählen.
Signal: Kraft, Dehnung, Ausgang einer Brücke, Spannung in Volt, mechanische Spannung oder Geschwindigkeit in der Einheit der Spalte. Aus einer Dehnung wird eine Kraft durch E und die Fläche der Stange, des Strangs am Messstreifen oder eines anderen Stabs; aus Volt durch eine Kalibrierung oder durch Verstärkung, Speisung und Brückenfaktor; aus einer Geschwindigkeit durch die Impedanz. Zug ist in der Stange positiv; ein Schlag drückt.
Nulllinie: der Mittelwert der ersten Abtastwerte, in denen nichts geschieht.
Bereich: „Spitze“ nimmt das Stück um den größten Wert, „Ansicht“ das, was das Bild zeigt (Strg+Mausrad und Umschalt+Ziehen zoomen dort), „Alles“ die ganze Aufzeichnung.
Höchstens Punkte: Ein Schlag behält so wenige Abtastwerte, wie Kraftstoß und e auf 1e-4 gleich lassen, solange Sie keine Anzahl wählen; eine Kurve behält so viele. Die Zusammenfassung sagt, wie weit die übrigen von den Geraden dazwischen entfernt sind.</translation>
    </message>
    <message>
        <source>sections that differ</source>
        <translation>Unterschiede in Abschnitten</translation>
    </message>
    <message>
        <source>Continuous drilling: gap and penetration of every blow, how the gaps scatter and follow each other, and the shares of the energy.</source>
        <translation>Fortlaufendes Bohren: Spalt und Eindringung jedes Schlags, wie die Spalte streuen und aufeinander folgen, und die Anteile der Energie.</translation>
    </message>
    <message>
        <source>Penetration rate, contact and gaps of continuous drilling over one parameter.</source>
        <translation>Bohrfortschritt, Kontakt und Spalte des fortlaufenden Bohrens über einem Parameter.</translation>
    </message>
    <message>
        <source>The designs: the first aim over the choice, with its scatter. Several aims and several uncertain inputs are compared below.</source>
        <translation>Die Auslegungen: das erste Ziel über der Wahl, mit seiner Streuung. Mehrere Ziele und mehrere unsichere Eingaben sind darunter verglichen.</translation>
    </message>
    <message>
        <source>gain of the amplifier [%]</source>
        <translation>Verstärkung des Verstärkers [%]</translation>
    </message>
    <message>
        <source>zero line [% of the peak]</source>
        <translation>Nulllinie [% der Spitze]</translation>
    </message>
    <message>
        <source>place of the gauge</source>
        <translation>Ort des Messstreifens</translation>
    </message>
    <message>
        <source>Identify needs a scenario with physical units: a record of a gauge is in seconds and newtons. Edit ▸ Make a rig of these groups makes one.</source>
        <translation>Identifizieren braucht ein Szenario mit physikalischen Einheiten: Die Aufzeichnung eines Messstreifens ist in Sekunden und Newton. Bearbeiten ▸ Eine Anlage aus diesen Kennzahlen machen erzeugt eines.</translation>
    </message>
    <message>
        <source>Choose the column of the gauge.</source>
        <translation>Wählen Sie die Spalte des Messstreifens.</translation>
    </message>
    <message>
        <source>Type the distance of gauge %1 from the bit face.</source>
        <translation>Geben Sie den Abstand des Messstreifens %1 von der Bohrkrone ein.</translation>
    </message>
    <message>
        <source>Gauge %1 is not on a uniform section of the rod or string: correct its distance from the bit face.</source>
        <translation>Der Messstreifen %1 ist nicht auf einem gleichmäßigen Abschnitt der Stange oder des Strangs: Berichtigen Sie seinen Abstand von der Bohrkrone.</translation>
    </message>
    <message>
        <source>Identify reads stiffness and elasticity of the rock, and the gap between bit and rock, from strain gauges on the rod. Open a record of one blow, or of several blows along a hole.</source>
        <translation>Die Seite Identifizieren bestimmt Steifigkeit und Elastizität des Gesteins und den Spalt zwischen Bohrkrone und Gestein aus Messungen mit Dehnungsmessstreifen auf der Stange. Dazu die Aufzeichnung eines Schlags oder mehrerer Schläge entlang eines Bohrlochs öffnen.</translation>
    </message>
    <message>
        <source>During the blow, the largest compression is %1 (%2), the largest tension %3 (%4).</source>
        <translation>Während des Schlags ist die größte Druckspannung %1 (%2), die größte Zugspannung %3 (%4).</translation>
    </message>
    <message>
        <source>x/L = %1</source>
        <translation>x/L = %1</translation>
    </message>
    <message>
        <source>%1 from the face of the hammer</source>
        <translation>%1 von der Schlagfläche des Hammers</translation>
    </message>
</context>
<context>
    <name>drillwave::AccuracyPage</name>
    <message>
        <source>Error against run time, or the hardest cases against their limits</source>
        <translation>Fehler über der Rechenzeit, oder die schwersten Fälle an ihren Marken</translation>
    </message>
    <message>
        <source>This scenario</source>
        <translation>Dieses Szenario</translation>
    </message>
    <message>
        <source>The worst first; a click loads a case</source>
        <translation>Die schlechtesten zuerst; ein Klick lädt einen Fall</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Hard test cases (uniform rods)</source>
        <translation>Schwierige Testfälle (gleichförmige Stangen)</translation>
    </message>
    <message>
        <source>Solve this scenario with every method and measure errors and times</source>
        <translation>Dieses Szenario mit jedem Verfahren lösen und Fehler und Zeiten messen</translation>
    </message>
    <message>
        <source>Solve and check some thousand stiff and extreme cases</source>
        <translation>Einige tausend steife und extreme Fälle lösen und prüfen</translation>
    </message>
    <message>
        <source>Press “Run” under “Settings” to compare the errors and run times of all methods for this scenario.</source>
        <translation>Unter „Einstellungen“ auf „Rechnen“ drücken, um Fehler und Rechenzeiten aller Verfahren an diesem Szenario zu vergleichen.</translation>
    </message>
    <message>
        <source>Run solves and checks some thousand stiff and extreme cases.</source>
        <translation>Rechnen löst und prüft einige tausend steife und extreme Fälle.</translation>
    </message>
    <message>
        <source>Cases that break solvers, each with all its checks, the worst first. A click loads a case.</source>
        <translation>Fälle, an denen Verfahren scheitern, jeder mit allen Prüfungen, die schlechtesten zuerst. Ein Klick lädt einen Fall.</translation>
    </message>
    <message>
        <source>The efficiency of %1 is accurate to %2, the error bound of the method.</source>
        <translation>Der Wirkungsgrad von %1 ist auf %2 genau (Fehlerschranke des Verfahrens).</translation>
    </message>
    <message>
        <source>Accuracy of the results, and the results of other methods.</source>
        <translation>Wie richtig die Zahlen sind, und was andere Verfahren ergeben.</translation>
    </message>
    <message>
        <source>e = %1 is accurate to %2, the error bound of the exact solver.</source>
        <translation>e = %1 ist auf %2 genau (Fehlerschranke des exakten Verfahrens).</translation>
    </message>
    <message>
        <source>load the case %1</source>
        <translation>den Fall %1 laden</translation>
    </message>
    <message>
        <source>The study is not finished yet.</source>
        <translation>Die Studie ist noch nicht fertig.</translation>
    </message>
    <message>
        <source>The study was stopped before its end: run it again.</source>
        <translation>Die Studie wurde vor ihrem Ende angehalten: noch einmal rechnen.</translation>
    </message>
    <message>
        <source>There is nothing to write: run the study first.</source>
        <translation>Es gibt nichts zu schreiben: erst die Studie rechnen.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Run (%1 s)</source>
        <translation>Rechnen (%1 s)</translation>
    </message>
    <message>
        <source>Solving with the most exact method …</source>
        <translation>Lösen mit dem genauesten Verfahren …</translation>
    </message>
</context>
<context>
    <name>drillwave::AimRow</name>
    <message>
        <source>Maximise or minimise</source>
        <translation>Maximum oder Minimum</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>max.</translation>
    </message>
    <message>
        <source>Statistic</source>
        <translation>Nach welcher Statistik</translation>
    </message>
    <message>
        <source>Remove this aim</source>
        <translation>Dieses Ziel entfernen</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>max. %1</translation>
    </message>
    <message>
        <source>least %1</source>
        <translation>min. %1</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>kleinster Wert</translation>
    </message>
</context>
<context>
    <name>drillwave::AimRows</name>
    <message>
        <source>+ aim</source>
        <translation>+ Ziel</translation>
    </message>
    <message>
        <source>Adds an objective. The first one decides; the others show the trade-off.</source>
        <translation>Fügt ein Ziel hinzu. Das erste entscheidet; die anderen zeigen den Zielkonflikt.</translation>
    </message>
    <message>
        <source>for the</source>
        <translation>für</translation>
    </message>
    <message>
        <source>then the</source>
        <translation>dann</translation>
    </message>
</context>
<context>
    <name>drillwave::AlertLink</name>
    <message>
        <source>✖ not solved</source>
        <translation>✖ nicht gelöst</translation>
    </message>
    <message>
        <source>⚠ 1 warning</source>
        <translation>⚠ 1 Warnung</translation>
    </message>
    <message>
        <source>⚠ %1 warnings</source>
        <translation>⚠ %1 Warnungen</translation>
    </message>
    <message>
        <source>ℹ 1 note</source>
        <translation>ℹ 1 Hinweis</translation>
    </message>
    <message>
        <source>ℹ %1 notes</source>
        <translation>ℹ %1 Hinweise</translation>
    </message>
</context>
<context>
    <name>drillwave::AlertList</name>
    <message>
        <source>Not solved</source>
        <translation>Nicht gelöst</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Nothing unusual</source>
        <translation>Nichts Ungewöhnliches</translation>
    </message>
    <message>
        <source>Nothing unusual.</source>
        <translation>Nichts Ungewöhnliches.</translation>
    </message>
    <message>
        <source>Go to “%1”</source>
        <translation>Zu „%1“</translation>
    </message>
</context>
<context>
    <name>drillwave::AreaKeys</name>
    <message>
        <source>Next &amp;area</source>
        <translation>Nächster &amp;Bereich</translation>
    </message>
    <message>
        <source>Pre&amp;vious area</source>
        <translation>Vori&amp;ger Bereich</translation>
    </message>
</context>
<context>
    <name>drillwave::AxisFields</name>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>%1: parameter</source>
        <translation>%1: Parameter</translation>
    </message>
    <message>
        <source>%1: logarithmic</source>
        <translation>%1: logarithmisch</translation>
    </message>
    <message>
        <source>Even ratios instead of even steps</source>
        <translation>Gleiche Verhältnisse statt gleicher Schritte</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, Einheit</translation>
    </message>
    <message>
        <source>must be greater than 0 on a logarithmic axis</source>
        <translation>muss auf einer logarithmischen Achse größer als 0 sein</translation>
    </message>
    <message>
        <source>must differ from the other end</source>
        <translation>muss sich vom anderen Ende unterscheiden</translation>
    </message>
</context>
<context>
    <name>drillwave::BlowPage</name>
    <message>
        <source>rms %1 · peaks differ by %2</source>
        <translation>rms %1 · Spitzen unterscheiden sich um %2</translation>
    </message>
    <message>
        <source> · lag %1</source>
        <translation> · Verzug %1</translation>
    </message>
    <message>
        <source>Values at the time cursor: normal force at the section, impact force, impulse, momentum</source>
        <translation>Werte am Zeitcursor: Normalkraft im Querschnitt, Kraft auf das Gestein, Kraftstoß, Impuls</translation>
    </message>
    <message>
        <source>Waves, impact force, impulse and momentum over time</source>
        <translation>Wellen, Kraft auf das Gestein, Kraftstoß und Impuls über der Zeit</translation>
    </message>
    <message>
        <source>Section x/L</source>
        <translation>Stelle x/L</translation>
    </message>
    <message>
        <source>Bring all curves into view (double-click in the plots)</source>
        <translation>Alle Kurven ins Bild bringen (Doppelklick in den Diagrammen)</translation>
    </message>
    <message>
        <source>To mark a time, press T over the plots or click an event in Result.</source>
        <translation>Zeit markieren: T über den Diagrammen oder Klick auf ein Ereignis im Ergebnis.</translation>
    </message>
    <message>
        <source>t = %1 · N = %2 · F = %3 · I = %4 · p = %5</source>
        <translation>t = %1 · N = %2 · F = %3 · I = %4 · p = %5</translation>
    </message>
    <message>
        <source>Nothing to show: this blow has too many waves to keep.</source>
        <translation>Nichts zu zeigen: dieser Schlag hat mehr Wellen, als behalten werden können.</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Nichts zu zeigen: %1</translation>
    </message>
    <message>
        <source>Blow</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Ctrl+wheel zooms · drag moves · double-click fits</source>
        <translation>Strg+Rad zoomt · Ziehen verschiebt · Doppelklick passt ein</translation>
    </message>
    <message>
        <source>The largest impact force on the rock is %1, at %2.</source>
        <translation>Die größte Kraft auf das Gestein ist %1, bei %2.</translation>
    </message>
    <message>
        <source>At %1, the force in this plot is between %2 (compression) and %3 (tension).</source>
        <translation>Bei %1 liegt die Kraft in diesem Diagramm zwischen %2 (Druck) und %3 (Zug).</translation>
    </message>
    <message>
        <source>Section at which the waves are shown: 0 is the struck end, 1 the bit.
N₀ₚ is the first wave to the bit, N₁ₙ its reflection from the bit, N₂ₚ from the rear end, N₃ₙ again from the bit.</source>
        <translation>Stelle, an der die Wellen gezeigt werden: 0 ist das hammerseitige Ende, 1 die Bohrkrone.
N₀ₚ ist die erste Welle zur Krone, N₁ₙ ihre Reflexion an der Krone, N₂ₚ am hinteren Ende, N₃ₙ wieder an der Krone.</translation>
    </message>
    <message>
        <source>0: struck end, 1: bit</source>
        <translation>0: hammerseitiges Ende, 1: Bohrkrone</translation>
    </message>
</context>
<context>
    <name>drillwave::BlowPlots</name>
    <message>
        <source>impact force F</source>
        <translation>Kraft auf das Gestein F</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>force of the hammer on the string</source>
        <translation>Kraft des Hammers auf den Strang</translation>
    </message>
    <message>
        <source>impulse of the impact force I</source>
        <translation>Kraftstoß I auf das Gestein</translation>
    </message>
    <message>
        <source>momentum of the rod p</source>
        <translation>Impuls der Stange p</translation>
    </message>
    <message>
        <source>Nₚ to the bit</source>
        <translation>Nₚ zur Krone</translation>
    </message>
    <message>
        <source>Nₙ from the bit</source>
        <translation>Nₙ von der Krone</translation>
    </message>
    <message>
        <source>momentum of the string p</source>
        <translation>Impuls des Strangs p</translation>
    </message>
    <message>
        <source>closed form, error of e &lt; %1</source>
        <translation>geschlossene Form, Fehler von e &lt; %1</translation>
    </message>
    <message>
        <source>waves at x/L = %1 (p to the bit, n from it)</source>
        <translation>Wellen bei x/L = %1 (p hin, n zurück)</translation>
    </message>
    <message>
        <source>N, tension +</source>
        <translation>N, Zug +</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>Zeit t</translation>
    </message>
    <message>
        <source>Four plots over time from 0 to %1. %2: largest N %3, wave to the bit %4, from the bit %5. Impact force up to %6, force of the hammer on the string up to %7. Impulse up to %8. Momentum of the string up to %9.</source>
        <translation>Vier Diagramme über der Zeit von 0 bis %1. %2: größtes N %3, Welle zur Bohrkrone %4, von der Bohrkrone %5. Kraft auf das Gestein bis %6, Kraft des Hammers auf den Strang bis %7. Kraftstoß bis %8. Impuls des Strangs bis %9.</translation>
    </message>
    <message>
        <source>Four plots over time from 0 to %1. Largest values at x/L = %2: normal force N %10, incident wave N0p %3, its reflection from the bit N1n %4, then from the rear end N2p %5 and again from the bit N3n %6. Impact force up to %7. Impulse up to %8. Momentum of the rod up to %9.</source>
        <translation>Vier Diagramme über der Zeit von 0 bis %1. Größte Werte bei x/L = %2: Normalkraft N %10, einlaufende Welle N0p %3, ihre Reflexion an der Krone N1n %4, dann am hinteren Ende N2p %5 und wieder an der Krone N3n %6. Kraft auf das Gestein bis %7. Kraftstoß bis %8. Impuls der Stange bis %9.</translation>
    </message>
    <message>
        <source>%1, %2 from its rear</source>
        <translation>%1, %2 von hinten</translation>
    </message>
</context>
<context>
    <name>drillwave::CompareModel</name>
    <message>
        <source>reference</source>
        <translation>Bezug</translation>
    </message>
</context>
<context>
    <name>drillwave::ComparePage</name>
    <message>
        <source>No runs are pinned yet.

F7 (or Pin, at the right of the tabs) keeps the present result with its scenario. Then change something and pin again: the runs are shown here side by side, and in the plots of the other pages.

On the pages of studies, Shift+click pins the point under the pointer.</source>
        <translation>Noch sind keine Läufe angeheftet.

F7 (oder Anheften, rechts neben den Reitern) behält das gegenwärtige Ergebnis mit seinem Szenario. Danach etwas ändern und wieder anheften: Die Läufe stehen hier nebeneinander und liegen über den Diagrammen der anderen Seiten.

Auf den Seiten der Studien heften Umschalt und ein Klick den Punkt unter dem Zeiger an.</translation>
    </message>
    <message>
        <source>Reference of all differences: here, in the list of runs and in the result</source>
        <translation>Wovon die Unterschiede genommen werden: hier, in der Liste der Läufe und im Ergebnis</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Revert to this run</source>
        <translation>Zurück zu diesem Lauf</translation>
    </message>
    <message>
        <source>Loads the scenario of the selected run; Undo takes it back</source>
        <translation>Bringt das Szenario des Laufs zurück, dessen Spalte gewählt ist, als ein Schritt, der rückgängig gemacht werden kann</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The whole table with all digits, for a spreadsheet</source>
        <translation>Die ganze Tabelle mit allen Ziffern, für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>Runs side by side</source>
        <translation>Läufe nebeneinander</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Compare (%1)</source>
        <translation>Vergleich (%1)</translation>
    </message>
    <message>
        <source>the present result</source>
        <translation>das gegenwärtige Ergebnis</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>No runs are pinned.</source>
        <translation>Keine Läufe sind angeheftet.</translation>
    </message>
    <message>
        <source>The present result is not solved yet.</source>
        <translation>Das gegenwärtige Ergebnis ist noch nicht gelöst.</translation>
    </message>
    <message>
        <source>&amp;Data of this table…</source>
        <translation>&amp;Daten dieser Tabelle …</translation>
    </message>
    <message>
        <source>Runs side by side with their differences, as CSV in the units on show</source>
        <translation>Läufe nebeneinander mit ihren Unterschieden, als CSV in den gezeigten Einheiten</translation>
    </message>
</context>
<context>
    <name>drillwave::ContactBarsItem</name>
    <message>
        <source>bit touches rock</source>
        <translation>Krone am Gestein</translation>
    </message>
</context>
<context>
    <name>drillwave::CursorBar</name>
    <message>
        <source>Curve to read</source>
        <translation>Kurve, die abgelesen wird</translation>
    </message>
    <message>
        <source>Curve whose values are read; a click on a curve selects it</source>
        <translation>Die Kurve, die abgelesen wird; ein Klick auf eine Kurve wählt sie</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the readings</source>
        <translation>Ablesungen kopieren</translation>
    </message>
    <message>
        <source>This table with all digits, to paste into a spreadsheet</source>
        <translation>Diese Tabelle mit allen Ziffern, zum Einfügen in eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Remove the cursors A and B</source>
        <translation>Die Cursor A und B entfernen</translation>
    </message>
    <message>
        <source>Cursors: %1</source>
        <translation>Cursor: %1</translation>
    </message>
    <message>
        <source>In view: %1</source>
        <translation>Im Bild: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::CurveMarks</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>kink %1</source>
        <translation>Knick %1</translation>
    </message>
</context>
<context>
    <name>drillwave::CurvePage</name>
    <message>
        <source>A result over a parameter</source>
        <translation>Ein Ergebnis über einem Parameter</translation>
    </message>
    <message>
        <source>vary</source>
        <translation>variiert</translation>
    </message>
    <message>
        <source>curves for</source>
        <translation>Kurven für</translation>
    </message>
    <message>
        <source>this scenario</source>
        <translation>dieses Szenario</translation>
    </message>
    <message>
        <source>Also a curve for the scenario&apos;s own value of the family</source>
        <translation>Eine Kurve auch für den Wert der Schar, den das Szenario hat</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>The paper&apos;s analytical solution, drawn where it is valid: rectangular blow, elastic rock (γ = 1)</source>
        <translation>Die analytische Lösung der Veröffentlichung, gestrichelt, wo sie gilt: Rechteckschlag, elastisches Gestein (γ = 1)</translation>
    </message>
    <message>
        <source>Rod without waves</source>
        <translation>Stange ohne Wellen</translation>
    </message>
    <message>
        <source>A rod that arrives without waves, dotted, over its stiffness in one of two units</source>
        <translation>Die Stange, die ohne Wellen ankommt, gepunktet, über ihrer Steifigkeit in einer von zwei Einheiten</translation>
    </message>
    <message>
        <source>no curve to compare with</source>
        <translation>keine Vergleichskurve</translation>
    </message>
    <message>
        <source>rod without waves, k₀ = Z/(2T)</source>
        <translation>Stange ohne Wellen, k₀ = Z/(2T)</translation>
    </message>
    <message>
        <source>rod without waves, k₀ = Z/t₀</source>
        <translation>Stange ohne Wellen, k₀ = Z/t₀</translation>
    </message>
    <message>
        <source>Points of a curve</source>
        <translation>Punkte einer Kurve</translation>
    </message>
    <message>
        <source>Number of blows solved along a curve of a drill string</source>
        <translation>Wie viele Schläge entlang einer Kurve eines Bohrstrangs gelöst werden</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Efficiency–stiffness</source>
        <translation>Wirkungsgrad–Steifigkeit</translation>
    </message>
    <message>
        <source>COR–stiffness</source>
        <translation>e–Steifigkeit</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
</context>
<context>
    <name>drillwave::DensityMark</name>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Frequency of the values, from the smallest to the largest</source>
        <translation>Wie oft Werte vorkommen, vom kleinsten bis zum größten</translation>
    </message>
</context>
<context>
    <name>drillwave::DesignCard</name>
    <message>
        <source>&lt;b&gt;This scenario&lt;/b&gt;</source>
        <translation>&lt;b&gt;Dieses Szenario&lt;/b&gt;</translation>
    </message>
    <message>
        <source>The samples do not distinguish this design from %1: any of them will do.</source>
        <translation>Die Stichproben unterscheiden diese Auslegung nicht von %1: jede davon ist recht.</translation>
    </message>
    <message>
        <source>Among them, %1 has the %2: %3.</source>
        <translation>Unter ihnen hat %1 %2: %3.</translation>
    </message>
    <message>
        <source>The best design for the values entered, %1, has an objective that is %2&#xa0;% smaller %3.</source>
        <translation>Bei der besten Auslegung für die eingegebenen Werte, %1, ist die Zielgröße %3 um %2&#xa0;% kleiner.</translation>
    </message>
    <message>
        <source>The best design for the values entered, %1, has an objective that is %2&#xa0;% larger %3.</source>
        <translation>Bei der besten Auslegung für die eingegebenen Werte, %1, ist die Zielgröße %3 um %2&#xa0;% größer.</translation>
    </message>
    <message>
        <source>the draws</source>
        <translation>die Ziehungen</translation>
    </message>
    <message>
        <source>To know the %1 better, measure &lt;b&gt;%2&lt;/b&gt; first: it causes %3 % of the scatter.</source>
        <translation>Um %1 genauer zu kennen, zuerst &lt;b&gt;%2&lt;/b&gt; messen: das verursacht %3&#xa0;% der Streuung.</translation>
    </message>
    <message>
        <source>Smallest %1 found for the best design: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Kleinster gefundener Wert (%1) der besten Auslegung für ungenau bekanntes Gestein: &lt;b&gt;%2&lt;/b&gt;, bei %3.</translation>
    </message>
    <message>
        <source>Largest %1 found for the best design: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Größter gefundener Wert (%1) der besten Auslegung für ungenau bekanntes Gestein: &lt;b&gt;%2&lt;/b&gt;, bei %3.</translation>
    </message>
    <message>
        <source>The choices change the blow energy: machines of different power are compared. “keep the energy” holds it constant.</source>
        <translation>Die Wahl ändert die Energie des Schlags: verglichen werden Maschinen verschiedener Leistung. „Energie halten“ hält sie.</translation>
    </message>
    <message>
        <source>Nearly all scatter of the efficiency comes from γ. To compare hammers, choose loading work as the objective.</source>
        <translation>Der Wirkungsgrad streut fast nur mit γ. Zum Vergleich von Hämmern die Belastungsarbeit als Zielgröße wählen.</translation>
    </message>
    <message>
        <source>Answer of the study</source>
        <translation>Was die Auslegungen sagen</translation>
    </message>
    <message>
        <source>Load the best design for uncertain rock</source>
        <translation>Beste Auslegung für ungenau bekanntes Gestein laden</translation>
    </message>
    <message>
        <source>Load the best design for the values entered</source>
        <translation>Beste Auslegung für die eingegebenen Werte laden</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>%1 samples of each design; ± is the 95 % error.</source>
        <translation>%1 Stichproben je Auslegung; ± ist der 95-%-Fehler.</translation>
    </message>
    <message>
        <source>%1 samples so far, %2 to come.</source>
        <translation>Bisher %1 Stichproben, %2 folgen.</translation>
    </message>
    <message>
        <source>With the values entered, the objective of the best design for uncertain rock is %1&#xa0;% smaller.</source>
        <translation>Mit den eingegebenen Werten ist die Zielgröße der besten Auslegung für ungenau bekanntes Gestein um %1&#xa0;% kleiner.</translation>
    </message>
    <message>
        <source>With the values entered, the objective of the best design for uncertain rock is %1&#xa0;% larger.</source>
        <translation>Mit den eingegebenen Werten ist die Zielgröße der besten Auslegung für ungenau bekanntes Gestein um %1&#xa0;% größer.</translation>
    </message>
    <message>
        <source>Best for the values entered: %1</source>
        <translation>Am besten für die eingegebenen Werte: %1</translation>
    </message>
    <message>
        <source>Present design: %1</source>
        <translation>Jetzige Auslegung: %1</translation>
    </message>
    <message>
        <source>Equally good: %1</source>
        <translation>Gleich gut: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Best for uncertain rock: %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Am besten für ungenau bekanntes Gestein: %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Present design: %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Jetzige Auslegung: %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Any design, such as %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Jede Auslegung, etwa %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Best in all aims: %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Am besten in allen Zielen: %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Best for uncertain rock: %1</source>
        <translation>Am besten für ungenau bekanntes Gestein: %1</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>%1 übernehmen</translation>
    </message>
    <message>
        <source>Smallest %1 found with %4: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Kleinster gefundener Wert (%1) mit %4: &lt;b&gt;%2&lt;/b&gt;, bei %3.</translation>
    </message>
    <message>
        <source>Largest %1 found with %4: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Größter gefundener Wert (%1) mit %4: &lt;b&gt;%2&lt;/b&gt;, bei %3.</translation>
    </message>
    <message>
        <source>%1 is equally good, within the error.</source>
        <translation>%1 ist im Rahmen des Fehlers gleich gut.</translation>
    </message>
</context>
<context>
    <name>drillwave::DesignPage</name>
    <message>
        <source>samples</source>
        <translation>Stichproben</translation>
    </message>
    <message>
        <source>Designs for uncertain inputs</source>
        <translation>Auslegungen bei unsicheren Eingaben</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>design variables</source>
        <translation>Entwurfsgrößen</translation>
    </message>
    <message>
        <source>keep the energy</source>
        <translation>Energie halten</translation>
    </message>
    <message>
        <source>Scales the blow of every design to the present blow energy, by impulse or hammer velocity</source>
        <translation>Der Schlag jeder Auslegung wird auf die Energie des gegenwärtigen skaliert: über seinen Kraftstoß oder über die Geschwindigkeit des Hammers</translation>
    </message>
    <message>
        <source>Samples of each design</source>
        <translation>Stichproben je Auslegung</translation>
    </message>
    <message>
        <source>Too many samples could not be solved: %1</source>
        <translation>Zu viele der Stichproben haben keine Antwort: %1</translation>
    </message>
    <message>
        <source>⚠ %1
The page shows the answer for the value before.</source>
        <translation>⚠ %1
Gezeigt wird der Wert davor.</translation>
    </message>
    <message>
        <source>%1 samples of each design</source>
        <translation>%1 Stichproben je Auslegung</translation>
    </message>
    <message>
        <source>%1 samples of each design so far, refined to %2</source>
        <translation>Bisher %1 Stichproben je Auslegung, verfeinert auf %2</translation>
    </message>
    <message>
        <source>There is no design study to report.</source>
        <translation>Es gibt keine Auslegung, von der zu berichten wäre.</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Auslegung</translation>
    </message>
    <message>
        <source>Solve all samples of this study; the time is an estimate</source>
        <translation>Alle Stichproben dieser Studie rechnen; die Zeit ist geschätzt</translation>
    </message>
    <message>
        <source>Not solved yet: this study takes more than 10 s. Press Refine to start it.</source>
        <translation>Noch ist nichts gerechnet: diese Studie dauert länger als 10 s. Der Knopf „Verfeinern“ startet sie.</translation>
    </message>
    <message>
        <source>%1 samples of each design so far</source>
        <translation>bisher %1 Stichproben je Auslegung</translation>
    </message>
    <message>
        <source>take the design %1</source>
        <translation>Auslegung %1 übernehmen</translation>
    </message>
    <message>
        <source>take the worst case</source>
        <translation>schlechtesten Fall übernehmen</translation>
    </message>
    <message>
        <source>Refine (%1)</source>
        <translation>Verfeinern (%1)</translation>
    </message>
    <message>
        <source>Save draws…</source>
        <translation>Ziehungen speichern…</translation>
    </message>
    <message>
        <source>Writes the table that design --draws reads</source>
        <translation>Schreibt die Tabelle, die design --draws liest</translation>
    </message>
    <message>
        <source>Remove the draws</source>
        <translation>Die Ziehungen entfernen</translation>
    </message>
    <message>
        <source>Removes the draws: the uncertain rows of the settings are used again</source>
        <translation>Entfernt die Ziehungen: Die unsicheren Zeilen der Einstellungen gelten wieder</translation>
    </message>
    <message>
        <source>draws of %1: %2 rows of %3</source>
        <translation>Ziehungen aus %1: %2 Zeilen von %3</translation>
    </message>
    <message>
        <source>The copied command reads the draws from %1: save them there first.</source>
        <translation>Der kopierte Befehl liest die Ziehungen aus %1: Speichern Sie sie zuerst dort.</translation>
    </message>
    <message>
        <source>Takes over this design as one undo step</source>
        <translation>Übernimmt diese Auslegung als einen Schritt, der rückgängig zu machen ist</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>%1 übernehmen</translation>
    </message>
    <message>
        <source>Objectives: %1</source>
        <translation>Ziele: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>clear %1</source>
        <translation>%1 leeren</translation>
    </message>
    <message>
        <source>change the pulse shape to %1</source>
        <translation>die Schlagform in %1 ändern</translation>
    </message>
    <message>
        <source>change the title</source>
        <translation>den Titel ändern</translation>
    </message>
    <message>
        <source>reload the file</source>
        <translation>die Datei neu laden</translation>
    </message>
    <message>
        <source>A preset of a rod is for uniform rods, and this scenario is a drill string.</source>
        <translation>Eine Voreinstellung einer Stange ist für gleichförmige Stangen, und dieses Szenario ist ein Bohrstrang.</translation>
    </message>
    <message>
        <source>A preset of a blow is a force, and this string is struck by the sections of its hammer.</source>
        <translation>Eine Voreinstellung eines Schlags ist eine Kraft, und diesen Strang schlagen die Abschnitte seines Hammers.</translation>
    </message>
    <message>
        <source>A preset has physical units, and this scenario is given by its dimensionless groups.</source>
        <translation>Eine Voreinstellung hat physikalische Einheiten, und dieses Szenario ist durch seine dimensionslosen Kennzahlen gegeben.</translation>
    </message>
    <message>
        <source>take the preset %1</source>
        <translation>die Voreinstellung %1 übernehmen</translation>
    </message>
    <message>
        <source>take the hammer blow from %1</source>
        <translation>den Hammerschlag aus %1 übernehmen</translation>
    </message>
    <message>
        <source>reload the table of the hammer blow</source>
        <translation>die Tabelle des Hammerschlags neu laden</translation>
    </message>
    <message>
        <source>This string is struck by the sections of its hammer, not by a force from a table.</source>
        <translation>Diesen Strang schlagen die Abschnitte seines Hammers, nicht eine Kraft aus einer Tabelle.</translation>
    </message>
    <message>
        <source>follow the table of the pulse</source>
        <translation>der Tabelle des Schlags folgen</translation>
    </message>
    <message>
        <source>%1: cannot be saved: %2. Your changes are still here: save under another name or in another folder.</source>
        <translation>%1: kann nicht gespeichert werden: %2. Nichts ist verloren: unter einem anderen Namen oder in einem anderen Ordner speichern.</translation>
    </message>
    <message>
        <source>change the design study</source>
        <translation>Auslegungsstudie ändern</translation>
    </message>
    <message>
        <source>restore the unsaved changes</source>
        <translation>nicht gespeicherte Änderungen wiederherstellen</translation>
    </message>
</context>
<context>
    <name>drillwave::DrillingPage</name>
    <message>
        <source>scan over</source>
        <translation>durchlaufen</translation>
    </message>
    <message>
        <source>Many blows under a feed</source>
        <translation>Viele Schläge unter einem Vorschub</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Simulates the blows at several values of this parameter, each once from rest and once with a bouncing machine</source>
        <translation>Simuliert die Schläge bei mehreren Werten dieses Parameters, jeden einmal aus der Ruhe und einmal mit springender Maschine</translation>
    </message>
    <message>
        <source>bracket</source>
        <translation>mit Grenzfällen</translation>
    </message>
    <message>
        <source>Repeats the scan with a constant feed force and, if a machine mass is given, with a dashpot of half the impedance of the rod. Makers do not publish their dampers: the results show how much this matters</source>
        <translation>Wiederholt den Durchlauf mit konstantem Andruck und, wenn eine Maschinenmasse angegeben ist, mit einem Dämpfer von der halben Impedanz der Stange. Hersteller veröffentlichen ihre Dämpfer nicht: die Ergebnisse zeigen, wie viel das ausmacht</translation>
    </message>
    <message>
        <source>Drilling needs a scenario in physical units. This one has dimensionless groups, so it has no blow frequency and no feed force.</source>
        <translation>Bohren braucht Szenarien in physikalischen Einheiten, und dieses ist durch seine dimensionslosen Kennzahlen gegeben: es hat weder Schlagfrequenz noch Andruck.</translation>
    </message>
    <message>
        <source>Stop %1/%2</source>
        <translation>Anhalten %1/%2</translation>
    </message>
    <message>
        <source>Feed force / mean force of the blows φ = %1; %2 round trips of a wave between two blows</source>
        <translation>Andruck / mittlere Kraft der Schläge φ = %1; %2 Hin- und Rückläufe einer Welle zwischen zwei Schlägen</translation>
    </message>
    <message>
        <source>No scan: %1</source>
        <translation>Kein Durchlauf: %1</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Blow %1 of %2 under the feed, with the waves and the motion it started with: gap %3, penetration %4. The panel Result shows a single blow from rest.</source>
        <translation>Schlag %1 von %2 unter dem Vorschub, mit den Wellen und der Bewegung, mit denen er begann: Spalt %3, Eindringung %4. Was das Ergebnis sagt, ist von einem einzelnen Schlag, der in Ruhe beginnt.</translation>
    </message>
    <message>
        <source>Data of the &amp;scan…</source>
        <translation>Daten des &amp;Durchlaufs …</translation>
    </message>
    <message>
        <source>The statistics at every value of the scan, as CSV</source>
        <translation>Die Statistik bei jedem Wert des Durchlaufs, als CSV</translation>
    </message>
    <message>
        <source>There is no scan of this scenario yet.</source>
        <translation>Von diesem Szenario gibt es noch keinen Durchlauf.</translation>
    </message>
    <message>
        <source>Solving the blows one after another …</source>
        <translation>Die Schläge werden einer nach dem anderen verfolgt …</translation>
    </message>
    <message>
        <source>; &quot;in contact&quot; means within %1 of the rock; %2</source>
        <translation>; „im Kontakt“ heißt höchstens %1 vom Gestein; %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>%1 abtasten</translation>
    </message>
</context>
<context>
    <name>drillwave::DrillingTable</name>
    <message>
        <source>Statistics of the blows</source>
        <translation>Statistik der Schläge</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>95 % error of the mean, from batches of blows and from longer and shorter time steps</source>
        <translation>Fehler des Mittels, 95 %: aus Gruppen von Schlägen, und was größere oder kleinere Zellen ändern</translation>
    </message>
</context>
<context>
    <name>drillwave::ElsewhereNotice</name>
    <message>
        <source>Go there</source>
        <translation>Dorthin</translation>
    </message>
    <message>
        <source>Opens the page that has the answer</source>
        <translation>Zu der Seite, die die Antwort hat</translation>
    </message>
</context>
<context>
    <name>drillwave::EnergyBar</name>
    <message>
        <source>rock</source>
        <translation>Gestein</translation>
    </message>
    <message>
        <source>rebound</source>
        <translation>Rückprall</translation>
    </message>
    <message>
        <source>hammer</source>
        <translation>Hammer</translation>
    </message>
    <message>
        <source>losses</source>
        <translation>Verluste</translation>
    </message>
    <message>
        <source>waves</source>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>Energy: no result</source>
        <translation>Energie: kein Ergebnis</translation>
    </message>
    <message>
        <source>Energy: %1</source>
        <translation>Energie: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::EventModel</name>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>unloading begins</source>
        <translation>Entlastung beginnt</translation>
    </message>
    <message>
        <source>primary loading</source>
        <translation>Erstbelastung</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>Trennung</translation>
    </message>
    <message>
        <source>corner of the law</source>
        <translation>Ecke des Gesetzes</translation>
    </message>
    <message>
        <source>event at the bit</source>
        <translation>Ereignis an der Bohrkrone</translation>
    </message>
</context>
<context>
    <name>drillwave::EventTable</name>
    <message>
        <source>Events at the bit</source>
        <translation>Ereignisse an der Bohrkrone</translation>
    </message>
    <message>
        <source>Select an event to move the time cursor there</source>
        <translation>Ein Ereignis wählen, um den Zeitcursor dorthin zu setzen</translation>
    </message>
</context>
<context>
    <name>drillwave::ExampleNote</name>
    <message>
        <source>&amp;About this example</source>
        <translation>&amp;Über dieses Beispiel</translation>
    </message>
    <message>
        <source>Things to look at in the open example</source>
        <translation>Worauf im geöffneten Beispiel zu achten ist</translation>
    </message>
    <message>
        <source>You have changed this example: its description may no longer be right. Undo brings the values back.</source>
        <translation>Dieses Beispiel ist geändert: was von seinen Werten gesagt ist, gilt vielleicht nicht mehr. Rückgängig bringt sie zurück.</translation>
    </message>
</context>
<context>
    <name>drillwave::ExportMenu</name>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>&amp;Histories…</source>
        <translation>&amp;Verläufe …</translation>
    </message>
    <message>
        <source>Forces, impulse, momentum, penetration and velocity over time, as CSV</source>
        <translation>Kräfte, Kraftstoß, Impuls, Eindringung und Geschwindigkeit über der Zeit, als CSV</translation>
    </message>
    <message>
        <source>&amp;Events…</source>
        <translation>&amp;Ereignisse …</translation>
    </message>
    <message>
        <source>Contacts, reversals and separations with their times, as CSV</source>
        <translation>Kontakte, Umkehrungen und Trennungen mit ihren Zeiten, als CSV</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>The present view, to paste into a report</source>
        <translation>Im gegenwärtigen Ausschnitt, zum Einfügen in einen Bericht</translation>
    </message>
    <message>
        <source>Everything into a &amp;folder…</source>
        <translation>Alles in einen &amp;Ordner …</translation>
    </message>
    <message>
        <source>Scenario, summary, histories, events and plots, as `drillwave run -o` writes them</source>
        <translation>Szenario, Zusammenfassung, Verläufe, Ereignisse und Diagramme, wie `drillwave run -o` sie schreibt</translation>
    </message>
    <message>
        <source>Save the data of the plot</source>
        <translation>Die Daten des Diagramms speichern</translation>
    </message>
    <message>
        <source>This blow has too many waves to keep: there are no histories.</source>
        <translation>Dieser Schlag hat mehr Wellen, als behalten werden können: es gibt keine Verläufe.</translation>
    </message>
    <message>
        <source>Export the histories</source>
        <translation>Die Verläufe exportieren</translation>
    </message>
    <message>
        <source>Export the events</source>
        <translation>Die Ereignisse exportieren</translation>
    </message>
    <message>
        <source>The blow could not be solved: %1</source>
        <translation>Der Schlag konnte nicht gelöst werden: %1</translation>
    </message>
    <message>
        <source>Overwrite the files in this folder?</source>
        <translation>Die Dateien in diesem Ordner überschreiben?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Das Bild speichern</translation>
    </message>
    <message>
        <source>%1: not written, the plot could not be drawn</source>
        <translation>%1: nicht geschrieben, das Diagramm konnte nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>Das Bild</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>Das Bild ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>The export has failed.</source>
        <translation>Der Export ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>&amp;Numbers as a table</source>
        <translation>&amp;Zahlen als Tabelle</translation>
    </message>
    <message>
        <source>The numbers this page draws, in a window of their own, to read and copy</source>
        <translation>Was diese Seite zeichnet, Zahl für Zahl, in einem eigenen Fenster: zum Lesen und Kopieren</translation>
    </message>
    <message>
        <source>The table</source>
        <translation>Die Tabelle</translation>
    </message>
    <message>
        <source>Numbers: %1</source>
        <translation>Zahlen: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::FamilyFields</name>
    <message>
        <source>%1: parameter</source>
        <translation>%1: Parameter</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1: values</source>
        <translation>%1: Werte</translation>
    </message>
    <message>
        <source>One curve for each value, with or without units: 0.1; 0.3; 1</source>
        <translation>Eine Kurve für jeden Wert, mit oder ohne Einheit: 0.1; 0.3; 1</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>höchstens %1 Werte</translation>
    </message>
</context>
<context>
    <name>drillwave::FeedText</name>
    <message>
        <source>⚠ short by %1 (−%2 %)</source>
        <translation>⚠ es fehlen %1 (−%2 %)</translation>
    </message>
    <message>
        <source>✓ met, %1 (%2 %) to spare</source>
        <translation>✓ erfüllt, %1 (%2 %) übrig</translation>
    </message>
    <message>
        <source>%1, effective %2</source>
        <translation>%1, wirksam %2</translation>
    </message>
</context>
<context>
    <name>drillwave::FigureDialog</name>
    <message>
        <source>Figure %1 of the paper</source>
        <translation>Abbildung %1 der Veröffentlichung</translation>
    </message>
    <message>
        <source>The paper prints no number with this figure.</source>
        <translation>Die Veröffentlichung druckt zu dieser Abbildung keine Zahl.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>gedruckt</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Numbers that the paper prints with this figure</source>
        <translation>Zahlen, die die Veröffentlichung zu dieser Abbildung druckt</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>differs: </source>
        <translation>weicht ab: </translation>
    </message>
</context>
<context>
    <name>drillwave::FigurePage</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Which result is shown</source>
        <translation>Welches Ergebnis gezeigt wird</translation>
    </message>
</context>
<context>
    <name>drillwave::FileLines</name>
    <message>
        <source>First lines of the file</source>
        <translation>Erste Zeilen der Datei</translation>
    </message>
    <message>
        <source>First lines of the file; samples begin at the marked one</source>
        <translation>Erste Zeilen der Datei; die Abtastwerte beginnen an der markierten</translation>
    </message>
</context>
<context>
    <name>drillwave::FileMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>New di&amp;mensionless</source>
        <translation>Neu, di&amp;mensionslos</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>A scenario given only by its groups β, γ, τ and δ, without units</source>
        <translation>Ein Szenario, das nur durch seine Kennzahlen β, γ, τ und δ gegeben ist, ohne Einheiten</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>A measured signal from a table of samples: as the hammer blow, or to compare with</source>
        <translation>Ein gemessenes Signal aus einer Tabelle von Abtastwerten: als Hammerschlag oder zum Vergleich</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>Beis&amp;piele</translation>
    </message>
    <message>
        <source>&amp;Figures of the paper</source>
        <translation>Abbildungen der Veröffentlichun&amp;g</translation>
    </message>
    <message>
        <source>waves at the middle of the rod</source>
        <translation>Wellen in der Mitte der Stange</translation>
    </message>
    <message>
        <source>impact force, impulse and momentum</source>
        <translation>Kraft auf das Gestein, Kraftstoß und Impuls</translation>
    </message>
    <message>
        <source>impact force and its closed form</source>
        <translation>Kraft auf das Gestein und ihre geschlossene Form</translation>
    </message>
    <message>
        <source>restitution over the stiffness</source>
        <translation>Stoßzahl über der Steifigkeit</translation>
    </message>
    <message>
        <source>restitution and its closed form</source>
        <translation>Stoßzahl und ihre geschlossene Form</translation>
    </message>
    <message>
        <source>restitution over the gap</source>
        <translation>Stoßzahl über dem Spalt</translation>
    </message>
    <message>
        <source>Figure &amp;%1: %2</source>
        <translation>Abbildung &amp;%1: %2</translation>
    </message>
    <message>
        <source>Computed again, beside the numbers that the paper prints</source>
        <translation>Neu berechnet, neben den Zahlen, die die Veröffentlichung druckt</translation>
    </message>
    <message>
        <source>The example cannot be opened.</source>
        <translation>Das Beispiel kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Zu&amp;letzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Clears this list; the files stay</source>
        <translation>Diese Namen vergessen; die Dateien bleiben</translation>
    </message>
    <message>
        <source>This file is no longer there.</source>
        <translation>Diese Datei ist nicht mehr da.</translation>
    </message>
    <message>
        <source>%1
It may be on a drive that is not connected. Remove it from the list?</source>
        <translation>%1
Vielleicht liegt sie auf einem Laufwerk, das nicht verbunden ist. Soll sie aus der Liste genommen werden?</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>The scenario cannot be opened.</source>
        <translation>Das Szenario kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>Das kann nicht übernommen werden.</translation>
    </message>
    <message>
        <source>%1 files were dropped; drop one at a time.</source>
        <translation>%1 Dateien wurden abgelegt; bitte eine auf einmal.</translation>
    </message>
    <message>
        <source>%1
Drop a scenario (.yaml), a file of a run (.csv, .json), a report (.html), the CSV file of a hammer blow, or a table of samples (.txt, .dat).</source>
        <translation>%1
Ablegen lassen sich ein Szenario (.yaml), eine Datei eines Laufs (.csv, .json), ein Bericht (.html), die CSV-Datei eines Hammerschlags oder eine Tabelle von Abtastwerten (.txt, .dat).</translation>
    </message>
    <message>
        <source>The file has been changed by another program.</source>
        <translation>Die Datei wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>%1
Saving overwrites the changes of that program.</source>
        <translation>%1
Speichern überschreibt, was jenes Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>A file of this name exists already.</source>
        <translation>Eine Datei dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>The scenario has not been saved.</source>
        <translation>Das Szenario wurde nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>drillwave::FileNotice</name>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Neu laden</translation>
    </message>
    <message>
        <source>Load the scenario from the file; Undo brings the present one back</source>
        <translation>Das Szenario aus der Datei nehmen; Rückgängig bringt das gegenwärtige zurück</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Meines behalten</translation>
    </message>
    <message>
        <source>Continue with the present scenario; saving overwrites the file</source>
        <translation>Mit dem gegenwärtigen Szenario weiterarbeiten; Speichern schreibt es über die Datei</translation>
    </message>
    <message>
        <source>%1 has been deleted or moved. Saving writes it again.</source>
        <translation>%1 wurde gelöscht oder verschoben. Speichern schreibt die Datei neu.</translation>
    </message>
    <message>
        <source>%1 has been changed by another program, and here as well.</source>
        <translation>%1 wurde von einem anderen Programm geändert, und hier auch.</translation>
    </message>
    <message>
        <source>%1 has been changed by another program.</source>
        <translation>%1 wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>The file cannot be reloaded.</source>
        <translation>Die Datei kann nicht neu geladen werden.</translation>
    </message>
</context>
<context>
    <name>drillwave::FolderDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>This folder does not exist yet. Create it?</source>
        <translation>Diesen Ordner gibt es noch nicht. Anlegen?</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
</context>
<context>
    <name>drillwave::FormNotice</name>
    <message>
        <source>&amp;Make a drill string of this</source>
        <translation>&amp;Bohrstrang daraus machen</translation>
    </message>
    <message>
        <source>&amp;Simplify to a uniform rod</source>
        <translation>Zur gleichförmigen Stange &amp;vereinfachen</translation>
    </message>
    <message>
        <source>Use a &amp;force instead of the hammer</source>
        <translation>&amp;Kraft anstelle des Hammers setzen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the conversion</source>
        <translation>Die Umwandlung zurücknehmen</translation>
    </message>
    <message>
        <source>make a drill string</source>
        <translation>einen Bohrstrang daraus machen</translation>
    </message>
    <message>
        <source>This is a drill string now: a hammer and one rod, to which couplings, an adapter and a bit can be added on the page String.</source>
        <translation>Das ist jetzt ein Bohrstrang: ein Hammer und eine Stange, zu denen auf der Seite Strang Kupplungsmuffen, ein Einsteckende und eine Bohrkrone hinzukommen können.</translation>
    </message>
    <message>
        <source>simplify to a uniform rod</source>
        <translation>zur gleichförmigen Stange vereinfachen</translation>
    </message>
    <message>
        <source>This is a uniform rod now, with the same travel time of waves as the string.</source>
        <translation>Das ist jetzt eine gleichförmige Stange, durch die Wellen so lange laufen wie durch den Strang.</translation>
    </message>
    <message>
        <source>use a force instead of the hammer</source>
        <translation>eine Kraft anstelle des Hammers setzen</translation>
    </message>
    <message>
        <source>A force drives the string now: any shape, or a measured blow by File ▸ Import.</source>
        <translation>Jetzt treibt eine Kraft den Strang: jede Form, oder ein gemessener Schlag über Datei ▸ Importieren.</translation>
    </message>
    <message>
        <source>Nothing was converted: %1</source>
        <translation>Nichts wurde umgewandelt: %1</translation>
    </message>
    <message>
        <source>Lost or changed:</source>
        <translation>Verloren oder geändert:</translation>
    </message>
    <message>
        <source>Makes a hammer and a rod with the same blow, to which couplings, an adapter and a bit can be added</source>
        <translation>Ein Hammer und eine Stange mit demselben Schlag, für Kupplungsmuffen, Einsteckende und Bohrkrone</translation>
    </message>
    <message>
        <source>Not of this scenario: %1</source>
        <translation>Nicht in diesem Szenario: %1</translation>
    </message>
    <message>
        <source>Only the rod, as long for the waves as the string, struck by a uniform piston</source>
        <translation>Die Stange allein, für die Wellen so lang wie der Strang, von einem gleichförmigen Kolben geschlagen</translation>
    </message>
    <message>
        <source>This scenario is a uniform rod</source>
        <translation>Dieses Szenario ist eine gleichförmige Stange</translation>
    </message>
    <message>
        <source>A force drives this scenario already</source>
        <translation>Dieses Szenario treibt schon eine Kraft</translation>
    </message>
    <message>
        <source>A force that reflected waves do not change, as a measured blow is</source>
        <translation>Eine Kraft, die nicht spürt, was zurückkommt, wie ein gemessener Schlag</translation>
    </message>
    <message>
        <source>Make a &amp;rig of these groups…</source>
        <translation>Eine &amp;Anlage aus diesen Kennzahlen machen…</translation>
    </message>
    <message>
        <source>This scenario has physical units already</source>
        <translation>Dieses Szenario hat schon physikalische Einheiten</translation>
    </message>
    <message>
        <source>Rod, force and duration of a physical scenario with the same groups</source>
        <translation>Stange, Kraft und Dauer eines physikalischen Szenarios mit denselben Kennzahlen</translation>
    </message>
</context>
<context>
    <name>drillwave::GaugeFields</name>
    <message>
        <source>gauge</source>
        <translation>Messstreifen</translation>
    </message>
    <message>
        <source>second gauge</source>
        <translation>zweiter Messstreifen</translation>
    </message>
    <message>
        <source>Column of the gauge that is nearest to the bit</source>
        <translation>Spalte des Messstreifens, der der Bohrkrone am nächsten ist</translation>
    </message>
    <message>
        <source>Column of another gauge along the same section, at least 0.5 m away</source>
        <translation>Spalte eines weiteren Messstreifens auf demselben Abschnitt, mindestens 0,5 m entfernt</translation>
    </message>
    <message>
        <source>%1, opposite side</source>
        <translation>%1, Gegenseite</translation>
    </message>
    <message>
        <source>Column of the gauge on the opposite side: the mean of both is free of bending</source>
        <translation>Spalte des Messstreifens auf der Gegenseite: Der Mittelwert beider ist frei von Biegung</translation>
    </message>
    <message>
        <source>%1, distance from the bit face</source>
        <translation>%1, Abstand von der Bohrkrone</translation>
    </message>
    <message>
        <source>from the bit</source>
        <translation>ab Bohrkrone</translation>
    </message>
    <message>
        <source>Distance of the gauge from the bit face</source>
        <translation>Abstand des Messstreifens von der Bohrkrone</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>muss positiv sein</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, Einheit</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>one side only</source>
        <translation>nur eine Seite</translation>
    </message>
    <message>
        <source>on %1, x = %2 m</source>
        <translation>auf %1, x = %2 m</translation>
    </message>
    <message>
        <source>not on a uniform section</source>
        <translation>nicht auf einem gleichmäßigen Abschnitt</translation>
    </message>
</context>
<context>
    <name>drillwave::GoalField</name>
    <message>
        <source>Goal: wanted result</source>
        <translation>Ziel: was das Ergebnis sein soll</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Wanted result: the values of the parameter that give it are marked, and a click takes one</source>
        <translation>Was das Ergebnis sein soll: die Werte des Parameters, die es ergeben, werden markiert, und ein Klick übernimmt einen</translation>
    </message>
</context>
<context>
    <name>drillwave::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>&amp;Einführung</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossar</translation>
    </message>
    <message>
        <source>&amp;About Drillwave</source>
        <translation>&amp;Über Drillwave</translation>
    </message>
    <message>
        <source>Drillwave %1</source>
        <translation>Drillwave %1</translation>
    </message>
    <message>
        <source>Percussive rock drilling: waves in the rod, the impact on the rock, the rebound.
Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Schlagendes Bohren: Wellen in der Stange, der Stoß auf das Gestein, der Rückprall.
Freie Software unter der GNU General Public License, Version 3 oder später.</translation>
    </message>
</context>
<context>
    <name>drillwave::HelpView</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>drillwave::HelpWindow</name>
    <message>
        <source>Manual — Drillwave</source>
        <translation>Handbuch — Drillwave</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Zurück (Alt+Links)</translation>
    </message>
    <message>
        <source>On (Alt+Right)</source>
        <translation>Weiter (Alt+Rechts)</translation>
    </message>
    <message>
        <source>Sections found</source>
        <translation>Gefundene Abschnitte</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Usual size</source>
        <translation>Übliche Größe</translation>
    </message>
    <message>
        <source>Search all chapters (Ctrl+F)</source>
        <translation>Alle Kapitel durchsuchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search all chapters</source>
        <translation>Alle Kapitel durchsuchen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>No section has all of these words.</source>
        <translation>Kein Abschnitt hat alle diese Wörter.</translation>
    </message>
</context>
<context>
    <name>drillwave::IdentifyPage</name>
    <message>
        <source>force–penetration</source>
        <translation>Kraft–Eindringung</translation>
    </message>
    <message>
        <source>The loading curve that is fitted</source>
        <translation>Die Belastungskurve, die angepasst wird</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>eine Gerade</translation>
    </message>
    <message>
        <source>yields once</source>
        <translation>gibt einmal nach</translation>
    </message>
    <message>
        <source>that of the scenario</source>
        <translation>das des Szenarios</translation>
    </message>
    <message>
        <source>Record with the model, what the model leaves over, and force over penetration</source>
        <translation>Aufzeichnung mit dem Modell, was das Modell übrig lässt, und Kraft über der Eindringung</translation>
    </message>
    <message>
        <source>Open record…</source>
        <translation>Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Known tolerances</source>
        <translation>Bekannte Toleranzen</translation>
    </message>
    <message>
        <source>behind the rock</source>
        <translation>hinter dem Gestein</translation>
    </message>
    <message>
        <source>Support of the specimen</source>
        <translation>Worauf die Probe ruht</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>a bar like that of the gauge</source>
        <translation>ein Stab wie der des Messstreifens</translation>
    </message>
    <message>
        <source>dispersion</source>
        <translation>Dispersion</translation>
    </message>
    <message>
        <source>How much of the dispersion of a round bar is taken into account</source>
        <translation>Wie viel der Dispersion eines runden Stabs berücksichtigt wird</translation>
    </message>
    <message>
        <source>round bar</source>
        <translation>runder Stab</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>use the rock identified from %1</source>
        <translation>das aus %1 bestimmte Gestein verwenden</translation>
    </message>
    <message>
        <source>D&amp;raws for Design…</source>
        <translation>Z&amp;iehungen für Auslegung…</translation>
    </message>
    <message>
        <source>Rows of values that the record allows, for design --draws</source>
        <translation>Zeilen von Werten, die die Aufzeichnung zulässt, für design --draws</translation>
    </message>
    <message>
        <source>There is no answer yet.</source>
        <translation>Es gibt noch keine Antwort.</translation>
    </message>
    <message>
        <source>The record does not fix the rock well enough.</source>
        <translation>Die Aufzeichnung legt das Gestein nicht genau genug fest.</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Other laws are being tried; they can widen the intervals.</source>
        <translation>Weitere Gesetze werden geprüft; sie können die Intervalle erweitern.</translation>
    </message>
    <message>
        <source>Tables of samples, one or several along a hole: time and strain, force or the output of a bridge</source>
        <translation>Tabellen von Messwerten, eine oder mehrere entlang eines Bohrlochs: Zeit und Dehnung, Kraft oder Ausgang einer Brücke</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Adds records of further blows, whose tables are read like the first</source>
        <translation>Fügt Aufzeichnungen weiterer Schläge hinzu, deren Tabellen wie die erste gelesen werden</translation>
    </message>
    <message>
        <source>blows of a record</source>
        <translation>Schläge einer Aufzeichnung</translation>
    </message>
    <message>
        <source>Blows of a record that are identified</source>
        <translation>Schläge einer Aufzeichnung, die ausgewertet werden</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>der erste</translation>
    </message>
    <message>
        <source>all of them</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 Aufzeichnungen</translation>
    </message>
    <message>
        <source>Further records and laws are being tried; they can change the answer.</source>
        <translation>Weitere Aufzeichnungen und Gesetze werden geprüft; sie können die Antwort ändern.</translation>
    </message>
    <message>
        <source>&amp;Table of records…</source>
        <translation>&amp;Tabelle der Aufzeichnungen…</translation>
    </message>
    <message>
        <source>A row for each record with its values, intervals and verdicts</source>
        <translation>Eine Zeile für jede Aufzeichnung mit Werten, Intervallen und Urteilen</translation>
    </message>
    <message>
        <source>There is only one record.</source>
        <translation>Es gibt nur eine Aufzeichnung.</translation>
    </message>
</context>
<context>
    <name>drillwave::IdentifyPanel</name>
    <message>
        <source>Rock as identified</source>
        <translation>Gestein, wie bestimmt</translation>
    </message>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>elasticity</source>
        <translation>Elastizität</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>A click on a tolerance goes to its field</source>
        <translation>Ein Klick auf eine Toleranz führt zu ihrem Feld</translation>
    </message>
    <message>
        <source>Use this rock</source>
        <translation>Dieses Gestein verwenden</translation>
    </message>
    <message>
        <source>Takes the rock into the scenario as one undo step</source>
        <translation>Übernimmt das Gestein als einen Schritt in das Szenario</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Anheften</translation>
    </message>
    <message>
        <source>Pins the scenario with this rock as a run; the scenario stays as it is</source>
        <translation>Heftet das Szenario mit diesem Gestein als Lauf an; das Szenario bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Design with these draws</source>
        <translation>Mit diesen Ziehungen auslegen</translation>
    </message>
    <message>
        <source>Takes the rock into the scenario, and opens Design with rows of values that the record allows as its uncertain inputs</source>
        <translation>Übernimmt das Gestein in das Szenario und öffnet Auslegung mit Zeilen von Werten, die die Aufzeichnung zulässt, als unsichere Eingaben</translation>
    </message>
    <message>
        <source>There are no draws: no record fixes the rock well enough.</source>
        <translation>Es gibt keine Ziehungen: Keine Aufzeichnung legt das Gestein genau genug fest.</translation>
    </message>
</context>
<context>
    <name>drillwave::ImportDialog</name>
    <message>
        <source>Import – %1</source>
        <translation>Importieren – %1</translation>
    </message>
    <message>
        <source>import as</source>
        <translation>importieren als</translation>
    </message>
    <message>
        <source>Use of the signal in the program</source>
        <translation>Verwendung des Signals im Programm</translation>
    </message>
    <message>
        <source>hammer blow</source>
        <translation>Hammerschlag</translation>
    </message>
    <message>
        <source>measured N in a section</source>
        <translation>gemessenes N in einem Querschnitt</translation>
    </message>
    <message>
        <source>measured force on the rock</source>
        <translation>gemessene Kraft auf das Gestein</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the measured curve in the list</source>
        <translation>Unter dem die gemessene Kurve geführt wird</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>The record and the part that is used</source>
        <translation>Die Aufzeichnung und was davon übernommen wird</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>N, tension +</source>
        <translation>N, Zug +</translation>
    </message>
    <message>
        <source>F, compression +</source>
        <translation>F, Druck +</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Nichts zu zeigen: %1</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>liest …</translation>
    </message>
    <message>
        <source>reading … %1 %</source>
        <translation>liest … %1 %</translation>
    </message>
    <message>
        <source>Only the shape is taken: this scenario has no physical units.</source>
        <translation>Nur die Form wird übernommen: dieses Szenario hat keine physikalischen Einheiten.</translation>
    </message>
    <message>
        <source>The blow replaces the hammer; Undo brings it back.</source>
        <translation>Der Schlag ersetzt den Kolben; Rückgängig bringt ihn zurück.</translation>
    </message>
    <message>
        <source>recorder</source>
        <translation>Messgerät</translation>
    </message>
    <message>
        <source>Saved settings: columns, units, gauge and amplifier. Select one, or type a name and keep the present settings.</source>
        <translation>Einstellungen, die unter einem Namen behalten wurden: Spalten, Einheiten, Messstreifen und Verstärker. Eine auswählen oder einen Namen eintippen und die jetzigen behalten.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keeps the present settings under this name, for the next record</source>
        <translation>Behält die jetzigen Einstellungen unter diesem Namen, für die nächste Aufzeichnung</translation>
    </message>
    <message>
        <source>as in the last import</source>
        <translation>wie beim letzten Import</translation>
    </message>
    <message>
        <source>record to read the rock from</source>
        <translation>Aufzeichnung, aus der das Gestein gelesen wird</translation>
    </message>
</context>
<context>
    <name>drillwave::ImportPlot</name>
    <message>
        <source>record</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>used</source>
        <translation>übernommen</translation>
    </message>
    <message>
        <source>time in the file [%1]</source>
        <translation>Zeit in der Datei [%1]</translation>
    </message>
</context>
<context>
    <name>drillwave::Importer</name>
    <message>
        <source>Import a measured signal</source>
        <translation>Ein gemessenes Signal importieren</translation>
    </message>
    <message>
        <source>Tables of samples (*.csv *.txt *.tsv *.dat *.asc *.prn);;All files (*)</source>
        <translation>Tabellen von Abtastwerten (*.csv *.txt *.tsv *.dat *.asc *.prn);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import of a measured signal</source>
        <translation>Import eines gemessenen Signals</translation>
    </message>
    <message>
        <source>The hammer blow is taken from %1.</source>
        <translation>Der Hammerschlag ist aus %1 übernommen.</translation>
    </message>
    <message>
        <source>%1 is shown on the page Blow.</source>
        <translation>%1 liegt jetzt über der Seite Schlag.</translation>
    </message>
    <message>
        <source>take the hammer blow from %1</source>
        <translation>den Hammerschlag aus %1 übernehmen</translation>
    </message>
    <message>
        <source>%1 measured curves are there already: remove one on the page Blow.</source>
        <translation>%1 gemessene Kurven sind schon da: eine auf der Seite Schlag entfernen.</translation>
    </message>
    <message>
        <source>The settings are kept for recorder %1.</source>
        <translation>Die Einstellungen sind für das Messgerät %1 behalten.</translation>
    </message>
    <message>
        <source>Open records of strain gauges</source>
        <translation>Aufzeichnungen von Dehnungsmessstreifen öffnen</translation>
    </message>
</context>
<context>
    <name>drillwave::IndexingBox</name>
    <message>
        <source>rock</source>
        <translation>Gestein</translation>
    </message>
    <message>
        <source>Machine: rock</source>
        <translation>Maschine: Gestein</translation>
    </message>
    <message>
        <source>Whether each blow meets new rock, or the crater of the blow before</source>
        <translation>Ob die Bohrkrone für jeden Schlag auf neues Gestein gedreht wird, oder wieder denselben Krater trifft</translation>
    </message>
    <message>
        <source>new for every blow</source>
        <translation>neu für jeden Schlag</translation>
    </message>
    <message>
        <source>the same crater</source>
        <translation>derselbe Krater</translation>
    </message>
    <message>
        <source>change the rock of the next blow</source>
        <translation>ändern, welches Gestein die Schläge treffen</translation>
    </message>
</context>
<context>
    <name>drillwave::JointMarksItem</name>
    <message>
        <source>hammer</source>
        <translation>Hammer</translation>
    </message>
</context>
<context>
    <name>drillwave::KnownFields</name>
    <message>
        <source>tolerance of %1</source>
        <translation>Toleranz von %1</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>95 % tolerance; empty: assumed</source>
        <translation>Toleranz zu 95 %; leer: angenommen</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>muss positiv sein</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, Einheit</translation>
    </message>
</context>
<context>
    <name>drillwave::LanguageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>Restart Drillwave in this language now: %1?</source>
        <translation>Drillwave jetzt in dieser Sprache neu starten: %1?</translation>
    </message>
    <message>
        <source>Unsaved changes, the file name, pinned runs and measured signals come back. Numbers stay as the system writes them; files and some chapters of the manual are in English.</source>
        <translation>Nicht gespeicherte Änderungen, der Name der Datei, angeheftete Läufe und gemessene Signale kommen zurück. Zahlen bleiben, wie das System sie schreibt; Dateien und einige Kapitel des Handbuchs sind auf Englisch.</translation>
    </message>
</context>
<context>
    <name>drillwave::LawSection</name>
    <message>
        <source>Bit and rock: law</source>
        <translation>Bohrkrone und Gestein: Kraft–Eindringung</translation>
    </message>
    <message>
        <source>Rise of the force with penetration: along a line, along lines with corners, or as a power; unloading always follows one slope</source>
        <translation>Wie die Kraft mit der Eindringung steigt: entlang einer Geraden, entlang eines Linienzugs mit Knicken oder mit einer Potenz davon; sie fällt immer mit derselben Steigung</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>geknickt</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Potenzgesetz</translation>
    </message>
    <message>
        <source>+ corner</source>
        <translation>+ Ecke</translation>
    </message>
    <message>
        <source>change the law of the rock</source>
        <translation>das Gesetz des Gesteins ändern</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>slope, of k</source>
        <translation>Steigung, von k</translation>
    </message>
    <message>
        <source>Remove corner %1</source>
        <translation>Ecke %1 entfernen</translation>
    </message>
    <message>
        <source>Corner %1: %2</source>
        <translation>Ecke %1: %2</translation>
    </message>
    <message>
        <source>add a corner to the law of the rock</source>
        <translation>dem Gesetz des Gesteins eine Ecke hinzufügen</translation>
    </message>
    <message>
        <source>remove a corner from the law of the rock</source>
        <translation>aus dem Gesetz des Gesteins eine Ecke entfernen</translation>
    </message>
    <message>
        <source>force–penetration</source>
        <translation>Kraft–Eindringung</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
</context>
<context>
    <name>drillwave::LevelField</name>
    <message>
        <source>Contours at</source>
        <translation>Höhenlinien bei</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>höchstens %1 Werte</translation>
    </message>
    <message>
        <source>Values of the contours, in the present units: 0.95; 1; 1.05</source>
        <translation>Die Werte, von denen das Kennfeld Höhenlinien hat, in den gezeigten Einheiten: 0.95; 1; 1.05</translation>
    </message>
</context>
<context>
    <name>drillwave::MainWindow</name>
    <message>
        <source>exact method · not solved</source>
        <translation>exaktes Verfahren · nicht gelöst</translation>
    </message>
    <message>
        <source>cell method · not solved</source>
        <translation>Zellenverfahren · nicht gelöst</translation>
    </message>
    <message>
        <source>cell method · computed in %1 · efficiency %2 ± %3</source>
        <translation>Zellenverfahren · berechnet in %1 · Wirkungsgrad %2 ± %3</translation>
    </message>
    <message>
        <source>exact method · %1 · computed in %2 · e = %3 ± %4</source>
        <translation>exaktes Verfahren · %1 · berechnet in %2 · e = %3 ± %4</translation>
    </message>
    <message>
        <source>1 force peak</source>
        <translation>1 Kraftspitze</translation>
    </message>
    <message>
        <source>%1 force peaks</source>
        <translation>%1 Kraftspitzen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>the input was changed meanwhile.</source>
        <translation>die Eingabe wurde inzwischen geändert.</translation>
    </message>
    <message>
        <source>another page was chosen meanwhile.</source>
        <translation>inzwischen wurde eine andere Seite gewählt.</translation>
    </message>
    <message>
        <source>other units were chosen meanwhile.</source>
        <translation>inzwischen wurden andere Einheiten gewählt.</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for the case of a crash.</source>
        <translation>Nicht gespeicherte Änderungen können für den Fall eines Absturzes nicht aufbewahrt werden.</translation>
    </message>
    <message>
        <source>%1[*] — Drillwave</source>
        <translation>%1[*] — Drillwave</translation>
    </message>
    <message>
        <source>%1 – %2[*] — Drillwave</source>
        <translation>%1 – %2[*] — Drillwave</translation>
    </message>
</context>
<context>
    <name>drillwave::ManualHelp</name>
    <message>
        <source>Menus and their keys</source>
        <translation>Menüs, wie sie jetzt sind</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>action</source>
        <translation>was sie tut</translation>
    </message>
</context>
<context>
    <name>drillwave::MapPage</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Result over two parameters</source>
        <translation>Ergebnis über zwei Parametern</translation>
    </message>
    <message>
        <source>Points of the map</source>
        <translation>Punkte des Kennfelds</translation>
    </message>
    <message>
        <source>Number of values of each of the two parameters</source>
        <translation>Wie viele Werte jeder der beiden Parameter annimmt</translation>
    </message>
    <message>
        <source>Both axes are %1: choose another parameter for one of them.</source>
        <translation>Beide Achsen sind %1: für eine davon einen anderen Parameter wählen.</translation>
    </message>
    <message>
        <source>here %1. %2</source>
        <translation>hier %1. %2</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Kennfeld</translation>
    </message>
    <message>
        <source>Click on a line or preset to use that point; Shift+click pins it. The crosshair can be dragged.</source>
        <translation>Klick auf eine Linie oder Voreinstellung: diesen Punkt übernehmen; mit Umschalt: zum Vergleich anheften. Das Fadenkreuz lässt sich ziehen.</translation>
    </message>
</context>
<context>
    <name>drillwave::MarchedNotice</name>
    <message>
        <source>Single blow</source>
        <translation>Einzelner Schlag</translation>
    </message>
    <message>
        <source>Shows the blow from rest again, as in Result</source>
        <translation>Wieder den Schlag zeigen, der in Ruhe beginnt, wie im Ergebnis</translation>
    </message>
</context>
<context>
    <name>drillwave::MeasuredBar</name>
    <message>
        <source>N: %1</source>
        <translation>N: %1</translation>
    </message>
    <message>
        <source>F: %1</source>
        <translation>F: %1</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>not drawn: compared with scenarios in physical units</source>
        <translation>nicht gezeichnet: wird mit Szenarien in physikalischen Einheiten verglichen</translation>
    </message>
    <message>
        <source>Measured curve</source>
        <translation>Gemessene Kurve</translation>
    </message>
    <message>
        <source>Shows the waves at the section of this gauge</source>
        <translation>Die Wellen an der Stelle zeigen, an der das gemessen wurde</translation>
    </message>
    <message>
        <source>Shift of the measured curve in time</source>
        <translation>Zeitversatz der gemessenen Kurve</translation>
    </message>
    <message>
        <source>Time added to the measured curve; Up and Down change it</source>
        <translation>Kommt zu den Zeiten der gemessenen Kurve hinzu; Hoch und Runter verschieben sie</translation>
    </message>
    <message>
        <source>Shifts the curve to the best fit with the computed one</source>
        <translation>Dorthin verschieben, wo sie am besten zur berechneten Kurve passt</translation>
    </message>
    <message>
        <source>Remove the measured curve</source>
        <translation>Die gemessene Kurve entfernen</translation>
    </message>
    <message>
        <source>Removes this measured curve; Undo brings it back</source>
        <translation>Diese gemessene Kurve wegnehmen; Rückgängig bringt sie zurück</translation>
    </message>
    <message>
        <source>Over the common time: root mean square of the difference; measured minus computed peak; delay of the measured curve from the best fit</source>
        <translation>Über der gemeinsamen Zeit: Wurzel aus dem mittleren Quadrat des Unterschieds; Betrag der größten Kraft, gemessen weniger berechnet; um wie viel die gemessene Kurve später kommt, als wo sie am besten passt</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Unit of the shift in time</source>
        <translation>Einheit des Zeitversatzes</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>%1 points; no sample is further than %2 from the lines between them</source>
        <translation>%1 Punkte; kein übernommener Abtastwert ist weiter als %2 von ihnen entfernt</translation>
    </message>
</context>
<context>
    <name>drillwave::MeasuredList</name>
    <message>
        <source>lay over the measured curve %1</source>
        <translation>die gemessene Kurve %1 darüberlegen</translation>
    </message>
    <message>
        <source>remove the measured curve %1</source>
        <translation>die gemessene Kurve %1 entfernen</translation>
    </message>
    <message>
        <source>shift the measured curve %1</source>
        <translation>die gemessene Kurve %1 verschieben</translation>
    </message>
</context>
<context>
    <name>drillwave::Message</name>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>The required feed force needs a scenario in physical units. This scenario is given by its dimensionless groups, without blow frequency and forces.</source>
        <translation>Der erforderliche Andruck braucht ein Szenario in physikalischen Einheiten. Dieses Szenario ist durch seine dimensionslosen Kennzahlen gegeben, ohne Schlagfrequenz und Kräfte.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Andruck</translation>
    </message>
    <message>
        <source>effective force, with weight along the hole</source>
        <translation>wirksame Kraft, mit Gewicht entlang des Bohrlochs</translation>
    </message>
    <message>
        <source>installed feed force</source>
        <translation>installierter Andruck</translation>
    </message>
    <message>
        <source>95 % of gaps</source>
        <translation>95 % der Spalte</translation>
    </message>
    <message>
        <source>elastic, worst gap</source>
        <translation>elastisch, ungünst. Spalt</translation>
    </message>
    <message>
        <source>Mean force that balances a blow which starts at rest on the rock</source>
        <translation>Mittlere Kraft, die einen Schlag ausgleicht, der in Ruhe auf dem Gestein beginnt</translation>
    </message>
    <message>
        <source>At this feed an undamped rigid rod is back at the rock before the next blow</source>
        <translation>Bei diesem Andruck ist eine ungedämpfte starre Stange vor dem nächsten Schlag zurück am Gestein</translation>
    </message>
    <message>
        <source>Effective feed force over the required one, less 1</source>
        <translation>Wirksamer Andruck geteilt durch den erforderlichen, minus 1</translation>
    </message>
    <message>
        <source>could not be solved: %1</source>
        <translation>konnte nicht gelöst werden: %1</translation>
    </message>
    <message>
        <source>%1 of %2 points could not be solved: their cells are empty; the first: %3</source>
        <translation>%1 von %2 Punkten ohne Lösung, ihre Zellen bleiben leer; der erste: %3</translation>
    </message>
    <message>
        <source>effective %1</source>
        <translation>wirksam %1</translation>
    </message>
    <message>
        <source>installed %1</source>
        <translation>installiert %1</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; free some space or choose another place</source>
        <translation>%1: kann nicht geschrieben werden: %2; Platz schaffen oder einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another place</source>
        <translation>%1: kann nicht geschrieben werden: %2; einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made: %2; choose another one</source>
        <translation>%1: der Ordner kann nicht angelegt werden: %2; einen anderen wählen</translation>
    </message>
    <message>
        <source>%1: is there and no file; choose another folder</source>
        <translation>%1: gibt es schon, und es ist keine Datei; einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>%1: exists already; choose another folder or ask for it to be overwritten</source>
        <translation>%1: gibt es schon; einen anderen Ordner wählen oder Überschreiben verlangen</translation>
    </message>
    <message>
        <source>%1: another run has been writing there for %2 seconds; wait for it or choose another folder</source>
        <translation>%1: ein anderer Lauf schreibt dort seit %2 Sekunden; auf ihn warten oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>%1: has been put there or changed by somebody else; move it away, or keep the runs again to replace it</source>
        <translation>%1: wurde von jemand anderem dorthin gelegt oder geändert; verschieben, oder die Läufe noch einmal aufbewahren, um sie zu ersetzen</translation>
    </message>
    <message>
        <source>The input %1 = %2 is outside its typical range, %3 to %4.</source>
        <translation>Die Eingabe %1 = %2 liegt außerhalb ihres üblichen Bereichs, %3 bis %4.</translation>
    </message>
    <message>
        <source>When the first reflection returns to the hammer, %1 % of the impulse of the blow is still to come. A real hammer would feel the reflection, but here the hammer force is prescribed. To include this effect, use a drill string with a hammer.</source>
        <translation>Wenn die erste Reflexion zum Hammer zurückkommt, stehen noch %1&#xa0;% vom Kraftstoß des Schlags aus. Ein wirklicher Hammer würde die Reflexion spüren, hier aber ist die Hammerkraft vorgegeben. Ein Bohrstrang mit Hammer berücksichtigt diese Wirkung.</translation>
    </message>
    <message>
        <source>No hammer data are given. The hammer is assumed to have the impedance of the rod and to give a rectangular blow. Enter the data of the piston.</source>
        <translation>Zum Hammer ist nichts angegeben. Angenommen ist ein Hammer mit der Impedanz der Stange und ein rechteckiger Schlag. Die Daten des Kolbens eingeben.</translation>
    </message>
    <message>
        <source>The hammer is the default one (%1, the material of the rod). Give the data of the rock drill&apos;s piston.</source>
        <translation>Der Hammer ist der Standardhammer (%1, Werkstoff der Stange). Die Daten des Kolbens des Bohrhammers angeben.</translation>
    </message>
    <message>
        <source>The impedance of the hammer is below that of the rod. The hammer therefore bounces back after one force step, and the rod receives more than the momentum of the hammer.</source>
        <translation>Die Impedanz des Hammers ist kleiner als die der Stange. Der Hammer prallt daher nach einer Kraftstufe zurück, und die Stange übernimmt mehr als den Impuls des Hammers.</translation>
    </message>
    <message>
        <source>The impedance of the hammer is above that of the rod: the force falls in ever smaller steps. Reflections that return to the hammer are neglected here.</source>
        <translation>Die Impedanz des Hammers ist größer als die der Stange: die Kraft fällt in immer kleineren Stufen. Rückläufe zum Hammer sind dabei vernachlässigt.</translation>
    </message>
    <message>
        <source>The waves of a blow make only %1 round trips in the string before the next blow, and they still act on that blow (%3). This may change the penetration by up to 10 %, depending on blow frequency and string length; to compute it, use %2.</source>
        <translation>Die Wellen eines Schlags machen nur %1 Hin- und Rückläufe im Strang bis zum nächsten Schlag und wirken noch auf diesen (%3). Das kann die Eindringung um bis zu 10&#xa0;% ändern, je nach Schlagfrequenz und Stranglänge; zum Berechnen %2 verwenden.</translation>
    </message>
    <message>
        <source>The waves of a blow make only %1 round trips in the string before the next blow, and they still act on that blow (%4). Because %1 is close to the whole number %2, they arrive at the same time as the next blow. This may change the penetration by up to 10 %; to compute it, use %3.</source>
        <translation>Die Wellen eines Schlags machen nur %1 Hin- und Rückläufe im Strang bis zum nächsten Schlag und wirken noch auf diesen (%4). Weil %1 nahe bei der ganzen Zahl %2 liegt, treffen sie gleichzeitig mit dem nächsten Schlag ein. Das kann die Eindringung um bis zu 10&#xa0;% ändern; zum Berechnen %3 verwenden.</translation>
    </message>
    <message>
        <source>only share a time step of %1, which takes more work than is permitted</source>
        <translation>haben nur einen Zeitschritt von %1 gemeinsam, der mehr Aufwand kostet, als erlaubt ist</translation>
    </message>
    <message>
        <source>share no time step</source>
        <translation>haben keinen Zeitschritt gemeinsam</translation>
    </message>
    <message>
        <source>force on the rock and rebound have errors: e by up to %1</source>
        <translation>Kraft auf das Gestein und Rückprall weichen ab: e um bis zu %1</translation>
    </message>
    <message>
        <source>the efficiency may have an error of %1</source>
        <translation>der Wirkungsgrad kann um %1 abweichen</translation>
    </message>
    <message>
        <source>The transit times of the sections %1: they were rounded by up to %2, and %3. %4</source>
        <translation>Die Laufzeiten der Abschnitte %1: sie wurden um bis zu %2 gerundet, und %3. %4</translation>
    </message>
    <message>
        <source>Round the section lengths to multiples of a common length, such as 50 mm. A longer time step then fits all sections exactly.</source>
        <translation>Die Abschnittslängen auf Vielfache einer gemeinsamen Länge runden, zum Beispiel 50 mm. Ein längerer Zeitschritt passt dann genau zu allen Abschnitten.</translation>
    </message>
    <message>
        <source>Enter all lengths in whole millimetres, with the same steel in all sections: the time step is then exact.</source>
        <translation>Alle Längen in ganzen Millimetern eingeben, mit demselben Stahl in allen Abschnitten: dann ist der Zeitschritt genau.</translation>
    </message>
    <message>
        <source>the blow is longer than a round trip in the rod (tau = %1 &lt; 0.5)</source>
        <translation>der Schlag länger dauert als ein Hin- und Rücklauf in der Stange (tau = %1 &lt; 0,5)</translation>
    </message>
    <message>
        <source>the bit meets the rock in the middle of a wave (delta = %1 is not a whole number)</source>
        <translation>die Bohrkrone das Gestein mitten in einer Welle trifft (delta = %1 ist keine ganze Zahl)</translation>
    </message>
    <message>
        <source>the loading curve of the rock is not a straight line</source>
        <translation>die Belastungskurve des Gesteins keine Gerade ist</translation>
    </message>
    <message>
        <source>the bit is still on the rock when the next reflection arrives</source>
        <translation>die Bohrkrone noch auf dem Gestein ist, wenn die nächste Reflexion ankommt</translation>
    </message>
    <message>
        <source>The closed-form solution for elastic rock does not apply, because %1. Its coefficient of restitution, e = %2, has an error of %3.</source>
        <translation>Die geschlossene Lösung für elastisches Gestein gilt nicht, weil %1. Ihre Stoßzahl e = %2 hat einen Fehler von %3.</translation>
    </message>
    <message>
        <source>compression</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>The rod moves as a rigid body until it meets the rock. The gap between bit and rock therefore only shifts the time of contact and has no other effect.</source>
        <translation>Die Stange bewegt sich als starrer Körper, bis sie auf das Gestein trifft. Der Spalt zwischen Bohrkrone und Gestein verschiebt daher nur die Zeit des Kontakts und hat keine andere Wirkung.</translation>
    </message>
    <message>
        <source>The rod rebounds with more momentum than it had before impact (e = %1). An estimate for rigid rock (e = 1) gives too small a feed force.</source>
        <translation>Die Stange prallt mit mehr Impuls zurück, als sie vor dem Aufprall hatte (e = %1). Eine Schätzung für starres Gestein (e = 1) ergibt einen zu kleinen Andruck.</translation>
    </message>
    <message>
        <source>The bit hits the rock %1 times in this blow: reflected waves push it against the rock again.</source>
        <translation>Die Bohrkrone trifft das Gestein in diesem Schlag %1-mal: reflektierte Wellen drücken sie wieder gegen das Gestein.</translation>
    </message>
    <message>
        <source>The numerical error of the coefficient of restitution e may be as large as %1.</source>
        <translation>Der numerische Fehler der Stoßzahl e kann bis zu %1 betragen.</translation>
    </message>
    <message>
        <source>This blow is not over after %1, when the next blow starts: bit and rock, or hammer and string, may meet again. The values are for that moment and not final.</source>
        <translation>Dieser Schlag ist nach %1, wenn der nächste beginnt, nicht zu Ende: Bohrkrone und Gestein oder Hammer und Strang können sich noch einmal treffen. Die Werte gelten für diesen Zeitpunkt und sind nicht endgültig.</translation>
    </message>
    <message>
        <source>The largest stresses of the sections were not computed, because this would exceed the limit of computing work. No strength was checked. Try a shorter end time (end_time).</source>
        <translation>Die größten Spannungen der Abschnitte wurden nicht berechnet, weil das den erlaubten Rechenaufwand überschreiten würde. Keine Festigkeit wurde geprüft. Eine kürzere Endzeit (end_time) versuchen.</translation>
    </message>
    <message>
        <source>The force on the rock reaches only %1, below the first corner of the loading curve at %2. The rock therefore acts as if its loading curve were one straight line.</source>
        <translation>Die Kraft auf das Gestein erreicht nur %1, unter der ersten Ecke der Belastungskurve bei %2. Das Gestein wirkt daher, als wäre die Belastungskurve eine einzige Gerade.</translation>
    </message>
    <message>
        <source>The feed force of %1 is below the mean force of the blows, %2, or too close to it. The gap between bit and rock therefore grows from blow to blow. Increase the feed force.</source>
        <translation>Der Andruck von %1 liegt unter der mittleren Kraft der Schläge, %2, oder zu nahe daran. Der Spalt zwischen Bohrkrone und Gestein wächst daher von Schlag zu Schlag. Den Andruck erhöhen.</translation>
    </message>
    <message>
        <source>Nothing damps the waves, so their fronts never decay. Give a wave loss; 1 to 30 % per round trip is usual.</source>
        <translation>Nichts dämpft die Wellen, daher klingen ihre Fronten nie ab. Einen Wellenverlust angeben; 1 bis 30&#xa0;% je Hin- und Rücklauf ist üblich.</translation>
    </message>
    <message>
        <source>After the piston has separated, the rebounding string hits it again, and the piston passes up to %1 % of its momentum to the string. If the machine has drawn the piston back by then, switch off “may strike again” (restrike: false in the file).</source>
        <translation>Nachdem sich der Kolben getrennt hat, trifft ihn der zurückprallende Strang noch einmal, und der Kolben gibt bis zu %1&#xa0;% seines Impulses an den Strang ab. Hat die Maschine den Kolben bis dahin zurückgezogen, „darf wieder schlagen“ ausschalten (restrike: false in der Datei).</translation>
    </message>
    <message>
        <source>At impact, the shank is up to %1 from its mean position in the machine. A real machine would then have another stroke and blow energy than assumed. If the damper has no spring, add one: a dashpot alone lets the shank drift.</source>
        <translation>Beim Schlag ist das Einsteckende bis zu %1 von seiner mittleren Lage in der Maschine entfernt. Eine wirkliche Maschine hätte dann einen anderen Hub und eine andere Schlagenergie als angenommen. Hat die Dämpfung keine Feder, eine hinzufügen: Ein Dämpfer allein lässt das Einsteckende wandern.</translation>
    </message>
    <message>
        <source>The blow frequency is rounded to %1, so that each blow falls on a time step.</source>
        <translation>Die Schlagfrequenz ist auf %1 gerundet, damit jeder Schlag auf einen Zeitschritt fällt.</translation>
    </message>
    <message>
        <source>The motion may not be steady yet: means of the first and second half of the blows differ by more than three times their error. Increase the number of blows, or of transient blows.</source>
        <translation>Die Bewegung ist vielleicht noch nicht stationär: Mittel der ersten und der zweiten Hälfte der Schläge unterscheiden sich um mehr als das Dreifache ihres Fehlers. Die Zahl der Schläge oder der Schläge zum Einschwingen erhöhen.</translation>
    </message>
    <message>
        <source>Two steady motions are possible. The start or the time step decides which one is computed; a real drill may settle into either.</source>
        <translation>Zwei stetige Bewegungen sind möglich. Anfang oder Zeitschritt entscheiden, welche berechnet wird; eine wirkliche Maschine kann jede der beiden annehmen.</translation>
    </message>
    <message>
        <source>The motion does not repeat from blow to blow: use the means, not the values of single blows.</source>
        <translation>Die Bewegung wiederholt sich nicht von Schlag zu Schlag: die Mittelwerte verwenden, nicht die Werte einzelner Schläge.</translation>
    </message>
    <message>
        <source>The energy balance of all blows has an error of %1 %. The time step is too long for the short contacts between bit and rock. A shorter time step reduces the error in proportion.</source>
        <translation>Die Energiebilanz aller Schläge hat einen Fehler von %1&#xa0;%. Der Zeitschritt ist für die kurzen Kontakte von Bohrkrone und Gestein zu lang. Ein kürzerer Zeitschritt verringert den Fehler im gleichen Verhältnis.</translation>
    </message>
    <message>
        <source>The data of the damper are assumed, because makers do not publish them. Try dashpots from 0.05 to 0.5 times the impedance of the rod.</source>
        <translation>Die Daten des Dämpfers sind angenommen, weil Hersteller sie nicht veröffentlichen. Dämpfer vom 0,05- bis 0,5-Fachen der Impedanz der Stange versuchen.</translation>
    </message>
    <message>
        <source>a dashpot of %1 and a spring of %2</source>
        <translation>einem Dämpfer von %1 und einer Feder von %2</translation>
    </message>
    <message>
        <source>a dashpot of %1</source>
        <translation>einem Dämpfer von %1</translation>
    </message>
    <message>
        <source>a spring of %1</source>
        <translation>einer Feder von %1</translation>
    </message>
    <message>
        <source>The blows could not be solved: %1.</source>
        <translation>Die Schläge konnten nicht gelöst werden: %1.</translation>
    </message>
    <message>
        <source>The computation was stopped before all blows were solved.</source>
        <translation>Die Rechnung wurde angehalten, bevor alle Schläge gelöst waren.</translation>
    </message>
    <message>
        <source>rod back at rest before every blow</source>
        <translation>Stange kommt vor jedem Schlag zur Ruhe</translation>
    </message>
    <message>
        <source>irregular: use means only</source>
        <translation>unregelmäßig: einzelne Schläge sind kein Ergebnis</translation>
    </message>
    <message>
        <source>repeats every blow</source>
        <translation>wiederholt sich mit jedem Schlag</translation>
    </message>
    <message>
        <source>repeats every %1 blows</source>
        <translation>wiederholt sich alle %1 Schläge</translation>
    </message>
    <message>
        <source>Lyapunov exponent %1 per blow</source>
        <translation>Ljapunow-Exponent %1 je Schlag</translation>
    </message>
    <message>
        <source>Lyapunov exponent %1 +- %2 per blow</source>
        <translation>Ljapunow-Exponent %1 +- %2 je Schlag</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>at every gap</source>
        <translation>bei jedem Spalt</translation>
    </message>
    <message>
        <source>The feed cannot be judged: the scenario has only dimensionless groups. Enter the scenario in physical units.</source>
        <translation>Der Vorschub wird nicht beurteilt: das Szenario ist nur durch seine dimensionslosen Kennzahlen gegeben. Das Szenario in physikalischen Einheiten eingeben.</translation>
    </message>
    <message>
        <source>The feed cannot be judged: give a blow frequency.</source>
        <translation>Der Vorschub wird nicht beurteilt: eine Schlagfrequenz angeben.</translation>
    </message>
    <message>
        <source>%1 (%2 with the weight along the hole)</source>
        <translation>%1 (%2 mit dem Gewicht entlang des Lochs)</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>this blow</source>
        <translation>dieser Schlag</translation>
    </message>
    <message>
        <source>95 % of all gaps</source>
        <translation>95&#xa0;% aller Spalte</translation>
    </message>
    <message>
        <source>rigid rock</source>
        <translation>starres Gestein</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>Abschnitt %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>force of corner %1</source>
        <translation>Kraft der Ecke %1</translation>
    </message>
    <message>
        <source>slope behind corner %1</source>
        <translation>Steigung hinter Ecke %1</translation>
    </message>
    <message>
        <source>hammer %1</source>
        <translation>Hammer %1</translation>
    </message>
    <message>
        <source>with its unit</source>
        <translation>mit Einheit</translation>
    </message>
    <message>
        <source>in US units</source>
        <translation>in US-Einheiten</translation>
    </message>
    <message>
        <source>preset %1: %2</source>
        <translation>Voreinstellung %1: %2</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>assumed by the program</source>
        <translation>vom Programm angenommen</translation>
    </message>
    <message>
        <source>hammer may strike again</source>
        <translation>Hammer darf wieder schlagen</translation>
    </message>
    <message>
        <source>law of bit and rock</source>
        <translation>Gesetz von Krone und Gestein</translation>
    </message>
    <message>
        <source>rock at the next blow</source>
        <translation>Gestein beim nächsten Schlag</translation>
    </message>
    <message>
        <source>table of the blow</source>
        <translation>Tabelle des Schlags</translation>
    </message>
    <message>
        <source>shape of the blow</source>
        <translation>Form des Schlags</translation>
    </message>
    <message>
        <source>its points are in the scenario</source>
        <translation>ihre Punkte stehen im Szenario</translation>
    </message>
    <message>
        <source>in the scenario</source>
        <translation>im Szenario</translation>
    </message>
    <message>
        <source>points of the blow</source>
        <translation>Punkte des Schlags</translation>
    </message>
    <message>
        <source>method %1</source>
        <translation>Verfahren %1</translation>
    </message>
    <message>
        <source>method %1, %2 segments</source>
        <translation>Verfahren %1, %2 Segmente</translation>
    </message>
    <message>
        <source>the percussion power</source>
        <translation>die Schlagleistung</translation>
    </message>
    <message>
        <source>the penetration rate</source>
        <translation>der Bohrfortschritt</translation>
    </message>
    <message>
        <source>polynomial cells</source>
        <translation>polynomiale Zellen</translation>
    </message>
    <message>
        <source>the feed force</source>
        <translation>der Andruck</translation>
    </message>
    <message>
        <source>%1 needs a scenario in physical units; this one is given by its dimensionless groups</source>
        <translation>%1 braucht ein Szenario in physikalischen Einheiten; dieses ist durch seine dimensionslosen Kennzahlen gegeben</translation>
    </message>
    <message>
        <source>%1 needs drill.blow_frequency; give it in the scenario or with --set</source>
        <translation>%1 braucht drill.blow_frequency; im Szenario oder mit --set angeben</translation>
    </message>
    <message>
        <source>The waves of this blow have %1 polynomial pieces, too many to study all gaps in a report: run `drillwave %2` instead, which takes longer.</source>
        <translation>Die Wellen dieses Schlags haben %1 Polynomstücke, zu viele, um in einem Bericht alle Spalte zu untersuchen: stattdessen `drillwave %2` aufrufen, was länger dauert.</translation>
    </message>
    <message>
        <source>The blow could not be solved at all gaps: %1</source>
        <translation>Der Schlag konnte nicht bei allen Spalten gelöst werden: %1</translation>
    </message>
    <message>
        <source>The reference case does not depend on the gap, which only shifts the time of contact.</source>
        <translation>Der Referenzfall hängt nicht vom Spalt ab: dieser verschiebt nur die Zeit des Kontakts.</translation>
    </message>
    <message>
        <source>The hammer still pushes when its first reflection returns: results are periodic only for gaps above %1 d0, and the statistics cover the first period above it.</source>
        <translation>Der Hammer drückt noch, wenn seine erste Reflexion zurück ist: die Ergebnisse haben erst ab einem Spalt von %1 d0 eine Periode im Spalt, und die Statistik gilt für die Periode, die dort beginnt.</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>%1 kink</source>
        <translation>%1 Knick</translation>
    </message>
    <message>
        <source>at a gap of</source>
        <translation>bei einem Spalt von</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>%1 % quantile</source>
        <translation>%1&#xa0;%-Quantil</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>all gaps equally likely</source>
        <translation>alle Spalte gleich wahrscheinlich</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>kleinster Wert</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größter Wert</translation>
    </message>
    <message>
        <source>gap %1 +- %2</source>
        <translation>Spalt %1 ± %2</translation>
    </message>
    <message>
        <source>e &gt; 1 at %1 of all gaps</source>
        <translation>e &gt; 1 bei %1 aller Spalte</translation>
    </message>
    <message>
        <source>, %1 of the scattered ones</source>
        <translation>, %1 der gestreuten</translation>
    </message>
    <message>
        <source>rises above 1 at %1</source>
        <translation>steigt über 1 bei %1</translation>
    </message>
    <message>
        <source>falls below 1 at %1</source>
        <translation>fällt unter 1 bei %1</translation>
    </message>
    <message>
        <source>%1 (slope %2 to %3 per d0)</source>
        <translation>%1 (Steigung von %2 auf %3 je d0)</translation>
    </message>
    <message>
        <source>Kinks of e at a gap of %1</source>
        <translation>Knicke von e bei einem Spalt von %1</translation>
    </message>
    <message>
        <source>The scattered gap is a normal distribution cut off at zero; mean and deviation are those before the cut.</source>
        <translation>Der gestreute Spalt ist eine bei null abgeschnittene Normalverteilung: Mittel und Standardabweichung sind die vor dem Schnitt.</translation>
    </message>
    <message>
        <source>Errors below %1, from %2 blow</source>
        <translation>Fehler unter %1, aus %2 Schlag</translation>
    </message>
    <message>
        <source>Errors below %1, from %2 blows</source>
        <translation>Fehler unter %1, aus %2 Schlägen</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Auftraggeber</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Report on one blow of a percussive drill, written by Drillwave %1, solved by %2. Tension is positive. %3</source>
        <translation>Bericht über einen Schlag beim schlagenden Bohren, geschrieben von Drillwave %1, Lösung: %2. Zug ist positiv. %3</translation>
    </message>
    <message>
        <source>Hammer and string of uniform sections; bending, torsion and friction in threads beyond a loss factor are not modelled.</source>
        <translation>Hammer und Strang aus gleichförmigen Abschnitten; Biegung, Torsion und Reibung in Gewinden über einen Verlustfaktor hinaus sind nicht modelliert.</translation>
    </message>
    <message>
        <source>One uniform rod; joints and the mass of the bit are not modelled.</source>
        <translation>Eine gleichförmige Stange; Verbindungen und die Masse der Bohrkrone sind nicht modelliert.</translation>
    </message>
    <message>
        <source>Alerts and remarks</source>
        <translation>Warnungen und Bemerkungen</translation>
    </message>
    <message>
        <source>Warning:</source>
        <translation>Warnung:</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Hinweis:</translation>
    </message>
    <message>
        <source>Nothing unusual.</source>
        <translation>Nichts Ungewöhnliches.</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>what</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Hammer and string</source>
        <translation>Hammer und Strang</translation>
    </message>
    <message>
        <source>The other %1 sections are in the report as HTML.</source>
        <translation>Die übrigen %1 Abschnitte stehen im HTML-Bericht.</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Groups and scales</source>
        <translation>Kennzahlen und Bezugsgrößen</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>scaled</source>
        <translation>als Vielfaches</translation>
    </message>
    <message>
        <source>place and time</source>
        <translation>wo und wann</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>E₀ and p₀ are the energy and momentum of the hammer.</source>
        <translation>E₀ und p₀ sind Energie und Impuls des Hammers.</translation>
    </message>
    <message>
        <source>W is the work of the hammer.</source>
        <translation>W ist die Arbeit des Hammers.</translation>
    </message>
    <message>
        <source>Comparison with other runs</source>
        <translation>Vergleich mit anderen Läufen</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Comparison with measurements</source>
        <translation>Vergleich mit der Messung</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Over the common time: root mean square of the difference, measured minus computed peak force, and delay of the measured signal from the best fit.</source>
        <translation>Über die gemeinsame Zeit: die Wurzel aus dem mittleren Quadrat der Differenz, der Betrag der größten Kraft, gemessen minus berechnet, und um wie viel später das gemessene Signal kommt als dort, wo es am besten passt.</translation>
    </message>
    <message>
        <source>Numerical error</source>
        <translation>Genauigkeit der Lösung</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>The errors of the efficiency and of the balances are numerical; rock and string are known far less well.</source>
        <translation>Der Fehler des Wirkungsgrads und die Fehler der Bilanzen sind numerisch; was man von Gestein und Strang weiß, ist weit gröber.</translation>
    </message>
    <message>
        <source>The error bound of e and the errors of the balances are numerical; rock and rod are known far less well.</source>
        <translation>Die Schranke für e und die Fehler der Bilanzen sind numerisch; was man von Gestein und Stange weiß, ist weit gröber.</translation>
    </message>
    <message>
        <source>Energy balance</source>
        <translation>Wohin die Energie ging</translation>
    </message>
    <message>
        <source>share of E₀</source>
        <translation>Anteil an E₀</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Largest stresses of every section</source>
        <translation>Größte Spannungen jedes Abschnitts</translation>
    </message>
    <message>
        <source>Places are from the rear end of a section. Reflected at a joint: the energy that the far end of the section reflects of the waves from the hammer, as a share of the hammer energy.</source>
        <translation>Orte zählen vom hinteren Ende eines Abschnitts. Die Reflexion ist der Anteil der Energie des Hammers, den die Verbindung am gesteinsseitigen Ende des Abschnitts von dem reflektiert, was vom Hammer kommt.</translation>
    </message>
    <message>
        <source>Required feed force</source>
        <translation>Bedarfe an Andruck</translation>
    </message>
    <message>
        <source>All gaps between bit and rock</source>
        <translation>Alle Spalte zwischen Krone und Gestein</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>`drill`</source>
        <translation>`drill`</translation>
    </message>
    <message>
        <source>the page &quot;Drilling&quot;</source>
        <translation>die Seite „Bohren“</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>closed_form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>The rest of the scenario is in the file attached to the PDF.</source>
        <translation>Der Rest des Szenarios steht in der Datei, die dem PDF angehängt ist.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Untitled scenario</source>
        <translation>Szenario ohne Titel</translation>
    </message>
    <message>
        <source>%1 % of%2</source>
        <translation>%1&#xa0;% von%2</translation>
    </message>
    <message>
        <source>in %1, at its rear end, at %2</source>
        <translation>in %1, am hammerseitigen Ende, bei %2</translation>
    </message>
    <message>
        <source>in %1, %2 from its rear end, at %3</source>
        <translation>in %1, %2 vom hammerseitigen Ende, bei %3</translation>
    </message>
    <message>
        <source>stiffness k t₀/Z</source>
        <translation>Steifigkeit k t₀/Z</translation>
    </message>
    <message>
        <source>elasticity of the rock</source>
        <translation>Elastizität des Gesteins</translation>
    </message>
    <message>
        <source>transit time of the string over t₀</source>
        <translation>Laufzeit des Strangs durch t₀</translation>
    </message>
    <message>
        <source>gap d/d₀</source>
        <translation>Spalt d/d₀</translation>
    </message>
    <message>
        <source>duration of the blow</source>
        <translation>Dauer des Schlags</translation>
    </message>
    <message>
        <source>impulse of the blow</source>
        <translation>Kraftstoß des Schlags</translation>
    </message>
    <message>
        <source>energy I₀²/(2 m), m of the string</source>
        <translation>Energie I₀²/(2 m), m des Strangs</translation>
    </message>
    <message>
        <source>mean force I₀/t₀</source>
        <translation>mittlere Kraft I₀/t₀</translation>
    </message>
    <message>
        <source>its stress in the rod</source>
        <translation>ihre Spannung in der Stange</translation>
    </message>
    <message>
        <source>displacement 2 I₀/Z, Z of the rod</source>
        <translation>Verschiebung 2 I₀/Z, Z der Stange</translation>
    </message>
    <message>
        <source>twice the transit time of the hammer</source>
        <translation>doppelte Laufzeit des Hammers</translation>
    </message>
    <message>
        <source>momentum of the hammer</source>
        <translation>Impuls des Hammers</translation>
    </message>
    <message>
        <source>energy of the hammer</source>
        <translation>Energie des Hammers</translation>
    </message>
    <message>
        <source>force Z v₀/2, Z of the rod</source>
        <translation>Kraft Z v₀/2, Z der Stange</translation>
    </message>
    <message>
        <source>displacement v₀ t₀</source>
        <translation>Verschiebung v₀ t₀</translation>
    </message>
    <message>
        <source>mass of the hammer</source>
        <translation>Masse des Hammers</translation>
    </message>
    <message>
        <source>length of the hammer</source>
        <translation>Länge des Hammers</translation>
    </message>
    <message>
        <source>mass of the string</source>
        <translation>Masse des Strangs</translation>
    </message>
    <message>
        <source>length of the string</source>
        <translation>Länge des Strangs</translation>
    </message>
    <message>
        <source>at x/L = %1, t = %2 t₀</source>
        <translation>bei x/L = %1, t = %2 t₀</translation>
    </message>
    <message>
        <source>%1 from the hammer, at %2</source>
        <translation>%1 vom Hammer, bei %2</translation>
    </message>
    <message>
        <source>stiffness k/k₀, k₀ = Z/t₀</source>
        <translation>Steifigkeit k/k₀, k₀ = Z/t₀</translation>
    </message>
    <message>
        <source>transit time T/t₀</source>
        <translation>Laufzeit T/t₀</translation>
    </message>
    <message>
        <source>gap d/d₀, d₀ = 2 I₀/Z</source>
        <translation>Spalt d/d₀, d₀ = 2 I₀/Z</translation>
    </message>
    <message>
        <source>its stress</source>
        <translation>ihre Spannung</translation>
    </message>
    <message>
        <source>displacement 2 I₀/Z</source>
        <translation>Verschiebung 2 I₀/Z</translation>
    </message>
    <message>
        <source>energy I₀²/(2 m)</source>
        <translation>Energie I₀²/(2 m)</translation>
    </message>
    <message>
        <source>transit time L/c</source>
        <translation>Laufzeit L/c</translation>
    </message>
    <message>
        <source>wave speed √(E/ρ)</source>
        <translation>Wellengeschwindigkeit √(E/ρ)</translation>
    </message>
    <message>
        <source>mass of the rod</source>
        <translation>Masse der Stange</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1 bei %2, %3</translation>
    </message>
    <message>
        <source>in the rock</source>
        <translation>im Gestein</translation>
    </message>
    <message>
        <source>hammer moving back</source>
        <translation>zurücklaufender Hammer</translation>
    </message>
    <message>
        <source>waves in the hammer</source>
        <translation>Wellen im Hammer</translation>
    </message>
    <message>
        <source>string moving back</source>
        <translation>zurücklaufender Strang</translation>
    </message>
    <message>
        <source>waves in the string</source>
        <translation>Wellen im Strang</translation>
    </message>
    <message>
        <source>lost in joints</source>
        <translation>verloren in Verbindungen</translation>
    </message>
    <message>
        <source>lost in sections</source>
        <translation>verloren in Abschnitten</translation>
    </message>
    <message>
        <source>between the faces</source>
        <translation>zwischen den Flächen</translation>
    </message>
    <message>
        <source>work of the force</source>
        <translation>Arbeit der Kraft</translation>
    </message>
    <message>
        <source>balance errors</source>
        <translation>Bilanzfehler</translation>
    </message>
    <message>
        <source>%1 of the momentum, %2 of the energy</source>
        <translation>%1 des Impulses, %2 der Energie</translation>
    </message>
    <message>
        <source>tension after</source>
        <translation>Zug danach</translation>
    </message>
    <message>
        <source>of yield</source>
        <translation>der Streckgrenze</translation>
    </message>
    <message>
        <source>of fatigue</source>
        <translation>der Dauerfestigkeit</translation>
    </message>
    <message>
        <source>joint reflects</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>gap at the blow</source>
        <translation>Spalt beim Schlag</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>in SI</source>
        <translation>in SI-Einheiten</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>muss größer als 0 sein</translation>
    </message>
    <message>
        <source>must be at least 0</source>
        <translation>darf nicht kleiner als 0 sein</translation>
    </message>
    <message>
        <source>must be in %1%2</source>
        <translation>muss in %1%2 liegen</translation>
    </message>
    <message>
        <source>must be greater than %1</source>
        <translation>muss größer als %1 sein</translation>
    </message>
    <message>
        <source>must be at least %1</source>
        <translation>muss mindestens %1 sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>cannot be stored: its values are at the limit of double precision, it reads back as %1</source>
        <translation>lässt sich nicht halten: die Werte, aus denen es folgt, liegen an der Grenze der doppelten Genauigkeit, zurückgelesen wird %1</translation>
    </message>
    <message>
        <source>in a larger one, double precision is too coarse to place a wave</source>
        <translation>bei größeren Werten sind Zahlen doppelter Genauigkeit zu grob, um eine Welle zu verorten</translation>
    </message>
    <message>
        <source>must not be a whole number: numbers are the places of sections</source>
        <translation>darf keine ganze Zahl sein: Zahlen sind die Nummern der Abschnitte</translation>
    </message>
    <message>
        <source>must not begin or end with a blank</source>
        <translation>darf nicht mit einem Leerzeichen beginnen oder enden</translation>
    </message>
    <message>
        <source>must have at most %1 bytes</source>
        <translation>darf höchstens %1 Byte haben</translation>
    </message>
    <message>
        <source>must be less than the diameter of %1</source>
        <translation>muss kleiner als der Durchmesser von %1 sein</translation>
    </message>
    <message>
        <source>must be larger than the bore of %1</source>
        <translation>muss größer als die Bohrung von %1 sein</translation>
    </message>
    <message>
        <source>must have at least one section</source>
        <translation>muss mindestens einen Abschnitt haben</translation>
    </message>
    <message>
        <source>each part must be one section, or a repeat of at least one</source>
        <translation>jeder Teil muss ein Abschnitt sein, oder eine Wiederholung von mindestens einem</translation>
    </message>
    <message>
        <source>only for a repeat</source>
        <translation>das hat nur eine Wiederholung</translation>
    </message>
    <message>
        <source>has %1 sections, its repeats written out; at most %2 are followed</source>
        <translation>hat %1 Abschnitte, Wiederholungen ausgeschrieben; höchstens %2 werden verfolgt</translation>
    </message>
    <message>
        <source>losses inside the hammer are not modelled: give them to sections of the string</source>
        <translation>Verluste im Hammer gehören nicht zum Modell: sie bei Abschnitten des Strangs angeben</translation>
    </message>
    <message>
        <source>is so narrow that its face only covers the bore of %1 of the section it strikes</source>
        <translation>ist so schmal, dass die Schlagfläche nur die Bohrung von %1 des getroffenen Abschnitts trifft</translation>
    </message>
    <message>
        <source>the values are too large or too small: impedance, transit time or mass overflows</source>
        <translation>die Werte sind so groß oder klein, dass Impedanz, Laufzeit oder Masse überlaufen</translation>
    </message>
    <message>
        <source>is missing: a law with corners needs at least one, as `bit_rock.corner.1.force` and `bit_rock.corner.1.slope`</source>
        <translation>fehlt: ein Gesetz mit Ecken braucht mindestens eine, als `bit_rock.corner.1.force` und `bit_rock.corner.1.slope`</translation>
    </message>
    <message>
        <source>has %1 corners, at most %2 are possible</source>
        <translation>hat %1 Ecken, höchstens %2 sind möglich</translation>
    </message>
    <message>
        <source>must be greater than the force of the corner before it, %1</source>
        <translation>muss größer als die Kraft der Ecke davor sein, %1</translation>
    </message>
    <message>
        <source>must be at most 1/gamma = %1, because loading steeper than unloading would create energy</source>
        <translation>darf höchstens 1/gamma = %1 sein: Belastung steiler als Entlastung würde Energie erzeugen</translation>
    </message>
    <message>
        <source>is missing: a corner has a force and a slope</source>
        <translation>fehlt: eine Ecke hat eine Kraft und eine Steigung</translation>
    </message>
    <message>
        <source>rise and fall together must not exceed 1, they are %1</source>
        <translation>Anstieg und Abfall dürfen zusammen nicht über 1 liegen, sie sind %1</translation>
    </message>
    <message>
        <source>is the reference case of a uniform rod (`drillwave: 1`); a drill string takes any other shape</source>
        <translation>ist der Referenzfall einer gleichförmigen Stange (`drillwave: 1`); ein Bohrstrang erlaubt jede andere Form</translation>
    </message>
    <message>
        <source>the hammer&apos;s impedance is %1 times the rod&apos;s, too many steps to follow; use the shape exponential, a rigid hammer</source>
        <translation>die Impedanz des Hammers ist das %1-Fache derjenigen der Stange, zu viele Stufen zum Verfolgen; die Form exponential nehmen, einen starren Hammer</translation>
    </message>
    <message>
        <source>with tau = %1 the bit meets the rock after %2 t0, too late for double precision to resolve one t0 (at most %3)%4</source>
        <translation>bei tau = %1 trifft die Bohrkrone das Gestein nach %2 t0, zu spät, als dass doppelte Genauigkeit sagen könnte, was in einem t0 geschieht (höchstens %3)%4</translation>
    </message>
    <message>
        <source>the values are too large or too small: the force or energy of the blow overflows</source>
        <translation>die Werte sind so groß oder klein, dass Kraft oder Energie des Schlags überlaufen</translation>
    </message>
    <message>
        <source>; it follows from the other values</source>
        <translation>; es folgt aus den anderen Werten</translation>
    </message>
    <message>
        <source>needs at least two points of time and force</source>
        <translation>braucht mindestens zwei Punkte aus Zeit und Kraft</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>hat mehr als %1 Punkte</translation>
    </message>
    <message>
        <source>point %1 must be finite numbers</source>
        <translation>Punkt %1 muss aus endlichen Zahlen bestehen</translation>
    </message>
    <message>
        <source>point %1 has a negative force, a hammer only pushes</source>
        <translation>Punkt %1 hat eine negative Kraft, ein Hammer drückt nur</translation>
    </message>
    <message>
        <source>point %1 must be later than the one before it</source>
        <translation>Punkt %1 muss später als der davor sein</translation>
    </message>
    <message>
        <source>must have a force greater than 0 somewhere</source>
        <translation>muss irgendwo eine Kraft größer als 0 haben</translation>
    </message>
    <message>
        <source>lasts too long</source>
        <translation>dauert zu lange</translation>
    </message>
    <message>
        <source>has no unit: write for example `%1 %2`; allowed units: %3</source>
        <translation>hat keine Einheit: zum Beispiel `%1 %2` schreiben; möglich sind: %3</translation>
    </message>
    <message>
        <source>a decimal comma is not read here: write a decimal point</source>
        <translation>ein Dezimalkomma wird hier nicht gelesen: einen Punkt schreiben</translation>
    </message>
    <message>
        <source>must be a plain number: remove %1</source>
        <translation>muss eine bloße Zahl sein, %1 ist zu viel</translation>
    </message>
    <message>
        <source>unit %1 is not known here; allowed units: %2</source>
        <translation>die Einheit %1 ist hier nicht bekannt; möglich sind: %2</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>ist keine Zahl</translation>
    </message>
    <message>
        <source>is too large or too small for a number of double precision</source>
        <translation>ist zu groß oder zu klein für eine Zahl doppelter Genauigkeit</translation>
    </message>
    <message>
        <source>must be a list of corners: `- {force: 90 kN, slope: 0.35}`</source>
        <translation>muss eine Liste von Ecken sein: `- {force: 90 kN, slope: 0.35}`</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>muss eines von %1 sein</translation>
    </message>
    <message>
        <source>is missing: write for example `corners: [{force: 90 kN, slope: 0.35}]`</source>
        <translation>fehlt: zum Beispiel `corners: [{force: 90 kN, slope: 0.35}]` schreiben</translation>
    </message>
    <message>
        <source>only for a law with corners; write `law: corners`</source>
        <translation>das hat nur ein Gesetz mit Ecken; `law: corners` schreiben</translation>
    </message>
    <message>
        <source>must be a list of presets, `- name: …`</source>
        <translation>muss eine Liste von Voreinstellungen sein, `- name: …`</translation>
    </message>
    <message>
        <source>each preset must begin with `name: …`</source>
        <translation>jede Voreinstellung muss mit `name: …` beginnen</translation>
    </message>
    <message>
        <source>must be text</source>
        <translation>muss Text sein</translation>
    </message>
    <message>
        <source>is the name of another preset too</source>
        <translation>ist auch der Name einer anderen Voreinstellung</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>the file must begin with `drillwave_presets: 1`</source>
        <translation>die Datei muss mit `drillwave_presets: 1` beginnen</translation>
    </message>
    <message>
        <source>is missing: the first line must be `drillwave_presets: 1`</source>
        <translation>fehlt: die erste Zeile muss `drillwave_presets: 1` sein</translation>
    </message>
    <message>
        <source>this program reads the format %1</source>
        <translation>dieses Programm liest das Format %1</translation>
    </message>
    <message>
        <source>the source %1</source>
        <translation>die Quelle %1</translation>
    </message>
    <message>
        <source>must be [value, source]; write `assumed` if there is no source</source>
        <translation>muss [Wert, Quelle] sein, die Quelle `assumed`, wo es keine gibt</translation>
    </message>
    <message>
        <source>must be a shape of a hammer blow that needs no table</source>
        <translation>muss eine Form des Hammerschlags sein, die keine Tabelle braucht</translation>
    </message>
    <message>
        <source>goes with a diameter, not with an area</source>
        <translation>gehört zu einem Durchmesser, nicht zu einem Querschnitt</translation>
    </message>
    <message>
        <source>and %1 more problems</source>
        <translation>und %1 weitere Fehler</translation>
    </message>
    <message>
        <source>only for a table; the shape is %1</source>
        <translation>das hat nur eine Tabelle, die Form ist %1</translation>
    </message>
    <message>
        <source>each point must be [time, force], as in %1</source>
        <translation>jeder Punkt muss [Zeit, Kraft] sein, wie in %1</translation>
    </message>
    <message>
        <source>must be a list of [time, force]</source>
        <translation>muss eine Liste von [Zeit, Kraft] sein</translation>
    </message>
    <message>
        <source>must be the name of a CSV file</source>
        <translation>muss der Name einer CSV-Datei sein</translation>
    </message>
    <message>
        <source>%1 (needs a unit in brackets, one of %2)</source>
        <translation>%1 (braucht eine Einheit in eckigen Klammern, eine von %2)</translation>
    </message>
    <message>
        <source>%1 (must have no unit in a dimensionless scenario)</source>
        <translation>%1 (darf in einem dimensionslosen Szenario keine Einheit haben)</translation>
    </message>
    <message>
        <source>the header must be %1</source>
        <translation>der Kopf muss %1 sein</translation>
    </message>
    <message>
        <source>the pulse table %1</source>
        <translation>die Tabelle des Schlags %1</translation>
    </message>
    <message>
        <source>the scenario file %1</source>
        <translation>die Szenariodatei %1</translation>
    </message>
    <message>
        <source>the scenario is larger than 1 MiB</source>
        <translation>das Szenario ist größer als 1 MiB</translation>
    </message>
    <message>
        <source>the scenario is larger than 1 MiB, the limit for files; keep the points of a table in a CSV file</source>
        <translation>das Szenario ist größer als 1 MiB, mehr, als eine Datei haben darf; die Punkte einer Tabelle in einer CSV-Datei ablegen</translation>
    </message>
    <message>
        <source>is missing: the first line must be `drillwave: %1`</source>
        <translation>fehlt: die erste Zeile muss `drillwave: %1` sein</translation>
    </message>
    <message>
        <source>must be the first key of the file</source>
        <translation>muss der erste Schlüssel der Datei sein</translation>
    </message>
    <message>
        <source>this file says drillwave: %1; this program reads up to %2, use a newer one</source>
        <translation>in dieser Datei steht drillwave: %1; dieses Programm liest bis %2, ein neueres nehmen</translation>
    </message>
    <message>
        <source>the format number must be %1 for a uniform rod or %2 for a drill string</source>
        <translation>die Formatnummer muss %1 für eine gleichförmige Stange oder %2 für einen Bohrstrang sein</translation>
    </message>
    <message>
        <source>belongs to a drill string: a file that has it begins with `drillwave: 2`</source>
        <translation>gehört zu einem Bohrstrang: eine Datei, die es hat, beginnt mit `drillwave: 2`</translation>
    </message>
    <message>
        <source>belongs to a uniform rod: a file that has it begins with `drillwave: 1`; a drill string has `string` instead of `rod`, and `hammer` or `pulse`</source>
        <translation>gehört zu einer gleichförmigen Stange: eine Datei, die es hat, beginnt mit `drillwave: 1`; ein Bohrstrang hat `string` anstelle von `rod`, und `hammer` oder `pulse`</translation>
    </message>
    <message>
        <source>cannot be combined with `dimensionless`: give one or the other</source>
        <translation>kann nicht neben `dimensionless` stehen: das eine oder das andere angeben</translation>
    </message>
    <message>
        <source>the file must be lines of `key: value`, the first `drillwave: 1`</source>
        <translation>die Datei muss aus Zeilen `key: value` bestehen, die erste `drillwave: 1`</translation>
    </message>
    <message>
        <source>must be a list of sections: `- {length: 300 mm, diameter: 50 mm}`</source>
        <translation>muss eine Liste von Abschnitten sein: `- {length: 300 mm, diameter: 50 mm}`</translation>
    </message>
    <message>
        <source>: write for example `%1`</source>
        <translation>: zum Beispiel `%1` schreiben</translation>
    </message>
    <message>
        <source>is not a known key; known here: %1</source>
        <translation>ist kein bekannter Schlüssel; bekannt sind hier: %1</translation>
    </message>
    <message>
        <source>is not a known key, did you mean `%1`?</source>
        <translation>ist kein bekannter Schlüssel, war `%1` gemeint?</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>ist zweimal angegeben</translation>
    </message>
    <message>
        <source>must be a section of `key: value` lines</source>
        <translation>muss ein Block aus Zeilen `key: value` sein</translation>
    </message>
    <message>
        <source>has no value%1</source>
        <translation>hat keinen Wert%1</translation>
    </message>
    <message>
        <source>must be one value%1</source>
        <translation>muss ein Wert sein%1</translation>
    </message>
    <message>
        <source>is missing, one of %1</source>
        <translation>fehlt, eines von %1</translation>
    </message>
    <message>
        <source>is missing%1</source>
        <translation>fehlt%1</translation>
    </message>
    <message>
        <source>is missing: give it or %1</source>
        <translation>fehlt: dies oder %1 angeben</translation>
    </message>
    <message>
        <source>cannot be combined with %1: give one or the other</source>
        <translation>kann nicht neben %1 stehen: das eine oder das andere angeben</translation>
    </message>
    <message>
        <source>must be a list of sections: `- {name: rod, length: 3660 mm, diameter: 39 mm}`</source>
        <translation>muss eine Liste von Abschnitten sein: `- {name: rod, length: 3660 mm, diameter: 39 mm}`</translation>
    </message>
    <message>
        <source>must be a section: `{length: 300 mm, diameter: 50 mm}`</source>
        <translation>muss ein Abschnitt sein: `{length: 300 mm, diameter: 50 mm}`</translation>
    </message>
    <message>
        <source>is empty; leave it out for a section without a name</source>
        <translation>ist leer; ein Abschnitt ohne Namen wird ohne ihn geschrieben</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>hat keinen Wert</translation>
    </message>
    <message>
        <source>must be one value</source>
        <translation>muss ein Wert sein</translation>
    </message>
    <message>
        <source>is missing: write for example `length: 3660 mm`</source>
        <translation>fehlt: zum Beispiel `length: 3660 mm` schreiben</translation>
    </message>
    <message>
        <source>goes with an area, not with a diameter</source>
        <translation>gehört zu einem Querschnitt, nicht zu einem Durchmesser</translation>
    </message>
    <message>
        <source>a hammer has no repeats; write its sections out</source>
        <translation>ein Hammer hat keine Wiederholungen; seine Abschnitte ausschreiben</translation>
    </message>
    <message>
        <source>a repeat cannot contain another one</source>
        <translation>eine Wiederholung kann nicht in einer anderen stehen</translation>
    </message>
    <message>
        <source>has more than %1 sections, its repeats written out</source>
        <translation>hat mehr als %1 Abschnitte, Wiederholungen ausgeschrieben</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>must be a section, `{name: rod, length: 3660 mm, diameter: 39 mm}`, or `{repeat: 3, of: […]}`</source>
        <translation>muss ein Abschnitt sein, `{name: rod, length: 3660 mm, diameter: 39 mm}`, oder `{repeat: 3, of: […]}`</translation>
    </message>
    <message>
        <source>is missing: give the list of the sections to repeat</source>
        <translation>fehlt: die Liste der Abschnitte, die wiederkommen</translation>
    </message>
    <message>
        <source>must be a list of at least one section</source>
        <translation>muss eine Liste mit mindestens einem Abschnitt sein</translation>
    </message>
    <message>
        <source>is missing: write for example `repeat: 3`</source>
        <translation>fehlt: zum Beispiel `repeat: 3` schreiben</translation>
    </message>
    <message>
        <source>cannot be combined with `hammer`: keep one, a hammer of sections or a force instead of it</source>
        <translation>steht neben `hammer`: eines behalten, einen Hammer aus Abschnitten oder eine Kraft an seiner Stelle</translation>
    </message>
    <message>
        <source>only for drill strings (`drillwave: 2`); this is a uniform rod</source>
        <translation>das hat nur ein Bohrstrang (`drillwave: 2`), dies ist eine gleichförmige Stange</translation>
    </message>
    <message>
        <source>only for uniform rods (`drillwave: 1`); this is a drill string</source>
        <translation>das hat nur eine gleichförmige Stange (`drillwave: 1`), dies ist ein Bohrstrang</translation>
    </message>
    <message>
        <source>only for a force instead of the hammer (`pulse`); this string is struck by a hammer</source>
        <translation>das hat nur eine Kraft anstelle des Hammers (`pulse`), diesen Strang schlägt ein Hammer</translation>
    </message>
    <message>
        <source>only for a hammer of sections (`hammer`); this string is driven by a force (`pulse`)</source>
        <translation>das hat nur ein Hammer aus Abschnitten (`hammer`), diesen Strang treibt eine Kraft (`pulse`)</translation>
    </message>
    <message>
        <source>the scenario is given by its dimensionless groups</source>
        <translation>das Szenario ist durch seine dimensionslosen Kennzahlen gegeben</translation>
    </message>
    <message>
        <source>the scenario is given by its dimensionless groups; set `%1` instead</source>
        <translation>das Szenario ist durch seine dimensionslosen Kennzahlen gegeben; stattdessen `%1` setzen</translation>
    </message>
    <message>
        <source>follows from the lengths of hammer and string; set those, as `string.1.length`</source>
        <translation>folgt aus den Längen von Hammer und Strang; diese setzen, wie `string.1.length`</translation>
    </message>
    <message>
        <source>%1; set its sections, as `string.1.length`</source>
        <translation>%1; seine Abschnitte setzen, wie `string.1.length`</translation>
    </message>
    <message>
        <source>only for %1; set `%2=%3` too</source>
        <translation>das hat nur %1; auch `%2=%3` setzen</translation>
    </message>
    <message>
        <source>needs a unit, because this scenario has physical units</source>
        <translation>braucht eine Einheit, da dieses Szenario in physikalischen Größen ist</translation>
    </message>
    <message>
        <source>has no unit in a dimensionless scenario</source>
        <translation>hat in einem dimensionslosen Szenario keine Einheit</translation>
    </message>
    <message>
        <source>only for a trapezoid; the shape is %1</source>
        <translation>das hat nur ein Trapez, die Form ist %1</translation>
    </message>
    <message>
        <source>follows from the diameters and materials of hammer and rod</source>
        <translation>folgt aus den Durchmessern und Werkstoffen von Hammer und Stange</translation>
    </message>
    <message>
        <source>only for a piston; the shape is %1</source>
        <translation>das hat nur ein Kolben, die Form ist %1</translation>
    </message>
    <message>
        <source>the rod is given by its area; set `rod.area` or `rod.diameter`</source>
        <translation>die Stange ist durch ihren Querschnitt gegeben; `rod.area` oder `rod.diameter` setzen</translation>
    </message>
    <message>
        <source>follows from the data of the %1</source>
        <translation>folgt aus den Daten von %1</translation>
    </message>
    <message>
        <source>a carriage return without a line feed</source>
        <translation>einen Wagenrücklauf ohne Zeilenvorschub</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>ein NUL-Byte</translation>
    </message>
    <message>
        <source>a control character</source>
        <translation>ein Steuerzeichen</translation>
    </message>
    <message>
        <source>a byte that is not UTF-8</source>
        <translation>ein Byte, das kein UTF-8 ist</translation>
    </message>
    <message>
        <source>is not a text file: it holds %1</source>
        <translation>ist keine Textdatei: sie enthält %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>more than %1 levels of nesting are not accepted</source>
        <translation>mehr als %1 Ebenen der Verschachtelung werden nicht angenommen</translation>
    </message>
    <message>
        <source>an alias (*) is not accepted here: write the value itself</source>
        <translation>ein Alias (*) wird hier nicht angenommen: den Wert selbst schreiben</translation>
    </message>
    <message>
        <source>an anchor (&amp;) is not accepted here: write the value itself</source>
        <translation>ein Anker (&amp;) wird hier nicht angenommen: den Wert selbst schreiben</translation>
    </message>
    <message>
        <source>a tag (!) is not accepted here: write only the value</source>
        <translation>ein Tag (!) wird hier nicht angenommen: den Wert allein schreiben</translation>
    </message>
    <message>
        <source>not YAML: the quote that begins here is not closed</source>
        <translation>kein YAML: das Anführungszeichen, das hier beginnt, ist nicht geschlossen</translation>
    </message>
    <message>
        <source>there are too many values from here on</source>
        <translation>ab hier sind es zu viele Werte</translation>
    </message>
    <message>
        <source>not YAML: %1</source>
        <translation>kein YAML: %1</translation>
    </message>
    <message>
        <source>The force is no longer prescribed: reflected waves can separate the hammer from the rod.</source>
        <translation>Der Schlag ist keine vorgegebene Kraft mehr: Wellen, die zum Hammer zurückkommen, während er noch drückt, trennen ihn von der Stange.</translation>
    </message>
    <message>
        <source>%1 of %2 sections have another impedance (couplings, adapter, bit): they became rod, which reflects nothing.</source>
        <translation>%1 von %2 Abschnitten haben eine andere Impedanz (Kupplungsmuffen, Einsteckende, Bohrkrone): sie sind zu Stange geworden, die nichts zurückwirft.</translation>
    </message>
    <message>
        <source>The lumped masses, that of the bit among them.</source>
        <translation>Die Punktmassen, darunter die der Bohrkrone.</translation>
    </message>
    <message>
        <source>The losses in joints and along the rods.</source>
        <translation>Die Verluste in Verbindungen und entlang der Stangen.</translation>
    </message>
    <message>
        <source>The steps of the hammer: it became uniform, with the same mass, velocity and travel time of waves.</source>
        <translation>Die Stufen des Hammers: er ist gleichförmig geworden, mit derselben Masse, Geschwindigkeit und Wellenlaufzeit.</translation>
    </message>
    <message>
        <source>The elastic face of the hammer: it is rigid.</source>
        <translation>Die elastische Schlagfläche des Hammers: sie ist starr.</translation>
    </message>
    <message>
        <source>After separation the hammer is withdrawn: it does not strike again.</source>
        <translation>Der Hammer wird nach der Trennung nicht noch einmal getroffen: er ist zurückgezogen.</translation>
    </message>
    <message>
        <source>it is a drill string already</source>
        <translation>es ist schon ein Bohrstrang</translation>
    </message>
    <message>
        <source>a drill string has physical units, and this scenario has none</source>
        <translation>ein Bohrstrang hat physikalische Einheiten, und dieses Szenario hat keine</translation>
    </message>
    <message>
        <source>the reference case of a rod that arrives without waves has no hammer</source>
        <translation>der Referenzfall einer Stange, die ohne Wellen ankommt, hat keinen Hammer</translation>
    </message>
    <message>
        <source>Waves reflected to the hammer are left out: the force is that of the hammer on an endless rod.</source>
        <translation>Was zum Hammer zurückkommt: die Kraft ist die des Hammers auf eine Stange ohne Ende.</translation>
    </message>
    <message>
        <source>The time until which the blow is followed.</source>
        <translation>Die Zeit, bis zu der der Schlag verfolgt wird.</translation>
    </message>
    <message>
        <source>such a blow has too many waves to keep</source>
        <translation>die Wellen eines solchen Schlags sind zu viele, um sie zu behalten</translation>
    </message>
    <message>
        <source>some output has no value</source>
        <translation>es hat zu einem der Ergebnisse keine Zahl</translation>
    </message>
    <message>
        <source>it has too many waves to keep</source>
        <translation>seine Wellen sind mehr, als behalten werden können</translation>
    </message>
    <message>
        <source>the hammer pushes longer than the reflections that are computed</source>
        <translation>der Hammer drückt noch, wenn seine Welle öfter zurückgekehrt ist, als verfolgt wird</translation>
    </message>
    <message>
        <source>it has no such output</source>
        <translation>es hat kein solches Ergebnis</translation>
    </message>
    <message>
        <source>the damper, or the face of the hammer, is too stiff for the time step</source>
        <translation>der Dämpfer oder die Schlagfläche des Hammers ist zu steif für die Zellen der Rechnung</translation>
    </message>
    <message>
        <source>the contact of damper or hammer with the rear end changes without end</source>
        <translation>der Dämpfer oder der Hammer trifft und verlässt das hintere Ende unaufhörlich</translation>
    </message>
    <message>
        <source>an event at the rear end cannot be placed</source>
        <translation>ein Ereignis am hinteren Ende lässt sich nicht verorten</translation>
    </message>
    <message>
        <source>the wave force overflowed</source>
        <translation>die Wellenkraft ist übergelaufen</translation>
    </message>
    <message>
        <source>its energies do not balance, so that its numbers are wrong</source>
        <translation>die Energien gehen nicht auf, so dass die Zahlen falsch sind</translation>
    </message>
    <message>
        <source>its error would be larger than permitted</source>
        <translation>der Fehler wäre größer als erlaubt</translation>
    </message>
    <message>
        <source>the order of two events hangs on rounding</source>
        <translation>die Reihenfolge zweier Ereignisse hängt an der Rundung</translation>
    </message>
    <message>
        <source>its numbers are beyond the range of double precision</source>
        <translation>die Zahlen liegen jenseits der doppelten Genauigkeit</translation>
    </message>
    <message>
        <source>an event at the rock cannot be placed</source>
        <translation>ein Ereignis am Gestein lässt sich nicht verorten</translation>
    </message>
    <message>
        <source>bit and rock change contact, or a small bit mass oscillates, faster than can be computed</source>
        <translation>Bohrkrone und Gestein treffen und trennen sich schneller, als verfolgt werden kann, oder eine kleine Masse der Bohrkrone schwingt zu schnell</translation>
    </message>
    <message>
        <source>the contact of hammer and string changes without end</source>
        <translation>die Schlagflächen von Hammer und Strang treffen und trennen sich unaufhörlich</translation>
    </message>
    <message>
        <source>a contact of hammer and string cannot be placed</source>
        <translation>ein Kontakt von Hammer und Strang lässt sich nicht verorten</translation>
    </message>
    <message>
        <source>contacts change too often, or a bit mass oscillates too fast: try softer rock, a larger gamma, no bit mass or a shorter end_time</source>
        <translation>Bohrkrone und Gestein, oder Hammer und Strang, treffen und trennen sich zu oft, oder eine Masse der Bohrkrone schwingt zu schnell, um verfolgt zu werden: ein weicheres Gestein, ein größeres gamma, keine Masse der Bohrkrone oder eine frühere end_time braucht weniger</translation>
    </message>
    <message>
        <source>polynomial cells need a force or a hammer; this rod arrives without waves</source>
        <translation>eine Stange, die sich als Ganzes auf das Gestein zubewegt, ist nichts für polynomiale Zellen, die eine Kraft oder einen Hammer verfolgen</translation>
    </message>
    <message>
        <source>losses inside the hammer are not modelled: give loss and attenuation only to the string</source>
        <translation>Verluste im Hammer gehören nicht zum Modell: loss und attenuation nur beim Strang angeben</translation>
    </message>
    <message>
        <source>the bit mass oscillates too fast on this rock: leave it out (it is too small to matter), or give a softer rock</source>
        <translation>die Masse der Bohrkrone schwingt auf diesem Gestein zu schnell, um verfolgt zu werden: sie weglassen, sie ist zu klein, um etwas auszumachen, oder ein weicheres Gestein angeben</translation>
    </message>
    <message>
        <source>a hammer that strikes, several sections, masses and losses are not for this method, which follows a force on a uniform rod</source>
        <translation>ein Hammer, der schlägt, mehrere Abschnitte, Massen und Verluste sind nichts für dieses Verfahren, das eine Kraft auf eine gleichförmige Stange verfolgt</translation>
    </message>
    <message>
        <source>is given %1 times; keep one of them</source>
        <translation>ist %1-mal angegeben; eines davon behalten</translation>
    </message>
    <message>
        <source>ends in .csv and holds no scenario; only CSV files of run, gap, thrust and accuracy do (for a sweep or table it is in the .yaml file beside it)</source>
        <translation>gilt als Ergebnis, da der Name auf .csv endet, und enthält kein Szenario; nur die CSV-Dateien von run, gap, thrust und accuracy beginnen mit einem (sweep und table haben es in der .yaml daneben)</translation>
    </message>
    <message>
        <source>is a web page and holds no scenario; only the HTML files of `drillwave report` begin with one</source>
        <translation>ist eine Webseite und enthält kein Szenario; nur die HTML-Dateien von `drillwave report` beginnen mit einem</translation>
    </message>
    <message>
        <source>is larger than 4 MiB, the limit for this kind of file</source>
        <translation>ist größer als 4 MiB, das ist kaum beabsichtigt</translation>
    </message>
    <message>
        <source>ends in .json and holds no `scenario`; give the scenario file</source>
        <translation>gilt als Ergebnis, da der Name auf .json endet, und enthält kein `scenario`; die Szenariodatei angeben</translation>
    </message>
    <message>
        <source>the scenario file is larger than 1024 KiB, the limit for scenario files</source>
        <translation>die Szenariodatei ist größer als 1024 KiB, das ist kaum beabsichtigt</translation>
    </message>
    <message>
        <source>holds no scenario of a result</source>
        <translation>enthält kein Szenario eines Ergebnisses</translation>
    </message>
    <message>
        <source>the reflections overlap, which the closed form neglects: the contact is not over when the third wave arrives; use the exact method or the lattice</source>
        <translation>die Reflexionen überlappen, was die geschlossene Form vernachlässigt: der Kontakt ist nicht vorbei, wenn die dritte Welle ankommt; das exakte Verfahren oder das Gitter nehmen</translation>
    </message>
    <message>
        <source>the momentum after a separation is zero within rounding: it cannot be decided whether the rod returns</source>
        <translation>der Impuls nach einer Trennung ist innerhalb der Rundung null: ob die Stange zurückkehrt, ist unentschieden</translation>
    </message>
    <message>
        <source>the lattice needs more than the permitted number of steps; use fewer segments or the exact method</source>
        <translation>das Gitter braucht mehr Schritte als erlaubt; weniger Segmente oder das exakte Verfahren nehmen</translation>
    </message>
    <message>
        <source>the lattice found more than the permitted number of events; use the exact method</source>
        <translation>das Gitter fand mehr Ereignisse als erlaubt; das exakte Verfahren nehmen</translation>
    </message>
    <message>
        <source>lattices with other step lengths have no solution, so the error cannot be estimated; use more segments or the exact method</source>
        <translation>Gitter anderer Schrittlängen finden keine Lösung, so dass sich der Fehler nicht schätzen lässt; mehr Segmente oder das exakte Verfahren nehmen</translation>
    </message>
    <message>
        <source>%1; joining needs the records written with the parts</source>
        <translation>%1; Teile werden anhand der .yaml zusammengefügt, die mit ihnen geschrieben wurden</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>is not a record of rows</source>
        <translation>beschreibt keine Zeilen</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>is of another format than %1, from a newer program</source>
        <translation>hat ein anderes Format als %1, von einem neueren Programm</translation>
    </message>
    <message>
        <source>has no command</source>
        <translation>nennt keinen Befehl</translation>
    </message>
    <message>
        <source>part: %1 is no part I/N</source>
        <translation>part: %1 ist kein Teil I/N</translation>
    </message>
    <message>
        <source>%1: is %2, as %3 is; give each part once</source>
        <translation>%1: ist %2, wie auch %3; jeden Teil nur einmal angeben</translation>
    </message>
    <message>
        <source>part %1 of %2 is missing; run it, or name its file</source>
        <translation>Teil %1 von %2 fehlt; Fehlendes rechnen oder angeben</translation>
    </message>
    <message>
        <source>parts %1 of %2 are missing; run them, or name their files</source>
        <translation>Teile %1 von %2 fehlen; Fehlendes rechnen oder angeben</translation>
    </message>
    <message>
        <source>%1: has %2 rows, but %3 of all %4 has %5; it belongs to another run</source>
        <translation>%1: hat %2 Zeilen, %3 aber müsste %5 von insgesamt %4 haben; die Datei stammt aus einem anderen Lauf</translation>
    </message>
    <message>
        <source>a dimensionless scenario has no drill; give the rod and the drill in units</source>
        <translation>ein dimensionsloses Szenario hat keine Maschine; Stange und Maschine mit Einheiten angeben</translation>
    </message>
    <message>
        <source>is missing: many blows require it</source>
        <translation>fehlt: für viele Schläge ist es nötig</translation>
    </message>
    <message>
        <source>the reference case rigid_body is one impact and has no blows</source>
        <translation>der Referenzfall rigid_body ist ein einziger Stoß und hat keine Schläge</translation>
    </message>
    <message>
        <source>needs drill.machine_mass, which the damper carries</source>
        <translation>braucht drill.machine_mass, die der Dämpfer trägt</translation>
    </message>
    <message>
        <source>%1 must be less than the blows, which are %2</source>
        <translation>%1 muss kleiner als die Anzahl der Schläge (%2) sein</translation>
    </message>
    <message>
        <source>a blow lasts %1 s, not less than the interval of the blows; lower the frequency or shorten the blow</source>
        <translation>ein Schlag dauert %1 s und damit nicht kürzer als der Schlagabstand; die Frequenz senken oder den Schlag verkürzen</translation>
    </message>
    <message>
        <source>waves take longer from hammer to bit than from blow to blow (%1 round trips); lower the frequency or make the string shorter</source>
        <translation>Wellen brauchen vom Hammer zur Bohrkrone länger als von einem Schlag zum nächsten (%1 Hin- und Rückläufe); die Frequenz senken oder den Strang kürzen</translation>
    </message>
    <message>
        <source>must be %1 or %2</source>
        <translation>muss %1 oder %2 sein</translation>
    </message>
    <message>
        <source>only for uniform rods (`drillwave: 1`)</source>
        <translation>das hat nur eine gleichförmige Stange (`drillwave: 1`)</translation>
    </message>
    <message>
        <source>only for drill strings (`drillwave: 2`)</source>
        <translation>das hat nur ein Bohrstrang (`drillwave: 2`)</translation>
    </message>
    <message>
        <source>only for a hammer of sections (`hammer`); this string is driven by a force</source>
        <translation>das hat nur ein Hammer aus Abschnitten (`hammer`), diesen Strang treibt eine Kraft</translation>
    </message>
    <message>
        <source>only for faces with a stiffness (`hammer.face_stiffness`)</source>
        <translation>das haben nur Schlagflächen mit einer Steifigkeit (`hammer.face_stiffness`)</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 Stücke</translation>
    </message>
    <message>
        <source>%1 of %2 segments</source>
        <translation>%1 mit %2 Segmenten</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>the feed force margin is known only for uniform rods (`drillwave: 1`)</source>
        <translation>die Reserve des Andrucks gibt es nur bei gleichförmigen Stangen (`drillwave: 1`)</translation>
    </message>
    <message>
        <source>the feed force margin needs drill.thrust; give it in the scenario or with --set</source>
        <translation>die Reserve des Andrucks braucht drill.thrust; im Szenario oder mit --set angeben</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is larger than the limit of %1 KiB</source>
        <translation>ist größer als %1 KiB, das ist kaum beabsichtigt</translation>
    </message>
    <message>
        <source>set the same thing</source>
        <translation>setzen dasselbe</translation>
    </message>
    <message>
        <source>`%1` is not a number; write it into the scenario file</source>
        <translation>`%1` ist keine Zahl; in die Szenariodatei schreiben</translation>
    </message>
    <message>
        <source>does not apply here: %1</source>
        <translation>hat hier keine Bedeutung: %1</translation>
    </message>
    <message>
        <source>`%1` is not a parameter</source>
        <translation>`%1` ist kein Parameter</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; did you mean `%2`?</source>
        <translation>`%1` ist kein Parameter; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>no section of the hammer is called `%1`; did you mean `%2`?</source>
        <translation>kein Abschnitt des Hammers heißt `%1`; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>no section of the string is called `%1`; did you mean `%2`?</source>
        <translation>kein Abschnitt des Strangs heißt `%1`; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>no section of the hammer is called `%1`; its names: %2</source>
        <translation>kein Abschnitt des Hammers heißt `%1`; die Namen sind: %2</translation>
    </message>
    <message>
        <source>no section of the string is called `%1`; its names: %2</source>
        <translation>kein Abschnitt des Strangs heißt `%1`; die Namen sind: %2</translation>
    </message>
    <message>
        <source>no section of the hammer is called `%1`; its sections have no names, give a place: `%2`</source>
        <translation>kein Abschnitt des Hammers heißt `%1`; seine Abschnitte haben keine Namen, eine Nummer angeben: `%2`</translation>
    </message>
    <message>
        <source>no section of the string is called `%1`; its sections have no names, give a place: `%2`</source>
        <translation>kein Abschnitt des Strangs heißt `%1`; seine Abschnitte haben keine Namen, eine Nummer angeben: `%2`</translation>
    </message>
    <message>
        <source>the hammer has only %1 section</source>
        <translation>der Hammer hat nur %1 Abschnitt</translation>
    </message>
    <message>
        <source>the hammer has only %1 sections</source>
        <translation>der Hammer hat nur %1 Abschnitte</translation>
    </message>
    <message>
        <source>the string has only %1 section</source>
        <translation>der Strang hat nur %1 Abschnitt</translation>
    </message>
    <message>
        <source>the string has only %1 sections</source>
        <translation>der Strang hat nur %1 Abschnitte</translation>
    </message>
    <message>
        <source>are the same section of a repeat</source>
        <translation>setzen denselben Abschnitt, der durch eine Wiederholung unter beiden Nummern vorkommt</translation>
    </message>
    <message>
        <source>set one section: section %1 of the hammer is called %2</source>
        <translation>setzen denselben Abschnitt: Abschnitt %1 des Hammers heißt %2</translation>
    </message>
    <message>
        <source>set one section: section %1 of the string is called %2</source>
        <translation>setzen denselben Abschnitt: Abschnitt %1 des Strangs heißt %2</translation>
    </message>
    <message>
        <source>the string has no repeat</source>
        <translation>der Strang hat keine Wiederholung</translation>
    </message>
    <message>
        <source>goes with an area, and the section is given by its diameter</source>
        <translation>gehört zu einem Querschnitt, und der Abschnitt ist durch seinen Durchmesser gegeben</translation>
    </message>
    <message>
        <source>goes with a diameter, and the section is given by its area</source>
        <translation>gehört zu einem Durchmesser, und der Abschnitt ist durch seinen Querschnitt gegeben</translation>
    </message>
    <message>
        <source>a dimensionless scenario has no drill</source>
        <translation>ein dimensionsloses Szenario hat keine Maschine</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>not solved: %1</source>
        <translation>nicht gelöst: %1</translation>
    </message>
    <message>
        <source>THE RING DOES NOT GIVE THE NUMBERS OF THE MOVED WAVES at %1 segments: please report this.</source>
        <translation>DER RINGPUFFER GIBT DIE ZAHLEN DER VERSCHOBENEN WELLEN NICHT WIEDER (%1 Segmente): bitte melden.</translation>
    </message>
    <message>
        <source>The ring buffer gives the same numbers as the moved waves, to the last bit.</source>
        <translation>Der Ringpuffer gibt jede Zahl der verschobenen Wellen bis zum letzten Bit genau wieder.</translation>
    </message>
    <message>
        <source>The table</source>
        <translation>Die Tabelle</translation>
    </message>
    <message>
        <source>Errors are absolute, forces in F0; lattice and closed form are compared with the exact solution.
estimate: error of e estimated by the method itself. order: observed, from the row above.
force: largest difference of the force history, at ends and middles of all steps; mid-step: at the
middles. A force that is constant in each step cannot be closer than half its change in a step.</source>
        <translation>Fehler sind absolut, Kräfte in F0; die von Gitter und geschlossener Form gegen die exakte Lösung.
Schätzung: was das Verfahren selbst zum Fehler von e sagt. Ordnung: beobachtet, zur Zeile darüber.
Kraft: größte Abweichung des Kraftverlaufs an Enden und Mitten aller Schritte; Schrittmitte: in
den Mitten. Eine je Schritt konstante Kraft weicht mindestens um ihre halbe Änderung je Schritt ab.</translation>
    </message>
    <message>
        <source>Times: processor time of a solve for e only. speed: how many times faster than the paper&apos;s choice,
the lattice of %1 segments with moved waves.</source>
        <translation>Zeiten: Rechenzeit einer Lösung nur für e. Tempo: wievielmal so schnell wie das Gitter der
Veröffentlichung, %1 Segmente mit verschobenen Wellen.</translation>
    </message>
    <message>
        <source>%1 Rows of over a second have fewer runs.</source>
        <translation>%1 Zeilen über einer Sekunde haben weniger Läufe.</translation>
    </message>
    <message>
        <source>It could not be solved in long double: %1.</source>
        <translation>In long double nicht gelöst: %1.</translation>
    </message>
    <message>
        <source>Its errors are differences from a solution in long double (%1 bits, %2),
whose own error is below %3 and included: they show
rounding and truncation, but not a wrong event, as both solutions share the code for events.</source>
        <translation>Ihre Fehler sind Differenzen zu einer Lösung in long double (%1 Bit, %2),
deren eigener Fehler unter %3 liegt und eingerechnet ist: sie zeigen Rundungs- und
Abbruchfehler, aber kein falsches Ereignis: beide rechnen Ereignisse mit demselben Code.</translation>
    </message>
    <message>
        <source>The exact solution</source>
        <translation>Die exakte Lösung</translation>
    </message>
    <message>
        <source>Therefore the histories were inserted into the equations at %1 points, without that code.
Largest residuals, in F0 (1 + beta/gamma):</source>
        <translation>Daher wurden ihre Verläufe an %1 Punkten in die Gleichungen eingesetzt, ohne diesen Code.
Größte Residuen, in F0 (1 + beta/gamma):</translation>
    </message>
    <message>
        <source>F&apos; = a (2g - F), a = beta or beta/gamma</source>
        <translation>F&apos; = a (2g - F), a = beta oder beta/gamma</translation>
    </message>
    <message>
        <source>F&apos; = a (2g - F), a = s_j beta on line j, or beta/gamma</source>
        <translation>F&apos; = a (2g - F), a = s_j beta auf Gerade j, oder beta/gamma</translation>
    </message>
    <message>
        <source>F = law of the penetration and of the largest one so far</source>
        <translation>F = Gesetz der Eindringung und der bisher größten</translation>
    </message>
    <message>
        <source>smallest force</source>
        <translation>kleinste Kraft</translation>
    </message>
    <message>
        <source>pulse %1</source>
        <translation>Schlagform %1</translation>
    </message>
    <message>
        <source>e = %1, peak force %2 F0</source>
        <translation>e = %1, Spitzenkraft %2 F0</translation>
    </message>
    <message>
        <source>Over the whole ladder the error of e falls with the number of segments to the power of %1.</source>
        <translation>Über alle Auflösungen fällt der Fehler von e mit der Anzahl der Segmente hoch %1.</translation>
    </message>
    <message>
        <source>error: error of the efficiency, against %1 (cut cells of half the length, error bound %2)
stated: error bound of the method; impulse: error of the impulse on the rock, over the hammer&apos;s
cells: polynomial cells, cut at jumps (sweep, map); cells_cut: cut at every corner of a wave (run);
plain: a lattice of constant cells, the usual method</source>
        <translation>Fehler: gegen den Wirkungsgrad %1 (geteilte Zellen, nochmals halb so groß, Fehler %2)
angegeben: laut Verfahren; Kraftstoß: Fehler des Kraftstoßes auf das Gestein durch den des Hammers
cells: polynomiale Zellen, an Sprüngen geteilt (sweep, map); cells_cut: an jeder Wellenecke (run);
plain: ein Gitter konstanter Zellen, wie bei anderen</translation>
    </message>
    <message>
        <source>and returned with the hammer</source>
        <translation>und was der Hammer zurücknimmt</translation>
    </message>
    <message>
        <source>work on the rock</source>
        <translation>Arbeit am Gestein</translation>
    </message>
    <message>
        <source>impulse 1 + e</source>
        <translation>Kraftstoß 1 + e</translation>
    </message>
    <message>
        <source>impulse on the rock</source>
        <translation>Kraftstoß auf das Gestein</translation>
    </message>
    <message>
        <source>%1 of the hammer&apos;s</source>
        <translation>das %1-Fache von dem des Hammers</translation>
    </message>
    <message>
        <source>restitution e of the string</source>
        <translation>Stoßzahl e des Strangs</translation>
    </message>
    <message>
        <source>peak force on the rock</source>
        <translation>Spitzenkraft auf das Gestein</translation>
    </message>
    <message>
        <source>largest penetration</source>
        <translation>größte Eindringung</translation>
    </message>
    <message>
        <source>residual penetration</source>
        <translation>bleibende Eindringung</translation>
    </message>
    <message>
        <source>largest compression</source>
        <translation>größter Druck</translation>
    </message>
    <message>
        <source>largest tension</source>
        <translation>größter Zug</translation>
    </message>
    <message>
        <source>compression after</source>
        <translation>Druck danach</translation>
    </message>
    <message>
        <source>percussion power</source>
        <translation>Schlagleistung</translation>
    </message>
    <message>
        <source>penetration rate</source>
        <translation>Bohrfortschritt</translation>
    </message>
    <message>
        <source>first contact</source>
        <translation>erster Kontakt</translation>
    </message>
    <message>
        <source>last separation</source>
        <translation>letzte Trennung</translation>
    </message>
    <message>
        <source>time in contact</source>
        <translation>Zeit in Kontakt</translation>
    </message>
    <message>
        <source>hammer separates</source>
        <translation>Hammer löst sich</translation>
    </message>
    <message>
        <source>hammer rebound</source>
        <translation>Hammerrückprall</translation>
    </message>
    <message>
        <source>away from the rock</source>
        <translation>vom Gestein weg</translation>
    </message>
    <message>
        <source>hammer work W</source>
        <translation>Hammerarbeit W</translation>
    </message>
    <message>
        <source>in the rebound</source>
        <translation>im Rückprall</translation>
    </message>
    <message>
        <source>in waves</source>
        <translation>in Wellen</translation>
    </message>
    <message>
        <source>%1 of the force&apos;s</source>
        <translation>das %1-Fache von dem der Kraft</translation>
    </message>
    <message>
        <source>%1, not met: short by %2 (%3)</source>
        <translation>%1, nicht erfüllt: es fehlen %2 (%3)</translation>
    </message>
    <message>
        <source>%1, met with %2 (%3) to spare</source>
        <translation>%1, erfüllt: %2 (%3) übrig</translation>
    </message>
    <message>
        <source>%1, installed %2</source>
        <translation>%1, installiert %2</translation>
    </message>
    <message>
        <source>%1, installed %2, effective %3</source>
        <translation>%1, installiert %2, wirksam %3</translation>
    </message>
    <message>
        <source>(error estimated as %1)</source>
        <translation>(Fehler geschätzt auf %1)</translation>
    </message>
    <message>
        <source>(error below %1)</source>
        <translation>(Fehler unter %1)</translation>
    </message>
    <message>
        <source>%1 of I0, %2 of W</source>
        <translation>%1 von I₀, %2 von W</translation>
    </message>
    <message>
        <source>method %1, %2, %3, solved in %4</source>
        <translation>Verfahren %1, %2, %3, gelöst in %4</translation>
    </message>
    <message>
        <source>%1 contact</source>
        <translation>%1 Kontakt</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 Kontakte</translation>
    </message>
    <message>
        <source>warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
    <message>
        <source>least</source>
        <translation>kleinster Wert</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>kink</source>
        <translation>Knick</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>rises above %1</source>
        <translation>steigt über %1</translation>
    </message>
    <message>
        <source>falls below %1</source>
        <translation>fällt unter %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>slope %1 to %2</source>
        <translation>Steigung von %1 auf %2</translation>
    </message>
    <message>
        <source>end of the range</source>
        <translation>Ende des Bereichs</translation>
    </message>
    <message>
        <source>between points</source>
        <translation>zwischen Punkten</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>and %1 more such stretches</source>
        <translation>weitere solche Teile des Bereichs: %1</translation>
    </message>
    <message>
        <source>Along %1 from %2 to %3, by its logarithm.</source>
        <translation>Entlang %1 von %2 bis %3, logarithmisch.</translation>
    </message>
    <message>
        <source>Along %1 from %2 to %3.</source>
        <translation>Entlang %1 von %2 bis %3.</translation>
    </message>
    <message>
        <source>and %1 more; --json has all</source>
        <translation>und %1 weitere; --json enthält alle</translation>
    </message>
    <message>
        <source>known only at grid points from %1 to %2: %3</source>
        <translation>nur an Gitterpunkten bekannt von %1 bis %2: %3</translation>
    </message>
    <message>
        <source>no answer from %1 to %2: %3</source>
        <translation>keine Antwort von %1 bis %2: %3</translation>
    </message>
    <message>
        <source>%1 blows solved in %2.</source>
        <translation>Aus %1 Schlägen in %2.</translation>
    </message>
    <message>
        <source>%1 draws of %2</source>
        <translation>%1 Ziehungen von %2</translation>
    </message>
    <message>
        <source>Uncertain: %1.</source>
        <translation>Unsicher: %1.</translation>
    </message>
    <message>
        <source>%1 (%2 values)</source>
        <translation>%1 (%2 Werte)</translation>
    </message>
    <message>
        <source>nothing, only the design of FILE</source>
        <translation>nichts, nur die Auslegung von FILE</translation>
    </message>
    <message>
        <source>Design variables: %1; every blow has the energy of FILE.</source>
        <translation>Zur Wahl: %1; jeder Schlag hat dieselbe Energie wie der von FILE.</translation>
    </message>
    <message>
        <source>Design variables: %1.</source>
        <translation>Zur Wahl: %1.</translation>
    </message>
    <message>
        <source>%1 design with %2 samples; +- is the 95 % error.</source>
        <translation>%1 Auslegung mit %2 Stichproben; +- ist der 95-%-Fehler.</translation>
    </message>
    <message>
        <source>%1 designs with %2 samples each, the same for all; +- is the 95 % error.</source>
        <translation>%1 Auslegungen mit je %2 Stichproben, für alle dieselben; +- ist der 95-%-Fehler.</translation>
    </message>
    <message>
        <source>design</source>
        <translation>Auslegung</translation>
    </message>
    <message>
        <source>%1 nominal</source>
        <translation>%1 nominal</translation>
    </message>
    <message>
        <source>marginal</source>
        <translation>grenzwertig</translation>
    </message>
    <message>
        <source>best for uncertain rock</source>
        <translation>beste, Gestein ungenau bekannt</translation>
    </message>
    <message>
        <source>best for the values entered</source>
        <translation>beste für eingegebene Werte</translation>
    </message>
    <message>
        <source>%1 instead of %2: %3 %4, with the values of FILE %5.</source>
        <translation>%1 anstelle von %2: %3 %4, wenn alles wie in FILE ist, %5.</translation>
    </message>
    <message>
        <source>no design is better in all aims</source>
        <translation>keine ist in allen Zielen besser</translation>
    </message>
    <message>
        <source>and %1 more: -o DIR writes them all.</source>
        <translation>und %1 weitere: -o DIR schreibt sie alle.</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>konstant</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>Ziehungen</translation>
    </message>
    <message>
        <source>acts with others</source>
        <translation>wirkt im Zusammenspiel</translation>
    </message>
    <message>
        <source>Worth measuring: share of the scatter, # by itself, - with others</source>
        <translation>Was sich zu messen lohnt: Anteil an der Streuung, # allein, - mit anderen</translation>
    </message>
    <message>
        <source>row %1 of the draws</source>
        <translation>Zeile %1 der Ziehungen</translation>
    </message>
    <message>
        <source>Smallest %1 of the best design within the ranges: %2 at %3 (samples only: %4; %5 searches, %6 of them ended here).</source>
        <translation>Kleinster in den Bereichen gefundener Wert (%1) der besten Auslegung für ungenau bekanntes Gestein: %2 bei %3 (nur aus Stichproben: %4; Suchen: %5, davon hier geendet: %6).</translation>
    </message>
    <message>
        <source>Largest %1 of the best design within the ranges: %2 at %3 (samples only: %4; %5 searches, %6 of them ended here).</source>
        <translation>Größter in den Bereichen gefundener Wert (%1) der besten Auslegung für ungenau bekanntes Gestein: %2 bei %3 (nur aus Stichproben: %4; Suchen: %5, davon hier geendet: %6).</translation>
    </message>
    <message>
        <source>%1 sample could not be solved and is left out of the statistics. Reason: %2.</source>
        <translation>%1 Stichprobe konnte nicht gelöst werden und fehlt in der Statistik. Grund: %2.</translation>
    </message>
    <message>
        <source>%1 samples could not be solved and are left out of the statistics. Reason: %2.</source>
        <translation>%1 Stichproben konnten nicht gelöst werden und fehlen in der Statistik. Grund: %2.</translation>
    </message>
    <message>
        <source>%1 design has no statistics, because more than 0.1 % of its samples could not be solved.</source>
        <translation>%1 Auslegung hat keine Statistik, weil mehr als 0,1&#xa0;% ihrer Stichproben nicht gelöst werden konnten.</translation>
    </message>
    <message>
        <source>%1 designs have no statistics, because more than 0.1 % of their samples could not be solved.</source>
        <translation>%1 Auslegungen haben keine Statistik, weil mehr als 0,1&#xa0;% ihrer Stichproben nicht gelöst werden konnten.</translation>
    </message>
    <message>
        <source>In up to %1 % of the samples of a design, the bit chatters on the rock. The numerical error of these blows is larger than the error of the statistics.</source>
        <translation>Bei bis zu %1&#xa0;% der Stichproben einer Auslegung rattert die Bohrkrone auf dem Gestein. Der numerische Fehler dieser Schläge ist größer als der Fehler der Statistik.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1 or %2 others</source>
        <translation>%1 oder %2 weitere</translation>
    </message>
    <message>
        <source>These designs are equally good within the error: %1. Use any of them.</source>
        <translation>Diese Auslegungen sind innerhalb des Fehlers gleich gut: %1. Jede davon ist recht.</translation>
    </message>
    <message>
        <source>These designs are equally good within the error: %1. Use any of them. Among them, the design %2 has the largest value of %3, %4.</source>
        <translation>Diese Auslegungen sind innerhalb des Fehlers gleich gut: %1. Jede davon ist recht. Unter ihnen hat die Auslegung %2 den größten Wert von %3, %4.</translation>
    </message>
    <message>
        <source>These designs are equally good within the error: %1. Use any of them. Among them, the design %2 has the smallest value of %3, %4.</source>
        <translation>Diese Auslegungen sind innerhalb des Fehlers gleich gut: %1. Jede davon ist recht. Unter ihnen hat die Auslegung %2 den kleinsten Wert von %3, %4.</translation>
    </message>
    <message>
        <source>The best design for uncertain rock lies at the upper end of the range of %1: extend that range.</source>
        <translation>Die beste Auslegung für ungenau bekanntes Gestein liegt am oberen Ende des Bereichs von %1: diesen Bereich erweitern.</translation>
    </message>
    <message>
        <source>The best design for uncertain rock lies at the lower end of the range of %1: extend that range.</source>
        <translation>Die beste Auslegung für ungenau bekanntes Gestein liegt am unteren Ende des Bereichs von %1: diesen Bereich erweitern.</translation>
    </message>
    <message>
        <source>The blow energy differs by up to %1 % between the designs: machines of different power are compared. Use --keep-energy to compare at the same energy.</source>
        <translation>Die Schlagenergie der Auslegungen unterscheidet sich um bis zu %1&#xa0;%: es werden Maschinen verschiedener Leistung verglichen. --keep-energy vergleicht bei gleicher Energie.</translation>
    </message>
    <message>
        <source>Nearly all scatter of the efficiency comes from the elasticity gamma of the rock. To compare hammers, choose the loading work as the objective: --aim max:loading_work@q05.</source>
        <translation>Der Wirkungsgrad streut fast nur mit der Elastizität gamma des Gesteins. Zum Vergleich von Hämmern die Belastungsarbeit als Zielgröße wählen: --aim max:loading_work@q05.</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>bouncing</source>
        <translation>Springen</translation>
    </message>
    <message>
        <source>period %1</source>
        <translation>Periode %1</translation>
    </message>
    <message>
        <source>irregular</source>
        <translation>unregelmäßig</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>%1 blows at each value</source>
        <translation>%1 Schläge bei jedem Wert</translation>
    </message>
    <message>
        <source>with %1, %2 blows at each value</source>
        <translation>mit %1, %2 Schläge bei jedem Wert</translation>
    </message>
    <message>
        <source>contact share</source>
        <translation>Kontaktanteil</translation>
    </message>
    <message>
        <source>balances</source>
        <translation>Bilanzen</translation>
    </message>
    <message>
        <source>%1 blows</source>
        <translation>%1 Schläge</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>rock impulse</source>
        <translation>Kraftstoß auf das Gestein</translation>
    </message>
    <message>
        <source>up to %1: an upper limit (all rock under the bit breaks, cuttings are removed)</source>
        <translation>bis %1: obere Grenze, alles Gestein unter der Krone gibt nach, Bohrklein verschwindet</translation>
    </message>
    <message>
        <source>%1 of the blows start within %2 of the rock</source>
        <translation>%1 der Schläge beginnen höchstens %2 vom Gestein entfernt</translation>
    </message>
    <message>
        <source>rock %1, damper %2, waves %3, new rock faces %4 of the energy from hammer and feed</source>
        <translation>Gestein %1, Dämpfer %2, Wellen %3, neue Gesteinsflächen %4 dessen, was Hammer und Vorschub bringen</translation>
    </message>
    <message>
        <source>momentum to %1, energy to %2</source>
        <translation>Impuls auf %1 genau, Energie auf %2 genau</translation>
    </message>
    <message>
        <source>phi = %1 (feed force over mean force of the blows), n_b = %2 round trips per blow</source>
        <translation>φ = %1 (Andruck durch mittlere Reaktion), %2 Hin- und Rückläufe je Schlag</translation>
    </message>
    <message>
        <source>The gap has a period of d0 = %1.</source>
        <translation>Der Spalt hat die Periode d₀ = %1.</translation>
    </message>
    <message>
        <source>The gap has a period of d0.</source>
        <translation>Der Spalt hat die Periode d₀.</translation>
    </message>
    <message>
        <source>%1 in %2.</source>
        <translation>%1 in %2.</translation>
    </message>
    <message>
        <source>rises through it</source>
        <translation>steigt darüber</translation>
    </message>
    <message>
        <source>falls through it</source>
        <translation>fällt darunter</translation>
    </message>
    <message>
        <source>turns round at it</source>
        <translation>kehrt dort um</translation>
    </message>
    <message>
        <source>is there at an end</source>
        <translation>an einem Ende erreicht</translation>
    </message>
    <message>
        <source>is it everywhere</source>
        <translation>überall erreicht</translation>
    </message>
    <message>
        <source>jumps over it</source>
        <translation>springt darüber</translation>
    </message>
    <message>
        <source>between points, from %1 to %2</source>
        <translation>zwischen Punkten, von %1 auf %2</translation>
    </message>
    <message>
        <source>where the output is known only at single points</source>
        <translation>wo das Ergebnis nur an einzelnen Punkten bekannt ist</translation>
    </message>
    <message>
        <source>where it has no answer</source>
        <translation>wo es keine Antwort gibt</translation>
    </message>
    <message>
        <source>where the output is known only at single points or has no value</source>
        <translation>wo das Ergebnis nur an einzelnen Punkten bekannt ist oder keinen Wert hat</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>no %1 gives %2</source>
        <translation>%1 ergibt nirgends %2</translation>
    </message>
    <message>
        <source>no %1 gives %2, which it jumps over at %3</source>
        <translation>%1 ergibt nirgends %2, was bei %3 übersprungen wird</translation>
    </message>
    <message>
        <source>%1: there is no answer anywhere</source>
        <translation>%1: nirgends gibt es eine Antwort</translation>
    </message>
    <message>
        <source>%1: the nearest is %2, at %3</source>
        <translation>%1: am nächsten kommt %2, bei %3</translation>
    </message>
    <message>
        <source>%1: the nearest is %2, at %3; there may be one %4</source>
        <translation>%1: am nächsten kommt %2, bei %3; eine Stelle kann es noch dort geben, %4</translation>
    </message>
    <message>
        <source>Goal: %1</source>
        <translation>Ziel: %1</translation>
    </message>
    <message>
        <source>None: %1.</source>
        <translation>Keine Stelle: %1.</translation>
    </message>
    <message>
        <source>There may be others %1.</source>
        <translation>Weitere kann es dort geben, %1.</translation>
    </message>
    <message>
        <source>There are no others from %1 to %2.</source>
        <translation>Weitere gibt es nicht von %1 bis %2.</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>nowhere between the points</source>
        <translation>nirgends zwischen den Punkten</translation>
    </message>
    <message>
        <source>%1 on %2, within %3</source>
        <translation>%1 auf %2, Abstand höchstens %3</translation>
    </message>
    <message>
        <source>%1 line</source>
        <translation>%1 Linie</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 Linien</translation>
    </message>
    <message>
        <source>%1, except %2 where it jumps across</source>
        <translation>%1, außer bei %2, wo das Ergebnis darüber springt</translation>
    </message>
    <message>
        <source>%1; %2 where the blows do not repeat: a mean scatters there, and the contour with it</source>
        <translation>%1; %2, wo sich die Schläge nicht wiederholen: dort streut ein Mittel, und die Höhenlinie mit ihm</translation>
    </message>
    <message>
        <source>%1; %2 crossing not placed: %3</source>
        <translation>%1; %2 Schnittpunkt nicht verortet: %3</translation>
    </message>
    <message>
        <source>%1; %2 crossings not placed: %3</source>
        <translation>%1; %2 Schnittpunkte nicht verortet: %3</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 Wert</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>%1 = %2 to %3, %4, log</source>
        <translation>%1 = %2 bis %3, %4, log</translation>
    </message>
    <message>
        <source>%1 = %2 to %3, %4</source>
        <translation>%1 = %2 bis %3, %4</translation>
    </message>
    <message>
        <source>%1 over %2; %3</source>
        <translation>%1 über %2; %3</translation>
    </message>
    <message>
        <source>%1 not solved: %2</source>
        <translation>%1 nicht gelöst: %2</translation>
    </message>
    <message>
        <source>%1 blow in %2.</source>
        <translation>%1 Schlag in %2.</translation>
    </message>
    <message>
        <source>%1 blows in %2.</source>
        <translation>%1 Schläge in %2.</translation>
    </message>
    <message>
        <source>slope %1 k from %2</source>
        <translation>Steigung %1 k ab %2</translation>
    </message>
    <message>
        <source>%1 k from %2</source>
        <translation>%1 k ab %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>rock: %1,</source>
        <translation>Gestein: %1,</translation>
    </message>
    <message>
        <source>was solved by method %1 (%2)</source>
        <translation>wurde mit dem Verfahren %1 gelöst (%2)</translation>
    </message>
    <message>
        <source>was solved by a lattice of `%1` (%2)</source>
        <translation>wurde mit einem Gitter von `%1` gelöst (%2)</translation>
    </message>
    <message>
        <source>kind of case</source>
        <translation>Art des Falls</translation>
    </message>
    <message>
        <source>cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>worst balance</source>
        <translation>größter Bilanzfehler</translation>
    </message>
    <message>
        <source>continuity</source>
        <translation>Stetigkeit</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>momentum residual</source>
        <translation>Fehler der Impulsbilanz</translation>
    </message>
    <message>
        <source>energy residual</source>
        <translation>Fehler der Energiebilanz</translation>
    </message>
    <message>
        <source>tension on the rock</source>
        <translation>Zug des Gesteins</translation>
    </message>
    <message>
        <source>return after the computed end</source>
        <translation>Rückkehr nach dem Ende</translation>
    </message>
    <message>
        <source>change over 1e-10</source>
        <translation>Änderung bei 1e-10</translation>
    </message>
    <message>
        <source>distance from limit</source>
        <translation>Abstand vom Grenzfall</translation>
    </message>
    <message>
        <source>distance from lattice</source>
        <translation>Abstand vom Gitter</translation>
    </message>
    <message>
        <source>distance from long double</source>
        <translation>Abstand von long double</translation>
    </message>
    <message>
        <source>stated error</source>
        <translation>angegebener Fehler</translation>
    </message>
    <message>
        <source>wave pieces</source>
        <translation>Wellenstücke</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>FAILED %1: %2</source>
        <translation>DURCHGEFALLEN %1: %2</translation>
    </message>
    <message>
        <source>%1 cases: %2 passed, %3 failed, %4 not solved</source>
        <translation>%1 Fälle: %2 bestanden, %3 durchgefallen, %4 nicht gelöst</translation>
    </message>
    <message>
        <source>%1 of %2, n_b = %3</source>
        <translation>%1 mit %2 je Schlag, %3 Hin- und Rückläufe bis zum nächsten Schlag</translation>
    </message>
    <message>
        <source>%1 takes a study of all gaps at every point; `drillwave thrust --along` has it</source>
        <translation>%1 braucht an jedem Punkt eine Studie aller Spalte; `drillwave thrust --along` hat es</translation>
    </message>
    <message>
        <source>a family has at most %1 lines, this one %2</source>
        <translation>eine Schar hat höchstens %1 Kurven, diese %2</translation>
    </message>
    <message>
        <source>the range of %1 must end above its beginning</source>
        <translation>der Bereich von %1 muss über seinem Anfang enden</translation>
    </message>
    <message>
        <source>a dimensionless scenario has no energy to keep; leave it out</source>
        <translation>ein durch seine Kennzahlen gegebenes Szenario hat keine Energie zu halten; die Option weglassen</translation>
    </message>
    <message>
        <source>a blow of given points has neither impulse nor velocity to scale; leave it out</source>
        <translation>ein Schlag aus gegebenen Punkten hat weder Kraftstoß noch Geschwindigkeit zum Skalieren; die Option weglassen</translation>
    </message>
    <message>
        <source>nothing is uncertain; give --uncertain KEY=LOW:HIGH or --draws FILE.csv</source>
        <translation>nichts ist unsicher; --uncertain KEY=LOW:HIGH oder --draws FILE.csv angeben</translation>
    </message>
    <message>
        <source>at most %1 uncertain parameters, these are %2</source>
        <translation>höchstens %1 unsichere Parameter, dies sind %2</translation>
    </message>
    <message>
        <source>at most %1 choices, these are %2</source>
        <translation>höchstens %1 Größen zur Wahl, dies sind %2</translation>
    </message>
    <message>
        <source>at most %1 aims, these are %2</source>
        <translation>höchstens %1 Ziele, dies sind %2</translation>
    </message>
    <message>
        <source>at most %1 designs, and the choices make too many to count; give fewer values</source>
        <translation>höchstens %1 Auslegungen, was zur Wahl steht, ergibt mehr, als sich zählen lässt; weniger Werte angeben</translation>
    </message>
    <message>
        <source>at most %1 designs, the choices make %2; give fewer values</source>
        <translation>höchstens %1 Auslegungen, was zur Wahl steht, ergibt %2; weniger Werte angeben</translation>
    </message>
    <message>
        <source>at most %1 blows, %2 designs at %3 samples are more; take fewer</source>
        <translation>höchstens %1 Schläge, %2 Auslegungen mit je %3 Stichproben sind mehr; weniger nehmen</translation>
    </message>
    <message>
        <source>%1 and %2 %3; leave out one of them</source>
        <translation>%1 und %2 %3; eines davon weglassen</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 ist zweimal angegeben; einmal angeben</translation>
    </message>
    <message>
        <source>%1 is both design variable and uncertain: only +-P% about its value can be both</source>
        <translation>%1 ist gewählt und unsicher: beides zugleich geht nur mit +-P% um die Wahl</translation>
    </message>
    <message>
        <source>keeping the energy sets %1, and so does the choice of %2; leave out that choice, or do not keep the energy (--no-keep-energy)</source>
        <translation>die Energie zu halten setzt %1, und die Wahl von %2 auch; diese Wahl weglassen oder die Energie nicht halten (--no-keep-energy)</translation>
    </message>
    <message>
        <source>thrust_margin needs a study of all gaps; aim at thrust instead</source>
        <translation>thrust_margin ist für sich schon eine Studie aller Spalte; thrust als Ziel nehmen</translation>
    </message>
    <message>
        <source>%1 needs many blows for each value; use `drillwave drill` or a sweep</source>
        <translation>%1 ist für sich schon eine Rechnung über viele Schläge; `drillwave drill` und sweep haben es</translation>
    </message>
    <message>
        <source>at %1: %2</source>
        <translation>bei %1: %2</translation>
    </message>
    <message>
        <source>column %1 %2</source>
        <translation>Spalte %1 %2</translation>
    </message>
    <message>
        <source>column `%1` is not a number that can be uncertain; leave it out</source>
        <translation>Spalte `%1` ist keine Zahl, die unsicher sein kann; in den Ziehungen weglassen</translation>
    </message>
    <message>
        <source>column `%1` is not a parameter; leave it out</source>
        <translation>Spalte `%1` ist kein Parameter; in den Ziehungen weglassen</translation>
    </message>
    <message>
        <source>the cell of %1 is missing; every draw needs a value of every key</source>
        <translation>die Zelle von %1 fehlt; jede Ziehung braucht zu jedem Schlüssel einen Wert</translation>
    </message>
    <message>
        <source>has no header; write the keys into the first row</source>
        <translation>hat keinen Kopf; die Schlüssel in die erste Zeile schreiben</translation>
    </message>
    <message>
        <source>has more than %1 rows; leave some out</source>
        <translation>hat mehr als %1 Zeilen; einige weglassen</translation>
    </message>
    <message>
        <source>has no rows of draws</source>
        <translation>hat keine Zeilen mit Ziehungen</translation>
    </message>
    <message>
        <source>has no width; give LOW below HIGH</source>
        <translation>hat keine Breite; LOW kleiner als HIGH angeben</translation>
    </message>
    <message>
        <source>has LOW above HIGH; exchange them</source>
        <translation>steht verkehrt herum; LOW kleiner als HIGH angeben</translation>
    </message>
    <message>
        <source>must begin above 0 where it is `log`</source>
        <translation>muss bei `log` über 0 beginnen</translation>
    </message>
    <message>
        <source>must begin above 0 where it is `lognormal`</source>
        <translation>muss bei `lognormal` über 0 beginnen</translation>
    </message>
    <message>
        <source>the distribution extends to %1, outside the allowed range; use lognormal</source>
        <translation>reicht bis %1, wo es keine Antwort gibt; lognormal nehmen</translation>
    </message>
    <message>
        <source>needs a number above 0 of per cent, as +-5%</source>
        <translation>braucht eine Prozentzahl über 0, wie +-5%</translation>
    </message>
    <message>
        <source>%1 needs LOW:HIGH, LOW:HIGH:log, :normal or :lognormal, or +-P%</source>
        <translation>%1 braucht LOW:HIGH, LOW:HIGH:log, :normal oder :lognormal, oder +-P%</translation>
    </message>
    <message>
        <source>unknown suffix `%1` after the range of %2; choose from uniform, log, normal, lognormal</source>
        <translation>`%1` hinter dem Bereich von %2 ist nicht bekannt; möglich sind uniform, log, normal, lognormal</translation>
    </message>
    <message>
        <source>`%1` is not a range: write KEY=LOW:HIGH, KEY=LOW:HIGH:log or KEY=+-P%</source>
        <translation>`%1` ist kein Bereich: KEY=LOW:HIGH, KEY=LOW:HIGH:log oder KEY=+-P% schreiben</translation>
    </message>
    <message>
        <source>%1 is not a number and cannot be uncertain; list values with --choose</source>
        <translation>%1 ist keine Zahl und kann nicht unsicher sein; mit --choose unter mehreren wählen</translation>
    </message>
    <message>
        <source>%1 takes only whole numbers and cannot be uncertain; list values with --choose</source>
        <translation>%1 nimmt nur ganze Zahlen und kann nicht unsicher sein; mit --choose unter mehreren wählen</translation>
    </message>
    <message>
        <source>%1 does not apply here: %2</source>
        <translation>%1 hat hier keine Bedeutung: %2</translation>
    </message>
    <message>
        <source>%1 = +-%2% (the scenario has 0 there; give LOW:HIGH)</source>
        <translation>%1 = +-%2% (das Szenario hat dort 0; LOW:HIGH angeben)</translation>
    </message>
    <message>
        <source>%1 = +-%2% (the scenario has no value there; give LOW:HIGH)</source>
        <translation>%1 = +-%2% (das Szenario hat dort keinen Wert; LOW:HIGH angeben)</translation>
    </message>
    <message>
        <source>%1 = +-%2% of %3 (%4)</source>
        <translation>%1 = +-%2% von %3 (%4)</translation>
    </message>
    <message>
        <source>the machine is pushed back without limit</source>
        <translation>die Maschine weicht zurück: keine beschränkte Bewegung</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>es wurde angehalten</translation>
    </message>
    <message>
        <source>the axis %1 of a map needs START:STOP:COUNT or START:STOP:COUNT:log</source>
        <translation>die Achse %1 eines Kennfelds braucht START:STOP:COUNT oder START:STOP:COUNT:log</translation>
    </message>
    <message>
        <source>the map has more than %1 points; take fewer, or use `drillwave sweep`, which has no limit</source>
        <translation>das Kennfeld hat mehr als %1 Punkte; weniger nehmen, oder `drillwave sweep`, das keine behält</translation>
    </message>
    <message>
        <source>momentum residual %1</source>
        <translation>Fehler der Impulsbilanz %1</translation>
    </message>
    <message>
        <source>energy residual %1</source>
        <translation>Fehler der Energiebilanz %1</translation>
    </message>
    <message>
        <source>tension on the rock: F/Fmax %1</source>
        <translation>das Gestein zieht: F/Fmax %1</translation>
    </message>
    <message>
        <source>not at its end: the bit returns by %1</source>
        <translation>nicht am Ende: das vordere Ende kehrt um %1 zurück</translation>
    </message>
    <message>
        <source>not continuous: e changes by %1</source>
        <translation>nicht stetig: e ändert sich um %1</translation>
    </message>
    <message>
        <source>far from its limit by a factor %1</source>
        <translation>um den Faktor %1 zu weit vom Grenzfall entfernt</translation>
    </message>
    <message>
        <source>the lattice differs, in units of its error estimate: %1</source>
        <translation>das Gitter weicht um das %1-Fache der geschätzten Fehler ab</translation>
    </message>
    <message>
        <source>the error bound is exceeded by a factor of %1</source>
        <translation>der angegebene Fehler wird um den Faktor %1 überschritten</translation>
    </message>
    <message>
        <source>%1 and %2 %3; vary one of them</source>
        <translation>%1 und %2 %3; eines davon variieren</translation>
    </message>
    <message>
        <source>`all` are all outputs already; give nothing else</source>
        <translation>`all` sind schon alle Ergebnisse; allein angeben</translation>
    </message>
    <message>
        <source>`%1` is not an output; did you mean `%2`?</source>
        <translation>`%1` ist kein Ergebnis; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>`%1` is not an output; choose from %2</source>
        <translation>`%1` ist kein Ergebnis; möglich sind %2</translation>
    </message>
    <message>
        <source>`%1` is given twice; give it once</source>
        <translation>`%1` ist zweimal angegeben; einmal angeben</translation>
    </message>
    <message>
        <source>SI columns need a scenario in physical units; this one is given by its dimensionless groups</source>
        <translation>SI-Spalten brauchen ein Szenario in physikalischen Einheiten; dieses ist durch seine dimensionslosen Kennzahlen gegeben</translation>
    </message>
    <message>
        <source>the count `%1` of %2 must be a whole number from 1 to %3</source>
        <translation>die Anzahl `%1` von %2 muss eine ganze Zahl von 1 bis %3 sein</translation>
    </message>
    <message>
        <source>unknown suffix `%1` after the range of %2; only `log` is allowed</source>
        <translation>`%1` hinter dem Ende von %2 ist nicht bekannt; nur `log` darf folgen</translation>
    </message>
    <message>
        <source>unknown suffix `%1` after the count of %2; only `log` is allowed</source>
        <translation>`%1` hinter der Anzahl von %2 ist nicht bekannt; nur `log` darf folgen</translation>
    </message>
    <message>
        <source>a logarithmic axis of %1 must begin and end above 0</source>
        <translation>eine logarithmische Achse von %1 muss über 0 beginnen und enden</translation>
    </message>
    <message>
        <source>%1 takes only whole numbers; give a COUNT that hits them, or a list A,B,C</source>
        <translation>%1 nimmt nur ganze Zahlen; ein COUNT angeben, das sie trifft, oder eine Liste A,B,C</translation>
    </message>
    <message>
        <source>%1 needs START:STOP:COUNT, START:STOP:COUNT:log or a list A,B,C</source>
        <translation>%1 braucht START:STOP:COUNT, START:STOP:COUNT:log oder eine Liste A,B,C</translation>
    </message>
    <message>
        <source>%1 needs START:STOP or START:STOP:log</source>
        <translation>%1 braucht START:STOP oder START:STOP:log</translation>
    </message>
    <message>
        <source>%1 has no numeric values; use a family of shapes</source>
        <translation>%1 hat keine Zahlen zum Verfolgen; eine Schar von Formen daraus machen</translation>
    </message>
    <message>
        <source>%1 has no numeric values; use a family of words</source>
        <translation>%1 hat keine Zahlen zum Verfolgen; eine Schar von Wörtern daraus machen</translation>
    </message>
    <message>
        <source>`%1` is not an axis: write KEY=START:STOP:COUNT, KEY=START:STOP:COUNT:log or KEY=A,B,C</source>
        <translation>`%1` ist keine Achse: KEY=START:STOP:COUNT, KEY=START:STOP:COUNT:log oder KEY=A,B,C schreiben</translation>
    </message>
    <message>
        <source>`%1` is not an axis: write KEY=START:STOP or KEY=START:STOP:log</source>
        <translation>`%1` ist keine Achse: KEY=START:STOP oder KEY=START:STOP:log schreiben</translation>
    </message>
    <message>
        <source>%1 has only whole numbers; make a family of them, or sweep it</source>
        <translation>%1 hat nur ganze Zahlen; eine Schar daraus machen, oder sweep nehmen</translation>
    </message>
    <message>
        <source>the range of %1 is too narrow: it must be at least 1e-4 of its end</source>
        <translation>der Bereich von %1 ist zu schmal: er muss mindestens 1e-4 seines Endes betragen</translation>
    </message>
    <message>
        <source>the axis %1</source>
        <translation>die Achse %1</translation>
    </message>
    <message>
        <source>a sweep has at most %1 axes, this one %2</source>
        <translation>sweep hat höchstens %1 Achsen, hier sind es %2</translation>
    </message>
    <message>
        <source>the axes %1 and %2 %3; vary one of them</source>
        <translation>die Achsen %1 und %2 %3; eine davon variieren</translation>
    </message>
    <message>
        <source>the grid has more than %1 points; take fewer values</source>
        <translation>das Raster hat mehr als %1 Punkte; weniger Werte nehmen</translation>
    </message>
    <message>
        <source>pictures show one axis or two, not %1; vary fewer, or leave out --plots</source>
        <translation>Bilder zeigen eine oder zwei Achsen, nicht %1; weniger variieren, oder --plots weglassen</translation>
    </message>
    <message>
        <source>no axis has two or more numeric values to draw a curve along</source>
        <translation>keine Achse hat zwei Zahlen oder mehr, über denen sich eine Kurve zeichnen lässt</translation>
    </message>
    <message>
        <source>pictures need all rows; leave out --shard</source>
        <translation>ein Teil der Zeilen lässt sich nicht zeichnen; --shard weglassen</translation>
    </message>
    <message>
        <source>at most %1 rows can be drawn, not %2; take fewer</source>
        <translation>höchstens %1 Zeilen lassen sich zeichnen, nicht %2; weniger nehmen</translation>
    </message>
    <message>
        <source>at most %1 curves can be distinguished, and %2 has %3 values; take fewer, or draw a map (drillwave map)</source>
        <translation>höchstens %1 Kurven lassen sich unterscheiden, und %2 hat %3 Werte; weniger nehmen, oder ein Kennfeld zeichnen (drillwave map)</translation>
    </message>
    <message>
        <source>at most %1 outputs can be drawn, not %2; choose with --outputs</source>
        <translation>höchstens %1 Ergebnisse lassen sich zeichnen, nicht %2; mit --outputs auswählen</translation>
    </message>
    <message>
        <source>is empty; its first row must name parameters</source>
        <translation>ist leer; die erste Zeile muss Parameter nennen</translation>
    </message>
    <message>
        <source>cells are separated by tabs, not by `,`; save the table with `,` between them and `.` in numbers</source>
        <translation>Zellen sind durch Tabulatoren getrennt, nicht durch `,`; die Tabelle mit `,` dazwischen und `.` in Zahlen speichern</translation>
    </message>
    <message>
        <source>cells are separated by `;`, not by `,`; save the table with `,` between them and `.` in numbers</source>
        <translation>Zellen sind durch `;` getrennt, nicht durch `,`; die Tabelle mit `,` dazwischen und `.` in Zahlen speichern</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; write a known key, or another name than `%2` for a column that is only passed through</source>
        <translation>`%1` ist kein Parameter; einen vorhandenen Schlüssel schreiben, oder für eine Spalte, die nur durchgereicht werden soll, einen anderen Namen als `%2`</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; did you mean `%2`? A column that is only passed through needs another name than `%3`</source>
        <translation>`%1` ist kein Parameter; war `%2` gemeint, oder für eine Spalte, die nur durchgereicht werden soll, ein anderer Name als `%3`?</translation>
    </message>
    <message>
        <source>has %1; save the table as CSV in UTF-8</source>
        <translation>enthält %1; die Tabelle als CSV in UTF-8 speichern</translation>
    </message>
    <message>
        <source>`%1` is no number; give it with --set for all rows</source>
        <translation>`%1` ist keine Zahl; mit --set für alle Zeilen angeben</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; write `%2`, with its unit in square brackets, or another name for a column that is only passed through</source>
        <translation>`%1` ist kein Parameter; `%2` schreiben, mit der Einheit in eckigen Klammern, oder für eine Spalte, die nur durchgereicht werden soll, einen anderen Namen</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; write `%2`, or another name for a column that is only passed through</source>
        <translation>`%1` ist kein Parameter; `%2` schreiben, oder für eine Spalte, die nur durchgereicht werden soll, einen anderen Namen</translation>
    </message>
    <message>
        <source>`%1` is not a parameter and only passed through</source>
        <translation>`%1` ist kein Parameter und wird nur durchgereicht</translation>
    </message>
    <message>
        <source>`%1` is not a parameter and only passed through; did you mean `%2`?</source>
        <translation>`%1` ist kein Parameter und wird nur durchgereicht; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>%1 has no unit; write it without `[%2]`</source>
        <translation>%1 hat keine Einheit; ohne `[%2]` schreiben</translation>
    </message>
    <message>
        <source>%1: unit `%2` is not known here; allowed units: %3</source>
        <translation>%1: die Einheit `%2` ist hier nicht bekannt; möglich sind: %3</translation>
    </message>
    <message>
        <source>sets %1, which column %2 also sets; keep one of them</source>
        <translation>setzt %1 noch einmal, Spalte %2 tut das schon; eine davon behalten</translation>
    </message>
    <message>
        <source>`%1` is passed through unchanged; the computed column with the same name follows</source>
        <translation>`%1` wird unverändert durchgereicht; die berechnete Spalte folgt unter demselben Namen</translation>
    </message>
    <message>
        <source>no column is a parameter, so every row would be the same blow; name parameters in the first row, such as `beta` or `rod.length [m]`</source>
        <translation>keine Spalte nennt einen Parameter, so dass jede Zeile derselbe Schlag wäre; in der ersten Zeile welche nennen, wie `beta` oder `rod.length [m]`</translation>
    </message>
    <message>
        <source>has %1; save the table in UTF-8</source>
        <translation>enthält %1; die Tabelle in UTF-8 speichern</translation>
    </message>
    <message>
        <source>is in %1, the column in %2: write it in that, or the header without a unit</source>
        <translation>ist in %1, die Spalte in %2: in deren Einheit schreiben, oder den Kopf ohne Einheit</translation>
    </message>
    <message>
        <source>has %1 cells, the header has %2</source>
        <translation>hat %1 Zellen, der Kopf hat %2</translation>
    </message>
    <message>
        <source>%1 and %2 %3; leave one of the two cells empty</source>
        <translation>%1 und %2 %3; eine der beiden Zellen leer lassen</translation>
    </message>
    <message>
        <source>text follows a closing quote</source>
        <translation>auf ein schließendes Anführungszeichen folgt Text</translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation>ein Anführungszeichen ist nicht geschlossen</translation>
    </message>
    <message>
        <source>the record is too long</source>
        <translation>der Datensatz ist zu lang</translation>
    </message>
    <message>
        <source>the record has too many cells</source>
        <translation>der Datensatz hat zu viele Zellen</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>muss eine ganze Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>must be UTF-8</source>
        <translation>muss UTF-8 sein</translation>
    </message>
    <message>
        <source>must be one line</source>
        <translation>muss eine einzige Zeile sein</translation>
    </message>
    <message>
        <source>must have no control characters</source>
        <translation>darf keine Steuerzeichen enthalten</translation>
    </message>
    <message>
        <source>must have no characters that change the reading direction</source>
        <translation>darf keine Zeichen enthalten, die die Leserichtung umkehren</translation>
    </message>
    <message>
        <source>must have a letter</source>
        <translation>muss einen Buchstaben enthalten</translation>
    </message>
    <message>
        <source>a loading curve of more than one line</source>
        <translation>eine Belastungskurve aus mehr als einer Geraden</translation>
    </message>
    <message>
        <source>the closed form is for a rectangular pulse, gamma = 1, a whole number as delta and tau &gt;= 0.5, not %1; use the exact method or the lattice</source>
        <translation>die geschlossene Form gilt für Rechteckschlag, gamma = 1, ganzzahliges delta und tau &gt;= 0,5, nicht für %1; das exakte Verfahren oder das Gitter nehmen</translation>
    </message>
    <message>
        <source>the file of presets %1</source>
        <translation>die Datei mit Voreinstellungen %1</translation>
    </message>
    <message>
        <source>--segments %1: needs at most %2 whole numbers from %3 to %4, as in 100,1000,10000</source>
        <translation>--segments %1: braucht höchstens %2 ganze Zahlen von %3 bis %4, wie 100,1000,10000</translation>
    </message>
    <message>
        <source>--segments %1: would move waves by %2 segments, more than --work-limit, now %3, permits (half a minute is some 1e9); take fewer or permit more</source>
        <translation>--segments %1: würde Wellen um %2 Segmente verschieben, mehr als --work-limit, jetzt %3, erlaubt (eine halbe Minute ist etwa 1e9); weniger nehmen oder mehr erlauben</translation>
    </message>
    <message>
        <source>unknown option `%1`; did you mean `%2`?</source>
        <translation>unbekannte Option `%1`; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>unknown option `%1`; --help lists the options</source>
        <translation>unbekannte Option `%1`; --help listet die Optionen auf</translation>
    </message>
    <message>
        <source>`%1` needs a value: %2</source>
        <translation>`%1` braucht einen Wert: %2</translation>
    </message>
    <message>
        <source>%1; `%2` after it is an option; write ./%2 for a file of that name</source>
        <translation>%1; `%2` dahinter ist eine Option, eine Datei dieses Namens ist ./%2</translation>
    </message>
    <message>
        <source>%1; `%2` after it is an option</source>
        <translation>%1; `%2` dahinter ist eine Option</translation>
    </message>
    <message>
        <source>`%1` takes no value</source>
        <translation>`%1` nimmt keinen Wert</translation>
    </message>
    <message>
        <source>--level: at most %1 levels</source>
        <translation>--level: höchstens %1 Werte</translation>
    </message>
    <message>
        <source>-o needs a name, this one is empty; - is standard output</source>
        <translation>-o braucht einen Namen, dieser ist leer; - ist die Standardausgabe</translation>
    </message>
    <message>
        <source>needs %1; see drillwave %2 --help</source>
        <translation>braucht %1; siehe drillwave %2 --help</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; the command takes none, see drillwave %2 --help</source>
        <translation>`%1` ist zu viel; der Befehl nimmt keine Argumente, siehe drillwave %2 --help</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; the command takes %2, see drillwave %3 --help</source>
        <translation>`%1` ist zu viel; der Befehl nimmt %2, siehe drillwave %3 --help</translation>
    </message>
    <message>
        <source>--goal needs one output; --outputs names %1</source>
        <translation>--goal gilt für ein einziges Ergebnis; --outputs nennt %1</translation>
    </message>
    <message>
        <source>--goal %1: without --si %2 is a number without a unit; add --si</source>
        <translation>--goal %1: ohne --si ist %2 eine Zahl ohne Einheit; --si hinzufügen</translation>
    </message>
    <message>
        <source>needs --along KEY=START:STOP or KEY=START:STOP:log</source>
        <translation>braucht --along KEY=START:STOP oder KEY=START:STOP:log</translation>
    </message>
    <message>
        <source>--goal cannot be used with -o -, which prints the curve; leave out -o, or give -o FILE.csv</source>
        <translation>für --goal ist kein Platz, wo -o - die Kurve ausgibt; -o weglassen oder -o FILE.csv angeben</translation>
    </message>
    <message>
        <source>%1: could not be solved everywhere: from %2 = %3 to %4: %5</source>
        <translation>%1: konnte nicht überall gelöst werden: von %2 = %3 bis %4: %5</translation>
    </message>
    <message>
        <source>--force applies to the file of -o; add -o FILE.csv</source>
        <translation>--force gilt für die Datei von -o; -o FILE.csv hinzufügen</translation>
    </message>
    <message>
        <source>--json and -o - would both print to standard output; take one</source>
        <translation>--json und -o - würden beide auf die Standardausgabe schreiben; eines davon nehmen</translation>
    </message>
    <message>
        <source>takes one FILE; remove `%1`</source>
        <translation>nimmt nur ein FILE; `%1` ist ein zweites</translation>
    </message>
    <message>
        <source>needs FILE</source>
        <translation>braucht FILE</translation>
    </message>
    <message>
        <source>blows</source>
        <translation>Schläge</translation>
    </message>
    <message>
        <source>%1: too many samples could not be solved, so designs have no statistics: %2 of %3; the first: %4</source>
        <translation>%1: zu viele Stichproben haben keine Antwort, so dass es zu Auslegungen keine Statistik gibt: %2 von %3; die erste: %4</translation>
    </message>
    <message>
        <source>no design meets all limits; loosen one or widen the choices</source>
        <translation>keine Auslegung hält alle Grenzen ein; eine lockern oder die Wahl erweitern</translation>
    </message>
    <message>
        <source>the scenario could not be solved with the values entered</source>
        <translation>das Szenario selbst konnte nicht gelöst werden</translation>
    </message>
    <message>
        <source>--force applies to the files of -o; add -o DIR</source>
        <translation>--force gilt für die Dateien von -o; -o DIR hinzufügen</translation>
    </message>
    <message>
        <source>files in %1</source>
        <translation>Dateien in %1</translation>
    </message>
    <message>
        <source>`%1` needs OUTPUT@STATISTIC, as efficiency@q05</source>
        <translation>`%1` braucht OUTPUT@STATISTIC, wie efficiency@q05</translation>
    </message>
    <message>
        <source>`all` means several outputs; name one</source>
        <translation>`all` sind mehrere Ergebnisse; eines nennen</translation>
    </message>
    <message>
        <source>`%1` is not a statistic; choose from mean, q01 to q99, min, max, nominal</source>
        <translation>`%1` ist keine Statistik; möglich sind mean, q01 bis q99, min, max, nominal</translation>
    </message>
    <message>
        <source>needs max:OUTPUT@STATISTIC or min:OUTPUT@STATISTIC</source>
        <translation>braucht max:OUTPUT@STATISTIC oder min:OUTPUT@STATISTIC</translation>
    </message>
    <message>
        <source>`%1`: write --aim before it</source>
        <translation>`%1`: --aim davor schreiben</translation>
    </message>
    <message>
        <source>needs OUTPUT@STATISTIC=VALUE</source>
        <translation>braucht OUTPUT@STATISTIC=VALUE</translation>
    </message>
    <message>
        <source>no display to open the window on; use `drillwave run FILE` (see --help), or `drillwave -platform offscreen`</source>
        <translation>keine Anzeige für das Fenster; `drillwave run FILE` nehmen (siehe --help), oder `drillwave -platform offscreen`</translation>
    </message>
    <message>
        <source>--gaps needs a scan; add --scan KEY=START:STOP:COUNT</source>
        <translation>--gaps gilt für einen Durchlauf; --scan KEY=START:STOP:COUNT hinzufügen</translation>
    </message>
    <message>
        <source>--histories: these blows have more than %1 samples; take fewer blows or fewer --cells</source>
        <translation>--histories: diese Schläge haben mehr als %1 Zeitpunkte; weniger Schläge oder weniger --cells nehmen</translation>
    </message>
    <message>
        <source>--work-limit %1: must be at least 1</source>
        <translation>--work-limit %1 muss eine Zahl von mindestens 1 sein</translation>
    </message>
    <message>
        <source>--si and --dimensionless cannot be combined</source>
        <translation>--si und --dimensionless schließen einander aus</translation>
    </message>
    <message>
        <source>--histories %1 needs a folder: add -o DIR</source>
        <translation>--histories %1 braucht einen Ordner: -o DIR hinzufügen</translation>
    </message>
    <message>
        <source>--histories %1 must be A:B, blows from 1 to %2</source>
        <translation>--histories %1 muss A:B sein, Schläge von 1 bis %2</translation>
    </message>
    <message>
        <source>end_time applies only to single blows, not here</source>
        <translation>end_time zählt bei einzelnen Schlägen, nicht hier</translation>
    </message>
    <message>
        <source>machine_mass without a damper: the machine presses with a constant force</source>
        <translation>machine_mass ohne Dämpfer: die Maschine drückt mit konstanter Kraft</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows could not be solved: their cells are empty; the first: %4</source>
        <translation>%1: %2 von %3 Zeilen ohne Lösung, ihre Zellen bleiben leer; die erste: %4</translation>
    </message>
    <message>
        <source>--plots: a scan over %1 has words on its axis and no picture; scan a number</source>
        <translation>--plots: ein Durchlauf über %1 hat Wörter auf der Achse und kein Bild; eine Zahl durchlaufen</translation>
    </message>
    <message>
        <source>-o and --gaps name the same file; give two</source>
        <translation>-o und --gaps nennen dieselbe Datei; zwei angeben</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>`%1` is not an example; `drillwave examples` lists them</source>
        <translation>`%1` ist kein Beispiel; `drillwave examples` listet sie auf</translation>
    </message>
    <message>
        <source>`%1` is not an example; did you mean `%2`?</source>
        <translation>`%1` ist kein Beispiel; war `%2` gemeint?</translation>
    </message>
    <message>
        <source>Fig. %1 could not be drawn</source>
        <translation>Abb. %1 konnte nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>%1 applies to files; add -o %2</source>
        <translation>%1 gilt für Dateien; mit -o %2 angeben, wohin sie sollen</translation>
    </message>
    <message>
        <source>needs -o DIR, the folder for the figures</source>
        <translation>braucht -o DIR, den Ordner für die Abbildungen</translation>
    </message>
    <message>
        <source>%1 files in %2; %3 of %4 printed numbers agree, see index.html or discrepancies.csv</source>
        <translation>%1 Dateien in %2; %3 von %4 gedruckten Zahlen stimmen, siehe index.html oder discrepancies.csv</translation>
    </message>
    <message>
        <source>must be from %1 to %2, d0 being %3</source>
        <translation>muss von %1 bis %2 sein, mit d0 = %3</translation>
    </message>
    <message>
        <source>must be from %1 to %2</source>
        <translation>muss von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>--gap-mean needs --gap-deviation, how far gaps scatter about it</source>
        <translation>--gap-mean braucht --gap-deviation, das angibt, wie weit Spalte darum streuen</translation>
    </message>
    <message>
        <source>is a drill string, and this command solves uniform rods alone (`drillwave: 1`); `drillwave curve FILE --along bit_rock.gap=0mm:2mm` follows a string along its gap</source>
        <translation>ist ein Bohrstrang, und dieser Befehl löst nur gleichförmige Stangen (`drillwave: 1`); `drillwave curve FILE --along bit_rock.gap=0mm:2mm` verfolgt einen Strang über seinem Spalt</translation>
    </message>
    <message>
        <source>--si: %1 is given by its dimensionless groups and has no SI units</source>
        <translation>--si: %1 ist durch dimensionslose Kennzahlen gegeben und hat keine SI-Einheiten</translation>
    </message>
    <message>
        <source>Usage: drillwave %1 [OPTION]…
</source>
        <translation>Aufruf: drillwave %1 [OPTION]…
</translation>
    </message>
    <message>
        <source>`%1` is not a section of %2</source>
        <translation>`%1` ist kein Abschnitt von %2</translation>
    </message>
    <message>
        <source>`%1` is not a section of %2, which has %3</source>
        <translation>`%1` ist kein Abschnitt von %2; vorhanden: %3</translation>
    </message>
    <message>
        <source>`%1` is not a command, chapter, parameter or output; see `drillwave help`</source>
        <translation>`%1` ist weder ein Befehl noch ein Kapitel, Parameter oder Ergebnis; `drillwave help` sagt, was es gibt</translation>
    </message>
    <message>
        <source>`%1` is not a command, chapter, parameter or output; did you mean %2? See `drillwave help`</source>
        <translation>`%1` ist weder ein Befehl noch ein Kapitel, Parameter oder Ergebnis; ähnlich: %2; `drillwave help` sagt, was es gibt</translation>
    </message>
    <message>
        <source>reading standard input; end it with Ctrl-D</source>
        <translation>liest die Standardeingabe; Strg-D beendet sie</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2; copy it to another disk, or get it again</source>
        <translation>%1: kann nicht gelesen werden: %2; auf einen anderen Datenträger kopieren oder neu beschaffen</translation>
    </message>
    <message>
        <source>is not a regular file; save the rows to a file first</source>
        <translation>ist keine gewöhnliche Datei; die Zeilen zuerst in eine Datei schreiben</translation>
    </message>
    <message>
        <source>cannot be opened for reading; check its permissions</source>
        <translation>kann nicht zum Lesen geöffnet werden; die Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>%1: cannot be stored in %2: %3; set TMPDIR to a folder with more space</source>
        <translation>%1: kann in %2 nicht zwischengespeichert werden: %3; TMPDIR auf einen Ordner mit mehr Platz setzen</translation>
    </message>
    <message>
        <source>%1: is longer than %2 MiB, the limit for input that is not a file; save its rows to a file first</source>
        <translation>%1: ist länger als %2 MiB, mehr wird von Eingaben, die keine Datei sind, nicht zwischengespeichert; die Zeilen zuerst in eine Datei schreiben</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>interrupted; no output was left behind</source>
        <translation>abgebrochen; es wurde keine Ausgabe hinterlassen</translation>
    </message>
    <message>
        <source>its command does not exist in this version: %1</source>
        <translation>den Befehl darin gibt es in dieser Version nicht: %1</translation>
    </message>
    <message>
        <source>is not a file of rows</source>
        <translation>ist keine Datei mit Zeilen</translation>
    </message>
    <message>
        <source>the part does not exist</source>
        <translation>diesen Teil gibt es nicht</translation>
    </message>
    <message>
        <source>%1; a part needs the record written with it</source>
        <translation>%1; ein Teil braucht die .yaml, die mit ihm geschrieben wurde</translation>
    </message>
    <message>
        <source>number of parts</source>
        <translation>Anzahl der Teile</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>%1: belongs to another run than %2: its %3 differs; leave it out or run it again</source>
        <translation>%1: ist Teil eines anderen Laufs als %2 (Unterschied: %3); weglassen oder neu rechnen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>needs -o FILE, where to write; - is standard output</source>
        <translation>braucht -o FILE, wohin geschrieben wird; - ist die Standardausgabe</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>%1 needs one of %2</source>
        <translation>%1 braucht eines von %2</translation>
    </message>
    <message>
        <source>%1: `%2` is not one of %3</source>
        <translation>%1: `%2` ist keines von %3</translation>
    </message>
    <message>
        <source>standard output: cannot be written: %1</source>
        <translation>Standardausgabe: kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; see `drillwave help`</source>
        <translation>`%1` ist zu viel; `drillwave help` sagt, was es gibt</translation>
    </message>
    <message>
        <source>out of memory: this needs more than is free, or than a limit (ulimit -v, -d) permits; raise it, use fewer threads (-j 1) or ask for less at once</source>
        <translation>Speicher erschöpft: dies braucht mehr, als frei ist oder eine Grenze (ulimit -v, -d) erlaubt; diese erhöhen, weniger Threads nehmen (-j 1) oder weniger auf einmal verlangen</translation>
    </message>
    <message>
        <source>internal error: %1; please report it with the command that led to it</source>
        <translation>interner Fehler: %1; bitte mit dem Befehl melden, der dazu geführt hat</translation>
    </message>
    <message>
        <source>needs --x KEY=START:STOP:COUNT[:log] and --y KEY=START:STOP:COUNT[:log]; %1 is missing</source>
        <translation>braucht --x KEY=START:STOP:COUNT[:log] und ebenso --y; %1 fehlt</translation>
    </message>
    <message>
        <source>--output: a map has one output; for several take `drillwave sweep`</source>
        <translation>--output: ein Kennfeld hat ein einziges Ergebnis; für mehrere `drillwave sweep` nehmen</translation>
    </message>
    <message>
        <source>%1 cannot be used with -o -, which prints the map; give -o FILE.csv</source>
        <translation>für %1 ist kein Platz, wo -o - das Kennfeld ausgibt; -o FILE.csv angeben</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>contour points</source>
        <translation>Höhenlinienpunkte</translation>
    </message>
    <message>
        <source>%1 points of a contour could not be placed: %2</source>
        <translation>%1 Punkte einer Höhenlinie ließen sich nicht bestimmen: %2</translation>
    </message>
    <message>
        <source>%1 of %2 points could not be solved and have no output; %3</source>
        <translation>%1 von %2 Punkten ohne Lösung und ohne Ergebnis; %3</translation>
    </message>
    <message>
        <source>--shard: a part of a map has only rows; add -o FILE.csv</source>
        <translation>--shard: ein Teil eines Kennfelds hat nur Zeilen; -o FILE.csv hinzufügen</translation>
    </message>
    <message>
        <source>%1 needs the map in one piece; leave out --shard</source>
        <translation>%1 braucht das Kennfeld in einem Stück; --shard weglassen</translation>
    </message>
    <message>
        <source>--method %1: is not known; choose from %2</source>
        <translation>--method %1: ist nicht bekannt; möglich sind %2</translation>
    </message>
    <message>
        <source>--segments applies to the lattice; add --method lattice</source>
        <translation>--segments gilt für das Gitter; --method lattice hinzufügen</translation>
    </message>
    <message>
        <source>%1: is for uniform rods; leave it out for a drill string</source>
        <translation>%1: gilt für gleichförmige Stangen; bei einem Bohrstrang weglassen</translation>
    </message>
    <message>
        <source>nothing can be written: %1; raise the limit of open files (ulimit -n)</source>
        <translation>nichts kann geschrieben werden: %1; die Grenze für offene Dateien erhöhen (ulimit -n)</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>Standardausgabe</translation>
    </message>
    <message>
        <source>is closed; send it to a file or to /dev/null</source>
        <translation>ist geschlossen; in eine Datei oder nach /dev/null leiten</translation>
    </message>
    <message>
        <source>the name is not UTF-8; choose another one</source>
        <translation>der Name hat Bytes, die kein UTF-8 sind; einen anderen wählen</translation>
    </message>
    <message>
        <source>is a folder; give the name of a file</source>
        <translation>ist ein Ordner; den Namen einer Datei angeben</translation>
    </message>
    <message>
        <source>exists already; use --force to overwrite it or choose another name</source>
        <translation>gibt es schon; mit --force überschreiben oder einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; free some space or choose another place with -o</source>
        <translation>%1: kann nicht geschrieben werden: %2; Platz schaffen oder mit -o einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another place with -o</source>
        <translation>%1: kann nicht geschrieben werden: %2; mit -o einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>may be %1; give the whole name</source>
        <translation>passt auf %1; den ganzen Namen angeben</translation>
    </message>
    <message>
        <source>is not known; did you mean `%1`?</source>
        <translation>ist nicht bekannt; war `%1` gemeint?</translation>
    </message>
    <message>
        <source>is not known; `%1` lists them</source>
        <translation>ist nicht bekannt; `%1` listet auf, was es gibt</translation>
    </message>
    <message>
        <source>the file of presets has an empty name; without one the built-in ones are taken</source>
        <translation>die Datei mit Voreinstellungen hat einen leeren Namen; ohne die Option gelten die eingebauten</translation>
    </message>
    <message>
        <source>%1: the file of presets is larger than the limit of %2 KiB</source>
        <translation>%1: die Datei mit Voreinstellungen ist größer als %2 KiB, das ist kaum beabsichtigt</translation>
    </message>
    <message>
        <source>%1 is a drill string: its sections are given one by one</source>
        <translation>%1 ist ein Bohrstrang, dessen Abschnitte einzeln angegeben werden</translation>
    </message>
    <message>
        <source>%1 is given by its dimensionless groups; presets need a scenario in physical units</source>
        <translation>%1 ist durch dimensionslose Kennzahlen gegeben; Voreinstellungen brauchen ein Szenario in physikalischen Einheiten</translation>
    </message>
    <message>
        <source>--presets applies to --rod, --hammer and --rock; add one of them</source>
        <translation>--presets gilt für --rod, --hammer und --rock; eines davon hinzufügen</translation>
    </message>
    <message>
        <source>rods, for %1</source>
        <translation>Stangen, für %1</translation>
    </message>
    <message>
        <source>hammers, for %1</source>
        <translation>Hämmer, für %1</translation>
    </message>
    <message>
        <source>rocks, for %1</source>
        <translation>Gesteine, für %1</translation>
    </message>
    <message>
        <source>pistons, for drill strings (length × diameter / bore)</source>
        <translation>Kolben, für Bohrstränge (Länge × Durchmesser / Bohrung)</translation>
    </message>
    <message>
        <source>adapters, for drill strings (length × diameter / bore)</source>
        <translation>Einsteckenden, für Bohrstränge (Länge × Durchmesser / Bohrung)</translation>
    </message>
    <message>
        <source>couplings, for drill strings (length × diameter / bore)</source>
        <translation>Kupplungsmuffen, für Bohrstränge (Länge × Durchmesser / Bohrung)</translation>
    </message>
    <message>
        <source>bits, for drill strings (length × diameter / bore)</source>
        <translation>Bohrkronen, für Bohrstränge (Länge × Durchmesser / Bohrung)</translation>
    </message>
    <message>
        <source>no preset has all of &quot;%1&quot;</source>
        <translation>keine Voreinstellung enthält alles aus &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 fertig</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>solving for %1; Ctrl-C ends it</source>
        <translation>löst seit %1; Strg-C bricht ab</translation>
    </message>
    <message>
        <source>solving for %1</source>
        <translation>löst seit %1</translation>
    </message>
    <message>
        <source>needs -o DIR, -o FILE.html or -o FILE.pdf, where to write</source>
        <translation>braucht -o DIR, -o FILE.html oder -o FILE.pdf, wohin geschrieben wird</translation>
    </message>
    <message>
        <source>a report is FILE.html or FILE.pdf; for a folder of that name, end it with /</source>
        <translation>ein Bericht ist FILE.html oder FILE.pdf; für einen Ordner dieses Namens / dahinter setzen</translation>
    </message>
    <message>
        <source>report in %1</source>
        <translation>Bericht in %1</translation>
    </message>
    <message>
        <source>--shard %1: needs I/N, 1 &lt;= I &lt;= N &lt;= %2</source>
        <translation>--shard %1: braucht I/N, 1 &lt;= I &lt;= N &lt;= %2</translation>
    </message>
    <message>
        <source>%1; --work-limit, now %2, permits more</source>
        <translation>%1; ein höheres --work-limit, jetzt %2, erlaubt mehr</translation>
    </message>
    <message>
        <source>%1 row</source>
        <translation>%1 Zeile</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>%1; %2 for other reasons</source>
        <translation>%1; %2 aus anderen Gründen</translation>
    </message>
    <message>
        <source>%1: could not be solved: %2</source>
        <translation>%1: konnte nicht gelöst werden: %2</translation>
    </message>
    <message>
        <source>Outputs:</source>
        <translation>Ergebnisse:</translation>
    </message>
    <message>
        <source>all of these that FILE has: some need a blow frequency, thrust_margin a thrust too</source>
        <translation>alle davon, die FILE hat; manche brauchen eine Frequenz, thrust_margin auch Andruck</translation>
    </message>
    <message>
        <source>Results of many blows, only by name (each takes a march); FILE needs drill.blow_frequency and drill.thrust:</source>
        <translation>Aus vielen Schlägen, nur namentlich (je Fall eine Rechnung); mit drill.blow_frequency und drill.thrust:</translation>
    </message>
    <message>
        <source>note: the waves of this blow are more than can be kept: no histories.csv, no record and no plots</source>
        <translation>Hinweis: dieser Schlag hat mehr Wellen, als behalten werden können: keine histories.csv und keine Diagramme</translation>
    </message>
    <message>
        <source>%1 and %2 %3; give one of them</source>
        <translation>%1 und %2 %3; eines davon angeben</translation>
    </message>
    <message>
        <source>needs KEY=VALUE</source>
        <translation>braucht KEY=VALUE</translation>
    </message>
    <message>
        <source>holds %1</source>
        <translation>enthält %1</translation>
    </message>
    <message>
        <source>%1: note: written by Drillwave %2, newer than this %3: results may differ</source>
        <translation>%1: Hinweis: von Drillwave %2 geschrieben, das neuer ist als dieses %3: Ergebnisse können abweichen</translation>
    </message>
    <message>
        <source>-o %1 is also the input (%2); choose another name for the output</source>
        <translation>-o %1 wird als Eingabe gelesen (%2); für die Ausgabe einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>FILE - and --presets - would both read standard input; take one</source>
        <translation>FILE - und --presets - würden beide die Standardeingabe lesen; eines davon nehmen</translation>
    </message>
    <message>
        <source>%1 with --set: %2</source>
        <translation>%1 mit --set: %2</translation>
    </message>
    <message>
        <source>%1: note: was solved by %2; this command solves exactly</source>
        <translation>%1: Hinweis: bisherige Lösung: %2; dieser Befehl löst exakt</translation>
    </message>
    <message>
        <source>%1: warning: %2</source>
        <translation>%1: Warnung: %2</translation>
    </message>
    <message>
        <source>--plots %1: `%2` is not a plot format; choose from %3</source>
        <translation>--plots %1: `%2` ist kein Format für Diagramme; möglich sind %3</translation>
    </message>
    <message>
        <source>--plots needs a file to store pictures beside, not %1; give -o FILE.csv</source>
        <translation>--plots: neben %1 ist kein Platz für Bilder; -o FILE.csv angeben</translation>
    </message>
    <message>
        <source>needs --vary KEY=START:STOP:COUNT[:log] or --vary KEY=A,B,C</source>
        <translation>braucht --vary KEY=START:STOP:COUNT[:log] oder --vary KEY=A,B,C</translation>
    </message>
    <message>
        <source>FILE and CASES are both standard input; give a name for one</source>
        <translation>FILE und CASES sind beide die Standardeingabe; für eines einen Namen angeben</translation>
    </message>
    <message>
        <source>--frequency VALUES is --along drill.blow_frequency=VALUES; give one of them</source>
        <translation>--frequency VALUES ist dasselbe wie --along drill.blow_frequency=VALUES; eines davon angeben</translation>
    </message>
    <message>
        <source>pulse.shape is not a number; use sweep for it</source>
        <translation>pulse.shape ist keine Zahl; sweep nimmt es</translation>
    </message>
    <message>
        <source>%1: at most %2 values</source>
        <translation>%1: höchstens %2 Werte</translation>
    </message>
    <message>
        <source>-o writes the table of --along; add --along KEY=START:STOP</source>
        <translation>-o schreibt die Tabelle von --along; --along KEY=START:STOP hinzufügen</translation>
    </message>
    <message>
        <source>unknown option `%1`; see drillwave --help</source>
        <translation>unbekannte Option `%1`; siehe drillwave --help</translation>
    </message>
    <message>
        <source>`%1` is not a command, file or example; did you mean `drillwave %2`?</source>
        <translation>`%1` ist weder ein Befehl noch eine Datei oder ein Beispiel; war `drillwave %2` gemeint?</translation>
    </message>
    <message>
        <source>No such file or command; see drillwave --help</source>
        <translation>keine solche Datei und kein solcher Befehl; siehe drillwave --help</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; the window opens one file</source>
        <translation>`%1` ist zu viel; das Fenster öffnet nur eine Datei</translation>
    </message>
    <message>
        <source>a section that loses everything carries no wave</source>
        <translation>was alles verliert, trägt keine Welle</translation>
    </message>
    <message>
        <source>no design reaches it</source>
        <translation>keine Auslegung erfüllt das</translation>
    </message>
    <message>
        <source>the nearest is %1 of %2</source>
        <translation>am nächsten kommt %2 mit %1</translation>
    </message>
    <message>
        <source>%1; did you mean the example %2?</source>
        <translation>%1; war das Beispiel %2 gemeint?</translation>
    </message>
    <message>
        <source>%1 is beyond the range of double precision: the values are too large or too small</source>
        <translation>%1 liegt außerhalb des Bereichs doppelter Genauigkeit: die Werte sind zu groß oder zu klein</translation>
    </message>
    <message>
        <source>not smooth within the work permitted</source>
        <translation>mit dem erlaubten Aufwand nicht glatt</translation>
    </message>
    <message>
        <source>errors do not vary smoothly</source>
        <translation>ein Fehler, der keinen glatten Verlauf hat</translation>
    </message>
    <message>
        <source>result of many blows, not necessarily smooth: straight lines between points</source>
        <translation>aus vielen Schlägen, die nicht glatt sein müssen: gerade zwischen den Punkten</translation>
    </message>
    <message>
        <source>solved point by point</source>
        <translation>Punkt für Punkt gelöst</translation>
    </message>
    <message>
        <source>other reasons</source>
        <translation>andere Gründe</translation>
    </message>
    <message>
        <source>the table has changed since it was checked: %1</source>
        <translation>die Tabelle hat sich geändert, seit sie geprüft wurde: %1</translation>
    </message>
    <message>
        <source>a step of the lattice is too long for the rock: (beta/gamma) tau/N = %1 must not exceed 2; it takes at least %2 segments</source>
        <translation>ein Schritt des Gitters ist zu lang für das Gestein: (beta/gamma) tau/N = %1 darf 2 nicht überschreiten; es braucht mindestens %2 Segmente</translation>
    </message>
    <message>
        <source>the lattice would need more than the permitted number of steps; use fewer than %1 segments, or the exact method</source>
        <translation>das Gitter bräuchte mehr Schritte als erlaubt; weniger als %1 Segmente oder das exakte Verfahren nehmen</translation>
    </message>
    <message>
        <source>a contact at time %1 is shorter than a step of the lattice; use more segments or the exact method</source>
        <translation>ein Kontakt zur Zeit %1 ist kürzer als ein Schritt des Gitters; mehr Segmente oder das exakte Verfahren nehmen</translation>
    </message>
    <message>
        <source>%1 of blows like this one</source>
        <translation>%1 bei Schlägen wie diesem</translation>
    </message>
    <message>
        <source>from %1 on slope %2</source>
        <translation>ab %1 Steigung %2</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>loading curve</source>
        <translation>Belastungskurve</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>größer als %1</translation>
    </message>
    <message>
        <source>greater than 0, at most %1</source>
        <translation>größer als 0, höchstens %1</translation>
    </message>
    <message>
        <source>required</source>
        <translation>erforderlich</translation>
    </message>
    <message>
        <source>required, or its alternative</source>
        <translation>erforderlich, oder was an seiner Stelle steht</translation>
    </message>
    <message>
        <source>required, or `%1`</source>
        <translation>erforderlich, oder `%1`</translation>
    </message>
    <message>
        <source>optional; default value assumed</source>
        <translation>kann wegbleiben: das Programm nimmt dann einen Wert an</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>kann wegbleiben</translation>
    </message>
    <message>
        <source>scenarios in physical units</source>
        <translation>Szenarien in physikalischen Einheiten</translation>
    </message>
    <message>
        <source>dimensionless scenarios</source>
        <translation>dimensionslose Szenarien</translation>
    </message>
    <message>
        <source>scenarios in physical units; only for many blows</source>
        <translation>Szenarien in physikalischen Einheiten, für viele Schläge: ein einzelner hängt nicht davon ab</translation>
    </message>
    <message>
        <source>drill strings</source>
        <translation>Bohrstränge</translation>
    </message>
    <message>
        <source>drill strings struck by a hammer</source>
        <translation>Bohrstränge, auf die ein Hammer schlägt</translation>
    </message>
    <message>
        <source>uniform rods, with units and without</source>
        <translation>gleichförmige Stangen, mit Einheiten und ohne</translation>
    </message>
    <message>
        <source>uniform rods in physical units</source>
        <translation>gleichförmige Stangen in physikalischen Einheiten</translation>
    </message>
    <message>
        <source>uniform rods in physical units, given by their diameter</source>
        <translation>gleichförmige Stangen in physikalischen Einheiten, gegeben durch ihren Durchmesser</translation>
    </message>
    <message>
        <source>hammer forces in physical units, except piston and table</source>
        <translation>Hammerkräfte in physikalischen Einheiten, außer denen eines Kolbens oder einer Tabelle</translation>
    </message>
    <message>
        <source>hammer forces of the shape `trapezoid`</source>
        <translation>Hammerkräfte der Form `trapezoid`</translation>
    </message>
    <message>
        <source>hammer forces of the shape `piston`, in physical units</source>
        <translation>Hammerkräfte der Form `piston`, in physikalischen Einheiten</translation>
    </message>
    <message>
        <source>hammer forces of the shape `piston`, dimensionless</source>
        <translation>Hammerkräfte der Form `piston`, dimensionslos</translation>
    </message>
    <message>
        <source>a whole number %1</source>
        <translation>eine ganze Zahl %1</translation>
    </message>
    <message>
        <source>rock with `law: %1`</source>
        <translation>Gestein mit `law: %1`</translation>
    </message>
    <message>
        <source>%1 to %2, of `drillwave presets`</source>
        <translation>%1 bis %2, aus `drillwave presets`</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>of</source>
        <translation>gilt für</translation>
    </message>
    <message>
        <source>in files</source>
        <translation>in Dateien</translation>
    </message>
    <message>
        <source>a word</source>
        <translation>ein Wort</translation>
    </message>
    <message>
        <source>one of</source>
        <translation>eines von</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stange</translation>
    </message>
    <message>
        <source>Hammer force</source>
        <translation>Hammerkraft</translation>
    </message>
    <message>
        <source>Material of a drill string</source>
        <translation>Werkstoff eines Bohrstrangs</translation>
    </message>
    <message>
        <source>Hammer of a drill string</source>
        <translation>Hammer eines Bohrstrangs</translation>
    </message>
    <message>
        <source>Bit and rock</source>
        <translation>Bohrkrone und Gestein</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Drill string</source>
        <translation>Bohrstrang</translation>
    </message>
    <message>
        <source>Shape of the hammer force (files §1.1)</source>
        <translation>Form der Hammerkraft (files §1.1)</translation>
    </message>
    <message>
        <source>Loading curve of bit and rock (files §1.4)</source>
        <translation>Belastungskurve von Bohrkrone und Gestein (files §1.4)</translation>
    </message>
    <message>
        <source>Whether every blow meets `fresh` rock or the `same` crater (drilling §4)</source>
        <translation>Ob jeder Schlag auf unberührtes Gestein trifft (`fresh`) oder auf denselben Krater (`same`; drilling §4)</translation>
    </message>
    <message>
        <source>many blows under a feed (drilling)</source>
        <translation>viele Schläge unter einem Vorschub (drilling)</translation>
    </message>
    <message>
        <source>every blow</source>
        <translation>jeden Schlag</translation>
    </message>
    <message>
        <source>uniform rods</source>
        <translation>gleichförmige Stangen</translation>
    </message>
    <message>
        <source>drill strings whose faces have a stiffness</source>
        <translation>Bohrstränge, deren Schlagflächen eine Steifigkeit haben</translation>
    </message>
    <message>
        <source>In the window: %1.</source>
        <translation>Im Fenster: %1.</translation>
    </message>
    <message>
        <source>none: only in SI</source>
        <translation>nichts: das gibt es nur in SI</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>eine reine Zahl</translation>
    </message>
    <message>
        <source>multiple of</source>
        <translation>Vielfaches von</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>All parameters of a scenario: in files, after `--set`, as axis of a study, as a field of the window. The program writes this chapter from its own table. A value outside its range is refused; outside the usual range it gives a warning. Presets are starting points with a source. Format of files: files §1.</source>
        <translation>Jede Zahl eines Szenarios: in Dateien, hinter `--set`, als Achse einer Studie, als Feld im Fenster. Dieses Kapitel schreibt das Programm aus der Tabelle, mit der es arbeitet. Außerhalb seines Bereichs wird ein Wert abgelehnt, außerhalb des üblichen gibt es einen Hinweis; was Voreinstellungen geben, ist ein Ausgangspunkt, mit seiner Quelle. Wie Dateien geschrieben werden: files §1.</translation>
    </message>
    <message>
        <source>Corners of the loading curve</source>
        <translation>Ecken der Belastungskurve</translation>
    </message>
    <message>
        <source>Up to 64, by number.</source>
        <translation>Bis zu 64 davon, nach ihrer Reihenfolge gezählt.</translation>
    </message>
    <message>
        <source>Sections of a drill string</source>
        <translation>Abschnitte eines Bohrstrangs</translation>
    </message>
    <message>
        <source>NAME is the name of sections, or the number of one, from 1; for the hammer, `hammer.1.length` (files §1.3).</source>
        <translation>NAME ist der Name von Abschnitten oder die Stelle eines Abschnitts, von 1 an; beim Hammer `hammer.1.length` (files §1.3).</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Wörter</translation>
    </message>
    <message>
        <source>Whether the hammer may strike again; otherwise it is withdrawn after the first separation</source>
        <translation>Ob der Hammer dableibt und wieder getroffen werden kann; sonst wird er nach der ersten Trennung zurückgezogen</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>All results: keys of JSON, columns of CSV files, names for `--outputs`, rows of the window. The program writes this chapter from its own table. Scales are those of theory §2; for drill strings, W0 and W are the hammer energy E0 and I0 is the momentum p0.</source>
        <translation>Jedes Ergebnis: ein Schlüssel in JSON, eine Spalte in CSV-Dateien, ein Name für `--outputs`, eine Zeile im Fenster. Dieses Kapitel schreibt das Programm aus der Tabelle, mit der es arbeitet. Die Bezugsgrößen sind die von theory §2; bei einem Bohrstrang sind W0 und W die Energie E0 seines Hammers, I0 dessen Impuls p0.</translation>
    </message>
    <message>
        <source>One blow</source>
        <translation>Ein Schlag</translation>
    </message>
    <message>
        <source>Many blows under a feed</source>
        <translation>Viele Schläge unter einem Vorschub</translation>
    </message>
    <message>
        <source>%1 point in %2.</source>
        <translation>%1 Punkt in %2.</translation>
    </message>
    <message>
        <source>%1 points in %2.</source>
        <translation>%1 Punkte in %2.</translation>
    </message>
    <message>
        <source>a section is shorter than a time step: take more (--cells), or leave the section out and add its mass to the section before it</source>
        <translation>ein Abschnitt ist kürzer als eine Zelle der Rechnung: mehr Zellen verwenden (--cells), oder den Abschnitt weglassen und seine Masse dem Abschnitt davor geben</translation>
    </message>
    <message>
        <source>the interval of the blows is %1 times t0 = %2 s, at most %3 are followed; raise the frequency or make the blow longer</source>
        <translation>der Abstand der Schläge ist das %1-fache von t0 = %2 s, verfolgt wird höchstens das %3-fache; die Frequenz erhöhen oder den Schlag verlängern</translation>
    </message>
    <message>
        <source>must be less than the blows, which are %1</source>
        <translation>muss kleiner sein als die Zahl der Schläge, %1</translation>
    </message>
    <message>
        <source>must be more than 0: the damper carries it</source>
        <translation>muss größer als 0 sein: der Dämpfer trägt sie</translation>
    </message>
    <message>
        <source>a goal is a value of one output; choose one output</source>
        <translation>ein Ziel ist der Wert einer Ergebnisgröße; genau eine wählen</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3, not %4</source>
        <translation>%1 muss zwischen %2 und %3 liegen, nicht bei %4</translation>
    </message>
    <message>
        <source>there is no blow %1 of %2</source>
        <translation>es gibt keinen Schlag %1 von %2</translation>
    </message>
    <message>
        <source>a normal gap needs a mean of at least 0 and a deviation from %1 to %2 [d0]</source>
        <translation>ein normalverteilter Spalt braucht einen Mittelwert von mindestens 0 und eine Abweichung von %1 bis %2 [d0]</translation>
    </message>
    <message>
        <source>the lattices of the paper solve only uniform rods</source>
        <translation>die Gitter des Artikels lösen nur gleichförmige Stangen</translation>
    </message>
    <message>
        <source>cells are of drill strings (`drillwave: 2`)</source>
        <translation>Zellen gibt es nur bei Bohrsträngen (`drillwave: 2`)</translation>
    </message>
    <message>
        <source>a sweep needs at least one axis and one output</source>
        <translation>ein Durchlauf braucht mindestens eine Achse und eine Ergebnisgröße</translation>
    </message>
    <message>
        <source>does not apply to this scenario</source>
        <translation>hat in diesem Szenario keine Bedeutung</translation>
    </message>
    <message>
        <source>-o - names no folder for the files; add -o DIR, or --json, which prints to standard output</source>
        <translation>-o - nennt keinen Ordner für die Dateien; -o DIR angeben oder --json, das auf die Standardausgabe schreibt</translation>
    </message>
    <message>
        <source>--histories and --scan cannot be combined: a scan has many sequences; take one of them</source>
        <translation>--histories gilt für die Schläge einer Folge, und --scan rechnet für jeden Wert eine; nur eines von beiden angeben</translation>
    </message>
    <message>
        <source>a uniform rod has no sections; they belong to `drillwave: 2`</source>
        <translation>darf bei einer gleichförmigen Stange keine Abschnitte haben: sie gehören zu `drillwave: 2`</translation>
    </message>
    <message>
        <source>%1: another process writes these rows; wait for it, or end it</source>
        <translation>%1: ein anderer Prozess schreibt diese Zeilen; auf ihn warten oder ihn beenden</translation>
    </message>
    <message>
        <source>%1: belongs to another run (other options, inputs or build); use --force to start again, or choose another name</source>
        <translation>%1: gehört zu einem anderen Lauf (andere Optionen, Eingaben oder anderes Programm); mit --force neu beginnen oder einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>has no checksum, or was changed after it was written</source>
        <translation>hat keine Prüfsumme oder wurde verändert, nachdem es geschrieben war</translation>
    </message>
    <message>
        <source>has no whole number `%1`</source>
        <translation>hat keine ganze Zahl `%1`</translation>
    </message>
    <message>
        <source>has no `%1`</source>
        <translation>hat kein `%1`</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>es ist eine Verknüpfung</translation>
    </message>
    <message>
        <source>%1: this lock of the folder cannot be opened: %2; remove it or choose another folder</source>
        <translation>%1: diese Sperre des Ordners kann nicht geöffnet werden: %2; sie löschen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>This report was written with --no-plots, so it has no plots. Write it again without that option to get them.</source>
        <translation>Die Diagramme fehlen, weil dieser Bericht mit --no-plots geschrieben wurde. Ohne diese Option noch einmal geschrieben, enthält er sie.</translation>
    </message>
    <message>
        <source>%1 is true or false, so it cannot be an axis; give it with --set</source>
        <translation>%1 ist wahr oder falsch (true, false) und damit keine Achse; mit --set angeben</translation>
    </message>
    <message>
        <source>--samples %1: rounded up to %2, a power of two</source>
        <translation>--samples %1: nimmt %2, eine Zweierpotenz</translation>
    </message>
    <message>
        <source>there is no drillwave-window beside this program; install the package drillwave, or build the program with DRILLWAVE_GUI=ON</source>
        <translation>neben diesem Programm gibt es kein drillwave-window; das Paket drillwave installieren oder das Programm mit DRILLWAVE_GUI=ON bauen</translation>
    </message>
    <message>
        <source>no window: %1; without it use `drillwave run FILE` (see --help)</source>
        <translation>kein Fenster: %1; ohne dieses `drillwave run FILE` verwenden (siehe --help)</translation>
    </message>
    <message>
        <source>no pictures: %1; without it leave out --plots, and write a report with --no-plots</source>
        <translation>keine Bilder: %1; ohne dieses --plots weglassen und einen Bericht mit --no-plots schreiben</translation>
    </message>
    <message>
        <source>the window cannot be opened on the platform of -platform or QT_QPA_PLATFORM; use `drillwave run FILE` or `-platform offscreen`</source>
        <translation>das Fenster kann auf der Plattform von -platform oder QT_QPA_PLATFORM nicht geöffnet werden; `drillwave run FILE` oder `-platform offscreen` verwenden</translation>
    </message>
    <message>
        <source>display %1 cannot be reached; set DISPLAY to an available one, use `drillwave run FILE` (see --help), or `drillwave -platform offscreen`</source>
        <translation>die Anzeige %1 ist nicht erreichbar; DISPLAY auf eine vorhandene setzen, `drillwave run FILE` (siehe --help) oder `drillwave -platform offscreen` verwenden</translation>
    </message>
    <message>
        <source>there are no fonts for the letters of the pictures; install some (Debian: apt install fonts-dejavu-core), or leave out the pictures</source>
        <translation>es gibt keine Schriften für die Beschriftung der Bilder; welche installieren (Debian: apt install fonts-dejavu-core) oder die Bilder weglassen</translation>
    </message>
    <message>
        <source>Usage: drillwave %1
</source>
        <translation>Aufruf: drillwave %1
</translation>
    </message>
    <message>
        <source>option</source>
        <translation>Option</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>bewirkt</translation>
    </message>
    <message>
        <source>commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>topics</source>
        <translation>was dort steht</translation>
    </message>
    <message>
        <source>The manual has `%1` in these places, the best first:</source>
        <translation>Im Handbuch kommt `%1` an diesen Stellen vor, die besten zuerst:</translation>
    </message>
    <message>
        <source>Parameters and outputs: %1.</source>
        <translation>Parameter und Ergebnisse: %1.</translation>
    </message>
    <message>
        <source>See also %1.</source>
        <translation>Siehe auch %1.</translation>
    </message>
    <message>
        <source>%1: differs from its record: it has %2 bytes with checksum %3, written were %4 and %5; it was changed or is another part, so run it again</source>
        <translation>%1: ist nicht, was sein Protokoll sagt: hat %2 Bytes mit der Prüfsumme %3, geschrieben wurden %4 mit %5; die Datei wurde verändert oder ist ein anderer Teil, ihn noch einmal rechnen</translation>
    </message>
    <message>
        <source>has no parts of --shard with their records</source>
        <translation>hat keine Teile von --shard mit ihren Protokollen</translation>
    </message>
    <message>
        <source>a map needs KEY=START:STOP:COUNT or KEY=START:STOP:COUNT:log; `drillwave sweep` takes a list</source>
        <translation>eine Karte braucht KEY=START:STOP:COUNT oder KEY=START:STOP:COUNT:log; eine Liste nimmt `drillwave sweep`</translation>
    </message>
    <message>
        <source>waiting for another run of drillwave, which holds the lock %1; Ctrl-C stops waiting</source>
        <translation>wartet auf einen anderen Lauf von drillwave, der die Sperre %1 hält; Strg-C bricht ab</translation>
    </message>
    <message>
        <source>--no-plots: a PDF is drawn with its plots; give -o FILE.html</source>
        <translation>--no-plots: ein PDF wird mit seinen Diagrammen gezeichnet; -o FILE.html angeben</translation>
    </message>
    <message>
        <source>--resume applies to the file of -o; add -o FILE.csv</source>
        <translation>--resume gilt für die Datei von -o; -o FILE.csv angeben</translation>
    </message>
    <message>
        <source>%1 needs the rows in one run; leave out --resume</source>
        <translation>%1 braucht die Zeilen aus einem Lauf; --resume weglassen</translation>
    </message>
    <message>
        <source>%1 rows take about %2 and %3. An interrupted run keeps no rows; with --resume it keeps finished rows, with --shard I/N finished parts</source>
        <translation>%1 Zeilen brauchen etwa %2 und %3. Ein Lauf, der vorzeitig endet, hinterlässt keine Zeilen, mit --resume aber die fertigen und mit --shard I/N die fertigen Teile</translation>
    </message>
    <message>
        <source>%1: %2 rows take about %3, and the disk has %4 free; take fewer rows, or write parts (--shard I/N) to several disks</source>
        <translation>%1: %2 Zeilen brauchen etwa %3, frei sind auf der Platte %4; weniger Zeilen nehmen oder Teile (--shard I/N) auf mehrere Platten schreiben</translation>
    </message>
    <message>
        <source>%1 of %2 rows could not be solved: their output cells are empty</source>
        <translation>%1 von %2 Zeilen ließen sich nicht lösen: ihre Ergebniszellen sind leer</translation>
    </message>
    <message>
        <source>%1: has all of these rows already</source>
        <translation>%1: hat alle diese Zeilen schon</translation>
    </message>
    <message>
        <source>interrupted; %1 of %2 rows are kept in %3; the same command continues after them</source>
        <translation>unterbrochen; %1 von %2 Zeilen stehen in %3, derselbe Befehl geht dahinter weiter</translation>
    </message>
    <message>
        <source>Keep the present design, %1: none of the %2 designs compared is better (%3 = %4).</source>
        <translation>Die jetzige Auslegung behalten, %1: keine der %2 verglichenen ist besser (%3 = %4).</translation>
    </message>
    <message>
        <source>Choose the design %1, which gives %2 = %3.</source>
        <translation>Die Auslegung %1 wählen; sie gibt %2 = %3.</translation>
    </message>
    <message>
        <source>feed required</source>
        <translation>Andruck erforderlich</translation>
    </message>
    <message>
        <source>+- is the 95 % error: the scatter of the blows plus three times the change with half or twice the time step. Penetrations are upper limits: all rock under the bit breaks and cuttings are removed.</source>
        <translation>+- enthält die Streuung der Schläge und das Dreifache dessen, was halb oder doppelt so viele Zellen ändern. Eindringungen sind obere Grenzen: alles Gestein unter der Bohrkrone gibt nach, und das Bohrklein verschwindet.</translation>
    </message>
    <message>
        <source>The single-blow estimate does not apply: the waves of a blow are still in the string at the next blow.</source>
        <translation>Die Schätzung aus einem Schlag gilt nicht: die Wellen eines Schlags sind noch im Strang, wenn der nächste kommt.</translation>
    </message>
    <message>
        <source>The feed force of %1 is less than the mean force of the blows, %2: the machine is pushed back.</source>
        <translation>Der Andruck von %1 ist kleiner als die mittlere Kraft der Schläge, %2: die Maschine weicht zurück.</translation>
    </message>
    <message>
        <source>A feed force of %1 is below the %2 that this blow requires: penetration will probably be lost.</source>
        <translation>Ein Andruck von %1 liegt unter den %2, die dieser Schlag erfordert: wahrscheinlich geht Eindringung verloren.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %2, this blow requires at least %1.</source>
        <translation>Es ist kein Andruck angegeben. Bei einer Schlagfrequenz von %2 erfordert dieser Schlag mindestens %1.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %2, this blow requires at least %1, and blows at other gaps or on rigid rock up to %3.</source>
        <translation>Es ist kein Andruck angegeben. Bei einer Schlagfrequenz von %2 erfordert dieser Schlag mindestens %1, Schläge bei anderen Spalten oder auf starres Gestein bis zu %3.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %2, this blow requires at least %1, and rigid rock at least %3.</source>
        <translation>Es ist kein Andruck angegeben. Bei einer Schlagfrequenz von %2 erfordert dieser Schlag mindestens %1, starres Gestein mindestens %3.</translation>
    </message>
    <message>
        <source>The feed cannot be judged: give a blow frequency and a feed force.</source>
        <translation>Der Vorschub wird nicht beurteilt: Schlagfrequenz und Andruck angeben.</translation>
    </message>
    <message>
        <source>The required feed force is estimated from single blows; %1 solves consecutive blows.</source>
        <translation>Der erforderliche Andruck ist aus einzelnen Schlägen geschätzt; %1 simuliert aufeinanderfolgende Schläge.</translation>
    </message>
    <message>
        <source>installed feed force %1</source>
        <translation>installierter Andruck %1</translation>
    </message>
    <message>
        <source>effective feed force %1 (installed %2, less %3 of weight along the hole)</source>
        <translation>wirksamer Andruck %1 (installiert %2, abzüglich %3 Gewicht längs des Bohrlochs)</translation>
    </message>
    <message>
        <source>effective feed force %1 (installed %2, and %3 of weight along the hole)</source>
        <translation>wirksamer Andruck %1 (installiert %2, und %3 Gewicht längs des Bohrlochs)</translation>
    </message>
    <message>
        <source>Friction, rotation and buckling are not modelled.</source>
        <translation>Reibung, Drehung und Knicken sind nicht modelliert.</translation>
    </message>
    <message>
        <source>Required feed</source>
        <translation>Erforderlicher Andruck</translation>
    </message>
    <message>
        <source>no wave loss is defined</source>
        <translation>kein Wellenverlust angegeben ist</translation>
    </message>
    <message>
        <source>the motion is irregular</source>
        <translation>die Bewegung unregelmäßig ist</translation>
    </message>
    <message>
        <source>only few blows were followed</source>
        <translation>nur wenige Schläge verfolgt wurden</translation>
    </message>
    <message>
        <source>the lengths are not whole numbers of time steps</source>
        <translation>die Längen keine ganze Zahl von Zeitschritten sind</translation>
    </message>
    <message>
        <source>Give a wave loss (%1): waves usually lose 1 to 30 % in each round trip.</source>
        <translation>Einen Wellenverlust angeben (%1): üblich sind 1 bis 30&#xa0;% je Hin- und Rücklauf.</translation>
    </message>
    <message>
        <source>Increase the number of blows (%1) to reduce the error of the mean penetration.</source>
        <translation>Die Zahl der Schläge (%1) erhöhen, um den Fehler der mittleren Eindringung zu verkleinern.</translation>
    </message>
    <message>
        <source>To reduce the error, use shorter time steps, or make the section lengths multiples of a common length.</source>
        <translation>Um den Fehler zu verkleinern, kürzere Zeitschritte verwenden oder die Abschnittslängen zu Vielfachen einer gemeinsamen Länge machen.</translation>
    </message>
    <message>
        <source>The bit penetrates %1 per blow, at a penetration rate of %2.</source>
        <translation>Die Bohrkrone dringt %1 je Schlag ein, bei einem Bohrfortschritt von %2.</translation>
    </message>
    <message>
        <source>The bit penetrates %1 per blow. The penetration rate of %2 is %3 of the rate that single blows from rest would give.</source>
        <translation>Die Bohrkrone dringt %1 je Schlag ein. Der Bohrfortschritt von %2 ist %3 dessen, was einzelne Schläge aus der Ruhe gäben.</translation>
    </message>
    <message>
        <source>The blows push the machine back without limit: increase the feed force.</source>
        <translation>Die Schläge drücken die Maschine ohne Grenze zurück: den Andruck erhöhen.</translation>
    </message>
    <message>
        <source>a feed force of %1</source>
        <translation>einem Andruck von %1</translation>
    </message>
    <message>
        <source>All values from %1 to %2 give the same penetration rate within the errors of the computation.</source>
        <translation>Alle Werte von %1 bis %2 ergeben im Rahmen der Rechenfehler denselben Bohrfortschritt.</translation>
    </message>
    <message>
        <source>a constant force</source>
        <translation>konstanter Kraft</translation>
    </message>
    <message>
        <source>The mean penetration per blow is inaccurate: its error is above %1, because %2.</source>
        <translation>Die mittlere Eindringung je Schlag ist ungenau: ihr Fehler liegt über %1, weil %2.</translation>
    </message>
    <message>
        <source>In %1 of the blows, the bit is in contact with the rock when the blow arrives.</source>
        <translation>Bei %1 der Schläge liegt die Bohrkrone am Gestein an, wenn der Schlag ankommt.</translation>
    </message>
    <message>
        <source>The connection between machine and rod is modelled as %1, which is an assumption.</source>
        <translation>Die Verbindung von Maschine und Stange ist mit %1 modelliert; das ist eine Annahme.</translation>
    </message>
    <message>
        <source>The connection between machine and rod is modelled as %1.</source>
        <translation>Die Verbindung von Maschine und Stange ist mit %1 modelliert.</translation>
    </message>
    <message>
        <source>All values of the scan give the same penetration rate, %1, within the errors of the computation.</source>
        <translation>Alle untersuchten Werte ergeben im Rahmen der Rechenfehler denselben Bohrfortschritt, %1.</translation>
    </message>
    <message>
        <source>Margin over the largest of the four required forces (%1): %2.</source>
        <translation>Reserve gegenüber der größten der vier erforderlichen Kräfte (%1): %2.</translation>
    </message>
    <message>
        <source>Margin over the larger of the two required forces (%1): %2.</source>
        <translation>Reserve gegenüber der größeren der beiden erforderlichen Kräfte (%1): %2.</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>return in time</source>
        <translation>rechtzeitig zurück</translation>
    </message>
    <message>
        <source>The impulse of a blow is that from hammer to string. For drill strings, only the gap entered and rigid rock are examined.</source>
        <translation>Der Kraftstoß eines Schlags ist der vom Hammer auf den Strang. Bei Bohrsträngen werden nur der eingegebene Spalt und starres Gestein untersucht.</translation>
    </message>
    <message>
        <source>sequences of blows</source>
        <translation>Schlagfolgen</translation>
    </message>
    <message>
        <source>all results: cones are solved more exactly</source>
        <translation>alle Ergebnisse, wegen der Kegel</translation>
    </message>
    <message>
        <source>cor and required feed: losses are counted</source>
        <translation>cor und der erforderliche Andruck, wegen der Verluste</translation>
    </message>
    <message>
        <source>contact shares</source>
        <translation>Anteile im Kontakt</translation>
    </message>
    <message>
        <source>statements about the feed</source>
        <translation>Aussagen über den Vorschub</translation>
    </message>
    <message>
        <source>energies, which are in J beside SI</source>
        <translation>Energien, neben SI in J</translation>
    </message>
    <message>
        <source>Written by Drillwave %1. Since then these results have changed: %2 (manual, Upgrading).</source>
        <translation>Geschrieben von Drillwave %1. Seither haben sich geändert: %2 (Handbuch, Kapitel Upgrading).</translation>
    </message>
    <message>
        <source>%1: note: %2</source>
        <translation>%1: Hinweis: %2</translation>
    </message>
    <message>
        <source>presets need physical units, and this scenario is given by its dimensionless groups; choose a group such as beta</source>
        <translation>Voreinstellungen brauchen physikalische Einheiten, und dieses Szenario ist durch seine dimensionslosen Kennzahlen gegeben; wählen Sie eine Kennzahl wie beta</translation>
    </message>
    <message>
        <source>a uniform rod has no bit; use a drill string</source>
        <translation>eine gleichförmige Stange hat keine Bohrkrone; ein Bohrstrang hat eine</translation>
    </message>
    <message>
        <source>the string does not end with a section called bit; name its last section so</source>
        <translation>der Strang endet nicht mit einem Abschnitt namens bit; geben Sie seinem letzten Abschnitt diesen Namen</translation>
    </message>
    <message>
        <source>a preset of a rod is for uniform rods, and this scenario is a drill string; choose sizes such as string.rod.diameter</source>
        <translation>eine Voreinstellung für eine Stange gilt für gleichförmige Stangen, und dieses Szenario ist ein Bohrstrang; wählen Sie Maße wie string.rod.diameter</translation>
    </message>
    <message>
        <source>this drill string is struck by a prescribed force, which no preset replaces; choose numbers such as pulse.duration</source>
        <translation>auf diesen Bohrstrang schlägt eine vorgegebene Kraft, die keine Voreinstellung ersetzt; wählen Sie Zahlen wie pulse.duration</translation>
    </message>
    <message>
        <source>The blow energy differs by up to %1 % between the designs: hammers of different power are compared.</source>
        <translation>Die Schlagenergie der Auslegungen unterscheidet sich um bis zu %1&#xa0;%: es werden Hämmer verschiedener Leistung verglichen.</translation>
    </message>
    <message>
        <source>Change the design from %1 to %2, which gives %3 = %4. The present design does not meet all limits.</source>
        <translation>Die Auslegung von %1 auf %2 ändern; das gibt %3 = %4. Die jetzige Auslegung hält nicht alle Grenzen ein.</translation>
    </message>
    <message>
        <source>Change %1 from %2 to %3, which gives %4 = %5. The present design does not meet all limits.</source>
        <translation>%1 von %2 auf %3 ändern; das gibt %4 = %5. Die jetzige Auslegung hält nicht alle Grenzen ein.</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>Warning for %1: %2</source>
        <translation>Warnung zu %1: %2</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>senkrechter Strich</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>from the table</source>
        <translation>aus der Tabelle</translation>
    </message>
    <message>
        <source>from the option</source>
        <translation>aus der Option</translation>
    </message>
    <message>
        <source>an estimate</source>
        <translation>eine Schätzung</translation>
    </message>
    <message>
        <source>Which unit has the signal? Volts also need --scale 50kN/V, or --excitation, --gain, --bridge and --gauge-factor</source>
        <translation>In welcher Einheit ist das Signal? Volt brauchen auch --scale 50kN/V oder --excitation, --gain, --bridge und --gauge-factor</translation>
    </message>
    <message>
        <source>What is the sampling rate?</source>
        <translation>Wie groß ist die Abtastrate?</translation>
    </message>
    <message>
        <source>Which unit have the times?</source>
        <translation>In welcher Einheit sind die Zeiten?</translation>
    </message>
    <message>
        <source>Which column is the signal? Several are possible</source>
        <translation>Welche Spalte ist das Signal? Mehrere kommen in Frage</translation>
    </message>
    <message>
        <source>Is the comma in 1,234 a decimal sign or a thousands separator?</source>
        <translation>Ist das Zeichen in 1,234 ein Dezimalzeichen oder trennt es Tausender?</translation>
    </message>
    <message>
        <source>What is the area of the bar at the gauge?</source>
        <translation>Wie groß ist die Fläche des Stabs am Messstreifen?</translation>
    </message>
    <message>
        <source>What is Young&apos;s modulus of the bar?</source>
        <translation>Wie groß ist der Elastizitätsmodul des Stabs?</translation>
    </message>
    <message>
        <source>How many gauges of the bridge are active?</source>
        <translation>Wie viele Messstreifen der Brücke sind aktiv?</translation>
    </message>
    <message>
        <source>What is the gauge factor?</source>
        <translation>Wie groß ist der k-Faktor?</translation>
    </message>
    <message>
        <source>What is the impedance of the bar? Give it as 18kN s/m</source>
        <translation>Wie groß ist die Impedanz des Stabs? Geben Sie sie als 18kN s/m an</translation>
    </message>
    <message>
        <source>times of day, as s since the first</source>
        <translation>Uhrzeiten, als s seit der ersten</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>column %1, %2, %3</source>
        <translation>Spalte %1, %2, %3</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>keine Einheit</translation>
    </message>
    <message>
        <source>evenly spaced, %1, %2</source>
        <translation>gleichmäßig, %1, %2</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>keine Rate</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>%1, separator %2, decimal sign %3, samples from line %4</source>
        <translation>%1, Trennzeichen %2, Dezimalzeichen %3, Abtastwerte ab Zeile %4</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Stichproben</translation>
    </message>
    <message>
        <source>%1, one in %2, from %3 on</source>
        <translation>%1, einer je %2, ab %3</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>record</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>there is a row without values between the cases; delete it</source>
        <translation>eine Zeile ohne Werte steht zwischen den Fällen; löschen Sie sie</translation>
    </message>
    <message>
        <source>must be one of tab, semicolon, comma, bar, blank</source>
        <translation>muss eines von tab, semicolon, comma, bar, blank sein</translation>
    </message>
    <message>
        <source>must be point or comma</source>
        <translation>muss point oder comma sein</translation>
    </message>
    <message>
        <source>must be one of utf-8, windows-1252, latin-1, utf-16le, utf-16be</source>
        <translation>muss eines von utf-8, windows-1252, latin-1, utf-16le, utf-16be sein</translation>
    </message>
    <message>
        <source>must be the name of a column, or its number from 1</source>
        <translation>muss der Name einer Spalte sein oder ihre Nummer ab 1</translation>
    </message>
    <message>
        <source>must be a unit of time, one of %1</source>
        <translation>muss eine Zeiteinheit sein, eine von %1</translation>
    </message>
    <message>
        <source>must be a unit of a signal, one of %1</source>
        <translation>muss eine Einheit eines Signals sein, eine von %1</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>muss über 0 sein</translation>
    </message>
    <message>
        <source>must be two times A:B, as in -50us:-10us</source>
        <translation>müssen zwei Zeiten A:B sein, wie in -50us:-10us</translation>
    </message>
    <message>
        <source>the first time must be before the second one</source>
        <translation>die erste Zeit muss vor der zweiten liegen</translation>
    </message>
    <message>
        <source>must be a factor that is not 0, or a force per unit: 2.5, 50kN/V, 18kN s/m</source>
        <translation>muss ein Faktor sein, der nicht 0 ist, oder eine Kraft je Einheit: 2.5, 50kN/V, 18kN s/m</translation>
    </message>
    <message>
        <source>must be refuse or skip</source>
        <translation>muss refuse oder skip sein</translation>
    </message>
    <message>
        <source>%1 equal samples at the largest value, %2: clipped?</source>
        <translation>%1 gleiche Abtastwerte beim größten Wert, %2: abgeschnitten?</translation>
    </message>
    <message>
        <source>before the blow the record is at %1 of its peak: set the zero line</source>
        <translation>vor dem Schlag steht die Aufzeichnung bei %1 ihrer Spitze: Setzen Sie die Nulllinie</translation>
    </message>
    <message>
        <source>the zero line drifts by %1 of the peak per ms</source>
        <translation>die Nulllinie driftet um %1 der Spitze je ms</translation>
    </message>
    <message>
        <source>the resolution of the recorder is %1 of the peak, coarser than the noise: use a smaller range</source>
        <translation>der Rekorder hat Stufen von %1 der Spitze, und das Rauschen ist kleiner: Nehmen Sie einen kleineren Messbereich</translation>
    </message>
    <message>
        <source>time steps differ from the usual step by up to %1</source>
        <translation>Zeitschritte weichen um bis zu %1 vom üblichen ab</translation>
    </message>
    <message>
        <source>the record holds %1 blows: choose one by its range of time</source>
        <translation>die Aufzeichnung enthält %1 Schläge: Wählen Sie einen durch seinen Zeitbereich</translation>
    </message>
    <message>
        <source>opposite gauges differ: half their difference is %1 of the peak (rms); check for bending or a loose gauge</source>
        <translation>gegenüberliegende Messstreifen unterscheiden sich: Ihre halbe Differenz ist %1 der Spitze (Effektivwert); ist der Stab gebogen oder ein Streifen lose?</translation>
    </message>
    <message>
        <source>the times have a gap of %1</source>
        <translation>die Zeiten haben eine Lücke von %1</translation>
    </message>
    <message>
        <source>this is not a table: it is %1</source>
        <translation>das ist keine Tabelle: Es ist %1</translation>
    </message>
    <message>
        <source>each channel is a row: the table was transposed, lines count its columns</source>
        <translation>jeder Kanal ist eine Zeile: Die Tabelle ist gedreht, Zeilennummern zählen ihre Spalten</translation>
    </message>
    <message>
        <source>no line of numbers is found in the first %1 lines; is it a table of samples? Give --separator, --decimal or --first-line</source>
        <translation>in den ersten %1 Zeilen steht keine Zeile mit Zahlen; ist es eine Tabelle von Abtastwerten? Geben Sie --separator, --decimal oder --first-line an</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>there is no column `%1`; there are: %2</source>
        <translation>es gibt keine Spalte `%1`; es gibt: %2</translation>
    </message>
    <message>
        <source>column %1 cannot be time and signal; choose another by --signal-column</source>
        <translation>Spalte %1 kann nicht Zeit und Signal sein; wählen Sie eine andere mit --signal-column</translation>
    </message>
    <message>
        <source>%1 (--rows skip)</source>
        <translation>%1 (--rows skip)</translation>
    </message>
    <message>
        <source>NUL bytes end the table: the recorder did not fill its file</source>
        <translation>NUL-Bytes beenden die Tabelle: Der Rekorder hat seine Datei nicht gefüllt</translation>
    </message>
    <message>
        <source>%1 rows without a number are skipped, the first is line %2</source>
        <translation>%1 Zeilen ohne Zahl werden übergangen, die erste ist Zeile %2</translation>
    </message>
    <message>
        <source>%1 of them are marked as overload of the recorder</source>
        <translation>%1 davon sagen, dass der Rekorder übersteuert war</translation>
    </message>
    <message>
        <source>skipped rows leave a gap of %1 in the blow, from %2: it is filled by a straight line</source>
        <translation>übergangene Zeilen hinterlassen eine Lücke von %1 im Schlag, ab %2: Geraden überbrücken sie</translation>
    </message>
    <message>
        <source>no sample lies between the times of --zero, %1 and %2</source>
        <translation>zwischen den Zeiten von --zero, %1 und %2, liegt kein Abtastwert</translation>
    </message>
    <message>
        <source>an Excel workbook (.xlsx); save the sheet as CSV</source>
        <translation>eine Excel-Arbeitsmappe (.xlsx); speichern Sie das Blatt als CSV</translation>
    </message>
    <message>
        <source>an OpenDocument spreadsheet (.ods); save the sheet as CSV</source>
        <translation>eine OpenDocument-Tabelle (.ods); speichern Sie das Blatt als CSV</translation>
    </message>
    <message>
        <source>a zip archive; unpack it first</source>
        <translation>ein Zip-Archiv; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>compressed by gzip; unpack it first</source>
        <translation>mit gzip komprimiert; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>compressed by bzip2; unpack it first</source>
        <translation>mit bzip2 komprimiert; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>compressed by xz; unpack it first</source>
        <translation>mit xz komprimiert; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>a 7-Zip archive; unpack it first</source>
        <translation>ein 7-Zip-Archiv; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>compressed by zstd; unpack it first</source>
        <translation>mit zstd komprimiert; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>an old Excel workbook (.xls); save the sheet as CSV</source>
        <translation>eine alte Excel-Arbeitsmappe (.xls); speichern Sie das Blatt als CSV</translation>
    </message>
    <message>
        <source>an HDF5 file (MATLAB 7.3 also writes it); export the channels as CSV</source>
        <translation>eine HDF5-Datei (auch MATLAB 7.3 schreibt sie); exportieren Sie die Kanäle als CSV</translation>
    </message>
    <message>
        <source>a MATLAB file; export the channels as CSV</source>
        <translation>eine MATLAB-Datei; exportieren Sie die Kanäle als CSV</translation>
    </message>
    <message>
        <source>a TDMS file; export the channels as CSV</source>
        <translation>eine TDMS-Datei; exportieren Sie die Kanäle als CSV</translation>
    </message>
    <message>
        <source>a NumPy array; write it by numpy.savetxt</source>
        <translation>ein NumPy-Feld; schreiben Sie es mit numpy.savetxt</translation>
    </message>
    <message>
        <source>a Parquet file; export the columns as CSV</source>
        <translation>eine Parquet-Datei; exportieren Sie die Spalten als CSV</translation>
    </message>
    <message>
        <source>an SQLite database; export a table as CSV</source>
        <translation>eine SQLite-Datenbank; exportieren Sie eine Tabelle als CSV</translation>
    </message>
    <message>
        <source>a PDF document, not a table</source>
        <translation>ein PDF-Dokument, keine Tabelle</translation>
    </message>
    <message>
        <source>a document in RTF; save it as plain text</source>
        <translation>ein RTF-Dokument; speichern Sie es als reinen Text</translation>
    </message>
    <message>
        <source>a picture, not a table</source>
        <translation>ein Bild, keine Tabelle</translation>
    </message>
    <message>
        <source>a sound or video file (RIFF); export samples as CSV</source>
        <translation>eine Ton- oder Videodatei (RIFF); exportieren Sie die Abtastwerte als CSV</translation>
    </message>
    <message>
        <source>text in UTF-32; save it as UTF-8</source>
        <translation>Text in UTF-32; speichern Sie ihn als UTF-8</translation>
    </message>
    <message>
        <source>an XML document; save the sheet as CSV</source>
        <translation>ein XML-Dokument; speichern Sie das Blatt als CSV</translation>
    </message>
    <message>
        <source>a web page; save the table as CSV</source>
        <translation>eine Webseite; speichern Sie die Tabelle als CSV</translation>
    </message>
    <message>
        <source>is not a bit; give the preset of a bit</source>
        <translation>ist keine Bohrkrone; geben Sie die Voreinstellung einer Bohrkrone an</translation>
    </message>
    <message>
        <source>is not a rod; give the preset of a rod</source>
        <translation>ist keine Stange; geben Sie die Voreinstellung einer Stange an</translation>
    </message>
    <message>
        <source>does not fit a drill string; give the preset of a piston</source>
        <translation>passt nicht zu einem Bohrstrang, dessen Hammer mitgerechnet wird; geben Sie die Voreinstellung eines Kolbens an</translation>
    </message>
    <message>
        <source>does not fit a uniform rod; give the preset of a hammer</source>
        <translation>passt nicht zu einer gleichförmigen Stange, deren Hammer eine Kraft ist; geben Sie die Voreinstellung eines Hammers an</translation>
    </message>
    <message>
        <source>must be a list of texts, each after a `-`</source>
        <translation>muss eine Liste von Texten sein, jeder nach einem `-`</translation>
    </message>
    <message>
        <source>has an item that is not text</source>
        <translation>hat einen Eintrag, der kein Text ist</translation>
    </message>
    <message>
        <source>holds no header `%1`</source>
        <translation>hat keine Kopfzeile `%1`</translation>
    </message>
    <message>
        <source>each channel is a row; run `drillwave signal FILE -o blow.csv` and use blow.csv</source>
        <translation>jeder Kanal ist eine Zeile; schreiben Sie `drillwave signal FILE -o blow.csv` und nehmen Sie diese Datei</translation>
    </message>
    <message>
        <source>1,234 can be a decimal number or a thousand: write one number with another count of decimals, such as 0,5 or 0.5</source>
        <translation>1,234 kann eine Zahl mit Dezimalen oder ein Tausender sein: Schreiben Sie eine Zahl mit einer anderen Anzahl von Dezimalen, etwa 0,5 oder 0.5</translation>
    </message>
    <message>
        <source>several columns could be the force, %1 is one; leave the others out</source>
        <translation>mehrere Spalten könnten die Kraft sein, %1 ist eine; lassen Sie die anderen weg</translation>
    </message>
    <message>
        <source>%1 is not a force; `--signal FILE` and the import convert strains and volts</source>
        <translation>%1 ist keine Kraft; `--signal FILE` und der Import machen eine aus Dehnungen und Volt</translation>
    </message>
    <message>
        <source>is not a file of recorders; it must begin with `drillwave_recorders: 1`</source>
        <translation>ist keine Datei von Rekordern; sie muss mit `drillwave_recorders: 1` beginnen</translation>
    </message>
    <message>
        <source>`%1` is not a known key; only `recorders` is</source>
        <translation>`%1` ist kein bekannter Schlüssel; nur `recorders` ist einer</translation>
    </message>
    <message>
        <source>must be a list of recorders with settings</source>
        <translation>müssen Namen von Rekordern mit Einstellungen sein</translation>
    </message>
    <message>
        <source>must be settings, each `option: value`</source>
        <translation>müssen Einstellungen sein, jede `option: value`</translation>
    </message>
    <message>
        <source>`%1` is not an option of drillwave signal</source>
        <translation>`%1` ist keine Option von drillwave signal</translation>
    </message>
    <message>
        <source>the recorder `%1` is given twice</source>
        <translation>der Rekorder `%1` steht zweimal da</translation>
    </message>
    <message>
        <source>not YAML: this line is indented by a tab; indent it by blanks</source>
        <translation>kein YAML: Diese Zeile ist mit einem Tabulator eingerückt; rücken Sie sie mit Leerzeichen ein</translation>
    </message>
    <message>
        <source>-o takes one record; give one FILE</source>
        <translation>-o nimmt eine Aufzeichnung; geben Sie eine FILE an</translation>
    </message>
    <message>
        <source>the file of recorders %1</source>
        <translation>die Datei der Rekorder %1</translation>
    </message>
    <message>
        <source>--recorder %1: is not known; did you mean `%2`?</source>
        <translation>--recorder %1: ist nicht bekannt; meinten Sie `%2`?</translation>
    </message>
    <message>
        <source>--recorder %1: is not known; --save-recorder %1 keeps options in %2</source>
        <translation>--recorder %1: ist nicht bekannt; --save-recorder %1 bewahrt Optionen in %2 auf</translation>
    </message>
    <message>
        <source>--from must be before --to</source>
        <translation>--from muss vor --to liegen</translation>
    </message>
    <message>
        <source>--save-recorder needs a name, this one is empty</source>
        <translation>--save-recorder braucht einen Namen, dieser ist leer</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>%1 applies to a record; add --signal FILE</source>
        <translation>%1 betrifft eine Aufzeichnung; fügen Sie --signal FILE hinzu</translation>
    </message>
    <message>
        <source>is given by its dimensionless groups; --signal needs physical units</source>
        <translation>ist durch seine dimensionslosen Größen gegeben; --signal braucht physikalische Einheiten</translation>
    </message>
    <message>
        <source>the table does not state: %1; give %2, see drillwave signal</source>
        <translation>die Tabelle lässt offen: %1; antworten Sie mit %2, siehe drillwave signal</translation>
    </message>
    <message>
        <source>%1: note: %2 of %3 samples are kept, impulse and e to 1e-4; --all-samples keeps all</source>
        <translation>%1: Hinweis: %2 von %3 Abtastwerten bleiben, Kraftstoß und e auf 1e-4; --all-samples behält alle</translation>
    </message>
    <message>
        <source>is not text</source>
        <translation>ist kein Text</translation>
    </message>
    <message>
        <source>needs at least two rows of numbers below the header</source>
        <translation>unter der Kopfzeile werden zwei Zeilen mit Zahlen gebraucht</translation>
    </message>
    <message>
        <source>Between bit and rock when the hammer strikes</source>
        <translation>Zwischen Bohrkrone und Gestein, wenn der Hammer schlägt</translation>
    </message>
    <message>
        <source>Impulse on the rock in a cycle; its mean is the feed force times the interval</source>
        <translation>Je Schlag und den Zyklus danach; im Mittel der Andruck mal dem Abstand der Schläge</translation>
    </message>
    <message>
        <source>Per blow; an upper limit: all rock under the bit breaks</source>
        <translation>Je Schlag; eine obere Grenze: alles Gestein unter der Bohrkrone gibt nach</translation>
    </message>
    <message>
        <source>Largest force on the rock in a cycle</source>
        <translation>Größte Kraft des Gesteins in einem Zyklus</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Number of contacts in a cycle</source>
        <translation>Wie viele Kontakte in einem Zyklus beginnen</translation>
    </message>
    <message>
        <source>Record:</source>
        <translation>Aufzeichnung:</translation>
    </message>
    <message>
        <source>The hammer is rounded to %1, so that waves can be kept. Its impulse is the same; its blow is longer or shorter in proportion.</source>
        <translation>Der Hammer ist auf %1 gerundet, damit Wellen behalten werden können; er gibt denselben Impuls, in einem um so viel längeren oder kürzeren Schlag.</translation>
    </message>
    <message>
        <source>The rod is rounded to %1, so that waves can be kept.</source>
        <translation>Die Stange ist auf %1 gerundet, damit Wellen behalten werden können.</translation>
    </message>
    <message>
        <source>%1th</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1st</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1nd</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1rd</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>sections %1 to %2</source>
        <translation>Abschnitte %1 bis %2</translation>
    </message>
    <message>
        <source>sections %1 and %2</source>
        <translation>Abschnitte %1 und %2</translation>
    </message>
    <message>
        <source>sections %1, %2 … %3</source>
        <translation>Abschnitte %1, %2 … %3</translation>
    </message>
    <message>
        <source>%1 and %2 %3</source>
        <translation>%1 und %2 %3</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1–%2 %3</translation>
    </message>
    <message>
        <source>%1, %2 … %3 %4</source>
        <translation>%1, %2 … %3 %4</translation>
    </message>
    <message>
        <source>%1 section</source>
        <translation>%1 Abschnitt</translation>
    </message>
    <message>
        <source>%1 sections</source>
        <translation>%1 Abschnitte</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 rod</source>
        <translation>%1 Stange</translation>
    </message>
    <message>
        <source>%1 rods</source>
        <translation>%1 Stangen</translation>
    </message>
    <message>
        <source>%1 coupling</source>
        <translation>%1 Kupplungsmuffe</translation>
    </message>
    <message>
        <source>%1 couplings</source>
        <translation>%1 Kupplungsmuffen</translation>
    </message>
    <message>
        <source>%1 other section</source>
        <translation>%1 weiterer Abschnitt</translation>
    </message>
    <message>
        <source>%1 other sections</source>
        <translation>%1 weitere Abschnitte</translation>
    </message>
    <message>
        <source>During the blow, the most heavily loaded section (%1) has a tension of %2, which is %3 of its fatigue strength of %4.</source>
        <translation>Während des Schlags hat der am höchsten belastete Abschnitt (%1) eine Zugspannung von %2; das sind %3 seiner Dauerfestigkeit von %4.</translation>
    </message>
    <message>
        <source>During the blow, the most heavily loaded section (%1) has a tension of %2, which is %3 of its yield strength of %4.</source>
        <translation>Während des Schlags hat der am höchsten belastete Abschnitt (%1) eine Zugspannung von %2; das sind %3 seiner Streckgrenze von %4.</translation>
    </message>
    <message>
        <source>During the blow, the most heavily loaded section (%1) has a compression of %2, which is %3 of its yield strength of %4.</source>
        <translation>Während des Schlags hat der am höchsten belastete Abschnitt (%1) eine Druckspannung von %2; das sind %3 seiner Streckgrenze von %4.</translation>
    </message>
    <message>
        <source>No section has a strength. Enter a strength (%1) to find the section that breaks first.</source>
        <translation>Kein Abschnitt hat eine Festigkeit. Eine Festigkeit angeben (%1), um den Abschnitt zu finden, der zuerst bricht.</translation>
    </message>
    <message>
        <source>the rod</source>
        <translation>die Stange</translation>
    </message>
    <message>
        <source>No strength is given for %1 section of the string.</source>
        <translation>Für %1 Abschnitt des Strangs ist keine Festigkeit angegeben.</translation>
    </message>
    <message>
        <source>No strength is given for %1 sections of the string.</source>
        <translation>Für %1 Abschnitte des Strangs ist keine Festigkeit angegeben.</translation>
    </message>
    <message>
        <source>is empty; leave it out for a section without a preset</source>
        <translation>ist leer; ein Abschnitt, der aus keiner Voreinstellung ist, wird ohne es geschrieben</translation>
    </message>
    <message>
        <source>This blow has too many waves to store them all. Plots of waves and forces therefore show a coarser model of the string. Its coefficient of restitution and efficiency differ by at most %1.</source>
        <translation>Dieser Schlag hat zu viele Wellen, um sie alle zu speichern. Wellen und Kräfte in den Diagrammen gehören daher zu einem gröber geteilten Strang. Dessen Stoßzahl und Wirkungsgrad weichen um höchstens %1 ab.</translation>
    </message>
    <message>
        <source>%1, but a small disturbance grows</source>
        <translation>%1, aber eine kleine Störung wächst</translation>
    </message>
    <message>
        <source>%1 needs rows with points and commas; leave out --decimal-comma</source>
        <translation>%1 braucht Zeilen mit Punkten und Kommas; --decimal-comma weglassen</translation>
    </message>
    <message>
        <source>Enter a wave loss under “%1”: waves usually lose 1 to 30 % in each round trip.</source>
        <translation>Unter „%1“ einen Wellenverlust eingeben: üblich sind 1 bis 30&#xa0;% je Hin- und Rücklauf.</translation>
    </message>
    <message>
        <source>Enter a larger number under “%1” to reduce the error of the mean penetration.</source>
        <translation>Unter „%1“ eine größere Zahl eingeben, um den Fehler der mittleren Eindringung zu verkleinern.</translation>
    </message>
    <message>
        <source>undamped</source>
        <translation>ungedämpft</translation>
    </message>
    <message>
        <source>damped only by the losses of the string</source>
        <translation>gedämpft nur durch die Verluste im Strang</translation>
    </message>
    <message>
        <source>%1 % of the wave is left, with a loss of %2 % per round trip</source>
        <translation>%1&#xa0;% der Welle sind noch da, bei %2&#xa0;% Verlust je Umlauf</translation>
    </message>
    <message>
        <source>This blow is not over after %1, when the next blow starts: the bit may hit the rock again. The values are for that moment and not final.</source>
        <translation>Dieser Schlag ist nach %1, wenn der nächste beginnt, nicht zu Ende: die Bohrkrone kann das Gestein noch einmal treffen. Die Werte gelten für diesen Zeitpunkt und sind nicht endgültig.</translation>
    </message>
    <message>
        <source>could not be solved at all gaps: %1</source>
        <translation>konnte nicht bei allen Spalten gelöst werden: %1</translation>
    </message>
    <message>
        <source>Results repeat every d₀ of gap.</source>
        <translation>Mit wachsendem Spalt wiederholen sich die Ergebnisse alle d₀.</translation>
    </message>
    <message>
        <source>Results repeat every d₀ = %1 of gap.</source>
        <translation>Mit wachsendem Spalt wiederholen sich die Ergebnisse alle d₀ = %1.</translation>
    </message>
    <message>
        <source>How the gap scatters</source>
        <translation>Wie der Spalt streut</translation>
    </message>
    <message>
        <source>The gap at the rig is a matter of chance: all gaps of a period equally likely, or a normal distribution cut off at zero</source>
        <translation>Niemand regelt den Spalt am Bohrgerät: alle Spalte einer Periode gleich, oder eine Normalverteilung, abgeschnitten bei keinem Spalt</translation>
    </message>
    <message>
        <source>all equally likely</source>
        <translation>gleichverteilt</translation>
    </message>
    <message>
        <source>mean ± deviation</source>
        <translation>Mittel ± Standardabw.</translation>
    </message>
    <message>
        <source>COR–gap</source>
        <translation>e–Spalt</translation>
    </message>
    <message>
        <source>Result over the gap, and how its values are distributed</source>
        <translation>Ergebnis über dem Spalt, und wie seine Werte verteilt sind</translation>
    </message>
    <message>
        <source>mean of the gap</source>
        <translation>Mittel des Spalts</translation>
    </message>
    <message>
        <source>standard deviation of the gap</source>
        <translation>Standardabweichung des Spalts</translation>
    </message>
    <message>
        <source>COR e</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>peak force Fm</source>
        <translation>Spitzenkraft Fm</translation>
    </message>
    <message>
        <source>A first look; the curve follows.</source>
        <translation>Ein erster Blick; die Kurve folgt.</translation>
    </message>
    <message>
        <source>Click on the curve to use that gap; Shift+click pins it.</source>
        <translation>Klick auf die Kurve: diesen Spalt übernehmen; mit Umschalt: zum Vergleich anheften.</translation>
    </message>
    <message>
        <source>COR–gap needs a uniform rod, whose results repeat over the gap. For drill strings they do not repeat: Efficiency–stiffness shows them over the gap, point by point.</source>
        <translation>e–Spalt ist für gleichförmige Stangen, deren Ergebnisse sich über dem Spalt wiederholen; die eines Bohrstrangs tun das nicht, und Wirkungsgrad–Steifigkeit zeigt sie über dem Spalt Punkt für Punkt.</translation>
    </message>
    <message>
        <source>gap d</source>
        <translation>Spalt d</translation>
    </message>
    <message>
        <source>δ = gap / d₀</source>
        <translation>δ = Spalt / d₀</translation>
    </message>
    <message>
        <source>per class [%]</source>
        <translation>je Klasse [%]</translation>
    </message>
    <message>
        <source>cumulative [%]</source>
        <translation>summiert [%]</translation>
    </message>
    <message>
        <source>share per class</source>
        <translation>Anteil je Klasse</translation>
    </message>
    <message>
        <source>cumulative share</source>
        <translation>Summenhäufigkeit</translation>
    </message>
    <message>
        <source>super rebound, e &gt; 1</source>
        <translation>Überrückprall, e &gt; 1</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>scattered gap: mean %1, 5–95 % %2…%3</source>
        <translation>gestreuter Spalt: Mittel %1, 5–95 % %2…%3</translation>
    </message>
    <message>
        <source>all gaps: mean %1, 5–95 % %2…%3</source>
        <translation>alle Spalte: Mittel %1, 5–95&#xa0;% %2…%3</translation>
    </message>
    <message>
        <source>e &gt; 1 at %1 of gaps</source>
        <translation>e &gt; 1 bei %1 der Spalte</translation>
    </message>
    <message>
        <source>feed force enough for 95 % of gaps: %1</source>
        <translation>Andruck, der für 95&#xa0;% der Spalte reicht: %1</translation>
    </message>
    <message>
        <source>records</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>give COLUMN@DISTANCE, the distance from the bit face</source>
        <translation>COLUMN@DISTANCE angeben, den Abstand von der Stirnfläche der Krone</translation>
    </message>
    <message>
        <source>two columns belong around the plus sign</source>
        <translation>um das Pluszeichen gehören zwei Spalten</translation>
    </message>
    <message>
        <source>the distance must be positive</source>
        <translation>der Abstand muss positiv sein</translation>
    </message>
    <message>
        <source>give KEY=+-TOLERANCE</source>
        <translation>KEY=+-TOLERANCE angeben</translation>
    </message>
    <message>
        <source>must be a percentage, such as +-2%</source>
        <translation>muss ein Prozentsatz sein, etwa +-2%</translation>
    </message>
    <message>
        <source>the tolerance must be positive</source>
        <translation>die Toleranz muss positiv sein</translation>
    </message>
    <message>
        <source>--%1 %2: must be one of %3</source>
        <translation>--%1 %2: muss eines von %3 sein</translation>
    </message>
    <message>
        <source>both gauges must be on one section of the string</source>
        <translation>beide Messstellen müssen auf einem Abschnitt des Strangs liegen</translation>
    </message>
    <message>
        <source>two gauges must be at least 0.5 m apart</source>
        <translation>zwei Messstellen müssen mindestens 0,5 m voneinander entfernt sein</translation>
    </message>
    <message>
        <source>needs --signals REC.csv</source>
        <translation>braucht --signals REC.csv</translation>
    </message>
    <message>
        <source>%1 is given twice; give each record once</source>
        <translation>%1 ist zweimal angegeben; jede Aufzeichnung einmal angeben</translation>
    </message>
    <message>
        <source>needs --gauge COLUMN@DISTANCE</source>
        <translation>braucht --gauge COLUMN@DISTANCE</translation>
    </message>
    <message>
        <source>takes one or two gauges</source>
        <translation>nimmt eine oder zwei Messstellen</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>muss positiv sein</translation>
    </message>
    <message>
        <source>is given by its dimensionless groups; identify needs physical units</source>
        <translation>ist durch seine dimensionslosen Kennzahlen gegeben; identify braucht physikalische Einheiten</translation>
    </message>
    <message>
        <source>is not on a uniform section of the rod or string</source>
        <translation>liegt nicht auf einem gleichförmigen Abschnitt der Stange oder des Strangs</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 Aufzeichnungen</translation>
    </message>
    <message>
        <source>rock when it is first loaded</source>
        <translation>Gestein bei der ersten Belastung</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>elasticity</source>
        <translation>Elastizität</translation>
    </message>
    <message>
        <source>bit not seated</source>
        <translation>Krone liegt nicht an</translation>
    </message>
    <message>
        <source>force at which the rock yields</source>
        <translation>Kraft, bei der das Gestein nachgibt</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>slope after yielding</source>
        <translation>Steigung nach dem Nachgeben</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>kleiner als %1</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>größer als %1</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>eingegrenzt</translation>
    </message>
    <message>
        <source>not seen: no contact</source>
        <translation>nicht zu sehen: kein Kontakt</translation>
    </message>
    <message>
        <source>not seen: the rock is too stiff</source>
        <translation>nicht zu sehen: das Gestein ist zu steif</translation>
    </message>
    <message>
        <source>not seen: the record ends before the rock unloads</source>
        <translation>nicht zu sehen: die Aufzeichnung endet, bevor sich das Gestein entlastet</translation>
    </message>
    <message>
        <source>next blow</source>
        <translation>nächster Schlag</translation>
    </message>
    <message>
        <source>changes from blow to blow</source>
        <translation>ändert sich von Schlag zu Schlag</translation>
    </message>
    <message>
        <source>no change is seen</source>
        <translation>keine Änderung ist zu sehen</translation>
    </message>
    <message>
        <source>waves that follow the blow</source>
        <translation>Wellen, die dem Schlag folgen</translation>
    </message>
    <message>
        <source>arrival of the reflection</source>
        <translation>Ankunft der Reflexion</translation>
    </message>
    <message>
        <source>modulus and density</source>
        <translation>E-Modul und Dichte</translation>
    </message>
    <message>
        <source>gain of the amplifier</source>
        <translation>Verstärkung des Verstärkers</translation>
    </message>
    <message>
        <source>distance between the gauges</source>
        <translation>Abstand der Messstellen voneinander</translation>
    </message>
    <message>
        <source>force rise hidden by noise</source>
        <translation>Kraftanstieg, vom Rauschen verdeckt</translation>
    </message>
    <message>
        <source>step of the recorder</source>
        <translation>Auflösungsstufe des Messgeräts</translation>
    </message>
    <message>
        <source>unexplained waves</source>
        <translation>unerklärte Wellen</translation>
    </message>
    <message>
        <source>assumed +-%1</source>
        <translation>angenommen ±%1</translation>
    </message>
    <message>
        <source>Limits of the result</source>
        <translation>Was das Ergebnis begrenzt</translation>
    </message>
    <message>
        <source>%1 +-%2</source>
        <translation>%1 ±%2</translation>
    </message>
    <message>
        <source>To know more: average 4 blows: %1.</source>
        <translation>Um mehr zu wissen: 4 Schläge mitteln: %1.</translation>
    </message>
    <message>
        <source>To know more: use gauges on opposite sides: %1.</source>
        <translation>Um mehr zu wissen: Messstreifen auf gegenüberliegenden Seiten verwenden: %1.</translation>
    </message>
    <message>
        <source>To know more: use gauges on opposite sides, or a second gauge: %1.</source>
        <translation>Um mehr zu wissen: Messstreifen auf gegenüberliegenden Seiten oder eine zweite Messstelle verwenden: %1.</translation>
    </message>
    <message>
        <source>To know more: use a smaller range or more bits: %1.</source>
        <translation>Um mehr zu wissen: einen kleineren Messbereich oder mehr Bit verwenden: %1.</translation>
    </message>
    <message>
        <source>To know more: measure the distance of the gauge from the bit: %1.</source>
        <translation>Um mehr zu wissen: den Abstand der Messstelle von der Krone messen: %1.</translation>
    </message>
    <message>
        <source>To know more: measure %1 to %2: %3.</source>
        <translation>Um mehr zu wissen: %1 auf %2 genau messen: %3.</translation>
    </message>
    <message>
        <source>match</source>
        <translation>Übereinstimmung</translation>
    </message>
    <message>
        <source>in quiet</source>
        <translation>in der Ruhe</translation>
    </message>
    <message>
        <source>%1 of the peak where nothing should be (bending and the like)</source>
        <translation>%1 der Spitze, wo nichts sein sollte (Biegung und dergleichen)</translation>
    </message>
    <message>
        <source>reflection after %1, the file says %2</source>
        <translation>Reflexion nach %1, die Datei sagt %2</translation>
    </message>
    <message>
        <source>%1; gain of the second gauge %2</source>
        <translation>%1; Verstärkung der zweiten Messstelle %2</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>zero line</source>
        <translation>Nulllinie</translation>
    </message>
    <message>
        <source>%1 of the peak, %2 in a millisecond</source>
        <translation>%1 der Spitze, %2 in einer Millisekunde</translation>
    </message>
    <message>
        <source>laws tried</source>
        <translation>versuchte Gesetze</translation>
    </message>
    <message>
        <source>The reflection does not arrive at the time computed from the scenario file. Check the distance of the gauge from the bit, the wave speed, the sampling clock, and whether the file lacks a section.</source>
        <translation>Die Reflexion kommt nicht zu der aus der Szenariodatei berechneten Zeit an. Den Abstand der Messstelle von der Krone, die Wellengeschwindigkeit und den Abtasttakt prüfen, und ob in der Datei ein Abschnitt fehlt.</translation>
    </message>
    <message>
        <source>A section between gauge and bit differs from the scenario file. Measure the bit head and the rod, and check whether the file lacks a section.</source>
        <translation>Ein Abschnitt zwischen Messstelle und Bohrkrone weicht von der Szenariodatei ab. Den Kronenkopf und die Stange messen, und prüfen, ob in der Datei ein Abschnitt fehlt.</translation>
    </message>
    <message>
        <source>The distance between the gauges, or a section between gauge and bit, differs from the scenario file. Measure this distance, the bit head and the rod.</source>
        <translation>Der Abstand der Messstellen voneinander oder ein Abschnitt zwischen Messstelle und Bohrkrone weicht von der Szenariodatei ab. Diesen Abstand, den Kronenkopf und die Stange messen.</translation>
    </message>
    <message>
        <source>The record shows waves at times when the rod should be at rest. Possible causes: bending (use gauges on opposite sides of the rod), the blow before, or couplings.</source>
        <translation>Die Aufzeichnung zeigt Wellen zu Zeiten, in denen die Stange in Ruhe sein sollte. Mögliche Ursachen: Biegung (Messstreifen auf gegenüberliegenden Seiten der Stange verwenden), der Schlag davor oder Kupplungsmuffen.</translation>
    </message>
    <message>
        <source>The zero line of the record drifts by more than the tolerance of the amplifier. Check the zero and the drift of the amplifier, and whether it is AC or DC coupled.</source>
        <translation>Die Nulllinie der Aufzeichnung bewegt sich um mehr als die Toleranz des Verstärkers. Nullpunkt und Drift des Verstärkers prüfen, und ob er AC- oder DC-gekoppelt ist.</translation>
    </message>
    <message>
        <source>The rod still rings from an earlier blow when this blow starts: measure a single blow.</source>
        <translation>Die Stange schwingt zu Beginn dieses Schlags noch von einem früheren nach: einen einzelnen Schlag messen.</translation>
    </message>
    <message>
        <source>The model does not agree with the record, so nothing is known about the rock. %1</source>
        <translation>Das Modell stimmt nicht mit der Aufzeichnung überein, daher ist über das Gestein nichts bekannt. %1</translation>
    </message>
    <message>
        <source>The record agrees with the rock of the scenario file.</source>
        <translation>Die Aufzeichnung stimmt mit dem Gestein der Szenariodatei überein.</translation>
    </message>
    <message>
        <source>The record contradicts the rock of the scenario file.</source>
        <translation>Die Aufzeichnung widerspricht dem Gestein der Szenariodatei.</translation>
    </message>
    <message>
        <source>The record agrees only roughly with the rock of the scenario file.</source>
        <translation>Die Aufzeichnung stimmt nur ungefähr mit dem Gestein der Szenariodatei überein.</translation>
    </message>
    <message>
        <source>The record agrees only roughly with the model.</source>
        <translation>Die Aufzeichnung stimmt nur ungefähr mit dem Modell überein.</translation>
    </message>
    <message>
        <source>The record agrees with a rock that yields at one force: its loading curve has one corner.</source>
        <translation>Die Aufzeichnung stimmt mit einem Gestein überein, das bei einer bestimmten Kraft nachgibt: seine Belastungskurve hat eine Ecke.</translation>
    </message>
    <message>
        <source>The record agrees with a rock whose force rises along one straight line while the bit penetrates.</source>
        <translation>Die Aufzeichnung stimmt mit einem Gestein überein, dessen Kraft beim Eindringen längs einer einzigen Geraden steigt.</translation>
    </message>
    <message>
        <source>The record determines stiffness and elasticity (gamma) of the rock, and the gap between bit and rock.</source>
        <translation>Die Aufzeichnung bestimmt Steifigkeit und Elastizität (gamma) des Gesteins und den Spalt zwischen Bohrkrone und Gestein.</translation>
    </message>
    <message>
        <source>Stiffness and elasticity (gamma) of the rock are known, but the gap between bit and rock is not.</source>
        <translation>Steifigkeit und Elastizität (gamma) des Gesteins sind bekannt, der Spalt zwischen Bohrkrone und Gestein nicht.</translation>
    </message>
    <message>
        <source>The stiffness of the rock is known, but its elasticity (gamma) is not.</source>
        <translation>Die Steifigkeit des Gesteins ist bekannt, die Elastizität (gamma) nicht.</translation>
    </message>
    <message>
        <source>The elasticity (gamma) of the rock is known, but its stiffness is not.</source>
        <translation>Die Elastizität (gamma) des Gesteins ist bekannt, die Steifigkeit nicht.</translation>
    </message>
    <message>
        <source>Neither stiffness nor elasticity (gamma) of the rock is known to within 20 %.</source>
        <translation>Weder Steifigkeit noch Elastizität (gamma) des Gesteins sind auf 20&#xa0;% genau bekannt.</translation>
    </message>
    <message>
        <source>waves of %1 of the peak are not explained by the model; they widen all intervals</source>
        <translation>Wellen von %1 der Spitze erklärt das Modell nicht; sie verbreitern alle Intervalle</translation>
    </message>
    <message>
        <source>waves of %1 of the peak are not explained by the model</source>
        <translation>Wellen von %1 der Spitze erklärt das Modell nicht</translation>
    </message>
    <message>
        <source>waves of %1 of the peak are there before the front; measure a single blow</source>
        <translation>vor der Front gibt es Wellen von %1 der Spitze; einen einzelnen Schlag messen</translation>
    </message>
    <message>
        <source>the reflection arrives after %1 instead of %2; check distance, wave speed and clock, and look for a section missing in the file</source>
        <translation>die Reflexion kommt nach %1 statt %2 an; Abstand, Wellengeschwindigkeit und Takt prüfen, und ob in der Datei ein Abschnitt fehlt</translation>
    </message>
    <message>
        <source>%1 changed by %2 would explain the record; measure it</source>
        <translation>%1, um %2 geändert, würde die Aufzeichnung erklären; nachmessen</translation>
    </message>
    <message>
        <source>%1 changed by %2, or another distance between the gauges, would explain the record; measure both</source>
        <translation>%1, um %2 geändert, oder ein anderer Abstand der Messstellen voneinander würde die Aufzeichnung erklären; beide nachmessen</translation>
    </message>
    <message>
        <source>a jump of the zero level %1 after the front would explain the record; check cable and amplifier</source>
        <translation>ein Sprung des Nullpunkts %1 nach der Front würde die Aufzeichnung erklären; Kabel und Verstärker prüfen</translation>
    </message>
    <message>
        <source>the rock begins as steep as it springs back: the bit may stand in the crater of a blow before, or be pressed into it</source>
        <translation>das Gestein beginnt so steil, wie es zurückfedert: die Krone steht vielleicht im Krater eines früheren Schlags oder ist hineingedrückt</translation>
    </message>
    <message>
        <source>some tolerances are assumed; give measured ones by --known KEY=+-TOLERANCE</source>
        <translation>einige Toleranzen sind angenommen; gemessene mit --known KEY=+-TOLERANCE angeben</translation>
    </message>
    <message>
        <source>the zero line moves by more than its tolerance</source>
        <translation>die Nulllinie bewegt sich um mehr als ihre Toleranz</translation>
    </message>
    <message>
        <source>the returning wave is clipped; those samples are left out</source>
        <translation>die zurückkehrende Welle ist abgeschnitten; diese Abtastwerte sind weggelassen</translation>
    </message>
    <message>
        <source>the quiet time between the blow and its reflection is short; put the gauge further from the bit</source>
        <translation>die ruhige Zeit zwischen dem Schlag und seiner Reflexion ist kurz; die Messstelle weiter von der Krone entfernt anbringen</translation>
    </message>
    <message>
        <source>there is no gauge on the opposite side of the rod; one would show bending</source>
        <translation>auf der gegenüberliegenden Seite der Stange ist kein Messstreifen; er würde Biegung zeigen</translation>
    </message>
    <message>
        <source>dispersion between gauge and bit is taken into account</source>
        <translation>die Dispersion zwischen Messstelle und Krone ist berücksichtigt</translation>
    </message>
    <message>
        <source>other laws were tried because the bilinear law leaves more than noise</source>
        <translation>andere Gesetze wurden versucht, weil das bilineare Gesetz mehr als Rauschen übrig lässt</translation>
    </message>
    <message>
        <source>another law explains the record as well; the intervals include it</source>
        <translation>ein anderes Gesetz erklärt die Aufzeichnung ebenso gut; die Intervalle schließen es ein</translation>
    </message>
    <message>
        <source>fewer than five records say little about how the rock changes</source>
        <translation>weniger als fünf Aufzeichnungen sagen wenig darüber, wie sich das Gestein ändert</translation>
    </message>
    <message>
        <source>the record holds further blows; --blows all identifies each</source>
        <translation>die Aufzeichnung enthält weitere Schläge; --blows all identifiziert jeden</translation>
    </message>
    <message>
        <source>the second gauge has the other sign; it is reversed</source>
        <translation>die zweite Messstelle hat das andere Vorzeichen; sie wird umgekehrt</translation>
    </message>
    <message>
        <source>the peak stress is unlikely; check the unit of the record</source>
        <translation>die Spitzenspannung ist unwahrscheinlich; die Einheit der Aufzeichnung prüfen</translation>
    </message>
    <message>
        <source>a rock that stiffens from the start explains the record as well as a gap</source>
        <translation>ein Gestein, das von Anfang an steifer wird, erklärt die Aufzeichnung ebenso gut wie ein Spalt</translation>
    </message>
    <message>
        <source>a section differs from the file by more than its tolerance</source>
        <translation>ein Abschnitt weicht um mehr als seine Toleranz von der Datei ab</translation>
    </message>
    <message>
        <source>the zero level jumps within the record</source>
        <translation>der Nullpunkt springt innerhalb der Aufzeichnung</translation>
    </message>
    <message>
        <source>the columns of the two gauges have different numbers of samples</source>
        <translation>die Spalten der beiden Messstellen haben verschieden viele Abtastwerte</translation>
    </message>
    <message>
        <source>%1: the opposite gauges have opposite signs; reverse one of them</source>
        <translation>%1: die gegenüberliegenden Messstreifen haben entgegengesetzte Vorzeichen; einen von ihnen umkehren</translation>
    </message>
    <message>
        <source>a gauge is not on a uniform section of rod or string</source>
        <translation>eine Messstelle liegt nicht auf einem gleichförmigen Abschnitt der Stange oder des Strangs</translation>
    </message>
    <message>
        <source>--known %1: the tolerance must be smaller than the value</source>
        <translation>--known %1: die Toleranz muss kleiner als der Wert sein</translation>
    </message>
    <message>
        <source>--known %1: is no size of the gauge&apos;s section or of a section between gauge and rock; give gain, zero, gauge, or such a key</source>
        <translation>--known %1: ist kein Maß des Abschnitts der Messstelle oder eines Abschnitts zwischen Messstelle und Gestein; gain, zero, gauge oder einen solchen Schlüssel angeben</translation>
    </message>
    <message>
        <source>the record has %1 samples; at least 50 are needed before the front</source>
        <translation>die Aufzeichnung hat %1 Abtastwerte; vor der Front sind mindestens 50 nötig</translation>
    </message>
    <message>
        <source>there is no such blow in the record</source>
        <translation>einen solchen Schlag gibt es in der Aufzeichnung nicht</translation>
    </message>
    <message>
        <source>no front is seen in the record; check the gauge, its column and the trigger</source>
        <translation>in der Aufzeichnung ist keine Front zu sehen; die Messstelle, ihre Spalte und den Trigger prüfen</translation>
    </message>
    <message>
        <source>only %1 samples stand before the front at %2; record at least 50 before it (trigger with more pre-trigger time)</source>
        <translation>nur %1 Abtastwerte stehen vor der Front bei %2; mindestens 50 davor aufzeichnen (mit mehr Vorlaufzeit triggern)</translation>
    </message>
    <message>
        <source>one of the gauges sees no front; check its column and its cable</source>
        <translation>eine der Messstellen sieht keine Front; ihre Spalte und ihr Kabel prüfen</translation>
    </message>
    <message>
        <source>the front reaches the gauge near the bit first: are the columns of the two gauges exchanged? Exchange them in --gauge</source>
        <translation>die Front erreicht die Messstelle nahe der Krone zuerst: sind die Spalten der beiden Messstellen vertauscht? In --gauge tauschen</translation>
    </message>
    <message>
        <source>the blow is not over when its reflection arrives after %1; a second gauge further from the bit is needed, or a gauge further away</source>
        <translation>der Schlag ist nicht vorbei, wenn seine Reflexion nach %1 ankommt; nötig ist eine zweite Messstelle weiter von der Krone oder eine Messstelle weiter weg</translation>
    </message>
    <message>
        <source>samples are missing from %1 to %2; record without a pause</source>
        <translation>Abtastwerte fehlen von %1 bis %2; ohne Pause aufzeichnen</translation>
    </message>
    <message>
        <source>the incident wave is clipped over %1; choose a larger range of the amplifier or of the recorder</source>
        <translation>die einlaufende Welle ist über %1 abgeschnitten; einen größeren Bereich des Verstärkers oder des Messgeräts wählen</translation>
    </message>
    <message>
        <source>--check needs --backing bar</source>
        <translation>--check braucht --backing bar</translation>
    </message>
    <message>
        <source>--check takes one column</source>
        <translation>--check nimmt eine Spalte</translation>
    </message>
    <message>
        <source>--with drill: %1 blows take about %2, more than a report may; set fewer blows (drill.blows), or use `drillwave drill --work-limit`</source>
        <translation>--with drill: %1 Schläge dauern etwa %2, länger als ein Bericht darf; weniger Schläge setzen (drill.blows) oder `drillwave drill --work-limit` benutzen</translation>
    </message>
    <message>
        <source>--with design needs a block `design` with its list `uncertain`; see `drillwave help files`</source>
        <translation>--with design braucht einen Block `design` mit seiner Liste `uncertain`; siehe `drillwave help files`</translation>
    </message>
    <message>
        <source>--with %1: `%2` is not a study of reports; choose from %3</source>
        <translation>--with %1: `%2` ist keine Studie für Berichte; möglich sind %3</translation>
    </message>
    <message>
        <source>nothing, only the present design</source>
        <translation>nichts, nur die jetzige Auslegung</translation>
    </message>
    <message>
        <source>Design variables: %1. All blows have the energy of the present one.</source>
        <translation>Zur Wahl: %1. Alle Schläge haben die Energie des jetzigen.</translation>
    </message>
    <message>
        <source>%1 instead of %2: %3 %4, with the values entered %5.</source>
        <translation>%1 statt %2: %3 %4, mit den eingegebenen Werten %5.</translation>
    </message>
    <message>
        <source>equally good</source>
        <translation>gleich gut</translation>
    </message>
    <message>
        <source>present design</source>
        <translation>jetzige</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>Zeit t</translation>
    </message>
    <message>
        <source>force, compression +</source>
        <translation>Kraft, Druck +</translation>
    </message>
    <message>
        <source>returning wave, measured</source>
        <translation>rücklaufende Welle, gemessen</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>incident wave</source>
        <translation>einlaufende Welle</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>incident</source>
        <translation>einlaufend</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>returning</source>
        <translation>rücklaufend</translation>
    </message>
    <message>
        <source>arrival by the distance</source>
        <translation>Ankunft nach dem Abstand</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>law, 95 %</source>
        <translation>Gesetz, 95 %</translation>
    </message>
    <message>
        <source>penetration U</source>
        <translation>Eindringung U</translation>
    </message>
    <message>
        <source>force on the rock F</source>
        <translation>Kraft auf das Gestein F</translation>
    </message>
    <message>
        <source>measured, only a picture</source>
        <translation>gemessen, nur ein Bild</translation>
    </message>
    <message>
        <source>+2 σ of the noise</source>
        <translation>+2 σ des Rauschens</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>law of the rock</source>
        <translation>Gesetz des Gesteins</translation>
    </message>
    <message>
        <source>check</source>
        <translation>Gegenprobe</translation>
    </message>
    <message>
        <source>The first %1 of %2 blows are not counted. The rate is an upper limit: all rock under the bit breaks and cuttings are removed.</source>
        <translation>Die ersten %1 von %2 Schlägen zählen nicht. Der Bohrfortschritt ist eine obere Grenze: alles Gestein unter der Krone gibt nach, Bohrklein verschwindet.</translation>
    </message>
    <message>
        <source>Design study</source>
        <translation>Auslegungsstudie</translation>
    </message>
    <message>
        <source>Continuous drilling</source>
        <translation>Fortlaufendes Bohren</translation>
    </message>
    <message>
        <source>%1: has another number of samples than the gauges</source>
        <translation>%1: hat eine andere Zahl von Messwerten als die Messstellen</translation>
    </message>
    <message>
        <source>%1: the table does not state this: %2. Open the record again and choose it.</source>
        <translation>%1: Die Tabelle gibt dies nicht an: %2. Öffnen Sie die Aufzeichnung erneut und wählen Sie es.</translation>
    </message>
    <message>
        <source>For 90 % of the scattered gaps, e is between %1 and %2; its mean is %3.</source>
        <translation>Für 90&#xa0;% der gestreuten Spalte liegt e zwischen %1 und %2; im Mittel ist es %3.</translation>
    </message>
    <message>
        <source>For 90 % of all gaps, e is between %1 and %2; its mean is %3.</source>
        <translation>Für 90&#xa0;% aller Spalte liegt e zwischen %1 und %2; im Mittel ist es %3.</translation>
    </message>
    <message>
        <source>not seen: the force stays below a corner</source>
        <translation>nicht gesehen: die Kraft bleibt unter einem Knick</translation>
    </message>
    <message>
        <source>column %1 is given twice; every gauge has a column of its own</source>
        <translation>Spalte %1 ist zweimal angegeben; jede Messstelle hat eine eigene Spalte</translation>
    </message>
    <message>
        <source>the record ends before the reflection arrives, %1 after the front; record longer</source>
        <translation>die Aufzeichnung endet, bevor die Reflexion %1 nach der Front eintrifft; länger aufzeichnen</translation>
    </message>
    <message>
        <source>only %1 samples show the reflection, in a window of %2; at least 50 are needed: record faster or longer, or put the gauge further from the end behind it</source>
        <translation>nur %1 Abtastwerte zeigen die Reflexion, in einem Fenster von %2; mindestens 50 sind nötig: schneller oder länger aufzeichnen oder die Messstelle weiter vom Ende hinter ihr setzen</translation>
    </message>
    <message>
        <source>--record is for one or two gauges</source>
        <translation>--record ist für eine oder zwei Messstellen</translation>
    </message>
    <message>
        <source>--%1 needs --record COLUMN@DISTANCE</source>
        <translation>--%1 braucht --record COLUMN@DISTANCE</translation>
    </message>
    <message>
        <source>must be a percentage from 0 to 100 %, such as 1%</source>
        <translation>muss ein Prozentsatz von 0 bis 100 % sein, etwa 1%</translation>
    </message>
    <message>
        <source>is given by its dimensionless groups; --record needs physical units</source>
        <translation>ist durch seine dimensionslosen Kennzahlen gegeben; --record braucht physikalische Einheiten</translation>
    </message>
    <message>
        <source>--record %1: is not on a uniform section of the rod or string</source>
        <translation>--record %1: liegt nicht auf einem gleichförmigen Abschnitt von Stange oder Strang</translation>
    </message>
    <message>
        <source>lowest %1 = %2 at %3 = %4; highest %1 = %5 at %3 = %6</source>
        <translation>niedrigstes %1 = %2 bei %3 = %4; höchstes %1 = %5 bei %3 = %6</translation>
    </message>
    <message>
        <source>next blow, 95 %</source>
        <translation>nächster Schlag, 95 %</translation>
    </message>
    <message>
        <source>record, 95 %</source>
        <translation>Aufzeichnung, 95 %</translation>
    </message>
    <message>
        <source>record on show</source>
        <translation>gezeigte Aufzeichnung</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>stimmt überein</translation>
    </message>
    <message>
        <source>agrees roughly</source>
        <translation>stimmt ungefähr überein</translation>
    </message>
    <message>
        <source>does not agree</source>
        <translation>stimmt nicht überein</translation>
    </message>
    <message>
        <source>A feed force of at least %1 would even return an undamped rod to the rock before each next blow.</source>
        <translation>Ein Andruck von mindestens %1 würde sogar eine ungedämpfte Stange vor jedem nächsten Schlag zum Gestein zurückbringen.</translation>
    </message>
    <message>
        <source>No larger feed force is required.</source>
        <translation>Mehr Andruck ist nicht erforderlich.</translation>
    </message>
    <message>
        <source>another solution, as good</source>
        <translation>eine andere Lösung, ebenso gut</translation>
    </message>
    <message>
        <source>--goal takes the value alone: --outputs cor --goal 1</source>
        <translation>--goal nimmt nur den Wert: --outputs cor --goal 1</translation>
    </message>
    <message>
        <source>The bit chatters on the rock (%1 contacts). Tiny changes of the input then change the coefficient of restitution e, which can be known only to within %2. A longer rod, a shorter blow or a softer rock reduces the chatter.</source>
        <translation>Die Bohrkrone rattert auf dem Gestein (%1 Kontakte). Winzige Änderungen der Eingabe ändern dann die Stoßzahl e, die nur auf %2 genau bekannt sein kann. Eine längere Stange, ein kürzerer Schlag oder weicheres Gestein mindert das Rattern.</translation>
    </message>
    <message>
        <source>Either the rock follows another law, or the scenario file is wrong about a section between gauge and bit or the distance between the gauges. Check the bit head and this distance first, then see where the measured and the modelled wave differ.</source>
        <translation>Entweder folgt das Gestein einem anderen Gesetz, oder in der Szenariodatei ist ein Abschnitt zwischen Messstelle und Bohrkrone oder der Abstand der Messstellen voneinander falsch. Zuerst den Kronenkopf und diesen Abstand prüfen, dann ansehen, wo gemessene und berechnete Welle auseinandergehen.</translation>
    </message>
    <message>
        <source>Either the rock follows another law, or the sections between gauge and bit differ from the scenario file. Check the bit head first, then see where the measured and the modelled wave differ.</source>
        <translation>Entweder folgt das Gestein einem anderen Gesetz, oder die Abschnitte zwischen Messstelle und Bohrkrone weichen von der Szenariodatei ab. Zuerst den Kronenkopf prüfen, dann ansehen, wo gemessene und berechnete Welle auseinandergehen.</translation>
    </message>
    <message>
        <source>The scan cannot decide which value is best: the penetrations have errors of +- %1, because %2.</source>
        <translation>Der Durchlauf kann nicht entscheiden, welcher Wert der beste ist: die Eindringungen haben Fehler von +- %1, weil %2.</translation>
    </message>
    <message>
        <source>gain within the record</source>
        <translation>Verstärkung innerhalb der Aufzeichnung</translation>
    </message>
    <message>
        <source>To know more: use a larger range of the amplifier, and check glue and cable of the gauge: %1.</source>
        <translation>Um mehr zu wissen: einen größeren Messbereich wählen und Klebung und Kabel des Dehnungsmessstreifens prüfen: %1.</translation>
    </message>
    <message>
        <source>the returning wave fits better with %1 less gain than the incident wave; check range, glue and cable of the gauge</source>
        <translation>die zurückkehrende Welle passt besser mit %1 weniger Verstärkung als die einfallende; Messbereich, Klebung und Kabel des Dehnungsmessstreifens prüfen</translation>
    </message>
    <message>
        <source>the returning wave fits better with %1 more gain than the incident wave; check range, glue and cable of the gauge</source>
        <translation>die zurückkehrende Welle passt besser mit %1 mehr Verstärkung als die einfallende; Messbereich, Klebung und Kabel des Dehnungsmessstreifens prüfen</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>lattice, moved waves, %1</source>
        <translation>Gitter, verschobene Wellen, %1</translation>
    </message>
    <message>
        <source>lattice, ring buffer, %1</source>
        <translation>Gitter, Ringpuffer, %1</translation>
    </message>
    <message>
        <source>%1, the paper&apos;s choice</source>
        <translation>%1, die Wahl der Veröffentlichung</translation>
    </message>
    <message>
        <source>The exact solution has nothing to compare with: %1</source>
        <translation>Die exakte Lösung hat keine andere, mit der sie zu vergleichen wäre: %1</translation>
    </message>
    <message>
        <source>e is right to %1 in %2</source>
        <translation>e stimmt auf %1 in %2</translation>
    </message>
    <message>
        <source>the paper&apos;s %1 segments give %2 in %3</source>
        <translation>die %1 Abschnitte der Veröffentlichung geben %2 in %3</translation>
    </message>
    <message>
        <source>processor time of a solve for e [s]</source>
        <translation>Rechenzeit einer Lösung für e [s]</translation>
    </message>
    <message>
        <source>error of e</source>
        <translation>Fehler von e</translation>
    </message>
    <message>
        <source>lattice, moved waves</source>
        <translation>Gitter, verschobene Wellen</translation>
    </message>
    <message>
        <source>lattice, ring buffer</source>
        <translation>Gitter, Ringpuffer</translation>
    </message>
    <message>
        <source>polynomial cells (studies)</source>
        <translation>polynomiale Zellen (Studien)</translation>
    </message>
    <message>
        <source>cut cells (a blow)</source>
        <translation>geteilte Zellen (ein Schlag)</translation>
    </message>
    <message>
        <source>plain lattice</source>
        <translation>einfaches Gitter</translation>
    </message>
    <message>
        <source>efficiency right to %1 in %2</source>
        <translation>Wirkungsgrad stimmt auf %1 in %2</translation>
    </message>
    <message>
        <source>in studies to %1 in %2</source>
        <translation>in Studien auf %1 in %2</translation>
    </message>
    <message>
        <source>plain lattice %1 in %2</source>
        <translation>einfaches Gitter %1 in %2</translation>
    </message>
    <message>
        <source>processor time of a solve [s]</source>
        <translation>Rechenzeit einer Lösung [s]</translation>
    </message>
    <message>
        <source>error of the efficiency</source>
        <translation>Fehler des Wirkungsgrads</translation>
    </message>
    <message>
        <source>cells of %1</source>
        <translation>Zellen von %1</translation>
    </message>
    <message>
        <source>%1 cases, all passed</source>
        <translation>%1 Fälle, alle bestanden</translation>
    </message>
    <message>
        <source>%1 of %2 cases failed</source>
        <translation>%1 von %2 Fällen durchgefallen</translation>
    </message>
    <message>
        <source>the worst: %1, %2 at %3 of its limit</source>
        <translation>der schlechteste: %1, %2 bei %3 seiner Marke</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenzfall</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>return</source>
        <translation>Rückkehr</translation>
    </message>
    <message>
        <source>stiffness over elasticity β/γ, the stiffest rate [1/t₀]</source>
        <translation>Steifigkeit durch Elastizität β/γ, die steifste Rate [1/t₀]</translation>
    </message>
    <message>
        <source>worst check over its limit</source>
        <translation>schlechtestes Maß durch seine Marke</translation>
    </message>
    <message>
        <source>a case above has failed</source>
        <translation>ein Fall darüber ist durchgefallen</translation>
    </message>
    <message>
        <source>worst check</source>
        <translation>schlechteste</translation>
    </message>
    <message>
        <source>of its limit</source>
        <translation>ihrer Marke</translation>
    </message>
    <message>
        <source>uniform rod</source>
        <translation>gleichförmige Stange</translation>
    </message>
    <message>
        <source>The rod rebounds with e = %1.</source>
        <translation>Die Stange prallt mit e = %1 zurück.</translation>
    </message>
    <message>
        <source>Stress in the rod</source>
        <translation>Spannung in der Stange</translation>
    </message>
    <message>
        <source>at the middle of the rod</source>
        <translation>in der Mitte der Stange</translation>
    </message>
    <message>
        <source>The force N %1 and its waves, the impact force, its impulse and the momentum of the rod over time.</source>
        <translation>Die Kraft N %1 und ihre Wellen, die Kraft auf das Gestein, ihr Kraftstoß und der Impuls der Stange über der Zeit.</translation>
    </message>
    <message>
        <source>The largest tension and compression along the rod, during the blow and in the residual waves.</source>
        <translation>Der größte Zug und Druck entlang der Stange, während der Schlag dauert und von den Restwellen.</translation>
    </message>
    <message>
        <source>%1 from the struck end</source>
        <translation>%1 vom Hammer</translation>
    </message>
    <message>
        <source>%1 from the hammer, %2</source>
        <translation>%1 vom Hammer, %2</translation>
    </message>
    <message>
        <source>place x: must be at most %1, the length of the rod</source>
        <translation>Stelle x: darf höchstens %1 sein, die Länge der Stange</translation>
    </message>
    <message>
        <source>drill string</source>
        <translation>Bohrstrang</translation>
    </message>
    <message>
        <source>Stress in hammer and string</source>
        <translation>Spannung in Hammer und Strang</translation>
    </message>
    <message>
        <source>in the middle of the longest section</source>
        <translation>in der Mitte des längsten Abschnitts</translation>
    </message>
    <message>
        <source>The force N %1 and its waves, the impact force, its impulse and the momentum of the string over time.</source>
        <translation>Die Kraft N %1 und ihre Wellen, die Kraft auf das Gestein, ihr Kraftstoß und der Impuls des Strangs über der Zeit.</translation>
    </message>
    <message>
        <source>The largest tension and compression along hammer (below 0) and string during the blow, with the strengths of the sections.</source>
        <translation>Der größte Zug und Druck entlang Hammer (unter 0) und Strang, während der Schlag dauert, mit den Festigkeiten der Abschnitte.</translation>
    </message>
    <message>
        <source>%1 from the struck end, %2</source>
        <translation>%1 vom hammerseitigen Ende, %2</translation>
    </message>
    <message>
        <source>place x: must be at most %1, the length of the string</source>
        <translation>Stelle x: darf höchstens %1 sein, die Länge des Strangs</translation>
    </message>
    <message>
        <source>feed force</source>
        <translation>Andruck</translation>
    </message>
    <message>
        <source>Each strip runs from the required feed force to the one that returns the rod in time.</source>
        <translation>Jeder Streifen reicht vom erforderlichen Andruck bis zu dem, der die Stange rechtzeitig zurückbringt.</translation>
    </message>
    <message>
        <source>W and E₀ are the work of the force on the string.</source>
        <translation>W und E₀ sind die Arbeit der Kraft am Strang.</translation>
    </message>
    <message>
        <source>this scenario</source>
        <translation>dieses Szenario</translation>
    </message>
    <message>
        <source>%1, this scenario</source>
        <translation>%1, dieses Szenario</translation>
    </message>
    <message>
        <source>rod without waves</source>
        <translation>Stange ohne Wellen</translation>
    </message>
    <message>
        <source>%1, no waves</source>
        <translation>%1, keine Wellen</translation>
    </message>
    <message>
        <source>%1, closed form</source>
        <translation>%1, geschlossene Form</translation>
    </message>
    <message>
        <source>%1 everywhere</source>
        <translation>%1 überall</translation>
    </message>
    <message>
        <source>%1 at %2 places</source>
        <translation>%1 an %2 Stellen</translation>
    </message>
    <message>
        <source>%1 at %2, nowhere else in this range</source>
        <translation>%1 bei %2, sonst nirgends in diesem Bereich</translation>
    </message>
    <message>
        <source>%1 at %2, perhaps elsewhere too</source>
        <translation>%1 bei %2, vielleicht auch anderswo</translation>
    </message>
    <message>
        <source>%1 reaches it at %2</source>
        <translation>%1 erreicht es bei %2</translation>
    </message>
    <message>
        <source>%1 is above it everywhere</source>
        <translation>%1 liegt überall darüber</translation>
    </message>
    <message>
        <source>%1 is below it everywhere</source>
        <translation>%1 liegt überall darunter</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1, the end of the range</source>
        <translation>%1, am Ende des Bereichs</translation>
    </message>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1 reicht von %2 bis %3</translation>
    </message>
    <message>
        <source>the largest %1 is %2</source>
        <translation>größter Wert %1: %2</translation>
    </message>
    <message>
        <source>the smallest %1 is %2</source>
        <translation>kleinster Wert %1: %2</translation>
    </message>
    <message>
        <source>e = 1 at %1 places</source>
        <translation>e = 1 an %1 Stellen</translation>
    </message>
    <message>
        <source>e = 1 at %1</source>
        <translation>e = 1 bei %1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>There is no answer anywhere in this range.</source>
        <translation>In diesem Bereich gibt es nirgends eine Antwort.</translation>
    </message>
    <message>
        <source>the curve has %1 points</source>
        <translation>die Kurve hat %1 Punkte</translation>
    </message>
    <message>
        <source>only points are known in a part of the range</source>
        <translation>in einem Teil des Bereichs sind nur einzelne Punkte bekannt</translation>
    </message>
    <message>
        <source>there is no answer in a part of the range: %1</source>
        <translation>in einem Teil des Bereichs gibt es keine Antwort: %1</translation>
    </message>
    <message>
        <source>%1 would yield: the stress in this section reaches %2, at %3 from its rear end and %4 after the start of the blow. Its yield strength is %5.</source>
        <translation>%1 würde fließen: die Spannung in diesem Abschnitt erreicht %2, %3 von seinem hinteren Ende und %4 nach Beginn des Schlags. Seine Streckgrenze ist %5.</translation>
    </message>
    <message>
        <source>The rod would yield: during the blow the stress reaches %1, at %2 from the hammer and %3 after the start of the blow. Its yield strength is %4.</source>
        <translation>Die Stange würde fließen: während des Schlags erreicht die Spannung %1, %2 vom Hammer und %3 nach Beginn des Schlags. Ihre Streckgrenze ist %4.</translation>
    </message>
    <message>
        <source>After the blow, residual waves would make the rod yield; the waves are not damped here. The stress reaches %1, at %2 from the hammer and %3 after the start of the blow. The yield strength is %4.</source>
        <translation>Nach dem Schlag würden die Restwellen die Stange fließen lassen; die Wellen sind hier nicht gedämpft. Die Spannung erreicht %1, %2 vom Hammer und %3 nach Beginn des Schlags. Die Streckgrenze ist %4.</translation>
    </message>
    <message>
        <source>Every blow loads %1 above its fatigue strength of %5. The stress reaches %2, at %3 from the rear end of this section and %4 after the start of the blow.</source>
        <translation>Jeder Schlag belastet %1 über die Dauerfestigkeit von %5. Die Spannung erreicht %2, in %3 vom hinteren Ende dieses Abschnitts und %4 nach Beginn des Schlags.</translation>
    </message>
    <message>
        <source>Every blow loads the rod above its fatigue strength of %4. During the blow, the stress reaches %1, at %2 from the hammer and %3 after the start of the blow.</source>
        <translation>Jeder Schlag belastet die Stange über ihre Dauerfestigkeit von %4. Während des Schlags erreicht die Spannung %1, %2 vom Hammer und %3 nach Beginn des Schlags.</translation>
    </message>
    <message>
        <source>Every blow loads the rod above its fatigue strength of %4, by residual waves that are not damped here. The stress reaches %1, at %2 from the hammer and %3 after the start of the blow.</source>
        <translation>Jeder Schlag belastet die Stange über ihre Dauerfestigkeit von %4, durch Restwellen, die hier nicht gedämpft sind. Die Spannung erreicht %1, %2 vom Hammer und %3 nach Beginn des Schlags.</translation>
    </message>
    <message>
        <source>%1 in compression</source>
        <translation>%1 Druck</translation>
    </message>
    <message>
        <source>%1 in tension</source>
        <translation>%1 Zug</translation>
    </message>
    <message>
        <source>The choice of the design makes no difference: the objective %1 is %2, within %3, for all %4 designs.</source>
        <translation>Die Wahl der Auslegung macht keinen Unterschied: die Zielgröße %1 ist bei allen %4 Auslegungen %2, auf %3 genau.</translation>
    </message>
    <message>
        <source>The choice of %1 makes no difference: the objective %2 is %3, within %4, for all %5 designs.</source>
        <translation>Die Wahl von %1 macht keinen Unterschied: die Zielgröße %2 ist bei allen %5 Auslegungen %3, auf %4 genau.</translation>
    </message>
    <message>
        <source>The choice of %1 makes no difference to the objectives and limits.</source>
        <translation>Die Wahl von %1 macht für Zielgrößen und Grenzen keinen Unterschied.</translation>
    </message>
    <message>
        <source>Number of other warnings for this design: %1.</source>
        <translation>Zahl der weiteren Warnungen für diese Auslegung: %1.</translation>
    </message>
    <message>
        <source>The highest penetration rate of the scan, %1, is reached with %2.</source>
        <translation>Der höchste Bohrfortschritt im untersuchten Bereich, %1, wird mit %2 erreicht.</translation>
    </message>
    <message>
        <source>blow</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>gap modulo d₀, in d₀</source>
        <translation>Spalt modulo d₀, in d₀</translation>
    </message>
    <message>
        <source>e at this gap</source>
        <translation>e dieses Spalts</translation>
    </message>
    <message>
        <source>next gap</source>
        <translation>nächster Spalt</translation>
    </message>
    <message>
        <source>remaining energy %1</source>
        <translation>verbliebene Energie %1</translation>
    </message>
    <message>
        <source>new rock faces %1</source>
        <translation>neue Gesteinsflächen %1</translation>
    </message>
    <message>
        <source>lost waves %1</source>
        <translation>Wellen, verloren %1</translation>
    </message>
    <message>
        <source>damper %1</source>
        <translation>Dämpfer %1</translation>
    </message>
    <message>
        <source>rock %1</source>
        <translation>Gestein %1</translation>
    </message>
    <message>
        <source>share of the energy</source>
        <translation>Energieanteil</translation>
    </message>
    <message>
        <source>rod bouncing at the start</source>
        <translation>Stange springt zu Beginn</translation>
    </message>
    <message>
        <source>blows in contact</source>
        <translation>Schläge im Kontakt</translation>
    </message>
    <message>
        <source>constant force</source>
        <translation>konstante Kraft</translation>
    </message>
    <message>
        <source>dashpot of half the impedance</source>
        <translation>Dämpfer der halben Impedanz</translation>
    </message>
    <message>
        <source>strip: 95 % confidence interval of the penetration rate</source>
        <translation>Streifen: 95-%-Vertrauensbereich des Bohrfortschritts</translation>
    </message>
    <message>
        <source>mean: over the shaded blows</source>
        <translation>Mittelwert: über die schattierten Schläge</translation>
    </message>
    <message>
        <source>gap and next gap: a projection from more dimensions</source>
        <translation>Spalt und nächster Spalt: eine Projektion weiterer Dimensionen</translation>
    </message>
    <message>
        <source>Gap and penetration of %1 of %2 blows; the first %3 are transient and excluded.</source>
        <translation>Spalt und Eindringung von %1 von %2 Schlägen; die ersten %3 schwingen sich ein und zählen nicht.</translation>
    </message>
    <message>
        <source>Penetration rate, contact share and gaps over %1.</source>
        <translation>Bohrfortschritt, Kontaktanteil und Spalte über %1.</translation>
    </message>
    <message>
        <source>scan of an earlier scenario: scan again</source>
        <translation>Durchlauf eines früheren Szenarios: neu durchlaufen</translation>
    </message>
    <message>
        <source>5 % to 95 %</source>
        <translation>5 % bis 95 %</translation>
    </message>
    <message>
        <source>with the values entered</source>
        <translation>mit den eingegebenen Werten</translation>
    </message>
    <message>
        <source>share of the scatter
(filled: without interactions)</source>
        <translation>Anteil an der Streuung
(gefüllt: ohne Wechselwirkung)</translation>
    </message>
    <message>
        <source>%1: no scatter</source>
        <translation>%1: streut nicht</translation>
    </message>
    <message>
        <source>%1 of %2 designs, best for uncertain rock %3</source>
        <translation>%1 von %2 Auslegungen, beste für ungenau bekanntes Gestein %3</translation>
    </message>
    <message>
        <source>on average</source>
        <translation>im Mittel</translation>
    </message>
    <message>
        <source>in the smallest sample</source>
        <translation>bei der kleinsten Stichprobe</translation>
    </message>
    <message>
        <source>in the largest sample</source>
        <translation>bei der größten Stichprobe</translation>
    </message>
    <message>
        <source>for the values entered</source>
        <translation>für die eingegebenen Werte</translation>
    </message>
    <message>
        <source>in the middle (median)</source>
        <translation>in der Mitte (Median)</translation>
    </message>
    <message>
        <source>reached in %1 % of cases</source>
        <translation>in %1&#xa0;% der Fälle erreicht</translation>
    </message>
    <message>
        <source>not exceeded in %1 % of cases</source>
        <translation>in %1&#xa0;% der Fälle nicht überschritten</translation>
    </message>
    <message>
        <source>at %1 ≈ %2</source>
        <translation>bei %1 ≈ %2</translation>
    </message>
    <message>
        <source>No point could be solved.</source>
        <translation>Kein Punkt konnte gelöst werden.</translation>
    </message>
    <message>
        <source>The map follows.</source>
        <translation>Das Kennfeld folgt.</translation>
    </message>
    <message>
        <source>%1 is not reached</source>
        <translation>%1 wird nicht erreicht</translation>
    </message>
    <message>
        <source>%1 of %2 points not solved (hatched)</source>
        <translation>%1 von %2 Punkten nicht gelöst (schraffiert)</translation>
    </message>
    <message>
        <source>%1 exceeds %2 only where %3 is above %5. At %4 = %6, %3 = %5 is enough.</source>
        <translation>%1 übersteigt %2 nur, wo %3 über %5 liegt. Bei %4 = %6 genügt %3 = %5.</translation>
    </message>
    <message>
        <source>%1 exceeds %2 only where %3 is below %5. At %4 = %6, %3 = %5 is low enough.</source>
        <translation>%1 übersteigt %2 nur, wo %3 unter %5 liegt. Bei %4 = %6 ist %3 = %5 klein genug.</translation>
    </message>
    <message>
        <source>present design: %1</source>
        <translation>jetzige Auslegung: %1</translation>
    </message>
    <message>
        <source>it takes %1 computing steps, more than the %2 permitted, about %3; fewer blows or --cells take less, --work-limit permits more</source>
        <translation>es kostet %1 Rechenschritte, mehr als die erlaubten %2, und dauert etwa %3; weniger Schläge oder ein kleineres --cells kosten weniger, ein höheres --work-limit erlaubt mehr</translation>
    </message>
    <message>
        <source>note: %1 sets %2, which is one section with a repeat; to set only one of them, write the sections out in FILE without the repeat</source>
        <translation>Hinweis: %1 setzt %2, einen Abschnitt mit Wiederholung; um nur einen davon zu setzen, in FILE die Abschnitte ohne Wiederholung einzeln aufschreiben</translation>
    </message>
    <message>
        <source>Change %1 from %2 to %3: this improves %4 from %6 to %5.</source>
        <translation>%1 von %2 auf %3 ändern. Das verbessert die Zielgröße „%4“ von %6 auf %5.</translation>
    </message>
    <message>
        <source>Change the design from %1 to %2: this improves %3 from %5 to %4.</source>
        <translation>Von der Auslegung %1 auf %2 wechseln. Das verbessert die Zielgröße „%3“ von %5 auf %4.</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for a single blow at any gap (%2 required).</source>
        <translation>Ein Andruck von %1 reicht für einen einzelnen Schlag, gleich bei welchem Spalt vor der Krone (%2 erforderlich).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow and for rigid rock (%2 required); other gaps between bit and rock were not examined.</source>
        <translation>Ein Andruck von %1 reicht für diesen Schlag und für starres Gestein (%2 erforderlich); andere Spalte zwischen Bohrkrone und Gestein wurden nicht untersucht.</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for a single blow at any gap. It even returns an undamped rod to the rock before the next blow (this requires %2).</source>
        <translation>Ein Andruck von %1 reicht für einen einzelnen Schlag, gleich bei welchem Spalt vor der Krone. Er bringt sogar eine ungedämpfte Stange vor dem nächsten Schlag zurück ans Gestein (dafür sind %2 erforderlich).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow and for rigid rock. It even returns an undamped rod to the rock before the next blow (this requires %2). Other gaps between bit and rock were not examined.</source>
        <translation>Ein Andruck von %1 reicht für diesen Schlag und für starres Gestein. Er bringt sogar eine ungedämpfte Stange vor dem nächsten Schlag zum Gestein zurück (das erfordert %2). Andere Spalte zwischen Bohrkrone und Gestein wurden nicht untersucht.</translation>
    </message>
    <message>
        <source>For this blow, the feed force must be at least %1 at a blow frequency of %2.</source>
        <translation>Für diesen Schlag muss der Andruck bei einer Schlagfrequenz von %2 mindestens %1 sein.</translation>
    </message>
    <message>
        <source>For this blow, the feed force must be at least %1 at %2, or the blow frequency at most %3 with the present feed force.</source>
        <translation>Für diesen Schlag muss der Andruck bei %2 mindestens %1 sein, oder die Schlagfrequenz beim jetzigen Andruck höchstens %3.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for this blow, by %2 for every gap between bit and rock.</source>
        <translation>Mit %1 mehr Andruck reicht er für diesen Schlag, mit %2 mehr für jeden Spalt zwischen Bohrkrone und Gestein.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for this blow, by %2 for rigid rock.</source>
        <translation>Mit %1 mehr Andruck reicht er für diesen Schlag, mit %2 mehr für starres Gestein.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for every gap between bit and rock.</source>
        <translation>Mit %1 mehr Andruck reicht er für jeden Spalt zwischen Bohrkrone und Gestein.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for rigid rock.</source>
        <translation>Mit %1 mehr Andruck reicht er für starres Gestein.</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow (%2 required), but not for every gap between bit and rock (up to %3 required).</source>
        <translation>Ein Andruck von %1 reicht für diesen Schlag (%2 erforderlich), aber nicht für jeden Spalt zwischen Bohrkrone und Gestein (bis %3 erforderlich).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow (%2 required), but not for rigid rock (%3 required).</source>
        <translation>Ein Andruck von %1 reicht für diesen Schlag (%2 erforderlich), aber nicht für starres Gestein (%3 erforderlich).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow (%2 required), but not for rigid rock (%3 required). Other gaps between bit and rock were not examined.</source>
        <translation>Ein Andruck von %1 reicht für diesen Schlag (%2 erforderlich), aber nicht für starres Gestein (%3 erforderlich). Andere Spalte zwischen Bohrkrone und Gestein wurden nicht untersucht.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %1, the weight of machine and rod along the hole is already enough for this blow and for rigid rock.</source>
        <translation>Es ist kein Andruck angegeben. Bei einer Schlagfrequenz von %1 reicht schon das Gewicht von Maschine und Stange längs des Bohrlochs für diesen Schlag und für starres Gestein.</translation>
    </message>
    <message>
        <source>required feed</source>
        <translation>erforderlicher Andruck</translation>
    </message>
    <message>
        <source>enough up to</source>
        <translation>reicht bis</translation>
    </message>
    <message>
        <source>Up to this blow frequency the effective feed force is at least the required one</source>
        <translation>Bis zu dieser Schlagfrequenz reicht der wirksame Andruck</translation>
    </message>
    <message>
        <source>The force for every gap is that for fully elastic rock. In this rock, the feed force is enough for %1 of all gaps.</source>
        <translation>Die Kraft für jeden Spalt ist die für vollelastisches Gestein. In diesem Gestein reicht der Andruck für %1 aller Spalte.</translation>
    </message>
    <message>
        <source>is not a rock; give the preset of a rock</source>
        <translation>ist kein Gestein; die Voreinstellung eines Gesteins angeben</translation>
    </message>
    <message>
        <source>a design does not choose its rock; vary the rock with --uncertain, such as bit_rock.stiffness=50MN/m:250MN/m</source>
        <translation>eine Auslegung wählt ihr Gestein nicht; das Gestein mit --uncertain variieren, etwa bit_rock.stiffness=50MN/m:250MN/m</translation>
    </message>
    <message>
        <source>its waves are kept in %1 cells, more than the %2 permitted; a longer blow, a shorter string or fewer --cells need less</source>
        <translation>seine Wellen liegen in %1 Zellen, mehr als die erlaubten %2; ein längerer Schlag, ein kürzerer Strang oder weniger --cells brauchen weniger</translation>
    </message>
    <message>
        <source>the waves of its blows at all gaps have more polynomial pieces than a quick study permits</source>
        <translation>die Wellen seiner Schläge bei allen Spalten haben mehr Polynomstücke, als eine schnelle Studie erlaubt</translation>
    </message>
    <message>
        <source>`%1` names presets, not a parameter; `sweep --vary %1=all` compares them</source>
        <translation>`%1` benennt Voreinstellungen, keinen Parameter; `sweep --vary %1=all` vergleicht sie</translation>
    </message>
    <message>
        <source>its histories have more than 4 million polynomial pieces, because of very many reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer</source>
        <translation>seine Verläufe haben mehr als 4 Millionen Polynomstücke, wegen sehr vieler Reflexionen; ein steiferes Gestein, ein größeres gamma oder ein kürzerer Schlag braucht weniger</translation>
    </message>
    <message>
        <source>its histories have more than 4 million polynomial pieces: the rock is so soft that the waves pass the rod millions of times in one contact; a stiffer rock needs fewer</source>
        <translation>seine Verläufe haben mehr als 4 Millionen Polynomstücke: das Gestein ist so weich, dass die Wellen die Stange in einem Kontakt millionenfach durchlaufen; ein steiferes Gestein braucht weniger</translation>
    </message>
    <message>
        <source>its waves have more polynomial pieces than the work limit permits, because of very many reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer</source>
        <translation>seine Wellen haben mehr Polynomstücke, als die Aufwandsgrenze erlaubt, wegen sehr vieler Reflexionen; ein steiferes Gestein, ein größeres gamma oder ein kürzerer Schlag braucht weniger</translation>
    </message>
    <message>
        <source>it takes more computing steps than the work limit permits: try fewer sections, lengths with a common divisor or a shorter end_time</source>
        <translation>der Schlag braucht mehr Rechenschritte, als die Aufwandsgrenze erlaubt: weniger Abschnitte, Längen mit gemeinsamem Teiler oder eine frühere end_time brauchen weniger</translation>
    </message>
    <message>
        <source>its sequence of blows takes more computing steps than the work limit permits</source>
        <translation>seine Schlagfolge braucht mehr Rechenschritte, als die Aufwandsgrenze erlaubt</translation>
    </message>
    <message>
        <source>its blows would take %1 computing steps, more than the work limit of %2, because contact changes very often; a larger gamma, fewer blows or a higher frequency take less</source>
        <translation>seine Schläge brauchten %1 Rechenschritte, mehr als die Aufwandsgrenze von %2, weil der Kontakt sehr oft wechselt; ein größeres gamma, weniger Schläge oder eine höhere Frequenz brauchen weniger</translation>
    </message>
    <message>
        <source>Enter a goal for %1 to find where it is reached.</source>
        <translation>Einen Zielwert für %1 eingeben, um zu finden, wo er erreicht wird.</translation>
    </message>
    <message>
        <source>The largest value of %1 is %2, at %3 = %5 and %4 = %6. The smallest is %9, at %3 = %7 and %4 = %8.</source>
        <translation>Der größte Wert von %1 ist %2, bei %3 = %5 und %4 = %6. Der kleinste ist %9, bei %3 = %7 und %4 = %8.</translation>
    </message>
    <message>
        <source>%1
(filled dots: no other design is better in both)</source>
        <translation>%1
(gefüllte Punkte: keine andere Auslegung ist in beidem besser)</translation>
    </message>
    <message>
        <source> (%1 compared with the present value)</source>
        <translation> (%1 gegenüber dem jetzigen Wert)</translation>
    </message>
    <message>
        <source>No single measurement would bring the uncertainty of %1 below 100 %.</source>
        <translation>Keine einzelne Messung brächte die Unsicherheit von %1 unter 100 %.</translation>
    </message>
    <message>
        <source>over 100 %</source>
        <translation>über 100 %</translation>
    </message>
    <message>
        <source>%1 has no extremes in this range</source>
        <translation>%1 hat in diesem Bereich keine Extrema</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>best, by less than the error</source>
        <translation>beste, Vorsprung kleiner als der Fehler</translation>
    </message>
    <message>
        <source>known to within %1</source>
        <translation>bekannt auf %1</translation>
    </message>
    <message>
        <source>uncertain by %1</source>
        <translation>unsicher um %1</translation>
    </message>
    <message>
        <source>not known: uncertain by more than a factor of 10</source>
        <translation>nicht bekannt: um mehr als den Faktor 10 unsicher</translation>
    </message>
    <message>
        <source>%1 +-%2 instead of +-%3</source>
        <translation>%1 +-%2 statt +-%3</translation>
    </message>
    <message>
        <source>To know more: record until the rock has unloaded, up to 1 ms after the reflection arrives.</source>
        <translation>Um mehr zu wissen: aufzeichnen, bis sich das Gestein entlastet hat, bis zu 1 ms nach Ankunft der Reflexion.</translation>
    </message>
    <message>
        <source>To know more: measure the distance between the gauges to %1: %2.</source>
        <translation>Um mehr zu wissen: den Abstand der Messstellen voneinander auf %1 messen: %2.</translation>
    </message>
    <message>
        <source>beyond noise, the model leaves an rms of %1 of the peak; the noise is %2</source>
        <translation>über das Rauschen hinaus lässt das Modell im Effektivwert %1 der Spitze übrig; das Rauschen ist %2</translation>
    </message>
    <message>
        <source>the wave behind the specimen is predicted with an rms error of %1 of its peak; it was measured %2 earlier</source>
        <translation>die Welle hinter der Probe ist mit einem Effektivwert des Fehlers von %1 ihrer Spitze vorhergesagt; gemessen wurde sie %2 früher</translation>
    </message>
    <message>
        <source>the wave behind the specimen is predicted with an rms error of %1 of its peak; it was measured %2 later</source>
        <translation>die Welle hinter der Probe ist mit einem Effektivwert des Fehlers von %1 ihrer Spitze vorhergesagt; gemessen wurde sie %2 später</translation>
    </message>
    <message>
        <source>a factor of %1 lowers this error to %2: the gain of that gauge or the bar there may differ</source>
        <translation>der Faktor %1 senkt diesen Fehler auf %2: die Verstärkung dieser Messstelle oder der Stab dort kann anders sein</translation>
    </message>
    <message>
        <source>The position of the gauge or the wave speed in the scenario file does not match the record.</source>
        <translation>Die Lage der Messstelle oder die Wellengeschwindigkeit in der Szenariodatei passt nicht zur Aufzeichnung.</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>eine Gerade</translation>
    </message>
    <message>
        <source>one corner</source>
        <translation>eine Ecke</translation>
    </message>
    <message>
        <source>crater of a blow before</source>
        <translation>Krater eines früheren Schlags</translation>
    </message>
    <message>
        <source>power law</source>
        <translation>Potenzgesetz</translation>
    </message>
    <message>
        <source>dashpot</source>
        <translation>Dämpfer</translation>
    </message>
    <message>
        <source>overload of the amplifier</source>
        <translation>Übersteuerung des Verstärkers</translation>
    </message>
    <message>
        <source>jump of the zero level</source>
        <translation>Sprung des Nullpunkts</translation>
    </message>
    <message>
        <source>that of the scenario</source>
        <translation>das des Szenarios</translation>
    </message>
    <message>
        <source>the reflection arrives after %1, the file says %2; a gauge %3 from the bit would fit: measure its distance</source>
        <translation>die Reflexion kommt nach %1 an, die Datei sagt %2; eine Messstelle %3 von der Krone würde passen: ihren Abstand messen</translation>
    </message>
    <message>
        <source>feeds: f I₀ mean blow force, f I₀(1+e) required, f I₀(1+2e) returns an undamped rod before the next blow</source>
        <translation>Andrücke: f I₀ mittlere Kraft der Schläge, f I₀(1+e) erforderlich, f I₀(1+2e) bringt eine ungedämpfte Stange vor dem nächsten Schlag zurück</translation>
    </message>
    <message>
        <source>fully elastic rock (gamma = 1), worst gap</source>
        <translation>vollelastisches Gestein (gamma = 1), ungünstigster Spalt</translation>
    </message>
    <message>
        <source>misfit</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>The model agrees with %1 of %2 records.</source>
        <translation>Das Modell stimmt mit %1 von %2 Aufzeichnungen überein.</translation>
    </message>
    <message>
        <source>The stiffness of the rock changes from blow to blow: at the next blow, it will be between %1 and %2 (95 %).</source>
        <translation>Die Steifigkeit des Gesteins ändert sich von Schlag zu Schlag: Beim nächsten Schlag liegt sie zwischen %1 und %2 (95 %).</translation>
    </message>
    <message>
        <source>No change of the rock&apos;s stiffness is seen from blow to blow: at the next blow, it will be between %1 and %2 (95 %).</source>
        <translation>Von Schlag zu Schlag ist keine Änderung der Steifigkeit zu sehen: Beim nächsten Schlag liegt sie zwischen %1 und %2 (95 %).</translation>
    </message>
    <message>
        <source>largest force of the table</source>
        <translation>größte Kraft der Tabelle</translation>
    </message>
    <message>
        <source>Feed force over %1, for %2. Each strip runs from the required feed force to the one that returns the rod in time. The shades behind the strips show what a feed force does for the rebound of this blow.</source>
        <translation>Andruck über %1, für %2. Jeder Streifen reicht vom erforderlichen Andruck bis zu dem, der die Stange rechtzeitig zurückbringt. Die Töne dahinter zeigen, was ein Andruck beim Rückprall dieses Schlags bewirkt.</translation>
    </message>
    <message>
        <source>These values give the same penetration rate within the errors of the computation: %1.</source>
        <translation>Diese Werte ergeben im Rahmen der Rechenfehler denselben Bohrfortschritt: %1.</translation>
    </message>
</context>
<context>
    <name>drillwave::MissingFields</name>
    <message>
        <source>enter the %1:</source>
        <translation>%1 eingeben:</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>ohne</translation>
    </message>
</context>
<context>
    <name>drillwave::Notice</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Dismiss this note</source>
        <translation>Diesen Hinweis schließen</translation>
    </message>
</context>
<context>
    <name>drillwave::NumbersWindow</name>
    <message>
        <source>%1 rows, %2 columns</source>
        <translation>%1 Zeilen, %2 Spalten</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
</context>
<context>
    <name>drillwave::OptionFields</name>
    <message>
        <source>%1, unit</source>
        <translation>%1, Einheit</translation>
    </message>
</context>
<context>
    <name>drillwave::OutputBox</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Which result is shown</source>
        <translation>Welches Ergebnis gezeigt wird</translation>
    </message>
</context>
<context>
    <name>drillwave::Page</name>
    <message>
        <source>Copy answer</source>
        <translation>Antwort kopieren</translation>
    </message>
    <message>
        <source>Copies answer and sentences below it as text</source>
        <translation>Kopiert die Antwort und die Sätze darunter als Text</translation>
    </message>
</context>
<context>
    <name>drillwave::PageTabs</name>
    <message>
        <source>THIS BLOW</source>
        <translation>DIESER SCHLAG</translation>
    </message>
    <message>
        <source>STUDIES</source>
        <translation>STUDIEN</translation>
    </message>
    <message>
        <source>&amp;Next page</source>
        <translation>&amp;Nächste Seite</translation>
    </message>
    <message>
        <source>&amp;Previous page</source>
        <translation>&amp;Vorige Seite</translation>
    </message>
    <message>
        <source>only for drill strings, and this scenario is a uniform rod: a click converts it, as Edit ▸ Make a drill string of this does</source>
        <translation>nur für Bohrstränge, und dieses Szenario ist eine gleichförmige Stange: ein Klick macht einen Bohrstrang daraus, wie Bearbeiten ▸ Bohrstrang daraus machen</translation>
    </message>
</context>
<context>
    <name>drillwave::ParameterRow</name>
    <message>
        <source>%1, slider</source>
        <translation>%1, Schieber</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, Einheit</translation>
    </message>
    <message>
        <source>Unit in which the %1 is shown</source>
        <translation>Einheit, in der %1 gezeigt wird</translation>
    </message>
    <message>
        <source>The value is outside the range of the slider.</source>
        <translation>Der Wert liegt außerhalb des Bereichs des Schiebers.</translation>
    </message>
    <message>
        <source>Find the value that gives…</source>
        <translation>Wert suchen, der ergibt…</translation>
    </message>
</context>
<context>
    <name>drillwave::PictureCursors</name>
    <message>
        <source>t = %1</source>
        <translation>t = %1</translation>
    </message>
    <message>
        <source>x/L = %1</source>
        <translation>x/L = %1</translation>
    </message>
</context>
<context>
    <name>drillwave::PictureDialog</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>dpi</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG – pixels</source>
        <translation>PNG – Pixel</translation>
    </message>
    <message>
        <source>SVG – lines and text, for editing</source>
        <translation>SVG – Linien und Text, zum Bearbeiten</translation>
    </message>
    <message>
        <source>PDF – lines and text, for printing</source>
        <translation>PDF – Linien und Text, zum Drucken</translation>
    </message>
    <message>
        <source>File format; the background is always white</source>
        <translation>Die Art der Datei; immer auf Weiß, wie auch das Fenster aussieht</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Breite auf dem Papier</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>Höhe auf dem Papier</translation>
    </message>
    <message>
        <source>Pixels per inch of a PNG; 300 is usual for print</source>
        <translation>Pixel je Zoll eines PNG; 300 sind für den Druck üblich</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>&amp;Auflösung</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Sharp at any size</source>
        <translation>Scharf in jeder Größe</translation>
    </message>
</context>
<context>
    <name>drillwave::PinnedRuns</name>
    <message>
        <source>&amp;Pin this result</source>
        <translation>Dieses Ergebnis an&amp;heften</translation>
    </message>
    <message>
        <source>&amp;Keep runs beside the file</source>
        <translation>Läufe neben der Datei auf&amp;bewahren</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Anheften</translation>
    </message>
    <message>
        <source>Keep this result with its scenario, to compare others with (F7)</source>
        <translation>Dieses Ergebnis mit seinem Szenario behalten, um andere damit zu vergleichen (F7)</translation>
    </message>
    <message>
        <source>In a folder of the same name, “.runs”: a scenario for each, so that they are there when the file is opened again</source>
        <translation>In einem Ordner desselben Namens, „.runs“: ein Szenario für jeden, damit sie da sind, wenn die Datei wieder geöffnet wird</translation>
    </message>
    <message>
        <source>There is no result to be pinned.</source>
        <translation>Es gibt kein Ergebnis, das angeheftet werden könnte.</translation>
    </message>
    <message>
        <source>This result cannot be pinned.</source>
        <translation>Dieses Ergebnis kann nicht angeheftet werden.</translation>
    </message>
    <message>
        <source>This result is not pinned.</source>
        <translation>Dieses Ergebnis ist nicht angeheftet.</translation>
    </message>
    <message>
        <source>revert to %1</source>
        <translation>zurück zu %1</translation>
    </message>
    <message>
        <source>The run cannot be brought back.</source>
        <translation>Der Lauf kann nicht zurückgebracht werden.</translation>
    </message>
    <message>
        <source>Delete the kept runs?</source>
        <translation>Sollen die aufbewahrten Läufe weggenommen werden?</translation>
    </message>
    <message>
        <source>%1
They stay on the list until the window is closed.</source>
        <translation>%1
Sie bleiben in der Liste, bis das Fenster geschlossen wird.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>There are runs beside this file already.</source>
        <translation>Neben dieser Datei gibt es schon Läufe.</translation>
    </message>
    <message>
        <source>%1
Runs that are not on the list here would be lost.</source>
        <translation>%1
Jene, die hier nicht in der Liste sind, gingen verloren.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>The runs are not kept.</source>
        <translation>Die Läufe sind nicht aufbewahrt.</translation>
    </message>
</context>
<context>
    <name>drillwave::PlaceField</name>
    <message>
        <source>Section x/L of the waves</source>
        <translation>Stelle x/L der Wellen</translation>
    </message>
    <message>
        <source>
Up and Down move it by 0.01, Page Up and Page Down by 0.1.</source>
        <translation>
Hoch und Runter verschieben sie um 0,01, Bild auf und Bild ab um 0,1.</translation>
    </message>
</context>
<context>
    <name>drillwave::PlayBar</name>
    <message>
        <source>Time cursor</source>
        <translation>Zeitcursor</translation>
    </message>
    <message>
        <source>Moves the time cursor through the times in view</source>
        <translation>Bewegt den Zeitcursor durch die Zeiten im Bild</translation>
    </message>
    <message>
        <source>in %1 s</source>
        <translation>in %1 s</translation>
    </message>
    <message>
        <source>Duration of playing the times in view</source>
        <translation>Wie lange das Abspielen der Zeiten im Bild dauert</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>Immer wieder abspielen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Pause (space bar)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Play the blow (space bar)</source>
        <translation>Den Schlag abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>%1-mal langsamer</translation>
    </message>
    <message>
        <source>%1 t₀ per second</source>
        <translation>%1 t₀ je Sekunde</translation>
    </message>
</context>
<context>
    <name>drillwave::PlotMenu</name>
    <message>
        <source>Copy &amp;picture</source>
        <translation>B&amp;ild kopieren</translation>
    </message>
    <message>
        <source>The present view, black on white, for a report</source>
        <translation>Diese Ansicht, schwarz auf weiß, für einen Bericht</translation>
    </message>
    <message>
        <source>Copy &amp;data</source>
        <translation>&amp;Daten kopieren</translation>
    </message>
    <message>
        <source>The numbers of what is shown, as a table for a spreadsheet</source>
        <translation>Die Zahlen dessen, was gezeigt wird, als Tabelle für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>Bild &amp;speichern …</translation>
    </message>
    <message>
        <source>This view as PNG, SVG or PDF</source>
        <translation>Diese Ansicht als PNG, SVG oder PDF</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>Daten s&amp;peichern …</translation>
    </message>
    <message>
        <source>The numbers of what is shown, as CSV</source>
        <translation>Die Zahlen dessen, was gezeigt wird, als CSV</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Bring all curves into view</source>
        <translation>Alle Kurven ins Bild bringen</translation>
    </message>
    <message>
        <source>&amp;Zoom back</source>
        <translation>&amp;Zurück zoomen</translation>
    </message>
    <message>
        <source>The previous view</source>
        <translation>Die Ansicht davor</translation>
    </message>
    <message>
        <source>Logarithmic &amp;horizontal axis</source>
        <translation>&amp;Waagrechte Achse logarithmisch</translation>
    </message>
    <message>
        <source>Logarithmic &amp;vertical axis</source>
        <translation>Senk&amp;rechte Achse logarithmisch</translation>
    </message>
    <message>
        <source>Equal steps are equal ratios; values of zero are not shown</source>
        <translation>Gleiche Schritte sind gleiche Faktoren; Nullen werden abgeschnitten</translation>
    </message>
    <message>
        <source>&amp;Curves shown</source>
        <translation>&amp;Gezeigte Kurven</translation>
    </message>
    <message>
        <source>&amp;Point for keys</source>
        <translation>Punkt für &amp;Tasten</translation>
    </message>
    <message>
        <source>Arrows move the point, N goes to the next mark, Enter acts like a click</source>
        <translation>Pfeile bewegen ihn, N geht zur nächsten Marke; die Eingabetaste tut dann, was ein Klick dort tut</translation>
    </message>
    <message>
        <source>Cursor &amp;A here</source>
        <translation>Cursor &amp;A hier</translation>
    </message>
    <message>
        <source>Reads the curves here; drag it to move it</source>
        <translation>Liest die Kurven hier ab; lässt sich ziehen</translation>
    </message>
    <message>
        <source>Cursor &amp;B here</source>
        <translation>Cursor &amp;B hier</translation>
    </message>
    <message>
        <source>Reads the curves here; slope, mean and integral from A to B</source>
        <translation>Liest die Kurven hier ab; Steigung, Mittel und Integral von A bis B</translation>
    </message>
    <message>
        <source>&amp;Time cursor here</source>
        <translation>Zeitcursor &amp;hier</translation>
    </message>
    <message>
        <source>The time shown on all pages</source>
        <translation>Der Augenblick, der auf allen Seiten gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Remove cursors A and B</source>
        <translation>Cursor A und B ent&amp;fernen</translation>
    </message>
    <message>
        <source>The table below the plot then reads the values in view</source>
        <translation>Die Tabelle unter dem Diagramm liest dann ab, was im Bild ist</translation>
    </message>
    <message>
        <source>Copy the &amp;table below</source>
        <translation>Tabelle dar&amp;unter kopieren</translation>
    </message>
    <message>
        <source>The readings at the cursors, or the numbers in view, to paste into a spreadsheet</source>
        <translation>Was an den Cursorn oder im Bild abgelesen ist, zum Einfügen in eine Tabellenkalkulation</translation>
    </message>
</context>
<context>
    <name>drillwave::PlotPage</name>
    <message>
        <source>&amp;Data of this plot…</source>
        <translation>&amp;Daten dieses Diagramms …</translation>
    </message>
    <message>
        <source>The curves of the plot, as CSV</source>
        <translation>Die Kurven, die das Diagramm zeigt, als CSV</translation>
    </message>
    <message>
        <source>&amp;Picture of this plot…</source>
        <translation>&amp;Bild dieses Diagramms …</translation>
    </message>
    <message>
        <source>The present view, as PNG, SVG or PDF</source>
        <translation>Im gegenwärtigen Ausschnitt, als PNG, SVG oder PDF</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
</context>
<context>
    <name>drillwave::PlotViewMenu</name>
    <message>
        <source>&amp;Plot on show</source>
        <translation>Gezeigtes &amp;Diagramm</translation>
    </message>
    <message>
        <source>&amp;Table below plots</source>
        <translation>&amp;Tabelle unter den Diagrammen</translation>
    </message>
    <message>
        <source>Readings in view, or at the cursors A and B</source>
        <translation>Liest ab, was im Bild ist, oder an den Cursorn A und B</translation>
    </message>
    <message>
        <source>No plot</source>
        <translation>Kein Diagramm</translation>
    </message>
</context>
<context>
    <name>drillwave::PresetBox</name>
    <message>
        <source>%1: preset</source>
        <translation>%1: Voreinstellung</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>The values belong to no preset. Select one to start from its values.</source>
        <translation>Die Werte sind die keiner Voreinstellung. Eine wählen, um von ihren Werten auszugehen.</translation>
    </message>
    <message>
        <source>Presets have physical units, and this scenario has only dimensionless groups.</source>
        <translation>Voreinstellungen sind physikalische Werte, und dieses Szenario ist nur durch seine dimensionslosen Kennzahlen gegeben.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>&amp;Add file of presets…</source>
        <translation>Datei mit Voreinstellungen &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>Adds the presets of your own YAML file, also for later sessions</source>
        <translation>Die Voreinstellungen einer eigenen YAML-Datei anbieten, jetzt und künftig</translation>
    </message>
    <message>
        <source>&amp;Open folder of presets</source>
        <translation>&amp;Ordner der Voreinstellungen öffnen</translation>
    </message>
    <message>
        <source>A file presets.yaml in %1 is read automatically</source>
        <translation>Eine Datei presets.yaml in %1 wird von selbst gelesen</translation>
    </message>
    <message>
        <source>Remove these from the list</source>
        <translation>Diese aus der Liste entfernen</translation>
    </message>
    <message>
        <source>⚠ %1 is not used: why?</source>
        <translation>⚠ %1 wird nicht verwendet: warum?</translation>
    </message>
    <message>
        <source>The presets of %1 are not used.</source>
        <translation>Die Voreinstellungen von %1 werden nicht verwendet.</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Add a file of presets</source>
        <translation>Eine Datei mit Voreinstellungen hinzufügen</translation>
    </message>
    <message>
        <source>Presets (*.yaml *.yml);;All files (*)</source>
        <translation>Voreinstellungen (*.yaml *.yml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>These presets cannot be used.</source>
        <translation>Diese Voreinstellungen können nicht verwendet werden.</translation>
    </message>
    <message>
        <source>This preset does not fit the rest of the scenario.</source>
        <translation>Diese Voreinstellung passt nicht zum Rest des Szenarios.</translation>
    </message>
</context>
<context>
    <name>drillwave::PresetTicks</name>
    <message>
        <source>hammers</source>
        <translation>Hämmer</translation>
    </message>
    <message>
        <source>rods</source>
        <translation>Stangen</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>Bohrkronen</translation>
    </message>
    <message>
        <source>Ticked presets are compared as designs</source>
        <translation>Angekreuzte Voreinstellungen sind Auslegungen, die zur Wahl stehen</translation>
    </message>
    <message>
        <source>%1 to choose from</source>
        <translation>%1 zur Wahl</translation>
    </message>
</context>
<context>
    <name>drillwave::PulsePreview</name>
    <message>
        <source>Hammer force over time</source>
        <translation>Hammerkraft über der Zeit</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>Spitze %1</translation>
    </message>
    <message>
        <source>t₀ = %1</source>
        <translation>t₀ = %1</translation>
    </message>
    <message>
        <source>No hammer force: the rod arrives with a uniform velocity</source>
        <translation>Keine Hammerkraft: die Stange kommt mit gleichförmiger Geschwindigkeit an</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Force of the hammer on the rod over time: %1</source>
        <translation>Kraft des Hammers auf die Stange über der Zeit: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::PulseSection</name>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Hammer blow: shape</source>
        <translation>Hammerschlag: Form</translation>
    </message>
    <message>
        <source>Shape of the force of the hammer on the rod over time</source>
        <translation>Form der Kraft des Hammers auf die Stange über der Zeit</translation>
    </message>
    <message>
        <source>Measured…</source>
        <translation>Gemessen …</translation>
    </message>
    <message>
        <source>Import a measured hammer blow: any table of samples, as a force, a strain or the output of a bridge</source>
        <translation>Einen gemessenen Hammerschlag importieren: jede Tabelle von Abtastwerten, als Kraft, Dehnung oder Ausgang einer Brücke</translation>
    </message>
    <message>
        <source>Table of the hammer blow</source>
        <translation>Tabelle des Hammerschlags</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Read the CSV file of the hammer blow again</source>
        <translation>Die CSV-Datei des Hammerschlags neu lesen</translation>
    </message>
    <message>
        <source>Choose CSV…</source>
        <translation>CSV wählen …</translation>
    </message>
    <message>
        <source>Reads the hammer blow from a CSV file that begins with `time [us],force [kN]`</source>
        <translation>Den Hammerschlag aus einer CSV-Datei übernehmen, die mit `time [us],force [kN]` beginnt</translation>
    </message>
    <message>
        <source>Hammer blow: impulse of the table</source>
        <translation>Hammerschlag: Kraftstoß der Tabelle</translation>
    </message>
    <message>
        <source>Impulse of the table. Another value scales all its forces, and the scenario then contains the points.</source>
        <translation>Kraftstoß der Tabelle; ein anderer skaliert alle ihre Kräfte, die das Szenario dann selbst enthält</translation>
    </message>
    <message>
        <source>impulse I₀</source>
        <translation>Kraftstoß I₀</translation>
    </message>
    <message>
        <source>Hammer blow: impulse of the table, unit</source>
        <translation>Hammerschlag: Kraftstoß der Tabelle, Einheit</translation>
    </message>
    <message>
        <source>a table of more than %1 points stays in its file: scale its forces there</source>
        <translation>eine Tabelle von mehr als %1 Punkten bleibt in ihrer Datei: die Kräfte dort skalieren</translation>
    </message>
    <message>
        <source>scale the hammer blow to %1</source>
        <translation>den Hammerschlag auf %1 skalieren</translation>
    </message>
    <message>
        <source>%1 from a file…</source>
        <translation>%1 aus einer Datei …</translation>
    </message>
    <message>
        <source>Take the hammer blow from a CSV file</source>
        <translation>Den Hammerschlag aus einer CSV-Datei übernehmen</translation>
    </message>
    <message>
        <source>Tables of time and force (*.csv);;All files (*)</source>
        <translation>Tabellen von Zeit und Kraft (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The hammer blow cannot be taken from this file.</source>
        <translation>Der Hammerschlag kann nicht aus dieser Datei übernommen werden.</translation>
    </message>
    <message>
        <source>“Measured…” imports tables of any other form.</source>
        <translation>„Gemessen …“ importiert Tabellen jeder anderen Form.</translation>
    </message>
</context>
<context>
    <name>drillwave::RangeRow</name>
    <message>
        <source>Uncertain parameter</source>
        <translation>Unsicherer Parameter</translation>
    </message>
    <message>
        <source>Design variable</source>
        <translation>Gewählter Parameter</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Wie er streut</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>even in log</source>
        <translation>gleich in log</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>normal in log</source>
        <translation>normal im Logarithmus</translation>
    </message>
    <message>
        <source>Equally likely between the limits, or a normal distribution with 95 % between them; in the value or in its logarithm</source>
        <translation>Jeder Wert zwischen den Enden so oft wie ein anderer, oder eine Glockenkurve, von der 95 % dazwischen liegen; im Wert oder in seinem Logarithmus</translation>
    </message>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>Even ratios instead of even steps</source>
        <translation>Gleiche Verhältnisse statt gleicher Schritte</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Anzahl der Werte</translation>
    </message>
    <message>
        <source> values</source>
        <translation> Werte</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, Einheit</translation>
    </message>
    <message>
        <source>must differ from the other end</source>
        <translation>muss sich vom anderen Ende unterscheiden</translation>
    </message>
    <message>
        <source>the range is reversed: give the lower end first</source>
        <translation>der Bereich steht kopf: das erste Ende ist das untere</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Removes this row: the parameter is known</source>
        <translation>Dieser ist bekannt</translation>
    </message>
    <message>
        <source>Removes this row: the parameter is not varied</source>
        <translation>Dieser bleibt, wie er ist</translation>
    </message>
</context>
<context>
    <name>drillwave::RangeRows</name>
    <message>
        <source>Add an uncertain parameter</source>
        <translation>Unsicheren Parameter hinzufügen</translation>
    </message>
    <message>
        <source>Add a design variable</source>
        <translation>Gewählten Parameter hinzufügen</translation>
    </message>
    <message>
        <source>Adds an uncertain parameter</source>
        <translation>Eine weitere Zahl, die nicht bekannt ist</translation>
    </message>
    <message>
        <source>Adds a design variable</source>
        <translation>Eine weitere Zahl, die gewählt werden kann</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
</context>
<context>
    <name>drillwave::RecordList</name>
    <message>
        <source>Records</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>record</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>misfit</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>A click shows a record; Delete removes it from the list</source>
        <translation>Ein Klick zeigt eine Aufzeichnung; Entf entfernt sie aus der Liste</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Removes this record from the list; the file stays</source>
        <translation>Entfernt diese Aufzeichnung aus der Liste; die Datei bleibt</translation>
    </message>
</context>
<context>
    <name>drillwave::ReportPreview</name>
    <message>
        <source>date of the day</source>
        <translation>Datum des Tages</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Aktualisieren</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Vorschau des Berichts</translation>
    </message>
    <message>
        <source>project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>Auftraggeber</translation>
    </message>
    <message>
        <source>The scenario has changed: shows the pages again for the present one</source>
        <translation>Das Szenario hat sich seitdem geändert: die Seiten des jetzigen zeigen</translation>
    </message>
    <message>
        <source>&amp;Write as HTML or PDF…</source>
        <translation>Als HTML oder PDF &amp;schreiben …</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
</context>
<context>
    <name>drillwave::ReportWriter</name>
    <message>
        <source>&amp;Report…</source>
        <translation>Beri&amp;cht …</translation>
    </message>
    <message>
        <source>A report as HTML or PDF: inputs with their sources, results, verdict, plots and the scenario</source>
        <translation>Eine Seite zum Weitergeben, als HTML oder PDF: Eingaben mit ihren Quellen, Ergebnisse, Urteil, Diagramme und das Szenario</translation>
    </message>
    <message>
        <source>&amp;Print the report…</source>
        <translation>Bericht &amp;drucken …</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf)</source>
        <translation>Webseite (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report has not been written.</source>
        <translation>Der Bericht wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>%1: a report is a file that ends in .html or .pdf; choose such a name</source>
        <translation>%1: ein Bericht ist eine Datei, die auf .html oder .pdf endet; einen solchen Namen wählen</translation>
    </message>
    <message>
        <source>The report has not been printed.</source>
        <translation>Der Bericht wurde nicht gedruckt.</translation>
    </message>
    <message>
        <source>The blow could not be solved: %1</source>
        <translation>Der Schlag konnte nicht gelöst werden: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>%1 does not accept pages; check the printer, or write the report as PDF</source>
        <translation>%1 nimmt keine Seiten an; nach dem Drucker sehen, oder den Bericht als PDF schreiben</translation>
    </message>
    <message>
        <source>Printed: %1</source>
        <translation>Gedruckt: %1</translation>
    </message>
    <message>
        <source>Pre&amp;view of the report…</source>
        <translation>&amp;Vorschau des Berichts …</translation>
    </message>
    <message>
        <source>Shows the pages of the report, with project, author, customer and date in their heading</source>
        <translation>Die Seiten des Berichts in einem Fenster, mit Projekt, Verfasser, Auftraggeber und Datum für ihren Kopf</translation>
    </message>
    <message>
        <source>There is no preview of the report.</source>
        <translation>Es gibt keine Vorschau des Berichts.</translation>
    </message>
    <message>
        <source>The report on pages of A4</source>
        <translation>Der Bericht auf Seiten A4</translation>
    </message>
</context>
<context>
    <name>drillwave::ResultPanel</name>
    <message>
        <source>Penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>Rebound</source>
        <translation>Rückprall</translation>
    </message>
    <message>
        <source>Stress in the rod</source>
        <translation>Spannung in der Stange</translation>
    </message>
    <message>
        <source>Force and times</source>
        <translation>Kraft und Zeiten</translation>
    </message>
    <message>
        <source>&amp;Copy results</source>
        <translation>Ergebnisse &amp;kopieren</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Andruck</translation>
    </message>
    <message>
        <source>required feed</source>
        <translation>erforderlicher Andruck</translation>
    </message>
    <message>
        <source>sequence of blows</source>
        <translation>Schlagfolge</translation>
    </message>
    <message>
        <source>Set wave loss 10 %</source>
        <translation>Wellenverlust 10 % setzen</translation>
    </message>
    <message>
        <source>Estimate from single blows. Consecutive blows are being solved …</source>
        <translation>Schätzung aus einzelnen Schlägen. Aufeinanderfolgende Schläge werden berechnet …</translation>
    </message>
    <message>
        <source>Estimate from single blows.</source>
        <translation>Schätzung aus einzelnen Schlägen.</translation>
    </message>
    <message>
        <source>Solve consecutive blows (about %1 s)</source>
        <translation>Aufeinanderfolgende Schläge verfolgen (etwa %1 s)</translation>
    </message>
    <message>
        <source>The required feed force is estimated from single blows; %1 solves consecutive blows.</source>
        <translation>Der erforderliche Andruck ist aus einzelnen Schlägen geschätzt; %1 simuliert aufeinanderfolgende Schläge.</translation>
    </message>
    <message>
        <source>penetration, energy, power and restitution</source>
        <translation>Eindringung, Energie, Leistung und Stoßzahl</translation>
    </message>
    <message>
        <source>e = %1</source>
        <translation>e = %1</translation>
    </message>
    <message>
        <source>this blow: penetration %1</source>
        <translation>dieser Schlag: Eindringung %1</translation>
    </message>
    <message>
        <source>hammer work %1</source>
        <translation>Arbeit des Hammers %1</translation>
    </message>
    <message>
        <source>power %1</source>
        <translation>Leistung %1</translation>
    </message>
</context>
<context>
    <name>drillwave::RigDialog</name>
    <message>
        <source>Rig of these groups</source>
        <translation>Anlage dieser Kennzahlen</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>&amp;Rod</source>
        <translation>&amp;Stange</translation>
    </message>
    <message>
        <source>Make the rig</source>
        <translation>Anlage erstellen</translation>
    </message>
    <message>
        <source>The groups give a rod of %1, an impulse of %2, a stiffness of %3 and a gap of %4.</source>
        <translation>Aus den Kennzahlen folgen eine Stange von %1, ein Impuls von %2, eine Steifigkeit von %3 und ein Spalt von %4.</translation>
    </message>
    <message>
        <source>make a rig of the groups</source>
        <translation>eine Anlage aus den Kennzahlen machen</translation>
    </message>
    <message>
        <source>Edit ▸ Make a rig of these groups gives it physical units; File ▸ New begins another one.</source>
        <translation>Bearbeiten ▸ Eine Anlage aus diesen Kennzahlen machen gibt ihm physikalische Einheiten; Datei ▸ Neu beginnt ein anderes.</translation>
    </message>
</context>
<context>
    <name>drillwave::RockPage</name>
    <message>
        <source>State of the rock at the time cursor, shown by the larger point</source>
        <translation>Zustand des Gesteins am Zeitcursor, dem größeren Punkt auf dem Weg</translation>
    </message>
    <message>
        <source>Shows the whole path (double-click in the plot)</source>
        <translation>Den ganzen Weg ins Bild bringen (Doppelklick im Diagramm)</translation>
    </message>
    <message>
        <source>Impact force against penetration</source>
        <translation>Kraft auf das Gestein über der Eindringung</translation>
    </message>
    <message>
        <source>Nothing to show: this blow has too many waves to keep.</source>
        <translation>Nichts zu zeigen: dieser Schlag hat mehr Wellen, als behalten werden können.</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Nichts zu zeigen: %1</translation>
    </message>
    <message>
        <source>To mark a time, click an event in Result or place the time cursor on the page Blow.</source>
        <translation>Zeit markieren: Klick auf ein Ereignis im Ergebnis, oder die Zeitmarke auf der Seite Schlag.</translation>
    </message>
    <message>
        <source>t = %1 · U = %2 · F = %3</source>
        <translation>t = %1 · U = %2 · F = %3</translation>
    </message>
    <message>
        <source>Rock</source>
        <translation>Gestein</translation>
    </message>
    <message>
        <source>The bit penetrates %1 into the rock, and %2 remain after the rebound. %3 % of the blow energy stays in the rock.</source>
        <translation>Die Bohrkrone dringt %1 ins Gestein ein, davon bleiben nach dem Rückprall %2. %3 % der Schlagenergie bleiben im Gestein.</translation>
    </message>
</context>
<context>
    <name>drillwave::RockPlot</name>
    <message>
        <source>no energy left in the rock</source>
        <translation>keine Energie bleibt im Gestein</translation>
    </message>
    <message>
        <source>impact force F</source>
        <translation>Kraft auf das Gestein F</translation>
    </message>
    <message>
        <source>penetration U</source>
        <translation>Eindringung U</translation>
    </message>
    <message>
        <source>enclosed area: %1</source>
        <translation>eingeschlossene Fläche: %1</translation>
    </message>
    <message>
        <source>Fₘ = %1</source>
        <translation>Fₘ = %1</translation>
    </message>
    <message>
        <source>Uₘ = %1</source>
        <translation>Uₘ = %1</translation>
    </message>
    <message>
        <source>Uᵣ = %1</source>
        <translation>Uᵣ = %1</translation>
    </message>
    <message>
        <source>k = %1</source>
        <translation>k = %1</translation>
    </message>
    <message>
        <source>k/γ = %1</source>
        <translation>k/γ = %1</translation>
    </message>
    <message>
        <source>Impact force against penetration. Loading along the slope k = %1 up to the peak, Fₘ = %2 at the penetration Uₘ = %3; unloading along k/γ = %4; the penetration Uᵣ = %5 stays. The enclosed area: %6.</source>
        <translation>Kraft auf das Gestein über der Eindringung. Belastung entlang der Steigung k = %1 bis zur Spitze, Fₘ = %2 bei der Eindringung Uₘ = %3; Entlastung entlang k/γ = %4; die Eindringung Uᵣ = %5 bleibt. Die eingeschlossene Fläche: %6.</translation>
    </message>
    <message>
        <source> Above its corners it loads along %1.</source>
        <translation> Hinter ihren Ecken belastet es entlang %1.</translation>
    </message>
    <message>
        <source>energy left in the rock: %1 (%2 of the blow)</source>
        <translation>Energie im Gestein: %1 (%2 des Schlags)</translation>
    </message>
</context>
<context>
    <name>drillwave::RodPage</name>
    <message>
        <source>Section shown by the dotted line: 0 is the struck end, 1 the bit.
A click in the plot moves it, and moves the time cursor to the largest stress there.</source>
        <translation>Die gepunktete Linie: wohin in der Stange man schaut, 0 ist das hammerseitige Ende, 1 die Bohrkrone.
Ein Klick ins Diagramm verschiebt sie, und den Zeitcursor dorthin, wo die Spannung dort am größten ist.</translation>
    </message>
    <message>
        <source>Section x/L</source>
        <translation>Stelle x/L</translation>
    </message>
    <message>
        <source>The largest stresses at the section, and when they occur</source>
        <translation>Die größten Spannungen an der Stelle, und wann sie auftreten</translation>
    </message>
    <message>
        <source>Bring the whole rod into view (double-click in the plot)</source>
        <translation>Die ganze Stange ins Bild bringen (Doppelklick im Diagramm)</translation>
    </message>
    <message>
        <source>Largest stresses along the rod</source>
        <translation>Größte Spannungen entlang der Stange</translation>
    </message>
    <message>
        <source>Nothing to show: there are too many waves to keep.</source>
        <translation>Nichts zu zeigen: so viele Wellen, dass sie nicht behalten werden.</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Nichts zu zeigen: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>At %1, during the blow: %2 and %3
afterwards, in the residual waves: %4 and %5</source>
        <translation>Bei %1, während des Schlags: %2 und %3
danach, in den Restwellen: %4 und %5</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stange</translation>
    </message>
    <message>
        <source>At %1, during the blow: %2 and %3
in %4</source>
        <translation>Bei %1, während des Schlags: %2 und %3
in %4</translation>
    </message>
    <message>
        <source>; the largest stress of this section uses %1 % of its strength</source>
        <translation>; die größte Spannung dieses Abschnitts nutzt %1 % der Festigkeit</translation>
    </message>
</context>
<context>
    <name>drillwave::RodPlot</name>
    <message>
        <source>largest compression in the blow</source>
        <translation>größter Druck im Schlag</translation>
    </message>
    <message>
        <source>largest tension in the blow</source>
        <translation>größter Zug im Schlag</translation>
    </message>
    <message>
        <source>compression of residual waves</source>
        <translation>Druck der Restwellen</translation>
    </message>
    <message>
        <source>tension of residual waves</source>
        <translation>Zug der Restwellen</translation>
    </message>
    <message>
        <source>position x from the struck end, hammer at x &lt; 0</source>
        <translation>Stelle x vom hammerseitigen Ende, Hammer bei x &lt; 0</translation>
    </message>
    <message>
        <source>position x from the struck end</source>
        <translation>Stelle x vom hammerseitigen Ende</translation>
    </message>
    <message>
        <source>stress (tension positive)</source>
        <translation>Spannung (Zug positiv)</translation>
    </message>
    <message>
        <source>stress, as force in the rod (tension positive)</source>
        <translation>Spannung, als Kraft in der Stange (Zug positiv)</translation>
    </message>
    <message>
        <source>force N (tension positive)</source>
        <translation>Kraft N (Zug positiv)</translation>
    </message>
    <message>
        <source>many waves: between peaks the curve may be too low by %1</source>
        <translation>so viele Wellen, dass eine Kurve zwischen den Spitzen um %1 zu niedrig sein kann</translation>
    </message>
    <message>
        <source>%1 up to %2 at %3, %4</source>
        <translation>%1 bis %2 bei %3, %4</translation>
    </message>
    <message>
        <source>Largest stresses along the rod, tension positive: %1.</source>
        <translation>Größte Spannungen entlang der Stange, Zug positiv: %1.</translation>
    </message>
    <message>
        <source>without local stresses at threads and changes of diameter</source>
        <translation>ohne örtliche Spannungen an Gewinden und Absätzen</translation>
    </message>
    <message>
        <source>without local stresses at threads; residual waves undamped</source>
        <translation>ohne örtliche Spannungen an Gewinden; Restwellen ungedämpft</translation>
    </message>
</context>
<context>
    <name>drillwave::RodProfile</name>
    <message>
        <source>Force along the rod at the time cursor, of this blow and of pinned runs</source>
        <translation>Kraft entlang der Stange am Zeitcursor, dieses Schlags und der angehefteten Läufe</translation>
    </message>
    <message>
        <source>Velocity along the rod at the time cursor, of this blow and of pinned runs</source>
        <translation>Geschwindigkeit entlang der Stange am Zeitcursor, dieses Schlags und der angehefteten Läufe</translation>
    </message>
    <message>
        <source>this blow</source>
        <translation>dieser Schlag</translation>
    </message>
    <message>
        <source>x = %1 · t = %2</source>
        <translation>x = %1 · t = %2</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>drillwave::RodStrip</name>
    <message>
        <source>The rod at the time cursor, coloured by its stress</source>
        <translation>Die Stange am Zeitcursor, nach ihrer Spannung gefärbt</translation>
    </message>
    <message>
        <source>The rod at the time cursor, coloured by its velocity</source>
        <translation>Die Stange am Zeitcursor, nach ihrer Geschwindigkeit gefärbt</translation>
    </message>
    <message>
        <source>The rod at the time cursor: hammer, rod, bit and rock. Blue is compressed, orange is in tension.</source>
        <translation>Die Stange am Zeitcursor: Hammer, Stange, Bohrkrone und Gestein. Blau ist gedrückt, Orange gezogen.</translation>
    </message>
    <message>
        <source>The rod at the time cursor: hammer, rod, bit and rock. Orange moves towards the rock, blue away from it; as on the colour bar above.</source>
        <translation>Die Stange am Zeitcursor: Hammer, Stange, Bohrkrone und Gestein. Orange bewegt sich zum Gestein, Blau davon weg; wie auf dem Farbbalken darüber.</translation>
    </message>
    <message>
        <source>t = %1 · after the end of the computed time, %2</source>
        <translation>t = %1 · später, als der Schlag verfolgt wurde, das ist bis %2</translation>
    </message>
    <message>
        <source>contact, penetration %1, impact force %2</source>
        <translation>Kontakt, Eindringung %1, Kraft auf das Gestein %2</translation>
    </message>
    <message>
        <source>apart, gap %1</source>
        <translation>getrennt, Spalt %1</translation>
    </message>
    <message>
        <source>bit at the rock, no force</source>
        <translation>Bohrkrone am Gestein, keine Kraft</translation>
    </message>
    <message>
        <source> · hammer pushes</source>
        <translation> · Hammer drückt</translation>
    </message>
    <message>
        <source> · hammer not in contact</source>
        <translation> · Hammer ohne Kontakt</translation>
    </message>
    <message>
        <source>t = %1 · %2 · stress %3 … %4</source>
        <translation>t = %1 · %2 · Spannung %3 … %4</translation>
    </message>
    <message>
        <source>t = %1 · %2 · velocity %3 … %4</source>
        <translation>t = %1 · %2 · Geschwindigkeit %3 … %4</translation>
    </message>
</context>
<context>
    <name>drillwave::RunKeeper</name>
    <message>
        <source>A run has changed.</source>
        <translation>Ein Lauf ist nicht mehr, was er war.</translation>
    </message>
    <message>
        <source>%1: too many runs are shown already; remove some and open the file again</source>
        <translation>%1: unter den gezeigten Läufen ist kein Platz dafür; einige entfernen und die Datei neu öffnen</translation>
    </message>
    <message>
        <source>%1: its file would replace another one in %2; remove the run and open the file again</source>
        <translation>%1: seine Datei würde eine andere in %2 ersetzen; den Lauf entfernen und die Datei neu öffnen</translation>
    </message>
    <message>
        <source>Not all runs that are kept with this file can be shown.</source>
        <translation>Nicht alle Läufe, die bei dieser Datei aufbewahrt sind, können gezeigt werden.</translation>
    </message>
    <message>
        <source>The runs are not kept beside the new file.</source>
        <translation>Neben der neuen Datei werden die Läufe nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>The scenario has no file yet: save it first, the runs are kept beside it.</source>
        <translation>Das Szenario hat noch keine Datei: erst speichern, die Läufe werden daneben aufbewahrt.</translation>
    </message>
    <message>
        <source>The runs are not kept.</source>
        <translation>Die Läufe sind nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>The runs are no longer kept.</source>
        <translation>Die Läufe werden nicht mehr aufbewahrt.</translation>
    </message>
</context>
<context>
    <name>drillwave::RunPanel</name>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>F7 pins this result for comparison.</source>
        <translation>F7 heftet dieses Ergebnis zum Vergleich an.</translation>
    </message>
    <message>
        <source>Ticked runs are shown in the plots. F2 renames, Del removes; right-click for more</source>
        <translation>Angehakte Läufe werden über die Diagramme gezeichnet. F2 benennt um, Entf entfernt, die Menütaste oder ein Rechtsklick hat das Übrige</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Δ</source>
        <translation>Δ</translation>
    </message>
    <message>
        <source>Re&amp;vert to this run</source>
        <translation>&amp;Zurück zu diesem Lauf</translation>
    </message>
    <message>
        <source>&amp;Compare with this run</source>
        <translation>&amp;Vergleichen mit diesem Lauf</translation>
    </message>
    <message>
        <source>Compare with the &amp;present result</source>
        <translation>Vergleichen mit dem &amp;gegenwärtigen Ergebnis</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>● now</source>
        <translation>● jetzt</translation>
    </message>
    <message>
        <source>The present result</source>
        <translation>Das gegenwärtige Ergebnis</translation>
    </message>
    <message>
        <source>ref.</source>
        <translation>Bez.</translation>
    </message>
    <message>
        <source>Being solved</source>
        <translation>Wird gelöst</translation>
    </message>
    <message>
        <source>Difference from the reference</source>
        <translation>Abweichung vom Bezug</translation>
    </message>
    <message>
        <source>Result shown of each run</source>
        <translation>Ergebnis, das von jedem Lauf gezeigt wird</translation>
    </message>
    <message>
        <source>COR e</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>Not kept when the window closes</source>
        <translation>Mit dem Fenster weg</translation>
    </message>
    <message>
        <source>File ▸ Keep runs beside the file keeps them</source>
        <translation>Datei ▸ Läufe neben der Datei aufbewahren behält sie</translation>
    </message>
</context>
<context>
    <name>drillwave::Runs</name>
    <message>
        <source>This is the run %1 already.</source>
        <translation>Das ist schon der Lauf %1.</translation>
    </message>
    <message>
        <source>There are %1 runs already, the most that can be distinguished: remove one first.</source>
        <translation>Es gibt %1 Läufe, so viele, wie sich unterscheiden lassen: erst einen entfernen.</translation>
    </message>
    <message>
        <source>%1 had e = %2 and has %3 now: the table of its hammer blow has been changed, or another version has solved it.</source>
        <translation>%1 hatte e = %2 und hat jetzt %3: die Tabelle seines Hammerschlags ist geändert, oder eine andere Version hat ihn gelöst.</translation>
    </message>
</context>
<context>
    <name>drillwave::ScenarioPanel</name>
    <message>
        <source>String</source>
        <translation>Strang</translation>
    </message>
    <message>
        <source>Hammer</source>
        <translation>Hammer</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stange</translation>
    </message>
    <message>
        <source>Hammer blow</source>
        <translation>Hammerschlag</translation>
    </message>
    <message>
        <source>Bit and rock</source>
        <translation>Bohrkrone und Gestein</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Title of the scenario</source>
        <translation>Titel des Szenarios</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>ohne</translation>
    </message>
</context>
<context>
    <name>drillwave::SectionBox</name>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>zugeklappt</translation>
    </message>
</context>
<context>
    <name>drillwave::SignalFields</name>
    <message>
        <source>place x</source>
        <translation>Stelle x</translation>
    </message>
    <message>
        <source>Distance of the gauge from the struck end; negative in the hammer</source>
        <translation>Der Messstelle, vom hammerseitigen Ende; unter 0 im Hammer</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>signal is</source>
        <translation>Signal ist</translation>
    </message>
    <message>
        <source>Quantity that was recorded</source>
        <translation>Aufgezeichnete Größe</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>output of a bridge</source>
        <translation>Ausgang einer Brücke</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of the numbers</source>
        <translation>Einheit der Zahlen</translation>
    </message>
    <message>
        <source>positive is</source>
        <translation>positiv ist</translation>
    </message>
    <message>
        <source>Meaning of positive numbers. In this program tension is positive in rods; on the rock and in a blow, compression is.</source>
        <translation>Was eine Zahl größer als 0 bedeutet. Hier ist Zug in einer Stange positiv, und Drücken in einem Schlag und auf das Gestein.</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>compression</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>zero line</source>
        <translation>Nulllinie</translation>
    </message>
    <message>
        <source>Zero level, subtracted from all samples</source>
        <translation>Was von allen Abtastwerten abgezogen wird</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgezeichnet</translation>
    </message>
    <message>
        <source>mean of the first</source>
        <translation>Mittel der ersten</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erste</translation>
    </message>
    <message>
        <source>Time at the start of the record without a signal</source>
        <translation>Wie lange in der Aufzeichnung nichts geschieht</translation>
    </message>
    <message>
        <source>zero is at</source>
        <translation>null liegt bei</translation>
    </message>
    <message>
        <source>In the unit of the column</source>
        <translation>In der Einheit der Spalte</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Samples before this time of the file are left out</source>
        <translation>Abtastwerte vor dieser Zeit der Datei werden weggelassen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Samples after this time of the file are left out</source>
        <translation>Abtastwerte nach dieser Zeit der Datei werden weggelassen</translation>
    </message>
    <message>
        <source>beginning</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>The range around the peak in which the signal exceeds 2 % of it</source>
        <translation>Von und bis dorthin, wo das Signal 2 % seiner Spitze ist, um sie herum</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>The range shown by the plot: zoom there first</source>
        <translation>Von und bis zu den Enden dessen, was das Diagramm zeigt: dort zuerst zoomen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>All of the record</source>
        <translation>Die ganze Aufzeichnung</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>clip what is negative</source>
        <translation>Negatives abschneiden</translation>
    </message>
    <message>
        <source>Forces below zero become zero: a hammer only pushes, and noise does not</source>
        <translation>Kräfte unter null werden null: ein Hammer drückt nur, Rauschen nicht</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Scaling of all forces</source>
        <translation>Womit alle Kräfte multipliziert werden</translation>
    </message>
    <message>
        <source>by a factor</source>
        <translation>mit einem Faktor</translation>
    </message>
    <message>
        <source>to an impulse</source>
        <translation>auf einen Kraftstoß</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>All forces are multiplied by it</source>
        <translation>Alle Kräfte werden damit multipliziert</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>Wanted impulse of the signal</source>
        <translation>Den das Signal haben soll</translation>
    </message>
    <message>
        <source>points at most</source>
        <translation>Punkte höchstens</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>wählen</translation>
    </message>
    <message>
        <source>The header has no known unit: choose the kind of signal and its unit.</source>
        <translation>Die Einheit im Kopf ist nicht bekannt, oder es gibt keine: wählen, was das Signal ist, und seine Einheit.</translation>
    </message>
    <message>
        <source>place x: not given: type the distance of the gauge from the struck end, because the time of a wave depends on it</source>
        <translation>Stelle x: nicht gegeben: eine Welle kommt durch jeden Querschnitt zu anderer Zeit; eingeben, wie weit die Messstelle vom hammerseitigen Ende ist</translation>
    </message>
    <message>
        <source>place x: must not be less than 0, the struck end</source>
        <translation>Stelle x: darf nicht kleiner als 0 sein, das hammerseitige Ende</translation>
    </message>
    <message>
        <source>place x: must be at least %1, the rear of the hammer</source>
        <translation>Stelle x: muss mindestens %1 sein, das hintere Ende des Hammers</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>elektrische Spannung</translation>
    </message>
    <message>
        <source>stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>particle velocity</source>
        <translation>Teilchengeschwindigkeit</translation>
    </message>
    <message>
        <source>Largest number of points to keep. By default a blow keeps as many as needed for impulse and e to within 1e-4. The summary below gives the largest deviation.</source>
        <translation>Die von den Abtastwerten bleiben; ein Schlag behält so wenige, wie Kraftstoß und e auf 1e-4 gleich lassen, bis Sie eine Anzahl wählen. Wie weit die übrigen von den Geraden dazwischen entfernt sind, steht unten</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>wie er ist</translation>
    </message>
</context>
<context>
    <name>drillwave::SolveStatus</name>
    <message>
        <source>%1 was not written: %2</source>
        <translation>%1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>solving was cancelled.</source>
        <translation>das Lösen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>stopped · the result shown is not that of the present input</source>
        <translation>angehalten · was gezeigt ist, gehört nicht zur gegenwärtigen Eingabe</translation>
    </message>
    <message>
        <source>solving … %1 waits for the result</source>
        <translation>löst … %1 wartet auf das Ergebnis</translation>
    </message>
    <message>
        <source>solving …</source>
        <translation>löst …</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Solve the present input</source>
        <translation>Die gegenwärtige Eingabe lösen</translation>
    </message>
    <message>
        <source>Stops solving; the old result stays, marked as old</source>
        <translation>Das Lösen anhalten; das alte Ergebnis bleibt, als solches markiert</translation>
    </message>
</context>
<context>
    <name>drillwave::StaleVeil</name>
    <message>
        <source>result of an earlier input</source>
        <translation>nicht zur gegenwärtigen Eingabe</translation>
    </message>
</context>
<context>
    <name>drillwave::StringCellEditor</name>
    <message>
        <source>not given</source>
        <translation>ohne</translation>
    </message>
</context>
<context>
    <name>drillwave::StringDrawing</name>
    <message>
        <source>Drawing of hammer and string</source>
        <translation>Zeichnung von Hammer und Strang</translation>
    </message>
    <message>
        <source>impedance Z %1 kN s/m</source>
        <translation>Impedanz Z %1 kN s/m</translation>
    </message>
    <message>
        <source>largest tension %1</source>
        <translation>größter Zug %1</translation>
    </message>
    <message>
        <source>largest compression %1</source>
        <translation>größter Druck %1</translation>
    </message>
    <message>
        <source>after the blow, tension %1</source>
        <translation>nach dem Schlag, Zug %1</translation>
    </message>
    <message>
        <source>after the blow, compression %1</source>
        <translation>nach dem Schlag, Druck %1</translation>
    </message>
    <message>
        <source>hammer</source>
        <translation>Hammer</translation>
    </message>
    <message>
        <source>rock</source>
        <translation>Gestein</translation>
    </message>
    <message>
        <source>string</source>
        <translation>Strang</translation>
    </message>
    <message>
        <source>Lengths to scale, diameters × %1</source>
        <translation>Längen maßstäblich, Durchmesser × %1</translation>
    </message>
    <message>
        <source>; upper half tension, lower half compression</source>
        <translation>; obere Hälfte Zug, untere Hälfte Druck</translation>
    </message>
    <message>
        <source>compression %1</source>
        <translation>Druck %1</translation>
    </message>
    <message>
        <source>tension %1</source>
        <translation>Zug %1</translation>
    </message>
</context>
<context>
    <name>drillwave::StringEdits</name>
    <message>
        <source>section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicates the selected section, with its name</source>
        <translation>Den gewählten Abschnitt mit seinem Namen noch einmal dorthin setzen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected sections</source>
        <translation>Die gewählten Abschnitte wegnehmen</translation>
    </message>
    <message>
        <source>Towards the hammer</source>
        <translation>Zum Hammer hin</translation>
    </message>
    <message>
        <source>Move the selected section one step towards the rear, into or out of a repeat</source>
        <translation>Den gewählten Abschnitt einen Schritt nach hinten verschieben, in eine Wiederholung oder aus ihr heraus</translation>
    </message>
    <message>
        <source>Towards the bit</source>
        <translation>Zur Bohrkrone hin</translation>
    </message>
    <message>
        <source>Move the selected section one step towards the bit, into or out of a repeat</source>
        <translation>Den gewählten Abschnitt einen Schritt zur Bohrkrone verschieben, in eine Wiederholung oder aus ihr heraus</translation>
    </message>
    <message>
        <source>Repeat…</source>
        <translation>Wiederholen …</translation>
    </message>
    <message>
        <source>Repeats the selected sections; inside a repeat, type the number of times</source>
        <translation>Die gewählten Abschnitte mehrmals aufeinander folgen lassen; in einer Wiederholung eingeben, wie oft</translation>
    </message>
    <message>
        <source>Like the selected one</source>
        <translation>Wie der gewählte</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Rods</source>
        <translation>Stangen</translation>
    </message>
    <message>
        <source>Hammer, instead of this one</source>
        <translation>Hammer, anstelle des gegenwärtigen</translation>
    </message>
    <message>
        <source>Adapters</source>
        <translation>Einsteckenden</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Kupplungsmuffen</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bohrkronen</translation>
    </message>
    <message>
        <source>From the example strings</source>
        <translation>Aus den Beispielsträngen</translation>
    </message>
    <message>
        <source>%1 sections</source>
        <translation>%1 Abschnitte</translation>
    </message>
    <message>
        <source>a section</source>
        <translation>einen Abschnitt</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>take the hammer %1</source>
        <translation>den Hammer %1 übernehmen</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>A hammer has at least one section.</source>
        <translation>Ein Hammer hat mindestens einen Abschnitt.</translation>
    </message>
    <message>
        <source>A string has at least one section.</source>
        <translation>Ein Strang hat mindestens einen Abschnitt.</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>remove %1 sections</source>
        <translation>%1 Abschnitte entfernen</translation>
    </message>
    <message>
        <source>move %1 towards the hammer</source>
        <translation>%1 zum Hammer hin verschieben</translation>
    </message>
    <message>
        <source>move %1 towards the bit</source>
        <translation>%1 zur Bohrkrone hin verschieben</translation>
    </message>
    <message>
        <source>Sections of the hammer stay in the hammer, sections of the string in the string.</source>
        <translation>Abschnitte des Hammers bleiben im Hammer, die des Strangs dahinter.</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>repeat %1</source>
        <translation>%1 wiederholen</translation>
    </message>
    <message>
        <source>Adds a section after the selected one: a copy, a preset or a section of the example strings. Adapters go to the shank, bits to the rock.</source>
        <translation>Einen Abschnitt hinter den gewählten setzen: einen gleichen, eine Voreinstellung oder einen der Beispielstränge; hinter dem letzten einer Wiederholung kommt er nach der Wiederholung; Einsteckenden kommen an den Anfang, Bohrkronen ans Gestein</translation>
    </message>
    <message>
        <source>Replace by preset</source>
        <translation>Durch Voreinstellung ersetzen</translation>
    </message>
    <message>
        <source>Replace the selected sections by a preset</source>
        <translation>Eine Voreinstellung an die Stelle der gewählten Abschnitte setzen</translation>
    </message>
    <message>
        <source>replace %1 by %2</source>
        <translation>%1 durch %2 ersetzen</translation>
    </message>
</context>
<context>
    <name>drillwave::StringModel</name>
    <message>
        <source>mass at
end</source>
        <translation>Masse
dahinter</translation>
    </message>
    <message>
        <source>attenu-
ation</source>
        <translation>Dämp-
fung</translation>
    </message>
    <message>
        <source>%1 at %2 from its rear end, %3</source>
        <translation>%1, %2 vom hammerseitigen Ende, %3</translation>
    </message>
    <message>
        <source>These sections are repeated %1 times. Type another number; 1 removes the repeat.</source>
        <translation>Diese Abschnitte kommen %1-mal hintereinander. Eine andere Zahl eingeben; 1 nimmt die Wiederholung weg.</translation>
    </message>
    <message>
        <source>Name of the section, also used in keys of parameters</source>
        <translation>Name des Abschnitts; auch Parameter gehen danach</translation>
    </message>
    <message>
        <source>Share of the hammer energy reflected by the joint after %1</source>
        <translation>Anteil der Energie des Hammers, den die Verbindung hinter %1 von dem reflektiert, was vom Hammer kommt</translation>
    </message>
    <message>
        <source>
in the residual waves: %1</source>
        <translation>
der Wellen, die der Schlag hinterlässt: %1</translation>
    </message>
    <message>
        <source>The hammer has no internal losses</source>
        <translation>Der Hammer verliert innen nichts</translation>
    </message>
    <message>
        <source>The section has a cross-section instead of diameters</source>
        <translation>Der Abschnitt ist durch seinen Querschnitt gegeben, nicht durch Durchmesser</translation>
    </message>
    <message>
        <source>H%1</source>
        <translation>H%1</translation>
    </message>
    <message>
        <source>Largest compression of the section during the blow</source>
        <translation>Größter Druck im Abschnitt, solange der Schlag dauert</translation>
    </message>
    <message>
        <source>Largest tension of the section during the blow</source>
        <translation>Größter Zug im Abschnitt, solange der Schlag dauert</translation>
    </message>
    <message>
        <source>Share of the hammer energy reflected by the joint after the section; of a repeat, by the joint that reflects most</source>
        <translation>Anteil der Energie des Hammers, den die Verbindung hinter dem Abschnitt von dem reflektiert, was vom Hammer kommt; in einer Wiederholung der Verbindung, die am meisten reflektiert</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>compres-
sion</source>
        <translation>größter
Druck</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>joint
reflects</source>
        <translation>Re-
flexion</translation>
    </message>
    <message>
        <source>The name %1</source>
        <translation>Der Name %1</translation>
    </message>
    <message>
        <source>call %1 “%2”</source>
        <translation>%1 „%2“ nennen</translation>
    </message>
    <message>
        <source>A repeat is a whole number from 1 to %1</source>
        <translation>Eine Wiederholung ist eine ganze Zahl von 1 bis %1</translation>
    </message>
    <message>
        <source>remove the repeat of %1</source>
        <translation>die Wiederholung von %1 wegnehmen</translation>
    </message>
    <message>
        <source>repeat %1 %2 times</source>
        <translation>%1 %2-mal wiederholen</translation>
    </message>
    <message>
        <source>%1: %2, of the fatigue strength of %3</source>
        <translation>%1: %2, von der Dauerfestigkeit von %3</translation>
    </message>
    <message>
        <source>%1: %2, of the yield strength of %3</source>
        <translation>%1: %2, von der Streckgrenze von %3</translation>
    </message>
    <message>
        <source>Preset of the section; the name is removed when a number changes</source>
        <translation>Die Voreinstellung, aus der der Abschnitt ist; der Name geht, wenn eine Zahl geändert wird</translation>
    </message>
    <message>
        <source>No strength is given</source>
        <translation>Keine Festigkeit ist angegeben</translation>
    </message>
    <message>
        <source>Place in keys: %1</source>
        <translation>Platz in Schlüsseln: %1</translation>
    </message>
    <message>
        <source>Largest stress during the blow as a share of the strength: tension over fatigue strength, or any stress over yield strength, whichever is larger</source>
        <translation>Größte Spannung während des Schlags als Anteil der Festigkeit: Zug von der Dauerfestigkeit oder beides von der Streckgrenze, was mehr ist</translation>
    </message>
    <message>
        <source>Preset of the section</source>
        <translation>Die Voreinstellung, aus der der Abschnitt ist</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>strength
used</source>
        <translation>Aus-
lastung</translation>
    </message>
    <message>
        <source>joint
loss</source>
        <translation>Gewinde-
verlust</translation>
    </message>
    <message>
        <source>diam-
eter</source>
        <translation>Durch-
messer</translation>
    </message>
</context>
<context>
    <name>drillwave::StringPage</name>
    <message>
        <source>Stresses of uniform sections: threads and shoulders raise them locally</source>
        <translation>Der gleichförmigen Abschnitte: Gewinde und Absätze erhöhen Spannungen örtlich</translation>
    </message>
    <message>
        <source>Sections of hammer and string</source>
        <translation>Abschnitte von Hammer und Strang</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>Alle Spalten</translation>
    </message>
    <message>
        <source>Not solved: %1</source>
        <translation>Nicht gelöst: %1</translation>
    </message>
    <message>
        <source>in %1, %2</source>
        <translation>in %1, %2</translation>
    </message>
    <message>
        <source>Largest tension %1; largest compression %2.</source>
        <translation>Größter Zug %1; größter Druck %2.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>&amp;Table of the sections…</source>
        <translation>&amp;Tabelle der Abschnitte …</translation>
    </message>
    <message>
        <source>Every section with its sizes and largest stresses, as CSV</source>
        <translation>Jeder Abschnitt mit seinen Maßen und größten Spannungen, als CSV</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Strang</translation>
    </message>
    <message>
        <source>Find the value that gives…</source>
        <translation>Wert suchen, der ergibt…</translation>
    </message>
    <message>
        <source>Also shows reflections of joints, presets, and the cross-section, Young&apos;s modulus, density, strengths, mass and attenuation of sections that have none of their own</source>
        <translation>Zeigt auch Reflexionen der Verbindungen, Voreinstellungen sowie Querschnitt, E-Modul, Dichte, Festigkeiten, Masse und Dämpfung von Abschnitten, die keine eigenen haben</translation>
    </message>
</context>
<context>
    <name>drillwave::StringSection</name>
    <message>
        <source>Closed forms and groups are for uniform rods only</source>
        <translation>Geschlossene Formen und Kennzahlen gibt es für gleichförmige Stangen, nicht hier</translation>
    </message>
    <message>
        <source>Sections…</source>
        <translation>Abschnitte …</translation>
    </message>
    <message>
        <source>The page String: a drawing, and all sections in a table to edit</source>
        <translation>Die Seite Strang: eine Zeichnung, und alle Abschnitte in einer Tabelle zum Bearbeiten</translation>
    </message>
    <message>
        <source>may strike again</source>
        <translation>darf wieder schlagen</translation>
    </message>
    <message>
        <source>Hammer: may strike again</source>
        <translation>Hammer: darf wieder schlagen</translation>
    </message>
    <message>
        <source>The hammer may be hit again by the string; otherwise it is withdrawn after the first separation</source>
        <translation>Der Hammer bleibt, wo der Strang ihn wieder treffen kann; sonst wird er zurückgezogen, sobald sie sich getrennt haben</translation>
    </message>
    <message>
        <source>let the hammer strike again</source>
        <translation>den Hammer wieder schlagen lassen</translation>
    </message>
    <message>
        <source>withdraw the hammer</source>
        <translation>den Hammer zurückziehen</translation>
    </message>
    <message>
        <source>; hammer %1, %2</source>
        <translation>; Hammer %1, %2</translation>
    </message>
</context>
<context>
    <name>drillwave::StringSketch</name>
    <message>
        <source>position x from the struck end, hammer at x &lt; 0</source>
        <translation>Stelle x vom hammerseitigen Ende, Hammer bei x &lt; 0</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>h%1</source>
        <translation>h%1</translation>
    </message>
</context>
<context>
    <name>drillwave::StudyMenu</name>
    <message>
        <source>&amp;Study</source>
        <translation>&amp;Studie</translation>
    </message>
    <message>
        <source>&amp;Copy as command line</source>
        <translation>Als Befehlszeile &amp;kopieren</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
</context>
<context>
    <name>drillwave::StudyPage</name>
    <message>
        <source>Copy as command line</source>
        <translation>Als Befehlszeile kopieren</translation>
    </message>
    <message>
        <source>Copies the command that writes the same numbers as CSV</source>
        <translation>Der Befehl, der dieselben Zahlen als CSV schreibt, für ein Terminal</translation>
    </message>
    <message>
        <source>&amp;Data of this study…</source>
        <translation>&amp;Daten dieser Studie …</translation>
    </message>
    <message>
        <source>The numbers of the study, as CSV</source>
        <translation>Die Zahlen der Studie, als CSV</translation>
    </message>
    <message>
        <source>The study was stopped before its end.</source>
        <translation>Die Studie wurde vor ihrem Ende angehalten.</translation>
    </message>
    <message>
        <source>The study is not finished yet.</source>
        <translation>Die Studie ist noch nicht fertig.</translation>
    </message>
    <message>
        <source>%1 set to %2</source>
        <translation>%1 auf %2 gesetzt</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
</context>
<context>
    <name>drillwave::StudyStatus</name>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Fortschritt der Studie</translation>
    </message>
    <message>
        <source>Stops the study; the points found so far stay</source>
        <translation>Die Studie anhalten; gefundene Punkte bleiben</translation>
    </message>
    <message>
        <source>%1 stopped</source>
        <translation>%1 angehalten</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Solve all</source>
        <translation>Ganz lösen</translation>
    </message>
    <message>
        <source>Solve all (%1)</source>
        <translation>Ganz lösen (%1)</translation>
    </message>
    <message>
        <source>Runs the study again to its end, whatever time it takes</source>
        <translation>Die Studie noch einmal bis zum Ende rechnen, wie lange es auch dauert</translation>
    </message>
    <message>
        <source>%1 stopped after %2 s</source>
        <translation>%1 nach %2 s angehalten</translation>
    </message>
    <message>
        <source>stopped after %1 s</source>
        <translation>nach %1 s angehalten</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
</context>
<context>
    <name>drillwave::TabStrip</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>drillwave::TableFields</name>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>separator</source>
        <translation>Trennzeichen</translation>
    </message>
    <message>
        <source>Character between the cells</source>
        <translation>Was zwischen den Zellen steht</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>semicolon ;</source>
        <translation>Semikolon ;</translation>
    </message>
    <message>
        <source>comma ,</source>
        <translation>Komma ,</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>Decimal sign of the numbers</source>
        <translation>Was vor den Dezimalen einer Zahl steht</translation>
    </message>
    <message>
        <source>point 1.5</source>
        <translation>Punkt 1.5</translation>
    </message>
    <message>
        <source>comma 1,5</source>
        <translation>Komma 1,5</translation>
    </message>
    <message>
        <source>samples from line</source>
        <translation>Werte ab Zeile</translation>
    </message>
    <message>
        <source>First line with a sample</source>
        <translation>Die erste Zeile der Datei, die ein Abtastwert ist</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>The column of times, or none</source>
        <translation>Die Spalte der Zeiten, oder keine</translation>
    </message>
    <message>
        <source>unit of time</source>
        <translation>Einheit der Zeit</translation>
    </message>
    <message>
        <source>Unit of the times</source>
        <translation>Worin die Zeiten angegeben sind</translation>
    </message>
    <message>
        <source>sampling rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Abtastwerte in einer Sekunde</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>The column of the signal</source>
        <translation>Die Spalte des Signals</translation>
    </message>
    <message>
        <source>mean with</source>
        <translation>Mittel mit</translation>
    </message>
    <message>
        <source>A second gauge on the other side of the bar: the mean is free of bending</source>
        <translation>Ein zweiter Messstreifen auf der anderen Seite des Stabs: das Mittel ist frei von Biegung</translation>
    </message>
    <message>
        <source>rows without number</source>
        <translation>Zeilen ohne Zahl</translation>
    </message>
    <message>
        <source>Empty cells, NaN and words: refuse the file, or skip and count the rows</source>
        <translation>Leere Zellen, NaN, Wörter: ob sie den Import anhalten oder weggelassen werden</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>ablehnen</translation>
    </message>
    <message>
        <source>skip and count</source>
        <translation>übergehen, zählen</translation>
    </message>
    <message>
        <source>no other gauge</source>
        <translation>kein weiterer</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>wählen</translation>
    </message>
    <message>
        <source>The file is empty, or no text.</source>
        <translation>Die Datei ist leer, oder kein Text.</translation>
    </message>
    <message>
        <source>No line of numbers is found in the first %1 lines with this separator and decimal sign: choose others, or the first line with a sample. Remove a longer header from the file.</source>
        <translation>In den ersten %1 Zeilen findet sich mit diesem Trennzeichen und Dezimalzeichen keine Zeile mit Zahlen: andere wählen, oder die Zeile, in der die Abtastwerte beginnen; ein längerer Kopf ist von der Datei abzuschneiden.</translation>
    </message>
    <message>
        <source>Time and signal are the same column: choose another one, or a sampling rate.</source>
        <translation>Zeit und Signal sind dieselbe Spalte: eine andere wählen, oder eine Abtastrate.</translation>
    </message>
    <message>
        <source>The second gauge is a column that is used already: choose another one.</source>
        <translation>Der zweite Messstreifen ist eine Spalte, die schon verwendet wird: eine andere wählen.</translation>
    </message>
    <message>
        <source>unit of time: not given in the table: choose one.</source>
        <translation>Einheit der Zeit: die Tabelle sagt sie nicht: eine wählen.</translation>
    </message>
    <message>
        <source>unit of time: %1 is not known: choose one.</source>
        <translation>Einheit der Zeit: %1 ist nicht bekannt: eine wählen.</translation>
    </message>
    <message>
        <source>sampling rate: %1</source>
        <translation>Abtastrate: %1</translation>
    </message>
    <message>
        <source>bar |</source>
        <translation>Strich |</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Each channel of this table is a row: turn rows into columns in a spreadsheet, or read it by drillwave signal -o.</source>
        <translation>Jeder Kanal dieser Tabelle ist eine Zeile: Machen Sie in einer Tabellenkalkulation Spalten daraus, oder lesen Sie sie mit drillwave signal -o.</translation>
    </message>
    <message>
        <source>decimal sign: 1,234 and 1.234 can be a decimal number or a thousand: choose the sign.</source>
        <translation>Dezimalzeichen: 1,234 und 1.234 können eine Zahl mit Dezimalen oder ein Tausender sein: Wählen Sie das Zeichen.</translation>
    </message>
    <message>
        <source>sampling rate: the table gives “%1” without a unit: type the rate.</source>
        <translation>Abtastrate: In der Tabelle steht „%1“ ohne Einheit: Geben Sie die Rate ein.</translation>
    </message>
    <message>
        <source>sampling rate: not given in the table: type it.</source>
        <translation>Abtastrate: Sie steht nicht in der Tabelle: Geben Sie sie ein.</translation>
    </message>
</context>
<context>
    <name>drillwave::TableNotice</name>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Neu laden</translation>
    </message>
    <message>
        <source>Read the hammer blow from the file again; Undo brings the present one back</source>
        <translation>Den Hammerschlag neu aus der Datei lesen; Rückgängig bringt den gegenwärtigen zurück</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Meines behalten</translation>
    </message>
    <message>
        <source>Continue with the points read before</source>
        <translation>Mit den Punkten weiterarbeiten, die zuvor gelesen wurden</translation>
    </message>
    <message>
        <source>%1, the hammer blow of this scenario, has been changed by another program.</source>
        <translation>%1, der Hammerschlag dieses Szenarios, wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>%1, the hammer blow of this scenario, has been deleted or moved. Its points are still here, but the scenario cannot be opened without the file.</source>
        <translation>%1, der Hammerschlag dieses Szenarios, wurde gelöscht oder verschoben. Seine Punkte sind noch da, aber ohne die Datei kann das Szenario nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The hammer blow cannot be read again.</source>
        <translation>Der Hammerschlag kann nicht neu gelesen werden.</translation>
    </message>
</context>
<context>
    <name>drillwave::TakenNotice</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo this change</source>
        <translation>Den Wert zurücknehmen</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
</context>
<context>
    <name>drillwave::UnitsChoice</name>
    <message>
        <source>dimensionless</source>
        <translation>dimensionslos</translation>
    </message>
    <message>
        <source>US</source>
        <translation>US</translation>
    </message>
    <message>
        <source>SI</source>
        <translation>SI</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Einheiten</translation>
    </message>
    <message>
        <source>&amp;SI</source>
        <translation>&amp;SI</translation>
    </message>
    <message>
        <source>&amp;US customary</source>
        <translation>&amp;US-Einheiten</translation>
    </message>
    <message>
        <source>&amp;Dimensionless</source>
        <translation>&amp;Dimensionslos</translation>
    </message>
    <message>
        <source>Units of fields, results and plots</source>
        <translation>Einheiten der Felder, Ergebnisse und Diagramme</translation>
    </message>
    <message>
        <source>as in the system selected</source>
        <translation>wie im gewählten System</translation>
    </message>
    <message>
        <source>This scenario is dimensionless: it has no physical values.</source>
        <translation>Dieses Szenario ist dimensionslos: es hat keine physikalischen Werte.</translation>
    </message>
    <message>
        <source>Units: %1</source>
        <translation>Einheiten: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit plots</source>
        <translation>Diagramme ein&amp;passen</translation>
    </message>
</context>
<context>
    <name>drillwave::WavePicturePage</name>
    <message>
        <source>Fronts</source>
        <translation>Fronten</translation>
    </message>
    <message>
        <source>Section shown by the dashed line, also used on the page Blow: 0 is the struck end, 1 the bit.</source>
        <translation>Die gestrichelte Linie: wo in der Stange die Wellen der Seite Schlag beobachtet werden; 0 ist das hammerseitige Ende, 1 die Bohrkrone.</translation>
    </message>
    <message>
        <source>Waves in the rod over position and time</source>
        <translation>Wellen in der Stange über Ort und Zeit</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>Kraft N</translation>
    </message>
    <message>
        <source>Particle velocity v</source>
        <translation>Teilchengeschwindigkeit v</translation>
    </message>
    <message>
        <source>Quantity shown by the colours</source>
        <translation>Was die Farben zeigen</translation>
    </message>
    <message>
        <source>Normal force (tension positive) or particle velocity (towards the rock positive)</source>
        <translation>Normalkraft (Zug positiv) oder Teilchengeschwindigkeit (zum Gestein positiv)</translation>
    </message>
    <message>
        <source>Lines that start where the hammer force begins (solid), jumps or ends (dashed), and move at the wave speed</source>
        <translation>Linien, auf denen die Hammerkraft beginnt (durchgezogen), springt oder endet (gestrichelt), mit der Wellengeschwindigkeit laufend</translation>
    </message>
    <message>
        <source>Section x/L</source>
        <translation>Stelle x/L</translation>
    </message>
    <message>
        <source>Value at the pointer</source>
        <translation>Wert am Zeiger</translation>
    </message>
    <message>
        <source>Bring the whole blow into view (double-click in the picture)</source>
        <translation>Den ganzen Schlag ins Bild bringen (Doppelklick ins Bild)</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Nichts zu zeigen: %1</translation>
    </message>
    <message>
        <source>Nothing to show: there are too many waves to keep.</source>
        <translation>Nichts zu zeigen: so viele Wellen, dass sie nicht behalten werden.</translation>
    </message>
    <message>
        <source>Wave picture</source>
        <translation>Wellenbild</translation>
    </message>
</context>
<context>
    <name>drillwave::WavePicturePlot</name>
    <message>
        <source>force N (tension positive)</source>
        <translation>Kraft N (Zug positiv)</translation>
    </message>
    <message>
        <source>particle velocity v (towards the rock positive)</source>
        <translation>Teilchengeschwindigkeit v (zum Gestein positiv)</translation>
    </message>
    <message>
        <source>position x from the struck end, hammer at x &lt; 0</source>
        <translation>Stelle x vom hammerseitigen Ende, Hammer bei x &lt; 0</translation>
    </message>
    <message>
        <source>position x from the struck end</source>
        <translation>Stelle x vom hammerseitigen Ende</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>Zeit t</translation>
    </message>
    <message>
        <source>x = %1 · t = %2 · %3 = %4</source>
        <translation>x = %1 · t = %2 · %3 = %4</translation>
    </message>
    <message>
        <source>%1 into %2 · t = %3</source>
        <translation>%1 in %2 · t = %3</translation>
    </message>
    <message>
        <source> · after the computed time</source>
        <translation> · später, als der Schlag verfolgt wurde</translation>
    </message>
    <message>
        <source> · N = %1 · σ = %2 · v = %3</source>
        <translation> · N = %1 · σ = %2 · v = %3</translation>
    </message>
    <message>
        <source>%1 in this view: from %2 to %3</source>
        <translation>%1 im Bild: von %2 bis %3</translation>
    </message>
    <message>
        <source> · colours end at ±%1</source>
        <translation> · Farben enden bei ±%1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>Picture of %1 over position and time from %2 to %3, up to %4. %5: %6%7.</source>
        <translation>Bild: %1 über Ort und Zeit von %2 bis %3, bis %4. %5: %6%7.</translation>
    </message>
    <message>
        <source>1 contact of bit and rock</source>
        <translation>1 Kontakt von Bohrkrone und Gestein</translation>
    </message>
    <message>
        <source>%1 contacts of bit and rock</source>
        <translation>%1 Kontakte von Bohrkrone und Gestein</translation>
    </message>
    <message>
        <source> and so on</source>
        <translation> und so weiter</translation>
    </message>
    <message>
        <source>fronts: — start, - - end of a wave</source>
        <translation>Fronten: — Beginn, - - Ende einer Welle</translation>
    </message>
    <message>
        <source>fronts: — start, - - end of a wave; p towards the bit, n back</source>
        <translation>Fronten: — Beginn, - - Ende einer Welle; p zur Krone, n zurück</translation>
    </message>
</context>
<context>
    <name>drillwave::WavesNotice</name>
    <message>
        <source>Round the lengths</source>
        <translation>Längen runden</translation>
    </message>
    <message>
        <source>Round the lengths of all sections to 10 mm</source>
        <translation>Die Längen aller Abschnitte auf 10 mm runden</translation>
    </message>
    <message>
        <source>round the lengths</source>
        <translation>die Längen runden</translation>
    </message>
    <message>
        <source>This blow has too many waves to keep, so this page shows those of a coarser string. Rounding lengths to 10 mm can show them in full: %1.</source>
        <translation>Dieser Schlag hat zu viele Wellen, um sie alle zu speichern: Diese Seite zeigt die eines gröber geteilten Strangs. Auf 10 mm gerundete Längen können sie alle zeigen: %1.</translation>
    </message>
</context>
<context>
    <name>drillwave::WindowLayout</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>Usage: drillwave [FILE]             open the window (scenario, result, example)
       drillwave COMMAND ARGUMENTS  work without a window

Commands:
</source>
        <translation>Aufruf: drillwave [FILE]             das Fenster öffnen (Szenario, Ergebnis, Beispiel)
        drillwave COMMAND ARGUMENTS  ohne Fenster arbeiten

Befehle:
</translation>
    </message>
    <message>
        <source>FILE is a scenario, a result file that contains its scenario (summary.json, histories.csv,
map.csv.yaml …), the name of a built-in example, or - for standard input.</source>
        <translation>FILE ist ein Szenario, eine Ergebnisdatei, die ihr Szenario enthält (summary.json, histories.csv,
map.csv.yaml …), der Name eines eingebauten Beispiels oder - für die Standardeingabe.</translation>
    </message>
    <message>
        <source>0 done, 1 internal error or out of memory, 2 wrong command line, 3 input cannot be read,
4 output cannot be written, 5 scenario invalid, 6 a case could not be solved, 130 interrupted</source>
        <translation>0 fertig, 1 interner Fehler oder Speicher erschöpft, 2 falscher Aufruf, 3 Eingabe nicht lesbar,
4 Ausgabe nicht schreibbar, 5 Szenario ungültig, 6 ein Fall ließ sich nicht lösen, 130 abgebrochen</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>Optionen:</translation>
    </message>
    <message>
        <source>print this help</source>
        <translation>diese Hilfe ausgeben</translation>
    </message>
    <message>
        <source>solve one blow; print a summary, write histories, events and plots</source>
        <translation>einen Schlag lösen: Zusammenfassung, auf Wunsch Verläufe, Ereignisse und Diagramme</translation>
    </message>
    <message>
        <source>change parameters of the scenario, such as rod.length=4.27m beta=0.8</source>
        <translation>Parameter des Szenarios ändern, zum Beispiel rod.length=4.27m beta=0.8</translation>
    </message>
    <message>
        <source>use the rod of this preset; `drillwave presets` lists rods, hammers and rocks</source>
        <translation>die Stange dieser Voreinstellung verwenden; `drillwave presets` zeigt Stangen, Hämmer und Gesteine</translation>
    </message>
    <message>
        <source>use the hammer of this preset</source>
        <translation>den Hammer dieser Voreinstellung verwenden</translation>
    </message>
    <message>
        <source>use the rock of this preset</source>
        <translation>das Gestein dieser Voreinstellung verwenden</translation>
    </message>
    <message>
        <source>with -o, also write plots in these formats</source>
        <translation>mit -o auch Diagramme in diesen Formaten schreiben</translation>
    </message>
    <message>
        <source>with -o, write CSV columns in SI (default for scenarios with units)</source>
        <translation>mit -o CSV-Spalten in SI-Einheiten schreiben (Vorgabe bei Szenarien mit Einheiten)</translation>
    </message>
    <message>
        <source>with -o, write CSV columns in dimensionless form</source>
        <translation>mit -o CSV-Spalten dimensionslos schreiben</translation>
    </message>
    <message>
        <source>overwrite existing files</source>
        <translation>vorhandene Dateien überschreiben</translation>
    </message>
    <message>
        <source>use German (de), Swedish (sv) or English (en)</source>
        <translation>Deutsch (de), Schwedisch (sv) oder Englisch (en) sprechen</translation>
    </message>
    <message>
        <source>solve one blow for every combination of parameter values, one CSV row each</source>
        <translation>einen Schlag für jede Kombination von Parameterwerten lösen, je eine CSV-Zeile</translation>
    </message>
    <message>
        <source>Solves one blow for every combination of the --vary values. Each combination is one row; the
parameter given last varies fastest. Values carry units where the parameter has one: --vary
rod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine
FILE.csv.yaml beside FILE.csv records version, command, varied parameters and scenario. --plots
can draw one or two varied parameters. The parameter with more values is the horizontal axis; each
value of the other parameter gives a curve.</source>
        <translation>Löst einen Schlag für jede Kombination der Werte von --vary. Jede Kombination ist eine Zeile; der
zuletzt genannte Parameter läuft am schnellsten. Werte haben Einheiten, wo der Parameter eine hat:
--vary rod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine
FILE.csv.yaml neben FILE.csv hält Version, Befehl, veränderte Parameter und Szenario fest. --plots
kann einen oder zwei veränderte Parameter zeichnen. Der Parameter mit mehr Werten ist die
waagerechte Achse; jeder Wert des anderen Parameters ergibt eine Kurve.</translation>
    </message>
    <message>
        <source>write outputs in SI, with units in the header</source>
        <translation>Ergebnisse in SI-Einheiten schreiben, mit Einheiten im Kopf</translation>
    </message>
    <message>
        <source>split the rows into N parts and solve only part I; `drillwave join` combines the parts; only part 1 has a header</source>
        <translation>die Zeilen in N Teile teilen und nur Teil I lösen; `drillwave join` fügt die Teile zusammen; nur Teil 1 hat einen Kopf</translation>
    </message>
    <message>
        <source>with -o, also write the plots that the window would show, as png, svg or pdf</source>
        <translation>mit -o auch die Diagramme schreiben, die das Fenster zeigen würde, als png, svg oder pdf</translation>
    </message>
    <message>
        <source>solve every row of a table of cases; write its columns and the outputs</source>
        <translation>jede Zeile einer Tabelle von Fällen lösen; ihre Spalten und Ergebnisse schreiben</translation>
    </message>
    <message>
        <source>CASES.csv is a table with one case in each row. Its header names parameters, with a unit in
brackets, as in rod.length [m], or with units in the cells. An empty cell keeps the value of FILE.
Columns that are not parameters are copied to the output. CASES can be - (standard input) or a
pipe. FILE.csv.yaml beside FILE.csv records version, command and scenario.</source>
        <translation>CASES.csv ist eine Tabelle mit einem Fall je Zeile. Ihr Kopf nennt Parameter, mit einer Einheit in
eckigen Klammern, wie rod.length [m], oder mit Einheiten in den Zellen. Eine leere Zelle lässt den
Wert von FILE gelten. Spalten, die keine Parameter sind, werden in die Ausgabe übernommen. CASES
kann - (Standardeingabe) oder eine Pipe sein. FILE.csv.yaml neben FILE.csv hält Version, Befehl
und Szenario fest.</translation>
    </message>
    <message>
        <source>vary one parameter: extremes, kinks and jumps of outputs, and where they reach a goal, with errors</source>
        <translation>einen Parameter ändern: Extrema, Knicke und Sprünge der Ausgaben und wo sie ein Ziel erreichen, mit Fehlern</translation>
    </message>
    <message>
        <source>parameter to follow continuously from START to STOP; with :log, its axis is logarithmic</source>
        <translation>Parameter, der stetig von START bis STOP verfolgt wird; mit :log ist seine Achse logarithmisch</translation>
    </message>
    <message>
        <source>vary this parameter, with one curve for each value; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C</source>
        <translation>diesen Parameter verändern, mit einer Kurve für jeden Wert; VALUES ist START:STOP:COUNT, START:STOP:COUNT:log (gleiche Verhältnisse) oder A,B,C</translation>
    </message>
    <message>
        <source>also print where an output crosses this value; give the value in the unit of the output&apos;s column</source>
        <translation>auch ausgeben, wo ein Ergebnis diesen Wert kreuzt; den Wert in der Einheit der Spalte des Ergebnisses angeben</translation>
    </message>
    <message>
        <source>print each parameter value at which the output is X. X is in the unit of the output&apos;s column. Exit code 6 if there is no such value</source>
        <translation>jeden Wert des Parameters ausgeben, bei dem das Ergebnis X ist. X hat die Einheit der Spalte des Ergebnisses. Exit-Code 6, wenn es keinen solchen Wert gibt</translation>
    </message>
    <message>
        <source>print and write outputs in SI</source>
        <translation>Ergebnisse in SI-Einheiten ausgeben und schreiben</translation>
    </message>
    <message>
        <source>also write the curve to FILE.csv, the settings to FILE.csv.yaml and the --goal values to FILE_goal.csv; -o - prints the points instead of the tables</source>
        <translation>auch die Kurve nach FILE.csv schreiben, die Einstellungen nach FILE.csv.yaml und die Werte von --goal nach FILE_goal.csv; -o - gibt die Punkte statt der Tabellen aus</translation>
    </message>
    <message>
        <source>map one output over two parameters, with contours</source>
        <translation>Karte eines Ergebnisses über zwei Parametern, mit Höhenlinien</translation>
    </message>
    <message>
        <source>Solves the output at every point of a grid of two parameters. FILE.csv has one row for each point,
with the same columns as from `drillwave sweep`; --y varies fastest. With --level X, also finds
the contour on which the output is X. Each point of a contour lies between two neighbouring grid
points and is solved for, not interpolated. FILE_contours.csv lists these points, how near to X
each one is, and where the output jumps over X.</source>
        <translation>Löst das Ergebnis an jedem Punkt eines Rasters zweier Parameter. FILE.csv hat eine Zeile je Punkt,
mit denselben Spalten wie von `drillwave sweep`; --y läuft am schnellsten. Mit --level X wird auch
die Höhenlinie bestimmt, auf der das Ergebnis X ist. Jeder Punkt einer Höhenlinie liegt zwischen
zwei benachbarten Rasterpunkten und wird durch Lösen bestimmt, nicht durch Interpolation.
FILE_contours.csv nennt diese Punkte, wie nahe an X jeder liegt, und wo das Ergebnis über X
springt.</translation>
    </message>
    <message>
        <source>vary this parameter on the horizontal axis; VALUES is START:STOP:COUNT or START:STOP:COUNT:log (equal ratios)</source>
        <translation>diesen Parameter auf der waagerechten Achse verändern; VALUES ist START:STOP:COUNT oder START:STOP:COUNT:log (gleiche Verhältnisse)</translation>
    </message>
    <message>
        <source>vary this parameter on the vertical axis; VALUES is START:STOP:COUNT or START:STOP:COUNT:log (equal ratios)</source>
        <translation>diesen Parameter auf der senkrechten Achse verändern; VALUES ist START:STOP:COUNT oder START:STOP:COUNT:log (gleiche Verhältnisse)</translation>
    </message>
    <message>
        <source>find the contour on which the output has this value; may be repeated</source>
        <translation>die Höhenlinie bestimmen, auf der das Ergebnis diesen Wert hat; mehrmals möglich</translation>
    </message>
    <message>
        <source>use SI units for the output and for the value of --level, which may then carry a unit</source>
        <translation>SI-Einheiten für das Ergebnis und für den Wert von --level verwenden, der dann eine Einheit haben darf</translation>
    </message>
    <message>
        <source>also write the map to FILE.csv, its settings to FILE.csv.yaml and its contours to FILE_contours.csv; -o - prints the points instead of the summary</source>
        <translation>auch die Karte nach FILE.csv schreiben, ihre Einstellungen nach FILE.csv.yaml und ihre Höhenlinien nach FILE_contours.csv; -o - gibt die Punkte statt der Zusammenfassung aus</translation>
    </message>
    <message>
        <source>combine the parts of a sweep, table or map that were solved with --shard</source>
        <translation>die Teile von sweep, table oder map zusammenfügen, in die --shard sie geteilt hat</translation>
    </message>
    <message>
        <source>write FILE and its description FILE.yaml; -o - prints the file instead</source>
        <translation>DATEI und ihre Beschreibung DATEI.yaml schreiben; -o - gibt die Datei stattdessen aus</translation>
    </message>
    <message>
        <source>restitution, forces and efficiency for all gaps between bit and rock</source>
        <translation>Stoßzahl, Kräfte und Wirkungsgrad für alle Spalte zwischen Bohrkrone und Gestein</translation>
    </message>
    <message>
        <source>Prints how the results depend on the gap between bit and rock at the start of the blow. Nobody
controls this gap at the rig. The results repeat each time the gap grows by d0 = 2 I0/Z (I0:
impulse of the blow, Z: impedance of the rod). All gaps within d0 therefore count as equally
likely. Prints minima and maxima with their gaps, mean, and 5, 50 and 95 % quantiles. Also prints
the share of gaps with a coefficient of restitution e above 1. --gap-deviation adds the same for a
normally distributed gap, cut off below zero.</source>
        <translation>Gibt aus, wie die Ergebnisse vom Spalt zwischen Bohrkrone und Gestein zu Beginn des Schlags abhängen.
Am Bohrgerät regelt diesen Spalt niemand. Die Ergebnisse wiederholen sich jedes Mal, wenn der Spalt
um d0 = 2 I0/Z wächst (I0: Kraftstoß des Schlags, Z: Impedanz der Stange). Darum gelten alle Spalte
innerhalb von d0 als gleich wahrscheinlich. Ausgegeben werden Minima und Maxima mit ihren Spalten,
Mittel sowie 5-, 50- und 95-%-Quantil, auch der Anteil der Spalte mit einer Stoßzahl e über 1.
--gap-deviation ergänzt dasselbe für einen normalverteilten Spalt, unter null abgeschnitten.</translation>
    </message>
    <message>
        <source>also print results for a normally distributed gap with this standard deviation</source>
        <translation>auch Ergebnisse für einen normalverteilten Spalt mit dieser Standardabweichung ausgeben</translation>
    </message>
    <message>
        <source>also write the results at each gap to FILE.csv; -o - prints them instead of the table</source>
        <translation>auch die Ergebnisse bei jedem Spalt nach FILE.csv schreiben; -o - gibt sie anstelle der Tabelle aus</translation>
    </message>
    <message>
        <source>with -o, write columns in SI, with units in the header</source>
        <translation>mit -o Spalten in SI-Einheiten schreiben, mit Einheiten im Kopf</translation>
    </message>
    <message>
        <source>number of first blows (transient blows) that the statistics exclude: short for --set drill.settle=N</source>
        <translation>Zahl der ersten Schläge (Einschwingen), die in keiner Statistik zählen: kurz für --set drill.settle=N</translation>
    </message>
    <message>
        <source>seed of the random intervals between blows: short for --set drill.seed=N</source>
        <translation>Startwert der zufälligen Schlagabstände: kurz für --set drill.seed=N</translation>
    </message>
    <message>
        <source>vary this parameter and compare its values; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C, with units</source>
        <translation>diesen Parameter verändern und seine Werte vergleichen; VALUES ist START:STOP:COUNT, START:STOP:COUNT:log (gleiche Verhältnisse) oder A,B,C, mit Einheiten</translation>
    </message>
    <message>
        <source>with --scan, also write the gap between bit and rock at the start of each blow to this file, without transient blows</source>
        <translation>mit --scan auch den Spalt zwischen Krone und Gestein zu Beginn jedes Schlags in diese Datei schreiben, ohne die Schläge zum Einschwingen</translation>
    </message>
    <message>
        <source>with -o DIR, also write the motion and forces over time from blow A to blow B</source>
        <translation>mit -o DIR auch Bewegung und Kräfte über der Zeit von Schlag A bis Schlag B schreiben</translation>
    </message>
    <message>
        <source>print dimensionless numbers: multiples of the scales d0, v0, I0, F0 and t0 of a blow (`drillwave help glossary 2`)</source>
        <translation>dimensionslose Zahlen ausgeben: Vielfache der Skalen d0, v0, I0, F0 und t0 eines Schlags (`drillwave help glossary 2`)</translation>
    </message>
    <message>
        <source>FILE.csv: also write one row per blow, with the settings in FILE.csv.yaml; DIR: write all files of the run into DIR; -o - prints the rows</source>
        <translation>FILE.csv: auch eine Zeile je Schlag schreiben, die Einstellungen nach FILE.csv.yaml; DIR: alle Dateien des Laufs nach DIR schreiben; -o - gibt die Zeilen aus</translation>
    </message>
    <message>
        <source>vary the blow frequency: short for --along drill.blow_frequency=VALUES</source>
        <translation>die Schlagfrequenz verändern: kurz für --along drill.blow_frequency=VALUES</translation>
    </message>
    <message>
        <source>also write the table of --along to FILE.csv; -o - prints this CSV instead of the tables</source>
        <translation>auch die Tabelle von --along nach FILE.csv schreiben; -o - gibt dieses CSV anstelle der Tabellen aus</translation>
    </message>
    <message>
        <source>find the best design for uncertain inputs, and which input to measure</source>
        <translation>die beste Auslegung bei unsicheren Größen finden, und welche Größe zu messen ist</translation>
    </message>
    <message>
        <source>uncertain input and the range of its values; see the description of the command</source>
        <translation>unsichere Größe und der Bereich ihrer Werte; siehe die Beschreibung des Befehls</translation>
    </message>
    <message>
        <source>take the samples of uncertain inputs from this table, one per row; its header names parameters</source>
        <translation>die Stichproben unsicherer Größen aus dieser Tabelle nehmen, eine je Zeile; ihr Kopf nennt Parameter</translation>
    </message>
    <message>
        <source>statistic of an output to maximise, or with min:… to minimise; up to three; the designs are ranked by the first</source>
        <translation>Statistik eines Ergebnisses, die maximiert oder mit min:… minimiert wird; bis zu drei; die erste ordnet die Auslegungen</translation>
    </message>
    <message>
        <source>give every design the blow energy of FILE, by scaling its impulse or hammer velocity</source>
        <translation>jeder Auslegung die Schlagenergie von FILE geben, durch Skalieren von Kraftstoß oder Hammergeschwindigkeit</translation>
    </message>
    <message>
        <source>also write the tables, the scenario of the best design and the JSON object into DIR</source>
        <translation>auch die Tabellen, das Szenario der besten Auslegung und das JSON-Objekt nach DIR schreiben</translation>
    </message>
    <message>
        <source>write a report: inputs with sources, results, verdict, plots, scenario</source>
        <translation>eine Seite zum Weitergeben: Eingaben mit Quellen, Ergebnisse, Urteil, Diagramme, das Szenario</translation>
    </message>
    <message>
        <source>name of the project, shown below the title</source>
        <translation>Name des Projekts, steht unter dem Titel</translation>
    </message>
    <message>
        <source>author</source>
        <translation>wer ihn geschrieben hat</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>für wen er ist</translation>
    </message>
    <message>
        <source>file or folder to write the report to; -o - prints the HTML</source>
        <translation>Datei oder Ordner für den Bericht; -o - gibt das HTML aus</translation>
    </message>
    <message>
        <source>reproduce the figures of the paper on which the model is based; compare each number printed there with the exact one</source>
        <translation>die Abbildungen der Veröffentlichung wiedergeben, auf der das Modell beruht; jede dort gedruckte Zahl mit der exakten vergleichen</translation>
    </message>
    <message>
        <source>folder to write into; -o - prints only discrepancies.csv (printed and exact numbers of the paper)</source>
        <translation>Ordner, in den geschrieben wird; -o - gibt nur discrepancies.csv aus (gedruckte und exakte Zahlen der Veröffentlichung)</translation>
    </message>
    <message>
        <source>compare error and run time of every method and resolution</source>
        <translation>Fehler und Rechenzeit jedes Verfahrens und jeder Auflösung vergleichen</translation>
    </message>
    <message>
        <source>Solves the blow exactly, in closed form if it applies, and numerically with the rod divided into
100 to 20000 segments (lattice). Compares errors and run times, which takes some ten seconds. For
drill strings, compares the solver of this program at several cell sizes with a lattice of
constant cells.</source>
        <translation>Löst den Schlag exakt, in geschlossener Form, wenn sie gilt, und numerisch mit der Stange in 100
bis 20000 Segmenten (Gitter). Vergleicht Fehler und Rechenzeiten; das dauert etwa zehn Sekunden.
Bei einem Bohrstrang wird das Verfahren dieses Programms bei mehreren Zellgrößen mit einem Gitter
konstanter Zellen verglichen.</translation>
    </message>
    <message>
        <source>also write the table to accuracy.csv in DIR; -o - prints this CSV instead of the table</source>
        <translation>die Tabelle auch nach accuracy.csv in DIR schreiben; -o - gibt dieses CSV anstelle der Tabelle aus</translation>
    </message>
    <message>
        <source>check the solver on stiff and extreme cases</source>
        <translation>das exakte Verfahren an steifen und extremen Fällen prüfen</translation>
    </message>
    <message>
        <source>Solves some thousand cases: published cases, difficult cases, each parameter through its whole
range, and extreme combinations for every shape of the blow. Checks that momentum and energy are
balanced, that the rock does not pull, and that no contact was missed. Also checks that e hardly
changes if a parameter changes by 1e-10. Compares the results with the limits of soft and rigid
rock, and with the lattice method if its steps are short enough. Compares the stated error with a
more precise solution (long double). Exit code 6 if any check fails.
Two ranges are not covered, because the exact solver would split the waves into more than 30
million pieces. They are beta below 1e-6 with gamma below 1, and tau below 0.1 with exponential
and piston blows.</source>
        <translation>Löst einige tausend Fälle: veröffentlichte Fälle, numerisch schwierige Fälle, jeden Parameter durch seinen ganzen
Bereich und Kombinationen von Extremwerten für jede Form des Schlags. Prüft bei jedem Fall, dass Impuls und
Energie ausgeglichen sind, dass das Gestein nicht zieht und dass kein Kontakt verpasst wurde. Prüft auch, dass
sich e kaum ändert, wenn sich ein Parameter um 1e-10 ändert. Vergleicht die Ergebnisse mit den Grenzfällen weiches
und starres Gestein und, wenn dessen Zeitschritte kurz genug sind, mit dem Gitterverfahren. Vergleicht den
angegebenen Fehler mit einer Lösung höherer Genauigkeit (long double). Exit-Code 6, wenn eine Prüfung fehlschlägt.
Zwei Bereiche sind nicht abgedeckt, weil das exakte Verfahren die Wellen in mehr als 30 Millionen
Stücke teilen würde. Es sind beta unter 1e-6 mit gamma unter 1, und tau unter 0,1 bei
exponentiellen Schlägen und Kolbenschlägen.</translation>
    </message>
    <message>
        <source>print one JSON object with all cases</source>
        <translation>ein JSON-Objekt mit allen Fällen ausgeben</translation>
    </message>
    <message>
        <source>write a table of all cases to stability.csv in DIR; -o - prints it instead of the summary</source>
        <translation>eine Tabelle aller Fälle nach stability.csv in DIR schreiben; -o - gibt sie anstelle der Zusammenfassung aus</translation>
    </message>
    <message>
        <source>list the errors of scenario files, one per line</source>
        <translation>die Fehler von Szenariodateien auflisten, einen je Zeile</translation>
    </message>
    <message>
        <source>Checks scenario files and preset files. Prints one line for each error, and nothing for a file without errors.</source>
        <translation>Prüft Szenariodateien und Dateien mit Voreinstellungen. Gibt eine Zeile je Fehler aus, und nichts für eine Datei ohne Fehler.</translation>
    </message>
    <message>
        <source>write the scenarios into DIR, one file each; -o - prints them</source>
        <translation>die Szenarien nach DIR schreiben, je eine Datei; -o - gibt sie aus</translation>
    </message>
    <message>
        <source>list rods, hammers, rocks and sections of drill strings, with their sources</source>
        <translation>Stangen, Hämmer, Gesteine und Abschnitte von Bohrsträngen auflisten, mit Quellen</translation>
    </message>
    <message>
        <source>list only presets with all of these words in kind, name, numbers or source, such as &quot;T38 bit&quot;</source>
        <translation>nur Voreinstellungen mit allen diesen Wörtern in Art, Name, Zahlen oder Quelle auflisten, zum Beispiel &quot;T38 bit&quot;</translation>
    </message>
    <message>
        <source>mean gap between bit and rock at the start of the blows, from `drill`</source>
        <translation>mittlerer Spalt zwischen Bohrkrone und Gestein zu Beginn der Schläge, aus `drill`</translation>
    </message>
    <message>
        <source>standard deviation of the gap between bit and rock at the start of the blows</source>
        <translation>Standardabweichung des Spalts zwischen Bohrkrone und Gestein zu Beginn der Schläge</translation>
    </message>
    <message>
        <source>gap between bit and rock that 95 % of the blows exceed</source>
        <translation>Spalt zwischen Bohrkrone und Gestein, den 95&#xa0;% der Schläge überschreiten</translation>
    </message>
    <message>
        <source>median of the gap between bit and rock at the start of the blows</source>
        <translation>Median des Spalts zwischen Bohrkrone und Gestein zu Beginn der Schläge</translation>
    </message>
    <message>
        <source>gap between bit and rock that 5 % of the blows exceed</source>
        <translation>Spalt zwischen Bohrkrone und Gestein, den 5&#xa0;% der Schläge überschreiten</translation>
    </message>
    <message>
        <source>mean penetration per blow; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>mittlere Eindringung je Schlag; eine obere Grenze, da alles Gestein unter der Krone als gebrochen gilt</translation>
    </message>
    <message>
        <source>95 % error of drill_penetration, the mean penetration per blow. Needs a second simulation of all blows, with other time steps</source>
        <translation>95-%-Fehler von drill_penetration, der mittleren Eindringung je Schlag. Braucht eine zweite Simulation aller Schläge, mit anderen Zeitschritten</translation>
    </message>
    <message>
        <source>penetration rate, m/s: mean penetration per blow times blow frequency; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>Bohrfortschritt, m/s: mittlere Eindringung je Schlag mal Schlagfrequenz; eine obere Grenze, da alles Gestein unter der Krone als gebrochen gilt</translation>
    </message>
    <message>
        <source>mean impulse on the rock per blow: feed force over blow frequency</source>
        <translation>mittlerer Kraftstoß auf das Gestein je Schlag: Andruck durch Schlagfrequenz</translation>
    </message>
    <message>
        <source>mean over all blows of the largest force on the rock</source>
        <translation>Mittel der größten Kraft auf das Gestein über alle Schläge</translation>
    </message>
    <message>
        <source>largest force in the damper between machine and rod</source>
        <translation>größte Kraft im Dämpfer zwischen Maschine und Stange</translation>
    </message>
    <message>
        <source>contact share: share of blows that start with the bit on the rock, or less than 0.05 d0 away from it. d0 = 2 I0/Z, with the impulse I0 of a blow and the impedance Z of the rod</source>
        <translation>Kontaktanteil: Anteil der Schläge, die mit der Bohrkrone am Gestein beginnen oder weniger als 0,05 d0 davon entfernt. d0 = 2 I0/Z, mit dem Kraftstoß I0 eines Schlags und der Impedanz Z der Stange</translation>
    </message>
    <message>
        <source>mean number of contacts between bit and rock in a blow</source>
        <translation>mittlere Zahl der Kontakte zwischen Bohrkrone und Gestein in einem Schlag</translation>
    </message>
    <message>
        <source>number of blows after which the motion repeats, 1 to 16; 0 if it does not repeat</source>
        <translation>Zahl der Schläge, nach denen sich die Bewegung wiederholt, 1 bis 16; 0, wenn sie sich nicht wiederholt</translation>
    </message>
    <message>
        <source>Lyapunov exponent: growth of a small disturbance per blow; above 0, single blows are not reproducible and only mean values count. Needs a second simulation of all blows</source>
        <translation>Lyapunov-Exponent: Wachstum einer kleinen Störung je Schlag; über 0 sind einzelne Schläge nicht reproduzierbar, und nur Mittelwerte zählen. Braucht eine zweite Simulation aller Schläge</translation>
    </message>
    <message>
        <source>number of round trips that a wave makes through rod or string between two blows (n_b)</source>
        <translation>Zahl der Hin- und Rückläufe einer Welle durch Stange oder Strang zwischen zwei Schlägen (n_b)</translation>
    </message>
    <message>
        <source>error of the momentum balance of all blows, relative to the impulse of the feed force</source>
        <translation>Fehler der Impulsbilanz aller Schläge, bezogen auf den Kraftstoß des Andrucks</translation>
    </message>
    <message>
        <source>error of the energy balance of all blows, as a share of the hammer work</source>
        <translation>Fehler der Energiebilanz aller Schläge, als Anteil an der Hammerarbeit</translation>
    </message>
    <message>
        <source>
drillwave help TOPIC prints the help of a command, as COMMAND --help and -h do. TOPIC can also be
a parameter (help bit_rock.gamma), an output (help cor) or an option (help --shard). It can be a
chapter of the manual, or a section of it (help theory 10). For any other word (help feed) it
prints the places of the manual that contain the word. drillwave version prints the version.

Chapters: %1.

Without a display, the window needs `-platform offscreen`. drillwave --reset-ui opens the window
with its default layout, page, units and choices. drillwave --language de opens it in German, only
this time (sv: Swedish, en: English). Commands also have --language; DRILLWAVE_LANGUAGE=de in the
environment sets the language for all of them.

Exit codes: %2.
</source>
        <translation>
drillwave help TOPIC gibt die Hilfe zu einem Befehl aus, wie auch COMMAND --help und -h. TOPIC kann auch ein
Parameter sein (help bit_rock.gamma), ein Ergebnis (help cor) oder eine Option (help --shard). Auch ein Kapitel
des Handbuchs oder ein Abschnitt daraus ist möglich (help theory 10). Zu jedem anderen Wort (help Vorschub)
gibt es die Stellen des Handbuchs aus, an denen das Wort vorkommt. drillwave version gibt die Version aus.

Kapitel: %1.

Ohne Bildschirm braucht das Fenster `-platform offscreen`. drillwave --reset-ui öffnet das Fenster
mit Anordnung, Seite, Einheiten und Auswahl der Vorgabe. drillwave --language de öffnet es dieses
eine Mal auf Deutsch (sv: Schwedisch, en: Englisch). Auch Befehle kennen --language;
DRILLWAVE_LANGUAGE=de in der Umgebung stellt die Sprache für alle ein.

Exit-Codes: %2.
</translation>
    </message>
    <message>
        <source>print the help of a command, parameter or output, or a chapter of the manual</source>
        <translation>die Hilfe zu Befehl, Parameter oder Ergebnis ausgeben, oder ein Kapitel des Handbuchs</translation>
    </message>
    <message>
        <source>TOPIC is a command (run), an option (--shard), a parameter (bit_rock.gamma), an output (cor) or a
symbol (e). It can also be a chapter of the manual (theory) or a section of it (theory 10). For
any other word (feed, units, exit codes), the places of the manual that contain it are printed,
the best first.</source>
        <translation>TOPIC ist ein Befehl (run), eine Option (--shard), ein Parameter (bit_rock.gamma), ein Ergebnis
(cor) oder ein Formelzeichen (e). Es kann auch ein Kapitel des Handbuchs sein (theory) oder ein
Abschnitt daraus (theory 10). Zu jedem anderen Wort (Vorschub, units, exit codes) werden die
Stellen des Handbuchs ausgegeben, an denen es vorkommt, die besten zuerst.</translation>
    </message>
    <message>
        <source>print the version of the program</source>
        <translation>die Version des Programms ausgeben</translation>
    </message>
    <message>
        <source>keep completed rows in FILE.csv.partial; after an interruption, the same command continues after them</source>
        <translation>fertige Zeilen in FILE.csv.partial behalten; nach einer Unterbrechung fährt derselbe Befehl nach ihnen fort</translation>
    </message>
    <message>
        <source>Writes FILE and its description FILE.yaml as one run without --shard would have written them, with
the same exit code. A PART is a file of rows with PART.yaml beside it, or a folder with all parts,
in any order. All parts must come from the same run: same scenario, varied parameters, table of
cases, build and number of parts. If a part is missing, given twice, from another run or changed
since it was written, the message names it; the exit code is 5.</source>
        <translation>Schreibt FILE und die Beschreibung FILE.yaml, wie ein Lauf ohne --shard sie geschrieben hätte, mit demselben
Exit-Code. Ein PART ist eine Datei mit Zeilen und PART.yaml daneben, oder ein Ordner mit allen Teilen, in
beliebiger Reihenfolge. Alle Teile müssen aus demselben Lauf sein: dasselbe Szenario, dieselben veränderten
Parameter, dieselbe Tabelle der Fälle, dasselbe Programm, dieselbe Zahl der Teile. Fehlt ein Teil, ist er
doppelt, aus einem anderen Lauf oder seit dem Schreiben verändert, nennt ihn die Meldung; der Exit-Code ist 5.</translation>
    </message>
    <message>
        <source>list the built-in scenarios, print the named ones, or write them into a folder</source>
        <translation>eingebaute Szenarien auflisten, die genannten ausgeben oder in einen Ordner schreiben</translation>
    </message>
    <message>
        <source>`drillwave examples t38_string &gt; my.yaml` saves a built-in scenario as a file to edit.</source>
        <translation>`drillwave examples t38_string &gt; my.yaml` speichert ein eingebautes Szenario als Datei, die man ändern kann.</translation>
    </message>
    <message>
        <source>simulate consecutive blows under a feed force: penetration rate, gaps, errors</source>
        <translation>aufeinanderfolgende Schläge unter einem Andruck: Bohrfortschritt, Spalte, Fehler</translation>
    </message>
    <message>
        <source>use this measured record as the blow; the options below say how to read it</source>
        <translation>diese gemessene Aufzeichnung als Schlag verwenden; die Optionen darunter sagen, wie sie gelesen wird</translation>
    </message>
    <message>
        <source>use all samples of --signal; by default samples are left out as long as this changes impulse and coefficient of restitution by less than 1e-4</source>
        <translation>alle Abtastwerte von --signal behalten; in der Vorgabe werden einige weggelassen, solange sich Kraftstoß und Stoßzahl um weniger als 1e-4 ändern</translation>
    </message>
    <message>
        <source>sign between the columns of the table: tab, semicolon, comma, bar (|) or blank (default: detected)</source>
        <translation>Zeichen zwischen den Spalten der Tabelle: tab, semicolon, comma, bar (|) oder blank (Vorgabe: erkannt)</translation>
    </message>
    <message>
        <source>decimal sign of the table: point or comma (default: detected)</source>
        <translation>Dezimalzeichen der Tabelle: point oder comma (Vorgabe: erkannt)</translation>
    </message>
    <message>
        <source>number of the first line with a sample (default: detected)</source>
        <translation>Nummer der ersten Zeile mit einem Abtastwert (Vorgabe: erkannt)</translation>
    </message>
    <message>
        <source>character encoding of the table: utf-8, windows-1252, latin-1, utf-16le or utf-16be (default: detected)</source>
        <translation>Zeichenkodierung der Tabelle: utf-8, windows-1252, latin-1, utf-16le oder utf-16be (Vorgabe: erkannt)</translation>
    </message>
    <message>
        <source>column of the times, by name or by number from 1</source>
        <translation>Spalte der Zeiten, mit Namen oder Nummer ab 1</translation>
    </message>
    <message>
        <source>column of the signal, by name or by number from 1; A+B takes the mean of two gauges on opposite sides</source>
        <translation>Spalte des Signals, mit Namen oder Nummer ab 1; A+B nimmt das Mittel zweier Messstreifen auf gegenüberliegenden Seiten</translation>
    </message>
    <message>
        <source>unit of the times, if the table does not state it: s, ms, us</source>
        <translation>Einheit der Zeiten, wenn die Tabelle sie nicht nennt: s, ms, us</translation>
    </message>
    <message>
        <source>unit of the signal, if the table does not state it: kN, microstrain, V, MPa, m/s</source>
        <translation>Einheit des Signals, wenn die Tabelle sie nicht nennt: kN, microstrain, V, MPa, m/s</translation>
    </message>
    <message>
        <source>sampling rate, such as 5MHz, used instead of a time column</source>
        <translation>Abtastrate, zum Beispiel 5MHz, statt einer Spalte von Zeiten</translation>
    </message>
    <message>
        <source>multiply the signal by this factor, or by a force per unit: 50kN/V, 18kN s/m</source>
        <translation>das Signal mit diesem Faktor multiplizieren, oder mit einer Kraft je Einheit: 50kN/V, 18kN s/m</translation>
    </message>
    <message>
        <source>gain of the amplifier, for a signal in volts (default: 1)</source>
        <translation>Verstärkung des Verstärkers, für ein Signal in Volt (Vorgabe: 1)</translation>
    </message>
    <message>
        <source>supply voltage of the bridge in volts, for a signal in volts</source>
        <translation>Speisespannung der Brücke in Volt, für ein Signal in Volt</translation>
    </message>
    <message>
        <source>bridge factor of the strain gauges: 1 (quarter bridge), 2 (half bridge), 4 (full bridge) or 2.6 (full bridge with Poisson gauges)</source>
        <translation>Brückenfaktor der Dehnungsmessstreifen: 1 (Viertelbrücke), 2 (Halbbrücke), 4 (Vollbrücke) oder 2.6 (Vollbrücke mit Querstreifen)</translation>
    </message>
    <message>
        <source>gauge factor of the strain gauges, for a signal in volts or mV/V</source>
        <translation>k-Faktor der Dehnungsmessstreifen, für ein Signal in Volt oder mV/V</translation>
    </message>
    <message>
        <source>cross-section of the bar at the gauge, such as 1134mm^2</source>
        <translation>Querschnitt des Stabs an der Messstelle, zum Beispiel 1134mm^2</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the bar that carries the gauge, such as 210GPa</source>
        <translation>Elastizitätsmodul des Stabs mit der Messstelle, zum Beispiel 210GPa</translation>
    </message>
    <message>
        <source>time range in which the signal is zero on average, such as -50us:-10us</source>
        <translation>Zeitbereich, in dem das Signal im Mittel null ist, zum Beispiel -50us:-10us</translation>
    </message>
    <message>
        <source>ignore samples earlier than this time in the table, such as 0us</source>
        <translation>Abtastwerte vor dieser Zeit der Tabelle weglassen, zum Beispiel 0us</translation>
    </message>
    <message>
        <source>ignore samples later than this time in the table, such as 400us</source>
        <translation>Abtastwerte nach dieser Zeit der Tabelle weglassen, zum Beispiel 400us</translation>
    </message>
    <message>
        <source>reverse the sign of the signal: its largest value is tension (default: compression)</source>
        <translation>das Vorzeichen des Signals umkehren: sein größter Wert ist Zug (Vorgabe: Druck)</translation>
    </message>
    <message>
        <source>treatment of rows in which a value is not a number: refuse the table, or skip these rows (default: refuse)</source>
        <translation>Behandlung von Zeilen, in denen ein Wert keine Zahl ist: refuse (Tabelle ablehnen) oder skip (Zeilen auslassen) (Vorgabe: refuse)</translation>
    </message>
    <message>
        <source>read the record with the options that `drillwave signal --save-recorder NAME` has saved</source>
        <translation>die Aufzeichnung mit den Optionen lesen, die `drillwave signal --save-recorder NAME` aufbewahrt hat</translation>
    </message>
    <message>
        <source>design variable to vary; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C; to compare presets: hammer=NAME,NAME</source>
        <translation>zu verändernde Entwurfsgröße; VALUES ist START:STOP:COUNT, START:STOP:COUNT:log (gleiche Verhältnisse) oder A,B,C; um Voreinstellungen zu vergleichen: hammer=NAME,NAME</translation>
    </message>
    <message>
        <source>read records of force, strain or voltage; print their units, blow and quality</source>
        <translation>Aufzeichnungen von Kraft, Dehnung oder Spannung lesen: Einheiten, Schlag, Qualität</translation>
    </message>
    <message>
        <source>Reads tables of a signal measured over time, and finds encoding, separator, decimal sign, columns
and units. If the table does not state something that is needed, the last lines printed ask for
it, and the exit code is 5. Several RECORDs are read as one series and give one row each. Commands
that take a scenario can use such a record as the blow, with --signal FILE and the same options.</source>
        <translation>Liest Tabellen eines über der Zeit gemessenen Signals und erkennt Kodierung, Trennzeichen, Dezimalzeichen, Spalten
und Einheiten. Nennt die Tabelle etwas nicht, das gebraucht wird, fragen die letzten ausgegebenen Zeilen danach,
und der Exit-Code ist 5. Mehrere RECORD werden als eine Reihe gelesen und ergeben je eine Zeile. Befehle, die ein
Szenario nehmen, können eine solche Aufzeichnung als Schlag verwenden, mit --signal FILE und denselben Optionen.</translation>
    </message>
    <message>
        <source>save the options for reading the record under this name; --recorder NAME uses them again</source>
        <translation>die Optionen zum Lesen der Aufzeichnung unter diesem Namen aufbewahren; --recorder NAME verwendet sie wieder</translation>
    </message>
    <message>
        <source>print JSON; for several FILEs, an array</source>
        <translation>JSON ausgeben; bei mehreren FILE ein Array</translation>
    </message>
    <message>
        <source>write the signal as read, with the columns time [us] and force [kN]</source>
        <translation>das Signal wie gelesen schreiben, mit den Spalten time [us] und force [kN]</translation>
    </message>
    <message>
        <source>overwrite FILE.csv if it exists</source>
        <translation>FILE.csv überschreiben, wenn es vorhanden ist</translation>
    </message>
    <message>
        <source>write CSV with semicolons between cells and decimal commas</source>
        <translation>CSV mit Semikolons zwischen den Zellen und Dezimalkommas schreiben</translation>
    </message>
    <message>
        <source>mean of a normally distributed gap, such as 0.5mm (default: the gap of FILE); if FILE has no physical units, a multiple of d0, such as 0.2</source>
        <translation>Mittel eines normalverteilten Spalts, zum Beispiel 0.5mm (Vorgabe: der Spalt von FILE); wenn FILE keine physikalischen Einheiten hat, ein Vielfaches von d0, zum Beispiel 0.2</translation>
    </message>
    <message>
        <source>print one JSON object instead of the table</source>
        <translation>ein JSON-Objekt anstelle der Tabelle ausgeben</translation>
    </message>
    <message>
        <source>take presets from this file instead of the built-in ones</source>
        <translation>Voreinstellungen aus dieser Datei nehmen statt der eingebauten</translation>
    </message>
    <message>
        <source>print one JSON object instead of the summary</source>
        <translation>ein JSON-Objekt anstelle der Zusammenfassung ausgeben</translation>
    </message>
    <message>
        <source>solution method: exact, lattice (time steps) or closed_form (default: exact; for a result file, its own method)</source>
        <translation>Lösungsverfahren: exact, lattice (Zeitschritte) oder closed_form (Vorgabe: exact; bei einer Ergebnisdatei deren Verfahren)</translation>
    </message>
    <message>
        <source>number of segments into which the lattice method (time steps) divides the rod (default: 10000)</source>
        <translation>Zahl der Segmente, in die das Gitterverfahren (Zeitschritte) die Stange teilt (Vorgabe: 10000)</translation>
    </message>
    <message>
        <source>do not solve a blow whose waves the exact solver must split into more than N pieces (default: 1000000, a few seconds at most)</source>
        <translation>einen Schlag nicht lösen, dessen Wellen das exakte Verfahren in mehr als N Stücke teilen muss (Vorgabe: 1000000, höchstens einige Sekunden)</translation>
    </message>
    <message>
        <source>outputs to write as columns, listed below (default: cor, the coefficient of restitution)</source>
        <translation>Ergebnisse, die als Spalten geschrieben werden, unten aufgelistet (Vorgabe: cor, die Stoßzahl)</translation>
    </message>
    <message>
        <source>leave outputs empty if the exact solver must split the waves into more than N pieces (default: 1000000, at most about 2 s per row)</source>
        <translation>die Ergebnisse einer Zeile leer lassen, wenn das exakte Verfahren die Wellen in mehr als N Stücke teilen muss (Vorgabe: 1000000, höchstens etwa 2 s je Zeile)</translation>
    </message>
    <message>
        <source>number of threads (default: all)</source>
        <translation>Zahl der Threads (Vorgabe: alle)</translation>
    </message>
    <message>
        <source>outputs to compute along the parameter, listed below (default: cor, the coefficient of restitution)</source>
        <translation>Ergebnisse entlang des Parameters, unten aufgelistet (Vorgabe: cor, die Stoßzahl)</translation>
    </message>
    <message>
        <source>print one JSON object instead of the tables</source>
        <translation>ein JSON-Objekt anstelle der Tabellen ausgeben</translation>
    </message>
    <message>
        <source>skip blows whose waves the exact solver must split into more than N pieces (default: 1000000)</source>
        <translation>Schläge auslassen, deren Wellen das exakte Verfahren in mehr als N Stücke teilen muss (Vorgabe: 1000000)</translation>
    </message>
    <message>
        <source>output to map, listed below (default: cor, the coefficient of restitution)</source>
        <translation>Ergebnis der Karte, unten aufgelistet (Vorgabe: cor, die Stoßzahl)</translation>
    </message>
    <message>
        <source>print the summary and the contours of the map as one JSON object</source>
        <translation>die Zusammenfassung und die Höhenlinien der Karte als ein JSON-Objekt ausgeben</translation>
    </message>
    <message>
        <source>skip points for which the exact solver must split the waves into more than N pieces (default: 1000000, at most about 2 s per point)</source>
        <translation>Punkte auslassen, bei denen das exakte Verfahren die Wellen in mehr als N Stücke teilen muss (Vorgabe: 1000000, höchstens etwa 2 s je Punkt)</translation>
    </message>
    <message>
        <source>number of blows: short for --set drill.blows=N (default: 1000, with --scan 300)</source>
        <translation>Zahl der Schläge: kurz für --set drill.blows=N (Vorgabe: 1000, mit --scan 300)</translation>
    </message>
    <message>
        <source>time steps per duration t0 of the blow, 10 to 400 (default: 40, with --scan 20)</source>
        <translation>Zeitschritte je Dauer t0 des Schlags, 10 bis 400 (Vorgabe: 40, mit --scan 20)</translation>
    </message>
    <message>
        <source>print numbers in SI units (default)</source>
        <translation>Zahlen in SI-Einheiten ausgeben (Vorgabe)</translation>
    </message>
    <message>
        <source>refuse a computation if its number of time steps times its number of section ends is above N (default: 4e9)</source>
        <translation>eine Rechnung ablehnen, wenn die Zahl der Zeitschritte mal die Zahl der Abschnittsenden über N liegt (Vorgabe: 4e9)</translation>
    </message>
    <message>
        <source>also print a table over the values of this parameter. VALUES is START:STOP[:COUNT], START:STOP[:COUNT]:log (equal ratios) or A,B,C. Default COUNT: 101, or every integer if the parameter is an integer</source>
        <translation>auch eine Tabelle über die Werte dieses Parameters ausgeben. VALUES ist START:STOP[:COUNT], START:STOP[:COUNT]:log (gleiche Verhältnisse) oder A,B,C. Vorgabe für COUNT: 101, oder jede ganze Zahl bei ganzzahligen Parametern</translation>
    </message>
    <message>
        <source>number of processor threads for --along (default: all)</source>
        <translation>Zahl der Threads für --along (Vorgabe: alle)</translation>
    </message>
    <message>
        <source>number of random samples for each design, rounded up to a power of two (default: 4096, for a drill string 1024)</source>
        <translation>Zahl der zufälligen Stichproben je Auslegung, aufgerundet auf eine Zweierpotenz (Vorgabe: 4096, bei einem Bohrstrang 1024)</translation>
    </message>
    <message>
        <source>seed of the random samples (default: 1)</source>
        <translation>Startwert der zufälligen Stichproben (Vorgabe: 1)</translation>
    </message>
    <message>
        <source>formats of the figures (default: png,svg)</source>
        <translation>Formate der Abbildungen (Vorgabe: png,svg)</translation>
    </message>
    <message>
        <source>numbers of rod segments to compare in the lattice method (time steps), such as 100,1000 (default: from 100 to 20000)</source>
        <translation>Segmentzahlen der Stange, die im Gitterverfahren (Zeitschritte) verglichen werden, etwa 100,1000 (Vorgabe: von 100 bis 20000)</translation>
    </message>
    <message>
        <source>limit the work of the lattice method, counted as time steps times segments (default: 1000000000, about half a minute)</source>
        <translation>den Aufwand des Gitterverfahrens begrenzen, gezählt als Zeitschritte mal Segmente (Vorgabe: 1000000000, etwa eine halbe Minute)</translation>
    </message>
    <message>
        <source>find stiffness and elasticity of the rock from strain gauges, with uncertainty</source>
        <translation>Steifigkeit und Elastizität des Gesteins aus Dehnungsmessstreifen, mit Unsicherheit</translation>
    </message>
    <message>
        <source>also write tables, random samples of the rock, and the scenario with the rock that was found, into DIR</source>
        <translation>auch Tabellen, zufällige Stichproben des Gesteins sowie das Szenario mit dem gefundenen Gestein nach DIR schreiben</translation>
    </message>
    <message>
        <source>limit: accept only designs for which this statistic of the output is at most VALUE</source>
        <translation>Grenze: nur Auslegungen zulassen, bei denen diese Statistik des Ergebnisses höchstens VALUE ist</translation>
    </message>
    <message>
        <source>limit: accept only designs for which this statistic of the output is at least VALUE</source>
        <translation>Grenze: nur Auslegungen zulassen, bei denen diese Statistik des Ergebnisses mindestens VALUE ist</translation>
    </message>
    <message>
        <source>read these records of strain gauges; give several records in the order of hole depth, the shallowest first</source>
        <translation>diese Aufzeichnungen von Dehnungsmessstreifen lesen; mehrere nach der Bohrlochtiefe ordnen, die flachste zuerst</translation>
    </message>
    <message>
        <source>column of a gauge and its distance from the bit face; give one or two gauges. A+B@… takes the mean of two gauges on opposite sides</source>
        <translation>Spalte einer Messstelle und ihr Abstand von der Kronenstirn; eine oder zwei Messstellen angeben. A+B@… nimmt das Mittel zweier Messstreifen auf gegenüberliegenden Seiten</translation>
    </message>
    <message>
        <source>95 % tolerance of a known input: KEY (gain, zero, gauge or a dimension) is within +-TOL of its value; see the description of the command</source>
        <translation>95-%-Toleranz einer bekannten Eingabe: KEY (gain, zero, gauge oder ein Maß) liegt um höchstens +-TOL neben seinem Wert; siehe die Beschreibung des Befehls</translation>
    </message>
    <message>
        <source>support behind the rock or specimen: rigid, or bar if the specimen is between two equal bars (default: rigid)</source>
        <translation>Auflage hinter Gestein oder Probe: rigid (starr), oder bar, wenn die Probe zwischen zwei gleichen Stäben liegt (Vorgabe: rigid)</translation>
    </message>
    <message>
        <source>predict the wave at a gauge on the bar behind the specimen, DISTANCE away from the specimen, and print the error; needs --backing bar</source>
        <translation>die Welle an einer Messstelle auf dem Stab hinter der Probe vorhersagen, im Abstand DISTANCE von der Probe, und den Fehler ausgeben; braucht --backing bar</translation>
    </message>
    <message>
        <source>correction for the dispersion of waves between gauge and bit: fit (estimated from the record), bar (theory of a round bar) or none (default: fit)</source>
        <translation>Korrektur der Dispersion der Wellen zwischen Messstelle und Bohrkrone: fit (aus der Aufzeichnung geschätzt), bar (Theorie eines runden Stabs) oder none (Vorgabe: fit)</translation>
    </message>
    <message>
        <source>use the record only up to this time after the reflected wave reaches the gauge</source>
        <translation>die Aufzeichnung nur bis zu dieser Zeit nach Ankunft der reflektierten Welle an der Messstelle verwenden</translation>
    </message>
    <message>
        <source>blows of a record to evaluate: first, or all (default: first)</source>
        <translation>Schläge einer Aufzeichnung, die ausgewertet werden: first (der erste) oder all (alle) (Vorgabe: first)</translation>
    </message>
    <message>
        <source>seed of the random numbers for noise and samples (default: 1)</source>
        <translation>Startwert der Zufallszahlen für Rauschen und Stichproben (Vorgabe: 1)</translation>
    </message>
    <message>
        <source>FILE.html is a single file with inputs, results, pictures and the scenario. It can be run again:
`drillwave run FILE.html`. FILE.pdf has the same content for printing on A4. -o DIR writes both,
as report.html and report.pdf. The numbers are those of `run --json`, in SI if the scenario has
physical units. The source of a value is the comment after it in the scenario file. For drill
strings, the report also shows the sections, drawn to scale, with their largest stresses.</source>
        <translation>FILE.html ist eine einzige Datei mit Eingaben, Ergebnissen, Bildern und dem Szenario. Sie lässt
sich neu rechnen: `drillwave run FILE.html`. FILE.pdf hat denselben Inhalt zum Drucken auf A4. -o
DIR schreibt beide, als report.html und report.pdf. Die Zahlen sind die von `run --json`, in
SI-Einheiten, wenn das Szenario physikalische Einheiten hat. Die Quelle eines Werts ist der
Kommentar dahinter in der Szenariodatei. Bei einem Bohrstrang zeigt der Bericht auch die
Abschnitte, maßstäblich gezeichnet, mit ihren größten Spannungen.</translation>
    </message>
    <message>
        <source>add studies to the report: drill (consecutive blows), design (best design, from the block `design` of FILE)</source>
        <translation>Studien in den Bericht aufnehmen: drill (aufeinanderfolgende Schläge), design (beste Auslegung, nach dem Block `design` von FILE)</translation>
    </message>
    <message>
        <source>number of processor threads for the studies added by --with (default: all)</source>
        <translation>Zahl der Threads für die Studien, die --with hinzufügt (Vorgabe: alle)</translation>
    </message>
    <message>
        <source>feed force that single blows require, and whether the installed one is sufficient</source>
        <translation>Andruck, den einzelne Schläge erfordern, und ob der angegebene ausreicht</translation>
    </message>
    <message>
        <source>with -o, also write the strain that a gauge at this distance from the bit face would record, in a column named COLUMN</source>
        <translation>mit -o auch die Dehnung schreiben, die eine Messstelle in diesem Abstand von der Kronenstirn aufzeichnen würde, in einer Spalte mit dem Namen COLUMN</translation>
    </message>
    <message>
        <source>white noise to add to --record, in % of its largest strain (default: 0%)</source>
        <translation>weißes Rauschen, das --record hinzugefügt wird, in % der größten Dehnung (Vorgabe: 0%)</translation>
    </message>
    <message>
        <source>seed of the random numbers for --noise (default: 1)</source>
        <translation>Startwert der Zufallszahlen für --noise (Vorgabe: 1)</translation>
    </message>
    <message>
        <source>-o DIR writes scenario.yaml, summary.json, histories.csv and events.csv; each of them contains the
scenario, so that `drillwave run` can run it again. With --plots, it also writes the plots blow.*,
rock.*, wave_picture.* and rod.*. For drill strings, the histories are taken at the middle of the
longest section. To rehearse a measurement for `identify`, add --record near@1.13m --record
far@2.93m --noise 1%. This also writes record.csv, the strain that two gauges would record in 1e6
samples per second. --record top+bottom@1.13m records two gauges on opposite sides of the rod,
each with its own noise.</source>
        <translation>-o DIR schreibt scenario.yaml, summary.json, histories.csv und events.csv; jede dieser Dateien
enthält das Szenario, so dass `drillwave run` sie wieder rechnen kann. Mit --plots werden auch die
Diagramme blow.*, rock.*, wave_picture.* und rod.* geschrieben. Bei Bohrsträngen stehen die Verläufe
für die Mitte des längsten Abschnitts. Um eine Messung für `identify` zu erproben, --record
near@1.13m --record far@2.93m --noise 1% hinzufügen. Das schreibt auch record.csv, die Dehnung, die
zwei Messstellen mit 1e6 Abtastwerten je Sekunde aufzeichnen würden. --record oben+unten@1.13m
zeichnet zwei Messstellen auf gegenüberliegenden Seiten der Stange auf, jede mit eigenem Rauschen.</translation>
    </message>
    <message>
        <source>Solves every design (every combination of the --choose values) with the same samples of the
uncertain inputs. Prints the best design over all samples (best for uncertain rock) and the
best with the inputs of FILE (best for the values entered). The first --aim decides both. Also
prints which designs are equally good within the errors, which input to measure first, and the
worst case in the ranges. The first sentence warns if the recommended design exceeds a
strength.
  --uncertain KEY=LOW:HIGH   all values from LOW to HIGH equally likely; with :log, equally likely
                             on a logarithmic scale. With :normal or :lognormal, a normal or
                             lognormal distribution with 95 % of the values from LOW to HIGH
  --uncertain KEY=+-P%       P % to either side of the value in FILE, or of the --choose value
  --choose hammer=NAME,NAME  hammer presets by name, or hammer=all for all of them; rod= works in the
                             same way. For drill strings, hammer= takes pistons, and bit= takes bits
A STATISTIC is mean, q01 to q99 (quantiles), min, max or nominal (with the inputs of FILE).
Without --aim, the objectives are max:efficiency@q05 and, if FILE has a blow frequency,
min:thrust@q95. Options that are not given are taken from the block `design` of FILE. -o DIR
writes designs.csv, pareto.csv, sensitivity.csv, worst.csv, best.yaml, design.json and, with
--plots, design.png.</source>
        <translation>Löst jede Auslegung (jede Kombination der Werte von --choose) mit denselben zufälligen Stichproben
der unsicheren Größen. Gibt die beste Auslegung über alle Stichproben aus (beste für unsicheres
Gestein) und die beste mit den Eingaben von FILE (beste für die eingegebenen Werte). Über beide
entscheidet das erste --aim. Gibt auch aus, welche Auslegungen im Rahmen der Fehler gleich gut
sind, welche Größe zuerst zu messen ist, und den schlechtesten Fall in den Bereichen. Der erste
Satz warnt, wenn die empfohlene Auslegung eine Festigkeit überschreitet.
  --uncertain KEY=LOW:HIGH   alle Werte von LOW bis HIGH gleich wahrscheinlich; mit :log gleich
                             wahrscheinlich auf logarithmischer Skala. Mit :normal oder :lognormal
                             eine Normal- oder Lognormalverteilung mit 95&#xa0;% der Werte von LOW bis HIGH
  --uncertain KEY=+-P%       P&#xa0;% nach beiden Seiten vom Wert in FILE oder vom Wert von --choose
  --choose hammer=NAME,NAME  Voreinstellungen des Hammers mit Namen, oder alle mit hammer=all;
                             ebenso rod=. Bei Bohrsträngen nimmt hammer= Kolben und bit= Bohrkronen
Eine STATISTIC ist mean, q01 bis q99 (Quantile), min, max oder nominal (mit den Eingaben von
FILE). Ohne --aim sind die Zielgrößen max:efficiency@q05 und, wenn FILE eine Schlagfrequenz hat,
min:thrust@q95. Optionen, die nicht angegeben sind, werden aus dem Block `design` von FILE
genommen. -o DIR schreibt designs.csv, pareto.csv, sensitivity.csv, worst.csv, best.yaml,
design.json und, mit --plots, design.png.</translation>
    </message>
    <message>
        <source>Lists the built-in presets, or those of FILE.yaml. KIND restricts the list to rod, hammer, rock,
piston, adapter, coupling or bit. Other commands use a preset with --rod NAME, --hammer NAME or
--rock NAME; the beginning of the name suffices if only one preset has it. Pistons, adapters,
couplings and bits are sections of drill strings: insert them on the page String of the window.</source>
        <translation>Listet die eingebauten Voreinstellungen auf oder die von FILE.yaml. KIND beschränkt die Liste auf
rod, hammer, rock, piston, adapter, coupling oder bit. Andere Befehle verwenden eine
Voreinstellung mit --rod NAME, --hammer NAME oder --rock NAME; der Anfang des Namens genügt, wenn
nur eine Voreinstellung so beginnt. Kolben, Einsteckenden, Kupplungsmuffen und Bohrkronen sind
Abschnitte von Bohrsträngen: auf der Seite Strang des Fensters einsetzen.</translation>
    </message>
    <message>
        <source>write the files of the run into DIR; -o - writes none</source>
        <translation>die Dateien des Laufs nach DIR schreiben; -o - schreibt keine</translation>
    </message>
    <message>
        <source>write the rows to FILE.csv, and the settings of the run to FILE.csv.yaml; -o - prints the rows (default)</source>
        <translation>die Zeilen nach FILE.csv schreiben und die Einstellungen des Laufs nach FILE.csv.yaml; -o - gibt die Zeilen aus (Vorgabe)</translation>
    </message>
    <message>
        <source>Follows outputs continuously over the range of a parameter, and finds every kink and jump. For
each output, prints where it is smallest and largest, its other minima and maxima, its kinks and
its jumps. Also prints where the output crosses a --level. All values have errors. If following an
output takes too much computing, it is solved only at single points, and the table says so.
--goal X prints every value of the parameter at which the output is X, with its error, and whether
there may be others. If no value gives X, prints the output nearest to X and where it occurs. Give
values with units if the parameter has one: --along bit_rock.stiffness=10MN/m:10GN/m:log</source>
        <translation>Verfolgt Ergebnisse stetig über den Bereich eines Parameters und findet jeden Knick und Sprung. Gibt für
jedes Ergebnis aus, wo es am kleinsten und am größten ist, seine anderen Minima und Maxima, seine Knicke
und Sprünge. Gibt auch aus, wo das Ergebnis einen Wert von --level kreuzt. Alle Werte haben Fehler. Braucht
das bei einem Ergebnis zu viel Rechnung, wird es nur an einzelnen Punkten gelöst, und die Tabelle sagt das.
--goal X gibt jeden Wert des Parameters aus, bei dem das Ergebnis X ist, mit Fehler, und ob es weitere
geben kann. Ergibt kein Wert X, gibt es das Ergebnis aus, das X am nächsten kommt, und wo es auftritt.
Werte mit Einheit angeben, wenn der Parameter eine hat: --along bit_rock.stiffness=10MN/m:10GN/m:log</translation>
    </message>
    <message>
        <source>Finds stiffness and elasticity (gamma) of the rock, and the gap between bit and rock. Uses the
waves recorded by strain gauges on the rod, or on the last rod of a string. Prints the values
with their 95 % intervals, what limits their accuracy, and what to measure better. The rock of
FILE (bit_rock) is used only with --law file. --known KEY=+-TOL states how well the inputs are
known:
  --known gain=+-5% zero=+-1%   gain of the amplifier, and its zero line in % of the peak
  --known gauge=+-2mm           distance of the gauges from the bit face
  --known rod.diameter=+-0.1mm  a dimension of the section with the gauge, or of a section between
                                gauge and bit
Records are read with the options of `signal`. -o DIR writes identified.yaml, posterior.csv
(random samples of the rock for design --draws), match.csv, force_penetration.csv, incident.csv,
identify.json and, for several records, records.csv. Exit code 0: stiffness or gamma is known.
Exit code 6: neither is known, or the record contradicts the model. The intervals can be too
narrow if the loading or the unloading curve of the rock is not a straight line (commands
§4.17).</source>
        <translation>Bestimmt Steifigkeit und Elastizität (gamma) des Gesteins und den Spalt zwischen Bohrkrone und
Gestein. Verwendet die Wellen, die Dehnungsmessstreifen auf der Stange oder auf der letzten Stange
eines Strangs aufzeichnen. Gibt die Werte mit ihren 95&#xa0;%-Intervallen aus, was ihre Genauigkeit
begrenzt und was besser zu messen ist. Das Gestein von FILE (bit_rock) wird nur mit --law file
verwendet. --known KEY=+-TOL sagt, wie genau die Eingaben bekannt sind:
  --known gain=+-5% zero=+-1%   Verstärkung des Verstärkers und seine Nulllinie in % der Spitze
  --known gauge=+-2mm           Abstand der Messstellen von der Kronenstirn
  --known rod.diameter=+-0.1mm  ein Maß des Abschnitts mit der Messstelle oder eines Abschnitts
                                zwischen Messstelle und Krone
Aufzeichnungen werden mit den Optionen von `signal` gelesen. -o DIR schreibt identified.yaml,
posterior.csv (Stichproben des Gesteins für design --draws), match.csv, force_penetration.csv,
incident.csv, identify.json und bei mehreren Aufzeichnungen records.csv. Exit-Code 0: Steifigkeit
oder gamma ist bekannt. Exit-Code 6: keines von beiden ist bekannt, oder die Aufzeichnung
widerspricht dem Modell. Die Intervalle können zu eng sein, wenn die Belastungs- oder die
Entlastungskurve des Gesteins keine Gerade ist (commands §4.17).</translation>
    </message>
    <message>
        <source>rock law to fit: bilinear (straight loading curve), corner (one corner in it) or auto (either); file checks the law given in FILE without a fit (default: auto)</source>
        <translation>Gesetz des Gesteins für die Anpassung: bilinear (gerade Belastungskurve), corner (mit einer Ecke) oder auto (eines von beiden); file prüft das Gesetz in FILE ohne Anpassung (Vorgabe: auto)</translation>
    </message>
    <message>
        <source>date printed in the report, any text (default: none)</source>
        <translation>Datum, das im Bericht steht, beliebiger Text (Vorgabe: keines)</translation>
    </message>
    <message>
        <source>write no plots and no PDF; a display is then not needed</source>
        <translation>keine Diagramme und kein PDF schreiben; dann ist kein Bildschirm nötig</translation>
    </message>
    <message>
        <source>Writes into DIR the data of Figs 3 to 8 of the paper on which the model is based, as CSV and
as pictures. discrepancies.csv compares each number printed in that paper with the exact one.
index.html shows all of them. The reference curves are written twice, because the paper
scales stiffness in two ways: by k0 = Z/(2T) in its plots, by k0 = Z/t0 in its text. Z is the
impedance of the rod, T the time that a wave takes along the rod, t0 the duration of the
blow.</source>
        <translation>Schreibt nach DIR die Daten der Abbildungen 3 bis 8 der Veröffentlichung, auf der das Modell
beruht, als CSV und als Bilder. discrepancies.csv vergleicht jede dort gedruckte Zahl mit der
exakten. index.html zeigt alles. Die Referenzkurven gibt es zweimal, weil die Veröffentlichung die
Steifigkeit auf zwei Arten skaliert: mit k0 = Z/(2T) in den Diagrammen und mit k0 = Z/t0 im Text.
Z ist die Impedanz der Stange, T die Laufzeit einer Welle durch die Stange, t0 die Dauer des
Schlags.</translation>
    </message>
    <message>
        <source>Simulates consecutive blows. The residual waves and the motion of the machine on its damper carry
over from one blow to the next; each blow meets new rock. Prints penetration and penetration rate
with their errors, and the share of blows that start with the bit on the rock. Also prints whether
the motion repeats, and where the energy goes. FILE needs drill.blow_frequency and drill.thrust,
the feed force. Penetrations are upper limits, because all rock under the bit is assumed to break.
--scan compares values of a parameter. Each value is simulated twice: starting at rest and
starting with a bouncing machine. A second row is printed only if the two differ. -o DIR writes scenario.yaml, summary.json and blows.csv into
DIR, with --histories also histories.csv, with --plots also drilling.png.</source>
        <translation>Simuliert aufeinanderfolgende Schläge. Die Restwellen und die Bewegung der Maschine auf ihrem Dämpfer gehen von
einem Schlag in den nächsten über; jeder Schlag trifft neues Gestein. Gibt Eindringung und Bohrfortschritt mit
ihren Fehlern aus und den Anteil der Schläge, die mit der Bohrkrone am Gestein beginnen. Gibt auch aus, ob sich
die Bewegung wiederholt und wohin die Energie geht. FILE braucht drill.blow_frequency und drill.thrust, den
Andruck. Eindringungen sind obere Grenzen, weil angenommen wird, dass alles Gestein unter der Krone bricht.
--scan vergleicht Werte eines Parameters. Jeder Wert wird zweimal simuliert: mit einem Anfang aus
der Ruhe und mit springender Maschine. Eine zweite Zeile wird nur ausgegeben, wenn sich beide unterscheiden. -o DIR schreibt scenario.yaml, summary.json und blows.csv
nach DIR, mit --histories auch histories.csv, mit --plots auch drilling.png.</translation>
    </message>
    <message>
        <source>vary this parameter; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C; to compare presets: rock=all, or rock=, hammer=, rod= or bit= with their names</source>
        <translation>diesen Parameter variieren; VALUES ist START:STOP:COUNT, START:STOP:COUNT:log (gleiche Verhältnisse) oder A,B,C; Voreinstellungen vergleichen: rock=all, oder rock=, hammer=, rod= oder bit= mit ihren Namen</translation>
    </message>
    <message>
        <source>Estimates from single blows whether the installed feed force is sufficient. Prints four cases: this
blow, 95 % of all gaps between bit and rock, rigid rock (e = 1), and the worst gap. The worst gap
requires the highest feed force on elastic rock (gamma = 1). In the columns of the table (theory
§10), f is the blow frequency, I0 the impulse of a blow and e the coefficient of restitution:
  required        f I0 (1 + e), the feed force that balances the blows
  return in time  f I0 (1 + 2e), the feed force that brings an undamped rigid rod back to the rock
                  before the next blow
  margin          effective over required feed force, less 1
  enough up to    highest blow frequency at which the effective feed force still
                  reaches the required one
If the feed force is below f I0, the blows push the machine back. The effective feed force is the
installed one; if drill.inclination is given, the weight of rod and drill.machine_mass along the
hole is added. For consecutive blows, use `drillwave drill`; its --scan
drill.thrust=START:STOP:COUNT shows the effect of more feed force. FILE must have physical units
and drill.blow_frequency; margins need drill.thrust, the installed feed force. For drill strings,
I0 is the impulse that the hammer transfers, and only this blow and rigid rock are printed.</source>
        <translation>Schätzt aus einzelnen Schlägen, ob der angegebene Andruck ausreicht. Gibt vier Fälle aus: diesen
Schlag, 95&#xa0;% aller Spalte zwischen Bohrkrone und Gestein, starres Gestein (e = 1) und den ungünstigsten
Spalt. Dieser erfordert auf elastischem Gestein (gamma = 1) den höchsten Andruck. In den Spalten der
Tabelle (theory §10) ist f die Schlagfrequenz, I0 der Kraftstoß eines Schlags und e die Stoßzahl:
  erforderlich   f I0 (1 + e), der Andruck, der die Schläge ausgleicht
  Rückkehr       f I0 (1 + 2e), der Andruck, der eine ungedämpfte starre Stange vor dem nächsten
                 Schlag zum Gestein zurückbringt
  Reserve        wirksamer durch erforderlichen Andruck, weniger 1
  reicht bis     höchste Schlagfrequenz, bei der der wirksame Andruck den
                 erforderlichen noch erreicht
Liegt der Andruck unter f I0, drücken die Schläge die Maschine zurück. Der wirksame Andruck ist der
angegebene; ist drill.inclination angegeben, kommt das Gewicht von Stange und drill.machine_mass längs des
Lochs hinzu. Für aufeinanderfolgende Schläge `drillwave drill` verwenden; dessen --scan
drill.thrust=START:STOP:COUNT zeigt die Wirkung von mehr Andruck. FILE braucht physikalische Einheiten und
drill.blow_frequency; Reserven brauchen drill.thrust, den angegebenen Andruck. Bei Bohrsträngen ist I0 der
Kraftstoß, den der Hammer überträgt, und es werden nur dieser Schlag und starres Gestein ausgegeben.</translation>
    </message>
    <message>
        <source>compare each design at its own blow energy, even if FILE sets keep_energy (the same energy for all designs)</source>
        <translation>jede Auslegung mit ihrer eigenen Schlagenergie vergleichen, auch wenn FILE keep_energy setzt (gleiche Energie für alle Auslegungen)</translation>
    </message>
    <message>
        <source>effective feed force divided by the mean force of the blows (phi); below 1 the blows push the machine back</source>
        <translation>wirksamer Andruck durch die mittlere Kraft der Schläge (phi); unter 1 schieben die Schläge die Maschine zurück</translation>
    </message>
</context>
</TS>
