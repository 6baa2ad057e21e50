// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/travelwords.h"

#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

QString travelProblem(const TravelProblem& problem, const Zero& zero, const AxisScale& scale) {
    if (problem.refusal == Refusal::TooFast)
        return (problem.ofChip
                    ? Texts::tr("That is %1; this module can be given at most %2.")
                    : Texts::tr("That is %1; the highest velocity of this axis is %2 (Axis page)."))
            .arg(velocity(scale, problem.velocity, 6), velocity(scale, problem.fastest, 6));
    const QString limit = place(zero, scale, problem.limit);
    const bool lowest = problem.lowest != scale.reversed();
    if (problem.turn) {
        const QString turn = place(zero, scale, *problem.turn);
        return lowest
                   ? Texts::tr(
                         "To take up the backlash, the move would reverse at %1, below the lowest position %2. Lower that position, or change the backlash or its direction (Axis page).")
                         .arg(turn, limit)
                   : Texts::tr(
                         "To take up the backlash, the move would reverse at %1, above the highest position %2. Raise that position, or change the backlash or its direction (Axis page).")
                         .arg(turn, limit);
    }
    if (problem.refusal == Refusal::AtTravelEnd)
        return lowest ? Texts::tr("Lowest position reached: %1. Move forward.").arg(limit)
                      : Texts::tr("Highest position reached: %1. Move in reverse.").arg(limit);
    return lowest ? Texts::tr("That is beyond the travel limits: the lowest position is %1 (Axis page).")
                        .arg(limit)
                  : Texts::tr("That is beyond the travel limits: the highest position is %1 (Axis page).")
                        .arg(limit);
}

QString travelProblem(const TravelProblem& problem, const ModuleState& module, const AxisScale& scale) {
    return travelProblem(problem, module.home.workZero(), scale);
}

QString fastestReason(const TravelSettings& travel) {
    return travel.fastest > 0 ? Texts::tr("The highest velocity is set on the Axis page.") : QString();
}

QString jogReason() {
    return Texts::tr("The max jog speed and the highest velocity are set on the Axis page.");
}

QString refusal(Refusal reason, const Intent& intent, const ModuleState& module, const AxisScale& scale) {
    const auto problem = nmc::travelProblem(intent, module);
    return problem && problem->refusal == reason ? travelProblem(*problem, module, scale) : refusal(reason);
}

QString travelState(const ModuleState& module, const AxisScale& scale) {
    switch (travelForce(module)) {
        case TravelForce::NotSet:
            return u"○ "_s + Texts::tr("No travel limits are set.");
        case TravelForce::HomeUnknown:
            return u"▲ "_s +
                   Texts::tr(
                       "Not in force: home is unknown. Search for it, save it, or confirm the position.");
        case TravelForce::InForce:
            break;
    }
    const Zero zero = module.home.workZero();
    const TravelRange range = travelRange(module).value_or(TravelRange{});
    const auto [lowest, highest] = scale.ordered(range.lowest, range.highest);
    if (!highest)
        return u"● "_s + Texts::tr("In force: not below %1.").arg(place(zero, scale, *lowest));
    if (!lowest)
        return u"● "_s + Texts::tr("In force: not above %1.").arg(place(zero, scale, *highest));
    return u"● "_s + Texts::tr("In force: from %1 to %2.")
                         .arg(place(zero, scale, *lowest), place(zero, scale, *highest));
}

QString travelSign(const ModuleState& module, const AxisScale& scale) {
    if (travelForce(module) == TravelForce::HomeUnknown)
        return u"▲ "_s + Texts::tr("Travel limits not in force");
    const auto place = static_cast<int>(travelPlace(module));
    switch (static_cast<TravelPlace>(scale.reversed() ? -place : place)) {
        case TravelPlace::Within:
            break;
        case TravelPlace::AtLowest:
            return u"● "_s + Texts::tr("At the lowest position");
        case TravelPlace::AtHighest:
            return u"● "_s + Texts::tr("At the highest position");
        case TravelPlace::BelowLowest:
            return u"▲ "_s + Texts::tr("Below the lowest position");
        case TravelPlace::AboveHighest:
            return u"▲ "_s + Texts::tr("Above the highest position");
    }
    return {};
}

QString declareQuestion(const ModuleState& module, const AxisScale& scale) {
    if (!module.latest || !module.latest->position)
        return {};
    return Texts::
        tr("Look at the axis first: is %1 really at %2? If so, home is at position 0, and the travel limits apply from there. If not, they protect the wrong range.")
            .arg(moduleName(module.info.index),
                 byCounter(module.home.workZero(), scale, *module.latest->position));
}

}  // namespace nmc::texts
