# SPDX-License-Identifier: GPL-3.0-or-later
"""Deliberate breakages of a read-only connection (faults.md H-02): it looks, and stops nobody unasked."""
from mutant import Edit, Mutant

# With it, what a task sends by mistake really goes out.
LETS_EVERYTHING_LEAVE = Edit("core/bus/line.cpp",
                             "    if (m_permit == Permit::Everything || !frame)",
                             "    if (true)")
DEFINES = Edit("core/bus/chain.cpp", "    if (items || m_readOnly)", "    if (items)")

READ_ONLY = (
    Mutant("read-only-line-lets-everything-leave", "everything passes there", (LETS_EVERYTHING_LEAVE,)),
    Mutant("read-only-defines-and-is-held-back", "a task asks what may not leave", (DEFINES,)),
    Mutant("read-only-defines", "what replies have in them is for others to define", (DEFINES, LETS_EVERYTHING_LEAVE)),
    Mutant("read-only-gives-addresses", "a chain without addresses is left so, and told of as that", (
        Edit("core/bus/discovery.cpp", "    } else if (m_config.readOnly) {", "    } else if (false) {"),
    )),
    Mutant("read-only-restarts-the-network", "it only looks again", (
        Edit("core/bus/engine.cpp",
             "m_config.readOnly ? Discovery::Start::Look : Discovery::Start::Restart",
             "Discovery::Start::Restart"),
    )),
    Mutant("read-only-takes-commands", "what would change a module is refused, and not lost on its way", (
        Edit("core/bus/engine.h", "return settled() && !m_config.readOnly;", "return settled();"),
    )),
    Mutant("read-only-owes-stops-nobody-asked-for", "a lost link is no reason to stop somebody else's motors", (
        Edit("core/bus/chain.cpp",
             "    if (m_readOnly && cause != StopCause::StopAll)\n        return;  // nobody asked\n", ""),
        LETS_EVERYTHING_LEAVE,
    )),
    Mutant("read-only-stops-when-it-gives-up", "nor is one that is given up", (
        Edit("core/bus/engine.cpp",
             "    if (!m_stops.stopping() && !m_config.readOnly) {\n", "    if (!m_stops.stopping()) {\n"),
    )),
    Mutant("read-only-suspects-motions", "each is somebody else's", (
        Edit("core/bus/engine.cpp", 
             "    if (m_config.readOnly)\n        return;  // whatever moves there", "    //"),
    )),
    Mutant("read-only-has-a-burst", "a crash stops nobody else's motors", (
        Edit("core/bus/chain.cpp", "    if (m_readOnly)\n        return burst;\n", ""),
    )),
    Mutant("read-only-forgets-a-stop-that-is-owed", "a stop that was asked for goes on until it is confirmed", (
        Edit("core/bus/engine.cpp",
             "m_stopAsked && (m_stops.stopping() || m_stops.due())", "m_stopAsked && m_stops.stopping()"),
    )),
    Mutant("read-only-guesses-how-long-an-answer-is", "the answer to a stop has what others wanted in it", (
        Edit("core/bus/chain.cpp", "        ask.request.framing = Framing::Open;", "        static_cast<void>(0);"),
    )),
)
