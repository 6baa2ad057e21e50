// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace nmc {

/// The unit in which an axis is displayed (interface.md, "Values"). The chip only knows counts (PIC-STEP:
/// steps).
enum class UnitKind : std::uint8_t { Native, Turns, Degrees, Millimetres, Own };

/// The sensible range of AxisUnit::countsPerUnit regardless of its sign, with a wide margin.
inline constexpr double kMinCountsPerUnit = 1e-6;
inline constexpr double kMaxCountsPerUnit = 1e9;

struct AxisUnit {
    UnitKind kind = UnitKind::Native;
    /// Counts (steps) per unit; negative for a reversed axis, whose forward is the chip's reverse. 1 for
    /// UnitKind::Native.
    double countsPerUnit = 1.0;
    std::string ownSymbol{};  ///< only for UnitKind::Own

    bool operator==(const AxisUnit&) const = default;
};

/// The unit for other programs, in no language: "counts" (`steps`: "steps"), "turns", "deg", "mm", or the
/// user's own.
[[nodiscard]] std::string symbolOf(const AxisUnit& unit, bool steps);

/// Counts per turn, if the unit defines it. This is a turn of the axis, which after a gear is not a turn of
/// the motor.
[[nodiscard]] std::optional<double> countsPerTurn(const AxisUnit& unit);
/// The distance in counts from home at which a motor may rest so that home is still made zero: a thousandth
/// of a turn or of an own unit, or a hundredth of a millimetre; at least one, which is the encoder's
/// resolution, and the only choice when the unit is counts.
[[nodiscard]] std::int32_t homeTolerance(const AxisUnit& unit);

/// Converts between the chip's numbers and the user's. "Native" is what the chip counts in: counts, counts
/// per servo tick, and counts per servo tick squared on a PIC-SERVO, whose tick the servo rate lengthens;
/// steps, steps/s and steps/s^2 on a PIC-STEP. With UnitKind::Native, the user reads native numbers too.
/// Pure.
class AxisScale {
public:
    AxisScale() = default;
    /// `servoRate`: SR, 1..255 (DS-V 4.3). Empty: another host may have set it, so the length of a tick is
    /// unknown, and with it every value per second.
    [[nodiscard]] static AxisScale servo(AxisUnit unit, std::optional<int> servoRate);
    [[nodiscard]] static AxisScale step(AxisUnit unit);

    [[nodiscard]] const AxisUnit& unit() const { return m_unit; }
    /// True when the user's forward is the chip's reverse, and the user's highest position is the chip's
    /// lowest.
    [[nodiscard]] bool reversed() const { return countsPerUnit() < 0; }
    /// Orders the chip's lowest and highest as the user's lowest and highest; on a reversed axis they are
    /// exchanged.
    template <typename Place>
    [[nodiscard]] std::pair<Place, Place> ordered(Place lowest, Place highest) const {
        return reversed() ? std::pair(highest, lowest) : std::pair(lowest, highest);
    }
    /// True for a PIC-STEP, whose positions are steps.
    [[nodiscard]] bool steps() const { return m_steps; }
    [[nodiscard]] bool native() const { return m_unit.kind == UnitKind::Native; }
    /// The factor from native velocity to counts (steps) per second; empty when SR is unknown.
    [[nodiscard]] std::optional<double> perSecond() const { return m_perSecond; }
    /// True when the user's velocities and accelerations can be converted from the chip's.
    [[nodiscard]] bool timed() const { return native() || m_perSecond; }

    [[nodiscard]] double position(double counts) const { return counts / countsPerUnit(); }
    [[nodiscard]] double counts(double position) const { return position * countsPerUnit(); }
    /// Conversion of magnitudes, positive on a reversed axis too.
    [[nodiscard]] double distance(double counts) const { return counts / std::abs(countsPerUnit()); }
    [[nodiscard]] double countsOfDistance(double distance) const {
        return distance * std::abs(countsPerUnit());
    }
    /// Conversion of magnitudes to the user's units per second; with UnitKind::Native they stay native. These
    /// four are empty unless timed().
    [[nodiscard]] std::optional<double> velocity(double nativeVelocity) const;
    [[nodiscard]] std::optional<double> nativeVelocity(double velocity) const;
    [[nodiscard]] std::optional<double> acceleration(double nativeAcceleration) const;
    [[nodiscard]] std::optional<double> nativeAcceleration(double acceleration) const;

    bool operator==(const AxisScale&) const = default;

private:
    AxisScale(AxisUnit unit, std::optional<double> perSecond, bool steps);
    [[nodiscard]] double countsPerUnit() const { return native() ? 1.0 : m_unit.countsPerUnit; }

    AxisUnit m_unit;
    std::optional<double> m_perSecond = 1.0;
    bool m_steps = false;
};

/// The unit of a velocity for other programs, as symbolOf() is that of a position.
[[nodiscard]] std::string velocitySymbolOf(const AxisScale& scale, bool steps);

}  // namespace nmc
