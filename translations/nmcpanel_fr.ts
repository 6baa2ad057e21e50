<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>CommandLine</name>
    <message>
        <source>Control panel for Networked Modular Control motor modules.</source>
        <translation>Programme de commande pour modules moteurs NMC (Networked Modular Control).</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NOM</translation>
    </message>
    <message>
        <source>Baud rate of the chain: 9600, 19200 (default), 57600 or 115200.</source>
        <translation>Débit de la chaîne&#xa0;: 9600, 19200 (par défaut), 57600 ou 115200.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Connect to the built-in simulator at startup. CHAIN lists its modules, the one farthest from the host first; the default is %1.</source>
        <translation>Se connecter au simulateur intégré au démarrage. CHAÎNE énumère ses modules, en commençant par le plus éloigné de l’ordinateur&#x202f;; par défaut&#xa0;: %1.</translation>
    </message>
    <message>
        <source>CHAIN</source>
        <translation>CHAÎNE</translation>
    </message>
    <message>
        <source>List the serial ports of this computer.</source>
        <translation>Énumérer les ports série de cet ordinateur.</translation>
    </message>
    <message>
        <source>Show this help.</source>
        <translation>Afficher cette aide.</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>Afficher la version.</translation>
    </message>
    <message>
        <source>Allow control lines to inject faults into the built-in simulator.</source>
        <translation>Autoriser les commandes nmcsim à injecter des défauts dans le simulateur intégré.</translation>
    </message>
    <message>
        <source>With --port or --simulator: connect read-only. Only status requests are sent, and closing does not stop motors. STOP ALL still works.</source>
        <translation>Avec --port ou --simulator&#xa0;: se connecter en lecture seule. Seules des demandes d’état sont envoyées, et la fermeture n’arrête pas les moteurs. TOUT ARRÊTER fonctionne toujours.</translation>
    </message>
    <message>
        <source>Machine file to open at startup.</source>
        <translation>Fichier machine à ouvrir au démarrage.</translation>
    </message>
    <message>
        <source>Let other programs in from the start. With =control, one of them may move motors without the user being asked.</source>
        <translation>Laisser entrer d’autres programmes dès le démarrage. Avec =control, l’un d’eux peut déplacer les moteurs sans demander.</translation>
    </message>
    <message>
        <source>Connect to a serial port at startup, or to one at a device server: tcp://HOST:PORT or rfc2217://HOST:PORT.</source>
        <translation>Se connecter au démarrage à un port série, ou à celui d’un serveur de périphériques&#xa0;: tcp://HOST:PORT ou rfc2217://HOST:PORT.</translation>
    </message>
</context>
<context>
    <name>Common</name>
    <message>
        <source>%1 of %2 modules answered.</source>
        <translation>Modules ayant répondu&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Groupe %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Débit (bauds)</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>Points et séquences</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Travel and speed limits</source>
        <translation>Limites de course et de vitesse</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Jeu mécanique</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Prise d’origine</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>Arrêt sur fin de course</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>Temps d’accélération</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Gains</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Comment</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Home all</source>
        <translation>Prendre les origines</translation>
    </message>
    <message>
        <source>limit 1</source>
        <translation>fin de course 1</translation>
    </message>
    <message>
        <source>limit 2</source>
        <translation>fin de course 2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>STOP ALL</source>
        <translation>TOUT ARRÊTER</translation>
    </message>
    <message>
        <source>Motor off</source>
        <translation>Couper le moteur</translation>
    </message>
    <message>
        <source>Connect fully</source>
        <translation>Connexion complète</translation>
    </message>
    <message>
        <source>steps/s</source>
        <translation>pas/s</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>tours</translation>
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
        <translation>Erreur de position</translation>
    </message>
    <message>
        <source>E-stop input</source>
        <translation>Entrée E-Stop</translation>
    </message>
    <message>
        <source>The motor holds its position.</source>
        <translation>Le moteur maintient sa position.</translation>
    </message>
    <message>
        <source>The motor follows the points of a path.</source>
        <translation>Le moteur suit les points d’une trajectoire.</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>Simulateur</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>pas</translation>
    </message>
    <message>
        <source>No module</source>
        <translation>Aucun module</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>◂ Hold</source>
        <translation>◂ Jog</translation>
    </message>
    <message>
        <source>Hold ▸</source>
        <translation>Jog ▸</translation>
    </message>
    <message>
        <source>◂| Step</source>
        <translation>◂| Pas</translation>
    </message>
    <message>
        <source>Step |▸</source>
        <translation>Pas |▸</translation>
    </message>
    <message>
        <source>Moves forward while held, then stops.</source>
        <translation>Se déplace en avant tant que le bouton est maintenu, puis s’arrête.</translation>
    </message>
    <message>
        <source>Moves in reverse while held, then stops.</source>
        <translation>Se déplace en arrière tant que le bouton est maintenu, puis s’arrête.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Chaîne</translation>
    </message>
    <message>
        <source>&amp;Scan again</source>
        <translation>Re&amp;lancer la recherche</translation>
    </message>
    <message>
        <source>Resets every module and assigns new addresses. Asks first.</source>
        <translation>Réinitialise chaque module et attribue de nouvelles adresses. Demande d’abord confirmation.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
    <message>
        <source>Open machine</source>
        <translation>Ouvrir une machine</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>ended at %1</source>
        <translation>terminé à %1</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Tous les types</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>Tous les modules</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>Vitesse de jog max.</translation>
    </message>
    <message>
        <source>The value at an A/D reading of 0.</source>
        <translation>Valeur pour une lecture A/D de 0.</translation>
    </message>
    <message>
        <source>The module received a garbled command and did not carry it out.</source>
        <translation>Le module a reçu une commande altérée et ne l’a pas exécutée.</translation>
    </message>
    <message>
        <source>Limit switch 1.</source>
        <translation>Fin de course 1.</translation>
    </message>
    <message>
        <source>Limit switch 2.</source>
        <translation>Fin de course 2.</translation>
    </message>
    <message>
        <source>Waiting for the home position.</source>
        <translation>En attente de la position d’origine.</translation>
    </message>
    <message>
        <source>Save as home</source>
        <translation>Enregistrer comme origine</translation>
    </message>
    <message>
        <source>Save as home: the present position</source>
        <translation>Enregistrer comme origine&#xa0;: la position actuelle</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Octet d’état</translation>
    </message>
    <message>
        <source>Home register</source>
        <translation>Registre d’origine</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Données brutes</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>état %1</translation>
    </message>
    <message>
        <source>Saves the present position as home. The motor does not move.</source>
        <translation>Enregistre la position actuelle comme origine. Le moteur ne bouge pas.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>actif</translation>
    </message>
    <message>
        <source>off</source>
        <translation>inactif</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>Trajectoire rapide</translation>
    </message>
    <message>
        <source>Amplifier</source>
        <translation>Amplificateur</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>PWM value</source>
        <translation>Valeur PWM</translation>
    </message>
    <message>
        <source>Abruptly</source>
        <translation>Brutal</translation>
    </message>
    <message>
        <source>Smoothly</source>
        <translation>Progressif</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Limite de courant</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Jog</translation>
    </message>
    <message>
        <source>Start&amp;ing values</source>
        <translation>Vale&amp;urs de départ</translation>
    </message>
    <message>
        <source>Starting values: fill in</source>
        <translation>Valeurs de départ&#xa0;: remplir</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1&#xa0;Hz</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>State of the selected module</source>
        <translation>État du module sélectionné</translation>
    </message>
    <message>
        <source>%1, address %2</source>
        <translation>%1, adresse %2</translation>
    </message>
    <message>
        <source>Pages of the module</source>
        <translation>Pages du module</translation>
    </message>
    <message>
        <source>A/D and PWM</source>
        <translation>A/D et PWM</translation>
    </message>
    <message>
        <source>A/D input</source>
        <translation>Entrée A/D</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Nom de %1</translation>
    </message>
    <message>
        <source>Off at stop</source>
        <translation>Coupée sur arrêt</translation>
    </message>
    <message>
        <source>%1 of 255</source>
        <translation>%1 sur 255</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? inconnu</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Broches</translation>
    </message>
    <message>
        <source>input</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>high</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>low</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>Switches this output at once.</source>
        <translation>Commute aussitôt cette sortie.</translation>
    </message>
    <message>
        <source>A search for home is running.</source>
        <translation>Une recherche d’origine est en cours.</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>Capteur d’origine</translation>
    </message>
    <message>
        <source>Limit 1</source>
        <translation>Fin de course 1</translation>
    </message>
    <message>
        <source>Limit 2</source>
        <translation>Fin de course 2</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Durée limite</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Alimentation moteur</translation>
    </message>
    <message>
        <source>A/D</source>
        <translation>A/D</translation>
    </message>
    <message>
        <source>Goal position</source>
        <translation>Position cible</translation>
    </message>
    <message>
        <source>The goal position</source>
        <translation>La position cible</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>Use nearest</source>
        <translation>Au plus proche</translation>
    </message>
    <message>
        <source>Use nearest allowed position</source>
        <translation>Au plus proche&#xa0;: la position autorisée la plus proche</translation>
    </message>
    <message>
        <source>Zero here: set the present position to 0</source>
        <translation>Zéro ici&#xa0;: mettre à 0 la position actuelle</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Aller à l’origine</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charger</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Y aller</translation>
    </message>
    <message>
        <source>Go to the position</source>
        <translation>Y aller&#xa0;: à la position</translation>
    </message>
    <message>
        <source>Run &amp;reverse</source>
        <translation>Ma&amp;rche arrière</translation>
    </message>
    <message>
        <source>Run reverse until stopped</source>
        <translation>Marche arrière jusqu’à l’ordre d’arrêt</translation>
    </message>
    <message>
        <source>R&amp;un forward</source>
        <translation>Marc&amp;he avant</translation>
    </message>
    <message>
        <source>Run forward until stopped</source>
        <translation>Marche avant jusqu’à l’ordre d’arrêt</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>Sets the goal to the nearest allowed position. Nothing moves.</source>
        <translation>Prend comme cible la position autorisée la plus proche. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Moves to the position, then holds.</source>
        <translation>Se déplace à la position, puis la maintient.</translation>
    </message>
    <message>
        <source>Runs forward until stopped.</source>
        <translation>Tourne en avant jusqu’à l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped.</source>
        <translation>Tourne en arrière jusqu’à l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>Courant moteur</translation>
    </message>
    <message>
        <source>Motor off: this module</source>
        <translation>Couper le moteur&#xa0;: ce module</translation>
    </message>
    <message>
        <source>A/D %1</source>
        <translation>A/D %1</translation>
    </message>
    <message>
        <source>Switches servo and amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Coupe le servo et l’amplificateur&#xa0;: le moteur peut tourner librement, et une charge peut tomber.</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Expert</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>A/D (temperature)</source>
        <translation>A/D (température)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation>Rien à annuler.</translation>
    </message>
    <message>
        <source>Nothing to redo.</source>
        <translation>Rien à rétablir.</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Vitesse maximale</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Réponse en fréquence</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exporter en CSV…</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Square wave</source>
        <translation>Signal carré</translation>
    </message>
    <message>
        <source>Method: how the command jumps</source>
        <translation>Mode de saut de la consigne</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Rise %1</source>
        <translation>Montée %1</translation>
    </message>
    <message>
        <source>Overshoot %1</source>
        <translation>Dépassement %1</translation>
    </message>
    <message>
        <source>Steady-state error %1</source>
        <translation>Erreur statique %1</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Réponse indicielle</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
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
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Cursor readings</source>
        <translation>Mesures des curseurs</translation>
    </message>
    <message>
        <source>Cursor 1</source>
        <translation>Curseur 1</translation>
    </message>
    <message>
        <source>Cursor 2</source>
        <translation>Curseur 2</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Image (PNG)…</translation>
    </message>
    <message>
        <source>The visible plot as an image.</source>
        <translation>Le graphique visible sous forme d’image.</translation>
    </message>
    <message>
        <source>&amp;Vector picture (SVG)…</source>
        <translation>Image &amp;vectorielle (SVG)…</translation>
    </message>
    <message>
        <source>The visible plot as lines that stay sharp at any size.</source>
        <translation>Le graphique visible en traits qui restent nets à toute taille.</translation>
    </message>
    <message>
        <source>P&amp;age (PDF)…</source>
        <translation>P&amp;age (PDF)…</translation>
    </message>
    <message>
        <source>The visible plot on a page for printing or a report.</source>
        <translation>Le graphique visible sur une page à imprimer ou pour un rapport.</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>Imp&amp;rimer…</translation>
    </message>
    <message>
        <source>Prints the visible plot on one of this computer&apos;s printers.</source>
        <translation>Imprime le graphique visible sur l’une des imprimantes de cet ordinateur.</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copier l’image</translation>
    </message>
    <message>
        <source>SIMULATOR, no real motor moved</source>
        <translation>SIMULATEUR, aucun moteur réel n’a bougé</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Fichiers %1 (*.%2)</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Déclenchement</translation>
    </message>
    <message>
        <source>NMC Panel %1</source>
        <translation>NMC Panel %1</translation>
    </message>
    <message>
        <source>Overlay: %1</source>
        <translation>Superposé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Oscilloscope</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>sur 255</translation>
    </message>
    <message>
        <source>Opens the port and looks for modules. Nothing moves.</source>
        <translation>Ouvre le port et recherche les modules. Rien ne bouge.</translation>
    </message>
    <message>
        <source>goes to all modules</source>
        <translation>agit sur tous les modules</translation>
    </message>
    <message>
        <source>Operator mode</source>
        <translation>Mode opérateur</translation>
    </message>
    <message>
        <source>Asks for the PIN.</source>
        <translation>Demande le code PIN.</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>Work offsets</source>
        <translation>Décalages de travail</translation>
    </message>
    <message>
        <source>waits for the port</source>
        <translation>attend le port</translation>
    </message>
    <message>
        <source>A sequence is already running.</source>
        <translation>Une séquence est déjà en cours.</translation>
    </message>
    <message>
        <source>Its name on this machine. Sends nothing.</source>
        <translation>Son nom sur cette machine. N’envoie rien.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation>Autres programmes</translation>
    </message>
</context>
<context>
    <name>Gains</name>
    <message>
        <source>Position gain</source>
        <translation>Gain proportionnel</translation>
    </message>
    <message>
        <source>Derivative gain</source>
        <translation>Gain dérivé</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>Gain intégral</translation>
    </message>
    <message>
        <source>Integration limit</source>
        <translation>Limite d’intégration</translation>
    </message>
    <message>
        <source>Output limit</source>
        <translation>Limite de sortie</translation>
    </message>
    <message>
        <source>Position error limit</source>
        <translation>Limite d’erreur</translation>
    </message>
    <message>
        <source>Servo rate divisor</source>
        <translation>Diviseur de cadence</translation>
    </message>
    <message>
        <source>Deadband compensation</source>
        <translation>Zone morte</translation>
    </message>
    <message>
        <source>Kp, position gain: output per count of position error. Set Kd first; then raise Kp with small, fast test moves until the motor starts to overshoot, and back off a little.</source>
        <translation>Kp, gain proportionnel&#xa0;: sortie par incrément d’erreur de position. Réglez d’abord Kd&#x202f;; augmentez ensuite Kp avec de petits déplacements d’essai rapides jusqu’à ce qu’un dépassement apparaisse, puis réduisez un peu.</translation>
    </message>
    <message>
        <source>Kd, derivative gain: damping. Start here, with Kp and Ki at 0: raise Kd until the motor starts to hum, then back off a little.</source>
        <translation>Kd, gain dérivé&#xa0;: amortissement. Commencez ici, avec Kp et Ki à 0&#xa0;: augmentez Kd jusqu’à ce que le moteur commence à bourdonner, puis réduisez un peu.</translation>
    </message>
    <message>
        <source>Ki, integral gain: removes the steady-state error that Kp and Kd leave. Set IL to 16000 first, then raise Ki until the error settles fast enough. Adds some overshoot.</source>
        <translation>Ki, gain intégral&#xa0;: supprime l’erreur statique que laissent Kp et Kd. Réglez d’abord IL à 16000, puis augmentez Ki jusqu’à ce que l’erreur s’annule assez vite. Ajoute un peu de dépassement.</translation>
    </message>
    <message>
        <source>IL, integration limit: limits the integral of the error. Last, lower it to the smallest value that still removes the steady-state error. 0 clears the integral.</source>
        <translation>IL, limite d’intégration&#xa0;: limite l’intégrale de l’erreur. Pour finir, réduisez-la à la plus petite valeur qui supprime encore l’erreur statique. 0 annule l’intégrale.</translation>
    </message>
    <message>
        <source>OL, output limit: the largest PWM value; 255 is 100 %. Use 127 for a 12 V motor on a 24 V supply.</source>
        <translation>OL, limite de sortie&#xa0;: plus grande valeur PWM&#x202f;; 255 correspond à 100&#x202f;%. Utilisez 127 pour un moteur 12&#xa0;V alimenté en 24&#xa0;V.</translation>
    </message>
    <message>
        <source>CL, current limit, compared with the A/D value. 0: off. Odd: limits while the A/D value is above CL. Even: limits while it is below CL.</source>
        <translation>CL, limite de courant, comparée à la valeur A/D. 0&#xa0;: inactive. Impaire&#xa0;: limite tant que la valeur A/D est supérieure à CL. Paire&#xa0;: limite tant qu’elle est inférieure à CL.</translation>
    </message>
    <message>
        <source>EL, position error limit in counts: the servo switches off when the error exceeds it, for example after a collision or a stall.</source>
        <translation>EL, limite d’erreur de position en incréments&#xa0;: le servo se coupe quand l’erreur la dépasse, par exemple après une collision ou un blocage.</translation>
    </message>
    <message>
        <source>SR, servo rate divisor: one servo tick is SR × 0.512 ms. A slower rate damps heavy loads with less Kd. Changing SR changes the meaning of every velocity and acceleration.</source>
        <translation>SR, diviseur de cadence servo&#xa0;: un cycle servo dure SR x 0,512&#xa0;ms. Une cadence plus lente amortit les charges lourdes avec moins de Kd. Modifier SR change la signification de toutes les vitesses et accélérations.</translation>
    </message>
    <message>
        <source>DB, deadband compensation: added to every PWM value except 0, for amplifiers with a deadband near zero. Version 4 and later.</source>
        <translation>DB, compensation de zone morte&#xa0;: ajoutée à chaque valeur PWM sauf 0, pour les amplificateurs à zone morte autour de zéro. À partir de la version 4.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>A/D above</source>
        <translation>A/D au-dessus</translation>
    </message>
    <message>
        <source>A/D below</source>
        <translation>A/D au-dessous</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
</context>
<context>
    <name>LoopTestTexts</name>
    <message numerus="yes">
        <source>%n frequencies up to %1 Hz</source>
        <translation>
            <numerusform>%n fréquence jusqu’à %1&#xa0;Hz</numerusform>
            <numerusform>%n fréquences jusqu’à %1&#xa0;Hz</numerusform>
        </translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) %1 Hz</source>
        <translation>Bande passante (-3&#xa0;dB) %1&#xa0;Hz</translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) not reached</source>
        <translation>Bande passante (-3&#xa0;dB) non atteinte</translation>
    </message>
    <message>
        <source>Resonance %1 dB</source>
        <translation>Résonance %1&#xa0;dB</translation>
    </message>
    <message>
        <source>Phase margin %1° at %2 Hz</source>
        <translation>Marge de phase %1° à %2&#xa0;Hz</translation>
    </message>
    <message>
        <source>Phase margin not reached</source>
        <translation>Marge de phase non atteinte</translation>
    </message>
    <message>
        <source>Gain margin %1</source>
        <translation>Marge de gain %1</translation>
    </message>
    <message>
        <source>Gain margin not reached</source>
        <translation>Marge de gain non atteinte</translation>
    </message>
    <message>
        <source>Edit the gains to see what this loop would do with them.</source>
        <translation>Modifiez les gains pour voir ce que cette boucle ferait avec eux.</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: OL or IL cut off the filter&apos;s output while measuring. Use a smaller amplitude.</source>
        <translation>Inconnu pour les gains des champs&#xa0;: OL ou IL a limité la sortie du filtre pendant la mesure. Utilisez une amplitude plus petite.</translation>
    </message>
    <message>
        <source>OL or IL cut off the filter&apos;s output while measuring: for small motions, the loop responds differently. Use a smaller amplitude or a lower speed.</source>
        <translation>OL ou IL a limité la sortie du filtre pendant la mesure&#xa0;: pour de petits mouvements, la boucle répond autrement. Utilisez une amplitude ou une vitesse plus petite.</translation>
    </message>
    <message>
        <source>unstable, the motor would oscillate</source>
        <translation>instable, le moteur oscillerait</translation>
    </message>
    <message>
        <source>known only from %1 to %2 Hz</source>
        <translation>connu seulement de %1 à %2 Hz</translation>
    </message>
    <message>
        <source>With the gains in the fields: %1</source>
        <translation>Avec les gains des champs&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: SR differs from that of the measurement.</source>
        <translation>Inconnu pour les gains des champs&#xa0;: SR diffère de celui de la mesure.</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: DB differs from that of the measurement.</source>
        <translation>Inconnu pour les gains des champs&#xa0;: DB diffère de celui de la mesure.</translation>
    </message>
    <message>
        <source>known only at %1 Hz</source>
        <translation>connu seulement à %1 Hz</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>About NMC Panel</source>
        <translation>À propos de NMC Panel</translation>
    </message>
    <message>
        <source>A control panel for PIC-SERVO, PIC-STEP and PIC-I/O modules on one serial line.

Free software under the GNU General Public License, version 3 or later. Icons: Tabler, MIT licence. Built with Qt %1.</source>
        <translation>Programme de commande pour modules PIC-SERVO, PIC-STEP et PIC-I/O sur une liaison série.

Logiciel libre sous licence GNU General Public License, version 3 ou ultérieure. Icônes&#xa0;: Tabler, licence MIT. Réalisé avec Qt %1.</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sécurité</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>&amp;Safety</source>
        <translation>&amp;Sécurité</translation>
    </message>
    <message>
        <source>&amp;About NMC Panel</source>
        <translation>À &amp;propos de NMC Panel</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>&amp;Rechercher une commande…</translation>
    </message>
    <message>
        <source>Colour&amp;s</source>
        <translation>Co&amp;uleurs</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>The new language takes effect the next time you start NMC Panel.</source>
        <translation>La nouvelle langue prend effet au prochain démarrage de NMC Panel.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Système</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>Raccourcis &amp;clavier</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>Signaler un pro&amp;blème…</translation>
    </message>
</context>
<context>
    <name>MessageLines</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n fois</numerusform>
            <numerusform>%n fois</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Terminé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>ModelTexts</name>
    <message>
        <source>Gain %1</source>
        <translation>Gain %1</translation>
    </message>
    <message>
        <source>counts/s per PWM count</source>
        <translation>incr./s par unité PWM</translation>
    </message>
    <message>
        <source>Time constant %1</source>
        <translation>Constante de temps %1</translation>
    </message>
    <message>
        <source>Friction %1</source>
        <translation>Frottement %1</translation>
    </message>
    <message>
        <source>of 255 PWM</source>
        <translation>sur 255 PWM</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>Charge %1</translation>
    </message>
    <message>
        <source>Model error %1 counts RMS; encoder and timing account for %2.</source>
        <translation>Erreur du modèle %1 incr. RMS&#x202f;; le codeur et l’échantillonnage expliquent %2.</translation>
    </message>
    <message>
        <source>Too few samples. Record for longer, or raise the baud rate.</source>
        <translation>Trop peu d’échantillons. Enregistrez plus longtemps ou augmentez le débit.</translation>
    </message>
    <message>
        <source>The shaft did not move. Check motor power and brake, or use a larger step.</source>
        <translation>L’arbre n’a pas bougé. Vérifiez l’alimentation du moteur et le frein, ou utilisez un échelon plus grand.</translation>
    </message>
    <message>
        <source>The shaft moved away from its goal. Check the direction on the Axis page.</source>
        <translation>L’arbre s’est éloigné de sa cible. Vérifiez le sens sur la page Axe.</translation>
    </message>
    <message>
        <source>The motor keeps oscillating. Lower Kp or raise Kd, then step again.</source>
        <translation>Le moteur ne cesse d’osciller. Réduisez Kp ou augmentez Kd, puis refaites l’échelon.</translation>
    </message>
    <message>
        <source>The model does not fit the step. Check for backlash, an elastic belt, a hard stop or a current limit.</source>
        <translation>Le modèle ne correspond pas à l’échelon. Vérifiez s’il y a du jeu, une courroie élastique, une butée mécanique ou une limite de courant.</translation>
    </message>
    <message>
        <source>These steps do not determine the motor gain. Add a larger step, so that the motor gets close to a steady speed.</source>
        <translation>Ces échelons ne déterminent pas le gain du moteur. Ajoutez un échelon plus grand, pour que le moteur approche d’une vitesse constante.</translation>
    </message>
    <message>
        <source>These steps do not determine the time constant. Repeat the step, or raise the baud rate.</source>
        <translation>Ces échelons ne déterminent pas la constante de temps. Répétez l’échelon ou augmentez le débit.</translation>
    </message>
    <message>
        <source>Overshoot %1, settling %2</source>
        <translation>Dépassement %1, établissement %2</translation>
    </message>
    <message>
        <source>Steady-state error %1 counts</source>
        <translation>Erreur statique %1 incr.</translation>
    </message>
    <message>
        <source>Phase margin %1°, gain margin %2</source>
        <translation>Marge de phase %1°, marge de gain %2</translation>
    </message>
    <message>
        <source>Phase margin %1°</source>
        <translation>Marge de phase %1°</translation>
    </message>
    <message>
        <source>Uncertain: step once more. Until then the suggested gains are conservative.</source>
        <translation>Incertain : faites encore un échelon. D’ici là, les gains proposés sont prudents.</translation>
    </message>
    <message>
        <source>The motor stopped abruptly short of its goal. Something is in its way: a hard stop, or its load. Clear the way, or step in the other direction.</source>
        <translation>Le moteur s’est arrêté net avant sa cible. Quelque chose le gêne : une butée ou ce qu’il entraîne. Dégagez le passage ou faites l’échelon dans l’autre sens.</translation>
    </message>
    <message>
        <source>In %1 of 100 cases the motor stops too far from its goal.</source>
        <translation>Dans %1 cas sur 100, le moteur s’arrête trop loin de sa cible.</translation>
    </message>
    <message>
        <source>Amplifier deadband %1</source>
        <translation>Zone morte de l’amplificateur %1</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>Jeu %1</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>incréments</translation>
    </message>
    <message>
        <source>A resonance above %1 Hz would not show; the margins allow for one.</source>
        <translation>Une résonance au-dessus de %1 Hz ne se verrait pas&#x202f;; les marges en tiennent compte.</translation>
    </message>
    <message>
        <source>The motor probably has more than %1 counts of play: that much motion is lost at each reversal. Take up the play between motor and encoder.</source>
        <translation>Le moteur a sans doute plus de %1 incréments de jeu&#x202f;: c’est ce qui se perd lorsqu’il change de sens. Rattrapez le jeu entre moteur et codeur.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>%1 counts, %2</source>
        <translation>%1 incréments, %2</translation>
    </message>
    <message>
        <source>Settling to ±%1 %: %2</source>
        <translation>Établissement à ±%1&#x202f;%&#xa0;: %2</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Réglage de %1</translation>
    </message>
    <message>
        <source>simulated; no real motor moved</source>
        <translation>simulé&#x202f;; aucun moteur réel n’a bougé</translation>
    </message>
    <message>
        <source>Speed while measuring %1 counts/s</source>
        <translation>Vitesse pendant la mesure %1 incr./s</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>%1 counts in %2 s</source>
        <translation>%1 incréments en %2 s</translation>
    </message>
    <message>
        <source>Settling to ±%1 counts for %2 s: %3</source>
        <translation>Établissement à ±%1 incréments pendant %2 s&#xa0;: %3</translation>
    </message>
    <message>
        <source>Peak error %1</source>
        <translation>Erreur maximale %1</translation>
    </message>
    <message>
        <source>RMS error %1</source>
        <translation>Erreur efficace %1</translation>
    </message>
</context>
<context>
    <name>ResponseTexts</name>
    <message>
        <source>too few samples</source>
        <translation>trop peu d’échantillons</translation>
    </message>
    <message>
        <source>did not reach 90 %</source>
        <translation>n’a pas atteint 90&#x202f;%</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>non enregistré</translation>
    </message>
    <message>
        <source>Very fast profile</source>
        <translation>Profil très rapide</translation>
    </message>
    <message>
        <source>Stop here, at the goal</source>
        <translation>Arrêt ici, à la cible</translation>
    </message>
    <message>
        <source>A move with velocity and acceleration so high that its profile reaches the goal in one servo tick. CMC and SC stop here, at the goal, instead.</source>
        <translation>Déplacement à vitesse et accélération telles que le profil atteint la cible en un cycle. CMC et SC s’arrêtent plutôt ici, à la cible.</translation>
    </message>
    <message>
        <source>The servo holds the goal at once, without a profile. Not available with version 1.</source>
        <translation>Le servo maintient aussitôt la cible, sans profil. Pas avec la version 1.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>limited to %1</source>
        <translation>limité à %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>samples missing, repeat</source>
        <translation>échantillons manquants, à refaire</translation>
    </message>
    <message>
        <source>%1, off its goal</source>
        <translation>%1, hors de la cible</translation>
    </message>
    <message>
        <source>never constant</source>
        <translation>jamais constante</translation>
    </message>
    <message>
        <source>Profiled move</source>
        <translation>Mouvement profilé</translation>
    </message>
    <message>
        <source>No step: moves there and back with the velocity and acceleration below, judged by a window and a dwell. Not available with version 1.</source>
        <translation>Pas d’échelon&#xa0;: des mouvements aller et retour avec la vitesse et l’accélération ci-dessous, jugés par une fenêtre et un temps de maintien. Non disponible avec la version 1.</translation>
    </message>
    <message>
        <source>%1 of %2 settled</source>
        <translation>%1 sur %2 établis</translation>
    </message>
    <message>
        <source>%1 to %2 ms (%3)</source>
        <translation>%1 à %2 ms (%3)</translation>
    </message>
</context>
<context>
    <name>Scope</name>
    <message>
        <source>%1, by %2</source>
        <translation>%1, par %2</translation>
    </message>
    <message>
        <source>From %1; 0 s is %2</source>
        <translation>À partir de %1&#x202f;; 0&#xa0;s correspond à %2</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Plus tôt</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Go to live</source>
        <translation>Retour au direct</translation>
    </message>
    <message>
        <source>Values up</source>
        <translation>Valeurs vers le haut</translation>
    </message>
    <message>
        <source>Values down</source>
        <translation>Valeurs vers le bas</translation>
    </message>
    <message>
        <source>Zoom values in</source>
        <translation>Agrandir les valeurs</translation>
    </message>
    <message>
        <source>Zoom values out</source>
        <translation>Réduire les valeurs</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>Ajuster les valeurs</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>command, calculated</source>
        <translation>consigne, calculée</translation>
    </message>
    <message>
        <source>error, calculated</source>
        <translation>erreur, calculée</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>PWM, calculated</source>
        <translation>PWM, calculée</translation>
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
        <translation>comptage</translation>
    </message>
    <message>
        <source>count rate</source>
        <translation>fréquence de comptage</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>incréments</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>incr./s</translation>
    </message>
    <message>
        <source>One row per reply, can be reopened here (*.csv)</source>
        <translation>Une ligne par réponse, peut être rouvert ici (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, for other programs only (*.csv)</source>
        <translation>Une colonne par signal, uniquement pour d’autres programmes (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, every millisecond, for other programs only (*.csv)</source>
        <translation>Une colonne par signal, toutes les millisecondes, uniquement pour d’autres programmes (*.csv)</translation>
    </message>
    <message>
        <source>custom trace %1</source>
        <translation>courbe personnalisée %1</translation>
    </message>
    <message>
        <source>error, reported</source>
        <translation>erreur, signalée</translation>
    </message>
</context>
<context>
    <name>StepperWords</name>
    <message>
        <source>%1 steps/s</source>
        <translation>%1&#xa0;pas/s</translation>
    </message>
    <message>
        <source>%1x: %2 to %3 steps/s</source>
        <translation>%1x&#xa0;: %2 à %3 pas/s</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2, the minimum profile speed.</source>
        <translation>Marche à %1&#xa0;: vitesse %2, la vitesse minimale de profil.</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2 of 250.</source>
        <translation>Marche à %1&#xa0;: vitesse %2 sur 250.</translation>
    </message>
    <message>
        <source>Runs at %1: timer count %2.</source>
        <translation>Marche à %1&#xa0;: valeur du timer %2.</translation>
    </message>
    <message>
        <source>%1 steps/s²</source>
        <translation>%1&#xa0;pas/s²</translation>
    </message>
    <message>
        <source>The motor is already there.</source>
        <translation>Le moteur y est déjà.</translation>
    </message>
    <message>
        <source>Takes %1 s. Too short for that speed: peaks at %2.</source>
        <translation>Dure %1&#xa0;s. Trop court pour cette vitesse&#xa0;: culmine à %2.</translation>
    </message>
    <message>
        <source>Takes %1 s, peak speed %2.</source>
        <translation>Dure %1&#xa0;s, vitesse maximale %2.</translation>
    </message>
    <message>
        <source>Ramp of %1.</source>
        <translation>Rampe de %1.</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>error, zoomed (%1)</source>
        <translation>écart, agrandi (%1)</translation>
    </message>
    <message>
        <source>PWM, calculated (of 255)</source>
        <translation>PWM, calculé (sur 255)</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Port &quot;%1&quot; not found. Only the simulator is available: --simulator.</source>
        <translation>Port «&#xa0;%1&#xa0;» introuvable. Seul le simulateur est disponible&#xa0;: --simulator.</translation>
    </message>
    <message>
        <source>Port &quot;%1&quot; not found. Available ports: %2.</source>
        <translation>Port «&#xa0;%1&#xa0;» introuvable. Ports disponibles&#xa0;: %2.</translation>
    </message>
    <message>
        <source>These modules do not support the baud rate &quot;%1&quot;. Use %2.</source>
        <translation>Ces modules ne prennent pas en charge le débit «&#xa0;%1&#xa0;». Utilisez %2.</translation>
    </message>
    <message>
        <source>The simulator does not understand the chain &quot;%1&quot;: %2 An example: --simulator=servo,servo@1</source>
        <translation>Le simulateur ne comprend pas la chaîne «&#xa0;%1&#xa0;»&#xa0;: %2 Exemple&#xa0;: --simulator=servo,servo@1</translation>
    </message>
    <message>
        <source>Unknown option &quot;%1&quot;. Use --help for a list.</source>
        <translation>Option inconnue «&#xa0;%1&#xa0;». --help donne la liste.</translation>
    </message>
    <message>
        <source>No display found: neither DISPLAY nor WAYLAND_DISPLAY is set.</source>
        <translation>Aucun affichage trouvé&#xa0;: ni DISPLAY ni WAYLAND_DISPLAY n’est défini.</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Relancer la recherche</translation>
    </message>
    <message>
        <source>Use simulator</source>
        <translation>Utiliser le simulateur</translation>
    </message>
    <message>
        <source>Choose another port</source>
        <translation>Choisir un autre port</translation>
    </message>
    <message>
        <source>Motor state unknown; no motor was moving when last seen.</source>
        <translation>État du moteur inconnu&#x202f;; aucun moteur n’était en mouvement à la dernière lecture.</translation>
    </message>
    <message>
        <source>Your user account has no permission to use %1.</source>
        <translation>Votre compte utilisateur n’a pas le droit d’utiliser %1.</translation>
    </message>
    <message>
        <source>Ask your system administrator for access.</source>
        <translation>Demandez l’accès à votre administrateur système.</translation>
    </message>
    <message>
        <source>It belongs to the group %1. Run %2, then log out and in again.</source>
        <translation>Il appartient au groupe %1. Exécutez %2, puis fermez et rouvrez la session.</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Copier la commande</translation>
    </message>
    <message>
        <source>%1 is used by another program.</source>
        <translation>%1 est utilisé par un autre programme.</translation>
    </message>
    <message>
        <source>Close it and try again.</source>
        <translation>Fermez-le et réessayez.</translation>
    </message>
    <message>
        <source>Close it and try again. Or use nmcctl through it: in its Chain menu, switch on &quot;Let programs in&quot;, and leave out --port.</source>
        <translation>Fermez-le et réessayez. Ou utilisez nmcctl à travers lui&#xa0;: dans son menu Chaîne, activez «&#xa0;Laisser entrer des programmes&#xa0;», et omettez --port.</translation>
    </message>
    <message>
        <source>%1 not found.</source>
        <translation>%1 introuvable.</translation>
    </message>
    <message>
        <source>Check that the adapter is plugged in. Its name may have changed.</source>
        <translation>Vérifiez que l’adaptateur est branché. Son nom a peut-être changé.</translation>
    </message>
    <message>
        <source>%1 is not a serial port.</source>
        <translation>%1 n’est pas un port série.</translation>
    </message>
    <message>
        <source>Choose the adapter&apos;s port, for example /dev/ttyUSB0.</source>
        <translation>Choisissez le port de l’adaptateur, par exemple /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>%1 does not support the selected baud rate.</source>
        <translation>%1 ne prend pas en charge le débit sélectionné.</translation>
    </message>
    <message>
        <source>Choose another baud rate; every adapter supports 19 200 Bd.</source>
        <translation>Choisissez un autre débit&#x202f;; tout adaptateur prend en charge 19&#x202f;200&#xa0;Bd.</translation>
    </message>
    <message>
        <source>The adapter at %1 was unplugged. %2</source>
        <translation>L’adaptateur sur %1 a été débranché. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then plug the adapter in again.</source>
        <translation>Utilisez l’arrêt câblé si nécessaire, puis rebranchez l’adaptateur.</translation>
    </message>
    <message>
        <source>Could not open %1.</source>
        <translation>Impossible d’ouvrir %1.</translation>
    </message>
    <message>
        <source>System message: %1</source>
        <translation>Message du système&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not every module answered at %1 Bd, so the modules cannot be used yet.</source>
        <translation>Au moins un module n’a pas répondu à %1&#xa0;Bd&#xa0;: les modules ne sont pas encore utilisables.</translation>
    </message>
    <message>
        <source>Module %1 did not answer at %2 Bd, so the modules cannot be used yet.</source>
        <translation>Le module %1 n’a pas répondu à %2&#xa0;Bd&#xa0;: les modules ne sont pas encore utilisables.</translation>
    </message>
    <message>
        <source>Usually the cable is too long for this baud rate, or termination is missing. Choose a lower baud rate for %1 and scan again.</source>
        <translation>Cause habituelle&#xa0;: câble trop long pour ce débit, ou terminaison absente. Choisissez un débit plus faible pour %1 et relancez la recherche.</translation>
    </message>
    <message>
        <source>Modules answered at %1, but their answers were garbled.</source>
        <translation>Des modules ont répondu sur %1, mais leurs réponses étaient altérées.</translation>
    </message>
    <message>
        <source>Usually noise on the cable, or two modules answering at once. Check the cable, its termination and the ADDR_IN jumpers.</source>
        <translation>Cause habituelle&#xa0;: parasites sur le câble, ou deux modules répondant en même temps. Vérifiez le câble, sa terminaison et les cavaliers ADDR_IN.</translation>
    </message>
    <message>
        <source>Port %1, %2 Bd</source>
        <translation>Port %1, %2&#xa0;Bd</translation>
    </message>
    <message>
        <source>module %1</source>
        <translation>module %1</translation>
    </message>
    <message>
        <source>module %1 &quot;%2&quot;</source>
        <translation>module %1 «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two.</source>
        <translation>La numérotation commence à l’extrémité de la chaîne. Contrôlez donc le module qui suit %1 en direction du PC&#xa0;: d’abord son alimentation, puis le connecteur entre les deux.</translation>
    </message>
    <message>
        <source>Work with %1</source>
        <translation>Travailler avec %1</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd.</source>
        <translation>Connecté à %1&#xa0;: %2 à %3&#xa0;Bd.</translation>
    </message>
    <message>
        <source>Nothing moves until you command it. Gains are unknown until you apply them.</source>
        <translation>Rien ne bouge sans votre demande. Les gains sont inconnus tant que vous ne les appliquez pas.</translation>
    </message>
    <message>
        <source>Disconnected from %1.</source>
        <translation>Déconnecté de %1.</translation>
    </message>
    <message>
        <source>All modules on %1 stopped answering. %2</source>
        <translation>Plus aucun module sur %1 ne répond. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Then check the power of the modules and the cable at the PC.</source>
        <translation>Utilisez l’arrêt câblé si nécessaire. Vérifiez ensuite l’alimentation des modules et le câble côté PC.</translation>
    </message>
    <message>
        <source>The link is unreliable: %1 of the last %2 exchanges failed.</source>
        <translation>La liaison n’est pas fiable&#xa0;: taux d’échec de %1 sur les %2 derniers échanges.</translation>
    </message>
    <message>
        <source>Updates are slow (%1 per second) because the USB adapter waits %2 ms before passing data on.</source>
        <translation>Les mises à jour sont lentes (%1 par seconde), car l’adaptateur USB attend %2&#xa0;ms avant de transmettre les données.</translation>
    </message>
    <message>
        <source>Set its latency timer to 1 ms.</source>
        <translation>Réglez sa temporisation (latency timer) à 1&#xa0;ms.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown: it was moving.</source>
        <translation>Le module %1 n’a pas répondu depuis %2&#xa0;s. État du moteur inconnu&#xa0;: il était en mouvement.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown; it was stopped when last seen.</source>
        <translation>Le module %1 n’a pas répondu depuis %2&#xa0;s. État du moteur inconnu&#x202f;; il était à l’arrêt à la dernière lecture.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. The state of its outputs is unknown.</source>
        <translation>Le module %1 n’a pas répondu depuis %2&#xa0;s. L’état de ses sorties est inconnu.</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Check its power and the plug next to it; the panel keeps trying.</source>
        <translation>Utilisez l’arrêt câblé si nécessaire. Vérifiez son alimentation et le connecteur voisin&#x202f;; le programme continue d’essayer.</translation>
    </message>
    <message>
        <source>Module %1 may not answer until module %2 has its address again.</source>
        <translation>Le module %1 peut ne pas répondre tant que le module %2 n’a pas retrouvé son adresse.</translation>
    </message>
    <message>
        <source>Restart the network…</source>
        <translation>Redémarrer le réseau…</translation>
    </message>
    <message>
        <source>Module %1 received a garbled command and did not carry it out.</source>
        <translation>Le module %1 a reçu une commande altérée et ne l’a pas exécutée.</translation>
    </message>
    <message>
        <source>Sending again (%1 of 3). Usually noise on the cable.</source>
        <translation>Nouvel envoi (%1 sur 3). Cause habituelle&#xa0;: parasites sur le câble.</translation>
    </message>
    <message>
        <source>The answer from module %1 was garbled.</source>
        <translation>La réponse du module %1 était altérée.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; the panel is reading the position again.</source>
        <translation>La commande a peut-être été exécutée, peut-être pas&#x202f;; le programme relit la position.</translation>
    </message>
    <message>
        <source>Command byte %1</source>
        <translation>Octet de commande %1</translation>
    </message>
    <message>
        <source>Module %1: done.</source>
        <translation>Module %1&#xa0;: terminé.</translation>
    </message>
    <message>
        <source>Module %1 received the command garbled and did not carry it out.</source>
        <translation>Le module %1 a reçu la commande altérée et ne l’a pas exécutée.</translation>
    </message>
    <message>
        <source>Sent 3 times; later commands were not sent. Usually noise on the cable.</source>
        <translation>Envoyée 3 fois&#x202f;; les commandes suivantes n’ont pas été envoyées. Cause habituelle&#xa0;: parasites sur le câble.</translation>
    </message>
    <message>
        <source>Module %1 did not answer the command. Motor state unknown.</source>
        <translation>Le module %1 n’a pas répondu à la commande. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; later commands were not sent. Look at the motor; stop all if in doubt.</source>
        <translation>La commande a peut-être été exécutée, peut-être pas&#x202f;; les commandes suivantes n’ont pas été envoyées. Regardez le moteur&#x202f;; en cas de doute, arrêtez tout.</translation>
    </message>
    <message>
        <source>Module %1 cannot do this in its present state. Nothing was sent.</source>
        <translation>Le module %1 ne peut pas faire cela dans son état actuel. Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>Stop the motor, then try again.</source>
        <translation>Arrêtez le moteur, puis réessayez.</translation>
    </message>
    <message>
        <source>The command for module %1 was cancelled.</source>
        <translation>La commande destinée au module %1 a été annulée.</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to module %1.</source>
        <translation>Trop de commandes attendent. Rien n’a été envoyé au module %1.</translation>
    </message>
    <message>
        <source>Wait until they are carried out, or press STOP ALL to discard them.</source>
        <translation>Attendez qu’elles soient exécutées, ou abandonnez-les avec TOUT ARRÊTER.</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was more than %2 counts from where it should be.</source>
        <translation>Le module %1 a coupé son servo, car le moteur était à plus de %2 incréments de la position de consigne.</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was too far from where it should be.</source>
        <translation>Le module %1 a coupé son servo, car le moteur était trop loin de la position de consigne.</translation>
    </message>
    <message>
        <source>Clear and stay off</source>
        <translation>Effacer, servo coupé</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its servo is off.</source>
        <translation>Le module %1 n’a pas d’alimentation moteur&#x202f;; son servo est donc coupé.</translation>
    </message>
    <message>
        <source>It stays off when power returns.</source>
        <translation>Il reste coupé au retour de l’alimentation.</translation>
    </message>
    <message>
        <source>The computer was busy, or the program that jogs it has stopped calling. Press and hold again.</source>
        <translation>L’ordinateur était occupé, ou le programme qui demande le jog n’a plus appelé. Appuyez de nouveau et maintenez.</translation>
    </message>
    <message>
        <source>Module %1 cannot do this now; nothing was sent.</source>
        <translation>Le module %1 ne peut pas faire cela maintenant&#x202f;; rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>reaches %1 of %2</source>
        <translation>atteint %1 des %2 modules</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped before the port closes.</source>
        <translation>
            <numerusform>%n moteur est en mouvement. Il sera arrêté avant la fermeture du port.</numerusform>
            <numerusform>%n moteurs sont en mouvement. Ils seront arrêtés avant la fermeture du port.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopping the motors, then closing.</source>
        <translation>Arrêt des moteurs, puis fermeture.</translation>
    </message>
    <message>
        <source>Fit a hardware emergency stop that removes motor power.</source>
        <translation>Prévoyez un arrêt d’urgence câblé qui coupe l’alimentation des moteurs.</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Compris</translation>
    </message>
    <message>
        <source>Module %1</source>
        <translation>Module %1</translation>
    </message>
    <message>
        <source>type %1</source>
        <translation>type %1</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Pas de réponse</translation>
    </message>
    <message>
        <source>Not asked</source>
        <translation>Non interrogé</translation>
    </message>
    <message>
        <source>No motor power</source>
        <translation>Moteur non alimenté</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>Servo coupé</translation>
    </message>
    <message>
        <source>Power was lost</source>
        <translation>Alimentation perdue</translation>
    </message>
    <message>
        <source>PWM mode</source>
        <translation>Mode PWM</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>En maintien</translation>
    </message>
    <message>
        <source>Accelerating</source>
        <translation>Accélère</translation>
    </message>
    <message>
        <source>At speed</source>
        <translation>Vitesse atteinte</translation>
    </message>
    <message>
        <source>Decelerating</source>
        <translation>Décélère</translation>
    </message>
    <message>
        <source>No status received from this module yet.</source>
        <translation>Aucun état reçu de ce module pour l’instant.</translation>
    </message>
    <message>
        <source>The module does not answer. Motor state unknown.</source>
        <translation>Le module ne répond pas. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>Sending has stopped because another module restarted, so what this one does now is not known. Scan again, or restart the network.</source>
        <translation>Plus rien n’est envoyé car un autre module a redémarré&#xa0;; on ne sait donc pas ce que fait celui-ci maintenant. Relancez la recherche, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the servo is switched off.</source>
        <translation>Le moteur peut tourner librement. C’est normal&#xa0;: le servo est coupé.</translation>
    </message>
    <message>
        <source>The servo switched itself off because the motor was too far from where it should be.</source>
        <translation>Le servo s’est coupé, car le moteur était trop loin de la position de consigne.</translation>
    </message>
    <message>
        <source>A fixed PWM value drives the motor; the servo does not control it. After a loss of motor power, the motor may turn again by itself.</source>
        <translation>Une valeur PWM fixe entraîne le moteur&#x202f;; le servo ne le régule pas. Après une coupure de l’alimentation moteur, le moteur peut se remettre à tourner tout seul.</translation>
    </message>
    <message>
        <source>The motor is changing its speed.</source>
        <translation>Le moteur change de vitesse.</translation>
    </message>
    <message>
        <source>The motor moves at its goal velocity.</source>
        <translation>Le moteur tourne à sa vitesse de consigne.</translation>
    </message>
    <message>
        <source>The motor is slowing down.</source>
        <translation>Le moteur ralentit.</translation>
    </message>
    <message>
        <source>Not connected. Choose a port and connect first.</source>
        <translation>Non connecté. Choisissez d’abord un port et connectez-vous.</translation>
    </message>
    <message>
        <source>This module is not a PIC-SERVO.</source>
        <translation>Ce module n’est pas un PIC-SERVO.</translation>
    </message>
    <message>
        <source>The module does not answer, so its state is unknown.</source>
        <translation>Le module ne répond pas&#x202f;; son état est donc inconnu.</translation>
    </message>
    <message>
        <source>This is not the type of module that the machine has here, so its settings do not apply. Only stop commands work until you accept the chain as found (Chain doctor).</source>
        <translation>La machine a ici un autre type de module&#x202f;; ses réglages ne s’appliquent donc pas. Seuls les arrêts agissent tant que vous n’avez pas accepté la chaîne telle quelle (Diagnostic de la chaîne).</translation>
    </message>
    <message>
        <source>The module has no motor power.</source>
        <translation>Le module n’a pas d’alimentation moteur.</translation>
    </message>
    <message>
        <source>The gains are 0 or unknown, so the motor would not hold. Apply gains first.</source>
        <translation>Les gains sont à 0 ou inconnus&#xa0;: le moteur ne tiendrait pas sa position. Appliquez d’abord des gains.</translation>
    </message>
    <message>
        <source>The servo is off. Enable it first.</source>
        <translation>Le servo est coupé. Activez-le d’abord.</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first: a move to a position starts from standstill.</source>
        <translation>Le moteur est en mouvement. Arrêtez-le d’abord&#xa0;: un déplacement vers une position part de l’arrêt.</translation>
    </message>
    <message>
        <source>The acceleration is 0 or unknown: the motor might not start or stop. Enter an acceleration.</source>
        <translation>L’accélération est à 0 ou inconnue&#xa0;: le moteur pourrait ne pas démarrer ou ne pas s’arrêter. Saisissez une accélération.</translation>
    </message>
    <message>
        <source>The velocity is 0 or unknown: the motor might not move, or move too fast. Enter a velocity.</source>
        <translation>La vitesse est à 0 ou inconnue&#xa0;: le moteur pourrait ne pas bouger, ou bouger trop vite. Saisissez une vitesse.</translation>
    </message>
    <message>
        <source>The chip cannot turn the motor this slowly in its speed mode. Enter a higher velocity, or choose another speed mode.</source>
        <translation>La puce ne peut pas faire tourner le moteur aussi lentement dans son mode de vitesse. Saisissez une vitesse plus élevée ou choisissez un autre mode de vitesse.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>restarting the modules</source>
        <translation>redémarrage des modules</translation>
    </message>
    <message>
        <source>assigning addresses</source>
        <translation>attribution des adresses</translation>
    </message>
    <message>
        <source>reading types and versions</source>
        <translation>lecture des types et versions</translation>
    </message>
    <message>
        <source>changing the baud rate</source>
        <translation>changement de débit</translation>
    </message>
    <message>
        <source>setting up status reports</source>
        <translation>configuration des états à transmettre</translation>
    </message>
    <message>
        <source>Simulator (%1)</source>
        <translation>Simulateur (%1)</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>Connecting to %1: %2</source>
        <translation>Connexion à %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1, %2 so far</source>
        <translation>%1, %2 jusqu’ici</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3</source>
        <translation>Connecté à %1 à %2&#xa0;Bd, %3</translation>
    </message>
    <message>
        <source>%1 is open, but no module is usable</source>
        <translation>%1 est ouvert, mais aucun module n’est utilisable</translation>
    </message>
    <message>
        <source>Connection to %1 lost, motor state unknown</source>
        <translation>Connexion à %1 perdue, état des moteurs inconnu</translation>
    </message>
    <message>
        <source>Sending to %1 has stopped: module %2 restarted</source>
        <translation>Plus rien n’est envoyé à %1&#xa0;: le module %2 a redémarré</translation>
    </message>
    <message numerus="yes">
        <source>%n modules</source>
        <translation>
            <numerusform>%n module</numerusform>
            <numerusform>%n modules</numerusform>
        </translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>counts</source>
        <translation>incréments</translation>
    </message>
    <message>
        <source>counts/tick</source>
        <translation>incr./cycle</translation>
    </message>
    <message>
        <source>counts/tick²</source>
        <translation>incr./cycle²</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Terminé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Échec&#xa0;: %1</translation>
    </message>
    <message>
        <source>Answer to: %1</source>
        <translation>Réponse à&#xa0;: %1</translation>
    </message>
    <message>
        <source>Two modules on %1 have the same address, so the modules cannot be used.</source>
        <translation>Deux modules sur %1 ont la même adresse&#xa0;: les modules ne sont pas utilisables.</translation>
    </message>
    <message>
        <source>No motor was moved. Usually two ADDR_IN inputs are grounded; ground only that of the module farthest from the PC.</source>
        <translation>Aucun moteur n’a été mis en mouvement. Cause habituelle&#xa0;: deux entrées ADDR_IN à la masse&#x202f;; seule celle du module le plus éloigné du PC doit y être.</translation>
    </message>
    <message>
        <source>The line at %1 is held low: only zero bytes arrive.</source>
        <translation>La ligne sur %1 est maintenue à l’état bas&#xa0;: seuls des octets nuls arrivent.</translation>
    </message>
    <message>
        <source>Motor state unknown; commands may not get through. Usually a short circuit, swapped wires of a pair, or a module without power.</source>
        <translation>État des moteurs inconnu&#x202f;; les commandes peuvent ne pas passer. Cause habituelle&#xa0;: court-circuit, fils d’une paire inversés ou module non alimenté.</translation>
    </message>
    <message>
        <source>The modules on %1 have no addresses yet.</source>
        <translation>Les modules sur %1 n’ont pas encore d’adresse.</translation>
    </message>
    <message>
        <source>A read-only connection cannot assign addresses. Choose Connect fully.</source>
        <translation>Une connexion en lecture seule ne peut pas attribuer d’adresses. Connectez-vous sans la lecture seule.</translation>
    </message>
    <message>
        <source>The link is marginal: %1 of the last %2 exchanges failed.</source>
        <translation>La liaison est limite&#xa0;: taux d’échec de %1 sur les %2 derniers échanges.</translation>
    </message>
    <message>
        <source>Motor state unknown. Look at the motor; stop all if in doubt.</source>
        <translation>État du moteur inconnu. Regardez le moteur&#x202f;; en cas de doute, arrêtez tout.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1&#xa0;min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1&#xa0;h</translation>
    </message>
    <message>
        <source>The panel froze for %1 while a motor was moving. The motor was not stopped.</source>
        <translation>Le programme est resté figé pendant %1 alors qu’un moteur était en mouvement. Le moteur n’a pas été arrêté.</translation>
    </message>
    <message>
        <source>STOP ALL did not work during that time. The computer was busy, or the program hung.</source>
        <translation>TOUT ARRÊTER était sans effet pendant ce temps. L’ordinateur était occupé, ou le programme était bloqué.</translation>
    </message>
    <message>
        <source>Resumed after %1: reading all values again.</source>
        <translation>Reprise après %1&#xa0;: relecture de toutes les valeurs.</translation>
    </message>
    <message>
        <source>Resumed after %1: motors were commanded to stop; reading all values again.</source>
        <translation>Reprise après %1&#xa0;: les moteurs ont reçu l’ordre d’arrêt&#x202f;; relecture de toutes les valeurs.</translation>
    </message>
    <message>
        <source>While the computer was suspended, the panel could not stop a motor. Look at the motors before the next move.</source>
        <translation>Pendant la veille de l’ordinateur, le programme ne pouvait arrêter aucun moteur. Regardez les moteurs avant le prochain déplacement.</translation>
    </message>
    <message numerus="yes">
        <source>The last session ended while motors %1 were moving.</source>
        <translation>
            <numerusform>La dernière session s’est terminée alors que le moteur %1 était en mouvement.</numerusform>
            <numerusform>La dernière session s’est terminée alors que les moteurs %1 étaient en mouvement.</numerusform>
        </translation>
    </message>
    <message>
        <source>Settings cannot be saved.</source>
        <translation>Les préférences ne peuvent pas être enregistrées.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works; only the window layout and the last port are not remembered.</source>
        <translation>Écriture impossible dans %1. Tout le reste fonctionne&#x202f;; seuls la disposition de la fenêtre et le dernier port ne sont pas mémorisés.</translation>
    </message>
    <message>
        <source>%1 is used by another program (pid %2).</source>
        <translation>%1 est utilisé par un autre programme (pid %2).</translation>
    </message>
    <message>
        <source>%1 is used by %2 (pid %3).</source>
        <translation>%1 est utilisé par %2 (pid %3).</translation>
    </message>
    <message>
        <source>It probes a newly connected adapter for a modem for a few seconds; wait, then try again. To keep it away from USB adapters, run %1, then plug the adapter in again.</source>
        <translation>Ce programme cherche pendant quelques secondes un modem sur tout adaptateur qui vient d’être branché&#x202f;; patientez, puis réessayez. Pour l’écarter des adaptateurs USB, exécutez %1, puis rebranchez l’adaptateur.</translation>
    </message>
    <message>
        <source>It mistakes many serial adapters for a Braille display. If you have none, run %1, then plug the adapter in again.</source>
        <translation>Ce programme prend de nombreux adaptateurs série pour une plage braille. Si vous n’en avez pas, exécutez %1, puis rebranchez l’adaptateur.</translation>
    </message>
    <message>
        <source>%1 is free, but a stale lock file marks it as in use.</source>
        <translation>%1 est libre, mais un fichier de verrouillage périmé le signale comme occupé.</translation>
    </message>
    <message>
        <source>%2 left the lock file %1 behind. Remove it with %3, then try again.</source>
        <translation>%2 a laissé le fichier de verrouillage %1. Supprimez-le avec %3, puis réessayez.</translation>
    </message>
    <message>
        <source>Could not open %1: no lock file can be created for it.</source>
        <translation>Impossible d’ouvrir %1&#xa0;: aucun fichier de verrouillage ne peut être créé.</translation>
    </message>
    <message>
        <source>Your user account has no write access to %1 or any other folder for lock files. Ask your system administrator for access.</source>
        <translation>Votre compte utilisateur n’a pas le droit d’écrire dans %1 ni dans un autre dossier de fichiers de verrouillage. Demandez l’accès à votre administrateur système.</translation>
    </message>
    <message>
        <source>Could not open %1: this program has too many open files.</source>
        <translation>Impossible d’ouvrir %1&#xa0;: ce programme a trop de fichiers ouverts.</translation>
    </message>
    <message>
        <source>Close files that you do not need, or restart the program.</source>
        <translation>Fermez les fichiers dont vous n’avez pas besoin, ou redémarrez le programme.</translation>
    </message>
    <message>
        <source>Set the latency timer of the USB adapter to 1 ms, then connect again.</source>
        <translation>Réglez la temporisation (latency timer) de l’adaptateur USB à 1&#xa0;ms, puis reconnectez-vous.</translation>
    </message>
    <message>
        <source>Run %1. This lasts until the adapter is unplugged. To make it permanent, also run %2.</source>
        <translation>Exécutez %1. L’effet dure jusqu’au débranchement de l’adaptateur. Pour le rendre permanent, exécutez aussi %2.</translation>
    </message>
    <message>
        <source>The adapter is back as %1 (same serial number). Reconnect?</source>
        <translation>L’adaptateur est de retour sous %1 (même numéro de série). Reconnecter&#x202f;?</translation>
    </message>
    <message>
        <source>A similar adapter was found as %1. Reconnect?</source>
        <translation>Un adaptateur semblable a été trouvé sous %1. Reconnecter&#x202f;?</translation>
    </message>
    <message>
        <source>Motors may still be moving. Reconnecting moves nothing and repeats no earlier command.</source>
        <translation>Des moteurs peuvent encore être en mouvement. La reconnexion ne fait rien bouger et ne répète aucune commande antérieure.</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (19 200 Bd tried).</source>
        <translation>Le port est ouvert, mais aucun module n’a répondu (essai à 19&#x202f;200&#xa0;Bd).</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).</source>
        <translation>Le port est ouvert, mais aucun module n’a répondu (essais à 9600, 19&#x202f;200, 57&#x202f;600 et 115&#x202f;200&#xa0;Bd).</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. If another program left the chain at an unusual baud rate, restart the network.</source>
        <translation>Vérifiez dans cet ordre&#xa0;: l’alimentation des modules&#x202f;; chaque câble de la chaîne, car un seul câble débranché masque tous les modules&#x202f;; le cavalier ADDR_IN du module le plus éloigné du PC&#x202f;; que TX et RX ne sont pas inversés&#x202f;; que l’adaptateur est full-duplex (4 fils). Si un autre programme a laissé la chaîne à un débit inhabituel, redémarrez le réseau.</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd, left running.</source>
        <translation>Connecté à %1&#xa0;: %2 à %3&#xa0;Bd, sans rien arrêter.</translation>
    </message>
    <message>
        <source>The modules carry on with what they were doing.</source>
        <translation>Les modules poursuivent ce qu’ils faisaient.</translation>
    </message>
    <message>
        <source>Gains are unknown until you apply them. Stop a motor before you move it: its last command is unknown.</source>
        <translation>Les gains sont inconnus tant que vous ne les appliquez pas. Arrêtez un moteur avant de le déplacer&#xa0;: sa dernière commande est inconnue.</translation>
    </message>
    <message>
        <source>A module without an address also answered; it cannot be used yet.</source>
        <translation>Un module sans adresse a aussi répondu&#x202f;; il n’est pas encore utilisable.</translation>
    </message>
    <message>
        <source>Its motor is off. Either a module has restarted, or a new one was added. Restart the network to give it an address.</source>
        <translation>Son moteur est coupé. Soit un module a redémarré, soit un nouveau a été ajouté. Redémarrez le réseau pour lui donner une adresse.</translation>
    </message>
    <message>
        <source>The link to module %1 is unreliable: %2 of its last %3 exchanges failed.</source>
        <translation>La liaison avec le module %1 n’est pas fiable&#xa0;: taux d’échec de %2 sur ses %3 derniers échanges.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconnecter</translation>
    </message>
    <message>
        <source>A different adapter is on %1.</source>
        <translation>Un autre adaptateur est sur %1.</translation>
    </message>
    <message>
        <source>The panel was connected to another adapter before. Nothing was sent.</source>
        <translation>Le programme était auparavant connecté à un autre adaptateur. Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>Se connecter quand même</translation>
    </message>
    <message>
        <source>The link to module %1 is marginal: %2 of its last %3 exchanges failed.</source>
        <translation>La liaison avec le module %1 est limite&#xa0;: taux d’échec de %2 sur ses %3 derniers échanges.</translation>
    </message>
    <message>
        <source>Its motor is off.</source>
        <translation>Son moteur est coupé.</translation>
    </message>
    <message>
        <source>Set its outputs again once it has its address.</source>
        <translation>Réglez de nouveau ses sorties dès qu’il a retrouvé son adresse.</translation>
    </message>
    <message>
        <source>Every module loses its position, gains and address, and switches its motor off.</source>
        <translation>Chaque module perd sa position, ses gains et son adresse, et coupe son moteur.</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped first.</source>
        <translation>
            <numerusform>%n moteur est en mouvement. Il sera d’abord arrêté.</numerusform>
            <numerusform>%n moteurs sont en mouvement. Ils seront d’abord arrêtés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restarted</source>
        <translation>Redémarré</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, gains and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>Le module a redémarré&#xa0;: son moteur est coupé&#x202f;; sa position, ses gains et son adresse sont perdus. Réattribuez son adresse si le programme le propose, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>The module restarted: its pins are inputs again, its outputs release what they drove, and its address is lost. Assign its address again if offered, or restart the network.</source>
        <translation>Le module a redémarré&#xa0;: ses broches sont de nouveau des entrées, ses sorties relâchent ce qu’elles pilotaient et son adresse est perdue. Réattribuez son adresse si le programme le propose, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, parameters and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>Le module a redémarré&#xa0;: son moteur est coupé&#xa0;; sa position, ses paramètres et son adresse sont perdus. Réattribuez son adresse si le programme le propose, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>all bytes are 00, or all FF, as on a line that is held low or high</source>
        <translation>tous les octets sont 00 ou FF, comme sur une ligne maintenue à l’état bas ou haut</translation>
    </message>
    <message>
        <source>more bytes than requested</source>
        <translation>plus d’octets que demandé</translation>
    </message>
    <message>
        <source>type or version does not match this module</source>
        <translation>le type ou la version ne correspond pas à ce module</translation>
    </message>
    <message>
        <source>an undefined status bit changed</source>
        <translation>un bit d’état non défini a changé</translation>
    </message>
    <message>
        <source>homing started without a command</source>
        <translation>prise d’origine démarrée sans commande</translation>
    </message>
    <message>
        <source>home register changed without a command</source>
        <translation>registre d’origine modifié sans commande</translation>
    </message>
    <message>
        <source>position jumped farther than the velocities allow</source>
        <translation>saut de position plus grand que les vitesses ne le permettent</translation>
    </message>
    <message>
        <source>velocity changed faster than any motor can</source>
        <translation>vitesse modifiée plus vite qu’un moteur ne le peut</translation>
    </message>
    <message>
        <source>servo is off, but pos_error or move_done is not set</source>
        <translation>le servo est coupé, mais pos_error ou move_done n’est pas à 1</translation>
    </message>
    <message>
        <source>servo is on without motor power</source>
        <translation>le servo est actif sans alimentation moteur</translation>
    </message>
    <message>
        <source>slew_done is set without accel_done</source>
        <translation>slew_done est à 1 sans accel_done</translation>
    </message>
    <message>
        <source>a sticky bit was cleared without a command</source>
        <translation>un bit mémorisé a été effacé sans commande</translation>
    </message>
    <message>
        <source>velocity and trapezoidal mode at once</source>
        <translation>modes vitesse et trapézoïdal en même temps</translation>
    </message>
    <message>
        <source>moving without power or amplifier</source>
        <translation>mouvement sans alimentation ou sans amplificateur</translation>
    </message>
    <message>
        <source>position changed while the motor was stopped</source>
        <translation>position modifiée alors que le moteur était à l’arrêt</translation>
    </message>
    <message>
        <source>timer count of a moving motor is not 1 to 65 452</source>
        <translation>la valeur du timer d’un moteur en mouvement n’est pas comprise entre 1 et 65&#x202f;452</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>acceptée</translation>
    </message>
    <message>
        <source>module refused: checksum</source>
        <translation>refusée par le module&#xa0;: somme de contrôle</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>too few bytes</source>
        <translation>trop peu d’octets</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>somme de contrôle fausse</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>rejetée&#xa0;: %1</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rejetée</translation>
    </message>
    <message>
        <source>cancelled by a stop</source>
        <translation>annulée par un arrêt</translation>
    </message>
    <message>
        <source>no answer expected</source>
        <translation>pas de réponse attendue</translation>
    </message>
    <message>
        <source>bytes, but no answer was expected</source>
        <translation>octets reçus, mais aucune réponse n’était attendue</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>connexion</translation>
    </message>
    <message>
        <source>poll</source>
        <translation>scrutation</translation>
    </message>
    <message>
        <source>command</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>check</source>
        <translation>vérification</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>jog</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>arrêt</translation>
    </message>
    <message>
        <source>challenge</source>
        <translation>contre-épreuve</translation>
    </message>
    <message>
        <source>flush</source>
        <translation>purge</translation>
    </message>
    <message>
        <source>Address %1</source>
        <translation>Adresse %1</translation>
    </message>
    <message>
        <source>SIMULATED SESSION: no hardware was connected.</source>
        <translation>SESSION SIMULÉE&#xa0;: aucun matériel n’était connecté.</translation>
    </message>
    <message>
        <source>Packets of %1 on %2, seconds since %3</source>
        <translation>Trames de %1 sur %2, en secondes depuis %3</translation>
    </message>
    <message>
        <source>Older exchanges left out of this file: %1.</source>
        <translation>Échanges plus anciens omis dans ce fichier&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Exchanges before this one were not recorded.</source>
        <translation>Les échanges antérieurs à celui-ci n’ont pas été enregistrés.</translation>
    </message>
    <message>
        <source>looking for modules</source>
        <translation>recherche des modules</translation>
    </message>
    <message>
        <source>Carried out by: %1.</source>
        <translation>Exécutée par&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not carried out by: %1.</source>
        <translation>Non exécutée par&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Unknown for: %1.</source>
        <translation>Inconnu pour&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No answer from: %1.</source>
        <translation>Pas de réponse de&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 modules of group %3 started. All of them were commanded to stop.</source>
        <translation>Modules du groupe %3 démarrés&#xa0;: %1 sur %2. Tous ont reçu l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>No module of group %1 started. Nothing was moved.</source>
        <translation>Aucun module du groupe %1 n’a démarré. Rien n’a bougé.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed their start.</source>
        <translation>Au moins un module du groupe %1 n’a pas confirmé son démarrage.</translation>
    </message>
    <message>
        <source>Look at the motors. The start is never repeated: load the moves again, then start the group again. Usually noise on the cable.</source>
        <translation>Regardez les moteurs. Le démarrage n’est jamais répété&#xa0;: rechargez le déplacement, puis démarrez de nouveau. Cause habituelle&#xa0;: parasites sur le câble.</translation>
    </message>
    <message>
        <source>Group %1 is empty. Nothing was sent.</source>
        <translation>Le groupe %1 est vide. Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>Add modules to the group first.</source>
        <translation>Ajoutez d’abord des modules au groupe.</translation>
    </message>
    <message>
        <source>Module %2 blocks the command to group %1. Nothing was sent.</source>
        <translation>Le module %2 bloque la commande au groupe %1. Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>A group starts only when every member answers, has confirmed its load and can start, and the group of every module is known. Load this module again, or set its group again.</source>
        <translation>Un groupe ne démarre que si chaque membre répond, a confirmé son chargement et peut démarrer, et si le groupe de chaque module est connu. Chargez de nouveau ce module, ou redéfinissez son groupe.</translation>
    </message>
    <message>
        <source>Module %1 did not confirm its new group, so its group is unknown.</source>
        <translation>Le module %1 n’a pas confirmé son nouveau groupe&#xa0;: son groupe est inconnu.</translation>
    </message>
    <message>
        <source>Could not change the group of module %1.</source>
        <translation>Impossible de changer le groupe du module %1.</translation>
    </message>
    <message>
        <source>Nothing was moved. A group has at most one leader, group FF has none, and the groups of all modules must be known. Check this, then try again.</source>
        <translation>Rien n’a bougé. Un groupe a au plus un meneur, le groupe FF n’en a pas, et les groupes de tous les modules doivent être connus. Vérifiez cela, puis réessayez.</translation>
    </message>
    <message>
        <source>The command to group %1 was cancelled.</source>
        <translation>La commande au groupe %1 a été annulée.</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to group %1.</source>
        <translation>Trop de commandes attendent. Rien n’a été envoyé au groupe %1.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed saving home.</source>
        <translation>Au moins un module du groupe %1 n’a pas confirmé l’enregistrement de l’origine.</translation>
    </message>
    <message>
        <source>No motor was moved.</source>
        <translation>Aucun moteur n’a été mis en mouvement.</translation>
    </message>
    <message>
        <source>A PIC-I/O confirms latched inputs and stored PWM values only as the leader: make it the leader of the group.</source>
        <translation>Un PIC-I/O ne confirme les entrées figées et les valeurs PWM mémorisées que s’il est le meneur&#xa0;: faites-en le meneur du groupe.</translation>
    </message>
    <message>
        <source>All modules now run at %1 Bd. Positions and gains are unchanged.</source>
        <translation>Tous les modules fonctionnent maintenant à %1&#xa0;Bd. Positions et gains sont inchangés.</translation>
    </message>
    <message>
        <source>Could not change the baud rate: the chain stays at %1 Bd. No motor was moved.</source>
        <translation>Impossible de changer le débit&#xa0;: la chaîne reste à %1&#xa0;Bd. Aucun moteur n’a été mis en mouvement.</translation>
    </message>
    <message>
        <source>The modules do not support %1 Bd. Choose another baud rate.</source>
        <translation>Les modules ne prennent pas en charge %1&#xa0;Bd. Choisissez un autre débit.</translation>
    </message>
    <message>
        <source>A motor is moving, or about to move. Stop all motors, then try again.</source>
        <translation>Un moteur est en mouvement ou sur le point de l’être. Arrêtez tous les moteurs, puis réessayez.</translation>
    </message>
    <message>
        <source>Module %1 does not answer and would be left behind. Connect again first.</source>
        <translation>Le module %1 ne répond pas et resterait à l’ancien débit. Reconnectez-vous d’abord.</translation>
    </message>
    <message>
        <source>Another program may have changed the group of module %1, which would then miss the new baud rate. Set its group again, or restart the network.</source>
        <translation>Un autre programme a peut-être changé le groupe du module %1, qui n’entendrait alors pas le changement de débit. Redéfinissez son groupe, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>Module %1 is a group leader and would answer at the new baud rate. Make it an ordinary member first.</source>
        <translation>Le module %1 est meneur de groupe et répondrait au nouveau débit. Faites-en d’abord un membre ordinaire.</translation>
    </message>
    <message>
        <source>Module %2 did not answer at %1 Bd, so all modules went back to the old rate. Try another baud rate, a shorter cable, or termination at both ends.</source>
        <translation>Le module %2 n’a pas répondu à %1&#xa0;Bd&#xa0;: tous les modules sont revenus à l’ancien débit. Essayez un autre débit, un câble plus court ou une terminaison aux deux extrémités.</translation>
    </message>
    <message>
        <source>A stop took priority.</source>
        <translation>Un arrêt était prioritaire.</translation>
    </message>
    <message>
        <source>Module %1 has not answered since the baud rate changed. No motor was moving.</source>
        <translation>Le module %1 n’a pas répondu depuis le changement de débit. Aucun moteur n’était en mouvement.</translation>
    </message>
    <message>
        <source>It may still be at %1 Bd; the others are at %2 Bd. Scan again. If the module is not found, restart the network: positions and gains are lost.</source>
        <translation>Il est peut-être encore à %1&#xa0;Bd&#x202f;; les autres sont à %2&#xa0;Bd. Relancez la recherche. Si le module reste introuvable, redémarrez le réseau&#xa0;: positions et gains seront perdus.</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>text in quotation marks</source>
        <translation>du texte entre guillemets</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>un objet entre { }</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>une liste entre [ ]</translation>
    </message>
    <message>
        <source>the file is incomplete.</source>
        <translation>le fichier est incomplet.</translation>
    </message>
    <message>
        <source>this text is not UTF-8.</source>
        <translation>ce texte n’est pas en UTF-8.</translation>
    </message>
    <message>
        <source>this is not JSON.</source>
        <translation>ce n’est pas du JSON.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 n’est pas un nombre.</translation>
    </message>
    <message>
        <source>this number is too large.</source>
        <translation>ce nombre est trop grand.</translation>
    </message>
    <message>
        <source>more than %1 levels of brackets.</source>
        <translation>plus de %1 niveaux de crochets.</translation>
    </message>
    <message>
        <source>more than %1 values.</source>
        <translation>plus de %1 valeurs.</translation>
    </message>
    <message>
        <source>%1 appears twice.</source>
        <translation>%1 figure deux fois.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 manque.</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1 n’est pas %2.</translation>
    </message>
    <message>
        <source>%1 is %2; it must be %3 to %4.</source>
        <translation>%1 vaut %2&#x202f;; il faut une valeur de %3 à %4.</translation>
    </message>
    <message>
        <source>%1 has the unknown value &quot;%2&quot;.</source>
        <translation>%1 a la valeur inconnue «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>%1 has an unprintable character.</source>
        <translation>%1 contient un caractère non imprimable.</translation>
    </message>
    <message>
        <source>%1 has more than %2 entries.</source>
        <translation>%1 a plus de %2 entrées.</translation>
    </message>
    <message>
        <source>%1 has a unit that does not fit the module of this axis.</source>
        <translation>%1 a une unité qui ne convient pas au module de cet axe.</translation>
    </message>
    <message>
        <source>module %1 is already in a group.</source>
        <translation>le module %1 est déjà dans un groupe.</translation>
    </message>
    <message>
        <source>another group also has address %1.</source>
        <translation>un autre groupe a aussi l’adresse %1.</translation>
    </message>
    <message>
        <source>the leader is not one of the group&apos;s modules.</source>
        <translation>le meneur ne fait pas partie des modules du groupe.</translation>
    </message>
    <message>
        <source>There is no file %1. Check whether it was moved, or its disk is disconnected.</source>
        <translation>Le fichier %1 n’existe pas. Vérifiez s’il a été déplacé, ou si son disque est déconnecté.</translation>
    </message>
    <message>
        <source>The folder %1 does not exist. Choose another one.</source>
        <translation>Le dossier %1 n’existe pas. Choisissez-en un autre.</translation>
    </message>
    <message>
        <source>This is a folder or a device. Choose a file.</source>
        <translation>C’est un dossier ou un périphérique. Choisissez un fichier.</translation>
    </message>
    <message>
        <source>Your user account has no permission for %1. Choose another folder, or change the permissions.</source>
        <translation>Votre compte utilisateur n’a pas les droits sur %1. Choisissez un autre dossier, ou modifiez les droits.</translation>
    </message>
    <message>
        <source>The disk of %1 is read-only. Choose another folder.</source>
        <translation>Le disque de %1 est en lecture seule. Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>The disk of %1 is full. Free some space, or choose another folder.</source>
        <translation>Le disque de %1 est plein. Libérez de la place, ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>It is larger than any machine file. Check that it is the right file.</source>
        <translation>Il est plus volumineux que tout fichier machine. Vérifiez qu’il s’agit du bon fichier.</translation>
    </message>
    <message>
        <source>Another program has changed it since it was opened or saved here. Open it to see the changes, or save as another file; saving as the same one replaces it.</source>
        <translation>Un autre programme l’a modifié depuis son ouverture ou son enregistrement ici. Ouvrez-le pour voir les modifications, ou enregistrez sous un autre nom&#x202f;; sous le même nom, il est remplacé.</translation>
    </message>
    <message>
        <source>See Details for the system&apos;s message.</source>
        <translation>Le message du système se trouve dans les détails.</translation>
    </message>
    <message>
        <source>counts (steps)</source>
        <translation>incréments (pas)</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>tours</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>unité personnalisée</translation>
    </message>
    <message>
        <source>abruptly</source>
        <translation>brutal</translation>
    </message>
    <message>
        <source>smoothly</source>
        <translation>progressif</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>moteur coupé</translation>
    </message>
    <message>
        <source>an unnamed machine</source>
        <translation>une machine sans nom</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty.</source>
        <translation>«&#xa0;%1&#xa0;» est vide.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2 bytes.</source>
        <translation>«&#xa0;%1&#xa0;» dépasse %2 octets.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a machine file of NMC Panel.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un fichier machine de NMC Panel.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was written by a newer NMC Panel: its format is %2; this version reads formats up to %3.</source>
        <translation>«&#xa0;%1&#xa0;» a été écrit par un NMC Panel plus récent&#xa0;: son format est %2&#x202f;; cette version lit les formats jusqu’à %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; line %2: %3</source>
        <translation>«&#xa0;%1&#xa0;» ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Nothing was loaded.</source>
        <translation>Rien n’a été chargé.</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;.</source>
        <translation>Impossible d’ouvrir «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;. Its previous content is kept.</source>
        <translation>Impossible d’enregistrer «&#xa0;%1&#xa0;». Son contenu précédent est conservé.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;: it could not be opened again afterwards.</source>
        <translation>Impossible d’enregistrer «&#xa0;%1&#xa0;»&#xa0;: il ne pourrait plus être rouvert ensuite.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. No differences.</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert. Aucune différence.</translation>
    </message>
    <message>
        <source>Nothing was applied.</source>
        <translation>Rien n’a été appliqué.</translation>
    </message>
    <message>
        <source>Modules or settings have changed since the table was shown, so it was updated. Check it, then apply again.</source>
        <translation>Des modules ou des réglages ont changé depuis l’affichage du tableau, qui a donc été mis à jour. Vérifiez-le, puis appliquez de nouveau.</translation>
    </message>
    <message>
        <source>An earlier session left unsaved changes to %1.</source>
        <translation>Une session antérieure a laissé des modifications non enregistrées de %1.</translation>
    </message>
    <message>
        <source>If modules are connected, Restore shows what would change. Nothing is sent before you choose Apply.</source>
        <translation>Si des modules sont connectés, «&#xa0;Rétablir&#xa0;» montre ce qui changerait. Rien n’est envoyé avant «&#xa0;Appliquer&#xa0;».</translation>
    </message>
    <message>
        <source>Discard: the changes are lost</source>
        <translation>Abandonner&#xa0;: les modifications seront perdues</translation>
    </message>
    <message>
        <source>Could not recover unsaved changes of an earlier session.</source>
        <translation>Impossible de récupérer les modifications non enregistrées d’une session antérieure.</translation>
    </message>
    <message>
        <source>unsaved changes</source>
        <translation>modifications non enregistrées</translation>
    </message>
    <message>
        <source>Changes to the machine are not backed up until you save them.</source>
        <translation>Les modifications de la machine n’ont pas de copie de secours tant que vous ne les enregistrez pas.</translation>
    </message>
    <message>
        <source>%1 is not writable.</source>
        <translation>Écriture impossible dans %1.</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Enregistrer les modifications de %1&#x202f;?</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Prise d’origine</translation>
    </message>
    <message>
        <source>A/D scale</source>
        <translation>Échelle A/D</translation>
    </message>
    <message>
        <source>Names of inputs and outputs</source>
        <translation>Noms des entrées et sorties</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>Temps d’accélération</translation>
    </message>
    <message>
        <source>Limit pins</source>
        <translation>Broches de fin de course</translation>
    </message>
    <message>
        <source>Baud rate, Bd</source>
        <translation>Débit, Bd</translation>
    </message>
    <message>
        <source>Type and version</source>
        <translation>Type et version</translation>
    </message>
    <message>
        <source>Counts (steps) per unit</source>
        <translation>Incréments (pas) par unité</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Run velocity</source>
        <translation>Vitesse de marche</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>Vitesse de jog</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>Vitesse de jog max.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>On limit switch 1</source>
        <translation>Sur fin de course 1</translation>
    </message>
    <message>
        <source>On limit switch 2</source>
        <translation>Sur fin de course 2</translation>
    </message>
    <message>
        <source>On index</source>
        <translation>Sur index</translation>
    </message>
    <message>
        <source>On position error</source>
        <translation>Sur erreur de position</translation>
    </message>
    <message>
        <source>On current limit</source>
        <translation>Sur limite de courant</translation>
    </message>
    <message>
        <source>On home switch</source>
        <translation>Sur capteur d’origine</translation>
    </message>
    <message>
        <source>Then on index</source>
        <translation>Puis sur index</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Vitesse d’index</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>Course de recherche</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Durée limite</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Aller à l’origine</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>Mettre la position à 0</translation>
    </message>
    <message>
        <source>Per A/D count</source>
        <translation>Par unité A/D</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>À zéro</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>Unité A/D</translation>
    </message>
    <message>
        <source>EL, counts</source>
        <translation>EL, incréments</translation>
    </message>
    <message>
        <source>Limit 1 is an input</source>
        <translation>Fin de course 1 en entrée</translation>
    </message>
    <message>
        <source>Limit 2 is an input</source>
        <translation>Fin de course 2 en entrée</translation>
    </message>
    <message>
        <source>Limit 1 as an output</source>
        <translation>Fin de course 1 en sortie</translation>
    </message>
    <message>
        <source>Limit 2 as an output</source>
        <translation>Fin de course 2 en sortie</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>Mode de vitesse</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Vitesse minimale de profil</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>Courant de marche</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>Courant de maintien</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>Seuil thermique</translation>
    </message>
    <message>
        <source>Ignore limit switches</source>
        <translation>Ignorer les fins de course</translation>
    </message>
    <message>
        <source>Ignore E-stop input</source>
        <translation>Ignorer l’entrée E-Stop</translation>
    </message>
    <message>
        <source>Motor off on limit or E-stop input</source>
        <translation>Couper le moteur sur fin de course ou entrée E-Stop</translation>
    </message>
    <message>
        <source>Output %1</source>
        <translation>Sortie %1</translation>
    </message>
    <message>
        <source>Input %1</source>
        <translation>Entrée %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Another type of module: if any of this axis is applied, the rest is reset.</source>
        <translation>Autre type de module&#xa0;: si une partie de cet axe est appliquée, le reste est réinitialisé.</translation>
    </message>
    <message>
        <source>Changes only the panel; nothing is sent.</source>
        <translation>Ne modifie que le programme&#x202f;; rien n’est envoyé.</translation>
    </message>
    <message>
        <source>Sent to the module.</source>
        <translation>Envoyé au module.</translation>
    </message>
    <message>
        <source>Filled in, not sent: %1</source>
        <translation>Saisi, non envoyé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Filled in, not sent.</source>
        <translation>Saisi, non envoyé.</translation>
    </message>
    <message>
        <source>Not in the file: stays as it is.</source>
        <translation>Absent du fichier&#xa0;: reste tel quel.</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving: stop them before anything is sent.</source>
        <translation>
            <numerusform>%n moteur est en mouvement&#xa0;: arrêtez-le avant tout envoi.</numerusform>
            <numerusform>%n moteurs sont en mouvement&#xa0;: arrêtez-les avant tout envoi.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was stopped: its switch stayed active while backing off.</source>
        <translation>%1 a été arrêté&#xa0;: son capteur est resté actif pendant le dégagement.</translation>
    </message>
    <message>
        <source>The switch may be stuck, or the search direction is wrong. Move the motor off the switch, or change the direction, then try again.</source>
        <translation>Le capteur est peut-être bloqué, ou le sens de recherche est faux. Dégagez le moteur du capteur ou changez le sens, puis réessayez.</translation>
    </message>
    <message>
        <source>%1 stopped before it found home.</source>
        <translation>%1 s’est arrêté avant d’avoir trouvé l’origine.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion. Check the search direction and the switches, then try again.</source>
        <translation>Un fin de course ou l’entrée E-Stop a mis fin au mouvement. Vérifiez le sens de recherche et les fins de course, puis réessayez.</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the search distance.</source>
        <translation>%1 a été arrêté&#xa0;: origine introuvable dans la course de recherche.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and the search distance.</source>
        <translation>Vérifiez le capteur et son câble, le sens de recherche et la course de recherche.</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the time limit.</source>
        <translation>%1 a été arrêté&#xa0;: origine introuvable dans la durée limite.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and velocity, and the time limit.</source>
        <translation>Vérifiez le capteur et son câble, le sens et la vitesse de recherche, et la durée limite.</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: the link was unreliable.</source>
        <translation>%1 n’a pas d’origine et a reçu l’ordre d’arrêt&#xa0;: la liaison n’était pas fiable.</translation>
    </message>
    <message>
        <source>The home position found may be wrong. Check the link, then repeat the search.</source>
        <translation>L’origine trouvée peut être fausse. Vérifiez la liaison, puis répétez la recherche.</translation>
    </message>
    <message>
        <source>%1 is not homed and does not answer. Motor state unknown.</source>
        <translation>%1 n’a pas d’origine et ne répond pas. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>It was commanded to stop. Use the hardware stop if it moves.</source>
        <translation>Il a reçu l’ordre d’arrêt. Utilisez l’arrêt câblé s’il bouge.</translation>
    </message>
    <message>
        <source>%1 is not homed: its motor switched itself off and is free to turn.</source>
        <translation>%1 n’a pas d’origine&#xa0;: son moteur s’est coupé et peut tourner librement.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, enable the motor, then repeat the search.</source>
        <translation>L’erreur de position était trop grande, ou l’alimentation moteur a fait défaut. Vérifiez l’absence de blocage, activez le moteur, puis répétez la recherche.</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: a command failed, or its answer was lost.</source>
        <translation>%1 n’a pas d’origine et a reçu l’ordre d’arrêt&#xa0;: une commande a échoué, ou sa réponse s’est perdue.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Repeat the search.</source>
        <translation>Cause habituelle&#xa0;: parasites sur le câble. Répétez la recherche.</translation>
    </message>
    <message>
        <source>%1 is at rest but not homed: two readings of home differ.</source>
        <translation>%1 est à l’arrêt mais n’a pas d’origine&#xa0;: deux lectures de l’origine diffèrent.</translation>
    </message>
    <message>
        <source>%1 found home and holds close to it, but the position was not set to 0.</source>
        <translation>%1 a trouvé l’origine et maintient sa position à proximité, mais la position n’a pas été mise à 0.</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>Backing off from the active switch</source>
        <translation>Dégagement du capteur actif</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Searching for the index</source>
        <translation>Recherche de l’index</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Arrêt en cours</translation>
    </message>
    <message>
        <source>Verifying home</source>
        <translation>Vérification de l’origine</translation>
    </message>
    <message>
        <source>Going to home</source>
        <translation>Retour à l’origine</translation>
    </message>
    <message>
        <source>Setting position to 0</source>
        <translation>Mise à 0 de la position</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>Pausing</source>
        <translation>Pause en cours</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>%1 did not finish its moves.</source>
        <translation>%1 n’a pas terminé ses déplacements.</translation>
    </message>
    <message>
        <source>%1 found home at %2.</source>
        <translation>%1 a trouvé l’origine à %2.</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 sur %3</translation>
    </message>
    <message>
        <source>The switch stayed active while the motor backed off. The motor was stopped.</source>
        <translation>Le capteur est resté actif pendant le dégagement du moteur. Celui-ci a été arrêté.</translation>
    </message>
    <message>
        <source>The motion ended before home was found. Check the search direction and the switches.</source>
        <translation>Le mouvement s’est terminé avant que l’origine soit trouvée. Vérifiez le sens de recherche et les fins de course.</translation>
    </message>
    <message>
        <source>No home within the search distance. The motor was stopped.</source>
        <translation>Pas d’origine dans la course de recherche. Le moteur a été arrêté.</translation>
    </message>
    <message>
        <source>No home within the time limit. The motor was stopped.</source>
        <translation>Pas d’origine dans la durée limite. Le moteur a été arrêté.</translation>
    </message>
    <message>
        <source>The link was unreliable. The motor was commanded to stop.</source>
        <translation>La liaison n’était pas fiable. Le moteur a reçu l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>The motor switched itself off and is free to turn.</source>
        <translation>Le moteur s’est coupé et peut tourner librement.</translation>
    </message>
    <message>
        <source>A command failed or was not answered. The motor was commanded to stop.</source>
        <translation>Une commande a échoué ou est restée sans réponse. Le moteur a reçu l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>Two readings of home differ. The motor is at rest.</source>
        <translation>Deux lectures de l’origine diffèrent. Le moteur est à l’arrêt.</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its motor is off.</source>
        <translation>Le module %1 n’a pas d’alimentation moteur&#x202f;; son moteur est donc coupé.</translation>
    </message>
    <message>
        <source>Module %1 is too hot and switched its motor off.</source>
        <translation>Le module %1 est trop chaud et a coupé son moteur.</translation>
    </message>
    <message>
        <source>The A/D value fell below the thermal limit. Let the motor cool down; then check the currents and the limit on the Parameters page.</source>
        <translation>La valeur A/D est tombée sous le seuil thermique. Laissez refroidir le moteur&#x202f;; vérifiez ensuite les courants et le seuil sur la page Paramètres.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because its E-stop input is active.</source>
        <translation>Le module %1 a coupé son moteur, car son entrée E-Stop est active.</translation>
    </message>
    <message>
        <source>It stays off when the input is released.</source>
        <translation>Il reste coupé même une fois l’entrée relâchée.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because a limit switch is active.</source>
        <translation>Le module %1 a coupé son moteur, car un fin de course est actif.</translation>
    </message>
    <message>
        <source>Enable it again, then move in the other direction.</source>
        <translation>Réactivez-le, puis déplacez-le dans l’autre sens.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off by itself.</source>
        <translation>Le module %1 a coupé son moteur de lui-même.</translation>
    </message>
    <message>
        <source>The cause is unknown. Check its power and inputs, then enable it again.</source>
        <translation>La cause est inconnue. Vérifiez son alimentation et ses entrées, puis réactivez-le.</translation>
    </message>
    <message>
        <source>Amplifier off</source>
        <translation>Amplificateur coupé</translation>
    </message>
    <message>
        <source>Stopped by a limit</source>
        <translation>Arrêté par fin de course</translation>
    </message>
    <message>
        <source>Too hot</source>
        <translation>Trop chaud</translation>
    </message>
    <message>
        <source>Switched itself off</source>
        <translation>S’est coupé de lui-même</translation>
    </message>
    <message>
        <source>The module has no motor power, so its motor is off.</source>
        <translation>Le module n’a pas d’alimentation moteur&#x202f;; son moteur est donc coupé.</translation>
    </message>
    <message>
        <source>The module switched its motor off when motor power failed. It stays off.</source>
        <translation>Le module a coupé son moteur quand l’alimentation moteur a fait défaut. Il reste coupé.</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the amplifier is switched off.</source>
        <translation>Le moteur peut tourner librement. C’est normal&#xa0;: l’amplificateur est coupé.</translation>
    </message>
    <message>
        <source>A limit switch stopped the motor. It can move in the other direction.</source>
        <translation>Un fin de course a arrêté le moteur. Il peut se déplacer dans l’autre sens.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input stopped the motor, or prevents it from moving.</source>
        <translation>L’entrée E-Stop du module a arrêté le moteur, ou l’empêche de bouger.</translation>
    </message>
    <message>
        <source>The module switched its motor off because the A/D value fell below the thermal limit. It stays off.</source>
        <translation>Le module a coupé son moteur, car la valeur A/D est tombée sous le seuil thermique. Il reste coupé.</translation>
    </message>
    <message>
        <source>The module switched its motor off; the cause is unknown.</source>
        <translation>Le module a coupé son moteur&#x202f;; la cause est inconnue.</translation>
    </message>
    <message>
        <source>Load a move first.</source>
        <translation>Chargez d’abord un déplacement.</translation>
    </message>
    <message>
        <source>The position is unknown.</source>
        <translation>La position est inconnue.</translation>
    </message>
    <message>
        <source>The servo is on. Switch the motor off first.</source>
        <translation>Le servo est actif. Coupez d’abord le moteur.</translation>
    </message>
    <message>
        <source>This chip version does not support it.</source>
        <translation>Cette version de la puce ne le permet pas.</translation>
    </message>
    <message>
        <source>Select at least one home condition.</source>
        <translation>Sélectionnez au moins une condition d’origine.</translation>
    </message>
    <message>
        <source>Enter a search distance and a time limit above 0.</source>
        <translation>Saisissez une course de recherche et une durée limite supérieures à 0.</translation>
    </message>
    <message>
        <source>The limit switch is already active. Move the motor off it first.</source>
        <translation>Le fin de course est déjà actif. Dégagez-en d’abord le moteur.</translation>
    </message>
    <message>
        <source>This limit pin is set as an output.</source>
        <translation>Cette broche de fin de course est configurée en sortie.</translation>
    </message>
    <message>
        <source>Enter a distance other than 0.</source>
        <translation>Saisissez une distance différente de 0.</translation>
    </message>
    <message>
        <source>This module is not a PIC-STEP.</source>
        <translation>Ce module n’est pas un PIC-STEP.</translation>
    </message>
    <message>
        <source>Apply parameters first.</source>
        <translation>Appliquez d’abord les paramètres.</translation>
    </message>
    <message>
        <source>The amplifier is off. Enable it first.</source>
        <translation>L’amplificateur est coupé. Activez-le d’abord.</translation>
    </message>
    <message>
        <source>Stop the motor first: the chip cannot change this in motion.</source>
        <translation>Arrêtez d’abord le moteur&#xa0;: la puce ne peut pas changer cela pendant un mouvement.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input is active. Release it first.</source>
        <translation>L’entrée E-Stop du module est active. Relâchez-la d’abord.</translation>
    </message>
    <message>
        <source>The A/D value is below the thermal limit: let the motor cool down, or lower the limit.</source>
        <translation>La valeur A/D est sous le seuil thermique&#xa0;: laissez refroidir le moteur, ou abaissez le seuil.</translation>
    </message>
    <message>
        <source>The goal is too far away: at most 2 147 483 647 counts or steps.</source>
        <translation>La cible est trop éloignée&#xa0;: au plus 2&#x202f;147&#x202f;483&#x202f;647 incréments ou pas.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. Settings applied: %2.</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert. Réglages appliqués&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Commands sent: %1. No motor was moved.</source>
        <translation>Commandes envoyées&#xa0;: %1. Aucun moteur n’a été mis en mouvement.</translation>
    </message>
    <message>
        <source>Leader of group %1</source>
        <translation>Meneur du groupe %1</translation>
    </message>
    <message>
        <source>Cannot be applied: the file is for another module.</source>
        <translation>Ne peut pas être appliqué&#xa0;: le fichier concerne un autre module.</translation>
    </message>
    <message>
        <source>Not in the chain; its settings are kept.</source>
        <translation>Absent de la chaîne&#x202f;; ses réglages sont conservés.</translation>
    </message>
    <message>
        <source>%1 was stopped and holds: it moved the wrong way, or by more than twice the step.</source>
        <translation>%1 maintient de nouveau sa position&#xa0;: il a bougé dans le mauvais sens, ou de plus du double de l’échelon.</translation>
    </message>
    <message>
        <source>The servo oscillates, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.</source>
        <translation>Le servo oscille, ou autre chose fait tourner le moteur. Réduisez Kp et Ki ou augmentez Kd, puis refaites l’échelon.</translation>
    </message>
    <message>
        <source>%1 was switched off and is free to turn: it kept oscillating after its step.</source>
        <translation>%1 a été coupé et peut tourner librement&#xa0;: il n’a cessé d’osciller après son échelon.</translation>
    </message>
    <message>
        <source>The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it.</source>
        <translation>Le servo n’est pas stable avec ces gains. Réduisez Kp et Ki ou augmentez Kd, appliquez-les, puis activez-le.</translation>
    </message>
    <message>
        <source>%1 does not come to rest; its servo stays on.</source>
        <translation>%1 ne se stabilise pas&#x202f;; son servo reste actif.</translation>
    </message>
    <message>
        <source>It oscillates, or an external force turns it. Lower Kp and Ki, or raise Kd. Choose Motor off to end it at once.</source>
        <translation>Il oscille, ou une force extérieure le fait tourner. Réduisez Kp et Ki, ou augmentez Kd&#x202f;; «&#xa0;Couper le moteur&#xa0;» y met fin aussitôt.</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its motor switched itself off and is free to turn.</source>
        <translation>%1 n’a pas achevé son échelon&#xa0;: son moteur s’est coupé et peut tourner librement.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or shorten the step, then enable the motor.</source>
        <translation>L’erreur de position était trop grande, ou l’alimentation moteur a fait défaut. Vérifiez l’absence de blocage, augmentez EL ou réduisez l’échelon, puis activez le moteur.</translation>
    </message>
    <message>
        <source>%1 does not answer, so its step was not recorded. Motor state unknown.</source>
        <translation>%1 ne répond pas&#xa0;: son échelon n’a pas été enregistré. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>It was commanded to hold. Use the hardware stop if it moves.</source>
        <translation>Il a reçu l’ordre de maintien. Utilisez l’arrêt câblé s’il bouge.</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: the link was unreliable.</source>
        <translation>%1 a reçu l’ordre de maintien, et son échelon n’a pas été enregistré&#xa0;: la liaison n’était pas fiable.</translation>
    </message>
    <message>
        <source>Check the link, then step again.</source>
        <translation>Vérifiez la liaison, puis refaites l’échelon.</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: a command failed, or its answer was lost.</source>
        <translation>%1 a reçu l’ordre de maintien, et son échelon n’a pas été enregistré&#xa0;: une commande a échoué, ou sa réponse s’est perdue.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Step again.</source>
        <translation>Cause habituelle&#xa0;: parasites sur le câble. Refaites l’échelon.</translation>
    </message>
    <message>
        <source>The motor does not come to rest; its servo stays on. Lower the gains, or switch the motor off.</source>
        <translation>Le moteur ne se stabilise pas&#x202f;; son servo reste actif. Réduisez les gains, ou coupez le moteur.</translation>
    </message>
    <message>
        <source>The motor kept oscillating by more than the whole step. It was switched off and is free to turn. Lower Kp and Ki, or raise Kd.</source>
        <translation>Le moteur n’a cessé d’osciller, avec une amplitude supérieure à l’échelon. Il a été coupé et peut tourner librement. Réduisez Kp et Ki, ou augmentez Kd.</translation>
    </message>
    <message>
        <source>its folder does not exist.</source>
        <translation>son dossier n’existe pas.</translation>
    </message>
    <message>
        <source>this is a folder or a device, not a file.</source>
        <translation>c’est un dossier ou un périphérique, pas un fichier.</translation>
    </message>
    <message>
        <source>your user account has no write access.</source>
        <translation>votre compte utilisateur n’a pas le droit d’y écrire.</translation>
    </message>
    <message>
        <source>the disk is read-only.</source>
        <translation>le disque est en lecture seule.</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>le disque est plein.</translation>
    </message>
    <message>
        <source>the file is too large for the disk.</source>
        <translation>le fichier est trop volumineux pour le disque.</translation>
    </message>
    <message>
        <source>the file was deleted.</source>
        <translation>le fichier a été supprimé.</translation>
    </message>
    <message>
        <source>the disk is too slow.</source>
        <translation>le disque est trop lent.</translation>
    </message>
    <message>
        <source>the disk reported a write error.</source>
        <translation>le disque a signalé une erreur d’écriture.</translation>
    </message>
    <message>
        <source>the file ends before its column names.</source>
        <translation>le fichier se termine avant les noms de ses colonnes.</translation>
    </message>
    <message>
        <source>column %1 is missing.</source>
        <translation>la colonne %1 manque.</translation>
    </message>
    <message>
        <source>the line is longer than %1 bytes, too long for a recording.</source>
        <translation>la ligne dépasse %1 octets&#xa0;: trop longue pour un enregistrement.</translation>
    </message>
    <message>
        <source>the file ends in the middle of this line.</source>
        <translation>le fichier se termine au milieu de cette ligne.</translation>
    </message>
    <message>
        <source>the line has %1 cells for %2 columns.</source>
        <translation>la ligne a %1 cellules pour %2 colonnes.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 est vide.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is not a number.</source>
        <translation>%1 vaut «&#xa0;%2&#xa0;», ce qui n’est pas un nombre.</translation>
    </message>
    <message>
        <source>%1 of module %2 goes backwards.</source>
        <translation>%1 du module %2 recule.</translation>
    </message>
    <message>
        <source>Recorded &quot;%1&quot;: %2.</source>
        <translation>«&#xa0;%1&#xa0;» enregistré&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Enregistré dans %1.</translation>
    </message>
    <message>
        <source>The part written before (%1) is kept.</source>
        <translation>La partie déjà écrite (%1) est conservée.</translation>
    </message>
    <message>
        <source>Nothing was kept.</source>
        <translation>Rien n’a été conservé.</translation>
    </message>
    <message>
        <source>Nothing is recorded to &quot;%1&quot;: no module is connected.</source>
        <translation>Rien n’est enregistré dans «&#xa0;%1&#xa0;»&#xa0;: aucun module n’est connecté.</translation>
    </message>
    <message>
        <source>Connect first, then record again.</source>
        <translation>Connectez d’abord, puis enregistrez de nouveau.</translation>
    </message>
    <message>
        <source>Recording to &quot;%1&quot; stopped: %2</source>
        <translation>L’enregistrement dans «&#xa0;%1&#xa0;» s’est arrêté&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 Motor control continues. To continue recording, choose another file.</source>
        <translation>%1 La commande des moteurs continue. Pour continuer l’enregistrement, choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a recording of NMC Panel.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un enregistrement de NMC Panel.</translation>
    </message>
    <message>
        <source>It has nothing to show. Choose another file.</source>
        <translation>Il ne contient rien à afficher. Choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>The scope shows the samples above that line: %1.</source>
        <translation>L’oscilloscope affiche les échantillons qui précèdent cette ligne&#xa0;: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no samples.</source>
        <translation>«&#xa0;%1&#xa0;» ne contient aucun échantillon.</translation>
    </message>
    <message>
        <source>Saved &quot;%1&quot;.</source>
        <translation>«&#xa0;%1&#xa0;» enregistré.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;.</source>
        <translation>Impossible d’enregistrer «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Show the last 2 s</source>
        <translation>Afficher les 2 dernières secondes</translation>
    </message>
    <message>
        <source>Stop of all motors</source>
        <translation>Arrêt de tous les moteurs</translation>
    </message>
    <message>
        <source>Too far for a step response: at most 2000 counts.</source>
        <translation>Trop loin pour une réponse indicielle&#xa0;: au plus 2000 incréments.</translation>
    </message>
    <message>
        <source>The goal is outside the chip&apos;s position range.</source>
        <translation>La cible est hors de la plage de positions de la puce.</translation>
    </message>
    <message>
        <source>A record must be 0.02 s to 3 s long.</source>
        <translation>Un enregistrement doit durer de 0,02&#xa0;s à 3&#xa0;s.</translation>
    </message>
    <message>
        <source>No motor is moving. All motors are commanded to stop before the port closes.</source>
        <translation>Aucun moteur n’est en mouvement. Tous reçoivent l’ordre d’arrêt avant la fermeture du port.</translation>
    </message>
    <message>
        <source>Nothing was lost: the panel detects wrong answers and retries. If it gets worse, motors are commanded to stop. Usually noise on the cable.</source>
        <translation>Rien n’est perdu&#xa0;: le programme détecte les réponses fausses et redemande. Si cela empire, les moteurs reçoivent l’ordre d’arrêt. Cause habituelle&#xa0;: parasites sur le câble.</translation>
    </message>
    <message>
        <source>It listens at 19 200 Bd and may misread the other modules&apos; traffic: all motors were commanded to stop, and sending has stopped.</source>
        <translation>Il écoute à 19&#x202f;200&#xa0;Bd et peut mal interpréter le trafic des autres modules&#xa0;: tous les moteurs ont reçu l’ordre d’arrêt, et plus rien n’est envoyé.</translation>
    </message>
    <message>
        <source>The panel froze for %1; motors were commanded to stop after 2 s.</source>
        <translation>Le programme est resté figé pendant %1&#x202f;; les moteurs ont reçu l’ordre d’arrêt au bout de 2&#xa0;s.</translation>
    </message>
    <message>
        <source>It was connected to %1 and was killed, or the computer failed. Motor state unknown: look at the motor before you connect; use the hardware stop if it moves. This message stays until the motor is seen at rest.</source>
        <translation>Elle était connectée à %1 et a été interrompue de force, ou l’ordinateur est tombé en panne. État du moteur inconnu&#xa0;: regardez le moteur avant de vous connecter&#x202f;; utilisez l’arrêt câblé s’il bouge. Ce message reste affiché jusqu’à ce que le moteur soit vu à l’arrêt.</translation>
    </message>
    <message>
        <source>I have checked: it is at rest</source>
        <translation>J’ai vérifié&#xa0;: il est à l’arrêt</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 do not answer</source>
        <translation>
            <numerusform>Le module %1 ne répond pas</numerusform>
            <numerusform>Les modules %1 ne répondent pas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 are off after a restart.</source>
        <translation>
            <numerusform>Le module %1 est coupé depuis un redémarrage.</numerusform>
            <numerusform>Les modules %1 sont coupés depuis un redémarrage.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop but were not seen at rest</source>
        <translation>
            <numerusform>Le module %1 a reçu l’ordre d’arrêt mais n’a pas été vu à l’arrêt</numerusform>
            <numerusform>Les modules %1 ont reçu l’ordre d’arrêt mais n’ont pas été vus à l’arrêt</numerusform>
        </translation>
    </message>
    <message>
        <source>You can assign just its address: the other modules keep their positions and gains.</source>
        <translation>Vous pouvez attribuer seulement son adresse&#xa0;: les autres modules gardent leurs positions et leurs gains.</translation>
    </message>
    <message>
        <source>Assign the address of module %1</source>
        <translation>Attribuer l’adresse du module %1</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no gains.</source>
        <translation>Le module %1 a retrouvé son adresse. Son moteur est coupé, sa position est 0 et il n’a pas de gains.</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its pins are inputs, and its outputs drive nothing.</source>
        <translation>Le module %1 a retrouvé son adresse. Ses broches sont des entrées et ses sorties ne pilotent rien.</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no parameters.</source>
        <translation>Le module %1 a retrouvé son adresse. Son moteur est coupé, sa position est 0 et il n’a pas de paramètres.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its gains and home it before you use it.</source>
        <translation>Les autres modules sont inchangés. Appliquez ses gains et faites la prise d’origine avant de l’utiliser.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Set its outputs again before you use it.</source>
        <translation>Les autres modules sont inchangés. Réglez de nouveau ses sorties avant de l’utiliser.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its parameters and home it before you use it.</source>
        <translation>Les autres modules sont inchangés. Appliquez ses paramètres et faites la prise d’origine avant de l’utiliser.</translation>
    </message>
    <message>
        <source>Could not assign the address of module %1. No motor was moved.</source>
        <translation>Impossible d’attribuer l’adresse du module %1. Aucun moteur n’a été mis en mouvement.</translation>
    </message>
    <message>
        <source>The module does not answer. Scan again, or restart the network.</source>
        <translation>Le module ne répond pas. Relancez la recherche, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>No module is known</source>
        <translation>Aucun module n’est connu</translation>
    </message>
    <message>
        <source>: use the hardware stop.</source>
        <translation>&#xa0;: utilisez l’arrêt câblé.</translation>
    </message>
    <message>
        <source>No stop was confirmed.</source>
        <translation>Aucun arrêt n’a été confirmé.</translation>
    </message>
    <message>
        <source>%1 of %2 stopped.</source>
        <translation>Arrêtés&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>Module %1 has stopped.</source>
        <translation>Le module %1 s’est arrêté.</translation>
    </message>
    <message>
        <source>It has stopped.</source>
        <translation>Il s’est arrêté.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: nothing held it for over 250 ms.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêter le jog&#xa0;: rien ne l’a maintenu pendant plus de 250&#xa0;ms.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: it did not confirm the command.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêter le jog&#xa0;: il n’a pas confirmé la commande.</translation>
    </message>
    <message>
        <source>Module %1 did not confirm the command to jog. Nothing was started.</source>
        <translation>Le module %1 n’a pas confirmé la commande de jog. Rien n’a été démarré.</translation>
    </message>
    <message>
        <source>The command or its answer was lost or garbled: if this recurs, check the cable. Press and hold again.</source>
        <translation>La commande ou sa réponse s’est perdue ou a été altérée&#xa0;: si cela se répète, vérifiez le câble. Appuyez de nouveau et maintenez.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its state no longer permits it.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêter le jog&#xa0;: son état ne le permet plus.</translation>
    </message>
    <message>
        <source>Module %1 cannot jog in its present state. Nothing was started.</source>
        <translation>Le module %1 ne peut pas faire de jog dans son état actuel. Rien n’a été démarré.</translation>
    </message>
    <message>
        <source>Its state says why: for example, its motor is off. Press and hold again once it may move.</source>
        <translation>Son état dit pourquoi&#xa0;: par exemple, son moteur est coupé. Appuyez de nouveau et maintenez dès qu’il peut se déplacer.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its travel limit has changed.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêter le jog&#xa0;: sa limite de course a changé.</translation>
    </message>
    <message>
        <source>Press and hold again to jog within the present limits.</source>
        <translation>Appuyez de nouveau et maintenez pour continuer le jog dans les limites actuelles.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: it reports motion, but its position stays at %2 counts.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêt&#xa0;: il signale un mouvement, mais sa position reste à %2 incréments.</translation>
    </message>
    <message>
        <source>Overcurrent: module %1 limits its motor current.</source>
        <translation>Surintensité&#xa0;: le module %1 limite le courant de son moteur.</translation>
    </message>
    <message>
        <source>The motor may fail to reach its goal or hold its load. Check for a jam or too heavy a load, or raise the limit. This message stays until you clear the sticky bits.</source>
        <translation>Le moteur peut ne pas atteindre sa cible ou ne pas tenir sa charge. Vérifiez l’absence de blocage ou de charge excessive, ou augmentez la limite. Ce message reste affiché jusqu’à l’effacement des bits mémorisés.</translation>
    </message>
    <message>
        <source>Off, but turning</source>
        <translation>Coupé, mais tourne</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>Surintensité</translation>
    </message>
    <message>
        <source>The shaft moves while the motor is off: a load turns it, or it is still coasting. A stop cannot hold it; use a brake, or enable the servo.</source>
        <translation>L’arbre tourne alors que le moteur est coupé&#xa0;: une charge l’entraîne, ou il continue sur sa lancée. Un arrêt ne peut pas le retenir&#x202f;; utilisez un frein, ou activez le servo.</translation>
    </message>
    <message>
        <source>The motor is at rest, but its current was limited: it may not hold its load. This stays until you clear the sticky bits.</source>
        <translation>Le moteur est à l’arrêt, mais son courant a été limité&#xa0;: il peut ne pas tenir sa charge. Cet état persiste jusqu’à l’effacement des bits mémorisés.</translation>
    </message>
    <message numerus="yes">
        <source>The panel ended without stopping its motors; its guardian commanded modules %1 to stop.</source>
        <translation>
            <numerusform>Le programme s’est terminé sans arrêter ses moteurs&#x202f;; son gardien a donné l’ordre d’arrêt au module %1.</numerusform>
            <numerusform>Le programme s’est terminé sans arrêter ses moteurs&#x202f;; son gardien a donné l’ordre d’arrêt aux modules %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program was killed, or it hung. The guardian cannot see whether a motor stopped: look at the motors before you connect; use the hardware stop if one moves.</source>
        <translation>Le programme a été fermé de force ou s’est bloqué. Le gardien ne peut pas voir si un moteur s’est arrêté&#xa0;: regardez les moteurs avant de vous connecter&#x202f;; utilisez l’arrêt câblé si l’un d’eux bouge.</translation>
    </message>
    <message>
        <source>The panel stalled while a motor was moving; its guardian commanded the motors to stop.</source>
        <translation>Le programme s’est figé alors qu’un moteur était en mouvement&#x202f;; son gardien a donné l’ordre d’arrêt aux moteurs.</translation>
    </message>
    <message>
        <source>The program was halted, or the computer was too busy. The panel is reading all values again.</source>
        <translation>Le programme a été suspendu, ou l’ordinateur était trop occupé. Le programme relit toutes les valeurs.</translation>
    </message>
    <message>
        <source>No guardian: if this program is killed, nothing stops the motors.</source>
        <translation>Pas de gardien&#xa0;: si ce programme est fermé de force, rien n’arrête les moteurs.</translation>
    </message>
    <message>
        <source>nmcguard is missing. Reinstall the program. Everything else works.</source>
        <translation>nmcguard est absent. Réinstallez le programme. Tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>Your user account has no permission to start nmcguard. Reinstall the program. Everything else works.</source>
        <translation>Votre compte utilisateur n’a pas le droit de lancer nmcguard. Réinstallez le programme. Tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>nmcguard and this program have different versions. Reinstall both. Everything else works.</source>
        <translation>nmcguard et ce programme ont des versions différentes. Réinstallez les deux. Tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>The computer ran out of memory or open files. Close other programs, then connect again. Everything else works.</source>
        <translation>L’ordinateur manque de mémoire ou de fichiers ouverts. Fermez d’autres programmes, puis reconnectez-vous. Tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>The guardian ended unexpectedly. Connect again to restart it. Everything else works.</source>
        <translation>Le gardien s’est terminé de façon inattendue. Reconnectez-vous pour le relancer. Tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses power, a running motor keeps running, and no program can stop it. STOP ALL and Esc work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs.</source>
        <translation>Ces modules n’ont pas de chien de garde de liaison&#xa0;: si le câble est coupé, si l’adaptateur se bloque ou si cet ordinateur n’est plus alimenté, un moteur en mouvement continue, et aucun programme ne peut l’arrêter. TOUT ARRÊTER et Esc n’agissent que tant que la liaison fonctionne. Un gardien arrête les moteurs si ce programme est fermé de force, plante ou se bloque.</translation>
    </message>
    <message>
        <source>Use --serve alone or as --serve=control.</source>
        <translation>--serve s’emploie seul ou avec =control.</translation>
    </message>
    <message>
        <source>--read-only requires --port or --simulator.</source>
        <translation>--read-only exige --port ou --simulator.</translation>
    </message>
    <message>
        <source>Module %1 of this chain does not answer. Motor state unknown.</source>
        <translation>Le module %1 de cette chaîne ne répond pas. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>Check its power and the plug next to it; the panel keeps trying. If you removed it on purpose, work with the others: the panel then forgets it and its settings.</source>
        <translation>Vérifiez son alimentation et le connecteur voisin&#x202f;; le programme continue d’essayer. Si vous l’avez retiré volontairement, travaillez avec les autres&#xa0;: le programme l’oublie alors, avec ses réglages.</translation>
    </message>
    <message>
        <source>A motor is moving, so the chain was not changed.</source>
        <translation>Un moteur est en mouvement&#xa0;: la chaîne n’a pas été modifiée.</translation>
    </message>
    <message>
        <source>Forgetting a module rescans the chain. Stop all motors, then try again.</source>
        <translation>Oublier un module relance la recherche dans la chaîne. Arrêtez tous les moteurs, puis réessayez.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses module %3, so the chain was not changed.</source>
        <translation>La ligne %1 de «&#xa0;%2&#xa0;» utilise le module %3&#xa0;: la chaîne n’a pas été modifiée.</translation>
    </message>
    <message>
        <source>The row is for another type of module than the one found there. Change or remove it first, then try again.</source>
        <translation>La ligne est destinée à un autre type de module que celui trouvé à cette place. Modifiez-la ou supprimez-la d’abord, puis réessayez.</translation>
    </message>
    <message>
        <source>Forgetting a module removes its axis from the machine. Change or remove that row first, then try again.</source>
        <translation>Oublier un module retire son axe de la machine. Modifiez ou supprimez d’abord cette ligne, puis réessayez.</translation>
    </message>
    <message>
        <source>Connected to %1 read-only: %2 at %3 Bd, left running.</source>
        <translation>Connecté à %1 en lecture seule&#xa0;: %2 à %3&#xa0;Bd, sans rien arrêter.</translation>
    </message>
    <message>
        <source>The modules carry on, even after you disconnect. Only status requests are sent. STOP ALL still works.</source>
        <translation>Les modules continuent ce qu’ils font, même après votre déconnexion. Seules des demandes d’état sont envoyées. TOUT ARRÊTER fonctionne toujours.</translation>
    </message>
    <message>
        <source>A port is already open.</source>
        <translation>Un port est déjà ouvert.</translation>
    </message>
    <message>
        <source>Disconnect first, then try again. Closing the port may stop motors.</source>
        <translation>Déconnectez-vous d’abord, puis réessayez. La fermeture du port peut arrêter les moteurs.</translation>
    </message>
    <message numerus="yes">
        <source>Motors %1 were moving, at %2.</source>
        <translation>
            <numerusform>Le moteur %1 était en mouvement, sur %2.</numerusform>
            <numerusform>Les moteurs %1 étaient en mouvement, sur %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>This message stays until the motor is seen at rest.</source>
        <translation>Ce message reste affiché jusqu’à ce que le moteur soit vu à l’arrêt.</translation>
    </message>
    <message>
        <source>Look first (read-only)</source>
        <translation>Voir d’abord (lecture seule)</translation>
    </message>
    <message>
        <source>This connection is read-only. Connect fully first.</source>
        <translation>Cette connexion est en lecture seule. Établissez d’abord une connexion complète.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, read-only</source>
        <translation>Connecté à %1 à %2&#xa0;Bd, %3, lecture seule</translation>
    </message>
    <message>
        <source>Only the adapter&apos;s echo came back from %1: no module answered.</source>
        <translation>Seul l’écho de l’adaptateur est revenu de %1&#xa0;: aucun module n’a répondu.</translation>
    </message>
    <message>
        <source>The echo is harmless. Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the modules&apos; transmit pair is wired to the adapter.</source>
        <translation>L’écho est sans danger. Vérifiez dans cet ordre&#xa0;: l’alimentation des modules&#x202f;; chaque câble de la chaîne, car un seul câble débranché masque tous les modules&#x202f;; que la paire d’émission des modules est raccordée à l’adaptateur.</translation>
    </message>
    <message>
        <source>The adapter at %1 echoes everything it sends. The panel ignores the echo.</source>
        <translation>L’adaptateur sur %1 renvoie en écho tout ce qu’il émet. Le programme ignore l’écho.</translation>
    </message>
    <message>
        <source>This is normal for a 2-wire adapter. No action needed.</source>
        <translation>C’est normal pour un adaptateur 2 fils. Rien à faire.</translation>
    </message>
    <message>
        <source>no exact echo of the command before it</source>
        <translation>pas d’écho exact de la commande qui précède</translation>
    </message>
    <message>
        <source>Another host is sending on this line.</source>
        <translation>Un autre hôte émet sur cette ligne.</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop.</source>
        <translation>
            <numerusform>Le module %1 a reçu l’ordre d’arrêt.</numerusform>
            <numerusform>Les modules %1 ont reçu l’ordre d’arrêt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Modules answer commands that this panel did not send; running tasks were cancelled. Close the other program, or disconnect its computer from the line, before you continue.</source>
        <translation>Des modules répondent à des commandes que ce programme n’a pas envoyées&#x202f;; les tâches en cours ont été annulées. Avant de continuer, fermez l’autre programme ou déconnectez son ordinateur de la ligne.</translation>
    </message>
    <message>
        <source>Module %1 moves without a command from this panel.</source>
        <translation>Le module %1 bouge sans commande de ce programme.</translation>
    </message>
    <message>
        <source>Another host on this line started it, or a load drives it. The panel does not stop it unless you do; the other host may start it again.</source>
        <translation>Un autre hôte de cette ligne l’a démarré, ou une charge l’entraîne. Le programme ne l’arrête pas de lui-même&#xa0;: à vous de le faire&#x202f;; l’autre hôte peut le redémarrer.</translation>
    </message>
    <message>
        <source>Home is unknown: search for it, or save it.</source>
        <translation>L’origine est inconnue&#xa0;: recherchez-la, ou enregistrez-la.</translation>
    </message>
    <message>
        <source>Friction holds it %1 off home, too far to set the position to 0. Raise Ki and IL on the Gains page, or clear &quot;Set position to 0&quot; on the Homing page. The tolerance follows from the unit on the Axis page.</source>
        <translation>Le frottement le retient à %1 de l’origine, trop loin pour mettre la position à 0. Augmentez Ki et IL sur la page Gains, ou décochez «&#xa0;Mettre la position à 0&#xa0;» sur la page Prise d’origine. La tolérance découle de l’unité choisie sur la page Axe.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor is off.</source>
        <translation>Contrôle de sens de %1 non concluant&#x202f;; son moteur est coupé.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor was commanded to switch off.</source>
        <translation>Contrôle de sens de %1 non concluant&#x202f;; il a reçu l’ordre de couper son moteur.</translation>
    </message>
    <message>
        <source>It turned farther than the check allows: something else turns it, or it coasts for a long time. Wait until it is at rest, then check again.</source>
        <translation>Il a tourné plus que le contrôle ne le permet&#xa0;: autre chose le fait tourner, ou il continue longtemps sur sa lancée. Attendez qu’il soit à l’arrêt, puis refaites le contrôle.</translation>
    </message>
    <message>
        <source>It does not come to rest although nothing drives it. Find what turns it, then check again.</source>
        <translation>Il ne s’immobilise pas alors que rien ne l’entraîne. Cherchez ce qui le fait tourner, puis refaites le contrôle.</translation>
    </message>
    <message>
        <source>The link was unreliable. Check the link, then repeat the direction check.</source>
        <translation>La liaison n’était pas fiable. Vérifiez la liaison, puis refaites le contrôle de sens.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive: it does not answer. Motor state unknown.</source>
        <translation>Contrôle de sens de %1 non concluant&#xa0;: il ne répond pas. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>It was commanded to switch off. Use the hardware stop if it moves.</source>
        <translation>Il a reçu l’ordre de couper son moteur. Utilisez l’arrêt câblé s’il bouge.</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Repeat the direction check.</source>
        <translation>Une commande a échoué, ou sa réponse s’est perdue. Refaites le contrôle de sens.</translation>
    </message>
    <message>
        <source>%1: motor and encoder directions match.</source>
        <translation>%1&#xa0;: les sens du moteur et du codeur concordent.</translation>
    </message>
    <message>
        <source>%1: motor or encoder is reversed. Do not enable it.</source>
        <translation>%1&#xa0;: moteur ou codeur inversé. Ne l’activez pas.</translation>
    </message>
    <message>
        <source>%1 did not move when driven.</source>
        <translation>%1 n’a pas bougé sous les impulsions.</translation>
    </message>
    <message>
        <source>%1 closed a limit switch; the check has ended.</source>
        <translation>%1 a fermé un fin de course&#x202f;; les impulsions ont donc été interrompues.</translation>
    </message>
    <message>
        <source>%1 lost motor power while being driven.</source>
        <translation>%1 a perdu l’alimentation moteur pendant les impulsions.</translation>
    </message>
    <message>
        <source>%1 did not move in both directions.</source>
        <translation>%1 n’a pas bougé dans les deux sens.</translation>
    </message>
    <message>
        <source>It is at rest %1 from home; its position there is 0.</source>
        <translation>Il s’est arrêté à %1 de l’origine&#x202f;; sa position est 0 à cet endroit.</translation>
    </message>
    <message>
        <source>It rests too far from home to set the position to 0. Raise Ki and IL on the Gains page.</source>
        <translation>Il s’est arrêté trop loin de l’origine pour mettre la position à 0. Augmentez Ki et IL sur la page Gains.</translation>
    </message>
    <message>
        <source>OK: it counts up when driven forward and down in reverse. You can enable it.</source>
        <translation>OK&#xa0;: la position augmente en marche avant et diminue en marche arrière. Vous pouvez l’activer.</translation>
    </message>
    <message>
        <source>Reversed: it counts down when driven forward and would run away when enabled. Swap the two motor leads, or encoder A and B, then check again.</source>
        <translation>Inversé&#xa0;: la position diminue en marche avant et il s’emballerait une fois activé. Permutez les deux fils du moteur, ou A et B du codeur, puis refaites le contrôle.</translation>
    </message>
    <message>
        <source>No movement at %1 % of the supply, with motor power present. Check for a jam, a brake or too heavy a load, and check the motor and encoder cables.</source>
        <translation>Aucun mouvement à %1&#x202f;% de la tension, alimentation moteur présente. Vérifiez l’absence de blocage, de frein ou de charge excessive, ainsi que les câbles du moteur et du codeur.</translation>
    </message>
    <message>
        <source>A limit switch is active: it may cut the motor&apos;s power.</source>
        <translation>Un fin de course est actif&#xa0;: il coupe peut-être l’alimentation du moteur.</translation>
    </message>
    <message>
        <source>Limit switch 1 closed during the move.</source>
        <translation>Le fin de course 1 s’est fermé pendant le déplacement.</translation>
    </message>
    <message>
        <source>Limit switch 2 closed during the move.</source>
        <translation>Le fin de course 2 s’est fermé pendant le déplacement.</translation>
    </message>
    <message>
        <source>Turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>Éloignez le moteur de l’extrémité de sa course à la main, puis refaites le contrôle.</translation>
    </message>
    <message>
        <source>Motor power failed. Switch it on, then check again.</source>
        <translation>L’alimentation moteur a fait défaut. Rétablissez-la, puis refaites le contrôle.</translation>
    </message>
    <message>
        <source>Unclear: it moved in one direction only, or twice in the same direction. Something blocks or turns it. Remove the load, turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>Non concluant&#xa0;: il n’a bougé que dans un sens, ou deux fois dans le même. Quelque chose le bloque ou le fait tourner. Retirez la charge, éloignez le moteur de l’extrémité de sa course à la main, puis refaites le contrôle.</translation>
    </message>
    <message>
        <source>Check for a jam, or raise EL on the Gains page.</source>
        <translation>Vérifiez l’absence de blocage, ou augmentez EL sur la page Gains.</translation>
    </message>
    <message>
        <source>It ran away from its goal: motor or encoder is probably reversed. Run the direction check on the Axis page before you enable it again.</source>
        <translation>Il s’est éloigné de sa cible en s’emballant&#xa0;: moteur ou codeur probablement inversé. Faites le contrôle de sens sur la page Axe avant de le réactiver.</translation>
    </message>
    <message>
        <source>It was driven but did not move: check for a jam, a brake or a hard stop, and check the motor cable. If it is only hard to turn, raise OL on the Gains page.</source>
        <translation>Il était commandé mais n’a pas bougé&#xa0;: vérifiez l’absence de blocage, de frein ou de butée mécanique, et vérifiez le câble du moteur. S’il est seulement dur à tourner, augmentez OL sur la page Gains.</translation>
    </message>
    <message>
        <source>Limit switch 1 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>Le fin de course 1 s’est fermé&#xa0;: il est probablement en bout de course. Déplacez-le dans l’autre sens. Pour un arrêt à temps, armez un arrêt sur fin de course sur la page Prise d’origine.</translation>
    </message>
    <message>
        <source>Limit switch 2 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>Le fin de course 2 s’est fermé&#xa0;: il est probablement en bout de course. Déplacez-le dans l’autre sens. Pour un arrêt à temps, armez un arrêt sur fin de course sur la page Prise d’origine.</translation>
    </message>
    <message>
        <source>It moved correctly but could not keep up: lower its velocity or acceleration, or raise OL and EL on the Gains page.</source>
        <translation>Il se déplaçait correctement mais n’a pas pu suivre&#xa0;: réduisez sa vitesse ou son accélération, ou augmentez OL et EL sur la page Gains.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving.</source>
        <translation>Le fin de course %1 du module %2 s’est fermé alors que son moteur était en mouvement.</translation>
    </message>
    <message>
        <source>While the switch is closed, the module blocks this direction. Move the motor the other way.</source>
        <translation>Tant que le fin de course est fermé, le module bloque ce sens. Déplacez le moteur dans l’autre sens.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving, but does not stop it.</source>
        <translation>Le fin de course %1 du module %2 s’est fermé alors que son moteur était en mouvement, mais ne l’arrête pas.</translation>
    </message>
    <message>
        <source>A PIC-SERVO stops at a limit switch only while a limit stop is armed. Stop the motor, then move it the other way. Arm a limit stop on the Homing page.</source>
        <translation>Un PIC-SERVO ne s’arrête sur un fin de course que si un arrêt sur fin de course est armé. Arrêtez le moteur, puis déplacez-le dans l’autre sens. Armez un arrêt sur fin de course sur la page Prise d’origine.</translation>
    </message>
    <message>
        <source>The limit stop of module %1 switched its motor off.</source>
        <translation>L’arrêt sur fin de course du module %1 a coupé son moteur.</translation>
    </message>
    <message>
        <source>The limit stop of module %1 stopped its motor.</source>
        <translation>L’arrêt sur fin de course du module %1 a arrêté son moteur.</translation>
    </message>
    <message>
        <source>A limit stop acts once. Move the motor off the switch, then arm or disarm the limit stop on the Homing page.</source>
        <translation>Un arrêt sur fin de course n’agit qu’une fois. Dégagez le moteur du fin de course, puis armez ou désarmez l’arrêt sur fin de course sur la page Prise d’origine.</translation>
    </message>
    <message>
        <source>Saving %1. The window closes when it is saved.</source>
        <translation>Enregistrement de %1. La fenêtre se ferme dès qu’il est terminé.</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 was moving.</source>
        <translation>État du moteur inconnu&#xa0;: %1 était en mouvement.</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 were moving.</source>
        <translation>État des moteurs inconnu&#xa0;: %1 étaient en mouvement.</translation>
    </message>
    <message>
        <source>Operator permissions</source>
        <translation>Permis à l’opérateur</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Activer</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Jog</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>Points et séquences</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Déplacements</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>Module %1 was %2 from home when last seen.</source>
        <translation>Le module %1 était à %2 de l’origine à la dernière lecture.</translation>
    </message>
    <message>
        <source>That was on %1; a search had found home. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>C’était le %1&#x202f;; une recherche avait trouvé l’origine. Si rien n’a déplacé l’axe depuis, vous pouvez rétablir l’origine à partir de cette position. Elle reste non vérifiée jusqu’à la prochaine recherche.</translation>
    </message>
    <message>
        <source>That was on %1; home had been saved. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>C’était le %1&#x202f;; l’origine avait été enregistrée. Si rien n’a déplacé l’axe depuis, vous pouvez rétablir l’origine à partir de cette position. Elle reste non vérifiée jusqu’à la prochaine recherche.</translation>
    </message>
    <message>
        <source>That was on %1; the position had been confirmed. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>C’était le %1&#x202f;; la position avait été confirmée. Si rien n’a déplacé l’axe depuis, vous pouvez rétablir l’origine à partir de cette position. Elle reste non vérifiée jusqu’à la prochaine recherche.</translation>
    </message>
    <message>
        <source>Restore home</source>
        <translation>Rétablir l’origine</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Messages are lost when this session ends.</source>
        <translation>Les messages sont perdus à la fin de cette session.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. To keep messages, export the message list.</source>
        <translation>Écriture impossible dans %1. Tout le reste fonctionne. Pour conserver les messages, exportez la liste des messages.</translation>
    </message>
    <message>
        <source>What led to that message is no longer kept.</source>
        <translation>Ce qui a mené à ce message n’est plus conservé.</translation>
    </message>
    <message>
        <source>The last %1 faults and stops can be shown. A recording keeps everything.</source>
        <translation>Les %1 derniers défauts et arrêts peuvent être affichés. Un enregistrement conserve tout.</translation>
    </message>
    <message>
        <source>The positions of the axes are not saved.</source>
        <translation>Les positions des axes ne sont pas enregistrées.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. If the modules lose power now, search for home again: an older position may be offered.</source>
        <translation>Écriture impossible dans %1. Tout le reste fonctionne. Si les modules perdent maintenant leur alimentation, relancez la prise d’origine&#xa0;: une position plus ancienne peut être proposée.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 stopped its motor.</source>
        <translation>Le fin de course %1 du module %2 a arrêté son moteur.</translation>
    </message>
    <message>
        <source>The E-stop input of module %1 is active: its motor is on but cannot move.</source>
        <translation>L’entrée E-Stop du module %1 est active&#xa0;: son moteur est activé mais ne peut pas bouger.</translation>
    </message>
    <message>
        <source>Release the input. This does not start a motion.</source>
        <translation>Relâchez l’entrée. Cela ne démarre aucun mouvement.</translation>
    </message>
    <message>
        <source>Not allowed in operator mode. Leave operator mode first.</source>
        <translation>Interdit en mode opérateur. Quittez d’abord le mode opérateur.</translation>
    </message>
    <message>
        <source>Load the move first, then choose Start: this way a garbled load never moves the motor.</source>
        <translation>Chargez d’abord le déplacement, puis choisissez «&#xa0;Démarrer&#xa0;»&#xa0;: ainsi, un chargement altéré ne fait jamais bouger le moteur.</translation>
    </message>
    <message>
        <source>it has no name.</source>
        <translation>il n’a pas de nom.</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is already used.</source>
        <translation>le nom «&#xa0;%1&#xa0;» est déjà utilisé.</translation>
    </message>
    <message>
        <source>module %1 appears twice.</source>
        <translation>le module %1 figure deux fois.</translation>
    </message>
    <message>
        <source>point &quot;%1&quot; does not exist.</source>
        <translation>le point «&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>sequence &quot;%1&quot; does not exist.</source>
        <translation>la séquence «&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>this row makes the sequence &quot;%1&quot; call itself endlessly.</source>
        <translation>avec cette ligne, la séquence «&#xa0;%1&#xa0;» s’appelle elle-même sans fin.</translation>
    </message>
    <message>
        <source>a repeat must go back to an earlier row.</source>
        <translation>une répétition doit revenir à une ligne précédente.</translation>
    </message>
    <message>
        <source>Order of Home all</source>
        <translation>Ordre de «&#xa0;Prendre les origines&#xa0;»</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Point %1</translation>
    </message>
    <message>
        <source>Sequence %1</source>
        <translation>Séquence %1</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Saisissez un nom.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is already used. Choose another one.</source>
        <translation>Le nom «&#xa0;%1&#xa0;» est déjà utilisé. Choisissez-en un autre.</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; contains %1 twice.</source>
        <translation>Le point «&#xa0;%2&#xa0;» contient deux fois %1.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; does not exist.</source>
        <translation>Le point «&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot; does not exist.</source>
        <translation>La séquence «&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; would call itself endlessly.</source>
        <translation>La séquence «&#xa0;%1&#xa0;» s’appellerait elle-même sans fin.</translation>
    </message>
    <message>
        <source>A repeat must go back to an earlier row.</source>
        <translation>Une répétition doit revenir à une ligne précédente.</translation>
    </message>
    <message>
        <source>The sequence has no rows. Add a row first.</source>
        <translation>La séquence n’a aucune ligne. Ajoutez d’abord une ligne.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; has no axes. Teach it again.</source>
        <translation>Le point «&#xa0;%1&#xa0;» n’a aucun axe. Refaites son apprentissage.</translation>
    </message>
    <message>
        <source>%1 is not in the chain.</source>
        <translation>%1 n’est pas dans la chaîne.</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; was taught before home of %1 was known, so it may have shifted. Teach it again.</source>
        <translation>Le point «&#xa0;%2&#xa0;» a été appris avant que l’origine de %1 soit connue&#x202f;; il a pu se décaler. Refaites son apprentissage.</translation>
    </message>
    <message>
        <source>Homing of %1 is not set up. Set it up on its Homing page.</source>
        <translation>La prise d’origine de %1 n’est pas configurée. Configurez-la sur sa page Prise d’origine.</translation>
    </message>
    <message>
        <source>%1 does not have this input or output.</source>
        <translation>%1 n’a pas cette entrée ou sortie.</translation>
    </message>
    <message>
        <source>The outputs of %1 are unknown. Set them once on the module&apos;s page.</source>
        <translation>Les sorties de %1 sont inconnues. Définissez-les une fois sur la page du module.</translation>
    </message>
    <message>
        <source>A run from the top never gets here: an earlier row repeats forever.</source>
        <translation>Une exécution depuis le début n’arrive jamais ici&#xa0;: une ligne précédente se répète sans fin.</translation>
    </message>
    <message>
        <source>At this row, %1 must be at home. Move it there first.</source>
        <translation>À cette ligne, %1 doit être à l’origine. Amenez-l’y d’abord.</translation>
    </message>
    <message>
        <source>At this row, %1 must be at point &quot;%2&quot;. Move it there first.</source>
        <translation>À cette ligne, %1 doit être au point «&#xa0;%2&#xa0;». Amenez-l’y d’abord.</translation>
    </message>
    <message>
        <source>At this row, output %1 of %2 must be in the opposite state. Set it first.</source>
        <translation>À cette ligne, la sortie %1 de %2 doit être commutée. Commutez-la d’abord.</translation>
    </message>
    <message>
        <source>You stopped it.</source>
        <translation>Vous avez demandé l’arrêt.</translation>
    </message>
    <message>
        <source>All motors were stopped.</source>
        <translation>Tous les moteurs ont été arrêtés.</translation>
    </message>
    <message>
        <source>%1 received another command, or something else moved it.</source>
        <translation>%1 a reçu une autre commande, ou autre chose l’a déplacé.</translation>
    </message>
    <message>
        <source>A limit switch of %1 closed during the move.</source>
        <translation>Un fin de course de %1 s’est fermé pendant le déplacement.</translation>
    </message>
    <message>
        <source>%1 stopped before it reached its goal.</source>
        <translation>%1 s’est arrêté avant d’atteindre sa cible.</translation>
    </message>
    <message>
        <source>The motor of %1 switched off.</source>
        <translation>Le moteur de %1 s’est coupé.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become high within %3 s.</source>
        <translation>%1 de %2 n’est pas passé au niveau haut en moins de %3&#xa0;s.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become low within %3 s.</source>
        <translation>%1 de %2 n’est pas passé au niveau bas en moins de %3&#xa0;s.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become active within %3 s.</source>
        <translation>%1 de %2 n’est pas devenu actif en moins de %3&#xa0;s.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become inactive within %3 s.</source>
        <translation>%1 de %2 n’est pas devenu inactif en moins de %3&#xa0;s.</translation>
    </message>
    <message>
        <source>%1 did not find home.</source>
        <translation>%1 n’a pas trouvé l’origine.</translation>
    </message>
    <message>
        <source>The link was unreliable.</source>
        <translation>La liaison n’était pas fiable.</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1 ne répond pas.</translation>
    </message>
    <message>
        <source>%1 refused or did not answer a command.</source>
        <translation>%1 a refusé une commande ou n’y a pas répondu.</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1, pass %2</source>
        <translation>%1, tour %2</translation>
    </message>
    <message>
        <source>Move to &quot;%1&quot;</source>
        <translation>Aller à «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot;</source>
        <translation>Séquence «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4 in all, moves: %5</source>
        <translation>%1&#xa0;: %2 à %3, %4 au total, déplacements&#xa0;: %5</translation>
    </message>
    <message>
        <source>move to</source>
        <translation>aller à</translation>
    </message>
    <message>
        <source>wait</source>
        <translation>attendre</translation>
    </message>
    <message>
        <source>wait for arrival</source>
        <translation>attendre l’arrivée</translation>
    </message>
    <message>
        <source>wait for input</source>
        <translation>attendre l’entrée</translation>
    </message>
    <message>
        <source>set output</source>
        <translation>définir la sortie</translation>
    </message>
    <message>
        <source>find home</source>
        <translation>prendre l’origine</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>répéter</translation>
    </message>
    <message>
        <source>call</source>
        <translation>appeler</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>capteur d’origine</translation>
    </message>
    <message>
        <source>%1: %2 from home</source>
        <translation>%1&#xa0;: %2 de l’origine</translation>
    </message>
    <message>
        <source>%1: at %2, home unknown</source>
        <translation>%1&#xa0;: à %2, origine inconnue</translation>
    </message>
    <message>
        <source>%1, row %2: %3</source>
        <translation>%1, ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Running: %1</source>
        <translation>En cours&#xa0;: %1</translation>
    </message>
    <message>
        <source>Finishing its row, then pausing: %1</source>
        <translation>Termine sa ligne, puis pause&#xa0;: %1</translation>
    </message>
    <message>
        <source>Paused before: %1</source>
        <translation>En pause avant&#xa0;: %1</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>Arrêt en cours&#xa0;: %1</translation>
    </message>
    <message>
        <source>Ended: %1. %2</source>
        <translation>Interruption&#xa0;: %1. %2</translation>
    </message>
    <message>
        <source>%1 is done.</source>
        <translation>%1&#xa0;: terminé.</translation>
    </message>
    <message>
        <source>%1 ended, and its motors were commanded to stop.</source>
        <translation>%1&#xa0;: interruption&#x202f;; ses moteurs ont reçu l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>It was at: %1. To continue, select a row and choose Run from row. Nothing restarts on its own.</source>
        <translation>Étape atteinte&#xa0;: %1. Pour continuer, sélectionnez une ligne et choisissez «&#xa0;Lancer depuis la ligne&#xa0;». Rien ne redémarre tout seul.</translation>
    </message>
    <message>
        <source>Nothing was started.</source>
        <translation>Rien n’a été démarré.</translation>
    </message>
    <message>
        <source>Dry run: the sequence would not start.</source>
        <translation>Marche à blanc&#xa0;: la séquence ne démarrerait pas.</translation>
    </message>
    <message>
        <source>Dry run: the simulation was not ready. Try again.</source>
        <translation>Marche à blanc&#xa0;: la simulation n’était pas prête. Réessayez.</translation>
    </message>
    <message>
        <source>Dry run: %1 cannot be simulated. %2</source>
        <translation>Marche à blanc&#xa0;: impossible de simuler %1. %2</translation>
    </message>
    <message>
        <source>Dry run: cut off after %1 s.</source>
        <translation>Marche à blanc&#xa0;: interrompue au bout de %1&#xa0;s.</translation>
    </message>
    <message>
        <source>Dry run: done after %1 s.</source>
        <translation>Marche à blanc&#xa0;: terminée au bout de %1&#xa0;s.</translation>
    </message>
    <message>
        <source>Dry run: it would end after %1 s. %2</source>
        <translation>Marche à blanc&#xa0;: interruption prévue au bout de %1&#xa0;s. %2</translation>
    </message>
    <message>
        <source>Homing takes longer in reality: %1.</source>
        <translation>La prise d’origine dure plus longtemps en réalité&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Inputs were assumed to change at once.</source>
        <translation>Les entrées ont été supposées changer aussitôt.</translation>
    </message>
    <message>
        <source>An endless repeat ran once.</source>
        <translation>Une répétition sans fin a été exécutée une fois.</translation>
    </message>
    <message>
        <source>Simulated motors were used; real motors may take longer.</source>
        <translation>Des moteurs simulés ont été utilisés&#x202f;; des moteurs réels peuvent mettre plus de temps.</translation>
    </message>
    <message>
        <source>the lowest position is not below the highest.</source>
        <translation>la position minimale n’est pas inférieure à la position maximale.</translation>
    </message>
    <message>
        <source>Lowest position, from home</source>
        <translation>Position minimale, depuis l’origine</translation>
    </message>
    <message>
        <source>Highest position, from home</source>
        <translation>Position maximale, depuis l’origine</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Vitesse maximale</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Surcourse</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Par le haut</translation>
    </message>
    <message>
        <source>Armed for each motion</source>
        <translation>Armé pour chaque mouvement</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within its travel limits or at its last known position.</source>
        <translation>%1 a été arrêté&#xa0;: origine introuvable, dans ses limites de course comme à son dernier emplacement.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, and the search direction. If the position is wrong, choose Position in doubt on the Axis page: the next search then uses only its search distance.</source>
        <translation>Vérifiez le capteur et son câble, ainsi que le sens de recherche. Si la position est fausse, choisissez «&#xa0;Position douteuse&#xa0;» sur la page Axe&#xa0;: la prochaine recherche n’utilise alors que sa course de recherche.</translation>
    </message>
    <message>
        <source>Taking up backlash</source>
        <translation>Rattrapage de jeu</translation>
    </message>
    <message>
        <source>The move would exceed the travel limits. The motor was stopped.</source>
        <translation>Le déplacement sortirait des limites de course. Le moteur a été arrêté.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop just before its travel limit.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêt juste avant sa limite de course.</translation>
    </message>
    <message>
        <source>The chip does not end this kind of motion by itself, so the panel did. Check the position before you continue.</source>
        <translation>La puce n’arrête pas d’elle-même ce type de mouvement&#x202f;; le programme l’a donc fait. Vérifiez la position avant de continuer.</translation>
    </message>
    <message>
        <source>That is beyond this axis&apos;s travel limits (Axis page).</source>
        <translation>C’est hors des limites de course de cet axe (page Axe).</translation>
    </message>
    <message>
        <source>Travel limit reached. Move in the other direction.</source>
        <translation>Limite de course atteinte. Repartez dans l’autre sens.</translation>
    </message>
    <message>
        <source>That exceeds this axis&apos;s highest velocity (Axis page).</source>
        <translation>Cela dépasse la vitesse maximale de cet axe (page Axe).</translation>
    </message>
    <message>
        <source>Stop first: a run towards a travel limit must start from standstill, so that the chip can end it there.</source>
        <translation>Arrêtez d’abord&#xa0;: une marche continue vers une limite de course doit partir de l’arrêt, pour que la puce puisse y mettre fin à cet endroit.</translation>
    </message>
    <message>
        <source>Wait until the limit stop of this axis is armed.</source>
        <translation>Attendez que l’arrêt sur fin de course de cet axe soit armé.</translation>
    </message>
    <message>
        <source>The current limit CL is 0 or unknown, so current cannot stop the motor. Apply a CL first.</source>
        <translation>La limite de courant CL est à 0 ou inconnue&#xa0;: le courant ne peut pas arrêter le moteur. Appliquez d’abord une valeur CL.</translation>
    </message>
    <message>
        <source>A limit switch, overheating or the E-stop input ended the move. The motor is at rest.</source>
        <translation>Un fin de course, une surchauffe ou l’entrée E-Stop a mis fin au déplacement. Le moteur est à l’arrêt.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed setting their position to 0.</source>
        <translation>Au moins un module du groupe %1 n’a pas confirmé la mise à 0 de sa position.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed clearing their sticky bits. A persistent fault sets its bit again at once.</source>
        <translation>Au moins un module du groupe %1 n’a pas confirmé l’effacement de ses bits mémorisés. Un défaut persistant remet aussitôt son bit à 1.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed the command.</source>
        <translation>Au moins un module du groupe %1 n’a pas confirmé la commande.</translation>
    </message>
    <message>
        <source>A group command requires that every member answers and can carry it out in its present state, and that the group of every module is known. Command the modules one by one, or set this module&apos;s group again.</source>
        <translation>Une commande de groupe exige une réponse de chaque membre, un état où chacun peut l’exécuter, et un groupe connu pour chaque module. Commandez les modules un par un, ou redéfinissez le groupe de ce module.</translation>
    </message>
    <message>
        <source>Group %1 was commanded to switch its motors off: module %2.</source>
        <translation>Le groupe %1 a reçu l’ordre de couper ses moteurs&#xa0;: module %2.</translation>
    </message>
    <message>
        <source>Group %1 was commanded to stop: module %2.</source>
        <translation>Le groupe %1 a reçu l’ordre d’arrêt&#xa0;: module %2.</translation>
    </message>
    <message>
        <source>This computer&apos;s port does not support %1 Bd. Choose another baud rate.</source>
        <translation>Le port de cet ordinateur ne prend pas en charge %1&#xa0;Bd. Choisissez un autre débit.</translation>
    </message>
    <message>
        <source>Module %1 now has address %2. Position, gains and group are unchanged.</source>
        <translation>Le module %1 a maintenant l’adresse %2. Position, gains et groupe sont inchangés.</translation>
    </message>
    <message>
        <source>The address is used by another module or not allowed. Choose a free address from 1 to 127.</source>
        <translation>L’adresse est utilisée par un autre module ou n’est pas autorisée. Choisissez une adresse libre de 1 à 127.</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Set its group first, or none.</source>
        <translation>Son groupe est inconnu et changerait avec l’adresse. Définissez d’abord son groupe, ou aucun.</translation>
    </message>
    <message>
        <source>Another module without an address would take it. Assign that module&apos;s address first, or restart the network.</source>
        <translation>Un autre module sans adresse la prendrait. Attribuez d’abord l’adresse de ce module, ou redémarrez le réseau.</translation>
    </message>
    <message>
        <source>The exact position that the servo holds is unknown. Choose Hold here first, or move the motor.</source>
        <translation>La position exacte que maintient le servo est inconnue. Choisissez «&#xa0;Maintenir d’abord ici&#xa0;», ou déplacez le moteur.</translation>
    </message>
    <message>
        <source>Module %1 oscillates while it holds its position.</source>
        <translation>Le module %1 maintient son moteur, et le moteur oscille.</translation>
    </message>
    <message>
        <source>Its servo is not stable with these gains. Lower Kp and Ki, or raise Kd, and apply them.</source>
        <translation>Son servo n’est pas stable avec ces gains. Réduisez Kp et Ki ou augmentez Kd, et appliquez-les.</translation>
    </message>
    <message>
        <source>Restore previous gains</source>
        <translation>Rétablir les gains précédents</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it began to oscillate.</source>
        <translation>%1 est revenu à ses gains précédents&#xa0;: il commençait à osciller.</translation>
    </message>
    <message>
        <source>Lower Kp and Ki, or raise Kd, then try again.</source>
        <translation>Réduisez Kp et Ki ou augmentez Kd, puis réessayez.</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it left its position.</source>
        <translation>%1 est revenu à ses gains précédents&#xa0;: il a quitté sa position.</translation>
    </message>
    <message>
        <source>These gains do not hold its load, or something else turned it.</source>
        <translation>Ces gains ne tiennent pas sa charge, ou autre chose l’a fait tourner.</translation>
    </message>
    <message>
        <source>%1 switched itself off while gains were being tried, and is free to turn.</source>
        <translation>%1 s’est coupé pendant l’essai de gains et peut tourner librement.</translation>
    </message>
    <message>
        <source>Its previous gains were sent again. Check for a jam, then enable it.</source>
        <translation>Ses gains précédents ont été renvoyés. Vérifiez l’absence de blocage, puis activez-le.</translation>
    </message>
    <message>
        <source>%1 does not answer while gains are being tried. Motor state unknown.</source>
        <translation>%1 ne répond pas pendant l’essai de gains. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>Its previous gains were sent. Use the hardware stop if it moves.</source>
        <translation>Ses gains précédents ont été envoyés. Utilisez l’arrêt câblé s’il bouge.</translation>
    </message>
    <message>
        <source>The new gains of %1 are in force; OL may still be lowered.</source>
        <translation>Les nouveaux gains de %1 sont en vigueur&#xa0;; OL est peut-être encore réduit.</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Apply the gains again.</source>
        <translation>Une commande a échoué, ou sa réponse s’est perdue. Appliquez de nouveau les gains.</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: the link was unreliable.</source>
        <translation>Les gains précédents de %1 ont été renvoyés&#xa0;: la liaison n’était pas fiable.</translation>
    </message>
    <message>
        <source>Check the link, then try again.</source>
        <translation>Vérifiez la liaison, puis réessayez.</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: a command failed, or its answer was lost.</source>
        <translation>Les gains précédents de %1 ont été renvoyés&#xa0;: une commande a échoué, ou sa réponse s’est perdue.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Try again.</source>
        <translation>Cause habituelle&#xa0;: parasites sur le câble. Réessayez.</translation>
    </message>
    <message>
        <source>Trying gains</source>
        <translation>Essai de gains</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: the trial has ended.</source>
        <translation>%1 est revenu à ses gains précédents&#xa0;: l’essai est terminé.</translation>
    </message>
    <message>
        <source>The motor began to oscillate. The previous gains are restored.</source>
        <translation>Le moteur commençait à osciller. Les gains précédents sont rétablis.</translation>
    </message>
    <message>
        <source>Could not print the page.</source>
        <translation>Impossible d’imprimer la page.</translation>
    </message>
    <message>
        <source>%1 Export the page as a PDF file and print that file.</source>
        <translation>%1 Exportez la page en fichier PDF et imprimez ce fichier.</translation>
    </message>
    <message>
        <source>The page was sent to the printer.</source>
        <translation>La page a été envoyée à l’imprimante.</translation>
    </message>
    <message>
        <source>The program %1, which sends pages to the printer, is not installed.</source>
        <translation>Le programme %1, qui envoie les pages à l’imprimante, n’est pas installé.</translation>
    </message>
    <message>
        <source>The print system refused it: see Details.</source>
        <translation>Le système d’impression l’a refusée&#xa0;: voir les détails.</translation>
    </message>
    <message>
        <source>Could not read the step responses of this machine.</source>
        <translation>Impossible de lire les réponses indicielles de cette machine.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of step responses.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un fichier de réponses indicielles.</translation>
    </message>
    <message>
        <source>The file is kept: before new step responses are saved, it is moved to %1.</source>
        <translation>Le fichier est conservé&#xa0;: avant l’enregistrement de nouvelles réponses indicielles, il est déplacé vers %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not readable. It is moved aside before new step responses are saved.</source>
        <translation>«&#xa0;%1&#xa0;» est illisible. Il est mis de côté avant l’enregistrement de nouvelles réponses indicielles.</translation>
    </message>
    <message>
        <source>The step responses of this session are not saved.</source>
        <translation>Les réponses indicielles de cette session ne sont pas enregistrées.</translation>
    </message>
    <message>
        <source>%1 is not writable. Export them before you close the panel.</source>
        <translation>Écriture impossible dans %1. Exportez-les avant de fermer le programme.</translation>
    </message>
    <message>
        <source>The loop test of %1 ended early.</source>
        <translation>%1&#xa0;: son essai de boucle s’est terminé avant la fin.</translation>
    </message>
    <message>
        <source>The motor moved farther than the test allows, and was commanded to hold. Check for a load that pulls it, or use lower gains.</source>
        <translation>Le moteur s’est déplacé plus loin que l’essai ne le permet et a reçu l’ordre de maintien. Vérifiez si une charge l’entraîne, ou utilisez des gains plus faibles.</translation>
    </message>
    <message>
        <source>A value of this test is out of range.</source>
        <translation>Une valeur de cet essai est hors plage.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>The module answers. It has inputs and outputs, but no motor.</source>
        <translation>Le module répond. Il a des entrées et des sorties, mais pas de moteur.</translation>
    </message>
    <message>
        <source>This module drives no motor.</source>
        <translation>Ce module n’entraîne pas de moteur.</translation>
    </message>
    <message>
        <source>This module is not a PIC-I/O.</source>
        <translation>Ce module n’est pas un PIC-I/O.</translation>
    </message>
    <message>
        <source>A module ended the path by itself: a limit switch, a position error, or no motor power. All axes of the path were commanded to stop.</source>
        <translation>Un module a mis fin à la trajectoire de lui-même&#xa0;: fin de course, erreur de position ou absence d’alimentation moteur. Tous les axes de la trajectoire ont reçu l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>%1 has not finished its path.</source>
        <translation>%1 n’a pas terminé sa trajectoire.</translation>
    </message>
    <message>
        <source>Not all axes started the path. All of them were commanded to stop.</source>
        <translation>Tous les axes n’ont pas démarré la trajectoire. Tous ont reçu l’ordre de s’arrêter.</translation>
    </message>
    <message>
        <source>The path points did not arrive in time, so the motor stopped at the last one.</source>
        <translation>Les points de la trajectoire ne sont pas arrivés à temps&#xa0;: le moteur s’est arrêté au dernier qu’il avait reçu.</translation>
    </message>
    <message>
        <source>The command position left the path. The motor was commanded to stop.</source>
        <translation>Le moteur n’a pas été conduit là où va la trajectoire. Il a reçu l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>On a path</source>
        <translation>Sur trajectoire</translation>
    </message>
    <message>
        <source>The path cannot be followed from here.</source>
        <translation>La trajectoire ne peut pas être suivie à partir d’ici.</translation>
    </message>
    <message>
        <source>Enable it, then move it the other way. The Amplifier page sets what a closed limit does.</source>
        <translation>Activez-le, puis déplacez-le dans l’autre sens. La page Amplificateur définit l’effet d’un fin de course fermé.</translation>
    </message>
    <message>
        <source>Limit switch %1 closed, and module %2 switched its motor off.</source>
        <translation>Le fin de course %1 s’est fermé, et le module %2 a coupé son moteur.</translation>
    </message>
    <message>
        <source>The limit in that direction is closed. Move the motor the other way.</source>
        <translation>Le fin de course de ce sens est fermé. Déplacez le moteur dans l’autre sens.</translation>
    </message>
    <message>
        <source>The rate &quot;%1&quot; does not exist. Use 30, 60 or 120.</source>
        <translation>La fréquence «&#xa0;%1&#xa0;» n’existe pas. Utilisez 30, 60 ou 120.</translation>
    </message>
    <message>
        <source>The file has no line that names its axes.</source>
        <translation>Aucune ligne du fichier ne nomme ses axes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis that can follow a path.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un axe capable de suivre une trajectoire.</translation>
    </message>
    <message>
        <source>This axis is named twice.</source>
        <translation>Cet axe est nommé deux fois.</translation>
    </message>
    <message>
        <source>A position is missing.</source>
        <translation>Une position manque.</translation>
    </message>
    <message>
        <source>The line has %1 positions; the file has %2 axes.</source>
        <translation>La ligne a %1 positions&#x202f;; le fichier a %2 axes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is outside the module&apos;s position range.</source>
        <translation>«&#xa0;%1&#xa0;» dépasse la plage de comptage du module.</translation>
    </message>
    <message>
        <source>The point is %1 from the previous one; at this rate the maximum is %2.</source>
        <translation>Le point est à %1 du précédent. À cette fréquence, au plus %2 sont possibles.</translation>
    </message>
    <message>
        <source>This needs a velocity of %1; the limit of the axis is %2.</source>
        <translation>Cela exige %1. L’axe est limité à %2.</translation>
    </message>
    <message>
        <source>%1 is beyond the travel limit of %2.</source>
        <translation>%1 est au-delà de la limite de course (%2).</translation>
    </message>
    <message>
        <source>A path needs at least two points.</source>
        <translation>Une trajectoire exige au moins deux points.</translation>
    </message>
    <message>
        <source>A path has at most %1 points.</source>
        <translation>Une trajectoire comporte au plus %1 points.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>Ligne %1, %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 has no path buffer. Only a PIC-SERVO CMC or SC can follow a path.</source>
        <translation>%1 n’a pas de tampon de trajectoire. Seul un PIC-SERVO CMC ou SC suit une trajectoire.</translation>
    </message>
    <message>
        <source>The I/O settings of %1 are unknown: another program set them. Apply them first on the Amplifier or Limits and I/O page.</source>
        <translation>Les réglages d’E/S de %1 sont inconnus&#xa0;: un autre programme les a définis. Appliquez-les d’abord sur la page Amplificateur ou Fins de course et E/S.</translation>
    </message>
    <message>
        <source>%1 is set to step and direction input. Switch that off on its Amplifier page first.</source>
        <translation>%1 reçoit des impulsions pas et direction. Désactivez d’abord cette entrée sur sa page Amplificateur.</translation>
    </message>
    <message>
        <source>%1: a path at 30 Hz needs fast path off (Amplifier or Limits and I/O page).</source>
        <translation>%1&#xa0;: une trajectoire à 30&#xa0;Hz exige «&#xa0;Trajectoire rapide&#xa0;» inactif (page Amplificateur ou Fins de course et E/S).</translation>
    </message>
    <message>
        <source>%1: a path at 120 Hz needs fast path on (Amplifier or Limits and I/O page).</source>
        <translation>%1&#xa0;: une trajectoire à 120&#xa0;Hz exige «&#xa0;Trajectoire rapide&#xa0;» actif (page Amplificateur ou Fins de course et E/S).</translation>
    </message>
    <message>
        <source>%1: a path needs a servo rate divisor of 1. Apply the gains with SR = 1 first.</source>
        <translation>%1&#xa0;: une trajectoire exige la cadence servo SR = 1. Appliquez d’abord les gains avec SR 1.</translation>
    </message>
    <message>
        <source>%1 has not reported its command position yet.</source>
        <translation>%1 n’a pas encore transmis sa position de consigne.</translation>
    </message>
    <message>
        <source>%1 is %2 from the first point. Choose Move to start first.</source>
        <translation>%1 est à %2 du premier point. Choisissez d’abord «&#xa0;Aller au départ&#xa0;».</translation>
    </message>
    <message>
        <source>%1: point %2 is %3 from the previous one; at this rate the maximum is %4.</source>
        <translation>%1&#xa0;: le point %2 est à %3 du précédent. À cette fréquence, au plus %4 sont possibles.</translation>
    </message>
    <message>
        <source>%1: point %2 needs a velocity of %3; the limit of the axis is %4.</source>
        <translation>%1&#xa0;: le point %2 exige %3. L’axe est limité à %4.</translation>
    </message>
    <message>
        <source>%1: point %2 at %3 is beyond the travel limit of %4.</source>
        <translation>%1&#xa0;: le point %2, à %3, est au-delà de la limite de course (%4).</translation>
    </message>
    <message>
        <source>The path does not fit this chain. Open it again.</source>
        <translation>La trajectoire ne correspond pas à cette chaîne. Rouvrez-la.</translation>
    </message>
    <message>
        <source>The axes of a path start together. Put them, and no other module, into one group: Chain, Groups.</source>
        <translation>Les axes d’une trajectoire démarrent ensemble. Mettez-les dans un même groupe, sans autre module&#xa0;: Chaîne, Groupes.</translation>
    </message>
    <message>
        <source>The path needs %1 % of the bus time; %2 % is available. Use a higher baud rate or a lower path rate.</source>
        <translation>La trajectoire exige %1&#x202f;% du temps du bus&#x202f;; %2&#x202f;% sont disponibles. Choisissez un débit plus élevé ou une fréquence de trajectoire plus faible.</translation>
    </message>
    <message>
        <source>%1 cannot follow a path. Only a PIC-SERVO CMC or SC can.</source>
        <translation>%1 ne peut pas suivre de trajectoire. Seul un PIC-SERVO CMC ou SC le peut.</translation>
    </message>
    <message>
        <source>%1 does not hold a known position. Enable its servo, and find home if the points count from home.</source>
        <translation>%1 ne maintient pas de position connue. Activez son servo, et faites la prise d’origine si les points sont comptés à partir de l’origine.</translation>
    </message>
    <message>
        <source>Only moves, waits, repeats and calls can become a path.</source>
        <translation>Seuls les déplacements, attentes, répétitions et appels peuvent devenir une trajectoire.</translation>
    </message>
    <message>
        <source>A path cannot repeat forever.</source>
        <translation>Une trajectoire ne peut pas se répéter sans fin.</translation>
    </message>
    <message>
        <source>Up to here the path would have more than %1 points.</source>
        <translation>À cette ligne, la trajectoire aurait déjà plus de %1 points.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; moves nothing.</source>
        <translation>La séquence «&#xa0;%1&#xa0;» ne déplace rien.</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;. %2</source>
        <translation>Impossible d’ouvrir «&#xa0;%1&#xa0;». %2</translation>
    </message>
    <message>
        <source>The path is done. Each axis holds its last point.</source>
        <translation>La trajectoire est terminée. Chaque axe maintient son dernier point.</translation>
    </message>
    <message>
        <source>The path was stopped.</source>
        <translation>La trajectoire a été arrêtée.</translation>
    </message>
    <message>
        <source>Starting the path</source>
        <translation>Démarrage de la trajectoire</translation>
    </message>
    <message>
        <source>Point %1 of %2, %3 s left, %4 points left in the buffer</source>
        <translation>Point %1 sur %2, encore %3&#xa0;s, %4 points d’avance dans le tampon</translation>
    </message>
    <message>
        <source>%1. The buffer is about to run dry: the bus is too slow.</source>
        <translation>%1. Le tampon est sur le point de se vider&#xa0;: le bus est trop lent.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>%1 points at %2 Hz, %3 s</source>
        <translation>%1 points à %2&#xa0;Hz, %3&#xa0;s</translation>
    </message>
    <message>
        <source>SM, step multiplier</source>
        <translation>SM, multiplicateur de pas</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>Trajectoire rapide</translation>
    </message>
    <message>
        <source>This pin of %1 is set as an output.</source>
        <translation>Cette broche de %1 est configurée en sortie.</translation>
    </message>
    <message>
        <source>This pin of %1 is not set as an output. Make it an output first.</source>
        <translation>Cette broche de %1 n’est pas configurée en sortie. Configurez-la sur la page E/S.</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not rise above %3 of 255 within %4 s.</source>
        <translation>A/D %1 de %2 n’est pas monté au-dessus de %3 sur 255 en moins de %4&#xa0;s.</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not fall below %3 of 255 within %4 s.</source>
        <translation>A/D %1 de %2 n’est pas descendu au-dessous de %3 sur 255 en moins de %4&#xa0;s.</translation>
    </message>
    <message>
        <source>wait for A/D</source>
        <translation>attendre A/D</translation>
    </message>
    <message numerus="yes">
        <source>No stop command is known for modules %1</source>
        <translation>
            <numerusform>Le module %1 ne peut pas recevoir d’ordre d’arrêt</numerusform>
            <numerusform>Les modules %1 ne peuvent pas recevoir d’ordre d’arrêt</numerusform>
        </translation>
    </message>
    <message>
        <source>If it moved the wrong way, run the direction check on the Axis page.</source>
        <translation>S’il a bougé dans le mauvais sens, faites le contrôle de sens sur la page Axe.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or make the test smaller, then enable the motor.</source>
        <translation>L’erreur de position était trop grande, ou l’alimentation moteur a fait défaut. Vérifiez l’absence de blocage, augmentez EL ou réduisez l’essai, puis activez le moteur.</translation>
    </message>
    <message>
        <source>Check the link, then start the test again.</source>
        <translation>Vérifiez la liaison, puis relancez l’essai.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Start the test again.</source>
        <translation>Cause habituelle&#xa0;: parasites sur le câble. Relancez l’essai.</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its limit stop ended it.</source>
        <translation>%1 n’a pas achevé son échelon&#xa0;: son arrêt sur fin de course l’a interrompu.</translation>
    </message>
    <message>
        <source>Its limit stop ended the test.</source>
        <translation>Son arrêt sur fin de course a interrompu l’essai.</translation>
    </message>
    <message>
        <source>The motor did not follow the sine wave, and was commanded to hold. Check for a jam, a hard stop, a slipping coupling or missing motor power, or use another amplitude.</source>
        <translation>Le moteur n’a pas suivi la sinusoïde et a reçu l’ordre de maintien. Vérifiez s’il y a un blocage, une butée mécanique, un accouplement qui glisse ou une alimentation moteur absente, ou utilisez une autre amplitude.</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: its output reached the limit OL.</source>
        <translation>%1 a retrouvé ses gains précédents&#xa0;: sa sortie a atteint la limite OL.</translation>
    </message>
    <message>
        <source>It oscillates, or was pushed. Lower Kp, or raise Kd, then try again.</source>
        <translation>Il oscille ou a été poussé. Baissez Kp ou augmentez Kd, puis réessayez.</translation>
    </message>
    <message>
        <source>Looking for printers…</source>
        <translation>Recherche d’imprimantes…</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Add one in the system&apos;s printer settings, or save the page as a PDF file.</source>
        <translation>Aucune imprimante n’est configurée sur cet ordinateur. Ajoutez-en une dans les réglages d’imprimantes du système, ou enregistrez la page en fichier PDF.</translation>
    </message>
    <message>
        <source>Printer: %1</source>
        <translation>Imprimante&#xa0;: %1</translation>
    </message>
    <message>
        <source>The output reached its limit. The previous gains are restored.</source>
        <translation>La sortie a atteint sa limite. Les gains précédents sont rétablis.</translation>
    </message>
    <message>
        <source>The line at %1 was disturbed while the modules were given addresses.</source>
        <translation>La ligne sur %1 a été perturbée pendant l’attribution des adresses aux modules.</translation>
    </message>
    <message>
        <source>A module that had answered stopped answering, so the number of modules is unknown. No motor was moved. Check the cable and the adapter, then scan again.</source>
        <translation>Un module qui avait répondu s’est tu : le nombre de modules est donc inconnu. Aucun moteur n’a bougé. Vérifiez le câble et l’adaptateur, puis relancez la recherche.</translation>
    </message>
    <message>
        <source>The adapter at %1 passes answers on in pieces, up to %2 ms apart.</source>
        <translation>L’adaptateur sur %1 transmet les réponses par morceaux, espacés de %2 ms au plus.</translation>
    </message>
    <message>
        <source>USB hubs, Bluetooth and device servers do that. The panel waits for the rest, so updates are slower. No action needed.</source>
        <translation>Les concentrateurs USB, le Bluetooth et les serveurs de ports font cela. Le programme attend la suite : les valeurs arrivent donc plus lentement. Rien à faire.</translation>
    </message>
    <message>
        <source>Motors were commanded to stop. Until answers have been correct for 2 s, only presence queries are sent; then the panel looks for the modules again. Try a lower baud rate, a shorter cable, or termination at both ends.</source>
        <translation>Les moteurs ont reçu l’ordre d’arrêt. Tant que les réponses n’ont pas été justes pendant 2&#xa0;s, seules des requêtes de présence sont envoyées&#xa0;; le programme relance alors la recherche. Essayez un débit plus faible, un câble plus court ou une terminaison aux deux extrémités.</translation>
    </message>
    <message>
        <source>%1 is %2; the module accepts %3 to %4.</source>
        <translation>%1 vaut %2 ; le module accepte de %3 à %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n stopped and holding</source>
        <translation>
            <numerusform>%n arrêté et maintenu</numerusform>
            <numerusform>%n arrêtés et maintenus</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n switched off</source>
        <translation>
            <numerusform>%n coupé</numerusform>
            <numerusform>%n coupés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n were off</source>
        <translation>
            <numerusform>%n déjà coupé</numerusform>
            <numerusform>%n déjà coupés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n I/O modules in their stop state</source>
        <translation>
            <numerusform>%n module d’E/S comme prévu pour un arrêt</numerusform>
            <numerusform>%n modules d’E/S comme prévu pour un arrêt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 ms.</source>
        <translation>%1, %2 ms.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to switch off: one answer reported a move in the wrong direction, to %2 counts.</source>
        <translation>Le module %1 a reçu l’ordre de couper son moteur : d’après une réponse, il est parti dans le mauvais sens, jusqu’à %2 incréments.</translation>
    </message>
    <message>
        <source>If it did, encoder or motor wires are swapped, or the gains make it oscillate. If it did not, the answer was wrong: check the cable.</source>
        <translation>Si c’est vrai, les fils du codeur ou du moteur sont inversés, ou les gains le font osciller. Si la position est juste, la réponse n’était pas la sienne : vérifiez le câble.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: one answer reported that it went past its goal, to %2 counts.</source>
        <translation>Le module %1 a reçu l’ordre d’arrêt : d’après une réponse, il a dépassé sa cible, jusqu’à %2 incréments.</translation>
    </message>
    <message>
        <source>Check the position before the next move. If it went there, the command was corrupted in transit, or the gains cause a large overshoot. If it did not, the answer was wrong: check the cable.</source>
        <translation>Vérifiez la position avant le prochain déplacement. S’il y est allé, la commande a été altérée en chemin, ou les gains provoquent un fort dépassement. Sinon, la réponse n’était pas la sienne : vérifiez le câble.</translation>
    </message>
    <message>
        <source>A question is waiting for your answer: %1</source>
        <translation>Une question attend votre réponse : %1</translation>
    </message>
    <message>
        <source>Show the question</source>
        <translation>Afficher la question</translation>
    </message>
    <message>
        <source>Maybe off</source>
        <translation>Peut-être coupé</translation>
    </message>
    <message>
        <source>Maybe moving</source>
        <translation>Bouge peut-être</translation>
    </message>
    <message>
        <source>One answer says that the motor is off. The next answer will show whether it is.</source>
        <translation>D’après une réponse, le module a coupé son moteur. La suivante le dira.</translation>
    </message>
    <message>
        <source>The last answers show the motor at rest, but it is not yet known whether it was started.</source>
        <translation>D’après les dernières réponses, le moteur est à l’arrêt, mais on ne sait pas encore s’il a été démarré.</translation>
    </message>
    <message>
        <source>Looking for modules… Until they are found, only stop commands work.</source>
        <translation>Recherche des modules… Jusque-là, seuls les arrêts agissent.</translation>
    </message>
    <message>
        <source>The servo rate of this module is unknown, so speeds per second cannot be calculated. Apply its gains first: they include SR.</source>
        <translation>La cadence servo de ce module est inconnue, donc toute vitesse par seconde aussi. Appliquez d’abord ses gains : SR en fait partie.</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteuse</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>il y a %1 s</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>périmée</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has one column per signal, a format for other programs. The scope opens files with one row per reply.</source>
        <translation>« %1 » a une colonne par signal, une forme pour d’autres programmes. L’oscilloscope ouvre les fichiers avec une ligne par réponse.</translation>
    </message>
    <message>
        <source>The position counter of module %1 has wrapped.</source>
        <translation>La position du module %1 a débordé.</translation>
    </message>
    <message>
        <source>The 32-bit counter has overflowed and continues at the other end of its range. Earlier positions and travel limits no longer match: find home, then clear the sticky bits on the Details page.</source>
        <translation>Elle a 32 bits et a continué à l’autre bout de leur plage. Les positions et limites de course d’avant ne sont plus où elles étaient : cherchez l’origine, puis effacez les bits mémorisés à la page Détails.</translation>
    </message>
    <message>
        <source>Limit switch 1 is active: the motor can only move away from it.</source>
        <translation>Le fin de course 1 est actif&#xa0;: le moteur ne peut que s’en éloigner.</translation>
    </message>
    <message>
        <source>Limit switch 2 is active: the motor can only move away from it.</source>
        <translation>Le fin de course 2 est actif&#xa0;: le moteur ne peut que s’en éloigner.</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programme</translation>
    </message>
    <message>
        <source>%1 is not a line behind a network.</source>
        <translation>%1 n’est pas une ligne accessible par le réseau.</translation>
    </message>
    <message>
        <source>Write tcp://HOST:PORT, or rfc2217://HOST:PORT if the device server lets the rate be set.</source>
        <translation>Écrivez tcp://HOST:PORT, ou rfc2217://HOST:PORT si le serveur de périphériques permet de régler le débit.</translation>
    </message>
    <message>
        <source>The computer or device server in %1 was not found.</source>
        <translation>L’ordinateur ou le serveur de périphériques de %1 est introuvable.</translation>
    </message>
    <message>
        <source>Check its name, and the network.</source>
        <translation>Vérifiez son nom et le réseau.</translation>
    </message>
    <message>
        <source>Nothing accepts connections at %1.</source>
        <translation>Rien n’accepte de connexion sur %1.</translation>
    </message>
    <message>
        <source>Check that the device server is on, that its TCP port is this one, and that no other program has it.</source>
        <translation>Vérifiez que le serveur de périphériques est allumé, que son port TCP est celui-ci et qu’aucun autre programme ne l’occupe.</translation>
    </message>
    <message>
        <source>%1 does not let the serial port be controlled.</source>
        <translation>%1 ne permet pas de commander le port série.</translation>
    </message>
    <message>
        <source>Enable RFC 2217 in the device server, or set it to 19 200 Bd, 8N1, and connect with tcp:// instead.</source>
        <translation>Activez RFC 2217 sur le serveur de périphériques, ou réglez-le sur 19 200 Bd, 8N1, et connectez-vous plutôt avec tcp://.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost. %2</source>
        <translation>La connexion à %1 est perdue. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then check the network and the device server.</source>
        <translation>Utilisez l’arrêt câblé si nécessaire, puis vérifiez le réseau et le serveur de périphériques.</translation>
    </message>
    <message>
        <source>The line is lent to a program.</source>
        <translation>La ligne est prêtée à un programme.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, lent to a program</source>
        <translation>Connecté à %1 à %2 Bd, %3, prêté à un programme</translation>
    </message>
    <message>
        <source>Settings copied from %1: %2.</source>
        <translation>Réglages copiés de %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The move and the record after it would take more than 6 s. Shorten the move or the record, or move faster.</source>
        <translation>Le mouvement et l’enregistrement qui le suit dureraient plus de 6 s. Raccourcissez le mouvement ou l’enregistrement, ou augmentez la vitesse.</translation>
    </message>
    <message>
        <source>The motor swung so far that it reversed, and was commanded to hold. Raise the speed, or lower the amplitude.</source>
        <translation>Le moteur a oscillé au point de changer de sens et a reçu l’ordre de maintien. Augmentez la vitesse ou réduisez l’amplitude.</translation>
    </message>
    <message>
        <source>At this speed the motor would reverse. Raise the speed, or lower the amplitude or the highest frequency.</source>
        <translation>À cette vitesse, le moteur changerait de sens. Augmentez la vitesse, ou réduisez l’amplitude ou la fréquence la plus élevée.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, from home</source>
        <translation>«&#xa0;%1&#xa0;», depuis l’origine</translation>
    </message>
    <message>
        <source>%1 did not stay within its arrival tolerance. Check its gains, or change the tolerance (Axis page).</source>
        <translation>%1 n’est pas resté dans sa tolérance d’arrivée. Vérifiez ses gains ou modifiez la tolérance (page Axe).</translation>
    </message>
    <message>
        <source>The motor would come too close to the position error limit, which switches the servo off. Make the step, the amplitude or the speed smaller, or raise EL.</source>
        <translation>Le moteur s’approcherait trop de la limite d’erreur de position, qui coupe le servo. Réduisez l’échelon, l’amplitude ou la vitesse, ou augmentez EL.</translation>
    </message>
    <message>
        <source>%1 did not finish its approaches.</source>
        <translation>%1 n’a pas terminé ses approches.</translation>
    </message>
    <message>
        <source>Reading the captured position</source>
        <translation>Lecture de la position capturée</translation>
    </message>
    <message>
        <source>The switch changed again while the motor stopped beyond it: it bounces, or its cam is too short. The motor is at rest. Move more slowly, or raise the acceleration.</source>
        <translation>Le capteur a encore changé pendant que le moteur s’arrêtait au-delà&#xa0;: il rebondit, ou sa came est trop courte. Le moteur est à l’arrêt. Allez plus lentement, ou augmentez l’accélération.</translation>
    </message>
    <message>
        <source>The switch or index did not change within the search distance and the time limit. It may be stuck, closed on both sides, or in the other direction; above 1 count per tick, an index can be missed. The motor was stopped.</source>
        <translation>Le capteur ou l’index n’a pas changé dans la course de recherche et le délai. Il peut être bloqué, fermé des deux côtés, ou dans l’autre sens&#xa0;; au-dessus de 1 incrément par période, un index peut être manqué. Le moteur a été arrêté.</translation>
    </message>
    <message>
        <source>The switch or index did not change within the travel limits. The motor was stopped.</source>
        <translation>Le capteur ou l’index n’a pas changé dans les limites de course. Le moteur a été arrêté.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion before the switch changed. The motor is at rest.</source>
        <translation>Un fin de course ou l’entrée d’arrêt d’urgence a mis fin au mouvement avant que le capteur ne change. Le moteur est à l’arrêt.</translation>
    </message>
    <message>
        <source>Choose one switch or the index, and nothing else.</source>
        <translation>Choisissez un seul capteur, ou l’index, et rien d’autre.</translation>
    </message>
    <message>
        <source>Approach it 2 to 100 times from each side.</source>
        <translation>Choisissez de 2 à 100 approches de chaque côté.</translation>
    </message>
    <message>
        <source>An earlier stop was not confirmed, so it was sent now.</source>
        <translation>Un arrêt demandé auparavant n’avait pas été confirmé&#xa0;; il vient donc d’être envoyé.</translation>
    </message>
    <message>
        <source>No stop can be sent now: use the hardware stop.</source>
        <translation>Aucun arrêt ne peut être envoyé pour l’instant&#xa0;: utilisez l’arrêt câblé.</translation>
    </message>
    <message>
        <source>It is sent as soon as you connect to the same modules again.</source>
        <translation>Il sera envoyé dès que vous serez de nouveau connecté aux mêmes modules.</translation>
    </message>
    <message>
        <source>Not connected: the state of the chain is unknown.</source>
        <translation>Non connecté&#xa0;: l’état de la chaîne est inconnu.</translation>
    </message>
    <message>
        <source>Chain OK: %1.</source>
        <translation>Chaîne OK&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No module answered.</source>
        <translation>Aucun module n’a répondu.</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered; the far end of the chain is missing.</source>
        <translation>Modules ayant répondu&#xa0;: %1 sur %2&#x202f;; l’extrémité de la chaîne manque.</translation>
    </message>
    <message>
        <source>%1 is not the expected module.</source>
        <translation>%1 n’est pas le module attendu.</translation>
    </message>
    <message>
        <source>More modules than expected: %1 instead of %2.</source>
        <translation>Plus de modules que prévu&#xa0;: %1 au lieu de %2.</translation>
    </message>
    <message>
        <source>%1 stopped answering. Motor state unknown.</source>
        <translation>%1 ne répond plus. État du moteur inconnu.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and gains are lost.</source>
        <translation>%1 a redémarré&#xa0;: sa position et ses gains sont perdus.</translation>
    </message>
    <message>
        <source>%1 restarted: its pins are inputs again, and its outputs release what they drove.</source>
        <translation>%1 a redémarré&#xa0;: ses broches sont de nouveau des entrées, et ses sorties relâchent ce qu’elles pilotaient.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and parameters are lost.</source>
        <translation>%1 a redémarré&#xa0;: sa position et ses paramètres sont perdus.</translation>
    </message>
    <message>
        <source>Choose a port and connect.</source>
        <translation>Choisissez un port et connectez-vous.</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC.</source>
        <translation>Vérifiez dans cet ordre&#xa0;: l’alimentation des modules&#x202f;; chaque câble de la chaîne, car un seul câble débranché masque tous les modules&#x202f;; le cavalier ADDR_IN du module le plus éloigné du PC.</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.</source>
        <translation>La numérotation commence à l’extrémité de la chaîne. Contrôlez donc le module qui suit %1 en direction du PC&#xa0;: d’abord son alimentation, puis le connecteur entre les deux. Relancez ensuite la recherche.</translation>
    </message>
    <message>
        <source>Only the modules nearest the PC answered, and their numbers have changed. Check the cable to the module at the far end, and check that no other ADDR_IN is grounded. Until this is fixed, settings do not match the modules.</source>
        <translation>Seuls les modules les plus proches du PC ont répondu, et leurs numéros ont changé. Vérifiez le câble du module à l’extrémité de la chaîne, et qu’aucun autre ADDR_IN n’est à la masse. Tant que le problème persiste, les réglages ne correspondent pas aux modules.</translation>
    </message>
    <message>
        <source>Name, unit, limits, speeds and points of the expected module are used for it; gains and parameters from a machine file are not sent to it. If you replaced the module on purpose, check these settings, then accept the chain as found.</source>
        <translation>Le nom, l’unité, les limites, les vitesses et les points du module attendu sont utilisés pour lui&#x202f;; les gains et paramètres d’un fichier machine ne lui sont pas envoyés. Si vous avez remplacé le module volontairement, vérifiez ces réglages, puis acceptez la chaîne telle quelle.</translation>
    </message>
    <message>
        <source>The settings of this place are for another type of module, so they are not used, and only stop commands work. Check the cables, then scan again. If you replaced the module on purpose, accept the chain as found (Chain doctor): all but its name is then to be set again, and its positions leave the points.</source>
        <translation>Les réglages de cette place sont ceux d’un autre type de module&#x202f;; ils ne sont donc pas utilisés, et seuls les arrêts agissent. Vérifiez les câbles, puis relancez la recherche. Si vous avez remplacé le module volontairement, acceptez la chaîne telle quelle (Diagnostic de la chaîne)&#xa0;: tout sauf son nom est alors à régler de nouveau, et ses positions sont retirées des points.</translation>
    </message>
    <message>
        <source>Modules from %1 on are new. If they belong there, accept the chain as found.</source>
        <translation>Les modules à partir de %1 sont nouveaux. S’ils sont à leur place, acceptez la chaîne telle quelle.</translation>
    </message>
    <message>
        <source>Check its power and cable; use the hardware stop if its motor moves. The panel retries from time to time.</source>
        <translation>Vérifiez son alimentation et son câble&#x202f;; utilisez l’arrêt câblé si son moteur bouge. Le programme réessaie de temps en temps.</translation>
    </message>
    <message>
        <source>Modules between it and the PC may not answer until it has its address again. Restart the network when it is safe to stop all motors and lose their positions.</source>
        <translation>Les modules entre lui et le PC peuvent ne pas répondre tant qu’il n’a pas retrouvé son adresse. Redémarrez le réseau dès que tous les moteurs peuvent s’arrêter et perdre leur position.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nouveau</translation>
    </message>
    <message>
        <source>different module</source>
        <translation>autre module</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>absent</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>ne répond pas</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>non interrogé</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>redémarré</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>aucun groupe</translation>
    </message>
    <message>
        <source>This chain is new: it has %1.</source>
        <translation>Cette chaîne est nouvelle&#xa0;: elle comporte %1.</translation>
    </message>
    <message>
        <source>Compare the list with the labels on the modules, starting with the module farthest from the PC. If it is right, accept the chain as found: from then on, missing and replaced modules are reported.</source>
        <translation>Comparez la liste aux étiquettes des modules, en commençant par le plus éloigné du PC. Si elle est juste, acceptez la chaîne telle quelle&#xa0;: dès lors, les modules absents ou remplacés sont signalés.</translation>
    </message>
    <message>
        <source>Looking for modules…</source>
        <translation>Recherche des modules…</translation>
    </message>
    <message>
        <source>Home: %1</source>
        <translation>Origine&#xa0;: %1</translation>
    </message>
    <message>
        <source>Home: unknown</source>
        <translation>Origine&#xa0;: inconnue</translation>
    </message>
    <message>
        <source>Home is unknown. Search for home, or move there and choose Save as home. A restart of the module loses home again.</source>
        <translation>L’origine est inconnue. Lancez la prise d’origine, ou amenez l’axe à l’origine et choisissez «&#xa0;Enregistrer comme origine&#xa0;». Un redémarrage du module fait de nouveau perdre l’origine.</translation>
    </message>
    <message>
        <source>Home is at %1. A search found it %2 min ago.</source>
        <translation>L’origine est à %1. Une recherche l’a trouvée il y a %2&#xa0;min.</translation>
    </message>
    <message>
        <source>Home is at %1. It was saved %2 min ago.</source>
        <translation>L’origine est à %1. Elle a été enregistrée il y a %2&#xa0;min.</translation>
    </message>
    <message>
        <source>Makes the present position 0. The motor does not move. The old zero is lost: from then on all positions count from here.</source>
        <translation>Met la position actuelle à 0. Le moteur ne bouge pas. L’ancien zéro est perdu&#xa0;: toutes les positions sont ensuite comptées à partir d’ici.</translation>
    </message>
    <message>
        <source>This moves home from %1 to %2.</source>
        <translation>L’origine passe ainsi de %1 à %2.</translation>
    </message>
    <message>
        <source>The position that the chip captured or saved last. A limit stop changes it, too; Zero here does not. Go home does not use it.</source>
        <translation>Dernière position capturée ou enregistrée par la puce. Un arrêt sur fin de course la modifie aussi&#x202f;; «&#xa0;Zéro ici&#xa0;» ne la modifie pas. «&#xa0;Aller à l’origine&#xa0;» ne l’utilise pas.</translation>
    </message>
    <message>
        <source>Home: %1, not verified</source>
        <translation>Origine&#xa0;: %1, non vérifiée</translation>
    </message>
    <message>
        <source>Home is at %1, not verified: restored %2 min ago from the last known position. Search for home to verify it.</source>
        <translation>L’origine est à %1, non vérifiée&#xa0;: rétablie il y a %2&#xa0;min d’après la dernière position connue. Lancez la prise d’origine pour la vérifier.</translation>
    </message>
    <message>
        <source>Home is at %1. You confirmed the position %2 min ago.</source>
        <translation>L’origine est à %1. Vous avez confirmé la position il y a %2&#xa0;min.</translation>
    </message>
    <message>
        <source>That is %1; this module can be given at most %2.</source>
        <translation>Cela fait %1&#x202f;; ce module accepte au plus %2.</translation>
    </message>
    <message>
        <source>That is %1; the highest velocity of this axis is %2 (Axis page).</source>
        <translation>Cela fait %1&#x202f;; la vitesse maximale de cet axe est %2 (page Axe).</translation>
    </message>
    <message>
        <source>Lowest position reached: %1. Move forward.</source>
        <translation>Position minimale atteinte&#xa0;: %1. Repartez en avant.</translation>
    </message>
    <message>
        <source>Highest position reached: %1. Move in reverse.</source>
        <translation>Position maximale atteinte&#xa0;: %1. Repartez en arrière.</translation>
    </message>
    <message>
        <source>No travel limits are set.</source>
        <translation>Aucune limite de course définie.</translation>
    </message>
    <message>
        <source>Not in force: home is unknown. Search for it, save it, or confirm the position.</source>
        <translation>Inactives&#xa0;: l’origine est inconnue. Recherchez-la, enregistrez-la ou confirmez la position.</translation>
    </message>
    <message>
        <source>In force: not below %1.</source>
        <translation>Actives&#xa0;: pas en dessous de %1.</translation>
    </message>
    <message>
        <source>In force: not above %1.</source>
        <translation>Actives&#xa0;: pas au-dessus de %1.</translation>
    </message>
    <message>
        <source>In force: from %1 to %2.</source>
        <translation>Actives&#xa0;: de %1 à %2.</translation>
    </message>
    <message>
        <source>Travel limits not in force</source>
        <translation>Limites de course inactives</translation>
    </message>
    <message>
        <source>At the lowest position</source>
        <translation>À la position minimale</translation>
    </message>
    <message>
        <source>At the highest position</source>
        <translation>À la position maximale</translation>
    </message>
    <message>
        <source>Below the lowest position</source>
        <translation>Sous la position minimale</translation>
    </message>
    <message>
        <source>Above the highest position</source>
        <translation>Au-delà de la position maximale</translation>
    </message>
    <message>
        <source>Look at the axis first: is %1 really at %2? If so, home is at position 0, and the travel limits apply from there. If not, they protect the wrong range.</source>
        <translation>Regardez d’abord l’axe&#xa0;: %1 est-il vraiment à %2&#x202f;? Si oui, l’origine est à la position 0, et les limites de course s’appliquent à partir de là. Sinon, elles protègent la mauvaise plage.</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, below the lowest position %2. Lower that position, or change the backlash or its direction (Axis page).</source>
        <translation>Pour rattraper le jeu, le déplacement ferait demi-tour à %1, sous la position minimale %2. Abaissez cette position, ou modifiez le jeu ou son sens (page Axe).</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, above the highest position %2. Raise that position, or change the backlash or its direction (Axis page).</source>
        <translation>Pour rattraper le jeu, le déplacement ferait demi-tour à %1, au-dessus de la position maximale %2. Relevez cette position, ou modifiez le jeu ou son sens (page Axe).</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the lowest position is %1 (Axis page).</source>
        <translation>C’est hors des limites de course : la position minimale est %1 (page Axe).</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the highest position is %1 (Axis page).</source>
        <translation>C’est hors des limites de course : la position maximale est %1 (page Axe).</translation>
    </message>
    <message>
        <source>The highest velocity is set on the Axis page.</source>
        <translation>La vitesse maximale se règle sur la page Axe.</translation>
    </message>
    <message>
        <source>The max jog speed and the highest velocity are set on the Axis page.</source>
        <translation>La vitesse de jog max. et la vitesse maximale se règlent sur la page Axe.</translation>
    </message>
    <message>
        <source>from &quot;%1&quot;</source>
        <translation>depuis «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 by the counter</source>
        <translation>%1 d’après le compteur</translation>
    </message>
    <message>
        <source>Positions count from &quot;%1&quot;.</source>
        <translation>Les positions sont comptées depuis «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>It is not known any more where &quot;%1&quot; is. Choose the work offset again, or clear it (Axis page).</source>
        <translation>On ne sait plus où se trouve «&#xa0;%1&#xa0;». Choisissez de nouveau le décalage de travail ou effacez-le (page Axe).</translation>
    </message>
    <message>
        <source>steps/s²</source>
        <translation>pas/s²</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>incr./s</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>incr./s²</translation>
    </message>
    <message>
        <source>%1 (%2 of 255)</source>
        <translation>%1 (%2 sur 255)</translation>
    </message>
    <message>
        <source>Oscillating ± %1 at about %2 Hz</source>
        <translation>Oscille de ± %1 à environ %2&#xa0;Hz</translation>
    </message>
    <message>
        <source>Oscillating ± %1</source>
        <translation>Oscille de ± %1</translation>
    </message>
    <message>
        <source>Hunting ± %1 every %2 s. Lower Ki.</source>
        <translation>Pompage de ± %1 toutes les %2 s. Diminuez Ki.</translation>
    </message>
    <message>
        <source>%1, hunting</source>
        <translation>%1, pompage</translation>
    </message>
    <message>
        <source>%1, oscillating</source>
        <translation>%1, oscille</translation>
    </message>
    <message>
        <source>%1, pushing at OL</source>
        <translation>%1, pousse à OL</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1, écart de %2</translation>
    </message>
    <message>
        <source>Kp is 0: the servo brakes the motor but holds no position.</source>
        <translation>Kp est à 0&#xa0;: le servo freine le moteur mais ne maintient aucune position.</translation>
    </message>
    <message>
        <source>%1 off the position to hold, and pushing with up to the full output limit. Something may be in the way.</source>
        <translation>À %1 de la position à maintenir, et pousse jusqu’à toute la limite de sortie. Quelque chose gêne peut-être.</translation>
    </message>
    <message>
        <source>%1 off the position to hold: friction, a load or an obstacle is stronger. A higher Kp, or an integral (Ki, IL), pushes more.</source>
        <translation>À %1 de la position à maintenir : un frottement, une charge ou un obstacle est plus fort. Un Kp plus grand, ou une intégrale (Ki, IL), pousse davantage.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; is missing.</source>
        <translation>Le paramètre «&#xa0;%1&#xa0;» manque.</translation>
    </message>
    <message>
        <source>These parameters are missing: %1.</source>
        <translation>Ces paramètres manquent&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; has the wrong type, or is out of its range.</source>
        <translation>Le paramètre «&#xa0;%1&#xa0;» est d’un mauvais type ou hors de ses limites.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here.</source>
        <translation>Le paramètre «&#xa0;%1&#xa0;» doit ici être compris entre %2 et %3.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here, in either direction. %3 is the max jog speed of the axis.</source>
        <translation>Le paramètre «&#xa0;%1&#xa0;» doit ici être compris entre %2 et %3, dans les deux sens. %3 est la vitesse de jog max. de l’axe.</translation>
    </message>
    <message>
        <source>There is no such axis.</source>
        <translation>Cet axe n’existe pas.</translation>
    </message>
    <message>
        <source>There is no sequence or point of that name.</source>
        <translation>Il n’y a ni séquence ni point de ce nom.</translation>
    </message>
    <message>
        <source>This program may not move motors now: call request_control first.</source>
        <translation>Ce programme ne peut pas déplacer les moteurs pour l’instant&#xa0;: appelez d’abord request_control.</translation>
    </message>
    <message>
        <source>Call hello first.</source>
        <translation>Appelez d’abord hello.</translation>
    </message>
    <message>
        <source>This panel speaks version %1 of the protocol, and the program version %2.</source>
        <translation>Ce panneau parle la version %1 du protocole, et le programme la version %2.</translation>
    </message>
    <message>
        <source>It was cancelled by a stop or by another command.</source>
        <translation>Un arrêt ou une autre commande l’a annulé.</translation>
    </message>
    <message>
        <source>Motors were stopped.</source>
        <translation>Des moteurs ont été arrêtés.</translation>
    </message>
    <message>
        <source>The user has taken control back.</source>
        <translation>L’utilisateur a repris le contrôle.</translation>
    </message>
    <message>
        <source>The user has commanded a motor.</source>
        <translation>L’utilisateur a commandé un moteur.</translation>
    </message>
    <message>
        <source>The chain is no longer connected.</source>
        <translation>La chaîne n’est plus connectée.</translation>
    </message>
    <message>
        <source>Other programs cannot connect.</source>
        <translation>D’autres programmes ne peuvent pas se connecter.</translation>
    </message>
    <message>
        <source>Another panel already lets programs in at %1.</source>
        <translation>Un autre panneau laisse déjà entrer des programmes par %1.</translation>
    </message>
    <message>
        <source>%1 is a link, belongs to another user, or is open to others. Remove it, and try again.</source>
        <translation>%1 est un lien, appartient à un autre utilisateur ou est ouvert à d’autres. Supprimez-le et réessayez.</translation>
    </message>
    <message>
        <source>%1 cannot be created.</source>
        <translation>%1 ne peut pas être créé.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has connected. It may read, stop motors and switch them off, but not move them.</source>
        <translation>Le programme «&#xa0;%1&#xa0;» s’est connecté. Il peut lire, arrêter les moteurs et les couper, mais pas les déplacer.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected; the motors that it moved are stopped.</source>
        <translation>Le programme «&#xa0;%1&#xa0;» s’est déconnecté&#xa0;; les moteurs qu’il a déplacés sont arrêtés.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected.</source>
        <translation>Le programme «&#xa0;%1&#xa0;» s’est déconnecté.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot;: %2</source>
        <translation>Programme «&#xa0;%1&#xa0;»&#xa0;: %2</translation>
    </message>
    <message>
        <source>This line is not JSON.</source>
        <translation>Cette ligne n’est pas du JSON.</translation>
    </message>
    <message>
        <source>A request is an object with method, params (an object) and id.</source>
        <translation>Une requête est un objet avec method, params (un objet) et id.</translation>
    </message>
    <message>
        <source>There is no such method.</source>
        <translation>Cette méthode n’existe pas.</translation>
    </message>
    <message>
        <source>The line is lent at %1. No program has used it yet.</source>
        <translation>La ligne est prêtée sur %1. Aucun programme ne l’a encore utilisée.</translation>
    </message>
    <message>
        <source>A program has the line, at %1.</source>
        <translation>Un programme a la ligne, sur %1.</translation>
    </message>
    <message>
        <source>All motors were commanded to stop, and the program is held off.</source>
        <translation>L’arrêt a été commandé à tous les moteurs, et le programme est tenu à l’écart.</translation>
    </message>
    <message>
        <source>What it sends is dropped. Release lets it continue; it does not know what it has missed.</source>
        <translation>Ce qu’il envoie est ignoré. Laisser continuer lui rend la ligne&#xa0;; il ne sait pas ce qu’il a manqué.</translation>
    </message>
    <message>
        <source>The program has closed %1, and the line is no longer lent.</source>
        <translation>Le programme a fermé %1, et la ligne n’est plus prêtée.</translation>
    </message>
    <message>
        <source>The line is no longer lent.</source>
        <translation>La ligne n’est plus prêtée.</translation>
    </message>
    <message>
        <source>The line was not lent.</source>
        <translation>La ligne n’a pas été prêtée.</translation>
    </message>
    <message>
        <source>The chain was busy, or a motor was moving. Stop the motors, and try again.</source>
        <translation>La chaîne était occupée, ou un moteur était en mouvement. Arrêtez les moteurs et réessayez.</translation>
    </message>
    <message>
        <source>There is something at %1 already. Choose another path.</source>
        <translation>Il y a déjà quelque chose sur %1. Choisissez un autre chemin.</translation>
    </message>
    <message>
        <source>No terminal can be made at %1. Choose a path in a folder of your own.</source>
        <translation>Aucun terminal ne peut être créé sur %1. Choisissez un chemin dans un de vos dossiers.</translation>
    </message>
    <message>
        <source>LENT at %1 — stopped; the program is held off.</source>
        <translation>PRÊTÉE sur %1 — arrêté&#xa0;; le programme est tenu à l’écart.</translation>
    </message>
    <message>
        <source>LENT at %1 — a program has the line. No travel limit or other check of the panel protects the motors; STOP ALL does.</source>
        <translation>PRÊTÉE sur %1 — un programme a la ligne. Aucune limite de course ni autre contrôle du panneau ne protège les moteurs&#xa0;; TOUT ARRÊTER agit.</translation>
    </message>
    <message>
        <source>LENT at %1 — no program yet.</source>
        <translation>PRÊTÉE sur %1 — aucun programme pour l’instant.</translation>
    </message>
    <message>
        <source>The motor did not stay within the arrival tolerance of its axis.</source>
        <translation>Le moteur n’est pas resté dans la tolérance d’arrivée de son axe.</translation>
    </message>
    <message>
        <source>This pin is not set as an output. Make it an output first.</source>
        <translation>Cette broche n’est pas réglée en sortie. Réglez-la d’abord en sortie.</translation>
    </message>
    <message>
        <source>The outputs of this module, or their directions, are unknown. Set them once first.</source>
        <translation>Les sorties de ce module, ou leurs directions, sont inconnues. Réglez-les d’abord une fois.</translation>
    </message>
    <message>
        <source>Several axes have this name. Use the number of the axis, or give each its own name.</source>
        <translation>Plusieurs axes portent ce nom. Utilisez le numéro de l’axe, ou donnez à chacun son propre nom.</translation>
    </message>
</context>
<context>
    <name>nmc::AmplifierBox</name>
    <message>
        <source>3-phase commutation</source>
        <translation>Commutation triphasée</translation>
    </message>
    <message>
        <source>For a brushless motor with Hall sensors and a 3-phase amplifier. Off: a brush motor.</source>
        <translation>Pour un moteur sans balais à capteurs Hall et un amplificateur triphasé. Inactif&#xa0;: moteur à balais.</translation>
    </message>
    <message>
        <source>Antiphase PWM</source>
        <translation>PWM en antiphase</translation>
    </message>
    <message>
        <source>For a locked-antiphase amplifier: 50 % PWM is zero output. Off: PWM and direction.</source>
        <translation>Pour un amplificateur dont le repos correspond à 50&#x202f;% de PWM. Inactif&#xa0;: PWM et direction.</translation>
    </message>
    <message>
        <source>Step and direction input</source>
        <translation>Entrée pas et direction</translation>
    </message>
    <message>
        <source>The motor follows step pulses at the limit pins instead of commands. The limit inputs then give no protection.</source>
        <translation>Le moteur suit les impulsions de pas sur les broches de fin de course au lieu des commandes. Les fins de course ne protègent alors plus rien.</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz.</source>
        <translation>Points de trajectoire à 60 et 120&#xa0;Hz au lieu de 30 et 60&#xa0;Hz.</translation>
    </message>
    <message>
        <source>Apply…</source>
        <translation>Appliquer…</translation>
    </message>
    <message>
        <source>Apply the amplifier settings</source>
        <translation>Appliquer les réglages de l’amplificateur</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Définir</translation>
    </message>
    <message>
        <source>Set the step multiplier</source>
        <translation>Définir le multiplicateur de pas</translation>
    </message>
    <message>
        <source>Keep its address and group</source>
        <translation>Conserver son adresse et son groupe</translation>
    </message>
    <message>
        <source>It comes back at this address after a power cycle, without a search.</source>
        <translation>Il revient à cette adresse après une coupure d’alimentation, sans recherche.</translation>
    </message>
    <message>
        <source>Amplifier on at power-up</source>
        <translation>Amplificateur actif au démarrage</translation>
    </message>
    <message>
        <source>AMP_EN goes high by itself after each power-up.</source>
        <translation>AMP_EN passe de lui-même à l’état haut à chaque mise sous tension.</translation>
    </message>
    <message>
        <source>Servo on at power-up</source>
        <translation>Servo actif au démarrage</translation>
    </message>
    <message>
        <source>The servo switches on by itself after each power-up, with the saved gains, even with no panel connected.</source>
        <translation>Le moteur maintient de lui-même sa position à chaque mise sous tension, avec les gains enregistrés, avant même qu’un programme soit connecté.</translation>
    </message>
    <message>
        <source>Save in module…</source>
        <translation>Enregistrer dans le module…</translation>
    </message>
    <message>
        <source>Save in module: configuration for power-up</source>
        <translation>Enregistrer dans le module la configuration de mise sous tension</translation>
    </message>
    <message>
        <source>Erase saved…</source>
        <translation>Effacer la configuration…</translation>
    </message>
    <message>
        <source>Erase saved configuration of the module</source>
        <translation>Effacer la configuration enregistrée du module</translation>
    </message>
    <message>
        <source>Limit inputs</source>
        <translation>Fins de course</translation>
    </message>
    <message>
        <source>do nothing</source>
        <translation>sans effet</translation>
    </message>
    <message>
        <source>stop abruptly</source>
        <translation>arrêt brutal</translation>
    </message>
    <message>
        <source>switch the motor off</source>
        <translation>moteur coupé</translation>
    </message>
    <message>
        <source>Amplifier settings of the module</source>
        <translation>Réglages d’amplificateur du module</translation>
    </message>
    <message>
        <source>Step multiplier</source>
        <translation>Multiplicateur de pas</translation>
    </message>
    <message>
        <source>Counts that one step pulse moves the motor.</source>
        <translation>Nombre d’incréments dont une impulsion de pas déplace le moteur.</translation>
    </message>
    <message>
        <source>Saved in the module, for power-up</source>
        <translation>Enregistré dans le module, pour la mise sous tension</translation>
    </message>
    <message>
        <source>Saves these choices, the settings above, the gains, the velocity and the acceleration as the module has them now. They come back at each power-up. 3-phase and antiphase come back after a reset, too. Both buttons restart the module: its motor switches off, and it needs its gains again.</source>
        <translation>Enregistre ces choix, les réglages ci-dessus, les gains, la vitesse et l’accélération tels que le module les a maintenant. Ils reviennent à chaque mise sous tension. Triphasé et antiphase reviennent aussi après une réinitialisation. Les deux boutons redémarrent le module&#xa0;: son moteur est coupé, et ses gains doivent lui être renvoyés.</translation>
    </message>
    <message>
        <source>? Unknown: nothing has been applied in this connection, and the settings cannot be read back. The module may have saved settings.</source>
        <translation>? Inconnu&#xa0;: rien n’a été appliqué pendant cette connexion, et le module ne le dit pas. Il peut avoir des réglages enregistrés.</translation>
    </message>
    <message>
        <source>✓ Applied: 3-phase %1, antiphase %2, step and direction %3, limits %4.</source>
        <translation>✓ Appliqué&#xa0;: triphasé %1, antiphase %2, pas et direction %3, fins de course %4.</translation>
    </message>
    <message>
        <source>Step and direction uses the limit pins: set the limit inputs to do nothing.</source>
        <translation>En mode pas et direction, les broches de fin de course en sont les entrées&#xa0;: choisissez «&#xa0;sans effet&#xa0;» pour les fins de course.</translation>
    </message>
    <message>
        <source>The module already has these settings.</source>
        <translation>Le module a ces réglages.</translation>
    </message>
    <message>
        <source>Takes AMP_EN low and sends these settings.</source>
        <translation>Met AMP_EN à l’état bas et envoie ces réglages.</translation>
    </message>
    <message>
        <source>Sends the module&apos;s present gains with this multiplier.</source>
        <translation>Envoie les gains du module avec ce multiplicateur.</translation>
    </message>
    <message>
        <source>Apply the amplifier settings first: the module&apos;s present settings are unknown.</source>
        <translation>Appliquez d’abord les réglages de l’amplificateur&#xa0;: l’état actuel du module est inconnu.</translation>
    </message>
    <message>
        <source>Saves the module&apos;s present settings and restarts it.</source>
        <translation>Enregistre ce que le module a maintenant, et le redémarre.</translation>
    </message>
    <message>
        <source>Erases the module&apos;s saved configuration and restarts it.</source>
        <translation>Fait oublier au module ce qu’il a enregistré, et le redémarre.</translation>
    </message>
    <message>
        <source>Apply amplifier settings</source>
        <translation>Appliquer les réglages de l’amplificateur</translation>
    </message>
    <message>
        <source>Apply these settings to %1? If 3-phase, antiphase or step and direction do not match the amplifier and its wiring, the amplifier can be destroyed, or the motor can run away once it is enabled.</source>
        <translation>Appliquer ces réglages à %1&#x202f;? Un réglage triphasé, antiphase ou pas et direction qui ne convient pas à l’amplificateur ou à son câblage peut détruire l’amplificateur, ou faire s’emballer le moteur dès son activation.</translation>
    </message>
    <message>
        <source>Apply settings</source>
        <translation>Appliquer les réglages</translation>
    </message>
    <message>
        <source>Save the configuration of %1? It takes effect at each power-up, whatever is connected then. The module restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>Enregistrer la configuration de %1&#x202f;? Elle revient à chaque mise sous tension, quoi qu’il y ait alors de raccordé. Le module redémarre maintenant&#xa0;: son moteur est coupé, et ses gains doivent lui être renvoyés.</translation>
    </message>
    <message>
        <source>Its motor will be driven right after power-up, without a command.</source>
        <translation>Son moteur sera piloté dès la mise sous tension, sans commande.</translation>
    </message>
    <message>
        <source>Save in module</source>
        <translation>Enregistrer dans le module</translation>
    </message>
    <message>
        <source>Save and restart</source>
        <translation>Enregistrer et redémarrer</translation>
    </message>
    <message>
        <source>Erase saved configuration</source>
        <translation>Effacer la configuration enregistrée</translation>
    </message>
    <message>
        <source>Erase the saved configuration of %1? From the next power-up it starts with its default settings. It restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>Effacer ce que %1 a enregistré&#x202f;? À la prochaine mise sous tension, il démarre comme un module neuf. Il redémarre maintenant&#xa0;: son moteur est coupé, et ses gains doivent lui être renvoyés.</translation>
    </message>
    <message>
        <source>Erase and restart</source>
        <translation>Effacer et redémarrer</translation>
    </message>
    <message>
        <source>What the module does by itself when limit 1 closes while it counts up, or limit 2 while it counts down. It stays armed.</source>
        <translation>Ce que le module fait de lui-même quand le fin de course 1 se ferme pendant qu’il compte vers le haut, ou le fin de course 2 pendant qu’il compte vers le bas. Cela reste armé.</translation>
    </message>
    <message>
        <source>Undo the last edit of the amplifier settings</source>
        <translation>Annuler la dernière modification des réglages de l’amplificateur</translation>
    </message>
    <message>
        <source>Redo the edit of the amplifier settings</source>
        <translation>Rétablir la modification des réglages de l’amplificateur</translation>
    </message>
    <message>
        <source>Revert the amplifier settings to those last sent</source>
        <translation>Abandonner&#xa0;: revenir aux derniers réglages de l’amplificateur envoyés</translation>
    </message>
    <message>
        <source>Restores the amplifier settings last sent. Sends nothing.</source>
        <translation>Rétablit les derniers réglages de l’amplificateur envoyés. N’envoie rien.</translation>
    </message>
    <message>
        <source>Clears the fields: no amplifier settings have been sent yet. Sends nothing.</source>
        <translation>Vide les champs&#xa0;: aucun réglage de l’amplificateur n’a encore été envoyé. N’envoie rien.</translation>
    </message>
    <message>
        <source>Choose what the limit inputs do.</source>
        <translation>Choisissez l’effet des entrées de fin de course.</translation>
    </message>
    <message>
        <source>A task is running on this module: wait for its end, or cancel it.</source>
        <translation>Une tâche est en cours sur ce module&#xa0;: attendez sa fin ou annulez-la.</translation>
    </message>
</context>
<context>
    <name>nmc::AskDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
</context>
<context>
    <name>nmc::AxesPage</name>
    <message>
        <source>All axes</source>
        <translation>Tous les axes</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Lent</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Rapide</translation>
    </message>
    <message>
        <source>Slow jog</source>
        <translation>Lent, pour le jog</translation>
    </message>
    <message>
        <source>Fast jog</source>
        <translation>Rapide, pour le jog</translation>
    </message>
    <message>
        <source>Step of all axes</source>
        <translation>Pas de tous les axes</translation>
    </message>
    <message>
        <source>Each axis at its own jog speed.</source>
        <translation>Chaque axe à sa propre vitesse de jog.</translation>
    </message>
    <message>
        <source>Each axis at its own max jog speed, set on its Axis or Parameters page.</source>
        <translation>Chaque axe à sa propre vitesse de jog max., définie sur sa page Axe ou Paramètres.</translation>
    </message>
    <message>
        <source>Distance that one click on Step moves an axis, in its own unit.</source>
        <translation>Distance dont un clic sur «&#xa0;Pas&#xa0;» déplace un axe, dans son unité.</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 unités</translation>
    </message>
    <message>
        <source>Enable all</source>
        <translation>Tout activer</translation>
    </message>
    <message>
        <source>Enable all motors</source>
        <translation>Tout activer&#xa0;: tous les moteurs</translation>
    </message>
    <message>
        <source>Home all axes, one after the other</source>
        <translation>Prendre les origines des axes, l’un après l’autre</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Homing is not set up for any axis. Set it up on each Homing page.</source>
        <translation>La prise d’origine n’est configurée pour aucun axe. Configurez-la sur chaque page Prise d’origine.</translation>
    </message>
    <message>
        <source>All motors are already enabled.</source>
        <translation>Tous les moteurs sont déjà activés.</translation>
    </message>
    <message>
        <source>Enables every motor at its present position.</source>
        <translation>Active chaque moteur à sa position actuelle.</translation>
    </message>
    <message>
        <source>Homes one axis after the other, in the order of the table, with each axis&apos;s homing settings. Any stop ends it.</source>
        <translation>Effectue la prise d’origine des axes l’un après l’autre, dans l’ordre du tableau, avec les réglages de chacun. Tout arrêt y met fin.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisBox</name>
    <message>
        <source>Name of the axis</source>
        <translation>Nom de l’axe</translation>
    </message>
    <message>
        <source>For example: Z axis</source>
        <translation>Par exemple&#xa0;: axe Z</translation>
    </message>
    <message>
        <source>The name of this axis in the list, in messages and in files.</source>
        <translation>Nom de cet axe dans la liste, dans les messages et dans les fichiers.</translation>
    </message>
    <message>
        <source>N&amp;ame</source>
        <translation>No&amp;m</translation>
    </message>
    <message>
        <source>Unit of the axis</source>
        <translation>Unité de l’axe</translation>
    </message>
    <message>
        <source>native counts</source>
        <translation>incréments natifs</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>unité personnalisée</translation>
    </message>
    <message>
        <source>The unit for positions and speeds. Changing it keeps every physical value and sends nothing.</source>
        <translation>Unité des positions et des vitesses. En changer conserve chaque valeur physique et n’envoie rien.</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>&amp;Unité</translation>
    </message>
    <message>
        <source>Counts in 1 unit</source>
        <translation>Incréments dans 1 unité</translation>
    </message>
    <message>
        <source>Counts or steps per unit.</source>
        <translation>Incréments ou pas par unité.</translation>
    </message>
    <message>
        <source>Symbol of the unit</source>
        <translation>Symbole de l’unité</translation>
    </message>
    <message>
        <source>Shown after the numbers, for example µl.</source>
        <translation>Affiché après les nombres, par exemple µl.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>Jog is never faster than this.</source>
        <translation>Le jog n’est jamais plus rapide.</translation>
    </message>
    <message>
        <source>Max &amp;jog speed</source>
        <translation>Jog jus&amp;qu’à</translation>
    </message>
    <message>
        <source>A/D scale, per count</source>
        <translation>Échelle A/D, par unité</translation>
    </message>
    <message>
        <source>The value of one A/D count, for example 5 V / 255, or amperes from the amplifier&apos;s current sense.</source>
        <translation>Valeur d’une unité A/D, par exemple 5&#xa0;V / 255, ou des ampères d’après la mesure de courant de l’amplificateur.</translation>
    </message>
    <message>
        <source>A/D at &amp;0</source>
        <translation>A/D à &amp;0</translation>
    </message>
    <message>
        <source>Unit of the A/D value</source>
        <translation>Unité de la valeur A/D</translation>
    </message>
    <message>
        <source>A, V, or whatever the A/D input measures.</source>
        <translation>A, V, ou ce que mesure l’entrée A/D.</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>Unité A/D</translation>
    </message>
    <message>
        <source>%1 in 1 %2</source>
        <translation>%1 dans 1 %2</translation>
    </message>
    <message>
        <source>Calculate…</source>
        <translation>Calculer…</translation>
    </message>
    <message>
        <source>Calculate the unit from encoder, gear and screw</source>
        <translation>Calculer l’unité à partir du codeur, du réducteur et de la vis</translation>
    </message>
    <message>
        <source>Calculates the unit from the data of encoder, gear and screw. Sends nothing.</source>
        <translation>Calcule l’unité d’après les caractéristiques du codeur, du réducteur et de la vis. N’envoie rien.</translation>
    </message>
    <message>
        <source>reversed: forward counts down</source>
        <translation>inversé&#xa0;: avant compte vers le bas</translation>
    </message>
    <message>
        <source>Reverses positions, directions and travel limits of this axis on the screen. Sends nothing.</source>
        <translation>Inverse à l’écran les positions, les sens et les limites de course de cet axe. N’envoie rien.</translation>
    </message>
    <message>
        <source>Axis %1 has the same name, so programs can call neither by it.</source>
        <translation>L’axe %1 porte le même nom : les programmes ne peuvent désigner ainsi ni l’un ni l’autre.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisRow</name>
    <message>
        <source>State of %1</source>
        <translation>État de %1</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position de %1</translation>
    </message>
    <message>
        <source>Hold to move %1 in reverse</source>
        <translation>Jog&#xa0;: %1 en arrière tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Hold to move %1 forward</source>
        <translation>Jog&#xa0;: %1 en avant tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Step %1 in reverse</source>
        <translation>Pas de %1 en arrière</translation>
    </message>
    <message>
        <source>Step %1 forward</source>
        <translation>Pas de %1 en avant</translation>
    </message>
    <message>
        <source>Home earlier</source>
        <translation>Origine plus tôt</translation>
    </message>
    <message>
        <source>Home %1 one place earlier</source>
        <translation>Origine de %1 un rang plus tôt</translation>
    </message>
    <message>
        <source>This step is less than one count of this axis, or beyond its range. Choose another step.</source>
        <translation>Ce pas est inférieur à un incrément de cet axe, ou hors de sa plage. Choisissez un autre pas.</translation>
    </message>
    <message>
        <source>Moves forward by the step above, then holds.</source>
        <translation>Se déplace en avant du pas ci-dessus, puis maintient la position.</translation>
    </message>
    <message>
        <source>Moves in reverse by the step above, then holds.</source>
        <translation>Se déplace en arrière du pas ci-dessus, puis maintient la position.</translation>
    </message>
    <message>
        <source>Homing is not set up for this axis. Set it up on its Homing page.</source>
        <translation>La prise d’origine n’est pas configurée pour cet axe. Configurez-la sur sa page Prise d’origine.</translation>
    </message>
    <message>
        <source>Home all starts with this axis.</source>
        <translation>«&#xa0;Prendre les origines&#xa0;» commence par cet axe.</translation>
    </message>
    <message>
        <source>Home all homes this axis as number %1. Click to move it one place earlier. Nothing moves.</source>
        <translation>«&#xa0;Prendre les origines&#xa0;» traite cet axe au rang %1. Un clic l’avance d’un rang. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Home: %1.</source>
        <translation>Origine&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Home: –</source>
        <translation>Origine&#xa0;: –</translation>
    </message>
</context>
<context>
    <name>nmc::Banner</name>
    <message>
        <source>Important message</source>
        <translation>Message important</translation>
    </message>
    <message>
        <source>Hides this message here. It stays in the message list.</source>
        <translation>Masque ce message ici. Il reste dans la liste des messages.</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>Masquer ce message</translation>
    </message>
    <message>
        <source>Shows the full text and all other messages in the message list.</source>
        <translation>Affiche le texte complet et tous les autres messages dans la liste des messages.</translation>
    </message>
    <message>
        <source>%1 more…</source>
        <translation>%1 de plus…</translation>
    </message>
    <message>
        <source>Read all…</source>
        <translation>Tout lire…</translation>
    </message>
</context>
<context>
    <name>nmc::Bell</name>
    <message>
        <source>Plays a sound on each fault, and when a search for home, a test, a series of steps or a sequence ends.</source>
        <translation>Émet un son à chaque défaut, et à la fin d’une prise d’origine, d’un essai, d’une série de pas ou d’une séquence.</translation>
    </message>
    <message>
        <source>So&amp;unds</source>
        <translation>&amp;Sons</translation>
    </message>
</context>
<context>
    <name>nmc::BenchTruth</name>
    <message>
        <source>Simulator values of the module</source>
        <translation>Valeurs du module dans le simulateur</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>The true position of the shaft since the simulation started.</source>
        <translation>Position réelle de l’arbre depuis le début de la simulation.</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Compteur de position</translation>
    </message>
    <message>
        <source>The position as the module counts it.</source>
        <translation>Position telle que le module la compte.</translation>
    </message>
    <message>
        <source>True, not calculated.</source>
        <translation>Réelle, non calculée.</translation>
    </message>
    <message>
        <source>Of the shaft.</source>
        <translation>De l’arbre.</translation>
    </message>
    <message>
        <source>Step rate</source>
        <translation>Fréquence de pas</translation>
    </message>
    <message>
        <source>Negative in reverse.</source>
        <translation>Négative en marche arrière.</translation>
    </message>
    <message>
        <source>The sign is the direction.</source>
        <translation>Le signe donne le sens.</translation>
    </message>
    <message>
        <source>255 is full current.</source>
        <translation>255 est le plein courant.</translation>
    </message>
    <message>
        <source>A/D reads</source>
        <translation>Lecture A/D</translation>
    </message>
    <message>
        <source>Violations</source>
        <translation>Violations</translation>
    </message>
    <message>
        <source>Protocol violations that would upset a real module.</source>
        <translation>Violations du protocole qui perturberaient un module réel.</translation>
    </message>
    <message>
        <source>%1 s, module %2: %3, %4</source>
        <translation>%1&#xa0;s, module %2&#xa0;: %3, %4</translation>
    </message>
</context>
<context>
    <name>nmc::BodePlot</name>
    <message>
        <source>No measurement yet. The motor follows sine waves from slow to fast, which shows the response of the loop.</source>
        <translation>Pas encore de mesure. Le moteur suit des sinusoïdes de plus en plus rapides, ce qui révèle la réponse de la boucle.</translation>
    </message>
    <message>
        <source>Magnitude, dB</source>
        <translation>Amplitude, dB</translation>
    </message>
    <message>
        <source>Phase, degrees</source>
        <translation>Phase, degrés</translation>
    </message>
    <message>
        <source>T, closed loop</source>
        <translation>T, boucle fermée</translation>
    </message>
    <message>
        <source>L, open loop</source>
        <translation>L, boucle ouverte</translation>
    </message>
    <message>
        <source>T: closed loop, from command to position. L: open loop; its phase above -180° where it crosses 0 dB is the phase margin. Right of the grey line the baud rate is too low to measure. Bars: two standard deviations of T.</source>
        <translation>T&#xa0;: boucle fermée, de la consigne à la position. L&#xa0;: boucle ouverte&#x202f;; sa phase au-dessus de -180° là où elle coupe 0&#xa0;dB est la marge de phase. À droite de la ligne grise, le débit est trop faible pour mesurer. Barres&#xa0;: deux écarts-types de T.</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Fréquence, Hz</translation>
    </message>
</context>
<context>
    <name>nmc::ChainDialog</name>
    <message>
        <source>Doctor, groups and baud rate</source>
        <translation>Diagnostic, groupes et débit</translation>
    </message>
    <message>
        <source>Doctor</source>
        <translation>Diagnostic</translation>
    </message>
</context>
<context>
    <name>nmc::ChainMenu</name>
    <message>
        <source>Chain &amp;doctor…</source>
        <translation>D&amp;iagnostic de la chaîne…</translation>
    </message>
    <message>
        <source>Compares the expected modules with those found, and shows where the chain probably breaks.</source>
        <translation>Compare les modules attendus à ceux trouvés, et indique où la chaîne est probablement interrompue.</translation>
    </message>
    <message>
        <source>&amp;Groups…</source>
        <translation>&amp;Groupes…</translation>
    </message>
    <message>
        <source>Assigns modules to groups, and starts their loaded moves together.</source>
        <translation>Affecte des modules à des groupes, et lance ensemble leurs déplacements chargés.</translation>
    </message>
    <message>
        <source>B&amp;aud rate of the chain…</source>
        <translation>Dé&amp;bit de la chaîne…</translation>
    </message>
    <message>
        <source>Changes the baud rate of the whole chain.</source>
        <translation>Change le débit de toute la chaîne.</translation>
    </message>
    <message>
        <source>Scans the chain again; nothing is reset.</source>
        <translation>Relance la recherche dans la chaîne&#x202f;; rien n’est réinitialisé.</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost…</source>
        <translation>Redémarrer le &amp;réseau&#xa0;: positions et gains seront perdus…</translation>
    </message>
    <message>
        <source>&amp;Let programs in</source>
        <translation>Laisser entrer des progra&amp;mmes</translation>
    </message>
    <message>
        <source>Other programs on this computer may read the chain, and ask to move motors.</source>
        <translation>D’autres programmes de cet ordinateur peuvent lire la chaîne et demander à déplacer les moteurs.</translation>
    </message>
    <message>
        <source>L&amp;end the line to a program…</source>
        <translation>Prêt&amp;er la ligne à un programme…</translation>
    </message>
    <message>
        <source>A program has the modules for itself; the panel shows what they report.</source>
        <translation>Un programme a les modules pour lui seul&#xa0;; le panneau montre ce qu’ils signalent.</translation>
    </message>
    <message>
        <source>&amp;Copy settings to other axes…</source>
        <translation>&amp;Copier les réglages vers d’autres axes…</translation>
    </message>
    <message>
        <source>Copies gains, limits and other settings to axes of the same type. Shows the differences first.</source>
        <translation>Copie les gains, les limites et d’autres réglages vers des axes du même type. Montre d’abord les différences.</translation>
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
        <translation>%1, %2, à l’adresse %3 sur la ligne</translation>
    </message>
    <message>
        <source>%1 · looking for modules…</source>
        <translation>%1 · recherche des modules…</translation>
    </message>
    <message>
        <source>%1, address %2, %3, %4</source>
        <translation>%1, adresse %2, %3, %4</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>%1, position %2</source>
        <translation>%1, position %2</translation>
    </message>
</context>
<context>
    <name>nmc::ChainView</name>
    <message>
        <source>Modules in wire order, the farthest from the PC first</source>
        <translation>Modules dans l’ordre du câblage, le plus éloigné du PC en premier</translation>
    </message>
    <message>
        <source>Not connected.

Choose a port above and connect. Without hardware, choose the simulator.</source>
        <translation>Non connecté.

Choisissez un port ci-dessus et connectez-vous. Sans matériel, choisissez le simulateur.</translation>
    </message>
</context>
<context>
    <name>nmc::ColourChoice</name>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Système</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>C&amp;lair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Contraste élevé</translation>
    </message>
</context>
<context>
    <name>nmc::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Rechercher une commande</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Rechercher des commandes</translation>
    </message>
    <message>
        <source>Type what to do, for example: go home</source>
        <translation>Saisissez l’action voulue, par exemple&#xa0;: origine</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>What it does, or why it is unavailable</source>
        <translation>Ce qu’elle fait, ou pourquoi elle n’est pas disponible</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>Aucune commande ne correspond.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Impossible actuellement.</translation>
    </message>
    <message>
        <source>Press Enter to run it.</source>
        <translation>Appuyez sur Entrée pour l’exécuter.</translation>
    </message>
    <message>
        <source>Its module is no longer connected.</source>
        <translation>Son module n’est plus connecté.</translation>
    </message>
    <message>
        <source>Press Enter to show it on the module&apos;s page. Nothing is sent.</source>
        <translation>Appuyez sur Entrée pour l’afficher sur la page du module. Rien n’est envoyé.</translation>
    </message>
</context>
<context>
    <name>nmc::ConnectionBar</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Connecter</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Déconnecter</translation>
    </message>
    <message>
        <source>Connection and stop</source>
        <translation>Connexion et arrêt</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>The serial port of the modules, or the simulator.</source>
        <translation>Port série des modules, ou simulateur.</translation>
    </message>
    <message>
        <source>The baud rate for a chain without addresses; a chain that has them keeps its rate.</source>
        <translation>Débit pour une chaîne sans adresses&#x202f;; une chaîne qui en a garde le sien.</translation>
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
        <translation>hors liste</translation>
    </message>
    <message>
        <source>no hardware needed</source>
        <translation>aucun matériel requis</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>Disconnect first.</source>
        <translation>Déconnectez-vous d’abord.</translation>
    </message>
    <message>
        <source>No port is open.</source>
        <translation>Aucun port n’est ouvert.</translation>
    </message>
    <message>
        <source>Closes the port.</source>
        <translation>Ferme le port.</translation>
    </message>
    <message>
        <source>Connect read-&amp;only</source>
        <translation>Connecter en lecture &amp;seule</translation>
    </message>
    <message>
        <source>Other ways to connect</source>
        <translation>Autres modes de connexion</translation>
    </message>
    <message>
        <source>Other ways to connect.</source>
        <translation>Autres modes de connexion.</translation>
    </message>
    <message>
        <source>Opens the port and only reads: only status requests are sent. STOP ALL still works.</source>
        <translation>Ouvre le port et se contente de lire&#xa0;: seules des demandes d’état sont envoyées. TOUT ARRÊTER fonctionne toujours.</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>Bauds</translation>
    </message>
</context>
<context>
    <name>nmc::ControlLineBox</name>
    <message>
        <source>Control line</source>
        <translation>Ligne de commande</translation>
    </message>
    <message>
        <source>Type an nmcsim command, then press Enter: state, set, power-cycle, break, mend, stats, time, fault. Shortcut: Ctrl+L.</source>
        <translation>Saisissez une commande nmcsim, puis appuyez sur Entrée&#xa0;: state, set, power-cycle, break, mend, stats, time, fault. Raccourci&#xa0;: Ctrl+L.</translation>
    </message>
    <message>
        <source>The simulator&apos;s answer</source>
        <translation>Réponse du simulateur</translation>
    </message>
</context>
<context>
    <name>nmc::CopyDialog</name>
    <message>
        <source>Axis to copy from</source>
        <translation>Axe source</translation>
    </message>
    <message>
        <source>The axis whose settings are copied.</source>
        <translation>L’axe dont les réglages sont copiés.</translation>
    </message>
    <message>
        <source>&amp;Show differences</source>
        <translation>&amp;Montrer les différences</translation>
    </message>
    <message>
        <source>Copy settings to other axes</source>
        <translation>Copier les réglages vers d’autres axes</translation>
    </message>
    <message>
        <source>Axes to copy to</source>
        <translation>Axes de destination</translation>
    </message>
    <message>
        <source>Axes with the same type of module and other settings.</source>
        <translation>Axes ayant le même type de module et d’autres réglages.</translation>
    </message>
    <message>
        <source>Settings to copy</source>
        <translation>Réglages à copier</translation>
    </message>
    <message>
        <source>Settings in which at least one of these axes differs.</source>
        <translation>Réglages dans lesquels au moins un de ces axes diffère.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>The differences are shown before anything is changed or sent. Numbers are copied in the units of the module: counts or steps.</source>
        <translation>Les différences sont montrées avant toute modification et tout envoi. Les nombres sont copiés dans les unités du module&#xa0;: incréments ou pas.</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Vers</translation>
    </message>
    <message>
        <source>S&amp;ettings</source>
        <translation>&amp;Réglages</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;De</translation>
    </message>
    <message>
        <source>No other axis with this type of module has other settings.</source>
        <translation>Aucun autre axe ayant ce type de module n’a d’autres réglages.</translation>
    </message>
    <message>
        <source>Select the axes to copy to.</source>
        <translation>Sélectionnez les axes de destination.</translation>
    </message>
    <message>
        <source>Select the settings to copy.</source>
        <translation>Sélectionnez les réglages à copier.</translation>
    </message>
    <message>
        <source>These settings are the same already.</source>
        <translation>Ces réglages sont déjà identiques.</translation>
    </message>
    <message>
        <source>Shows what would change. Nothing is sent.</source>
        <translation>Montre ce qui changerait. Rien n’est envoyé.</translation>
    </message>
</context>
<context>
    <name>nmc::CounterBox</name>
    <message>
        <source>Set and restart</source>
        <translation>Régler et relancer</translation>
    </message>
    <message>
        <source>Set and restart the timer or counter</source>
        <translation>Régler et relancer le timer ou le compteur</translation>
    </message>
    <message>
        <source>Latch inputs</source>
        <translation>Figer les entrées</translation>
    </message>
    <message>
        <source>Latch inputs and counter at the same time</source>
        <translation>Figer les entrées et le compteur au même instant</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Stocker</translation>
    </message>
    <message>
        <source>Store outputs for later</source>
        <translation>Stocker les sorties pour plus tard</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>Apply the stored outputs</source>
        <translation>Écrire les sorties stockées</translation>
    </message>
    <message>
        <source>Counter and synchronous I/O</source>
        <translation>Compteur et E/S synchrones</translation>
    </message>
    <message>
        <source>Counter source</source>
        <translation>Source du compteur</translation>
    </message>
    <message>
        <source>timer, 5 MHz</source>
        <translation>timer, 5&#xa0;MHz</translation>
    </message>
    <message>
        <source>counter of rising edges on IO10</source>
        <translation>compteur de fronts montants sur IO10</translation>
    </message>
    <message>
        <source>Prescaler</source>
        <translation>Prédiviseur</translation>
    </message>
    <message>
        <source>every edge</source>
        <translation>chaque front</translation>
    </message>
    <message>
        <source>every 2nd edge</source>
        <translation>un front sur 2</translation>
    </message>
    <message>
        <source>every 4th edge</source>
        <translation>un front sur 4</translation>
    </message>
    <message>
        <source>every 8th edge</source>
        <translation>un front sur 8</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Compteur</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Comptage</translation>
    </message>
    <message>
        <source>Latched values</source>
        <translation>Valeurs figées</translation>
    </message>
    <message>
        <source>Latched</source>
        <translation>Figé</translation>
    </message>
    <message>
        <source>Outputs to store</source>
        <translation>Sorties à stocker</translation>
    </message>
    <message>
        <source>Add up the outputs: IO1 is 1, IO2 is 2, IO3 is 4, up to IO12, which is 2048.</source>
        <translation>Additionnez les sorties&#xa0;: IO1 vaut 1, IO2 vaut 2, IO3 vaut 4, jusqu’à IO12, qui vaut 2048.</translation>
    </message>
    <message>
        <source>%1 to store</source>
        <translation>%1 à stocker</translation>
    </message>
    <message>
        <source>Counter source unknown: another program has set it.</source>
        <translation>Source du compteur inconnue&#xa0;: un autre programme l’a définie.</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>= %1&#xa0;s</translation>
    </message>
    <message>
        <source>%1 Hz on IO10</source>
        <translation>%1&#xa0;Hz sur IO10</translation>
    </message>
    <message>
        <source>IO12 to IO1: %1, count %2</source>
        <translation>IO12 à IO1&#xa0;: %1, compteur %2</translation>
    </message>
    <message>
        <source>Sends the settings above. The count restarts at 0.</source>
        <translation>Envoie les réglages ci-dessus. Le comptage repart de 0.</translation>
    </message>
    <message>
        <source>Latches all pins and the count at the same moment, and reads them.</source>
        <translation>Fige toutes les broches et le compteur au même instant, et les lit.</translation>
    </message>
    <message>
        <source>Sends these values to the module, which keeps them until you apply them.</source>
        <translation>Envoie ces valeurs au module, qui les garde jusqu’à ce que vous les écriviez sur les sorties.</translation>
    </message>
    <message>
        <source>Store outputs first.</source>
        <translation>Stockez d’abord des sorties.</translation>
    </message>
    <message>
        <source>Applies the stored pin levels and PWM values at the same moment.</source>
        <translation>Écrit au même instant les broches et les valeurs PWM stockées.</translation>
    </message>
    <message>
        <source>stored: %1, PWM %2 and %3</source>
        <translation>stocké&#xa0;: %1, PWM %2 et %3</translation>
    </message>
</context>
<context>
    <name>nmc::CounterTable</name>
    <message>
        <source>Counters of the link</source>
        <translation>Compteurs de la liaison</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Since the chain was found</source>
        <translation>Depuis la découverte de la chaîne</translation>
    </message>
    <message>
        <source>sent: commands that asked for an answer</source>
        <translation>envoyées&#xa0;: commandes demandant une réponse</translation>
    </message>
    <message>
        <source>accepted: answers that passed all checks</source>
        <translation>acceptées&#xa0;: réponses ayant passé tous les contrôles</translation>
    </message>
    <message>
        <source>mean round trip, from sending a command to its complete answer</source>
        <translation>aller-retour moyen, de l’envoi d’une commande à sa réponse complète</translation>
    </message>
    <message>
        <source>longest round trip</source>
        <translation>aller-retour le plus long</translation>
    </message>
    <message>
        <source>retried: commands that were sent again</source>
        <translation>répétées&#xa0;: commandes envoyées de nouveau</translation>
    </message>
    <message>
        <source>timeouts: no answer, or too few bytes</source>
        <translation>délais dépassés&#xa0;: pas de réponse, ou trop peu d’octets</translation>
    </message>
    <message>
        <source>refused by the module: the command reached it with a wrong checksum</source>
        <translation>refusées par le module&#xa0;: la commande l’a atteint avec une somme de contrôle fausse</translation>
    </message>
    <message>
        <source>wrong checksums: the answer was corrupted in transit</source>
        <translation>sommes de contrôle fausses&#xa0;: la réponse a été altérée en chemin</translation>
    </message>
    <message>
        <source>surplus bytes: received without a request</source>
        <translation>octets en trop&#xa0;: reçus sans demande</translation>
    </message>
    <message>
        <source>of these, stale: late answers, discarded</source>
        <translation>dont périmés&#xa0;: réponses tardives, rejetées</translation>
    </message>
    <message>
        <source>resyncs: link checked again after errors</source>
        <translation>resynchronisations&#xa0;: liaison revérifiée après des erreurs</translation>
    </message>
    <message>
        <source>rejected by a rule: checksum right, but answer implausible</source>
        <translation>rejetées par une règle&#xa0;: somme de contrôle juste, mais réponse invraisemblable</translation>
    </message>
    <message>
        <source>  of these: %1</source>
        <translation>  dont&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>nmc::CursorPanel</name>
    <message>
        <source>Shows or hides the cursor readings.</source>
        <translation>Affiche ou masque les mesures des curseurs.</translation>
    </message>
    <message>
        <source>Between the cursors: %1</source>
        <translation>Entre les curseurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>Spectrum…</source>
        <translation>Spectre…</translation>
    </message>
    <message>
        <source>Shows at which frequencies a signal oscillates between the cursors.</source>
        <translation>Affiche les fréquences auxquelles un signal oscille entre les curseurs.</translation>
    </message>
    <message>
        <source>XY view…</source>
        <translation>Vue XY…</translation>
    </message>
    <message>
        <source>Shows one signal over another between the cursors.</source>
        <translation>Affiche un signal en fonction d’un autre, entre les curseurs.</translation>
    </message>
</context>
<context>
    <name>nmc::CursorTable</name>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Crête à crête</translation>
    </message>
    <message>
        <source>Slope, per s</source>
        <translation>Pente, par s</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source> (%1 Hz)</source>
        <translation> (%1&#xa0;Hz)</translation>
    </message>
</context>
<context>
    <name>nmc::DetailsBox</name>
    <message>
        <source>The move has ended; in velocity mode the goal velocity is reached.</source>
        <translation>Le déplacement est terminé&#x202f;; en mode vitesse, la vitesse de consigne est atteinte.</translation>
    </message>
    <message>
        <source>The current limit was reached. Stays set until you clear the sticky bits.</source>
        <translation>La limite de courant a été atteinte. Reste à 1 jusqu’à l’effacement des bits mémorisés.</translation>
    </message>
    <message>
        <source>Motor power is present.</source>
        <translation>L’alimentation moteur est présente.</translation>
    </message>
    <message>
        <source>The position error exceeded its limit, or the servo is off. Stays set until you clear the sticky bits.</source>
        <translation>L’erreur de position a dépassé sa limite, ou le servo est coupé. Reste à 1 jusqu’à l’effacement des bits mémorisés.</translation>
    </message>
    <message>
        <source>The complement of the encoder&apos;s index.</source>
        <translation>Complément de l’index du codeur.</translation>
    </message>
    <message>
        <source>The 32-bit position has wrapped. Stays set until you clear the sticky bits.</source>
        <translation>La position 32 bits a débordé. Reste à 1 jusqu’à l’effacement des bits mémorisés.</translation>
    </message>
    <message>
        <source>The servo is on.</source>
        <translation>Le servo est actif.</translation>
    </message>
    <message>
        <source>The first acceleration phase of the move has ended.</source>
        <translation>La première phase d’accélération du déplacement est terminée.</translation>
    </message>
    <message>
        <source>The constant phase of the move has ended.</source>
        <translation>La phase à vitesse constante du déplacement est terminée.</translation>
    </message>
    <message>
        <source>A servo tick took too long; typically not serious. Stays set until you clear the sticky bits.</source>
        <translation>Un cycle servo a duré trop longtemps&#x202f;; en général sans gravité. Reste à 1 jusqu’à l’effacement des bits mémorisés.</translation>
    </message>
    <message>
        <source>Clear stic&amp;ky bits</source>
        <translation>Effacer les bits &amp;mémorisés</translation>
    </message>
    <message>
        <source>Clear sticky bits of the status</source>
        <translation>Effacer les bits mémorisés de l’état</translation>
    </message>
    <message>
        <source>Auxiliary byte</source>
        <translation>Octet auxiliaire</translation>
    </message>
    <message>
        <source>A/D (motor current)</source>
        <translation>A/D (courant moteur)</translation>
    </message>
    <message>
        <source>Velocity reported by the chip</source>
        <translation>Vitesse signalée par la puce</translation>
    </message>
    <message>
        <source>, auxiliary %1</source>
        <translation>, auxiliaire %1</translation>
    </message>
    <message>
        <source>Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing.</source>
        <translation>Efface overcurrent, pos_error, pos_wrap et servo_overrun. Ne démarre rien.</translation>
    </message>
    <message>
        <source>Position error reported by the chip</source>
        <translation>Erreur de position signalée par la puce</translation>
    </message>
    <message>
        <source>Path points left</source>
        <translation>Points de trajectoire restants</translation>
    </message>
    <message>
        <source>The module is sending step pulses.</source>
        <translation>Des impulsions de pas arrivent.</translation>
    </message>
    <message>
        <source>The driver is enabled (AMP_EN is high).</source>
        <translation>Le driver est actif (AMP_EN est à l’état haut).</translation>
    </message>
    <message>
        <source>Motor power is present (PWR_SENSE is high).</source>
        <translation>L’alimentation moteur est présente (PWR_SENSE est à l’état haut).</translation>
    </message>
    <message>
        <source>The motor has reached its commanded speed.</source>
        <translation>Le moteur a atteint sa vitesse de consigne.</translation>
    </message>
    <message>
        <source>Runs with a ramp: velocity profile mode.</source>
        <translation>Marche avec rampe&#xa0;: mode profil de vitesse.</translation>
    </message>
    <message>
        <source>Moves to a position with a ramp: trapezoidal profile mode.</source>
        <translation>Déplacement vers une position avec rampe&#xa0;: mode profil trapézoïdal.</translation>
    </message>
    <message>
        <source>High stops the motor, unless it is ignored.</source>
        <translation>L’état haut arrête le moteur, sauf si l’entrée est ignorée.</translation>
    </message>
    <message>
        <source>General purpose input.</source>
        <translation>Entrée à usage général.</translation>
    </message>
    <message>
        <source>For homing.</source>
        <translation>Pour la prise d’origine.</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>à l’arrêt</translation>
    </message>
    <message>
        <source>trapezoidal profile</source>
        <translation>profil trapézoïdal</translation>
    </message>
    <message>
        <source>velocity profile</source>
        <translation>profil de vitesse</translation>
    </message>
    <message>
        <source>unprofiled, with stop</source>
        <translation>sans profil, avec arrêt</translation>
    </message>
    <message>
        <source>unprofiled, without stop</source>
        <translation>sans profil, sans arrêt</translation>
    </message>
    <message>
        <source>moving, commanded by another program</source>
        <translation>en mouvement, commandé par un autre programme</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>&amp;Zéro ici</translation>
    </message>
    <message>
        <source>Inputs byte</source>
        <translation>Octet des entrées</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Timer count</source>
        <translation>Valeur du timer</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>, inputs %1</source>
        <translation>, entrées %1</translation>
    </message>
    <message>
        <source>High blocks counting up, unless it is ignored.</source>
        <translation>L’état haut bloque le comptage vers le haut, sauf si l’entrée est ignorée.</translation>
    </message>
    <message>
        <source>High blocks counting down, unless it is ignored.</source>
        <translation>L’état haut bloque le comptage vers le bas, sauf si l’entrée est ignorée.</translation>
    </message>
</context>
<context>
    <name>nmc::DifferencesDialog</name>
    <message>
        <source>&amp;Select all</source>
        <translation>Tout &amp;sélectionner</translation>
    </message>
    <message>
        <source>Clear a&amp;ll</source>
        <translation>Tout désé&amp;lectionner</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Appliquer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>Dans le fichier</translation>
    </message>
    <message>
        <source>Here or last sent</source>
        <translation>Ici ou dernier envoi</translation>
    </message>
    <message>
        <source>When applied</source>
        <translation>À l’application</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Selects all check boxes, including settings sent to modules that are on.</source>
        <translation>Coche toutes les cases, y compris les réglages envoyés à des modules actifs.</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>Tout désélectionner</translation>
    </message>
    <message>
        <source>Clears all check boxes.</source>
        <translation>Décoche toutes les cases.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Keeps everything as it is.</source>
        <translation>Laisse tout en l’état.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; differs from the current settings. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced by those in the file.</source>
        <translation>«&#xa0;%1&#xa0;» diffère des réglages actuels. Rien n’est modifié ni envoyé tant que vous ne choisissez pas «&#xa0;Appliquer&#xa0;», et aucun moteur ne bouge. Les valeurs saisies mais non envoyées sont remplacées par celles du fichier.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 valeurs</translation>
    </message>
    <message>
        <source>Applies the selected settings and sends those marked as sent.</source>
        <translation>Applique les réglages sélectionnés et envoie ceux qui sont marqués comme envoyés.</translation>
    </message>
    <message>
        <source>Selected: %1 of %2. Sent to modules: %3.</source>
        <translation>Sélectionnés&#xa0;: %1 sur %2. Envoyés aux modules&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Differences from the present settings</source>
        <translation>Différences avec les réglages actuels</translation>
    </message>
    <message>
        <source>Settings of %1 for other axes. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced.</source>
        <translation>Réglages de %1 pour d’autres axes. Rien n’est modifié ni envoyé avant Appliquer, et aucun moteur ne bouge. Les valeurs saisies mais non envoyées sont remplacées.</translation>
    </message>
    <message>
        <source>Copy settings</source>
        <translation>Copier les réglages</translation>
    </message>
    <message>
        <source>%1: differences</source>
        <translation>%1&#xa0;: différences</translation>
    </message>
</context>
<context>
    <name>nmc::DirectBox</name>
    <message>
        <source>%1 as set here</source>
        <translation>%1 selon ces réglages</translation>
    </message>
    <message>
        <source>What the chip will do</source>
        <translation>Ce que fera la puce</translation>
    </message>
    <message>
        <source>Command bytes</source>
        <translation>Octets de la commande</translation>
    </message>
    <message>
        <source>A bit of %1: %2</source>
        <translation>Un bit de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Bits of %1: %2</source>
        <translation>Bits de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Data of %1: %2</source>
        <translation>Données de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: load</source>
        <translation>%1&#xa0;: charger</translation>
    </message>
    <message>
        <source>If cleared, the chip keeps the previously loaded value.</source>
        <translation>Si la case est décochée, la puce garde la valeur chargée auparavant.</translation>
    </message>
</context>
<context>
    <name>nmc::DirectionCheckBox</name>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Direction check…</source>
        <translation>Contrôle de sens…</translation>
    </message>
    <message>
        <source>Direction of motor and encoder</source>
        <translation>Sens du moteur et du codeur</translation>
    </message>
    <message>
        <source>Direction check of motor and encoder</source>
        <translation>Contrôle de sens du moteur et du codeur</translation>
    </message>
    <message>
        <source>Cancel the direction check</source>
        <translation>Annuler le contrôle de sens</translation>
    </message>
    <message>
        <source>Result of the direction check</source>
        <translation>Résultat du contrôle de sens</translation>
    </message>
    <message>
        <source>A direction check is running.</source>
        <translation>Un contrôle de sens est en cours.</translation>
    </message>
    <message>
        <source>Something turns the motor. Wait until it is at rest.</source>
        <translation>Quelque chose fait tourner le moteur. Attendez qu’il soit à l’arrêt.</translation>
    </message>
    <message>
        <source>The motor of %1 will move a little, forward and in reverse. It is driven in pulses of less than 0.1 s, with slowly rising power up to %2 % of its supply, until it has moved %3. A motor that runs freely may coast farther; more than %4 ends the check. Keep clear of it.</source>
        <translation>Le moteur de %1 va bouger un peu, en avant et en arrière. Il reçoit des impulsions de moins de 0,1&#xa0;s, d’une puissance lentement croissante jusqu’à %2&#x202f;% de son alimentation, jusqu’à ce qu’il se soit déplacé de %3. Un moteur qui tourne sans charge peut continuer plus loin sur sa lancée&#x202f;; au-delà de %4, le contrôle s’arrête. Tenez-vous à l’écart.</translation>
    </message>
    <message>
        <source>Direction check</source>
        <translation>Contrôle de sens</translation>
    </message>
    <message>
        <source>&amp;Pulse motor</source>
        <translation>Lancer les im&amp;pulsions</translation>
    </message>
    <message>
        <source>Driving it in reverse.</source>
        <translation>Impulsion en marche arrière.</translation>
    </message>
    <message>
        <source>Driving it forward.</source>
        <translation>Impulsion en marche avant.</translation>
    </message>
    <message>
        <source>Inconclusive: see the message.</source>
        <translation>Non concluant&#xa0;: voir le message.</translation>
    </message>
    <message>
        <source>Not checked in this connection. Run the check before you enable the servo for the first time: with motor or encoder reversed, it runs away.</source>
        <translation>Non contrôlé pendant cette connexion. Faites le contrôle avant la première activation du servo&#xa0;: si le moteur ou le codeur est inversé, il s’emballe.</translation>
    </message>
    <message>
        <source>Moves the motor a little, without the servo, to check that it turns the way its encoder counts. Asks first.</source>
        <translation>Fait bouger un peu le moteur, sans le servo, pour vérifier qu’il tourne dans le sens où compte son codeur. Demande d’abord confirmation.</translation>
    </message>
    <message>
        <source>No direction check is running.</source>
        <translation>Aucun contrôle de sens n’est en cours.</translation>
    </message>
    <message>
        <source>Ends the check and switches the motor off.</source>
        <translation>Met fin au contrôle et coupe le moteur.</translation>
    </message>
</context>
<context>
    <name>nmc::DoctorPage</name>
    <message>
        <source>Chain doctor</source>
        <translation>Diagnostic de la chaîne</translation>
    </message>
    <message>
        <source>Modules expected and found, the farthest from the PC first</source>
        <translation>Modules attendus et trouvés, le plus éloigné du PC en premier</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Attendu</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Scan again: look for modules</source>
        <translation>Relancer la recherche de modules</translation>
    </message>
    <message>
        <source>Accep&amp;t as found</source>
        <translation>Accep&amp;ter telle quelle</translation>
    </message>
    <message>
        <source>Accept as found</source>
        <translation>Accepter telle quelle</translation>
    </message>
    <message>
        <source>&amp;Restart the network…</source>
        <translation>Redémarrer le &amp;réseau…</translation>
    </message>
    <message>
        <source>Restart the network: positions and gains are lost</source>
        <translation>Redémarrer le réseau&#xa0;: positions et gains seront perdus</translation>
    </message>
    <message>
        <source>Scans the chain again with status requests only: nothing is reset, nothing moves.</source>
        <translation>Relance la recherche dans la chaîne avec des demandes d’état uniquement&#xa0;: rien n’est réinitialisé, rien ne bouge.</translation>
    </message>
    <message>
        <source>The chain already matches.</source>
        <translation>La chaîne correspond déjà.</translation>
    </message>
    <message>
        <source>From now on, the panel expects the modules found here.</source>
        <translation>Désormais, le programme attend les modules trouvés ici.</translation>
    </message>
</context>
<context>
    <name>nmc::ExpertBox</name>
    <message>
        <source>Capture only</source>
        <translation>Capture seule</translation>
    </message>
    <message>
        <source>Stop abruptly</source>
        <translation>Arrêt brutal</translation>
    </message>
    <message>
        <source>Stop smoothly</source>
        <translation>Arrêt progressif</translation>
    </message>
    <message>
        <source>The chip stops watching for home.</source>
        <translation>La puce cesse de guetter l’origine.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register and stops. Start the motion with a command of your own.</source>
        <translation>Au premier de ces événements, la puce mémorise sa position dans le registre d’origine et s’arrête. Démarrez le mouvement par une commande de votre choix.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register. The motion goes on.</source>
        <translation>Au premier de ces événements, la puce mémorise sa position dans le registre d’origine. Le mouvement continue.</translation>
    </message>
    <message>
        <source>Load Trajectory</source>
        <translation>Load Trajectory</translation>
    </message>
    <message>
        <source>Send load</source>
        <translation>Envoyer le chargement</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Trapezoidal</source>
        <translation>Trapézoïdal</translation>
    </message>
    <message>
        <source>Position (counts)</source>
        <translation>Position (incréments)</translation>
    </message>
    <message>
        <source>Velocity (counts/tick × 65536)</source>
        <translation>Vitesse (incr./cycle × 65536)</translation>
    </message>
    <message>
        <source>Acceleration (counts/tick² × 65536)</source>
        <translation>Accélération (incr./cycle² × 65536)</translation>
    </message>
    <message>
        <source>Reverse (velocity and PWM)</source>
        <translation>Arrière (vitesse et PWM)</translation>
    </message>
    <message>
        <source>Start motion now</source>
        <translation>Démarrer tout de suite</translation>
    </message>
    <message>
        <source>Stop Motor</source>
        <translation>Stop Motor</translation>
    </message>
    <message>
        <source>Send stop</source>
        <translation>Envoyer l’arrêt</translation>
    </message>
    <message>
        <source>Amplifier only</source>
        <translation>Amplificateur seul</translation>
    </message>
    <message>
        <source>At a position</source>
        <translation>À une position</translation>
    </message>
    <message>
        <source>Amplifier enabled</source>
        <translation>Amplificateur actif</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. The servo stays as it is.</source>
        <translation>Commute seulement AMP_EN. Le servo reste tel quel.</translation>
    </message>
    <message>
        <source>The servo is switched off. The motor is free to turn.</source>
        <translation>Le servo est coupé. Le moteur peut tourner librement.</translation>
    </message>
    <message>
        <source>The motor stops at once and holds.</source>
        <translation>Le moteur s’arrête immédiatement et maintient sa position.</translation>
    </message>
    <message>
        <source>The servo is switched ON and holds its position.</source>
        <translation>Le servo est mis EN MARCHE et maintient sa position.</translation>
    </message>
    <message>
        <source>The motor slows down with the loaded acceleration and holds.</source>
        <translation>Le moteur ralentit avec l’accélération chargée et maintient sa position.</translation>
    </message>
    <message>
        <source>The motor goes to this position without a profile, as fast as the gains drive it, and holds there.</source>
        <translation>Le moteur va à cette position sans profil, aussi vite que les gains l’entraînent, et s’y maintient.</translation>
    </message>
    <message>
        <source>Set Homing Mode</source>
        <translation>Set Homing Mode</translation>
    </message>
    <message>
        <source>Send homing mode</source>
        <translation>Envoyer le mode d’origine</translation>
    </message>
    <message>
        <source>Change of limit 1</source>
        <translation>Changement du fin de course 1</translation>
    </message>
    <message>
        <source>Change of limit 2</source>
        <translation>Changement du fin de course 2</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Puis</translation>
    </message>
    <message>
        <source>Table 4 of the data sheet has no such mode for the present state of the motor.</source>
        <translation>Le tableau 4 ne prévoit pas ce mode depuis l’état actuel du moteur.</translation>
    </message>
    <message>
        <source>Position (steps)</source>
        <translation>Position (pas)</translation>
    </message>
    <message>
        <source>Acceleration time (0.25 ms)</source>
        <translation>Temps d’accélération (0,25&#xa0;ms)</translation>
    </message>
    <message>
        <source>Initial timer count</source>
        <translation>Valeur initiale du timer</translation>
    </message>
    <message>
        <source>Nearest integer speed</source>
        <translation>Vitesse entière la plus proche</translation>
    </message>
    <message>
        <source>Reverse (not trapezoidal)</source>
        <translation>Arrière (sauf trapézoïdal)</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. A motion in progress keeps counting.</source>
        <translation>Commute seulement AMP_EN. Un mouvement en cours continue de compter.</translation>
    </message>
    <message>
        <source>The steps end at once.</source>
        <translation>Les pas cessent immédiatement.</translation>
    </message>
    <message>
        <source>The motor slows down with its acceleration time.</source>
        <translation>Le moteur ralentit avec son temps d’accélération.</translation>
    </message>
    <message>
        <source>Change of the home switch</source>
        <translation>Changement du capteur d’origine</translation>
    </message>
    <message>
        <source>Commands as in the data sheet</source>
        <translation>Commandes de la fiche technique</translation>
    </message>
    <message>
        <source>Commands as in the data sheet, in native counts. STOP ALL and Esc work as usual.</source>
        <translation>Commandes de la fiche technique, en incréments natifs. TOUT ARRÊTER et Esc agissent comme d’habitude.</translation>
    </message>
    <message>
        <source>%1 Waits for Start Motion; the next load overwrites it.</source>
        <translation>%1 Attend Start Motion&#x202f;; le prochain chargement l’écrase.</translation>
    </message>
    <message>
        <source>The servo is off; the PWM value drives the motor. No limit applies.</source>
        <translation>Le servo est coupé&#x202f;; la valeur PWM entraîne le moteur. Aucune limite ne s’applique.</translation>
    </message>
    <message>
        <source>The motor runs until it is stopped.</source>
        <translation>Le moteur tourne jusqu’à l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position. Start it only from standstill.</source>
        <translation>Déplacement trapézoïdal vers la position. Ne le démarrez qu’à l’arrêt.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position.</source>
        <translation>Déplacement trapézoïdal vers la position.</translation>
    </message>
    <message>
        <source>A ramp to the speed. The motor runs until it is stopped.</source>
        <translation>Rampe vers la vitesse. Le moteur tourne jusqu’à l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>One speed from the first step to the position.</source>
        <translation>Une seule vitesse, du premier pas à la position.</translation>
    </message>
    <message>
        <source>One speed from the first step. The motor runs until it is stopped.</source>
        <translation>Une seule vitesse dès le premier pas. Le moteur tourne jusqu’à l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>The move continues to its position at this speed. If it has just ended, the motor runs until it is stopped.</source>
        <translation>Le déplacement continue jusqu’à sa position à cette vitesse. S’il vient de se terminer, le moteur tourne jusqu’à l’ordre d’arrêt.</translation>
    </message>
    <message>
        <source>Reset module…</source>
        <translation>Réinitialiser le module…</translation>
    </message>
    <message>
        <source>Reset module to its power-up state</source>
        <translation>Réinitialiser le module à l’état de mise sous tension</translation>
    </message>
    <message>
        <source>Returns this module to its power-up state and assigns its address again. The other modules are unchanged.</source>
        <translation>Remet ce module dans son état de mise sous tension et lui attribue de nouveau son adresse. Les autres modules sont inchangés.</translation>
    </message>
    <message>
        <source>Reset module</source>
        <translation>Réinitialiser le module</translation>
    </message>
    <message>
        <source>Reset %1? Its motor switches off, and it loses its position, settings and group. The other modules are unchanged.</source>
        <translation>Réinitialiser %1&#x202f;? Son moteur se coupe, et il perd sa position, ses réglages et son groupe. Les autres modules sont inchangés.</translation>
    </message>
    <message>
        <source>Reset the module</source>
        <translation>Réinitialiser le module</translation>
    </message>
    <message>
        <source>Relative (trapezoidal)</source>
        <translation>Relatif (trapézoïdal)</translation>
    </message>
    <message>
        <source>A trapezoidal move by this many counts, from the command position. Start it only from standstill.</source>
        <translation>Déplacement trapézoïdal de ce nombre d’incréments, depuis la position de consigne du servo. Ne le démarrez qu’à l’arrêt.</translation>
    </message>
    <message>
        <source>Advanced features on</source>
        <translation>Fonctions avancées actives</translation>
    </message>
    <message>
        <source>Reset Position</source>
        <translation>Reset Position</translation>
    </message>
    <message>
        <source>Send reset position</source>
        <translation>Envoyer Reset Position</translation>
    </message>
    <message>
        <source>To 0</source>
        <translation>À 0</translation>
    </message>
    <message>
        <source>Relative to home</source>
        <translation>Par rapport à l’origine</translation>
    </message>
    <message>
        <source>To a value</source>
        <translation>À une valeur</translation>
    </message>
    <message>
        <source>The home register is subtracted from the position. Nothing moves.</source>
        <translation>Le registre d’origine est soustrait de la position. Rien ne bouge.</translation>
    </message>
    <message>
        <source>The position becomes this value. Nothing moves.</source>
        <translation>La position prend cette valeur. Rien ne bouge.</translation>
    </message>
</context>
<context>
    <name>nmc::FirstSteps</name>
    <message>
        <source>Show me</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Show me: the next step</source>
        <translation>Montrer&#xa0;: l’étape suivante</translation>
    </message>
    <message>
        <source>Shows the control for the next step. Sends nothing.</source>
        <translation>Montre la commande de l’étape suivante. N’envoie rien.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Fill in gains</source>
        <translation>Remplir les gains</translation>
    </message>
    <message>
        <source>Apply gains</source>
        <translation>Appliquer les gains</translation>
    </message>
    <message>
        <source>Enable servo</source>
        <translation>Activer le servo</translation>
    </message>
    <message>
        <source>Take the starting values, or type your own. Nothing is sent yet.</source>
        <translation>Reprenez les valeurs de départ, ou saisissez les vôtres. Rien n’est encore envoyé.</translation>
    </message>
    <message>
        <source>Sends the gains to the module. The motor does not move.</source>
        <translation>Envoie les gains au module. Le moteur ne bouge pas.</translation>
    </message>
    <message>
        <source>New wiring? Run the direction check on the Axis page first.</source>
        <translation>Nouveau câblage&#x202f;? Faites d’abord le contrôle de sens sur la page Axe.</translation>
    </message>
    <message>
        <source>The motor moves while you hold the button. Esc stops it from anywhere.</source>
        <translation>Le moteur bouge tant que vous maintenez le bouton. Esc l’arrête depuis n’importe où.</translation>
    </message>
</context>
<context>
    <name>nmc::FrequencyPage</name>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>The motor swings around its position, slowly at first, then faster. Make sure that everything it drives can move freely.</source>
        <translation>Le moteur oscille autour de sa position, d’abord lentement, puis plus vite. Assurez-vous que tout ce qu’il entraîne peut bouger librement.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>The amplitude</source>
        <translation>L’amplitude</translation>
    </message>
    <message>
        <source>How far the command swings to either side. The motor is stopped if it swings four times as far.</source>
        <translation>Excursion de la consigne de part et d’autre. Le moteur est arrêté s’il oscille quatre fois plus loin.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>The lowest frequency</source>
        <translation>La fréquence la plus basse</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>The highest frequency</source>
        <translation>La fréquence la plus haute</translation>
    </message>
    <message>
        <source>The test ends earlier if the baud rate is too low: at about 40 Hz at 115 200 Bd, and at about 8 Hz at 19 200 Bd.</source>
        <translation>L’essai se termine plus tôt si le débit est trop faible&#xa0;: vers 40&#xa0;Hz à 115200&#xa0;Bd, et vers 8&#xa0;Hz à 19200&#xa0;Bd.</translation>
    </message>
    <message>
        <source>Results of the frequency response</source>
        <translation>Résultats de la réponse en fréquence</translation>
    </message>
    <message>
        <source>Export CSV of the frequency response</source>
        <translation>Exporter en CSV la réponse en fréquence</translation>
    </message>
    <message>
        <source>The baud rate is too low for higher frequencies.</source>
        <translation>Le débit est trop faible pour des fréquences plus élevées.</translation>
    </message>
    <message>
        <source>No measurement yet.</source>
        <translation>Pas encore de mesure.</translation>
    </message>
    <message>
        <source>Saves frequency, magnitude and phase of the open and the closed loop.</source>
        <translation>Enregistre fréquence, amplitude et phase de la boucle ouverte et de la boucle fermée.</translation>
    </message>
    <message>
        <source>Export the frequency response</source>
        <translation>Exporter la réponse en fréquence</translation>
    </message>
    <message>
        <source>Speed while measuring</source>
        <translation>Vitesse pendant la mesure</translation>
    </message>
    <message>
        <source>The speed while measuring</source>
        <translation>La vitesse pendant la mesure</translation>
    </message>
    <message>
        <source>0: at rest. Otherwise the sines ride on a motion to and fro, forward first, or backwards first if it is negative; the motor never reverses within a sine, so dry friction does not show. It moves away by up to this speed times five periods of the lowest frequency.</source>
        <translation>0&#xa0;: à l’arrêt. Sinon, les sinusoïdes se superposent à un mouvement de va-et-vient, d’abord en avant, ou d’abord en arrière si la valeur est négative&#xa0;; le moteur ne change jamais de sens pendant une sinusoïde, si bien que le frottement sec n’apparaît pas. Il s’éloigne au plus de cette vitesse multipliée par cinq périodes de la fréquence la plus basse.</translation>
    </message>
    <message>
        <source>What the gains in the fields would do</source>
        <translation>Ce que feraient les gains des champs</translation>
    </message>
    <message>
        <source>in motion</source>
        <translation>en mouvement</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>à l’arrêt</translation>
    </message>
    <message>
        <source>Fill in all gains to see what this loop would do with them.</source>
        <translation>Remplissez tous les gains pour voir ce que cette boucle ferait avec eux.</translation>
    </message>
    <message>
        <source>with the gains in the fields</source>
        <translation>avec les gains des champs</translation>
    </message>
    <message>
        <source>The last measurement ended early. The one before it is still shown.</source>
        <translation>La dernière mesure s’est terminée avant la fin. La précédente reste affichée.</translation>
    </message>
</context>
<context>
    <name>nmc::GainsBox</name>
    <message>
        <source>&amp;Apply gains</source>
        <translation>Tout appli&amp;quer</translation>
    </message>
    <message>
        <source>Apply gains: all</source>
        <translation>Tout appliquer&#xa0;: tous les gains</translation>
    </message>
    <message>
        <source>Revert the gains to those last sent</source>
        <translation>Abandonner&#xa0;: revenir aux derniers gains envoyés</translation>
    </message>
    <message>
        <source>Fills in values to start tuning with. Sends nothing.</source>
        <translation>Remplit les champs avec des valeurs pour commencer le réglage. N’envoie rien.</translation>
    </message>
    <message>
        <source>Gains cannot be read back from the module. They are unknown until you apply them.</source>
        <translation>Les gains ne peuvent pas être relus dans le module. Ils sont inconnus tant que vous ne les appliquez pas.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The servo is on: they take effect immediately.</source>
        <translation>Envoie tous les gains à la fois. Le servo est actif&#xa0;: ils prennent effet immédiatement.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The motor does not move.</source>
        <translation>Envoie tous les gains à la fois. Le moteur ne bouge pas.</translation>
    </message>
    <message>
        <source>&amp;Apply live</source>
        <translation>Tout appli&amp;quer à chaud</translation>
    </message>
    <message>
        <source>Restores the gains last sent. Sends nothing.</source>
        <translation>Rétablit les derniers gains envoyés. N’envoie rien.</translation>
    </message>
    <message>
        <source>Clears the fields: no gains have been sent yet. Sends nothing.</source>
        <translation>Vide les champs&#xa0;: aucun gain n’a encore été envoyé. N’envoie rien.</translation>
    </message>
    <message>
        <source>Sense of the current limit</source>
        <translation>Sens de la limite de courant</translation>
    </message>
    <message>
        <source>Whether a high or a low A/D value means overcurrent. The chip distinguishes them by odd and even values.</source>
        <translation>Indique si une valeur A/D élevée ou faible signifie surintensité. La puce les distingue par les nombres impairs et pairs.</translation>
    </message>
    <message>
        <source>Undo the last edit of a gain</source>
        <translation>Annuler la dernière modification d’un gain</translation>
    </message>
    <message>
        <source>Redo the last undone edit of a gain</source>
        <translation>Rétablir la modification d’un gain</translation>
    </message>
    <message>
        <source>All zero</source>
        <translation>Tout à zéro</translation>
    </message>
    <message>
        <source>All zero: fill in 0 for all gains</source>
        <translation>Tout à zéro&#xa0;: mettre 0 dans tous les gains</translation>
    </message>
    <message>
        <source>Changing SR from %2 to %1 changes the servo tick, and with it the meaning of every velocity and acceleration in counts per tick.</source>
        <translation>Passer SR de %2 à %1 change le cycle servo, et avec lui la signification de toutes les vitesses et accélérations en incréments par cycle.</translation>
    </message>
    <message>
        <source>Gains while the servo is on</source>
        <translation>Gains avec servo actif</translation>
    </message>
    <message>
        <source>The servo is on, and the gains in the module are unknown, so this may be a large change. The motor may jump or oscillate.</source>
        <translation>Le servo est actif, et les gains du module sont inconnus&#xa0;: la modification peut être importante. Le moteur peut faire un à-coup ou osciller.</translation>
    </message>
    <message>
        <source>The servo is on, and this is a large change: %1. The motor may jump or oscillate.</source>
        <translation>Le servo est actif, et la modification est importante&#xa0;: %1. Le moteur peut faire un à-coup ou osciller.</translation>
    </message>
    <message>
        <source>&amp;Apply these gains</source>
        <translation>&amp;Appliquer ces gains</translation>
    </message>
    <message>
        <source>Step response…</source>
        <translation>Réponse indicielle…</translation>
    </message>
    <message>
        <source>Step response: open</source>
        <translation>Réponse indicielle&#xa0;: ouvrir</translation>
    </message>
    <message>
        <source>Opens the step response, which shows how the motor follows a small step (F9).</source>
        <translation>Ouvre la réponse indicielle, qui montre comment le moteur suit un petit échelon (F9).</translation>
    </message>
    <message>
        <source>Fills the fields with 0, to start tuning. Sends nothing. Once applied, the motor no longer holds.</source>
        <translation>Remplit les champs de 0, pour commencer le réglage. N’envoie rien. Une fois ces valeurs appliquées, le moteur ne tient plus sa position.</translation>
    </message>
    <message>
        <source>Try for %1 s</source>
        <translation>Essayer %1&#xa0;s</translation>
    </message>
    <message>
        <source>Try for %1 s: these gains</source>
        <translation>Essayer %1&#xa0;s&#xa0;: ces gains</translation>
    </message>
    <message>
        <source>Keep gains</source>
        <translation>Garder les gains</translation>
    </message>
    <message>
        <source>Keep gains: those being tried</source>
        <translation>Garder les gains à l’essai</translation>
    </message>
    <message>
        <source>These gains are already being tried.</source>
        <translation>Ces gains sont déjà à l’essai.</translation>
    </message>
    <message>
        <source>The module already has these gains.</source>
        <translation>Le module a déjà ces gains.</translation>
    </message>
    <message>
        <source>Sends these gains and restores the previous ones after %1 s unless you keep them, or at once if the motor starts to oscillate.</source>
        <translation>Envoie ces gains et rétablit les précédents au bout de %1&#xa0;s si vous ne les gardez pas, ou aussitôt si le moteur se met à osciller.</translation>
    </message>
    <message>
        <source>No gains are being tried.</source>
        <translation>Aucun gain n’est à l’essai.</translation>
    </message>
    <message>
        <source>Keeps the gains that are being tried.</source>
        <translation>Garde les gains à l’essai.</translation>
    </message>
    <message>
        <source>Apply live: all gains</source>
        <translation>Tout appliquer à chaud&#xa0;: tous les gains</translation>
    </message>
    <message>
        <source>no current limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>limits above (odd)</source>
        <translation>limite au-dessus (impaire)</translation>
    </message>
    <message>
        <source>limits below (even)</source>
        <translation>limite au-dessous (paire)</translation>
    </message>
    <message>
        <source>Range: %1 to %2.</source>
        <translation>Plage&#xa0;: %1 à %2.</translation>
    </message>
</context>
<context>
    <name>nmc::GenericPanel</name>
    <message>
        <source>Module without controls</source>
        <translation>Module sans commandes</translation>
    </message>
    <message>
        <source>No status yet.</source>
        <translation>Pas encore d’état.</translation>
    </message>
    <message>
        <source>Status byte %1</source>
        <translation>Octet d’état %1</translation>
    </message>
    <message>
        <source>, position %1</source>
        <translation>, position %1</translation>
    </message>
    <message>
        <source>It does not answer. </source>
        <translation>Il ne répond pas. </translation>
    </message>
    <message>
        <source>Request status</source>
        <translation>Demander l’état</translation>
    </message>
    <message>
        <source>Sends No Operation, which only requests the status.</source>
        <translation>Envoie No Operation, qui ne fait que demander l’état.</translation>
    </message>
    <message>
        <source>The panel does not support this type and version (supported: PIC-SERVO v1 to v5 and v10, PIC-STEP v1, PIC-I/O v1), so it only shows the module&apos;s status. STOP ALL might not stop its motor: use the hardware stop.</source>
        <translation>Le programme ne prend pas en charge ce type et cette version (pris en charge&#xa0;: PIC-SERVO v1 à v5 et v10, PIC-STEP v1, PIC-I/O v1)&#x202f;; il n’affiche donc que l’état du module. TOUT ARRÊTER n’arrête peut-être pas son moteur&#xa0;: utilisez l’arrêt matériel.</translation>
    </message>
</context>
<context>
    <name>nmc::GroupsPage</name>
    <message>
        <source>No modules yet: connect first.</source>
        <translation>Pas encore de modules&#xa0;: connectez-vous d’abord.</translation>
    </message>
    <message>
        <source>Group to command</source>
        <translation>Groupe à commander</translation>
    </message>
    <message>
        <source>St&amp;art loaded moves</source>
        <translation>Lancer les déplacements ch&amp;argés</translation>
    </message>
    <message>
        <source>Start loaded moves of this group</source>
        <translation>Lancer les déplacements chargés de ce groupe</translation>
    </message>
    <message>
        <source>Save &amp;home</source>
        <translation>Enregistrer l’&amp;origine</translation>
    </message>
    <message>
        <source>Save home: the present positions of this group</source>
        <translation>Enregistrer l’origine&#xa0;: les positions actuelles de ce groupe</translation>
    </message>
    <message>
        <source>Group of module %1</source>
        <translation>Groupe du module %1</translation>
    </message>
    <message>
        <source>The group that this module listens to. Sent at once; nothing moves.</source>
        <translation>Groupe que ce module écoute. Envoyé aussitôt&#x202f;; rien ne bouge.</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>meneur</translation>
    </message>
    <message>
        <source>Leader of its group: module %1</source>
        <translation>Meneur de son groupe&#xa0;: module %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Choose a group first.</source>
        <translation>Choisissez d’abord un groupe.</translation>
    </message>
    <message>
        <source>This module answers for its group. A group has at most one leader.</source>
        <translation>Ce module répond pour son groupe. Un groupe a au plus un meneur.</translation>
    </message>
    <message>
        <source>move loaded</source>
        <translation>déplacement chargé</translation>
    </message>
    <message>
        <source>No groups yet. Add modules to a group first.</source>
        <translation>Pas encore de groupes. Ajoutez d’abord des modules à un groupe.</translation>
    </message>
    <message>
        <source>Starts the loaded moves of all members in the same tick. Available once every member has confirmed its load.</source>
        <translation>Lance les déplacements chargés de tous les membres dans le même cycle. Disponible dès que chaque membre a confirmé son chargement.</translation>
    </message>
    <message>
        <source>Saves the present position of each member as home, in the same tick. Nothing moves.</source>
        <translation>Enregistre la position actuelle de chaque membre comme origine, dans le même cycle. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Nom du groupe</translation>
    </message>
    <message>
        <source>The name of this group. Saved with the machine; nothing is sent.</source>
        <translation>Nom de ce groupe. Enregistré avec la machine&#x202f;; rien n’est envoyé.</translation>
    </message>
    <message>
        <source>A module listens to one group besides its own address. All members carry out a group command in the same tick; the leader, if any, answers for them, and the panel then checks each member. Status requests go to single modules.</source>
        <translation>Un module écoute un groupe en plus de sa propre adresse. Tous les membres exécutent une commande de groupe dans le même cycle&#x202f;; le meneur, s’il y en a un, répond pour eux, et le programme vérifie ensuite chaque membre. Les demandes d’état vont à un seul module à la fois.</translation>
    </message>
    <message>
        <source>The group that the buttons act on.</source>
        <translation>Groupe que commandent les boutons.</translation>
    </message>
    <message>
        <source>Stop s&amp;moothly</source>
        <translation>Arrêt &amp;progressif</translation>
    </message>
    <message>
        <source>Stop smoothly: this group</source>
        <translation>Arrêt progressif de ce groupe</translation>
    </message>
    <message>
        <source>Stop at &amp;once</source>
        <translation>Arrêt &amp;brutal</translation>
    </message>
    <message>
        <source>Stop at once: this group</source>
        <translation>Arrêt brutal de ce groupe</translation>
    </message>
    <message>
        <source>Motors o&amp;ff</source>
        <translation>&amp;Couper les moteurs</translation>
    </message>
    <message>
        <source>Motors off in this group</source>
        <translation>Couper les moteurs de ce groupe</translation>
    </message>
    <message>
        <source>C&amp;lear sticky bits</source>
        <translation>Effacer les bits &amp;mémorisés</translation>
    </message>
    <message>
        <source>Clear sticky bits of this group</source>
        <translation>Effacer les bits mémorisés de ce groupe</translation>
    </message>
    <message>
        <source>Set &amp;position to 0…</source>
        <translation>&amp;Mettre la position à 0…</translation>
    </message>
    <message>
        <source>Set position to 0 for this group</source>
        <translation>Mettre la position à 0 pour ce groupe</translation>
    </message>
    <message>
        <source>Address of module %1</source>
        <translation>Adresse du module %1</translation>
    </message>
    <message>
        <source>The address of this module, 1 to 127. Press Enter to send it. Position, gains and group are kept.</source>
        <translation>Adresse de ce module, 1 à 127. Appuyez sur Entrée pour l’envoyer. Position, gains et groupe sont conservés.</translation>
    </message>
    <message>
        <source>Makes the present position of each member 0. Asks first.</source>
        <translation>Met à 0 la position actuelle de chaque membre. Demande d’abord confirmation.</translation>
    </message>
    <message>
        <source>Clears the sticky fault bits of each member. PIC-SERVO only.</source>
        <translation>Efface les bits de défaut mémorisés de chaque membre. PIC-SERVO uniquement.</translation>
    </message>
    <message>
        <source>Every member that is on slows down and holds. Repeated until all are seen at rest.</source>
        <translation>Chaque membre actif ralentit et maintient sa position. Répété jusqu’à ce que tous soient vus à l’arrêt.</translation>
    </message>
    <message>
        <source>Every member that is on stops at once and holds. Repeated until all are seen at rest.</source>
        <translation>Chaque membre actif s’arrête immédiatement et maintient sa position. Répété jusqu’à ce que tous soient vus à l’arrêt.</translation>
    </message>
    <message>
        <source>Switches every member off: motors coast, and loads may fall. Repeated until all are seen at rest.</source>
        <translation>Coupe chaque membre&#xa0;: les moteurs continuent sur leur lancée, et des charges peuvent tomber. Répété jusqu’à ce que tous soient vus à l’arrêt.</translation>
    </message>
    <message>
        <source>The present position of each motor of %1 becomes 0: module %2. Home, limits and taught points then refer to different positions.</source>
        <translation>La position actuelle de chaque moteur de %1 devient 0&#xa0;: module %2. L’origine, les limites et les points appris désignent alors d’autres emplacements.</translation>
    </message>
    <message>
        <source>Set positions to 0</source>
        <translation>Mettre les positions à 0</translation>
    </message>
    <message>
        <source>&amp;Set positions to 0</source>
        <translation>&amp;Mettre les positions à 0</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Choose a group first, or none.</source>
        <translation>Son groupe est inconnu et changerait avec l’adresse. Choisissez d’abord un groupe, ou aucun.</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change addresses.</source>
        <translation>Un moteur est en mouvement. Arrêtez tous les moteurs pour changer les adresses.</translation>
    </message>
    <message>
        <source>Address %1 is used by %2. Nothing was sent.</source>
        <translation>L’adresse %1 est utilisée par %2. Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>outputs stored</source>
        <translation>sorties stockées</translation>
    </message>
    <message>
        <source>Store its outputs first.</source>
        <translation>Stockez d’abord ses sorties.</translation>
    </message>
    <message>
        <source>The address</source>
        <translation>L’adresse</translation>
    </message>
    <message>
        <source>address</source>
        <translation>adresse</translation>
    </message>
</context>
<context>
    <name>nmc::HoldFirstButton</name>
    <message>
        <source>Hold here first</source>
        <translation>Maintenir d’abord ici</translation>
    </message>
    <message>
        <source>Holds the motor at its present position (Stop here).</source>
        <translation>Maintient le moteur à sa position actuelle («&#xa0;Arrêt ici&#xa0;»).</translation>
    </message>
</context>
<context>
    <name>nmc::HomingBox</name>
    <message>
        <source>Home</source>
        <translation>Prendre l’origine</translation>
    </message>
    <message>
        <source>Cancel search</source>
        <translation>Annuler la recherche</translation>
    </message>
    <message>
        <source>Home: search for it</source>
        <translation>Prendre l’origine&#xa0;: lancer la recherche</translation>
    </message>
    <message>
        <source>Cancel search for home</source>
        <translation>Annuler la recherche d’origine</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Progression de la recherche</translation>
    </message>
    <message>
        <source>Moves the motor to search for home, as set above.</source>
        <translation>Déplace le moteur à la recherche de l’origine, selon les réglages ci-dessus.</translation>
    </message>
    <message>
        <source>No search for home is running.</source>
        <translation>Aucune recherche d’origine n’est en cours.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly, without homing it.</source>
        <translation>Arrête progressivement le moteur, sans prise d’origine.</translation>
    </message>
    <message>
        <source>Done: home was at %1.</source>
        <translation>Terminé&#xa0;: l’origine était à %1.</translation>
    </message>
    <message>
        <source>No search yet.</source>
        <translation>Pas encore de recherche.</translation>
    </message>
</context>
<context>
    <name>nmc::HomingForm</name>
    <message>
        <source>Search for home</source>
        <translation>Recherche d’origine</translation>
    </message>
    <message>
        <source>Home is where this switch changes. If it is active at the start, the motor first backs off in the other direction.</source>
        <translation>L’origine est là où ce capteur change d’état. S’il est actif au départ, le moteur se dégage d’abord dans l’autre sens.</translation>
    </message>
    <message>
        <source>Limit 1 (forward)</source>
        <translation>Fin de course 1 (avant)</translation>
    </message>
    <message>
        <source>Limit 2 (reverse)</source>
        <translation>Fin de course 2 (arrière)</translation>
    </message>
    <message>
        <source>Home is at</source>
        <translation>Origine sur</translation>
    </message>
    <message>
        <source>Home is at the encoder&apos;s index, which comes once per turn.</source>
        <translation>L’origine est à l’index du codeur, qui vient une fois par tour.</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the position error limit switches the servo off. Sticky bits are cleared first. The servo is switched on again only to continue to the index or to home.</source>
        <translation>L’origine est sur une butée mécanique&#xa0;: le moteur va contre elle jusqu’à ce que la limite d’erreur de position coupe le servo. Les bits mémorisés sont d’abord effacés. Le servo n’est réactivé que pour continuer jusqu’à l’index ou l’origine.</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the current limit is reached. On its own, it takes effect only at full speed; combined with other conditions, from the start, so the starting current must stay below it. Sticky bits are cleared first.</source>
        <translation>L’origine est sur une butée mécanique&#xa0;: le moteur va contre elle jusqu’à la limite de courant. Seule, elle n’agit qu’à pleine vitesse&#x202f;; avec d’autres conditions, dès le départ, si bien que le courant de démarrage doit lui rester inférieur. Les bits mémorisés sont d’abord effacés.</translation>
    </message>
    <message>
        <source>then at the index, going back</source>
        <translation>puis à l’index, au retour</translation>
    </message>
    <message>
        <source>The conditions above find the approximate place; a second, slower search finds the index, which is more exact.</source>
        <translation>Les conditions ci-dessus trouvent l’emplacement approximatif&#x202f;; une seconde recherche, plus lente, trouve l’index, plus précis.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Reverse: search direction</source>
        <translation>Arrière&#xa0;: sens de recherche</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Forward: search direction</source>
        <translation>Avant&#xa0;: sens de recherche</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Maximum velocity for searching, backing off and going to home.</source>
        <translation>Vitesse maximale pour la recherche, le dégagement et le retour à l’origine.</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Vitesse d’index</translation>
    </message>
    <message>
        <source>Velocity of the second search, for the index. Slower is more exact.</source>
        <translation>Vitesse de la seconde recherche, celle de l’index. Plus lente, elle est plus précise.</translation>
    </message>
    <message>
        <source>Also used for smooth stops.</source>
        <translation>Sert aussi aux arrêts progressifs.</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>Course de recherche</translation>
    </message>
    <message>
        <source>A search, or backing off, stops and fails after this distance.</source>
        <translation>Une recherche ou un dégagement s’arrête et échoue au-delà de cette distance.</translation>
    </message>
    <message>
        <source>Time limit of a search</source>
        <translation>Durée limite d’une recherche</translation>
    </message>
    <message>
        <source>A search stops and fails after this time.</source>
        <translation>Une recherche s’arrête et échoue au bout de ce temps.</translation>
    </message>
    <message>
        <source>%1 of the search for home</source>
        <translation>%1 pour la recherche d’origine</translation>
    </message>
    <message>
        <source>Abruptly: stop at home</source>
        <translation>Brutal&#xa0;: arrêt à l’origine</translation>
    </message>
    <message>
        <source>Smoothly: stop at home</source>
        <translation>Progressif&#xa0;: arrêt à l’origine</translation>
    </message>
    <message>
        <source>Motor off at home</source>
        <translation>Couper le moteur à l’origine</translation>
    </message>
    <message>
        <source>Stop there</source>
        <translation>Mode d’arrêt</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Puis</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Aller à l’origine</translation>
    </message>
    <message>
        <source>The motor stops past home; this moves it back. If the search has switched the servo or amplifier off, it is switched on again.</source>
        <translation>Le moteur s’arrête après l’origine&#x202f;; ceci l’y ramène. Si la recherche a coupé le servo ou l’amplificateur, il est réactivé.</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>Mettre la position à 0</translation>
    </message>
    <message>
        <source>The first search already finds the index.</source>
        <translation>La première recherche trouve déjà l’index.</translation>
    </message>
    <message>
        <source>Needs Go to home, because the position at which the motor rests becomes 0.</source>
        <translation>Exige «&#xa0;Aller à l’origine&#xa0;»&#xa0;: la position où se trouve le moteur devient 0.</translation>
    </message>
    <message>
        <source>The search direction, in which the switch closes.</source>
        <translation>Sens de recherche, dans lequel le capteur se ferme.</translation>
    </message>
    <message>
        <source>A position error switches the servo off.</source>
        <translation>Une erreur de position coupe le servo.</translation>
    </message>
    <message>
        <source> This chip version does not stop the motor by itself: the panel stops it, a few hundredths of a second later.</source>
        <translation> Cette version de la puce ne s’arrête pas d’elle-même&#xa0;: le programme l’arrête, quelques centièmes de seconde plus tard.</translation>
    </message>
    <message>
        <source> The chip stops it by itself.</source>
        <translation> La puce l’arrête d’elle-même.</translation>
    </message>
    <message>
        <source>At home the motor stops at once and holds.</source>
        <translation>À l’origine, le moteur s’arrête immédiatement et maintient sa position.</translation>
    </message>
    <message>
        <source>At home the motor slows down, stops past it and holds.</source>
        <translation>À l’origine, le moteur ralentit, s’arrête au-delà et maintient sa position.</translation>
    </message>
    <message>
        <source>At home the motor is switched off and is free to turn.</source>
        <translation>À l’origine, le moteur est coupé et peut tourner librement.</translation>
    </message>
    <message>
        <source>Once the motor is at home, its position becomes 0.</source>
        <translation>Dès que le moteur est à l’origine, sa position devient 0.</translation>
    </message>
    <message>
        <source>Limit 1 (reverse)</source>
        <translation>Fin de course 1 (arrière)</translation>
    </message>
    <message>
        <source>Limit 2 (forward)</source>
        <translation>Fin de course 2 (avant)</translation>
    </message>
</context>
<context>
    <name>nmc::IoBox</name>
    <message>
        <source>Limits and I/O</source>
        <translation>Fins de course et E/S</translation>
    </message>
    <message>
        <source>The encoder&apos;s index pulse, once per turn with most encoders.</source>
        <translation>Impulsion d’index du codeur, une fois par tour avec la plupart des codeurs.</translation>
    </message>
    <message>
        <source>Without motor power the servo switches off, and stays off when power returns.</source>
        <translation>Sans alimentation moteur, le servo se coupe, et reste coupé au retour de l’alimentation.</translation>
    </message>
    <message>
        <source>The A/D input; with most amplifiers, the motor current. Set its scale on the Axis page.</source>
        <translation>Entrée A/D&#x202f;; avec la plupart des amplificateurs, le courant moteur. Son échelle se définit sur la page Axe.</translation>
    </message>
    <message>
        <source>Amplifier enabled (&amp;AMP_EN)</source>
        <translation>A&amp;mplificateur actif (AMP_EN)</translation>
    </message>
    <message>
        <source>On this chip, a limit switch alone does not stop the motor. Arm a limit stop on the Homing page.</source>
        <translation>Avec cette puce, un fin de course seul n’arrête pas le moteur. Armez un arrêt sur fin de course sur la page Prise d’origine.</translation>
    </message>
    <message>
        <source>Limit &amp;1</source>
        <translation>Fin de course &amp;1</translation>
    </message>
    <message>
        <source>Limit &amp;2</source>
        <translation>Fin de course &amp;2</translation>
    </message>
    <message>
        <source>Limit %1: input or output</source>
        <translation>Fin de course %1&#xa0;: entrée ou sortie</translation>
    </message>
    <message>
        <source>output, low</source>
        <translation>sortie, bas</translation>
    </message>
    <message>
        <source>output, high</source>
        <translation>sortie, haut</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Nothing is sent until all are chosen.</source>
        <translation>Un autre programme a configuré ce module&#xa0;: le sens de ses broches est inconnu. Rien n’est envoyé tant que tout n’est pas choisi.</translation>
    </message>
    <message>
        <source>Makes the pin an input, or an output with this level. Sent at once.</source>
        <translation>Fait de la broche une entrée, ou une sortie à ce niveau. Envoyé aussitôt.</translation>
    </message>
    <message>
        <source>at the index</source>
        <translation>sur l’index</translation>
    </message>
    <message>
        <source>not at the index</source>
        <translation>hors de l’index</translation>
    </message>
    <message>
        <source>present</source>
        <translation>présente</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>absente</translation>
    </message>
    <message>
        <source>Switches only the amplifier&apos;s enable line; the servo stays as it is. When off, the motor gets no current, whatever the servo does.</source>
        <translation>Commute seulement la ligne d’activation de l’amplificateur&#x202f;; le servo reste tel quel. Si elle est inactive, le moteur ne reçoit aucun courant, quoi que fasse le servo.</translation>
    </message>
    <message>
        <source>The Amplifier page sets what the module does when a limit closes.</source>
        <translation>La page Amplificateur définit ce que fait le module quand un fin de course se ferme.</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz. Sent at once.</source>
        <translation>Points de trajectoire à 60 et 120&#xa0;Hz au lieu de 30 et 60&#xa0;Hz. Envoyé aussitôt.</translation>
    </message>
</context>
<context>
    <name>nmc::IoHead</name>
    <message>
        <source>Name of this module</source>
        <translation>Nom de ce module</translation>
    </message>
    <message>
        <source>Last answer: %1.</source>
        <translation>Dernière réponse&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>nmc::IoPanel</name>
    <message>
        <source>I/O module</source>
        <translation>Module d’E/S</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Compteur</translation>
    </message>
</context>
<context>
    <name>nmc::IoValuesBox</name>
    <message>
        <source>Reads</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Per count</source>
        <translation>Par unité</translation>
    </message>
    <message>
        <source>At 0</source>
        <translation>À 0</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>Valeur de %1</translation>
    </message>
    <message>
        <source>%1 per count</source>
        <translation>%1, par unité</translation>
    </message>
    <message>
        <source>The value of one A/D count.</source>
        <translation>Valeur d’une unité A/D.</translation>
    </message>
    <message>
        <source>The unit of the value.</source>
        <translation>Unité de la valeur.</translation>
    </message>
    <message>
        <source>%1 at 0</source>
        <translation>%1 à 0</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unité de %1</translation>
    </message>
    <message>
        <source>PWM output</source>
        <translation>Sortie PWM</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Actuel</translation>
    </message>
    <message>
        <source>0 to 255</source>
        <translation>0 à 255</translation>
    </message>
    <message>
        <source>Last value sent to %1</source>
        <translation>Dernière valeur envoyée à %1</translation>
    </message>
    <message>
        <source>255 is always on. Press Enter to send.</source>
        <translation>255&#xa0;: toujours actif. Appuyez sur Entrée pour envoyer.</translation>
    </message>
    <message>
        <source>Switch %1 off on STOP ALL</source>
        <translation>Couper %1 par TOUT ARRÊTER</translation>
    </message>
    <message>
        <source>STOP ALL switches this output off. If cleared, the output stays as it is.</source>
        <translation>TOUT ARRÊTER coupe cette sortie. Si la case est décochée, la sortie reste telle quelle.</translation>
    </message>
    <message>
        <source>The PWM values are unknown. Enter one for each output: both are sent together.</source>
        <translation>Les valeurs PWM sont inconnues. Saisissez-en une pour chaque sortie&#xa0;: les deux sont envoyées ensemble.</translation>
    </message>
</context>
<context>
    <name>nmc::JogBox</name>
    <message>
        <source>Jog speed</source>
        <translation>Vitesse de jog</translation>
    </message>
    <message>
        <source>Hold to move in reverse</source>
        <translation>Jog en arrière tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Hold to move forward</source>
        <translation>Jog en avant tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it. Returns to a low value at each connection; set the max jog speed on the Axis page.</source>
        <translation>Vitesse du moteur tant que vous maintenez un bouton, ou la barre d’espace sur celui-ci. Revient à une valeur faible à chaque connexion&#x202f;; la vitesse de jog max. se définit sur la page Axe.</translation>
    </message>
    <message>
        <source>J&amp;og speed</source>
        <translation>Vitesse de &amp;jog</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it: %1 to %2. Set the max jog speed on the Parameters page.</source>
        <translation>Vitesse du moteur tant que vous maintenez un bouton, ou la barre d’espace sur celui-ci&#xa0;: %1 à %2. La vitesse de jog max. se définit sur la page Paramètres.</translation>
    </message>
</context>
<context>
    <name>nmc::Layouts</name>
    <message>
        <source>&amp;Operate</source>
        <translation>&amp;Exploitation</translation>
    </message>
    <message>
        <source>Motion in the middle, everything else around it.</source>
        <translation>Le mouvement au centre, tout le reste autour.</translation>
    </message>
    <message>
        <source>&amp;Tune</source>
        <translation>Ré&amp;glage</translation>
    </message>
    <message>
        <source>Large plots, with gains and step response beside them.</source>
        <translation>Grands graphiques, avec les gains et la réponse indicielle à côté.</translation>
    </message>
    <message>
        <source>&amp;Chain</source>
        <translation>&amp;Chaîne</translation>
    </message>
    <message>
        <source>Modules, packets and messages.</source>
        <translation>Modules, trames et messages.</translation>
    </message>
</context>
<context>
    <name>nmc::LendDialog</name>
    <message>
        <source>Path of the terminal</source>
        <translation>Chemin du terminal</translation>
    </message>
    <message>
        <source>&amp;Lend the line</source>
        <translation>&amp;Prêter la ligne</translation>
    </message>
    <message>
        <source>Lend the line to a program</source>
        <translation>Prêter la ligne à un programme</translation>
    </message>
    <message>
        <source>The program opens this path in place of the serial port, and has the modules for itself. The panel shows and records what they report, and sends nothing: your travel limits, stops at limits and other checks do not protect the motors. STOP ALL works, and holds the program off.</source>
        <translation>Le programme ouvre ce chemin à la place du port série, et a les modules pour lui seul. Le panneau montre et enregistre ce qu’ils signalent, et n’envoie rien&#xa0;: limites de course, arrêts aux limites et autres contrôles ne protègent pas les moteurs. TOUT ARRÊTER agit, et tient le programme à l’écart.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>&amp;Path of the terminal</source>
        <translation>&amp;Chemin du terminal</translation>
    </message>
    <message>
        <source>A motor is moving. Stop it first.</source>
        <translation>Un moteur est en mouvement. Arrêtez-le d’abord.</translation>
    </message>
    <message>
        <source>Enter a path.</source>
        <translation>Saisissez un chemin.</translation>
    </message>
    <message>
        <source>Creates the terminal. Nothing moves.</source>
        <translation>Crée le terminal. Rien ne bouge.</translation>
    </message>
</context>
<context>
    <name>nmc::LimitStopBox</name>
    <message>
        <source>Arm limit stop</source>
        <translation>Armer l’arrêt</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Désarmer</translation>
    </message>
    <message>
        <source>Limit 1: stop there</source>
        <translation>Fin de course 1&#xa0;: arrêt à cet endroit</translation>
    </message>
    <message>
        <source>Limit 2: stop there</source>
        <translation>Fin de course 2&#xa0;: arrêt à cet endroit</translation>
    </message>
    <message>
        <source>Disarm limit stop</source>
        <translation>Désarmer l’arrêt sur fin de course</translation>
    </message>
    <message>
        <source>State of the limit stop</source>
        <translation>État de l’arrêt sur fin de course</translation>
    </message>
    <message>
        <source>Abruptly: stop at the limit</source>
        <translation>Brutal&#xa0;: arrêt au fin de course</translation>
    </message>
    <message>
        <source>Smoothly: stop at the limit</source>
        <translation>Progressif&#xa0;: arrêt au fin de course</translation>
    </message>
    <message>
        <source>Motor off at the limit</source>
        <translation>Couper le moteur au fin de course</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Arrêt sur</translation>
    </message>
    <message>
        <source>Select a limit switch first.</source>
        <translation>Sélectionnez d’abord un fin de course.</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 1 changes.</source>
        <translation>Le moteur s’arrête quand le fin de course 1 change d’état.</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 2 changes.</source>
        <translation>Le moteur s’arrête quand le fin de course 2 change d’état.</translation>
    </message>
    <message>
        <source>At the limit the motor stops at once and holds.</source>
        <translation>Au fin de course, le moteur s’arrête immédiatement et maintient sa position.</translation>
    </message>
    <message>
        <source>At the limit the motor slows down, stops past it and holds.</source>
        <translation>Au fin de course, le moteur ralentit, s’arrête au-delà et maintient sa position.</translation>
    </message>
    <message>
        <source>At the limit the motor is switched off and is free to turn.</source>
        <translation>Au fin de course, le moteur est coupé et peut tourner librement.</translation>
    </message>
    <message>
        <source>The chip itself then stops the motor once when a selected limit switch changes, faster than the panel could. A search for home replaces it.</source>
        <translation>La puce elle-même arrête alors le moteur une fois, quand un fin de course sélectionné change d’état, plus vite que le programme ne le pourrait. Une recherche d’origine prend sa place.</translation>
    </message>
    <message>
        <source>The limit stop is not armed.</source>
        <translation>L’arrêt sur fin de course n’est pas armé.</translation>
    </message>
    <message>
        <source>A limit switch no longer stops the motor.</source>
        <translation>Un fin de course n’arrête plus le moteur.</translation>
    </message>
    <message>
        <source>○ Not armed: a limit switch alone does not stop the motor.</source>
        <translation>○ Non armé&#xa0;: un fin de course seul n’arrête pas le moteur.</translation>
    </message>
    <message>
        <source>○ This chip version cannot stop at a limit switch.</source>
        <translation>○ Cette version de la puce ne sait pas s’arrêter sur un fin de course.</translation>
    </message>
    <message>
        <source>● Armed: stops at %1, once.</source>
        <translation>● Armé&#xa0;: arrêt sur %1, une fois.</translation>
    </message>
    <message>
        <source>▲ Tripped by %1; the motor was stopped. No longer armed.</source>
        <translation>▲ Déclenché par %1&#xa0;: le moteur a été arrêté. N’est plus armé.</translation>
    </message>
    <message>
        <source>? The chip watches for an event that this connection did not request.</source>
        <translation>? La puce guette un événement que cette connexion n’a pas demandé.</translation>
    </message>
    <message>
        <source>the position error limit</source>
        <translation>limite d’erreur de position</translation>
    </message>
    <message>
        <source>the current limit</source>
        <translation>limite de courant</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Courant</translation>
    </message>
    <message>
        <source>for each motion of this axis</source>
        <translation>à chaque mouvement de cet axe</translation>
    </message>
    <message>
        <source>Position error stops the motor</source>
        <translation>Erreur de position&#xa0;: arrêter le moteur</translation>
    </message>
    <message>
        <source>Current stops the motor</source>
        <translation>Courant&#xa0;: arrêter le moteur</translation>
    </message>
    <message>
        <source>For each motion of this axis, arm the limit stop</source>
        <translation>À chaque mouvement de cet axe, armer l’arrêt sur fin de course</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armé</translation>
    </message>
    <message>
        <source>The motor stops when the position error exceeds EL; this always switches the servo off.</source>
        <translation>Le moteur s’arrête quand l’erreur de position dépasse EL&#x202f;; cela coupe toujours le servo.</translation>
    </message>
    <message>
        <source>The motor stops when its current exceeds CL.</source>
        <translation>Le moteur s’arrête quand son courant dépasse CL.</translation>
    </message>
    <message>
        <source>The panel arms the limit stop whenever the motor is at rest with its servo on, even after a trip, and before any motion starts. Saved with the machine.</source>
        <translation>Le programme arme l’arrêt sur fin de course dès que le moteur est à l’arrêt avec le servo actif, même après un déclenchement, et avant tout mouvement. Enregistré avec la machine.</translation>
    </message>
    <message>
        <source>The limit stop is armed for each motion. Clear that check box first.</source>
        <translation>L’arrêt sur fin de course est armé pour chaque mouvement. Décochez d’abord cette case.</translation>
    </message>
    <message>
        <source>A search for home or a measurement is running and uses the same function of the chip.</source>
        <translation>Une recherche d’origine ou une mesure est en cours et utilise la même fonction de la puce.</translation>
    </message>
    <message>
        <source>○ Not armed: the search for home or the measurement has replaced it.</source>
        <translation>○ Non armé&#xa0;: la recherche d’origine ou la mesure a pris sa place.</translation>
    </message>
</context>
<context>
    <name>nmc::LinkBar</name>
    <message>
        <source>State of the link</source>
        <translation>État de la liaison</translation>
    </message>
    <message>
        <source>Exchanges per second, and their share of the line&apos;s capacity.</source>
        <translation>Échanges par seconde, et leur part de la capacité de la ligne.</translation>
    </message>
    <message>
        <source>Failed exchanges: no answer, garbled, or refused for a bad checksum.</source>
        <translation>Échanges échoués&#xa0;: pas de réponse, réponse altérée, ou refus pour somme de contrôle fausse.</translation>
    </message>
    <message>
        <source>Mean time from sending a command to its complete answer.</source>
        <translation>Temps moyen entre l’envoi d’une commande et sa réponse complète.</translation>
    </message>
    <message>
        <source>– exchanges/s</source>
        <translation>– échanges/s</translation>
    </message>
    <message>
        <source>– errors</source>
        <translation>– erreurs</translation>
    </message>
    <message>
        <source>round trip –</source>
        <translation>aller-retour –</translation>
    </message>
    <message>
        <source>%1 exchanges/s, %2 % bus load</source>
        <translation>%1 échanges/s, %2&#x202f;% de la ligne</translation>
    </message>
    <message numerus="yes">
        <source>%1 errors, %2/s</source>
        <translation>
            <numerusform>%1 erreur, %2/s</numerusform>
            <numerusform>%1 erreurs, %2/s</numerusform>
        </translation>
    </message>
    <message>
        <source>round trip %1 ms</source>
        <translation>aller-retour %1&#xa0;ms</translation>
    </message>
</context>
<context>
    <name>nmc::LoopTestsDock</name>
    <message>
        <source>Square wave, frequency response (Bode plot), and a report of the tuning</source>
        <translation>Signal carré, réponse en fréquence (diagramme de Bode) et rapport du réglage</translation>
    </message>
    <message>
        <source>Loop tests</source>
        <translation>Essais de boucle</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Report: save the tuning</source>
        <translation>Rapport&#xa0;: enregistrer le réglage</translation>
    </message>
    <message>
        <source>Select a PIC-SERVO first.</source>
        <translation>Sélectionnez d’abord un PIC-SERVO.</translation>
    </message>
    <message>
        <source>Saves one page as PDF or HTML: gains, last step response, motor model and frequency response.</source>
        <translation>Enregistre une page en PDF ou HTML&#xa0;: gains, dernière réponse indicielle, modèle du moteur et réponse en fréquence.</translation>
    </message>
</context>
<context>
    <name>nmc::MachineMenu</name>
    <message>
        <source>&amp;New machine</source>
        <translation>&amp;Nouvelle machine</translation>
    </message>
    <message>
        <source>Discards names, units and settings of all axes; nothing is sent.</source>
        <translation>Abandonne les noms, unités et réglages de tous les axes&#x202f;; rien n’est envoyé.</translation>
    </message>
    <message>
        <source>&amp;Open machine…</source>
        <translation>&amp;Ouvrir une machine…</translation>
    </message>
    <message>
        <source>Shows what a machine file would change. Nothing is sent until you apply it.</source>
        <translation>Montre ce qu’un fichier machine changerait. Rien n’est envoyé tant que vous ne l’appliquez pas.</translation>
    </message>
    <message>
        <source>&amp;Save machine</source>
        <translation>&amp;Enregistrer la machine</translation>
    </message>
    <message>
        <source>Saves names, units, gains, limits, homing and groups to the machine file.</source>
        <translation>Enregistre noms, unités, gains, limites, prise d’origine et groupes dans le fichier machine.</translation>
    </message>
    <message>
        <source>Save machine &amp;as…</source>
        <translation>Enregistrer la machine &amp;sous…</translation>
    </message>
    <message>
        <source>Saves the machine under another file name.</source>
        <translation>Enregistre la machine sous un autre nom de fichier.</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>Fichiers ré&amp;cents</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>new machine</source>
        <translation>nouvelle machine</translation>
    </message>
    <message>
        <source>Machine files (*.%1)</source>
        <translation>Fichiers machine (*.%1)</translation>
    </message>
    <message>
        <source>Save machine</source>
        <translation>Enregistrer la machine</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>machine</translation>
    </message>
    <message>
        <source>&amp;Save and close</source>
        <translation>&amp;Enregistrer et fermer</translation>
    </message>
    <message>
        <source>&amp;Close: the changes can be restored at the next start</source>
        <translation>&amp;Fermer&#xa0;: le prochain démarrage proposera de les rétablir</translation>
    </message>
    <message>
        <source>&amp;Save changes</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard: the changes are lost</source>
        <translation>Aban&amp;donner&#xa0;: les modifications seront perdues</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>%1 (being saved)</source>
        <translation>%1 (enregistrement en cours)</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Enregistrement</translation>
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
        <translation>Menus</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>Modules</translation>
    </message>
    <message>
        <source>NMC Panel - Simulator</source>
        <translation>NMC Panel - Simulateur</translation>
    </message>
    <message>
        <source>NMC Panel - %1</source>
        <translation>NMC Panel - %1</translation>
    </message>
    <message>
        <source>&amp;Stop and disconnect</source>
        <translation>Arrêter et &amp;déconnecter</translation>
    </message>
    <message>
        <source>&amp;Stop and close</source>
        <translation>Arrêter et &amp;fermer</translation>
    </message>
    <message>
        <source>Motors are moving</source>
        <translation>Moteurs en mouvement</translation>
    </message>
    <message>
        <source>Restart the network</source>
        <translation>Redémarrer le réseau</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost</source>
        <translation>Redémarrer le &amp;réseau&#xa0;: positions et gains seront perdus</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (lecture seule)</translation>
    </message>
    <message>
        <source>No module can be moved. Connect a motor module first.</source>
        <translation>Aucun module ne peut être déplacé. Connectez d’abord un module moteur.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
    <message>
        <source>Let the program &quot;%1&quot; move motors? Esc, STOP ALL or any command of yours ends that.</source>
        <translation>Laisser le programme «&#xa0;%1&#xa0;» déplacer les moteurs&#xa0;? Échap, TOUT ARRÊTER ou toute commande de votre part y met fin.</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Refuser</translation>
    </message>
    <message>
        <source>Let it move motors</source>
        <translation>Laisser déplacer</translation>
    </message>
</context>
<context>
    <name>nmc::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>NMC Panel - Manual</source>
        <translation>NMC Panel - Manuel</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Pages du manuel</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Page du manuel</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Goes back to the previous page (%1).</source>
        <translation>Revient à la page précédente (%1).</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Goes forward again (%1).</source>
        <translation>Repasse à la page suivante (%1).</translation>
    </message>
    <message>
        <source>Search this page</source>
        <translation>Rechercher dans la page</translation>
    </message>
    <message>
        <source>Enter finds the next match, Shift+Enter the previous one (Ctrl+F).</source>
        <translation>Entrée trouve l’occurrence suivante, Maj+Entrée la précédente (Ctrl+F).</translation>
    </message>
    <message>
        <source>The manual is not installed. It belongs in %1.</source>
        <translation>Le manuel n’est pas installé. Son emplacement prévu est %1.</translation>
    </message>
    <message>
        <source>Not found on this page</source>
        <translation>Introuvable dans cette page</translation>
    </message>
</context>
<context>
    <name>nmc::MessageList</name>
    <message>
        <source>No messages. Problems are listed here, with the time when they ended.</source>
        <translation>Aucun message. Les problèmes s’affichent ici, ainsi que leur fin.</translation>
    </message>
    <message>
        <source>No message matches the filter above.</source>
        <translation>Aucun message ne correspond au filtre ci-dessus.</translation>
    </message>
</context>
<context>
    <name>nmc::MessagePanel</name>
    <message>
        <source>Messages and their filter</source>
        <translation>Messages et leur filtre</translation>
    </message>
    <message>
        <source>Kind of messages shown</source>
        <translation>Type de messages affichés</translation>
    </message>
    <message>
        <source>Filters the messages by kind.</source>
        <translation>Filtre les messages par type.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Module whose messages are shown</source>
        <translation>Module dont les messages sont affichés</translation>
    </message>
    <message>
        <source>Filters the messages by module.</source>
        <translation>Filtre les messages par module.</translation>
    </message>
    <message>
        <source>Active only</source>
        <translation>Actifs</translation>
    </message>
    <message>
        <source>Shows only messages whose cause persists.</source>
        <translation>N’affiche que les messages dont la cause persiste.</translation>
    </message>
    <message>
        <source>Search messages</source>
        <translation>Rechercher dans les messages</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Shows only messages that contain these words.</source>
        <translation>N’affiche que les messages qui contiennent ces mots.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Export the messages shown</source>
        <translation>Exporter les messages affichés</translation>
    </message>
    <message>
        <source>Saves the messages shown to a text file.</source>
        <translation>Enregistre les messages affichés dans un fichier texte.</translation>
    </message>
    <message>
        <source>Kept for this session only.</source>
        <translation>Conservés pour cette session seulement.</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Conservés dans %1</translation>
    </message>
    <message>
        <source>Export messages</source>
        <translation>Exporter les messages</translation>
    </message>
</context>
<context>
    <name>nmc::MessageRow</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n fois</numerusform>
            <numerusform>%n fois</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::ModelBox</name>
    <message>
        <source>Motor model</source>
        <translation>Modèle du moteur</translation>
    </message>
    <message>
        <source>Find motor model</source>
        <translation>Identifier le modèle</translation>
    </message>
    <message>
        <source>Find motor model from the steps</source>
        <translation>Identifier le modèle du moteur d’après les échelons</translation>
    </message>
    <message>
        <source>Motor model found</source>
        <translation>Modèle du moteur identifié</translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Fill in the suggested gains</source>
        <translation>Remplir les gains proposés</translation>
    </message>
    <message>
        <source>Suggested gains</source>
        <translation>Gains proposés</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Raide</translation>
    </message>
    <message>
        <source>How fast the motor follows. Far right: as fast as noise, output limit and stability permit.</source>
        <translation>Rapidité avec laquelle le moteur suit. Tout à droite&#xa0;: aussi vite que le bruit, la limite de sortie et la stabilité le permettent.</translation>
    </message>
    <message>
        <source>Damped</source>
        <translation>Amorti</translation>
    </message>
    <message>
        <source>Damping. Far right: no overshoot.</source>
        <translation>Amortissement. Tout à droite&#xa0;: pas de dépassement.</translation>
    </message>
    <message>
        <source>Loud</source>
        <translation>Bruyant</translation>
    </message>
    <message>
        <source>How much encoder noise may drive the motor through Kd.</source>
        <translation>Part du bruit du codeur qui peut entraîner le moteur à travers Kd.</translation>
    </message>
    <message>
        <source>The motor model is being calculated.</source>
        <translation>Le calcul du modèle du moteur est en cours.</translation>
    </message>
    <message>
        <source>Record a step with this module first.</source>
        <translation>Enregistrez d’abord un échelon avec ce module.</translation>
    </message>
    <message>
        <source>Calculates the motor model from up to %1 recent steps of this module. Sends nothing.</source>
        <translation>Calcule le modèle du moteur à partir des %1 derniers échelons au plus de ce module. N’envoie rien.</translation>
    </message>
    <message>
        <source>No suggested gains. Find the motor model first.</source>
        <translation>Pas de gains proposés. Identifiez d’abord le modèle du moteur.</translation>
    </message>
    <message>
        <source>Copies the suggested gains to the Gains page. Sends nothing.</source>
        <translation>Copie les gains proposés dans la page Gains. N’envoie rien.</translation>
    </message>
    <message>
        <source>Calculating the motor model…</source>
        <translation>Calcul du modèle du moteur…</translation>
    </message>
    <message>
        <source>The run behind this model was removed. Find the motor model again.</source>
        <translation>Le relevé qui a servi à ce modèle a été supprimé. Identifiez de nouveau le modèle du moteur.</translation>
    </message>
    <message>
        <source>No gains keep this motor stable and quiet.</source>
        <translation>Aucun gain ne rend ce moteur stable et silencieux.</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Marge de phase</translation>
    </message>
    <message>
        <source>The phase margin</source>
        <translation>La marge de phase</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the suggested loop is from oscillating, at least. 30°: fast, rings. 45° to 60°: moderate.</source>
        <translation>À quelle distance de l’oscillation la boucle proposée reste au moins. 30° : rapide, avec rebonds. 45° à 60° : modéré.</translation>
    </message>
    <message>
        <source>° at least</source>
        <translation>° au moins</translation>
    </message>
    <message>
        <source>Step once more and find model</source>
        <translation>1 échelon de plus, puis identifier</translation>
    </message>
    <message>
        <source>Step %1 times and find model</source>
        <translation>%1 échelons, puis identifier</translation>
    </message>
    <message>
        <source>The motor jumps once more, as far as before; the model is then found from the recent steps. Make sure that everything it drives can move freely.</source>
        <translation>Le moteur saute encore une fois, aussi loin qu’avant, et est identifié à partir des derniers échelons. Assurez-vous que tout ce qu’il entraîne peut bouger librement.</translation>
    </message>
    <message>
        <source>The motor jumps by the distance of the step and back, then twice as far and back, but no farther than %1 and %2 counts; the model is then found from these steps. Make sure that everything it drives can move freely.</source>
        <translation>Le moteur saute de la distance de l’échelon et revient, puis deux fois plus loin et revient, mais d’au plus %1 et %2 incr., et est identifié à partir de ces échelons. Assurez-vous que tout ce qu’il entraîne peut bouger librement.</translation>
    </message>
    <message>
        <source>Calculating the suggested gains…</source>
        <translation>Calcul des gains proposés…</translation>
    </message>
    <message>
        <source>The suggested gains are being calculated.</source>
        <translation>Le calcul des gains proposés est en cours.</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleBench</name>
    <message>
        <source>Simulated module controls</source>
        <translation>Commandes du module simulé</translation>
    </message>
    <message>
        <source>Pages of the simulated module</source>
        <translation>Pages du module simulé</translation>
    </message>
    <message>
        <source>Switches</source>
        <translation>Interrupteurs</translation>
    </message>
    <message>
        <source>Closed while checked.</source>
        <translation>Fermé si coché.</translation>
    </message>
    <message>
        <source>The motor&apos;s supply, not the module&apos;s.</source>
        <translation>L’alimentation du moteur, pas celle du module.</translation>
    </message>
    <message>
        <source>Limit switch 1, forward</source>
        <translation>Fin de course 1, avant</translation>
    </message>
    <message>
        <source>Limit switch 2, reverse</source>
        <translation>Fin de course 2, arrière</translation>
    </message>
    <message>
        <source>Input 1</source>
        <translation>Entrée 1</translation>
    </message>
    <message>
        <source>Input 2</source>
        <translation>Entrée 2</translation>
    </message>
    <message>
        <source>The A/D reading of the temperature sensor.</source>
        <translation>Lecture A/D du capteur de température.</translation>
    </message>
    <message>
        <source>Limit switch 1</source>
        <translation>Fin de course 1</translation>
    </message>
    <message>
        <source>Limit switch 2</source>
        <translation>Fin de course 2</translation>
    </message>
    <message>
        <source>Encoder index</source>
        <translation>Index du codeur</translation>
    </message>
    <message>
        <source>Stays until the shaft moves.</source>
        <translation>Persiste jusqu’à ce que l’arbre bouge.</translation>
    </message>
    <message>
        <source>Set the A/D input by hand</source>
        <translation>Fixer l’entrée A/D à la main</translation>
    </message>
    <message>
        <source>If cleared, the A/D input reads the motor current.</source>
        <translation>Si la case est décochée, l’entrée A/D lit le courant moteur.</translation>
    </message>
    <message>
        <source>ADDR line broken towards the host</source>
        <translation>Ligne ADDR coupée vers l’hôte</translation>
    </message>
    <message>
        <source>The line is broken between this module and the next one towards the host, which then gets no address.</source>
        <translation>La ligne est coupée entre ce module et le suivant en direction de l’hôte, qui ne reçoit alors pas d’adresse.</translation>
    </message>
    <message>
        <source>Power-cycle</source>
        <translation>Couper/remettre</translation>
    </message>
    <message>
        <source>Switches this module off and on: it loses its address and gains.</source>
        <translation>Coupe et remet l’alimentation de ce module&#xa0;: il perd son adresse et ses gains.</translation>
    </message>
    <message>
        <source>Power-cycle all</source>
        <translation>Couper/remettre tout</translation>
    </message>
    <message>
        <source>Switches all modules off and on: they lose their addresses and gains.</source>
        <translation>Coupe et remet l’alimentation de tous les modules&#xa0;: ils perdent leurs adresses et leurs gains.</translation>
    </message>
    <message>
        <source>Late tick</source>
        <translation>Cycle tardif</translation>
    </message>
    <message>
        <source>Makes one servo tick take too long: servo_overrun.</source>
        <translation>Fait durer un cycle servo trop longtemps&#xa0;: servo_overrun.</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mécanique</translation>
    </message>
    <message>
        <source>Load torque</source>
        <translation>Couple de charge</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>External torque; positive values turn the shaft in reverse.</source>
        <translation>Couple extérieur&#x202f;; une valeur positive fait tourner l’arbre en arrière.</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Inertie</translation>
    </message>
    <message>
        <source>10⁻⁶ kg·m²</source>
        <translation>10⁻⁶ kg·m²</translation>
    </message>
    <message>
        <source>Moment of inertia of rotor and load.</source>
        <translation>Moment d’inertie du rotor et de la charge.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Dry friction; it also holds the shaft at rest.</source>
        <translation>Frottement sec&#x202f;; il retient aussi l’arbre à l’arrêt.</translation>
    </message>
    <message>
        <source>Stop, reverse</source>
        <translation>Butée arrière</translation>
    </message>
    <message>
        <source>A hard stop at the reverse end of travel. It cannot be set past the present shaft position.</source>
        <translation>Butée mécanique à l’extrémité arrière de la course. Elle ne peut pas être placée au-delà de la position actuelle de l’arbre.</translation>
    </message>
    <message>
        <source>Stop, forward</source>
        <translation>Butée avant</translation>
    </message>
    <message>
        <source>A hard stop at the forward end of travel. It cannot be set past the present shaft position.</source>
        <translation>Butée mécanique à l’extrémité avant de la course. Elle ne peut pas être placée au-delà de la position actuelle de l’arbre.</translation>
    </message>
    <message>
        <source>Limit switches at the stops</source>
        <translation>Fins de course aux butées</translation>
    </message>
    <message>
        <source>The limit switches close at the ends of travel and cannot be set by hand.</source>
        <translation>Les fins de course se ferment aux extrémités de la course et ne peuvent pas être réglés à la main.</translation>
    </message>
    <message>
        <source>Home switch at</source>
        <translation>Capteur d’origine à</translation>
    </message>
    <message>
        <source>Follows the motor&apos;s position: see Mechanics.</source>
        <translation>Suit la position du moteur&#xa0;: voir Mécanique.</translation>
    </message>
    <message>
        <source>The home switch is closed forward of this position. If cleared, set it by hand.</source>
        <translation>Le capteur d’origine est fermé en avant de cette position. Si la case est décochée, il se règle à la main.</translation>
    </message>
    <message>
        <source>%1: level</source>
        <translation>%1&#xa0;: niveau</translation>
    </message>
    <message>
        <source>255 is 5 V.</source>
        <translation>255 correspond à 5&#xa0;V.</translation>
    </message>
    <message>
        <source>PWM 1 and 2</source>
        <translation>PWM 1 et 2</translation>
    </message>
    <message>
        <source>The module&apos;s PWM outputs, 0 to 255.</source>
        <translation>Valeurs que le module délivre, sur 255.</translation>
    </message>
    <message>
        <source>Timer or counter</source>
        <translation>Timer ou compteur</translation>
    </message>
    <message>
        <source>The module&apos;s own count.</source>
        <translation>Tel que le module le compte.</translation>
    </message>
    <message>
        <source>An output: the module sets its level.</source>
        <translation>Une sortie&#xa0;: le module définit son niveau.</translation>
    </message>
    <message>
        <source>High while checked.</source>
        <translation>État haut si coché.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>off, %1</source>
        <translation>inactif, %1</translation>
    </message>
    <message>
        <source>timer, %1</source>
        <translation>timer, %1</translation>
    </message>
    <message>
        <source>counter, %1</source>
        <translation>compteur, %1</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleContext</name>
    <message>
        <source>Waiting for the module&apos;s answer.</source>
        <translation>En attente de la réponse du module.</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePage</name>
    <message>
        <source>Motions of the selected module</source>
        <translation>Mouvements du module sélectionné</translation>
    </message>
    <message>
        <source>The pages of this module.</source>
        <translation>Les pages de ce module.</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePanel</name>
    <message>
        <source>Selected module</source>
        <translation>Module sélectionné</translation>
    </message>
</context>
<context>
    <name>nmc::MotionBox</name>
    <message>
        <source>Ve&amp;locity</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>Vitesse du déplacement</translation>
    </message>
    <message>
        <source>Acceleratio&amp;n</source>
        <translation>Accélératio&amp;n</translation>
    </message>
    <message>
        <source>Velocity of running</source>
        <translation>Vitesse de la marche continue</translation>
    </message>
    <message>
        <source>Used by every motion here, and by a smooth stop.</source>
        <translation>Utilisée par tous les mouvements de cette page, et par l’arrêt progressif.</translation>
    </message>
    <message>
        <source>How fast the motor turns.</source>
        <translation>Vitesse à laquelle tourne le moteur.</translation>
    </message>
    <message>
        <source>Position or distance</source>
        <translation>Position ou distance</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>Whether the number is a position, or a distance from the present position.</source>
        <translation>Indique si le nombre est une position, ou une distance depuis la position actuelle.</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>&amp;Zéro ici</translation>
    </message>
    <message>
        <source>Load the move, start it later</source>
        <translation>Charger le déplacement, le démarrer plus tard</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Start the loaded move</source>
        <translation>Démarrer le déplacement chargé</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>Takes %1, peak %2: too short to reach its velocity</source>
        <translation>Dure %1, maximum %2&#xa0;: trop court pour atteindre sa vitesse</translation>
    </message>
    <message>
        <source>Takes %1, peak %2</source>
        <translation>Dure %1, maximum %2</translation>
    </message>
    <message>
        <source>Peak %1</source>
        <translation>Maximum %1</translation>
    </message>
    <message>
        <source>Peak %1: too short to reach its velocity</source>
        <translation>Maximum %1&#xa0;: trop court pour atteindre sa vitesse</translation>
    </message>
    <message>
        <source>Already there</source>
        <translation>Déjà en place</translation>
    </message>
    <message>
        <source>The goal is outside the position range.</source>
        <translation>La cible est hors de la plage de positions.</translation>
    </message>
    <message>
        <source>The goal of a trapezoidal move from standstill. Press Enter to start.</source>
        <translation>Cible d’un déplacement trapézoïdal à partir de l’arrêt. Appuyez sur Entrée pour démarrer.</translation>
    </message>
    <message>
        <source>Go to &amp;position</source>
        <translation>Aller à la &amp;position</translation>
    </message>
    <message>
        <source>Run at velocit&amp;y</source>
        <translation>Vite&amp;sse de marche</translation>
    </message>
    <message>
        <source>The velocity of a run. Press Enter to run, or to change the velocity during a run.</source>
        <translation>Vitesse d’une marche continue. Appuyez sur Entrée pour la lancer, ou pour changer la vitesse en marche.</translation>
    </message>
    <message>
        <source>Loads the move without starting it. Choose Start, or start the module&apos;s group.</source>
        <translation>Charge le déplacement sans le démarrer. Choisissez «&#xa0;Démarrer&#xa0;», ou démarrez le groupe du module.</translation>
    </message>
    <message>
        <source>Starts the loaded move.</source>
        <translation>Démarre le déplacement chargé.</translation>
    </message>
    <message>
        <source>Moves to home.</source>
        <translation>Se déplace à l’origine.</translation>
    </message>
    <message>
        <source>Runs forward until stopped, or to its highest position.</source>
        <translation>Tourne en avant jusqu’à l’ordre d’arrêt, ou jusqu’à sa position maximale.</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped, or to its lowest position.</source>
        <translation>Tourne en arrière jusqu’à l’ordre d’arrêt, ou jusqu’à sa position minimale.</translation>
    </message>
</context>
<context>
    <name>nmc::MoveByBox</name>
    <message>
        <source>Step by a distance</source>
        <translation>Déplacement par pas d’une distance donnée</translation>
    </message>
    <message>
        <source>Step by</source>
        <translation>Déplacement par pas</translation>
    </message>
    <message>
        <source>Distance of a step</source>
        <translation>Distance d’un pas</translation>
    </message>
    <message>
        <source>The distance of a step</source>
        <translation>La distance d’un pas</translation>
    </message>
    <message>
        <source>Step in reverse</source>
        <translation>Pas en arrière</translation>
    </message>
    <message>
        <source>Step forward</source>
        <translation>Pas en avant</translation>
    </message>
    <message>
        <source>The number of steps</source>
        <translation>Le nombre de pas</translation>
    </message>
    <message>
        <source>Number of steps per click.</source>
        <translation>Nombre de pas par clic.</translation>
    </message>
    <message>
        <source>The pause between steps</source>
        <translation>La pause entre les pas</translation>
    </message>
    <message>
        <source>Time to wait after each move, in seconds.</source>
        <translation>Temps d’attente après chaque déplacement, en secondes.</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>aller-retour</translation>
    </message>
    <message>
        <source>There and back with each step</source>
        <translation>Aller-retour à chaque pas</translation>
    </message>
    <message>
        <source>Each step goes there and back.</source>
        <translation>Chaque pas fait un aller et retour.</translation>
    </message>
    <message>
        <source>End steps</source>
        <translation>Terminer les pas</translation>
    </message>
    <message>
        <source>End steps and stop</source>
        <translation>Terminer les pas et arrêter</translation>
    </message>
    <message>
        <source>times, pause</source>
        <translation>fois, pause</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>A series of steps is already running.</source>
        <translation>Une série de pas est déjà en cours.</translation>
    </message>
    <message>
        <source>Moves forward by this distance, then holds.</source>
        <translation>Se déplace en avant de cette distance, puis maintient la position.</translation>
    </message>
    <message>
        <source>Moves in reverse by this distance, then holds.</source>
        <translation>Se déplace en arrière de cette distance, puis maintient la position.</translation>
    </message>
    <message>
        <source>No series of steps is running.</source>
        <translation>Aucune série de pas n’est en cours.</translation>
    </message>
    <message>
        <source>Ends the series of steps and stops the motor smoothly.</source>
        <translation>Met fin à la série de pas et arrête progressivement le moteur.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Distance per click, at the velocity of Go to.</source>
        <translation>Distance par clic, à la vitesse de «&#xa0;Aller à la position&#xa0;».</translation>
    </message>
</context>
<context>
    <name>nmc::NumberField</name>
    <message>
        <source>%1 must be %2 to %3%4.</source>
        <translation>%1&#xa0;: valeurs admises de %2 à %3%4.</translation>
    </message>
    <message>
        <source>Enter a value for %1.</source>
        <translation>Saisissez une valeur&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 must be a number.</source>
        <translation>%1&#xa0;: saisissez un nombre.</translation>
    </message>
    <message>
        <source>%1 has two decimal marks. Both , and . count as decimal marks.</source>
        <translation>%1&#xa0;: deux séparateurs décimaux. La virgule (,) et le point (.) comptent tous deux comme séparateur décimal.</translation>
    </message>
    <message>
        <source>%1 must be a whole number without , or . in it.</source>
        <translation>%1 : saisissez un nombre entier, sans , ni .</translation>
    </message>
    <message>
        <source>%1: %2 can be read in two ways. Press Enter in the field for %3, or type %4.</source>
        <translation>%1 : %2 peut se lire de deux façons. Appuyez sur Entrée dans le champ pour %3, ou saisissez %4.</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorDialog</name>
    <message>
        <source>Select what the operator may do. STOP ALL, Esc, each motor&apos;s stops and Disconnect always work. Operator mode prevents mistakes; it is not a security feature: anyone with access to this computer&apos;s files can bypass it.</source>
        <translation>Sélectionnez ce que l’opérateur peut faire. TOUT ARRÊTER, Esc, les arrêts de chaque moteur et «&#xa0;Déconnecter&#xa0;» restent toujours utilisables. Le mode opérateur évite les erreurs&#x202f;; ce n’est pas une protection&#xa0;: quiconque accède aux fichiers de cet ordinateur peut le contourner.</translation>
    </message>
    <message>
        <source>&amp;Enable motors, clear faults</source>
        <translation>Activ&amp;er les moteurs, acquitter les défauts</translation>
    </message>
    <message>
        <source>&amp;Jog</source>
        <translation>&amp;Jog</translation>
    </message>
    <message>
        <source>&amp;Points and sequences</source>
        <translation>&amp;Points et séquences</translation>
    </message>
    <message>
        <source>&amp;Moves: go to, run, step</source>
        <translation>Déplace&amp;ments&#xa0;: cible, marche continue, par pas</translation>
    </message>
    <message>
        <source>&amp;Homing</source>
        <translation>Prise d’ori&amp;gine</translation>
    </message>
    <message>
        <source>&amp;Outputs</source>
        <translation>S&amp;orties</translation>
    </message>
    <message>
        <source>P&amp;IN to leave operator mode, at least 4 characters</source>
        <translation>P&amp;IN pour quitter le mode opérateur, au moins 4 caractères</translation>
    </message>
    <message>
        <source>PIN &amp;again</source>
        <translation>&amp;Confirmer le PIN</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>&amp;Leave operator mode</source>
        <translation>&amp;Quitter le mode opérateur</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Cancel: keep the mode unchanged</source>
        <translation>Annuler&#xa0;: garder le mode inchangé</translation>
    </message>
    <message>
        <source>The PIN is too short: use at least 4 characters.</source>
        <translation>Le PIN est trop court&#xa0;: utilisez au moins 4 caractères.</translation>
    </message>
    <message>
        <source>The two PINs differ. Type the same PIN twice.</source>
        <translation>Les deux PIN diffèrent. Saisissez deux fois le même.</translation>
    </message>
    <message>
        <source>Wrong PIN. %1</source>
        <translation>PIN incorrect. %1</translation>
    </message>
    <message>
        <source>E&amp;nter operator mode</source>
        <translation>Passer en mode opéra&amp;teur</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorLock</name>
    <message>
        <source>If you forgot it, close the panel and remove the &quot;operator&quot; section from %1.</source>
        <translation>Si vous l’avez oublié, fermez le programme et supprimez la section «&#xa0;operator&#xa0;» de %1.</translation>
    </message>
    <message>
        <source>Leave o&amp;perator mode…</source>
        <translation>Quitter le mode o&amp;pérateur…</translation>
    </message>
    <message>
        <source>O&amp;perator mode…</source>
        <translation>Mode o&amp;pérateur…</translation>
    </message>
    <message>
        <source>Limits the panel to the actions that you select, until someone enters the PIN.</source>
        <translation>Limite le programme aux actions que vous sélectionnez, jusqu’à la saisie du PIN.</translation>
    </message>
</context>
<context>
    <name>nmc::PacketModel</name>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Sent to</source>
        <translation>Envoyé à</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>But</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
</context>
<context>
    <name>nmc::PacketMonitor</name>
    <message>
        <source>Packet monitor</source>
        <translation>Moniteur de trames</translation>
    </message>
    <message>
        <source>Filter packets by module</source>
        <translation>Filtrer les trames par module</translation>
    </message>
    <message>
        <source>Shows only packets of one module (Ctrl+M).</source>
        <translation>N’affiche que les trames d’un module (Ctrl+M).</translation>
    </message>
    <message>
        <source>Filter packets by kind</source>
        <translation>Filtrer les trames par type</translation>
    </message>
    <message>
        <source>Shows only packets of one kind (Ctrl+T).</source>
        <translation>N’affiche que les trames d’un type (Ctrl+T).</translation>
    </message>
    <message>
        <source>Polls</source>
        <translation>Scrutations</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Arrêts</translation>
    </message>
    <message>
        <source>Connecting and link</source>
        <translation>Connexion et liaison</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Erreurs seulement</translation>
    </message>
    <message>
        <source>Stops recording; packets shown stay (%1).</source>
        <translation>Suspend l’enregistrement&#x202f;; les trames affichées restent (%1).</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Clears the packets shown (%1).</source>
        <translation>Efface les trames affichées (%1).</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copies the selected rows as text, or all rows if none is selected (%1).</source>
        <translation>Copie les lignes sélectionnées en texte, ou toutes les lignes si aucune n’est sélectionnée (%1).</translation>
    </message>
    <message>
        <source>Saves all recorded packets as text, or as a log that can be replayed (%1).</source>
        <translation>Enregistre toutes les trames en texte, ou en journal rejouable (%1).</translation>
    </message>
    <message>
        <source>Packets and counters</source>
        <translation>Trames et compteurs</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Trames</translation>
    </message>
    <message>
        <source>Counters</source>
        <translation>Compteurs</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Save packets</source>
        <translation>Enregistrer les trames</translation>
    </message>
    <message>
        <source>Replayable log (*%1)</source>
        <translation>Journal rejouable (*%1)</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 sur %2 affichées</translation>
    </message>
    <message>
        <source>%1, %2 older dropped</source>
        <translation>%1, %2 plus anciennes supprimées</translation>
    </message>
    <message>
        <source>%1, paused</source>
        <translation>%1, en pause</translation>
    </message>
</context>
<context>
    <name>nmc::PacketView</name>
    <message>
        <source>Packets, newest last</source>
        <translation>Trames, les plus récentes en dernier</translation>
    </message>
    <message>
        <source>No packets. Exchanges are recorded while this view is visible.</source>
        <translation>Aucune trame. Les échanges sont enregistrés tant que cette vue est visible.</translation>
    </message>
    <message>
        <source>No packets match the filter.</source>
        <translation>Aucune trame ne correspond au filtre.</translation>
    </message>
</context>
<context>
    <name>nmc::PanelHead</name>
    <message>
        <source>&amp;Enable servo</source>
        <translation>Activ&amp;er le servo</translation>
    </message>
    <message>
        <source>Enable servo of this module</source>
        <translation>Activer le servo de ce module</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Arrê&amp;t</translation>
    </message>
    <message>
        <source>Stop this module smoothly</source>
        <translation>Arrêt progressif de ce module</translation>
    </message>
    <message>
        <source>Stop a&amp;bruptly</source>
        <translation>Arrêt &amp;brutal</translation>
    </message>
    <message>
        <source>Stop abruptly: this module</source>
        <translation>Arrêt brutal&#xa0;: ce module</translation>
    </message>
    <message>
        <source>&amp;Motor off</source>
        <translation>Couper &amp;le moteur</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Position inconnue</translation>
    </message>
    <message>
        <source>The servo is already on.</source>
        <translation>Le servo est déjà actif.</translation>
    </message>
    <message>
        <source>Switches the amplifier on and holds the motor in place.</source>
        <translation>Active l’amplificateur et maintient le moteur en place.</translation>
    </message>
    <message>
        <source>Slows down with the present acceleration, then holds.</source>
        <translation>Ralentit le moteur avec l’accélération actuelle, puis maintient la position.</translation>
    </message>
    <message>
        <source>Stops at once, then holds.</source>
        <translation>Arrête le moteur immédiatement, puis maintient la position.</translation>
    </message>
    <message>
        <source>&amp;Enable amplifier</source>
        <translation>Activ&amp;er l’amplificateur</translation>
    </message>
    <message>
        <source>Enable amplifier of this module</source>
        <translation>Activer l’amplificateur de ce module</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Arrêt ici</translation>
    </message>
    <message>
        <source>Stop here: hold this module at its present position</source>
        <translation>Arrêt ici&#xa0;: maintenir ce module à sa position actuelle</translation>
    </message>
    <message>
        <source>Position %1 %2</source>
        <translation>Position %1 %2</translation>
    </message>
    <message>
        <source>The amplifier is already on.</source>
        <translation>L’amplificateur est déjà actif.</translation>
    </message>
    <message>
        <source>Stops at once and switches the amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Arrête le moteur immédiatement et coupe l’amplificateur&#xa0;: le moteur peut tourner librement, et une charge peut tomber.</translation>
    </message>
    <message>
        <source>Task running on this module</source>
        <translation>Tâche en cours sur ce module</translation>
    </message>
    <message>
        <source>Measured velocity</source>
        <translation>Vitesse mesurée</translation>
    </message>
    <message>
        <source>Velocity measured from positions over 0.2 s.</source>
        <translation>Vitesse mesurée à partir des positions sur 0,2&#xa0;s.</translation>
    </message>
    <message>
        <source>Motor power as sensed by the module.</source>
        <translation>Alimentation moteur telle que le module la détecte.</translation>
    </message>
    <message>
        <source>Limit %1 –</source>
        <translation>FdC %1 –</translation>
    </message>
    <message>
        <source>Limit %1 high</source>
        <translation>FdC %1 haut</translation>
    </message>
    <message>
        <source>Limit %1 low</source>
        <translation>FdC %1 bas</translation>
    </message>
    <message>
        <source>Power –</source>
        <translation>Alimentation –</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Alimentation</translation>
    </message>
    <message>
        <source>No power</source>
        <translation>Non alimenté</translation>
    </message>
    <message>
        <source>Current was limited: %1</source>
        <translation>Courant limité&#xa0;: %1</translation>
    </message>
    <message>
        <source>Current %1</source>
        <translation>Courant %1</translation>
    </message>
    <message>
        <source>● Limit stop armed</source>
        <translation>● Arrêt sur fin de course armé</translation>
    </message>
    <message>
        <source>▲ Limit stop tripped</source>
        <translation>▲ Arrêt sur fin de course déclenché</translation>
    </message>
    <message>
        <source>In motion, stops at once, as Stop abruptly does. At rest, holds the position that the motor has at this moment, without a profile.</source>
        <translation>En mouvement, arrête le moteur immédiatement, comme l’arrêt brutal. À l’arrêt, maintient sans profil la position que le moteur a à cet instant.</translation>
    </message>
    <message>
        <source>Travel limits</source>
        <translation>Limites de course</translation>
    </message>
    <message>
        <source>Switches the amplifier on, holds the motor in place and clears the sticky bits: the position error bit is set while the servo is off.</source>
        <translation>Active l’amplificateur, maintient le moteur en place et efface les bits mémorisés&#xa0;: le bit d’erreur de position est à 1 tant que le servo est coupé.</translation>
    </message>
    <message>
        <source>Looking for modules… This is the last known state.</source>
        <translation>Recherche des modules… Voici ce qu’il a indiqué en dernier.</translation>
    </message>
    <message>
        <source>Driven by a test</source>
        <translation>Entraîné par un essai</translation>
    </message>
    <message>
        <source>The test moves the motor around the position that it held.</source>
        <translation>L’essai déplace le moteur autour de la position qu’il maintenait.</translation>
    </message>
    <message>
        <source>Limit switch 1: high blocks the way to it.</source>
        <translation>Fin de course 1&#xa0;: l’état haut bloque la marche vers lui.</translation>
    </message>
    <message>
        <source>Limit switch 2: high blocks the way to it.</source>
        <translation>Fin de course 2&#xa0;: l’état haut bloque la marche vers lui.</translation>
    </message>
    <message>
        <source>counter: %1</source>
        <translation>compteur&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1&#xa0;: inconnu</translation>
    </message>
</context>
<context>
    <name>nmc::PathPlot</name>
    <message>
        <source>Positions of the path over time</source>
        <translation>Positions de la trajectoire en fonction du temps</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>No path. Open a file, or draw one from a sequence.</source>
        <translation>Aucune trajectoire. Ouvrez un fichier, ou générez-en une d’après une séquence.</translation>
    </message>
</context>
<context>
    <name>nmc::PathsPage</name>
    <message>
        <source>Paths</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Choice of a path</source>
        <translation>Choix d’une trajectoire</translation>
    </message>
    <message>
        <source>Open path…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open path… from a CSV file</source>
        <translation>Ouvrir… une trajectoire depuis un fichier CSV</translation>
    </message>
    <message>
        <source>Save path…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Save path… as a CSV file</source>
        <translation>Enregistrer… la trajectoire dans un fichier CSV</translation>
    </message>
    <message>
        <source>Sequence to draw a path from</source>
        <translation>Séquence d’après laquelle générer une trajectoire</translation>
    </message>
    <message>
        <source>Rate of the path to draw</source>
        <translation>Fréquence de la trajectoire à générer</translation>
    </message>
    <message>
        <source>Draw path</source>
        <translation>Générer</translation>
    </message>
    <message>
        <source>Draw path from the moves of a sequence</source>
        <translation>Générer la trajectoire d’après les déplacements d’une séquence</translation>
    </message>
    <message>
        <source>The path</source>
        <translation>La trajectoire</translation>
    </message>
    <message>
        <source>Running the path</source>
        <translation>Exécution de la trajectoire</translation>
    </message>
    <message>
        <source>Move to start</source>
        <translation>Aller au départ</translation>
    </message>
    <message>
        <source>Move to start: to the first point of the path</source>
        <translation>Aller au départ&#xa0;: au premier point de la trajectoire</translation>
    </message>
    <message>
        <source>Run path</source>
        <translation>Exécuter</translation>
    </message>
    <message>
        <source>Run path, with confirmation</source>
        <translation>Exécuter la trajectoire après confirmation</translation>
    </message>
    <message>
        <source>Stop path</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop path: all its axes slow down</source>
        <translation>Arrêter la trajectoire&#xa0;: tous ses axes décélèrent</translation>
    </message>
    <message>
        <source>Progress of the path</source>
        <translation>Progression de la trajectoire</translation>
    </message>
    <message>
        <source>State of the path</source>
        <translation>État de la trajectoire</translation>
    </message>
    <message>
        <source>Paths need a PIC-SERVO CMC or SC. This chain has none.</source>
        <translation>Les trajectoires exigent un PIC-SERVO CMC ou SC. Cette chaîne n’en a pas.</translation>
    </message>
    <message>
        <source>A path is running.</source>
        <translation>Une trajectoire est en cours.</translation>
    </message>
    <message>
        <source>Open or draw a path first.</source>
        <translation>Ouvrez ou générez d’abord une trajectoire.</translation>
    </message>
    <message>
        <source>A sequence or a move to a point is running.</source>
        <translation>Une séquence ou un déplacement vers un point est en cours.</translation>
    </message>
    <message>
        <source>The unit of an axis has changed. Open or draw the path again.</source>
        <translation>L’unité d’un axe a changé. Rouvrez la trajectoire, ou générez-la de nouveau.</translation>
    </message>
    <message>
        <source>The counter or the home of an axis has changed. Draw the path again.</source>
        <translation>Le compteur ou l’origine d’un axe a changé. Générez de nouveau la trajectoire.</translation>
    </message>
    <message>
        <source>%1 is not a path for this chain:</source>
        <translation>%1 n’est pas une trajectoire pour cette chaîne&#xa0;:</translation>
    </message>
    <message>
        <source>There may be more problems after these.</source>
        <translation>D’autres problèmes peuvent suivre.</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>Lecture du fichier…</translation>
    </message>
    <message>
        <source>Reads positions for each point from a CSV file. Nothing moves.</source>
        <translation>Lit les positions de chaque point dans un fichier CSV. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Saves the path as CSV, with its positions in the units of the axes.</source>
        <translation>Enregistre la trajectoire en CSV, avec ses positions dans les unités des axes.</translation>
    </message>
    <message>
        <source>Create a sequence of moves first (F3).</source>
        <translation>Créez d’abord une séquence de déplacements (F3).</translation>
    </message>
    <message>
        <source>Turns the moves of this sequence into one motion without stops. Nothing moves.</source>
        <translation>Convertit les déplacements de cette séquence en un seul mouvement sans arrêt. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Moves each axis of the path to its first point.</source>
        <translation>Déplace chaque axe de la trajectoire vers son premier point.</translation>
    </message>
    <message>
        <source>Runs all axes through the path. Asks first.</source>
        <translation>Fait parcourir la trajectoire à tous les axes, après confirmation.</translation>
    </message>
    <message>
        <source>No path is running.</source>
        <translation>Aucune trajectoire n’est en cours.</translation>
    </message>
    <message>
        <source>Stops all axes of the path; they hold where they stop.</source>
        <translation>Arrête tous les axes de la trajectoire&#x202f;; ils maintiennent leur position là où ils s’arrêtent.</translation>
    </message>
    <message>
        <source>A path file has a column for each axis. Axes here: %1.</source>
        <translation>Un fichier de trajectoire a une colonne par axe. Axes de cette chaîne&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Open a path</source>
        <translation>Ouvrir une trajectoire</translation>
    </message>
    <message>
        <source>Save the path</source>
        <translation>Enregistrer la trajectoire</translation>
    </message>
    <message>
        <source>Start of the path</source>
        <translation>Départ de la trajectoire</translation>
    </message>
    <message>
        <source>All axes of the path start to move. Make sure that nothing is in their way.</source>
        <translation>Tous les axes de la trajectoire se mettent en mouvement. Assurez-vous que rien ne gêne leur course.</translation>
    </message>
    <message>
        <source>Run the path</source>
        <translation>Exécuter la trajectoire</translation>
    </message>
    <message>
        <source>&amp;Run path</source>
        <translation>&amp;Exécuter la trajectoire</translation>
    </message>
</context>
<context>
    <name>nmc::Pendant</name>
    <message>
        <source>Pendant: &amp;keyboard, gamepad or jog wheel</source>
        <translation>Pupitre&#xa0;: &amp;clavier, manette ou molette</translation>
    </message>
    <message>
        <source>To move the motor, hold Shift with an arrow key, or a shoulder button of a gamepad with its left stick or D-pad, or a button of a jog wheel with its ring or wheel. B (○) of the gamepad and the middle button of the wheel are STOP ALL. (F12)</source>
        <translation>Pour déplacer le moteur, maintenez Maj avec une touche fléchée, une gâchette supérieure de la manette avec son stick gauche ou sa croix, ou un bouton d’une molette avec sa bague ou sa roue. B (○) de la manette et le bouton du milieu de la molette sont TOUT ARRÊTER. (F12)</translation>
    </message>
</context>
<context>
    <name>nmc::PinBox</name>
    <message>
        <source>Make all pins inputs</source>
        <translation>Mettre toutes les broches en entrée</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Broche</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Ask first</source>
        <translation>Confirmer</translation>
    </message>
    <message>
        <source>output</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>Sens de %1</translation>
    </message>
    <message>
        <source>high: output %1</source>
        <translation>haut&#xa0;: sortie %1</translation>
    </message>
    <message>
        <source>Ask first before %1 changes</source>
        <translation>Confirmer avant de changer %1</translation>
    </message>
    <message>
        <source>Asks before the panel switches this output.</source>
        <translation>Demande confirmation avant que le programme commute cette sortie.</translation>
    </message>
    <message>
        <source>Take %1 low on STOP ALL</source>
        <translation>Mettre %1 à l’état bas par TOUT ARRÊTER</translation>
    </message>
    <message>
        <source>STOP ALL takes this output low. If cleared, the output stays as it is.</source>
        <translation>TOUT ARRÊTER met cette sortie à l’état bas. Si la case est décochée, la sortie reste telle quelle.</translation>
    </message>
    <message>
        <source>Switch %1 on?</source>
        <translation>Activer %1&#x202f;?</translation>
    </message>
    <message>
        <source>Switch %1 off?</source>
        <translation>Désactiver %1&#x202f;?</translation>
    </message>
    <message>
        <source>&amp;Switch on</source>
        <translation>&amp;Activer</translation>
    </message>
    <message>
        <source>&amp;Switch off</source>
        <translation>&amp;Désactiver</translation>
    </message>
    <message>
        <source>Makes all twelve pins inputs: outputs release what they drive.</source>
        <translation>Met les douze broches en entrée&#xa0;: les sorties relâchent ce qu’elles pilotent.</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Make all pins inputs to start over.</source>
        <translation>Un autre programme a configuré ce module&#xa0;: le sens de ses broches est inconnu. Mettez toutes les broches en entrée pour repartir de zéro.</translation>
    </message>
    <message>
        <source>Pin directions unknown. Make all pins inputs first.</source>
        <translation>Sens des broches inconnu. Mettez d’abord toutes les broches en entrée.</translation>
    </message>
    <message>
        <source>Input: the module reads this pin. Output: it drives this pin.</source>
        <translation>Entrée&#xa0;: le module lit cette broche. Sortie&#xa0;: il la pilote.</translation>
    </message>
    <message>
        <source>high, set low</source>
        <translation>haut, réglé bas</translation>
    </message>
    <message>
        <source>low, set high</source>
        <translation>bas, réglé haut</translation>
    </message>
    <message>
        <source>This pin is an input.</source>
        <translation>Cette broche est une entrée.</translation>
    </message>
    <message>
        <source>Pin directions unknown.</source>
        <translation>Sens des broches inconnu.</translation>
    </message>
</context>
<context>
    <name>nmc::PointsModel</name>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
</context>
<context>
    <name>nmc::PrintDialog</name>
    <message>
        <source>&amp;Print</source>
        <translation>Im&amp;primer</translation>
    </message>
    <message>
        <source>Save as P&amp;DF…</source>
        <translation>Enregistrer en P&amp;DF…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimer</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Imprimante</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Exemplaires</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>Imprimantes</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Saves the page as a file that any computer can print.</source>
        <translation>Enregistre la page dans un fichier que tout ordinateur peut imprimer.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>P&amp;rinter</source>
        <translation>Imp&amp;rimante</translation>
    </message>
    <message>
        <source>C&amp;opies</source>
        <translation>&amp;Exemplaires</translation>
    </message>
    <message>
        <source>The printer to use. It is preselected next time.</source>
        <translation>L’imprimante à utiliser&#xa0;; elle sera proposée de nouveau la prochaine fois.</translation>
    </message>
    <message>
        <source>Sends the page to this printer.</source>
        <translation>Envoie la page à cette imprimante.</translation>
    </message>
    <message>
        <source>Save the page</source>
        <translation>Enregistrer la page</translation>
    </message>
    <message>
        <source>page</source>
        <translation>page</translation>
    </message>
</context>
<context>
    <name>nmc::PwmBox</name>
    <message>
        <source>Drive reverse</source>
        <translation>Piloter en arrière</translation>
    </message>
    <message>
        <source>Drive forward</source>
        <translation>Piloter en avant</translation>
    </message>
    <message>
        <source>The PWM value</source>
        <translation>La valeur PWM</translation>
    </message>
    <message>
        <source>The share of the supply that drives the motor; 255 is full power.</source>
        <translation>Part de l’alimentation qui entraîne le moteur&#x202f;; 255 est la pleine puissance.</translation>
    </message>
    <message>
        <source>Drive reverse with this PWM value</source>
        <translation>Piloter en arrière avec cette valeur PWM</translation>
    </message>
    <message>
        <source>Drive forward with this PWM value</source>
        <translation>Piloter en avant avec cette valeur PWM</translation>
    </message>
    <message>
        <source>PWM drives the motor directly, without the servo. No position, position error or output limit protects it, and it runs until you switch it off.</source>
        <translation>La PWM entraîne le moteur directement, sans le servo. Aucune limite de position, d’erreur de position ou de sortie ne le protège, et il tourne jusqu’à ce que vous le coupiez.</translation>
    </message>
    <message>
        <source>= %1 %</source>
        <translation>= %1&#x202f;%</translation>
    </message>
    <message>
        <source>Drives the motor in reverse until you switch it off.</source>
        <translation>Entraîne le moteur en arrière jusqu’à ce que vous le coupiez.</translation>
    </message>
    <message>
        <source>Drives the motor forward until you switch it off.</source>
        <translation>Entraîne le moteur en avant jusqu’à ce que vous le coupiez.</translation>
    </message>
</context>
<context>
    <name>nmc::RatePage</name>
    <message>
        <source>&amp;Change baud rate</source>
        <translation>&amp;Changer de débit</translation>
    </message>
    <message>
        <source>New baud rate of the chain</source>
        <translation>Nouveau débit de la chaîne</translation>
    </message>
    <message>
        <source>The new baud rate of the whole chain.</source>
        <translation>Nouveau débit de toute la chaîne.</translation>
    </message>
    <message>
        <source>Change baud rate of the whole chain</source>
        <translation>Changer de débit&#xa0;: toute la chaîne</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1&#xa0;Bd</translation>
    </message>
    <message>
        <source>Positions, gains and groups are kept. The panel checks every module at the new baud rate; if one does not answer, all modules go back to the old rate.</source>
        <translation>Positions, gains et groupes sont conservés. Le programme vérifie chaque module au nouveau débit&#x202f;; si l’un ne répond pas, tous les modules reviennent à l’ancien débit.</translation>
    </message>
    <message>
        <source>The chain runs at %1 Bd.</source>
        <translation>La chaîne fonctionne à %1&#xa0;Bd.</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change the baud rate.</source>
        <translation>Un moteur est en mouvement. Arrêtez tous les moteurs pour changer de débit.</translation>
    </message>
    <message>
        <source>The chain already runs at this baud rate.</source>
        <translation>La chaîne fonctionne déjà à ce débit.</translation>
    </message>
    <message>
        <source>Sends the new baud rate to every module, then checks each one.</source>
        <translation>Envoie le nouveau débit à chaque module, puis vérifie chacun.</translation>
    </message>
    <message>
        <source>Modules that do not answer would stay at the old baud rate: %1.</source>
        <translation>Les modules qui ne répondent pas resteraient à l’ancien débit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Modules with an unknown group may miss the change: %1. Set their group on the Groups page, or none.</source>
        <translation>Les modules dont le groupe est inconnu peuvent manquer le changement&#xa0;: %1. Définissez leur groupe sur la page Groupes, ou aucun.</translation>
    </message>
    <message>
        <source>Group leaders would answer during the change. Make these ordinary members on the Groups page: %1.</source>
        <translation>Les meneurs de groupe répondraient pendant le changement. Faites-en des membres ordinaires sur la page Groupes&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Autre…</translation>
    </message>
    <message>
        <source>Divisor of Set Baud Rate</source>
        <translation>Diviseur de Set Baud Rate</translation>
    </message>
    <message>
        <source>The baud rate is 1 250 000 Bd / (divisor + 1). The panel first checks that this computer&apos;s port supports it to within 2 %.</source>
        <translation>Le débit est de 1&#x202f;250&#x202f;000&#xa0;Bd / (diviseur + 1). Le programme vérifie d’abord que le port de cet ordinateur le permet à 2&#x202f;% près.</translation>
    </message>
    <message>
        <source>= %1 Bd</source>
        <translation>= %1&#xa0;Bd</translation>
    </message>
    <message>
        <source>The divisor</source>
        <translation>Le diviseur</translation>
    </message>
</context>
<context>
    <name>nmc::RepeatabilityBox</name>
    <message>
        <source>Repeatability and backlash</source>
        <translation>Répétabilité et jeu mécanique</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Measure repeatability and backlash</source>
        <translation>Mesurer la répétabilité et le jeu mécanique</translation>
    </message>
    <message>
        <source>Cancel measuring the repeatability</source>
        <translation>Annuler la mesure de répétabilité</translation>
    </message>
    <message>
        <source>Use as backlash</source>
        <translation>Utiliser comme jeu</translation>
    </message>
    <message>
        <source>Use as backlash of the axis</source>
        <translation>Utiliser comme jeu de l’axe</translation>
    </message>
    <message>
        <source>Result of the repeatability measurement</source>
        <translation>Résultat de la mesure de répétabilité</translation>
    </message>
    <message>
        <source>Approach this input</source>
        <translation>Approcher cette entrée</translation>
    </message>
    <message>
        <source>The motor approaches it from both sides. Direction, acceleration, search distance and time limit are those of the search for home.</source>
        <translation>Le moteur l’approche des deux côtés. Le sens, l’accélération, la course de recherche et le délai sont ceux de la recherche d’origine.</translation>
    </message>
    <message>
        <source>Velocity of the approach</source>
        <translation>Vitesse d’approche</translation>
    </message>
    <message>
        <source>Slower is more exact: the chip may read its inputs only once per servo tick.</source>
        <translation>Plus lent est plus exact&#xa0;: la puce ne lit peut-être ses entrées qu’une fois par période d’asservissement.</translation>
    </message>
    <message>
        <source>Times from each side</source>
        <translation>Nombre de chaque côté</translation>
    </message>
    <message>
        <source>Number of approaches from each side.</source>
        <translation>Nombre d’approches de chaque côté.</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Approcher</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>from each side</source>
        <translation>de chaque côté</translation>
    </message>
    <message>
        <source>The measurement is running.</source>
        <translation>La mesure est en cours.</translation>
    </message>
    <message>
        <source>Measure first.</source>
        <translation>Mesurez d’abord.</translation>
    </message>
    <message>
        <source>An index does not show the backlash of the load.</source>
        <translation>Un index ne montre pas le jeu de la charge.</translation>
    </message>
    <message>
        <source>No backlash was found that exceeds its uncertainty.</source>
        <translation>Aucun jeu supérieur à son incertitude n’a été trouvé.</translation>
    </message>
    <message>
        <source>The axis has this backlash.</source>
        <translation>L’axe a déjà ce jeu.</translation>
    </message>
    <message>
        <source>Not measured in this connection.</source>
        <translation>Pas mesuré pendant cette connexion.</translation>
    </message>
    <message>
        <source>Forward, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>Avant, %4 fois&#xa0;: moyenne %1, écart type %2, étendue %3</translation>
    </message>
    <message>
        <source>Reverse, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>Arrière, %4 fois&#xa0;: moyenne %1, écart type %2, étendue %3</translation>
    </message>
    <message>
        <source>Difference: %1 ± %2</source>
        <translation>Différence&#xa0;: %1 ± %2</translation>
    </message>
    <message>
        <source>Backlash: %1 ± %2</source>
        <translation>Jeu&#xa0;: %1 ± %2</translation>
    </message>
    <message>
        <source>The index is on the encoder&apos;s own shaft: this shows how well a capture repeats, not the backlash of the load.</source>
        <translation>L’index est sur l’arbre du codeur&#xa0;: cela montre la répétabilité d’une capture, pas le jeu de la charge.</translation>
    </message>
    <message>
        <source>Below zero, so this is not backlash. The switch may bounce.</source>
        <translation>Inférieur à zéro&#xa0;: ce n’est donc pas du jeu. Le capteur rebondit peut-être.</translation>
    </message>
    <message>
        <source>Includes the hysteresis of the switch itself. Only with the encoder on the motor and the switch on the load does it show the backlash between them.</source>
        <translation>Comprend l’hystérésis du capteur lui-même. Seulement avec le codeur sur le moteur et le capteur sur la charge, cela montre le jeu entre les deux.</translation>
    </message>
    <message>
        <source>The motor moves up to %1 between two readings of the inputs. Measure more slowly.</source>
        <translation>Le moteur se déplace jusqu’à %1 entre deux lectures des entrées par la puce. Mesurez plus lentement.</translation>
    </message>
    <message>
        <source>Moves the motor to and fro across the switch or index, and reads where it was captured.</source>
        <translation>Fait passer le moteur dans les deux sens sur le capteur ou l’index, et lit où il a été capturé.</translation>
    </message>
    <message>
        <source>No measurement is running.</source>
        <translation>Aucune mesure n’est en cours.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly; what was captured stays.</source>
        <translation>Arrête le moteur en douceur&#xa0;; ce qui a été capturé reste.</translation>
    </message>
    <message>
        <source>Makes %1 the backlash of the axis (Axis page): what was measured, with its uncertainty. Sends nothing.</source>
        <translation>Fait de %1 le jeu de l’axe (page Axe)&#xa0;: la valeur mesurée, avec son incertitude. N’envoie rien.</translation>
    </message>
</context>
<context>
    <name>nmc::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>Nothing is sent. Read the report below, save it, and attach the file where you describe the problem. It contains neither your PIN nor the name of your home folder.</source>
        <translation>Rien n’est envoyé. Lisez le rapport ci-dessous, enregistrez-le et joignez le fichier là où vous décrivez le problème. Il ne contient ni votre PIN ni le nom de votre dossier personnel.</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>Texte du rapport</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Enregistrer sous…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseForm</name>
    <message>
        <source>Settings of the next step</source>
        <translation>Réglages du prochain échelon</translation>
    </message>
    <message>
        <source>Distance of the step response</source>
        <translation>Distance de la réponse indicielle</translation>
    </message>
    <message>
        <source>The distance of the step</source>
        <translation>La distance de l’échelon</translation>
    </message>
    <message>
        <source>The record</source>
        <translation>L’enregistrement</translation>
    </message>
    <message>
        <source>The settling band</source>
        <translation>La bande de tolérance</translation>
    </message>
    <message>
        <source>% of the step</source>
        <translation>% de l’échelon</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal. At least one count. Applies to all runs.</source>
        <translation>La réponse est établie quand le moteur reste aussi proche de sa cible. Au moins un incrément. S’applique à tous les relevés.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Settling band</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
    <message>
        <source>Step and record</source>
        <translation>Échelon et enregistrement</translation>
    </message>
    <message>
        <source>The motor jumps by this distance, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>Le moteur saute de cette distance, puis maintient sa position. Assurez-vous que tout ce qu’il entraîne peut bouger librement (Maj+F9).</translation>
    </message>
    <message>
        <source>%1 %2 instead of %3</source>
        <translation>%1 %2 au lieu de %3</translation>
    </message>
    <message>
        <source>Some gains in the fields were not sent: %1. Which gains should the step use?</source>
        <translation>Certains gains des champs n’ont pas été envoyés&#xa0;: %1. Avec quels gains faire l’échelon&#x202f;?</translation>
    </message>
    <message>
        <source>Gains not sent</source>
        <translation>Gains non envoyés</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>&amp;Apply and step</source>
        <translation>&amp;Appliquer et faire l’échelon</translation>
    </message>
    <message>
        <source>Step with &amp;present gains</source>
        <translation>Échelon avec les gains actue&amp;ls</translation>
    </message>
    <message>
        <source>How far the command goes; negative: reverse. Small steps show the tuning of the servo, large ones the limits of the amplifier.</source>
        <translation>Distance de la consigne&#xa0;; négative&#xa0;: en arrière. De petits échelons montrent le réglage de l’asservissement, de grands les limites de l’amplificateur.</translation>
    </message>
    <message>
        <source>How long to record after the step, or after the end of a move. Then the motor is commanded to hold.</source>
        <translation>Durée d’enregistrement après l’échelon ou après la fin d’un mouvement. Ensuite le moteur est maintenu.</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>Vitesse du mouvement</translation>
    </message>
    <message>
        <source>Acceleration of the move</source>
        <translation>Accélération du mouvement</translation>
    </message>
    <message>
        <source>Moves there and back</source>
        <translation>Mouvements aller et retour</translation>
    </message>
    <message>
        <source>How often it moves there and back. Each move is recorded.</source>
        <translation>Nombre d’allers et retours. Chaque mouvement est enregistré.</translation>
    </message>
    <message>
        <source>Settling window</source>
        <translation>Fenêtre d’établissement</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal for the dwell. At least one count. Applies to all moves.</source>
        <translation>Le moteur est établi lorsqu’il reste aussi près de sa cible pendant le temps de maintien. Au moins un incrément. S’applique à tous les mouvements.</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Maintien</translation>
    </message>
    <message>
        <source>How long it must stay in the window. The settling time ends where the dwell begins.</source>
        <translation>Durée pendant laquelle il doit rester dans la fenêtre. Le temps d’établissement finit où le maintien commence.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Aller et retour</translation>
    </message>
    <message>
        <source>A step or move is already running.</source>
        <translation>Un échelon ou un mouvement est déjà en cours.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Move and record</source>
        <translation>Déplacer et enregistrer</translation>
    </message>
    <message>
        <source>The motor moves there and back, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>Le moteur va et revient, puis se maintient. Assurez-vous que tout ce qu’il entraîne peut bouger librement (Maj+F9).</translation>
    </message>
    <message>
        <source>The velocity of the move. Until you type one, it is that of moves to a position.</source>
        <translation>La vitesse du mouvement. Tant que vous n’en saisissez pas, c’est celle des mouvements vers une position.</translation>
    </message>
    <message>
        <source>The acceleration of the move. Until you type one, it is that of moves to a position.</source>
        <translation>L’accélération du mouvement. Tant que vous n’en saisissez pas, c’est celle des mouvements vers une position.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePage</name>
    <message>
        <source>Use these gains</source>
        <translation>Utiliser ces gains</translation>
    </message>
    <message>
        <source>Select a run in the list first.</source>
        <translation>Sélectionnez d’abord un relevé dans la liste.</translation>
    </message>
    <message>
        <source>This run belongs to %1. Select that module first.</source>
        <translation>Ce relevé appartient à %1. Sélectionnez d’abord ce module.</translation>
    </message>
    <message>
        <source>Copies the gains of this run to the Gains page. Sends nothing (Ctrl+Shift+U).</source>
        <translation>Copie les gains de ce relevé dans la page Gains. N’envoie rien (Ctrl+Maj+U).</translation>
    </message>
    <message>
        <source>Removes this run from the list (Ctrl+Del).</source>
        <translation>Supprime ce relevé de la liste (Ctrl+Suppr).</translation>
    </message>
    <message>
        <source>No run yet. Record a step first.</source>
        <translation>Pas encore de relevé. Enregistrez d’abord un échelon.</translation>
    </message>
    <message>
        <source>Saves all runs in the list with their gains and results (Ctrl+Shift+X).</source>
        <translation>Enregistre tous les relevés de la liste avec leurs gains et résultats (Ctrl+Maj+X).</translation>
    </message>
    <message>
        <source>Export step responses</source>
        <translation>Exporter les réponses indicielles</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
    <message>
        <source>Step results</source>
        <translation>Résultats des échelons</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Tous les relevés</translation>
    </message>
    <message>
        <source>All runs of this module in the plot</source>
        <translation>Tous les relevés de ce module dans le graphique</translation>
    </message>
    <message>
        <source>Shows the other runs of this module, older runs paler.</source>
        <translation>Affiche les autres relevés de ce module, les plus anciens en plus pâle.</translation>
    </message>
    <message>
        <source>No run was removed.</source>
        <translation>Aucun relevé n’a été supprimé.</translation>
    </message>
    <message>
        <source>Restores the run removed last (Ctrl+Shift+Del).</source>
        <translation>Rétablit le dernier relevé supprimé (Ctrl+Maj+Suppr).</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePlot</name>
    <message>
        <source>Step responses over time</source>
        <translation>Réponses indicielles dans le temps</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>relevé %1, %2</translation>
    </message>
    <message>
        <source>A: %1</source>
        <translation>A&#xa0;: %1</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B&#xa0;: %1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>No run selected. A step response shows how the motor follows a jump of its command.</source>
        <translation>Aucun relevé sélectionné. Une réponse indicielle montre comment le moteur suit un saut de sa consigne.</translation>
    </message>
    <message>
        <source>motor model</source>
        <translation>modèle du moteur</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prédit</translation>
    </message>
    <message>
        <source>Positions since the step, relative to its start. The shaded band is the settling band around the goal. Double-click to switch between the whole record and the motion. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>Positions depuis l’échelon, par rapport à son départ. La zone grisée est la bande de tolérance autour de la cible. Double-cliquez pour basculer entre l’enregistrement entier et le mouvement. La molette zoome le temps, ou les positions avec Ctrl&#x202f;; faites glisser pour déplacer la vue&#x202f;; faites glisser avec Maj pour sélectionner une durée.</translation>
    </message>
    <message>
        <source>time since the step (s)</source>
        <translation>temps depuis l’échelon (s)</translation>
    </message>
    <message>
        <source>position from the start</source>
        <translation>position depuis le départ</translation>
    </message>
    <message>
        <source>position from the start (%1)</source>
        <translation>position depuis le départ (%1)</translation>
    </message>
    <message>
        <source>goal, command</source>
        <translation>cible, consigne</translation>
    </message>
    <message>
        <source>time since the start (s)</source>
        <translation>temps depuis le départ (s)</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseResults</name>
    <message>
        <source>Results of the runs shown</source>
        <translation>Résultats des relevés affichés</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Relevé</translation>
    </message>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Montée, 10 à 90&#x202f;%</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>Erreur statique</translation>
    </message>
    <message>
        <source>Peak PWM, of 255</source>
        <translation>PWM max., sur 255</translation>
    </message>
    <message>
        <source>Sample interval</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>Time from 10 % to 90 % of the step.</source>
        <translation>Temps de 10&#x202f;% à 90&#x202f;% de l’échelon.</translation>
    </message>
    <message>
        <source>How far the motor went past its goal, in % of the step.</source>
        <translation>De combien le moteur a dépassé sa cible, en&#x202f;% de l’échelon.</translation>
    </message>
    <message>
        <source>Goal minus the mean position over the last fifth of the record.</source>
        <translation>Cible moins position moyenne sur le dernier cinquième de l’enregistrement.</translation>
    </message>
    <message>
        <source>PWM demand at the jump, calculated from the gains. Later ticks may need more: below the output limit OL this is a lower bound.</source>
        <translation>PWM demandée lors du saut, calculée d’après les gains. Les cycles suivants peuvent en demander plus&#xa0;: en dessous de la limite de sortie OL, c’est une borne inférieure.</translation>
    </message>
    <message>
        <source>Mean time between two positions of the record. It sets the accuracy of the results.</source>
        <translation>Temps moyen entre deux positions de l’enregistrement. Il détermine la précision des résultats.</translation>
    </message>
    <message>
        <source>Settling to the goal</source>
        <translation>Établissement à la cible</translation>
    </message>
    <message>
        <source>Settling to rest position</source>
        <translation>Établissement au repos</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the goal. Empty if that happens only in the last fifth of the record.</source>
        <translation>Temps jusqu’à ce que la position reste dans la bande de tolérance autour de la cible. Vide si cela n’arrive que dans le dernier cinquième de l’enregistrement.</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the mean position of the last fifth of the record. Without integral gain (Ki, IL), friction holds a motor off its goal.</source>
        <translation>De même, autour de la position moyenne du dernier cinquième de l’enregistrement. Sans gain intégral (Ki, IL), le frottement retient le moteur à l’écart de sa cible.</translation>
    </message>
    <message>
        <source>Move time</source>
        <translation>Durée du mouvement</translation>
    </message>
    <message>
        <source>Settling after the move</source>
        <translation>Établissement après le mouvement</translation>
    </message>
    <message>
        <source>Settling, all moves</source>
        <translation>Établissement, tous</translation>
    </message>
    <message>
        <source>Peak error</source>
        <translation>Erreur maximale</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>Erreur efficace</translation>
    </message>
    <message>
        <source>Error at constant velocity</source>
        <translation>Erreur à vitesse constante</translation>
    </message>
    <message>
        <source>Duration of the commanded profile, calculated from distance, velocity and acceleration.</source>
        <translation>Durée du profil commandé, calculée à partir de la distance, de la vitesse et de l’accélération.</translation>
    </message>
    <message>
        <source>Time from the end of the profile until the motor is in the window, where it stays for the dwell.</source>
        <translation>Temps de la fin du profil jusqu’à ce que le moteur soit dans la fenêtre, où il reste pendant le maintien.</translation>
    </message>
    <message>
        <source>The shortest and the longest settling time of the moves there and back, and their number.</source>
        <translation>Les temps d’établissement le plus court et le plus long des allers et retours, et leur nombre.</translation>
    </message>
    <message>
        <source>The largest position error during the move and after it, without its sign.</source>
        <translation>La plus grande erreur de position pendant le mouvement et après, sans son signe.</translation>
    </message>
    <message>
        <source>Root mean square of the position error during the move.</source>
        <translation>Valeur efficace de l’erreur de position pendant le mouvement.</translation>
    </message>
    <message>
        <source>Mean position error over the second half of the time at constant velocity.</source>
        <translation>Erreur de position moyenne sur la seconde moitié du temps à vitesse constante.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseTable</name>
    <message>
        <source>Step responses so far</source>
        <translation>Réponses indicielles jusqu’ici</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Relevé</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Établissement</translation>
    </message>
    <message>
        <source>Run %1 as A</source>
        <translation>Relevé %1 comme A</translation>
    </message>
    <message>
        <source>Run %1 as B</source>
        <translation>Relevé %1 comme B</translation>
    </message>
    <message>
        <source>Draws this run as A, with a solid line.</source>
        <translation>Trace ce relevé comme A, en trait plein.</translation>
    </message>
    <message>
        <source>Draws this run as B, with a dashed line.</source>
        <translation>Trace ce relevé comme B, en trait interrompu.</translation>
    </message>
    <message>
        <source>Step responses, newest first. Select two check boxes to compare the curves. The last %1 are saved with the machine; those with a name or a note are kept longest.</source>
        <translation>Réponses indicielles, les plus récentes d’abord. Cochez deux cases pour comparer les courbes. Les %1 dernières sont enregistrées avec la machine&#x202f;; celles qui ont un nom ou une note sont gardées le plus longtemps.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Name of the run. Double-click or press F2 to edit.</source>
        <translation>Nom du relevé. Double-cliquez ou appuyez sur F2 pour le modifier.</translation>
    </message>
    <message>
        <source>Note on the run. Double-click or press F2 to edit.</source>
        <translation>Note sur le relevé. Double-cliquez ou appuyez sur F2 pour la modifier.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseView</name>
    <message>
        <source>Run</source>
        <translation>Relevé</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Fits the view to the motion and all positions (A, in the plot).</source>
        <translation>Ajuste la vue au mouvement et à toutes les positions (A, dans le graphique).</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C, in the plot).</source>
        <translation>Affiche deux curseurs de mesure&#xa0;: faites-les glisser (C, dans le graphique).</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard.</source>
        <translation>Copie le graphique visible dans le presse-papiers.</translation>
    </message>
    <message>
        <source>Exports the visible plot, with a description of the runs.</source>
        <translation>Exporte le graphique visible, avec une description des relevés.</translation>
    </message>
    <message>
        <source>A: run %1, %2, %3, %4</source>
        <translation>A&#xa0;: relevé %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>B: run %1, %2, %3, %4</source>
        <translation>B&#xa0;: relevé %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>Kp %1 Kd %2 Ki %3 IL %4; rise %5; overshoot %6; settling %7</source>
        <translation>Kp %1 Kd %2 Ki %3 IL %4&#x202f;; montée %5&#x202f;; dépassement %6&#x202f;; établissement %7</translation>
    </message>
    <message>
        <source>Step response, by NMC Panel %1</source>
        <translation>Réponse indicielle, par NMC Panel %1</translation>
    </message>
    <message>
        <source>%1: cursor 1 %2, cursor 2 %3, difference %4</source>
        <translation>%1&#xa0;: curseur 1 %2, curseur 2 %3, écart %4</translation>
    </message>
    <message>
        <source>Picture of the step response</source>
        <translation>Image de la réponse indicielle</translation>
    </message>
    <message>
        <source>step</source>
        <translation>échelon</translation>
    </message>
</context>
<context>
    <name>nmc::Ribbons</name>
    <message>
        <source>SIMULATOR — no hardware connected; all values are simulated</source>
        <translation>SIMULATEUR — aucun matériel connecté&#x202f;; toutes les valeurs sont simulées</translation>
    </message>
    <message>
        <source>Simulated session</source>
        <translation>Session simulée</translation>
    </message>
    <message>
        <source>Read-only session</source>
        <translation>Session en lecture seule</translation>
    </message>
    <message>
        <source>READ-ONLY — only status requests are sent. STOP ALL still works.</source>
        <translation>LECTURE SEULE — seules des demandes d’état sont envoyées. TOUT ARRÊTER fonctionne toujours.</translation>
    </message>
    <message>
        <source>Reconnects to the same port with commands allowed. Nothing moves.</source>
        <translation>Se reconnecte au même port en autorisant les commandes. Rien ne bouge.</translation>
    </message>
    <message>
        <source>OPERATOR MODE — only allowed actions are available. STOP ALL always works.</source>
        <translation>MODE OPÉRATEUR — seules les actions permises sont disponibles. TOUT ARRÊTER fonctionne toujours.</translation>
    </message>
    <message>
        <source>Leave…</source>
        <translation>Quitter…</translation>
    </message>
    <message>
        <source>End pendant mode</source>
        <translation>Terminer le mode pupitre</translation>
    </message>
    <message>
        <source>Hold Shift with ◂ or ▸ to move it. Esc ends pendant mode.</source>
        <translation>Maintenez Maj avec ◂ ou ▸ pour le déplacer. Esc quitte le mode pupitre.</translation>
    </message>
    <message>
        <source>Not moved: %1</source>
        <translation>Non déplacé&#xa0;: %1</translation>
    </message>
    <message>
        <source>PENDANT — %1. %2</source>
        <translation>PUPITRE — %1. %2</translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation>Pupitre</translation>
    </message>
    <message>
        <source>Ends pendant mode: arrow keys and gamepad no longer move anything.</source>
        <translation>Quitte le mode pupitre&#xa0;: les touches fléchées et la manette ne déplacent plus rien.</translation>
    </message>
    <message>
        <source>To move it, hold Shift with ◂ or ▸, or a shoulder button of the gamepad with its left stick or D-pad. B (○) is STOP ALL. Esc ends pendant mode.</source>
        <translation>Pour le déplacer, maintenez Maj avec ◂ ou ▸, ou une gâchette supérieure de la manette avec son stick gauche ou sa croix. B (○) est TOUT ARRÊTER. Esc quitte le mode pupitre.</translation>
    </message>
    <message>
        <source>End control</source>
        <translation>Reprendre le contrôle</translation>
    </message>
    <message>
        <source>The program may no longer move motors.</source>
        <translation>Le programme ne peut plus déplacer les moteurs.</translation>
    </message>
    <message>
        <source>PROGRAM — &quot;%1&quot; may move motors. Esc or any command of yours ends that.</source>
        <translation>PROGRAMME — «&#xa0;%1&#xa0;» peut déplacer les moteurs. Échap ou toute commande de votre part y met fin.</translation>
    </message>
    <message>
        <source>PROGRAMS — none can connect now.</source>
        <translation>PROGRAMMES — aucun ne peut se connecter pour l’instant.</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect once a port is open.</source>
        <translation>PROGRAMMES — connexion possible dès qu’un port est ouvert.</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect at %1. Connected: %2.</source>
        <translation>PROGRAMMES — connexion possible par %1. Connectés&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Line lent to a program</source>
        <translation>Ligne prêtée à un programme</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Laisser continuer</translation>
    </message>
    <message>
        <source>The program has the line again. It may move motors at once.</source>
        <translation>Le programme a de nouveau la ligne. Il peut mouvoir des moteurs immédiatement.</translation>
    </message>
    <message>
        <source>End lending</source>
        <translation>Mettre fin au prêt</translation>
    </message>
    <message>
        <source>The program loses the line, and the chain is scanned again. Nothing is reset or stopped.</source>
        <translation>Le programme perd la ligne, et les modules sont recherchés de nouveau. Rien n’est réinitialisé ni arrêté.</translation>
    </message>
    <message>
        <source>There is a jog wheel, but you may not read it. Unplug it and plug it in again; if that does not help, see the manual. Esc ends pendant mode.</source>
        <translation>Une molette est branchée, mais vous n’avez pas le droit de la lire. Débranchez-la et rebranchez-la&#xa0;; si cela ne suffit pas, consultez le manuel. Esc quitte le mode pupitre.</translation>
    </message>
    <message>
        <source>To move it, hold a button of the jog wheel, and push its ring or cap for a speed or turn the wheel for steps. The middle button, or the right one of a 3-axis mouse, is STOP ALL. Esc ends pendant mode.</source>
        <translation>Pour le déplacer, maintenez un bouton de la molette et poussez la bague ou le capuchon pour une vitesse, ou tournez la molette pour des pas. Le bouton du milieu, ou le droit d’une souris à 3 axes, est TOUT ARRÊTER. Esc quitte le mode pupitre.</translation>
    </message>
</context>
<context>
    <name>nmc::RowDelegate</name>
    <message>
        <source>Value of the row</source>
        <translation>Valeur de la ligne</translation>
    </message>
    <message>
        <source>The value</source>
        <translation>La valeur</translation>
    </message>
    <message>
        <source>Choices of the row</source>
        <translation>Choix de la ligne</translation>
    </message>
</context>
<context>
    <name>nmc::RowsModel</name>
    <message>
        <source>from row %1 on</source>
        <translation>depuis la ligne %1</translation>
    </message>
    <message>
        <source>together</source>
        <translation>ensemble</translation>
    </message>
    <message>
        <source>together, next row at once</source>
        <translation>ensemble, ligne suivante aussitôt</translation>
    </message>
    <message>
        <source>one after the other</source>
        <translation>l’un après l’autre</translation>
    </message>
    <message>
        <source>one after the other, next row at once</source>
        <translation>l’un après l’autre, ligne suivante aussitôt</translation>
    </message>
    <message>
        <source>%1 active</source>
        <translation>%1 actif</translation>
    </message>
    <message>
        <source>%1 not active</source>
        <translation>%1 inactif</translation>
    </message>
    <message>
        <source>output %1 on</source>
        <translation>sortie %1 active</translation>
    </message>
    <message>
        <source>output %1 off</source>
        <translation>sortie %1 inactive</translation>
    </message>
    <message>
        <source>%1 % of its velocity</source>
        <translation>%1&#x202f;% de sa vitesse</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>within %1 s</source>
        <translation>en moins de %1&#xa0;s</translation>
    </message>
    <message>
        <source>forever</source>
        <translation>sans fin</translation>
    </message>
    <message numerus="yes">
        <source>%n times in all</source>
        <translation>
            <numerusform>%n fois au total</numerusform>
            <numerusform>%n fois au total</numerusform>
        </translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>%1 haut</translation>
    </message>
    <message>
        <source>%1 low</source>
        <translation>%1 bas</translation>
    </message>
    <message>
        <source>IO%1 high</source>
        <translation>IO%1 haut</translation>
    </message>
    <message>
        <source>IO%1 low</source>
        <translation>IO%1 bas</translation>
    </message>
    <message>
        <source>A/D %1 above</source>
        <translation>A/D %1 au-dessus</translation>
    </message>
    <message>
        <source>A/D %1 below</source>
        <translation>A/D %1 au-dessous</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Délai</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeBar</name>
    <message>
        <source>Freezes the display (Ctrl+P). Recording of samples continues.</source>
        <translation>Fige l’affichage (Ctrl+P). L’acquisition des échantillons continue.</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C).</source>
        <translation>Affiche deux curseurs de mesure&#xa0;: faites-les glisser (C).</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Bits d’état</translation>
    </message>
    <message>
        <source>Shows the status bits of the selected module over time (B).</source>
        <translation>Affiche les bits d’état du module sélectionné dans le temps (B).</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1&#xa0;min</translation>
    </message>
    <message>
        <source>Time shown by the scope</source>
        <translation>Plage de temps affichée par l’oscilloscope</translation>
    </message>
    <message>
        <source>Sets how much time the scope shows.</source>
        <translation>Définit la plage de temps affichée par l’oscilloscope.</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>Pla&amp;ge</translation>
    </message>
    <message>
        <source>Signals…</source>
        <translation>Signaux…</translation>
    </message>
    <message>
        <source>Selects signals for the strips (S).</source>
        <translation>Choisit les signaux des bandes (S).</translation>
    </message>
    <message>
        <source>Waits for a signal or a status bit, and holds the picture around it (T).</source>
        <translation>Attend un signal ou un bit d’état, et fige l’image autour de cet instant (T).</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Retour au direct</translation>
    </message>
    <message>
        <source>Returns to the live display.</source>
        <translation>Revient à l’affichage en direct.</translation>
    </message>
    <message>
        <source>Source of the picture</source>
        <translation>Source de l’image</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeExport</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>&amp;Samples (CSV)…</source>
        <translation>Échantillon&amp;s (CSV)…</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard, with its samples if there are only a few.</source>
        <translation>Copie le graphique visible dans le presse-papiers, avec ses échantillons s’ils sont peu nombreux.</translation>
    </message>
    <message>
        <source>Export from the scope</source>
        <translation>Exporter depuis l’oscilloscope</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>oscilloscope</translation>
    </message>
    <message>
        <source>All samples of all modules in the visible time. A file with one row per reply can be reopened here; one with a column per signal is for other programs only.</source>
        <translation>Tous les échantillons de tous les modules dans le temps visible. Un fichier avec une ligne par réponse peut être rouvert ici ; avec une colonne par signal, il est uniquement pour d’autres programmes.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeFiles</name>
    <message>
        <source>Open &amp;recording…</source>
        <translation>Ouvrir un en&amp;registrement…</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Ends the recording and closes its file (Ctrl+Shift+R).</source>
        <translation>Termine l’enregistrement et ferme son fichier (Ctrl+Maj+R).</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Cancels opening; the scope stays as it is.</source>
        <translation>Annule l’ouverture&#x202f;; l’oscilloscope reste tel quel.</translation>
    </message>
    <message>
        <source>Shows a recording in the scope. Control of the motors continues.</source>
        <translation>Affiche un enregistrement dans l’oscilloscope. La commande des moteurs continue.</translation>
    </message>
    <message>
        <source>Saves every sample of all modules to a file from now on (Ctrl+Shift+R).</source>
        <translation>Enregistre désormais chaque échantillon de tous les modules dans un fichier (Ctrl+Maj+R).</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Nothing to record: connect a module first.</source>
        <translation>Rien à enregistrer&#xa0;: connectez d’abord un module.</translation>
    </message>
    <message>
        <source>● Recording %1, %2, %3</source>
        <translation>● Enregistrement %1, %2, %3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>Opening %1, %2 %</source>
        <translation>Ouverture de %1, %2&#x202f;%</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>Enregistrer dans un fichier</translation>
    </message>
    <message>
        <source>Recordings (*.%1)</source>
        <translation>Enregistrements (*.%1)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Over&amp;lay a recording…</source>
        <translation>S&amp;uperposer un enregistrement…</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposition</translation>
    </message>
    <message>
        <source>Removes the recording from the plots. Its file is kept.</source>
        <translation>Retire l’enregistrement des graphiques. Son fichier est conservé.</translation>
    </message>
    <message>
        <source>◂ Earlier</source>
        <translation>◂ Plus tôt</translation>
    </message>
    <message>
        <source>Moves the recording to the left.</source>
        <translation>Décale l’enregistrement vers la gauche.</translation>
    </message>
    <message>
        <source>Later ▸</source>
        <translation>Plus tard ▸</translation>
    </message>
    <message>
        <source>Moves the recording to the right.</source>
        <translation>Décale l’enregistrement vers la droite.</translation>
    </message>
    <message>
        <source>Draws a recording in pale lines below the live traces, aligned to the start of the last motion.</source>
        <translation>Trace un enregistrement en traits pâles sous les courbes en direct, calé sur le début du dernier mouvement.</translation>
    </message>
    <message>
        <source>Overlay a recording</source>
        <translation>Superposer un enregistrement</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePanel</name>
    <message>
        <source>Exports the visible samples or a picture.</source>
        <translation>Exporte les échantillons visibles ou une image.</translation>
    </message>
    <message>
        <source>Bits of the lane</source>
        <translation>Bits de la piste</translation>
    </message>
    <message>
        <source>%1 (simulator)</source>
        <translation>%1 (simulateur)</translation>
    </message>
    <message>
        <source>Saves and restores arrangements of the scope by name.</source>
        <translation>Enregistre et rétablit des dispositions de l’oscilloscope par leur nom.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePlot</name>
    <message>
        <source>%1 · unknown</source>
        <translation>%1 · inconnu</translation>
    </message>
    <message>
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The band exceeds the strip: %1 to %2</source>
        <translation>Le tracé dépasse la bande&#xa0;: %1 à %2</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePresets</name>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>&amp;Remove preset</source>
        <translation>&amp;Supprimer le préréglage</translation>
    </message>
    <message>
        <source>Remove preset</source>
        <translation>Supprimer le préréglage</translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>&amp;Enregistrer comme préréglage…</translation>
    </message>
    <message>
        <source>Keeps the present signals, strips, bits and time under a name.</source>
        <translation>Conserve les signaux, bandes, bits et durée actuels sous un nom.</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Enregistrer comme préréglage</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Replaces the preset of that name.</source>
        <translation>Remplace le préréglage de ce nom.</translation>
    </message>
    <message>
        <source>There are %1 presets, which is the most. Remove one first.</source>
        <translation>Il y a déjà %1 préréglages, c’est le maximum. Supprimez-en un d’abord.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeStrips</name>
    <message>
        <source>Plots; arrow keys move, plus and minus zoom</source>
        <translation>Graphiques&#x202f;; les flèches déplacent, plus et moins zooment</translation>
    </message>
    <message>
        <source>Strip %1 of the scope</source>
        <translation>Bande %1 de l’oscilloscope</translation>
    </message>
    <message>
        <source>Drag to resize the strips. Double-click to make them equal.</source>
        <translation>Faites glisser pour redimensionner les bandes. Un double-clic les rend égales.</translation>
    </message>
</context>
<context>
    <name>nmc::SequencesPage</name>
    <message>
        <source>Rename point</source>
        <translation>Renommer le point</translation>
    </message>
    <message>
        <source>Change row</source>
        <translation>Modifier la ligne</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Name of the point to teach</source>
        <translation>Nom du point à apprendre</translation>
    </message>
    <message>
        <source>Name of a point</source>
        <translation>Nom d’un point</translation>
    </message>
    <message>
        <source>Axes to teach</source>
        <translation>Axes à apprendre</translation>
    </message>
    <message>
        <source>The selected axes become part of the point.</source>
        <translation>Les axes sélectionnés feront partie du point.</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Apprendre</translation>
    </message>
    <message>
        <source>Teach a point: store the positions of the selected axes</source>
        <translation>Apprendre un point&#xa0;: mémoriser les positions des axes sélectionnés</translation>
    </message>
    <message>
        <source>Go to point</source>
        <translation>Aller au point</translation>
    </message>
    <message>
        <source>Go to point: the selected one</source>
        <translation>Aller au point sélectionné</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Supprimer le point</translation>
    </message>
    <message>
        <source>Remove point: the selected one</source>
        <translation>Supprimer le point sélectionné</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>Nom de la séquence</translation>
    </message>
    <message>
        <source>Type a new name for this sequence, then press Enter.</source>
        <translation>Saisissez un nouveau nom pour cette séquence, puis appuyez sur Entrée.</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Nouvelle séquence</translation>
    </message>
    <message>
        <source>Remove sequence</source>
        <translation>Supprimer la séquence</translation>
    </message>
    <message>
        <source>Remove sequence with its rows</source>
        <translation>Supprimer la séquence avec ses lignes</translation>
    </message>
    <message>
        <source>Rows of the sequence</source>
        <translation>Lignes de la séquence</translation>
    </message>
    <message>
        <source>Double-click a cell or press F2 to edit it.</source>
        <translation>Double-cliquez sur une cellule ou appuyez sur F2 pour la modifier.</translation>
    </message>
    <message>
        <source>Result of the dry run</source>
        <translation>Résultat de la marche à blanc</translation>
    </message>
    <message>
        <source>Rename sequence</source>
        <translation>Renommer la séquence</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Ajouter une ligne</translation>
    </message>
    <message>
        <source>Add row after the selected one</source>
        <translation>Ajouter une ligne après la ligne sélectionnée</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate the selected row</source>
        <translation>Dupliquer la ligne sélectionnée</translation>
    </message>
    <message>
        <source>Duplicate row</source>
        <translation>Dupliquer la ligne</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Supprimer la ligne</translation>
    </message>
    <message>
        <source>Remove row: the selected one</source>
        <translation>Supprimer la ligne&#xa0;: celle qui est sélectionnée</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Up: move the selected row</source>
        <translation>Vers le haut&#xa0;: déplacer la ligne sélectionnée</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Vers le bas</translation>
    </message>
    <message>
        <source>Down: move the selected row</source>
        <translation>Vers le bas&#xa0;: déplacer la ligne sélectionnée</translation>
    </message>
    <message>
        <source>Undo the last change to points and sequences</source>
        <translation>Annuler la dernière modification des points et séquences</translation>
    </message>
    <message>
        <source>Redo the last undone change to points and sequences</source>
        <translation>Rétablir la dernière modification annulée des points et séquences</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Marche à blanc</translation>
    </message>
    <message>
        <source>Dry run: simulate the sequence; nothing moves</source>
        <translation>Marche à blanc&#xa0;: simuler la séquence&#x202f;; rien ne bouge</translation>
    </message>
    <message>
        <source>Dry run…</source>
        <translation>Marche à blanc…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécuter</translation>
    </message>
    <message>
        <source>Run the sequence</source>
        <translation>Exécuter la séquence</translation>
    </message>
    <message>
        <source>Run from row</source>
        <translation>Lancer depuis la ligne</translation>
    </message>
    <message>
        <source>Run from row: start at the selected row</source>
        <translation>Lancer depuis la ligne sélectionnée</translation>
    </message>
    <message>
        <source>Pause the sequence after its row</source>
        <translation>Pause de la séquence après sa ligne</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>Pas à pas</translation>
    </message>
    <message>
        <source>Single step: run one row of the sequence</source>
        <translation>Pas à pas&#xa0;: exécuter une ligne de la séquence</translation>
    </message>
    <message>
        <source>Stop sequence</source>
        <translation>Arrêter la séquence</translation>
    </message>
    <message>
        <source>Stop sequence and its motors</source>
        <translation>Arrêter la séquence et ses moteurs</translation>
    </message>
    <message>
        <source>Teach point</source>
        <translation>Apprendre un point</translation>
    </message>
    <message>
        <source>Move row</source>
        <translation>Déplacer la ligne</translation>
    </message>
    <message>
        <source>Enter a name for the point first.</source>
        <translation>Saisissez d’abord un nom pour le point.</translation>
    </message>
    <message>
        <source>Select at least one axis.</source>
        <translation>Sélectionnez au moins un axe.</translation>
    </message>
    <message>
        <source>Stores the present positions of the selected axes under this name, replacing any point of that name. Nothing moves.</source>
        <translation>Mémorise les positions actuelles des axes sélectionnés sous ce nom, en remplaçant tout point de ce nom. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Select a point in the table.</source>
        <translation>Sélectionnez un point dans le tableau.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses this point. Change that row first.</source>
        <translation>La ligne %1 de «&#xa0;%2&#xa0;» utilise ce point. Modifiez d’abord cette ligne.</translation>
    </message>
    <message>
        <source>Moves all axes of this point there together, each at its own velocity.</source>
        <translation>Déplace ensemble tous les axes de ce point jusqu’à lui, chacun à sa propre vitesse.</translation>
    </message>
    <message>
        <source>Removes this point; nothing moves.</source>
        <translation>Supprime ce point&#x202f;; rien ne bouge.</translation>
    </message>
    <message>
        <source>No sequence yet. Add one first.</source>
        <translation>Pas encore de séquence. Ajoutez-en d’abord une.</translation>
    </message>
    <message>
        <source>Select a row in the table.</source>
        <translation>Sélectionnez une ligne dans le tableau.</translation>
    </message>
    <message>
        <source>Adds an empty sequence.</source>
        <translation>Ajoute une séquence vide.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; calls this sequence. Change that row first.</source>
        <translation>La ligne %1 de «&#xa0;%2&#xa0;» appelle cette séquence. Modifiez d’abord cette ligne.</translation>
    </message>
    <message>
        <source>Removes this sequence with its rows.</source>
        <translation>Supprime cette séquence avec ses lignes.</translation>
    </message>
    <message>
        <source>Adds a row after the selected one, or at the end.</source>
        <translation>Ajoute une ligne après la ligne sélectionnée, ou à la fin.</translation>
    </message>
    <message>
        <source>Adds a copy of the row after it.</source>
        <translation>Ajoute une copie de la ligne juste après.</translation>
    </message>
    <message>
        <source>Removes this row.</source>
        <translation>Supprime cette ligne.</translation>
    </message>
    <message>
        <source>The row cannot move farther: a repeat must stay below the row it goes back to.</source>
        <translation>La ligne ne peut pas aller plus loin&#xa0;: une répétition doit rester sous la ligne à laquelle elle revient.</translation>
    </message>
    <message>
        <source>Moves this row up.</source>
        <translation>Déplace cette ligne vers le haut.</translation>
    </message>
    <message>
        <source>Moves this row down.</source>
        <translation>Déplace cette ligne vers le bas.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from its first row.</source>
        <translation>Exécute «&#xa0;%1&#xa0;» depuis sa première ligne.</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from the selected row on. The axes must be where the rows above leave them.</source>
        <translation>Exécute «&#xa0;%1&#xa0;» à partir de la ligne sélectionnée. Les axes doivent être là où les lignes précédentes les laissent.</translation>
    </message>
    <message>
        <source>No sequence is running.</source>
        <translation>Aucune séquence n’est en cours.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Continues from where it paused.</source>
        <translation>Reprend là où elle s’était mise en pause.</translation>
    </message>
    <message>
        <source>Finishes the current row, then waits.</source>
        <translation>Termine la ligne en cours, puis attend.</translation>
    </message>
    <message>
        <source>The sequence is running. Pause it first.</source>
        <translation>La séquence est en cours. Mettez-la d’abord en pause.</translation>
    </message>
    <message>
        <source>Runs one row, then waits. Starts with the selected row.</source>
        <translation>Exécute une ligne, puis attend. Commence par la ligne sélectionnée.</translation>
    </message>
    <message>
        <source>Ends the sequence and stops its motors smoothly.</source>
        <translation>Met fin à la séquence et arrête progressivement ses moteurs.</translation>
    </message>
    <message>
        <source>End dry run</source>
        <translation>Arrêter la marche à blanc</translation>
    </message>
    <message>
        <source>Simulates the sequence: shows how long it takes, where each axis goes and what would be refused. Nothing moves.</source>
        <translation>Simule la séquence&#xa0;: montre sa durée, où va chaque axe et ce qui serait refusé. Rien ne bouge.</translation>
    </message>
</context>
<context>
    <name>nmc::ServoPanel</name>
    <message>
        <source>Servo module</source>
        <translation>Module servo</translation>
    </message>
    <message>
        <source>Limits &amp;&amp; I/O</source>
        <translation>Fins de course &amp;&amp; E/S</translation>
    </message>
</context>
<context>
    <name>nmc::SignalsDialog</name>
    <message>
        <source>Signals of the scope</source>
        <translation>Signaux de l’oscilloscope</translation>
    </message>
    <message>
        <source>Signals and their strips</source>
        <translation>Signaux et leurs bandes</translation>
    </message>
    <message>
        <source>Strip %1</source>
        <translation>Bande %1</translation>
    </message>
    <message>
        <source>Select the strips of each signal. Empty strips are hidden.</source>
        <translation>Sélectionnez les bandes de chaque signal. Les bandes vides sont masquées.</translation>
    </message>
    <message>
        <source>The selected module</source>
        <translation>Le module sélectionné</translation>
    </message>
    <message>
        <source>&amp;Usual signals</source>
        <translation>Signaux &amp;usuels</translation>
    </message>
    <message>
        <source>Usual signals</source>
        <translation>Signaux usuels</translation>
    </message>
    <message>
        <source>%1: %2 in strip %3</source>
        <translation>%1&#xa0;: %2 dans la bande %3</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Filter by module or signal</source>
        <translation>Filtrer par module ou par signal</translation>
    </message>
    <message>
        <source>Position and command position, with the error and the motor current below.</source>
        <translation>Position et position de consigne, avec dessous l’erreur et le courant moteur.</translation>
    </message>
    <message>
        <source>&amp;Custom traces…</source>
        <translation>&amp;Courbes personnalisées…</translation>
    </message>
    <message>
        <source>Custom traces</source>
        <translation>Courbes personnalisées</translation>
    </message>
    <message>
        <source>Traces of your own, from one or two signals.</source>
        <translation>Vos propres courbes, à partir d’un ou deux signaux.</translation>
    </message>
</context>
<context>
    <name>nmc::SimulatorBench</name>
    <message>
        <source>Simulated module</source>
        <translation>Module simulé</translation>
    </message>
    <message>
        <source>Follows the module list, and includes modules that the panel did not find.</source>
        <translation>Suit la liste des modules, et comprend aussi les modules que le programme n’a pas trouvés.</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumDialog</name>
    <message>
        <source>Peak</source>
        <translation>Pic</translation>
    </message>
    <message>
        <source>Spectrum between the cursors</source>
        <translation>Spectre entre les curseurs</translation>
    </message>
    <message>
        <source>&amp;Signal</source>
        <translation>&amp;Signal</translation>
    </message>
    <message>
        <source>Peak: %1 Hz, amplitude %2 %3</source>
        <translation>Pic&#xa0;: %1 Hz, amplitude %2 %3</translation>
    </message>
    <message>
        <source>No oscillation stands out from the noise.</source>
        <translation>Aucune oscillation ne se détache du bruit.</translation>
    </message>
    <message>
        <source>From %1 Hz, two periods between the cursors, to %2 Hz, nearly half the rate of the samples.</source>
        <translation>De %1 Hz, deux périodes entre les curseurs, à %2 Hz, presque la moitié de la fréquence des échantillons.</translation>
    </message>
    <message>
        <source>There is a long gap between the cursors. Move both to the same side of it.</source>
        <translation>Il y a une longue lacune entre les curseurs. Placez-les tous deux du même côté.</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>The sines in the signal, by frequency in Hz. The circle marks the highest that stands out from the noise. Double-click to show everything. Scroll to zoom the frequency, or the amplitudes with Ctrl; drag to pan; drag with Shift to select frequencies.</source>
        <translation>Les sinusoïdes du signal, par fréquence en Hz. Le cercle marque la plus haute qui se détache du bruit. Double-cliquez pour tout afficher. La molette zoome la fréquence, ou les amplitudes avec Ctrl&#xa0;; faites glisser pour déplacer la vue&#xa0;; faites glisser avec Maj pour sélectionner des fréquences.</translation>
    </message>
</context>
<context>
    <name>nmc::SquarePlot</name>
    <message>
        <source>Square wave, one period</source>
        <translation>Signal carré, une période</translation>
    </message>
    <message>
        <source>median, %1</source>
        <translation>médiane, %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>No edge recorded yet. A square wave overlays many steps while you change gains.</source>
        <translation>Aucun front enregistré. Un signal carré superpose de nombreux échelons pendant que vous modifiez les gains.</translation>
    </message>
    <message>
        <source>All edges with the present gains, overlaid: the line is their median, the shaded band holds 80 % of the samples. Pale: the previous gains. Double-click to show everything. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>Tous les fronts avec les gains actuels, superposés&#xa0;: le trait est leur médiane, la zone grisée contient 80&#xa0;% des échantillons. En pâle&#xa0;: les gains précédents. Double-cliquez pour tout afficher. La molette zoome le temps, ou les positions avec Ctrl&#xa0;; faites glisser pour déplacer la vue ; faites glisser avec Maj pour sélectionner une durée.</translation>
    </message>
</context>
<context>
    <name>nmc::SquareWavePage</name>
    <message>
        <source>Start test</source>
        <translation>Lancer le test</translation>
    </message>
    <message>
        <source>The motor jumps back and forth around its position. Make sure that everything it drives can move freely.</source>
        <translation>Le moteur saute d’un côté à l’autre de sa position. Assurez-vous que tout ce qu’il entraîne peut bouger librement.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>The distance</source>
        <translation>La distance</translation>
    </message>
    <message>
        <source>From side to side: half to either side of the present position.</source>
        <translation>D’un côté à l’autre&#xa0;: la moitié de chaque côté de la position actuelle.</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Période</translation>
    </message>
    <message>
        <source>The period</source>
        <translation>La période</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Périodes</translation>
    </message>
    <message>
        <source>Periods to run</source>
        <translation>Nombre de périodes</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>Excursion</translation>
    </message>
    <message>
        <source>How far the motor may move past either side. Beyond that, the test stops and the motor holds.</source>
        <translation>Distance dont le moteur peut dépasser chaque côté. Au-delà, l’essai s’arrête et le moteur maintient sa position.</translation>
    </message>
    <message>
        <source>Results of the edges</source>
        <translation>Résultats des fronts</translation>
    </message>
    <message>
        <source>Keep as a run</source>
        <translation>Garder comme relevé</translation>
    </message>
    <message>
        <source>Keep as a run: the median edge</source>
        <translation>Garder comme relevé&#xa0;: le front médian</translation>
    </message>
    <message>
        <source>Settling %1</source>
        <translation>Établissement %1</translation>
    </message>
    <message>
        <source>No edge recorded yet.</source>
        <translation>Aucun front enregistré.</translation>
    </message>
    <message>
        <source>Adds the median of the rising edges to the list of step responses.</source>
        <translation>Ajoute la médiane des fronts montants à la liste des réponses indicielles.</translation>
    </message>
    <message>
        <source>Edges with these gains: %1</source>
        <translation>Fronts avec ces gains&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>nmc::StagedForm</name>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ envoyé</translation>
    </message>
    <message>
        <source>● not sent</source>
        <translation>● non envoyé</translation>
    </message>
    <message>
        <source>Undoes the last edit in these fields. Sends nothing.</source>
        <translation>Annule la dernière modification dans ces champs. N’envoie rien.</translation>
    </message>
    <message>
        <source>Redoes the edit that was undone. Sends nothing.</source>
        <translation>Rétablit la modification annulée. N’envoie rien.</translation>
    </message>
    <message>
        <source>No changes to apply.</source>
        <translation>Aucune modification à appliquer.</translation>
    </message>
</context>
<context>
    <name>nmc::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Start the simulator</source>
        <translation>Démarrer le simulateur</translation>
    </message>
    <message>
        <source>Needs no hardware. Three simulated modules to try everything on; no real motor moves.</source>
        <translation>Sans matériel. Trois modules simulés pour tout essayer&#x202f;; aucun moteur réel ne bouge.</translation>
    </message>
    <message>
        <source>Connects to the built-in simulator.</source>
        <translation>Se connecte au simulateur intégré.</translation>
    </message>
    <message>
        <source>Choose a serial port…</source>
        <translation>Choisir un port série…</translation>
    </message>
    <message>
        <source>No serial port found. Plug in the modules&apos; adapter; it then appears here.</source>
        <translation>Aucun port série trouvé. Branchez l’adaptateur des modules&#xa0;: il apparaît ici.</translation>
    </message>
    <message>
        <source>%1 Bd.</source>
        <translation>%1&#xa0;Bd.</translation>
    </message>
    <message>
        <source>%1, %2 Bd.</source>
        <translation>%1, %2&#xa0;Bd.</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>Se connecter à %1</translation>
    </message>
    <message>
        <source>The modules must be powered and their cable plugged in.</source>
        <translation>Les modules doivent être alimentés et leur câble branché.</translation>
    </message>
    <message>
        <source>Other ports are in the list above.</source>
        <translation>Les autres ports figurent dans la liste ci-dessus.</translation>
    </message>
</context>
<context>
    <name>nmc::StatusLane</name>
    <message>
        <source>Status bits over time</source>
        <translation>Bits d’état dans le temps</translation>
    </message>
</context>
<context>
    <name>nmc::StepperIoBox</name>
    <message>
        <source>Set all outputs</source>
        <translation>Définir toutes les sorties</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entrées et sorties</translation>
    </message>
    <message>
        <source>OUT%1</source>
        <translation>OUT%1</translation>
    </message>
    <message>
        <source>Name of output %1</source>
        <translation>Nom de la sortie %1</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>Name of input %1</source>
        <translation>Nom de l’entrée %1</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorée</translation>
    </message>
    <message>
        <source>keeps the motor from moving</source>
        <translation>empêche le moteur de bouger</translation>
    </message>
    <message>
        <source>blocks forward</source>
        <translation>bloque la marche avant</translation>
    </message>
    <message>
        <source>blocks reverse</source>
        <translation>bloque la marche arrière</translation>
    </message>
    <message>
        <source>● %1, not sent</source>
        <translation>● %1, non envoyé</translation>
    </message>
    <message>
        <source>Selects the level. Choose Set all outputs to send all five.</source>
        <translation>Choisit le niveau. «&#xa0;Définir toutes les sorties&#xa0;» envoie les cinq.</translation>
    </message>
    <message>
        <source>Select a level for all five outputs first.</source>
        <translation>Choisissez d’abord un niveau pour les cinq sorties.</translation>
    </message>
    <message>
        <source>Sends all five outputs as selected above.</source>
        <translation>Envoie les cinq sorties telles que choisies ci-dessus.</translation>
    </message>
    <message>
        <source>Outputs unknown: they cannot be read back. Select all five levels, then set them.</source>
        <translation>Sorties inconnues&#xa0;: elles ne peuvent pas être relues. Choisissez les cinq niveaux, puis définissez-les.</translation>
    </message>
</context>
<context>
    <name>nmc::StepperMotionBox</name>
    <message>
        <source>b&amp;y this distance</source>
        <translation>de cette di&amp;stance</translation>
    </message>
    <message>
        <source>By this distance from the present position</source>
        <translation>De cette distance depuis la position actuelle</translation>
    </message>
    <message>
        <source>The speed</source>
        <translation>La vitesse</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Position</translation>
    </message>
    <message>
        <source>Trave&amp;l speed</source>
        <translation>&amp;Vitesse de déplacement</translation>
    </message>
    <message>
        <source>Load o&amp;nly</source>
        <translation>Charger seuleme&amp;nt</translation>
    </message>
    <message>
        <source>Load only, start later</source>
        <translation>Charger seulement, démarrer plus tard</translation>
    </message>
    <message>
        <source>Start loaded</source>
        <translation>Lancer le mouvement</translation>
    </message>
    <message>
        <source>Start loaded motion</source>
        <translation>Lancer le mouvement chargé</translation>
    </message>
    <message>
        <source>How fast the motor turns: %1 to %2 in this speed mode. The chip uses the nearest speed available.</source>
        <translation>Vitesse du moteur&#xa0;: %1 à %2 dans ce mode de vitesse. La puce utilise la vitesse disponible la plus proche.</translation>
    </message>
    <message>
        <source>At constant speed, without a ramp.</source>
        <translation>À vitesse constante, sans rampe.</translation>
    </message>
    <message>
        <source>Takes %1 s from standstill.</source>
        <translation>Dure %1&#xa0;s à partir de l’arrêt.</translation>
    </message>
    <message>
        <source>Stop, wait: %1</source>
        <translation>Arrêt, attente&#xa0;: %1</translation>
    </message>
    <message>
        <source>Loads the motion without starting it.</source>
        <translation>Charge le mouvement sans le démarrer.</translation>
    </message>
    <message>
        <source>Load &amp;reverse</source>
        <translation>Charger a&amp;rrière</translation>
    </message>
    <message>
        <source>Load forward</source>
        <translation>Charger avant</translation>
    </message>
    <message>
        <source>Starts the loaded motion.</source>
        <translation>Démarre le mouvement chargé.</translation>
    </message>
    <message>
        <source>A run has no goal.</source>
        <translation>Une marche continue n’a pas de cible.</translation>
    </message>
    <message>
        <source>The goal of the move. Press Enter to start.</source>
        <translation>Cible du déplacement. Appuyez sur Entrée pour démarrer.</translation>
    </message>
    <message>
        <source>The distance counts from where the motor is at the start.</source>
        <translation>La distance se compte depuis la position du moteur au départ.</translation>
    </message>
    <message>
        <source>The buttons only load the motion. Choose Start loaded, or start the module&apos;s group.</source>
        <translation>Les boutons ne font que charger le mouvement. Choisissez «&#xa0;Lancer le mouvement&#xa0;», ou démarrez le groupe du module.</translation>
    </message>
    <message>
        <source>No ramp.</source>
        <translation>Pas de rampe.</translation>
    </message>
    <message>
        <source>Stops smoothly, waits until the motor is at rest, then: %1</source>
        <translation>S’arrête progressivement, attend que le moteur soit à l’arrêt, puis&#xa0;: %1</translation>
    </message>
    <message>
        <source>Moves to home with a ramp, at the travel speed.</source>
        <translation>Va à l’origine avec une rampe, à la vitesse de déplacement.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Moves to a position with ramps (trapezoidal profile mode).</source>
        <translation>Se déplace vers une position avec rampes (mode profil trapézoïdal).</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Ramps to a speed and keeps it until stopped (velocity profile mode).</source>
        <translation>Monte en rampe jusqu’à une vitesse et la garde jusqu’à l’ordre d’arrêt (mode profil de vitesse).</translation>
    </message>
    <message>
        <source>Move without ramp</source>
        <translation>Déplacement sans rampe</translation>
    </message>
    <message>
        <source>Moves to a position at constant speed, without ramps. At too high a speed the motor loses steps (unprofiled, with stop).</source>
        <translation>Se déplace vers une position à vitesse constante, sans rampes. À une vitesse trop élevée, le moteur perd des pas (sans profil, avec arrêt).</translation>
    </message>
    <message>
        <source>Run without ramp</source>
        <translation>Marche sans rampe</translation>
    </message>
    <message>
        <source>Runs at constant speed, without a ramp, until stopped. At too high a speed the motor loses steps (unprofiled, without stop).</source>
        <translation>Tourne à vitesse constante, sans rampe, jusqu’à l’ordre d’arrêt. À une vitesse trop élevée, le moteur perd des pas (sans profil, sans arrêt).</translation>
    </message>
    <message>
        <source>Kind of motion</source>
        <translation>Type de mouvement</translation>
    </message>
</context>
<context>
    <name>nmc::StepperPanel</name>
    <message>
        <source>Stepper module</source>
        <translation>Module pas à pas</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
</context>
<context>
    <name>nmc::StepperParametersBox</name>
    <message>
        <source>ignored: no motor stop</source>
        <translation>ignorés&#xa0;: ils n’arrêtent rien</translation>
    </message>
    <message>
        <source>motor switches off, too</source>
        <translation>le moteur est aussi coupé</translation>
    </message>
    <message>
        <source>&amp;Apply parameters</source>
        <translation>Tout appli&amp;quer</translation>
    </message>
    <message>
        <source>Revert the parameters to those last sent</source>
        <translation>Abandonner&#xa0;: revenir aux derniers paramètres envoyés</translation>
    </message>
    <message>
        <source>Apply parameters: all</source>
        <translation>Tout appliquer&#xa0;: tous les paramètres</translation>
    </message>
    <message>
        <source>Fills in low speeds and currents to start with. Sends nothing.</source>
        <translation>Remplit les champs de vitesses et courants faibles pour commencer. N’envoie rien.</translation>
    </message>
    <message>
        <source>Choose a speed mode.</source>
        <translation>Choisissez un mode de vitesse.</translation>
    </message>
    <message>
        <source>Parameters cannot be read back from the module. The motor moves only after you apply them.</source>
        <translation>Les paramètres ne peuvent pas être relus dans le module. Le moteur ne bouge qu’après leur application.</translation>
    </message>
    <message>
        <source>If checked, the E-stop input does not stop the motor.</source>
        <translation>Si la case est cochée, l’entrée E-Stop n’arrête pas le moteur.</translation>
    </message>
    <message>
        <source>If checked, the limit switches do not stop the motor.</source>
        <translation>Si la case est cochée, les fins de course n’arrêtent pas le moteur.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.</source>
        <translation>Envoie tous les paramètres à la fois. L’amplificateur est actif&#xa0;: courants et limites prennent effet immédiatement.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The motor does not move.</source>
        <translation>Envoie tous les paramètres à la fois. Le moteur ne bouge pas.</translation>
    </message>
    <message>
        <source>Restores the parameters last sent. Sends nothing.</source>
        <translation>Rétablit les derniers paramètres envoyés. N’envoie rien.</translation>
    </message>
    <message>
        <source>Clears the fields: no parameters have been sent yet. Sends nothing.</source>
        <translation>Vide les champs&#xa0;: aucun paramètre n’a encore été envoyé. N’envoie rien.</translation>
    </message>
    <message>
        <source>Undo the last edit of a parameter</source>
        <translation>Annuler la dernière modification d’un paramètre</translation>
    </message>
    <message>
        <source>Redo the edit of a parameter</source>
        <translation>Rétablir la modification d’un paramètre</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>Mode de vitesse</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Vitesse minimale de profil</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>Courant de marche</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>Courant de maintien</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>Seuil thermique</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>Fins de course</translation>
    </message>
    <message>
        <source>On limit or E-stop</source>
        <translation>Sur fin de course ou E-Stop</translation>
    </message>
    <message>
        <source>The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.</source>
        <translation>L’horloge du générateur de pas. Une horloge plus rapide atteint des vitesses plus élevées par paliers plus grossiers&#xa0;: utilisez la plus lente qui soit assez rapide. La modifier change la signification de toutes les vitesses et rampes.</translation>
    </message>
    <message>
        <source>The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.</source>
        <translation>Vitesse à laquelle les rampes commencent et finissent. Le moteur doit pouvoir démarrer et s’arrêter à cette vitesse sans perdre de pas. Les marches continues et les déplacements avec rampe ne sont jamais plus lents.</translation>
    </message>
    <message>
        <source>Motor current while moving; 255 is the driver&apos;s full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.</source>
        <translation>Courant du moteur en mouvement&#x202f;; 255 est le plein courant du driver. 0&#xa0;: pas de courant, le moteur ne suit pas. Ne dépassez pas les valeurs nominales du moteur et du driver.</translation>
    </message>
    <message>
        <source>Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and no holding torque.</source>
        <translation>Courant du moteur à l’arrêt, environ 0,25&#xa0;s après un mouvement. En général inférieur au courant de marche, pour limiter l’échauffement du moteur. 0&#xa0;: pas de courant, le moteur ne maintient rien.</translation>
    </message>
    <message>
        <source>The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.</source>
        <translation>Le module coupe le moteur quand la valeur A/D tombe sous ce seuil&#xa0;: la tension d’un pont à thermistance baisse quand le moteur chauffe. 0&#xa0;: inactif. Pour trouver le bon seuil, observez la valeur A/D d’un moteur chaud.</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches do not stop the motor, and it can run into the end of its travel.</source>
        <translation>Normalement, la puce s’arrête au fin de course 1 en marche avant et au fin de course 2 en marche arrière. S’ils sont ignorés, les fins de course n’arrêtent rien et le moteur peut heurter l’extrémité de sa course.</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor when its E-stop input goes high. When ignored, the input does not stop the motor.</source>
        <translation>Normalement, la puce arrête le moteur quand son entrée E-Stop passe à l’état haut. Si elle est ignorée, l’entrée n’arrête rien.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.</source>
        <translation>Un fin de course ou l’entrée E-Stop coupe en plus le moteur&#xa0;: il peut tourner librement, et une charge peut tomber.</translation>
    </message>
    <message>
        <source>A/D now %1</source>
        <translation>A/D actuel %1</translation>
    </message>
    <message>
        <source>off; %1</source>
        <translation>inactif&#x202f;; %1</translation>
    </message>
    <message>
        <source>no current</source>
        <translation>pas de courant</translation>
    </message>
    <message>
        <source>%1 % of full</source>
        <translation>%1&#x202f;% du maximum</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>vitesse %1</translation>
    </message>
    <message>
        <source>The acceleration time</source>
        <translation>Le temps d’accélération</translation>
    </message>
    <message>
        <source>How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it.</source>
        <translation>Durée pendant laquelle une rampe reste à chaque vitesse, en unités de 0,25&#xa0;ms&#x202f;; plus petit est plus raide. Envoyé avec le prochain mouvement à rampe, et utilisé par les arrêts progressifs suivants.</translation>
    </message>
    <message>
        <source>Jog is never faster than this. Set a speed that you can react to.</source>
        <translation>Le jog n’est jamais plus rapide. Choisissez une vitesse qui vous laisse le temps de réagir.</translation>
    </message>
    <message>
        <source>With every motion</source>
        <translation>À chaque mouvement</translation>
    </message>
    <message>
        <source>× 0.25 ms</source>
        <translation>× 0,25&#xa0;ms</translation>
    </message>
</context>
<context>
    <name>nmc::StopButton</name>
    <message>
        <source>STOP ALL  Esc</source>
        <translation>TOUT ARRÊTER  Esc</translation>
    </message>
    <message>
        <source>STOP ALL  Esc: stop all motors</source>
        <translation>TOUT ARRÊTER  Esc&#xa0;: arrêter tous les moteurs</translation>
    </message>
    <message>
        <source>Stops every motor. Unavailable: no port is open.</source>
        <translation>Arrête tous les moteurs. Indisponible&#xa0;: aucun port n’est ouvert.</translation>
    </message>
    <message>
        <source>Stops every motor on this line at once; Esc does the same from anywhere. It %1.
It works only while the link works: fit a hardware stop as well.</source>
        <translation>Arrête immédiatement tous les moteurs de cette ligne&#x202f;; Esc fait de même depuis n’importe où. La commande %1.
Elle n’agit que tant que la liaison fonctionne&#xa0;: prévoyez aussi un arrêt câblé.</translation>
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
        <translation>Ces échantillons ne sont plus conservés individuellement. Déplacez les curseurs vers de plus récents.</translation>
    </message>
    <message>
        <source>%1 samples are between the cursors, and %2 are the most. Move the cursors closer together.</source>
        <translation>Il y a %1 échantillons entre les curseurs, et %2 au plus sont possibles. Rapprochez les curseurs.</translation>
    </message>
    <message>
        <source>Too few samples are between the cursors. Move them farther apart.</source>
        <translation>Il y a trop peu d’échantillons entre les curseurs. Éloignez-les.</translation>
    </message>
</context>
<context>
    <name>nmc::TestForm</name>
    <message>
        <source>End test</source>
        <translation>Terminer l’essai</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Progression de l’essai</translation>
    </message>
    <message>
        <source>The test is already running.</source>
        <translation>L’essai est déjà en cours.</translation>
    </message>
    <message>
        <source>The test is not running.</source>
        <translation>L’essai n’est pas en cours.</translation>
    </message>
</context>
<context>
    <name>nmc::TracesDialog</name>
    <message>
        <source>Custom traces</source>
        <translation>Courbes personnalisées</translation>
    </message>
    <message>
        <source>Each trace is the sum of one or two signals, each times a factor. Values are taken in the units in which the signals are shown; a negative factor subtracts.</source>
        <translation>Chaque courbe est la somme d’un ou deux signaux, chacun multiplié par un facteur. Les valeurs sont dans les unités dans lesquelles les signaux sont affichés&#xa0;; un facteur négatif soustrait.</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Second signal</source>
        <translation>Second signal</translation>
    </message>
    <message>
        <source>Low-pass, Hz</source>
        <translation>Passe-bas, Hz</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Appliquer</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>%1, trace %2</source>
        <translation>%1, courbe %2</translation>
    </message>
    <message>
        <source>The name in the legend. Without one, there is no such trace.</source>
        <translation>Le nom dans la légende. Sans nom, la courbe n’existe pas.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Selected module</source>
        <translation>Module sélectionné</translation>
    </message>
    <message>
        <source>Smooths the trace: what is faster than this frequency is attenuated, and the trace lags behind. Empty: no filter.</source>
        <translation>Lisse la courbe&#xa0;: ce qui est plus rapide que cette fréquence est atténué, et la courbe prend du retard. Vide&#xa0;: pas de filtre.</translation>
    </message>
    <message>
        <source>Shown beside the name.</source>
        <translation>Affichée à côté du nom.</translation>
    </message>
    <message>
        <source>Factor of: %1</source>
        <translation>Facteur de&#xa0;: %1</translation>
    </message>
    <message>
        <source>The signal is multiplied by it.</source>
        <translation>Le signal est multiplié par ce facteur.</translation>
    </message>
    <message>
        <source>A factor must not be 0.</source>
        <translation>Un facteur ne doit pas être 0.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
</context>
<context>
    <name>nmc::TravelBox</name>
    <message>
        <source>State of the travel limits</source>
        <translation>État des limites de course</translation>
    </message>
    <message>
        <source>Counted from home. No motion passes it while home is known. Empty: no limit.</source>
        <translation>Comptée depuis l’origine. Aucun mouvement ne la dépasse tant que l’origine est connue. Vide&#xa0;: pas de limite.</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Ici</translation>
    </message>
    <message>
        <source>Here: make the present position the lowest</source>
        <translation>Ici&#xa0;: prendre la position actuelle comme position minimale</translation>
    </message>
    <message>
        <source>Here: make the present position the highest</source>
        <translation>Ici&#xa0;: prendre la position actuelle comme position maximale</translation>
    </message>
    <message>
        <source>Limits moves, runs, steps, jog and homing. Empty: the module&apos;s maximum.</source>
        <translation>Limite les déplacements, marches continues, pas, jog et prises d’origine. Vide&#xa0;: le maximum du module.</translation>
    </message>
    <message>
        <source>Slightly more than the play between motor and load. A move from the other side overshoots its goal by this distance and comes back. Empty: none.</source>
        <translation>Un peu plus que le jeu entre le moteur et la charge. Un déplacement venant de l’autre côté dépasse sa cible de cette distance et revient. Vide&#xa0;: aucun.</translation>
    </message>
    <message>
        <source>Approach direction of every goal</source>
        <translation>Sens d’approche de chaque cible</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>par le bas</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>par le haut</translation>
    </message>
    <message>
        <source>Go, Go home, steps, points and sequences approach their goals from this side. Loaded moves and paths go straight to theirs.</source>
        <translation>«&#xa0;Y aller&#xa0;», «&#xa0;Aller à l’origine&#xa0;», les pas, les points et les séquences approchent leur cible de ce côté. Les déplacements chargés et les trajectoires y vont directement.</translation>
    </message>
    <message>
        <source>Confirm position…</source>
        <translation>Confirmer la position…</translation>
    </message>
    <message>
        <source>Confirm position as correct</source>
        <translation>Confirmer la position comme exacte</translation>
    </message>
    <message>
        <source>Position in doubt</source>
        <translation>Position douteuse</translation>
    </message>
    <message>
        <source>Position in doubt: it may be wrong</source>
        <translation>Position douteuse&#xa0;: elle peut être fausse</translation>
    </message>
    <message>
        <source>Confirm the position</source>
        <translation>Confirmer la position</translation>
    </message>
    <message>
        <source>Position &amp;is right</source>
        <translation>La pos&amp;ition est exacte</translation>
    </message>
    <message>
        <source>The lowest position must be below the highest. The old value is kept.</source>
        <translation>La position minimale doit être inférieure à la position maximale. L’ancienne valeur est conservée.</translation>
    </message>
    <message>
        <source>Sets the lowest position to the present position.</source>
        <translation>Prend la position actuelle comme position minimale.</translation>
    </message>
    <message>
        <source>Sets the highest position to the present position.</source>
        <translation>Prend la position actuelle comme position maximale.</translation>
    </message>
    <message>
        <source>Confirms that the position is right: home is at position 0. Asks first.</source>
        <translation>Confirme que la position est exacte&#xa0;: l’origine est à la position 0. Demande d’abord confirmation.</translation>
    </message>
    <message>
        <source>Marks home as unknown. The travel limits are not in force until home is known again.</source>
        <translation>Marque l’origine comme inconnue. Les limites de course sont inactives jusqu’à ce que l’origine soit de nouveau connue.</translation>
    </message>
    <message>
        <source>With this backlash, no move can end at home: it would reverse beyond the limit. Move the limit away from home, or change the backlash or its direction.</source>
        <translation>Avec ce jeu, aucun déplacement ne peut finir à l’origine : il ferait demi-tour au-delà de la limite. Éloignez la limite de l’origine, ou modifiez le jeu ou son sens.</translation>
    </message>
    <message>
        <source>Arrival tolerance</source>
        <translation>Tolérance d’arrivée</translation>
    </message>
    <message>
        <source>Sequences, and programs that wait, go on when the motor has stayed this close to its goal for the time beside it. Empty: when it stands still.</source>
        <translation>Les séquences, et les programmes qui attendent, continuent lorsque le moteur est resté aussi près de sa cible pendant la durée indiquée à côté. Vide&#xa0;: lorsqu’il est à l’arrêt.</translation>
    </message>
    <message>
        <source>Time within the arrival tolerance</source>
        <translation>Durée dans la tolérance d’arrivée</translation>
    </message>
    <message>
        <source>How long the motor must stay within the tolerance.</source>
        <translation>Durée pendant laquelle le moteur doit rester dans la tolérance.</translation>
    </message>
    <message>
        <source>Arrival within</source>
        <translation>Arrivée à moins de</translation>
    </message>
    <message>
        <source>for</source>
        <translation>pendant</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerBar</name>
    <message>
        <source>Trigger on</source>
        <translation>Déclencher sur</translation>
    </message>
    <message>
        <source>The signal or status bit to wait for.</source>
        <translation>Signal ou bit d’état à attendre.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>The event to wait for.</source>
        <translation>Événement à attendre.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>The level for the event.</source>
        <translation>Niveau de l’événement.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Single: holds the first picture. Normal: shows picture after picture.</source>
        <translation>Monocoup&#xa0;: garde la première image. Normal&#xa0;: affiche image après image.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Share of the picture before the trigger, in percent.</source>
        <translation>Part de l’image avant le déclenchement, en pourcentage.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>State of the trigger</source>
        <translation>État du déclenchement</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Inactif</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Monocoup</translation>
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
        <translation>monte à</translation>
    </message>
    <message>
        <source>falls to</source>
        <translation>descend à</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>supérieur à</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>inférieur à</translation>
    </message>
    <message>
        <source>becomes 1</source>
        <translation>passe à 1</translation>
    </message>
    <message>
        <source>becomes 0</source>
        <translation>passe à 0</translation>
    </message>
    <message>
        <source>is 1</source>
        <translation>vaut 1</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>vaut 0</translation>
    </message>
    <message>
        <source>No module connected.</source>
        <translation>Aucun module connecté.</translation>
    </message>
    <message>
        <source>Choose a mode first.</source>
        <translation>Choisissez d’abord un mode.</translation>
    </message>
    <message>
        <source>Waits for the next trigger.</source>
        <translation>Attend le prochain déclenchement.</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerControl</name>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>triggered %1, more samples to come</source>
        <translation>déclenché à %1, suite à venir</translation>
    </message>
    <message>
        <source>triggered %1</source>
        <translation>déclenché à %1</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerRecords</name>
    <message>
        <source>Save each picture…</source>
        <translation>Enregistrer chaque image…</translation>
    </message>
    <message>
        <source>Save each picture</source>
        <translation>Enregistrer chaque image</translation>
    </message>
    <message>
        <source>Saves the samples of each picture to a folder that you choose.</source>
        <translation>Enregistre les échantillons de chaque image dans un dossier que vous choisissez.</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>Conserver les derniers</translation>
    </message>
    <message>
        <source>How many files are kept. Then the oldest is replaced.</source>
        <translation>Nombre de fichiers conservés. Ensuite, le plus ancien est remplacé.</translation>
    </message>
    <message>
        <source>Saved pictures</source>
        <translation>Images enregistrées</translation>
    </message>
    <message>
        <source>Save each picture to a folder</source>
        <translation>Enregistrer chaque image dans un dossier</translation>
    </message>
    <message>
        <source>%1 taken for %2</source>
        <translation>%1 prises pour %2</translation>
    </message>
</context>
<context>
    <name>nmc::TuningFiles</name>
    <message>
        <source>PIC-SERVO, version %1, address %2</source>
        <translation>PIC-SERVO, version %1, adresse %2</translation>
    </message>
    <message>
        <source>%1, %2 Bd</source>
        <translation>%1, %2&#xa0;Bd</translation>
    </message>
    <message>
        <source>Save the tuning report</source>
        <translation>Enregistrer le rapport de réglage</translation>
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
        <translation>Calculer l’unité</translation>
    </message>
    <message>
        <source>Type of axis</source>
        <translation>Type d’axe</translation>
    </message>
    <message>
        <source>rotary, in turns</source>
        <translation>rotatif, en tours</translation>
    </message>
    <message>
        <source>rotary, in degrees</source>
        <translation>rotatif, en degrés</translation>
    </message>
    <message>
        <source>linear, in millimetres</source>
        <translation>linéaire, en millimètres</translation>
    </message>
    <message>
        <source>The unit to display for this axis.</source>
        <translation>Unité d’affichage de cet axe.</translation>
    </message>
    <message>
        <source>The axis</source>
        <translation>L’axe</translation>
    </message>
    <message>
        <source>Full steps per motor turn</source>
        <translation>Pas entiers par tour moteur</translation>
    </message>
    <message>
        <source>200 for a motor with 1.8 degrees per step.</source>
        <translation>200 pour un moteur de 1,8 degré par pas.</translation>
    </message>
    <message>
        <source>Microsteps per full step</source>
        <translation>Micropas par pas entier</translation>
    </message>
    <message>
        <source>As set on the driver; 1 for full steps, 2 for half steps.</source>
        <translation>Comme réglé sur le driver&#x202f;; 1 pour des pas entiers, 2 pour des demi-pas.</translation>
    </message>
    <message>
        <source>Encoder lines per turn</source>
        <translation>Traits du codeur par tour</translation>
    </message>
    <message>
        <source>As on its label: lines, CPR or PPR. The chip counts four per line.</source>
        <translation>Comme sur son étiquette&#xa0;: traits, CPR ou PPR. La puce compte quatre incréments par trait.</translation>
    </message>
    <message>
        <source>Gear: motor turns</source>
        <translation>Réducteur&#xa0;: tours moteur</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 50; without a gear, 1.</source>
        <translation>Pour un réducteur 50&#xa0;: 1, saisissez 50&#x202f;; sans réducteur, 1.</translation>
    </message>
    <message>
        <source>Gear: output turns</source>
        <translation>Réducteur&#xa0;: tours de sortie</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 1.</source>
        <translation>Pour un réducteur 50&#xa0;: 1, saisissez 1.</translation>
    </message>
    <message>
        <source>Travel per output turn (mm)</source>
        <translation>Course par tour de sortie (mm)</translation>
    </message>
    <message>
        <source>Lead screw: pitch times starts. Belt: pulley teeth times belt pitch. Rack: pinion teeth times rack pitch.</source>
        <translation>Vis&#xa0;: pas fois nombre de filets. Courroie&#xa0;: dents de la poulie fois pas de la courroie. Crémaillère&#xa0;: dents du pignon fois pas de la crémaillère.</translation>
    </message>
    <message>
        <source>Calculated unit</source>
        <translation>Unité calculée</translation>
    </message>
    <message>
        <source>Use this unit</source>
        <translation>Utiliser cette unité</translation>
    </message>
    <message>
        <source>Enter a number above 0 in each field.</source>
        <translation>Saisissez un nombre supérieur à 0 dans chaque champ.</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>incréments</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>tour</translation>
    </message>
    <message>
        <source>1 %1 is %2 %3. The smallest step is %4 %5.</source>
        <translation>1 %1 vaut %2 %3. Le plus petit pas est de %4 %5.</translation>
    </message>
    <message>
        <source>Sets this unit for the axis. Keeps every physical value and sends nothing.</source>
        <translation>Définit cette unité pour l’axe. Conserve chaque valeur physique et n’envoie rien.</translation>
    </message>
</context>
<context>
    <name>nmc::WorkBox</name>
    <message>
        <source>Positions count from this work offset</source>
        <translation>Les positions sont comptées depuis ce décalage de travail</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Clear work offset: positions count by the counter</source>
        <translation>Effacer le décalage de travail&#xa0;: les positions suivent le compteur</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete work offset</source>
        <translation>Supprimer le décalage de travail</translation>
    </message>
    <message>
        <source>Count from</source>
        <translation>Compter depuis</translation>
    </message>
    <message>
        <source>Number for the present position</source>
        <translation>Nombre pour la position actuelle</translation>
    </message>
    <message>
        <source>What the present position is to be called, in the unit of the axis.</source>
        <translation>La valeur à donner à la position actuelle, dans l’unité de l’axe.</translation>
    </message>
    <message>
        <source>Name of the work offset</source>
        <translation>Nom du décalage de travail</translation>
    </message>
    <message>
        <source>The name by which you choose it later.</source>
        <translation>Le nom sous lequel vous le choisirez plus tard.</translation>
    </message>
    <message>
        <source>For example: fixture A</source>
        <translation>Par exemple&#xa0;: montage A</translation>
    </message>
    <message>
        <source>Call this position</source>
        <translation>Nommer cette position</translation>
    </message>
    <message>
        <source>Call this position: make a work offset</source>
        <translation>Nommer cette position&#xa0;: créer un décalage de travail</translation>
    </message>
    <message>
        <source>This position is</source>
        <translation>Cette position est</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first, and call its position then.</source>
        <translation>Le moteur est en mouvement. Arrêtez-le d’abord, puis nommez sa position.</translation>
    </message>
    <message>
        <source>Enter a name for the work offset, for example of a fixture.</source>
        <translation>Saisissez un nom pour le décalage de travail, par exemple celui d’un montage.</translation>
    </message>
    <message>
        <source>Another work offset of this axis has this name. Delete that one, or enter another name.</source>
        <translation>Un autre décalage de travail de cet axe porte ce nom. Supprimez-le ou saisissez un autre nom.</translation>
    </message>
    <message>
        <source>This axis has as many work offsets as it can have. Delete one first.</source>
        <translation>Cet axe a déjà le nombre maximal de décalages de travail. Supprimez-en un d’abord.</translation>
    </message>
    <message>
        <source>With this number, the work offset would be outside the position range.</source>
        <translation>Avec ce nombre, le décalage de travail serait hors de la plage des positions.</translation>
    </message>
    <message>
        <source>the counter</source>
        <translation>le compteur</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1&#xa0;: inconnu</translation>
    </message>
    <message>
        <source>Where the positions on the screen count from. Nothing moves, and nothing is sent.</source>
        <translation>D’où sont comptées les positions à l’écran. Rien ne bouge et rien n’est envoyé.</translation>
    </message>
    <message>
        <source>No work offset is in use.</source>
        <translation>Aucun décalage de travail n’est utilisé.</translation>
    </message>
    <message>
        <source>Positions count by the counter again. Nothing moves.</source>
        <translation>Les positions suivent de nouveau le compteur. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Choose the work offset first.</source>
        <translation>Choisissez d’abord le décalage de travail.</translation>
    </message>
    <message>
        <source>Deletes the work offset from the machine. Nothing moves.</source>
        <translation>Supprime le décalage de travail de la machine. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Positions then count from there. Nothing moves; counter and home stay.</source>
        <translation>Les positions sont alors comptées depuis là. Rien ne bouge&#xa0;; le compteur et l’origine restent.</translation>
    </message>
    <message>
        <source>Home is unknown: an offset lasts only until home or the counter changes, and is not kept.</source>
        <translation>L’origine est inconnue&#xa0;: un décalage ne dure que jusqu’à ce que l’origine ou le compteur change, et n’est pas conservé.</translation>
    </message>
</context>
<context>
    <name>nmc::XyDialog</name>
    <message>
        <source>One signal over another, between the cursors</source>
        <translation>Un signal en fonction d’un autre, entre les curseurs</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>&amp;Horizontal</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>&amp;Vertical</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 en fonction de %2</translation>
    </message>
</context>
<context>
    <name>nmc::XyPlot</name>
    <message>
        <source>One signal over another</source>
        <translation>Un signal en fonction d’un autre</translation>
    </message>
    <message>
        <source>Each sample of the vertical signal, over the value of the horizontal one at the same time. The dot marks the last one. Double-click to show everything. Scroll to zoom horizontally, or vertically with Ctrl; drag to pan.</source>
        <translation>Chaque échantillon du signal vertical, en fonction de la valeur du signal horizontal au même instant. Le point marque le dernier. Double-cliquez pour tout afficher. La molette zoome horizontalement, ou verticalement avec Ctrl&#xa0;; faites glisser pour déplacer la vue.</translation>
    </message>
</context>
</TS>
