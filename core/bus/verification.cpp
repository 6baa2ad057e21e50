// SPDX-License-Identifier: MIT
#include "bus/verification.h"

#include <cstdlib>

#include "base/overloaded.h"
#include "bus/standstill.h"

namespace nmc::bus {

namespace {

/// A reset position differs from what was before by more, or it cannot be told.
constexpr std::int64_t kTellsApart = 10 * kStillCounts;

struct Verifier {
    const Belief& belief;
    const Verification& verification;

    Carried operator()(const StartMotion&) const {
        if (belief.mayMove())
            return Carried::Out;
        const bool moved = belief.position() && verification.position &&
                           !samePlace(*belief.position(), *verification.position);
        if (moved)
            return Carried::Out;
        // Not carried out, or a move of no length: the module's own word decides.
        return verification.end.result == ReplyResult::Refused ? Carried::NotOut : Carried::Unknown;
    }
    Carried operator()(const ResetPosition&) const {
        if (belief.mayMove() || !belief.position() || !verification.position)
            return Carried::Unknown;
        if (std::abs(std::int64_t{*verification.position}) < kTellsApart)
            return Carried::NotOut;  // close to 0 either way: once more does no harm
        if (samePlace(*belief.position(), 0))
            return Carried::Out;
        return samePlace(*belief.position(), *verification.position) ? Carried::NotOut : Carried::Unknown;
    }
    Carried operator()(const SaveAsHome&) const {
        if (!belief.home() || !belief.position())
            return Carried::Unknown;
        if (samePlace(*belief.home(), *belief.position()))
            return Carried::Out;
        return belief.mayMove() ? Carried::Unknown : Carried::NotOut;
    }
    Carried operator()(const servo::ClearStickyBits&) const {
        return belief.anySticky() ? Carried::NotOut : Carried::Out;
    }
    Carried operator()(
        const AnyOf<SetAddress, DefineStatus, ReadStatus, servo::LoadTrajectory, stepper::LoadTrajectory,
                    servo::SetGain, stepper::SetParameters, servo::StopMotor, stepper::StopMotor,
                    servo::IoControl, stepper::SetOutputs, servo::SetHoming, stepper::SetHoming, SetBaud, Nop,
                    HardReset> auto&) const {
        return Carried::Unknown;
    }
    Carried operator()(const servo::LaterCommand auto&) const { return Carried::Unknown; }
    Carried operator()(const io::OwnCommand auto&) const { return Carried::Unknown; }
};

struct CanLook {
    bool operator()(const StartMotion&) const { return true; }
    bool operator()(const ResetPosition&) const { return true; }
    bool operator()(const SaveAsHome&) const { return true; }
    bool operator()(const servo::ClearStickyBits&) const { return true; }
    bool operator()(const AnyOf<SetAddress, DefineStatus, ReadStatus, servo::LoadTrajectory,
                                stepper::LoadTrajectory, servo::SetGain, stepper::SetParameters,
                                servo::StopMotor, stepper::StopMotor, servo::IoControl, stepper::SetOutputs,
                                servo::SetHoming, stepper::SetHoming, SetBaud, Nop, HardReset> auto&) const {
        return false;
    }
    bool operator()(const servo::LaterCommand auto&) const { return false; }
    bool operator()(const io::OwnCommand auto&) const { return false; }
};

}  // namespace

bool canVerify(const ModuleCommand& command) {
    return std::visit([](const auto& chip) { return std::visit(CanLook{}, chip); }, command);
}

Carried verify(const Order& order, const Belief& belief, const Verification& verification) {
    return std::visit(
        [&](const auto& chip) {
            return std::visit(Verifier{belief, verification}, chip);
        },
        order.command);
}

}  // namespace nmc::bus
