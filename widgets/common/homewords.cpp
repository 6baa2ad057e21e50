// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/homewords.h"

#include <cmath>

#include "widgets/common/textparts.h"
#include "widgets/common/workwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

using Place = std::optional<HomeFact::Place>;

}  // namespace

QString home(const Place& place, const Zero& zero, const AxisScale& scale) {
    if (!place)
        return Texts::tr("Home: unknown");
    const QString where = texts::place(zero, scale, place->counts);
    return place->verified() ? Texts::tr("Home: %1").arg(where)
                             : Texts::tr("Home: %1, not verified").arg(where);
}

QString homeMeaning(const Place& place, const Zero& zero, TimePoint seen, const AxisScale& scale) {
    if (!place)
        return Texts::tr(
            "Home is unknown. Search for home, or move there and choose Save as home. A restart of the module loses home again.");
    const QString where = texts::place(zero, scale, place->counts);
    // Counted up to the last status, whose age is shown beside it.
    const QString minutes = QString::number(std::floor(toSeconds(seen - place->since) / 60.0));
    switch (place->source) {
        case HomeFact::Source::Search:
            return Texts::tr("Home is at %1. A search found it %2 min ago.").arg(where, minutes);
        case HomeFact::Source::Saved:
            return Texts::tr("Home is at %1. It was saved %2 min ago.").arg(where, minutes);
        case HomeFact::Source::Declared:
            return Texts::tr("Home is at %1. You confirmed the position %2 min ago.").arg(where, minutes);
        case HomeFact::Source::Remembered:
            return Texts::
                tr("Home is at %1, not verified: restored %2 min ago from the last known position. Search for home to verify it.")
                    .arg(where, minutes);
    }
    return {};
}

QString zeroMeaning(const ModuleState& module, const AxisScale& scale) {
    const QString act = Texts::tr(
        "Makes the present position 0. The motor does not move. The old zero is lost: from then on all positions count from here.");
    if (!module.home.place() || !module.latest || !module.latest->position)
        return act;
    const std::int32_t now = module.home.place()->counts;
    const Zero zero = module.home.workZero();
    const QString home = Texts::tr("This moves home from %1 to %2.")
                             .arg(byCounter(zero, scale, now),
                                  byCounter(zero, scale, countsBetween(*module.latest->position, now)));
    return act + u' ' + home;
}

QString homeRegisterMeaning() {
    return Texts::tr(
        "The position that the chip captured or saved last. A limit stop changes it, too; Zero here does not. Go home does not use it.");
}

}  // namespace nmc::texts
