// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>

#include "widgets/panels/modulecontext.h"

class QAbstractButton;
class QLabel;

namespace nmc {

class Command;

/// Homing used as a safety stop (DS-V 5.2), because on a PIC-SERVO neither a limit input nor an excessive
/// position error or current stops the motor by itself. The stop is armed, not armed, or tripped; it is armed
/// for each motion if the axis is set up so (LimitStopSettings).
class LimitStopBox : public QGroupBox {
    Q_OBJECT

public:
    LimitStopBox(ModuleContext& context, QWidget* parent);

    /// True while a search for home or a measurement uses the same function of the chip.
    [[nodiscard]] static bool isReplaced(const ModuleContext& context);

private:
    /// A check box for what the motor is to be stopped at.
    struct Condition {
        QAbstractButton* box;
        bool ChipStop::*flag;
        QString meaning;
    };

    void refresh();
    void refreshState();
    [[nodiscard]] intent::ArmLimitStop wanted() const;
    [[nodiscard]] QString whyNotArmed() const;
    void keep();
    void showSettings();

    ModuleContext& m_context;
    std::array<Condition, 4> m_conditions;
    QAbstractButton* m_each;
    std::optional<LimitStopSettings> m_shown;
    std::array<QAbstractButton*, 3> m_manners{};  ///< by HomingRecipe::Stop
    Command* m_arm;
    Command* m_disarm;
    QLabel* m_state;
};

}  // namespace nmc
