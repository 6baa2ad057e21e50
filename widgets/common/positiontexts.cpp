// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/positiontexts.h"

#include <QDateTime>
#include <QLocale>

#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

Message positionRemembered(const PositionMemory::Offer& offer, const AxisScale& scale) {
    const RememberedPosition& last = offer.remembered;
    const QString when = QLocale().toString(QDateTime::fromSecsSinceEpoch(last.seen), QLocale::ShortFormat);
    return {
        .key = key::position(offer.module),
        .module = offer.module,
        .headline = Texts::tr("Module %1 stood %2 from home when it was seen last.")
                        .arg(moduleNumber(offer.module), position(scale, last.fromHome)),
        .body =
            (last.source == HomeFact::Source::Search
                 ? Texts::tr(
                       "That was on %1; a search had found that home. If nothing has moved the axis since, home can be taken from that: not verified, until a search finds it.")
                 : Texts::tr(
                       "That was on %1; that home had been saved. If nothing has moved the axis since, home can be taken from that: not verified, until a search finds it."))
                .arg(when),
        .actions = {{MessageAction::TakePosition, Texts::tr("Take home from that")},
                    {MessageAction::ForgetPosition, Texts::tr("Forget it")}},
        .stands = true};
}

QString key::position(ModuleIndex module) {
    return ofModule(u"position"_s, module);
}

}  // namespace nmc::texts
