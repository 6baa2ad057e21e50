// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class Command;

/// Checks whether motor and encoder of a PIC-SERVO have the same direction, before it is enabled for the
/// first time (model/procedure/directioncheck.h). It asks before it drives the motor; the servo can be
/// enabled without this check.
class DirectionCheckBox : public QGroupBox {
    Q_OBJECT

public:
    DirectionCheckBox(ModuleContext& context, QWidget* parent);

private:
    void ask();
    void refresh();
    [[nodiscard]] std::optional<ProcedureReport> report() const;
    [[nodiscard]] QString whyNotNow() const;
    [[nodiscard]] QString question() const;
    [[nodiscard]] QString found() const;

    ModuleContext& m_context;
    Command* m_check;
    Command* m_cancel;
    QLabel* m_state;
};

}  // namespace nmc
