# SPDX-License-Identifier: GPL-3.0-or-later
"""Deliberate breakages of the bus engine and of the port, as by a careless change. A test must notice each."""
from mutant import Edit, Mutant
from readonlymutants import READ_ONLY
from stopmutants import STOPS

RESYNC = (
    Mutant("no-flush-in-a-resync", "link.md 2.2: without 16 nulls, a module keeps waiting for the rest of a packet", (
        Edit("core/bus/recovery.cpp",
             "{Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{},",
             "{Line::Pause{m_quarantine}, DiscardInput{},"),
    )),
    Mutant("no-quarantine", "link.md 2.2: a late reply must not answer the next command", (
        Edit("core/bus/recovery.cpp",
             "{Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{},",
             "{DiscardInput{}, Line::Nulls{},"),
    )),
    Mutant("no-challenge", "link.md 2.2: after a resync, nothing is believed before two right answers", (
        Edit("core/bus/recovery.cpp",
             "    return challenge();",
             "    if (!m_doubt->wasUnresponsive) {\n"
             "        m_doubt.reset();\n"
             "        return Again{};\n"
             "    }\n"
             "    return challenge();"),
    )),
    Mutant("one-answer-ends-a-doubt", "link.md 2.2: a second challenge, with a reply of another length, is required", (
        Edit("core/bus/recovery.cpp", "constexpr unsigned kPasses = 2;", "constexpr unsigned kPasses = 1;"),
    )),
    Mutant("items-not-defined-anew", "faults.md F-43: after a doubt, replies may have another length", (
        Edit("core/bus/recovery.cpp", "belief.forgetItems();", "{}"),
    )),
)

BELIEVING = (
    Mutant("never-in-full", "link.md 2.2: two layouts of different length alternate", (
        Edit("core/bus/pollschedule.cpp", "module.full = !module.full;", "module.full = false;"),
    )),
    Mutant("always-in-full", "link.md 2.2: two layouts of different length alternate", (
        Edit("core/bus/pollschedule.cpp", "module.full = !module.full;", "module.full = true;"),
    )),
    Mutant("sum-only", "link.md 2.4: the sum misses one error of two bits in sixteen", (
        Edit("core/bus/plausibility.cpp",
             "    if (const auto impossible = structure(end))\n        return impossible;\n",
             "    return std::nullopt;\n"),
    )),
    Mutant("no-structure", "link.md 2.4: some bits exclude each other", (
        Edit("core/bus/plausibility.cpp",
             "    if (const auto impossible = structure(end))\n        return impossible;\n", ""),
    )),
    Mutant("no-physics", "link.md 2.4: a position is near the one before", (
        Edit("core/bus/plausibility.cpp",
             "return travelled < lowest || travelled > highest ? std::optional(Rejection::PositionJump) : std::nullopt;",
             "return std::nullopt;"),
    )),
    Mutant("bytes-after-a-reply-ignored", "link.md 2.2: surplus bytes reject the reply", (
        Edit("core/bus/line.cpp", "m_done->end.result = ReplyResult::Rejected;\n    m_done->end.rejection = Rejection::Surplus;", ";"),
    )),
    Mutant("bytes-behind-a-reply-cut-off", "faults.md F-04: surplus bytes reject the whole frame", (
        Edit("core/bus/line.cpp",
             "pending.received.appendWhatFits(bytes);",
             "const std::size_t most = pending.framing == Framing::Open ? kMaxReply + kMaxSurplus : pending.wanted();\n"
             "    pending.received.append(bytes.first(std::min(bytes.size(), most - pending.received.size())));"),
    )),
    Mutant("early-bytes-are-the-reply", "faults.md F-46: no module answers before it has received the command", (
        Edit("core/bus/line.cpp",
             "if (m_pending->received.empty() && now < m_pending->left) {",
             "if (m_done && m_pending->received.empty() && now < m_pending->left) {"),
    )),
    Mutant("one-reply-permits", "link.md 2.4: two replies in a row are needed to permit", (
        Edit("core/bus/trust.cpp",
             "const unsigned confirmed = second ? unsigned{before} : 0U;",
             "const unsigned confirmed = 0xFFU;"),
    )),
    Mutant("two-of-one-length-permit", "link.md 2.4: two replies of different length are needed to permit", (
        Edit("core/bus/trust.cpp",
             "const bool second = m_last && m_last->length != length;",
             "const bool second = m_last.has_value();"),
    )),
    Mutant("refused-reply-believed", "faults.md F-08: a refusal shows that the module answers, but is no sample", (
        Edit("core/bus/engine.cpp",
             "    if (end.result == ReplyResult::Refused) {\n        module.trust.interrupt();",
             "    if (false) {\n        module.trust.interrupt();"),
    )),
)

