<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Chain</name>
    <message>
        <source>Not connected, so nothing is known of the chain.</source>
        <translation>Nicht verbunden, daher ist über die Kette nichts bekannt.</translation>
    </message>
    <message>
        <source>All is well: %1.</source>
        <translation>Alles in Ordnung: %1.</translation>
    </message>
    <message>
        <source>No module answers.</source>
        <translation>Kein Modul antwortet.</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered.</source>
        <translation>%1 von %2 Modulen haben geantwortet.</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered, and the far end of the chain is not among them.</source>
        <translation>%1 von %2 Modulen haben geantwortet, und das ferne Ende der Kette ist nicht darunter.</translation>
    </message>
    <message>
        <source>%1 is another one than expected.</source>
        <translation>%1 ist ein anderes als erwartet.</translation>
    </message>
    <message>
        <source>There are more modules than expected: %1 instead of %2.</source>
        <translation>Es sind mehr Module als erwartet: %1 statt %2.</translation>
    </message>
    <message>
        <source>%1 does not answer any more. Its motor&apos;s state is unknown.</source>
        <translation>%1 antwortet nicht mehr. Sein Motorzustand ist unbekannt.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and gains are lost.</source>
        <translation>%1 ist neu gestartet: Position und Reglerwerte sind verloren.</translation>
    </message>
    <message>
        <source>Choose a port and connect.</source>
        <translation>Einen Port wählen und verbinden.</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain, one loose cable hides all modules; the ADDR_IN jumper of the module farthest from the PC.</source>
        <translation>Der Reihe nach prüfen: Versorgung der Module; jedes Kabel der Kette, ein loses Kabel verbirgt alle Module; den ADDR_IN-Jumper des vom PC am weitesten entfernten Moduls.</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.</source>
        <translation>Die Nummerierung beginnt am fernen Ende. Deshalb das nächste Modul in Richtung PC nach %1 prüfen: zuerst seine Versorgung, dann den Stecker dazwischen. Dann erneut suchen.</translation>
    </message>
    <message>
        <source>What answers are the modules nearest the PC, with new numbers. Look at the cable to the module at the far end, and whether another ADDR_IN is grounded now. Their settings belong to other places until this is mended.</source>
        <translation>Es antworten die Module, die dem PC am nächsten sind, mit neuen Nummern. Das Kabel zum Modul am fernen Ende prüfen, und ob jetzt ein anderes ADDR_IN auf Masse liegt. Bis das behoben ist, gehören ihre Einstellungen zu anderen Plätzen.</translation>
    </message>
    <message>
        <source>Settings that belong to the expected one are not applied here. If it was exchanged on purpose, take what is there as expected.</source>
        <translation>Einstellungen, die zum erwarteten Modul gehören, werden hier nicht angewendet. Wurde es absichtlich getauscht, das Vorhandene als erwartet übernehmen.</translation>
    </message>
    <message>
        <source>From %1 on they are new. If they are meant to be there, take what is there as expected.</source>
        <translation>Ab %1 sind sie neu. Gehören sie dorthin, das Vorhandene als erwartet übernehmen.</translation>
    </message>
    <message>
        <source>Check its power and the cable towards it; use the hardware stop if its motor moves. It is asked again by itself, rarely.</source>
        <translation>Seine Versorgung und das Kabel zu ihm prüfen; den Hardware-Stopp benutzen, wenn sein Motor sich bewegt. Es wird von selbst weiter abgefragt, aber selten.</translation>
    </message>
    <message>
        <source>Modules from it towards the PC may be deaf until it has its address again. When all motors may stand still and lose their positions, restart the network.</source>
        <translation>Module von ihm in Richtung PC sind möglicherweise nicht ansprechbar, bis es wieder seine Adresse hat. Wenn alle Motoren stillstehen und ihre Positionen verlieren dürfen, das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>another one</source>
        <translation>ein anderes</translation>
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
        <source>restarted</source>
        <translation>neu gestartet</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>keine Gruppe</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>Nothing is known of this chain yet: it has %1.</source>
        <translation>Von dieser Kette ist noch nichts bekannt: Sie hat %1.</translation>
    </message>
    <message>
        <source>Compare them with the labels on the modules, the one farthest from the PC first. If all are there, take them as expected: whatever is missing or another one is noticed from then on.</source>
        <translation>Mit den Aufschriften der Module vergleichen, das vom PC am weitesten entfernte zuerst. Sind alle da, sie als erwartet übernehmen: Von da an fällt auf, was fehlt oder ein anderes ist.</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Control panel for Networked Modular Control motor modules.</source>
        <translation>Bedienprogramm für Motormodule nach Networked Modular Control (NMC).</translation>
    </message>
    <message>
        <source>Connect to a serial port at once.</source>
        <translation>Sofort mit einer seriellen Schnittstelle verbinden.</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NAME</translation>
    </message>
    <message>
        <source>Rate to run the chain at: 9600, 19200 (default), 57600 or 115200.</source>
        <translation>Rate, mit der die Kette arbeitet: 9600, 19200 (Vorgabe), 57600 oder 115200.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Connect to the built-in simulator at once. CHAIN lists its modules, the one farthest from the host first; the default is %1.</source>
        <translation>Sofort mit dem eingebauten Simulator verbinden. KETTE zählt seine Module auf, das vom Rechner am weitesten entfernte zuerst; Vorgabe ist %1.</translation>
    </message>
    <message>
        <source>CHAIN</source>
        <translation>KETTE</translation>
    </message>
    <message>
        <source>List the serial ports of this machine.</source>
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
        <source>Let control lines inject faults into the built-in simulator.</source>
        <translation>Steuerzeilen dürfen Fehler in den eingebauten Simulator einstreuen.</translation>
    </message>
    <message>
        <source>With --port or --simulator: only look. Nothing is sent but questions, and closing leaves motors as they are; STOP ALL acts.</source>
        <translation>Mit --port oder --simulator: nur ansehen. Außer Fragen wird nichts gesendet, und Schließen lässt Motoren, wie sie sind; ALLES STOPP wirkt.</translation>
    </message>
    <message>
        <source>A machine file, opened at the start.</source>
        <translation>Eine Maschinendatei, die beim Start geöffnet wird.</translation>
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
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Position error limit</source>
        <translation>Grenze der Regelabweichung</translation>
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
        <source>Kp, position gain: output for each count of position error. After Kd, raise it with small, fast test moves until the motor starts to overshoot, then back off a little.</source>
        <translation>Kp, Lageverstärkung: Ausgangswert je Inkrement Regelabweichung. Nach Kd in kleinen, schnellen Testfahrten erhöhen, bis der Motor überzuschwingen beginnt, dann etwas zurücknehmen.</translation>
    </message>
    <message>
        <source>Kd, derivative gain: damping. Start here, with Kp and Ki 0: raise it until the motor starts to hum, then back off a little bit.</source>
        <translation>Kd, Differentialverstärkung: Dämpfung. Hier beginnen, mit Kp und Ki auf 0: erhöhen, bis der Motor zu brummen beginnt, dann etwas zurücknehmen.</translation>
    </message>
    <message>
        <source>Ki, integral gain: removes the steady error that Kp and Kd leave. Set IL to 16000 first, then raise Ki until the error is small enough soon enough. It adds some overshoot.</source>
        <translation>Ki, Integralverstärkung: beseitigt die bleibende Regelabweichung, die Kp und Kd übrig lassen. Zuerst IL auf 16000 setzen, dann Ki erhöhen, bis die Abweichung schnell genug klein genug wird. Das Überschwingen nimmt etwas zu.</translation>
    </message>
    <message>
        <source>IL, integration limit: bounds the running sum of the error. In the end lower it to the least value that still cancels the steady error. 0 clears the sum.</source>
        <translation>IL, Integralgrenze: begrenzt die laufende Summe der Abweichung. Am Ende auf den kleinsten Wert senken, der die bleibende Abweichung noch ausgleicht. 0 löscht die Summe.</translation>
    </message>
    <message>
        <source>OL, output limit: the largest PWM value, 255 is 100 %. A 12 V motor on 24 V takes 127.</source>
        <translation>OL, Ausgangsgrenze: größter PWM-Wert, 255 entspricht 100 %. Ein 12-V-Motor an 24 V verträgt 127.</translation>
    </message>
    <message>
        <source>CL, current limit, compared with the A/D value. 0: off. Odd: limits when the A/D value is above CL. Even: limits when it is below CL.</source>
        <translation>CL, Stromgrenze, wird mit dem A/D-Wert verglichen. 0: aus. Ungerade: begrenzt, wenn der A/D-Wert über CL liegt. Gerade: begrenzt, wenn er unter CL liegt.</translation>
    </message>
    <message>
        <source>EL, position error limit in counts: beyond it the servo switches itself off, for example after a collision or a stall.</source>
        <translation>EL, Grenze der Regelabweichung in Inkrementen: darüber schaltet sich der Servo selbst ab, zum Beispiel nach einer Kollision oder Blockade.</translation>
    </message>
    <message>
        <source>SR, servo rate divisor: one servo tick is SR x 0.512 ms. A slower rate damps heavy loads with less Kd. Changing SR changes what every velocity and acceleration means.</source>
        <translation>SR, Servotakt-Teiler: ein Servotakt dauert SR x 0,512 ms. Ein langsamerer Takt dämpft schwere Lasten mit weniger Kd. Mit SR ändert sich die Bedeutung jeder Geschwindigkeit und Beschleunigung.</translation>
    </message>
    <message>
        <source>DB, deadband compensation: added to every PWM value but 0, for amplifiers that do nothing near zero. Version 4 and later.</source>
        <translation>DB, Totzonenkompensation: wird zu jedem PWM-Wert außer 0 addiert, für Verstärker, die nahe null nichts tun. Ab Version 4.</translation>
    </message>
    <message>
        <source>Range: %1 to %2.</source>
        <translation>Bereich: %1 bis %2.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
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
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
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
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 auf %3</translation>
    </message>
</context>
<context>
    <name>HomeTexts</name>
    <message>
        <source>Home: %1</source>
        <translation>Referenz: %1</translation>
    </message>
    <message>
        <source>Home: not known</source>
        <translation>Referenz: unbekannt</translation>
    </message>
    <message>
        <source>Where home is, is not known in this connection. A search finds it, Save as home sets it; a restart, and whatever else sets the position unseen, loses it.</source>
        <translation>Wo die Referenz liegt, ist in dieser Verbindung nicht bekannt. Eine Suche findet sie, Als Referenz speichern setzt sie; ein Neustart, und was sonst die Position ungesehen setzt, verliert sie.</translation>
    </message>
    <message>
        <source>Home is at %1. A search found it %2 min ago.</source>
        <translation>Die Referenz liegt bei %1. Eine Suche hat sie vor %2 min gefunden.</translation>
    </message>
    <message>
        <source>Home is at %1. It was saved %2 min ago.</source>
        <translation>Die Referenz liegt bei %1. Sie wurde vor %2 min gespeichert.</translation>
    </message>
    <message>
        <source>Makes the present position 0. The motor does not move. Where 0 has been is lost: all positions are counted from here then.</source>
        <translation>Macht die jetzige Position zu 0. Der Motor bewegt sich nicht. Wo 0 bisher war, geht verloren: Alle Positionen zählen dann von hier.</translation>
    </message>
    <message>
        <source>Home, now at %1, is at %2 then.</source>
        <translation>Die Referenz, jetzt bei %1, liegt dann bei %2.</translation>
    </message>
    <message>
        <source>What the chip captured or saved last, as it counted then: a limit stop writes it as well, and Zero here leaves it as it is. Go home does not go by it.</source>
        <translation>Was der Chip zuletzt erfasst oder gespeichert hat, so wie er damals zählte: Auch ein Endschalter-Stopp schreibt es, und Hier nullen lässt es, wie es ist. Zur Referenz richtet sich nicht danach.</translation>
    </message>
    <message>
        <source>Home: %1, not verified</source>
        <translation>Referenz: %1, nicht bestätigt</translation>
    </message>
    <message>
        <source>Home is at %1, not verified: it was taken from where the axis was seen last, %2 min ago. A search verifies it.</source>
        <translation>Die Referenz ist bei %1, nicht bestätigt: Sie wurde vor %2 min daraus übernommen, wo die Achse zuletzt gesehen wurde. Eine Suche bestätigt sie.</translation>
    </message>
    <message>
        <source>Home is at %1. The position was declared right %2 min ago.</source>
        <translation>Die Referenz liegt bei %1. Die Position wurde vor %2 min für richtig erklärt.</translation>
    </message>
</context>
<context>
    <name>LoopTestTexts</name>
    <message>
        <source>%1 frequencies up to %2 Hz</source>
        <translation>%1 Frequenzen bis %2 Hz</translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) %1 Hz</source>
        <translation>Bandbreite (-3 dB) %1 Hz</translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) beyond that</source>
        <translation>Bandbreite (-3 dB) darüber</translation>
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
</context>
<context>
    <name>Menus</name>
    <message>
        <source>About NMC Panel</source>
        <translation>Über NMC Panel</translation>
    </message>
    <message>
        <source>NMC Panel %1</source>
        <translation>NMC Panel %1</translation>
    </message>
    <message>
        <source>A control panel for PIC-SERVO and PIC-STEP motor modules on one serial line.

Free software under the GNU General Public License, version 3 or later. Icons: Tabler, MIT licence. Built with Qt %1.</source>
        <translation>Bedienprogramm für Motormodule PIC-SERVO und PIC-STEP an einer seriellen Leitung.

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
        <source>Chain</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Befehl &amp;finden…</translation>
    </message>
</context>
<context>
    <name>MessageLines</name>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>over at %1</source>
        <translation>vorbei um %1</translation>
    </message>
    <message>
        <source>Over: %1</source>
        <translation>Vorbei: %1</translation>
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
        <source>ms</source>
        <translation>ms</translation>
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
        <source>Off by %1 counts rms; encoder and times explain %2.</source>
        <translation>Abweichung %1 Ink. (RMS); Geber und Zeiten erklären %2.</translation>
    </message>
    <message>
        <source>There are too few samples. Record for longer, or raise the baud rate.</source>
        <translation>Es gibt zu wenige Messwerte. Länger aufzeichnen oder die Baudrate erhöhen.</translation>
    </message>
    <message>
        <source>The shaft did not move. Check motor power and brake, or make a longer step.</source>
        <translation>Die Welle hat sich nicht bewegt. Motorspannung und Bremse prüfen oder einen größeren Sprung machen.</translation>
    </message>
    <message>
        <source>The shaft starts away from its goal. Check the direction on the page Axis.</source>
        <translation>Die Welle läuft von ihrem Ziel weg. Auf der Seite Achse die Richtung prüfen.</translation>
    </message>
    <message>
        <source>The motor swings and does not calm down. Lower Kp or raise Kd, then step again.</source>
        <translation>Der Motor schwingt und beruhigt sich nicht. Kp verringern oder Kd erhöhen, dann noch einmal springen.</translation>
    </message>
    <message>
        <source>This model does not explain the step. Look for backlash, a belt, a stop that was hit, or a current limit.</source>
        <translation>Dieses Modell erklärt den Sprung nicht. Auf Spiel, einen Riemen, einen Anschlag oder eine Stromgrenze prüfen.</translation>
    </message>
    <message>
        <source>These steps leave the motor&apos;s gain open. Add a longer one, so that it comes near a steady speed.</source>
        <translation>Diese Sprünge lassen die Verstärkung des Motors offen. Einen größeren hinzufügen, damit er einer festen Geschwindigkeit nahe kommt.</translation>
    </message>
    <message>
        <source>These steps leave the time constant open. Repeat the step, or raise the baud rate.</source>
        <translation>Diese Sprünge lassen die Zeitkonstante offen. Den Sprung wiederholen oder die Baudrate erhöhen.</translation>
    </message>
    <message>
        <source>Overshoot %1, settling %2</source>
        <translation>Überschwingen %1, Einschwingen %2</translation>
    </message>
    <message>
        <source>Error at rest %1 counts</source>
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
</context>
<context>
    <name>Report</name>
    <message>
        <source>Gains</source>
        <translation>Reglerwerte</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source>%1 counts, %2</source>
        <translation>%1 Inkremente, %2</translation>
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
        <source>Settling to ±%1 %: %2</source>
        <translation>Einschwingen auf ±%1 %: %2</translation>
    </message>
    <message>
        <source>Steady-state error %1</source>
        <translation>Bleibende Abweichung %1</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Reglereinstellung von %1</translation>
    </message>
    <message>
        <source>simulated: no real motor moved</source>
        <translation>simuliert: kein wirklicher Motor bewegt</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
</context>
<context>
    <name>Scope</name>
    <message>
        <source>NMC Panel %1</source>
        <translation>NMC Panel %1</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>SIMULATOR, no real motor moved</source>
        <translation>SIMULATOR, kein echter Motor bewegt</translation>
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
        <source>To the present</source>
        <translation>Zur Gegenwart</translation>
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
        <source>position</source>
        <translation>Position</translation>
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
        <source>A/D</source>
        <translation>A/D</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
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
        <source>%1/s²</source>
        <translation>%1/s²</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>von 255</translation>
    </message>
    <message>
        <source>A row for each reply (*.csv)</source>
        <translation>Eine Zeile je Antwort (*.csv)</translation>
    </message>
    <message>
        <source>A column for each signal (*.csv)</source>
        <translation>Eine Spalte je Signal (*.csv)</translation>
    </message>
    <message>
        <source>A column for each signal, every millisecond (*.csv)</source>
        <translation>Eine Spalte je Signal, jede Millisekunde (*.csv)</translation>
    </message>
</context>
<context>
    <name>StepMeaning</name>
    <message>
        <source>Speed mode</source>
        <translation>Geschwindigkeitsmodus</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Kleinste Profilgeschwindigkeit</translation>
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
        <source>E-stop input</source>
        <translation>E-Stop-Eingang</translation>
    </message>
    <message>
        <source>When one stops it</source>
        <translation>Wenn einer ihn stoppt</translation>
    </message>
    <message>
        <source>The clock of the step timer. A faster one reaches higher speeds in coarser steps: take the slowest that is fast enough. The same speeds and ramps mean something else in another mode.</source>
        <translation>Der Takt des Schritt-Timers. Ein schnellerer erreicht höhere Geschwindigkeiten in gröberen Stufen: den langsamsten nehmen, der schnell genug ist. Dieselben Geschwindigkeiten und Rampen bedeuten in einem anderen Modus etwas anderes.</translation>
    </message>
    <message>
        <source>Where ramps begin and end. The motor must start and stop at this speed at once without losing steps; runs and moves with a ramp go no slower.</source>
        <translation>Wo Rampen beginnen und enden. Der Motor muss mit dieser Geschwindigkeit ohne Schrittverlust sofort anfahren und anhalten können; Dauerlauf und Fahrten mit Rampe werden nicht langsamer.</translation>
    </message>
    <message>
        <source>The current limit while the motor moves, as a part of 255 of what the driver can give. 0 is no current: the motor does not follow. Not more than motor and driver stand.</source>
        <translation>Die Stromgrenze, während der Motor sich bewegt, als Teil von 255 dessen, was der Treiber liefern kann. 0 ist kein Strom: der Motor folgt nicht. Nicht mehr, als Motor und Treiber vertragen.</translation>
    </message>
    <message>
        <source>The current limit at rest, from about 0.25 s after a motion. Usually lower than the run current, so that the motor stays cool. 0 is no current: nothing is held.</source>
        <translation>Die Stromgrenze im Stillstand, ab etwa 0,25 s nach einer Bewegung. Meist kleiner als der Fahrstrom, damit der Motor kühl bleibt. 0 ist kein Strom: nichts wird gehalten.</translation>
    </message>
    <message>
        <source>The module switches the motor off when the A/D value falls below this: the voltage of a thermistor bridge falls as the motor gets warmer. 0 turns this off. Watch the A/D value of a warm motor to find the right limit.</source>
        <translation>Das Modul schaltet den Motor ab, wenn der A/D-Wert darunter fällt: die Spannung einer Thermistorbrücke sinkt, wenn der Motor wärmer wird. 0 schaltet das aus. Den A/D-Wert eines warmen Motors beobachten, um die richtige Grenze zu finden.</translation>
    </message>
    <message>
        <source>As a rule the chip stops at limit switch 1 going forward and at limit switch 2 in reverse. With this on the switches stop nothing, and the motor can run into its end.</source>
        <translation>In der Regel stoppt der Chip vorwärts am Endschalter 1 und rückwärts am Endschalter 2. Ist dies ein, stoppen die Schalter nichts, und der Motor kann in sein Ende fahren.</translation>
    </message>
    <message>
        <source>As a rule the chip stops the motor when its E-stop input goes high. With this on the input stops nothing.</source>
        <translation>In der Regel stoppt der Chip den Motor, wenn sein E-Stop-Eingang auf High geht. Ist dies ein, stoppt der Eingang nichts.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input switches the motor off too, not only stops it: it is then free to turn, and a load may fall.</source>
        <translation>Ein Endschalter oder der E-Stop-Eingang stoppt den Motor nicht nur, sondern schaltet ihn auch ab: er ist dann frei drehbar, eine Last kann absinken.</translation>
    </message>
    <message>
        <source>A/D now %1</source>
        <translation>A/D jetzt %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
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
        <translation>%1 % des vollen Werts</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>Geschwindigkeit %1</translation>
    </message>
