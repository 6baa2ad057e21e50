// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/axes/axisrow.h"

#include <QGridLayout>
#include <QLabel>
#include <cmath>
#include <utility>

#include "model/intent/jog.h"
#include "model/intent/rights.h"
#include "widgets/common/look.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/common/workwords.h"
#include "widgets/panels/command.h"
#include "widgets/panels/holdbutton.h"

namespace nmc {

using namespace Qt::StringLiterals;

AxisRow::AxisRow(const PanelView& view, Requests& requests, int line, QGridLayout& grid, QWidget* box)
    : QObject(box),
      m_context(view, requests),
      m_name(new QLabel(box)),
      m_state(new QLabel(box)),
      m_position(new QLabel(box)) {
    const QString number = QString::number(line);
    look::nameText(m_name, u"axisName"_s + number, Common::tr("Axis"));
    m_state->setObjectName(u"axisState"_s + number);
    m_position->setObjectName(u"axisPosition"_s + number);
    m_position->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_position->setFont(look::tabular(m_position->font()));
    const auto newHold = [&](const QString& name, bool reverse) {
        auto* button = newJogButton(
            m_context, reverse, [this, reverse](double /*share*/) { return wantedHold(reverse); }, box);
        button->setObjectName(name + number);
        return button;
    };
    m_holdReverse = newHold(u"axisHoldReverseButton"_s, true);
    m_holdForward = newHold(u"axisHoldForwardButton"_s, false);
    const auto newCommand = [&](const QString& name, const QString& text, const std::function<void()>& act) {
        return new Command({.name = name + number, .icon = {}, .text = text, .accessible = {}}, box, act);
    };
    m_stepReverse = newCommand(u"axisStepReverseButton"_s, Common::tr("◂| Step"), [this] { step(true); });
    m_stepForward = newCommand(u"axisStepForwardButton"_s, Common::tr("Step |▸"), [this] { step(false); });
    m_earlier = newCommand(u"axisHomeEarlierButton"_s, tr("Home earlier"),
                           [this] { emit earlierWanted(m_context.state().info.index); });
    int column = 0;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_state, m_position, m_holdReverse,
                                                           m_holdForward, m_stepReverse->button(),
                                                           m_stepForward->button(), m_earlier->button()})
        grid.addWidget(widget, line, column++);
    m_context.whenSeen(m_name, [this] { refresh(); });
}

void AxisRow::remove() {
    endHold();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_state, m_position, m_holdReverse,
                                                           m_holdForward, m_stepReverse->button(),
                                                           m_stepForward->button(), m_earlier->button()}) {
        widget->setObjectName({});  // its successor has the same name
        widget->hide();
        widget->deleteLater();
    }
    for (Command* command : {m_stepReverse, m_stepForward, m_earlier})
        command->deleteLater();
    deleteLater();
}

void AxisRow::show(const PanelView& view) {
    if (view.scale().reversed() != m_context.scale().reversed())
        endHold();
    m_context.show(view);
}

void AxisRow::setJog(JogSpeed speed, double step, int place) {
    if (speed != m_speed)
        endHold();  // a hold in progress was requested at another speed
    m_speed = speed;
    m_step = step;
    m_place = place;
    refresh();
}

void AxisRow::endHold() {
    m_holdReverse->endHold();
    m_holdForward->endHold();
}

std::optional<bus::HoldToMove> AxisRow::wantedHold(bool reverse) const {
    const JogRange range = jogRange(m_context.state(), m_context.settings());
    return jog(m_context.state(), m_context.settings(), m_speed == JogSpeed::Fast ? range.cap : range.first,
               m_context.chipReverse(reverse));
}

std::optional<Intent> AxisRow::wantedStep(bool reverse) const {
    const double counts = std::round(m_context.scale().countsOfDistance(m_step));
    if (counts < 1 || counts > static_cast<double>(servo::kPositionRange.max))
        return std::nullopt;
    const auto way = static_cast<std::int32_t>(m_context.chipReverse(reverse) ? -counts : counts);
    const auto hold = wantedHold(reverse);
    return hold ? std::optional<Intent>(intent::MoveBy{{.counts = way}, paceOf(*hold)}) : std::nullopt;
}

