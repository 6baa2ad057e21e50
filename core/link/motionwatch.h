// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "model/modulestate.h"

namespace nmc {

/// Whether some motor moves, or moved when its module was last heard of: the bus thread's own copy, for the
/// time when nobody in the GUI thread looks.
class MotionWatch {
public:
    void take(const bus::Event& event) {
        if (const auto* chain = std::get_if<bus::ChainFound>(&event)) {
            m_modules.assign(chain->modules.size(), {});
            for (std::size_t i = 0; i < m_modules.size(); ++i)
                m_modules[i].info = chain->modules[i];
        } else if (const auto* sample = std::get_if<bus::Sample>(&event)) {
            apply(*sample);
        } else if (const auto* executed = std::get_if<bus::CommandExecuted>(&event)) {
            apply(*executed);
        }
    }
    [[nodiscard]] bool anyMoves() const { return std::any_of(m_modules.begin(), m_modules.end(), moves); }

private:
    [[nodiscard]] static bool moves(const ModuleState& module) {
        const bool stepper = module.info.identity.type == ModuleType::Step;
        return stepper ? module.latest && module.latest->stepStatus().moving() : module.moving();
    }
    template <typename Event>
    void apply(const Event& event) {
        if (event.module.value() < m_modules.size())
            m_modules[event.module.value()].apply(event);
    }

    std::vector<ModuleState> m_modules;
};

}  // namespace nmc
