// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/axisscale.h"
#include "widgets/common/numberfield.h"

class QLabel;

namespace nmc {

/// A field for a position, velocity or acceleration of one axis: kept in the chip's own numbers ("native",
/// model/settings/axisscale.h), shown in the user's unit, with the other view beside it. Changing the unit
/// keeps the physical amount to the last bit and emits nothing.
class QuantityField : public NumberField {
    Q_OBJECT

public:
    /// A position may be below 0, and is that of a reversed axis from its other side; all others are amounts.
    enum class Kind : std::uint8_t { Position, Distance, Velocity, Acceleration };

    QuantityField(Kind kind, QWidget* parent = nullptr);

    /// What the field is called in its sentences.
    void setQuantity(const QString& quantity);
    void setNativeRange(double min, double max);
    /// What an arrow key adds: so much in the chip's numbers, in the user's unit the round number below it.
    void setNativeStep(double step);
    /// Emits nothing. A servo rate that changes keeps the native number: the chip would, too. While the scale
    /// is not timed(), a velocity or acceleration shows nothing, has no value and cannot be edited.
    void setScale(const AxisScale& scale);
    [[nodiscard]] const AxisScale& scale() const { return m_scale; }

    /// Emits nothing.
    void showNative(double native);
    void showNothing();
    /// Empty while what stands there is not one number within the range.
    [[nodiscard]] std::optional<double> native() const;

    /// The unit, and the same number in the other view; children of the field's parent, to be laid out beside
    /// it.
    [[nodiscard]] QLabel* unitLabel() const { return m_unit; }
    [[nodiscard]] QLabel* otherView() const { return m_other; }
    /// Also names the other view's label: `objectName` + "PerSecond".
    void setName(const QString& objectName, const QString& accessibleName);

signals:
    /// The user has typed another number, or one that is none.
    void nativeEdited();

private:
    void takeText();
    void refresh();
    [[nodiscard]] bool tellable() const { return m_kind <= Kind::Distance || m_scale.timed(); }
    /// These two only while it is tellable().
    [[nodiscard]] double toUser(double native) const;
    [[nodiscard]] double toNative(double user) const;
    [[nodiscard]] int decimalsWanted() const;
    [[nodiscard]] QString unitText() const;
    [[nodiscard]] QString otherText(double native) const;

    Kind m_kind;
    AxisScale m_scale;
    double m_min = 0;
    double m_max = 0;
    double m_step = 1;
    std::optional<double> m_native;  ///< exact, however it is rounded for show
    QString m_quantity;
    QLabel* m_unit;
    QLabel* m_other;
};

}  // namespace nmc
