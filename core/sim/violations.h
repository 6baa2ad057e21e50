// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/time.h"
#include "protocol/frame.h"

namespace nmc::sim {

/// What a host did that a real chip would not tolerate, or that its data sheet forbids: see violationTable().
enum class ViolationKind : std::uint8_t {
    CommandInFlight,
    CommandOverwritten,
    TrapezoidInMotion,
    ResetInMotion,
    ReplyCollision,
    WrongLength,
    UnknownCommand,
    StopBits,
    OutOfRange,
    ReservedBits,
    SetBaudSingle,
    Unsupported,
    ModeTransition,
    DirectionChange,
    PathOverflow,
    ParametersNotSet,
    VelocityNotLoaded,
};

struct ViolationRow {
    ViolationKind kind;
    std::string_view name;  ///< snake case, as in `stats`
    std::string_view meaning;
};

/// All kinds, in order.
[[nodiscard]] std::span<const ViolationRow> violationTable();

/// The kind's name.
[[nodiscard]] std::string_view toText(ViolationKind kind);

struct Violation {
    TimePoint time;
    std::uint8_t module = 0;  ///< from 0, in addressing order
    ViolationKind kind = ViolationKind::CommandInFlight;
    PacketBytes bytes;  ///< the packet that caused it
};

/// The violations in order of occurrence, and separately the remarks: a data sheet advises against these, but
/// specifies the result. Only the first kCapacity entries are kept, because the first one explains the
/// others; violations are counted beyond that.
class ViolationLog {
public:
    static constexpr std::size_t kCapacity = 10'000;

    void add(const Violation& violation);
    void remark(const Violation& violation);
    void clear() { *this = {}; }
    [[nodiscard]] const std::vector<Violation>& entries() const { return m_entries; }
    /// Includes violations beyond kCapacity.
    [[nodiscard]] std::uint64_t count() const { return m_count; }
    [[nodiscard]] const std::vector<Violation>& remarks() const { return m_remarks; }

private:
    std::vector<Violation> m_entries;
    std::vector<Violation> m_remarks;
    std::uint64_t m_count = 0;
};

}  // namespace nmc::sim
