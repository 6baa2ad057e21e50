// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "protocol/commandcode.h"
#include "protocol/frame.h"

namespace nmc::bus {

/// What to do when nobody answered: the command may or may not have been carried out (link.md 2.3).
enum class AfterSilence : std::uint8_t {
    GiveUp,        ///< never blindly repeated: it could move twice, or carry out again what has been undone
    Repeat,        ///< after a resync; carrying it out twice changes nothing
    RepeatAtOnce,  ///< a stop: only nulls before it
};

struct RetryRule {
    AfterSilence afterSilence = AfterSilence::GiveUp;
    std::uint8_t silentRepeats = 0;
    std::uint8_t refusedAttempts = 3;  ///< in total, when the module says that it refused
    bool operator==(const RetryRule&) const = default;
};

/// The table of link.md 2.3. A Load Trajectory that does not start can be sent again: nothing moves yet.
[[nodiscard]] constexpr RetryRule retryRule(CommandCode code, bool startsMotion) {
    switch (code) {
        case CommandCode::Nop:
        case CommandCode::ReadStatus:
        case CommandCode::DefineStatus:
        case CommandCode::SetGain:    // the identical set
        case CommandCode::IoControl:  // PIC-STEP: Set Outputs
            return {AfterSilence::Repeat, 2};
        case CommandCode::LoadTrajectory:
            return startsMotion ? RetryRule{} : RetryRule{AfterSilence::Repeat, 2};
        case CommandCode::StopMotor:
            return {AfterSilence::RepeatAtOnce, 4, 10};
        case CommandCode::StartMotion:      // a look at the module decides, see verification.h
        case CommandCode::ResetPosition:    // the same
        case CommandCode::SaveAsHome:       // the same
        case CommandCode::ClearStickyBits:  // the same
        case CommandCode::SetHoming:        // home may have been found meanwhile
        case CommandCode::SetAddress:       // Discovery asks at the new address first
            return {};
        case CommandCode::SetBaud:  // no reply by design; never an exchange
        case CommandCode::HardReset:
        case CommandCode::AddPathPoints:
            return {AfterSilence::GiveUp, 0, 1};
    }
    return {};
}

/// Once it is carried out, "stands still" has to be shown anew.
[[nodiscard]] constexpr bool mayStartMotion(const Payload& payload) {
    const bool data = !payload.data.empty();
    switch (payload.code) {
        case CommandCode::StartMotion:
            return true;
        case CommandCode::LoadTrajectory:
            return data && (payload.data[0] & 0x80U) != 0;
        case CommandCode::StopMotor:
            return data && (payload.data[0] & 0x10U) != 0;  // PIC-SERVO: stop here, at a position
        case CommandCode::AddPathPoints:
            return !data;  // starts the path
        case CommandCode::ResetPosition:
        case CommandCode::SetAddress:
        case CommandCode::DefineStatus:
        case CommandCode::ReadStatus:
        case CommandCode::SetGain:
        case CommandCode::IoControl:
        case CommandCode::SetHoming:
        case CommandCode::SetBaud:
        case CommandCode::ClearStickyBits:
        case CommandCode::SaveAsHome:
        case CommandCode::Nop:
        case CommandCode::HardReset:
            return false;
    }
    return false;
}

/// The rule for a payload as it goes out; "start now" is bit 7 of a Load Trajectory on both chips.
[[nodiscard]] constexpr RetryRule retryRule(const Payload& payload) {
    const bool starts = payload.code == CommandCode::LoadTrajectory && !payload.data.empty() &&
                        (payload.data[0] & 0x80U) != 0;
    return retryRule(payload.code, starts);
}

}  // namespace nmc::bus
