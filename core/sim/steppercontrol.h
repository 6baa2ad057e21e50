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

/// The stepper chip without its command parser: step generator, pins, and the effect of the pins on the
/// motion (DS-S 4). The pins are sampled once per tick, or not at all while nothing can change them.
class StepperControl {
public:
    /// Restores the power-up state. The machine that the chip is wired to stays as it is.
    void reset();
    void run(Duration time);
    void set(Input input, std::optional<double> value);

    // Commands.
    void resetPosition() { m_motion.resetPosition(); }
    void setParameters(const StepperParameters& parameters);
    [[nodiscard]] bool hasParameters() const { return m_hasParameters; }
    [[nodiscard]] const StepperTrajectory& loaded() const { return m_loaded; }
    void load(const StepperTrajectory& trajectory) { m_loaded = trajectory; }
    /// Executes what is loaded, unless a pin forbids it. The mode transition must be allowed.
    void start(StepperMode goal);
    [[nodiscard]] const StepperMotion& motion() const { return m_motion; }
    void setAmplifier(bool enabled);
    void turnOff();
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
    /// True without driver power or with an overheated motor: amplifier and motion are then off.
    [[nodiscard]] bool driverFails() const;
    [[nodiscard]] bool estopActs() const;
    [[nodiscard]] bool limitActs(bool reverse) const;
    [[nodiscard]] HomeInputs homePins() const;

    StepperMachine m_machine;
    StepperPins m_pins;          ///< the machine's pins, as the chip last saw them
    bool m_pinsChanged = false;  ///< the pins have changed, or their meaning has
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
