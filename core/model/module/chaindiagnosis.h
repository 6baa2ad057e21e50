// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/module/linkstate.h"
#include "model/settings/machine.h"

namespace nmc {

/// One place in the chain: the module that the user's machine has there, and the one that answers.
struct ChainPlace {
    enum class State : std::uint8_t {
        Fine,
        New,           ///< nothing was expected here
        Different,     ///< another type or version
        Missing,       ///< expected, but did not answer when the chain was found
        Unresponsive,  ///< was found, but no longer answers
        NotAsked,      ///< sending has stopped, because another module restarted
        Restarted,
    };
    ModuleIndex module;
    std::string name;
    std::optional<ModuleIdentity> expected;
    std::optional<ModuleIdentity> found;
    bool otherType = false;  ///< the module found is only stopped, as of another type than set up
    State state = State::Fine;

    bool operator==(const ChainPlace&) const = default;
};

/// Compares the expected chain with the one found, and locates the probable break. Addresses are assigned
/// from the far end: the module farthest from the PC is the first, and each one enables the next towards the
/// PC (DS-V 4.1).
struct ChainDiagnosis {
    enum class Finding : std::uint8_t {
        NotConnected,
        Looking,  ///< searching again for the known modules
        Fine,
        NothingExpected,  ///< the machine does not state yet what belongs there
        NobodyAnswers,
        BreakBehind,     ///< the first places answer: check between `at` and the next one towards the PC
        FarEndMissing,   ///< the last ones expected answer: the far end is cut off, and a new first module
                         ///< begins the chain
        OtherHardware,   ///< types or versions differ from `at` on
        MoreThanBefore,  ///< `at` is the first new module
        Unresponsive,    ///< `at`, and perhaps others, stopped answering
        Restarted,       ///< `at` restarted; modules between it and the PC may not receive anything
    };
    Finding finding = Finding::NotConnected;
    std::optional<ModuleIndex> at;
    unsigned expected = 0;
    unsigned found = 0;
    std::vector<ChainPlace> places;

    bool operator==(const ChainDiagnosis&) const = default;
};

/// The length of the chain that the machine expects; 0: it expects nothing.
[[nodiscard]] unsigned expectedModules(const Machine& machine);
/// Compares the machine with the chain found. Pure.
[[nodiscard]] ChainDiagnosis diagnose(const Machine& machine, const LinkState& link);

}  // namespace nmc
