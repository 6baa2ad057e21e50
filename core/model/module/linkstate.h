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

/// The line while it is lent to a program (docs/lending.md).
struct LentLine {
    std::string path;      ///< of the terminal
    bool inUse = false;    ///< the program has sent something
    bool heldOff = false;  ///< by a stop of all modules
    bool operator==(const LentLine&) const = default;
};

/// The whole connection as a value: the data behind the tool bar, the chain list and the status bar.
struct LinkState {
    LinkPhase phase = LinkPhase::Disconnected;
    /// Number of the connection within this program run, from 1; the last one while disconnected. 0: none
    /// yet.
    std::uint32_t connection = 0;
    /// Unplugging ended the last connection to this port, which has not been open since: the last values
    /// shown are the last known.
    bool unplugged = false;
    std::string port;  ///< as chosen by the user
    bool simulated = false;
    /// Only queries and a stop of all modules are sent: another host is responsible for what moves (faults.md
    /// H-02).
    bool readOnly = false;
    /// While the link is lost: it is because a module restarted, which would misread what is sent to the
    /// others. So nobody is asked any more, and nothing is sent except a stop of all modules.
    bool quiet = false;
    /// Nothing is sent except by that program, and by a stop of all modules.
    std::optional<LentLine> lent{};
    /// What an operator may request; empty: the panel is not locked.
    std::optional<OperatorRights> rights{};
    std::uint32_t baud = 0;
    Duration latency{};  ///< delay of replies that is allowed for, once the port is open
    bus::ConnectStage stage = bus::ConnectStage::Restarting;
    /// While connecting: the modules below are searched for at their last addresses, and have been sent
    /// nothing that would change these. Whatever they are doing continues.
    bool looking = false;
    std::uint8_t found = 0;            ///< modules found so far while connecting
    std::vector<ModuleState> modules;  ///< in addressing order: farthest from the host first
    /// The module polled as often as the line allows, at the expense of the others.
    std::optional<ModuleIndex> focused{};
    /// The time of this view; empty: nothing is out of date.
    std::optional<TimePoint> now{};

    [[nodiscard]] bool isOpen() const { return phase != LinkPhase::Disconnected; }
    /// Modules are shown, and a stop of all of them may be requested: the port is open, or it was unplugged,
    /// and a stop waits for it.
    [[nodiscard]] bool hasChain() const { return isOpen() || unplugged; }
    /// Copies the settings of the user's machine on how its axes may move, as far as they are usable(), into
    /// their modules, where every precondition finds them.
    void take(const Machine& machine);
};

/// The machine as it applies to the modules that are there, with every axis as usable() for its module. The
/// user's own machine stays as it is, and applies again once the expected modules are back.
[[nodiscard]] Machine usable(Machine machine, const std::vector<ModuleState>& modules);

/// True if the machine has anything for this place that goes by the type of its module: settings other than
/// the name, a position in a point, or a row of a sequence.
[[nodiscard]] bool isSetUp(const Machine& machine, ModuleIndex module);

/// The state as it may be displayed: a module that is no longer polled, because the link is lost or addresses
/// are being assigned again, counts as not answering, whatever it reported last, and sends no replies. After
/// LinkState::quiet, those that did answer are shown as not asked. While modules are only searched for, this
/// does not apply. Everything that displays modules uses this.
[[nodiscard]] LinkState asShown(LinkState link);
/// The same for one module of `link`.
[[nodiscard]] ModuleState asShown(ModuleState module, const LinkState& link);
/// True if the module's last report may be shown as current. Every display uses this rule.
[[nodiscard]] bool isLive(const LinkState& link, const ModuleState& module);

/// True if the module is known to belong to this chain, but has not answered since the chain was found, nor
/// was it reported as restarted.
[[nodiscard]] bool isMissing(const ModuleState& module);
[[nodiscard]] std::vector<ModuleIndex> movingModules(const LinkState& link);

/// The figures that the status bar fetches once a second.
struct LinkFigures {
    double exchangesPerSecond = 0;
    double wireShare = 0;  ///< fraction of what an undisturbed line could carry, 0..1
    double errorsPerSecond = 0;
    std::uint64_t errors = 0;  ///< since the connection was opened
    double meanRoundTripMs = 0;
    bus::LinkStatistics counters{};  ///< the basis of these figures, since the chain was found
};

}  // namespace nmc
