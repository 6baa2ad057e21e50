// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc::sim {

/// Levels of the pins that a home search can watch.
struct HomeInputs {
    bool limit1 = false;
    bool limit2 = false;
    bool index = false;  ///< the home switch of a stepper
};

/// The conditions that Set Homing Mode watches, and whether one has occurred (DS-V 5.2, DS-S 5.1).
class Homing {
public:
    enum class Stop : std::uint8_t { None, Off, Abrupt, Smooth };

    static constexpr std::uint8_t kLimit1 = 0x01;
    static constexpr std::uint8_t kLimit2 = 0x02;
    static constexpr std::uint8_t kMotorOff = 0x04;
    static constexpr std::uint8_t kIndex = 0x08;
    static constexpr std::uint8_t kStopAbruptly = 0x10;
    static constexpr std::uint8_t kStopSmoothly = 0x20;
    static constexpr std::uint8_t kPositionError = 0x40;
    static constexpr std::uint8_t kCurrentLimit = 0x80;

    /// A trigger is a change from the levels in `now`. A control byte that watches nothing cancels the
    /// search.
    void begin(std::uint8_t control, HomeInputs now);
    [[nodiscard]] bool inProgress() const { return m_inProgress; }
    [[nodiscard]] bool waitsFor(std::uint8_t condition) const {
        return m_inProgress && (m_control & condition) != 0;
    }
    /// Called once per maximum-rate tick while in progress. Returns true when the home position must be
    /// captured; the search is then over.
    bool triggered(HomeInputs now, bool positionErrorTrip, bool currentLimiting);
    /// How to stop the motor when home is found.
    [[nodiscard]] Stop stop() const;
    /// Stops the motor of `chip` like that.
    void stopMotor(auto& chip) const {
        switch (stop()) {
            case Stop::None:
                return;
            case Stop::Off:
                return chip.turnOff();
            case Stop::Abrupt:
                return chip.stopAbruptly();
            case Stop::Smooth:
                return chip.stopSmoothly();
        }
    }

private:
    HomeInputs m_baseline;
    std::uint8_t m_control = 0;
    bool m_inProgress = false;
};

}  // namespace nmc::sim
