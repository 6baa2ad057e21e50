# SPDX-License-Identifier: GPL-3.0-or-later
"""Deliberate breakages of the promise that a stop always acts, and is confirmed only at rest."""
from mutant import Edit, Mutant

STOPPING = (
    Mutant("no-nulls-before-a-stop", "link.md 2.6: nulls come first if the link is in doubt, or the stop may be lost", (
        Edit("core/bus/stoplane.cpp",
             "script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});",
             "script.emplace_back(Line::Pause{kAfterNulls});"),
        Edit("core/bus/recovery.cpp",
             "Line::Script{Line::Nulls{}, Line::Pause{kAfterNulls}, DiscardInput{}};",
             "Line::Script{Line::Pause{kAfterNulls}, DiscardInput{}};"),
    )),
    Mutant("stop-behind-the-quarantine", "link.md 2.6: a stop overtakes everything", (
        Edit("core/bus/engine.cpp", "offer(true, m_stops);", "offer(true, m_recovery, m_stops);"),
    )),
    Mutant("stop-behind-a-reply", "link.md 2.6: a stop may cut off a reply in flight", (
        Edit("core/bus/engine.cpp",
             "        m_stops.stopAll(now);\n        interrupt(now);\n",
             "        m_stops.stopAll(now);\n"),
    )),
    Mutant("stop-with-its-queue-left", "faults.md N2: a stop cancels everything that is waiting", (
        Edit("core/bus/engine.cpp",
             "    cancelAll(Change::Kind::StopAll);\n",
             "    m_hold.clear();\n"),
    )),
    Mutant("tried-gains-left-at-a-stop", "trialtask.h: the previous gains are restored before anything else", (
        Edit("core/bus/trialtask.cpp", "    if (change.cancelsAll())\n", "    if (false)\n"),
    )),
    Mutant("abrupt-stop-of-a-servo-that-is-off", "link.md 2.6: it would switch the servo on", (
        Edit("core/bus/stoptarget.cpp",
             "            if (belief.mayBeOn())\n                return stopMotor(",
             "            if (true)\n                return stopMotor("),
    )),
    Mutant("stop-to-groups-of-another-host", "faults.md F-44: a group chosen by another host may have a leader", (
        Edit("core/bus/chain.cpp",
             "        const auto& other = module.belief.info().group;\n",
             "        const std::optional other = module.belief.info().group.value_or(GroupPlace{});\n"),
        Edit("core/bus/chain.cpp",
             "    const auto& place = belief(stops.front().module).info().group;\n",
             "    const std::optional place = belief(stops.front().module).info().group.value_or(GroupPlace{});\n"),
        Edit("core/bus/chain.cpp",
             "            if (belief(order.module).info().group->leader)",
             "            if (belief(order.module).info().group.value_or(GroupPlace{}).leader)"),
    )),
    Mutant("suspect-motion-goes-on", "faults.md M-17: a motor that is not where it should be is stopped", (
        Edit("core/bus/engine.cpp",
             "    haltAxes({module}, StopCause::MotionSuspect, off ? StopManner::Off : StopManner::Abruptly);",
             "    static_cast<void>(off);\n    notify({Change::Kind::Stopped, {module}});"),
    )),
)

# In every phase, as long as the port is open.
ALWAYS = (
    Mutant("no-stop-while-looking-again", "link.md 2.6: during a search, the chain known before is stopped at once", (
        Edit("core/bus/engine.cpp",
             "    if (!m_chain.empty()) {\n        if (m_search.active()",
             "    if (!m_chain.empty() && !m_search.active()) {\n        if (m_search.active()"),
    )),
    Mutant("no-stop-after-a-search-in-vain", "link.md 2.6: the chain known before may still receive commands", (
        Edit("core/bus/engine.cpp",
             "    if (!m_chain.empty()) {\n        if (m_search.active()",
             "    if (!m_chain.empty() && (m_connected || m_search.active())) {\n        if (m_search.active()"),
        Edit("core/bus/engine.cpp",
             "        m_stops.stopAll(now);  // no module",
             "        m_events.emplace_back(StopFinished{});  // no module"),
    )),
    Mutant("no-nulls-after-a-search", "link.md 2.6: the search may have left half a command in a module", (
        Edit("core/bus/engine.cpp",
             "        if (m_search.active() || !m_connected)\n            m_recovery.doubtLine();\n", ""),
    )),
    Mutant("stop-at-the-rate-of-the-port", "link.md 2.6: a stop is sent at the rate of the chain known before", (
        Edit("core/bus/stoplane.cpp",
             "    if (m_line.baud() != m_chain.rate())\n        script.emplace_back(SetHostBaud{m_chain.rate()});\n",
             ""),
        Edit("core/bus/stoplane.cpp", "    if (strayed)\n        return Line::toRate(m_chain.rate());\n", ""),
    )),
    Mutant("second-connect-swallows-a-stop", "engine.h: a stop ends in exactly one StopFinished", (
        Edit("core/bus/stoplane.h",
             "    /// Each module has been sent its stop;",
             "    void drop() { m_run.reset(), m_sentBlind.clear(), m_waiting = false; }\n"
             "    /// Each module has been sent its stop;"),
        Edit("core/bus/engine.cpp",
             "    if (m_stops.running()) {", "    m_stops.drop();\n    if (m_stops.running()) {"),
    )),
    Mutant("chain-forgotten-at-connect", "link.md 2.6: the chain is kept until another one is found", (
        Edit("core/bus/engine.cpp",
             "        interrupt(now);\n        m_recovery.reset();\n",
             "        interrupt(now);\n        m_chain = Chain();\n        m_recovery.reset();\n"),
    )),
)

