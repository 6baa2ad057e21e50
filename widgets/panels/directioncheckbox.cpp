// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/directioncheckbox.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "model/intent/directionplan.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

DirectionCheckBox::DirectionCheckBox(QWidget* parent)
    : QGroupBox(tr("Direction"), parent),
      m_check(new QPushButton(tr("Direction check…"), this)),
      m_cancel(new QPushButton(tr("Cancel"), this)),
      m_state(new QLabel(this)) {
    look::name(this, u"directionCheckBox"_s, tr("Direction of motor and encoder"));
    look::name(m_check, u"directionCheckButton"_s, tr("Check the direction of motor and encoder"));
    look::name(m_cancel, u"cancelDirectionCheckButton"_s, tr("Cancel the direction check"));
    look::nameText(m_state, u"directionCheckState"_s, tr("What the direction check has found"));
    m_state->setWordWrap(true);
    m_state->setTextFormat(Qt::PlainText);

    const int unit = look::gridUnit(this);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_check);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(unit / 2);
    layout->addWidget(m_state);
    layout->addLayout(buttons);

    connect(m_check, &QPushButton::clicked, this, &DirectionCheckBox::ask);
    connect(m_cancel, &QPushButton::clicked, this,
            [this] { emit intentRequested(intent::CancelProcedure{}); });
    refresh();
}

void DirectionCheckBox::showModule(const PanelView& view) {
    const bool another = !m_known || m_module.info.index != view.module.info.index;
    if (another || !view.connected)
        m_report.reset();
    m_known = true;
    m_module = view.module;
    m_unit = view.settings.unit;
    m_scale = view.scale();
    m_connected = view.connected;
    // None was told of in this connection: whoever has changed a plug since the last has to look again.
    if (view.procedure == nullptr)
        m_report.reset();
    else if (m_connected && view.procedure->kind == ProcedureKind::DirectionCheck)
        m_report = *view.procedure;
    refresh();
}

void DirectionCheckBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

bool DirectionCheckBox::running() const {
    return m_report && !m_report->over();
}

QString DirectionCheckBox::whyNotNow() const {
    if (!m_connected)
        return texts::refusal(Refusal::NotConnected);
    if (running())
        return tr("A direction check is under way.");
    const auto refusal = whyNot(Request::CheckDirection, m_module);
    if (refusal == Refusal::Moving)
        return tr("Something turns the motor. Wait until it stands still.");
    if (refusal)
        return texts::refusal(*refusal);
    return m_busy ? tr("Waiting for the module's answer.") : QString();
}

QString DirectionCheckBox::question() const {
    constexpr double kWhole = 255.0;
    return tr("The motor of %1 will move a little, forward and in reverse. It is pushed for less than a "
              "tenth "
              "of a second at a time, a little stronger each time up to %2 % of its supply, until it has "
              "moved "
              "%3; a motor that runs freely may run on for some more. Farther than %4 ends the check. Keep "
              "clear of it.")
        .arg(texts::moduleName(m_module.info.index))
        .arg(qRound(kStrongestPush * 100.0 / kWhole))
        .arg(texts::position(m_scale, kMovedCounts), texts::position(m_scale, directionReach(m_unit)));
}

void DirectionCheckBox::ask() {
    if (!whyNotNow().isEmpty())
        return;
    // The module that it was asked for, as long as that can be checked.
    const auto text = [this, module = m_module.info.index] {
        const bool same = module == m_module.info.index && parentWidget()->isVisible();
        return same && whyNotNow().isEmpty() ? question() : QString();
    };
    AskDialog::ask({.name = u"directionCheckDialog"_s,
                    .title = tr("Direction check"),
                    .text = text,
                    .stay = tr("&Cancel"),
                    .stayName = u"stayDirectionCheckButton"_s,
                    .stayIsDefault = true},
                   {{tr("&Push the motor"), u"startDirectionCheckButton"_s,
                     [this] { emit intentRequested(intent::CheckDirection{directionReach(m_unit)}); }}},
                   window());
}

/// Shape, then word.
QString DirectionCheckBox::state() const {
    if (running())
        return u"▶ "_s + (m_report->round > 1 ? tr("Pushing it in reverse.") : tr("Pushing it forward."));
    if (m_report && m_report->direction)
        return (m_report->direction->verdict == DirectionVerdict::Right ? u"✓ "_s : u"▲ "_s) +
               texts::directionFound(*m_report->direction);
    if (m_report && m_report->failure)
        return u"▲ "_s + tr("No verdict: see the message.");
    return u"○ "_s +
           tr("Not checked in this connection. Do it before you enable the servo for the first time: "
              "with motor or encoder reversed it runs away.");
}

void DirectionCheckBox::refresh() {
    look::setPossible(
        m_check, whyNotNow(),
        tr("Moves the motor a little, without the servo, to see that it turns the way its encoder "
           "counts. Asks first."));
    look::setPossible(m_cancel, running() ? QString() : tr("No direction check is under way."),
                      tr("Ends the check; the motor is off then."));
    look::setText(m_state, state());
}

}  // namespace nmc
