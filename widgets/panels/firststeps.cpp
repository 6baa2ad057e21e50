// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/firststeps.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kRoomForAllSteps = 46;  ///< width, in heights of a text line, from which all steps have room

struct StepWords {
    QString title;
    QString hint;
};

StepWords wordsOf(FirstStep step) {
    switch (step) {
        case FirstStep::FillInGains:
            return {FirstSteps::tr("Fill in gains"),
                    FirstSteps::tr("Take the starting values, or type your own. Nothing is sent yet.")};
        case FirstStep::ApplyGains:
            return {FirstSteps::tr("Apply gains"),
                    FirstSteps::tr("Sends the gains to the module. The motor does not move.")};
        case FirstStep::Enable:
            return {FirstSteps::tr("Enable servo"),
                    FirstSteps::tr("New wiring? Run the direction check on the Axis page first.")};
        case FirstStep::Jog:
            return {Common::tr("Jog"),
                    FirstSteps::tr("The motor moves while you hold the button. Esc stops it from anywhere.")};
    }
    return {};
}

}  // namespace

FirstSteps::FirstSteps(ModuleContext& context, QWidget* parent)
    : QFrame(parent),
      m_context(context),
      m_hint(newMutedLine(this, u"firstStepHint"_s)),
      m_show(new QPushButton(tr("Show me"), this)) {
    look::name(this, u"firstSteps"_s, tr("First steps"));
    look::name(m_show, u"firstStepButton"_s, tr("Show me: the next step"));
    m_show->setToolTip(tr("Shows the control for the next step. Sends nothing."));
    const int unit = look::gridUnit(this);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit / 3, unit, unit / 3);
    layout->setSpacing(unit * 2);
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        m_steps[i] = new QLabel(this);
        m_steps[i]->setObjectName(u"firstStep%1"_s.arg(i + 1));
        layout->addWidget(m_steps[i]);
    }
    layout->addWidget(m_hint, 1);
    layout->addStretch();
    layout->addWidget(m_show);
    connect(m_show, &QPushButton::clicked, this, [this] {
        if (m_next)
            emit placeWanted(*m_next);
    });
    // Not whenSeen(), which does not refresh a hidden box: the strip hides itself.
    connect(&m_context, &ModuleContext::changed, this, &FirstSteps::refresh);
    refresh();
}

void FirstSteps::giveRoomBack() {
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(false);
    setSizePolicy(policy);
}

void FirstSteps::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    if (m_next)
        refreshSteps(*m_next);
}

void FirstSteps::refresh() {
    const ModuleState& module = m_context.state();
    const bool mayAct = m_context.connected() && !module.silent && !module.lookedFor && !module.readOnly &&
                        !module.lent && !module.rights && !module.otherType();
    m_next = mayAct ? nextFirstStep(module, m_context.settings()) : std::nullopt;
    if (m_next) {
        refreshSteps(*m_next);
        look::keepRoom(this);
    }
    setVisible(m_next.has_value());
}

/// Shows each step as a shape followed by words: a check mark for one that is done, an arrow at the next.
void FirstSteps::refreshSteps(FirstStep next) {
    const bool wide = width() >= fontMetrics().height() * kRoomForAllSteps;
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const auto step = static_cast<FirstStep>(i);
        const QString mark = step < next    ? u"✓"_s
                             : step == next ? u"▸ %1."_s.arg(i + 1)
                                            : u"%1."_s.arg(i + 1);
        look::setText(m_steps[i], mark + u' ' + wordsOf(step).title);
        QFont font = this->font();
        font.setBold(step == next);
        if (m_steps[i]->font().bold() != font.bold())
            m_steps[i]->setFont(font);
        m_steps[i]->setVisible(wide || step == next);
    }
    const StepWords words = wordsOf(next);
    look::setText(m_hint, words.hint);
    m_hint->setVisible(wide);
    setToolTip(words.hint);
    setAccessibleDescription(
        tr("Step %1 of %2: %3").arg(static_cast<int>(next) + 1).arg(m_steps.size()).arg(words.title));
}

}  // namespace nmc
