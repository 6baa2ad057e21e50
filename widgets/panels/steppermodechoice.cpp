// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/steppermodechoice.h"

#include <QRadioButton>

#include "widgets/common/flowlayout.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepperModeChoice::StepperModeChoice(QWidget* parent) : QWidget(parent) {
    struct Choice {
        QString name;
        QString text;
        QString meaning;
    };
    const std::array<Choice, 4> choices{
        Choice{u"stepperModeTrapezoidal"_s, tr("Move"),
               tr("Moves to a position with ramps (trapezoidal profile mode).")},
        Choice{u"stepperModeProfile"_s, tr("Run"),
               tr("Ramps to a speed and keeps it until stopped (velocity profile mode).")},
        Choice{
            u"stepperModeTimedMove"_s, tr("Move without ramp"),
            tr("Moves to a position at constant speed, without ramps. At too high a speed the motor loses steps (unprofiled, with stop).")},
        Choice{
            u"stepperModeTimedRun"_s, tr("Run without ramp"),
            tr("Runs at constant speed, without a ramp, until stopped. At too high a speed the motor loses steps (unprofiled, without stop).")}};
    look::name(this, u"stepperModeChoice"_s, tr("Kind of motion"));
    auto* row = new FlowLayout(look::gridUnit(this) * 2, this);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        m_buttons[i] = new QRadioButton(choices[i].text, this);
        look::name(m_buttons[i], choices[i].name, choices[i].text);
        m_buttons[i]->setToolTip(choices[i].meaning);
        row->addWidget(m_buttons[i]);
        connect(m_buttons[i], &QRadioButton::clicked, this, &StepperModeChoice::chosen);
    }
}

StepperModeChoice::Mode StepperModeChoice::mode() const {
    for (std::size_t i = 0; i < m_buttons.size(); ++i)
        if (m_buttons[i]->isChecked())
            return static_cast<Mode>(i);
    return Mode::Trapezoid;
}

void StepperModeChoice::showMode(Mode mode) {
    m_buttons[static_cast<std::size_t>(mode)]->setChecked(true);
}

}  // namespace nmc