</context>
<context>
    <name>StepTexts</name>
    <message>
        <source>too few samples</source>
        <translation>zu wenige Messwerte</translation>
    </message>
    <message>
        <source>did not reach 90 %</source>
        <translation>90 % nicht erreicht</translation>
    </message>
    <message>
        <source>not in this record</source>
        <translation>nicht in dieser Aufzeichnung</translation>
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
        <source>A move with so much velocity and acceleration that its profile is at the goal in one tick.</source>
        <translation>Eine Fahrt mit so viel Geschwindigkeit und Beschleunigung, dass ihr Profil in einem Takt am Ziel ist.</translation>
    </message>
    <message>
        <source>The goal is made the position to hold, without a profile. Not with version 1.</source>
        <translation>Das Ziel wird ohne Profil zur gehaltenen Position. Nicht mit Version 1.</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
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
</context>
<context>
    <name>StepWords</name>
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
        <source>The motor is there already.</source>
        <translation>Der Motor ist bereits dort.</translation>
    </message>
    <message>
        <source>Takes %1 s. Too short for that speed: reaches %2.</source>
        <translation>Dauert %1 s. Zu kurz für diese Geschwindigkeit: erreicht %2.</translation>
    </message>
    <message>
        <source>Takes %1 s, fastest %2.</source>
        <translation>Dauert %1 s, höchstens %2 schnell.</translation>
    </message>
    <message>
        <source>Ramp of %1.</source>
        <translation>Rampe von %1.</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>There is no port &quot;%1&quot;. Only the simulator is here: --simulator.</source>
        <translation>Es gibt keinen Port „%1“. Nur der Simulator ist vorhanden: --simulator.</translation>
    </message>
    <message>
        <source>There is no port &quot;%1&quot;. These are here: %2.</source>
        <translation>Es gibt keinen Port „%1“. Vorhanden sind: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a rate of these modules. They take %2.</source>
        <translation>„%1“ ist keine Rate dieser Module. Möglich sind %2.</translation>
    </message>
    <message>
        <source>The simulator does not understand the chain &quot;%1&quot;: %2 An example: --simulator=servo,servo@1</source>
        <translation>Der Simulator versteht die Kette „%1“ nicht: %2 Ein Beispiel: --simulator=servo,servo@1</translation>
    </message>
    <message>
        <source>There is no option &quot;%1&quot;. --help lists them.</source>
        <translation>Es gibt keine Option „%1“. --help listet alle auf.</translation>
    </message>
    <message>
        <source>There is no display to open a window on: neither DISPLAY nor WAYLAND_DISPLAY is set.</source>
        <translation>Es gibt keine Anzeige für ein Fenster: weder DISPLAY noch WAYLAND_DISPLAY ist gesetzt.</translation>
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
        <source>Motor state unknown; no motor was moving at the last word.</source>
        <translation>Motorzustand unbekannt; zuletzt bewegte sich kein Motor.</translation>
    </message>
    <message>
        <source>Your user account may not use %1.</source>
        <translation>Ihr Benutzerkonto darf %1 nicht verwenden.</translation>
    </message>
    <message>
        <source>Ask whoever looks after this computer for access to it.</source>
        <translation>Bitten Sie die Person, die diesen Rechner betreut, um Zugriff.</translation>
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
        <source>There is no %1.</source>
        <translation>%1 ist nicht vorhanden.</translation>
    </message>
    <message>
        <source>Most often the adapter is not plugged in, or it has another name now.</source>
        <translation>Meist ist der Adapter nicht eingesteckt oder hat jetzt einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1 is not a serial port.</source>
        <translation>%1 ist keine serielle Schnittstelle.</translation>
    </message>
    <message>
        <source>Choose the port of the adapter, for example /dev/ttyUSB0.</source>
        <translation>Den Port des Adapters wählen, zum Beispiel /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>%1 cannot run at the chosen rate.</source>
        <translation>%1 kann nicht mit der gewählten Rate arbeiten.</translation>
    </message>
    <message>
        <source>Choose another rate; every adapter can do 19 200 Bd.</source>
        <translation>Eine andere Rate wählen; 19 200 Bd beherrscht jeder Adapter.</translation>
    </message>
    <message>
        <source>The adapter at %1 was unplugged. %2</source>
        <translation>Der Adapter an %1 wurde abgezogen. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then plug it in again.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen, dann den Adapter wieder einstecken.</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <translation>%1 konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The system says: %1</source>
        <translation>Das System meldet: %1</translation>
    </message>
    <message>
        <source>Not every module answered at %1 Bd, so the modules cannot be used yet.</source>
        <translation>Bei %1 Bd hat nicht jedes Modul geantwortet; die Module sind daher noch nicht verwendbar.</translation>
    </message>
    <message>
        <source>Module %1 did not answer at %2 Bd, so the modules cannot be used yet.</source>
        <translation>Modul %1 hat bei %2 Bd nicht geantwortet; die Module sind daher noch nicht verwendbar.</translation>
    </message>
    <message>
        <source>Usually the cable is too long for this rate, or termination is missing. Choose a lower rate for %1 and scan again.</source>
        <translation>Meist ist das Kabel zu lang für diese Rate, oder der Abschluss fehlt. Eine niedrigere Rate für %1 wählen und erneut suchen.</translation>
    </message>
    <message>
        <source>Modules answered at %1, but their answers could not be read.</source>
        <translation>An %1 haben Module geantwortet, aber die Antworten waren nicht lesbar.</translation>
    </message>
    <message>
        <source>Usually noise on the cable, or two modules answer at once. Check the cable, its termination and the ADDR_IN jumpers.</source>
        <translation>Meist Störungen auf dem Kabel, oder zwei Module antworten gleichzeitig. Kabel, Abschluss und ADDR_IN-Jumper prüfen.</translation>
    </message>
    <message>
        <source>Port %1, %2 Bd</source>
        <translation>Port %1, %2 Bd</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered.</source>
        <translation>%1 von %2 Modulen haben geantwortet.</translation>
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
        <source>Nothing moves until you ask for it. Gains are unknown until you apply them.</source>
        <translation>Nichts bewegt sich ohne Anforderung. Die Reglerwerte sind unbekannt, bis sie angewendet werden.</translation>
    </message>
    <message>
        <source>Disconnected from %1.</source>
        <translation>Verbindung zu %1 getrennt.</translation>
    </message>
    <message>
        <source>No module answers on %1 any more. %2</source>
        <translation>An %1 antwortet kein Modul mehr. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Then check the power of the modules and the cable at the PC.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen. Dann die Versorgung der Module und das Kabel am PC prüfen.</translation>
    </message>
    <message>
        <source>The link is unreliable: %1 of the last %2 exchanges went wrong.</source>
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
        <source>How</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown: it was moving.</source>
        <translation>Modul %1 antwortet seit %2 s nicht. Motorzustand unbekannt: der Motor war in Bewegung.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown; it was stopped at the last word.</source>
        <translation>Modul %1 antwortet seit %2 s nicht. Motorzustand unbekannt; zuletzt stand der Motor.</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Usually its power or the plug next to it; it is asked again all the time.</source>
        <translation>Bei Bedarf den Hardware-Stopp benutzen. Meist liegt es an der Versorgung oder am Stecker daneben; das Modul wird laufend weiter abgefragt.</translation>
    </message>
    <message>
        <source>Module %1 may not answer until module %2 has its address again.</source>
        <translation>Modul %1 antwortet möglicherweise erst, wenn Modul %2 wieder seine Adresse hat.</translation>
    </message>
    <message>
        <source>Module %1 restarted: its position and gains are lost.</source>
        <translation>Modul %1 ist neu gestartet: Position und Reglerwerte sind verloren.</translation>
    </message>
    <message>
        <source>Restart the network…</source>
        <translation>Netzwerk neu starten…</translation>
    </message>
    <message>
        <source>Module %1 did not understand the last command, so it was not carried out.</source>
        <translation>Modul %1 hat den letzten Befehl nicht verstanden; er wurde nicht ausgeführt.</translation>
    </message>
    <message>
        <source>Sent again (%1 of 3). Usually noise on the cable.</source>
        <translation>Erneut gesendet (%1 von 3). Meist Störungen auf dem Kabel.</translation>
    </message>
    <message>
        <source>The answer from module %1 was garbled.</source>
        <translation>Die Antwort von Modul %1 war verstümmelt.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; position is being read again.</source>
        <translation>Ob der Befehl ausgeführt wurde, ist offen; die Position wird neu gelesen.</translation>
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
        <source>Module %1 did not understand the command, so it was not carried out.</source>
        <translation>Modul %1 hat den Befehl nicht verstanden; er wurde nicht ausgeführt.</translation>
    </message>
    <message>
        <source>It was sent 3 times. Usually noise on the cable. Nothing after it was sent.</source>
        <translation>Er wurde 3-mal gesendet. Meist Störungen auf dem Kabel. Danach wurde nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>Module %1 did not answer the command. Motor state unknown.</source>
        <translation>Modul %1 hat auf den Befehl nicht geantwortet. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out. Look at the motor; stop all if in doubt. Nothing after it was sent.</source>
        <translation>Ob der Befehl ausgeführt wurde, ist offen. Den Motor ansehen; im Zweifel alles stoppen. Danach wurde nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>Module %1 does not allow this in its present state. Nothing was sent.</source>
        <translation>Modul %1 lässt das in seinem jetzigen Zustand nicht zu. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Stop the motor, then try again.</source>
        <translation>Den Motor anhalten, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>The command for module %1 was dropped because a stop came first.</source>
        <translation>Der Befehl für Modul %1 wurde verworfen, weil ein Stopp dazwischenkam.</translation>
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
        <source>The computer was busy for more than 250 ms. Press and hold again.</source>
        <translation>Der Rechner war länger als 250 ms beschäftigt. Erneut drücken und halten.</translation>
    </message>
    <message>
        <source>Not possible for module %1 now; nothing was sent.</source>
        <translation>Für Modul %1 jetzt nicht möglich; es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>%1 of %2 stopped, %3 ms. Still holding.</source>
        <translation>%1 von %2 angehalten, %3 ms. Position wird gehalten.</translation>
    </message>
    <message>
        <source>%1 of %2 stopped, %3 ms. Every motor is off.</source>
        <translation>%1 von %2 angehalten, %3 ms. Alle Motoren sind aus.</translation>
    </message>
    <message>
        <source>reaches %1 of %2</source>
        <translation>erreicht %1 von %2</translation>
    </message>
    <message>
        <source>1 motor is moving. It will be stopped before the port closes.</source>
        <translation>1 Motor ist in Bewegung. Er wird angehalten, bevor der Port geschlossen wird.</translation>
    </message>
    <message>
        <source>%1 motors are moving. They will be stopped before the port closes.</source>
        <translation>%1 Motoren sind in Bewegung. Sie werden angehalten, bevor der Port geschlossen wird.</translation>
    </message>
    <message>
        <source>Stopping the motors, then closing.</source>
        <translation>Die Motoren werden angehalten, dann wird geschlossen.</translation>
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
        <source>No motor power</source>
        <translation>Versorgung fehlt</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>Servo aus</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>Power was lost</source>
        <translation>Versorgung war weg</translation>
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
        <source>No status has come from this module yet.</source>
        <translation>Von diesem Modul ist noch kein Status eingetroffen.</translation>
    </message>
    <message>
        <source>The module does not answer: moving or stopped is unknown.</source>
        <translation>Das Modul antwortet nicht: ob sich der Motor bewegt, ist unbekannt.</translation>
    </message>
    <message>
        <source>The motor is free to turn. Nothing is wrong: the servo has not been switched on, or was switched off.</source>
        <translation>Der Motor ist frei drehbar. Das ist kein Fehler: der Servo wurde noch nicht eingeschaltet oder wurde ausgeschaltet.</translation>
    </message>
    <message>
        <source>The servo switched itself off because the motor was too far from where it should be.</source>
        <translation>Der Servo hat sich abgeschaltet, weil der Motor zu weit von der Sollposition entfernt war.</translation>
    </message>
    <message>
        <source>A fixed PWM value drives the motor; the servo does not control it.</source>
        <translation>Ein fester PWM-Wert treibt den Motor; der Servo regelt ihn nicht.</translation>
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
        <source>Not connected: choose a port and connect first.</source>
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
        <source>The motor is moving. A move to a position starts from standstill: stop first.</source>
        <translation>Der Motor ist in Bewegung. Eine Position wird aus dem Stillstand angefahren: zuerst stoppen.</translation>
    </message>
    <message>
        <source>The acceleration is 0: the motor could neither start nor stop.</source>
        <translation>Die Beschleunigung ist 0: der Motor könnte weder anfahren noch anhalten.</translation>
    </message>
    <message>
        <source>The velocity is 0: the motor would not move.</source>
        <translation>Die Geschwindigkeit ist 0: der Motor würde sich nicht bewegen.</translation>
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
        <source>giving addresses</source>
        <translation>Adressen werden vergeben</translation>
    </message>
    <message>
        <source>asking for type and version</source>
        <translation>Typ und Version werden abgefragt</translation>
    </message>
    <message>
        <source>changing the rate</source>
        <translation>Rate wird geändert</translation>
    </message>
    <message>
        <source>preparing the status reports</source>
        <translation>Statusmeldungen werden vorbereitet</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>Simulator</translation>
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
        <source>%1 is open, but no module could be used</source>
        <translation>%1 ist offen, aber kein Modul ist verwendbar</translation>
    </message>
    <message>
        <source>Connection to %1 lost, motor state unknown</source>
        <translation>Verbindung zu %1 verloren, Motorzustand unbekannt</translation>
    </message>
    <message>
        <source>1 module</source>
        <translation>1 Modul</translation>
    </message>
    <message>
        <source>%1 modules</source>
        <translation>%1 Module</translation>
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
        <source>%1 counts/s</source>
        <translation>%1 Ink./s</translation>
    </message>
    <message>
        <source>%1 counts/s²</source>
        <translation>%1 Ink./s²</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Erledigt: %1</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>Nicht ausgeführt: %1</translation>
    </message>
    <message>
        <source>Answer to: %1</source>
        <translation>Antwort auf: %1</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Two modules answer at the same address on %1, so the modules cannot be used.</source>
        <translation>Zwei Module antworten an %1 unter derselben Adresse; die Module sind so nicht benutzbar.</translation>
    </message>
    <message>
        <source>Nothing was moved. Usually two ADDR_IN inputs are grounded: only that of the module farthest from the PC may be.</source>
        <translation>Es wurde nichts bewegt. Meist liegen zwei ADDR_IN-Eingänge auf Masse: Nur der des vom PC am weitesten entfernten Moduls darf es.</translation>
    </message>
    <message>
        <source>The line at %1 is held low: nothing but zero bytes comes in.</source>
        <translation>Die Leitung an %1 wird auf Low gehalten: Es kommen nur Nullbytes an.</translation>
    </message>
    <message>
        <source>Usually a short circuit, swapped wires of a pair, or a module without power. Motor state unknown; commands may not arrive either.</source>
        <translation>Meist ein Kurzschluss, vertauschte Adern eines Paars oder ein Modul ohne Spannung. Zustand der Motoren unbekannt; auch Befehle kommen vielleicht nicht an.</translation>
    </message>
    <message>
        <source>No module at %1 has an address yet.</source>
        <translation>Noch kein Modul an %1 hat eine Adresse.</translation>
    </message>
    <message>
        <source>A read-only connection changes nothing, so it gives no addresses. Connect without read-only.</source>
        <translation>Eine Verbindung nur zum Lesen ändert nichts und vergibt daher keine Adressen. Ohne „nur lesen“ verbinden.</translation>
    </message>
    <message>
        <source>The link is doubtful: %1 of the last %2 exchanges went wrong.</source>
        <translation>Die Verbindung ist zweifelhaft: %1 der letzten %2 Austausche gingen schief.</translation>
    </message>
    <message>
        <source>Either the command was damaged on its way, or the gains let it overshoot by far. Read the position before the next move.</source>
        <translation>Entweder wurde der Befehl unterwegs beschädigt, oder die Reglerwerte lassen es weit überschwingen. Vor der nächsten Fahrt die Position ablesen.</translation>
    </message>
    <message>
        <source>Motor state unknown. Look at the motor; stop all if in doubt.</source>
        <translation>Zustand des Motors unbekannt. Sehen Sie nach dem Motor; im Zweifel alles stoppen.</translation>
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
        <source>The panel was frozen for %1 while a motor was moving. It was not stopped.</source>
        <translation>Das Programm reagierte %1 lang nicht, während sich ein Motor bewegte. Er wurde nicht gestoppt.</translation>
    </message>
    <message>
        <source>Stop all could not be pressed meanwhile. The computer was busy, or the program hung.</source>
        <translation>ALLES STOPP war währenddessen nicht möglich. Der Rechner war ausgelastet, oder das Programm hing.</translation>
    </message>
    <message>
        <source>Resumed after %1: all values are read again.</source>
        <translation>Aufgewacht nach %1: alle Werte werden neu gelesen.</translation>
    </message>
    <message>
        <source>Resumed after %1: motors were told to stop, and all values are read again.</source>
        <translation>Aufgewacht nach %1: die Motoren haben den Stoppbefehl bekommen, und alle Werte werden neu gelesen.</translation>
    </message>
    <message>
        <source>The computer was suspended. Motors that moved went on moving meanwhile; look at them before the next move.</source>
        <translation>Der Rechner war im Ruhezustand. Motoren, die sich bewegten, liefen währenddessen weiter; sehen Sie vor der nächsten Bewegung nach ihnen.</translation>
    </message>
    <message>
        <source>The last session ended while motor %1 was moving.</source>
        <translation>Die letzte Sitzung endete, während sich Motor %1 bewegte.</translation>
    </message>
    <message>
        <source>The last session ended while motors %1 were moving.</source>
        <translation>Die letzte Sitzung endete, während sich die Motoren %1 bewegten.</translation>
    </message>
    <message>
        <source>Settings are not saved.</source>
        <translation>Einstellungen werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Everything else works; only the layout of the window and the last port will not be remembered.</source>
        <translation>%1 lässt sich nicht schreiben. Alles andere funktioniert; nur die Anordnung des Fensters und der letzte Anschluss bleiben nicht erhalten.</translation>
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
        <source>It looks for a modem for some seconds after an adapter was plugged in; wait, and try again. To keep it away from USB adapters: %1, then plug the adapter in again.</source>
        <translation>Es sucht einige Sekunden lang nach einem Modem, wenn ein Adapter eingesteckt wurde; warten Sie und versuchen Sie es noch einmal. Um es von USB-Adaptern fernzuhalten: %1, dann den Adapter neu einstecken.</translation>
    </message>
    <message>
        <source>It takes many serial adapters for a Braille display. If you use none: %1, then plug the adapter in again.</source>
        <translation>Es hält viele serielle Adapter für eine Braillezeile. Wenn Sie keine benutzen: %1, dann den Adapter neu einstecken.</translation>
    </message>
    <message>
        <source>%1 is free, but a lock file says that it is in use.</source>
        <translation>%1 ist frei, aber eine Sperrdatei sagt, dass es benutzt wird.</translation>
    </message>
    <message>
        <source>The lock file %1 was left by %2, whose program has ended without removing it. Remove it with: %3, then try again.</source>
        <translation>Die Sperrdatei %1 wurde von %2 hinterlassen; das Programm endete, ohne sie zu entfernen. Entfernen Sie sie mit: %3, und versuchen Sie es dann noch einmal.</translation>
    </message>
    <message>
        <source>%1 cannot be opened because no lock file can be made for it.</source>
        <translation>%1 lässt sich nicht öffnen, weil dafür keine Sperrdatei angelegt werden kann.</translation>
    </message>
    <message>
        <source>Your user account may not write to %1, nor to any other folder for such files. Ask whoever looks after this computer for access to it.</source>
        <translation>Ihr Benutzerkonto darf weder in %1 schreiben noch in einen anderen Ordner für solche Dateien. Bitten Sie die Person, die diesen Rechner betreut, um Zugriff.</translation>
    </message>
    <message>
        <source>%1 could not be opened: this program has too many files open.</source>
        <translation>%1 ließ sich nicht öffnen: dieses Programm hat zu viele Dateien offen.</translation>
    </message>
    <message>
        <source>Close what it does not need, or start it again.</source>
        <translation>Schließen Sie, was nicht gebraucht wird, oder starten Sie es neu.</translation>
    </message>
    <message>
        <source>Set the latency timer of the USB adapter to 1 ms, then connect again.</source>
        <translation>Setzen Sie den Latenz-Timer des USB-Adapters auf 1 ms, dann verbinden Sie neu.</translation>
    </message>
    <message>
        <source>Run %1. That lasts until it is unplugged; for good, also run %2.</source>
        <translation>Führen Sie %1 aus. Das hält, bis er abgezogen wird; für immer zusätzlich %2.</translation>
    </message>
    <message>
        <source>The adapter is back as %1 (same serial number). Reconnect?</source>
        <translation>Der Adapter ist wieder da, als %1 (gleiche Seriennummer). Neu verbinden?</translation>
    </message>
    <message>
        <source>An adapter of the same kind is there as %1. Reconnect?</source>
        <translation>Ein Adapter der gleichen Art ist da, als %1. Neu verbinden?</translation>
    </message>
    <message>
        <source>Motors may still be moving. Reconnecting moves nothing, and nothing that was asked for before is sent again.</source>
        <translation>Motoren können noch in Bewegung sein. Das Verbinden bewegt nichts, und nichts, was vorher verlangt wurde, wird noch einmal gesendet.</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).</source>
        <translation>Der Port ist offen, aber kein Modul hat geantwortet (9600, 19 200, 57 600 und 115 200 Bd versucht).</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain, one loose cable hides all modules; the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. A chain that another program left at a rate of its own can be restarted.</source>
        <translation>Prüfen Sie der Reihe nach: Spannung der Module; jedes Kabel der Kette, ein loses verbirgt alle Module; die ADDR_IN-Brücke des vom PC am weitesten entfernten Moduls; TX und RX nicht vertauscht; ein Vollduplex-Adapter (4 Drähte). Eine Kette, die ein anderes Programm bei einer eigenen Rate zurückließ, lässt sich neu starten.</translation>
    </message>
    <message>
        <source>Attached to %1: %2 at %3 Bd, left as they were.</source>
        <translation>Verbunden mit %1: %2 bei %3 Bd, unverändert gelassen.</translation>
    </message>
    <message>
        <source>What they were doing goes on. Gains are unknown until you apply them. Stop a motor before you move it: what it was told last cannot be asked.</source>
        <translation>Was sie gerade taten, läuft weiter. Die Reglerwerte sind unbekannt, bis Sie sie senden. Stoppen Sie einen Motor, bevor Sie ihn bewegen: Was ihm zuletzt gesagt wurde, lässt sich nicht abfragen.</translation>
    </message>
    <message>
        <source>A module without an address answers, too, and cannot be used yet.</source>
        <translation>Auch ein Modul ohne Adresse antwortet; es ist noch nicht benutzbar.</translation>
    </message>
    <message>
        <source>Either one of the chain has restarted, or a new one was added. Its motor is off. A restart of the network gives it an address.</source>
        <translation>Entweder ist eines der Kette neu gestartet, oder ein neues kam hinzu. Sein Motor ist aus. Ein Neustart des Netzwerks gibt ihm eine Adresse.</translation>
    </message>
    <message>
        <source>The link to module %1 is unreliable: %2 of its last %3 exchanges went wrong.</source>
        <translation>Die Verbindung zu Modul %1 ist unzuverlässig: %2 der letzten %3 Austausche gingen schief.</translation>
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
        <source>It is not the one that this panel was connected to before. Nothing was sent.</source>
        <translation>Es ist nicht der, mit dem dieses Programm vorher verbunden war. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Connect to it</source>
        <translation>Damit verbinden</translation>
    </message>
    <message>
        <source>The link to module %1 is doubtful: %2 of its last %3 exchanges went wrong.</source>
        <translation>Die Verbindung zu Modul %1 ist zweifelhaft: %2 der letzten %3 Austausche gingen schief.</translation>
    </message>
    <message>
        <source>Its motor is off.</source>
        <translation>Sein Motor ist aus.</translation>
    </message>
    <message>
        <source>Every module forgets its position, its gains and its address, and lets go of its motor.</source>
        <translation>Jedes Modul vergisst seine Position, seine Reglerwerte und seine Adresse und lässt seinen Motor los.</translation>
    </message>
    <message>
        <source>1 motor is moving. It will be stopped first.</source>
        <translation>1 Motor bewegt sich. Er wird zuerst gestoppt.</translation>
    </message>
    <message>
        <source>%1 motors are moving. They will be stopped first.</source>
        <translation>%1 Motoren bewegen sich. Sie werden zuerst gestoppt.</translation>
    </message>
    <message>
        <source>Restarted</source>
        <translation>Neu gestartet</translation>
    </message>
    <message>
        <source>The module restarted by itself: its motor is off, and its position, gains and address are lost until the network is restarted.</source>
        <translation>Das Modul ist von selbst neu gestartet: Sein Motor ist aus; Position, Reglerwerte und Adresse sind verloren, bis das Netzwerk neu gestartet wird.</translation>
    </message>
    <message>
        <source>all bytes are 00, or all FF, as on a line that is held low or high</source>
        <translation>alle Bytes sind 00 oder alle FF, wie auf einer Leitung, die auf Low oder High gehalten wird</translation>
    </message>
    <message>
        <source>more bytes than were asked for</source>
        <translation>mehr Bytes als angefordert</translation>
    </message>
    <message>
        <source>type or version is not that of this module</source>
        <translation>Typ oder Version sind nicht die dieses Moduls</translation>
    </message>
    <message>
        <source>a bit that the data sheet leaves open has changed</source>
        <translation>ein Bit, das das Datenblatt offen lässt, hat sich geändert</translation>
    </message>
    <message>
        <source>homing began without a command</source>
        <translation>Referenzsuche begann ohne Befehl</translation>
    </message>
    <message>
        <source>home register changed without a command</source>
        <translation>Home-Register änderte sich ohne Befehl</translation>
    </message>
    <message>
        <source>position is farther from the last one than the velocities allow</source>
        <translation>Position ist weiter von der vorigen entfernt, als die Geschwindigkeiten erlauben</translation>
    </message>
    <message>
        <source>velocity changed faster than a motor can</source>
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
        <source>position changed although the motor was stopped</source>
        <translation>Position änderte sich, obwohl der Motor stand</translation>
    </message>
    <message>
        <source>timer count of a moving motor is outside 1 to 65 452</source>
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
        <source>wrong sum</source>
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
        <source>abandoned for a stop</source>
        <translation>für einen Stopp abgebrochen</translation>
    </message>
    <message>
        <source>no answer expected</source>
        <translation>keine Antwort erwartet</translation>
    </message>
    <message>
        <source>bytes although no answer was expected</source>
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
        <source>held motion</source>
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
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
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
        <source>%1 older exchanges are not in this file.</source>
        <translation>%1 ältere Übertragungen sind nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>Exchanges before this one were not recorded.</source>
        <translation>Übertragungen vor dieser wurden nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>looking for modules</source>
        <translation>suche Module</translation>
    </message>
    <message>
        <source>Usually encoder or motor wires are swapped, or the gains make it swing. Check both before the next move.</source>
        <translation>Meist sind Encoder- oder Motoradern vertauscht, oder die Reglerwerte lassen ihn schwingen. Vor der nächsten Fahrt beides prüfen.</translation>
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
        <source>Cannot be told of: %1.</source>
        <translation>Ungewiss bei: %1.</translation>
    </message>
    <message>
        <source>No answer from: %1.</source>
        <translation>Keine Antwort von: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 modules of group %3 started. All of them were told to stop.</source>
        <translation>%1 von %2 Modulen der Gruppe %3 sind gestartet. An alle ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>No module of group %1 started. Nothing moves because of it.</source>
        <translation>Kein Modul der Gruppe %1 ist gestartet. Dadurch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Whether all modules of group %1 started is unknown.</source>
        <translation>Ob alle Module der Gruppe %1 gestartet sind, ist unbekannt.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. The start was sent once and is not repeated; look at the motors, load again, then start again.</source>
        <translation>Meist Störungen auf dem Kabel. Der Start wurde einmal gesendet und wird nicht wiederholt; die Motoren ansehen, erneut laden, dann erneut starten.</translation>
    </message>
    <message>
        <source>Group %1 has no members. Nothing was sent.</source>
        <translation>Gruppe %1 hat keine Mitglieder. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Put modules into the group first.</source>
        <translation>Zuerst Module in die Gruppe aufnehmen.</translation>
    </message>
    <message>
        <source>The command to group %1 was withheld because of module %2. Nothing was sent.</source>
        <translation>Der Befehl an Gruppe %1 wurde wegen Modul %2 zurückgehalten. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>A group starts only when every member has confirmed its load, answers, and may start; and only when the group of every module is known. Load this module again, or give it its group again.</source>
        <translation>Eine Gruppe startet nur, wenn jedes Mitglied das Laden bestätigt hat, antwortet und starten darf; und nur, wenn die Gruppe jedes Moduls bekannt ist. Dieses Modul erneut laden oder ihm seine Gruppe neu zuweisen.</translation>
    </message>
    <message>
        <source>Module %1 did not answer the change of its group, so its group is unknown.</source>
        <translation>Modul %1 hat auf den Wechsel seiner Gruppe nicht geantwortet, seine Gruppe ist daher unbekannt.</translation>
    </message>
    <message>
        <source>The group of module %1 was not changed.</source>
        <translation>Die Gruppe von Modul %1 wurde nicht geändert.</translation>
    </message>
    <message>
        <source>No motor moves by it. Group FF cannot have a leader, and a group only one; the groups of all modules must be known for that. Try again.</source>
        <translation>Dadurch bewegt sich kein Motor. Gruppe FF kann keinen Leiter haben und jede andere Gruppe nur einen; dafür müssen die Gruppen aller Module bekannt sein. Erneut versuchen.</translation>
    </message>
    <message>
        <source>The command to group %1 was overtaken by a stop.</source>
        <translation>Dem Befehl an Gruppe %1 kam ein Stopp zuvor.</translation>
    </message>
    <message>
        <source>All motors were told to stop.</source>
        <translation>An alle Motoren ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>Not every module of group %1 has certainly saved its position as home.</source>
        <translation>Nicht jedes Modul der Gruppe %1 hat seine Position sicher als Referenzposition gespeichert.</translation>
    </message>
    <message>
        <source>No motor moved by it.</source>
        <translation>Dadurch hat sich kein Motor bewegt.</translation>
    </message>
    <message>
        <source>All modules now talk at %1 Bd. Positions and gains are what they were.</source>
        <translation>Alle Module arbeiten jetzt mit %1 Bd. Positionen und Reglerwerte sind unverändert.</translation>
    </message>
    <message>
        <source>The rate was not changed: the chain stays at %1 Bd. No motor moved by it.</source>
        <translation>Die Rate wurde nicht geändert: die Kette bleibt bei %1 Bd. Dadurch hat sich kein Motor bewegt.</translation>
    </message>
    <message>
        <source>The modules cannot make %1 Bd.</source>
        <translation>Die Module beherrschen %1 Bd nicht.</translation>
    </message>
    <message>
        <source>Something moves, or is about to. Stop all motors, then try again.</source>
        <translation>Etwas bewegt sich oder ist im Begriff dazu. Alle Motoren stoppen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>There is no answer from module %1, which would be left behind. Connect again first.</source>
        <translation>Von Modul %1 kommt keine Antwort; es würde zurückgelassen. Zuerst neu verbinden.</translation>
    </message>
    <message>
        <source>Another program may have changed the group of module %1, which would not hear the new rate. Set its group again, or restart the network.</source>
        <translation>Ein anderes Programm hat möglicherweise die Gruppe von Modul %1 geändert; es würde die neue Rate nicht mitbekommen. Seine Gruppe neu zuweisen oder das Netzwerk neu starten.</translation>
    </message>
    <message>
        <source>There is a group leader, module %1, whose answer would come at the new rate. Make it an ordinary member first.</source>
        <translation>Es gibt einen Gruppenleiter, Modul %1, dessen Antwort mit der neuen Rate käme. Zuerst ein gewöhnliches Mitglied daraus machen.</translation>
    </message>
    <message>
        <source>There was no answer at %1 Bd from module %2, so all went back. Try another rate, a shorter cable, or termination at both ends.</source>
        <translation>Bei %1 Bd kam von Modul %2 keine Antwort, daher sind alle zurückgekehrt. Eine andere Rate, ein kürzeres Kabel oder einen Abschluss an beiden Enden versuchen.</translation>
    </message>
    <message>
        <source>A stop came first.</source>
        <translation>Ein Stopp kam dazwischen.</translation>
    </message>
    <message>
        <source>No answer from module %1 since the change of rate. Nothing was moving.</source>
        <translation>Keine Antwort von Modul %1 seit dem Wechsel der Rate. Es war nichts in Bewegung.</translation>
    </message>
    <message>
        <source>It may still be at %1 Bd; the others are at %2 Bd. Scan again; if it is not found, restart the network: positions and gains are lost.</source>
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
        <source>a text in quotation marks</source>
        <translation>ein Text in Anführungszeichen</translation>
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
        <source>the file ends here, in the middle.</source>
        <translation>die Datei endet hier, mittendrin.</translation>
    </message>
    <message>
        <source>this text is not in UTF-8.</source>
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
        <source>this number is too big.</source>
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
        <source>%1 is there twice.</source>
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
        <source>%1 is %2; the module takes %3 to %4.</source>
        <translation>%1 ist %2; beim Modul möglich ist %3 bis %4.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, a word that is not known.</source>
        <translation>%1 ist „%2“, ein unbekanntes Wort.</translation>
    </message>
    <message>
        <source>%1 has a character that cannot be printed.</source>
        <translation>%1 enthält ein nicht druckbares Zeichen.</translation>
    </message>
    <message>
        <source>%1 has more than %2 entries.</source>
        <translation>%1 hat mehr als %2 Einträge.</translation>
    </message>
    <message>
        <source>%1 has a unit that the module of this axis does not count in.</source>
        <translation>%1 hat eine Einheit, in der das Modul dieser Achse nicht zählt.</translation>
    </message>
    <message>
        <source>module %1 is in a group already.</source>
        <translation>Modul %1 ist bereits in einer Gruppe.</translation>
    </message>
    <message>
        <source>another group has address %1, too.</source>
        <translation>auch eine andere Gruppe hat die Adresse %1.</translation>
    </message>
    <message>
        <source>the leader is not one of the group&apos;s modules.</source>
        <translation>der Leiter ist keines der Module der Gruppe.</translation>
    </message>
    <message>
        <source>It is not there any more. Was it moved, or is its disk not connected?</source>
        <translation>Die Datei ist nicht mehr da. Wurde sie verschoben, oder ist ihr Datenträger nicht angeschlossen?</translation>
    </message>
    <message>
        <source>The folder %1 is not there. Choose another one.</source>
        <translation>Den Ordner %1 gibt es nicht. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>This is a folder or a device. Choose a file.</source>
        <translation>Das ist ein Ordner oder ein Gerät. Eine Datei wählen.</translation>
    </message>
    <message>
        <source>Your user account may not do that in %1. Choose another folder, or change the permissions.</source>
        <translation>Ihr Benutzerkonto darf das in %1 nicht. Einen anderen Ordner wählen oder die Zugriffsrechte ändern.</translation>
    </message>
    <message>
        <source>The disk of %1 can only be read. Choose another folder.</source>
        <translation>Der Datenträger von %1 ist nur lesbar. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>There is no room left on the disk of %1. Make room, or choose another folder.</source>
        <translation>Auf dem Datenträger von %1 ist kein Platz mehr. Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>It is larger than any machine file. Is it the right file?</source>
        <translation>Sie ist größer als jede Maschinendatei. Ist es die richtige Datei?</translation>
    </message>
    <message>
        <source>The system says why under Details.</source>
        <translation>Den Grund, den das System meldet, zeigen die Details.</translation>
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
        <source>own unit</source>
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
        <source>a machine without a name</source>
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
        <source>&quot;%1&quot; was written by a newer NMC Panel: its format is %2, and this program knows formats up to %3.</source>
        <translation>„%1“ wurde von einem neueren NMC Panel geschrieben: das Format ist %2, dieses Programm kennt Formate bis %3.</translation>
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
        <source>&quot;%1&quot; was not opened.</source>
        <translation>„%1“ wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved. What it held before is still there.</source>
        <translation>„%1“ wurde nicht gespeichert. Der bisherige Inhalt ist noch vorhanden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved: this machine could not be opened again.</source>
        <translation>„%1“ wurde nicht gespeichert: diese Maschine ließe sich nicht wieder öffnen.</translation>
    </message>
    <message>
        <source>Nothing was sent to a module.</source>
        <translation>An kein Modul wurde etwas gesendet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. It says what is there already.</source>
        <translation>„%1“ ist offen. Die Datei enthält, was schon eingestellt ist.</translation>
    </message>
    <message>
        <source>Unsaved work on %1 is there.</source>
        <translation>Ungespeicherte Arbeit an %1 ist vorhanden.</translation>
    </message>
    <message>
        <source>An earlier session ended before it was saved. Restoring it sends nothing.</source>
        <translation>Eine frühere Sitzung endete, bevor gespeichert wurde. Das Wiederherstellen sendet nichts.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard: the work is lost</source>
        <translation>Verwerfen: die Arbeit geht verloren</translation>
    </message>
    <message>
        <source>Unsaved work of an earlier session cannot be read.</source>
        <translation>Ungespeicherte Arbeit einer früheren Sitzung ist nicht lesbar.</translation>
    </message>
    <message>
        <source>unsaved work</source>
        <translation>ungespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Changes to the machine are not kept until you save them yourself.</source>
        <translation>Änderungen an der Maschine bleiben erst erhalten, wenn Sie sie selbst speichern.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 lässt sich nicht schreiben.</translation>
    </message>
    <message>
        <source>The changes to %1 are not saved.</source>
        <translation>Die Änderungen an %1 sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
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
        <source>Homing</source>
        <translation>Referenzsuche</translation>
    </message>
    <message>
        <source>A/D scale</source>
        <translation>A/D-Skalierung</translation>
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
        <source>Gains</source>
        <translation>Reglerwerte</translation>
    </message>
    <message>
        <source>Limit pins</source>
        <translation>Endschalter-Pins</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Rate, Bd</source>
        <translation>Rate, Bd</translation>
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
        <translation>Geschwindigkeit des Dauerlaufs</translation>
    </message>
    <message>
        <source>Hold-to-move velocity</source>
        <translation>Geschwindigkeit beim Tippen</translation>
    </message>
    <message>
        <source>Hold-to-move cap</source>
        <translation>Obergrenze beim Tippen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>On limit 1</source>
        <translation>Bei Endschalter 1</translation>
    </message>
    <message>
        <source>On limit 2</source>
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
        <source>Then the index</source>
        <translation>Danach der Index</translation>
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
        <source>Travel limit</source>
        <translation>Weggrenze</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Referenzposition anfahren</translation>
    </message>
    <message>
        <source>Make it zero</source>
        <translation>Auf null setzen</translation>
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
        <translation>Kleinste Profilgeschwindigkeit</translation>
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
        <source>Ignore limits</source>
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
        <source>Changes the panel only; nothing is sent.</source>
        <translation>Ändert nur das Programm; es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Is sent to the module.</source>
        <translation>Wird an das Modul gesendet.</translation>
    </message>
    <message>
        <source>Waits in the fields, not sent: %1</source>
        <translation>Wartet in den Feldern, nicht gesendet: %1</translation>
    </message>
    <message>
        <source>Waits in the fields, not sent.</source>
        <translation>Wartet in den Feldern, nicht gesendet.</translation>
    </message>
    <message>
        <source>Not in the file: it stays as it is.</source>
        <translation>Nicht in der Datei: bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>1 motor is moving: stop it before anything is sent.</source>
        <translation>1 Motor ist in Bewegung: anhalten, bevor etwas gesendet wird.</translation>
    </message>
    <message>
        <source>%1 motors are moving: stop them before anything is sent.</source>
        <translation>%1 Motoren sind in Bewegung: anhalten, bevor etwas gesendet wird.</translation>
    </message>
    <message>
        <source>%1 was stopped: its switch stayed active while it backed off.</source>
        <translation>%1 wurde gestoppt: der Schalter blieb beim Freifahren aktiv.</translation>
    </message>
    <message>
        <source>The switch may be stuck, or the search goes the wrong way. Move the motor off the switch, or change the direction, then try again.</source>
        <translation>Vielleicht klemmt der Schalter, oder die Suche läuft in die falsche Richtung. Den Motor vom Schalter wegbewegen oder die Richtung ändern, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>%1 stopped before it found home.</source>
        <translation>%1 blieb stehen, bevor die Referenzposition gefunden war.</translation>
    </message>
    <message>
        <source>A limit or the E-stop input ended its motion. Check the direction of the search and the switches, then try again.</source>
        <translation>Ein Endschalter oder der E-Stop-Eingang hat die Bewegung beendet. Die Richtung der Suche und die Schalter prüfen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>%1 was stopped: no home within the travel limit.</source>
        <translation>%1 wurde gestoppt: keine Referenzposition innerhalb der Weggrenze.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the direction of the search, and the limit.</source>
        <translation>Den Schalter und sein Kabel, die Richtung der Suche und die Grenze prüfen.</translation>
    </message>
    <message>
        <source>%1 was stopped: no home within the time limit.</source>
        <translation>%1 wurde gestoppt: keine Referenzposition innerhalb der Zeitgrenze.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the direction and the speed of the search, and the limit.</source>
        <translation>Den Schalter und sein Kabel, die Richtung und die Geschwindigkeit der Suche und die Grenze prüfen.</translation>
    </message>
    <message>
        <source>%1 is not homed and was told to stop: the link was in doubt meanwhile.</source>
        <translation>%1 ist nicht referenziert, ein Stoppbefehl wurde gesendet: die Verbindung war währenddessen zweifelhaft.</translation>
    </message>
    <message>
        <source>What was said of home then may be wrong. See to the link, then repeat the search.</source>
        <translation>Was dabei über die Referenzposition gemeldet wurde, ist vielleicht falsch. Die Verbindung prüfen, dann die Suche wiederholen.</translation>
    </message>
    <message>
        <source>%1 is not homed and does not answer. Motor state unknown.</source>
        <translation>%1 ist nicht referenziert und antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>It was told to stop. Use the hardware stop if it moves.</source>
        <translation>Ein Stoppbefehl wurde gesendet. Den Hardware-Stopp benutzen, wenn der Motor sich bewegt.</translation>
    </message>
    <message>
        <source>%1 is not homed: its motor went off by itself, and is free to turn.</source>
        <translation>%1 ist nicht referenziert: der Motor hat sich von selbst abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The motor was too far from where it should be, or lost its power. Check for a jam, enable it, then repeat the search.</source>
        <translation>Der Motor war zu weit von der Sollposition entfernt oder verlor seine Versorgung. Prüfen, ob etwas klemmt, den Motor einschalten, dann die Suche wiederholen.</translation>
    </message>
    <message>
        <source>%1 is not homed and was told to stop: a command was not carried out, or its answer was lost.</source>
        <translation>%1 ist nicht referenziert, ein Stoppbefehl wurde gesendet: ein Befehl wurde nicht ausgeführt, oder seine Antwort ging verloren.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Repeat the search.</source>
        <translation>Meist Störungen auf dem Kabel. Die Suche wiederholen.</translation>
    </message>
    <message>
        <source>%1 stands still and is not homed: two readings of its home differ.</source>
        <translation>%1 steht still und ist nicht referenziert: zwei Lesungen der Referenzposition weichen voneinander ab.</translation>
    </message>
    <message>
        <source>%1 has found its home and holds close to it, but nothing was made zero.</source>
        <translation>%1 hat die Referenzposition gefunden und hält nahe dabei, aber nichts wurde auf null gesetzt.</translation>
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
        <source>Searching the index</source>
        <translation>Sucht den Index</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Hält an</translation>
    </message>
    <message>
        <source>Reading home twice</source>
        <translation>Liest die Referenzposition zweimal</translation>
    </message>
    <message>
        <source>Going to home</source>
        <translation>Fährt die Referenzposition an</translation>
    </message>
    <message>
        <source>Making home zero</source>
        <translation>Setzt die Referenzposition auf null</translation>
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
        <source>%1 has not finished its moves.</source>
        <translation>%1 hat seine Fahrten nicht beendet.</translation>
    </message>
    <message>
        <source>%1 has found its home: it was at %2.</source>
        <translation>%1 hat die Referenzposition gefunden: sie lag bei %2.</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 von %3</translation>
    </message>
    <message>
        <source>The switch stayed active while the motor backed off. It was stopped.</source>
        <translation>Der Schalter blieb aktiv, während der Motor freifuhr. Er wurde gestoppt.</translation>
    </message>
    <message>
        <source>The motion ended before home was found.</source>
        <translation>Die Bewegung endete, bevor die Referenzposition gefunden war.</translation>
    </message>
    <message>
        <source>The travel limit was reached. The motor was stopped.</source>
        <translation>Die Weggrenze wurde erreicht. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>The time limit was reached. The motor was stopped.</source>
        <translation>Die Zeitgrenze wurde erreicht. Der Motor wurde gestoppt.</translation>
    </message>
    <message>
        <source>The link was in doubt meanwhile. The motor was told to stop.</source>
        <translation>Die Verbindung war währenddessen zweifelhaft. An den Motor ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>The module does not answer. Motor state unknown.</source>
        <translation>Das Modul antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>The motor went off by itself, and is free to turn.</source>
        <translation>Der Motor hat sich von selbst abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>A command was not carried out or not answered. The motor was told to stop.</source>
        <translation>Ein Befehl wurde nicht ausgeführt oder nicht beantwortet. An den Motor ging ein Stoppbefehl.</translation>
    </message>
    <message>
        <source>Two readings of home differ. The motor stands still.</source>
        <translation>Zwei Lesungen der Referenzposition weichen voneinander ab. Der Motor steht still.</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its motor is off.</source>
        <translation>Modul %1 hat keine Motorversorgung, daher ist sein Motor aus.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because it is too hot.</source>
        <translation>Modul %1 hat seinen Motor abgeschaltet, weil er zu heiß ist.</translation>
    </message>
    <message>
        <source>The A/D value fell below the thermal limit. Let the motor cool down; then look at the currents and the limit on the Parameters page.</source>
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
        <source>It does not say why. Check its power and its inputs, then enable it again.</source>
        <translation>Den Grund meldet es nicht. Versorgung und Eingänge prüfen, dann wieder einschalten.</translation>
    </message>
    <message>
        <source>Amplifier off</source>
        <translation>Verstärker aus</translation>
    </message>
    <message>
        <source>Stopped by a limit</source>
        <translation>Von Endschalter gestoppt</translation>
    </message>
    <message>
        <source>E-stop input</source>
        <translation>E-Stop-Eingang</translation>
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
        <source>The module switched its motor off when motor power went away. It stays off.</source>
        <translation>Das Modul hat seinen Motor abgeschaltet, als die Motorversorgung ausfiel. Er bleibt aus.</translation>
    </message>
    <message>
        <source>The motor is held where it is.</source>
        <translation>Der Motor wird an seiner Position gehalten.</translation>
    </message>
    <message>
        <source>The motor is free to turn. Nothing is wrong: the amplifier has not been switched on, or was switched off.</source>
        <translation>Der Motor ist frei drehbar. Das ist kein Fehler: der Verstärker wurde noch nicht eingeschaltet oder wurde ausgeschaltet.</translation>
    </message>
    <message>
        <source>A limit switch stopped the motor. It can move in the other direction.</source>
        <translation>Ein Endschalter hat den Motor gestoppt. Er kann in die andere Richtung fahren.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input stopped the motor, or keeps it from moving.</source>
        <translation>Der E-Stop-Eingang des Moduls hat den Motor gestoppt oder hindert ihn an der Bewegung.</translation>
    </message>
    <message>
        <source>The module switched its motor off because the A/D value fell below the thermal limit. It stays off.</source>
        <translation>Das Modul hat seinen Motor abgeschaltet, weil der A/D-Wert unter die Temperaturgrenze gefallen ist. Er bleibt aus.</translation>
    </message>
    <message>
        <source>The module switched its motor off by itself, and does not say why.</source>
        <translation>Das Modul hat seinen Motor von selbst abgeschaltet und meldet den Grund nicht.</translation>
    </message>
    <message>
        <source>Nothing is loaded that could be started.</source>
        <translation>Es ist nichts geladen, was gestartet werden könnte.</translation>
    </message>
    <message>
        <source>The position is not known.</source>
        <translation>Die Position ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The servo is on. Switch the motor off first.</source>
        <translation>Der Servo ist ein. Zuerst den Motor abschalten.</translation>
    </message>
    <message>
        <source>This version of the chip cannot do it.</source>
        <translation>Diese Version des Chips kann das nicht.</translation>
    </message>
    <message>
        <source>Nothing is chosen that home could be found by.</source>
        <translation>Es ist nichts gewählt, woran die Referenz zu finden wäre.</translation>
    </message>
    <message>
        <source>A search needs a travel limit and a time limit above 0.</source>
        <translation>Eine Suche braucht eine Weggrenze und eine Zeitgrenze über 0.</translation>
    </message>
    <message>
        <source>The limit is active now: it would stop the motor when it is left.</source>
        <translation>Der Endschalter ist jetzt aktiv: beim Verlassen würde er den Motor stoppen.</translation>
    </message>
    <message>
        <source>The limit&apos;s pin is an output, so it tells nothing.</source>
        <translation>Der Pin des Endschalters ist ein Ausgang und meldet daher nichts.</translation>
    </message>
    <message>
        <source>A move by 0 is none.</source>
        <translation>Eine Fahrt um 0 ist keine.</translation>
    </message>
    <message>
        <source>This module is not a PIC-STEP.</source>
        <translation>Dieses Modul ist kein PIC-STEP.</translation>
    </message>
    <message>
        <source>The module moves and holds nothing before it was given its parameters. Apply them first.</source>
        <translation>Das Modul bewegt und hält nichts, bevor es seine Parameter bekommen hat. Zuerst die Parameter anwenden.</translation>
    </message>
    <message>
        <source>The amplifier is off. Enable it first.</source>
        <translation>Der Verstärker ist aus. Zuerst einschalten.</translation>
    </message>
    <message>
        <source>The motor is moving, and the chip does not allow this change in motion: stop first.</source>
        <translation>Der Motor ist in Bewegung, und der Chip lässt diese Änderung während der Fahrt nicht zu: zuerst stoppen.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input is active and keeps the motor from moving.</source>
        <translation>Der E-Stop-Eingang des Moduls ist aktiv und hindert den Motor an der Bewegung.</translation>
    </message>
    <message>
        <source>Limit switch 1 is active: the motor can move in reverse only.</source>
        <translation>Endschalter 1 ist aktiv: der Motor kann nur rückwärts fahren.</translation>
    </message>
    <message>
        <source>Limit switch 2 is active: the motor can move forward only.</source>
        <translation>Endschalter 2 ist aktiv: der Motor kann nur vorwärts fahren.</translation>
    </message>
    <message>
        <source>The A/D value is below the thermal limit: the module would switch the motor off at once.</source>
        <translation>Der A/D-Wert liegt unter der Temperaturgrenze: das Modul würde den Motor sofort abschalten.</translation>
    </message>
    <message>
        <source>The goal is more than 2 147 483 647 steps away.</source>
        <translation>Das Ziel ist mehr als 2 147 483 647 Schritte entfernt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open; settings taken from it: %2.</source>
        <translation>„%1“ ist offen; daraus übernommene Einstellungen: %2.</translation>
    </message>
    <message>
        <source>Commands sent, as chosen: %1. No motor was moved.</source>
        <translation>Gesendete Befehle, wie gewählt: %1. Kein Motor wurde bewegt.</translation>
    </message>
    <message>
        <source>Leader of group %1</source>
        <translation>Leitmodul der Gruppe %1</translation>
    </message>
    <message>
        <source>Cannot be applied: the file is for another module.</source>
        <translation>Kann nicht angewendet werden: die Datei ist für ein anderes Modul.</translation>
    </message>
    <message>
        <source>Not there now; its settings are kept.</source>
        <translation>Jetzt nicht da; seine Einstellungen werden behalten.</translation>
    </message>
    <message>
        <source>%1 holds again: it went the wrong way, or farther than twice its step.</source>
        <translation>%1 hält wieder: der Motor lief in die falsche Richtung oder weiter als die doppelte Sprungstrecke.</translation>
    </message>
    <message>
        <source>The servo swings, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.</source>
        <translation>Der Servo schwingt, oder etwas anderes dreht den Motor. Kp und Ki senken oder Kd erhöhen, dann den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>%1 was switched off and is free to turn: it did not calm down after its step.</source>
        <translation>%1 wurde abgeschaltet und ist frei drehbar: der Motor kam nach dem Sprung nicht zur Ruhe.</translation>
    </message>
    <message>
        <source>The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it.</source>
        <translation>Der Servo ist mit diesen Reglerwerten nicht stabil. Kp und Ki senken oder Kd erhöhen, die Werte anwenden, dann einschalten.</translation>
    </message>
    <message>
        <source>%1 does not stand still; its servo stays on.</source>
        <translation>%1 steht nicht still; der Servo bleibt ein.</translation>
    </message>
    <message>
        <source>It swings, or is turned from outside. Lower Kp and Ki, or raise Kd; Motor off ends it at once.</source>
        <translation>Der Motor schwingt oder wird von außen gedreht. Kp und Ki senken oder Kd erhöhen; „Motor aus“ beendet es sofort.</translation>
    </message>
    <message>
        <source>%1 made no whole step: its motor went off by itself, and is free to turn.</source>
        <translation>%1 hat keinen ganzen Sprung gemacht: der Motor ging von selbst aus und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The motor was too far from where it should be, or lost its power. Check for a jam, raise EL or make the step shorter, then enable it.</source>
        <translation>Der Motor war zu weit von der Sollposition entfernt oder verlor seine Versorgung. Prüfen, ob etwas klemmt, EL erhöhen oder den Sprung verkleinern, dann einschalten.</translation>
    </message>
    <message>
        <source>%1 does not answer, so its step is not recorded. Motor state unknown.</source>
        <translation>%1 antwortet nicht, der Sprung ist daher nicht aufgezeichnet. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>It was told to hold. Use the hardware stop if it moves.</source>
        <translation>Ein Haltebefehl wurde gesendet. Den Hardware-Stopp benutzen, wenn der Motor sich bewegt.</translation>
    </message>
    <message>
        <source>%1 was told to hold, and its step is not recorded: the link was in doubt meanwhile.</source>
        <translation>%1 bekam einen Haltebefehl, und der Sprung ist nicht aufgezeichnet: die Verbindung war währenddessen zweifelhaft.</translation>
    </message>
    <message>
        <source>See to the link, then step again.</source>
        <translation>Die Verbindung prüfen, dann den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>%1 has no step recorded and was told to hold: a command was not carried out, or its answer was lost.</source>
        <translation>%1 hat keinen Sprung aufgezeichnet und bekam einen Haltebefehl: ein Befehl wurde nicht ausgeführt, oder seine Antwort ging verloren.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Step again.</source>
        <translation>Meist Störungen auf dem Kabel. Den Sprung wiederholen.</translation>
    </message>
    <message>
        <source>The motor does not stand still; its servo stays on. Lower the gains, or switch it off.</source>
        <translation>Der Motor steht nicht still; sein Servo bleibt ein. Die Reglerwerte senken oder den Motor abschalten.</translation>
    </message>
    <message>
        <source>The motor swung by more than the whole step and did not calm down, so it was switched off and is free to turn. Lower Kp and Ki, or raise Kd.</source>
        <translation>Der Motor schwang um mehr als den ganzen Sprung und kam nicht zur Ruhe; er wurde daher abgeschaltet und ist frei drehbar. Kp und Ki senken oder Kd erhöhen.</translation>
    </message>
    <message>
        <source>its folder is not there.</source>
        <translation>den Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>this is a folder or a device, not a file.</source>
        <translation>das ist ein Ordner oder ein Gerät, keine Datei.</translation>
    </message>
    <message>
        <source>your user account may not write there.</source>
        <translation>Ihr Benutzerkonto darf dort nicht schreiben.</translation>
    </message>
    <message>
        <source>the disk can only be read.</source>
        <translation>der Datenträger ist nur lesbar.</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>the disk takes no larger file.</source>
        <translation>der Datenträger nimmt keine größere Datei auf.</translation>
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
        <source>the disk does not take it.</source>
        <translation>der Datenträger nimmt sie nicht an.</translation>
    </message>
    <message>
        <source>the file ends before the names of its columns.</source>
        <translation>die Datei endet vor den Namen ihrer Spalten.</translation>
    </message>
    <message>
        <source>there is no column %1.</source>
        <translation>die Spalte %1 fehlt.</translation>
    </message>
    <message>
        <source>the line is longer than %1 bytes, as no line of a recording is.</source>
        <translation>die Zeile ist länger als %1 Byte, wie keine Zeile einer Aufzeichnung.</translation>
    </message>
    <message>
        <source>the file ends here, in the middle of the line.</source>
        <translation>die Datei endet hier, mitten in der Zeile.</translation>
    </message>
    <message>
        <source>there are %1 cells for %2 columns.</source>
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
        <source>%1 of module %2 goes back.</source>
        <translation>%1 von Modul %2 läuft zurück.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is recorded: %2.</source>
        <translation>„%1“ ist aufgezeichnet: %2.</translation>
    </message>
    <message>
        <source>It is in %1.</source>
        <translation>Die Datei ist in %1.</translation>
    </message>
    <message>
        <source>What was written before (%1) is kept.</source>
        <translation>Das zuvor Geschriebene (%1) bleibt erhalten.</translation>
    </message>
    <message>
        <source>Nothing is kept.</source>
        <translation>Nichts bleibt erhalten.</translation>
    </message>
    <message>
        <source>Recording to &quot;%1&quot; ended: %2</source>
        <translation>Die Aufzeichnung in „%1“ ist beendet: %2</translation>
    </message>
    <message>
        <source>%1 Control goes on. To go on recording, choose another file.</source>
        <translation>%1 Die Steuerung läuft weiter. Um weiter aufzuzeichnen, eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a recording of NMC Panel.</source>
        <translation>„%1“ ist keine Aufzeichnung von NMC Panel.</translation>
    </message>
    <message>
        <source>There is nothing to show of it.</source>
        <translation>Davon lässt sich nichts zeigen.</translation>
    </message>
    <message>
        <source>The scope shows what stands above that line: %1 samples.</source>
        <translation>Das Oszilloskop zeigt, was über dieser Zeile steht: %1 Messwerte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no samples in it.</source>
        <translation>„%1“ enthält keine Messwerte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is saved.</source>
        <translation>„%1“ ist gespeichert.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved.</source>
        <translation>„%1“ wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>Show the last 2 s</source>
        <translation>Die letzten 2 s zeigen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stop of all motors</source>
        <translation>Stopp aller Motoren</translation>
    </message>
    <message>
        <source>A step response is for a small move: at most 2000 counts.</source>
        <translation>Eine Sprungantwort ist für eine kleine Bewegung: höchstens 2000 Inkremente.</translation>
    </message>
    <message>
        <source>The step would switch the servo off: right after it the position error is the whole step, which is above the position error limit, or too close to it. Make the step shorter or raise EL.</source>
        <translation>Der Sprung würde den Servo abschalten: gleich danach ist der Positionsfehler der ganze Sprung, und der liegt über der Grenze der Regelabweichung oder zu nahe an ihr. Den Sprung verkleinern oder EL erhöhen.</translation>
    </message>
    <message>
        <source>The goal is beyond the positions the chip can count.</source>
        <translation>Das Ziel liegt außerhalb der Positionen, die der Chip zählen kann.</translation>
    </message>
    <message>
        <source>A record takes from 0.02 s to 3 s.</source>
        <translation>Eine Aufzeichnung dauert 0,02 s bis 3 s.</translation>
    </message>
    <message>
        <source>No motor moves any more. All are told to stop before the port closes.</source>
        <translation>Kein Motor bewegt sich mehr. Alle erhalten den Stoppbefehl, bevor der Anschluss geschlossen wird.</translation>
    </message>
    <message>
        <source>Motors were told to stop. Try a lower rate, a shorter cable, or termination at both ends.</source>
        <translation>Die Motoren erhielten den Stoppbefehl. Eine niedrigere Rate, ein kürzeres Kabel oder Abschlusswiderstände an beiden Enden versuchen.</translation>
    </message>
    <message>
        <source>Nothing was lost: wrong answers are recognised and asked for again. Motors are told to stop if it gets worse. Usually noise on the cable.</source>
        <translation>Nichts ging verloren: Falsche Antworten werden erkannt und noch einmal erfragt. Die Motoren erhalten den Stoppbefehl, wenn es schlimmer wird. Meist Störungen auf dem Kabel.</translation>
    </message>
    <message>
        <source>It listens at 19 200 Bd, where the others&apos; traffic is noise to it: all motors were told to stop, and nothing is sent any more.</source>
        <translation>Es hört mit 19 200 Bd, wo der Verkehr der anderen für es Rauschen ist: Alle Motoren erhielten den Stoppbefehl, und es wird nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>The panel was frozen for %1; motors were told to stop after 2 s.</source>
        <translation>Das Programm reagierte %1 lang nicht; die Motoren erhielten nach 2 s den Stoppbefehl.</translation>
    </message>
    <message>
        <source>It was connected to %1, and was killed, or the computer failed. Motor state unknown: look at it before you connect; use the hardware stop if it moves. This is said until the motor was seen at rest.</source>
        <translation>Sie war mit %1 verbunden und wurde abgebrochen, oder der Rechner fiel aus. Zustand des Motors unbekannt: vor dem Verbinden nachsehen; den Hardware-Stopp benutzen, wenn er sich bewegt. Das steht hier, bis der Motor stillstehend gesehen wurde.</translation>
    </message>
    <message>
        <source>I have looked: it stands still</source>
        <translation>Ich habe nachgesehen: Er steht still</translation>
    </message>
    <message>
        <source>Module %1 does not answer</source>
        <translation>Modul %1 antwortet nicht</translation>
    </message>
    <message>
        <source>Modules %1 do not answer</source>
        <translation>Die Module %1 antworten nicht</translation>
    </message>
    <message>
        <source>Module %1 was told to stop but was not seen at rest</source>
        <translation>Modul %1 erhielt den Stoppbefehl, wurde aber nicht stillstehend gesehen</translation>
    </message>
    <message>
        <source>Modules %1 were told to stop but were not seen at rest</source>
        <translation>Die Module %1 erhielten den Stoppbefehl, wurden aber nicht stillstehend gesehen</translation>
    </message>
    <message>
        <source>The others keep their positions and gains when it is only given its address.</source>
        <translation>Die anderen behalten Position und Reglerwerte, wenn es nur seine Adresse erhält.</translation>
    </message>
    <message>
        <source>Give module %1 its address</source>
        <translation>Modul %1 seine Adresse geben</translation>
    </message>
    <message>
        <source>Module %1 has its address again. It is off, at position 0 and without gains.</source>
        <translation>Modul %1 hat seine Adresse wieder. Es ist aus, auf Position 0 und ohne Reglerwerte.</translation>
    </message>
    <message>
        <source>The other modules are as they were. Send its gains and home it before you use it.</source>
        <translation>Die anderen Module sind, wie sie waren. Vor dem Benutzen seine Reglerwerte senden und die Referenzfahrt machen.</translation>
    </message>
    <message>
        <source>Module %1 was not given its address. No motor moved by it.</source>
        <translation>Modul %1 erhielt seine Adresse nicht. Kein Motor bewegte sich dadurch.</translation>
    </message>
    <message>
        <source>It does not answer. Scan again, or restart the network.</source>
        <translation>Es antwortet nicht. Erneut suchen oder das Netz neu starten.</translation>
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
        <source>No stop could be confirmed.</source>
        <translation>Kein Stopp konnte bestätigt werden.</translation>
    </message>
    <message>
        <source>%1 of %2 stopped.</source>
        <translation>%1 von %2 gestoppt.</translation>
    </message>
    <message>
        <source>Module %1 has stopped.</source>
        <translation>Modul %1 steht jetzt.</translation>
    </message>
    <message>
        <source>It has stopped.</source>
        <translation>Es steht jetzt.</translation>
    </message>
    <message>
        <source>Module %1 was told to stop: the button was held, but the panel was too slow to say so.</source>
        <translation>Modul %1 erhielt den Stoppbefehl: Der Knopf war gedrückt, aber das Programm war zu langsam, es zu melden.</translation>
    </message>
    <message>
        <source>Module %1 was told to switch off: it moved the wrong way, to %2 counts.</source>
        <translation>Modul %1 erhielt den Befehl, auszuschalten: Es bewegte sich in die falsche Richtung, bis %2 Inkremente.</translation>
    </message>
    <message>
        <source>Module %1 was told to stop: it went past its goal, to %2 counts.</source>
        <translation>Modul %1 erhielt den Stoppbefehl: Es fuhr über sein Ziel hinaus, bis %2 Inkremente.</translation>
    </message>
    <message>
        <source>Module %1 was told to stop: it says that it moves, but reports %2 counts again and again.</source>
        <translation>Modul %1 erhielt den Stoppbefehl: Es sagt, dass es sich bewegt, meldet aber immer wieder %2 Inkremente.</translation>
    </message>
    <message>
        <source>Module %1 limits the current of its motor: overcurrent.</source>
        <translation>Modul %1 begrenzt den Strom seines Motors: Überstrom.</translation>
    </message>
    <message>
        <source>The motor may not reach its goal, or not hold its load. Check for a jam or too heavy a load, or raise the limit. It says so until the sticky bits are cleared.</source>
        <translation>Vielleicht erreicht der Motor sein Ziel nicht oder hält seine Last nicht. Auf Klemmen oder zu große Last prüfen oder die Grenze erhöhen. Das Modul meldet es, bis die Sticky-Bits gelöscht werden.</translation>
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
        <source>The shaft moves although the motor is off: a load turns it, or it is still running down. No stop holds it; use a brake, or enable the servo.</source>
        <translation>Die Welle bewegt sich, obwohl der Motor aus ist: Eine Last dreht sie, oder sie läuft noch aus. Kein Stopp hält sie; eine Bremse benutzen oder den Servo einschalten.</translation>
    </message>
    <message>
        <source>The motor stands, but its current was limited: it may not hold its load. This stays until the sticky bits are cleared.</source>
        <translation>Der Motor steht, aber sein Strom wurde begrenzt: Vielleicht hält er seine Last nicht. Das bleibt so, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>The panel ended without stopping its motors; its guardian told module %1 to stop.</source>
        <translation>Das Panel endete, ohne seine Motoren anzuhalten; sein Wächter hat Modul %1 angewiesen, anzuhalten.</translation>
    </message>
    <message>
        <source>The panel ended without stopping its motors; its guardian told modules %1 to stop.</source>
        <translation>Das Panel endete, ohne seine Motoren anzuhalten; sein Wächter hat die Module %1 angewiesen, anzuhalten.</translation>
    </message>
    <message>
        <source>The program was killed, or it hung. The guardian cannot see whether a motor obeyed: look at it before you connect; use the hardware stop if it moves.</source>
        <translation>Das Programm wurde beendet, oder es hing. Der Wächter kann nicht sehen, ob ein Motor gehorcht hat: vor dem Verbinden hinsehen; den Hardware-Stopp benutzen, wenn er sich bewegt.</translation>
    </message>
    <message>
        <source>The panel stood still while a motor was moving; its guardian told the motors to stop.</source>
        <translation>Das Panel stand still, während sich ein Motor bewegte; sein Wächter hat die Motoren angewiesen, anzuhalten.</translation>
    </message>
    <message>
        <source>The program was halted, or the computer was too busy. Every value is being read again.</source>
        <translation>Das Programm war angehalten, oder der Rechner war zu beschäftigt. Alle Werte werden neu gelesen.</translation>
    </message>
    <message>
        <source>Nobody stops the motors if this program is killed: it has no guardian.</source>
        <translation>Niemand hält die Motoren an, wenn dieses Programm abgeschossen wird: Es hat keinen Wächter.</translation>
    </message>
    <message>
        <source>nmcguard, a part of this program, is missing. Install the program again. Everything else works.</source>
        <translation>nmcguard, ein Teil dieses Programms, fehlt. Das Programm neu installieren. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>This user may not start nmcguard, a part of this program. Everything else works.</source>
        <translation>Dieser Benutzer darf nmcguard, einen Teil dieses Programms, nicht starten. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The nmcguard of this program is of another version. Install the program again. Everything else works.</source>
        <translation>Das nmcguard dieses Programms hat eine andere Version. Das Programm neu installieren. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The computer has no memory or no file left for it. Close other programs, then connect again. Everything else works.</source>
        <translation>Der Rechner hat keinen Speicher oder keine Datei mehr dafür frei. Andere Programme schließen, dann neu verbinden. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>It has ended by itself. Connect again to start another one. Everything else works.</source>
        <translation>Er hat sich von selbst beendet. Neu verbinden, um einen anderen zu starten. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses its power, a motor that runs keeps running, and no program can stop it. Stop all, and Esc, work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs.</source>
        <translation>Diese Module überwachen die Verbindung nicht: Wenn das Kabel durchtrennt ist, der Adapter hängt oder dieser Rechner seinen Strom verliert, läuft ein laufender Motor weiter, und kein Programm kann ihn anhalten. ALLES STOPP und Esc wirken nur, solange die Verbindung besteht. Ein Wächter hält die Motoren an, wenn dieses Programm abgeschossen wird, abstürzt oder hängt.</translation>
    </message>
    <message>
        <source>--read-only needs something to look at: --port or --simulator.</source>
        <translation>--read-only braucht etwas zum Ansehen: --port oder --simulator.</translation>
    </message>
    <message>
        <source>Module %1 of the chain known here does not answer. Motor state unknown.</source>
        <translation>Modul %1 der hier bekannten Kette antwortet nicht. Motorzustand unbekannt.</translation>
    </message>
    <message>
        <source>Its place is kept for it. Usually its power or the plug next to it; it is asked again all the time. If it was taken out on purpose, work with the others: then it is forgotten.</source>
        <translation>Sein Platz bleibt ihm. Meist liegt es an seiner Versorgung oder am Stecker daneben; es wird laufend wieder gefragt. Wurde es absichtlich entfernt, mit den anderen arbeiten: Dann wird es vergessen.</translation>
    </message>
    <message>
        <source>A motor is moving, so the chain stays as it is known.</source>
        <translation>Ein Motor ist in Bewegung, die Kette bleibt daher, wie sie bekannt ist.</translation>
    </message>
    <message>
        <source>To forget a module, the chain is looked for anew. Stop all motors, then try again.</source>
        <translation>Um ein Modul zu vergessen, wird die Kette neu gesucht. Alle Motoren anhalten, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Looking at %1 read-only: %2 at %3 Bd, left as they were.</source>
        <translation>Nur lesend an %1: %2 bei %3 Bd, unverändert gelassen.</translation>
    </message>
    <message>
        <source>What they are doing goes on, also when this connection ends. Nothing is sent but questions; STOP ALL acts.</source>
        <translation>Was sie tun, geht weiter, auch wenn diese Verbindung endet. Außer Fragen wird nichts gesendet; ALLES STOPP wirkt.</translation>
    </message>
    <message>
        <source>A port is open already.</source>
        <translation>Ein Port ist schon offen.</translation>
    </message>
    <message>
        <source>Disconnect first; closing it may stop motors. Then look again.</source>
        <translation>Zuerst trennen; das Schließen hält Motoren unter Umständen an. Dann noch einmal ansehen.</translation>
    </message>
    <message>
        <source>Motor %1 was moving, at %2.</source>
        <translation>Motor %1 war in Bewegung, an %2.</translation>
    </message>
    <message>
        <source>Motors %1 were moving, at %2.</source>
        <translation>Die Motoren %1 waren in Bewegung, an %2.</translation>
    </message>
    <message>
        <source>This is said until the motor was seen at rest.</source>
        <translation>Diese Meldung bleibt, bis der Motor im Stillstand gesehen wurde.</translation>
    </message>
    <message>
        <source>Connect fully</source>
        <translation>Voll verbinden</translation>
    </message>
    <message>
        <source>Look first (read-only)</source>
        <translation>Erst ansehen (nur lesen)</translation>
    </message>
    <message>
        <source>This connection is read-only: nothing is sent but questions. Connect fully first.</source>
        <translation>Diese Verbindung ist nur zum Lesen: Außer Fragen wird nichts gesendet. Zuerst voll verbinden.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, read-only</source>
        <translation>Verbunden mit %1 bei %2 Bd, %3, nur lesend</translation>
    </message>
    <message>
        <source>Only the echo of the adapter at %1 came back: no module answered.</source>
        <translation>Nur das Echo des Adapters an %1 kam zurück: kein Modul hat geantwortet.</translation>
    </message>
    <message>
        <source>The echo itself does no harm. Check, in this order: module power; every cable in the chain, one loose cable hides all modules; that the transmit pair of the modules is wired to the adapter, too.</source>
        <translation>Das Echo selbst schadet nicht. In dieser Reihenfolge prüfen: Versorgung der Module; jedes Kabel der Kette, ein loses verbirgt alle Module; ob auch das Sendepaar der Module am Adapter angeschlossen ist.</translation>
    </message>
    <message>
        <source>The adapter at %1 returns what is sent to it. The panel ignores it.</source>
        <translation>Der Adapter an %1 gibt zurück, was ihm gesendet wird. Das Programm lässt das unbeachtet.</translation>
    </message>
    <message>
        <source>That is how a 2-wire adapter works. Nothing needs to be done.</source>
        <translation>So arbeitet ein Zweidraht-Adapter. Es ist nichts zu tun.</translation>
    </message>
    <message>
        <source>not behind the exact echo of its command</source>
        <translation>nicht hinter dem genauen Echo des Befehls</translation>
    </message>
    <message>
        <source>Somebody else is sending on this line.</source>
        <translation>Jemand anders sendet auf dieser Leitung.</translation>
    </message>
    <message>
        <source>Module %1 was told to stop.</source>
        <translation>Modul %1 hat den Stoppbefehl bekommen.</translation>
    </message>
    <message>
        <source>Modules %1 were told to stop.</source>
        <translation>Die Module %1 haben den Stoppbefehl bekommen.</translation>
    </message>
    <message>
        <source>Modules answer commands that did not come from here; what was under way here was cancelled. End the other program, or take its computer off the line, before you go on.</source>
        <translation>Module antworten auf Befehle, die nicht von hier kamen; was hier im Gang war, wurde abgebrochen. Das andere Programm beenden oder seinen Rechner von der Leitung nehmen, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>Module %1 moves, and not because of this panel.</source>
        <translation>Modul %1 bewegt sich, und nicht durch dieses Programm.</translation>
    </message>
    <message>
        <source>Another host on this line has started it, or a load drives it. The panel leaves it alone unless you stop it; that host may start it again.</source>
        <translation>Ein anderer Rechner auf dieser Leitung hat es gestartet, oder eine Last treibt es. Das Programm greift nicht ein, solange Sie es nicht stoppen; es kann von dort wieder gestartet werden.</translation>
    </message>
    <message>
        <source>STOP ALL</source>
        <translation>ALLES STOPP</translation>
    </message>
    <message>
        <source>Where home is, is not known: search for it, or save it.</source>
        <translation>Wo die Referenz liegt, ist nicht bekannt: suchen oder speichern.</translation>
    </message>
    <message>
        <source>It rests %1 off its home, and zero would be off by as much: friction keeps it there. Raise Ki and IL on the page Gains, or clear &quot;Make it zero&quot; on the page Homing. What is close enough follows from the unit on the page Axis.</source>
        <translation>Der Motor ruht %1 neben seiner Referenz, und null läge ebenso weit daneben: Reibung hält ihn dort. Ki und IL auf der Seite Reglerwerte erhöhen oder „Auf null setzen“ auf der Seite Referenzsuche abwählen. Was nah genug ist, folgt aus der Einheit auf der Seite Achse.</translation>
    </message>
    <message>
        <source>%1 has no verdict on its direction, and its motor is off.</source>
        <translation>%1: kein Ergebnis zur Drehrichtung, und der Motor ist aus.</translation>
    </message>
    <message>
        <source>%1 has no verdict on its direction, and its motor was told to switch off.</source>
        <translation>%1: kein Ergebnis zur Drehrichtung, und der Motor wurde angewiesen, sich abzuschalten.</translation>
    </message>
    <message>
        <source>It was turned farther than the check allows: something else turns it, or it runs on for long. See that it stands still, then check again.</source>
        <translation>Er wurde weiter gedreht, als die Prüfung erlaubt: Etwas anderes dreht ihn, oder er läuft lange nach. Dafür sorgen, dass er stillsteht, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>It does not stand still although nothing drives it. See what turns it, then check again.</source>
        <translation>Er steht nicht still, obwohl ihn nichts antreibt. Nachsehen, was ihn dreht, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>The link was in doubt meanwhile. See to the link, then check again.</source>
        <translation>Die Verbindung war unterdessen zweifelhaft. Die Verbindung in Ordnung bringen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>%1 has no verdict on its direction and does not answer. Motor state unknown.</source>
        <translation>%1: kein Ergebnis zur Drehrichtung, und das Modul antwortet nicht. Zustand des Motors unbekannt.</translation>
    </message>
    <message>
        <source>It was told to switch off. Use the hardware stop if it moves.</source>
        <translation>Er wurde angewiesen, sich abzuschalten. Den Hardware-Not-Halt benutzen, falls er sich bewegt.</translation>
    </message>
    <message>
        <source>A command was not carried out, or its answer was lost. Check again.</source>
        <translation>Ein Befehl wurde nicht ausgeführt, oder seine Antwort ging verloren. Erneut prüfen.</translation>
    </message>
    <message>
        <source>%1: motor and encoder go the same way.</source>
        <translation>%1: Motor und Encoder laufen in dieselbe Richtung.</translation>
    </message>
    <message>
        <source>%1: motor or encoder is reversed. Do not enable it.</source>
        <translation>%1: Motor oder Encoder ist vertauscht. Nicht einschalten.</translation>
    </message>
    <message>
        <source>%1 did not move when it was pushed.</source>
        <translation>%1 hat sich beim Anstoßen nicht bewegt.</translation>
    </message>
    <message>
        <source>%1 closed a limit switch, so it was not pushed on.</source>
        <translation>%1 hat einen Endschalter geschlossen und wurde deshalb nicht weiter angestoßen.</translation>
    </message>
    <message>
        <source>%1 lost its motor power while it was pushed.</source>
        <translation>%1 hat beim Anstoßen die Motorversorgung verloren.</translation>
    </message>
    <message>
        <source>%1 did not move one way and the other.</source>
        <translation>%1 hat sich nicht hin und her bewegt.</translation>
    </message>
    <message>
        <source>It rests %1 off its home, and is zero there.</source>
        <translation>Der Motor ruht %1 neben seiner Referenz, und dort ist null.</translation>
    </message>
    <message>
        <source>It rests too far from its home for a zero. See Ki and IL on the page Gains.</source>
        <translation>Der Motor ruht zu weit neben seiner Referenz für ein Nullsetzen. Siehe Ki und IL auf der Seite Reglerwerte.</translation>
    </message>
    <message>
        <source>All right: driven forward it counts up, in reverse down. It can be enabled.</source>
        <translation>In Ordnung: Vorwärts angetrieben zählt er aufwärts, rückwärts abwärts. Er kann eingeschaltet werden.</translation>
    </message>
    <message>
        <source>Reversed: driven forward it counts down. Enabled like this it would run away. Swap the motor&apos;s two leads, or the encoder&apos;s A and B, then check again.</source>
        <translation>Vertauscht: Vorwärts angetrieben zählt er abwärts. So eingeschaltet würde er davonlaufen. Die beiden Motorleitungen oder A und B des Encoders vertauschen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>No movement with %1 % of the supply, and motor power is there: look for a jam or a brake, at the cables of motor and encoder, or for a load that is too heavy.</source>
        <translation>Keine Bewegung mit %1 % der Versorgung, und die Motorversorgung ist da: nach einer Blockade oder Bremse, nach den Kabeln von Motor und Encoder oder nach einer zu schweren Last sehen.</translation>
    </message>
    <message>
        <source>A limit input is active: it may stand in a switch that takes its power away.</source>
        <translation>Ein Endschaltereingang ist aktiv: Vielleicht steht er in einem Schalter, der ihm den Strom nimmt.</translation>
    </message>
    <message>
        <source>Limit 1 closed on the way.</source>
        <translation>Endschalter 1 hat unterwegs geschlossen.</translation>
    </message>
    <message>
        <source>Limit 2 closed on the way.</source>
        <translation>Endschalter 2 hat unterwegs geschlossen.</translation>
    </message>
    <message>
        <source>Turn the motor away from its end by hand, then check again.</source>
        <translation>Den Motor von Hand vom Ende wegdrehen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Motor power went away. Switch it on, then check again.</source>
        <translation>Die Motorversorgung ist ausgefallen. Einschalten, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Not clear: it moved one way only, or the same way twice. Something blocks or turns it. Turn it away from its end by hand, take the load off, then check again.</source>
        <translation>Nicht eindeutig: Er bewegte sich nur in eine Richtung oder zweimal in dieselbe. Etwas blockiert oder dreht ihn. Von Hand vom Ende wegdrehen, die Last abnehmen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Check for a jam, or raise EL on the page Gains.</source>
        <translation>Auf eine Blockade prüfen oder EL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>It ran away from where it was told to be: motor or encoder is probably reversed. Make the direction check on the page Axis before you enable it again.</source>
        <translation>Er ist von seiner Sollposition davongelaufen: Motor oder Encoder ist wahrscheinlich vertauscht. Vor dem erneuten Einschalten die Richtungsprüfung auf der Seite Achse machen.</translation>
    </message>
    <message>
        <source>It was driven and did not move: look for a jam, a brake or an end stop, and at the motor&apos;s cable. If it is only hard to turn, raise OL on the page Gains.</source>
        <translation>Er wurde angetrieben und hat sich nicht bewegt: nach einer Blockade, einer Bremse, einem Anschlag und nach dem Motorkabel sehen. Ist er nur schwergängig, OL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>Limit 1 closed on the way: it is probably at the end of its travel. Drive it the other way; a limit stop on the page Homing ends a motion in time.</source>
        <translation>Endschalter 1 hat unterwegs geschlossen: Er ist wahrscheinlich am Ende seines Wegs. In die andere Richtung fahren; ein Endschalter-Stopp auf der Seite Referenzsuche beendet eine Bewegung rechtzeitig.</translation>
    </message>
    <message>
        <source>Limit 2 closed on the way: it is probably at the end of its travel. Drive it the other way; a limit stop on the page Homing ends a motion in time.</source>
        <translation>Endschalter 2 hat unterwegs geschlossen: Er ist wahrscheinlich am Ende seines Wegs. In die andere Richtung fahren; ein Endschalter-Stopp auf der Seite Referenzsuche beendet eine Bewegung rechtzeitig.</translation>
    </message>
    <message>
        <source>It moved as it was told, and could not keep up: lower its velocity or acceleration, or raise OL and EL on the page Gains.</source>
        <translation>Er bewegte sich wie verlangt und kam nicht nach: Geschwindigkeit oder Beschleunigung senken oder OL und EL auf der Seite Reglerwerte erhöhen.</translation>
    </message>
    <message>
        <source>Limit %1 of module %2 closed while its motor was moving.</source>
        <translation>Endschalter %1 von Modul %2 hat geschlossen, während sich der Motor bewegte.</translation>
    </message>
    <message>
        <source>The module lets its motor go no farther that way while the switch is closed. Move it the other way.</source>
        <translation>Das Modul lässt den Motor in dieser Richtung nicht weiter, solange der Schalter geschlossen ist. In die andere Richtung fahren.</translation>
    </message>
    <message>
        <source>Limit %1 of module %2 closed while its motor was moving, and does not stop it.</source>
        <translation>Endschalter %1 von Modul %2 hat geschlossen, während sich der Motor bewegte, und stoppt ihn nicht.</translation>
    </message>
    <message>
        <source>A PIC-SERVO stops at a limit by itself only where a limit stop is armed, and none was there. Stop it, then move it the other way; the page Homing arms a limit stop.</source>
        <translation>Ein PIC-SERVO stoppt an einem Endschalter nur dann von selbst, wenn ein Endschalter-Stopp scharf ist, und hier war keiner scharf. Motor stoppen, dann in die andere Richtung fahren; die Seite Referenzsuche schaltet einen Endschalter-Stopp scharf.</translation>
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
        <source>It acts once, and is not armed any more. Move the motor off the switch, then arm it again on the page Homing, or disarm it there.</source>
        <translation>Er wirkt einmal und ist nicht mehr scharf. Den Motor vom Schalter wegfahren, dann auf der Seite Referenzsuche wieder scharf schalten oder dort entschärfen.</translation>
    </message>
    <message>
        <source>%1 is being saved. The window closes as soon as the disk has it.</source>
        <translation>%1 wird gespeichert. Das Fenster schließt sich, sobald es auf dem Datenträger ist.</translation>
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
        <source>Left to the operator</source>
        <translation>Dem Bediener überlassen</translation>
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
        <source>Module %1 stood %2 from home when it was seen last.</source>
        <translation>Modul %1 stand %2 von der Referenz entfernt, als es zuletzt gesehen wurde.</translation>
    </message>
    <message>
        <source>That was on %1; a search had found that home. If nothing has moved the axis since, home can be taken from that: not verified, until a search finds it.</source>
        <translation>Das war am %1; die Referenz hatte eine Suche gefunden. Hat seither nichts die Achse bewegt, kann sie daraus übernommen werden: nicht bestätigt, bis eine Suche sie findet.</translation>
    </message>
    <message>
        <source>That was on %1; that home had been saved. If nothing has moved the axis since, home can be taken from that: not verified, until a search finds it.</source>
        <translation>Das war am %1; die Referenz war gespeichert worden. Hat seither nichts die Achse bewegt, kann sie daraus übernommen werden: nicht bestätigt, bis eine Suche sie findet.</translation>
    </message>
    <message>
        <source>Take home from that</source>
        <translation>Referenz daraus übernehmen</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Messages are not kept beyond this session.</source>
        <translation>Meldungen werden nicht über diese Sitzung hinaus aufbewahrt.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Everything else works; the list of messages has an export.</source>
        <translation>%1 kann nicht geschrieben werden. Alles andere geht; die Liste der Meldungen lässt sich exportieren.</translation>
    </message>
    <message>
        <source>Limit %1 of module %2 stopped its motor.</source>
        <translation>Endschalter %1 von Modul %2 hat seinen Motor angehalten.</translation>
    </message>
    <message>
        <source>The E-stop input of module %1 is active: its motor is on, and does not move.</source>
        <translation>Der E-Stop-Eingang von Modul %1 ist aktiv: Sein Motor ist an und bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Release the input; nothing moves by that.</source>
        <translation>Geben Sie den Eingang frei; dadurch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>The panel is in operator mode, and this is not left to the operator.</source>
        <translation>Das Programm ist im Bedienermodus, und dies ist dem Bediener nicht überlassen.</translation>
    </message>
    <message>
        <source>A trapezoidal move is loaded first and then started by Start, so that a garbled load never moves anything.</source>
        <translation>Eine Trapezfahrt wird zuerst geladen und dann mit „Starten“ gestartet, damit ein gestörter Ladebefehl nie etwas bewegt.</translation>
    </message>
    <message>
        <source>it has no name.</source>
        <translation>der Name fehlt.</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is taken already.</source>
        <translation>der Name „%1“ ist schon vergeben.</translation>
    </message>
    <message>
        <source>module %1 is there twice.</source>
        <translation>Modul %1 kommt zweimal vor.</translation>
    </message>
    <message>
        <source>there is no point &quot;%1&quot;.</source>
        <translation>es gibt keinen Punkt „%1“.</translation>
    </message>
    <message>
        <source>there is no sequence &quot;%1&quot;.</source>
        <translation>es gibt keinen Ablauf „%1“.</translation>
    </message>
    <message>
        <source>by this row the sequence &quot;%1&quot; would call itself and never end.</source>
        <translation>mit dieser Zeile würde der Ablauf „%1“ sich selbst aufrufen und nie enden.</translation>
    </message>
    <message>
        <source>a repeat goes back to a row above it.</source>
        <translation>eine Wiederholung springt zu einer Zeile über ihr zurück.</translation>
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
        <source>It has no name.</source>
        <translation>Der Name fehlt.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is taken already.</source>
        <translation>Der Name „%1“ ist schon vergeben.</translation>
    </message>
    <message>
        <source>%1 is in point &quot;%2&quot; twice.</source>
        <translation>%1 kommt im Punkt „%2“ zweimal vor.</translation>
    </message>
    <message>
        <source>There is no point &quot;%1&quot;.</source>
        <translation>Es gibt keinen Punkt „%1“.</translation>
    </message>
    <message>
        <source>There is no sequence &quot;%1&quot;.</source>
        <translation>Es gibt keinen Ablauf „%1“.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; would call itself and never end.</source>
        <translation>Der Ablauf „%1“ würde sich selbst aufrufen und nie enden.</translation>
    </message>
    <message>
        <source>A repeat goes back to a row above it.</source>
        <translation>Eine Wiederholung springt zu einer Zeile über ihr zurück.</translation>
    </message>
    <message>
        <source>The sequence has no rows.</source>
        <translation>Der Ablauf hat keine Zeilen.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; has no axes. Teach it again.</source>
        <translation>Der Punkt „%1“ hat keine Achsen. Ihn neu teachen.</translation>
    </message>
    <message>
        <source>%1 is not in the chain.</source>
        <translation>%1 ist nicht in der Kette.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 was taught in point &quot;%2&quot; before its home was known, so the place may be another one now. Teach it again.</source>
        <translation>%1 wurde im Punkt „%2“ geteacht, bevor seine Referenz bekannt war; die Stelle kann jetzt eine andere sein. Den Punkt neu teachen.</translation>
    </message>
    <message>
        <source>%1 has not been told how to find its home. See its page Homing.</source>
        <translation>Für %1 ist nicht festgelegt, wie die Referenz gesucht wird. Siehe dort die Seite Referenzsuche.</translation>
    </message>
    <message>
        <source>%1 does not have this input or output.</source>
        <translation>%1 hat diesen Ein- oder Ausgang nicht.</translation>
    </message>
    <message>
        <source>This limit pin of %1 is an output, so it tells nothing.</source>
        <translation>Dieser Endschalteranschluss von %1 ist ein Ausgang und sagt daher nichts.</translation>
    </message>
    <message>
        <source>This limit pin of %1 is not known to be an output. See its page I/O.</source>
        <translation>Von diesem Endschalteranschluss von %1 ist nicht bekannt, dass er ein Ausgang ist. Siehe dort die Seite E/A.</translation>
    </message>
    <message>
        <source>The outputs of %1 are not known. Set them once on its page I/O.</source>
        <translation>Die Ausgänge von %1 sind nicht bekannt. Sie dort einmal auf der Seite E/A setzen.</translation>
    </message>
    <message>
        <source>A run from the top never comes here: a repeat for ever stands above.</source>
        <translation>Ein Lauf von oben kommt nie hierher: darüber steht eine endlose Wiederholung.</translation>
    </message>
    <message>
        <source>A run from the top would have %1 at its home here. Move it there first.</source>
        <translation>Bei einem Lauf von oben stünde %1 hier an seiner Referenz. Erst dorthin fahren.</translation>
    </message>
    <message>
        <source>A run from the top would have %1 at point &quot;%2&quot; here. Move it there first.</source>
        <translation>Bei einem Lauf von oben stünde %1 hier am Punkt „%2“. Erst dorthin fahren.</translation>
    </message>
    <message>
        <source>A run from the top would have set output %1 of %2 otherwise here. Set it first.</source>
        <translation>Bei einem Lauf von oben wäre Ausgang %1 von %2 hier anders gesetzt. Ihn erst setzen.</translation>
    </message>
    <message>
        <source>You have stopped it.</source>
        <translation>Sie haben ihn gestoppt.</translation>
    </message>
    <message>
        <source>All motors were stopped.</source>
        <translation>Alle Motoren wurden gestoppt.</translation>
    </message>
    <message>
        <source>%1 was told something else, or was moved by somebody else.</source>
        <translation>%1 bekam einen anderen Befehl oder wurde von anderer Seite bewegt.</translation>
    </message>
    <message>
        <source>A limit switch of %1 closed on the way.</source>
        <translation>Ein Endschalter von %1 schloss unterwegs.</translation>
    </message>
    <message>
        <source>%1 stopped before it was there.</source>
        <translation>%1 blieb vor dem Ziel stehen.</translation>
    </message>
    <message>
        <source>The motor of %1 went off.</source>
        <translation>Der Motor von %1 ging aus.</translation>
    </message>
    <message>
        <source>The input of %1 that it waited for did not come in time.</source>
        <translation>Der Eingang von %1, auf den gewartet wurde, kam nicht rechtzeitig.</translation>
    </message>
    <message>
        <source>%1 has not found its home.</source>
        <translation>%1 hat die Referenz nicht gefunden.</translation>
    </message>
    <message>
        <source>The link was in doubt.</source>
        <translation>Die Verbindung war zweifelhaft.</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1 antwortet nicht.</translation>
    </message>
    <message>
        <source>A command to %1 was refused or not answered.</source>
        <translation>Ein Befehl an %1 wurde abgelehnt oder nicht beantwortet.</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1, round %2</source>
        <translation>%1, Durchgang %2</translation>
    </message>
    <message>
        <source>Move to &quot;%1&quot;</source>
        <translation>Fahrt zu „%1“</translation>
    </message>
    <message>
        <source>Home all</source>
        <translation>Alle referenzieren</translation>
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
        <source>limit 1</source>
        <translation>Endschalter 1</translation>
    </message>
    <message>
        <source>limit 2</source>
        <translation>Endschalter 2</translation>
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
        <source>%1: at %2, home not known</source>
        <translation>%1: bei %2, Referenz unbekannt</translation>
    </message>
    <message>
        <source>%1, row %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>Runs: %1</source>
        <translation>Läuft: %1</translation>
    </message>
    <message>
        <source>Finishes its row, then pauses: %1</source>
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
        <source>Paused by a doubt, motors stopped: %1. %2</source>
        <translation>Aus Zweifel pausiert, Motoren gestoppt: %1. %2</translation>
    </message>
    <message>
        <source>Over: %1. %2</source>
        <translation>Zu Ende: %1. %2</translation>
    </message>
    <message>
        <source>%1 is done.</source>
        <translation>%1 ist fertig.</translation>
    </message>
    <message>
        <source>%1 paused, and its motors were told to stop.</source>
        <translation>%1 pausiert; die Motoren bekamen den Stoppbefehl.</translation>
    </message>
    <message>
        <source>%1 has ended, and its motors were told to stop.</source>
        <translation>%1 wurde beendet; die Motoren bekamen den Stoppbefehl.</translation>
    </message>
    <message>
        <source>It was at: %1. Nothing moves again by itself; choose the row to go on from, and run from there.</source>
        <translation>Stand: %1. Von selbst fährt nichts mehr; die Zeile wählen, bei der es weitergehen soll, und von dort starten.</translation>
    </message>
    <message>
        <source>Nothing was started.</source>
        <translation>Nichts wurde gestartet.</translation>
    </message>
    <message>
        <source>Dry run: it would not be started.</source>
        <translation>Probelauf: er würde nicht gestartet.</translation>
    </message>
    <message>
        <source>Dry run: the simulated copy was not ready. Try again.</source>
        <translation>Probelauf: die simulierte Kopie war nicht bereit. Noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Dry run: it takes longer than %1 s and was not followed any farther.</source>
        <translation>Probelauf: er dauert länger als %1 s und wurde nicht weiter verfolgt.</translation>
    </message>
    <message>
        <source>Dry run: done after %1 s.</source>
        <translation>Probelauf: fertig nach %1 s.</translation>
    </message>
    <message>
        <source>Dry run: it would end after %1 s. %2</source>
        <translation>Probelauf: er würde nach %1 s enden. %2</translation>
    </message>
    <message>
        <source>Searches for home take longer than here: %1.</source>
        <translation>Referenzsuchen dauern länger als hier: %1.</translation>
    </message>
    <message>
        <source>Inputs came at once here.</source>
        <translation>Eingänge kamen hier sofort.</translation>
    </message>
    <message>
        <source>A repeat for ever was done once.</source>
        <translation>Eine endlose Wiederholung lief einmal.</translation>
    </message>
    <message>
        <source>The motors were the simulator&apos;s; yours may take longer.</source>
        <translation>Die Motoren waren die des Simulators; Ihre können länger brauchen.</translation>
    </message>
    <message>
        <source>the lowest position of travel is not below the highest.</source>
        <translation>die tiefste Position des Fahrwegs liegt nicht unter der höchsten.</translation>
    </message>
    <message>
        <source>Limits of travel and speed</source>
        <translation>Grenzen von Fahrweg und Geschwindigkeit</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>Endschalter-Stopp</translation>
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
        <source>Distance beyond the goal</source>
        <translation>Weg über das Ziel hinaus</translation>
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
        <source>%1 was stopped: no home within its limits of travel, nor where home was.</source>
        <translation>%1 wurde angehalten: keine Referenz innerhalb der Fahrweggrenzen, auch nicht dort, wo sie war.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, and the direction of the search. If the position is wrong, say so on the page Axis (Position in doubt): the search then goes by its own travel limit.</source>
        <translation>Schalter, Kabel und Suchrichtung prüfen. Stimmt die Position nicht, das auf der Seite Achse angeben (Position zweifelhaft): Dann gilt für die Suche nur ihre eigene Weggrenze.</translation>
    </message>
    <message>
        <source>Taking up backlash</source>
        <translation>Spiel wird herausgefahren</translation>
    </message>
    <message>
        <source>The way on leads beyond the limits of travel. The motor was stopped.</source>
        <translation>Der weitere Weg führt über die Fahrweggrenzen hinaus. Der Motor wurde angehalten.</translation>
    </message>
    <message>
        <source>Module %1 was told to stop: it was about to leave its limits of travel.</source>
        <translation>Modul %1 wurde zum Anhalten aufgefordert: Es war im Begriff, seine Fahrweggrenzen zu verlassen.</translation>
    </message>
    <message>
        <source>The chip does not end this kind of motion by itself, so the panel did. See where it stands before you go on.</source>
        <translation>Der Chip beendet diese Art von Bewegung nicht selbst, deshalb tat es das Panel. Vor dem Weiterfahren nachsehen, wo sie steht.</translation>
    </message>
    <message>
        <source>That is beyond the limits of travel of this axis (page Axis).</source>
        <translation>Das liegt außerhalb der Fahrweggrenzen dieser Achse (Seite Achse).</translation>
    </message>
    <message>
        <source>The limit of travel is reached: there is no way on in that direction.</source>
        <translation>Die Fahrweggrenze ist erreicht: In dieser Richtung geht es nicht weiter.</translation>
    </message>
    <message>
        <source>That is faster than this axis may go (page Axis).</source>
        <translation>Das ist schneller, als diese Achse fahren darf (Seite Achse).</translation>
    </message>
    <message>
        <source>Towards a limit of travel a run starts from standstill, so that the chip ends it there: stop first.</source>
        <translation>Auf eine Fahrweggrenze zu beginnt ein Lauf im Stillstand, damit der Chip ihn dort beendet: zuerst anhalten.</translation>
    </message>
    <message>
        <source>The limit stop of this axis is not armed yet; it is about to be.</source>
        <translation>Der Endschalter-Stopp dieser Achse ist noch nicht scharf; er wird es gleich.</translation>
    </message>
    <message>
        <source>The current limit CL is 0 or unknown, so the current would never stop the motor.</source>
        <translation>Die Stromgrenze CL ist 0 oder unbekannt, der Strom würde den Motor also nie anhalten.</translation>
    </message>
    <message>
        <source>A limit switch, heat or the E-stop input ended the move. The motor stands still.</source>
        <translation>Ein Endschalter, Hitze oder der Not-Halt-Eingang hat die Fahrt beendet. Der Motor steht.</translation>
    </message>
    <message>
        <source>Not every module of group %1 has certainly set its position to 0.</source>
        <translation>Nicht jedes Modul der Gruppe %1 hat seine Position sicher auf 0 gesetzt.</translation>
    </message>
    <message>
        <source>Not every module of group %1 has certainly cleared its sticky bits: what lasts sets its bit again at once.</source>
        <translation>Nicht jedes Modul der Gruppe %1 hat seine Sticky-Bits sicher gelöscht: Was andauert, setzt sein Bit sofort wieder.</translation>
    </message>
    <message>
        <source>Not every module of group %1 has certainly done it.</source>
        <translation>Nicht jedes Modul der Gruppe %1 hat es sicher ausgeführt.</translation>
    </message>
    <message>
        <source>A group is told something only when every member answers and may be told that now, and when the group of every module is known. Ask the modules one by one, or give this module its group again.</source>
        <translation>Einer Gruppe wird nur etwas gesagt, wenn jedes Mitglied antwortet und das jetzt darf und wenn die Gruppe jedes Moduls bekannt ist. Die Module einzeln ansprechen oder diesem Modul seine Gruppe erneut geben.</translation>
    </message>
    <message>
        <source>Group %1 was told to switch its motors off: module %2.</source>
        <translation>Die Gruppe %1 soll ihre Motoren ausschalten: Modul %2.</translation>
    </message>
    <message>
        <source>Group %1 was told to stop: module %2.</source>
        <translation>Die Gruppe %1 soll anhalten: Modul %2.</translation>
    </message>
    <message>
        <source>The port of this computer cannot make %1 Bd. Choose another rate.</source>
        <translation>Der Anschluss dieses Rechners kann %1 Bd nicht erzeugen. Eine andere Rate wählen.</translation>
    </message>
    <message>
        <source>Module %1 has address %2 now. Position, gains and group are what they were.</source>
        <translation>Modul %1 hat jetzt die Adresse %2. Position, Reglerwerte und Gruppe sind, was sie waren.</translation>
    </message>
    <message>
        <source>Another module answers there, or no module may have that address. Choose one of 1 to 127 that is free.</source>
        <translation>Dort antwortet ein anderes Modul, oder kein Modul darf diese Adresse haben. Eine freie von 1 bis 127 wählen.</translation>
    </message>
    <message>
        <source>Its group is not known here and would be changed with the address. Give it a group first, or none.</source>
        <translation>Seine Gruppe ist hier nicht bekannt und würde mit der Adresse geändert. Ihm zuerst eine Gruppe geben oder keine.</translation>
    </message>
    <message>
        <source>Which position the servo holds is not known to the count. Hold it here first, or move it.</source>
        <translation>Welche Position der Servo hält, ist nicht auf das Inkrement genau bekannt. Erst hier halten oder verfahren.</translation>
    </message>
    <message>
        <source>Module %1 holds its motor, and the motor oscillates.</source>
        <translation>Modul %1 hält seinen Motor, und der Motor schwingt.</translation>
    </message>
    <message>
        <source>Its servo is not stable with these gains. Lower Kp and Ki, or raise Kd, and apply them.</source>
        <translation>Sein Servo ist mit diesen Reglerwerten nicht stabil. Kp und Ki senken oder Kd erhöhen und anwenden.</translation>
    </message>
    <message>
        <source>Motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>Back to the gains before</source>
        <translation>Zurück zu den Reglerwerten davor</translation>
    </message>
    <message>
        <source>%1 has the gains from before again: it began to swing.</source>
        <translation>%1 hat wieder die Reglerwerte von vorher: Es begann zu schwingen.</translation>
    </message>
    <message>
        <source>Lower Kp and Ki, or raise Kd, then try again.</source>
        <translation>Kp und Ki verringern oder Kd erhöhen, dann noch einmal probieren.</translation>
    </message>
    <message>
        <source>%1 has the gains from before again: it left the place where it stood.</source>
        <translation>%1 hat wieder die Reglerwerte von vorher: Es hat seinen Platz verlassen.</translation>
    </message>
    <message>
        <source>These gains do not hold its load, or something else turned it.</source>
        <translation>Diese Reglerwerte halten seine Last nicht, oder etwas anderes hat es gedreht.</translation>
    </message>
    <message>
        <source>%1 went off by itself while gains were tried, and is free to turn.</source>
        <translation>%1 ist beim Probieren von Reglerwerten von selbst ausgegangen und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The gains from before were sent again. Check for a jam, then enable it.</source>
        <translation>Die Reglerwerte von vorher wurden wieder gesendet. Auf Klemmen prüfen, dann einschalten.</translation>
    </message>
    <message>
        <source>%1 does not answer while gains are tried. Motor state unknown.</source>
        <translation>%1 antwortet beim Probieren von Reglerwerten nicht. Zustand des Motors unbekannt.</translation>
    </message>
    <message>
        <source>The gains from before were sent. Use the hardware stop if it moves.</source>
        <translation>Die Reglerwerte von vorher wurden gesendet. Hardware-Not-Halt benutzen, wenn es sich bewegt.</translation>
    </message>
    <message>
        <source>%1 was sent the gains from before: the link was in doubt meanwhile.</source>
        <translation>%1 wurden die Reglerwerte von vorher gesendet: Die Verbindung war inzwischen zweifelhaft.</translation>
    </message>
    <message>
        <source>See to the link, then try again.</source>
        <translation>Die Verbindung prüfen, dann noch einmal probieren.</translation>
    </message>
    <message>
        <source>%1 was sent the gains from before: a command was not carried out, or its answer was lost.</source>
        <translation>%1 wurden die Reglerwerte von vorher gesendet: Ein Befehl wurde nicht ausgeführt, oder seine Antwort ging verloren.</translation>
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
        <source>%1 has the gains from before again: the try is over.</source>
        <translation>%1 hat wieder die Reglerwerte von vorher: Die Probe ist vorbei.</translation>
    </message>
    <message>
        <source>The motor began to swing. The gains from before are back.</source>
        <translation>Der Motor begann zu schwingen. Die Reglerwerte von vorher gelten wieder.</translation>
    </message>
    <message>
        <source>The page was not printed.</source>
        <translation>Die Seite wurde nicht gedruckt.</translation>
    </message>
    <message>
        <source>%1 Export the page as a PDF file, and print that elsewhere.</source>
        <translation>%1 Die Seite als PDF-Datei exportieren und anderswo drucken.</translation>
    </message>
    <message>
        <source>The page is on its way to the printer.</source>
        <translation>Die Seite ist auf dem Weg zum Drucker.</translation>
    </message>
    <message>
        <source>It went to the printer that this computer uses unless told otherwise.</source>
        <translation>Sie ging an den Standarddrucker dieses Rechners.</translation>
    </message>
    <message>
        <source>The program %1 is not installed, which hands pages to the printer.</source>
        <translation>Das Programm %1, das Seiten an den Drucker gibt, ist nicht installiert.</translation>
    </message>
    <message>
        <source>The print system does not take it: see the details.</source>
        <translation>Das Drucksystem nimmt sie nicht an: siehe Einzelheiten.</translation>
    </message>
    <message>
        <source>The step responses of this machine were not read.</source>
        <translation>Die Sprungantworten dieser Maschine wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of step responses.</source>
        <translation>„%1“ ist keine Datei mit Sprungantworten.</translation>
    </message>
    <message>
        <source>Nothing of it is lost: when new ones are kept, it is set aside in %1.</source>
        <translation>Davon geht nichts verloren: Wenn neue aufbewahrt werden, wird sie in %1 beiseitegelegt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read. When new ones are kept, it is set aside.</source>
        <translation>„%1“ kann nicht gelesen werden. Wenn neue aufbewahrt werden, wird sie beiseitegelegt.</translation>
    </message>
    <message>
        <source>The step responses of this session are not kept.</source>
        <translation>Die Sprungantworten dieser Sitzung werden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Export them before you close the panel.</source>
        <translation>%1 kann nicht geschrieben werden. Exportieren Sie sie, bevor Sie das Panel schließen.</translation>
    </message>
    <message>
        <source>%1: the test of its loop has ended early.</source>
        <translation>%1: Die Prüfung des Regelkreises endete vorzeitig.</translation>
    </message>
    <message>
        <source>The motor went farther than the test allows, and was told to hold. Look for a load that pulls it, or choose gentler gains.</source>
        <translation>Der Motor ging weiter, als die Prüfung erlaubt, und soll jetzt halten. Eine Last suchen, die an ihm zieht, oder sanftere Reglerwerte wählen.</translation>
    </message>
    <message>
        <source>A value of this test is out of its range.</source>
        <translation>Ein Wert dieser Prüfung liegt außerhalb seines Bereichs.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Inputs and outputs answer. No motor is connected here.</source>
        <translation>Ein- und Ausgänge antworten. Hier ist kein Motor angeschlossen.</translation>
    </message>
    <message>
        <source>This module drives no motor.</source>
        <translation>Dieses Modul treibt keinen Motor.</translation>
    </message>
    <message>
        <source>This module is not a PIC-I/O.</source>
        <translation>Dieses Modul ist kein PIC-I/O.</translation>
    </message>
