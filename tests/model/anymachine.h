// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <string>

#include "model/settings/machine.h"

/// Arbitrary machines.
namespace nmc::testing_support {

inline double pick(double min, double max) {
    return min + (max - min) * *rc::gen::inRange(0, 1'000'000'001) / 1e9;
}
template <typename T>
T pickWhole(std::int64_t min, std::int64_t max) {
    return static_cast<T>(*rc::gen::inRange<std::int64_t>(min, max + 1));
}
inline bool coin() {
    return *rc::gen::arbitrary<bool>();
}
inline std::string pickName() {
    return *rc::gen::element<std::string>("", "Z", "Spindle \"left\"", "a\\b/c", "Übergabe 材料 🛑",
                                          "<b>");
}

/// Every pin and input has a name, because a comparison shows only those that were set.
inline PinSettings anyPins() {
    PinSettings settings;
    settings.pins.resize(pickWhole<std::size_t>(1, 12));
    settings.pwm.resize(pickWhole<std::size_t>(0, 2));
    settings.analog.resize(pickWhole<std::size_t>(0, 3));
    for (auto* list : {&settings.pins, &settings.pwm})
        for (OutputSettings& output : *list)
            output = {"Lamp " + pickName(), coin(), coin()};
    for (AnalogInput& input : settings.analog)
        input = {"Air " + pickName(), {pick(-10, 10), pick(-100, 100), "bar"}};
    return settings;
}

inline AxisSettings anyAxis() {
    AxisSettings axis;
    axis.name = pickName();
    if (coin())
        axis.expected = ModuleIdentity{pickWhole<ModuleType>(0, 255), pickWhole<std::uint8_t>(0, 255)};
    axis.unit = {pickWhole<UnitKind>(0, 4), pick(1e-6, 1e9), pickName()};
    axis.motion = {pick(0, 32'767), pick(0, 32'767), pick(0, 32'767),
                   pick(0, 32'767), pick(0, 32'767), pick(0, 2e9)};
    if (coin())
        axis.travel = {pickWhole<std::int32_t>(-0x7FFFFFFF, -1), pickWhole<std::int32_t>(0, 0x7FFFFFFF),
                       pick(0, 32'767)};
    else if (coin())
        axis.travel.highest = pickWhole<std::int32_t>(-0x7FFFFFFF, 0x7FFFFFFF);
    axis.backlash = {pick(0, 2e9), coin()};
    axis.arrival = {pick(0, 2e9), pick(0, 100)};
    axis.limitStop = {coin(), {coin(), coin(), pickWhole<HomingRecipe::Stop>(0, 2), coin(), coin()}};
    for (auto i = pickWhole<int>(0, 3); i > 0; --i)
        axis.workOffsets.push_back(
            {pickName() + std::to_string(i), pickWhole<std::int32_t>(-0x7FFFFFFF, 0x7FFFFFFF)});
    if (coin())
        axis.homing = HomingRecipe{
            coin(),          coin(),          coin(),          coin(),
            coin(),          coin(),          coin(),          coin(),
            pick(0, 32'767), pick(0, 32'767), pick(0, 32'767), pickWhole<HomingRecipe::Stop>(0, 2),
            pick(0, 2e9),    pick(0, 86'400), coin(),          coin()};
    axis.analog = {pick(-10, 10), pick(-1e6, 1e6), pickName()};
    if (coin())
        axis.gains = servo::SetGain{pickWhole<std::uint16_t>(0, 32'767),
                                    pickWhole<std::uint16_t>(0, 32'767),
                                    pickWhole<std::uint16_t>(0, 32'767),
                                    pickWhole<std::uint16_t>(0, 32'767),
                                    pickWhole<std::uint8_t>(0, 255),
                                    pickWhole<std::uint8_t>(0, 255),
                                    pickWhole<std::uint16_t>(0, 16'383),
                                    pickWhole<std::uint8_t>(1, 255),
                                    coin() ? std::optional(pickWhole<std::uint8_t>(0, 255)) : std::nullopt,
                                    coin() ? std::optional(pickWhole<std::uint8_t>(0, 255)) : std::nullopt};
    if (coin())
        axis.io = servo::IoControl{coin(), coin(), coin(), coin(), coin()};
    if (coin())
        axis.fastPath = coin();
    if (coin())
        axis.parameters = stepper::SetParameters{pickWhole<stepper::SpeedMode>(0, 3),
                                                 coin(),
                                                 coin(),
                                                 coin(),
                                                 pickWhole<std::uint8_t>(1, 250),
                                                 pickWhole<std::uint8_t>(0, 255),
                                                 pickWhole<std::uint8_t>(0, 255),
                                                 pickWhole<std::uint8_t>(0, 255)};
    axis.accelerationTime = pick(0, 255);
    for (std::string& name : axis.outputNames)
        name = pickName();
    for (std::string& name : axis.inputNames)
        name = pickName();
    if (coin())
        axis.pins = anyPins();
    return axis;
}

inline Action anyRow(const Program& program, std::size_t row, std::size_t sequence) {
    const auto axis = pickWhole<std::uint8_t>(0, 31);
    switch (pickWhole<int>(0, 8)) {
        case 0:
            if (!program.points.empty())
                return action::MoveTo{program.points.front().name, coin(), coin(),
                                      pickWhole<unsigned>(1, 100)};
            return action::WaitForArrival{};
        case 1:
            return action::Wait{pick(0, 86'400)};
        case 2:
            return action::WaitForInput{ModuleIndex(axis), pickWhole<InputPin>(0, 16), coin(),
                                        pick(0, 86'400)};
        case 3:
            return action::SetOutput{ModuleIndex(axis), pickWhole<unsigned>(1, 12), coin()};
        case 4:
            return action::Home{ModuleIndex(axis)};
        case 5:
            if (row > 0)
                return action::Repeat{pickWhole<std::size_t>(0, static_cast<std::int64_t>(row) - 1),
                                      pickWhole<unsigned>(0, 1'000'000)};
            return action::WaitForArrival{};
        case 6:
            if (sequence > 0)
                return action::Call{program.sequences.front().name};
            return action::WaitForArrival{};
        case 7:
            return action::WaitForAnalog{ModuleIndex(axis), pickWhole<unsigned>(1, 3), coin(),
                                         pickWhole<unsigned>(0, 255), pick(0, 86'400)};
        default:
            return action::WaitForArrival{};
    }
}

inline Program anyProgram() {
    Program program;
    for (std::size_t i = pickWhole<std::size_t>(0, 3); i > 0; --i) {
        Point point{pickName() + std::to_string(i), {}};
        for (std::uint8_t axis = 0; axis < 3; ++axis)
            if (coin())
                point.axes.push_back(
                    {ModuleIndex(axis), pickWhole<std::int32_t>(-0x7FFFFFFF, 0x7FFFFFFF), coin()});
        program.points.push_back(point);
    }
    for (std::size_t i = 0; i < pickWhole<std::size_t>(0, 3); ++i) {
        Sequence sequence{pickName() + std::to_string(i), {}};
        for (std::size_t rows = pickWhole<std::size_t>(0, 6); sequence.rows.size() < rows;)
            sequence.rows.push_back(anyRow(program, sequence.rows.size(), i));
        program.sequences.push_back(sequence);
    }
    return program;
}

inline Machine anyMachine() {
    Machine machine;
    machine.name = pickName();
    machine.baud = *rc::gen::element<std::uint32_t>(0, 9'600, 19'200, 57'600, 115'200);
    const auto count = pickWhole<std::size_t>(0, 6);
    for (std::size_t i = 0; i < count; ++i)
        machine.axes.push_back(anyAxis());
    for (std::size_t i = 0; i + 1 < count; i += 2) {
        GroupSettings group{static_cast<std::uint8_t>(0x81 + i), pickName(), {}, {}};
        group.members = {ModuleIndex(static_cast<std::uint8_t>(i)),
                         ModuleIndex(static_cast<std::uint8_t>(i + 1))};
        if (coin())
            group.leader = group.members[coin() ? 1 : 0];
        machine.groups.push_back(group);
    }
    machine.program = anyProgram();
    if (coin())
        machine.homeOrder = {ModuleIndex(3), ModuleIndex(0)};
    return machine;
}

}  // namespace nmc::testing_support
