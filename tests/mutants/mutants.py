# SPDX-License-Identifier: GPL-3.0-or-later
"""Deliberate breakages of the bus engine: what a careless change would do. Each must be noticed by a test."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Edit:
    """`old` is in `file` exactly once and becomes `new`."""
    file: str
    old: str
    new: str


@dataclass(frozen=True)
class Mutant:
    name: str
    breaks: str  # the rule, and where it is written
    edits: tuple[Edit, ...]


MUTANTS = (
    Mutant("no-nulls-before-a-stop", "link.md 2.6: nulls first on a link that is not healthy, or the stop is swallowed", (
        Edit("core/bus/enginestop.cpp",
             "script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});",
             "script.insert(script.end(), {Line::Pause{kAfterNulls}});"),
        Edit("core/bus/enginedispatch.cpp",
             "line.run({Line::Nulls{}, Line::Pause{kAfterNulls}, DiscardInput{}}, now);",
             "line.run({Line::Pause{kAfterNulls}, DiscardInput{}}, now);"),
    )),
    Mutant("no-flush-in-a-resync", "link.md 2.2: 16 nulls, or a module goes on waiting for the rest of a packet", (
        Edit("core/bus/enginedispatch.cpp",
             "line.run({Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{},",
             "line.run({Line::Pause{m_quarantine}, DiscardInput{},"),
    )),
    Mutant("no-quarantine", "link.md 2.2: a late reply is waited out, or it answers the next command", (
        Edit("core/bus/enginedispatch.cpp",
             "line.run({Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{},",
             "line.run({DiscardInput{}, Line::Nulls{},"),
    )),
    Mutant("blind-retry-of-set-address", "link.md 2.3: the new address is asked first, or two modules get it", (
        Edit("core/bus/discovery.cpp",
             "return enter(Phase::Probe);",
             "return m_setAttempts < 3 ? enter(Phase::Set) : enter(Phase::Probe);"),
    )),
    Mutant("load-and-start-in-one", "link.md 1: a trapezoidal move is never started by the command that loads it", (
        Edit("core/bus/gate.cpp",
             "return load.startNow ? Verdict::Never : onlyAtStandstill(belief);",
             "return onlyAtStandstill(belief);"),
    )),
    Mutant("blind-retry-of-start", "link.md 2.3: a start that nobody answered is never repeated", (
        Edit("core/bus/retrypolicy.h",
             "        case CommandCode::StartMotion:\n        case CommandCode::ResetPosition:",
             "        case CommandCode::StartMotion:\n            return {AfterSilence::Repeat, 2};\n"
             "        case CommandCode::ResetPosition:"),
    )),
    Mutant("reset-position-in-motion", "protocol.md: not in a trapezoidal move", (
        Edit("core/bus/gate.cpp",
             "Verdict operator()(const ResetPosition&) const { return onlyAtStandstill(belief); }",
             "Verdict operator()(const ResetPosition&) const { return Verdict::Allowed; }"),
    )),
    Mutant("one-look-after-a-stop", "link.md 2.6: confirmed twice", (
        Edit("core/bus/stoprun.cpp", "} else if (target.confirmed == 2) {",
             "} else if (target.confirmed >= 1) {"),
    )),
)