</context>
<context>
    <name>TravelTexts</name>
    <message>
        <source>That is %1; this axis goes at most %2 (page Axis).</source>
        <translation>Das sind %1; diese Achse fährt höchstens %2 (Seite Achse).</translation>
    </message>
    <message>
        <source>The lowest position of this axis is %1: there is no way on in reverse.</source>
        <translation>Die tiefste Position dieser Achse ist %1: Rückwärts geht es nicht weiter.</translation>
    </message>
    <message>
        <source>The highest position of this axis is %1: there is no way on forward.</source>
        <translation>Die höchste Position dieser Achse ist %1: Vorwärts geht es nicht weiter.</translation>
    </message>
    <message>
        <source>That is beyond the limits of travel: the lowest position to go to is %1.</source>
        <translation>Das liegt außerhalb der Fahrweggrenzen: Die tiefste Position, die angefahren werden kann, ist %1.</translation>
    </message>
    <message>
        <source>That is beyond the limits of travel: the highest position to go to is %1.</source>
        <translation>Das liegt außerhalb der Fahrweggrenzen: Die höchste Position, die angefahren werden kann, ist %1.</translation>
    </message>
    <message>
        <source>No limits of travel are set.</source>
        <translation>Keine Fahrweggrenzen gesetzt.</translation>
    </message>
    <message>
        <source>Not in force: home is not known. Search for it, save it, or declare the position right.</source>
        <translation>Nicht in Kraft: Die Referenz ist nicht bekannt. Suchen, speichern oder die Position für richtig erklären.</translation>
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
        <source>Limits of travel not in force</source>
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
        <source>Is %1 really at %2 now? Then home is where the position is 0, and the limits of travel are in force from there. If it is not, they protect the wrong places. Look at the axis itself first.</source>
        <translation>Steht %1 jetzt wirklich bei %2? Dann liegt die Referenz, wo die Position 0 ist, und die Fahrweggrenzen gelten von dort aus. Wenn nicht, schützen sie die falschen Stellen. Zuerst die Achse selbst ansehen.</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>steps/s</source>
        <translation>Schritte/s</translation>
    </message>
    <message>
        <source>steps/s²</source>
        <translation>Schritte/s²</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
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
        <source>Each axis at its own velocity of hold to move.</source>
        <translation>Jede Achse mit ihrer eigenen Tippgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Each axis at its own cap of hold to move, which is set on its page Axis.</source>
        <translation>Jede Achse mit ihrer eigenen Höchstgeschwindigkeit beim Tippen, die auf ihrer Seite Achse steht.</translation>
    </message>
    <message>
        <source>How far one click on Step moves an axis, in its own unit.</source>
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
        <source>Enable all motors where they stand</source>
        <translation>Alle Motoren einschalten, wo sie stehen</translation>
    </message>
    <message>
        <source>Home all</source>
        <translation>Alle referenzieren</translation>
    </message>
    <message>
        <source>Find the home of all axes, one after the other</source>
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
        <source>No axis has a recipe for its home. See the page Homing of each.</source>
        <translation>Für keine Achse ist festgelegt, wie die Referenz gesucht wird. Siehe jeweils die Seite Referenzsuche.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No module.</source>
        <translation>Kein Modul.</translation>
    </message>
    <message>
        <source>All motors are enabled.</source>
        <translation>Alle Motoren sind eingeschaltet.</translation>
    </message>
    <message>
        <source>Enables each motor that can be, where it stands.</source>
        <translation>Schaltet jeden Motor ein, bei dem es möglich ist, wo er steht.</translation>
    </message>
    <message>
        <source>Finds the home of one axis after the other, in the order that stands in the table, by their recipes. Any stop ends it.</source>
        <translation>Sucht die Referenz einer Achse nach der anderen, in der Reihenfolge der Tabelle und wie jeweils festgelegt. Jeder Stopp beendet es.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisBox</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Name of the axis</source>
        <translation>Name der Achse</translation>
    </message>
    <message>
        <source>for example Z axis</source>
        <translation>zum Beispiel Z-Achse</translation>
    </message>
    <message>
        <source>What this axis is called, in the list, in messages and in files.</source>
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
        <source>the chip&apos;s own</source>
        <translation>die des Chips</translation>
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
        <source>a unit of your own</source>
        <translation>eine eigene Einheit</translation>
    </message>
    <message>
        <source>What positions and speeds are shown in. Changing it keeps every amount and sends nothing.</source>
        <translation>Worin Positionen und Geschwindigkeiten angezeigt werden. Beim Wechsel bleibt jeder Betrag erhalten, und es wird nichts gesendet.</translation>
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
        <source>How many counts or steps of the chip make one unit.</source>
        <translation>Wie viele Inkremente oder Schritte des Chips eine Einheit ergeben.</translation>
    </message>
    <message>
        <source>Symbol of the unit</source>
        <translation>Zeichen der Einheit</translation>
    </message>
    <message>
        <source>What stands behind the numbers, for example µl.</source>
        <translation>Was hinter den Zahlen steht, zum Beispiel µl.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Cap of hold to move</source>
        <translation>Höchstwert für Tippen</translation>
    </message>
    <message>
        <source>The cap of hold to move</source>
        <translation>Der Höchstwert für Tippen</translation>
    </message>
    <message>
        <source>Hold to move never goes faster than this.</source>
        <translation>Beim Tippen wird nie schneller gefahren.</translation>
    </message>
    <message>
        <source>&amp;Jog cap</source>
        <translation>H&amp;öchstwert Tippen</translation>
    </message>
    <message>
        <source>A/D, each step</source>
        <translation>A/D, je Stufe</translation>
    </message>
    <message>
        <source>What one of the 255 steps of the A/D value stands for, for example 5 V / 255, or amperes by the amplifier&apos;s current sense.</source>
        <translation>Wofür eine der 255 Stufen des A/D-Werts steht, zum Beispiel 5 V / 255 oder Ampere nach der Strommessung des Verstärkers.</translation>
    </message>
    <message>
        <source>A/D at &amp;0</source>
        <translation>A/D bei &amp;0</translation>
    </message>
    <message>
        <source>What an A/D value of 0 stands for.</source>
        <translation>Wofür ein A/D-Wert von 0 steht.</translation>
    </message>
    <message>
        <source>Unit of the A/D value</source>
        <translation>Einheit des A/D-Werts</translation>
    </message>
    <message>
        <source>A, V, or what the A/D input measures here.</source>
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
        <source>Work it out…</source>
        <translation>Berechnen…</translation>
    </message>
    <message>
        <source>Work it out from encoder, gear and screw</source>
        <translation>Aus Encoder, Getriebe und Spindel berechnen</translation>
    </message>
    <message>
        <source>Works the unit out from what stands on the labels of encoder, gear and screw. Sends nothing.</source>
        <translation>Berechnet die Einheit aus den Angaben auf den Typenschildern von Encoder, Getriebe und Spindel. Sendet nichts.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisRow</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>State of %1</source>
        <translation>Zustand von %1</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position von %1</translation>
    </message>
    <message>
        <source>◂ Hold</source>
        <translation>◂ Tippen</translation>
    </message>
    <message>
        <source>Move %1 in reverse while held</source>
        <translation>%1 rückwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Hold ▸</source>
        <translation>Tippen ▸</translation>
    </message>
    <message>
        <source>Move %1 forward while held</source>
        <translation>%1 vorwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>◂| Step</source>
        <translation>◂| Schritt</translation>
    </message>
    <message>
        <source>Move %1 one step in reverse</source>
        <translation>%1 einen Schritt rückwärts fahren</translation>
    </message>
    <message>
        <source>Step |▸</source>
        <translation>Schritt |▸</translation>
    </message>
    <message>
        <source>Move %1 one step forward</source>
        <translation>%1 einen Schritt vorwärts fahren</translation>
    </message>
    <message>
        <source>Home earlier</source>
        <translation>Früher referenzieren</translation>
    </message>
    <message>
        <source>Home all takes %1 one place earlier</source>
        <translation>„Alle referenzieren“ nimmt %1 eine Stelle früher</translation>
    </message>
    <message>
        <source>This step is less than one count of this axis, or more than it can go.</source>
        <translation>Dieser Schritt ist kleiner als ein Count dieser Achse oder größer, als sie fahren kann.</translation>
    </message>
    <message>
        <source>Moves forward while it is held, then stops.</source>
        <translation>Fährt vorwärts, solange sie gedrückt ist, und stoppt dann.</translation>
    </message>
    <message>
        <source>Moves in reverse while it is held, then stops.</source>
        <translation>Fährt rückwärts, solange sie gedrückt ist, und stoppt dann.</translation>
    </message>
    <message>
        <source>Moves forward by the step above, and holds there.</source>
        <translation>Fährt um den Schritt oben vorwärts und hält dort.</translation>
    </message>
    <message>
        <source>Moves in reverse by the step above, and holds there.</source>
        <translation>Fährt um den Schritt oben rückwärts und hält dort.</translation>
    </message>
    <message>
        <source>This axis has no recipe for its home. See its page Homing.</source>
        <translation>Für diese Achse ist nicht festgelegt, wie die Referenz gesucht wird. Siehe ihre Seite Referenzsuche.</translation>
    </message>
    <message>
        <source>Home all begins with this axis.</source>
        <translation>„Alle referenzieren“ beginnt mit dieser Achse.</translation>
    </message>
    <message>
        <source>Home all finds the home of this axis as number %1; a click makes it one earlier. Nothing moves.</source>
        <translation>„Alle referenzieren“ sucht die Referenz dieser Achse als Nummer %1; ein Klick nimmt sie eine Stelle früher. Nichts fährt.</translation>
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
        <source>Hide this message here. It stays in the list of messages.</source>
        <translation>Diese Meldung hier ausblenden. Sie bleibt in der Liste der Meldungen.</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>Diese Meldung ausblenden</translation>
    </message>
    <message>
        <source>Shows the whole text, and all other messages, in the list of messages.</source>
        <translation>Zeigt den ganzen Text und alle anderen Meldungen in der Liste der Meldungen.</translation>
    </message>
    <message>
        <source>Show the list of messages</source>
        <translation>Die Liste der Meldungen zeigen</translation>
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
        <source>S&amp;ounds</source>
        <translation>&amp;Töne</translation>
    </message>
    <message>
        <source>A sound at each fault, and at the end of a sequence, of a search for home or of moves by N.</source>
        <translation>Ein Ton bei jedem Fehler und am Ende eines Ablaufs, einer Referenzfahrt oder von Schritten um N.</translation>
    </message>
