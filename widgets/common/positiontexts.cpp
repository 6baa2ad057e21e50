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

QString age(double seconds, bool doubtful) {
    if (doubtful)
        return Texts::tr("doubtful");
    return seconds >= 0.1 ? Texts::tr("%1 s old").arg(readout(std::floor(seconds * 10) / 10, 3))
                          : Texts::tr("out of date");
}

Message positionRemembered(const PositionMemory::Offer& offer, const AxisScale& scale) {
    const RememberedPosition& last = offer.remembered;
    const QString when = QLocale().toString(QDateTime::fromSecsSinceEpoch(last.seen), QLocale::ShortFormat);
    return {
        .key = ofModule(key::kPosition, offer.module),
        .module = offer.module,
        .headline = Texts::tr("Module %1 was %2 from home when last seen.")
                        .arg(moduleNumber(offer.module), position(scale, last.fromHome)),
        .body =
            (last.source == HomeFact::Source::Search
                 ? Texts::tr(
                       "That was on %1; a search had found home. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.")
                 : Texts::tr(
                       "That was on %1; home had been saved. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search."))
                .arg(when),
        .actions = {{MessageAction::TakePosition, Texts::tr("Restore home")},
                    {MessageAction::ForgetPosition, Texts::tr("Discard")}},
        .stands = true};
}

}  // namespace nmc::texts
