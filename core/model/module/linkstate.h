// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bus/types.h"
#include "model/module/modulestate.h"

namespace nmc {

enum class LinkPhase : std::uint8_t { Disconnected, Connecting, Connected, Lost };

/// The whole connection as a value: what the tool bar, the chain list and the status bar show.
struct LinkState {
    LinkPhase phase = LinkPhase::Disconnected;
    std::string port;  ///< as the user chose it
    bool simulated = false;
    std::uint32_t baud = 0;
    bus::ConnectStage stage = bus::ConnectStage::Restarting;
    std::uint8_t found = 0;            ///< modules found so far while connecting
    std::vector<ModuleState> modules;  ///< in the order of addressing: farthest from the host first
};

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
