// SPDX-License-Identifier: MIT
#include "model/intent/directplan.h"

#include "base/overloaded.h"
#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"
#include "protocol/takes.h"

namespace nmc {

namespace {

using Reason = std::optional<Refusal>;

struct WhyNot {
    const ModuleState& module;

    // ---- PIC-SERVO ----

    Reason operator()(const servo::LoadTrajectory& load) const {
        if (!load.startNow)
            return whyInaccessible(IntentKind::Load, module);
        if (!load.servo)
            return whyNot(IntentKind::DrivePwm, module);
        if (load.profile == servo::ProfileMode::Trapezoidal)
            return Refusal::StartApart;
        if (!load.velocity && !module.velocity)
            return Refusal::NoVelocity;  // it would run at whatever another host has loaded
        const auto acceleration = load.acceleration ? load.acceleration : module.acceleration;
        return acceleration && acceleration->value() != 0 ? whyNot(IntentKind::Run, module)
                                                          : Reason(Refusal::NoAcceleration);
    }
    Reason operator()(const servo::StopMotor& stop) const {
        switch (stop.manner) {
            case servo::StopManner::AmplifierOnly:
                return whyNot(IntentKind::SetAmplifier, module);
            case servo::StopManner::MotorOff:
                return whyNot(IntentKind::MotorOff, module);
            case servo::StopManner::Smoothly:
                if (!module.canDecelerate())
                    return Refusal::NoAcceleration;
                break;
            case servo::StopManner::Abruptly:
                break;
            case servo::StopManner::Here:
                return whyNot(IntentKind::StopHere, module);
        }
        // A stop switches on a servo that is off (DS-V 5.2).
        return whyNot(module.servoOn() ? IntentKind::StopMotion : IntentKind::Enable, module);
    }
    Reason operator()(const servo::SetGain&) const { return whyNot(IntentKind::ApplyGains, module); }
    Reason operator()(const servo::IoControl&) const { return whyNot(IntentKind::ControlIo, module); }
    Reason operator()(const AnyOf<servo::ResetRelativeToHome, servo::SetPosition> auto&) const {
        return whyNot(IntentKind::ResetPosition, module);
    }
    Reason operator()(const servo::ScIoControl&) const { return whyNot(IntentKind::ControlSc, module); }
    Reason operator()(const servo::ClearStickyBits&) const {
        return whyNot(IntentKind::ClearStickyBits, module);
    }

    // ---- PIC-STEP ----

    Reason operator()(const stepper::LoadTrajectory& load) const {
        if (!inTable4(load))
            return Refusal::VersionLacksIt;
        if (load.startNow && load.position)
            return Refusal::StartApart;
        return load.startNow ? whyNotStarted(load, module) : whyNot(IntentKind::Load, module);
    }
    Reason operator()(const stepper::StopMotor& stop) const {
        const bool enables = stop.amplifierEnable && !module.stepper.amplifierOn();
        return whyNot(enables ? IntentKind::Enable : IntentKind::StopMotion, module);
    }
    Reason operator()(const stepper::SetParameters& parameters) const {
        return whyNotSet(parameters, module);
    }
    Reason operator()(const stepper::SetOutputs&) const { return whyNot(IntentKind::SetOutputs, module); }

    // ---- PIC-I/O ----

    Reason operator()(const AnyOf<io::SetOutput, io::SetPwm, io::SynchOutput> auto&) const {
        return whyNot(IntentKind::SetOutputs, module);
    }
    Reason operator()(
        const AnyOf<io::SetDirection, io::SetSynchOutput, io::SetTimerMode, io::SynchInput> auto&) const {
        return whyNot(IntentKind::ControlIo, module);
    }

    // ---- several chips ----

    Reason operator()(const AnyOf<servo::SetHoming, stepper::SetHoming> auto&) const {
        return whyInaccessible(IntentKind::Home, module);
    }
    Reason operator()(const StartMotion&) const { return whyNot(IntentKind::StartLoaded, module); }
    Reason operator()(const ResetPosition&) const { return whyNot(IntentKind::ResetPosition, module); }
    Reason operator()(const SaveAsHome&) const { return whyNot(IntentKind::SaveAsHome, module); }
    Reason operator()(const AnyOf<DefineStatus, ReadStatus, Nop> auto&) const {
        return whyInaccessible(IntentKind::StopMotion, module);
    }
    /// Addresses, rates, resets and paths belong to the bus, and cannot be sent as single commands.
    Reason operator()(
        const AnyOf<SetAddress, SetBaud, HardReset, servo::AddPathPoints, servo::HardReset> auto&) const {
        return Refusal::VersionLacksIt;
    }
};

}  // namespace

std::optional<Refusal> whyNotDirect(const ModuleCommand& command, const ModuleState& module) {
    if (module.isKnown()) {
        if (std::holds_alternative<StepperCommand>(command) && !module.isStepper())
            return Refusal::NotAStepper;
        if (std::holds_alternative<IoCommand>(command) && !module.isIo())
            return Refusal::NotAnIoModule;
        if (std::holds_alternative<ServoCommand>(command) && !module.isServo())
            return Refusal::NotAServo;
    }
    if (!std::visit([&](const auto& own) { return takes(module.info.identity, own); }, command))
        return Refusal::VersionLacksIt;
    if (const auto refusal = visitCommand(WhyNot{module}, command))
        return refusal;
    const auto problem = travelProblem(intent::Direct{command}, module);
    return problem ? std::optional(problem->refusal) : std::nullopt;
}

}  // namespace nmc
