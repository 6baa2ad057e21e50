// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "model/response/responserecord.h"
#include "model/tuning/loopmodel.h"
#include "model/tuning/motormodel.h"
#include "sim/encoder.h"
#include "sim/motorplant.h"
#include "sim/pid.h"
#include "sim/random.h"

/// The simulator's motor behind the simulator's control filter, polled as by the bus at 115 200 Bd.
namespace nmc::testing_support {

/// The constants that follow from the motor's physics: K = V / 255 / k in counts, tau = J R / k^2, c = M R /
/// k in PWM counts (viscous friction is left out: it is below a permille here). A second mass is part of J,
/// because below its resonance it swings along; the amplifier's deadband D adds to c, and each PWM count
/// above it is worth more.
[[nodiscard]] inline MotorConstants physics(const sim::MotorParameters& p) {
    const double voltsPerPwm = p.supplyVolts / (255 - p.amplifierDeadbandPwm);
    const double pwmPerNm = p.resistanceOhm / p.motorConstant / voltsPerPwm;
    return {voltsPerPwm / p.motorConstant * p.countsPerTurn / (2 * std::numbers::pi),
            (p.inertiaKgM2 + p.elasticInertiaKgM2) * p.resistanceOhm / (p.motorConstant * p.motorConstant),
            p.coulombNm * pwmPerNm,
            -p.loadNm * pwmPerNm,
            p.inductanceHenry / p.resistanceOhm,
            1.0 * p.amplifierDeadbandPwm,
            1.0 * static_cast<double>(p.playCounts)};
}

/// The model of a motor that is known without a doubt.
[[nodiscard]] inline MotorModel exactly(const MotorConstants& motor) {
    MotorModel model;
    model.gain.value = motor.gain;
    model.timeConstant.value = motor.timeConstant;
    model.friction.value = motor.friction;
    model.load.value = motor.load;
    model.delay.value = motor.delay;
    model.deadband.value = motor.deadband;
    model.play.value = motor.play;
    model.noise = motor.noise;
    return model;
}

class TunedServo {
public:
    TunedServo(const sim::MotorParameters& motor, const servo::SetGain& gains, std::uint64_t seed)
        : m_plant(motor), m_random(seed), m_noise(seed + 1), m_backlash(motor.playCounts) {
        setGains(gains);
    }

    void setGains(const servo::SetGain& g) {
        m_set = g;
        m_gains = {g.kp, g.kd, g.ki, g.il, g.ol, g.cl, g.el, g.sr, g.db.value_or(0)};
        m_untilServo = 1;
    }
    void setPower(bool on) { m_power = on; }
    /// Counts by which the motor turns before the encoder does.
    void setBacklash(std::int64_t counts) { m_backlash = counts; }
    void reverseEncoder() { m_encoder.setReversed(true); }
    [[nodiscard]] std::int32_t position() const { return m_encoder.position(); }
    [[nodiscard]] std::int32_t command() const { return m_command; }
    [[nodiscard]] const sim::MotorPlant& plant() const { return m_plant; }

    void wait(double seconds) {
        for (double t = 0; t < seconds; t += kTick)
            tick();
    }

    /// Performs a step of the command and returns its record. Polls come every 1.5 ms, out of step with the
    /// ticks: each is latched at the tick after it, which makes its time uncertain by half a tick, and by
    /// another 0.1 ms.
    [[nodiscard]] ResponseRecord step(std::int32_t counts, double record) {
        constexpr double kPoll = 1.5e-3;
        ResponseRecord run;
        run.bandPercent = kFirstBand;
        run.taken = {{}, m_command, m_command + counts, record, ResponseMethod::Profile, m_set};
        std::vector<ResponsePoint> polled;
        const double told = 0.02 + m_random.unit() * kTick;
        double poll = m_random.unit() * kPoll;
        const auto ticks = static_cast<int>((told + record) / kTick) + 1;
        bool commanded = false;
        for (int i = 1; i <= ticks; ++i) {
            const double now = i * kTick;
            tick();
            for (; poll <= now; poll += kPoll)
                polled.push_back({poll + kTick / 2 + jitter(), static_cast<double>(m_encoder.position())});
            if (!commanded && told <= now) {
                commanded = true;
                m_command += counts;
            }
        }
        const double at = told + kTick / 2 + jitter();
        for (const ResponsePoint& point : polled)
            if (point.seconds - at <= record)
                run.points.push_back({point.seconds - at, point.position});
        judge(run, kFirstBand);
        return run;
    }

    /// Performs a step and returns its true course from the first tick that sees it: at each tick, the
    /// position of the shaft on which the encoder sits.
    [[nodiscard]] ResponseRecord trueStep(std::int32_t counts, double record) {
        ResponseRecord run;
        run.taken = {{}, m_command, m_command + counts, record, ResponseMethod::Profile, m_set};
        m_command += counts;
        for (double t = 0; t <= record; t += kTick) {
            tick();
            run.points.push_back({t, static_cast<double>(m_driven)});
        }
        judge(run, kFirstBand);
        return run;
    }

private:
    static constexpr double kTick = 512e-6;

    [[nodiscard]] double jitter() { return (m_random.unit() * 2 - 1) * 1e-4; }

    void tick() {
        m_plant.advanceTick(m_pwm, m_power);
        m_driven = std::clamp(m_driven, m_plant.shaft() - m_backlash, m_plant.shaft());
        const double noise = m_plant.parameters().encoderNoiseCounts;
        m_encoder.read(m_driven + (noise > 0 ? std::llround(noise * m_noise.normal()) : 0));
        if (--m_untilServo > 0)
            return;
        m_untilServo = m_gains.sr;
        const std::int64_t output = m_filter.output(m_gains, m_command - m_encoder.position());
        auto magnitude = static_cast<int>(std::min<std::int64_t>(std::abs(output) / 256, m_gains.ol));
        if (magnitude > 0)
            magnitude = std::min(magnitude + m_gains.db, 255);
        m_pwm = output < 0 ? -magnitude : magnitude;
    }

    sim::MotorPlant m_plant;
    sim::Encoder m_encoder;
    sim::PidFilter m_filter;
    sim::Gains m_gains;
    servo::SetGain m_set;
    sim::Random m_random;
    sim::Random m_noise;
    std::int64_t m_backlash;
    std::int64_t m_driven = 0;  ///< in counts: the shaft on which the encoder sits
    std::int32_t m_command = 0;
    int m_pwm = 0;
    int m_untilServo = 1;
    bool m_power = true;
};

}  // namespace nmc::testing_support
