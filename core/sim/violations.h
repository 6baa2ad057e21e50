// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/time.h"
#include "protocol/frame.h"

namespace nmc::sim {

/// What a host did that a real chip would not forgive, or that its data sheet forbids.
enum class ViolationKind : std::uint8_t {
    CommandInFlight,     ///< a command sent before the previous one was answered (DS-V 4.1)
    CommandOverwritten,  ///< a module lost a command to the next one (DS-V 4.1)
    TrapezoidInMotion,   ///< a trapezoidal move started or changed while the motor moved (DS-V 4.4)
    ResetInMotion,       ///< Reset Position in a servo's trapezoid or any motion of a stepper
    ReplyCollision,      ///< two modules answered at once: two leaders of a group, or one address twice
    WrongLength,         ///< the command byte announced another number of data bytes than the command has
    UnknownCommand,      ///< no such command on this chip
    StopBits,            ///< more than one manner of stopping in Stop Motor or Set Homing Mode
    OutOfRange,          ///< a value outside the data sheet's range
    SetBaudSingle,       ///< Set Baud Rate to an individual address (DS-V 5.2)
    Unsupported,         ///< not available on this version
    ModeTransition,      ///< not in the stepper's mode table, or not with what was loaded (DS-S 5.1, Table 4)
    DirectionChange,     ///< a stepper's direction changed without a stop (DS-S 4.1, 4.2)
    PathOverflow,        ///< a point that found the path buffer full
    ParametersNotSet,    ///< a stepper started before Set Parameters (DS-S 5.1)
};

/// Snake case, as in `stats`.
[[nodiscard]] std::string_view toText(ViolationKind kind);

struct Violation {
    TimePoint time;
    std::uint8_t module = 0;  ///< from 0, in the order of addressing
    ViolationKind kind = ViolationKind::CommandInFlight;
    PacketBytes bytes;  ///< the packet that did it
};

/// The violations in the order they happened. Keeps the first kCapacity and counts the rest: the first is the
/// one that explains the others.
class ViolationLog {
public:
    static constexpr std::size_t kCapacity = 10'000;

    void add(const Violation& violation);
    [[nodiscard]] const std::vector<Violation>& entries() const { return m_entries; }
    /// Including those that found no room.
    [[nodiscard]] std::uint64_t count() const { return m_count; }

private:
    std::vector<Violation> m_entries;
    std::uint64_t m_count = 0;
};

}  // namespace nmc::sim