# How its outcome is reported, and when.
REPORTING = (
    Mutant("one-look-after-a-stop", "link.md 2.6: a stop is confirmed by two replies", (
        Edit("core/bus/stoptarget.h", "return m_confirmed >= 2;", "return m_confirmed >= 1;"),
    )),
    Mutant("stop-given-up-after-one-silence", "link.md 2.6: a stop is repeated while its module may still answer", (
        Edit("core/bus/stoplane.cpp",
             "constexpr unsigned kSilences = 3;", "constexpr unsigned kSilences = 1;"),
        Edit("core/bus/stoplane.cpp",
             "(member.wasUnresponsive || now - m_run->began >= kSilentFor);",
             "(true || now - m_run->began >= kSilentFor);"),
    )),
    Mutant("stop-over-with-the-first-answer", "link.md 2.6: a stop is repeated until it is confirmed", (
        Edit("core/bus/stoplane.cpp",
             "!member.givenUp && !target(member).stopped();", "!member.givenUp && !target(member).heard();"),
    )),
    Mutant("stopped-when-told", "link.md 2.6: stopped means seen at rest", (
        Edit("core/bus/stoplane.cpp",
             "!member.givenUp && !target(member).stopped();", "!member.givenUp && !target(member).heard();"),
        Edit("core/bus/stoplane.cpp",
             "} else if (module.owed->target.stopped()) {", "} else if (module.owed->target.heard()) {"),
    )),
    Mutant("unconfirmed-counts-as-stopped", "link.md 2.6: a stop was sent, but rest was not seen", (
        Edit("core/bus/stoplane.cpp",
             "} else if (module.owed->target.stopped()) {", "} else if (module.owed->target.heard()) {"),
    )),
    Mutant("silent-counts-as-stopped", "link.md 2.6: a module that does not answer is not reached", (
        Edit("core/bus/stoplane.cpp",
             "} else if (module.owed->target.stopped()) {",
             "} else if (module.owed->target.stopped() || module.owed->target.silences() > 0) {"),
    )),
    Mutant("moving-servo-counts-as-stopped", "link.md 2.6: a motor that continues to move is not confirmed", (
        Edit("core/bus/stoptarget.cpp",
             "    if (showsMotion(type, report))\n",
             "    if (type == ModuleType::Servo)\n        return true;\n    if (showsMotion(type, report))\n"),
    )),
    Mutant("moving-stepper-counts-as-stopped", "link.md 2.6: a motor that continues to move is not confirmed", (
        Edit("core/bus/stoptarget.cpp",
             "    if (showsMotion(type, report))\n",
             "    if (type == ModuleType::Stepper)\n        return true;\n    if (showsMotion(type, report))\n"),
    )),
    Mutant("restarted-module-in-no-list", "types.h: each module is in one list of StopFinished", (
        Edit("core/bus/stoplane.cpp",
             "        if (module.belief.restarted()) {\n            event.unreached.push_back(index);\n        } else",
             "        if (module.belief.restarted()) {\n        } else"),
    )),
)

