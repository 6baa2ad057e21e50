// SPDX-License-Identifier: MIT
#include "sim/steppermachine.h"

#include <algorithm>

namespace nmc::sim {

void StepperMachine::set(Input input, std::optional<double> value) {
    const bool level = value.value_or(0.0) != 0.0;
    const auto steps = static_cast<std::int64_t>(value.value_or(0.0));
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
            m_travelMin = value ? steps : kNoMin;
            return;
        case Input::TravelMax:
            m_travelMax = value ? steps : kNoMax;
            return;
        case Input::Limits:
            m_limitsAutomatic = level;
            return;
        case Input::HomeSwitchAt:
            m_homeSwitchAt.reset();
            if (value)
                m_homeSwitchAt = steps;
            return;
        case Input::LoadPlay:
            m_loadPlay = steps;
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
    m_shaft = std::clamp(m_shaft + steps, m_travelMin, m_travelMax);
    m_load = std::clamp(m_load, m_shaft - m_loadPlay, m_shaft);
}

StepperPins StepperMachine::pins() const {
    StepperPins pins = m_set;
    if (m_limitsAutomatic) {
        pins.limit1 = m_shaft >= m_travelMax;
        pins.limit2 = m_shaft <= m_travelMin;
    }
    if (m_homeSwitchAt)
        pins.homeSwitch = m_load >= *m_homeSwitchAt;
    return pins;
}

std::optional<std::int64_t> StepperMachine::travelMin() const {
    return m_travelMin == kNoMin ? std::nullopt : std::optional(m_travelMin);
}

std::optional<std::int64_t> StepperMachine::travelMax() const {
    return m_travelMax == kNoMax ? std::nullopt : std::optional(m_travelMax);
}

bool StepperMachine::shaftMovesPins() const {
    return (m_limitsAutomatic && (travelMin() || travelMax())) || m_homeSwitchAt;
}

}  // namespace nmc::sim
