// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus/types.h"
#include "model/module/modulestate.h"

namespace nmc {

enum class LinkPhase : std::uint8_t { Disconnected, Connecting, Connected, Lost };

/// The whole connection as a value: what the tool bar, the chain list and the status bar show.
struct LinkState {
    LinkPhase phase = LinkPhase::Disconnected;
    /// Which connection of this program, counted from 1; the last one while there is none. 0: none yet.
    std::uint32_t connection = 0;
    bool unplugged = false;  ///< that ended it: what was shown last is the last that is known
    std::string port;        ///< as the user chose it
    bool simulated = false;
    /// Nothing is sent but questions, and a stop of all: what moves is nobody's here (faults.md H-02).
    bool readOnly = false;
    /// What an operator may ask for; empty: the panel is not locked.
    std::optional<OperatorRights> rights{};
    std::uint32_t baud = 0;
    bus::ConnectStage stage = bus::ConnectStage::Restarting;
    /// While connecting: the modules below are looked for where they were, and have not been told anything
    /// that would change that. What they do, they go on doing.
    bool looking = false;
    std::uint8_t found = 0;            ///< modules found so far while connecting
    std::vector<ModuleState> modules;  ///< in the order of addressing: farthest from the host first
    /// One that is asked as often as the wire carries, at the cost of the others.
    std::optional<ModuleIndex> focused{};
    /// When this is looked at; empty: nothing is old.
    std::optional<TimePoint> now{};

    /// What the machine says of how its axes may move goes along with their modules, where every rule finds
    /// it.
    void take(const Machine& machine);
};

/// The same as it may be shown: a module that is not asked any more, since the link is lost or the chain is
/// given its addresses again, does not answer, whatever it said last. While it is only looked for, that is no
/// news of the module. What shows modules shows these.
[[nodiscard]] LinkState asShown(LinkState link);
/// Whether what this module said last may be shown as what is so now. The one rule for everything that does.
[[nodiscard]] bool isLive(const LinkState& link, const ModuleState& module);

/// It is known of this chain, and has not answered since the chain was found; nor has it been heard of as
/// restarted.
[[nodiscard]] bool isMissing(const ModuleState& module);

/// What the status bar pulls once a second.
struct LinkFigures {
    double exchangesPerSecond = 0;
    double wireShare = 0;  ///< of what a perfect line would carry, 0..1
    double errorsPerSecond = 0;
    std::uint64_t errors = 0;  ///< since the connection was made
    double meanRoundTripMs = 0;
    bus::LinkStatistics counters{};  ///< behind these figures, since the chain was found
};

}  // namespace nmc
