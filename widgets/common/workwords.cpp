// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/workwords.h"

#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

QString from(const WorkZero& zero) {
    return Texts::tr("from \"%1\"").arg(QString::fromStdString(zero.offset.name));
}

QString place(const Zero& zero, const AxisScale& scale, double counts) {
    const auto shown = countedFrom(zero, counts);
    return zero && shown ? position(scale, *shown) + u' ' + from(*zero) : byCounter(zero, scale, counts);
}

QString byCounter(const Zero& zero, const AxisScale& scale, double counts) {
    const QString where = position(scale, counts);
    return zero ? Texts::tr("%1 by the counter").arg(where) : where;
}

QString marked(const Zero& zero, const AxisScale& scale, double counts) {
    const auto shown = countedFrom(zero, counts);
    return (zero ? u"◇ "_s : QString()) + (shown ? fixedPosition(scale, *shown) : u"–"_s);
}

QString zeroInUse(const Zero& zero) {
    if (!zero)
        return {};
    return (zero->counts
                ? Texts::tr("Positions count from \"%1\".")
                : Texts::tr(
                      "It is not known any more where \"%1\" is. Choose the work offset again, or clear it (Axis page)."))
        .arg(QString::fromStdString(zero->offset.name));
}

}  // namespace nmc::texts
