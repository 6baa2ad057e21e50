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

/// Name, unit, jog speed cap and A/D scale of an axis, and the boxes for its direction, its work offsets and
/// its travel. Its own fields send nothing: changing the unit keeps every physical value.
class AxisBox : public QWidget {
    Q_OBJECT

public:
    /// The object names of a stepper's controls begin with "stepper"; its jog speed cap is set with its other
    /// speeds.
    AxisBox(ModuleContext& context, QWidget* parent);

private:
    void build();
    NumberField* addNumber(QFormLayout* form, const QString& label, const QString& objectName, double largest,
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
