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

/// Taught points, and the sequences of rows that move between them. Values only; part of the machine.
namespace nmc {

/// The position of one axis at a point.
struct PointAxis {
    ModuleIndex module;
    /// Counts (steps) from home as given by HomeFact, which is adjusted when the counter is set to 0. If home
    /// was unknown, this is the value of the counter itself. Nothing moves there while home is known
    /// (taughtElsewhere()). While home is unknown, a counter that was set since is not noticed, because a
    /// machine without home switches has nothing else to go by.
    std::int32_t counts = 0;
    bool fromHome = true;

    bool operator==(const PointAxis&) const = default;
};

struct Point {
    std::string name;  ///< UTF-8; not empty; unique among the points
    std::vector<PointAxis> axes;

    bool operator==(const Point&) const = default;
};

/// Pins that a sequence can wait for: the limit pins of a PIC-SERVO or PIC-STEP that are inputs, the other
/// inputs of a PIC-STEP, and the pins of a PIC-I/O.
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

/// The number of a PIC-I/O's pin, from 0; empty for a pin of another chip.
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
/// Moves to a point at the axes' own velocity and acceleration (MotionSettings).
struct MoveTo {
    std::string point;
    bool together = true;    ///< all axes start at once; otherwise each waits for the previous one
    bool waits = true;       ///< until the axes arrive; otherwise the next row begins at once
    unsigned percent = 100;  ///< of the velocity, 1..100
    bool operator==(const MoveTo&) const = default;
};
struct Wait {
    double seconds = 1.0;
    bool operator==(const Wait&) const = default;
};
/// Waits for the arrival of all moves that were not waited for.
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
/// Sets OUT1..OUT5 of a PIC-STEP, or IO1..IO12 of a PIC-I/O and the limit pins 1 and 2 of a PIC-SERVO if
/// they are outputs (DS-V 5.2).
struct SetOutput {
    ModuleIndex module;
    unsigned output = 1;
    bool on = true;
    bool operator==(const SetOutput&) const = default;
};
/// Homes an axis by its own recipe.
struct Home {
    ModuleIndex module;
    bool operator==(const Home&) const = default;
};
/// Goes back to a row above until the rows from there on have run `times` times.
struct Repeat {
    std::size_t from = 0;
    unsigned times = 2;  ///< in total; 0: forever
    bool operator==(const Repeat&) const = default;
};
struct Call {
    std::string sequence;
    bool operator==(const Call&) const = default;
};
/// Waits until an analog input of a PIC-I/O is above the level, or below it.
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

/// The one module that a row sets, homes or waits for; empty for other rows.
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
    std::string name;  ///< UTF-8; not empty; unique among the sequences
    std::vector<Action> rows;

    bool operator==(const Sequence&) const = default;
};

/// All points and sequences of a machine.
struct Program {
    std::vector<Point> points;
    std::vector<Sequence> sequences;

    /// Returns null if no point has this name.
    [[nodiscard]] const Point* point(const std::string& name) const {
        const auto found = std::ranges::find(points, name, &Point::name);
        return found != points.end() ? &*found : nullptr;
    }
    /// Returns null if no sequence has this name.
    [[nodiscard]] const Sequence* sequence(const std::string& name) const {
        const auto found = std::ranges::find(sequences, name, &Sequence::name);
        return found != sequences.end() ? &*found : nullptr;
    }
    bool operator==(const Program&) const = default;
};

}  // namespace nmc
