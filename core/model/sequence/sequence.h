// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/strong.h"

/// Taught points, and the tables of rows that are run between them. Values only; part of the machine.
namespace nmc {

/// Where one axis stands at a point.
struct PointAxis {
    ModuleIndex module;
    /// Counts (steps) from home as HomeFact knows it, which goes along when the counter is set to 0. Without
    /// a known home they are the counter's own: of use until home is found or the counter is set.
    std::int32_t counts = 0;
    bool fromHome = true;

    bool operator==(const PointAxis&) const = default;
};

struct Point {
    std::string name;  ///< UTF-8; not empty, and no other point has it
    std::vector<PointAxis> axes;

    bool operator==(const Point&) const = default;
};

/// What a sequence can wait for: a limit pin of either chip that is an input, the others of a PIC-STEP, and
/// the pins of a PIC-I/O.
enum class InputPin : std::uint8_t {
    Limit1,
    Limit2,
    In1,
    In2,
    HomeSwitch,
    Io1,
    Io2,
    Io3,
    Io4,
    Io5,
    Io6,
    Io7,
    Io8,
    Io9,
    Io10,
    Io11,
    Io12
};

/// Which of a PIC-I/O's pins, from 0; nothing: of another chip.
[[nodiscard]] constexpr std::optional<unsigned> ioPin(InputPin pin) {
    if (pin < InputPin::Io1)
        return std::nullopt;
    return static_cast<unsigned>(pin) - static_cast<unsigned>(InputPin::Io1);
}
[[nodiscard]] constexpr InputPin inputPin(unsigned ioPin) {
    return static_cast<InputPin>(static_cast<unsigned>(InputPin::Io1) + ioPin);
}

/// The rows of a sequence.
namespace action {
/// At the axes' own velocity and acceleration (MotionSettings).
struct MoveTo {
    std::string point;
    bool together = true;    ///< all axes start at once; otherwise each waits for the one before
    bool waits = true;       ///< until they are there; otherwise the next row begins at once
    unsigned percent = 100;  ///< of the velocity, 1..100
    bool operator==(const MoveTo&) const = default;
};
struct Wait {
    double seconds = 1.0;
    bool operator==(const Wait&) const = default;
};
/// Of all moves that were not waited for.
struct WaitForArrival {
    bool operator==(const WaitForArrival&) const = default;
};
struct WaitForInput {
    ModuleIndex module;
    InputPin pin = InputPin::Limit1;
    bool active = true;     ///< PIC-I/O: high
    double timeout = 10.0;  ///< s; then the sequence fails
    bool operator==(const WaitForInput&) const = default;
};
/// OUT1..OUT5 of a PIC-STEP; IO1..IO12 of a PIC-I/O and the limit pins 1 and 2 of a PIC-SERVO, where they are
/// outputs (DS-V 5.2).
struct SetOutput {
    ModuleIndex module;
    unsigned output = 1;
    bool on = true;
    bool operator==(const SetOutput&) const = default;
};
/// By the axis's own recipe.
struct Home {
    ModuleIndex module;
    bool operator==(const Home&) const = default;
};
/// Back to a row above, until it was done that many times.
struct Repeat {
    std::size_t from = 0;
    unsigned times = 2;  ///< 0: for ever
    bool operator==(const Repeat&) const = default;
};
struct Call {
    std::string sequence;
    bool operator==(const Call&) const = default;
};
/// Of a PIC-I/O: until it is above the level, or below.
struct WaitForAnalog {
    ModuleIndex module;
    unsigned input = 1;  ///< 1..3
    bool above = true;
    unsigned level = 128;   ///< 0..255
    double timeout = 10.0;  ///< s; then the sequence fails
    bool operator==(const WaitForAnalog&) const = default;
};
}  // namespace action

using Action =
    std::variant<action::MoveTo, action::Wait, action::WaitForArrival, action::WaitForInput,
                 action::SetOutput, action::Home, action::Repeat, action::Call, action::WaitForAnalog>;

/// The one module that a row sets, homes or waits for.
[[nodiscard]] inline std::optional<ModuleIndex> moduleOf(const Action& row) {
    return std::visit(
        [](const auto& action) -> std::optional<ModuleIndex> {
            if constexpr (requires { action.module; })
                return action.module;
            else
                return std::nullopt;
        },
        row);
}

struct Sequence {
    std::string name;  ///< UTF-8; not empty, and no other sequence has it
    std::vector<Action> rows;

    bool operator==(const Sequence&) const = default;
};

/// All points and sequences of a machine.
struct Program {
    std::vector<Point> points;
    std::vector<Sequence> sequences;

    /// Null for none of that name.
    [[nodiscard]] const Point* point(const std::string& name) const {
        const auto found = std::ranges::find(points, name, &Point::name);
        return found != points.end() ? &*found : nullptr;
    }
    [[nodiscard]] const Sequence* sequence(const std::string& name) const {
        const auto found = std::ranges::find(sequences, name, &Sequence::name);
        return found != sequences.end() ? &*found : nullptr;
    }
    bool operator==(const Program&) const = default;
};

}  // namespace nmc