</context>
<context>
    <name>nmc::BenchTruth</name>
    <message>
        <source>What the simulator knows of the module</source>
        <translation>Was der Simulator vom Modul weiß</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Welle</translation>
    </message>
    <message>
        <source>Where the shaft really is, since the simulation began.</source>
        <translation>Wo die Welle wirklich steht, seit Beginn der Simulation.</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Positionszähler</translation>
    </message>
    <message>
        <source>What the module believes.</source>
        <translation>Was das Modul glaubt.</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>True, not calculated.</source>
        <translation>Wahr, nicht berechnet.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
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
        <source>steps/s</source>
        <translation>Schritte/s</translation>
    </message>
    <message>
        <source>Negative in reverse.</source>
        <translation>Rückwärts negativ.</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>von 255</translation>
    </message>
    <message>
        <source>The sign is the direction.</source>
        <translation>Das Vorzeichen ist die Richtung.</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>Motorstrom</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
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
        <source>What a real module would not have forgiven.</source>
        <translation>Was ein echtes Modul nicht verziehen hätte.</translation>
    </message>
    <message>
        <source>%1 s, module %2: %3, %4</source>
        <translation>%1 s, Modul %2: %3, %4</translation>
    </message>
</context>
<context>
    <name>nmc::BodePlot</name>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Sines of the command show how the loop follows, from slow to fast.</source>
        <translation>Noch ist nichts gemessen. Sinusschwingungen des Sollwerts zeigen, wie der Kreis folgt, von langsam bis schnell.</translation>
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
        <source>Frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
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
        <source>T: how the position follows the command. L: what the loop makes of its error; where it crosses 0 dB its phase above -180° is the phase margin. Behind the grey line the baud rate is too low to measure. Bars: two standard deviations of T.</source>
        <translation>T: wie die Position der Sollposition folgt. L: was der Regelkreis aus seinem Fehler macht; wo L durch 0 dB geht, ist seine Phase über -180° die Phasenreserve. Hinter der grauen Linie ist die Baudrate zum Messen zu niedrig. Balken: zwei Standardabweichungen von T.</translation>
    </message>
</context>
<context>
    <name>nmc::ChainDialog</name>
    <message>
        <source>Chain</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Doctor, groups and rate</source>
        <translation>Diagnose, Gruppen und Rate</translation>
    </message>
    <message>
        <source>Doctor</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
</context>
<context>
    <name>nmc::ChainMenu</name>
    <message>
        <source>Chain &amp;doctor…</source>
        <translation>Kettendia&amp;gnose…</translation>
    </message>
    <message>
        <source>What is expected, what is there, and where the chain probably breaks.</source>
        <translation>Was erwartet wird, was da ist und wo die Kette wahrscheinlich unterbrochen ist.</translation>
    </message>
    <message>
        <source>&amp;Groups…</source>
        <translation>&amp;Gruppen…</translation>
    </message>
    <message>
        <source>Who listens to which group; starting loaded moves at once.</source>
        <translation>Wer auf welche Gruppe hört; geladene Fahrten gleichzeitig starten.</translation>
    </message>
    <message>
        <source>R&amp;ate of the chain…</source>
        <translation>&amp;Rate der Kette…</translation>
    </message>
    <message>
        <source>Takes the whole chain to another rate.</source>
        <translation>Stellt die ganze Kette auf eine andere Rate um.</translation>
    </message>
    <message>
        <source>&amp;Scan again</source>
        <translation>Erneut &amp;suchen</translation>
    </message>
    <message>
        <source>Looks for the chain again; nothing is reset.</source>
        <translation>Sucht die Kette neu; nichts wird zurückgesetzt.</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost…</source>
        <translation>Netzwerk &amp;neu starten: Positionen und Reglerwerte gehen verloren…</translation>
    </message>
    <message>
        <source>Resets every module and gives addresses again. Asks first.</source>
        <translation>Setzt jedes Modul zurück und vergibt die Adressen neu. Fragt vorher nach.</translation>
    </message>
</context>
<context>
    <name>nmc::ChainModel</name>
    <message>
        <source>PC</source>
        <translation>PC</translation>
    </message>
    <message>
        <source>%1, address %2, %3, %4, position %5 %6</source>
        <translation>%1, Adresse %2, %3, %4, Position %5 %6</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
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
        <source>%1, oscillating</source>
        <translation>%1, schwingt</translation>
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
    <name>nmc::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl finden</translation>
    </message>
    <message>
        <source>Words of the command</source>
        <translation>Wörter des Befehls</translation>
    </message>
    <message>
        <source>Type what to do, for example: go home</source>
        <translation>Eingeben, was zu tun ist, zum Beispiel: Referenz</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
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
        <source>What it does, or why it can&apos;t be done</source>
        <translation>Was er tut, oder warum er nicht möglich ist</translation>
    </message>
    <message>
        <source>No command has these words.</source>
        <translation>Kein Befehl enthält diese Wörter.</translation>
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
        <source>Rate in Bd</source>
        <translation>Rate in Bd</translation>
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
        <source>The serial port the modules are on, or the simulator.</source>
        <translation>Die serielle Schnittstelle, an der die Module hängen, oder der Simulator.</translation>
    </message>
    <message>
        <source>The rate to work at. Connecting starts at 19 200 Bd, then changes to this one.</source>
        <translation>Die Arbeitsrate. Der Verbindungsaufbau beginnt mit 19 200 Bd und wechselt dann zu dieser Rate.</translation>
    </message>
    <message>
        <source>Por&amp;t</source>
        <translation>P&amp;ort</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Bd</source>
        <translation>Bd</translation>
    </message>
    <message>
        <source>not in the list of ports</source>
        <translation>nicht in der Liste der Ports</translation>
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
        <source>Opens the port and looks for modules. Nothing moves.</source>
        <translation>Öffnet den Port und sucht Module. Nichts bewegt sich.</translation>
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
        <source>goes to all modules</source>
        <translation>geht an alle Module</translation>
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
        <source>Opens the port and only looks: nothing is sent but questions. STOP ALL acts.</source>
        <translation>Öffnet den Port und sieht nur zu: Außer Fragen wird nichts gesendet. ALLES STOPP wirkt.</translation>
    </message>
</context>
<context>
    <name>nmc::ControlLineBox</name>
    <message>
        <source>Control line</source>
        <translation>Steuerzeile</translation>
    </message>
    <message>
        <source>A line as nmcsim takes it, then Enter: state, set, power-cycle, break, mend, stats, time, fault. Ctrl+L comes here.</source>
        <translation>Eine Zeile, wie nmcsim sie versteht, dann Eingabe: state, set, power-cycle, break, mend, stats, time, fault. Strg+L führt hierher.</translation>
    </message>
    <message>
        <source>The simulator&apos;s answer</source>
        <translation>Antwort des Simulators</translation>
    </message>
