// SPDX-License-Identifier: MIT
#include "bus/rejoin.h"

#include <algorithm>

namespace nmc::bus {

namespace {

[[nodiscard]] auto findIn(const std::vector<ModuleInfo>& modules, const ModuleInfo& info) {
    return std::ranges::find_if(modules, [&](const ModuleInfo& other) { return sameModule(other, info); });
}

}  // namespace

bool sameModule(const ModuleInfo& one, const ModuleInfo& other) {
    return one.address == other.address && one.identity == other.identity;
}

std::optional<Rejoined> rejoin(const std::vector<ModuleInfo>& known, const std::vector<ModuleInfo>& found,
                               std::optional<ModuleIdentity> unaddressed) {
    const bool ofIt = std::ranges::all_of(
        found, [&](const ModuleInfo& info) { return findIn(known, info) != known.end(); });
    if (found.empty() || !ofIt)
        return std::nullopt;
    Rejoined rejoined;
    for (const ModuleInfo& info : known) {
        const auto here = findIn(found, info);
        rejoined.modules.push_back(here != found.end() ? *here : info);
        rejoined.modules.back().index = info.index;
        if (here == found.end())
            rejoined.absent.push_back(info.index);
    }
    // Modules nearer the host may be cut off with it: it is the farthest of those that do not answer.
    if (unaddressed && !rejoined.absent.empty() &&
        known[rejoined.absent.front().value()].identity == *unaddressed)
        rejoined.restarted = rejoined.absent.front();
    return rejoined;
}

}  // namespace nmc::bus