QString AxisRow::whyNotHeld(bool reverse) const {
    // Never "busy": a hold in progress must not end because it waits for the answers to its own commands.
    if (const auto hold = wantedHold(reverse))
        return m_context.reasonFor(*hold);
    const QString reason = m_context.reasonFor(IntentKind::Hold);
    return reason.isEmpty() ? texts::refusal(Refusal::ParametersUnknown) : reason;
}

QString AxisRow::whyNotStepped(bool reverse) const {
    if (const QString reason = m_context.reasonNow(IntentKind::Move); !reason.isEmpty())
        return reason;
    const auto wanted = wantedStep(reverse);
    if (!wanted)
        return tr("This step is less than one count of this axis, or beyond its range. Choose another step.");
    const auto steps = plan(*wanted, m_context.state());
    return steps ? QString() : texts::refusal(steps.error());
}

/// Each control says of which axis it is, as that is named now.
void AxisRow::nameControls(const QString& who) {
    m_state->setAccessibleDescription(tr("State of %1").arg(who));
    m_position->setAccessibleDescription(tr("Position of %1").arg(who));
    m_holdReverse->setAccessibleName(tr("Hold to move %1 in reverse").arg(who));
    m_holdForward->setAccessibleName(tr("Hold to move %1 forward").arg(who));
    m_stepReverse->button()->setAccessibleName(tr("Step %1 in reverse").arg(who));
    m_stepForward->button()->setAccessibleName(tr("Step %1 forward").arg(who));
    m_earlier->button()->setAccessibleName(m_earlier->text() + u' ' +
                                           tr("Home %1 one place earlier").arg(who));
}

void AxisRow::refresh() {
    const ModuleState& module = m_context.state();
    const AxisScale scale = m_context.scale();
    const QString who = texts::moduleName(module.info.index);
    look::setText(m_name, who);
    look::setText(m_state, texts::activity(module.activity()));
    m_state->setToolTip(texts::activityMeaning(module, scale));
    const auto position = module.latest ? module.latest->position : std::nullopt;
    const bool old = m_context.age().has_value();
    const texts::Zero zero = module.home.workZero();
    QString where = position ? texts::marked(zero, scale, *position) + u' ' + texts::unitOf(scale) : u"–"_s;
    if (position && old)
        where += u", "_s + texts::age(0, module.positionDoubtful());  // no updates while the age grows
    look::setReadout(m_position, where);
    m_position->setToolTip(texts::zeroInUse(zero));
    look::setOld(m_position, old);
    look::setPossible(m_holdForward, whyNotHeld(false), Common::tr("Moves forward while held, then stops."));
    look::setPossible(m_holdReverse, whyNotHeld(true),
                      Common::tr("Moves in reverse while held, then stops."));
    m_stepForward->setPossible(whyNotStepped(false), tr("Moves forward by the step above, then holds."));
    m_stepReverse->setPossible(whyNotStepped(true), tr("Moves in reverse by the step above, then holds."));
    const auto locked = whyNotEdited(module.rights);
    m_earlier->setPossible(
        locked         ? texts::refusal(*locked)
        : m_place == 0 ? tr("Homing is not set up for this axis. Set it up on its Homing page.")
        : m_place == 1 ? tr("Home all starts with this axis.")
                       : QString(),
        tr("Home all homes this axis as number %1. Click to move it one place earlier. Nothing moves.")
            .arg(m_place));
    const QString place = m_place > 0 ? tr("Home: %1.").arg(m_place) : tr("Home: –");
    m_earlier->setText(place);
    if (std::exchange(m_named, who + place) != who + place)
        nameControls(who);
}

void AxisRow::step(bool reverse) {
    if (const auto wanted = wantedStep(reverse))
        m_context.ask(*wanted);
}

}  // namespace nmc
