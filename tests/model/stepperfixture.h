// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/modulestate.h"

namespace nmc::testing_support {

// Status and inputs of a PIC-STEP (DS-S 5.2).
inline constexpr std::uint8_t kMoving = 0x01;
inline constexpr std::uint8_t kAmplifier = 0x04;
inline constexpr std::uint8_t kStepPower = 0x08;
inline constexpr std::uint8_t kAtSpeed = 0x10;
inline constexpr std::uint8_t kVelocityMode = 0x20;
inline constexpr std::uint8_t kTrapezoidalMode = 0x40;
inline constexpr std::uint8_t kStepHoming = 0x80;
inline constexpr unsigned kStepOn = kStepPower | kAmplifier;
inline constexpr std::uint8_t kEstopIn = 0x01;
inline constexpr std::uint8_t kLimit1In = 0x08;
inline constexpr std::uint8_t kLimit2In = 0x10;

/// A PIC-STEP with a status or a command every 10 ms.
struct Stepper {
    ModuleState module;
    TimePoint time{};
    std::int32_t position = 0;
    std::uint8_t inputs = 0;
    std::uint8_t analog = 200;
    std::uint16_t timer = 60'000;

    Stepper() { module.info = {ModuleIndex(0), BusAddress(1), {ModuleType::Stepper, 1}}; }

    void says(unsigned status) {
        time += std::chrono::milliseconds(10);
        StatusReport report;
        report.items = StatusItems(StatusItems::All);
        report.status = static_cast<std::uint8_t>(status);
        report.position = position;
        report.analog = analog;
        report.timerCount = timer;
        report.aux = inputs;
        report.home = 0;
        module.apply(bus::Sample{module.info.index, time, report});
    }
    void was(StepperCommand command) {
        time += std::chrono::milliseconds(10);
        module.apply(bus::CommandExecuted{module.info.index, time, std::move(command)});
    }
    void wasStopped(stepper::StopManner manner, bool amplifier = true) {
        was(stepper::StopMotor{amplifier, manner});
    }

    [[nodiscard]] static stepper::SetParameters parameters() {
        stepper::SetParameters p;
        p.speedMode = stepper::SpeedMode::X1;
        p.minimumProfileSpeed = 4;
        p.runCurrent = 100;
        p.holdCurrent = 50;
        return p;
    }
    /// A stepper that has parameters, is on, and rests at 0.
    [[nodiscard]] static Stepper holding() {
        Stepper stepper;
        stepper.says(kStepPower);
        stepper.was(parameters());
        stepper.wasStopped(stepper::StopManner::AmplifierOnly);
        stepper.says(kStepPower | kAmplifier);
        return stepper;
    }
    /// A stepper that runs in velocity profile mode.
    [[nodiscard]] static Stepper running(bool reverse = false) {
        Stepper stepper = holding();
        stepper::LoadTrajectory load;
        load.speed = std::uint8_t{40};
        load.accelerationTime = std::uint8_t{4};
        load.reverse = reverse;
        load.startNow = true;
        stepper.was(load);
        stepper.says(kStepPower | kAmplifier | kMoving | kVelocityMode | kAtSpeed);
        return stepper;
    }
    [[nodiscard]] static stepper::LoadTrajectory trapezoid(std::int32_t goal) {
        stepper::LoadTrajectory load;
        load.position = Counts(goal);
        load.speed = std::uint8_t{40};
        load.accelerationTime = std::uint8_t{4};
        return load;
    }
};

}  // namespace nmc::testing_support
