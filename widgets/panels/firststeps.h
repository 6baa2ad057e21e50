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

/// A strip below the page of a servo that has no gains yet: fill in, apply, enable, jog, with the next of
/// them marked. It goes when they are done, and leaves its room empty until giveRoomBack(): what it ends with
/// is a motion, and nothing moves under the pointer then.
class FirstSteps : public QFrame {
    Q_OBJECT

public:
    FirstSteps(ModuleContext& context, QWidget* parent);

    /// The page is laid out anew anyway.
    void giveRoomBack();

signals:
    /// "Show me": where that is done.
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
