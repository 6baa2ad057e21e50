// SPDX-License-Identifier: MIT
#include "bus/holdlane.h"

#include <algorithm>
#include <utility>

#include "module/profiledload.h"

namespace nmc::bus {

void HoldLane::end(std::uint32_t press) {
    m_over = std::max(press, m_over.value_or(press));
}

void HoldLane::hold(const HoldToMove& hold, TimePoint now) {
    if (over(hold.press))
        return;
    m_wanted = hold;
    if (m_sent)
        m_sent->press = hold.press;  // the same motion need not be sent twice
    m_until = now + m_timeout;
}

std::optional<HoldToMove> HoldLane::release() {
    if (m_wanted)
        end(m_wanted->press);
    const bool loaded = std::exchange(m_loaded, false);
    const auto wanted = std::exchange(m_wanted, std::nullopt);
    const auto sent = std::exchange(m_sent, std::nullopt);
    return loaded && !sent ? wanted : sent;
}

void HoldLane::clear() {
    (void)release();
}

std::optional<TimePoint> HoldLane::deadline() const {
    return m_wanted ? std::optional(m_until) : std::nullopt;
}

std::optional<Order> HoldLane::start() const {
    if (!m_wanted || m_wanted == m_sent)
        return std::nullopt;
    const HoldToMove& hold = *m_wanted;
    const auto goal = m_sent ? std::nullopt : hold.goal;
    if (hold.pace) {
        auto load = profiledLoad(hold.pace->speed, hold.pace->accelerationTime, goal, hold.reverse);
        load.startNow = !goal;
        return Order{hold.module, StepperCommand(load)};
    }
    auto load = profiledLoad(hold.velocity, hold.acceleration, goal, hold.reverse);
    load.startNow = !goal;
    return Order{hold.module, ServoCommand(load)};
}

Order HoldLane::startLoaded() const {
    return {m_wanted->module,
            forChip(m_wanted->pace ? ModuleType::Stepper : ModuleType::Servo, StartMotion{})};
}

}  // namespace nmc::bus
