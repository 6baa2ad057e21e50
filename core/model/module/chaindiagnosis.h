// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/module/linkstate.h"
#include "model/settings/machine.h"

namespace nmc {

/// One place of the chain: what the user's machine has there, and what answers.
struct ChainPlace {
    enum class State : std::uint8_t {
        Fine,
        New,           ///< nothing was expected here
        Different,     ///< another type or version
        Missing,       ///< expected, and did not answer when the chain was found
        Unresponsive,  ///< was found, and does not answer any more
        Restarted,
    };
    ModuleIndex module;
    std::string name;
    std::optional<ModuleIdentity> expected;
    std::optional<ModuleIdentity> found;
    State state = State::Fine;

    bool operator==(const ChainPlace&) const = default;
};

/// Expected against found, and where the chain probably breaks. Addresses are given from the far end on: the
/// module farthest from the PC is the first, and each lets the next one towards the PC speak (DS-V 4.1).
struct ChainDiagnosis {
    enum class Finding : std::uint8_t {
        NotConnected,
        Looking,  ///< again, for the modules that are known
        Fine,
        NothingExpected,  ///< nobody has said yet what belongs there
        NobodyAnswers,
        BreakBehind,     ///< the first places answer: look between `at` and the next one towards the PC
        FarEndMissing,   ///< what answers are the last ones expected: the far end was cut off at a new first
                         ///< module
        OtherHardware,   ///< types or versions are others, from `at` on
        MoreThanBefore,  ///< `at` is the first new one
        Unresponsive,    ///< `at` and perhaps others stopped answering
        Restarted,       ///< `at` did, and what lies behind it towards the PC may be deaf
    };
    Finding finding = Finding::NotConnected;
    std::optional<ModuleIndex> at;
    unsigned expected = 0;
    unsigned found = 0;
    std::vector<ChainPlace> places;

    bool operator==(const ChainDiagnosis&) const = default;
};

/// How long the chain is that the machine expects; 0: it expects nothing.
[[nodiscard]] unsigned expectedModules(const Machine& machine);
/// Pure.
[[nodiscard]] ChainDiagnosis diagnose(const Machine& machine, const LinkState& link);

}  // namespace nmc
