<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>LoopTestTexts</name>
    <message numerus="yes">
        <source>%n frequencies up to %1 Hz</source>
        <translation>
            <numerusform>%n frequency up to %1 Hz</numerusform>
            <numerusform>%n frequencies up to %1 Hz</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MessageLines</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n time</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message numerus="yes">
        <source>%n motors are moving: stop them before anything is sent.</source>
        <translation>
            <numerusform>%n motor is moving: stop it before anything is sent.</numerusform>
            <numerusform>%n motors are moving: stop them before anything is sent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The panel ended without stopping its motors; its guardian commanded modules %1 to stop.</source>
        <translation>
            <numerusform>The panel ended without stopping its motors; its guardian commanded module %1 to stop.</numerusform>
            <numerusform>The panel ended without stopping its motors; its guardian commanded modules %1 to stop.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Motors %1 were moving, at %2.</source>
        <translation>
            <numerusform>Motor %1 was moving, at %2.</numerusform>
            <numerusform>Motors %1 were moving, at %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The last session ended while motors %1 were moving.</source>
        <translation>
            <numerusform>The last session ended while motor %1 was moving.</numerusform>
            <numerusform>The last session ended while motors %1 were moving.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No stop command is known for modules %1</source>
        <translation>
            <numerusform>No stop command is known for module %1</numerusform>
            <numerusform>No stop command is known for modules %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 do not answer</source>
        <translation>
            <numerusform>Module %1 does not answer</numerusform>
            <numerusform>Modules %1 do not answer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 are off after a restart.</source>
        <translation>
            <numerusform>Module %1 is off after a restart.</numerusform>
            <numerusform>Modules %1 are off after a restart.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop but were not seen at rest</source>
        <translation>
            <numerusform>Module %1 was commanded to stop but was not seen at rest</numerusform>
            <numerusform>Modules %1 were commanded to stop but were not seen at rest</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop.</source>
        <translation>
            <numerusform>Module %1 was commanded to stop.</numerusform>
            <numerusform>Modules %1 were commanded to stop.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped before the port closes.</source>
        <translation>
            <numerusform>%n motor is moving. It will be stopped before the port closes.</numerusform>
            <numerusform>%n motors are moving. They will be stopped before the port closes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped first.</source>
        <translation>
            <numerusform>%n motor is moving. It will be stopped first.</numerusform>
            <numerusform>%n motors are moving. They will be stopped first.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n modules</source>
        <translation>
            <numerusform>%n module</numerusform>
            <numerusform>%n modules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stopped and holding</source>
        <translation>
            <numerusform>%n stopped and holding</numerusform>
            <numerusform>%n stopped and holding</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n switched off</source>
        <translation>
            <numerusform>%n switched off</numerusform>
            <numerusform>%n switched off</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n were off</source>
        <translation>
            <numerusform>%n was off</numerusform>
            <numerusform>%n were off</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n I/O modules in their stop state</source>
        <translation>
            <numerusform>%n I/O module in its stop state</numerusform>
            <numerusform>%n I/O modules in their stop state</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::LinkBar</name>
    <message numerus="yes">
        <source>%1 errors, %2/s</source>
        <translation>
            <numerusform>%1 error, %2/s</numerusform>
            <numerusform>%1 errors, %2/s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::MessageRow</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n time</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::RowsModel</name>
    <message numerus="yes">
        <source>%n times in all</source>
        <translation>
            <numerusform>%n time in all</numerusform>
            <numerusform>%n times in all</numerusform>
        </translation>
    </message>
</context>
</TS>
