// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/directioncheckbox.h"

#include <QLabel>
#include <QVBoxLayout>

#include "model/intent/directionplan.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Beside the plots, where the page is narrow; a form that has little room would cut the text off.
constexpr int kVerdictLines = 4;
}  // namespace

DirectionCheckBox::DirectionCheckBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(tr("Direction"), parent),
      m_context(context),
      m_check(new Command({.name = u"directionCheckButton"_s,
                           .text = tr("Direction check…"),
                           .accessible = tr("Direction check of motor and encoder")},
                          this, [this] { ask(); })),
      m_cancel(new Command({.name = u"cancelDirectionCheckButton"_s,
                            .text = Common::tr("Cancel"),
                            .accessible = tr("Cancel the direction check")},
                           this, [this] { m_context.ask(intent::CancelProcedure{}); })),
      m_state(form::newParagraph(u"directionCheckState"_s, tr("Result of the direction check"), this,
                                 kVerdictLines)) {
    look::name(this, u"directionCheckBox"_s, tr("Direction of motor and encoder"));
    const int unit = look::gridUnit(this);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(unit / 2);
    layout->addWidget(m_state);
    layout->addLayout(new FlowLayout(unit, {m_cancel->button(), m_check->button()}));
    m_context.whenSeen(this, [this] { refresh(); });
}

std::optional<ProcedureReport> DirectionCheckBox::report() const {
    // Only a report of this connection counts: since an earlier one, a plug may have been changed.
    return m_context.connected() ? m_context.procedure(ProcedureKind::DirectionCheck) : std::nullopt;
}

QString DirectionCheckBox::whyNotNow() const {
    if (!m_context.connected())
        return texts::refusal(Refusal::NotConnected);
    if (m_context.runs(ProcedureKind::DirectionCheck))
        return tr("A direction check is running.");
    if (m_context.whyNot(IntentKind::CheckDirection) == Refusal::Moving)
        return tr("Something turns the motor. Wait until it is at rest.");
    return m_context.reasonNow(IntentKind::CheckDirection);
}

QString DirectionCheckBox::question() const {
    constexpr double kWhole = 255.0;
    const AxisScale scale = m_context.scale();
    return tr("The motor of %1 will move a little, forward and in reverse. It is driven in pulses of less than 0.1 s, with slowly rising power up to %2 % of its supply, until it has moved %3. A motor that runs freely may coast farther; more than %4 ends the check. Keep clear of it.")
        .arg(texts::moduleName(m_context.state().info.index),
             QString::number(qRound(kStrongestPush * 100.0 / kWhole)), texts::distance(scale, kMovedCounts),
             texts::distance(scale, directionReach(m_context.settings().unit)));
}

void DirectionCheckBox::ask() {
    // The question stays as long as the Axis page is visible and the check is possible.
    const auto text = [this] {
        const bool stands = parentWidget()->isVisible() && whyNotNow().isEmpty();
        return stands ? question() : QString();
    };
    const auto go = [this] {
        m_context.ask(intent::CheckDirection{directionReach(m_context.settings().unit)});
    };
    AskDialog::ask({.name = u"directionCheckDialog"_s,
                    .title = tr("Direction check"),
                    .text = text,
                    .stayName = u"stayDirectionCheckButton"_s},
                   {{tr("&Pulse motor"), u"startDirectionCheckButton"_s, go}}, this);
}

/// Returns the state of the check, as a shape followed by words.
QString DirectionCheckBox::found() const {
    const auto check = report();
    if (m_context.runs(ProcedureKind::DirectionCheck))
        return u"▶ "_s + (m_context.chipReverse(check->round > 1) ? tr("Driving it in reverse.")
                                                                  : tr("Driving it forward."));
    if (check && check->direction)
        return (check->direction->verdict == DirectionVerdict::Right ? u"✓ "_s : u"▲ "_s) +
               texts::directionFound(*check->direction);
    if (check && check->failure)
        return u"▲ "_s + tr("Inconclusive: see the message.");
    return u"○ "_s +
           tr("Not checked in this connection. Run the check before you enable the servo for the first time: with motor or encoder reversed, it runs away.");
}

void DirectionCheckBox::refresh() {
    m_check->setPossible(
        whyNotNow(),
        tr("Moves the motor a little, without the servo, to check that it turns the way its encoder counts. Asks first."));
    m_cancel->setPossible(
        m_context.runs(ProcedureKind::DirectionCheck) ? QString() : tr("No direction check is running."),
        tr("Ends the check and switches the motor off."));
    look::setText(m_state, found());
}

}  // namespace nmc