</context>
<context>
    <name>nmc::CounterBox</name>
    <message>
        <source>Set, from 0</source>
        <translation>Einstellen, ab 0</translation>
    </message>
    <message>
        <source>Set the mode of timer and counter, and begin at 0</source>
        <translation>Betriebsart von Zeitgeber und Zähler einstellen, ab 0</translation>
    </message>
    <message>
        <source>Latch inputs</source>
        <translation>Eingänge festhalten</translation>
    </message>
    <message>
        <source>Latch pins and counter at one moment</source>
        <translation>Pins und Zähler im selben Augenblick festhalten</translation>
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
        <source>Put out</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>Put out what was stored</source>
        <translation>Abgelegtes ausgeben</translation>
    </message>
    <message>
        <source>Counter and synchronous I/O</source>
        <translation>Zähler und gleichzeitige Ein- und Ausgabe</translation>
    </message>
    <message>
        <source>What counts</source>
        <translation>Was gezählt wird</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
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
        <source>every one</source>
        <translation>jede</translation>
    </message>
    <message>
        <source>every 2nd</source>
        <translation>jede 2.</translation>
    </message>
    <message>
        <source>every 4th</source>
        <translation>jede 4.</translation>
    </message>
    <message>
        <source>every 8th</source>
        <translation>jede 8.</translation>
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
        <source>What was latched</source>
        <translation>Was festgehalten wurde</translation>
    </message>
    <message>
        <source>At one moment</source>
        <translation>Im selben Augenblick</translation>
    </message>
    <message>
        <source>Outputs to store</source>
        <translation>Abzulegende Ausgänge</translation>
    </message>
    <message>
        <source>The outputs</source>
        <translation>Die Ausgänge</translation>
    </message>
    <message>
        <source>IO1 counts 1, IO2 2, IO3 4, and so on up to IO12, which counts 2048.</source>
        <translation>IO1 zählt 1, IO2 2, IO3 4 und so weiter bis IO12, das 2048 zählt.</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>%1 to store</source>
        <translation>%1 zum Ablegen</translation>
    </message>
    <message>
        <source>What counts is unknown: another program has set it.</source>
        <translation>Was zählt, ist unbekannt: Ein anderes Programm hat es eingestellt.</translation>
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
        <source>Sends what is chosen above. The count begins at 0.</source>
        <translation>Sendet, was oben gewählt ist. Die Zählung beginnt bei 0.</translation>
    </message>
    <message>
        <source>Latches all pins and the count at one moment, and reads them.</source>
        <translation>Hält alle Pins und den Zählerstand im selben Augenblick fest und liest sie.</translation>
    </message>
    <message>
        <source>Sends these values to the module, which keeps them until they are put out.</source>
        <translation>Sendet diese Werte an das Modul, das sie behält, bis sie ausgegeben werden.</translation>
    </message>
    <message>
        <source>Store something first.</source>
        <translation>Zuerst etwas ablegen.</translation>
    </message>
    <message>
        <source>Puts out what was stored, pins and PWM at one moment.</source>
        <translation>Gibt Abgelegtes aus, Pins und PWM im selben Augenblick.</translation>
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
        <source>accepted: answers that were believed</source>
        <translation>angenommen: Antworten, denen geglaubt wurde</translation>
    </message>
    <message>
        <source>mean round trip, from sending a command to its whole answer</source>
        <translation>mittlere Antwortzeit, vom Senden eines Befehls bis zu seiner ganzen Antwort</translation>
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
        <source>time-outs: no answer, or too few bytes</source>
        <translation>Zeitüberschreitungen: keine Antwort oder zu wenige Bytes</translation>
    </message>
    <message>
        <source>refused by the module: the command reached it with a wrong checksum</source>
        <translation>vom Modul abgewiesen: der Befehl erreichte es mit falscher Prüfsumme</translation>
    </message>
    <message>
        <source>wrong sums: the answer was damaged on its way</source>
        <translation>falsche Prüfsummen: die Antwort wurde unterwegs beschädigt</translation>
    </message>
    <message>
        <source>surplus bytes: nobody had asked for them</source>
        <translation>überzählige Bytes: niemand hatte sie angefordert</translation>
    </message>
    <message>
        <source>of them stale: discarded while late answers were waited out</source>
        <translation>davon veraltet: verworfen, während späte Antworten abgewartet wurden</translation>
    </message>
    <message>
        <source>resyncs: the link had to prove itself again</source>
        <translation>Neuabgleiche: die Verbindung musste sich neu beweisen</translation>
    </message>
    <message>
        <source>rejected by a rule: the sum was right, but the answer was not believed</source>
        <translation>durch eine Regel verworfen: die Prüfsumme stimmte, aber der Antwort wurde nicht geglaubt</translation>
    </message>
    <message>
        <source>  of them: %1</source>
        <translation>  davon: %1</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>nmc::CursorPanel</name>
    <message>
        <source>Readings of the cursors</source>
        <translation>Was die Cursor anzeigen</translation>
    </message>
    <message>
        <source>Shows or hides what the cursors read.</source>
        <translation>Zeigt oder verbirgt, was die Cursor anzeigen.</translation>
    </message>
    <message>
        <source>Between the cursors: %1</source>
        <translation>Zwischen den Cursorn: %1</translation>
    </message>
</context>
<context>
    <name>nmc::CursorTable</name>
    <message>
        <source>What the cursors read</source>
        <translation>Was die Cursor anzeigen</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
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
        <source> (%1 Hz)</source>
        <translation> (%1 Hz)</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
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
        <translation>Effektivwert</translation>
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
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
</context>
<context>
    <name>nmc::DetailsBox</name>
    <message>
        <source>The move has ended; in velocity mode the goal velocity is reached.</source>
        <translation>Die Fahrt ist beendet; im Geschwindigkeitsbetrieb ist die Zielgeschwindigkeit erreicht.</translation>
    </message>
    <message>
        <source>The module could not read the last command; it was not carried out.</source>
        <translation>Das Modul konnte den letzten Befehl nicht lesen; er wurde nicht ausgeführt.</translation>
    </message>
    <message>
        <source>The current limit was reached. Stays until sticky bits are cleared.</source>
        <translation>Die Stromgrenze wurde erreicht. Bleibt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>Motor power is present.</source>
        <translation>Die Motorversorgung ist vorhanden.</translation>
    </message>
    <message>
        <source>The position error was beyond its limit, or the servo is off. Stays until sticky bits are cleared.</source>
        <translation>Die Regelabweichung lag über ihrer Grenze, oder der Servo ist aus. Bleibt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>Limit input 1.</source>
        <translation>Endschaltereingang 1.</translation>
    </message>
    <message>
        <source>Limit input 2.</source>
        <translation>Endschaltereingang 2.</translation>
    </message>
    <message>
        <source>Waiting for the home position.</source>
        <translation>Wartet auf die Referenzposition.</translation>
    </message>
    <message>
        <source>The complement of the encoder&apos;s index.</source>
        <translation>Das Komplement des Indexsignals des Encoders.</translation>
    </message>
    <message>
        <source>The 32-bit position has wrapped. Stays until sticky bits are cleared.</source>
        <translation>Die 32-Bit-Position ist übergelaufen. Bleibt, bis die Sticky-Bits gelöscht werden.</translation>
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
        <source>A servo tick took too long; typically not serious. Stays until sticky bits are cleared.</source>
        <translation>Ein Servotakt hat zu lange gedauert; meist unbedenklich. Bleibt, bis die Sticky-Bits gelöscht werden.</translation>
    </message>
    <message>
        <source>Clear stic&amp;ky bits</source>
        <translation>Stick&amp;y-Bits löschen</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Clear the sticky status bits</source>
        <translation>Die Sticky-Statusbits löschen</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Statusbyte</translation>
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
        <source>Velocity, as the chip says</source>
        <translation>Geschwindigkeit laut Chip</translation>
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
        <source>, auxiliary %1</source>
        <translation>, Hilfsbyte %1</translation>
    </message>
    <message>
        <source>Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing.</source>
        <translation>Löscht overcurrent, pos_error, pos_wrap und servo_overrun. Startet nichts.</translation>
    </message>
    <message>
        <source>Save as home</source>
        <translation>Als Referenz speichern</translation>
    </message>
    <message>
        <source>Save the present position as home</source>
        <translation>Die jetzige Position als Referenz speichern</translation>
    </message>
    <message>
        <source>Keeps the present position as home. The motor does not move.</source>
        <translation>Merkt sich die jetzige Position als Referenz. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Home register</source>
        <translation>Referenzregister</translation>
    </message>
</context>
<context>
    <name>nmc::DifferencesDialog</name>
    <message>
        <source>&amp;Tick all</source>
        <translation>A&amp;lle anhaken</translation>
    </message>
    <message>
        <source>Tick &amp;none</source>
        <translation>&amp;Keinen anhaken</translation>
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
        <source>What the machine file would change</source>
        <translation>Was die Maschinendatei ändern würde</translation>
    </message>
    <message>
        <source>Open machine</source>
        <translation>Maschine öffnen</translation>
    </message>
    <message>
        <source>Differences between the file and what is here</source>
        <translation>Unterschiede zwischen der Datei und dem Stand hier</translation>
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
        <source>Here, or last sent</source>
        <translation>Hier oder zuletzt gesendet</translation>
    </message>
    <message>
        <source>Applying it</source>
        <translation>Beim Anwenden</translation>
    </message>
    <message>
        <source>Tick all</source>
        <translation>Alle anhaken</translation>
    </message>
    <message>
        <source>Ticks everything that can be applied, also what is sent to modules that are on.</source>
        <translation>Hakt alles an, was sich anwenden lässt, auch was an eingeschaltete Module gesendet wird.</translation>
    </message>
    <message>
        <source>Tick none</source>
        <translation>Keinen anhaken</translation>
    </message>
    <message>
        <source>Takes all ticks away.</source>
        <translation>Nimmt alle Haken weg.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leaves everything as it is.</source>
        <translation>Lässt alles, wie es ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; differs from what is here. Nothing changes, and nothing is sent, before you apply it; no motor is moved by it. What was typed and not sent gives way to the file.</source>
        <translation>„%1“ weicht vom Stand hier ab. Vor dem Anwenden ändert sich nichts, und es wird nichts gesendet; kein Motor bewegt sich dadurch. Was eingetippt und nicht gesendet ist, weicht der Datei.</translation>
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
        <source>Takes over what is ticked, and sends what is said to be sent.</source>
        <translation>Übernimmt, was angehakt ist, und sendet, was als zu senden angegeben ist.</translation>
    </message>
    <message>
        <source>Chosen: %1 of %2. Sent to modules: %3.</source>
        <translation>Gewählt: %1 von %2. An Module gesendet: %3.</translation>
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
        <source>The command&apos;s bytes</source>
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
        <source>Load: %1</source>
        <translation>Laden: %1</translation>
    </message>
    <message>
        <source>Without it the chip keeps the value that was loaded before.</source>
        <translation>Ohne ihn behält der Chip den zuvor geladenen Wert.</translation>
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
        <translation>Richtungsprüfung …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Direction of motor and encoder</source>
        <translation>Drehrichtung von Motor und Encoder</translation>
    </message>
    <message>
        <source>Check the direction of motor and encoder</source>
        <translation>Drehrichtung von Motor und Encoder prüfen</translation>
    </message>
    <message>
        <source>Cancel the direction check</source>
        <translation>Richtungsprüfung abbrechen</translation>
    </message>
    <message>
        <source>What the direction check has found</source>
        <translation>Was die Richtungsprüfung ergeben hat</translation>
    </message>
    <message>
        <source>A direction check is under way.</source>
        <translation>Eine Richtungsprüfung läuft.</translation>
    </message>
    <message>
        <source>Something turns the motor. Wait until it stands still.</source>
        <translation>Etwas dreht den Motor. Warten, bis er stillsteht.</translation>
    </message>
    <message>
        <source>The motor of %1 will move a little, forward and in reverse. It is pushed for less than a tenth of a second at a time, a little stronger each time up to %2 % of its supply, until it has moved %3; a motor that runs freely may run on for some more. Farther than %4 ends the check. Keep clear of it.</source>
        <translation>Der Motor von %1 wird sich ein wenig bewegen, vorwärts und rückwärts. Er wird jeweils weniger als eine Zehntelsekunde lang angestoßen, jedes Mal ein wenig stärker bis zu %2 % seiner Versorgung, bis er sich um %3 bewegt hat; ein frei drehender Motor kann noch etwas weiterlaufen. Mehr als %4 beendet die Prüfung. Abstand halten.</translation>
    </message>
    <message>
        <source>Direction check</source>
        <translation>Richtungsprüfung</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Push the motor</source>
        <translation>&amp;Motor anstoßen</translation>
    </message>
    <message>
        <source>Pushing it in reverse.</source>
        <translation>Wird rückwärts angestoßen.</translation>
    </message>
    <message>
        <source>Pushing it forward.</source>
        <translation>Wird vorwärts angestoßen.</translation>
    </message>
    <message>
        <source>No verdict: see the message.</source>
        <translation>Kein Ergebnis: siehe die Meldung.</translation>
    </message>
    <message>
        <source>Not checked in this connection. Do it before you enable the servo for the first time: with motor or encoder reversed it runs away.</source>
        <translation>In dieser Verbindung nicht geprüft. Vor dem ersten Einschalten des Servos prüfen: Mit vertauschtem Motor oder Encoder läuft er davon.</translation>
    </message>
    <message>
        <source>Moves the motor a little, without the servo, to see that it turns the way its encoder counts. Asks first.</source>
        <translation>Bewegt den Motor ein wenig, ohne Servo, um zu sehen, ob er sich so dreht, wie sein Encoder zählt. Fragt vorher.</translation>
    </message>
    <message>
        <source>No direction check is under way.</source>
        <translation>Es läuft keine Richtungsprüfung.</translation>
    </message>
    <message>
        <source>Ends the check; the motor is off then.</source>
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
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
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
        <source>&amp;Scan again</source>
        <translation>Erneut &amp;suchen</translation>
    </message>
    <message>
        <source>Look for the chain again</source>
        <translation>Die Kette neu suchen</translation>
    </message>
    <message>
        <source>&amp;Take as expected</source>
        <translation>Als er&amp;wartet übernehmen</translation>
    </message>
    <message>
        <source>Take what is there as expected</source>
        <translation>Das Vorhandene als erwartet übernehmen</translation>
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
        <source>Looks for the chain again with questions only: nothing is reset, nothing moves.</source>
        <translation>Sucht die Kette nur mit Abfragen neu: nichts wird zurückgesetzt, nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Resets every module and gives addresses again. Asks first.</source>
        <translation>Setzt jedes Modul zurück und vergibt die Adressen neu. Fragt vorher nach.</translation>
    </message>
    <message>
        <source>It is what is expected already.</source>
        <translation>Das wird bereits erwartet.</translation>
    </message>
    <message>
        <source>From now on the modules that are there are the expected ones.</source>
        <translation>Von nun an sind die vorhandenen Module die erwarteten.</translation>
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
        <source>Motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>The chip no longer watches for home.</source>
        <translation>Der Chip sucht keine Referenz mehr.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register and stops by itself. Start the motion with your own command.</source>
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
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>Position (counts)</source>
        <translation>Position (Inkremente)</translation>
    </message>
    <message>
        <source>Velocity (counts/tick × 65536)</source>
        <translation>Geschwindigkeit (Inkr./Takt × 65536)</translation>
    </message>
    <message>
        <source>Acceleration (counts/tick² × 65536)</source>
        <translation>Beschleunigung (Inkr./Takt² × 65536)</translation>
    </message>
    <message>
        <source>PWM value</source>
        <translation>PWM-Wert</translation>
    </message>
    <message>
        <source>Reverse (velocity and PWM)</source>
        <translation>Rückwärts (Geschwindigkeit und PWM)</translation>
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
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Amplifier only</source>
        <translation>Nur Verstärker</translation>
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
        <source>At a position</source>
        <translation>An einer Position</translation>
    </message>
    <message>
        <source>Amplifier enabled</source>
        <translation>Verstärker ein</translation>
    </message>
    <message>
        <source>Only AMP_EN is switched. The servo stays as it is.</source>
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
        <translation>Der Motor fährt ohne Profil zu dieser Position, so schnell die Reglerwerte ihn treiben, und hält dort.</translation>
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
        <translation>Wechsel an Grenze 1</translation>
    </message>
    <message>
        <source>Change of limit 2</source>
        <translation>Wechsel an Grenze 2</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Regelabweichung</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>Table 4 has no mode for this, from what the motor does now.</source>
        <translation>Tabelle 4 kennt dafür keinen Modus aus dem, was der Motor jetzt tut.</translation>
    </message>
    <message>
        <source>Position (steps)</source>
        <translation>Position (Schritte)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration time (0.25 ms)</source>
        <translation>Beschleunigungszeit (0,25 ms)</translation>
    </message>
    <message>
        <source>Initial timer count</source>
        <translation>Anfangszählerstand</translation>
    </message>
    <message>
        <source>Nearest integer speed</source>
        <translation>Nächste ganze Geschwindigkeit</translation>
    </message>
    <message>
        <source>Reverse (without a position)</source>
        <translation>Rückwärts (ohne Position)</translation>
    </message>
    <message>
        <source>Only AMP_EN is switched. A motion goes on counting.</source>
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
        <source>Commands as the data sheet has them</source>
        <translation>Befehle, wie das Datenblatt sie hat</translation>
    </message>
    <message>
        <source>Commands as the data sheet has them, in the chip&apos;s own numbers. STOP ALL and Esc act as ever.</source>
        <translation>Befehle, wie das Datenblatt sie hat, in den Zahlen des Chips. ALLES STOPP und Esc wirken wie immer.</translation>
    </message>
    <message>
        <source>%1 Waits for Start Motion; the next load overwrites it.</source>
        <translation>%1 Wartet auf Start Motion; der nächste Ladebefehl überschreibt es.</translation>
    </message>
    <message>
        <source>The servo is off and the PWM value drives the motor. No limit applies.</source>
        <translation>Der Servo ist aus, und der PWM-Wert treibt den Motor. Keine Grenze gilt.</translation>
    </message>
    <message>
        <source>The motor runs until it is stopped.</source>
        <translation>Der Motor läuft bis zum Stopp.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position. Start it from standstill only.</source>
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
        <source>The move goes on to its position at this speed. Had it ended meanwhile, the motor would run until it is stopped.</source>
        <translation>Die Fahrt geht mit dieser Geschwindigkeit bis zu ihrer Position weiter. Wäre sie inzwischen beendet, liefe der Motor bis zum Stopp.</translation>
    </message>
    <message>
        <source>Reset module…</source>
        <translation>Modul zurücksetzen…</translation>
    </message>
    <message>
        <source>Reset this module</source>
        <translation>Dieses Modul zurücksetzen</translation>
    </message>
    <message>
        <source>Takes this module back to its power-up state, and gives it its address again. The others stay as they are.</source>
        <translation>Setzt dieses Modul in den Einschaltzustand zurück und gibt ihm seine Adresse wieder. Die anderen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Reset module</source>
        <translation>Modul zurücksetzen</translation>
    </message>
    <message>
        <source>Reset %1? Its motor goes off, and it forgets its position, its settings and its group. The other modules stay as they are.</source>
        <translation>%1 zurücksetzen? Sein Motor geht aus, und es vergisst Position, Einstellungen und Gruppe. Die anderen Module bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Reset the module</source>
        <translation>Modul zurücksetzen</translation>
    </message>
</context>
<context>
    <name>nmc::FrequencyPage</name>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>The motor swings about where it is held, slowly at first, then faster. Everything that turns with it must be free to.</source>
        <translation>Der Motor schwingt um die Stelle, an der er gehalten wird, erst langsam, dann schneller. Alles, was sich mitdreht, muss sich drehen können.</translation>
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
        <source>How far the command swings to either side. The motor may swing four times as far before it is stopped.</source>
        <translation>Wie weit der Sollwert nach jeder Seite schwingt. Der Motor darf viermal so weit schwingen, bevor er gestoppt wird.</translation>
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
        <source>It ends before it where the baud rate is too low: at about 40 Hz at 115200 Bd, and at about 8 Hz at 19200 Bd.</source>
        <translation>Es endet vorher, wo die Baudrate zu niedrig ist: bei etwa 40 Hz mit 115200 Bd und bei etwa 8 Hz mit 19200 Bd.</translation>
    </message>
    <message>
        <source>What the frequency response comes to</source>
        <translation>Was der Frequenzgang ergibt</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>Export the frequency response</source>
        <translation>Frequenzgang exportieren</translation>
    </message>
    <message>
        <source>The baud rate is too low for higher frequencies.</source>
        <translation>Für höhere Frequenzen ist die Baudrate zu niedrig.</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
    <message>
        <source>Saves frequency, magnitude and phase of both loops.</source>
        <translation>Speichert Frequenz, Betrag und Phase von beiden.</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
</context>
<context>
    <name>nmc::GainsBox</name>
    <message>
        <source>&amp;Apply gains</source>
        <translation>A&amp;lle anwenden</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Start&amp;ing values</source>
        <translation>Sta&amp;rtwerte</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Reglerwerte</translation>
    </message>
    <message>
        <source>Apply all gains</source>
        <translation>Alle Reglerwerte anwenden</translation>
    </message>
    <message>
        <source>Revert the gains to what was sent</source>
        <translation>Reglerwerte auf die gesendeten zurücksetzen</translation>
    </message>
    <message>
        <source>Fill in starting values</source>
        <translation>Startwerte eintragen</translation>
    </message>
    <message>
        <source>Fills the fields with values to begin tuning with. Sends nothing.</source>
        <translation>Füllt die Felder mit Werten für den Beginn der Abstimmung. Sendet nichts.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ gesendet</translation>
    </message>
    <message>
        <source>● edited, not sent</source>
        <translation>● nicht gesendet</translation>
    </message>
    <message>
        <source>Gains cannot be read back from the module. Until you apply them they are unknown.</source>
        <translation>Reglerwerte sind aus dem Modul nicht lesbar. Bis zum Anwenden sind sie unbekannt.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The servo is on: they act immediately.</source>
        <translation>Sendet alle Reglerwerte auf einmal. Der Servo ist ein: sie wirken sofort.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The motor does not move.</source>
        <translation>Sendet alle Reglerwerte auf einmal. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>&amp;Apply gains, live</source>
        <translation>A&amp;lle anwenden, live</translation>
    </message>
    <message>
        <source>Back to the gains that were sent. Sends nothing.</source>
        <translation>Zurück zu den gesendeten Reglerwerten. Sendet nichts.</translation>
    </message>
    <message>
        <source>Empties the fields: no gains have been sent yet. Sends nothing.</source>
        <translation>Leert die Felder: es wurden noch keine Reglerwerte gesendet. Sendet nichts.</translation>
    </message>
    <message>
        <source>Sense of the current limit</source>
        <translation>Wirkungssinn der Stromgrenze</translation>
    </message>
    <message>
        <source>Whether a large or a small A/D value means too much current. The chip tells them apart by odd and even numbers.</source>
        <translation>Ob ein großer oder ein kleiner A/D-Wert zu viel Strom bedeutet. Der Chip unterscheidet das an geraden und ungeraden Zahlen.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last edit of a gain</source>
        <translation>Die letzte Änderung eines Reglerwerts rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo the edit of a gain</source>
        <translation>Die Änderung eines Reglerwerts wiederherstellen</translation>
    </message>
    <message>
        <source>All zero</source>
        <translation>Alle null</translation>
    </message>
    <message>
        <source>Fill in zero for all gains</source>
        <translation>Für alle Reglerwerte null eintragen</translation>
    </message>
    <message>
        <source>SR %1 instead of %2 changes the servo tick: every velocity and acceleration in counts per tick means another speed then.</source>
        <translation>SR %1 statt %2 ändert den Servotakt: jede Geschwindigkeit und Beschleunigung in Inkrementen je Takt bedeutet dann ein anderes Tempo.</translation>
    </message>
    <message>
        <source>Gains while the servo is on</source>
        <translation>Reglerwerte bei eingeschaltetem Servo</translation>
    </message>
    <message>
        <source>The servo is on, and this is a large step: %1. The motor may jump or swing.</source>
        <translation>Der Servo ist ein, und das ist ein großer Schritt: %1. Der Motor kann springen oder schwingen.</translation>
    </message>
    <message>
        <source>&amp;Apply these gains</source>
        <translation>&amp;Diese Reglerwerte anwenden</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Step response…</source>
        <translation>Sprungantwort…</translation>
    </message>
    <message>
        <source>Open the step response</source>
        <translation>Die Sprungantwort öffnen</translation>
    </message>
    <message>
        <source>Opens the place where a small step shows how the motor follows (F9).</source>
        <translation>Öffnet den Ort, an dem ein kleiner Sprung zeigt, wie der Motor folgt (F9).</translation>
    </message>
    <message>
        <source>Fills the fields with 0, where tuning begins. Sends nothing; once applied, the motor does not hold any more.</source>
        <translation>Füllt die Felder mit 0, dem Beginn der Abstimmung. Sendet nichts; nach dem Anwenden hält der Motor nicht mehr.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts zurückzunehmen.</translation>
    </message>
    <message>
        <source>Takes back the last edit in these fields. Sends nothing.</source>
        <translation>Nimmt die letzte Änderung in diesen Feldern zurück. Sendet nichts.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Makes the edit again that was undone. Sends nothing.</source>
        <translation>Macht die Änderung noch einmal, die rückgängig gemacht wurde. Sendet nichts.</translation>
    </message>
    <message>
        <source>Nothing was edited.</source>
        <translation>Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Try for %1 s</source>
        <translation>%1 s probieren</translation>
    </message>
    <message>
        <source>Try these gains for %1 seconds</source>
        <translation>Diese Reglerwerte %1 Sekunden lang probieren</translation>
    </message>
    <message>
        <source>Keep them</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep the gains that are being tried</source>
        <translation>Die Reglerwerte behalten, die probiert werden</translation>
    </message>
    <message>
        <source>They are being tried already.</source>
        <translation>Sie werden schon probiert.</translation>
    </message>
    <message>
        <source>The module has these gains already.</source>
        <translation>Das Modul hat diese Reglerwerte schon.</translation>
    </message>
    <message>
        <source>Sends these gains and takes them back after %1 s, unless you keep them; at once when the motor begins to swing.</source>
        <translation>Sendet diese Reglerwerte und nimmt sie nach %1 s zurück, wenn sie nicht behalten werden; sofort, wenn der Motor zu schwingen beginnt.</translation>
    </message>
    <message>
        <source>No gains are being tried.</source>
        <translation>Es werden keine Reglerwerte probiert.</translation>
    </message>
    <message>
        <source>The gains that are being tried stay.</source>
        <translation>Die Reglerwerte, die probiert werden, bleiben.</translation>
    </message>
</context>
<context>
    <name>nmc::GenericPanel</name>
    <message>
        <source>Module without controls</source>
        <translation>Modul ohne Bedienelemente</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <source>Ask for its status</source>
        <translation>Status abfragen</translation>
    </message>
    <message>
        <source>Ask this module for its status</source>
        <translation>Den Status dieses Moduls abfragen</translation>
    </message>
    <message>
        <source>Sends No Operation, which only asks for the status.</source>
        <translation>Sendet No Operation, das nur den Status abfragt.</translation>
    </message>
    <message>
        <source>Its type and version are not among those whose data sheets this panel follows (PIC-SERVO v1 to v5 and v10, PIC-STEP v1, PIC-I/O v1), so what a command would do to it is not known. It is only looked at; Stop all reaches it.</source>
        <translation>Typ und Version gehören nicht zu denen, deren Datenblättern dieses Programm folgt (PIC-SERVO v1 bis v5 und v10, PIC-STEP v1, PIC-I/O v1); was ein Befehl bei ihm bewirken würde, ist nicht bekannt. Es wird nur angesehen; ALLES STOPP erreicht es.</translation>
    </message>
</context>
<context>
    <name>nmc::GroupsPage</name>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>No modules yet: connect first.</source>
        <translation>Noch keine Module: zuerst verbinden.</translation>
    </message>
    <message>
        <source>Group to be commanded</source>
        <translation>Gruppe für die Befehle</translation>
    </message>
    <message>
        <source>St&amp;art loaded moves</source>
        <translation>Geladene Fahrten s&amp;tarten</translation>
    </message>
    <message>
        <source>Start the loaded moves of this group</source>
        <translation>Die geladenen Fahrten dieser Gruppe starten</translation>
    </message>
    <message>
        <source>Save &amp;home</source>
        <translation>&amp;Referenz speichern</translation>
    </message>
    <message>
        <source>Save the present positions of this group as home</source>
        <translation>Die jetzigen Positionen dieser Gruppe als Referenz speichern</translation>
    </message>
    <message>
        <source>Group of module %1</source>
        <translation>Gruppe von Modul %1</translation>
    </message>
    <message>
        <source>The group this module listens to. Sent at once; nothing moves.</source>
        <translation>Die Gruppe, auf die dieses Modul hört. Wird sofort gesendet; nichts bewegt sich.</translation>
    </message>
    <message>
        <source>leads</source>
        <translation>leitet</translation>
    </message>
    <message>
        <source>Module %1 leads its group</source>
        <translation>Modul %1 leitet seine Gruppe</translation>
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
        <source>This module answers for its group; a group has one leader at most.</source>
        <translation>Dieses Modul antwortet für seine Gruppe; eine Gruppe hat höchstens ein Leitmodul.</translation>
    </message>
    <message>
        <source>move loaded</source>
        <translation>Fahrt geladen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No module is in a group yet.</source>
        <translation>Noch ist kein Modul in einer Gruppe.</translation>
    </message>
    <message>
        <source>Starts the moves that all members have loaded, in the same tick. Withheld unless every member has confirmed its load.</source>
        <translation>Startet im selben Takt die Fahrten, die alle Mitglieder geladen haben. Wird zurückgehalten, solange nicht jedes Mitglied das Laden bestätigt hat.</translation>
    </message>
    <message>
        <source>Each member captures its present position as home, in the same tick. Nothing moves.</source>
        <translation>Jedes Mitglied erfasst im selben Takt seine jetzige Position als Referenz. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Name der Gruppe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What you call this group. Kept with the machine; nothing is sent.</source>
        <translation>Wie Sie diese Gruppe nennen. Steht bei der Maschine; nichts wird gesendet.</translation>
    </message>
    <message>
        <source>A module listens to one group besides its own address. A command to a group is carried out by all its members in the same tick; its leader, if it has one, answers for them; then each member is looked at by itself. Questions go to single modules: from a group only the leader would answer.</source>
        <translation>Ein Modul hört außer auf seine eigene Adresse auf eine Gruppe. Einen Befehl an eine Gruppe führen alle Mitglieder im selben Takt aus; ihr Leiter, wenn sie einen hat, antwortet für alle; dann wird jedes Mitglied einzeln angesehen. Fragen gehen an einzelne Module: von einer Gruppe würde nur der Leiter antworten.</translation>
    </message>
    <message>
        <source>Which group the buttons are for.</source>
        <translation>Für welche Gruppe die Schaltflächen gelten.</translation>
    </message>
    <message>
        <source>Stop s&amp;moothly</source>
        <translation>&amp;Sanft anhalten</translation>
    </message>
    <message>
        <source>Stop this group smoothly</source>
        <translation>Diese Gruppe sanft anhalten</translation>
    </message>
    <message>
        <source>Stop at &amp;once</source>
        <translation>S&amp;ofort anhalten</translation>
    </message>
    <message>
        <source>Stop this group at once</source>
        <translation>Diese Gruppe sofort anhalten</translation>
    </message>
    <message>
        <source>Motors o&amp;ff</source>
        <translation>&amp;Motoren aus</translation>
    </message>
    <message>
        <source>Motors of this group off</source>
        <translation>Motoren dieser Gruppe aus</translation>
    </message>
    <message>
        <source>C&amp;lear sticky bits</source>
        <translation>Sticky-Bits &amp;löschen</translation>
    </message>
    <message>
        <source>Clear the sticky bits of this group</source>
        <translation>Die Sticky-Bits dieser Gruppe löschen</translation>
    </message>
    <message>
        <source>Set &amp;position to 0…</source>
        <translation>&amp;Position auf 0 setzen…</translation>
    </message>
    <message>
        <source>Set the positions of this group to 0</source>
        <translation>Die Positionen dieser Gruppe auf 0 setzen</translation>
    </message>
    <message>
        <source>Address of module %1</source>
        <translation>Adresse von Modul %1</translation>
    </message>
    <message>
        <source>address </source>
        <translation>Adresse </translation>
    </message>
    <message>
        <source>The address this module answers to, 1 to 127. Sent with Enter; it keeps its position, gains and group.</source>
        <translation>Die Adresse, auf die dieses Modul antwortet, 1 bis 127. Wird mit der Eingabetaste gesendet; Position, Reglerwerte und Gruppe bleiben.</translation>
    </message>
    <message>
        <source>The place where each member stands becomes 0. Asks first.</source>
        <translation>Der Ort, an dem jedes Mitglied steht, wird 0. Fragt vorher.</translation>
    </message>
    <message>
        <source>Takes back what each member has remembered of faults. PIC-SERVO only.</source>
        <translation>Nimmt zurück, was sich jedes Mitglied an Fehlern gemerkt hat. Nur PIC-SERVO.</translation>
    </message>
    <message>
        <source>Each member that is on slows down, and holds. Repeated until each is seen at rest.</source>
        <translation>Jedes eingeschaltete Mitglied bremst ab und hält. Wird wiederholt, bis jedes in Ruhe gesehen wurde.</translation>
    </message>
    <message>
        <source>Each member that is on stops at once, and holds. Repeated until each is seen at rest.</source>
        <translation>Jedes eingeschaltete Mitglied hält sofort an und hält. Wird wiederholt, bis jedes in Ruhe gesehen wurde.</translation>
    </message>
    <message>
        <source>Switches each member off: it coasts, and a load may drop. Repeated until each is seen at rest.</source>
        <translation>Schaltet jedes Mitglied aus: Es läuft aus, und eine Last kann fallen. Wird wiederholt, bis jedes in Ruhe gesehen wurde.</translation>
    </message>
    <message>
        <source>The place where each motor of %1 stands becomes position 0: module %2. Home, limits and taught points mean other places after that.</source>
        <translation>Der Ort, an dem jeder Motor von %1 steht, wird Position 0: Modul %2. Referenz, Grenzen und gelernte Punkte bedeuten danach andere Orte.</translation>
    </message>
    <message>
        <source>Set positions to 0</source>
        <translation>Positionen auf 0 setzen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Set positions to 0</source>
        <translation>&amp;Positionen auf 0 setzen</translation>
    </message>
    <message>
        <source>Its group is not known here and would be changed with the address. Choose a group first, or none.</source>
        <translation>Seine Gruppe ist hier nicht bekannt und würde mit der Adresse geändert. Zuerst eine Gruppe wählen oder keine.</translation>
    </message>
    <message>
        <source>A motor is moving. Addresses change at standstill only.</source>
        <translation>Ein Motor bewegt sich. Adressen ändern sich nur im Stillstand.</translation>
    </message>
    <message>
        <source>Address %1 is that of %2. Nothing was sent.</source>
        <translation>Adresse %1 ist die von %2. Nichts wurde gesendet.</translation>
    </message>
