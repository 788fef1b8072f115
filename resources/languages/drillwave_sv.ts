<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sv">
<context>
    <name>GaugeRows</name>
    <message>
        <source>gauge is on</source>
        <translation>givaren sitter på</translation>
    </message>
    <message>
        <source>Bar used to convert strain to force</source>
        <translation>Vars E-modul och area gör en kraft av en töjning</translation>
    </message>
    <message>
        <source>the rod or string</source>
        <translation>stången eller strängen</translation>
    </message>
    <message>
        <source>another bar</source>
        <translation>en annan stång</translation>
    </message>
    <message>
        <source>E of the bar</source>
        <translation>stångens E</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-modul</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diameter</translation>
    </message>
    <message>
        <source>Diameter of the solid bar at the gauge</source>
        <translation>På den massiva stången där givaren sitter</translation>
    </message>
    <message>
        <source>gauge factor k</source>
        <translation>givarfaktor k</translation>
    </message>
    <message>
        <source>Relative resistance over strain</source>
        <translation>Relativ resistansändring per töjning</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densitet</translation>
    </message>
    <message>
        <source>The impedance of the bar is its area times √(E ρ)</source>
        <translation>Stångens: impedansen är arean gånger √(E ρ)</translation>
    </message>
    <message>
        <source>bridge factor</source>
        <translation>bryggfaktor</translation>
    </message>
    <message>
        <source>Active gauges: 1 quarter, 2 half, 4 full bridge; 2.6 full bridge with two gauges across a bar of Poisson&apos;s ratio 0.3</source>
        <translation>Aktiva töjningsgivare: 1 kvarts-, 2 halv-, 4 helbrygga; 2,6 helbrygga med två givare tvärs en stång med Poissons tal 0,3</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>förstärkning</translation>
    </message>
    <message>
        <source>Volts out of the amplifier over volts in</source>
        <translation>Förstärkarens: volt ut genom volt in</translation>
    </message>
    <message>
        <source>excitation in V</source>
        <translation>matning i V</translation>
    </message>
    <message>
        <source>Supply of the bridge</source>
        <translation>Bryggans matningsspänning</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>inte angiven</translation>
    </message>
    <message>
        <source>force per volt</source>
        <translation>kraft per volt</translation>
    </message>
    <message>
        <source>Result of a calibration; it overrides the bridge</source>
        <translation>Från en kalibrering; den går före bryggan</translation>
    </message>
    <message>
        <source>Volts are no forces: type the force per volt of a calibration, or the excitation of the bridge.</source>
        <translation>Volt är inte krafter: ange kraften per volt från en kalibrering eller bryggans matning.</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Markera allt</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>Steg &amp;upp</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>Steg &amp;ner</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Lösgör</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Undocks and re-attaches the dock widget</source>
        <translation>Lösgör panelen från fönstret och sätter tillbaka den</translation>
    </message>
    <message>
        <source>Closes the dock widget</source>
        <translation>Stänger panelen</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Back</source>
        <translation>Tillbaka</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Framåt</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Överordnad mapp</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Gå tillbaka</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Gå framåt</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Gå till överordnad mapp</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Skapa ny mapp</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Skapa en ny mapp</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Detaljer</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Visa som lista</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Visa med detaljer</translation>
    </message>
    <message>
        <source>Look in:</source>
        <translation>Sök i:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Fil&amp;namn:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Filer av typen:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Mapp:</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Mappar</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Filer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öppna</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Spara som</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Välj</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Sök mapp</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Senaste platser</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Sidofält</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Lista över platser och bokmärken</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Visa </translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>Visa &amp;dolda filer</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Ny mapp</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Ny mapp</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Byt namn</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Ta bort</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>Mappen kunde inte tas bort.</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 finns redan.
Ersätta den?</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Filen hittades inte.
Är filnamnet rätt?</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Mappen hittades inte.
Är dess namn rätt?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>”%1” är skrivskyddad.
Ta bort ändå?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>Ska ”%1” verkligen tas bort?</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Storlek</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Sort</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Ändrad</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Dator</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Min dator</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Klipp &amp;ut</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiera</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Klistra &amp;in</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Markera allt</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>Visa detaljer...</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Dölj detaljer...</translation>
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
        <translation>&amp;Nej</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hjälp</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Verkställ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Försök igen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorera</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Kasta</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Spara alla</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Ja till &amp;alla</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;ej till alla</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Återställ förval</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Rulla hit</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Början</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Slutet</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Vänsterkanten</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Högerkanten</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Sida uppåt</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Sida nedåt</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Sida åt vänster</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Sida åt höger</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Rulla uppåt</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Rulla nedåt</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Rulla åt vänster</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Rulla åt höger</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Skift</translation>
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
        <translation>Delete</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Insert</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Mellanslag</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabb</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Retur</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Vänster</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Höger</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Upp</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ned</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Rulla åt vänster</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Rulla åt höger</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo</source>
        <translation>Ångra</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Gör om</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Ångra: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Gör om: %1</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Klipp &amp;ut</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiera</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>Kopiera &amp;länken</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Klistra &amp;in</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Markera allt</translation>
    </message>
</context>
<context>
    <name>UnitKind</name>
    <message>
        <source>length of the rod</source>
        <translation>stångens längd</translation>
    </message>
    <message>
        <source>penetration, gap, diameter</source>
        <translation>inträngning, spalt, diameter</translation>
    </message>
    <message>
        <source>force, thrust</source>
        <translation>kraft, matningskraft</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>impuls</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energi</translation>
    </message>
    <message>
        <source>power</source>
        <translation>effekt</translation>
    </message>
    <message>
        <source>stress</source>
        <translation>spänning</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>styvhet</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tid</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>hastighet</translation>
    </message>
    <message>
        <source>penetration rate</source>
        <translation>borrsjunkning</translation>
    </message>
    <message>
        <source>blow frequency</source>
        <translation>slagfrekvens</translation>
    </message>
    <message>
        <source>area</source>
        <translation>area</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-modul</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densitet</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>massa</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>vinkel</translation>
    </message>
    <message>
        <source>attenuation</source>
        <translation>avklingning</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>dämpning</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Angle of the hole below the horizontal. With it, the weight of machine and rod along the hole adds to the feed force.</source>
        <translation>Hålets vinkel under horisontalplanet. Med den läggs tyngden av maskin och stång längs hålet till matningskraften.</translation>
    </message>
    <message>
        <source>Blows per second of the rock drill</source>
        <translation>Borrmaskinens slag per sekund</translation>
    </message>
    <message>
        <source>Number of consecutive blows (default: 1000)</source>
        <translation>Antal slag i följd (standard: 1000)</translation>
    </message>
    <message>
        <source>Cross-section of a cone at the end towards the rock; `area` is that of the rear end</source>
        <translation>Tvärsnittsarea vid änden mot berget för en kon, vars `area` är bakändens</translation>
    </message>
    <message>
        <source>Cross-section of the rod, instead of diameter and bore</source>
        <translation>Stångens tvärsnittsarea, i stället för dess diameter och spolhål</translation>
    </message>
    <message>
        <source>Cross-section, instead of diameter and bore</source>
        <translation>Tvärsnittsarea, i stället för diameter och spolhål</translation>
    </message>
    <message>
        <source>Damping between machine and rear end of the string, for many blows; needs a machine mass</source>
        <translation>Dämpning mellan maskin och strängens bakände, för många slag; kräver en maskinmassa</translation>
    </message>
    <message>
        <source>Decay of the amplitude of a wave per length</source>
        <translation>Avtagande av en vågs amplitud per längd</translation>
    </message>
    <message>
        <source>Density of all sections without one of their own</source>
        <translation>Densitet hos varje sektion som inte har en egen</translation>
    </message>
    <message>
        <source>Density of the elastic hammer (default: that of the rod)</source>
        <translation>Den elastiska hammarens densitet, stångens om inte angiven</translation>
    </message>
    <message>
        <source>Density of the rod</source>
        <translation>Stångens densitet</translation>
    </message>
    <message>
        <source>Density (default: that of the material)</source>
        <translation>Densitet, materialets om inte angiven</translation>
    </message>
    <message>
        <source>Diameter of the elastic hammer</source>
        <translation>Den elastiska hammarens diameter</translation>
    </message>
    <message>
        <source>Diameter of the flushing hole, less than the outer diameter</source>
        <translation>Spolhålets diameter, mindre än ytterdiametern</translation>
    </message>
    <message>
        <source>Duration of the hammer force; time constant of an exponential one</source>
        <translation>Hammarkraftens varaktighet; tidskonstanten för en exponentiell</translation>
    </message>
    <message>
        <source>Elasticity parameter: loading over unloading stiffness; 1 is elastic</source>
        <translation>Elasticitetsparameter: styvhet vid belastning genom styvhet vid avlastning; 1 är elastiskt</translation>
    </message>
    <message>
        <source>Exponent of a power law F = k U (U/U1)^(p - 1) of loading; 1 is a straight line</source>
        <translation>Exponent i en potenslag F = k U (U/U1)^(p - 1) för belastning; 1 är en rät linje</translation>
    </message>
    <message>
        <source>Feed force that the drill rig applies</source>
        <translation>Matningskraft som borriggen utövar</translation>
    </message>
    <message>
        <source>Force at which the slope of the loading curve changes</source>
        <translation>Kraft från vilken belastningskurvan har en annan lutning</translation>
    </message>
    <message>
        <source>Gap between bit and rock when the hammer strikes</source>
        <translation>Spalt mellan borrkrona och berg när hammaren slår</translation>
    </message>
    <message>
        <source>Gap over 2 I0/Z; in a scenario with units it changes the gap</source>
        <translation>Spalt genom 2 I0/Z; i ett scenario med enheter ändrar talet spalten</translation>
    </message>
    <message>
        <source>Number of times the sections of the first repeat follow one another</source>
        <translation>Hur ofta sektionerna i strängens första upprepning följer på varandra</translation>
    </message>
    <message>
        <source>Impedance of the elastic hammer over that of the rod</source>
        <translation>Den elastiska hammarens impedans genom stångens</translation>
    </message>
    <message>
        <source>Impulse of the hammer force</source>
        <translation>Hammarkraftens impuls</translation>
    </message>
    <message>
        <source>Impulse of the impact force on the rock, (1 + e) times that of the hammer</source>
        <translation>Stötkraftens impuls på berget, (1 + e) gånger hammarens</translation>
    </message>
    <message>
        <source>Largest compressive stress of the residual waves after the blow; for drill strings, over one round trip. The model does not damp them, a real rod does.</source>
        <translation>Största tryckspänning i restvågorna efter slaget; för borrsträngar under ett varv fram och åter. Modellen dämpar dem inte, det gör en verklig stång.</translation>
    </message>
    <message>
        <source>Largest compressive stress of uniform sections during the blow, until one transit time after the last separation of bit and rock; threads and shoulders raise it locally</source>
        <translation>Största tryckspänning i likformiga sektioner medan slaget varar, till sista separationen av borrkrona och berg plus en gångtid; gängor och ansatser höjer den lokalt</translation>
    </message>
    <message>
        <source>Largest impact force</source>
        <translation>Största stötkraft</translation>
    </message>
    <message>
        <source>Largest penetration of the bit during the blow</source>
        <translation>Borrkronans största inträngning under slaget</translation>
    </message>
    <message>
        <source>Largest tensile stress of the residual waves after the blow; for drill strings, over one round trip. The model does not damp them, a real rod does.</source>
        <translation>Största dragspänning i restvågorna efter slaget; för borrsträngar under ett varv fram och åter. Modellen dämpar dem inte, det gör en verklig stång.</translation>
    </message>
    <message>
        <source>Largest tensile stress of uniform sections during the blow, until one transit time after the last separation of bit and rock; threads and shoulders raise it locally</source>
        <translation>Största dragspänning i likformiga sektioner medan slaget varar, till sista separationen av borrkrona och berg plus en gångtid; gängor och ansatser höjer den lokalt</translation>
    </message>
    <message>
        <source>Length of the elastic hammer; one step of the blow lasts one round trip in it</source>
        <translation>Den elastiska hammarens längd; dess varv fram och åter är ett steg i slaget</translation>
    </message>
    <message>
        <source>Length of the rod or rod string, from the hammer to the bit</source>
        <translation>Stångens eller strängens längd, från hammaren till borrkronan</translation>
    </message>
    <message>
        <source>Length of the section</source>
        <translation>Sektionens längd</translation>
    </message>
    <message>
        <source>Lumped mass at the end towards the rock; for the last section of a string, the mass of the bit</source>
        <translation>Massa samlad vid änden mot berget; för en strängs sista sektion en massa hos borrkronan</translation>
    </message>
    <message>
        <source>Mass that the feed moves besides the rod: its weight counts with an inclination, its inertia when consecutive blows are solved</source>
        <translation>Massa som matningen flyttar utöver stången: dess tyngd räknas vid en lutning, dess tröghet när på varandra följande slag beräknas</translation>
    </message>
    <message>
        <source>Mean hammer force, impulse over duration</source>
        <translation>Hammarens medelkraft, impuls genom varaktighet</translation>
    </message>
    <message>
        <source>Standard deviation of the time between two blows, as a share of its mean; cut off at three deviations</source>
        <translation>Standardavvikelse hos den (normalfördelade) tiden mellan två slag, som andel av dess medelvärde; avskuren vid tre standardavvikelser</translation>
    </message>
    <message>
        <source>Number of peaks of the impact force above 1 % of the largest</source>
        <translation>Antal toppar i stötkraften över 1 % av den största</translation>
    </message>
    <message>
        <source>Start of the random numbers for the scatter of the intervals</source>
        <translation>Startvärde för slumptalen till spridningen i intervallen</translation>
    </message>
    <message>
        <source>Outer diameter of a cone at the end towards the rock; `diameter` is that of the rear end, and the bore is constant</source>
        <translation>Ytterdiameter vid änden mot berget för en kon, vars `diameter` är bakändens; spolhålet har konstant diameter</translation>
    </message>
    <message>
        <source>Outer diameter of the rod</source>
        <translation>Stångens ytterdiameter</translation>
    </message>
    <message>
        <source>Outer diameter of the section</source>
        <translation>Sektionens ytterdiameter</translation>
    </message>
    <message>
        <source>Residual penetration after the blow</source>
        <translation>Inträngning som blir kvar efter slaget</translation>
    </message>
    <message>
        <source>Residual penetration times blow frequency. It is an upper limit for blows from rest: indexing, flushing and lost contact reduce it. Residual waves may add to it (page Drilling).</source>
        <translation>Kvarstående inträngning gånger slagfrekvens. Det är en övre gräns för slag från vila: indexering, spolning och förlorad kontakt minskar den. Restvågor kan öka den (sidan Borrning).</translation>
    </message>
    <message>
        <source>Share of the hammer energy that remains in the hammer as waves</source>
        <translation>Andel av hammarens energi som löper fram och åter i den</translation>
    </message>
    <message>
        <source>Share of the hammer energy that remains as motion of the hammer after the blow</source>
        <translation>Andel av hammarens energi som den rör sig med efter slaget</translation>
    </message>
    <message>
        <source>Share of the hammer energy stored in the stiffness of the faces while they touch</source>
        <translation>Andel av hammarens energi i slagytornas styvhet, där de ännu rör vid varandra</translation>
    </message>
    <message>
        <source>Share of the hammer energy lost in joints</source>
        <translation>Andel av hammarens energi som skarvarna tar</translation>
    </message>
    <message>
        <source>Share of the hammer energy that waves lose along the sections</source>
        <translation>Andel av hammarens energi som vågor förlorar på vägen</translation>
    </message>
    <message>
        <source>Share of the energy that moves the rod or the string back as a whole</source>
        <translation>Andel av energin som för stången eller strängen tillbaka som helhet</translation>
    </message>
    <message>
        <source>Share of the energy that remains in the rod or string as waves</source>
        <translation>Andel av energin som löper fram och åter i stången eller strängen</translation>
    </message>
    <message>
        <source>Share of the energy that remains in the rock: the efficiency</source>
        <translation>Andel av energin som stannar i berget: verkningsgraden</translation>
    </message>
    <message>
        <source>Share of the residual waves lost per round trip, for many blows</source>
        <translation>Andel av restvågorna som går förlorad per varv fram och åter, för många slag</translation>
    </message>
    <message>
        <source>Slope of the loading curve above that corner, as a multiple of the stiffness</source>
        <translation>Belastningskurvans lutning från detta hörn, som en multipel av styvheten</translation>
    </message>
    <message>
        <source>Stiffness of the damper&apos;s spring between machine and rear end of the string, for many blows; needs a machine mass</source>
        <translation>Styvhet hos dämparens fjäder mellan maskin och strängens bakände, för många slag; kräver en maskinmassa</translation>
    </message>
    <message>
        <source>Stiffness group k t0/Z; in a scenario with units it changes the stiffness</source>
        <translation>Styvhetstal k t0/Z; i ett scenario med enheter ändrar talet styvheten</translation>
    </message>
    <message>
        <source>Stiffness of bit and rock in primary loading</source>
        <translation>Styvhet hos borrkrona och berg vid första belastning</translation>
    </message>
    <message>
        <source>Stiffness of the contact of hammer and string (default: rigid)</source>
        <translation>Styvhet i kontakten mellan hammare och sträng; stel om inte angiven</translation>
    </message>
    <message>
        <source>Stress up to which the rod stays elastic; a larger one gives a warning</source>
        <translation>Spänning upp till vilken stången är elastisk; ett slag däröver ger en varning</translation>
    </message>
    <message>
        <source>Stress up to which the section stays elastic; a larger one gives a warning</source>
        <translation>Spänning upp till vilken sektionen är elastisk; ett slag däröver ger en varning</translation>
    </message>
    <message>
        <source>Summed over all contacts</source>
        <translation>Summerad över alla kontakter</translation>
    </message>
    <message>
        <source>Tensile stress that the rod endures blow after blow; a larger one gives a warning</source>
        <translation>Dragspänning som stången tål slag efter slag; mer ger en varning</translation>
    </message>
    <message>
        <source>Tensile stress that the section endures blow after blow; a larger one gives a warning</source>
        <translation>Dragspänning som sektionen tål slag efter slag; mer ger en varning</translation>
    </message>
    <message>
        <source>Transient blows at the start, excluded from statistics (default: a fifth of all)</source>
        <translation>Slag för insvängning i början, som inte ingår i statistiken (standard: en femtedel av alla)</translation>
    </message>
    <message>
        <source>Time of the first separation of hammer and string</source>
        <translation>Tid då hammare och sträng först skils åt</translation>
    </message>
    <message>
        <source>Time in which a trapezoid falls, as a fraction of the duration</source>
        <translation>Tid på vilken en trapets faller, som andel av varaktigheten</translation>
    </message>
    <message>
        <source>Time in which a trapezoid rises, as a fraction of the duration</source>
        <translation>Tid på vilken en trapets stiger, som andel av varaktigheten</translation>
    </message>
    <message>
        <source>Time of the first contact</source>
        <translation>Tid för den första kontakten</translation>
    </message>
    <message>
        <source>Time of the last separation</source>
        <translation>Tid för den sista separationen</translation>
    </message>
    <message>
        <source>Time until when the blow on a drill string is followed (default: to its end)</source>
        <translation>Tid till vilken en borrsträngs slag följs; till slagets slut om inte angiven</translation>
    </message>
    <message>
        <source>Transit time of the rod over t0; in a scenario with units it changes the rod length</source>
        <translation>Stångens gångtid genom t0; i ett scenario med enheter ändrar talet stångens längd</translation>
    </message>
    <message>
        <source>Velocity of the elastic hammer when it hits the rod</source>
        <translation>Den elastiska hammarens hastighet när den träffar stången</translation>
    </message>
    <message>
        <source>Velocity of the hammer after the blow, away from the rock</source>
        <translation>Hammarens hastighet efter slaget, bort från berget</translation>
    </message>
    <message>
        <source>Velocity of the hammer when it strikes the string</source>
        <translation>Hammarens hastighet när den träffar strängen</translation>
    </message>
    <message>
        <source>Difference of all shares together from 1</source>
        <translation>Avvikelse från 1 för summan av alla andelar</translation>
    </message>
    <message>
        <source>Work of the hammer on the rod</source>
        <translation>Hammarens arbete på stången</translation>
    </message>
    <message>
        <source>Work of the hammer on the rod times the blow frequency</source>
        <translation>Hammarens arbete på stången gånger slagfrekvensen</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-modul</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of all sections without one of their own</source>
        <translation>E-modul hos varje sektion som inte har en egen</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the elastic hammer (default: that of the rod)</source>
        <translation>Den elastiska hammarens E-modul, stångens om inte angiven</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the rod; sets its wave speed with the density</source>
        <translation>Stångens E-modul; ger med densiteten dess våghastighet</translation>
    </message>
    <message>
        <source>Young&apos;s modulus (default: that of the material)</source>
        <translation>E-modul, materialets om inte angiven</translation>
    </message>
    <message>
        <source>area</source>
        <translation>area</translation>
    </message>
    <message>
        <source>attenuation</source>
        <translation>avklingning</translation>
    </message>
    <message>
        <source>balance error</source>
        <translation>balansfel</translation>
    </message>
    <message>
        <source>between the faces</source>
        <translation>mellan slagytorna</translation>
    </message>
    <message>
        <source>blow frequency</source>
        <translation>slagfrekvens</translation>
    </message>
    <message>
        <source>blow frequency times impulse, N, if the scenario gives a frequency</source>
        <translation>slagfrekvens gånger impuls, N, när scenariot har en frekvens</translation>
    </message>
    <message>
        <source>blows</source>
        <translation>slag</translation>
    </message>
    <message>
        <source>bore</source>
        <translation>spolhål</translation>
    </message>
    <message>
        <source>bound on the numerical error of cor</source>
        <translation>gräns för det numeriska felet i e</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cell</translation>
    </message>
    <message>
        <source>cells x nodes</source>
        <translation>celler x noder</translation>
    </message>
    <message>
        <source>coefficient of restitution e = -pf/p0</source>
        <translation>studstal e = -pf/p0</translation>
    </message>
    <message>
        <source>compression, after</source>
        <translation>tryck i restvågor</translation>
    </message>
    <message>
        <source>compression, blow</source>
        <translation>tryck, slag</translation>
    </message>
    <message>
        <source>cor</source>
        <translation>studstal e</translation>
    </message>
    <message>
        <source>cor error</source>
        <translation>fel i studstalet</translation>
    </message>
    <message>
        <source>dashpot</source>
        <translation>dämpare</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densitet</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diameter</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>varaktighet</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>verkningsgrad</translation>
    </message>
    <message>
        <source>efficiency error</source>
        <translation>fel i verkningsgraden</translation>
    </message>
    <message>
        <source>efficiency recovered</source>
        <translation>med återvinning</translation>
    </message>
    <message>
        <source>efficiency plus the energy that returns with the hammer, for drill strings</source>
        <translation>verkningsgrad och det hammaren tar tillbaka, för en borrsträng</translation>
    </message>
    <message>
        <source>elasticity</source>
        <translation>elasticitet</translation>
    </message>
    <message>
        <source>end area</source>
        <translation>slutarea</translation>
    </message>
    <message>
        <source>end diameter</source>
        <translation>slutdiameter</translation>
    </message>
    <message>
        <source>end time</source>
        <translation>sluttid</translation>
    </message>
    <message>
        <source>energy stored in the stiffness of the faces, fraction of the hammer energy</source>
        <translation>energi i slagytornas styvhet, andel av hammarens</translation>
    </message>
    <message>
        <source>energy remaining in the rock, fraction of the hammer work</source>
        <translation>energi kvar i berget, andel av hammarens arbete</translation>
    </message>
    <message>
        <source>energy remaining in waves of the hammer, fraction of the hammer energy</source>
        <translation>energi kvar i hammarens vågor, andel av dess egen</translation>
    </message>
    <message>
        <source>energy remaining in waves, fraction of the hammer work</source>
        <translation>energi kvar i vågor, andel av hammarens arbete</translation>
    </message>
    <message>
        <source>energy lost in joints, fraction of the hammer energy</source>
        <translation>energi förlorad i skarvar, andel av hammarens</translation>
    </message>
    <message>
        <source>energy lost along the sections, fraction of the hammer energy</source>
        <translation>energi förlorad på vägen genom sektioner, andel av hammarens</translation>
    </message>
    <message>
        <source>energy of the hammer&apos;s motion after the blow, fraction of that before it</source>
        <translation>energi hos hammaren som helhet på väg tillbaka, andel av den vid anslaget</translation>
    </message>
    <message>
        <source>energy of the rebound, fraction of the hammer work</source>
        <translation>studsens energi, andel av hammarens arbete</translation>
    </message>
    <message>
        <source>energy of the string after the blow, fraction of the hammer energy</source>
        <translation>strängens energi efter slaget, andel av hammarens</translation>
    </message>
    <message>
        <source>error</source>
        <translation>fel</translation>
    </message>
    <message>
        <source>error of e</source>
        <translation>fel i e</translation>
    </message>
    <message>
        <source>error of the energy balance, fraction of the hammer work</source>
        <translation>fel i energibalansen, andel av hammarens arbete</translation>
    </message>
    <message>
        <source>error of the momentum balance, fraction of I0</source>
        <translation>fel i rörelsemängdens balans, andel av I0</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>uppskattning</translation>
    </message>
    <message>
        <source>events</source>
        <translation>händelser</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>exponent</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponentiell</translation>
    </message>
    <message>
        <source>contact stiffness</source>
        <translation>kontaktstyvhet</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>fall</translation>
    </message>
    <message>
        <source>fatigue strength</source>
        <translation>utmattningsgräns</translation>
    </message>
    <message>
        <source>first contact</source>
        <translation>första kontakt</translation>
    </message>
    <message>
        <source>force</source>
        <translation>kraft</translation>
    </message>
    <message>
        <source>force peaks</source>
        <translation>krafttoppar</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>spalt</translation>
    </message>
    <message>
        <source>half sine</source>
        <translation>halvsinus</translation>
    </message>
    <message>
        <source>hammer Young&apos;s modulus</source>
        <translation>hammarens E</translation>
    </message>
    <message>
        <source>hammer density</source>
        <translation>hammardensitet</translation>
    </message>
    <message>
        <source>hammer diameter</source>
        <translation>hammardiameter</translation>
    </message>
    <message>
        <source>hammer separates</source>
        <translation>hammaren släpper</translation>
    </message>
    <message>
        <source>hammer length</source>
        <translation>hammarlängd</translation>
    </message>
    <message>
        <source>hammer rebound</source>
        <translation>hammarstuds</translation>
    </message>
    <message>
        <source>hammer velocity</source>
        <translation>hammarhastighet</translation>
    </message>
    <message>
        <source>hammer work W</source>
        <translation>hammararbete W</translation>
    </message>
    <message>
        <source>hammer work times blow frequency, W, if the scenario gives a frequency</source>
        <translation>hammarens arbete gånger slagfrekvensen, W, när scenariot har en frekvens</translation>
    </message>
    <message>
        <source>impedance ratio</source>
        <translation>impedansförhållande</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>impuls</translation>
    </message>
    <message>
        <source>impulse of the impact force, 1 + e</source>
        <translation>stötkraftens impuls, 1 + e</translation>
    </message>
    <message>
        <source>impulse on the rock</source>
        <translation>impuls på berget</translation>
    </message>
    <message>
        <source>inclination</source>
        <translation>lutning</translation>
    </message>
    <message>
        <source>installed feed force</source>
        <translation>matningskraft</translation>
    </message>
    <message>
        <source>into the hammer</source>
        <translation>till hammaren</translation>
    </message>
    <message>
        <source>into the rebound</source>
        <translation>till studsen</translation>
    </message>
    <message>
        <source>into the rock</source>
        <translation>till berget</translation>
    </message>
    <message>
        <source>largest compression in the rod during the blow</source>
        <translation>största tryck i stången medan slaget varar</translation>
    </message>
    <message>
        <source>largest compression of the residual waves, undamped</source>
        <translation>största tryck i restvågorna, odämpat</translation>
    </message>
    <message>
        <source>largest impact force</source>
        <translation>största stötkraft</translation>
    </message>
    <message>
        <source>largest penetration</source>
        <translation>största inträngning</translation>
    </message>
    <message>
        <source>largest penetration of the bit</source>
        <translation>borrkronans största inträngning</translation>
    </message>
    <message>
        <source>largest tension in the rod during the blow</source>
        <translation>största drag i stången medan slaget varar</translation>
    </message>
    <message>
        <source>largest tension of the residual waves, undamped</source>
        <translation>största drag i restvågorna, odämpat</translation>
    </message>
    <message>
        <source>last separation</source>
        <translation>sista separation</translation>
    </message>
    <message>
        <source>remaining in waves</source>
        <translation>kvar i vågor</translation>
    </message>
    <message>
        <source>length</source>
        <translation>längd</translation>
    </message>
    <message>
        <source>loading work</source>
        <translation>belastningsarbete</translation>
    </message>
    <message>
        <source>loss</source>
        <translation>förlust</translation>
    </message>
    <message>
        <source>lost in joints</source>
        <translation>förlorat i skarvar</translation>
    </message>
    <message>
        <source>lost in sections</source>
        <translation>förlorat i sektioner</translation>
    </message>
    <message>
        <source>machine mass</source>
        <translation>maskinmassa</translation>
    </message>
    <message>
        <source>machine pushed back</source>
        <translation>maskinen trycks tillbaka</translation>
    </message>
    <message>
        <source>attached mass</source>
        <translation>massa efter</translation>
    </message>
    <message>
        <source>mean force</source>
        <translation>medelkraft</translation>
    </message>
    <message>
        <source>median</source>
        <translation>median</translation>
    </message>
    <message>
        <source>mid-step</source>
        <translation>mitt i steget</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>minimum</translation>
    </message>
    <message>
        <source>momentum of the string after the blow, towards the rock, over that of the hammer</source>
        <translation>strängens rörelsemängd efter slaget, mot berget, genom hammarens</translation>
    </message>
    <message>
        <source>momentum residual</source>
        <translation>fel i rörelsemängdens balans</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordning</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>toppkraft</translation>
    </message>
    <message>
        <source>peaks of the impact force above 1 % of the largest</source>
        <translation>toppar i stötkraften över 1 % av den största</translation>
    </message>
    <message>
        <source>penetration</source>
        <translation>inträngning</translation>
    </message>
    <message>
        <source>penetration per blow</source>
        <translation>inträngning/slag</translation>
    </message>
    <message>
        <source>penetration rate</source>
        <translation>borrsjunkning</translation>
    </message>
    <message>
        <source>residual penetration after the blow</source>
        <translation>inträngning som blir kvar efter slaget</translation>
    </message>
    <message>
        <source>residual penetration times blow frequency, m/s, if the scenario gives a frequency: an upper limit</source>
        <translation>kvarstående inträngning gånger slagfrekvensen, m/s, när scenariot har en frekvens: en övre gräns</translation>
    </message>
    <message>
        <source>percussion power</source>
        <translation>slageffekt</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>bitar</translation>
    </message>
    <message>
        <source>piston</source>
        <translation>kolv</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rektangulär</translation>
    </message>
    <message>
        <source>reference penetration</source>
        <translation>referensinträngning</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>upprepningar</translation>
    </message>
    <message>
        <source>rigid body</source>
        <translation>stel kropp</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>stigning</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>körningar</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>spridning</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>startvärde</translation>
    </message>
    <message>
        <source>transient blows</source>
        <translation>insvängning</translation>
    </message>
    <message>
        <source>share of the hammer work that remains in the rock</source>
        <translation>andel av hammarens arbete som stannar i berget</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>lutning</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>fart</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>fjäder</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angivet</translation>
    </message>
    <message>
        <source>error bound of the efficiency, for drill strings</source>
        <translation>angivet fel i en borrsträngs verkningsgrad</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>styvhet</translation>
    </message>
    <message>
        <source>string energy</source>
        <translation>strängens energi</translation>
    </message>
    <message>
        <source>string momentum</source>
        <translation>strängens rörelsemängd</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabell</translation>
    </message>
    <message>
        <source>tension, after</source>
        <translation>drag i restvågor</translation>
    </message>
    <message>
        <source>tension, blow</source>
        <translation>drag, slag</translation>
    </message>
    <message>
        <source>thrust</source>
        <translation>matningskraft</translation>
    </message>
    <message>
        <source>thrust margin</source>
        <translation>matningskraftens marginal</translation>
    </message>
    <message>
        <source>time of the first separation of hammer and string</source>
        <translation>tid då hammare och sträng först skils åt</translation>
    </message>
    <message>
        <source>time in contact</source>
        <translation>tid i kontakt</translation>
    </message>
    <message>
        <source>time in contact, summed over contacts</source>
        <translation>tid i kontakt, summerad över kontakterna</translation>
    </message>
    <message>
        <source>time of the first contact</source>
        <translation>tid för den första kontakten</translation>
    </message>
    <message>
        <source>time of the last separation</source>
        <translation>tid för den sista separationen</translation>
    </message>
    <message>
        <source>end of the computed time of the blow</source>
        <translation>tid till vilken slaget följdes</translation>
    </message>
    <message>
        <source>transit time</source>
        <translation>gångtid</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>trapets</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>triangulär</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>hastighet</translation>
    </message>
    <message>
        <source>velocity of the hammer after the blow, away from the rock, over that of impact</source>
        <translation>hammarens hastighet efter slaget, bort från berget, genom den vid anslaget</translation>
    </message>
    <message>
        <source>wave loss</source>
        <translation>vågförlust</translation>
    </message>
    <message>
        <source>waves in the hammer</source>
        <translation>vågor i hammaren</translation>
    </message>
    <message>
        <source>work of the hammer over m v0^2/2</source>
        <translation>hammarens arbete genom m v0^2/2</translation>
    </message>
    <message>
        <source>work on the rock up to the largest force, fraction of the hammer work</source>
        <translation>arbete på berget upp till den största kraften, andel av hammarens arbete</translation>
    </message>
    <message>
        <source>yield strength</source>
        <translation>sträckgräns</translation>
    </message>
    <message>
        <source>Penetration at which a power law gives F = k U1</source>
        <translation>Inträngning vid vilken en potenslag ger F = k U1</translation>
    </message>
    <message>
        <source>Penetration at which a power law gives F = k U1, in d0</source>
        <translation>Inträngning vid vilken en potenslag ger F = k U1, i d0</translation>
    </message>
    <message>
        <source>remaining in the string</source>
        <translation>kvar i strängen</translation>
    </message>
    <message>
        <source>bound on the error of e</source>
        <translation>gräns för felet i e</translation>
    </message>
    <message>
        <source>bound on the error of the efficiency</source>
        <translation>gräns för felet i verkningsgraden</translation>
    </message>
    <message>
        <source>error of the energy balance</source>
        <translation>fel i energibalansen</translation>
    </message>
    <message>
        <source>error of the momentum balance</source>
        <translation>fel i rörelsemängdens balans</translation>
    </message>
    <message>
        <source>computed until</source>
        <translation>beräknad till</translation>
    </message>
    <message>
        <source>feed force margin at every gap</source>
        <translation>matningskraftens marginal vid varje spalt</translation>
    </message>
    <message>
        <source>momentum of the string to the rock</source>
        <translation>strängens rörelsemängd mot berget</translation>
    </message>
    <message>
        <source>restitution e</source>
        <translation>studstal e</translation>
    </message>
    <message>
        <source>rock, and energy returned with the hammer</source>
        <translation>berget och vad hammaren tar tillbaka</translation>
    </message>
    <message>
        <source>feed force required by this blow</source>
        <translation>matningskraft som slaget kräver</translation>
    </message>
    <message>
        <source>a law of one line</source>
        <translation>en lag med en linje</translation>
    </message>
    <message>
        <source>a law with corners</source>
        <translation>en lag med hörn</translation>
    </message>
    <message>
        <source>a power law</source>
        <translation>en potenslag</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klart</translation>
    </message>
    <message>
        <source>not_solved</source>
        <translation>inte löst</translation>
    </message>
    <message>
        <source>pushed_back</source>
        <translation>trycks tillbaka</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>stoppad</translation>
    </message>
    <message>
        <source>0.7 kg: Mitsubishi Materials, type 23, second hand; the shape assumed, so that it has that mass</source>
        <translation>0,7 kg: Mitsubishi Materials, typ 23, i andra hand; formen antagen så att den har denna massa</translation>
    </message>
    <message>
        <source>11 kW over 110 J (press release of 2005, second hand)</source>
        <translation>11 kW genom 110 J (pressmeddelande från 2005, i andra hand)</translation>
    </message>
    <message>
        <source>110 J at 10 m/s (press release of 2005, second hand); uniform, its length and velocity assumed</source>
        <translation>110 J vid 10 m/s (pressmeddelande från 2005, i andra hand); likformig, dess längd och hastighet antagna</translation>
    </message>
    <message>
        <source>200 J at 10 m/s: 12 kW at 60 Hz (brochure 9865 0024, second hand); uniform, its length and velocity assumed</source>
        <translation>200 J vid 10 m/s: 12 kW vid 60 Hz (broschyr 9865 0024, i andra hand); likformig, dess längd och hastighet antagna</translation>
    </message>
    <message>
        <source>200 J at 10 m/s: of 180 to 220 J (specification of the HC drifters, second hand); uniform, its length and velocity assumed</source>
        <translation>200 J vid 10 m/s: inom 180 till 220 J (specifikation för HC-borrmaskinerna, i andra hand); likformig, dess längd och hastighet antagna</translation>
    </message>
    <message>
        <source>25 mm across flats, less a flushing hole of 8.6 mm (Epiroc catalogue 9866 0424, Robit, second hand)</source>
        <translation>nyckelvidd 25 mm, minus ett spolhål på 8,6 mm (Epirocs katalog 9866 0424, Robit, i andra hand)</translation>
    </message>
    <message>
        <source>28 mm across flats, less a flushing hole of 8.8 mm (Sandvik, Robit catalogues, second hand)</source>
        <translation>nyckelvidd 28 mm, minus ett spolhål på 8,8 mm (katalogerna från Sandvik och Robit, i andra hand)</translation>
    </message>
    <message>
        <source>308 J at 10 m/s: 18.5 kW at 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 to 19 kW); uniform, its length and velocity assumed</source>
        <translation>308 J vid 10 m/s: 18,5 kW vid 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 till 19 kW); likformig, dess längd och hastighet antagna</translation>
    </message>
    <message>
        <source>32 mm across flats, less a flushing hole of 9.6 mm (Epiroc, Sandvik, Robit catalogues, second hand)</source>
        <translation>nyckelvidd 32 mm, minus ett spolhål på 9,6 mm (katalogerna från Epiroc, Sandvik och Robit, i andra hand)</translation>
    </message>
    <message>
        <source>35 mm across flats, less a flushing hole of 9.5 mm (Epiroc, Sandvik, Robit catalogues, second hand)</source>
        <translation>nyckelvidd 35 mm, minus ett spolhål på 9,5 mm (katalogerna från Epiroc, Sandvik och Robit, i andra hand)</translation>
    </message>
    <message>
        <source>3500 blows a minute (Power &amp; Motion, Hydraulic valves make machines rock solid)</source>
        <translation>3500 slag per minut (Power &amp; Motion, Hydraulic valves make machines rock solid)</translation>
    </message>
    <message>
        <source>380 J at 10 m/s: the most of 250 to 380 J (specification of the HC drifters, second hand); uniform, its length and velocity assumed</source>
        <translation>380 J vid 10 m/s: det högsta av 250 till 380 J (specifikation för HC-borrmaskinerna, i andra hand); likformig, dess längd och hastighet antagna</translation>
    </message>
    <message>
        <source>380 to 390 mm, 3.1 to 3.3 kg, bore 10 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>380 till 390 mm, 3,1 till 3,3 kg, spolhål 10 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>406 mm, 3.3 kg, bore 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>406 mm, 3,3 kg, spolhål 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>41 x 160 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>41 × 160 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>435 mm, 4.7 to 5.0 kg, bore 9.6 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>435 mm, 4,7 till 5,0 kg, spolhål 9,6 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>447 mm, 5.0 kg, bore 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>447 mm, 5,0 kg, spolhål 14 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>50 Hz with 5.5 kW, second hand</source>
        <translation>50 Hz vid 5,5 kW, i andra hand</translation>
    </message>
    <message>
        <source>54 x 170 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>54 × 170 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>55 x 190 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>55 × 190 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>605 mm, 9.3 kg, bore 11.3 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>605 mm, 9,3 kg, spolhål 11,3 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>63 x 210 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>63 × 210 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>7.5 kW over 165 J (press release of 2005, second hand)</source>
        <translation>7,5 kW genom 165 J (pressmeddelande från 2005, i andra hand)</translation>
    </message>
    <message>
        <source>72 x 235 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); bore assumed: that of the rod, the joint being full</source>
        <translation>72 × 235 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>770 mm, 13.1 to 14.3 kg, bore 6.6 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>770 mm, 13,1 till 14,3 kg, spolhål 6,6 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>790 mm, 14.8 kg, bore 11.3 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>790 mm, 14,8 kg, spolhål 11,3 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>840 mm, 15.8 kg, bore 6.2 mm (Mitsubishi Materials, Top Hammer Tools 2024, second hand); as if uniform, the diameter from the mass</source>
        <translation>840 mm, 15,8 kg, spolhål 6,2 mm (Mitsubishi Materials, Top Hammer Tools 2024, i andra hand); som om likformig, diametern ur massan</translation>
    </message>
    <message>
        <source>A bench-drilling rod in medium rock: a good case to start with. Look at energy and feed force: three quarters of the blow energy remain in the rock, most of the rest remains in the rod as waves, and the rebound decides the required feed force. Drag stiffness or gap and watch both change.</source>
        <translation>En stång för pallborrning i medelhårt berg: ett bra fall att börja med. Se på energin och matningskraften: tre fjärdedelar av slagenergin stannar i berget, det mesta av resten löper fram och åter i stången som vågor, och studsen bestämmer den matningskraft som slagen kräver. Dra i reglaget för styvhet eller spalt för att se båda ändras.</translation>
    </message>
    <message>
        <source>A heavy string in soft rock, struck by an elastic piston a little stiffer than the rod. Look at the steps of the hammer blow, each as long as the piston&apos;s own round trip, and at the deep penetration: soft rock takes up the wave so slowly that the contact lasts longer than a round trip of the wave in the rod.</source>
        <translation>En tung sträng i mjukt berg, slagen av en elastisk kolv något styvare än stången. Se på hammarslagets steg, vart och ett lika långt som kolvens eget varv fram och åter, och på den djupa inträngningen: mjukt berg tar upp vågen så långsamt att kontakten varar längre än vågens varv fram och åter i stången.</translation>
    </message>
    <message>
        <source>A light drifter on hard rock. Look at the peak force and at the thrust needed: stiff rock answers a short blow with a high, brief force and throws the string back harder than softer rock, so that more feed force is needed for each joule that stays in the rock. Compare with the T38 rod in medium rock.</source>
        <translation>En lätt borrmaskin på hårt berg. Se på toppkraften och på matningskraften som krävs: styvt berg svarar på ett kort slag med en hög, kortvarig kraft och kastar tillbaka strängen hårdare än mjukare berg, så att det krävs mer matningskraft för varje joule som stannar i berget. Jämför med T38-stången i medelhårt berg.</translation>
    </message>
    <message>
        <source>A rod without waves before the impact: it flies as a rigid body against the same spring as in Fig. 4 (a). Look at the single long contact and compare e = 0.990 with 1.401 there: the super rebound is the work of the pre-impact waves. The scales are those of Fig. 4, the unit of time being the t0 that gives tau = 10.</source>
        <translation>En stång utan vågor före stöten: den flyger som en stel kropp mot samma fjäder som i fig. 4 (a). Se på den enda, långa kontakten och jämför e = 0,990 med 1,401 där: superstudsen är ett verk av vågorna före stöten. Skalorna är de i fig. 4, med det t0 som ger tau = 10 som tidsenhet.</translation>
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
        <translation>Epirocs katalog 9866 0424, i andra hand</translation>
    </message>
    <message>
        <source>Epiroc catalogue 9866 0424, second hand; the weights of Robit and Sandvik agree within 2 %</source>
        <translation>Epirocs katalog 9866 0424, i andra hand; vikterna hos Robit och Sandvik stämmer överens inom 2&#xa0;%</translation>
    </message>
    <message>
        <source>Fig. 4 (a) of the paper, elastic spring</source>
        <translation>Artikelns fig. 4 (a), elastisk fjäder</translation>
    </message>
    <message>
        <source>Fig. 4 (b) of the paper, bilinear rock</source>
        <translation>Artikelns fig. 4 (b), bilinjärt berg</translation>
    </message>
    <message>
        <source>Fig. 8 of the paper, gap of the smallest rebound</source>
        <translation>Artikelns fig. 8, spalten med den minsta studsen</translation>
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
        <translation>R25, sexkant 25 mm</translation>
    </message>
    <message>
        <source>R32 drifter, 42 and 34 mm</source>
        <translation>R32-borrmaskin, 42 och 34 mm</translation>
    </message>
    <message>
        <source>R32 rod, hard rock</source>
        <translation>R32-stång, hårt berg</translation>
    </message>
    <message>
        <source>R32 shank, 350 mm</source>
        <translation>R32-nackadapter, 350 mm</translation>
    </message>
    <message>
        <source>R32 string, one rod, hard rock</source>
        <translation>R32-sträng, en stång, hårt berg</translation>
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
        <translation>R32, sexkant 28 mm</translation>
    </message>
    <message>
        <source>R32, hex 32 mm</source>
        <translation>R32, sexkant 32 mm</translation>
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
        <translation>Referensfall, stång som kommer fram utan vågor</translation>
    </message>
    <message>
        <source>Rock that yields: from 90 kN on it loads along a line of a third of the slope. Look at the rock, whose curve bends, and at the peak force, which stays low while the bit goes deeper; `--set bit_rock.law=bilinear` is the same rock without the corner.</source>
        <translation>Berg som ger efter: från 90 kN belastas det längs en linje med en tredjedel av lutningen. Se på berget, vars kurva böjer av, och på toppkraften, som förblir låg medan borrkronan går djupare; `--set bit_rock.law=bilinear` är samma berg utan hörnet.</translation>
    </message>
    <message>
        <source>Sandvik HL 820ST</source>
        <translation>Sandvik HL 820ST</translation>
    </message>
    <message>
        <source>Sandvik catalogue 2024, second hand</source>
        <translation>Sandviks katalog 2024, i andra hand</translation>
    </message>
    <message>
        <source>Sandvik catalogue 2024, second hand; the weights there are 7 % less; the rod of the R32 examples</source>
        <translation>Sandviks katalog 2024, i andra hand; vikterna där är 7&#xa0;% lägre; stången i R32-exemplen</translation>
    </message>
    <message>
        <source>Sandvik, Robit catalogues, second hand; weights agree within 2 %</source>
        <translation>katalogerna från Sandvik och Robit, i andra hand; vikterna stämmer överens inom 2&#xa0;%</translation>
    </message>
    <message>
        <source>T38 drifter, 50 and 38 mm</source>
        <translation>T38-borrmaskin, 50 och 38 mm</translation>
    </message>
    <message>
        <source>T38 rod, medium rock</source>
        <translation>T38-stång, medelhårt berg</translation>
    </message>
    <message>
        <source>T38 rod, rock not measured</source>
        <translation>T38-stång, berg som inte är uppmätt</translation>
    </message>
    <message>
        <source>T38 rod, rock that yields</source>
        <translation>T38-stång, berg som ger efter</translation>
    </message>
    <message>
        <source>T38 shank, 450 mm</source>
        <translation>T38-nackadapter, 450 mm</translation>
    </message>
    <message>
        <source>T38 string, three rods</source>
        <translation>T38-sträng, tre stänger</translation>
    </message>
    <message>
        <source>T38, 190 mm</source>
        <translation>T38, 190 mm</translation>
    </message>
    <message>
        <source>T38, 190 mm, worn</source>
        <translation>T38, 190 mm, sliten</translation>
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
        <translation>T51-borrmaskin för pallborrning, 62 och 52 mm</translation>
    </message>
    <message>
        <source>T51 rod, soft rock, piston blow</source>
        <translation>T51-stång, mjukt berg, kolvslag</translation>
    </message>
    <message>
        <source>T51 shank, 550 mm</source>
        <translation>T51-nackadapter, 550 mm</translation>
    </message>
    <message>
        <source>T51 string, five rods, bench drilling</source>
        <translation>T51-sträng, fem stänger, pallborrning</translation>
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
        <translation>Spalten ensam gör en superstuds till en svag studs. Se på den första krafttoppen: framänden passerar en spalt på 0,521 d0 under vågens första hälft, som reflekteras som om det inte fanns något berg, och först den andra hälften möter fjädern; resten kommer tillbaka ett varv fram och åter senare. Därför faller e från 1,401 till 0,842. Dra spalten mot 0 eller 1 för att se det stiga igen.</translation>
    </message>
    <message>
        <source>The paper&apos;s elastic blow. Look at the two force peaks and the impulse: the incident wave gives the first peak, which alone would send the rod back as fast as it came (impulse 2, e = 1); the wave that comes back from the free rear end gives the second, which adds 0.4. So e = 1.401, a super rebound, although no energy was added.</source>
        <translation>Artikelns elastiska slag. Se på de två krafttopparna och impulsen: den infallande vågen ger den första toppen, som ensam skulle skicka tillbaka stången lika fort som den kom (impuls 2, e = 1); vågen som kommer tillbaka från den fria bakänden ger den andra, som lägger till 0,4. Därför är e = 1,401, en superstuds, fast ingen energi har tillförts.</translation>
    </message>
    <message>
        <source>The same blow on rock that keeps most of the work done on it. Look at the force peaks: they rise as in Fig. 4 (a) but fall ten times faster (slope k/γ, γ = 0.1), so the rock pushes back for a shorter time and the rod rebounds slowly: e = 0.407. Three quarters of the work of the hammer stay in the rock.</source>
        <translation>Samma slag på berg som behåller det mesta av det arbete som uträttas på det. Se på krafttopparna: de stiger som i fig. 4 (a) men faller tio gånger snabbare (lutning k/γ, γ = 0,1), så att berget trycker tillbaka under en kortare tid och stången studsar långsamt: e = 0,407. Tre fjärdedelar av hammarens arbete stannar i berget.</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>antaget</translation>
    </message>
    <message>
        <source>assumed: 1.3 kg; bits of this thread are 43 to 76 mm wide</source>
        <translation>antaget: 1,3 kg; borrkronor med denna gänga är 43 till 76 mm breda</translation>
    </message>
    <message>
        <source>assumed: 12.4 kg, 562 J; front about as thick as the shank</source>
        <translation>antaget: 12,4 kg, 562 J; främre delen ungefär lika tjock som nacken</translation>
    </message>
    <message>
        <source>assumed: 208 J a blow in steel</source>
        <translation>antaget: 208 J per slag i stål</translation>
    </message>
    <message>
        <source>assumed: 244 MPa in a round R32 rod</source>
        <translation>antaget: 244 MPa i en rund R32-stång</translation>
    </message>
    <message>
        <source>assumed: 3.2 kg; bits of this thread are 64 to 89 mm wide</source>
        <translation>antaget: 3,2 kg; borrkronor med denna gänga är 64 till 89 mm breda</translation>
    </message>
    <message>
        <source>assumed: 4.1 kg, 187 J; front about as thick as the shank</source>
        <translation>antaget: 4,1 kg, 187 J; främre delen ungefär lika tjock som nacken</translation>
    </message>
    <message>
        <source>assumed: 451 J a blow in steel</source>
        <translation>antaget: 451 J per slag i stål</translation>
    </message>
    <message>
        <source>assumed: 6.9 kg, 342 J; front about as thick as the shank</source>
        <translation>antaget: 6,9 kg, 342 J; främre delen ungefär lika tjock som nacken</translation>
    </message>
    <message>
        <source>assumed: 7.5 kg; bits of this thread are 89 to 127 mm wide</source>
        <translation>antaget: 7,5 kg; borrkronor med denna gänga är 89 till 127 mm breda</translation>
    </message>
    <message>
        <source>assumed: a blow of about 200 us in steel</source>
        <translation>antaget: ett slag på omkring 200 us i stål</translation>
    </message>
    <message>
        <source>assumed: a little thicker than a T51 rod is in steel</source>
        <translation>antaget: något tjockare än en T51-stång räknad i stål</translation>
    </message>
    <message>
        <source>assumed: a stiff test stand</source>
        <translation>antaget: en styv provbänk</translation>
    </message>
    <message>
        <source>assumed: about 10 kW of percussion</source>
        <translation>antaget: omkring 10 kW slageffekt</translation>
    </message>
    <message>
        <source>assumed: about 12 kW of percussion</source>
        <translation>antaget: omkring 12 kW slageffekt</translation>
    </message>
    <message>
        <source>assumed: about 20 kW of percussion</source>
        <translation>antaget: omkring 20 kW slageffekt</translation>
    </message>
    <message>
        <source>assumed: about 4 kg at 10 m/s</source>
        <translation>antaget: omkring 4 kg vid 10 m/s</translation>
    </message>
    <message>
        <source>assumed: about 4 kg on a T38 rod</source>
        <translation>antaget: omkring 4 kg mot en T38-stång</translation>
    </message>
    <message>
        <source>assumed: about the cross-section of a T38 rod</source>
        <translation>antaget: ungefär en T38-stångs tvärsnittsarea</translation>
    </message>
    <message>
        <source>assumed: as thick as a T38 rod is in steel, so that it is almost at rest after the first push</source>
        <translation>antaget: lika tjock som en T38-stång räknad i stål, så att den är nästan i vila efter den första knuffen</translation>
    </message>
    <message>
        <source>assumed: beta = 0.27 with a T51 rod and a blow of 0.23 ms</source>
        <translation>antaget: beta = 0,27 med en T51-stång och ett slag på 0,23 ms</translation>
    </message>
    <message>
        <source>assumed: beta = 0.53 with a T38 rod (the paper: of the order of 1 in drilling)</source>
        <translation>antaget: beta = 0,53 med en T38-stång (artikeln: av storleksordningen 1 vid borrning)</translation>
    </message>
    <message>
        <source>assumed: beta = 1.5 with an R32 rod (the paper: of the order of 1 in drilling)</source>
        <translation>antaget: beta = 1,5 med en R32-stång (artikeln: av storleksordningen 1 vid borrning)</translation>
    </message>
    <message>
        <source>assumed: heat-treated drill steel</source>
        <translation>antaget: värmebehandlat borrstål</translation>
    </message>
    <message>
        <source>assumed: less than half of the yield strength, smooth rod, no corrosion</source>
        <translation>antaget: mindre än halva sträckgränsen, slät stång, ingen korrosion</translation>
    </message>
    <message>
        <source>assumed: mean force 255 kN, 331 J a blow in a T38 rod</source>
        <translation>antaget: medelkraft 255 kN, 331 J per slag i en T38-stång</translation>
    </message>
    <message>
        <source>assumed: more elastic than the 0.1 the paper takes for drilling</source>
        <translation>antaget: mer elastiskt än de 0,1 som artikeln räknar med för borrning</translation>
    </message>
    <message>
        <source>assumed: piston about as thick as the rod</source>
        <translation>antaget: kolv ungefär lika tjock som stången</translation>
    </message>
    <message>
        <source>assumed: piston of about 0.39 m</source>
        <translation>antaget: kolv på omkring 0,39 m</translation>
    </message>
    <message>
        <source>assumed: piston of about 0.52 m</source>
        <translation>antaget: kolv på omkring 0,52 m</translation>
    </message>
    <message>
        <source>assumed: the maker gives none</source>
        <translation>antaget: tillverkaren anger ingen</translation>
    </message>
    <message>
        <source>assumed: twice that of hard rock</source>
        <translation>antaget: dubbelt så mycket som för hårt berg</translation>
    </message>
    <message>
        <source>assumed: uniform hammer</source>
        <translation>antaget: likformig hammare</translation>
    </message>
    <message>
        <source>assumed: usual</source>
        <translation>antaget: vanligt</translation>
    </message>
    <message>
        <source>brochure 9865 0009, second hand</source>
        <translation>broschyr 9865 0009, i andra hand</translation>
    </message>
    <message>
        <source>brochure 9865 0122, second hand</source>
        <translation>broschyr 9865 0122, i andra hand</translation>
    </message>
    <message>
        <source>elastic anvil</source>
        <translation>elastiskt städ</translation>
    </message>
    <message>
        <source>hard rock</source>
        <translation>hårt berg</translation>
    </message>
    <message>
        <source>heavy drifter, piston</source>
        <translation>tung borrmaskin, kolv</translation>
    </message>
    <message>
        <source>hex 35 mm, T38 and R32</source>
        <translation>sexkant 35 mm, T38 och R32</translation>
    </message>
    <message>
        <source>light drifter, short blow</source>
        <translation>lätt borrmaskin, kort slag</translation>
    </message>
    <message>
        <source>linear elastic: what goes in comes out</source>
        <translation>linjärt elastiskt: det som går in kommer ut</translation>
    </message>
    <message>
        <source>mass: the maker&apos;s product range of 2025, second hand; uniform, its length and velocity assumed</source>
        <translation>massa: tillverkarens produktprogram 2025, i andra hand; likformig, dess längd och hastighet antagna</translation>
    </message>
    <message>
        <source>medium drifter</source>
        <translation>medeltung borrmaskin</translation>
    </message>
    <message>
        <source>medium drifter, piston</source>
        <translation>medeltung borrmaskin, kolv</translation>
    </message>
    <message>
        <source>medium rock</source>
        <translation>medelhårt berg</translation>
    </message>
    <message>
        <source>model: hammer much shorter and thicker than the rod</source>
        <translation>modell: hammare mycket kortare och tjockare än stången</translation>
    </message>
    <message>
        <source>narrow bore R32, round 32 mm</source>
        <translation>R32 med smalt spolhål, rund 32 mm</translation>
    </message>
    <message>
        <source>nominal size of the thread; the rod of the T38 example</source>
        <translation>gängans nominella mått; stången i T38-exemplet</translation>
    </message>
    <message>
        <source>nominal, from the name of the rod</source>
        <translation>nominellt, ur stångens namn</translation>
    </message>
    <message>
        <source>of 40 to 62.5 Hz (specification of the HC drifters, second hand)</source>
        <translation>inom 40 till 62,5 Hz (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>of 47 to 55 Hz (specification of the HC drifters, second hand)</source>
        <translation>inom 47 till 55 Hz (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>of 55 to 65 Hz (specification of the HC drifters, second hand)</source>
        <translation>inom 55 till 65 Hz (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>rigid hammer</source>
        <translation>stel hammare</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 110 J (press release of 2005, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 110 J (pressmeddelande från 2005, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 117 J (specification of the HC drifters, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 117 J (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 149 J: 110 foot-pounds (Power &amp; Motion, Hydraulic valves make machines rock solid)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 149 J: 110 fotpund (Power &amp; Motion, Hydraulic valves make machines rock solid)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 160 J (specification of the HC drifters, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 160 J (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 165 J (press release of 2005, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 165 J (pressmeddelande från 2005, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 175 J: 14 kW at 80 Hz (brochure 9865 0009, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 175 J: 14 kW vid 80 Hz (broschyr 9865 0009, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 200 J: 12 kW at 60 Hz (brochure 9865 0024, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 200 J: 12 kW vid 60 Hz (broschyr 9865 0024, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 200 J: of 180 to 220 J (specification of the HC drifters, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 200 J: inom 180 till 220 J (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 308 J: 18.5 kW at 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 to 19 kW)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 308 J: 18,5 kW vid 60 Hz (E&amp;MJ, Hydraulic drills hammer through: 18 till 19 kW)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 350 J: 21 kW (specification of the DL431, second hand) at 60 Hz, which is assumed</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 350 J: 21 kW (specifikation för DL431, i andra hand) vid 60 Hz, som är antaget</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 380 J: the most of 250 to 380 J (specification of the HC drifters, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 380 J: det högsta av 250 till 380 J (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>so that a blow of steel at 10 m/s has 60 J: 6 kW at 100 Hz (brochure 9865 0122, second hand)</source>
        <translation>så att ett slag av en stålkolv vid 10 m/s har 60 J: 6 kW vid 100 Hz (broschyr 9865 0122, i andra hand)</translation>
    </message>
    <message>
        <source>soft rock</source>
        <translation>mjukt berg</translation>
    </message>
    <message>
        <source>steel, usual value</source>
        <translation>stål, vanligt värde</translation>
    </message>
    <message>
        <source>that of the examples; loss assumed: a tight joint loses a few per cent, a worn one several times as much</source>
        <translation>den i exemplen; förlusten antagen: en väl åtdragen skarv förlorar några procent, en sliten flera gånger så mycket</translation>
    </message>
    <message>
        <source>the coupling of the T38 examples, 1 mm thicker than catalogues have it; bore assumed: that of the rod, the joint being full</source>
        <translation>skarvhylsan i T38-exemplen, 1 mm tjockare än i katalogerna; spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>the coupling of the T51 example, 5 mm longer than catalogues have it; bore assumed: that of the rod, the joint being full</source>
        <translation>skarvhylsan i T51-exemplet, 5 mm längre än i katalogerna; spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>the least of 63 to 72 Hz (specification of the HC drifters, second hand)</source>
        <translation>det lägsta av 63 till 72 Hz (specifikation för HC-borrmaskinerna, i andra hand)</translation>
    </message>
    <message>
        <source>the most (E&amp;MJ, Hydraulic drills hammer through)</source>
        <translation>det högsta (E&amp;MJ, Hydraulic drills hammer through)</translation>
    </message>
    <message>
        <source>the most of 40 to 60 Hz (brochure 9865 0024, second hand)</source>
        <translation>det högsta av 40 till 60 Hz (broschyr 9865 0024, i andra hand)</translation>
    </message>
    <message>
        <source>the paper&apos;s value for percussive drilling</source>
        <translation>artikelns värde för slående borrning</translation>
    </message>
    <message>
        <source>uniform, 36 mm</source>
        <translation>likformig, 36 mm</translation>
    </message>
    <message>
        <source>usual size in catalogues (45 x 150 mm); bore assumed: that of the rod, the joint being full</source>
        <translation>vanligt mått i kataloger (45 × 150 mm); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>usual size in catalogues (55 x 170 mm); bore assumed: that of the rod, the joint being full</source>
        <translation>vanligt mått i kataloger (55 × 170 mm); spolhålet antaget: stångens, eftersom skarven är utfylld</translation>
    </message>
    <message>
        <source>very hard rock</source>
        <translation>mycket hårt berg</translation>
    </message>
    <message>
        <source>5 % of the gaps</source>
        <translation>5&#xa0;% av spalterna</translation>
    </message>
    <message>
        <source>95 % of the gaps</source>
        <translation>95&#xa0;% av spalterna</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Ljapunovexponent</translation>
    </message>
    <message>
        <source>number of blows after which the motion repeats, 1 to 16; 0 if it does not repeat</source>
        <translation>antal slag efter vilka rörelsen upprepas, 1 till 16; 0 om den inte upprepas</translation>
    </message>
    <message>
        <source>contact share: blows that start with the bit on the rock</source>
        <translation>slag som börjar på berget</translation>
    </message>
    <message>
        <source>contacts of a blow</source>
        <translation>kontakter per slag</translation>
    </message>
    <message>
        <source>mean number of contacts between bit and rock in a blow</source>
        <translation>medelantal kontakter mellan borrkrona och berg i ett slag</translation>
    </message>
    <message>
        <source>deviation of the gap</source>
        <translation>spaltens standardavvikelse</translation>
    </message>
    <message>
        <source>error of the energy balance of all blows, as a share of the hammer work</source>
        <translation>fel i energibalansen för alla slag, som andel av hammarens arbete</translation>
    </message>
    <message>
        <source>error of the momentum balance of all blows, relative to the impulse of the feed force</source>
        <translation>fel i rörelsemängdens balans för alla slag, relativt matningskraftens impuls</translation>
    </message>
    <message>
        <source>error of the energy of many blows</source>
        <translation>fel i energin över många slag</translation>
    </message>
    <message>
        <source>error of the mean penetration</source>
        <translation>fel i medelinträngningen</translation>
    </message>
    <message>
        <source>error of the momentum of many blows</source>
        <translation>fel i rörelsemängden över många slag</translation>
    </message>
    <message>
        <source>gap between bit and rock that 95 % of the blows exceed</source>
        <translation>spalt mellan borrkrona och berg som 95&#xa0;% av slagen överskrider</translation>
    </message>
    <message>
        <source>gap between bit and rock that 5 % of the blows exceed</source>
        <translation>spalt mellan borrkrona och berg som 5&#xa0;% av slagen överskrider</translation>
    </message>
    <message>
        <source>median of the gap between bit and rock at the start of the blows</source>
        <translation>median av spalten mellan borrkrona och berg när slagen börjar</translation>
    </message>
    <message>
        <source>Lyapunov exponent: growth of a small disturbance per blow; above 0, single blows are not reproducible and only mean values count. Needs a second simulation of all blows</source>
        <translation>Lyapunovexponent: tillväxt av en liten störning per slag; över 0 är enstaka slag inte reproducerbara, och bara medelvärden gäller. Kräver en andra simulering av alla slag</translation>
    </message>
    <message>
        <source>95 % error of drill_penetration, the mean penetration per blow. Needs a second simulation of all blows, with other time steps</source>
        <translation>95&#xa0;%-fel för drill_penetration, medelinträngningen per slag. Kräver en andra simulering av alla slag, med andra tidssteg</translation>
    </message>
    <message>
        <source>largest force in the damper between machine and rod</source>
        <translation>största kraft i dämparen mellan maskin och stång</translation>
    </message>
    <message>
        <source>mean gap at the blow</source>
        <translation>medelspalt vid slaget</translation>
    </message>
    <message>
        <source>mean gap between bit and rock at the start of the blows, from `drill`</source>
        <translation>medelspalt mellan borrkrona och berg när slagen börjar, från `drill`</translation>
    </message>
    <message>
        <source>mean impulse on the rock</source>
        <translation>medelimpuls på berget</translation>
    </message>
    <message>
        <source>mean impulse on the rock per blow: feed force over blow frequency</source>
        <translation>medelimpuls på berget per slag: matningskraft genom slagfrekvens</translation>
    </message>
    <message>
        <source>mean over all blows of the largest force on the rock</source>
        <translation>medelvärde över alla slag av den största kraften på berget</translation>
    </message>
    <message>
        <source>mean peak force</source>
        <translation>medel av toppkraften</translation>
    </message>
    <message>
        <source>mean penetration of a blow</source>
        <translation>medelinträngning per slag</translation>
    </message>
    <message>
        <source>mean penetration per blow; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>medelinträngning per slag; en övre gräns, eftersom allt berg under kronan antas brytas</translation>
    </message>
    <message>
        <source>penetration rate, m/s: mean penetration per blow times blow frequency; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>borrsjunkning, m/s: medelinträngning per slag gånger slagfrekvens; en övre gräns, eftersom allt berg under kronan antas brytas</translation>
    </message>
    <message>
        <source>median of the gaps</source>
        <translation>median av spalterna</translation>
    </message>
    <message>
        <source>number of round trips that a wave makes through rod or string between two blows (n_b)</source>
        <translation>antal varv som en våg gör fram och åter genom stång eller sträng mellan två slag (n_b)</translation>
    </message>
    <message>
        <source>penetration rate of many blows</source>
        <translation>borrsjunkning över många slag</translation>
    </message>
    <message>
        <source>period of the motion</source>
        <translation>rörelsens period</translation>
    </message>
    <message>
        <source>effective feed force divided by the mean force of the blows (phi); below 1 the blows push the machine back</source>
        <translation>verkande matningskraft delad med slagens medelkraft (phi); under 1 skjuter slagen maskinen bakåt</translation>
    </message>
    <message>
        <source>round trips from blow to blow</source>
        <translation>varv fram och åter från slag till slag</translation>
    </message>
    <message>
        <source>contact share: share of blows that start with the bit on the rock, or less than 0.05 d0 away from it. d0 = 2 I0/Z, with the impulse I0 of a blow and the impedance Z of the rod</source>
        <translation>kontaktandel: andel slag som börjar med borrkronan mot berget, eller mindre än 0,05 d0 från det. d0 = 2 I0/Z, med slagets impuls I0 och stångens impedans Z</translation>
    </message>
    <message>
        <source>standard deviation of the gap between bit and rock at the start of the blows</source>
        <translation>standardavvikelse för spalten mellan borrkrona och berg när slagen börjar</translation>
    </message>
    <message>
        <source>thrust number</source>
        <translation>matningstal</translation>
    </message>
    <message>
        <source>bound on the error of the stresses</source>
        <translation>gräns för felet i spänningarna</translation>
    </message>
    <message>
        <source>error bound of the largest stresses of a drill string, fraction of each</source>
        <translation>angivet fel i en borrsträngs största spänningar, som andel av var och en</translation>
    </message>
    <message>
        <source>stress error</source>
        <translation>fel i spänningarna</translation>
    </message>
    <message>
        <source>95 % of all gaps</source>
        <translation>95 % av alla spalter</translation>
    </message>
    <message>
        <source>not enough</source>
        <translation>räcker inte</translation>
    </message>
    <message>
        <source>fully elastic rock (gamma = 1), worst gap</source>
        <translation>helt elastiskt berg (gamma = 1), ogynnsammaste spalt</translation>
    </message>
    <message>
        <source>no estimate</source>
        <translation>ingen uppskattning</translation>
    </message>
    <message>
        <source>enough in all cases</source>
        <translation>räcker i samtliga fall</translation>
    </message>
    <message>
        <source>returns the rod in time</source>
        <translation>stången återvänder i tid</translation>
    </message>
    <message>
        <source>rigid rock</source>
        <translation>stelt berg</translation>
    </message>
    <message>
        <source>this blow</source>
        <translation>detta slag</translation>
    </message>
    <message>
        <source>A T38 string of three rods with its hammer. Look at the efficiency, which the joints decide: 0.32 of the energy of the hammer stays in the rock. Each joint is assumed to lose 5 % of the energy that passes; without these losses 0.50 would stay. The couplings are of larger impedance than the rods and reflect part of every wave; as thin as the rod they would leave 0.41. Then look at the largest tension.</source>
        <translation>En T38-sträng av tre stänger med sin hammare. Se på verkningsgraden, som skarvarna avgör: 0,32 av hammarens energi stannar i berget. Varje skarv antas förlora 5&#xa0;% av energin som passerar; utan dessa förluster skulle 0,50 stanna. Skarvhylsorna har större impedans än stängerna och kastar tillbaka en del av varje våg; lika tunna som stången skulle de lämna 0,41. Se sedan på det största draget.</translation>
    </message>
    <message>
        <source>A bench drilling string of five T51 rods. Look at the efficiency, 0.24 where three T38 rods have 0.32, and set string.repeat to fewer and to more rods: the first joints of a string cost more than the last. Each is assumed to lose 5 % of the energy that passes; without these losses 0.46 would stay in the rock.</source>
        <translation>En sträng av fem T51-stänger för pallborrning. Se på verkningsgraden, 0,24 där tre T38-stänger har 0,32, och sätt string.repeat till färre och fler stänger: en strängs första skarvar kostar mer än de sista. Var och en antas förlora 5&#xa0;% av energin som passerar; utan dessa förluster skulle 0,46 stanna i berget.</translation>
    </message>
    <message>
        <source>A light drifter with one R32 rod on hard rock. Look at the efficiency: 0.56, where three T38 rods in softer rock have 0.32. Each joint is assumed to lose 5 % of the energy that passes, and a string of one rod has few of them; without these losses 0.67 would stay in the rock, and 8 % would move back with the hammer, not 0.7 %.</source>
        <translation>En lätt borrmaskin med en R32-stång på hårt berg. Se på verkningsgraden: 0,56, där tre T38-stänger i mjukare berg har 0,32. Varje skarv antas förlora 5&#xa0;% av energin som passerar, och en sträng av en stång har få av dem; utan dessa förluster skulle 0,67 stanna i berget, och 8&#xa0;% gå tillbaka med hammaren, inte 0,7&#xa0;%.</translation>
    </message>
    <message>
        <source>assumed: case-hardened Cr-Ni-Mo steel; fatigue: the 400 MPa of a smooth bar over a notch factor of 1.6 for threads and splines</source>
        <translation>antaget: sätthärdat Cr-Ni-Mo-stål; utmattning: de 400 MPa hos en slät stång delat med en anvisningsfaktor på 1,6 för gängor och splines</translation>
    </message>
    <message>
        <source>hammer</source>
        <translation>hammare</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>stång</translation>
    </message>
    <message>
        <source>bit</source>
        <translation>borrkrona</translation>
    </message>
    <message>
        <source>adapter</source>
        <translation>nackadapter</translation>
    </message>
    <message>
        <source>coupling</source>
        <translation>skarvhylsa</translation>
    </message>
    <message>
        <source>bit skirt</source>
        <translation>kronskaft</translation>
    </message>
    <message>
        <source>bit head</source>
        <translation>kronhuvud</translation>
    </message>
    <message>
        <source>Which blow for rock that nobody has measured? Look at the page Design: the blow that is best in this rock loses much in softer and springier rock, a longer one of the same energy less. The command is `drillwave design piston_for_unknown_rock`; the block design holds its set-up.</source>
        <translation>Vilket slag för berg som ingen har mätt? Se på sidan Konstruktion: det slag som är bäst i detta berg förlorar mycket i mjukare och mer fjädrande berg, ett längre med samma energi mindre. Kommandot är `drillwave design piston_for_unknown_rock`; blocket design innehåller dess inställningar.</translation>
    </message>
    <message>
        <source>Share of the energy of a wave that is lost in the joint at the end towards the rock: 3 to 6 % with tight threads, 6 to 10 % with worn threads (trade texts, not measured)</source>
        <translation>Andel av en vågs energi som går förlorad i skarven vid änden mot berget: 3 till 6 % med åtdragna gängor, 6 till 10 % med slitna gängor (facktexter, inte uppmätt)</translation>
    </message>
    <message>
        <source>enough for this blow only</source>
        <translation>räcker bara för detta slag</translation>
    </message>
    <message>
        <source>rock</source>
        <translation>berg</translation>
    </message>
    <message>
        <source>effective feed force over the largest of the four required ones, less 1, if the scenario gives them; takes a study of all gaps</source>
        <translation>verksam matningskraft genom den största av de fyra som krävs, minus 1, när scenariot har dem; kräver en studie av alla spalter</translation>
    </message>
</context>
<context>
    <name>drillwave</name>
    <message>
        <source>it is damaged, or written by another version of the program</source>
        <translation>den är skadad, eller skriven av en annan version av programmet</translation>
    </message>
    <message>
        <source>No value has statistics.</source>
        <translation>Inget värde har någon statistik.</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>större än %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>minst %1</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>över %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>från %1</translation>
    </message>
    <message>
        <source>%1 to below %2</source>
        <translation>%1 till under %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 till %2</translation>
    </message>
    <message>
        <source>Range: %1; usual: %2 – %3.</source>
        <translation>Område: %1; vanligt: %2 – %3.</translation>
    </message>
    <message>
        <source>F1: its place in the manual.</source>
        <translation>F1: dess plats i handboken.</translation>
    </message>
    <message>
        <source>kept in the scenario itself</source>
        <translation>finns i själva scenariot</translation>
    </message>
    <message>
        <source>%1 points, scaled to t₀ and I₀, %2</source>
        <translation>%1 punkter, skalade till t₀ och I₀, %2</translation>
    </message>
    <message>
        <source>%1 points, %2, %3, %4</source>
        <translation>%1 punkter, %2, %3, %4</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>rad %1: %2</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>får inte vara negativ</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>måste vara större än 0</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>får inte vara 0</translation>
    </message>
    <message>
        <source>%1: unit</source>
        <translation>%1: enhet</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>med %1</translation>
    </message>
    <message>
        <source>by less than %1</source>
        <translation>med mindre än %1</translation>
    </message>
    <message>
        <source>With the present rod and rock this changes e = %1 %2.</source>
        <translation>Med den stång och det berg som visas ändrar det e = %1 %2.</translation>
    </message>
    <message>
        <source>Impulse %1, peak %2 at %3 in the file.</source>
        <translation>Impuls %1, topp %2 vid %3 i filen.</translation>
    </message>
    <message>
        <source>All of the %1 samples are kept, of %2 in the record.</source>
        <translation>Alla %1 mätvärden behålls, av %2 i inspelningen.</translation>
    </message>
    <message>
        <source>%1 of %2 samples become %3 points: no sample is further than %4 (%5 of the peak) from the lines between the points; the impulse changes by %6.</source>
        <translation>%1 av %2 mätvärden blir %3 punkter: inget använt mätvärde ligger längre än %4 (%5 av toppen) från linjerna mellan dem, impulsen ändras med %6.</translation>
    </message>
    <message>
        <source>%1 negative samples are clipped, which adds %2 to the impulse.</source>
        <translation>%1 negativa mätvärden klipps bort, vilket lägger %2 till impulsen.</translation>
    </message>
    <message>
        <source>This is a large change: use a shorter part of the record.</source>
        <translation>Det är mycket: ta en mindre del av inspelningen.</translation>
    </message>
    <message>
        <source>%1 rows without a number are skipped, the first is line %2.</source>
        <translation>%1 rader utan tal hoppas över, den första är rad %2.</translation>
    </message>
    <message>
        <source>hammer blow</source>
        <translation>hammarslag</translation>
    </message>
    <message>
        <source>elastic hammer</source>
        <translation>elastisk hammare</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>skillnader</translation>
    </message>
    <message>
        <source>nothing differs</source>
        <translation>inga skillnader</translation>
    </message>
    <message>
        <source>results</source>
        <translation>resultat</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>storhet</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>enhet</translation>
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
        <translation>detta scenario</translation>
    </message>
    <message>
        <source>COR e</source>
        <translation>studstal e</translation>
    </message>
    <message>
        <source>not solved yet</source>
        <translation>ännu inte löst</translation>
    </message>
    <message>
        <source>not solved: %1</source>
        <translation>inte löst: %1</translation>
    </message>
    <message>
        <source>no such result here</source>
        <translation>inget sådant resultat här</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>yield strength %1</source>
        <translation>sträckgräns %1</translation>
    </message>
    <message>
        <source>fatigue strength %1</source>
        <translation>utmattningsgräns %1</translation>
    </message>
    <message>
        <source>yield strengths</source>
        <translation>sträckgränser</translation>
    </message>
    <message>
        <source>fatigue strengths</source>
        <translation>utmattningsgränser</translation>
    </message>
    <message>
        <source>hammer %1</source>
        <translation>hammare %1</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>sektion %1</translation>
    </message>
    <message>
        <source>No curve on this axis has positive values.</source>
        <translation>Ingen kurva på denna axel har positiva värden.</translation>
    </message>
    <message>
        <source>Curves on this axis have negative values; hide them first.</source>
        <translation>Kurvor på denna axel har negativa värden; dölj dem först.</translation>
    </message>
    <message>
        <source>%1 at A</source>
        <translation>%1 vid A</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>%1 at B</source>
        <translation>%1 vid B</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>%1 from A to B</source>
        <translation>%1 från A till B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>mv</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>lutning</translation>
    </message>
    <message>
        <source>integral</source>
        <translation>integral</translation>
    </message>
    <message>
        <source>∫</source>
        <translation>∫</translation>
    </message>
    <message>
        <source>least %1 in view</source>
        <translation>minsta %1 i vyn</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>%1 of the least</source>
        <translation>%1 för det minsta</translation>
    </message>
    <message>
        <source>at</source>
        <translation>vid</translation>
    </message>
    <message>
        <source>largest %1 in view</source>
        <translation>största %1 i vyn</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>%1 of the largest</source>
        <translation>%1 för det största</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 från</translation>
    </message>
    <message>
        <source>from</source>
        <translation>från</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 till</translation>
    </message>
    <message>
        <source>to</source>
        <translation>till</translation>
    </message>
    <message>
        <source>mean in view</source>
        <translation>medel i vyn</translation>
    </message>
    <message>
        <source>integral in view</source>
        <translation>integral i vyn</translation>
    </message>
    <message>
        <source>Width and height must be from %1 to %2 mm.</source>
        <translation>Bredd och höjd måste ligga mellan %1 och %2 mm.</translation>
    </message>
    <message>
        <source>The resolution must be from %1 to %2 dpi.</source>
        <translation>Upplösningen måste ligga mellan %1 och %2 dpi.</translation>
    </message>
    <message>
        <source>That is more than %1 million pixels: choose a smaller size or a lower resolution.</source>
        <translation>Det är mer än %1 miljoner bildpunkter: välj mindre mått eller lägre upplösning.</translation>
    </message>
    <message>
        <source>Scenarios (*.yaml *.yml);;All files (*)</source>
        <translation>Scenarier (*.yaml *.yml);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Scenarios and results (*.yaml *.yml *.csv *.json *.html);;All files (*)</source>
        <translation>Scenarier och resultat (*.yaml *.yml *.csv *.json *.html);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Osparade ändringar</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Spara ändringarna i ”%1”?</translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation>Annars går de förlorade.</translation>
    </message>
    <message>
        <source>Drillwave</source>
        <translation>Drillwave</translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation>Stäng ändå</translation>
    </message>
    <message>
        <source>Open a scenario</source>
        <translation>Öppna ett scenario</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>Spara scenariot</translation>
    </message>
    <message>
        <source>Export everything into a folder</source>
        <translation>Exportera allt till en mapp</translation>
    </message>
    <message>
        <source>Unsaved changes found</source>
        <translation>Osparade ändringar hittades</translation>
    </message>
    <message>
        <source>Restore the unsaved changes to “%1”?</source>
        <translation>Återställa de osparade ändringarna i ”%1”?</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Återställ</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Kasta</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Senare</translation>
    </message>
    <message>
        <source>Numerical error ± %1</source>
        <translation>Numeriskt fel ± %1</translation>
    </message>
    <message>
        <source>in the hammer, %1</source>
        <translation>i hammaren, %1</translation>
    </message>
    <message>
        <source>at x/L = %1, t = %2</source>
        <translation>vid x/L = %1, t = %2</translation>
    </message>
    <message>
        <source>Place and time where this value is first reached: a click leads there</source>
        <translation>Var i stången det först är så stort, och när: ett klick leder dit</translation>
    </message>
    <message>
        <source>margin, this blow</source>
        <translation>marginal, detta slag</translation>
    </message>
    <message>
        <source>installed</source>
        <translation>installerad</translation>
    </message>
    <message>
        <source>Feed force of the drill rig</source>
        <translation>Borriggens matningskraft</translation>
    </message>
    <message>
        <source>Coefficient of restitution: momentum after the blow over momentum before it, reversed, e = −pf/p0</source>
        <translation>Studstal: rörelsemängd efter slaget genom rörelsemängd före, omvänd, e = −pf/p0</translation>
    </message>
    <message>
        <source>Difference from %1</source>
        <translation>Så mycket skiljer det från %1</translation>
    </message>
    <message>
        <source>%1, against %2: %3</source>
        <translation>%1, mot %2: %3</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>ingen %1</translation>
    </message>
    <message>
        <source>divides by zero</source>
        <translation>delar med noll</translation>
    </message>
    <message>
        <source>has no number where one is needed</source>
        <translation>saknar tal där ett behövs</translation>
    </message>
    <message>
        <source>has too many brackets in each other</source>
        <translation>har för många parenteser i varandra</translation>
    </message>
    <message>
        <source>lacks a closing bracket; a unit follows it</source>
        <translation>saknar en högerparentes; en enhet står efter den</translation>
    </message>
    <message>
        <source>is too large</source>
        <translation>är för stort</translation>
    </message>
    <message>
        <source>can mean %1 or %2: write it without the separator, or as %3</source>
        <translation>kan betyda %1 eller %2: skriv det utan skiljetecken, eller som %3</translation>
    </message>
    <message>
        <source>is not one number: remove the separators of its digits</source>
        <translation>är inte ett tal: ta bort skiljetecknen mellan siffrorna</translation>
    </message>
    <message>
        <source>has more than one line: give one value</source>
        <translation>är mer än en rad: ett värde behövs</translation>
    </message>
    <message>
        <source>The program ended unexpectedly; the last change was at %1.</source>
        <translation>Programmet avslutades oväntat; den senaste ändringen är från %1.</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier run cannot be restored.</source>
        <translation>Osparade ändringar från en tidigare körning kan inte återställas.</translation>
    </message>
    <message>
        <source>%1
The file is kept as %2 and not offered again.</source>
        <translation>%1
Filen sparas som %2 och erbjuds inte igen.</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>denna rapport</translation>
    </message>
    <message>
        <source>what</source>
        <translation>storhet</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>förskjutning</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>peaks differ by</source>
        <translation>topparna skiljer</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>eftersläpning</translation>
    </message>
    <message>
        <source>force N at %1</source>
        <translation>kraft N vid %1</translation>
    </message>
    <message>
        <source>impact force</source>
        <translation>stötkraft</translation>
    </message>
    <message>
        <source>where &quot;%1&quot; was measured</source>
        <translation>där ”%1” mättes</translation>
    </message>
    <message>
        <source>Measured signals are dashed.</source>
        <translation>Det uppmätta är streckat.</translation>
    </message>
    <message>
        <source>Force over penetration: the area inside stays in the rock as energy.</source>
        <translation>Kraft över inträngning: den inneslutna ytan stannar som energi i berget.</translation>
    </message>
    <message>
        <source>The force in the rod over place and time, tension positive; bars at the right show contact of bit and rock. On the colour scale, lines mark the smallest and largest force, triangles forces beyond the colours.</source>
        <translation>Kraften i stången över läge och tid, drag positivt; staplar till höger visar kontakten mellan krona och berg. På färgskalan är ett streck den minsta eller största kraften, en triangel en bortom färgerna.</translation>
    </message>
    <message>
        <source>Hammer (dark) and string, lengths and diameters each to scale, with the numbers of the sections; the bore is dashed, the rock is at the right.</source>
        <translation>Hammare (mörk) och sträng skalenligt, längder och diametrar var för sig, med sektionernas nummer; spolhålet är streckat, berget till höger.</translation>
    </message>
    <message>
        <source>Restitution over one period of the gap between bit and rock, and its distribution when all gaps are equally likely.</source>
        <translation>Studstal över en period av spalten mellan krona och berg, och hur det är fördelat när alla spalter är lika sannolika.</translation>
    </message>
    <message>
        <source>Required and installed feed force over the blow frequency.</source>
        <translation>Behov av matningskraft och den installerade över slagfrekvensen.</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>sida %1 av %2</translation>
    </message>
    <message>
        <source>feed force margin, this blow</source>
        <translation>matningskraftens marginal, detta slag</translation>
    </message>
    <message>
        <source>feed force required at every gap</source>
        <translation>matningskraft som räcker vid varje spalt</translation>
    </message>
    <message>
        <source>feed force margin at every gap</source>
        <translation>matningskraftens marginal vid varje spalt</translation>
    </message>
    <message>
        <source>hammer energy E₀</source>
        <translation>hammarenergi E₀</translation>
    </message>
    <message>
        <source>Energy of the hammer before the blow; all shares refer to it. Its work on the string is smaller.</source>
        <translation>Hammarens energi före slaget; alla andelar är av den, dess arbete på strängen är mindre</translation>
    </message>
    <message>
        <source>Effective feed force minus the feed force required by this blow, also as a share of it</source>
        <translation>Verksam matningskraft minus vad detta slag kräver, och som andel av det</translation>
    </message>
    <message>
        <source>required, this blow</source>
        <translation>krävs, detta slag</translation>
    </message>
    <message>
        <source>Mean force that balances this blow, which starts at rest on the rock</source>
        <translation>Medelkraft som balanserar detta slag, som börjar i vila på berget</translation>
    </message>
    <message>
        <source>return in time</source>
        <translation>återkomst i tid</translation>
    </message>
    <message>
        <source>At this feed an undamped rigid rod is back at the rock before the next blow</source>
        <translation>Vid denna matningskraft är en odämpad stel stång tillbaka vid berget före nästa slag</translation>
    </message>
    <message>
        <source>required, every gap</source>
        <translation>krävs, varje spalt</translation>
    </message>
    <message>
        <source>The largest force required by this blow, by 95 % of all gaps, on rigid rock, and by the worst gap on elastic rock</source>
        <translation>Den största kraft som krävs: av detta slag, av 95 % av alla spalter, på stelt berg och av den sämsta spalten på elastiskt berg</translation>
    </message>
    <message>
        <source>Effective feed force minus the largest of the four, also as a share of it: thrust_margin in commands and files</source>
        <translation>Verksam matningskraft minus den största av de fyra, och som andel av den: thrust_margin i kommandon och filer</translation>
    </message>
    <message>
        <source>They leave a gap of %1, which is filled by a straight line.</source>
        <translation>De lämnar ett gap på %1 som en rät linje korsar.</translation>
    </message>
    <message>
        <source>NUL bytes end the table: the recorder did not fill its file.</source>
        <translation>NUL-byte avslutar tabellen: mätinstrumentet fyllde inte sin fil.</translation>
    </message>
    <message>
        <source>Restart &amp;now</source>
        <translation>Starta om &amp;nu</translation>
    </message>
    <message>
        <source>The changes were made to %1, which stays as it is until you save.</source>
        <translation>De gjordes i %1, som inte ändras förrän du sparar.</translation>
    </message>
    <message>
        <source>Some pinned runs cannot be restored.</source>
        <translation>Några fästa körningar kan inte återställas.</translation>
    </message>
    <message>
        <source>Table: separator, decimal sign, the first line with a sample and the columns are found out; change what is wrong. A unit or a sampling rate that the table does not state has to be chosen.
Signal: force, strain, output of a bridge, voltage, stress or velocity in the unit of the column. A strain becomes a force by E and the area of the rod, of the string where the gauge is, or of another bar; a voltage by a calibration, or by gain, excitation and bridge factor; a velocity by the impedance. Tension is positive in the rod; a blow presses.
Zero line: the mean of the first samples, in which nothing happens.
Range: “Peak” takes the stretch around the largest value, “View” what the plot shows (Ctrl+wheel and Shift+drag zoom there), “All” the whole record.
Points at most: a blow keeps as few samples as leave impulse and e the same to 1e-4, unless you choose a number; a curve keeps so many. The summary says how far the others are from the lines between them.</source>
        <translation>Tabell: avgränsare, decimaltecken, första raden med ett mätvärde och kolumnerna hittas; ändra det som är fel. Det som inte står i tabellen, till exempel en enhet eller samplingsfrekvensen, ska väljas.
Signal: kraft, töjning, utsignal från en brygga, elektrisk spänning, mekanisk spänning eller hastighet i kolumnens enhet. En töjning blir en kraft genom E och arean hos stången, strängen vid givaren eller en annan stång; volt genom en kalibrering eller genom förstärkning, matning och bryggfaktor; en hastighet genom impedansen. Drag är positivt i stången; ett slag trycker.
Nollinje: medelvärdet av de första mätvärdena, då ingenting händer.
Område: ”Topp” tar stycket kring det största värdet, ”Vy” det som bilden visar (Ctrl+hjul och Skift+dra zoomar där), ”Allt” hela mätningen.
Högst antal punkter: ett slag behåller så få mätvärden att impuls och e är lika till 1e-4, så länge du inte väljer ett antal; en kurva behåller så många. Sammanfattningen säger hur långt de övriga är från linjerna emellan.</translation>
    </message>
    <message>
        <source>sections that differ</source>
        <translation>sektioner som skiljer sig</translation>
    </message>
    <message>
        <source>Continuous drilling: gap and penetration of every blow, how the gaps scatter and follow each other, and the shares of the energy.</source>
        <translation>Kontinuerlig borrning: spalt och inträngning för varje slag, hur spalterna sprids och följer på varandra, och energins andelar.</translation>
    </message>
    <message>
        <source>Penetration rate, contact and gaps of continuous drilling over one parameter.</source>
        <translation>Borrsjunkning, kontakt och spalter vid kontinuerlig borrning över en parameter.</translation>
    </message>
    <message>
        <source>The designs: the first aim over the choice, with its scatter. Several aims and several uncertain inputs are compared below.</source>
        <translation>Konstruktionerna: det första målet över valet, med sin spridning. Flera mål och flera osäkra indata jämförs därunder.</translation>
    </message>
    <message>
        <source>gain of the amplifier [%]</source>
        <translation>förstärkarens förstärkning [%]</translation>
    </message>
    <message>
        <source>zero line [% of the peak]</source>
        <translation>nollinje [% av toppen]</translation>
    </message>
    <message>
        <source>place of the gauge</source>
        <translation>givarens läge</translation>
    </message>
    <message>
        <source>Identify needs a scenario with physical units: a record of a gauge is in seconds and newtons. Edit ▸ Make a rig of these groups makes one.</source>
        <translation>Identifiera behöver ett scenario med fysiska enheter: en givares inspelning är i sekunder och newton. Redigera ▸ Gör en rigg av dessa tal skapar ett.</translation>
    </message>
    <message>
        <source>Choose the column of the gauge.</source>
        <translation>Välj givarens kolumn.</translation>
    </message>
    <message>
        <source>Type the distance of gauge %1 from the bit face.</source>
        <translation>Skriv avståndet från borrkronan för givare %1.</translation>
    </message>
    <message>
        <source>Gauge %1 is not on a uniform section of the rod or string: correct its distance from the bit face.</source>
        <translation>Givare %1 sitter inte på en likformig sektion av stången eller strängen: rätta dess avstånd från borrkronan.</translation>
    </message>
    <message>
        <source>Identify reads stiffness and elasticity of the rock, and the gap between bit and rock, from strain gauges on the rod. Open a record of one blow, or of several blows along a hole.</source>
        <translation>Sidan Identifiera bestämmer bergets styvhet och elasticitet och spalten mellan borrkrona och berg ur mätningar med töjningsgivare på stången. Öppna inspelningen av ett slag, eller av flera slag längs ett borrhål.</translation>
    </message>
    <message>
        <source>During the blow, the largest compression is %1 (%2), the largest tension %3 (%4).</source>
        <translation>Under slaget är den största tryckspänningen %1 (%2), den största dragspänningen %3 (%4).</translation>
    </message>
    <message>
        <source>x/L = %1</source>
        <translation>x/L = %1</translation>
    </message>
    <message>
        <source>%1 from the face of the hammer</source>
        <translation>%1 från hammarens slagyta</translation>
    </message>
</context>
<context>
    <name>drillwave::AccuracyPage</name>
    <message>
        <source>Error against run time, or the hardest cases against their limits</source>
        <translation>Fel mot beräkningstid, eller de svåraste fallen mot sina gränser</translation>
    </message>
    <message>
        <source>This scenario</source>
        <translation>Detta scenario</translation>
    </message>
    <message>
        <source>The worst first; a click loads a case</source>
        <translation>De sämsta först; ett klick laddar ett fall</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Beräkna</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Hard test cases (uniform rods)</source>
        <translation>Svåra testfall (likformiga stänger)</translation>
    </message>
    <message>
        <source>Solve this scenario with every method and measure errors and times</source>
        <translation>Lös detta scenario med alla metoder och mät fel och tider</translation>
    </message>
    <message>
        <source>Solve and check some thousand stiff and extreme cases</source>
        <translation>Lös och kontrollera några tusen styva och extrema fall</translation>
    </message>
    <message>
        <source>Press “Run” under “Settings” to compare the errors and run times of all methods for this scenario.</source>
        <translation>Tryck på ”Beräkna” under ”Inställningar” för att jämföra alla metoders fel och tider för detta scenario.</translation>
    </message>
    <message>
        <source>Run solves and checks some thousand stiff and extreme cases.</source>
        <translation>Beräkna löser och kontrollerar några tusen styva och extrema fall.</translation>
    </message>
    <message>
        <source>Cases that break solvers, each with all its checks, the worst first. A click loads a case.</source>
        <translation>Fall som knäcker lösare, vart och ett med alla kontroller, de sämsta först. Ett klick laddar ett fall.</translation>
    </message>
    <message>
        <source>The efficiency of %1 is accurate to %2, the error bound of the method.</source>
        <translation>Verkningsgraden %1 är noggrann på %2 när (metodens felgräns).</translation>
    </message>
    <message>
        <source>Accuracy of the results, and the results of other methods.</source>
        <translation>Hur riktiga talen är, och vad andra metoder ger.</translation>
    </message>
    <message>
        <source>e = %1 is accurate to %2, the error bound of the exact solver.</source>
        <translation>e = %1 är noggrant på %2 när (den exakta metodens felgräns).</translation>
    </message>
    <message>
        <source>load the case %1</source>
        <translation>ladda fallet %1</translation>
    </message>
    <message>
        <source>The study is not finished yet.</source>
        <translation>Studien är inte färdig än.</translation>
    </message>
    <message>
        <source>The study was stopped before its end: run it again.</source>
        <translation>Studien stoppades före slutet: beräkna igen.</translation>
    </message>
    <message>
        <source>There is nothing to write: run the study first.</source>
        <translation>Det finns inget att skriva: beräkna studien först.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Noggrannhet</translation>
    </message>
    <message>
        <source>method</source>
        <translation>metod</translation>
    </message>
    <message>
        <source>case</source>
        <translation>fall</translation>
    </message>
    <message>
        <source>Run (%1 s)</source>
        <translation>Beräkna (%1 s)</translation>
    </message>
    <message>
        <source>Solving with the most exact method …</source>
        <translation>Löser med den noggrannaste metoden …</translation>
    </message>
</context>
<context>
    <name>drillwave::AimRow</name>
    <message>
        <source>Maximise or minimise</source>
        <translation>Störst eller minst</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>störst</translation>
    </message>
    <message>
        <source>Statistic</source>
        <translation>Efter vilken statistik</translation>
    </message>
    <message>
        <source>Remove this aim</source>
        <translation>Ta bort detta mål</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>störst %1</translation>
    </message>
    <message>
        <source>least %1</source>
        <translation>minst %1</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>minst</translation>
    </message>
</context>
<context>
    <name>drillwave::AimRows</name>
    <message>
        <source>+ aim</source>
        <translation>+ mål</translation>
    </message>
    <message>
        <source>Adds an objective. The first one decides; the others show the trade-off.</source>
        <translation>Lägger till ett mål. Det första avgör; de andra visar avvägningen.</translation>
    </message>
    <message>
        <source>for the</source>
        <translation>för</translation>
    </message>
    <message>
        <source>then the</source>
        <translation>sedan</translation>
    </message>
</context>
<context>
    <name>drillwave::AlertLink</name>
    <message>
        <source>✖ not solved</source>
        <translation>✖ inte löst</translation>
    </message>
    <message>
        <source>⚠ 1 warning</source>
        <translation>⚠ 1 varning</translation>
    </message>
    <message>
        <source>⚠ %1 warnings</source>
        <translation>⚠ %1 varningar</translation>
    </message>
    <message>
        <source>ℹ 1 note</source>
        <translation>ℹ 1 anmärkning</translation>
    </message>
    <message>
        <source>ℹ %1 notes</source>
        <translation>ℹ %1 anmärkningar</translation>
    </message>
</context>
<context>
    <name>drillwave::AlertList</name>
    <message>
        <source>Not solved</source>
        <translation>Inte löst</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Varning</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Anmärkning</translation>
    </message>
    <message>
        <source>Nothing unusual</source>
        <translation>Inget ovanligt</translation>
    </message>
    <message>
        <source>Nothing unusual.</source>
        <translation>Inget ovanligt.</translation>
    </message>
    <message>
        <source>Go to “%1”</source>
        <translation>Gå till ”%1”</translation>
    </message>
</context>
<context>
    <name>drillwave::AreaKeys</name>
    <message>
        <source>Next &amp;area</source>
        <translation>Nästa &amp;område</translation>
    </message>
    <message>
        <source>Pre&amp;vious area</source>
        <translation>Före&amp;gående område</translation>
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
        <translation>%1: parameter</translation>
    </message>
    <message>
        <source>%1: logarithmic</source>
        <translation>%1: logaritmisk</translation>
    </message>
    <message>
        <source>Even ratios instead of even steps</source>
        <translation>Lika förhållanden i stället för lika steg</translation>
    </message>
    <message>
        <source>from</source>
        <translation>från</translation>
    </message>
    <message>
        <source>to</source>
        <translation>till</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, enhet</translation>
    </message>
    <message>
        <source>must be greater than 0 on a logarithmic axis</source>
        <translation>måste vara större än 0 på en logaritmisk axel</translation>
    </message>
    <message>
        <source>must differ from the other end</source>
        <translation>måste skilja sig från den andra änden</translation>
    </message>
</context>
<context>
    <name>drillwave::BlowPage</name>
    <message>
        <source>rms %1 · peaks differ by %2</source>
        <translation>rms %1 · topparna skiljer %2</translation>
    </message>
    <message>
        <source> · lag %1</source>
        <translation> · eftersläpning %1</translation>
    </message>
    <message>
        <source>Values at the time cursor: normal force at the section, impact force, impulse, momentum</source>
        <translation>Värden vid tidsmarkören: normalkraft i tvärsnittet, stötkraft, impuls, rörelsemängd</translation>
    </message>
    <message>
        <source>Waves, impact force, impulse and momentum over time</source>
        <translation>Vågor, stötkraft, impuls och rörelsemängd över tiden</translation>
    </message>
    <message>
        <source>Section x/L</source>
        <translation>Läge x/L</translation>
    </message>
    <message>
        <source>Bring all curves into view (double-click in the plots)</source>
        <translation>Visa alla kurvor i sin helhet (dubbelklick i diagrammen)</translation>
    </message>
    <message>
        <source>To mark a time, press T over the plots or click an event in Result.</source>
        <translation>Markera tid: T över diagrammen eller klick på en händelse i resultatet.</translation>
    </message>
    <message>
        <source>t = %1 · N = %2 · F = %3 · I = %4 · p = %5</source>
        <translation>t = %1 · N = %2 · F = %3 · I = %4 · p = %5</translation>
    </message>
    <message>
        <source>Nothing to show: this blow has too many waves to keep.</source>
        <translation>Inget att visa: detta slag har fler vågor än vad som kan sparas.</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Inget att visa: %1</translation>
    </message>
    <message>
        <source>Blow</source>
        <translation>Slag</translation>
    </message>
    <message>
        <source>Ctrl+wheel zooms · drag moves · double-click fits</source>
        <translation>Ctrl+hjul zoomar · dra flyttar · dubbelklick anpassar</translation>
    </message>
    <message>
        <source>The largest impact force on the rock is %1, at %2.</source>
        <translation>Den största kraften mot berget är %1, vid %2.</translation>
    </message>
    <message>
        <source>At %1, the force in this plot is between %2 (compression) and %3 (tension).</source>
        <translation>Vid %1 ligger kraften i detta diagram mellan %2 (tryck) och %3 (drag).</translation>
    </message>
    <message>
        <source>Section at which the waves are shown: 0 is the struck end, 1 the bit.
N₀ₚ is the first wave to the bit, N₁ₙ its reflection from the bit, N₂ₚ from the rear end, N₃ₙ again from the bit.</source>
        <translation>Snitt där vågorna visas: 0 är slagänden, 1 borrkronan.
N₀ₚ är den första vågen mot kronan, N₁ₙ dess reflexion från kronan, N₂ₚ från bakänden, N₃ₙ åter från kronan.</translation>
    </message>
    <message>
        <source>0: struck end, 1: bit</source>
        <translation>0: slagänden, 1: borrkronan</translation>
    </message>
</context>
<context>
    <name>drillwave::BlowPlots</name>
    <message>
        <source>impact force F</source>
        <translation>stötkraft F</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>sluten form</translation>
    </message>
    <message>
        <source>force of the hammer on the string</source>
        <translation>hammarens kraft på strängen</translation>
    </message>
    <message>
        <source>impulse of the impact force I</source>
        <translation>stötkraftens impuls I</translation>
    </message>
    <message>
        <source>momentum of the rod p</source>
        <translation>stångens rörelsemängd p</translation>
    </message>
    <message>
        <source>Nₚ to the bit</source>
        <translation>Nₚ mot borrkronan</translation>
    </message>
    <message>
        <source>Nₙ from the bit</source>
        <translation>Nₙ från borrkronan</translation>
    </message>
    <message>
        <source>momentum of the string p</source>
        <translation>strängens rörelsemängd p</translation>
    </message>
    <message>
        <source>closed form, error of e &lt; %1</source>
        <translation>sluten form, fel i e &lt; %1</translation>
    </message>
    <message>
        <source>waves at x/L = %1 (p to the bit, n from it)</source>
        <translation>vågor vid x/L = %1 (p fram, n tillbaka)</translation>
    </message>
    <message>
        <source>N, tension +</source>
        <translation>N, drag +</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>tid t</translation>
    </message>
    <message>
        <source>Four plots over time from 0 to %1. %2: largest N %3, wave to the bit %4, from the bit %5. Impact force up to %6, force of the hammer on the string up to %7. Impulse up to %8. Momentum of the string up to %9.</source>
        <translation>Fyra diagram över tiden från 0 till %1. %2: största N %3, våg mot borrkronan %4, från borrkronan %5. Stötkraft upp till %6, hammarens kraft på strängen upp till %7. Impuls upp till %8. Strängens rörelsemängd upp till %9.</translation>
    </message>
    <message>
        <source>Four plots over time from 0 to %1. Largest values at x/L = %2: normal force N %10, incident wave N0p %3, its reflection from the bit N1n %4, then from the rear end N2p %5 and again from the bit N3n %6. Impact force up to %7. Impulse up to %8. Momentum of the rod up to %9.</source>
        <translation>Fyra diagram över tiden från 0 till %1. Största värden vid x/L = %2: normalkraft N %10, infallande våg N0p %3, dess reflexion från kronan N1n %4, sedan från bakänden N2p %5 och åter från kronan N3n %6. Stötkraft upp till %7. Impuls upp till %8. Stångens rörelsemängd upp till %9.</translation>
    </message>
    <message>
        <source>%1, %2 from its rear</source>
        <translation>%1, %2 från dess bakände</translation>
    </message>
</context>
<context>
    <name>drillwave::CompareModel</name>
    <message>
        <source>reference</source>
        <translation>referens</translation>
    </message>
</context>
<context>
    <name>drillwave::ComparePage</name>
    <message>
        <source>No runs are pinned yet.

F7 (or Pin, at the right of the tabs) keeps the present result with its scenario. Then change something and pin again: the runs are shown here side by side, and in the plots of the other pages.

On the pages of studies, Shift+click pins the point under the pointer.</source>
        <translation>Inga körningar är fästa ännu.

F7 (eller Fäst, till höger om flikarna) behåller det aktuella resultatet med sitt scenario. Ändra sedan något och fäst igen: körningarna står här sida vid sida, och ligger över diagrammen på de andra sidorna.

På studiernas sidor fäster Skift och ett klick punkten under pekaren.</translation>
    </message>
    <message>
        <source>Reference of all differences: here, in the list of runs and in the result</source>
        <translation>Vad skillnaderna räknas från: här, i listan över körningar och i resultatet</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Jämför med</translation>
    </message>
    <message>
        <source>Revert to this run</source>
        <translation>Återgå till denna körning</translation>
    </message>
    <message>
        <source>Loads the scenario of the selected run; Undo takes it back</source>
        <translation>Tar tillbaka scenariot för den körning vars kolumn är vald, som ett steg som kan ångras</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
    <message>
        <source>The whole table with all digits, for a spreadsheet</source>
        <translation>Hela tabellen med alla siffror, för ett kalkylark</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Spara som CSV…</translation>
    </message>
    <message>
        <source>Runs side by side</source>
        <translation>Körningar sida vid sida</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Jämförelse</translation>
    </message>
    <message>
        <source>Compare (%1)</source>
        <translation>Jämförelse (%1)</translation>
    </message>
    <message>
        <source>the present result</source>
        <translation>det aktuella resultatet</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nu</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>Återgå till %1</translation>
    </message>
    <message>
        <source>No runs are pinned.</source>
        <translation>Inga körningar är fästa.</translation>
    </message>
    <message>
        <source>The present result is not solved yet.</source>
        <translation>Det aktuella resultatet är inte löst än.</translation>
    </message>
    <message>
        <source>&amp;Data of this table…</source>
        <translation>&amp;Data i denna tabell…</translation>
    </message>
    <message>
        <source>Runs side by side with their differences, as CSV in the units on show</source>
        <translation>Körningar sida vid sida med sina skillnader, som CSV i de visade enheterna</translation>
    </message>
</context>
<context>
    <name>drillwave::ContactBarsItem</name>
    <message>
        <source>bit touches rock</source>
        <translation>krona mot berg</translation>
    </message>
</context>
<context>
    <name>drillwave::CursorBar</name>
    <message>
        <source>Curve to read</source>
        <translation>Kurva som avläses</translation>
    </message>
    <message>
        <source>Curve whose values are read; a click on a curve selects it</source>
        <translation>Kurvan som avläses; ett klick på en kurva väljer den</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
    <message>
        <source>Copy the readings</source>
        <translation>Kopiera avläsningen</translation>
    </message>
    <message>
        <source>This table with all digits, to paste into a spreadsheet</source>
        <translation>Denna tabell med alla siffror, att klistra in i ett kalkylark</translation>
    </message>
    <message>
        <source>Remove the cursors A and B</source>
        <translation>Ta bort markörerna A och B</translation>
    </message>
    <message>
        <source>Cursors: %1</source>
        <translation>Markörer: %1</translation>
    </message>
    <message>
        <source>In view: %1</source>
        <translation>I vyn: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::CurveMarks</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 vid %2</translation>
    </message>
    <message>
        <source>kink %1</source>
        <translation>knäck %1</translation>
    </message>
</context>
<context>
    <name>drillwave::CurvePage</name>
    <message>
        <source>A result over a parameter</source>
        <translation>Ett resultat över en parameter</translation>
    </message>
    <message>
        <source>vary</source>
        <translation>variera</translation>
    </message>
    <message>
        <source>curves for</source>
        <translation>kurvor för</translation>
    </message>
    <message>
        <source>this scenario</source>
        <translation>detta scenario</translation>
    </message>
    <message>
        <source>Also a curve for the scenario&apos;s own value of the family</source>
        <translation>En kurva även för det värde i skaran som scenariot har</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>sluten form</translation>
    </message>
    <message>
        <source>The paper&apos;s analytical solution, drawn where it is valid: rectangular blow, elastic rock (γ = 1)</source>
        <translation>Artikelns analytiska lösning, streckad där den gäller: rektangulärt slag, elastiskt berg (γ = 1)</translation>
    </message>
    <message>
        <source>Rod without waves</source>
        <translation>Stång utan vågor</translation>
    </message>
    <message>
        <source>A rod that arrives without waves, dotted, over its stiffness in one of two units</source>
        <translation>Stången som kommer fram utan vågor, prickad, över sin styvhet i en av två enheter</translation>
    </message>
    <message>
        <source>no curve to compare with</source>
        <translation>ingen jämförelsekurva</translation>
    </message>
    <message>
        <source>rod without waves, k₀ = Z/(2T)</source>
        <translation>stång utan vågor, k₀ = Z/(2T)</translation>
    </message>
    <message>
        <source>rod without waves, k₀ = Z/t₀</source>
        <translation>stång utan vågor, k₀ = Z/t₀</translation>
    </message>
    <message>
        <source>Points of a curve</source>
        <translation>Punkter på en kurva</translation>
    </message>
    <message>
        <source>Number of blows solved along a curve of a drill string</source>
        <translation>Hur många slag som löses längs en kurva för en borrsträng</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punkter</translation>
    </message>
    <message>
        <source>Efficiency–stiffness</source>
        <translation>Verkningsgrad–styvhet</translation>
    </message>
    <message>
        <source>COR–stiffness</source>
        <translation>e–styvhet</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>mål</translation>
    </message>
</context>
<context>
    <name>drillwave::DensityMark</name>
    <message>
        <source>Density</source>
        <translation>Täthet</translation>
    </message>
    <message>
        <source>Frequency of the values, from the smallest to the largest</source>
        <translation>Hur ofta värden förekommer, från det minsta till det största</translation>
    </message>
</context>
<context>
    <name>drillwave::DesignCard</name>
    <message>
        <source>&lt;b&gt;This scenario&lt;/b&gt;</source>
        <translation>&lt;b&gt;Detta scenario&lt;/b&gt;</translation>
    </message>
    <message>
        <source>The samples do not distinguish this design from %1: any of them will do.</source>
        <translation>Stickproven skiljer inte denna konstruktion från %1: vilken som helst duger.</translation>
    </message>
    <message>
        <source>Among them, %1 has the %2: %3.</source>
        <translation>Av dem har %1 %2: %3.</translation>
    </message>
    <message>
        <source>The best design for the values entered, %1, has an objective that is %2&#xa0;% smaller %3.</source>
        <translation>För den bästa konstruktionen för de angivna värdena, %1, är målstorheten %2&#xa0;% mindre %3.</translation>
    </message>
    <message>
        <source>The best design for the values entered, %1, has an objective that is %2&#xa0;% larger %3.</source>
        <translation>För den bästa konstruktionen för de angivna värdena, %1, är målstorheten %2&#xa0;% större %3.</translation>
    </message>
    <message>
        <source>the draws</source>
        <translation>dragningarna</translation>
    </message>
    <message>
        <source>To know the %1 better, measure &lt;b&gt;%2&lt;/b&gt; first: it causes %3 % of the scatter.</source>
        <translation>För att känna %1 bättre, mät först &lt;b&gt;%2&lt;/b&gt;: den orsakar %3&#xa0;% av spridningen.</translation>
    </message>
    <message>
        <source>Smallest %1 found for the best design: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Minsta funna värde (%1) för den bästa konstruktionen för ofullständigt känt berg: &lt;b&gt;%2&lt;/b&gt;, vid %3.</translation>
    </message>
    <message>
        <source>Largest %1 found for the best design: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Största funna värde (%1) för den bästa konstruktionen för ofullständigt känt berg: &lt;b&gt;%2&lt;/b&gt;, vid %3.</translation>
    </message>
    <message>
        <source>The choices change the blow energy: machines of different power are compared. “keep the energy” holds it constant.</source>
        <translation>Valen ändrar slagets energi: maskiner med olika effekt jämförs. ”behåll energin” behåller den.</translation>
    </message>
    <message>
        <source>Nearly all scatter of the efficiency comes from γ. To compare hammers, choose loading work as the objective.</source>
        <translation>Verkningsgraden sprider nästan bara med γ. Välj belastningsarbetet som målstorhet för att jämföra hammare.</translation>
    </message>
    <message>
        <source>Answer of the study</source>
        <translation>Vad konstruktionerna säger</translation>
    </message>
    <message>
        <source>Load the best design for uncertain rock</source>
        <translation>Ladda den bästa konstruktionen för ofullständigt känt berg</translation>
    </message>
    <message>
        <source>Load the best design for the values entered</source>
        <translation>Ladda den bästa konstruktionen för de angivna värdena</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Ladda</translation>
    </message>
    <message>
        <source>%1 samples of each design; ± is the 95 % error.</source>
        <translation>%1 stickprov per konstruktion; ± är 95&#xa0;%-felet.</translation>
    </message>
    <message>
        <source>%1 samples so far, %2 to come.</source>
        <translation>Hittills %1 stickprov, %2 återstår.</translation>
    </message>
    <message>
        <source>With the values entered, the objective of the best design for uncertain rock is %1&#xa0;% smaller.</source>
        <translation>Med de angivna värdena är målstorheten för den bästa konstruktionen för ofullständigt känt berg %1&#xa0;% mindre.</translation>
    </message>
    <message>
        <source>With the values entered, the objective of the best design for uncertain rock is %1&#xa0;% larger.</source>
        <translation>Med de angivna värdena är målstorheten för den bästa konstruktionen för ofullständigt känt berg %1&#xa0;% större.</translation>
    </message>
    <message>
        <source>Best for the values entered: %1</source>
        <translation>Bäst för de angivna värdena: %1</translation>
    </message>
    <message>
        <source>Present design: %1</source>
        <translation>Nuvarande konstruktion: %1</translation>
    </message>
    <message>
        <source>Equally good: %1</source>
        <translation>Lika bra: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Best for uncertain rock: %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Bäst för ofullständigt känt berg: %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Present design: %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Nuvarande konstruktion: %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Any design, such as %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Vilken konstruktion som helst, till exempel %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Best in all aims: %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Bäst i alla mål: %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Best for uncertain rock: %1</source>
        <translation>Bäst för ofullständigt känt berg: %1</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>Använd %1</translation>
    </message>
    <message>
        <source>Smallest %1 found with %4: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Minsta funna värde (%1) med %4: &lt;b&gt;%2&lt;/b&gt;, vid %3.</translation>
    </message>
    <message>
        <source>Largest %1 found with %4: &lt;b&gt;%2&lt;/b&gt;, at %3.</source>
        <translation>Största funna värde (%1) med %4: &lt;b&gt;%2&lt;/b&gt;, vid %3.</translation>
    </message>
    <message>
        <source>%1 is equally good, within the error.</source>
        <translation>%1 är lika bra inom felet.</translation>
    </message>
</context>
<context>
    <name>drillwave::DesignPage</name>
    <message>
        <source>samples</source>
        <translation>stickprov</translation>
    </message>
    <message>
        <source>Designs for uncertain inputs</source>
        <translation>Konstruktioner för osäkra indata</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>osäkert</translation>
    </message>
    <message>
        <source>design variables</source>
        <translation>konstruktionsvariabler</translation>
    </message>
    <message>
        <source>keep the energy</source>
        <translation>behåll energin</translation>
    </message>
    <message>
        <source>Scales the blow of every design to the present blow energy, by impulse or hammer velocity</source>
        <translation>Varje konstruktions slag skalas till det aktuella slagets energi: med dess impuls, eller med hammarens hastighet</translation>
    </message>
    <message>
        <source>Samples of each design</source>
        <translation>Stickprov per konstruktion</translation>
    </message>
    <message>
        <source>Too many samples could not be solved: %1</source>
        <translation>För många av stickproven saknar svar: %1</translation>
    </message>
    <message>
        <source>⚠ %1
The page shows the answer for the value before.</source>
        <translation>⚠ %1
Det som visas gäller värdet dessförinnan.</translation>
    </message>
    <message>
        <source>%1 samples of each design</source>
        <translation>%1 stickprov per konstruktion</translation>
    </message>
    <message>
        <source>%1 samples of each design so far, refined to %2</source>
        <translation>Hittills %1 stickprov per konstruktion, förfinat till %2</translation>
    </message>
    <message>
        <source>There is no design study to report.</source>
        <translation>Det finns ingen konstruktion att berätta om.</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Konstruktion</translation>
    </message>
    <message>
        <source>Solve all samples of this study; the time is an estimate</source>
        <translation>Beräkna alla stickprov i studien; tiden är en uppskattning</translation>
    </message>
    <message>
        <source>Not solved yet: this study takes more than 10 s. Press Refine to start it.</source>
        <translation>Inget är beräknat ännu: studien tar mer än 10 s. Knappen ”Förfina” startar den.</translation>
    </message>
    <message>
        <source>%1 samples of each design so far</source>
        <translation>hittills %1 stickprov för varje konstruktion</translation>
    </message>
    <message>
        <source>take the design %1</source>
        <translation>ta över konstruktionen %1</translation>
    </message>
    <message>
        <source>take the worst case</source>
        <translation>ta över det sämsta fallet</translation>
    </message>
    <message>
        <source>Refine (%1)</source>
        <translation>Förfina (%1)</translation>
    </message>
    <message>
        <source>Save draws…</source>
        <translation>Spara dragningar…</translation>
    </message>
    <message>
        <source>Writes the table that design --draws reads</source>
        <translation>Skriver tabellen som design --draws läser</translation>
    </message>
    <message>
        <source>Remove the draws</source>
        <translation>Ta bort dragningarna</translation>
    </message>
    <message>
        <source>Removes the draws: the uncertain rows of the settings are used again</source>
        <translation>Tar bort dragningarna: inställningarnas osäkra rader gäller igen</translation>
    </message>
    <message>
        <source>draws of %1: %2 rows of %3</source>
        <translation>dragningar ur %1: %2 rader med %3</translation>
    </message>
    <message>
        <source>The copied command reads the draws from %1: save them there first.</source>
        <translation>Det kopierade kommandot läser dragningarna ur %1: spara dem där först.</translation>
    </message>
    <message>
        <source>Takes over this design as one undo step</source>
        <translation>Tar över denna konstruktion som ett steg som kan ångras</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detaljer</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>Använd %1</translation>
    </message>
    <message>
        <source>Objectives: %1</source>
        <translation>Mål: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Namnlös</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 till %2</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>ändra %1</translation>
    </message>
    <message>
        <source>clear %1</source>
        <translation>rensa %1</translation>
    </message>
    <message>
        <source>change the pulse shape to %1</source>
        <translation>ändra slagets form till %1</translation>
    </message>
    <message>
        <source>change the title</source>
        <translation>ändra titeln</translation>
    </message>
    <message>
        <source>reload the file</source>
        <translation>läs om filen</translation>
    </message>
    <message>
        <source>A preset of a rod is for uniform rods, and this scenario is a drill string.</source>
        <translation>Ett förval för en stång är för likformiga stänger, och detta scenario är en borrsträng.</translation>
    </message>
    <message>
        <source>A preset of a blow is a force, and this string is struck by the sections of its hammer.</source>
        <translation>Ett förval för ett slag är en kraft, och denna sträng slås av sektionerna i sin hammare.</translation>
    </message>
    <message>
        <source>A preset has physical units, and this scenario is given by its dimensionless groups.</source>
        <translation>Ett förval har fysikaliska enheter, och detta scenario är givet av sina dimensionslösa tal.</translation>
    </message>
    <message>
        <source>take the preset %1</source>
        <translation>ta förvalet %1</translation>
    </message>
    <message>
        <source>take the hammer blow from %1</source>
        <translation>ta hammarslaget från %1</translation>
    </message>
    <message>
        <source>reload the table of the hammer blow</source>
        <translation>läs om hammarslagets tabell</translation>
    </message>
    <message>
        <source>This string is struck by the sections of its hammer, not by a force from a table.</source>
        <translation>Denna sträng slås av sektionerna i sin hammare, inte av en kraft ur en tabell.</translation>
    </message>
    <message>
        <source>follow the table of the pulse</source>
        <translation>följ slagets tabell</translation>
    </message>
    <message>
        <source>%1: cannot be saved: %2. Your changes are still here: save under another name or in another folder.</source>
        <translation>%1: kan inte sparas: %2. Inget är förlorat: spara under ett annat namn eller i en annan mapp.</translation>
    </message>
    <message>
        <source>change the design study</source>
        <translation>ändra konstruktionsstudien</translation>
    </message>
    <message>
        <source>restore the unsaved changes</source>
        <translation>återställ de osparade ändringarna</translation>
    </message>
</context>
<context>
    <name>drillwave::DrillingPage</name>
    <message>
        <source>scan over</source>
        <translation>svep över</translation>
    </message>
    <message>
        <source>Many blows under a feed</source>
        <translation>Många slag under en matning</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Svep</translation>
    </message>
    <message>
        <source>Simulates the blows at several values of this parameter, each once from rest and once with a bouncing machine</source>
        <translation>Simulerar slagen vid flera värden på denna parameter, vart och ett en gång från vila och en gång med studsande maskin</translation>
    </message>
    <message>
        <source>bracket</source>
        <translation>visa gränsfall</translation>
    </message>
    <message>
        <source>Repeats the scan with a constant feed force and, if a machine mass is given, with a dashpot of half the impedance of the rod. Makers do not publish their dampers: the results show how much this matters</source>
        <translation>Upprepar svepet med konstant matningskraft och, om en maskinmassa är angiven, med en dämpare på halva stångens impedans. Tillverkare offentliggör inte sina dämpare: resultaten visar hur mycket det betyder</translation>
    </message>
    <message>
        <source>Drilling needs a scenario in physical units. This one has dimensionless groups, so it has no blow frequency and no feed force.</source>
        <translation>Borrning gäller scenarier i fysikaliska enheter, och detta är givet av sina dimensionslösa tal: det har ingen slagfrekvens och ingen matningskraft.</translation>
    </message>
    <message>
        <source>Stop %1/%2</source>
        <translation>Stoppa %1/%2</translation>
    </message>
    <message>
        <source>Feed force / mean force of the blows φ = %1; %2 round trips of a wave between two blows</source>
        <translation>Matningskraft / slagens medelkraft φ = %1; en våg gör %2 varv mellan två slag</translation>
    </message>
    <message>
        <source>No scan: %1</source>
        <translation>Inget svep: %1</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Borrning</translation>
    </message>
    <message>
        <source>Blow %1 of %2 under the feed, with the waves and the motion it started with: gap %3, penetration %4. The panel Result shows a single blow from rest.</source>
        <translation>Slag %1 av %2 under matningen, med de vågor och den rörelse som det började med: spalt %3, inträngning %4. Det som resultatet säger gäller ett enstaka slag som börjar i vila.</translation>
    </message>
    <message>
        <source>Data of the &amp;scan…</source>
        <translation>Data för s&amp;vepet…</translation>
    </message>
    <message>
        <source>The statistics at every value of the scan, as CSV</source>
        <translation>Statistiken vid varje värde i svepet, som CSV</translation>
    </message>
    <message>
        <source>There is no scan of this scenario yet.</source>
        <translation>Det finns inget svep av detta scenario än.</translation>
    </message>
    <message>
        <source>Solving the blows one after another …</source>
        <translation>Slagen följs ett efter ett …</translation>
    </message>
    <message>
        <source>; &quot;in contact&quot; means within %1 of the rock; %2</source>
        <translation>; ”i kontakt” betyder högst %1 från berget; %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detaljer</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>Svep över %1</translation>
    </message>
</context>
<context>
    <name>drillwave::DrillingTable</name>
    <message>
        <source>Statistics of the blows</source>
        <translation>Statistik över slagen</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>medel</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>standardavvikelse</translation>
    </message>
    <message>
        <source>median</source>
        <translation>median</translation>
    </message>
    <message>
        <source>95 % error of the mean, from batches of blows and from longer and shorter time steps</source>
        <translation>Fel i medelvärdet, 95 %: ur grupper av slag, och vad större eller mindre celler ändrar</translation>
    </message>
</context>
<context>
    <name>drillwave::ElsewhereNotice</name>
    <message>
        <source>Go there</source>
        <translation>Gå dit</translation>
    </message>
    <message>
        <source>Opens the page that has the answer</source>
        <translation>Till sidan som har svaret</translation>
    </message>
</context>
<context>
    <name>drillwave::EnergyBar</name>
    <message>
        <source>rock</source>
        <translation>berg</translation>
    </message>
    <message>
        <source>rebound</source>
        <translation>studs</translation>
    </message>
    <message>
        <source>hammer</source>
        <translation>hammare</translation>
    </message>
    <message>
        <source>losses</source>
        <translation>förluster</translation>
    </message>
    <message>
        <source>waves</source>
        <translation>vågor</translation>
    </message>
    <message>
        <source>Energy: no result</source>
        <translation>Energi: inget resultat</translation>
    </message>
    <message>
        <source>Energy: %1</source>
        <translation>Energi: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::EventModel</name>
    <message>
        <source>contact</source>
        <translation>kontakt</translation>
    </message>
    <message>
        <source>unloading begins</source>
        <translation>avlastning börjar</translation>
    </message>
    <message>
        <source>primary loading</source>
        <translation>första belastning</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>separation</translation>
    </message>
    <message>
        <source>corner of the law</source>
        <translation>hörn i lagen</translation>
    </message>
    <message>
        <source>event at the bit</source>
        <translation>händelse vid borrkronan</translation>
    </message>
</context>
<context>
    <name>drillwave::EventTable</name>
    <message>
        <source>Events at the bit</source>
        <translation>Händelser vid borrkronan</translation>
    </message>
    <message>
        <source>Select an event to move the time cursor there</source>
        <translation>Välj en händelse för att flytta tidsmarkören dit</translation>
    </message>
</context>
<context>
    <name>drillwave::ExampleNote</name>
    <message>
        <source>&amp;About this example</source>
        <translation>O&amp;m detta exempel</translation>
    </message>
    <message>
        <source>Things to look at in the open example</source>
        <translation>Vad man ska titta på i exemplet som är öppet</translation>
    </message>
    <message>
        <source>You have changed this example: its description may no longer be right. Undo brings the values back.</source>
        <translation>Detta exempel är ändrat: det som sägs om dess värden gäller kanske inte längre. Ångra tar tillbaka dem.</translation>
    </message>
</context>
<context>
    <name>drillwave::ExportMenu</name>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Alla filer (*)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportera</translation>
    </message>
    <message>
        <source>&amp;Histories…</source>
        <translation>&amp;Förlopp…</translation>
    </message>
    <message>
        <source>Forces, impulse, momentum, penetration and velocity over time, as CSV</source>
        <translation>Krafter, impuls, rörelsemängd, inträngning och hastighet över tiden, som CSV</translation>
    </message>
    <message>
        <source>&amp;Events…</source>
        <translation>&amp;Händelser…</translation>
    </message>
    <message>
        <source>Contacts, reversals and separations with their times, as CSV</source>
        <translation>Kontakter, vändningar och separationer med sina tider, som CSV</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Kopiera bild</translation>
    </message>
    <message>
        <source>The present view, to paste into a report</source>
        <translation>Som den är zoomad, att klistra in i en rapport</translation>
    </message>
    <message>
        <source>Everything into a &amp;folder…</source>
        <translation>Allt till en &amp;mapp…</translation>
    </message>
    <message>
        <source>Scenario, summary, histories, events and plots, as `drillwave run -o` writes them</source>
        <translation>Scenario, sammanfattning, förlopp, händelser och diagram, som `drillwave run -o` skriver dem</translation>
    </message>
    <message>
        <source>Save the data of the plot</source>
        <translation>Spara diagrammets data</translation>
    </message>
    <message>
        <source>This blow has too many waves to keep: there are no histories.</source>
        <translation>Detta slag har fler vågor än vad som kan sparas: det finns inga förlopp.</translation>
    </message>
    <message>
        <source>Export the histories</source>
        <translation>Exportera förloppen</translation>
    </message>
    <message>
        <source>Export the events</source>
        <translation>Exportera händelserna</translation>
    </message>
    <message>
        <source>The blow could not be solved: %1</source>
        <translation>Slaget kunde inte lösas: %1</translation>
    </message>
    <message>
        <source>Overwrite the files in this folder?</source>
        <translation>Skriva över filerna i denna mapp?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Skriv över</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Spara bilden</translation>
    </message>
    <message>
        <source>%1: not written, the plot could not be drawn</source>
        <translation>%1: inte skriven, diagrammet kunde inte ritas</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>Bilden</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>Bilden finns i urklipp.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skriven: %1</translation>
    </message>
    <message>
        <source>The export has failed.</source>
        <translation>Exporten misslyckades.</translation>
    </message>
    <message>
        <source>&amp;Numbers as a table</source>
        <translation>&amp;Siffrorna som tabell</translation>
    </message>
    <message>
        <source>The numbers this page draws, in a window of their own, to read and copy</source>
        <translation>Det som sidan ritar, siffra för siffra, i ett eget fönster: för att läsas och kopieras</translation>
    </message>
    <message>
        <source>The table</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>Numbers: %1</source>
        <translation>Siffror: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::FamilyFields</name>
    <message>
        <source>%1: parameter</source>
        <translation>%1: parameter</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>%1: values</source>
        <translation>%1: värden</translation>
    </message>
    <message>
        <source>One curve for each value, with or without units: 0.1; 0.3; 1</source>
        <translation>En kurva för varje värde, med eller utan enheter: 0.1; 0.3; 1</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>inget värde</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>högst %1 värden</translation>
    </message>
</context>
<context>
    <name>drillwave::FeedText</name>
    <message>
        <source>⚠ short by %1 (−%2 %)</source>
        <translation>⚠ saknar %1 (−%2 %)</translation>
    </message>
    <message>
        <source>✓ met, %1 (%2 %) to spare</source>
        <translation>✓ uppfyllt, %1 (%2 %) till godo</translation>
    </message>
    <message>
        <source>%1, effective %2</source>
        <translation>%1, verksam %2</translation>
    </message>
</context>
<context>
    <name>drillwave::FigureDialog</name>
    <message>
        <source>Figure %1 of the paper</source>
        <translation>Figur %1 i artikeln</translation>
    </message>
    <message>
        <source>The paper prints no number with this figure.</source>
        <translation>Artikeln trycker inget tal till denna figur.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>tal</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>tryckt</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>anmärkning</translation>
    </message>
    <message>
        <source>Numbers that the paper prints with this figure</source>
        <translation>Tal som artikeln trycker till denna figur</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>avviker</translation>
    </message>
    <message>
        <source>differs: </source>
        <translation>avviker: </translation>
    </message>
</context>
<context>
    <name>drillwave::FigurePage</name>
    <message>
        <source>Result</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>Which result is shown</source>
        <translation>Vilket resultat som visas</translation>
    </message>
</context>
<context>
    <name>drillwave::FileLines</name>
    <message>
        <source>First lines of the file</source>
        <translation>Filens första rader</translation>
    </message>
    <message>
        <source>First lines of the file; samples begin at the marked one</source>
        <translation>Filens första rader; mätvärdena börjar på den markerade</translation>
    </message>
</context>
<context>
    <name>drillwave::FileMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arkiv</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Ny</translation>
    </message>
    <message>
        <source>New di&amp;mensionless</source>
        <translation>Ny di&amp;mensionslös</translation>
    </message>
    <message>
        <source>new</source>
        <translation>ny</translation>
    </message>
    <message>
        <source>A scenario given only by its groups β, γ, τ and δ, without units</source>
        <translation>Ett scenario givet enbart av sina tal β, γ, τ och δ, utan enheter</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öppna…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Spara s&amp;om…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importera…</translation>
    </message>
    <message>
        <source>A measured signal from a table of samples: as the hammer blow, or to compare with</source>
        <translation>En uppmätt signal ur en tabell med mätvärden: som hammarslag, eller att jämföra med</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avsluta</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>Exem&amp;pel</translation>
    </message>
    <message>
        <source>&amp;Figures of the paper</source>
        <translation>Fi&amp;gurer ur artikeln</translation>
    </message>
    <message>
        <source>waves at the middle of the rod</source>
        <translation>vågor i stångens mitt</translation>
    </message>
    <message>
        <source>impact force, impulse and momentum</source>
        <translation>stötkraft, impuls och rörelsemängd</translation>
    </message>
    <message>
        <source>impact force and its closed form</source>
        <translation>stötkraft och dess slutna form</translation>
    </message>
    <message>
        <source>restitution over the stiffness</source>
        <translation>studstal över styvheten</translation>
    </message>
    <message>
        <source>restitution and its closed form</source>
        <translation>studstal och dess slutna form</translation>
    </message>
    <message>
        <source>restitution over the gap</source>
        <translation>studstal över spalten</translation>
    </message>
    <message>
        <source>Figure &amp;%1: %2</source>
        <translation>Figur &amp;%1: %2</translation>
    </message>
    <message>
        <source>Computed again, beside the numbers that the paper prints</source>
        <translation>Beräknad på nytt, bredvid talen som artikeln trycker</translation>
    </message>
    <message>
        <source>The example cannot be opened.</source>
        <translation>Exemplet kan inte öppnas.</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Öppna se&amp;naste</translation>
    </message>
    <message>
        <source>&amp;Clear list</source>
        <translation>&amp;Töm listan</translation>
    </message>
    <message>
        <source>Clears this list; the files stay</source>
        <translation>Glöm dessa namn; filerna finns kvar</translation>
    </message>
    <message>
        <source>This file is no longer there.</source>
        <translation>Denna fil finns inte längre.</translation>
    </message>
    <message>
        <source>%1
It may be on a drive that is not connected. Remove it from the list?</source>
        <translation>%1
Den kan ligga på en enhet som inte är ansluten. Ska den tas bort från listan?</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort den</translation>
    </message>
    <message>
        <source>The scenario cannot be opened.</source>
        <translation>Scenariot kan inte öppnas.</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>Detta kan inte tas emot.</translation>
    </message>
    <message>
        <source>%1 files were dropped; drop one at a time.</source>
        <translation>%1 filer släpptes; släpp en åt gången.</translation>
    </message>
    <message>
        <source>%1
Drop a scenario (.yaml), a file of a run (.csv, .json), a report (.html), the CSV file of a hammer blow, or a table of samples (.txt, .dat).</source>
        <translation>%1
Släpp ett scenario (.yaml), en fil från en körning (.csv, .json), en rapport (.html), CSV-filen för ett hammarslag, eller en tabell med mätvärden (.txt, .dat).</translation>
    </message>
    <message>
        <source>The file has been changed by another program.</source>
        <translation>Filen har ändrats av ett annat program.</translation>
    </message>
    <message>
        <source>%1
Saving overwrites the changes of that program.</source>
        <translation>%1
Att spara skriver över det som det programmet har skrivit.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Skriv över</translation>
    </message>
    <message>
        <source>A file of this name exists already.</source>
        <translation>En fil med detta namn finns redan.</translation>
    </message>
    <message>
        <source>The scenario has not been saved.</source>
        <translation>Scenariot har inte sparats.</translation>
    </message>
</context>
<context>
    <name>drillwave::FileNotice</name>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Läs om</translation>
    </message>
    <message>
        <source>Load the scenario from the file; Undo brings the present one back</source>
        <translation>Ta scenariot från filen; Ångra tar tillbaka det aktuella</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Behåll mitt</translation>
    </message>
    <message>
        <source>Continue with the present scenario; saving overwrites the file</source>
        <translation>Fortsätt med det aktuella scenariot; att spara skriver det över filen</translation>
    </message>
    <message>
        <source>%1 has been deleted or moved. Saving writes it again.</source>
        <translation>%1 har tagits bort eller flyttats. Att spara skriver den igen.</translation>
    </message>
    <message>
        <source>%1 has been changed by another program, and here as well.</source>
        <translation>%1 har ändrats av ett annat program, och även här.</translation>
    </message>
    <message>
        <source>%1 has been changed by another program.</source>
        <translation>%1 har ändrats av ett annat program.</translation>
    </message>
    <message>
        <source>The file cannot be reloaded.</source>
        <translation>Filen kan inte läsas om.</translation>
    </message>
</context>
<context>
    <name>drillwave::FolderDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportera</translation>
    </message>
    <message>
        <source>This folder does not exist yet. Create it?</source>
        <translation>Det finns ingen sådan mapp ännu. Skapa den?</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Skapa den</translation>
    </message>
</context>
<context>
    <name>drillwave::FormNotice</name>
    <message>
        <source>&amp;Make a drill string of this</source>
        <translation>Gör en &amp;borrsträng av detta</translation>
    </message>
    <message>
        <source>&amp;Simplify to a uniform rod</source>
        <translation>&amp;Förenkla till en likformig stång</translation>
    </message>
    <message>
        <source>Use a &amp;force instead of the hammer</source>
        <translation>Sätt en &amp;kraft i hammarens ställe</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ångra</translation>
    </message>
    <message>
        <source>Undo the conversion</source>
        <translation>Ta tillbaka omvandlingen</translation>
    </message>
    <message>
        <source>make a drill string</source>
        <translation>gör en borrsträng</translation>
    </message>
    <message>
        <source>This is a drill string now: a hammer and one rod, to which couplings, an adapter and a bit can be added on the page String.</source>
        <translation>Detta är nu en borrsträng: en hammare och en stång, till vilka skarvhylsor, en nackadapter och en borrkrona kan läggas på sidan Sträng.</translation>
    </message>
    <message>
        <source>simplify to a uniform rod</source>
        <translation>förenkla till en likformig stång</translation>
    </message>
    <message>
        <source>This is a uniform rod now, with the same travel time of waves as the string.</source>
        <translation>Detta är nu en likformig stång, genom vilken vågor går lika länge som genom strängen.</translation>
    </message>
    <message>
        <source>use a force instead of the hammer</source>
        <translation>sätt en kraft i hammarens ställe</translation>
    </message>
    <message>
        <source>A force drives the string now: any shape, or a measured blow by File ▸ Import.</source>
        <translation>En kraft driver nu strängen: vilken form som helst, eller ett uppmätt slag via Arkiv ▸ Importera.</translation>
    </message>
    <message>
        <source>Nothing was converted: %1</source>
        <translation>Inget omvandlades: %1</translation>
    </message>
    <message>
        <source>Lost or changed:</source>
        <translation>Förlorat eller ändrat:</translation>
    </message>
    <message>
        <source>Makes a hammer and a rod with the same blow, to which couplings, an adapter and a bit can be added</source>
        <translation>En hammare och en stång med samma slag, att lägga skarvhylsor, en nackadapter och en borrkrona till</translation>
    </message>
    <message>
        <source>Not of this scenario: %1</source>
        <translation>Inte för detta scenario: %1</translation>
    </message>
    <message>
        <source>Only the rod, as long for the waves as the string, struck by a uniform piston</source>
        <translation>Bara stången, lika lång för vågorna som strängen, slagen av en likformig kolv</translation>
    </message>
    <message>
        <source>This scenario is a uniform rod</source>
        <translation>Detta scenario är en likformig stång</translation>
    </message>
    <message>
        <source>A force drives this scenario already</source>
        <translation>En kraft driver redan detta scenario</translation>
    </message>
    <message>
        <source>A force that reflected waves do not change, as a measured blow is</source>
        <translation>En kraft som inte känner av det som kommer tillbaka, som ett uppmätt slag</translation>
    </message>
    <message>
        <source>Make a &amp;rig of these groups…</source>
        <translation>Gör en &amp;rigg av dessa tal…</translation>
    </message>
    <message>
        <source>This scenario has physical units already</source>
        <translation>Scenariot har redan fysikaliska enheter</translation>
    </message>
    <message>
        <source>Rod, force and duration of a physical scenario with the same groups</source>
        <translation>Stång, kraft och varaktighet för ett fysikaliskt scenario med samma dimensionslösa tal</translation>
    </message>
</context>
<context>
    <name>drillwave::GaugeFields</name>
    <message>
        <source>gauge</source>
        <translation>givare</translation>
    </message>
    <message>
        <source>second gauge</source>
        <translation>andra givare</translation>
    </message>
    <message>
        <source>Column of the gauge that is nearest to the bit</source>
        <translation>Kolumn för givaren närmast borrkronan</translation>
    </message>
    <message>
        <source>Column of another gauge along the same section, at least 0.5 m away</source>
        <translation>Kolumn för en annan givare på samma sektion, minst 0,5 m bort</translation>
    </message>
    <message>
        <source>%1, opposite side</source>
        <translation>%1, motsatta sidan</translation>
    </message>
    <message>
        <source>Column of the gauge on the opposite side: the mean of both is free of bending</source>
        <translation>Kolumn för givaren på motsatta sidan: medelvärdet av båda är fritt från böjning</translation>
    </message>
    <message>
        <source>%1, distance from the bit face</source>
        <translation>%1, avstånd från borrkronan</translation>
    </message>
    <message>
        <source>from the bit</source>
        <translation>från kronan</translation>
    </message>
    <message>
        <source>Distance of the gauge from the bit face</source>
        <translation>Givarens avstånd från borrkronan</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>måste vara positivt</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, enhet</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>one side only</source>
        <translation>bara en sida</translation>
    </message>
    <message>
        <source>on %1, x = %2 m</source>
        <translation>på %1, x = %2 m</translation>
    </message>
    <message>
        <source>not on a uniform section</source>
        <translation>inte på en likformig sektion</translation>
    </message>
</context>
<context>
    <name>drillwave::GoalField</name>
    <message>
        <source>Goal: wanted result</source>
        <translation>Mål: vad resultatet ska bli</translation>
    </message>
    <message>
        <source>none</source>
        <translation>inget</translation>
    </message>
    <message>
        <source>Wanted result: the values of the parameter that give it are marked, and a click takes one</source>
        <translation>Vad resultatet ska bli: de värden på parametern som ger det markeras, och ett klick tar ett av dem</translation>
    </message>
</context>
<context>
    <name>drillwave::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjälp</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Hand&amp;bok</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>&amp;Introduktion</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>&amp;Mus och tangenter</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>Ord&amp;lista</translation>
    </message>
    <message>
        <source>&amp;About Drillwave</source>
        <translation>&amp;Om Drillwave</translation>
    </message>
    <message>
        <source>Drillwave %1</source>
        <translation>Drillwave %1</translation>
    </message>
    <message>
        <source>Percussive rock drilling: waves in the rod, the impact on the rock, the rebound.
Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Slående bergborrning: vågor i stången, stöten mot berget, studsen.
Fri programvara under GNU General Public License, version 3 eller senare.</translation>
    </message>
</context>
<context>
    <name>drillwave::HelpView</name>
    <message>
        <source>Manual</source>
        <translation>Handbok</translation>
    </message>
</context>
<context>
    <name>drillwave::HelpWindow</name>
    <message>
        <source>Manual — Drillwave</source>
        <translation>Handbok — Drillwave</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Tillbaka (Alt+Vänster)</translation>
    </message>
    <message>
        <source>On (Alt+Right)</source>
        <translation>Framåt (Alt+Höger)</translation>
    </message>
    <message>
        <source>Sections found</source>
        <translation>Funna avsnitt</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Sök</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Större</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Mindre</translation>
    </message>
    <message>
        <source>Usual size</source>
        <translation>Vanlig storlek</translation>
    </message>
    <message>
        <source>Search all chapters (Ctrl+F)</source>
        <translation>Sök i alla kapitel (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search all chapters</source>
        <translation>Sök i alla kapitel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Innehåll</translation>
    </message>
    <message>
        <source>No section has all of these words.</source>
        <translation>Inget avsnitt har alla dessa ord.</translation>
    </message>
</context>
<context>
    <name>drillwave::IdentifyPage</name>
    <message>
        <source>force–penetration</source>
        <translation>kraft–inträngning</translation>
    </message>
    <message>
        <source>The loading curve that is fitted</source>
        <translation>Belastningskurvan som anpassas</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatiskt</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>en rät linje</translation>
    </message>
    <message>
        <source>yields once</source>
        <translation>ger efter en gång</translation>
    </message>
    <message>
        <source>that of the scenario</source>
        <translation>scenariots</translation>
    </message>
    <message>
        <source>Record with the model, what the model leaves over, and force over penetration</source>
        <translation>Inspelning med modellen, vad modellen lämnar kvar och kraft över inträngning</translation>
    </message>
    <message>
        <source>Open record…</source>
        <translation>Öppna inspelning…</translation>
    </message>
    <message>
        <source>Known tolerances</source>
        <translation>Kända toleranser</translation>
    </message>
    <message>
        <source>behind the rock</source>
        <translation>bakom berget</translation>
    </message>
    <message>
        <source>Support of the specimen</source>
        <translation>Vad provet vilar på</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>stelt</translation>
    </message>
    <message>
        <source>a bar like that of the gauge</source>
        <translation>en stång som givarens</translation>
    </message>
    <message>
        <source>dispersion</source>
        <translation>dispersion</translation>
    </message>
    <message>
        <source>How much of the dispersion of a round bar is taken into account</source>
        <translation>Hur mycket av en rund stångs dispersion som beaktas</translation>
    </message>
    <message>
        <source>round bar</source>
        <translation>rund stång</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>use the rock identified from %1</source>
        <translation>använd berget som bestämts ur %1</translation>
    </message>
    <message>
        <source>D&amp;raws for Design…</source>
        <translation>D&amp;ragningar för Konstruktion…</translation>
    </message>
    <message>
        <source>Rows of values that the record allows, for design --draws</source>
        <translation>Rader med värden som inspelningen tillåter, för design --draws</translation>
    </message>
    <message>
        <source>There is no answer yet.</source>
        <translation>Det finns inget svar ännu.</translation>
    </message>
    <message>
        <source>The record does not fix the rock well enough.</source>
        <translation>Inspelningen bestämmer inte berget tillräckligt väl.</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifiera</translation>
    </message>
    <message>
        <source>Other laws are being tried; they can widen the intervals.</source>
        <translation>Andra lagar prövas; de kan vidga intervallen.</translation>
    </message>
    <message>
        <source>Tables of samples, one or several along a hole: time and strain, force or the output of a bridge</source>
        <translation>Tabeller med mätvärden, en eller flera längs ett borrhål: tid och töjning, kraft eller utsignal från en brygga</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Lägg till…</translation>
    </message>
    <message>
        <source>Adds records of further blows, whose tables are read like the first</source>
        <translation>Lägger till inspelningar av fler slag, vars tabeller läses som den första</translation>
    </message>
    <message>
        <source>blows of a record</source>
        <translation>slag i en inspelning</translation>
    </message>
    <message>
        <source>Blows of a record that are identified</source>
        <translation>Slag i en inspelning som utvärderas</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>det första</translation>
    </message>
    <message>
        <source>all of them</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 inspelningar</translation>
    </message>
    <message>
        <source>Further records and laws are being tried; they can change the answer.</source>
        <translation>Ytterligare inspelningar och lagar prövas; de kan ändra svaret.</translation>
    </message>
    <message>
        <source>&amp;Table of records…</source>
        <translation>&amp;Tabell över inspelningar…</translation>
    </message>
    <message>
        <source>A row for each record with its values, intervals and verdicts</source>
        <translation>En rad för varje inspelning med värden, intervall och omdömen</translation>
    </message>
    <message>
        <source>There is only one record.</source>
        <translation>Det finns bara en inspelning.</translation>
    </message>
</context>
<context>
    <name>drillwave::IdentifyPanel</name>
    <message>
        <source>Rock as identified</source>
        <translation>Berget som bestämt</translation>
    </message>
    <message>
        <source>what</source>
        <translation>vad</translation>
    </message>
    <message>
        <source>value</source>
        <translation>värde</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>omdöme</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>orsak</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>styvhet</translation>
    </message>
    <message>
        <source>elasticity</source>
        <translation>elasticitet</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolerans</translation>
    </message>
    <message>
        <source>A click on a tolerance goes to its field</source>
        <translation>Ett klick på en tolerans leder till dess fält</translation>
    </message>
    <message>
        <source>Use this rock</source>
        <translation>Använd detta berg</translation>
    </message>
    <message>
        <source>Takes the rock into the scenario as one undo step</source>
        <translation>Tar in berget i scenariot som ett steg</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fäst</translation>
    </message>
    <message>
        <source>Pins the scenario with this rock as a run; the scenario stays as it is</source>
        <translation>Fäster scenariot med detta berg som en körning; scenariot förblir som det är</translation>
    </message>
    <message>
        <source>Design with these draws</source>
        <translation>Konstruera med dessa dragningar</translation>
    </message>
    <message>
        <source>Takes the rock into the scenario, and opens Design with rows of values that the record allows as its uncertain inputs</source>
        <translation>Tar in berget i scenariot och öppnar Konstruktion med rader av värden som inspelningen tillåter som osäkra indata</translation>
    </message>
    <message>
        <source>There are no draws: no record fixes the rock well enough.</source>
        <translation>Det finns inga dragningar: ingen inspelning bestämmer berget tillräckligt väl.</translation>
    </message>
</context>
<context>
    <name>drillwave::ImportDialog</name>
    <message>
        <source>Import – %1</source>
        <translation>Importera – %1</translation>
    </message>
    <message>
        <source>import as</source>
        <translation>importera som</translation>
    </message>
    <message>
        <source>Use of the signal in the program</source>
        <translation>Signalens användning i programmet</translation>
    </message>
    <message>
        <source>hammer blow</source>
        <translation>hammarslag</translation>
    </message>
    <message>
        <source>measured N in a section</source>
        <translation>uppmätt N i ett tvärsnitt</translation>
    </message>
    <message>
        <source>measured force on the rock</source>
        <translation>uppmätt kraft på berget</translation>
    </message>
    <message>
        <source>name</source>
        <translation>namn</translation>
    </message>
    <message>
        <source>Name of the measured curve in the list</source>
        <translation>Vad den uppmätta kurvan kallas i listan</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabell</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>The record and the part that is used</source>
        <translation>Inspelningen, och vad som används av den</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importera</translation>
    </message>
    <message>
        <source>N, tension +</source>
        <translation>N, drag +</translation>
    </message>
    <message>
        <source>F, compression +</source>
        <translation>F, tryck +</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Inget att visa: %1</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>läser …</translation>
    </message>
    <message>
        <source>reading … %1 %</source>
        <translation>läser … %1 %</translation>
    </message>
    <message>
        <source>Only the shape is taken: this scenario has no physical units.</source>
        <translation>Bara formen används: detta scenario har inga fysikaliska enheter.</translation>
    </message>
    <message>
        <source>The blow replaces the hammer; Undo brings it back.</source>
        <translation>Slaget ersätter hammaren; ångra tar tillbaka den.</translation>
    </message>
    <message>
        <source>recorder</source>
        <translation>mätinstrument</translation>
    </message>
    <message>
        <source>Saved settings: columns, units, gauge and amplifier. Select one, or type a name and keep the present settings.</source>
        <translation>Inställningar som har sparats under ett namn: kolumner, enheter, givare och förstärkare. Välj några, eller skriv ett namn och spara de nuvarande.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>inget</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behåll</translation>
    </message>
    <message>
        <source>Keeps the present settings under this name, for the next record</source>
        <translation>Sparar de nuvarande inställningarna under detta namn, för nästa mätning</translation>
    </message>
    <message>
        <source>as in the last import</source>
        <translation>som vid den senaste importen</translation>
    </message>
    <message>
        <source>record to read the rock from</source>
        <translation>inspelning som berget läses ur</translation>
    </message>
</context>
<context>
    <name>drillwave::ImportPlot</name>
    <message>
        <source>record</source>
        <translation>inspelning</translation>
    </message>
    <message>
        <source>used</source>
        <translation>använt</translation>
    </message>
    <message>
        <source>time in the file [%1]</source>
        <translation>tid i filen [%1]</translation>
    </message>
</context>
<context>
    <name>drillwave::Importer</name>
    <message>
        <source>Import a measured signal</source>
        <translation>Importera en uppmätt signal</translation>
    </message>
    <message>
        <source>Tables of samples (*.csv *.txt *.tsv *.dat *.asc *.prn);;All files (*)</source>
        <translation>Tabeller med mätvärden (*.csv *.txt *.tsv *.dat *.asc *.prn);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Import of a measured signal</source>
        <translation>Import av en uppmätt signal</translation>
    </message>
    <message>
        <source>The hammer blow is taken from %1.</source>
        <translation>Hammarslaget är taget från %1.</translation>
    </message>
    <message>
        <source>%1 is shown on the page Blow.</source>
        <translation>%1 ligger nu över sidan Slag.</translation>
    </message>
    <message>
        <source>take the hammer blow from %1</source>
        <translation>ta hammarslaget från %1</translation>
    </message>
    <message>
        <source>%1 measured curves are there already: remove one on the page Blow.</source>
        <translation>%1 uppmätta kurvor finns redan: ta bort en på sidan Slag.</translation>
    </message>
    <message>
        <source>The settings are kept for recorder %1.</source>
        <translation>Inställningarna är sparade för mätinstrumentet %1.</translation>
    </message>
    <message>
        <source>Open records of strain gauges</source>
        <translation>Öppna inspelningar från töjningsgivare</translation>
    </message>
</context>
<context>
    <name>drillwave::IndexingBox</name>
    <message>
        <source>rock</source>
        <translation>berg</translation>
    </message>
    <message>
        <source>Machine: rock</source>
        <translation>Maskin: berg</translation>
    </message>
    <message>
        <source>Whether each blow meets new rock, or the crater of the blow before</source>
        <translation>Om borrkronan vrids till nytt berg för varje slag, eller träffar samma krater igen</translation>
    </message>
    <message>
        <source>new for every blow</source>
        <translation>nytt för varje slag</translation>
    </message>
    <message>
        <source>the same crater</source>
        <translation>samma krater</translation>
    </message>
    <message>
        <source>change the rock of the next blow</source>
        <translation>ändra vilket berg slagen träffar</translation>
    </message>
</context>
<context>
    <name>drillwave::JointMarksItem</name>
    <message>
        <source>hammer</source>
        <translation>hammare</translation>
    </message>
</context>
<context>
    <name>drillwave::KnownFields</name>
    <message>
        <source>tolerance of %1</source>
        <translation>tolerans för %1</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>antaget</translation>
    </message>
    <message>
        <source>95 % tolerance; empty: assumed</source>
        <translation>95 % tolerans; tomt: antaget</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>måste vara positivt</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, enhet</translation>
    </message>
</context>
<context>
    <name>drillwave::LanguageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Språk</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Systemets</translation>
    </message>
    <message>
        <source>Restart Drillwave in this language now: %1?</source>
        <translation>Starta om Drillwave på detta språk nu: %1?</translation>
    </message>
    <message>
        <source>Unsaved changes, the file name, pinned runs and measured signals come back. Numbers stay as the system writes them; files and some chapters of the manual are in English.</source>
        <translation>Osparade ändringar, filens namn, fästa körningar och uppmätta signaler kommer tillbaka. Tal skrivs som systemet skriver dem; filer och några kapitel i handboken är på engelska.</translation>
    </message>
</context>
<context>
    <name>drillwave::LawSection</name>
    <message>
        <source>Bit and rock: law</source>
        <translation>Borrkrona och berg: kraft–inträngning</translation>
    </message>
    <message>
        <source>Rise of the force with penetration: along a line, along lines with corners, or as a power; unloading always follows one slope</source>
        <translation>Hur kraften växer med inträngningen: längs en rät linje, längs en bruten linje eller med en potens av den; den faller alltid med samma lutning</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>bruten linje</translation>
    </message>
    <message>
        <source>power</source>
        <translation>potenslag</translation>
    </message>
    <message>
        <source>+ corner</source>
        <translation>+ hörn</translation>
    </message>
    <message>
        <source>change the law of the rock</source>
        <translation>ändra bergets lag</translation>
    </message>
    <message>
        <source>from</source>
        <translation>från</translation>
    </message>
    <message>
        <source>force</source>
        <translation>kraft</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>lutning</translation>
    </message>
    <message>
        <source>slope, of k</source>
        <translation>lutning, av k</translation>
    </message>
    <message>
        <source>Remove corner %1</source>
        <translation>Ta bort hörn %1</translation>
    </message>
    <message>
        <source>Corner %1: %2</source>
        <translation>Hörn %1: %2</translation>
    </message>
    <message>
        <source>add a corner to the law of the rock</source>
        <translation>lägg ett hörn till bergets lag</translation>
    </message>
    <message>
        <source>remove a corner from the law of the rock</source>
        <translation>ta bort ett hörn ur bergets lag</translation>
    </message>
    <message>
        <source>force–penetration</source>
        <translation>kraft–inträngning</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linjär</translation>
    </message>
</context>
<context>
    <name>drillwave::LevelField</name>
    <message>
        <source>Contours at</source>
        <translation>Nivåkurvor vid</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 är inget tal</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>högst %1 nivåer</translation>
    </message>
    <message>
        <source>Values of the contours, in the present units: 0.95; 1; 1.05</source>
        <translation>De värden som kartan har nivåkurvor för, i de visade enheterna: 0.95; 1; 1.05</translation>
    </message>
</context>
<context>
    <name>drillwave::MainWindow</name>
    <message>
        <source>exact method · not solved</source>
        <translation>exakt metod · inte löst</translation>
    </message>
    <message>
        <source>cell method · not solved</source>
        <translation>cellmetoden · inte löst</translation>
    </message>
    <message>
        <source>cell method · computed in %1 · efficiency %2 ± %3</source>
        <translation>cellmetoden · beräknat på %1 · verkningsgrad %2 ± %3</translation>
    </message>
    <message>
        <source>exact method · %1 · computed in %2 · e = %3 ± %4</source>
        <translation>exakt metod · %1 · beräknat på %2 · e = %3 ± %4</translation>
    </message>
    <message>
        <source>1 force peak</source>
        <translation>1 krafttopp</translation>
    </message>
    <message>
        <source>%1 force peaks</source>
        <translation>%1 krafttoppar</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Sidor</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenario</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigera</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>the input was changed meanwhile.</source>
        <translation>indata ändrades under tiden.</translation>
    </message>
    <message>
        <source>another page was chosen meanwhile.</source>
        <translation>en annan sida valdes under tiden.</translation>
    </message>
    <message>
        <source>other units were chosen meanwhile.</source>
        <translation>andra enheter valdes under tiden.</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for the case of a crash.</source>
        <translation>Osparade ändringar kan inte bevaras för händelse av en krasch.</translation>
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
        <translation>Menyerna, som de är nu</translation>
    </message>
    <message>
        <source>key</source>
        <translation>tangent</translation>
    </message>
    <message>
        <source>action</source>
        <translation>vad den gör</translation>
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
        <translation>färg</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>nivåkurvor</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punkter</translation>
    </message>
    <message>
        <source>Result over two parameters</source>
        <translation>Resultat över två parametrar</translation>
    </message>
    <message>
        <source>Points of the map</source>
        <translation>Kartans punkter</translation>
    </message>
    <message>
        <source>Number of values of each of the two parameters</source>
        <translation>Hur många värden var och en av de två parametrarna tar</translation>
    </message>
    <message>
        <source>Both axes are %1: choose another parameter for one of them.</source>
        <translation>Båda axlarna är %1: välj en annan parameter för en av dem.</translation>
    </message>
    <message>
        <source>here %1. %2</source>
        <translation>här %1. %2</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karta</translation>
    </message>
    <message>
        <source>Click on a line or preset to use that point; Shift+click pins it. The crosshair can be dragged.</source>
        <translation>Klick på en linje eller ett förval: använd den punkten; med Skift: fäst den för jämförelse. Hårkorset kan dras.</translation>
    </message>
</context>
<context>
    <name>drillwave::MarchedNotice</name>
    <message>
        <source>Single blow</source>
        <translation>Enstaka slag</translation>
    </message>
    <message>
        <source>Shows the blow from rest again, as in Result</source>
        <translation>Visa åter slaget som börjar i vila, som i resultatet</translation>
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
        <translation>Passa in</translation>
    </message>
    <message>
        <source>not drawn: compared with scenarios in physical units</source>
        <translation>inte ritad: jämförs med scenarier i fysikaliska enheter</translation>
    </message>
    <message>
        <source>Measured curve</source>
        <translation>Uppmätt kurva</translation>
    </message>
    <message>
        <source>Shows the waves at the section of this gauge</source>
        <translation>Visa vågorna i det tvärsnitt där detta mättes</translation>
    </message>
    <message>
        <source>Shift of the measured curve in time</source>
        <translation>Den uppmätta kurvans förskjutning i tid</translation>
    </message>
    <message>
        <source>Time added to the measured curve; Up and Down change it</source>
        <translation>Läggs till den uppmätta kurvans tider; Upp och Ned flyttar den</translation>
    </message>
    <message>
        <source>Shifts the curve to the best fit with the computed one</source>
        <translation>Förskjut den dit där den passar bäst med den beräknade kurvan</translation>
    </message>
    <message>
        <source>Remove the measured curve</source>
        <translation>Ta bort den uppmätta kurvan</translation>
    </message>
    <message>
        <source>Removes this measured curve; Undo brings it back</source>
        <translation>Ta bort denna uppmätta kurva; Ångra tar tillbaka den</translation>
    </message>
    <message>
        <source>Over the common time: root mean square of the difference; measured minus computed peak; delay of the measured curve from the best fit</source>
        <translation>Över den tid som båda har: roten ur medelkvadraten av deras skillnad; storleken på den största kraften, uppmätt minus beräknad; hur mycket senare den uppmätta kurvan kommer än där den passar bäst</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Uppmätt</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>förskjutning</translation>
    </message>
    <message>
        <source>Unit of the shift in time</source>
        <translation>Enhet för förskjutningen i tid</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>vid %1</translation>
    </message>
    <message>
        <source>%1 points; no sample is further than %2 from the lines between them</source>
        <translation>%1 punkter; inget använt mätvärde ligger längre än %2 från dem</translation>
    </message>
</context>
<context>
    <name>drillwave::MeasuredList</name>
    <message>
        <source>lay over the measured curve %1</source>
        <translation>lägg den uppmätta kurvan %1 över</translation>
    </message>
    <message>
        <source>remove the measured curve %1</source>
        <translation>ta bort den uppmätta kurvan %1</translation>
    </message>
    <message>
        <source>shift the measured curve %1</source>
        <translation>förskjut den uppmätta kurvan %1</translation>
    </message>
</context>
<context>
    <name>drillwave::Message</name>
    <message>
        <source>over</source>
        <translation>över</translation>
    </message>
    <message>
        <source>The required feed force needs a scenario in physical units. This scenario is given by its dimensionless groups, without blow frequency and forces.</source>
        <translation>Den nödvändiga matningskraften kräver ett scenario i fysikaliska enheter. Detta scenario är givet av sina dimensionslösa tal, utan slagfrekvens och krafter.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Matningskraft</translation>
    </message>
    <message>
        <source>effective force, with weight along the hole</source>
        <translation>verksam kraft, med vikten längs hålet</translation>
    </message>
    <message>
        <source>installed feed force</source>
        <translation>installerad matningskraft</translation>
    </message>
    <message>
        <source>95 % of gaps</source>
        <translation>95 % av spalterna</translation>
    </message>
    <message>
        <source>elastic, worst gap</source>
        <translation>elastiskt, sämsta spalt</translation>
    </message>
    <message>
        <source>Mean force that balances a blow which starts at rest on the rock</source>
        <translation>Medelkraft som balanserar ett slag som börjar i vila på berget</translation>
    </message>
    <message>
        <source>At this feed an undamped rigid rod is back at the rock before the next blow</source>
        <translation>Vid denna matningskraft är en odämpad stel stång tillbaka vid berget före nästa slag</translation>
    </message>
    <message>
        <source>Effective feed force over the required one, less 1</source>
        <translation>Verksam matningskraft delad med den som krävs, minus 1</translation>
    </message>
    <message>
        <source>could not be solved: %1</source>
        <translation>kunde inte lösas: %1</translation>
    </message>
    <message>
        <source>%1 of %2 points could not be solved: their cells are empty; the first: %3</source>
        <translation>%1 av %2 punkter kunde inte lösas: deras celler är tomma; den första: %3</translation>
    </message>
    <message>
        <source>effective %1</source>
        <translation>verksam %1</translation>
    </message>
    <message>
        <source>installed %1</source>
        <translation>installerad %1</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; free some space or choose another place</source>
        <translation>%1: kan inte skrivas: %2; frigör utrymme eller välj en annan plats</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another place</source>
        <translation>%1: kan inte skrivas: %2; välj en annan plats</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made: %2; choose another one</source>
        <translation>%1: mappen kan inte skapas: %2; välj en annan</translation>
    </message>
    <message>
        <source>%1: is there and no file; choose another folder</source>
        <translation>%1: finns och är ingen fil; välj en annan mapp</translation>
    </message>
    <message>
        <source>%1: exists already; choose another folder or ask for it to be overwritten</source>
        <translation>%1: finns redan; välj en annan mapp eller begär att den skrivs över</translation>
    </message>
    <message>
        <source>%1: another run has been writing there for %2 seconds; wait for it or choose another folder</source>
        <translation>%1: en annan körning har skrivit där i %2 sekunder; vänta på den eller välj en annan mapp</translation>
    </message>
    <message>
        <source>%1: has been put there or changed by somebody else; move it away, or keep the runs again to replace it</source>
        <translation>%1: har lagts dit eller ändrats av någon annan; flytta undan den, eller spara körningarna igen för att ersätta den</translation>
    </message>
    <message>
        <source>The input %1 = %2 is outside its typical range, %3 to %4.</source>
        <translation>Indata %1 = %2 ligger utanför det vanliga området, %3 till %4.</translation>
    </message>
    <message>
        <source>When the first reflection returns to the hammer, %1 % of the impulse of the blow is still to come. A real hammer would feel the reflection, but here the hammer force is prescribed. To include this effect, use a drill string with a hammer.</source>
        <translation>När den första reflexionen kommer tillbaka till hammaren återstår %1&#xa0;% av slagets impuls. En verklig hammare skulle känna reflexionen, men här är hammarkraften given. En borrsträng med hammare tar hänsyn till denna verkan.</translation>
    </message>
    <message>
        <source>No hammer data are given. The hammer is assumed to have the impedance of the rod and to give a rectangular blow. Enter the data of the piston.</source>
        <translation>Inga hammardata är angivna. Hammaren antas ha stångens impedans och ge ett rektangulärt slag. Ange kolvens data.</translation>
    </message>
    <message>
        <source>The hammer is the default one (%1, the material of the rod). Give the data of the rock drill&apos;s piston.</source>
        <translation>Hammaren är standardhammaren (%1, stångens material). Ange data för borrmaskinens kolv.</translation>
    </message>
    <message>
        <source>The impedance of the hammer is below that of the rod. The hammer therefore bounces back after one force step, and the rod receives more than the momentum of the hammer.</source>
        <translation>Hammarens impedans är lägre än stångens. Hammaren studsar därför tillbaka efter ett kraftsteg, och stången tar över mer än hammarens rörelsemängd.</translation>
    </message>
    <message>
        <source>The impedance of the hammer is above that of the rod: the force falls in ever smaller steps. Reflections that return to the hammer are neglected here.</source>
        <translation>Hammarens impedans är högre än stångens: kraften faller i allt mindre steg. Reflexer tillbaka till hammaren försummas här.</translation>
    </message>
    <message>
        <source>The waves of a blow make only %1 round trips in the string before the next blow, and they still act on that blow (%3). This may change the penetration by up to 10 %, depending on blow frequency and string length; to compute it, use %2.</source>
        <translation>Slagets vågor hinner bara %1 varv fram och åter i strängen till nästa slag och verkar ännu på det slaget (%3). Det kan ändra inträngningen med upp till 10&#xa0;%, beroende på slagfrekvens och stränglängd; använd %2 för att beräkna den.</translation>
    </message>
    <message>
        <source>The waves of a blow make only %1 round trips in the string before the next blow, and they still act on that blow (%4). Because %1 is close to the whole number %2, they arrive at the same time as the next blow. This may change the penetration by up to 10 %; to compute it, use %3.</source>
        <translation>Slagets vågor hinner bara %1 varv fram och åter i strängen till nästa slag och verkar ännu på det slaget (%4). Eftersom %1 ligger nära heltalet %2 kommer de samtidigt med nästa slag. Det kan ändra inträngningen med upp till 10&#xa0;%; använd %3 för att beräkna den.</translation>
    </message>
    <message>
        <source>only share a time step of %1, which takes more work than is permitted</source>
        <translation>har bara ett gemensamt tidssteg på %1, som kräver mer arbete än vad som är tillåtet</translation>
    </message>
    <message>
        <source>share no time step</source>
        <translation>har inget gemensamt tidssteg</translation>
    </message>
    <message>
        <source>force on the rock and rebound have errors: e by up to %1</source>
        <translation>kraften på berget och studsen avviker: e med upp till %1</translation>
    </message>
    <message>
        <source>the efficiency may have an error of %1</source>
        <translation>verkningsgraden kan avvika med %1</translation>
    </message>
    <message>
        <source>The transit times of the sections %1: they were rounded by up to %2, and %3. %4</source>
        <translation>Sektionernas gångtider %1: de avrundades med upp till %2, och %3. %4</translation>
    </message>
    <message>
        <source>Round the section lengths to multiples of a common length, such as 50 mm. A longer time step then fits all sections exactly.</source>
        <translation>Avrunda sektionslängderna till multiplar av en gemensam längd, t.ex. 50 mm. Ett längre tidssteg passar då exakt för alla sektioner.</translation>
    </message>
    <message>
        <source>Enter all lengths in whole millimetres, with the same steel in all sections: the time step is then exact.</source>
        <translation>Ange alla längder i hela millimeter, med samma stål i alla sektioner: då är tidssteget exakt.</translation>
    </message>
    <message>
        <source>the blow is longer than a round trip in the rod (tau = %1 &lt; 0.5)</source>
        <translation>slaget är längre än ett varv fram och åter i stången (tau = %1 &lt; 0,5)</translation>
    </message>
    <message>
        <source>the bit meets the rock in the middle of a wave (delta = %1 is not a whole number)</source>
        <translation>borrkronan träffar berget mitt i en våg (delta = %1 är inget heltal)</translation>
    </message>
    <message>
        <source>the loading curve of the rock is not a straight line</source>
        <translation>bergets belastningskurva inte är en rät linje</translation>
    </message>
    <message>
        <source>the bit is still on the rock when the next reflection arrives</source>
        <translation>borrkronan ännu är på berget när nästa reflexion kommer</translation>
    </message>
    <message>
        <source>The closed-form solution for elastic rock does not apply, because %1. Its coefficient of restitution, e = %2, has an error of %3.</source>
        <translation>Den slutna lösningen för elastiskt berg gäller inte, eftersom %1. Dess studstal e = %2 har ett fel på %3.</translation>
    </message>
    <message>
        <source>compression</source>
        <translation>tryck</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>drag</translation>
    </message>
    <message>
        <source>The rod moves as a rigid body until it meets the rock. The gap between bit and rock therefore only shifts the time of contact and has no other effect.</source>
        <translation>Stången rör sig som en stel kropp tills den möter berget. Spalten mellan borrkrona och berg flyttar därför bara kontaktens tid och har ingen annan verkan.</translation>
    </message>
    <message>
        <source>The rod rebounds with more momentum than it had before impact (e = %1). An estimate for rigid rock (e = 1) gives too small a feed force.</source>
        <translation>Stången studsar med mer rörelsemängd än den hade före anslaget (e = %1). En uppskattning för stelt berg (e = 1) ger för liten matningskraft.</translation>
    </message>
    <message>
        <source>The bit hits the rock %1 times in this blow: reflected waves push it against the rock again.</source>
        <translation>Borrkronan träffar berget %1 gånger i detta slag: reflekterade vågor trycker den tillbaka mot berget.</translation>
    </message>
    <message>
        <source>The numerical error of the coefficient of restitution e may be as large as %1.</source>
        <translation>Det numeriska felet i studstalet e kan vara så stort som %1.</translation>
    </message>
    <message>
        <source>This blow is not over after %1, when the next blow starts: bit and rock, or hammer and string, may meet again. The values are for that moment and not final.</source>
        <translation>Detta slag är inte över efter %1, när nästa börjar: borrkrona och berg, eller hammare och sträng, kan träffas igen. Värdena gäller vid den tiden och är inte slutliga.</translation>
    </message>
    <message>
        <source>The largest stresses of the sections were not computed, because this would exceed the limit of computing work. No strength was checked. Try a shorter end time (end_time).</source>
        <translation>Sektionernas största spänningar beräknades inte, eftersom det skulle kräva mer beräkning än vad som är tillåtet. Ingen hållfasthet kontrollerades. Prova en kortare sluttid (end_time).</translation>
    </message>
    <message>
        <source>The force on the rock reaches only %1, below the first corner of the loading curve at %2. The rock therefore acts as if its loading curve were one straight line.</source>
        <translation>Kraften på berget når bara %1, under belastningskurvans första hörn vid %2. Berget verkar därför som om belastningskurvan vore en enda rät linje.</translation>
    </message>
    <message>
        <source>The feed force of %1 is below the mean force of the blows, %2, or too close to it. The gap between bit and rock therefore grows from blow to blow. Increase the feed force.</source>
        <translation>Matningskraften %1 är lägre än slagens medelkraft, %2, eller för nära den. Spalten mellan borrkrona och berg växer därför från slag till slag. Öka matningskraften.</translation>
    </message>
    <message>
        <source>Nothing damps the waves, so their fronts never decay. Give a wave loss; 1 to 30 % per round trip is usual.</source>
        <translation>Inget dämpar vågorna, så deras fronter klingar aldrig av. Ange en vågförlust; 1 till 30&#xa0;% per varv fram och åter är vanlig.</translation>
    </message>
    <message>
        <source>After the piston has separated, the rebounding string hits it again, and the piston passes up to %1 % of its momentum to the string. If the machine has drawn the piston back by then, switch off “may strike again” (restrike: false in the file).</source>
        <translation>Efter att kolven har skilts träffar den studsande strängen den igen, och kolven ger upp till %1&#xa0;% av sin rörelsemängd till strängen. Om maskinen då har dragit tillbaka kolven, stäng av ”får slå flera gånger” (restrike: false i filen).</translation>
    </message>
    <message>
        <source>At impact, the shank is up to %1 from its mean position in the machine. A real machine would then have another stroke and blow energy than assumed. If the damper has no spring, add one: a dashpot alone lets the shank drift.</source>
        <translation>Vid slaget är nacken upp till %1 från sitt medelläge i maskinen. En verklig maskin skulle då ha en annan slaglängd och slagenergi än antaget. Lägg till en fjäder om dämparen saknar den: en dämpare ensam låter nacken vandra.</translation>
    </message>
    <message>
        <source>The blow frequency is rounded to %1, so that each blow falls on a time step.</source>
        <translation>Slagfrekvensen är avrundad till %1, så att varje slag faller på ett tidssteg.</translation>
    </message>
    <message>
        <source>The motion may not be steady yet: means of the first and second half of the blows differ by more than three times their error. Increase the number of blows, or of transient blows.</source>
        <translation>Rörelsen är kanske ännu inte stationär: medelvärden för första och andra hälften av slagen skiljer sig med mer än tre gånger felet. Öka antalet slag eller slag för insvängning.</translation>
    </message>
    <message>
        <source>Two steady motions are possible. The start or the time step decides which one is computed; a real drill may settle into either.</source>
        <translation>Två jämna rörelser är möjliga. Starten eller tidssteget avgör vilken som beräknas; en verklig maskin kan hamna i vilken som helst av dem.</translation>
    </message>
    <message>
        <source>The motion does not repeat from blow to blow: use the means, not the values of single blows.</source>
        <translation>Rörelsen upprepar sig inte från slag till slag: använd medelvärdena, inte värden för enstaka slag.</translation>
    </message>
    <message>
        <source>The energy balance of all blows has an error of %1 %. The time step is too long for the short contacts between bit and rock. A shorter time step reduces the error in proportion.</source>
        <translation>Energibalansen för alla slag har ett fel på %1&#xa0;%. Tidssteget är för långt för de korta kontakterna mellan borrkrona och berg. Ett kortare tidssteg minskar felet i samma mån.</translation>
    </message>
    <message>
        <source>The data of the damper are assumed, because makers do not publish them. Try dashpots from 0.05 to 0.5 times the impedance of the rod.</source>
        <translation>Dämparens data är antagna, eftersom tillverkare inte offentliggör dem. Prova dämpare från 0,05 till 0,5 gånger stångens impedans.</translation>
    </message>
    <message>
        <source>a dashpot of %1 and a spring of %2</source>
        <translation>en dämpare på %1 och en fjäder på %2</translation>
    </message>
    <message>
        <source>a dashpot of %1</source>
        <translation>en dämpare på %1</translation>
    </message>
    <message>
        <source>a spring of %1</source>
        <translation>en fjäder på %1</translation>
    </message>
    <message>
        <source>The blows could not be solved: %1.</source>
        <translation>Slagen kunde inte lösas: %1.</translation>
    </message>
    <message>
        <source>The computation was stopped before all blows were solved.</source>
        <translation>Beräkningen stoppades innan alla slag var lösta.</translation>
    </message>
    <message>
        <source>rod back at rest before every blow</source>
        <translation>stången kommer till vila före varje slag</translation>
    </message>
    <message>
        <source>irregular: use means only</source>
        <translation>oregelbunden: enstaka slag är inget resultat</translation>
    </message>
    <message>
        <source>repeats every blow</source>
        <translation>upprepas varje slag</translation>
    </message>
    <message>
        <source>repeats every %1 blows</source>
        <translation>upprepas efter %1 slag</translation>
    </message>
    <message>
        <source>Lyapunov exponent %1 per blow</source>
        <translation>Ljapunovexponent %1 per slag</translation>
    </message>
    <message>
        <source>Lyapunov exponent %1 +- %2 per blow</source>
        <translation>Ljapunovexponent %1 +- %2 per slag</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>vid %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>från %1 till %2</translation>
    </message>
    <message>
        <source>at every gap</source>
        <translation>vid varje spalt</translation>
    </message>
    <message>
        <source>The feed cannot be judged: the scenario has only dimensionless groups. Enter the scenario in physical units.</source>
        <translation>Matningen bedöms inte: scenariot ges bara av sina dimensionslösa tal. Ange scenariot i fysikaliska enheter.</translation>
    </message>
    <message>
        <source>The feed cannot be judged: give a blow frequency.</source>
        <translation>Matningen bedöms inte: ange en slagfrekvens.</translation>
    </message>
    <message>
        <source>%1 (%2 with the weight along the hole)</source>
        <translation>%1 (%2 med vikten längs hålet)</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>minst %1</translation>
    </message>
    <message>
        <source>this blow</source>
        <translation>detta slag</translation>
    </message>
    <message>
        <source>95 % of all gaps</source>
        <translation>95&#xa0;% av alla spalter</translation>
    </message>
    <message>
        <source>rigid rock</source>
        <translation>stelt berg</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>sektion %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 för %2</translation>
    </message>
    <message>
        <source>force of corner %1</source>
        <translation>kraft i hörn %1</translation>
    </message>
    <message>
        <source>slope behind corner %1</source>
        <translation>lutning efter hörn %1</translation>
    </message>
    <message>
        <source>hammer %1</source>
        <translation>hammare %1</translation>
    </message>
    <message>
        <source>with its unit</source>
        <translation>med enhet</translation>
    </message>
    <message>
        <source>in US units</source>
        <translation>i US-enheter</translation>
    </message>
    <message>
        <source>preset %1: %2</source>
        <translation>förval %1: %2</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>inte angivet</translation>
    </message>
    <message>
        <source>assumed by the program</source>
        <translation>antaget av programmet</translation>
    </message>
    <message>
        <source>hammer may strike again</source>
        <translation>hammaren får slå flera gånger</translation>
    </message>
    <message>
        <source>law of bit and rock</source>
        <translation>lag för krona och berg</translation>
    </message>
    <message>
        <source>rock at the next blow</source>
        <translation>berget vid nästa slag</translation>
    </message>
    <message>
        <source>table of the blow</source>
        <translation>slagets tabell</translation>
    </message>
    <message>
        <source>shape of the blow</source>
        <translation>slagets form</translation>
    </message>
    <message>
        <source>its points are in the scenario</source>
        <translation>dess punkter står i scenariot</translation>
    </message>
    <message>
        <source>in the scenario</source>
        <translation>i scenariot</translation>
    </message>
    <message>
        <source>points of the blow</source>
        <translation>slagets punkter</translation>
    </message>
    <message>
        <source>method %1</source>
        <translation>metod %1</translation>
    </message>
    <message>
        <source>method %1, %2 segments</source>
        <translation>metod %1, %2 segment</translation>
    </message>
    <message>
        <source>the percussion power</source>
        <translation>slageffekten</translation>
    </message>
    <message>
        <source>the penetration rate</source>
        <translation>borrsjunkningen</translation>
    </message>
    <message>
        <source>polynomial cells</source>
        <translation>polynomceller</translation>
    </message>
    <message>
        <source>the feed force</source>
        <translation>matningskraften</translation>
    </message>
    <message>
        <source>%1 needs a scenario in physical units; this one is given by its dimensionless groups</source>
        <translation>%1 förutsätter ett scenario i fysikaliska enheter; detta är givet av sina dimensionslösa tal</translation>
    </message>
    <message>
        <source>%1 needs drill.blow_frequency; give it in the scenario or with --set</source>
        <translation>%1 förutsätter drill.blow_frequency; ange den i scenariot eller med --set</translation>
    </message>
    <message>
        <source>The waves of this blow have %1 polynomial pieces, too many to study all gaps in a report: run `drillwave %2` instead, which takes longer.</source>
        <translation>Vågorna i detta slag har %1 polynombitar, för många för att undersöka alla spalter i en rapport: kör i stället `drillwave %2`, som tar längre tid.</translation>
    </message>
    <message>
        <source>The blow could not be solved at all gaps: %1</source>
        <translation>Slaget kunde inte lösas vid alla spalter: %1</translation>
    </message>
    <message>
        <source>The reference case does not depend on the gap, which only shifts the time of contact.</source>
        <translation>Referensfallet beror inte på spalten: den flyttar bara kontaktens tid.</translation>
    </message>
    <message>
        <source>The hammer still pushes when its first reflection returns: results are periodic only for gaps above %1 d0, and the statistics cover the first period above it.</source>
        <translation>Hammaren trycker fortfarande när dess första reflexion är tillbaka: resultaten har en period i spalten först från en spalt på %1 d0, och statistiken gäller perioden som börjar där.</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>impuls</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>toppkraft</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>verkningsgrad</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>överallt</translation>
    </message>
    <message>
        <source>%1 kink</source>
        <translation>%1 (knäck)</translation>
    </message>
    <message>
        <source>at a gap of</source>
        <translation>vid en spalt på</translation>
    </message>
    <message>
        <source>median</source>
        <translation>median</translation>
    </message>
    <message>
        <source>%1 % quantile</source>
        <translation>%1&#xa0;%-kvantil</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>medelvärde</translation>
    </message>
    <message>
        <source>all gaps equally likely</source>
        <translation>alla spalter lika sannolika</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>minst</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>störst</translation>
    </message>
    <message>
        <source>gap %1 +- %2</source>
        <translation>spalt %1 ± %2</translation>
    </message>
    <message>
        <source>e &gt; 1 at %1 of all gaps</source>
        <translation>e &gt; 1 vid %1 av alla spalter</translation>
    </message>
    <message>
        <source>, %1 of the scattered ones</source>
        <translation>, %1 av de spridda</translation>
    </message>
    <message>
        <source>rises above 1 at %1</source>
        <translation>stiger över 1 vid %1</translation>
    </message>
    <message>
        <source>falls below 1 at %1</source>
        <translation>faller under 1 vid %1</translation>
    </message>
    <message>
        <source>%1 (slope %2 to %3 per d0)</source>
        <translation>%1 (lutning %2 till %3 per d0)</translation>
    </message>
    <message>
        <source>Kinks of e at a gap of %1</source>
        <translation>Knäckar i e vid en spalt på %1</translation>
    </message>
    <message>
        <source>The scattered gap is a normal distribution cut off at zero; mean and deviation are those before the cut.</source>
        <translation>Den spridda spalten är en normalfördelning avskuren vid noll: medelvärde och standardavvikelse är de före snittet.</translation>
    </message>
    <message>
        <source>Errors below %1, from %2 blow</source>
        <translation>Fel under %1, ur %2 slag</translation>
    </message>
    <message>
        <source>Errors below %1, from %2 blows</source>
        <translation>Fel under %1, ur %2 slag</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Författare</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kund</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Report on one blow of a percussive drill, written by Drillwave %1, solved by %2. Tension is positive. %3</source>
        <translation>Rapport om ett slag vid slående bergborrning, skriven av Drillwave %1, lösning: %2. Drag är positivt. %3</translation>
    </message>
    <message>
        <source>Hammer and string of uniform sections; bending, torsion and friction in threads beyond a loss factor are not modelled.</source>
        <translation>Hammare och sträng av likformiga sektioner; böjning, vridning och friktion i gängor utöver en förlustfaktor modelleras inte.</translation>
    </message>
    <message>
        <source>One uniform rod; joints and the mass of the bit are not modelled.</source>
        <translation>En likformig stång; skarvar och kronans massa modelleras inte.</translation>
    </message>
    <message>
        <source>Alerts and remarks</source>
        <translation>Varningar och anmärkningar</translation>
    </message>
    <message>
        <source>Warning:</source>
        <translation>Varning:</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Anmärkning:</translation>
    </message>
    <message>
        <source>Nothing unusual.</source>
        <translation>Inget ovanligt.</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Indata</translation>
    </message>
    <message>
        <source>key</source>
        <translation>nyckel</translation>
    </message>
    <message>
        <source>what</source>
        <translation>storhet</translation>
    </message>
    <message>
        <source>value</source>
        <translation>värde</translation>
    </message>
    <message>
        <source>source</source>
        <translation>källa</translation>
    </message>
    <message>
        <source>place</source>
        <translation>nummer</translation>
    </message>
    <message>
        <source>section</source>
        <translation>sektion</translation>
    </message>
    <message>
        <source>times</source>
        <translation>antal</translation>
    </message>
    <message>
        <source>Hammer and string</source>
        <translation>Hammare och sträng</translation>
    </message>
    <message>
        <source>The other %1 sections are in the report as HTML.</source>
        <translation>De övriga %1 sektionerna står i rapporten som HTML.</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>symbol</translation>
    </message>
    <message>
        <source>Groups and scales</source>
        <translation>Dimensionslösa tal och referensstorheter</translation>
    </message>
    <message>
        <source>result</source>
        <translation>resultat</translation>
    </message>
    <message>
        <source>scaled</source>
        <translation>som multipel</translation>
    </message>
    <message>
        <source>place and time</source>
        <translation>var och när</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>E₀ and p₀ are the energy and momentum of the hammer.</source>
        <translation>E₀ och p₀ är hammarens energi och rörelsemängd.</translation>
    </message>
    <message>
        <source>W is the work of the hammer.</source>
        <translation>W är hammarens arbete.</translation>
    </message>
    <message>
        <source>Comparison with other runs</source>
        <translation>Jämförelse med andra körningar</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>storhet</translation>
    </message>
    <message>
        <source>Comparison with measurements</source>
        <translation>Jämförelse med mätningen</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>signal</translation>
    </message>
    <message>
        <source>Over the common time: root mean square of the difference, measured minus computed peak force, and delay of the measured signal from the best fit.</source>
        <translation>Över den tid som båda har: roten ur medelkvadraten av skillnaden, storleken på den största kraften, uppmätt minus beräknad, och hur mycket senare den uppmätta signalen kommer än där den passar bäst.</translation>
    </message>
    <message>
        <source>Numerical error</source>
        <translation>Lösningens noggrannhet</translation>
    </message>
    <message>
        <source>error</source>
        <translation>fel</translation>
    </message>
    <message>
        <source>size</source>
        <translation>storlek</translation>
    </message>
    <message>
        <source>The errors of the efficiency and of the balances are numerical; rock and string are known far less well.</source>
        <translation>Felet i verkningsgraden och felen i balanserna är numeriska; vad man vet om berg och sträng är långt grövre.</translation>
    </message>
    <message>
        <source>The error bound of e and the errors of the balances are numerical; rock and rod are known far less well.</source>
        <translation>Gränsen för e och felen i balanserna är numeriska; vad man vet om berg och stång är långt grövre.</translation>
    </message>
    <message>
        <source>Energy balance</source>
        <translation>Vart energin tog vägen</translation>
    </message>
    <message>
        <source>share of E₀</source>
        <translation>andel av E₀</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energi</translation>
    </message>
    <message>
        <source>Largest stresses of every section</source>
        <translation>Största spänningar i varje sektion</translation>
    </message>
    <message>
        <source>Places are from the rear end of a section. Reflected at a joint: the energy that the far end of the section reflects of the waves from the hammer, as a share of the hammer energy.</source>
        <translation>Lägen räknas från sektionens bakände. Reflexionen i skarven är den andel av hammarens energi som skarven vid änden mot berget reflekterar av det som kommer från hammaren.</translation>
    </message>
    <message>
        <source>Required feed force</source>
        <translation>Behov av matningskraft</translation>
    </message>
    <message>
        <source>All gaps between bit and rock</source>
        <translation>Alla spalter mellan krona och berg</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenario</translation>
    </message>
    <message>
        <source>`drill`</source>
        <translation>`drill`</translation>
    </message>
    <message>
        <source>the page &quot;Drilling&quot;</source>
        <translation>sidan ”Borrning”</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>gitter</translation>
    </message>
    <message>
        <source>closed_form</source>
        <translation>sluten form</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nej</translation>
    </message>
    <message>
        <source>The rest of the scenario is in the file attached to the PDF.</source>
        <translation>Resten av scenariot står i filen som är bifogad till PDF:en.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagram</translation>
    </message>
    <message>
        <source>Untitled scenario</source>
        <translation>Scenario utan titel</translation>
    </message>
    <message>
        <source>%1 % of%2</source>
        <translation>%1&#xa0;% av%2</translation>
    </message>
    <message>
        <source>in %1, at its rear end, at %2</source>
        <translation>i %1, vid änden mot hammaren, vid %2</translation>
    </message>
    <message>
        <source>in %1, %2 from its rear end, at %3</source>
        <translation>i %1, %2 från änden mot hammaren, vid %3</translation>
    </message>
    <message>
        <source>stiffness k t₀/Z</source>
        <translation>styvhet k t₀/Z</translation>
    </message>
    <message>
        <source>elasticity of the rock</source>
        <translation>bergets elasticitet</translation>
    </message>
    <message>
        <source>transit time of the string over t₀</source>
        <translation>strängens gångtid genom t₀</translation>
    </message>
    <message>
        <source>gap d/d₀</source>
        <translation>spalt d/d₀</translation>
    </message>
    <message>
        <source>duration of the blow</source>
        <translation>slagets varaktighet</translation>
    </message>
    <message>
        <source>impulse of the blow</source>
        <translation>slagets impuls</translation>
    </message>
    <message>
        <source>energy I₀²/(2 m), m of the string</source>
        <translation>energi I₀²/(2 m), m för strängen</translation>
    </message>
    <message>
        <source>mean force I₀/t₀</source>
        <translation>medelkraft I₀/t₀</translation>
    </message>
    <message>
        <source>its stress in the rod</source>
        <translation>dess spänning i stången</translation>
    </message>
    <message>
        <source>displacement 2 I₀/Z, Z of the rod</source>
        <translation>förskjutning 2 I₀/Z, Z för stången</translation>
    </message>
    <message>
        <source>twice the transit time of the hammer</source>
        <translation>hammarens dubbla gångtid</translation>
    </message>
    <message>
        <source>momentum of the hammer</source>
        <translation>hammarens rörelsemängd</translation>
    </message>
    <message>
        <source>energy of the hammer</source>
        <translation>hammarens energi</translation>
    </message>
    <message>
        <source>force Z v₀/2, Z of the rod</source>
        <translation>kraft Z v₀/2, Z för stången</translation>
    </message>
    <message>
        <source>displacement v₀ t₀</source>
        <translation>förskjutning v₀ t₀</translation>
    </message>
    <message>
        <source>mass of the hammer</source>
        <translation>hammarens massa</translation>
    </message>
    <message>
        <source>length of the hammer</source>
        <translation>hammarens längd</translation>
    </message>
    <message>
        <source>mass of the string</source>
        <translation>strängens massa</translation>
    </message>
    <message>
        <source>length of the string</source>
        <translation>strängens längd</translation>
    </message>
    <message>
        <source>at x/L = %1, t = %2 t₀</source>
        <translation>vid x/L = %1, t = %2 t₀</translation>
    </message>
    <message>
        <source>%1 from the hammer, at %2</source>
        <translation>%1 från hammaren, vid %2</translation>
    </message>
    <message>
        <source>stiffness k/k₀, k₀ = Z/t₀</source>
        <translation>styvhet k/k₀, k₀ = Z/t₀</translation>
    </message>
    <message>
        <source>transit time T/t₀</source>
        <translation>gångtid T/t₀</translation>
    </message>
    <message>
        <source>gap d/d₀, d₀ = 2 I₀/Z</source>
        <translation>spalt d/d₀, d₀ = 2 I₀/Z</translation>
    </message>
    <message>
        <source>its stress</source>
        <translation>dess spänning</translation>
    </message>
    <message>
        <source>displacement 2 I₀/Z</source>
        <translation>förskjutning 2 I₀/Z</translation>
    </message>
    <message>
        <source>energy I₀²/(2 m)</source>
        <translation>energi I₀²/(2 m)</translation>
    </message>
    <message>
        <source>transit time L/c</source>
        <translation>gångtid L/c</translation>
    </message>
    <message>
        <source>wave speed √(E/ρ)</source>
        <translation>våghastighet √(E/ρ)</translation>
    </message>
    <message>
        <source>mass of the rod</source>
        <translation>stångens massa</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1 vid %2, %3</translation>
    </message>
    <message>
        <source>in the rock</source>
        <translation>i berget</translation>
    </message>
    <message>
        <source>hammer moving back</source>
        <translation>hammare på väg tillbaka</translation>
    </message>
    <message>
        <source>waves in the hammer</source>
        <translation>vågor i hammaren</translation>
    </message>
    <message>
        <source>string moving back</source>
        <translation>sträng på väg tillbaka</translation>
    </message>
    <message>
        <source>waves in the string</source>
        <translation>vågor i strängen</translation>
    </message>
    <message>
        <source>lost in joints</source>
        <translation>förlorat i skarvar</translation>
    </message>
    <message>
        <source>lost in sections</source>
        <translation>förlorat i sektioner</translation>
    </message>
    <message>
        <source>between the faces</source>
        <translation>mellan slagytorna</translation>
    </message>
    <message>
        <source>work of the force</source>
        <translation>kraftens arbete</translation>
    </message>
    <message>
        <source>balance errors</source>
        <translation>balansfel</translation>
    </message>
    <message>
        <source>%1 of the momentum, %2 of the energy</source>
        <translation>%1 för rörelsemängden, %2 för energin</translation>
    </message>
    <message>
        <source>tension after</source>
        <translation>drag efteråt</translation>
    </message>
    <message>
        <source>of yield</source>
        <translation>av sträckgränsen</translation>
    </message>
    <message>
        <source>of fatigue</source>
        <translation>av utmattningsgränsen</translation>
    </message>
    <message>
        <source>joint reflects</source>
        <translation>reflexion i skarv</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>marginal</translation>
    </message>
    <message>
        <source>gap at the blow</source>
        <translation>spalt vid slaget</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>matning</translation>
    </message>
    <message>
        <source>in SI</source>
        <translation>i SI-enheter</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>måste vara ett ändligt tal</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>måste vara större än 0</translation>
    </message>
    <message>
        <source>must be at least 0</source>
        <translation>får inte vara mindre än 0</translation>
    </message>
    <message>
        <source>must be in %1%2</source>
        <translation>måste ligga i %1%2</translation>
    </message>
    <message>
        <source>must be greater than %1</source>
        <translation>måste vara större än %1</translation>
    </message>
    <message>
        <source>must be at least %1</source>
        <translation>måste vara minst %1</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>måste vara ett heltal</translation>
    </message>
    <message>
        <source>cannot be stored: its values are at the limit of double precision, it reads back as %1</source>
        <translation>går inte att behålla: värdena som det följer av ligger vid gränsen för dubbel precision, det läses tillbaka som %1</translation>
    </message>
    <message>
        <source>in a larger one, double precision is too coarse to place a wave</source>
        <translation>vid större värden är talen i dubbel precision för grova för att placera en våg</translation>
    </message>
    <message>
        <source>must not be a whole number: numbers are the places of sections</source>
        <translation>får inte vara ett heltal: tal är sektionernas nummer</translation>
    </message>
    <message>
        <source>must not begin or end with a blank</source>
        <translation>får inte börja eller sluta med ett blanksteg</translation>
    </message>
    <message>
        <source>must have at most %1 bytes</source>
        <translation>får ha högst %1 byte</translation>
    </message>
    <message>
        <source>must be less than the diameter of %1</source>
        <translation>måste vara mindre än diametern på %1</translation>
    </message>
    <message>
        <source>must be larger than the bore of %1</source>
        <translation>måste vara större än spolhålet på %1</translation>
    </message>
    <message>
        <source>must have at least one section</source>
        <translation>måste ha minst en sektion</translation>
    </message>
    <message>
        <source>each part must be one section, or a repeat of at least one</source>
        <translation>varje del måste vara en sektion, eller en upprepning av minst en</translation>
    </message>
    <message>
        <source>only for a repeat</source>
        <translation>bara en upprepning har det</translation>
    </message>
    <message>
        <source>has %1 sections, its repeats written out; at most %2 are followed</source>
        <translation>har %1 sektioner, upprepningar utskrivna; högst %2 följs</translation>
    </message>
    <message>
        <source>losses inside the hammer are not modelled: give them to sections of the string</source>
        <translation>förluster inne i hammaren ingår inte i modellen: ange dem för sektioner i strängen</translation>
    </message>
    <message>
        <source>is so narrow that its face only covers the bore of %1 of the section it strikes</source>
        <translation>är så smal att slagytan bara träffar spolhålet på %1 i den sektion den slår mot</translation>
    </message>
    <message>
        <source>the values are too large or too small: impedance, transit time or mass overflows</source>
        <translation>värdena är så stora eller små att impedans, gångtid eller massa hamnar utanför talområdet</translation>
    </message>
    <message>
        <source>is missing: a law with corners needs at least one, as `bit_rock.corner.1.force` and `bit_rock.corner.1.slope`</source>
        <translation>saknas: en lag med hörn behöver minst ett, som `bit_rock.corner.1.force` och `bit_rock.corner.1.slope`</translation>
    </message>
    <message>
        <source>has %1 corners, at most %2 are possible</source>
        <translation>har %1 hörn, högst %2 är möjliga</translation>
    </message>
    <message>
        <source>must be greater than the force of the corner before it, %1</source>
        <translation>måste vara större än kraften i hörnet före, %1</translation>
    </message>
    <message>
        <source>must be at most 1/gamma = %1, because loading steeper than unloading would create energy</source>
        <translation>får vara högst 1/gamma = %1: belastning brantare än avlastning skulle skapa energi</translation>
    </message>
    <message>
        <source>is missing: a corner has a force and a slope</source>
        <translation>saknas: ett hörn har en kraft och en lutning</translation>
    </message>
    <message>
        <source>rise and fall together must not exceed 1, they are %1</source>
        <translation>stigning och fall får tillsammans inte överstiga 1, de är %1</translation>
    </message>
    <message>
        <source>is the reference case of a uniform rod (`drillwave: 1`); a drill string takes any other shape</source>
        <translation>är referensfallet för en likformig stång (`drillwave: 1`); en borrsträng kan ha vilken annan form som helst</translation>
    </message>
    <message>
        <source>the hammer&apos;s impedance is %1 times the rod&apos;s, too many steps to follow; use the shape exponential, a rigid hammer</source>
        <translation>hammarens impedans är %1 gånger stångens, för många steg att följa; använd formen exponential, en stel hammare</translation>
    </message>
    <message>
        <source>with tau = %1 the bit meets the rock after %2 t0, too late for double precision to resolve one t0 (at most %3)%4</source>
        <translation>med tau = %1 möter borrkronan berget efter %2 t0, för sent för att dubbel precision ska kunna säga vad som händer inom ett t0 (högst %3)%4</translation>
    </message>
    <message>
        <source>the values are too large or too small: the force or energy of the blow overflows</source>
        <translation>värdena är så stora eller små att slagets kraft eller energi hamnar utanför talområdet</translation>
    </message>
    <message>
        <source>; it follows from the other values</source>
        <translation>; det följer av de andra värdena</translation>
    </message>
    <message>
        <source>needs at least two points of time and force</source>
        <translation>behöver minst två punkter med tid och kraft</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>har fler än %1 punkter</translation>
    </message>
    <message>
        <source>point %1 must be finite numbers</source>
        <translation>punkt %1 måste vara ändliga tal</translation>
    </message>
    <message>
        <source>point %1 has a negative force, a hammer only pushes</source>
        <translation>punkt %1 har en negativ kraft, en hammare kan bara trycka</translation>
    </message>
    <message>
        <source>point %1 must be later than the one before it</source>
        <translation>punkt %1 måste vara senare än den före</translation>
    </message>
    <message>
        <source>must have a force greater than 0 somewhere</source>
        <translation>måste ha en kraft större än 0 någonstans</translation>
    </message>
    <message>
        <source>lasts too long</source>
        <translation>varar för länge</translation>
    </message>
    <message>
        <source>has no unit: write for example `%1 %2`; allowed units: %3</source>
        <translation>har ingen enhet: skriv till exempel `%1 %2`; möjliga enheter: %3</translation>
    </message>
    <message>
        <source>a decimal comma is not read here: write a decimal point</source>
        <translation>decimalkomma godtas inte här: skriv decimalpunkt</translation>
    </message>
    <message>
        <source>must be a plain number: remove %1</source>
        <translation>måste vara ett rent tal, %1 är för mycket</translation>
    </message>
    <message>
        <source>unit %1 is not known here; allowed units: %2</source>
        <translation>enheten %1 är okänd här; möjliga enheter: %2</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>är tomt</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>är inget tal</translation>
    </message>
    <message>
        <source>is too large or too small for a number of double precision</source>
        <translation>är för stort eller för litet för ett tal i dubbel precision</translation>
    </message>
    <message>
        <source>must be a list of corners: `- {force: 90 kN, slope: 0.35}`</source>
        <translation>måste vara en lista med hörn: `- {force: 90 kN, slope: 0.35}`</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>måste vara något av %1</translation>
    </message>
    <message>
        <source>is missing: write for example `corners: [{force: 90 kN, slope: 0.35}]`</source>
        <translation>saknas: skriv till exempel `corners: [{force: 90 kN, slope: 0.35}]`</translation>
    </message>
    <message>
        <source>only for a law with corners; write `law: corners`</source>
        <translation>bara en lag med hörn har det; skriv `law: corners`</translation>
    </message>
    <message>
        <source>must be a list of presets, `- name: …`</source>
        <translation>måste vara en lista med förval, `- name: …`</translation>
    </message>
    <message>
        <source>each preset must begin with `name: …`</source>
        <translation>varje förval måste börja med `name: …`</translation>
    </message>
    <message>
        <source>must be text</source>
        <translation>måste vara text</translation>
    </message>
    <message>
        <source>is the name of another preset too</source>
        <translation>är även namnet på ett annat förval</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>saknas</translation>
    </message>
    <message>
        <source>the file must begin with `drillwave_presets: 1`</source>
        <translation>filen måste börja med `drillwave_presets: 1`</translation>
    </message>
    <message>
        <source>is missing: the first line must be `drillwave_presets: 1`</source>
        <translation>saknas: första raden måste vara `drillwave_presets: 1`</translation>
    </message>
    <message>
        <source>this program reads the format %1</source>
        <translation>detta program läser formatet %1</translation>
    </message>
    <message>
        <source>the source %1</source>
        <translation>källan %1</translation>
    </message>
    <message>
        <source>must be [value, source]; write `assumed` if there is no source</source>
        <translation>måste vara [värde, källa], med källan `assumed` där det inte finns någon</translation>
    </message>
    <message>
        <source>must be a shape of a hammer blow that needs no table</source>
        <translation>måste vara en form på hammarslaget som inte behöver någon tabell</translation>
    </message>
    <message>
        <source>goes with a diameter, not with an area</source>
        <translation>hör till en diameter, inte till en area</translation>
    </message>
    <message>
        <source>and %1 more problems</source>
        <translation>och %1 fel till</translation>
    </message>
    <message>
        <source>only for a table; the shape is %1</source>
        <translation>bara en tabell har det, formen är %1</translation>
    </message>
    <message>
        <source>each point must be [time, force], as in %1</source>
        <translation>varje punkt måste vara [tid, kraft], som i %1</translation>
    </message>
    <message>
        <source>must be a list of [time, force]</source>
        <translation>måste vara en lista med [tid, kraft]</translation>
    </message>
    <message>
        <source>must be the name of a CSV file</source>
        <translation>måste vara namnet på en CSV-fil</translation>
    </message>
    <message>
        <source>%1 (needs a unit in brackets, one of %2)</source>
        <translation>%1 (behöver en enhet inom hakparentes, en av %2)</translation>
    </message>
    <message>
        <source>%1 (must have no unit in a dimensionless scenario)</source>
        <translation>%1 (får inte ha någon enhet i ett dimensionslöst scenario)</translation>
    </message>
    <message>
        <source>the header must be %1</source>
        <translation>huvudet måste vara %1</translation>
    </message>
    <message>
        <source>the pulse table %1</source>
        <translation>slagets tabell %1</translation>
    </message>
    <message>
        <source>the scenario file %1</source>
        <translation>scenariofilen %1</translation>
    </message>
    <message>
        <source>the scenario is larger than 1 MiB</source>
        <translation>scenariot är större än 1 MiB</translation>
    </message>
    <message>
        <source>the scenario is larger than 1 MiB, the limit for files; keep the points of a table in a CSV file</source>
        <translation>scenariot är större än 1 MiB, vilket ingen fil får vara; lägg tabellens punkter i en CSV-fil</translation>
    </message>
    <message>
        <source>is missing: the first line must be `drillwave: %1`</source>
        <translation>saknas: första raden måste vara `drillwave: %1`</translation>
    </message>
    <message>
        <source>must be the first key of the file</source>
        <translation>måste vara filens första nyckel</translation>
    </message>
    <message>
        <source>this file says drillwave: %1; this program reads up to %2, use a newer one</source>
        <translation>filen säger drillwave: %1; detta program läser upp till %2, använd ett nyare</translation>
    </message>
    <message>
        <source>the format number must be %1 for a uniform rod or %2 for a drill string</source>
        <translation>formatnumret måste vara %1 för en likformig stång eller %2 för en borrsträng</translation>
    </message>
    <message>
        <source>belongs to a drill string: a file that has it begins with `drillwave: 2`</source>
        <translation>hör till en borrsträng: en fil som har det börjar med `drillwave: 2`</translation>
    </message>
    <message>
        <source>belongs to a uniform rod: a file that has it begins with `drillwave: 1`; a drill string has `string` instead of `rod`, and `hammer` or `pulse`</source>
        <translation>hör till en likformig stång: en fil som har det börjar med `drillwave: 1`; en borrsträng har `string` i stället för `rod`, och `hammer` eller `pulse`</translation>
    </message>
    <message>
        <source>cannot be combined with `dimensionless`: give one or the other</source>
        <translation>kan inte stå bredvid `dimensionless`: ange det ena eller det andra</translation>
    </message>
    <message>
        <source>the file must be lines of `key: value`, the first `drillwave: 1`</source>
        <translation>filen måste bestå av rader `key: value`, den första `drillwave: 1`</translation>
    </message>
    <message>
        <source>must be a list of sections: `- {length: 300 mm, diameter: 50 mm}`</source>
        <translation>måste vara en lista med sektioner: `- {length: 300 mm, diameter: 50 mm}`</translation>
    </message>
    <message>
        <source>: write for example `%1`</source>
        <translation>: skriv till exempel `%1`</translation>
    </message>
    <message>
        <source>is not a known key; known here: %1</source>
        <translation>är ingen känd nyckel; kända här: %1</translation>
    </message>
    <message>
        <source>is not a known key, did you mean `%1`?</source>
        <translation>är ingen känd nyckel, menade du `%1`?</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>är angivet två gånger</translation>
    </message>
    <message>
        <source>must be a section of `key: value` lines</source>
        <translation>måste vara ett avsnitt med rader `key: value`</translation>
    </message>
    <message>
        <source>has no value%1</source>
        <translation>har inget värde%1</translation>
    </message>
    <message>
        <source>must be one value%1</source>
        <translation>måste vara ett värde%1</translation>
    </message>
    <message>
        <source>is missing, one of %1</source>
        <translation>saknas, något av %1</translation>
    </message>
    <message>
        <source>is missing%1</source>
        <translation>saknas%1</translation>
    </message>
    <message>
        <source>is missing: give it or %1</source>
        <translation>saknas: ange det eller %1</translation>
    </message>
    <message>
        <source>cannot be combined with %1: give one or the other</source>
        <translation>kan inte stå bredvid %1: ange det ena eller det andra</translation>
    </message>
    <message>
        <source>must be a list of sections: `- {name: rod, length: 3660 mm, diameter: 39 mm}`</source>
        <translation>måste vara en lista med sektioner: `- {name: rod, length: 3660 mm, diameter: 39 mm}`</translation>
    </message>
    <message>
        <source>must be a section: `{length: 300 mm, diameter: 50 mm}`</source>
        <translation>måste vara en sektion: `{length: 300 mm, diameter: 50 mm}`</translation>
    </message>
    <message>
        <source>is empty; leave it out for a section without a name</source>
        <translation>är tomt; en sektion utan namn skrivs utan det</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>har inget värde</translation>
    </message>
    <message>
        <source>must be one value</source>
        <translation>måste vara ett värde</translation>
    </message>
    <message>
        <source>is missing: write for example `length: 3660 mm`</source>
        <translation>saknas: skriv till exempel `length: 3660 mm`</translation>
    </message>
    <message>
        <source>goes with an area, not with a diameter</source>
        <translation>hör till en area, inte till en diameter</translation>
    </message>
    <message>
        <source>a hammer has no repeats; write its sections out</source>
        <translation>en hammare har inga upprepningar; skriv ut dess sektioner</translation>
    </message>
    <message>
        <source>a repeat cannot contain another one</source>
        <translation>en upprepning kan inte stå inne i en annan</translation>
    </message>
    <message>
        <source>has more than %1 sections, its repeats written out</source>
        <translation>har fler än %1 sektioner, upprepningar utskrivna</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>måste vara true eller false</translation>
    </message>
    <message>
        <source>must be a section, `{name: rod, length: 3660 mm, diameter: 39 mm}`, or `{repeat: 3, of: […]}`</source>
        <translation>måste vara en sektion, `{name: rod, length: 3660 mm, diameter: 39 mm}`, eller `{repeat: 3, of: […]}`</translation>
    </message>
    <message>
        <source>is missing: give the list of the sections to repeat</source>
        <translation>saknas: listan över de sektioner som upprepas</translation>
    </message>
    <message>
        <source>must be a list of at least one section</source>
        <translation>måste vara en lista med minst en sektion</translation>
    </message>
    <message>
        <source>is missing: write for example `repeat: 3`</source>
        <translation>saknas: skriv till exempel `repeat: 3`</translation>
    </message>
    <message>
        <source>cannot be combined with `hammer`: keep one, a hammer of sections or a force instead of it</source>
        <translation>står bredvid `hammer`: behåll ett, en hammare av sektioner eller en kraft i dess ställe</translation>
    </message>
    <message>
        <source>only for drill strings (`drillwave: 2`); this is a uniform rod</source>
        <translation>bara en borrsträng har det (`drillwave: 2`), detta är en likformig stång</translation>
    </message>
    <message>
        <source>only for uniform rods (`drillwave: 1`); this is a drill string</source>
        <translation>bara en likformig stång har det (`drillwave: 1`), detta är en borrsträng</translation>
    </message>
    <message>
        <source>only for a force instead of the hammer (`pulse`); this string is struck by a hammer</source>
        <translation>bara en kraft i hammarens ställe har det (`pulse`), denna sträng slås av en hammare</translation>
    </message>
    <message>
        <source>only for a hammer of sections (`hammer`); this string is driven by a force (`pulse`)</source>
        <translation>bara en hammare av sektioner har det (`hammer`), denna sträng drivs av en kraft (`pulse`)</translation>
    </message>
    <message>
        <source>the scenario is given by its dimensionless groups</source>
        <translation>scenariot är givet av sina dimensionslösa tal</translation>
    </message>
    <message>
        <source>the scenario is given by its dimensionless groups; set `%1` instead</source>
        <translation>scenariot är givet av sina dimensionslösa tal; sätt `%1` i stället</translation>
    </message>
    <message>
        <source>follows from the lengths of hammer and string; set those, as `string.1.length`</source>
        <translation>följer av längderna på hammare och sträng; sätt dem, t.ex. `string.1.length`</translation>
    </message>
    <message>
        <source>%1; set its sections, as `string.1.length`</source>
        <translation>%1; sätt dess sektioner, t.ex. `string.1.length`</translation>
    </message>
    <message>
        <source>only for %1; set `%2=%3` too</source>
        <translation>bara %1 har det; sätt även `%2=%3`</translation>
    </message>
    <message>
        <source>needs a unit, because this scenario has physical units</source>
        <translation>behöver en enhet, eftersom scenariot är i fysikaliska storheter</translation>
    </message>
    <message>
        <source>has no unit in a dimensionless scenario</source>
        <translation>har ingen enhet i ett dimensionslöst scenario</translation>
    </message>
    <message>
        <source>only for a trapezoid; the shape is %1</source>
        <translation>bara en trapets har det, formen är %1</translation>
    </message>
    <message>
        <source>follows from the diameters and materials of hammer and rod</source>
        <translation>följer av diametrar och material hos hammare och stång</translation>
    </message>
    <message>
        <source>only for a piston; the shape is %1</source>
        <translation>bara en kolv har det, formen är %1</translation>
    </message>
    <message>
        <source>the rod is given by its area; set `rod.area` or `rod.diameter`</source>
        <translation>stången är given av sin area; sätt `rod.area` eller `rod.diameter`</translation>
    </message>
    <message>
        <source>follows from the data of the %1</source>
        <translation>följer av data för %1</translation>
    </message>
    <message>
        <source>a carriage return without a line feed</source>
        <translation>en vagnretur utan radmatning</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>en NUL-byte</translation>
    </message>
    <message>
        <source>a control character</source>
        <translation>ett styrtecken</translation>
    </message>
    <message>
        <source>a byte that is not UTF-8</source>
        <translation>en byte som inte är UTF-8</translation>
    </message>
    <message>
        <source>is not a text file: it holds %1</source>
        <translation>är ingen textfil: den innehåller %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>filen är tom</translation>
    </message>
    <message>
        <source>more than %1 levels of nesting are not accepted</source>
        <translation>fler än %1 nästlingsnivåer godtas inte</translation>
    </message>
    <message>
        <source>an alias (*) is not accepted here: write the value itself</source>
        <translation>ett alias (*) godtas inte här: skriv själva värdet</translation>
    </message>
    <message>
        <source>an anchor (&amp;) is not accepted here: write the value itself</source>
        <translation>ett ankare (&amp;) godtas inte här: skriv själva värdet</translation>
    </message>
    <message>
        <source>a tag (!) is not accepted here: write only the value</source>
        <translation>en tagg (!) godtas inte här: skriv bara värdet</translation>
    </message>
    <message>
        <source>not YAML: the quote that begins here is not closed</source>
        <translation>inte YAML: citattecknet som börjar här är inte stängt</translation>
    </message>
    <message>
        <source>there are too many values from here on</source>
        <translation>härifrån är det för många värden</translation>
    </message>
    <message>
        <source>not YAML: %1</source>
        <translation>inte YAML: %1</translation>
    </message>
    <message>
        <source>The force is no longer prescribed: reflected waves can separate the hammer from the rod.</source>
        <translation>Slaget är ingen föreskriven kraft längre: vågor som kommer tillbaka till hammaren medan den ännu trycker skiljer den från stången.</translation>
    </message>
    <message>
        <source>%1 of %2 sections have another impedance (couplings, adapter, bit): they became rod, which reflects nothing.</source>
        <translation>%1 av %2 sektioner har en annan impedans (skarvhylsor, nackadapter, krona): de har blivit stång, som inte reflekterar något.</translation>
    </message>
    <message>
        <source>The lumped masses, that of the bit among them.</source>
        <translation>Punktmassorna, kronans bland dem.</translation>
    </message>
    <message>
        <source>The losses in joints and along the rods.</source>
        <translation>Förlusterna i skarvar och längs stängerna.</translation>
    </message>
    <message>
        <source>The steps of the hammer: it became uniform, with the same mass, velocity and travel time of waves.</source>
        <translation>Hammarens steg: den har blivit likformig, med samma massa, hastighet och gångtid.</translation>
    </message>
    <message>
        <source>The elastic face of the hammer: it is rigid.</source>
        <translation>Hammarens elastiska slagyta: den är stel.</translation>
    </message>
    <message>
        <source>After separation the hammer is withdrawn: it does not strike again.</source>
        <translation>Hammaren träffas inte igen efter separationen: den är tillbakadragen.</translation>
    </message>
    <message>
        <source>it is a drill string already</source>
        <translation>det är redan en borrsträng</translation>
    </message>
    <message>
        <source>a drill string has physical units, and this scenario has none</source>
        <translation>en borrsträng har fysikaliska enheter, och detta scenario har inga</translation>
    </message>
    <message>
        <source>the reference case of a rod that arrives without waves has no hammer</source>
        <translation>referensfallet med en stång som kommer fram utan vågor har ingen hammare</translation>
    </message>
    <message>
        <source>Waves reflected to the hammer are left out: the force is that of the hammer on an endless rod.</source>
        <translation>Det som kommer tillbaka till hammaren: kraften är hammarens på en oändligt lång stång.</translation>
    </message>
    <message>
        <source>The time until which the blow is followed.</source>
        <translation>Tiden till vilken slaget följs.</translation>
    </message>
    <message>
        <source>such a blow has too many waves to keep</source>
        <translation>vågorna i ett sådant slag är för många för att sparas</translation>
    </message>
    <message>
        <source>some output has no value</source>
        <translation>det saknar tal för ett av resultaten</translation>
    </message>
    <message>
        <source>it has too many waves to keep</source>
        <translation>dess vågor är fler än som kan sparas</translation>
    </message>
    <message>
        <source>the hammer pushes longer than the reflections that are computed</source>
        <translation>hammaren trycker fortfarande när dess våg har återvänt oftare än som följs</translation>
    </message>
    <message>
        <source>it has no such output</source>
        <translation>det har inget sådant resultat</translation>
    </message>
    <message>
        <source>the damper, or the face of the hammer, is too stiff for the time step</source>
        <translation>dämparen, eller hammarens slagyta, är för styv för beräkningens celler</translation>
    </message>
    <message>
        <source>the contact of damper or hammer with the rear end changes without end</source>
        <translation>dämparen, eller hammaren, möter och lämnar bakänden utan slut</translation>
    </message>
    <message>
        <source>an event at the rear end cannot be placed</source>
        <translation>en händelse vid bakänden går inte att placera</translation>
    </message>
    <message>
        <source>the wave force overflowed</source>
        <translation>vågkraften hamnade utanför talområdet</translation>
    </message>
    <message>
        <source>its energies do not balance, so that its numbers are wrong</source>
        <translation>dess energibalans går inte ihop, så att dess tal är fel</translation>
    </message>
    <message>
        <source>its error would be larger than permitted</source>
        <translation>dess fel skulle vara större än tillåtet</translation>
    </message>
    <message>
        <source>the order of two events hangs on rounding</source>
        <translation>ordningen mellan två händelser hänger på avrundningen</translation>
    </message>
    <message>
        <source>its numbers are beyond the range of double precision</source>
        <translation>dess tal ligger utanför talområdet för dubbel precision</translation>
    </message>
    <message>
        <source>an event at the rock cannot be placed</source>
        <translation>en händelse vid berget går inte att placera</translation>
    </message>
    <message>
        <source>bit and rock change contact, or a small bit mass oscillates, faster than can be computed</source>
        <translation>krona och berg möts och skiljs, eller en liten kronmassa svänger, fortare än som kan följas</translation>
    </message>
    <message>
        <source>the contact of hammer and string changes without end</source>
        <translation>hammarens och strängens slagytor möts och skiljs utan slut</translation>
    </message>
    <message>
        <source>a contact of hammer and string cannot be placed</source>
        <translation>en kontakt mellan hammare och sträng går inte att placera</translation>
    </message>
    <message>
        <source>contacts change too often, or a bit mass oscillates too fast: try softer rock, a larger gamma, no bit mass or a shorter end_time</source>
        <translation>krona och berg, eller hammare och sträng, möts och skiljs för ofta, eller en kronmassa svänger för fort, för att följas: ett mjukare berg, ett större gamma, ingen kronmassa eller ett tidigare end_time behöver mindre</translation>
    </message>
    <message>
        <source>polynomial cells need a force or a hammer; this rod arrives without waves</source>
        <translation>en stång som i sin helhet rör sig mot berget är inget för polynomceller, som följer en kraft eller en hammare</translation>
    </message>
    <message>
        <source>losses inside the hammer are not modelled: give loss and attenuation only to the string</source>
        <translation>förluster inne i hammaren ingår inte i modellen: ange loss och attenuation bara för strängen</translation>
    </message>
    <message>
        <source>the bit mass oscillates too fast on this rock: leave it out (it is too small to matter), or give a softer rock</source>
        <translation>kronmassan svänger för fort på detta berg för att följas: utelämna den, den är för liten för att spela roll, eller ange ett mjukare berg</translation>
    </message>
    <message>
        <source>a hammer that strikes, several sections, masses and losses are not for this method, which follows a force on a uniform rod</source>
        <translation>en hammare som slår, flera sektioner, massor och förluster är inget för denna metod, som följer en kraft på en likformig stång</translation>
    </message>
    <message>
        <source>is given %1 times; keep one of them</source>
        <translation>är angivet %1 gånger; behåll ett av dem</translation>
    </message>
    <message>
        <source>ends in .csv and holds no scenario; only CSV files of run, gap, thrust and accuracy do (for a sweep or table it is in the .yaml file beside it)</source>
        <translation>antas vara ett resultat, eftersom namnet slutar på .csv, men innehåller inget scenario; bara CSV-filerna från run, gap, thrust och accuracy börjar med ett (sweep och table har det i .yaml-filen bredvid)</translation>
    </message>
    <message>
        <source>is a web page and holds no scenario; only the HTML files of `drillwave report` begin with one</source>
        <translation>är en webbsida men innehåller inget scenario; bara HTML-filerna från `drillwave report` börjar med ett</translation>
    </message>
    <message>
        <source>is larger than 4 MiB, the limit for this kind of file</source>
        <translation>är större än 4 MiB, för stor för att vara avsedd</translation>
    </message>
    <message>
        <source>ends in .json and holds no `scenario`; give the scenario file</source>
        <translation>antas vara ett resultat, eftersom namnet slutar på .json, men innehåller inget `scenario`; ange scenariofilen</translation>
    </message>
    <message>
        <source>the scenario file is larger than 1024 KiB, the limit for scenario files</source>
        <translation>scenariofilen är större än 1024 KiB, för stor för att vara avsedd</translation>
    </message>
    <message>
        <source>holds no scenario of a result</source>
        <translation>innehåller inget scenario från ett resultat</translation>
    </message>
    <message>
        <source>the reflections overlap, which the closed form neglects: the contact is not over when the third wave arrives; use the exact method or the lattice</source>
        <translation>reflexionerna överlappar, vilket den slutna formen försummar: kontakten är inte över när den tredje vågen kommer; använd den exakta metoden eller gittret</translation>
    </message>
    <message>
        <source>the momentum after a separation is zero within rounding: it cannot be decided whether the rod returns</source>
        <translation>rörelsemängden efter en separation är noll inom avrundningen: om stången återvänder är oavgjort</translation>
    </message>
    <message>
        <source>the lattice needs more than the permitted number of steps; use fewer segments or the exact method</source>
        <translation>gittret behöver fler steg än tillåtet; använd färre segment eller den exakta metoden</translation>
    </message>
    <message>
        <source>the lattice found more than the permitted number of events; use the exact method</source>
        <translation>gittret fann fler händelser än tillåtet; använd den exakta metoden</translation>
    </message>
    <message>
        <source>lattices with other step lengths have no solution, so the error cannot be estimated; use more segments or the exact method</source>
        <translation>gitter med andra steglängder finner ingen lösning, så att felet inte kan uppskattas; använd fler segment eller den exakta metoden</translation>
    </message>
    <message>
        <source>%1; joining needs the records written with the parts</source>
        <translation>%1; delar sätts ihop efter de .yaml-filer som skrevs tillsammans med dem</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>del %1 av %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 till %2</translation>
    </message>
    <message>
        <source>is not a record of rows</source>
        <translation>är ingen .yaml-fil till rader</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kan inte läsas: %1</translation>
    </message>
    <message>
        <source>is of another format than %1, from a newer program</source>
        <translation>har ett annat format än %1, från ett nyare program</translation>
    </message>
    <message>
        <source>has no command</source>
        <translation>saknar kommando</translation>
    </message>
    <message>
        <source>part: %1 is no part I/N</source>
        <translation>part: %1 är ingen del I/N</translation>
    </message>
    <message>
        <source>%1: is %2, as %3 is; give each part once</source>
        <translation>%1: är %2, liksom %3; ange varje del en gång</translation>
    </message>
    <message>
        <source>part %1 of %2 is missing; run it, or name its file</source>
        <translation>del %1 av %2 saknas; kör den, eller ange dess fil</translation>
    </message>
    <message>
        <source>parts %1 of %2 are missing; run them, or name their files</source>
        <translation>delarna %1 av %2 saknas; kör dem, eller ange deras filer</translation>
    </message>
    <message>
        <source>%1: has %2 rows, but %3 of all %4 has %5; it belongs to another run</source>
        <translation>%1: har %2 rader, men %3, av totalt %4 rader, har %5; filen hör till en annan körning</translation>
    </message>
    <message>
        <source>a dimensionless scenario has no drill; give the rod and the drill in units</source>
        <translation>ett dimensionslöst scenario har ingen borrmaskin; ange stången och borrmaskinen med enheter</translation>
    </message>
    <message>
        <source>is missing: many blows require it</source>
        <translation>saknas: många slag kräver det</translation>
    </message>
    <message>
        <source>the reference case rigid_body is one impact and has no blows</source>
        <translation>referensfallet rigid_body är en enda stöt och har inga slag</translation>
    </message>
    <message>
        <source>needs drill.machine_mass, which the damper carries</source>
        <translation>kräver drill.machine_mass, som dämparen bär</translation>
    </message>
    <message>
        <source>%1 must be less than the blows, which are %2</source>
        <translation>%1 måste vara mindre än antalet slag, som är %2</translation>
    </message>
    <message>
        <source>a blow lasts %1 s, not less than the interval of the blows; lower the frequency or shorten the blow</source>
        <translation>ett slag varar %1 s, vilket inte är kortare än tiden mellan slagen; sänk frekvensen eller gör slaget kortare</translation>
    </message>
    <message>
        <source>waves take longer from hammer to bit than from blow to blow (%1 round trips); lower the frequency or make the string shorter</source>
        <translation>vågorna behöver längre tid från hammare till borrkrona än det är mellan slagen (%1 varv fram och åter); sänk frekvensen eller gör strängen kortare</translation>
    </message>
    <message>
        <source>must be %1 or %2</source>
        <translation>måste vara %1 eller %2</translation>
    </message>
    <message>
        <source>only for uniform rods (`drillwave: 1`)</source>
        <translation>bara en likformig stång har det (`drillwave: 1`)</translation>
    </message>
    <message>
        <source>only for drill strings (`drillwave: 2`)</source>
        <translation>bara en borrsträng har det (`drillwave: 2`)</translation>
    </message>
    <message>
        <source>only for a hammer of sections (`hammer`); this string is driven by a force</source>
        <translation>bara en hammare av sektioner har det (`hammer`), denna sträng drivs av en kraft</translation>
    </message>
    <message>
        <source>only for faces with a stiffness (`hammer.face_stiffness`)</source>
        <translation>bara slagytor med styvhet har det (`hammer.face_stiffness`)</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 celler</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 bitar</translation>
    </message>
    <message>
        <source>%1 of %2 segments</source>
        <translation>%1 med %2 segment</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 steg</translation>
    </message>
    <message>
        <source>the feed force margin is known only for uniform rods (`drillwave: 1`)</source>
        <translation>matningskraftens marginal är känd bara för likformiga stänger (`drillwave: 1`)</translation>
    </message>
    <message>
        <source>the feed force margin needs drill.thrust; give it in the scenario or with --set</source>
        <translation>matningskraftens marginal förutsätter drill.thrust; ange den i scenariot eller med --set</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kan inte öppnas: %1</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>filen finns inte</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>är en mapp, ingen fil</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>är ingen vanlig fil</translation>
    </message>
    <message>
        <source>is larger than the limit of %1 KiB</source>
        <translation>är större än %1 KiB, för stor för att kunna vara avsedd</translation>
    </message>
    <message>
        <source>set the same thing</source>
        <translation>sätter samma sak</translation>
    </message>
    <message>
        <source>`%1` is not a number; write it into the scenario file</source>
        <translation>`%1` är inget tal; skriv det i scenariofilen</translation>
    </message>
    <message>
        <source>does not apply here: %1</source>
        <translation>har ingen betydelse här: %1</translation>
    </message>
    <message>
        <source>`%1` is not a parameter</source>
        <translation>`%1` är ingen parameter</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; did you mean `%2`?</source>
        <translation>`%1` är ingen parameter; menade du `%2`?</translation>
    </message>
    <message>
        <source>no section of the hammer is called `%1`; did you mean `%2`?</source>
        <translation>ingen sektion i hammaren heter `%1`; menade du `%2`?</translation>
    </message>
    <message>
        <source>no section of the string is called `%1`; did you mean `%2`?</source>
        <translation>ingen sektion i strängen heter `%1`; menade du `%2`?</translation>
    </message>
    <message>
        <source>no section of the hammer is called `%1`; its names: %2</source>
        <translation>ingen sektion i hammaren heter `%1`; namnen är: %2</translation>
    </message>
    <message>
        <source>no section of the string is called `%1`; its names: %2</source>
        <translation>ingen sektion i strängen heter `%1`; namnen är: %2</translation>
    </message>
    <message>
        <source>no section of the hammer is called `%1`; its sections have no names, give a place: `%2`</source>
        <translation>ingen sektion i hammaren heter `%1`; dess sektioner har inga namn, ange ett nummer: `%2`</translation>
    </message>
    <message>
        <source>no section of the string is called `%1`; its sections have no names, give a place: `%2`</source>
        <translation>ingen sektion i strängen heter `%1`; dess sektioner har inga namn, ange ett nummer: `%2`</translation>
    </message>
    <message>
        <source>the hammer has only %1 section</source>
        <translation>hammaren har bara %1 sektion</translation>
    </message>
    <message>
        <source>the hammer has only %1 sections</source>
        <translation>hammaren har bara %1 sektioner</translation>
    </message>
    <message>
        <source>the string has only %1 section</source>
        <translation>strängen har bara %1 sektion</translation>
    </message>
    <message>
        <source>the string has only %1 sections</source>
        <translation>strängen har bara %1 sektioner</translation>
    </message>
    <message>
        <source>are the same section of a repeat</source>
        <translation>sätter samma sektion, som en upprepning för till båda ställena</translation>
    </message>
    <message>
        <source>set one section: section %1 of the hammer is called %2</source>
        <translation>sätter samma sektion: sektion %1 i hammaren heter %2</translation>
    </message>
    <message>
        <source>set one section: section %1 of the string is called %2</source>
        <translation>sätter samma sektion: sektion %1 i strängen heter %2</translation>
    </message>
    <message>
        <source>the string has no repeat</source>
        <translation>strängen har ingen upprepning</translation>
    </message>
    <message>
        <source>goes with an area, and the section is given by its diameter</source>
        <translation>hör till en area, och sektionen är given av sin diameter</translation>
    </message>
    <message>
        <source>goes with a diameter, and the section is given by its area</source>
        <translation>hör till en diameter, och sektionen är given av sin area</translation>
    </message>
    <message>
        <source>a dimensionless scenario has no drill</source>
        <translation>ett dimensionslöst scenario har ingen borrmaskin</translation>
    </message>
    <message>
        <source>method</source>
        <translation>metod</translation>
    </message>
    <message>
        <source>not solved: %1</source>
        <translation>inte löst: %1</translation>
    </message>
    <message>
        <source>THE RING DOES NOT GIVE THE NUMBERS OF THE MOVED WAVES at %1 segments: please report this.</source>
        <translation>RINGBUFFERTEN GER INTE DE FLYTTADE VÅGORNAS TAL vid %1 segment: rapportera gärna detta.</translation>
    </message>
    <message>
        <source>The ring buffer gives the same numbers as the moved waves, to the last bit.</source>
        <translation>Ringbufferten ger exakt samma tal som de flyttade vågorna, till sista biten.</translation>
    </message>
    <message>
        <source>The table</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>Errors are absolute, forces in F0; lattice and closed form are compared with the exact solution.
estimate: error of e estimated by the method itself. order: observed, from the row above.
force: largest difference of the force history, at ends and middles of all steps; mid-step: at the
middles. A force that is constant in each step cannot be closer than half its change in a step.</source>
        <translation>Felen är absoluta, krafter i F0; gittrets och den slutna formens är mot den exakta lösningen.
uppskattning: vad metoden själv säger om sitt fel i e. ordning: observerad, från raden ovanför.
kraft: största skillnad i kraftförloppet, i alla stegs ändar och mitt; mitt i steget: bara i mitten.
En kraft som är konstant i varje steg kan inte komma närmare än halva sin ändring i ett steg.</translation>
    </message>
    <message>
        <source>Times: processor time of a solve for e only. speed: how many times faster than the paper&apos;s choice,
the lattice of %1 segments with moved waves.</source>
        <translation>Tider: processortid för att lösa enbart e. fart: hur många gånger snabbare än artikelns val,
gittret med %1 segment och flyttade vågor.</translation>
    </message>
    <message>
        <source>%1 Rows of over a second have fewer runs.</source>
        <translation>%1 Rader på över en sekund har färre körningar.</translation>
    </message>
    <message>
        <source>It could not be solved in long double: %1.</source>
        <translation>I long double löstes det inte: %1.</translation>
    </message>
    <message>
        <source>Its errors are differences from a solution in long double (%1 bits, %2),
whose own error is below %3 and included: they show
rounding and truncation, but not a wrong event, as both solutions share the code for events.</source>
        <translation>Dess fel är skillnader mot en lösning i long double (%1 bitar, %2),
vars eget fel är under %3 och medräknat: de visar
avrundning och trunkering, men inte en felaktig händelse: båda behandlar händelser med samma kod.</translation>
    </message>
    <message>
        <source>The exact solution</source>
        <translation>Den exakta lösningen</translation>
    </message>
    <message>
        <source>Therefore the histories were inserted into the equations at %1 points, without that code.
Largest residuals, in F0 (1 + beta/gamma):</source>
        <translation>Därför har dess förlopp satts in i ekvationerna igen i %1 punkter, utan den koden.
Största residualer, i F0 (1 + beta/gamma):</translation>
    </message>
    <message>
        <source>F&apos; = a (2g - F), a = beta or beta/gamma</source>
        <translation>F&apos; = a (2g - F), a = beta eller beta/gamma</translation>
    </message>
    <message>
        <source>F&apos; = a (2g - F), a = s_j beta on line j, or beta/gamma</source>
        <translation>F&apos; = a (2g - F), a = s_j beta på linje j, eller beta/gamma</translation>
    </message>
    <message>
        <source>F = law of the penetration and of the largest one so far</source>
        <translation>F = lag för inträngningen och den hittills största</translation>
    </message>
    <message>
        <source>smallest force</source>
        <translation>minsta kraft</translation>
    </message>
    <message>
        <source>pulse %1</source>
        <translation>slagform %1</translation>
    </message>
    <message>
        <source>e = %1, peak force %2 F0</source>
        <translation>e = %1, toppkraft %2 F0</translation>
    </message>
    <message>
        <source>Over the whole ladder the error of e falls with the number of segments to the power of %1.</source>
        <translation>Över hela serien avtar felet i e med antalet segment upphöjt till %1.</translation>
    </message>
    <message>
        <source>error: error of the efficiency, against %1 (cut cells of half the length, error bound %2)
stated: error bound of the method; impulse: error of the impulse on the rock, over the hammer&apos;s
cells: polynomial cells, cut at jumps (sweep, map); cells_cut: cut at every corner of a wave (run);
plain: a lattice of constant cells, the usual method</source>
        <translation>fel: i verkningsgraden, mot %1 (delade celler av halva storleken, angivet fel %2)
angivet: vad metoden säger om felet; impuls: fel i impulsen på berget, som andel av hammarens
cells: polynomceller delade vid språng (sweep, map); cells_cut: delade vid alla hörn i en våg (run);
plain: ett gitter av konstanta celler, så som andra har det</translation>
    </message>
    <message>
        <source>and returned with the hammer</source>
        <translation>och det hammaren tar tillbaka</translation>
    </message>
    <message>
        <source>work on the rock</source>
        <translation>arbete på berget</translation>
    </message>
    <message>
        <source>impulse 1 + e</source>
        <translation>impuls 1 + e</translation>
    </message>
    <message>
        <source>impulse on the rock</source>
        <translation>impuls på berget</translation>
    </message>
    <message>
        <source>%1 of the hammer&apos;s</source>
        <translation>%1 gånger hammarens</translation>
    </message>
    <message>
        <source>restitution e of the string</source>
        <translation>strängens studstal e</translation>
    </message>
    <message>
        <source>peak force on the rock</source>
        <translation>toppkraft på berget</translation>
    </message>
    <message>
        <source>largest penetration</source>
        <translation>största inträngning</translation>
    </message>
    <message>
        <source>residual penetration</source>
        <translation>kvarstående inträngning</translation>
    </message>
    <message>
        <source>largest compression</source>
        <translation>största tryck</translation>
    </message>
    <message>
        <source>largest tension</source>
        <translation>största drag</translation>
    </message>
    <message>
        <source>compression after</source>
        <translation>tryck efteråt</translation>
    </message>
    <message>
        <source>percussion power</source>
        <translation>slageffekt</translation>
    </message>
    <message>
        <source>penetration rate</source>
        <translation>borrsjunkning</translation>
    </message>
    <message>
        <source>first contact</source>
        <translation>första kontakt</translation>
    </message>
    <message>
        <source>last separation</source>
        <translation>sista separation</translation>
    </message>
    <message>
        <source>time in contact</source>
        <translation>tid i kontakt</translation>
    </message>
    <message>
        <source>hammer separates</source>
        <translation>hammaren släpper</translation>
    </message>
    <message>
        <source>hammer rebound</source>
        <translation>hammarstuds</translation>
    </message>
    <message>
        <source>away from the rock</source>
        <translation>bort från berget</translation>
    </message>
    <message>
        <source>hammer work W</source>
        <translation>hammararbete W</translation>
    </message>
    <message>
        <source>in the rebound</source>
        <translation>i studsen</translation>
    </message>
    <message>
        <source>in waves</source>
        <translation>i vågor</translation>
    </message>
    <message>
        <source>%1 of the force&apos;s</source>
        <translation>%1 gånger kraftens</translation>
    </message>
    <message>
        <source>%1, not met: short by %2 (%3)</source>
        <translation>%1, inte uppfyllt: %2 (%3) saknas</translation>
    </message>
    <message>
        <source>%1, met with %2 (%3) to spare</source>
        <translation>%1, uppfyllt med %2 (%3) till godo</translation>
    </message>
    <message>
        <source>%1, installed %2</source>
        <translation>%1, installerad %2</translation>
    </message>
    <message>
        <source>%1, installed %2, effective %3</source>
        <translation>%1, installerad %2, verksam %3</translation>
    </message>
    <message>
        <source>(error estimated as %1)</source>
        <translation>(felet uppskattat till %1)</translation>
    </message>
    <message>
        <source>(error below %1)</source>
        <translation>(felet under %1)</translation>
    </message>
    <message>
        <source>%1 of I0, %2 of W</source>
        <translation>%1 av I₀, %2 av W</translation>
    </message>
    <message>
        <source>method %1, %2, %3, solved in %4</source>
        <translation>metod %1, %2, %3, löst på %4</translation>
    </message>
    <message>
        <source>%1 contact</source>
        <translation>%1 kontakt</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 kontakter</translation>
    </message>
    <message>
        <source>warning: %1</source>
        <translation>varning: %1</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>anmärkning: %1</translation>
    </message>
    <message>
        <source>least</source>
        <translation>minst</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>minimum</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>kink</source>
        <translation>knäck</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>språng</translation>
    </message>
    <message>
        <source>rises above %1</source>
        <translation>stiger över %1</translation>
    </message>
    <message>
        <source>falls below %1</source>
        <translation>faller under %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>till %1</translation>
    </message>
    <message>
        <source>slope %1 to %2</source>
        <translation>lutning %1 till %2</translation>
    </message>
    <message>
        <source>end of the range</source>
        <translation>områdets ände</translation>
    </message>
    <message>
        <source>between points</source>
        <translation>mellan punkter</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>överallt</translation>
    </message>
    <message>
        <source>and %1 more such stretches</source>
        <translation>och ytterligare %1 sådana avsnitt</translation>
    </message>
    <message>
        <source>Along %1 from %2 to %3, by its logarithm.</source>
        <translation>Längs %1 från %2 till %3, logaritmiskt.</translation>
    </message>
    <message>
        <source>Along %1 from %2 to %3.</source>
        <translation>Längs %1 från %2 till %3.</translation>
    </message>
    <message>
        <source>and %1 more; --json has all</source>
        <translation>och %1 till; --json ger alla</translation>
    </message>
    <message>
        <source>known only at grid points from %1 to %2: %3</source>
        <translation>känt bara i rutnätspunkter från %1 till %2: %3</translation>
    </message>
    <message>
        <source>no answer from %1 to %2: %3</source>
        <translation>inget svar från %1 till %2: %3</translation>
    </message>
    <message>
        <source>%1 blows solved in %2.</source>
        <translation>Beräknat ur %1 slag på %2.</translation>
    </message>
    <message>
        <source>%1 draws of %2</source>
        <translation>%1 dragningar av %2</translation>
    </message>
    <message>
        <source>Uncertain: %1.</source>
        <translation>Osäkert: %1.</translation>
    </message>
    <message>
        <source>%1 (%2 values)</source>
        <translation>%1 (%2 värden)</translation>
    </message>
    <message>
        <source>nothing, only the design of FILE</source>
        <translation>inget, bara konstruktionen i FILE</translation>
    </message>
    <message>
        <source>Design variables: %1; every blow has the energy of FILE.</source>
        <translation>Val: %1; varje slag har samma energi som det i FILE.</translation>
    </message>
    <message>
        <source>Design variables: %1.</source>
        <translation>Val: %1.</translation>
    </message>
    <message>
        <source>%1 design with %2 samples; +- is the 95 % error.</source>
        <translation>%1 konstruktion med %2 stickprov; +- är 95&#xa0;%-felet.</translation>
    </message>
    <message>
        <source>%1 designs with %2 samples each, the same for all; +- is the 95 % error.</source>
        <translation>%1 konstruktioner med %2 stickprov var, samma för alla; +- är 95&#xa0;%-felet.</translation>
    </message>
    <message>
        <source>design</source>
        <translation>konstruktion</translation>
    </message>
    <message>
        <source>%1 nominal</source>
        <translation>%1 nominellt</translation>
    </message>
    <message>
        <source>marginal</source>
        <translation>på gränsen</translation>
    </message>
    <message>
        <source>best for uncertain rock</source>
        <translation>bäst, berget ofullständigt känt</translation>
    </message>
    <message>
        <source>best for the values entered</source>
        <translation>bäst för de angivna värdena</translation>
    </message>
    <message>
        <source>%1 instead of %2: %3 %4, with the values of FILE %5.</source>
        <translation>%1 i stället för %2: %3 %4; där allt är som i FILE %5.</translation>
    </message>
    <message>
        <source>no design is better in all aims</source>
        <translation>ingen är bättre i alla mål</translation>
    </message>
    <message>
        <source>and %1 more: -o DIR writes them all.</source>
        <translation>och %1 till: -o DIR skriver alla.</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>konstant</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>dragningar</translation>
    </message>
    <message>
        <source>acts with others</source>
        <translation>verkar i kombination</translation>
    </message>
    <message>
        <source>Worth measuring: share of the scatter, # by itself, - with others</source>
        <translation>Vad som är värt att mäta: andel av spridningen, # ensam, - med andra</translation>
    </message>
    <message>
        <source>row %1 of the draws</source>
        <translation>rad %1 i dragningarna</translation>
    </message>
    <message>
        <source>Smallest %1 of the best design within the ranges: %2 at %3 (samples only: %4; %5 searches, %6 of them ended here).</source>
        <translation>Minsta funna värde (%1) för den bästa konstruktionen för ofullständigt känt berg inom områdena: %2 vid %3 (bara stickproven: %4; %5 sökningar, %6 av dem slutade här).</translation>
    </message>
    <message>
        <source>Largest %1 of the best design within the ranges: %2 at %3 (samples only: %4; %5 searches, %6 of them ended here).</source>
        <translation>Största funna värde (%1) för den bästa konstruktionen för ofullständigt känt berg inom områdena: %2 vid %3 (bara stickproven: %4; %5 sökningar, %6 av dem slutade här).</translation>
    </message>
    <message>
        <source>%1 sample could not be solved and is left out of the statistics. Reason: %2.</source>
        <translation>%1 stickprov kunde inte lösas och saknas i statistiken. Orsak: %2.</translation>
    </message>
    <message>
        <source>%1 samples could not be solved and are left out of the statistics. Reason: %2.</source>
        <translation>%1 stickprov kunde inte lösas och saknas i statistiken. Orsak: %2.</translation>
    </message>
    <message>
        <source>%1 design has no statistics, because more than 0.1 % of its samples could not be solved.</source>
        <translation>%1 konstruktion saknar statistik, eftersom mer än 0,1&#xa0;% av dess stickprov inte kunde lösas.</translation>
    </message>
    <message>
        <source>%1 designs have no statistics, because more than 0.1 % of their samples could not be solved.</source>
        <translation>%1 konstruktioner saknar statistik, eftersom mer än 0,1&#xa0;% av deras stickprov inte kunde lösas.</translation>
    </message>
    <message>
        <source>In up to %1 % of the samples of a design, the bit chatters on the rock. The numerical error of these blows is larger than the error of the statistics.</source>
        <translation>I upp till %1&#xa0;% av stickproven i en konstruktion skallrar borrkronan mot berget. Det numeriska felet i dessa slag är större än statistikens fel.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 eller %2</translation>
    </message>
    <message>
        <source>%1 or %2 others</source>
        <translation>%1 eller %2 andra</translation>
    </message>
    <message>
        <source>These designs are equally good within the error: %1. Use any of them.</source>
        <translation>Dessa konstruktioner är lika bra inom felet: %1. Använd vilken som helst av dem.</translation>
    </message>
    <message>
        <source>These designs are equally good within the error: %1. Use any of them. Among them, the design %2 has the largest value of %3, %4.</source>
        <translation>Dessa konstruktioner är lika bra inom felet: %1. Använd vilken som helst av dem. Bland dem har konstruktionen %2 det största värdet på %3, %4.</translation>
    </message>
    <message>
        <source>These designs are equally good within the error: %1. Use any of them. Among them, the design %2 has the smallest value of %3, %4.</source>
        <translation>Dessa konstruktioner är lika bra inom felet: %1. Använd vilken som helst av dem. Bland dem har konstruktionen %2 det minsta värdet på %3, %4.</translation>
    </message>
    <message>
        <source>The best design for uncertain rock lies at the upper end of the range of %1: extend that range.</source>
        <translation>Den bästa konstruktionen för ofullständigt känt berg ligger i övre änden av området för %1: vidga det området.</translation>
    </message>
    <message>
        <source>The best design for uncertain rock lies at the lower end of the range of %1: extend that range.</source>
        <translation>Den bästa konstruktionen för ofullständigt känt berg ligger i nedre änden av området för %1: vidga det området.</translation>
    </message>
    <message>
        <source>The blow energy differs by up to %1 % between the designs: machines of different power are compared. Use --keep-energy to compare at the same energy.</source>
        <translation>Slagenergin skiljer sig med upp till %1&#xa0;% mellan konstruktionerna: maskiner med olika effekt jämförs. Använd --keep-energy för att jämföra vid samma energi.</translation>
    </message>
    <message>
        <source>Nearly all scatter of the efficiency comes from the elasticity gamma of the rock. To compare hammers, choose the loading work as the objective: --aim max:loading_work@q05.</source>
        <translation>Verkningsgraden sprider nästan bara med bergets elasticitet gamma. Välj belastningsarbetet som målstorhet för att jämföra hammare: --aim max:loading_work@q05.</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>vila</translation>
    </message>
    <message>
        <source>bouncing</source>
        <translation>studsande</translation>
    </message>
    <message>
        <source>period %1</source>
        <translation>period %1</translation>
    </message>
    <message>
        <source>irregular</source>
        <translation>oregelbunden</translation>
    </message>
    <message>
        <source>start</source>
        <translation>start</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>spalt</translation>
    </message>
    <message>
        <source>penetration</source>
        <translation>inträngning</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>kontakt</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>rörelse</translation>
    </message>
    <message>
        <source>%1 blows at each value</source>
        <translation>%1 slag vid varje värde</translation>
    </message>
    <message>
        <source>with %1, %2 blows at each value</source>
        <translation>med %1, %2 slag vid varje värde</translation>
    </message>
    <message>
        <source>contact share</source>
        <translation>kontaktandel</translation>
    </message>
    <message>
        <source>balances</source>
        <translation>balanser</translation>
    </message>
    <message>
        <source>%1 blows</source>
        <translation>%1 slag</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>standardavvikelse</translation>
    </message>
    <message>
        <source>rock impulse</source>
        <translation>impuls på berget</translation>
    </message>
    <message>
        <source>up to %1: an upper limit (all rock under the bit breaks, cuttings are removed)</source>
        <translation>upp till %1: en övre gräns, allt berg under borrkronan ger efter och borrkaxet försvinner</translation>
    </message>
    <message>
        <source>%1 of the blows start within %2 of the rock</source>
        <translation>%1 av slagen börjar inom %2 från berget</translation>
    </message>
    <message>
        <source>rock %1, damper %2, waves %3, new rock faces %4 of the energy from hammer and feed</source>
        <translation>berg %1, dämpare %2, vågor %3, nya bergytor %4 av det som hammare och matning tillför</translation>
    </message>
    <message>
        <source>momentum to %1, energy to %2</source>
        <translation>rörelsemängd på %1 när, energi på %2 när</translation>
    </message>
    <message>
        <source>phi = %1 (feed force over mean force of the blows), n_b = %2 round trips per blow</source>
        <translation>φ = %1 (matningskraft genom medelreaktion), %2 varv fram och åter per slag</translation>
    </message>
    <message>
        <source>The gap has a period of d0 = %1.</source>
        <translation>Spalten har perioden d₀ = %1.</translation>
    </message>
    <message>
        <source>The gap has a period of d0.</source>
        <translation>Spalten har perioden d₀.</translation>
    </message>
    <message>
        <source>%1 in %2.</source>
        <translation>%1 på %2.</translation>
    </message>
    <message>
        <source>rises through it</source>
        <translation>stiger genom det</translation>
    </message>
    <message>
        <source>falls through it</source>
        <translation>faller genom det</translation>
    </message>
    <message>
        <source>turns round at it</source>
        <translation>vänder vid det</translation>
    </message>
    <message>
        <source>is there at an end</source>
        <translation>når det vid en ände</translation>
    </message>
    <message>
        <source>is it everywhere</source>
        <translation>är det överallt</translation>
    </message>
    <message>
        <source>jumps over it</source>
        <translation>hoppar över det</translation>
    </message>
    <message>
        <source>between points, from %1 to %2</source>
        <translation>mellan punkter, från %1 till %2</translation>
    </message>
    <message>
        <source>where the output is known only at single points</source>
        <translation>där resultatet är känt bara i enstaka punkter</translation>
    </message>
    <message>
        <source>where it has no answer</source>
        <translation>där det saknar svar</translation>
    </message>
    <message>
        <source>where the output is known only at single points or has no value</source>
        <translation>där resultatet är känt bara i enstaka punkter eller saknar värde</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 från %2 till %3</translation>
    </message>
    <message>
        <source>no %1 gives %2</source>
        <translation>inget värde på %1 ger %2</translation>
    </message>
    <message>
        <source>no %1 gives %2, which it jumps over at %3</source>
        <translation>inget värde på %1 ger %2, som hoppas över vid %3</translation>
    </message>
    <message>
        <source>%1: there is no answer anywhere</source>
        <translation>%1: det finns inget svar någonstans</translation>
    </message>
    <message>
        <source>%1: the nearest is %2, at %3</source>
        <translation>%1: närmast kommer %2, vid %3</translation>
    </message>
    <message>
        <source>%1: the nearest is %2, at %3; there may be one %4</source>
        <translation>%1: närmast kommer %2, vid %3; det kan finnas ett sådant %4</translation>
    </message>
    <message>
        <source>Goal: %1</source>
        <translation>Mål: %1</translation>
    </message>
    <message>
        <source>None: %1.</source>
        <translation>Nås inte: %1.</translation>
    </message>
    <message>
        <source>There may be others %1.</source>
        <translation>Det kan finnas fler %1.</translation>
    </message>
    <message>
        <source>There are no others from %1 to %2.</source>
        <translation>Det finns inga fler från %1 till %2.</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 punkter</translation>
    </message>
    <message>
        <source>nowhere between the points</source>
        <translation>ingenstans mellan punkterna</translation>
    </message>
    <message>
        <source>%1 on %2, within %3</source>
        <translation>%1 på %2, inom %3</translation>
    </message>
    <message>
        <source>%1 line</source>
        <translation>%1 kurva</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 kurvor</translation>
    </message>
    <message>
        <source>%1, except %2 where it jumps across</source>
        <translation>%1, utom %2 där resultatet gör ett språng</translation>
    </message>
    <message>
        <source>%1; %2 where the blows do not repeat: a mean scatters there, and the contour with it</source>
        <translation>%1; %2 där slagen inte upprepas: ett medelvärde har spridning där, och nivåkurvan med det</translation>
    </message>
    <message>
        <source>%1; %2 crossing not placed: %3</source>
        <translation>%1; %2 korsning utan bestämt läge: %3</translation>
    </message>
    <message>
        <source>%1; %2 crossings not placed: %3</source>
        <translation>%1; %2 korsningar utan bestämt läge: %3</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 värde</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 värden</translation>
    </message>
    <message>
        <source>%1 = %2 to %3, %4, log</source>
        <translation>%1 = %2 till %3, %4, log</translation>
    </message>
    <message>
        <source>%1 = %2 to %3, %4</source>
        <translation>%1 = %2 till %3, %4</translation>
    </message>
    <message>
        <source>%1 over %2; %3</source>
        <translation>%1 över %2; %3</translation>
    </message>
    <message>
        <source>%1 not solved: %2</source>
        <translation>%1 utan lösning: %2</translation>
    </message>
    <message>
        <source>%1 blow in %2.</source>
        <translation>%1 slag på %2.</translation>
    </message>
    <message>
        <source>%1 blows in %2.</source>
        <translation>%1 slag på %2.</translation>
    </message>
    <message>
        <source>slope %1 k from %2</source>
        <translation>lutning %1 k från %2</translation>
    </message>
    <message>
        <source>%1 k from %2</source>
        <translation>%1 k från %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>och %1 till</translation>
    </message>
    <message>
        <source>rock: %1,</source>
        <translation>berg: %1,</translation>
    </message>
    <message>
        <source>was solved by method %1 (%2)</source>
        <translation>löstes med metod %1 (%2)</translation>
    </message>
    <message>
        <source>was solved by a lattice of `%1` (%2)</source>
        <translation>löstes med ett gitter på `%1` (%2)</translation>
    </message>
    <message>
        <source>kind of case</source>
        <translation>typ av fall</translation>
    </message>
    <message>
        <source>cases</source>
        <translation>fall</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>godkända</translation>
    </message>
    <message>
        <source>worst balance</source>
        <translation>sämsta balans</translation>
    </message>
    <message>
        <source>continuity</source>
        <translation>kontinuitet</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>bitar</translation>
    </message>
    <message>
        <source>momentum residual</source>
        <translation>fel i rörelsemängdens balans</translation>
    </message>
    <message>
        <source>energy residual</source>
        <translation>fel i energibalansen</translation>
    </message>
    <message>
        <source>tension on the rock</source>
        <translation>drag från berget</translation>
    </message>
    <message>
        <source>return after the computed end</source>
        <translation>återkomst efter slutet</translation>
    </message>
    <message>
        <source>change over 1e-10</source>
        <translation>ändring vid 1e-10</translation>
    </message>
    <message>
        <source>distance from limit</source>
        <translation>avstånd från gränsfallet</translation>
    </message>
    <message>
        <source>distance from lattice</source>
        <translation>avstånd från gittret</translation>
    </message>
    <message>
        <source>distance from long double</source>
        <translation>avstånd från long double</translation>
    </message>
    <message>
        <source>stated error</source>
        <translation>angivet fel</translation>
    </message>
    <message>
        <source>wave pieces</source>
        <translation>vågbitar</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>sekunder</translation>
    </message>
    <message>
        <source>column</source>
        <translation>kolumn</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>sämst</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>gräns</translation>
    </message>
    <message>
        <source>FAILED %1: %2</source>
        <translation>UNDERKÄNT %1: %2</translation>
    </message>
    <message>
        <source>%1 cases: %2 passed, %3 failed, %4 not solved</source>
        <translation>%1 fall: %2 godkända, %3 underkända, %4 inte lösta</translation>
    </message>
    <message>
        <source>%1 of %2, n_b = %3</source>
        <translation>%1 med %2, %3 varv fram och åter till nästa slag</translation>
    </message>
    <message>
        <source>%1 takes a study of all gaps at every point; `drillwave thrust --along` has it</source>
        <translation>%1 kräver en studie av alla spalter i varje punkt; `drillwave thrust --along` ger det</translation>
    </message>
    <message>
        <source>a family has at most %1 lines, this one %2</source>
        <translation>en skara har högst %1 kurvor, denna har %2</translation>
    </message>
    <message>
        <source>the range of %1 must end above its beginning</source>
        <translation>området för %1 måste sluta på ett högre värde än det börjar</translation>
    </message>
    <message>
        <source>a dimensionless scenario has no energy to keep; leave it out</source>
        <translation>ett scenario givet av sina dimensionslösa tal har ingen energi att behålla; utelämna det</translation>
    </message>
    <message>
        <source>a blow of given points has neither impulse nor velocity to scale; leave it out</source>
        <translation>ett slag av givna punkter har varken impuls eller hastighet att skala; utelämna det</translation>
    </message>
    <message>
        <source>nothing is uncertain; give --uncertain KEY=LOW:HIGH or --draws FILE.csv</source>
        <translation>inget är osäkert; ange --uncertain KEY=LOW:HIGH eller --draws FILE.csv</translation>
    </message>
    <message>
        <source>at most %1 uncertain parameters, these are %2</source>
        <translation>högst %1 osäkra parametrar, här är det %2</translation>
    </message>
    <message>
        <source>at most %1 choices, these are %2</source>
        <translation>högst %1 val, här är det %2</translation>
    </message>
    <message>
        <source>at most %1 aims, these are %2</source>
        <translation>högst %1 mål, här är det %2</translation>
    </message>
    <message>
        <source>at most %1 designs, and the choices make too many to count; give fewer values</source>
        <translation>högst %1 konstruktioner, valen ger fler än som går att räkna; ange färre värden</translation>
    </message>
    <message>
        <source>at most %1 designs, the choices make %2; give fewer values</source>
        <translation>högst %1 konstruktioner, valen ger %2; ange färre värden</translation>
    </message>
    <message>
        <source>at most %1 blows, %2 designs at %3 samples are more; take fewer</source>
        <translation>högst %1 slag, %2 konstruktioner med %3 stickprov var är fler; ta färre</translation>
    </message>
    <message>
        <source>%1 and %2 %3; leave out one of them</source>
        <translation>%1 och %2 %3; utelämna en av dem</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 är angivet två gånger; ange det en gång</translation>
    </message>
    <message>
        <source>%1 is both design variable and uncertain: only +-P% about its value can be both</source>
        <translation>%1 är både vald och osäker: bara +-P% kring valet är möjligt</translation>
    </message>
    <message>
        <source>keeping the energy sets %1, and so does the choice of %2; leave out that choice, or do not keep the energy (--no-keep-energy)</source>
        <translation>att behålla energin sätter %1, och det gör valet av %2 också; utelämna valet eller behåll inte energin (--no-keep-energy)</translation>
    </message>
    <message>
        <source>thrust_margin needs a study of all gaps; aim at thrust instead</source>
        <translation>thrust_margin är i sig en studie av alla spalter; ta thrust som mål</translation>
    </message>
    <message>
        <source>%1 needs many blows for each value; use `drillwave drill` or a sweep</source>
        <translation>%1 kräver en egen beräkning av många slag; `drillwave drill` och sweep har det</translation>
    </message>
    <message>
        <source>at %1: %2</source>
        <translation>vid %1: %2</translation>
    </message>
    <message>
        <source>column %1 %2</source>
        <translation>kolumn %1 %2</translation>
    </message>
    <message>
        <source>column `%1` is not a number that can be uncertain; leave it out</source>
        <translation>kolumn `%1` är inget tal som kan vara osäkert; utelämna den ur dragningarna</translation>
    </message>
    <message>
        <source>column `%1` is not a parameter; leave it out</source>
        <translation>kolumn `%1` är ingen parameter; utelämna den ur dragningarna</translation>
    </message>
    <message>
        <source>the cell of %1 is missing; every draw needs a value of every key</source>
        <translation>cellen för %1 saknas; varje dragning behöver ett värde för varje nyckel</translation>
    </message>
    <message>
        <source>has no header; write the keys into the first row</source>
        <translation>saknar huvud; skriv nycklarna i första raden</translation>
    </message>
    <message>
        <source>has more than %1 rows; leave some out</source>
        <translation>har fler än %1 rader; utelämna några</translation>
    </message>
    <message>
        <source>has no rows of draws</source>
        <translation>har inga rader med dragningar</translation>
    </message>
    <message>
        <source>has no width; give LOW below HIGH</source>
        <translation>har ingen bredd; ange LOW mindre än HIGH</translation>
    </message>
    <message>
        <source>has LOW above HIGH; exchange them</source>
        <translation>är omvänt; ange LOW mindre än HIGH</translation>
    </message>
    <message>
        <source>must begin above 0 where it is `log`</source>
        <translation>måste börja över 0 med `log`</translation>
    </message>
    <message>
        <source>must begin above 0 where it is `lognormal`</source>
        <translation>måste börja över 0 med `lognormal`</translation>
    </message>
    <message>
        <source>the distribution extends to %1, outside the allowed range; use lognormal</source>
        <translation>når %1, där det inte finns något svar; använd lognormal</translation>
    </message>
    <message>
        <source>needs a number above 0 of per cent, as +-5%</source>
        <translation>behöver ett procenttal över 0, t.ex. +-5%</translation>
    </message>
    <message>
        <source>%1 needs LOW:HIGH, LOW:HIGH:log, :normal or :lognormal, or +-P%</source>
        <translation>%1 behöver LOW:HIGH, LOW:HIGH:log, :normal eller :lognormal, eller +-P%</translation>
    </message>
    <message>
        <source>unknown suffix `%1` after the range of %2; choose from uniform, log, normal, lognormal</source>
        <translation>`%1` efter området för %2 är inte känt; välj bland uniform, log, normal, lognormal</translation>
    </message>
    <message>
        <source>`%1` is not a range: write KEY=LOW:HIGH, KEY=LOW:HIGH:log or KEY=+-P%</source>
        <translation>`%1` är inget område: skriv KEY=LOW:HIGH, KEY=LOW:HIGH:log eller KEY=+-P%</translation>
    </message>
    <message>
        <source>%1 is not a number and cannot be uncertain; list values with --choose</source>
        <translation>%1 är inget tal och kan inte vara osäkert; välj bland flera med --choose</translation>
    </message>
    <message>
        <source>%1 takes only whole numbers and cannot be uncertain; list values with --choose</source>
        <translation>%1 tar bara heltal och kan inte vara osäkert; välj bland flera med --choose</translation>
    </message>
    <message>
        <source>%1 does not apply here: %2</source>
        <translation>%1 har ingen betydelse här: %2</translation>
    </message>
    <message>
        <source>%1 = +-%2% (the scenario has 0 there; give LOW:HIGH)</source>
        <translation>%1 = +-%2% (scenariot har 0 där; ange LOW:HIGH)</translation>
    </message>
    <message>
        <source>%1 = +-%2% (the scenario has no value there; give LOW:HIGH)</source>
        <translation>%1 = +-%2% (scenariot har inget värde där; ange LOW:HIGH)</translation>
    </message>
    <message>
        <source>%1 = +-%2% of %3 (%4)</source>
        <translation>%1 = +-%2% av %3 (%4)</translation>
    </message>
    <message>
        <source>the machine is pushed back without limit</source>
        <translation>maskinen trycks tillbaka: ingen begränsad rörelse</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>beräkningen stoppades</translation>
    </message>
    <message>
        <source>the axis %1 of a map needs START:STOP:COUNT or START:STOP:COUNT:log</source>
        <translation>axeln %1 i en karta behöver START:STOP:COUNT eller START:STOP:COUNT:log</translation>
    </message>
    <message>
        <source>the map has more than %1 points; take fewer, or use `drillwave sweep`, which has no limit</source>
        <translation>kartan har fler än %1 punkter; ta färre, eller `drillwave sweep`, som inte håller några i minnet</translation>
    </message>
    <message>
        <source>momentum residual %1</source>
        <translation>fel i rörelsemängdens balans %1</translation>
    </message>
    <message>
        <source>energy residual %1</source>
        <translation>fel i energibalansen %1</translation>
    </message>
    <message>
        <source>tension on the rock: F/Fmax %1</source>
        <translation>berget drar: F/Fmax %1</translation>
    </message>
    <message>
        <source>not at its end: the bit returns by %1</source>
        <translation>inte vid sitt slut: framänden återvänder med %1</translation>
    </message>
    <message>
        <source>not continuous: e changes by %1</source>
        <translation>inte kontinuerligt: e ändras med %1</translation>
    </message>
    <message>
        <source>far from its limit by a factor %1</source>
        <translation>för långt från gränsvärdet: faktor %1</translation>
    </message>
    <message>
        <source>the lattice differs, in units of its error estimate: %1</source>
        <translation>gittret avviker med %1 gånger de uppskattade felen</translation>
    </message>
    <message>
        <source>the error bound is exceeded by a factor of %1</source>
        <translation>det angivna felet överskrids med en faktor %1</translation>
    </message>
    <message>
        <source>%1 and %2 %3; vary one of them</source>
        <translation>%1 och %2 %3; variera en av dem</translation>
    </message>
    <message>
        <source>`all` are all outputs already; give nothing else</source>
        <translation>`all` är redan alla resultat; ange det ensamt</translation>
    </message>
    <message>
        <source>`%1` is not an output; did you mean `%2`?</source>
        <translation>`%1` är inget resultat; menade du `%2`?</translation>
    </message>
    <message>
        <source>`%1` is not an output; choose from %2</source>
        <translation>`%1` är inget resultat; välj bland %2</translation>
    </message>
    <message>
        <source>`%1` is given twice; give it once</source>
        <translation>`%1` är angivet två gånger; ange det en gång</translation>
    </message>
    <message>
        <source>SI columns need a scenario in physical units; this one is given by its dimensionless groups</source>
        <translation>SI-kolumner förutsätter ett scenario i fysikaliska enheter; detta är givet av sina dimensionslösa tal</translation>
    </message>
    <message>
        <source>the count `%1` of %2 must be a whole number from 1 to %3</source>
        <translation>antalet `%1` för %2 måste vara ett heltal från 1 till %3</translation>
    </message>
    <message>
        <source>unknown suffix `%1` after the range of %2; only `log` is allowed</source>
        <translation>`%1` efter slutet för %2 är inte känt; bara `log` får följa</translation>
    </message>
    <message>
        <source>unknown suffix `%1` after the count of %2; only `log` is allowed</source>
        <translation>`%1` efter antalet för %2 är inte känt; bara `log` får följa</translation>
    </message>
    <message>
        <source>a logarithmic axis of %1 must begin and end above 0</source>
        <translation>en logaritmisk axel för %1 måste börja och sluta över 0</translation>
    </message>
    <message>
        <source>%1 takes only whole numbers; give a COUNT that hits them, or a list A,B,C</source>
        <translation>%1 tar bara heltal; ange ett COUNT som träffar dem, eller en lista A,B,C</translation>
    </message>
    <message>
        <source>%1 needs START:STOP:COUNT, START:STOP:COUNT:log or a list A,B,C</source>
        <translation>%1 behöver START:STOP:COUNT, START:STOP:COUNT:log eller en lista A,B,C</translation>
    </message>
    <message>
        <source>%1 needs START:STOP or START:STOP:log</source>
        <translation>%1 behöver START:STOP eller START:STOP:log</translation>
    </message>
    <message>
        <source>%1 has no numeric values; use a family of shapes</source>
        <translation>%1 har inga tal att följa; gör en skara av former</translation>
    </message>
    <message>
        <source>%1 has no numeric values; use a family of words</source>
        <translation>%1 har inga tal att följa; gör en skara av ord</translation>
    </message>
    <message>
        <source>`%1` is not an axis: write KEY=START:STOP:COUNT, KEY=START:STOP:COUNT:log or KEY=A,B,C</source>
        <translation>`%1` är ingen axel: skriv KEY=START:STOP:COUNT, KEY=START:STOP:COUNT:log eller KEY=A,B,C</translation>
    </message>
    <message>
        <source>`%1` is not an axis: write KEY=START:STOP or KEY=START:STOP:log</source>
        <translation>`%1` är ingen axel: skriv KEY=START:STOP eller KEY=START:STOP:log</translation>
    </message>
    <message>
        <source>%1 has only whole numbers; make a family of them, or sweep it</source>
        <translation>%1 har bara heltal; gör en skara av dem, eller använd sweep</translation>
    </message>
    <message>
        <source>the range of %1 is too narrow: it must be at least 1e-4 of its end</source>
        <translation>området för %1 är för smalt: det måste vara minst 1e-4 av sitt slutvärde</translation>
    </message>
    <message>
        <source>the axis %1</source>
        <translation>axeln %1</translation>
    </message>
    <message>
        <source>a sweep has at most %1 axes, this one %2</source>
        <translation>sweep har högst %1 axlar, här är det %2</translation>
    </message>
    <message>
        <source>the axes %1 and %2 %3; vary one of them</source>
        <translation>axlarna %1 och %2 %3; variera en av dem</translation>
    </message>
    <message>
        <source>the grid has more than %1 points; take fewer values</source>
        <translation>rutnätet har fler än %1 punkter; ta färre värden</translation>
    </message>
    <message>
        <source>pictures show one axis or two, not %1; vary fewer, or leave out --plots</source>
        <translation>bilder visar en axel eller två, inte %1; variera färre eller utelämna --plots</translation>
    </message>
    <message>
        <source>no axis has two or more numeric values to draw a curve along</source>
        <translation>ingen axel har två tal eller fler att rita en kurva längs</translation>
    </message>
    <message>
        <source>pictures need all rows; leave out --shard</source>
        <translation>en enskild del av raderna kan inte ritas; utelämna --shard</translation>
    </message>
    <message>
        <source>at most %1 rows can be drawn, not %2; take fewer</source>
        <translation>högst %1 rader kan ritas, inte %2; ta färre</translation>
    </message>
    <message>
        <source>at most %1 curves can be distinguished, and %2 has %3 values; take fewer, or draw a map (drillwave map)</source>
        <translation>högst %1 kurvor går att skilja åt, och %2 har %3 värden; ta färre, eller rita en karta (drillwave map)</translation>
    </message>
    <message>
        <source>at most %1 outputs can be drawn, not %2; choose with --outputs</source>
        <translation>högst %1 resultat kan ritas, inte %2; välj med --outputs</translation>
    </message>
    <message>
        <source>is empty; its first row must name parameters</source>
        <translation>är tom; första raden måste namnge parametrar</translation>
    </message>
    <message>
        <source>cells are separated by tabs, not by `,`; save the table with `,` between them and `.` in numbers</source>
        <translation>cellerna skiljs åt av tabbar, inte av `,`; spara tabellen med `,` mellan dem och `.` i talen</translation>
    </message>
    <message>
        <source>cells are separated by `;`, not by `,`; save the table with `,` between them and `.` in numbers</source>
        <translation>cellerna skiljs åt av `;`, inte av `,`; spara tabellen med `,` mellan dem och `.` i talen</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; write a known key, or another name than `%2` for a column that is only passed through</source>
        <translation>`%1` är ingen parameter; skriv en nyckel som finns, eller ett annat namn än `%2` för en kolumn som bara ska föras över</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; did you mean `%2`? A column that is only passed through needs another name than `%3`</source>
        <translation>`%1` är ingen parameter; menade du `%2`, eller ett annat namn än `%3` för en kolumn som bara ska föras över?</translation>
    </message>
    <message>
        <source>has %1; save the table as CSV in UTF-8</source>
        <translation>innehåller %1; spara tabellen som CSV i UTF-8</translation>
    </message>
    <message>
        <source>`%1` is no number; give it with --set for all rows</source>
        <translation>`%1` är inget tal; ange värdet med --set för alla rader</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; write `%2`, with its unit in square brackets, or another name for a column that is only passed through</source>
        <translation>`%1` är ingen parameter; skriv `%2`, med enhet inom hakparentes, eller ett annat namn för en kolumn som bara ska föras över</translation>
    </message>
    <message>
        <source>`%1` is not a parameter; write `%2`, or another name for a column that is only passed through</source>
        <translation>`%1` är ingen parameter; skriv `%2`, eller ett annat namn för en kolumn som bara ska föras över</translation>
    </message>
    <message>
        <source>`%1` is not a parameter and only passed through</source>
        <translation>`%1` är ingen parameter och förs bara över</translation>
    </message>
    <message>
        <source>`%1` is not a parameter and only passed through; did you mean `%2`?</source>
        <translation>`%1` är ingen parameter och förs bara över; menade du `%2`?</translation>
    </message>
    <message>
        <source>%1 has no unit; write it without `[%2]`</source>
        <translation>%1 har ingen enhet; skriv utan `[%2]`</translation>
    </message>
    <message>
        <source>%1: unit `%2` is not known here; allowed units: %3</source>
        <translation>%1: enheten `%2` är okänd här; möjliga enheter: %3</translation>
    </message>
    <message>
        <source>sets %1, which column %2 also sets; keep one of them</source>
        <translation>sätter %1 igen, kolumn %2 gör det redan; behåll en av dem</translation>
    </message>
    <message>
        <source>`%1` is passed through unchanged; the computed column with the same name follows</source>
        <translation>`%1` förs över som den är; den beräknade kolumnen följer med samma namn</translation>
    </message>
    <message>
        <source>no column is a parameter, so every row would be the same blow; name parameters in the first row, such as `beta` or `rod.length [m]`</source>
        <translation>ingen kolumn namnger en parameter, så att varje rad vore samma slag; namnge några i första raden, t.ex. `beta` eller `rod.length [m]`</translation>
    </message>
    <message>
        <source>has %1; save the table in UTF-8</source>
        <translation>innehåller %1; spara tabellen i UTF-8</translation>
    </message>
    <message>
        <source>is in %1, the column in %2: write it in that, or the header without a unit</source>
        <translation>är i %1, kolumnen i %2: skriv värdet i kolumnens enhet, eller huvudet utan enhet</translation>
    </message>
    <message>
        <source>has %1 cells, the header has %2</source>
        <translation>antalet celler är %1, i huvudet %2</translation>
    </message>
    <message>
        <source>%1 and %2 %3; leave one of the two cells empty</source>
        <translation>%1 och %2 %3; lämna en av de två cellerna tom</translation>
    </message>
    <message>
        <source>text follows a closing quote</source>
        <translation>text följer efter ett avslutande citattecken</translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation>ett citattecken är inte stängt</translation>
    </message>
    <message>
        <source>the record is too long</source>
        <translation>posten är för lång</translation>
    </message>
    <message>
        <source>the record has too many cells</source>
        <translation>posten har för många celler</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>måste vara ett heltal från %1 till %2</translation>
    </message>
    <message>
        <source>must be UTF-8</source>
        <translation>måste vara UTF-8</translation>
    </message>
    <message>
        <source>must be one line</source>
        <translation>måste vara en enda rad</translation>
    </message>
    <message>
        <source>must have no control characters</source>
        <translation>får inte ha några styrtecken</translation>
    </message>
    <message>
        <source>must have no characters that change the reading direction</source>
        <translation>får inte ha tecken som vänder läsriktningen</translation>
    </message>
    <message>
        <source>must have a letter</source>
        <translation>måste ha en bokstav</translation>
    </message>
    <message>
        <source>a loading curve of more than one line</source>
        <translation>en belastningskurva med fler än en linje</translation>
    </message>
    <message>
        <source>the closed form is for a rectangular pulse, gamma = 1, a whole number as delta and tau &gt;= 0.5, not %1; use the exact method or the lattice</source>
        <translation>den slutna formen gäller för rektangulärt slag, gamma = 1, heltal som delta och tau &gt;= 0,5, inte för %1; använd den exakta metoden eller gittret</translation>
    </message>
    <message>
        <source>the file of presets %1</source>
        <translation>filen med förval %1</translation>
    </message>
    <message>
        <source>--segments %1: needs at most %2 whole numbers from %3 to %4, as in 100,1000,10000</source>
        <translation>--segments %1: behöver högst %2 heltal från %3 till %4, som i 100,1000,10000</translation>
    </message>
    <message>
        <source>--segments %1: would move waves by %2 segments, more than --work-limit, now %3, permits (half a minute is some 1e9); take fewer or permit more</source>
        <translation>--segments %1: skulle flytta vågor %2 segment, mer än vad --work-limit, nu %3, tillåter (en halv minut är omkring 1e9); ta färre eller tillåt fler</translation>
    </message>
    <message>
        <source>unknown option `%1`; did you mean `%2`?</source>
        <translation>okänd flagga `%1`; menade du `%2`?</translation>
    </message>
    <message>
        <source>unknown option `%1`; --help lists the options</source>
        <translation>okänd flagga `%1`; --help listar flaggorna</translation>
    </message>
    <message>
        <source>`%1` needs a value: %2</source>
        <translation>`%1` behöver ett värde: %2</translation>
    </message>
    <message>
        <source>%1; `%2` after it is an option; write ./%2 for a file of that name</source>
        <translation>%1; `%2` efter den är en flagga, en fil med det namnet skrivs ./%2</translation>
    </message>
    <message>
        <source>%1; `%2` after it is an option</source>
        <translation>%1; `%2` efter den är en flagga</translation>
    </message>
    <message>
        <source>`%1` takes no value</source>
        <translation>`%1` tar inget värde</translation>
    </message>
    <message>
        <source>--level: at most %1 levels</source>
        <translation>--level: högst %1 nivåer</translation>
    </message>
    <message>
        <source>-o needs a name, this one is empty; - is standard output</source>
        <translation>-o behöver ett namn, detta är tomt; - är standard ut</translation>
    </message>
    <message>
        <source>needs %1; see drillwave %2 --help</source>
        <translation>behöver %1; se drillwave %2 --help</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; the command takes none, see drillwave %2 --help</source>
        <translation>`%1` är för mycket; kommandot tar inget argument, se drillwave %2 --help</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; the command takes %2, see drillwave %3 --help</source>
        <translation>`%1` är för mycket; kommandot tar bara %2, se drillwave %3 --help</translation>
    </message>
    <message>
        <source>--goal needs one output; --outputs names %1</source>
        <translation>--goal gäller ett enda resultat; --outputs anger %1</translation>
    </message>
    <message>
        <source>--goal %1: without --si %2 is a number without a unit; add --si</source>
        <translation>--goal %1: utan --si är %2 ett tal utan enhet; lägg till --si</translation>
    </message>
    <message>
        <source>needs --along KEY=START:STOP or KEY=START:STOP:log</source>
        <translation>behöver --along KEY=START:STOP eller KEY=START:STOP:log</translation>
    </message>
    <message>
        <source>--goal cannot be used with -o -, which prints the curve; leave out -o, or give -o FILE.csv</source>
        <translation>--goal har ingen plats när -o - skriver ut kurvan; utelämna -o, eller ange -o FILE.csv</translation>
    </message>
    <message>
        <source>%1: could not be solved everywhere: from %2 = %3 to %4: %5</source>
        <translation>%1: kunde inte lösas överallt: från %2 = %3 till %4: %5</translation>
    </message>
    <message>
        <source>--force applies to the file of -o; add -o FILE.csv</source>
        <translation>--force gäller filen från -o; lägg till -o FILE.csv</translation>
    </message>
    <message>
        <source>--json and -o - would both print to standard output; take one</source>
        <translation>--json och -o - skulle båda skriva till standard ut; välj en av dem</translation>
    </message>
    <message>
        <source>takes one FILE; remove `%1`</source>
        <translation>tar bara en FILE; `%1` är en andra</translation>
    </message>
    <message>
        <source>needs FILE</source>
        <translation>behöver FILE</translation>
    </message>
    <message>
        <source>blows</source>
        <translation>slag</translation>
    </message>
    <message>
        <source>%1: too many samples could not be solved, so designs have no statistics: %2 of %3; the first: %4</source>
        <translation>%1: för många stickprov saknar svar, så att konstruktioner inte har någon statistik: %2 av %3; det första: %4</translation>
    </message>
    <message>
        <source>no design meets all limits; loosen one or widen the choices</source>
        <translation>ingen konstruktion uppfyller alla gränser; lätta på någon eller vidga valen</translation>
    </message>
    <message>
        <source>the scenario could not be solved with the values entered</source>
        <translation>scenariot som det är kunde inte lösas</translation>
    </message>
    <message>
        <source>--force applies to the files of -o; add -o DIR</source>
        <translation>--force gäller filerna från -o; lägg till -o DIR</translation>
    </message>
    <message>
        <source>files in %1</source>
        <translation>filer i %1</translation>
    </message>
    <message>
        <source>`%1` needs OUTPUT@STATISTIC, as efficiency@q05</source>
        <translation>`%1` behöver OUTPUT@STATISTIC, t.ex. efficiency@q05</translation>
    </message>
    <message>
        <source>`all` means several outputs; name one</source>
        <translation>`all` är flera resultat; ange ett</translation>
    </message>
    <message>
        <source>`%1` is not a statistic; choose from mean, q01 to q99, min, max, nominal</source>
        <translation>`%1` är ingen statistik; välj bland mean, q01 till q99, min, max, nominal</translation>
    </message>
    <message>
        <source>needs max:OUTPUT@STATISTIC or min:OUTPUT@STATISTIC</source>
        <translation>behöver max:OUTPUT@STATISTIC eller min:OUTPUT@STATISTIC</translation>
    </message>
    <message>
        <source>`%1`: write --aim before it</source>
        <translation>`%1`: skriv --aim före</translation>
    </message>
    <message>
        <source>needs OUTPUT@STATISTIC=VALUE</source>
        <translation>behöver OUTPUT@STATISTIC=VALUE</translation>
    </message>
    <message>
        <source>no display to open the window on; use `drillwave run FILE` (see --help), or `drillwave -platform offscreen`</source>
        <translation>ingen bildskärm att öppna fönstret på; använd `drillwave run FILE` (se --help) eller `drillwave -platform offscreen`</translation>
    </message>
    <message>
        <source>--gaps needs a scan; add --scan KEY=START:STOP:COUNT</source>
        <translation>--gaps gäller ett svep; lägg till --scan KEY=START:STOP:COUNT</translation>
    </message>
    <message>
        <source>--histories: these blows have more than %1 samples; take fewer blows or fewer --cells</source>
        <translation>--histories: dessa slag har fler än %1 tidpunkter; ta färre slag eller färre --cells</translation>
    </message>
    <message>
        <source>--work-limit %1: must be at least 1</source>
        <translation>--work-limit %1 måste vara ett tal som är minst 1</translation>
    </message>
    <message>
        <source>--si and --dimensionless cannot be combined</source>
        <translation>--si och --dimensionless utesluter varandra</translation>
    </message>
    <message>
        <source>--histories %1 needs a folder: add -o DIR</source>
        <translation>--histories %1 behöver en mapp: lägg till -o DIR</translation>
    </message>
    <message>
        <source>--histories %1 must be A:B, blows from 1 to %2</source>
        <translation>--histories %1 måste vara A:B, slag från 1 till %2</translation>
    </message>
    <message>
        <source>end_time applies only to single blows, not here</source>
        <translation>end_time gäller enstaka slag, inte här</translation>
    </message>
    <message>
        <source>machine_mass without a damper: the machine presses with a constant force</source>
        <translation>machine_mass utan dämpare: maskinen trycker med en konstant kraft</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows could not be solved: their cells are empty; the first: %4</source>
        <translation>%1: %2 av %3 rader kunde inte lösas: deras celler är tomma; den första: %4</translation>
    </message>
    <message>
        <source>--plots: a scan over %1 has words on its axis and no picture; scan a number</source>
        <translation>--plots: ett svep över %1 har ord på sin axel och ingen bild; svep över ett tal</translation>
    </message>
    <message>
        <source>-o and --gaps name the same file; give two</source>
        <translation>-o och --gaps anger samma fil; ange två</translation>
    </message>
    <message>
        <source>values</source>
        <translation>värden</translation>
    </message>
    <message>
        <source>`%1` is not an example; `drillwave examples` lists them</source>
        <translation>`%1` är inget exempel; `drillwave examples` listar dem</translation>
    </message>
    <message>
        <source>`%1` is not an example; did you mean `%2`?</source>
        <translation>`%1` är inget exempel; menade du `%2`?</translation>
    </message>
    <message>
        <source>Fig. %1 could not be drawn</source>
        <translation>Fig. %1 kunde inte ritas</translation>
    </message>
    <message>
        <source>%1 applies to files; add -o %2</source>
        <translation>%1 gäller filer; lägg till -o %2 för att säga vart de skrivs</translation>
    </message>
    <message>
        <source>needs -o DIR, the folder for the figures</source>
        <translation>behöver -o DIR, mappen för figurerna</translation>
    </message>
    <message>
        <source>%1 files in %2; %3 of %4 printed numbers agree, see index.html or discrepancies.csv</source>
        <translation>%1 filer i %2; %3 av %4 tryckta tal stämmer, se index.html eller discrepancies.csv</translation>
    </message>
    <message>
        <source>must be from %1 to %2, d0 being %3</source>
        <translation>måste vara från %1 till %2, där d0 är %3</translation>
    </message>
    <message>
        <source>must be from %1 to %2</source>
        <translation>måste vara från %1 till %2</translation>
    </message>
    <message>
        <source>--gap-mean needs --gap-deviation, how far gaps scatter about it</source>
        <translation>--gap-mean behöver --gap-deviation, hur mycket spalterna sprider sig kring medelvärdet</translation>
    </message>
    <message>
        <source>is a drill string, and this command solves uniform rods alone (`drillwave: 1`); `drillwave curve FILE --along bit_rock.gap=0mm:2mm` follows a string along its gap</source>
        <translation>är en borrsträng, och detta kommando löser bara likformiga stänger (`drillwave: 1`); `drillwave curve FILE --along bit_rock.gap=0mm:2mm` följer en sträng längs spalten</translation>
    </message>
    <message>
        <source>--si: %1 is given by its dimensionless groups and has no SI units</source>
        <translation>--si: %1 är givet av sina dimensionslösa tal och har inga SI-enheter</translation>
    </message>
    <message>
        <source>Usage: drillwave %1 [OPTION]…
</source>
        <translation>Användning: drillwave %1 [OPTION]…
</translation>
    </message>
    <message>
        <source>`%1` is not a section of %2</source>
        <translation>`%1` är inget avsnitt i %2</translation>
    </message>
    <message>
        <source>`%1` is not a section of %2, which has %3</source>
        <translation>`%1` är inget avsnitt i %2, som har %3</translation>
    </message>
    <message>
        <source>`%1` is not a command, chapter, parameter or output; see `drillwave help`</source>
        <translation>`%1` är varken kommando eller kapitel, parameter eller resultat; `drillwave help` säger vad som finns</translation>
    </message>
    <message>
        <source>`%1` is not a command, chapter, parameter or output; did you mean %2? See `drillwave help`</source>
        <translation>`%1` är varken kommando eller kapitel, parameter eller resultat; nära ligger %2; `drillwave help` säger vad som finns</translation>
    </message>
    <message>
        <source>reading standard input; end it with Ctrl-D</source>
        <translation>läser standard in; avsluta med Ctrl-D</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2; copy it to another disk, or get it again</source>
        <translation>%1: kan inte läsas: %2; kopiera till en annan disk, eller hämta på nytt</translation>
    </message>
    <message>
        <source>is not a regular file; save the rows to a file first</source>
        <translation>är ingen vanlig fil; skriv först raderna till en fil</translation>
    </message>
    <message>
        <source>cannot be opened for reading; check its permissions</source>
        <translation>kan inte öppnas för läsning; kontrollera behörigheterna</translation>
    </message>
    <message>
        <source>%1: cannot be stored in %2: %3; set TMPDIR to a folder with more space</source>
        <translation>%1: kan inte mellanlagras i %2: %3; sätt TMPDIR till en mapp med mer utrymme</translation>
    </message>
    <message>
        <source>%1: is longer than %2 MiB, the limit for input that is not a file; save its rows to a file first</source>
        <translation>%1: är längre än %2 MiB, det mesta som mellanlagras av det som inte är en fil; skriv först raderna till en fil</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>avbrutet</translation>
    </message>
    <message>
        <source>interrupted; no output was left behind</source>
        <translation>avbrutet; inga utdata lämnades kvar</translation>
    </message>
    <message>
        <source>its command does not exist in this version: %1</source>
        <translation>dess kommando finns inte i denna version: %1</translation>
    </message>
    <message>
        <source>is not a file of rows</source>
        <translation>är ingen fil med rader</translation>
    </message>
    <message>
        <source>the part does not exist</source>
        <translation>delen finns inte</translation>
    </message>
    <message>
        <source>%1; a part needs the record written with it</source>
        <translation>%1; en del behöver den .yaml-fil som skrevs med den</translation>
    </message>
    <message>
        <source>number of parts</source>
        <translation>antal delar</translation>
    </message>
    <message>
        <source>command</source>
        <translation>kommando</translation>
    </message>
    <message>
        <source>%1: belongs to another run than %2: its %3 differs; leave it out or run it again</source>
        <translation>%1: är en del av en annan körning än %2: skillnad i %3; utelämna den eller kör den igen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kan inte läsas</translation>
    </message>
    <message>
        <source>needs -o FILE, where to write; - is standard output</source>
        <translation>behöver -o FILE, som anger vart resultatet skrivs; - är standard ut</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>rader</translation>
    </message>
    <message>
        <source>%1 needs one of %2</source>
        <translation>%1 behöver något av %2</translation>
    </message>
    <message>
        <source>%1: `%2` is not one of %3</source>
        <translation>%1: `%2` är inte något av %3</translation>
    </message>
    <message>
        <source>standard output: cannot be written: %1</source>
        <translation>standard ut: kan inte skrivas: %1</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; see `drillwave help`</source>
        <translation>`%1` är för mycket; `drillwave help` säger vad som finns</translation>
    </message>
    <message>
        <source>out of memory: this needs more than is free, or than a limit (ulimit -v, -d) permits; raise it, use fewer threads (-j 1) or ask for less at once</source>
        <translation>minnesbrist: detta kräver mer än vad som är ledigt, eller än vad en gräns (ulimit -v, -d) tillåter; höj den, använd färre trådar (-j 1) eller begär mindre på en gång</translation>
    </message>
    <message>
        <source>internal error: %1; please report it with the command that led to it</source>
        <translation>internt fel: %1; rapportera det, med kommandot som ledde till det</translation>
    </message>
    <message>
        <source>needs --x KEY=START:STOP:COUNT[:log] and --y KEY=START:STOP:COUNT[:log]; %1 is missing</source>
        <translation>behöver --x KEY=START:STOP:COUNT[:log] och --y likaså; %1 saknas</translation>
    </message>
    <message>
        <source>--output: a map has one output; for several take `drillwave sweep`</source>
        <translation>--output: en karta har ett resultat; för flera finns `drillwave sweep`</translation>
    </message>
    <message>
        <source>%1 cannot be used with -o -, which prints the map; give -o FILE.csv</source>
        <translation>%1 har ingen plats när -o - skriver ut kartan; ange -o FILE.csv</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punkter</translation>
    </message>
    <message>
        <source>contour points</source>
        <translation>nivåkurvpunkter</translation>
    </message>
    <message>
        <source>%1 points of a contour could not be placed: %2</source>
        <translation>%1 punkter på en nivåkurva kunde inte bestämmas: %2</translation>
    </message>
    <message>
        <source>%1 of %2 points could not be solved and have no output; %3</source>
        <translation>%1 av %2 punkter kunde inte lösas och saknar resultat; %3</translation>
    </message>
    <message>
        <source>--shard: a part of a map has only rows; add -o FILE.csv</source>
        <translation>--shard: en del av en karta har bara rader; lägg till -o FILE.csv</translation>
    </message>
    <message>
        <source>%1 needs the map in one piece; leave out --shard</source>
        <translation>%1 kräver kartan i ett stycke; utelämna --shard</translation>
    </message>
    <message>
        <source>--method %1: is not known; choose from %2</source>
        <translation>--method %1: är inte känd; välj bland %2</translation>
    </message>
    <message>
        <source>--segments applies to the lattice; add --method lattice</source>
        <translation>--segments gäller gittret; lägg till --method lattice</translation>
    </message>
    <message>
        <source>%1: is for uniform rods; leave it out for a drill string</source>
        <translation>%1: gäller bara likformiga stänger; utelämnas för en borrsträng</translation>
    </message>
    <message>
        <source>nothing can be written: %1; raise the limit of open files (ulimit -n)</source>
        <translation>inget kan skrivas: %1; höj gränsen för öppna filer (ulimit -n)</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>standard ut</translation>
    </message>
    <message>
        <source>is closed; send it to a file or to /dev/null</source>
        <translation>är stängd; skicka den till en fil eller till /dev/null</translation>
    </message>
    <message>
        <source>the name is not UTF-8; choose another one</source>
        <translation>namnet har byte som inte är UTF-8; välj ett annat</translation>
    </message>
    <message>
        <source>is a folder; give the name of a file</source>
        <translation>är en mapp; ange namnet på en fil</translation>
    </message>
    <message>
        <source>exists already; use --force to overwrite it or choose another name</source>
        <translation>finns redan; skriv över med --force eller välj ett annat namn</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; free some space or choose another place with -o</source>
        <translation>%1: kan inte skrivas: %2; frigör utrymme eller välj en annan plats med -o</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another place with -o</source>
        <translation>%1: kan inte skrivas: %2; välj en annan plats med -o</translation>
    </message>
    <message>
        <source>may be %1; give the whole name</source>
        <translation>kan vara %1; ange hela namnet</translation>
    </message>
    <message>
        <source>is not known; did you mean `%1`?</source>
        <translation>är inte känt; menade du `%1`?</translation>
    </message>
    <message>
        <source>is not known; `%1` lists them</source>
        <translation>är inte känt; `%1` listar dem som finns</translation>
    </message>
    <message>
        <source>the file of presets has an empty name; without one the built-in ones are taken</source>
        <translation>filen med förval har ett tomt namn; utan fil tas de inbyggda</translation>
    </message>
    <message>
        <source>%1: the file of presets is larger than the limit of %2 KiB</source>
        <translation>%1: filen med förval är större än %2 KiB, för stor för att vara avsedd</translation>
    </message>
    <message>
        <source>%1 is a drill string: its sections are given one by one</source>
        <translation>%1 är en borrsträng, vars sektioner anges en för en</translation>
    </message>
    <message>
        <source>%1 is given by its dimensionless groups; presets need a scenario in physical units</source>
        <translation>%1 är givet av sina dimensionslösa tal; förval kräver ett scenario i fysikaliska enheter</translation>
    </message>
    <message>
        <source>--presets applies to --rod, --hammer and --rock; add one of them</source>
        <translation>--presets gäller --rod, --hammer och --rock; lägg till någon av dem</translation>
    </message>
    <message>
        <source>rods, for %1</source>
        <translation>stänger, för %1</translation>
    </message>
    <message>
        <source>hammers, for %1</source>
        <translation>hammare, för %1</translation>
    </message>
    <message>
        <source>rocks, for %1</source>
        <translation>berg, för %1</translation>
    </message>
    <message>
        <source>pistons, for drill strings (length × diameter / bore)</source>
        <translation>kolvar, för borrsträngar (längd × diameter / spolhål)</translation>
    </message>
    <message>
        <source>adapters, for drill strings (length × diameter / bore)</source>
        <translation>nackadaptrar, för borrsträngar (längd × diameter / spolhål)</translation>
    </message>
    <message>
        <source>couplings, for drill strings (length × diameter / bore)</source>
        <translation>skarvhylsor, för borrsträngar (längd × diameter / spolhål)</translation>
    </message>
    <message>
        <source>bits, for drill strings (length × diameter / bore)</source>
        <translation>borrkronor, för borrsträngar (längd × diameter / spolhål)</translation>
    </message>
    <message>
        <source>no preset has all of &quot;%1&quot;</source>
        <translation>inget förval innehåller allt i &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 klart</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 kvar</translation>
    </message>
    <message>
        <source>solving for %1; Ctrl-C ends it</source>
        <translation>löser, hittills %1; Ctrl-C avbryter</translation>
    </message>
    <message>
        <source>solving for %1</source>
        <translation>löser, hittills %1</translation>
    </message>
    <message>
        <source>needs -o DIR, -o FILE.html or -o FILE.pdf, where to write</source>
        <translation>behöver -o DIR, -o FILE.html eller -o FILE.pdf, som anger vart rapporten skrivs</translation>
    </message>
    <message>
        <source>a report is FILE.html or FILE.pdf; for a folder of that name, end it with /</source>
        <translation>en rapport är FILE.html eller FILE.pdf; för en mapp med det namnet sätts / efter</translation>
    </message>
    <message>
        <source>report in %1</source>
        <translation>rapport i %1</translation>
    </message>
    <message>
        <source>--shard %1: needs I/N, 1 &lt;= I &lt;= N &lt;= %2</source>
        <translation>--shard %1: behöver I/N, 1 &lt;= I &lt;= N &lt;= %2</translation>
    </message>
    <message>
        <source>%1; --work-limit, now %2, permits more</source>
        <translation>%1; --work-limit, nu %2, tillåter mer</translation>
    </message>
    <message>
        <source>%1 row</source>
        <translation>%1 rad</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 rader</translation>
    </message>
    <message>
        <source>%1; %2 for other reasons</source>
        <translation>%1; %2 av andra skäl</translation>
    </message>
    <message>
        <source>%1: could not be solved: %2</source>
        <translation>%1: kunde inte lösas: %2</translation>
    </message>
    <message>
        <source>Outputs:</source>
        <translation>Resultat:</translation>
    </message>
    <message>
        <source>all of these that FILE has: some need a blow frequency, thrust_margin a thrust too</source>
        <translation>alla som FILE har: några kräver slagfrekvens, thrust_margin även matningskraft</translation>
    </message>
    <message>
        <source>Results of many blows, only by name (each takes a march); FILE needs drill.blow_frequency and drill.thrust:</source>
        <translation>Över många slag, bara vid namn (en egen beräkning var); FILE behöver drill.blow_frequency, drill.thrust:</translation>
    </message>
    <message>
        <source>note: the waves of this blow are more than can be kept: no histories.csv, no record and no plots</source>
        <translation>anmärkning: detta slag har fler vågor än vad som kan behållas: ingen histories.csv och inga diagram</translation>
    </message>
    <message>
        <source>%1 and %2 %3; give one of them</source>
        <translation>%1 och %2 %3; ange en av dem</translation>
    </message>
    <message>
        <source>needs KEY=VALUE</source>
        <translation>behöver KEY=VALUE</translation>
    </message>
    <message>
        <source>holds %1</source>
        <translation>innehåller %1</translation>
    </message>
    <message>
        <source>%1: note: written by Drillwave %2, newer than this %3: results may differ</source>
        <translation>%1: anmärkning: skriven av Drillwave %2, som är nyare än denna %3: resultaten kan skilja sig</translation>
    </message>
    <message>
        <source>-o %1 is also the input (%2); choose another name for the output</source>
        <translation>-o %1 läses som indata (%2); välj ett annat namn för utdata</translation>
    </message>
    <message>
        <source>FILE - and --presets - would both read standard input; take one</source>
        <translation>FILE - och --presets - skulle båda läsa standard in; välj en av dem</translation>
    </message>
    <message>
        <source>%1 with --set: %2</source>
        <translation>%1 med --set: %2</translation>
    </message>
    <message>
        <source>%1: note: was solved by %2; this command solves exactly</source>
        <translation>%1: anmärkning: löstes med %2; detta kommando löser exakt</translation>
    </message>
    <message>
        <source>%1: warning: %2</source>
        <translation>%1: varning: %2</translation>
    </message>
    <message>
        <source>--plots %1: `%2` is not a plot format; choose from %3</source>
        <translation>--plots %1: `%2` är inget diagramformat; välj bland %3</translation>
    </message>
    <message>
        <source>--plots needs a file to store pictures beside, not %1; give -o FILE.csv</source>
        <translation>--plots: det finns ingen plats för bilder bredvid %1; ange -o FILE.csv</translation>
    </message>
    <message>
        <source>needs --vary KEY=START:STOP:COUNT[:log] or --vary KEY=A,B,C</source>
        <translation>behöver --vary KEY=START:STOP:COUNT[:log] eller --vary KEY=A,B,C</translation>
    </message>
    <message>
        <source>FILE and CASES are both standard input; give a name for one</source>
        <translation>FILE och CASES är båda standard in; ange ett namn för en av dem</translation>
    </message>
    <message>
        <source>--frequency VALUES is --along drill.blow_frequency=VALUES; give one of them</source>
        <translation>--frequency VALUES är --along drill.blow_frequency=VALUES; ange en av dem</translation>
    </message>
    <message>
        <source>pulse.shape is not a number; use sweep for it</source>
        <translation>pulse.shape är inget tal; använd sweep</translation>
    </message>
    <message>
        <source>%1: at most %2 values</source>
        <translation>%1: högst %2 värden</translation>
    </message>
    <message>
        <source>-o writes the table of --along; add --along KEY=START:STOP</source>
        <translation>-o skriver tabellen från --along; lägg till --along KEY=START:STOP</translation>
    </message>
    <message>
        <source>unknown option `%1`; see drillwave --help</source>
        <translation>okänd flagga `%1`; se drillwave --help</translation>
    </message>
    <message>
        <source>`%1` is not a command, file or example; did you mean `drillwave %2`?</source>
        <translation>`%1` är varken kommando, fil eller exempel; menade du `drillwave %2`?</translation>
    </message>
    <message>
        <source>No such file or command; see drillwave --help</source>
        <translation>finns varken som fil eller kommando; se drillwave --help</translation>
    </message>
    <message>
        <source>unexpected argument `%1`; the window opens one file</source>
        <translation>`%1` är för mycket; fönstret öppnar en fil</translation>
    </message>
    <message>
        <source>a section that loses everything carries no wave</source>
        <translation>det som förlorar allt bär ingen våg</translation>
    </message>
    <message>
        <source>no design reaches it</source>
        <translation>ingen konstruktion uppfyller det</translation>
    </message>
    <message>
        <source>the nearest is %1 of %2</source>
        <translation>närmast kommer %1 för %2</translation>
    </message>
    <message>
        <source>%1; did you mean the example %2?</source>
        <translation>%1; menade du exemplet %2?</translation>
    </message>
    <message>
        <source>%1 is beyond the range of double precision: the values are too large or too small</source>
        <translation>%1 ligger utanför området för dubbel precision: värdena är för stora eller för små</translation>
    </message>
    <message>
        <source>not smooth within the work permitted</source>
        <translation>inte jämn inom det tillåtna arbetet</translation>
    </message>
    <message>
        <source>errors do not vary smoothly</source>
        <translation>ett fel, som inte har något jämnt förlopp</translation>
    </message>
    <message>
        <source>result of many blows, not necessarily smooth: straight lines between points</source>
        <translation>av många slag, som inte behöver vara jämnt: rakt mellan punkterna</translation>
    </message>
    <message>
        <source>solved point by point</source>
        <translation>löst punkt för punkt</translation>
    </message>
    <message>
        <source>other reasons</source>
        <translation>andra skäl</translation>
    </message>
    <message>
        <source>the table has changed since it was checked: %1</source>
        <translation>tabellen har ändrats sedan den kontrollerades: %1</translation>
    </message>
    <message>
        <source>a step of the lattice is too long for the rock: (beta/gamma) tau/N = %1 must not exceed 2; it takes at least %2 segments</source>
        <translation>ett steg i gittret är för långt för berget: (beta/gamma) tau/N = %1 får inte överstiga 2; det krävs minst %2 segment</translation>
    </message>
    <message>
        <source>the lattice would need more than the permitted number of steps; use fewer than %1 segments, or the exact method</source>
        <translation>gittret skulle behöva fler steg än tillåtet; använd färre än %1 segment eller den exakta metoden</translation>
    </message>
    <message>
        <source>a contact at time %1 is shorter than a step of the lattice; use more segments or the exact method</source>
        <translation>en kontakt vid tiden %1 är kortare än ett steg i gittret; använd fler segment eller den exakta metoden</translation>
    </message>
    <message>
        <source>%1 of blows like this one</source>
        <translation>%1 vid slag som detta</translation>
    </message>
    <message>
        <source>from %1 on slope %2</source>
        <translation>från %1 lutning %2</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>form</translation>
    </message>
    <message>
        <source>loading curve</source>
        <translation>belastningskurva</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>i %1</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>större än %1</translation>
    </message>
    <message>
        <source>greater than 0, at most %1</source>
        <translation>större än 0, högst %1</translation>
    </message>
    <message>
        <source>required</source>
        <translation>krävs</translation>
    </message>
    <message>
        <source>required, or its alternative</source>
        <translation>krävs, eller det som står i dess ställe</translation>
    </message>
    <message>
        <source>required, or `%1`</source>
        <translation>krävs, eller `%1`</translation>
    </message>
    <message>
        <source>optional; default value assumed</source>
        <translation>får utelämnas: programmet antar då ett värde</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>får utelämnas</translation>
    </message>
    <message>
        <source>scenarios in physical units</source>
        <translation>scenarier i fysikaliska enheter</translation>
    </message>
    <message>
        <source>dimensionless scenarios</source>
        <translation>dimensionslösa scenarier</translation>
    </message>
    <message>
        <source>scenarios in physical units; only for many blows</source>
        <translation>scenarier i fysikaliska enheter, vid många slag: ett enstaka slag beror inte på det</translation>
    </message>
    <message>
        <source>drill strings</source>
        <translation>borrsträngar</translation>
    </message>
    <message>
        <source>drill strings struck by a hammer</source>
        <translation>borrsträngar som en hammare slår på</translation>
    </message>
    <message>
        <source>uniform rods, with units and without</source>
        <translation>likformiga stänger, med enheter och utan</translation>
    </message>
    <message>
        <source>uniform rods in physical units</source>
        <translation>likformiga stänger i fysikaliska enheter</translation>
    </message>
    <message>
        <source>uniform rods in physical units, given by their diameter</source>
        <translation>likformiga stänger i fysikaliska enheter, givna av sin diameter</translation>
    </message>
    <message>
        <source>hammer forces in physical units, except piston and table</source>
        <translation>hammarkrafter i fysikaliska enheter, utom en kolvs eller en tabells</translation>
    </message>
    <message>
        <source>hammer forces of the shape `trapezoid`</source>
        <translation>hammarkrafter av formen `trapezoid`</translation>
    </message>
    <message>
        <source>hammer forces of the shape `piston`, in physical units</source>
        <translation>hammarkrafter av formen `piston`, i fysikaliska enheter</translation>
    </message>
    <message>
        <source>hammer forces of the shape `piston`, dimensionless</source>
        <translation>hammarkrafter av formen `piston`, dimensionslösa</translation>
    </message>
    <message>
        <source>a whole number %1</source>
        <translation>ett heltal %1</translation>
    </message>
    <message>
        <source>rock with `law: %1`</source>
        <translation>berg med `law: %1`</translation>
    </message>
    <message>
        <source>%1 to %2, of `drillwave presets`</source>
        <translation>%1 till %2, ur `drillwave presets`</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>enhet</translation>
    </message>
    <message>
        <source>range</source>
        <translation>område</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>vanligt</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>förval</translation>
    </message>
    <message>
        <source>of</source>
        <translation>gäller</translation>
    </message>
    <message>
        <source>in files</source>
        <translation>i filer</translation>
    </message>
    <message>
        <source>a word</source>
        <translation>ett ord</translation>
    </message>
    <message>
        <source>one of</source>
        <translation>ett av</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stång</translation>
    </message>
    <message>
        <source>Hammer force</source>
        <translation>Hammarkraft</translation>
    </message>
    <message>
        <source>Material of a drill string</source>
        <translation>En borrsträngs material</translation>
    </message>
    <message>
        <source>Hammer of a drill string</source>
        <translation>En borrsträngs hammare</translation>
    </message>
    <message>
        <source>Bit and rock</source>
        <translation>Borrkrona och berg</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Borrning</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Dimensionslösa tal</translation>
    </message>
    <message>
        <source>Drill string</source>
        <translation>Borrsträng</translation>
    </message>
    <message>
        <source>Shape of the hammer force (files §1.1)</source>
        <translation>Hammarkraftens form (files §1.1)</translation>
    </message>
    <message>
        <source>Loading curve of bit and rock (files §1.4)</source>
        <translation>Belastningskurva för borrkrona och berg (files §1.4)</translation>
    </message>
    <message>
        <source>Whether every blow meets `fresh` rock or the `same` crater (drilling §4)</source>
        <translation>Om varje slag möter orört berg (`fresh`) eller samma krater (`same`; drilling §4)</translation>
    </message>
    <message>
        <source>many blows under a feed (drilling)</source>
        <translation>många slag under en matning (drilling)</translation>
    </message>
    <message>
        <source>every blow</source>
        <translation>alla slag</translation>
    </message>
    <message>
        <source>uniform rods</source>
        <translation>likformiga stänger</translation>
    </message>
    <message>
        <source>drill strings whose faces have a stiffness</source>
        <translation>borrsträngar vars ändytor har en styvhet</translation>
    </message>
    <message>
        <source>In the window: %1.</source>
        <translation>I fönstret: %1.</translation>
    </message>
    <message>
        <source>none: only in SI</source>
        <translation>inget: det finns bara i SI</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>ett rent tal</translation>
    </message>
    <message>
        <source>multiple of</source>
        <translation>multipel av</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametrar</translation>
    </message>
    <message>
        <source>All parameters of a scenario: in files, after `--set`, as axis of a study, as a field of the window. The program writes this chapter from its own table. A value outside its range is refused; outside the usual range it gives a warning. Presets are starting points with a source. Format of files: files §1.</source>
        <translation>Alla tal i ett scenario: i filer, efter `--set`, som axel i en studie, som fält i fönstret. Programmet skriver detta kapitel ur den tabell som det arbetar med. Utanför sitt område avvisas ett värde, utanför det vanliga påpekas det; vad förval ger är en utgångspunkt, med sin källa. Hur filer skrivs: files §1.</translation>
    </message>
    <message>
        <source>Corners of the loading curve</source>
        <translation>Belastningskurvans hörn</translation>
    </message>
    <message>
        <source>Up to 64, by number.</source>
        <translation>Upp till 64 av dem, numrerade efter sin plats.</translation>
    </message>
    <message>
        <source>Sections of a drill string</source>
        <translation>En borrsträngs sektioner</translation>
    </message>
    <message>
        <source>NAME is the name of sections, or the number of one, from 1; for the hammer, `hammer.1.length` (files §1.3).</source>
        <translation>NAME är namnet på sektioner, eller numret på en av dem, från 1; för hammaren `hammer.1.length` (files §1.3).</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Ord</translation>
    </message>
    <message>
        <source>Whether the hammer may strike again; otherwise it is withdrawn after the first separation</source>
        <translation>Om hammaren stannar kvar och kan träffas igen; annars tas den bort efter den första separationen</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>All results: keys of JSON, columns of CSV files, names for `--outputs`, rows of the window. The program writes this chapter from its own table. Scales are those of theory §2; for drill strings, W0 and W are the hammer energy E0 and I0 is the momentum p0.</source>
        <translation>Alla resultat: en nyckel i JSON, en kolumn i CSV-filer, ett namn för `--outputs`, en rad i fönstret. Programmet skriver detta kapitel ur den tabell som det arbetar med. Referensstorheterna är de i theory §2; för en borrsträng är W0 och W energin E0, I0 rörelsemängden p0.</translation>
    </message>
    <message>
        <source>One blow</source>
        <translation>Ett slag</translation>
    </message>
    <message>
        <source>Many blows under a feed</source>
        <translation>Många slag under en matning</translation>
    </message>
    <message>
        <source>%1 point in %2.</source>
        <translation>%1 punkt på %2.</translation>
    </message>
    <message>
        <source>%1 points in %2.</source>
        <translation>%1 punkter på %2.</translation>
    </message>
    <message>
        <source>a section is shorter than a time step: take more (--cells), or leave the section out and add its mass to the section before it</source>
        <translation>ett avsnitt är kortare än en cell i beräkningen: använd fler celler (--cells), eller utelämna avsnittet och ge dess massa till avsnittet framför</translation>
    </message>
    <message>
        <source>the interval of the blows is %1 times t0 = %2 s, at most %3 are followed; raise the frequency or make the blow longer</source>
        <translation>slagens intervall är %1 gånger t0 = %2 s, högst %3 gånger följs; höj frekvensen eller gör slaget längre</translation>
    </message>
    <message>
        <source>must be less than the blows, which are %1</source>
        <translation>måste vara mindre än antalet slag, %1</translation>
    </message>
    <message>
        <source>must be more than 0: the damper carries it</source>
        <translation>måste vara större än 0: dämparen bär den</translation>
    </message>
    <message>
        <source>a goal is a value of one output; choose one output</source>
        <translation>ett mål är ett värde av en utdata; välj en utdata</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3, not %4</source>
        <translation>%1 måste vara från %2 till %3, inte %4</translation>
    </message>
    <message>
        <source>there is no blow %1 of %2</source>
        <translation>det finns inget slag %1 av %2</translation>
    </message>
    <message>
        <source>a normal gap needs a mean of at least 0 and a deviation from %1 to %2 [d0]</source>
        <translation>en normalfördelad spalt kräver ett medelvärde på minst 0 och en avvikelse från %1 till %2 [d0]</translation>
    </message>
    <message>
        <source>the lattices of the paper solve only uniform rods</source>
        <translation>artikelns gitter löser bara likformiga stänger</translation>
    </message>
    <message>
        <source>cells are of drill strings (`drillwave: 2`)</source>
        <translation>celler finns bara för borrsträngar (`drillwave: 2`)</translation>
    </message>
    <message>
        <source>a sweep needs at least one axis and one output</source>
        <translation>ett svep kräver minst en axel och en utdata</translation>
    </message>
    <message>
        <source>does not apply to this scenario</source>
        <translation>har ingen betydelse i detta scenario</translation>
    </message>
    <message>
        <source>-o - names no folder for the files; add -o DIR, or --json, which prints to standard output</source>
        <translation>-o - anger ingen mapp för filerna; ange -o DIR, eller --json, som skriver till standard ut</translation>
    </message>
    <message>
        <source>--histories and --scan cannot be combined: a scan has many sequences; take one of them</source>
        <translation>--histories gäller slagen i en följd, och --scan räknar en för varje värde; välj en av dem</translation>
    </message>
    <message>
        <source>a uniform rod has no sections; they belong to `drillwave: 2`</source>
        <translation>får inte ha sektioner i en likformig stång: de hör till `drillwave: 2`</translation>
    </message>
    <message>
        <source>%1: another process writes these rows; wait for it, or end it</source>
        <translation>%1: en annan process skriver dessa rader; vänta på den, eller avsluta den</translation>
    </message>
    <message>
        <source>%1: belongs to another run (other options, inputs or build); use --force to start again, or choose another name</source>
        <translation>%1: hör till en annan körning (andra val, indata eller annat program); börja om med --force, eller välj ett annat namn</translation>
    </message>
    <message>
        <source>has no checksum, or was changed after it was written</source>
        <translation>har ingen kontrollsumma, eller ändrades efter att det skrevs</translation>
    </message>
    <message>
        <source>has no whole number `%1`</source>
        <translation>har inget heltal `%1`</translation>
    </message>
    <message>
        <source>has no `%1`</source>
        <translation>har inget `%1`</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>det är en länk</translation>
    </message>
    <message>
        <source>%1: this lock of the folder cannot be opened: %2; remove it or choose another folder</source>
        <translation>%1: mappens lås kan inte öppnas: %2; ta bort det eller välj en annan mapp</translation>
    </message>
    <message>
        <source>This report was written with --no-plots, so it has no plots. Write it again without that option to get them.</source>
        <translation>Diagrammen är utelämnade eftersom rapporten skrevs med --no-plots. Skriv den igen utan flaggan för att få dem.</translation>
    </message>
    <message>
        <source>%1 is true or false, so it cannot be an axis; give it with --set</source>
        <translation>%1 är sant eller falskt (true, false) och därmed ingen axel; ange det med --set</translation>
    </message>
    <message>
        <source>--samples %1: rounded up to %2, a power of two</source>
        <translation>--samples %1: tar %2, en tvåpotens</translation>
    </message>
    <message>
        <source>there is no drillwave-window beside this program; install the package drillwave, or build the program with DRILLWAVE_GUI=ON</source>
        <translation>det finns inget drillwave-window bredvid programmet; installera paketet drillwave eller bygg programmet med DRILLWAVE_GUI=ON</translation>
    </message>
    <message>
        <source>no window: %1; without it use `drillwave run FILE` (see --help)</source>
        <translation>inget fönster: %1; utan det används `drillwave run FILE` (se --help)</translation>
    </message>
    <message>
        <source>no pictures: %1; without it leave out --plots, and write a report with --no-plots</source>
        <translation>inga bilder: %1; utan det utelämnas --plots, och en rapport skrivs med --no-plots</translation>
    </message>
    <message>
        <source>the window cannot be opened on the platform of -platform or QT_QPA_PLATFORM; use `drillwave run FILE` or `-platform offscreen`</source>
        <translation>fönstret kan inte öppnas på plattformen från -platform eller QT_QPA_PLATFORM; använd `drillwave run FILE` eller `-platform offscreen`</translation>
    </message>
    <message>
        <source>display %1 cannot be reached; set DISPLAY to an available one, use `drillwave run FILE` (see --help), or `drillwave -platform offscreen`</source>
        <translation>skärmen %1 kan inte nås; sätt DISPLAY till en som finns, använd `drillwave run FILE` (se --help) eller `drillwave -platform offscreen`</translation>
    </message>
    <message>
        <source>there are no fonts for the letters of the pictures; install some (Debian: apt install fonts-dejavu-core), or leave out the pictures</source>
        <translation>det finns inga typsnitt för bildernas text; installera några (Debian: apt install fonts-dejavu-core) eller utelämna bilderna</translation>
    </message>
    <message>
        <source>Usage: drillwave %1
</source>
        <translation>Användning: drillwave %1
</translation>
    </message>
    <message>
        <source>option</source>
        <translation>flagga</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>gör</translation>
    </message>
    <message>
        <source>commands</source>
        <translation>kommandon</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>topics</source>
        <translation>vad som står där</translation>
    </message>
    <message>
        <source>The manual has `%1` in these places, the best first:</source>
        <translation>I handboken förekommer `%1` på dessa ställen, de bästa först:</translation>
    </message>
    <message>
        <source>Parameters and outputs: %1.</source>
        <translation>Parametrar och resultat: %1.</translation>
    </message>
    <message>
        <source>See also %1.</source>
        <translation>Se även %1.</translation>
    </message>
    <message>
        <source>%1: differs from its record: it has %2 bytes with checksum %3, written were %4 and %5; it was changed or is another part, so run it again</source>
        <translation>%1: är inte vad dess protokoll säger: har %2 byte med kontrollsumman %3, skrivna blev %4 med %5; filen har ändrats eller är en annan del, kör den igen</translation>
    </message>
    <message>
        <source>has no parts of --shard with their records</source>
        <translation>har inga delar av --shard med sina protokoll</translation>
    </message>
    <message>
        <source>a map needs KEY=START:STOP:COUNT or KEY=START:STOP:COUNT:log; `drillwave sweep` takes a list</source>
        <translation>en karta behöver KEY=START:STOP:COUNT eller KEY=START:STOP:COUNT:log; `drillwave sweep` tar en lista</translation>
    </message>
    <message>
        <source>waiting for another run of drillwave, which holds the lock %1; Ctrl-C stops waiting</source>
        <translation>väntar på en annan körning av drillwave, som håller låset %1; Ctrl-C avbryter</translation>
    </message>
    <message>
        <source>--no-plots: a PDF is drawn with its plots; give -o FILE.html</source>
        <translation>--no-plots: en PDF ritas med sina diagram; ange -o FILE.html</translation>
    </message>
    <message>
        <source>--resume applies to the file of -o; add -o FILE.csv</source>
        <translation>--resume gäller filen i -o; ange -o FILE.csv</translation>
    </message>
    <message>
        <source>%1 needs the rows in one run; leave out --resume</source>
        <translation>%1 kräver raderna från en enda körning; utelämna --resume</translation>
    </message>
    <message>
        <source>%1 rows take about %2 and %3. An interrupted run keeps no rows; with --resume it keeps finished rows, with --shard I/N finished parts</source>
        <translation>%1 rader tar ungefär %2 och %3. En körning som slutar i förtid lämnar inga rader, men med --resume de färdiga och med --shard I/N de färdiga delarna</translation>
    </message>
    <message>
        <source>%1: %2 rows take about %3, and the disk has %4 free; take fewer rows, or write parts (--shard I/N) to several disks</source>
        <translation>%1: %2 rader tar ungefär %3, och disken har %4 ledigt; ta färre rader, eller skriv delar (--shard I/N) till flera diskar</translation>
    </message>
    <message>
        <source>%1 of %2 rows could not be solved: their output cells are empty</source>
        <translation>%1 av %2 rader kunde inte lösas: deras utdataceller är tomma</translation>
    </message>
    <message>
        <source>%1: has all of these rows already</source>
        <translation>%1: har redan alla dessa rader</translation>
    </message>
    <message>
        <source>interrupted; %1 of %2 rows are kept in %3; the same command continues after them</source>
        <translation>avbruten; %1 av %2 rader finns i %3, och samma kommando fortsätter efter dem</translation>
    </message>
    <message>
        <source>Keep the present design, %1: none of the %2 designs compared is better (%3 = %4).</source>
        <translation>Behåll den nuvarande konstruktionen, %1: ingen av de %2 jämförda är bättre (%3 = %4).</translation>
    </message>
    <message>
        <source>Choose the design %1, which gives %2 = %3.</source>
        <translation>Välj konstruktionen %1, som ger %2 = %3.</translation>
    </message>
    <message>
        <source>feed required</source>
        <translation>erforderlig matningskraft</translation>
    </message>
    <message>
        <source>+- is the 95 % error: the scatter of the blows plus three times the change with half or twice the time step. Penetrations are upper limits: all rock under the bit breaks and cuttings are removed.</source>
        <translation>+- innehåller slagens spridning och tre gånger det som hälften eller dubbelt så många celler ändrar. Inträngningar är övre gränser: allt berg under borrkronan ger vika, och borrkaxet försvinner.</translation>
    </message>
    <message>
        <source>The single-blow estimate does not apply: the waves of a blow are still in the string at the next blow.</source>
        <translation>Uppskattningen från ett slag gäller inte: vågorna från ett slag är kvar i strängen när nästa kommer.</translation>
    </message>
    <message>
        <source>The feed force of %1 is less than the mean force of the blows, %2: the machine is pushed back.</source>
        <translation>Matningskraften %1 är mindre än slagens medelkraft, %2: maskinen trycks tillbaka.</translation>
    </message>
    <message>
        <source>A feed force of %1 is below the %2 that this blow requires: penetration will probably be lost.</source>
        <translation>En matningskraft på %1 är lägre än de %2 som detta slag kräver: inträngning går troligen förlorad.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %2, this blow requires at least %1.</source>
        <translation>Ingen matningskraft är angiven. Vid en slagfrekvens på %2 kräver detta slag minst %1.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %2, this blow requires at least %1, and blows at other gaps or on rigid rock up to %3.</source>
        <translation>Ingen matningskraft är angiven. Vid en slagfrekvens på %2 kräver detta slag minst %1, och slag vid andra spalter eller på stelt berg upp till %3.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %2, this blow requires at least %1, and rigid rock at least %3.</source>
        <translation>Ingen matningskraft är angiven. Vid en slagfrekvens på %2 kräver detta slag minst %1, och stelt berg minst %3.</translation>
    </message>
    <message>
        <source>The feed cannot be judged: give a blow frequency and a feed force.</source>
        <translation>Matningen bedöms inte: ange slagfrekvens och matningskraft.</translation>
    </message>
    <message>
        <source>The required feed force is estimated from single blows; %1 solves consecutive blows.</source>
        <translation>Den krävda matningskraften är uppskattad från enstaka slag; %1 simulerar slag efter slag.</translation>
    </message>
    <message>
        <source>installed feed force %1</source>
        <translation>installerad matningskraft %1</translation>
    </message>
    <message>
        <source>effective feed force %1 (installed %2, less %3 of weight along the hole)</source>
        <translation>verksam matningskraft %1 (installerad %2, minus %3 tyngd längs hålet)</translation>
    </message>
    <message>
        <source>effective feed force %1 (installed %2, and %3 of weight along the hole)</source>
        <translation>verksam matningskraft %1 (installerad %2, och %3 tyngd längs hålet)</translation>
    </message>
    <message>
        <source>Friction, rotation and buckling are not modelled.</source>
        <translation>Friktion, rotation och knäckning ingår inte i modellen.</translation>
    </message>
    <message>
        <source>Required feed</source>
        <translation>Matningskraft som krävs</translation>
    </message>
    <message>
        <source>no wave loss is defined</source>
        <translation>ingen vågförlust är angiven</translation>
    </message>
    <message>
        <source>the motion is irregular</source>
        <translation>rörelsen är oregelbunden</translation>
    </message>
    <message>
        <source>only few blows were followed</source>
        <translation>bara få slag följdes</translation>
    </message>
    <message>
        <source>the lengths are not whole numbers of time steps</source>
        <translation>längderna inte är ett helt antal tidssteg</translation>
    </message>
    <message>
        <source>Give a wave loss (%1): waves usually lose 1 to 30 % in each round trip.</source>
        <translation>Ange en vågförlust (%1): vågor förlorar vanligen 1 till 30&#xa0;% per varv fram och åter.</translation>
    </message>
    <message>
        <source>Increase the number of blows (%1) to reduce the error of the mean penetration.</source>
        <translation>Öka antalet slag (%1) för att minska medelinträngningens fel.</translation>
    </message>
    <message>
        <source>To reduce the error, use shorter time steps, or make the section lengths multiples of a common length.</source>
        <translation>För att minska felet, använd kortare tidssteg, eller gör sektionslängderna till multiplar av en gemensam längd.</translation>
    </message>
    <message>
        <source>The bit penetrates %1 per blow, at a penetration rate of %2.</source>
        <translation>Borrkronan tränger in %1 per slag, med en borrsjunkning på %2.</translation>
    </message>
    <message>
        <source>The bit penetrates %1 per blow. The penetration rate of %2 is %3 of the rate that single blows from rest would give.</source>
        <translation>Borrkronan tränger in %1 per slag. Borrsjunkningen %2 är %3 av den som enstaka slag från vila skulle ge.</translation>
    </message>
    <message>
        <source>The blows push the machine back without limit: increase the feed force.</source>
        <translation>Slagen trycker tillbaka maskinen utan gräns: öka matningskraften.</translation>
    </message>
    <message>
        <source>a feed force of %1</source>
        <translation>en matningskraft på %1</translation>
    </message>
    <message>
        <source>All values from %1 to %2 give the same penetration rate within the errors of the computation.</source>
        <translation>Alla värden från %1 till %2 ger samma borrsjunkning inom beräkningens fel.</translation>
    </message>
    <message>
        <source>a constant force</source>
        <translation>en konstant kraft</translation>
    </message>
    <message>
        <source>The mean penetration per blow is inaccurate: its error is above %1, because %2.</source>
        <translation>Medelinträngningen per slag är osäker: dess fel är över %1, eftersom %2.</translation>
    </message>
    <message>
        <source>In %1 of the blows, the bit is in contact with the rock when the blow arrives.</source>
        <translation>Vid %1 av slagen ligger borrkronan an mot berget när slaget kommer.</translation>
    </message>
    <message>
        <source>The connection between machine and rod is modelled as %1, which is an assumption.</source>
        <translation>Förbindelsen mellan maskin och stång är modellerad som %1, vilket är ett antagande.</translation>
    </message>
    <message>
        <source>The connection between machine and rod is modelled as %1.</source>
        <translation>Förbindelsen mellan maskin och stång är modellerad som %1.</translation>
    </message>
    <message>
        <source>All values of the scan give the same penetration rate, %1, within the errors of the computation.</source>
        <translation>Alla undersökta värden ger samma borrsjunkning, %1, inom beräkningens fel.</translation>
    </message>
    <message>
        <source>Margin over the largest of the four required forces (%1): %2.</source>
        <translation>Marginal över den största av de fyra krafter som krävs (%1): %2.</translation>
    </message>
    <message>
        <source>Margin over the larger of the two required forces (%1): %2.</source>
        <translation>Marginal över den större av de två krafter som krävs (%1): %2.</translation>
    </message>
    <message>
        <source>case</source>
        <translation>fall</translation>
    </message>
    <message>
        <source>return in time</source>
        <translation>återkomst i tid</translation>
    </message>
    <message>
        <source>The impulse of a blow is that from hammer to string. For drill strings, only the gap entered and rigid rock are examined.</source>
        <translation>Slagets impuls är den från hammaren till strängen. För borrsträngar undersöks bara den angivna spalten och stelt berg.</translation>
    </message>
    <message>
        <source>sequences of blows</source>
        <translation>slagföljder</translation>
    </message>
    <message>
        <source>all results: cones are solved more exactly</source>
        <translation>alla resultat, genom dess koner</translation>
    </message>
    <message>
        <source>cor and required feed: losses are counted</source>
        <translation>cor och den matningskraft som krävs, genom dess förluster</translation>
    </message>
    <message>
        <source>contact shares</source>
        <translation>andelar i kontakt</translation>
    </message>
    <message>
        <source>statements about the feed</source>
        <translation>utsagor om matningen</translation>
    </message>
    <message>
        <source>energies, which are in J beside SI</source>
        <translation>energier, som är i J bredvid SI</translation>
    </message>
    <message>
        <source>Written by Drillwave %1. Since then these results have changed: %2 (manual, Upgrading).</source>
        <translation>Skriven av Drillwave %1. Sedan dess har ändrats: %2 (handboken, kapitlet Upgrading).</translation>
    </message>
    <message>
        <source>%1: note: %2</source>
        <translation>%1: anmärkning: %2</translation>
    </message>
    <message>
        <source>presets need physical units, and this scenario is given by its dimensionless groups; choose a group such as beta</source>
        <translation>förval kräver fysikaliska enheter, och detta scenario ges av sina dimensionslösa tal; välj ett tal som beta</translation>
    </message>
    <message>
        <source>a uniform rod has no bit; use a drill string</source>
        <translation>en likformig stång har ingen borrkrona; en borrsträng har en</translation>
    </message>
    <message>
        <source>the string does not end with a section called bit; name its last section so</source>
        <translation>strängen slutar inte med en sektion som heter bit; ge den sista sektionen det namnet</translation>
    </message>
    <message>
        <source>a preset of a rod is for uniform rods, and this scenario is a drill string; choose sizes such as string.rod.diameter</source>
        <translation>ett förval för en stång gäller likformiga stänger, och detta scenario är en borrsträng; välj mått som string.rod.diameter</translation>
    </message>
    <message>
        <source>this drill string is struck by a prescribed force, which no preset replaces; choose numbers such as pulse.duration</source>
        <translation>denna borrsträng slås av en given kraft, som inget förval ersätter; välj tal som pulse.duration</translation>
    </message>
    <message>
        <source>The blow energy differs by up to %1 % between the designs: hammers of different power are compared.</source>
        <translation>Slagenergin skiljer sig med upp till %1&#xa0;% mellan konstruktionerna: hammare med olika effekt jämförs.</translation>
    </message>
    <message>
        <source>Change the design from %1 to %2, which gives %3 = %4. The present design does not meet all limits.</source>
        <translation>Ändra konstruktionen från %1 till %2, vilket ger %3 = %4. Den nuvarande konstruktionen uppfyller inte alla gränser.</translation>
    </message>
    <message>
        <source>Change %1 from %2 to %3, which gives %4 = %5. The present design does not meet all limits.</source>
        <translation>Ändra %1 från %2 till %3, vilket ger %4 = %5. Den nuvarande konstruktionen uppfyller inte alla gränser.</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Varning: %1</translation>
    </message>
    <message>
        <source>Warning for %1: %2</source>
        <translation>Varning för %1: %2</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabb</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>semikolon</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>lodstreck</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>blanksteg</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>komma</translation>
    </message>
    <message>
        <source>from the table</source>
        <translation>från tabellen</translation>
    </message>
    <message>
        <source>from the option</source>
        <translation>från alternativet</translation>
    </message>
    <message>
        <source>an estimate</source>
        <translation>en uppskattning</translation>
    </message>
    <message>
        <source>Which unit has the signal? Volts also need --scale 50kN/V, or --excitation, --gain, --bridge and --gauge-factor</source>
        <translation>I vilken enhet är signalen? Volt behöver också --scale 50kN/V eller --excitation, --gain, --bridge och --gauge-factor</translation>
    </message>
    <message>
        <source>What is the sampling rate?</source>
        <translation>Vilken är samplingsfrekvensen?</translation>
    </message>
    <message>
        <source>Which unit have the times?</source>
        <translation>I vilken enhet är tiderna?</translation>
    </message>
    <message>
        <source>Which column is the signal? Several are possible</source>
        <translation>Vilken kolumn är signalen? Flera kan vara det</translation>
    </message>
    <message>
        <source>Is the comma in 1,234 a decimal sign or a thousands separator?</source>
        <translation>Är tecknet i 1,234 ett decimaltecken eller skiljer det tusental?</translation>
    </message>
    <message>
        <source>What is the area of the bar at the gauge?</source>
        <translation>Hur stor är stångens area vid givaren?</translation>
    </message>
    <message>
        <source>What is Young&apos;s modulus of the bar?</source>
        <translation>Vilken är stångens elasticitetsmodul?</translation>
    </message>
    <message>
        <source>How many gauges of the bridge are active?</source>
        <translation>Hur många av bryggans givare är aktiva?</translation>
    </message>
    <message>
        <source>What is the gauge factor?</source>
        <translation>Vilken är givarfaktorn?</translation>
    </message>
    <message>
        <source>What is the impedance of the bar? Give it as 18kN s/m</source>
        <translation>Vilken är stångens impedans? Ange den som 18kN s/m</translation>
    </message>
    <message>
        <source>times of day, as s since the first</source>
        <translation>klockslag, som s sedan det första</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tid</translation>
    </message>
    <message>
        <source>column %1, %2, %3</source>
        <translation>kolumn %1, %2, %3</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>ingen enhet</translation>
    </message>
    <message>
        <source>evenly spaced, %1, %2</source>
        <translation>jämnt, %1, %2</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>ingen frekvens</translation>
    </message>
    <message>
        <source>format</source>
        <translation>format</translation>
    </message>
    <message>
        <source>%1, separator %2, decimal sign %3, samples from line %4</source>
        <translation>%1, avgränsare %2, decimaltecken %3, mätvärden från rad %4</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>stickprov</translation>
    </message>
    <message>
        <source>%1, one in %2, from %3 on</source>
        <translation>%1, ett per %2, från %3</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>topp</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>anmärkning</translation>
    </message>
    <message>
        <source>question</source>
        <translation>fråga</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>record</source>
        <translation>inspelning</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>frekvens</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>förskjutning</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>brus</translation>
    </message>
    <message>
        <source>remarks</source>
        <translation>anmärkningar</translation>
    </message>
    <message>
        <source>questions</source>
        <translation>frågor</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>ej läst</translation>
    </message>
    <message>
        <source>there is a row without values between the cases; delete it</source>
        <translation>en rad utan värden står mellan fallen; ta bort den</translation>
    </message>
    <message>
        <source>must be one of tab, semicolon, comma, bar, blank</source>
        <translation>måste vara ett av tab, semicolon, comma, bar, blank</translation>
    </message>
    <message>
        <source>must be point or comma</source>
        <translation>måste vara point eller comma</translation>
    </message>
    <message>
        <source>must be one of utf-8, windows-1252, latin-1, utf-16le, utf-16be</source>
        <translation>måste vara ett av utf-8, windows-1252, latin-1, utf-16le, utf-16be</translation>
    </message>
    <message>
        <source>must be the name of a column, or its number from 1</source>
        <translation>måste vara namnet på en kolumn eller dess nummer från 1</translation>
    </message>
    <message>
        <source>must be a unit of time, one of %1</source>
        <translation>måste vara en tidsenhet, en av %1</translation>
    </message>
    <message>
        <source>must be a unit of a signal, one of %1</source>
        <translation>måste vara en enhet för en signal, en av %1</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>måste vara över 0</translation>
    </message>
    <message>
        <source>must be two times A:B, as in -50us:-10us</source>
        <translation>måste vara två tider A:B, som i -50us:-10us</translation>
    </message>
    <message>
        <source>the first time must be before the second one</source>
        <translation>den första tiden måste vara före den andra</translation>
    </message>
    <message>
        <source>must be a factor that is not 0, or a force per unit: 2.5, 50kN/V, 18kN s/m</source>
        <translation>måste vara en faktor som inte är 0, eller en kraft per enhet: 2.5, 50kN/V, 18kN s/m</translation>
    </message>
    <message>
        <source>must be refuse or skip</source>
        <translation>måste vara refuse eller skip</translation>
    </message>
    <message>
        <source>%1 equal samples at the largest value, %2: clipped?</source>
        <translation>%1 lika mätvärden vid det största värdet, %2: avklippt?</translation>
    </message>
    <message>
        <source>before the blow the record is at %1 of its peak: set the zero line</source>
        <translation>före slaget ligger mätningen på %1 av sin topp: ställ in nollinjen</translation>
    </message>
    <message>
        <source>the zero line drifts by %1 of the peak per ms</source>
        <translation>nollinjen driver med %1 av toppen per ms</translation>
    </message>
    <message>
        <source>the resolution of the recorder is %1 of the peak, coarser than the noise: use a smaller range</source>
        <translation>instrumentet har steg på %1 av toppen, och bruset är mindre: använd ett mindre mätområde</translation>
    </message>
    <message>
        <source>time steps differ from the usual step by up to %1</source>
        <translation>tidssteg avviker med upp till %1 från det vanliga</translation>
    </message>
    <message>
        <source>the record holds %1 blows: choose one by its range of time</source>
        <translation>mätningen innehåller %1 slag: välj ett genom dess tidsområde</translation>
    </message>
    <message>
        <source>opposite gauges differ: half their difference is %1 of the peak (rms); check for bending or a loose gauge</source>
        <translation>motstående givare skiljer sig: halva skillnaden är %1 av toppen (effektivvärde); är stången böjd eller en givare lös?</translation>
    </message>
    <message>
        <source>the times have a gap of %1</source>
        <translation>tiderna har ett gap på %1</translation>
    </message>
    <message>
        <source>this is not a table: it is %1</source>
        <translation>det är ingen tabell: det är %1</translation>
    </message>
    <message>
        <source>each channel is a row: the table was transposed, lines count its columns</source>
        <translation>varje kanal är en rad: tabellen är vriden, radnummer räknar dess kolumner</translation>
    </message>
    <message>
        <source>no line of numbers is found in the first %1 lines; is it a table of samples? Give --separator, --decimal or --first-line</source>
        <translation>ingen rad med tal finns bland de första %1 raderna; är det en tabell med mätvärden? Ange --separator, --decimal eller --first-line</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>rad %1: %2</translation>
    </message>
    <message>
        <source>there is no column `%1`; there are: %2</source>
        <translation>det finns ingen kolumn `%1`; det finns: %2</translation>
    </message>
    <message>
        <source>column %1 cannot be time and signal; choose another by --signal-column</source>
        <translation>kolumn %1 kan inte vara både tid och signal; välj en annan med --signal-column</translation>
    </message>
    <message>
        <source>%1 (--rows skip)</source>
        <translation>%1 (--rows skip)</translation>
    </message>
    <message>
        <source>NUL bytes end the table: the recorder did not fill its file</source>
        <translation>NUL-byte avslutar tabellen: mätinstrumentet fyllde inte sin fil</translation>
    </message>
    <message>
        <source>%1 rows without a number are skipped, the first is line %2</source>
        <translation>%1 rader utan tal hoppas över, den första är rad %2</translation>
    </message>
    <message>
        <source>%1 of them are marked as overload of the recorder</source>
        <translation>%1 av dem säger att instrumentet var överstyrt</translation>
    </message>
    <message>
        <source>skipped rows leave a gap of %1 in the blow, from %2: it is filled by a straight line</source>
        <translation>överhoppade rader lämnar ett gap på %1 i slaget, från %2: räta linjer korsar det</translation>
    </message>
    <message>
        <source>no sample lies between the times of --zero, %1 and %2</source>
        <translation>inget mätvärde ligger mellan tiderna i --zero, %1 och %2</translation>
    </message>
    <message>
        <source>an Excel workbook (.xlsx); save the sheet as CSV</source>
        <translation>en Excel-arbetsbok (.xlsx); spara bladet som CSV</translation>
    </message>
    <message>
        <source>an OpenDocument spreadsheet (.ods); save the sheet as CSV</source>
        <translation>ett OpenDocument-kalkylark (.ods); spara bladet som CSV</translation>
    </message>
    <message>
        <source>a zip archive; unpack it first</source>
        <translation>ett zip-arkiv; packa upp det först</translation>
    </message>
    <message>
        <source>compressed by gzip; unpack it first</source>
        <translation>komprimerat med gzip; packa upp det först</translation>
    </message>
    <message>
        <source>compressed by bzip2; unpack it first</source>
        <translation>komprimerat med bzip2; packa upp det först</translation>
    </message>
    <message>
        <source>compressed by xz; unpack it first</source>
        <translation>komprimerat med xz; packa upp det först</translation>
    </message>
    <message>
        <source>a 7-Zip archive; unpack it first</source>
        <translation>ett 7-Zip-arkiv; packa upp det först</translation>
    </message>
    <message>
        <source>compressed by zstd; unpack it first</source>
        <translation>komprimerat med zstd; packa upp det först</translation>
    </message>
    <message>
        <source>an old Excel workbook (.xls); save the sheet as CSV</source>
        <translation>en gammal Excel-arbetsbok (.xls); spara bladet som CSV</translation>
    </message>
    <message>
        <source>an HDF5 file (MATLAB 7.3 also writes it); export the channels as CSV</source>
        <translation>en HDF5-fil (MATLAB 7.3 skriver också sådana); exportera kanalerna som CSV</translation>
    </message>
    <message>
        <source>a MATLAB file; export the channels as CSV</source>
        <translation>en MATLAB-fil; exportera kanalerna som CSV</translation>
    </message>
    <message>
        <source>a TDMS file; export the channels as CSV</source>
        <translation>en TDMS-fil; exportera kanalerna som CSV</translation>
    </message>
    <message>
        <source>a NumPy array; write it by numpy.savetxt</source>
        <translation>en NumPy-matris; skriv den med numpy.savetxt</translation>
    </message>
    <message>
        <source>a Parquet file; export the columns as CSV</source>
        <translation>en Parquet-fil; exportera kolumnerna som CSV</translation>
    </message>
    <message>
        <source>an SQLite database; export a table as CSV</source>
        <translation>en SQLite-databas; exportera en tabell som CSV</translation>
    </message>
    <message>
        <source>a PDF document, not a table</source>
        <translation>ett PDF-dokument, ingen tabell</translation>
    </message>
    <message>
        <source>a document in RTF; save it as plain text</source>
        <translation>ett RTF-dokument; spara det som ren text</translation>
    </message>
    <message>
        <source>a picture, not a table</source>
        <translation>en bild, ingen tabell</translation>
    </message>
    <message>
        <source>a sound or video file (RIFF); export samples as CSV</source>
        <translation>en ljud- eller videofil (RIFF); exportera mätvärdena som CSV</translation>
    </message>
    <message>
        <source>text in UTF-32; save it as UTF-8</source>
        <translation>text i UTF-32; spara den som UTF-8</translation>
    </message>
    <message>
        <source>an XML document; save the sheet as CSV</source>
        <translation>ett XML-dokument; spara bladet som CSV</translation>
    </message>
    <message>
        <source>a web page; save the table as CSV</source>
        <translation>en webbsida; spara tabellen som CSV</translation>
    </message>
    <message>
        <source>is not a bit; give the preset of a bit</source>
        <translation>är ingen borrkrona; ange förvalet för en borrkrona</translation>
    </message>
    <message>
        <source>is not a rod; give the preset of a rod</source>
        <translation>är ingen stång; ange förvalet för en stång</translation>
    </message>
    <message>
        <source>does not fit a drill string; give the preset of a piston</source>
        <translation>passar inte en borrsträng, vars hammare också beräknas; ange förvalet för en kolv</translation>
    </message>
    <message>
        <source>does not fit a uniform rod; give the preset of a hammer</source>
        <translation>passar inte en likformig stång, vars hammare är en kraft; ange förvalet för en hammare</translation>
    </message>
    <message>
        <source>must be a list of texts, each after a `-`</source>
        <translation>måste vara en lista med texter, var och en efter ett `-`</translation>
    </message>
    <message>
        <source>has an item that is not text</source>
        <translation>har en post som inte är en text</translation>
    </message>
    <message>
        <source>holds no header `%1`</source>
        <translation>har ingen rubrikrad `%1`</translation>
    </message>
    <message>
        <source>each channel is a row; run `drillwave signal FILE -o blow.csv` and use blow.csv</source>
        <translation>varje kanal är en rad; skriv `drillwave signal FILE -o blow.csv` och använd den filen</translation>
    </message>
    <message>
        <source>1,234 can be a decimal number or a thousand: write one number with another count of decimals, such as 0,5 or 0.5</source>
        <translation>1,234 kan vara ett tal med decimaler eller ett tusental: skriv ett tal med ett annat antal decimaler, till exempel 0,5 eller 0.5</translation>
    </message>
    <message>
        <source>several columns could be the force, %1 is one; leave the others out</source>
        <translation>flera kolumner kan vara kraften, %1 är en; utelämna de andra</translation>
    </message>
    <message>
        <source>%1 is not a force; `--signal FILE` and the import convert strains and volts</source>
        <translation>%1 är ingen kraft; `--signal FILE` och importen gör en av töjningar och volt</translation>
    </message>
    <message>
        <source>is not a file of recorders; it must begin with `drillwave_recorders: 1`</source>
        <translation>är ingen fil med mätinstrument; den måste börja med `drillwave_recorders: 1`</translation>
    </message>
    <message>
        <source>`%1` is not a known key; only `recorders` is</source>
        <translation>`%1` är ingen känd nyckel; endast `recorders` är det</translation>
    </message>
    <message>
        <source>must be a list of recorders with settings</source>
        <translation>måste vara namn på mätinstrument med inställningar</translation>
    </message>
    <message>
        <source>must be settings, each `option: value`</source>
        <translation>måste vara inställningar, var och en `option: value`</translation>
    </message>
    <message>
        <source>`%1` is not an option of drillwave signal</source>
        <translation>`%1` är inget alternativ till drillwave signal</translation>
    </message>
    <message>
        <source>the recorder `%1` is given twice</source>
        <translation>mätinstrumentet `%1` finns två gånger</translation>
    </message>
    <message>
        <source>not YAML: this line is indented by a tab; indent it by blanks</source>
        <translation>inte YAML: raden är indragen med en tabb; dra in den med blanksteg</translation>
    </message>
    <message>
        <source>-o takes one record; give one FILE</source>
        <translation>-o tar en mätning; ange en FILE</translation>
    </message>
    <message>
        <source>the file of recorders %1</source>
        <translation>filen med mätinstrument %1</translation>
    </message>
    <message>
        <source>--recorder %1: is not known; did you mean `%2`?</source>
        <translation>--recorder %1: är inte känt; menade du `%2`?</translation>
    </message>
    <message>
        <source>--recorder %1: is not known; --save-recorder %1 keeps options in %2</source>
        <translation>--recorder %1: är inte känt; --save-recorder %1 sparar alternativ i %2</translation>
    </message>
    <message>
        <source>--from must be before --to</source>
        <translation>--from måste vara före --to</translation>
    </message>
    <message>
        <source>--save-recorder needs a name, this one is empty</source>
        <translation>--save-recorder behöver ett namn, detta är tomt</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: kan inte skrivas: %2</translation>
    </message>
    <message>
        <source>%1 applies to a record; add --signal FILE</source>
        <translation>%1 gäller en mätning; lägg till --signal FILE</translation>
    </message>
    <message>
        <source>is given by its dimensionless groups; --signal needs physical units</source>
        <translation>anges av sina dimensionslösa grupper; --signal behöver fysikaliska enheter</translation>
    </message>
    <message>
        <source>the table does not state: %1; give %2, see drillwave signal</source>
        <translation>tabellen lämnar öppet: %1; svara med %2, se drillwave signal</translation>
    </message>
    <message>
        <source>%1: note: %2 of %3 samples are kept, impulse and e to 1e-4; --all-samples keeps all</source>
        <translation>%1: notera: %2 av %3 mätvärden behålls, impuls och e till 1e-4; --all-samples behåller alla</translation>
    </message>
    <message>
        <source>is not text</source>
        <translation>är ingen text</translation>
    </message>
    <message>
        <source>needs at least two rows of numbers below the header</source>
        <translation>två rader med tal behövs under rubriken</translation>
    </message>
    <message>
        <source>Between bit and rock when the hammer strikes</source>
        <translation>Mellan borrkrona och berg när hammaren slår</translation>
    </message>
    <message>
        <source>Impulse on the rock in a cycle; its mean is the feed force times the interval</source>
        <translation>För ett slag och cykeln efter det; i medeltal matningen gånger tiden mellan slagen</translation>
    </message>
    <message>
        <source>Per blow; an upper limit: all rock under the bit breaks</source>
        <translation>För ett slag, en övre gräns: allt berg under borrkronan ger efter</translation>
    </message>
    <message>
        <source>Largest force on the rock in a cycle</source>
        <translation>Bergets största kraft i en cykel</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>kontakter</translation>
    </message>
    <message>
        <source>Number of contacts in a cycle</source>
        <translation>Hur många kontakter som börjar i en cykel</translation>
    </message>
    <message>
        <source>Record:</source>
        <translation>Mätning:</translation>
    </message>
    <message>
        <source>The hammer is rounded to %1, so that waves can be kept. Its impulse is the same; its blow is longer or shorter in proportion.</source>
        <translation>Hammaren är avrundad till %1, så att vågor kan sparas; den ger samma impuls, i ett slag som är så mycket längre eller kortare.</translation>
    </message>
    <message>
        <source>The rod is rounded to %1, so that waves can be kept.</source>
        <translation>Stången är avrundad till %1, så att vågor kan sparas.</translation>
    </message>
    <message>
        <source>%1th</source>
        <translation>%1:e</translation>
    </message>
    <message>
        <source>%1st</source>
        <translation>%1:a</translation>
    </message>
    <message>
        <source>%1nd</source>
        <translation>%1:a</translation>
    </message>
    <message>
        <source>%1rd</source>
        <translation>%1:e</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>sections %1 to %2</source>
        <translation>sektioner %1 till %2</translation>
    </message>
    <message>
        <source>sections %1 and %2</source>
        <translation>sektioner %1 och %2</translation>
    </message>
    <message>
        <source>sections %1, %2 … %3</source>
        <translation>sektioner %1, %2 … %3</translation>
    </message>
    <message>
        <source>%1 and %2 %3</source>
        <translation>%1 och %2 %3</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 till %2 %3</translation>
    </message>
    <message>
        <source>%1, %2 … %3 %4</source>
        <translation>%1, %2 … %3 %4</translation>
    </message>
    <message>
        <source>%1 section</source>
        <translation>%1 sektion</translation>
    </message>
    <message>
        <source>%1 sections</source>
        <translation>%1 sektioner</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 rod</source>
        <translation>%1 stång</translation>
    </message>
    <message>
        <source>%1 rods</source>
        <translation>%1 stänger</translation>
    </message>
    <message>
        <source>%1 coupling</source>
        <translation>%1 skarvhylsa</translation>
    </message>
    <message>
        <source>%1 couplings</source>
        <translation>%1 skarvhylsor</translation>
    </message>
    <message>
        <source>%1 other section</source>
        <translation>%1 annan sektion</translation>
    </message>
    <message>
        <source>%1 other sections</source>
        <translation>%1 andra sektioner</translation>
    </message>
    <message>
        <source>During the blow, the most heavily loaded section (%1) has a tension of %2, which is %3 of its fatigue strength of %4.</source>
        <translation>Under slaget har den hårdast belastade sektionen (%1) en dragspänning på %2, vilket är %3 av utmattningsgränsen %4.</translation>
    </message>
    <message>
        <source>During the blow, the most heavily loaded section (%1) has a tension of %2, which is %3 of its yield strength of %4.</source>
        <translation>Under slaget har den hårdast belastade sektionen (%1) en dragspänning på %2, vilket är %3 av sträckgränsen %4.</translation>
    </message>
    <message>
        <source>During the blow, the most heavily loaded section (%1) has a compression of %2, which is %3 of its yield strength of %4.</source>
        <translation>Under slaget har den hårdast belastade sektionen (%1) en tryckspänning på %2, vilket är %3 av sträckgränsen %4.</translation>
    </message>
    <message>
        <source>No section has a strength. Enter a strength (%1) to find the section that breaks first.</source>
        <translation>Ingen sektion har en hållfasthet. Ange en hållfasthet (%1) för att hitta den sektion som brister först.</translation>
    </message>
    <message>
        <source>the rod</source>
        <translation>stången</translation>
    </message>
    <message>
        <source>No strength is given for %1 section of the string.</source>
        <translation>Hållfasthet saknas för %1 sektion av strängen.</translation>
    </message>
    <message>
        <source>No strength is given for %1 sections of the string.</source>
        <translation>Hållfasthet saknas för %1 sektioner av strängen.</translation>
    </message>
    <message>
        <source>is empty; leave it out for a section without a preset</source>
        <translation>är tomt; en sektion som inte kommer från ett förval skrivs utan det</translation>
    </message>
    <message>
        <source>This blow has too many waves to store them all. Plots of waves and forces therefore show a coarser model of the string. Its coefficient of restitution and efficiency differ by at most %1.</source>
        <translation>Slaget har för många vågor för att alla ska kunna sparas. Vågor och krafter i diagrammen är därför från en grövre indelad sträng. Dess studstal och verkningsgrad avviker med högst %1.</translation>
    </message>
    <message>
        <source>%1, but a small disturbance grows</source>
        <translation>%1, men en liten störning växer</translation>
    </message>
    <message>
        <source>%1 needs rows with points and commas; leave out --decimal-comma</source>
        <translation>%1 kräver rader med punkter och kommatecken; utelämna --decimal-comma</translation>
    </message>
    <message>
        <source>Enter a wave loss under “%1”: waves usually lose 1 to 30 % in each round trip.</source>
        <translation>Ange en vågförlust under ”%1”: vågor förlorar vanligen 1 till 30&#xa0;% per varv fram och åter.</translation>
    </message>
    <message>
        <source>Enter a larger number under “%1” to reduce the error of the mean penetration.</source>
        <translation>Ange ett större tal under ”%1” för att minska medelinträngningens fel.</translation>
    </message>
    <message>
        <source>undamped</source>
        <translation>odämpade</translation>
    </message>
    <message>
        <source>damped only by the losses of the string</source>
        <translation>dämpade bara av strängens förluster</translation>
    </message>
    <message>
        <source>%1 % of the wave is left, with a loss of %2 % per round trip</source>
        <translation>%1&#xa0;% av vågen är kvar, med %2&#xa0;% förlust per varv</translation>
    </message>
    <message>
        <source>This blow is not over after %1, when the next blow starts: the bit may hit the rock again. The values are for that moment and not final.</source>
        <translation>Detta slag är inte över efter %1, när nästa börjar: borrkronan kan träffa berget igen. Värdena gäller vid den tiden och är inte slutliga.</translation>
    </message>
    <message>
        <source>could not be solved at all gaps: %1</source>
        <translation>kunde inte lösas vid alla spalter: %1</translation>
    </message>
    <message>
        <source>Results repeat every d₀ of gap.</source>
        <translation>När spalten växer upprepar sig resultaten för varje d₀.</translation>
    </message>
    <message>
        <source>Results repeat every d₀ = %1 of gap.</source>
        <translation>När spalten växer upprepar sig resultaten för varje d₀ = %1.</translation>
    </message>
    <message>
        <source>How the gap scatters</source>
        <translation>Hur spalten sprider</translation>
    </message>
    <message>
        <source>The gap at the rig is a matter of chance: all gaps of a period equally likely, or a normal distribution cut off at zero</source>
        <translation>Ingen styr spalten på riggen: alla spalter i en period lika, eller en normalfördelning avskuren vid ingen spalt</translation>
    </message>
    <message>
        <source>all equally likely</source>
        <translation>alla lika sannolika</translation>
    </message>
    <message>
        <source>mean ± deviation</source>
        <translation>medel ± standardavv.</translation>
    </message>
    <message>
        <source>COR–gap</source>
        <translation>e–spalt</translation>
    </message>
    <message>
        <source>Result over the gap, and how its values are distributed</source>
        <translation>Resultat över spalten, och hur dess värden fördelar sig</translation>
    </message>
    <message>
        <source>mean of the gap</source>
        <translation>spaltens medelvärde</translation>
    </message>
    <message>
        <source>standard deviation of the gap</source>
        <translation>spaltens standardavvikelse</translation>
    </message>
    <message>
        <source>COR e</source>
        <translation>studstal e</translation>
    </message>
    <message>
        <source>peak force Fm</source>
        <translation>toppkraft Fm</translation>
    </message>
    <message>
        <source>A first look; the curve follows.</source>
        <translation>En första blick; kurvan följer.</translation>
    </message>
    <message>
        <source>Click on the curve to use that gap; Shift+click pins it.</source>
        <translation>Klick på kurvan: använd den spalten; med Skift: fäst den för jämförelse.</translation>
    </message>
    <message>
        <source>COR–gap needs a uniform rod, whose results repeat over the gap. For drill strings they do not repeat: Efficiency–stiffness shows them over the gap, point by point.</source>
        <translation>e–spalt gäller likformiga stänger, vars resultat upprepas över spalten; en borrsträngs resultat gör inte det, och Verkningsgrad–styvhet visar dem över spalten punkt för punkt.</translation>
    </message>
    <message>
        <source>gap d</source>
        <translation>spalt d</translation>
    </message>
    <message>
        <source>δ = gap / d₀</source>
        <translation>δ = spalt / d₀</translation>
    </message>
    <message>
        <source>per class [%]</source>
        <translation>per klass [%]</translation>
    </message>
    <message>
        <source>cumulative [%]</source>
        <translation>kumulativt [%]</translation>
    </message>
    <message>
        <source>share per class</source>
        <translation>andel per klass</translation>
    </message>
    <message>
        <source>cumulative share</source>
        <translation>kumulativ andel</translation>
    </message>
    <message>
        <source>super rebound, e &gt; 1</source>
        <translation>superstuds, e &gt; 1</translation>
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
        <translation>spridd spalt: medel %1, 5–95 % %2…%3</translation>
    </message>
    <message>
        <source>all gaps: mean %1, 5–95 % %2…%3</source>
        <translation>alla spalter: medel %1, 5–95&#xa0;% %2…%3</translation>
    </message>
    <message>
        <source>e &gt; 1 at %1 of gaps</source>
        <translation>e &gt; 1 vid %1 av spalterna</translation>
    </message>
    <message>
        <source>feed force enough for 95 % of gaps: %1</source>
        <translation>matningskraft som räcker för 95&#xa0;% av spalterna: %1</translation>
    </message>
    <message>
        <source>records</source>
        <translation>mätningar</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>give COLUMN@DISTANCE, the distance from the bit face</source>
        <translation>ange COLUMN@DISTANCE, avståndet från kronans frontyta</translation>
    </message>
    <message>
        <source>two columns belong around the plus sign</source>
        <translation>kring plustecknet hör två kolumner hemma</translation>
    </message>
    <message>
        <source>the distance must be positive</source>
        <translation>avståndet måste vara positivt</translation>
    </message>
    <message>
        <source>give KEY=+-TOLERANCE</source>
        <translation>ange KEY=+-TOLERANCE</translation>
    </message>
    <message>
        <source>must be a percentage, such as +-2%</source>
        <translation>måste vara en procentsats, till exempel +-2%</translation>
    </message>
    <message>
        <source>the tolerance must be positive</source>
        <translation>toleransen måste vara positiv</translation>
    </message>
    <message>
        <source>--%1 %2: must be one of %3</source>
        <translation>--%1 %2: måste vara något av %3</translation>
    </message>
    <message>
        <source>both gauges must be on one section of the string</source>
        <translation>båda givarna måste sitta på samma sektion av strängen</translation>
    </message>
    <message>
        <source>two gauges must be at least 0.5 m apart</source>
        <translation>två givare måste sitta minst 0,5 m från varandra</translation>
    </message>
    <message>
        <source>needs --signals REC.csv</source>
        <translation>behöver --signals REC.csv</translation>
    </message>
    <message>
        <source>%1 is given twice; give each record once</source>
        <translation>%1 är angivet två gånger; ange varje mätning en gång</translation>
    </message>
    <message>
        <source>needs --gauge COLUMN@DISTANCE</source>
        <translation>behöver --gauge COLUMN@DISTANCE</translation>
    </message>
    <message>
        <source>takes one or two gauges</source>
        <translation>tar en eller två givare</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>måste vara positivt</translation>
    </message>
    <message>
        <source>is given by its dimensionless groups; identify needs physical units</source>
        <translation>är givet av sina dimensionslösa tal; identify kräver fysikaliska enheter</translation>
    </message>
    <message>
        <source>is not on a uniform section of the rod or string</source>
        <translation>sitter inte på en likformig sektion av stången eller strängen</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 mätningar</translation>
    </message>
    <message>
        <source>rock when it is first loaded</source>
        <translation>berget när det först belastas</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>styvhet</translation>
    </message>
    <message>
        <source>elasticity</source>
        <translation>elasticitet</translation>
    </message>
    <message>
        <source>bit not seated</source>
        <translation>kronan ligger inte an</translation>
    </message>
    <message>
        <source>force at which the rock yields</source>
        <translation>kraft vid vilken berget ger efter</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>hörn</translation>
    </message>
    <message>
        <source>slope after yielding</source>
        <translation>lutning efter att berget gett efter</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>lutning</translation>
    </message>
    <message>
        <source>known</source>
        <translation>känt</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>osäkert</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>mindre än %1</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>större än %1</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>begränsat</translation>
    </message>
    <message>
        <source>not seen: no contact</source>
        <translation>syns inte: ingen kontakt</translation>
    </message>
    <message>
        <source>not seen: the rock is too stiff</source>
        <translation>syns inte: berget är för styvt</translation>
    </message>
    <message>
        <source>not seen: the record ends before the rock unloads</source>
        <translation>syns inte: mätningen slutar innan berget avlastas</translation>
    </message>
    <message>
        <source>next blow</source>
        <translation>nästa slag</translation>
    </message>
    <message>
        <source>changes from blow to blow</source>
        <translation>ändras från slag till slag</translation>
    </message>
    <message>
        <source>no change is seen</source>
        <translation>ingen ändring syns</translation>
    </message>
    <message>
        <source>waves that follow the blow</source>
        <translation>vågor som följer slaget</translation>
    </message>
    <message>
        <source>arrival of the reflection</source>
        <translation>reflexionens ankomst</translation>
    </message>
    <message>
        <source>modulus and density</source>
        <translation>E-modul och densitet</translation>
    </message>
    <message>
        <source>gain of the amplifier</source>
        <translation>förstärkarens förstärkning</translation>
    </message>
    <message>
        <source>distance between the gauges</source>
        <translation>avstånd mellan givarna</translation>
    </message>
    <message>
        <source>force rise hidden by noise</source>
        <translation>kraftökning, dold av brus</translation>
    </message>
    <message>
        <source>step of the recorder</source>
        <translation>mätinstrumentets upplösningssteg</translation>
    </message>
    <message>
        <source>unexplained waves</source>
        <translation>oförklarade vågor</translation>
    </message>
    <message>
        <source>assumed +-%1</source>
        <translation>antaget ±%1</translation>
    </message>
    <message>
        <source>Limits of the result</source>
        <translation>Vad som begränsar resultatet</translation>
    </message>
    <message>
        <source>%1 +-%2</source>
        <translation>%1 ±%2</translation>
    </message>
    <message>
        <source>To know more: average 4 blows: %1.</source>
        <translation>För att veta mer: ta medelvärdet av 4 slag: %1.</translation>
    </message>
    <message>
        <source>To know more: use gauges on opposite sides: %1.</source>
        <translation>För att veta mer: använd givare på motstående sidor: %1.</translation>
    </message>
    <message>
        <source>To know more: use gauges on opposite sides, or a second gauge: %1.</source>
        <translation>För att veta mer: använd givare på motstående sidor, eller en andra givare: %1.</translation>
    </message>
    <message>
        <source>To know more: use a smaller range or more bits: %1.</source>
        <translation>För att veta mer: använd ett mindre mätområde eller fler bitar: %1.</translation>
    </message>
    <message>
        <source>To know more: measure the distance of the gauge from the bit: %1.</source>
        <translation>För att veta mer: mät givarens avstånd från kronan: %1.</translation>
    </message>
    <message>
        <source>To know more: measure %1 to %2: %3.</source>
        <translation>För att veta mer: mät %1 med noggrannheten %2: %3.</translation>
    </message>
    <message>
        <source>match</source>
        <translation>överensstämmelse</translation>
    </message>
    <message>
        <source>in quiet</source>
        <translation>i lugnet</translation>
    </message>
    <message>
        <source>%1 of the peak where nothing should be (bending and the like)</source>
        <translation>%1 av toppen där inget borde finnas (böjning och liknande)</translation>
    </message>
    <message>
        <source>reflection after %1, the file says %2</source>
        <translation>reflexion efter %1, filen säger %2</translation>
    </message>
    <message>
        <source>%1; gain of the second gauge %2</source>
        <translation>%1; den andra givarens förstärkning %2</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>tider</translation>
    </message>
    <message>
        <source>zero line</source>
        <translation>nollinje</translation>
    </message>
    <message>
        <source>%1 of the peak, %2 in a millisecond</source>
        <translation>%1 av toppen, %2 på en millisekund</translation>
    </message>
    <message>
        <source>laws tried</source>
        <translation>prövade lagar</translation>
    </message>
    <message>
        <source>The reflection does not arrive at the time computed from the scenario file. Check the distance of the gauge from the bit, the wave speed, the sampling clock, and whether the file lacks a section.</source>
        <translation>Reflexionen kommer inte vid den tid som beräknas ur scenariofilen. Kontrollera givarens avstånd från kronan, våghastigheten, samplingsklockan, och om en sektion saknas i filen.</translation>
    </message>
    <message>
        <source>A section between gauge and bit differs from the scenario file. Measure the bit head and the rod, and check whether the file lacks a section.</source>
        <translation>En sektion mellan givare och borrkrona avviker från scenariofilen. Mät kronhuvudet och stången, och kontrollera om en sektion saknas i filen.</translation>
    </message>
    <message>
        <source>The distance between the gauges, or a section between gauge and bit, differs from the scenario file. Measure this distance, the bit head and the rod.</source>
        <translation>Avståndet mellan givarna, eller en sektion mellan givare och borrkrona, avviker från scenariofilen. Mät detta avstånd, kronhuvudet och stången.</translation>
    </message>
    <message>
        <source>The record shows waves at times when the rod should be at rest. Possible causes: bending (use gauges on opposite sides of the rod), the blow before, or couplings.</source>
        <translation>Mätningen visar vågor vid tider då stången borde vara i vila. Möjliga orsaker: böjning (använd givare på motsatta sidor av stången), slaget innan, eller skarvhylsor.</translation>
    </message>
    <message>
        <source>The zero line of the record drifts by more than the tolerance of the amplifier. Check the zero and the drift of the amplifier, and whether it is AC or DC coupled.</source>
        <translation>Mätningens nollinje rör sig mer än förstärkarens tolerans. Kontrollera förstärkarens nollpunkt och drift, och om den är AC- eller DC-kopplad.</translation>
    </message>
    <message>
        <source>The rod still rings from an earlier blow when this blow starts: measure a single blow.</source>
        <translation>Stången svänger fortfarande efter ett tidigare slag när detta slag börjar: mät ett enstaka slag.</translation>
    </message>
    <message>
        <source>The model does not agree with the record, so nothing is known about the rock. %1</source>
        <translation>Modellen stämmer inte med mätningen, så inget är känt om berget. %1</translation>
    </message>
    <message>
        <source>The record agrees with the rock of the scenario file.</source>
        <translation>Mätningen stämmer med scenariofilens berg.</translation>
    </message>
    <message>
        <source>The record contradicts the rock of the scenario file.</source>
        <translation>Mätningen motsäger scenariofilens berg.</translation>
    </message>
    <message>
        <source>The record agrees only roughly with the rock of the scenario file.</source>
        <translation>Mätningen stämmer bara ungefär med scenariofilens berg.</translation>
    </message>
    <message>
        <source>The record agrees only roughly with the model.</source>
        <translation>Mätningen stämmer bara ungefär med modellen.</translation>
    </message>
    <message>
        <source>The record agrees with a rock that yields at one force: its loading curve has one corner.</source>
        <translation>Mätningen stämmer med ett berg som ger efter vid en viss kraft: dess belastningskurva har ett hörn.</translation>
    </message>
    <message>
        <source>The record agrees with a rock whose force rises along one straight line while the bit penetrates.</source>
        <translation>Mätningen stämmer med ett berg vars kraft stiger längs en enda rät linje när kronan tränger in.</translation>
    </message>
    <message>
        <source>The record determines stiffness and elasticity (gamma) of the rock, and the gap between bit and rock.</source>
        <translation>Mätningen bestämmer bergets styvhet och elasticitet (gamma) och spalten mellan borrkrona och berg.</translation>
    </message>
    <message>
        <source>Stiffness and elasticity (gamma) of the rock are known, but the gap between bit and rock is not.</source>
        <translation>Bergets styvhet och elasticitet (gamma) är kända, men inte spalten mellan borrkrona och berg.</translation>
    </message>
    <message>
        <source>The stiffness of the rock is known, but its elasticity (gamma) is not.</source>
        <translation>Bergets styvhet är känd, men inte dess elasticitet (gamma).</translation>
    </message>
    <message>
        <source>The elasticity (gamma) of the rock is known, but its stiffness is not.</source>
        <translation>Bergets elasticitet (gamma) är känd, men inte dess styvhet.</translation>
    </message>
    <message>
        <source>Neither stiffness nor elasticity (gamma) of the rock is known to within 20 %.</source>
        <translation>Varken bergets styvhet eller dess elasticitet (gamma) är känd på 20&#xa0;% när.</translation>
    </message>
    <message>
        <source>waves of %1 of the peak are not explained by the model; they widen all intervals</source>
        <translation>vågor på %1 av toppen förklaras inte av modellen; de vidgar alla intervall</translation>
    </message>
    <message>
        <source>waves of %1 of the peak are not explained by the model</source>
        <translation>vågor på %1 av toppen förklaras inte av modellen</translation>
    </message>
    <message>
        <source>waves of %1 of the peak are there before the front; measure a single blow</source>
        <translation>det finns vågor på %1 av toppen före vågfronten; mät ett enstaka slag</translation>
    </message>
    <message>
        <source>the reflection arrives after %1 instead of %2; check distance, wave speed and clock, and look for a section missing in the file</source>
        <translation>reflexionen kommer efter %1 i stället för %2; kontrollera avstånd, våghastighet och klocka, och om en sektion saknas i filen</translation>
    </message>
    <message>
        <source>%1 changed by %2 would explain the record; measure it</source>
        <translation>%1, ändrat med %2, skulle förklara mätningen; mät det</translation>
    </message>
    <message>
        <source>%1 changed by %2, or another distance between the gauges, would explain the record; measure both</source>
        <translation>%1, ändrat med %2, eller ett annat avstånd mellan givarna skulle förklara mätningen; mät båda</translation>
    </message>
    <message>
        <source>a jump of the zero level %1 after the front would explain the record; check cable and amplifier</source>
        <translation>ett hopp i nollnivån %1 efter vågfronten skulle förklara mätningen; kontrollera kabel och förstärkare</translation>
    </message>
    <message>
        <source>the rock begins as steep as it springs back: the bit may stand in the crater of a blow before, or be pressed into it</source>
        <translation>berget börjar lika brant som det fjädrar tillbaka: kronan kan stå i kratern efter ett tidigare slag, eller vara intryckt i den</translation>
    </message>
    <message>
        <source>some tolerances are assumed; give measured ones by --known KEY=+-TOLERANCE</source>
        <translation>några toleranser är antagna; ange uppmätta med --known KEY=+-TOLERANCE</translation>
    </message>
    <message>
        <source>the zero line moves by more than its tolerance</source>
        <translation>nollinjen rör sig mer än sin tolerans</translation>
    </message>
    <message>
        <source>the returning wave is clipped; those samples are left out</source>
        <translation>den återvändande vågen är klippt; dessa mätvärden är utelämnade</translation>
    </message>
    <message>
        <source>the quiet time between the blow and its reflection is short; put the gauge further from the bit</source>
        <translation>den lugna tiden mellan slaget och dess reflexion är kort; sätt givaren längre från kronan</translation>
    </message>
    <message>
        <source>there is no gauge on the opposite side of the rod; one would show bending</source>
        <translation>det finns ingen givare på motstående sida av stången; den skulle visa böjning</translation>
    </message>
    <message>
        <source>dispersion between gauge and bit is taken into account</source>
        <translation>dispersionen mellan givare och krona är medräknad</translation>
    </message>
    <message>
        <source>other laws were tried because the bilinear law leaves more than noise</source>
        <translation>andra lagar prövades, eftersom den bilinjära lagen lämnar kvar mer än brus</translation>
    </message>
    <message>
        <source>another law explains the record as well; the intervals include it</source>
        <translation>en annan lag förklarar mätningen lika bra; intervallen omfattar den</translation>
    </message>
    <message>
        <source>fewer than five records say little about how the rock changes</source>
        <translation>färre än fem mätningar säger lite om hur berget ändras</translation>
    </message>
    <message>
        <source>the record holds further blows; --blows all identifies each</source>
        <translation>mätningen innehåller fler slag; --blows all identifierar vart och ett</translation>
    </message>
    <message>
        <source>the second gauge has the other sign; it is reversed</source>
        <translation>den andra givaren har omvänt tecken; den vänds</translation>
    </message>
    <message>
        <source>the peak stress is unlikely; check the unit of the record</source>
        <translation>toppspänningen är osannolik; kontrollera mätningens enhet</translation>
    </message>
    <message>
        <source>a rock that stiffens from the start explains the record as well as a gap</source>
        <translation>ett berg som styvnar från början förklarar mätningen lika bra som en spalt</translation>
    </message>
    <message>
        <source>a section differs from the file by more than its tolerance</source>
        <translation>en sektion avviker från filen med mer än sin tolerans</translation>
    </message>
    <message>
        <source>the zero level jumps within the record</source>
        <translation>nollnivån hoppar inom mätningen</translation>
    </message>
    <message>
        <source>the columns of the two gauges have different numbers of samples</source>
        <translation>de två givarnas kolumner har olika antal mätvärden</translation>
    </message>
    <message>
        <source>%1: the opposite gauges have opposite signs; reverse one of them</source>
        <translation>%1: de motstående givarna har motsatta tecken; vänd en av dem</translation>
    </message>
    <message>
        <source>a gauge is not on a uniform section of rod or string</source>
        <translation>en givare sitter inte på en likformig sektion av stången eller strängen</translation>
    </message>
    <message>
        <source>--known %1: the tolerance must be smaller than the value</source>
        <translation>--known %1: toleransen måste vara mindre än värdet</translation>
    </message>
    <message>
        <source>--known %1: is no size of the gauge&apos;s section or of a section between gauge and rock; give gain, zero, gauge, or such a key</source>
        <translation>--known %1: är inget mått på givarens sektion eller på en sektion mellan givare och berg; ange gain, zero, gauge eller en sådan nyckel</translation>
    </message>
    <message>
        <source>the record has %1 samples; at least 50 are needed before the front</source>
        <translation>mätningen har %1 mätvärden; minst 50 behövs före vågfronten</translation>
    </message>
    <message>
        <source>there is no such blow in the record</source>
        <translation>det finns inget sådant slag i mätningen</translation>
    </message>
    <message>
        <source>no front is seen in the record; check the gauge, its column and the trigger</source>
        <translation>ingen vågfront syns i mätningen; kontrollera givaren, dess kolumn och triggern</translation>
    </message>
    <message>
        <source>only %1 samples stand before the front at %2; record at least 50 before it (trigger with more pre-trigger time)</source>
        <translation>bara %1 mätvärden står före vågfronten vid %2; mät minst 50 före den (trigga med längre förtid)</translation>
    </message>
    <message>
        <source>one of the gauges sees no front; check its column and its cable</source>
        <translation>en av givarna ser ingen vågfront; kontrollera dess kolumn och kabel</translation>
    </message>
    <message>
        <source>the front reaches the gauge near the bit first: are the columns of the two gauges exchanged? Exchange them in --gauge</source>
        <translation>vågfronten når givaren nära kronan först: är de två givarnas kolumner förväxlade? Byt plats på dem i --gauge</translation>
    </message>
    <message>
        <source>the blow is not over when its reflection arrives after %1; a second gauge further from the bit is needed, or a gauge further away</source>
        <translation>slaget är inte över när dess reflexion kommer efter %1; det behövs en andra givare längre från kronan, eller en givare längre bort</translation>
    </message>
    <message>
        <source>samples are missing from %1 to %2; record without a pause</source>
        <translation>mätvärden saknas från %1 till %2; mät utan uppehåll</translation>
    </message>
    <message>
        <source>the incident wave is clipped over %1; choose a larger range of the amplifier or of the recorder</source>
        <translation>den infallande vågen är klippt under %1; välj ett större område på förstärkaren eller mätinstrumentet</translation>
    </message>
    <message>
        <source>--check needs --backing bar</source>
        <translation>--check kräver --backing bar</translation>
    </message>
    <message>
        <source>--check takes one column</source>
        <translation>--check tar en kolumn</translation>
    </message>
    <message>
        <source>--with drill: %1 blows take about %2, more than a report may; set fewer blows (drill.blows), or use `drillwave drill --work-limit`</source>
        <translation>--with drill: %1 slag tar ungefär %2, längre än en rapport får; ange färre slag (drill.blows) eller använd `drillwave drill --work-limit`</translation>
    </message>
    <message>
        <source>--with design needs a block `design` with its list `uncertain`; see `drillwave help files`</source>
        <translation>--with design behöver ett block `design` med sin lista `uncertain`; se `drillwave help files`</translation>
    </message>
    <message>
        <source>--with %1: `%2` is not a study of reports; choose from %3</source>
        <translation>--with %1: `%2` är ingen studie för rapporter; välj bland %3</translation>
    </message>
    <message>
        <source>nothing, only the present design</source>
        <translation>inget, bara den nuvarande konstruktionen</translation>
    </message>
    <message>
        <source>Design variables: %1. All blows have the energy of the present one.</source>
        <translation>Val: %1. Alla slag har samma energi som det nuvarande.</translation>
    </message>
    <message>
        <source>%1 instead of %2: %3 %4, with the values entered %5.</source>
        <translation>%1 i stället för %2: %3 %4, med de inmatade värdena %5.</translation>
    </message>
    <message>
        <source>equally good</source>
        <translation>lika bra</translation>
    </message>
    <message>
        <source>present design</source>
        <translation>nuvarande</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>tid t</translation>
    </message>
    <message>
        <source>force, compression +</source>
        <translation>kraft, tryck +</translation>
    </message>
    <message>
        <source>returning wave, measured</source>
        <translation>återvändande våg, uppmätt</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modell</translation>
    </message>
    <message>
        <source>incident wave</source>
        <translation>infallande våg</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>uppmätt</translation>
    </message>
    <message>
        <source>incident</source>
        <translation>infallande</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>lugnt</translation>
    </message>
    <message>
        <source>returning</source>
        <translation>återvändande</translation>
    </message>
    <message>
        <source>arrival by the distance</source>
        <translation>ankomst enligt avståndet</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>rest</translation>
    </message>
    <message>
        <source>law, 95 %</source>
        <translation>lag, 95 %</translation>
    </message>
    <message>
        <source>penetration U</source>
        <translation>inträngning U</translation>
    </message>
    <message>
        <source>force on the rock F</source>
        <translation>kraft på berget F</translation>
    </message>
    <message>
        <source>measured, only a picture</source>
        <translation>uppmätt, bara en bild</translation>
    </message>
    <message>
        <source>+2 σ of the noise</source>
        <translation>+2 σ av bruset</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inte känt</translation>
    </message>
    <message>
        <source>law of the rock</source>
        <translation>bergets lag</translation>
    </message>
    <message>
        <source>check</source>
        <translation>kontroll</translation>
    </message>
    <message>
        <source>The first %1 of %2 blows are not counted. The rate is an upper limit: all rock under the bit breaks and cuttings are removed.</source>
        <translation>De första %1 av %2 slag räknas inte. Borrsjunkningen är en övre gräns: allt berg under borrkronan ger efter och borrkaxet försvinner.</translation>
    </message>
    <message>
        <source>Design study</source>
        <translation>Konstruktionsstudie</translation>
    </message>
    <message>
        <source>Continuous drilling</source>
        <translation>Kontinuerlig borrning</translation>
    </message>
    <message>
        <source>%1: has another number of samples than the gauges</source>
        <translation>%1: har ett annat antal mätvärden än givarna</translation>
    </message>
    <message>
        <source>%1: the table does not state this: %2. Open the record again and choose it.</source>
        <translation>%1: tabellen anger inte detta: %2. Öppna inspelningen igen och välj det.</translation>
    </message>
    <message>
        <source>For 90 % of the scattered gaps, e is between %1 and %2; its mean is %3.</source>
        <translation>För 90&#xa0;% av de spridda spalterna ligger e mellan %1 och %2; medelvärdet är %3.</translation>
    </message>
    <message>
        <source>For 90 % of all gaps, e is between %1 and %2; its mean is %3.</source>
        <translation>För 90&#xa0;% av alla spalter ligger e mellan %1 och %2; medelvärdet är %3.</translation>
    </message>
    <message>
        <source>not seen: the force stays below a corner</source>
        <translation>inte sett: kraften stannar under ett knä</translation>
    </message>
    <message>
        <source>column %1 is given twice; every gauge has a column of its own</source>
        <translation>kolumn %1 anges två gånger; varje givare har en egen kolumn</translation>
    </message>
    <message>
        <source>the record ends before the reflection arrives, %1 after the front; record longer</source>
        <translation>inspelningen slutar innan reflexen kommer %1 efter fronten; spela in längre</translation>
    </message>
    <message>
        <source>only %1 samples show the reflection, in a window of %2; at least 50 are needed: record faster or longer, or put the gauge further from the end behind it</source>
        <translation>bara %1 sampel visar reflexen, i ett fönster på %2; minst 50 behövs: spela in snabbare eller längre, eller sätt givaren längre från änden bakom den</translation>
    </message>
    <message>
        <source>--record is for one or two gauges</source>
        <translation>--record gäller en eller två givare</translation>
    </message>
    <message>
        <source>--%1 needs --record COLUMN@DISTANCE</source>
        <translation>--%1 kräver --record COLUMN@DISTANCE</translation>
    </message>
    <message>
        <source>must be a percentage from 0 to 100 %, such as 1%</source>
        <translation>måste vara en procentsats från 0 till 100 %, till exempel 1%</translation>
    </message>
    <message>
        <source>is given by its dimensionless groups; --record needs physical units</source>
        <translation>anges med sina dimensionslösa tal; --record kräver fysikaliska enheter</translation>
    </message>
    <message>
        <source>--record %1: is not on a uniform section of the rod or string</source>
        <translation>--record %1: ligger inte på en likformig sektion av stången eller strängen</translation>
    </message>
    <message>
        <source>lowest %1 = %2 at %3 = %4; highest %1 = %5 at %3 = %6</source>
        <translation>lägsta %1 = %2 vid %3 = %4; högsta %1 = %5 vid %3 = %6</translation>
    </message>
    <message>
        <source>next blow, 95 %</source>
        <translation>nästa slag, 95 %</translation>
    </message>
    <message>
        <source>record, 95 %</source>
        <translation>inspelning, 95 %</translation>
    </message>
    <message>
        <source>record on show</source>
        <translation>visad inspelning</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>avvisad: %1</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>stämmer</translation>
    </message>
    <message>
        <source>agrees roughly</source>
        <translation>stämmer ungefär</translation>
    </message>
    <message>
        <source>does not agree</source>
        <translation>stämmer inte</translation>
    </message>
    <message>
        <source>A feed force of at least %1 would even return an undamped rod to the rock before each next blow.</source>
        <translation>En matningskraft på minst %1 skulle till och med föra en odämpad stång tillbaka till berget före varje nästa slag.</translation>
    </message>
    <message>
        <source>No larger feed force is required.</source>
        <translation>Ingen större matningskraft krävs.</translation>
    </message>
    <message>
        <source>another solution, as good</source>
        <translation>en annan lösning, lika bra</translation>
    </message>
    <message>
        <source>--goal takes the value alone: --outputs cor --goal 1</source>
        <translation>--goal tar bara värdet: --outputs cor --goal 1</translation>
    </message>
    <message>
        <source>The bit chatters on the rock (%1 contacts). Tiny changes of the input then change the coefficient of restitution e, which can be known only to within %2. A longer rod, a shorter blow or a softer rock reduces the chatter.</source>
        <translation>Borrkronan skallrar mot berget (%1 kontakter). Mycket små ändringar av indata ändrar då studstalet e, som bara kan vara känt på %2 när. En längre stång, ett kortare slag eller mjukare berg minskar skallret.</translation>
    </message>
    <message>
        <source>Either the rock follows another law, or the scenario file is wrong about a section between gauge and bit or the distance between the gauges. Check the bit head and this distance first, then see where the measured and the modelled wave differ.</source>
        <translation>Antingen följer berget en annan lag, eller så är en sektion mellan givare och borrkrona eller avståndet mellan givarna fel i scenariofilen. Kontrollera först kronhuvudet och detta avstånd, och se sedan var uppmätt och beräknad våg skiljer sig åt.</translation>
    </message>
    <message>
        <source>Either the rock follows another law, or the sections between gauge and bit differ from the scenario file. Check the bit head first, then see where the measured and the modelled wave differ.</source>
        <translation>Antingen följer berget en annan lag, eller så avviker sektionerna mellan givare och borrkrona från scenariofilen. Kontrollera först kronhuvudet, och se sedan var uppmätt och beräknad våg skiljer sig åt.</translation>
    </message>
    <message>
        <source>The scan cannot decide which value is best: the penetrations have errors of +- %1, because %2.</source>
        <translation>Svepet kan inte avgöra vilket värde som är bäst: inträngningarna har fel på +- %1, eftersom %2.</translation>
    </message>
    <message>
        <source>gain within the record</source>
        <translation>förstärkning inom mätningen</translation>
    </message>
    <message>
        <source>To know more: use a larger range of the amplifier, and check glue and cable of the gauge: %1.</source>
        <translation>För att veta mer: använd ett större mätområde, och kontrollera givarens lim och kabel: %1.</translation>
    </message>
    <message>
        <source>the returning wave fits better with %1 less gain than the incident wave; check range, glue and cable of the gauge</source>
        <translation>den återvändande vågen passar bättre med %1 lägre förstärkning än den infallande; kontrollera mätområde, lim och kabel för givaren</translation>
    </message>
    <message>
        <source>the returning wave fits better with %1 more gain than the incident wave; check range, glue and cable of the gauge</source>
        <translation>den återvändande vågen passar bättre med %1 högre förstärkning än den infallande; kontrollera mätområde, lim och kabel för givaren</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>sluten form</translation>
    </message>
    <message>
        <source>lattice, moved waves, %1</source>
        <translation>gitter, flyttade vågor, %1</translation>
    </message>
    <message>
        <source>lattice, ring buffer, %1</source>
        <translation>gitter, ringbuffert, %1</translation>
    </message>
    <message>
        <source>%1, the paper&apos;s choice</source>
        <translation>%1, artikelns val</translation>
    </message>
    <message>
        <source>The exact solution has nothing to compare with: %1</source>
        <translation>Den exakta lösningen har ingen annan att jämföras med: %1</translation>
    </message>
    <message>
        <source>e is right to %1 in %2</source>
        <translation>e är rätt på %1 när, på %2</translation>
    </message>
    <message>
        <source>the paper&apos;s %1 segments give %2 in %3</source>
        <translation>artikelns %1 segment ger %2 på %3</translation>
    </message>
    <message>
        <source>processor time of a solve for e [s]</source>
        <translation>processortid för en lösning av e [s]</translation>
    </message>
    <message>
        <source>error of e</source>
        <translation>fel i e</translation>
    </message>
    <message>
        <source>lattice, moved waves</source>
        <translation>gitter, flyttade vågor</translation>
    </message>
    <message>
        <source>lattice, ring buffer</source>
        <translation>gitter, ringbuffert</translation>
    </message>
    <message>
        <source>polynomial cells (studies)</source>
        <translation>polynomceller (studier)</translation>
    </message>
    <message>
        <source>cut cells (a blow)</source>
        <translation>delade celler (ett slag)</translation>
    </message>
    <message>
        <source>plain lattice</source>
        <translation>enkelt gitter</translation>
    </message>
    <message>
        <source>efficiency right to %1 in %2</source>
        <translation>verkningsgraden rätt på %1 när, på %2</translation>
    </message>
    <message>
        <source>in studies to %1 in %2</source>
        <translation>i studier på %1 när, på %2</translation>
    </message>
    <message>
        <source>plain lattice %1 in %2</source>
        <translation>enkelt gitter %1 på %2</translation>
    </message>
    <message>
        <source>processor time of a solve [s]</source>
        <translation>processortid för en lösning [s]</translation>
    </message>
    <message>
        <source>error of the efficiency</source>
        <translation>fel i verkningsgraden</translation>
    </message>
    <message>
        <source>cells of %1</source>
        <translation>celler på %1</translation>
    </message>
    <message>
        <source>%1 cases, all passed</source>
        <translation>%1 fall, alla godkända</translation>
    </message>
    <message>
        <source>%1 of %2 cases failed</source>
        <translation>%1 av %2 fall underkända</translation>
    </message>
    <message>
        <source>the worst: %1, %2 at %3 of its limit</source>
        <translation>det sämsta: %1, %2 vid %3 av sin gräns</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>rörelsemängd</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>gränsfall</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>drag</translation>
    </message>
    <message>
        <source>return</source>
        <translation>återkomst</translation>
    </message>
    <message>
        <source>stiffness over elasticity β/γ, the stiffest rate [1/t₀]</source>
        <translation>styvhet genom elasticitet β/γ, den styvaste takten [1/t₀]</translation>
    </message>
    <message>
        <source>worst check over its limit</source>
        <translation>sämsta mått genom dess gräns</translation>
    </message>
    <message>
        <source>a case above has failed</source>
        <translation>ett fall ovanför har underkänts</translation>
    </message>
    <message>
        <source>worst check</source>
        <translation>sämsta kontroll</translation>
    </message>
    <message>
        <source>of its limit</source>
        <translation>av gränsen</translation>
    </message>
    <message>
        <source>uniform rod</source>
        <translation>likformig stång</translation>
    </message>
    <message>
        <source>The rod rebounds with e = %1.</source>
        <translation>Stången studsar tillbaka med e = %1.</translation>
    </message>
    <message>
        <source>Stress in the rod</source>
        <translation>Spänning i stången</translation>
    </message>
    <message>
        <source>at the middle of the rod</source>
        <translation>vid stångens mitt</translation>
    </message>
    <message>
        <source>The force N %1 and its waves, the impact force, its impulse and the momentum of the rod over time.</source>
        <translation>Kraften N %1 och dess vågor, stötkraften, dess impuls och stångens rörelsemängd över tiden.</translation>
    </message>
    <message>
        <source>The largest tension and compression along the rod, during the blow and in the residual waves.</source>
        <translation>Största drag och tryck längs stången, medan slaget varar och i restvågorna.</translation>
    </message>
    <message>
        <source>%1 from the struck end</source>
        <translation>%1 från slagänden</translation>
    </message>
    <message>
        <source>%1 from the hammer, %2</source>
        <translation>%1 från hammaren, %2</translation>
    </message>
    <message>
        <source>place x: must be at most %1, the length of the rod</source>
        <translation>läge x: får vara högst %1, stångens längd</translation>
    </message>
    <message>
        <source>drill string</source>
        <translation>borrsträng</translation>
    </message>
    <message>
        <source>Stress in hammer and string</source>
        <translation>Spänning i hammare och sträng</translation>
    </message>
    <message>
        <source>in the middle of the longest section</source>
        <translation>mitt i den längsta sektionen</translation>
    </message>
    <message>
        <source>The force N %1 and its waves, the impact force, its impulse and the momentum of the string over time.</source>
        <translation>Kraften N %1 och dess vågor, stötkraften, dess impuls och strängens rörelsemängd över tiden.</translation>
    </message>
    <message>
        <source>The largest tension and compression along hammer (below 0) and string during the blow, with the strengths of the sections.</source>
        <translation>Största drag och tryck längs hammare (under 0) och sträng medan slaget varar, med sektionernas hållfasthet.</translation>
    </message>
    <message>
        <source>%1 from the struck end, %2</source>
        <translation>%1 från slagänden, %2</translation>
    </message>
    <message>
        <source>place x: must be at most %1, the length of the string</source>
        <translation>läge x: får vara högst %1, strängens längd</translation>
    </message>
    <message>
        <source>feed force</source>
        <translation>matningskraft</translation>
    </message>
    <message>
        <source>Each strip runs from the required feed force to the one that returns the rod in time.</source>
        <translation>Varje band går från matningskraften som krävs till den som för tillbaka stången i tid.</translation>
    </message>
    <message>
        <source>W and E₀ are the work of the force on the string.</source>
        <translation>W och E₀ är kraftens arbete på strängen.</translation>
    </message>
    <message>
        <source>this scenario</source>
        <translation>detta scenario</translation>
    </message>
    <message>
        <source>%1, this scenario</source>
        <translation>%1, detta scenario</translation>
    </message>
    <message>
        <source>rod without waves</source>
        <translation>stång utan vågor</translation>
    </message>
    <message>
        <source>%1, no waves</source>
        <translation>%1, inga vågor</translation>
    </message>
    <message>
        <source>%1, closed form</source>
        <translation>%1, sluten form</translation>
    </message>
    <message>
        <source>%1 everywhere</source>
        <translation>%1 överallt</translation>
    </message>
    <message>
        <source>%1 at %2 places</source>
        <translation>%1 på %2 ställen</translation>
    </message>
    <message>
        <source>%1 at %2, nowhere else in this range</source>
        <translation>%1 vid %2, ingen annanstans i det här området</translation>
    </message>
    <message>
        <source>%1 at %2, perhaps elsewhere too</source>
        <translation>%1 vid %2, kanske även annanstans</translation>
    </message>
    <message>
        <source>%1 reaches it at %2</source>
        <translation>%1 når det vid %2</translation>
    </message>
    <message>
        <source>%1 is above it everywhere</source>
        <translation>%1 ligger överallt över</translation>
    </message>
    <message>
        <source>%1 is below it everywhere</source>
        <translation>%1 ligger överallt under</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 vid %2</translation>
    </message>
    <message>
        <source>%1, the end of the range</source>
        <translation>%1, i slutet av området</translation>
    </message>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1 går från %2 till %3</translation>
    </message>
    <message>
        <source>the largest %1 is %2</source>
        <translation>största värde %1: %2</translation>
    </message>
    <message>
        <source>the smallest %1 is %2</source>
        <translation>minsta värde %1: %2</translation>
    </message>
    <message>
        <source>e = 1 at %1 places</source>
        <translation>e = 1 på %1 ställen</translation>
    </message>
    <message>
        <source>e = 1 at %1</source>
        <translation>e = 1 vid %1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>mål</translation>
    </message>
    <message>
        <source>There is no answer anywhere in this range.</source>
        <translation>Det finns inget svar någonstans i detta område.</translation>
    </message>
    <message>
        <source>the curve has %1 points</source>
        <translation>kurvan har %1 punkter</translation>
    </message>
    <message>
        <source>only points are known in a part of the range</source>
        <translation>i en del av området är bara enstaka punkter kända</translation>
    </message>
    <message>
        <source>there is no answer in a part of the range: %1</source>
        <translation>i en del av området finns inget svar: %1</translation>
    </message>
    <message>
        <source>%1 would yield: the stress in this section reaches %2, at %3 from its rear end and %4 after the start of the blow. Its yield strength is %5.</source>
        <translation>%1 skulle flyta: spänningen i denna sektion når %2, %3 från dess bakände och %4 efter slagets början. Dess sträckgräns är %5.</translation>
    </message>
    <message>
        <source>The rod would yield: during the blow the stress reaches %1, at %2 from the hammer and %3 after the start of the blow. Its yield strength is %4.</source>
        <translation>Stången skulle flyta: under slaget når spänningen %1, %2 från hammaren och %3 efter slagets början. Dess sträckgräns är %4.</translation>
    </message>
    <message>
        <source>After the blow, residual waves would make the rod yield; the waves are not damped here. The stress reaches %1, at %2 from the hammer and %3 after the start of the blow. The yield strength is %4.</source>
        <translation>Efter slaget skulle restvågorna få stången att flyta; vågorna dämpas inte här. Spänningen når %1, %2 från hammaren och %3 efter slagets början. Sträckgränsen är %4.</translation>
    </message>
    <message>
        <source>Every blow loads %1 above its fatigue strength of %5. The stress reaches %2, at %3 from the rear end of this section and %4 after the start of the blow.</source>
        <translation>Varje slag belastar %1 över utmattningsgränsen på %5. Spänningen når %2, %3 från sektionens bakre ände och %4 efter slagets början.</translation>
    </message>
    <message>
        <source>Every blow loads the rod above its fatigue strength of %4. During the blow, the stress reaches %1, at %2 from the hammer and %3 after the start of the blow.</source>
        <translation>Varje slag belastar stången över dess utmattningsgräns på %4. Under slaget når spänningen %1, %2 från hammaren och %3 efter slagets början.</translation>
    </message>
    <message>
        <source>Every blow loads the rod above its fatigue strength of %4, by residual waves that are not damped here. The stress reaches %1, at %2 from the hammer and %3 after the start of the blow.</source>
        <translation>Varje slag belastar stången över dess utmattningsgräns på %4, genom restvågor som inte dämpas här. Spänningen når %1, %2 från hammaren och %3 efter slagets början.</translation>
    </message>
    <message>
        <source>%1 in compression</source>
        <translation>%1 tryck</translation>
    </message>
    <message>
        <source>%1 in tension</source>
        <translation>%1 drag</translation>
    </message>
    <message>
        <source>The choice of the design makes no difference: the objective %1 is %2, within %3, for all %4 designs.</source>
        <translation>Valet av konstruktion gör ingen skillnad: målstorheten %1 är %2, inom %3, för alla %4 konstruktioner.</translation>
    </message>
    <message>
        <source>The choice of %1 makes no difference: the objective %2 is %3, within %4, for all %5 designs.</source>
        <translation>Valet av %1 gör ingen skillnad: målstorheten %2 är %3, inom %4, för alla %5 konstruktioner.</translation>
    </message>
    <message>
        <source>The choice of %1 makes no difference to the objectives and limits.</source>
        <translation>Valet av %1 gör ingen skillnad för målstorheter och gränser.</translation>
    </message>
    <message>
        <source>Number of other warnings for this design: %1.</source>
        <translation>Antal ytterligare varningar för denna konstruktion: %1.</translation>
    </message>
    <message>
        <source>The highest penetration rate of the scan, %1, is reached with %2.</source>
        <translation>Den högsta borrsjunkningen i det undersökta området, %1, nås med %2.</translation>
    </message>
    <message>
        <source>blow</source>
        <translation>slag</translation>
    </message>
    <message>
        <source>gap modulo d₀, in d₀</source>
        <translation>spalt modulo d₀, i d₀</translation>
    </message>
    <message>
        <source>e at this gap</source>
        <translation>e för denna spalt</translation>
    </message>
    <message>
        <source>next gap</source>
        <translation>nästa spalt</translation>
    </message>
    <message>
        <source>remaining energy %1</source>
        <translation>kvarvarande energi %1</translation>
    </message>
    <message>
        <source>new rock faces %1</source>
        <translation>nya bergytor %1</translation>
    </message>
    <message>
        <source>lost waves %1</source>
        <translation>vågor, förlorat %1</translation>
    </message>
    <message>
        <source>damper %1</source>
        <translation>dämpare %1</translation>
    </message>
    <message>
        <source>rock %1</source>
        <translation>berg %1</translation>
    </message>
    <message>
        <source>share of the energy</source>
        <translation>energiandel</translation>
    </message>
    <message>
        <source>rod bouncing at the start</source>
        <translation>stången studsar från början</translation>
    </message>
    <message>
        <source>blows in contact</source>
        <translation>slag i kontakt</translation>
    </message>
    <message>
        <source>constant force</source>
        <translation>konstant kraft</translation>
    </message>
    <message>
        <source>dashpot of half the impedance</source>
        <translation>dämpare på halva impedansen</translation>
    </message>
    <message>
        <source>strip: 95 % confidence interval of the penetration rate</source>
        <translation>band: 95 % konfidensintervall för borrsjunkningen</translation>
    </message>
    <message>
        <source>mean: over the shaded blows</source>
        <translation>medelvärde: över de skuggade slagen</translation>
    </message>
    <message>
        <source>gap and next gap: a projection from more dimensions</source>
        <translation>spalt och nästa spalt: en projektion av fler dimensioner</translation>
    </message>
    <message>
        <source>Gap and penetration of %1 of %2 blows; the first %3 are transient and excluded.</source>
        <translation>Spalt och inträngning för %1 av %2 slag; de första %3 svänger in och räknas inte.</translation>
    </message>
    <message>
        <source>Penetration rate, contact share and gaps over %1.</source>
        <translation>Borrsjunkning, kontaktandel och spalter över %1.</translation>
    </message>
    <message>
        <source>scan of an earlier scenario: scan again</source>
        <translation>svep för ett tidigare scenario: svep igen</translation>
    </message>
    <message>
        <source>5 % to 95 %</source>
        <translation>5 % till 95 %</translation>
    </message>
    <message>
        <source>with the values entered</source>
        <translation>med de angivna värdena</translation>
    </message>
    <message>
        <source>share of the scatter
(filled: without interactions)</source>
        <translation>andel av spridningen
(fylld: utan samverkan)</translation>
    </message>
    <message>
        <source>%1: no scatter</source>
        <translation>%1: sprider inte</translation>
    </message>
    <message>
        <source>%1 of %2 designs, best for uncertain rock %3</source>
        <translation>%1 av %2 konstruktioner, bäst för ofullständigt känt berg %3</translation>
    </message>
    <message>
        <source>on average</source>
        <translation>i medeltal</translation>
    </message>
    <message>
        <source>in the smallest sample</source>
        <translation>för det minsta stickprovet</translation>
    </message>
    <message>
        <source>in the largest sample</source>
        <translation>för det största stickprovet</translation>
    </message>
    <message>
        <source>for the values entered</source>
        <translation>för de angivna värdena</translation>
    </message>
    <message>
        <source>in the middle (median)</source>
        <translation>i mitten (median)</translation>
    </message>
    <message>
        <source>reached in %1 % of cases</source>
        <translation>som uppnås i %1&#xa0;% av fallen</translation>
    </message>
    <message>
        <source>not exceeded in %1 % of cases</source>
        <translation>som inte överskrids i %1&#xa0;% av fallen</translation>
    </message>
    <message>
        <source>at %1 ≈ %2</source>
        <translation>vid %1 ≈ %2</translation>
    </message>
    <message>
        <source>No point could be solved.</source>
        <translation>Ingen punkt kunde lösas.</translation>
    </message>
    <message>
        <source>The map follows.</source>
        <translation>Kartan följer.</translation>
    </message>
    <message>
        <source>%1 is not reached</source>
        <translation>%1 nås inte</translation>
    </message>
    <message>
        <source>%1 of %2 points not solved (hatched)</source>
        <translation>%1 av %2 punkter inte lösta (skrafferade)</translation>
    </message>
    <message>
        <source>%1 exceeds %2 only where %3 is above %5. At %4 = %6, %3 = %5 is enough.</source>
        <translation>%1 överstiger %2 bara där %3 är över %5. Vid %4 = %6 räcker %3 = %5.</translation>
    </message>
    <message>
        <source>%1 exceeds %2 only where %3 is below %5. At %4 = %6, %3 = %5 is low enough.</source>
        <translation>%1 överstiger %2 bara där %3 är under %5. Vid %4 = %6 är %3 = %5 lågt nog.</translation>
    </message>
    <message>
        <source>present design: %1</source>
        <translation>nuvarande konstruktion: %1</translation>
    </message>
    <message>
        <source>it takes %1 computing steps, more than the %2 permitted, about %3; fewer blows or --cells take less, --work-limit permits more</source>
        <translation>det krävs %1 beräkningssteg, omkring %3, mer än de %2 som är tillåtna; färre slag eller färre --cells kräver mindre, --work-limit tillåter mer</translation>
    </message>
    <message>
        <source>note: %1 sets %2, which is one section with a repeat; to set only one of them, write the sections out in FILE without the repeat</source>
        <translation>anmärkning: %1 sätter %2, en sektion som upprepas; skriv ut sektionerna utan upprepning i FILE för att sätta bara en av dem</translation>
    </message>
    <message>
        <source>Change %1 from %2 to %3: this improves %4 from %6 to %5.</source>
        <translation>Ändra %1 från %2 till %3: det förbättrar %4 från %6 till %5.</translation>
    </message>
    <message>
        <source>Change the design from %1 to %2: this improves %3 from %5 to %4.</source>
        <translation>Byt konstruktion från %1 till %2: det förbättrar %3 från %5 till %4.</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for a single blow at any gap (%2 required).</source>
        <translation>En matningskraft på %1 räcker för ett enstaka slag, oavsett spalten framför kronan (%2 krävs).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow and for rigid rock (%2 required); other gaps between bit and rock were not examined.</source>
        <translation>En matningskraft på %1 räcker för detta slag och för stelt berg (%2 krävs); andra spalter mellan borrkrona och berg undersöktes inte.</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for a single blow at any gap. It even returns an undamped rod to the rock before the next blow (this requires %2).</source>
        <translation>En matningskraft på %1 räcker för ett enstaka slag, oavsett spalten framför kronan. Den för till och med en odämpad stång tillbaka till berget före nästa slag (det kräver %2).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow and for rigid rock. It even returns an undamped rod to the rock before the next blow (this requires %2). Other gaps between bit and rock were not examined.</source>
        <translation>En matningskraft på %1 räcker för detta slag och för stelt berg. Den för till och med en odämpad stång tillbaka till berget före nästa slag (det kräver %2). Andra spalter mellan borrkrona och berg undersöktes inte.</translation>
    </message>
    <message>
        <source>For this blow, the feed force must be at least %1 at a blow frequency of %2.</source>
        <translation>För detta slag måste matningskraften vara minst %1 vid en slagfrekvens på %2.</translation>
    </message>
    <message>
        <source>For this blow, the feed force must be at least %1 at %2, or the blow frequency at most %3 with the present feed force.</source>
        <translation>För detta slag måste matningskraften vara minst %1 vid %2, eller slagfrekvensen högst %3 vid nuvarande matningskraft.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for this blow, by %2 for every gap between bit and rock.</source>
        <translation>Med %1 mer matningskraft räcker den för detta slag, med %2 mer för varje spalt mellan borrkrona och berg.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for this blow, by %2 for rigid rock.</source>
        <translation>Med %1 mer matningskraft räcker den för detta slag, med %2 mer för stelt berg.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for every gap between bit and rock.</source>
        <translation>Med %1 mer matningskraft räcker den för varje spalt mellan borrkrona och berg.</translation>
    </message>
    <message>
        <source>Raise the feed force by %1 to have enough for rigid rock.</source>
        <translation>Med %1 mer matningskraft räcker den för stelt berg.</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow (%2 required), but not for every gap between bit and rock (up to %3 required).</source>
        <translation>En matningskraft på %1 räcker för detta slag (%2 krävs), men inte för varje spalt mellan borrkrona och berg (upp till %3 krävs).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow (%2 required), but not for rigid rock (%3 required).</source>
        <translation>En matningskraft på %1 räcker för detta slag (%2 krävs), men inte för stelt berg (%3 krävs).</translation>
    </message>
    <message>
        <source>A feed force of %1 is enough for this blow (%2 required), but not for rigid rock (%3 required). Other gaps between bit and rock were not examined.</source>
        <translation>En matningskraft på %1 räcker för detta slag (%2 krävs), men inte för stelt berg (%3 krävs). Andra spalter mellan borrkrona och berg undersöktes inte.</translation>
    </message>
    <message>
        <source>No feed force is given. At a blow frequency of %1, the weight of machine and rod along the hole is already enough for this blow and for rigid rock.</source>
        <translation>Ingen matningskraft är angiven. Vid en slagfrekvens på %1 räcker redan tyngden av maskin och stång längs hålet för detta slag och för stelt berg.</translation>
    </message>
    <message>
        <source>required feed</source>
        <translation>erforderlig matningskraft</translation>
    </message>
    <message>
        <source>enough up to</source>
        <translation>räcker till</translation>
    </message>
    <message>
        <source>Up to this blow frequency the effective feed force is at least the required one</source>
        <translation>Upp till denna slagfrekvens räcker den verksamma matningskraften</translation>
    </message>
    <message>
        <source>The force for every gap is that for fully elastic rock. In this rock, the feed force is enough for %1 of all gaps.</source>
        <translation>Kraften för varje spalt är den för helt elastiskt berg. I detta berg räcker matningskraften för %1 av alla spalter.</translation>
    </message>
    <message>
        <source>is not a rock; give the preset of a rock</source>
        <translation>är inget berg; ange ett förval för berg</translation>
    </message>
    <message>
        <source>a design does not choose its rock; vary the rock with --uncertain, such as bit_rock.stiffness=50MN/m:250MN/m</source>
        <translation>en konstruktion väljer inte sitt berg; variera berget med --uncertain, till exempel bit_rock.stiffness=50MN/m:250MN/m</translation>
    </message>
    <message>
        <source>its waves are kept in %1 cells, more than the %2 permitted; a longer blow, a shorter string or fewer --cells need less</source>
        <translation>dess vågor lagras i %1 celler, mer än de %2 som är tillåtna; ett längre slag, en kortare sträng eller färre --cells kräver mindre</translation>
    </message>
    <message>
        <source>the waves of its blows at all gaps have more polynomial pieces than a quick study permits</source>
        <translation>vågorna i dess slag vid alla spalter har fler polynombitar än en snabb studie tillåter</translation>
    </message>
    <message>
        <source>`%1` names presets, not a parameter; `sweep --vary %1=all` compares them</source>
        <translation>`%1` anger förval, ingen parameter; `sweep --vary %1=all` jämför dem</translation>
    </message>
    <message>
        <source>its histories have more than 4 million polynomial pieces, because of very many reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer</source>
        <translation>dess förlopp har mer än 4 miljoner polynombitar, på grund av mycket många reflexioner; ett styvare berg, ett större gamma eller ett kortare slag kräver färre</translation>
    </message>
    <message>
        <source>its histories have more than 4 million polynomial pieces: the rock is so soft that the waves pass the rod millions of times in one contact; a stiffer rock needs fewer</source>
        <translation>dess förlopp har mer än 4 miljoner polynombitar: berget är så mjukt att vågorna passerar stången miljontals gånger i en kontakt; ett styvare berg kräver färre</translation>
    </message>
    <message>
        <source>its waves have more polynomial pieces than the work limit permits, because of very many reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer</source>
        <translation>dess vågor har fler polynombitar än arbetsgränsen tillåter, på grund av mycket många reflexioner; ett styvare berg, ett större gamma eller ett kortare slag kräver färre</translation>
    </message>
    <message>
        <source>it takes more computing steps than the work limit permits: try fewer sections, lengths with a common divisor or a shorter end_time</source>
        <translation>det tar fler beräkningssteg än arbetsgränsen tillåter: färre sektioner, längder med en gemensam delare eller ett tidigare end_time kräver färre</translation>
    </message>
    <message>
        <source>its sequence of blows takes more computing steps than the work limit permits</source>
        <translation>dess slagföljd tar fler beräkningssteg än arbetsgränsen tillåter</translation>
    </message>
    <message>
        <source>its blows would take %1 computing steps, more than the work limit of %2, because contact changes very often; a larger gamma, fewer blows or a higher frequency take less</source>
        <translation>dess slag skulle ta %1 beräkningssteg, mer än arbetsgränsen på %2, eftersom kontakten växlar mycket ofta; ett större gamma, färre slag eller en högre frekvens kräver mindre</translation>
    </message>
    <message>
        <source>Enter a goal for %1 to find where it is reached.</source>
        <translation>Ange ett målvärde för %1 för att hitta var det nås.</translation>
    </message>
    <message>
        <source>The largest value of %1 is %2, at %3 = %5 and %4 = %6. The smallest is %9, at %3 = %7 and %4 = %8.</source>
        <translation>Det största värdet på %1 är %2, vid %3 = %5 och %4 = %6. Det minsta är %9, vid %3 = %7 och %4 = %8.</translation>
    </message>
    <message>
        <source>%1
(filled dots: no other design is better in both)</source>
        <translation>%1
(fyllda punkter: ingen annan konstruktion är bättre i båda)</translation>
    </message>
    <message>
        <source> (%1 compared with the present value)</source>
        <translation> (%1 jämfört med nuvarande värde)</translation>
    </message>
    <message>
        <source>No single measurement would bring the uncertainty of %1 below 100 %.</source>
        <translation>Ingen enskild mätning skulle få osäkerheten hos %1 under 100 %.</translation>
    </message>
    <message>
        <source>over 100 %</source>
        <translation>över 100 %</translation>
    </message>
    <message>
        <source>%1 has no extremes in this range</source>
        <translation>%1 har inga extremvärden i detta område</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>best, by less than the error</source>
        <translation>bäst, men skillnaden är mindre än felet</translation>
    </message>
    <message>
        <source>known to within %1</source>
        <translation>känt inom %1</translation>
    </message>
    <message>
        <source>uncertain by %1</source>
        <translation>osäkert med %1</translation>
    </message>
    <message>
        <source>not known: uncertain by more than a factor of 10</source>
        <translation>inte känt: osäkert med mer än en faktor 10</translation>
    </message>
    <message>
        <source>%1 +-%2 instead of +-%3</source>
        <translation>%1 +-%2 i stället för +-%3</translation>
    </message>
    <message>
        <source>To know more: record until the rock has unloaded, up to 1 ms after the reflection arrives.</source>
        <translation>För att veta mer: mät tills berget har avlastats, upp till 1 ms efter att reflexionen kommer.</translation>
    </message>
    <message>
        <source>To know more: measure the distance between the gauges to %1: %2.</source>
        <translation>För att veta mer: mät avståndet mellan givarna på %1 när: %2.</translation>
    </message>
    <message>
        <source>beyond noise, the model leaves an rms of %1 of the peak; the noise is %2</source>
        <translation>utöver bruset lämnar modellen kvar ett effektivvärde på %1 av toppen; bruset är %2</translation>
    </message>
    <message>
        <source>the wave behind the specimen is predicted with an rms error of %1 of its peak; it was measured %2 earlier</source>
        <translation>vågen bakom provet förutsägs med ett fel (effektivvärde) på %1 av sin topp; den mättes %2 tidigare</translation>
    </message>
    <message>
        <source>the wave behind the specimen is predicted with an rms error of %1 of its peak; it was measured %2 later</source>
        <translation>vågen bakom provet förutsägs med ett fel (effektivvärde) på %1 av sin topp; den mättes %2 senare</translation>
    </message>
    <message>
        <source>a factor of %1 lowers this error to %2: the gain of that gauge or the bar there may differ</source>
        <translation>faktorn %1 sänker felet till %2: den givarens förstärkning eller stången där kan vara en annan</translation>
    </message>
    <message>
        <source>The position of the gauge or the wave speed in the scenario file does not match the record.</source>
        <translation>Givarens läge eller våghastigheten i scenariofilen stämmer inte med mätningen.</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>en rät linje</translation>
    </message>
    <message>
        <source>one corner</source>
        <translation>ett hörn</translation>
    </message>
    <message>
        <source>crater of a blow before</source>
        <translation>krater från ett tidigare slag</translation>
    </message>
    <message>
        <source>power law</source>
        <translation>potenslag</translation>
    </message>
    <message>
        <source>dashpot</source>
        <translation>dämpare</translation>
    </message>
    <message>
        <source>overload of the amplifier</source>
        <translation>överstyrd förstärkare</translation>
    </message>
    <message>
        <source>jump of the zero level</source>
        <translation>hopp i nollnivån</translation>
    </message>
    <message>
        <source>that of the scenario</source>
        <translation>scenariots</translation>
    </message>
    <message>
        <source>the reflection arrives after %1, the file says %2; a gauge %3 from the bit would fit: measure its distance</source>
        <translation>reflexionen kommer efter %1, filen säger %2; en givare %3 från kronan skulle passa: mät avståndet</translation>
    </message>
    <message>
        <source>feeds: f I₀ mean blow force, f I₀(1+e) required, f I₀(1+2e) returns an undamped rod before the next blow</source>
        <translation>matningskrafter: f I₀ slagens medelkraft, f I₀(1+e) krävs, f I₀(1+2e) för tillbaka en odämpad stång före nästa slag</translation>
    </message>
    <message>
        <source>fully elastic rock (gamma = 1), worst gap</source>
        <translation>helt elastiskt berg (gamma = 1), ogynnsammaste spalt</translation>
    </message>
    <message>
        <source>misfit</source>
        <translation>avvikelse</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>omdöme</translation>
    </message>
    <message>
        <source>The model agrees with %1 of %2 records.</source>
        <translation>Modellen stämmer med %1 av %2 mätningar.</translation>
    </message>
    <message>
        <source>The stiffness of the rock changes from blow to blow: at the next blow, it will be between %1 and %2 (95 %).</source>
        <translation>Bergets styvhet ändras från slag till slag: vid nästa slag ligger den mellan %1 och %2 (95 %).</translation>
    </message>
    <message>
        <source>No change of the rock&apos;s stiffness is seen from blow to blow: at the next blow, it will be between %1 and %2 (95 %).</source>
        <translation>Ingen ändring av bergets styvhet syns från slag till slag: vid nästa slag ligger den mellan %1 och %2 (95 %).</translation>
    </message>
    <message>
        <source>largest force of the table</source>
        <translation>tabellens största kraft</translation>
    </message>
    <message>
        <source>Feed force over %1, for %2. Each strip runs from the required feed force to the one that returns the rod in time. The shades behind the strips show what a feed force does for the rebound of this blow.</source>
        <translation>Matningskraft över %1, för %2. Varje band går från matningskraften som krävs till den som för tillbaka stången i tid. Tonerna bakom banden visar vad en matningskraft gör vid detta slags studs.</translation>
    </message>
    <message>
        <source>These values give the same penetration rate within the errors of the computation: %1.</source>
        <translation>Dessa värden ger samma borrsjunkning inom beräkningens fel: %1.</translation>
    </message>
</context>
<context>
    <name>drillwave::MissingFields</name>
    <message>
        <source>enter the %1:</source>
        <translation>ange %1:</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>inte angiven</translation>
    </message>
</context>
<context>
    <name>drillwave::Notice</name>
    <message>
        <source>Warning</source>
        <translation>Varning</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Anmärkning</translation>
    </message>
    <message>
        <source>Dismiss this note</source>
        <translation>Stäng denna upplysning</translation>
    </message>
</context>
<context>
    <name>drillwave::NumbersWindow</name>
    <message>
        <source>%1 rows, %2 columns</source>
        <translation>%1 rader, %2 kolumner</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiera</translation>
    </message>
</context>
<context>
    <name>drillwave::OptionFields</name>
    <message>
        <source>%1, unit</source>
        <translation>%1, enhet</translation>
    </message>
</context>
<context>
    <name>drillwave::OutputBox</name>
    <message>
        <source>Result</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>Which result is shown</source>
        <translation>Vilket resultat som visas</translation>
    </message>
</context>
<context>
    <name>drillwave::Page</name>
    <message>
        <source>Copy answer</source>
        <translation>Kopiera svaret</translation>
    </message>
    <message>
        <source>Copies answer and sentences below it as text</source>
        <translation>Kopierar svaret och meningarna därunder som text</translation>
    </message>
</context>
<context>
    <name>drillwave::PageTabs</name>
    <message>
        <source>THIS BLOW</source>
        <translation>DETTA SLAG</translation>
    </message>
    <message>
        <source>STUDIES</source>
        <translation>STUDIER</translation>
    </message>
    <message>
        <source>&amp;Next page</source>
        <translation>&amp;Nästa sida</translation>
    </message>
    <message>
        <source>&amp;Previous page</source>
        <translation>&amp;Föregående sida</translation>
    </message>
    <message>
        <source>only for drill strings, and this scenario is a uniform rod: a click converts it, as Edit ▸ Make a drill string of this does</source>
        <translation>bara för borrsträngar, och detta scenario är en likformig stång: ett klick gör en borrsträng av det, som Redigera ▸ Gör en borrsträng av detta</translation>
    </message>
</context>
<context>
    <name>drillwave::ParameterRow</name>
    <message>
        <source>%1, slider</source>
        <translation>%1, skjutreglage</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, enhet</translation>
    </message>
    <message>
        <source>Unit in which the %1 is shown</source>
        <translation>Enhet som %1 visas i</translation>
    </message>
    <message>
        <source>The value is outside the range of the slider.</source>
        <translation>Värdet ligger utanför skjutreglagets område.</translation>
    </message>
    <message>
        <source>Find the value that gives…</source>
        <translation>Sök värdet som ger…</translation>
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
        <translation>Spara bild</translation>
    </message>
    <message>
        <source>PNG – pixels</source>
        <translation>PNG – bildpunkter</translation>
    </message>
    <message>
        <source>SVG – lines and text, for editing</source>
        <translation>SVG – linjer och text, för redigering</translation>
    </message>
    <message>
        <source>PDF – lines and text, for printing</source>
        <translation>PDF – linjer och text, för utskrift</translation>
    </message>
    <message>
        <source>File format; the background is always white</source>
        <translation>Filens slag; alltid på vitt, hur fönstret än ser ut</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Bredd på papper</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>Höjd på papper</translation>
    </message>
    <message>
        <source>Pixels per inch of a PNG; 300 is usual for print</source>
        <translation>Bildpunkter per tum i en PNG; 300 är vanligt för tryck</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Bredd</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höjd</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>&amp;Upplösning</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Välj fil…</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 bildpunkter</translation>
    </message>
    <message>
        <source>Sharp at any size</source>
        <translation>Skarp i alla storlekar</translation>
    </message>
</context>
<context>
    <name>drillwave::PinnedRuns</name>
    <message>
        <source>&amp;Pin this result</source>
        <translation>Fäst &amp;detta resultat</translation>
    </message>
    <message>
        <source>&amp;Keep runs beside the file</source>
        <translation>&amp;Behåll körningar bredvid filen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fäst</translation>
    </message>
    <message>
        <source>Keep this result with its scenario, to compare others with (F7)</source>
        <translation>Behåll detta resultat med sitt scenario, att jämföra andra med (F7)</translation>
    </message>
    <message>
        <source>In a folder of the same name, “.runs”: a scenario for each, so that they are there when the file is opened again</source>
        <translation>I en mapp med samma namn, ”.runs”: ett scenario för varje, så att de finns där när filen öppnas igen</translation>
    </message>
    <message>
        <source>There is no result to be pinned.</source>
        <translation>Det finns inget resultat att fästa.</translation>
    </message>
    <message>
        <source>This result cannot be pinned.</source>
        <translation>Detta resultat kan inte fästas.</translation>
    </message>
    <message>
        <source>This result is not pinned.</source>
        <translation>Detta resultat är inte fäst.</translation>
    </message>
    <message>
        <source>revert to %1</source>
        <translation>återgå till %1</translation>
    </message>
    <message>
        <source>The run cannot be brought back.</source>
        <translation>Körningen kan inte tas tillbaka.</translation>
    </message>
    <message>
        <source>Delete the kept runs?</source>
        <translation>Ska de sparade körningarna tas bort?</translation>
    </message>
    <message>
        <source>%1
They stay on the list until the window is closed.</source>
        <translation>%1
De är kvar i listan tills fönstret stängs.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>There are runs beside this file already.</source>
        <translation>Det finns redan körningar bredvid denna fil.</translation>
    </message>
    <message>
        <source>%1
Runs that are not on the list here would be lost.</source>
        <translation>%1
De som inte finns i listan här skulle gå förlorade.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersätt</translation>
    </message>
    <message>
        <source>The runs are not kept.</source>
        <translation>Körningarna är inte sparade.</translation>
    </message>
</context>
<context>
    <name>drillwave::PlaceField</name>
    <message>
        <source>Section x/L of the waves</source>
        <translation>Läge x/L för vågorna</translation>
    </message>
    <message>
        <source>
Up and Down move it by 0.01, Page Up and Page Down by 0.1.</source>
        <translation>
Upp och Ned flyttar det med 0,01, Page Up och Page Down med 0,1.</translation>
    </message>
</context>
<context>
    <name>drillwave::PlayBar</name>
    <message>
        <source>Time cursor</source>
        <translation>Tidsmarkör</translation>
    </message>
    <message>
        <source>Moves the time cursor through the times in view</source>
        <translation>Flyttar tidsmarkören genom tiderna i vyn</translation>
    </message>
    <message>
        <source>in %1 s</source>
        <translation>på %1 s</translation>
    </message>
    <message>
        <source>Duration of playing the times in view</source>
        <translation>Hur lång tid det tar att spela upp tiderna i vyn</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Upprepa</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>Spela upp om och om igen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Paus</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Spela upp</translation>
    </message>
    <message>
        <source>Pause (space bar)</source>
        <translation>Paus (mellanslag)</translation>
    </message>
    <message>
        <source>Play the blow (space bar)</source>
        <translation>Spela upp slaget (mellanslag)</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>%1 gånger långsammare</translation>
    </message>
    <message>
        <source>%1 t₀ per second</source>
        <translation>%1 t₀ per sekund</translation>
    </message>
</context>
<context>
    <name>drillwave::PlotMenu</name>
    <message>
        <source>Copy &amp;picture</source>
        <translation>Kopiera b&amp;ild</translation>
    </message>
    <message>
        <source>The present view, black on white, for a report</source>
        <translation>Denna vy, svart på vitt, för en rapport</translation>
    </message>
    <message>
        <source>Copy &amp;data</source>
        <translation>Kopiera &amp;data</translation>
    </message>
    <message>
        <source>The numbers of what is shown, as a table for a spreadsheet</source>
        <translation>Talen i det som visas, som en tabell för ett kalkylark</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>&amp;Spara bild…</translation>
    </message>
    <message>
        <source>This view as PNG, SVG or PDF</source>
        <translation>Denna vy som PNG, SVG eller PDF</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>S&amp;para data…</translation>
    </message>
    <message>
        <source>The numbers of what is shown, as CSV</source>
        <translation>Talen i det som visas, som CSV</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;npassa</translation>
    </message>
    <message>
        <source>Bring all curves into view</source>
        <translation>Visa alla kurvor i sin helhet</translation>
    </message>
    <message>
        <source>&amp;Zoom back</source>
        <translation>&amp;Zooma tillbaka</translation>
    </message>
    <message>
        <source>The previous view</source>
        <translation>Föregående vy</translation>
    </message>
    <message>
        <source>Logarithmic &amp;horizontal axis</source>
        <translation>Logaritmisk vå&amp;grät axel</translation>
    </message>
    <message>
        <source>Logarithmic &amp;vertical axis</source>
        <translation>Logaritmisk &amp;lodrät axel</translation>
    </message>
    <message>
        <source>Equal steps are equal ratios; values of zero are not shown</source>
        <translation>Lika steg är lika faktorer; nollor klipps bort</translation>
    </message>
    <message>
        <source>&amp;Curves shown</source>
        <translation>Visade &amp;kurvor</translation>
    </message>
    <message>
        <source>&amp;Point for keys</source>
        <translation>Punkt för &amp;tangenter</translation>
    </message>
    <message>
        <source>Arrows move the point, N goes to the next mark, Enter acts like a click</source>
        <translation>Pilar flyttar den, N går till nästa märke; Retur gör sedan vad ett klick gör där</translation>
    </message>
    <message>
        <source>Cursor &amp;A here</source>
        <translation>Markör &amp;A här</translation>
    </message>
    <message>
        <source>Reads the curves here; drag it to move it</source>
        <translation>Läser av kurvorna här; kan dras</translation>
    </message>
    <message>
        <source>Cursor &amp;B here</source>
        <translation>Markör &amp;B här</translation>
    </message>
    <message>
        <source>Reads the curves here; slope, mean and integral from A to B</source>
        <translation>Läser av kurvorna här; lutning, medel och integral från A till B</translation>
    </message>
    <message>
        <source>&amp;Time cursor here</source>
        <translation>Tidsmarkör &amp;här</translation>
    </message>
    <message>
        <source>The time shown on all pages</source>
        <translation>Det ögonblick som visas på alla sidor</translation>
    </message>
    <message>
        <source>&amp;Remove cursors A and B</source>
        <translation>Ta bort markörerna A &amp;och B</translation>
    </message>
    <message>
        <source>The table below the plot then reads the values in view</source>
        <translation>Tabellen under diagrammet läser då av det som är i vyn</translation>
    </message>
    <message>
        <source>Copy the &amp;table below</source>
        <translation>Kopiera tabellen &amp;under</translation>
    </message>
    <message>
        <source>The readings at the cursors, or the numbers in view, to paste into a spreadsheet</source>
        <translation>Det som är avläst vid markörerna eller i vyn, att klistra in i ett kalkylark</translation>
    </message>
</context>
<context>
    <name>drillwave::PlotPage</name>
    <message>
        <source>&amp;Data of this plot…</source>
        <translation>&amp;Data i detta diagram…</translation>
    </message>
    <message>
        <source>The curves of the plot, as CSV</source>
        <translation>Kurvorna som diagrammet visar, som CSV</translation>
    </message>
    <message>
        <source>&amp;Picture of this plot…</source>
        <translation>B&amp;ild av detta diagram…</translation>
    </message>
    <message>
        <source>The present view, as PNG, SVG or PDF</source>
        <translation>Som den är zoomad, som PNG, SVG eller PDF</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Visa allt</translation>
    </message>
</context>
<context>
    <name>drillwave::PlotViewMenu</name>
    <message>
        <source>&amp;Plot on show</source>
        <translation>Visat &amp;diagram</translation>
    </message>
    <message>
        <source>&amp;Table below plots</source>
        <translation>&amp;Tabell under diagrammen</translation>
    </message>
    <message>
        <source>Readings in view, or at the cursors A and B</source>
        <translation>Läser av det som är i vyn, eller vid markörerna A och B</translation>
    </message>
    <message>
        <source>No plot</source>
        <translation>Inget diagram</translation>
    </message>
</context>
<context>
    <name>drillwave::PresetBox</name>
    <message>
        <source>%1: preset</source>
        <translation>%1: förval</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>egna</translation>
    </message>
    <message>
        <source>The values belong to no preset. Select one to start from its values.</source>
        <translation>Värdena är inget förvals. Välj ett för att utgå från dess värden.</translation>
    </message>
    <message>
        <source>Presets have physical units, and this scenario has only dimensionless groups.</source>
        <translation>Förval är fysikaliska värden, och detta scenario är givet enbart av sina dimensionslösa tal.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>&amp;Add file of presets…</source>
        <translation>Lägg till fil med &amp;förval…</translation>
    </message>
    <message>
        <source>Adds the presets of your own YAML file, also for later sessions</source>
        <translation>Erbjud förvalen i en egen YAML-fil, nu och framöver</translation>
    </message>
    <message>
        <source>&amp;Open folder of presets</source>
        <translation>&amp;Öppna mappen med förval</translation>
    </message>
    <message>
        <source>A file presets.yaml in %1 is read automatically</source>
        <translation>En fil presets.yaml i %1 läses av sig själv</translation>
    </message>
    <message>
        <source>Remove these from the list</source>
        <translation>Ta bort dessa från listan</translation>
    </message>
    <message>
        <source>⚠ %1 is not used: why?</source>
        <translation>⚠ %1 används inte: varför?</translation>
    </message>
    <message>
        <source>The presets of %1 are not used.</source>
        <translation>Förvalen i %1 används inte.</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Ta bort den från listan</translation>
    </message>
    <message>
        <source>Add a file of presets</source>
        <translation>Lägg till en fil med förval</translation>
    </message>
    <message>
        <source>Presets (*.yaml *.yml);;All files (*)</source>
        <translation>Förval (*.yaml *.yml);;Alla filer (*)</translation>
    </message>
    <message>
        <source>These presets cannot be used.</source>
        <translation>Dessa förval kan inte användas.</translation>
    </message>
    <message>
        <source>This preset does not fit the rest of the scenario.</source>
        <translation>Detta förval passar inte resten av scenariot.</translation>
    </message>
</context>
<context>
    <name>drillwave::PresetTicks</name>
    <message>
        <source>hammers</source>
        <translation>hammare</translation>
    </message>
    <message>
        <source>rods</source>
        <translation>stänger</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>borrkronor</translation>
    </message>
    <message>
        <source>Ticked presets are compared as designs</source>
        <translation>Förkryssade förval är konstruktioner att välja mellan</translation>
    </message>
    <message>
        <source>%1 to choose from</source>
        <translation>%1 att välja mellan</translation>
    </message>
</context>
<context>
    <name>drillwave::PulsePreview</name>
    <message>
        <source>Hammer force over time</source>
        <translation>Hammarkraft över tiden</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>topp %1</translation>
    </message>
    <message>
        <source>t₀ = %1</source>
        <translation>t₀ = %1</translation>
    </message>
    <message>
        <source>No hammer force: the rod arrives with a uniform velocity</source>
        <translation>Ingen hammarkraft: stången kommer fram med likformig hastighet</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Force of the hammer on the rod over time: %1</source>
        <translation>Hammarens kraft på stången över tiden: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::PulseSection</name>
    <message>
        <source>shape</source>
        <translation>form</translation>
    </message>
    <message>
        <source>Hammer blow: shape</source>
        <translation>Hammarslag: form</translation>
    </message>
    <message>
        <source>Shape of the force of the hammer on the rod over time</source>
        <translation>Formen på hammarens kraft på stången över tiden</translation>
    </message>
    <message>
        <source>Measured…</source>
        <translation>Uppmätt…</translation>
    </message>
    <message>
        <source>Import a measured hammer blow: any table of samples, as a force, a strain or the output of a bridge</source>
        <translation>Importera ett uppmätt hammarslag: vilken tabell med mätvärden som helst, som kraft, töjning eller en bryggas utsignal</translation>
    </message>
    <message>
        <source>Table of the hammer blow</source>
        <translation>Hammarslagets tabell</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Läs om</translation>
    </message>
    <message>
        <source>Read the CSV file of the hammer blow again</source>
        <translation>Läs hammarslagets CSV-fil igen</translation>
    </message>
    <message>
        <source>Choose CSV…</source>
        <translation>Välj CSV…</translation>
    </message>
    <message>
        <source>Reads the hammer blow from a CSV file that begins with `time [us],force [kN]`</source>
        <translation>Ta hammarslaget från en CSV-fil som börjar med `time [us],force [kN]`</translation>
    </message>
    <message>
        <source>Hammer blow: impulse of the table</source>
        <translation>Hammarslag: tabellens impuls</translation>
    </message>
    <message>
        <source>Impulse of the table. Another value scales all its forces, and the scenario then contains the points.</source>
        <translation>Tabellens impuls; en annan skalar alla dess krafter, som scenariot då håller i sig självt</translation>
    </message>
    <message>
        <source>impulse I₀</source>
        <translation>impuls I₀</translation>
    </message>
    <message>
        <source>Hammer blow: impulse of the table, unit</source>
        <translation>Hammarslag: tabellens impuls, enhet</translation>
    </message>
    <message>
        <source>a table of more than %1 points stays in its file: scale its forces there</source>
        <translation>en tabell med mer än %1 punkter stannar i sin fil: skala krafterna där</translation>
    </message>
    <message>
        <source>scale the hammer blow to %1</source>
        <translation>skala hammarslaget till %1</translation>
    </message>
    <message>
        <source>%1 from a file…</source>
        <translation>%1 från en fil…</translation>
    </message>
    <message>
        <source>Take the hammer blow from a CSV file</source>
        <translation>Ta hammarslaget från en CSV-fil</translation>
    </message>
    <message>
        <source>Tables of time and force (*.csv);;All files (*)</source>
        <translation>Tabeller med tid och kraft (*.csv);;Alla filer (*)</translation>
    </message>
    <message>
        <source>The hammer blow cannot be taken from this file.</source>
        <translation>Hammarslaget kan inte tas från denna fil.</translation>
    </message>
    <message>
        <source>“Measured…” imports tables of any other form.</source>
        <translation>”Uppmätt…” importerar tabeller av alla andra slag.</translation>
    </message>
</context>
<context>
    <name>drillwave::RangeRow</name>
    <message>
        <source>Uncertain parameter</source>
        <translation>Osäker parameter</translation>
    </message>
    <message>
        <source>Design variable</source>
        <translation>Vald parameter</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Hur den sprider</translation>
    </message>
    <message>
        <source>even</source>
        <translation>jämn</translation>
    </message>
    <message>
        <source>even in log</source>
        <translation>jämn i log</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>normal in log</source>
        <translation>normal i logaritmen</translation>
    </message>
    <message>
        <source>Equally likely between the limits, or a normal distribution with 95 % between them; in the value or in its logarithm</source>
        <translation>Varje värde mellan ändarna lika ofta som ett annat, eller en klockkurva av vilken 95 % ligger mellan dem; i värdet eller i dess logaritm</translation>
    </message>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>Even ratios instead of even steps</source>
        <translation>Lika förhållanden i stället för lika steg</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Antal värden</translation>
    </message>
    <message>
        <source> values</source>
        <translation> värden</translation>
    </message>
    <message>
        <source>from</source>
        <translation>från</translation>
    </message>
    <message>
        <source>to</source>
        <translation>till</translation>
    </message>
    <message>
        <source>%1, unit</source>
        <translation>%1, enhet</translation>
    </message>
    <message>
        <source>must differ from the other end</source>
        <translation>måste skilja sig från den andra änden</translation>
    </message>
    <message>
        <source>the range is reversed: give the lower end first</source>
        <translation>området är upp och ner: den första änden är den undre</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Ta bort %1</translation>
    </message>
    <message>
        <source>Removes this row: the parameter is known</source>
        <translation>Denna är känd</translation>
    </message>
    <message>
        <source>Removes this row: the parameter is not varied</source>
        <translation>Denna förblir som den är</translation>
    </message>
</context>
<context>
    <name>drillwave::RangeRows</name>
    <message>
        <source>Add an uncertain parameter</source>
        <translation>Lägg till en osäker parameter</translation>
    </message>
    <message>
        <source>Add a design variable</source>
        <translation>Lägg till en vald parameter</translation>
    </message>
    <message>
        <source>Adds an uncertain parameter</source>
        <translation>Ett tal till som inte är känt</translation>
    </message>
    <message>
        <source>Adds a design variable</source>
        <translation>Ett tal till som kan väljas</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Ta bort %1</translation>
    </message>
</context>
<context>
    <name>drillwave::RecordList</name>
    <message>
        <source>Records</source>
        <translation>Inspelningar</translation>
    </message>
    <message>
        <source>record</source>
        <translation>inspelning</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>omdöme</translation>
    </message>
    <message>
        <source>misfit</source>
        <translation>avvikelse</translation>
    </message>
    <message>
        <source>A click shows a record; Delete removes it from the list</source>
        <translation>Ett klick visar en inspelning; Delete tar bort den ur listan</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Ta bort %1</translation>
    </message>
    <message>
        <source>Removes this record from the list; the file stays</source>
        <translation>Tar bort denna inspelning ur listan; filen blir kvar</translation>
    </message>
</context>
<context>
    <name>drillwave::ReportPreview</name>
    <message>
        <source>date of the day</source>
        <translation>dagens datum</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Uppdatera</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Förhandsvisning av rapporten</translation>
    </message>
    <message>
        <source>project</source>
        <translation>projekt</translation>
    </message>
    <message>
        <source>author</source>
        <translation>författare</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>kund</translation>
    </message>
    <message>
        <source>The scenario has changed: shows the pages again for the present one</source>
        <translation>Scenariot har ändrats sedan dess: visa sidorna för det som det är nu</translation>
    </message>
    <message>
        <source>&amp;Write as HTML or PDF…</source>
        <translation>&amp;Skriv som HTML eller PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Skriv &amp;ut…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;täng</translation>
    </message>
</context>
<context>
    <name>drillwave::ReportWriter</name>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Rapport…</translation>
    </message>
    <message>
        <source>A report as HTML or PDF: inputs with their sources, results, verdict, plots and the scenario</source>
        <translation>En sida att lämna över, som HTML eller PDF: indata med sina källor, resultat, omdöme, diagram och scenariot</translation>
    </message>
    <message>
        <source>&amp;Print the report…</source>
        <translation>Skriv &amp;ut rapporten…</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Skriv rapporten</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf)</source>
        <translation>Webbsida (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report has not been written.</source>
        <translation>Rapporten har inte skrivits.</translation>
    </message>
    <message>
        <source>%1: a report is a file that ends in .html or .pdf; choose such a name</source>
        <translation>%1: en rapport är en fil som slutar på .html eller .pdf; välj ett sådant namn</translation>
    </message>
    <message>
        <source>The report has not been printed.</source>
        <translation>Rapporten har inte skrivits ut.</translation>
    </message>
    <message>
        <source>The blow could not be solved: %1</source>
        <translation>Slaget kunde inte lösas: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skriven: %1</translation>
    </message>
    <message>
        <source>%1 does not accept pages; check the printer, or write the report as PDF</source>
        <translation>%1 tar inte emot några sidor; se efter skrivaren, eller skriv rapporten som PDF</translation>
    </message>
    <message>
        <source>Printed: %1</source>
        <translation>Utskrivet: %1</translation>
    </message>
    <message>
        <source>Pre&amp;view of the report…</source>
        <translation>&amp;Förhandsvisa rapporten…</translation>
    </message>
    <message>
        <source>Shows the pages of the report, with project, author, customer and date in their heading</source>
        <translation>Rapportens sidor i ett fönster, med projekt, författare, kund och datum för sidhuvudet</translation>
    </message>
    <message>
        <source>There is no preview of the report.</source>
        <translation>Det finns ingen förhandsvisning av rapporten.</translation>
    </message>
    <message>
        <source>The report on pages of A4</source>
        <translation>Rapporten på A4-sidor</translation>
    </message>
</context>
<context>
    <name>drillwave::ResultPanel</name>
    <message>
        <source>Penetration</source>
        <translation>Inträngning</translation>
    </message>
    <message>
        <source>Rebound</source>
        <translation>Studs</translation>
    </message>
    <message>
        <source>Stress in the rod</source>
        <translation>Spänning i stången</translation>
    </message>
    <message>
        <source>Force and times</source>
        <translation>Kraft och tider</translation>
    </message>
    <message>
        <source>&amp;Copy results</source>
        <translation>&amp;Kopiera resultaten</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energi</translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation>Varningar</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Händelser</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Borrning</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Matningskraft</translation>
    </message>
    <message>
        <source>required feed</source>
        <translation>erforderlig matningskraft</translation>
    </message>
    <message>
        <source>sequence of blows</source>
        <translation>slagföljd</translation>
    </message>
    <message>
        <source>Set wave loss 10 %</source>
        <translation>Sätt vågförlust 10 %</translation>
    </message>
    <message>
        <source>Estimate from single blows. Consecutive blows are being solved …</source>
        <translation>Uppskattning från enskilda slag. På varandra följande slag beräknas …</translation>
    </message>
    <message>
        <source>Estimate from single blows.</source>
        <translation>Uppskattning från enstaka slag.</translation>
    </message>
    <message>
        <source>Solve consecutive blows (about %1 s)</source>
        <translation>Följ på varandra följande slag (cirka %1 s)</translation>
    </message>
    <message>
        <source>The required feed force is estimated from single blows; %1 solves consecutive blows.</source>
        <translation>Den krävda matningskraften är uppskattad från enstaka slag; %1 simulerar slag efter slag.</translation>
    </message>
    <message>
        <source>penetration, energy, power and restitution</source>
        <translation>inträngning, energi, effekt och studstal</translation>
    </message>
    <message>
        <source>e = %1</source>
        <translation>e = %1</translation>
    </message>
    <message>
        <source>this blow: penetration %1</source>
        <translation>detta slag: inträngning %1</translation>
    </message>
    <message>
        <source>hammer work %1</source>
        <translation>hammarens arbete %1</translation>
    </message>
    <message>
        <source>power %1</source>
        <translation>effekt %1</translation>
    </message>
</context>
<context>
    <name>drillwave::RigDialog</name>
    <message>
        <source>Rig of these groups</source>
        <translation>Rigg av dessa tal</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>egna</translation>
    </message>
    <message>
        <source>&amp;Rod</source>
        <translation>&amp;Stång</translation>
    </message>
    <message>
        <source>Make the rig</source>
        <translation>Gör riggen</translation>
    </message>
    <message>
        <source>The groups give a rod of %1, an impulse of %2, a stiffness of %3 and a gap of %4.</source>
        <translation>Av talen följer en stång på %1, en impuls på %2, en styvhet på %3 och en spalt på %4.</translation>
    </message>
    <message>
        <source>make a rig of the groups</source>
        <translation>göra en rigg av talen</translation>
    </message>
    <message>
        <source>Edit ▸ Make a rig of these groups gives it physical units; File ▸ New begins another one.</source>
        <translation>Redigera ▸ Gör en rigg av dessa tal ger det fysikaliska enheter; Arkiv ▸ Ny börjar ett annat.</translation>
    </message>
</context>
<context>
    <name>drillwave::RockPage</name>
    <message>
        <source>State of the rock at the time cursor, shown by the larger point</source>
        <translation>Bergets tillstånd vid tidsmarkören, den större punkten på banan</translation>
    </message>
    <message>
        <source>Shows the whole path (double-click in the plot)</source>
        <translation>Visa hela banan (dubbelklick i diagrammet)</translation>
    </message>
    <message>
        <source>Impact force against penetration</source>
        <translation>Stötkraft över inträngning</translation>
    </message>
    <message>
        <source>Nothing to show: this blow has too many waves to keep.</source>
        <translation>Inget att visa: detta slag har fler vågor än vad som kan sparas.</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Inget att visa: %1</translation>
    </message>
    <message>
        <source>To mark a time, click an event in Result or place the time cursor on the page Blow.</source>
        <translation>Markera tid: klick på en händelse i resultatet, eller tidsmarkören på sidan Slag.</translation>
    </message>
    <message>
        <source>t = %1 · U = %2 · F = %3</source>
        <translation>t = %1 · U = %2 · F = %3</translation>
    </message>
    <message>
        <source>Rock</source>
        <translation>Berg</translation>
    </message>
    <message>
        <source>The bit penetrates %1 into the rock, and %2 remain after the rebound. %3 % of the blow energy stays in the rock.</source>
        <translation>Borrkronan tränger in %1 i berget, varav %2 återstår efter studsen. %3 % av slagenergin stannar i berget.</translation>
    </message>
</context>
<context>
    <name>drillwave::RockPlot</name>
    <message>
        <source>no energy left in the rock</source>
        <translation>ingen energi kvar i berget</translation>
    </message>
    <message>
        <source>impact force F</source>
        <translation>stötkraft F</translation>
    </message>
    <message>
        <source>penetration U</source>
        <translation>inträngning U</translation>
    </message>
    <message>
        <source>enclosed area: %1</source>
        <translation>innesluten yta: %1</translation>
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
        <translation>Stötkraft över inträngning. Belastning längs lutningen k = %1 upp till toppen, Fₘ = %2 vid inträngningen Uₘ = %3; avlastning längs k/γ = %4; inträngningen Uᵣ = %5 blir kvar. Den inneslutna ytan: %6.</translation>
    </message>
    <message>
        <source> Above its corners it loads along %1.</source>
        <translation> Bakom sina hörn belastas det längs %1.</translation>
    </message>
    <message>
        <source>energy left in the rock: %1 (%2 of the blow)</source>
        <translation>energi kvar i berget: %1 (%2 av slaget)</translation>
    </message>
</context>
<context>
    <name>drillwave::RodPage</name>
    <message>
        <source>Section shown by the dotted line: 0 is the struck end, 1 the bit.
A click in the plot moves it, and moves the time cursor to the largest stress there.</source>
        <translation>Den prickade linjen: var i stången man tittar, 0 är slagänden, 1 borrkronan.
Ett klick i diagrammet flyttar den, och tidsmarkören till när spänningen där är störst.</translation>
    </message>
    <message>
        <source>Section x/L</source>
        <translation>Läge x/L</translation>
    </message>
    <message>
        <source>The largest stresses at the section, and when they occur</source>
        <translation>De största spänningarna i tvärsnittet, och när de uppträder</translation>
    </message>
    <message>
        <source>Bring the whole rod into view (double-click in the plot)</source>
        <translation>Visa hela stången (dubbelklick i diagrammet)</translation>
    </message>
    <message>
        <source>Largest stresses along the rod</source>
        <translation>Största spänningar längs stången</translation>
    </message>
    <message>
        <source>Nothing to show: there are too many waves to keep.</source>
        <translation>Inget att visa: så många vågor att de inte sparas.</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Inget att visa: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 vid %2</translation>
    </message>
    <message>
        <source>At %1, during the blow: %2 and %3
afterwards, in the residual waves: %4 and %5</source>
        <translation>Vid %1, under slaget: %2 och %3
därefter, i restvågorna: %4 och %5</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stång</translation>
    </message>
    <message>
        <source>At %1, during the blow: %2 and %3
in %4</source>
        <translation>Vid %1, under slaget: %2 och %3
i %4</translation>
    </message>
    <message>
        <source>; the largest stress of this section uses %1 % of its strength</source>
        <translation>; den största spänningen i denna sektion utnyttjar %1 % av hållfastheten</translation>
    </message>
</context>
<context>
    <name>drillwave::RodPlot</name>
    <message>
        <source>largest compression in the blow</source>
        <translation>största tryck i slaget</translation>
    </message>
    <message>
        <source>largest tension in the blow</source>
        <translation>största drag i slaget</translation>
    </message>
    <message>
        <source>compression of residual waves</source>
        <translation>tryck i restvågorna</translation>
    </message>
    <message>
        <source>tension of residual waves</source>
        <translation>drag i restvågorna</translation>
    </message>
    <message>
        <source>position x from the struck end, hammer at x &lt; 0</source>
        <translation>läge x från slagänden, hammaren vid x &lt; 0</translation>
    </message>
    <message>
        <source>position x from the struck end</source>
        <translation>läge x från slagänden</translation>
    </message>
    <message>
        <source>stress (tension positive)</source>
        <translation>spänning (drag positivt)</translation>
    </message>
    <message>
        <source>stress, as force in the rod (tension positive)</source>
        <translation>spänning, som kraft i stången (drag positivt)</translation>
    </message>
    <message>
        <source>force N (tension positive)</source>
        <translation>kraft N (drag positivt)</translation>
    </message>
    <message>
        <source>many waves: between peaks the curve may be too low by %1</source>
        <translation>så många vågor att en kurva mellan topparna kan vara %1 för låg</translation>
    </message>
    <message>
        <source>%1 up to %2 at %3, %4</source>
        <translation>%1 upp till %2 vid %3, %4</translation>
    </message>
    <message>
        <source>Largest stresses along the rod, tension positive: %1.</source>
        <translation>Största spänningar längs stången, drag positivt: %1.</translation>
    </message>
    <message>
        <source>without local stresses at threads and changes of diameter</source>
        <translation>utan lokala spänningar vid gängor och ansatser</translation>
    </message>
    <message>
        <source>without local stresses at threads; residual waves undamped</source>
        <translation>utan lokala spänningar vid gängor; restvågor odämpade</translation>
    </message>
</context>
<context>
    <name>drillwave::RodProfile</name>
    <message>
        <source>Force along the rod at the time cursor, of this blow and of pinned runs</source>
        <translation>Kraft längs stången vid tidsmarkören, för detta slag och för fästa körningar</translation>
    </message>
    <message>
        <source>Velocity along the rod at the time cursor, of this blow and of pinned runs</source>
        <translation>Hastighet längs stången vid tidsmarkören, för detta slag och för fästa körningar</translation>
    </message>
    <message>
        <source>this blow</source>
        <translation>detta slag</translation>
    </message>
    <message>
        <source>x = %1 · t = %2</source>
        <translation>x = %1 · t = %2</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nu</translation>
    </message>
</context>
<context>
    <name>drillwave::RodStrip</name>
    <message>
        <source>The rod at the time cursor, coloured by its stress</source>
        <translation>Stången vid tidsmarkören, färgad efter sin spänning</translation>
    </message>
    <message>
        <source>The rod at the time cursor, coloured by its velocity</source>
        <translation>Stången vid tidsmarkören, färgad efter sin hastighet</translation>
    </message>
    <message>
        <source>The rod at the time cursor: hammer, rod, bit and rock. Blue is compressed, orange is in tension.</source>
        <translation>Stången vid tidsmarkören: hammare, stång, borrkrona och berg. Blått är tryckt, orange är draget.</translation>
    </message>
    <message>
        <source>The rod at the time cursor: hammer, rod, bit and rock. Orange moves towards the rock, blue away from it; as on the colour bar above.</source>
        <translation>Stången vid tidsmarkören: hammare, stång, borrkrona och berg. Orange rör sig mot berget, blått bort från det; som på färgskalan ovanför.</translation>
    </message>
    <message>
        <source>t = %1 · after the end of the computed time, %2</source>
        <translation>t = %1 · senare än slaget följdes, vilket är till %2</translation>
    </message>
    <message>
        <source>contact, penetration %1, impact force %2</source>
        <translation>kontakt, inträngning %1, stötkraft %2</translation>
    </message>
    <message>
        <source>apart, gap %1</source>
        <translation>isär, spalt %1</translation>
    </message>
    <message>
        <source>bit at the rock, no force</source>
        <translation>borrkronan mot berget, ingen kraft</translation>
    </message>
    <message>
        <source> · hammer pushes</source>
        <translation> · hammaren trycker</translation>
    </message>
    <message>
        <source> · hammer not in contact</source>
        <translation> · hammaren utan kontakt</translation>
    </message>
    <message>
        <source>t = %1 · %2 · stress %3 … %4</source>
        <translation>t = %1 · %2 · spänning %3 … %4</translation>
    </message>
    <message>
        <source>t = %1 · %2 · velocity %3 … %4</source>
        <translation>t = %1 · %2 · hastighet %3 … %4</translation>
    </message>
</context>
<context>
    <name>drillwave::RunKeeper</name>
    <message>
        <source>A run has changed.</source>
        <translation>En körning är inte vad den var.</translation>
    </message>
    <message>
        <source>%1: too many runs are shown already; remove some and open the file again</source>
        <translation>%1: det finns ingen plats för den bland de visade körningarna; ta bort några och öppna filen igen</translation>
    </message>
    <message>
        <source>%1: its file would replace another one in %2; remove the run and open the file again</source>
        <translation>%1: dess fil skulle ersätta en annan i %2; ta bort körningen och öppna filen igen</translation>
    </message>
    <message>
        <source>Not all runs that are kept with this file can be shown.</source>
        <translation>Inte alla körningar som sparats med denna fil kan visas.</translation>
    </message>
    <message>
        <source>The runs are not kept beside the new file.</source>
        <translation>Körningarna sparas inte bredvid den nya filen.</translation>
    </message>
    <message>
        <source>The scenario has no file yet: save it first, the runs are kept beside it.</source>
        <translation>Scenariot har ingen fil ännu: spara det först, körningarna sparas bredvid.</translation>
    </message>
    <message>
        <source>The runs are not kept.</source>
        <translation>Körningarna är inte sparade.</translation>
    </message>
    <message>
        <source>The runs are no longer kept.</source>
        <translation>Körningarna sparas inte längre.</translation>
    </message>
</context>
<context>
    <name>drillwave::RunPanel</name>
    <message>
        <source>Runs</source>
        <translation>Körningar</translation>
    </message>
    <message>
        <source>F7 pins this result for comparison.</source>
        <translation>F7 fäster resultatet för jämförelse.</translation>
    </message>
    <message>
        <source>Ticked runs are shown in the plots. F2 renames, Del removes; right-click for more</source>
        <translation>Förbockade körningar ritas över diagrammen. F2 byter namn, Delete tar bort, menytangenten eller ett högerklick har resten</translation>
    </message>
    <message>
        <source>run</source>
        <translation>körning</translation>
    </message>
    <message>
        <source>Δ</source>
        <translation>Δ</translation>
    </message>
    <message>
        <source>Re&amp;vert to this run</source>
        <translation>Åter&amp;gå till denna körning</translation>
    </message>
    <message>
        <source>&amp;Compare with this run</source>
        <translation>&amp;Jämför med denna körning</translation>
    </message>
    <message>
        <source>Compare with the &amp;present result</source>
        <translation>Jämför med det aktuella &amp;resultatet</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Byt namn</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Ta bort</translation>
    </message>
    <message>
        <source>● now</source>
        <translation>● nu</translation>
    </message>
    <message>
        <source>The present result</source>
        <translation>Det aktuella resultatet</translation>
    </message>
    <message>
        <source>ref.</source>
        <translation>ref.</translation>
    </message>
    <message>
        <source>Being solved</source>
        <translation>Löses</translation>
    </message>
    <message>
        <source>Difference from the reference</source>
        <translation>Skillnad mot referensen</translation>
    </message>
    <message>
        <source>Result shown of each run</source>
        <translation>Resultat som visas för varje körning</translation>
    </message>
    <message>
        <source>COR e</source>
        <translation>studstal e</translation>
    </message>
    <message>
        <source>Not kept when the window closes</source>
        <translation>Försvinner med fönstret</translation>
    </message>
    <message>
        <source>File ▸ Keep runs beside the file keeps them</source>
        <translation>Arkiv ▸ Behåll körningar bredvid filen behåller dem</translation>
    </message>
</context>
<context>
    <name>drillwave::Runs</name>
    <message>
        <source>This is the run %1 already.</source>
        <translation>Detta är redan körningen %1.</translation>
    </message>
    <message>
        <source>There are %1 runs already, the most that can be distinguished: remove one first.</source>
        <translation>Det finns %1 körningar, så många som går att skilja åt: ta bort en först.</translation>
    </message>
    <message>
        <source>%1 had e = %2 and has %3 now: the table of its hammer blow has been changed, or another version has solved it.</source>
        <translation>%1 hade e = %2 och har nu %3: hammarslagets tabell har ändrats, eller en annan version har löst den.</translation>
    </message>
</context>
<context>
    <name>drillwave::ScenarioPanel</name>
    <message>
        <source>String</source>
        <translation>Sträng</translation>
    </message>
    <message>
        <source>Hammer</source>
        <translation>Hammare</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stång</translation>
    </message>
    <message>
        <source>Hammer blow</source>
        <translation>Hammarslag</translation>
    </message>
    <message>
        <source>Bit and rock</source>
        <translation>Borrkrona och berg</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Borrning</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maskin</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Dimensionslösa tal</translation>
    </message>
    <message>
        <source>Title of the scenario</source>
        <translation>Scenariots titel</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>förval</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>inte angiven</translation>
    </message>
</context>
<context>
    <name>drillwave::SectionBox</name>
    <message>
        <source>open</source>
        <translation>öppen</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>hopfälld</translation>
    </message>
</context>
<context>
    <name>drillwave::SignalFields</name>
    <message>
        <source>place x</source>
        <translation>läge x</translation>
    </message>
    <message>
        <source>Distance of the gauge from the struck end; negative in the hammer</source>
        <translation>Givarens, från slagänden; under 0 i hammaren</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>inte angiven</translation>
    </message>
    <message>
        <source>signal is</source>
        <translation>signalen är</translation>
    </message>
    <message>
        <source>Quantity that was recorded</source>
        <translation>Storhet som spelades in</translation>
    </message>
    <message>
        <source>force</source>
        <translation>kraft</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>töjning</translation>
    </message>
    <message>
        <source>output of a bridge</source>
        <translation>utsignal från en brygga</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>enhet</translation>
    </message>
    <message>
        <source>Unit of the numbers</source>
        <translation>Talens enhet</translation>
    </message>
    <message>
        <source>positive is</source>
        <translation>positivt är</translation>
    </message>
    <message>
        <source>Meaning of positive numbers. In this program tension is positive in rods; on the rock and in a blow, compression is.</source>
        <translation>Vad ett tal större än 0 betyder. Här är drag positivt i en stång, och tryckande i ett slag och på berget.</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>drag</translation>
    </message>
    <message>
        <source>compression</source>
        <translation>tryck</translation>
    </message>
    <message>
        <source>zero line</source>
        <translation>nollinje</translation>
    </message>
    <message>
        <source>Zero level, subtracted from all samples</source>
        <translation>Vad som dras från alla mätvärden</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>som inspelat</translation>
    </message>
    <message>
        <source>mean of the first</source>
        <translation>medel av de första</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ett värde</translation>
    </message>
    <message>
        <source>first</source>
        <translation>de första</translation>
    </message>
    <message>
        <source>Time at the start of the record without a signal</source>
        <translation>Hur länge ingenting händer i inspelningen</translation>
    </message>
    <message>
        <source>zero is at</source>
        <translation>noll ligger vid</translation>
    </message>
    <message>
        <source>In the unit of the column</source>
        <translation>I kolumnens enhet</translation>
    </message>
    <message>
        <source>from</source>
        <translation>från</translation>
    </message>
    <message>
        <source>Samples before this time of the file are left out</source>
        <translation>Mätvärden före denna tid i filen utelämnas</translation>
    </message>
    <message>
        <source>to</source>
        <translation>till</translation>
    </message>
    <message>
        <source>Samples after this time of the file are left out</source>
        <translation>Mätvärden efter denna tid i filen utelämnas</translation>
    </message>
    <message>
        <source>beginning</source>
        <translation>början</translation>
    </message>
    <message>
        <source>end</source>
        <translation>slut</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Topp</translation>
    </message>
    <message>
        <source>The range around the peak in which the signal exceeds 2 % of it</source>
        <translation>Från och till dit där signalen är 2 % av sin topp, kring den</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vy</translation>
    </message>
    <message>
        <source>The range shown by the plot: zoom there first</source>
        <translation>Från och till ändarna av det som diagrammet visar: zooma dit först</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Allt</translation>
    </message>
    <message>
        <source>All of the record</source>
        <translation>Hela inspelningen</translation>
    </message>
    <message>
        <source>range</source>
        <translation>område</translation>
    </message>
    <message>
        <source>clip what is negative</source>
        <translation>klipp bort negativt</translation>
    </message>
    <message>
        <source>Forces below zero become zero: a hammer only pushes, and noise does not</source>
        <translation>Krafter under noll blir noll: en hammare bara trycker, och det gör inte brus</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>skala</translation>
    </message>
    <message>
        <source>Scaling of all forces</source>
        <translation>Vad alla krafter multipliceras med</translation>
    </message>
    <message>
        <source>by a factor</source>
        <translation>med en faktor</translation>
    </message>
    <message>
        <source>to an impulse</source>
        <translation>till en impuls</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>faktor</translation>
    </message>
    <message>
        <source>All forces are multiplied by it</source>
        <translation>Alla krafter multipliceras med den</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>impuls</translation>
    </message>
    <message>
        <source>Wanted impulse of the signal</source>
        <translation>Som signalen ska ha</translation>
    </message>
    <message>
        <source>points at most</source>
        <translation>punkter högst</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>välj</translation>
    </message>
    <message>
        <source>The header has no known unit: choose the kind of signal and its unit.</source>
        <translation>Enheten i huvudet är inte känd, eller det finns ingen: välj vad signalen är, och dess enhet.</translation>
    </message>
    <message>
        <source>place x: not given: type the distance of the gauge from the struck end, because the time of a wave depends on it</source>
        <translation>läge x: inte angivet: en våg passerar varje tvärsnitt vid en annan tid; skriv hur långt givaren sitter från slagänden</translation>
    </message>
    <message>
        <source>place x: must not be less than 0, the struck end</source>
        <translation>läge x: får inte vara mindre än 0, slagänden</translation>
    </message>
    <message>
        <source>place x: must be at least %1, the rear of the hammer</source>
        <translation>läge x: måste vara minst %1, hammarens bakände</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>elektrisk spänning</translation>
    </message>
    <message>
        <source>stress</source>
        <translation>spänning</translation>
    </message>
    <message>
        <source>particle velocity</source>
        <translation>partikelhastighet</translation>
    </message>
    <message>
        <source>Largest number of points to keep. By default a blow keeps as many as needed for impulse and e to within 1e-4. The summary below gives the largest deviation.</source>
        <translation>Som behålls av mätvärdena; ett slag behåller så få att impuls och e är lika till 1e-4 tills du väljer ett antal. Hur långt de övriga är från linjerna emellan står nedan</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>som den är</translation>
    </message>
</context>
<context>
    <name>drillwave::SolveStatus</name>
    <message>
        <source>%1 was not written: %2</source>
        <translation>%1 skrevs inte: %2</translation>
    </message>
    <message>
        <source>solving was cancelled.</source>
        <translation>lösningen avbröts.</translation>
    </message>
    <message>
        <source>stopped · the result shown is not that of the present input</source>
        <translation>stoppad · det som visas hör inte till aktuella indata</translation>
    </message>
    <message>
        <source>solving … %1 waits for the result</source>
        <translation>löser … %1 väntar på resultatet</translation>
    </message>
    <message>
        <source>solving …</source>
        <translation>löser …</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Lös</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Solve the present input</source>
        <translation>Lös aktuella indata</translation>
    </message>
    <message>
        <source>Stops solving; the old result stays, marked as old</source>
        <translation>Sluta lösa; det gamla resultatet är kvar, märkt som sådant</translation>
    </message>
</context>
<context>
    <name>drillwave::StaleVeil</name>
    <message>
        <source>result of an earlier input</source>
        <translation>inte för aktuella indata</translation>
    </message>
</context>
<context>
    <name>drillwave::StringCellEditor</name>
    <message>
        <source>not given</source>
        <translation>inte angiven</translation>
    </message>
</context>
<context>
    <name>drillwave::StringDrawing</name>
    <message>
        <source>Drawing of hammer and string</source>
        <translation>Ritning av hammare och sträng</translation>
    </message>
    <message>
        <source>impedance Z %1 kN s/m</source>
        <translation>impedans Z %1 kN s/m</translation>
    </message>
    <message>
        <source>largest tension %1</source>
        <translation>största drag %1</translation>
    </message>
    <message>
        <source>largest compression %1</source>
        <translation>största tryck %1</translation>
    </message>
    <message>
        <source>after the blow, tension %1</source>
        <translation>efter slaget, drag %1</translation>
    </message>
    <message>
        <source>after the blow, compression %1</source>
        <translation>efter slaget, tryck %1</translation>
    </message>
    <message>
        <source>hammer</source>
        <translation>hammare</translation>
    </message>
    <message>
        <source>rock</source>
        <translation>berg</translation>
    </message>
    <message>
        <source>string</source>
        <translation>sträng</translation>
    </message>
    <message>
        <source>Lengths to scale, diameters × %1</source>
        <translation>Längder i skala, diametrar × %1</translation>
    </message>
    <message>
        <source>; upper half tension, lower half compression</source>
        <translation>; övre halvan drag, nedre halvan tryck</translation>
    </message>
    <message>
        <source>compression %1</source>
        <translation>tryck %1</translation>
    </message>
    <message>
        <source>tension %1</source>
        <translation>drag %1</translation>
    </message>
</context>
<context>
    <name>drillwave::StringEdits</name>
    <message>
        <source>section</source>
        <translation>sektion</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Lägg till</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicera</translation>
    </message>
    <message>
        <source>Duplicates the selected section, with its name</source>
        <translation>Sätt den valda sektionen dit en gång till, med sitt namn</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Removes the selected sections</source>
        <translation>Ta bort de valda sektionerna</translation>
    </message>
    <message>
        <source>Towards the hammer</source>
        <translation>Mot hammaren</translation>
    </message>
    <message>
        <source>Move the selected section one step towards the rear, into or out of a repeat</source>
        <translation>Flytta den valda sektionen ett steg bakåt, in i eller ut ur en upprepning</translation>
    </message>
    <message>
        <source>Towards the bit</source>
        <translation>Mot borrkronan</translation>
    </message>
    <message>
        <source>Move the selected section one step towards the bit, into or out of a repeat</source>
        <translation>Flytta den valda sektionen ett steg mot borrkronan, in i eller ut ur en upprepning</translation>
    </message>
    <message>
        <source>Repeat…</source>
        <translation>Upprepa…</translation>
    </message>
    <message>
        <source>Repeats the selected sections; inside a repeat, type the number of times</source>
        <translation>Låt de valda sektionerna följa på varandra flera gånger; skriv hur ofta i en upprepning</translation>
    </message>
    <message>
        <source>Like the selected one</source>
        <translation>Lik den valda</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Förval</translation>
    </message>
    <message>
        <source>Rods</source>
        <translation>Stänger</translation>
    </message>
    <message>
        <source>Hammer, instead of this one</source>
        <translation>Hammare, i stället för denna</translation>
    </message>
    <message>
        <source>Adapters</source>
        <translation>Nackadaptrar</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Skarvhylsor</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Borrkronor</translation>
    </message>
    <message>
        <source>From the example strings</source>
        <translation>Ur exempelsträngarna</translation>
    </message>
    <message>
        <source>%1 sections</source>
        <translation>%1 sektioner</translation>
    </message>
    <message>
        <source>a section</source>
        <translation>en sektion</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>lägg till %1</translation>
    </message>
    <message>
        <source>take the hammer %1</source>
        <translation>ta hammaren %1</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>duplicera %1</translation>
    </message>
    <message>
        <source>A hammer has at least one section.</source>
        <translation>En hammare har minst en sektion.</translation>
    </message>
    <message>
        <source>A string has at least one section.</source>
        <translation>En sträng har minst en sektion.</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>ta bort %1</translation>
    </message>
    <message>
        <source>remove %1 sections</source>
        <translation>ta bort %1 sektioner</translation>
    </message>
    <message>
        <source>move %1 towards the hammer</source>
        <translation>flytta %1 mot hammaren</translation>
    </message>
    <message>
        <source>move %1 towards the bit</source>
        <translation>flytta %1 mot borrkronan</translation>
    </message>
    <message>
        <source>Sections of the hammer stay in the hammer, sections of the string in the string.</source>
        <translation>Hammarens sektioner stannar i hammaren, strängens bakom den.</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>flytta %1</translation>
    </message>
    <message>
        <source>repeat %1</source>
        <translation>upprepa %1</translation>
    </message>
    <message>
        <source>Adds a section after the selected one: a copy, a preset or a section of the example strings. Adapters go to the shank, bits to the rock.</source>
        <translation>Sätt en sektion efter den valda: en likadan, ett förval eller en ur exempelsträngarna; efter den sista i en upprepning kommer den efter upprepningen; nackadaptrar hamnar först, borrkronor vid berget</translation>
    </message>
    <message>
        <source>Replace by preset</source>
        <translation>Ersätt med förval</translation>
    </message>
    <message>
        <source>Replace the selected sections by a preset</source>
        <translation>Sätt ett förval i stället för de valda sektionerna</translation>
    </message>
    <message>
        <source>replace %1 by %2</source>
        <translation>ersätta %1 med %2</translation>
    </message>
</context>
<context>
    <name>drillwave::StringModel</name>
    <message>
        <source>mass at
end</source>
        <translation>massa
bakom</translation>
    </message>
    <message>
        <source>attenu-
ation</source>
        <translation>av-
klingning</translation>
    </message>
    <message>
        <source>%1 at %2 from its rear end, %3</source>
        <translation>%1, %2 från änden mot hammaren, %3</translation>
    </message>
    <message>
        <source>These sections are repeated %1 times. Type another number; 1 removes the repeat.</source>
        <translation>Dessa sektioner kommer %1 gånger efter varandra. Skriv ett annat tal; 1 tar bort upprepningen.</translation>
    </message>
    <message>
        <source>Name of the section, also used in keys of parameters</source>
        <translation>Sektionens namn; även parametrar går efter det</translation>
    </message>
    <message>
        <source>Share of the hammer energy reflected by the joint after %1</source>
        <translation>Den andel av hammarens energi som skarven bakom %1 reflekterar av det som kommer från hammaren</translation>
    </message>
    <message>
        <source>
in the residual waves: %1</source>
        <translation>
av de vågor som slaget lämnar: %1</translation>
    </message>
    <message>
        <source>The hammer has no internal losses</source>
        <translation>Hammaren förlorar inget inuti</translation>
    </message>
    <message>
        <source>The section has a cross-section instead of diameters</source>
        <translation>Sektionen är given av sin tvärsnittsarea, inte av diametrar</translation>
    </message>
    <message>
        <source>H%1</source>
        <translation>H%1</translation>
    </message>
    <message>
        <source>Largest compression of the section during the blow</source>
        <translation>Största tryck i sektionen medan slaget varar</translation>
    </message>
    <message>
        <source>Largest tension of the section during the blow</source>
        <translation>Största drag i sektionen medan slaget varar</translation>
    </message>
    <message>
        <source>Share of the hammer energy reflected by the joint after the section; of a repeat, by the joint that reflects most</source>
        <translation>Den andel av hammarens energi som skarven bakom sektionen reflekterar av det som kommer från hammaren; i en upprepning av den skarv som reflekterar mest</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>antal</translation>
    </message>
    <message>
        <source>name</source>
        <translation>namn</translation>
    </message>
    <message>
        <source>compres-
sion</source>
        <translation>största
tryck</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>drag</translation>
    </message>
    <message>
        <source>joint
reflects</source>
        <translation>reflexion
i skarv</translation>
    </message>
    <message>
        <source>The name %1</source>
        <translation>Namnet %1</translation>
    </message>
    <message>
        <source>call %1 “%2”</source>
        <translation>kalla %1 ”%2”</translation>
    </message>
    <message>
        <source>A repeat is a whole number from 1 to %1</source>
        <translation>En upprepning är ett heltal från 1 till %1</translation>
    </message>
    <message>
        <source>remove the repeat of %1</source>
        <translation>ta bort upprepningen av %1</translation>
    </message>
    <message>
        <source>repeat %1 %2 times</source>
        <translation>upprepa %1 %2 gånger</translation>
    </message>
    <message>
        <source>%1: %2, of the fatigue strength of %3</source>
        <translation>%1: %2, av utmattningsgränsen på %3</translation>
    </message>
    <message>
        <source>%1: %2, of the yield strength of %3</source>
        <translation>%1: %2, av sträckgränsen på %3</translation>
    </message>
    <message>
        <source>Preset of the section; the name is removed when a number changes</source>
        <translation>Förvalet som sektionen kommer från; namnet försvinner när ett tal ändras</translation>
    </message>
    <message>
        <source>No strength is given</source>
        <translation>Ingen hållfasthet är angiven</translation>
    </message>
    <message>
        <source>Place in keys: %1</source>
        <translation>Plats i nycklar: %1</translation>
    </message>
    <message>
        <source>Largest stress during the blow as a share of the strength: tension over fatigue strength, or any stress over yield strength, whichever is larger</source>
        <translation>Största spänningen under slaget som andel av hållfastheten: drag av utmattningsgränsen, eller båda av sträckgränsen, vilket som är mer</translation>
    </message>
    <message>
        <source>Preset of the section</source>
        <translation>Förvalet som sektionen kommer från</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>förval</translation>
    </message>
    <message>
        <source>strength
used</source>
        <translation>utnytt-
jande</translation>
    </message>
    <message>
        <source>joint
loss</source>
        <translation>skarv-
förlust</translation>
    </message>
    <message>
        <source>diam-
eter</source>
        <translation>dia-
meter</translation>
    </message>
</context>
<context>
    <name>drillwave::StringPage</name>
    <message>
        <source>Stresses of uniform sections: threads and shoulders raise them locally</source>
        <translation>För likformiga sektioner: gängor och ansatser höjer spänningarna lokalt</translation>
    </message>
    <message>
        <source>Sections of hammer and string</source>
        <translation>Hammarens och strängens sektioner</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>Alla kolumner</translation>
    </message>
    <message>
        <source>Not solved: %1</source>
        <translation>Inte löst: %1</translation>
    </message>
    <message>
        <source>in %1, %2</source>
        <translation>i %1, %2</translation>
    </message>
    <message>
        <source>Largest tension %1; largest compression %2.</source>
        <translation>Största drag %1; största tryck %2.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>plats</translation>
    </message>
    <message>
        <source>&amp;Table of the sections…</source>
        <translation>&amp;Tabell över sektionerna…</translation>
    </message>
    <message>
        <source>Every section with its sizes and largest stresses, as CSV</source>
        <translation>Varje sektion med sina mått och största spänningar, som CSV</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Sträng</translation>
    </message>
    <message>
        <source>Find the value that gives…</source>
        <translation>Sök värdet som ger…</translation>
    </message>
    <message>
        <source>Also shows reflections of joints, presets, and the cross-section, Young&apos;s modulus, density, strengths, mass and attenuation of sections that have none of their own</source>
        <translation>Visar också skarvarnas reflexioner, förval samt tvärsnitt, elasticitetsmodul, densitet, hållfastheter, massa och avklingning för sektioner som inte har egna</translation>
    </message>
</context>
<context>
    <name>drillwave::StringSection</name>
    <message>
        <source>Closed forms and groups are for uniform rods only</source>
        <translation>Slutna former och dimensionslösa tal gäller likformiga stänger, och finns inte här</translation>
    </message>
    <message>
        <source>Sections…</source>
        <translation>Sektioner…</translation>
    </message>
    <message>
        <source>The page String: a drawing, and all sections in a table to edit</source>
        <translation>Sidan Sträng: en ritning, och alla sektioner i en tabell att redigera</translation>
    </message>
    <message>
        <source>may strike again</source>
        <translation>får slå flera gånger</translation>
    </message>
    <message>
        <source>Hammer: may strike again</source>
        <translation>Hammare: får slå flera gånger</translation>
    </message>
    <message>
        <source>The hammer may be hit again by the string; otherwise it is withdrawn after the first separation</source>
        <translation>Hammaren stannar där strängen kan möta den igen; annars dras den tillbaka när de har skilts åt</translation>
    </message>
    <message>
        <source>let the hammer strike again</source>
        <translation>låt hammaren slå flera gånger</translation>
    </message>
    <message>
        <source>withdraw the hammer</source>
        <translation>dra tillbaka hammaren</translation>
    </message>
    <message>
        <source>; hammer %1, %2</source>
        <translation>; hammare %1, %2</translation>
    </message>
</context>
<context>
    <name>drillwave::StringSketch</name>
    <message>
        <source>position x from the struck end, hammer at x &lt; 0</source>
        <translation>läge x från slagänden, hammaren vid x &lt; 0</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diameter</translation>
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
        <translation>&amp;Kopiera som kommandorad</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>&amp;Avbryt</translation>
    </message>
</context>
<context>
    <name>drillwave::StudyPage</name>
    <message>
        <source>Copy as command line</source>
        <translation>Kopiera som kommandorad</translation>
    </message>
    <message>
        <source>Copies the command that writes the same numbers as CSV</source>
        <translation>Kommandot som skriver samma tal som CSV, för en terminal</translation>
    </message>
    <message>
        <source>&amp;Data of this study…</source>
        <translation>&amp;Data i denna studie…</translation>
    </message>
    <message>
        <source>The numbers of the study, as CSV</source>
        <translation>Studiens tal, som CSV</translation>
    </message>
    <message>
        <source>The study was stopped before its end.</source>
        <translation>Studien stoppades före slutet.</translation>
    </message>
    <message>
        <source>The study is not finished yet.</source>
        <translation>Studien är inte färdig än.</translation>
    </message>
    <message>
        <source>%1 set to %2</source>
        <translation>%1 satt till %2</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Inställningar</translation>
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
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Studiens framsteg</translation>
    </message>
    <message>
        <source>Stops the study; the points found so far stay</source>
        <translation>Stoppa studien; punkter som den har funnit är kvar</translation>
    </message>
    <message>
        <source>%1 stopped</source>
        <translation>%1 stoppad</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>stoppad</translation>
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
        <translation>Lös allt</translation>
    </message>
    <message>
        <source>Solve all (%1)</source>
        <translation>Lös allt (%1)</translation>
    </message>
    <message>
        <source>Runs the study again to its end, whatever time it takes</source>
        <translation>Kör studien igen till slutet, hur lång tid det än tar</translation>
    </message>
    <message>
        <source>%1 stopped after %2 s</source>
        <translation>%1 stoppad efter %2 s</translation>
    </message>
    <message>
        <source>stopped after %1 s</source>
        <translation>stoppad efter %1 s</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 kvar</translation>
    </message>
</context>
<context>
    <name>drillwave::TabStrip</name>
    <message>
        <source>Pages</source>
        <translation>Sidor</translation>
    </message>
</context>
<context>
    <name>drillwave::TableFields</name>
    <message>
        <source>column %1</source>
        <translation>kolumn %1</translation>
    </message>
    <message>
        <source>separator</source>
        <translation>skiljetecken</translation>
    </message>
    <message>
        <source>Character between the cells</source>
        <translation>Vad som står mellan cellerna</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabb</translation>
    </message>
    <message>
        <source>semicolon ;</source>
        <translation>semikolon ;</translation>
    </message>
    <message>
        <source>comma ,</source>
        <translation>komma ,</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>blanksteg</translation>
    </message>
    <message>
        <source>decimal sign</source>
        <translation>decimaltecken</translation>
    </message>
    <message>
        <source>Decimal sign of the numbers</source>
        <translation>Vad som står före ett tals decimaler</translation>
    </message>
    <message>
        <source>point 1.5</source>
        <translation>punkt 1.5</translation>
    </message>
    <message>
        <source>comma 1,5</source>
        <translation>komma 1,5</translation>
    </message>
    <message>
        <source>samples from line</source>
        <translation>mätvärden från rad</translation>
    </message>
    <message>
        <source>First line with a sample</source>
        <translation>Filens första rad som är ett mätvärde</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tid</translation>
    </message>
    <message>
        <source>The column of times, or none</source>
        <translation>Kolumnen med tider, eller ingen</translation>
    </message>
    <message>
        <source>unit of time</source>
        <translation>tidens enhet</translation>
    </message>
    <message>
        <source>Unit of the times</source>
        <translation>Vad tiderna är angivna i</translation>
    </message>
    <message>
        <source>sampling rate</source>
        <translation>samplingsfrekvens</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Mätvärden per sekund</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>signal</translation>
    </message>
    <message>
        <source>The column of the signal</source>
        <translation>Kolumnen med signalen</translation>
    </message>
    <message>
        <source>mean with</source>
        <translation>medel med</translation>
    </message>
    <message>
        <source>A second gauge on the other side of the bar: the mean is free of bending</source>
        <translation>En andra givare på stångens andra sida: medelvärdet är fritt från böjning</translation>
    </message>
    <message>
        <source>rows without number</source>
        <translation>rader utan tal</translation>
    </message>
    <message>
        <source>Empty cells, NaN and words: refuse the file, or skip and count the rows</source>
        <translation>Tomma celler, NaN, ord: om de stoppar importen eller utelämnas</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>vägra</translation>
    </message>
    <message>
        <source>skip and count</source>
        <translation>hoppa över, räkna</translation>
    </message>
    <message>
        <source>no other gauge</source>
        <translation>ingen annan givare</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>jämnt fördelat</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>välj</translation>
    </message>
    <message>
        <source>The file is empty, or no text.</source>
        <translation>Filen är tom, eller ingen text.</translation>
    </message>
    <message>
        <source>No line of numbers is found in the first %1 lines with this separator and decimal sign: choose others, or the first line with a sample. Remove a longer header from the file.</source>
        <translation>Ingen rad med tal hittas i de första %1 raderna med detta skiljetecken och decimaltecken: välj andra, eller raden där mätvärdena börjar; ett längre huvud får klippas bort ur filen.</translation>
    </message>
    <message>
        <source>Time and signal are the same column: choose another one, or a sampling rate.</source>
        <translation>Tid och signal är samma kolumn: välj en annan, eller en samplingsfrekvens.</translation>
    </message>
    <message>
        <source>The second gauge is a column that is used already: choose another one.</source>
        <translation>Den andra givaren är en kolumn som redan används: välj en annan.</translation>
    </message>
    <message>
        <source>unit of time: not given in the table: choose one.</source>
        <translation>tidens enhet: tabellen anger den inte: välj en.</translation>
    </message>
    <message>
        <source>unit of time: %1 is not known: choose one.</source>
        <translation>tidens enhet: %1 är inte känd: välj en.</translation>
    </message>
    <message>
        <source>sampling rate: %1</source>
        <translation>samplingsfrekvens: %1</translation>
    </message>
    <message>
        <source>bar |</source>
        <translation>streck |</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>inte angivet</translation>
    </message>
    <message>
        <source>Each channel of this table is a row: turn rows into columns in a spreadsheet, or read it by drillwave signal -o.</source>
        <translation>Varje kanal i tabellen är en rad: gör kolumner av raderna i ett kalkylprogram, eller läs den med drillwave signal -o.</translation>
    </message>
    <message>
        <source>decimal sign: 1,234 and 1.234 can be a decimal number or a thousand: choose the sign.</source>
        <translation>decimaltecken: 1,234 och 1.234 kan vara ett tal med decimaler eller ett tusental: välj tecknet.</translation>
    </message>
    <message>
        <source>sampling rate: the table gives “%1” without a unit: type the rate.</source>
        <translation>samplingsfrekvens: i tabellen står ”%1” utan enhet: ange frekvensen.</translation>
    </message>
    <message>
        <source>sampling rate: not given in the table: type it.</source>
        <translation>samplingsfrekvens: den står inte i tabellen: ange den.</translation>
    </message>
</context>
<context>
    <name>drillwave::TableNotice</name>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Läs om</translation>
    </message>
    <message>
        <source>Read the hammer blow from the file again; Undo brings the present one back</source>
        <translation>Läs hammarslaget från filen igen; Ångra tar tillbaka det aktuella</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Behåll mitt</translation>
    </message>
    <message>
        <source>Continue with the points read before</source>
        <translation>Fortsätt med de punkter som lästes tidigare</translation>
    </message>
    <message>
        <source>%1, the hammer blow of this scenario, has been changed by another program.</source>
        <translation>%1, hammarslaget i detta scenario, har ändrats av ett annat program.</translation>
    </message>
    <message>
        <source>%1, the hammer blow of this scenario, has been deleted or moved. Its points are still here, but the scenario cannot be opened without the file.</source>
        <translation>%1, hammarslaget i detta scenario, har tagits bort eller flyttats. Dess punkter finns kvar här, men scenariot kan inte öppnas utan filen.</translation>
    </message>
    <message>
        <source>The hammer blow cannot be read again.</source>
        <translation>Hammarslaget kan inte läsas igen.</translation>
    </message>
</context>
<context>
    <name>drillwave::TakenNotice</name>
    <message>
        <source>Undo</source>
        <translation>Ångra</translation>
    </message>
    <message>
        <source>Undo this change</source>
        <translation>Ta tillbaka värdet</translation>
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
        <translation>dimensionslös</translation>
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
        <translation>&amp;Enheter</translation>
    </message>
    <message>
        <source>&amp;SI</source>
        <translation>&amp;SI</translation>
    </message>
    <message>
        <source>&amp;US customary</source>
        <translation>&amp;US-enheter</translation>
    </message>
    <message>
        <source>&amp;Dimensionless</source>
        <translation>&amp;Dimensionslös</translation>
    </message>
    <message>
        <source>Units of fields, results and plots</source>
        <translation>Enheter för fält, resultat och diagram</translation>
    </message>
    <message>
        <source>as in the system selected</source>
        <translation>som i det valda systemet</translation>
    </message>
    <message>
        <source>This scenario is dimensionless: it has no physical values.</source>
        <translation>Detta scenario är dimensionslöst: det har inga fysikaliska värden.</translation>
    </message>
    <message>
        <source>Units: %1</source>
        <translation>Enheter: %1</translation>
    </message>
</context>
<context>
    <name>drillwave::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>&amp;Fit plots</source>
        <translation>&amp;Anpassa diagrammen</translation>
    </message>
</context>
<context>
    <name>drillwave::WavePicturePage</name>
    <message>
        <source>Fronts</source>
        <translation>Fronter</translation>
    </message>
    <message>
        <source>Section shown by the dashed line, also used on the page Blow: 0 is the struck end, 1 the bit.</source>
        <translation>Den streckade linjen: var i stången vågorna på sidan Slag betraktas; 0 är slagänden, 1 borrkronan.</translation>
    </message>
    <message>
        <source>Waves in the rod over position and time</source>
        <translation>Vågor i stången över läge och tid</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>Kraft N</translation>
    </message>
    <message>
        <source>Particle velocity v</source>
        <translation>Partikelhastighet v</translation>
    </message>
    <message>
        <source>Quantity shown by the colours</source>
        <translation>Vad färgerna visar</translation>
    </message>
    <message>
        <source>Normal force (tension positive) or particle velocity (towards the rock positive)</source>
        <translation>Normalkraft (drag positivt) eller partikelhastighet (mot berget positivt)</translation>
    </message>
    <message>
        <source>Lines that start where the hammer force begins (solid), jumps or ends (dashed), and move at the wave speed</source>
        <translation>Linjer där hammarkraften börjar (heldragna), hoppar eller slutar (streckade), som löper med våghastigheten</translation>
    </message>
    <message>
        <source>Section x/L</source>
        <translation>Läge x/L</translation>
    </message>
    <message>
        <source>Value at the pointer</source>
        <translation>Värde vid pekaren</translation>
    </message>
    <message>
        <source>Bring the whole blow into view (double-click in the picture)</source>
        <translation>Visa hela slaget (dubbelklick i bilden)</translation>
    </message>
    <message>
        <source>Nothing to show: %1</source>
        <translation>Inget att visa: %1</translation>
    </message>
    <message>
        <source>Nothing to show: there are too many waves to keep.</source>
        <translation>Inget att visa: så många vågor att de inte sparas.</translation>
    </message>
    <message>
        <source>Wave picture</source>
        <translation>Vågbild</translation>
    </message>
</context>
<context>
    <name>drillwave::WavePicturePlot</name>
    <message>
        <source>force N (tension positive)</source>
        <translation>kraft N (drag positivt)</translation>
    </message>
    <message>
        <source>particle velocity v (towards the rock positive)</source>
        <translation>partikelhastighet v (mot berget positivt)</translation>
    </message>
    <message>
        <source>position x from the struck end, hammer at x &lt; 0</source>
        <translation>läge x från slagänden, hammaren vid x &lt; 0</translation>
    </message>
    <message>
        <source>position x from the struck end</source>
        <translation>läge x från slagänden</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>tid t</translation>
    </message>
    <message>
        <source>x = %1 · t = %2 · %3 = %4</source>
        <translation>x = %1 · t = %2 · %3 = %4</translation>
    </message>
    <message>
        <source>%1 into %2 · t = %3</source>
        <translation>%1 in i %2 · t = %3</translation>
    </message>
    <message>
        <source> · after the computed time</source>
        <translation> · senare än slaget följdes</translation>
    </message>
    <message>
        <source> · N = %1 · σ = %2 · v = %3</source>
        <translation> · N = %1 · σ = %2 · v = %3</translation>
    </message>
    <message>
        <source>%1 in this view: from %2 to %3</source>
        <translation>%1 i vyn: från %2 till %3</translation>
    </message>
    <message>
        <source> · colours end at ±%1</source>
        <translation> · färgerna slutar vid ±%1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>från %1 till %2</translation>
    </message>
    <message>
        <source>Picture of %1 over position and time from %2 to %3, up to %4. %5: %6%7.</source>
        <translation>Bild: %1 över läge och tid från %2 till %3, upp till %4. %5: %6%7.</translation>
    </message>
    <message>
        <source>1 contact of bit and rock</source>
        <translation>1 kontakt mellan borrkrona och berg</translation>
    </message>
    <message>
        <source>%1 contacts of bit and rock</source>
        <translation>%1 kontakter mellan borrkrona och berg</translation>
    </message>
    <message>
        <source> and so on</source>
        <translation> och så vidare</translation>
    </message>
    <message>
        <source>fronts: — start, - - end of a wave</source>
        <translation>fronter: — början, - - slutet av en våg</translation>
    </message>
    <message>
        <source>fronts: — start, - - end of a wave; p towards the bit, n back</source>
        <translation>fronter: — början, - - slutet av en våg; p mot kronan, n tillbaka</translation>
    </message>
</context>
<context>
    <name>drillwave::WavesNotice</name>
    <message>
        <source>Round the lengths</source>
        <translation>Avrunda längderna</translation>
    </message>
    <message>
        <source>Round the lengths of all sections to 10 mm</source>
        <translation>Avrunda alla sektioners längder till 10 mm</translation>
    </message>
    <message>
        <source>round the lengths</source>
        <translation>avrunda längderna</translation>
    </message>
    <message>
        <source>This blow has too many waves to keep, so this page shows those of a coarser string. Rounding lengths to 10 mm can show them in full: %1.</source>
        <translation>Slaget har för många vågor för att alla ska kunna sparas: sidan visar vågorna i en grövre indelad sträng. Med längder avrundade till 10 mm kan alla visas: %1.</translation>
    </message>
</context>
<context>
    <name>drillwave::WindowLayout</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Åte&amp;rställ layouten</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>Usage: drillwave [FILE]             open the window (scenario, result, example)
       drillwave COMMAND ARGUMENTS  work without a window

Commands:
</source>
        <translation>Användning: drillwave [FILE]             öppna fönstret (scenario, resultat, exempel)
            drillwave COMMAND ARGUMENTS  arbeta utan fönster

Kommandon:
</translation>
    </message>
    <message>
        <source>FILE is a scenario, a result file that contains its scenario (summary.json, histories.csv,
map.csv.yaml …), the name of a built-in example, or - for standard input.</source>
        <translation>FILE är ett scenario, en resultatfil som innehåller sitt scenario (summary.json, histories.csv,
map.csv.yaml …), namnet på ett inbyggt exempel, eller - för standard in.</translation>
    </message>
    <message>
        <source>0 done, 1 internal error or out of memory, 2 wrong command line, 3 input cannot be read,
4 output cannot be written, 5 scenario invalid, 6 a case could not be solved, 130 interrupted</source>
        <translation>0 klart, 1 internt fel eller minnesbrist, 2 felaktig kommandorad, 3 indata kan inte läsas,
4 utdata kan inte skrivas, 5 ogiltigt scenario, 6 ett fall kunde inte lösas, 130 avbrutet</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>Flaggor:</translation>
    </message>
    <message>
        <source>print this help</source>
        <translation>skriv ut denna hjälp</translation>
    </message>
    <message>
        <source>solve one blow; print a summary, write histories, events and plots</source>
        <translation>lös ett slag; skriv en sammanfattning, förlopp, händelser och diagram</translation>
    </message>
    <message>
        <source>change parameters of the scenario, such as rod.length=4.27m beta=0.8</source>
        <translation>ändra scenariots parametrar, t.ex. rod.length=4.27m beta=0.8</translation>
    </message>
    <message>
        <source>use the rod of this preset; `drillwave presets` lists rods, hammers and rocks</source>
        <translation>använd stången i detta förval; `drillwave presets` listar stänger, hammare och berg</translation>
    </message>
    <message>
        <source>use the hammer of this preset</source>
        <translation>använd hammaren i detta förval</translation>
    </message>
    <message>
        <source>use the rock of this preset</source>
        <translation>använd berget i detta förval</translation>
    </message>
    <message>
        <source>with -o, also write plots in these formats</source>
        <translation>med -o: skriv även diagram i dessa format</translation>
    </message>
    <message>
        <source>with -o, write CSV columns in SI (default for scenarios with units)</source>
        <translation>med -o: skriv CSV-kolumner i SI-enheter (standard för scenarier med enheter)</translation>
    </message>
    <message>
        <source>with -o, write CSV columns in dimensionless form</source>
        <translation>med -o: skriv CSV-kolumner dimensionslöst</translation>
    </message>
    <message>
        <source>overwrite existing files</source>
        <translation>skriv över befintliga filer</translation>
    </message>
    <message>
        <source>use German (de), Swedish (sv) or English (en)</source>
        <translation>skriv på tyska (de), svenska (sv) eller engelska (en)</translation>
    </message>
    <message>
        <source>solve one blow for every combination of parameter values, one CSV row each</source>
        <translation>lös ett slag för varje kombination av parametervärden, en CSV-rad per slag</translation>
    </message>
    <message>
        <source>Solves one blow for every combination of the --vary values. Each combination is one row; the
parameter given last varies fastest. Values carry units where the parameter has one: --vary
rod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine
FILE.csv.yaml beside FILE.csv records version, command, varied parameters and scenario. --plots
can draw one or two varied parameters. The parameter with more values is the horizontal axis; each
value of the other parameter gives a curve.</source>
        <translation>Löser ett slag för varje kombination av värdena i --vary. Varje kombination är en rad; den sist
angivna parametern varierar snabbast. Värden anges med enhet där parametern har en: --vary
rod.length=3m:6m:4 --vary pulse.shape=rectangular,half_sine
FILE.csv.yaml bredvid FILE.csv innehåller version, kommando, varierade parametrar och scenario.
--plots kan rita en eller två varierade parametrar. Parametern med fler värden är den vågräta
axeln; varje värde på den andra parametern ger en kurva.</translation>
    </message>
    <message>
        <source>write outputs in SI, with units in the header</source>
        <translation>skriv resultat i SI-enheter, angivna i huvudet</translation>
    </message>
    <message>
        <source>split the rows into N parts and solve only part I; `drillwave join` combines the parts; only part 1 has a header</source>
        <translation>dela raderna i N delar och lös bara del I; `drillwave join` sätter ihop delarna; bara del 1 har rubrikrad</translation>
    </message>
    <message>
        <source>with -o, also write the plots that the window would show, as png, svg or pdf</source>
        <translation>med -o: skriv även de diagram som fönstret skulle visa, som png, svg eller pdf</translation>
    </message>
    <message>
        <source>solve every row of a table of cases; write its columns and the outputs</source>
        <translation>lös varje rad i en tabell med fall; skriv dess kolumner och resultaten</translation>
    </message>
    <message>
        <source>CASES.csv is a table with one case in each row. Its header names parameters, with a unit in
brackets, as in rod.length [m], or with units in the cells. An empty cell keeps the value of FILE.
Columns that are not parameters are copied to the output. CASES can be - (standard input) or a
pipe. FILE.csv.yaml beside FILE.csv records version, command and scenario.</source>
        <translation>CASES.csv är en tabell med ett fall per rad. Huvudet anger parametrar, med en enhet inom
hakparentes, som i rod.length [m], eller med enheter i cellerna. En tom cell behåller värdet i
FILE. Kolumner som inte är parametrar förs över till utdata. CASES kan vara - (standard in) eller
ett rör (pipe). FILE.csv.yaml bredvid FILE.csv innehåller version, kommando och scenario.</translation>
    </message>
    <message>
        <source>vary one parameter: extremes, kinks and jumps of outputs, and where they reach a goal, with errors</source>
        <translation>variera en parameter: extremvärden, knän och språng hos utdata och var de når ett mål, med fel</translation>
    </message>
    <message>
        <source>parameter to follow continuously from START to STOP; with :log, its axis is logarithmic</source>
        <translation>parameter som följs kontinuerligt från START till STOP; med :log är dess axel logaritmisk</translation>
    </message>
    <message>
        <source>vary this parameter, with one curve for each value; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C</source>
        <translation>variera denna parameter, med en kurva för varje värde; VALUES är START:STOP:COUNT, START:STOP:COUNT:log (lika förhållanden) eller A,B,C</translation>
    </message>
    <message>
        <source>also print where an output crosses this value; give the value in the unit of the output&apos;s column</source>
        <translation>skriv även ut var ett resultat korsar detta värde; ange värdet i enheten för resultatets kolumn</translation>
    </message>
    <message>
        <source>print each parameter value at which the output is X. X is in the unit of the output&apos;s column. Exit code 6 if there is no such value</source>
        <translation>skriv varje värde på parametern där resultatet är X. X är i enheten för resultatets kolumn. Slutkod 6 om inget sådant värde finns</translation>
    </message>
    <message>
        <source>print and write outputs in SI</source>
        <translation>skriv resultat i SI-enheter</translation>
    </message>
    <message>
        <source>also write the curve to FILE.csv, the settings to FILE.csv.yaml and the --goal values to FILE_goal.csv; -o - prints the points instead of the tables</source>
        <translation>skriv även kurvan till FILE.csv, inställningarna till FILE.csv.yaml och värdena från --goal till FILE_goal.csv; -o - skriver ut punkterna i stället för tabellerna</translation>
    </message>
    <message>
        <source>map one output over two parameters, with contours</source>
        <translation>karta av ett resultat över två parametrar, med nivåkurvor</translation>
    </message>
    <message>
        <source>Solves the output at every point of a grid of two parameters. FILE.csv has one row for each point,
with the same columns as from `drillwave sweep`; --y varies fastest. With --level X, also finds
the contour on which the output is X. Each point of a contour lies between two neighbouring grid
points and is solved for, not interpolated. FILE_contours.csv lists these points, how near to X
each one is, and where the output jumps over X.</source>
        <translation>Löser resultatet i varje punkt i ett rutnät av två parametrar. FILE.csv har en rad per punkt, med
samma kolumner som från `drillwave sweep`; --y varierar snabbast. Med --level X bestäms även
nivåkurvan där resultatet är X. Varje punkt på en nivåkurva ligger mellan två närliggande
rutnätspunkter och beräknas av lösaren, inte genom interpolation. FILE_contours.csv anger dessa
punkter, hur nära X var och en ligger, och var resultatet hoppar över X.</translation>
    </message>
    <message>
        <source>vary this parameter on the horizontal axis; VALUES is START:STOP:COUNT or START:STOP:COUNT:log (equal ratios)</source>
        <translation>variera denna parameter på den vågräta axeln; VALUES är START:STOP:COUNT eller START:STOP:COUNT:log (lika förhållanden)</translation>
    </message>
    <message>
        <source>vary this parameter on the vertical axis; VALUES is START:STOP:COUNT or START:STOP:COUNT:log (equal ratios)</source>
        <translation>variera denna parameter på den lodräta axeln; VALUES är START:STOP:COUNT eller START:STOP:COUNT:log (lika förhållanden)</translation>
    </message>
    <message>
        <source>find the contour on which the output has this value; may be repeated</source>
        <translation>bestäm nivåkurvan där resultatet har detta värde; kan anges flera gånger</translation>
    </message>
    <message>
        <source>use SI units for the output and for the value of --level, which may then carry a unit</source>
        <translation>använd SI-enheter för resultatet och för värdet i --level, som då får ha enhet</translation>
    </message>
    <message>
        <source>also write the map to FILE.csv, its settings to FILE.csv.yaml and its contours to FILE_contours.csv; -o - prints the points instead of the summary</source>
        <translation>skriv även kartan till FILE.csv, dess inställningar till FILE.csv.yaml och dess nivåkurvor till FILE_contours.csv; -o - skriver ut punkterna i stället för sammanfattningen</translation>
    </message>
    <message>
        <source>combine the parts of a sweep, table or map that were solved with --shard</source>
        <translation>sätt ihop de delar av sweep, table eller map som --shard har delat upp</translation>
    </message>
    <message>
        <source>write FILE and its description FILE.yaml; -o - prints the file instead</source>
        <translation>skriv FIL och beskrivningen FIL.yaml; -o - skriver ut filen i stället</translation>
    </message>
    <message>
        <source>restitution, forces and efficiency for all gaps between bit and rock</source>
        <translation>studstal, krafter och verkningsgrad för alla spalter mellan borrkrona och berg</translation>
    </message>
    <message>
        <source>Prints how the results depend on the gap between bit and rock at the start of the blow. Nobody
controls this gap at the rig. The results repeat each time the gap grows by d0 = 2 I0/Z (I0:
impulse of the blow, Z: impedance of the rod). All gaps within d0 therefore count as equally
likely. Prints minima and maxima with their gaps, mean, and 5, 50 and 95 % quantiles. Also prints
the share of gaps with a coefficient of restitution e above 1. --gap-deviation adds the same for a
normally distributed gap, cut off below zero.</source>
        <translation>Skriver ut hur resultaten beror på spalten mellan borrkrona och berg när slaget börjar. På riggen
styr ingen denna spalt. Resultaten upprepas varje gång spalten växer med d0 = 2 I0/Z (I0: slagets
impuls, Z: stångens impedans). Därför räknas alla spalter inom d0 som lika sannolika. Skriver
minima och maxima med sina spalter, medelvärde, 5-, 50- och 95&#xa0;%-kvantiler och andelen spalter med
ett studstal e över 1. --gap-deviation lägger till detsamma för en normalfördelad spalt, avskuren
under noll.</translation>
    </message>
    <message>
        <source>also print results for a normally distributed gap with this standard deviation</source>
        <translation>skriv även ut resultat för ett normalfördelat spel med denna standardavvikelse</translation>
    </message>
    <message>
        <source>also write the results at each gap to FILE.csv; -o - prints them instead of the table</source>
        <translation>skriv även resultaten vid varje spalt till FILE.csv; -o - skriver ut dem i stället för tabellen</translation>
    </message>
    <message>
        <source>with -o, write columns in SI, with units in the header</source>
        <translation>med -o: skriv kolumner i SI-enheter, angivna i huvudet</translation>
    </message>
    <message>
        <source>number of first blows (transient blows) that the statistics exclude: short for --set drill.settle=N</source>
        <translation>antal första slag (insvängning) som statistiken utesluter: kortform för --set drill.settle=N</translation>
    </message>
    <message>
        <source>seed of the random intervals between blows: short for --set drill.seed=N</source>
        <translation>startvärde för de slumpmässiga slagintervallen: kortform för --set drill.seed=N</translation>
    </message>
    <message>
        <source>vary this parameter and compare its values; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C, with units</source>
        <translation>variera denna parameter och jämför dess värden; VALUES är START:STOP:COUNT, START:STOP:COUNT:log (lika förhållanden) eller A,B,C, med enheter</translation>
    </message>
    <message>
        <source>with --scan, also write the gap between bit and rock at the start of each blow to this file, without transient blows</source>
        <translation>med --scan: skriv även spalten mellan krona och berg när varje slag börjar till denna fil, utom för insvängningen</translation>
    </message>
    <message>
        <source>with -o DIR, also write the motion and forces over time from blow A to blow B</source>
        <translation>med -o DIR: skriv även rörelse och krafter över tiden från slag A till slag B</translation>
    </message>
    <message>
        <source>print dimensionless numbers: multiples of the scales d0, v0, I0, F0 and t0 of a blow (`drillwave help glossary 2`)</source>
        <translation>skriv dimensionslösa tal: multiplar av ett slags skalor d0, v0, I0, F0 och t0 (`drillwave help glossary 2`)</translation>
    </message>
    <message>
        <source>FILE.csv: also write one row per blow, with the settings in FILE.csv.yaml; DIR: write all files of the run into DIR; -o - prints the rows</source>
        <translation>FILE.csv: skriv även en rad per slag, med inställningarna i FILE.csv.yaml; DIR: skriv alla körningens filer till DIR; -o - skriver ut raderna</translation>
    </message>
    <message>
        <source>vary the blow frequency: short for --along drill.blow_frequency=VALUES</source>
        <translation>variera slagfrekvensen: kortform för --along drill.blow_frequency=VALUES</translation>
    </message>
    <message>
        <source>also write the table of --along to FILE.csv; -o - prints this CSV instead of the tables</source>
        <translation>skriv även tabellen från --along till FILE.csv; -o - skriver ut denna CSV i stället för tabellerna</translation>
    </message>
    <message>
        <source>find the best design for uncertain inputs, and which input to measure</source>
        <translation>hitta den bästa konstruktionen vid osäkra storheter, och vad som bör mätas</translation>
    </message>
    <message>
        <source>uncertain input and the range of its values; see the description of the command</source>
        <translation>osäker storhet och området för dess värden; se beskrivningen av kommandot</translation>
    </message>
    <message>
        <source>take the samples of uncertain inputs from this table, one per row; its header names parameters</source>
        <translation>ta stickproven av osäkra storheter ur denna tabell, ett per rad; dess huvud anger parametrar</translation>
    </message>
    <message>
        <source>statistic of an output to maximise, or with min:… to minimise; up to three; the designs are ranked by the first</source>
        <translation>statistik av ett resultat att maximera, eller med min:… minimera; upp till tre; konstruktionerna rangordnas efter den första</translation>
    </message>
    <message>
        <source>give every design the blow energy of FILE, by scaling its impulse or hammer velocity</source>
        <translation>ge varje konstruktion slagenergin i FILE, genom att skala impuls eller hammarhastighet</translation>
    </message>
    <message>
        <source>also write the tables, the scenario of the best design and the JSON object into DIR</source>
        <translation>skriv även tabellerna, den bästa konstruktionens scenario och JSON-objektet till DIR</translation>
    </message>
    <message>
        <source>write a report: inputs with sources, results, verdict, plots, scenario</source>
        <translation>en sida att lämna över: indata med källor, resultat, omdöme, diagram, scenariot</translation>
    </message>
    <message>
        <source>name of the project, shown below the title</source>
        <translation>projektets namn, står under titeln</translation>
    </message>
    <message>
        <source>author</source>
        <translation>vem som har skrivit den</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>vem den är avsedd för</translation>
    </message>
    <message>
        <source>file or folder to write the report to; -o - prints the HTML</source>
        <translation>fil eller mapp för rapporten; -o - skriver ut HTML-texten</translation>
    </message>
    <message>
        <source>reproduce the figures of the paper on which the model is based; compare each number printed there with the exact one</source>
        <translation>återge figurerna i den artikel som modellen bygger på; jämför varje tryckt tal med det exakta</translation>
    </message>
    <message>
        <source>folder to write into; -o - prints only discrepancies.csv (printed and exact numbers of the paper)</source>
        <translation>mapp att skriva i; -o - skriver bara ut discrepancies.csv (artikelns tryckta tal och de exakta)</translation>
    </message>
    <message>
        <source>compare error and run time of every method and resolution</source>
        <translation>jämför fel och beräkningstid för alla metoder och upplösningar</translation>
    </message>
    <message>
        <source>Solves the blow exactly, in closed form if it applies, and numerically with the rod divided into
100 to 20000 segments (lattice). Compares errors and run times, which takes some ten seconds. For
drill strings, compares the solver of this program at several cell sizes with a lattice of
constant cells.</source>
        <translation>Löser slaget exakt, i sluten form om den gäller, och numeriskt med stången delad i 100 till
20000 segment (gitter). Jämför fel och beräkningstider, vilket tar omkring tio sekunder. För en
borrsträng jämförs programmets metod vid flera cellstorlekar med ett gitter av konstanta
celler.</translation>
    </message>
    <message>
        <source>also write the table to accuracy.csv in DIR; -o - prints this CSV instead of the table</source>
        <translation>skriv även tabellen till accuracy.csv i DIR; -o - skriver ut denna CSV i stället för tabellen</translation>
    </message>
    <message>
        <source>check the solver on stiff and extreme cases</source>
        <translation>kontrollera lösaren på styva och extrema fall</translation>
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
        <translation>Löser några tusen fall: publicerade fall, numeriskt svåra fall, varje parameter genom hela sitt
område och kombinationer av extremvärden för varje slagform. Kontrollerar i varje fall att
rörelsemängd och energi balanserar, att berget inte drar och att ingen kontakt missades. Kontrollerar
även att e knappt ändras om en parameter ändras med 1e-10. Jämför resultaten med gränsfallen mjukt
och stelt berg och, om dess tidssteg är korta nog, med gittermetoden. Jämför det angivna felet med en
lösning med högre precision (long double). Slutkod 6 om någon kontroll underkänns.
Två områden ingår inte, eftersom den exakta metoden skulle dela vågorna i mer än 30 miljoner
bitar. De är beta under 1e-6 med gamma under 1, och tau under 0,1 med exponentiella slag och
kolvslag.</translation>
    </message>
    <message>
        <source>print one JSON object with all cases</source>
        <translation>skriv ut ett JSON-objekt med alla fall</translation>
    </message>
    <message>
        <source>write a table of all cases to stability.csv in DIR; -o - prints it instead of the summary</source>
        <translation>skriv en tabell över alla fall till stability.csv i DIR; -o - skriver ut den i stället för sammanfattningen</translation>
    </message>
    <message>
        <source>list the errors of scenario files, one per line</source>
        <translation>lista felen i scenariofiler, ett per rad</translation>
    </message>
    <message>
        <source>Checks scenario files and preset files. Prints one line for each error, and nothing for a file without errors.</source>
        <translation>Kontrollerar scenariofiler och filer med förval. Skriver en rad för varje fel, och inget för en fil utan fel.</translation>
    </message>
    <message>
        <source>write the scenarios into DIR, one file each; -o - prints them</source>
        <translation>skriv scenarierna till DIR, en fil var; -o - skriver ut dem</translation>
    </message>
    <message>
        <source>list rods, hammers, rocks and sections of drill strings, with their sources</source>
        <translation>lista stänger, hammare, berg och sektioner till borrsträngar, med sina källor</translation>
    </message>
    <message>
        <source>list only presets with all of these words in kind, name, numbers or source, such as &quot;T38 bit&quot;</source>
        <translation>lista bara förval med alla dessa ord i typ, namn, tal eller källa, t.ex. &quot;T38 bit&quot;</translation>
    </message>
    <message>
        <source>mean gap between bit and rock at the start of the blows, from `drill`</source>
        <translation>medelspalt mellan borrkrona och berg när slagen börjar, från `drill`</translation>
    </message>
    <message>
        <source>standard deviation of the gap between bit and rock at the start of the blows</source>
        <translation>standardavvikelse för spalten mellan borrkrona och berg när slagen börjar</translation>
    </message>
    <message>
        <source>gap between bit and rock that 95 % of the blows exceed</source>
        <translation>spalt mellan borrkrona och berg som 95&#xa0;% av slagen överskrider</translation>
    </message>
    <message>
        <source>median of the gap between bit and rock at the start of the blows</source>
        <translation>median av spalten mellan borrkrona och berg när slagen börjar</translation>
    </message>
    <message>
        <source>gap between bit and rock that 5 % of the blows exceed</source>
        <translation>spalt mellan borrkrona och berg som 5&#xa0;% av slagen överskrider</translation>
    </message>
    <message>
        <source>mean penetration per blow; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>medelinträngning per slag; en övre gräns, eftersom allt berg under kronan antas brytas</translation>
    </message>
    <message>
        <source>95 % error of drill_penetration, the mean penetration per blow. Needs a second simulation of all blows, with other time steps</source>
        <translation>95&#xa0;%-fel för drill_penetration, medelinträngningen per slag. Kräver en andra simulering av alla slag, med andra tidssteg</translation>
    </message>
    <message>
        <source>penetration rate, m/s: mean penetration per blow times blow frequency; an upper limit, as all rock under the bit is assumed to break</source>
        <translation>borrsjunkning, m/s: medelinträngning per slag gånger slagfrekvens; en övre gräns, eftersom allt berg under kronan antas brytas</translation>
    </message>
    <message>
        <source>mean impulse on the rock per blow: feed force over blow frequency</source>
        <translation>medelimpuls på berget per slag: matningskraft genom slagfrekvens</translation>
    </message>
    <message>
        <source>mean over all blows of the largest force on the rock</source>
        <translation>medelvärde över alla slag av den största kraften på berget</translation>
    </message>
    <message>
        <source>largest force in the damper between machine and rod</source>
        <translation>största kraft i dämparen mellan maskin och stång</translation>
    </message>
    <message>
        <source>contact share: share of blows that start with the bit on the rock, or less than 0.05 d0 away from it. d0 = 2 I0/Z, with the impulse I0 of a blow and the impedance Z of the rod</source>
        <translation>kontaktandel: andel slag som börjar med borrkronan mot berget, eller mindre än 0,05 d0 från det. d0 = 2 I0/Z, med slagets impuls I0 och stångens impedans Z</translation>
    </message>
    <message>
        <source>mean number of contacts between bit and rock in a blow</source>
        <translation>medelantal kontakter mellan borrkrona och berg i ett slag</translation>
    </message>
    <message>
        <source>number of blows after which the motion repeats, 1 to 16; 0 if it does not repeat</source>
        <translation>antal slag efter vilka rörelsen upprepas, 1 till 16; 0 om den inte upprepas</translation>
    </message>
    <message>
        <source>Lyapunov exponent: growth of a small disturbance per blow; above 0, single blows are not reproducible and only mean values count. Needs a second simulation of all blows</source>
        <translation>Lyapunovexponent: tillväxt av en liten störning per slag; över 0 är enstaka slag inte reproducerbara, och bara medelvärden gäller. Kräver en andra simulering av alla slag</translation>
    </message>
    <message>
        <source>number of round trips that a wave makes through rod or string between two blows (n_b)</source>
        <translation>antal varv som en våg gör fram och åter genom stång eller sträng mellan två slag (n_b)</translation>
    </message>
    <message>
        <source>error of the momentum balance of all blows, relative to the impulse of the feed force</source>
        <translation>fel i rörelsemängdens balans för alla slag, relativt matningskraftens impuls</translation>
    </message>
    <message>
        <source>error of the energy balance of all blows, as a share of the hammer work</source>
        <translation>fel i energibalansen för alla slag, som andel av hammarens arbete</translation>
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
drillwave help TOPIC skriver ut hjälpen till ett kommando, liksom COMMAND --help och -h. TOPIC kan också
vara en parameter (help bit_rock.gamma), ett resultat (help cor) eller en flagga (help --shard). Det kan
även vara ett kapitel i handboken eller ett avsnitt ur det (help theory 10). För varje annat ord (help
matning) skrivs de ställen i handboken där ordet förekommer. drillwave version skriver versionen.

Kapitel i handboken: %1.

Utan bildskärm behöver fönstret `-platform offscreen`. drillwave --reset-ui öppnar fönstret med
ursprunglig layout, sida, enheter och val. drillwave --language de öppnar det på tyska, bara denna
gång (sv: svenska, en: engelska). Även kommandon har --language; DRILLWAVE_LANGUAGE=de i miljön
ställer in språket för alla.

Slutkoder: %2.
</translation>
    </message>
    <message>
        <source>print the help of a command, parameter or output, or a chapter of the manual</source>
        <translation>skriv ut hjälpen till kommando, parameter eller resultat, eller ett kapitel i handboken</translation>
    </message>
    <message>
        <source>TOPIC is a command (run), an option (--shard), a parameter (bit_rock.gamma), an output (cor) or a
symbol (e). It can also be a chapter of the manual (theory) or a section of it (theory 10). For
any other word (feed, units, exit codes), the places of the manual that contain it are printed,
the best first.</source>
        <translation>TOPIC är ett kommando (run), en flagga (--shard), en parameter (bit_rock.gamma), ett resultat
(cor) eller en symbol (e). Det kan även vara ett kapitel i handboken (theory) eller ett avsnitt ur
det (theory 10). För varje annat ord (matning, units, exit codes) skrivs de ställen i handboken
där det förekommer, de bästa först.</translation>
    </message>
    <message>
        <source>print the version of the program</source>
        <translation>skriva ut programmets version</translation>
    </message>
    <message>
        <source>keep completed rows in FILE.csv.partial; after an interruption, the same command continues after them</source>
        <translation>behåll färdiga rader i FILE.csv.partial; efter ett avbrott fortsätter samma kommando efter dem</translation>
    </message>
    <message>
        <source>Writes FILE and its description FILE.yaml as one run without --shard would have written them, with
the same exit code. A PART is a file of rows with PART.yaml beside it, or a folder with all parts,
in any order. All parts must come from the same run: same scenario, varied parameters, table of
cases, build and number of parts. If a part is missing, given twice, from another run or changed
since it was written, the message names it; the exit code is 5.</source>
        <translation>Skriver FILE och beskrivningen FILE.yaml som en körning utan --shard hade skrivit dem, med samma
slutkod. En PART är en fil med rader och PART.yaml intill, eller en mapp med alla delar, i valfri
ordning. Alla delar måste komma från samma körning: samma scenario, varierade parametrar,
falltabell, program och antal delar. Om en del saknas, är angiven två gånger, kommer från en annan
körning eller har ändrats sedan den skrevs nämns den i meddelandet; slutkoden är 5.</translation>
    </message>
    <message>
        <source>list the built-in scenarios, print the named ones, or write them into a folder</source>
        <translation>lista de inbyggda scenarierna, skriv ut de nämnda eller skriv dem i en mapp</translation>
    </message>
    <message>
        <source>`drillwave examples t38_string &gt; my.yaml` saves a built-in scenario as a file to edit.</source>
        <translation>`drillwave examples t38_string &gt; my.yaml` sparar ett inbyggt scenario som en fil att ändra i.</translation>
    </message>
    <message>
        <source>simulate consecutive blows under a feed force: penetration rate, gaps, errors</source>
        <translation>simulera slag i följd under en matningskraft: borrsjunkning, spalter, fel</translation>
    </message>
    <message>
        <source>use this measured record as the blow; the options below say how to read it</source>
        <translation>använd denna mätning som slag; alternativen nedan säger hur den läses</translation>
    </message>
    <message>
        <source>use all samples of --signal; by default samples are left out as long as this changes impulse and coefficient of restitution by less than 1e-4</source>
        <translation>behåll alla mätvärden från --signal; som standard utelämnas några, så länge impuls och studstal ändras med mindre än 1e-4</translation>
    </message>
    <message>
        <source>sign between the columns of the table: tab, semicolon, comma, bar (|) or blank (default: detected)</source>
        <translation>tecken mellan tabellens kolumner: tab, semicolon, comma, bar (|) eller blank (standard: hittas)</translation>
    </message>
    <message>
        <source>decimal sign of the table: point or comma (default: detected)</source>
        <translation>tabellens decimaltecken: point eller comma (standard: hittas)</translation>
    </message>
    <message>
        <source>number of the first line with a sample (default: detected)</source>
        <translation>nummer på första raden med ett mätvärde (standard: hittas)</translation>
    </message>
    <message>
        <source>character encoding of the table: utf-8, windows-1252, latin-1, utf-16le or utf-16be (default: detected)</source>
        <translation>tabellens teckenkodning: utf-8, windows-1252, latin-1, utf-16le eller utf-16be (standard: hittas)</translation>
    </message>
    <message>
        <source>column of the times, by name or by number from 1</source>
        <translation>tidernas kolumn, med namn eller nummer från 1</translation>
    </message>
    <message>
        <source>column of the signal, by name or by number from 1; A+B takes the mean of two gauges on opposite sides</source>
        <translation>signalens kolumn, med namn eller nummer från 1; A+B tar medelvärdet av två givare på motsatta sidor</translation>
    </message>
    <message>
        <source>unit of the times, if the table does not state it: s, ms, us</source>
        <translation>tidernas enhet, om tabellen inte anger den: s, ms, us</translation>
    </message>
    <message>
        <source>unit of the signal, if the table does not state it: kN, microstrain, V, MPa, m/s</source>
        <translation>signalens enhet, om tabellen inte anger den: kN, microstrain, V, MPa, m/s</translation>
    </message>
    <message>
        <source>sampling rate, such as 5MHz, used instead of a time column</source>
        <translation>samplingsfrekvens, t.ex. 5MHz, i stället för en kolumn med tider</translation>
    </message>
    <message>
        <source>multiply the signal by this factor, or by a force per unit: 50kN/V, 18kN s/m</source>
        <translation>multiplicera signalen med denna faktor, eller med en kraft per enhet: 50kN/V, 18kN s/m</translation>
    </message>
    <message>
        <source>gain of the amplifier, for a signal in volts (default: 1)</source>
        <translation>förstärkarens förstärkning, för en signal i volt (standard: 1)</translation>
    </message>
    <message>
        <source>supply voltage of the bridge in volts, for a signal in volts</source>
        <translation>bryggans matningsspänning i volt, för en signal i volt</translation>
    </message>
    <message>
        <source>bridge factor of the strain gauges: 1 (quarter bridge), 2 (half bridge), 4 (full bridge) or 2.6 (full bridge with Poisson gauges)</source>
        <translation>töjningsgivarnas bryggfaktor: 1 (kvartsbrygga), 2 (halvbrygga), 4 (helbrygga) eller 2.6 (helbrygga med tvärgivare)</translation>
    </message>
    <message>
        <source>gauge factor of the strain gauges, for a signal in volts or mV/V</source>
        <translation>töjningsgivarnas givarfaktor, för en signal i volt eller mV/V</translation>
    </message>
    <message>
        <source>cross-section of the bar at the gauge, such as 1134mm^2</source>
        <translation>stångens tvärsnitt vid givaren, t.ex. 1134mm^2</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the bar that carries the gauge, such as 210GPa</source>
        <translation>elasticitetsmodul för stången med givaren, t.ex. 210GPa</translation>
    </message>
    <message>
        <source>time range in which the signal is zero on average, such as -50us:-10us</source>
        <translation>tidsområde där signalen i medeltal är noll, t.ex. -50us:-10us</translation>
    </message>
    <message>
        <source>ignore samples earlier than this time in the table, such as 0us</source>
        <translation>utelämna mätvärden före denna tid i tabellen, t.ex. 0us</translation>
    </message>
    <message>
        <source>ignore samples later than this time in the table, such as 400us</source>
        <translation>utelämna mätvärden efter denna tid i tabellen, t.ex. 400us</translation>
    </message>
    <message>
        <source>reverse the sign of the signal: its largest value is tension (default: compression)</source>
        <translation>vänd signalens tecken: dess största värde är drag (standard: tryck)</translation>
    </message>
    <message>
        <source>treatment of rows in which a value is not a number: refuse the table, or skip these rows (default: refuse)</source>
        <translation>behandling av rader där ett värde inte är ett tal: refuse (avvisa tabellen) eller skip (hoppa över raderna) (standard: refuse)</translation>
    </message>
    <message>
        <source>read the record with the options that `drillwave signal --save-recorder NAME` has saved</source>
        <translation>läs mätningen med de alternativ som `drillwave signal --save-recorder NAME` har sparat</translation>
    </message>
    <message>
        <source>design variable to vary; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C; to compare presets: hammer=NAME,NAME</source>
        <translation>konstruktionsvariabel att variera; VALUES är START:STOP:COUNT, START:STOP:COUNT:log (lika förhållanden) eller A,B,C; för att jämföra förval: hammer=NAME,NAME</translation>
    </message>
    <message>
        <source>read records of force, strain or voltage; print their units, blow and quality</source>
        <translation>läs mätningar av kraft, töjning eller spänning: enheter, slag och kvalitet</translation>
    </message>
    <message>
        <source>Reads tables of a signal measured over time, and finds encoding, separator, decimal sign, columns
and units. If the table does not state something that is needed, the last lines printed ask for
it, and the exit code is 5. Several RECORDs are read as one series and give one row each. Commands
that take a scenario can use such a record as the blow, with --signal FILE and the same options.</source>
        <translation>Läser tabeller med en signal som mätts över tiden och hittar kodning, avgränsare, decimaltecken,
kolumner och enheter. Om tabellen inte anger något som behövs frågar de sista utskrivna raderna
efter det, och slutkoden är 5. Flera RECORD läses som en serie och ger en rad var. Kommandon som
tar ett scenario kan använda en sådan mätning som slag, med --signal FILE och samma alternativ.</translation>
    </message>
    <message>
        <source>save the options for reading the record under this name; --recorder NAME uses them again</source>
        <translation>spara alternativen för att läsa mätningen under detta namn; --recorder NAME använder dem igen</translation>
    </message>
    <message>
        <source>print JSON; for several FILEs, an array</source>
        <translation>skriv ut JSON; för flera FILE en array</translation>
    </message>
    <message>
        <source>write the signal as read, with the columns time [us] and force [kN]</source>
        <translation>skriv signalen som den lästes, med kolumnerna time [us] och force [kN]</translation>
    </message>
    <message>
        <source>overwrite FILE.csv if it exists</source>
        <translation>skriv över FILE.csv om den finns</translation>
    </message>
    <message>
        <source>write CSV with semicolons between cells and decimal commas</source>
        <translation>skriv CSV med semikolon mellan celler och decimalkomma</translation>
    </message>
    <message>
        <source>mean of a normally distributed gap, such as 0.5mm (default: the gap of FILE); if FILE has no physical units, a multiple of d0, such as 0.2</source>
        <translation>medelvärde för en normalfördelad spalt, t.ex. 0.5mm (standard: spalten i FILE); om FILE inte har fysikaliska enheter, en multipel av d0, t.ex. 0.2</translation>
    </message>
    <message>
        <source>print one JSON object instead of the table</source>
        <translation>skriv ut ett JSON-objekt i stället för tabellen</translation>
    </message>
    <message>
        <source>take presets from this file instead of the built-in ones</source>
        <translation>ta förval ur denna fil i stället för de inbyggda</translation>
    </message>
    <message>
        <source>print one JSON object instead of the summary</source>
        <translation>skriv ut ett JSON-objekt i stället för sammanfattningen</translation>
    </message>
    <message>
        <source>solution method: exact, lattice (time steps) or closed_form (default: exact; for a result file, its own method)</source>
        <translation>lösningsmetod: exact, lattice (tidssteg) eller closed_form (förval: exact; för en resultatfil dess egen metod)</translation>
    </message>
    <message>
        <source>number of segments into which the lattice method (time steps) divides the rod (default: 10000)</source>
        <translation>antal segment som gittermetoden (tidssteg) delar stången i (standard: 10000)</translation>
    </message>
    <message>
        <source>do not solve a blow whose waves the exact solver must split into more than N pieces (default: 1000000, a few seconds at most)</source>
        <translation>lös inte ett slag vars vågor den exakta metoden måste dela i mer än N bitar (förval: 1000000, högst några sekunder)</translation>
    </message>
    <message>
        <source>outputs to write as columns, listed below (default: cor, the coefficient of restitution)</source>
        <translation>resultat att skriva som kolumner, listade nedan (standard: cor, studstalet)</translation>
    </message>
    <message>
        <source>leave outputs empty if the exact solver must split the waves into more than N pieces (default: 1000000, at most about 2 s per row)</source>
        <translation>lämna resultaten i en rad tomma om den exakta metoden måste dela vågorna i mer än N bitar (förval: 1000000, högst omkring 2 s per rad)</translation>
    </message>
    <message>
        <source>number of threads (default: all)</source>
        <translation>antal trådar (standard: alla)</translation>
    </message>
    <message>
        <source>outputs to compute along the parameter, listed below (default: cor, the coefficient of restitution)</source>
        <translation>resultat att beräkna längs parametern, listade nedan (förval: cor, studstalet)</translation>
    </message>
    <message>
        <source>print one JSON object instead of the tables</source>
        <translation>skriv ut ett JSON-objekt i stället för tabellerna</translation>
    </message>
    <message>
        <source>skip blows whose waves the exact solver must split into more than N pieces (default: 1000000)</source>
        <translation>hoppa över slag vars vågor den exakta metoden måste dela i mer än N bitar (förval: 1000000)</translation>
    </message>
    <message>
        <source>output to map, listed below (default: cor, the coefficient of restitution)</source>
        <translation>kartans resultat, listade nedan (standard: cor, studstalet)</translation>
    </message>
    <message>
        <source>print the summary and the contours of the map as one JSON object</source>
        <translation>skriv ut sammanfattningen och kartans nivåkurvor som ett JSON-objekt</translation>
    </message>
    <message>
        <source>skip points for which the exact solver must split the waves into more than N pieces (default: 1000000, at most about 2 s per point)</source>
        <translation>hoppa över punkter där den exakta metoden måste dela vågorna i mer än N bitar (förval: 1000000, högst omkring 2 s per punkt)</translation>
    </message>
    <message>
        <source>number of blows: short for --set drill.blows=N (default: 1000, with --scan 300)</source>
        <translation>antal slag: kortform för --set drill.blows=N (standard: 1000, med --scan 300)</translation>
    </message>
    <message>
        <source>time steps per duration t0 of the blow, 10 to 400 (default: 40, with --scan 20)</source>
        <translation>tidssteg per slagets varaktighet t0, 10 till 400 (standard: 40, med --scan 20)</translation>
    </message>
    <message>
        <source>print numbers in SI units (default)</source>
        <translation>skriv tal i SI-enheter (standard)</translation>
    </message>
    <message>
        <source>refuse a computation if its number of time steps times its number of section ends is above N (default: 4e9)</source>
        <translation>avvisa en beräkning om antalet tidssteg gånger antalet sektionsändar är större än N (förval: 4e9)</translation>
    </message>
    <message>
        <source>also print a table over the values of this parameter. VALUES is START:STOP[:COUNT], START:STOP[:COUNT]:log (equal ratios) or A,B,C. Default COUNT: 101, or every integer if the parameter is an integer</source>
        <translation>skriv även ut en tabell över värdena på denna parameter. VALUES är START:STOP[:COUNT], START:STOP[:COUNT]:log (lika förhållanden) eller A,B,C. Standard för COUNT: 101, eller varje heltal för heltalsparametrar</translation>
    </message>
    <message>
        <source>number of processor threads for --along (default: all)</source>
        <translation>antal trådar för --along (standard: alla)</translation>
    </message>
    <message>
        <source>number of random samples for each design, rounded up to a power of two (default: 4096, for a drill string 1024)</source>
        <translation>antal slumpmässiga stickprov per konstruktion, avrundat uppåt till en tvåpotens (standard: 4096, för en borrsträng 1024)</translation>
    </message>
    <message>
        <source>seed of the random samples (default: 1)</source>
        <translation>startvärde för de slumpmässiga stickproven (standard: 1)</translation>
    </message>
    <message>
        <source>formats of the figures (default: png,svg)</source>
        <translation>figurernas format (standard: png,svg)</translation>
    </message>
    <message>
        <source>numbers of rod segments to compare in the lattice method (time steps), such as 100,1000 (default: from 100 to 20000)</source>
        <translation>antal stångsegment att jämföra i gittermetoden (tidssteg), till exempel 100,1000 (förval: från 100 till 20000)</translation>
    </message>
    <message>
        <source>limit the work of the lattice method, counted as time steps times segments (default: 1000000000, about half a minute)</source>
        <translation>begränsa gittermetodens arbete, räknat som tidssteg gånger segment (förval: 1000000000, omkring en halv minut)</translation>
    </message>
    <message>
        <source>find stiffness and elasticity of the rock from strain gauges, with uncertainty</source>
        <translation>bestäm bergets styvhet och elasticitet ur töjningsgivare, med osäkerhet</translation>
    </message>
    <message>
        <source>also write tables, random samples of the rock, and the scenario with the rock that was found, into DIR</source>
        <translation>skriv även tabeller, slumpmässiga stickprov av berget samt scenariot med det funna berget till DIR</translation>
    </message>
    <message>
        <source>limit: accept only designs for which this statistic of the output is at most VALUE</source>
        <translation>gräns: godta bara konstruktioner för vilka denna statistik av resultatet är högst VALUE</translation>
    </message>
    <message>
        <source>limit: accept only designs for which this statistic of the output is at least VALUE</source>
        <translation>gräns: godta bara konstruktioner för vilka denna statistik av resultatet är minst VALUE</translation>
    </message>
    <message>
        <source>read these records of strain gauges; give several records in the order of hole depth, the shallowest first</source>
        <translation>läs dessa inspelningar från töjningsgivare; ange flera i ordning efter borrhålets djup, den grundaste först</translation>
    </message>
    <message>
        <source>column of a gauge and its distance from the bit face; give one or two gauges. A+B@… takes the mean of two gauges on opposite sides</source>
        <translation>kolumn för en givare och dess avstånd från kronans front; ange en eller två givare. A+B@… tar medelvärdet av två givare på motsatta sidor</translation>
    </message>
    <message>
        <source>95 % tolerance of a known input: KEY (gain, zero, gauge or a dimension) is within +-TOL of its value; see the description of the command</source>
        <translation>95&#xa0;%-tolerans för en känd indata: KEY (gain, zero, gauge eller ett mått) ligger inom +-TOL från sitt värde; se beskrivningen av kommandot</translation>
    </message>
    <message>
        <source>support behind the rock or specimen: rigid, or bar if the specimen is between two equal bars (default: rigid)</source>
        <translation>stöd bakom berg eller prov: rigid (stelt), eller bar om provet ligger mellan två likadana stänger (standard: rigid)</translation>
    </message>
    <message>
        <source>predict the wave at a gauge on the bar behind the specimen, DISTANCE away from the specimen, and print the error; needs --backing bar</source>
        <translation>förutsäg vågen vid en givare på stången bakom provet, på avståndet DISTANCE från provet, och skriv ut felet; kräver --backing bar</translation>
    </message>
    <message>
        <source>correction for the dispersion of waves between gauge and bit: fit (estimated from the record), bar (theory of a round bar) or none (default: fit)</source>
        <translation>korrektion för vågornas dispersion mellan givare och borrkrona: fit (uppskattad ur mätningen), bar (teorin för en rund stång) eller none (förval: fit)</translation>
    </message>
    <message>
        <source>use the record only up to this time after the reflected wave reaches the gauge</source>
        <translation>använd mätningen bara till denna tid efter att den reflekterade vågen nått givaren</translation>
    </message>
    <message>
        <source>blows of a record to evaluate: first, or all (default: first)</source>
        <translation>slag i en mätning som utvärderas: first (det första) eller all (alla) (standard: first)</translation>
    </message>
    <message>
        <source>seed of the random numbers for noise and samples (default: 1)</source>
        <translation>startvärde för slumptalen för brus och stickprov (standard: 1)</translation>
    </message>
    <message>
        <source>FILE.html is a single file with inputs, results, pictures and the scenario. It can be run again:
`drillwave run FILE.html`. FILE.pdf has the same content for printing on A4. -o DIR writes both,
as report.html and report.pdf. The numbers are those of `run --json`, in SI if the scenario has
physical units. The source of a value is the comment after it in the scenario file. For drill
strings, the report also shows the sections, drawn to scale, with their largest stresses.</source>
        <translation>FILE.html är en enda fil med indata, resultat, bilder och scenariot. Den kan köras igen:
`drillwave run FILE.html`. FILE.pdf har samma innehåll för utskrift på A4. -o DIR skriver båda,
som report.html och report.pdf. Talen är de som `run --json` ger, i SI-enheter om scenariot har
fysikaliska enheter. Källan till ett värde är kommentaren efter det i scenariofilen. För en
borrsträng visar rapporten även sektionerna, skalenligt ritade, med sina största spänningar.</translation>
    </message>
    <message>
        <source>add studies to the report: drill (consecutive blows), design (best design, from the block `design` of FILE)</source>
        <translation>lägg till studier i rapporten: drill (slag i följd), design (bästa konstruktion, enligt blocket `design` i FILE)</translation>
    </message>
    <message>
        <source>number of processor threads for the studies added by --with (default: all)</source>
        <translation>antal trådar för de studier som --with lägger till (standard: alla)</translation>
    </message>
    <message>
        <source>feed force that single blows require, and whether the installed one is sufficient</source>
        <translation>matningskraft som enstaka slag kräver, och om den angivna räcker</translation>
    </message>
    <message>
        <source>with -o, also write the strain that a gauge at this distance from the bit face would record, in a column named COLUMN</source>
        <translation>med -o: skriv även den töjning som en givare på detta avstånd från kronans front skulle registrera, i en kolumn med namnet COLUMN</translation>
    </message>
    <message>
        <source>white noise to add to --record, in % of its largest strain (default: 0%)</source>
        <translation>vitt brus att lägga till i --record, i % av den största töjningen (standard: 0%)</translation>
    </message>
    <message>
        <source>seed of the random numbers for --noise (default: 1)</source>
        <translation>startvärde för slumptalen för --noise (standard: 1)</translation>
    </message>
    <message>
        <source>-o DIR writes scenario.yaml, summary.json, histories.csv and events.csv; each of them contains the
scenario, so that `drillwave run` can run it again. With --plots, it also writes the plots blow.*,
rock.*, wave_picture.* and rod.*. For drill strings, the histories are taken at the middle of the
longest section. To rehearse a measurement for `identify`, add --record near@1.13m --record
far@2.93m --noise 1%. This also writes record.csv, the strain that two gauges would record in 1e6
samples per second. --record top+bottom@1.13m records two gauges on opposite sides of the rod,
each with its own noise.</source>
        <translation>-o DIR skriver scenario.yaml, summary.json, histories.csv och events.csv; var och en innehåller
scenariot, så att `drillwave run` kan köra den igen. Med --plots skrivs även diagrammen blow.*,
rock.*, wave_picture.* och rod.*. För borrsträngar gäller förloppen mitten av den längsta
sektionen. För att öva en mätning inför `identify`, lägg till --record near@1.13m --record
far@2.93m --noise 1%. Då skrivs även record.csv, den töjning som två givare skulle registrera med
1e6 sampel per sekund. --record upp+ner@1.13m registrerar två givare på motsatta sidor av stången,
var och en med eget brus.</translation>
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
        <translation>Löser varje konstruktion (varje kombination av värdena i --choose) med samma slumpmässiga
stickprov av de osäkra storheterna. Skriver ut den bästa konstruktionen över alla stickprov (bäst
för osäkert berg) och den bästa med indata i FILE (bäst för de angivna värdena). Det första --aim
avgör båda. Skriver även vilka konstruktioner som är lika bra inom felen, vilken storhet som bör
mätas först, och det sämsta fallet inom områdena. Den första meningen varnar om den rekommenderade
konstruktionen överskrider en hållfasthet.
  --uncertain KEY=LOW:HIGH   alla värden från LOW till HIGH lika sannolika; med :log lika sannolika
                             på logaritmisk skala. Med :normal eller :lognormal en normal- eller
                             lognormalfördelning med 95&#xa0;% av värdena från LOW till HIGH
  --uncertain KEY=+-P%       P&#xa0;% åt båda sidor om värdet i FILE, eller om värdet i --choose
  --choose hammer=NAME,NAME  hammarförval med namn, eller alla med hammer=all; rod= fungerar
                             likadant. För borrsträngar tar hammer= kolvar och bit= borrkronor
En STATISTIC är mean, q01 till q99 (kvantiler), min, max eller nominal (med indata i FILE).
Utan --aim är målstorheterna max:efficiency@q05 och, om FILE har en slagfrekvens,
min:thrust@q95. Alternativ som inte anges tas ur blocket `design` i FILE. -o DIR skriver
designs.csv, pareto.csv, sensitivity.csv, worst.csv, best.yaml, design.json och, med --plots,
design.png.</translation>
    </message>
    <message>
        <source>Lists the built-in presets, or those of FILE.yaml. KIND restricts the list to rod, hammer, rock,
piston, adapter, coupling or bit. Other commands use a preset with --rod NAME, --hammer NAME or
--rock NAME; the beginning of the name suffices if only one preset has it. Pistons, adapters,
couplings and bits are sections of drill strings: insert them on the page String of the window.</source>
        <translation>Listar de inbyggda förvalen, eller dem i FILE.yaml. KIND begränsar listan till rod, hammer, rock,
piston, adapter, coupling eller bit. Andra kommandon använder ett förval med --rod NAME, --hammer
NAME eller --rock NAME; början av namnet räcker om bara ett förval börjar så. Kolvar,
nackadaptrar, skarvhylsor och borrkronor är sektioner i borrsträngar: de läggs in på fönstrets
sida Sträng.</translation>
    </message>
    <message>
        <source>write the files of the run into DIR; -o - writes none</source>
        <translation>skriv körningens filer till DIR; -o - skriver inga</translation>
    </message>
    <message>
        <source>write the rows to FILE.csv, and the settings of the run to FILE.csv.yaml; -o - prints the rows (default)</source>
        <translation>skriv raderna till FILE.csv och körningens inställningar till FILE.csv.yaml; -o - skriver ut raderna (standard)</translation>
    </message>
    <message>
        <source>Follows outputs continuously over the range of a parameter, and finds every kink and jump. For
each output, prints where it is smallest and largest, its other minima and maxima, its kinks and
its jumps. Also prints where the output crosses a --level. All values have errors. If following an
output takes too much computing, it is solved only at single points, and the table says so.
--goal X prints every value of the parameter at which the output is X, with its error, and whether
there may be others. If no value gives X, prints the output nearest to X and where it occurs. Give
values with units if the parameter has one: --along bit_rock.stiffness=10MN/m:10GN/m:log</source>
        <translation>Följer resultat kontinuerligt över en parameters område och hittar varje knäck och språng. Skriver
för varje resultat var det är minst och störst, dess andra minima och maxima, dess knäckar och
språng. Skriver även var resultatet korsar en nivå (--level). Alla värden har fel. Om det kräver
för mycket beräkning löses resultatet bara i enstaka punkter, och tabellen säger det.
--goal X skriver varje värde på parametern där resultatet är X, med sitt fel, och om det kan
finnas fler. Om inget värde ger X skrivs det resultat som kommer närmast X, och var det finns.
Ange värden med enhet om parametern har en: --along bit_rock.stiffness=10MN/m:10GN/m:log</translation>
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
        <translation>Bestämmer bergets styvhet och elasticitet (gamma) och spalten mellan borrkrona och berg. Använder
de vågor som töjningsgivare registrerar på stången, eller på den sista stången i en sträng.
Skriver ut värdena med deras 95&#xa0;%-intervall, vad som begränsar noggrannheten och vad som bör mätas
bättre. Berget i FILE (bit_rock) används bara med --law file. --known KEY=+-TOL anger hur väl
indata är kända:
  --known gain=+-5% zero=+-1%   förstärkarens förstärkning, och dess nollinje i % av toppen
  --known gauge=+-2mm           givarnas avstånd från kronans front
  --known rod.diameter=+-0.1mm  ett mått på sektionen med givaren, eller på en sektion mellan
                                givare och krona
Mätningar läses med alternativen för `signal`. -o DIR skriver identified.yaml,
posterior.csv (stickprov av berget för design --draws), match.csv, force_penetration.csv,
incident.csv, identify.json och, för flera mätningar, records.csv. Slutkod 0: styvhet eller
gamma är känd. Slutkod 6: ingen av dem är känd, eller mätningen motsäger modellen.
Intervallen kan vara för snäva om bergets belastnings- eller avlastningskurva inte är en
rät linje (commands §4.17).</translation>
    </message>
    <message>
        <source>rock law to fit: bilinear (straight loading curve), corner (one corner in it) or auto (either); file checks the law given in FILE without a fit (default: auto)</source>
        <translation>berglag som anpassas till mätningen: bilinear (rak belastningskurva), corner (med ett hörn) eller auto (någon av dem); file prövar lagen i FILE utan anpassning (förval: auto)</translation>
    </message>
    <message>
        <source>date printed in the report, any text (default: none)</source>
        <translation>datum som står i rapporten, valfri text (standard: inget)</translation>
    </message>
    <message>
        <source>write no plots and no PDF; a display is then not needed</source>
        <translation>skriv inga diagram och ingen PDF; då behövs ingen skärm</translation>
    </message>
    <message>
        <source>Writes into DIR the data of Figs 3 to 8 of the paper on which the model is based, as CSV and
as pictures. discrepancies.csv compares each number printed in that paper with the exact one.
index.html shows all of them. The reference curves are written twice, because the paper
scales stiffness in two ways: by k0 = Z/(2T) in its plots, by k0 = Z/t0 in its text. Z is the
impedance of the rod, T the time that a wave takes along the rod, t0 the duration of the
blow.</source>
        <translation>Skriver till DIR data för fig. 3 till 8 i den artikel som modellen bygger på, som CSV
och som bilder. discrepancies.csv jämför varje tal som artikeln trycker med det
exakta. index.html visar alltsammans. Referenskurvorna skrivs två gånger, eftersom
artikeln skalar styvheten på två sätt: med k0 = Z/(2T) i diagrammen och med k0 = Z/t0
i texten. Z är stångens impedans, T den tid en våg behöver längs stången, t0 slagets
varaktighet.</translation>
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
        <translation>Simulerar på varandra följande slag. Restvågorna och maskinens rörelse på sin dämpare förs vidare
från ett slag till nästa; varje slag möter nytt berg. Skriver inträngning och borrsjunkning med
sina fel, och andelen slag som börjar med borrkronan mot berget. Skriver även om rörelsen upprepar
sig och vart energin tar vägen. FILE behöver drill.blow_frequency och drill.thrust,
matningskraften. Inträngningar är övre gränser, eftersom allt berg under kronan antas brytas.
--scan jämför värden på en parameter. Varje värde simuleras två gånger: med start från vila och
med studsande maskin. En andra rad skrivs bara om de två skiljer sig. -o DIR skriver scenario.yaml, summary.json och blows.csv till DIR, med
--histories även histories.csv, med --plots även drilling.png.</translation>
    </message>
    <message>
        <source>vary this parameter; VALUES is START:STOP:COUNT, START:STOP:COUNT:log (equal ratios) or A,B,C; to compare presets: rock=all, or rock=, hammer=, rod= or bit= with their names</source>
        <translation>variera denna parameter; VALUES är START:STOP:COUNT, START:STOP:COUNT:log (lika förhållanden) eller A,B,C; jämför förval: rock=all, eller rock=, hammer=, rod= eller bit= med deras namn</translation>
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
        <translation>Uppskattar från enstaka slag om den angivna matningskraften räcker. Skriver ut fyra fall: detta
slag, 95&#xa0;% av alla spalter mellan borrkrona och berg, stelt berg (e = 1) och den värsta spalten.
Den kräver den högsta matningskraften på elastiskt berg (gamma = 1). I tabellens kolumner (theory
§10) är f slagfrekvensen, I0 ett slags impuls och e studstalet:
  krävs           f I0 (1 + e), den matningskraft som balanserar slagen
  retur i tid     f I0 (1 + 2e), den matningskraft som för en odämpad stel stång tillbaka till
                  berget före nästa slag
  marginal        effektiv genom krävd matningskraft, minus 1
  räcker till     högsta slagfrekvens vid vilken den effektiva matningskraften
                  ännu når den krävda
Om matningskraften är lägre än f I0 trycker slagen tillbaka maskinen. Den effektiva
matningskraften är den angivna; om drill.inclination anges tillkommer tyngden av stång och
drill.machine_mass längs hålet. För slag i följd, använd `drillwave drill`; dess --scan
drill.thrust=START:STOP:COUNT visar verkan av mer matningskraft. FILE måste ha fysikaliska enheter
och drill.blow_frequency; marginaler kräver drill.thrust, den angivna matningskraften. För
borrsträngar är I0 den impuls som hammaren överför, och bara detta slag och stelt berg skrivs ut.</translation>
    </message>
    <message>
        <source>compare each design at its own blow energy, even if FILE sets keep_energy (the same energy for all designs)</source>
        <translation>jämför varje konstruktion vid dess egen slagenergi, även om FILE anger keep_energy (samma energi för alla konstruktioner)</translation>
    </message>
    <message>
        <source>effective feed force divided by the mean force of the blows (phi); below 1 the blows push the machine back</source>
        <translation>verkande matningskraft delad med slagens medelkraft (phi); under 1 skjuter slagen maskinen bakåt</translation>
    </message>
</context>
</TS>
