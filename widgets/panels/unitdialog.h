// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "model/settings/drivetrain.h"
#include "widgets/panels/modulecontext.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;

/// Calculates the unit of an axis from the labels of encoder, gear and screw. Not modal, and sends nothing:
/// it changes the unit when its button is clicked.
class UnitDialog : public QDialog {
    Q_OBJECT

public:
    UnitDialog(ModuleContext& context, QWidget* parent);

private:
    NumberField* addField(const QString& name, const QString& label, double value, const QString& meaning);
    [[nodiscard]] DriveTrain drive() const;
    [[nodiscard]] UnitKind kind() const;
    void refresh();
    void take();

    ModuleContext& m_context;
    QFormLayout* m_form;
    QComboBox* m_kind = nullptr;
    NumberField* m_perTurn;  ///< lines of an encoder, full steps of a stepper
    NumberField* m_microsteps = nullptr;
    NumberField* m_motorTurns;
    NumberField* m_outputTurns;
    NumberField* m_travel;
    QLabel* m_result;
    QPushButton* m_use;
};

}  // namespace nmc