COMMANDS = (
    Mutant("blind-retry-of-set-address", "link.md 2.3: the new address is queried first, or two modules may get it", (
        Edit("core/bus/addressing.cpp",
             "encode(set), {}}, 0, Quarantine::Brief);",
             "encode(set), {}}, 1, Quarantine::Brief);"),
    )),
    Mutant("address-number-sent-twice", "link.md 2.3: a module may have taken the number although no answer arrived", (
        Edit("core/bus/addressing.cpp",
             "    const SetAddress set{BusAddress(++m_number), kEverybody, false};",
             "    m_number = static_cast<std::uint8_t>(m_addresses.size() + 1);\n"
             "    const SetAddress set{BusAddress(m_number), kEverybody, false};"),
    )),
    Mutant("states-kept-through-new-addresses", "link.md 2.6: a module that was reset is off, and stays off", (
        Edit("core/bus/engine.cpp",
             "        m_chain.forgetStates();\n", ""),
    )),
    Mutant("load-and-start-in-one", "link.md 1: a trapezoidal move is never started by the command that loads it", (
        Edit("core/module/commandfacts.cpp",
             "load.isTrapezoidal() ? Never : load.servo", "load.servo"),
    )),
    Mutant("blind-retry-of-start", "link.md 2.3: a start without an answer is never repeated unverified", (
        Edit("core/module/commandfacts.cpp",
             "{ return {kGiveUp, Motion, AsLoaded, Effect::Start}; }",
             "{ return {kRepeat, Motion, AsLoaded, Effect::Start}; }"),
    )),
    Mutant("blind-retry-of-a-refused-start", "faults.md F-09: the refusal itself may be a transmission error", (
        Edit("core/bus/operationtask.cpp",
             "        ask.refusedAttempts = 1;\n        ask.refusedBefore",
             "        ask.refusedBefore"),
    )),
    Mutant("start-without-all-loads", "faults.md M-26: the start is withheld if a member refused its load", (
        Edit("core/bus/operationtask.cpp",
             "    if (end.result == ReplyResult::Accepted)\n        return accept(end);",
             "    if (!unanswered(end.result))\n        return accept(end);"),
    )),
    Mutant("reset-position-in-motion", "faults.md M-19: never sent while the motor moves", (
        Edit("core/module/commandfacts.cpp",
             "{kGiveUp, Position, Standstill, Effect::Counter}",
             "{kGiveUp, Position, Always, Effect::Counter}"),
    )),
    Mutant("gate-believes-an-old-status", "link.md 2.4: a status from before the last motion permits nothing", (
        Edit("core/bus/gate.cpp",
             "    if (!belief.fresh())\n        return Permission::NeedsStatus;\n    if (belief.mayMove())\n",
             "    if (belief.mayMove())\n"),
    )),
    Mutant("hard-reset-to-connect", "faults.md F-23: connecting only queries; a reset needs consent", (
        Edit("core/bus/discovery.cpp",
             "m_phase(start == Start::Look ? Phase::Look : Phase::Restart),",
             "m_phase(Phase::Restart),"),
    )),
)

LOSING = (
    Mutant("one-search-only", "link.md 2.9: late answers hide no chain", (
        Edit("core/bus/searchtask.h", "kAttempts = 3;", "kAttempts = 1;"),
    )),
    Mutant("silent-module-at-the-full-rate", "faults.md F-10: a silent module is queried rarely", (
        Edit("core/bus/pollschedule.cpp",
             "    if (!m_lastProbe)\n        return module.due;\n",
             "    return TimePoint{};\n"),
    )),
    Mutant("lost-link-never-told", "faults.md F-11: silence of all modules has one cause, reported once", (
        Edit("core/bus/recovery.cpp", "    if (!m_givenUp)\n        m_events.emplace_back(LinkLost{});\n", ""),
    )),
    Mutant("no-stops-on-a-dead-line", "faults.md F-11: commands may still arrive", (
        Edit("core/bus/engine.cpp", "    if (findings.allLost)\n        onLinkLost();\n", ""),
    )),
    Mutant("health-never-lost", "link.md 2.5: the link is lost from 100 on", (
        Edit("core/bus/health.cpp", "if (m_level == LinkHealth::Lost || m_bucket >= kLost)", "if (false)"),
    )),
    Mutant("health-comes-back", "link.md 2.5: a lost link stays lost", (
        Edit("core/bus/health.cpp",
             "if (m_level == LinkHealth::Lost || m_bucket >= kLost)", "if (m_bucket >= kLost)"),
    )),
    Mutant("restarted-module-is-only-silent", "faults.md F-15: it is reported as having lost its settings", (
        Edit("core/bus/restartsearch.cpp",
             "    if (unanswered(end.result) || m_chain.anyRestarted())\n",
             "    if (true)\n"),
    )),
    Mutant("restart-named-at-once", "faults.md F-15: which module it was follows from which ones still answer", (
        Edit("core/bus/restartsearch.cpp", "    if (m_others.empty()) {", "    if (true) {"),
    )),
    Mutant("restarted-module-gets-its-address-back", "faults.md F-15: never without a request", (
        Edit("core/bus/restartsearch.cpp",
             "        name();\n",
             "        name();\n"
             "        for (const Chain::Module& module : m_chain.modules())\n"
             "            if (module.belief.restarted() && !m_quiet)\n"
             "                return Line::Script{\n"
             "                    Line::Packet{toPacket({BusAddress(0), encode(SetAddress{\n"
             "                        module.belief.info().address, BusAddress(0xFF), false})})},\n"
             "                    Line::Lag{kAfterNulls}, DiscardInput{}};\n"),
    )),
    Mutant("noise-for-a-restarted-module", "faults.md F-16: no more packets at a rate at which it does not listen", (
        Edit("core/bus/restartsearch.cpp", "    m_quiet = m_chain.rate() != kPowerUpBaud;\n", "    m_quiet = false;\n"),
    )),
)

