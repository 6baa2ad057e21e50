// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/dates.h"

namespace nmc {

QDateTime dateOf(TimePoint at, TimePoint now) {
    return QDateTime::currentDateTime().addMSecs(-qRound64(toSeconds(now - at) * 1e3));
}

QString isoDate(const QDateTime& date) {
    return date.toOffsetFromUtc(date.offsetFromUtc()).toString(Qt::ISODateWithMs);
}

QDateTime dateIn(const std::string& iso) {
    return QDateTime::fromString(QString::fromStdString(iso), Qt::ISODateWithMs);
}

}  // namespace nmc
