// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/positiontexts.h"

#include <QDateTime>
#include <QLocale>
#include <cmath>

#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

/// What was remembered keeps the source of the home that was verified last, so it is never Remembered.
QString lastHome(HomeFact::Source source) {
    switch (source) {
        case HomeFact::Source::Search:
            return Texts::tr(
                "That was on %1; a search had found home. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.");
        case HomeFact::Source::Declared:
            return Texts::tr(
                "That was on %1; the position had been confirmed. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.");
        case HomeFact::Source::Saved:
        case HomeFact::Source::Remembered:
            break;
    }
    return Texts::tr(
        "That was on %1; home had been saved. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.");
}

}  // namespace

QString age(double seconds, bool doubtful) {
    if (doubtful)
        return Texts::tr("doubtful");
    return seconds >= 0.1 ? Texts::tr("%1 s old").arg(readout(std::floor(seconds * 10) / 10, 3))
                          : Texts::tr("out of date");
}

Message positionRemembered(const PositionMemory::Offer& offer, const AxisScale& scale) {
    const RememberedPosition& last = offer.remembered;
    const QString when = QLocale().toString(QDateTime::fromSecsSinceEpoch(last.seen), QLocale::ShortFormat);
    return {.key = ofModule(key::kPosition, offer.module),
            .module = offer.module,
            .headline = Texts::tr("Module %1 was %2 from home when last seen.")
                            .arg(moduleNumber(offer.module), position(scale, last.fromHome)),
            .body = lastHome(last.source).arg(when),
            .actions = {{MessageAction::TakePosition, Texts::tr("Restore home")},
                        {MessageAction::ForgetPosition, Texts::tr("Discard")}},
            .stands = true};
}

}  // namespace nmc::texts
