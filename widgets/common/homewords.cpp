// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/homewords.h"

#include <QCoreApplication>
#include <cmath>

#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

using Place = std::optional<HomeFact::Place>;

class Texts {
    Q_DECLARE_TR_FUNCTIONS(HomeTexts)
};

}  // namespace

QString home(const Place& place, const AxisScale& scale) {
    if (!place)
        return Texts::tr("Home: not known");
    const QString where = position(scale, place->counts);
    return place->verified() ? Texts::tr("Home: %1").arg(where)
                             : Texts::tr("Home: %1, not verified").arg(where);
}

QString homeMeaning(const Place& place, TimePoint seen, const AxisScale& scale) {
    if (!place)
        return Texts::tr(
            "Where home is, is not known in this connection. A search finds it, Save as home sets it; a restart, and whatever else sets the position unseen, loses it.");
    const QString where = position(scale, place->counts);
    // As of the last status: how old that is, stands beside it.
    const double minutes = std::floor(toSeconds(seen - place->since) / 60.0);
    switch (place->source) {
        case HomeFact::Source::Search:
            return Texts::tr("Home is at %1. A search found it %2 min ago.").arg(where).arg(minutes);
        case HomeFact::Source::Saved:
            return Texts::tr("Home is at %1. It was saved %2 min ago.").arg(where).arg(minutes);
        case HomeFact::Source::Declared:
            return Texts::tr("Home is at %1. The position was declared right %2 min ago.")
                .arg(where)
                .arg(minutes);
        case HomeFact::Source::Remembered:
            return Texts::
                tr("Home is at %1, not verified: it was taken from where the axis was seen last, %2 min ago. A search verifies it.")
                    .arg(where)
                    .arg(minutes);
    }
    return {};
}

QString zeroMeaning(const ModuleState& module, const AxisScale& scale) {
    const QString act = Texts::tr(
        "Makes the present position 0. The motor does not move. Where 0 has been is lost: all positions are counted from here then.");
    if (!module.home.place() || !module.latest || !module.latest->position)
        return act;
    const std::int32_t now = module.home.place()->counts;
    return act + u' ' +
           Texts::tr("Home, now at %1, is at %2 then.")
               .arg(position(scale, now), position(scale, countsBetween(*module.latest->position, now)));
}

QString homeRegisterMeaning() {
    return Texts::tr(
        "What the chip captured or saved last, as it counted then: a limit stop writes it as well, and Zero here leaves it as it is. Go home does not go by it.");
}

}  // namespace nmc::texts
