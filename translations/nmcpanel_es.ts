<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>CommandLine</name>
    <message>
        <source>Control panel for Networked Modular Control motor modules.</source>
        <translation>Panel de control para módulos de motor Networked Modular Control (NMC).</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NOMBRE</translation>
    </message>
    <message>
        <source>Baud rate of the chain: 9600, 19200 (default), 57600 or 115200.</source>
        <translation>Velocidad en baudios de la cadena: 9600, 19200 (predeterminada), 57600 o 115200.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Connect to the built-in simulator at startup. CHAIN lists its modules, the one farthest from the host first; the default is %1.</source>
        <translation>Conectar al simulador integrado al iniciar. CADENA enumera sus módulos, primero el más alejado del PC; el valor predeterminado es %1.</translation>
    </message>
    <message>
        <source>CHAIN</source>
        <translation>CADENA</translation>
    </message>
    <message>
        <source>List the serial ports of this computer.</source>
        <translation>Mostrar los puertos serie de este equipo.</translation>
    </message>
    <message>
        <source>Show this help.</source>
        <translation>Mostrar esta ayuda.</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>Mostrar la versión.</translation>
    </message>
    <message>
        <source>Allow control lines to inject faults into the built-in simulator.</source>
        <translation>Permitir que las líneas de control provoquen fallos en el simulador integrado.</translation>
    </message>
    <message>
        <source>With --port or --simulator: connect read-only. Only status requests are sent, and closing does not stop motors. STOP ALL still works.</source>
        <translation>Con --port o --simulator: conectar en solo lectura. Solo se envían consultas de estado, y al cerrar no se paran los motores. PARAR TODO sigue funcionando.</translation>
    </message>
    <message>
        <source>Machine file to open at startup.</source>
        <translation>Archivo de máquina que se abre al iniciar.</translation>
    </message>
    <message>
        <source>Let other programs in from the start. With =control, one of them may move motors without the user being asked.</source>
        <translation>Dejar entrar a otros programas desde el inicio. Con =control, uno de ellos puede mover motores sin preguntar.</translation>
    </message>
    <message>
        <source>Connect to a serial port at startup, or to one at a device server: tcp://HOST:PORT or rfc2217://HOST:PORT.</source>
        <translation>Conectarse al iniciar a un puerto serie, o al de un servidor de dispositivos: tcp://HOST:PORT o rfc2217://HOST:PORT.</translation>
    </message>
</context>
<context>
    <name>Common</name>
    <message>
        <source>%1 of %2 modules answered.</source>
        <translation>Respondieron %1 de %2 módulos.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupo %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudios</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>Puntos y secuencias</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Travel and speed limits</source>
        <translation>Límites de recorrido y velocidad</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Holgura</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenciado</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>Parada por límite</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>Tiempo de aceleración</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Ganancias</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Cómo</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Home all</source>
        <translation>Referenciar todo</translation>
    </message>
    <message>
        <source>limit 1</source>
        <translation>final de carrera 1</translation>
    </message>
    <message>
        <source>limit 2</source>
        <translation>final de carrera 2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>STOP ALL</source>
        <translation>PARAR TODO</translation>
    </message>
    <message>
        <source>Motor off</source>
        <translation>Apagar motor</translation>
    </message>
    <message>
        <source>Connect fully</source>
        <translation>Conexión completa</translation>
    </message>
    <message>
        <source>steps/s</source>
        <translation>pasos/s</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>vueltas</translation>
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
        <translation>Error de posición</translation>
    </message>
    <message>
        <source>E-stop input</source>
        <translation>Entrada E-Stop</translation>
    </message>
    <message>
        <source>The motor holds its position.</source>
        <translation>El motor mantiene su posición.</translation>
    </message>
    <message>
        <source>The motor follows the points of a path.</source>
        <translation>El motor sigue los puntos de una trayectoria.</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>Simulador</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>pasos</translation>
    </message>
    <message>
        <source>No module</source>
        <translation>Ningún módulo</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
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
        <translation>◂| Paso</translation>
    </message>
    <message>
        <source>Step |▸</source>
        <translation>Paso |▸</translation>
    </message>
    <message>
        <source>Moves forward while held, then stops.</source>
        <translation>Se mueve hacia adelante mientras se mantiene pulsado y después se detiene.</translation>
    </message>
    <message>
        <source>Moves in reverse while held, then stops.</source>
        <translation>Se mueve hacia atrás mientras se mantiene pulsado y después se detiene.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Cadena</translation>
    </message>
    <message>
        <source>&amp;Scan again</source>
        <translation>Volver a bu&amp;scar</translation>
    </message>
    <message>
        <source>Resets every module and assigns new addresses. Asks first.</source>
        <translation>Reinicia todos los módulos y asigna nuevas direcciones. Pregunta antes.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texto (*.txt)</translation>
    </message>
    <message>
        <source>Open machine</source>
        <translation>Abrir máquina</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>ended at %1</source>
        <translation>terminó: %1</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Todos los tipos</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>Todos los módulos</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>Vel. de jog máx.</translation>
    </message>
    <message>
        <source>The value at an A/D reading of 0.</source>
        <translation>El valor con una lectura A/D de 0.</translation>
    </message>
    <message>
        <source>The module received a garbled command and did not carry it out.</source>
        <translation>El módulo recibió un comando corrupto y no lo ejecutó.</translation>
    </message>
    <message>
        <source>Limit switch 1.</source>
        <translation>Final de carrera 1.</translation>
    </message>
    <message>
        <source>Limit switch 2.</source>
        <translation>Final de carrera 2.</translation>
    </message>
    <message>
        <source>Waiting for the home position.</source>
        <translation>Esperando la posición de referencia.</translation>
    </message>
    <message>
        <source>Save as home</source>
        <translation>Guardar como referencia</translation>
    </message>
    <message>
        <source>Save as home: the present position</source>
        <translation>Guardar como referencia: la posición actual</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Byte de estado</translation>
    </message>
    <message>
        <source>Home register</source>
        <translation>Registro de referencia</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>En bruto</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>estado %1</translation>
    </message>
    <message>
        <source>Saves the present position as home. The motor does not move.</source>
        <translation>Guarda la posición actual como referencia. El motor no se mueve.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activo</translation>
    </message>
    <message>
        <source>off</source>
        <translation>inactivo</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>Trayectoria rápida</translation>
    </message>
    <message>
        <source>Amplifier</source>
        <translation>Amplificador</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>PWM value</source>
        <translation>Valor de PWM</translation>
    </message>
    <message>
        <source>Abruptly</source>
        <translation>Bruscamente</translation>
    </message>
    <message>
        <source>Smoothly</source>
        <translation>Suavemente</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Índice</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Límite de corriente</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Jog</translation>
    </message>
    <message>
        <source>Start&amp;ing values</source>
        <translation>Valores i&amp;niciales</translation>
    </message>
    <message>
        <source>Starting values: fill in</source>
        <translation>Valores iniciales: rellenar</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Salidas</translation>
    </message>
    <message>
        <source>State of the selected module</source>
        <translation>Estado del módulo seleccionado</translation>
    </message>
    <message>
        <source>%1, address %2</source>
        <translation>%1, dirección %2</translation>
    </message>
    <message>
        <source>Pages of the module</source>
        <translation>Páginas del módulo</translation>
    </message>
    <message>
        <source>A/D and PWM</source>
        <translation>A/D y PWM</translation>
    </message>
    <message>
        <source>A/D input</source>
        <translation>Entrada A/D</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Nombre de %1</translation>
    </message>
    <message>
        <source>Off at stop</source>
        <translation>Apagar al parar</translation>
    </message>
    <message>
        <source>%1 of 255</source>
        <translation>%1 de 255</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? desconocido</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pines</translation>
    </message>
    <message>
        <source>input</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>high</source>
        <translation>alto</translation>
    </message>
    <message>
        <source>low</source>
        <translation>bajo</translation>
    </message>
    <message>
        <source>Switches this output at once.</source>
        <translation>Conmuta esta salida de inmediato.</translation>
    </message>
    <message>
        <source>A search for home is running.</source>
        <translation>Hay una búsqueda de referencia en curso.</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>Interruptor de referencia</translation>
    </message>
    <message>
        <source>Limit 1</source>
        <translation>Final 1</translation>
    </message>
    <message>
        <source>Limit 2</source>
        <translation>Final 2</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Límite de tiempo</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Alimentación del motor</translation>
    </message>
    <message>
        <source>A/D</source>
        <translation>A/D</translation>
    </message>
    <message>
        <source>Goal position</source>
        <translation>Posición de destino</translation>
    </message>
    <message>
        <source>The goal position</source>
        <translation>La posición de destino</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>Use nearest</source>
        <translation>Usar más próxima</translation>
    </message>
    <message>
        <source>Use nearest allowed position</source>
        <translation>Usar más próxima de las posiciones permitidas</translation>
    </message>
    <message>
        <source>Zero here: set the present position to 0</source>
        <translation>Cero aquí: poner la posición actual a 0</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Ir a referencia</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Cargar</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>Despla&amp;zar</translation>
    </message>
    <message>
        <source>Go to the position</source>
        <translation>Desplazar a la posición</translation>
    </message>
    <message>
        <source>Run &amp;reverse</source>
        <translation>At&amp;rás</translation>
    </message>
    <message>
        <source>Run reverse until stopped</source>
        <translation>Atrás: marcha hasta la orden de parada</translation>
    </message>
    <message>
        <source>R&amp;un forward</source>
        <translation>Ad&amp;elante</translation>
    </message>
    <message>
        <source>Run forward until stopped</source>
        <translation>Adelante: marcha hasta la orden de parada</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message>
        <source>Sets the goal to the nearest allowed position. Nothing moves.</source>
        <translation>Pone como destino la posición permitida más próxima. Nada se mueve.</translation>
    </message>
    <message>
        <source>Moves to the position, then holds.</source>
        <translation>Va a la posición y después la mantiene.</translation>
    </message>
    <message>
        <source>Runs forward until stopped.</source>
        <translation>Gira hacia adelante hasta que se le ordene parar.</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped.</source>
        <translation>Gira hacia atrás hasta que se le ordene parar.</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>Corriente del motor</translation>
    </message>
    <message>
        <source>Motor off: this module</source>
        <translation>Apagar motor: este módulo</translation>
    </message>
    <message>
        <source>A/D %1</source>
        <translation>A/D %1</translation>
    </message>
    <message>
        <source>Switches servo and amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Apaga el servo y el amplificador: el motor puede girar libremente y una carga puede caer.</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experto</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>A/D (temperature)</source>
        <translation>A/D (temperatura)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation>Nada que deshacer.</translation>
    </message>
    <message>
        <source>Nothing to redo.</source>
        <translation>Nada que rehacer.</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Velocidad máxima</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Respuesta en frecuencia</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exportar CSV…</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Square wave</source>
        <translation>Onda cuadrada</translation>
    </message>
    <message>
        <source>Method: how the command jumps</source>
        <translation>Forma: cómo salta la consigna</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Rise %1</source>
        <translation>Subida %1</translation>
    </message>
    <message>
        <source>Overshoot %1</source>
        <translation>Sobreimpulso %1</translation>
    </message>
    <message>
        <source>Steady-state error %1</source>
        <translation>Error estacionario %1</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Respuesta al escalón</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
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
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Sobreimpulso</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Módulo</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Cursor readings</source>
        <translation>Lecturas de los cursores</translation>
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
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursores</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>I&amp;magen (PNG)…</translation>
    </message>
    <message>
        <source>The visible plot as an image.</source>
        <translation>La gráfica visible como imagen.</translation>
    </message>
    <message>
        <source>&amp;Vector picture (SVG)…</source>
        <translation>Imagen &amp;vectorial (SVG)…</translation>
    </message>
    <message>
        <source>The visible plot as lines that stay sharp at any size.</source>
        <translation>La gráfica visible en líneas nítidas a cualquier tamaño.</translation>
    </message>
    <message>
        <source>P&amp;age (PDF)…</source>
        <translation>Págin&amp;a (PDF)…</translation>
    </message>
    <message>
        <source>The visible plot on a page for printing or a report.</source>
        <translation>La gráfica visible en una página para imprimir o para un informe.</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>Imp&amp;rimir…</translation>
    </message>
    <message>
        <source>Prints the visible plot on one of this computer&apos;s printers.</source>
        <translation>Imprime la gráfica visible en una de las impresoras de este equipo.</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copiar imagen</translation>
    </message>
    <message>
        <source>SIMULATOR, no real motor moved</source>
        <translation>SIMULADOR, no se movió ningún motor real</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Archivos %1 (*.%2)</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Disparo</translation>
    </message>
    <message>
        <source>NMC Panel %1</source>
        <translation>NMC Panel %1</translation>
    </message>
    <message>
        <source>Overlay: %1</source>
        <translation>Superposición: %1</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Osciloscopio</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>de 255</translation>
    </message>
    <message>
        <source>Opens the port and looks for modules. Nothing moves.</source>
        <translation>Abre el puerto y busca módulos. Nada se mueve.</translation>
    </message>
    <message>
        <source>goes to all modules</source>
        <translation>va a todos los módulos</translation>
    </message>
    <message>
        <source>Operator mode</source>
        <translation>Modo operador</translation>
    </message>
    <message>
        <source>Asks for the PIN.</source>
        <translation>Pide el PIN.</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Llegada</translation>
    </message>
    <message>
        <source>Work offsets</source>
        <translation>Desplazamientos de trabajo</translation>
    </message>
    <message>
        <source>waits for the port</source>
        <translation>espera al puerto</translation>
    </message>
    <message>
        <source>A sequence is already running.</source>
        <translation>Ya hay una secuencia en ejecución.</translation>
    </message>
    <message>
        <source>Its name on this machine. Sends nothing.</source>
        <translation>Su nombre en esta máquina. No envía nada.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation>Otros programas</translation>
    </message>
</context>
<context>
    <name>Gains</name>
    <message>
        <source>Position gain</source>
        <translation>Ganancia de posición</translation>
    </message>
    <message>
        <source>Derivative gain</source>
        <translation>Ganancia derivativa</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>Ganancia integral</translation>
    </message>
    <message>
        <source>Integration limit</source>
        <translation>Límite de integración</translation>
    </message>
    <message>
        <source>Output limit</source>
        <translation>Límite de salida</translation>
    </message>
    <message>
        <source>Position error limit</source>
        <translation>Límite de error</translation>
    </message>
    <message>
        <source>Servo rate divisor</source>
        <translation>Divisor de ciclo</translation>
    </message>
    <message>
        <source>Deadband compensation</source>
        <translation>Banda muerta</translation>
    </message>
    <message>
        <source>Kp, position gain: output per count of position error. Set Kd first; then raise Kp with small, fast test moves until the motor starts to overshoot, and back off a little.</source>
        <translation>Kp, ganancia de posición: salida por cada cuenta de error de posición. Ajuste primero Kd; después aumente Kp con movimientos de prueba cortos y rápidos hasta que el motor empiece a sobreoscilar, y redúzcala un poco.</translation>
    </message>
    <message>
        <source>Kd, derivative gain: damping. Start here, with Kp and Ki at 0: raise Kd until the motor starts to hum, then back off a little.</source>
        <translation>Kd, ganancia derivativa: amortiguación. Empiece aquí, con Kp y Ki en 0: aumente Kd hasta que el motor empiece a zumbar y redúzcala un poco.</translation>
    </message>
    <message>
        <source>Ki, integral gain: removes the steady-state error that Kp and Kd leave. Set IL to 16000 first, then raise Ki until the error settles fast enough. Adds some overshoot.</source>
        <translation>Ki, ganancia integral: elimina el error estacionario que dejan Kp y Kd. Ponga primero IL en 16000 y después aumente Ki hasta que el error desaparezca con suficiente rapidez. Añade algo de sobreimpulso.</translation>
    </message>
    <message>
        <source>IL, integration limit: limits the integral of the error. Last, lower it to the smallest value that still removes the steady-state error. 0 clears the integral.</source>
        <translation>IL, límite de integración: limita la integral del error. Al final, redúzcalo al menor valor que aún elimine el error estacionario. 0 borra la integral.</translation>
    </message>
    <message>
        <source>OL, output limit: the largest PWM value; 255 is 100 %. Use 127 for a 12 V motor on a 24 V supply.</source>
        <translation>OL, límite de salida: el mayor valor de PWM; 255 equivale al 100 %. Use 127 para un motor de 12 V con alimentación de 24 V.</translation>
    </message>
    <message>
        <source>CL, current limit, compared with the A/D value. 0: off. Odd: limits while the A/D value is above CL. Even: limits while it is below CL.</source>
        <translation>CL, límite de corriente; se compara con el valor A/D. 0: inactivo. Impar: limita mientras el valor A/D está por encima de CL. Par: limita mientras está por debajo de CL.</translation>
    </message>
    <message>
        <source>EL, position error limit in counts: the servo switches off when the error exceeds it, for example after a collision or a stall.</source>
        <translation>EL, límite de error de posición en cuentas: el servo se apaga cuando el error lo supera, por ejemplo tras una colisión o un bloqueo.</translation>
    </message>
    <message>
        <source>SR, servo rate divisor: one servo tick is SR × 0.512 ms. A slower rate damps heavy loads with less Kd. Changing SR changes the meaning of every velocity and acceleration.</source>
        <translation>SR, divisor del ciclo de servo: un ciclo de servo dura SR x 0,512 ms. Un ciclo más lento amortigua cargas pesadas con menos Kd. Cambiar SR cambia el significado de todas las velocidades y aceleraciones.</translation>
    </message>
    <message>
        <source>DB, deadband compensation: added to every PWM value except 0, for amplifiers with a deadband near zero. Version 4 and later.</source>
        <translation>DB, compensación de banda muerta: se suma a todos los valores de PWM excepto 0, para amplificadores con banda muerta cerca de cero. A partir de la versión 4.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>A/D above</source>
        <translation>A/D mayor</translation>
    </message>
    <message>
        <source>A/D below</source>
        <translation>A/D menor</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 a %3</translation>
    </message>
</context>
<context>
    <name>LoopTestTexts</name>
    <message numerus="yes">
        <source>%n frequencies up to %1 Hz</source>
        <translation>
            <numerusform>%n frecuencia hasta %1 Hz</numerusform>
            <numerusform>%n frecuencias hasta %1 Hz</numerusform>
        </translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) %1 Hz</source>
        <translation>Ancho de banda (-3 dB) %1 Hz</translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) not reached</source>
        <translation>Ancho de banda (-3 dB) no alcanzado</translation>
    </message>
    <message>
        <source>Resonance %1 dB</source>
        <translation>Resonancia %1 dB</translation>
    </message>
    <message>
        <source>Phase margin %1° at %2 Hz</source>
        <translation>Margen de fase %1° a %2 Hz</translation>
    </message>
    <message>
        <source>Phase margin not reached</source>
        <translation>Margen de fase no alcanzado</translation>
    </message>
    <message>
        <source>Gain margin %1</source>
        <translation>Margen de ganancia %1</translation>
    </message>
    <message>
        <source>Gain margin not reached</source>
        <translation>Margen de ganancia no alcanzado</translation>
    </message>
    <message>
        <source>Edit the gains to see what this loop would do with them.</source>
        <translation>Edite las ganancias para ver qué haría este lazo con ellas.</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: OL or IL cut off the filter&apos;s output while measuring. Use a smaller amplitude.</source>
        <translation>Desconocido para las ganancias de los campos: OL o IL limitó la salida del filtro durante la medición. Use una amplitud menor.</translation>
    </message>
    <message>
        <source>OL or IL cut off the filter&apos;s output while measuring: for small motions, the loop responds differently. Use a smaller amplitude or a lower speed.</source>
        <translation>OL o IL limitó la salida del filtro durante la medición: con movimientos pequeños, el lazo responde de otro modo. Use una amplitud o una velocidad menor.</translation>
    </message>
    <message>
        <source>unstable, the motor would oscillate</source>
        <translation>inestable, el motor oscilaría</translation>
    </message>
    <message>
        <source>known only from %1 to %2 Hz</source>
        <translation>conocido solo de %1 a %2 Hz</translation>
    </message>
    <message>
        <source>With the gains in the fields: %1</source>
        <translation>Con las ganancias de los campos: %1</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: SR differs from that of the measurement.</source>
        <translation>Desconocido para las ganancias de los campos: SR difiere del de la medición.</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: DB differs from that of the measurement.</source>
        <translation>Desconocido para las ganancias de los campos: DB difiere del de la medición.</translation>
    </message>
    <message>
        <source>known only at %1 Hz</source>
        <translation>conocido solo a %1 Hz</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>About NMC Panel</source>
        <translation>Acerca de NMC Panel</translation>
    </message>
    <message>
        <source>A control panel for PIC-SERVO, PIC-STEP and PIC-I/O modules on one serial line.

Free software under the GNU General Public License, version 3 or later. Icons: Tabler, MIT licence. Built with Qt %1.</source>
        <translation>Panel de control para módulos PIC-SERVO, PIC-STEP y PIC-I/O en una línea serie.

Software libre con licencia GNU General Public License, versión 3 o posterior. Iconos: Tabler, licencia MIT. Desarrollado con Qt %1.</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Seguridad</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Restablecer disposición</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>&amp;Safety</source>
        <translation>&amp;Seguridad</translation>
    </message>
    <message>
        <source>&amp;About NMC Panel</source>
        <translation>&amp;Acerca de NMC Panel</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>&amp;Buscar un comando…</translation>
    </message>
    <message>
        <source>Colour&amp;s</source>
        <translation>Co&amp;lores</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>The new language takes effect the next time you start NMC Panel.</source>
        <translation>El nuevo idioma se aplicará la próxima vez que inicie NMC Panel.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Sistema</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>Atajos de &amp;teclado</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>&amp;Informar de un problema…</translation>
    </message>
</context>
<context>
    <name>MessageLines</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n vez</numerusform>
            <numerusform>%n veces</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Terminó: %1</translation>
    </message>
</context>
<context>
    <name>ModelTexts</name>
    <message>
        <source>Gain %1</source>
        <translation>Ganancia %1</translation>
    </message>
    <message>
        <source>counts/s per PWM count</source>
        <translation>cuentas/s por unidad de PWM</translation>
    </message>
    <message>
        <source>Time constant %1</source>
        <translation>Constante de tiempo %1</translation>
    </message>
    <message>
        <source>Friction %1</source>
        <translation>Rozamiento %1</translation>
    </message>
    <message>
        <source>of 255 PWM</source>
        <translation>de 255 de PWM</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>Carga %1</translation>
    </message>
    <message>
        <source>Model error %1 counts RMS; encoder and timing account for %2.</source>
        <translation>Error del modelo: %1 cuentas RMS; el encoder y la temporización explican %2.</translation>
    </message>
    <message>
        <source>Too few samples. Record for longer, or raise the baud rate.</source>
        <translation>Hay muy pocas muestras. Grabe durante más tiempo o aumente la velocidad en baudios.</translation>
    </message>
    <message>
        <source>The shaft did not move. Check motor power and brake, or use a larger step.</source>
        <translation>El eje del motor no se movió. Compruebe la alimentación del motor y el freno, o use un escalón mayor.</translation>
    </message>
    <message>
        <source>The shaft moved away from its goal. Check the direction on the Axis page.</source>
        <translation>El motor se alejó de su destino. Compruebe el sentido en la página Eje.</translation>
    </message>
    <message>
        <source>The motor keeps oscillating. Lower Kp or raise Kd, then step again.</source>
        <translation>El motor no deja de oscilar. Reduzca Kp o aumente Kd y repita el escalón.</translation>
    </message>
    <message>
        <source>The model does not fit the step. Check for backlash, an elastic belt, a hard stop or a current limit.</source>
        <translation>El modelo no se ajusta al escalón. Compruebe si hay holgura, una correa elástica, un tope mecánico o un límite de corriente.</translation>
    </message>
    <message>
        <source>These steps do not determine the motor gain. Add a larger step, so that the motor gets close to a steady speed.</source>
        <translation>Estos escalones no determinan la ganancia del motor. Añada uno mayor, para que el motor se acerque a una velocidad constante.</translation>
    </message>
    <message>
        <source>These steps do not determine the time constant. Repeat the step, or raise the baud rate.</source>
        <translation>Estos escalones no determinan la constante de tiempo. Repita el escalón o aumente la velocidad en baudios.</translation>
    </message>
    <message>
        <source>Overshoot %1, settling %2</source>
        <translation>Sobreimpulso %1, establecimiento %2</translation>
    </message>
    <message>
        <source>Steady-state error %1 counts</source>
        <translation>Error estacionario %1 cuentas</translation>
    </message>
    <message>
        <source>Phase margin %1°, gain margin %2</source>
        <translation>Margen de fase %1°, margen de ganancia %2</translation>
    </message>
    <message>
        <source>Phase margin %1°</source>
        <translation>Margen de fase %1°</translation>
    </message>
    <message>
        <source>Uncertain: step once more. Until then the suggested gains are conservative.</source>
        <translation>Incierto: haga un escalón más. Hasta entonces, las ganancias propuestas son prudentes.</translation>
    </message>
    <message>
        <source>The motor stopped abruptly short of its goal. Something is in its way: a hard stop, or its load. Clear the way, or step in the other direction.</source>
        <translation>El motor se detuvo en seco antes de su destino. Algo le estorba: un tope o lo que mueve. Despeje el recorrido o haga el escalón en el otro sentido.</translation>
    </message>
    <message>
        <source>In %1 of 100 cases the motor stops too far from its goal.</source>
        <translation>En %1 de cada 100 casos, el motor se detiene demasiado lejos de su destino.</translation>
    </message>
    <message>
        <source>Amplifier deadband %1</source>
        <translation>Banda muerta del amplificador %1</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>Holgura %1</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>cuentas</translation>
    </message>
    <message>
        <source>A resonance above %1 Hz would not show; the margins allow for one.</source>
        <translation>Una resonancia por encima de %1 Hz no se vería; los márgenes la tienen en cuenta.</translation>
    </message>
    <message>
        <source>The motor probably has more than %1 counts of play: that much motion is lost at each reversal. Take up the play between motor and encoder.</source>
        <translation>El motor tiene probablemente más de %1 cuentas de holgura: es lo que se pierde al cambiar de sentido. Elimine la holgura entre motor y encoder.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>%1 counts, %2</source>
        <translation>%1 cuentas, %2</translation>
    </message>
    <message>
        <source>Settling to ±%1 %: %2</source>
        <translation>Establecimiento en ±%1 %: %2</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Ajuste de %1</translation>
    </message>
    <message>
        <source>simulated; no real motor moved</source>
        <translation>simulado; no se movió ningún motor real</translation>
    </message>
    <message>
        <source>Speed while measuring %1 counts/s</source>
        <translation>Velocidad durante la medición %1 cuentas/s</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>%1 counts in %2 s</source>
        <translation>%1 cuentas en %2 s</translation>
    </message>
    <message>
        <source>Settling to ±%1 counts for %2 s: %3</source>
        <translation>Establecimiento a ±%1 cuentas durante %2 s: %3</translation>
    </message>
    <message>
        <source>Peak error %1</source>
        <translation>Error máximo %1</translation>
    </message>
    <message>
        <source>RMS error %1</source>
        <translation>Error eficaz %1</translation>
    </message>
</context>
<context>
    <name>ResponseTexts</name>
    <message>
        <source>too few samples</source>
        <translation>muy pocas muestras</translation>
    </message>
    <message>
        <source>did not reach 90 %</source>
        <translation>no alcanzó el 90 %</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>no grabado</translation>
    </message>
    <message>
        <source>Very fast profile</source>
        <translation>Perfil muy rápido</translation>
    </message>
    <message>
        <source>Stop here, at the goal</source>
        <translation>Parar aquí, en el destino</translation>
    </message>
    <message>
        <source>A move with velocity and acceleration so high that its profile reaches the goal in one servo tick. CMC and SC stop here, at the goal, instead.</source>
        <translation>Un movimiento con tanta velocidad y aceleración que el perfil llega al destino en un solo ciclo. CMC y SC, en cambio, paran aquí, en el destino.</translation>
    </message>
    <message>
        <source>The servo holds the goal at once, without a profile. Not available with version 1.</source>
        <translation>El servo mantiene el destino de inmediato, sin perfil. No disponible en la versión 1.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>limited to %1</source>
        <translation>limitado a %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>al menos %1</translation>
    </message>
    <message>
        <source>samples missing, repeat</source>
        <translation>faltan muestras; repítalo</translation>
    </message>
    <message>
        <source>%1, off its goal</source>
        <translation>%1, fuera de su destino</translation>
    </message>
    <message>
        <source>never constant</source>
        <translation>nunca constante</translation>
    </message>
    <message>
        <source>Profiled move</source>
        <translation>Movimiento con perfil</translation>
    </message>
    <message>
        <source>No step: moves there and back with the velocity and acceleration below, judged by a window and a dwell. Not available with version 1.</source>
        <translation>Sin escalón: movimientos de ida y vuelta con la velocidad y la aceleración de abajo, evaluados con una ventana y una permanencia. No disponible con la versión 1.</translation>
    </message>
    <message>
        <source>%1 of %2 settled</source>
        <translation>%1 de %2 establecidos</translation>
    </message>
    <message>
        <source>%1 to %2 ms (%3)</source>
        <translation>de %1 a %2 ms (%3)</translation>
    </message>
</context>
<context>
    <name>Scope</name>
    <message>
        <source>%1, by %2</source>
        <translation>%1, de %2</translation>
    </message>
    <message>
        <source>From %1; 0 s is %2</source>
        <translation>Desde %1; 0 s es %2</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Reducir</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Go to live</source>
        <translation>Ir al presente</translation>
    </message>
    <message>
        <source>Values up</source>
        <translation>Subir valores</translation>
    </message>
    <message>
        <source>Values down</source>
        <translation>Bajar valores</translation>
    </message>
    <message>
        <source>Zoom values in</source>
        <translation>Ampliar valores</translation>
    </message>
    <message>
        <source>Zoom values out</source>
        <translation>Reducir valores</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>Ajustar valores</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>command, calculated</source>
        <translation>consigna, calculada</translation>
    </message>
    <message>
        <source>error, calculated</source>
        <translation>error, calculado</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>aceleración</translation>
    </message>
    <message>
        <source>PWM, calculated</source>
        <translation>PWM, calculado</translation>
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
        <translation>recuento</translation>
    </message>
    <message>
        <source>count rate</source>
        <translation>tasa de recuento</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>cuentas</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>cuentas/s</translation>
    </message>
    <message>
        <source>One row per reply, can be reopened here (*.csv)</source>
        <translation>Una fila por respuesta, se puede volver a abrir aquí (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, for other programs only (*.csv)</source>
        <translation>Una columna por señal, solo para otros programas (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, every millisecond, for other programs only (*.csv)</source>
        <translation>Una columna por señal, cada milisegundo, solo para otros programas (*.csv)</translation>
    </message>
    <message>
        <source>custom trace %1</source>
        <translation>traza propia %1</translation>
    </message>
    <message>
        <source>error, reported</source>
        <translation>error, comunicado</translation>
    </message>
</context>
<context>
    <name>StepperWords</name>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 pasos/s</translation>
    </message>
    <message>
        <source>%1x: %2 to %3 steps/s</source>
        <translation>%1x: de %2 a %3 pasos/s</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2, the minimum profile speed.</source>
        <translation>Marcha a %1: velocidad %2, la mínima del perfil.</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2 of 250.</source>
        <translation>Marcha a %1: velocidad %2 de 250.</translation>
    </message>
    <message>
        <source>Runs at %1: timer count %2.</source>
        <translation>Marcha a %1: valor del temporizador %2.</translation>
    </message>
    <message>
        <source>%1 steps/s²</source>
        <translation>%1 pasos/s²</translation>
    </message>
    <message>
        <source>The motor is already there.</source>
        <translation>El motor ya está ahí.</translation>
    </message>
    <message>
        <source>Takes %1 s. Too short for that speed: peaks at %2.</source>
        <translation>Tarda %1 s. Demasiado corto para esa velocidad: llega como máximo a %2.</translation>
    </message>
    <message>
        <source>Takes %1 s, peak speed %2.</source>
        <translation>Tarda %1 s, velocidad máxima %2.</translation>
    </message>
    <message>
        <source>Ramp of %1.</source>
        <translation>Rampa de %1.</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>error, zoomed (%1)</source>
        <translation>error, ampliado (%1)</translation>
    </message>
    <message>
        <source>PWM, calculated (of 255)</source>
        <translation>PWM, calculado (de 255)</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Port &quot;%1&quot; not found. Only the simulator is available: --simulator.</source>
        <translation>No se encontró el puerto “%1”. Solo está disponible el simulador: --simulator.</translation>
    </message>
    <message>
        <source>Port &quot;%1&quot; not found. Available ports: %2.</source>
        <translation>No se encontró el puerto “%1”. Puertos disponibles: %2.</translation>
    </message>
    <message>
        <source>These modules do not support the baud rate &quot;%1&quot;. Use %2.</source>
        <translation>Estos módulos no admiten la velocidad en baudios “%1”. Use %2.</translation>
    </message>
    <message>
        <source>The simulator does not understand the chain &quot;%1&quot;: %2 An example: --simulator=servo,servo@1</source>
        <translation>El simulador no entiende la cadena “%1”: %2 Un ejemplo: --simulator=servo,servo@1</translation>
    </message>
    <message>
        <source>Unknown option &quot;%1&quot;. Use --help for a list.</source>
        <translation>Opción desconocida “%1”. Use --help para ver la lista.</translation>
    </message>
    <message>
        <source>No display found: neither DISPLAY nor WAYLAND_DISPLAY is set.</source>
        <translation>No se encontró ninguna pantalla: no están definidas DISPLAY ni WAYLAND_DISPLAY.</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Volver a buscar</translation>
    </message>
    <message>
        <source>Use simulator</source>
        <translation>Usar simulador</translation>
    </message>
    <message>
        <source>Choose another port</source>
        <translation>Elegir otro puerto</translation>
    </message>
    <message>
        <source>Motor state unknown; no motor was moving when last seen.</source>
        <translation>Estado de los motores desconocido; ninguno se movía en la última lectura.</translation>
    </message>
    <message>
        <source>Your user account has no permission to use %1.</source>
        <translation>Su cuenta de usuario no puede usar %1.</translation>
    </message>
    <message>
        <source>Ask your system administrator for access.</source>
        <translation>Pida acceso al administrador del sistema.</translation>
    </message>
    <message>
        <source>It belongs to the group %1. Run %2, then log out and in again.</source>
        <translation>Pertenece al grupo %1. Ejecute %2, cierre la sesión y vuelva a iniciarla.</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Copiar comando</translation>
    </message>
    <message>
        <source>%1 is used by another program.</source>
        <translation>Otro programa está usando %1.</translation>
    </message>
    <message>
        <source>Close it and try again.</source>
        <translation>Ciérrelo e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Close it and try again. Or use nmcctl through it: in its Chain menu, switch on &quot;Let programs in&quot;, and leave out --port.</source>
        <translation>Ciérrelo e inténtelo de nuevo. O use nmcctl a través de él: en su menú Cadena, active «Dejar entrar programas» y omita --port.</translation>
    </message>
    <message>
        <source>%1 not found.</source>
        <translation>No se encontró %1.</translation>
    </message>
    <message>
        <source>Check that the adapter is plugged in. Its name may have changed.</source>
        <translation>Compruebe que el adaptador está conectado. Su nombre puede haber cambiado.</translation>
    </message>
    <message>
        <source>%1 is not a serial port.</source>
        <translation>%1 no es un puerto serie.</translation>
    </message>
    <message>
        <source>Choose the adapter&apos;s port, for example /dev/ttyUSB0.</source>
        <translation>Elija el puerto del adaptador, por ejemplo /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>%1 does not support the selected baud rate.</source>
        <translation>%1 no admite la velocidad en baudios elegida.</translation>
    </message>
    <message>
        <source>Choose another baud rate; every adapter supports 19 200 Bd.</source>
        <translation>Elija otra velocidad en baudios; todos los adaptadores admiten 19 200 Bd.</translation>
    </message>
    <message>
        <source>The adapter at %1 was unplugged. %2</source>
        <translation>Se desconectó el adaptador de %1. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then plug the adapter in again.</source>
        <translation>Use la parada por hardware si es necesario y vuelva a conectar el adaptador.</translation>
    </message>
    <message>
        <source>Could not open %1.</source>
        <translation>No se pudo abrir %1.</translation>
    </message>
    <message>
        <source>System message: %1</source>
        <translation>Mensaje del sistema: %1</translation>
    </message>
    <message>
        <source>Not every module answered at %1 Bd, so the modules cannot be used yet.</source>
        <translation>No todos los módulos respondieron a %1 Bd, por lo que aún no se pueden usar.</translation>
    </message>
    <message>
        <source>Module %1 did not answer at %2 Bd, so the modules cannot be used yet.</source>
        <translation>El módulo %1 no respondió a %2 Bd, por lo que los módulos aún no se pueden usar.</translation>
    </message>
    <message>
        <source>Usually the cable is too long for this baud rate, or termination is missing. Choose a lower baud rate for %1 and scan again.</source>
        <translation>Suele deberse a un cable demasiado largo para esta velocidad en baudios o a falta de terminación. Elija una velocidad menor para %1 y vuelva a buscar.</translation>
    </message>
    <message>
        <source>Modules answered at %1, but their answers were garbled.</source>
        <translation>Respondieron módulos en %1, pero sus respuestas llegaron corruptas.</translation>
    </message>
    <message>
        <source>Usually noise on the cable, or two modules answering at once. Check the cable, its termination and the ADDR_IN jumpers.</source>
        <translation>Suele deberse a ruido en el cable o a que dos módulos responden a la vez. Compruebe el cable, su terminación y los puentes ADDR_IN.</translation>
    </message>
    <message>
        <source>Port %1, %2 Bd</source>
        <translation>Puerto %1, %2 Bd</translation>
    </message>
    <message>
        <source>module %1</source>
        <translation>módulo %1</translation>
    </message>
    <message>
        <source>module %1 &quot;%2&quot;</source>
        <translation>módulo %1 “%2”</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two.</source>
        <translation>La numeración empieza en el extremo lejano; por eso, revise el módulo que sigue a %1 hacia el PC: primero su alimentación y después el conector entre ambos.</translation>
    </message>
    <message>
        <source>Work with %1</source>
        <translation>Trabajar con %1</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd.</source>
        <translation>Conectado a %1: %2 a %3 Bd.</translation>
    </message>
    <message>
        <source>Nothing moves until you command it. Gains are unknown until you apply them.</source>
        <translation>Nada se mueve hasta que usted lo ordene. Las ganancias se desconocen hasta que las aplique.</translation>
    </message>
    <message>
        <source>Disconnected from %1.</source>
        <translation>Desconectado de %1.</translation>
    </message>
    <message>
        <source>All modules on %1 stopped answering. %2</source>
        <translation>Todos los módulos de %1 dejaron de responder. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Then check the power of the modules and the cable at the PC.</source>
        <translation>Use la parada por hardware si es necesario. Después compruebe la alimentación de los módulos y el cable del PC.</translation>
    </message>
    <message>
        <source>The link is unreliable: %1 of the last %2 exchanges failed.</source>
        <translation>El enlace no es fiable: fallaron %1 de los últimos %2 intercambios.</translation>
    </message>
    <message>
        <source>Updates are slow (%1 per second) because the USB adapter waits %2 ms before passing data on.</source>
        <translation>Los valores llegan despacio (%1 por segundo) porque el adaptador USB espera %2 ms antes de entregar los datos.</translation>
    </message>
    <message>
        <source>Set its latency timer to 1 ms.</source>
        <translation>Ajuste su temporizador de latencia a 1 ms.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown: it was moving.</source>
        <translation>El módulo %1 no responde desde hace %2 s. Estado del motor desconocido: estaba en movimiento.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown; it was stopped when last seen.</source>
        <translation>El módulo %1 no responde desde hace %2 s. Estado del motor desconocido; estaba parado en la última lectura.</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. The state of its outputs is unknown.</source>
        <translation>El módulo %1 no responde desde hace %2 s. El estado de sus salidas es desconocido.</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Check its power and the plug next to it; the panel keeps trying.</source>
        <translation>Use la parada por hardware si es necesario. Compruebe su alimentación y el conector contiguo; el panel sigue intentándolo.</translation>
    </message>
    <message>
        <source>Module %1 may not answer until module %2 has its address again.</source>
        <translation>El módulo %1 puede no responder hasta que el módulo %2 recupere su dirección.</translation>
    </message>
    <message>
        <source>Restart the network…</source>
        <translation>Reiniciar la red…</translation>
    </message>
    <message>
        <source>Module %1 received a garbled command and did not carry it out.</source>
        <translation>El módulo %1 recibió un comando corrupto y no lo ejecutó.</translation>
    </message>
    <message>
        <source>Sending again (%1 of 3). Usually noise on the cable.</source>
        <translation>Se envía de nuevo (%1 de 3). Suele deberse a ruido en el cable.</translation>
    </message>
    <message>
        <source>The answer from module %1 was garbled.</source>
        <translation>La respuesta del módulo %1 llegó corrupta.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; the panel is reading the position again.</source>
        <translation>El comando puede haberse ejecutado o no; el panel está leyendo la posición de nuevo.</translation>
    </message>
    <message>
        <source>Command byte %1</source>
        <translation>Byte de comando %1</translation>
    </message>
    <message>
        <source>Module %1: done.</source>
        <translation>Módulo %1: hecho.</translation>
    </message>
    <message>
        <source>Module %1 received the command garbled and did not carry it out.</source>
        <translation>El módulo %1 recibió el comando corrupto y no lo ejecutó.</translation>
    </message>
    <message>
        <source>Sent 3 times; later commands were not sent. Usually noise on the cable.</source>
        <translation>Se envió 3 veces; los comandos siguientes no se enviaron. Suele deberse a ruido en el cable.</translation>
    </message>
    <message>
        <source>Module %1 did not answer the command. Motor state unknown.</source>
        <translation>El módulo %1 no respondió al comando. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; later commands were not sent. Look at the motor; stop all if in doubt.</source>
        <translation>El comando puede haberse ejecutado o no; los siguientes no se enviaron. Observe el motor y, en caso de duda, pare todo.</translation>
    </message>
    <message>
        <source>Module %1 cannot do this in its present state. Nothing was sent.</source>
        <translation>El módulo %1 no puede hacerlo en su estado actual. No se envió nada.</translation>
    </message>
    <message>
        <source>Stop the motor, then try again.</source>
        <translation>Pare el motor e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The command for module %1 was cancelled.</source>
        <translation>El comando para el módulo %1 se canceló.</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to module %1.</source>
        <translation>Hay demasiados comandos en espera. No se envió nada al módulo %1.</translation>
    </message>
    <message>
        <source>Wait until they are carried out, or press STOP ALL to discard them.</source>
        <translation>Espere a que se ejecuten o descártelos con PARAR TODO.</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was more than %2 counts from where it should be.</source>
        <translation>El módulo %1 apagó su servo porque el motor estaba a más de %2 cuentas de donde debía.</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was too far from where it should be.</source>
        <translation>El módulo %1 apagó su servo porque el motor estaba demasiado lejos de donde debía.</translation>
    </message>
    <message>
        <source>Clear and stay off</source>
        <translation>Borrar y dejar apagado</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its servo is off.</source>
        <translation>El módulo %1 no tiene alimentación del motor, por lo que su servo está apagado.</translation>
    </message>
    <message>
        <source>It stays off when power returns.</source>
        <translation>Seguirá apagado cuando vuelva la alimentación.</translation>
    </message>
    <message>
        <source>The computer was busy, or the program that jogs it has stopped calling. Press and hold again.</source>
        <translation>El equipo estuvo ocupado, o el programa que pide el jog dejó de llamar. Vuelva a mantener pulsado.</translation>
    </message>
    <message>
        <source>Module %1 cannot do this now; nothing was sent.</source>
        <translation>El módulo %1 no puede hacerlo ahora; no se envió nada.</translation>
    </message>
    <message>
        <source>reaches %1 of %2</source>
        <translation>llega a %1 de %2</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped before the port closes.</source>
        <translation>
            <numerusform>%n motor está en movimiento. El panel lo parará antes de cerrar el puerto.</numerusform>
            <numerusform>%n motores están en movimiento. El panel los parará antes de cerrar el puerto.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopping the motors, then closing.</source>
        <translation>Parando los motores antes de cerrar.</translation>
    </message>
    <message>
        <source>Fit a hardware emergency stop that removes motor power.</source>
        <translation>Instale una parada de emergencia por hardware que corte la alimentación de los motores.</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Entendido</translation>
    </message>
    <message>
        <source>Module %1</source>
        <translation>Módulo %1</translation>
    </message>
    <message>
        <source>type %1</source>
        <translation>tipo %1</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Sin respuesta</translation>
    </message>
    <message>
        <source>Not asked</source>
        <translation>Sin consultar</translation>
    </message>
    <message>
        <source>No motor power</source>
        <translation>Motor sin tensión</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>Servo apagado</translation>
    </message>
    <message>
        <source>Power was lost</source>
        <translation>Se perdió la alimentación</translation>
    </message>
    <message>
        <source>PWM mode</source>
        <translation>Modo PWM</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Mantiene posición</translation>
    </message>
    <message>
        <source>Accelerating</source>
        <translation>Acelerando</translation>
    </message>
    <message>
        <source>At speed</source>
        <translation>A velocidad constante</translation>
    </message>
    <message>
        <source>Decelerating</source>
        <translation>Decelerando</translation>
    </message>
    <message>
        <source>No status received from this module yet.</source>
        <translation>Aún no se ha recibido ningún estado de este módulo.</translation>
    </message>
    <message>
        <source>The module does not answer. Motor state unknown.</source>
        <translation>El módulo no responde. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>Sending has stopped because another module restarted, so what this one does now is not known. Scan again, or restart the network.</source>
        <translation>Ya no se envía nada porque otro módulo se reinició, así que no se sabe qué hace este ahora. Vuelva a buscar o reinicie la red.</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the servo is switched off.</source>
        <translation>El motor puede girar libremente. Es normal: el servo está apagado.</translation>
    </message>
    <message>
        <source>The servo switched itself off because the motor was too far from where it should be.</source>
        <translation>El servo se apagó solo porque el motor estaba demasiado lejos de donde debía.</translation>
    </message>
    <message>
        <source>A fixed PWM value drives the motor; the servo does not control it. After a loss of motor power, the motor may turn again by itself.</source>
        <translation>Un valor de PWM fijo acciona el motor; el servo no lo controla. Tras un fallo de la alimentación, el motor puede volver a girar por sí solo.</translation>
    </message>
    <message>
        <source>The motor is changing its speed.</source>
        <translation>El motor está cambiando de velocidad.</translation>
    </message>
    <message>
        <source>The motor moves at its goal velocity.</source>
        <translation>El motor se mueve a su velocidad objetivo.</translation>
    </message>
    <message>
        <source>The motor is slowing down.</source>
        <translation>El motor está frenando.</translation>
    </message>
    <message>
        <source>Not connected. Choose a port and connect first.</source>
        <translation>Sin conexión. Elija primero un puerto y conecte.</translation>
    </message>
    <message>
        <source>This module is not a PIC-SERVO.</source>
        <translation>Este módulo no es un PIC-SERVO.</translation>
    </message>
    <message>
        <source>The module does not answer, so its state is unknown.</source>
        <translation>El módulo no responde, por lo que se desconoce su estado.</translation>
    </message>
    <message>
        <source>This is not the type of module that the machine has here, so its settings do not apply. Only stop commands work until you accept the chain as found (Chain doctor).</source>
        <translation>La máquina tiene aquí otro tipo de módulo, por lo que sus ajustes no se aplican. Hasta que acepte la cadena tal como se encontró (Diagnóstico de la cadena), solo actúan las paradas.</translation>
    </message>
    <message>
        <source>The module has no motor power.</source>
        <translation>El módulo no tiene alimentación del motor.</translation>
    </message>
    <message>
        <source>The gains are 0 or unknown, so the motor would not hold. Apply gains first.</source>
        <translation>Las ganancias son 0 o desconocidas, por lo que el motor no mantendría la posición. Aplique primero las ganancias.</translation>
    </message>
    <message>
        <source>The servo is off. Enable it first.</source>
        <translation>El servo está apagado. Habilítelo primero.</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first: a move to a position starts from standstill.</source>
        <translation>El motor está en movimiento. Párelo primero: un movimiento a una posición empieza con el motor parado.</translation>
    </message>
    <message>
        <source>The acceleration is 0 or unknown: the motor might not start or stop. Enter an acceleration.</source>
        <translation>La aceleración es 0 o desconocida: el motor quizá no podría arrancar ni parar. Introduzca una aceleración.</translation>
    </message>
    <message>
        <source>The velocity is 0 or unknown: the motor might not move, or move too fast. Enter a velocity.</source>
        <translation>La velocidad es 0 o desconocida: el motor quizá no se movería o se movería demasiado rápido. Introduzca una velocidad.</translation>
    </message>
    <message>
        <source>The chip cannot turn the motor this slowly in its speed mode. Enter a higher velocity, or choose another speed mode.</source>
        <translation>El chip no puede girar el motor tan despacio en su modo de velocidad. Introduzca una velocidad mayor o elija otro modo de velocidad.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Atención</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fallo</translation>
    </message>
    <message>
        <source>restarting the modules</source>
        <translation>reiniciando los módulos</translation>
    </message>
    <message>
        <source>assigning addresses</source>
        <translation>asignando direcciones</translation>
    </message>
    <message>
        <source>reading types and versions</source>
        <translation>leyendo tipos y versiones</translation>
    </message>
    <message>
        <source>changing the baud rate</source>
        <translation>cambiando la velocidad en baudios</translation>
    </message>
    <message>
        <source>setting up status reports</source>
        <translation>configurando los informes de estado</translation>
    </message>
    <message>
        <source>Simulator (%1)</source>
        <translation>Simulador (%1)</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Sin conexión</translation>
    </message>
    <message>
        <source>Connecting to %1: %2</source>
        <translation>Conectando a %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 so far</source>
        <translation>%1, %2 por ahora</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3</source>
        <translation>Conectado a %1 a %2 Bd, %3</translation>
    </message>
    <message>
        <source>%1 is open, but no module is usable</source>
        <translation>%1 está abierto, pero ningún módulo se puede usar</translation>
    </message>
    <message>
        <source>Connection to %1 lost, motor state unknown</source>
        <translation>Se perdió la conexión con %1; estado de los motores desconocido</translation>
    </message>
    <message>
        <source>Sending to %1 has stopped: module %2 restarted</source>
        <translation>Ya no se envía nada a %1: el módulo %2 se reinició</translation>
    </message>
    <message numerus="yes">
        <source>%n modules</source>
        <translation>
            <numerusform>%n módulo</numerusform>
            <numerusform>%n módulos</numerusform>
        </translation>
    </message>
    <message>
        <source> and </source>
        <translation> y </translation>
    </message>
    <message>
        <source>counts</source>
        <translation>cuentas</translation>
    </message>
    <message>
        <source>counts/tick</source>
        <translation>cuentas/ciclo</translation>
    </message>
    <message>
        <source>counts/tick²</source>
        <translation>cuentas/ciclo²</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Hecho: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Error: %1</translation>
    </message>
    <message>
        <source>Answer to: %1</source>
        <translation>Respuesta a: %1</translation>
    </message>
    <message>
        <source>Two modules on %1 have the same address, so the modules cannot be used.</source>
        <translation>Dos módulos de %1 tienen la misma dirección, por lo que los módulos no se pueden usar.</translation>
    </message>
    <message>
        <source>No motor was moved. Usually two ADDR_IN inputs are grounded; ground only that of the module farthest from the PC.</source>
        <translation>No se movió ningún motor. Suele haber dos entradas ADDR_IN conectadas a masa; conecte a masa solo la del módulo más alejado del PC.</translation>
    </message>
    <message>
        <source>The line at %1 is held low: only zero bytes arrive.</source>
        <translation>La línea de %1 está retenida a nivel bajo: solo llegan bytes a cero.</translation>
    </message>
    <message>
        <source>Motor state unknown; commands may not get through. Usually a short circuit, swapped wires of a pair, or a module without power.</source>
        <translation>Estado de los motores desconocido; los comandos pueden no llegar. Suele deberse a un cortocircuito, a hilos de un par cruzados o a un módulo sin alimentación.</translation>
    </message>
    <message>
        <source>The modules on %1 have no addresses yet.</source>
        <translation>Los módulos de %1 aún no tienen dirección.</translation>
    </message>
    <message>
        <source>A read-only connection cannot assign addresses. Choose Connect fully.</source>
        <translation>Una conexión de solo lectura no puede asignar direcciones. Conecte sin el modo de solo lectura.</translation>
    </message>
    <message>
        <source>The link is marginal: %1 of the last %2 exchanges failed.</source>
        <translation>El enlace es deficiente: fallaron %1 de los últimos %2 intercambios.</translation>
    </message>
    <message>
        <source>Motor state unknown. Look at the motor; stop all if in doubt.</source>
        <translation>Estado del motor desconocido. Observe el motor y, en caso de duda, pare todo.</translation>
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
        <translation>El panel se bloqueó durante %1 con un motor en movimiento. El motor no recibió orden de parar.</translation>
    </message>
    <message>
        <source>STOP ALL did not work during that time. The computer was busy, or the program hung.</source>
        <translation>PARAR TODO no funcionó durante ese tiempo. El equipo estaba ocupado o el programa se colgó.</translation>
    </message>
    <message>
        <source>Resumed after %1: reading all values again.</source>
        <translation>Reanudado tras %1: se leen de nuevo todos los valores.</translation>
    </message>
    <message>
        <source>Resumed after %1: motors were commanded to stop; reading all values again.</source>
        <translation>Reanudado tras %1: se ordenó parar a los motores; se leen de nuevo todos los valores.</translation>
    </message>
    <message>
        <source>While the computer was suspended, the panel could not stop a motor. Look at the motors before the next move.</source>
        <translation>Mientras el equipo estuvo suspendido, el panel no podía parar ningún motor. Observe los motores antes del próximo movimiento.</translation>
    </message>
    <message numerus="yes">
        <source>The last session ended while motors %1 were moving.</source>
        <translation>
            <numerusform>La última sesión terminó con el motor %1 en movimiento.</numerusform>
            <numerusform>La última sesión terminó con los motores %1 en movimiento.</numerusform>
        </translation>
    </message>
    <message>
        <source>Settings cannot be saved.</source>
        <translation>No se pueden guardar los ajustes.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works; only the window layout and the last port are not remembered.</source>
        <translation>No se puede escribir en %1. Todo lo demás funciona; solo no se recuerdan la disposición de la ventana ni el último puerto.</translation>
    </message>
    <message>
        <source>%1 is used by another program (pid %2).</source>
        <translation>Otro programa (pid %2) está usando %1.</translation>
    </message>
    <message>
        <source>%1 is used by %2 (pid %3).</source>
        <translation>%2 (pid %3) está usando %1.</translation>
    </message>
    <message>
        <source>It probes a newly connected adapter for a modem for a few seconds; wait, then try again. To keep it away from USB adapters, run %1, then plug the adapter in again.</source>
        <translation>Busca un módem durante unos segundos en cada adaptador recién conectado; espere e inténtelo de nuevo. Para que no toque los adaptadores USB, ejecute %1 y vuelva a conectar el adaptador.</translation>
    </message>
    <message>
        <source>It mistakes many serial adapters for a Braille display. If you have none, run %1, then plug the adapter in again.</source>
        <translation>Confunde muchos adaptadores serie con una pantalla braille. Si no tiene ninguna, ejecute %1 y vuelva a conectar el adaptador.</translation>
    </message>
    <message>
        <source>%1 is free, but a stale lock file marks it as in use.</source>
        <translation>%1 está libre, pero un archivo de bloqueo obsoleto lo marca como ocupado.</translation>
    </message>
    <message>
        <source>%2 left the lock file %1 behind. Remove it with %3, then try again.</source>
        <translation>%2 dejó el archivo de bloqueo %1. Elimínelo con %3 e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Could not open %1: no lock file can be created for it.</source>
        <translation>No se pudo abrir %1: no se puede crear un archivo de bloqueo para él.</translation>
    </message>
    <message>
        <source>Your user account has no write access to %1 or any other folder for lock files. Ask your system administrator for access.</source>
        <translation>Su cuenta de usuario no puede escribir en %1 ni en ninguna otra carpeta de archivos de bloqueo. Pida acceso al administrador del sistema.</translation>
    </message>
    <message>
        <source>Could not open %1: this program has too many open files.</source>
        <translation>No se pudo abrir %1: este programa tiene demasiados archivos abiertos.</translation>
    </message>
    <message>
        <source>Close files that you do not need, or restart the program.</source>
        <translation>Cierre los archivos que no necesite o reinicie el programa.</translation>
    </message>
    <message>
        <source>Set the latency timer of the USB adapter to 1 ms, then connect again.</source>
        <translation>Ajuste el temporizador de latencia del adaptador USB a 1 ms y vuelva a conectar.</translation>
    </message>
    <message>
        <source>Run %1. This lasts until the adapter is unplugged. To make it permanent, also run %2.</source>
        <translation>Ejecute %1. Esto dura hasta que se desconecte el adaptador. Para hacerlo permanente, ejecute también %2.</translation>
    </message>
    <message>
        <source>The adapter is back as %1 (same serial number). Reconnect?</source>
        <translation>El adaptador está de vuelta como %1 (mismo número de serie). ¿Reconectar?</translation>
    </message>
    <message>
        <source>A similar adapter was found as %1. Reconnect?</source>
        <translation>Se encontró un adaptador similar como %1. ¿Reconectar?</translation>
    </message>
    <message>
        <source>Motors may still be moving. Reconnecting moves nothing and repeats no earlier command.</source>
        <translation>Puede haber motores aún en movimiento. Reconectar no mueve nada ni repite ningún comando anterior.</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (19 200 Bd tried).</source>
        <translation>El puerto está abierto, pero no respondió ningún módulo (se probó a 19 200 Bd).</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).</source>
        <translation>El puerto está abierto, pero no respondió ningún módulo (se probó a 9600, 19 200, 57 600 y 115 200 Bd).</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. If another program left the chain at an unusual baud rate, restart the network.</source>
        <translation>Compruebe, en este orden: la alimentación de los módulos; todos los cables de la cadena, pues uno solo suelto oculta todos los módulos; el puente ADDR_IN del módulo más alejado del PC; que TX y RX no estén cruzados; que el adaptador sea full-duplex (4 hilos). Si otro programa dejó la cadena a una velocidad en baudios poco habitual, reinicie la red.</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd, left running.</source>
        <translation>Conectado a %1: %2 a %3 Bd, sin alterar su marcha.</translation>
    </message>
    <message>
        <source>The modules carry on with what they were doing.</source>
        <translation>Los módulos siguen con lo que hacían.</translation>
    </message>
    <message>
        <source>Gains are unknown until you apply them. Stop a motor before you move it: its last command is unknown.</source>
        <translation>Las ganancias se desconocen hasta que las aplique. Pare un motor antes de moverlo: su último comando se desconoce.</translation>
    </message>
    <message>
        <source>A module without an address also answered; it cannot be used yet.</source>
        <translation>También respondió un módulo sin dirección; aún no se puede usar.</translation>
    </message>
    <message>
        <source>Its motor is off. Either a module has restarted, or a new one was added. Restart the network to give it an address.</source>
        <translation>Su motor está apagado. O se reinició un módulo o se añadió uno nuevo. Reinicie la red para darle una dirección.</translation>
    </message>
    <message>
        <source>The link to module %1 is unreliable: %2 of its last %3 exchanges failed.</source>
        <translation>El enlace con el módulo %1 no es fiable: fallaron %2 de sus últimos %3 intercambios.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconectar</translation>
    </message>
    <message>
        <source>A different adapter is on %1.</source>
        <translation>En %1 hay un adaptador distinto.</translation>
    </message>
    <message>
        <source>The panel was connected to another adapter before. Nothing was sent.</source>
        <translation>El panel estaba conectado antes a otro adaptador. No se envió nada.</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>Conectar de todos modos</translation>
    </message>
    <message>
        <source>The link to module %1 is marginal: %2 of its last %3 exchanges failed.</source>
        <translation>El enlace con el módulo %1 es deficiente: fallaron %2 de sus últimos %3 intercambios.</translation>
    </message>
    <message>
        <source>Its motor is off.</source>
        <translation>Su motor está apagado.</translation>
    </message>
    <message>
        <source>Set its outputs again once it has its address.</source>
        <translation>Ajuste de nuevo sus salidas cuando vuelva a tener su dirección.</translation>
    </message>
    <message>
        <source>Every module loses its position, gains and address, and switches its motor off.</source>
        <translation>Todos los módulos pierden su posición, sus ganancias y su dirección, y apagan su motor.</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped first.</source>
        <translation>
            <numerusform>%n motor está en movimiento. El panel lo parará primero.</numerusform>
            <numerusform>%n motores están en movimiento. El panel los parará primero.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restarted</source>
        <translation>Reiniciado</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, gains and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>El módulo se reinició: su motor está apagado y ha perdido su posición, sus ganancias y su dirección. Asígnele de nuevo su dirección si se ofrece, o reinicie la red.</translation>
    </message>
    <message>
        <source>The module restarted: its pins are inputs again, its outputs release what they drove, and its address is lost. Assign its address again if offered, or restart the network.</source>
        <translation>El módulo se reinició: sus pines vuelven a ser entradas, sus salidas dejan libre lo que gobernaban y ha perdido su dirección. Asígnele de nuevo su dirección si se ofrece, o reinicie la red.</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, parameters and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>El módulo se reinició: su motor está apagado y ha perdido su posición, sus parámetros y su dirección. Asígnele de nuevo su dirección si se ofrece, o reinicie la red.</translation>
    </message>
    <message>
        <source>all bytes are 00, or all FF, as on a line that is held low or high</source>
        <translation>todos los bytes son 00, o todos FF, como en una línea retenida a nivel bajo o alto</translation>
    </message>
    <message>
        <source>more bytes than requested</source>
        <translation>más bytes de los pedidos</translation>
    </message>
    <message>
        <source>type or version does not match this module</source>
        <translation>el tipo o la versión no corresponden a este módulo</translation>
    </message>
    <message>
        <source>an undefined status bit changed</source>
        <translation>cambió un bit de estado no definido</translation>
    </message>
    <message>
        <source>homing started without a command</source>
        <translation>el referenciado empezó sin un comando</translation>
    </message>
    <message>
        <source>home register changed without a command</source>
        <translation>el registro de referencia cambió sin un comando</translation>
    </message>
    <message>
        <source>position jumped farther than the velocities allow</source>
        <translation>la posición saltó más de lo que permiten las velocidades</translation>
    </message>
    <message>
        <source>velocity changed faster than any motor can</source>
        <translation>la velocidad cambió más rápido de lo que puede ningún motor</translation>
    </message>
    <message>
        <source>servo is off, but pos_error or move_done is not set</source>
        <translation>el servo está apagado, pero pos_error o move_done no está activo</translation>
    </message>
    <message>
        <source>servo is on without motor power</source>
        <translation>el servo está encendido sin alimentación del motor</translation>
    </message>
    <message>
        <source>slew_done is set without accel_done</source>
        <translation>slew_done está activo sin accel_done</translation>
    </message>
    <message>
        <source>a sticky bit was cleared without a command</source>
        <translation>un bit enclavado se borró sin un comando</translation>
    </message>
    <message>
        <source>velocity and trapezoidal mode at once</source>
        <translation>modo de velocidad y trapezoidal a la vez</translation>
    </message>
    <message>
        <source>moving without power or amplifier</source>
        <translation>movimiento sin alimentación o sin amplificador</translation>
    </message>
    <message>
        <source>position changed while the motor was stopped</source>
        <translation>la posición cambió con el motor parado</translation>
    </message>
    <message>
        <source>timer count of a moving motor is not 1 to 65 452</source>
        <translation>el valor del temporizador de un motor en movimiento no está entre 1 y 65 452</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>module refused: checksum</source>
        <translation>rechazado por el módulo: suma de comprobación</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>too few bytes</source>
        <translation>faltan bytes</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>suma de comprobación errónea</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>rechazado: %1</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>cancelled by a stop</source>
        <translation>cancelado por una parada</translation>
    </message>
    <message>
        <source>no answer expected</source>
        <translation>no se espera respuesta</translation>
    </message>
    <message>
        <source>bytes, but no answer was expected</source>
        <translation>llegaron bytes, pero no se esperaba respuesta</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>conexión</translation>
    </message>
    <message>
        <source>poll</source>
        <translation>consulta</translation>
    </message>
    <message>
        <source>command</source>
        <translation>comando</translation>
    </message>
    <message>
        <source>check</source>
        <translation>comprobación</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>jog</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>parada</translation>
    </message>
    <message>
        <source>challenge</source>
        <translation>contraprueba</translation>
    </message>
    <message>
        <source>flush</source>
        <translation>vaciado</translation>
    </message>
    <message>
        <source>Address %1</source>
        <translation>Dirección %1</translation>
    </message>
    <message>
        <source>SIMULATED SESSION: no hardware was connected.</source>
        <translation>SESIÓN SIMULADA: no había hardware conectado.</translation>
    </message>
    <message>
        <source>Packets of %1 on %2, seconds since %3</source>
        <translation>Paquetes de %1 en %2, segundos desde %3</translation>
    </message>
    <message>
        <source>Older exchanges left out of this file: %1.</source>
        <translation>Intercambios más antiguos no incluidos en este archivo: %1.</translation>
    </message>
    <message>
        <source>Exchanges before this one were not recorded.</source>
        <translation>Los intercambios anteriores a este no se grabaron.</translation>
    </message>
    <message>
        <source>looking for modules</source>
        <translation>buscando módulos</translation>
    </message>
    <message>
        <source>Carried out by: %1.</source>
        <translation>Lo ejecutaron: %1.</translation>
    </message>
    <message>
        <source>Not carried out by: %1.</source>
        <translation>No lo ejecutaron: %1.</translation>
    </message>
    <message>
        <source>Unknown for: %1.</source>
        <translation>Se desconoce en: %1.</translation>
    </message>
    <message>
        <source>No answer from: %1.</source>
        <translation>Sin respuesta de: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 modules of group %3 started. All of them were commanded to stop.</source>
        <translation>Arrancaron %1 de %2 módulos del grupo %3. Se ordenó parar a todos ellos.</translation>
    </message>
    <message>
        <source>No module of group %1 started. Nothing was moved.</source>
        <translation>No arrancó ningún módulo del grupo %1. No se movió nada.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed their start.</source>
        <translation>No todos los módulos del grupo %1 confirmaron su arranque.</translation>
    </message>
    <message>
        <source>Look at the motors. The start is never repeated: load the moves again, then start the group again. Usually noise on the cable.</source>
        <translation>Observe los motores. El arranque nunca se repite: cargue de nuevo y vuelva a iniciar. Suele deberse a ruido en el cable.</translation>
    </message>
    <message>
        <source>Group %1 is empty. Nothing was sent.</source>
        <translation>El grupo %1 está vacío. No se envió nada.</translation>
    </message>
    <message>
        <source>Add modules to the group first.</source>
        <translation>Añada primero módulos al grupo.</translation>
    </message>
    <message>
        <source>Module %2 blocks the command to group %1. Nothing was sent.</source>
        <translation>El módulo %2 bloquea el comando al grupo %1. No se envió nada.</translation>
    </message>
    <message>
        <source>A group starts only when every member answers, has confirmed its load and can start, and the group of every module is known. Load this module again, or set its group again.</source>
        <translation>Un grupo solo arranca si todos sus miembros responden, han confirmado su carga y pueden arrancar, y si se conoce el grupo de todos los módulos. Cargue de nuevo este módulo o asígnele de nuevo su grupo.</translation>
    </message>
    <message>
        <source>Module %1 did not confirm its new group, so its group is unknown.</source>
        <translation>El módulo %1 no confirmó su nuevo grupo, por lo que su grupo se desconoce.</translation>
    </message>
    <message>
        <source>Could not change the group of module %1.</source>
        <translation>No se pudo cambiar el grupo del módulo %1.</translation>
    </message>
    <message>
        <source>Nothing was moved. A group has at most one leader, group FF has none, and the groups of all modules must be known. Check this, then try again.</source>
        <translation>No se movió nada. Un grupo tiene como máximo un líder, el grupo FF no tiene ninguno y deben conocerse los grupos de todos los módulos. Compruébelo e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The command to group %1 was cancelled.</source>
        <translation>El comando para el grupo %1 se canceló.</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to group %1.</source>
        <translation>Hay demasiados comandos en espera. No se envió nada al grupo %1.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed saving home.</source>
        <translation>No todos los módulos del grupo %1 confirmaron que guardaron la referencia.</translation>
    </message>
    <message>
        <source>No motor was moved.</source>
        <translation>No se movió ningún motor.</translation>
    </message>
    <message>
        <source>A PIC-I/O confirms latched inputs and stored PWM values only as the leader: make it the leader of the group.</source>
        <translation>Un PIC-I/O solo confirma las entradas capturadas y los valores PWM guardados como líder: hágalo líder del grupo.</translation>
    </message>
    <message>
        <source>All modules now run at %1 Bd. Positions and gains are unchanged.</source>
        <translation>Todos los módulos trabajan ahora a %1 Bd. Las posiciones y las ganancias no han cambiado.</translation>
    </message>
    <message>
        <source>Could not change the baud rate: the chain stays at %1 Bd. No motor was moved.</source>
        <translation>No se pudo cambiar la velocidad en baudios: la cadena sigue a %1 Bd. No se movió ningún motor.</translation>
    </message>
    <message>
        <source>The modules do not support %1 Bd. Choose another baud rate.</source>
        <translation>Los módulos no admiten %1 Bd. Elija otra velocidad en baudios.</translation>
    </message>
    <message>
        <source>A motor is moving, or about to move. Stop all motors, then try again.</source>
        <translation>Un motor se mueve o está a punto de moverse. Pare todos los motores e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Module %1 does not answer and would be left behind. Connect again first.</source>
        <translation>El módulo %1 no responde y se quedaría atrás. Conecte de nuevo primero.</translation>
    </message>
    <message>
        <source>Another program may have changed the group of module %1, which would then miss the new baud rate. Set its group again, or restart the network.</source>
        <translation>Otro programa puede haber cambiado el grupo del módulo %1, que entonces no recibiría la nueva velocidad en baudios. Asígnele de nuevo su grupo o reinicie la red.</translation>
    </message>
    <message>
        <source>Module %1 is a group leader and would answer at the new baud rate. Make it an ordinary member first.</source>
        <translation>El módulo %1 es líder de grupo y respondería a la nueva velocidad en baudios. Conviértalo primero en un miembro ordinario.</translation>
    </message>
    <message>
        <source>Module %2 did not answer at %1 Bd, so all modules went back to the old rate. Try another baud rate, a shorter cable, or termination at both ends.</source>
        <translation>El módulo %2 no respondió a %1 Bd, por lo que todos los módulos volvieron a la velocidad anterior. Pruebe otra velocidad en baudios, un cable más corto o terminación en ambos extremos.</translation>
    </message>
    <message>
        <source>A stop took priority.</source>
        <translation>Una parada tuvo prioridad.</translation>
    </message>
    <message>
        <source>Module %1 has not answered since the baud rate changed. No motor was moving.</source>
        <translation>El módulo %1 no responde desde el cambio de velocidad en baudios. No se movía ningún motor.</translation>
    </message>
    <message>
        <source>It may still be at %1 Bd; the others are at %2 Bd. Scan again. If the module is not found, restart the network: positions and gains are lost.</source>
        <translation>Puede seguir a %1 Bd; los demás están a %2 Bd. Vuelva a buscar. Si no se encuentra el módulo, reinicie la red: se pierden las posiciones y las ganancias.</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>text in quotation marks</source>
        <translation>texto entre comillas</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>un objeto entre { }</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>una lista entre [ ]</translation>
    </message>
    <message>
        <source>the file is incomplete.</source>
        <translation>el archivo está incompleto.</translation>
    </message>
    <message>
        <source>this text is not UTF-8.</source>
        <translation>este texto no es UTF-8.</translation>
    </message>
    <message>
        <source>this is not JSON.</source>
        <translation>esto no es JSON.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 no es un número.</translation>
    </message>
    <message>
        <source>this number is too large.</source>
        <translation>este número es demasiado grande.</translation>
    </message>
    <message>
        <source>more than %1 levels of brackets.</source>
        <translation>más de %1 niveles de corchetes.</translation>
    </message>
    <message>
        <source>more than %1 values.</source>
        <translation>más de %1 valores.</translation>
    </message>
    <message>
        <source>%1 appears twice.</source>
        <translation>%1 aparece dos veces.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>falta %1.</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1 no es %2.</translation>
    </message>
    <message>
        <source>%1 is %2; it must be %3 to %4.</source>
        <translation>%1 es %2; debe estar entre %3 y %4.</translation>
    </message>
    <message>
        <source>%1 has the unknown value &quot;%2&quot;.</source>
        <translation>%1 tiene el valor desconocido “%2”.</translation>
    </message>
    <message>
        <source>%1 has an unprintable character.</source>
        <translation>%1 contiene un carácter no imprimible.</translation>
    </message>
    <message>
        <source>%1 has more than %2 entries.</source>
        <translation>%1 tiene más de %2 entradas.</translation>
    </message>
    <message>
        <source>%1 has a unit that does not fit the module of this axis.</source>
        <translation>%1 tiene una unidad que no corresponde al módulo de este eje.</translation>
    </message>
    <message>
        <source>module %1 is already in a group.</source>
        <translation>el módulo %1 ya está en un grupo.</translation>
    </message>
    <message>
        <source>another group also has address %1.</source>
        <translation>otro grupo también tiene la dirección %1.</translation>
    </message>
    <message>
        <source>the leader is not one of the group&apos;s modules.</source>
        <translation>el líder no es uno de los módulos del grupo.</translation>
    </message>
    <message>
        <source>There is no file %1. Check whether it was moved, or its disk is disconnected.</source>
        <translation>No existe el archivo %1. Compruebe si se movió o si su disco está desconectado.</translation>
    </message>
    <message>
        <source>The folder %1 does not exist. Choose another one.</source>
        <translation>La carpeta %1 no existe. Elija otra.</translation>
    </message>
    <message>
        <source>This is a folder or a device. Choose a file.</source>
        <translation>Es una carpeta o un dispositivo. Elija un archivo.</translation>
    </message>
    <message>
        <source>Your user account has no permission for %1. Choose another folder, or change the permissions.</source>
        <translation>Su cuenta de usuario no tiene permiso para %1. Elija otra carpeta o cambie los permisos.</translation>
    </message>
    <message>
        <source>The disk of %1 is read-only. Choose another folder.</source>
        <translation>El disco de %1 es de solo lectura. Elija otra carpeta.</translation>
    </message>
    <message>
        <source>The disk of %1 is full. Free some space, or choose another folder.</source>
        <translation>El disco de %1 está lleno. Libere espacio o elija otra carpeta.</translation>
    </message>
    <message>
        <source>It is larger than any machine file. Check that it is the right file.</source>
        <translation>Es mayor que cualquier archivo de máquina. Compruebe que es el archivo correcto.</translation>
    </message>
    <message>
        <source>Another program has changed it since it was opened or saved here. Open it to see the changes, or save as another file; saving as the same one replaces it.</source>
        <translation>Otro programa lo ha modificado desde que se abrió o se guardó aquí. Ábralo para ver los cambios, o guarde con otro nombre; si guarda con el mismo, se sustituye.</translation>
    </message>
    <message>
        <source>See Details for the system&apos;s message.</source>
        <translation>Consulte Detalles para ver el mensaje del sistema.</translation>
    </message>
    <message>
        <source>counts (steps)</source>
        <translation>cuentas (pasos)</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>vueltas</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>unidad propia</translation>
    </message>
    <message>
        <source>abruptly</source>
        <translation>bruscamente</translation>
    </message>
    <message>
        <source>smoothly</source>
        <translation>suavemente</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>apagar motor</translation>
    </message>
    <message>
        <source>an unnamed machine</source>
        <translation>una máquina sin nombre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty.</source>
        <translation>“%1” está vacío.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2 bytes.</source>
        <translation>“%1” ocupa más de %2 bytes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a machine file of NMC Panel.</source>
        <translation>“%1” no es un archivo de máquina de NMC Panel.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was written by a newer NMC Panel: its format is %2; this version reads formats up to %3.</source>
        <translation>“%1” se escribió con un NMC Panel más reciente: su formato es %2; esta versión lee formatos hasta %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; line %2: %3</source>
        <translation>“%1” línea %2: %3</translation>
    </message>
    <message>
        <source>Nothing was loaded.</source>
        <translation>No se cargó nada.</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;.</source>
        <translation>No se pudo abrir “%1”.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;. Its previous content is kept.</source>
        <translation>No se pudo guardar “%1”. Se conserva su contenido anterior.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;: it could not be opened again afterwards.</source>
        <translation>No se pudo guardar “%1”: después no se podría volver a abrir.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>No se envió nada.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. No differences.</source>
        <translation>“%1” está abierto. Sin diferencias.</translation>
    </message>
    <message>
        <source>Nothing was applied.</source>
        <translation>No se aplicó nada.</translation>
    </message>
    <message>
        <source>Modules or settings have changed since the table was shown, so it was updated. Check it, then apply again.</source>
        <translation>Los módulos o los ajustes han cambiado desde que se mostró la tabla, por lo que esta se actualizó. Compruébela y aplique de nuevo.</translation>
    </message>
    <message>
        <source>An earlier session left unsaved changes to %1.</source>
        <translation>Una sesión anterior dejó cambios sin guardar de %1.</translation>
    </message>
    <message>
        <source>If modules are connected, Restore shows what would change. Nothing is sent before you choose Apply.</source>
        <translation>Si hay módulos conectados, «Restaurar» muestra qué cambiaría. No se envía nada antes de «Aplicar».</translation>
    </message>
    <message>
        <source>Discard: the changes are lost</source>
        <translation>Descartar: los cambios se pierden</translation>
    </message>
    <message>
        <source>Could not recover unsaved changes of an earlier session.</source>
        <translation>No se pudieron recuperar los cambios sin guardar de una sesión anterior.</translation>
    </message>
    <message>
        <source>unsaved changes</source>
        <translation>cambios sin guardar</translation>
    </message>
    <message>
        <source>Changes to the machine are not backed up until you save them.</source>
        <translation>No hay copia de seguridad de los cambios de la máquina hasta que los guarde.</translation>
    </message>
    <message>
        <source>%1 is not writable.</source>
        <translation>No se puede escribir en %1.</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>¿Guardar los cambios de %1?</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenciado</translation>
    </message>
    <message>
        <source>A/D scale</source>
        <translation>Escala A/D</translation>
    </message>
    <message>
        <source>Names of inputs and outputs</source>
        <translation>Nombres de entradas y salidas</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>Tiempo de aceleración</translation>
    </message>
    <message>
        <source>Limit pins</source>
        <translation>Pines de final de carrera</translation>
    </message>
    <message>
        <source>Baud rate, Bd</source>
        <translation>Baudios, Bd</translation>
    </message>
    <message>
        <source>Type and version</source>
        <translation>Tipo y versión</translation>
    </message>
    <message>
        <source>Counts (steps) per unit</source>
        <translation>Cuentas (pasos) por unidad</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Run velocity</source>
        <translation>Velocidad de marcha</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>Velocidad de jog</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>Vel. de jog máx.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>On limit switch 1</source>
        <translation>Con final de carrera 1</translation>
    </message>
    <message>
        <source>On limit switch 2</source>
        <translation>Con final de carrera 2</translation>
    </message>
    <message>
        <source>On index</source>
        <translation>Con índice</translation>
    </message>
    <message>
        <source>On position error</source>
        <translation>Con error de posición</translation>
    </message>
    <message>
        <source>On current limit</source>
        <translation>Con límite de corriente</translation>
    </message>
    <message>
        <source>On home switch</source>
        <translation>Con interruptor de referencia</translation>
    </message>
    <message>
        <source>Then on index</source>
        <translation>Después con índice</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Velocidad de índice</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>Distancia de búsqueda</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Límite de tiempo</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Ir a la referencia</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>Poner posición a 0</translation>
    </message>
    <message>
        <source>Per A/D count</source>
        <translation>Por unidad A/D</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>En cero</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>Unidad A/D</translation>
    </message>
    <message>
        <source>EL, counts</source>
        <translation>EL, cuentas</translation>
    </message>
    <message>
        <source>Limit 1 is an input</source>
        <translation>El pin de final 1 es una entrada</translation>
    </message>
    <message>
        <source>Limit 2 is an input</source>
        <translation>El pin de final 2 es una entrada</translation>
    </message>
    <message>
        <source>Limit 1 as an output</source>
        <translation>Pin de final 1 como salida</translation>
    </message>
    <message>
        <source>Limit 2 as an output</source>
        <translation>Pin de final 2 como salida</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>Modo de velocidad</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Velocidad mínima del perfil</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>Corriente de marcha</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>Corriente de retención</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>Límite térmico</translation>
    </message>
    <message>
        <source>Ignore limit switches</source>
        <translation>Ignorar finales de carrera</translation>
    </message>
    <message>
        <source>Ignore E-stop input</source>
        <translation>Ignorar entrada E-Stop</translation>
    </message>
    <message>
        <source>Motor off on limit or E-stop input</source>
        <translation>Apagar motor con final de carrera o entrada E-Stop</translation>
    </message>
    <message>
        <source>Output %1</source>
        <translation>Salida %1</translation>
    </message>
    <message>
        <source>Input %1</source>
        <translation>Entrada %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Another type of module: if any of this axis is applied, the rest is reset.</source>
        <translation>Otro tipo de módulo: si se aplica algo de este eje, el resto se restablece.</translation>
    </message>
    <message>
        <source>Changes only the panel; nothing is sent.</source>
        <translation>Solo cambia el panel; no se envía nada.</translation>
    </message>
    <message>
        <source>Sent to the module.</source>
        <translation>Se envía al módulo.</translation>
    </message>
    <message>
        <source>Filled in, not sent: %1</source>
        <translation>Rellenado, sin enviar: %1</translation>
    </message>
    <message>
        <source>Filled in, not sent.</source>
        <translation>Rellenado, sin enviar.</translation>
    </message>
    <message>
        <source>Not in the file: stays as it is.</source>
        <translation>No está en el archivo: queda como está.</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving: stop them before anything is sent.</source>
        <translation>
            <numerusform>%n motor está en movimiento: párelo antes de enviar nada.</numerusform>
            <numerusform>%n motores están en movimiento: párelos antes de enviar nada.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was stopped: its switch stayed active while backing off.</source>
        <translation>%1 se paró: su interruptor siguió activo al retirarse de él.</translation>
    </message>
    <message>
        <source>The switch may be stuck, or the search direction is wrong. Move the motor off the switch, or change the direction, then try again.</source>
        <translation>El interruptor puede estar atascado, o el sentido de búsqueda es erróneo. Aparte el motor del interruptor o cambie el sentido e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>%1 stopped before it found home.</source>
        <translation>%1 se paró antes de encontrar la referencia.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion. Check the search direction and the switches, then try again.</source>
        <translation>Un final de carrera o la entrada E-Stop terminó el movimiento. Compruebe el sentido de búsqueda y los interruptores e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the search distance.</source>
        <translation>%1 se paró: no se encontró la referencia en la distancia de búsqueda.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and the search distance.</source>
        <translation>Compruebe el interruptor y su cable, el sentido de búsqueda y la distancia de búsqueda.</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the time limit.</source>
        <translation>%1 se paró: no se encontró la referencia dentro del límite de tiempo.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and velocity, and the time limit.</source>
        <translation>Compruebe el interruptor y su cable, el sentido y la velocidad de búsqueda y el límite de tiempo.</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: the link was unreliable.</source>
        <translation>%1 no está referenciado y se le ordenó parar: el enlace no era fiable.</translation>
    </message>
    <message>
        <source>The home position found may be wrong. Check the link, then repeat the search.</source>
        <translation>La referencia encontrada puede ser errónea. Compruebe el enlace y repita la búsqueda.</translation>
    </message>
    <message>
        <source>%1 is not homed and does not answer. Motor state unknown.</source>
        <translation>%1 no está referenciado y no responde. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>It was commanded to stop. Use the hardware stop if it moves.</source>
        <translation>Se le ordenó parar. Use la parada por hardware si se mueve.</translation>
    </message>
    <message>
        <source>%1 is not homed: its motor switched itself off and is free to turn.</source>
        <translation>%1 no está referenciado: su motor se apagó solo y puede girar libremente.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, enable the motor, then repeat the search.</source>
        <translation>El error de posición era demasiado grande o falló la alimentación del motor. Compruebe si hay un atasco, habilite el motor y repita la búsqueda.</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: a command failed, or its answer was lost.</source>
        <translation>%1 no está referenciado y se le ordenó parar: un comando falló o se perdió su respuesta.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Repeat the search.</source>
        <translation>Suele deberse a ruido en el cable. Repita la búsqueda.</translation>
    </message>
    <message>
        <source>%1 is at rest but not homed: two readings of home differ.</source>
        <translation>%1 está parado pero no referenciado: dos lecturas de la referencia difieren.</translation>
    </message>
    <message>
        <source>%1 found home and holds close to it, but the position was not set to 0.</source>
        <translation>%1 encontró la referencia y mantiene la posición cerca de ella, pero la posición no se puso a 0.</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Preparando</translation>
    </message>
    <message>
        <source>Backing off from the active switch</source>
        <translation>Retirándose del interruptor activo</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Buscando</translation>
    </message>
    <message>
        <source>Searching for the index</source>
        <translation>Buscando el índice</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Parando</translation>
    </message>
    <message>
        <source>Verifying home</source>
        <translation>Verificando la referencia</translation>
    </message>
    <message>
        <source>Going to home</source>
        <translation>Yendo a la referencia</translation>
    </message>
    <message>
        <source>Setting position to 0</source>
        <translation>Poniendo posición a 0</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>Pausing</source>
        <translation>Pausando</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Hecho</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallido</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>%1 did not finish its moves.</source>
        <translation>%1 no terminó sus movimientos.</translation>
    </message>
    <message>
        <source>%1 found home at %2.</source>
        <translation>%1 encontró la referencia en %2.</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 de %3</translation>
    </message>
    <message>
        <source>The switch stayed active while the motor backed off. The motor was stopped.</source>
        <translation>El interruptor siguió activo mientras el motor se retiraba. Se paró el motor.</translation>
    </message>
    <message>
        <source>The motion ended before home was found. Check the search direction and the switches.</source>
        <translation>El movimiento terminó antes de encontrar la referencia. Compruebe el sentido de búsqueda y los interruptores.</translation>
    </message>
    <message>
        <source>No home within the search distance. The motor was stopped.</source>
        <translation>No se encontró la referencia en la distancia de búsqueda. Se paró el motor.</translation>
    </message>
    <message>
        <source>No home within the time limit. The motor was stopped.</source>
        <translation>No se encontró la referencia dentro del límite de tiempo. Se paró el motor.</translation>
    </message>
    <message>
        <source>The link was unreliable. The motor was commanded to stop.</source>
        <translation>El enlace no era fiable. Se ordenó parar al motor.</translation>
    </message>
    <message>
        <source>The motor switched itself off and is free to turn.</source>
        <translation>El motor se apagó solo y puede girar libremente.</translation>
    </message>
    <message>
        <source>A command failed or was not answered. The motor was commanded to stop.</source>
        <translation>Un comando falló o no tuvo respuesta. Se ordenó parar al motor.</translation>
    </message>
    <message>
        <source>Two readings of home differ. The motor is at rest.</source>
        <translation>Dos lecturas de la referencia difieren. El motor está parado.</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its motor is off.</source>
        <translation>El módulo %1 no tiene alimentación del motor, por lo que su motor está apagado.</translation>
    </message>
    <message>
        <source>Module %1 is too hot and switched its motor off.</source>
        <translation>El módulo %1 está demasiado caliente y apagó su motor.</translation>
    </message>
    <message>
        <source>The A/D value fell below the thermal limit. Let the motor cool down; then check the currents and the limit on the Parameters page.</source>
        <translation>El valor A/D cayó por debajo del límite térmico. Deje enfriar el motor y compruebe después las corrientes y el límite en la página Parámetros.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because its E-stop input is active.</source>
        <translation>El módulo %1 apagó su motor porque su entrada E-Stop está activa.</translation>
    </message>
    <message>
        <source>It stays off when the input is released.</source>
        <translation>Seguirá apagado cuando se libere la entrada.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because a limit switch is active.</source>
        <translation>El módulo %1 apagó su motor porque un final de carrera está activo.</translation>
    </message>
    <message>
        <source>Enable it again, then move in the other direction.</source>
        <translation>Habilítelo de nuevo y muévalo en el otro sentido.</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off by itself.</source>
        <translation>El módulo %1 apagó su motor por sí solo.</translation>
    </message>
    <message>
        <source>The cause is unknown. Check its power and inputs, then enable it again.</source>
        <translation>Se desconoce la causa. Compruebe su alimentación y sus entradas y habilítelo de nuevo.</translation>
    </message>
    <message>
        <source>Amplifier off</source>
        <translation>Amplificador apagado</translation>
    </message>
    <message>
        <source>Stopped by a limit</source>
        <translation>Parado por límite</translation>
    </message>
    <message>
        <source>Too hot</source>
        <translation>Sobrecalentado</translation>
    </message>
    <message>
        <source>Switched itself off</source>
        <translation>Se apagó solo</translation>
    </message>
    <message>
        <source>The module has no motor power, so its motor is off.</source>
        <translation>El módulo no tiene alimentación del motor, por lo que su motor está apagado.</translation>
    </message>
    <message>
        <source>The module switched its motor off when motor power failed. It stays off.</source>
        <translation>El módulo apagó su motor cuando falló la alimentación del motor. Sigue apagado.</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the amplifier is switched off.</source>
        <translation>El motor puede girar libremente. Es normal: el amplificador está apagado.</translation>
    </message>
    <message>
        <source>A limit switch stopped the motor. It can move in the other direction.</source>
        <translation>Un final de carrera paró el motor. Puede moverse en el otro sentido.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input stopped the motor, or prevents it from moving.</source>
        <translation>La entrada E-Stop del módulo paró el motor o impide que se mueva.</translation>
    </message>
    <message>
        <source>The module switched its motor off because the A/D value fell below the thermal limit. It stays off.</source>
        <translation>El módulo apagó su motor porque el valor A/D cayó por debajo del límite térmico. Sigue apagado.</translation>
    </message>
    <message>
        <source>The module switched its motor off; the cause is unknown.</source>
        <translation>El módulo apagó su motor; se desconoce la causa.</translation>
    </message>
    <message>
        <source>Load a move first.</source>
        <translation>Cargue primero un movimiento.</translation>
    </message>
    <message>
        <source>The position is unknown.</source>
        <translation>La posición se desconoce.</translation>
    </message>
    <message>
        <source>The servo is on. Switch the motor off first.</source>
        <translation>El servo está encendido. Apague primero el motor.</translation>
    </message>
    <message>
        <source>This chip version does not support it.</source>
        <translation>Esta versión del chip no lo admite.</translation>
    </message>
    <message>
        <source>Select at least one home condition.</source>
        <translation>Seleccione al menos una condición de referencia.</translation>
    </message>
    <message>
        <source>Enter a search distance and a time limit above 0.</source>
        <translation>Introduzca una distancia de búsqueda y un límite de tiempo mayores que 0.</translation>
    </message>
    <message>
        <source>The limit switch is already active. Move the motor off it first.</source>
        <translation>El final de carrera ya está activo. Aparte primero el motor de él.</translation>
    </message>
    <message>
        <source>This limit pin is set as an output.</source>
        <translation>Este pin de final de carrera está configurado como salida.</translation>
    </message>
    <message>
        <source>Enter a distance other than 0.</source>
        <translation>Introduzca una distancia distinta de 0.</translation>
    </message>
    <message>
        <source>This module is not a PIC-STEP.</source>
        <translation>Este módulo no es un PIC-STEP.</translation>
    </message>
    <message>
        <source>Apply parameters first.</source>
        <translation>Aplique primero los parámetros.</translation>
    </message>
    <message>
        <source>The amplifier is off. Enable it first.</source>
        <translation>El amplificador está apagado. Habilítelo primero.</translation>
    </message>
    <message>
        <source>Stop the motor first: the chip cannot change this in motion.</source>
        <translation>Pare primero el motor: el chip no puede cambiarlo en movimiento.</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input is active. Release it first.</source>
        <translation>La entrada E-Stop del módulo está activa. Libérela primero.</translation>
    </message>
    <message>
        <source>The A/D value is below the thermal limit: let the motor cool down, or lower the limit.</source>
        <translation>El valor A/D está por debajo del límite térmico: deje enfriar el motor o reduzca el límite.</translation>
    </message>
    <message>
        <source>The goal is too far away: at most 2 147 483 647 counts or steps.</source>
        <translation>El destino está demasiado lejos: como máximo 2 147 483 647 cuentas o pasos.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. Settings applied: %2.</source>
        <translation>“%1” está abierto. Ajustes aplicados: %2.</translation>
    </message>
    <message>
        <source>Commands sent: %1. No motor was moved.</source>
        <translation>Comandos enviados: %1. No se movió ningún motor.</translation>
    </message>
    <message>
        <source>Leader of group %1</source>
        <translation>Líder del grupo %1</translation>
    </message>
    <message>
        <source>Cannot be applied: the file is for another module.</source>
        <translation>No se puede aplicar: el archivo es para otro módulo.</translation>
    </message>
    <message>
        <source>Not in the chain; its settings are kept.</source>
        <translation>No está en la cadena; se conservan sus ajustes.</translation>
    </message>
    <message>
        <source>%1 was stopped and holds: it moved the wrong way, or by more than twice the step.</source>
        <translation>%1 vuelve a mantener la posición: se movió en el sentido erróneo o más del doble del escalón.</translation>
    </message>
    <message>
        <source>The servo oscillates, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.</source>
        <translation>El servo oscila, o algo externo gira el motor. Reduzca Kp y Ki o aumente Kd y repita el escalón.</translation>
    </message>
    <message>
        <source>%1 was switched off and is free to turn: it kept oscillating after its step.</source>
        <translation>%1 se apagó y puede girar libremente: siguió oscilando tras su escalón.</translation>
    </message>
    <message>
        <source>The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it.</source>
        <translation>El servo no es estable con estas ganancias. Reduzca Kp y Ki o aumente Kd, aplíquelas y después habilítelo.</translation>
    </message>
    <message>
        <source>%1 does not come to rest; its servo stays on.</source>
        <translation>%1 no llega a pararse; su servo sigue encendido.</translation>
    </message>
    <message>
        <source>It oscillates, or an external force turns it. Lower Kp and Ki, or raise Kd. Choose Motor off to end it at once.</source>
        <translation>Oscila, o una fuerza externa lo gira. Reduzca Kp y Ki o aumente Kd; “Apagar motor” pone fin a ello de inmediato.</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its motor switched itself off and is free to turn.</source>
        <translation>%1 no completó su escalón: su motor se apagó solo y puede girar libremente.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or shorten the step, then enable the motor.</source>
        <translation>El error de posición era demasiado grande o falló la alimentación del motor. Compruebe si hay un atasco, aumente EL o reduzca el escalón y después habilite el motor.</translation>
    </message>
    <message>
        <source>%1 does not answer, so its step was not recorded. Motor state unknown.</source>
        <translation>%1 no responde, por lo que su escalón no se grabó. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>It was commanded to hold. Use the hardware stop if it moves.</source>
        <translation>Se le ordenó mantener la posición. Use la parada por hardware si se mueve.</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: the link was unreliable.</source>
        <translation>Se ordenó a %1 mantener la posición, y su escalón no se grabó: el enlace no era fiable.</translation>
    </message>
    <message>
        <source>Check the link, then step again.</source>
        <translation>Compruebe el enlace y repita el escalón.</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: a command failed, or its answer was lost.</source>
        <translation>Se ordenó a %1 mantener la posición, y su escalón no se grabó: un comando falló o se perdió su respuesta.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Step again.</source>
        <translation>Suele deberse a ruido en el cable. Repita el escalón.</translation>
    </message>
    <message>
        <source>The motor does not come to rest; its servo stays on. Lower the gains, or switch the motor off.</source>
        <translation>El motor no llega a pararse; su servo sigue encendido. Reduzca las ganancias o apague el motor.</translation>
    </message>
    <message>
        <source>The motor kept oscillating by more than the whole step. It was switched off and is free to turn. Lower Kp and Ki, or raise Kd.</source>
        <translation>El motor siguió oscilando con una amplitud mayor que todo el escalón. Se apagó y puede girar libremente. Reduzca Kp y Ki o aumente Kd.</translation>
    </message>
    <message>
        <source>its folder does not exist.</source>
        <translation>su carpeta no existe.</translation>
    </message>
    <message>
        <source>this is a folder or a device, not a file.</source>
        <translation>es una carpeta o un dispositivo, no un archivo.</translation>
    </message>
    <message>
        <source>your user account has no write access.</source>
        <translation>su cuenta de usuario no tiene permiso de escritura.</translation>
    </message>
    <message>
        <source>the disk is read-only.</source>
        <translation>el disco es de solo lectura.</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>el disco está lleno.</translation>
    </message>
    <message>
        <source>the file is too large for the disk.</source>
        <translation>el archivo es demasiado grande para el disco.</translation>
    </message>
    <message>
        <source>the file was deleted.</source>
        <translation>el archivo se eliminó.</translation>
    </message>
    <message>
        <source>the disk is too slow.</source>
        <translation>el disco es demasiado lento.</translation>
    </message>
    <message>
        <source>the disk reported a write error.</source>
        <translation>el disco comunicó un error de escritura.</translation>
    </message>
    <message>
        <source>the file ends before its column names.</source>
        <translation>el archivo termina antes de los nombres de sus columnas.</translation>
    </message>
    <message>
        <source>column %1 is missing.</source>
        <translation>falta la columna %1.</translation>
    </message>
    <message>
        <source>the line is longer than %1 bytes, too long for a recording.</source>
        <translation>la línea ocupa más de %1 bytes, demasiado para una grabación.</translation>
    </message>
    <message>
        <source>the file ends in the middle of this line.</source>
        <translation>el archivo termina en medio de esta línea.</translation>
    </message>
    <message>
        <source>the line has %1 cells for %2 columns.</source>
        <translation>la línea tiene %1 celdas para %2 columnas.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 está vacío.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is not a number.</source>
        <translation>%1 es “%2”, que no es un número.</translation>
    </message>
    <message>
        <source>%1 of module %2 goes backwards.</source>
        <translation>%1 del módulo %2 retrocede.</translation>
    </message>
    <message>
        <source>Recorded &quot;%1&quot;: %2.</source>
        <translation>Grabado “%1”: %2.</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Guardado en %1.</translation>
    </message>
    <message>
        <source>The part written before (%1) is kept.</source>
        <translation>Se conserva la parte escrita antes (%1).</translation>
    </message>
    <message>
        <source>Nothing was kept.</source>
        <translation>No se conservó nada.</translation>
    </message>
    <message>
        <source>Nothing is recorded to &quot;%1&quot;: no module is connected.</source>
        <translation>No se graba nada en “%1”: no hay ningún módulo conectado.</translation>
    </message>
    <message>
        <source>Connect first, then record again.</source>
        <translation>Conecte primero y vuelva a grabar.</translation>
    </message>
    <message>
        <source>Recording to &quot;%1&quot; stopped: %2</source>
        <translation>Se detuvo la grabación en “%1”: %2</translation>
    </message>
    <message>
        <source>%1 Motor control continues. To continue recording, choose another file.</source>
        <translation>%1 El control continúa. Para seguir grabando, elija otro archivo.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a recording of NMC Panel.</source>
        <translation>“%1” no es una grabación de NMC Panel.</translation>
    </message>
    <message>
        <source>It has nothing to show. Choose another file.</source>
        <translation>No contiene nada que mostrar. Elija otro archivo.</translation>
    </message>
    <message>
        <source>The scope shows the samples above that line: %1.</source>
        <translation>El osciloscopio muestra las muestras anteriores a esa línea: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no samples.</source>
        <translation>“%1” no contiene muestras.</translation>
    </message>
    <message>
        <source>Saved &quot;%1&quot;.</source>
        <translation>Guardado “%1”.</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;.</source>
        <translation>No se pudo guardar “%1”.</translation>
    </message>
    <message>
        <source>Show the last 2 s</source>
        <translation>Mostrar los últimos 2 s</translation>
    </message>
    <message>
        <source>Stop of all motors</source>
        <translation>Parada de todos los motores</translation>
    </message>
    <message>
        <source>Too far for a step response: at most 2000 counts.</source>
        <translation>Demasiado para una respuesta al escalón: como máximo 2000 cuentas.</translation>
    </message>
    <message>
        <source>The goal is outside the chip&apos;s position range.</source>
        <translation>El destino está fuera del rango de posiciones del chip.</translation>
    </message>
    <message>
        <source>A record must be 0.02 s to 3 s long.</source>
        <translation>Una grabación debe durar de 0,02 s a 3 s.</translation>
    </message>
    <message>
        <source>No motor is moving. All motors are commanded to stop before the port closes.</source>
        <translation>Ningún motor se mueve. Se ordena parar a todos antes de cerrar el puerto.</translation>
    </message>
    <message>
        <source>Nothing was lost: the panel detects wrong answers and retries. If it gets worse, motors are commanded to stop. Usually noise on the cable.</source>
        <translation>No se perdió nada: el panel detecta las respuestas erróneas y pregunta de nuevo. Si empeora, se ordena parar a los motores. Suele deberse a ruido en el cable.</translation>
    </message>
    <message>
        <source>It listens at 19 200 Bd and may misread the other modules&apos; traffic: all motors were commanded to stop, and sending has stopped.</source>
        <translation>Escucha a 19 200 Bd y puede malinterpretar el tráfico de los demás módulos: se ordenó parar a todos los motores y ya no se envía nada.</translation>
    </message>
    <message>
        <source>The panel froze for %1; motors were commanded to stop after 2 s.</source>
        <translation>El panel se bloqueó durante %1; se ordenó parar a los motores a los 2 s.</translation>
    </message>
    <message>
        <source>It was connected to %1 and was killed, or the computer failed. Motor state unknown: look at the motor before you connect; use the hardware stop if it moves. This message stays until the motor is seen at rest.</source>
        <translation>Estaba conectada a %1 y se terminó a la fuerza, o falló el equipo. Estado del motor desconocido: observe el motor antes de conectar; use la parada por hardware si se mueve. Este mensaje permanece hasta que se vea el motor parado.</translation>
    </message>
    <message>
        <source>I have checked: it is at rest</source>
        <translation>Lo he comprobado: está parado</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 do not answer</source>
        <translation>
            <numerusform>El módulo %1 no responde</numerusform>
            <numerusform>Los módulos %1 no responden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 are off after a restart.</source>
        <translation>
            <numerusform>El módulo %1 está apagado tras reiniciarse.</numerusform>
            <numerusform>Los módulos %1 están apagados tras reiniciarse.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop but were not seen at rest</source>
        <translation>
            <numerusform>Se ordenó parar al módulo %1, pero no se le vio parado</numerusform>
            <numerusform>Se ordenó parar a los módulos %1, pero no se les vio parados</numerusform>
        </translation>
    </message>
    <message>
        <source>You can assign just its address: the other modules keep their positions and gains.</source>
        <translation>Puede asignarle solo su dirección: los demás módulos conservan sus posiciones y ganancias.</translation>
    </message>
    <message>
        <source>Assign the address of module %1</source>
        <translation>Asignar la dirección del módulo %1</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no gains.</source>
        <translation>El módulo %1 vuelve a tener su dirección. Su motor está apagado, su posición es 0 y no tiene ganancias.</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its pins are inputs, and its outputs drive nothing.</source>
        <translation>El módulo %1 vuelve a tener su dirección. Sus pines son entradas y sus salidas no gobiernan nada.</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no parameters.</source>
        <translation>El módulo %1 vuelve a tener su dirección. Su motor está apagado, su posición es 0 y no tiene parámetros.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its gains and home it before you use it.</source>
        <translation>Los demás módulos no han cambiado. Aplique sus ganancias y referéncielo antes de usarlo.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Set its outputs again before you use it.</source>
        <translation>Los demás módulos no han cambiado. Ajuste de nuevo sus salidas antes de usarlo.</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its parameters and home it before you use it.</source>
        <translation>Los demás módulos no han cambiado. Aplique sus parámetros y referéncielo antes de usarlo.</translation>
    </message>
    <message>
        <source>Could not assign the address of module %1. No motor was moved.</source>
        <translation>No se pudo asignar la dirección del módulo %1. No se movió ningún motor.</translation>
    </message>
    <message>
        <source>The module does not answer. Scan again, or restart the network.</source>
        <translation>El módulo no responde. Vuelva a buscar o reinicie la red.</translation>
    </message>
    <message>
        <source>No module is known</source>
        <translation>No se conoce ningún módulo</translation>
    </message>
    <message>
        <source>: use the hardware stop.</source>
        <translation>: use la parada por hardware.</translation>
    </message>
    <message>
        <source>No stop was confirmed.</source>
        <translation>No se confirmó ninguna parada.</translation>
    </message>
    <message>
        <source>%1 of %2 stopped.</source>
        <translation>%1 de %2 parados.</translation>
    </message>
    <message>
        <source>Module %1 has stopped.</source>
        <translation>El módulo %1 se ha parado.</translation>
    </message>
    <message>
        <source>It has stopped.</source>
        <translation>Se ha parado.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: nothing held it for over 250 ms.</source>
        <translation>Se ordenó al módulo %1 terminar el jog: nada lo mantuvo durante más de 250 ms.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: it did not confirm the command.</source>
        <translation>Se ordenó al módulo %1 terminar el jog: no confirmó el comando.</translation>
    </message>
    <message>
        <source>Module %1 did not confirm the command to jog. Nothing was started.</source>
        <translation>El módulo %1 no confirmó el comando de jog. No se inició nada.</translation>
    </message>
    <message>
        <source>The command or its answer was lost or garbled: if this recurs, check the cable. Press and hold again.</source>
        <translation>El comando o su respuesta se perdió o se corrompió: si se repite, compruebe el cable. Vuelva a mantener pulsado.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its state no longer permits it.</source>
        <translation>Se ordenó al módulo %1 terminar el jog: su estado ya no lo permite.</translation>
    </message>
    <message>
        <source>Module %1 cannot jog in its present state. Nothing was started.</source>
        <translation>El módulo %1 no puede hacer jog en su estado actual. No se inició nada.</translation>
    </message>
    <message>
        <source>Its state says why: for example, its motor is off. Press and hold again once it may move.</source>
        <translation>Su estado dice por qué: por ejemplo, su motor está apagado. Vuelva a mantener pulsado cuando pueda moverse.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its travel limit has changed.</source>
        <translation>Se ordenó al módulo %1 terminar el jog: su límite de recorrido ha cambiado.</translation>
    </message>
    <message>
        <source>Press and hold again to jog within the present limits.</source>
        <translation>Vuelva a mantener pulsado para hacer jog dentro de los límites actuales.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: it reports motion, but its position stays at %2 counts.</source>
        <translation>Se ordenó parar al módulo %1: indica movimiento, pero su posición sigue en %2 cuentas.</translation>
    </message>
    <message>
        <source>Overcurrent: module %1 limits its motor current.</source>
        <translation>Sobrecorriente: el módulo %1 limita la corriente de su motor.</translation>
    </message>
    <message>
        <source>The motor may fail to reach its goal or hold its load. Check for a jam or too heavy a load, or raise the limit. This message stays until you clear the sticky bits.</source>
        <translation>El motor puede no alcanzar su destino o no retener su carga. Compruebe si hay un atasco o una carga excesiva, o aumente el límite. Este mensaje permanece hasta que borre los bits enclavados.</translation>
    </message>
    <message>
        <source>Off, but turning</source>
        <translation>Apagado, pero gira</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>Sobrecorriente</translation>
    </message>
    <message>
        <source>The shaft moves while the motor is off: a load turns it, or it is still coasting. A stop cannot hold it; use a brake, or enable the servo.</source>
        <translation>El eje del motor se mueve con el motor apagado: una carga lo gira o aún gira por inercia. Una parada no puede retenerlo; use un freno o habilite el servo.</translation>
    </message>
    <message>
        <source>The motor is at rest, but its current was limited: it may not hold its load. This stays until you clear the sticky bits.</source>
        <translation>El motor está parado, pero su corriente se limitó: puede no retener su carga. Esto permanece hasta que borre los bits enclavados.</translation>
    </message>
    <message numerus="yes">
        <source>The panel ended without stopping its motors; its guardian commanded modules %1 to stop.</source>
        <translation>
            <numerusform>El panel terminó sin parar sus motores; su guardián ordenó parar al módulo %1.</numerusform>
            <numerusform>El panel terminó sin parar sus motores; su guardián ordenó parar a los módulos %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program was killed, or it hung. The guardian cannot see whether a motor stopped: look at the motors before you connect; use the hardware stop if one moves.</source>
        <translation>El programa se terminó a la fuerza o se colgó. El guardián no puede ver si un motor se paró: observe los motores antes de conectar; use la parada por hardware si alguno se mueve.</translation>
    </message>
    <message>
        <source>The panel stalled while a motor was moving; its guardian commanded the motors to stop.</source>
        <translation>El panel quedó bloqueado con un motor en movimiento; su guardián ordenó parar a los motores.</translation>
    </message>
    <message>
        <source>The program was halted, or the computer was too busy. The panel is reading all values again.</source>
        <translation>El programa se suspendió o el equipo estaba demasiado ocupado. El panel está leyendo de nuevo todos los valores.</translation>
    </message>
    <message>
        <source>No guardian: if this program is killed, nothing stops the motors.</source>
        <translation>Sin guardián: si este programa se termina a la fuerza, nada detiene los motores.</translation>
    </message>
    <message>
        <source>nmcguard is missing. Reinstall the program. Everything else works.</source>
        <translation>Falta nmcguard. Reinstale el programa. Todo lo demás funciona.</translation>
    </message>
    <message>
        <source>Your user account has no permission to start nmcguard. Reinstall the program. Everything else works.</source>
        <translation>Su cuenta de usuario no puede iniciar nmcguard. Reinstale el programa. Todo lo demás funciona.</translation>
    </message>
    <message>
        <source>nmcguard and this program have different versions. Reinstall both. Everything else works.</source>
        <translation>nmcguard y este programa tienen versiones distintas. Reinstale ambos. Todo lo demás funciona.</translation>
    </message>
    <message>
        <source>The computer ran out of memory or open files. Close other programs, then connect again. Everything else works.</source>
        <translation>El equipo se quedó sin memoria o alcanzó el máximo de archivos abiertos. Cierre otros programas y conecte de nuevo. Todo lo demás funciona.</translation>
    </message>
    <message>
        <source>The guardian ended unexpectedly. Connect again to restart it. Everything else works.</source>
        <translation>El guardián terminó inesperadamente. Conecte de nuevo para reiniciarlo. Todo lo demás funciona.</translation>
    </message>
    <message>
        <source>These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses power, a running motor keeps running, and no program can stop it. STOP ALL and Esc work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs.</source>
        <translation>Estos módulos no vigilan el enlace: si se corta el cable, se bloquea el adaptador o este equipo se queda sin corriente, un motor en marcha sigue en marcha y ningún programa puede pararlo. PARAR TODO y Esc solo funcionan mientras funcione el enlace. Un guardián detiene los motores si este programa se termina a la fuerza, falla o se cuelga.</translation>
    </message>
    <message>
        <source>Use --serve alone or as --serve=control.</source>
        <translation>--serve se usa solo o con =control.</translation>
    </message>
    <message>
        <source>--read-only requires --port or --simulator.</source>
        <translation>--read-only requiere --port o --simulator.</translation>
    </message>
    <message>
        <source>Module %1 of this chain does not answer. Motor state unknown.</source>
        <translation>El módulo %1 de esta cadena no responde. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>Check its power and the plug next to it; the panel keeps trying. If you removed it on purpose, work with the others: the panel then forgets it and its settings.</source>
        <translation>Compruebe su alimentación y el conector contiguo; el panel sigue intentándolo. Si lo retiró a propósito, trabaje con los demás: el panel lo olvida entonces, junto con sus ajustes.</translation>
    </message>
    <message>
        <source>A motor is moving, so the chain was not changed.</source>
        <translation>Un motor está en movimiento, por lo que la cadena no se cambió.</translation>
    </message>
    <message>
        <source>Forgetting a module rescans the chain. Stop all motors, then try again.</source>
        <translation>Para olvidar un módulo se vuelven a buscar los módulos de la cadena. Pare todos los motores e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses module %3, so the chain was not changed.</source>
        <translation>La fila %1 de “%2” usa el módulo %3, por lo que la cadena no se cambió.</translation>
    </message>
    <message>
        <source>The row is for another type of module than the one found there. Change or remove it first, then try again.</source>
        <translation>La fila es para otro tipo de módulo que el encontrado en ese lugar. Cámbiela o quítela primero e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Forgetting a module removes its axis from the machine. Change or remove that row first, then try again.</source>
        <translation>Al olvidar un módulo se quita su eje de la máquina. Cambie o quite primero esa fila e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Connected to %1 read-only: %2 at %3 Bd, left running.</source>
        <translation>Conectado a %1 en solo lectura: %2 a %3 Bd, sin alterar su marcha.</translation>
    </message>
    <message>
        <source>The modules carry on, even after you disconnect. Only status requests are sent. STOP ALL still works.</source>
        <translation>Los módulos siguen con lo que hacían, incluso después de desconectar. Solo se envían consultas de estado. PARAR TODO sigue funcionando.</translation>
    </message>
    <message>
        <source>A port is already open.</source>
        <translation>Ya hay un puerto abierto.</translation>
    </message>
    <message>
        <source>Disconnect first, then try again. Closing the port may stop motors.</source>
        <translation>Desconecte primero e inténtelo de nuevo. Cerrar el puerto puede parar motores.</translation>
    </message>
    <message numerus="yes">
        <source>Motors %1 were moving, at %2.</source>
        <translation>
            <numerusform>El motor %1 estaba en movimiento, en %2.</numerusform>
            <numerusform>Los motores %1 estaban en movimiento, en %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>This message stays until the motor is seen at rest.</source>
        <translation>Este mensaje permanece hasta que se vea el motor parado.</translation>
    </message>
    <message>
        <source>Look first (read-only)</source>
        <translation>Observar antes (solo lectura)</translation>
    </message>
    <message>
        <source>This connection is read-only. Connect fully first.</source>
        <translation>Esta conexión es de solo lectura. Elija primero “Conexión completa”.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, read-only</source>
        <translation>Conectado a %1 a %2 Bd, %3, solo lectura</translation>
    </message>
    <message>
        <source>Only the adapter&apos;s echo came back from %1: no module answered.</source>
        <translation>De %1 solo volvió el eco del adaptador: no respondió ningún módulo.</translation>
    </message>
    <message>
        <source>The echo is harmless. Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the modules&apos; transmit pair is wired to the adapter.</source>
        <translation>El eco es inofensivo. Compruebe, en este orden: la alimentación de los módulos; todos los cables de la cadena, pues uno solo suelto oculta todos los módulos; que el par de transmisión de los módulos esté conectado al adaptador.</translation>
    </message>
    <message>
        <source>The adapter at %1 echoes everything it sends. The panel ignores the echo.</source>
        <translation>El adaptador de %1 devuelve el eco de todo lo que envía. El panel ignora el eco.</translation>
    </message>
    <message>
        <source>This is normal for a 2-wire adapter. No action needed.</source>
        <translation>Es normal en un adaptador de 2 hilos. No hay que hacer nada.</translation>
    </message>
    <message>
        <source>no exact echo of the command before it</source>
        <translation>sin eco exacto del comando anterior</translation>
    </message>
    <message>
        <source>Another host is sending on this line.</source>
        <translation>Otro equipo está enviando por esta línea.</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop.</source>
        <translation>
            <numerusform>Se ordenó parar al módulo %1.</numerusform>
            <numerusform>Se ordenó parar a los módulos %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Modules answer commands that this panel did not send; running tasks were cancelled. Close the other program, or disconnect its computer from the line, before you continue.</source>
        <translation>Hay módulos que responden a comandos que este panel no envió; se cancelaron las tareas en curso. Cierre el otro programa o desconecte su equipo de la línea antes de continuar.</translation>
    </message>
    <message>
        <source>Module %1 moves without a command from this panel.</source>
        <translation>El módulo %1 se mueve sin un comando de este panel.</translation>
    </message>
    <message>
        <source>Another host on this line started it, or a load drives it. The panel does not stop it unless you do; the other host may start it again.</source>
        <translation>Lo puso en marcha otro equipo de esta línea, o lo arrastra una carga. El panel no lo detiene si usted no lo ordena; el otro equipo puede volver a ponerlo en marcha.</translation>
    </message>
    <message>
        <source>Home is unknown: search for it, or save it.</source>
        <translation>La referencia se desconoce: búsquela o guárdela.</translation>
    </message>
    <message>
        <source>Friction holds it %1 off home, too far to set the position to 0. Raise Ki and IL on the Gains page, or clear &quot;Set position to 0&quot; on the Homing page. The tolerance follows from the unit on the Axis page.</source>
        <translation>El rozamiento lo retiene a %1 de la referencia, demasiado lejos para poner la posición a 0. Aumente Ki e IL en la página Ganancias o desmarque “Poner posición a 0” en la página Referenciado. La tolerancia depende de la unidad de la página Eje.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor is off.</source>
        <translation>Prueba de sentido de %1 no concluyente; su motor está apagado.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor was commanded to switch off.</source>
        <translation>Prueba de sentido de %1 no concluyente; se ordenó apagar su motor.</translation>
    </message>
    <message>
        <source>It turned farther than the check allows: something else turns it, or it coasts for a long time. Wait until it is at rest, then check again.</source>
        <translation>Giró más de lo que permite la prueba: algo externo lo gira o tarda mucho en pararse por inercia. Espere a que esté parado y repita la prueba.</translation>
    </message>
    <message>
        <source>It does not come to rest although nothing drives it. Find what turns it, then check again.</source>
        <translation>No llega a pararse aunque nada lo acciona. Averigüe qué lo gira y repita la prueba.</translation>
    </message>
    <message>
        <source>The link was unreliable. Check the link, then repeat the direction check.</source>
        <translation>El enlace no era fiable. Compruebe el enlace y repita la prueba de sentido.</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive: it does not answer. Motor state unknown.</source>
        <translation>Prueba de sentido de %1 no concluyente: no responde. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>It was commanded to switch off. Use the hardware stop if it moves.</source>
        <translation>Se le ordenó apagar el motor. Use la parada por hardware si se mueve.</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Repeat the direction check.</source>
        <translation>Un comando falló o se perdió su respuesta. Repita la prueba de sentido.</translation>
    </message>
    <message>
        <source>%1: motor and encoder directions match.</source>
        <translation>%1: los sentidos del motor y del encoder coinciden.</translation>
    </message>
    <message>
        <source>%1: motor or encoder is reversed. Do not enable it.</source>
        <translation>%1: el motor o el encoder está invertido. No lo habilite.</translation>
    </message>
    <message>
        <source>%1 did not move when driven.</source>
        <translation>%1 no se movió al empujarlo.</translation>
    </message>
    <message>
        <source>%1 closed a limit switch; the check has ended.</source>
        <translation>%1 cerró un final de carrera, por lo que no se siguió empujando.</translation>
    </message>
    <message>
        <source>%1 lost motor power while being driven.</source>
        <translation>%1 perdió la alimentación del motor mientras se empujaba.</translation>
    </message>
    <message>
        <source>%1 did not move in both directions.</source>
        <translation>%1 no se movió en ambos sentidos.</translation>
    </message>
    <message>
        <source>It is at rest %1 from home; its position there is 0.</source>
        <translation>Queda parado a %1 de la referencia; ahí su posición es 0.</translation>
    </message>
    <message>
        <source>It rests too far from home to set the position to 0. Raise Ki and IL on the Gains page.</source>
        <translation>Queda parado demasiado lejos de la referencia para poner la posición a 0. Aumente Ki e IL en la página Ganancias.</translation>
    </message>
    <message>
        <source>OK: it counts up when driven forward and down in reverse. You can enable it.</source>
        <translation>Correcto: cuenta hacia arriba al accionarlo hacia adelante y hacia abajo al accionarlo hacia atrás. Puede habilitarlo.</translation>
    </message>
    <message>
        <source>Reversed: it counts down when driven forward and would run away when enabled. Swap the two motor leads, or encoder A and B, then check again.</source>
        <translation>Invertido: cuenta hacia abajo al accionarlo hacia adelante y se embalaría al habilitarlo. Cruce los dos cables del motor, o A y B del encoder, y repita la prueba.</translation>
    </message>
    <message>
        <source>No movement at %1 % of the supply, with motor power present. Check for a jam, a brake or too heavy a load, and check the motor and encoder cables.</source>
        <translation>Sin movimiento al %1 % de la alimentación, con el motor alimentado. Compruebe si hay un atasco, un freno o una carga excesiva, y revise los cables del motor y del encoder.</translation>
    </message>
    <message>
        <source>A limit switch is active: it may cut the motor&apos;s power.</source>
        <translation>Un final de carrera está activo: puede cortar la alimentación del motor.</translation>
    </message>
    <message>
        <source>Limit switch 1 closed during the move.</source>
        <translation>El final de carrera 1 se cerró durante el movimiento.</translation>
    </message>
    <message>
        <source>Limit switch 2 closed during the move.</source>
        <translation>El final de carrera 2 se cerró durante el movimiento.</translation>
    </message>
    <message>
        <source>Turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>Gire a mano el motor para alejarlo del final de su recorrido y repita la prueba.</translation>
    </message>
    <message>
        <source>Motor power failed. Switch it on, then check again.</source>
        <translation>Falló la alimentación del motor. Conéctela y repita la prueba.</translation>
    </message>
    <message>
        <source>Unclear: it moved in one direction only, or twice in the same direction. Something blocks or turns it. Remove the load, turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>No está claro: se movió en un solo sentido o dos veces en el mismo. Algo lo bloquea o lo gira. Retire la carga, gire a mano el motor para alejarlo del final de su recorrido y repita la prueba.</translation>
    </message>
    <message>
        <source>Check for a jam, or raise EL on the Gains page.</source>
        <translation>Compruebe si hay un atasco o aumente EL en la página Ganancias.</translation>
    </message>
    <message>
        <source>It ran away from its goal: motor or encoder is probably reversed. Run the direction check on the Axis page before you enable it again.</source>
        <translation>Se embaló alejándose de su destino: el motor o el encoder está probablemente invertido. Haga la prueba de sentido en la página Eje antes de habilitarlo de nuevo.</translation>
    </message>
    <message>
        <source>It was driven but did not move: check for a jam, a brake or a hard stop, and check the motor cable. If it is only hard to turn, raise OL on the Gains page.</source>
        <translation>Se accionó pero no se movió: compruebe si hay un atasco, un freno o un tope mecánico, y revise el cable del motor. Si solo cuesta girarlo, aumente OL en la página Ganancias.</translation>
    </message>
    <message>
        <source>Limit switch 1 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>Se cerró el final de carrera 1: está probablemente al final de su recorrido. Muévalo en el otro sentido. Para que se detenga a tiempo, arme una parada por límite en la página Referenciado.</translation>
    </message>
    <message>
        <source>Limit switch 2 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>Se cerró el final de carrera 2: está probablemente al final de su recorrido. Muévalo en el otro sentido. Para que se detenga a tiempo, arme una parada por límite en la página Referenciado.</translation>
    </message>
    <message>
        <source>It moved correctly but could not keep up: lower its velocity or acceleration, or raise OL and EL on the Gains page.</source>
        <translation>Se movió bien pero no pudo seguir: reduzca su velocidad o aceleración, o aumente OL y EL en la página Ganancias.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving.</source>
        <translation>El final de carrera %1 del módulo %2 se cerró con su motor en movimiento.</translation>
    </message>
    <message>
        <source>While the switch is closed, the module blocks this direction. Move the motor the other way.</source>
        <translation>Mientras el interruptor está cerrado, el módulo bloquea este sentido. Mueva el motor en el otro sentido.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving, but does not stop it.</source>
        <translation>El final de carrera %1 del módulo %2 se cerró con su motor en movimiento, pero no lo detiene.</translation>
    </message>
    <message>
        <source>A PIC-SERVO stops at a limit switch only while a limit stop is armed. Stop the motor, then move it the other way. Arm a limit stop on the Homing page.</source>
        <translation>Un PIC-SERVO se detiene en un final de carrera solo mientras hay una parada por límite armada. Pare el motor y muévalo en el otro sentido. Arme una parada por límite en la página Referenciado.</translation>
    </message>
    <message>
        <source>The limit stop of module %1 switched its motor off.</source>
        <translation>La parada por límite del módulo %1 apagó su motor.</translation>
    </message>
    <message>
        <source>The limit stop of module %1 stopped its motor.</source>
        <translation>La parada por límite del módulo %1 paró su motor.</translation>
    </message>
    <message>
        <source>A limit stop acts once. Move the motor off the switch, then arm or disarm the limit stop on the Homing page.</source>
        <translation>Una parada por límite actúa una sola vez. Aparte el motor del interruptor y después arme o desarme la parada por límite en la página Referenciado.</translation>
    </message>
    <message>
        <source>Saving %1. The window closes when it is saved.</source>
        <translation>Guardando %1. La ventana se cerrará cuando esté guardado.</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 was moving.</source>
        <translation>Estado del motor desconocido: %1 estaba en movimiento.</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 were moving.</source>
        <translation>Estado de los motores desconocido: %1 estaban en movimiento.</translation>
    </message>
    <message>
        <source>Operator permissions</source>
        <translation>Permitido al operador</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Habilitar</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Jog</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>Puntos y secuencias</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Movimientos</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Salidas</translation>
    </message>
    <message>
        <source>Module %1 was %2 from home when last seen.</source>
        <translation>El módulo %1 estaba a %2 de la referencia en la última lectura.</translation>
    </message>
    <message>
        <source>That was on %1; a search had found home. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>Eso fue el %1; una búsqueda había encontrado la referencia. Si nada ha movido el eje desde entonces, puede restaurar así la referencia. Queda sin verificar hasta la próxima búsqueda.</translation>
    </message>
    <message>
        <source>That was on %1; home had been saved. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>Eso fue el %1; la referencia se había guardado. Si nada ha movido el eje desde entonces, puede restaurar así la referencia. Queda sin verificar hasta la próxima búsqueda.</translation>
    </message>
    <message>
        <source>That was on %1; the position had been confirmed. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>Eso fue el %1; la posición se había confirmado. Si nada ha movido el eje desde entonces, puede restaurar así la referencia. Queda sin verificar hasta la próxima búsqueda.</translation>
    </message>
    <message>
        <source>Restore home</source>
        <translation>Restaurar referencia</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Messages are lost when this session ends.</source>
        <translation>Los mensajes se pierden al terminar esta sesión.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. To keep messages, export the message list.</source>
        <translation>No se puede escribir en %1. Todo lo demás funciona. Para conservar los mensajes, exporte la lista de mensajes.</translation>
    </message>
    <message>
        <source>What led to that message is no longer kept.</source>
        <translation>Lo que llevó a ese mensaje ya no se conserva.</translation>
    </message>
    <message>
        <source>The last %1 faults and stops can be shown. A recording keeps everything.</source>
        <translation>Se pueden mostrar los últimos %1 fallos y paradas. Una grabación lo conserva todo.</translation>
    </message>
    <message>
        <source>The positions of the axes are not saved.</source>
        <translation>Las posiciones de los ejes no se guardan.</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. If the modules lose power now, search for home again: an older position may be offered.</source>
        <translation>No se puede escribir en %1. Todo lo demás funciona. Si los módulos se quedan ahora sin alimentación, vuelva a buscar la referencia: puede que se ofrezca una posición más antigua.</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 stopped its motor.</source>
        <translation>El final de carrera %1 del módulo %2 paró su motor.</translation>
    </message>
    <message>
        <source>The E-stop input of module %1 is active: its motor is on but cannot move.</source>
        <translation>La entrada E-Stop del módulo %1 está activa: su motor está encendido pero no se puede mover.</translation>
    </message>
    <message>
        <source>Release the input. This does not start a motion.</source>
        <translation>Libere la entrada. Esto no inicia ningún movimiento.</translation>
    </message>
    <message>
        <source>Not allowed in operator mode. Leave operator mode first.</source>
        <translation>No permitido en modo operador. Salga primero del modo operador.</translation>
    </message>
    <message>
        <source>Load the move first, then choose Start: this way a garbled load never moves the motor.</source>
        <translation>Cargue primero el movimiento y después elija Iniciar: así una carga corrupta nunca mueve el motor.</translation>
    </message>
    <message>
        <source>it has no name.</source>
        <translation>no tiene nombre.</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is already used.</source>
        <translation>el nombre “%1” ya está en uso.</translation>
    </message>
    <message>
        <source>module %1 appears twice.</source>
        <translation>el módulo %1 aparece dos veces.</translation>
    </message>
    <message>
        <source>point &quot;%1&quot; does not exist.</source>
        <translation>el punto “%1” no existe.</translation>
    </message>
    <message>
        <source>sequence &quot;%1&quot; does not exist.</source>
        <translation>la secuencia “%1” no existe.</translation>
    </message>
    <message>
        <source>this row makes the sequence &quot;%1&quot; call itself endlessly.</source>
        <translation>esta fila hace que la secuencia “%1” se llame a sí misma sin fin.</translation>
    </message>
    <message>
        <source>a repeat must go back to an earlier row.</source>
        <translation>una repetición debe volver a una fila anterior.</translation>
    </message>
    <message>
        <source>Order of Home all</source>
        <translation>Orden de “Referenciar todo”</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punto %1</translation>
    </message>
    <message>
        <source>Sequence %1</source>
        <translation>Secuencia %1</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Introduzca un nombre.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is already used. Choose another one.</source>
        <translation>El nombre “%1” ya está en uso. Elija otro.</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; contains %1 twice.</source>
        <translation>El punto “%2” contiene %1 dos veces.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; does not exist.</source>
        <translation>El punto “%1” no existe.</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot; does not exist.</source>
        <translation>La secuencia “%1” no existe.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; would call itself endlessly.</source>
        <translation>La secuencia “%1” se llamaría a sí misma sin fin.</translation>
    </message>
    <message>
        <source>A repeat must go back to an earlier row.</source>
        <translation>Una repetición debe volver a una fila anterior.</translation>
    </message>
    <message>
        <source>The sequence has no rows. Add a row first.</source>
        <translation>La secuencia no tiene filas. Añada primero una fila.</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; has no axes. Teach it again.</source>
        <translation>El punto “%1” no tiene ejes. Memorícelo de nuevo.</translation>
    </message>
    <message>
        <source>%1 is not in the chain.</source>
        <translation>%1 no está en la cadena.</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; was taught before home of %1 was known, so it may have shifted. Teach it again.</source>
        <translation>El punto “%2” se memorizó antes de conocer la referencia de %1, por lo que puede haberse desplazado. Memorícelo de nuevo.</translation>
    </message>
    <message>
        <source>Homing of %1 is not set up. Set it up on its Homing page.</source>
        <translation>El referenciado de %1 no está configurado. Configúrelo en su página Referenciado.</translation>
    </message>
    <message>
        <source>%1 does not have this input or output.</source>
        <translation>%1 no tiene esta entrada o salida.</translation>
    </message>
    <message>
        <source>The outputs of %1 are unknown. Set them once on the module&apos;s page.</source>
        <translation>Las salidas de %1 se desconocen. Fíjelas una vez en la página del módulo.</translation>
    </message>
    <message>
        <source>A run from the top never gets here: an earlier row repeats forever.</source>
        <translation>Una ejecución desde el principio nunca llega aquí: una fila anterior se repite sin fin.</translation>
    </message>
    <message>
        <source>At this row, %1 must be at home. Move it there first.</source>
        <translation>En esta fila, %1 debe estar en la referencia. Llévelo allí primero.</translation>
    </message>
    <message>
        <source>At this row, %1 must be at point &quot;%2&quot;. Move it there first.</source>
        <translation>En esta fila, %1 debe estar en el punto “%2”. Llévelo allí primero.</translation>
    </message>
    <message>
        <source>At this row, output %1 of %2 must be in the opposite state. Set it first.</source>
        <translation>En esta fila, la salida %1 de %2 debe estar conmutada. Conmútela primero.</translation>
    </message>
    <message>
        <source>You stopped it.</source>
        <translation>Usted ordenó la parada.</translation>
    </message>
    <message>
        <source>All motors were stopped.</source>
        <translation>Se pararon todos los motores.</translation>
    </message>
    <message>
        <source>%1 received another command, or something else moved it.</source>
        <translation>%1 recibió otro comando, o algo distinto lo movió.</translation>
    </message>
    <message>
        <source>A limit switch of %1 closed during the move.</source>
        <translation>Un final de carrera de %1 se cerró durante el movimiento.</translation>
    </message>
    <message>
        <source>%1 stopped before it reached its goal.</source>
        <translation>%1 se paró antes de alcanzar su destino.</translation>
    </message>
    <message>
        <source>The motor of %1 switched off.</source>
        <translation>El motor de %1 se apagó.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become high within %3 s.</source>
        <translation>%1 de %2 no pasó a nivel alto en %3 s.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become low within %3 s.</source>
        <translation>%1 de %2 no pasó a nivel bajo en %3 s.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become active within %3 s.</source>
        <translation>%1 de %2 no pasó a activo en %3 s.</translation>
    </message>
    <message>
        <source>%1 of %2 did not become inactive within %3 s.</source>
        <translation>%1 de %2 no pasó a inactivo en %3 s.</translation>
    </message>
    <message>
        <source>%1 did not find home.</source>
        <translation>%1 no encontró la referencia.</translation>
    </message>
    <message>
        <source>The link was unreliable.</source>
        <translation>El enlace no era fiable.</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1 no responde.</translation>
    </message>
    <message>
        <source>%1 refused or did not answer a command.</source>
        <translation>%1 rechazó un comando o no respondió a él.</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, fila %2</translation>
    </message>
    <message>
        <source>%1, pass %2</source>
        <translation>%1, pasada %2</translation>
    </message>
    <message>
        <source>Move to &quot;%1&quot;</source>
        <translation>Movimiento a “%1”</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot;</source>
        <translation>Secuencia “%1”</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4 in all, moves: %5</source>
        <translation>%1: de %2 a %3, %4 en total, movimientos: %5</translation>
    </message>
    <message>
        <source>move to</source>
        <translation>mover a</translation>
    </message>
    <message>
        <source>wait</source>
        <translation>esperar</translation>
    </message>
    <message>
        <source>wait for arrival</source>
        <translation>esperar llegada</translation>
    </message>
    <message>
        <source>wait for input</source>
        <translation>esperar entrada</translation>
    </message>
    <message>
        <source>set output</source>
        <translation>fijar salida</translation>
    </message>
    <message>
        <source>find home</source>
        <translation>buscar referencia</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>repetir</translation>
    </message>
    <message>
        <source>call</source>
        <translation>llamar</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>interruptor de referencia</translation>
    </message>
    <message>
        <source>%1: %2 from home</source>
        <translation>%1: a %2 de la referencia</translation>
    </message>
    <message>
        <source>%1: at %2, home unknown</source>
        <translation>%1: en %2, referencia desconocida</translation>
    </message>
    <message>
        <source>%1, row %2: %3</source>
        <translation>%1, fila %2: %3</translation>
    </message>
    <message>
        <source>Running: %1</source>
        <translation>En ejecución: %1</translation>
    </message>
    <message>
        <source>Finishing its row, then pausing: %1</source>
        <translation>Termina su fila y después pausa: %1</translation>
    </message>
    <message>
        <source>Paused before: %1</source>
        <translation>En pausa antes de: %1</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>Parando: %1</translation>
    </message>
    <message>
        <source>Ended: %1. %2</source>
        <translation>Terminó: %1. %2</translation>
    </message>
    <message>
        <source>%1 is done.</source>
        <translation>%1: completado.</translation>
    </message>
    <message>
        <source>%1 ended, and its motors were commanded to stop.</source>
        <translation>%1 terminó, y se ordenó parar a sus motores.</translation>
    </message>
    <message>
        <source>It was at: %1. To continue, select a row and choose Run from row. Nothing restarts on its own.</source>
        <translation>Estaba en: %1. Para continuar, seleccione una fila y elija “Ejecutar desde fila”. Nada se reanuda por sí solo.</translation>
    </message>
    <message>
        <source>Nothing was started.</source>
        <translation>No se inició nada.</translation>
    </message>
    <message>
        <source>Dry run: the sequence would not start.</source>
        <translation>Simulación: la secuencia no se iniciaría.</translation>
    </message>
    <message>
        <source>Dry run: the simulation was not ready. Try again.</source>
        <translation>Simulación: no estaba lista. Inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Dry run: %1 cannot be simulated. %2</source>
        <translation>Simulación: no se puede simular %1. %2</translation>
    </message>
    <message>
        <source>Dry run: cut off after %1 s.</source>
        <translation>Simulación: interrumpida a los %1 s.</translation>
    </message>
    <message>
        <source>Dry run: done after %1 s.</source>
        <translation>Simulación: terminada a los %1 s.</translation>
    </message>
    <message>
        <source>Dry run: it would end after %1 s. %2</source>
        <translation>Simulación: terminaría a los %1 s. %2</translation>
    </message>
    <message>
        <source>Homing takes longer in reality: %1.</source>
        <translation>En la realidad el referenciado tarda más: %1.</translation>
    </message>
    <message>
        <source>Inputs were assumed to change at once.</source>
        <translation>Se supuso que las entradas cambian de inmediato.</translation>
    </message>
    <message>
        <source>An endless repeat ran once.</source>
        <translation>Una repetición sin fin se ejecutó una vez.</translation>
    </message>
    <message>
        <source>Simulated motors were used; real motors may take longer.</source>
        <translation>Se usaron motores simulados; los reales pueden tardar más.</translation>
    </message>
    <message>
        <source>the lowest position is not below the highest.</source>
        <translation>la posición mínima no está por debajo de la máxima.</translation>
    </message>
    <message>
        <source>Lowest position, from home</source>
        <translation>Posición mínima, desde la referencia</translation>
    </message>
    <message>
        <source>Highest position, from home</source>
        <translation>Posición máxima, desde la referencia</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>Velocidad máxima</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Sobrerrecorrido</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>Armed for each motion</source>
        <translation>Armada en cada movimiento</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within its travel limits or at its last known position.</source>
        <translation>%1 se paró: no se encontró la referencia dentro de sus límites de recorrido ni en su último lugar.</translation>
    </message>
    <message>
        <source>Check the switch and its cable, and the search direction. If the position is wrong, choose Position in doubt on the Axis page: the next search then uses only its search distance.</source>
        <translation>Compruebe el interruptor y su cable, y el sentido de búsqueda. Si la posición es errónea, elija “Posición dudosa” en la página Eje: la próxima búsqueda usará entonces solo su distancia de búsqueda.</translation>
    </message>
    <message>
        <source>Taking up backlash</source>
        <translation>Compensando la holgura</translation>
    </message>
    <message>
        <source>The move would exceed the travel limits. The motor was stopped.</source>
        <translation>El movimiento superaría los límites de recorrido. Se paró el motor.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop just before its travel limit.</source>
        <translation>Se ordenó parar al módulo %1 justo antes de su límite de recorrido.</translation>
    </message>
    <message>
        <source>The chip does not end this kind of motion by itself, so the panel did. Check the position before you continue.</source>
        <translation>El chip no termina por sí solo este tipo de movimiento, así que lo hizo el panel. Compruebe la posición antes de continuar.</translation>
    </message>
    <message>
        <source>That is beyond this axis&apos;s travel limits (Axis page).</source>
        <translation>Está fuera de los límites de recorrido de este eje (página Eje).</translation>
    </message>
    <message>
        <source>Travel limit reached. Move in the other direction.</source>
        <translation>Límite de recorrido alcanzado. Vaya en el otro sentido.</translation>
    </message>
    <message>
        <source>That exceeds this axis&apos;s highest velocity (Axis page).</source>
        <translation>Supera la velocidad máxima de este eje (página Eje).</translation>
    </message>
    <message>
        <source>Stop first: a run towards a travel limit must start from standstill, so that the chip can end it there.</source>
        <translation>Pare primero: una marcha hacia un límite de recorrido debe empezar con el motor parado, para que el chip pueda terminarla allí.</translation>
    </message>
    <message>
        <source>Wait until the limit stop of this axis is armed.</source>
        <translation>Espere a que se arme la parada por límite de este eje.</translation>
    </message>
    <message>
        <source>The current limit CL is 0 or unknown, so current cannot stop the motor. Apply a CL first.</source>
        <translation>El límite de corriente CL es 0 o desconocido, por lo que la corriente no puede parar el motor. Aplique primero un CL.</translation>
    </message>
    <message>
        <source>A limit switch, overheating or the E-stop input ended the move. The motor is at rest.</source>
        <translation>Un final de carrera, un sobrecalentamiento o la entrada E-Stop terminó el movimiento. El motor está parado.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed setting their position to 0.</source>
        <translation>No todos los módulos del grupo %1 confirmaron que pusieron su posición a 0.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed clearing their sticky bits. A persistent fault sets its bit again at once.</source>
        <translation>No todos los módulos del grupo %1 confirmaron que borraron sus bits enclavados. Un fallo que persiste vuelve a activar su bit de inmediato.</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed the command.</source>
        <translation>No todos los módulos del grupo %1 confirmaron el comando.</translation>
    </message>
    <message>
        <source>A group command requires that every member answers and can carry it out in its present state, and that the group of every module is known. Command the modules one by one, or set this module&apos;s group again.</source>
        <translation>Un comando de grupo exige que todos los miembros respondan y puedan ejecutarlo en su estado, y que se conozca el grupo de todos los módulos. Envíe los comandos módulo a módulo o asigne de nuevo su grupo a este módulo.</translation>
    </message>
    <message>
        <source>Group %1 was commanded to switch its motors off: module %2.</source>
        <translation>Se ordenó al grupo %1 apagar sus motores: módulo %2.</translation>
    </message>
    <message>
        <source>Group %1 was commanded to stop: module %2.</source>
        <translation>Se ordenó parar al grupo %1: módulo %2.</translation>
    </message>
    <message>
        <source>This computer&apos;s port does not support %1 Bd. Choose another baud rate.</source>
        <translation>El puerto de este equipo no admite %1 Bd. Elija otra velocidad en baudios.</translation>
    </message>
    <message>
        <source>Module %1 now has address %2. Position, gains and group are unchanged.</source>
        <translation>El módulo %1 tiene ahora la dirección %2. Su posición, sus ganancias y su grupo no han cambiado.</translation>
    </message>
    <message>
        <source>The address is used by another module or not allowed. Choose a free address from 1 to 127.</source>
        <translation>Otro módulo usa esa dirección, o no está permitida. Elija una dirección libre de 1 a 127.</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Set its group first, or none.</source>
        <translation>Su grupo se desconoce y cambiaría con la dirección. Asígnele primero un grupo, o ninguno.</translation>
    </message>
    <message>
        <source>Another module without an address would take it. Assign that module&apos;s address first, or restart the network.</source>
        <translation>Otro módulo sin dirección la tomaría. Asigne primero la dirección de ese módulo o reinicie la red.</translation>
    </message>
    <message>
        <source>The exact position that the servo holds is unknown. Choose Hold here first, or move the motor.</source>
        <translation>Se desconoce la posición exacta que mantiene el servo. Elija primero “Mantener aquí” o mueva el motor.</translation>
    </message>
    <message>
        <source>Module %1 oscillates while it holds its position.</source>
        <translation>El módulo %1 mantiene la posición, y su motor oscila.</translation>
    </message>
    <message>
        <source>Its servo is not stable with these gains. Lower Kp and Ki, or raise Kd, and apply them.</source>
        <translation>Su servo no es estable con estas ganancias. Reduzca Kp y Ki o aumente Kd, y aplíquelas.</translation>
    </message>
    <message>
        <source>Restore previous gains</source>
        <translation>Restaurar ganancias anteriores</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it began to oscillate.</source>
        <translation>%1 vuelve a sus ganancias anteriores: empezó a oscilar.</translation>
    </message>
    <message>
        <source>Lower Kp and Ki, or raise Kd, then try again.</source>
        <translation>Reduzca Kp y Ki o aumente Kd e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it left its position.</source>
        <translation>%1 vuelve a sus ganancias anteriores: se salió de su posición.</translation>
    </message>
    <message>
        <source>These gains do not hold its load, or something else turned it.</source>
        <translation>Estas ganancias no retienen su carga, o algo externo lo giró.</translation>
    </message>
    <message>
        <source>%1 switched itself off while gains were being tried, and is free to turn.</source>
        <translation>%1 se apagó solo mientras se probaban ganancias y puede girar libremente.</translation>
    </message>
    <message>
        <source>Its previous gains were sent again. Check for a jam, then enable it.</source>
        <translation>Se enviaron de nuevo sus ganancias anteriores. Compruebe si hay un atasco y después habilítelo.</translation>
    </message>
    <message>
        <source>%1 does not answer while gains are being tried. Motor state unknown.</source>
        <translation>%1 no responde mientras se prueban ganancias. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>Its previous gains were sent. Use the hardware stop if it moves.</source>
        <translation>Se enviaron sus ganancias anteriores. Use la parada por hardware si se mueve.</translation>
    </message>
    <message>
        <source>The new gains of %1 are in force; OL may still be lowered.</source>
        <translation>Las nuevas ganancias de %1 están en vigor; puede que OL siga reducido.</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Apply the gains again.</source>
        <translation>Un comando falló o se perdió su respuesta. Aplique de nuevo las ganancias.</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: the link was unreliable.</source>
        <translation>Se enviaron de nuevo las ganancias anteriores de %1: el enlace no era fiable.</translation>
    </message>
    <message>
        <source>Check the link, then try again.</source>
        <translation>Compruebe el enlace e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: a command failed, or its answer was lost.</source>
        <translation>Se enviaron de nuevo las ganancias anteriores de %1: un comando falló o se perdió su respuesta.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Try again.</source>
        <translation>Suele deberse a ruido en el cable. Inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Trying gains</source>
        <translation>Probando ganancias</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: the trial has ended.</source>
        <translation>%1 vuelve a sus ganancias anteriores: la prueba ha terminado.</translation>
    </message>
    <message>
        <source>The motor began to oscillate. The previous gains are restored.</source>
        <translation>El motor empezó a oscilar. Se restauraron las ganancias anteriores.</translation>
    </message>
    <message>
        <source>Could not print the page.</source>
        <translation>No se pudo imprimir la página.</translation>
    </message>
    <message>
        <source>%1 Export the page as a PDF file and print that file.</source>
        <translation>%1 Exporte la página como archivo PDF e imprima ese archivo.</translation>
    </message>
    <message>
        <source>The page was sent to the printer.</source>
        <translation>La página se envió a la impresora.</translation>
    </message>
    <message>
        <source>The program %1, which sends pages to the printer, is not installed.</source>
        <translation>El programa %1, que envía páginas a la impresora, no está instalado.</translation>
    </message>
    <message>
        <source>The print system refused it: see Details.</source>
        <translation>El sistema de impresión la rechazó: consulte Detalles.</translation>
    </message>
    <message>
        <source>Could not read the step responses of this machine.</source>
        <translation>No se pudieron leer las respuestas al escalón de esta máquina.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of step responses.</source>
        <translation>“%1” no es un archivo de respuestas al escalón.</translation>
    </message>
    <message>
        <source>The file is kept: before new step responses are saved, it is moved to %1.</source>
        <translation>El archivo se conserva: antes de guardar nuevas respuestas al escalón, se traslada a %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not readable. It is moved aside before new step responses are saved.</source>
        <translation>“%1” no se puede leer. Se aparta antes de guardar nuevas respuestas al escalón.</translation>
    </message>
    <message>
        <source>The step responses of this session are not saved.</source>
        <translation>Las respuestas al escalón de esta sesión no se guardan.</translation>
    </message>
    <message>
        <source>%1 is not writable. Export them before you close the panel.</source>
        <translation>No se puede escribir en %1. Expórtelas antes de cerrar el panel.</translation>
    </message>
    <message>
        <source>The loop test of %1 ended early.</source>
        <translation>%1: su prueba de lazo terminó antes de tiempo.</translation>
    </message>
    <message>
        <source>The motor moved farther than the test allows, and was commanded to hold. Check for a load that pulls it, or use lower gains.</source>
        <translation>El motor se movió más de lo que permite la prueba, y se le ordenó mantener la posición. Compruebe si una carga tira de él o use ganancias menores.</translation>
    </message>
    <message>
        <source>A value of this test is out of range.</source>
        <translation>Un valor de esta prueba está fuera de rango.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>The module answers. It has inputs and outputs, but no motor.</source>
        <translation>El módulo responde. Tiene entradas y salidas, pero ningún motor.</translation>
    </message>
    <message>
        <source>This module drives no motor.</source>
        <translation>Este módulo no acciona ningún motor.</translation>
    </message>
    <message>
        <source>This module is not a PIC-I/O.</source>
        <translation>Este módulo no es un PIC-I/O.</translation>
    </message>
    <message>
        <source>A module ended the path by itself: a limit switch, a position error, or no motor power. All axes of the path were commanded to stop.</source>
        <translation>Un módulo terminó la trayectoria por sí solo: un final de carrera, un error de posición o falta de alimentación del motor. Se ordenó parar a todos los ejes de la trayectoria.</translation>
    </message>
    <message>
        <source>%1 has not finished its path.</source>
        <translation>%1 no ha terminado su trayectoria.</translation>
    </message>
    <message>
        <source>Not all axes started the path. All of them were commanded to stop.</source>
        <translation>No todos los ejes iniciaron la trayectoria. Se les ordenó parar.</translation>
    </message>
    <message>
        <source>The path points did not arrive in time, so the motor stopped at the last one.</source>
        <translation>Los puntos de la trayectoria no llegaron a tiempo, por lo que el motor se paró en el último que tenía.</translation>
    </message>
    <message>
        <source>The command position left the path. The motor was commanded to stop.</source>
        <translation>El motor no fue guiado por la trayectoria. Se le ordenó parar.</translation>
    </message>
    <message>
        <source>On a path</source>
        <translation>En una trayectoria</translation>
    </message>
    <message>
        <source>The path cannot be followed from here.</source>
        <translation>Desde aquí no se puede seguir la trayectoria.</translation>
    </message>
    <message>
        <source>Enable it, then move it the other way. The Amplifier page sets what a closed limit does.</source>
        <translation>Habilítelo y muévalo en el otro sentido. En la página Amplificador se configura qué hace un final de carrera cerrado.</translation>
    </message>
    <message>
        <source>Limit switch %1 closed, and module %2 switched its motor off.</source>
        <translation>Se cerró el final de carrera %1, y el módulo %2 apagó su motor.</translation>
    </message>
    <message>
        <source>The limit in that direction is closed. Move the motor the other way.</source>
        <translation>El final de carrera de ese sentido está cerrado. Mueva el motor en el otro sentido.</translation>
    </message>
    <message>
        <source>The rate &quot;%1&quot; does not exist. Use 30, 60 or 120.</source>
        <translation>La frecuencia “%1” no existe. Use 30, 60 o 120.</translation>
    </message>
    <message>
        <source>The file has no line that names its axes.</source>
        <translation>El archivo no tiene ninguna línea que nombre sus ejes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis that can follow a path.</source>
        <translation>“%1” no es un eje que pueda seguir una trayectoria.</translation>
    </message>
    <message>
        <source>This axis is named twice.</source>
        <translation>Este eje aparece dos veces.</translation>
    </message>
    <message>
        <source>A position is missing.</source>
        <translation>Falta una posición.</translation>
    </message>
    <message>
        <source>The line has %1 positions; the file has %2 axes.</source>
        <translation>La línea tiene %1 posiciones; el archivo tiene %2 ejes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>“%1” no es un número.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is outside the module&apos;s position range.</source>
        <translation>“%1” supera lo que el módulo puede contar.</translation>
    </message>
    <message>
        <source>The point is %1 from the previous one; at this rate the maximum is %2.</source>
        <translation>El punto está a %1 del anterior. A esta frecuencia se admiten como máximo %2.</translation>
    </message>
    <message>
        <source>This needs a velocity of %1; the limit of the axis is %2.</source>
        <translation>Esto requiere %1. El eje está limitado a %2.</translation>
    </message>
    <message>
        <source>%1 is beyond the travel limit of %2.</source>
        <translation>%1 está más allá del límite de recorrido de %2.</translation>
    </message>
    <message>
        <source>A path needs at least two points.</source>
        <translation>Una trayectoria necesita al menos dos puntos.</translation>
    </message>
    <message>
        <source>A path has at most %1 points.</source>
        <translation>Una trayectoria tiene como máximo %1 puntos.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>Línea %1, %2: %3</translation>
    </message>
    <message>
        <source>%1 has no path buffer. Only a PIC-SERVO CMC or SC can follow a path.</source>
        <translation>%1 no tiene búfer de trayectoria. Solo un PIC-SERVO CMC o SC sigue una trayectoria.</translation>
    </message>
    <message>
        <source>The I/O settings of %1 are unknown: another program set them. Apply them first on the Amplifier or Limits and I/O page.</source>
        <translation>Los ajustes de E/S de %1 son desconocidos: otro programa los ha cambiado. Aplíquelos primero en la página Amplificador o Finales y E/S.</translation>
    </message>
    <message>
        <source>%1 is set to step and direction input. Switch that off on its Amplifier page first.</source>
        <translation>%1 sigue pulsos de paso y dirección. Desactívelo primero en su página Amplificador.</translation>
    </message>
    <message>
        <source>%1: a path at 30 Hz needs fast path off (Amplifier or Limits and I/O page).</source>
        <translation>%1: una trayectoria a 30 Hz requiere “Trayectoria rápida” desactivada (página Amplificador o Finales y E/S).</translation>
    </message>
    <message>
        <source>%1: a path at 120 Hz needs fast path on (Amplifier or Limits and I/O page).</source>
        <translation>%1: una trayectoria a 120 Hz requiere “Trayectoria rápida” activada (página Amplificador o Finales y E/S).</translation>
    </message>
    <message>
        <source>%1: a path needs a servo rate divisor of 1. Apply the gains with SR = 1 first.</source>
        <translation>%1: una trayectoria requiere el ciclo de servo SR = 1. Aplique primero las ganancias con SR 1.</translation>
    </message>
    <message>
        <source>%1 has not reported its command position yet.</source>
        <translation>%1 aún no ha comunicado su posición de consigna.</translation>
    </message>
    <message>
        <source>%1 is %2 from the first point. Choose Move to start first.</source>
        <translation>%1 está a %2 del primer punto. Elija primero “Ir al inicio”.</translation>
    </message>
    <message>
        <source>%1: point %2 is %3 from the previous one; at this rate the maximum is %4.</source>
        <translation>%1: el punto %2 está a %3 del anterior. A esta frecuencia se admiten como máximo %4.</translation>
    </message>
    <message>
        <source>%1: point %2 needs a velocity of %3; the limit of the axis is %4.</source>
        <translation>%1: el punto %2 requiere %3. El eje está limitado a %4.</translation>
    </message>
    <message>
        <source>%1: point %2 at %3 is beyond the travel limit of %4.</source>
        <translation>%1: el punto %2, en %3, está más allá del límite de recorrido de %4.</translation>
    </message>
    <message>
        <source>The path does not fit this chain. Open it again.</source>
        <translation>La trayectoria no corresponde a esta cadena. Ábrala de nuevo.</translation>
    </message>
    <message>
        <source>The axes of a path start together. Put them, and no other module, into one group: Chain, Groups.</source>
        <translation>Los ejes de una trayectoria arrancan a la vez. Póngalos en un mismo grupo, sin ningún otro módulo: Cadena, Grupos.</translation>
    </message>
    <message>
        <source>The path needs %1 % of the bus time; %2 % is available. Use a higher baud rate or a lower path rate.</source>
        <translation>La trayectoria necesita el %1 % del tiempo del bus; está disponible el %2 %. Use una velocidad en baudios mayor o una frecuencia de trayectoria menor.</translation>
    </message>
    <message>
        <source>%1 cannot follow a path. Only a PIC-SERVO CMC or SC can.</source>
        <translation>%1 no puede seguir una trayectoria. Solo puede un PIC-SERVO CMC o SC.</translation>
    </message>
    <message>
        <source>%1 does not hold a known position. Enable its servo, and find home if the points count from home.</source>
        <translation>%1 no mantiene una posición conocida. Habilite su servo y busque la referencia si los puntos se cuentan desde ella.</translation>
    </message>
    <message>
        <source>Only moves, waits, repeats and calls can become a path.</source>
        <translation>Solo los movimientos, las esperas, las repeticiones y las llamadas pueden convertirse en una trayectoria.</translation>
    </message>
    <message>
        <source>A path cannot repeat forever.</source>
        <translation>Una trayectoria no puede repetirse sin fin.</translation>
    </message>
    <message>
        <source>Up to here the path would have more than %1 points.</source>
        <translation>Hasta aquí, la trayectoria tendría más de %1 puntos.</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; moves nothing.</source>
        <translation>La secuencia “%1” no mueve nada.</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;. %2</source>
        <translation>No se pudo abrir “%1”. %2</translation>
    </message>
    <message>
        <source>The path is done. Each axis holds its last point.</source>
        <translation>La trayectoria ha terminado. Cada eje mantiene su último punto.</translation>
    </message>
    <message>
        <source>The path was stopped.</source>
        <translation>Se paró la trayectoria.</translation>
    </message>
    <message>
        <source>Starting the path</source>
        <translation>Iniciando la trayectoria</translation>
    </message>
    <message>
        <source>Point %1 of %2, %3 s left, %4 points left in the buffer</source>
        <translation>Punto %1 de %2, quedan %3 s, %4 puntos por delante en el búfer</translation>
    </message>
    <message>
        <source>%1. The buffer is about to run dry: the bus is too slow.</source>
        <translation>%1. El búfer está a punto de vaciarse: el bus es demasiado lento.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 a %3</translation>
    </message>
    <message>
        <source>%1 points at %2 Hz, %3 s</source>
        <translation>%1 puntos a %2 Hz, %3 s</translation>
    </message>
    <message>
        <source>SM, step multiplier</source>
        <translation>SM, multiplicador de pasos</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>Trayectoria rápida</translation>
    </message>
    <message>
        <source>This pin of %1 is set as an output.</source>
        <translation>Este pin de %1 está configurado como salida.</translation>
    </message>
    <message>
        <source>This pin of %1 is not set as an output. Make it an output first.</source>
        <translation>Este pin de %1 no está configurado como salida. Configúrelo en la página E/S.</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not rise above %3 of 255 within %4 s.</source>
        <translation>A/D %1 de %2 no superó %3 de 255 en %4 s.</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not fall below %3 of 255 within %4 s.</source>
        <translation>A/D %1 de %2 no bajó de %3 de 255 en %4 s.</translation>
    </message>
    <message>
        <source>wait for A/D</source>
        <translation>esperar A/D</translation>
    </message>
    <message numerus="yes">
        <source>No stop command is known for modules %1</source>
        <translation>
            <numerusform>No se puede ordenar parar al módulo %1</numerusform>
            <numerusform>No se puede ordenar parar a los módulos %1</numerusform>
        </translation>
    </message>
    <message>
        <source>If it moved the wrong way, run the direction check on the Axis page.</source>
        <translation>Si se movió en sentido contrario, haga la prueba de sentido en la página Eje.</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or make the test smaller, then enable the motor.</source>
        <translation>El error de posición era demasiado grande o falló la alimentación del motor. Compruebe si hay un atasco, aumente EL o reduzca la prueba y después habilite el motor.</translation>
    </message>
    <message>
        <source>Check the link, then start the test again.</source>
        <translation>Compruebe el enlace y vuelva a iniciar la prueba.</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Start the test again.</source>
        <translation>Suele deberse a ruido en el cable. Vuelva a iniciar la prueba.</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its limit stop ended it.</source>
        <translation>%1 no completó su escalón: lo terminó su parada por límite.</translation>
    </message>
    <message>
        <source>Its limit stop ended the test.</source>
        <translation>Su parada por límite terminó la prueba.</translation>
    </message>
    <message>
        <source>The motor did not follow the sine wave, and was commanded to hold. Check for a jam, a hard stop, a slipping coupling or missing motor power, or use another amplitude.</source>
        <translation>El motor no siguió la onda senoidal, y se le ordenó mantener la posición. Compruebe si hay un atasco, un tope mecánico, un acoplamiento que patina o falta la alimentación del motor, o use otra amplitud.</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: its output reached the limit OL.</source>
        <translation>%1 vuelve a sus ganancias anteriores: la salida alcanzó el límite OL.</translation>
    </message>
    <message>
        <source>It oscillates, or was pushed. Lower Kp, or raise Kd, then try again.</source>
        <translation>Oscila o recibió un empujón. Baje Kp o suba Kd y vuelva a probar.</translation>
    </message>
    <message>
        <source>Looking for printers…</source>
        <translation>Buscando impresoras…</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Add one in the system&apos;s printer settings, or save the page as a PDF file.</source>
        <translation>No hay ninguna impresora configurada en este equipo. Añada una en los ajustes de impresoras del sistema o guarde la página como archivo PDF.</translation>
    </message>
    <message>
        <source>Printer: %1</source>
        <translation>Impresora: %1</translation>
    </message>
    <message>
        <source>The output reached its limit. The previous gains are restored.</source>
        <translation>La salida alcanzó su límite. Se han restablecido las ganancias anteriores.</translation>
    </message>
    <message>
        <source>The line at %1 was disturbed while the modules were given addresses.</source>
        <translation>La línea de %1 sufrió una perturbación mientras se asignaban direcciones a los módulos.</translation>
    </message>
    <message>
        <source>A module that had answered stopped answering, so the number of modules is unknown. No motor was moved. Check the cable and the adapter, then scan again.</source>
        <translation>Un módulo que había respondido dejó de hacerlo, así que no se sabe cuántos hay. No se movió ningún motor. Compruebe el cable y el adaptador y vuelva a buscar.</translation>
    </message>
    <message>
        <source>The adapter at %1 passes answers on in pieces, up to %2 ms apart.</source>
        <translation>El adaptador de %1 entrega las respuestas en trozos, separados hasta %2 ms.</translation>
    </message>
    <message>
        <source>USB hubs, Bluetooth and device servers do that. The panel waits for the rest, so updates are slower. No action needed.</source>
        <translation>Los concentradores USB, Bluetooth y los servidores de dispositivos hacen eso. El panel espera el resto, por lo que los valores llegan más despacio. No hay que hacer nada.</translation>
    </message>
    <message>
        <source>Motors were commanded to stop. Until answers have been correct for 2 s, only presence queries are sent; then the panel looks for the modules again. Try a lower baud rate, a shorter cable, or termination at both ends.</source>
        <translation>Se ordenó parar a los motores. Hasta que las respuestas sean correctas durante 2 s, solo se envían consultas de presencia; entonces el panel vuelve a buscar. Pruebe una velocidad en baudios menor, un cable más corto o terminación en ambos extremos.</translation>
    </message>
    <message>
        <source>%1 is %2; the module accepts %3 to %4.</source>
        <translation>%1 es %2; el módulo acepta de %3 a %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n stopped and holding</source>
        <translation>
            <numerusform>%n parado y sujeto</numerusform>
            <numerusform>%n parados y sujetos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n switched off</source>
        <translation>
            <numerusform>%n apagado</numerusform>
            <numerusform>%n apagados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n were off</source>
        <translation>
            <numerusform>%n estaba apagado</numerusform>
            <numerusform>%n estaban apagados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n I/O modules in their stop state</source>
        <translation>
            <numerusform>%n módulo de E/S como se fijó para una parada</numerusform>
            <numerusform>%n módulos de E/S como se fijó para una parada</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 ms.</source>
        <translation>%1, %2 ms.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to switch off: one answer reported a move in the wrong direction, to %2 counts.</source>
        <translation>Se ordenó al módulo %1 apagar el motor: según una respuesta, se movió en el sentido erróneo, hasta %2 cuentas.</translation>
    </message>
    <message>
        <source>If it did, encoder or motor wires are swapped, or the gains make it oscillate. If it did not, the answer was wrong: check the cable.</source>
        <translation>Si fue así, los cables del encoder o del motor están cruzados, o las ganancias lo hacen oscilar. Si la posición es correcta, la respuesta no era suya: compruebe el cable.</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: one answer reported that it went past its goal, to %2 counts.</source>
        <translation>Se ordenó parar al módulo %1: según una respuesta, sobrepasó su destino, hasta %2 cuentas.</translation>
    </message>
    <message>
        <source>Check the position before the next move. If it went there, the command was corrupted in transit, or the gains cause a large overshoot. If it did not, the answer was wrong: check the cable.</source>
        <translation>Compruebe la posición antes del próximo movimiento. Si llegó allí, el comando se dañó por el camino o las ganancias causan un gran sobreimpulso. Si no, la respuesta no era suya: compruebe el cable.</translation>
    </message>
    <message>
        <source>A question is waiting for your answer: %1</source>
        <translation>Una pregunta espera su respuesta: %1</translation>
    </message>
    <message>
        <source>Show the question</source>
        <translation>Mostrar la pregunta</translation>
    </message>
    <message>
        <source>Maybe off</source>
        <translation>Quizá apagado</translation>
    </message>
    <message>
        <source>Maybe moving</source>
        <translation>Quizá en movimiento</translation>
    </message>
    <message>
        <source>One answer says that the motor is off. The next answer will show whether it is.</source>
        <translation>Según una respuesta, el módulo apagó su motor. La siguiente lo dirá.</translation>
    </message>
    <message>
        <source>The last answers show the motor at rest, but it is not yet known whether it was started.</source>
        <translation>Según las últimas respuestas el motor está parado, pero aún no se sabe si se arrancó.</translation>
    </message>
    <message>
        <source>Looking for modules… Until they are found, only stop commands work.</source>
        <translation>Buscando módulos… Hasta encontrarlos, solo actúan las paradas.</translation>
    </message>
    <message>
        <source>The servo rate of this module is unknown, so speeds per second cannot be calculated. Apply its gains first: they include SR.</source>
        <translation>El ciclo de servo de este módulo se desconoce, y con él toda velocidad por segundo. Aplique primero sus ganancias: SR va con ellas.</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>dudosa</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>hace %1 s</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desactualizado</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has one column per signal, a format for other programs. The scope opens files with one row per reply.</source>
        <translation>“%1” tiene una columna por señal, una forma para otros programas. El osciloscopio abre archivos con una fila por respuesta.</translation>
    </message>
    <message>
        <source>The position counter of module %1 has wrapped.</source>
        <translation>La posición del módulo %1 se ha desbordado.</translation>
    </message>
    <message>
        <source>The 32-bit counter has overflowed and continues at the other end of its range. Earlier positions and travel limits no longer match: find home, then clear the sticky bits on the Details page.</source>
        <translation>Tiene 32 bits y continuó en el otro extremo de su rango. Las posiciones y los límites de recorrido anteriores ya no están donde estaban: busque la referencia y luego borre los bits enclavados en la página Detalles.</translation>
    </message>
    <message>
        <source>Limit switch 1 is active: the motor can only move away from it.</source>
        <translation>El final de carrera 1 está activo: el motor solo puede alejarse de él.</translation>
    </message>
    <message>
        <source>Limit switch 2 is active: the motor can only move away from it.</source>
        <translation>El final de carrera 2 está activo: el motor solo puede alejarse de él.</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programa</translation>
    </message>
    <message>
        <source>%1 is not a line behind a network.</source>
        <translation>%1 no es una línea accesible por la red.</translation>
    </message>
    <message>
        <source>Write tcp://HOST:PORT, or rfc2217://HOST:PORT if the device server lets the rate be set.</source>
        <translation>Escriba tcp://HOST:PORT, o rfc2217://HOST:PORT si el servidor de dispositivos permite ajustar la velocidad.</translation>
    </message>
    <message>
        <source>The computer or device server in %1 was not found.</source>
        <translation>No se encontró el equipo o el servidor de dispositivos de %1.</translation>
    </message>
    <message>
        <source>Check its name, and the network.</source>
        <translation>Compruebe su nombre y la red.</translation>
    </message>
    <message>
        <source>Nothing accepts connections at %1.</source>
        <translation>Nada acepta conexiones en %1.</translation>
    </message>
    <message>
        <source>Check that the device server is on, that its TCP port is this one, and that no other program has it.</source>
        <translation>Compruebe que el servidor de dispositivos está encendido, que su puerto TCP es este y que ningún otro programa lo ocupa.</translation>
    </message>
    <message>
        <source>%1 does not let the serial port be controlled.</source>
        <translation>%1 no permite controlar el puerto serie.</translation>
    </message>
    <message>
        <source>Enable RFC 2217 in the device server, or set it to 19 200 Bd, 8N1, and connect with tcp:// instead.</source>
        <translation>Active RFC 2217 en el servidor de dispositivos, o ajústelo a 19 200 Bd, 8N1, y conéctese con tcp://.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost. %2</source>
        <translation>Se ha perdido la conexión con %1. %2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then check the network and the device server.</source>
        <translation>Use la parada por hardware si es necesario y luego compruebe la red y el servidor de dispositivos.</translation>
    </message>
    <message>
        <source>The line is lent to a program.</source>
        <translation>La línea está prestada a un programa.</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, lent to a program</source>
        <translation>Conectado a %1 a %2 Bd, %3, prestado a un programa</translation>
    </message>
    <message>
        <source>Settings copied from %1: %2.</source>
        <translation>Ajustes copiados de %1: %2.</translation>
    </message>
    <message>
        <source>The move and the record after it would take more than 6 s. Shorten the move or the record, or move faster.</source>
        <translation>El movimiento y el registro posterior durarían más de 6 s. Acorte el movimiento o el registro, o muévase más rápido.</translation>
    </message>
    <message>
        <source>The motor swung so far that it reversed, and was commanded to hold. Raise the speed, or lower the amplitude.</source>
        <translation>El motor osciló tanto que invirtió el sentido, y se le ordenó mantener la posición. Aumente la velocidad o reduzca la amplitud.</translation>
    </message>
    <message>
        <source>At this speed the motor would reverse. Raise the speed, or lower the amplitude or the highest frequency.</source>
        <translation>A esta velocidad, el motor invertiría el sentido. Aumente la velocidad, o reduzca la amplitud o la frecuencia más alta.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, from home</source>
        <translation>«%1», desde la referencia</translation>
    </message>
    <message>
        <source>%1 did not stay within its arrival tolerance. Check its gains, or change the tolerance (Axis page).</source>
        <translation>%1 no permaneció dentro de su tolerancia de llegada. Compruebe sus ganancias o cambie la tolerancia (página Eje).</translation>
    </message>
    <message>
        <source>The motor would come too close to the position error limit, which switches the servo off. Make the step, the amplitude or the speed smaller, or raise EL.</source>
        <translation>El motor se acercaría demasiado al límite de error de posición, que apaga el servo. Reduzca el escalón, la amplitud o la velocidad, o aumente EL.</translation>
    </message>
    <message>
        <source>%1 did not finish its approaches.</source>
        <translation>%1 no ha terminado sus aproximaciones.</translation>
    </message>
    <message>
        <source>Reading the captured position</source>
        <translation>Leyendo la posición capturada</translation>
    </message>
    <message>
        <source>The switch changed again while the motor stopped beyond it: it bounces, or its cam is too short. The motor is at rest. Move more slowly, or raise the acceleration.</source>
        <translation>El interruptor cambió otra vez mientras el motor se detenía más allá: rebota, o su leva es demasiado corta. El motor está parado. Vaya más despacio o aumente la aceleración.</translation>
    </message>
    <message>
        <source>The switch or index did not change within the search distance and the time limit. It may be stuck, closed on both sides, or in the other direction; above 1 count per tick, an index can be missed. The motor was stopped.</source>
        <translation>El interruptor o el índice no cambió dentro de la distancia de búsqueda y el tiempo límite. Puede estar atascado, cerrado en ambos lados o en el otro sentido; por encima de 1 cuenta por período puede perderse un índice. Se paró el motor.</translation>
    </message>
    <message>
        <source>The switch or index did not change within the travel limits. The motor was stopped.</source>
        <translation>El interruptor o el índice no cambió dentro de los límites de recorrido. Se paró el motor.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion before the switch changed. The motor is at rest.</source>
        <translation>Un final de carrera o la entrada de paro de emergencia terminó el movimiento antes de que cambiara el interruptor. El motor está parado.</translation>
    </message>
    <message>
        <source>Choose one switch or the index, and nothing else.</source>
        <translation>Elija un solo interruptor o el índice, y nada más.</translation>
    </message>
    <message>
        <source>Approach it 2 to 100 times from each side.</source>
        <translation>Elija de 2 a 100 aproximaciones desde cada lado.</translation>
    </message>
    <message>
        <source>An earlier stop was not confirmed, so it was sent now.</source>
        <translation>Una parada anterior no se confirmó, así que se envió ahora.</translation>
    </message>
    <message>
        <source>No stop can be sent now: use the hardware stop.</source>
        <translation>Ahora no se puede enviar ninguna parada: use la parada por hardware.</translation>
    </message>
    <message>
        <source>It is sent as soon as you connect to the same modules again.</source>
        <translation>Se enviará en cuanto vuelva a conectar con los mismos módulos.</translation>
    </message>
    <message>
        <source>Not connected: the state of the chain is unknown.</source>
        <translation>Sin conexión: se desconoce el estado de la cadena.</translation>
    </message>
    <message>
        <source>Chain OK: %1.</source>
        <translation>Cadena correcta: %1.</translation>
    </message>
    <message>
        <source>No module answered.</source>
        <translation>No respondió ningún módulo.</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered; the far end of the chain is missing.</source>
        <translation>Respondieron %1 de %2 módulos; falta el extremo lejano de la cadena.</translation>
    </message>
    <message>
        <source>%1 is not the expected module.</source>
        <translation>%1 no es el módulo esperado.</translation>
    </message>
    <message>
        <source>More modules than expected: %1 instead of %2.</source>
        <translation>Hay más módulos de los esperados: %1 en lugar de %2.</translation>
    </message>
    <message>
        <source>%1 stopped answering. Motor state unknown.</source>
        <translation>%1 dejó de responder. Estado del motor desconocido.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and gains are lost.</source>
        <translation>%1 se reinició: ha perdido su posición y sus ganancias.</translation>
    </message>
    <message>
        <source>%1 restarted: its pins are inputs again, and its outputs release what they drove.</source>
        <translation>%1 se reinició: sus pines vuelven a ser entradas y sus salidas dejan libre lo que gobernaban.</translation>
    </message>
    <message>
        <source>%1 restarted: its position and parameters are lost.</source>
        <translation>%1 se reinició: ha perdido su posición y sus parámetros.</translation>
    </message>
    <message>
        <source>Choose a port and connect.</source>
        <translation>Elija un puerto y conecte.</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC.</source>
        <translation>Compruebe, en este orden: la alimentación de los módulos; todos los cables de la cadena, pues uno solo suelto oculta todos los módulos; el puente ADDR_IN del módulo más alejado del PC.</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.</source>
        <translation>La numeración empieza en el extremo lejano; por eso, revise el módulo que sigue a %1 hacia el PC: primero su alimentación y después el conector entre ambos. Luego vuelva a buscar.</translation>
    </message>
    <message>
        <source>Only the modules nearest the PC answered, and their numbers have changed. Check the cable to the module at the far end, and check that no other ADDR_IN is grounded. Until this is fixed, settings do not match the modules.</source>
        <translation>Solo respondieron los módulos más cercanos al PC, y sus números han cambiado. Compruebe el cable del módulo del extremo lejano y que ningún otro ADDR_IN esté conectado a masa. Hasta que se corrija, los ajustes no corresponden a los módulos.</translation>
    </message>
    <message>
        <source>Name, unit, limits, speeds and points of the expected module are used for it; gains and parameters from a machine file are not sent to it. If you replaced the module on purpose, check these settings, then accept the chain as found.</source>
        <translation>Se usan para él el nombre, la unidad, los límites, las velocidades y los puntos del módulo esperado; las ganancias y los parámetros de un archivo de máquina no se le envían. Si sustituyó el módulo a propósito, compruebe estos ajustes y luego acepte la cadena tal como se encontró.</translation>
    </message>
    <message>
        <source>The settings of this place are for another type of module, so they are not used, and only stop commands work. Check the cables, then scan again. If you replaced the module on purpose, accept the chain as found (Chain doctor): all but its name is then to be set again, and its positions leave the points.</source>
        <translation>Los ajustes de este lugar son de otro tipo de módulo, así que no se usan y solo actúan las paradas. Compruebe los cables y vuelva a buscar. Si sustituyó el módulo a propósito, acepte la cadena tal como se encontró (Diagnóstico de la cadena): entonces hay que ajustar de nuevo todo menos su nombre, y sus posiciones se quitan de los puntos.</translation>
    </message>
    <message>
        <source>Modules from %1 on are new. If they belong there, accept the chain as found.</source>
        <translation>Los módulos son nuevos a partir de %1. Si deben estar ahí, acepte la cadena tal como se encontró.</translation>
    </message>
    <message>
        <source>Check its power and cable; use the hardware stop if its motor moves. The panel retries from time to time.</source>
        <translation>Compruebe su alimentación y su cable; use la parada por hardware si el motor se mueve. El panel lo reintenta de vez en cuando.</translation>
    </message>
    <message>
        <source>Modules between it and the PC may not answer until it has its address again. Restart the network when it is safe to stop all motors and lose their positions.</source>
        <translation>Los módulos situados entre él y el PC pueden no responder hasta que recupere su dirección. Reinicie la red cuando todos los motores puedan pararse y perder su posición.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>correcto</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nuevo</translation>
    </message>
    <message>
        <source>different module</source>
        <translation>módulo distinto</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>no responde</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>sin consultar</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>reiniciado</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>sin grupo</translation>
    </message>
    <message>
        <source>This chain is new: it has %1.</source>
        <translation>Esta cadena es nueva: tiene %1.</translation>
    </message>
    <message>
        <source>Compare the list with the labels on the modules, starting with the module farthest from the PC. If it is right, accept the chain as found: from then on, missing and replaced modules are reported.</source>
        <translation>Compare la lista con las etiquetas de los módulos, empezando por el más alejado del PC. Si es correcta, acepte la cadena tal como se encontró: a partir de entonces se avisará de los módulos que falten o se sustituyan.</translation>
    </message>
    <message>
        <source>Looking for modules…</source>
        <translation>Buscando módulos…</translation>
    </message>
    <message>
        <source>Home: %1</source>
        <translation>Referencia: %1</translation>
    </message>
    <message>
        <source>Home: unknown</source>
        <translation>Referencia: desconocida</translation>
    </message>
    <message>
        <source>Home is unknown. Search for home, or move there and choose Save as home. A restart of the module loses home again.</source>
        <translation>La referencia se desconoce. Búsquela, o lleve el motor hasta ella y elija “Guardar como referencia”. Al reiniciarse el módulo, se vuelve a perder.</translation>
    </message>
    <message>
        <source>Home is at %1. A search found it %2 min ago.</source>
        <translation>La referencia está en %1. Una búsqueda la encontró hace %2 min.</translation>
    </message>
    <message>
        <source>Home is at %1. It was saved %2 min ago.</source>
        <translation>La referencia está en %1. Se guardó hace %2 min.</translation>
    </message>
    <message>
        <source>Makes the present position 0. The motor does not move. The old zero is lost: from then on all positions count from here.</source>
        <translation>Convierte la posición actual en 0. El motor no se mueve. El cero anterior se pierde: desde entonces todas las posiciones se cuentan desde aquí.</translation>
    </message>
    <message>
        <source>This moves home from %1 to %2.</source>
        <translation>Esto traslada la referencia de %1 a %2.</translation>
    </message>
    <message>
        <source>The position that the chip captured or saved last. A limit stop changes it, too; Zero here does not. Go home does not use it.</source>
        <translation>La última posición que el chip capturó o guardó. Una parada por límite también la cambia; “Cero aquí” no. “Ir a referencia” no la utiliza.</translation>
    </message>
    <message>
        <source>Home: %1, not verified</source>
        <translation>Referencia: %1, sin verificar</translation>
    </message>
    <message>
        <source>Home is at %1, not verified: restored %2 min ago from the last known position. Search for home to verify it.</source>
        <translation>La referencia está en %1, sin verificar: se restauró hace %2 min a partir de la última posición conocida. Busque la referencia para verificarla.</translation>
    </message>
    <message>
        <source>Home is at %1. You confirmed the position %2 min ago.</source>
        <translation>La referencia está en %1. Usted confirmó la posición hace %2 min.</translation>
    </message>
    <message>
        <source>That is %1; this module can be given at most %2.</source>
        <translation>Eso es %1; este módulo admite como máximo %2.</translation>
    </message>
    <message>
        <source>That is %1; the highest velocity of this axis is %2 (Axis page).</source>
        <translation>Eso es %1; la velocidad máxima de este eje es %2 (página Eje).</translation>
    </message>
    <message>
        <source>Lowest position reached: %1. Move forward.</source>
        <translation>Posición mínima alcanzada: %1. Vaya hacia adelante.</translation>
    </message>
    <message>
        <source>Highest position reached: %1. Move in reverse.</source>
        <translation>Posición máxima alcanzada: %1. Vaya hacia atrás.</translation>
    </message>
    <message>
        <source>No travel limits are set.</source>
        <translation>No hay límites de recorrido definidos.</translation>
    </message>
    <message>
        <source>Not in force: home is unknown. Search for it, save it, or confirm the position.</source>
        <translation>Sin efecto: la referencia se desconoce. Búsquela, guárdela o confirme la posición.</translation>
    </message>
    <message>
        <source>In force: not below %1.</source>
        <translation>En vigor: no por debajo de %1.</translation>
    </message>
    <message>
        <source>In force: not above %1.</source>
        <translation>En vigor: no por encima de %1.</translation>
    </message>
    <message>
        <source>In force: from %1 to %2.</source>
        <translation>En vigor: de %1 a %2.</translation>
    </message>
    <message>
        <source>Travel limits not in force</source>
        <translation>Límites de recorrido sin efecto</translation>
    </message>
    <message>
        <source>At the lowest position</source>
        <translation>En la posición mínima</translation>
    </message>
    <message>
        <source>At the highest position</source>
        <translation>En la posición máxima</translation>
    </message>
    <message>
        <source>Below the lowest position</source>
        <translation>Por debajo de la posición mínima</translation>
    </message>
    <message>
        <source>Above the highest position</source>
        <translation>Por encima de la posición máxima</translation>
    </message>
    <message>
        <source>Look at the axis first: is %1 really at %2? If so, home is at position 0, and the travel limits apply from there. If not, they protect the wrong range.</source>
        <translation>Observe primero el eje: ¿está %1 realmente en %2? Si es así, la referencia está en la posición 0 y los límites de recorrido se cuentan desde ahí. Si no, protegen una zona errónea.</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, below the lowest position %2. Lower that position, or change the backlash or its direction (Axis page).</source>
        <translation>Para absorber la holgura, el movimiento daría la vuelta en %1, por debajo de la posición mínima %2. Baje esa posición, o cambie la holgura o su sentido (página Eje).</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, above the highest position %2. Raise that position, or change the backlash or its direction (Axis page).</source>
        <translation>Para absorber la holgura, el movimiento daría la vuelta en %1, por encima de la posición máxima %2. Suba esa posición, o cambie la holgura o su sentido (página Eje).</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the lowest position is %1 (Axis page).</source>
        <translation>Está fuera de los límites de recorrido: la posición mínima es %1 (página Eje).</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the highest position is %1 (Axis page).</source>
        <translation>Está fuera de los límites de recorrido: la posición máxima es %1 (página Eje).</translation>
    </message>
    <message>
        <source>The highest velocity is set on the Axis page.</source>
        <translation>La velocidad máxima se ajusta en la página Eje.</translation>
    </message>
    <message>
        <source>The max jog speed and the highest velocity are set on the Axis page.</source>
        <translation>La velocidad de jog máx. y la velocidad máxima se ajustan en la página Eje.</translation>
    </message>
    <message>
        <source>from &quot;%1&quot;</source>
        <translation>desde «%1»</translation>
    </message>
    <message>
        <source>%1 by the counter</source>
        <translation>%1 según el contador</translation>
    </message>
    <message>
        <source>Positions count from &quot;%1&quot;.</source>
        <translation>Las posiciones se cuentan desde «%1».</translation>
    </message>
    <message>
        <source>It is not known any more where &quot;%1&quot; is. Choose the work offset again, or clear it (Axis page).</source>
        <translation>Ya no se sabe dónde está «%1». Elija de nuevo el desplazamiento de trabajo o bórrelo (página Eje).</translation>
    </message>
    <message>
        <source>steps/s²</source>
        <translation>pasos/s²</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>cuentas/s</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>cuentas/s²</translation>
    </message>
    <message>
        <source>%1 (%2 of 255)</source>
        <translation>%1 (%2 de 255)</translation>
    </message>
    <message>
        <source>Oscillating ± %1 at about %2 Hz</source>
        <translation>Oscila ± %1 a unos %2 Hz</translation>
    </message>
    <message>
        <source>Oscillating ± %1</source>
        <translation>Oscila ± %1</translation>
    </message>
    <message>
        <source>Hunting ± %1 every %2 s. Lower Ki.</source>
        <translation>Oscila lentamente ± %1 cada %2 s. Reduzca Ki.</translation>
    </message>
    <message>
        <source>%1, hunting</source>
        <translation>%1, oscila lentamente</translation>
    </message>
    <message>
        <source>%1, oscillating</source>
        <translation>%1, oscila</translation>
    </message>
    <message>
        <source>%1, pushing at OL</source>
        <translation>%1, empuja con OL</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1, desviado %2</translation>
    </message>
    <message>
        <source>Kp is 0: the servo brakes the motor but holds no position.</source>
        <translation>Kp es 0: el servo frena el motor pero no mantiene ninguna posición.</translation>
    </message>
    <message>
        <source>%1 off the position to hold, and pushing with up to the full output limit. Something may be in the way.</source>
        <translation>A %1 de la posición que debe mantener, y empuja hasta con todo el límite de salida. Puede que algo estorbe.</translation>
    </message>
    <message>
        <source>%1 off the position to hold: friction, a load or an obstacle is stronger. A higher Kp, or an integral (Ki, IL), pushes more.</source>
        <translation>A %1 de la posición que debe mantener: la fricción, una carga o un obstáculo es más fuerte. Un Kp mayor, o una integral (Ki, IL), empuja más.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; is missing.</source>
        <translation>Falta el parámetro «%1».</translation>
    </message>
    <message>
        <source>These parameters are missing: %1.</source>
        <translation>Faltan estos parámetros: %1.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; has the wrong type, or is out of its range.</source>
        <translation>El parámetro «%1» es de otro tipo o está fuera de su rango.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here.</source>
        <translation>El parámetro «%1» debe estar aquí entre %2 y %3.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here, in either direction. %3 is the max jog speed of the axis.</source>
        <translation>El parámetro «%1» debe estar aquí entre %2 y %3, en ambos sentidos. %3 es la velocidad de jog máxima del eje.</translation>
    </message>
    <message>
        <source>There is no such axis.</source>
        <translation>Ese eje no existe.</translation>
    </message>
    <message>
        <source>There is no sequence or point of that name.</source>
        <translation>No hay ninguna secuencia ni punto con ese nombre.</translation>
    </message>
    <message>
        <source>This program may not move motors now: call request_control first.</source>
        <translation>Este programa no puede mover motores ahora: llame antes a request_control.</translation>
    </message>
    <message>
        <source>Call hello first.</source>
        <translation>Llame antes a hello.</translation>
    </message>
    <message>
        <source>This panel speaks version %1 of the protocol, and the program version %2.</source>
        <translation>Este panel habla la versión %1 del protocolo, y el programa la versión %2.</translation>
    </message>
    <message>
        <source>It was cancelled by a stop or by another command.</source>
        <translation>Lo ha cancelado una parada u otro comando.</translation>
    </message>
    <message>
        <source>Motors were stopped.</source>
        <translation>Se han parado motores.</translation>
    </message>
    <message>
        <source>The user has taken control back.</source>
        <translation>El usuario ha recuperado el control.</translation>
    </message>
    <message>
        <source>The user has commanded a motor.</source>
        <translation>El usuario ha dado una orden a un motor.</translation>
    </message>
    <message>
        <source>The chain is no longer connected.</source>
        <translation>La cadena ya no está conectada.</translation>
    </message>
    <message>
        <source>Other programs cannot connect.</source>
        <translation>Otros programas no pueden conectarse.</translation>
    </message>
    <message>
        <source>Another panel already lets programs in at %1.</source>
        <translation>Otro panel ya deja entrar programas por %1.</translation>
    </message>
    <message>
        <source>%1 is a link, belongs to another user, or is open to others. Remove it, and try again.</source>
        <translation>%1 es un enlace, pertenece a otro usuario o está abierto a otros. Elimínelo e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>%1 cannot be created.</source>
        <translation>No se puede crear %1.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has connected. It may read, stop motors and switch them off, but not move them.</source>
        <translation>El programa «%1» se ha conectado. Puede leer, detener motores y apagarlos, pero no moverlos.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected; the motors that it moved are stopped.</source>
        <translation>El programa «%1» se ha desconectado; se paran los motores que movió.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected.</source>
        <translation>El programa «%1» se ha desconectado.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot;: %2</source>
        <translation>Programa «%1»: %2</translation>
    </message>
    <message>
        <source>This line is not JSON.</source>
        <translation>Esta línea no es JSON.</translation>
    </message>
    <message>
        <source>A request is an object with method, params (an object) and id.</source>
        <translation>Una petición es un objeto con method, params (un objeto) e id.</translation>
    </message>
    <message>
        <source>There is no such method.</source>
        <translation>No existe ese método.</translation>
    </message>
    <message>
        <source>The line is lent at %1. No program has used it yet.</source>
        <translation>La línea está prestada en %1. Ningún programa la ha usado todavía.</translation>
    </message>
    <message>
        <source>A program has the line, at %1.</source>
        <translation>Un programa tiene la línea, en %1.</translation>
    </message>
    <message>
        <source>All motors were commanded to stop, and the program is held off.</source>
        <translation>Se ordenó parar a todos los motores, y el programa queda retenido.</translation>
    </message>
    <message>
        <source>What it sends is dropped. Release lets it continue; it does not know what it has missed.</source>
        <translation>Lo que envía se descarta. Dejar continuar le devuelve la línea; no sabe lo que se ha perdido.</translation>
    </message>
    <message>
        <source>The program has closed %1, and the line is no longer lent.</source>
        <translation>El programa ha cerrado %1, y la línea ya no está prestada.</translation>
    </message>
    <message>
        <source>The line is no longer lent.</source>
        <translation>La línea ya no está prestada.</translation>
    </message>
    <message>
        <source>The line was not lent.</source>
        <translation>La línea no se ha prestado.</translation>
    </message>
    <message>
        <source>The chain was busy, or a motor was moving. Stop the motors, and try again.</source>
        <translation>La cadena estaba ocupada, o un motor se movía. Pare los motores e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>There is something at %1 already. Choose another path.</source>
        <translation>Ya hay algo en %1. Elija otra ruta.</translation>
    </message>
    <message>
        <source>No terminal can be made at %1. Choose a path in a folder of your own.</source>
        <translation>No se puede crear un terminal en %1. Elija una ruta en una carpeta propia.</translation>
    </message>
    <message>
        <source>LENT at %1 — stopped; the program is held off.</source>
        <translation>PRESTADA en %1 — parado; el programa queda retenido.</translation>
    </message>
    <message>
        <source>LENT at %1 — a program has the line. No travel limit or other check of the panel protects the motors; STOP ALL does.</source>
        <translation>PRESTADA en %1 — un programa tiene la línea. Ningún límite de recorrido ni otra comprobación del panel protege los motores; PARAR TODO actúa.</translation>
    </message>
    <message>
        <source>LENT at %1 — no program yet.</source>
        <translation>PRESTADA en %1 — todavía ningún programa.</translation>
    </message>
    <message>
        <source>The motor did not stay within the arrival tolerance of its axis.</source>
        <translation>El motor no permaneció dentro de la tolerancia de llegada de su eje.</translation>
    </message>
    <message>
        <source>This pin is not set as an output. Make it an output first.</source>
        <translation>Este pin no está configurado como salida. Configúrelo primero como salida.</translation>
    </message>
    <message>
        <source>The outputs of this module, or their directions, are unknown. Set them once first.</source>
        <translation>Las salidas de este módulo, o sus direcciones, son desconocidas. Establézcalas primero una vez.</translation>
    </message>
    <message>
        <source>Several axes have this name. Use the number of the axis, or give each its own name.</source>
        <translation>Varios ejes tienen este nombre. Use el número del eje o dé a cada uno su propio nombre.</translation>
    </message>
</context>
<context>
    <name>nmc::AmplifierBox</name>
    <message>
        <source>3-phase commutation</source>
        <translation>Conmutación trifásica</translation>
    </message>
    <message>
        <source>For a brushless motor with Hall sensors and a 3-phase amplifier. Off: a brush motor.</source>
        <translation>Para un motor sin escobillas con sensores Hall y un amplificador trifásico. Inactivo: un motor con escobillas.</translation>
    </message>
    <message>
        <source>Antiphase PWM</source>
        <translation>PWM en contrafase</translation>
    </message>
    <message>
        <source>For a locked-antiphase amplifier: 50 % PWM is zero output. Off: PWM and direction.</source>
        <translation>Para un amplificador en el que un 50 % de PWM significa reposo. Inactivo: PWM y dirección.</translation>
    </message>
    <message>
        <source>Step and direction input</source>
        <translation>Entrada de paso y dirección</translation>
    </message>
    <message>
        <source>The motor follows step pulses at the limit pins instead of commands. The limit inputs then give no protection.</source>
        <translation>El motor sigue los pulsos de paso de los pines de final de carrera en lugar de los comandos. Los finales de carrera no protegen entonces nada.</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz.</source>
        <translation>Puntos de trayectoria a 60 y 120 Hz en lugar de 30 y 60 Hz.</translation>
    </message>
    <message>
        <source>Apply…</source>
        <translation>Aplicar…</translation>
    </message>
    <message>
        <source>Apply the amplifier settings</source>
        <translation>Aplicar los ajustes del amplificador</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Set the step multiplier</source>
        <translation>Fijar el multiplicador de pasos</translation>
    </message>
    <message>
        <source>Keep its address and group</source>
        <translation>Conservar su dirección y grupo</translation>
    </message>
    <message>
        <source>It comes back at this address after a power cycle, without a search.</source>
        <translation>Vuelve con esta dirección tras apagarlo y encenderlo, sin una búsqueda.</translation>
    </message>
    <message>
        <source>Amplifier on at power-up</source>
        <translation>Amplificador encendido al arrancar</translation>
    </message>
    <message>
        <source>AMP_EN goes high by itself after each power-up.</source>
        <translation>AMP_EN pasa por sí solo a nivel alto en cada encendido.</translation>
    </message>
    <message>
        <source>Servo on at power-up</source>
        <translation>Servo encendido al arrancar</translation>
    </message>
    <message>
        <source>The servo switches on by itself after each power-up, with the saved gains, even with no panel connected.</source>
        <translation>El motor mantiene la posición por sí solo tras cada encendido, con las ganancias guardadas, antes de que haya un panel conectado.</translation>
    </message>
    <message>
        <source>Save in module…</source>
        <translation>Guardar en el módulo…</translation>
    </message>
    <message>
        <source>Save in module: configuration for power-up</source>
        <translation>Guardar en el módulo la configuración de arranque</translation>
    </message>
    <message>
        <source>Erase saved…</source>
        <translation>Borrar lo guardado…</translation>
    </message>
    <message>
        <source>Erase saved configuration of the module</source>
        <translation>Borrar lo guardado: la configuración del módulo</translation>
    </message>
    <message>
        <source>Limit inputs</source>
        <translation>Finales de carrera</translation>
    </message>
    <message>
        <source>do nothing</source>
        <translation>no hacen nada</translation>
    </message>
    <message>
        <source>stop abruptly</source>
        <translation>detienen bruscamente</translation>
    </message>
    <message>
        <source>switch the motor off</source>
        <translation>apagan el motor</translation>
    </message>
    <message>
        <source>Amplifier settings of the module</source>
        <translation>Ajustes del amplificador del módulo</translation>
    </message>
    <message>
        <source>Step multiplier</source>
        <translation>Multiplicador de pasos</translation>
    </message>
    <message>
        <source>Counts that one step pulse moves the motor.</source>
        <translation>Cuentas que cada pulso de paso mueve el motor.</translation>
    </message>
    <message>
        <source>Saved in the module, for power-up</source>
        <translation>Guardado en el módulo, para el arranque</translation>
    </message>
    <message>
        <source>Saves these choices, the settings above, the gains, the velocity and the acceleration as the module has them now. They come back at each power-up. 3-phase and antiphase come back after a reset, too. Both buttons restart the module: its motor switches off, and it needs its gains again.</source>
        <translation>Guarda estas opciones, los ajustes de arriba, las ganancias, la velocidad y la aceleración tal como los tiene ahora el módulo. Se recuperan en cada encendido. Los modos trifásico y en contrafase se recuperan también tras un reinicio. Ambos botones reinician el módulo: su motor se apaga y necesita de nuevo sus ganancias.</translation>
    </message>
    <message>
        <source>? Unknown: nothing has been applied in this connection, and the settings cannot be read back. The module may have saved settings.</source>
        <translation>? Desconocido: no se aplicó nada en esta conexión, y el módulo no lo indica. Puede tener ajustes guardados.</translation>
    </message>
    <message>
        <source>✓ Applied: 3-phase %1, antiphase %2, step and direction %3, limits %4.</source>
        <translation>✓ Aplicado: trifásico %1, contrafase %2, paso y dirección %3, finales de carrera: %4.</translation>
    </message>
    <message>
        <source>Step and direction uses the limit pins: set the limit inputs to do nothing.</source>
        <translation>Con paso y dirección, los pines de final de carrera son sus entradas: ponga los finales de carrera en “no hacen nada”.</translation>
    </message>
    <message>
        <source>The module already has these settings.</source>
        <translation>El módulo tiene estos ajustes.</translation>
    </message>
    <message>
        <source>Takes AMP_EN low and sends these settings.</source>
        <translation>Pone AMP_EN a nivel bajo y envía estos ajustes.</translation>
    </message>
    <message>
        <source>Sends the module&apos;s present gains with this multiplier.</source>
        <translation>Envía las ganancias que tiene el módulo, con este multiplicador.</translation>
    </message>
    <message>
        <source>Apply the amplifier settings first: the module&apos;s present settings are unknown.</source>
        <translation>Aplique primero los ajustes del amplificador: se desconoce lo que tiene ahora el módulo.</translation>
    </message>
    <message>
        <source>Saves the module&apos;s present settings and restarts it.</source>
        <translation>Guarda lo que tiene ahora el módulo y lo reinicia.</translation>
    </message>
    <message>
        <source>Erases the module&apos;s saved configuration and restarts it.</source>
        <translation>Hace que el módulo olvide lo que guardó y lo reinicia.</translation>
    </message>
    <message>
        <source>Apply amplifier settings</source>
        <translation>Aplicar ajustes del amplificador</translation>
    </message>
    <message>
        <source>Apply these settings to %1? If 3-phase, antiphase or step and direction do not match the amplifier and its wiring, the amplifier can be destroyed, or the motor can run away once it is enabled.</source>
        <translation>¿Aplicar estos ajustes a %1? Unos modos trifásico, en contrafase o de paso y dirección que no correspondan al amplificador o a su cableado pueden destruir el amplificador, o hacer que el motor se embale en cuanto se habilite.</translation>
    </message>
    <message>
        <source>Apply settings</source>
        <translation>Aplicar ajustes</translation>
    </message>
    <message>
        <source>Save the configuration of %1? It takes effect at each power-up, whatever is connected then. The module restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>¿Guardar la configuración de %1? Se recupera en cada encendido, esté conectado lo que esté entonces. El módulo se reinicia ahora: su motor se apaga y necesita de nuevo sus ganancias.</translation>
    </message>
    <message>
        <source>Its motor will be driven right after power-up, without a command.</source>
        <translation>Su motor se accionará justo después del encendido, sin ningún comando.</translation>
    </message>
    <message>
        <source>Save in module</source>
        <translation>Guardar en el módulo</translation>
    </message>
    <message>
        <source>Save and restart</source>
        <translation>Guardar y reiniciar</translation>
    </message>
    <message>
        <source>Erase saved configuration</source>
        <translation>Borrar configuración guardada</translation>
    </message>
    <message>
        <source>Erase the saved configuration of %1? From the next power-up it starts with its default settings. It restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>¿Borrar lo que %1 ha guardado? En el próximo encendido arranca como un módulo nuevo. Se reinicia ahora: su motor se apaga y necesita de nuevo sus ganancias.</translation>
    </message>
    <message>
        <source>Erase and restart</source>
        <translation>Borrar y reiniciar</translation>
    </message>
    <message>
        <source>What the module does by itself when limit 1 closes while it counts up, or limit 2 while it counts down. It stays armed.</source>
        <translation>Lo que hace el módulo por sí solo cuando se cierra el final 1 mientras cuenta hacia arriba, o el final 2 mientras cuenta hacia abajo. Sigue armado.</translation>
    </message>
    <message>
        <source>Undo the last edit of the amplifier settings</source>
        <translation>Deshacer la última edición de los ajustes del amplificador</translation>
    </message>
    <message>
        <source>Redo the edit of the amplifier settings</source>
        <translation>Rehacer la edición de los ajustes del amplificador</translation>
    </message>
    <message>
        <source>Revert the amplifier settings to those last sent</source>
        <translation>Revertir los ajustes del amplificador a los últimos enviados</translation>
    </message>
    <message>
        <source>Restores the amplifier settings last sent. Sends nothing.</source>
        <translation>Restaura los últimos ajustes del amplificador enviados. No envía nada.</translation>
    </message>
    <message>
        <source>Clears the fields: no amplifier settings have been sent yet. Sends nothing.</source>
        <translation>Vacía los campos: aún no se han enviado ajustes del amplificador. No envía nada.</translation>
    </message>
    <message>
        <source>Choose what the limit inputs do.</source>
        <translation>Elija qué hacen las entradas de final de carrera.</translation>
    </message>
    <message>
        <source>A task is running on this module: wait for its end, or cancel it.</source>
        <translation>Hay una tarea en curso en este módulo: espere a que termine o cancélela.</translation>
    </message>
</context>
<context>
    <name>nmc::AskDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
</context>
<context>
    <name>nmc::AxesPage</name>
    <message>
        <source>All axes</source>
        <translation>Todos los ejes</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Lento</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Rápido</translation>
    </message>
    <message>
        <source>Slow jog</source>
        <translation>Lento: jog lento</translation>
    </message>
    <message>
        <source>Fast jog</source>
        <translation>Rápido: jog rápido</translation>
    </message>
    <message>
        <source>Step of all axes</source>
        <translation>Paso de todos los ejes</translation>
    </message>
    <message>
        <source>Each axis at its own jog speed.</source>
        <translation>Cada eje a su propia velocidad de jog.</translation>
    </message>
    <message>
        <source>Each axis at its own max jog speed, set on its Axis or Parameters page.</source>
        <translation>Cada eje a su propia velocidad de jog máxima, definida en su página Eje o Parámetros.</translation>
    </message>
    <message>
        <source>Distance that one click on Step moves an axis, in its own unit.</source>
        <translation>Distancia que un clic en “Paso” mueve un eje, en su propia unidad.</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 unidades</translation>
    </message>
    <message>
        <source>Enable all</source>
        <translation>Habilitar todo</translation>
    </message>
    <message>
        <source>Enable all motors</source>
        <translation>Habilitar todos los motores</translation>
    </message>
    <message>
        <source>Home all axes, one after the other</source>
        <translation>Referenciar todos los ejes, uno tras otro</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Homing is not set up for any axis. Set it up on each Homing page.</source>
        <translation>El referenciado no está configurado para ningún eje. Configúrelo en cada página Referenciado.</translation>
    </message>
    <message>
        <source>All motors are already enabled.</source>
        <translation>Todos los motores ya están habilitados.</translation>
    </message>
    <message>
        <source>Enables every motor at its present position.</source>
        <translation>Habilita cada motor en su posición actual.</translation>
    </message>
    <message>
        <source>Homes one axis after the other, in the order of the table, with each axis&apos;s homing settings. Any stop ends it.</source>
        <translation>Referencia un eje tras otro, en el orden de la tabla y con los ajustes de referenciado de cada eje. Cualquier parada lo termina.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisBox</name>
    <message>
        <source>Name of the axis</source>
        <translation>Nombre del eje</translation>
    </message>
    <message>
        <source>For example: Z axis</source>
        <translation>Por ejemplo: eje Z</translation>
    </message>
    <message>
        <source>The name of this axis in the list, in messages and in files.</source>
        <translation>El nombre de este eje en la lista, en los mensajes y en los archivos.</translation>
    </message>
    <message>
        <source>N&amp;ame</source>
        <translation>&amp;Nombre de eje</translation>
    </message>
    <message>
        <source>Unit of the axis</source>
        <translation>Unidad del eje</translation>
    </message>
    <message>
        <source>native counts</source>
        <translation>cuentas nativas</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>unidad propia</translation>
    </message>
    <message>
        <source>The unit for positions and speeds. Changing it keeps every physical value and sends nothing.</source>
        <translation>La unidad de posiciones y velocidades. Cambiarla conserva todas las magnitudes físicas y no envía nada.</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>Unidad &amp;física</translation>
    </message>
    <message>
        <source>Counts in 1 unit</source>
        <translation>Cuentas en 1 unidad</translation>
    </message>
    <message>
        <source>Counts or steps per unit.</source>
        <translation>Cuentas o pasos por unidad.</translation>
    </message>
    <message>
        <source>Symbol of the unit</source>
        <translation>Símbolo de la unidad</translation>
    </message>
    <message>
        <source>Shown after the numbers, for example µl.</source>
        <translation>Se muestra después de los números, por ejemplo µl.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Jog is never faster than this.</source>
        <translation>El jog nunca es más rápido que esto.</translation>
    </message>
    <message>
        <source>Max &amp;jog speed</source>
        <translation>Jog ha&amp;sta</translation>
    </message>
    <message>
        <source>A/D scale, per count</source>
        <translation>Escala A/D, por unidad</translation>
    </message>
    <message>
        <source>The value of one A/D count, for example 5 V / 255, or amperes from the amplifier&apos;s current sense.</source>
        <translation>El valor de una unidad A/D, por ejemplo 5 V / 255, o los amperios según el sensor de corriente del amplificador.</translation>
    </message>
    <message>
        <source>A/D at &amp;0</source>
        <translation>A/D en &amp;0</translation>
    </message>
    <message>
        <source>Unit of the A/D value</source>
        <translation>Unidad del valor A/D</translation>
    </message>
    <message>
        <source>A, V, or whatever the A/D input measures.</source>
        <translation>A, V o lo que mida la entrada A/D.</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>Unidad A/D</translation>
    </message>
    <message>
        <source>%1 in 1 %2</source>
        <translation>%1 en 1 %2</translation>
    </message>
    <message>
        <source>Calculate…</source>
        <translation>Calcular…</translation>
    </message>
    <message>
        <source>Calculate the unit from encoder, gear and screw</source>
        <translation>Calcular la unidad a partir de encoder, reductora y husillo</translation>
    </message>
    <message>
        <source>Calculates the unit from the data of encoder, gear and screw. Sends nothing.</source>
        <translation>Calcula la unidad a partir de los datos del encoder, la reductora y el husillo. No envía nada.</translation>
    </message>
    <message>
        <source>reversed: forward counts down</source>
        <translation>invertido: adelante cuenta hacia abajo</translation>
    </message>
    <message>
        <source>Reverses positions, directions and travel limits of this axis on the screen. Sends nothing.</source>
        <translation>Invierte en pantalla las posiciones, los sentidos y los límites de recorrido de este eje. No envía nada.</translation>
    </message>
    <message>
        <source>Axis %1 has the same name, so programs can call neither by it.</source>
        <translation>El eje %1 tiene el mismo nombre, así que los programas no pueden llamar así a ninguno de los dos.</translation>
    </message>
</context>
<context>
    <name>nmc::AxisRow</name>
    <message>
        <source>State of %1</source>
        <translation>Estado de %1</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Posición de %1</translation>
    </message>
    <message>
        <source>Hold to move %1 in reverse</source>
        <translation>Jog: mantener pulsado para mover %1 hacia atrás</translation>
    </message>
    <message>
        <source>Hold to move %1 forward</source>
        <translation>Jog: mantener pulsado para mover %1 hacia adelante</translation>
    </message>
    <message>
        <source>Step %1 in reverse</source>
        <translation>Paso de %1 hacia atrás</translation>
    </message>
    <message>
        <source>Step %1 forward</source>
        <translation>Paso de %1 hacia adelante</translation>
    </message>
    <message>
        <source>Home earlier</source>
        <translation>Referenciar antes</translation>
    </message>
    <message>
        <source>Home %1 one place earlier</source>
        <translation>Referenciar %1 un puesto antes</translation>
    </message>
    <message>
        <source>This step is less than one count of this axis, or beyond its range. Choose another step.</source>
        <translation>Este paso es menor que una cuenta de este eje o supera su rango. Elija otro paso.</translation>
    </message>
    <message>
        <source>Moves forward by the step above, then holds.</source>
        <translation>Se mueve hacia adelante el paso de arriba y después mantiene la posición.</translation>
    </message>
    <message>
        <source>Moves in reverse by the step above, then holds.</source>
        <translation>Se mueve hacia atrás el paso de arriba y después mantiene la posición.</translation>
    </message>
    <message>
        <source>Homing is not set up for this axis. Set it up on its Homing page.</source>
        <translation>El referenciado no está configurado para este eje. Configúrelo en su página Referenciado.</translation>
    </message>
    <message>
        <source>Home all starts with this axis.</source>
        <translation>“Referenciar todo” empieza por este eje.</translation>
    </message>
    <message>
        <source>Home all homes this axis as number %1. Click to move it one place earlier. Nothing moves.</source>
        <translation>“Referenciar todo” referencia este eje con el número %1. Haga clic para adelantarlo un puesto. Nada se mueve.</translation>
    </message>
    <message>
        <source>Home: %1.</source>
        <translation>Referencia: %1.</translation>
    </message>
    <message>
        <source>Home: –</source>
        <translation>Referencia: –</translation>
    </message>
</context>
<context>
    <name>nmc::Banner</name>
    <message>
        <source>Important message</source>
        <translation>Mensaje importante</translation>
    </message>
    <message>
        <source>Hides this message here. It stays in the message list.</source>
        <translation>Oculta aquí este mensaje. Sigue en la lista de mensajes.</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>Ocultar este mensaje</translation>
    </message>
    <message>
        <source>Shows the full text and all other messages in the message list.</source>
        <translation>Muestra el texto completo y los demás mensajes en la lista de mensajes.</translation>
    </message>
    <message>
        <source>%1 more…</source>
        <translation>%1 más…</translation>
    </message>
    <message>
        <source>Read all…</source>
        <translation>Leer todo…</translation>
    </message>
</context>
<context>
    <name>nmc::Bell</name>
    <message>
        <source>Plays a sound on each fault, and when a search for home, a test, a series of steps or a sequence ends.</source>
        <translation>Emite un sonido con cada fallo y al terminar un referenciado, una prueba, una serie de pasos o una secuencia.</translation>
    </message>
    <message>
        <source>So&amp;unds</source>
        <translation>&amp;Sonidos</translation>
    </message>
</context>
<context>
    <name>nmc::BenchTruth</name>
    <message>
        <source>Simulator values of the module</source>
        <translation>Valores del módulo en el simulador</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Eje del motor</translation>
    </message>
    <message>
        <source>The true position of the shaft since the simulation started.</source>
        <translation>La posición real del eje del motor desde que empezó la simulación.</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Contador de posición</translation>
    </message>
    <message>
        <source>The position as the module counts it.</source>
        <translation>La posición tal como la cuenta el módulo.</translation>
    </message>
    <message>
        <source>True, not calculated.</source>
        <translation>Real, no calculado.</translation>
    </message>
    <message>
        <source>Of the shaft.</source>
        <translation>Del eje del motor.</translation>
    </message>
    <message>
        <source>Step rate</source>
        <translation>Frecuencia de pasos</translation>
    </message>
    <message>
        <source>Negative in reverse.</source>
        <translation>Negativa hacia atrás.</translation>
    </message>
    <message>
        <source>The sign is the direction.</source>
        <translation>El signo es el sentido.</translation>
    </message>
    <message>
        <source>255 is full current.</source>
        <translation>255 es la corriente máxima.</translation>
    </message>
    <message>
        <source>A/D reads</source>
        <translation>Lectura A/D</translation>
    </message>
    <message>
        <source>Violations</source>
        <translation>Infracciones</translation>
    </message>
    <message>
        <source>Protocol violations that would upset a real module.</source>
        <translation>Infracciones del protocolo que alterarían un módulo real.</translation>
    </message>
    <message>
        <source>%1 s, module %2: %3, %4</source>
        <translation>%1 s, módulo %2: %3, %4</translation>
    </message>
</context>
<context>
    <name>nmc::BodePlot</name>
    <message>
        <source>No measurement yet. The motor follows sine waves from slow to fast, which shows the response of the loop.</source>
        <translation>Aún no hay ninguna medición. El motor sigue ondas senoidales de lentas a rápidas, lo que muestra la respuesta del lazo.</translation>
    </message>
    <message>
        <source>Magnitude, dB</source>
        <translation>Magnitud, dB</translation>
    </message>
    <message>
        <source>Phase, degrees</source>
        <translation>Fase, grados</translation>
    </message>
    <message>
        <source>T, closed loop</source>
        <translation>T, lazo cerrado</translation>
    </message>
    <message>
        <source>L, open loop</source>
        <translation>L, lazo abierto</translation>
    </message>
    <message>
        <source>T: closed loop, from command to position. L: open loop; its phase above -180° where it crosses 0 dB is the phase margin. Right of the grey line the baud rate is too low to measure. Bars: two standard deviations of T.</source>
        <translation>T: lazo cerrado, de la consigna a la posición. L: lazo abierto; su fase por encima de -180° donde cruza 0 dB es el margen de fase. A la derecha de la línea gris, la velocidad en baudios es demasiado baja para medir. Barras: dos desviaciones típicas de T.</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frecuencia, Hz</translation>
    </message>
</context>
<context>
    <name>nmc::ChainDialog</name>
    <message>
        <source>Doctor, groups and baud rate</source>
        <translation>Diagnóstico, grupos y baudios</translation>
    </message>
    <message>
        <source>Doctor</source>
        <translation>Diagnóstico</translation>
    </message>
</context>
<context>
    <name>nmc::ChainMenu</name>
    <message>
        <source>Chain &amp;doctor…</source>
        <translation>&amp;Diagnóstico de la cadena…</translation>
    </message>
    <message>
        <source>Compares the expected modules with those found, and shows where the chain probably breaks.</source>
        <translation>Compara los módulos esperados con los encontrados y muestra dónde se interrumpe probablemente la cadena.</translation>
    </message>
    <message>
        <source>&amp;Groups…</source>
        <translation>&amp;Grupos…</translation>
    </message>
    <message>
        <source>Assigns modules to groups, and starts their loaded moves together.</source>
        <translation>Asigna módulos a grupos e inicia a la vez sus movimientos cargados.</translation>
    </message>
    <message>
        <source>B&amp;aud rate of the chain…</source>
        <translation>Velocid&amp;ad en baudios de la cadena…</translation>
    </message>
    <message>
        <source>Changes the baud rate of the whole chain.</source>
        <translation>Cambia la velocidad en baudios de toda la cadena.</translation>
    </message>
    <message>
        <source>Scans the chain again; nothing is reset.</source>
        <translation>Vuelve a buscar los módulos de la cadena; no se reinicia nada.</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost…</source>
        <translation>&amp;Reiniciar la red: se pierden posiciones y ganancias…</translation>
    </message>
    <message>
        <source>&amp;Let programs in</source>
        <translation>Dejar entrar progra&amp;mas</translation>
    </message>
    <message>
        <source>Other programs on this computer may read the chain, and ask to move motors.</source>
        <translation>Otros programas de este equipo pueden leer la cadena y pedir mover motores.</translation>
    </message>
    <message>
        <source>L&amp;end the line to a program…</source>
        <translation>Pr&amp;estar la línea a un programa…</translation>
    </message>
    <message>
        <source>A program has the modules for itself; the panel shows what they report.</source>
        <translation>Un programa tiene los módulos para sí; el panel muestra lo que comunican.</translation>
    </message>
    <message>
        <source>&amp;Copy settings to other axes…</source>
        <translation>&amp;Copiar ajustes a otros ejes…</translation>
    </message>
    <message>
        <source>Copies gains, limits and other settings to axes of the same type. Shows the differences first.</source>
        <translation>Copia ganancias, límites y otros ajustes a ejes del mismo tipo. Muestra primero las diferencias.</translation>
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
        <translation>%1, %2, en la dirección %3 de la línea</translation>
    </message>
    <message>
        <source>%1 · looking for modules…</source>
        <translation>%1 · buscando módulos…</translation>
    </message>
    <message>
        <source>%1, address %2, %3, %4</source>
        <translation>%1, dirección %2, %3, %4</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocida</translation>
    </message>
    <message>
        <source>%1, position %2</source>
        <translation>%1, posición %2</translation>
    </message>
</context>
<context>
    <name>nmc::ChainView</name>
    <message>
        <source>Modules in wire order, the farthest from the PC first</source>
        <translation>Módulos en el orden de la línea, primero el más alejado del PC</translation>
    </message>
    <message>
        <source>Not connected.

Choose a port above and connect. Without hardware, choose the simulator.</source>
        <translation>Sin conexión.

Elija arriba un puerto y conecte. Si no tiene hardware, elija el simulador.</translation>
    </message>
</context>
<context>
    <name>nmc::ColourChoice</name>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Alto contraste</translation>
    </message>
</context>
<context>
    <name>nmc::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Buscar un comando</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Buscar comandos</translation>
    </message>
    <message>
        <source>Type what to do, for example: go home</source>
        <translation>Escriba qué hacer, por ejemplo: ir a referencia</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
    <message>
        <source>What it does, or why it is unavailable</source>
        <translation>Qué hace, o por qué no está disponible</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>Ningún comando coincide.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Ahora no es posible.</translation>
    </message>
    <message>
        <source>Press Enter to run it.</source>
        <translation>Pulse Intro para ejecutarlo.</translation>
    </message>
    <message>
        <source>Its module is no longer connected.</source>
        <translation>Su módulo ya no está conectado.</translation>
    </message>
    <message>
        <source>Press Enter to show it on the module&apos;s page. Nothing is sent.</source>
        <translation>Pulse Intro para mostrarlo en la página del módulo. No se envía nada.</translation>
    </message>
</context>
<context>
    <name>nmc::ConnectionBar</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Conectar</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Desconectar</translation>
    </message>
    <message>
        <source>Connection and stop</source>
        <translation>Conexión y parada</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>The serial port of the modules, or the simulator.</source>
        <translation>El puerto serie de los módulos, o el simulador.</translation>
    </message>
    <message>
        <source>The baud rate for a chain without addresses; a chain that has them keeps its rate.</source>
        <translation>La velocidad en baudios para una cadena sin direcciones; una que ya las tiene conserva la suya.</translation>
    </message>
    <message>
        <source>Por&amp;t</source>
        <translation>P&amp;uerto</translation>
    </message>
    <message>
        <source>Bd</source>
        <translation>Bd</translation>
    </message>
    <message>
        <source>not listed</source>
        <translation>no está en la lista</translation>
    </message>
    <message>
        <source>no hardware needed</source>
        <translation>no necesita hardware</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>Disconnect first.</source>
        <translation>Desconecte primero.</translation>
    </message>
    <message>
        <source>No port is open.</source>
        <translation>No hay ningún puerto abierto.</translation>
    </message>
    <message>
        <source>Closes the port.</source>
        <translation>Cierra el puerto.</translation>
    </message>
    <message>
        <source>Connect read-&amp;only</source>
        <translation>Conectar en s&amp;olo lectura</translation>
    </message>
    <message>
        <source>Other ways to connect</source>
        <translation>Otras formas de conectar</translation>
    </message>
    <message>
        <source>Other ways to connect.</source>
        <translation>Otras formas de conectar.</translation>
    </message>
    <message>
        <source>Opens the port and only reads: only status requests are sent. STOP ALL still works.</source>
        <translation>Abre el puerto y solo lee: solo se envían consultas de estado. PARAR TODO sigue funcionando.</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>Baudios</translation>
    </message>
</context>
<context>
    <name>nmc::ControlLineBox</name>
    <message>
        <source>Control line</source>
        <translation>Línea de control</translation>
    </message>
    <message>
        <source>Type an nmcsim command, then press Enter: state, set, power-cycle, break, mend, stats, time, fault. Shortcut: Ctrl+L.</source>
        <translation>Escriba un comando de nmcsim y pulse Intro: state, set, power-cycle, break, mend, stats, time, fault. Atajo: Ctrl+L.</translation>
    </message>
    <message>
        <source>The simulator&apos;s answer</source>
        <translation>Respuesta del simulador</translation>
    </message>
</context>
<context>
    <name>nmc::CopyDialog</name>
    <message>
        <source>Axis to copy from</source>
        <translation>Eje de origen</translation>
    </message>
    <message>
        <source>The axis whose settings are copied.</source>
        <translation>El eje cuyos ajustes se copian.</translation>
    </message>
    <message>
        <source>&amp;Show differences</source>
        <translation>&amp;Mostrar las diferencias</translation>
    </message>
    <message>
        <source>Copy settings to other axes</source>
        <translation>Copiar ajustes a otros ejes</translation>
    </message>
    <message>
        <source>Axes to copy to</source>
        <translation>Ejes de destino</translation>
    </message>
    <message>
        <source>Axes with the same type of module and other settings.</source>
        <translation>Ejes con el mismo tipo de módulo y otros ajustes.</translation>
    </message>
    <message>
        <source>Settings to copy</source>
        <translation>Ajustes que copiar</translation>
    </message>
    <message>
        <source>Settings in which at least one of these axes differs.</source>
        <translation>Ajustes en los que al menos uno de estos ejes difiere.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>The differences are shown before anything is changed or sent. Numbers are copied in the units of the module: counts or steps.</source>
        <translation>Las diferencias se muestran antes de cambiar o enviar nada. Los números se copian en las unidades del módulo: cuentas o pasos.</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;A</translation>
    </message>
    <message>
        <source>S&amp;ettings</source>
        <translation>A&amp;justes</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;De</translation>
    </message>
    <message>
        <source>No other axis with this type of module has other settings.</source>
        <translation>Ningún otro eje con este tipo de módulo tiene otros ajustes.</translation>
    </message>
    <message>
        <source>Select the axes to copy to.</source>
        <translation>Seleccione los ejes de destino.</translation>
    </message>
    <message>
        <source>Select the settings to copy.</source>
        <translation>Seleccione los ajustes que copiar.</translation>
    </message>
    <message>
        <source>These settings are the same already.</source>
        <translation>Estos ajustes ya son iguales.</translation>
    </message>
    <message>
        <source>Shows what would change. Nothing is sent.</source>
        <translation>Muestra lo que cambiaría. No se envía nada.</translation>
    </message>
</context>
<context>
    <name>nmc::CounterBox</name>
    <message>
        <source>Set and restart</source>
        <translation>Fijar y reiniciar</translation>
    </message>
    <message>
        <source>Set and restart the timer or counter</source>
        <translation>Fijar y reiniciar el temporizador o contador</translation>
    </message>
    <message>
        <source>Latch inputs</source>
        <translation>Capturar entradas</translation>
    </message>
    <message>
        <source>Latch inputs and counter at the same time</source>
        <translation>Capturar entradas y contador a la vez</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Almacenar</translation>
    </message>
    <message>
        <source>Store outputs for later</source>
        <translation>Almacenar salidas para después</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Emitir</translation>
    </message>
    <message>
        <source>Apply the stored outputs</source>
        <translation>Emitir las salidas almacenadas</translation>
    </message>
    <message>
        <source>Counter and synchronous I/O</source>
        <translation>Contador y E/S síncronas</translation>
    </message>
    <message>
        <source>Counter source</source>
        <translation>Fuente del contador</translation>
    </message>
    <message>
        <source>timer, 5 MHz</source>
        <translation>temporizador, 5 MHz</translation>
    </message>
    <message>
        <source>counter of rising edges on IO10</source>
        <translation>contador de flancos de subida en IO10</translation>
    </message>
    <message>
        <source>Prescaler</source>
        <translation>Preescalador</translation>
    </message>
    <message>
        <source>every edge</source>
        <translation>cada flanco</translation>
    </message>
    <message>
        <source>every 2nd edge</source>
        <translation>cada 2.º flanco</translation>
    </message>
    <message>
        <source>every 4th edge</source>
        <translation>cada 4.º flanco</translation>
    </message>
    <message>
        <source>every 8th edge</source>
        <translation>cada 8.º flanco</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Recuento</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Cuenta</translation>
    </message>
    <message>
        <source>Latched values</source>
        <translation>Valores capturados</translation>
    </message>
    <message>
        <source>Latched</source>
        <translation>Capturado</translation>
    </message>
    <message>
        <source>Outputs to store</source>
        <translation>Salidas que almacenar</translation>
    </message>
    <message>
        <source>Add up the outputs: IO1 is 1, IO2 is 2, IO3 is 4, up to IO12, which is 2048.</source>
        <translation>Sume las salidas: IO1 es 1, IO2 es 2, IO3 es 4, hasta IO12, que es 2048.</translation>
    </message>
    <message>
        <source>%1 to store</source>
        <translation>%1 que almacenar</translation>
    </message>
    <message>
        <source>Counter source unknown: another program has set it.</source>
        <translation>Fuente del contador desconocida: la configuró otro programa.</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>= %1 s</translation>
    </message>
    <message>
        <source>%1 Hz on IO10</source>
        <translation>%1 Hz en IO10</translation>
    </message>
    <message>
        <source>IO12 to IO1: %1, count %2</source>
        <translation>IO12 a IO1: %1, recuento %2</translation>
    </message>
    <message>
        <source>Sends the settings above. The count restarts at 0.</source>
        <translation>Envía los ajustes de arriba. El recuento vuelve a empezar en 0.</translation>
    </message>
    <message>
        <source>Latches all pins and the count at the same moment, and reads them.</source>
        <translation>Captura todos los pines y el recuento en el mismo instante y los lee.</translation>
    </message>
    <message>
        <source>Sends these values to the module, which keeps them until you apply them.</source>
        <translation>Envía estos valores al módulo, que los guarda hasta que usted los emita.</translation>
    </message>
    <message>
        <source>Store outputs first.</source>
        <translation>Almacene primero las salidas.</translation>
    </message>
    <message>
        <source>Applies the stored pin levels and PWM values at the same moment.</source>
        <translation>Emite los pines y los valores de PWM almacenados en el mismo instante.</translation>
    </message>
    <message>
        <source>stored: %1, PWM %2 and %3</source>
        <translation>almacenado: %1, PWM %2 y %3</translation>
    </message>
</context>
<context>
    <name>nmc::CounterTable</name>
    <message>
        <source>Counters of the link</source>
        <translation>Contadores del enlace</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Recuento</translation>
    </message>
    <message>
        <source>Since the chain was found</source>
        <translation>Desde que se encontró la cadena</translation>
    </message>
    <message>
        <source>sent: commands that asked for an answer</source>
        <translation>enviados: comandos que pedían respuesta</translation>
    </message>
    <message>
        <source>accepted: answers that passed all checks</source>
        <translation>aceptadas: respuestas que superaron todas las comprobaciones</translation>
    </message>
    <message>
        <source>mean round trip, from sending a command to its complete answer</source>
        <translation>tiempo de respuesta medio, desde el envío de un comando hasta su respuesta completa</translation>
    </message>
    <message>
        <source>longest round trip</source>
        <translation>tiempo de respuesta más largo</translation>
    </message>
    <message>
        <source>retried: commands that were sent again</source>
        <translation>reintentados: comandos que se enviaron de nuevo</translation>
    </message>
    <message>
        <source>timeouts: no answer, or too few bytes</source>
        <translation>tiempos agotados: sin respuesta o con bytes de menos</translation>
    </message>
    <message>
        <source>refused by the module: the command reached it with a wrong checksum</source>
        <translation>rechazados por el módulo: el comando le llegó con una suma de comprobación errónea</translation>
    </message>
    <message>
        <source>wrong checksums: the answer was corrupted in transit</source>
        <translation>sumas de comprobación erróneas: la respuesta se dañó por el camino</translation>
    </message>
    <message>
        <source>surplus bytes: received without a request</source>
        <translation>bytes sobrantes: recibidos sin haberlos pedido</translation>
    </message>
    <message>
        <source>of these, stale: late answers, discarded</source>
        <translation>de ellos obsoletos: respuestas tardías, descartadas</translation>
    </message>
    <message>
        <source>resyncs: link checked again after errors</source>
        <translation>resincronizaciones: enlace comprobado de nuevo tras errores</translation>
    </message>
    <message>
        <source>rejected by a rule: checksum right, but answer implausible</source>
        <translation>rechazadas por una regla: suma de comprobación correcta, pero respuesta inverosímil</translation>
    </message>
    <message>
        <source>  of these: %1</source>
        <translation>  de ellas: %1</translation>
    </message>
</context>
<context>
    <name>nmc::CursorPanel</name>
    <message>
        <source>Shows or hides the cursor readings.</source>
        <translation>Muestra u oculta las lecturas de los cursores.</translation>
    </message>
    <message>
        <source>Between the cursors: %1</source>
        <translation>Entre los cursores: %1</translation>
    </message>
    <message>
        <source>Spectrum…</source>
        <translation>Espectro…</translation>
    </message>
    <message>
        <source>Shows at which frequencies a signal oscillates between the cursors.</source>
        <translation>Muestra a qué frecuencias oscila una señal entre los cursores.</translation>
    </message>
    <message>
        <source>XY view…</source>
        <translation>Vista XY…</translation>
    </message>
    <message>
        <source>Shows one signal over another between the cursors.</source>
        <translation>Muestra una señal en función de otra, entre los cursores.</translation>
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
        <translation>Media</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Pico a pico</translation>
    </message>
    <message>
        <source>Slope, per s</source>
        <translation>Pendiente, por s</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frecuencia</translation>
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
        <translation>El movimiento ha terminado; en modo de velocidad se ha alcanzado la velocidad objetivo.</translation>
    </message>
    <message>
        <source>The current limit was reached. Stays set until you clear the sticky bits.</source>
        <translation>Se alcanzó el límite de corriente. Queda activo hasta que borre los bits enclavados.</translation>
    </message>
    <message>
        <source>Motor power is present.</source>
        <translation>Hay alimentación del motor.</translation>
    </message>
    <message>
        <source>The position error exceeded its limit, or the servo is off. Stays set until you clear the sticky bits.</source>
        <translation>El error de posición superó su límite, o el servo está apagado. Queda activo hasta que borre los bits enclavados.</translation>
    </message>
    <message>
        <source>The complement of the encoder&apos;s index.</source>
        <translation>El complemento del índice del encoder.</translation>
    </message>
    <message>
        <source>The 32-bit position has wrapped. Stays set until you clear the sticky bits.</source>
        <translation>La posición de 32 bits se ha desbordado. Queda activo hasta que borre los bits enclavados.</translation>
    </message>
    <message>
        <source>The servo is on.</source>
        <translation>El servo está encendido.</translation>
    </message>
    <message>
        <source>The first acceleration phase of the move has ended.</source>
        <translation>La primera fase de aceleración del movimiento ha terminado.</translation>
    </message>
    <message>
        <source>The constant phase of the move has ended.</source>
        <translation>La fase de velocidad constante del movimiento ha terminado.</translation>
    </message>
    <message>
        <source>A servo tick took too long; typically not serious. Stays set until you clear the sticky bits.</source>
        <translation>Un ciclo de servo duró demasiado; normalmente no es grave. Queda activo hasta que borre los bits enclavados.</translation>
    </message>
    <message>
        <source>Clear stic&amp;ky bits</source>
        <translation>Borrar bit&amp;s enclavados</translation>
    </message>
    <message>
        <source>Clear sticky bits of the status</source>
        <translation>Borrar bits enclavados del estado</translation>
    </message>
    <message>
        <source>Auxiliary byte</source>
        <translation>Byte auxiliar</translation>
    </message>
    <message>
        <source>A/D (motor current)</source>
        <translation>A/D (corriente del motor)</translation>
    </message>
    <message>
        <source>Velocity reported by the chip</source>
        <translation>Velocidad comunicada por el chip</translation>
    </message>
    <message>
        <source>, auxiliary %1</source>
        <translation>, auxiliar %1</translation>
    </message>
    <message>
        <source>Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing.</source>
        <translation>Borra overcurrent, pos_error, pos_wrap y servo_overrun. No inicia nada.</translation>
    </message>
    <message>
        <source>Position error reported by the chip</source>
        <translation>Error de posición comunicado por el chip</translation>
    </message>
    <message>
        <source>Path points left</source>
        <translation>Puntos de trayectoria restantes</translation>
    </message>
    <message>
        <source>The module is sending step pulses.</source>
        <translation>Llegan pulsos de paso.</translation>
    </message>
    <message>
        <source>The driver is enabled (AMP_EN is high).</source>
        <translation>El driver está habilitado (AMP_EN está alto).</translation>
    </message>
    <message>
        <source>Motor power is present (PWR_SENSE is high).</source>
        <translation>Hay alimentación del motor (PWR_SENSE está alto).</translation>
    </message>
    <message>
        <source>The motor has reached its commanded speed.</source>
        <translation>El motor ha alcanzado la velocidad de consigna.</translation>
    </message>
    <message>
        <source>Runs with a ramp: velocity profile mode.</source>
        <translation>Gira con rampa: modo de perfil de velocidad.</translation>
    </message>
    <message>
        <source>Moves to a position with a ramp: trapezoidal profile mode.</source>
        <translation>Va a una posición con rampa: modo de perfil trapezoidal.</translation>
    </message>
    <message>
        <source>High stops the motor, unless it is ignored.</source>
        <translation>El nivel alto detiene el motor, salvo que se ignore.</translation>
    </message>
    <message>
        <source>General purpose input.</source>
        <translation>Entrada de uso general.</translation>
    </message>
    <message>
        <source>For homing.</source>
        <translation>Sirve para el referenciado.</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>parado</translation>
    </message>
    <message>
        <source>trapezoidal profile</source>
        <translation>perfil trapezoidal</translation>
    </message>
    <message>
        <source>velocity profile</source>
        <translation>perfil de velocidad</translation>
    </message>
    <message>
        <source>unprofiled, with stop</source>
        <translation>sin perfil, con parada</translation>
    </message>
    <message>
        <source>unprofiled, without stop</source>
        <translation>sin perfil, sin parada</translation>
    </message>
    <message>
        <source>moving, commanded by another program</source>
        <translation>en movimiento, por orden de otro programa</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>Cero a&amp;quí</translation>
    </message>
    <message>
        <source>Inputs byte</source>
        <translation>Byte de entradas</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Timer count</source>
        <translation>Valor del temporizador</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>, inputs %1</source>
        <translation>, entradas %1</translation>
    </message>
    <message>
        <source>High blocks counting up, unless it is ignored.</source>
        <translation>El nivel alto bloquea la cuenta hacia arriba, salvo que se ignore.</translation>
    </message>
    <message>
        <source>High blocks counting down, unless it is ignored.</source>
        <translation>El nivel alto bloquea la cuenta hacia abajo, salvo que se ignore.</translation>
    </message>
</context>
<context>
    <name>nmc::DifferencesDialog</name>
    <message>
        <source>&amp;Select all</source>
        <translation>&amp;Marcar todo</translation>
    </message>
    <message>
        <source>Clear a&amp;ll</source>
        <translation>&amp;Desmarcar todo</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Aplicar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>En el archivo</translation>
    </message>
    <message>
        <source>Here or last sent</source>
        <translation>Aquí o último enviado</translation>
    </message>
    <message>
        <source>When applied</source>
        <translation>Al aplicar</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Marcar todo</translation>
    </message>
    <message>
        <source>Selects all check boxes, including settings sent to modules that are on.</source>
        <translation>Marca todas las casillas, incluidos los ajustes que se envían a módulos encendidos.</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>Desmarcar todo</translation>
    </message>
    <message>
        <source>Clears all check boxes.</source>
        <translation>Desmarca todas las casillas.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Keeps everything as it is.</source>
        <translation>Deja todo como está.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; differs from the current settings. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced by those in the file.</source>
        <translation>“%1” difiere de los ajustes actuales. No se cambia ni se envía nada hasta que elija Aplicar, y ningún motor se mueve. Los valores escritos y no enviados se sustituyen por los del archivo.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 valores</translation>
    </message>
    <message>
        <source>Applies the selected settings and sends those marked as sent.</source>
        <translation>Aplica los ajustes marcados y envía los indicados para enviar.</translation>
    </message>
    <message>
        <source>Selected: %1 of %2. Sent to modules: %3.</source>
        <translation>Marcados: %1 de %2. Se envían a módulos: %3.</translation>
    </message>
    <message>
        <source>Differences from the present settings</source>
        <translation>Diferencias con los ajustes actuales</translation>
    </message>
    <message>
        <source>Settings of %1 for other axes. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced.</source>
        <translation>Ajustes de %1 para otros ejes. Nada se cambia ni se envía hasta que elija Aplicar, y ningún motor se mueve. Los valores escritos pero no enviados se reemplazan.</translation>
    </message>
    <message>
        <source>Copy settings</source>
        <translation>Copiar ajustes</translation>
    </message>
    <message>
        <source>%1: differences</source>
        <translation>%1: diferencias</translation>
    </message>
</context>
<context>
    <name>nmc::DirectBox</name>
    <message>
        <source>%1 as set here</source>
        <translation>%1 como se indica aquí</translation>
    </message>
    <message>
        <source>What the chip will do</source>
        <translation>Lo que hará el chip</translation>
    </message>
    <message>
        <source>Command bytes</source>
        <translation>Bytes del comando</translation>
    </message>
    <message>
        <source>A bit of %1: %2</source>
        <translation>Un bit de %1: %2</translation>
    </message>
    <message>
        <source>Bits of %1: %2</source>
        <translation>Bits de %1: %2</translation>
    </message>
    <message>
        <source>Data of %1: %2</source>
        <translation>Datos de %1: %2</translation>
    </message>
    <message>
        <source>%1: load</source>
        <translation>%1: cargar</translation>
    </message>
    <message>
        <source>If cleared, the chip keeps the previously loaded value.</source>
        <translation>Si está desmarcado, el chip conserva el valor cargado antes.</translation>
    </message>
</context>
<context>
    <name>nmc::DirectionCheckBox</name>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Direction check…</source>
        <translation>Prueba de sentido…</translation>
    </message>
    <message>
        <source>Direction of motor and encoder</source>
        <translation>Sentido del motor y del encoder</translation>
    </message>
    <message>
        <source>Direction check of motor and encoder</source>
        <translation>Prueba de sentido del motor y del encoder</translation>
    </message>
    <message>
        <source>Cancel the direction check</source>
        <translation>Cancelar la prueba de sentido</translation>
    </message>
    <message>
        <source>Result of the direction check</source>
        <translation>Resultado de la prueba de sentido</translation>
    </message>
    <message>
        <source>A direction check is running.</source>
        <translation>Hay una prueba de sentido en curso.</translation>
    </message>
    <message>
        <source>Something turns the motor. Wait until it is at rest.</source>
        <translation>Algo gira el motor. Espere a que esté parado.</translation>
    </message>
    <message>
        <source>The motor of %1 will move a little, forward and in reverse. It is driven in pulses of less than 0.1 s, with slowly rising power up to %2 % of its supply, until it has moved %3. A motor that runs freely may coast farther; more than %4 ends the check. Keep clear of it.</source>
        <translation>El motor de %1 se moverá un poco, hacia adelante y hacia atrás. Se le empuja menos de 0,1 s cada vez, con una potencia que sube despacio hasta el %2 % de su alimentación, hasta que se haya movido %3. Un motor que gira libremente puede seguir más por inercia; más de %4 termina la prueba. Manténgase alejado de él.</translation>
    </message>
    <message>
        <source>Direction check</source>
        <translation>Prueba de sentido</translation>
    </message>
    <message>
        <source>&amp;Pulse motor</source>
        <translation>Em&amp;pujar el motor</translation>
    </message>
    <message>
        <source>Driving it in reverse.</source>
        <translation>Empujando hacia atrás.</translation>
    </message>
    <message>
        <source>Driving it forward.</source>
        <translation>Empujando hacia adelante.</translation>
    </message>
    <message>
        <source>Inconclusive: see the message.</source>
        <translation>No concluyente: consulte el mensaje.</translation>
    </message>
    <message>
        <source>Not checked in this connection. Run the check before you enable the servo for the first time: with motor or encoder reversed, it runs away.</source>
        <translation>Sin probar en esta conexión. Haga la prueba antes de habilitar el servo por primera vez: con el motor o el encoder invertido, se embala.</translation>
    </message>
    <message>
        <source>Moves the motor a little, without the servo, to check that it turns the way its encoder counts. Asks first.</source>
        <translation>Mueve el motor un poco, sin el servo, para comprobar que gira en el sentido en que cuenta su encoder. Pregunta antes.</translation>
    </message>
    <message>
        <source>No direction check is running.</source>
        <translation>No hay ninguna prueba de sentido en curso.</translation>
    </message>
    <message>
        <source>Ends the check and switches the motor off.</source>
        <translation>Termina la prueba y apaga el motor.</translation>
    </message>
</context>
<context>
    <name>nmc::DoctorPage</name>
    <message>
        <source>Chain doctor</source>
        <translation>Diagnóstico de la cadena</translation>
    </message>
    <message>
        <source>Modules expected and found, the farthest from the PC first</source>
        <translation>Módulos esperados y encontrados, primero el más alejado del PC</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Esperado</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Scan again: look for modules</source>
        <translation>Volver a buscar: módulos de la cadena</translation>
    </message>
    <message>
        <source>Accep&amp;t as found</source>
        <translation>Acep&amp;tar lo encontrado</translation>
    </message>
    <message>
        <source>Accept as found</source>
        <translation>Aceptar lo encontrado</translation>
    </message>
    <message>
        <source>&amp;Restart the network…</source>
        <translation>&amp;Reiniciar la red…</translation>
    </message>
    <message>
        <source>Restart the network: positions and gains are lost</source>
        <translation>Reiniciar la red: se pierden posiciones y ganancias</translation>
    </message>
    <message>
        <source>Scans the chain again with status requests only: nothing is reset, nothing moves.</source>
        <translation>Vuelve a buscar los módulos de la cadena solo con consultas de estado: no se reinicia nada, nada se mueve.</translation>
    </message>
    <message>
        <source>The chain already matches.</source>
        <translation>La cadena ya coincide.</translation>
    </message>
    <message>
        <source>From now on, the panel expects the modules found here.</source>
        <translation>Desde ahora el panel espera los módulos encontrados aquí.</translation>
    </message>
</context>
<context>
    <name>nmc::ExpertBox</name>
    <message>
        <source>Capture only</source>
        <translation>Solo capturar</translation>
    </message>
    <message>
        <source>Stop abruptly</source>
        <translation>Parar bruscamente</translation>
    </message>
    <message>
        <source>Stop smoothly</source>
        <translation>Parar suavemente</translation>
    </message>
    <message>
        <source>The chip stops watching for home.</source>
        <translation>El chip deja de vigilar la referencia.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register and stops. Start the motion with a command of your own.</source>
        <translation>En el primero de estos eventos el chip guarda su posición en el registro de referencia y se detiene. Inicie el movimiento con un comando propio.</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register. The motion goes on.</source>
        <translation>En el primero de estos eventos el chip guarda su posición en el registro de referencia. El movimiento continúa.</translation>
    </message>
    <message>
        <source>Load Trajectory</source>
        <translation>Load Trajectory</translation>
    </message>
    <message>
        <source>Send load</source>
        <translation>Enviar carga</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Trapezoidal</source>
        <translation>Trapezoidal</translation>
    </message>
    <message>
        <source>Position (counts)</source>
        <translation>Posición (cuentas)</translation>
    </message>
    <message>
        <source>Velocity (counts/tick × 65536)</source>
        <translation>Velocidad (cuentas/ciclo × 65536)</translation>
    </message>
    <message>
        <source>Acceleration (counts/tick² × 65536)</source>
        <translation>Aceleración (cuentas/ciclo² × 65536)</translation>
    </message>
    <message>
        <source>Reverse (velocity and PWM)</source>
        <translation>Atrás (velocidad y PWM)</translation>
    </message>
    <message>
        <source>Start motion now</source>
        <translation>Iniciar movimiento ya</translation>
    </message>
    <message>
        <source>Stop Motor</source>
        <translation>Stop Motor</translation>
    </message>
    <message>
        <source>Send stop</source>
        <translation>Enviar parada</translation>
    </message>
    <message>
        <source>Amplifier only</source>
        <translation>Solo amplificador</translation>
    </message>
    <message>
        <source>At a position</source>
        <translation>En una posición</translation>
    </message>
    <message>
        <source>Amplifier enabled</source>
        <translation>Amplificador habilitado</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. The servo stays as it is.</source>
        <translation>Conmuta solo AMP_EN. El servo queda como está.</translation>
    </message>
    <message>
        <source>The servo is switched off. The motor is free to turn.</source>
        <translation>El servo se apaga. El motor puede girar libremente.</translation>
    </message>
    <message>
        <source>The motor stops at once and holds.</source>
        <translation>El motor se detiene de inmediato y mantiene la posición.</translation>
    </message>
    <message>
        <source>The servo is switched ON and holds its position.</source>
        <translation>El servo se ENCIENDE y mantiene su posición.</translation>
    </message>
    <message>
        <source>The motor slows down with the loaded acceleration and holds.</source>
        <translation>El motor frena con la aceleración cargada y mantiene la posición.</translation>
    </message>
    <message>
        <source>The motor goes to this position without a profile, as fast as the gains drive it, and holds there.</source>
        <translation>El motor va a esta posición sin perfil, tan rápido como lo llevan las ganancias, y la mantiene.</translation>
    </message>
    <message>
        <source>Set Homing Mode</source>
        <translation>Set Homing Mode</translation>
    </message>
    <message>
        <source>Send homing mode</source>
        <translation>Enviar modo de ref.</translation>
    </message>
    <message>
        <source>Change of limit 1</source>
        <translation>Cambio del final 1</translation>
    </message>
    <message>
        <source>Change of limit 2</source>
        <translation>Cambio del final 2</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Table 4 of the data sheet has no such mode for the present state of the motor.</source>
        <translation>La tabla 4 no prevé ese modo desde el estado actual del motor.</translation>
    </message>
    <message>
        <source>Position (steps)</source>
        <translation>Posición (pasos)</translation>
    </message>
    <message>
        <source>Acceleration time (0.25 ms)</source>
        <translation>Tiempo de aceleración (0,25 ms)</translation>
    </message>
    <message>
        <source>Initial timer count</source>
        <translation>Valor inicial del temporizador</translation>
    </message>
    <message>
        <source>Nearest integer speed</source>
        <translation>Velocidad entera más próxima</translation>
    </message>
    <message>
        <source>Reverse (not trapezoidal)</source>
        <translation>Atrás (no trapezoidal)</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. A motion in progress keeps counting.</source>
        <translation>Conmuta solo AMP_EN. Un movimiento en curso sigue contando.</translation>
    </message>
    <message>
        <source>The steps end at once.</source>
        <translation>Los pasos terminan de inmediato.</translation>
    </message>
    <message>
        <source>The motor slows down with its acceleration time.</source>
        <translation>El motor frena con su tiempo de aceleración.</translation>
    </message>
    <message>
        <source>Change of the home switch</source>
        <translation>Cambio del interruptor de referencia</translation>
    </message>
    <message>
        <source>Commands as in the data sheet</source>
        <translation>Comandos como en la hoja de datos</translation>
    </message>
    <message>
        <source>Commands as in the data sheet, in native counts. STOP ALL and Esc work as usual.</source>
        <translation>Comandos como en la hoja de datos, en cuentas nativas. PARAR TODO y Esc funcionan como siempre.</translation>
    </message>
    <message>
        <source>%1 Waits for Start Motion; the next load overwrites it.</source>
        <translation>%1 Espera a Start Motion; la próxima carga lo sobrescribe.</translation>
    </message>
    <message>
        <source>The servo is off; the PWM value drives the motor. No limit applies.</source>
        <translation>El servo está apagado; el valor de PWM acciona el motor. No se aplica ningún límite.</translation>
    </message>
    <message>
        <source>The motor runs until it is stopped.</source>
        <translation>El motor gira hasta que se le ordene parar.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position. Start it only from standstill.</source>
        <translation>Un movimiento trapezoidal a la posición. Inícielo solo con el motor parado.</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position.</source>
        <translation>Un movimiento trapezoidal a la posición.</translation>
    </message>
    <message>
        <source>A ramp to the speed. The motor runs until it is stopped.</source>
        <translation>Una rampa hasta la velocidad. El motor gira hasta que se le ordene parar.</translation>
    </message>
    <message>
        <source>One speed from the first step to the position.</source>
        <translation>Una sola velocidad desde el primer paso hasta la posición.</translation>
    </message>
    <message>
        <source>One speed from the first step. The motor runs until it is stopped.</source>
        <translation>Una sola velocidad desde el primer paso. El motor gira hasta que se le ordene parar.</translation>
    </message>
    <message>
        <source>The move continues to its position at this speed. If it has just ended, the motor runs until it is stopped.</source>
        <translation>El movimiento continúa hasta su posición a esta velocidad. Si acaba de terminar, el motor gira hasta que se le ordene parar.</translation>
    </message>
    <message>
        <source>Reset module…</source>
        <translation>Reiniciar módulo…</translation>
    </message>
    <message>
        <source>Reset module to its power-up state</source>
        <translation>Reiniciar módulo a su estado de arranque</translation>
    </message>
    <message>
        <source>Returns this module to its power-up state and assigns its address again. The other modules are unchanged.</source>
        <translation>Devuelve este módulo a su estado de arranque y le asigna de nuevo su dirección. Los demás módulos no cambian.</translation>
    </message>
    <message>
        <source>Reset module</source>
        <translation>Reiniciar módulo</translation>
    </message>
    <message>
        <source>Reset %1? Its motor switches off, and it loses its position, settings and group. The other modules are unchanged.</source>
        <translation>¿Reiniciar %1? Su motor se apaga, y pierde su posición, sus ajustes y su grupo. Los demás módulos no cambian.</translation>
    </message>
    <message>
        <source>Reset the module</source>
        <translation>Reiniciar el módulo</translation>
    </message>
    <message>
        <source>Relative (trapezoidal)</source>
        <translation>Relativo (trapezoidal)</translation>
    </message>
    <message>
        <source>A trapezoidal move by this many counts, from the command position. Start it only from standstill.</source>
        <translation>Un movimiento trapezoidal de este número de cuentas, desde la consigna del servo. Inícielo solo con el motor parado.</translation>
    </message>
    <message>
        <source>Advanced features on</source>
        <translation>Funciones avanzadas activas</translation>
    </message>
    <message>
        <source>Reset Position</source>
        <translation>Reset Position</translation>
    </message>
    <message>
        <source>Send reset position</source>
        <translation>Enviar Reset Position</translation>
    </message>
    <message>
        <source>To 0</source>
        <translation>A 0</translation>
    </message>
    <message>
        <source>Relative to home</source>
        <translation>Relativo a la referencia</translation>
    </message>
    <message>
        <source>To a value</source>
        <translation>A un valor</translation>
    </message>
    <message>
        <source>The home register is subtracted from the position. Nothing moves.</source>
        <translation>El registro de referencia se resta de la posición. Nada se mueve.</translation>
    </message>
    <message>
        <source>The position becomes this value. Nothing moves.</source>
        <translation>La posición pasa a ser este valor. Nada se mueve.</translation>
    </message>
</context>
<context>
    <name>nmc::FirstSteps</name>
    <message>
        <source>Show me</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>Show me: the next step</source>
        <translation>Mostrar: el siguiente paso</translation>
    </message>
    <message>
        <source>Shows the control for the next step. Sends nothing.</source>
        <translation>Muestra el control del siguiente paso. No envía nada.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Paso %1 de %2: %3</translation>
    </message>
    <message>
        <source>Fill in gains</source>
        <translation>Rellenar ganancias</translation>
    </message>
    <message>
        <source>Apply gains</source>
        <translation>Aplicar ganancias</translation>
    </message>
    <message>
        <source>Enable servo</source>
        <translation>Habilitar servo</translation>
    </message>
    <message>
        <source>Take the starting values, or type your own. Nothing is sent yet.</source>
        <translation>Tome los valores iniciales o escriba los suyos. Aún no se envía nada.</translation>
    </message>
    <message>
        <source>Sends the gains to the module. The motor does not move.</source>
        <translation>Envía las ganancias al módulo. El motor no se mueve.</translation>
    </message>
    <message>
        <source>New wiring? Run the direction check on the Axis page first.</source>
        <translation>¿Cableado nuevo? Haga primero la prueba de sentido en la página Eje.</translation>
    </message>
    <message>
        <source>The motor moves while you hold the button. Esc stops it from anywhere.</source>
        <translation>El motor se mueve mientras mantiene pulsado el botón. Esc lo para desde cualquier lugar.</translation>
    </message>
</context>
<context>
    <name>nmc::FrequencyPage</name>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>The motor swings around its position, slowly at first, then faster. Make sure that everything it drives can move freely.</source>
        <translation>El motor oscila alrededor de su posición, primero despacio y después más rápido. Asegúrese de que todo lo que acciona puede moverse libremente.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitud</translation>
    </message>
    <message>
        <source>The amplitude</source>
        <translation>La amplitud</translation>
    </message>
    <message>
        <source>How far the command swings to either side. The motor is stopped if it swings four times as far.</source>
        <translation>Cuánto oscila la consigna a cada lado. El motor se detiene si oscila cuatro veces esa amplitud.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>The lowest frequency</source>
        <translation>La frecuencia más baja</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>The highest frequency</source>
        <translation>La frecuencia más alta</translation>
    </message>
    <message>
        <source>The test ends earlier if the baud rate is too low: at about 40 Hz at 115 200 Bd, and at about 8 Hz at 19 200 Bd.</source>
        <translation>La prueba termina antes si la velocidad en baudios es demasiado baja: a unos 40 Hz con 115200 Bd y a unos 8 Hz con 19200 Bd.</translation>
    </message>
    <message>
        <source>Results of the frequency response</source>
        <translation>Resultados de la respuesta en frecuencia</translation>
    </message>
    <message>
        <source>Export CSV of the frequency response</source>
        <translation>Exportar CSV de la respuesta en frecuencia</translation>
    </message>
    <message>
        <source>The baud rate is too low for higher frequencies.</source>
        <translation>La velocidad en baudios es demasiado baja para frecuencias más altas.</translation>
    </message>
    <message>
        <source>No measurement yet.</source>
        <translation>Aún no hay ninguna medición.</translation>
    </message>
    <message>
        <source>Saves frequency, magnitude and phase of the open and the closed loop.</source>
        <translation>Guarda frecuencia, magnitud y fase del lazo abierto y del cerrado.</translation>
    </message>
    <message>
        <source>Export the frequency response</source>
        <translation>Exportar la respuesta en frecuencia</translation>
    </message>
    <message>
        <source>Speed while measuring</source>
        <translation>Velocidad durante la medición</translation>
    </message>
    <message>
        <source>The speed while measuring</source>
        <translation>La velocidad durante la medición</translation>
    </message>
    <message>
        <source>0: at rest. Otherwise the sines ride on a motion to and fro, forward first, or backwards first if it is negative; the motor never reverses within a sine, so dry friction does not show. It moves away by up to this speed times five periods of the lowest frequency.</source>
        <translation>0: en reposo. Si no, las ondas senoidales se superponen a un movimiento de ida y vuelta, primero hacia delante, o primero hacia atrás si es negativa; el motor nunca invierte el sentido dentro de una onda, así que el rozamiento seco no se nota. Se aleja como máximo esta velocidad por cinco periodos de la frecuencia más baja.</translation>
    </message>
    <message>
        <source>What the gains in the fields would do</source>
        <translation>Lo que harían las ganancias de los campos</translation>
    </message>
    <message>
        <source>in motion</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>Fill in all gains to see what this loop would do with them.</source>
        <translation>Rellene todas las ganancias para ver qué haría este lazo con ellas.</translation>
    </message>
    <message>
        <source>with the gains in the fields</source>
        <translation>con las ganancias de los campos</translation>
    </message>
    <message>
        <source>The last measurement ended early. The one before it is still shown.</source>
        <translation>La última medición terminó antes de tiempo. Se sigue mostrando la anterior.</translation>
    </message>
</context>
<context>
    <name>nmc::GainsBox</name>
    <message>
        <source>&amp;Apply gains</source>
        <translation>Aplicar &amp;ganancias</translation>
    </message>
    <message>
        <source>Apply gains: all</source>
        <translation>Aplicar ganancias: todas</translation>
    </message>
    <message>
        <source>Revert the gains to those last sent</source>
        <translation>Revertir las ganancias a las últimas enviadas</translation>
    </message>
    <message>
        <source>Fills in values to start tuning with. Sends nothing.</source>
        <translation>Rellena valores con los que empezar el ajuste. No envía nada.</translation>
    </message>
    <message>
        <source>Gains cannot be read back from the module. They are unknown until you apply them.</source>
        <translation>Las ganancias no se pueden leer del módulo. Se desconocen hasta que las aplique.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The servo is on: they take effect immediately.</source>
        <translation>Envía todas las ganancias a la vez. El servo está encendido: actúan de inmediato.</translation>
    </message>
    <message>
        <source>Sends all gains at once. The motor does not move.</source>
        <translation>Envía todas las ganancias a la vez. El motor no se mueve.</translation>
    </message>
    <message>
        <source>&amp;Apply live</source>
        <translation>Aplicar ganancia&amp;s ya</translation>
    </message>
    <message>
        <source>Restores the gains last sent. Sends nothing.</source>
        <translation>Restaura las últimas ganancias enviadas. No envía nada.</translation>
    </message>
    <message>
        <source>Clears the fields: no gains have been sent yet. Sends nothing.</source>
        <translation>Vacía los campos: aún no se han enviado ganancias. No envía nada.</translation>
    </message>
    <message>
        <source>Sense of the current limit</source>
        <translation>Sentido del límite de corriente</translation>
    </message>
    <message>
        <source>Whether a high or a low A/D value means overcurrent. The chip distinguishes them by odd and even values.</source>
        <translation>Si la sobrecorriente corresponde a un valor A/D alto o bajo. El chip los distingue por números impares y pares.</translation>
    </message>
    <message>
        <source>Undo the last edit of a gain</source>
        <translation>Deshacer la última edición de una ganancia</translation>
    </message>
    <message>
        <source>Redo the last undone edit of a gain</source>
        <translation>Rehacer la edición de una ganancia</translation>
    </message>
    <message>
        <source>All zero</source>
        <translation>Todo a cero</translation>
    </message>
    <message>
        <source>All zero: fill in 0 for all gains</source>
        <translation>Todo a cero: poner 0 en todas las ganancias</translation>
    </message>
    <message>
        <source>Changing SR from %2 to %1 changes the servo tick, and with it the meaning of every velocity and acceleration in counts per tick.</source>
        <translation>Cambiar SR de %2 a %1 cambia el ciclo de servo y, con él, el significado de todas las velocidades y aceleraciones en cuentas por ciclo.</translation>
    </message>
    <message>
        <source>Gains while the servo is on</source>
        <translation>Ganancias con el servo encendido</translation>
    </message>
    <message>
        <source>The servo is on, and the gains in the module are unknown, so this may be a large change. The motor may jump or oscillate.</source>
        <translation>El servo está encendido, y no se conocen las ganancias del módulo: este puede ser un cambio grande. El motor puede saltar u oscilar.</translation>
    </message>
    <message>
        <source>The servo is on, and this is a large change: %1. The motor may jump or oscillate.</source>
        <translation>El servo está encendido, y este es un cambio grande: %1. El motor puede saltar u oscilar.</translation>
    </message>
    <message>
        <source>&amp;Apply these gains</source>
        <translation>&amp;Aplicar estas ganancias</translation>
    </message>
    <message>
        <source>Step response…</source>
        <translation>Respuesta al escalón…</translation>
    </message>
    <message>
        <source>Step response: open</source>
        <translation>Respuesta al escalón: abrir</translation>
    </message>
    <message>
        <source>Opens the step response, which shows how the motor follows a small step (F9).</source>
        <translation>Abre la respuesta al escalón, que muestra cómo sigue el motor un escalón pequeño (F9).</translation>
    </message>
    <message>
        <source>Fills the fields with 0, to start tuning. Sends nothing. Once applied, the motor no longer holds.</source>
        <translation>Pone los campos a 0 para empezar el ajuste. No envía nada. Una vez aplicados, el motor ya no mantiene la posición.</translation>
    </message>
    <message>
        <source>Try for %1 s</source>
        <translation>Probar %1 s</translation>
    </message>
    <message>
        <source>Try for %1 s: these gains</source>
        <translation>Probar %1 s: estas ganancias</translation>
    </message>
    <message>
        <source>Keep gains</source>
        <translation>Conservar ganancias</translation>
    </message>
    <message>
        <source>Keep gains: those being tried</source>
        <translation>Conservar ganancias: las que están en prueba</translation>
    </message>
    <message>
        <source>These gains are already being tried.</source>
        <translation>Estas ganancias ya se están probando.</translation>
    </message>
    <message>
        <source>The module already has these gains.</source>
        <translation>El módulo ya tiene estas ganancias.</translation>
    </message>
    <message>
        <source>Sends these gains and restores the previous ones after %1 s unless you keep them, or at once if the motor starts to oscillate.</source>
        <translation>Envía estas ganancias. Si no elige “Conservar”, a los %1 s se restauran las anteriores; si el motor empieza a oscilar, de inmediato.</translation>
    </message>
    <message>
        <source>No gains are being tried.</source>
        <translation>No se están probando ganancias.</translation>
    </message>
    <message>
        <source>Keeps the gains that are being tried.</source>
        <translation>Conserva las ganancias que se están probando.</translation>
    </message>
    <message>
        <source>Apply live: all gains</source>
        <translation>Aplicar ganancias ya: todas</translation>
    </message>
    <message>
        <source>no current limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>limits above (odd)</source>
        <translation>limita por encima (impar)</translation>
    </message>
    <message>
        <source>limits below (even)</source>
        <translation>limita por debajo (par)</translation>
    </message>
    <message>
        <source>Range: %1 to %2.</source>
        <translation>Rango: de %1 a %2.</translation>
    </message>
</context>
<context>
    <name>nmc::GenericPanel</name>
    <message>
        <source>Module without controls</source>
        <translation>Módulo sin controles</translation>
    </message>
    <message>
        <source>No status yet.</source>
        <translation>Aún sin estado.</translation>
    </message>
    <message>
        <source>Status byte %1</source>
        <translation>Byte de estado %1</translation>
    </message>
    <message>
        <source>, position %1</source>
        <translation>, posición %1</translation>
    </message>
    <message>
        <source>It does not answer. </source>
        <translation>No responde. </translation>
    </message>
    <message>
        <source>Request status</source>
        <translation>Consultar estado</translation>
    </message>
    <message>
        <source>Sends No Operation, which only requests the status.</source>
        <translation>Envía No Operation, que solo consulta el estado.</translation>
    </message>
    <message>
        <source>The panel does not support this type and version (supported: PIC-SERVO v1 to v5 and v10, PIC-STEP v1, PIC-I/O v1), so it only shows the module&apos;s status. STOP ALL might not stop its motor: use the hardware stop.</source>
        <translation>El panel no admite este tipo y versión (admite: PIC-SERVO v1 a v5 y v10, PIC-STEP v1, PIC-I/O v1), por lo que solo muestra el estado del módulo. Es posible que PARAR TODO no pare su motor: use la parada por hardware.</translation>
    </message>
</context>
<context>
    <name>nmc::GroupsPage</name>
    <message>
        <source>No modules yet: connect first.</source>
        <translation>Aún no hay módulos: conecte primero.</translation>
    </message>
    <message>
        <source>Group to command</source>
        <translation>Grupo destinatario</translation>
    </message>
    <message>
        <source>St&amp;art loaded moves</source>
        <translation>Inici&amp;ar movimientos cargados</translation>
    </message>
    <message>
        <source>Start loaded moves of this group</source>
        <translation>Iniciar movimientos cargados: este grupo</translation>
    </message>
    <message>
        <source>Save &amp;home</source>
        <translation>Guardar &amp;referencia</translation>
    </message>
    <message>
        <source>Save home: the present positions of this group</source>
        <translation>Guardar referencia: las posiciones actuales de este grupo</translation>
    </message>
    <message>
        <source>Group of module %1</source>
        <translation>Grupo del módulo %1</translation>
    </message>
    <message>
        <source>The group that this module listens to. Sent at once; nothing moves.</source>
        <translation>El grupo al que atiende este módulo. Se envía de inmediato; nada se mueve.</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>líder</translation>
    </message>
    <message>
        <source>Leader of its group: module %1</source>
        <translation>Líder de su grupo: módulo %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Choose a group first.</source>
        <translation>Elija primero un grupo.</translation>
    </message>
    <message>
        <source>This module answers for its group. A group has at most one leader.</source>
        <translation>Este módulo responde por su grupo. Un grupo tiene como máximo un líder.</translation>
    </message>
    <message>
        <source>move loaded</source>
        <translation>movimiento cargado</translation>
    </message>
    <message>
        <source>No groups yet. Add modules to a group first.</source>
        <translation>Aún no hay grupos. Añada primero módulos a un grupo.</translation>
    </message>
    <message>
        <source>Starts the loaded moves of all members in the same tick. Available once every member has confirmed its load.</source>
        <translation>Inicia los movimientos cargados de todos los miembros en el mismo ciclo. Disponible cuando todos los miembros han confirmado su carga.</translation>
    </message>
    <message>
        <source>Saves the present position of each member as home, in the same tick. Nothing moves.</source>
        <translation>Guarda la posición actual de cada miembro como referencia, en el mismo ciclo. Nada se mueve.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Nombre del grupo</translation>
    </message>
    <message>
        <source>The name of this group. Saved with the machine; nothing is sent.</source>
        <translation>El nombre de este grupo. Se guarda con la máquina; no se envía nada.</translation>
    </message>
    <message>
        <source>A module listens to one group besides its own address. All members carry out a group command in the same tick; the leader, if any, answers for them, and the panel then checks each member. Status requests go to single modules.</source>
        <translation>Un módulo atiende a un grupo además de a su propia dirección. Todos los miembros ejecutan un comando de grupo en el mismo ciclo; el líder, si lo hay, responde por ellos, y el panel comprueba después cada miembro. Las consultas de estado van a módulos individuales.</translation>
    </message>
    <message>
        <source>The group that the buttons act on.</source>
        <translation>El grupo al que los botones envían comandos.</translation>
    </message>
    <message>
        <source>Stop s&amp;moothly</source>
        <translation>Parar suave&amp;mente</translation>
    </message>
    <message>
        <source>Stop smoothly: this group</source>
        <translation>Parar suavemente este grupo</translation>
    </message>
    <message>
        <source>Stop at &amp;once</source>
        <translation>Parar de &amp;inmediato</translation>
    </message>
    <message>
        <source>Stop at once: this group</source>
        <translation>Parar de inmediato este grupo</translation>
    </message>
    <message>
        <source>Motors o&amp;ff</source>
        <translation>Apa&amp;gar motores</translation>
    </message>
    <message>
        <source>Motors off in this group</source>
        <translation>Apagar motores de este grupo</translation>
    </message>
    <message>
        <source>C&amp;lear sticky bits</source>
        <translation>Borrar bit&amp;s enclavados</translation>
    </message>
    <message>
        <source>Clear sticky bits of this group</source>
        <translation>Borrar bits enclavados: este grupo</translation>
    </message>
    <message>
        <source>Set &amp;position to 0…</source>
        <translation>&amp;Poner posición a 0…</translation>
    </message>
    <message>
        <source>Set position to 0 for this group</source>
        <translation>Poner posición a 0 en este grupo</translation>
    </message>
    <message>
        <source>Address of module %1</source>
        <translation>Dirección del módulo %1</translation>
    </message>
    <message>
        <source>The address of this module, 1 to 127. Press Enter to send it. Position, gains and group are kept.</source>
        <translation>La dirección de este módulo, de 1 a 127. Pulse Intro para enviarla. La posición, las ganancias y el grupo se conservan.</translation>
    </message>
    <message>
        <source>Makes the present position of each member 0. Asks first.</source>
        <translation>Convierte en 0 la posición actual de cada miembro. Pregunta antes.</translation>
    </message>
    <message>
        <source>Clears the sticky fault bits of each member. PIC-SERVO only.</source>
        <translation>Borra los bits de fallo enclavados de cada miembro. Solo PIC-SERVO.</translation>
    </message>
    <message>
        <source>Every member that is on slows down and holds. Repeated until all are seen at rest.</source>
        <translation>Cada miembro encendido frena y mantiene la posición. Se repite hasta verlos todos parados.</translation>
    </message>
    <message>
        <source>Every member that is on stops at once and holds. Repeated until all are seen at rest.</source>
        <translation>Cada miembro encendido se detiene de inmediato y mantiene la posición. Se repite hasta verlos todos parados.</translation>
    </message>
    <message>
        <source>Switches every member off: motors coast, and loads may fall. Repeated until all are seen at rest.</source>
        <translation>Apaga todos los miembros: los motores giran por inercia y las cargas pueden caer. Se repite hasta verlos todos parados.</translation>
    </message>
    <message>
        <source>The present position of each motor of %1 becomes 0: module %2. Home, limits and taught points then refer to different positions.</source>
        <translation>La posición actual de cada motor de %1 pasa a ser 0: módulo %2. La referencia, los límites y los puntos memorizados indicarán entonces otros lugares.</translation>
    </message>
    <message>
        <source>Set positions to 0</source>
        <translation>Poner posiciones a 0</translation>
    </message>
    <message>
        <source>&amp;Set positions to 0</source>
        <translation>&amp;Poner posiciones a 0</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Choose a group first, or none.</source>
        <translation>Su grupo se desconoce y cambiaría con la dirección. Elija primero un grupo, o ninguno.</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change addresses.</source>
        <translation>Un motor está en movimiento. Pare todos los motores para cambiar direcciones.</translation>
    </message>
    <message>
        <source>Address %1 is used by %2. Nothing was sent.</source>
        <translation>La dirección %1 la usa %2. No se envió nada.</translation>
    </message>
    <message>
        <source>outputs stored</source>
        <translation>salidas almacenadas</translation>
    </message>
    <message>
        <source>Store its outputs first.</source>
        <translation>Almacene primero sus salidas.</translation>
    </message>
    <message>
        <source>The address</source>
        <translation>La dirección</translation>
    </message>
    <message>
        <source>address</source>
        <translation>dirección</translation>
    </message>
</context>
<context>
    <name>nmc::HoldFirstButton</name>
    <message>
        <source>Hold here first</source>
        <translation>Mantener aquí</translation>
    </message>
    <message>
        <source>Holds the motor at its present position (Stop here).</source>
        <translation>Mantiene el motor en su posición actual (Parar aquí).</translation>
    </message>
</context>
<context>
    <name>nmc::HomingBox</name>
    <message>
        <source>Home</source>
        <translation>Buscar referencia</translation>
    </message>
    <message>
        <source>Cancel search</source>
        <translation>Cancelar búsqueda</translation>
    </message>
    <message>
        <source>Home: search for it</source>
        <translation>Buscar referencia del módulo</translation>
    </message>
    <message>
        <source>Cancel search for home</source>
        <translation>Cancelar búsqueda de referencia</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Progreso de la búsqueda</translation>
    </message>
    <message>
        <source>Moves the motor to search for home, as set above.</source>
        <translation>Mueve el motor para buscar la referencia, según lo indicado arriba.</translation>
    </message>
    <message>
        <source>No search for home is running.</source>
        <translation>No hay ninguna búsqueda de referencia en curso.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly, without homing it.</source>
        <translation>Detiene el motor suavemente, sin referenciarlo.</translation>
    </message>
    <message>
        <source>Done: home was at %1.</source>
        <translation>Hecho: la referencia estaba en %1.</translation>
    </message>
    <message>
        <source>No search yet.</source>
        <translation>Aún sin búsqueda.</translation>
    </message>
</context>
<context>
    <name>nmc::HomingForm</name>
    <message>
        <source>Search for home</source>
        <translation>Buscar la referencia</translation>
    </message>
    <message>
        <source>Home is where this switch changes. If it is active at the start, the motor first backs off in the other direction.</source>
        <translation>La referencia está donde cambia este interruptor. Si está activo al empezar, el motor se retira primero en el otro sentido.</translation>
    </message>
    <message>
        <source>Limit 1 (forward)</source>
        <translation>Final 1 (adelante)</translation>
    </message>
    <message>
        <source>Limit 2 (reverse)</source>
        <translation>Final 2 (atrás)</translation>
    </message>
    <message>
        <source>Home is at</source>
        <translation>Referencia en</translation>
    </message>
    <message>
        <source>Home is at the encoder&apos;s index, which comes once per turn.</source>
        <translation>La referencia está en el índice del encoder, que aparece una vez por vuelta.</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the position error limit switches the servo off. Sticky bits are cleared first. The servo is switched on again only to continue to the index or to home.</source>
        <translation>La referencia está en un tope mecánico: el motor avanza contra él hasta que el límite de error de posición apaga el servo. Antes se borran los bits enclavados. El servo solo se vuelve a encender para continuar al índice o a la referencia.</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the current limit is reached. On its own, it takes effect only at full speed; combined with other conditions, from the start, so the starting current must stay below it. Sticky bits are cleared first.</source>
        <translation>La referencia está en un tope mecánico: el motor avanza contra él hasta alcanzar el límite de corriente. Sola, esta condición actúa únicamente a velocidad plena; con otras, desde el principio, por lo que la corriente de arranque debe quedar por debajo de él. Antes se borran los bits enclavados.</translation>
    </message>
    <message>
        <source>then at the index, going back</source>
        <translation>después en el índice, al volver</translation>
    </message>
    <message>
        <source>The conditions above find the approximate place; a second, slower search finds the index, which is more exact.</source>
        <translation>Las condiciones de arriba hallan el lugar aproximado; una segunda búsqueda, más lenta, halla el índice, que es más exacto.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Reverse: search direction</source>
        <translation>Atrás: sentido de búsqueda</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Forward: search direction</source>
        <translation>Adelante: sentido de búsqueda</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Maximum velocity for searching, backing off and going to home.</source>
        <translation>Velocidad máxima para buscar, retirarse e ir a la referencia.</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>Velocidad de índice</translation>
    </message>
    <message>
        <source>Velocity of the second search, for the index. Slower is more exact.</source>
        <translation>Velocidad de la segunda búsqueda, la del índice. Cuanto más lenta, más exacta.</translation>
    </message>
    <message>
        <source>Also used for smooth stops.</source>
        <translation>Se usa también en las paradas suaves.</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>Distancia de búsqueda</translation>
    </message>
    <message>
        <source>A search, or backing off, stops and fails after this distance.</source>
        <translation>Una búsqueda, o una retirada, se detiene y falla tras esta distancia.</translation>
    </message>
    <message>
        <source>Time limit of a search</source>
        <translation>Límite de tiempo de una búsqueda</translation>
    </message>
    <message>
        <source>A search stops and fails after this time.</source>
        <translation>Una búsqueda se detiene y falla tras este tiempo.</translation>
    </message>
    <message>
        <source>%1 of the search for home</source>
        <translation>%1 de la búsqueda de referencia</translation>
    </message>
    <message>
        <source>Abruptly: stop at home</source>
        <translation>Bruscamente: parar en la referencia</translation>
    </message>
    <message>
        <source>Smoothly: stop at home</source>
        <translation>Suavemente: parar en la referencia</translation>
    </message>
    <message>
        <source>Motor off at home</source>
        <translation>Apagar motor en la referencia</translation>
    </message>
    <message>
        <source>Stop there</source>
        <translation>Parar ahí</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>Ir a la referencia</translation>
    </message>
    <message>
        <source>The motor stops past home; this moves it back. If the search has switched the servo or amplifier off, it is switched on again.</source>
        <translation>El motor se detiene pasada la referencia; esto lo hace volver a ella. Si la búsqueda apagó el servo o el amplificador, se vuelve a encender.</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>Poner posición a 0</translation>
    </message>
    <message>
        <source>The first search already finds the index.</source>
        <translation>La primera búsqueda ya encuentra el índice.</translation>
    </message>
    <message>
        <source>Needs Go to home, because the position at which the motor rests becomes 0.</source>
        <translation>Requiere “Ir a la referencia”: la posición en que está el motor pasa a ser 0.</translation>
    </message>
    <message>
        <source>The search direction, in which the switch closes.</source>
        <translation>El sentido de búsqueda, en el que se cierra el interruptor.</translation>
    </message>
    <message>
        <source>A position error switches the servo off.</source>
        <translation>Un error de posición apaga el servo.</translation>
    </message>
    <message>
        <source> This chip version does not stop the motor by itself: the panel stops it, a few hundredths of a second later.</source>
        <translation> Esta versión del chip no lo detiene por sí sola: lo detiene el panel, unas centésimas de segundo después.</translation>
    </message>
    <message>
        <source> The chip stops it by itself.</source>
        <translation> El chip lo detiene por sí solo.</translation>
    </message>
    <message>
        <source>At home the motor stops at once and holds.</source>
        <translation>En la referencia el motor se detiene de inmediato y mantiene la posición.</translation>
    </message>
    <message>
        <source>At home the motor slows down, stops past it and holds.</source>
        <translation>En la referencia el motor frena, se detiene pasada ella y mantiene la posición.</translation>
    </message>
    <message>
        <source>At home the motor is switched off and is free to turn.</source>
        <translation>En la referencia el motor se apaga y puede girar libremente.</translation>
    </message>
    <message>
        <source>Once the motor is at home, its position becomes 0.</source>
        <translation>Cuando el motor está en la referencia, su posición pasa a ser 0.</translation>
    </message>
    <message>
        <source>Limit 1 (reverse)</source>
        <translation>Final 1 (atrás)</translation>
    </message>
    <message>
        <source>Limit 2 (forward)</source>
        <translation>Final 2 (adelante)</translation>
    </message>
</context>
<context>
    <name>nmc::IoBox</name>
    <message>
        <source>Limits and I/O</source>
        <translation>Finales de carrera y E/S</translation>
    </message>
    <message>
        <source>The encoder&apos;s index pulse, once per turn with most encoders.</source>
        <translation>El pulso de índice del encoder, una vez por vuelta en la mayoría de los encoders.</translation>
    </message>
    <message>
        <source>Without motor power the servo switches off, and stays off when power returns.</source>
        <translation>Sin alimentación del motor el servo se apaga, y sigue apagado cuando vuelve la alimentación.</translation>
    </message>
    <message>
        <source>The A/D input; with most amplifiers, the motor current. Set its scale on the Axis page.</source>
        <translation>La entrada A/D; con la mayoría de los amplificadores, la corriente del motor. Ajuste su escala en la página Eje.</translation>
    </message>
    <message>
        <source>Amplifier enabled (&amp;AMP_EN)</source>
        <translation>Ampli&amp;ficador habilitado (AMP_EN)</translation>
    </message>
    <message>
        <source>On this chip, a limit switch alone does not stop the motor. Arm a limit stop on the Homing page.</source>
        <translation>En este chip, un final de carrera por sí solo no detiene el motor. Arme una parada por límite en la página Referenciado.</translation>
    </message>
    <message>
        <source>Limit &amp;1</source>
        <translation>Final &amp;1</translation>
    </message>
    <message>
        <source>Limit &amp;2</source>
        <translation>Final &amp;2</translation>
    </message>
    <message>
        <source>Limit %1: input or output</source>
        <translation>Final %1: entrada o salida</translation>
    </message>
    <message>
        <source>output, low</source>
        <translation>salida, bajo</translation>
    </message>
    <message>
        <source>output, high</source>
        <translation>salida, alto</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Nothing is sent until all are chosen.</source>
        <translation>Otro programa configuró este módulo, por lo que se desconoce el sentido de sus pines. No se envía nada hasta que se elijan todos.</translation>
    </message>
    <message>
        <source>Makes the pin an input, or an output with this level. Sent at once.</source>
        <translation>Hace del pin una entrada, o una salida con este nivel. Se envía de inmediato.</translation>
    </message>
    <message>
        <source>at the index</source>
        <translation>en el índice</translation>
    </message>
    <message>
        <source>not at the index</source>
        <translation>fuera del índice</translation>
    </message>
    <message>
        <source>present</source>
        <translation>presente</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>Switches only the amplifier&apos;s enable line; the servo stays as it is. When off, the motor gets no current, whatever the servo does.</source>
        <translation>Conmuta solo la línea de habilitación del amplificador; el servo queda como está. Si está desactivada, el motor no recibe corriente, haga lo que haga el servo.</translation>
    </message>
    <message>
        <source>The Amplifier page sets what the module does when a limit closes.</source>
        <translation>En la página Amplificador se configura qué hace el módulo cuando se cierra un final de carrera.</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz. Sent at once.</source>
        <translation>Puntos de trayectoria a 60 y 120 Hz en lugar de 30 y 60 Hz. Se envía de inmediato.</translation>
    </message>
</context>
<context>
    <name>nmc::IoHead</name>
    <message>
        <source>Name of this module</source>
        <translation>Nombre de este módulo</translation>
    </message>
    <message>
        <source>Last answer: %1.</source>
        <translation>Última respuesta: %1.</translation>
    </message>
</context>
<context>
    <name>nmc::IoPanel</name>
    <message>
        <source>I/O module</source>
        <translation>Módulo de E/S</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Contador</translation>
    </message>
</context>
<context>
    <name>nmc::IoValuesBox</name>
    <message>
        <source>Reads</source>
        <translation>Lectura</translation>
    </message>
    <message>
        <source>Per count</source>
        <translation>Por unidad</translation>
    </message>
    <message>
        <source>At 0</source>
        <translation>En 0</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>Valor de %1</translation>
    </message>
    <message>
        <source>%1 per count</source>
        <translation>%1, por unidad</translation>
    </message>
    <message>
        <source>The value of one A/D count.</source>
        <translation>El valor de una unidad A/D.</translation>
    </message>
    <message>
        <source>The unit of the value.</source>
        <translation>La unidad del valor.</translation>
    </message>
    <message>
        <source>%1 at 0</source>
        <translation>%1 en 0</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unidad de %1</translation>
    </message>
    <message>
        <source>PWM output</source>
        <translation>Salida PWM</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>0 to 255</source>
        <translation>0 a 255</translation>
    </message>
    <message>
        <source>Last value sent to %1</source>
        <translation>Último valor enviado a %1</translation>
    </message>
    <message>
        <source>255 is always on. Press Enter to send.</source>
        <translation>255: siempre activada. Pulse Intro para enviar.</translation>
    </message>
    <message>
        <source>Switch %1 off on STOP ALL</source>
        <translation>Desactivar %1 con PARAR TODO</translation>
    </message>
    <message>
        <source>STOP ALL switches this output off. If cleared, the output stays as it is.</source>
        <translation>PARAR TODO desactiva esta salida. Si está desmarcado, la salida queda como está.</translation>
    </message>
    <message>
        <source>The PWM values are unknown. Enter one for each output: both are sent together.</source>
        <translation>Los valores PWM son desconocidos. Introduzca uno para cada salida: ambos se envían juntos.</translation>
    </message>
</context>
<context>
    <name>nmc::JogBox</name>
    <message>
        <source>Jog speed</source>
        <translation>Velocidad de jog</translation>
    </message>
    <message>
        <source>Hold to move in reverse</source>
        <translation>Jog: mantener pulsado para mover hacia atrás</translation>
    </message>
    <message>
        <source>Hold to move forward</source>
        <translation>Jog: mantener pulsado para mover hacia adelante</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it. Returns to a low value at each connection; set the max jog speed on the Axis page.</source>
        <translation>A qué velocidad gira el motor mientras mantiene pulsado un botón, o Espacio sobre él. Vuelve a un valor bajo en cada conexión; la velocidad de jog máxima se ajusta en la página Eje.</translation>
    </message>
    <message>
        <source>J&amp;og speed</source>
        <translation>Velocidad de &amp;jog</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it: %1 to %2. Set the max jog speed on the Parameters page.</source>
        <translation>A qué velocidad gira el motor mientras mantiene pulsado un botón, o Espacio sobre él: de %1 a %2. La velocidad de jog máxima se ajusta en la página Parámetros.</translation>
    </message>
</context>
<context>
    <name>nmc::Layouts</name>
    <message>
        <source>&amp;Operate</source>
        <translation>&amp;Operar</translation>
    </message>
    <message>
        <source>Motion in the middle, everything else around it.</source>
        <translation>El movimiento en el centro, todo lo demás alrededor.</translation>
    </message>
    <message>
        <source>&amp;Tune</source>
        <translation>Ajus&amp;tar</translation>
    </message>
    <message>
        <source>Large plots, with gains and step response beside them.</source>
        <translation>Gráficas grandes, con las ganancias y la respuesta al escalón al lado.</translation>
    </message>
    <message>
        <source>&amp;Chain</source>
        <translation>&amp;Cadena</translation>
    </message>
    <message>
        <source>Modules, packets and messages.</source>
        <translation>Módulos, paquetes y mensajes.</translation>
    </message>
</context>
<context>
    <name>nmc::LendDialog</name>
    <message>
        <source>Path of the terminal</source>
        <translation>Ruta del terminal</translation>
    </message>
    <message>
        <source>&amp;Lend the line</source>
        <translation>&amp;Prestar la línea</translation>
    </message>
    <message>
        <source>Lend the line to a program</source>
        <translation>Prestar la línea a un programa</translation>
    </message>
    <message>
        <source>The program opens this path in place of the serial port, and has the modules for itself. The panel shows and records what they report, and sends nothing: your travel limits, stops at limits and other checks do not protect the motors. STOP ALL works, and holds the program off.</source>
        <translation>El programa abre esta ruta en lugar del puerto serie, y tiene los módulos para sí. El panel muestra y registra lo que comunican, y no envía nada: los límites de recorrido, las paradas en los límites y otras comprobaciones no protegen los motores. PARAR TODO actúa, y retiene el programa.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;Path of the terminal</source>
        <translation>&amp;Ruta del terminal</translation>
    </message>
    <message>
        <source>A motor is moving. Stop it first.</source>
        <translation>Un motor se está moviendo. Párelo primero.</translation>
    </message>
    <message>
        <source>Enter a path.</source>
        <translation>Introduzca una ruta.</translation>
    </message>
    <message>
        <source>Creates the terminal. Nothing moves.</source>
        <translation>Crea el terminal. Nada se mueve.</translation>
    </message>
</context>
<context>
    <name>nmc::LimitStopBox</name>
    <message>
        <source>Arm limit stop</source>
        <translation>Armar parada</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Desarmar</translation>
    </message>
    <message>
        <source>Limit 1: stop there</source>
        <translation>Final 1: parar ahí</translation>
    </message>
    <message>
        <source>Limit 2: stop there</source>
        <translation>Final 2: parar ahí</translation>
    </message>
    <message>
        <source>Disarm limit stop</source>
        <translation>Desarmar la parada por límite</translation>
    </message>
    <message>
        <source>State of the limit stop</source>
        <translation>Estado de la parada por límite</translation>
    </message>
    <message>
        <source>Abruptly: stop at the limit</source>
        <translation>Bruscamente: parar en el límite</translation>
    </message>
    <message>
        <source>Smoothly: stop at the limit</source>
        <translation>Suavemente: parar en el límite</translation>
    </message>
    <message>
        <source>Motor off at the limit</source>
        <translation>Apagar motor en el límite</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Parar en</translation>
    </message>
    <message>
        <source>Select a limit switch first.</source>
        <translation>Seleccione primero un final de carrera.</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 1 changes.</source>
        <translation>El motor se detiene cuando cambia el final de carrera 1.</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 2 changes.</source>
        <translation>El motor se detiene cuando cambia el final de carrera 2.</translation>
    </message>
    <message>
        <source>At the limit the motor stops at once and holds.</source>
        <translation>En el límite el motor se detiene de inmediato y mantiene la posición.</translation>
    </message>
    <message>
        <source>At the limit the motor slows down, stops past it and holds.</source>
        <translation>En el límite el motor frena, se detiene pasado él y mantiene la posición.</translation>
    </message>
    <message>
        <source>At the limit the motor is switched off and is free to turn.</source>
        <translation>En el límite el motor se apaga y puede girar libremente.</translation>
    </message>
    <message>
        <source>The chip itself then stops the motor once when a selected limit switch changes, faster than the panel could. A search for home replaces it.</source>
        <translation>El propio chip detiene entonces el motor, una sola vez, cuando cambia un final de carrera seleccionado, y más rápido de lo que podría el panel. Una búsqueda de referencia la sustituye.</translation>
    </message>
    <message>
        <source>The limit stop is not armed.</source>
        <translation>La parada por límite no está armada.</translation>
    </message>
    <message>
        <source>A limit switch no longer stops the motor.</source>
        <translation>Un final de carrera ya no detiene el motor.</translation>
    </message>
    <message>
        <source>○ Not armed: a limit switch alone does not stop the motor.</source>
        <translation>○ Sin armar: un final de carrera por sí solo no detiene el motor.</translation>
    </message>
    <message>
        <source>○ This chip version cannot stop at a limit switch.</source>
        <translation>○ Esta versión del chip no puede detenerse en un final de carrera.</translation>
    </message>
    <message>
        <source>● Armed: stops at %1, once.</source>
        <translation>● Armada: se detiene en %1, una vez.</translation>
    </message>
    <message>
        <source>▲ Tripped by %1; the motor was stopped. No longer armed.</source>
        <translation>▲ Disparada por %1; el motor se paró. Ya no está armada.</translation>
    </message>
    <message>
        <source>? The chip watches for an event that this connection did not request.</source>
        <translation>? El chip vigila un evento que esta conexión no pidió.</translation>
    </message>
    <message>
        <source>the position error limit</source>
        <translation>el límite de error de posición</translation>
    </message>
    <message>
        <source>the current limit</source>
        <translation>el límite de corriente</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Corriente</translation>
    </message>
    <message>
        <source>for each motion of this axis</source>
        <translation>en cada movimiento de este eje</translation>
    </message>
    <message>
        <source>Position error stops the motor</source>
        <translation>Error de posición: detiene el motor</translation>
    </message>
    <message>
        <source>Current stops the motor</source>
        <translation>Corriente: detiene el motor</translation>
    </message>
    <message>
        <source>For each motion of this axis, arm the limit stop</source>
        <translation>En cada movimiento de este eje, armar la parada por límite</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armada</translation>
    </message>
    <message>
        <source>The motor stops when the position error exceeds EL; this always switches the servo off.</source>
        <translation>El motor se detiene cuando el error de posición supera EL; esto siempre apaga el servo.</translation>
    </message>
    <message>
        <source>The motor stops when its current exceeds CL.</source>
        <translation>El motor se detiene cuando su corriente supera CL.</translation>
    </message>
    <message>
        <source>The panel arms the limit stop whenever the motor is at rest with its servo on, even after a trip, and before any motion starts. Saved with the machine.</source>
        <translation>El panel arma la parada por límite siempre que el motor está parado con el servo encendido, también tras un disparo, y antes de que empiece un movimiento. Se guarda con la máquina.</translation>
    </message>
    <message>
        <source>The limit stop is armed for each motion. Clear that check box first.</source>
        <translation>La parada por límite se arma en cada movimiento. Desmarque primero esa casilla.</translation>
    </message>
    <message>
        <source>A search for home or a measurement is running and uses the same function of the chip.</source>
        <translation>Hay una búsqueda de referencia o una medición en curso que usa la misma función del chip.</translation>
    </message>
    <message>
        <source>○ Not armed: the search for home or the measurement has replaced it.</source>
        <translation>○ Sin armar: la búsqueda de referencia o la medición la ha sustituido.</translation>
    </message>
</context>
<context>
    <name>nmc::LinkBar</name>
    <message>
        <source>State of the link</source>
        <translation>Estado del enlace</translation>
    </message>
    <message>
        <source>Exchanges per second, and their share of the line&apos;s capacity.</source>
        <translation>Intercambios por segundo y su parte de la capacidad de la línea.</translation>
    </message>
    <message>
        <source>Failed exchanges: no answer, garbled, or refused for a bad checksum.</source>
        <translation>Intercambios fallidos: sin respuesta, corruptos o rechazados por una suma de comprobación errónea.</translation>
    </message>
    <message>
        <source>Mean time from sending a command to its complete answer.</source>
        <translation>Tiempo medio desde el envío de un comando hasta su respuesta completa.</translation>
    </message>
    <message>
        <source>– exchanges/s</source>
        <translation>– intercambios/s</translation>
    </message>
    <message>
        <source>– errors</source>
        <translation>– errores</translation>
    </message>
    <message>
        <source>round trip –</source>
        <translation>respuesta en –</translation>
    </message>
    <message>
        <source>%1 exchanges/s, %2 % bus load</source>
        <translation>%1 intercambios/s, %2 % de la línea</translation>
    </message>
    <message numerus="yes">
        <source>%1 errors, %2/s</source>
        <translation>
            <numerusform>%1 error, %2/s</numerusform>
            <numerusform>%1 errores, %2/s</numerusform>
        </translation>
    </message>
    <message>
        <source>round trip %1 ms</source>
        <translation>respuesta en %1 ms</translation>
    </message>
</context>
<context>
    <name>nmc::LoopTestsDock</name>
    <message>
        <source>Square wave, frequency response (Bode plot), and a report of the tuning</source>
        <translation>Onda cuadrada, respuesta en frecuencia (diagrama de Bode) e informe del ajuste</translation>
    </message>
    <message>
        <source>Loop tests</source>
        <translation>Pruebas de lazo</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Report: save the tuning</source>
        <translation>Informe: guardar el ajuste</translation>
    </message>
    <message>
        <source>Select a PIC-SERVO first.</source>
        <translation>Seleccione primero un PIC-SERVO.</translation>
    </message>
    <message>
        <source>Saves one page as PDF or HTML: gains, last step response, motor model and frequency response.</source>
        <translation>Guarda una página en PDF o HTML: ganancias, última respuesta al escalón, modelo del motor y respuesta en frecuencia.</translation>
    </message>
</context>
<context>
    <name>nmc::MachineMenu</name>
    <message>
        <source>&amp;New machine</source>
        <translation>&amp;Nueva máquina</translation>
    </message>
    <message>
        <source>Discards names, units and settings of all axes; nothing is sent.</source>
        <translation>Descarta nombres, unidades y ajustes de todos los ejes; no se envía nada.</translation>
    </message>
    <message>
        <source>&amp;Open machine…</source>
        <translation>A&amp;brir máquina…</translation>
    </message>
    <message>
        <source>Shows what a machine file would change. Nothing is sent until you apply it.</source>
        <translation>Muestra qué cambiaría un archivo de máquina. No se envía nada hasta que lo aplique.</translation>
    </message>
    <message>
        <source>&amp;Save machine</source>
        <translation>&amp;Guardar máquina</translation>
    </message>
    <message>
        <source>Saves names, units, gains, limits, homing and groups to the machine file.</source>
        <translation>Guarda nombres, unidades, ganancias, límites, referenciado y grupos en el archivo de máquina.</translation>
    </message>
    <message>
        <source>Save machine &amp;as…</source>
        <translation>Gu&amp;ardar máquina como…</translation>
    </message>
    <message>
        <source>Saves the machine under another file name.</source>
        <translation>Guarda la máquina con otro nombre de archivo.</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>Abrir re&amp;ciente</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Abrir reciente</translation>
    </message>
    <message>
        <source>new machine</source>
        <translation>máquina nueva</translation>
    </message>
    <message>
        <source>Machine files (*.%1)</source>
        <translation>Archivos de máquina (*.%1)</translation>
    </message>
    <message>
        <source>Save machine</source>
        <translation>Guardar máquina</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>máquina</translation>
    </message>
    <message>
        <source>&amp;Save and close</source>
        <translation>&amp;Guardar y cerrar</translation>
    </message>
    <message>
        <source>&amp;Close: the changes can be restored at the next start</source>
        <translation>&amp;Cerrar: podrá restaurarlos al iniciar</translation>
    </message>
    <message>
        <source>&amp;Save changes</source>
        <translation>&amp;Guardar cambios</translation>
    </message>
    <message>
        <source>&amp;Discard: the changes are lost</source>
        <translation>&amp;Descartar: los cambios se pierden</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Ca&amp;ncelar</translation>
    </message>
    <message>
        <source>%1 (being saved)</source>
        <translation>%1 (guardando)</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Guardando</translation>
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
        <translation>Menús</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>Módulos</translation>
    </message>
    <message>
        <source>NMC Panel - Simulator</source>
        <translation>NMC Panel - Simulador</translation>
    </message>
    <message>
        <source>NMC Panel - %1</source>
        <translation>NMC Panel - %1</translation>
    </message>
    <message>
        <source>&amp;Stop and disconnect</source>
        <translation>&amp;Parar y desconectar</translation>
    </message>
    <message>
        <source>&amp;Stop and close</source>
        <translation>&amp;Parar y cerrar</translation>
    </message>
    <message>
        <source>Motors are moving</source>
        <translation>Motores en movimiento</translation>
    </message>
    <message>
        <source>Restart the network</source>
        <translation>Reiniciar la red</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost</source>
        <translation>&amp;Reiniciar la red: se pierden posiciones y ganancias</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (solo lectura)</translation>
    </message>
    <message>
        <source>No module can be moved. Connect a motor module first.</source>
        <translation>No se puede mover ningún módulo. Conecte primero un módulo de motor.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Escalón</translation>
    </message>
    <message>
        <source>Let the program &quot;%1&quot; move motors? Esc, STOP ALL or any command of yours ends that.</source>
        <translation>¿Dejar que el programa «%1» mueva motores? Esc, PARAR TODO o cualquier comando suyo lo termina.</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Rechazar</translation>
    </message>
    <message>
        <source>Let it move motors</source>
        <translation>Dejar mover motores</translation>
    </message>
</context>
<context>
    <name>nmc::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>NMC Panel - Manual</source>
        <translation>NMC Panel - Manual</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Páginas del manual</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Página del manual</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Goes back to the previous page (%1).</source>
        <translation>Vuelve a la página anterior (%1).</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Goes forward again (%1).</source>
        <translation>Avanza de nuevo (%1).</translation>
    </message>
    <message>
        <source>Search this page</source>
        <translation>Buscar en esta página</translation>
    </message>
    <message>
        <source>Enter finds the next match, Shift+Enter the previous one (Ctrl+F).</source>
        <translation>Intro busca la siguiente coincidencia; Mayús+Intro, la anterior (Ctrl+F).</translation>
    </message>
    <message>
        <source>The manual is not installed. It belongs in %1.</source>
        <translation>El manual no está instalado. Debe estar en %1.</translation>
    </message>
    <message>
        <source>Not found on this page</source>
        <translation>No se encuentra en esta página</translation>
    </message>
</context>
<context>
    <name>nmc::MessageList</name>
    <message>
        <source>No messages. Problems are listed here, with the time when they ended.</source>
        <translation>No hay mensajes. Aquí aparecen los problemas y cuándo terminan.</translation>
    </message>
    <message>
        <source>No message matches the filter above.</source>
        <translation>Ningún mensaje coincide con el filtro de arriba.</translation>
    </message>
</context>
<context>
    <name>nmc::MessagePanel</name>
    <message>
        <source>Messages and their filter</source>
        <translation>Mensajes y su filtro</translation>
    </message>
    <message>
        <source>Kind of messages shown</source>
        <translation>Tipo de mensajes mostrados</translation>
    </message>
    <message>
        <source>Filters the messages by kind.</source>
        <translation>Filtra los mensajes por tipo.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Module whose messages are shown</source>
        <translation>Módulo cuyos mensajes se muestran</translation>
    </message>
    <message>
        <source>Filters the messages by module.</source>
        <translation>Filtra los mensajes por módulo.</translation>
    </message>
    <message>
        <source>Active only</source>
        <translation>Activos</translation>
    </message>
    <message>
        <source>Shows only messages whose cause persists.</source>
        <translation>Muestra solo los mensajes cuya causa persiste.</translation>
    </message>
    <message>
        <source>Search messages</source>
        <translation>Buscar mensajes</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Shows only messages that contain these words.</source>
        <translation>Muestra solo los mensajes que contienen estas palabras.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>Export the messages shown</source>
        <translation>Exportar los mensajes mostrados</translation>
    </message>
    <message>
        <source>Saves the messages shown to a text file.</source>
        <translation>Guarda los mensajes mostrados en un archivo de texto.</translation>
    </message>
    <message>
        <source>Kept for this session only.</source>
        <translation>Se conservan solo en esta sesión.</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Se conservan en %1</translation>
    </message>
    <message>
        <source>Export messages</source>
        <translation>Exportar mensajes</translation>
    </message>
</context>
<context>
    <name>nmc::MessageRow</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n vez</numerusform>
            <numerusform>%n veces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::ModelBox</name>
    <message>
        <source>Motor model</source>
        <translation>Modelo del motor</translation>
    </message>
    <message>
        <source>Find motor model</source>
        <translation>Identificar modelo</translation>
    </message>
    <message>
        <source>Find motor model from the steps</source>
        <translation>Identificar modelo del motor a partir de los escalones</translation>
    </message>
    <message>
        <source>Motor model found</source>
        <translation>Modelo de motor hallado</translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Fill in the suggested gains</source>
        <translation>Rellenar con las ganancias sugeridas</translation>
    </message>
    <message>
        <source>Suggested gains</source>
        <translation>Ganancias sugeridas</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Rígido</translation>
    </message>
    <message>
        <source>How fast the motor follows. Far right: as fast as noise, output limit and stability permit.</source>
        <translation>Rapidez con que sigue el motor. A la derecha del todo: tan rápido como permiten el ruido, el límite de salida y la estabilidad.</translation>
    </message>
    <message>
        <source>Damped</source>
        <translation>Amortiguado</translation>
    </message>
    <message>
        <source>Damping. Far right: no overshoot.</source>
        <translation>Amortiguación. A la derecha del todo: sin sobreimpulso.</translation>
    </message>
    <message>
        <source>Loud</source>
        <translation>Ruidoso</translation>
    </message>
    <message>
        <source>How much encoder noise may drive the motor through Kd.</source>
        <translation>Cuánto ruido del encoder puede llegar al motor a través de Kd.</translation>
    </message>
    <message>
        <source>The motor model is being calculated.</source>
        <translation>Se está calculando el modelo del motor.</translation>
    </message>
    <message>
        <source>Record a step with this module first.</source>
        <translation>Grabe primero un escalón con este módulo.</translation>
    </message>
    <message>
        <source>Calculates the motor model from up to %1 recent steps of this module. Sends nothing.</source>
        <translation>Calcula el modelo del motor a partir de hasta %1 escalones recientes de este módulo. No envía nada.</translation>
    </message>
    <message>
        <source>No suggested gains. Find the motor model first.</source>
        <translation>No hay ganancias sugeridas. Identifique primero el modelo del motor.</translation>
    </message>
    <message>
        <source>Copies the suggested gains to the Gains page. Sends nothing.</source>
        <translation>Copia las ganancias sugeridas en la página Ganancias. No envía nada.</translation>
    </message>
    <message>
        <source>Calculating the motor model…</source>
        <translation>Calculando el modelo del motor…</translation>
    </message>
    <message>
        <source>The run behind this model was removed. Find the motor model again.</source>
        <translation>Se quitó el ensayo en que se basa este modelo. Identifique de nuevo el modelo del motor.</translation>
    </message>
    <message>
        <source>No gains keep this motor stable and quiet.</source>
        <translation>Ninguna ganancia mantiene este motor estable y silencioso.</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Margen de fase</translation>
    </message>
    <message>
        <source>The phase margin</source>
        <translation>El margen de fase</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the suggested loop is from oscillating, at least. 30°: fast, rings. 45° to 60°: moderate.</source>
        <translation>A qué distancia de la oscilación queda como mínimo el lazo propuesto. 30°: rápido, con rebotes. 45° a 60°: moderado.</translation>
    </message>
    <message>
        <source>° at least</source>
        <translation>° como mínimo</translation>
    </message>
    <message>
        <source>Step once more and find model</source>
        <translation>1 escalón más e identificar</translation>
    </message>
    <message>
        <source>Step %1 times and find model</source>
        <translation>%1 escalones e identificar</translation>
    </message>
    <message>
        <source>The motor jumps once more, as far as before; the model is then found from the recent steps. Make sure that everything it drives can move freely.</source>
        <translation>El motor salta una vez más, tan lejos como antes, y se identifica a partir de los últimos escalones. Asegúrese de que todo lo que acciona puede moverse libremente.</translation>
    </message>
    <message>
        <source>The motor jumps by the distance of the step and back, then twice as far and back, but no farther than %1 and %2 counts; the model is then found from these steps. Make sure that everything it drives can move freely.</source>
        <translation>El motor salta la distancia del escalón y vuelve, después el doble y vuelve, pero como máximo %1 y %2 cuentas, y se identifica a partir de estos escalones. Asegúrese de que todo lo que acciona puede moverse libremente.</translation>
    </message>
    <message>
        <source>Calculating the suggested gains…</source>
        <translation>Calculando las ganancias sugeridas…</translation>
    </message>
    <message>
        <source>The suggested gains are being calculated.</source>
        <translation>Se están calculando las ganancias sugeridas.</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleBench</name>
    <message>
        <source>Simulated module controls</source>
        <translation>Controles del módulo simulado</translation>
    </message>
    <message>
        <source>Pages of the simulated module</source>
        <translation>Páginas del módulo simulado</translation>
    </message>
    <message>
        <source>Switches</source>
        <translation>Interruptores</translation>
    </message>
    <message>
        <source>Closed while checked.</source>
        <translation>Cerrado mientras está marcado.</translation>
    </message>
    <message>
        <source>The motor&apos;s supply, not the module&apos;s.</source>
        <translation>La alimentación del motor, no la del módulo.</translation>
    </message>
    <message>
        <source>Limit switch 1, forward</source>
        <translation>Final de carrera 1, adelante</translation>
    </message>
    <message>
        <source>Limit switch 2, reverse</source>
        <translation>Final de carrera 2, atrás</translation>
    </message>
    <message>
        <source>Input 1</source>
        <translation>Entrada 1</translation>
    </message>
    <message>
        <source>Input 2</source>
        <translation>Entrada 2</translation>
    </message>
    <message>
        <source>The A/D reading of the temperature sensor.</source>
        <translation>La lectura A/D del sensor de temperatura.</translation>
    </message>
    <message>
        <source>Limit switch 1</source>
        <translation>Final de carrera 1</translation>
    </message>
    <message>
        <source>Limit switch 2</source>
        <translation>Final de carrera 2</translation>
    </message>
    <message>
        <source>Encoder index</source>
        <translation>Índice del encoder</translation>
    </message>
    <message>
        <source>Stays until the shaft moves.</source>
        <translation>Se mantiene hasta que se mueve el eje del motor.</translation>
    </message>
    <message>
        <source>Set the A/D input by hand</source>
        <translation>Fijar la entrada A/D a mano</translation>
    </message>
    <message>
        <source>If cleared, the A/D input reads the motor current.</source>
        <translation>Si está desmarcado, la entrada A/D lee la corriente del motor.</translation>
    </message>
    <message>
        <source>ADDR line broken towards the host</source>
        <translation>Línea ADDR cortada hacia el PC</translation>
    </message>
    <message>
        <source>The line is broken between this module and the next one towards the host, which then gets no address.</source>
        <translation>La línea está cortada entre este módulo y el siguiente hacia el PC, que entonces no recibe dirección.</translation>
    </message>
    <message>
        <source>Power-cycle</source>
        <translation>Apagar y encender</translation>
    </message>
    <message>
        <source>Switches this module off and on: it loses its address and gains.</source>
        <translation>Apaga y enciende este módulo: pierde su dirección y sus ganancias.</translation>
    </message>
    <message>
        <source>Power-cycle all</source>
        <translation>Apagar y encender todo</translation>
    </message>
    <message>
        <source>Switches all modules off and on: they lose their addresses and gains.</source>
        <translation>Apaga y enciende todos los módulos: pierden sus direcciones y ganancias.</translation>
    </message>
    <message>
        <source>Late tick</source>
        <translation>Ciclo tardío</translation>
    </message>
    <message>
        <source>Makes one servo tick take too long: servo_overrun.</source>
        <translation>Hace que un ciclo de servo dure demasiado: servo_overrun.</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mecánica</translation>
    </message>
    <message>
        <source>Load torque</source>
        <translation>Par de carga</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>External torque; positive values turn the shaft in reverse.</source>
        <translation>Par externo; los valores positivos giran el eje del motor hacia atrás.</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Inercia</translation>
    </message>
    <message>
        <source>10⁻⁶ kg·m²</source>
        <translation>10⁻⁶ kg·m²</translation>
    </message>
    <message>
        <source>Moment of inertia of rotor and load.</source>
        <translation>Momento de inercia del rotor y la carga.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Rozamiento</translation>
    </message>
    <message>
        <source>Dry friction; it also holds the shaft at rest.</source>
        <translation>Rozamiento seco; también retiene el eje del motor parado.</translation>
    </message>
    <message>
        <source>Stop, reverse</source>
        <translation>Tope, atrás</translation>
    </message>
    <message>
        <source>A hard stop at the reverse end of travel. It cannot be set past the present shaft position.</source>
        <translation>Un tope mecánico en el extremo trasero del recorrido. No se puede poner más allá de la posición actual del eje del motor.</translation>
    </message>
    <message>
        <source>Stop, forward</source>
        <translation>Tope, adelante</translation>
    </message>
    <message>
        <source>A hard stop at the forward end of travel. It cannot be set past the present shaft position.</source>
        <translation>Un tope mecánico en el extremo delantero del recorrido. No se puede poner más allá de la posición actual del eje del motor.</translation>
    </message>
    <message>
        <source>Limit switches at the stops</source>
        <translation>Finales de carrera en los topes</translation>
    </message>
    <message>
        <source>The limit switches close at the ends of travel and cannot be set by hand.</source>
        <translation>Los finales de carrera se cierran en los extremos del recorrido y no se pueden accionar a mano.</translation>
    </message>
    <message>
        <source>Home switch at</source>
        <translation>Int. de ref. en</translation>
    </message>
    <message>
        <source>Follows the motor&apos;s position: see Mechanics.</source>
        <translation>Sigue la posición del motor: vea Mecánica.</translation>
    </message>
    <message>
        <source>The home switch is closed forward of this position. If cleared, set it by hand.</source>
        <translation>El interruptor de referencia está cerrado de esta posición hacia adelante. Si está desmarcado, acciónelo a mano.</translation>
    </message>
    <message>
        <source>%1: level</source>
        <translation>%1: nivel</translation>
    </message>
    <message>
        <source>255 is 5 V.</source>
        <translation>255 equivale a 5 V.</translation>
    </message>
    <message>
        <source>PWM 1 and 2</source>
        <translation>PWM 1 y 2</translation>
    </message>
    <message>
        <source>The module&apos;s PWM outputs, 0 to 255.</source>
        <translation>Lo que emite el módulo, de 255.</translation>
    </message>
    <message>
        <source>Timer or counter</source>
        <translation>Temporizador o contador</translation>
    </message>
    <message>
        <source>The module&apos;s own count.</source>
        <translation>Tal como cuenta el módulo.</translation>
    </message>
    <message>
        <source>An output: the module sets its level.</source>
        <translation>Una salida: el módulo fija su nivel.</translation>
    </message>
    <message>
        <source>High while checked.</source>
        <translation>Nivel alto mientras está marcado.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>off, %1</source>
        <translation>inactivo, %1</translation>
    </message>
    <message>
        <source>timer, %1</source>
        <translation>temporizador, %1</translation>
    </message>
    <message>
        <source>counter, %1</source>
        <translation>contador, %1</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleContext</name>
    <message>
        <source>Waiting for the module&apos;s answer.</source>
        <translation>Esperando la respuesta del módulo.</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePage</name>
    <message>
        <source>Motions of the selected module</source>
        <translation>Movimientos del módulo seleccionado</translation>
    </message>
    <message>
        <source>The pages of this module.</source>
        <translation>Las páginas de este módulo.</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePanel</name>
    <message>
        <source>Selected module</source>
        <translation>Módulo seleccionado</translation>
    </message>
</context>
<context>
    <name>nmc::MotionBox</name>
    <message>
        <source>Ve&amp;locity</source>
        <translation>Ve&amp;locidad</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>Velocidad del movimiento</translation>
    </message>
    <message>
        <source>Acceleratio&amp;n</source>
        <translation>Acelerac&amp;ión</translation>
    </message>
    <message>
        <source>Velocity of running</source>
        <translation>Velocidad de la marcha</translation>
    </message>
    <message>
        <source>Used by every motion here, and by a smooth stop.</source>
        <translation>Se usa en todos los movimientos de aquí y en la parada suave.</translation>
    </message>
    <message>
        <source>How fast the motor turns.</source>
        <translation>A qué velocidad gira el motor.</translation>
    </message>
    <message>
        <source>Position or distance</source>
        <translation>Posición o distancia</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>Whether the number is a position, or a distance from the present position.</source>
        <translation>Si el número es una posición o una distancia desde la posición actual.</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>Cero a&amp;quí</translation>
    </message>
    <message>
        <source>Load the move, start it later</source>
        <translation>Cargar el movimiento, iniciarlo después</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Start the loaded move</source>
        <translation>Iniciar el movimiento cargado</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Takes %1, peak %2: too short to reach its velocity</source>
        <translation>Tarda %1, máximo %2: demasiado corto para alcanzar su velocidad</translation>
    </message>
    <message>
        <source>Takes %1, peak %2</source>
        <translation>Tarda %1, máximo %2</translation>
    </message>
    <message>
        <source>Peak %1</source>
        <translation>Máximo %1</translation>
    </message>
    <message>
        <source>Peak %1: too short to reach its velocity</source>
        <translation>Máximo %1: demasiado corto para alcanzar su velocidad</translation>
    </message>
    <message>
        <source>Already there</source>
        <translation>Ya está ahí</translation>
    </message>
    <message>
        <source>The goal is outside the position range.</source>
        <translation>El destino está fuera del rango de posiciones.</translation>
    </message>
    <message>
        <source>The goal of a trapezoidal move from standstill. Press Enter to start.</source>
        <translation>El destino de un movimiento trapezoidal con el motor parado al inicio. Pulse Intro para iniciarlo.</translation>
    </message>
    <message>
        <source>Go to &amp;position</source>
        <translation>Ir a p&amp;osición</translation>
    </message>
    <message>
        <source>Run at velocit&amp;y</source>
        <translation>Velocidad de marc&amp;ha</translation>
    </message>
    <message>
        <source>The velocity of a run. Press Enter to run, or to change the velocity during a run.</source>
        <translation>La velocidad de una marcha. Pulse Intro para iniciarla, o para cambiar la velocidad durante una marcha.</translation>
    </message>
    <message>
        <source>Loads the move without starting it. Choose Start, or start the module&apos;s group.</source>
        <translation>Carga el movimiento sin iniciarlo. Elija Iniciar o inicie el grupo del módulo.</translation>
    </message>
    <message>
        <source>Starts the loaded move.</source>
        <translation>Inicia el movimiento cargado.</translation>
    </message>
    <message>
        <source>Moves to home.</source>
        <translation>Va a la referencia.</translation>
    </message>
    <message>
        <source>Runs forward until stopped, or to its highest position.</source>
        <translation>Gira hacia adelante hasta que se le ordene parar o hasta su posición máxima.</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped, or to its lowest position.</source>
        <translation>Gira hacia atrás hasta que se le ordene parar o hasta su posición mínima.</translation>
    </message>
</context>
<context>
    <name>nmc::MoveByBox</name>
    <message>
        <source>Step by a distance</source>
        <translation>Mover por pasos de una distancia</translation>
    </message>
    <message>
        <source>Step by</source>
        <translation>Por pasos</translation>
    </message>
    <message>
        <source>Distance of a step</source>
        <translation>Distancia de un paso</translation>
    </message>
    <message>
        <source>The distance of a step</source>
        <translation>La distancia de un paso</translation>
    </message>
    <message>
        <source>Step in reverse</source>
        <translation>Paso hacia atrás</translation>
    </message>
    <message>
        <source>Step forward</source>
        <translation>Paso hacia adelante</translation>
    </message>
    <message>
        <source>The number of steps</source>
        <translation>El número de pasos</translation>
    </message>
    <message>
        <source>Number of steps per click.</source>
        <translation>Número de pasos por clic.</translation>
    </message>
    <message>
        <source>The pause between steps</source>
        <translation>La pausa entre pasos</translation>
    </message>
    <message>
        <source>Time to wait after each move, in seconds.</source>
        <translation>Tiempo de espera tras cada movimiento, en segundos.</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>ida y vuelta</translation>
    </message>
    <message>
        <source>There and back with each step</source>
        <translation>Ida y vuelta en cada paso</translation>
    </message>
    <message>
        <source>Each step goes there and back.</source>
        <translation>Cada paso va y vuelve.</translation>
    </message>
    <message>
        <source>End steps</source>
        <translation>Terminar pasos</translation>
    </message>
    <message>
        <source>End steps and stop</source>
        <translation>Terminar pasos y parar</translation>
    </message>
    <message>
        <source>times, pause</source>
        <translation>veces, pausa</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>A series of steps is already running.</source>
        <translation>Ya hay una serie de pasos en curso.</translation>
    </message>
    <message>
        <source>Moves forward by this distance, then holds.</source>
        <translation>Se mueve hacia adelante esta distancia y después mantiene la posición.</translation>
    </message>
    <message>
        <source>Moves in reverse by this distance, then holds.</source>
        <translation>Se mueve hacia atrás esta distancia y después mantiene la posición.</translation>
    </message>
    <message>
        <source>No series of steps is running.</source>
        <translation>No hay ninguna serie de pasos en curso.</translation>
    </message>
    <message>
        <source>Ends the series of steps and stops the motor smoothly.</source>
        <translation>Termina la serie de pasos y detiene el motor suavemente.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Distance per click, at the velocity of Go to.</source>
        <translation>Distancia por clic, a la velocidad de “Ir a posición”.</translation>
    </message>
</context>
<context>
    <name>nmc::NumberField</name>
    <message>
        <source>%1 must be %2 to %3%4.</source>
        <translation>%1 debe estar entre %2 y %3%4.</translation>
    </message>
    <message>
        <source>Enter a value for %1.</source>
        <translation>Introduzca un valor para %1.</translation>
    </message>
    <message>
        <source>%1 must be a number.</source>
        <translation>%1 debe ser un número.</translation>
    </message>
    <message>
        <source>%1 has two decimal marks. Both , and . count as decimal marks.</source>
        <translation>%1 tiene dos signos decimales. Tanto , como . cuentan como signos decimales.</translation>
    </message>
    <message>
        <source>%1 must be a whole number without , or . in it.</source>
        <translation>%1 debe ser un número entero sin , ni .</translation>
    </message>
    <message>
        <source>%1: %2 can be read in two ways. Press Enter in the field for %3, or type %4.</source>
        <translation>%1: %2 puede leerse de dos maneras. Pulse Intro en el campo para %3, o escriba %4.</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorDialog</name>
    <message>
        <source>Select what the operator may do. STOP ALL, Esc, each motor&apos;s stops and Disconnect always work. Operator mode prevents mistakes; it is not a security feature: anyone with access to this computer&apos;s files can bypass it.</source>
        <translation>Marque lo que puede hacer el operador. PARAR TODO, Esc, las paradas de cada motor y Desconectar siempre funcionan. El modo operador evita errores; no es una protección: quien tenga acceso a los archivos de este equipo puede eludirlo.</translation>
    </message>
    <message>
        <source>&amp;Enable motors, clear faults</source>
        <translation>Habilitar motor&amp;es, borrar fallos</translation>
    </message>
    <message>
        <source>&amp;Jog</source>
        <translation>&amp;Jog</translation>
    </message>
    <message>
        <source>&amp;Points and sequences</source>
        <translation>&amp;Puntos y secuencias</translation>
    </message>
    <message>
        <source>&amp;Moves: go to, run, step</source>
        <translation>&amp;Movimientos: ir a, marcha, por pasos</translation>
    </message>
    <message>
        <source>&amp;Homing</source>
        <translation>&amp;Referenciado</translation>
    </message>
    <message>
        <source>&amp;Outputs</source>
        <translation>&amp;Salidas</translation>
    </message>
    <message>
        <source>P&amp;IN to leave operator mode, at least 4 characters</source>
        <translation>P&amp;IN para salir del modo operador, mínimo 4 caracteres</translation>
    </message>
    <message>
        <source>PIN &amp;again</source>
        <translation>Repe&amp;tir PIN</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>&amp;Leave operator mode</source>
        <translation>Sa&amp;lir del modo operador</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>Cancel: keep the mode unchanged</source>
        <translation>Cancelar: no cambiar el modo</translation>
    </message>
    <message>
        <source>The PIN is too short: use at least 4 characters.</source>
        <translation>El PIN es demasiado corto: use al menos 4 caracteres.</translation>
    </message>
    <message>
        <source>The two PINs differ. Type the same PIN twice.</source>
        <translation>Los dos PIN no coinciden. Escriba dos veces el mismo.</translation>
    </message>
    <message>
        <source>Wrong PIN. %1</source>
        <translation>PIN erróneo. %1</translation>
    </message>
    <message>
        <source>E&amp;nter operator mode</source>
        <translation>E&amp;ntrar en modo operador</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorLock</name>
    <message>
        <source>If you forgot it, close the panel and remove the &quot;operator&quot; section from %1.</source>
        <translation>Si lo ha olvidado, cierre el panel y elimine la sección “operator” de %1.</translation>
    </message>
    <message>
        <source>Leave o&amp;perator mode…</source>
        <translation>Salir del modo o&amp;perador…</translation>
    </message>
    <message>
        <source>O&amp;perator mode…</source>
        <translation>Modo o&amp;perador…</translation>
    </message>
    <message>
        <source>Limits the panel to the actions that you select, until someone enters the PIN.</source>
        <translation>Limita el panel a las acciones que usted marque, hasta que alguien introduzca el PIN.</translation>
    </message>
</context>
<context>
    <name>nmc::PacketModel</name>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>Sent to</source>
        <translation>Enviado a</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Significado</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Respuesta</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
</context>
<context>
    <name>nmc::PacketMonitor</name>
    <message>
        <source>Packet monitor</source>
        <translation>Monitor de paquetes</translation>
    </message>
    <message>
        <source>Filter packets by module</source>
        <translation>Filtrar paquetes por módulo</translation>
    </message>
    <message>
        <source>Shows only packets of one module (Ctrl+M).</source>
        <translation>Muestra solo los paquetes de un módulo (Ctrl+M).</translation>
    </message>
    <message>
        <source>Filter packets by kind</source>
        <translation>Filtrar paquetes por tipo</translation>
    </message>
    <message>
        <source>Shows only packets of one kind (Ctrl+T).</source>
        <translation>Muestra solo los paquetes de un tipo (Ctrl+T).</translation>
    </message>
    <message>
        <source>Polls</source>
        <translation>Consultas</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Paradas</translation>
    </message>
    <message>
        <source>Connecting and link</source>
        <translation>Conexión y enlace</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Solo errores</translation>
    </message>
    <message>
        <source>Stops recording; packets shown stay (%1).</source>
        <translation>Detiene la grabación; los paquetes mostrados se quedan (%1).</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Clears the packets shown (%1).</source>
        <translation>Vacía la lista de paquetes mostrados (%1).</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the selected rows as text, or all rows if none is selected (%1).</source>
        <translation>Copia como texto las filas seleccionadas, o todas si no hay ninguna seleccionada (%1).</translation>
    </message>
    <message>
        <source>Saves all recorded packets as text, or as a log that can be replayed (%1).</source>
        <translation>Guarda todos los paquetes grabados como texto o como registro reproducible (%1).</translation>
    </message>
    <message>
        <source>Packets and counters</source>
        <translation>Paquetes y contadores</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Paquetes</translation>
    </message>
    <message>
        <source>Counters</source>
        <translation>Contadores</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reanudar</translation>
    </message>
    <message>
        <source>Save packets</source>
        <translation>Guardar paquetes</translation>
    </message>
    <message>
        <source>Replayable log (*%1)</source>
        <translation>Registro reproducible (*%1)</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 de %2 mostrados</translation>
    </message>
    <message>
        <source>%1, %2 older dropped</source>
        <translation>%1, %2 anteriores descartados</translation>
    </message>
    <message>
        <source>%1, paused</source>
        <translation>%1, en pausa</translation>
    </message>
</context>
<context>
    <name>nmc::PacketView</name>
    <message>
        <source>Packets, newest last</source>
        <translation>Paquetes, los más recientes al final</translation>
    </message>
    <message>
        <source>No packets. Exchanges are recorded while this view is visible.</source>
        <translation>No hay paquetes. Los intercambios se graban mientras esta vista está visible.</translation>
    </message>
    <message>
        <source>No packets match the filter.</source>
        <translation>Ningún paquete coincide con el filtro.</translation>
    </message>
</context>
<context>
    <name>nmc::PanelHead</name>
    <message>
        <source>&amp;Enable servo</source>
        <translation>Habili&amp;tar servo</translation>
    </message>
    <message>
        <source>Enable servo of this module</source>
        <translation>Habilitar servo de este módulo</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>Stop this module smoothly</source>
        <translation>Parar este módulo suavemente</translation>
    </message>
    <message>
        <source>Stop a&amp;bruptly</source>
        <translation>Parada &amp;brusca</translation>
    </message>
    <message>
        <source>Stop abruptly: this module</source>
        <translation>Parada brusca: este módulo</translation>
    </message>
    <message>
        <source>&amp;Motor off</source>
        <translation>Apagar &amp;motor</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Posición desconocida</translation>
    </message>
    <message>
        <source>The servo is already on.</source>
        <translation>El servo ya está encendido.</translation>
    </message>
    <message>
        <source>Switches the amplifier on and holds the motor in place.</source>
        <translation>Enciende el amplificador y mantiene el motor en su sitio.</translation>
    </message>
    <message>
        <source>Slows down with the present acceleration, then holds.</source>
        <translation>Frena con la aceleración actual y después mantiene la posición.</translation>
    </message>
    <message>
        <source>Stops at once, then holds.</source>
        <translation>Se detiene de inmediato y después mantiene la posición.</translation>
    </message>
    <message>
        <source>&amp;Enable amplifier</source>
        <translation>&amp;Habilitar amplificador</translation>
    </message>
    <message>
        <source>Enable amplifier of this module</source>
        <translation>Habilitar amplificador de este módulo</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Parar aquí</translation>
    </message>
    <message>
        <source>Stop here: hold this module at its present position</source>
        <translation>Parar aquí: mantener este módulo en su posición actual</translation>
    </message>
    <message>
        <source>Position %1 %2</source>
        <translation>Posición %1 %2</translation>
    </message>
    <message>
        <source>The amplifier is already on.</source>
        <translation>El amplificador ya está encendido.</translation>
    </message>
    <message>
        <source>Stops at once and switches the amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>Se detiene de inmediato y apaga el amplificador: el motor puede girar libremente y una carga puede caer.</translation>
    </message>
    <message>
        <source>Task running on this module</source>
        <translation>Tarea en curso en este módulo</translation>
    </message>
    <message>
        <source>Measured velocity</source>
        <translation>Velocidad medida</translation>
    </message>
    <message>
        <source>Velocity measured from positions over 0.2 s.</source>
        <translation>Velocidad medida a partir de las posiciones durante 0,2 s.</translation>
    </message>
    <message>
        <source>Motor power as sensed by the module.</source>
        <translation>Alimentación del motor detectada por el módulo.</translation>
    </message>
    <message>
        <source>Limit %1 –</source>
        <translation>Final %1 –</translation>
    </message>
    <message>
        <source>Limit %1 high</source>
        <translation>Final %1 alto</translation>
    </message>
    <message>
        <source>Limit %1 low</source>
        <translation>Final %1 bajo</translation>
    </message>
    <message>
        <source>Power –</source>
        <translation>Tensión –</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Tensión</translation>
    </message>
    <message>
        <source>No power</source>
        <translation>Sin tensión</translation>
    </message>
    <message>
        <source>Current was limited: %1</source>
        <translation>Corriente limitada: %1</translation>
    </message>
    <message>
        <source>Current %1</source>
        <translation>Corriente %1</translation>
    </message>
    <message>
        <source>● Limit stop armed</source>
        <translation>● Parada por límite armada</translation>
    </message>
    <message>
        <source>▲ Limit stop tripped</source>
        <translation>▲ Parada por límite disparada</translation>
    </message>
    <message>
        <source>In motion, stops at once, as Stop abruptly does. At rest, holds the position that the motor has at this moment, without a profile.</source>
        <translation>En movimiento, se detiene de inmediato, como «Parar bruscamente». En reposo, mantiene la posición que tiene el motor en este momento, sin perfil.</translation>
    </message>
    <message>
        <source>Travel limits</source>
        <translation>Límites de recorrido</translation>
    </message>
    <message>
        <source>Switches the amplifier on, holds the motor in place and clears the sticky bits: the position error bit is set while the servo is off.</source>
        <translation>Enciende el amplificador, mantiene el motor en su sitio y borra los bits enclavados: el del error de posición está activo mientras el servo está apagado.</translation>
    </message>
    <message>
        <source>Looking for modules… This is the last known state.</source>
        <translation>Buscando módulos… Esto es lo último que dijo.</translation>
    </message>
    <message>
        <source>Driven by a test</source>
        <translation>Movido por una prueba</translation>
    </message>
    <message>
        <source>The test moves the motor around the position that it held.</source>
        <translation>La prueba mueve el motor alrededor de la posición que mantenía.</translation>
    </message>
    <message>
        <source>Limit switch 1: high blocks the way to it.</source>
        <translation>Final de carrera 1: alto bloquea el avance hacia él.</translation>
    </message>
    <message>
        <source>Limit switch 2: high blocks the way to it.</source>
        <translation>Final de carrera 2: alto bloquea el avance hacia él.</translation>
    </message>
    <message>
        <source>counter: %1</source>
        <translation>contador: %1</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1: desconocido</translation>
    </message>
</context>
<context>
    <name>nmc::PathPlot</name>
    <message>
        <source>Positions of the path over time</source>
        <translation>Posiciones de la trayectoria en el tiempo</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>No path. Open a file, or draw one from a sequence.</source>
        <translation>No hay trayectoria. Abra un archivo o trace una a partir de una secuencia.</translation>
    </message>
</context>
<context>
    <name>nmc::PathsPage</name>
    <message>
        <source>Paths</source>
        <translation>Trayectorias</translation>
    </message>
    <message>
        <source>Choice of a path</source>
        <translation>Elección de una trayectoria</translation>
    </message>
    <message>
        <source>Open path…</source>
        <translation>Abrir trayectoria…</translation>
    </message>
    <message>
        <source>Open path… from a CSV file</source>
        <translation>Abrir trayectoria… desde un archivo CSV</translation>
    </message>
    <message>
        <source>Save path…</source>
        <translation>Guardar trayectoria…</translation>
    </message>
    <message>
        <source>Save path… as a CSV file</source>
        <translation>Guardar trayectoria… como archivo CSV</translation>
    </message>
    <message>
        <source>Sequence to draw a path from</source>
        <translation>Secuencia a partir de la cual trazar una trayectoria</translation>
    </message>
    <message>
        <source>Rate of the path to draw</source>
        <translation>Frecuencia de la trayectoria que se traza</translation>
    </message>
    <message>
        <source>Draw path</source>
        <translation>Trazar trayectoria</translation>
    </message>
    <message>
        <source>Draw path from the moves of a sequence</source>
        <translation>Trazar trayectoria a partir de los movimientos de una secuencia</translation>
    </message>
    <message>
        <source>The path</source>
        <translation>La trayectoria</translation>
    </message>
    <message>
        <source>Running the path</source>
        <translation>Ejecución de la trayectoria</translation>
    </message>
    <message>
        <source>Move to start</source>
        <translation>Ir al inicio</translation>
    </message>
    <message>
        <source>Move to start: to the first point of the path</source>
        <translation>Ir al inicio: al primer punto de la trayectoria</translation>
    </message>
    <message>
        <source>Run path</source>
        <translation>Ejecutar trayectoria</translation>
    </message>
    <message>
        <source>Run path, with confirmation</source>
        <translation>Ejecutar trayectoria tras una pregunta</translation>
    </message>
    <message>
        <source>Stop path</source>
        <translation>Parar trayectoria</translation>
    </message>
    <message>
        <source>Stop path: all its axes slow down</source>
        <translation>Parar trayectoria: todos sus ejes frenan</translation>
    </message>
    <message>
        <source>Progress of the path</source>
        <translation>Progreso de la trayectoria</translation>
    </message>
    <message>
        <source>State of the path</source>
        <translation>Estado de la trayectoria</translation>
    </message>
    <message>
        <source>Paths need a PIC-SERVO CMC or SC. This chain has none.</source>
        <translation>Las trayectorias requieren un PIC-SERVO CMC o SC. Esta cadena no tiene ninguno.</translation>
    </message>
    <message>
        <source>A path is running.</source>
        <translation>Hay una trayectoria en ejecución.</translation>
    </message>
    <message>
        <source>Open or draw a path first.</source>
        <translation>Abra o trace primero una trayectoria.</translation>
    </message>
    <message>
        <source>A sequence or a move to a point is running.</source>
        <translation>Hay una secuencia o un movimiento a un punto en curso.</translation>
    </message>
    <message>
        <source>The unit of an axis has changed. Open or draw the path again.</source>
        <translation>La unidad de un eje ha cambiado. Abra o trace de nuevo la trayectoria.</translation>
    </message>
    <message>
        <source>The counter or the home of an axis has changed. Draw the path again.</source>
        <translation>El contador o la referencia de un eje ha cambiado. Trace de nuevo la trayectoria.</translation>
    </message>
    <message>
        <source>%1 is not a path for this chain:</source>
        <translation>%1 no es una trayectoria para esta cadena:</translation>
    </message>
    <message>
        <source>There may be more problems after these.</source>
        <translation>Puede haber más problemas después de estos.</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>Leyendo el archivo…</translation>
    </message>
    <message>
        <source>Reads positions for each point from a CSV file. Nothing moves.</source>
        <translation>Lee de un archivo CSV las posiciones de cada punto. Nada se mueve.</translation>
    </message>
    <message>
        <source>Saves the path as CSV, with its positions in the units of the axes.</source>
        <translation>Guarda la trayectoria como CSV, con sus posiciones en las unidades de los ejes.</translation>
    </message>
    <message>
        <source>Create a sequence of moves first (F3).</source>
        <translation>Cree primero una secuencia de movimientos (F3).</translation>
    </message>
    <message>
        <source>Turns the moves of this sequence into one motion without stops. Nothing moves.</source>
        <translation>Convierte los movimientos de esta secuencia en un solo movimiento sin paradas. Nada se mueve.</translation>
    </message>
    <message>
        <source>Moves each axis of the path to its first point.</source>
        <translation>Mueve cada eje de la trayectoria a su primer punto.</translation>
    </message>
    <message>
        <source>Runs all axes through the path. Asks first.</source>
        <translation>Mueve todos los ejes por la trayectoria, tras una pregunta.</translation>
    </message>
    <message>
        <source>No path is running.</source>
        <translation>No hay ninguna trayectoria en ejecución.</translation>
    </message>
    <message>
        <source>Stops all axes of the path; they hold where they stop.</source>
        <translation>Detiene todos los ejes de la trayectoria; mantienen la posición donde se paran.</translation>
    </message>
    <message>
        <source>A path file has a column for each axis. Axes here: %1.</source>
        <translation>Un archivo de trayectoria tiene una columna para cada eje. Ejes aquí: %1.</translation>
    </message>
    <message>
        <source>Open a path</source>
        <translation>Abrir una trayectoria</translation>
    </message>
    <message>
        <source>Save the path</source>
        <translation>Guardar la trayectoria</translation>
    </message>
    <message>
        <source>Start of the path</source>
        <translation>Inicio de la trayectoria</translation>
    </message>
    <message>
        <source>All axes of the path start to move. Make sure that nothing is in their way.</source>
        <translation>Todos los ejes de la trayectoria empiezan a moverse. Asegúrese de que no haya nada en su camino.</translation>
    </message>
    <message>
        <source>Run the path</source>
        <translation>Ejecutar la trayectoria</translation>
    </message>
    <message>
        <source>&amp;Run path</source>
        <translation>&amp;Ejecutar trayectoria</translation>
    </message>
</context>
<context>
    <name>nmc::Pendant</name>
    <message>
        <source>Pendant: &amp;keyboard, gamepad or jog wheel</source>
        <translation>Mando portá&amp;til: teclado, gamepad o volante</translation>
    </message>
    <message>
        <source>To move the motor, hold Shift with an arrow key, or a shoulder button of a gamepad with its left stick or D-pad, or a button of a jog wheel with its ring or wheel. B (○) of the gamepad and the middle button of the wheel are STOP ALL. (F12)</source>
        <translation>Para mover el motor, mantenga pulsada Mayús con una flecha, un botón superior de un gamepad con su palanca izquierda o su cruceta, o un botón de un volante con su anillo o su rueda. B (○) del gamepad y el botón central del volante son PARAR TODO. (F12)</translation>
    </message>
</context>
<context>
    <name>nmc::PinBox</name>
    <message>
        <source>Make all pins inputs</source>
        <translation>Poner todos los pines como entradas</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Ask first</source>
        <translation>Preguntar</translation>
    </message>
    <message>
        <source>output</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>Sentido de %1</translation>
    </message>
    <message>
        <source>high: output %1</source>
        <translation>alto: salida %1</translation>
    </message>
    <message>
        <source>Ask first before %1 changes</source>
        <translation>Preguntar antes de que %1 cambie</translation>
    </message>
    <message>
        <source>Asks before the panel switches this output.</source>
        <translation>Pregunta antes de que el panel conmute esta salida.</translation>
    </message>
    <message>
        <source>Take %1 low on STOP ALL</source>
        <translation>Poner %1 a nivel bajo con PARAR TODO</translation>
    </message>
    <message>
        <source>STOP ALL takes this output low. If cleared, the output stays as it is.</source>
        <translation>PARAR TODO pone esta salida a nivel bajo. Si está desmarcado, la salida queda como está.</translation>
    </message>
    <message>
        <source>Switch %1 on?</source>
        <translation>¿Activar %1?</translation>
    </message>
    <message>
        <source>Switch %1 off?</source>
        <translation>¿Desactivar %1?</translation>
    </message>
    <message>
        <source>&amp;Switch on</source>
        <translation>&amp;Activar</translation>
    </message>
    <message>
        <source>&amp;Switch off</source>
        <translation>&amp;Desactivar</translation>
    </message>
    <message>
        <source>Makes all twelve pins inputs: outputs release what they drive.</source>
        <translation>Convierte los doce pines en entradas: las salidas dejan libre lo que gobiernan.</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Make all pins inputs to start over.</source>
        <translation>Otro programa configuró este módulo, por lo que se desconoce el sentido de sus pines. Ponga todos los pines como entradas para empezar de nuevo.</translation>
    </message>
    <message>
        <source>Pin directions unknown. Make all pins inputs first.</source>
        <translation>Se desconoce el sentido de los pines. Ponga primero todos los pines como entradas.</translation>
    </message>
    <message>
        <source>Input: the module reads this pin. Output: it drives this pin.</source>
        <translation>Entrada: el módulo lee este pin. Salida: lo gobierna.</translation>
    </message>
    <message>
        <source>high, set low</source>
        <translation>alto, fijado bajo</translation>
    </message>
    <message>
        <source>low, set high</source>
        <translation>bajo, fijado alto</translation>
    </message>
    <message>
        <source>This pin is an input.</source>
        <translation>Este pin es una entrada.</translation>
    </message>
    <message>
        <source>Pin directions unknown.</source>
        <translation>Se desconoce el sentido de los pines.</translation>
    </message>
</context>
<context>
    <name>nmc::PointsModel</name>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posiciones</translation>
    </message>
</context>
<context>
    <name>nmc::PrintDialog</name>
    <message>
        <source>&amp;Print</source>
        <translation>Im&amp;primir</translation>
    </message>
    <message>
        <source>Save as P&amp;DF…</source>
        <translation>Guardar como P&amp;DF…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Impresora</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copias</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>Impresoras</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Guardar como PDF…</translation>
    </message>
    <message>
        <source>Saves the page as a file that any computer can print.</source>
        <translation>Guarda la página en un archivo que cualquier equipo puede imprimir.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>P&amp;rinter</source>
        <translation>Imp&amp;resora</translation>
    </message>
    <message>
        <source>C&amp;opies</source>
        <translation>C&amp;opias</translation>
    </message>
    <message>
        <source>The printer to use. It is preselected next time.</source>
        <translation>La impresora que se usará; se propondrá de nuevo la próxima vez.</translation>
    </message>
    <message>
        <source>Sends the page to this printer.</source>
        <translation>Envía la página a esta impresora.</translation>
    </message>
    <message>
        <source>Save the page</source>
        <translation>Guardar la página</translation>
    </message>
    <message>
        <source>page</source>
        <translation>página</translation>
    </message>
</context>
<context>
    <name>nmc::PwmBox</name>
    <message>
        <source>Drive reverse</source>
        <translation>Accionar atrás</translation>
    </message>
    <message>
        <source>Drive forward</source>
        <translation>Accionar adelante</translation>
    </message>
    <message>
        <source>The PWM value</source>
        <translation>El valor de PWM</translation>
    </message>
    <message>
        <source>The share of the supply that drives the motor; 255 is full power.</source>
        <translation>La parte de la alimentación que acciona el motor; 255 es toda la potencia.</translation>
    </message>
    <message>
        <source>Drive reverse with this PWM value</source>
        <translation>Accionar atrás con este valor de PWM</translation>
    </message>
    <message>
        <source>Drive forward with this PWM value</source>
        <translation>Accionar adelante con este valor de PWM</translation>
    </message>
    <message>
        <source>PWM drives the motor directly, without the servo. No position, position error or output limit protects it, and it runs until you switch it off.</source>
        <translation>El PWM acciona el motor directamente, sin el servo. Ningún límite de posición, de error de posición ni de salida lo protege, y el motor gira hasta que usted lo apague.</translation>
    </message>
    <message>
        <source>= %1 %</source>
        <translation>= %1 %</translation>
    </message>
    <message>
        <source>Drives the motor in reverse until you switch it off.</source>
        <translation>Acciona el motor hacia atrás hasta que usted lo apague.</translation>
    </message>
    <message>
        <source>Drives the motor forward until you switch it off.</source>
        <translation>Acciona el motor hacia adelante hasta que usted lo apague.</translation>
    </message>
</context>
<context>
    <name>nmc::RatePage</name>
    <message>
        <source>&amp;Change baud rate</source>
        <translation>&amp;Cambiar velocidad</translation>
    </message>
    <message>
        <source>New baud rate of the chain</source>
        <translation>Nueva velocidad en baudios de la cadena</translation>
    </message>
    <message>
        <source>The new baud rate of the whole chain.</source>
        <translation>La nueva velocidad en baudios de toda la cadena.</translation>
    </message>
    <message>
        <source>Change baud rate of the whole chain</source>
        <translation>Cambiar velocidad en baudios de toda la cadena</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>Positions, gains and groups are kept. The panel checks every module at the new baud rate; if one does not answer, all modules go back to the old rate.</source>
        <translation>Las posiciones, las ganancias y los grupos se conservan. El panel comprueba todos los módulos a la nueva velocidad; si uno no responde, todos vuelven a la anterior.</translation>
    </message>
    <message>
        <source>The chain runs at %1 Bd.</source>
        <translation>La cadena trabaja a %1 Bd.</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change the baud rate.</source>
        <translation>Un motor está en movimiento. Pare todos los motores para cambiar la velocidad en baudios.</translation>
    </message>
    <message>
        <source>The chain already runs at this baud rate.</source>
        <translation>La cadena ya trabaja a esta velocidad en baudios.</translation>
    </message>
    <message>
        <source>Sends the new baud rate to every module, then checks each one.</source>
        <translation>Envía la nueva velocidad en baudios a todos los módulos y después comprueba cada uno.</translation>
    </message>
    <message>
        <source>Modules that do not answer would stay at the old baud rate: %1.</source>
        <translation>Los módulos que no responden se quedarían a la velocidad anterior: %1.</translation>
    </message>
    <message>
        <source>Modules with an unknown group may miss the change: %1. Set their group on the Groups page, or none.</source>
        <translation>Los módulos de grupo desconocido pueden no recibir el cambio: %1. Asígneles un grupo en la página Grupos, o ninguno.</translation>
    </message>
    <message>
        <source>Group leaders would answer during the change. Make these ordinary members on the Groups page: %1.</source>
        <translation>Los líderes de grupo responderían durante el cambio. Conviértalos en miembros ordinarios en la página Grupos: %1.</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Otra…</translation>
    </message>
    <message>
        <source>Divisor of Set Baud Rate</source>
        <translation>Divisor de Set Baud Rate</translation>
    </message>
    <message>
        <source>The baud rate is 1 250 000 Bd / (divisor + 1). The panel first checks that this computer&apos;s port supports it to within 2 %.</source>
        <translation>La velocidad en baudios es 1 250 000 Bd / (divisor + 1). El panel comprueba antes que el puerto de este equipo la admite con un error de hasta el 2 %.</translation>
    </message>
    <message>
        <source>= %1 Bd</source>
        <translation>= %1 Bd</translation>
    </message>
    <message>
        <source>The divisor</source>
        <translation>El divisor</translation>
    </message>
</context>
<context>
    <name>nmc::RepeatabilityBox</name>
    <message>
        <source>Repeatability and backlash</source>
        <translation>Repetibilidad y holgura</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Measure repeatability and backlash</source>
        <translation>Medir la repetibilidad y la holgura</translation>
    </message>
    <message>
        <source>Cancel measuring the repeatability</source>
        <translation>Cancelar la medición de repetibilidad</translation>
    </message>
    <message>
        <source>Use as backlash</source>
        <translation>Usar como holgura</translation>
    </message>
    <message>
        <source>Use as backlash of the axis</source>
        <translation>Usar como holgura del eje</translation>
    </message>
    <message>
        <source>Result of the repeatability measurement</source>
        <translation>Resultado de la medición de repetibilidad</translation>
    </message>
    <message>
        <source>Approach this input</source>
        <translation>Aproximarse a esta entrada</translation>
    </message>
    <message>
        <source>The motor approaches it from both sides. Direction, acceleration, search distance and time limit are those of the search for home.</source>
        <translation>El motor se aproxima desde ambos lados. El sentido, la aceleración, la distancia de búsqueda y el tiempo límite son los de la búsqueda de referencia.</translation>
    </message>
    <message>
        <source>Velocity of the approach</source>
        <translation>Velocidad de aproximación</translation>
    </message>
    <message>
        <source>Slower is more exact: the chip may read its inputs only once per servo tick.</source>
        <translation>Más despacio es más exacto: puede que el chip lea sus entradas solo una vez por período del servo.</translation>
    </message>
    <message>
        <source>Times from each side</source>
        <translation>Veces desde cada lado</translation>
    </message>
    <message>
        <source>Number of approaches from each side.</source>
        <translation>Número de aproximaciones desde cada lado.</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Aproximarse a</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Veces</translation>
    </message>
    <message>
        <source>from each side</source>
        <translation>desde cada lado</translation>
    </message>
    <message>
        <source>The measurement is running.</source>
        <translation>La medición está en curso.</translation>
    </message>
    <message>
        <source>Measure first.</source>
        <translation>Mida primero.</translation>
    </message>
    <message>
        <source>An index does not show the backlash of the load.</source>
        <translation>Un índice no muestra la holgura de la carga.</translation>
    </message>
    <message>
        <source>No backlash was found that exceeds its uncertainty.</source>
        <translation>No se encontró una holgura mayor que su incertidumbre.</translation>
    </message>
    <message>
        <source>The axis has this backlash.</source>
        <translation>El eje ya tiene esta holgura.</translation>
    </message>
    <message>
        <source>Not measured in this connection.</source>
        <translation>Sin medir en esta conexión.</translation>
    </message>
    <message>
        <source>Forward, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>Adelante, %4 veces: media %1, desviación estándar %2, rango %3</translation>
    </message>
    <message>
        <source>Reverse, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>Atrás, %4 veces: media %1, desviación estándar %2, rango %3</translation>
    </message>
    <message>
        <source>Difference: %1 ± %2</source>
        <translation>Diferencia: %1 ± %2</translation>
    </message>
    <message>
        <source>Backlash: %1 ± %2</source>
        <translation>Holgura: %1 ± %2</translation>
    </message>
    <message>
        <source>The index is on the encoder&apos;s own shaft: this shows how well a capture repeats, not the backlash of the load.</source>
        <translation>El índice está en el eje del propio encoder: esto muestra lo bien que se repite una captura, no la holgura de la carga.</translation>
    </message>
    <message>
        <source>Below zero, so this is not backlash. The switch may bounce.</source>
        <translation>Menor que cero, así que no es holgura. Quizá el interruptor rebote.</translation>
    </message>
    <message>
        <source>Includes the hysteresis of the switch itself. Only with the encoder on the motor and the switch on the load does it show the backlash between them.</source>
        <translation>Incluye la histéresis del propio interruptor. Solo con el encoder en el motor y el interruptor en la carga muestra la holgura entre ambos.</translation>
    </message>
    <message>
        <source>The motor moves up to %1 between two readings of the inputs. Measure more slowly.</source>
        <translation>El motor se mueve hasta %1 entre dos lecturas de las entradas por el chip. Mida más despacio.</translation>
    </message>
    <message>
        <source>Moves the motor to and fro across the switch or index, and reads where it was captured.</source>
        <translation>Mueve el motor de un lado a otro sobre el interruptor o el índice, y lee dónde se capturó.</translation>
    </message>
    <message>
        <source>No measurement is running.</source>
        <translation>No hay ninguna medición en curso.</translation>
    </message>
    <message>
        <source>Stops the motor smoothly; what was captured stays.</source>
        <translation>Para el motor suavemente; lo capturado se conserva.</translation>
    </message>
    <message>
        <source>Makes %1 the backlash of the axis (Axis page): what was measured, with its uncertainty. Sends nothing.</source>
        <translation>Hace de %1 la holgura del eje (página Eje): lo medido con su incertidumbre. No envía nada.</translation>
    </message>
</context>
<context>
    <name>nmc::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Informar de un problema</translation>
    </message>
    <message>
        <source>Nothing is sent. Read the report below, save it, and attach the file where you describe the problem. It contains neither your PIN nor the name of your home folder.</source>
        <translation>No se envía nada. Lea el informe de abajo, guárdelo y adjunte el archivo allí donde describa el problema. No contiene ni su PIN ni el nombre de su carpeta personal.</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>Texto del informe</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Guardar como…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseForm</name>
    <message>
        <source>Settings of the next step</source>
        <translation>Ajustes del próximo escalón</translation>
    </message>
    <message>
        <source>Distance of the step response</source>
        <translation>Distancia de la respuesta al escalón</translation>
    </message>
    <message>
        <source>The distance of the step</source>
        <translation>La distancia del escalón</translation>
    </message>
    <message>
        <source>The record</source>
        <translation>La grabación</translation>
    </message>
    <message>
        <source>The settling band</source>
        <translation>La banda de establecimiento</translation>
    </message>
    <message>
        <source>% of the step</source>
        <translation>% del escalón</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal. At least one count. Applies to all runs.</source>
        <translation>El motor se considera establecido cuando permanece así de cerca de su destino. Al menos una cuenta. Se aplica a todos los ensayos.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Settling band</source>
        <translation>Banda</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Escalón</translation>
    </message>
    <message>
        <source>Step and record</source>
        <translation>Escalón y grabación</translation>
    </message>
    <message>
        <source>The motor jumps by this distance, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>El motor salta esta distancia y después mantiene la posición. Asegúrese de que todo lo que acciona puede moverse libremente (Mayús+F9).</translation>
    </message>
    <message>
        <source>%1 %2 instead of %3</source>
        <translation>%1 %2 en lugar de %3</translation>
    </message>
    <message>
        <source>Some gains in the fields were not sent: %1. Which gains should the step use?</source>
        <translation>Algunas ganancias de los campos no se han enviado: %1. ¿Con qué ganancias debe hacerse el escalón?</translation>
    </message>
    <message>
        <source>Gains not sent</source>
        <translation>Ganancias sin enviar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;Apply and step</source>
        <translation>&amp;Aplicar y dar el escalón</translation>
    </message>
    <message>
        <source>Step with &amp;present gains</source>
        <translation>&amp;Escalón con las actuales</translation>
    </message>
    <message>
        <source>How far the command goes; negative: reverse. Small steps show the tuning of the servo, large ones the limits of the amplifier.</source>
        <translation>Distancia de la consigna; negativa: hacia atrás. Los escalones pequeños muestran el ajuste del servo, los grandes los límites del amplificador.</translation>
    </message>
    <message>
        <source>How long to record after the step, or after the end of a move. Then the motor is commanded to hold.</source>
        <translation>Cuánto se registra tras el escalón o tras el fin de un movimiento. Después se ordena al motor mantenerse.</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>Velocidad del movimiento</translation>
    </message>
    <message>
        <source>Acceleration of the move</source>
        <translation>Aceleración del movimiento</translation>
    </message>
    <message>
        <source>Moves there and back</source>
        <translation>Movimientos de ida y vuelta</translation>
    </message>
    <message>
        <source>How often it moves there and back. Each move is recorded.</source>
        <translation>Cuántas veces va y vuelve. Se registra cada movimiento.</translation>
    </message>
    <message>
        <source>Settling window</source>
        <translation>Ventana de establecimiento</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal for the dwell. At least one count. Applies to all moves.</source>
        <translation>El motor se ha establecido cuando permanece así de cerca de su destino durante la permanencia. Al menos una cuenta. Se aplica a todos los movimientos.</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Permanencia</translation>
    </message>
    <message>
        <source>How long it must stay in the window. The settling time ends where the dwell begins.</source>
        <translation>Cuánto debe permanecer en la ventana. El tiempo de establecimiento acaba donde empieza la permanencia.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Ida y vuelta</translation>
    </message>
    <message>
        <source>A step or move is already running.</source>
        <translation>Ya hay un escalón o un movimiento en curso.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Move and record</source>
        <translation>Mover y registrar</translation>
    </message>
    <message>
        <source>The motor moves there and back, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>El motor va y vuelve, y luego se mantiene. Asegúrese de que todo lo que mueve puede moverse libremente (Mayús+F9).</translation>
    </message>
    <message>
        <source>The velocity of the move. Until you type one, it is that of moves to a position.</source>
        <translation>La velocidad del movimiento. Mientras no escriba una, es la de los movimientos a una posición.</translation>
    </message>
    <message>
        <source>The acceleration of the move. Until you type one, it is that of moves to a position.</source>
        <translation>La aceleración del movimiento. Mientras no escriba una, es la de los movimientos a una posición.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePage</name>
    <message>
        <source>Use these gains</source>
        <translation>Usar estas ganancias</translation>
    </message>
    <message>
        <source>Select a run in the list first.</source>
        <translation>Seleccione primero un ensayo de la lista.</translation>
    </message>
    <message>
        <source>This run belongs to %1. Select that module first.</source>
        <translation>Este ensayo es de %1. Seleccione primero ese módulo.</translation>
    </message>
    <message>
        <source>Copies the gains of this run to the Gains page. Sends nothing (Ctrl+Shift+U).</source>
        <translation>Copia las ganancias de este ensayo en la página Ganancias. No envía nada (Ctrl+Mayús+U).</translation>
    </message>
    <message>
        <source>Removes this run from the list (Ctrl+Del).</source>
        <translation>Quita este ensayo de la lista (Ctrl+Supr).</translation>
    </message>
    <message>
        <source>No run yet. Record a step first.</source>
        <translation>Aún no hay ensayos. Grabe primero un escalón.</translation>
    </message>
    <message>
        <source>Saves all runs in the list with their gains and results (Ctrl+Shift+X).</source>
        <translation>Guarda todos los ensayos de la lista con sus ganancias y resultados (Ctrl+Mayús+X).</translation>
    </message>
    <message>
        <source>Export step responses</source>
        <translation>Exportar respuestas al escalón</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Escalón</translation>
    </message>
    <message>
        <source>Step results</source>
        <translation>Resultados de los escalones</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Todos los ensayos</translation>
    </message>
    <message>
        <source>All runs of this module in the plot</source>
        <translation>Todos los ensayos de este módulo en la gráfica</translation>
    </message>
    <message>
        <source>Shows the other runs of this module, older runs paler.</source>
        <translation>Muestra los demás ensayos de este módulo, más pálidos cuanto más antiguos.</translation>
    </message>
    <message>
        <source>No run was removed.</source>
        <translation>No se ha quitado ningún ensayo.</translation>
    </message>
    <message>
        <source>Restores the run removed last (Ctrl+Shift+Del).</source>
        <translation>Restaura el último ensayo quitado (Ctrl+Mayús+Supr).</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePlot</name>
    <message>
        <source>Step responses over time</source>
        <translation>Respuestas al escalón en el tiempo</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>ensayo %1, %2</translation>
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
        <translation>destino</translation>
    </message>
    <message>
        <source>No run selected. A step response shows how the motor follows a jump of its command.</source>
        <translation>Ningún ensayo seleccionado. Una respuesta al escalón muestra cómo sigue el motor un salto de su consigna.</translation>
    </message>
    <message>
        <source>motor model</source>
        <translation>modelo del motor</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>previsto</translation>
    </message>
    <message>
        <source>Positions since the step, relative to its start. The shaded band is the settling band around the goal. Double-click to switch between the whole record and the motion. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>Posiciones desde el escalón, relativas a su inicio. La banda sombreada es la banda de establecimiento alrededor del destino. Doble clic para alternar entre toda la grabación y el movimiento. Rueda para ampliar el tiempo, o las posiciones con Ctrl; arrastre para desplazar; arrastre con Mayús para seleccionar un tiempo.</translation>
    </message>
    <message>
        <source>time since the step (s)</source>
        <translation>tiempo desde el escalón (s)</translation>
    </message>
    <message>
        <source>position from the start</source>
        <translation>posición desde el inicio</translation>
    </message>
    <message>
        <source>position from the start (%1)</source>
        <translation>posición desde el inicio (%1)</translation>
    </message>
    <message>
        <source>goal, command</source>
        <translation>destino, consigna</translation>
    </message>
    <message>
        <source>time since the start (s)</source>
        <translation>tiempo desde el inicio (s)</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseResults</name>
    <message>
        <source>Results of the runs shown</source>
        <translation>Resultados de los ensayos mostrados</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Subida, del 10 al 90 %</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>Error estacionario</translation>
    </message>
    <message>
        <source>Peak PWM, of 255</source>
        <translation>Pico de PWM, de 255</translation>
    </message>
    <message>
        <source>Sample interval</source>
        <translation>Intervalo de muestreo</translation>
    </message>
    <message>
        <source>Time from 10 % to 90 % of the step.</source>
        <translation>Tiempo del 10 % al 90 % del escalón.</translation>
    </message>
    <message>
        <source>How far the motor went past its goal, in % of the step.</source>
        <translation>Cuánto sobrepasó el motor su destino, en % del escalón.</translation>
    </message>
    <message>
        <source>Goal minus the mean position over the last fifth of the record.</source>
        <translation>Destino menos la posición media en la última quinta parte de la grabación.</translation>
    </message>
    <message>
        <source>PWM demand at the jump, calculated from the gains. Later ticks may need more: below the output limit OL this is a lower bound.</source>
        <translation>Demanda de PWM en el salto, calculada con las ganancias. Los ciclos posteriores pueden necesitar más: por debajo del límite de salida OL es una cota inferior.</translation>
    </message>
    <message>
        <source>Mean time between two positions of the record. It sets the accuracy of the results.</source>
        <translation>Tiempo medio entre dos posiciones de la grabación. Determina la exactitud de los resultados.</translation>
    </message>
    <message>
        <source>Settling to the goal</source>
        <translation>Establecimiento en destino</translation>
    </message>
    <message>
        <source>Settling to rest position</source>
        <translation>Establecimiento en reposo</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the goal. Empty if that happens only in the last fifth of the record.</source>
        <translation>Tiempo hasta que la posición permanece en la banda de establecimiento alrededor del destino. Vacío si eso solo ocurre en la última quinta parte de la grabación.</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the mean position of the last fifth of the record. Without integral gain (Ki, IL), friction holds a motor off its goal.</source>
        <translation>Lo mismo, alrededor de la posición media de la última quinta parte de la grabación. Sin ganancia integral (Ki, IL), el rozamiento retiene un motor fuera de su destino.</translation>
    </message>
    <message>
        <source>Move time</source>
        <translation>Duración del movimiento</translation>
    </message>
    <message>
        <source>Settling after the move</source>
        <translation>Establecimiento tras el movimiento</translation>
    </message>
    <message>
        <source>Settling, all moves</source>
        <translation>Establecimiento, todos</translation>
    </message>
    <message>
        <source>Peak error</source>
        <translation>Error máximo</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>Error eficaz</translation>
    </message>
    <message>
        <source>Error at constant velocity</source>
        <translation>Error a velocidad constante</translation>
    </message>
    <message>
        <source>Duration of the commanded profile, calculated from distance, velocity and acceleration.</source>
        <translation>Duración del perfil ordenado, calculada con la distancia, la velocidad y la aceleración.</translation>
    </message>
    <message>
        <source>Time from the end of the profile until the motor is in the window, where it stays for the dwell.</source>
        <translation>Tiempo desde el fin del perfil hasta que el motor está en la ventana, donde permanece.</translation>
    </message>
    <message>
        <source>The shortest and the longest settling time of the moves there and back, and their number.</source>
        <translation>El establecimiento más corto y el más largo de los movimientos de ida y vuelta, y su número.</translation>
    </message>
    <message>
        <source>The largest position error during the move and after it, without its sign.</source>
        <translation>El mayor error de posición durante el movimiento y después, sin su signo.</translation>
    </message>
    <message>
        <source>Root mean square of the position error during the move.</source>
        <translation>Valor eficaz del error de posición durante el movimiento.</translation>
    </message>
    <message>
        <source>Mean position error over the second half of the time at constant velocity.</source>
        <translation>Error de posición medio en la segunda mitad del tiempo a velocidad constante.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseTable</name>
    <message>
        <source>Step responses so far</source>
        <translation>Respuestas al escalón hasta ahora</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Establecimiento</translation>
    </message>
    <message>
        <source>Run %1 as A</source>
        <translation>Ensayo %1 como A</translation>
    </message>
    <message>
        <source>Run %1 as B</source>
        <translation>Ensayo %1 como B</translation>
    </message>
    <message>
        <source>Draws this run as A, with a solid line.</source>
        <translation>Dibuja este ensayo como A, con línea continua.</translation>
    </message>
    <message>
        <source>Draws this run as B, with a dashed line.</source>
        <translation>Dibuja este ensayo como B, con línea discontinua.</translation>
    </message>
    <message>
        <source>Step responses, newest first. Select two check boxes to compare the curves. The last %1 are saved with the machine; those with a name or a note are kept longest.</source>
        <translation>Respuestas al escalón, primero la más reciente. Marque dos casillas para comparar las curvas. Las últimas %1 se guardan con la máquina; las que tienen nombre o nota se conservan más tiempo.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Name of the run. Double-click or press F2 to edit.</source>
        <translation>Nombre del ensayo. Haga doble clic o pulse F2 para editarlo.</translation>
    </message>
    <message>
        <source>Note on the run. Double-click or press F2 to edit.</source>
        <translation>Nota sobre el ensayo. Haga doble clic o pulse F2 para editarla.</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseView</name>
    <message>
        <source>Run</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Encuadrar</translation>
    </message>
    <message>
        <source>Fits the view to the motion and all positions (A, in the plot).</source>
        <translation>Encuadra en la vista el movimiento y todas las posiciones (A, en la gráfica).</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C, in the plot).</source>
        <translation>Muestra dos cursores para medir: arrástrelos (C, en la gráfica).</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard.</source>
        <translation>Copia la gráfica visible al portapapeles.</translation>
    </message>
    <message>
        <source>Exports the visible plot, with a description of the runs.</source>
        <translation>Exporta la gráfica visible, con una descripción de los ensayos.</translation>
    </message>
    <message>
        <source>A: run %1, %2, %3, %4</source>
        <translation>A: ensayo %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>B: run %1, %2, %3, %4</source>
        <translation>B: ensayo %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>Kp %1 Kd %2 Ki %3 IL %4; rise %5; overshoot %6; settling %7</source>
        <translation>Kp %1 Kd %2 Ki %3 IL %4; subida %5; sobreimpulso %6; establecimiento %7</translation>
    </message>
    <message>
        <source>Step response, by NMC Panel %1</source>
        <translation>Respuesta al escalón, de NMC Panel %1</translation>
    </message>
    <message>
        <source>%1: cursor 1 %2, cursor 2 %3, difference %4</source>
        <translation>%1: cursor 1 %2, cursor 2 %3, diferencia %4</translation>
    </message>
    <message>
        <source>Picture of the step response</source>
        <translation>Imagen de la respuesta al escalón</translation>
    </message>
    <message>
        <source>step</source>
        <translation>escalón</translation>
    </message>
</context>
<context>
    <name>nmc::Ribbons</name>
    <message>
        <source>SIMULATOR — no hardware connected; all values are simulated</source>
        <translation>SIMULADOR — no hay hardware conectado; todos los valores son simulados</translation>
    </message>
    <message>
        <source>Simulated session</source>
        <translation>Sesión simulada</translation>
    </message>
    <message>
        <source>Read-only session</source>
        <translation>Sesión de solo lectura</translation>
    </message>
    <message>
        <source>READ-ONLY — only status requests are sent. STOP ALL still works.</source>
        <translation>SOLO LECTURA — solo se envían consultas de estado. PARAR TODO sigue funcionando.</translation>
    </message>
    <message>
        <source>Reconnects to the same port with commands allowed. Nothing moves.</source>
        <translation>Vuelve a conectar al mismo puerto con los comandos permitidos. Nada se mueve.</translation>
    </message>
    <message>
        <source>OPERATOR MODE — only allowed actions are available. STOP ALL always works.</source>
        <translation>MODO OPERADOR — solo están disponibles las acciones permitidas. PARAR TODO siempre funciona.</translation>
    </message>
    <message>
        <source>Leave…</source>
        <translation>Salir…</translation>
    </message>
    <message>
        <source>End pendant mode</source>
        <translation>Terminar modo de mando portátil</translation>
    </message>
    <message>
        <source>Hold Shift with ◂ or ▸ to move it. Esc ends pendant mode.</source>
        <translation>Mantenga pulsada Mayús con ◂ o ▸ para moverlo. Esc termina el modo de mando portátil.</translation>
    </message>
    <message>
        <source>Not moved: %1</source>
        <translation>No se movió: %1</translation>
    </message>
    <message>
        <source>PENDANT — %1. %2</source>
        <translation>MANDO PORTÁTIL — %1. %2</translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation>Mando portátil</translation>
    </message>
    <message>
        <source>Ends pendant mode: arrow keys and gamepad no longer move anything.</source>
        <translation>Termina el modo de mando portátil: las flechas y el gamepad ya no mueven nada.</translation>
    </message>
    <message>
        <source>To move it, hold Shift with ◂ or ▸, or a shoulder button of the gamepad with its left stick or D-pad. B (○) is STOP ALL. Esc ends pendant mode.</source>
        <translation>Para moverlo, mantenga pulsada Mayús con ◂ o ▸, o un botón superior del gamepad con su palanca izquierda o su cruceta. B (○) es PARAR TODO. Esc termina el modo de mando portátil.</translation>
    </message>
    <message>
        <source>End control</source>
        <translation>Terminar control</translation>
    </message>
    <message>
        <source>The program may no longer move motors.</source>
        <translation>El programa ya no puede mover motores.</translation>
    </message>
    <message>
        <source>PROGRAM — &quot;%1&quot; may move motors. Esc or any command of yours ends that.</source>
        <translation>PROGRAMA — «%1» puede mover motores. Esc o cualquier comando suyo lo termina.</translation>
    </message>
    <message>
        <source>PROGRAMS — none can connect now.</source>
        <translation>PROGRAMAS — ninguno puede conectarse ahora.</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect once a port is open.</source>
        <translation>PROGRAMAS — podrán conectarse cuando haya un puerto abierto.</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect at %1. Connected: %2.</source>
        <translation>PROGRAMAS — pueden conectarse por %1. Conectados: %2.</translation>
    </message>
    <message>
        <source>Line lent to a program</source>
        <translation>Línea prestada a un programa</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Dejar continuar</translation>
    </message>
    <message>
        <source>The program has the line again. It may move motors at once.</source>
        <translation>El programa tiene de nuevo la línea. Puede mover motores de inmediato.</translation>
    </message>
    <message>
        <source>End lending</source>
        <translation>Terminar el préstamo</translation>
    </message>
    <message>
        <source>The program loses the line, and the chain is scanned again. Nothing is reset or stopped.</source>
        <translation>El programa pierde la línea, y los módulos se buscan de nuevo. Nada se reinicia ni se para.</translation>
    </message>
    <message>
        <source>There is a jog wheel, but you may not read it. Unplug it and plug it in again; if that does not help, see the manual. Esc ends pendant mode.</source>
        <translation>Hay un volante conectado, pero no tiene permiso para leerlo. Desenchúfelo y vuelva a enchufarlo; si no sirve, consulte el manual. Esc termina el modo de mando portátil.</translation>
    </message>
    <message>
        <source>To move it, hold a button of the jog wheel, and push its ring or cap for a speed or turn the wheel for steps. The middle button, or the right one of a 3-axis mouse, is STOP ALL. Esc ends pendant mode.</source>
        <translation>Para moverlo, mantenga pulsado un botón del volante y desvíe el anillo o la tapa para una velocidad, o gire el volante para dar pasos. El botón central, o el derecho de un ratón de 3 ejes, es PARAR TODO. Esc termina el modo de mando portátil.</translation>
    </message>
</context>
<context>
    <name>nmc::RowDelegate</name>
    <message>
        <source>Value of the row</source>
        <translation>Valor de la fila</translation>
    </message>
    <message>
        <source>The value</source>
        <translation>El valor</translation>
    </message>
    <message>
        <source>Choices of the row</source>
        <translation>Opciones de la fila</translation>
    </message>
</context>
<context>
    <name>nmc::RowsModel</name>
    <message>
        <source>from row %1 on</source>
        <translation>desde la fila %1</translation>
    </message>
    <message>
        <source>together</source>
        <translation>a la vez</translation>
    </message>
    <message>
        <source>together, next row at once</source>
        <translation>a la vez, fila siguiente de inmediato</translation>
    </message>
    <message>
        <source>one after the other</source>
        <translation>uno tras otro</translation>
    </message>
    <message>
        <source>one after the other, next row at once</source>
        <translation>uno tras otro, fila siguiente de inmediato</translation>
    </message>
    <message>
        <source>%1 active</source>
        <translation>%1 activo</translation>
    </message>
    <message>
        <source>%1 not active</source>
        <translation>%1 no activo</translation>
    </message>
    <message>
        <source>output %1 on</source>
        <translation>activar salida %1</translation>
    </message>
    <message>
        <source>output %1 off</source>
        <translation>desactivar salida %1</translation>
    </message>
    <message>
        <source>%1 % of its velocity</source>
        <translation>%1 % de su velocidad</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>within %1 s</source>
        <translation>máx. %1 s</translation>
    </message>
    <message>
        <source>forever</source>
        <translation>sin fin</translation>
    </message>
    <message numerus="yes">
        <source>%n times in all</source>
        <translation>
            <numerusform>%n vez en total</numerusform>
            <numerusform>%n veces en total</numerusform>
        </translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>%1 alto</translation>
    </message>
    <message>
        <source>%1 low</source>
        <translation>%1 bajo</translation>
    </message>
    <message>
        <source>IO%1 high</source>
        <translation>IO%1 alto</translation>
    </message>
    <message>
        <source>IO%1 low</source>
        <translation>IO%1 bajo</translation>
    </message>
    <message>
        <source>A/D %1 above</source>
        <translation>A/D %1 mayor que</translation>
    </message>
    <message>
        <source>A/D %1 below</source>
        <translation>A/D %1 menor que</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Plazo</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeBar</name>
    <message>
        <source>Freezes the display (Ctrl+P). Recording of samples continues.</source>
        <translation>Congela la imagen (Ctrl+P). Las muestras se siguen grabando.</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C).</source>
        <translation>Muestra dos cursores para medir: arrástrelos (C).</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Bits de estado</translation>
    </message>
    <message>
        <source>Shows the status bits of the selected module over time (B).</source>
        <translation>Muestra los bits de estado del módulo seleccionado a lo largo del tiempo (B).</translation>
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
        <translation>Tiempo mostrado por el osciloscopio</translation>
    </message>
    <message>
        <source>Sets how much time the scope shows.</source>
        <translation>Define cuánto tiempo muestra el osciloscopio.</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>Ran&amp;go</translation>
    </message>
    <message>
        <source>Signals…</source>
        <translation>Señales…</translation>
    </message>
    <message>
        <source>Selects signals for the strips (S).</source>
        <translation>Selecciona las señales de las franjas (S).</translation>
    </message>
    <message>
        <source>Waits for a signal or a status bit, and holds the picture around it (T).</source>
        <translation>Espera una señal o un bit de estado y retiene la imagen alrededor (T).</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Volver al presente</translation>
    </message>
    <message>
        <source>Returns to the live display.</source>
        <translation>Vuelve a la imagen en vivo.</translation>
    </message>
    <message>
        <source>Source of the picture</source>
        <translation>Fuente de la imagen</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeExport</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>&amp;Samples (CSV)…</source>
        <translation>Mue&amp;stras (CSV)…</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard, with its samples if there are only a few.</source>
        <translation>Copia la gráfica visible al portapapeles, con sus muestras si son pocas.</translation>
    </message>
    <message>
        <source>Export from the scope</source>
        <translation>Exportar del osciloscopio</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>osciloscopio</translation>
    </message>
    <message>
        <source>All samples of all modules in the visible time. A file with one row per reply can be reopened here; one with a column per signal is for other programs only.</source>
        <translation>Todas las muestras de todos los módulos en el tiempo visible. Un archivo con una fila por respuesta se puede volver a abrir aquí; con una columna por señal es solo para otros programas.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeFiles</name>
    <message>
        <source>Open &amp;recording…</source>
        <translation>Abrir g&amp;rabación…</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Detener grabación</translation>
    </message>
    <message>
        <source>Ends the recording and closes its file (Ctrl+Shift+R).</source>
        <translation>Termina la grabación y cierra su archivo (Ctrl+Mayús+R).</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Abriendo</translation>
    </message>
    <message>
        <source>Cancels opening; the scope stays as it is.</source>
        <translation>Cancela la apertura; el osciloscopio queda como está.</translation>
    </message>
    <message>
        <source>Shows a recording in the scope. Control of the motors continues.</source>
        <translation>Muestra una grabación en el osciloscopio. El control de los motores continúa.</translation>
    </message>
    <message>
        <source>Saves every sample of all modules to a file from now on (Ctrl+Shift+R).</source>
        <translation>Guarda desde ahora todas las muestras de todos los módulos en un archivo (Ctrl+Mayús+R).</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Grabar…</translation>
    </message>
    <message>
        <source>Nothing to record: connect a module first.</source>
        <translation>Nada que grabar: conecte primero un módulo.</translation>
    </message>
    <message>
        <source>● Recording %1, %2, %3</source>
        <translation>● Grabando %1, %2, %3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Opening %1, %2 %</source>
        <translation>Abriendo %1, %2 %</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>Grabar en un archivo</translation>
    </message>
    <message>
        <source>Recordings (*.%1)</source>
        <translation>Grabaciones (*.%1)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Abrir grabación</translation>
    </message>
    <message>
        <source>Over&amp;lay a recording…</source>
        <translation>S&amp;uperponer una grabación…</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposición</translation>
    </message>
    <message>
        <source>Removes the recording from the plots. Its file is kept.</source>
        <translation>Quita la grabación de las gráficas. Su archivo se conserva.</translation>
    </message>
    <message>
        <source>◂ Earlier</source>
        <translation>◂ Anterior</translation>
    </message>
    <message>
        <source>Moves the recording to the left.</source>
        <translation>Desplaza la grabación a la izquierda.</translation>
    </message>
    <message>
        <source>Later ▸</source>
        <translation>Posterior ▸</translation>
    </message>
    <message>
        <source>Moves the recording to the right.</source>
        <translation>Desplaza la grabación a la derecha.</translation>
    </message>
    <message>
        <source>Draws a recording in pale lines below the live traces, aligned to the start of the last motion.</source>
        <translation>Dibuja una grabación en líneas pálidas bajo las curvas en vivo, alineada con el inicio del último movimiento.</translation>
    </message>
    <message>
        <source>Overlay a recording</source>
        <translation>Superponer una grabación</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePanel</name>
    <message>
        <source>Exports the visible samples or a picture.</source>
        <translation>Exporta las muestras visibles o una imagen.</translation>
    </message>
    <message>
        <source>Bits of the lane</source>
        <translation>Bits de la banda</translation>
    </message>
    <message>
        <source>%1 (simulator)</source>
        <translation>%1 (simulador)</translation>
    </message>
    <message>
        <source>Saves and restores arrangements of the scope by name.</source>
        <translation>Guarda y restaura disposiciones del osciloscopio por su nombre.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePlot</name>
    <message>
        <source>%1 · unknown</source>
        <translation>%1 · desconocido</translation>
    </message>
    <message>
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The band exceeds the strip: %1 to %2</source>
        <translation>La banda supera la franja: de %1 a %2</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePresets</name>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>&amp;Remove preset</source>
        <translation>&amp;Quitar preajuste</translation>
    </message>
    <message>
        <source>Remove preset</source>
        <translation>Quitar preajuste</translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>&amp;Guardar como preajuste…</translation>
    </message>
    <message>
        <source>Keeps the present signals, strips, bits and time under a name.</source>
        <translation>Conserva las señales, franjas, bits y tiempo actuales con un nombre.</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Guardar como preajuste</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Replaces the preset of that name.</source>
        <translation>Sustituye el preajuste con ese nombre.</translation>
    </message>
    <message>
        <source>There are %1 presets, which is the most. Remove one first.</source>
        <translation>Ya hay %1 preajustes, que es el máximo. Quite uno primero.</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeStrips</name>
    <message>
        <source>Plots; arrow keys move, plus and minus zoom</source>
        <translation>Gráficas; las flechas desplazan, más y menos amplían o reducen</translation>
    </message>
    <message>
        <source>Strip %1 of the scope</source>
        <translation>Franja %1 del osciloscopio</translation>
    </message>
    <message>
        <source>Drag to resize the strips. Double-click to make them equal.</source>
        <translation>Arrastre para cambiar la altura de las franjas. Un doble clic las iguala.</translation>
    </message>
</context>
<context>
    <name>nmc::SequencesPage</name>
    <message>
        <source>Rename point</source>
        <translation>Cambiar nombre del punto</translation>
    </message>
    <message>
        <source>Change row</source>
        <translation>Cambiar fila</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Name of the point to teach</source>
        <translation>Nombre del punto que se memoriza</translation>
    </message>
    <message>
        <source>Name of a point</source>
        <translation>Nombre de un punto</translation>
    </message>
    <message>
        <source>Axes to teach</source>
        <translation>Ejes que se memorizan</translation>
    </message>
    <message>
        <source>The selected axes become part of the point.</source>
        <translation>Los ejes marcados pasan a formar parte del punto.</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Memorizar</translation>
    </message>
    <message>
        <source>Teach a point: store the positions of the selected axes</source>
        <translation>Memorizar un punto: guardar las posiciones de los ejes marcados</translation>
    </message>
    <message>
        <source>Go to point</source>
        <translation>Ir al punto</translation>
    </message>
    <message>
        <source>Go to point: the selected one</source>
        <translation>Ir al punto seleccionado</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Quitar punto</translation>
    </message>
    <message>
        <source>Remove point: the selected one</source>
        <translation>Quitar punto: el seleccionado</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Secuencias</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Secuencia</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>Nombre de la secuencia</translation>
    </message>
    <message>
        <source>Type a new name for this sequence, then press Enter.</source>
        <translation>Escriba un nombre nuevo para esta secuencia y pulse Intro.</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Nueva secuencia</translation>
    </message>
    <message>
        <source>Remove sequence</source>
        <translation>Quitar secuencia</translation>
    </message>
    <message>
        <source>Remove sequence with its rows</source>
        <translation>Quitar secuencia con sus filas</translation>
    </message>
    <message>
        <source>Rows of the sequence</source>
        <translation>Filas de la secuencia</translation>
    </message>
    <message>
        <source>Double-click a cell or press F2 to edit it.</source>
        <translation>Haga doble clic en una celda o pulse F2 para editarla.</translation>
    </message>
    <message>
        <source>Result of the dry run</source>
        <translation>Resultado de la simulación</translation>
    </message>
    <message>
        <source>Rename sequence</source>
        <translation>Cambiar nombre de la secuencia</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Añadir fila</translation>
    </message>
    <message>
        <source>Add row after the selected one</source>
        <translation>Añadir fila después de la seleccionada</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate the selected row</source>
        <translation>Duplicar la fila seleccionada</translation>
    </message>
    <message>
        <source>Duplicate row</source>
        <translation>Duplicar fila</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Quitar fila</translation>
    </message>
    <message>
        <source>Remove row: the selected one</source>
        <translation>Quitar fila: la seleccionada</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Up: move the selected row</source>
        <translation>Subir: mover la fila seleccionada</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Down: move the selected row</source>
        <translation>Bajar: mover la fila seleccionada</translation>
    </message>
    <message>
        <source>Undo the last change to points and sequences</source>
        <translation>Deshacer el último cambio en puntos y secuencias</translation>
    </message>
    <message>
        <source>Redo the last undone change to points and sequences</source>
        <translation>Rehacer el último cambio deshecho en puntos y secuencias</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Simular</translation>
    </message>
    <message>
        <source>Dry run: simulate the sequence; nothing moves</source>
        <translation>Simular la secuencia; nada se mueve</translation>
    </message>
    <message>
        <source>Dry run…</source>
        <translation>Simulando…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Run the sequence</source>
        <translation>Ejecutar la secuencia</translation>
    </message>
    <message>
        <source>Run from row</source>
        <translation>Ejecutar desde fila</translation>
    </message>
    <message>
        <source>Run from row: start at the selected row</source>
        <translation>Ejecutar desde fila: empezar en la seleccionada</translation>
    </message>
    <message>
        <source>Pause the sequence after its row</source>
        <translation>Pausa de la secuencia tras su fila</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>Fila a fila</translation>
    </message>
    <message>
        <source>Single step: run one row of the sequence</source>
        <translation>Fila a fila: ejecutar una fila de la secuencia</translation>
    </message>
    <message>
        <source>Stop sequence</source>
        <translation>Parar secuencia</translation>
    </message>
    <message>
        <source>Stop sequence and its motors</source>
        <translation>Parar secuencia y sus motores</translation>
    </message>
    <message>
        <source>Teach point</source>
        <translation>Memorizar punto</translation>
    </message>
    <message>
        <source>Move row</source>
        <translation>Mover fila</translation>
    </message>
    <message>
        <source>Enter a name for the point first.</source>
        <translation>Introduzca primero un nombre para el punto.</translation>
    </message>
    <message>
        <source>Select at least one axis.</source>
        <translation>Marque al menos un eje.</translation>
    </message>
    <message>
        <source>Stores the present positions of the selected axes under this name, replacing any point of that name. Nothing moves.</source>
        <translation>Guarda las posiciones actuales de los ejes marcados con este nombre y sustituye el punto que ya se llame así. Nada se mueve.</translation>
    </message>
    <message>
        <source>Select a point in the table.</source>
        <translation>Seleccione un punto en la tabla.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses this point. Change that row first.</source>
        <translation>La fila %1 de “%2” usa este punto. Cambie primero esa fila.</translation>
    </message>
    <message>
        <source>Moves all axes of this point there together, each at its own velocity.</source>
        <translation>Lleva a la vez todos los ejes de este punto hasta él, cada uno a su propia velocidad.</translation>
    </message>
    <message>
        <source>Removes this point; nothing moves.</source>
        <translation>Quita este punto; nada se mueve.</translation>
    </message>
    <message>
        <source>No sequence yet. Add one first.</source>
        <translation>Aún no hay secuencias. Añada primero una.</translation>
    </message>
    <message>
        <source>Select a row in the table.</source>
        <translation>Seleccione una fila en la tabla.</translation>
    </message>
    <message>
        <source>Adds an empty sequence.</source>
        <translation>Añade una secuencia vacía.</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; calls this sequence. Change that row first.</source>
        <translation>La fila %1 de “%2” llama a esta secuencia. Cambie primero esa fila.</translation>
    </message>
    <message>
        <source>Removes this sequence with its rows.</source>
        <translation>Quita esta secuencia con sus filas.</translation>
    </message>
    <message>
        <source>Adds a row after the selected one, or at the end.</source>
        <translation>Añade una fila después de la seleccionada o al final.</translation>
    </message>
    <message>
        <source>Adds a copy of the row after it.</source>
        <translation>Añade detrás una copia de la fila.</translation>
    </message>
    <message>
        <source>Removes this row.</source>
        <translation>Quita esta fila.</translation>
    </message>
    <message>
        <source>The row cannot move farther: a repeat must stay below the row it goes back to.</source>
        <translation>La fila no puede moverse más: una repetición debe quedar debajo de la fila a la que vuelve.</translation>
    </message>
    <message>
        <source>Moves this row up.</source>
        <translation>Sube esta fila.</translation>
    </message>
    <message>
        <source>Moves this row down.</source>
        <translation>Baja esta fila.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Deshacer: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rehacer: %1</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from its first row.</source>
        <translation>Ejecuta “%1” desde su primera fila.</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from the selected row on. The axes must be where the rows above leave them.</source>
        <translation>Ejecuta “%1” desde la fila seleccionada. Los ejes deben estar donde los dejan las filas de arriba.</translation>
    </message>
    <message>
        <source>No sequence is running.</source>
        <translation>No hay ninguna secuencia en ejecución.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Continues from where it paused.</source>
        <translation>Continúa desde donde hizo la pausa.</translation>
    </message>
    <message>
        <source>Finishes the current row, then waits.</source>
        <translation>Termina la fila actual y después espera.</translation>
    </message>
    <message>
        <source>The sequence is running. Pause it first.</source>
        <translation>La secuencia está en ejecución. Póngala primero en pausa.</translation>
    </message>
    <message>
        <source>Runs one row, then waits. Starts with the selected row.</source>
        <translation>Ejecuta una fila y después espera. Empieza por la fila seleccionada.</translation>
    </message>
    <message>
        <source>Ends the sequence and stops its motors smoothly.</source>
        <translation>Termina la secuencia y detiene sus motores suavemente.</translation>
    </message>
    <message>
        <source>End dry run</source>
        <translation>Terminar simulación</translation>
    </message>
    <message>
        <source>Simulates the sequence: shows how long it takes, where each axis goes and what would be refused. Nothing moves.</source>
        <translation>Simula la secuencia: muestra cuánto tarda, adónde va cada eje y qué se rechazaría. Nada se mueve.</translation>
    </message>
</context>
<context>
    <name>nmc::ServoPanel</name>
    <message>
        <source>Servo module</source>
        <translation>Módulo servo</translation>
    </message>
    <message>
        <source>Limits &amp;&amp; I/O</source>
        <translation>Finales &amp;&amp; E/S</translation>
    </message>
</context>
<context>
    <name>nmc::SignalsDialog</name>
    <message>
        <source>Signals of the scope</source>
        <translation>Señales del osciloscopio</translation>
    </message>
    <message>
        <source>Signals and their strips</source>
        <translation>Señales y sus franjas</translation>
    </message>
    <message>
        <source>Strip %1</source>
        <translation>Franja %1</translation>
    </message>
    <message>
        <source>Select the strips of each signal. Empty strips are hidden.</source>
        <translation>Seleccione las franjas de cada señal. Las franjas vacías se ocultan.</translation>
    </message>
    <message>
        <source>The selected module</source>
        <translation>El módulo seleccionado</translation>
    </message>
    <message>
        <source>&amp;Usual signals</source>
        <translation>Señales habit&amp;uales</translation>
    </message>
    <message>
        <source>Usual signals</source>
        <translation>Señales habituales</translation>
    </message>
    <message>
        <source>%1: %2 in strip %3</source>
        <translation>%1: %2 en la franja %3</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Filter by module or signal</source>
        <translation>Filtro por módulo o señal</translation>
    </message>
    <message>
        <source>Position and command position, with the error and the motor current below.</source>
        <translation>Posición y posición de consigna, con el error y la corriente del motor debajo.</translation>
    </message>
    <message>
        <source>&amp;Custom traces…</source>
        <translation>Trazas &amp;propias…</translation>
    </message>
    <message>
        <source>Custom traces</source>
        <translation>Trazas propias</translation>
    </message>
    <message>
        <source>Traces of your own, from one or two signals.</source>
        <translation>Trazas propias, a partir de una o dos señales.</translation>
    </message>
</context>
<context>
    <name>nmc::SimulatorBench</name>
    <message>
        <source>Simulated module</source>
        <translation>Módulo simulado</translation>
    </message>
    <message>
        <source>Follows the module list, and includes modules that the panel did not find.</source>
        <translation>Sigue la lista de módulos e incluye los que el panel no encontró.</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumDialog</name>
    <message>
        <source>Peak</source>
        <translation>Pico</translation>
    </message>
    <message>
        <source>Spectrum between the cursors</source>
        <translation>Espectro entre los cursores</translation>
    </message>
    <message>
        <source>&amp;Signal</source>
        <translation>&amp;Señal</translation>
    </message>
    <message>
        <source>Peak: %1 Hz, amplitude %2 %3</source>
        <translation>Pico: %1 Hz, amplitud %2 %3</translation>
    </message>
    <message>
        <source>No oscillation stands out from the noise.</source>
        <translation>Ninguna oscilación destaca sobre el ruido.</translation>
    </message>
    <message>
        <source>From %1 Hz, two periods between the cursors, to %2 Hz, nearly half the rate of the samples.</source>
        <translation>De %1 Hz, dos periodos entre los cursores, a %2 Hz, casi la mitad de la frecuencia de las muestras.</translation>
    </message>
    <message>
        <source>There is a long gap between the cursors. Move both to the same side of it.</source>
        <translation>Hay un hueco largo entre los cursores. Mueva ambos al mismo lado del hueco.</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>The sines in the signal, by frequency in Hz. The circle marks the highest that stands out from the noise. Double-click to show everything. Scroll to zoom the frequency, or the amplitudes with Ctrl; drag to pan; drag with Shift to select frequencies.</source>
        <translation>Las ondas senoidales de la señal, por frecuencia en Hz. El círculo marca la más alta que destaca sobre el ruido. Doble clic para mostrar todo. Rueda para ampliar la frecuencia, o las amplitudes con Ctrl; arrastre para desplazar; arrastre con Mayús para seleccionar frecuencias.</translation>
    </message>
</context>
<context>
    <name>nmc::SquarePlot</name>
    <message>
        <source>Square wave, one period</source>
        <translation>Onda cuadrada, un período</translation>
    </message>
    <message>
        <source>median, %1</source>
        <translation>mediana, %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>consigna</translation>
    </message>
    <message>
        <source>No edge recorded yet. A square wave overlays many steps while you change gains.</source>
        <translation>Aún no se ha grabado ningún flanco. Una onda cuadrada superpone muchos escalones mientras usted cambia las ganancias.</translation>
    </message>
    <message>
        <source>All edges with the present gains, overlaid: the line is their median, the shaded band holds 80 % of the samples. Pale: the previous gains. Double-click to show everything. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>Todos los flancos con las ganancias actuales, superpuestos: la línea es su mediana; la banda sombreada contiene el 80 % de las muestras. En tono pálido: las ganancias anteriores. Doble clic para mostrar todo. Rueda para ampliar el tiempo, o las posiciones con Ctrl; arrastre para desplazar; arrastre con Mayús para seleccionar un tiempo.</translation>
    </message>
</context>
<context>
    <name>nmc::SquareWavePage</name>
    <message>
        <source>Start test</source>
        <translation>Iniciar prueba</translation>
    </message>
    <message>
        <source>The motor jumps back and forth around its position. Make sure that everything it drives can move freely.</source>
        <translation>El motor salta de un lado a otro de su posición. Asegúrese de que todo lo que acciona puede moverse libremente.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>The distance</source>
        <translation>La distancia</translation>
    </message>
    <message>
        <source>From side to side: half to either side of the present position.</source>
        <translation>De lado a lado: la mitad a cada lado de la posición actual.</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Período</translation>
    </message>
    <message>
        <source>The period</source>
        <translation>El período</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Períodos</translation>
    </message>
    <message>
        <source>Periods to run</source>
        <translation>Períodos que ejecutar</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>Desviación</translation>
    </message>
    <message>
        <source>How far the motor may move past either side. Beyond that, the test stops and the motor holds.</source>
        <translation>Cuánto puede sobrepasar el motor cada lado. Más allá, la prueba se detiene y el motor mantiene la posición.</translation>
    </message>
    <message>
        <source>Results of the edges</source>
        <translation>Resultados de los flancos</translation>
    </message>
    <message>
        <source>Keep as a run</source>
        <translation>Guardar como ensayo</translation>
    </message>
    <message>
        <source>Keep as a run: the median edge</source>
        <translation>Guardar como ensayo: la mediana de los flancos</translation>
    </message>
    <message>
        <source>Settling %1</source>
        <translation>Establecimiento %1</translation>
    </message>
    <message>
        <source>No edge recorded yet.</source>
        <translation>Aún no se ha grabado ningún flanco.</translation>
    </message>
    <message>
        <source>Adds the median of the rising edges to the list of step responses.</source>
        <translation>Añade la mediana de los flancos de subida a la lista de respuestas al escalón.</translation>
    </message>
    <message>
        <source>Edges with these gains: %1</source>
        <translation>Flancos con estas ganancias: %1</translation>
    </message>
</context>
<context>
    <name>nmc::StagedForm</name>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ enviado</translation>
    </message>
    <message>
        <source>● not sent</source>
        <translation>● sin enviar</translation>
    </message>
    <message>
        <source>Undoes the last edit in these fields. Sends nothing.</source>
        <translation>Deshace la última edición de estos campos. No envía nada.</translation>
    </message>
    <message>
        <source>Redoes the edit that was undone. Sends nothing.</source>
        <translation>Rehace la edición que se deshizo. No envía nada.</translation>
    </message>
    <message>
        <source>No changes to apply.</source>
        <translation>No hay cambios que aplicar.</translation>
    </message>
</context>
<context>
    <name>nmc::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Start the simulator</source>
        <translation>Iniciar el simulador</translation>
    </message>
    <message>
        <source>Needs no hardware. Three simulated modules to try everything on; no real motor moves.</source>
        <translation>No requiere hardware. Tres módulos simulados para probarlo todo; no se mueve ningún motor real.</translation>
    </message>
    <message>
        <source>Connects to the built-in simulator.</source>
        <translation>Conecta al simulador integrado.</translation>
    </message>
    <message>
        <source>Choose a serial port…</source>
        <translation>Elegir un puerto serie…</translation>
    </message>
    <message>
        <source>No serial port found. Plug in the modules&apos; adapter; it then appears here.</source>
        <translation>No se encontró ningún puerto serie. Conecte el adaptador de los módulos: aparecerá aquí.</translation>
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
        <translation>Conectar a %1</translation>
    </message>
    <message>
        <source>The modules must be powered and their cable plugged in.</source>
        <translation>Requiere los módulos alimentados y su cable conectado.</translation>
    </message>
    <message>
        <source>Other ports are in the list above.</source>
        <translation>Los demás puertos están en la lista de arriba.</translation>
    </message>
</context>
<context>
    <name>nmc::StatusLane</name>
    <message>
        <source>Status bits over time</source>
        <translation>Bits de estado a lo largo del tiempo</translation>
    </message>
</context>
<context>
    <name>nmc::StepperIoBox</name>
    <message>
        <source>Set all outputs</source>
        <translation>Fijar todas las salidas</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entradas y salidas</translation>
    </message>
    <message>
        <source>OUT%1</source>
        <translation>OUT%1</translation>
    </message>
    <message>
        <source>Name of output %1</source>
        <translation>Nombre de la salida %1</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>Name of input %1</source>
        <translation>Nombre de la entrada %1</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorado</translation>
    </message>
    <message>
        <source>keeps the motor from moving</source>
        <translation>impide que el motor se mueva</translation>
    </message>
    <message>
        <source>blocks forward</source>
        <translation>bloquea hacia adelante</translation>
    </message>
    <message>
        <source>blocks reverse</source>
        <translation>bloquea hacia atrás</translation>
    </message>
    <message>
        <source>● %1, not sent</source>
        <translation>● %1, sin enviar</translation>
    </message>
    <message>
        <source>Selects the level. Choose Set all outputs to send all five.</source>
        <translation>Selecciona el nivel. Elija “Fijar todas las salidas” para enviar las cinco.</translation>
    </message>
    <message>
        <source>Select a level for all five outputs first.</source>
        <translation>Seleccione primero un nivel para las cinco salidas.</translation>
    </message>
    <message>
        <source>Sends all five outputs as selected above.</source>
        <translation>Envía las cinco salidas tal como se seleccionaron arriba.</translation>
    </message>
    <message>
        <source>Outputs unknown: they cannot be read back. Select all five levels, then set them.</source>
        <translation>Salidas desconocidas: no se pueden leer del módulo. Seleccione los cinco niveles y después fíjelos.</translation>
    </message>
</context>
<context>
    <name>nmc::StepperMotionBox</name>
    <message>
        <source>b&amp;y this distance</source>
        <translation>en es&amp;ta distancia</translation>
    </message>
    <message>
        <source>By this distance from the present position</source>
        <translation>En esta distancia desde la posición actual</translation>
    </message>
    <message>
        <source>The speed</source>
        <translation>La velocidad</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>Pos&amp;ición</translation>
    </message>
    <message>
        <source>Trave&amp;l speed</source>
        <translation>Ve&amp;locidad de avance</translation>
    </message>
    <message>
        <source>Load o&amp;nly</source>
        <translation>S&amp;olo cargar</translation>
    </message>
    <message>
        <source>Load only, start later</source>
        <translation>Solo cargar, iniciar después</translation>
    </message>
    <message>
        <source>Start loaded</source>
        <translation>Iniciar lo cargado</translation>
    </message>
    <message>
        <source>Start loaded motion</source>
        <translation>Iniciar lo cargado: el movimiento</translation>
    </message>
    <message>
        <source>How fast the motor turns: %1 to %2 in this speed mode. The chip uses the nearest speed available.</source>
        <translation>A qué velocidad gira el motor: de %1 a %2 en este modo de velocidad. El chip usa la velocidad disponible más próxima.</translation>
    </message>
    <message>
        <source>At constant speed, without a ramp.</source>
        <translation>A velocidad constante, sin rampa.</translation>
    </message>
    <message>
        <source>Takes %1 s from standstill.</source>
        <translation>Tarda %1 s desde parado.</translation>
    </message>
    <message>
        <source>Stop, wait: %1</source>
        <translation>Parar, esperar: %1</translation>
    </message>
    <message>
        <source>Loads the motion without starting it.</source>
        <translation>Carga el movimiento sin iniciarlo.</translation>
    </message>
    <message>
        <source>Load &amp;reverse</source>
        <translation>Cargar at&amp;rás</translation>
    </message>
    <message>
        <source>Load forward</source>
        <translation>Cargar adelante</translation>
    </message>
    <message>
        <source>Starts the loaded motion.</source>
        <translation>Inicia el movimiento cargado.</translation>
    </message>
    <message>
        <source>A run has no goal.</source>
        <translation>Una marcha no tiene destino.</translation>
    </message>
    <message>
        <source>The goal of the move. Press Enter to start.</source>
        <translation>El destino del movimiento. Pulse Intro para iniciarlo.</translation>
    </message>
    <message>
        <source>The distance counts from where the motor is at the start.</source>
        <translation>La distancia se cuenta desde donde está el motor al iniciarse.</translation>
    </message>
    <message>
        <source>The buttons only load the motion. Choose Start loaded, or start the module&apos;s group.</source>
        <translation>Los botones solo cargan el movimiento. Elija “Iniciar lo cargado” o inicie el grupo del módulo.</translation>
    </message>
    <message>
        <source>No ramp.</source>
        <translation>Sin rampa.</translation>
    </message>
    <message>
        <source>Stops smoothly, waits until the motor is at rest, then: %1</source>
        <translation>Se detiene suavemente, espera a que el motor esté parado y después: %1</translation>
    </message>
    <message>
        <source>Moves to home with a ramp, at the travel speed.</source>
        <translation>Va a la referencia con rampa, a la velocidad de avance.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Moves to a position with ramps (trapezoidal profile mode).</source>
        <translation>Va a una posición con rampas (modo de perfil trapezoidal).</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcha</translation>
    </message>
    <message>
        <source>Ramps to a speed and keeps it until stopped (velocity profile mode).</source>
        <translation>Sube en rampa hasta una velocidad y la conserva hasta que se le ordene parar (modo de perfil de velocidad).</translation>
    </message>
    <message>
        <source>Move without ramp</source>
        <translation>Movimiento sin rampa</translation>
    </message>
    <message>
        <source>Moves to a position at constant speed, without ramps. At too high a speed the motor loses steps (unprofiled, with stop).</source>
        <translation>Va a una posición a velocidad constante, sin rampas. Si la velocidad es excesiva, el motor pierde pasos (sin perfil, con parada).</translation>
    </message>
    <message>
        <source>Run without ramp</source>
        <translation>Marcha sin rampa</translation>
    </message>
    <message>
        <source>Runs at constant speed, without a ramp, until stopped. At too high a speed the motor loses steps (unprofiled, without stop).</source>
        <translation>Gira a velocidad constante, sin rampa, hasta que se le ordene parar. Si la velocidad es excesiva, el motor pierde pasos (sin perfil, sin parada).</translation>
    </message>
    <message>
        <source>Kind of motion</source>
        <translation>Tipo de movimiento</translation>
    </message>
</context>
<context>
    <name>nmc::StepperPanel</name>
    <message>
        <source>Stepper module</source>
        <translation>Módulo paso a paso</translation>
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
        <translation>ignorados: no detienen nada</translation>
    </message>
    <message>
        <source>motor switches off, too</source>
        <translation>también se apaga el motor</translation>
    </message>
    <message>
        <source>&amp;Apply parameters</source>
        <translation>Aplicar parámetro&amp;s</translation>
    </message>
    <message>
        <source>Revert the parameters to those last sent</source>
        <translation>Revertir los parámetros a los últimos enviados</translation>
    </message>
    <message>
        <source>Apply parameters: all</source>
        <translation>Aplicar parámetros: todos</translation>
    </message>
    <message>
        <source>Fills in low speeds and currents to start with. Sends nothing.</source>
        <translation>Rellena velocidades y corrientes bajas para empezar. No envía nada.</translation>
    </message>
    <message>
        <source>Choose a speed mode.</source>
        <translation>Elija un modo de velocidad.</translation>
    </message>
    <message>
        <source>Parameters cannot be read back from the module. The motor moves only after you apply them.</source>
        <translation>Los parámetros no se pueden leer del módulo. El motor solo se mueve después de que los aplique.</translation>
    </message>
    <message>
        <source>If checked, the E-stop input does not stop the motor.</source>
        <translation>Si está marcado, la entrada E-Stop no detiene el motor.</translation>
    </message>
    <message>
        <source>If checked, the limit switches do not stop the motor.</source>
        <translation>Si está marcado, los finales de carrera no detienen el motor.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.</source>
        <translation>Envía todos los parámetros a la vez. El amplificador está encendido: las corrientes y los límites actúan de inmediato.</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The motor does not move.</source>
        <translation>Envía todos los parámetros a la vez. El motor no se mueve.</translation>
    </message>
    <message>
        <source>Restores the parameters last sent. Sends nothing.</source>
        <translation>Restaura los últimos parámetros enviados. No envía nada.</translation>
    </message>
    <message>
        <source>Clears the fields: no parameters have been sent yet. Sends nothing.</source>
        <translation>Vacía los campos: aún no se han enviado parámetros. No envía nada.</translation>
    </message>
    <message>
        <source>Undo the last edit of a parameter</source>
        <translation>Deshacer la última edición de un parámetro</translation>
    </message>
    <message>
        <source>Redo the edit of a parameter</source>
        <translation>Rehacer la edición de un parámetro</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>Modo de velocidad</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>Velocidad mínima del perfil</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>Corriente de marcha</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>Corriente de retención</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>Límite térmico</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>Finales de carrera</translation>
    </message>
    <message>
        <source>On limit or E-stop</source>
        <translation>Con final de carrera o E-Stop</translation>
    </message>
    <message>
        <source>The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.</source>
        <translation>El reloj del temporizador de pasos. Un reloj más rápido alcanza velocidades mayores con saltos más gruesos: use el más lento que baste. Cambiarlo cambia el significado de todas las velocidades y rampas.</translation>
    </message>
    <message>
        <source>The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.</source>
        <translation>La velocidad a la que empiezan y terminan las rampas. El motor debe poder arrancar y parar a esta velocidad sin perder pasos. Las marchas y los movimientos con rampa nunca son más lentos.</translation>
    </message>
    <message>
        <source>Motor current while moving; 255 is the driver&apos;s full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.</source>
        <translation>Corriente del motor en movimiento; 255 es toda la corriente del driver. 0: sin corriente, y el motor no sigue los pasos. No supere los valores nominales del motor ni del driver.</translation>
    </message>
    <message>
        <source>Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and no holding torque.</source>
        <translation>Corriente del motor parado, desde unos 0,25 s después de un movimiento. Suele ser menor que la de marcha, para que el motor no se caliente. 0: sin corriente, y el motor no retiene nada.</translation>
    </message>
    <message>
        <source>The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.</source>
        <translation>El módulo apaga el motor cuando el valor A/D cae por debajo de este límite: la tensión de un puente con termistor baja cuando el motor se calienta. 0: inactivo. Para hallar el límite correcto, observe el valor A/D con el motor caliente.</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches do not stop the motor, and it can run into the end of its travel.</source>
        <translation>Normalmente el chip detiene el motor en el final de carrera 1 al ir hacia adelante y en el 2 al ir hacia atrás. Si se ignoran, los finales de carrera no detienen nada y el motor puede chocar con el final de su recorrido.</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor when its E-stop input goes high. When ignored, the input does not stop the motor.</source>
        <translation>Normalmente el chip detiene el motor cuando su entrada E-Stop pasa a nivel alto. Si se ignora, la entrada no detiene nada.</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.</source>
        <translation>Un final de carrera o la entrada E-Stop también apagan el motor: puede girar libremente y una carga puede caer.</translation>
    </message>
    <message>
        <source>A/D now %1</source>
        <translation>A/D actual: %1</translation>
    </message>
    <message>
        <source>off; %1</source>
        <translation>inactivo; %1</translation>
    </message>
    <message>
        <source>no current</source>
        <translation>sin corriente</translation>
    </message>
    <message>
        <source>%1 % of full</source>
        <translation>%1 % del máximo</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>velocidad %1</translation>
    </message>
    <message>
        <source>The acceleration time</source>
        <translation>El tiempo de aceleración</translation>
    </message>
    <message>
        <source>How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it.</source>
        <translation>Cuánto permanece una rampa en cada velocidad, en unidades de 0,25 ms; cuanto menor, más empinada. Se envía con el próximo movimiento con rampa y lo usan las paradas suaves posteriores.</translation>
    </message>
    <message>
        <source>Jog is never faster than this. Set a speed that you can react to.</source>
        <translation>El jog nunca es más rápido que esto. Ponga una velocidad a la que pueda reaccionar.</translation>
    </message>
    <message>
        <source>With every motion</source>
        <translation>Con cada movimiento</translation>
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
        <translation>PARAR TODO  Esc</translation>
    </message>
    <message>
        <source>STOP ALL  Esc: stop all motors</source>
        <translation>PARAR TODO  Esc: parar todos los motores</translation>
    </message>
    <message>
        <source>Stops every motor. Unavailable: no port is open.</source>
        <translation>Detiene todos los motores. No disponible: no hay ningún puerto abierto.</translation>
    </message>
    <message>
        <source>Stops every motor on this line at once; Esc does the same from anywhere. It %1.
It works only while the link works: fit a hardware stop as well.</source>
        <translation>Detiene de inmediato todos los motores de esta línea; Esc hace lo mismo desde cualquier lugar. El comando %1.
Solo funciona mientras funcione el enlace: instale además una parada por hardware.</translation>
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
        <translation>Estas muestras ya no se conservan individualmente. Mueva los cursores a otras más recientes.</translation>
    </message>
    <message>
        <source>%1 samples are between the cursors, and %2 are the most. Move the cursors closer together.</source>
        <translation>Hay %1 muestras entre los cursores, y %2 son el máximo. Acerque los cursores.</translation>
    </message>
    <message>
        <source>Too few samples are between the cursors. Move them farther apart.</source>
        <translation>Hay muy pocas muestras entre los cursores. Sepárelos más.</translation>
    </message>
</context>
<context>
    <name>nmc::TestForm</name>
    <message>
        <source>End test</source>
        <translation>Terminar prueba</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Progreso de la prueba</translation>
    </message>
    <message>
        <source>The test is already running.</source>
        <translation>La prueba ya está en curso.</translation>
    </message>
    <message>
        <source>The test is not running.</source>
        <translation>La prueba no está en curso.</translation>
    </message>
</context>
<context>
    <name>nmc::TracesDialog</name>
    <message>
        <source>Custom traces</source>
        <translation>Trazas propias</translation>
    </message>
    <message>
        <source>Each trace is the sum of one or two signals, each times a factor. Values are taken in the units in which the signals are shown; a negative factor subtracts.</source>
        <translation>Cada traza es la suma de una o dos señales, cada una por un factor. Los valores se toman en las unidades en que se muestran las señales; un factor negativo resta.</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>Second signal</source>
        <translation>Segunda señal</translation>
    </message>
    <message>
        <source>Low-pass, Hz</source>
        <translation>Paso bajo, Hz</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Aplicar</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Emitir</translation>
    </message>
    <message>
        <source>%1, trace %2</source>
        <translation>%1, traza %2</translation>
    </message>
    <message>
        <source>The name in the legend. Without one, there is no such trace.</source>
        <translation>El nombre en la leyenda. Sin nombre, la traza no existe.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Selected module</source>
        <translation>Módulo seleccionado</translation>
    </message>
    <message>
        <source>Smooths the trace: what is faster than this frequency is attenuated, and the trace lags behind. Empty: no filter.</source>
        <translation>Suaviza la traza: lo que es más rápido que esta frecuencia se atenúa, y la traza se retrasa. Vacío: sin filtro.</translation>
    </message>
    <message>
        <source>Shown beside the name.</source>
        <translation>Se muestra junto al nombre.</translation>
    </message>
    <message>
        <source>Factor of: %1</source>
        <translation>Factor de: %1</translation>
    </message>
    <message>
        <source>The signal is multiplied by it.</source>
        <translation>La señal se multiplica por él.</translation>
    </message>
    <message>
        <source>A factor must not be 0.</source>
        <translation>Un factor no debe ser 0.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>no</translation>
    </message>
</context>
<context>
    <name>nmc::TravelBox</name>
    <message>
        <source>State of the travel limits</source>
        <translation>Estado de los límites de recorrido</translation>
    </message>
    <message>
        <source>Counted from home. No motion passes it while home is known. Empty: no limit.</source>
        <translation>Contada desde la referencia. Ningún movimiento la sobrepasa mientras se conozca la referencia. Vacío: sin límite.</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Aquí</translation>
    </message>
    <message>
        <source>Here: make the present position the lowest</source>
        <translation>Aquí: convertir la posición actual en la mínima</translation>
    </message>
    <message>
        <source>Here: make the present position the highest</source>
        <translation>Aquí: convertir la posición actual en la máxima</translation>
    </message>
    <message>
        <source>Limits moves, runs, steps, jog and homing. Empty: the module&apos;s maximum.</source>
        <translation>Limita movimientos, marchas, pasos, jog y referenciado. Vacío: el máximo del módulo.</translation>
    </message>
    <message>
        <source>Slightly more than the play between motor and load. A move from the other side overshoots its goal by this distance and comes back. Empty: none.</source>
        <translation>Algo más que el juego entre el motor y la carga. Un movimiento desde el otro lado sobrepasa su destino en esta distancia y vuelve. Vacío: ninguna.</translation>
    </message>
    <message>
        <source>Approach direction of every goal</source>
        <translation>Sentido de llegada a cada destino</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>desde abajo</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>desde arriba</translation>
    </message>
    <message>
        <source>Go, Go home, steps, points and sequences approach their goals from this side. Loaded moves and paths go straight to theirs.</source>
        <translation>“Desplazar”, “Ir a referencia”, los pasos, los puntos y las secuencias llegan a su destino desde este lado. Los movimientos cargados y las trayectorias van directos.</translation>
    </message>
    <message>
        <source>Confirm position…</source>
        <translation>Confirmar posición…</translation>
    </message>
    <message>
        <source>Confirm position as correct</source>
        <translation>Confirmar posición como correcta</translation>
    </message>
    <message>
        <source>Position in doubt</source>
        <translation>Posición dudosa</translation>
    </message>
    <message>
        <source>Position in doubt: it may be wrong</source>
        <translation>Posición dudosa: puede ser errónea</translation>
    </message>
    <message>
        <source>Confirm the position</source>
        <translation>Confirmar la posición</translation>
    </message>
    <message>
        <source>Position &amp;is right</source>
        <translation>La pos&amp;ición es correcta</translation>
    </message>
    <message>
        <source>The lowest position must be below the highest. The old value is kept.</source>
        <translation>La posición mínima debe estar por debajo de la máxima. Se conserva el valor anterior.</translation>
    </message>
    <message>
        <source>Sets the lowest position to the present position.</source>
        <translation>Pone la posición mínima en la posición actual.</translation>
    </message>
    <message>
        <source>Sets the highest position to the present position.</source>
        <translation>Pone la posición máxima en la posición actual.</translation>
    </message>
    <message>
        <source>Confirms that the position is right: home is at position 0. Asks first.</source>
        <translation>Confirma que la posición es correcta: la referencia está en la posición 0. Pregunta antes.</translation>
    </message>
    <message>
        <source>Marks home as unknown. The travel limits are not in force until home is known again.</source>
        <translation>Marca la referencia como desconocida. Los límites de recorrido no tienen efecto hasta que se conozca de nuevo la referencia.</translation>
    </message>
    <message>
        <source>With this backlash, no move can end at home: it would reverse beyond the limit. Move the limit away from home, or change the backlash or its direction.</source>
        <translation>Con esta holgura, ningún movimiento puede terminar en la referencia: daría la vuelta más allá del límite. Aleje el límite de la referencia, o cambie la holgura o su sentido.</translation>
    </message>
    <message>
        <source>Arrival tolerance</source>
        <translation>Tolerancia de llegada</translation>
    </message>
    <message>
        <source>Sequences, and programs that wait, go on when the motor has stayed this close to its goal for the time beside it. Empty: when it stands still.</source>
        <translation>Las secuencias, y los programas que esperan, continúan cuando el motor ha permanecido así de cerca de su destino durante el tiempo indicado al lado. Vacío: cuando está parado.</translation>
    </message>
    <message>
        <source>Time within the arrival tolerance</source>
        <translation>Tiempo dentro de la tolerancia de llegada</translation>
    </message>
    <message>
        <source>How long the motor must stay within the tolerance.</source>
        <translation>Cuánto tiempo debe permanecer el motor dentro de la tolerancia.</translation>
    </message>
    <message>
        <source>Arrival within</source>
        <translation>Llegada a menos de</translation>
    </message>
    <message>
        <source>for</source>
        <translation>durante</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerBar</name>
    <message>
        <source>Trigger on</source>
        <translation>Disparo con</translation>
    </message>
    <message>
        <source>The signal or status bit to wait for.</source>
        <translation>La señal o el bit de estado que se espera.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condición</translation>
    </message>
    <message>
        <source>The event to wait for.</source>
        <translation>El evento que se espera.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>The level for the event.</source>
        <translation>El nivel para el evento.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Single: holds the first picture. Normal: shows picture after picture.</source>
        <translation>Único: retiene la primera imagen. Normal: muestra una imagen tras otra.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Share of the picture before the trigger, in percent.</source>
        <translation>Parte de la imagen anterior al disparo, en porcentaje.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armar</translation>
    </message>
    <message>
        <source>State of the trigger</source>
        <translation>Estado del disparo</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Inactivo</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Único</translation>
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
        <translation>sube a</translation>
    </message>
    <message>
        <source>falls to</source>
        <translation>baja a</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>es mayor que</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>es menor que</translation>
    </message>
    <message>
        <source>becomes 1</source>
        <translation>pasa a 1</translation>
    </message>
    <message>
        <source>becomes 0</source>
        <translation>pasa a 0</translation>
    </message>
    <message>
        <source>is 1</source>
        <translation>es 1</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>es 0</translation>
    </message>
    <message>
        <source>No module connected.</source>
        <translation>Ningún módulo conectado.</translation>
    </message>
    <message>
        <source>Choose a mode first.</source>
        <translation>Elija primero un modo.</translation>
    </message>
    <message>
        <source>Waits for the next trigger.</source>
        <translation>Espera el próximo disparo.</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerControl</name>
    <message>
        <source>waiting</source>
        <translation>en espera</translation>
    </message>
    <message>
        <source>triggered %1, more samples to come</source>
        <translation>disparado: %1, faltan muestras por llegar</translation>
    </message>
    <message>
        <source>triggered %1</source>
        <translation>disparado: %1</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerRecords</name>
    <message>
        <source>Save each picture…</source>
        <translation>Guardar cada imagen…</translation>
    </message>
    <message>
        <source>Save each picture</source>
        <translation>Guardar cada imagen</translation>
    </message>
    <message>
        <source>Saves the samples of each picture to a folder that you choose.</source>
        <translation>Guarda las muestras de cada imagen en una carpeta que usted elige.</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>Conservar los últimos</translation>
    </message>
    <message>
        <source>How many files are kept. Then the oldest is replaced.</source>
        <translation>Cuántos archivos se conservan. Después se sustituye el más antiguo.</translation>
    </message>
    <message>
        <source>Saved pictures</source>
        <translation>Imágenes guardadas</translation>
    </message>
    <message>
        <source>Save each picture to a folder</source>
        <translation>Guardar cada imagen en una carpeta</translation>
    </message>
    <message>
        <source>%1 taken for %2</source>
        <translation>%1 tomadas para %2</translation>
    </message>
</context>
<context>
    <name>nmc::TuningFiles</name>
    <message>
        <source>PIC-SERVO, version %1, address %2</source>
        <translation>PIC-SERVO, versión %1, dirección %2</translation>
    </message>
    <message>
        <source>%1, %2 Bd</source>
        <translation>%1, %2 Bd</translation>
    </message>
    <message>
        <source>Save the tuning report</source>
        <translation>Guardar el informe de ajuste</translation>
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
        <translation>Calcular la unidad</translation>
    </message>
    <message>
        <source>Type of axis</source>
        <translation>Tipo de eje</translation>
    </message>
    <message>
        <source>rotary, in turns</source>
        <translation>rotativo, en vueltas</translation>
    </message>
    <message>
        <source>rotary, in degrees</source>
        <translation>rotativo, en grados</translation>
    </message>
    <message>
        <source>linear, in millimetres</source>
        <translation>lineal, en milímetros</translation>
    </message>
    <message>
        <source>The unit to display for this axis.</source>
        <translation>La unidad con que se muestra este eje.</translation>
    </message>
    <message>
        <source>The axis</source>
        <translation>El eje</translation>
    </message>
    <message>
        <source>Full steps per motor turn</source>
        <translation>Pasos completos por vuelta del motor</translation>
    </message>
    <message>
        <source>200 for a motor with 1.8 degrees per step.</source>
        <translation>200 para un motor de 1,8 grados por paso.</translation>
    </message>
    <message>
        <source>Microsteps per full step</source>
        <translation>Micropasos por paso completo</translation>
    </message>
    <message>
        <source>As set on the driver; 1 for full steps, 2 for half steps.</source>
        <translation>Según lo ajustado en el driver; 1 para pasos completos, 2 para medios pasos.</translation>
    </message>
    <message>
        <source>Encoder lines per turn</source>
        <translation>Líneas del encoder por vuelta</translation>
    </message>
    <message>
        <source>As on its label: lines, CPR or PPR. The chip counts four per line.</source>
        <translation>Según su etiqueta: líneas, CPR o PPR. El chip cuenta cuatro por línea.</translation>
    </message>
    <message>
        <source>Gear: motor turns</source>
        <translation>Reductora: vueltas del motor</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 50; without a gear, 1.</source>
        <translation>Para una reductora 50 : 1, introduzca 50; sin reductora, 1.</translation>
    </message>
    <message>
        <source>Gear: output turns</source>
        <translation>Reductora: vueltas a la salida</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 1.</source>
        <translation>Para una reductora 50 : 1, introduzca 1.</translation>
    </message>
    <message>
        <source>Travel per output turn (mm)</source>
        <translation>Recorrido por vuelta de salida (mm)</translation>
    </message>
    <message>
        <source>Lead screw: pitch times starts. Belt: pulley teeth times belt pitch. Rack: pinion teeth times rack pitch.</source>
        <translation>Husillo: paso por número de entradas. Correa: dientes de la polea por paso de la correa. Cremallera: dientes del piñón por paso de la cremallera.</translation>
    </message>
    <message>
        <source>Calculated unit</source>
        <translation>Unidad calculada</translation>
    </message>
    <message>
        <source>Use this unit</source>
        <translation>Usar esta unidad</translation>
    </message>
    <message>
        <source>Enter a number above 0 in each field.</source>
        <translation>Introduzca un número mayor que 0 en cada campo.</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>cuentas</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>vuelta</translation>
    </message>
    <message>
        <source>1 %1 is %2 %3. The smallest step is %4 %5.</source>
        <translation>1 %1 son %2 %3. El paso más pequeño es %4 %5.</translation>
    </message>
    <message>
        <source>Sets this unit for the axis. Keeps every physical value and sends nothing.</source>
        <translation>Pone esta unidad al eje. Conserva todas las magnitudes físicas y no envía nada.</translation>
    </message>
</context>
<context>
    <name>nmc::WorkBox</name>
    <message>
        <source>Positions count from this work offset</source>
        <translation>Las posiciones se cuentan desde este desplazamiento de trabajo</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Clear work offset: positions count by the counter</source>
        <translation>Borrar el desplazamiento de trabajo: las posiciones siguen el contador</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete work offset</source>
        <translation>Eliminar el desplazamiento de trabajo</translation>
    </message>
    <message>
        <source>Count from</source>
        <translation>Contar desde</translation>
    </message>
    <message>
        <source>Number for the present position</source>
        <translation>Número para la posición actual</translation>
    </message>
    <message>
        <source>What the present position is to be called, in the unit of the axis.</source>
        <translation>El valor que debe tener la posición actual, en la unidad del eje.</translation>
    </message>
    <message>
        <source>Name of the work offset</source>
        <translation>Nombre del desplazamiento de trabajo</translation>
    </message>
    <message>
        <source>The name by which you choose it later.</source>
        <translation>El nombre con el que lo elegirá más tarde.</translation>
    </message>
    <message>
        <source>For example: fixture A</source>
        <translation>Por ejemplo: utillaje A</translation>
    </message>
    <message>
        <source>Call this position</source>
        <translation>Llamar así a esta posición</translation>
    </message>
    <message>
        <source>Call this position: make a work offset</source>
        <translation>Llamar así a esta posición: crear un desplazamiento de trabajo</translation>
    </message>
    <message>
        <source>This position is</source>
        <translation>Esta posición es</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first, and call its position then.</source>
        <translation>El motor está en movimiento. Deténgalo primero y luego asigne su posición.</translation>
    </message>
    <message>
        <source>Enter a name for the work offset, for example of a fixture.</source>
        <translation>Introduzca un nombre para el desplazamiento de trabajo, por ejemplo el de un utillaje.</translation>
    </message>
    <message>
        <source>Another work offset of this axis has this name. Delete that one, or enter another name.</source>
        <translation>Otro desplazamiento de trabajo de este eje tiene este nombre. Elimínelo o introduzca otro nombre.</translation>
    </message>
    <message>
        <source>This axis has as many work offsets as it can have. Delete one first.</source>
        <translation>Este eje ya tiene el máximo de desplazamientos de trabajo. Elimine uno primero.</translation>
    </message>
    <message>
        <source>With this number, the work offset would be outside the position range.</source>
        <translation>Con este número, el desplazamiento de trabajo quedaría fuera del rango de posiciones.</translation>
    </message>
    <message>
        <source>the counter</source>
        <translation>el contador</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1: desconocido</translation>
    </message>
    <message>
        <source>Where the positions on the screen count from. Nothing moves, and nothing is sent.</source>
        <translation>Desde dónde se cuentan las posiciones en pantalla. Nada se mueve y no se envía nada.</translation>
    </message>
    <message>
        <source>No work offset is in use.</source>
        <translation>No se usa ningún desplazamiento de trabajo.</translation>
    </message>
    <message>
        <source>Positions count by the counter again. Nothing moves.</source>
        <translation>Las posiciones vuelven a seguir el contador. Nada se mueve.</translation>
    </message>
    <message>
        <source>Choose the work offset first.</source>
        <translation>Elija primero el desplazamiento de trabajo.</translation>
    </message>
    <message>
        <source>Deletes the work offset from the machine. Nothing moves.</source>
        <translation>Elimina el desplazamiento de trabajo de la máquina. Nada se mueve.</translation>
    </message>
    <message>
        <source>Positions then count from there. Nothing moves; counter and home stay.</source>
        <translation>Las posiciones se cuentan entonces desde ahí. Nada se mueve; el contador y la referencia quedan igual.</translation>
    </message>
    <message>
        <source>Home is unknown: an offset lasts only until home or the counter changes, and is not kept.</source>
        <translation>La referencia es desconocida: un desplazamiento solo dura hasta que cambie la referencia o el contador, y no se conserva.</translation>
    </message>
</context>
<context>
    <name>nmc::XyDialog</name>
    <message>
        <source>One signal over another, between the cursors</source>
        <translation>Una señal en función de otra, entre los cursores</translation>
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
        <translation>%1 en función de %2</translation>
    </message>
</context>
<context>
    <name>nmc::XyPlot</name>
    <message>
        <source>One signal over another</source>
        <translation>Una señal en función de otra</translation>
    </message>
    <message>
        <source>Each sample of the vertical signal, over the value of the horizontal one at the same time. The dot marks the last one. Double-click to show everything. Scroll to zoom horizontally, or vertically with Ctrl; drag to pan.</source>
        <translation>Cada muestra de la señal vertical, en función del valor de la horizontal en el mismo instante. El punto marca la última. Doble clic para mostrar todo. Rueda para ampliar en horizontal, o en vertical con Ctrl; arrastre para desplazar.</translation>
    </message>
</context>
</TS>
