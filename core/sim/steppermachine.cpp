// SPDX-License-Identifier: MIT
#include "sim/steppermachine.h"

#include <algorithm>
#include <limits>

namespace nmc::sim {

void StepperMachine::set(Input input, std::optional<double> value) {
    const bool level = value.value_or(0.0) != 0.0;
    const auto steps = static_cast<std::int64_t>(value.value_or(0.0));
    const auto place = value ? std::optional(steps) : std::nullopt;
    switch (input) {
        case Input::Limit1:
            m_set.limit1 = level;
            return;
        case Input::Limit2:
            m_set.limit2 = level;
            return;
        case Input::Power:
            m_set.power = level;
            return;
        case Input::Estop:
            m_set.estop = level;
            return;
        case Input::In1:
            m_set.in1 = level;
            return;
        case Input::In2:
            m_set.in2 = level;
            return;
        case Input::HomeSwitch:
            m_set.homeSwitch = level;
            return;
        case Input::Analog:
            m_set.analog = static_cast<std::uint8_t>(steps);
            return;
        case Input::TravelMin:
            m_around.travelMin = place;
            return;
        case Input::TravelMax:
            m_around.travelMax = place;
            return;
        case Input::Limits:
            m_around.limitsAutomatic = level;
            return;
        case Input::HomeSwitchAt:
            m_around.homeSwitchAt = place;
            return;
        case Input::LoadPlay:
            m_around.loadPlay = steps;
            return turn(0);
        case Input::Index:
        case Input::Load:
        case Input::Inertia:
        case Input::Friction:
        case Input::Play:
        case Input::CountsPerTurn:
        case Input::Deadband:
        case Input::Gain:
        case Input::EncoderNoise:
        case Input::ElasticInertia:
        case Input::Resonance:
        case Input::ServoOverrun:
        case Input::Pulses:
        case Input::VoltSense:
        case Input::Pin:
            return;  // servo and PIC-I/O only
    }
}

void StepperMachine::turn(std::int64_t steps) {
    using Steps = std::numeric_limits<std::int64_t>;
    m_around.shaft = std::clamp(m_around.shaft + steps, m_around.travelMin.value_or(Steps::min()),
                                m_around.travelMax.value_or(Steps::max()));
    m_load = std::clamp(m_load, m_around.shaft - m_around.loadPlay, m_around.shaft);
}

StepperPins StepperMachine::pins() const {
    StepperPins pins = m_set;
    if (m_around.limitsAutomatic) {
        pins.limit1 = m_around.travelMax && m_around.shaft >= *m_around.travelMax;
        pins.limit2 = m_around.travelMin && m_around.shaft <= *m_around.travelMin;
    }
    if (m_around.homeSwitchAt)
        pins.homeSwitch = m_load >= *m_around.homeSwitchAt;
    return pins;
}

bool StepperMachine::shaftMovesPins() const {
    return (m_around.limitsAutomatic && (m_around.travelMin || m_around.travelMax)) || m_around.homeSwitchAt;
}

}  // namespace nmc::sim
