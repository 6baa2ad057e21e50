// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace nmc {

/// What the user reads an axis in (interface.md, "Values"). The chip only knows counts (PIC-STEP: steps).
enum class UnitKind : std::uint8_t { Native, Turns, Degrees, Millimetres, Own };

/// What makes sense as AxisUnit::countsPerUnit, with much to spare; its sign apart.
inline constexpr double kMinCountsPerUnit = 1e-6;
inline constexpr double kMaxCountsPerUnit = 1e9;

struct AxisUnit {
    UnitKind kind = UnitKind::Native;
    /// Counts (steps) in one of them; below 0: a reversed axis, whose forward is the chip's reverse. 1 for
    /// UnitKind::Native.
    double countsPerUnit = 1.0;
    std::string ownSymbol{};  ///< of UnitKind::Own

    bool operator==(const AxisUnit&) const = default;
};

/// What one turn is, where the unit tells; of the axis, which behind a gear is not the motor's.
[[nodiscard]] std::optional<double> countsPerTurn(const AxisUnit& unit);
/// Counts that a motor may rest off its home and home still becomes zero: a thousandth of a turn or of an own
/// unit, a hundredth of a millimetre; never less than one, the grain of the encoder, which is all there is
/// for who thinks in counts.
[[nodiscard]] std::int32_t homeTolerance(const AxisUnit& unit);

/// Between the chip's numbers and the user's. "Native" is what the chip counts in: counts, counts per servo
/// tick, counts per servo tick squared on a PIC-SERVO, whose tick the servo rate stretches; steps, steps/s
/// and steps/s^2 on a PIC-STEP. With UnitKind::Native the user reads native numbers, too. Pure.
class AxisScale {
public:
    AxisScale() = default;
    /// `servoRate`: SR, 1..255 (DS-V 4.3). Empty: another host may have set it, so how long a tick is, and
    /// with it every number per second, is not known.
    [[nodiscard]] static AxisScale servo(AxisUnit unit, std::optional<int> servoRate);
    [[nodiscard]] static AxisScale step(AxisUnit unit);

    [[nodiscard]] const AxisUnit& unit() const { return m_unit; }
    /// The user's forward is the chip's reverse, his highest position the chip's lowest.
    [[nodiscard]] bool reversed() const { return countsPerUnit() < 0; }
    /// The chip's lowest and highest as the user's lowest and highest: he has them the other way round on a
    /// reversed axis.
    template <typename Place>
    [[nodiscard]] std::pair<Place, Place> ordered(Place lowest, Place highest) const {
        return reversed() ? std::pair(highest, lowest) : std::pair(lowest, highest);
    }
    /// A PIC-STEP: its positions are steps.
    [[nodiscard]] bool steps() const { return m_steps; }
    [[nodiscard]] bool native() const { return m_unit.kind == UnitKind::Native; }
    /// Native velocity times this is counts (steps) per second; empty: SR is not known.
    [[nodiscard]] std::optional<double> perSecond() const { return m_perSecond; }
    /// The user's velocities and accelerations can be told from the chip's.
    [[nodiscard]] bool timed() const { return native() || m_perSecond; }

    [[nodiscard]] double position(double counts) const { return counts / countsPerUnit(); }
    [[nodiscard]] double counts(double position) const { return position * countsPerUnit(); }
    /// Amounts, above 0 either way.
    [[nodiscard]] double distance(double counts) const { return counts / std::abs(countsPerUnit()); }
    [[nodiscard]] double countsOfDistance(double distance) const {
        return distance * std::abs(countsPerUnit());
    }
    /// Amounts in the user's units per second; with UnitKind::Native they stay native. These four are empty
    /// unless timed().
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

}  // namespace nmc
