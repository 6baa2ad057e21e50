// SPDX-License-Identifier: MIT
#include "module/commandfacts.h"

namespace nmc {

namespace {

constexpr RetryRule kGiveUp{};
constexpr RetryRule kOnce{0, 1};
constexpr RetryRule kRepeat{2};
constexpr RetryRule kRepeatAtOnce{4, 10, true};

using enum Evidence;
using enum When;

constexpr CommandFacts kQuestion{kRepeat, None, Always, Effect::None};
/// Setting the same value again changes nothing.
constexpr CommandFacts kSetting{kRepeat, None, Always, Effect::Setting};
/// Carrying it out again would undo the outcome of the first time: home found, the counter set to 0, outputs
/// set or inputs latched.
constexpr CommandFacts kOnceOnly{kGiveUp, None, Always, Effect::Setting};

/// Omitting a command's row is a compile error.
struct Row {
    CommandFacts operator()(const AnyOf<Nop, ReadStatus, DefineStatus> auto&) const { return kQuestion; }
    /// Discovery queries the new address before it sends this command again.
    CommandFacts operator()(const SetAddress&) const { return {kGiveUp, None, Never, Effect::Setting}; }
    /// Has no reply by design, and is never an exchange.
    CommandFacts operator()(const SetBaud&) const { return {kGiveUp, None, Never, Effect::Setting}; }
    CommandFacts operator()(const AnyOf<HardReset, servo::HardReset> auto&) const {
        return {kOnce, None, Never, Effect::Setting};
    }
    CommandFacts operator()(const ResetPosition&) const {
        return {kGiveUp, Position, Standstill, Effect::Counter};
    }
    CommandFacts operator()(const SaveAsHome&) const { return {kGiveUp, Home, Always, Effect::Setting}; }
    CommandFacts operator()(const StartMotion&) const { return {kGiveUp, Motion, AsLoaded, Effect::Start}; }

    // ---- PIC-SERVO ----

    /// Nothing moves before the start, so a load alone can be sent again, and at any time (DS-V 5.1, note 1).
    /// A trapezoidal move is never started by the command that loads it, so that a garbled load moves
    /// nothing.
    CommandFacts operator()(const servo::LoadTrajectory& load) const {
        if (!load.startNow)
            return kSetting;
        const When when = load.isTrapezoidal() ? Never : load.servo ? OffThePath : AsLoaded;
        return {kGiveUp, None, when, Effect::Start};
    }
    CommandFacts operator()(const servo::SetGain&) const { return kSetting; }
    /// The position of Stop Here may differ from the present one, so it can start a motion.
    CommandFacts operator()(const servo::StopMotor& stop) const {
        const Effect effect = stop.manner == servo::StopManner::Here            ? Effect::Start
                              : stop.manner == servo::StopManner::AmplifierOnly ? Effect::Setting
                                                                                : Effect::Stop;
        return {kRepeatAtOnce, None, Always, effect};
    }
    /// Fast path would change the rate of the points that are already in the buffer.
    CommandFacts operator()(const servo::IoControl&) const {
        return {kRepeat, None, OffThePath, Effect::Setting};
    }
    CommandFacts operator()(const servo::SetHoming&) const { return kOnceOnly; }
    CommandFacts operator()(const servo::ClearStickyBits&) const {
        return {kGiveUp, StickyBits, Always, Effect::Setting};
    }
    CommandFacts operator()(const AnyOf<servo::ResetRelativeToHome, servo::SetPosition> auto&) const {
        return {kGiveUp, None, Standstill, Effect::Counter};
    }
    /// Each bit takes effect at once, and some of them can destroy an amplifier that is on.
    CommandFacts operator()(const servo::ScIoControl&) const {
        return {kRepeat, None, MotorOff, Effect::Setting};
    }
    /// Path points are sent by PathTask, which checks mayFollowPath().
    CommandFacts operator()(const servo::AddPathPoints& add) const {
        return {kOnce, None, Never, add.startsPath() ? Effect::Start : Effect::Setting};
    }

    // ---- PIC-STEP ----

    CommandFacts operator()(const stepper::LoadTrajectory& load) const {
        if (!load.startNow)
            return {kRepeat, None, AsLoaded, Effect::Setting};
        // As for a PIC-SERVO, a garbled goal must not move anything.
        return {kGiveUp, None, load.position ? Never : AsLoaded, Effect::Start};
    }
    CommandFacts operator()(const stepper::SetParameters&) const {
        return {kRepeat, None, AsLoaded, Effect::Setting};
    }
    CommandFacts operator()(const stepper::StopMotor&) const {
        return {kRepeatAtOnce, None, Always, Effect::Stop};
    }
    CommandFacts operator()(const stepper::SetOutputs&) const { return kSetting; }
    CommandFacts operator()(const stepper::SetHoming&) const { return kOnceOnly; }

    // ---- PIC-I/O ----

    CommandFacts operator()(
        const AnyOf<io::SetDirection, io::SetOutput, io::SetPwm, io::SetSynchOutput> auto&) const {
        return kSetting;
    }
    CommandFacts operator()(const AnyOf<io::SetTimerMode, io::SynchOutput, io::SynchInput> auto&) const {
        return kOnceOnly;
    }
};

}  // namespace

CommandFacts factsOf(const ModuleCommand& command) {
    return visitCommand(Row{}, command);
}

}  // namespace nmc
