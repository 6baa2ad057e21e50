// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "sim/homing.h"
#include "sim/snapshot.h"
#include "sim/steppercurrent.h"
#include "sim/steppermachine.h"
#include "sim/steppermotion.h"
#include "sim/steppertransition.h"

namespace nmc::sim {

/// The stepper chip behind its commands: step generator, pins, and what the pins do to the motion (DS-S 4).
/// Pins are looked at once per tick, or not at all while nothing can change them.
class StepperControl {
public:
    /// Power-up. The machine that the chip is wired to stays as it is.
    void reset();
    void run(Duration time);
    void set(Input input, std::optional<double> value);

    // Commands.
    void resetPosition() { m_motion.resetPosition(); }
    void setParameters(const StepperParameters& parameters);
    [[nodiscard]] bool hasParameters() const { return m_hasParameters; }
    [[nodiscard]] const StepperTrajectory& loaded() const { return m_loaded; }
    void load(const StepperTrajectory& trajectory) { m_loaded = trajectory; }
    /// Executes what is loaded, unless a pin forbids it. The transition must be an allowed one.
    void start(StepperMode goal);
    [[nodiscard]] const StepperMotion& motion() const { return m_motion; }
    void setAmplifier(bool enabled);
    void stopAbruptly();
    void stopSmoothly();
    void setOutputs(std::uint8_t outputs) { m_outputs = outputs & kOutputPins; }
    void setHoming(std::uint8_t control);
    void saveAsHome() { m_home = m_motion.position(); }

    // Status.
    [[nodiscard]] std::uint8_t statusByte() const;
    [[nodiscard]] std::uint8_t inputsByte() const;
    [[nodiscard]] std::uint8_t analog() const { return m_pins.analog; }
    [[nodiscard]] std::int32_t home() const { return m_home; }
    [[nodiscard]] const Homing& homing() const { return m_homing; }
    [[nodiscard]] StepperSnapshot snapshot() const;

private:
    static constexpr std::uint8_t kOutputPins = 0x1F;
    static constexpr std::uint8_t kPowerUpOutputs = 0x10;

    void advance(Duration time);
    void watchPins();
    void watchHome();
    void turnOff();
    /// No driver power, or too hot a motor: no amplifier and no motion.
    [[nodiscard]] bool driverFails() const;
    [[nodiscard]] bool estopActs() const;
    [[nodiscard]] bool limitActs(bool reverse) const;
    [[nodiscard]] HomeInputs homePins() const;

    StepperMachine m_machine;
    StepperPins m_pins;          ///< the machine's, as the chip sees them
    bool m_pinsChanged = false;  ///< or what they mean
    StepperMotion m_motion;
    StepperTrajectory m_loaded;
    StepperParameters m_parameters;
    bool m_hasParameters = false;
    StepperCurrent m_current;
    bool m_ampEnabled = false;
    bool m_estopSeen = false;
    std::uint8_t m_outputs = kPowerUpOutputs;
    Homing m_homing;
    std::int32_t m_home = 0;
};

}  // namespace nmc::sim
