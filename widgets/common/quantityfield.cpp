// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/quantityfield.h"

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/common/workwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kVelocityDecimals = 4;
constexpr int kAccelerationDecimals = 5;
constexpr int kMaxDecimals = 6;
/// Resolution of a PIC-SERVO's velocity or acceleration in the user's unit, as a fraction of one native unit.
constexpr double kFinePart = 1e-4;

/// The largest number not above `value` that is 1, 2 or 5 times a power of ten.
double roundBelow(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    const double digit = value / decade + 1e-9;
    return decade * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}
}  // namespace

QuantityField::QuantityField(Kind kind, QWidget* parent)
    : NumberField(0, parent), m_kind(kind), m_unit(new QLabel(parent)), m_other(newMutedLine(parent)) {
    m_other->setFont(look::tabular(font()));
    connect(this, &NumberField::edited, this, &QuantityField::takeText);
    refresh();
}

void QuantityField::setName(const QString& objectName, const QString& accessibleName) {
    m_accessible = accessibleName;
    look::name(this, objectName, accessibleName);
    m_unit->setObjectName(objectName + u"Unit"_s);
    m_other->setObjectName(objectName + u"PerSecond"_s);
}

void QuantityField::setQuantity(const QString& quantity) {
    m_quantity = quantity;
    refresh();
}

void QuantityField::setNativeRange(double min, double max) {
    if (min == m_min && max == m_max)
        return;  // called with every status of the module
    m_min = min;
    m_max = max;
    refresh();
}

void QuantityField::setNativeStep(double step) {
    m_step = step;
    refresh();
}

void QuantityField::setScale(const AxisScale& scale) {
    if (scale == m_scale)
        return;
    m_scale = scale;
    refresh();
    if (!convertible())
        return NumberField::showNothing();
    // Shown again, because the old number may not have been in the range of the new unit.
    if (m_native)
        showNative(*m_native);
}

void QuantityField::setZero(const std::optional<WorkZero>& zero, bool keepsNumber) {
    if (zero == m_zero)
        return;
    const std::optional<double> before = countsOfZero();
    // The same offset is at other counts only after the counter was set, and is still the same place.
    keepsNumber = keepsNumber || (zero && m_zero && zero->offset == m_zero->offset);
    m_zero = zero;
    const std::optional<double> after = countsOfZero();
    if (!before || !after)
        m_native.reset();
    else if (m_native && keepsNumber)
        *m_native += *after - *before;
    if (!m_native)
        NumberField::showNothing();
    setAccessibleName(zero ? m_accessible + u", "_s + texts::from(*zero) : m_accessible);
    refresh();
    if (m_native)
        showNative(*m_native);
}

void QuantityField::showNative(double native) {
    m_native = native;
    if (convertible())
        showValue(toUser(native));
    refresh();
}

void QuantityField::showNothing() {
    m_native.reset();
    NumberField::showNothing();
    refresh();
}

void QuantityField::follow(double native, double nativeBefore) {
    if (native != nativeBefore && this->native() != native)
        showNative(native);
}

std::optional<double> QuantityField::native() const {
    return value().has_value() ? m_native : std::nullopt;
}

void QuantityField::takeText() {
    m_native.reset();
    refresh();
    emit nativeEdited();
}

void QuantityField::refresh() {
    setWords(m_quantity, m_zero ? unitText() + u' ' + texts::from(*m_zero) : unitText());
    look::setText(m_unit, unitText());
    setUnavailable(convertible()    ? QString()
                   : countsOfZero() ? texts::refusal(Refusal::ServoRateUnknown)
                                    : texts::zeroInUse(m_zero));
    if (convertible()) {
        setDecimals(decimalsWanted());
        const auto [lowest, highest] = std::minmax({toUser(m_min), toUser(m_max)});
        setRange(lowest, highest);
        const double finest = std::pow(10.0, -decimals());
        setSingleStep(m_scale.native() ? m_step : std::max(roundBelow(std::abs(toUser(m_step))), finest));
        // Also a text that had no value in the range or unit of before, and has one now.
        if (const std::optional<double> user = value(); user && !m_native)
            m_native = std::clamp(toNative(*user), m_min, m_max);
    }
    const std::optional<double> now = convertible() ? native() : m_native;
    // In counts it would be the place by the counter, which is another number.
    look::setText(m_other, m_zero ? texts::from(*m_zero) : now ? otherText(*now) : u"–"_s);
}

double QuantityField::toUser(double native) const {
    switch (m_kind) {
        case Kind::Position:
            return m_scale.position(native - *countsOfZero());
        case Kind::Distance:
            return m_scale.distance(native);
        case Kind::Velocity:
            return direction() * *m_scale.velocity(native);
        case Kind::Acceleration:
            return *m_scale.acceleration(native);
    }
    return native;
}

double QuantityField::toNative(double user) const {
    switch (m_kind) {
        case Kind::Position:
            // The chip knows only whole counts.
            return std::round(m_scale.counts(user)) + *countsOfZero();
        case Kind::Distance:
            return std::round(m_scale.countsOfDistance(user));
        case Kind::Velocity:
            return direction() * *m_scale.nativeVelocity(user);
        case Kind::Acceleration:
            return *m_scale.nativeAcceleration(user);
    }
    return user;
}

/// As many decimals as the chip can resolve.
int QuantityField::decimalsWanted() const {
    if (m_kind <= Kind::Distance)
        return texts::positionDecimals(m_scale);
    const bool velocity = m_kind == Kind::Velocity;
    if (m_scale.native() && m_scale.steps())
        return velocity ? 1 : 0;
    if (m_scale.native())
        return velocity ? kVelocityDecimals : kAccelerationDecimals;
    const double finest = std::abs(toUser(1.0)) * (m_scale.steps() ? 1.0 : kFinePart);
    return qBound(0, static_cast<int>(std::ceil(-std::log10(finest))), kMaxDecimals);
}

QString QuantityField::unitText() const {
    if (m_kind <= Kind::Distance)
        return texts::unitOf(m_scale);
    return m_kind == Kind::Velocity ? texts::velocityUnitOf(m_scale) : texts::accelerationUnitOf(m_scale);
}

QString QuantityField::otherText(double native) const {
    if (m_kind <= Kind::Distance)
        return texts::otherPosition(m_scale, native);
    return m_kind == Kind::Velocity ? texts::otherVelocity(m_scale, native)
                                    : texts::otherAcceleration(m_scale, native);
}

}  // namespace nmc
