// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace nmc {

class NumberField;
class QuantityField;

/// What the user calls an axis and reads it in. Nothing here is sent: changing the unit keeps every physical
/// amount.
class AxisBox : public QWidget {
    Q_OBJECT

public:
    /// The names of a stepper's controls begin with "stepper"; its cap of hold to move is set where its
    /// speeds are.
    AxisBox(ModuleContext& context, QWidget* parent);

    /// Another box, below its fields.
    void addBelow(QWidget* box);
    /// The same where a first session looks: below name and unit.
    void addBelowUnit(QWidget* box);

private:
    [[nodiscard]] QString named(const QString& name) const;
    void build();
    void buildAnalog(QFormLayout* form);
    NumberField* addNumber(QFormLayout* form, const QString& label, const QString& objectName,
                           const QString& meaning);
    void connectControls();
    void workOutUnit();
    void edit(const SettingsEdit& change);
    void showModule();
    void refresh();
    [[nodiscard]] UnitKind kind() const;

    ModuleContext& m_context;
    ModuleType m_type;
    QLineEdit* m_name = nullptr;
    QComboBox* m_unit = nullptr;
    NumberField* m_countsPerUnit = nullptr;
    QLabel* m_countsPerUnitLabel = nullptr;
    QCheckBox* m_reversed = nullptr;
    QLineEdit* m_symbol = nullptr;
    QLabel* m_symbolLabel = nullptr;
    QuantityField* m_holdCap = nullptr;
    NumberField* m_analogPerCount = nullptr;
    NumberField* m_analogAtZero = nullptr;
    QLineEdit* m_analogUnit = nullptr;
    QLabel* m_hint = nullptr;
    std::optional<AxisSettings> m_shown;
};

}  // namespace nmc
