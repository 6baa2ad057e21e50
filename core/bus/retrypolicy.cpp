// SPDX-License-Identifier: MIT
#include "bus/retrypolicy.h"

#include "base/overloaded.h"

namespace nmc::bus {

namespace {

constexpr RetryRule kGiveUp{};
constexpr RetryRule kOnce{AfterSilence::GiveUp, 0, 1};
constexpr RetryRule kRepeat{AfterSilence::Repeat, 2};

struct Rule {
    /// Questions, and settings that are the same however often they are made.
    RetryRule operator()(
        const AnyOf<Nop, ReadStatus, DefineStatus, servo::SetGain, servo::IoControl, servo::ScIoControl,
                    stepper::SetParameters, stepper::SetOutputs, io::SetDirection, io::SetOutput, io::SetPwm,
                    io::SetSynchOutput> auto&) const {
        return kRepeat;
    }
    /// One that does not start can be sent again: nothing moves yet.
    RetryRule operator()(const AnyOf<servo::LoadTrajectory, stepper::LoadTrajectory> auto& load) const {
        return load.startNow ? kGiveUp : kRepeat;
    }
    RetryRule operator()(const AnyOf<servo::StopMotor, stepper::StopMotor> auto&) const {
        return {AfterSilence::RepeatAtOnce, 4, 10};
    }
    /// A look at the module decides, see verification.h.
    RetryRule operator()(const AnyOf<StartMotion, ResetPosition, servo::ResetRelativeToHome,
                                     servo::SetPosition, SaveAsHome, servo::ClearStickyBits> auto&) const {
        return kGiveUp;
    }
    /// The first one may have been carried out: home found, the counter set to 0, outputs set or inputs
    /// latched. A second one would undo that, or do it at another moment.
    RetryRule operator()(const AnyOf<servo::SetHoming, stepper::SetHoming, io::SetTimerMode, io::SynchOutput,
                                     io::SynchInput> auto&) const {
        return kGiveUp;
    }
    /// Discovery asks at the new address first.
    RetryRule operator()(const SetAddress&) const { return kGiveUp; }
    /// Set Baud has no reply by design, and is never an exchange.
    RetryRule operator()(const SetBaud&) const { return kGiveUp; }
    RetryRule operator()(const AnyOf<HardReset, servo::HardReset, servo::AddPathPoints> auto&) const {
        return kOnce;
    }
};

struct Starts {
    bool operator()(const StartMotion&) const { return true; }
    bool operator()(const AnyOf<servo::LoadTrajectory, stepper::LoadTrajectory> auto& load) const {
        return load.startNow;
    }
    bool operator()(const servo::StopMotor& stop) const {
        return stop.manner == servo::StopManner::Here;  // which may be another place
    }
    bool operator()(const servo::AddPathPoints& add) const { return add.startsPath(); }
    bool operator()(const AnyOf<ResetPosition, SetAddress, DefineStatus, ReadStatus, servo::SetGain,
                                servo::IoControl, servo::ScIoControl, servo::SetHoming, SetBaud,
                                servo::ClearStickyBits, SaveAsHome, Nop, HardReset, servo::HardReset,
                                servo::ResetRelativeToHome, servo::SetPosition, stepper::SetParameters,
                                stepper::StopMotor, stepper::SetOutputs, stepper::SetHoming> auto&) const {
        return false;
    }
    bool operator()(const io::OwnCommand auto&) const { return false; }
};

}  // namespace

RetryRule retryRule(const ModuleCommand& command) {
    return std::visit([](const auto& chip) { return std::visit(Rule{}, chip); }, command);
}

bool mayStartMotion(const ModuleCommand& command) {
    return std::visit([](const auto& chip) { return std::visit(Starts{}, chip); }, command);
}

}  // namespace nmc::bus
