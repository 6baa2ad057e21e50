// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "model/settings/machine.h"
#include "widgets/common/quantityfield.h"

class QAbstractButton;
class QLabel;

namespace nmc {

class FormGrid;

/// The fields of a home search. The form always has a complete recipe: a typed value that is not a number
/// within its range changes nothing, and is reported by problemText().
class HomingForm : public QWidget {
    Q_OBJECT

public:
    HomingForm(ModuleType type, QWidget* parent);

    /// Emits nothing.
    void showRecipe(const HomingRecipe& recipe);
    /// Emits nothing. The version of `chip` determines whether the chip or the panel stops the motor;
    /// `speedUnit`: for a PIC-STEP, the speed in steps/s of which all its speeds are whole multiples.
    void showChip(const AxisScale& scale, const ModuleIdentity& chip, double speedUnit);
    /// `reason`: why the fields cannot be edited; empty if they can.
    void setLocked(const QString& reason);

    [[nodiscard]] const HomingRecipe& recipe() const { return m_recipe; }
    /// Empty while every field in use has a valid value.
    [[nodiscard]] QString problemText() const;

signals:
    void edited();

private:
    using Flag = bool HomingRecipe::*;
    using Number = double HomingRecipe::*;
    struct Box {
        QAbstractButton* button;
        Flag flag;
        QString meaning;
    };
    struct Quantity {
        QuantityField* field;
        Number value;
        QLabel* label;
        QString meaning;
    };

    void buildConditions(FormGrid* grid);
    void buildMotion(FormGrid* grid);
    void buildEnd(FormGrid* grid);
    QWidget* row(const QList<QWidget*>& widgets);
    QAbstractButton* addBox(const QString& name, const QString& text, Flag flag, const QString& meaning);
    void addQuantity(FormGrid* grid, QuantityField::Kind kind, const QString& name, const QString& text,
                     Number value, const QString& meaning);
    [[nodiscard]] QString named(const QString& name) const;
    void refresh();
    void refreshStops();
    void applyEdit();
    [[nodiscard]] bool uses(Number value) const;

    ModuleType m_type;
    HomingRecipe m_recipe;
    bool m_reversed = false;  ///< the axis is reversed: forward here is reverse for the chip
    int m_version = 0;
    QString m_locked;  ///< why it is; empty if it is not
    QList<Box> m_boxes;
    QList<Quantity> m_quantities;
    QAbstractButton* m_forward = nullptr;
    QAbstractButton* m_reverse = nullptr;
    std::array<QAbstractButton*, 3> m_stops{};  ///< by HomingRecipe::Stop
    NumberField* m_timeLimit = nullptr;
};

}  // namespace nmc
