<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CommandLine</name>
    <message>
        <source>Control panel for Networked Modular Control motor modules.</source>
        <translation>Bedienprogramm für Motormodule nach Networked Modular Control (NMC).</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NAME</translation>
    </message>
    <message>
        <source>Baud rate of the chain: 9600, 19200 (default), 57600 or 115200.</source>
        <translation>Baudrate der Kette: 9600, 19200 (Vorgabe), 57600 oder 115200.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Connect to the built-in simulator at startup. CHAIN lists its modules, the one farthest from the host first; the default is %1.</source>
        <translation>Beim Start mit dem eingebauten Simulator verbinden. KETTE zählt seine Module auf, das vom Rechner am weitesten entfernte zuerst; Vorgabe ist %1.</translation>
    </message>
    <message>
        <source>CHAIN</source>
        <translation>KETTE</translation>
    </message>
    <message>
        <source>List the serial ports of this computer.</source>
        <translation>Die seriellen Schnittstellen dieses Rechners auflisten.</translation>
    </message>
    <message>
        <source>Show this help.</source>
        <translation>Diese Hilfe anzeigen.</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>Die Version anzeigen.</translation>
    </message>
    <message>
        <source>Allow control lines to inject faults into the built-in simulator.</source>
        <translation>Steuerzeilen dürfen Fehler in den eingebauten Simulator einspeisen.</translation>
    </message>
    <message>
        <source>With --port or --simulator: connect read-only. Only status requests are sent, and closing does not stop motors. STOP ALL still works.</source>
        <translation>Mit --port oder --simulator: nur lesend verbinden. Es werden nur Statusabfragen gesendet, und Schließen stoppt keine Motoren. ALLES STOPP wirkt weiterhin.</translation>
    </message>
    <message>
        <source>Machine file to open at startup.</source>
        <translation>Eine Maschinendatei, die beim Start geöffnet wird.</translation>
    </message>
    <message>
        <source>Let other programs in from the start. With =control, one of them may move motors without the user being asked.</source>
        <translation>Andere Programme von Anfang an einlassen. Mit =control darf eines davon Motoren bewegen, ohne dass gefragt wird.</translation>
    </message>
    <message>
        <source>Connect to a serial port at startup, or to one at a device server: tcp://HOST:PORT or rfc2217://HOST:PORT.</source>
        <translation>Beim Start mit einer seriellen Schnittstelle verbinden, oder mit der eines Geräteservers: tcp://HOST:PORT oder rfc2217://HOST:PORT.</translation>
    </message>
</context>
<context>
    <name>Common</name>
    <message>
        <source>%1 of %2 modules answered.</source>
        <translation>%1 von %2 Modulen haben geantwortet.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>Punkte und Abläufe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Travel and speed limits</source>
        <translation>Weg- und Geschwindigkeitsgrenzen</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>Endschalter-Stopp</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>Beschleunigungszeit</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Reglerwerte</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Home all</source>
        <translation>Alle referenzieren</translation>
    </message>
    <message>
        <source>limit 1</source>
        <translation>Endschalter 1</translation>
    </message>
    <message>
        <source>limit 2</source>
        <translation>Endschalter 2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>STOP ALL</source>
        <translation>ALLES STOPP</translation>
    </message>
    <message>
        <source>Motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>Connect fully</source>
        <translation>Voll verbinden</translation>
    </message>
    <message>
        <source>steps/s</source>
        <translation>Schritte/s</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1/s²</source>
        <translation>%1/s²</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>E-stop input</source>
        <translation>E-Stop-Eingang</translation>
    </message>
    <message>
        <source>The motor holds its position.</source>
        <translation>Der Motor hält seine Position.</translation>
    </message>
    <message>
        <source>The motor follows the points of a path.</source>
        <translation>Der Motor folgt den Punkten einer Bahn.</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>Simulator</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>No module</source>
        <translation>Kein Modul</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>◂ Hold</source>
        <translation>◂ Tippen</translation>
    </message>
    <message>
        <source>Hold ▸</source>
        <translation>Tippen ▸</translation>
    </message>
    <message>
        <source>◂| Step</source>
        <translation>◂| Schritt</translation>
    </message>
    <message>
        <source>Step |▸</source>
        <translation>Schritt |▸</translation>
    </message>
    <message>
        <source>Moves forward while held, then stops.</source>
        <translation>Fährt vorwärts, solange gedrückt, und stoppt dann.</translation>
    </message>
    <message>
        <source>Moves in reverse while held, then stops.</source>
        <translation>Fährt rückwärts, solange gedrückt, und stoppt dann.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>&amp;Scan again</source>
        <translation>Erneut &amp;suchen</translation>
    </message>
    <message>
        <source>Resets every module and assigns new addresses. Asks first.</source>
        <translation>Setzt jedes Modul zurück und vergibt die Adressen neu. Fragt vorher nach.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>Open machine</source>
        <translation>Maschine öffnen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>ended at %1</source>
        <translation>endete um %1</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>Alle Module</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>Max. Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>The value at an A/D reading of 0.</source>
        <translation>Der Wert bei einem A/D-Wert von 0.</translation>
    </message>
    <message>
        <source>The module received a garbled command and did not carry it out.</source>
        <translation>Das Modul hat einen gestörten Befehl empfangen und nicht ausgeführt.</translation>
    </message>
    <message>
        <source>Limit switch 1.</source>
        <translation>Endschaltereingang 1.</translation>
    </message>
    <message>
        <source>Limit switch 2.</source>
        <translation>Endschaltereingang 2.</translation>
    </message>
    <message>
        <source>Waiting for the home position.</source>
        <translation>Wartet auf die Referenz.</translation>
    </message>
    <message>
        <source>Save as home</source>
        <translation>Als Referenz speichern</translation>
    </message>
    <message>
        <source>Save as home: the present position</source>
        <translation>Als Referenz speichern: Die jetzige Position als Referenz speichern</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Statusbyte</translation>
    </message>
    <message>
        <source>Home register</source>
        <translation>Referenzregister</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Rohdaten</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>Status %1</translation>
    </message>
    <message>
        <source>Saves the present position as home. The motor does not move.</source>
        <translation>Speichert die jetzige Position als Referenz. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>Schnelle Bahn</translation>
    </message>
    <message>
        <source>Amplifier</source>
        <translation>Verstärker</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>PWM value</source>
        <translation>PWM-Wert</translation>
    </message>
    <message>
        <source>Abruptly</source>
        <translation>Sofort</translation>
    </message>
    <message>
        <source>Smoothly</source>
        <translation>Sanft</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>Start&amp;ing values</source>
        <translation>Sta&amp;rtwerte</translation>
    </message>
    <message>
        <source>Starting values: fill in</source>
        <translation>Startwerte eintragen</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>State of the selected module</source>
        <translation>Zustand des gewählten Moduls</translation>
    </message>
    <message>
        <source>%1, address %2</source>
        <translation>%1, Adresse %2</translation>
    </message>
    <message>
        <source>Pages of the module</source>
        <translation>Seiten des Moduls</translation>
    </message>
    <message>
        <source>A/D and PWM</source>
        <translation>A/D und PWM</translation>
    </message>
    <message>
        <source>A/D input</source>
        <translation>A/D-Eingang</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>Off at stop</source>
        <translation>Aus bei Stopp</translation>
    </message>
    <message>
        <source>%1 of 255</source>
        <translation>%1 von 255</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pins</translation>
    </message>
    <message>
        <source>input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>high</source>
        <translation>High</translation>
    </message>
    <message>
        <source>low</source>
        <translation>Low</translation>
    </message>
    <message>
        <source>Switches this output at once.</source>
        <translation>Schaltet diesen Ausgang sofort.</translation>
    </message>
    <message>
        <source>A search for home is running.</source>
        <translation>Eine Referenzfahrt läuft.</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>Limit 1</source>
        <translation>Endschalter 1</translation>
    </message>
    <message>
        <source>Limit 2</source>
        <translation>Endschalter 2</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Motorversorgung</translation>
    </message>
    <message>
        <source>A/D</source>
        <translation>A/D</translation>
    </message>
    <message>
        <source>Goal position</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>The goal position</source>
        <translation>Die Zielposition</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Use nearest</source>
        <translation>Nächstes nehmen</translation>
    </message>
    <message>
        <source>Use nearest allowed position</source>
        <translation>Nächstes nehmen: Die nächste erlaubte Position als Ziel eintragen</translation>
    </message>
    <message>
        <source>Zero here: set the present position to 0</source>
        <translation>Hier nullen: Die jetzige Position zu null machen</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Zur Referenz</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>A&amp;nfahren</translation>
    </message>
    <message>
        <source>Go to the position</source>
        <translation>Die Position anfahren</translation>
    </message>
    <message>
        <source>Run &amp;reverse</source>
        <translation>Rüc&amp;kwärts</translation>
    </message>
    <message>
        <source>Run reverse until stopped</source>
        <translation>Rückwärts: Dauerlauf rückwärts bis zum Stopp</translation>
    </message>
    <message>
        <source>R&amp;un forward</source>
        <translation>Vorw&amp;ärts</translation>
    </message>
    <message>
        <source>Run forward until stopped</source>
        <translation>Dauerlauf vorwärts bis zum Stopp</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 nehmen</translation>
    </message>
    <message>
        <source>Sets the goal to the nearest allowed position. Nothing moves.</source>
        <translation>Trägt die nächste erlaubte Position als Ziel ein. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Moves to the position, then holds.</source>
        <translation>Fährt zur Position und hält dort.</translation>
    </message>
    <message>
        <source>Runs forward until stopped.</source>
        <translation>Läuft vorwärts bis zum Stopp.</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped.</source>
        <translation>Läuft rückwärts bis zum Stopp.</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>Motorstrom</translation>
    </message>
    <message>
        <source>Motor off: this module</source>
        <translation>Motor aus: dieses Modul</translation>
    </message>
    <message>
        <source>A/D %1</source>
        <translation>A/D %1</translation>
    </message>
    <message>
        <source>Switches servo and amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Schaltet Servo und Verstärker aus: Der Motor ist frei drehbar, und eine Last kann absinken.</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>A/D (temperature)</source>
        <translation>A/D (Temperatur)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Nothing to redo.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Höchste Geschwindigkeit</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Square wave</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Method: how the command jumps</source>
        <translation>Art, wie die Sollposition springt</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Rise %1</source>
        <translation>Anstieg %1</translation>
    </message>
    <message>
        <source>Overshoot %1</source>
        <translation>Überschwingen %1</translation>
    </message>
    <message>
        <source>Steady-state error %1</source>
        <translation>Bleibende Abweichung %1</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Cursor readings</source>
        <translation>Cursorwerte</translation>
    </message>
    <message>
        <source>Cursor 1</source>
        <translation>Cursor 1</translation>
    </message>
    <message>
        <source>Cursor 2</source>
        <translation>Cursor 2</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Bild (PNG)…</translation>
    </message>
    <message>
        <source>The visible plot as an image.</source>
        <translation>Das sichtbare Diagramm als Bild.</translation>
    </message>
    <message>
        <source>&amp;Vector picture (SVG)…</source>
        <translation>&amp;Vektorbild (SVG)…</translation>
    </message>
    <message>
        <source>The visible plot as lines that stay sharp at any size.</source>
        <translation>Das sichtbare Diagramm in Linien, die in jeder Größe scharf bleiben.</translation>
    </message>
    <message>
        <source>P&amp;age (PDF)…</source>
        <translation>&amp;Seite (PDF)…</translation>
    </message>
    <message>
        <source>The visible plot on a page for printing or a report.</source>
        <translation>Das sichtbare Diagramm auf einer Seite zum Drucken oder für einen Bericht.</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>Prints the visible plot on one of this computer&apos;s printers.</source>
        <translation>Druckt das sichtbare Diagramm auf einem Drucker dieses Rechners.</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>SIMULATOR, no real motor moved</source>
        <translation>SIMULATOR, kein echter Motor bewegt</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>NMC Panel %1</source>
        <translation>NMC Panel %1</translation>
    </message>
    <message>
        <source>Overlay: %1</source>
        <translation>Unterlegt: %1</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Oszilloskop</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>von 255</translation>
    </message>
    <message>
        <source>Opens the port and looks for modules. Nothing moves.</source>
        <translation>Öffnet den Port und sucht Module. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>goes to all modules</source>
        <translation>geht an alle Module</translation>
    </message>
    <message>
        <source>Operator mode</source>
        <translation>Bedienermodus</translation>
    </message>
    <message>
        <source>Asks for the PIN.</source>
        <translation>Fragt nach der PIN.</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankunft</translation>
    </message>
    <message>
        <source>Work offsets</source>
        <translation>Nullpunktversätze</translation>
    </message>
    <message>
        <source>waits for the port</source>
        <translation>wartet auf die Schnittstelle</translation>
    </message>
    <message>
        <source>A sequence is already running.</source>
        <translation>Ein Ablauf läuft schon.</translation>
    </message>
    <message>
        <source>Its name on this machine. Sends nothing.</source>
        <translation>Sein Name an dieser Maschine. Sendet nichts.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation>Andere Programme</translation>
    </message>
</context>
<context>
    <name>Gains</name>
    <message>
        <source>Position gain</source>
        <translation>Lageverstärkung</translation>
    </message>
    <message>
        <source>Derivative gain</source>
        <translation>Differentialverstärkung</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>Integralverstärkung</translation>
    </message>
    <message>
        <source>Integration limit</source>
        <translation>Integralgrenze</translation>
    </message>
    <message>
        <source>Output limit</source>
        <translation>Ausgangsgrenze</translation>
    </message>
    <message>
        <source>Position error limit</source>
        <translation>Positionsfehlergrenze</translation>
    </message>
    <message>
        <source>Servo rate divisor</source>
        <translation>Servotakt-Teiler</translation>
    </message>
    <message>
        <source>Deadband compensation</source>
        <translation>Totzonenkompensation</translation>
    </message>
    <message>
        <source>Kp, position gain: output per count of position error. Set Kd first; then raise Kp with small, fast test moves until the motor starts to overshoot, and back off a little.</source>
        <translation>Kp, Lageverstärkung: Ausgangswert je Inkrement Positionsfehler. Zuerst Kd einstellen; dann Kp mit kleinen, schnellen Testfahrten erhöhen, bis der Motor überzuschwingen beginnt, und etwas zurücknehmen.</translation>
    </message>
    <message>
        <source>Kd, derivative gain: damping. Start here, with Kp and Ki at 0: raise Kd until the motor starts to hum, then back off a little.</source>
        <translation>Kd, Differentialverstärkung: Dämpfung. Hier beginnen, mit Kp und Ki auf 0: erhöhen, bis der Motor zu brummen beginnt, dann etwas zurücknehmen.</translation>
    </message>
    <message>
        <source>Ki, integral gain: removes the steady-state error that Kp and Kd leave. Set IL to 16000 first, then raise Ki until the error settles fast enough. Adds some overshoot.</source>
        <translation>Ki, Integralverstärkung: beseitigt die bleibende Regelabweichung, die Kp und Kd übrig lassen. Zuerst IL auf 16000 setzen, dann Ki erhöhen, bis die Abweichung schnell genug ausgeregelt ist. Das Überschwingen nimmt etwas zu.</translation>
    </message>
    <message>
        <source>IL, integration limit: limits the integral of the error. Last, lower it to the smallest value that still removes the steady-state error. 0 clears the integral.</source>
        <translation>IL, Integralgrenze: begrenzt das Integral der Abweichung. Zuletzt auf den kleinsten Wert senken, der die bleibende Abweichung noch ausregelt. 0 löscht das Integral.</translation>
    </message>
    <message>
        <source>OL, output limit: the largest PWM value; 255 is 100 %. Use 127 for a 12 V motor on a 24 V supply.</source>
        <translation>OL, Ausgangsgrenze: größter PWM-Wert, 255 entspricht 100 %. Für einen 12-V-Motor an 24 V auf 127 setzen.</translation>
    </message>
    <message>
        <source>CL, current limit, compared with the A/D value. 0: off. Odd: limits while the A/D value is above CL. Even: limits while it is below CL.</source>
        <translation>CL, Stromgrenze, wird mit dem A/D-Wert verglichen. 0: aus. Ungerade: begrenzt, wenn der A/D-Wert über CL liegt. Gerade: begrenzt, wenn er unter CL liegt.</translation>
    </message>
    <message>
        <source>EL, position error limit in counts: the servo switches off when the error exceeds it, for example after a collision or a stall.</source>
        <translation>EL, Positionsfehlergrenze in Inkrementen: Wird sie überschritten, schaltet sich der Servo ab, zum Beispiel nach einer Kollision oder Blockade.</translation>
    </message>
    <message>
        <source>SR, servo rate divisor: one servo tick is SR × 0.512 ms. A slower rate damps heavy loads with less Kd. Changing SR changes the meaning of every velocity and acceleration.</source>
        <translation>SR, Servotakt-Teiler: Ein Servotakt dauert SR x 0,512 ms. Ein langsamerer Takt dämpft schwere Lasten mit weniger Kd. Mit SR ändert sich die Bedeutung jeder Geschwindigkeit und Beschleunigung.</translation>
    </message>
    <message>
        <source>DB, deadband compensation: added to every PWM value except 0, for amplifiers with a deadband near zero. Version 4 and later.</source>
        <translation>DB, Totzonenkompensation: wird zu jedem PWM-Wert außer 0 addiert, für Verstärker mit einer Totzone nahe null. Ab Version 4.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>A/D above</source>
        <translation>A/D über</translation>
    </message>
    <message>
        <source>A/D below</source>
        <translation>A/D unter</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 auf %3</translation>
    </message>
</context>
<context>
    <name>LoopTestTexts</name>
    <message numerus="yes">
        <source>%n frequencies up to %1 Hz</source>
        <translation>
            <numerusform>%n Frequenz bis %1 Hz</numerusform>
            <numerusform>%n Frequenzen bis %1 Hz</numerusform>
        </translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) %1 Hz</source>
        <translation>Bandbreite (-3 dB) %1 Hz</translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) not reached</source>
        <translation>Bandbreite (-3 dB) nicht erreicht</translation>
    </message>
    <message>
        <source>Resonance %1 dB</source>
        <translation>Resonanz %1 dB</translation>
    </message>
    <message>
        <source>Phase margin %1° at %2 Hz</source>
        <translation>Phasenreserve %1° bei %2 Hz</translation>
    </message>
    <message>
        <source>Phase margin not reached</source>
        <translation>Phasenreserve nicht erreicht</translation>
    </message>
    <message>
        <source>Gain margin %1</source>
        <translation>Amplitudenreserve %1</translation>
    </message>
    <message>
        <source>Gain margin not reached</source>
        <translation>Amplitudenreserve nicht erreicht</translation>
    </message>
    <message>
        <source>Edit the gains to see what this loop would do with them.</source>
        <translation>Reglerwerte ändern, um zu sehen, was dieser Regelkreis damit täte.</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: OL or IL cut off the filter&apos;s output while measuring. Use a smaller amplitude.</source>
        <translation>Für die Reglerwerte in den Feldern nicht bekannt: OL oder IL hat bei der Messung die Ausgabe des Reglers begrenzt. Eine kleinere Amplitude nehmen.</translation>
    </message>
    <message>
        <source>OL or IL cut off the filter&apos;s output while measuring: for small motions, the loop responds differently. Use a smaller amplitude or a lower speed.</source>
        <translation>OL oder IL hat bei der Messung die Ausgabe des Reglers begrenzt: Bei kleinen Bewegungen antwortet der Regelkreis anders. Eine kleinere Amplitude oder eine geringere Geschwindigkeit nehmen.</translation>
    </message>
    <message>
        <source>unstable, the motor would oscillate</source>
        <translation>instabil, der Motor würde schwingen</translation>
    </message>
    <message>
        <source>known only from %1 to %2 Hz</source>
        <translation>nur von %1 bis %2 Hz bekannt</translation>
    </message>
    <message>
        <source>With the gains in the fields: %1</source>
        <translation>Mit den Reglerwerten in den Feldern: %1</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: SR differs from that of the measurement.</source>
        <translation>Für die Reglerwerte in den Feldern nicht bekannt: SR ist anders als bei der Messung.</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: DB differs from that of the measurement.</source>
        <translation>Für die Reglerwerte in den Feldern nicht bekannt: DB ist anders als bei der Messung.</translation>
    </message>
    <message>
        <source>known only at %1 Hz</source>
        <translation>nur bei %1 Hz bekannt</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>About NMC Panel</source>
        <translation>Über NMC Panel</translation>
    </message>
    <message>
        <source>A control panel for PIC-SERVO, PIC-STEP and PIC-I/O modules on one serial line.

Free software under the GNU General Public License, version 3 or later. Icons: Tabler, MIT licence. Built with Qt %1.</source>
        <translation>Bedienprogramm für Module PIC-SERVO, PIC-STEP und PIC-I/O an einer seriellen Leitung.

Freie Software unter der GNU General Public License, Version 3 oder später. Symbole: Tabler, MIT-Lizenz. Erstellt mit Qt %1.</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Layout zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&amp;Safety</source>
        <translation>&amp;Sicherheit</translation>
    </message>
    <message>
        <source>&amp;About NMC Panel</source>
        <translation>&amp;Über NMC Panel</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Befehl &amp;finden…</translation>
    </message>
    <message>
        <source>Colour&amp;s</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The new language takes effect the next time you start NMC Panel.</source>
        <translation>Die neue Sprache gilt ab dem nächsten Start von NMC Panel.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>S&amp;ystem</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>&amp;Problem melden…</translation>
    </message>
</context>
<context>
    <name>MessageLines</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n-mal</numerusform>
            <numerusform>%n-mal</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Endete: %1</translation>
    </message>
</context>
<context>
    <name>ModelTexts</name>
    <message>
        <source>Gain %1</source>
        <translation>Verstärkung %1</translation>
    </message>
    <message>
        <source>counts/s per PWM count</source>
        <translation>Ink./s je PWM-Stufe</translation>
    </message>
    <message>
        <source>Time constant %1</source>
        <translation>Zeitkonstante %1</translation>
    </message>
    <message>
        <source>Friction %1</source>
        <translation>Reibung %1</translation>
    </message>
    <message>
        <source>of 255 PWM</source>
        <translation>von 255 PWM</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>Last %1</translation>
    </message>
    <message>
        <source>Model error %1 counts RMS; encoder and timing account for %2.</source>
        <translation>Modellabweichung %1 Ink. (RMS); Encoder und Zeitmessung erklären %2.</translation>
    </message>
    <message>
        <source>Too few samples. Record for longer, or raise the baud rate.</source>
        <translation>Es gibt zu wenige Messwerte. Länger aufzeichnen oder die Baudrate erhöhen.</translation>
    </message>
    <message>
        <source>The shaft did not move. Check motor power and brake, or use a larger step.</source>
        <translation>Die Welle hat sich nicht bewegt. Motorversorgung und Bremse prüfen oder einen größeren Sprung machen.</translation>
    </message>
    <message>
        <source>The shaft moved away from its goal. Check the direction on the Axis page.</source>
        <translation>Die Welle läuft von ihrem Ziel weg. Auf der Seite Achse die Richtung prüfen.</translation>
    </message>
    <message>
        <source>The motor keeps oscillating. Lower Kp or raise Kd, then step again.</source>
        <translation>Der Motor schwingt weiter. Kp verringern oder Kd erhöhen, dann den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>The model does not fit the step. Check for backlash, an elastic belt, a hard stop or a current limit.</source>
        <translation>Das Modell passt nicht zum Sprung. Auf Spiel, einen elastischen Riemen, einen Anschlag oder eine Stromgrenze prüfen.</translation>
    </message>
    <message>
        <source>These steps do not determine the motor gain. Add a larger step, so that the motor gets close to a steady speed.</source>
        <translation>Aus diesen Sprüngen lässt sich die Verstärkung des Motors nicht bestimmen. Einen größeren Sprung hinzufügen, damit der Motor nahezu konstante Geschwindigkeit erreicht.</translation>
    </message>
    <message>
        <source>These steps do not determine the time constant. Repeat the step, or raise the baud rate.</source>
        <translation>Aus diesen Sprüngen lässt sich die Zeitkonstante nicht bestimmen. Den Sprung wiederholen oder die Baudrate erhöhen.</translation>
    </message>
    <message>
        <source>Overshoot %1, settling %2</source>
        <translation>Überschwingen %1, Einschwingen %2</translation>
    </message>
    <message>
        <source>Steady-state error %1 counts</source>
        <translation>Bleibende Abweichung %1 Ink.</translation>
    </message>
    <message>
        <source>Phase margin %1°, gain margin %2</source>
        <translation>Phasenreserve %1°, Amplitudenreserve %2</translation>
    </message>
    <message>
        <source>Phase margin %1°</source>
        <translation>Phasenreserve %1°</translation>
    </message>
    <message>
        <source>Uncertain: step once more. Until then the suggested gains are conservative.</source>
        <translation>Unsicher: noch einen Sprung aufzeichnen. Bis dahin sind die vorgeschlagenen Reglerwerte vorsichtig.</translation>
    </message>
    <message>
        <source>The motor stopped abruptly short of its goal. Something is in its way: a hard stop, or its load. Clear the way, or step in the other direction.</source>
        <translation>Der Motor blieb vor seinem Ziel schlagartig stehen. Etwas ist im Weg: ein Anschlag oder das, was er antreibt. Platz schaffen oder in die andere Richtung springen.</translation>
    </message>
    <message>
        <source>In %1 of 100 cases the motor stops too far from its goal.</source>
        <translation>In %1 von 100 Fällen bleibt der Motor zu weit von seinem Ziel stehen.</translation>
    </message>
    <message>
        <source>Amplifier deadband %1</source>
        <translation>Totzone des Verstärkers %1</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>Spiel %1</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Ink.</translation>
    </message>
    <message>
        <source>A resonance above %1 Hz would not show; the margins allow for one.</source>
        <translation>Eine Resonanz oberhalb von %1 Hz wäre nicht zu sehen; die Reserven berücksichtigen eine.</translation>
    </message>
    <message>
        <source>The motor probably has more than %1 counts of play: that much motion is lost at each reversal. Take up the play between motor and encoder.</source>
        <translation>Der Motor hat vermutlich mehr als %1 Inkremente Spiel: So viel geht beim Umkehren verloren. Das Spiel zwischen Motor und Encoder beseitigen.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>%1 counts, %2</source>
        <translation>%1 Inkremente, %2</translation>
    </message>
    <message>
        <source>Settling to ±%1 %: %2</source>
        <translation>Einschwingen auf ±%1 %: %2</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Reglereinstellung von %1</translation>
    </message>
    <message>
        <source>simulated; no real motor moved</source>
        <translation>simuliert: kein echter Motor bewegt</translation>
    </message>
    <message>
        <source>Speed while measuring %1 counts/s</source>
        <translation>Geschwindigkeit beim Messen %1 Inkremente/s</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>%1 counts in %2 s</source>
        <translation>%1 Inkremente in %2 s</translation>
    </message>
    <message>
        <source>Settling to ±%1 counts for %2 s: %3</source>
        <translation>Einschwingen auf ±%1 Inkremente für %2 s: %3</translation>
    </message>
    <message>
        <source>Peak error %1</source>
        <translation>Größter Fehler %1</translation>
    </message>
    <message>
        <source>RMS error %1</source>
        <translation>Effektivwert des Fehlers %1</translation>
    </message>
</context>
<context>
    <name>ResponseTexts</name>
    <message>
        <source>too few samples</source>
        <translation>zu wenige Messwerte</translation>
    </message>
    <message>
        <source>did not reach 90 %</source>
        <translation>90 % nicht erreicht</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Very fast profile</source>
        <translation>Sehr schnelles Profil</translation>
    </message>
    <message>
        <source>Stop here, at the goal</source>
        <translation>Hier stoppen, am Ziel</translation>
    </message>
    <message>
        <source>A move with velocity and acceleration so high that its profile reaches the goal in one servo tick. CMC and SC stop here, at the goal, instead.</source>
        <translation>Eine Fahrt mit so viel Geschwindigkeit und Beschleunigung, dass ihr Profil in einem Takt am Ziel ist. CMC und SC stoppen stattdessen hier, am Ziel.</translation>
    </message>
    <message>
        <source>The servo holds the goal at once, without a profile. Not available with version 1.</source>
        <translation>Der Servo hält sofort das Ziel, ohne Profil. Nicht mit Version 1.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>limited to %1</source>
        <translation>begrenzt auf %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>samples missing, repeat</source>
        <translation>Messwerte fehlen, wiederholen</translation>
    </message>
    <message>
        <source>%1, off its goal</source>
        <translation>%1, neben dem Ziel</translation>
    </message>
    <message>
        <source>never constant</source>
        <translation>nie konstant</translation>
    </message>
    <message>
        <source>Profiled move</source>
        <translation>Fahrt mit Profil</translation>
    </message>
    <message>
        <source>No step: moves there and back with the velocity and acceleration below, judged by a window and a dwell. Not available with version 1.</source>
        <translation>Kein Sprung: Fahrten hin und zurück mit der Geschwindigkeit und Beschleunigung darunter, bewertet nach Fenster und Verweilzeit. Bei Version 1 nicht verfügbar.</translation>
    </message>
    <message>
        <source>%1 of %2 settled</source>
        <translation>%1 von %2 eingeschwungen</translation>
    </message>
    <message>
        <source>%1 to %2 ms (%3)</source>
        <translation>%1 bis %2 ms (%3)</translation>
    </message>
</context>
<context>
    <name>Scope</name>
    <message>
        <source>%1, by %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>From %1; 0 s is %2</source>
        <translation>Ab %1; 0 s ist %2</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Go to live</source>
        <translation>Zu live</translation>
    </message>
    <message>
        <source>Values up</source>
        <translation>Werte nach oben</translation>
    </message>
    <message>
        <source>Values down</source>
        <translation>Werte nach unten</translation>
    </message>
    <message>
        <source>Zoom values in</source>
        <translation>Werte vergrößern</translation>
    </message>
    <message>
        <source>Zoom values out</source>
        <translation>Werte verkleinern</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>Werte einpassen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>command, calculated</source>
        <translation>Sollposition, berechnet</translation>
    </message>
    <message>
        <source>error, calculated</source>
        <translation>Positionsfehler, berechnet</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>PWM, calculated</source>
        <translation>PWM, berechnet</translation>
    </message>
    <message>
        <source>A/D 2</source>
        <translation>A/D 2</translation>
    </message>
    <message>
        <source>A/D 3</source>
        <translation>A/D 3</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>count rate</source>
        <translation>Zählrate</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Zählwerte</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>Zählwerte/s</translation>
    </message>
    <message>
        <source>One row per reply, can be reopened here (*.csv)</source>
        <translation>Eine Zeile je Antwort, hier wieder zu öffnen (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, for other programs only (*.csv)</source>
        <translation>Eine Spalte je Signal, nur für andere Programme (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, every millisecond, for other programs only (*.csv)</source>
        <translation>Eine Spalte je Signal, jede Millisekunde, nur für andere Programme (*.csv)</translation>
    </message>
    <message>
        <source>custom trace %1</source>
        <translation>eigene Kurve %1</translation>
    </message>
    <message>
        <source>error, reported</source>
        <translation>Positionsfehler, gemeldet</translation>
    </message>
</context>
<context>
    <name>StepperWords</name>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 Schritte/s</translation>
    </message>
    <message>
        <source>%1x: %2 to %3 steps/s</source>
        <translation>%1x: %2 bis %3 Schritte/s</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2, the minimum profile speed.</source>
        <translation>Läuft mit %1: Geschwindigkeit %2, die kleinste Profilgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2 of 250.</source>
        <translation>Läuft mit %1: Geschwindigkeit %2 von 250.</translation>
    </message>
    <message>
        <source>Runs at %1: timer count %2.</source>
        <translation>Läuft mit %1: Timerwert %2.</translation>
    </message>
    <message>
        <source>%1 steps/s²</source>
        <translation>%1 Schritte/s²</translation>
    </message>
    <message>
        <source>The motor is already there.</source>
        <translation>Der Motor ist bereits dort.</translation>
    </message>
    <message>
        <source>Takes %1 s. Too short for that speed: peaks at %2.</source>
        <translation>Dauert %1 s. Zu kurz für diese Geschwindigkeit: Spitze %2.</translation>
    </message>
    <message>
        <source>Takes %1 s, peak speed %2.</source>
        <translation>Dauert %1 s, Spitze %2.</translation>
    </message>
    <message>
        <source>Ramp of %1.</source>
        <translation>Rampe von %1.</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>error, zoomed (%1)</source>
        <translation>Abweichung, vergrößert (%1)</translation>
    </message>
    <message>
        <source>PWM, calculated (of 255)</source>
        <translation>PWM, berechnet (von 255)</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Port &quot;%1&quot; not found. Only the simulator is available: --simulator.</source>
        <translation>Es gibt keinen Port „%1“. Nur der Simulator ist vorhanden: --simulator.</translation>
    </message>
    <message>
        <source>Port &quot;%1&quot; not found. Available ports: %2.</source>
        <translation>Es gibt keinen Port „%1“. Vorhanden sind: %2.</translation>
    </message>
    <message>
        <source>These modules do not support the baud rate &quot;%1&quot;. Use %2.</source>
        <translation>Diese Module unterstützen die Baudrate „%1“ nicht. Möglich sind: %2.</translation>
    </message>
    <message>
        <source>The simulator does not understand the chain &quot;%1&quot;: %2 An example: --simulator=servo,servo@1</source>
        <translation>Der Simulator versteht die Kette „%1“ nicht: %2 Ein Beispiel: --simulator=servo,servo@1</translation>
    </message>
    <message>
        <source>Unknown option &quot;%1&quot;. Use --help for a list.</source>
        <translation>Unbekannte Option „%1“. --help zeigt eine Liste.</translation>
    </message>
    <message>
        <source>No display found: neither DISPLAY nor WAYLAND_DISPLAY is set.</source>
        <translation>Keine Anzeige gefunden: weder DISPLAY noch WAYLAND_DISPLAY ist gesetzt.</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>Use simulator</source>
        <translation>Simulator verwenden</translation>
    </message>
    <message>
        <source>Choose another port</source>
        <translation>Anderen Port wählen</translation>
    </message>
    <message>
        <source>Motor state unknown; no motor was moving when last seen.</source>
        <translation>Motorzustand unbekannt; zuletzt bewegte sich kein Motor.</translation>
    </message>
    <message>
        <source>Your user account has no permission to use %1.</source>
        <translation>Ihr Benutzerkonto darf %1 nicht verwenden.</translation>
    </message>
    <message>
        <source>Ask your system administrator for access.</source>
        <translation>Bitten Sie Ihre Systemverwaltung um Zugriff.</translation>
    </message>
    <message>
        <source>It belongs to the group %1. Run %2, then log out and in again.</source>
        <translation>Der Port gehört der Gruppe %1. %2 ausführen, dann ab- und wieder anmelden.</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>%1 is used by another program.</source>
        <translation>%1 wird von einem anderen Programm verwendet.</translation>
    </message>
    <message>
        <source>Close it and try again.</source>
        <translation>Das andere Programm schließen und erneut versuchen.</translation>
    </message>
    <message>
        <source>Close it and try again. Or use nmcctl through it: in its Chain menu, switch on &quot;Let programs in&quot;, and leave out --port.</source>
        <translation>Das andere Programm schließen und erneut versuchen. Oder nmcctl darüber benutzen: dort im Menü Kette „Programme einlassen“ einschalten und --port weglassen.</translation>
    </message>
    <message>
        <source>%1 not found.</source>
        <translation>%1 nicht gefunden.</translation>
    </message>
    <message>
        <source>Check that the adapter is plugged in. Its name may have changed.</source>
        <translation>Prüfen, ob der Adapter eingesteckt ist. Sein Name kann sich geändert haben.</translation>
    </message>
    <message>
        <source>%1 is not a serial port.</source>
        <translation>%1 ist keine serielle Schnittstelle.</translation>
    </message>
    <message>
        <source>Choose the adapter&apos;s port, for example /dev/ttyUSB0.</source>
        <translation>Den Port des Adapters wählen, zum Beispiel /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>%1 does not support the selected baud rate.</source>
        <translation>%1 unterstützt die gewählte Baudrate nicht.</translation>
    </message>
    <message>
        <source>Choose another baud rate; every adapter supports 19 200 Bd.</source>
        <translation>Eine andere Rate wählen; 19 200 Bd beherrscht jeder Adapter.</translation>
    </message>
    <message>
        <source>The adapter at %1 was unplugged. %2</source>
        <translation>Der Adapter an %1 wurde abgezogen. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then plug the adapter in again.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen, dann den Adapter wieder einstecken.</translation>
    </message>
    <message>
        <source>Could not open %1.</source>
        <translation>%1 konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>System message: %1</source>
        <translation>Meldung des Systems: %1</translation>
    </message>
    <message>
        <source>Not every module answered at %1 Bd, so the modules cannot be used yet.</source>
        <translation>Bei %1 Bd haben nicht alle Module geantwortet; die Module sind daher noch nicht verwendbar.</translation>
    </message>
    <message>
        <source>Module %1 did not answer at %2 Bd, so the modules cannot be used yet.</source>
        <translation>Modul %1 hat bei %2 Bd nicht geantwortet; die Module sind daher noch nicht verwendbar.</translation>
    </message>
    <message>
        <source>Usually the cable is too long for this baud rate, or termination is missing. Choose a lower baud rate for %1 and scan again.</source>
        <translation>Meist ist das Kabel zu lang für diese Rate, oder der Abschluss fehlt. Eine niedrigere Rate für %1 wählen und erneut suchen.</translation>
    </message>
    <message>
        <source>Modules answered at %1, but their answers were garbled.</source>
        <translation>Module haben an %1 geantwortet, aber ihre Antworten waren gestört.</translation>
    </message>
    <message>
        <source>Usually noise on the cable, or two modules answering at once. Check the cable, its termination and the ADDR_IN jumpers.</source>
        <translation>Meist Störungen auf dem Kabel, oder zwei Module antworten gleichzeitig. Kabel, Abschluss und ADDR_IN-Jumper prüfen.</translation>
    </message>
    <message>
        <source>Port %1, %2 Bd</source>
        <translation>Port %1, %2 Bd</translation>
    </message>
    <message>
        <source>module %1</source>
        <translation>Modul %1</translation>
    </message>
    <message>
        <source>module %1 &quot;%2&quot;</source>
        <translation>Modul %1 „%2“</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two.</source>
        <translation>Die Nummerierung beginnt am fernen Ende. Deshalb das nächste Modul in Richtung PC nach %1 prüfen: zuerst seine Versorgung, dann den Stecker dazwischen.</translation>
    </message>
    <message>
        <source>Work with %1</source>
        <translation>Mit %1 arbeiten</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd.</source>
        <translation>Verbunden mit %1: %2 bei %3 Bd.</translation>
    </message>
    <message>
        <source>Nothing moves until you command it. Gains are unknown until you apply them.</source>
        <translation>Nichts bewegt sich ohne Anforderung. Die Reglerwerte sind unbekannt, bis sie angewendet werden.</translation>
    </message>
    <message>
        <source>Disconnected from %1.</source>
        <translation>Verbindung zu %1 getrennt.</translation>
    </message>
    <message>
        <source>All modules on %1 stopped answering. %2</source>
        <translation>Alle Module an %1 antworten nicht mehr. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Then check the power of the modules and the cable at the PC.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen. Dann die Versorgung der Module und das Kabel am PC prüfen.</translation>
    </message>
    <message>
        <source>The link is unreliable: %1 of the last %2 exchanges failed.</source>
        <translation>Die Verbindung ist unzuverlässig: %1 der letzten %2 Übertragungen sind misslungen.</translation>
    </message>
    <message>
        <source>Updates are slow (%1 per second) because the USB adapter waits %2 ms before passing data on.</source>
        <translation>Die Werte kommen langsam (%1 pro Sekunde), weil der USB-Adapter Daten erst nach %2 ms weitergibt.</translation>
    </message>
    <message>
        <source>Set its latency timer to 1 ms.</source>
        <translation>Den Latenz-Timer des Adapters auf 1 ms stellen.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown: it was moving.</source>
        <translation>Modul %1 antwortet seit %2 s nicht. Motorzustand unbekannt: Der Motor war in Bewegung.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown; it was stopped when last seen.</source>
        <translation>Modul %1 antwortet seit %2 s nicht. Motorzustand unbekannt; zuletzt stand der Motor.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. The state of its outputs is unknown.</source>
        <translation>Modul %1 antwortet seit %2 s nicht. Der Zustand seiner Ausgänge ist unbekannt.</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Check its power and the plug next to it; the panel keeps trying.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen. Versorgung des Moduls und den Stecker neben ihm prüfen; das Programm versucht es weiter.</translation>
    </message>
    <message>
        <source>Module %1 may not answer until module %2 has its address again.</source>
        <translation>Modul %1 antwortet möglicherweise erst, wenn Modul %2 wieder seine Adresse hat.</translation>
    </message>
    <message>
        <source>Restart the network…</source>
        <translation>Netzwerk neu starten…</translation>
    </message>
    <message>
        <source>Module %1 received a garbled command and did not carry it out.</source>
        <translation>Modul %1 hat einen gestörten Befehl empfangen und nicht ausgeführt.</translation>
    </message>
    <message>
        <source>Sending again (%1 of 3). Usually noise on the cable.</source>
        <translation>Erneut gesendet (%1 von 3). Meist Störungen auf dem Kabel.</translation>
    </message>
    <message>
        <source>The answer from module %1 was garbled.</source>
        <translation>Die Antwort von Modul %1 war gestört.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; the panel is reading the position again.</source>
        <translation>Ob der Befehl ausgeführt wurde, ist ungewiss; das Programm liest die Position neu.</translation>
    </message>
    <message>
        <source>Command byte %1</source>
        <translation>Befehlsbyte %1</translation>
    </message>
    <message>
        <source>Module %1: done.</source>
        <translation>Modul %1: erledigt.</translation>
    </message>
    <message>
        <source>Module %1 received the command garbled and did not carry it out.</source>
        <translation>Modul %1 hat den Befehl gestört empfangen und nicht ausgeführt.</translation>
    </message>
    <message>
        <source>Sent 3 times; later commands were not sent. Usually noise on the cable.</source>
        <translation>3-mal gesendet; spätere Befehle wurden nicht gesendet. Meist Störungen auf dem Kabel.</translation>
    </message>
    <message>
        <source>Module %1 did not answer the command. Motor state unknown.</source>
        <translation>Modul %1 hat auf den Befehl nicht geantwortet. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; later commands were not sent. Look at the motor; stop all if in doubt.</source>
        <translation>Ob der Befehl ausgeführt wurde, ist ungewiss; spätere Befehle wurden nicht gesendet. Den Motor ansehen; im Zweifel alles stoppen.</translation>
    </message>
    <message>
        <source>Module %1 cannot do this in its present state. Nothing was sent.</source>
        <translation>Modul %1 kann das in seinem jetzigen Zustand nicht. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Stop the motor, then try again.</source>
        <translation>Den Motor stoppen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>The command for module %1 was cancelled.</source>
        <translation>Der Befehl für Modul %1 wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to module %1.</source>
        <translation>Zu viele Befehle warten. An Modul %1 wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Wait until they are carried out, or press STOP ALL to discard them.</source>
        <translation>Warten Sie, bis sie ausgeführt sind, oder verwerfen Sie sie mit ALLES STOPP.</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was more than %2 counts from where it should be.</source>
        <translation>Modul %1 hat seinen Servo abgeschaltet, weil der Motor mehr als %2 Inkremente von der Sollposition entfernt war.</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was too far from where it should be.</source>
        <translation>Modul %1 hat seinen Servo abgeschaltet, weil der Motor zu weit von der Sollposition entfernt war.</translation>
    </message>
    <message>
        <source>Clear and stay off</source>
        <translation>Löschen, Servo bleibt aus</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its servo is off.</source>
        <translation>Modul %1 hat keine Motorversorgung, daher ist sein Servo aus.</translation>
    </message>
    <message>
        <source>It stays off when power returns.</source>
        <translation>Er bleibt aus, wenn die Versorgung wiederkehrt.</translation>
    </message>
    <message>
        <source>The computer was busy, or the program that jogs it has stopped calling. Press and hold again.</source>
        <translation>Der Rechner war ausgelastet, oder das Programm, das tippt, rief nicht mehr auf. Erneut drücken und halten.</translation>
    </message>
    <message>
        <source>Module %1 cannot do this now; nothing was sent.</source>
        <translation>Für Modul %1 jetzt nicht möglich; es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>reaches %1 of %2</source>
        <translation>erreicht %1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped before the port closes.</source>
        <translation>
            <numerusform>%n Motor ist in Bewegung. Er wird gestoppt, bevor der Port geschlossen wird.</numerusform>
            <numerusform>%n Motoren sind in Bewegung. Sie werden gestoppt, bevor der Port geschlossen wird.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopping the motors, then closing.</source>
        <translation>Die Motoren werden gestoppt, dann wird der Port geschlossen.</translation>
    </message>
    <message>
        <source>Fit a hardware emergency stop that removes motor power.</source>
        <translation>Einen Hardware-Not-Halt vorsehen, der die Motorversorgung trennt.</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Module %1</source>
        <translation>Modul %1</translation>
    </message>
    <message>
        <source>type %1</source>
        <translation>Typ %1</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>Not asked</source>
        <translation>Nicht abgefragt</translation>
    </message>
    <message>
        <source>No motor power</source>
        <translation>Versorgung fehlt</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>Servo aus</translation>
    </message>
    <message>
        <source>Power was lost</source>
        <translation>Versorgung fehlte</translation>
    </message>
    <message>
        <source>PWM mode</source>
        <translation>PWM-Betrieb</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Hält Position</translation>
    </message>
    <message>
        <source>Accelerating</source>
        <translation>Beschleunigt</translation>
    </message>
    <message>
        <source>At speed</source>
        <translation>Konstantfahrt</translation>
    </message>
    <message>
        <source>Decelerating</source>
        <translation>Bremst</translation>
    </message>
    <message>
        <source>No status received from this module yet.</source>
        <translation>Von diesem Modul ist noch kein Status eingetroffen.</translation>
    </message>
    <message>
        <source>The module does not answer. Motor state unknown.</source>
        <translation>Das Modul antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>Sending has stopped because another module restarted, so what this one does now is not known. Scan again, or restart the network.</source>
        <translation>Weil ein anderes Modul neu gestartet ist, wird nichts mehr gesendet; was dieses jetzt tut, ist daher nicht bekannt. Erneut suchen oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the servo is switched off.</source>
        <translation>Der Motor ist frei drehbar. Das ist normal: Der Servo ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>The servo switched itself off because the motor was too far from where it should be.</source>
        <translation>Der Servo hat sich abgeschaltet, weil der Motor zu weit von der Sollposition entfernt war.</translation>
    </message>
    <message>
        <source>A fixed PWM value drives the motor; the servo does not control it. After a loss of motor power, the motor may turn again by itself.</source>
        <translation>Ein fester PWM-Wert treibt den Motor an; der Servo regelt ihn nicht. Nach einem Ausfall der Motorversorgung kann der Motor sich von selbst wieder drehen.</translation>
    </message>
    <message>
        <source>The motor is changing its speed.</source>
        <translation>Der Motor ändert seine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The motor moves at its goal velocity.</source>
        <translation>Der Motor fährt mit seiner Zielgeschwindigkeit.</translation>
    </message>
    <message>
        <source>The motor is slowing down.</source>
        <translation>Der Motor wird langsamer.</translation>
    </message>
    <message>
        <source>Not connected. Choose a port and connect first.</source>
        <translation>Nicht verbunden: zuerst einen Port wählen und verbinden.</translation>
    </message>
    <message>
        <source>This module is not a PIC-SERVO.</source>
        <translation>Dieses Modul ist kein PIC-SERVO.</translation>
    </message>
    <message>
        <source>The module does not answer, so its state is unknown.</source>
        <translation>Das Modul antwortet nicht, sein Zustand ist daher unbekannt.</translation>
    </message>
    <message>
        <source>This is not the type of module that the machine has here, so its settings do not apply. Only stop commands work until you accept the chain as found (Chain doctor).</source>
        <translation>Die Maschine hat hier einen anderen Modultyp, ihre Einstellungen gelten daher nicht. Bis die Kette so übernommen wird, wie sie ist (Kettendiagnose), wirken nur Stopps.</translation>
    </message>
    <message>
        <source>The module has no motor power.</source>
        <translation>Das Modul hat keine Motorversorgung.</translation>
    </message>
    <message>
        <source>The gains are 0 or unknown, so the motor would not hold. Apply gains first.</source>
        <translation>Die Reglerwerte sind 0 oder unbekannt, der Motor würde nicht halten. Zuerst die Reglerwerte anwenden.</translation>
    </message>
    <message>
        <source>The servo is off. Enable it first.</source>
        <translation>Der Servo ist aus. Zuerst einschalten.</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first: a move to a position starts from standstill.</source>
        <translation>Der Motor ist in Bewegung. Eine Position wird aus dem Stillstand angefahren: zuerst stoppen.</translation>
    </message>
    <message>
        <source>The acceleration is 0 or unknown: the motor might not start or stop. Enter an acceleration.</source>
        <translation>Die Beschleunigung ist 0 oder unbekannt: Der Motor könnte vielleicht nicht anlaufen oder anhalten. Eine Beschleunigung eingeben.</translation>
    </message>
    <message>
        <source>The velocity is 0 or unknown: the motor might not move, or move too fast. Enter a velocity.</source>
        <translation>Die Geschwindigkeit ist 0 oder unbekannt: Der Motor würde sich vielleicht nicht oder zu schnell bewegen. Eine Geschwindigkeit eingeben.</translation>
    </message>
    <message>
        <source>The chip cannot turn the motor this slowly in its speed mode. Enter a higher velocity, or choose another speed mode.</source>
        <translation>So langsam kann der Chip den Motor in seinem Geschwindigkeitsmodus nicht drehen. Eine höhere Geschwindigkeit eingeben oder einen anderen Geschwindigkeitsmodus wählen.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>restarting the modules</source>
        <translation>Module werden neu gestartet</translation>
    </message>
    <message>
        <source>assigning addresses</source>
        <translation>Adressen werden vergeben</translation>
    </message>
    <message>
        <source>reading types and versions</source>
        <translation>Typ und Version werden abgefragt</translation>
    </message>
    <message>
        <source>changing the baud rate</source>
        <translation>Rate wird geändert</translation>
    </message>
    <message>
        <source>setting up status reports</source>
        <translation>Statusmeldungen werden vorbereitet</translation>
    </message>
    <message>
        <source>Simulator (%1)</source>
        <translation>Simulator (%1)</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Connecting to %1: %2</source>
        <translation>Verbinden mit %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 so far</source>
        <translation>%1, bisher %2</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3</source>
        <translation>Verbunden mit %1 bei %2 Bd, %3</translation>
    </message>
    <message>
        <source>%1 is open, but no module is usable</source>
        <translation>%1 ist offen, aber kein Modul ist verwendbar</translation>
    </message>
    <message>
        <source>Connection to %1 lost, motor state unknown</source>
        <translation>Verbindung zu %1 verloren, Motorzustand unbekannt</translation>
    </message>
    <message>
        <source>Sending to %1 has stopped: module %2 restarted</source>
        <translation>An %1 wird nichts mehr gesendet: Modul %2 ist neu gestartet</translation>
    </message>
    <message numerus="yes">
        <source>%n modules</source>
        <translation>
            <numerusform>%n Modul</numerusform>
            <numerusform>%n Module</numerusform>
        </translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Ink.</translation>
    </message>
    <message>
        <source>counts/tick</source>
        <translation>Ink./Takt</translation>
    </message>
    <message>
        <source>counts/tick²</source>
        <translation>Ink./Takt²</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Erledigt: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Answer to: %1</source>
        <translation>Antwort auf: %1</translation>
    </message>
    <message>
        <source>Two modules on %1 have the same address, so the modules cannot be used.</source>
        <translation>Zwei Module antworten an %1 unter derselben Adresse; die Module sind so nicht benutzbar.</translation>
    </message>
    <message>
        <source>No motor was moved. Usually two ADDR_IN inputs are grounded; ground only that of the module farthest from the PC.</source>
        <translation>Es wurde kein Motor bewegt. Meist liegen zwei ADDR_IN-Eingänge auf Masse: Nur der des vom PC am weitesten entfernten Moduls darf auf Masse liegen.</translation>
    </message>
    <message>
        <source>The line at %1 is held low: only zero bytes arrive.</source>
        <translation>Die Leitung an %1 wird auf Low gehalten: Es kommen nur Nullbytes an.</translation>
    </message>
    <message>
        <source>Motor state unknown; commands may not get through. Usually a short circuit, swapped wires of a pair, or a module without power.</source>
        <translation>Motorzustand unbekannt; Befehle kommen vielleicht nicht an. Meist ein Kurzschluss, vertauschte Adern eines Paars oder ein Modul ohne Versorgung.</translation>
    </message>
    <message>
        <source>The modules on %1 have no addresses yet.</source>
        <translation>Die Module an %1 haben noch keine Adressen.</translation>
    </message>
    <message>
        <source>A read-only connection cannot assign addresses. Choose Connect fully.</source>
        <translation>Eine nur lesende Verbindung kann keine Adressen vergeben. Ohne „nur lesen“ verbinden.</translation>
    </message>
    <message>
        <source>The link is marginal: %1 of the last %2 exchanges failed.</source>
        <translation>Die Verbindung ist grenzwertig: %1 der letzten %2 Übertragungen sind misslungen.</translation>
    </message>
    <message>
        <source>Motor state unknown. Look at the motor; stop all if in doubt.</source>
        <translation>Motorzustand unbekannt. Den Motor ansehen; im Zweifel alles stoppen.</translation>
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
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>The panel froze for %1 while a motor was moving. The motor was not stopped.</source>
        <translation>Das Programm reagierte %1 lang nicht, während sich ein Motor bewegte. Der Motor wurde nicht gestoppt.</translation>
    </message>
    <message>
        <source>STOP ALL did not work during that time. The computer was busy, or the program hung.</source>
        <translation>ALLES STOPP wirkte in dieser Zeit nicht. Der Rechner war ausgelastet, oder das Programm hing.</translation>
    </message>
    <message>
        <source>Resumed after %1: reading all values again.</source>
        <translation>Aufgewacht nach %1: Alle Werte werden neu gelesen.</translation>
    </message>
    <message>
        <source>Resumed after %1: motors were commanded to stop; reading all values again.</source>
        <translation>Aufgewacht nach %1: An die Motoren ging ein Stoppbefehl; alle Werte werden neu gelesen.</translation>
    </message>
    <message>
        <source>While the computer was suspended, the panel could not stop a motor. Look at the motors before the next move.</source>
        <translation>Während der Rechner im Ruhezustand war, konnte das Programm keinen Motor stoppen. Sehen Sie vor der nächsten Bewegung nach den Motoren.</translation>
    </message>
    <message numerus="yes">
        <source>The last session ended while motors %1 were moving.</source>
        <translation>
            <numerusform>Die letzte Sitzung endete, während sich Motor %1 bewegte.</numerusform>
            <numerusform>Die letzte Sitzung endete, während sich die Motoren %1 bewegten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Settings cannot be saved.</source>
        <translation>Einstellungen werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works; only the window layout and the last port are not remembered.</source>
        <translation>%1 ist nicht beschreibbar. Alles andere funktioniert; nur die Fensteranordnung und der letzte Port bleiben nicht erhalten.</translation>
    </message>
    <message>
        <source>%1 is used by another program (pid %2).</source>
        <translation>%1 wird von einem anderen Programm benutzt (PID %2).</translation>
    </message>
    <message>
        <source>%1 is used by %2 (pid %3).</source>
        <translation>%1 wird von %2 benutzt (PID %3).</translation>
    </message>
    <message>
        <source>It probes a newly connected adapter for a modem for a few seconds; wait, then try again. To keep it away from USB adapters, run %1, then plug the adapter in again.</source>
        <translation>Es prüft einen neu angeschlossenen Adapter einige Sekunden lang auf ein Modem; warten, dann erneut versuchen. Um es von USB-Adaptern fernzuhalten, %1 ausführen, dann den Adapter neu einstecken.</translation>
    </message>
    <message>
        <source>It mistakes many serial adapters for a Braille display. If you have none, run %1, then plug the adapter in again.</source>
        <translation>Es hält viele serielle Adapter für eine Braillezeile. Wird keine benutzt, %1 ausführen, dann den Adapter neu einstecken.</translation>
    </message>
    <message>
        <source>%1 is free, but a stale lock file marks it as in use.</source>
        <translation>%1 ist frei, aber eine veraltete Sperrdatei weist den Port als belegt aus.</translation>
    </message>
    <message>
        <source>%2 left the lock file %1 behind. Remove it with %3, then try again.</source>
        <translation>%2 hat die Sperrdatei %1 zurückgelassen. Mit %3 entfernen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Could not open %1: no lock file can be created for it.</source>
        <translation>%1 konnte nicht geöffnet werden: Es lässt sich keine Sperrdatei dafür anlegen.</translation>
    </message>
    <message>
        <source>Your user account has no write access to %1 or any other folder for lock files. Ask your system administrator for access.</source>
        <translation>Ihr Benutzerkonto darf weder in %1 noch in einem anderen Ordner für Sperrdateien schreiben. Bitten Sie Ihre Systemverwaltung um Zugriff.</translation>
    </message>
    <message>
        <source>Could not open %1: this program has too many open files.</source>
        <translation>%1 konnte nicht geöffnet werden: Dieses Programm hat zu viele Dateien offen.</translation>
    </message>
    <message>
        <source>Close files that you do not need, or restart the program.</source>
        <translation>Nicht benötigte Dateien schließen oder das Programm neu starten.</translation>
    </message>
    <message>
        <source>Set the latency timer of the USB adapter to 1 ms, then connect again.</source>
        <translation>Den Latenz-Timer des USB-Adapters auf 1 ms stellen, dann neu verbinden.</translation>
    </message>
    <message>
        <source>Run %1. This lasts until the adapter is unplugged. To make it permanent, also run %2.</source>
        <translation>%1 ausführen. Das gilt, bis der Adapter abgezogen wird. Damit es dauerhaft gilt, zusätzlich %2 ausführen.</translation>
    </message>
    <message>
        <source>The adapter is back as %1 (same serial number). Reconnect?</source>
        <translation>Der Adapter ist als %1 wieder da (gleiche Seriennummer). Neu verbinden?</translation>
    </message>
    <message>
        <source>A similar adapter was found as %1. Reconnect?</source>
        <translation>Ein ähnlicher Adapter wurde als %1 gefunden. Neu verbinden?</translation>
    </message>
    <message>
        <source>Motors may still be moving. Reconnecting moves nothing and repeats no earlier command.</source>
        <translation>Motoren können noch in Bewegung sein. Das Verbinden bewegt nichts und wiederholt keinen früheren Befehl.</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (19 200 Bd tried).</source>
        <translation>Der Port ist offen, aber kein Modul hat geantwortet (19 200 Bd versucht).</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).</source>
        <translation>Der Port ist offen, aber kein Modul hat geantwortet (9600, 19 200, 57 600 und 115 200 Bd versucht).</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. If another program left the chain at an unusual baud rate, restart the network.</source>
        <translation>Der Reihe nach prüfen: Versorgung der Module; jedes Kabel der Kette, ein loses Kabel verbirgt alle Module; den ADDR_IN-Jumper des vom PC am weitesten entfernten Moduls; TX und RX nicht vertauscht; ein Vollduplex-Adapter (4 Drähte). Hat ein anderes Programm die Kette bei einer ungewöhnlichen Baudrate zurückgelassen, das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd, left running.</source>
        <translation>Verbunden mit %1: %2 bei %3 Bd, laufen weiter.</translation>
    </message>
    <message>
        <source>The modules carry on with what they were doing.</source>
        <translation>Die Module machen weiter, was sie gerade taten.</translation>
    </message>
    <message>
        <source>Gains are unknown until you apply them. Stop a motor before you move it: its last command is unknown.</source>
        <translation>Die Reglerwerte sind unbekannt, bis sie angewendet werden. Einen Motor stoppen, bevor er bewegt wird: Sein letzter Befehl ist unbekannt.</translation>
    </message>
    <message>
        <source>A module without an address also answered; it cannot be used yet.</source>
        <translation>Auch ein Modul ohne Adresse hat geantwortet; es ist noch nicht verwendbar.</translation>
    </message>
    <message>
        <source>Its motor is off. Either a module has restarted, or a new one was added. Restart the network to give it an address.</source>
        <translation>Sein Motor ist aus. Entweder ist ein Modul neu gestartet, oder ein neues kam hinzu. Ein Neustart des Netzwerks gibt ihm eine Adresse.</translation>
    </message>
    <message>
        <source>The link to module %1 is unreliable: %2 of its last %3 exchanges failed.</source>
        <translation>Die Verbindung zu Modul %1 ist unzuverlässig: %2 der letzten %3 Übertragungen sind misslungen.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Neu verbinden</translation>
    </message>
    <message>
        <source>A different adapter is on %1.</source>
        <translation>An %1 ist ein anderer Adapter.</translation>
    </message>
    <message>
        <source>The panel was connected to another adapter before. Nothing was sent.</source>
        <translation>Das Programm war vorher mit einem anderen Adapter verbunden. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>Trotzdem verbinden</translation>
    </message>
    <message>
        <source>The link to module %1 is marginal: %2 of its last %3 exchanges failed.</source>
        <translation>Die Verbindung zu Modul %1 ist grenzwertig: %2 der letzten %3 Übertragungen sind misslungen.</translation>
    </message>
    <message>
        <source>Its motor is off.</source>
        <translation>Sein Motor ist aus.</translation>
    </message>
    <message>
        <source>Set its outputs again once it has its address.</source>
        <translation>Seine Ausgänge neu setzen, sobald es seine Adresse wieder hat.</translation>
    </message>
    <message>
        <source>Every module loses its position, gains and address, and switches its motor off.</source>
        <translation>Jedes Modul verliert Position, Reglerwerte und Adresse und schaltet seinen Motor ab.</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped first.</source>
        <translation>
            <numerusform>%n Motor bewegt sich. Er wird zuerst gestoppt.</numerusform>
            <numerusform>%n Motoren bewegen sich. Sie werden zuerst gestoppt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restarted</source>
        <translation>Neu gestartet</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, gains and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>Das Modul ist neu gestartet: Sein Motor ist aus, Position, Reglerwerte und Adresse sind verloren. Die Adresse neu vergeben, wenn es angeboten wird, oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>The module restarted: its pins are inputs again, its outputs release what they drove, and its address is lost. Assign its address again if offered, or restart the network.</source>
        <translation>Das Modul ist neu gestartet: Seine Pins sind wieder Eingänge, seine Ausgänge haben losgelassen, was sie getrieben haben, und seine Adresse ist verloren. Die Adresse neu vergeben, wenn es angeboten wird, oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, parameters and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>Das Modul ist neu gestartet: Sein Motor ist aus, Position, Parameter und Adresse sind verloren. Die Adresse neu vergeben, wenn es angeboten wird, oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>all bytes are 00, or all FF, as on a line that is held low or high</source>
        <translation>alle Bytes sind 00 oder alle FF, wie auf einer Leitung, die auf Low oder High gehalten wird</translation>
    </message>
    <message>
        <source>more bytes than requested</source>
        <translation>mehr Bytes als angefordert</translation>
    </message>
    <message>
        <source>type or version does not match this module</source>
        <translation>Typ oder Version passt nicht zu diesem Modul</translation>
    </message>
    <message>
        <source>an undefined status bit changed</source>
        <translation>ein undefiniertes Statusbit hat sich geändert</translation>
    </message>
    <message>
        <source>homing started without a command</source>
        <translation>Referenzfahrt begann ohne Befehl</translation>
    </message>
    <message>
        <source>home register changed without a command</source>
        <translation>Referenzregister änderte sich ohne Befehl</translation>
    </message>
    <message>
        <source>position jumped farther than the velocities allow</source>
        <translation>Position sprang weiter, als die Geschwindigkeiten erlauben</translation>
    </message>
    <message>
        <source>velocity changed faster than any motor can</source>
        <translation>Geschwindigkeit änderte sich schneller, als ein Motor kann</translation>
    </message>
    <message>
        <source>servo is off, but pos_error or move_done is not set</source>
        <translation>Servo ist aus, aber pos_error oder move_done ist nicht gesetzt</translation>
    </message>
    <message>
        <source>servo is on without motor power</source>
        <translation>Servo ist ohne Motorversorgung ein</translation>
    </message>
    <message>
        <source>slew_done is set without accel_done</source>
        <translation>slew_done ist ohne accel_done gesetzt</translation>
    </message>
    <message>
        <source>a sticky bit was cleared without a command</source>
        <translation>ein Sticky-Bit wurde ohne Befehl gelöscht</translation>
    </message>
    <message>
        <source>velocity and trapezoidal mode at once</source>
        <translation>Geschwindigkeits- und Trapezmodus zugleich</translation>
    </message>
    <message>
        <source>moving without power or amplifier</source>
        <translation>Bewegung ohne Versorgung oder Verstärker</translation>
    </message>
    <message>
        <source>position changed while the motor was stopped</source>
        <translation>Position änderte sich, obwohl der Motor stand</translation>
    </message>
    <message>
        <source>timer count of a moving motor is not 1 to 65 452</source>
        <translation>Timerwert eines laufenden Motors liegt außerhalb von 1 bis 65 452</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>module refused: checksum</source>
        <translation>vom Modul abgewiesen: Prüfsumme</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>too few bytes</source>
        <translation>zu wenige Bytes</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>falsche Prüfsumme</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>verworfen: %1</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>cancelled by a stop</source>
        <translation>durch einen Stopp abgebrochen</translation>
    </message>
    <message>
        <source>no answer expected</source>
        <translation>keine Antwort erwartet</translation>
    </message>
    <message>
        <source>bytes, but no answer was expected</source>
        <translation>Bytes, obwohl keine Antwort erwartet wurde</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>Verbindungsaufbau</translation>
    </message>
    <message>
        <source>poll</source>
        <translation>Abfrage</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>challenge</source>
        <translation>Gegenprobe</translation>
    </message>
    <message>
        <source>flush</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Address %1</source>
        <translation>Adresse %1</translation>
    </message>
    <message>
        <source>SIMULATED SESSION: no hardware was connected.</source>
        <translation>SIMULIERTE SITZUNG: es war keine Hardware angeschlossen.</translation>
    </message>
    <message>
        <source>Packets of %1 on %2, seconds since %3</source>
        <translation>Pakete von %1 an %2, Sekunden seit %3</translation>
    </message>
    <message>
        <source>Older exchanges left out of this file: %1.</source>
        <translation>Ältere Übertragungen, die in dieser Datei fehlen: %1.</translation>
    </message>
    <message>
        <source>Exchanges before this one were not recorded.</source>
        <translation>Übertragungen vor dieser wurden nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>looking for modules</source>
        <translation>Module werden gesucht</translation>
    </message>
    <message>
        <source>Carried out by: %1.</source>
        <translation>Ausgeführt von: %1.</translation>
    </message>
    <message>
        <source>Not carried out by: %1.</source>
        <translation>Nicht ausgeführt von: %1.</translation>
    </message>
    <message>
        <source>Unknown for: %1.</source>
        <translation>Ungewiss bei: %1.</translation>
    </message>
    <message>
        <source>No answer from: %1.</source>
        <translation>Keine Antwort von: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 modules of group %3 started. All of them were commanded to stop.</source>
        <translation>%1 von %2 Modulen der Gruppe %3 sind gestartet. An alle ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>No module of group %1 started. Nothing was moved.</source>
        <translation>Kein Modul der Gruppe %1 ist gestartet. Es wurde nichts bewegt.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed their start.</source>
        <translation>Nicht alle Module der Gruppe %1 haben ihren Start bestätigt.</translation>
    </message>
    <message>
        <source>Look at the motors. The start is never repeated: load the moves again, then start the group again. Usually noise on the cable.</source>
        <translation>Die Motoren ansehen. Der Start wird nie wiederholt: erneut laden, dann erneut starten. Meist Störungen auf dem Kabel.</translation>
    </message>
    <message>
        <source>Group %1 is empty. Nothing was sent.</source>
        <translation>Gruppe %1 hat keine Mitglieder. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Add modules to the group first.</source>
        <translation>Zuerst Module in die Gruppe aufnehmen.</translation>
    </message>
    <message>
        <source>Module %2 blocks the command to group %1. Nothing was sent.</source>
        <translation>Modul %2 blockiert den Befehl an Gruppe %1. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>A group starts only when every member answers, has confirmed its load and can start, and the group of every module is known. Load this module again, or set its group again.</source>
        <translation>Eine Gruppe startet nur, wenn jedes Mitglied antwortet, das Laden bestätigt hat und starten kann und wenn die Gruppe jedes Moduls bekannt ist. Dieses Modul erneut laden oder seine Gruppe neu zuweisen.</translation>
    </message>
    <message>
        <source>Module %1 did not confirm its new group, so its group is unknown.</source>
        <translation>Modul %1 hat seine neue Gruppe nicht bestätigt, seine Gruppe ist daher unbekannt.</translation>
    </message>
    <message>
        <source>Could not change the group of module %1.</source>
        <translation>Die Gruppe von Modul %1 konnte nicht geändert werden.</translation>
    </message>
    <message>
        <source>Nothing was moved. A group has at most one leader, group FF has none, and the groups of all modules must be known. Check this, then try again.</source>
        <translation>Es wurde kein Motor bewegt. Eine Gruppe hat höchstens ein Leitmodul, Gruppe FF hat keines, und die Gruppen aller Module müssen bekannt sein. Das prüfen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>The command to group %1 was cancelled.</source>
        <translation>Der Befehl an Gruppe %1 wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to group %1.</source>
        <translation>Zu viele Befehle warten. An Gruppe %1 wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed saving home.</source>
        <translation>Nicht alle Module der Gruppe %1 haben das Speichern der Referenz bestätigt.</translation>
    </message>
    <message>
        <source>No motor was moved.</source>
        <translation>Es wurde kein Motor bewegt.</translation>
    </message>
    <message>
        <source>A PIC-I/O confirms latched inputs and stored PWM values only as the leader: make it the leader of the group.</source>
        <translation>Ein PIC-I/O bestätigt erfasste Eingänge und gespeicherte PWM-Werte nur als Leitmodul: Machen Sie es zum Leitmodul der Gruppe.</translation>
    </message>
    <message>
        <source>All modules now run at %1 Bd. Positions and gains are unchanged.</source>
        <translation>Alle Module arbeiten jetzt mit %1 Bd. Positionen und Reglerwerte sind unverändert.</translation>
    </message>
    <message>
        <source>Could not change the baud rate: the chain stays at %1 Bd. No motor was moved.</source>
        <translation>Die Baudrate konnte nicht geändert werden: Die Kette bleibt bei %1 Bd. Es wurde kein Motor bewegt.</translation>
    </message>
    <message>
        <source>The modules do not support %1 Bd. Choose another baud rate.</source>
        <translation>Die Module unterstützen %1 Bd nicht. Eine andere Baudrate wählen.</translation>
    </message>
    <message>
        <source>A motor is moving, or about to move. Stop all motors, then try again.</source>
        <translation>Ein Motor bewegt sich oder ist im Begriff dazu. Alle Motoren stoppen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Module %1 does not answer and would be left behind. Connect again first.</source>
        <translation>Modul %1 antwortet nicht und würde zurückbleiben. Zuerst neu verbinden.</translation>
    </message>
    <message>
        <source>Another program may have changed the group of module %1, which would then miss the new baud rate. Set its group again, or restart the network.</source>
        <translation>Ein anderes Programm hat möglicherweise die Gruppe von Modul %1 geändert; dann bekäme es die neue Baudrate nicht mit. Seine Gruppe neu zuweisen oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>Module %1 is a group leader and would answer at the new baud rate. Make it an ordinary member first.</source>
        <translation>Modul %1 ist Leitmodul einer Gruppe und würde mit der neuen Baudrate antworten. Zuerst ein gewöhnliches Mitglied daraus machen.</translation>
    </message>
    <message>
        <source>Module %2 did not answer at %1 Bd, so all modules went back to the old rate. Try another baud rate, a shorter cable, or termination at both ends.</source>
        <translation>Bei %1 Bd hat Modul %2 nicht geantwortet, daher sind alle Module zurückgekehrt. Eine andere Baudrate, ein kürzeres Kabel oder einen Abschluss an beiden Enden versuchen.</translation>
    </message>
    <message>
        <source>A stop took priority.</source>
        <translation>Ein Stopp hatte Vorrang.</translation>
    </message>
    <message>
        <source>Module %1 has not answered since the baud rate changed. No motor was moving.</source>
        <translation>Modul %1 hat seit dem Wechsel der Baudrate nicht geantwortet. Es war kein Motor in Bewegung.</translation>
    </message>
    <message>
        <source>It may still be at %1 Bd; the others are at %2 Bd. Scan again. If the module is not found, restart the network: positions and gains are lost.</source>
        <translation>Es ist möglicherweise noch bei %1 Bd; die anderen sind bei %2 Bd. Erneut suchen; wird es nicht gefunden, das Netzwerk neu starten: Positionen und Reglerwerte gehen verloren.</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>text in quotation marks</source>
        <translation>Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>ein Objekt in { }</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>eine Liste in [ ]</translation>
    </message>
    <message>
        <source>the file is incomplete.</source>
        <translation>die Datei ist unvollständig.</translation>
    </message>
    <message>
        <source>this text is not UTF-8.</source>
        <translation>dieser Text ist nicht in UTF-8.</translation>
    </message>
    <message>
        <source>this is not JSON.</source>
        <translation>das ist kein JSON.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>this number is too large.</source>
        <translation>diese Zahl ist zu groß.</translation>
    </message>
    <message>
        <source>more than %1 levels of brackets.</source>
        <translation>mehr als %1 Klammerebenen.</translation>
    </message>
    <message>
        <source>more than %1 values.</source>
        <translation>mehr als %1 Werte.</translation>
    </message>
    <message>
        <source>%1 appears twice.</source>
        <translation>%1 ist doppelt vorhanden.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 fehlt.</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1 muss %2 sein.</translation>
    </message>
    <message>
        <source>%1 is %2; it must be %3 to %4.</source>
        <translation>%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
    <message>
        <source>%1 has the unknown value &quot;%2&quot;.</source>
        <translation>%1 hat den unbekannten Wert „%2“.</translation>
    </message>
    <message>
        <source>%1 has an unprintable character.</source>
        <translation>%1 enthält ein nicht druckbares Zeichen.</translation>
    </message>
    <message>
        <source>%1 has more than %2 entries.</source>
        <translation>%1 hat mehr als %2 Einträge.</translation>
    </message>
    <message>
        <source>%1 has a unit that does not fit the module of this axis.</source>
        <translation>%1 hat eine Einheit, die nicht zum Modul dieser Achse passt.</translation>
    </message>
    <message>
        <source>module %1 is already in a group.</source>
        <translation>Modul %1 ist bereits in einer Gruppe.</translation>
    </message>
    <message>
        <source>another group also has address %1.</source>
        <translation>eine andere Gruppe hat ebenfalls die Adresse %1.</translation>
    </message>
    <message>
        <source>the leader is not one of the group&apos;s modules.</source>
        <translation>das Leitmodul gehört nicht zur Gruppe.</translation>
    </message>
    <message>
        <source>There is no file %1. Check whether it was moved, or its disk is disconnected.</source>
        <translation>Es gibt keine Datei %1. Prüfen, ob sie verschoben wurde oder ihr Datenträger fehlt.</translation>
    </message>
    <message>
        <source>The folder %1 does not exist. Choose another one.</source>
        <translation>Den Ordner %1 gibt es nicht. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>This is a folder or a device. Choose a file.</source>
        <translation>Das ist ein Ordner oder ein Gerät. Eine Datei wählen.</translation>
    </message>
    <message>
        <source>Your user account has no permission for %1. Choose another folder, or change the permissions.</source>
        <translation>Ihr Benutzerkonto hat keine Berechtigung für %1. Einen anderen Ordner wählen oder die Zugriffsrechte ändern.</translation>
    </message>
    <message>
        <source>The disk of %1 is read-only. Choose another folder.</source>
        <translation>Der Datenträger von %1 ist schreibgeschützt. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>The disk of %1 is full. Free some space, or choose another folder.</source>
        <translation>Der Datenträger von %1 ist voll. Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>It is larger than any machine file. Check that it is the right file.</source>
        <translation>Sie ist größer als jede Maschinendatei. Prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>Another program has changed it since it was opened or saved here. Open it to see the changes, or save as another file; saving as the same one replaces it.</source>
        <translation>Ein anderes Programm hat sie geändert, seit sie hier geöffnet oder gespeichert wurde. Öffnen Sie sie, um die Änderungen zu sehen, oder speichern Sie unter einem anderen Namen; unter demselben Namen wird sie ersetzt.</translation>
    </message>
    <message>
        <source>See Details for the system&apos;s message.</source>
        <translation>Die Meldung des Systems steht unter „Details“.</translation>
    </message>
    <message>
        <source>counts (steps)</source>
        <translation>Inkremente (Schritte)</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>eigene Einheit</translation>
    </message>
    <message>
        <source>abruptly</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>smoothly</source>
        <translation>sanft</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>an unnamed machine</source>
        <translation>Maschine ohne Namen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty.</source>
        <translation>„%1“ ist leer.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2 bytes.</source>
        <translation>„%1“ ist größer als %2 Byte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a machine file of NMC Panel.</source>
        <translation>„%1“ ist keine Maschinendatei von NMC Panel.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was written by a newer NMC Panel: its format is %2; this version reads formats up to %3.</source>
        <translation>„%1“ wurde von einem neueren NMC Panel geschrieben: Das Format ist %2, dieses Programm kennt Formate bis %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; line %2: %3</source>
        <translation>„%1“ Zeile %2: %3</translation>
    </message>
    <message>
        <source>Nothing was loaded.</source>
        <translation>Es wurde nichts geladen.</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;.</source>
        <translation>„%1“ konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;. Its previous content is kept.</source>
        <translation>„%1“ konnte nicht gespeichert werden. Der bisherige Inhalt bleibt erhalten.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;: it could not be opened again afterwards.</source>
        <translation>„%1“ konnte nicht gespeichert werden: Die Datei ließe sich danach nicht wieder öffnen.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. No differences.</source>
        <translation>„%1“ ist geöffnet. Keine Unterschiede.</translation>
    </message>
    <message>
        <source>Nothing was applied.</source>
        <translation>Es wurde nichts angewendet.</translation>
    </message>
    <message>
        <source>Modules or settings have changed since the table was shown, so it was updated. Check it, then apply again.</source>
        <translation>Seit die Tabelle angezeigt wurde, haben sich Module oder Einstellungen geändert; sie ist nun auf dem neuesten Stand. Die Tabelle prüfen, dann erneut anwenden.</translation>
    </message>
    <message>
        <source>An earlier session left unsaved changes to %1.</source>
        <translation>Eine frühere Sitzung hinterließ nicht gespeicherte Änderungen an %1.</translation>
    </message>
    <message>
        <source>If modules are connected, Restore shows what would change. Nothing is sent before you choose Apply.</source>
        <translation>Wenn Module verbunden sind, zeigt „Wiederherstellen“, was sich ändern würde. Vor „Anwenden“ wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Discard: the changes are lost</source>
        <translation>Verwerfen: die Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>Could not recover unsaved changes of an earlier session.</source>
        <translation>Nicht gespeicherte Änderungen einer früheren Sitzung konnten nicht wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>unsaved changes</source>
        <translation>nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Changes to the machine are not backed up until you save them.</source>
        <translation>Änderungen an der Maschine sind erst gesichert, wenn sie gespeichert werden.</translation>
    </message>
    <message>
        <source>%1 is not writable.</source>
        <translation>%1 ist nicht beschreibbar.</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Die Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>A/D scale</source>
        <translation>A/D-Skala</translation>
    </message>
    <message>
        <source>Names of inputs and outputs</source>
        <translation>Namen der Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>Beschleunigungszeit</translation>
    </message>
    <message>
        <source>Limit pins</source>
        <translation>Endschalter-Pins</translation>
    </message>
    <message>
        <source>Baud rate, Bd</source>
        <translation>Baudrate, Bd</translation>
    </message>
    <message>
        <source>Type and version</source>
        <translation>Typ und Version</translation>
    </message>
    <message>
        <source>Counts (steps) per unit</source>
        <translation>Inkremente (Schritte) je Einheit</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Run velocity</source>
        <translation>Dauerlaufgeschwindigkeit</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>Max. Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>On limit switch 1</source>
        <translation>Bei Endschalter 1</translation>
    </message>
    <message>
        <source>On limit switch 2</source>
        <translation>Bei Endschalter 2</translation>
    </message>
    <message>
        <source>On index</source>
        <translation>Bei Index</translation>
    </message>
    <message>
        <source>On position error</source>
        <translation>Bei Positionsfehler</translation>
    </message>
    <message>
        <source>On current limit</source>
        <translation>Bei Stromgrenze</translation>
    </message>
    <message>
        <source>On home switch</source>
        <translation>Bei Referenzschalter</translation>
    </message>
    <message>
        <source>Then on index</source>
        <translation>Danach am Index</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Indexgeschwindigkeit</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>Suchweg</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Referenz anfahren</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>Position auf 0 setzen</translation>
    </message>
    <message>
        <source>Per A/D count</source>
        <translation>Je A/D-Stufe</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>Bei null</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>A/D-Einheit</translation>
    </message>
    <message>
        <source>EL, counts</source>
        <translation>EL, Inkremente</translation>
    </message>
    <message>
        <source>Limit 1 is an input</source>
        <translation>Endschalter-Pin 1 ist ein Eingang</translation>
    </message>
    <message>
        <source>Limit 2 is an input</source>
        <translation>Endschalter-Pin 2 ist ein Eingang</translation>
    </message>
    <message>
        <source>Limit 1 as an output</source>
        <translation>Endschalter-Pin 1 als Ausgang</translation>
    </message>
    <message>
        <source>Limit 2 as an output</source>
        <translation>Endschalter-Pin 2 als Ausgang</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>Geschwindigkeitsmodus</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Min. Profilgeschwindigkeit</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>Fahrstrom</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>Haltestrom</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>Temperaturgrenze</translation>
    </message>
    <message>
        <source>Ignore limit switches</source>
        <translation>Endschalter ignorieren</translation>
    </message>
    <message>
        <source>Ignore E-stop input</source>
        <translation>E-Stop-Eingang ignorieren</translation>
    </message>
    <message>
        <source>Motor off on limit or E-stop input</source>
        <translation>Motor aus bei Endschalter oder E-Stop-Eingang</translation>
    </message>
    <message>
        <source>Output %1</source>
        <translation>Ausgang %1</translation>
    </message>
    <message>
        <source>Input %1</source>
        <translation>Eingang %1</translation>
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
        <source>Another type of module: if any of this axis is applied, the rest is reset.</source>
        <translation>Anderer Modultyp: Wird etwas von dieser Achse übernommen, wird der Rest zurückgesetzt.</translation>
    </message>
    <message>
        <source>Changes only the panel; nothing is sent.</source>
        <translation>Ändert nur das Programm; es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Sent to the module.</source>
        <translation>Wird an das Modul gesendet.</translation>
    </message>
    <message>
        <source>Filled in, not sent: %1</source>
        <translation>Eingetragen, nicht gesendet: %1</translation>
    </message>
    <message>
        <source>Filled in, not sent.</source>
        <translation>Eingetragen, nicht gesendet.</translation>
    </message>
    <message>
        <source>Not in the file: stays as it is.</source>
        <translation>Nicht in der Datei: bleibt, wie es ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving: stop them before anything is sent.</source>
        <translation>
            <numerusform>%n Motor ist in Bewegung: stoppen, bevor etwas gesendet wird.</numerusform>
            <numerusform>%n Motoren sind in Bewegung: stoppen, bevor etwas gesendet wird.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was stopped: its switch stayed active while backing off.</source>
        <translation>%1 wurde gestoppt: Der Schalter blieb beim Freifahren aktiv.</translation>
    </message>
    <message>
        <source>The switch may be stuck, or the search direction is wrong. Move the motor off the switch, or change the direction, then try again.</source>
        <translation>Vielleicht klemmt der Schalter, oder die Suchrichtung ist falsch. Den Motor vom Schalter wegfahren oder die Richtung ändern, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>%1 stopped before it found home.</source>
        <translation>%1 blieb stehen, bevor die Referenz gefunden war.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion. Check the search direction and the switches, then try again.</source>
        <translation>Ein Endschalter oder der E-Stop-Eingang hat die Bewegung beendet. Die Richtung der Suche und die Schalter prüfen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the search distance.</source>
        <translation>%1 wurde gestoppt: Referenz innerhalb des Suchwegs nicht gefunden.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and the search distance.</source>
        <translation>Schalter und Kabel, Suchrichtung und Suchweg prüfen.</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the time limit.</source>
        <translation>%1 wurde gestoppt: Referenz innerhalb der Zeitgrenze nicht gefunden.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and velocity, and the time limit.</source>
        <translation>Schalter und Kabel, Suchrichtung und Suchgeschwindigkeit und die Zeitgrenze prüfen.</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: the link was unreliable.</source>
        <translation>%1 ist nicht referenziert, ein Stoppbefehl wurde gesendet: Die Verbindung war unzuverlässig.</translation>
    </message>
    <message>
        <source>The home position found may be wrong. Check the link, then repeat the search.</source>
        <translation>Die gefundene Referenz ist vielleicht falsch. Die Verbindung prüfen, dann die Suche wiederholen.</translation>
    </message>
    <message>
        <source>%1 is not homed and does not answer. Motor state unknown.</source>
        <translation>%1 ist nicht referenziert und antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>It was commanded to stop. Use the hardware stop if it moves.</source>
        <translation>Ein Stoppbefehl wurde gesendet. Den Hardware-Stopp benutzen, wenn der Motor sich bewegt.</translation>
    </message>
    <message>
        <source>%1 is not homed: its motor switched itself off and is free to turn.</source>
        <translation>%1 ist nicht referenziert: Der Motor hat sich selbst abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, enable the motor, then repeat the search.</source>
        <translation>Der Positionsfehler war zu groß, oder die Motorversorgung fiel aus. Auf eine Blockade prüfen, den Motor einschalten, dann die Suche wiederholen.</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: a command failed, or its answer was lost.</source>
        <translation>%1 ist nicht referenziert, ein Stoppbefehl wurde gesendet: Ein Befehl ist fehlgeschlagen, oder seine Antwort ging verloren.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Repeat the search.</source>
        <translation>Meist Störungen auf dem Kabel. Die Suche wiederholen.</translation>
    </message>
    <message>
        <source>%1 is at rest but not homed: two readings of home differ.</source>
        <translation>%1 steht still, ist aber nicht referenziert: Zwei Messungen der Referenz weichen voneinander ab.</translation>
    </message>
    <message>
        <source>%1 found home and holds close to it, but the position was not set to 0.</source>
        <translation>%1 hat die Referenz gefunden und hält nahe bei ihr, aber die Position wurde nicht auf 0 gesetzt.</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Bereitet vor</translation>
    </message>
    <message>
        <source>Backing off from the active switch</source>
        <translation>Fährt vom aktiven Schalter frei</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Sucht</translation>
    </message>
    <message>
        <source>Searching for the index</source>
        <translation>Sucht den Index</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Stoppt</translation>
    </message>
    <message>
        <source>Verifying home</source>
        <translation>Prüft die Referenz</translation>
    </message>
    <message>
        <source>Going to home</source>
        <translation>Fährt zur Referenz</translation>
    </message>
    <message>
        <source>Setting position to 0</source>
        <translation>Setzt Position auf 0</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Fährt</translation>
    </message>
    <message>
        <source>Pausing</source>
        <translation>Pausiert</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Erledigt</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>%1 did not finish its moves.</source>
        <translation>%1 hat seine Fahrten nicht beendet.</translation>
    </message>
    <message>
        <source>%1 found home at %2.</source>
        <translation>%1 hat die Referenz bei %2 gefunden.</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 von %3</translation>
    </message>
    <message>
        <source>The switch stayed active while the motor backed off. The motor was stopped.</source>
        <translation>Der Schalter blieb beim Freifahren aktiv. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>The motion ended before home was found. Check the search direction and the switches.</source>
        <translation>Die Bewegung endete, bevor die Referenz gefunden war. Suchrichtung und Schalter prüfen.</translation>
    </message>
    <message>
        <source>No home within the search distance. The motor was stopped.</source>
        <translation>Referenz innerhalb des Suchwegs nicht gefunden. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>No home within the time limit. The motor was stopped.</source>
        <translation>Referenz innerhalb der Zeitgrenze nicht gefunden. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>The link was unreliable. The motor was commanded to stop.</source>
        <translation>Die Verbindung war unzuverlässig. An den Motor ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>The motor switched itself off and is free to turn.</source>
        <translation>Der Motor hat sich von selbst abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>A command failed or was not answered. The motor was commanded to stop.</source>
        <translation>Ein Befehl ist fehlgeschlagen oder wurde nicht beantwortet. An den Motor ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>Two readings of home differ. The motor is at rest.</source>
        <translation>Zwei Messungen der Referenz weichen voneinander ab. Der Motor steht still.</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its motor is off.</source>
        <translation>Modul %1 hat keine Motorversorgung, daher ist sein Motor aus.</translation>
    </message>
    <message>
        <source>Module %1 is too hot and switched its motor off.</source>
        <translation>Modul %1 ist zu heiß und hat seinen Motor abgeschaltet.</translation>
    </message>
    <message>
        <source>The A/D value fell below the thermal limit. Let the motor cool down; then check the currents and the limit on the Parameters page.</source>
        <translation>Der A/D-Wert ist unter die Temperaturgrenze gefallen. Den Motor abkühlen lassen; dann die Ströme und die Grenze auf der Seite Parameter prüfen.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because its E-stop input is active.</source>
        <translation>Modul %1 hat seinen Motor abgeschaltet, weil sein E-Stop-Eingang aktiv ist.</translation>
    </message>
    <message>
        <source>It stays off when the input is released.</source>
        <translation>Er bleibt aus, wenn der Eingang wieder frei wird.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because a limit switch is active.</source>
        <translation>Modul %1 hat seinen Motor abgeschaltet, weil ein Endschalter aktiv ist.</translation>
    </message>
    <message>
        <source>Enable it again, then move in the other direction.</source>
        <translation>Wieder einschalten, dann in die andere Richtung fahren.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off by itself.</source>
        <translation>Modul %1 hat seinen Motor von selbst abgeschaltet.</translation>
    </message>
    <message>
        <source>The cause is unknown. Check its power and inputs, then enable it again.</source>
        <translation>Die Ursache ist unbekannt. Versorgung und Eingänge prüfen, dann wieder einschalten.</translation>
    </message>
    <message>
        <source>Amplifier off</source>
        <translation>Verstärker aus</translation>
    </message>
    <message>
        <source>Stopped by a limit</source>
        <translation>Am Endschalter gestoppt</translation>
    </message>
    <message>
        <source>Too hot</source>
        <translation>Zu heiß</translation>
    </message>
    <message>
        <source>Switched itself off</source>
        <translation>Selbst abgeschaltet</translation>
    </message>
    <message>
        <source>The module has no motor power, so its motor is off.</source>
        <translation>Das Modul hat keine Motorversorgung, daher ist sein Motor aus.</translation>
    </message>
    <message>
        <source>The module switched its motor off when motor power failed. It stays off.</source>
        <translation>Das Modul hat seinen Motor abgeschaltet, als die Motorversorgung ausfiel. Er bleibt aus.</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the amplifier is switched off.</source>
        <translation>Der Motor ist frei drehbar. Das ist normal: Der Verstärker ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>A limit switch stopped the motor. It can move in the other direction.</source>
        <translation>Ein Endschalter hat den Motor gestoppt. Er kann in die andere Richtung fahren.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input stopped the motor, or prevents it from moving.</source>
        <translation>Der E-Stop-Eingang des Moduls hat den Motor gestoppt oder hindert ihn an der Bewegung.</translation>
    </message>
    <message>
        <source>The module switched its motor off because the A/D value fell below the thermal limit. It stays off.</source>
        <translation>Das Modul hat seinen Motor abgeschaltet, weil der A/D-Wert unter die Temperaturgrenze gefallen ist. Er bleibt aus.</translation>
    </message>
    <message>
        <source>The module switched its motor off; the cause is unknown.</source>
        <translation>Das Modul hat seinen Motor abgeschaltet; die Ursache ist unbekannt.</translation>
    </message>
    <message>
        <source>Load a move first.</source>
        <translation>Zuerst eine Fahrt laden.</translation>
    </message>
    <message>
        <source>The position is unknown.</source>
        <translation>Die Position ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The servo is on. Switch the motor off first.</source>
        <translation>Der Servo ist ein. Zuerst den Motor abschalten.</translation>
    </message>
    <message>
        <source>This chip version does not support it.</source>
        <translation>Diese Version des Chips kann das nicht.</translation>
    </message>
    <message>
        <source>Select at least one home condition.</source>
        <translation>Mindestens eine Bedingung für die Referenz wählen.</translation>
    </message>
    <message>
        <source>Enter a search distance and a time limit above 0.</source>
        <translation>Suchweg und Zeitgrenze größer als 0 eingeben.</translation>
    </message>
    <message>
        <source>The limit switch is already active. Move the motor off it first.</source>
        <translation>Der Endschalter ist schon aktiv. Den Motor zuerst von ihm wegbewegen.</translation>
    </message>
    <message>
        <source>This limit pin is set as an output.</source>
        <translation>Dieser Endschalter-Pin ist als Ausgang eingestellt.</translation>
    </message>
    <message>
        <source>Enter a distance other than 0.</source>
        <translation>Eine Strecke ungleich 0 eingeben.</translation>
    </message>
    <message>
        <source>This module is not a PIC-STEP.</source>
        <translation>Dieses Modul ist kein PIC-STEP.</translation>
    </message>
    <message>
        <source>Apply parameters first.</source>
        <translation>Zuerst die Parameter anwenden.</translation>
    </message>
    <message>
        <source>The amplifier is off. Enable it first.</source>
        <translation>Der Verstärker ist aus. Zuerst einschalten.</translation>
    </message>
    <message>
        <source>Stop the motor first: the chip cannot change this in motion.</source>
        <translation>Zuerst den Motor stoppen: Der Chip kann das während der Bewegung nicht ändern.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input is active. Release it first.</source>
        <translation>Der E-Stop-Eingang des Moduls ist aktiv. Zuerst freigeben.</translation>
    </message>
    <message>
        <source>The A/D value is below the thermal limit: let the motor cool down, or lower the limit.</source>
        <translation>Der A/D-Wert liegt unter der Temperaturgrenze: Den Motor abkühlen lassen oder die Grenze senken.</translation>
    </message>
    <message>
        <source>The goal is too far away: at most 2 147 483 647 counts or steps.</source>
        <translation>Das Ziel ist mehr als 2 147 483 647 Inkremente oder Schritte entfernt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. Settings applied: %2.</source>
        <translation>„%1“ ist geöffnet. Angewendete Einstellungen: %2.</translation>
    </message>
    <message>
        <source>Commands sent: %1. No motor was moved.</source>
        <translation>Gesendete Befehle: %1. Es wurde kein Motor bewegt.</translation>
    </message>
    <message>
        <source>Leader of group %1</source>
        <translation>Leitmodul der Gruppe %1</translation>
    </message>
    <message>
        <source>Cannot be applied: the file is for another module.</source>
        <translation>Kann nicht angewendet werden: Die Datei ist für ein anderes Modul.</translation>
    </message>
    <message>
        <source>Not in the chain; its settings are kept.</source>
        <translation>Nicht in der Kette; seine Einstellungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>%1 was stopped and holds: it moved the wrong way, or by more than twice the step.</source>
        <translation>%1 hält wieder: Der Motor lief in die falsche Richtung oder weiter als der doppelte Sprung.</translation>
    </message>
    <message>
        <source>The servo oscillates, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.</source>
        <translation>Der Servo schwingt, oder etwas anderes dreht den Motor. Kp und Ki senken oder Kd erhöhen, dann den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>%1 was switched off and is free to turn: it kept oscillating after its step.</source>
        <translation>%1 wurde abgeschaltet und ist frei drehbar: Der Motor schwang nach dem Sprung weiter.</translation>
    </message>
    <message>
        <source>The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it.</source>
        <translation>Der Servo ist mit diesen Reglerwerten nicht stabil. Kp und Ki senken oder Kd erhöhen, die Werte anwenden, dann einschalten.</translation>
    </message>
    <message>
        <source>%1 does not come to rest; its servo stays on.</source>
        <translation>%1 kommt nicht zur Ruhe; der Servo bleibt ein.</translation>
    </message>
    <message>
        <source>It oscillates, or an external force turns it. Lower Kp and Ki, or raise Kd. Choose Motor off to end it at once.</source>
        <translation>Der Motor schwingt, oder eine äußere Kraft dreht ihn. Kp und Ki senken oder Kd erhöhen; „Motor aus“ beendet es sofort.</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its motor switched itself off and is free to turn.</source>
        <translation>%1 hat den Sprung nicht beendet: Der Motor hat sich selbst abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or shorten the step, then enable the motor.</source>
        <translation>Der Positionsfehler war zu groß, oder die Motorversorgung fiel aus. Auf eine Blockade prüfen, EL erhöhen oder den Sprung verkleinern, dann den Motor einschalten.</translation>
    </message>
    <message>
        <source>%1 does not answer, so its step was not recorded. Motor state unknown.</source>
        <translation>%1 antwortet nicht, der Sprung wurde daher nicht aufgezeichnet. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>It was commanded to hold. Use the hardware stop if it moves.</source>
        <translation>Ein Haltebefehl wurde gesendet. Den Hardware-Stopp benutzen, wenn der Motor sich bewegt.</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: the link was unreliable.</source>
        <translation>%1 bekam einen Haltebefehl, und der Sprung wurde nicht aufgezeichnet: Die Verbindung war unzuverlässig.</translation>
    </message>
    <message>
        <source>Check the link, then step again.</source>
        <translation>Die Verbindung prüfen, dann den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: a command failed, or its answer was lost.</source>
        <translation>%1 bekam einen Haltebefehl, und der Sprung wurde nicht aufgezeichnet: Ein Befehl ist fehlgeschlagen, oder seine Antwort ging verloren.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Step again.</source>
        <translation>Meist Störungen auf dem Kabel. Den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>The motor does not come to rest; its servo stays on. Lower the gains, or switch the motor off.</source>
        <translation>Der Motor kommt nicht zur Ruhe; sein Servo bleibt ein. Die Reglerwerte senken oder den Motor abschalten.</translation>
    </message>
    <message>
        <source>The motor kept oscillating by more than the whole step. It was switched off and is free to turn. Lower Kp and Ki, or raise Kd.</source>
        <translation>Der Motor schwang um mehr als den ganzen Sprung und kam nicht zur Ruhe; er wurde daher abgeschaltet und ist frei drehbar. Kp und Ki senken oder Kd erhöhen.</translation>
    </message>
    <message>
        <source>its folder does not exist.</source>
        <translation>den Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>this is a folder or a device, not a file.</source>
        <translation>das ist ein Ordner oder ein Gerät, keine Datei.</translation>
    </message>
    <message>
        <source>your user account has no write access.</source>
        <translation>Ihr Benutzerkonto darf dort nicht schreiben.</translation>
    </message>
    <message>
        <source>the disk is read-only.</source>
        <translation>der Datenträger ist schreibgeschützt.</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>the file is too large for the disk.</source>
        <translation>die Datei ist zu groß für den Datenträger.</translation>
    </message>
    <message>
        <source>the file was deleted.</source>
        <translation>die Datei wurde gelöscht.</translation>
    </message>
    <message>
        <source>the disk is too slow.</source>
        <translation>der Datenträger ist zu langsam.</translation>
    </message>
    <message>
        <source>the disk reported a write error.</source>
        <translation>der Datenträger meldet einen Schreibfehler.</translation>
    </message>
    <message>
        <source>the file ends before its column names.</source>
        <translation>die Datei endet vor den Spaltennamen.</translation>
    </message>
    <message>
        <source>column %1 is missing.</source>
        <translation>die Spalte %1 fehlt.</translation>
    </message>
    <message>
        <source>the line is longer than %1 bytes, too long for a recording.</source>
        <translation>die Zeile ist länger als %1 Byte, zu lang für eine Aufzeichnung.</translation>
    </message>
    <message>
        <source>the file ends in the middle of this line.</source>
        <translation>die Datei endet hier, mitten in der Zeile.</translation>
    </message>
    <message>
        <source>the line has %1 cells for %2 columns.</source>
        <translation>es sind %1 Zellen für %2 Spalten.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 ist leer.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is not a number.</source>
        <translation>%1 ist „%2“, und das ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 of module %2 goes backwards.</source>
        <translation>%1 von Modul %2 läuft zurück.</translation>
    </message>
    <message>
        <source>Recorded &quot;%1&quot;: %2.</source>
        <translation>„%1“ ist aufgezeichnet: %2.</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>The part written before (%1) is kept.</source>
        <translation>Das zuvor Geschriebene (%1) bleibt erhalten.</translation>
    </message>
    <message>
        <source>Nothing was kept.</source>
        <translation>Es wurde nichts aufbewahrt.</translation>
    </message>
    <message>
        <source>Nothing is recorded to &quot;%1&quot;: no module is connected.</source>
        <translation>Nach „%1“ wird nichts aufgezeichnet: Es ist kein Modul verbunden.</translation>
    </message>
    <message>
        <source>Connect first, then record again.</source>
        <translation>Zuerst verbinden, dann erneut aufzeichnen.</translation>
    </message>
    <message>
        <source>Recording to &quot;%1&quot; stopped: %2</source>
        <translation>Die Aufzeichnung in „%1“ ist beendet: %2</translation>
    </message>
    <message>
        <source>%1 Motor control continues. To continue recording, choose another file.</source>
        <translation>%1 Die Steuerung läuft weiter. Um weiter aufzuzeichnen, eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a recording of NMC Panel.</source>
        <translation>„%1“ ist keine Aufzeichnung von NMC Panel.</translation>
    </message>
    <message>
        <source>It has nothing to show. Choose another file.</source>
        <translation>Sie enthält nichts Darstellbares. Eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>The scope shows the samples above that line: %1.</source>
        <translation>Das Oszilloskop zeigt die Messwerte oberhalb dieser Zeile: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no samples.</source>
        <translation>„%1“ enthält keine Messwerte.</translation>
    </message>
    <message>
        <source>Saved &quot;%1&quot;.</source>
        <translation>„%1“ ist gespeichert.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;.</source>
        <translation>„%1“ konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Show the last 2 s</source>
        <translation>Die letzten 2 s zeigen</translation>
    </message>
    <message>
        <source>Stop of all motors</source>
        <translation>Stopp aller Motoren</translation>
    </message>
    <message>
        <source>Too far for a step response: at most 2000 counts.</source>
        <translation>Zu weit für eine Sprungantwort: höchstens 2000 Inkremente.</translation>
    </message>
    <message>
        <source>The goal is outside the chip&apos;s position range.</source>
        <translation>Das Ziel liegt außerhalb des Positionsbereichs des Chips.</translation>
    </message>
    <message>
        <source>A record must be 0.02 s to 3 s long.</source>
        <translation>Eine Aufzeichnung muss 0,02 s bis 3 s dauern.</translation>
    </message>
    <message>
        <source>No motor is moving. All motors are commanded to stop before the port closes.</source>
        <translation>Kein Motor bewegt sich. An alle geht ein Stoppbefehl, bevor der Port geschlossen wird.</translation>
    </message>
    <message>
        <source>Nothing was lost: the panel detects wrong answers and retries. If it gets worse, motors are commanded to stop. Usually noise on the cable.</source>
        <translation>Nichts ging verloren: Das Programm erkennt falsche Antworten und fragt erneut. Wird es schlimmer, geht an die Motoren ein Stoppbefehl. Meist Störungen auf dem Kabel.</translation>
    </message>
    <message>
        <source>It listens at 19 200 Bd and may misread the other modules&apos; traffic: all motors were commanded to stop, and sending has stopped.</source>
        <translation>Es hört mit 19 200 Bd zu und kann den Verkehr der anderen Module falsch lesen: An alle Motoren ging ein Stoppbefehl, und es wird nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>The panel froze for %1; motors were commanded to stop after 2 s.</source>
        <translation>Das Programm reagierte %1 lang nicht; an die Motoren ging nach 2 s ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>It was connected to %1 and was killed, or the computer failed. Motor state unknown: look at the motor before you connect; use the hardware stop if it moves. This message stays until the motor is seen at rest.</source>
        <translation>Sie war mit %1 verbunden und wurde abgebrochen, oder der Rechner fiel aus. Motorzustand unbekannt: den Motor ansehen, bevor Sie verbinden; den Hardware-Stopp benutzen, wenn er sich bewegt. Diese Meldung bleibt, bis der Motor im Stillstand gesehen wurde.</translation>
    </message>
    <message>
        <source>I have checked: it is at rest</source>
        <translation>Ich habe nachgesehen: Er steht still</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 do not answer</source>
        <translation>
            <numerusform>Modul %1 antwortet nicht</numerusform>
            <numerusform>Die Module %1 antworten nicht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 are off after a restart.</source>
        <translation>
            <numerusform>Modul %1 ist nach einem Neustart aus.</numerusform>
            <numerusform>Die Module %1 sind nach einem Neustart aus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop but were not seen at rest</source>
        <translation>
            <numerusform>An Modul %1 ging ein Stoppbefehl, es wurde aber nicht im Stillstand gesehen</numerusform>
            <numerusform>An die Module %1 ging ein Stoppbefehl, sie wurden aber nicht im Stillstand gesehen</numerusform>
        </translation>
    </message>
    <message>
        <source>You can assign just its address: the other modules keep their positions and gains.</source>
        <translation>Sie können allein seine Adresse vergeben: Die anderen Module behalten Position und Reglerwerte.</translation>
    </message>
    <message>
        <source>Assign the address of module %1</source>
        <translation>Modul %1 seine Adresse geben</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no gains.</source>
        <translation>Modul %1 hat seine Adresse wieder. Sein Motor ist aus, seine Position ist 0, und es hat keine Reglerwerte.</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its pins are inputs, and its outputs drive nothing.</source>
        <translation>Modul %1 hat seine Adresse wieder. Seine Pins sind Eingänge, seine Ausgänge treiben nichts.</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no parameters.</source>
        <translation>Modul %1 hat seine Adresse wieder. Sein Motor ist aus, seine Position ist 0, und es hat keine Parameter.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its gains and home it before you use it.</source>
        <translation>Die anderen Module sind unverändert. Vor dem Benutzen seine Reglerwerte anwenden und es referenzieren.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Set its outputs again before you use it.</source>
        <translation>Die anderen Module sind unverändert. Vor dem Benutzen seine Ausgänge neu setzen.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its parameters and home it before you use it.</source>
        <translation>Die anderen Module sind unverändert. Vor dem Benutzen seine Parameter anwenden und es referenzieren.</translation>
    </message>
    <message>
        <source>Could not assign the address of module %1. No motor was moved.</source>
        <translation>Die Adresse von Modul %1 konnte nicht vergeben werden. Es wurde kein Motor bewegt.</translation>
    </message>
    <message>
        <source>The module does not answer. Scan again, or restart the network.</source>
        <translation>Das Modul antwortet nicht. Erneut suchen oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>No module is known</source>
        <translation>Kein Modul ist bekannt</translation>
    </message>
    <message>
        <source>: use the hardware stop.</source>
        <translation>: den Hardware-Stopp benutzen.</translation>
    </message>
    <message>
        <source>No stop was confirmed.</source>
        <translation>Kein Stopp konnte bestätigt werden.</translation>
    </message>
    <message>
        <source>%1 of %2 stopped.</source>
        <translation>%1 von %2 gestoppt.</translation>
    </message>
    <message>
        <source>Module %1 has stopped.</source>
        <translation>Modul %1 steht still.</translation>
    </message>
    <message>
        <source>It has stopped.</source>
        <translation>Es steht still.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: nothing held it for over 250 ms.</source>
        <translation>An Modul %1 ging beim Tippen ein Stoppbefehl: Länger als 250 ms hielt nichts das Tippen aufrecht.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: it did not confirm the command.</source>
        <translation>An Modul %1 ging beim Tippen ein Stoppbefehl: Es hat den Befehl nicht bestätigt.</translation>
    </message>
    <message>
        <source>Module %1 did not confirm the command to jog. Nothing was started.</source>
        <translation>Modul %1 hat den Befehl zum Tippen nicht bestätigt. Nichts wurde gestartet.</translation>
    </message>
    <message>
        <source>The command or its answer was lost or garbled: if this recurs, check the cable. Press and hold again.</source>
        <translation>Der Befehl oder die Antwort ging verloren oder war gestört: Bei Wiederholung das Kabel prüfen. Erneut drücken und halten.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its state no longer permits it.</source>
        <translation>An Modul %1 ging beim Tippen ein Stoppbefehl: Sein Zustand lässt es nicht mehr zu.</translation>
    </message>
    <message>
        <source>Module %1 cannot jog in its present state. Nothing was started.</source>
        <translation>Modul %1 kann in seinem jetzigen Zustand nicht tippen. Nichts wurde gestartet.</translation>
    </message>
    <message>
        <source>Its state says why: for example, its motor is off. Press and hold again once it may move.</source>
        <translation>Sein Zustand nennt den Grund: Zum Beispiel ist sein Motor aus. Erneut drücken und halten, sobald er fahren darf.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its travel limit has changed.</source>
        <translation>An Modul %1 ging beim Tippen ein Stoppbefehl: Seine Fahrweggrenze hat sich geändert.</translation>
    </message>
    <message>
        <source>Press and hold again to jog within the present limits.</source>
        <translation>Erneut drücken und halten, um innerhalb der jetzigen Grenzen zu tippen.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: it reports motion, but its position stays at %2 counts.</source>
        <translation>An Modul %1 ging ein Stoppbefehl: Es meldet Bewegung, aber seine Position bleibt bei %2 Inkrementen.</translation>
    </message>
    <message>
        <source>Overcurrent: module %1 limits its motor current.</source>
        <translation>Überstrom: Modul %1 begrenzt seinen Motorstrom.</translation>
    </message>
    <message>
        <source>The motor may fail to reach its goal or hold its load. Check for a jam or too heavy a load, or raise the limit. This message stays until you clear the sticky bits.</source>
        <translation>Vielleicht erreicht der Motor sein Ziel nicht oder hält seine Last nicht. Auf eine Blockade oder zu große Last prüfen oder die Grenze erhöhen. Diese Meldung bleibt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>Off, but turning</source>
        <translation>Aus, dreht aber</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>Überstrom</translation>
    </message>
    <message>
        <source>The shaft moves while the motor is off: a load turns it, or it is still coasting. A stop cannot hold it; use a brake, or enable the servo.</source>
        <translation>Die Welle bewegt sich, obwohl der Motor aus ist: Eine Last dreht sie, oder sie läuft noch aus. Kein Stopp hält sie; eine Bremse benutzen oder den Servo einschalten.</translation>
    </message>
    <message>
        <source>The motor is at rest, but its current was limited: it may not hold its load. This stays until you clear the sticky bits.</source>
        <translation>Der Motor steht, aber sein Strom wurde begrenzt: Vielleicht hält er seine Last nicht. Das bleibt so, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message numerus="yes">
        <source>The panel ended without stopping its motors; its guardian commanded modules %1 to stop.</source>
        <translation>
            <numerusform>Das Programm endete, ohne seine Motoren zu stoppen; sein Wächter hat an Modul %1 einen Stoppbefehl gesendet.</numerusform>
            <numerusform>Das Programm endete, ohne seine Motoren zu stoppen; sein Wächter hat an die Module %1 einen Stoppbefehl gesendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program was killed, or it hung. The guardian cannot see whether a motor stopped: look at the motors before you connect; use the hardware stop if one moves.</source>
        <translation>Das Programm wurde gewaltsam beendet, oder es hing. Der Wächter kann nicht sehen, ob ein Motor stoppte: die Motoren ansehen, bevor Sie verbinden; den Hardware-Stopp benutzen, wenn sich einer bewegt.</translation>
    </message>
    <message>
        <source>The panel stalled while a motor was moving; its guardian commanded the motors to stop.</source>
        <translation>Das Programm stockte, während sich ein Motor bewegte; sein Wächter hat an die Motoren einen Stoppbefehl gesendet.</translation>
    </message>
    <message>
        <source>The program was halted, or the computer was too busy. The panel is reading all values again.</source>
        <translation>Das Programm war angehalten, oder der Rechner war ausgelastet. Das Programm liest alle Werte neu.</translation>
    </message>
    <message>
        <source>No guardian: if this program is killed, nothing stops the motors.</source>
        <translation>Kein Wächter: Wird dieses Programm gewaltsam beendet, stoppt nichts die Motoren.</translation>
    </message>
    <message>
        <source>nmcguard is missing. Reinstall the program. Everything else works.</source>
        <translation>nmcguard fehlt. Das Programm neu installieren. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>Your user account has no permission to start nmcguard. Reinstall the program. Everything else works.</source>
        <translation>Ihr Benutzerkonto darf nmcguard nicht starten. Das Programm neu installieren. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>nmcguard and this program have different versions. Reinstall both. Everything else works.</source>
        <translation>nmcguard und dieses Programm haben verschiedene Versionen. Beide neu installieren. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The computer ran out of memory or open files. Close other programs, then connect again. Everything else works.</source>
        <translation>Der Rechner hat keinen Speicher oder keine offenen Dateien mehr frei. Andere Programme schließen, dann neu verbinden. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The guardian ended unexpectedly. Connect again to restart it. Everything else works.</source>
        <translation>Der Wächter endete unerwartet. Neu verbinden, um ihn wieder zu starten. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses power, a running motor keeps running, and no program can stop it. STOP ALL and Esc work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs.</source>
        <translation>Diese Module überwachen die Verbindung nicht: Wird das Kabel durchtrennt, hängt der Adapter oder verliert dieser Rechner seine Stromversorgung, so läuft ein laufender Motor weiter, und kein Programm kann ihn stoppen. ALLES STOPP und Esc wirken nur, solange die Verbindung besteht. Ein Wächter stoppt die Motoren, wenn dieses Programm gewaltsam beendet wird, abstürzt oder hängt.</translation>
    </message>
    <message>
        <source>Use --serve alone or as --serve=control.</source>
        <translation>--serve steht allein oder mit =control.</translation>
    </message>
    <message>
        <source>--read-only requires --port or --simulator.</source>
        <translation>--read-only braucht --port oder --simulator.</translation>
    </message>
    <message>
        <source>Module %1 of this chain does not answer. Motor state unknown.</source>
        <translation>Modul %1 dieser Kette antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>Check its power and the plug next to it; the panel keeps trying. If you removed it on purpose, work with the others: the panel then forgets it and its settings.</source>
        <translation>Versorgung des Moduls und den Stecker neben ihm prüfen; das Programm versucht es weiter. Wurde es absichtlich entfernt, mit den anderen arbeiten: Das Programm vergisst es dann mitsamt seinen Einstellungen.</translation>
    </message>
    <message>
        <source>A motor is moving, so the chain was not changed.</source>
        <translation>Ein Motor ist in Bewegung, die Kette wurde daher nicht geändert.</translation>
    </message>
    <message>
        <source>Forgetting a module rescans the chain. Stop all motors, then try again.</source>
        <translation>Um ein Modul zu vergessen, wird die Kette neu gesucht. Alle Motoren stoppen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses module %3, so the chain was not changed.</source>
        <translation>Zeile %1 von „%2“ benutzt Modul %3, die Kette wurde daher nicht geändert.</translation>
    </message>
    <message>
        <source>The row is for another type of module than the one found there. Change or remove it first, then try again.</source>
        <translation>Die Zeile ist für einen anderen Modultyp als den dort gefundenen. Zuerst die Zeile ändern oder entfernen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Forgetting a module removes its axis from the machine. Change or remove that row first, then try again.</source>
        <translation>Mit dem Modul wird auch seine Achse aus der Maschine entfernt. Zuerst diese Zeile ändern oder entfernen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Connected to %1 read-only: %2 at %3 Bd, left running.</source>
        <translation>Nur lesend verbunden mit %1: %2 bei %3 Bd, laufen weiter.</translation>
    </message>
    <message>
        <source>The modules carry on, even after you disconnect. Only status requests are sent. STOP ALL still works.</source>
        <translation>Die Module machen weiter, auch nach dem Trennen. Es werden nur Statusabfragen gesendet. ALLES STOPP wirkt weiterhin.</translation>
    </message>
    <message>
        <source>A port is already open.</source>
        <translation>Ein Port ist schon offen.</translation>
    </message>
    <message>
        <source>Disconnect first, then try again. Closing the port may stop motors.</source>
        <translation>Zuerst trennen, dann erneut versuchen. Schließen des Ports kann Motoren stoppen.</translation>
    </message>
    <message numerus="yes">
        <source>Motors %1 were moving, at %2.</source>
        <translation>
            <numerusform>Motor %1 war in Bewegung, an %2.</numerusform>
            <numerusform>Die Motoren %1 waren in Bewegung, an %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>This message stays until the motor is seen at rest.</source>
        <translation>Diese Meldung bleibt, bis der Motor im Stillstand gesehen wurde.</translation>
    </message>
    <message>
        <source>Look first (read-only)</source>
        <translation>Erst ansehen (nur lesen)</translation>
    </message>
    <message>
        <source>This connection is read-only. Connect fully first.</source>
        <translation>Diese Verbindung ist nur zum Lesen. Zuerst voll verbinden.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, read-only</source>
        <translation>Verbunden mit %1 bei %2 Bd, %3, nur lesend</translation>
    </message>
    <message>
        <source>Only the adapter&apos;s echo came back from %1: no module answered.</source>
        <translation>Nur das Echo des Adapters an %1 kam zurück: Kein Modul hat geantwortet.</translation>
    </message>
    <message>
        <source>The echo is harmless. Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the modules&apos; transmit pair is wired to the adapter.</source>
        <translation>Das Echo ist unschädlich. Der Reihe nach prüfen: Versorgung der Module; jedes Kabel der Kette, ein loses Kabel verbirgt alle Module; ob auch das Sendepaar der Module am Adapter angeschlossen ist.</translation>
    </message>
    <message>
        <source>The adapter at %1 echoes everything it sends. The panel ignores the echo.</source>
        <translation>Der Adapter an %1 gibt alles, was er sendet, als Echo zurück. Das Programm ignoriert das Echo.</translation>
    </message>
    <message>
        <source>This is normal for a 2-wire adapter. No action needed.</source>
        <translation>Bei einem Zweidraht-Adapter ist das normal. Es ist nichts zu tun.</translation>
    </message>
    <message>
        <source>no exact echo of the command before it</source>
        <translation>kein genaues Echo des vorherigen Befehls</translation>
    </message>
    <message>
        <source>Another host is sending on this line.</source>
        <translation>Ein anderer Rechner sendet auf dieser Leitung.</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop.</source>
        <translation>
            <numerusform>An Modul %1 ging ein Stoppbefehl.</numerusform>
            <numerusform>An die Module %1 ging ein Stoppbefehl.</numerusform>
        </translation>
    </message>
    <message>
        <source>Modules answer commands that this panel did not send; running tasks were cancelled. Close the other program, or disconnect its computer from the line, before you continue.</source>
        <translation>Module antworten auf Befehle, die dieses Programm nicht gesendet hat; laufende Vorgänge wurden abgebrochen. Das andere Programm beenden oder seinen Rechner von der Leitung trennen, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>Module %1 moves without a command from this panel.</source>
        <translation>Modul %1 bewegt sich ohne einen Befehl dieses Programms.</translation>
    </message>
    <message>
        <source>Another host on this line started it, or a load drives it. The panel does not stop it unless you do; the other host may start it again.</source>
        <translation>Ein anderer Rechner auf dieser Leitung hat es gestartet, oder eine Last treibt es an. Das Programm stoppt es nicht, solange Sie es nicht stoppen; der andere Rechner kann es wieder starten.</translation>
    </message>
    <message>
        <source>Home is unknown: search for it, or save it.</source>
        <translation>Die Referenz ist unbekannt: suchen oder speichern.</translation>
    </message>
    <message>
        <source>Friction holds it %1 off home, too far to set the position to 0. Raise Ki and IL on the Gains page, or clear &quot;Set position to 0&quot; on the Homing page. The tolerance follows from the unit on the Axis page.</source>
        <translation>Reibung hält den Motor %1 neben der Referenz, zu weit, um die Position auf 0 zu setzen. Ki und IL auf der Seite Reglerwerte erhöhen oder „Position auf 0 setzen“ auf der Seite Referenzfahrt abwählen. Die Toleranz folgt aus der Einheit auf der Seite Achse.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor is off.</source>
        <translation>Richtungsprüfung von %1 ohne Ergebnis; der Motor ist aus.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor was commanded to switch off.</source>
        <translation>Richtungsprüfung von %1 ohne Ergebnis; an den Motor ging der Befehl, sich abzuschalten.</translation>
    </message>
    <message>
        <source>It turned farther than the check allows: something else turns it, or it coasts for a long time. Wait until it is at rest, then check again.</source>
        <translation>Der Motor drehte sich weiter, als die Prüfung erlaubt: Etwas anderes dreht ihn, oder er läuft lange nach. Warten, bis er stillsteht, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>It does not come to rest although nothing drives it. Find what turns it, then check again.</source>
        <translation>Er steht nicht still, obwohl ihn nichts antreibt. Nachsehen, was ihn dreht, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>The link was unreliable. Check the link, then repeat the direction check.</source>
        <translation>Die Verbindung war unzuverlässig. Die Verbindung prüfen, dann die Richtungsprüfung wiederholen.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive: it does not answer. Motor state unknown.</source>
        <translation>Richtungsprüfung von %1 ohne Ergebnis: Das Modul antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>It was commanded to switch off. Use the hardware stop if it moves.</source>
        <translation>Der Befehl zum Abschalten wurde gesendet. Den Hardware-Stopp benutzen, wenn der Motor sich bewegt.</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Repeat the direction check.</source>
        <translation>Ein Befehl ist fehlgeschlagen, oder seine Antwort ging verloren. Die Richtungsprüfung wiederholen.</translation>
    </message>
    <message>
        <source>%1: motor and encoder directions match.</source>
        <translation>%1: Drehrichtung von Motor und Encoder stimmt überein.</translation>
    </message>
    <message>
        <source>%1: motor or encoder is reversed. Do not enable it.</source>
        <translation>%1: Motor oder Encoder ist verpolt. Nicht einschalten.</translation>
    </message>
    <message>
        <source>%1 did not move when driven.</source>
        <translation>%1 hat sich trotz Antrieb nicht bewegt.</translation>
    </message>
    <message>
        <source>%1 closed a limit switch; the check has ended.</source>
        <translation>%1 hat einen Endschalter geschlossen; die Prüfung ist beendet.</translation>
    </message>
    <message>
        <source>%1 lost motor power while being driven.</source>
        <translation>%1 hat während der Prüfung die Motorversorgung verloren.</translation>
    </message>
    <message>
        <source>%1 did not move in both directions.</source>
        <translation>%1 hat sich nicht in beide Richtungen bewegt.</translation>
    </message>
    <message>
        <source>It is at rest %1 from home; its position there is 0.</source>
        <translation>Der Motor steht %1 neben der Referenz; dort ist seine Position 0.</translation>
    </message>
    <message>
        <source>It rests too far from home to set the position to 0. Raise Ki and IL on the Gains page.</source>
        <translation>Der Motor steht zu weit neben der Referenz, um die Position auf 0 zu setzen. Ki und IL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>OK: it counts up when driven forward and down in reverse. You can enable it.</source>
        <translation>In Ordnung: Vorwärts angetrieben zählt er aufwärts, rückwärts abwärts. Er kann eingeschaltet werden.</translation>
    </message>
    <message>
        <source>Reversed: it counts down when driven forward and would run away when enabled. Swap the two motor leads, or encoder A and B, then check again.</source>
        <translation>Verpolt: Vorwärts angetrieben zählt er abwärts und würde beim Einschalten durchgehen. Die beiden Motorleitungen oder A und B des Encoders vertauschen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>No movement at %1 % of the supply, with motor power present. Check for a jam, a brake or too heavy a load, and check the motor and encoder cables.</source>
        <translation>Keine Bewegung mit %1 % der Versorgung, obwohl die Motorversorgung da ist. Auf eine Blockade, eine Bremse oder zu große Last prüfen, dazu die Kabel von Motor und Encoder.</translation>
    </message>
    <message>
        <source>A limit switch is active: it may cut the motor&apos;s power.</source>
        <translation>Ein Endschalter ist aktiv: Er trennt vielleicht die Motorversorgung.</translation>
    </message>
    <message>
        <source>Limit switch 1 closed during the move.</source>
        <translation>Endschalter 1 hat während der Fahrt geschlossen.</translation>
    </message>
    <message>
        <source>Limit switch 2 closed during the move.</source>
        <translation>Endschalter 2 hat während der Fahrt geschlossen.</translation>
    </message>
    <message>
        <source>Turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>Den Motor von Hand vom Ende des Fahrwegs wegdrehen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Motor power failed. Switch it on, then check again.</source>
        <translation>Die Motorversorgung ist ausgefallen. Einschalten, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Unclear: it moved in one direction only, or twice in the same direction. Something blocks or turns it. Remove the load, turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>Unklar: Er bewegte sich nur in eine Richtung oder zweimal in dieselbe. Etwas blockiert oder dreht ihn. Die Last abnehmen, den Motor von Hand vom Ende des Fahrwegs wegdrehen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Check for a jam, or raise EL on the Gains page.</source>
        <translation>Auf eine Blockade prüfen oder EL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>It ran away from its goal: motor or encoder is probably reversed. Run the direction check on the Axis page before you enable it again.</source>
        <translation>Er lief von seinem Ziel davon: Motor oder Encoder ist wahrscheinlich verpolt. Vor dem erneuten Einschalten die Richtungsprüfung auf der Seite Achse ausführen.</translation>
    </message>
    <message>
        <source>It was driven but did not move: check for a jam, a brake or a hard stop, and check the motor cable. If it is only hard to turn, raise OL on the Gains page.</source>
        <translation>Er wurde angetrieben, bewegte sich aber nicht: auf eine Blockade, eine Bremse oder einen Anschlag prüfen, dazu das Motorkabel. Ist er nur schwergängig, OL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>Limit switch 1 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>Endschalter 1 hat geschlossen: Er ist wahrscheinlich am Ende seines Fahrwegs. In die andere Richtung fahren. Um rechtzeitig zu stoppen, auf der Seite Referenzfahrt einen Endschalter-Stopp scharf schalten.</translation>
    </message>
    <message>
        <source>Limit switch 2 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>Endschalter 2 hat geschlossen: Er ist wahrscheinlich am Ende seines Fahrwegs. In die andere Richtung fahren. Um rechtzeitig zu stoppen, auf der Seite Referenzfahrt einen Endschalter-Stopp scharf schalten.</translation>
    </message>
    <message>
        <source>It moved correctly but could not keep up: lower its velocity or acceleration, or raise OL and EL on the Gains page.</source>
        <translation>Er bewegte sich wie verlangt und kam nicht nach: Geschwindigkeit oder Beschleunigung senken oder OL und EL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving.</source>
        <translation>Endschalter %1 von Modul %2 hat geschlossen, während sich der Motor bewegte.</translation>
    </message>
    <message>
        <source>While the switch is closed, the module blocks this direction. Move the motor the other way.</source>
        <translation>Solange der Schalter geschlossen ist, sperrt das Modul diese Richtung. In die andere Richtung fahren.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving, but does not stop it.</source>
        <translation>Endschalter %1 von Modul %2 hat geschlossen, während sich der Motor bewegte, stoppt ihn aber nicht.</translation>
    </message>
    <message>
        <source>A PIC-SERVO stops at a limit switch only while a limit stop is armed. Stop the motor, then move it the other way. Arm a limit stop on the Homing page.</source>
        <translation>Ein PIC-SERVO stoppt an einem Endschalter nur, wenn ein Endschalter-Stopp scharf ist. Den Motor stoppen, dann in die andere Richtung fahren. Auf der Seite Referenzfahrt einen Endschalter-Stopp scharf schalten.</translation>
    </message>
    <message>
        <source>The limit stop of module %1 switched its motor off.</source>
        <translation>Der Endschalter-Stopp von Modul %1 hat den Motor abgeschaltet.</translation>
    </message>
    <message>
        <source>The limit stop of module %1 stopped its motor.</source>
        <translation>Der Endschalter-Stopp von Modul %1 hat den Motor gestoppt.</translation>
    </message>
    <message>
        <source>A limit stop acts once. Move the motor off the switch, then arm or disarm the limit stop on the Homing page.</source>
        <translation>Ein Endschalter-Stopp wirkt einmal. Den Motor vom Schalter wegfahren, dann den Endschalter-Stopp auf der Seite Referenzfahrt scharf schalten oder entschärfen.</translation>
    </message>
    <message>
        <source>Saving %1. The window closes when it is saved.</source>
        <translation>%1 wird gespeichert. Das Fenster schließt sich, sobald das geschehen ist.</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 was moving.</source>
        <translation>Motorzustand unbekannt: %1 war in Bewegung.</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 were moving.</source>
        <translation>Motorzustand unbekannt: %1 waren in Bewegung.</translation>
    </message>
    <message>
        <source>Operator permissions</source>
        <translation>Rechte des Bedieners</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>Punkte und Abläufe</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Fahrten</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>Module %1 was %2 from home when last seen.</source>
        <translation>Modul %1 stand %2 von der Referenz entfernt, als es zuletzt gesehen wurde.</translation>
    </message>
    <message>
        <source>That was on %1; a search had found home. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>Das war am %1; die Referenz war durch eine Suche gefunden. Hat seither nichts die Achse bewegt, kann die Referenz daraus wiederhergestellt werden. Sie bleibt bis zur nächsten Suche unbestätigt.</translation>
    </message>
    <message>
        <source>That was on %1; home had been saved. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>Das war am %1; die Referenz war gespeichert. Hat seither nichts die Achse bewegt, kann die Referenz daraus wiederhergestellt werden. Sie bleibt bis zur nächsten Suche unbestätigt.</translation>
    </message>
    <message>
        <source>That was on %1; the position had been confirmed. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>Das war am %1; die Position war bestätigt. Hat seither nichts die Achse bewegt, kann die Referenz daraus wiederhergestellt werden. Sie bleibt bis zur nächsten Suche unbestätigt.</translation>
    </message>
    <message>
        <source>Restore home</source>
        <translation>Referenz wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Messages are lost when this session ends.</source>
        <translation>Meldungen gehen am Ende dieser Sitzung verloren.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. To keep messages, export the message list.</source>
        <translation>%1 ist nicht beschreibbar. Alles andere funktioniert. Um Meldungen aufzubewahren, die Liste der Meldungen exportieren.</translation>
    </message>
    <message>
        <source>What led to that message is no longer kept.</source>
        <translation>Was zu dieser Meldung führte, wird nicht mehr aufbewahrt.</translation>
    </message>
    <message>
        <source>The last %1 faults and stops can be shown. A recording keeps everything.</source>
        <translation>Die letzten %1 Störungen und Stopps können angezeigt werden. Eine Aufzeichnung behält alles.</translation>
    </message>
    <message>
        <source>The positions of the axes are not saved.</source>
        <translation>Die Positionen der Achsen werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. If the modules lose power now, search for home again: an older position may be offered.</source>
        <translation>%1 ist nicht beschreibbar. Alles andere funktioniert. Wenn die Module jetzt ihre Versorgung verlieren, die Referenz neu suchen: Möglicherweise wird eine ältere Position angeboten.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 stopped its motor.</source>
        <translation>Endschalter %1 von Modul %2 hat seinen Motor gestoppt.</translation>
    </message>
    <message>
        <source>The E-stop input of module %1 is active: its motor is on but cannot move.</source>
        <translation>Der E-Stop-Eingang von Modul %1 ist aktiv: Sein Motor ist ein, kann sich aber nicht bewegen.</translation>
    </message>
    <message>
        <source>Release the input. This does not start a motion.</source>
        <translation>Den Eingang freigeben. Das startet keine Bewegung.</translation>
    </message>
    <message>
        <source>Not allowed in operator mode. Leave operator mode first.</source>
        <translation>Im Bedienermodus nicht erlaubt. Zuerst den Bedienermodus verlassen.</translation>
    </message>
    <message>
        <source>Load the move first, then choose Start: this way a garbled load never moves the motor.</source>
        <translation>Die Fahrt zuerst laden, dann „Starten“ wählen: So bewegt ein gestörter Ladebefehl nie den Motor.</translation>
    </message>
    <message>
        <source>it has no name.</source>
        <translation>der Name fehlt.</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is already used.</source>
        <translation>der Name „%1“ ist schon vergeben.</translation>
    </message>
    <message>
        <source>module %1 appears twice.</source>
        <translation>Modul %1 kommt zweimal vor.</translation>
    </message>
    <message>
        <source>point &quot;%1&quot; does not exist.</source>
        <translation>es gibt keinen Punkt „%1“.</translation>
    </message>
    <message>
        <source>sequence &quot;%1&quot; does not exist.</source>
        <translation>es gibt keinen Ablauf „%1“.</translation>
    </message>
    <message>
        <source>this row makes the sequence &quot;%1&quot; call itself endlessly.</source>
        <translation>mit dieser Zeile würde der Ablauf „%1“ sich selbst aufrufen und nie enden.</translation>
    </message>
    <message>
        <source>a repeat must go back to an earlier row.</source>
        <translation>eine Wiederholung muss zu einer früheren Zeile zurückgehen.</translation>
    </message>
    <message>
        <source>Order of Home all</source>
        <translation>Reihenfolge von „Alle referenzieren“</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Sequence %1</source>
        <translation>Ablauf %1</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Einen Namen eingeben.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is already used. Choose another one.</source>
        <translation>Der Name „%1“ ist schon vergeben. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; contains %1 twice.</source>
        <translation>%1 kommt im Punkt „%2“ zweimal vor.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; does not exist.</source>
        <translation>Es gibt keinen Punkt „%1“.</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot; does not exist.</source>
        <translation>Es gibt keinen Ablauf „%1“.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; would call itself endlessly.</source>
        <translation>Der Ablauf „%1“ würde sich selbst aufrufen und nie enden.</translation>
    </message>
    <message>
        <source>A repeat must go back to an earlier row.</source>
        <translation>Eine Wiederholung muss zu einer früheren Zeile zurückgehen.</translation>
    </message>
    <message>
        <source>The sequence has no rows. Add a row first.</source>
        <translation>Der Ablauf hat keine Zeilen. Zuerst eine Zeile hinzufügen.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; has no axes. Teach it again.</source>
        <translation>Der Punkt „%1“ hat keine Achsen. Den Punkt neu teachen.</translation>
    </message>
    <message>
        <source>%1 is not in the chain.</source>
        <translation>%1 ist nicht in der Kette.</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; was taught before home of %1 was known, so it may have shifted. Teach it again.</source>
        <translation>Punkt „%2“ wurde geteacht, bevor die Referenz von %1 bekannt war; er kann sich verschoben haben. Den Punkt neu teachen.</translation>
    </message>
    <message>
        <source>Homing of %1 is not set up. Set it up on its Homing page.</source>
        <translation>Für %1 ist keine Referenzfahrt eingerichtet. Auf der Seite Referenzfahrt einrichten.</translation>
    </message>
    <message>
        <source>%1 does not have this input or output.</source>
        <translation>%1 hat diesen Ein- oder Ausgang nicht.</translation>
    </message>
    <message>
        <source>The outputs of %1 are unknown. Set them once on the module&apos;s page.</source>
        <translation>Die Ausgänge von %1 sind nicht bekannt. Sie einmal auf der Seite des Moduls setzen.</translation>
    </message>
    <message>
        <source>A run from the top never gets here: an earlier row repeats forever.</source>
        <translation>Ein Lauf von oben kommt nie hierher: darüber steht eine endlose Wiederholung.</translation>
    </message>
    <message>
        <source>At this row, %1 must be at home. Move it there first.</source>
        <translation>In dieser Zeile muss %1 an der Referenz stehen. Zuerst dorthin fahren.</translation>
    </message>
    <message>
        <source>At this row, %1 must be at point &quot;%2&quot;. Move it there first.</source>
        <translation>In dieser Zeile muss %1 am Punkt „%2“ stehen. Zuerst dorthin fahren.</translation>
    </message>
    <message>
        <source>At this row, output %1 of %2 must be in the opposite state. Set it first.</source>
        <translation>In dieser Zeile muss Ausgang %1 von %2 umgeschaltet sein. Zuerst setzen.</translation>
    </message>
    <message>
        <source>You stopped it.</source>
        <translation>Von Ihnen gestoppt.</translation>
    </message>
    <message>
        <source>All motors were stopped.</source>
        <translation>Alle Motoren wurden gestoppt.</translation>
    </message>
    <message>
        <source>%1 received another command, or something else moved it.</source>
        <translation>%1 bekam einen anderen Befehl, oder etwas anderes hat die Achse bewegt.</translation>
    </message>
    <message>
        <source>A limit switch of %1 closed during the move.</source>
        <translation>Ein Endschalter von %1 schloss während der Fahrt.</translation>
    </message>
    <message>
        <source>%1 stopped before it reached its goal.</source>
        <translation>%1 blieb vor dem Ziel stehen.</translation>
    </message>
    <message>
        <source>The motor of %1 switched off.</source>
        <translation>Der Motor von %1 hat sich abgeschaltet.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become high within %3 s.</source>
        <translation>%1 von %2 wurde nicht innerhalb von %3 s High.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become low within %3 s.</source>
        <translation>%1 von %2 wurde nicht innerhalb von %3 s Low.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become active within %3 s.</source>
        <translation>%1 von %2 wurde nicht innerhalb von %3 s aktiv.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become inactive within %3 s.</source>
        <translation>%1 von %2 wurde nicht innerhalb von %3 s inaktiv.</translation>
    </message>
    <message>
        <source>%1 did not find home.</source>
        <translation>%1 hat die Referenz nicht gefunden.</translation>
    </message>
    <message>
        <source>The link was unreliable.</source>
        <translation>Die Verbindung war unzuverlässig.</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1 antwortet nicht.</translation>
    </message>
    <message>
        <source>%1 refused or did not answer a command.</source>
        <translation>Ein Befehl an %1 wurde abgelehnt oder nicht beantwortet.</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1, pass %2</source>
        <translation>%1, Durchgang %2</translation>
    </message>
    <message>
        <source>Move to &quot;%1&quot;</source>
        <translation>Fahrt zu „%1“</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot;</source>
        <translation>Ablauf „%1“</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4 in all, moves: %5</source>
        <translation>%1: %2 bis %3, insgesamt %4, Fahrten: %5</translation>
    </message>
    <message>
        <source>move to</source>
        <translation>fahren zu</translation>
    </message>
    <message>
        <source>wait</source>
        <translation>warten</translation>
    </message>
    <message>
        <source>wait for arrival</source>
        <translation>auf Ankunft warten</translation>
    </message>
    <message>
        <source>wait for input</source>
        <translation>auf Eingang warten</translation>
    </message>
    <message>
        <source>set output</source>
        <translation>Ausgang setzen</translation>
    </message>
    <message>
        <source>find home</source>
        <translation>Referenz suchen</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>call</source>
        <translation>aufrufen</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>%1: %2 from home</source>
        <translation>%1: %2 von der Referenz</translation>
    </message>
    <message>
        <source>%1: at %2, home unknown</source>
        <translation>%1: bei %2, Referenz unbekannt</translation>
    </message>
    <message>
        <source>%1, row %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>Running: %1</source>
        <translation>Läuft: %1</translation>
    </message>
    <message>
        <source>Finishing its row, then pausing: %1</source>
        <translation>Beendet die Zeile und pausiert dann: %1</translation>
    </message>
    <message>
        <source>Paused before: %1</source>
        <translation>Pausiert vor: %1</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>Stoppt: %1</translation>
    </message>
    <message>
        <source>Ended: %1. %2</source>
        <translation>Beendet: %1. %2</translation>
    </message>
    <message>
        <source>%1 is done.</source>
        <translation>%1 ist fertig.</translation>
    </message>
    <message>
        <source>%1 ended, and its motors were commanded to stop.</source>
        <translation>%1 wurde beendet; an die Motoren ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>It was at: %1. To continue, select a row and choose Run from row. Nothing restarts on its own.</source>
        <translation>Stand: %1. Zum Fortsetzen eine Zeile wählen, dann „Ab Zeile starten“. Nichts startet von selbst wieder.</translation>
    </message>
    <message>
        <source>Nothing was started.</source>
        <translation>Nichts wurde gestartet.</translation>
    </message>
    <message>
        <source>Dry run: the sequence would not start.</source>
        <translation>Probelauf: Der Ablauf würde nicht starten.</translation>
    </message>
    <message>
        <source>Dry run: the simulation was not ready. Try again.</source>
        <translation>Probelauf: die simulierte Kopie war nicht bereit. Noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Dry run: %1 cannot be simulated. %2</source>
        <translation>Probelauf: %1 lässt sich nicht simulieren. %2</translation>
    </message>
    <message>
        <source>Dry run: cut off after %1 s.</source>
        <translation>Probelauf: nach %1 s abgebrochen.</translation>
    </message>
    <message>
        <source>Dry run: done after %1 s.</source>
        <translation>Probelauf: fertig nach %1 s.</translation>
    </message>
    <message>
        <source>Dry run: it would end after %1 s. %2</source>
        <translation>Probelauf: Der Ablauf würde nach %1 s enden. %2</translation>
    </message>
    <message>
        <source>Homing takes longer in reality: %1.</source>
        <translation>In Wirklichkeit dauern Referenzfahrten länger: %1.</translation>
    </message>
    <message>
        <source>Inputs were assumed to change at once.</source>
        <translation>Es wurde angenommen, dass sich Eingänge sofort ändern.</translation>
    </message>
    <message>
        <source>An endless repeat ran once.</source>
        <translation>Eine endlose Wiederholung lief einmal.</translation>
    </message>
    <message>
        <source>Simulated motors were used; real motors may take longer.</source>
        <translation>Die Motoren waren die des Simulators; Ihre können länger brauchen.</translation>
    </message>
    <message>
        <source>the lowest position is not below the highest.</source>
        <translation>die tiefste Position des Fahrwegs liegt nicht unter der höchsten.</translation>
    </message>
    <message>
        <source>Lowest position, from home</source>
        <translation>Tiefste Position, ab Referenz</translation>
    </message>
    <message>
        <source>Highest position, from home</source>
        <translation>Höchste Position, ab Referenz</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Höchste Geschwindigkeit</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Überfahrstrecke</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Armed for each motion</source>
        <translation>Für jede Bewegung scharf</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within its travel limits or at its last known position.</source>
        <translation>%1 wurde gestoppt: Referenz weder innerhalb der Fahrweggrenzen noch an ihrer letzten bekannten Position gefunden.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, and the search direction. If the position is wrong, choose Position in doubt on the Axis page: the next search then uses only its search distance.</source>
        <translation>Schalter, Kabel und Suchrichtung prüfen. Stimmt die Position nicht, auf der Seite Achse „Position zweifelhaft“ wählen: Die nächste Suche benutzt dann nur ihren Suchweg.</translation>
    </message>
    <message>
        <source>Taking up backlash</source>
        <translation>Spiel wird herausgefahren</translation>
    </message>
    <message>
        <source>The move would exceed the travel limits. The motor was stopped.</source>
        <translation>Die Fahrt würde die Fahrweggrenzen überschreiten. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop just before its travel limit.</source>
        <translation>An Modul %1 ging kurz vor seiner Fahrweggrenze ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>The chip does not end this kind of motion by itself, so the panel did. Check the position before you continue.</source>
        <translation>Der Chip beendet diese Art von Bewegung nicht selbst, deshalb tat es das Programm. Vor dem Weiterfahren die Position prüfen.</translation>
    </message>
    <message>
        <source>That is beyond this axis&apos;s travel limits (Axis page).</source>
        <translation>Das liegt außerhalb der Fahrweggrenzen dieser Achse (Seite Achse).</translation>
    </message>
    <message>
        <source>Travel limit reached. Move in the other direction.</source>
        <translation>Fahrweggrenze erreicht. In die andere Richtung bewegen.</translation>
    </message>
    <message>
        <source>That exceeds this axis&apos;s highest velocity (Axis page).</source>
        <translation>Das ist schneller, als diese Achse fahren darf (Seite Achse).</translation>
    </message>
    <message>
        <source>Stop first: a run towards a travel limit must start from standstill, so that the chip can end it there.</source>
        <translation>Zuerst stoppen: Ein Lauf auf eine Fahrweggrenze zu muss aus dem Stillstand beginnen, damit der Chip ihn dort beenden kann.</translation>
    </message>
    <message>
        <source>Wait until the limit stop of this axis is armed.</source>
        <translation>Warten, bis der Endschalter-Stopp dieser Achse scharf ist.</translation>
    </message>
    <message>
        <source>The current limit CL is 0 or unknown, so current cannot stop the motor. Apply a CL first.</source>
        <translation>Die Stromgrenze CL ist 0 oder unbekannt, der Strom kann den Motor daher nicht stoppen. Zuerst CL anwenden.</translation>
    </message>
    <message>
        <source>A limit switch, overheating or the E-stop input ended the move. The motor is at rest.</source>
        <translation>Ein Endschalter, Überhitzung oder der E-Stop-Eingang hat die Fahrt beendet. Der Motor steht still.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed setting their position to 0.</source>
        <translation>Nicht alle Module der Gruppe %1 haben bestätigt, dass ihre Position auf 0 gesetzt ist.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed clearing their sticky bits. A persistent fault sets its bit again at once.</source>
        <translation>Nicht alle Module der Gruppe %1 haben das Löschen ihrer Sticky-Bits bestätigt. Eine andauernde Störung setzt ihr Bit sofort wieder.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed the command.</source>
        <translation>Nicht alle Module der Gruppe %1 haben den Befehl bestätigt.</translation>
    </message>
    <message>
        <source>A group command requires that every member answers and can carry it out in its present state, and that the group of every module is known. Command the modules one by one, or set this module&apos;s group again.</source>
        <translation>Ein Gruppenbefehl setzt voraus, dass jedes Mitglied antwortet und ihn ausführen kann und dass die Gruppe jedes Moduls bekannt ist. Die Module einzeln ansteuern oder die Gruppe dieses Moduls neu zuweisen.</translation>
    </message>
    <message>
        <source>Group %1 was commanded to switch its motors off: module %2.</source>
        <translation>An Gruppe %1 ging der Befehl, ihre Motoren auszuschalten: Modul %2.</translation>
    </message>
    <message>
        <source>Group %1 was commanded to stop: module %2.</source>
        <translation>An Gruppe %1 ging ein Stoppbefehl: Modul %2.</translation>
    </message>
    <message>
        <source>This computer&apos;s port does not support %1 Bd. Choose another baud rate.</source>
        <translation>Der Port dieses Rechners unterstützt %1 Bd nicht. Eine andere Baudrate wählen.</translation>
    </message>
    <message>
        <source>Module %1 now has address %2. Position, gains and group are unchanged.</source>
        <translation>Modul %1 hat jetzt die Adresse %2. Position, Reglerwerte und Gruppe sind, was sie waren.</translation>
    </message>
    <message>
        <source>The address is used by another module or not allowed. Choose a free address from 1 to 127.</source>
        <translation>Die Adresse gehört einem anderen Modul oder ist nicht erlaubt. Eine freie Adresse von 1 bis 127 wählen.</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Set its group first, or none.</source>
        <translation>Seine Gruppe ist unbekannt und würde sich mit der Adresse ändern. Zuerst seine Gruppe setzen oder keine.</translation>
    </message>
    <message>
        <source>Another module without an address would take it. Assign that module&apos;s address first, or restart the network.</source>
        <translation>Ein anderes Modul ohne Adresse würde sie annehmen. Zuerst diesem Modul seine Adresse geben oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>The exact position that the servo holds is unknown. Choose Hold here first, or move the motor.</source>
        <translation>Die genaue Position, die der Servo hält, ist unbekannt. Zuerst „Erst hier halten“ wählen oder den Motor verfahren.</translation>
    </message>
    <message>
        <source>Module %1 oscillates while it holds its position.</source>
        <translation>Modul %1 hält seinen Motor, und der Motor schwingt.</translation>
    </message>
    <message>
        <source>Its servo is not stable with these gains. Lower Kp and Ki, or raise Kd, and apply them.</source>
        <translation>Sein Servo ist mit diesen Reglerwerten nicht stabil. Kp und Ki senken oder Kd erhöhen und anwenden.</translation>
    </message>
    <message>
        <source>Restore previous gains</source>
        <translation>Vorige Reglerwerte wiederherstellen</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it began to oscillate.</source>
        <translation>%1 hat wieder die vorigen Reglerwerte: Der Motor begann zu schwingen.</translation>
    </message>
    <message>
        <source>Lower Kp and Ki, or raise Kd, then try again.</source>
        <translation>Kp und Ki senken oder Kd erhöhen, dann erneut probieren.</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it left its position.</source>
        <translation>%1 hat wieder die vorigen Reglerwerte: Der Motor verließ seine Position.</translation>
    </message>
    <message>
        <source>These gains do not hold its load, or something else turned it.</source>
        <translation>Mit diesen Reglerwerten hält er seine Last nicht, oder etwas anderes hat ihn gedreht.</translation>
    </message>
    <message>
        <source>%1 switched itself off while gains were being tried, and is free to turn.</source>
        <translation>%1 hat sich beim Probieren von Reglerwerten selbst abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>Its previous gains were sent again. Check for a jam, then enable it.</source>
        <translation>Die vorigen Reglerwerte wurden wieder gesendet. Auf eine Blockade prüfen, dann einschalten.</translation>
    </message>
    <message>
        <source>%1 does not answer while gains are being tried. Motor state unknown.</source>
        <translation>%1 antwortet beim Probieren von Reglerwerten nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>Its previous gains were sent. Use the hardware stop if it moves.</source>
        <translation>Die vorigen Reglerwerte wurden gesendet. Den Hardware-Stopp benutzen, wenn der Motor sich bewegt.</translation>
    </message>
    <message>
        <source>The new gains of %1 are in force; OL may still be lowered.</source>
        <translation>Die neuen Reglerwerte von %1 gelten; OL ist vielleicht noch herabgesetzt.</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Apply the gains again.</source>
        <translation>Ein Befehl ist fehlgeschlagen, oder seine Antwort ging verloren. Die Reglerwerte noch einmal anwenden.</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: the link was unreliable.</source>
        <translation>Die vorigen Reglerwerte von %1 wurden wieder gesendet: Die Verbindung war unzuverlässig.</translation>
    </message>
    <message>
        <source>Check the link, then try again.</source>
        <translation>Die Verbindung prüfen, dann noch einmal probieren.</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: a command failed, or its answer was lost.</source>
        <translation>Die vorigen Reglerwerte von %1 wurden wieder gesendet: Ein Befehl ist fehlgeschlagen, oder seine Antwort ging verloren.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Try again.</source>
        <translation>Meist Störungen auf dem Kabel. Noch einmal probieren.</translation>
    </message>
    <message>
        <source>Trying gains</source>
        <translation>Probiert Reglerwerte</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: the trial has ended.</source>
        <translation>%1 hat wieder die vorigen Reglerwerte: Der Versuch ist beendet.</translation>
    </message>
    <message>
        <source>The motor began to oscillate. The previous gains are restored.</source>
        <translation>Der Motor begann zu schwingen. Die Reglerwerte von vorher gelten wieder.</translation>
    </message>
    <message>
        <source>Could not print the page.</source>
        <translation>Die Seite konnte nicht gedruckt werden.</translation>
    </message>
    <message>
        <source>%1 Export the page as a PDF file and print that file.</source>
        <translation>%1 Die Seite als PDF-Datei exportieren und anderswo drucken.</translation>
    </message>
    <message>
        <source>The page was sent to the printer.</source>
        <translation>Die Seite ist auf dem Weg zum Drucker.</translation>
    </message>
    <message>
        <source>The program %1, which sends pages to the printer, is not installed.</source>
        <translation>Das Programm %1, das Seiten an den Drucker gibt, ist nicht installiert.</translation>
    </message>
    <message>
        <source>The print system refused it: see Details.</source>
        <translation>Das Drucksystem hat sie abgewiesen: siehe Details.</translation>
    </message>
    <message>
        <source>Could not read the step responses of this machine.</source>
        <translation>Die Sprungantworten dieser Maschine konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of step responses.</source>
        <translation>„%1“ ist keine Datei mit Sprungantworten.</translation>
    </message>
    <message>
        <source>The file is kept: before new step responses are saved, it is moved to %1.</source>
        <translation>Die Datei bleibt erhalten: Bevor neue Sprungantworten gespeichert werden, wird sie nach %1 verschoben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not readable. It is moved aside before new step responses are saved.</source>
        <translation>„%1“ ist nicht lesbar. Die Datei wird beiseitegelegt, bevor neue Sprungantworten gespeichert werden.</translation>
    </message>
    <message>
        <source>The step responses of this session are not saved.</source>
        <translation>Die Sprungantworten dieser Sitzung werden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>%1 is not writable. Export them before you close the panel.</source>
        <translation>%1 ist nicht beschreibbar. Exportieren Sie sie, bevor Sie das Programm schließen.</translation>
    </message>
    <message>
        <source>The loop test of %1 ended early.</source>
        <translation>%1: Die Prüfung des Regelkreises endete vorzeitig.</translation>
    </message>
    <message>
        <source>The motor moved farther than the test allows, and was commanded to hold. Check for a load that pulls it, or use lower gains.</source>
        <translation>Der Motor bewegte sich weiter, als die Prüfung erlaubt, und bekam einen Haltebefehl. Prüfen, ob eine Last an ihm zieht, oder kleinere Reglerwerte nehmen.</translation>
    </message>
    <message>
        <source>A value of this test is out of range.</source>
        <translation>Ein Wert dieser Prüfung liegt außerhalb seines Bereichs.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>The module answers. It has inputs and outputs, but no motor.</source>
        <translation>Das Modul antwortet. Es hat Ein- und Ausgänge, aber keinen Motor.</translation>
    </message>
    <message>
        <source>This module drives no motor.</source>
        <translation>Dieses Modul treibt keinen Motor an.</translation>
    </message>
    <message>
        <source>This module is not a PIC-I/O.</source>
        <translation>Dieses Modul ist kein PIC-I/O.</translation>
    </message>
    <message>
        <source>A module ended the path by itself: a limit switch, a position error, or no motor power. All axes of the path were commanded to stop.</source>
        <translation>Ein Modul hat die Bahn von selbst beendet: ein Endschalter, ein Positionsfehler oder fehlende Motorversorgung. An alle Achsen der Bahn ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>%1 has not finished its path.</source>
        <translation>%1 hat seine Bahn nicht beendet.</translation>
    </message>
    <message>
        <source>Not all axes started the path. All of them were commanded to stop.</source>
        <translation>Nicht alle Achsen der Bahn sind gestartet. An alle ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>The path points did not arrive in time, so the motor stopped at the last one.</source>
        <translation>Die Bahnpunkte kamen nicht rechtzeitig, deshalb blieb der Motor am letzten stehen.</translation>
    </message>
    <message>
        <source>The command position left the path. The motor was commanded to stop.</source>
        <translation>Die Sollposition hat die Bahn verlassen. An den Motor ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>On a path</source>
        <translation>Auf einer Bahn</translation>
    </message>
    <message>
        <source>The path cannot be followed from here.</source>
        <translation>Von hier aus lässt sich die Bahn nicht abfahren.</translation>
    </message>
    <message>
        <source>Enable it, then move it the other way. The Amplifier page sets what a closed limit does.</source>
        <translation>Einschalten, dann in die andere Richtung fahren. Was ein geschlossener Endschalter bewirkt, steht auf der Seite Verstärker.</translation>
    </message>
    <message>
        <source>Limit switch %1 closed, and module %2 switched its motor off.</source>
        <translation>Endschalter %1 hat geschlossen, und Modul %2 hat seinen Motor ausgeschaltet.</translation>
    </message>
    <message>
        <source>The limit in that direction is closed. Move the motor the other way.</source>
        <translation>Der Endschalter in dieser Richtung ist geschlossen. In die andere Richtung fahren.</translation>
    </message>
    <message>
        <source>The rate &quot;%1&quot; does not exist. Use 30, 60 or 120.</source>
        <translation>Die Rate „%1“ gibt es nicht. Möglich sind 30, 60 oder 120.</translation>
    </message>
    <message>
        <source>The file has no line that names its axes.</source>
        <translation>Keine Zeile der Datei nennt ihre Achsen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis that can follow a path.</source>
        <translation>„%1“ ist keine Achse, die einer Bahn folgen kann.</translation>
    </message>
    <message>
        <source>This axis is named twice.</source>
        <translation>Diese Achse ist doppelt genannt.</translation>
    </message>
    <message>
        <source>A position is missing.</source>
        <translation>Eine Position fehlt.</translation>
    </message>
    <message>
        <source>The line has %1 positions; the file has %2 axes.</source>
        <translation>Die Zeile hat %1 Positionen, die Datei %2 Achsen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is outside the module&apos;s position range.</source>
        <translation>„%1“ liegt außerhalb dessen, was das Modul zählen kann.</translation>
    </message>
    <message>
        <source>The point is %1 from the previous one; at this rate the maximum is %2.</source>
        <translation>Der Punkt liegt %1 vom vorigen entfernt. Bei dieser Rate sind höchstens %2 möglich.</translation>
    </message>
    <message>
        <source>This needs a velocity of %1; the limit of the axis is %2.</source>
        <translation>Dafür ist eine Geschwindigkeit von %1 nötig; die Grenze der Achse ist %2.</translation>
    </message>
    <message>
        <source>%1 is beyond the travel limit of %2.</source>
        <translation>%1 liegt jenseits der Fahrweggrenze von %2.</translation>
    </message>
    <message>
        <source>A path needs at least two points.</source>
        <translation>Eine Bahn braucht mindestens zwei Punkte.</translation>
    </message>
    <message>
        <source>A path has at most %1 points.</source>
        <translation>Eine Bahn hat höchstens %1 Punkte.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>Zeile %1, %2: %3</translation>
    </message>
    <message>
        <source>%1 has no path buffer. Only a PIC-SERVO CMC or SC can follow a path.</source>
        <translation>%1 hat keinen Bahnpuffer. Nur ein PIC-SERVO CMC oder SC folgt einer Bahn.</translation>
    </message>
    <message>
        <source>The I/O settings of %1 are unknown: another program set them. Apply them first on the Amplifier or Limits and I/O page.</source>
        <translation>Die I/O-Einstellungen von %1 sind unbekannt: Ein anderes Programm hat sie gesetzt. Erst auf der Seite Verstärker oder Endschalter und E/A anwenden.</translation>
    </message>
    <message>
        <source>%1 is set to step and direction input. Switch that off on its Amplifier page first.</source>
        <translation>%1 folgt Takt- und Richtungsimpulsen. Das zuerst auf der Seite Verstärker abschalten.</translation>
    </message>
    <message>
        <source>%1: a path at 30 Hz needs fast path off (Amplifier or Limits and I/O page).</source>
        <translation>%1: Für eine Bahn mit 30 Hz muss „Schnelle Bahn“ aus sein (Seite Verstärker oder Endschalter und E/A).</translation>
    </message>
    <message>
        <source>%1: a path at 120 Hz needs fast path on (Amplifier or Limits and I/O page).</source>
        <translation>%1: Für eine Bahn mit 120 Hz muss „Schnelle Bahn“ ein sein (Seite Verstärker oder Endschalter und E/A).</translation>
    </message>
    <message>
        <source>%1: a path needs a servo rate divisor of 1. Apply the gains with SR = 1 first.</source>
        <translation>%1: Eine Bahn braucht den Servotakt-Teiler SR = 1. Zuerst die Reglerwerte mit SR 1 anwenden.</translation>
    </message>
    <message>
        <source>%1 has not reported its command position yet.</source>
        <translation>%1 hat seine Sollposition noch nicht gemeldet.</translation>
    </message>
    <message>
        <source>%1 is %2 from the first point. Choose Move to start first.</source>
        <translation>%1 ist %2 vom ersten Punkt entfernt. Erst „Zum Anfang“ wählen.</translation>
    </message>
    <message>
        <source>%1: point %2 is %3 from the previous one; at this rate the maximum is %4.</source>
        <translation>%1: Punkt %2 liegt %3 vom vorigen entfernt; bei dieser Rate sind höchstens %4 möglich.</translation>
    </message>
    <message>
        <source>%1: point %2 needs a velocity of %3; the limit of the axis is %4.</source>
        <translation>%1: Für Punkt %2 ist eine Geschwindigkeit von %3 nötig; die Grenze der Achse ist %4.</translation>
    </message>
    <message>
        <source>%1: point %2 at %3 is beyond the travel limit of %4.</source>
        <translation>%1: Punkt %2 bei %3 liegt jenseits der Fahrweggrenze von %4.</translation>
    </message>
    <message>
        <source>The path does not fit this chain. Open it again.</source>
        <translation>Die Bahn passt nicht zu dieser Kette. Erneut öffnen.</translation>
    </message>
    <message>
        <source>The axes of a path start together. Put them, and no other module, into one group: Chain, Groups.</source>
        <translation>Die Achsen einer Bahn starten gemeinsam. Sie, und kein anderes Modul, in eine Gruppe setzen: Kette, Gruppen.</translation>
    </message>
    <message>
        <source>The path needs %1 % of the bus time; %2 % is available. Use a higher baud rate or a lower path rate.</source>
        <translation>Die Bahn braucht %1 % der Zeit des Busses, verfügbar sind %2 %. Eine höhere Baudrate oder eine niedrigere Bahnrate wählen.</translation>
    </message>
    <message>
        <source>%1 cannot follow a path. Only a PIC-SERVO CMC or SC can.</source>
        <translation>%1 kann keiner Bahn folgen. Das kann nur ein PIC-SERVO CMC oder SC.</translation>
    </message>
    <message>
        <source>%1 does not hold a known position. Enable its servo, and find home if the points count from home.</source>
        <translation>%1 hält keine bekannte Position. Den Servo einschalten und referenzieren, falls die Punkte von der Referenz aus zählen.</translation>
    </message>
    <message>
        <source>Only moves, waits, repeats and calls can become a path.</source>
        <translation>Nur Fahrten, Wartezeiten, Wiederholungen und Aufrufe können eine Bahn werden.</translation>
    </message>
    <message>
        <source>A path cannot repeat forever.</source>
        <translation>Eine Bahn kann sich nicht endlos wiederholen.</translation>
    </message>
    <message>
        <source>Up to here the path would have more than %1 points.</source>
        <translation>Bis hierher hätte die Bahn mehr als %1 Punkte.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; moves nothing.</source>
        <translation>Der Ablauf „%1“ bewegt nichts.</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;. %2</source>
        <translation>„%1“ konnte nicht geöffnet werden. %2</translation>
    </message>
    <message>
        <source>The path is done. Each axis holds its last point.</source>
        <translation>Die Bahn ist beendet. Jede Achse hält ihren letzten Punkt.</translation>
    </message>
    <message>
        <source>The path was stopped.</source>
        <translation>Die Bahn wurde gestoppt.</translation>
    </message>
    <message>
        <source>Starting the path</source>
        <translation>Die Bahn beginnt</translation>
    </message>
    <message>
        <source>Point %1 of %2, %3 s left, %4 points left in the buffer</source>
        <translation>Punkt %1 von %2, noch %3 s, %4 Punkte voraus im Puffer</translation>
    </message>
    <message>
        <source>%1. The buffer is about to run dry: the bus is too slow.</source>
        <translation>%1. Der Puffer läuft gleich leer: Der Bus ist zu langsam.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 points at %2 Hz, %3 s</source>
        <translation>%1 Punkte mit %2 Hz, %3 s</translation>
    </message>
    <message>
        <source>SM, step multiplier</source>
        <translation>SM, Taktfaktor</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>Schnelle Bahn</translation>
    </message>
    <message>
        <source>This pin of %1 is set as an output.</source>
        <translation>Dieser Pin von %1 ist als Ausgang eingestellt.</translation>
    </message>
    <message>
        <source>This pin of %1 is not set as an output. Make it an output first.</source>
        <translation>Dieser Pin von %1 ist nicht als Ausgang eingestellt. Auf der Seite E/A einstellen.</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not rise above %3 of 255 within %4 s.</source>
        <translation>A/D %1 von %2 stieg nicht innerhalb von %4 s über %3 von 255.</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not fall below %3 of 255 within %4 s.</source>
        <translation>A/D %1 von %2 fiel nicht innerhalb von %4 s unter %3 von 255.</translation>
    </message>
    <message>
        <source>wait for A/D</source>
        <translation>auf A/D warten</translation>
    </message>
    <message numerus="yes">
        <source>No stop command is known for modules %1</source>
        <translation>
            <numerusform>Modul %1 kann kein Stoppbefehl gegeben werden</numerusform>
            <numerusform>Den Modulen %1 kann kein Stoppbefehl gegeben werden</numerusform>
        </translation>
    </message>
    <message>
        <source>If it moved the wrong way, run the direction check on the Axis page.</source>
        <translation>Wenn er sich falsch herum bewegte, die Richtungsprüfung auf der Seite Achse ausführen.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or make the test smaller, then enable the motor.</source>
        <translation>Der Positionsfehler war zu groß, oder die Motorversorgung fiel aus. Auf eine Blockade prüfen, EL erhöhen oder die Prüfung verkleinern, dann den Motor einschalten.</translation>
    </message>
    <message>
        <source>Check the link, then start the test again.</source>
        <translation>Die Verbindung prüfen, dann die Prüfung erneut starten.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Start the test again.</source>
        <translation>Meist Störungen auf dem Kabel. Die Prüfung erneut starten.</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its limit stop ended it.</source>
        <translation>%1 hat den Sprung nicht beendet: Der Endschalter-Stopp hat ihn abgebrochen.</translation>
    </message>
    <message>
        <source>Its limit stop ended the test.</source>
        <translation>Der Endschalter-Stopp hat die Prüfung abgebrochen.</translation>
    </message>
    <message>
        <source>The motor did not follow the sine wave, and was commanded to hold. Check for a jam, a hard stop, a slipping coupling or missing motor power, or use another amplitude.</source>
        <translation>Der Motor folgte der Sinusschwingung nicht und bekam einen Haltebefehl. Auf eine Blockade, einen Anschlag, eine rutschende Kupplung oder fehlende Motorversorgung prüfen, oder eine andere Amplitude nehmen.</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: its output reached the limit OL.</source>
        <translation>%1 hat wieder die vorigen Verstärkungen: Die Stellgröße hat die Grenze OL erreicht.</translation>
    </message>
    <message>
        <source>It oscillates, or was pushed. Lower Kp, or raise Kd, then try again.</source>
        <translation>Der Motor schwingt oder wurde angestoßen. Kp senken oder Kd erhöhen, dann erneut probieren.</translation>
    </message>
    <message>
        <source>Looking for printers…</source>
        <translation>Drucker werden gesucht…</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Add one in the system&apos;s printer settings, or save the page as a PDF file.</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet. In den Druckereinstellungen des Systems einen hinzufügen, oder die Seite als PDF-Datei speichern.</translation>
    </message>
    <message>
        <source>Printer: %1</source>
        <translation>Drucker: %1</translation>
    </message>
    <message>
        <source>The output reached its limit. The previous gains are restored.</source>
        <translation>Die Stellgröße hat ihre Grenze erreicht. Die vorigen Verstärkungen gelten wieder.</translation>
    </message>
    <message>
        <source>The line at %1 was disturbed while the modules were given addresses.</source>
        <translation>Die Leitung an %1 war gestört, während die Module Adressen bekamen.</translation>
    </message>
    <message>
        <source>A module that had answered stopped answering, so the number of modules is unknown. No motor was moved. Check the cable and the adapter, then scan again.</source>
        <translation>Ein Modul, das geantwortet hatte, verstummte. Wie viele es sind, ist daher unbekannt. Kein Motor wurde bewegt. Kabel und Adapter prüfen, dann erneut suchen.</translation>
    </message>
    <message>
        <source>The adapter at %1 passes answers on in pieces, up to %2 ms apart.</source>
        <translation>Der Adapter an %1 gibt Antworten stückweise weiter, mit bis zu %2 ms Abstand.</translation>
    </message>
    <message>
        <source>USB hubs, Bluetooth and device servers do that. The panel waits for the rest, so updates are slower. No action needed.</source>
        <translation>USB-Hubs, Bluetooth und Geräteserver tun das. Das Programm wartet auf den Rest, daher kommen Werte langsamer. Nichts zu tun.</translation>
    </message>
    <message>
        <source>Motors were commanded to stop. Until answers have been correct for 2 s, only presence queries are sent; then the panel looks for the modules again. Try a lower baud rate, a shorter cable, or termination at both ends.</source>
        <translation>An die Motoren ging ein Stoppbefehl. Bis die Antworten 2 s lang richtig waren, wird nur noch nach den Modulen gefragt; dann sucht das Programm erneut. Eine niedrigere Baudrate, ein kürzeres Kabel oder einen Abschluss an beiden Enden versuchen.</translation>
    </message>
    <message>
        <source>%1 is %2; the module accepts %3 to %4.</source>
        <translation>%1 ist %2; das Modul nimmt %3 bis %4 an.</translation>
    </message>
    <message numerus="yes">
        <source>%n stopped and holding</source>
        <translation>
            <numerusform>%n gestoppt und hält</numerusform>
            <numerusform>%n gestoppt und halten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n switched off</source>
        <translation>
            <numerusform>%n abgeschaltet</numerusform>
            <numerusform>%n abgeschaltet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n were off</source>
        <translation>
            <numerusform>%n war aus</numerusform>
            <numerusform>%n waren aus</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n I/O modules in their stop state</source>
        <translation>
            <numerusform>%n E/A-Modul wie für einen Stopp eingestellt</numerusform>
            <numerusform>%n E/A-Module wie für einen Stopp eingestellt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 ms.</source>
        <translation>%1, %2 ms.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to switch off: one answer reported a move in the wrong direction, to %2 counts.</source>
        <translation>Modul %1 bekam den Befehl, seinen Motor abzuschalten: Laut einer Antwort bewegte er sich in die falsche Richtung, bis %2 Inkremente.</translation>
    </message>
    <message>
        <source>If it did, encoder or motor wires are swapped, or the gains make it oscillate. If it did not, the answer was wrong: check the cable.</source>
        <translation>Wenn das stimmt, sind Encoder- oder Motoradern vertauscht, oder die Reglerwerte lassen ihn schwingen. Wenn die Position richtig ist, war es nicht seine eigene Antwort: Kabel prüfen.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: one answer reported that it went past its goal, to %2 counts.</source>
        <translation>An Modul %1 ging ein Stoppbefehl: Laut einer Antwort fuhr es über sein Ziel hinaus, bis %2 Inkremente.</translation>
    </message>
    <message>
        <source>Check the position before the next move. If it went there, the command was corrupted in transit, or the gains cause a large overshoot. If it did not, the answer was wrong: check the cable.</source>
        <translation>Vor der nächsten Fahrt die Position prüfen. Wenn es dorthin fuhr, wurde der Befehl unterwegs verfälscht, oder die Reglerwerte verursachen starkes Überschwingen. Wenn nicht, war es nicht seine eigene Antwort: Kabel prüfen.</translation>
    </message>
    <message>
        <source>A question is waiting for your answer: %1</source>
        <translation>Eine Frage wartet auf Ihre Antwort: %1</translation>
    </message>
    <message>
        <source>Show the question</source>
        <translation>Frage zeigen</translation>
    </message>
    <message>
        <source>Maybe off</source>
        <translation>Vielleicht aus</translation>
    </message>
    <message>
        <source>Maybe moving</source>
        <translation>Bewegt sich vielleicht</translation>
    </message>
    <message>
        <source>One answer says that the motor is off. The next answer will show whether it is.</source>
        <translation>Laut einer Antwort hat das Modul seinen Motor abgeschaltet. Die nächste wird es zeigen.</translation>
    </message>
    <message>
        <source>The last answers show the motor at rest, but it is not yet known whether it was started.</source>
        <translation>Nach den letzten Antworten steht der Motor, aber ob er gestartet wurde, ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Looking for modules… Until they are found, only stop commands work.</source>
        <translation>Module werden gesucht… Bis sie gefunden sind, wirken nur Stopps.</translation>
    </message>
    <message>
        <source>The servo rate of this module is unknown, so speeds per second cannot be calculated. Apply its gains first: they include SR.</source>
        <translation>Der Servotakt-Teiler SR dieses Moduls ist unbekannt, und damit jede Geschwindigkeit pro Sekunde. Zuerst seine Reglerwerte anwenden: SR gehört dazu.</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>%1 s alt</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has one column per signal, a format for other programs. The scope opens files with one row per reply.</source>
        <translation>„%1“ hat eine Spalte je Signal, eine Form für andere Programme. Das Oszilloskop öffnet Dateien mit einer Zeile je Antwort.</translation>
    </message>
    <message>
        <source>The position counter of module %1 has wrapped.</source>
        <translation>Die Position von Modul %1 ist übergelaufen.</translation>
    </message>
    <message>
        <source>The 32-bit counter has overflowed and continues at the other end of its range. Earlier positions and travel limits no longer match: find home, then clear the sticky bits on the Details page.</source>
        <translation>Sie hat 32 Bit und ging am anderen Ende ihres Bereichs weiter. Positionen und Verfahrgrenzen von vorher sind nicht mehr, wo sie waren: Referenz suchen, dann auf der Seite Details die Sticky-Bits löschen.</translation>
    </message>
    <message>
        <source>Limit switch 1 is active: the motor can only move away from it.</source>
        <translation>Endschalter 1 ist aktiv: Der Motor kann sich nur von ihm weg bewegen.</translation>
    </message>
    <message>
        <source>Limit switch 2 is active: the motor can only move away from it.</source>
        <translation>Endschalter 2 ist aktiv: Der Motor kann sich nur von ihm weg bewegen.</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>%1 is not a line behind a network.</source>
        <translation>%1 ist keine Leitung hinter einem Netzwerk.</translation>
    </message>
    <message>
        <source>Write tcp://HOST:PORT, or rfc2217://HOST:PORT if the device server lets the rate be set.</source>
        <translation>tcp://HOST:PORT schreiben, oder rfc2217://HOST:PORT, wenn sich die Baudrate am Geräteserver einstellen lässt.</translation>
    </message>
    <message>
        <source>The computer or device server in %1 was not found.</source>
        <translation>Der Computer oder Geräteserver in %1 wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>Check its name, and the network.</source>
        <translation>Den Namen und das Netzwerk prüfen.</translation>
    </message>
    <message>
        <source>Nothing accepts connections at %1.</source>
        <translation>Bei %1 nimmt nichts Verbindungen an.</translation>
    </message>
    <message>
        <source>Check that the device server is on, that its TCP port is this one, and that no other program has it.</source>
        <translation>Prüfen, ob der Geräteserver eingeschaltet ist, ob dies sein TCP-Port ist und ob kein anderes Programm ihn belegt.</translation>
    </message>
    <message>
        <source>%1 does not let the serial port be controlled.</source>
        <translation>%1 lässt die serielle Schnittstelle nicht steuern.</translation>
    </message>
    <message>
        <source>Enable RFC 2217 in the device server, or set it to 19 200 Bd, 8N1, and connect with tcp:// instead.</source>
        <translation>RFC 2217 im Geräteserver einschalten, oder ihn auf 19 200 Bd, 8N1, stellen und stattdessen mit tcp:// verbinden.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost. %2</source>
        <translation>Die Verbindung zu %1 ist abgebrochen. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then check the network and the device server.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen, dann Netzwerk und Geräteserver prüfen.</translation>
    </message>
    <message>
        <source>The line is lent to a program.</source>
        <translation>Die Leitung ist an ein Programm verliehen.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, lent to a program</source>
        <translation>Verbunden mit %1 bei %2 Bd, %3, an ein Programm verliehen</translation>
    </message>
    <message>
        <source>Settings copied from %1: %2.</source>
        <translation>Einstellungen von %1 kopiert: %2.</translation>
    </message>
    <message>
        <source>The move and the record after it would take more than 6 s. Shorten the move or the record, or move faster.</source>
        <translation>Die Fahrt und die Aufzeichnung danach würden länger als 6 s dauern. Fahrt oder Aufzeichnung verkürzen, oder schneller fahren.</translation>
    </message>
    <message>
        <source>The motor swung so far that it reversed, and was commanded to hold. Raise the speed, or lower the amplitude.</source>
        <translation>Der Motor schwang so weit, dass er die Richtung wechselte, und bekam einen Haltebefehl. Die Geschwindigkeit erhöhen oder die Amplitude verringern.</translation>
    </message>
    <message>
        <source>At this speed the motor would reverse. Raise the speed, or lower the amplitude or the highest frequency.</source>
        <translation>Bei dieser Geschwindigkeit würde der Motor die Richtung wechseln. Die Geschwindigkeit erhöhen oder die Amplitude oder die höchste Frequenz verringern.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, from home</source>
        <translation>„%1“, ab Referenz</translation>
    </message>
    <message>
        <source>%1 did not stay within its arrival tolerance. Check its gains, or change the tolerance (Axis page).</source>
        <translation>%1 blieb nicht innerhalb der Ankunftstoleranz. Die Reglerwerte prüfen oder die Toleranz ändern (Seite Achse).</translation>
    </message>
    <message>
        <source>The motor would come too close to the position error limit, which switches the servo off. Make the step, the amplitude or the speed smaller, or raise EL.</source>
        <translation>Der Motor käme der Positionsfehlergrenze zu nahe, die den Servo abschaltet. Sprung, Amplitude oder Geschwindigkeit verkleinern oder EL erhöhen.</translation>
    </message>
    <message>
        <source>%1 did not finish its approaches.</source>
        <translation>%1 hat die Anfahrten nicht beendet.</translation>
    </message>
    <message>
        <source>Reading the captured position</source>
        <translation>Liest die erfasste Position</translation>
    </message>
    <message>
        <source>The switch changed again while the motor stopped beyond it: it bounces, or its cam is too short. The motor is at rest. Move more slowly, or raise the acceleration.</source>
        <translation>Der Schalter hat noch einmal gewechselt, während der Motor dahinter anhielt: Er prellt, oder der Nocken ist zu kurz. Der Motor steht. Langsamer fahren oder die Beschleunigung erhöhen.</translation>
    </message>
    <message>
        <source>The switch or index did not change within the search distance and the time limit. It may be stuck, closed on both sides, or in the other direction; above 1 count per tick, an index can be missed. The motor was stopped.</source>
        <translation>Schalter oder Index hat sich innerhalb von Suchweg und Zeitgrenze nicht geändert. Er kann klemmen, auf beiden Seiten geschlossen sein oder in der anderen Richtung liegen; über 1 Inkrement je Takt kann ein Index verpasst werden. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>The switch or index did not change within the travel limits. The motor was stopped.</source>
        <translation>Schalter oder Index hat sich innerhalb der Verfahrgrenzen nicht geändert. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion before the switch changed. The motor is at rest.</source>
        <translation>Ein Endschalter oder der Not-Halt-Eingang hat die Bewegung beendet, bevor der Schalter wechselte. Der Motor steht.</translation>
    </message>
    <message>
        <source>Choose one switch or the index, and nothing else.</source>
        <translation>Genau einen Schalter oder den Index wählen.</translation>
    </message>
    <message>
        <source>Approach it 2 to 100 times from each side.</source>
        <translation>2 bis 100 Anfahrten von jeder Seite wählen.</translation>
    </message>
    <message>
        <source>An earlier stop was not confirmed, so it was sent now.</source>
        <translation>Ein früherer Stopp wurde nicht bestätigt und deshalb jetzt gesendet.</translation>
    </message>
    <message>
        <source>No stop can be sent now: use the hardware stop.</source>
        <translation>Jetzt kann kein Stopp gesendet werden: den Hardware-Stopp benutzen.</translation>
    </message>
    <message>
        <source>It is sent as soon as you connect to the same modules again.</source>
        <translation>Er wird gesendet, sobald wieder eine Verbindung zu denselben Modulen besteht.</translation>
    </message>
    <message>
        <source>Not connected: the state of the chain is unknown.</source>
        <translation>Nicht verbunden, daher ist über die Kette nichts bekannt.</translation>
    </message>
    <message>
        <source>Chain OK: %1.</source>
        <translation>Alles in Ordnung: %1.</translation>
    </message>
    <message>
        <source>No module answered.</source>
        <translation>Kein Modul hat geantwortet.</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered; the far end of the chain is missing.</source>
        <translation>%1 von %2 Modulen haben geantwortet, und das ferne Ende der Kette ist nicht darunter.</translation>
    </message>
    <message>
        <source>%1 is not the expected module.</source>
        <translation>%1 ist nicht das erwartete Modul.</translation>
    </message>
    <message>
        <source>More modules than expected: %1 instead of %2.</source>
        <translation>Es sind mehr Module als erwartet: %1 statt %2.</translation>
    </message>
    <message>
        <source>%1 stopped answering. Motor state unknown.</source>
        <translation>%1 antwortet nicht mehr. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and gains are lost.</source>
        <translation>%1 ist neu gestartet: Position und Reglerwerte sind verloren.</translation>
    </message>
    <message>
        <source>%1 restarted: its pins are inputs again, and its outputs release what they drove.</source>
        <translation>%1 ist neu gestartet: Seine Pins sind wieder Eingänge, seine Ausgänge haben losgelassen, was sie getrieben haben.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and parameters are lost.</source>
        <translation>%1 ist neu gestartet: Position und Parameter sind verloren.</translation>
    </message>
    <message>
        <source>Choose a port and connect.</source>
        <translation>Einen Port wählen und verbinden.</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC.</source>
        <translation>Der Reihe nach prüfen: Versorgung der Module; jedes Kabel der Kette, ein loses Kabel verbirgt alle Module; den ADDR_IN-Jumper des vom PC am weitesten entfernten Moduls.</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.</source>
        <translation>Die Nummerierung beginnt am fernen Ende. Deshalb das nächste Modul in Richtung PC nach %1 prüfen: zuerst seine Versorgung, dann den Stecker dazwischen. Dann erneut suchen.</translation>
    </message>
    <message>
        <source>Only the modules nearest the PC answered, and their numbers have changed. Check the cable to the module at the far end, and check that no other ADDR_IN is grounded. Until this is fixed, settings do not match the modules.</source>
        <translation>Nur die Module nahe am PC haben geantwortet, und ihre Nummern haben sich geändert. Das Kabel zum Modul am fernen Ende prüfen und ob ein anderer ADDR_IN auf Masse liegt. Bis das behoben ist, passen die Einstellungen nicht zu den Modulen.</translation>
    </message>
    <message>
        <source>Name, unit, limits, speeds and points of the expected module are used for it; gains and parameters from a machine file are not sent to it. If you replaced the module on purpose, check these settings, then accept the chain as found.</source>
        <translation>Name, Einheit, Grenzen, Geschwindigkeiten und Punkte des erwarteten Moduls werden für dieses verwendet; Reglerwerte und Parameter aus einer Maschinendatei werden ihm nicht gesendet. Wurde es absichtlich getauscht, diese Einstellungen prüfen, dann die Kette so übernehmen, wie sie ist.</translation>
    </message>
    <message>
        <source>The settings of this place are for another type of module, so they are not used, and only stop commands work. Check the cables, then scan again. If you replaced the module on purpose, accept the chain as found (Chain doctor): all but its name is then to be set again, and its positions leave the points.</source>
        <translation>Die Einstellungen dieses Platzes gehören zu einem anderen Modultyp. Sie werden daher nicht verwendet, und nur Stopps wirken. Die Kabel prüfen, dann erneut suchen. Wurde das Modul absichtlich getauscht, die Kette so übernehmen, wie sie ist (Kettendiagnose): Dann ist alles außer seinem Namen neu einzustellen, und seine Positionen entfallen aus den Punkten.</translation>
    </message>
    <message>
        <source>Modules from %1 on are new. If they belong there, accept the chain as found.</source>
        <translation>Ab %1 sind die Module neu. Gehören sie dorthin, die Kette so übernehmen, wie sie ist.</translation>
    </message>
    <message>
        <source>Check its power and cable; use the hardware stop if its motor moves. The panel retries from time to time.</source>
        <translation>Versorgung und Kabel prüfen; bewegt sich der Motor, den Hardware-Stopp benutzen. Das Programm fragt von Zeit zu Zeit erneut an.</translation>
    </message>
    <message>
        <source>Modules between it and the PC may not answer until it has its address again. Restart the network when it is safe to stop all motors and lose their positions.</source>
        <translation>Module von ihm in Richtung PC sind möglicherweise nicht ansprechbar, bis es wieder seine Adresse hat. Wenn alle Motoren stillstehen und ihre Positionen verlieren dürfen, das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>different module</source>
        <translation>anderes Modul</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>nicht abgefragt</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>neu gestartet</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>keine Gruppe</translation>
    </message>
    <message>
        <source>This chain is new: it has %1.</source>
        <translation>Diese Kette ist neu: Sie hat %1.</translation>
    </message>
    <message>
        <source>Compare the list with the labels on the modules, starting with the module farthest from the PC. If it is right, accept the chain as found: from then on, missing and replaced modules are reported.</source>
        <translation>Die Liste mit den Aufschriften der Module vergleichen, beginnend mit dem, das am weitesten vom PC entfernt ist. Stimmt sie, die Kette so übernehmen: Von da an werden fehlende und getauschte Module gemeldet.</translation>
    </message>
    <message>
        <source>Looking for modules…</source>
        <translation>Module werden gesucht…</translation>
    </message>
    <message>
        <source>Home: %1</source>
        <translation>Referenz: %1</translation>
    </message>
    <message>
        <source>Home: unknown</source>
        <translation>Referenz: unbekannt</translation>
    </message>
    <message>
        <source>Home is unknown. Search for home, or move there and choose Save as home. A restart of the module loses home again.</source>
        <translation>Die Referenz ist unbekannt. Die Referenz suchen oder dorthin fahren und „Als Referenz speichern“ wählen. Ein Neustart des Moduls verliert sie wieder.</translation>
    </message>
    <message>
        <source>Home is at %1. A search found it %2 min ago.</source>
        <translation>Die Referenz liegt bei %1. Sie wurde vor %2 min durch eine Suche gefunden.</translation>
    </message>
    <message>
        <source>Home is at %1. It was saved %2 min ago.</source>
        <translation>Die Referenz liegt bei %1. Sie wurde vor %2 min gespeichert.</translation>
    </message>
    <message>
        <source>Makes the present position 0. The motor does not move. The old zero is lost: from then on all positions count from here.</source>
        <translation>Macht die jetzige Position zu 0. Der Motor bewegt sich nicht. Der bisherige Nullpunkt geht verloren: Ab dann zählen alle Positionen von hier.</translation>
    </message>
    <message>
        <source>This moves home from %1 to %2.</source>
        <translation>Die Referenz geht damit von %1 auf %2.</translation>
    </message>
    <message>
        <source>The position that the chip captured or saved last. A limit stop changes it, too; Zero here does not. Go home does not use it.</source>
        <translation>Die Position, die der Chip zuletzt erfasst oder gespeichert hat. Auch ein Endschalter-Stopp ändert sie, „Hier nullen“ nicht. „Zur Referenz“ benutzt sie nicht.</translation>
    </message>
    <message>
        <source>Home: %1, not verified</source>
        <translation>Referenz: %1, nicht bestätigt</translation>
    </message>
    <message>
        <source>Home is at %1, not verified: restored %2 min ago from the last known position. Search for home to verify it.</source>
        <translation>Die Referenz liegt bei %1, nicht bestätigt: Sie wurde vor %2 min aus der letzten bekannten Position wiederhergestellt. Eine Referenzfahrt bestätigt sie.</translation>
    </message>
    <message>
        <source>Home is at %1. You confirmed the position %2 min ago.</source>
        <translation>Die Referenz liegt bei %1. Die Position wurde vor %2 min bestätigt.</translation>
    </message>
    <message>
        <source>That is %1; this module can be given at most %2.</source>
        <translation>Das sind %1; dieses Modul nimmt höchstens %2 an.</translation>
    </message>
    <message>
        <source>That is %1; the highest velocity of this axis is %2 (Axis page).</source>
        <translation>Das sind %1; die höchste Geschwindigkeit dieser Achse ist %2 (Seite Achse).</translation>
    </message>
    <message>
        <source>Lowest position reached: %1. Move forward.</source>
        <translation>Tiefste Position erreicht: %1. Vorwärts bewegen.</translation>
    </message>
    <message>
        <source>Highest position reached: %1. Move in reverse.</source>
        <translation>Höchste Position erreicht: %1. Rückwärts bewegen.</translation>
    </message>
    <message>
        <source>No travel limits are set.</source>
        <translation>Keine Fahrweggrenzen gesetzt.</translation>
    </message>
    <message>
        <source>Not in force: home is unknown. Search for it, save it, or confirm the position.</source>
        <translation>Nicht in Kraft: Die Referenz ist unbekannt. Suchen, speichern oder die Position bestätigen.</translation>
    </message>
    <message>
        <source>In force: not below %1.</source>
        <translation>In Kraft: nicht unter %1.</translation>
    </message>
    <message>
        <source>In force: not above %1.</source>
        <translation>In Kraft: nicht über %1.</translation>
    </message>
    <message>
        <source>In force: from %1 to %2.</source>
        <translation>In Kraft: von %1 bis %2.</translation>
    </message>
    <message>
        <source>Travel limits not in force</source>
        <translation>Fahrweggrenzen nicht in Kraft</translation>
    </message>
    <message>
        <source>At the lowest position</source>
        <translation>An der tiefsten Position</translation>
    </message>
    <message>
        <source>At the highest position</source>
        <translation>An der höchsten Position</translation>
    </message>
    <message>
        <source>Below the lowest position</source>
        <translation>Unter der tiefsten Position</translation>
    </message>
    <message>
        <source>Above the highest position</source>
        <translation>Über der höchsten Position</translation>
    </message>
    <message>
        <source>Look at the axis first: is %1 really at %2? If so, home is at position 0, and the travel limits apply from there. If not, they protect the wrong range.</source>
        <translation>Zuerst die Achse ansehen: Steht %1 wirklich bei %2? Dann liegt die Referenz bei Position 0, und die Fahrweggrenzen gelten von dort aus. Wenn nicht, schützen sie den falschen Bereich.</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, below the lowest position %2. Lower that position, or change the backlash or its direction (Axis page).</source>
        <translation>Um das Spiel aufzunehmen, würde die Fahrt bei %1 umkehren, unter der tiefsten Position %2. Diese Position tiefer setzen, oder das Spiel oder seine Richtung ändern (Seite Achse).</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, above the highest position %2. Raise that position, or change the backlash or its direction (Axis page).</source>
        <translation>Um das Spiel aufzunehmen, würde die Fahrt bei %1 umkehren, über der höchsten Position %2. Diese Position höher setzen, oder das Spiel oder seine Richtung ändern (Seite Achse).</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the lowest position is %1 (Axis page).</source>
        <translation>Das liegt außerhalb der Fahrweggrenzen: Die tiefste Position ist %1 (Seite Achse).</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the highest position is %1 (Axis page).</source>
        <translation>Das liegt außerhalb der Fahrweggrenzen: Die höchste Position ist %1 (Seite Achse).</translation>
    </message>
    <message>
        <source>The highest velocity is set on the Axis page.</source>
        <translation>Die höchste Geschwindigkeit steht auf der Seite Achse.</translation>
    </message>
    <message>
        <source>The max jog speed and the highest velocity are set on the Axis page.</source>
        <translation>Die max. Tippgeschwindigkeit und die höchste Geschwindigkeit stehen auf der Seite Achse.</translation>
    </message>
    <message>
        <source>from &quot;%1&quot;</source>
        <translation>ab „%1“</translation>
    </message>
    <message>
        <source>%1 by the counter</source>
        <translation>%1 nach dem Zähler</translation>
    </message>
    <message>
        <source>Positions count from &quot;%1&quot;.</source>
        <translation>Positionen zählen ab „%1“.</translation>
    </message>
    <message>
        <source>It is not known any more where &quot;%1&quot; is. Choose the work offset again, or clear it (Axis page).</source>
        <translation>Es ist nicht mehr bekannt, wo „%1“ ist. Den Nullpunktversatz neu wählen oder aufheben (Seite Achse).</translation>
    </message>
    <message>
        <source>steps/s²</source>
        <translation>Schritte/s²</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>Ink./s</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>Ink./s²</translation>
    </message>
    <message>
        <source>%1 (%2 of 255)</source>
        <translation>%1 (%2 von 255)</translation>
    </message>
    <message>
        <source>Oscillating ± %1 at about %2 Hz</source>
        <translation>Schwingt um ± %1 bei etwa %2 Hz</translation>
    </message>
    <message>
        <source>Oscillating ± %1</source>
        <translation>Schwingt um ± %1</translation>
    </message>
    <message>
        <source>Hunting ± %1 every %2 s. Lower Ki.</source>
        <translation>Pendelt um ± %1 alle %2 s. Ki verkleinern.</translation>
    </message>
    <message>
        <source>%1, hunting</source>
        <translation>%1, pendelt</translation>
    </message>
    <message>
        <source>%1, oscillating</source>
        <translation>%1, schwingt</translation>
    </message>
    <message>
        <source>%1, pushing at OL</source>
        <translation>%1, drückt mit OL</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1, %2 daneben</translation>
    </message>
    <message>
        <source>Kp is 0: the servo brakes the motor but holds no position.</source>
        <translation>Kp ist 0: Der Servo bremst den Motor, hält aber keine Position.</translation>
    </message>
    <message>
        <source>%1 off the position to hold, and pushing with up to the full output limit. Something may be in the way.</source>
        <translation>%1 neben der Position, die zu halten ist, und drückt mit bis zur ganzen Ausgangsgrenze. Vielleicht ist etwas im Weg.</translation>
    </message>
    <message>
        <source>%1 off the position to hold: friction, a load or an obstacle is stronger. A higher Kp, or an integral (Ki, IL), pushes more.</source>
        <translation>%1 neben der Position, die zu halten ist: Reibung, eine Last oder ein Hindernis ist stärker. Ein größeres Kp oder ein Integralanteil (Ki, IL) drückt mehr.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; is missing.</source>
        <translation>Der Parameter „%1“ fehlt.</translation>
    </message>
    <message>
        <source>These parameters are missing: %1.</source>
        <translation>Diese Parameter fehlen: %1.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; has the wrong type, or is out of its range.</source>
        <translation>Der Parameter „%1“ hat den falschen Typ oder liegt außerhalb seines Bereichs.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here.</source>
        <translation>Der Parameter „%1“ muss hier zwischen %2 und %3 liegen.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here, in either direction. %3 is the max jog speed of the axis.</source>
        <translation>Der Parameter „%1“ muss hier zwischen %2 und %3 liegen, in beiden Richtungen. %3 ist die max. Tippgeschwindigkeit der Achse.</translation>
    </message>
    <message>
        <source>There is no such axis.</source>
        <translation>Diese Achse gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no sequence or point of that name.</source>
        <translation>Einen Ablauf oder Punkt dieses Namens gibt es nicht.</translation>
    </message>
    <message>
        <source>This program may not move motors now: call request_control first.</source>
        <translation>Dieses Programm darf jetzt keine Motoren bewegen: zuerst request_control aufrufen.</translation>
    </message>
    <message>
        <source>Call hello first.</source>
        <translation>Zuerst hello aufrufen.</translation>
    </message>
    <message>
        <source>This panel speaks version %1 of the protocol, and the program version %2.</source>
        <translation>Dieses Bedienprogramm spricht Version %1 des Protokolls, das andere Programm Version %2.</translation>
    </message>
    <message>
        <source>It was cancelled by a stop or by another command.</source>
        <translation>Ein Stopp oder ein anderer Befehl hat es abgebrochen.</translation>
    </message>
    <message>
        <source>Motors were stopped.</source>
        <translation>Motoren wurden gestoppt.</translation>
    </message>
    <message>
        <source>The user has taken control back.</source>
        <translation>Der Benutzer hat die Kontrolle zurückgenommen.</translation>
    </message>
    <message>
        <source>The user has commanded a motor.</source>
        <translation>Der Benutzer hat einem Motor etwas befohlen.</translation>
    </message>
    <message>
        <source>The chain is no longer connected.</source>
        <translation>Die Kette ist nicht mehr verbunden.</translation>
    </message>
    <message>
        <source>Other programs cannot connect.</source>
        <translation>Andere Programme können sich nicht verbinden.</translation>
    </message>
    <message>
        <source>Another panel already lets programs in at %1.</source>
        <translation>Ein anderes Bedienprogramm lässt bereits Programme unter %1 ein.</translation>
    </message>
    <message>
        <source>%1 is a link, belongs to another user, or is open to others. Remove it, and try again.</source>
        <translation>%1 ist eine Verknüpfung, gehört einem anderen Benutzer oder ist für andere offen. Entfernen und erneut versuchen.</translation>
    </message>
    <message>
        <source>%1 cannot be created.</source>
        <translation>%1 lässt sich nicht anlegen.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has connected. It may read, stop motors and switch them off, but not move them.</source>
        <translation>Programm „%1“ hat sich verbunden. Es darf lesen, Motoren anhalten und ausschalten, sie aber nicht bewegen.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected; the motors that it moved are stopped.</source>
        <translation>Programm „%1“ hat sich getrennt; die Motoren, die es bewegt hat, werden gestoppt.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected.</source>
        <translation>Programm „%1“ hat sich getrennt.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot;: %2</source>
        <translation>Programm „%1“: %2</translation>
    </message>
    <message>
        <source>This line is not JSON.</source>
        <translation>Diese Zeile ist kein JSON.</translation>
    </message>
    <message>
        <source>A request is an object with method, params (an object) and id.</source>
        <translation>Eine Anfrage ist ein Objekt mit method, params (einem Objekt) und id.</translation>
    </message>
    <message>
        <source>There is no such method.</source>
        <translation>Diese Methode gibt es nicht.</translation>
    </message>
    <message>
        <source>The line is lent at %1. No program has used it yet.</source>
        <translation>Die Leitung ist bei %1 verliehen. Noch hat kein Programm sie benutzt.</translation>
    </message>
    <message>
        <source>A program has the line, at %1.</source>
        <translation>Ein Programm hat die Leitung, bei %1.</translation>
    </message>
    <message>
        <source>All motors were commanded to stop, and the program is held off.</source>
        <translation>Allen Motoren wurde Stopp befohlen, und das Programm wird aufgehalten.</translation>
    </message>
    <message>
        <source>What it sends is dropped. Release lets it continue; it does not know what it has missed.</source>
        <translation>Was es sendet, wird verworfen. Freigeben lässt es weitermachen; es weiß nicht, was ihm entgangen ist.</translation>
    </message>
    <message>
        <source>The program has closed %1, and the line is no longer lent.</source>
        <translation>Das Programm hat %1 geschlossen, und die Leitung ist nicht mehr verliehen.</translation>
    </message>
    <message>
        <source>The line is no longer lent.</source>
        <translation>Die Leitung ist nicht mehr verliehen.</translation>
    </message>
    <message>
        <source>The line was not lent.</source>
        <translation>Die Leitung wurde nicht verliehen.</translation>
    </message>
    <message>
        <source>The chain was busy, or a motor was moving. Stop the motors, and try again.</source>
        <translation>Die Kette war beschäftigt, oder ein Motor bewegte sich. Die Motoren stoppen und es erneut versuchen.</translation>
    </message>
    <message>
        <source>There is something at %1 already. Choose another path.</source>
        <translation>Bei %1 ist schon etwas. Einen anderen Pfad wählen.</translation>
    </message>
    <message>
        <source>No terminal can be made at %1. Choose a path in a folder of your own.</source>
        <translation>Bei %1 lässt sich kein Terminal anlegen. Einen Pfad in einem eigenen Ordner wählen.</translation>
    </message>
    <message>
        <source>LENT at %1 — stopped; the program is held off.</source>
        <translation>VERLIEHEN bei %1 — gestoppt; das Programm wird aufgehalten.</translation>
    </message>
    <message>
        <source>LENT at %1 — a program has the line. No travel limit or other check of the panel protects the motors; STOP ALL does.</source>
        <translation>VERLIEHEN bei %1 — ein Programm hat die Leitung. Keine Verfahrgrenze und keine andere Prüfung schützt die Motoren; ALLES STOPP wirkt.</translation>
    </message>
    <message>
        <source>LENT at %1 — no program yet.</source>
        <translation>VERLIEHEN bei %1 — noch kein Programm.</translation>
    </message>
    <message>
        <source>The motor did not stay within the arrival tolerance of its axis.</source>
        <translation>Der Motor blieb nicht innerhalb der Ankunftstoleranz seiner Achse.</translation>
    </message>
    <message>
        <source>This pin is not set as an output. Make it an output first.</source>
        <translation>Dieser Pin ist nicht als Ausgang eingestellt. Zuerst als Ausgang einstellen.</translation>
    </message>
    <message>
        <source>The outputs of this module, or their directions, are unknown. Set them once first.</source>
        <translation>Die Ausgänge dieses Moduls oder ihre Richtungen sind unbekannt. Sie zuerst einmal setzen.</translation>
    </message>
    <message>
        <source>Several axes have this name. Use the number of the axis, or give each its own name.</source>
        <translation>Mehrere Achsen haben diesen Namen. Die Nummer der Achse verwenden oder jeder einen eigenen Namen geben.</translation>
    </message>
</context>
<context>
    <name>nmc::AmplifierBox</name>
    <message>
        <source>3-phase commutation</source>
        <translation>3-Phasen-Kommutierung</translation>
    </message>
    <message>
        <source>For a brushless motor with Hall sensors and a 3-phase amplifier. Off: a brush motor.</source>
        <translation>Für einen bürstenlosen Motor mit Hall-Sensoren und einen 3-Phasen-Verstärker. Aus: ein Bürstenmotor.</translation>
    </message>
    <message>
        <source>Antiphase PWM</source>
        <translation>Gegenphasige PWM</translation>
    </message>
    <message>
        <source>For a locked-antiphase amplifier: 50 % PWM is zero output. Off: PWM and direction.</source>
        <translation>Für einen Verstärker mit gegenphasiger PWM (locked antiphase): 50 % PWM ist Ausgang null. Aus: PWM und Richtung.</translation>
    </message>
    <message>
        <source>Step and direction input</source>
        <translation>Takt- und Richtungseingang</translation>
    </message>
    <message>
        <source>The motor follows step pulses at the limit pins instead of commands. The limit inputs then give no protection.</source>
        <translation>Der Motor folgt Taktimpulsen an den Endschalter-Pins statt Befehlen. Die Endschalter schützen dann nicht.</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz.</source>
        <translation>Bahnpunkte mit 60 und 120 Hz statt mit 30 und 60 Hz.</translation>
    </message>
    <message>
        <source>Apply…</source>
        <translation>Anwenden…</translation>
    </message>
    <message>
        <source>Apply the amplifier settings</source>
        <translation>Anwenden der Verstärkereinstellungen</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Set the step multiplier</source>
        <translation>Setzen des Taktfaktors</translation>
    </message>
    <message>
        <source>Keep its address and group</source>
        <translation>Adresse und Gruppe behalten</translation>
    </message>
    <message>
        <source>It comes back at this address after a power cycle, without a search.</source>
        <translation>Nach dem Aus- und Einschalten ist es ohne Suche wieder unter dieser Adresse da.</translation>
    </message>
    <message>
        <source>Amplifier on at power-up</source>
        <translation>Verstärker beim Einschalten an</translation>
    </message>
    <message>
        <source>AMP_EN goes high by itself after each power-up.</source>
        <translation>AMP_EN geht nach jedem Einschalten von selbst auf High.</translation>
    </message>
    <message>
        <source>Servo on at power-up</source>
        <translation>Servo beim Einschalten an</translation>
    </message>
    <message>
        <source>The servo switches on by itself after each power-up, with the saved gains, even with no panel connected.</source>
        <translation>Der Servo schaltet sich nach jedem Einschalten von selbst ein, mit den gespeicherten Reglerwerten, auch wenn kein Programm verbunden ist.</translation>
    </message>
    <message>
        <source>Save in module…</source>
        <translation>Im Modul speichern…</translation>
    </message>
    <message>
        <source>Save in module: configuration for power-up</source>
        <translation>Im Modul speichern, was beim Einschalten gilt</translation>
    </message>
    <message>
        <source>Erase saved…</source>
        <translation>Gespeichertes löschen…</translation>
    </message>
    <message>
        <source>Erase saved configuration of the module</source>
        <translation>Gespeichertes löschen: die Konfiguration des Moduls</translation>
    </message>
    <message>
        <source>Limit inputs</source>
        <translation>Endschalter</translation>
    </message>
    <message>
        <source>do nothing</source>
        <translation>bewirken nichts</translation>
    </message>
    <message>
        <source>stop abruptly</source>
        <translation>stoppen sofort</translation>
    </message>
    <message>
        <source>switch the motor off</source>
        <translation>schalten den Motor aus</translation>
    </message>
    <message>
        <source>Amplifier settings of the module</source>
        <translation>Verstärkereinstellungen des Moduls</translation>
    </message>
    <message>
        <source>Step multiplier</source>
        <translation>Taktfaktor</translation>
    </message>
    <message>
        <source>Counts that one step pulse moves the motor.</source>
        <translation>Um so viele Inkremente bewegt ein Taktimpuls den Motor.</translation>
    </message>
    <message>
        <source>Saved in the module, for power-up</source>
        <translation>Im Modul gespeichert, für das Einschalten</translation>
    </message>
    <message>
        <source>Saves these choices, the settings above, the gains, the velocity and the acceleration as the module has them now. They come back at each power-up. 3-phase and antiphase come back after a reset, too. Both buttons restart the module: its motor switches off, and it needs its gains again.</source>
        <translation>Speichert diese Auswahl, die Einstellungen oben, Reglerwerte, Geschwindigkeit und Beschleunigung, wie das Modul sie jetzt hat. Sie gelten nach jedem Einschalten wieder. 3 Phasen und Gegenphase gelten auch nach einem Reset wieder. Beide Schaltflächen starten das Modul neu: Sein Motor geht aus, und es braucht seine Reglerwerte noch einmal.</translation>
    </message>
    <message>
        <source>? Unknown: nothing has been applied in this connection, and the settings cannot be read back. The module may have saved settings.</source>
        <translation>? Unbekannt: In dieser Verbindung wurde nichts angewendet, und die Einstellungen sind nicht auslesbar. Das Modul kann gespeicherte Einstellungen haben.</translation>
    </message>
    <message>
        <source>✓ Applied: 3-phase %1, antiphase %2, step and direction %3, limits %4.</source>
        <translation>✓ Angewendet: 3 Phasen %1, Gegenphase %2, Takt und Richtung %3, Endschalter %4.</translation>
    </message>
    <message>
        <source>Step and direction uses the limit pins: set the limit inputs to do nothing.</source>
        <translation>Takt und Richtung benutzt die Endschalter-Pins: die Endschalter auf „bewirken nichts“ stellen.</translation>
    </message>
    <message>
        <source>The module already has these settings.</source>
        <translation>Das Modul hat diese Einstellungen.</translation>
    </message>
    <message>
        <source>Takes AMP_EN low and sends these settings.</source>
        <translation>Nimmt AMP_EN auf Low und sendet diese Einstellungen.</translation>
    </message>
    <message>
        <source>Sends the module&apos;s present gains with this multiplier.</source>
        <translation>Sendet die Reglerwerte des Moduls mit diesem Faktor.</translation>
    </message>
    <message>
        <source>Apply the amplifier settings first: the module&apos;s present settings are unknown.</source>
        <translation>Zuerst die Verstärkereinstellungen anwenden: Was das Modul jetzt hat, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Saves the module&apos;s present settings and restarts it.</source>
        <translation>Speichert, was das Modul jetzt hat, und startet es neu.</translation>
    </message>
    <message>
        <source>Erases the module&apos;s saved configuration and restarts it.</source>
        <translation>Lässt das Modul vergessen, was es gespeichert hat, und startet es neu.</translation>
    </message>
    <message>
        <source>Apply amplifier settings</source>
        <translation>Verstärkereinstellungen anwenden</translation>
    </message>
    <message>
        <source>Apply these settings to %1? If 3-phase, antiphase or step and direction do not match the amplifier and its wiring, the amplifier can be destroyed, or the motor can run away once it is enabled.</source>
        <translation>Diese Einstellungen auf %1 anwenden? Passen 3 Phasen, Gegenphase oder Takt und Richtung nicht zum Verstärker und seiner Verdrahtung, kann der Verstärker zerstört werden oder der Motor nach dem Einschalten durchgehen.</translation>
    </message>
    <message>
        <source>Apply settings</source>
        <translation>Einstellungen anwenden</translation>
    </message>
    <message>
        <source>Save the configuration of %1? It takes effect at each power-up, whatever is connected then. The module restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>Die Konfiguration von %1 speichern? Sie gilt nach jedem Einschalten, was auch immer dann angeschlossen ist. Das Modul startet jetzt neu: Sein Motor geht aus, und es braucht seine Reglerwerte noch einmal.</translation>
    </message>
    <message>
        <source>Its motor will be driven right after power-up, without a command.</source>
        <translation>Sein Motor wird gleich nach dem Einschalten bestromt, ohne Befehl.</translation>
    </message>
    <message>
        <source>Save in module</source>
        <translation>Im Modul speichern</translation>
    </message>
    <message>
        <source>Save and restart</source>
        <translation>Speichern und neu starten</translation>
    </message>
    <message>
        <source>Erase saved configuration</source>
        <translation>Gespeichertes löschen</translation>
    </message>
    <message>
        <source>Erase the saved configuration of %1? From the next power-up it starts with its default settings. It restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>Löschen, was %1 gespeichert hat? Ab dem nächsten Einschalten startet es mit seinen Grundeinstellungen. Es startet jetzt neu: Sein Motor geht aus, und es braucht seine Reglerwerte noch einmal.</translation>
    </message>
    <message>
        <source>Erase and restart</source>
        <translation>Löschen und neu starten</translation>
    </message>
    <message>
        <source>What the module does by itself when limit 1 closes while it counts up, or limit 2 while it counts down. It stays armed.</source>
        <translation>Was das Modul von selbst tut, wenn Endschalter 1 schließt, während es aufwärts zählt, oder Endschalter 2, während es abwärts zählt. Es bleibt scharf.</translation>
    </message>
    <message>
        <source>Undo the last edit of the amplifier settings</source>
        <translation>Die letzte Änderung der Verstärkereinstellungen rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the edit of the amplifier settings</source>
        <translation>Die Änderung der Verstärkereinstellungen wiederholen</translation>
    </message>
    <message>
        <source>Revert the amplifier settings to those last sent</source>
        <translation>Verstärkereinstellungen auf die gesendeten zurücksetzen</translation>
    </message>
    <message>
        <source>Restores the amplifier settings last sent. Sends nothing.</source>
        <translation>Stellt die zuletzt gesendeten Verstärkereinstellungen wieder her. Sendet nichts.</translation>
    </message>
    <message>
        <source>Clears the fields: no amplifier settings have been sent yet. Sends nothing.</source>
        <translation>Leert die Felder: Es wurden noch keine Verstärkereinstellungen gesendet. Sendet nichts.</translation>
    </message>
    <message>
        <source>Choose what the limit inputs do.</source>
        <translation>Wählen, was die Endschalter-Eingänge bewirken.</translation>
    </message>
    <message>
        <source>A task is running on this module: wait for its end, or cancel it.</source>
        <translation>Auf diesem Modul läuft ein Vorgang: sein Ende abwarten oder ihn abbrechen.</translation>
    </message>
</context>
<context>
    <name>nmc::AskDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
</context>
<context>
    <name>nmc::AxesPage</name>
    <message>
        <source>All axes</source>
        <translation>Alle Achsen</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Slow jog</source>
        <translation>Langsam tippen</translation>
    </message>
    <message>
        <source>Fast jog</source>
        <translation>Schnell tippen</translation>
    </message>
    <message>
        <source>Step of all axes</source>
        <translation>Schritt aller Achsen</translation>
    </message>
    <message>
        <source>Each axis at its own jog speed.</source>
        <translation>Jede Achse mit ihrer eigenen Tippgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Each axis at its own max jog speed, set on its Axis or Parameters page.</source>
        <translation>Jede Achse mit ihrer max. Tippgeschwindigkeit, die auf ihrer Seite Achse oder Parameter eingestellt ist.</translation>
    </message>
    <message>
        <source>Distance that one click on Step moves an axis, in its own unit.</source>
        <translation>Wie weit ein Klick auf Schritt eine Achse fährt, in ihrer eigenen Einheit.</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 Einheiten</translation>
    </message>
    <message>
        <source>Enable all</source>
        <translation>Alle einschalten</translation>
    </message>
    <message>
        <source>Enable all motors</source>
        <translation>Alle einschalten: alle Motoren</translation>
    </message>
    <message>
        <source>Home all axes, one after the other</source>
        <translation>Die Referenz aller Achsen nacheinander suchen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Homing is not set up for any axis. Set it up on each Homing page.</source>
        <translation>Für keine Achse ist eine Referenzfahrt eingerichtet. Auf der Seite Referenzfahrt jeder Achse einrichten.</translation>
    </message>
    <message>
        <source>All motors are already enabled.</source>
        <translation>Alle Motoren sind bereits eingeschaltet.</translation>
    </message>
    <message>
        <source>Enables every motor at its present position.</source>
        <translation>Schaltet jeden Motor an seiner jetzigen Position ein.</translation>
    </message>
    <message>
        <source>Homes one axis after the other, in the order of the table, with each axis&apos;s homing settings. Any stop ends it.</source>
        <translation>Sucht die Referenz einer Achse nach der anderen, in der Reihenfolge der Tabelle und mit den Einstellungen jeder Achse. Jeder Stopp beendet es.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisBox</name>
    <message>
        <source>Name of the axis</source>
        <translation>Name der Achse</translation>
    </message>
    <message>
        <source>For example: Z axis</source>
        <translation>zum Beispiel Z-Achse</translation>
    </message>
    <message>
        <source>The name of this axis in the list, in messages and in files.</source>
        <translation>Wie diese Achse in der Liste, in Meldungen und in Dateien heißt.</translation>
    </message>
    <message>
        <source>N&amp;ame</source>
        <translation>Name de&amp;r Achse</translation>
    </message>
    <message>
        <source>Unit of the axis</source>
        <translation>Einheit der Achse</translation>
    </message>
    <message>
        <source>native counts</source>
        <translation>Inkremente</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>eine eigene Einheit</translation>
    </message>
    <message>
        <source>The unit for positions and speeds. Changing it keeps every physical value and sends nothing.</source>
        <translation>Die Einheit für Positionen und Geschwindigkeiten. Beim Wechsel bleibt jede physikalische Größe erhalten, und es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>E&amp;inheit</translation>
    </message>
    <message>
        <source>Counts in 1 unit</source>
        <translation>Inkremente in 1 Einheit</translation>
    </message>
    <message>
        <source>Counts or steps per unit.</source>
        <translation>Inkremente oder Schritte je Einheit.</translation>
    </message>
    <message>
        <source>Symbol of the unit</source>
        <translation>Zeichen der Einheit</translation>
    </message>
    <message>
        <source>Shown after the numbers, for example µl.</source>
        <translation>Was hinter den Zahlen steht, zum Beispiel µl.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Jog is never faster than this.</source>
        <translation>Tippen ist nie schneller als dieser Wert.</translation>
    </message>
    <message>
        <source>Max &amp;jog speed</source>
        <translation>H&amp;öchstwert Tippen</translation>
    </message>
    <message>
        <source>A/D scale, per count</source>
        <translation>A/D-Skala, je Stufe</translation>
    </message>
    <message>
        <source>The value of one A/D count, for example 5 V / 255, or amperes from the amplifier&apos;s current sense.</source>
        <translation>Der Wert einer A/D-Stufe, zum Beispiel 5 V / 255 oder Ampere nach der Strommessung des Verstärkers.</translation>
    </message>
    <message>
        <source>A/D at &amp;0</source>
        <translation>A/D bei &amp;0</translation>
    </message>
    <message>
        <source>Unit of the A/D value</source>
        <translation>Einheit des A/D-Werts</translation>
    </message>
    <message>
        <source>A, V, or whatever the A/D input measures.</source>
        <translation>A, V oder was der A/D-Eingang hier misst.</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>A/D-Einheit</translation>
    </message>
    <message>
        <source>%1 in 1 %2</source>
        <translation>%1 in 1 %2</translation>
    </message>
    <message>
        <source>Calculate…</source>
        <translation>Berechnen…</translation>
    </message>
    <message>
        <source>Calculate the unit from encoder, gear and screw</source>
        <translation>Aus Encoder, Getriebe und Spindel berechnen</translation>
    </message>
    <message>
        <source>Calculates the unit from the data of encoder, gear and screw. Sends nothing.</source>
        <translation>Berechnet die Einheit aus den Daten von Encoder, Getriebe und Spindel. Sendet nichts.</translation>
    </message>
    <message>
        <source>reversed: forward counts down</source>
        <translation>umgekehrt: vorwärts zählt abwärts</translation>
    </message>
    <message>
        <source>Reverses positions, directions and travel limits of this axis on the screen. Sends nothing.</source>
        <translation>Kehrt Positionen, Richtungen und Verfahrgrenzen dieser Achse in der Anzeige um. Sendet nichts.</translation>
    </message>
    <message>
        <source>Axis %1 has the same name, so programs can call neither by it.</source>
        <translation>Achse %1 heißt genauso, deshalb können Programme keine der beiden so ansprechen.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisRow</name>
    <message>
        <source>State of %1</source>
        <translation>Zustand von %1</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position von %1</translation>
    </message>
    <message>
        <source>Hold to move %1 in reverse</source>
        <translation>Tippen: %1 rückwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Hold to move %1 forward</source>
        <translation>Tippen: %1 vorwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Step %1 in reverse</source>
        <translation>Schritt: %1 einen Schritt rückwärts fahren</translation>
    </message>
    <message>
        <source>Step %1 forward</source>
        <translation>Schritt: %1 einen Schritt vorwärts fahren</translation>
    </message>
    <message>
        <source>Home earlier</source>
        <translation>Früher referenzieren</translation>
    </message>
    <message>
        <source>Home %1 one place earlier</source>
        <translation>Früher referenzieren: %1 eine Stelle früher in „Alle referenzieren“</translation>
    </message>
    <message>
        <source>This step is less than one count of this axis, or beyond its range. Choose another step.</source>
        <translation>Dieser Schritt ist kleiner als ein Inkrement dieser Achse oder liegt außerhalb ihres Bereichs. Einen anderen Schritt wählen.</translation>
    </message>
    <message>
        <source>Moves forward by the step above, then holds.</source>
        <translation>Fährt um den Schritt oben vorwärts und hält dort.</translation>
    </message>
    <message>
        <source>Moves in reverse by the step above, then holds.</source>
        <translation>Fährt um den Schritt oben rückwärts und hält dort.</translation>
    </message>
    <message>
        <source>Homing is not set up for this axis. Set it up on its Homing page.</source>
        <translation>Für diese Achse ist keine Referenzfahrt eingerichtet. Auf ihrer Seite Referenzfahrt einrichten.</translation>
    </message>
    <message>
        <source>Home all starts with this axis.</source>
        <translation>„Alle referenzieren“ beginnt mit dieser Achse.</translation>
    </message>
    <message>
        <source>Home all homes this axis as number %1. Click to move it one place earlier. Nothing moves.</source>
        <translation>„Alle referenzieren“ nimmt diese Achse als Nummer %1. Ein Klick verschiebt sie eine Stelle nach vorn. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Home: %1.</source>
        <translation>Referenz: %1.</translation>
    </message>
    <message>
        <source>Home: –</source>
        <translation>Referenz: –</translation>
    </message>
</context>
<context>
    <name>nmc::Banner</name>
    <message>
        <source>Important message</source>
        <translation>Wichtige Meldung</translation>
    </message>
    <message>
        <source>Hides this message here. It stays in the message list.</source>
        <translation>Diese Meldung hier ausblenden. Sie bleibt in der Liste der Meldungen.</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>Diese Meldung ausblenden</translation>
    </message>
    <message>
        <source>Shows the full text and all other messages in the message list.</source>
        <translation>Zeigt den ganzen Text und alle anderen Meldungen in der Liste der Meldungen.</translation>
    </message>
    <message>
        <source>%1 more…</source>
        <translation>%1 weitere…</translation>
    </message>
    <message>
        <source>Read all…</source>
        <translation>Alles lesen…</translation>
    </message>
</context>
<context>
    <name>nmc::Bell</name>
    <message>
        <source>Plays a sound on each fault, and when a search for home, a test, a series of steps or a sequence ends.</source>
        <translation>Spielt einen Ton bei jeder Störung und am Ende einer Referenzfahrt, eines Tests, einer Schrittfolge oder eines Ablaufs.</translation>
    </message>
    <message>
        <source>So&amp;unds</source>
        <translation>&amp;Töne</translation>
    </message>
</context>
<context>
    <name>nmc::BenchTruth</name>
    <message>
        <source>Simulator values of the module</source>
        <translation>Simulatorwerte des Moduls</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Welle</translation>
    </message>
    <message>
        <source>The true position of the shaft since the simulation started.</source>
        <translation>Wo die Welle wirklich steht, seit Beginn der Simulation.</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Positionszähler</translation>
    </message>
    <message>
        <source>The position as the module counts it.</source>
        <translation>Die Position, wie das Modul sie zählt.</translation>
    </message>
    <message>
        <source>True, not calculated.</source>
        <translation>Wahr, nicht berechnet.</translation>
    </message>
    <message>
        <source>Of the shaft.</source>
        <translation>Der Welle.</translation>
    </message>
    <message>
        <source>Step rate</source>
        <translation>Schrittrate</translation>
    </message>
    <message>
        <source>Negative in reverse.</source>
        <translation>Rückwärts negativ.</translation>
    </message>
    <message>
        <source>The sign is the direction.</source>
        <translation>Das Vorzeichen ist die Richtung.</translation>
    </message>
    <message>
        <source>255 is full current.</source>
        <translation>255 ist der volle Strom.</translation>
    </message>
    <message>
        <source>A/D reads</source>
        <translation>A/D liest</translation>
    </message>
    <message>
        <source>Violations</source>
        <translation>Verstöße</translation>
    </message>
    <message>
        <source>Protocol violations that would upset a real module.</source>
        <translation>Protokollverstöße, die ein echtes Modul gestört hätten.</translation>
    </message>
    <message>
        <source>%1 s, module %2: %3, %4</source>
        <translation>%1 s, Modul %2: %3, %4</translation>
    </message>
</context>
<context>
    <name>nmc::BodePlot</name>
    <message>
        <source>No measurement yet. The motor follows sine waves from slow to fast, which shows the response of the loop.</source>
        <translation>Noch keine Messung. Der Motor folgt Sinusschwingungen von langsam bis schnell; das zeigt das Verhalten des Regelkreises.</translation>
    </message>
    <message>
        <source>Magnitude, dB</source>
        <translation>Betrag, dB</translation>
    </message>
    <message>
        <source>Phase, degrees</source>
        <translation>Phase, Grad</translation>
    </message>
    <message>
        <source>T, closed loop</source>
        <translation>T, geschlossen</translation>
    </message>
    <message>
        <source>L, open loop</source>
        <translation>L, offen</translation>
    </message>
    <message>
        <source>T: closed loop, from command to position. L: open loop; its phase above -180° where it crosses 0 dB is the phase margin. Right of the grey line the baud rate is too low to measure. Bars: two standard deviations of T.</source>
        <translation>T: geschlossener Regelkreis, von der Sollposition zur Position. L: offener Regelkreis; seine Phase über -180°, wo L durch 0 dB geht, ist die Phasenreserve. Rechts der grauen Linie ist die Baudrate zum Messen zu niedrig. Balken: zwei Standardabweichungen von T.</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
</context>
<context>
    <name>nmc::ChainDialog</name>
    <message>
        <source>Doctor, groups and baud rate</source>
        <translation>Diagnose, Gruppen und Rate</translation>
    </message>
    <message>
        <source>Doctor</source>
        <translation>Diagnose</translation>
    </message>
</context>
<context>
    <name>nmc::ChainMenu</name>
    <message>
        <source>Chain &amp;doctor…</source>
        <translation>Kettendiagn&amp;ose…</translation>
    </message>
    <message>
        <source>Compares the expected modules with those found, and shows where the chain probably breaks.</source>
        <translation>Vergleicht die erwarteten Module mit den gefundenen und zeigt, wo die Kette wahrscheinlich unterbrochen ist.</translation>
    </message>
    <message>
        <source>&amp;Groups…</source>
        <translation>&amp;Gruppen…</translation>
    </message>
    <message>
        <source>Assigns modules to groups, and starts their loaded moves together.</source>
        <translation>Weist Module Gruppen zu und startet deren geladene Bewegungen gemeinsam.</translation>
    </message>
    <message>
        <source>B&amp;aud rate of the chain…</source>
        <translation>Baud&amp;rate der Kette…</translation>
    </message>
    <message>
        <source>Changes the baud rate of the whole chain.</source>
        <translation>Stellt die ganze Kette auf eine andere Rate um.</translation>
    </message>
    <message>
        <source>Scans the chain again; nothing is reset.</source>
        <translation>Sucht die Kette neu; nichts wird zurückgesetzt.</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost…</source>
        <translation>Netzwerk &amp;neu starten: Positionen und Reglerwerte gehen verloren…</translation>
    </message>
    <message>
        <source>&amp;Let programs in</source>
        <translation>Programme &amp;einlassen</translation>
    </message>
    <message>
        <source>Other programs on this computer may read the chain, and ask to move motors.</source>
        <translation>Andere Programme auf diesem Rechner dürfen die Kette lesen und darum bitten, Motoren zu bewegen.</translation>
    </message>
    <message>
        <source>L&amp;end the line to a program…</source>
        <translation>Leitung an ein &amp;Programm verleihen…</translation>
    </message>
    <message>
        <source>A program has the modules for itself; the panel shows what they report.</source>
        <translation>Ein Programm hat die Module für sich; das Panel zeigt, was sie melden.</translation>
    </message>
    <message>
        <source>&amp;Copy settings to other axes…</source>
        <translation>Einstellungen auf andere A&amp;chsen kopieren…</translation>
    </message>
    <message>
        <source>Copies gains, limits and other settings to axes of the same type. Shows the differences first.</source>
        <translation>Kopiert Reglerwerte, Grenzen und andere Einstellungen auf Achsen gleichen Typs. Zeigt zuerst die Unterschiede.</translation>
    </message>
</context>
<context>
    <name>nmc::ChainModel</name>
    <message>
        <source>PC</source>
        <translation>PC</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1, %2, at address %3 on the wire</source>
        <translation>%1, %2, mit Adresse %3 an der Leitung</translation>
    </message>
    <message>
        <source>%1 · looking for modules…</source>
        <translation>%1 · Module werden gesucht…</translation>
    </message>
    <message>
        <source>%1, address %2, %3, %4</source>
        <translation>%1, Adresse %2, %3, %4</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1, position %2</source>
        <translation>%1, Position %2</translation>
    </message>
</context>
<context>
    <name>nmc::ChainView</name>
    <message>
        <source>Modules in wire order, the farthest from the PC first</source>
        <translation>Module in der Reihenfolge der Leitung, das vom PC entfernteste zuerst</translation>
    </message>
    <message>
        <source>Not connected.

Choose a port above and connect. Without hardware, choose the simulator.</source>
        <translation>Nicht verbunden.

Oben einen Port wählen und verbinden. Ohne Hardware den Simulator wählen.</translation>
    </message>
</context>
<context>
    <name>nmc::ColourChoice</name>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
</context>
<context>
    <name>nmc::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl finden</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Type what to do, for example: go home</source>
        <translation>Eingeben, was zu tun ist, zum Beispiel: Zur Referenz</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>What it does, or why it is unavailable</source>
        <translation>Was er tut oder warum er nicht möglich ist</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>Kein passender Befehl.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Das ist jetzt nicht möglich.</translation>
    </message>
    <message>
        <source>Press Enter to run it.</source>
        <translation>Die Eingabetaste führt ihn aus.</translation>
    </message>
    <message>
        <source>Its module is no longer connected.</source>
        <translation>Sein Modul ist nicht mehr verbunden.</translation>
    </message>
    <message>
        <source>Press Enter to show it on the module&apos;s page. Nothing is sent.</source>
        <translation>Die Eingabetaste zeigt ihn auf der Seite seines Moduls. Es wird nichts gesendet.</translation>
    </message>
</context>
<context>
    <name>nmc::ConnectionBar</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>Connection and stop</source>
        <translation>Verbindung und Stopp</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>The serial port of the modules, or the simulator.</source>
        <translation>Die serielle Schnittstelle, an der die Module hängen, oder der Simulator.</translation>
    </message>
    <message>
        <source>The baud rate for a chain without addresses; a chain that has them keeps its rate.</source>
        <translation>Die Baudrate für eine Kette ohne Adressen; eine, die schon welche hat, behält ihre eigene.</translation>
    </message>
    <message>
        <source>Por&amp;t</source>
        <translation>P&amp;ort</translation>
    </message>
    <message>
        <source>Bd</source>
        <translation>Bd</translation>
    </message>
    <message>
        <source>not listed</source>
        <translation>nicht aufgeführt</translation>
    </message>
    <message>
        <source>no hardware needed</source>
        <translation>keine Hardware nötig</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>Disconnect first.</source>
        <translation>Zuerst trennen.</translation>
    </message>
    <message>
        <source>No port is open.</source>
        <translation>Es ist kein Port offen.</translation>
    </message>
    <message>
        <source>Closes the port.</source>
        <translation>Schließt den Port.</translation>
    </message>
    <message>
        <source>Connect read-&amp;only</source>
        <translation>Nur &amp;lesend verbinden</translation>
    </message>
    <message>
        <source>Other ways to connect</source>
        <translation>Andere Arten zu verbinden</translation>
    </message>
    <message>
        <source>Other ways to connect.</source>
        <translation>Andere Arten zu verbinden.</translation>
    </message>
    <message>
        <source>Opens the port and only reads: only status requests are sent. STOP ALL still works.</source>
        <translation>Öffnet den Port und liest nur: Es werden nur Statusabfragen gesendet. ALLES STOPP wirkt weiterhin.</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>Baud</translation>
    </message>
</context>
<context>
    <name>nmc::ControlLineBox</name>
    <message>
        <source>Control line</source>
        <translation>Steuerzeile</translation>
    </message>
    <message>
        <source>Type an nmcsim command, then press Enter: state, set, power-cycle, break, mend, stats, time, fault. Shortcut: Ctrl+L.</source>
        <translation>Einen nmcsim-Befehl eingeben, dann Eingabetaste: state, set, power-cycle, break, mend, stats, time, fault. Tastenkürzel: Strg+L.</translation>
    </message>
    <message>
        <source>The simulator&apos;s answer</source>
        <translation>Antwort des Simulators</translation>
    </message>
</context>
<context>
    <name>nmc::CopyDialog</name>
    <message>
        <source>Axis to copy from</source>
        <translation>Achse, von der kopiert wird</translation>
    </message>
    <message>
        <source>The axis whose settings are copied.</source>
        <translation>Die Achse, deren Einstellungen kopiert werden.</translation>
    </message>
    <message>
        <source>&amp;Show differences</source>
        <translation>&amp;Unterschiede zeigen</translation>
    </message>
    <message>
        <source>Copy settings to other axes</source>
        <translation>Einstellungen auf andere Achsen kopieren</translation>
    </message>
    <message>
        <source>Axes to copy to</source>
        <translation>Achsen, auf die kopiert wird</translation>
    </message>
    <message>
        <source>Axes with the same type of module and other settings.</source>
        <translation>Achsen mit gleichem Modultyp und anderen Einstellungen.</translation>
    </message>
    <message>
        <source>Settings to copy</source>
        <translation>Zu kopierende Einstellungen</translation>
    </message>
    <message>
        <source>Settings in which at least one of these axes differs.</source>
        <translation>Einstellungen, in denen mindestens eine dieser Achsen abweicht.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>The differences are shown before anything is changed or sent. Numbers are copied in the units of the module: counts or steps.</source>
        <translation>Die Unterschiede werden gezeigt, bevor etwas geändert oder gesendet wird. Zahlen werden in den Einheiten des Moduls kopiert: Inkremente oder Schritte.</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Nach</translation>
    </message>
    <message>
        <source>S&amp;ettings</source>
        <translation>&amp;Einstellungen</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>No other axis with this type of module has other settings.</source>
        <translation>Keine andere Achse mit diesem Modultyp hat andere Einstellungen.</translation>
    </message>
    <message>
        <source>Select the axes to copy to.</source>
        <translation>Zuerst die Zielachsen wählen.</translation>
    </message>
    <message>
        <source>Select the settings to copy.</source>
        <translation>Zuerst die Einstellungen wählen.</translation>
    </message>
    <message>
        <source>These settings are the same already.</source>
        <translation>Diese Einstellungen sind schon gleich.</translation>
    </message>
    <message>
        <source>Shows what would change. Nothing is sent.</source>
        <translation>Zeigt, was sich ändern würde. Nichts wird gesendet.</translation>
    </message>
</context>
<context>
    <name>nmc::CounterBox</name>
    <message>
        <source>Set and restart</source>
        <translation>Setzen, ab 0</translation>
    </message>
    <message>
        <source>Set and restart the timer or counter</source>
        <translation>Setzen, ab 0: Betriebsart von Zeitgeber und Zähler einstellen, ab 0</translation>
    </message>
    <message>
        <source>Latch inputs</source>
        <translation>Eingänge erfassen</translation>
    </message>
    <message>
        <source>Latch inputs and counter at the same time</source>
        <translation>Eingänge erfassen: Eingänge und Zähler gleichzeitig</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Ablegen</translation>
    </message>
    <message>
        <source>Store outputs for later</source>
        <translation>Ausgänge für später ablegen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>Apply the stored outputs</source>
        <translation>Abgelegtes ausgeben</translation>
    </message>
    <message>
        <source>Counter and synchronous I/O</source>
        <translation>Zähler und gleichzeitige Ein- und Ausgabe</translation>
    </message>
    <message>
        <source>Counter source</source>
        <translation>Quelle des Zählers</translation>
    </message>
    <message>
        <source>timer, 5 MHz</source>
        <translation>Zeitgeber, 5 MHz</translation>
    </message>
    <message>
        <source>counter of rising edges on IO10</source>
        <translation>Zähler der steigenden Flanken an IO10</translation>
    </message>
    <message>
        <source>Prescaler</source>
        <translation>Vorteiler</translation>
    </message>
    <message>
        <source>every edge</source>
        <translation>jede Flanke</translation>
    </message>
    <message>
        <source>every 2nd edge</source>
        <translation>jede 2. Flanke</translation>
    </message>
    <message>
        <source>every 4th edge</source>
        <translation>jede 4. Flanke</translation>
    </message>
    <message>
        <source>every 8th edge</source>
        <translation>jede 8. Flanke</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Zählung</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Zählt</translation>
    </message>
    <message>
        <source>Latched values</source>
        <translation>Erfasste Werte</translation>
    </message>
    <message>
        <source>Latched</source>
        <translation>Erfasst</translation>
    </message>
    <message>
        <source>Outputs to store</source>
        <translation>Abzulegende Ausgänge</translation>
    </message>
    <message>
        <source>Add up the outputs: IO1 is 1, IO2 is 2, IO3 is 4, up to IO12, which is 2048.</source>
        <translation>Die Werte der Ausgänge addieren: IO1 ist 1, IO2 ist 2, IO3 ist 4, bis IO12, das 2048 ist.</translation>
    </message>
    <message>
        <source>%1 to store</source>
        <translation>%1 zum Ablegen</translation>
    </message>
    <message>
        <source>Counter source unknown: another program has set it.</source>
        <translation>Zählerquelle unbekannt: Ein anderes Programm hat sie eingestellt.</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>= %1 s</translation>
    </message>
    <message>
        <source>%1 Hz on IO10</source>
        <translation>%1 Hz an IO10</translation>
    </message>
    <message>
        <source>IO12 to IO1: %1, count %2</source>
        <translation>IO12 bis IO1: %1, Zählerstand %2</translation>
    </message>
    <message>
        <source>Sends the settings above. The count restarts at 0.</source>
        <translation>Sendet die Einstellungen oben. Die Zählung beginnt wieder bei 0.</translation>
    </message>
    <message>
        <source>Latches all pins and the count at the same moment, and reads them.</source>
        <translation>Erfasst alle Pins und den Zählerstand im selben Augenblick und liest sie.</translation>
    </message>
    <message>
        <source>Sends these values to the module, which keeps them until you apply them.</source>
        <translation>Sendet diese Werte an das Modul, das sie behält, bis sie ausgegeben werden.</translation>
    </message>
    <message>
        <source>Store outputs first.</source>
        <translation>Zuerst Ausgänge ablegen.</translation>
    </message>
    <message>
        <source>Applies the stored pin levels and PWM values at the same moment.</source>
        <translation>Gibt die abgelegten Pin-Pegel und PWM-Werte im selben Augenblick aus.</translation>
    </message>
    <message>
        <source>stored: %1, PWM %2 and %3</source>
        <translation>abgelegt: %1, PWM %2 und %3</translation>
    </message>
</context>
<context>
    <name>nmc::CounterTable</name>
    <message>
        <source>Counters of the link</source>
        <translation>Zähler der Verbindung</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Since the chain was found</source>
        <translation>Seit die Kette gefunden wurde</translation>
    </message>
    <message>
        <source>sent: commands that asked for an answer</source>
        <translation>gesendet: Befehle, die eine Antwort verlangten</translation>
    </message>
    <message>
        <source>accepted: answers that passed all checks</source>
        <translation>angenommen: Antworten, die alle Prüfungen bestanden</translation>
    </message>
    <message>
        <source>mean round trip, from sending a command to its complete answer</source>
        <translation>mittlere Antwortzeit, vom Senden eines Befehls bis zur vollständigen Antwort</translation>
    </message>
    <message>
        <source>longest round trip</source>
        <translation>längste Antwortzeit</translation>
    </message>
    <message>
        <source>retried: commands that were sent again</source>
        <translation>wiederholt: Befehle, die noch einmal gesendet wurden</translation>
    </message>
    <message>
        <source>timeouts: no answer, or too few bytes</source>
        <translation>Zeitüberschreitungen: keine Antwort oder zu wenige Bytes</translation>
    </message>
    <message>
        <source>refused by the module: the command reached it with a wrong checksum</source>
        <translation>vom Modul abgewiesen: der Befehl erreichte es mit falscher Prüfsumme</translation>
    </message>
    <message>
        <source>wrong checksums: the answer was corrupted in transit</source>
        <translation>falsche Prüfsummen: die Antwort wurde unterwegs verfälscht</translation>
    </message>
    <message>
        <source>surplus bytes: received without a request</source>
        <translation>überzählige Bytes: niemand hatte sie angefordert</translation>
    </message>
    <message>
        <source>of these, stale: late answers, discarded</source>
        <translation>davon veraltet: späte Antworten, verworfen</translation>
    </message>
    <message>
        <source>resyncs: link checked again after errors</source>
        <translation>Neuabgleiche: Verbindung nach Fehlern neu geprüft</translation>
    </message>
    <message>
        <source>rejected by a rule: checksum right, but answer implausible</source>
        <translation>durch eine Regel verworfen: Prüfsumme richtig, aber Antwort unplausibel</translation>
    </message>
    <message>
        <source>  of these: %1</source>
        <translation>  davon: %1</translation>
    </message>
</context>
<context>
    <name>nmc::CursorPanel</name>
    <message>
        <source>Shows or hides the cursor readings.</source>
        <translation>Zeigt oder verbirgt die Cursorwerte.</translation>
    </message>
    <message>
        <source>Between the cursors: %1</source>
        <translation>Zwischen den Cursorn: %1</translation>
    </message>
    <message>
        <source>Spectrum…</source>
        <translation>Spektrum…</translation>
    </message>
    <message>
        <source>Shows at which frequencies a signal oscillates between the cursors.</source>
        <translation>Zeigt, bei welchen Frequenzen ein Signal zwischen den Cursorn schwingt.</translation>
    </message>
    <message>
        <source>XY view…</source>
        <translation>XY-Ansicht…</translation>
    </message>
    <message>
        <source>Shows one signal over another between the cursors.</source>
        <translation>Zeigt ein Signal über einem anderen, zwischen den Cursorn.</translation>
    </message>
</context>
<context>
    <name>nmc::CursorTable</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Spitze-Spitze</translation>
    </message>
    <message>
        <source>Slope, per s</source>
        <translation>Steigung, je s</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source> (%1 Hz)</source>
        <translation> (%1 Hz)</translation>
    </message>
</context>
<context>
    <name>nmc::DetailsBox</name>
    <message>
        <source>The move has ended; in velocity mode the goal velocity is reached.</source>
        <translation>Die Fahrt ist beendet; im Geschwindigkeitsbetrieb ist die Zielgeschwindigkeit erreicht.</translation>
    </message>
    <message>
        <source>The current limit was reached. Stays set until you clear the sticky bits.</source>
        <translation>Die Stromgrenze wurde erreicht. Bleibt gesetzt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>Motor power is present.</source>
        <translation>Die Motorversorgung ist vorhanden.</translation>
    </message>
    <message>
        <source>The position error exceeded its limit, or the servo is off. Stays set until you clear the sticky bits.</source>
        <translation>Der Positionsfehler überschritt seine Grenze, oder der Servo ist aus. Bleibt gesetzt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>The complement of the encoder&apos;s index.</source>
        <translation>Das Komplement des Indexsignals des Encoders.</translation>
    </message>
    <message>
        <source>The 32-bit position has wrapped. Stays set until you clear the sticky bits.</source>
        <translation>Die 32-Bit-Position ist übergelaufen. Bleibt gesetzt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>The servo is on.</source>
        <translation>Der Servo ist ein.</translation>
    </message>
    <message>
        <source>The first acceleration phase of the move has ended.</source>
        <translation>Die erste Beschleunigungsphase der Fahrt ist beendet.</translation>
    </message>
    <message>
        <source>The constant phase of the move has ended.</source>
        <translation>Die Konstantphase der Fahrt ist beendet.</translation>
    </message>
    <message>
        <source>A servo tick took too long; typically not serious. Stays set until you clear the sticky bits.</source>
        <translation>Ein Servotakt hat zu lange gedauert; meist unbedenklich. Bleibt gesetzt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>Clear stic&amp;ky bits</source>
        <translation>Stick&amp;y-Bits löschen</translation>
    </message>
    <message>
        <source>Clear sticky bits of the status</source>
        <translation>Sticky-Bits löschen: Die Sticky-Statusbits löschen</translation>
    </message>
    <message>
        <source>Auxiliary byte</source>
        <translation>Hilfsbyte</translation>
    </message>
    <message>
        <source>A/D (motor current)</source>
        <translation>A/D (Motorstrom)</translation>
    </message>
    <message>
        <source>Velocity reported by the chip</source>
        <translation>Geschwindigkeit laut Chip</translation>
    </message>
    <message>
        <source>, auxiliary %1</source>
        <translation>, Hilfsbyte %1</translation>
    </message>
    <message>
        <source>Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing.</source>
        <translation>Löscht overcurrent, pos_error, pos_wrap und servo_overrun. Startet nichts.</translation>
    </message>
    <message>
        <source>Position error reported by the chip</source>
        <translation>Vom Chip gemeldeter Positionsfehler</translation>
    </message>
    <message>
        <source>Path points left</source>
        <translation>Verbleibende Bahnpunkte</translation>
    </message>
    <message>
        <source>The module is sending step pulses.</source>
        <translation>Schrittimpulse kommen.</translation>
    </message>
    <message>
        <source>The driver is enabled (AMP_EN is high).</source>
        <translation>Der Treiber ist eingeschaltet (AMP_EN ist High).</translation>
    </message>
    <message>
        <source>Motor power is present (PWR_SENSE is high).</source>
        <translation>Die Motorversorgung ist vorhanden (PWR_SENSE ist High).</translation>
    </message>
    <message>
        <source>The motor has reached its commanded speed.</source>
        <translation>Der Motor hat die verlangte Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Runs with a ramp: velocity profile mode.</source>
        <translation>Läuft mit Rampe: Geschwindigkeitsprofil.</translation>
    </message>
    <message>
        <source>Moves to a position with a ramp: trapezoidal profile mode.</source>
        <translation>Fährt mit Rampe zu einer Position: Trapezprofil.</translation>
    </message>
    <message>
        <source>High stops the motor, unless it is ignored.</source>
        <translation>High stoppt den Motor, wenn der Eingang nicht ignoriert wird.</translation>
    </message>
    <message>
        <source>General purpose input.</source>
        <translation>Eingang zur freien Verwendung.</translation>
    </message>
    <message>
        <source>For homing.</source>
        <translation>Für die Referenzfahrt.</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>trapezoidal profile</source>
        <translation>Trapezprofil</translation>
    </message>
    <message>
        <source>velocity profile</source>
        <translation>Geschwindigkeitsprofil</translation>
    </message>
    <message>
        <source>unprofiled, with stop</source>
        <translation>ohne Profil, mit Stopp</translation>
    </message>
    <message>
        <source>unprofiled, without stop</source>
        <translation>ohne Profil, ohne Stopp</translation>
    </message>
    <message>
        <source>moving, commanded by another program</source>
        <translation>bewegt sich nach dem Befehl eines anderen Programms</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>Hie&amp;r nullen</translation>
    </message>
    <message>
        <source>Inputs byte</source>
        <translation>Eingangsbyte</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Timer count</source>
        <translation>Timerwert</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>, inputs %1</source>
        <translation>, Eingänge %1</translation>
    </message>
    <message>
        <source>High blocks counting up, unless it is ignored.</source>
        <translation>High sperrt das Aufwärtszählen, außer wenn ignoriert.</translation>
    </message>
    <message>
        <source>High blocks counting down, unless it is ignored.</source>
        <translation>High sperrt das Abwärtszählen, außer wenn ignoriert.</translation>
    </message>
</context>
<context>
    <name>nmc::DifferencesDialog</name>
    <message>
        <source>&amp;Select all</source>
        <translation>A&amp;lle auswählen</translation>
    </message>
    <message>
        <source>Clear a&amp;ll</source>
        <translation>&amp;Keine auswählen</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>An&amp;wenden</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Here or last sent</source>
        <translation>Hier oder zuletzt gesendet</translation>
    </message>
    <message>
        <source>When applied</source>
        <translation>Beim Anwenden</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alle auswählen</translation>
    </message>
    <message>
        <source>Selects all check boxes, including settings sent to modules that are on.</source>
        <translation>Setzt alle Häkchen, auch bei Einstellungen für eingeschaltete Module.</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>Keine auswählen</translation>
    </message>
    <message>
        <source>Clears all check boxes.</source>
        <translation>Entfernt alle Häkchen.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Keeps everything as it is.</source>
        <translation>Lässt alles, wie es ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; differs from the current settings. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced by those in the file.</source>
        <translation>„%1“ weicht von den jetzigen Einstellungen ab. Bis „Anwenden“ gewählt wird, ändert sich nichts, und es wird nichts gesendet; kein Motor bewegt sich. Eingegebene, nicht gesendete Werte werden durch die der Datei ersetzt.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>Applies the selected settings and sends those marked as sent.</source>
        <translation>Wendet die gewählten Einstellungen an und sendet die als zu senden markierten.</translation>
    </message>
    <message>
        <source>Selected: %1 of %2. Sent to modules: %3.</source>
        <translation>Gewählt: %1 von %2. An Module gesendet: %3.</translation>
    </message>
    <message>
        <source>Differences from the present settings</source>
        <translation>Unterschiede zu den jetzigen Einstellungen</translation>
    </message>
    <message>
        <source>Settings of %1 for other axes. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced.</source>
        <translation>Einstellungen von %1 für andere Achsen. Vor „Anwenden“ wird nichts geändert oder gesendet, und kein Motor bewegt sich. Eingegebene, nicht gesendete Werte werden ersetzt.</translation>
    </message>
    <message>
        <source>Copy settings</source>
        <translation>Einstellungen kopieren</translation>
    </message>
    <message>
        <source>%1: differences</source>
        <translation>%1: Unterschiede</translation>
    </message>
</context>
<context>
    <name>nmc::DirectBox</name>
    <message>
        <source>%1 as set here</source>
        <translation>%1 wie hier eingestellt</translation>
    </message>
    <message>
        <source>What the chip will do</source>
        <translation>Was der Chip tun wird</translation>
    </message>
    <message>
        <source>Command bytes</source>
        <translation>Bytes des Befehls</translation>
    </message>
    <message>
        <source>A bit of %1: %2</source>
        <translation>Ein Bit von %1: %2</translation>
    </message>
    <message>
        <source>Bits of %1: %2</source>
        <translation>Bits von %1: %2</translation>
    </message>
    <message>
        <source>Data of %1: %2</source>
        <translation>Daten von %1: %2</translation>
    </message>
    <message>
        <source>%1: load</source>
        <translation>%1: laden</translation>
    </message>
    <message>
        <source>If cleared, the chip keeps the previously loaded value.</source>
        <translation>Ohne Häkchen behält der Chip den zuvor geladenen Wert.</translation>
    </message>
</context>
<context>
    <name>nmc::DirectionCheckBox</name>
    <message>
        <source>Direction</source>
        <translation>Drehrichtung</translation>
    </message>
    <message>
        <source>Direction check…</source>
        <translation>Richtungsprüfung…</translation>
    </message>
    <message>
        <source>Direction of motor and encoder</source>
        <translation>Drehrichtung von Motor und Encoder</translation>
    </message>
    <message>
        <source>Direction check of motor and encoder</source>
        <translation>Richtungsprüfung: Drehrichtung von Motor und Encoder prüfen</translation>
    </message>
    <message>
        <source>Cancel the direction check</source>
        <translation>Richtungsprüfung abbrechen</translation>
    </message>
    <message>
        <source>Result of the direction check</source>
        <translation>Ergebnis der Richtungsprüfung</translation>
    </message>
    <message>
        <source>A direction check is running.</source>
        <translation>Eine Richtungsprüfung läuft.</translation>
    </message>
    <message>
        <source>Something turns the motor. Wait until it is at rest.</source>
        <translation>Etwas dreht den Motor. Warten, bis er stillsteht.</translation>
    </message>
    <message>
        <source>The motor of %1 will move a little, forward and in reverse. It is driven in pulses of less than 0.1 s, with slowly rising power up to %2 % of its supply, until it has moved %3. A motor that runs freely may coast farther; more than %4 ends the check. Keep clear of it.</source>
        <translation>Der Motor von %1 bewegt sich gleich ein wenig, vorwärts und rückwärts. Er wird mit Impulsen von weniger als 0,1 s angetrieben, mit langsam steigender Leistung bis zu %2 % seiner Versorgung, bis er sich um %3 bewegt hat. Ein frei laufender Motor kann weiter auslaufen; mehr als %4 beendet die Prüfung. Abstand halten.</translation>
    </message>
    <message>
        <source>Direction check</source>
        <translation>Richtungsprüfung</translation>
    </message>
    <message>
        <source>&amp;Pulse motor</source>
        <translation>&amp;Motor anstoßen</translation>
    </message>
    <message>
        <source>Driving it in reverse.</source>
        <translation>Antrieb rückwärts.</translation>
    </message>
    <message>
        <source>Driving it forward.</source>
        <translation>Antrieb vorwärts.</translation>
    </message>
    <message>
        <source>Inconclusive: see the message.</source>
        <translation>Kein Ergebnis: siehe die Meldung.</translation>
    </message>
    <message>
        <source>Not checked in this connection. Run the check before you enable the servo for the first time: with motor or encoder reversed, it runs away.</source>
        <translation>In dieser Verbindung nicht geprüft. Vor dem ersten Einschalten des Servos prüfen: Mit verpoltem Motor oder Encoder geht der Motor durch.</translation>
    </message>
    <message>
        <source>Moves the motor a little, without the servo, to check that it turns the way its encoder counts. Asks first.</source>
        <translation>Bewegt den Motor ein wenig, ohne Servo, um zu sehen, ob er sich so dreht, wie sein Encoder zählt. Fragt vorher.</translation>
    </message>
    <message>
        <source>No direction check is running.</source>
        <translation>Es läuft keine Richtungsprüfung.</translation>
    </message>
    <message>
        <source>Ends the check and switches the motor off.</source>
        <translation>Beendet die Prüfung; der Motor ist dann aus.</translation>
    </message>
</context>
<context>
    <name>nmc::DoctorPage</name>
    <message>
        <source>Chain doctor</source>
        <translation>Kettendiagnose</translation>
    </message>
    <message>
        <source>Modules expected and found, the farthest from the PC first</source>
        <translation>Erwartete und gefundene Module, das vom PC entfernteste zuerst</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Scan again: look for modules</source>
        <translation>Erneut suchen: Kette erneut suchen</translation>
    </message>
    <message>
        <source>Accep&amp;t as found</source>
        <translation>&amp;Wie gefunden übernehmen</translation>
    </message>
    <message>
        <source>Accept as found</source>
        <translation>Wie gefunden übernehmen</translation>
    </message>
    <message>
        <source>&amp;Restart the network…</source>
        <translation>Netzwerk &amp;neu starten…</translation>
    </message>
    <message>
        <source>Restart the network: positions and gains are lost</source>
        <translation>Netzwerk neu starten: Positionen und Reglerwerte gehen verloren</translation>
    </message>
    <message>
        <source>Scans the chain again with status requests only: nothing is reset, nothing moves.</source>
        <translation>Sucht die Kette nur mit Statusabfragen neu: Nichts wird zurückgesetzt, nichts bewegt sich.</translation>
    </message>
    <message>
        <source>The chain already matches.</source>
        <translation>Die Kette stimmt bereits.</translation>
    </message>
    <message>
        <source>From now on, the panel expects the modules found here.</source>
        <translation>Ab jetzt erwartet das Programm die hier gefundenen Module.</translation>
    </message>
</context>
<context>
    <name>nmc::ExpertBox</name>
    <message>
        <source>Capture only</source>
        <translation>Nur erfassen</translation>
    </message>
    <message>
        <source>Stop abruptly</source>
        <translation>Sofort stoppen</translation>
    </message>
    <message>
        <source>Stop smoothly</source>
        <translation>Sanft stoppen</translation>
    </message>
    <message>
        <source>The chip stops watching for home.</source>
        <translation>Der Chip wartet nicht mehr auf die Referenz.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register and stops. Start the motion with a command of your own.</source>
        <translation>Beim ersten dieser Ereignisse speichert der Chip seine Position im Referenzregister und stoppt von selbst. Die Bewegung mit einem eigenen Befehl starten.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register. The motion goes on.</source>
        <translation>Beim ersten dieser Ereignisse speichert der Chip seine Position im Referenzregister. Die Bewegung geht weiter.</translation>
    </message>
    <message>
        <source>Load Trajectory</source>
        <translation>Load Trajectory</translation>
    </message>
    <message>
        <source>Send load</source>
        <translation>Laden senden</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Trapezoidal</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>Position (counts)</source>
        <translation>Position (Inkremente)</translation>
    </message>
    <message>
        <source>Velocity (counts/tick × 65536)</source>
        <translation>Geschwindigkeit (Ink./Takt × 65536)</translation>
    </message>
    <message>
        <source>Acceleration (counts/tick² × 65536)</source>
        <translation>Beschleunigung (Ink./Takt² × 65536)</translation>
    </message>
    <message>
        <source>Reverse (velocity and PWM)</source>
        <translation>Rückwärts (Geschw. und PWM)</translation>
    </message>
    <message>
        <source>Start motion now</source>
        <translation>Bewegung sofort starten</translation>
    </message>
    <message>
        <source>Stop Motor</source>
        <translation>Stop Motor</translation>
    </message>
    <message>
        <source>Send stop</source>
        <translation>Stopp senden</translation>
    </message>
    <message>
        <source>Amplifier only</source>
        <translation>Nur Verstärker</translation>
    </message>
    <message>
        <source>At a position</source>
        <translation>An einer Position</translation>
    </message>
    <message>
        <source>Amplifier enabled</source>
        <translation>Verstärker ein</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. The servo stays as it is.</source>
        <translation>Nur AMP_EN wird geschaltet. Der Servo bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>The servo is switched off. The motor is free to turn.</source>
        <translation>Der Servo wird abgeschaltet. Der Motor ist frei drehbar.</translation>
    </message>
    <message>
        <source>The motor stops at once and holds.</source>
        <translation>Der Motor stoppt sofort und hält.</translation>
    </message>
    <message>
        <source>The servo is switched ON and holds its position.</source>
        <translation>Der Servo wird EINGESCHALTET und hält seine Position.</translation>
    </message>
    <message>
        <source>The motor slows down with the loaded acceleration and holds.</source>
        <translation>Der Motor bremst mit der geladenen Beschleunigung und hält.</translation>
    </message>
    <message>
        <source>The motor goes to this position without a profile, as fast as the gains drive it, and holds there.</source>
        <translation>Der Motor fährt ohne Profil zu dieser Position, so schnell die Reglerwerte es zulassen, und hält dort.</translation>
    </message>
    <message>
        <source>Set Homing Mode</source>
        <translation>Set Homing Mode</translation>
    </message>
    <message>
        <source>Send homing mode</source>
        <translation>Referenzmodus senden</translation>
    </message>
    <message>
        <source>Change of limit 1</source>
        <translation>Wechsel Endsch. 1</translation>
    </message>
    <message>
        <source>Change of limit 2</source>
        <translation>Wechsel Endsch. 2</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>Table 4 of the data sheet has no such mode for the present state of the motor.</source>
        <translation>Tabelle 4 kennt keinen solchen Modus aus dem jetzigen Zustand des Motors.</translation>
    </message>
    <message>
        <source>Position (steps)</source>
        <translation>Position (Schritte)</translation>
    </message>
    <message>
        <source>Acceleration time (0.25 ms)</source>
        <translation>Beschleunigungszeit (0,25 ms)</translation>
    </message>
    <message>
        <source>Initial timer count</source>
        <translation>Anfangs-Timerwert</translation>
    </message>
    <message>
        <source>Nearest integer speed</source>
        <translation>Nächste ganze Geschwindigkeit</translation>
    </message>
    <message>
        <source>Reverse (not trapezoidal)</source>
        <translation>Rückwärts (nicht Trapez)</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. A motion in progress keeps counting.</source>
        <translation>Nur AMP_EN wird geschaltet. Eine Bewegung zählt weiter.</translation>
    </message>
    <message>
        <source>The steps end at once.</source>
        <translation>Die Schritte enden sofort.</translation>
    </message>
    <message>
        <source>The motor slows down with its acceleration time.</source>
        <translation>Der Motor bremst mit seiner Beschleunigungszeit.</translation>
    </message>
    <message>
        <source>Change of the home switch</source>
        <translation>Wechsel am Referenzschalter</translation>
    </message>
    <message>
        <source>Commands as in the data sheet</source>
        <translation>Befehle wie im Datenblatt</translation>
    </message>
    <message>
        <source>Commands as in the data sheet, in native counts. STOP ALL and Esc work as usual.</source>
        <translation>Befehle wie im Datenblatt, in Inkrementen des Chips. ALLES STOPP und Esc wirken wie immer.</translation>
    </message>
    <message>
        <source>%1 Waits for Start Motion; the next load overwrites it.</source>
        <translation>%1 Wartet auf Start Motion; der nächste Ladebefehl überschreibt es.</translation>
    </message>
    <message>
        <source>The servo is off; the PWM value drives the motor. No limit applies.</source>
        <translation>Der Servo ist aus; der PWM-Wert treibt den Motor an. Keine Grenze gilt.</translation>
    </message>
    <message>
        <source>The motor runs until it is stopped.</source>
        <translation>Der Motor läuft bis zum Stopp.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position. Start it only from standstill.</source>
        <translation>Eine Trapezfahrt zur Position. Nur aus dem Stillstand starten.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position.</source>
        <translation>Eine Trapezfahrt zur Position.</translation>
    </message>
    <message>
        <source>A ramp to the speed. The motor runs until it is stopped.</source>
        <translation>Eine Rampe zur Geschwindigkeit. Der Motor läuft bis zum Stopp.</translation>
    </message>
    <message>
        <source>One speed from the first step to the position.</source>
        <translation>Eine einzige Geschwindigkeit vom ersten Schritt bis zur Position.</translation>
    </message>
    <message>
        <source>One speed from the first step. The motor runs until it is stopped.</source>
        <translation>Eine einzige Geschwindigkeit vom ersten Schritt an. Der Motor läuft bis zum Stopp.</translation>
    </message>
    <message>
        <source>The move continues to its position at this speed. If it has just ended, the motor runs until it is stopped.</source>
        <translation>Die Fahrt geht mit dieser Geschwindigkeit bis zu ihrer Position weiter. Ist sie gerade beendet, läuft der Motor bis zum Stopp.</translation>
    </message>
    <message>
        <source>Reset module…</source>
        <translation>Modul zurücksetzen…</translation>
    </message>
    <message>
        <source>Reset module to its power-up state</source>
        <translation>Modul zurücksetzen: Dieses Modul zurücksetzen</translation>
    </message>
    <message>
        <source>Returns this module to its power-up state and assigns its address again. The other modules are unchanged.</source>
        <translation>Setzt dieses Modul in den Einschaltzustand zurück und gibt ihm seine Adresse wieder. Die anderen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Reset module</source>
        <translation>Modul zurücksetzen</translation>
    </message>
    <message>
        <source>Reset %1? Its motor switches off, and it loses its position, settings and group. The other modules are unchanged.</source>
        <translation>%1 zurücksetzen? Sein Motor geht aus, und es verliert Position, Einstellungen und Gruppe. Die anderen Module bleiben unverändert.</translation>
    </message>
    <message>
        <source>Reset the module</source>
        <translation>Modul zurücksetzen</translation>
    </message>
    <message>
        <source>Relative (trapezoidal)</source>
        <translation>Relativ (Trapez)</translation>
    </message>
    <message>
        <source>A trapezoidal move by this many counts, from the command position. Start it only from standstill.</source>
        <translation>Eine Trapezfahrt um so viele Inkremente, von der Sollposition aus. Nur aus dem Stillstand starten.</translation>
    </message>
    <message>
        <source>Advanced features on</source>
        <translation>Erweiterte Funktionen an</translation>
    </message>
    <message>
        <source>Reset Position</source>
        <translation>Reset Position</translation>
    </message>
    <message>
        <source>Send reset position</source>
        <translation>Reset Position senden</translation>
    </message>
    <message>
        <source>To 0</source>
        <translation>Auf 0</translation>
    </message>
    <message>
        <source>Relative to home</source>
        <translation>Relativ zur Referenz</translation>
    </message>
    <message>
        <source>To a value</source>
        <translation>Auf einen Wert</translation>
    </message>
    <message>
        <source>The home register is subtracted from the position. Nothing moves.</source>
        <translation>Das Referenzregister wird von der Position abgezogen. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>The position becomes this value. Nothing moves.</source>
        <translation>Die Position wird dieser Wert. Nichts bewegt sich.</translation>
    </message>
</context>
<context>
    <name>nmc::FirstSteps</name>
    <message>
        <source>Show me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Show me: the next step</source>
        <translation>Zeigen: den nächsten Schritt</translation>
    </message>
    <message>
        <source>Shows the control for the next step. Sends nothing.</source>
        <translation>Zeigt das Bedienelement für den nächsten Schritt. Sendet nichts.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>Fill in gains</source>
        <translation>Reglerwerte eintragen</translation>
    </message>
    <message>
        <source>Apply gains</source>
        <translation>Reglerwerte anwenden</translation>
    </message>
    <message>
        <source>Enable servo</source>
        <translation>Servo einschalten</translation>
    </message>
    <message>
        <source>Take the starting values, or type your own. Nothing is sent yet.</source>
        <translation>Startwerte nehmen oder eigene eingeben. Noch wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Sends the gains to the module. The motor does not move.</source>
        <translation>Sendet die Reglerwerte an das Modul. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>New wiring? Run the direction check on the Axis page first.</source>
        <translation>Neu verdrahtet? Zuerst die Richtungsprüfung auf der Seite Achse ausführen.</translation>
    </message>
    <message>
        <source>The motor moves while you hold the button. Esc stops it from anywhere.</source>
        <translation>Der Motor bewegt sich, solange die Taste gehalten wird. Esc stoppt ihn von überall.</translation>
    </message>
</context>
<context>
    <name>nmc::FrequencyPage</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>The motor swings around its position, slowly at first, then faster. Make sure that everything it drives can move freely.</source>
        <translation>Der Motor schwingt um seine Position, erst langsam, dann schneller. Sicherstellen, dass sich alles, was er antreibt, frei bewegen kann.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>The amplitude</source>
        <translation>Die Amplitude</translation>
    </message>
    <message>
        <source>How far the command swings to either side. The motor is stopped if it swings four times as far.</source>
        <translation>Wie weit die Sollposition nach jeder Seite schwingt. Schwingt der Motor viermal so weit, wird er gestoppt.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>The lowest frequency</source>
        <translation>Die niedrigste Frequenz</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>The highest frequency</source>
        <translation>Die höchste Frequenz</translation>
    </message>
    <message>
        <source>The test ends earlier if the baud rate is too low: at about 40 Hz at 115 200 Bd, and at about 8 Hz at 19 200 Bd.</source>
        <translation>Die Messung endet früher, wenn die Baudrate zu niedrig ist: bei etwa 40 Hz mit 115 200 Bd und bei etwa 8 Hz mit 19 200 Bd.</translation>
    </message>
    <message>
        <source>Results of the frequency response</source>
        <translation>Was der Frequenzgang ergibt</translation>
    </message>
    <message>
        <source>Export CSV of the frequency response</source>
        <translation>CSV exportieren: Frequenzgang exportieren</translation>
    </message>
    <message>
        <source>The baud rate is too low for higher frequencies.</source>
        <translation>Für höhere Frequenzen ist die Baudrate zu niedrig.</translation>
    </message>
    <message>
        <source>No measurement yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
    <message>
        <source>Saves frequency, magnitude and phase of the open and the closed loop.</source>
        <translation>Speichert Frequenz, Betrag und Phase des offenen und des geschlossenen Regelkreises.</translation>
    </message>
    <message>
        <source>Export the frequency response</source>
        <translation>Frequenzgang exportieren</translation>
    </message>
    <message>
        <source>Speed while measuring</source>
        <translation>Geschwindigkeit beim Messen</translation>
    </message>
    <message>
        <source>The speed while measuring</source>
        <translation>Die Geschwindigkeit beim Messen</translation>
    </message>
    <message>
        <source>0: at rest. Otherwise the sines ride on a motion to and fro, forward first, or backwards first if it is negative; the motor never reverses within a sine, so dry friction does not show. It moves away by up to this speed times five periods of the lowest frequency.</source>
        <translation>0: im Stillstand. Sonst liegen die Sinusschwingungen auf einer Hin- und Herbewegung, erst vorwärts, bei negativem Wert erst rückwärts; innerhalb einer Schwingung wechselt der Motor nie die Richtung, sodass trockene Reibung nicht stört. Er entfernt sich bis zu dieser Geschwindigkeit mal fünf Perioden der niedrigsten Frequenz.</translation>
    </message>
    <message>
        <source>What the gains in the fields would do</source>
        <translation>Was die Reglerwerte in den Feldern täten</translation>
    </message>
    <message>
        <source>in motion</source>
        <translation>in Bewegung</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>im Stillstand</translation>
    </message>
    <message>
        <source>Fill in all gains to see what this loop would do with them.</source>
        <translation>Alle Reglerwerte ausfüllen, um zu sehen, was dieser Regelkreis damit täte.</translation>
    </message>
    <message>
        <source>with the gains in the fields</source>
        <translation>mit den Reglerwerten in den Feldern</translation>
    </message>
    <message>
        <source>The last measurement ended early. The one before it is still shown.</source>
        <translation>Die letzte Messung endete vorzeitig. Die davor wird weiter gezeigt.</translation>
    </message>
</context>
<context>
    <name>nmc::GainsBox</name>
    <message>
        <source>&amp;Apply gains</source>
        <translation>A&amp;lle anwenden</translation>
    </message>
    <message>
        <source>Apply gains: all</source>
        <translation>Alle anwenden: Alle Reglerwerte anwenden</translation>
    </message>
    <message>
        <source>Revert the gains to those last sent</source>
        <translation>Reglerwerte auf die gesendeten zurücksetzen</translation>
    </message>
    <message>
        <source>Fills in values to start tuning with. Sends nothing.</source>
        <translation>Füllt die Felder mit Werten, mit denen die Einstellung beginnen kann. Sendet nichts.</translation>
    </message>
    <message>
        <source>Gains cannot be read back from the module. They are unknown until you apply them.</source>
        <translation>Reglerwerte sind aus dem Modul nicht auslesbar. Bis zum Anwenden sind sie unbekannt.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The servo is on: they take effect immediately.</source>
        <translation>Sendet alle Reglerwerte auf einmal. Der Servo ist ein: Sie wirken sofort.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The motor does not move.</source>
        <translation>Sendet alle Reglerwerte auf einmal. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>&amp;Apply live</source>
        <translation>A&amp;lle live anwenden</translation>
    </message>
    <message>
        <source>Restores the gains last sent. Sends nothing.</source>
        <translation>Stellt die zuletzt gesendeten Reglerwerte wieder her. Sendet nichts.</translation>
    </message>
    <message>
        <source>Clears the fields: no gains have been sent yet. Sends nothing.</source>
        <translation>Leert die Felder: Es wurden noch keine Reglerwerte gesendet. Sendet nichts.</translation>
    </message>
    <message>
        <source>Sense of the current limit</source>
        <translation>Wirkungssinn der Stromgrenze</translation>
    </message>
    <message>
        <source>Whether a high or a low A/D value means overcurrent. The chip distinguishes them by odd and even values.</source>
        <translation>Ob ein hoher oder ein niedriger A/D-Wert Überstrom bedeutet. Der Chip unterscheidet das an ungeraden und geraden Zahlen.</translation>
    </message>
    <message>
        <source>Undo the last edit of a gain</source>
        <translation>Die letzte Änderung eines Reglerwerts rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the last undone edit of a gain</source>
        <translation>Die Änderung eines Reglerwerts wiederherstellen</translation>
    </message>
    <message>
        <source>All zero</source>
        <translation>Alle null</translation>
    </message>
    <message>
        <source>All zero: fill in 0 for all gains</source>
        <translation>Alle null: Für alle Reglerwerte null eintragen</translation>
    </message>
    <message>
        <source>Changing SR from %2 to %1 changes the servo tick, and with it the meaning of every velocity and acceleration in counts per tick.</source>
        <translation>SR von %2 auf %1 zu ändern ändert den Servotakt und damit die Bedeutung jeder Geschwindigkeit und Beschleunigung in Inkrementen je Takt.</translation>
    </message>
    <message>
        <source>Gains while the servo is on</source>
        <translation>Reglerwerte bei eingeschaltetem Servo</translation>
    </message>
    <message>
        <source>The servo is on, and the gains in the module are unknown, so this may be a large change. The motor may jump or oscillate.</source>
        <translation>Der Servo ist ein, und die Reglerwerte im Modul sind unbekannt: Das kann eine große Änderung sein. Der Motor kann springen oder schwingen.</translation>
    </message>
    <message>
        <source>The servo is on, and this is a large change: %1. The motor may jump or oscillate.</source>
        <translation>Der Servo ist ein, und das ist eine große Änderung: %1. Der Motor kann springen oder schwingen.</translation>
    </message>
    <message>
        <source>&amp;Apply these gains</source>
        <translation>&amp;Diese Reglerwerte anwenden</translation>
    </message>
    <message>
        <source>Step response…</source>
        <translation>Sprungantwort…</translation>
    </message>
    <message>
        <source>Step response: open</source>
        <translation>Sprungantwort: Die Sprungantwort öffnen</translation>
    </message>
    <message>
        <source>Opens the step response, which shows how the motor follows a small step (F9).</source>
        <translation>Öffnet die Sprungantwort, die zeigt, wie der Motor einem kleinen Sprung folgt (F9).</translation>
    </message>
    <message>
        <source>Fills the fields with 0, to start tuning. Sends nothing. Once applied, the motor no longer holds.</source>
        <translation>Füllt die Felder mit 0, um die Einstellung zu beginnen. Sendet nichts. Nach dem Anwenden hält der Motor nicht mehr.</translation>
    </message>
    <message>
        <source>Try for %1 s</source>
        <translation>%1 s probieren</translation>
    </message>
    <message>
        <source>Try for %1 s: these gains</source>
        <translation>Diese Reglerwerte %1 Sekunden lang probieren</translation>
    </message>
    <message>
        <source>Keep gains</source>
        <translation>Werte behalten</translation>
    </message>
    <message>
        <source>Keep gains: those being tried</source>
        <translation>Werte behalten, die probiert werden</translation>
    </message>
    <message>
        <source>These gains are already being tried.</source>
        <translation>Diese Reglerwerte werden schon probiert.</translation>
    </message>
    <message>
        <source>The module already has these gains.</source>
        <translation>Das Modul hat diese Reglerwerte schon.</translation>
    </message>
    <message>
        <source>Sends these gains and restores the previous ones after %1 s unless you keep them, or at once if the motor starts to oscillate.</source>
        <translation>Sendet diese Reglerwerte und stellt nach %1 s die vorigen wieder her, wenn sie nicht behalten werden, oder sofort, wenn der Motor zu schwingen beginnt.</translation>
    </message>
    <message>
        <source>No gains are being tried.</source>
        <translation>Es werden keine Reglerwerte probiert.</translation>
    </message>
    <message>
        <source>Keeps the gains that are being tried.</source>
        <translation>Die Reglerwerte, die probiert werden, bleiben.</translation>
    </message>
    <message>
        <source>Apply live: all gains</source>
        <translation>Alle live anwenden: Reglerwerte</translation>
    </message>
    <message>
        <source>no current limit</source>
        <translation>keine Stromgrenze</translation>
    </message>
    <message>
        <source>limits above (odd)</source>
        <translation>begrenzt darüber (ungerade)</translation>
    </message>
    <message>
        <source>limits below (even)</source>
        <translation>begrenzt darunter (gerade)</translation>
    </message>
    <message>
        <source>Range: %1 to %2.</source>
        <translation>Bereich: %1 bis %2.</translation>
    </message>
</context>
<context>
    <name>nmc::GenericPanel</name>
    <message>
        <source>Module without controls</source>
        <translation>Modul ohne Bedienelemente</translation>
    </message>
    <message>
        <source>No status yet.</source>
        <translation>Noch kein Status.</translation>
    </message>
    <message>
        <source>Status byte %1</source>
        <translation>Statusbyte %1</translation>
    </message>
    <message>
        <source>, position %1</source>
        <translation>, Position %1</translation>
    </message>
    <message>
        <source>It does not answer. </source>
        <translation>Keine Antwort. </translation>
    </message>
    <message>
        <source>Request status</source>
        <translation>Status abfragen</translation>
    </message>
    <message>
        <source>Sends No Operation, which only requests the status.</source>
        <translation>Sendet No Operation, das nur den Status abfragt.</translation>
    </message>
    <message>
        <source>The panel does not support this type and version (supported: PIC-SERVO v1 to v5 and v10, PIC-STEP v1, PIC-I/O v1), so it only shows the module&apos;s status. STOP ALL might not stop its motor: use the hardware stop.</source>
        <translation>Dieses Programm kennt Typ und Version dieses Moduls nicht (bekannt sind PIC-SERVO v1 bis v5 und v10, PIC-STEP v1, PIC-I/O v1) und zeigt deshalb nur seinen Status. ALLES STOPP hält seinen Motor vielleicht nicht an: Hardware-Stopp benutzen.</translation>
    </message>
</context>
<context>
    <name>nmc::GroupsPage</name>
    <message>
        <source>No modules yet: connect first.</source>
        <translation>Noch keine Module: zuerst verbinden.</translation>
    </message>
    <message>
        <source>Group to command</source>
        <translation>Gruppe für die Befehle</translation>
    </message>
    <message>
        <source>St&amp;art loaded moves</source>
        <translation>Geladene Fahrten s&amp;tarten</translation>
    </message>
    <message>
        <source>Start loaded moves of this group</source>
        <translation>Geladene Fahrten starten: diese Gruppe</translation>
    </message>
    <message>
        <source>Save &amp;home</source>
        <translation>&amp;Referenz speichern</translation>
    </message>
    <message>
        <source>Save home: the present positions of this group</source>
        <translation>Referenz speichern: die jetzigen Positionen dieser Gruppe</translation>
    </message>
    <message>
        <source>Group of module %1</source>
        <translation>Gruppe von Modul %1</translation>
    </message>
    <message>
        <source>The group that this module listens to. Sent at once; nothing moves.</source>
        <translation>Die Gruppe, auf die dieses Modul hört. Wird sofort gesendet; nichts bewegt sich.</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>Leiter</translation>
    </message>
    <message>
        <source>Leader of its group: module %1</source>
        <translation>Leiter seiner Gruppe: Modul %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Choose a group first.</source>
        <translation>Zuerst eine Gruppe wählen.</translation>
    </message>
    <message>
        <source>This module answers for its group. A group has at most one leader.</source>
        <translation>Dieses Modul antwortet für seine Gruppe; eine Gruppe hat höchstens ein Leitmodul.</translation>
    </message>
    <message>
        <source>move loaded</source>
        <translation>Fahrt geladen</translation>
    </message>
    <message>
        <source>No groups yet. Add modules to a group first.</source>
        <translation>Noch keine Gruppen. Zuerst Module in eine Gruppe setzen.</translation>
    </message>
    <message>
        <source>Starts the loaded moves of all members in the same tick. Available once every member has confirmed its load.</source>
        <translation>Startet die geladenen Fahrten aller Mitglieder im selben Takt. Möglich, sobald jedes Mitglied das Laden bestätigt hat.</translation>
    </message>
    <message>
        <source>Saves the present position of each member as home, in the same tick. Nothing moves.</source>
        <translation>Speichert im selben Takt die jetzige Position jedes Mitglieds als Referenz. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Name der Gruppe</translation>
    </message>
    <message>
        <source>The name of this group. Saved with the machine; nothing is sent.</source>
        <translation>Der Name dieser Gruppe. Wird mit der Maschine gespeichert; nichts wird gesendet.</translation>
    </message>
    <message>
        <source>A module listens to one group besides its own address. All members carry out a group command in the same tick; the leader, if any, answers for them, and the panel then checks each member. Status requests go to single modules.</source>
        <translation>Ein Modul hört außer auf seine eigene Adresse auf eine Gruppe. Alle Mitglieder führen einen Gruppenbefehl im selben Takt aus; das Leitmodul, wenn es eines gibt, antwortet für sie, und das Programm prüft dann jedes Mitglied. Statusabfragen gehen an einzelne Module.</translation>
    </message>
    <message>
        <source>The group that the buttons act on.</source>
        <translation>Für welche Gruppe die Schaltflächen gelten.</translation>
    </message>
    <message>
        <source>Stop s&amp;moothly</source>
        <translation>&amp;Sanft stoppen</translation>
    </message>
    <message>
        <source>Stop smoothly: this group</source>
        <translation>Sanft stoppen: diese Gruppe</translation>
    </message>
    <message>
        <source>Stop at &amp;once</source>
        <translation>S&amp;ofort stoppen</translation>
    </message>
    <message>
        <source>Stop at once: this group</source>
        <translation>Sofort stoppen: diese Gruppe</translation>
    </message>
    <message>
        <source>Motors o&amp;ff</source>
        <translation>&amp;Motoren aus</translation>
    </message>
    <message>
        <source>Motors off in this group</source>
        <translation>Motoren aus: diese Gruppe</translation>
    </message>
    <message>
        <source>C&amp;lear sticky bits</source>
        <translation>Sticky-Bits &amp;löschen</translation>
    </message>
    <message>
        <source>Clear sticky bits of this group</source>
        <translation>Sticky-Bits löschen: diese Gruppe</translation>
    </message>
    <message>
        <source>Set &amp;position to 0…</source>
        <translation>&amp;Position auf 0 setzen…</translation>
    </message>
    <message>
        <source>Set position to 0 for this group</source>
        <translation>Position auf 0 setzen: Die Positionen dieser Gruppe auf 0 setzen</translation>
    </message>
    <message>
        <source>Address of module %1</source>
        <translation>Adresse von Modul %1</translation>
    </message>
    <message>
        <source>The address of this module, 1 to 127. Press Enter to send it. Position, gains and group are kept.</source>
        <translation>Die Adresse, auf die dieses Modul antwortet, 1 bis 127. Wird mit der Eingabetaste gesendet; Position, Reglerwerte und Gruppe bleiben.</translation>
    </message>
    <message>
        <source>Makes the present position of each member 0. Asks first.</source>
        <translation>Macht die jetzige Position jedes Mitglieds zu 0. Fragt vorher.</translation>
    </message>
    <message>
        <source>Clears the sticky fault bits of each member. PIC-SERVO only.</source>
        <translation>Löscht die Sticky-Fehlerbits jedes Mitglieds. Nur PIC-SERVO.</translation>
    </message>
    <message>
        <source>Every member that is on slows down and holds. Repeated until all are seen at rest.</source>
        <translation>Jedes eingeschaltete Mitglied bremst ab und hält dann die Position. Wird wiederholt, bis alle im Stillstand gesehen wurden.</translation>
    </message>
    <message>
        <source>Every member that is on stops at once and holds. Repeated until all are seen at rest.</source>
        <translation>Jedes eingeschaltete Mitglied stoppt sofort und hält dann die Position. Wird wiederholt, bis alle im Stillstand gesehen wurden.</translation>
    </message>
    <message>
        <source>Switches every member off: motors coast, and loads may fall. Repeated until all are seen at rest.</source>
        <translation>Schaltet jedes Mitglied aus: Motoren laufen aus, und Lasten können fallen. Wird wiederholt, bis alle im Stillstand gesehen wurden.</translation>
    </message>
    <message>
        <source>The present position of each motor of %1 becomes 0: module %2. Home, limits and taught points then refer to different positions.</source>
        <translation>Die jetzige Position jedes Motors von %1 wird 0: Modul %2. Referenz, Grenzen und geteachte Punkte bezeichnen danach andere Positionen.</translation>
    </message>
    <message>
        <source>Set positions to 0</source>
        <translation>Positionen auf 0 setzen</translation>
    </message>
    <message>
        <source>&amp;Set positions to 0</source>
        <translation>&amp;Positionen auf 0 setzen</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Choose a group first, or none.</source>
        <translation>Seine Gruppe ist unbekannt und würde sich mit der Adresse ändern. Zuerst eine Gruppe wählen oder keine.</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change addresses.</source>
        <translation>Ein Motor ist in Bewegung. Zum Ändern von Adressen alle Motoren stoppen.</translation>
    </message>
    <message>
        <source>Address %1 is used by %2. Nothing was sent.</source>
        <translation>Adresse %1 ist die von %2. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>outputs stored</source>
        <translation>Ausgänge abgelegt</translation>
    </message>
    <message>
        <source>Store its outputs first.</source>
        <translation>Zuerst seine Ausgänge ablegen.</translation>
    </message>
    <message>
        <source>The address</source>
        <translation>Die Adresse</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
</context>
<context>
    <name>nmc::HoldFirstButton</name>
    <message>
        <source>Hold here first</source>
        <translation>Erst hier halten</translation>
    </message>
    <message>
        <source>Holds the motor at its present position (Stop here).</source>
        <translation>Hält den Motor an seiner jetzigen Position (Hier stoppen).</translation>
    </message>
</context>
<context>
    <name>nmc::HomingBox</name>
    <message>
        <source>Home</source>
        <translation>Referenz suchen</translation>
    </message>
    <message>
        <source>Cancel search</source>
        <translation>Suche abbrechen</translation>
    </message>
    <message>
        <source>Home: search for it</source>
        <translation>Referenz suchen: Die Referenz suchen</translation>
    </message>
    <message>
        <source>Cancel search for home</source>
        <translation>Suche abbrechen: die Referenzfahrt</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Fortschritt der Suche</translation>
    </message>
    <message>
        <source>Moves the motor to search for home, as set above.</source>
        <translation>Bewegt den Motor: er sucht die Referenz, wie oben eingestellt.</translation>
    </message>
    <message>
        <source>No search for home is running.</source>
        <translation>Es läuft keine Referenzfahrt.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly, without homing it.</source>
        <translation>Stoppt den Motor sanft; er hat dann keine Referenz.</translation>
    </message>
    <message>
        <source>Done: home was at %1.</source>
        <translation>Erledigt: Die Referenz lag bei %1.</translation>
    </message>
    <message>
        <source>No search yet.</source>
        <translation>Noch keine Suche.</translation>
    </message>
</context>
<context>
    <name>nmc::HomingForm</name>
    <message>
        <source>Search for home</source>
        <translation>Referenz suchen</translation>
    </message>
    <message>
        <source>Home is where this switch changes. If it is active at the start, the motor first backs off in the other direction.</source>
        <translation>Die Referenz liegt dort, wo sich dieser Schalter ändert. Ist er zu Beginn aktiv, fährt der Motor zuerst in die andere Richtung von ihm weg.</translation>
    </message>
    <message>
        <source>Limit 1 (forward)</source>
        <translation>Endschalter 1 (vorwärts)</translation>
    </message>
    <message>
        <source>Limit 2 (reverse)</source>
        <translation>Endschalter 2 (rückwärts)</translation>
    </message>
    <message>
        <source>Home is at</source>
        <translation>Referenz liegt bei</translation>
    </message>
    <message>
        <source>Home is at the encoder&apos;s index, which comes once per turn.</source>
        <translation>Die Referenz liegt am Index des Encoders, der einmal je Umdrehung kommt.</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the position error limit switches the servo off. Sticky bits are cleared first. The servo is switched on again only to continue to the index or to home.</source>
        <translation>Die Referenz liegt an einem festen Anschlag: Der Motor fährt dagegen, bis die Positionsfehlergrenze den Servo abschaltet. Vorher werden die Sticky-Bits gelöscht. Der Servo wird nur zur Weiterfahrt zum Index oder zur Referenz wieder eingeschaltet.</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the current limit is reached. On its own, it takes effect only at full speed; combined with other conditions, from the start, so the starting current must stay below it. Sticky bits are cleared first.</source>
        <translation>Die Referenz liegt an einem festen Anschlag: Der Motor fährt dagegen, bis die Stromgrenze erreicht ist. Allein wirkt sie nur bei voller Geschwindigkeit, mit anderen Bedingungen von Anfang an; der Anfahrstrom muss dann darunter bleiben. Vorher werden die Sticky-Bits gelöscht.</translation>
    </message>
    <message>
        <source>then at the index, going back</source>
        <translation>danach am Index, auf dem Rückweg</translation>
    </message>
    <message>
        <source>The conditions above find the approximate place; a second, slower search finds the index, which is more exact.</source>
        <translation>Die Bedingungen oben finden die ungefähre Stelle; eine zweite, langsamere Suche findet den Index, der genauer ist.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Reverse: search direction</source>
        <translation>Rückwärts suchen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Forward: search direction</source>
        <translation>Vorwärts suchen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Maximum velocity for searching, backing off and going to home.</source>
        <translation>Höchste Geschwindigkeit beim Suchen, Freifahren und Anfahren der Referenz.</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Indexgeschwindigkeit</translation>
    </message>
    <message>
        <source>Velocity of the second search, for the index. Slower is more exact.</source>
        <translation>Wie schnell die zweite Suche nach dem Index ist; langsamer ist genauer.</translation>
    </message>
    <message>
        <source>Also used for smooth stops.</source>
        <translation>Gilt auch für sanfte Stopps.</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>Suchweg</translation>
    </message>
    <message>
        <source>A search, or backing off, stops and fails after this distance.</source>
        <translation>Eine Suche oder ein Freifahren, das so weit gegangen ist, wird gestoppt und ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Time limit of a search</source>
        <translation>Zeitgrenze einer Suche</translation>
    </message>
    <message>
        <source>A search stops and fails after this time.</source>
        <translation>Eine Suche, die so lange gedauert hat, wird gestoppt und ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>%1 of the search for home</source>
        <translation>%1 der Referenzfahrt</translation>
    </message>
    <message>
        <source>Abruptly: stop at home</source>
        <translation>An der Referenz sofort stoppen</translation>
    </message>
    <message>
        <source>Smoothly: stop at home</source>
        <translation>An der Referenz sanft stoppen</translation>
    </message>
    <message>
        <source>Motor off at home</source>
        <translation>An der Referenz den Motor abschalten</translation>
    </message>
    <message>
        <source>Stop there</source>
        <translation>Dort stoppen</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Und dann</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Referenz anfahren</translation>
    </message>
    <message>
        <source>The motor stops past home; this moves it back. If the search has switched the servo or amplifier off, it is switched on again.</source>
        <translation>Der Motor stoppt hinter der Referenz; dies fährt ihn zu ihr zurück. Ein Servo oder Verstärker, den die Suche abgeschaltet hat, wird dafür wieder eingeschaltet.</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>Position auf 0 setzen</translation>
    </message>
    <message>
        <source>The first search already finds the index.</source>
        <translation>Schon die erste Suche findet den Index.</translation>
    </message>
    <message>
        <source>Needs Go to home, because the position at which the motor rests becomes 0.</source>
        <translation>Braucht „Referenz anfahren“: Die Position, an der der Motor steht, wird 0.</translation>
    </message>
    <message>
        <source>The search direction, in which the switch closes.</source>
        <translation>Die Richtung der Suche, in der sich der Schalter schließt.</translation>
    </message>
    <message>
        <source>A position error switches the servo off.</source>
        <translation>Ein Positionsfehler schaltet den Servo von selbst ab.</translation>
    </message>
    <message>
        <source> This chip version does not stop the motor by itself: the panel stops it, a few hundredths of a second later.</source>
        <translation> Diese Version des Chips stoppt den Motor nicht von selbst: Das Programm stoppt ihn einige Hundertstelsekunden später.</translation>
    </message>
    <message>
        <source> The chip stops it by itself.</source>
        <translation> Der Chip stoppt ihn von selbst.</translation>
    </message>
    <message>
        <source>At home the motor stops at once and holds.</source>
        <translation>An der Referenz stoppt der Motor sofort und hält dann die Position.</translation>
    </message>
    <message>
        <source>At home the motor slows down, stops past it and holds.</source>
        <translation>An der Referenz bremst der Motor, stoppt hinter ihr und hält dann die Position.</translation>
    </message>
    <message>
        <source>At home the motor is switched off and is free to turn.</source>
        <translation>An der Referenz wird der Motor abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>Once the motor is at home, its position becomes 0.</source>
        <translation>Sobald der Motor an der Referenz steht, wird seine Position 0.</translation>
    </message>
    <message>
        <source>Limit 1 (reverse)</source>
        <translation>Endschalter 1 (rückwärts)</translation>
    </message>
    <message>
        <source>Limit 2 (forward)</source>
        <translation>Endschalter 2 (vorwärts)</translation>
    </message>
</context>
<context>
    <name>nmc::IoBox</name>
    <message>
        <source>Limits and I/O</source>
        <translation>Endschalter und E/A</translation>
    </message>
    <message>
        <source>The encoder&apos;s index pulse, once per turn with most encoders.</source>
        <translation>Der Indexpuls des Encoders, bei den meisten Encodern einmal je Umdrehung.</translation>
    </message>
    <message>
        <source>Without motor power the servo switches off, and stays off when power returns.</source>
        <translation>Ohne Motorversorgung schaltet sich der Servo ab und bleibt aus, wenn sie wiederkehrt.</translation>
    </message>
    <message>
        <source>The A/D input; with most amplifiers, the motor current. Set its scale on the Axis page.</source>
        <translation>Der A/D-Eingang, bei den meisten Verstärkern der Motorstrom. Seine Skala wird auf der Seite Achse eingestellt.</translation>
    </message>
    <message>
        <source>Amplifier enabled (&amp;AMP_EN)</source>
        <translation>Ve&amp;rstärker ein (AMP_EN)</translation>
    </message>
    <message>
        <source>On this chip, a limit switch alone does not stop the motor. Arm a limit stop on the Homing page.</source>
        <translation>Ein Endschalter allein stoppt den Motor bei diesem Chip nicht. Auf der Seite Referenzfahrt einen Endschalter-Stopp scharf schalten.</translation>
    </message>
    <message>
        <source>Limit &amp;1</source>
        <translation>Endschalter &amp;1</translation>
    </message>
    <message>
        <source>Limit &amp;2</source>
        <translation>Endschalter &amp;2</translation>
    </message>
    <message>
        <source>Limit %1: input or output</source>
        <translation>Endschalter %1: Eingang oder Ausgang</translation>
    </message>
    <message>
        <source>output, low</source>
        <translation>Ausgang, Low</translation>
    </message>
    <message>
        <source>output, high</source>
        <translation>Ausgang, High</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Nothing is sent until all are chosen.</source>
        <translation>Ein anderes Programm hat dieses Modul eingerichtet, die Richtungen der Pins sind daher unbekannt. Gesendet wird erst, wenn alle gewählt sind.</translation>
    </message>
    <message>
        <source>Makes the pin an input, or an output with this level. Sent at once.</source>
        <translation>Macht den Pin zu einem Eingang oder zu einem Ausgang mit diesem Pegel. Wird sofort gesendet.</translation>
    </message>
    <message>
        <source>at the index</source>
        <translation>am Index</translation>
    </message>
    <message>
        <source>not at the index</source>
        <translation>nicht am Index</translation>
    </message>
    <message>
        <source>present</source>
        <translation>vorhanden</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Switches only the amplifier&apos;s enable line; the servo stays as it is. When off, the motor gets no current, whatever the servo does.</source>
        <translation>Schaltet nur die Freigabeleitung des Verstärkers; der Servo bleibt, wie er ist. Ist sie aus, bekommt der Motor keinen Strom, was auch immer der Servo tut.</translation>
    </message>
    <message>
        <source>The Amplifier page sets what the module does when a limit closes.</source>
        <translation>Was das Modul tut, wenn ein Endschalter schließt, steht auf der Seite Verstärker.</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz. Sent at once.</source>
        <translation>Bahnpunkte mit 60 und 120 Hz statt mit 30 und 60 Hz. Wird sofort gesendet.</translation>
    </message>
</context>
<context>
    <name>nmc::IoHead</name>
    <message>
        <source>Name of this module</source>
        <translation>Name dieses Moduls</translation>
    </message>
    <message>
        <source>Last answer: %1.</source>
        <translation>Letzte Antwort: %1.</translation>
    </message>
</context>
<context>
    <name>nmc::IoPanel</name>
    <message>
        <source>I/O module</source>
        <translation>E/A-Modul</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Zähler</translation>
    </message>
</context>
<context>
    <name>nmc::IoValuesBox</name>
    <message>
        <source>Reads</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Per count</source>
        <translation>Je Stufe</translation>
    </message>
    <message>
        <source>At 0</source>
        <translation>Bei 0</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>Wert von %1</translation>
    </message>
    <message>
        <source>%1 per count</source>
        <translation>%1 je Zähler</translation>
    </message>
    <message>
        <source>The value of one A/D count.</source>
        <translation>Der Wert einer A/D-Stufe.</translation>
    </message>
    <message>
        <source>The unit of the value.</source>
        <translation>Die Einheit des Werts.</translation>
    </message>
    <message>
        <source>%1 at 0</source>
        <translation>%1 bei 0</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Einheit von %1</translation>
    </message>
    <message>
        <source>PWM output</source>
        <translation>PWM-Ausgang</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>0 to 255</source>
        <translation>0 bis 255</translation>
    </message>
    <message>
        <source>Last value sent to %1</source>
        <translation>Letzter an %1 gesendeter Wert</translation>
    </message>
    <message>
        <source>255 is always on. Press Enter to send.</source>
        <translation>255 ist ständig an. Die Eingabetaste sendet es.</translation>
    </message>
    <message>
        <source>Switch %1 off on STOP ALL</source>
        <translation>ALLES STOPP schaltet %1 aus</translation>
    </message>
    <message>
        <source>STOP ALL switches this output off. If cleared, the output stays as it is.</source>
        <translation>ALLES STOPP schaltet diesen Ausgang aus. Ohne Haken bleibt er, wie er ist.</translation>
    </message>
    <message>
        <source>The PWM values are unknown. Enter one for each output: both are sent together.</source>
        <translation>Die PWM-Werte sind unbekannt. Für jeden Ausgang einen eingeben: beide werden zusammen gesendet.</translation>
    </message>
</context>
<context>
    <name>nmc::JogBox</name>
    <message>
        <source>Jog speed</source>
        <translation>Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>Hold to move in reverse</source>
        <translation>Tippen: Rückwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Hold to move forward</source>
        <translation>Tippen: Vorwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it. Returns to a low value at each connection; set the max jog speed on the Axis page.</source>
        <translation>Wie schnell sich der Motor dreht, solange eine Taste oder auf ihr die Leertaste gedrückt ist. Nach jedem Verbinden wieder niedrig; die max. Tippgeschwindigkeit wird auf der Seite Achse eingestellt.</translation>
    </message>
    <message>
        <source>J&amp;og speed</source>
        <translation>Tippgesch&amp;windigkeit</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it: %1 to %2. Set the max jog speed on the Parameters page.</source>
        <translation>Wie schnell sich der Motor dreht, solange eine Taste oder auf ihr die Leertaste gedrückt ist: %1 bis %2. Die max. Tippgeschwindigkeit wird auf der Seite Parameter eingestellt.</translation>
    </message>
</context>
<context>
    <name>nmc::Layouts</name>
    <message>
        <source>&amp;Operate</source>
        <translation>&amp;Bedienen</translation>
    </message>
    <message>
        <source>Motion in the middle, everything else around it.</source>
        <translation>Bewegungen in der Mitte, alles andere darum herum.</translation>
    </message>
    <message>
        <source>&amp;Tune</source>
        <translation>&amp;Einstellen</translation>
    </message>
    <message>
        <source>Large plots, with gains and step response beside them.</source>
        <translation>Große Kurven, daneben Reglerwerte und Sprungantwort.</translation>
    </message>
    <message>
        <source>&amp;Chain</source>
        <translation>&amp;Kette</translation>
    </message>
    <message>
        <source>Modules, packets and messages.</source>
        <translation>Module, Pakete und Meldungen.</translation>
    </message>
</context>
<context>
    <name>nmc::LendDialog</name>
    <message>
        <source>Path of the terminal</source>
        <translation>Pfad des Terminals</translation>
    </message>
    <message>
        <source>&amp;Lend the line</source>
        <translation>Leitung ver&amp;leihen</translation>
    </message>
    <message>
        <source>Lend the line to a program</source>
        <translation>Leitung an ein Programm verleihen</translation>
    </message>
    <message>
        <source>The program opens this path in place of the serial port, and has the modules for itself. The panel shows and records what they report, and sends nothing: your travel limits, stops at limits and other checks do not protect the motors. STOP ALL works, and holds the program off.</source>
        <translation>Das Programm öffnet diesen Pfad anstelle der seriellen Schnittstelle und hat die Module für sich. Hier wird gezeigt und aufgezeichnet, was sie melden, und nichts gesendet: Verfahrgrenzen, Stopps an Grenzen und andere Prüfungen schützen die Motoren nicht. ALLES STOPP wirkt und hält das Programm auf.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Path of the terminal</source>
        <translation>&amp;Pfad des Terminals</translation>
    </message>
    <message>
        <source>A motor is moving. Stop it first.</source>
        <translation>Ein Motor bewegt sich. Stoppen Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>Enter a path.</source>
        <translation>Einen Pfad eingeben.</translation>
    </message>
    <message>
        <source>Creates the terminal. Nothing moves.</source>
        <translation>Legt das Terminal an. Nichts bewegt sich.</translation>
    </message>
</context>
<context>
    <name>nmc::LimitStopBox</name>
    <message>
        <source>Arm limit stop</source>
        <translation>Stopp scharf schalten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
    <message>
        <source>Limit 1: stop there</source>
        <translation>Endschalter 1: Bei Endschalter 1 stoppen</translation>
    </message>
    <message>
        <source>Limit 2: stop there</source>
        <translation>Endschalter 2: Bei Endschalter 2 stoppen</translation>
    </message>
    <message>
        <source>Disarm limit stop</source>
        <translation>Entschärfen: Den Endschalter-Stopp entschärfen</translation>
    </message>
    <message>
        <source>State of the limit stop</source>
        <translation>Zustand des Endschalter-Stopps</translation>
    </message>
    <message>
        <source>Abruptly: stop at the limit</source>
        <translation>Am Endschalter sofort stoppen</translation>
    </message>
    <message>
        <source>Smoothly: stop at the limit</source>
        <translation>Am Endschalter sanft stoppen</translation>
    </message>
    <message>
        <source>Motor off at the limit</source>
        <translation>Am Endschalter den Motor abschalten</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Stoppen bei</translation>
    </message>
    <message>
        <source>Select a limit switch first.</source>
        <translation>Zuerst einen Endschalter wählen.</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 1 changes.</source>
        <translation>Der Motor stoppt, wenn sich Endschalter 1 ändert.</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 2 changes.</source>
        <translation>Der Motor stoppt, wenn sich Endschalter 2 ändert.</translation>
    </message>
    <message>
        <source>At the limit the motor stops at once and holds.</source>
        <translation>Am Endschalter stoppt der Motor sofort und hält dann die Position.</translation>
    </message>
    <message>
        <source>At the limit the motor slows down, stops past it and holds.</source>
        <translation>Am Endschalter bremst der Motor, stoppt hinter ihm und hält dann die Position.</translation>
    </message>
    <message>
        <source>At the limit the motor is switched off and is free to turn.</source>
        <translation>Am Endschalter wird der Motor abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The chip itself then stops the motor once when a selected limit switch changes, faster than the panel could. A search for home replaces it.</source>
        <translation>Der Chip selbst stoppt den Motor dann einmal, wenn sich ein gewählter Endschalter ändert, schneller als das Programm es könnte. Eine Referenzfahrt ersetzt dies.</translation>
    </message>
    <message>
        <source>The limit stop is not armed.</source>
        <translation>Der Endschalter-Stopp ist nicht scharf.</translation>
    </message>
    <message>
        <source>A limit switch no longer stops the motor.</source>
        <translation>Ein Endschalter stoppt den Motor nicht mehr.</translation>
    </message>
    <message>
        <source>○ Not armed: a limit switch alone does not stop the motor.</source>
        <translation>○ Nicht scharf: Ein Endschalter allein stoppt den Motor nicht.</translation>
    </message>
    <message>
        <source>○ This chip version cannot stop at a limit switch.</source>
        <translation>○ Diese Version des Chips kann nicht von selbst an einem Endschalter stoppen.</translation>
    </message>
    <message>
        <source>● Armed: stops at %1, once.</source>
        <translation>● Scharf: stoppt an %1, einmal.</translation>
    </message>
    <message>
        <source>▲ Tripped by %1; the motor was stopped. No longer armed.</source>
        <translation>▲ Ausgelöst durch %1; der Motor wurde gestoppt. Nicht mehr scharf.</translation>
    </message>
    <message>
        <source>? The chip watches for an event that this connection did not request.</source>
        <translation>? Der Chip überwacht etwas, das in dieser Verbindung nicht angefordert wurde.</translation>
    </message>
    <message>
        <source>the position error limit</source>
        <translation>Positionsfehlergrenze</translation>
    </message>
    <message>
        <source>the current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>for each motion of this axis</source>
        <translation>für jede Bewegung dieser Achse</translation>
    </message>
    <message>
        <source>Position error stops the motor</source>
        <translation>Positionsfehler stoppt den Motor</translation>
    </message>
    <message>
        <source>Current stops the motor</source>
        <translation>Strom stoppt den Motor</translation>
    </message>
    <message>
        <source>For each motion of this axis, arm the limit stop</source>
        <translation>für jede Bewegung dieser Achse: Den Endschalter-Stopp für jede Bewegung dieser Achse scharf schalten</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>The motor stops when the position error exceeds EL; this always switches the servo off.</source>
        <translation>Der Motor stoppt, wenn der Positionsfehler EL überschreitet; das schaltet den Servo immer ab.</translation>
    </message>
    <message>
        <source>The motor stops when its current exceeds CL.</source>
        <translation>Der Motor stoppt, wenn sein Strom CL überschreitet.</translation>
    </message>
    <message>
        <source>The panel arms the limit stop whenever the motor is at rest with its servo on, even after a trip, and before any motion starts. Saved with the machine.</source>
        <translation>Das Programm schaltet den Endschalter-Stopp scharf, sobald der Motor mit eingeschaltetem Servo steht, auch nach dem Auslösen, und bevor eine Bewegung beginnt. Wird mit der Maschine gespeichert.</translation>
    </message>
    <message>
        <source>The limit stop is armed for each motion. Clear that check box first.</source>
        <translation>Der Endschalter-Stopp wird für jede Bewegung scharf geschaltet. Zuerst dieses Häkchen entfernen.</translation>
    </message>
    <message>
        <source>A search for home or a measurement is running and uses the same function of the chip.</source>
        <translation>Eine Referenzfahrt oder eine Messung läuft und benutzt dieselbe Funktion des Chips.</translation>
    </message>
    <message>
        <source>○ Not armed: the search for home or the measurement has replaced it.</source>
        <translation>○ Nicht scharf: Die Referenzfahrt oder die Messung hat ihn ersetzt.</translation>
    </message>
</context>
<context>
    <name>nmc::LinkBar</name>
    <message>
        <source>State of the link</source>
        <translation>Zustand der Verbindung</translation>
    </message>
    <message>
        <source>Exchanges per second, and their share of the line&apos;s capacity.</source>
        <translation>Übertragungen pro Sekunde und ihr Anteil an der Kapazität der Leitung.</translation>
    </message>
    <message>
        <source>Failed exchanges: no answer, garbled, or refused for a bad checksum.</source>
        <translation>Fehlgeschlagene Übertragungen: keine Antwort, gestört oder wegen falscher Prüfsumme abgewiesen.</translation>
    </message>
    <message>
        <source>Mean time from sending a command to its complete answer.</source>
        <translation>Mittlere Zeit vom Senden eines Befehls bis zur vollständigen Antwort.</translation>
    </message>
    <message>
        <source>– exchanges/s</source>
        <translation>– Übertragungen/s</translation>
    </message>
    <message>
        <source>– errors</source>
        <translation>– Fehler</translation>
    </message>
    <message>
        <source>round trip –</source>
        <translation>Antwortzeit –</translation>
    </message>
    <message>
        <source>%1 exchanges/s, %2 % bus load</source>
        <translation>%1 Übertragungen/s, %2 % Buslast</translation>
    </message>
    <message numerus="yes">
        <source>%1 errors, %2/s</source>
        <translation>
            <numerusform>%1 Fehler, %2/s</numerusform>
            <numerusform>%1 Fehler, %2/s</numerusform>
        </translation>
    </message>
    <message>
        <source>round trip %1 ms</source>
        <translation>Antwortzeit %1 ms</translation>
    </message>
</context>
<context>
    <name>nmc::LoopTestsDock</name>
    <message>
        <source>Square wave, frequency response (Bode plot), and a report of the tuning</source>
        <translation>Rechteck, Frequenzgang (Bode-Diagramm) und ein Bericht über die Einstellung</translation>
    </message>
    <message>
        <source>Loop tests</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Report: save the tuning</source>
        <translation>Bericht über die Einstellung speichern</translation>
    </message>
    <message>
        <source>Select a PIC-SERVO first.</source>
        <translation>Zuerst einen PIC-SERVO wählen.</translation>
    </message>
    <message>
        <source>Saves one page as PDF or HTML: gains, last step response, motor model and frequency response.</source>
        <translation>Speichert eine Seite als PDF oder HTML: Reglerwerte, letzte Sprungantwort, Motormodell und Frequenzgang.</translation>
    </message>
</context>
<context>
    <name>nmc::MachineMenu</name>
    <message>
        <source>&amp;New machine</source>
        <translation>&amp;Neue Maschine</translation>
    </message>
    <message>
        <source>Discards names, units and settings of all axes; nothing is sent.</source>
        <translation>Verwirft Namen, Einheiten und Einstellungen aller Achsen; es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>&amp;Open machine…</source>
        <translation>Maschine ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Shows what a machine file would change. Nothing is sent until you apply it.</source>
        <translation>Zeigt, was eine Maschinendatei ändern würde; vor dem Anwenden wird nichts gesendet.</translation>
    </message>
    <message>
        <source>&amp;Save machine</source>
        <translation>Maschine &amp;speichern</translation>
    </message>
    <message>
        <source>Saves names, units, gains, limits, homing and groups to the machine file.</source>
        <translation>Speichert Namen, Einheiten, Reglerwerte, Grenzen, Referenzfahrt und Gruppen in der Maschinendatei.</translation>
    </message>
    <message>
        <source>Save machine &amp;as…</source>
        <translation>Maschine speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Saves the machine under another file name.</source>
        <translation>Schreibt die Maschine in eine Datei mit anderem Namen.</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>new machine</source>
        <translation>neue Maschine</translation>
    </message>
    <message>
        <source>Machine files (*.%1)</source>
        <translation>Maschinendateien (*.%1)</translation>
    </message>
    <message>
        <source>Save machine</source>
        <translation>Maschine speichern</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>&amp;Save and close</source>
        <translation>&amp;Speichern und schließen</translation>
    </message>
    <message>
        <source>&amp;Close: the changes can be restored at the next start</source>
        <translation>S&amp;chließen: der nächste Start bietet sie wieder an</translation>
    </message>
    <message>
        <source>&amp;Save changes</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard: the changes are lost</source>
        <translation>&amp;Verwerfen: die Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>%1 (being saved)</source>
        <translation>%1 (wird gespeichert)</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>nmc::MainWindow</name>
    <message>
        <source>NMC Panel</source>
        <translation>NMC Panel</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menüs</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>NMC Panel - Simulator</source>
        <translation>NMC Panel - Simulator</translation>
    </message>
    <message>
        <source>NMC Panel - %1</source>
        <translation>NMC Panel - %1</translation>
    </message>
    <message>
        <source>&amp;Stop and disconnect</source>
        <translation>&amp;Stoppen und trennen</translation>
    </message>
    <message>
        <source>&amp;Stop and close</source>
        <translation>&amp;Stoppen und schließen</translation>
    </message>
    <message>
        <source>Motors are moving</source>
        <translation>Motoren in Bewegung</translation>
    </message>
    <message>
        <source>Restart the network</source>
        <translation>Netzwerk neu starten</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost</source>
        <translation>Netzwerk &amp;neu starten: Positionen und Reglerwerte gehen verloren</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (nur lesend)</translation>
    </message>
    <message>
        <source>No module can be moved. Connect a motor module first.</source>
        <translation>Kein Modul lässt sich bewegen. Zuerst ein Motormodul verbinden.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Let the program &quot;%1&quot; move motors? Esc, STOP ALL or any command of yours ends that.</source>
        <translation>Das Programm „%1“ Motoren bewegen lassen? Esc, ALLES STOPP oder ein eigener Befehl beendet das.</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>Let it move motors</source>
        <translation>Motoren bewegen lassen</translation>
    </message>
</context>
<context>
    <name>nmc::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>NMC Panel - Manual</source>
        <translation>NMC Panel - Handbuch</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Goes back to the previous page (%1).</source>
        <translation>Geht zurück zur vorigen Seite (%1).</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Goes forward again (%1).</source>
        <translation>Geht wieder vorwärts (%1).</translation>
    </message>
    <message>
        <source>Search this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>Enter finds the next match, Shift+Enter the previous one (Ctrl+F).</source>
        <translation>Die Eingabetaste findet den nächsten Treffer, Umschalt+Eingabe den vorigen (Strg+F).</translation>
    </message>
    <message>
        <source>The manual is not installed. It belongs in %1.</source>
        <translation>Das Handbuch ist nicht installiert. Es gehört nach %1.</translation>
    </message>
    <message>
        <source>Not found on this page</source>
        <translation>Auf dieser Seite nicht gefunden</translation>
    </message>
</context>
<context>
    <name>nmc::MessageList</name>
    <message>
        <source>No messages. Problems are listed here, with the time when they ended.</source>
        <translation>Keine Meldungen. Probleme erscheinen hier, auch wenn sie enden.</translation>
    </message>
    <message>
        <source>No message matches the filter above.</source>
        <translation>Keine Meldung passt zum Filter oben.</translation>
    </message>
</context>
<context>
    <name>nmc::MessagePanel</name>
    <message>
        <source>Messages and their filter</source>
        <translation>Meldungen und ihr Filter</translation>
    </message>
    <message>
        <source>Kind of messages shown</source>
        <translation>Art der gezeigten Meldungen</translation>
    </message>
    <message>
        <source>Filters the messages by kind.</source>
        <translation>Welche Art von Meldungen gezeigt wird.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Module whose messages are shown</source>
        <translation>Modul, dessen Meldungen gezeigt werden</translation>
    </message>
    <message>
        <source>Filters the messages by module.</source>
        <translation>Von welchem Modul Meldungen gezeigt werden.</translation>
    </message>
    <message>
        <source>Active only</source>
        <translation>Nur aktive</translation>
    </message>
    <message>
        <source>Shows only messages whose cause persists.</source>
        <translation>Zeigt nur Meldungen, deren Ursache andauert.</translation>
    </message>
    <message>
        <source>Search messages</source>
        <translation>Meldungen durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Shows only messages that contain these words.</source>
        <translation>Zeigt nur Meldungen mit diesen Wörtern.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Export the messages shown</source>
        <translation>Die gezeigten Meldungen exportieren</translation>
    </message>
    <message>
        <source>Saves the messages shown to a text file.</source>
        <translation>Schreibt die gezeigten Meldungen in eine Textdatei.</translation>
    </message>
    <message>
        <source>Kept for this session only.</source>
        <translation>Nur für diese Sitzung aufbewahrt.</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Aufbewahrt in %1</translation>
    </message>
    <message>
        <source>Export messages</source>
        <translation>Meldungen exportieren</translation>
    </message>
</context>
<context>
    <name>nmc::MessageRow</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n-mal</numerusform>
            <numerusform>%n-mal</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::ModelBox</name>
    <message>
        <source>Motor model</source>
        <translation>Motormodell</translation>
    </message>
    <message>
        <source>Find motor model</source>
        <translation>Motormodell bestimmen</translation>
    </message>
    <message>
        <source>Find motor model from the steps</source>
        <translation>Motormodell bestimmen aus den Sprüngen</translation>
    </message>
    <message>
        <source>Motor model found</source>
        <translation>Der bestimmte Motor</translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation>Eintragen</translation>
    </message>
    <message>
        <source>Fill in the suggested gains</source>
        <translation>Eintragen der vorgeschlagenen Reglerwerte in die Felder</translation>
    </message>
    <message>
        <source>Suggested gains</source>
        <translation>Vorgeschlagene Reglerwerte</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Steif</translation>
    </message>
    <message>
        <source>How fast the motor follows. Far right: as fast as noise, output limit and stability permit.</source>
        <translation>Wie schnell der Motor folgt. Ganz rechts: so schnell, wie Rauschen, Ausgangsgrenze und Stabilität erlauben.</translation>
    </message>
    <message>
        <source>Damped</source>
        <translation>Gedämpft</translation>
    </message>
    <message>
        <source>Damping. Far right: no overshoot.</source>
        <translation>Dämpfung. Ganz rechts: kein Überschwingen.</translation>
    </message>
    <message>
        <source>Loud</source>
        <translation>Laut</translation>
    </message>
    <message>
        <source>How much encoder noise may drive the motor through Kd.</source>
        <translation>Wie stark das Encoderrauschen über Kd auf den Motor wirken darf.</translation>
    </message>
    <message>
        <source>The motor model is being calculated.</source>
        <translation>Das Motormodell wird berechnet.</translation>
    </message>
    <message>
        <source>Record a step with this module first.</source>
        <translation>Zuerst mit diesem Modul einen Sprung aufzeichnen.</translation>
    </message>
    <message>
        <source>Calculates the motor model from up to %1 recent steps of this module. Sends nothing.</source>
        <translation>Berechnet das Motormodell aus den letzten Sprüngen dieses Moduls, höchstens %1. Sendet nichts.</translation>
    </message>
    <message>
        <source>No suggested gains. Find the motor model first.</source>
        <translation>Keine Vorschläge. Zuerst das Motormodell bestimmen.</translation>
    </message>
    <message>
        <source>Copies the suggested gains to the Gains page. Sends nothing.</source>
        <translation>Trägt die vorgeschlagenen Werte in die Felder der Seite Reglerwerte ein. Sendet nichts.</translation>
    </message>
    <message>
        <source>Calculating the motor model…</source>
        <translation>Motor wird bestimmt…</translation>
    </message>
    <message>
        <source>The run behind this model was removed. Find the motor model again.</source>
        <translation>Der Lauf zu diesem Modell wurde entfernt. Das Motormodell neu bestimmen.</translation>
    </message>
    <message>
        <source>No gains keep this motor stable and quiet.</source>
        <translation>Mit keinen Reglerwerten ist dieser Motor stabil und ruhig.</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>The phase margin</source>
        <translation>Die Phasenreserve</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the suggested loop is from oscillating, at least. 30°: fast, rings. 45° to 60°: moderate.</source>
        <translation>Wie weit der vorgeschlagene Regelkreis mindestens vom Schwingen entfernt ist. 30°: schnell, schwingt nach. 45° bis 60°: gemäßigt.</translation>
    </message>
    <message>
        <source>° at least</source>
        <translation>° mindestens</translation>
    </message>
    <message>
        <source>Step once more and find model</source>
        <translation>Noch 1 Sprung, dann bestimmen</translation>
    </message>
    <message>
        <source>Step %1 times and find model</source>
        <translation>%1 Sprünge, dann bestimmen</translation>
    </message>
    <message>
        <source>The motor jumps once more, as far as before; the model is then found from the recent steps. Make sure that everything it drives can move freely.</source>
        <translation>Der Motor springt noch einmal, so weit wie zuvor, und wird aus den letzten Sprüngen bestimmt. Sicherstellen, dass sich alles, was er antreibt, frei bewegen kann.</translation>
    </message>
    <message>
        <source>The motor jumps by the distance of the step and back, then twice as far and back, but no farther than %1 and %2 counts; the model is then found from these steps. Make sure that everything it drives can move freely.</source>
        <translation>Der Motor springt um die Strecke des Sprungs und zurück, dann doppelt so weit und zurück, höchstens aber um %1 und %2 Ink., und wird aus diesen Sprüngen bestimmt. Sicherstellen, dass sich alles, was er antreibt, frei bewegen kann.</translation>
    </message>
    <message>
        <source>Calculating the suggested gains…</source>
        <translation>Vorschläge werden berechnet…</translation>
    </message>
    <message>
        <source>The suggested gains are being calculated.</source>
        <translation>Die Vorschläge werden berechnet.</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleBench</name>
    <message>
        <source>Simulated module controls</source>
        <translation>Bedienung des simulierten Moduls</translation>
    </message>
    <message>
        <source>Pages of the simulated module</source>
        <translation>Seiten des simulierten Moduls</translation>
    </message>
    <message>
        <source>Switches</source>
        <translation>Schalter</translation>
    </message>
    <message>
        <source>Closed while checked.</source>
        <translation>Mit Haken geschlossen.</translation>
    </message>
    <message>
        <source>The motor&apos;s supply, not the module&apos;s.</source>
        <translation>Die Versorgung des Motors, nicht die des Moduls.</translation>
    </message>
    <message>
        <source>Limit switch 1, forward</source>
        <translation>Endschalter 1, vorwärts</translation>
    </message>
    <message>
        <source>Limit switch 2, reverse</source>
        <translation>Endschalter 2, rückwärts</translation>
    </message>
    <message>
        <source>Input 1</source>
        <translation>Eingang 1</translation>
    </message>
    <message>
        <source>Input 2</source>
        <translation>Eingang 2</translation>
    </message>
    <message>
        <source>The A/D reading of the temperature sensor.</source>
        <translation>Der A/D-Wert des Temperatursensors.</translation>
    </message>
    <message>
        <source>Limit switch 1</source>
        <translation>Endschalter 1</translation>
    </message>
    <message>
        <source>Limit switch 2</source>
        <translation>Endschalter 2</translation>
    </message>
    <message>
        <source>Encoder index</source>
        <translation>Indexpuls</translation>
    </message>
    <message>
        <source>Stays until the shaft moves.</source>
        <translation>Gilt, bis sich die Welle weiterbewegt.</translation>
    </message>
    <message>
        <source>Set the A/D input by hand</source>
        <translation>A/D-Eingang von Hand</translation>
    </message>
    <message>
        <source>If cleared, the A/D input reads the motor current.</source>
        <translation>Ohne Haken liest der A/D-Eingang den Motorstrom.</translation>
    </message>
    <message>
        <source>ADDR line broken towards the host</source>
        <translation>ADDR zum Rechner unterbrochen</translation>
    </message>
    <message>
        <source>The line is broken between this module and the next one towards the host, which then gets no address.</source>
        <translation>Die Leitung ist zwischen diesem Modul und dem nächsten zum Rechner hin unterbrochen; jenes bekommt dann keine Adresse.</translation>
    </message>
    <message>
        <source>Power-cycle</source>
        <translation>Aus und ein</translation>
    </message>
    <message>
        <source>Switches this module off and on: it loses its address and gains.</source>
        <translation>Schaltet dieses Modul aus und ein: Es verliert Adresse und Reglerwerte.</translation>
    </message>
    <message>
        <source>Power-cycle all</source>
        <translation>Alle aus und ein</translation>
    </message>
    <message>
        <source>Switches all modules off and on: they lose their addresses and gains.</source>
        <translation>Schaltet alle Module aus und ein: Sie verlieren Adressen und Reglerwerte.</translation>
    </message>
    <message>
        <source>Late tick</source>
        <translation>Später Takt</translation>
    </message>
    <message>
        <source>Makes one servo tick take too long: servo_overrun.</source>
        <translation>Lässt einen Servotakt zu lange dauern: servo_overrun.</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mechanik</translation>
    </message>
    <message>
        <source>Load torque</source>
        <translation>Lastmoment</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>External torque; positive values turn the shaft in reverse.</source>
        <translation>Äußeres Moment; positiv zieht die Welle rückwärts.</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>10⁻⁶ kg·m²</source>
        <translation>10⁻⁶ kg·m²</translation>
    </message>
    <message>
        <source>Moment of inertia of rotor and load.</source>
        <translation>Trägheitsmoment von Läufer und Last.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Dry friction; it also holds the shaft at rest.</source>
        <translation>Trockene Reibung, die die Welle auch im Stillstand hält.</translation>
    </message>
    <message>
        <source>Stop, reverse</source>
        <translation>Anschlag rückw.</translation>
    </message>
    <message>
        <source>A hard stop at the reverse end of travel. It cannot be set past the present shaft position.</source>
        <translation>Ein fester Anschlag am hinteren Ende des Fahrwegs. Er kann nicht hinter die jetzige Position der Welle gesetzt werden.</translation>
    </message>
    <message>
        <source>Stop, forward</source>
        <translation>Anschlag vorw.</translation>
    </message>
    <message>
        <source>A hard stop at the forward end of travel. It cannot be set past the present shaft position.</source>
        <translation>Ein fester Anschlag am vorderen Ende des Fahrwegs. Er kann nicht hinter die jetzige Position der Welle gesetzt werden.</translation>
    </message>
    <message>
        <source>Limit switches at the stops</source>
        <translation>Endschalter an den Anschlägen</translation>
    </message>
    <message>
        <source>The limit switches close at the ends of travel and cannot be set by hand.</source>
        <translation>Die Endschalter schließen an den Enden des Wegs; von Hand sind sie dann nicht stellbar.</translation>
    </message>
    <message>
        <source>Home switch at</source>
        <translation>Ref.-Schalter bei</translation>
    </message>
    <message>
        <source>Follows the motor&apos;s position: see Mechanics.</source>
        <translation>Folgt der Position des Motors: siehe Mechanik.</translation>
    </message>
    <message>
        <source>The home switch is closed forward of this position. If cleared, set it by hand.</source>
        <translation>Der Referenzschalter ist ab dieser Position vorwärts geschlossen. Ohne Haken wird er von Hand gestellt.</translation>
    </message>
    <message>
        <source>%1: level</source>
        <translation>%1: Pegel</translation>
    </message>
    <message>
        <source>255 is 5 V.</source>
        <translation>255 bedeutet 5 V.</translation>
    </message>
    <message>
        <source>PWM 1 and 2</source>
        <translation>PWM 1 und 2</translation>
    </message>
    <message>
        <source>The module&apos;s PWM outputs, 0 to 255.</source>
        <translation>Was das Modul ausgibt, von 255.</translation>
    </message>
    <message>
        <source>Timer or counter</source>
        <translation>Zeitgeber oder Zähler</translation>
    </message>
    <message>
        <source>The module&apos;s own count.</source>
        <translation>Wie das Modul zählt.</translation>
    </message>
    <message>
        <source>An output: the module sets its level.</source>
        <translation>Ein Ausgang: Das Modul bestimmt seinen Pegel.</translation>
    </message>
    <message>
        <source>High while checked.</source>
        <translation>Mit Haken High.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>off, %1</source>
        <translation>aus, %1</translation>
    </message>
    <message>
        <source>timer, %1</source>
        <translation>Zeitgeber, %1</translation>
    </message>
    <message>
        <source>counter, %1</source>
        <translation>Zähler, %1</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleContext</name>
    <message>
        <source>Waiting for the module&apos;s answer.</source>
        <translation>Die Antwort des Moduls steht noch aus.</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePage</name>
    <message>
        <source>Motions of the selected module</source>
        <translation>Bewegungen des gewählten Moduls</translation>
    </message>
    <message>
        <source>The pages of this module.</source>
        <translation>Die Seiten dieses Moduls.</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePanel</name>
    <message>
        <source>Selected module</source>
        <translation>Gewähltes Modul</translation>
    </message>
</context>
<context>
    <name>nmc::MotionBox</name>
    <message>
        <source>Ve&amp;locity</source>
        <translation>&amp;Geschwindigkeit</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>Geschwindigkeit der Fahrt</translation>
    </message>
    <message>
        <source>Acceleratio&amp;n</source>
        <translation>&amp;Beschleunigung</translation>
    </message>
    <message>
        <source>Velocity of running</source>
        <translation>Geschwindigkeit des Dauerlaufs</translation>
    </message>
    <message>
        <source>Used by every motion here, and by a smooth stop.</source>
        <translation>Gilt für jede Bewegung hier und für den sanften Stopp.</translation>
    </message>
    <message>
        <source>How fast the motor turns.</source>
        <translation>Wie schnell sich der Motor dreht.</translation>
    </message>
    <message>
        <source>Position or distance</source>
        <translation>Position oder Strecke</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Whether the number is a position, or a distance from the present position.</source>
        <translation>Ob die Zahl eine Position ist oder eine Strecke von dort, wo der Motor jetzt steht.</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>Hier n&amp;ullen</translation>
    </message>
    <message>
        <source>Load the move, start it later</source>
        <translation>Die Fahrt laden, später starten</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Start the loaded move</source>
        <translation>Die geladene Fahrt starten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Takes %1, peak %2: too short to reach its velocity</source>
        <translation>Dauert %1, Spitze %2: zu kurz, um die Geschwindigkeit zu erreichen</translation>
    </message>
    <message>
        <source>Takes %1, peak %2</source>
        <translation>Dauert %1, Spitze %2</translation>
    </message>
    <message>
        <source>Peak %1</source>
        <translation>Spitze %1</translation>
    </message>
    <message>
        <source>Peak %1: too short to reach its velocity</source>
        <translation>Spitze %1: zu kurz, um die Geschwindigkeit zu erreichen</translation>
    </message>
    <message>
        <source>Already there</source>
        <translation>Bereits dort</translation>
    </message>
    <message>
        <source>The goal is outside the position range.</source>
        <translation>Das Ziel liegt außerhalb des Positionsbereichs.</translation>
    </message>
    <message>
        <source>The goal of a trapezoidal move from standstill. Press Enter to start.</source>
        <translation>Das Ziel einer Trapezfahrt aus dem Stillstand. Die Eingabetaste startet die Fahrt.</translation>
    </message>
    <message>
        <source>Go to &amp;position</source>
        <translation>&amp;Position anfahren</translation>
    </message>
    <message>
        <source>Run at velocit&amp;y</source>
        <translation>Laufges&amp;chwindigkeit</translation>
    </message>
    <message>
        <source>The velocity of a run. Press Enter to run, or to change the velocity during a run.</source>
        <translation>Die Geschwindigkeit des Dauerlaufs. Die Eingabetaste startet ihn oder ändert während des Laufs die Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Loads the move without starting it. Choose Start, or start the module&apos;s group.</source>
        <translation>Lädt die Fahrt und startet sie nicht: das tut „Starten“ oder der Start der Gruppe des Moduls.</translation>
    </message>
    <message>
        <source>Starts the loaded move.</source>
        <translation>Startet die geladene Fahrt.</translation>
    </message>
    <message>
        <source>Moves to home.</source>
        <translation>Fährt zur Referenz.</translation>
    </message>
    <message>
        <source>Runs forward until stopped, or to its highest position.</source>
        <translation>Läuft vorwärts bis zum Stopp oder bis zur höchsten Position.</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped, or to its lowest position.</source>
        <translation>Läuft rückwärts bis zum Stopp oder bis zur tiefsten Position.</translation>
    </message>
</context>
<context>
    <name>nmc::MoveByBox</name>
    <message>
        <source>Step by a distance</source>
        <translation>Um eine Strecke weiterfahren</translation>
    </message>
    <message>
        <source>Step by</source>
        <translation>Schrittfahrt</translation>
    </message>
    <message>
        <source>Distance of a step</source>
        <translation>Strecke eines Schritts</translation>
    </message>
    <message>
        <source>The distance of a step</source>
        <translation>Die Strecke eines Schritts</translation>
    </message>
    <message>
        <source>Step in reverse</source>
        <translation>Schritt: Ein Schritt rückwärts</translation>
    </message>
    <message>
        <source>Step forward</source>
        <translation>Schritt: Ein Schritt vorwärts</translation>
    </message>
    <message>
        <source>The number of steps</source>
        <translation>Die Zahl der Schritte</translation>
    </message>
    <message>
        <source>Number of steps per click.</source>
        <translation>Wie viele Schritte ein Klick auslöst.</translation>
    </message>
    <message>
        <source>The pause between steps</source>
        <translation>Die Pause zwischen den Schritten</translation>
    </message>
    <message>
        <source>Time to wait after each move, in seconds.</source>
        <translation>Wartezeit nach jeder Fahrt in Sekunden.</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>hin und zurück</translation>
    </message>
    <message>
        <source>There and back with each step</source>
        <translation>hin und zurück: Jeder Schritt hin und zurück</translation>
    </message>
    <message>
        <source>Each step goes there and back.</source>
        <translation>Jeder Schritt geht hin und wieder zurück.</translation>
    </message>
    <message>
        <source>End steps</source>
        <translation>Schritte beenden</translation>
    </message>
    <message>
        <source>End steps and stop</source>
        <translation>Die Schritte beenden und stoppen</translation>
    </message>
    <message>
        <source>times, pause</source>
        <translation>mal, Pause</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>A series of steps is already running.</source>
        <translation>Eine Schrittfolge läuft bereits.</translation>
    </message>
    <message>
        <source>Moves forward by this distance, then holds.</source>
        <translation>Fährt um diese Strecke vorwärts und hält dort.</translation>
    </message>
    <message>
        <source>Moves in reverse by this distance, then holds.</source>
        <translation>Fährt um diese Strecke rückwärts und hält dort.</translation>
    </message>
    <message>
        <source>No series of steps is running.</source>
        <translation>Es läuft keine Schrittfolge.</translation>
    </message>
    <message>
        <source>Ends the series of steps and stops the motor smoothly.</source>
        <translation>Beendet die Schrittfolge und stoppt den Motor sanft.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Distance per click, at the velocity of Go to.</source>
        <translation>Wie weit ein Klick den Motor bewegt, mit der Geschwindigkeit von „Position anfahren“.</translation>
    </message>
</context>
<context>
    <name>nmc::NumberField</name>
    <message>
        <source>%1 must be %2 to %3%4.</source>
        <translation>%1: möglich ist %2 bis %3%4.</translation>
    </message>
    <message>
        <source>Enter a value for %1.</source>
        <translation>Einen Wert für %1 eingeben.</translation>
    </message>
    <message>
        <source>%1 must be a number.</source>
        <translation>%1 muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>%1 has two decimal marks. Both , and . count as decimal marks.</source>
        <translation>%1 hat zwei Dezimalzeichen. Sowohl , als auch . ist hier Dezimalzeichen.</translation>
    </message>
    <message>
        <source>%1 must be a whole number without , or . in it.</source>
        <translation>%1 muss eine ganze Zahl ohne , und . sein.</translation>
    </message>
    <message>
        <source>%1: %2 can be read in two ways. Press Enter in the field for %3, or type %4.</source>
        <translation>%1: %2 kann man auf zwei Arten lesen. Für %3 im Feld die Eingabetaste drücken, oder %4 eingeben.</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorDialog</name>
    <message>
        <source>Select what the operator may do. STOP ALL, Esc, each motor&apos;s stops and Disconnect always work. Operator mode prevents mistakes; it is not a security feature: anyone with access to this computer&apos;s files can bypass it.</source>
        <translation>Wählen Sie, was der Bediener tun darf. ALLES STOPP, Esc, die Stopps jedes Motors und Trennen gehen immer. Der Bedienermodus verhindert Versehen; er ist keine Zugangssicherung: Wer Zugriff auf die Dateien dieses Rechners hat, kann ihn umgehen.</translation>
    </message>
    <message>
        <source>&amp;Enable motors, clear faults</source>
        <translation>Motoren &amp;einschalten, Fehler quittieren</translation>
    </message>
    <message>
        <source>&amp;Jog</source>
        <translation>&amp;Tippen</translation>
    </message>
    <message>
        <source>&amp;Points and sequences</source>
        <translation>&amp;Punkte und Abläufe</translation>
    </message>
    <message>
        <source>&amp;Moves: go to, run, step</source>
        <translation>&amp;Fahrten: zu einem Ziel, dauernd, schrittweise</translation>
    </message>
    <message>
        <source>&amp;Homing</source>
        <translation>&amp;Referenzfahrt</translation>
    </message>
    <message>
        <source>&amp;Outputs</source>
        <translation>Aus&amp;gänge</translation>
    </message>
    <message>
        <source>P&amp;IN to leave operator mode, at least 4 characters</source>
        <translation>P&amp;IN zum Verlassen, mindestens 4 Zeichen</translation>
    </message>
    <message>
        <source>PIN &amp;again</source>
        <translation>Die&amp;selbe noch einmal</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>&amp;Leave operator mode</source>
        <translation>Bedienermodus &amp;verlassen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Cancel: keep the mode unchanged</source>
        <translation>Abbrechen: Modus unverändert lassen</translation>
    </message>
    <message>
        <source>The PIN is too short: use at least 4 characters.</source>
        <translation>Die PIN ist zu kurz: Sie braucht mindestens 4 Zeichen.</translation>
    </message>
    <message>
        <source>The two PINs differ. Type the same PIN twice.</source>
        <translation>Die beiden PINs sind verschieden. Geben Sie zweimal dieselbe ein.</translation>
    </message>
    <message>
        <source>Wrong PIN. %1</source>
        <translation>Das ist nicht die PIN. %1</translation>
    </message>
    <message>
        <source>E&amp;nter operator mode</source>
        <translation>&amp;Bedienermodus beginnen</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorLock</name>
    <message>
        <source>If you forgot it, close the panel and remove the &quot;operator&quot; section from %1.</source>
        <translation>Ist sie vergessen, schließen Sie das Programm und entfernen Sie den Abschnitt „operator“ aus %1.</translation>
    </message>
    <message>
        <source>Leave o&amp;perator mode…</source>
        <translation>&amp;Bedienermodus verlassen…</translation>
    </message>
    <message>
        <source>O&amp;perator mode…</source>
        <translation>Be&amp;dienermodus…</translation>
    </message>
    <message>
        <source>Limits the panel to the actions that you select, until someone enters the PIN.</source>
        <translation>Beschränkt das Programm auf die gewählten Aktionen, bis jemand die PIN eingibt.</translation>
    </message>
</context>
<context>
    <name>nmc::PacketModel</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Sent to</source>
        <translation>Gesendet an</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Zweck</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>nmc::PacketMonitor</name>
    <message>
        <source>Packet monitor</source>
        <translation>Paketmonitor</translation>
    </message>
    <message>
        <source>Filter packets by module</source>
        <translation>Pakete nach Modul filtern</translation>
    </message>
    <message>
        <source>Shows only packets of one module (Ctrl+M).</source>
        <translation>Zeigt nur die Pakete eines Moduls (Strg+M).</translation>
    </message>
    <message>
        <source>Filter packets by kind</source>
        <translation>Pakete nach Art filtern</translation>
    </message>
    <message>
        <source>Shows only packets of one kind (Ctrl+T).</source>
        <translation>Zeigt nur Pakete einer Art (Strg+T).</translation>
    </message>
    <message>
        <source>Polls</source>
        <translation>Abfragen</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stopps</translation>
    </message>
    <message>
        <source>Connecting and link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Nur Fehler</translation>
    </message>
    <message>
        <source>Stops recording; packets shown stay (%1).</source>
        <translation>Hält die Aufzeichnung an; das Gezeigte bleibt (%1).</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clears the packets shown (%1).</source>
        <translation>Leert die gezeigten Pakete (%1).</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected rows as text, or all rows if none is selected (%1).</source>
        <translation>Kopiert die gewählten Zeilen als Text, oder alle, wenn keine gewählt ist (%1).</translation>
    </message>
    <message>
        <source>Saves all recorded packets as text, or as a log that can be replayed (%1).</source>
        <translation>Speichert alles Aufgezeichnete als Text oder als Protokoll, das wieder abgespielt werden kann (%1).</translation>
    </message>
    <message>
        <source>Packets and counters</source>
        <translation>Pakete und Zähler</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Pakete</translation>
    </message>
    <message>
        <source>Counters</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Save packets</source>
        <translation>Pakete speichern</translation>
    </message>
    <message>
        <source>Replayable log (*%1)</source>
        <translation>Abspielbares Protokoll (*%1)</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 von %2 gezeigt</translation>
    </message>
    <message>
        <source>%1, %2 older dropped</source>
        <translation>%1, %2 ältere verworfen</translation>
    </message>
    <message>
        <source>%1, paused</source>
        <translation>%1, angehalten</translation>
    </message>
</context>
<context>
    <name>nmc::PacketView</name>
    <message>
        <source>Packets, newest last</source>
        <translation>Pakete, die neuesten zuletzt</translation>
    </message>
    <message>
        <source>No packets. Exchanges are recorded while this view is visible.</source>
        <translation>Keine Pakete. Übertragungen werden aufgezeichnet, solange diese Ansicht sichtbar ist.</translation>
    </message>
    <message>
        <source>No packets match the filter.</source>
        <translation>Kein Paket dieses Moduls und dieser Art wurde aufgezeichnet.</translation>
    </message>
</context>
<context>
    <name>nmc::PanelHead</name>
    <message>
        <source>&amp;Enable servo</source>
        <translation>Servo &amp;einschalten</translation>
    </message>
    <message>
        <source>Enable servo of this module</source>
        <translation>Den Servo dieses Moduls einschalten</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Stop this module smoothly</source>
        <translation>Dieses Modul sanft stoppen</translation>
    </message>
    <message>
        <source>Stop a&amp;bruptly</source>
        <translation>So&amp;fort-Stopp</translation>
    </message>
    <message>
        <source>Stop abruptly: this module</source>
        <translation>Sofort-Stopp: dieses Modul</translation>
    </message>
    <message>
        <source>&amp;Motor off</source>
        <translation>&amp;Motor aus</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Position unbekannt</translation>
    </message>
    <message>
        <source>The servo is already on.</source>
        <translation>Der Servo ist bereits ein.</translation>
    </message>
    <message>
        <source>Switches the amplifier on and holds the motor in place.</source>
        <translation>Schaltet den Verstärker ein und hält den Motor an seiner Position.</translation>
    </message>
    <message>
        <source>Slows down with the present acceleration, then holds.</source>
        <translation>Bremst mit der geltenden Beschleunigung, hält dann die Position.</translation>
    </message>
    <message>
        <source>Stops at once, then holds.</source>
        <translation>Stoppt sofort, hält dann die Position.</translation>
    </message>
    <message>
        <source>&amp;Enable amplifier</source>
        <translation>Verstärker &amp;einschalten</translation>
    </message>
    <message>
        <source>Enable amplifier of this module</source>
        <translation>Den Verstärker dieses Moduls einschalten</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Hier stoppen</translation>
    </message>
    <message>
        <source>Stop here: hold this module at its present position</source>
        <translation>Dieses Modul an seiner jetzigen Position stoppen</translation>
    </message>
    <message>
        <source>Position %1 %2</source>
        <translation>Position %1 %2</translation>
    </message>
    <message>
        <source>The amplifier is already on.</source>
        <translation>Der Verstärker ist bereits ein.</translation>
    </message>
    <message>
        <source>Stops at once and switches the amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Stoppt sofort und schaltet den Verstärker aus: Der Motor ist frei drehbar, und eine Last kann absinken.</translation>
    </message>
    <message>
        <source>Task running on this module</source>
        <translation>Laufender Vorgang dieses Moduls</translation>
    </message>
    <message>
        <source>Measured velocity</source>
        <translation>Gemessene Geschwindigkeit</translation>
    </message>
    <message>
        <source>Velocity measured from positions over 0.2 s.</source>
        <translation>Geschwindigkeit, aus Positionen über 0,2 s gemessen.</translation>
    </message>
    <message>
        <source>Motor power as sensed by the module.</source>
        <translation>Motorversorgung, wie das Modul sie erkennt.</translation>
    </message>
    <message>
        <source>Limit %1 –</source>
        <translation>Grenze %1 –</translation>
    </message>
    <message>
        <source>Limit %1 high</source>
        <translation>Grenze %1 high</translation>
    </message>
    <message>
        <source>Limit %1 low</source>
        <translation>Grenze %1 low</translation>
    </message>
    <message>
        <source>Power –</source>
        <translation>Spannung –</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>No power</source>
        <translation>Keine Spannung</translation>
    </message>
    <message>
        <source>Current was limited: %1</source>
        <translation>Strom wurde begrenzt: %1</translation>
    </message>
    <message>
        <source>Current %1</source>
        <translation>Strom %1</translation>
    </message>
    <message>
        <source>● Limit stop armed</source>
        <translation>● Endschalter-Stopp scharf</translation>
    </message>
    <message>
        <source>▲ Limit stop tripped</source>
        <translation>▲ Endschalter-Stopp ausgelöst</translation>
    </message>
    <message>
        <source>In motion, stops at once, as Stop abruptly does. At rest, holds the position that the motor has at this moment, without a profile.</source>
        <translation>In Bewegung: stoppt sofort, wie „Sofort stoppen“. Im Stillstand: hält ohne Profil die Position, die der Motor in diesem Moment hat.</translation>
    </message>
    <message>
        <source>Travel limits</source>
        <translation>Fahrweggrenzen</translation>
    </message>
    <message>
        <source>Switches the amplifier on, holds the motor in place and clears the sticky bits: the position error bit is set while the servo is off.</source>
        <translation>Schaltet den Verstärker ein, hält den Motor an seiner Position und löscht die Sticky-Bits: Das Bit des Positionsfehlers ist gesetzt, solange der Servo aus ist.</translation>
    </message>
    <message>
        <source>Looking for modules… This is the last known state.</source>
        <translation>Module werden gesucht… Das ist der letzte gemeldete Stand.</translation>
    </message>
    <message>
        <source>Driven by a test</source>
        <translation>Von einem Test bewegt</translation>
    </message>
    <message>
        <source>The test moves the motor around the position that it held.</source>
        <translation>Der Test bewegt den Motor um die Position, die er hielt.</translation>
    </message>
    <message>
        <source>Limit switch 1: high blocks the way to it.</source>
        <translation>Endschalter 1: high sperrt den Weg dorthin.</translation>
    </message>
    <message>
        <source>Limit switch 2: high blocks the way to it.</source>
        <translation>Endschalter 2: high sperrt den Weg dorthin.</translation>
    </message>
    <message>
        <source>counter: %1</source>
        <translation>Zähler: %1</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1: nicht bekannt</translation>
    </message>
</context>
<context>
    <name>nmc::PathPlot</name>
    <message>
        <source>Positions of the path over time</source>
        <translation>Positionen der Bahn über der Zeit</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>No path. Open a file, or draw one from a sequence.</source>
        <translation>Keine Bahn. Eine Datei öffnen oder eine aus einem Ablauf zeichnen.</translation>
    </message>
</context>
<context>
    <name>nmc::PathsPage</name>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Choice of a path</source>
        <translation>Wahl einer Bahn</translation>
    </message>
    <message>
        <source>Open path…</source>
        <translation>Bahn öffnen…</translation>
    </message>
    <message>
        <source>Open path… from a CSV file</source>
        <translation>Bahn öffnen… aus einer CSV-Datei</translation>
    </message>
    <message>
        <source>Save path…</source>
        <translation>Bahn speichern…</translation>
    </message>
    <message>
        <source>Save path… as a CSV file</source>
        <translation>Bahn speichern… als CSV-Datei</translation>
    </message>
    <message>
        <source>Sequence to draw a path from</source>
        <translation>Ablauf, aus dem eine Bahn wird</translation>
    </message>
    <message>
        <source>Rate of the path to draw</source>
        <translation>Rate der zu zeichnenden Bahn</translation>
    </message>
    <message>
        <source>Draw path</source>
        <translation>Bahn zeichnen</translation>
    </message>
    <message>
        <source>Draw path from the moves of a sequence</source>
        <translation>Bahn zeichnen aus den Fahrten eines Ablaufs</translation>
    </message>
    <message>
        <source>The path</source>
        <translation>Die Bahn</translation>
    </message>
    <message>
        <source>Running the path</source>
        <translation>Ausführen der Bahn</translation>
    </message>
    <message>
        <source>Move to start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Move to start: to the first point of the path</source>
        <translation>Zum Anfang: zum ersten Punkt der Bahn fahren</translation>
    </message>
    <message>
        <source>Run path</source>
        <translation>Bahn fahren</translation>
    </message>
    <message>
        <source>Run path, with confirmation</source>
        <translation>Bahn fahren, mit Rückfrage</translation>
    </message>
    <message>
        <source>Stop path</source>
        <translation>Bahn stoppen</translation>
    </message>
    <message>
        <source>Stop path: all its axes slow down</source>
        <translation>Bahn stoppen: alle ihre Achsen bremsen ab</translation>
    </message>
    <message>
        <source>Progress of the path</source>
        <translation>Fortschritt der Bahn</translation>
    </message>
    <message>
        <source>State of the path</source>
        <translation>Zustand der Bahn</translation>
    </message>
    <message>
        <source>Paths need a PIC-SERVO CMC or SC. This chain has none.</source>
        <translation>Bahnen brauchen einen PIC-SERVO CMC oder SC. Diese Kette hat keinen.</translation>
    </message>
    <message>
        <source>A path is running.</source>
        <translation>Eine Bahn läuft.</translation>
    </message>
    <message>
        <source>Open or draw a path first.</source>
        <translation>Erst eine Bahn öffnen oder zeichnen.</translation>
    </message>
    <message>
        <source>A sequence or a move to a point is running.</source>
        <translation>Ein Ablauf oder eine Fahrt zu einem Punkt läuft.</translation>
    </message>
    <message>
        <source>The unit of an axis has changed. Open or draw the path again.</source>
        <translation>Die Einheit einer Achse hat sich geändert. Die Bahn erneut öffnen oder zeichnen.</translation>
    </message>
    <message>
        <source>The counter or the home of an axis has changed. Draw the path again.</source>
        <translation>Der Zähler oder die Referenz einer Achse hat sich geändert. Die Bahn erneut zeichnen.</translation>
    </message>
    <message>
        <source>%1 is not a path for this chain:</source>
        <translation>%1 ist keine Bahn für diese Kette:</translation>
    </message>
    <message>
        <source>There may be more problems after these.</source>
        <translation>Danach kann es weitere Probleme geben.</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>Die Datei wird gelesen…</translation>
    </message>
    <message>
        <source>Reads positions for each point from a CSV file. Nothing moves.</source>
        <translation>Liest die Positionen jedes Punktes aus einer CSV-Datei. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Saves the path as CSV, with its positions in the units of the axes.</source>
        <translation>Speichert die Bahn als CSV, mit Positionen in den Einheiten der Achsen.</translation>
    </message>
    <message>
        <source>Create a sequence of moves first (F3).</source>
        <translation>Erst einen Ablauf mit Fahrten anlegen (F3).</translation>
    </message>
    <message>
        <source>Turns the moves of this sequence into one motion without stops. Nothing moves.</source>
        <translation>Macht aus den Fahrten dieses Ablaufs eine einzige Bewegung ohne Halt. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Moves each axis of the path to its first point.</source>
        <translation>Fährt jede Achse der Bahn zu ihrem ersten Punkt.</translation>
    </message>
    <message>
        <source>Runs all axes through the path. Asks first.</source>
        <translation>Fährt alle Achsen durch die Bahn. Fragt vorher.</translation>
    </message>
    <message>
        <source>No path is running.</source>
        <translation>Keine Bahn läuft.</translation>
    </message>
    <message>
        <source>Stops all axes of the path; they hold where they stop.</source>
        <translation>Stoppt alle Achsen der Bahn. Sie halten, wo sie stehen bleiben.</translation>
    </message>
    <message>
        <source>A path file has a column for each axis. Axes here: %1.</source>
        <translation>Eine Bahndatei hat eine Spalte für jede Achse. Achsen hier: %1.</translation>
    </message>
    <message>
        <source>Open a path</source>
        <translation>Bahn öffnen</translation>
    </message>
    <message>
        <source>Save the path</source>
        <translation>Bahn speichern</translation>
    </message>
    <message>
        <source>Start of the path</source>
        <translation>Anfang der Bahn</translation>
    </message>
    <message>
        <source>All axes of the path start to move. Make sure that nothing is in their way.</source>
        <translation>Alle Achsen der Bahn setzen sich in Bewegung. Sicherstellen, dass ihnen nichts im Weg ist.</translation>
    </message>
    <message>
        <source>Run the path</source>
        <translation>Bahn fahren</translation>
    </message>
    <message>
        <source>&amp;Run path</source>
        <translation>Bahn &amp;fahren</translation>
    </message>
</context>
<context>
    <name>nmc::Pendant</name>
    <message>
        <source>Pendant: &amp;keyboard, gamepad or jog wheel</source>
        <translation>Handgerät: &amp;Tastatur, Gamepad oder Handrad</translation>
    </message>
    <message>
        <source>To move the motor, hold Shift with an arrow key, or a shoulder button of a gamepad with its left stick or D-pad, or a button of a jog wheel with its ring or wheel. B (○) of the gamepad and the middle button of the wheel are STOP ALL. (F12)</source>
        <translation>Zum Bewegen des Motors Umschalt mit einer Pfeiltaste gedrückt halten, eine Schultertaste eines Gamepads mit seinem linken Stick oder Steuerkreuz oder eine Taste eines Handrads mit seinem Ring oder Rad. B (○) des Gamepads und die mittlere Taste des Handrads sind ALLES STOPP. (F12)</translation>
    </message>
</context>
<context>
    <name>nmc::PinBox</name>
    <message>
        <source>Make all pins inputs</source>
        <translation>Alle Pins zu Eingängen machen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Ask first</source>
        <translation>Erst fragen</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>Richtung von %1</translation>
    </message>
    <message>
        <source>high: output %1</source>
        <translation>High: Ausgang %1</translation>
    </message>
    <message>
        <source>Ask first before %1 changes</source>
        <translation>Erst fragen, bevor sich %1 ändert</translation>
    </message>
    <message>
        <source>Asks before the panel switches this output.</source>
        <translation>Das Programm fragt, bevor es diesen Ausgang schaltet.</translation>
    </message>
    <message>
        <source>Take %1 low on STOP ALL</source>
        <translation>ALLES STOPP nimmt %1 auf Low</translation>
    </message>
    <message>
        <source>STOP ALL takes this output low. If cleared, the output stays as it is.</source>
        <translation>ALLES STOPP nimmt diesen Ausgang auf Low. Ohne Haken bleibt er, wie er ist.</translation>
    </message>
    <message>
        <source>Switch %1 on?</source>
        <translation>%1 einschalten?</translation>
    </message>
    <message>
        <source>Switch %1 off?</source>
        <translation>%1 ausschalten?</translation>
    </message>
    <message>
        <source>&amp;Switch on</source>
        <translation>&amp;Einschalten</translation>
    </message>
    <message>
        <source>&amp;Switch off</source>
        <translation>&amp;Ausschalten</translation>
    </message>
    <message>
        <source>Makes all twelve pins inputs: outputs release what they drive.</source>
        <translation>Macht alle zwölf Pins zu Eingängen: Ausgänge lassen los, was sie treiben.</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Make all pins inputs to start over.</source>
        <translation>Ein anderes Programm hat dieses Modul eingerichtet, die Richtungen der Pins sind daher unbekannt. Alle Pins zu Eingängen machen, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>Pin directions unknown. Make all pins inputs first.</source>
        <translation>Die Richtungen sind unbekannt. Zuerst alle Pins zu Eingängen machen.</translation>
    </message>
    <message>
        <source>Input: the module reads this pin. Output: it drives this pin.</source>
        <translation>Ob das Modul diesen Pin liest oder treibt.</translation>
    </message>
    <message>
        <source>high, set low</source>
        <translation>High, gesetzt: Low</translation>
    </message>
    <message>
        <source>low, set high</source>
        <translation>Low, gesetzt: High</translation>
    </message>
    <message>
        <source>This pin is an input.</source>
        <translation>Dieser Pin ist ein Eingang.</translation>
    </message>
    <message>
        <source>Pin directions unknown.</source>
        <translation>Die Richtungen sind unbekannt.</translation>
    </message>
</context>
<context>
    <name>nmc::PointsModel</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
</context>
<context>
    <name>nmc::PrintDialog</name>
    <message>
        <source>&amp;Print</source>
        <translation>&amp;Drucken</translation>
    </message>
    <message>
        <source>Save as P&amp;DF…</source>
        <translation>Als &amp;PDF speichern…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Exemplare</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Als PDF speichern…</translation>
    </message>
    <message>
        <source>Saves the page as a file that any computer can print.</source>
        <translation>Speichert die Seite als Datei, die jeder Rechner drucken kann.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>P&amp;rinter</source>
        <translation>D&amp;rucker</translation>
    </message>
    <message>
        <source>C&amp;opies</source>
        <translation>&amp;Exemplare</translation>
    </message>
    <message>
        <source>The printer to use. It is preselected next time.</source>
        <translation>Der Drucker; er wird beim nächsten Mal wieder vorgeschlagen.</translation>
    </message>
    <message>
        <source>Sends the page to this printer.</source>
        <translation>Schickt die Seite an diesen Drucker.</translation>
    </message>
    <message>
        <source>Save the page</source>
        <translation>Seite speichern</translation>
    </message>
    <message>
        <source>page</source>
        <translation>Seite</translation>
    </message>
</context>
<context>
    <name>nmc::PwmBox</name>
    <message>
        <source>Drive reverse</source>
        <translation>Rückwärts treiben</translation>
    </message>
    <message>
        <source>Drive forward</source>
        <translation>Vorwärts treiben</translation>
    </message>
    <message>
        <source>The PWM value</source>
        <translation>Der PWM-Wert</translation>
    </message>
    <message>
        <source>The share of the supply that drives the motor; 255 is full power.</source>
        <translation>Der Anteil der Versorgung, der den Motor antreibt; 255 ist die volle Leistung.</translation>
    </message>
    <message>
        <source>Drive reverse with this PWM value</source>
        <translation>Rückwärts treiben: Den Motor mit diesem PWM-Wert rückwärts treiben</translation>
    </message>
    <message>
        <source>Drive forward with this PWM value</source>
        <translation>Vorwärts treiben: Den Motor mit diesem PWM-Wert vorwärts treiben</translation>
    </message>
    <message>
        <source>PWM drives the motor directly, without the servo. No position, position error or output limit protects it, and it runs until you switch it off.</source>
        <translation>PWM treibt den Motor direkt an, ohne den Servo. Keine Positions-, Positionsfehler- oder Ausgangsgrenze schützt ihn, und er läuft, bis er abgeschaltet wird.</translation>
    </message>
    <message>
        <source>= %1 %</source>
        <translation>= %1 %</translation>
    </message>
    <message>
        <source>Drives the motor in reverse until you switch it off.</source>
        <translation>Treibt den Motor rückwärts an, bis er abgeschaltet wird.</translation>
    </message>
    <message>
        <source>Drives the motor forward until you switch it off.</source>
        <translation>Treibt den Motor vorwärts an, bis er abgeschaltet wird.</translation>
    </message>
</context>
<context>
    <name>nmc::RatePage</name>
    <message>
        <source>&amp;Change baud rate</source>
        <translation>Baud&amp;rate ändern</translation>
    </message>
    <message>
        <source>New baud rate of the chain</source>
        <translation>Neue Rate der Kette</translation>
    </message>
    <message>
        <source>The new baud rate of the whole chain.</source>
        <translation>Die Rate, mit der die ganze Kette arbeiten soll.</translation>
    </message>
    <message>
        <source>Change baud rate of the whole chain</source>
        <translation>Die Rate der ganzen Kette ändern</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>Positions, gains and groups are kept. The panel checks every module at the new baud rate; if one does not answer, all modules go back to the old rate.</source>
        <translation>Positionen, Reglerwerte und Gruppen bleiben. Jedes Modul wird bei der neuen Rate abgefragt; antwortet eines dort nicht, kehren alle zur alten zurück.</translation>
    </message>
    <message>
        <source>The chain runs at %1 Bd.</source>
        <translation>Die Kette arbeitet mit %1 Bd.</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change the baud rate.</source>
        <translation>Ein Motor ist in Bewegung. Zum Ändern der Baudrate alle Motoren stoppen.</translation>
    </message>
    <message>
        <source>The chain already runs at this baud rate.</source>
        <translation>Die Kette arbeitet bereits mit dieser Rate.</translation>
    </message>
    <message>
        <source>Sends the new baud rate to every module, then checks each one.</source>
        <translation>Teilt jedem Modul die neue Rate mit und fragt jedes dort ab.</translation>
    </message>
    <message>
        <source>Modules that do not answer would stay at the old baud rate: %1.</source>
        <translation>Einige Module antworten nicht und blieben bei der alten Rate zurück: %1.</translation>
    </message>
    <message>
        <source>Modules with an unknown group may miss the change: %1. Set their group on the Groups page, or none.</source>
        <translation>Module mit unbekannter Gruppe verpassen vielleicht den Wechsel: %1. Auf der Seite Gruppen ihre Gruppe setzen oder keine.</translation>
    </message>
    <message>
        <source>Group leaders would answer during the change. Make these ordinary members on the Groups page: %1.</source>
        <translation>Leitmodule würden während des Wechsels antworten. Auf der Seite Gruppen gewöhnliche Mitglieder daraus machen: %1.</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Andere…</translation>
    </message>
    <message>
        <source>Divisor of Set Baud Rate</source>
        <translation>Teiler von Set Baud Rate</translation>
    </message>
    <message>
        <source>The baud rate is 1 250 000 Bd / (divisor + 1). The panel first checks that this computer&apos;s port supports it to within 2 %.</source>
        <translation>Die Baudrate ist 1 250 000 Bd / (Teiler + 1). Das Programm prüft zuerst, ob der Port dieses Rechners sie auf 2 % genau unterstützt.</translation>
    </message>
    <message>
        <source>= %1 Bd</source>
        <translation>= %1 Bd</translation>
    </message>
    <message>
        <source>The divisor</source>
        <translation>Der Teiler</translation>
    </message>
</context>
<context>
    <name>nmc::RepeatabilityBox</name>
    <message>
        <source>Repeatability and backlash</source>
        <translation>Wiederholgenauigkeit und Spiel</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measure repeatability and backlash</source>
        <translation>Wiederholgenauigkeit und Spiel messen</translation>
    </message>
    <message>
        <source>Cancel measuring the repeatability</source>
        <translation>Messung der Wiederholgenauigkeit abbrechen</translation>
    </message>
    <message>
        <source>Use as backlash</source>
        <translation>Als Spiel verwenden</translation>
    </message>
    <message>
        <source>Use as backlash of the axis</source>
        <translation>Als Spiel der Achse verwenden</translation>
    </message>
    <message>
        <source>Result of the repeatability measurement</source>
        <translation>Ergebnis der Messung der Wiederholgenauigkeit</translation>
    </message>
    <message>
        <source>Approach this input</source>
        <translation>Diesen Eingang anfahren</translation>
    </message>
    <message>
        <source>The motor approaches it from both sides. Direction, acceleration, search distance and time limit are those of the search for home.</source>
        <translation>Der Motor fährt ihn von beiden Seiten an. Richtung, Beschleunigung, Suchweg und Zeitgrenze sind die der Referenzfahrt.</translation>
    </message>
    <message>
        <source>Velocity of the approach</source>
        <translation>Geschwindigkeit der Anfahrt</translation>
    </message>
    <message>
        <source>Slower is more exact: the chip may read its inputs only once per servo tick.</source>
        <translation>Langsamer ist genauer: Der Chip liest seine Eingänge vielleicht nur einmal je Servotakt.</translation>
    </message>
    <message>
        <source>Times from each side</source>
        <translation>Anzahl von jeder Seite</translation>
    </message>
    <message>
        <source>Number of approaches from each side.</source>
        <translation>Anzahl der Anfahrten von jeder Seite.</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>from each side</source>
        <translation>von jeder Seite</translation>
    </message>
    <message>
        <source>The measurement is running.</source>
        <translation>Die Messung läuft.</translation>
    </message>
    <message>
        <source>Measure first.</source>
        <translation>Zuerst messen.</translation>
    </message>
    <message>
        <source>An index does not show the backlash of the load.</source>
        <translation>Ein Index zeigt das Spiel der Last nicht.</translation>
    </message>
    <message>
        <source>No backlash was found that exceeds its uncertainty.</source>
        <translation>Es wurde kein Spiel gefunden, das größer als seine Unsicherheit ist.</translation>
    </message>
    <message>
        <source>The axis has this backlash.</source>
        <translation>Die Achse hat dieses Spiel.</translation>
    </message>
    <message>
        <source>Not measured in this connection.</source>
        <translation>In dieser Verbindung nicht gemessen.</translation>
    </message>
    <message>
        <source>Forward, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>Vorwärts, %4-mal: Mittelwert %1, Standardabweichung %2, Spanne %3</translation>
    </message>
    <message>
        <source>Reverse, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>Rückwärts, %4-mal: Mittelwert %1, Standardabweichung %2, Spanne %3</translation>
    </message>
    <message>
        <source>Difference: %1 ± %2</source>
        <translation>Differenz: %1 ± %2</translation>
    </message>
    <message>
        <source>Backlash: %1 ± %2</source>
        <translation>Spiel: %1 ± %2</translation>
    </message>
    <message>
        <source>The index is on the encoder&apos;s own shaft: this shows how well a capture repeats, not the backlash of the load.</source>
        <translation>Der Index sitzt auf der Welle des Encoders: Dies zeigt, wie gut sich eine Erfassung wiederholt, nicht das Spiel der Last.</translation>
    </message>
    <message>
        <source>Below zero, so this is not backlash. The switch may bounce.</source>
        <translation>Unter null, also kein Spiel. Vielleicht prellt der Schalter.</translation>
    </message>
    <message>
        <source>Includes the hysteresis of the switch itself. Only with the encoder on the motor and the switch on the load does it show the backlash between them.</source>
        <translation>Enthält die Hysterese des Schalters selbst. Nur mit dem Encoder am Motor und dem Schalter an der Last zeigt es das Spiel dazwischen.</translation>
    </message>
    <message>
        <source>The motor moves up to %1 between two readings of the inputs. Measure more slowly.</source>
        <translation>Der Motor bewegt sich um bis zu %1, bis der Chip seine Eingänge wieder liest. Langsamer messen.</translation>
    </message>
    <message>
        <source>Moves the motor to and fro across the switch or index, and reads where it was captured.</source>
        <translation>Fährt den Motor über Schalter oder Index hin und her und liest, wo er erfasst wurde.</translation>
    </message>
    <message>
        <source>No measurement is running.</source>
        <translation>Es läuft keine Messung.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly; what was captured stays.</source>
        <translation>Hält den Motor sanft an; was erfasst wurde, bleibt.</translation>
    </message>
    <message>
        <source>Makes %1 the backlash of the axis (Axis page): what was measured, with its uncertainty. Sends nothing.</source>
        <translation>Macht %1 zum Spiel der Achse (Seite Achse): das Gemessene mit seiner Unsicherheit. Sendet nichts.</translation>
    </message>
</context>
<context>
    <name>nmc::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Problem melden</translation>
    </message>
    <message>
        <source>Nothing is sent. Read the report below, save it, and attach the file where you describe the problem. It contains neither your PIN nor the name of your home folder.</source>
        <translation>Es wird nichts gesendet. Den Bericht unten lesen, speichern und die Datei dort anhängen, wo das Problem beschrieben wird. Er enthält weder die PIN noch den Namen des persönlichen Ordners.</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>Text des Berichts</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseForm</name>
    <message>
        <source>Settings of the next step</source>
        <translation>Wie der nächste Sprung gemacht wird</translation>
    </message>
    <message>
        <source>Distance of the step response</source>
        <translation>Strecke der Sprungantwort</translation>
    </message>
    <message>
        <source>The distance of the step</source>
        <translation>Die Strecke des Sprungs</translation>
    </message>
    <message>
        <source>The record</source>
        <translation>Die Aufzeichnung</translation>
    </message>
    <message>
        <source>The settling band</source>
        <translation>Das Toleranzband</translation>
    </message>
    <message>
        <source>% of the step</source>
        <translation>% des Sprungs</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal. At least one count. Applies to all runs.</source>
        <translation>Der Motor ist eingeschwungen, wenn er so nahe am Ziel bleibt. Mindestens ein Inkrement. Gilt für alle Läufe.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Settling band</source>
        <translation>Toleranzband</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Step and record</source>
        <translation>Einen Sprung ausführen und aufzeichnen</translation>
    </message>
    <message>
        <source>The motor jumps by this distance, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>Der Motor springt um diese Strecke und hält dort. Sicherstellen, dass sich alles, was er antreibt, frei bewegen kann (Umschalt+F9).</translation>
    </message>
    <message>
        <source>%1 %2 instead of %3</source>
        <translation>%1 %2 statt %3</translation>
    </message>
    <message>
        <source>Some gains in the fields were not sent: %1. Which gains should the step use?</source>
        <translation>Einige Reglerwerte in den Feldern wurden nicht gesendet: %1. Mit welchen soll der Sprung gemacht werden?</translation>
    </message>
    <message>
        <source>Gains not sent</source>
        <translation>Nicht gesendete Reglerwerte</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Apply and step</source>
        <translation>&amp;Anwenden und springen</translation>
    </message>
    <message>
        <source>Step with &amp;present gains</source>
        <translation>&amp;Mit denen des Moduls springen</translation>
    </message>
    <message>
        <source>How far the command goes; negative: reverse. Small steps show the tuning of the servo, large ones the limits of the amplifier.</source>
        <translation>Wie weit die Sollposition geht; negativ: rückwärts. Kleine Sprünge zeigen die Einstellung des Servos, große die Grenzen des Verstärkers.</translation>
    </message>
    <message>
        <source>How long to record after the step, or after the end of a move. Then the motor is commanded to hold.</source>
        <translation>Wie lange nach dem Sprung oder nach dem Ende einer Fahrt aufgezeichnet wird. Danach hält der Motor.</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>Geschwindigkeit der Fahrt</translation>
    </message>
    <message>
        <source>Acceleration of the move</source>
        <translation>Beschleunigung der Fahrt</translation>
    </message>
    <message>
        <source>Moves there and back</source>
        <translation>Fahrten hin und zurück</translation>
    </message>
    <message>
        <source>How often it moves there and back. Each move is recorded.</source>
        <translation>Wie oft hin und zurück gefahren wird. Jede Fahrt wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>Settling window</source>
        <translation>Einschwingfenster</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal for the dwell. At least one count. Applies to all moves.</source>
        <translation>Der Motor ist eingeschwungen, wenn er während der Verweilzeit so nah am Ziel bleibt. Mindestens ein Inkrement. Gilt für alle Fahrten.</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Verweilzeit</translation>
    </message>
    <message>
        <source>How long it must stay in the window. The settling time ends where the dwell begins.</source>
        <translation>Wie lange er im Fenster bleiben muss. Die Einschwingzeit endet, wo die Verweilzeit beginnt.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Hin und zurück</translation>
    </message>
    <message>
        <source>A step or move is already running.</source>
        <translation>Ein Sprung oder eine Fahrt läuft bereits.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Move and record</source>
        <translation>Fahren und aufzeichnen</translation>
    </message>
    <message>
        <source>The motor moves there and back, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>Der Motor fährt hin und zurück und hält dann. Sicherstellen, dass sich alles Angetriebene frei bewegen kann (Umschalt+F9).</translation>
    </message>
    <message>
        <source>The velocity of the move. Until you type one, it is that of moves to a position.</source>
        <translation>Die Geschwindigkeit der Fahrt. Bis eine eingegeben wird, ist es die der Fahrten zu einer Position.</translation>
    </message>
    <message>
        <source>The acceleration of the move. Until you type one, it is that of moves to a position.</source>
        <translation>Die Beschleunigung der Fahrt. Bis eine eingegeben wird, ist es die der Fahrten zu einer Position.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePage</name>
    <message>
        <source>Use these gains</source>
        <translation>Werte übernehmen</translation>
    </message>
    <message>
        <source>Select a run in the list first.</source>
        <translation>Zuerst einen Lauf in der Liste wählen.</translation>
    </message>
    <message>
        <source>This run belongs to %1. Select that module first.</source>
        <translation>Dieser Lauf gehört zu %1. Zuerst dieses Modul wählen.</translation>
    </message>
    <message>
        <source>Copies the gains of this run to the Gains page. Sends nothing (Ctrl+Shift+U).</source>
        <translation>Trägt die Reglerwerte dieses Laufs in die Felder der Seite Reglerwerte ein. Sendet nichts (Strg+Umschalt+U).</translation>
    </message>
    <message>
        <source>Removes this run from the list (Ctrl+Del).</source>
        <translation>Nimmt diesen Lauf aus der Liste (Strg+Entf).</translation>
    </message>
    <message>
        <source>No run yet. Record a step first.</source>
        <translation>Noch kein Lauf. Zuerst einen Sprung aufzeichnen.</translation>
    </message>
    <message>
        <source>Saves all runs in the list with their gains and results (Ctrl+Shift+X).</source>
        <translation>Speichert alle Läufe der Liste mit ihren Reglerwerten und Ergebnissen (Strg+Umschalt+X).</translation>
    </message>
    <message>
        <source>Export step responses</source>
        <translation>Sprungantworten exportieren</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Step results</source>
        <translation>Ergebnisse der Sprünge</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Alle Läufe</translation>
    </message>
    <message>
        <source>All runs of this module in the plot</source>
        <translation>Alle Läufe dieses Moduls in der Kurve</translation>
    </message>
    <message>
        <source>Shows the other runs of this module, older runs paler.</source>
        <translation>Zeichnet auch die anderen Läufe dieses Moduls, ältere blasser.</translation>
    </message>
    <message>
        <source>No run was removed.</source>
        <translation>Es wurde kein Lauf entfernt.</translation>
    </message>
    <message>
        <source>Restores the run removed last (Ctrl+Shift+Del).</source>
        <translation>Holt den zuletzt entfernten Lauf zurück (Strg+Umschalt+Entf).</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePlot</name>
    <message>
        <source>Step responses over time</source>
        <translation>Sprungantworten über der Zeit</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>Lauf %1, %2</translation>
    </message>
    <message>
        <source>A: %1</source>
        <translation>A: %1</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B: %1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>No run selected. A step response shows how the motor follows a jump of its command.</source>
        <translation>Kein Lauf gezeigt. Ein Sprung zeigt, wie der Motor folgt, wenn seine Sollposition springt.</translation>
    </message>
    <message>
        <source>motor model</source>
        <translation>Motormodell</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>Positions since the step, relative to its start. The shaded band is the settling band around the goal. Double-click to switch between the whole record and the motion. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>Positionen seit dem Sprung, bezogen auf seinen Beginn. Das schattierte Band ist das Toleranzband um das Ziel. Ein Doppelklick wechselt zwischen der ganzen Aufzeichnung und der Bewegung. Das Mausrad zoomt die Zeit, mit Strg die Positionen; Ziehen verschiebt; Ziehen mit Umschalt wählt eine Zeit.</translation>
    </message>
    <message>
        <source>time since the step (s)</source>
        <translation>Zeit seit dem Sprung (s)</translation>
    </message>
    <message>
        <source>position from the start</source>
        <translation>Position vom Start aus</translation>
    </message>
    <message>
        <source>position from the start (%1)</source>
        <translation>Position vom Start aus (%1)</translation>
    </message>
    <message>
        <source>goal, command</source>
        <translation>Ziel, Sollposition</translation>
    </message>
    <message>
        <source>time since the start (s)</source>
        <translation>Zeit seit dem Start (s)</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseResults</name>
    <message>
        <source>Results of the runs shown</source>
        <translation>Was die gezeigten Läufe ergeben</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Anstieg, 10 bis 90 %</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>Bleibende Abweichung</translation>
    </message>
    <message>
        <source>Peak PWM, of 255</source>
        <translation>PWM-Spitze, von 255</translation>
    </message>
    <message>
        <source>Sample interval</source>
        <translation>Messabstand</translation>
    </message>
    <message>
        <source>Time from 10 % to 90 % of the step.</source>
        <translation>Zeit von 10 % bis 90 % des Sprungs.</translation>
    </message>
    <message>
        <source>How far the motor went past its goal, in % of the step.</source>
        <translation>Wie weit der Motor über sein Ziel hinausging, in % des Sprungs.</translation>
    </message>
    <message>
        <source>Goal minus the mean position over the last fifth of the record.</source>
        <translation>Ziel minus mittlere Position im letzten Fünftel der Aufzeichnung.</translation>
    </message>
    <message>
        <source>PWM demand at the jump, calculated from the gains. Later ticks may need more: below the output limit OL this is a lower bound.</source>
        <translation>PWM-Bedarf beim Sprung, aus den Reglerwerten berechnet. Spätere Takte können mehr brauchen: Unter der Ausgangsgrenze OL ist dies eine untere Schranke.</translation>
    </message>
    <message>
        <source>Mean time between two positions of the record. It sets the accuracy of the results.</source>
        <translation>Mittlere Zeit zwischen zwei Positionen der Aufzeichnung. Von ihr hängt die Genauigkeit der Ergebnisse ab.</translation>
    </message>
    <message>
        <source>Settling to the goal</source>
        <translation>Einschwingen aufs Ziel</translation>
    </message>
    <message>
        <source>Settling to rest position</source>
        <translation>Einschwingen zur Ruhe</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the goal. Empty if that happens only in the last fifth of the record.</source>
        <translation>Zeit, bis die Position im Toleranzband um das Ziel bleibt. Leer, wenn das erst im letzten Fünftel der Aufzeichnung eintritt.</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the mean position of the last fifth of the record. Without integral gain (Ki, IL), friction holds a motor off its goal.</source>
        <translation>Dasselbe um die mittlere Position des letzten Fünftels der Aufzeichnung. Reibung hält einen Motor neben seinem Ziel, wenn es keinen Integralanteil (Ki, IL) gibt.</translation>
    </message>
    <message>
        <source>Move time</source>
        <translation>Fahrzeit</translation>
    </message>
    <message>
        <source>Settling after the move</source>
        <translation>Einschwingen nach der Fahrt</translation>
    </message>
    <message>
        <source>Settling, all moves</source>
        <translation>Einschwingen, alle Fahrten</translation>
    </message>
    <message>
        <source>Peak error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>Effektivwert des Fehlers</translation>
    </message>
    <message>
        <source>Error at constant velocity</source>
        <translation>Fehler bei konstanter Geschw.</translation>
    </message>
    <message>
        <source>Duration of the commanded profile, calculated from distance, velocity and acceleration.</source>
        <translation>Dauer des kommandierten Profils, berechnet aus Weg, Geschwindigkeit und Beschleunigung.</translation>
    </message>
    <message>
        <source>Time from the end of the profile until the motor is in the window, where it stays for the dwell.</source>
        <translation>Zeit vom Ende des Profils, bis der Motor im Fenster ist, wo er die Verweilzeit über bleibt.</translation>
    </message>
    <message>
        <source>The shortest and the longest settling time of the moves there and back, and their number.</source>
        <translation>Die kürzeste und die längste Einschwingzeit der Fahrten hin und zurück, und deren Anzahl.</translation>
    </message>
    <message>
        <source>The largest position error during the move and after it, without its sign.</source>
        <translation>Der größte Positionsfehler während der Fahrt und danach, ohne Vorzeichen.</translation>
    </message>
    <message>
        <source>Root mean square of the position error during the move.</source>
        <translation>Effektivwert des Positionsfehlers während der Fahrt.</translation>
    </message>
    <message>
        <source>Mean position error over the second half of the time at constant velocity.</source>
        <translation>Mittlerer Positionsfehler über die zweite Hälfte der Zeit mit konstanter Geschwindigkeit.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseTable</name>
    <message>
        <source>Step responses so far</source>
        <translation>Bisherige Sprungantworten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Einschwingen</translation>
    </message>
    <message>
        <source>Run %1 as A</source>
        <translation>Lauf %1 als A</translation>
    </message>
    <message>
        <source>Run %1 as B</source>
        <translation>Lauf %1 als B</translation>
    </message>
    <message>
        <source>Draws this run as A, with a solid line.</source>
        <translation>Zeichnet diesen Lauf als A, mit durchgezogener Linie.</translation>
    </message>
    <message>
        <source>Draws this run as B, with a dashed line.</source>
        <translation>Zeichnet diesen Lauf als B, mit gestrichelter Linie.</translation>
    </message>
    <message>
        <source>Step responses, newest first. Select two check boxes to compare the curves. The last %1 are saved with the machine; those with a name or a note are kept longest.</source>
        <translation>Sprungantworten, die neueste zuerst. Zwei Häkchen setzen, um die Kurven zu vergleichen. Die letzten %1 werden mit der Maschine gespeichert; am längsten bleiben die mit einem Namen oder einer Notiz.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Name of the run. Double-click or press F2 to edit.</source>
        <translation>Wie der Lauf heißt. Zum Schreiben doppelklicken oder F2 drücken.</translation>
    </message>
    <message>
        <source>Note on the run. Double-click or press F2 to edit.</source>
        <translation>Was man von dem Lauf wissen sollte. Doppelklicken oder F2 drücken.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseView</name>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fits the view to the motion and all positions (A, in the plot).</source>
        <translation>Passt die Ansicht an die Bewegung und alle Positionen an (A, im Diagramm).</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C, in the plot).</source>
        <translation>Zwei Cursor zum Messen: ziehen Sie sie (C, im Diagramm).</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard.</source>
        <translation>Kopiert das sichtbare Diagramm in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Exports the visible plot, with a description of the runs.</source>
        <translation>Exportiert das sichtbare Diagramm mit einer Beschreibung der Läufe.</translation>
    </message>
    <message>
        <source>A: run %1, %2, %3, %4</source>
        <translation>A: Lauf %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>B: run %1, %2, %3, %4</source>
        <translation>B: Lauf %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>Kp %1 Kd %2 Ki %3 IL %4; rise %5; overshoot %6; settling %7</source>
        <translation>Kp %1 Kd %2 Ki %3 IL %4; Anstieg %5; Überschwingen %6; Einschwingen %7</translation>
    </message>
    <message>
        <source>Step response, by NMC Panel %1</source>
        <translation>Sprungantwort, von NMC Panel %1</translation>
    </message>
    <message>
        <source>%1: cursor 1 %2, cursor 2 %3, difference %4</source>
        <translation>%1: Cursor 1 %2, Cursor 2 %3, Differenz %4</translation>
    </message>
    <message>
        <source>Picture of the step response</source>
        <translation>Bild der Sprungantwort</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
</context>
<context>
    <name>nmc::Ribbons</name>
    <message>
        <source>SIMULATOR — no hardware connected; all values are simulated</source>
        <translation>SIMULATOR — keine Hardware angeschlossen; alle Werte sind simuliert</translation>
    </message>
    <message>
        <source>Simulated session</source>
        <translation>Simulierte Sitzung</translation>
    </message>
    <message>
        <source>Read-only session</source>
        <translation>Sitzung nur zum Lesen</translation>
    </message>
    <message>
        <source>READ-ONLY — only status requests are sent. STOP ALL still works.</source>
        <translation>NUR LESEN — nur Statusabfragen werden gesendet. ALLES STOPP wirkt.</translation>
    </message>
    <message>
        <source>Reconnects to the same port with commands allowed. Nothing moves.</source>
        <translation>Verbindet neu mit demselben Port; Befehle sind dann erlaubt. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>OPERATOR MODE — only allowed actions are available. STOP ALL always works.</source>
        <translation>BEDIENERMODUS — nur erlaubte Aktionen sind möglich. ALLES STOPP wirkt immer.</translation>
    </message>
    <message>
        <source>Leave…</source>
        <translation>Verlassen…</translation>
    </message>
    <message>
        <source>End pendant mode</source>
        <translation>Handgerät beenden</translation>
    </message>
    <message>
        <source>Hold Shift with ◂ or ▸ to move it. Esc ends pendant mode.</source>
        <translation>Zum Bewegen Umschalt mit ◂ oder ▸ gedrückt halten. Esc beendet das Handgerät.</translation>
    </message>
    <message>
        <source>Not moved: %1</source>
        <translation>Nicht bewegt: %1</translation>
    </message>
    <message>
        <source>PENDANT — %1. %2</source>
        <translation>HANDGERÄT — %1. %2</translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation>Handgerät</translation>
    </message>
    <message>
        <source>Ends pendant mode: arrow keys and gamepad no longer move anything.</source>
        <translation>Beendet das Handgerät: Pfeiltasten und Gamepad bewegen nichts mehr.</translation>
    </message>
    <message>
        <source>To move it, hold Shift with ◂ or ▸, or a shoulder button of the gamepad with its left stick or D-pad. B (○) is STOP ALL. Esc ends pendant mode.</source>
        <translation>Zum Bewegen Umschalt mit ◂ oder ▸ gedrückt halten oder eine Schultertaste des Gamepads mit seinem linken Stick oder Steuerkreuz. B (○) ist ALLES STOPP. Esc beendet das Handgerät.</translation>
    </message>
    <message>
        <source>End control</source>
        <translation>Kontrolle beenden</translation>
    </message>
    <message>
        <source>The program may no longer move motors.</source>
        <translation>Das Programm darf keine Motoren mehr bewegen.</translation>
    </message>
    <message>
        <source>PROGRAM — &quot;%1&quot; may move motors. Esc or any command of yours ends that.</source>
        <translation>PROGRAMM — „%1“ darf Motoren bewegen. Esc oder ein eigener Befehl beendet das.</translation>
    </message>
    <message>
        <source>PROGRAMS — none can connect now.</source>
        <translation>PROGRAMME — derzeit kann sich keines verbinden.</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect once a port is open.</source>
        <translation>PROGRAMME — dürfen sich verbinden, sobald ein Port offen ist.</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect at %1. Connected: %2.</source>
        <translation>PROGRAMME — dürfen sich unter %1 verbinden. Verbunden: %2.</translation>
    </message>
    <message>
        <source>Line lent to a program</source>
        <translation>Leitung an ein Programm verliehen</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>The program has the line again. It may move motors at once.</source>
        <translation>Das Programm hat die Leitung wieder. Es kann sofort Motoren bewegen.</translation>
    </message>
    <message>
        <source>End lending</source>
        <translation>Verleihen beenden</translation>
    </message>
    <message>
        <source>The program loses the line, and the chain is scanned again. Nothing is reset or stopped.</source>
        <translation>Das Programm verliert die Leitung, und die Module werden neu gesucht. Nichts wird zurückgesetzt oder gestoppt.</translation>
    </message>
    <message>
        <source>There is a jog wheel, but you may not read it. Unplug it and plug it in again; if that does not help, see the manual. Esc ends pendant mode.</source>
        <translation>Ein Handrad ist angeschlossen, darf aber nicht gelesen werden. Abziehen und wieder einstecken; hilft das nicht, im Handbuch nachsehen. Esc beendet das Handgerät.</translation>
    </message>
    <message>
        <source>To move it, hold a button of the jog wheel, and push its ring or cap for a speed or turn the wheel for steps. The middle button, or the right one of a 3-axis mouse, is STOP ALL. Esc ends pendant mode.</source>
        <translation>Zum Bewegen eine Taste des Handrads gedrückt halten und den Ring oder die Kappe für eine Geschwindigkeit auslenken oder das Rad für Schritte drehen. Die mittlere Taste, bei einer 3-Achs-Maus die rechte, ist ALLES STOPP. Esc beendet das Handgerät.</translation>
    </message>
</context>
<context>
    <name>nmc::RowDelegate</name>
    <message>
        <source>Value of the row</source>
        <translation>Wert der Zeile</translation>
    </message>
    <message>
        <source>The value</source>
        <translation>Der Wert</translation>
    </message>
    <message>
        <source>Choices of the row</source>
        <translation>Auswahl der Zeile</translation>
    </message>
</context>
<context>
    <name>nmc::RowsModel</name>
    <message>
        <source>from row %1 on</source>
        <translation>ab Zeile %1</translation>
    </message>
    <message>
        <source>together</source>
        <translation>zusammen</translation>
    </message>
    <message>
        <source>together, next row at once</source>
        <translation>zusammen, nächste Zeile sofort</translation>
    </message>
    <message>
        <source>one after the other</source>
        <translation>nacheinander</translation>
    </message>
    <message>
        <source>one after the other, next row at once</source>
        <translation>nacheinander, nächste Zeile sofort</translation>
    </message>
    <message>
        <source>%1 active</source>
        <translation>%1 aktiv</translation>
    </message>
    <message>
        <source>%1 not active</source>
        <translation>%1 nicht aktiv</translation>
    </message>
    <message>
        <source>output %1 on</source>
        <translation>Ausgang %1 ein</translation>
    </message>
    <message>
        <source>output %1 off</source>
        <translation>Ausgang %1 aus</translation>
    </message>
    <message>
        <source>%1 % of its velocity</source>
        <translation>%1 % der Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>within %1 s</source>
        <translation>binnen %1 s</translation>
    </message>
    <message>
        <source>forever</source>
        <translation>endlos</translation>
    </message>
    <message numerus="yes">
        <source>%n times in all</source>
        <translation>
            <numerusform>insgesamt %n-mal</numerusform>
            <numerusform>insgesamt %n-mal</numerusform>
        </translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>%1 High</translation>
    </message>
    <message>
        <source>%1 low</source>
        <translation>%1 Low</translation>
    </message>
    <message>
        <source>IO%1 high</source>
        <translation>IO%1 High</translation>
    </message>
    <message>
        <source>IO%1 low</source>
        <translation>IO%1 Low</translation>
    </message>
    <message>
        <source>A/D %1 above</source>
        <translation>A/D %1 über</translation>
    </message>
    <message>
        <source>A/D %1 below</source>
        <translation>A/D %1 unter</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Binnen</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeBar</name>
    <message>
        <source>Freezes the display (Ctrl+P). Recording of samples continues.</source>
        <translation>Hält das Bild an (Strg+P). Messwerte werden weiter erfasst.</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C).</source>
        <translation>Zeigt zwei Cursor zum Messen, die sich ziehen lassen (C).</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Statusbits</translation>
    </message>
    <message>
        <source>Shows the status bits of the selected module over time (B).</source>
        <translation>Zeigt die Statusbits des gewählten Moduls über der Zeit (B).</translation>
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
        <source>Time shown by the scope</source>
        <translation>Dargestellte Zeit des Oszilloskops</translation>
    </message>
    <message>
        <source>Sets how much time the scope shows.</source>
        <translation>Wie viel Zeit das Oszilloskop darstellt.</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Zeitraum</translation>
    </message>
    <message>
        <source>Signals…</source>
        <translation>Signale…</translation>
    </message>
    <message>
        <source>Selects signals for the strips (S).</source>
        <translation>Wählt die Signale der Streifen (S).</translation>
    </message>
    <message>
        <source>Waits for a signal or a status bit, and holds the picture around it (T).</source>
        <translation>Wartet auf ein Signal oder ein Statusbit und hält fest, was darum herum war (T).</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu live</translation>
    </message>
    <message>
        <source>Returns to the live display.</source>
        <translation>Zeigt, was die Module jetzt melden.</translation>
    </message>
    <message>
        <source>Source of the picture</source>
        <translation>Quelle des Bilds</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeExport</name>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>&amp;Samples (CSV)…</source>
        <translation>&amp;Messwerte (CSV)…</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard, with its samples if there are only a few.</source>
        <translation>Kopiert das sichtbare Diagramm in die Zwischenablage; mit seinen Messwerten, wenn es wenige sind.</translation>
    </message>
    <message>
        <source>Export from the scope</source>
        <translation>Aus dem Oszilloskop exportieren</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>oszilloskop</translation>
    </message>
    <message>
        <source>All samples of all modules in the visible time. A file with one row per reply can be reopened here; one with a column per signal is for other programs only.</source>
        <translation>Jeder Messwert aller Module in der sichtbaren Zeit. Eine Datei mit einer Zeile je Antwort lässt sich hier wieder öffnen; eine mit einer Spalte je Signal ist nur für andere Programme.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeFiles</name>
    <message>
        <source>Open &amp;recording…</source>
        <translation>&amp;Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Ends the recording and closes its file (Ctrl+Shift+R).</source>
        <translation>Beendet die Aufzeichnung und schließt ihre Datei (Strg+Umschalt+R).</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Cancels opening; the scope stays as it is.</source>
        <translation>Lässt die Datei, wie sie ist; das Oszilloskop bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Shows a recording in the scope. Control of the motors continues.</source>
        <translation>Zeigt eine Aufzeichnung im Oszilloskop. Die Steuerung der Motoren läuft weiter.</translation>
    </message>
    <message>
        <source>Saves every sample of all modules to a file from now on (Ctrl+Shift+R).</source>
        <translation>Schreibt ab jetzt jeden Messwert aller Module in eine Datei (Strg+Umschalt+R).</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Aufzeichnen…</translation>
    </message>
    <message>
        <source>Nothing to record: connect a module first.</source>
        <translation>Nichts aufzuzeichnen: zuerst ein Modul verbinden.</translation>
    </message>
    <message>
        <source>● Recording %1, %2, %3</source>
        <translation>● Zeichnet auf: %1, %2, %3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Opening %1, %2 %</source>
        <translation>Öffnet %1, %2 %</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>In eine Datei aufzeichnen</translation>
    </message>
    <message>
        <source>Recordings (*.%1)</source>
        <translation>Aufzeichnungen (*.%1)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Over&amp;lay a recording…</source>
        <translation>Aufzeichnung unter&amp;legen…</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Unterlegt</translation>
    </message>
    <message>
        <source>Removes the recording from the plots. Its file is kept.</source>
        <translation>Nimmt die Aufzeichnung aus den Kurven. Ihre Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>◂ Earlier</source>
        <translation>◂ Früher</translation>
    </message>
    <message>
        <source>Moves the recording to the left.</source>
        <translation>Verschiebt die Aufzeichnung nach links.</translation>
    </message>
    <message>
        <source>Later ▸</source>
        <translation>Später ▸</translation>
    </message>
    <message>
        <source>Moves the recording to the right.</source>
        <translation>Verschiebt die Aufzeichnung nach rechts.</translation>
    </message>
    <message>
        <source>Draws a recording in pale lines below the live traces, aligned to the start of the last motion.</source>
        <translation>Zeichnet eine Aufzeichnung mit blassen Linien unter die laufenden Kurven, ausgerichtet am Beginn der letzten Bewegung.</translation>
    </message>
    <message>
        <source>Overlay a recording</source>
        <translation>Aufzeichnung unterlegen</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePanel</name>
    <message>
        <source>Exports the visible samples or a picture.</source>
        <translation>Holt das Sichtbare aus dem Oszilloskop: Messwerte oder ein Bild.</translation>
    </message>
    <message>
        <source>Bits of the lane</source>
        <translation>Bits der Statusspur</translation>
    </message>
    <message>
        <source>%1 (simulator)</source>
        <translation>%1 (Simulator)</translation>
    </message>
    <message>
        <source>Saves and restores arrangements of the scope by name.</source>
        <translation>Speichert Anordnungen des Oszilloskops unter Namen und stellt sie wieder her.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePlot</name>
    <message>
        <source>%1 · unknown</source>
        <translation>%1 · unbekannt</translation>
    </message>
    <message>
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The band exceeds the strip: %1 to %2</source>
        <translation>Das Band ist breiter als der Streifen: %1 bis %2</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePresets</name>
    <message>
        <source>Presets</source>
        <translation>Anordnungen</translation>
    </message>
    <message>
        <source>&amp;Remove preset</source>
        <translation>Anordnung &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove preset</source>
        <translation>Anordnung entfernen</translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>Als Anordnung &amp;speichern…</translation>
    </message>
    <message>
        <source>Keeps the present signals, strips, bits and time under a name.</source>
        <translation>Behält die jetzigen Signale, Streifen, Bits und die Zeit unter einem Namen.</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Anordnung speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Replaces the preset of that name.</source>
        <translation>Ersetzt die Anordnung mit diesem Namen.</translation>
    </message>
    <message>
        <source>There are %1 presets, which is the most. Remove one first.</source>
        <translation>Es gibt schon %1 Anordnungen, mehr sind nicht möglich. Zuerst eine entfernen.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeStrips</name>
    <message>
        <source>Plots; arrow keys move, plus and minus zoom</source>
        <translation>Diagramme; Pfeiltasten verschieben, Plus und Minus zoomen</translation>
    </message>
    <message>
        <source>Strip %1 of the scope</source>
        <translation>Streifen %1 des Oszilloskops</translation>
    </message>
    <message>
        <source>Drag to resize the strips. Double-click to make them equal.</source>
        <translation>Ziehen ändert die Höhe der Streifen. Ein Doppelklick macht sie gleich hoch.</translation>
    </message>
</context>
<context>
    <name>nmc::SequencesPage</name>
    <message>
        <source>Rename point</source>
        <translation>Punkt umbenennen</translation>
    </message>
    <message>
        <source>Change row</source>
        <translation>Zeile ändern</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Name of the point to teach</source>
        <translation>Name des Punkts, der geteacht wird</translation>
    </message>
    <message>
        <source>Name of a point</source>
        <translation>Name eines Punkts</translation>
    </message>
    <message>
        <source>Axes to teach</source>
        <translation>Achsen, die geteacht werden</translation>
    </message>
    <message>
        <source>The selected axes become part of the point.</source>
        <translation>Die gewählten Achsen werden Teil des Punkts.</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Teachen</translation>
    </message>
    <message>
        <source>Teach a point: store the positions of the selected axes</source>
        <translation>Teachen: die Positionen der gewählten Achsen speichern</translation>
    </message>
    <message>
        <source>Go to point</source>
        <translation>Zum Punkt</translation>
    </message>
    <message>
        <source>Go to point: the selected one</source>
        <translation>Zum gewählten Punkt fahren</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove point: the selected one</source>
        <translation>Den gewählten Punkt entfernen</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Abläufe</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Ablauf</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>Name des Ablaufs</translation>
    </message>
    <message>
        <source>Type a new name for this sequence, then press Enter.</source>
        <translation>Ein anderer Name für diesen Ablauf; die Eingabetaste übernimmt ihn.</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Neuer Ablauf</translation>
    </message>
    <message>
        <source>Remove sequence</source>
        <translation>Ablauf entfernen</translation>
    </message>
    <message>
        <source>Remove sequence with its rows</source>
        <translation>Diesen Ablauf mit seinen Zeilen entfernen</translation>
    </message>
    <message>
        <source>Rows of the sequence</source>
        <translation>Zeilen des Ablaufs</translation>
    </message>
    <message>
        <source>Double-click a cell or press F2 to edit it.</source>
        <translation>Ein Doppelklick oder F2 ändert, was in einer Zelle steht.</translation>
    </message>
    <message>
        <source>Result of the dry run</source>
        <translation>Ergebnis des Probelaufs</translation>
    </message>
    <message>
        <source>Rename sequence</source>
        <translation>Ablauf umbenennen</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Zeile hinzufügen</translation>
    </message>
    <message>
        <source>Add row after the selected one</source>
        <translation>Eine Zeile hinter der gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate the selected row</source>
        <translation>Die gewählte Zeile duplizieren</translation>
    </message>
    <message>
        <source>Duplicate row</source>
        <translation>Zeile duplizieren</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Zeile entfernen</translation>
    </message>
    <message>
        <source>Remove row: the selected one</source>
        <translation>Zeile entfernen: Die gewählte Zeile entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hinauf</translation>
    </message>
    <message>
        <source>Up: move the selected row</source>
        <translation>Die gewählte Zeile nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Hinunter</translation>
    </message>
    <message>
        <source>Down: move the selected row</source>
        <translation>Die gewählte Zeile nach unten</translation>
    </message>
    <message>
        <source>Undo the last change to points and sequences</source>
        <translation>Die letzte Änderung an Punkten und Abläufen rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the last undone change to points and sequences</source>
        <translation>Wiederherstellen, was an Punkten und Abläufen rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>Dry run: simulate the sequence; nothing moves</source>
        <translation>Den Ablauf an einer simulierten Kopie voraussehen; nichts fährt</translation>
    </message>
    <message>
        <source>Dry run…</source>
        <translation>Probelauf…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Run the sequence</source>
        <translation>Den Ablauf starten</translation>
    </message>
    <message>
        <source>Run from row</source>
        <translation>Ab Zeile starten</translation>
    </message>
    <message>
        <source>Run from row: start at the selected row</source>
        <translation>Den Ablauf ab der gewählten Zeile starten</translation>
    </message>
    <message>
        <source>Pause the sequence after its row</source>
        <translation>Pause: den Ablauf nach seiner Zeile anhalten</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>Einzelschritt</translation>
    </message>
    <message>
        <source>Single step: run one row of the sequence</source>
        <translation>Einzelschritt: eine Zeile des Ablaufs ausführen</translation>
    </message>
    <message>
        <source>Stop sequence</source>
        <translation>Ablauf stoppen</translation>
    </message>
    <message>
        <source>Stop sequence and its motors</source>
        <translation>Den Ablauf und seine Motoren stoppen</translation>
    </message>
    <message>
        <source>Teach point</source>
        <translation>Punkt teachen</translation>
    </message>
    <message>
        <source>Move row</source>
        <translation>Zeile verschieben</translation>
    </message>
    <message>
        <source>Enter a name for the point first.</source>
        <translation>Dem Punkt erst einen Namen geben.</translation>
    </message>
    <message>
        <source>Select at least one axis.</source>
        <translation>Mindestens eine Achse wählen.</translation>
    </message>
    <message>
        <source>Stores the present positions of the selected axes under this name, replacing any point of that name. Nothing moves.</source>
        <translation>Speichert die jetzigen Positionen der gewählten Achsen unter diesem Namen und ersetzt einen Punkt gleichen Namens. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Select a point in the table.</source>
        <translation>Einen Punkt in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses this point. Change that row first.</source>
        <translation>Zeile %1 von „%2“ benutzt diesen Punkt. Zuerst diese Zeile ändern.</translation>
    </message>
    <message>
        <source>Moves all axes of this point there together, each at its own velocity.</source>
        <translation>Fährt alle Achsen dieses Punkts zugleich dorthin, jede mit ihrer eigenen Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Removes this point; nothing moves.</source>
        <translation>Entfernt diesen Punkt; nichts bewegt sich.</translation>
    </message>
    <message>
        <source>No sequence yet. Add one first.</source>
        <translation>Noch kein Ablauf. Zuerst einen hinzufügen.</translation>
    </message>
    <message>
        <source>Select a row in the table.</source>
        <translation>Eine Zeile in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Adds an empty sequence.</source>
        <translation>Fügt einen leeren Ablauf hinzu.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; calls this sequence. Change that row first.</source>
        <translation>Zeile %1 von „%2“ ruft diesen Ablauf auf. Zuerst diese Zeile ändern.</translation>
    </message>
    <message>
        <source>Removes this sequence with its rows.</source>
        <translation>Entfernt diesen Ablauf mit seinen Zeilen.</translation>
    </message>
    <message>
        <source>Adds a row after the selected one, or at the end.</source>
        <translation>Fügt eine Zeile hinter der gewählten oder am Ende hinzu.</translation>
    </message>
    <message>
        <source>Adds a copy of the row after it.</source>
        <translation>Fügt dieselbe Zeile dahinter noch einmal ein.</translation>
    </message>
    <message>
        <source>Removes this row.</source>
        <translation>Entfernt diese Zeile.</translation>
    </message>
    <message>
        <source>The row cannot move farther: a repeat must stay below the row it goes back to.</source>
        <translation>Die Zeile lässt sich nicht weiter verschieben: Eine Wiederholung muss unter der Zeile bleiben, zu der sie zurückgeht.</translation>
    </message>
    <message>
        <source>Moves this row up.</source>
        <translation>Verschiebt diese Zeile nach oben.</translation>
    </message>
    <message>
        <source>Moves this row down.</source>
        <translation>Verschiebt diese Zeile nach unten.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Macht rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Stellt wieder her: %1</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from its first row.</source>
        <translation>Startet „%1“ bei der ersten Zeile.</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from the selected row on. The axes must be where the rows above leave them.</source>
        <translation>Startet „%1“ ab der gewählten Zeile. Die Achsen müssen dort stehen, wo die Zeilen darüber sie lassen.</translation>
    </message>
    <message>
        <source>No sequence is running.</source>
        <translation>Kein Ablauf läuft.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Continues from where it paused.</source>
        <translation>Macht weiter, wo er pausiert hat.</translation>
    </message>
    <message>
        <source>Finishes the current row, then waits.</source>
        <translation>Beendet die laufende Zeile und wartet dann.</translation>
    </message>
    <message>
        <source>The sequence is running. Pause it first.</source>
        <translation>Der Ablauf läuft. Ihn zuerst pausieren.</translation>
    </message>
    <message>
        <source>Runs one row, then waits. Starts with the selected row.</source>
        <translation>Führt eine Zeile aus und wartet dann. Die erste ist die gewählte.</translation>
    </message>
    <message>
        <source>Ends the sequence and stops its motors smoothly.</source>
        <translation>Beendet den Ablauf und stoppt seine Motoren sanft.</translation>
    </message>
    <message>
        <source>End dry run</source>
        <translation>Probelauf beenden</translation>
    </message>
    <message>
        <source>Simulates the sequence: shows how long it takes, where each axis goes and what would be refused. Nothing moves.</source>
        <translation>Zeigt an einer simulierten Kopie, wie lange der Ablauf dauert, wohin jede Achse fährt und was abgelehnt würde. Nichts fährt.</translation>
    </message>
</context>
<context>
    <name>nmc::ServoPanel</name>
    <message>
        <source>Servo module</source>
        <translation>Servomodul</translation>
    </message>
    <message>
        <source>Limits &amp;&amp; I/O</source>
        <translation>Endschalter &amp;&amp; E/A</translation>
    </message>
</context>
<context>
    <name>nmc::SignalsDialog</name>
    <message>
        <source>Signals of the scope</source>
        <translation>Signale des Oszilloskops</translation>
    </message>
    <message>
        <source>Signals and their strips</source>
        <translation>Signale und die Streifen, in denen sie stehen</translation>
    </message>
    <message>
        <source>Strip %1</source>
        <translation>Streifen %1</translation>
    </message>
    <message>
        <source>Select the strips of each signal. Empty strips are hidden.</source>
        <translation>Die Streifen jedes Signals wählen. Leere Streifen werden ausgeblendet.</translation>
    </message>
    <message>
        <source>The selected module</source>
        <translation>Das gewählte Modul</translation>
    </message>
    <message>
        <source>&amp;Usual signals</source>
        <translation>&amp;Übliche Signale</translation>
    </message>
    <message>
        <source>Usual signals</source>
        <translation>Übliche Signale</translation>
    </message>
    <message>
        <source>%1: %2 in strip %3</source>
        <translation>%1: %2 in Streifen %3</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter by module or signal</source>
        <translation>Filter: nach Modul oder Signal</translation>
    </message>
    <message>
        <source>Position and command position, with the error and the motor current below.</source>
        <translation>Die Position mit ihrer Sollposition, darunter Positionsfehler und Motorstrom.</translation>
    </message>
    <message>
        <source>&amp;Custom traces…</source>
        <translation>&amp;Eigene Kurven…</translation>
    </message>
    <message>
        <source>Custom traces</source>
        <translation>Eigene Kurven</translation>
    </message>
    <message>
        <source>Traces of your own, from one or two signals.</source>
        <translation>Eigene Kurven aus einem oder zwei Signalen.</translation>
    </message>
</context>
<context>
    <name>nmc::SimulatorBench</name>
    <message>
        <source>Simulated module</source>
        <translation>Simuliertes Modul</translation>
    </message>
    <message>
        <source>Follows the module list, and includes modules that the panel did not find.</source>
        <translation>Folgt der Modulliste. Enthält auch Module, die das Programm nicht findet.</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumDialog</name>
    <message>
        <source>Peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Spectrum between the cursors</source>
        <translation>Spektrum zwischen den Cursorn</translation>
    </message>
    <message>
        <source>&amp;Signal</source>
        <translation>&amp;Signal</translation>
    </message>
    <message>
        <source>Peak: %1 Hz, amplitude %2 %3</source>
        <translation>Spitze: %1 Hz, Amplitude %2 %3</translation>
    </message>
    <message>
        <source>No oscillation stands out from the noise.</source>
        <translation>Keine Schwingung hebt sich vom Rauschen ab.</translation>
    </message>
    <message>
        <source>From %1 Hz, two periods between the cursors, to %2 Hz, nearly half the rate of the samples.</source>
        <translation>Von %1 Hz, zwei Perioden zwischen den Cursorn, bis %2 Hz, fast der halben Rate der Messwerte.</translation>
    </message>
    <message>
        <source>There is a long gap between the cursors. Move both to the same side of it.</source>
        <translation>Zwischen den Cursorn liegt eine lange Lücke. Beide auf dieselbe Seite der Lücke ziehen.</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>The sines in the signal, by frequency in Hz. The circle marks the highest that stands out from the noise. Double-click to show everything. Scroll to zoom the frequency, or the amplitudes with Ctrl; drag to pan; drag with Shift to select frequencies.</source>
        <translation>Die Sinusschwingungen im Signal, nach Frequenz in Hz. Der Kreis markiert die höchste, die sich vom Rauschen abhebt. Ein Doppelklick zeigt alles. Das Mausrad zoomt die Frequenz, mit Strg die Amplituden; Ziehen verschiebt; Ziehen mit Umschalt wählt Frequenzen.</translation>
    </message>
</context>
<context>
    <name>nmc::SquarePlot</name>
    <message>
        <source>Square wave, one period</source>
        <translation>Rechteck, eine Periode</translation>
    </message>
    <message>
        <source>median, %1</source>
        <translation>Median, %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Sollposition</translation>
    </message>
    <message>
        <source>No edge recorded yet. A square wave overlays many steps while you change gains.</source>
        <translation>Noch ist keine Flanke aufgezeichnet. Ein Rechteck legt viele Sprünge übereinander, während Reglerwerte geändert werden.</translation>
    </message>
    <message>
        <source>All edges with the present gains, overlaid: the line is their median, the shaded band holds 80 % of the samples. Pale: the previous gains. Double-click to show everything. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>Alle Flanken mit den jetzigen Reglerwerten übereinander: ihr Median, und schattiert, wo acht von zehn Messwerten liegen. Blass: mit den Reglerwerten davor. Ein Doppelklick zeigt alles. Das Mausrad zoomt die Zeit, mit Strg die Positionen; Ziehen verschiebt; Ziehen mit Umschalt wählt eine Zeit.</translation>
    </message>
</context>
<context>
    <name>nmc::SquareWavePage</name>
    <message>
        <source>Start test</source>
        <translation>Test starten</translation>
    </message>
    <message>
        <source>The motor jumps back and forth around its position. Make sure that everything it drives can move freely.</source>
        <translation>Der Motor springt um seine Position hin und her. Sicherstellen, dass sich alles, was er antreibt, frei bewegen kann.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>The distance</source>
        <translation>Die Strecke</translation>
    </message>
    <message>
        <source>From side to side: half to either side of the present position.</source>
        <translation>Von Seite zu Seite, je die Hälfte zu beiden Seiten der Stelle, an der der Motor gehalten wird.</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>The period</source>
        <translation>Die Periode</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>Periods to run</source>
        <translation>Die Zahl der Perioden</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>How far the motor may move past either side. Beyond that, the test stops and the motor holds.</source>
        <translation>Wie weit der Motor über jede Seite hinausgehen darf. Darüber hinaus stoppt die Prüfung, und der Motor hält.</translation>
    </message>
    <message>
        <source>Results of the edges</source>
        <translation>Was die Flanken ergeben</translation>
    </message>
    <message>
        <source>Keep as a run</source>
        <translation>Als Lauf behalten</translation>
    </message>
    <message>
        <source>Keep as a run: the median edge</source>
        <translation>Als Lauf behalten: den Median der Flanken</translation>
    </message>
    <message>
        <source>Settling %1</source>
        <translation>Einschwingen %1</translation>
    </message>
    <message>
        <source>No edge recorded yet.</source>
        <translation>Noch ist keine Flanke aufgezeichnet.</translation>
    </message>
    <message>
        <source>Adds the median of the rising edges to the list of step responses.</source>
        <translation>Fügt den Median der steigenden Flanken zur Liste der Sprungantworten hinzu.</translation>
    </message>
    <message>
        <source>Edges with these gains: %1</source>
        <translation>Flanken mit diesen Reglerwerten: %1</translation>
    </message>
</context>
<context>
    <name>nmc::StagedForm</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ gesendet</translation>
    </message>
    <message>
        <source>● not sent</source>
        <translation>● nicht gesendet</translation>
    </message>
    <message>
        <source>Undoes the last edit in these fields. Sends nothing.</source>
        <translation>Macht die letzte Änderung in diesen Feldern rückgängig. Sendet nichts.</translation>
    </message>
    <message>
        <source>Redoes the edit that was undone. Sends nothing.</source>
        <translation>Stellt die rückgängig gemachte Änderung wieder her. Sendet nichts.</translation>
    </message>
    <message>
        <source>No changes to apply.</source>
        <translation>Keine Änderungen.</translation>
    </message>
</context>
<context>
    <name>nmc::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start the simulator</source>
        <translation>Simulator starten</translation>
    </message>
    <message>
        <source>Needs no hardware. Three simulated modules to try everything on; no real motor moves.</source>
        <translation>Braucht keine Hardware. Drei simulierte Module zum Ausprobieren; kein echter Motor bewegt sich.</translation>
    </message>
    <message>
        <source>Connects to the built-in simulator.</source>
        <translation>Verbindet mit dem eingebauten Simulator.</translation>
    </message>
    <message>
        <source>Choose a serial port…</source>
        <translation>Seriellen Port wählen…</translation>
    </message>
    <message>
        <source>No serial port found. Plug in the modules&apos; adapter; it then appears here.</source>
        <translation>Kein serieller Port gefunden. Den Adapter der Module einstecken: Er erscheint hier.</translation>
    </message>
    <message>
        <source>%1 Bd.</source>
        <translation>%1 Bd.</translation>
    </message>
    <message>
        <source>%1, %2 Bd.</source>
        <translation>%1, %2 Bd.</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>Mit %1 verbinden</translation>
    </message>
    <message>
        <source>The modules must be powered and their cable plugged in.</source>
        <translation>Die Module müssen versorgt und ihr Kabel eingesteckt sein.</translation>
    </message>
    <message>
        <source>Other ports are in the list above.</source>
        <translation>Andere Ports stehen in der Liste oben.</translation>
    </message>
</context>
<context>
    <name>nmc::StatusLane</name>
    <message>
        <source>Status bits over time</source>
        <translation>Statusbits über der Zeit</translation>
    </message>
</context>
<context>
    <name>nmc::StepperIoBox</name>
    <message>
        <source>Set all outputs</source>
        <translation>Alle Ausgänge setzen</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Eingänge und Ausgänge</translation>
    </message>
    <message>
        <source>OUT%1</source>
        <translation>OUT%1</translation>
    </message>
    <message>
        <source>Name of output %1</source>
        <translation>Name von Ausgang %1</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>Name of input %1</source>
        <translation>Name von Eingang %1</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoriert</translation>
    </message>
    <message>
        <source>keeps the motor from moving</source>
        <translation>hindert den Motor an der Bewegung</translation>
    </message>
    <message>
        <source>blocks forward</source>
        <translation>sperrt vorwärts</translation>
    </message>
    <message>
        <source>blocks reverse</source>
        <translation>sperrt rückwärts</translation>
    </message>
    <message>
        <source>● %1, not sent</source>
        <translation>● %1, nicht gesendet</translation>
    </message>
    <message>
        <source>Selects the level. Choose Set all outputs to send all five.</source>
        <translation>Wählt den Pegel. „Alle Ausgänge setzen“ sendet alle fünf.</translation>
    </message>
    <message>
        <source>Select a level for all five outputs first.</source>
        <translation>Zuerst alle fünf Ausgänge wählen.</translation>
    </message>
    <message>
        <source>Sends all five outputs as selected above.</source>
        <translation>Sendet alle fünf Ausgänge wie oben gewählt.</translation>
    </message>
    <message>
        <source>Outputs unknown: they cannot be read back. Select all five levels, then set them.</source>
        <translation>Ausgänge unbekannt: Sie lassen sich nicht auslesen. Alle fünf Pegel wählen, dann setzen.</translation>
    </message>
</context>
<context>
    <name>nmc::StepperMotionBox</name>
    <message>
        <source>b&amp;y this distance</source>
        <translation>&amp;um diese Strecke</translation>
    </message>
    <message>
        <source>By this distance from the present position</source>
        <translation>Um diese Strecke ab der jetzigen Position</translation>
    </message>
    <message>
        <source>The speed</source>
        <translation>Die Geschwindigkeit</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Position</translation>
    </message>
    <message>
        <source>Trave&amp;l speed</source>
        <translation>Fahr&amp;geschwindigkeit</translation>
    </message>
    <message>
        <source>Load o&amp;nly</source>
        <translation>Nur &amp;laden</translation>
    </message>
    <message>
        <source>Load only, start later</source>
        <translation>Nur laden: Die Bewegung laden, später starten</translation>
    </message>
    <message>
        <source>Start loaded</source>
        <translation>Geladenes starten</translation>
    </message>
    <message>
        <source>Start loaded motion</source>
        <translation>Geladenes starten: Die geladene Bewegung starten</translation>
    </message>
    <message>
        <source>How fast the motor turns: %1 to %2 in this speed mode. The chip uses the nearest speed available.</source>
        <translation>Wie schnell sich der Motor dreht: %1 bis %2 in diesem Geschwindigkeitsmodus. Der Chip nimmt den nächstliegenden Wert, den er kann.</translation>
    </message>
    <message>
        <source>At constant speed, without a ramp.</source>
        <translation>Mit konstanter Geschwindigkeit, ohne Rampe.</translation>
    </message>
    <message>
        <source>Takes %1 s from standstill.</source>
        <translation>Dauert %1 s aus dem Stillstand.</translation>
    </message>
    <message>
        <source>Stop, wait: %1</source>
        <translation>Stopp, warten: %1</translation>
    </message>
    <message>
        <source>Loads the motion without starting it.</source>
        <translation>Lädt die Bewegung, ohne sie zu starten.</translation>
    </message>
    <message>
        <source>Load &amp;reverse</source>
        <translation>Rüc&amp;kwärts laden</translation>
    </message>
    <message>
        <source>Load forward</source>
        <translation>Vorwärts laden</translation>
    </message>
    <message>
        <source>Starts the loaded motion.</source>
        <translation>Startet die zuletzt geladene Bewegung.</translation>
    </message>
    <message>
        <source>A run has no goal.</source>
        <translation>Ein Dauerlauf hat kein Ziel.</translation>
    </message>
    <message>
        <source>The goal of the move. Press Enter to start.</source>
        <translation>Das Ziel der Fahrt. Die Eingabetaste startet sie.</translation>
    </message>
    <message>
        <source>The distance counts from where the motor is at the start.</source>
        <translation>Die Strecke zählt von dort, wo der Motor beim Start steht.</translation>
    </message>
    <message>
        <source>The buttons only load the motion. Choose Start loaded, or start the module&apos;s group.</source>
        <translation>Die Tasten senden die Bewegung, ohne sie zu starten; das tut „Geladenes starten“ oder die Gruppe.</translation>
    </message>
    <message>
        <source>No ramp.</source>
        <translation>Keine Rampe.</translation>
    </message>
    <message>
        <source>Stops smoothly, waits until the motor is at rest, then: %1</source>
        <translation>Stoppt sanft, wartet, bis der Motor steht, dann: %1</translation>
    </message>
    <message>
        <source>Moves to home with a ramp, at the travel speed.</source>
        <translation>Fährt mit Rampe zur Referenz, mit der Fahrgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>Moves to a position with ramps (trapezoidal profile mode).</source>
        <translation>Fährt mit Rampen zu einer Position (Modus Trapezprofil).</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Dauerlauf</translation>
    </message>
    <message>
        <source>Ramps to a speed and keeps it until stopped (velocity profile mode).</source>
        <translation>Fährt über eine Rampe auf eine Geschwindigkeit und behält sie bis zum Stopp (Modus Geschwindigkeitsprofil).</translation>
    </message>
    <message>
        <source>Move without ramp</source>
        <translation>Fahrt ohne Rampe</translation>
    </message>
    <message>
        <source>Moves to a position at constant speed, without ramps. At too high a speed the motor loses steps (unprofiled, with stop).</source>
        <translation>Fährt mit konstanter Geschwindigkeit ohne Rampen zu einer Position. Bei zu hoher Geschwindigkeit verliert der Motor Schritte (ohne Profil, mit Stopp).</translation>
    </message>
    <message>
        <source>Run without ramp</source>
        <translation>Dauerlauf ohne Rampe</translation>
    </message>
    <message>
        <source>Runs at constant speed, without a ramp, until stopped. At too high a speed the motor loses steps (unprofiled, without stop).</source>
        <translation>Läuft mit konstanter Geschwindigkeit ohne Rampe bis zum Stopp. Bei zu hoher Geschwindigkeit verliert der Motor Schritte (ohne Profil, ohne Stopp).</translation>
    </message>
    <message>
        <source>Kind of motion</source>
        <translation>Art der Bewegung</translation>
    </message>
</context>
<context>
    <name>nmc::StepperPanel</name>
    <message>
        <source>Stepper module</source>
        <translation>Schrittmotormodul</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/A</translation>
    </message>
</context>
<context>
    <name>nmc::StepperParametersBox</name>
    <message>
        <source>ignored: no motor stop</source>
        <translation>ignoriert: kein Motorstopp</translation>
    </message>
    <message>
        <source>motor switches off, too</source>
        <translation>der Motor wird auch abgeschaltet</translation>
    </message>
    <message>
        <source>&amp;Apply parameters</source>
        <translation>Alle ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Revert the parameters to those last sent</source>
        <translation>Parameter auf die gesendeten zurücksetzen</translation>
    </message>
    <message>
        <source>Apply parameters: all</source>
        <translation>Alle übernehmen: Alle Parameter übernehmen</translation>
    </message>
    <message>
        <source>Fills in low speeds and currents to start with. Sends nothing.</source>
        <translation>Füllt die Felder mit kleinen Geschwindigkeiten und Strömen für den Anfang. Sendet nichts.</translation>
    </message>
    <message>
        <source>Choose a speed mode.</source>
        <translation>Einen Geschwindigkeitsmodus wählen.</translation>
    </message>
    <message>
        <source>Parameters cannot be read back from the module. The motor moves only after you apply them.</source>
        <translation>Parameter sind aus dem Modul nicht auslesbar. Der Motor bewegt sich erst, wenn sie angewendet sind.</translation>
    </message>
    <message>
        <source>If checked, the E-stop input does not stop the motor.</source>
        <translation>Mit Haken stoppt der E-Stop-Eingang den Motor nicht.</translation>
    </message>
    <message>
        <source>If checked, the limit switches do not stop the motor.</source>
        <translation>Mit Haken stoppen die Endschalter den Motor nicht.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.</source>
        <translation>Sendet alle Parameter auf einmal. Der Verstärker ist ein: Ströme und Grenzen wirken sofort.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The motor does not move.</source>
        <translation>Sendet alle Parameter auf einmal. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Restores the parameters last sent. Sends nothing.</source>
        <translation>Stellt die zuletzt gesendeten Parameter wieder her. Sendet nichts.</translation>
    </message>
    <message>
        <source>Clears the fields: no parameters have been sent yet. Sends nothing.</source>
        <translation>Leert die Felder: Es wurden noch keine Parameter gesendet. Sendet nichts.</translation>
    </message>
    <message>
        <source>Undo the last edit of a parameter</source>
        <translation>Die letzte Änderung eines Parameters rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the edit of a parameter</source>
        <translation>Die Änderung eines Parameters wiederherstellen</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>Geschwindigkeitsmodus</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Min. Profilgeschwindigkeit</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>Fahrstrom</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>Haltestrom</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>Temperaturgrenze</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>Endschalter</translation>
    </message>
    <message>
        <source>On limit or E-stop</source>
        <translation>Bei Endschalter oder E-Stop</translation>
    </message>
    <message>
        <source>The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.</source>
        <translation>Der Takt des Schritt-Timers. Ein schnellerer Takt erreicht höhere Geschwindigkeiten in gröberen Stufen: den langsamsten nehmen, der schnell genug ist. Ein Wechsel ändert die Bedeutung jeder Geschwindigkeit und Rampe.</translation>
    </message>
    <message>
        <source>The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.</source>
        <translation>Die Geschwindigkeit, bei der Rampen beginnen und enden. Der Motor muss mit ihr ohne Schrittverlust anfahren und anhalten können. Dauerlauf und Fahrten mit Rampe sind nie langsamer.</translation>
    </message>
    <message>
        <source>Motor current while moving; 255 is the driver&apos;s full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.</source>
        <translation>Motorstrom während der Bewegung; 255 ist der volle Strom des Treibers. 0: kein Strom, und der Motor folgt nicht. Die Nennwerte von Motor und Treiber nicht überschreiten.</translation>
    </message>
    <message>
        <source>Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and no holding torque.</source>
        <translation>Motorstrom im Stillstand, ab etwa 0,25 s nach einer Bewegung. Meist kleiner als der Fahrstrom, damit der Motor kühl bleibt. 0: kein Strom und kein Haltemoment.</translation>
    </message>
    <message>
        <source>The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.</source>
        <translation>Das Modul schaltet den Motor ab, wenn der A/D-Wert unter diese Grenze fällt: Die Spannung einer Thermistorbrücke sinkt, wenn der Motor wärmer wird. 0: aus. Um die richtige Grenze zu finden, den A/D-Wert eines warmen Motors beobachten.</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches do not stop the motor, and it can run into the end of its travel.</source>
        <translation>Normalerweise stoppt der Chip den Motor vorwärts am Endschalter 1 und rückwärts am Endschalter 2. Werden die Schalter ignoriert, stoppen sie den Motor nicht, und er kann in das Ende seines Fahrwegs laufen.</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor when its E-stop input goes high. When ignored, the input does not stop the motor.</source>
        <translation>Normalerweise stoppt der Chip den Motor, wenn sein E-Stop-Eingang auf High geht. Wird der Eingang ignoriert, stoppt er den Motor nicht.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.</source>
        <translation>Ein Endschalter oder der E-Stop-Eingang schaltet den Motor zusätzlich ab: Er ist dann frei drehbar, und eine Last kann absinken.</translation>
    </message>
    <message>
        <source>A/D now %1</source>
        <translation>A/D jetzt %1</translation>
    </message>
    <message>
        <source>off; %1</source>
        <translation>aus; %1</translation>
    </message>
    <message>
        <source>no current</source>
        <translation>kein Strom</translation>
    </message>
    <message>
        <source>%1 % of full</source>
        <translation>%1 % des Maximums</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>The acceleration time</source>
        <translation>Die Beschleunigungszeit</translation>
    </message>
    <message>
        <source>How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it.</source>
        <translation>Wie lange eine Rampe bei jeder Geschwindigkeit bleibt, in 0,25 ms: je kleiner, desto steiler. Wird mit der nächsten Bewegung mit Rampe gesendet und gilt für einen sanften Stopp danach.</translation>
    </message>
    <message>
        <source>Jog is never faster than this. Set a speed that you can react to.</source>
        <translation>Tippen ist nie schneller. So einstellen, dass man noch reagieren kann.</translation>
    </message>
    <message>
        <source>With every motion</source>
        <translation>Mit jeder Bewegung</translation>
    </message>
    <message>
        <source>× 0.25 ms</source>
        <translation>× 0,25 ms</translation>
    </message>
</context>
<context>
    <name>nmc::StopButton</name>
    <message>
        <source>STOP ALL  Esc</source>
        <translation>ALLES STOPP  Esc</translation>
    </message>
    <message>
        <source>STOP ALL  Esc: stop all motors</source>
        <translation>Alle Motoren stoppen, Taste Esc</translation>
    </message>
    <message>
        <source>Stops every motor. Unavailable: no port is open.</source>
        <translation>Stoppt jeden Motor. Nicht verfügbar: Kein Port ist offen.</translation>
    </message>
    <message>
        <source>Stops every motor on this line at once; Esc does the same from anywhere. It %1.
It works only while the link works: fit a hardware stop as well.</source>
        <translation>Stoppt jeden Motor an dieser Leitung sofort; Esc wirkt überall ebenso. Der Befehl %1.
Das wirkt nur, solange die Verbindung besteht: zusätzlich einen Hardware-Stopp vorsehen.</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
</context>
<context>
    <name>nmc::StretchDialog</name>
    <message>
        <source>These samples are no longer kept individually. Move the cursors to newer ones.</source>
        <translation>Diese Messwerte sind nicht mehr einzeln vorhanden. Die Cursor zu neueren ziehen.</translation>
    </message>
    <message>
        <source>%1 samples are between the cursors, and %2 are the most. Move the cursors closer together.</source>
        <translation>Zwischen den Cursorn liegen %1 Messwerte, höchstens %2 sind möglich. Die Cursor näher zusammenziehen.</translation>
    </message>
    <message>
        <source>Too few samples are between the cursors. Move them farther apart.</source>
        <translation>Zwischen den Cursorn liegen zu wenige Messwerte. Die Cursor weiter auseinanderziehen.</translation>
    </message>
</context>
<context>
    <name>nmc::TestForm</name>
    <message>
        <source>End test</source>
        <translation>Test beenden</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Wie der Test läuft</translation>
    </message>
    <message>
        <source>The test is already running.</source>
        <translation>Die Prüfung läuft schon.</translation>
    </message>
    <message>
        <source>The test is not running.</source>
        <translation>Die Prüfung läuft nicht.</translation>
    </message>
</context>
<context>
    <name>nmc::TracesDialog</name>
    <message>
        <source>Custom traces</source>
        <translation>Eigene Kurven</translation>
    </message>
    <message>
        <source>Each trace is the sum of one or two signals, each times a factor. Values are taken in the units in which the signals are shown; a negative factor subtracts.</source>
        <translation>Jede Kurve ist die Summe von einem oder zwei Signalen, jedes mal einem Faktor. Es gelten die Einheiten, in denen die Signale angezeigt werden; ein negativer Faktor zieht ab.</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Second signal</source>
        <translation>Zweites Signal</translation>
    </message>
    <message>
        <source>Low-pass, Hz</source>
        <translation>Tiefpass, Hz</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>An&amp;wenden</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>%1, trace %2</source>
        <translation>%1, Kurve %2</translation>
    </message>
    <message>
        <source>The name in the legend. Without one, there is no such trace.</source>
        <translation>Der Name in der Legende. Ohne Namen gibt es die Kurve nicht.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Selected module</source>
        <translation>Gewähltes Modul</translation>
    </message>
    <message>
        <source>Smooths the trace: what is faster than this frequency is attenuated, and the trace lags behind. Empty: no filter.</source>
        <translation>Glättet die Kurve: was schneller als diese Frequenz ist, wird gedämpft, und die Kurve eilt nach. Leer: kein Filter.</translation>
    </message>
    <message>
        <source>Shown beside the name.</source>
        <translation>Steht neben dem Namen.</translation>
    </message>
    <message>
        <source>Factor of: %1</source>
        <translation>Faktor von: %1</translation>
    </message>
    <message>
        <source>The signal is multiplied by it.</source>
        <translation>Das Signal wird damit multipliziert.</translation>
    </message>
    <message>
        <source>A factor must not be 0.</source>
        <translation>Ein Faktor darf nicht 0 sein.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>nmc::TravelBox</name>
    <message>
        <source>State of the travel limits</source>
        <translation>Zustand der Fahrweggrenzen</translation>
    </message>
    <message>
        <source>Counted from home. No motion passes it while home is known. Empty: no limit.</source>
        <translation>Ab der Referenz gezählt. Solange die Referenz bekannt ist, geht keine Bewegung darüber hinaus. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>Here: make the present position the lowest</source>
        <translation>Hier: die jetzige Position als tiefste setzen</translation>
    </message>
    <message>
        <source>Here: make the present position the highest</source>
        <translation>Hier: die jetzige Position als höchste setzen</translation>
    </message>
    <message>
        <source>Limits moves, runs, steps, jog and homing. Empty: the module&apos;s maximum.</source>
        <translation>Begrenzt Fahrten, Dauerlauf, Schritte, Tippen und Referenzfahrt. Leer: der Höchstwert des Moduls.</translation>
    </message>
    <message>
        <source>Slightly more than the play between motor and load. A move from the other side overshoots its goal by this distance and comes back. Empty: none.</source>
        <translation>Etwas mehr als das Spiel zwischen Motor und Last. Eine Fahrt von der anderen Seite geht um diese Strecke über ihr Ziel hinaus und kommt zurück. Leer: keines.</translation>
    </message>
    <message>
        <source>Approach direction of every goal</source>
        <translation>Seite, von der jedes Ziel angefahren wird</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>von unten</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>Go, Go home, steps, points and sequences approach their goals from this side. Loaded moves and paths go straight to theirs.</source>
        <translation>„Anfahren“, „Zur Referenz“, Schritte, Punkte und Abläufe kommen von dieser Seite an ihr Ziel. Geladene Fahrten und Bahnen gehen direkt.</translation>
    </message>
    <message>
        <source>Confirm position…</source>
        <translation>Position bestätigen…</translation>
    </message>
    <message>
        <source>Confirm position as correct</source>
        <translation>Position als richtig bestätigen</translation>
    </message>
    <message>
        <source>Position in doubt</source>
        <translation>Position zweifelhaft</translation>
    </message>
    <message>
        <source>Position in doubt: it may be wrong</source>
        <translation>Position zweifelhaft: sie kann falsch sein</translation>
    </message>
    <message>
        <source>Confirm the position</source>
        <translation>Position bestätigen</translation>
    </message>
    <message>
        <source>Position &amp;is right</source>
        <translation>Position &amp;stimmt</translation>
    </message>
    <message>
        <source>The lowest position must be below the highest. The old value is kept.</source>
        <translation>Die tiefste Position muss unter der höchsten liegen. Was vorher gesetzt war, bleibt.</translation>
    </message>
    <message>
        <source>Sets the lowest position to the present position.</source>
        <translation>Setzt die tiefste Position auf die jetzige.</translation>
    </message>
    <message>
        <source>Sets the highest position to the present position.</source>
        <translation>Setzt die höchste Position auf die jetzige.</translation>
    </message>
    <message>
        <source>Confirms that the position is right: home is at position 0. Asks first.</source>
        <translation>Bestätigt, dass die Position stimmt: Die Referenz liegt bei Position 0. Fragt vorher.</translation>
    </message>
    <message>
        <source>Marks home as unknown. The travel limits are not in force until home is known again.</source>
        <translation>Markiert die Referenz als unbekannt. Bis sie wieder bekannt ist, gelten die Fahrweggrenzen nicht.</translation>
    </message>
    <message>
        <source>With this backlash, no move can end at home: it would reverse beyond the limit. Move the limit away from home, or change the backlash or its direction.</source>
        <translation>Mit diesem Spiel kann keine Fahrt an der Referenz enden: Sie würde jenseits der Grenze umkehren. Die Grenze von der Referenz wegsetzen, oder das Spiel oder seine Richtung ändern.</translation>
    </message>
    <message>
        <source>Arrival tolerance</source>
        <translation>Ankunftstoleranz</translation>
    </message>
    <message>
        <source>Sequences, and programs that wait, go on when the motor has stayed this close to its goal for the time beside it. Empty: when it stands still.</source>
        <translation>Abläufe und wartende Programme gehen weiter, wenn der Motor so lange wie daneben angegeben so nah am Ziel geblieben ist. Leer: wenn er stillsteht.</translation>
    </message>
    <message>
        <source>Time within the arrival tolerance</source>
        <translation>Zeit innerhalb der Ankunftstoleranz</translation>
    </message>
    <message>
        <source>How long the motor must stay within the tolerance.</source>
        <translation>Wie lange der Motor innerhalb der Toleranz bleiben muss.</translation>
    </message>
    <message>
        <source>Arrival within</source>
        <translation>Ankunft innerhalb</translation>
    </message>
    <message>
        <source>for</source>
        <translation>für</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerBar</name>
    <message>
        <source>Trigger on</source>
        <translation>Trigger auf</translation>
    </message>
    <message>
        <source>The signal or status bit to wait for.</source>
        <translation>Das Signal oder Statusbit, auf das gewartet wird.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>The event to wait for.</source>
        <translation>Das Ereignis, auf das gewartet wird.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>The level for the event.</source>
        <translation>Die Schwelle für das Ereignis.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Single: holds the first picture. Normal: shows picture after picture.</source>
        <translation>Einzeln: hält das erste Bild. Normal: zeigt Bild um Bild.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>Share of the picture before the trigger, in percent.</source>
        <translation>Anteil des Bildes vor dem Trigger, in Prozent.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>State of the trigger</source>
        <translation>Zustand des Triggers</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>rises to</source>
        <translation>steigt auf</translation>
    </message>
    <message>
        <source>falls to</source>
        <translation>fällt auf</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>liegt über</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>liegt unter</translation>
    </message>
    <message>
        <source>becomes 1</source>
        <translation>wird 1</translation>
    </message>
    <message>
        <source>becomes 0</source>
        <translation>wird 0</translation>
    </message>
    <message>
        <source>is 1</source>
        <translation>ist 1</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>ist 0</translation>
    </message>
    <message>
        <source>No module connected.</source>
        <translation>Kein Modul verbunden.</translation>
    </message>
    <message>
        <source>Choose a mode first.</source>
        <translation>Zuerst einen Modus wählen.</translation>
    </message>
    <message>
        <source>Waits for the next trigger.</source>
        <translation>Wartet ab jetzt auf den nächsten Trigger.</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerControl</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>triggered %1, more samples to come</source>
        <translation>ausgelöst um %1, weitere Messwerte folgen</translation>
    </message>
    <message>
        <source>triggered %1</source>
        <translation>ausgelöst um %1</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerRecords</name>
    <message>
        <source>Save each picture…</source>
        <translation>Jedes Bild speichern…</translation>
    </message>
    <message>
        <source>Save each picture</source>
        <translation>Jedes Bild speichern</translation>
    </message>
    <message>
        <source>Saves the samples of each picture to a folder that you choose.</source>
        <translation>Speichert die Messwerte jedes Bildes in einem Ordner, der gewählt wird.</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>Behalten werden die letzten</translation>
    </message>
    <message>
        <source>How many files are kept. Then the oldest is replaced.</source>
        <translation>Wie viele Dateien behalten werden. Danach wird die älteste ersetzt.</translation>
    </message>
    <message>
        <source>Saved pictures</source>
        <translation>Gespeicherte Bilder</translation>
    </message>
    <message>
        <source>Save each picture to a folder</source>
        <translation>Jedes Bild in einem Ordner speichern</translation>
    </message>
    <message>
        <source>%1 taken for %2</source>
        <translation>%1 aufgenommen für %2</translation>
    </message>
</context>
<context>
    <name>nmc::TuningFiles</name>
    <message>
        <source>PIC-SERVO, version %1, address %2</source>
        <translation>PIC-SERVO, Version %1, Adresse %2</translation>
    </message>
    <message>
        <source>%1, %2 Bd</source>
        <translation>%1, %2 Bd</translation>
    </message>
    <message>
        <source>Save the tuning report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
</context>
<context>
    <name>nmc::UnitDialog</name>
    <message>
        <source>Calculate the unit</source>
        <translation>Einheit berechnen</translation>
    </message>
    <message>
        <source>Type of axis</source>
        <translation>Art der Achse</translation>
    </message>
    <message>
        <source>rotary, in turns</source>
        <translation>drehend, in Umdrehungen</translation>
    </message>
    <message>
        <source>rotary, in degrees</source>
        <translation>drehend, in Grad</translation>
    </message>
    <message>
        <source>linear, in millimetres</source>
        <translation>linear, in Millimetern</translation>
    </message>
    <message>
        <source>The unit to display for this axis.</source>
        <translation>Worin diese Achse abgelesen werden soll.</translation>
    </message>
    <message>
        <source>The axis</source>
        <translation>Die Achse</translation>
    </message>
    <message>
        <source>Full steps per motor turn</source>
        <translation>Vollschritte des Motors je Umdrehung</translation>
    </message>
    <message>
        <source>200 for a motor with 1.8 degrees per step.</source>
        <translation>200 bei einem Motor mit 1,8 Grad je Schritt.</translation>
    </message>
    <message>
        <source>Microsteps per full step</source>
        <translation>Mikroschritte je Vollschritt</translation>
    </message>
    <message>
        <source>As set on the driver; 1 for full steps, 2 for half steps.</source>
        <translation>Wie am Treiber eingestellt; 1 für Vollschritte, 2 für Halbschritte.</translation>
    </message>
    <message>
        <source>Encoder lines per turn</source>
        <translation>Striche des Encoders je Umdrehung</translation>
    </message>
    <message>
        <source>As on its label: lines, CPR or PPR. The chip counts four per line.</source>
        <translation>Wie auf seinem Typenschild: Striche, CPR oder PPR. Der Chip zählt vier je Strich.</translation>
    </message>
    <message>
        <source>Gear: motor turns</source>
        <translation>Getriebe: Umdrehungen des Motors</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 50; without a gear, 1.</source>
        <translation>Bei einem Getriebe 50 : 1 hier 50 eingeben; ohne Getriebe 1.</translation>
    </message>
    <message>
        <source>Gear: output turns</source>
        <translation>Getriebe: Umdrehungen am Abtrieb</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 1.</source>
        <translation>Bei einem Getriebe 50 : 1 hier 1 eingeben.</translation>
    </message>
    <message>
        <source>Travel per output turn (mm)</source>
        <translation>Weg je Umdrehung am Abtrieb (mm)</translation>
    </message>
    <message>
        <source>Lead screw: pitch times starts. Belt: pulley teeth times belt pitch. Rack: pinion teeth times rack pitch.</source>
        <translation>Spindel: Steigung mal Gangzahl. Riemen: Zähne der Scheibe mal Teilung des Riemens. Zahnstange: Zähne des Ritzels mal Teilung der Zahnstange.</translation>
    </message>
    <message>
        <source>Calculated unit</source>
        <translation>Die Einheit, die sich ergibt</translation>
    </message>
    <message>
        <source>Use this unit</source>
        <translation>Diese Einheit übernehmen</translation>
    </message>
    <message>
        <source>Enter a number above 0 in each field.</source>
        <translation>In jedes Feld eine Zahl über 0 eingeben.</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Inkremente</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Umdrehung</translation>
    </message>
    <message>
        <source>1 %1 is %2 %3. The smallest step is %4 %5.</source>
        <translation>1 %1 sind %2 %3. Der kleinste Schritt ist %4 %5.</translation>
    </message>
    <message>
        <source>Sets this unit for the axis. Keeps every physical value and sends nothing.</source>
        <translation>Setzt diese Einheit für die Achse. Jede physikalische Größe bleibt erhalten; es wird nichts gesendet.</translation>
    </message>
</context>
<context>
    <name>nmc::WorkBox</name>
    <message>
        <source>Positions count from this work offset</source>
        <translation>Positionen zählen ab diesem Nullpunktversatz</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Aufheben</translation>
    </message>
    <message>
        <source>Clear work offset: positions count by the counter</source>
        <translation>Aufheben: Positionen zählen nach dem Zähler</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete work offset</source>
        <translation>Löschen: Nullpunktversatz löschen</translation>
    </message>
    <message>
        <source>Count from</source>
        <translation>Zählen ab</translation>
    </message>
    <message>
        <source>Number for the present position</source>
        <translation>Zahl für die jetzige Position</translation>
    </message>
    <message>
        <source>What the present position is to be called, in the unit of the axis.</source>
        <translation>Wie die jetzige Position heißen soll, in der Einheit der Achse.</translation>
    </message>
    <message>
        <source>Name of the work offset</source>
        <translation>Name des Nullpunktversatzes</translation>
    </message>
    <message>
        <source>The name by which you choose it later.</source>
        <translation>Der Name, unter dem er später gewählt wird.</translation>
    </message>
    <message>
        <source>For example: fixture A</source>
        <translation>Zum Beispiel: Vorrichtung A</translation>
    </message>
    <message>
        <source>Call this position</source>
        <translation>Position so nennen</translation>
    </message>
    <message>
        <source>Call this position: make a work offset</source>
        <translation>Position so nennen: einen Nullpunktversatz anlegen</translation>
    </message>
    <message>
        <source>This position is</source>
        <translation>Diese Position ist</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first, and call its position then.</source>
        <translation>Der Motor bewegt sich. Zuerst anhalten, dann seine Position benennen.</translation>
    </message>
    <message>
        <source>Enter a name for the work offset, for example of a fixture.</source>
        <translation>Einen Namen für den Nullpunktversatz eingeben, zum Beispiel den einer Vorrichtung.</translation>
    </message>
    <message>
        <source>Another work offset of this axis has this name. Delete that one, or enter another name.</source>
        <translation>Ein anderer Nullpunktversatz dieser Achse heißt so. Diesen löschen oder einen anderen Namen eingeben.</translation>
    </message>
    <message>
        <source>This axis has as many work offsets as it can have. Delete one first.</source>
        <translation>Diese Achse hat schon so viele Nullpunktversätze wie möglich. Zuerst einen löschen.</translation>
    </message>
    <message>
        <source>With this number, the work offset would be outside the position range.</source>
        <translation>Mit dieser Zahl läge der Nullpunktversatz außerhalb des Positionsbereichs.</translation>
    </message>
    <message>
        <source>the counter</source>
        <translation>dem Zähler</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1: nicht bekannt</translation>
    </message>
    <message>
        <source>Where the positions on the screen count from. Nothing moves, and nothing is sent.</source>
        <translation>Ab wo die Positionen am Bildschirm zählen. Nichts bewegt sich, und nichts wird gesendet.</translation>
    </message>
    <message>
        <source>No work offset is in use.</source>
        <translation>Kein Nullpunktversatz ist in Gebrauch.</translation>
    </message>
    <message>
        <source>Positions count by the counter again. Nothing moves.</source>
        <translation>Positionen zählen wieder nach dem Zähler. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Choose the work offset first.</source>
        <translation>Zuerst den Nullpunktversatz wählen.</translation>
    </message>
    <message>
        <source>Deletes the work offset from the machine. Nothing moves.</source>
        <translation>Löscht den Nullpunktversatz aus der Maschine. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Positions then count from there. Nothing moves; counter and home stay.</source>
        <translation>Positionen zählen dann von dort. Nichts bewegt sich; Zähler und Referenz bleiben.</translation>
    </message>
    <message>
        <source>Home is unknown: an offset lasts only until home or the counter changes, and is not kept.</source>
        <translation>Die Referenz ist unbekannt: ein Versatz gilt nur, bis sich Referenz oder Zähler ändern, und wird nicht behalten.</translation>
    </message>
</context>
<context>
    <name>nmc::XyDialog</name>
    <message>
        <source>One signal over another, between the cursors</source>
        <translation>Ein Signal über einem anderen, zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagerecht</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>&amp;Waagerecht</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>&amp;Senkrecht</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 über %2</translation>
    </message>
</context>
<context>
    <name>nmc::XyPlot</name>
    <message>
        <source>One signal over another</source>
        <translation>Ein Signal über einem anderen</translation>
    </message>
    <message>
        <source>Each sample of the vertical signal, over the value of the horizontal one at the same time. The dot marks the last one. Double-click to show everything. Scroll to zoom horizontally, or vertically with Ctrl; drag to pan.</source>
        <translation>Jeder Messwert des senkrechten Signals über dem Wert des waagerechten zur selben Zeit. Der Punkt markiert den letzten. Ein Doppelklick zeigt alles. Das Mausrad zoomt waagerecht, mit Strg senkrecht; Ziehen verschiebt.</translation>
    </message>
</context>
</TS>
