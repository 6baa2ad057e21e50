// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace nmc::sim {

/// Parameters of the motor, its load, its amplifier and its encoder. The defaults describe a small 24 V servo
/// motor.
struct MotorParameters {
    double supplyVolts = 24.0;
    double resistanceOhm = 1.1;
    double inductanceHenry = 0.6e-3;
    double motorConstant = 0.038;     ///< torque constant, N·m/A, and back-EMF constant, V·s/rad
    double inertiaKgM2 = 1.7e-5;      ///< rotor and load
    double viscousNmS = 1e-6;         ///< friction torque per speed, N·m·s/rad
    double coulombNm = 0.004;         ///< dry friction; it also holds the shaft at rest
    double loadNm = 0.0;              ///< external torque; positive pulls the shaft backwards
    double countsPerTurn = 2000.0;    ///< encoder edges per turn
    std::int64_t playCounts = 0;      ///< counts that the shaft turns before the encoder follows
    std::int64_t loadPlayCounts = 0;  ///< counts that the encoder turns before the home switch's cam follows
    double encoderNoiseCounts = 0.0;  ///< rms error of the encoder, drawn anew each tick
    double elasticInertiaKgM2 = 0.0;  ///< second mass on a spring at the shaft; 0: none
    double resonanceHz = 50.0;  ///< frequency at which shaft and second mass oscillate against each other
    double adCountsPerAmpere = 255.0 / 5;  ///< current sense: 1 V per ampere, 255 = 5 V
    int amplifierDeadbandPwm = 0;          ///< PWM counts that produce no output
    double travelMinCounts = -std::numeric_limits<double>::infinity();  ///< hard stops, in shaft counts
    double travelMaxCounts = std::numeric_limits<double>::infinity();

    /// Speed per PWM count without friction and deadband, in counts per second: the gain K of docs/tuning.md.
    [[nodiscard]] double gain() const { return supplyVolts / 255.0 * speedPerVolt(); }
    /// Changes the supply voltage so that the gain has this value.
    void setGain(double gain) { supplyVolts = 255.0 * gain / speedPerVolt(); }

private:
    [[nodiscard]] double speedPerVolt() const {
        return countsPerTurn / (2.0 * std::numbers::pi) / motorConstant;
    }
};

/// A brushed DC motor driven by a sign-magnitude bridge. The electrical and mechanical equations are solved
/// exactly over each sub-step, including dry friction as long as the direction does not change:
///
///     L di/dt = V - R i - K w        J dw/dt = K i - b w - load - coulomb sgn(w)
///
/// At PWM 0 the bridge shorts the motor (it brakes); a disabled or unpowered bridge is open and the motor
/// coasts.
///
/// A second mass on a spring is part of the load, and is at rest when it is attached. Within a sub-step the
/// spring's torque is constant at its value in the middle of the sub-step (leapfrog): at the highest
/// resonance, 400 Hz, the oscillation is 0.4 % too fast. A fiftieth of critical damping brings it to rest.
class MotorPlant {
public:
    static constexpr int kSubsteps = 4;
    static constexpr double kSubstepSeconds = 512e-6 / kSubsteps;

    explicit MotorPlant(const MotorParameters& parameters = {}) { setParameters(parameters); }

    void setParameters(const MotorParameters& parameters);
    [[nodiscard]] const MotorParameters& parameters() const { return m_parameters; }

    /// Advances one maximum-rate servo tick (512 us) with a PWM value of -255..255, whose sign is the
    /// direction pin.
    void advanceTick(double pwm, bool bridgeEnabled);

    /// Holds the shaft where it is, however strong the motor, or releases it.
    void hold(bool held);

    /// Position of the shaft in counts since construction, unaffected by Reset Position or power.
    [[nodiscard]] double shaftCounts() const { return m_state.counts; }
    /// Shaft position in whole counts, rounded down.
    [[nodiscard]] std::int64_t shaft() const {
        const auto whole = static_cast<std::int64_t>(m_state.counts);
        return whole - (m_state.counts < static_cast<double>(whole) ? 1 : 0);
    }
    /// The index pulse of an encoder at this position: high for one count per turn.
    [[nodiscard]] bool index(std::int64_t encoder) const;
    [[nodiscard]] double currentAmperes() const { return m_state.amperes; }
    [[nodiscard]] double speedRadPerSecond() const { return m_state.radPerSecond; }
    /// Speed in counts per maximum-rate servo tick.
    [[nodiscard]] double speedCountsPerTick() const { return m_state.radPerSecond * m_countsPerRad * 512e-6; }
    /// The current sense voltage as read by the chip's converter; it has no sign.
    [[nodiscard]] std::uint8_t currentSense() const;
    /// True when the motor stands still without current, and only a drive or a changed parameter will move
    /// it.
    [[nodiscard]] bool atRest() const {
        return m_state.radPerSecond == 0.0 && m_state.amperes == 0.0 && m_elastic.stands() &&
               (m_held || std::abs(m_parameters.loadNm) <= m_parameters.coulombNm);
    }

private:
    struct State {
        double amperes = 0;
        double radPerSecond = 0;
        double counts = 0;
    };
    /// The next value of one state variable, as weights of the present state, the voltage and the torque.
    struct Row {
        double amperes = 0, radPerSecond = 0, volts = 0, torque = 0;
    };

    /// The second mass relative to the shaft.
    struct Elastic {
        double stiffness = 0;  ///< N·m/rad
        double damping = 0;    ///< N·m·s/rad
        double twist = 0;      ///< rad by which the shaft is ahead
        double radPerSecond = 0;
        [[nodiscard]] bool stands() const { return twist == 0.0 && radPerSecond == 0.0; }
    };

    /// Advances the twist by half a sub-step.
    void twist();
    void swing();
    void substepClosed(double volts);
    void substepOpen();
    void substepAtRest(double nextAmperes, double volts);
    [[nodiscard]] State solved(double volts, double torque) const;
    void reverse(double speedBefore, State& next) const;
    void keepWithinTravel();
    /// True when a hard stop takes up a torque of this sign.
    [[nodiscard]] bool isStopped(double torque) const;

    MotorParameters m_parameters;
    State m_state;
    Elastic m_elastic;
    double m_loadNm = 0;  ///< including the spring's torque
    bool m_held = false;
    Row m_amperes, m_speed, m_counts;  ///< with the terminals driven
    double m_stalledDecay = 0;         ///< current at standstill
    double m_stalledGain = 0;
    double m_coastDecay = 0;  ///< with the terminals open
    double m_coastGain = 0;
    double m_coastTravel = 0;
    double m_coastTravelGain = 0;
    double m_countsPerRad = 0;
    double m_voltsPerPwm = 0;
};

}  // namespace nmc::sim
