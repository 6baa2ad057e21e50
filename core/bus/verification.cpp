// SPDX-License-Identifier: MIT
#include "bus/verification.h"

#include <cstdlib>

#include "bus/standstill.h"
#include "module/commandfacts.h"

namespace nmc::bus {

namespace {

/// A reset can be verified only if the previous position differs from 0 by at least this much.
constexpr std::int64_t kDistinguishable = 10 * kStillCounts;

[[nodiscard]] Carried verifyMotion(const Belief& belief, const Verification& verification) {
    const bool moved =
        belief.position() && verification.position && !samePlace(*belief.position(), *verification.position);
    // Not mayMove(): a run counts as running from the moment its start was sent.
    if (verification.stood && (belief.showsMotion() || moved))
        return Carried::Out;
    // It was not carried out, was a move of no length, or does not show in a motion from before: the module's
    // reply decides.
    return verification.end.result == ReplyResult::Refused ? Carried::NotOut : Carried::Unknown;
}

[[nodiscard]] Carried verifyPosition(const Belief& belief, const Verification& verification) {
    if (belief.mayMove() || !belief.position() || !verification.position)
        return Carried::Unknown;
    if (std::abs(std::int64_t{*verification.position}) < kDistinguishable)
        return Carried::NotOut;  // close to 0 either way: repeating it is harmless
    if (samePlace(*belief.position(), 0))
        return Carried::Out;
    return samePlace(*belief.position(), *verification.position) ? Carried::NotOut : Carried::Unknown;
}

[[nodiscard]] Carried verifyHome(const Belief& belief) {
    if (!belief.home() || !belief.position())
        return Carried::Unknown;
    if (samePlace(*belief.home(), *belief.position()))
        return Carried::Out;
    return belief.mayMove() ? Carried::Unknown : Carried::NotOut;
}

}  // namespace

Carried verify(const Order& order, const Belief& belief, const Verification& verification) {
    switch (factsOf(order.command).evidence) {
        case Evidence::None:
            break;
        case Evidence::Motion:
            return verifyMotion(belief, verification);
        case Evidence::Position:
            return verifyPosition(belief, verification);
        case Evidence::Home:
            return verifyHome(belief);
        case Evidence::StickyBits:
            return belief.anySticky() ? Carried::NotOut : Carried::Out;
    }
    return Carried::Unknown;
}

}  // namespace nmc::bus