</context>
<context>
    <name>nmc::HoldFirstButton</name>
    <message>
        <source>Hold here first</source>
        <translation>Erst hier halten</translation>
    </message>
    <message>
        <source>Hold the motor where it is, before a test</source>
        <translation>Den Motor vor einer Prüfung halten, wo er steht</translation>
    </message>
    <message>
        <source>Takes the position it has at this moment as the one to hold (Stop here).</source>
        <translation>Nimmt die Position von diesem Augenblick als die, die zu halten ist (Hier stoppen).</translation>
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
        <source>Homing</source>
        <translation>Referenzsuche</translation>
    </message>
    <message>
        <source>Search for home</source>
        <translation>Die Referenz suchen</translation>
    </message>
    <message>
        <source>Cancel the search for home</source>
        <translation>Die Referenzsuche abbrechen</translation>
    </message>
    <message>
        <source>Stages of the search</source>
        <translation>Abschnitte der Suche</translation>
    </message>
    <message>
        <source>How the search goes</source>
        <translation>Wie die Suche verläuft</translation>
    </message>
    <message>
        <source>Settings of the search</source>
        <translation>Einstellungen der Suche</translation>
    </message>
    <message>
        <source>A search for home is under way.</source>
        <translation>Eine Referenzsuche läuft.</translation>
    </message>
    <message>
        <source>Moves the motor: it searches for home as set above.</source>
        <translation>Bewegt den Motor: er sucht die Referenz, wie oben eingestellt.</translation>
    </message>
    <message>
        <source>No search for home is under way.</source>
        <translation>Es läuft keine Referenzsuche.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly; it is not homed then.</source>
        <translation>Stoppt den Motor sanft; er hat dann keine Referenz.</translation>
    </message>
    <message>
        <source>Done: home was at %1.</source>
        <translation>Erledigt: die Referenz lag bei %1.</translation>
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
        <translation>Die Referenz suchen</translation>
    </message>
    <message>
        <source>Home is where this switch changes. When it is active at the start, the motor first backs off from it in the other direction.</source>
        <translation>Die Referenz liegt dort, wo sich dieser Schalter ändert. Ist er zu Beginn aktiv, fährt der Motor zuerst in die andere Richtung von ihm weg.</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>Referenzschalter</translation>
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
        <source>Limit 1</source>
        <translation>Endschalter 1</translation>
    </message>
    <message>
        <source>Limit 2</source>
        <translation>Endschalter 2</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Home is at the encoder&apos;s index, which comes once in a turn.</source>
        <translation>Die Referenz liegt am Index des Encoders, der einmal je Umdrehung kommt.</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the position error limit switches the servo off. Sticky bits are cleared before. The servo is switched on again only if it is to go on, to the index or to home.</source>
        <translation>Die Referenz liegt an einem festen Anschlag: der Motor fährt dagegen, bis die Grenze der Regelabweichung den Servo abschaltet. Vorher werden die Sticky-Bits gelöscht. Der Servo wird nur wieder eingeschaltet, wenn es weitergehen soll, zum Index oder zur Referenz.</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the current limit is reached. Alone it is looked for at full speed only; together with others from the start, whose current must stay below it then. Sticky bits are cleared before.</source>
        <translation>Die Referenz liegt an einem festen Anschlag: der Motor fährt dagegen, bis die Stromgrenze erreicht ist. Allein wird sie nur bei voller Geschwindigkeit beachtet, zusammen mit anderen von Anfang an; der Anfahrstrom muss dann darunter bleiben. Vorher werden die Sticky-Bits gelöscht.</translation>
    </message>
    <message>
        <source>then at the index, going back</source>
        <translation>danach am Index, auf dem Rückweg</translation>
    </message>
    <message>
        <source>What is chosen above finds the neighbourhood; a second, slower search finds the index, which is more exact.</source>
        <translation>Das oben Gewählte findet die Umgebung; eine zweite, langsamere Suche findet den Index, der genauer ist.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Search in reverse</source>
        <translation>Rückwärts suchen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Search forward</source>
        <translation>Vorwärts suchen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>How fast the motor searches, backs off and goes to home. It is never faster than this.</source>
        <translation>Wie schnell der Motor sucht, freifährt und zur Referenz fährt. Schneller wird er nie.</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Indexgeschwindigkeit</translation>
    </message>
    <message>
        <source>How fast the second search for the index is; slower is more exact.</source>
        <translation>Wie schnell die zweite Suche nach dem Index ist; langsamer ist genauer.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>How fast the velocity changes, smooth stops included.</source>
        <translation>Wie schnell sich die Geschwindigkeit ändert, auch beim sanften Stoppen.</translation>
    </message>
    <message>
        <source>Travel limit</source>
        <translation>Weggrenze</translation>
    </message>
    <message>
        <source>A search, or backing off, that has gone so far is stopped, and has failed.</source>
        <translation>Eine Suche oder ein Freifahren, das so weit gegangen ist, wird gestoppt und ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Time limit of a search</source>
        <translation>Zeitgrenze einer Suche</translation>
    </message>
    <message>
        <source>A search that has taken so long is stopped, and has failed.</source>
        <translation>Eine Suche, die so lange gedauert hat, wird gestoppt und ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>%1 of the search for home</source>
        <translation>%1 der Referenzsuche</translation>
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
        <source>Motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>Stop abruptly at home</source>
        <translation>An der Referenz sofort stoppen</translation>
    </message>
    <message>
        <source>Stop smoothly at home</source>
        <translation>An der Referenz sanft stoppen</translation>
    </message>
    <message>
        <source>Switch the motor off at home</source>
        <translation>An der Referenz den Motor abschalten</translation>
    </message>
    <message>
        <source>Stop there</source>
        <translation>Dort stoppen</translation>
    </message>
    <message>
        <source>And then</source>
        <translation>Und dann</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Referenzposition anfahren</translation>
    </message>
    <message>
        <source>The motor stops behind home; this moves it back to it. A servo or amplifier that the search has switched off is switched on again for it.</source>
        <translation>Der Motor stoppt hinter der Referenz; dies fährt ihn zu ihr zurück. Ein Servo oder Verstärker, den die Suche abgeschaltet hat, wird dafür wieder eingeschaltet.</translation>
    </message>
    <message>
        <source>Make it zero</source>
        <translation>Auf null setzen</translation>
    </message>
    <message>
        <source>A search for home is under way.</source>
        <translation>Eine Referenzsuche läuft.</translation>
    </message>
    <message>
        <source>The first search finds the index already.</source>
        <translation>Schon die erste Suche findet den Index.</translation>
    </message>
    <message>
        <source>The position where the motor stands becomes 0, so it has to go to home first.</source>
        <translation>Die Position, an der der Motor steht, wird 0; daher muss er zuerst zur Referenz fahren.</translation>
    </message>
    <message>
        <source>The direction of the search, in which the switch closes.</source>
        <translation>Die Richtung der Suche, in der sich der Schalter schließt.</translation>
    </message>
    <message>
        <source>A position error switches the servo off by itself.</source>
        <translation>Ein Positionsfehler schaltet den Servo von selbst ab.</translation>
    </message>
    <message>
        <source> This version of the chip does not stop by itself: the panel stops it, some hundredths of a second later.</source>
        <translation> Diese Version des Chips stoppt den Motor nicht von selbst: das Programm stoppt ihn, einige Hundertstelsekunden später.</translation>
    </message>
    <message>
        <source> The chip stops it by itself.</source>
        <translation> Der Chip stoppt ihn von selbst.</translation>
    </message>
    <message>
        <source>At home the motor stops at once, and holds.</source>
        <translation>An der Referenz stoppt der Motor sofort und hält dann die Position.</translation>
    </message>
    <message>
        <source>At home the motor slows down, stops behind it, and holds.</source>
        <translation>An der Referenz bremst der Motor, stoppt hinter ihr und hält dann die Position.</translation>
    </message>
    <message>
        <source>At home the motor is switched off, and is free to turn.</source>
        <translation>An der Referenz wird der Motor abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>Once the motor stands at home, its position becomes 0.</source>
        <translation>Sobald der Motor an der Referenz steht, wird seine Position 0.</translation>
    </message>
</context>
<context>
    <name>nmc::IoBox</name>
    <message>
        <source>Limits and I/O</source>
        <translation>Endschalter und E/A</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>The encoder&apos;s index pulse, once a turn with most encoders.</source>
        <translation>Der Indexpuls des Encoders, bei den meisten Encodern einmal je Umdrehung.</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Motorversorgung</translation>
    </message>
    <message>
        <source>Without it the servo switches off, and stays off when power returns.</source>
        <translation>Ohne sie schaltet sich der Servo ab und bleibt aus, wenn die Versorgung wiederkehrt.</translation>
    </message>
    <message>
        <source>The A/D input, by most amplifiers the motor current. Its scale is set on the page Axis.</source>
        <translation>Der A/D-Eingang, bei den meisten Verstärkern der Motorstrom. Seine Skala wird auf der Seite Achse eingestellt.</translation>
    </message>
    <message>
        <source>A/D</source>
        <translation>A/D</translation>
    </message>
    <message>
        <source>Amplifier enabled (&amp;AMP_EN)</source>
        <translation>Ve&amp;rstärker ein (AMP_EN)</translation>
    </message>
    <message>
        <source>Amplifier enabled</source>
        <translation>Verstärker eingeschaltet</translation>
    </message>
    <message>
        <source>A limit input does not stop the motor by itself on this chip: arm a limit stop on the page Homing.</source>
        <translation>Ein Endschaltereingang stoppt den Motor bei diesem Chip nicht von selbst: auf der Seite Referenzsuche einen Endschalter-Stopp scharf schalten.</translation>
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
        <source>Use of the pin Limit %1</source>
        <translation>Verwendung des Pins Limit %1</translation>
    </message>
    <message>
        <source>input</source>
        <translation>Eingang</translation>
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
        <source>high</source>
        <translation>High</translation>
    </message>
    <message>
        <source>low</source>
        <translation>Low</translation>
    </message>
    <message>
        <source>Whether the pin is an input, or an output and its level. Sent at once.</source>
        <translation>Ob der Pin ein Eingang ist oder ein Ausgang, und dessen Pegel. Wird sofort gesendet.</translation>
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
        <source>Sets the amplifier&apos;s enable line alone; the servo stays as it is. Without it the motor gets no current, whatever the servo does.</source>
        <translation>Stellt nur die Freigabeleitung des Verstärkers; der Servo bleibt, wie er ist. Ohne sie bekommt der Motor keinen Strom, was auch immer der Servo tut.</translation>
    </message>
</context>
<context>
    <name>nmc::IoHead</name>
    <message>
        <source>State of the selected module</source>
        <translation>Zustand des gewählten Moduls</translation>
    </message>
    <message>
        <source>Name of this module</source>
        <translation>Name dieses Moduls</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What it is on this machine. Sends nothing.</source>
        <translation>Was es an dieser Maschine ist. Sendet nichts.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>%1, address %2</source>
        <translation>%1, Adresse %2</translation>
    </message>
</context>
<context>
    <name>nmc::IoPanel</name>
    <message>
        <source>I/O module</source>
        <translation>E/A-Modul</translation>
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
        <source>Counter</source>
        <translation>Zähler</translation>
    </message>
</context>
<context>
    <name>nmc::IoValuesBox</name>
    <message>
        <source>A/D and PWM</source>
        <translation>A/D und PWM</translation>
    </message>
    <message>
        <source>What it is on this machine. Sends nothing.</source>
        <translation>Was es an dieser Maschine ist. Sendet nichts.</translation>
    </message>
    <message>
        <source>A/D input</source>
        <translation>A/D-Eingang</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Each step</source>
        <translation>Je Stufe</translation>
    </message>
    <message>
        <source>At 0</source>
        <translation>Bei 0</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What %1 reads</source>
        <translation>Was %1 liest</translation>
    </message>
    <message>
        <source>%1, each step</source>
        <translation>%1, je Stufe</translation>
    </message>
    <message>
        <source>How much each of the 255 steps stands for.</source>
        <translation>Wofür jede der 255 Stufen steht.</translation>
    </message>
    <message>
        <source>%1 at 0</source>
        <translation>%1 bei 0</translation>
    </message>
    <message>
        <source>What an A/D value of 0 stands for.</source>
        <translation>Wofür ein A/D-Wert von 0 steht.</translation>
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
        <source>Off at stop</source>
        <translation>Aus bei Stopp</translation>
    </message>
    <message>
        <source>What %1 was told</source>
        <translation>Was %1 gesagt wurde</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>Wert von %1</translation>
    </message>
    <message>
        <source>255 is on all the time. Enter sends it.</source>
        <translation>255 ist ständig an. Die Eingabetaste sendet es.</translation>
    </message>
    <message>
        <source>STOP ALL switches %1 off</source>
        <translation>ALLES STOPP schaltet %1 aus</translation>
    </message>
    <message>
        <source>STOP ALL switches this output off. Without a tick it stays as it is.</source>
        <translation>ALLES STOPP schaltet diesen Ausgang aus. Ohne Haken bleibt er, wie er ist.</translation>
    </message>
    <message>
        <source>%1 of 255</source>
        <translation>%1 von 255</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
</context>
<context>
    <name>nmc::JogBox</name>
    <message>
        <source>Jog</source>
        <translation>Tippbetrieb</translation>
    </message>
    <message>
        <source>Velocity while held</source>
        <translation>Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>The velocity while held</source>
        <translation>Die Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>◂ Hold</source>
        <translation>◂ Tippen</translation>
    </message>
    <message>
        <source>Move in reverse while held</source>
        <translation>Rückwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Hold ▸</source>
        <translation>Tippen ▸</translation>
    </message>
    <message>
        <source>Move forward while held</source>
        <translation>Vorwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Moves forward while it is held, then stops.</source>
        <translation>Fährt vorwärts, solange sie gedrückt ist, und stoppt dann.</translation>
    </message>
    <message>
        <source>Moves in reverse while it is held, then stops.</source>
        <translation>Fährt rückwärts, solange sie gedrückt ist, und stoppt dann.</translation>
    </message>
    <message>
        <source>How fast the motor turns while a button, or Space on it, is held. Low again after every connect; the cap is set on the page Axis.</source>
        <translation>Wie schnell sich der Motor dreht, solange eine Taste oder auf ihr die Leertaste gedrückt ist. Nach jedem Verbinden wieder niedrig; der Höchstwert wird auf der Seite Achse eingestellt.</translation>
    </message>
    <message>
        <source>Jog at velocit&amp;y</source>
        <translation>Tippgesch&amp;windigkeit</translation>
    </message>
</context>
<context>
    <name>nmc::Layouts</name>
    <message>
        <source>&amp;Operate</source>
        <translation>&amp;Bedienen</translation>
    </message>
    <message>
        <source>Motions in the middle, everything else around them.</source>
        <translation>Bewegungen in der Mitte, alles andere darum herum.</translation>
    </message>
    <message>
        <source>&amp;Tune</source>
        <translation>&amp;Einstellen</translation>
    </message>
    <message>
        <source>Plots take most of the window, gains and step beside them.</source>
        <translation>Die Kurven nehmen den größten Teil des Fensters ein, Reglerwerte und Sprung daneben.</translation>
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
    <name>nmc::LimitStopBox</name>
    <message>
        <source>limit 1</source>
        <translation>Endschalter 1</translation>
    </message>
    <message>
        <source>limit 2</source>
        <translation>Endschalter 2</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>Endschalter-Stopp</translation>
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
        <source>Arm limit stop</source>
        <translation>Stopp scharf schalten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
    <message>
        <source>Stop at limit 1</source>
        <translation>Bei Endschalter 1 stoppen</translation>
    </message>
    <message>
        <source>Stop at limit 2</source>
        <translation>Bei Endschalter 2 stoppen</translation>
    </message>
    <message>
        <source>Arm the limit stop</source>
        <translation>Den Endschalter-Stopp scharf schalten</translation>
    </message>
    <message>
        <source>Disarm the limit stop</source>
        <translation>Den Endschalter-Stopp entschärfen</translation>
    </message>
    <message>
        <source>State of the limit stop</source>
        <translation>Zustand des Endschalter-Stopps</translation>
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
        <source>Motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>Stop abruptly at the limit</source>
        <translation>Am Endschalter sofort stoppen</translation>
    </message>
    <message>
        <source>Stop smoothly at the limit</source>
        <translation>Am Endschalter sanft stoppen</translation>
    </message>
    <message>
        <source>Switch the motor off at the limit</source>
        <translation>Am Endschalter den Motor abschalten</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Stoppen bei</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>A search for home is under way; it uses the same watch of the chip.</source>
        <translation>Eine Referenzsuche läuft; sie benutzt dieselbe Überwachung des Chips.</translation>
    </message>
    <message>
        <source>Choose a limit first.</source>
        <translation>Zuerst einen Endschalter wählen.</translation>
    </message>
    <message>
        <source>The motor stops when limit 1 changes.</source>
        <translation>Der Motor stoppt, wenn sich Endschalter 1 ändert.</translation>
    </message>
    <message>
        <source>The motor stops when limit 2 changes.</source>
        <translation>Der Motor stoppt, wenn sich Endschalter 2 ändert.</translation>
    </message>
    <message>
        <source>At the limit the motor stops at once, and holds.</source>
        <translation>Am Endschalter stoppt der Motor sofort und hält dann die Position.</translation>
    </message>
    <message>
        <source>At the limit the motor slows down, stops behind it, and holds.</source>
        <translation>Am Endschalter bremst der Motor, stoppt hinter ihm und hält dann die Position.</translation>
    </message>
    <message>
        <source>At the limit the motor is switched off, and is free to turn.</source>
        <translation>Am Endschalter wird der Motor abgeschaltet und ist frei drehbar.</translation>
    </message>
    <message>
        <source>The chip itself then stops the motor when a chosen limit changes, once; sooner than the panel could. A search for home replaces it.</source>
        <translation>Der Chip selbst stoppt dann den Motor, wenn sich ein gewählter Endschalter ändert, einmal; früher, als das Programm es könnte. Eine Referenzsuche ersetzt es.</translation>
    </message>
    <message>
        <source>It is not armed.</source>
        <translation>Er ist nicht scharf.</translation>
    </message>
    <message>
        <source>A limit no longer stops the motor.</source>
        <translation>Ein Endschalter stoppt den Motor nicht mehr.</translation>
    </message>
    <message>
        <source>○ Not armed: a limit input alone does not stop the motor.</source>
        <translation>○ Nicht scharf: ein Endschaltereingang allein stoppt den Motor nicht.</translation>
    </message>
    <message>
        <source>○ This version of the chip cannot stop at a limit by itself.</source>
        <translation>○ Diese Version des Chips kann nicht von selbst an einem Endschalter stoppen.</translation>
    </message>
    <message>
        <source>○ Not armed: the search for home has replaced it.</source>
        <translation>○ Nicht scharf: die Referenzsuche hat ihn ersetzt.</translation>
    </message>
    <message>
        <source>● Armed: stops at %1, once.</source>
        <translation>● Scharf: stoppt an %1, einmal.</translation>
    </message>
    <message>
        <source>▲ Tripped: %1 has changed, and the motor was stopped. Not armed any more.</source>
        <translation>▲ Ausgelöst: %1 hat sich geändert, und der Motor wurde gestoppt. Nicht mehr scharf.</translation>
    </message>
    <message>
        <source>? The chip watches for something that was not asked for in this connection.</source>
        <translation>? Der Chip überwacht etwas, das in dieser Verbindung nicht angefordert wurde.</translation>
    </message>
    <message>
        <source>the position error limit</source>
        <translation>Grenze des Positionsfehlers</translation>
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
        <source>Position error</source>
        <translation>Positionsfehler</translation>
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
        <source>Stop when the position error exceeds its limit</source>
        <translation>Anhalten, wenn der Positionsfehler seine Grenze überschreitet</translation>
    </message>
    <message>
        <source>Stop when the current exceeds its limit</source>
        <translation>Anhalten, wenn der Strom seine Grenze überschreitet</translation>
    </message>
    <message>
        <source>Arm the limit stop for each motion of this axis</source>
        <translation>Den Endschalter-Stopp für jede Bewegung dieser Achse scharf schalten</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>The motor stops when it is farther from where it should be than EL allows; the servo goes off then in any case.</source>
        <translation>Der Motor hält an, wenn er weiter vom Sollort entfernt ist, als EL erlaubt; der Servo geht dann in jedem Fall aus.</translation>
    </message>
    <message>
        <source>The motor stops when its current exceeds CL.</source>
        <translation>Der Motor hält an, wenn sein Strom CL überschreitet.</translation>
    </message>
    <message>
        <source>Whenever the motor stands with its servo on, the panel arms the limit stop, also after it has tripped; no motion begins before. Kept with the machine.</source>
        <translation>Immer wenn der Motor mit eingeschaltetem Servo steht, schaltet das Panel den Endschalter-Stopp scharf, auch nachdem er ausgelöst hat; vorher beginnt keine Bewegung. Wird mit der Maschine gespeichert.</translation>
    </message>
    <message>
        <source>The axis has it armed for each motion: it would be armed again at once.</source>
        <translation>Die Achse hat ihn für jede Bewegung scharf: Er würde sofort wieder scharf geschaltet.</translation>
    </message>
</context>
<context>
    <name>nmc::LinkBar</name>
    <message>
        <source>State of the link</source>
        <translation>Zustand der Verbindung</translation>
    </message>
    <message>
        <source>Exchanges per second, and what share that is of what a perfect line would carry.</source>
        <translation>Übertragungen pro Sekunde und deren Anteil an dem, was eine perfekte Leitung schaffen würde.</translation>
    </message>
    <message>
        <source>Exchanges that went wrong: no answer, garbled, or refused for a bad checksum.</source>
        <translation>Misslungene Übertragungen: keine Antwort, verstümmelt oder wegen falscher Prüfsumme abgewiesen.</translation>
    </message>
    <message>
        <source>Mean time from sending a command to its whole answer.</source>
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
        <source>%1 exchanges/s, %2 % of the wire</source>
        <translation>%1 Übertragungen/s, %2 % der Leitung</translation>
    </message>
    <message>
        <source>1 error</source>
        <translation>1 Fehler</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 Fehler</translation>
    </message>
    <message>
        <source>%1, %2/s</source>
        <translation>%1, %2/s</translation>
    </message>
    <message>
        <source>round trip %1 ms</source>
        <translation>Antwortzeit %1 ms</translation>
    </message>
</context>
<context>
    <name>nmc::LoopTestsDock</name>
    <message>
        <source>Loop tests</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>Tests of the loop</source>
        <translation>Prüfungen des Regelkreises</translation>
    </message>
    <message>
        <source>Square wave</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Save a report of the tuning</source>
        <translation>Bericht über die Einstellung speichern</translation>
    </message>
    <message>
        <source>Select a PIC-SERVO first.</source>
        <translation>Zuerst einen PIC-SERVO wählen.</translation>
    </message>
    <message>
        <source>One page, as PDF or HTML: gains, the last step response, the motor that was found and the frequency response.</source>
        <translation>Eine Seite, als PDF oder HTML: Reglerwerte, die letzte Sprungantwort, der gefundene Motor und der Frequenzgang.</translation>
    </message>
</context>
<context>
    <name>nmc::MachineMenu</name>
    <message>
        <source>&amp;New machine</source>
        <translation>&amp;Neue Maschine</translation>
    </message>
    <message>
        <source>Forgets names, units and settings of all axes; nothing is sent.</source>
        <translation>Vergisst Namen, Einheiten und Einstellungen aller Achsen; es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>&amp;Open machine…</source>
        <translation>Maschine ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Shows what a machine file would change; nothing is sent before you apply it.</source>
        <translation>Zeigt, was eine Maschinendatei ändern würde; vor dem Anwenden wird nichts gesendet.</translation>
    </message>
    <message>
        <source>&amp;Save machine</source>
        <translation>Maschine &amp;speichern</translation>
    </message>
    <message>
        <source>Writes names, units, gains, limits, homing and groups into the machine&apos;s file.</source>
        <translation>Schreibt Namen, Einheiten, Reglerwerte, Grenzen, Referenzsuche und Gruppen in die Datei der Maschine.</translation>
    </message>
    <message>
        <source>Save machine &amp;as…</source>
        <translation>Maschine speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Writes the machine into a file of another name.</source>
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
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open machine</source>
        <translation>Maschine öffnen</translation>
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
        <source>&amp;Close: the next start offers them again</source>
        <translation>S&amp;chließen: der nächste Start bietet sie wieder an</translation>
    </message>
    <message>
        <source>&amp;Save them</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Drop them: the changes are lost</source>
        <translation>&amp;Verwerfen: die Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>S&amp;tay</source>
        <translation>&amp;Bleiben</translation>
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
        <source>SIMULATOR — no hardware is connected; every value comes from the program itself</source>
        <translation>SIMULATOR — keine Hardware angeschlossen; alle Werte stammen aus dem Programm selbst</translation>
    </message>
    <message>
        <source>Simulated session</source>
        <translation>Simulierte Sitzung</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Oszilloskop</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
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
        <source>Choose a port and connect.
Without hardware, choose the simulator.</source>
        <translation>Einen Port wählen und verbinden.
Ohne Hardware den Simulator wählen.</translation>
    </message>
    <message>
        <source>No module.</source>
        <translation>Kein Modul.</translation>
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
        <source>St&amp;ay</source>
        <translation>&amp;Bleiben</translation>
    </message>
    <message>
        <source>Restart the network</source>
        <translation>Netzwerk neu starten</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost</source>
        <translation>Netzwerk &amp;neu starten: Positionen und Reglerwerte gehen verloren</translation>
    </message>
    <message>
        <source>Read-only session</source>
        <translation>Sitzung nur zum Lesen</translation>
    </message>
    <message>
        <source>READ-ONLY — nothing is sent but questions. STOP ALL acts.</source>
        <translation>NUR LESEN — außer Fragen wird nichts gesendet. ALLES STOPP wirkt.</translation>
    </message>
    <message>
        <source>Connect fully</source>
        <translation>Voll verbinden</translation>
    </message>
    <message>
        <source>Connects to the same port so that commands can be sent. Nothing moves by it.</source>
        <translation>Verbindet mit demselben Port so, dass Befehle gesendet werden können. Dadurch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (nur lesend)</translation>
    </message>
    <message>
        <source>It is not possible now.</source>
        <translation>Das ist jetzt nicht möglich.</translation>
    </message>
    <message>
        <source>Enter does it.</source>
        <translation>Eingabe führt ihn aus.</translation>
    </message>
    <message>
        <source>No module</source>
        <translation>Kein Modul</translation>
    </message>
    <message>
        <source>Its module is gone.</source>
        <translation>Das Modul gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Enter shows it on the page of its module; nothing is sent.</source>
        <translation>Eingabe zeigt ihn auf der Seite seines Moduls; es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Operator mode</source>
        <translation>Bedienermodus</translation>
    </message>
    <message>
        <source>OPERATOR MODE — only what is left to the operator can be done. STOP ALL acts.</source>
        <translation>BEDIENERMODUS — es geht nur, was dem Bediener überlassen ist. ALLES STOPP wirkt.</translation>
    </message>
    <message>
        <source>Leave it…</source>
        <translation>Verlassen…</translation>
    </message>
    <message>
        <source>Asks for the PIN.</source>
        <translation>Fragt nach der PIN.</translation>
    </message>
    <message>
        <source>End it</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>There is no module that could be moved.</source>
        <translation>Es gibt kein Modul, das bewegt werden könnte.</translation>
    </message>
    <message>
        <source>Shift with ◂ or ▸ moves it while both are held. Esc ends this.</source>
        <translation>Umschalt mit ◂ oder ▸ bewegt ihn, solange beide gehalten werden. Esc beendet das.</translation>
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
        <source>Module</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation>Handgerät</translation>
    </message>
    <message>
        <source>Arrow keys and gamepad move nothing any more.</source>
        <translation>Pfeiltasten und Gamepad bewegen nichts mehr.</translation>
    </message>
    <message>
        <source>Shift with ◂ or ▸ moves it while both are held; so does a shoulder button of the gamepad with its left stick or cross. B (○) is STOP ALL. Esc ends this.</source>
        <translation>Umschalt mit ◂ oder ▸ bewegt ihn, solange beide gehalten werden; ebenso eine Schultertaste des Gamepads mit seinem linken Stick oder Steuerkreuz. B (○) ist ALLES STOPP. Esc beendet das.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
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
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
</context>
<context>
    <name>nmc::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>No messages. What goes wrong, and when it is over, is told here.</source>
        <translation>Keine Meldungen. Was misslingt und wann es vorbei ist, steht hier.</translation>
    </message>
    <message>
        <source>None of the messages passes the filter above.</source>
        <translation>Der Filter oben lässt keine der Meldungen durch.</translation>
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
        <source>Which kind of messages is shown.</source>
        <translation>Welche Art von Meldungen gezeigt wird.</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>News</source>
        <translation>Neuigkeiten</translation>
    </message>
    <message>
        <source>Module whose messages are shown</source>
        <translation>Modul, dessen Meldungen gezeigt werden</translation>
    </message>
    <message>
        <source>Of which module messages are shown.</source>
        <translation>Von welchem Modul Meldungen gezeigt werden.</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>Alle Module</translation>
    </message>
    <message>
        <source>Not over</source>
        <translation>Nicht vorbei</translation>
    </message>
    <message>
        <source>Only messages that are not over</source>
        <translation>Nur Meldungen, die nicht vorbei sind</translation>
    </message>
    <message>
        <source>Shows only what is not over.</source>
        <translation>Zeigt nur, was nicht vorbei ist.</translation>
    </message>
    <message>
        <source>Words of the messages shown</source>
        <translation>Wörter der gezeigten Meldungen</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Wörter</translation>
    </message>
    <message>
        <source>Shows only messages with these words.</source>
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
        <source>Writes the messages that are shown to a text file.</source>
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
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
</context>
<context>
    <name>nmc::MessageRow</name>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>over at %1</source>
        <translation>vorbei um %1</translation>
    </message>
</context>
<context>
    <name>nmc::ModelBox</name>
    <message>
        <source>Motor model</source>
        <translation>Motormodell</translation>
    </message>
    <message>
        <source>Find the motor</source>
        <translation>Motor bestimmen</translation>
    </message>
    <message>
        <source>Find the motor that explains the steps</source>
        <translation>Motor bestimmen, der die Sprünge erklärt</translation>
    </message>
    <message>
        <source>The motor that was found</source>
        <translation>Der bestimmte Motor</translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation>Eintragen</translation>
    </message>
    <message>
        <source>Fill the suggested gains into the fields</source>
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
        <source>How fast it follows: at the right as fast as noise, output limit and stability permit.</source>
        <translation>Wie schnell er folgt: rechts so schnell, wie Geräusch, Ausgangsgrenze und Stabilität erlauben.</translation>
    </message>
    <message>
        <source>Damped</source>
        <translation>Gedämpft</translation>
    </message>
    <message>
        <source>At the right it does not overshoot.</source>
        <translation>Rechts schwingt er nicht über.</translation>
    </message>
    <message>
        <source>Loud</source>
        <translation>Laut</translation>
    </message>
    <message>
        <source>How much a count of the encoder may shake the motor by way of Kd.</source>
        <translation>Wie sehr ein Inkrement des Gebers den Motor über Kd rütteln darf.</translation>
    </message>
    <message>
        <source>It is being looked for.</source>
        <translation>Er wird gerade bestimmt.</translation>
    </message>
    <message>
        <source>Make a step with this module first.</source>
        <translation>Zuerst einen Sprung mit diesem Modul machen.</translation>
    </message>
    <message>
        <source>Finds the motor that explains the last steps of this module, up to %1 of them. Sends nothing.</source>
        <translation>Bestimmt den Motor, der die letzten Sprünge dieses Moduls erklärt, bis zu %1 davon. Sendet nichts.</translation>
    </message>
    <message>
        <source>No gains are suggested.</source>
        <translation>Es sind keine Reglerwerte vorgeschlagen.</translation>
    </message>
    <message>
        <source>Puts the suggested gains into the fields of the Gains page. Sends nothing.</source>
        <translation>Trägt die vorgeschlagenen Werte in die Felder der Seite Reglerwerte ein. Sendet nichts.</translation>
    </message>
    <message>
        <source>Looking for the motor…</source>
        <translation>Motor wird bestimmt …</translation>
    </message>
    <message>
        <source>The run that it was found from is gone. Find it again.</source>
        <translation>Der Lauf, aus dem er bestimmt wurde, ist fort. Neu bestimmen.</translation>
    </message>
    <message>
        <source>No gains make this motor stable and still.</source>
        <translation>Mit keinen Reglerwerten ist dieser Motor stabil und ruhig.</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleBench</name>
    <message>
        <source>What can be done to the simulated module</source>
        <translation>Was sich am simulierten Modul einstellen lässt</translation>
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
        <source>Motor power</source>
        <translation>Motorversorgung</translation>
    </message>
    <message>
        <source>The supply of the motor, not of the module.</source>
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
        <source>Home switch</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>E-stop input</source>
        <translation>E-Stop-Eingang</translation>
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
        <source>A/D input</source>
        <translation>A/D-Eingang</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>von 255</translation>
    </message>
    <message>
        <source>What the converter reads at the temperature sensor.</source>
        <translation>Was der Wandler am Temperatursensor liest.</translation>
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
        <translation>Geberindex</translation>
    </message>
    <message>
        <source>Lasts until the shaft moves on.</source>
        <translation>Gilt, bis sich die Welle weiterbewegt.</translation>
    </message>
    <message>
        <source>A/D input by hand</source>
        <translation>A/D von Hand</translation>
    </message>
    <message>
        <source>Unchecked, the converter reads the motor&apos;s current.</source>
        <translation>Ohne Haken liest der Wandler den Motorstrom.</translation>
    </message>
    <message>
        <source>ADDR line broken towards the host</source>
        <translation>ADDR zum Rechner unterbrochen</translation>
    </message>
    <message>
        <source>Broken between this module and the next towards the host</source>
        <translation>Zwischen diesem Modul und dem nächsten zum Rechner hin unterbrochen</translation>
    </message>
    <message>
        <source>Broken between this module and the next towards the host: that one does not get an address.</source>
        <translation>Zwischen diesem Modul und dem nächsten zum Rechner hin unterbrochen: jenes bekommt keine Adresse.</translation>
    </message>
    <message>
        <source>Power-cycle</source>
        <translation>Aus und ein</translation>
    </message>
    <message>
        <source>Switches this module off and on: it forgets its address and its gains.</source>
        <translation>Schaltet dieses Modul aus und ein: es vergisst Adresse und Reglerwerte.</translation>
    </message>
    <message>
        <source>Power-cycle all</source>
        <translation>Alle aus und ein</translation>
    </message>
    <message>
        <source>Switches all modules off and on: they forget their addresses and gains.</source>
        <translation>Schaltet alle Module aus und ein: sie vergessen Adressen und Reglerwerte.</translation>
    </message>
    <message>
        <source>Late tick</source>
        <translation>Später Takt</translation>
    </message>
    <message>
        <source>Lets one servo tick take too long: servo_overrun.</source>
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
        <source>External torque; positive pulls the shaft backwards.</source>
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
        <source>Dry friction, which also holds the shaft at rest.</source>
        <translation>Trockene Reibung, die die Welle auch im Stillstand hält.</translation>
    </message>
    <message>
        <source>Stop, reverse</source>
        <translation>Anschlag rückw.</translation>
    </message>
    <message>
        <source>A hard stop at the reverse end of the travel. It cannot be put beyond the place where the shaft is.</source>
        <translation>Ein fester Anschlag am rückwärtigen Ende des Wegs. Er kann nicht jenseits der Welle liegen.</translation>
    </message>
    <message>
        <source>Stop, forward</source>
        <translation>Anschlag vorw.</translation>
    </message>
    <message>
        <source>A hard stop at the forward end of the travel. It cannot be put beyond the place where the shaft is.</source>
        <translation>Ein fester Anschlag am vorderen Ende des Wegs. Er kann nicht jenseits der Welle liegen.</translation>
    </message>
    <message>
        <source>Limit switches at the stops</source>
        <translation>Endschalter an den Anschlägen</translation>
    </message>
    <message>
        <source>Limit switches at the travel&apos;s ends</source>
        <translation>Endschalter an den Enden des Wegs</translation>
    </message>
    <message>
        <source>The limit switches close at the travel&apos;s ends; they cannot be set by hand then.</source>
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
        <source>The home switch is closed from there on, forward. Unchecked, it is set by hand.</source>
        <translation>Der Referenzschalter ist von dort an vorwärts geschlossen. Ohne Haken wird er von Hand gestellt.</translation>
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
        <source>Motion</source>
        <translation>Bewegung</translation>
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
        <source>Motion</source>
        <translation>Bewegung</translation>
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
        <source>&amp;Go</source>
        <translation>A&amp;nfahren</translation>
    </message>
    <message>
        <source>Go to the position</source>
        <translation>Die Position anfahren</translation>
    </message>
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
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Velocity of running</source>
        <translation>Geschwindigkeit des Dauerlaufs</translation>
    </message>
    <message>
        <source>Run &amp;reverse</source>
        <translation>Rüc&amp;kwärts</translation>
    </message>
    <message>
        <source>Run in reverse until stopped</source>
        <translation>Dauerlauf rückwärts bis zum Stopp</translation>
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
        <source>Starts the move to the position, and holds there.</source>
        <translation>Startet die Fahrt zur Position und hält dort.</translation>
    </message>
    <message>
        <source>Runs forward until it is stopped.</source>
        <translation>Läuft vorwärts bis zum Stopp.</translation>
    </message>
    <message>
        <source>Runs in reverse until it is stopped.</source>
        <translation>Läuft rückwärts bis zum Stopp.</translation>
    </message>
    <message>
        <source>How fast the velocity changes. Used by every kind of motion here, and by a smooth stop.</source>
        <translation>Wie schnell sich die Geschwindigkeit ändert. Gilt hier für jede Art von Bewegung und für den sanften Stopp.</translation>
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
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>distance from here</source>
        <translation>Strecke von hier</translation>
    </message>
    <message>
        <source>Whether the number is a position, or a distance from where the motor is now.</source>
        <translation>Ob die Zahl eine Position ist oder eine Strecke von dort, wo der Motor jetzt steht.</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>Hier n&amp;ullen</translation>
    </message>
    <message>
        <source>Make the present position zero</source>
        <translation>Die jetzige Position zu null machen</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Zur Referenz</translation>
    </message>
    <message>
        <source>Go to the home position</source>
        <translation>Die Referenzposition anfahren</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
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
        <source>It is there already</source>
        <translation>Der Motor ist bereits dort</translation>
    </message>
    <message>
        <source>The goal is beyond the range of positions.</source>
        <translation>Das Ziel liegt außerhalb des Positionsbereichs.</translation>
    </message>
    <message>
        <source>Where to go from standstill, with a trapezoidal profile. Enter starts the move.</source>
        <translation>Wohin aus dem Stillstand mit Trapezprofil gefahren wird. Eingabe startet die Fahrt.</translation>
    </message>
    <message>
        <source>Go to &amp;position</source>
        <translation>&amp;Position anfahren</translation>
    </message>
    <message>
        <source>Run at vel&amp;ocity</source>
        <translation>Laufges&amp;chwindigkeit</translation>
    </message>
    <message>
        <source>How fast the motor turns until it is stopped. Enter runs, and changes the velocity on the way.</source>
        <translation>Wie schnell sich der Motor bis zum Stopp dreht. Eingabe startet den Lauf und ändert unterwegs die Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Loads the move and does not start it: Start does, or the start of the module&apos;s group.</source>
        <translation>Lädt die Fahrt und startet sie nicht: das tut „Starten“ oder der Start der Gruppe des Moduls.</translation>
    </message>
    <message>
        <source>Starts the move that was loaded.</source>
        <translation>Startet die geladene Fahrt.</translation>
    </message>
    <message>
        <source>Goes to home.</source>
        <translation>Fährt zur Referenz.</translation>
    </message>
    <message>
        <source>Take the nearest</source>
        <translation>Nächste nehmen</translation>
    </message>
    <message>
        <source>Put the nearest position that is allowed into the goal</source>
        <translation>Die nächste erlaubte Position als Ziel eintragen</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>%1 nehmen</translation>
    </message>
    <message>
        <source>Puts the nearest position that is allowed into the goal. Nothing moves.</source>
        <translation>Trägt die nächste erlaubte Position als Ziel ein. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Runs forward until it is stopped, or to its highest position.</source>
        <translation>Läuft vorwärts, bis angehalten wird, oder bis zur höchsten Position.</translation>
    </message>
    <message>
        <source>Runs in reverse until it is stopped, or to its lowest position.</source>
        <translation>Läuft rückwärts, bis angehalten wird, oder bis zur tiefsten Position.</translation>
    </message>
