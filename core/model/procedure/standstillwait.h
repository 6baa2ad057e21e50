// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/standstill.h"
#include "model/module/modulestate.h"

namespace nmc {

/// A wait until a motor stands still, which only statuses latched after its beginning prove. Pure.
class StandstillWait {
public:
    /// The next call of over() begins another wait.
    void restart() { m_since.reset(); }
    /// Call after every update of the module. True if the motor stands.
    [[nodiscard]] bool over(const ModuleState& module, TimePoint now) {
        if (!m_since) {
            m_since = now;
            m_standstill.reset();
        }
        return module.latestTime > *m_since && module.latest && module.latest->position &&
               m_standstill.look(module.latestTime, *module.latest->position, module.moving());
    }
    /// Time since the first call of over().
    [[nodiscard]] Duration lasted(TimePoint now) const { return now - *m_since; }

private:
    std::optional<TimePoint> m_since;
    Standstill m_standstill;
};

}  // namespace nmc