# A stop of one module, until it is confirmed.
OWING = (
    Mutant("owed-stop-dropped-after-four-tries", "link.md 2.6: an owed stop is never given up", (
        Edit("core/bus/stoplane.cpp",
             "    const bool looked = ",
             "    if (owed->target.silences() > kAtOnce) {\n"
             "        owed.reset();\n"
             "        return {};\n"
             "    }\n"
             "    const bool looked = "),
    )),
    Mutant("owed-stop-dropped-when-its-module-is-silent", "link.md 2.6: it is repeated blindly", (
        Edit("core/bus/stoplane.cpp",
             "        module.owed->due = now + kAfterSilence;\n",
             "        if (!m_chain.answers(index)) {\n"
             "            module.owed.reset();\n"
             "            continue;\n"
             "        }\n"
             "        module.owed->due = now + kAfterSilence;\n"),
    )),
    Mutant("owed-stop-dropped-when-the-link-is-lost", "link.md 2.6: commands may still arrive", (
        Edit("core/bus/engine.cpp",
             "    for (const Order& stop : m_chain.stops())\n"
             "        if (!m_chain.at(stop.module).owed)\n"
             "            m_chain.owe(stop.module, StopCause::LinkGivenUp);\n",
             "    for (Chain::Module& module : m_chain.modules())\n"
             "        module.owed.reset();\n"),
    )),
    Mutant("owed-stop-dropped-by-a-connect", "link.md 2.6: it is repeated while the chain is being searched for", (
        Edit("core/bus/engine.cpp",
             "    m_stops.onSearchBegun();\n",
             "    m_stops.onSearchBegun();\n"
             "    for (Chain::Module& module : m_chain.modules())\n"
             "        module.owed.reset();\n"),
    )),
    Mutant("owed-stop-dropped-with-its-chain", "link.md 2.6: it remains owed to a module that is found where it was", (
        Edit("core/bus/engine.cpp",
             "            if (module.owed && info.address == module",
             "            if (false && module.owed && info.address == module"),
    )),
    Mutant("owed-stop-dropped-with-its-connection", "faults.md F-27: the next connection sends it again", (
        Edit("core/bus/engine.cpp",
             "                if (found.attached && sameModule(info, stop.module))",
             "                if (false && sameModule(info, stop.module))"),
    )),
    Mutant("owed-stop-of-another-module", "faults.md F-27: only a module that is found as it was is sent it", (
        Edit("core/bus/engine.cpp",
             "                if (found.attached && sameModule(info, stop.module))",
             "                if (found.attached)"),
    )),
    Mutant("owed-stop-over-when-answered", "link.md 2.6: only a confirmation ends it", (
        Edit("core/bus/stoplane.cpp",
             "    if (owed->target.stopped()) {", "    if (end.result == ReplyResult::Accepted) {"),
    )),
    Mutant("owed-stop-behind-the-quarantine", "link.md 2.6: it does not wait for late answers", (
        Edit("core/bus/engine.cpp",
             "    if (m_recovery.resyncing() && m_stops.anyUnsent(now))\n        interrupt(now);\n", ""),
    )),
    Mutant("switched-off-motor-held-by-a-stop-of-all", "link.md 2.6: with its servo on, it would run on the wrong way", (
        Edit("core/bus/chain.cpp",
             "    if (module.owed && !bothWanted)\n", "    if (module.owed && !bothWanted && false)\n"),
    )),
    Mutant("limit-reported-during-a-stop-of-all", "types.h: StoppedBeforeLimit is for a stop that the limit has caused", (
        Edit("core/bus/engine.cpp",
             "        manner && (!known.owed || endsMore(*manner, *known.owed))) {", "        manner) {"),
    )),
    Mutant("hold-without-an-end", "link.md 2.7: held motion ends when the evidence stops coming", (
        Edit("core/bus/holdtask.cpp", "m_until = now + m_timeout;", "m_until = now + 1000 * m_timeout;"),
    )),
    Mutant("hold-that-owes-nothing", "link.md 2.6: held motion ends with a stop", (
        Edit("core/bus/holdtask.cpp",
             "released && m_chain.has(released->module))",
             "released && false && m_chain.has(released->module))"),
    )),
    Mutant("press-that-is-over-moves-again", "holdtask.h: late evidence of a press that has ended moves nothing", (
        Edit("core/bus/holdtask.h", "press <= *m_over;", "press < *m_over;"),
    )),
    Mutant("press-that-was-refused-moves-later", "holdtask.h: a press that was refused has ended", (
        Edit("core/bus/engine.cpp", "        return m_hold.refuse(hold);", "        return;"),
    )),
)

STOPS = STOPPING + ALWAYS + REPORTING + OWING
