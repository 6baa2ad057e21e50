# SPDX-License-Identifier: GPL-3.0-or-later
"""Deliberate breakages of a read-only connection (faults.md H-02), which only queries, and stops nothing unasked."""
from mutant import Edit, Mutant

# With this one, whatever a task sends by mistake is really transmitted.
LETS_EVERYTHING_LEAVE = Edit("core/bus/line.cpp",
                             "    if (m_permit == Permit::Everything || !frame)",
                             "    if (true)")
DEFINES = Edit("core/bus/chain.cpp", "    if (items || m_readOnly)", "    if (items)")

READ_ONLY = (
    Mutant("read-only-line-lets-everything-leave", "link.md 2.8: the line is where the promise is enforced",
           (LETS_EVERYTHING_LEAVE,)),
    Mutant("read-only-defines-and-is-held-back", "link.md 2.8: a task requests what may not be sent", (DEFINES,)),
    Mutant("read-only-defines", "link.md 2.8: other hosts define what replies contain",
           (DEFINES, LETS_EVERYTHING_LEAVE)),
    Mutant("read-only-gives-addresses", "link.md 2.8: a chain without addresses is left as it is", (
        Edit("core/bus/discovery.cpp", "    } else if (m_config.readOnly) {", "    } else if (false) {"),
    )),
    Mutant("read-only-restarts-the-network", "link.md 2.8: a restart only searches again", (
        Edit("core/bus/engine.cpp",
             "m_config.readOnly ? Discovery::Start::Look : Discovery::Start::Restart",
             "Discovery::Start::Restart"),
    )),
    Mutant("read-only-takes-commands", "link.md 2.8: a command is refused, and not lost on its way", (
        Edit("core/bus/engine.h", "return settled() && !m_config.readOnly;", "return settled();"),
    )),
    Mutant("read-only-owes-stops-nobody-asked-for", "link.md 2.8: a lost link is no reason to stop its motors", (
        Edit("core/bus/chain.cpp",
             "    if (m_readOnly && cause != StopCause::StopAll)\n        return;  // the user did not request it\n", ""),
        LETS_EVERYTHING_LEAVE,
    )),
    Mutant("read-only-stops-when-it-gives-up", "link.md 2.8: nor is a link that is given up", (
        Edit("core/bus/engine.cpp",
             "    if (!m_stops.stopping() && !m_config.readOnly) {\n", "    if (!m_stops.stopping()) {\n"),
    )),
    Mutant("read-only-suspects-motions", "link.md 2.8: all motions belong to other hosts", (
        Edit("core/bus/engine.cpp", 
             "    if (m_config.readOnly || lent())\n        return;  // whatever moves there",
             "    if (lent())\n        return;  // whatever moves there"),
    )),
    Mutant("read-only-has-a-burst", "link.md 2.8: a crash stops no motors of other hosts", (
        Edit("core/bus/chain.cpp", "    if (m_readOnly)\n        return burst;\n", ""),
    )),
    Mutant("read-only-forgets-a-stop-that-is-owed", "link.md 2.8: a requested stop is repeated until confirmed", (
        Edit("core/bus/engine.cpp",
             "m_stopAsked && (m_stops.stopping() || m_stops.due())", "m_stopAsked && m_stops.stopping()"),
    )),
    Mutant("read-only-guesses-how-long-an-answer-is", "link.md 2.8: other hosts define the length of an answer", (
        Edit("core/bus/chain.cpp", "        ask.request.framing = Framing::Open;", "        static_cast<void>(0);"),
    )),
)
