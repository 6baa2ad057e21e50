// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/homefact.h"
#include "model/settings/axisscale.h"
#include "widgets/common/numberfield.h"

class QLabel;

namespace nmc {

/// A field for a position, velocity or acceleration of one axis: kept in the chip's own numbers ("native",
/// model/settings/axisscale.h), shown in the user's unit, with the value in the other unit beside it.
/// Changing the unit keeps the physical quantity to the last bit and emits nothing.
class QuantityField : public NumberField {
    Q_OBJECT

public:
    /// A position may be negative, and changes its sign on a reversed axis, as does a velocity whose native
    /// range goes below 0; all others are magnitudes.
    enum class Kind : std::uint8_t { Position, Distance, Velocity, Acceleration };

    QuantityField(Kind kind, QWidget* parent = nullptr);

    /// The name of the quantity in sentences about the field.
    void setQuantity(const QString& quantity);
    void setNativeRange(double min, double max);
    /// The step of an arrow key, in the chip's numbers; in the user's unit, the next lower round number.
    void setNativeStep(double step);
    /// Emits nothing. A change of the servo rate keeps the native number, as the chip does. While the scale
    /// is not timed(), a field for a velocity or acceleration is empty, has no value and cannot be edited.
    void setScale(const AxisScale& scale);
    [[nodiscard]] const AxisScale& scale() const { return m_scale; }
    /// The work offset from which a position counts. Emits nothing. The position that was typed stays the
    /// same place and is shown as another number, or, with `keepsNumber`, the number stays. The number also
    /// stays if the chip's counter was set, because it is the same place by the new counter. Any other text
    /// is cleared, and so is all text if the old or the new zero is not known: the same text would be another
    /// place. While it is not known, the field cannot be edited.
    void setZero(const std::optional<WorkZero>& zero, bool keepsNumber = false);

    /// Emits nothing.
    void showNative(double native);
    void showNothing();
    /// Shows a value that is kept elsewhere if it has changed and the field does not contain it already, so
    /// that what is being typed is kept. Emits nothing.
    void follow(double native, double nativeBefore);
    /// Empty unless the text is an unambiguous number within the range.
    [[nodiscard]] std::optional<double> native() const;

    /// Labels with the unit and with the value in the other unit; children of the field's parent, to be
    /// placed beside the field.
    [[nodiscard]] QLabel* unitLabel() const { return m_unit; }
    [[nodiscard]] QLabel* otherView() const { return m_other; }
    /// Also names the labels: `objectName` + "Unit" and `objectName` + "PerSecond".
    void setName(const QString& objectName, const QString& accessibleName);

signals:
    /// The user has typed another number, or something that is not a number.
    void nativeEdited();

private:
    void takeText();
    void refresh();
    [[nodiscard]] bool convertible() const {
        return m_kind <= Kind::Distance ? countsOfZero().has_value() : m_scale.timed();
    }
    [[nodiscard]] std::optional<double> countsOfZero() const { return m_zero ? m_zero->counts : 0.0; }
    /// -1 for a velocity that has a direction, on a reversed axis.
    [[nodiscard]] double direction() const { return m_min < 0 && m_scale.reversed() ? -1.0 : 1.0; }
    /// toUser() and toNative() require convertible().
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
    std::optional<double> m_native;  ///< exact, even if it is shown rounded
    std::optional<WorkZero> m_zero;
    QString m_quantity;
    QString m_accessible;
    QLabel* m_unit;
    QLabel* m_other;
};

}  // namespace nmc
