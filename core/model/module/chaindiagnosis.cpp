// SPDX-License-Identifier: MIT
#include "model/module/chaindiagnosis.h"

#include <algorithm>

namespace nmc {

namespace {

using Finding = ChainDiagnosis::Finding;

ChainPlace placeOf(std::size_t index, const Machine& machine, const LinkState& link) {
    ChainPlace place;
    place.module = ModuleIndex(static_cast<std::uint8_t>(index));
    if (index < machine.axes.size()) {
        place.name = machine.axes[index].name;
        place.expected = machine.axes[index].expected;
    }
    if (index >= link.modules.size()) {
        place.state = ChainPlace::State::Missing;
        return place;
    }
    const ModuleState& module = link.modules[index];
    place.found = module.info.identity;
    place.otherType = module.otherType();
    if (module.hasRestarted)
        place.state = ChainPlace::State::Restarted;
    else if (module.notAsked)
        place.state = ChainPlace::State::NotAsked;
    else if (!module.lookedFor && !isLive(link, module))
        place.state = ChainPlace::State::Unresponsive;
    else if (!place.expected)
        place.state = ChainPlace::State::New;
    else if (*place.expected != *place.found)
        place.state = ChainPlace::State::Different;
    return place;
}

std::optional<ModuleIndex> firstWith(const std::vector<ChainPlace>& places, ChainPlace::State state) {
    const auto place = std::ranges::find(places, state, &ChainPlace::state);
    return place == places.end() ? std::nullopt : std::optional(place->module);
}

/// True if the modules found are the last ones expected, in the same order.
bool isTail(const ChainDiagnosis& chain) {
    if (chain.found == 0 || chain.found >= chain.expected)
        return false;
    const std::size_t shift = chain.expected - chain.found;
    for (std::size_t i = 0; i < chain.found; ++i)
        if (chain.places[i].found != chain.places[i + shift].expected)
            return false;
    return true;
}

void conclude(ChainDiagnosis& chain) {
    for (const auto& [state, finding] : {std::pair{ChainPlace::State::Restarted, Finding::Restarted},
                                         std::pair{ChainPlace::State::Unresponsive, Finding::Unresponsive}})
        if (const auto at = firstWith(chain.places, state)) {
            chain.finding = finding;
            chain.at = at;
            return;
        }
    const auto different = firstWith(chain.places, ChainPlace::State::Different);
    if (different && isTail(chain)) {
        chain.finding = Finding::FarEndMissing;
    } else if (different) {
        chain.finding = Finding::OtherHardware;
        chain.at = different;
    } else if (chain.found == 0) {
        chain.finding = Finding::NobodyAnswers;
    } else if (chain.found < chain.expected) {
        chain.finding = Finding::BreakBehind;
        chain.at = ModuleIndex(static_cast<std::uint8_t>(chain.found - 1));
    } else if (chain.expected == 0) {
        chain.finding = Finding::NothingExpected;
    } else if (chain.found > chain.expected) {
        chain.finding = Finding::MoreThanBefore;
        chain.at = firstWith(chain.places, ChainPlace::State::New);
    } else {
        chain.finding = Finding::Fine;
    }
}

}  // namespace

unsigned expectedModules(const Machine& machine) {
    unsigned last = 0;
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        if (machine.axes[i].expected)
            last = static_cast<unsigned>(i) + 1;
    return last;
}

ChainDiagnosis diagnose(const Machine& machine, const LinkState& link) {
    ChainDiagnosis chain;
    chain.expected = expectedModules(machine);
    chain.found = static_cast<unsigned>(link.modules.size());
    for (std::size_t i = 0; i < std::max(chain.expected, chain.found); ++i)
        chain.places.push_back(placeOf(i, machine, link));
    if (link.phase == LinkPhase::Connected || link.phase == LinkPhase::Lost)
        conclude(chain);
    else if (link.phase == LinkPhase::Connecting && link.looking)
        chain.finding = Finding::Looking;
    return chain;
}

}  // namespace nmc
