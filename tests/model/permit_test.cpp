// SPDX-License-Identifier: GPL-3.0-or-later
// What the window offers against what the bus lets through: both follow the same commands and statuses.
#include <gtest/gtest.h>

#include "bus/gate.h"
#include "model/intent/directplan.h"
#include "servofixture.h"
#include "stepperfixture.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;

/// One module as the bus and as the window knows it, with a command or a status every 10 ms.
struct Known {
    explicit Known(ModuleIdentity identity) : belief({ModuleIndex(0), BusAddress(1), identity}) {
        module.info = belief.info();
    }

    void says(unsigned status, unsigned aux, std::int16_t velocity = 0, std::int32_t position = 0) {
        StatusReport report;
        report.items = StatusItems(StatusItems::All);
        report.status = static_cast<std::uint8_t>(status);
        report.aux = static_cast<std::uint8_t>(aux);
        report.position = position;
        report.velocity = velocity;
        report.timerCount = 60'000;
        time += 10ms;
        belief.onStatus(report, time);
        module.apply(bus::Sample{module.info.index, time, report});
    }
    void was(const ModuleCommand& command) {
        time += 10ms;
        belief.onSent(command, time);
        belief.onExecuted(command);
        module.apply(bus::CommandExecuted{module.info.index, time, command});
    }

    bus::Belief belief;
    ModuleState module;
    TimePoint time{};
};

[[nodiscard]] ModuleCommand servoCommand(ServoCommand command) {
    return command;
}

constexpr unsigned kOff = kMoveDone | kPosError | kPower;
constexpr unsigned kPathMode = 0x40;

[[nodiscard]] Known servoThatIsOff(std::uint8_t version = 4) {
    Known servo({ModuleType::Servo, version});
    servo.says(kOff, 0);
    servo::SetGain gains;
    gains.kp = 200;
    gains.ol = 255;
    servo.was(servoCommand(gains));
    servo.says(kOff, 0);
    return servo;
}

[[nodiscard]] Known servoThatHolds(std::uint8_t version = 4) {
    Known servo = servoThatIsOff(version);
    servo.was(servoCommand(stopWith(servo::StopManner::Abruptly)));
    servo.says(kMoveDone | kPower, kServoOn);
    servo.says(kMoveDone | kPower, kServoOn);
    return servo;
}

