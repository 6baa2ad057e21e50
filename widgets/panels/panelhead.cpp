// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/panelhead.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "widgets/common/glyphs.h"
#include "widgets/common/homewords.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

PanelHead::PanelHead(Drive drive, QWidget* parent)
    : QFrame(parent),
      m_drive(drive),
      m_glyph(new GlyphLabel(this)),
      m_name(new QLabel(this)),
      m_type(look::newMutedLabel({}, this)),
      m_state(new QLabel(this)),
      m_meaning(look::newMutedLabel({}, this)),
      m_position(new QLabel(this)),
      m_positionUnit(look::newMutedLabel({}, this)),
      m_otherPosition(look::newMutedLabel({}, this)),
      m_home(look::newMutedLabel({}, this)),
      m_enable(drive == Drive::Stepper
                   ? addButton(u"power"_s, tr("&Enable amplifier"), u"enableButton"_s,
                               tr("Enable the amplifier of this module"), intent::Enable{})
                   : addButton(u"power"_s, tr("&Enable servo"), u"enableButton"_s,
                               tr("Enable the servo of this module"), intent::Enable{})),
      m_stopSmoothly(addButton(u"player-stop"_s, tr("&Stop"), u"stopSmoothlyButton"_s,
                               tr("Stop this module smoothly"), intent::StopSmoothly{})),
      m_stopAbruptly(addButton(u"player-stop"_s, tr("Stop a&bruptly"), u"stopAbruptlyButton"_s,
                               tr("Stop this module abruptly"), intent::StopAbruptly{})),
      m_stopHere(addButton(u"player-stop"_s, tr("Stop here"), u"stopHereButton"_s,
                           tr("Stop this module at its present position"), intent::StopHere{})),
      m_motorOff(addButton(u"bolt"_s, tr("&Motor off"), u"motorOffButton"_s, tr("Switch this motor off"),
                           intent::MotorOff{})) {
    look::name(this, named(u"panelHead"_s), tr("State of the selected module"));
    m_name->setObjectName(named(u"moduleName"_s));
    m_type->setObjectName(named(u"moduleType"_s));
    m_state->setObjectName(named(u"stateLabel"_s));
    m_position->setObjectName(named(u"positionLabel"_s));
    QFont large = look::scaled(font(), 1.5);
    large.setBold(true);
    m_state->setFont(large);
    m_glyph->setFont(look::scaled(font(), 1.7));
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_position->setFont(look::tabular(look::scaled(font(), 2.8)));
    m_position->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_positionUnit->setObjectName(named(u"positionUnit"_s));
    m_otherPosition->setObjectName(named(u"otherPosition"_s));
    m_otherPosition->setFont(look::tabular(font()));
    m_home->setObjectName(named(u"homeState"_s));
    m_meaning->setObjectName(named(u"stateMeaning"_s));
    m_meaning->setWordWrap(true);

    m_stopHere->setVisible(m_drive == Drive::Servo);
    m_stopHere->setShortcut(Qt::CTRL | Qt::Key_U);

    const int unit = look::gridUnit(this);
    auto* who = new QHBoxLayout;
    who->addWidget(m_name);
    who->addSpacing(unit / 2);
    who->addWidget(m_type);
    who->addStretch(1);
    auto* what = new QHBoxLayout;
    what->addWidget(m_glyph);
    what->addSpacing(unit / 2);
    what->addWidget(m_state);
    what->addStretch(1);
    what->addWidget(m_home, 0, Qt::AlignBottom);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addWidget(m_enable);
    buttons->addSpacing(unit);
    buttons->addWidget(m_stopSmoothly);
    buttons->addWidget(m_stopAbruptly);
    buttons->addWidget(m_stopHere);
    buttons->addSpacing(unit);
    buttons->addWidget(m_motorOff);
    buttons->addStretch(1);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit / 2, unit, unit / 2);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 2);
    grid->addLayout(who, 0, 0);
    grid->addLayout(what, 1, 0);
    grid->addWidget(m_position, 0, 1, 2, 1, Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(m_positionUnit, 0, 2, 2, 1, Qt::AlignVCenter);
    grid->addWidget(m_meaning, 2, 0);
    grid->addWidget(m_otherPosition, 2, 1, 1, 2, Qt::AlignRight);
    grid->addLayout(buttons, 3, 0, 1, 3);
    grid->setColumnStretch(0, 1);
}