</context>
<context>
    <name>nmc::NumberField</name>
    <message>
        <source>%1 takes %2 to %3%4.</source>
        <translation>%1: möglich ist %2 bis %3%4.</translation>
    </message>
    <message>
        <source>%1 is still empty.</source>
        <translation>%1 ist noch leer.</translation>
    </message>
    <message>
        <source>%1 needs a number.</source>
        <translation>%1 braucht eine Zahl.</translation>
    </message>
    <message>
        <source>%1 has two decimal marks. Both , and . are the decimal mark here.</source>
        <translation>%1 hat zwei Dezimalzeichen. Sowohl , als auch . ist hier Dezimalzeichen.</translation>
    </message>
    <message>
        <source>%1 needs a whole number.</source>
        <translation>%1 braucht eine ganze Zahl.</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorDialog</name>
    <message>
        <source>Operator mode</source>
        <translation>Bedienermodus</translation>
    </message>
    <message>
        <source>Choose what is left to the operator. STOP ALL, Esc, each motor&apos;s stops and disconnecting always work. This keeps hands off by mistake; it is no security: who gets at the files of this computer gets around it.</source>
        <translation>Wählen Sie, was dem Bediener überlassen bleibt. ALLES STOPP, Esc, die Stopps jedes Motors und Trennen gehen immer. Das schützt vor Versehen; es ist keine Sicherheit: Wer an die Dateien dieses Rechners kommt, kommt daran vorbei.</translation>
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
        <source>&amp;Moves: go to, run, by N</source>
        <translation>&amp;Fahrten: zu einem Ziel, dauernd, um N</translation>
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
        <source>P&amp;IN to leave it, 4 characters at least</source>
        <translation>P&amp;IN zum Verlassen, mindestens 4 Zeichen</translation>
    </message>
    <message>
        <source>The same &amp;again</source>
        <translation>Die&amp;selbe noch einmal</translation>
    </message>
    <message>
        <source>&amp;Begin operator mode</source>
        <translation>Bedienermodus be&amp;ginnen</translation>
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
        <source>Leave it as it is</source>
        <translation>Lassen, wie es ist</translation>
    </message>
    <message>
        <source>The PIN is too short: it needs 4 characters.</source>
        <translation>Die PIN ist zu kurz: Sie braucht 4 Zeichen.</translation>
    </message>
    <message>
        <source>The two PINs differ. Type the same one twice.</source>
        <translation>Die beiden PINs sind verschieden. Tippen Sie zweimal dieselbe.</translation>
    </message>
    <message>
        <source>That is not the PIN. %1</source>
        <translation>Das ist nicht die PIN. %1</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorLock</name>
    <message>
        <source>If it is forgotten, close the panel and remove the part &quot;operator&quot; from %1.</source>
        <translation>Ist sie vergessen, schließen Sie das Programm und entfernen Sie den Abschnitt „operator“ aus %1.</translation>
    </message>
    <message>
        <source>Leave o&amp;perator mode…</source>
        <translation>&amp;Bedienermodus verlassen…</translation>
    </message>
    <message>
        <source>O&amp;perator mode…</source>
        <translation>&amp;Bedienermodus…</translation>
    </message>
    <message>
        <source>Asks for the PIN.</source>
        <translation>Fragt nach der PIN.</translation>
    </message>
    <message>
        <source>Leaves to an operator only what you choose, until somebody has the PIN.</source>
        <translation>Überlässt einem Bediener nur, was Sie wählen, bis jemand die PIN hat.</translation>
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
        <source>Command</source>
        <translation>Befehl</translation>
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
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>nmc::PacketMonitor</name>
    <message>
        <source>Packet monitor</source>
        <translation>Paketmonitor</translation>
    </message>
    <message>
        <source>Packets of which module</source>
        <translation>Pakete welches Moduls</translation>
    </message>
    <message>
        <source>Shows the packets of one module only (Ctrl+M).</source>
        <translation>Zeigt nur die Pakete eines Moduls (Strg+M).</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>Alle Module</translation>
    </message>
    <message>
        <source>Packets of which kind</source>
        <translation>Pakete welcher Art</translation>
    </message>
    <message>
        <source>Shows packets of one kind only (Ctrl+T).</source>
        <translation>Zeigt nur Pakete einer Art (Strg+T).</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>Polls</source>
        <translation>Abfragen</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
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
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stops recording; what is shown stays (%1).</source>
        <translation>Hält die Aufzeichnung an; das Gezeigte bleibt (%1).</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Forgets the packets shown so far (%1).</source>
        <translation>Vergisst die bisher gezeigten Pakete (%1).</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected rows as text, or all when none is selected (%1).</source>
        <translation>Kopiert die gewählten Zeilen als Text, oder alle, wenn keine gewählt ist (%1).</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Saves everything recorded as a text, or as a log that can be replayed (%1).</source>
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
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
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
        <source>Packets, the newest last</source>
        <translation>Pakete, die neuesten zuletzt</translation>
    </message>
    <message>
        <source>No packets. Every exchange is recorded while this can be seen.</source>
        <translation>Keine Pakete. Jede Übertragung wird aufgezeichnet, solange dies zu sehen ist.</translation>
    </message>
    <message>
        <source>No packet of this module and kind has been recorded.</source>
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
        <source>Enable the servo of this module</source>
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
        <source>Stop this module abruptly</source>
        <translation>Dieses Modul sofort stoppen</translation>
    </message>
    <message>
        <source>&amp;Motor off</source>
        <translation>&amp;Motor aus</translation>
    </message>
    <message>
        <source>Switch this motor off</source>
        <translation>Diesen Motor abschalten</translation>
    </message>
    <message>
        <source>State of the selected module</source>
        <translation>Zustand des gewählten Moduls</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Position unbekannt</translation>
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
        <source>%1, address %2</source>
        <translation>%1, Adresse %2</translation>
    </message>
    <message>
        <source>The servo is on already.</source>
        <translation>Der Servo ist bereits ein.</translation>
    </message>
    <message>
        <source>Switches the amplifier on and holds the motor where it is.</source>
        <translation>Schaltet den Verstärker ein und hält den Motor an seiner Position.</translation>
    </message>
    <message>
        <source>Slows down at the acceleration in force, then holds.</source>
        <translation>Bremst mit der geltenden Beschleunigung, hält dann die Position.</translation>
    </message>
    <message>
        <source>Stops at once, then holds.</source>
        <translation>Stoppt sofort, hält dann die Position.</translation>
    </message>
    <message>
        <source>Switches servo and amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Schaltet Servo und Verstärker aus: der Motor ist frei drehbar, eine Last kann absinken.</translation>
    </message>
    <message>
        <source>&amp;Enable amplifier</source>
        <translation>Verstärker &amp;einschalten</translation>
    </message>
    <message>
        <source>Enable the amplifier of this module</source>
        <translation>Den Verstärker dieses Moduls einschalten</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Hier stoppen</translation>
    </message>
    <message>
        <source>Stop this module at its present position</source>
        <translation>Dieses Modul an seiner jetzigen Position stoppen</translation>
    </message>
    <message>
        <source>Position %1 %2</source>
        <translation>Position %1 %2</translation>
    </message>
    <message>
        <source>The amplifier is on already.</source>
        <translation>Der Verstärker ist bereits ein.</translation>
    </message>
    <message>
        <source>Stops at once and switches the amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Stoppt sofort und schaltet den Verstärker aus: der Motor ist frei drehbar, eine Last kann absinken.</translation>
    </message>
    <message>
        <source>What runs with this module</source>
        <translation>Was mit diesem Modul läuft</translation>
    </message>
    <message>
        <source>Measured velocity</source>
        <translation>Gemessene Geschwindigkeit</translation>
    </message>
    <message>
        <source>How fast it turns, measured from its positions over a fifth of a second.</source>
        <translation>Wie schnell er sich dreht, gemessen an den Positionen einer Fünftelsekunde.</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>Motorstrom</translation>
    </message>
    <message>
        <source>A/D input</source>
        <translation>A/D-Eingang</translation>
    </message>
    <message>
        <source>Limit input 1.</source>
        <translation>Endschaltereingang 1.</translation>
    </message>
    <message>
        <source>Limit input 1: high blocks forward.</source>
        <translation>Endschaltereingang 1: high sperrt vorwärts.</translation>
    </message>
    <message>
        <source>Limit input 2.</source>
        <translation>Endschaltereingang 2.</translation>
    </message>
    <message>
        <source>Limit input 2: high blocks reverse.</source>
        <translation>Endschaltereingang 2: high sperrt rückwärts.</translation>
    </message>
    <message>
        <source>Motor power, as the module senses it.</source>
        <translation>Motorspannung, wie das Modul sie erkennt.</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>Endschalter-Stopp</translation>
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
        <source>A/D %1</source>
        <translation>A/D %1</translation>
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
        <source>Jumps without a profile to the position it has at this moment, then holds there.</source>
        <translation>Springt ohne Profil an die Position, die er in diesem Augenblick hat, und hält dort.</translation>
    </message>
    <message>
        <source>Limits of travel</source>
        <translation>Fahrweggrenzen</translation>
    </message>
    <message>
        <source>Kp is 0: the servo brakes the motor, and holds no position.</source>
        <translation>Kp ist 0: Der Servo bremst den Motor und hält keine Position.</translation>
    </message>
    <message>
        <source>Switches the amplifier on, holds the motor where it is, and clears the sticky bits: that of the position error is set while the servo is off.</source>
        <translation>Schaltet den Verstärker ein, hält den Motor, wo er steht, und löscht die Sticky-Bits: Das der Regelabweichung ist gesetzt, solange der Servo aus ist.</translation>
    </message>
</context>
<context>
    <name>nmc::Pendant</name>
    <message>
        <source>Pendant: &amp;keyboard or gamepad</source>
        <translation>Handgerät: &amp;Tastatur oder Gamepad</translation>
    </message>
    <message>
        <source>Shift with an arrow key moves the motor while both are held; so does a shoulder button of a gamepad with its left stick or cross. B (○) of the gamepad is STOP ALL. (F12)</source>
        <translation>Umschalt mit einer Pfeiltaste bewegt den Motor, solange beide gehalten werden; ebenso eine Schultertaste eines Gamepads mit seinem linken Stick oder Steuerkreuz. B (○) des Gamepads ist ALLES STOPP. (F12)</translation>
    </message>
</context>
<context>
    <name>nmc::PinBox</name>
    <message>
        <source>Make all pins inputs</source>
        <translation>Alle Pins zu Eingängen machen</translation>
    </message>
    <message>
        <source>Make all twelve pins inputs</source>
        <translation>Alle zwölf Pins zu Eingängen machen</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pins</translation>
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
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Ask first</source>
        <translation>Erst fragen</translation>
    </message>
    <message>
        <source>Off at stop</source>
        <translation>Aus bei Stopp</translation>
    </message>
    <message>
        <source>input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>Richtung von %1</translation>
    </message>
    <message>
        <source>high</source>
        <translation>High</translation>
    </message>
    <message>
        <source>high: output %1</source>
        <translation>High: Ausgang %1</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What it is on this machine. Sends nothing.</source>
        <translation>Was es an dieser Maschine ist. Sendet nichts.</translation>
    </message>
    <message>
        <source>Ask before %1 changes</source>
        <translation>Fragen, bevor sich %1 ändert</translation>
    </message>
    <message>
        <source>The panel asks before it switches this output.</source>
        <translation>Das Programm fragt, bevor es diesen Ausgang schaltet.</translation>
    </message>
    <message>
        <source>STOP ALL takes %1 low</source>
        <translation>ALLES STOPP nimmt %1 auf Low</translation>
    </message>
    <message>
        <source>STOP ALL takes this output low. Without a tick it stays as it is.</source>
        <translation>ALLES STOPP nimmt diesen Ausgang auf Low. Ohne Haken bleibt er, wie er ist.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
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
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
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
        <source>Makes all twelve pins inputs: outputs let go of what they drive.</source>
        <translation>Macht alle zwölf Pins zu Eingängen: Ausgänge lassen los, was sie treiben.</translation>
    </message>
    <message>
        <source>Another program has left this module, and it does not tell which pins are outputs. Make all pins inputs to begin anew.</source>
        <translation>Ein anderes Programm hat dieses Modul hinterlassen, und es sagt nicht, welche Pins Ausgänge sind. Alle Pins zu Eingängen machen, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>The directions are unknown. Make all pins inputs first.</source>
        <translation>Die Richtungen sind unbekannt. Zuerst alle Pins zu Eingängen machen.</translation>
    </message>
    <message>
        <source>Whether the module reads this pin or drives it.</source>
        <translation>Ob das Modul diesen Pin liest oder treibt.</translation>
    </message>
    <message>
        <source>high, told low</source>
        <translation>High, soll Low sein</translation>
    </message>
    <message>
        <source>low, told high</source>
        <translation>Low, soll High sein</translation>
    </message>
    <message>
        <source>low</source>
        <translation>Low</translation>
    </message>
    <message>
        <source>This pin is an input.</source>
        <translation>Dieser Pin ist ein Eingang.</translation>
    </message>
    <message>
        <source>The directions are unknown.</source>
        <translation>Die Richtungen sind unbekannt.</translation>
    </message>
    <message>
        <source>Switches this output at once.</source>
        <translation>Schaltet diesen Ausgang sofort.</translation>
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
        <source>Motor off</source>
        <translation>Motor aus</translation>
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
        <source>The PWM value</source>
        <translation>Der PWM-Wert</translation>
    </message>
    <message>
        <source>How much of the supply drives the motor: 255 is all of it.</source>
        <translation>Welcher Anteil der Versorgung den Motor treibt: 255 ist die ganze.</translation>
    </message>
    <message>
        <source>Drive the motor in reverse with this PWM value</source>
        <translation>Den Motor mit diesem PWM-Wert rückwärts treiben</translation>
    </message>
    <message>
        <source>Drive the motor forward with this PWM value</source>
        <translation>Den Motor mit diesem PWM-Wert vorwärts treiben</translation>
    </message>
    <message>
        <source>Switch this motor off</source>
        <translation>Diesen Motor abschalten</translation>
    </message>
    <message>
        <source>The motor is driven directly, without the servo: no position limit, no position error limit and no output limit protects it, and it runs until it is switched off.</source>
        <translation>Der Motor wird direkt getrieben, ohne den Servo: keine Positionsgrenze, keine Grenze der Regelabweichung und keine Ausgangsgrenze schützt ihn, und er läuft, bis er abgeschaltet wird.</translation>
    </message>
    <message>
        <source>= %1 %</source>
        <translation>= %1 %</translation>
    </message>
    <message>
        <source>Drives the motor in reverse until it is switched off.</source>
        <translation>Treibt den Motor rückwärts, bis er abgeschaltet wird.</translation>
    </message>
    <message>
        <source>Drives the motor forward until it is switched off.</source>
        <translation>Treibt den Motor vorwärts, bis er abgeschaltet wird.</translation>
    </message>
    <message>
        <source>Switches servo and amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Schaltet Servo und Verstärker aus: der Motor ist frei drehbar, eine Last kann absinken.</translation>
    </message>
</context>
<context>
    <name>nmc::RatePage</name>
    <message>
        <source>&amp;Change the rate</source>
        <translation>&amp;Rate ändern</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>New rate of the chain</source>
        <translation>Neue Rate der Kette</translation>
    </message>
    <message>
        <source>The rate that the whole chain shall run at.</source>
        <translation>Die Rate, mit der die ganze Kette arbeiten soll.</translation>
    </message>
    <message>
        <source>Change the rate of the whole chain</source>
        <translation>Die Rate der ganzen Kette ändern</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>Positions, gains and groups stay. Every module is asked at the new rate; when one does not answer there, all go back to the old one.</source>
        <translation>Positionen, Reglerwerte und Gruppen bleiben. Jedes Modul wird bei der neuen Rate abgefragt; antwortet eines dort nicht, kehren alle zur alten zurück.</translation>
    </message>
    <message>
        <source>The chain runs at %1 Bd.</source>
        <translation>Die Kette arbeitet mit %1 Bd.</translation>
    </message>
    <message>
        <source>A motor is moving. The rate changes at standstill only.</source>
        <translation>Ein Motor ist in Bewegung. Die Rate wird nur im Stillstand geändert.</translation>
    </message>
    <message>
        <source>The chain runs at this rate already.</source>
        <translation>Die Kette arbeitet bereits mit dieser Rate.</translation>
    </message>
    <message>
        <source>Tells every module the new rate, and asks each there.</source>
        <translation>Teilt jedem Modul die neue Rate mit und fragt jedes dort ab.</translation>
    </message>
    <message>
        <source>Some modules do not answer, and would be left behind at the old rate: %1.</source>
        <translation>Einige Module antworten nicht und blieben bei der alten Rate zurück: %1.</translation>
    </message>
    <message>
        <source>The groups of some modules are not known, so they might not hear it: %1. Choose a group for them on the page Groups, or none.</source>
        <translation>Die Gruppen einiger Module sind nicht bekannt, sie würden es also vielleicht nicht hören: %1. Wählen Sie auf der Seite Gruppen eine für sie, oder keine.</translation>
    </message>
    <message>
        <source>A leader of a group would answer while the rate changes. Take that from these on the page Groups: %1.</source>
        <translation>Ein Gruppenleiter würde antworten, während die Rate wechselt. Nehmen Sie das auf der Seite Gruppen diesen ab: %1.</translation>
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
        <source>The rate is 1 250 000 Bd / (divisor + 1). Whether the port of this computer makes it to within 2 % is tried before any module is told.</source>
        <translation>Die Rate ist 1 250 000 Bd / (Teiler + 1). Ob der Anschluss dieses Rechners sie auf 2 % genau erzeugt, wird geprüft, bevor ein Modul davon erfährt.</translation>
    </message>
    <message>
        <source>= %1 Bd</source>
        <translation>= %1 Bd</translation>
    </message>
</context>
<context>
    <name>nmc::RowDelegate</name>
    <message>
        <source>Number of the row</source>
        <translation>Zahl der Zeile</translation>
    </message>
    <message>
        <source>The number</source>
        <translation>Die Zahl</translation>
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
        <source>for ever</source>
        <translation>endlos</translation>
    </message>
    <message>
        <source>%1 times in all</source>
        <translation>insgesamt %1-mal</translation>
    </message>
    <message>
        <source>Do</source>
        <translation>Tun</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Holds the picture still (Ctrl+P). Samples are still recorded.</source>
        <translation>Hält das Bild an (Strg+P). Messwerte werden weiter erfasst.</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Two cursors to measure with: drag them (C).</source>
        <translation>Zwei Cursor zum Messen, die sich ziehen lassen (C).</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Statusbits</translation>
    </message>
    <message>
        <source>The status bits of the selected module over time (B).</source>
        <translation>Die Statusbits des gewählten Moduls über der Zeit (B).</translation>
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
        <source>How much time the scope shows.</source>
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
        <source>Which signals of which modules stand in which strip (S).</source>
        <translation>Welche Signale welcher Module in welchem Streifen stehen (S).</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Waits for a signal or a status bit, and holds what was around it (T).</source>
        <translation>Wartet auf ein Signal oder ein Statusbit und hält fest, was darum herum war (T).</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu live</translation>
    </message>
    <message>
        <source>Shows what the modules say now.</source>
        <translation>Zeigt, was die Module jetzt melden.</translation>
    </message>
    <message>
        <source>What is shown instead of the present</source>
        <translation>Was statt der Gegenwart gezeigt wird</translation>
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
        <source>Every sample of all modules in the time that is seen, to be opened here again.</source>
        <translation>Jeder Messwert aller Module in der sichtbaren Zeit; lässt sich hier wieder öffnen.</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Bild (PNG)…</translation>
    </message>
    <message>
        <source>What is seen, as an image.</source>
        <translation>Das Sichtbare als Bild.</translation>
    </message>
    <message>
        <source>&amp;Vector picture (SVG)…</source>
        <translation>&amp;Vektorbild (SVG)…</translation>
    </message>
    <message>
        <source>What is seen, in lines that stay sharp at any size.</source>
        <translation>Das Sichtbare in Linien, die in jeder Größe scharf bleiben.</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>What is seen, onto the clipboard; with its samples where these are few.</source>
        <translation>Das Sichtbare in die Zwischenablage; mit seinen Messwerten, wenn es wenige sind.</translation>
    </message>
    <message>
        <source>Export from the scope</source>
        <translation>Aus dem Oszilloskop exportieren</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>oszilloskop</translation>
    </message>
    <message>
        <source>P&amp;age (PDF)…</source>
        <translation>&amp;Seite (PDF)…</translation>
    </message>
    <message>
        <source>What is seen, on a page for a printer or a report.</source>
        <translation>Was zu sehen ist, auf einer Seite für einen Drucker oder einen Bericht.</translation>
    </message>
    <message>
        <source>P&amp;rint</source>
        <translation>&amp;Drucken</translation>
    </message>
    <message>
        <source>What is seen, on a page of the printer that this computer uses unless told otherwise.</source>
        <translation>Was zu sehen ist, auf einer Seite des Standarddruckers dieses Rechners.</translation>
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
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leaves the file alone; the scope stays as it is.</source>
        <translation>Lässt die Datei, wie sie ist; das Oszilloskop bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Shows a recording in the scope. Control of the motors goes on.</source>
        <translation>Zeigt eine Aufzeichnung im Oszilloskop. Die Steuerung der Motoren läuft weiter.</translation>
    </message>
    <message>
        <source>Writes every sample of all modules to a file from now on (Ctrl+Shift+R).</source>
        <translation>Schreibt ab jetzt jeden Messwert aller Module in eine Datei (Strg+Umschalt+R).</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Aufzeichnen…</translation>
    </message>
    <message>
        <source>There is nothing to record: no module is connected.</source>
        <translation>Es gibt nichts aufzuzeichnen: kein Modul ist verbunden.</translation>
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
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>&amp;Lay a recording under the live traces…</source>
        <translation>Aufzeichnung unter die laufenden Kurven &amp;legen …</translation>
    </message>
    <message>
        <source>Under the live traces</source>
        <translation>Unter den laufenden Kurven</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes the recording out of the plots. Its file stays as it is.</source>
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
        <source>Draws a recording pale below what is live, its first motion where the last one here began.</source>
        <translation>Zeichnet eine Aufzeichnung blass unter das Laufende, ihre erste Bewegung dort, wo hier die letzte begann.</translation>
    </message>
    <message>
        <source>Lay a recording under the live traces</source>
        <translation>Aufzeichnung unter die laufenden Kurven legen</translation>
    </message>
    <message>
        <source>Pale below the live traces: %1</source>
        <translation>Blass unter den laufenden Kurven: %1</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePanel</name>
    <message>
        <source>Scope</source>
        <translation>Oszilloskop</translation>
    </message>
    <message>
        <source>Takes what is seen out of the scope: samples or a picture.</source>
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
        <source>Pale below: %1</source>
        <translation>Blass darunter: %1</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePlot</name>
    <message>
        <source>%1 · not known now</source>
        <translation>%1 · jetzt nicht bekannt</translation>
    </message>
    <message>
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The band is wider than the strip: %1 to %2</source>
        <translation>Das Band ist breiter als der Streifen: %1 bis %2</translation>
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
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Drag it to resize the strips. A double click makes them equal.</source>
        <translation>Ziehen ändert die Höhe der Streifen. Ein Doppelklick macht sie gleich hoch.</translation>
    </message>
    <message>
        <source>error, reported</source>
        <translation>Positionsfehler, gemeldet</translation>
    </message>
</context>
<context>
    <name>nmc::SequencesPage</name>
    <message>
        <source>Points and sequences</source>
        <translation>Punkte und Abläufe</translation>
    </message>
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
        <source>The ticked axes become part of the point.</source>
        <translation>Die angekreuzten Achsen werden Teil des Punkts.</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Teachen</translation>
    </message>
    <message>
        <source>Teach a point: keep where the ticked axes stand</source>
        <translation>Einen Punkt teachen: behalten, wo die angekreuzten Achsen stehen</translation>
    </message>
    <message>
        <source>Go to point</source>
        <translation>Zum Punkt</translation>
    </message>
    <message>
        <source>Move to the chosen point</source>
        <translation>Zum gewählten Punkt fahren</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen point</source>
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
        <source>Another name for this sequence; Enter takes it.</source>
        <translation>Ein anderer Name für diesen Ablauf; die Eingabetaste übernimmt ihn.</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Neuer Ablauf</translation>
    </message>
    <message>
        <source>Add an empty sequence</source>
        <translation>Einen leeren Ablauf hinzufügen</translation>
    </message>
    <message>
        <source>Remove sequence</source>
        <translation>Ablauf entfernen</translation>
    </message>
    <message>
        <source>Remove this sequence with its rows</source>
        <translation>Diesen Ablauf mit seinen Zeilen entfernen</translation>
    </message>
    <message>
        <source>Rows of the sequence</source>
        <translation>Zeilen des Ablaufs</translation>
    </message>
    <message>
        <source>A double click or F2 changes what stands in a cell.</source>
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
        <source>Add a row behind the chosen one</source>
        <translation>Eine Zeile hinter der gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate the chosen row</source>
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
        <source>Remove the chosen row</source>
        <translation>Die gewählte Zeile entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hinauf</translation>
    </message>
    <message>
        <source>Move the chosen row up</source>
        <translation>Die gewählte Zeile hinauf schieben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Hinunter</translation>
    </message>
    <message>
        <source>Move the chosen row down</source>
        <translation>Die gewählte Zeile hinunter schieben</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change of points and sequences</source>
        <translation>Die letzte Änderung an Punkten und Abläufen rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo what was undone of points and sequences</source>
        <translation>Wiederherstellen, was an Punkten und Abläufen rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>Foresee the sequence on a simulated copy; nothing moves</source>
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
        <source>Run the sequence from the chosen row on</source>
        <translation>Den Ablauf ab der gewählten Zeile starten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause the sequence behind its row</source>
        <translation>Den Ablauf hinter seiner Zeile pausieren</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>Einzelschritt</translation>
    </message>
    <message>
        <source>Run one row of the sequence</source>
        <translation>Eine Zeile des Ablaufs ausführen</translation>
    </message>
    <message>
        <source>Stop sequence</source>
        <translation>Ablauf stoppen</translation>
    </message>
    <message>
        <source>Stop the sequence and its motors</source>
        <translation>Den Ablauf und seine Motoren stoppen</translation>
    </message>
    <message>
        <source>Teach point</source>
        <translation>Punkt teachen</translation>
    </message>
    <message>
        <source>Move row</source>
        <translation>Zeile schieben</translation>
    </message>
    <message>
        <source>Give the point a name first.</source>
        <translation>Dem Punkt erst einen Namen geben.</translation>
    </message>
    <message>
        <source>Tick at least one axis.</source>
        <translation>Mindestens eine Achse ankreuzen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Keeps where the ticked axes stand now under this name; nothing moves. A point that has the name already gets the new places.</source>
        <translation>Behält unter diesem Namen, wo die angekreuzten Achsen jetzt stehen; nichts fährt. Ein Punkt, der schon so heißt, bekommt die neuen Stellen.</translation>
    </message>
    <message>
        <source>Choose a point in the table.</source>
        <translation>Einen Punkt in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; moves to it.</source>
        <translation>Zeile %1 von „%2“ fährt dorthin.</translation>
    </message>
    <message>
        <source>Moves all axes of this point there at once, each at its own velocity.</source>
        <translation>Fährt alle Achsen dieses Punkts zugleich dorthin, jede mit ihrer eigenen Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Removes this point; nothing moves.</source>
        <translation>Entfernt diesen Punkt; nichts fährt.</translation>
    </message>
    <message>
        <source>There is no sequence yet.</source>
        <translation>Es gibt noch keinen Ablauf.</translation>
    </message>
    <message>
        <source>Choose a row in the table.</source>
        <translation>Eine Zeile in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Adds an empty sequence.</source>
        <translation>Fügt einen leeren Ablauf hinzu.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; calls it.</source>
        <translation>Zeile %1 von „%2“ ruft ihn auf.</translation>
    </message>
    <message>
        <source>Removes this sequence with its rows.</source>
        <translation>Entfernt diesen Ablauf mit seinen Zeilen.</translation>
    </message>
    <message>
        <source>Adds a row behind the chosen one, or at the end.</source>
        <translation>Fügt eine Zeile hinter der gewählten oder am Ende hinzu.</translation>
    </message>
    <message>
        <source>Adds the same row again behind it.</source>
        <translation>Fügt dieselbe Zeile dahinter noch einmal ein.</translation>
    </message>
    <message>
        <source>Removes this row.</source>
        <translation>Entfernt diese Zeile.</translation>
    </message>
    <message>
        <source>It cannot go any farther: a repeat stays below the row that it goes back to.</source>
        <translation>Weiter geht es nicht: eine Wiederholung bleibt unter der Zeile, zu der sie zurückspringt.</translation>
    </message>
    <message>
        <source>Moves this row up.</source>
        <translation>Schiebt diese Zeile hinauf.</translation>
    </message>
    <message>
        <source>Moves this row down.</source>
        <translation>Schiebt diese Zeile hinunter.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Undoes: %1</source>
        <translation>Macht rückgängig: %1</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>Does again: %1</source>
        <translation>Stellt wieder her: %1</translation>
    </message>
    <message>
        <source>A sequence runs already.</source>
        <translation>Ein Ablauf läuft schon.</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from its first row.</source>
        <translation>Startet „%1“ bei der ersten Zeile.</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from the chosen row on. Possible where the axes stand as the rows above leave them.</source>
        <translation>Startet „%1“ ab der gewählten Zeile. Möglich, wenn die Achsen so stehen, wie die Zeilen darüber sie verlassen.</translation>
    </message>
    <message>
        <source>No sequence runs.</source>
        <translation>Kein Ablauf läuft.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Goes on where it has paused.</source>
        <translation>Macht weiter, wo er pausiert hat.</translation>
    </message>
    <message>
        <source>Finishes the row that is under way, then waits.</source>
        <translation>Beendet die laufende Zeile und wartet dann.</translation>
    </message>
    <message>
        <source>It runs. Pause it first.</source>
        <translation>Er läuft. Ihn erst pausieren.</translation>
    </message>
    <message>
        <source>Runs one row, then waits. The first one is the chosen row.</source>
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
        <source>Shows how long the sequence takes, where each axis goes and what would be refused, on a simulated copy. Nothing moves.</source>
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
        <source>Gains</source>
        <translation>Reglerwerte</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Pages of the module</source>
        <translation>Seiten des Moduls</translation>
    </message>
    <message>
        <source>Limits &amp;&amp; I/O</source>
        <translation>Endschalter &amp;&amp; E/A</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenzsuche</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
</context>
<context>
    <name>nmc::SignalsDialog</name>
    <message>
        <source>Signals of the scope</source>
        <translation>Signale des Oszilloskops</translation>
    </message>
    <message>
        <source>Signals, and the strips they stand in</source>
        <translation>Signale und die Streifen, in denen sie stehen</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Strip %1</source>
        <translation>Streifen %1</translation>
    </message>
    <message>
        <source>A tick puts the signal into that strip. A strip without a tick is not shown.</source>
        <translation>Ein Haken setzt das Signal in diesen Streifen. Ein Streifen ohne Haken wird nicht gezeigt.</translation>
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
        <source>Filter: a module, a signal, or words of both</source>
        <translation>Filter: ein Modul, ein Signal oder Wörter von beiden</translation>
    </message>
    <message>
        <source>Position with its command position, below them the error and the motor current.</source>
        <translation>Die Position mit ihrer Sollposition, darunter Positionsfehler und Motorstrom.</translation>
    </message>
</context>
<context>
    <name>nmc::SimulatorDock</name>
    <message>
        <source>Simulator</source>
        <translation>Simulator</translation>
    </message>
    <message>
        <source>Simulated module</source>
        <translation>Simuliertes Modul</translation>
    </message>
    <message>
        <source>Follows the list of modules. Has those too that the panel does not find.</source>
        <translation>Folgt der Modulliste. Enthält auch Module, die das Programm nicht findet.</translation>
    </message>
</context>
<context>
    <name>nmc::SquarePlot</name>
    <message>
        <source>Square wave, one period</source>
        <translation>Rechteck, eine Periode</translation>
    </message>
    <message>
        <source>All edges with the present gains laid over one another: their median, and shaded where eight of ten samples are. Pale: with the gains before.</source>
        <translation>Alle Flanken mit den jetzigen Reglerwerten übereinander: ihr Median, und schattiert, wo acht von zehn Messwerten liegen. Blass: mit den Reglerwerten davor.</translation>
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
        <source>No edge is recorded yet. A square wave lays many steps over one another, while gains are changed.</source>
        <translation>Noch ist keine Flanke aufgezeichnet. Ein Rechteck legt viele Sprünge übereinander, während Reglerwerte geändert werden.</translation>
    </message>
</context>
<context>
    <name>nmc::SquareWavePage</name>
    <message>
        <source>Square wave</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>The motor jumps to and fro about where it is held. Everything that turns with it must be free to.</source>
        <translation>Der Motor springt um die Stelle, an der er gehalten wird, hin und her. Alles, was sich mitdreht, muss sich drehen können.</translation>
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
        <source>From side to side, half of it to either side of where the motor is held.</source>
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
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>The number of periods</source>
        <translation>Die Zahl der Perioden</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>The excursion</source>
        <translation>Die Auslenkung</translation>
    </message>
    <message>
        <source>How far the motor may go beyond either side. Farther than that it is held.</source>
        <translation>Wie weit der Motor über jede Seite hinaus gehen darf. Darüber hinaus wird er gehalten.</translation>
    </message>
    <message>
        <source>How the command is made to jump</source>
        <translation>Wie die Sollposition zum Springen gebracht wird</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What the edges come to</source>
        <translation>Was die Flanken ergeben</translation>
    </message>
    <message>
        <source>Keep as a run</source>
        <translation>Als Lauf behalten</translation>
    </message>
    <message>
        <source>Keep the folded edge as a step response</source>
        <translation>Die Flanken als Sprungantwort behalten</translation>
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
        <source>Settling %1</source>
        <translation>Einschwingen %1</translation>
    </message>
    <message>
        <source>Steady-state error %1</source>
        <translation>Bleibende Abweichung %1</translation>
    </message>
    <message>
        <source>No edge is recorded yet.</source>
        <translation>Noch ist keine Flanke aufgezeichnet.</translation>
    </message>
    <message>
        <source>Puts the median of the edges towards higher counts into the list of step responses.</source>
        <translation>Nimmt den Median der Flanken vorwärts in die Liste der Sprungantworten auf.</translation>
    </message>
    <message>
        <source>Edges with these gains: %1</source>
        <translation>Flanken mit diesen Reglerwerten: %1</translation>
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
    <name>nmc::StatusTable</name>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>nmc::StepByBox</name>
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
        <source>◂| Step</source>
        <translation>◂| Schritt</translation>
    </message>
    <message>
        <source>One step in reverse</source>
        <translation>Ein Schritt rückwärts</translation>
    </message>
    <message>
        <source>Step |▸</source>
        <translation>Schritt |▸</translation>
    </message>
    <message>
        <source>One step forward</source>
        <translation>Ein Schritt vorwärts</translation>
    </message>
    <message>
        <source>The number of steps</source>
        <translation>Die Zahl der Schritte</translation>
    </message>
    <message>
        <source>How many steps one click makes.</source>
        <translation>Wie viele Schritte ein Klick auslöst.</translation>
    </message>
    <message>
        <source>The pause between steps</source>
        <translation>Die Pause zwischen den Schritten</translation>
    </message>
    <message>
        <source>Seconds to wait after each move.</source>
        <translation>Wartezeit nach jeder Fahrt in Sekunden.</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>hin und zurück</translation>
    </message>
    <message>
        <source>Each step there and back</source>
        <translation>Jeder Schritt hin und zurück</translation>
    </message>
    <message>
        <source>Each step goes there and back again.</source>
        <translation>Jeder Schritt geht hin und wieder zurück.</translation>
    </message>
    <message>
        <source>End steps</source>
        <translation>Schritte beenden</translation>
    </message>
    <message>
        <source>End the steps and stop</source>
        <translation>Die Schritte beenden und stoppen</translation>
    </message>
    <message>
        <source>times, pause</source>
        <translation>mal, Pause</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Steps are being made already.</source>
        <translation>Es werden bereits Schritte gefahren.</translation>
    </message>
    <message>
        <source>Moves forward by this distance, and holds there.</source>
        <translation>Fährt um diese Strecke vorwärts und hält dort.</translation>
    </message>
    <message>
        <source>Moves in reverse by this distance, and holds there.</source>
        <translation>Fährt um diese Strecke rückwärts und hält dort.</translation>
    </message>
    <message>
        <source>No steps are being made.</source>
        <translation>Es werden keine Schritte gefahren.</translation>
    </message>
    <message>
        <source>Makes no more steps, and stops the motor smoothly.</source>
        <translation>Fährt keine weiteren Schritte und stoppt den Motor sanft.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>How far one click moves the motor, at the velocity of Go to.</source>
        <translation>Wie weit ein Klick den Motor bewegt, mit der Geschwindigkeit von „Position anfahren“.</translation>
    </message>