GROUPS = (
    Mutant("old-leader-stays", "faults.md F-44: a group never has two leaders", (
        Edit("core/bus/groupwork.cpp", "        orders.push_back(orderTo(info.index, {info.group->group, false}));\n", ""),
    )),
    Mutant("group-start-blindly-repeated", "link.md 2.3: no second start after a doubt", (
        Edit("core/bus/groupwork.cpp", "    ask.silentRepeats = 0;\n", "    ask.silentRepeats = 2;\n"),
    )),
    Mutant("leader-speaks-for-all", "faults.md M-27: only a query of each member shows what it did", (
        Edit("core/bus/grouprun.cpp", "        at(leader).outcome = MemberOutcome::Done;\n",
             "        for (Member& member : m_members)\n            member.outcome = MemberOutcome::Done;\n"),
    )),
    Mutant("half-a-group-goes-on", "faults.md M-27: a group of which only a part started is stopped", (
        Edit("core/bus/groupwork.cpp", "    if (run.partly())\n        m_halfStarted = members;\n", ""),
    )),
    Mutant("command-to-an-unknown-group", "link.md 2.3: a module in an unknown group may be a member", (
        Edit("core/bus/groupwork.cpp", "        if (!info.group || (everybody",
             "        if (!info.group)\n            continue;\n        if ((everybody"),
    )),
    Mutant("refused-load-leaves-the-old-one", "faults.md M-26: the load that is waiting is not the one requested", (
        Edit("core/bus/engine.cpp", "            module.belief.forgetLoad();\n", "            ;\n"),
    )),
    Mutant("rate-changed-for-group-ff-only", "protocol.md 1: a module is in exactly one group", (
        Edit("core/bus/ratetask.cpp", "        groups.emplace_back(module.belief.info().group->group);\n", ""),
    )),
    Mutant("no-way-back-from-a-rate", "faults.md F-24: modules that have changed their rate are brought back", (
        Edit("core/bus/ratetask.cpp", "RateChange::WayBack::Wanted", "RateChange::WayBack::None"),
    )),
    Mutant("stop-waits-for-the-rate", "faults.md N7: a stop is never queued", (
        Edit("core/bus/ratetask.cpp", "    if (m_change && (", "    if (false && ("),
    )),
    Mutant("stop-at-one-rate-only", "link.md 2.6: during a change of rate, modules may listen at either rate", (
        Edit("core/bus/ratetask.cpp",
             "stops = m_stops.blindStops();\n"
             "    if (m_stops.stopping() || !stops.empty())\n        m_stops.onBlindSent();\n",
             "stops{};\n"),
    )),
    Mutant("rate-changed-with-a-leader", "faults.md F-26: the leader's answer would come at the new rate", (
        Edit("core/bus/ratetask.cpp", "return b.info().group->leader; })", "return false && b.info().group->leader; })"),
    )),
    Mutant("rate-change-without-an-end", "engine.h: connecting during a change of rate ends it, with an event", (
        Edit("core/bus/ratetask.cpp",
             "            if (const auto dropped = std::exchange(*ended, std::nullopt))\n"
             "                m_events.emplace_back(RateChangeFailed{\n"
             "                    RateChangeFailed::Reason::Interrupted, dropped->to(), dropped->from(), {}, {}});",
             "            ended->reset();"),
    )),
)

PORT = (
    Mutant("port-kept-open-after-a-hangup", "faults.md F-27: reported once and closed at once; Qt alone would spin", (
        Edit("core/link/connection/serialtransport.cpp",
             "    if (fds[0].revents != 0)\n        return tl::unexpected(gone());\n", ""),
    ), "link"),
)

MUTANTS = RESYNC + BELIEVING + COMMANDS + STOPS + READ_ONLY + LOSING + GROUPS + PORT