[[nodiscard]] Known servoThatRuns() {
    Known servo = servoThatHolds();
    servo.was(servoCommand(velocityMode(8 << 16, 1'311)));
    servo.says(kMoveDone | kPower, kServoOn, 8, 160);
    return servo;
}

[[nodiscard]] Known servoThatMoves() {
    Known servo = servoThatHolds();
    servo.was(servoCommand(trapezoid(20'000, 8 << 16, 1'311)));
    servo.was(servoCommand(StartMotion{}));
    servo.says(kPower, kServoOn, 8, 160);
    return servo;
}

[[nodiscard]] Known servoThatCoasts() {
    Known servo = servoThatRuns();
    servo.was(servoCommand(stopWith(servo::StopManner::MotorOff)));
    for (std::int32_t i = 1; i < 4; ++i)
        servo.says(kOff, 0, 8, 160 + 156 * i);
    return servo;
}

/// It has switched itself off, and turns on.
[[nodiscard]] Known servoThatTripped() {
    Known servo = servoThatRuns();
    for (std::int32_t i = 1; i < 4; ++i)
        servo.says(kOff, 0, 8, 160 + 156 * i);
    return servo;
}

[[nodiscard]] Known servoInPwmMode() {
    Known servo = servoThatIsOff();
    servo::LoadTrajectory load;
    load.servo = false;
    load.pwm = std::uint8_t{100};
    load.startNow = true;
    servo.was(servoCommand(load));
    servo.says(kOff, 0, 8, 160);
    return servo;
}

[[nodiscard]] Known servoOnAPath() {
    Known servo = servoThatHolds(kPathVersion);
    servo.was(servoCommand(servo::AddPathPoints{}));
    servo.says(kMoveDone | kPower, kServoOn | kPathMode, 1, 20);
    return servo;
}

[[nodiscard]] Known stepperThatHolds() {
    Known stepper({ModuleType::Stepper, 1});
    stepper.says(kStepPower, 0);
    stepper.was(StepperCommand(Stepper::parameters()));
    stepper.was(StepperCommand(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly}));
    stepper.says(kStepOn, 0);
    return stepper;
}

[[nodiscard]] stepper::LoadTrajectory stepperRun(bool reverse = false) {
    stepper::LoadTrajectory load;
    load.speed = std::uint8_t{40};
    load.accelerationTime = std::uint8_t{4};
    load.reverse = reverse;
    load.startNow = true;
    return load;
}

[[nodiscard]] Known stepperThatRuns() {
    Known stepper = stepperThatHolds();
    stepper.was(StepperCommand(stepperRun()));
    stepper.says(kStepOn | kMoving | kVelocityMode | kAtSpeed, 0, 0, 50);
    return stepper;
}

/// Commands of a PIC-SERVO, those that depend on its state in every variant that matters.
[[nodiscard]] std::vector<ModuleCommand> servoCommands() {
    using enum servo::StopManner;
    servo::LoadTrajectory load = trapezoid(500, 8 << 16, 1'311);
    servo::LoadTrajectory pwm;
    pwm.servo = false;
    pwm.pwm = std::uint8_t{10};
    std::vector<ModuleCommand> all;
    for (const bool now : {false, true})
        for (servo::LoadTrajectory each : {load, velocityMode(8 << 16, 1'311), pwm}) {
            each.startNow = now;
            all.push_back(servoCommand(each));
        }
    for (const servo::StopManner manner : {AmplifierOnly, MotorOff, Abruptly, Smoothly, Here})
        all.push_back(servoCommand(stopWith(manner)));
    const auto add = [&](const auto&... commands) { (all.push_back(servoCommand(commands)), ...); };
    add(StartMotion{}, ResetPosition{}, SaveAsHome{}, Nop{}, ReadStatus{}, DefineStatus{}, servo::SetGain{},
        servo::IoControl{}, servo::SetHoming{}, servo::ClearStickyBits{}, servo::ResetRelativeToHome{},
        servo::SetPosition{}, servo::ScIoControl{}, servo::AddPathPoints{}, servo::HardReset{}, SetAddress{},
        SetBaud{}, HardReset{});
    return all;
}

/// Every load, whether Table 4 of DS-S has it or not, and the other commands of a PIC-STEP.
[[nodiscard]] std::vector<ModuleCommand> stepperCommands() {
    std::vector<ModuleCommand> all;
    for (unsigned bits = 0; bits < 32; ++bits) {
        stepper::LoadTrajectory load = stepperRun((bits & 16U) != 0);
        if ((bits & 1U) != 0)
            load.position = Counts(500);
        if ((bits & 2U) != 0)
            load.timer = stepper::TimerCount{60'000, 40};
        if ((bits & 4U) != 0)
            load.speed = load.accelerationTime = std::nullopt;
        load.startNow = (bits & 8U) != 0;
        all.emplace_back(StepperCommand(load));
    }
    stepper::SetParameters other = Stepper::parameters();
    other.minimumProfileSpeed = 9;
    const auto add = [&](const auto&... commands) { (all.push_back(StepperCommand(commands)), ...); };
    add(StartMotion{}, ResetPosition{}, SaveAsHome{}, Nop{}, ReadStatus{}, DefineStatus{},
        Stepper::parameters(), other, stepper::SetOutputs{}, stepper::SetHoming{}, SetAddress{}, SetBaud{},
        HardReset{}, stepper::StopMotor{true, stepper::StopManner::Smoothly});
    return all;
}

struct Situation {
    const char* name;
    Known (*known)();
    std::vector<ModuleCommand> (*commands)();
};

class WindowAndGate : public testing::TestWithParam<Situation> {};

/// A request that the bus would refuse has a control that is disabled, with a reason.
TEST_P(WindowAndGate, NothingIsOfferedThatTheBusRefuses) {
    using enum bus::Permission;
    const Known now = GetParam().known();
    unsigned offered = 0;
    for (const ModuleCommand& command : GetParam().commands()) {
        if (whyNotDirect(command, now.module))
            continue;
        ++offered;
        const bus::Permission permission = permit(now.belief, command);
        EXPECT_TRUE(permission == Allowed || permission == NeedsStatus)
            << toHex(ByteBuffer<1>{payloadOf(command).commandByte()}) << ' '
            << toHex(payloadOf(command).data);
    }
    EXPECT_GT(offered, 4U);
}
INSTANTIATE_TEST_SUITE_P(
    Of, WindowAndGate,
    testing::Values(Situation{"AServoThatIsOff", [] { return servoThatIsOff(); }, servoCommands},
                    Situation{"AServoThatHolds", [] { return servoThatHolds(); }, servoCommands},
                    Situation{"AnScThatIsOff", [] { return servoThatIsOff(kScVersion); }, servoCommands},
                    Situation{"AServoThatRuns", servoThatRuns, servoCommands},
                    Situation{"AServoThatMoves", servoThatMoves, servoCommands},
                    Situation{"AServoThatCoasts", servoThatCoasts, servoCommands},
                    Situation{"AServoThatTripped", servoThatTripped, servoCommands},
                    Situation{"AServoInPwmMode", servoInPwmMode, servoCommands},
                    Situation{"AServoOnAPath", servoOnAPath, servoCommands},
                    Situation{"AStepperThatHolds", stepperThatHolds, stepperCommands},
                    Situation{"AStepperThatRuns", stepperThatRuns, stepperCommands}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace nmc
