// SPDX-License-Identifier: MIT
#include "sim/steppermachine.h"

#include <algorithm>
#include <array>
#include <limits>

namespace nmc::sim {

namespace {

struct Level {
    Input input;
    bool StepperPins::*pin;
};
constexpr std::array kLevels{Level{Input::Limit1, &StepperPins::limit1},
                             Level{Input::Limit2, &StepperPins::limit2},
                             Level{Input::Power, &StepperPins::power},
                             Level{Input::Estop, &StepperPins::estop},
                             Level{Input::In1, &StepperPins::in1},
                             Level{Input::In2, &StepperPins::in2},
                             Level{Input::HomeSwitch, &StepperPins::homeSwitch}};

struct ShaftPlace {
    Input input;
    std::optional<std::int64_t> StepperSurroundings::*place;
};
constexpr std::array kShaftPlaces{ShaftPlace{Input::TravelMin, &StepperSurroundings::travelMin},
                                  ShaftPlace{Input::TravelMax, &StepperSurroundings::travelMax},
                                  ShaftPlace{Input::HomeSwitchAt, &StepperSurroundings::homeSwitchAt}};

}  // namespace

void StepperMachine::set(Input input, std::optional<double> value) {
    const bool level = value.value_or(0.0) != 0.0;
    const auto steps = static_cast<std::int64_t>(value.value_or(0.0));
    for (const Level& one : kLevels)
        if (one.input == input)
            m_set.*one.pin = level;
    for (const ShaftPlace& one : kShaftPlaces)
        if (one.input == input)
            m_around.*one.place = value ? std::optional(steps) : std::nullopt;
    if (input == Input::Analog)
        m_set.analog = static_cast<std::uint8_t>(steps);
    if (input == Input::Limits)
        m_around.limitsAutomatic = level;
    if (input == Input::LoadPlay) {
        m_around.loadPlay = steps;
        turn(0);
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
