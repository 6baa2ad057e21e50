// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/unitwords.h"

#include <cmath>
#include <cstdlib>

#include "model/module/holding.h"
#include "model/module/modulestate.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

QString equal(std::optional<double> value, const QString& unit) {
    return u"= %1 %2"_s.arg(value ? readout(*value) : u"–"_s, unit);
}

QString countsOf(const AxisScale& scale) {
    return scale.steps() ? unitSteps() : unitCounts();
}

QString offBy(const Holding& holding, const AxisScale& scale) {
    return distance(scale, static_cast<double>(std::abs(holding.off)));
}

QString nativeVelocityUnit(const AxisScale& scale) {
    return scale.steps() ? Common::tr("steps/s") : unitVelocity();
}

QString nativeAccelerationUnit(const AxisScale& scale) {
    return scale.steps() ? Texts::tr("steps/s²") : Texts::tr("counts/tick²");
}

}  // namespace

QString unitOf(const AxisScale& scale) {
    switch (scale.unit().kind) {
        case UnitKind::Native:
            return countsOf(scale);
        case UnitKind::Turns:
            return Common::tr("turns");
        case UnitKind::Degrees:
            return u"°"_s;
        case UnitKind::Millimetres:
            return Texts::tr("mm");
        case UnitKind::Own:
            return QString::fromStdString(scale.unit().ownSymbol);
    }
    return {};
}

QString velocityUnitOf(const AxisScale& scale) {
    return scale.native() ? nativeVelocityUnit(scale) : measuredVelocityUnitOf(scale);
}

QString measuredVelocityUnitOf(const AxisScale& scale) {
    return Common::tr("%1/s").arg(unitOf(scale));
}

QString accelerationUnitOf(const AxisScale& scale) {
    return scale.native() ? nativeAccelerationUnit(scale) : Common::tr("%1/s²").arg(unitOf(scale));
}

QString velocity(const AxisScale& scale, double native, int significant) {
    const auto value = scale.velocity(native);
    return value ? readout(*value, significant) + u' ' + velocityUnitOf(scale)
                 : readout(native, significant) + u' ' + nativeVelocityUnit(scale);
}

QString acceleration(const AxisScale& scale, double native) {
    const auto value = scale.acceleration(native);
    return value ? readout(*value) + u' ' + accelerationUnitOf(scale)
                 : readout(native) + u' ' + nativeAccelerationUnit(scale);
}

int positionDecimals(const AxisScale& scale) {
    constexpr int kMax = 6;
    return qBound(0, static_cast<int>(std::ceil(-std::log10(scale.distance(1.0)))), kMax);
}

QString fixedPosition(const AxisScale& scale, double counts) {
    return fixed(scale.position(counts), positionDecimals(scale));
}

QString measuredVelocity(const AxisScale& scale, double countsPerSecond) {
    // A velocity measured over a fifth of a second is not more precise.
    constexpr int kMaxDecimals = 3;
    const int decimals = qBound(0, positionDecimals(scale) - 1, kMaxDecimals);
    return fixed(scale.position(countsPerSecond), decimals) + u' ' + measuredVelocityUnitOf(scale);
}

QString position(const AxisScale& scale, double counts) {
    return readout(scale.position(counts), 6) + u' ' + unitOf(scale);
}

QString distance(const AxisScale& scale, double counts) {
    return readout(scale.distance(counts), 6) + u' ' + unitOf(scale);
}

QString swing(const SwingWatch::Swing& swing, const AxisScale& scale) {
    const QString far = readout(scale.distance(swing.amplitude), 2) + u' ' + unitOf(scale);
    if (swing.hunts)
        return Texts::tr("Hunting ± %1 every %2 s. Lower Ki.").arg(far, readout(1 / *swing.hertz, 2));
    return swing.hertz ? Texts::tr("Oscillating ± %1 at about %2 Hz").arg(far, readout(*swing.hertz, 2))
                       : Texts::tr("Oscillating ± %1").arg(far);
}

QString activity(const ModuleState& module, const AxisScale& scale) {
    const QString word = activity(module.activity());
    const auto& swing = module.swing.swing();
    if (module.activity() == Activity::Holding && swing)
        return (swing->hunts ? Texts::tr("%1, hunting") : Texts::tr("%1, oscillating")).arg(word);
    const auto holding = holdingOf(module);
    if (!holding)
        return word;
    return holding->atLimit ? Texts::tr("%1, pushing at OL").arg(word)
                            : Texts::tr("%1, %2 off").arg(word, offBy(*holding, scale));
}

QString activityMeaning(const ModuleState& module, const AxisScale& scale) {
    if (module.activity() == Activity::Holding) {
        if (const auto& swing = module.swing.swing())
            return texts::swing(*swing, scale);
        if (module.isServo() && module.gains && module.gains->kp == 0)
            return Texts::tr("Kp is 0: the servo brakes the motor but holds no position.");
    }
    const auto holding = holdingOf(module);
    if (!holding)
        return activityMeaning(module.activity(), module.info.identity.type);
    return (holding->atLimit
                ? Texts::tr(
                      "%1 off the position to hold, and pushing with up to the full output limit. Something may be in the way.")
                : Texts::tr(
                      "%1 off the position to hold: friction, a load or an obstacle is stronger. A higher Kp, or an integral (Ki, IL), pushes more."))
        .arg(offBy(*holding, scale));
}

QString otherPosition(const AxisScale& scale, double counts) {
    return scale.native() ? QString() : equal(counts, countsOf(scale));
}

QString otherVelocity(const AxisScale& scale, double nativeVelocity) {
    if (!scale.native())
        return equal(nativeVelocity, nativeVelocityUnit(scale));
    const auto perSecond = scale.perSecond();
    return scale.steps() ? QString()
                         : equal(perSecond ? std::optional(nativeVelocity * *perSecond) : std::nullopt,
                                 Texts::tr("counts/s"));
}

QString otherAcceleration(const AxisScale& scale, double nativeAcceleration) {
    if (!scale.native())
        return equal(nativeAcceleration, nativeAccelerationUnit(scale));
    const auto perSecond = scale.perSecond();
    return scale.steps()
               ? QString()
               : equal(perSecond ? std::optional(nativeAcceleration * *perSecond * *perSecond) : std::nullopt,
                       Texts::tr("counts/s²"));
}

QString analog(const AnalogScale& scale, int value) {
    return readout(scale.atZero + scale.perCount * value, 3) + u' ' + QString::fromStdString(scale.unit);
}

QString analogReading(const AnalogScale& scale, std::optional<int> value) {
    return value ? Texts::tr("%1 (%2 of 255)").arg(analog(scale, *value), QString::number(*value)) : u"–"_s;
}

}  // namespace nmc::texts
