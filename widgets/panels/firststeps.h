// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <array>
#include <optional>

#include "model/module/firststep.h"
#include "widgets/panels/modulecontext.h"

class QLabel;
class QPushButton;

namespace nmc {

class ElidedLabel;

/// A strip below the page of a servo that has no gains yet: fill in, apply, enable, jog, with the next step
/// marked. It disappears when all are done, but leaves its room empty until giveRoomBack(): the last step is
/// a motion, and nothing may shift under the pointer then.
class FirstSteps : public QFrame {
    Q_OBJECT

public:
    FirstSteps(ModuleContext& context, QWidget* parent);

    /// Call when the page is laid out again anyway.
    void giveRoomBack();

signals:
    /// "Show me" was clicked: the control for this step is to be shown.
    void placeWanted(nmc::FirstStep step);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void refreshSteps(FirstStep next);

    ModuleContext& m_context;
    std::array<QLabel*, 4> m_steps{};
    ElidedLabel* m_hint;
    QPushButton* m_show;
    std::optional<FirstStep> m_next;
};

}  // namespace nmc