</context>
<context>
    <name>nmc::StepDetailsBox</name>
    <message>
        <source>Step pulses are coming.</source>
        <translation>Schrittimpulse kommen.</translation>
    </message>
    <message>
        <source>The module could not read the last command; it was not carried out.</source>
        <translation>Das Modul konnte den letzten Befehl nicht lesen; er wurde nicht ausgeführt.</translation>
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
        <source>The motor has the speed that was asked for.</source>
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
        <source>Waiting for the home position.</source>
        <translation>Wartet auf die Referenzposition.</translation>
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
        <source>High blocks forward, unless it is ignored.</source>
        <translation>High sperrt vorwärts, wenn der Eingang nicht ignoriert wird.</translation>
    </message>
    <message>
        <source>High blocks reverse, unless it is ignored.</source>
        <translation>High sperrt rückwärts, wenn der Eingang nicht ignoriert wird.</translation>
    </message>
    <message>
        <source>For homing.</source>
        <translation>Für die Referenzsuche.</translation>
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
        <source>moving as another program told it to</source>
        <translation>bewegt sich nach dem Befehl eines anderen Programms</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>Hie&amp;r nullen</translation>
    </message>
    <message>
        <source>Save as home</source>
        <translation>Als Referenz speichern</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Make the present position zero</source>
        <translation>Die jetzige Position zu null machen</translation>
    </message>
    <message>
        <source>Save the present position as home</source>
        <translation>Die jetzige Position als Referenz speichern</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Statusbyte</translation>
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
        <source>A/D (temperature)</source>
        <translation>A/D (Temperatur)</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Rohdaten</translation>
    </message>
    <message>
        <source>%1, stands for %2</source>
        <translation>%1, entspricht %2</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>Status %1</translation>
    </message>
    <message>
        <source>, inputs %1</source>
        <translation>, Eingänge %1</translation>
    </message>
    <message>
        <source>Keeps the present position as home. The motor does not move.</source>
        <translation>Merkt sich die jetzige Position als Referenz. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Home register</source>
        <translation>Referenzregister</translation>
    </message>
</context>
<context>
    <name>nmc::StepForm</name>
    <message>
        <source>How the next step is made</source>
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
        <source>How far the command jumps; below 0 in reverse. Small steps show how the servo is tuned, large ones what the amplifier can do.</source>
        <translation>Wie weit die Sollposition springt; unter 0 rückwärts. Kleine Sprünge zeigen, wie der Servo abgestimmt ist, große, was der Verstärker kann.</translation>
    </message>
    <message>
        <source>How the command is made to jump</source>
        <translation>Wie die Sollposition zum Springen gebracht wird</translation>
    </message>
    <message>
        <source>The record</source>
        <translation>Die Aufzeichnung</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>How long the motor is watched after the step. Then it is told to hold.</source>
        <translation>Wie lange der Motor nach dem Sprung beobachtet wird. Dann bekommt er einen Haltebefehl.</translation>
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
        <source>The motor has settled when it stays this close to its goal, and is never judged by less than a count. All runs are judged by it.</source>
        <translation>Der Motor ist eingeschwungen, wenn er so nahe am Ziel bleibt; strenger als auf ein Inkrement wird nie geprüft. Gilt für alle Läufe.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Art</translation>
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
        <source>Make a step and record it</source>
        <translation>Einen Sprung machen und aufzeichnen</translation>
    </message>
    <message>
        <source>A step is being made already.</source>
        <translation>Es läuft bereits ein Sprung.</translation>
    </message>
    <message>
        <source>The motor jumps by this distance, and holds there. Everything that turns with it must be free to (Shift+F9).</source>
        <translation>Der Motor springt um diese Strecke und hält dort. Alles, was sich mitdreht, muss frei beweglich sein (Umschalt+F9).</translation>
    </message>
    <message>
        <source>%1 %2 instead of %3</source>
        <translation>%1 %2 statt %3</translation>
    </message>
    <message>
        <source>Some gains in the fields were not sent: %1. With which is the step to be made?</source>
        <translation>Einige Reglerwerte in den Feldern wurden nicht gesendet: %1. Mit welchen soll der Sprung gemacht werden?</translation>
    </message>
    <message>
        <source>Gains that were not sent</source>
        <translation>Nicht gesendete Reglerwerte</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Apply them and step</source>
        <translation>&amp;Anwenden und springen</translation>
    </message>
    <message>
        <source>Step with those that it &amp;has</source>
        <translation>&amp;Mit denen des Moduls springen</translation>
    </message>
</context>
<context>
    <name>nmc::StepHoldBox</name>
    <message>
        <source>Speed whe&amp;n held</source>
        <translation>Tippges&amp;chwindigkeit</translation>
    </message>
    <message>
        <source>Speed while held</source>
        <translation>Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>The speed while held</source>
        <translation>Die Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>◂ Hold</source>
        <translation>◂ Tippen</translation>
    </message>
    <message>
        <source>Move in reverse while held</source>
        <translation>Rückwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Hold ▸</source>
        <translation>Tippen ▸</translation>
    </message>
    <message>
        <source>Move forward while held</source>
        <translation>Vorwärts fahren, solange gedrückt</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>moves only while a button, or Space on it, is held</source>
        <translation>bewegt nur, solange eine Taste, oder die Leertaste auf ihr, gedrückt ist</translation>
    </message>
    <message>
        <source>How fast the motor turns while a button is held: %1 to %2. The most is set on the Parameters page.</source>
        <translation>Wie schnell sich der Motor dreht, solange eine Taste gehalten wird: %1 bis %2. Das Höchste wird auf der Seite Parameter eingestellt.</translation>
    </message>
    <message>
        <source>Moves forward while it is held, then stops.</source>
        <translation>Fährt vorwärts, solange sie gedrückt ist, und stoppt dann.</translation>
    </message>
    <message>
        <source>Moves in reverse while it is held, then stops.</source>
        <translation>Fährt rückwärts, solange sie gedrückt ist, und stoppt dann.</translation>
    </message>
</context>
<context>
    <name>nmc::StepIoBox</name>
    <message>
        <source>Set all outputs</source>
        <translation>Alle Ausgänge setzen</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Eingänge und Ausgänge</translation>
    </message>
    <message>
        <source>Set all five outputs</source>
        <translation>Alle fünf Ausgänge setzen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What it is on this machine. Sends nothing.</source>
        <translation>Was es an dieser Maschine ist. Sendet nichts.</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>Output %1</source>
        <translation>Ausgang %1</translation>
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
        <source>E-stop input</source>
        <translation>E-Stop-Eingang</translation>
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
        <source>Home switch</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>Name of input %1</source>
        <translation>Name von Eingang %1</translation>
    </message>
    <message>
        <source>A/D (temperature)</source>
        <translation>A/D (Temperatur)</translation>
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
        <source>high</source>
        <translation>High</translation>
    </message>
    <message>
        <source>low</source>
        <translation>Low</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
    <message>
        <source>● %1, not sent</source>
        <translation>● %1, nicht gesendet</translation>
    </message>
    <message>
        <source>Switches this output at once.</source>
        <translation>Schaltet diesen Ausgang sofort.</translation>
    </message>
    <message>
        <source>Chooses what it shall be. Set all outputs sends the five of them.</source>
        <translation>Wählt, was er werden soll. „Alle Ausgänge setzen“ sendet alle fünf.</translation>
    </message>
    <message>
        <source>Choose all five outputs first.</source>
        <translation>Zuerst alle fünf Ausgänge wählen.</translation>
    </message>
    <message>
        <source>Sends all five outputs as chosen above.</source>
        <translation>Sendet alle fünf Ausgänge wie oben gewählt.</translation>
    </message>
    <message>
        <source>The outputs are unknown: the module cannot be asked. Choose all five, then set them.</source>
        <translation>Die Ausgänge sind unbekannt: das Modul lässt sich nicht danach fragen. Alle fünf wählen, dann setzen.</translation>
    </message>
</context>
<context>
    <name>nmc::StepModeChoice</name>
    <message>
        <source>Move</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>Goes to a position: speeds up, runs, slows down and stops there (trapezoidal profile mode).</source>
        <translation>Fährt zu einer Position: beschleunigt, läuft, bremst und stoppt dort (Trapezprofil).</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Dauerlauf</translation>
    </message>
    <message>
        <source>Ramps to a speed and keeps it until it is stopped (velocity profile mode).</source>
        <translation>Fährt über eine Rampe auf eine Geschwindigkeit und behält sie bis zum Stopp (Geschwindigkeitsprofil).</translation>
    </message>
    <message>
        <source>Move without ramp</source>
        <translation>Fahrt ohne Rampe</translation>
    </message>
    <message>
        <source>Goes to a position at one speed from the first step on, and stops there at once. Too fast, and the motor loses steps (unprofiled, with stop).</source>
        <translation>Fährt vom ersten Schritt an mit einer einzigen Geschwindigkeit zu einer Position und stoppt dort sofort. Ist sie zu hoch, verliert der Motor Schritte (ohne Profil, mit Stopp).</translation>
    </message>
    <message>
        <source>Run without ramp</source>
        <translation>Dauerlauf ohne Rampe</translation>
    </message>
    <message>
        <source>Runs at one speed from the first step on until it is stopped. Too fast, and the motor loses steps (unprofiled, without stop).</source>
        <translation>Läuft vom ersten Schritt an mit einer einzigen Geschwindigkeit bis zum Stopp. Ist sie zu hoch, verliert der Motor Schritte (ohne Profil, ohne Stopp).</translation>
    </message>
    <message>
        <source>How to move</source>
        <translation>Art der Bewegung</translation>
    </message>
</context>
<context>
    <name>nmc::StepMotionBox</name>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
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
        <source>b&amp;y that much from here</source>
        <translation>&amp;um so viel von hier aus</translation>
    </message>
    <message>
        <source>Move by that much from where the motor stands</source>
        <translation>Um so viel von dort, wo der Motor steht</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
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
        <source>Run in reverse until stopped</source>
        <translation>Dauerlauf rückwärts bis zum Stopp</translation>
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
        <source>L&amp;oad only</source>
        <translation>Nur &amp;laden</translation>
    </message>
    <message>
        <source>Load the motion, start it later</source>
        <translation>Die Bewegung laden, später starten</translation>
    </message>
    <message>
        <source>Start loaded</source>
        <translation>Geladenes starten</translation>
    </message>
    <message>
        <source>Start the motion that was loaded</source>
        <translation>Die geladene Bewegung starten</translation>
    </message>
    <message>
        <source>How fast the motor turns: %1 to %2 in this speed mode. The chip takes the nearest that it can do.</source>
        <translation>Wie schnell sich der Motor dreht: %1 bis %2 in diesem Geschwindigkeitsmodus. Der Chip nimmt den nächstliegenden Wert, den er kann.</translation>
    </message>
    <message>
        <source>At that speed from the first step on.</source>
        <translation>Vom ersten Schritt an mit dieser Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Gets there in %1 s from standstill.</source>
        <translation>Ist aus dem Stillstand in %1 s dort.</translation>
    </message>
    <message>
        <source>Stop, wait: %1</source>
        <translation>Stopp, warten: %1</translation>
    </message>
    <message>
        <source>Sends the motion without starting it.</source>
        <translation>Sendet die Bewegung, ohne sie zu starten.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Starts the move to the position, and holds there.</source>
        <translation>Startet die Fahrt zur Position und hält dort.</translation>
    </message>
    <message>
        <source>Load &amp;reverse</source>
        <translation>Rüc&amp;kwärts laden</translation>
    </message>
    <message>
        <source>Runs in reverse until it is stopped.</source>
        <translation>Läuft rückwärts bis zum Stopp.</translation>
    </message>
    <message>
        <source>Load forward</source>
        <translation>Vorwärts laden</translation>
    </message>
    <message>
        <source>Runs forward until it is stopped.</source>
        <translation>Läuft vorwärts bis zum Stopp.</translation>
    </message>
    <message>
        <source>Starts the motion that was loaded last.</source>
        <translation>Startet die zuletzt geladene Bewegung.</translation>
    </message>
    <message>
        <source>A run has no goal.</source>
        <translation>Ein Dauerlauf hat kein Ziel.</translation>
    </message>
    <message>
        <source>Where to go. Enter starts the move.</source>
        <translation>Wohin gefahren wird. Eingabe startet die Fahrt.</translation>
    </message>
    <message>
        <source>The position counts from where the motor stands at the start.</source>
        <translation>Die Position zählt von dort, wo der Motor beim Start steht.</translation>
    </message>
    <message>
        <source>The buttons send the motion without starting it; Start loaded does, or its group.</source>
        <translation>Die Tasten senden die Bewegung, ohne sie zu starten; das tut „Geladenes starten“ oder die Gruppe.</translation>
    </message>
    <message>
        <source>No ramp.</source>
        <translation>Keine Rampe.</translation>
    </message>
    <message>
        <source>Stops smoothly, waits until the motor stands, then: %1</source>
        <translation>Stoppt sanft, wartet, bis der Motor steht, dann: %1</translation>
    </message>
    <message>
        <source>Take the nearest</source>
        <translation>Nächste nehmen</translation>
    </message>
    <message>
        <source>Put the nearest position that is allowed into the goal</source>
        <translation>Die nächste erlaubte Position als Ziel eintragen</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>%1 nehmen</translation>
    </message>
    <message>
        <source>Puts the nearest position that is allowed into the goal. Nothing moves.</source>
        <translation>Trägt die nächste erlaubte Position als Ziel ein. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Zur Referenz</translation>
    </message>
    <message>
        <source>Go to the home position</source>
        <translation>Die Referenzposition anfahren</translation>
    </message>
    <message>
        <source>Goes to home with a ramp, at the speed of moves to a position.</source>
        <translation>Fährt mit Rampe zur Referenz, mit der Geschwindigkeit der Fahrten zu einer Position.</translation>
    </message>
</context>
<context>
    <name>nmc::StepPanel</name>
    <message>
        <source>Stepper module</source>
        <translation>Schrittmotormodul</translation>
    </message>
    <message>
        <source>Pages of the module</source>
        <translation>Seiten des Moduls</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/A</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenzsuche</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
</context>
<context>
    <name>nmc::StepParametersBox</name>
    <message>
        <source>ignored: they stop nothing</source>
        <translation>ignoriert: sie stoppen nichts</translation>
    </message>
    <message>
        <source>ignored: it stops nothing</source>
        <translation>ignoriert: er stoppt nichts</translation>
    </message>
    <message>
        <source>the motor goes off as well</source>
        <translation>der Motor wird auch abgeschaltet</translation>
    </message>
    <message>
        <source>Start&amp;ing values</source>
        <translation>Sta&amp;rtwerte</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Apply parameters</source>
        <translation>Alle an&amp;wenden</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Fill in starting values</source>
        <translation>Startwerte eintragen</translation>
    </message>
    <message>
        <source>Revert the parameters to what was sent</source>
        <translation>Parameter auf die gesendeten zurücksetzen</translation>
    </message>
    <message>
        <source>Apply all parameters</source>
        <translation>Alle Parameter anwenden</translation>
    </message>
    <message>
        <source>Fills the fields with slow speeds and low currents to begin with. Sends nothing.</source>
        <translation>Füllt die Felder mit kleinen Geschwindigkeiten und Strömen für den Anfang. Sendet nichts.</translation>
    </message>
    <message>
        <source>Choose a speed mode.</source>
        <translation>Einen Geschwindigkeitsmodus wählen.</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
    <message>
        <source>● edited, not sent</source>
        <translation>● nicht gesendet</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ gesendet</translation>
    </message>
    <message>
        <source>Parameters cannot be read back from the module, and nothing moves before they are applied.</source>
        <translation>Parameter sind aus dem Modul nicht lesbar, und vor dem Anwenden bewegt sich nichts.</translation>
    </message>
    <message>
        <source>With this the module&apos;s E-stop input does not stop the motor.</source>
        <translation>Damit stoppt der E-Stop-Eingang des Moduls den Motor nicht.</translation>
    </message>
    <message>
        <source>With this the limit switches do not stop the motor.</source>
        <translation>Damit stoppen die Endschalter den Motor nicht.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The amplifier is on: currents and limits act immediately.</source>
        <translation>Sendet alle Parameter auf einmal. Der Verstärker ist ein: Ströme und Grenzen wirken sofort.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The motor does not move.</source>
        <translation>Sendet alle Parameter auf einmal. Der Motor bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Nothing was edited.</source>
        <translation>Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Back to the parameters that were sent. Sends nothing.</source>
        <translation>Zurück zu den gesendeten Parametern. Sendet nichts.</translation>
    </message>
    <message>
        <source>Empties the fields: no parameters have been sent yet. Sends nothing.</source>
        <translation>Leert die Felder: es wurden noch keine Parameter gesendet. Sendet nichts.</translation>
    </message>
</context>
<context>
    <name>nmc::StepPlot</name>
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
        <source>No run is shown. A step shows how the motor follows when its command jumps.</source>
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
        <source>Positions since the step, counted from where it began. The shaded band is the settling band around the goal. A double click shows the whole record, or only as long as it moves. The wheel zooms (with Ctrl the positions), a drag moves, a drag with Shift chooses a time.</source>
        <translation>Positionen seit dem Sprung, gezählt von dort, wo er begann. Das schattierte Band ist das Einschwingband um das Ziel. Ein Doppelklick zeigt die ganze Aufzeichnung oder nur die Zeit der Bewegung. Das Mausrad zoomt (mit Strg die Positionen), Ziehen verschiebt, Ziehen mit Umschalt wählt eine Zeit.</translation>
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
        <source> (%1 Hz)</source>
        <translation> (%1 Hz)</translation>
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
</context>
<context>
    <name>nmc::StepRampBox</name>
    <message>
        <source>Acceleration time</source>
        <translation>Beschleunigungszeit</translation>
    </message>
    <message>
        <source>The acceleration time</source>
        <translation>Die Beschleunigungszeit</translation>
    </message>
    <message>
        <source>How long a ramp stays at each speed, in 0.25 ms: the smaller, the steeper. Sent with the next motion that has a ramp, and used by a smooth stop after it.</source>
        <translation>Wie lange eine Rampe bei jeder Geschwindigkeit bleibt, in 0,25 ms: je kleiner, desto steiler. Wird mit der nächsten Bewegung mit Rampe gesendet und gilt für einen sanften Stopp danach.</translation>
    </message>
    <message>
        <source>Fastest speed of hold to move</source>
        <translation>Höchste Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>The fastest speed of hold to move</source>
        <translation>Die höchste Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>Hold to move goes no faster than this. Set it so that a hand can still follow.</source>
        <translation>Der Tippbetrieb wird nicht schneller als dies. So einstellen, dass eine Hand noch folgen kann.</translation>
    </message>
    <message>
        <source>With every motion</source>
        <translation>Mit jeder Bewegung</translation>
    </message>
    <message>
        <source>Hold to move, at most</source>
        <translation>Tippbetrieb, höchstens</translation>
    </message>
    <message>
        <source>× 0.25 ms</source>
        <translation>× 0,25 ms</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? unbekannt</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ gesendet</translation>
    </message>
    <message>
        <source>● edited, not sent</source>
        <translation>● nicht gesendet</translation>
    </message>
</context>
<context>
    <name>nmc::StepResponsePage</name>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>Werte übernehmen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>Choose a run in the list first.</source>
        <translation>Zuerst einen Lauf in der Liste wählen.</translation>
    </message>
    <message>
        <source>This run is of %1. Select that module first.</source>
        <translation>Dieser Lauf ist von %1. Zuerst dieses Modul wählen.</translation>
    </message>
    <message>
        <source>Puts the gains of this run into the fields of the Gains page. Sends nothing (Ctrl+Shift+U).</source>
        <translation>Trägt die Reglerwerte dieses Laufs in die Felder der Seite Reglerwerte ein. Sendet nichts (Strg+Umschalt+U).</translation>
    </message>
    <message>
        <source>Takes this run off the list (Ctrl+Del).</source>
        <translation>Nimmt diesen Lauf aus der Liste (Strg+Entf).</translation>
    </message>
    <message>
        <source>There is no run yet.</source>
        <translation>Es gibt noch keinen Lauf.</translation>
    </message>
    <message>
        <source>Saves all runs of the list, with their gains and results (Ctrl+Shift+X).</source>
        <translation>Speichert alle Läufe der Liste mit ihren Reglerwerten und Ergebnissen (Strg+Umschalt+X).</translation>
    </message>
    <message>
        <source>Export step responses</source>
        <translation>Sprungantworten exportieren</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>What the steps tell</source>
        <translation>Was die Sprünge sagen</translation>
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
        <source>Draws the other runs of this module as well, the older the paler.</source>
        <translation>Zeichnet auch die anderen Läufe dieses Moduls, ältere blasser.</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>No run was removed.</source>
        <translation>Es wurde kein Lauf entfernt.</translation>
    </message>
    <message>
        <source>Brings the run back that was removed last (Ctrl+Shift+Del).</source>
        <translation>Holt den zuletzt entfernten Lauf zurück (Strg+Umschalt+Entf).</translation>
    </message>
</context>
<context>
    <name>nmc::StepResults</name>
    <message>
        <source>What the runs that are shown come to</source>
        <translation>Was die gezeigten Läufe ergeben</translation>
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
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Anstieg, 10 bis 90 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
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
        <source>How far it went beyond its goal, in % of the step.</source>
        <translation>Wie weit es über das Ziel hinausging, in % des Sprungs.</translation>
    </message>
    <message>
        <source>Goal less the mean position of the last fifth of the record.</source>
        <translation>Ziel minus mittlere Position im letzten Fünftel der Aufzeichnung.</translation>
    </message>
    <message>
        <source>What the servo asks of the amplifier when the command jumps, from the gains. A later tick may ask for more, so below the output limit OL it is only a lower bound.</source>
        <translation>Was der Servo vom Verstärker verlangt, wenn die Sollposition springt, aus den Reglerwerten. Ein späterer Takt kann mehr verlangen; unter der Ausgangsgrenze OL ist es daher nur eine untere Schranke.</translation>
    </message>
    <message>
        <source>The mean time between two positions of the record. The doubts come from it.</source>
        <translation>Die mittlere Zeit zwischen zwei Positionen der Aufzeichnung. Aus ihr ergeben sich die Unsicherheiten.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Settling to the goal</source>
        <translation>Einschwingen aufs Ziel</translation>
    </message>
    <message>
        <source>Settling where it stays</source>
        <translation>Einschwingen zur Ruhe</translation>
    </message>
    <message>
        <source>Time until it stays within the settling band around the goal. Nothing if that is not before the last fifth of the record.</source>
        <translation>Zeit, bis er im Einschwingband um das Ziel bleibt. Nichts, wenn das nicht vor dem letzten Fünftel der Aufzeichnung ist.</translation>
    </message>
    <message>
        <source>The same around the mean position of the last fifth of the record. Friction holds a motor beside its goal unless there is an integral (Ki, IL).</source>
        <translation>Dasselbe um die mittlere Position des letzten Fünftels der Aufzeichnung. Reibung hält einen Motor neben seinem Ziel, wenn es keinen Integralanteil (Ki, IL) gibt.</translation>
    </message>
</context>
<context>
    <name>nmc::StepRunTable</name>
    <message>
        <source>Step responses so far</source>
        <translation>Bisherige Sprungantworten</translation>
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
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
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
        <source>The step responses so far, newest first. Tick two of them to compare their curves. The last %1 are kept with the machine, those with a name or a note longest.</source>
        <translation>Die bisherigen Sprungantworten, die neueste zuerst. Haken Sie zwei an, um ihre Kurven zu vergleichen. Die letzten %1 werden bei der Maschine aufbewahrt, am längsten die mit einem Namen oder einer Notiz.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>What the run is called. Double-click it, or press F2, to write.</source>
        <translation>Wie der Lauf heißt. Zum Schreiben doppelklicken oder F2 drücken.</translation>
    </message>
    <message>
        <source>What is to be known of the run. Double-click it, or press F2.</source>
        <translation>Was man von dem Lauf wissen sollte. Doppelklicken oder F2 drücken.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>nmc::StepView</name>
    <message>
        <source>What the cursors read</source>
        <translation>Was die Cursor anzeigen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
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
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>As long as the motor moves, and all positions (A, in the plot).</source>
        <translation>Solange der Motor sich bewegt, und alle Positionen (A, im Diagramm).</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Two cursors to measure with: drag them (C, in the plot).</source>
        <translation>Zwei Cursor zum Messen: ziehen Sie sie (C, im Diagramm).</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Bild (PNG)…</translation>
    </message>
    <message>
        <source>What is seen, as an image.</source>
        <translation>Das Sichtbare als Bild.</translation>
    </message>
    <message>
        <source>&amp;Vector picture (SVG)…</source>
        <translation>&amp;Vektorbild (SVG)…</translation>
    </message>
    <message>
        <source>What is seen, in lines that stay sharp at any size.</source>
        <translation>Das Sichtbare in Linien, die in jeder Größe scharf bleiben.</translation>
    </message>
    <message>
        <source>P&amp;age (PDF)…</source>
        <translation>&amp;Seite (PDF)…</translation>
    </message>
    <message>
        <source>What is seen, on a page for a printer or a report.</source>
        <translation>Das Sichtbare auf einer Seite für einen Drucker oder einen Bericht.</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>What is seen, onto the clipboard.</source>
        <translation>Das Sichtbare in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Takes what is seen out of the panel, with the runs in words.</source>
        <translation>Holt das Sichtbare aus dem Panel heraus, mit den Läufen in Worten.</translation>
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
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>P&amp;rint</source>
        <translation>&amp;Drucken</translation>
    </message>
    <message>
        <source>What is seen, on a page of the printer that this computer uses unless told otherwise.</source>
        <translation>Was zu sehen ist, auf einer Seite des Standarddruckers dieses Rechners.</translation>
    </message>
</context>
<context>
    <name>nmc::StopButton</name>
    <message>
        <source>STOP ALL  Esc</source>
        <translation>ALLES STOPP  Esc</translation>
    </message>
    <message>
        <source>Stop all motors, key Esc</source>
        <translation>Alle Motoren stoppen, Taste Esc</translation>
    </message>
    <message>
        <source>Stops every motor. No port is open.</source>
        <translation>Stoppt jeden Motor. Es ist kein Port offen.</translation>
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
    <message>
        <source>STOP ALL</source>
        <translation>ALLES STOPP</translation>
    </message>
    <message>
        <source>goes to all modules</source>
        <translation>geht an alle Module</translation>
    </message>
</context>
<context>
    <name>nmc::TestForm</name>
    <message>
        <source>End it</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>End the test</source>
        <translation>Prüfung beenden</translation>
    </message>
    <message>
        <source>How the test goes</source>
        <translation>Wie die Prüfung läuft</translation>
    </message>
    <message>
        <source>It runs already.</source>
        <translation>Sie läuft schon.</translation>
    </message>
    <message>
        <source>It does not run.</source>
        <translation>Sie läuft nicht.</translation>
    </message>
    <message>
        <source>The motor is held where it is.</source>
        <translation>Der Motor wird an seiner Position gehalten.</translation>
    </message>
</context>
<context>
    <name>nmc::TravelBox</name>
    <message>
        <source>Limits of travel and speed</source>
        <translation>Grenzen von Fahrweg und Geschwindigkeit</translation>
    </message>
    <message>
        <source>State of the limits of travel</source>
        <translation>Zustand der Fahrweggrenzen</translation>
    </message>
    <message>
        <source>Lowest position</source>
        <translation>Tiefste Position</translation>
    </message>
    <message>
        <source>Highest position</source>
        <translation>Höchste Position</translation>
    </message>
    <message>
        <source>The lowest position</source>
        <translation>Die tiefste Position</translation>
    </message>
    <message>
        <source>The highest position</source>
        <translation>Die höchste Position</translation>
    </message>
    <message>
        <source>Counted from home. No motion goes beyond it while home is known. Empty: no limit.</source>
        <translation>Ab der Referenz gezählt. Solange die Referenz bekannt ist, geht keine Bewegung darüber hinaus. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>Make the present position the lowest</source>
        <translation>Die jetzige Position zur tiefsten machen</translation>
    </message>
    <message>
        <source>Make the present position the highest</source>
        <translation>Die jetzige Position zur höchsten machen</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Höchste Geschwindigkeit</translation>
    </message>
    <message>
        <source>The highest velocity</source>
        <translation>Die höchste Geschwindigkeit</translation>
    </message>
    <message>
        <source>Nothing moves this axis faster: no move, run, step, jog or search for home. Empty: as fast as the module can.</source>
        <translation>Nichts bewegt diese Achse schneller: keine Fahrt, kein Lauf, kein Schritt, kein Tippen, keine Referenzsuche. Leer: so schnell das Modul kann.</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>The backlash</source>
        <translation>Das Spiel</translation>
    </message>
    <message>
        <source>Somewhat more than the play between motor and load. A move from the wrong side then goes beyond its goal by as much first, and comes back. Empty: none.</source>
        <translation>Etwas mehr als das Spiel zwischen Motor und Last. Eine Fahrt von der falschen Seite geht dann zuerst um so viel über ihr Ziel hinaus und kommt zurück. Leer: keines.</translation>
    </message>
    <message>
        <source>Side from which every goal is come to</source>
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
        <source>Go to, Go home and Step come to their goal from this side. A loaded move goes straight.</source>
        <translation>Fahrt, Referenzfahrt und Schritt kommen von dieser Seite an ihr Ziel. Eine geladene Fahrt geht geradewegs.</translation>
    </message>
    <message>
        <source>Declare position right…</source>
        <translation>Position für richtig erklären…</translation>
    </message>
    <message>
        <source>Declare that the position is right</source>
        <translation>Die Position für richtig erklären</translation>
    </message>
    <message>
        <source>Position in doubt</source>
        <translation>Position zweifelhaft</translation>
    </message>
    <message>
        <source>Say that the position may be wrong</source>
        <translation>Angeben, dass die Position falsch sein kann</translation>
    </message>
    <message>
        <source>Declare the position right</source>
        <translation>Die Position für richtig erklären</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>It &amp;is right</source>
        <translation>Sie &amp;stimmt</translation>
    </message>
    <message>
        <source>The lowest position has to be below the highest. What was set before stays.</source>
        <translation>Die tiefste Position muss unter der höchsten liegen. Was vorher gesetzt war, bleibt.</translation>
    </message>
    <message>
        <source>The axis goes no lower than where it is now.</source>
        <translation>Die Achse fährt nicht tiefer, als sie jetzt steht.</translation>
    </message>
    <message>
        <source>The axis goes no higher than where it is now.</source>
        <translation>Die Achse fährt nicht höher, als sie jetzt steht.</translation>
    </message>
    <message>
        <source>Takes your word that the position is right: home is where it is 0. Asks first.</source>
        <translation>Nimmt Ihr Wort dafür, dass die Position stimmt: Die Referenz liegt, wo sie 0 ist. Fragt zuerst.</translation>
    </message>
    <message>
        <source>Home is not known any more, and the limits of travel are not in force until it is.</source>
        <translation>Die Referenz ist dann nicht mehr bekannt, und die Fahrweggrenzen gelten erst wieder, wenn sie es ist.</translation>
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
        <source>What it has to do.</source>
        <translation>Was es tun muss.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Where it has to do that.</source>
        <translation>Wo es das tun muss.</translation>
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
        <source>How much of the picture is from before the trigger, in percent.</source>
        <translation>Wie viel des Bildes aus der Zeit vor dem Trigger ist, in Prozent.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
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
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <source>No module is there.</source>
        <translation>Kein Modul ist da.</translation>
    </message>
    <message>
        <source>Choose a mode first.</source>
        <translation>Zuerst einen Modus wählen.</translation>
    </message>
    <message>
        <source>Waits for the next trigger from now on.</source>
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
    <name>nmc::UnitDialog</name>
    <message>
        <source>Work out the unit</source>
        <translation>Einheit berechnen</translation>
    </message>
    <message>
        <source>What the axis does</source>
        <translation>Was die Achse tut</translation>
    </message>
    <message>
        <source>turns, in turns</source>
        <translation>dreht sich, in Umdrehungen</translation>
    </message>
    <message>
        <source>turns, in degrees</source>
        <translation>dreht sich, in Grad</translation>
    </message>
    <message>
        <source>moves along a line, in millimetres</source>
        <translation>fährt geradeaus, in Millimetern</translation>
    </message>
    <message>
        <source>What you want to read this axis in.</source>
        <translation>Worin diese Achse abgelesen werden soll.</translation>
    </message>
    <message>
        <source>The axis</source>
        <translation>Die Achse</translation>
    </message>
    <message>
        <source>Full steps of the motor for one turn</source>
        <translation>Vollschritte des Motors je Umdrehung</translation>
    </message>
    <message>
        <source>200 for a motor with 1.8 degrees a step.</source>
        <translation>200 bei einem Motor mit 1,8 Grad je Schritt.</translation>
    </message>
    <message>
        <source>Microsteps for each full step</source>
        <translation>Mikroschritte je Vollschritt</translation>
    </message>
    <message>
        <source>As the driver is set; 1 for none, 2 for half steps.</source>
        <translation>Wie am Treiber eingestellt; 1 für keine, 2 für Halbschritte.</translation>
    </message>
    <message>
        <source>Lines of the encoder for one turn</source>
        <translation>Striche des Encoders je Umdrehung</translation>
    </message>
    <message>
        <source>As its label says: lines, CPR or PPR. The chip counts four for each line.</source>
        <translation>Wie auf seinem Typenschild: Striche, CPR oder PPR. Der Chip zählt vier je Strich.</translation>
    </message>
    <message>
        <source>Gear: turns of the motor</source>
        <translation>Getriebe: Umdrehungen des Motors</translation>
    </message>
    <message>
        <source>For a gear of 50 : 1 enter 50 here; without a gear 1.</source>
        <translation>Bei einem Getriebe 50 : 1 hier 50 eingeben; ohne Getriebe 1.</translation>
    </message>
    <message>
        <source>Gear: make turns of the output</source>
        <translation>Getriebe: ergeben Umdrehungen am Abtrieb</translation>
    </message>
    <message>
        <source>For a gear of 50 : 1 enter 1 here.</source>
        <translation>Bei einem Getriebe 50 : 1 hier 1 eingeben.</translation>
    </message>
    <message>
        <source>Travel for one turn of the output (mm)</source>
        <translation>Weg je Umdrehung am Abtrieb (mm)</translation>
    </message>
    <message>
        <source>Lead screw: its pitch times its starts. Belt: teeth of the pulley times the pitch of the belt. Rack: teeth of the pinion times the pitch of the rack.</source>
        <translation>Spindel: Steigung mal Gangzahl. Riemen: Zähne der Scheibe mal Teilung des Riemens. Zahnstange: Zähne des Ritzels mal Teilung der Zahnstange.</translation>
    </message>
    <message>
        <source>The unit that follows</source>
        <translation>Die Einheit, die sich ergibt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
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
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Inkremente</translation>
    </message>
    <message>
        <source>1 %1 is %2 %3. The smallest step is %4 %1.</source>
        <translation>1 %1 sind %2 %3. Der kleinste Schritt ist %4 %1.</translation>
    </message>
    <message>
        <source>Takes it as the unit of this axis. Keeps every amount, and sends nothing.</source>
        <translation>Übernimmt sie als Einheit dieser Achse. Behält jeden Betrag und sendet nichts.</translation>
    </message>
</context>
</TS>