QString PanelHead::named(const QString& name) const {
    return m_drive == Drive::Servo ? name : u"step"_s + name[0].toUpper() + name.mid(1);
}

QPushButton* PanelHead::addButton(const QString& icon, const QString& text, const QString& objectName,
                                  const QString& accessibleName, Intent intent) {
    auto* button = new QPushButton(icons::tinted(icon), text, this);
    look::name(button, named(objectName), accessibleName);
    connect(button, &QPushButton::clicked, this, [this, intent] { emit intentRequested(intent); });
    return button;
}

void PanelHead::showPosition(const PanelView& view) {
    const AxisScale scale = view.scale();
    const std::optional<StatusReport>& latest = view.module.latest;
    const bool known = latest.has_value() && latest->position.has_value();
    const bool old = view.age.has_value();
    const QString unit = texts::unitOf(scale);
    const QString number = !known           ? u"–"_s
                           : scale.native() ? texts::grouped(*latest->position)
                                            : texts::fixedPosition(scale, *latest->position);
    look::setText(m_position, number);
    m_position->setProperty("counts", known ? QVariant(*latest->position) : QVariant());
    m_position->setAccessibleName(known ? tr("Position %1 %2").arg(number, unit) : tr("Position unknown"));
    QFont font = m_position->font();
    if (font.strikeOut() != old) {
        font.setStrikeOut(old);
        m_position->setFont(font);
        m_position->setForegroundRole(old ? QPalette::PlaceholderText : QPalette::WindowText);
    }
    const QString ageText = old && *view.age >= 0.1
                                ? tr("%1 s old").arg(texts::readout(std::floor(*view.age * 10) / 10, 3))
                                : tr("out of date");
    look::setText(m_positionUnit, old ? unit + u", "_s + ageText : unit);
    look::setText(m_otherPosition, known ? texts::otherPosition(scale, *latest->position) : QString());
}

void PanelHead::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    m_module = module;
    m_connected = view.connected;
    m_on = module.driveOn() && (module.isStepper() || module.amplifierEnabled);
    const Activity activity = module.activity();
    look::setText(m_name, texts::moduleName(module.info.index));
    look::setText(
        m_type,
        tr("%1, address %2").arg(texts::moduleType(module.info.identity)).arg(module.info.address.value()));
    look::setText(m_state, texts::activity(activity));
    look::setText(m_meaning, texts::activityMeaning(activity));
    m_glyph->showActivity(activity);
    m_glyph->setToolTip(texts::activityMeaning(activity));
    showPosition(view);
    look::setText(m_home, texts::home(module.home, view.scale()));
    m_home->setToolTip(texts::homeMeaning(module, view.scale()));
    refresh();
}

void PanelHead::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void PanelHead::refresh() {
    const auto reason = [this](Request request) {
        const std::optional<Refusal> refusal =
            m_connected && m_module ? whyNot(request, *m_module) : std::optional(Refusal::NotConnected);
        return refusal.has_value() ? texts::refusal(*refusal) : QString();
    };
    const QString enable = !m_on                       ? reason(Request::Enable)
                           : m_drive == Drive::Stepper ? tr("The amplifier is on already.")
                                                       : tr("The servo is on already.");
    look::setPossible(m_enable, enable.isEmpty() && m_busy ? tr("Waiting for the module's answer.") : enable,
                      tr("Switches the amplifier on and holds the motor where it is."));
    const QString stop = reason(Request::StopMotion);
    look::setPossible(m_stopSmoothly, stop, tr("Slows down at the acceleration in force, then holds."));
    look::setPossible(m_stopAbruptly, stop, tr("Stops at once, then holds."));
    look::setPossible(m_stopHere, reason(Request::StopHere),
                      tr("Jumps without a profile to the position it has at this moment, then holds there "
                         "(Ctrl+U)."));
    look::setPossible(
        m_motorOff, reason(Request::MotorOff),
        m_drive == Drive::Stepper
            ? tr("Stops at once and switches the amplifier off: the motor is free to turn, and a load may "
                 "fall.")
            : tr("Switches servo and amplifier off: the motor is free to turn, and a load may fall."));
}

}  // namespace nmc
