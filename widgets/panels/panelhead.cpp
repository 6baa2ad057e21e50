// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/panelhead.h"

#include <QGridLayout>
#include <QLabel>
#include <QStyle>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/common/workwords.h"
#include "widgets/panels/command.h"
#include "widgets/panels/limitstopbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
// Widths, in heights of a text line, from which the position is beside the state, and buttons have icons.
constexpr int kRoomForPosition = 34;
constexpr int kRoomy = 46;
}  // namespace

PanelHead::PanelHead(ModuleContext& context, QWidget* parent)
    : QFrame(parent),
      m_context(context),
      m_glyph(new GlyphLabel(this)),
      m_name(new QLabel(this)),
      m_type(look::newMutedLabel({}, this, context.named(u"moduleType"_s))),
      m_state(new QLabel(this)),
      m_meaning(new ElidedLabel(1, this)),
      m_procedure(new QLabel(this)),
      m_position(new QLabel(this)),
      m_positionUnit(look::newMutedLabel({}, this, context.named(u"positionUnit"_s))),
      m_otherPosition(look::newMutedLabel({}, this, context.named(u"otherPosition"_s))),
      m_work(new ElidedLabel(1, this)),
      m_velocity(new QLabel(this)),
      m_home(new ElidedLabel(1, this)),
      m_current(new QLabel(this)) {
    look::name(this, m_context.named(u"panelHead"_s), Common::tr("State of the selected module"));
    m_name->setObjectName(m_context.named(u"moduleName"_s));
    m_state->setObjectName(m_context.named(u"stateLabel"_s));
    m_meaning->setObjectName(m_context.named(u"stateMeaning"_s));
    look::nameText(m_procedure, m_context.named(u"procedureLabel"_s), tr("Task running on this module"));
    m_position->setObjectName(m_context.named(u"positionLabel"_s));
    m_work->setObjectName(m_context.named(u"headWork"_s));
    look::nameText(m_velocity, m_context.named(u"velocityLabel"_s), tr("Measured velocity"));
    m_velocity->setToolTip(tr("Velocity measured from positions over 0.2 s."));
    m_home->setObjectName(m_context.named(u"homeState"_s));
    look::nameText(m_current, m_context.named(u"currentLabel"_s),
                   isServo() ? Common::tr("Motor current") : Common::tr("A/D input"));
    const bool servo = isServo();
    m_enable = servo ? addCommand(u"power"_s, tr("&Enable servo"), u"enableButton"_s,
                                  tr("Enable servo of this module"), intent::Enable{})
                     : addCommand(u"power"_s, tr("&Enable amplifier"), u"enableButton"_s,
                                  tr("Enable amplifier of this module"), intent::Enable{});
    m_stopSmoothly = addCommand(u"player-stop"_s, tr("&Stop"), u"stopSmoothlyButton"_s,
                                tr("Stop this module smoothly"), intent::StopSmoothly{});
    m_stopAbruptly = addCommand(u"player-stop"_s, tr("Stop a&bruptly"), u"stopAbruptlyButton"_s,
                                tr("Stop abruptly: this module"), intent::StopAbruptly{});
    if (servo)
        m_stopHere = addCommand(u"player-stop"_s, tr("Stop here"), u"stopHereButton"_s,
                                tr("Stop here: hold this module at its present position"), intent::StopHere{},
                                Qt::CTRL | Qt::Key_U);
    m_motorOff = addCommand(u"bolt"_s, tr("&Motor off"), u"motorOffButton"_s,
                            Common::tr("Motor off: this module"), intent::MotorOff{});
    build();
    m_context.whenSeen(this, [this] { refresh(); });
}

void PanelHead::build() {
    m_state->setFont(look::scaled(font(), 1.5));
    m_glyph->setFont(look::scaled(font(), 1.7));
    for (QLabel* label : {m_state, m_name, m_procedure})
        form::setBold(label);
    m_position->setFont(look::tabular(look::scaled(font(), 2.6)));
    m_velocity->setFont(look::tabular(look::scaled(font(), 1.5)));
    m_otherPosition->setFont(look::tabular(font()));
    m_current->setFont(look::tabular(font()));
    for (QLabel* label : {m_position, m_velocity, m_otherPosition})
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

    m_travel = new QLabel(this);
    look::nameText(m_travel, m_context.named(u"headTravel"_s), tr("Travel limits"));
    // If there is little room, these shrink and their tool tips show the full text, so that the window does
    // not become wider.
    for (QLabel* words : {m_home, m_travel})
        words->setMinimumWidth(1);
    if (isServo()) {
        m_limitStop = new QLabel(this);
        look::nameText(m_limitStop, u"headLimitStop"_s, Common::tr("Limit stop"));
    }
    m_limits[0] = newSign(u"headLimit1"_s, isServo() ? Common::tr("Limit switch 1.")
                                                     : tr("Limit switch 1: high blocks the way to it."));
    m_limits[1] = newSign(u"headLimit2"_s, isServo() ? Common::tr("Limit switch 2.")
                                                     : tr("Limit switch 2: high blocks the way to it."));
    m_power = newSign(u"headPower"_s, tr("Motor power as sensed by the module."));
    arrange(false);
}

void PanelHead::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    const int lines = width() / fontMetrics().height();
    if (const bool narrow = lines < kRoomForPosition; narrow != m_narrow)
        arrange(narrow);
    // No icons if the words need the room, as they do in German.
    const int icon = lines < kRoomy ? 0 : style()->pixelMetric(QStyle::PM_ButtonIconSize);
    for (const Command* command : {m_enable, m_stopSmoothly, m_stopAbruptly, m_stopHere, m_motorOff})
        if (command != nullptr)
            command->button()->setIconSize({icon, icon});
}

QHBoxLayout* PanelHead::row(std::initializer_list<QWidget*> widgets) const {
    auto* row = new QHBoxLayout;
    row->setSpacing(look::gridUnit(this) / 2);
    for (QWidget* widget : widgets)
        if (widget != nullptr)
            row->addWidget(widget);
    return row;
}

QHBoxLayout* PanelHead::signs() const {
    auto* signs = new QHBoxLayout;
    signs->setSpacing(look::gridUnit(this) / 2);
    for (const Sign& sign : {m_limits[0], m_limits[1], m_power}) {
        signs->addWidget(sign.glyph);
        signs->addWidget(sign.word);
        signs->addSpacing(look::gridUnit(this) / 2);
    }
    return signs;
}

/// Arranges everything side by side, or one below the other if there is little room.
void PanelHead::arrange(bool narrow) {
    m_narrow = narrow;
    delete layout();
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit / 2, unit, unit / 2);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(narrow ? unit / 3 : unit / 2);
    m_type->setVisible(!narrow);
    QHBoxLayout* who = row({m_name, m_type});
    who->addStretch(1);
    who->addWidget(m_procedure);
    grid->addLayout(who, 0, 0);
    QHBoxLayout* what = row({m_glyph, m_state});
    if (narrow)
        arrangeNarrow(*grid, what);
    else
        arrangeWide(*grid, what);
    grid->setColumnStretch(0, 1);
}

void PanelHead::arrangeWide(QGridLayout& grid, QHBoxLayout* what) {
    const int unit = look::gridUnit(this);
    what->addSpacing(unit / 2);
    what->addWidget(m_meaning, 1, Qt::AlignVCenter);
    QHBoxLayout* all = signs();
    all->addWidget(m_current);
    all->addSpacing(unit);
    all->addWidget(m_home, 1);
    all->addWidget(m_travel);
    if (m_limitStop != nullptr)
        all->addWidget(m_limitStop);
    QHBoxLayout* buttons = row({m_enable->button()});
    buttons->addSpacing(unit);
    buttons->addLayout(row({m_stopSmoothly->button(), m_stopAbruptly->button(),
                            m_stopHere != nullptr ? m_stopHere->button() : nullptr}));
    buttons->addSpacing(unit);
    buttons->addWidget(m_motorOff->button());
    buttons->addWidget(m_work, 1);
    m_work->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    buttons->addWidget(m_otherPosition);
    grid.addLayout(what, 1, 0);
    grid.addLayout(all, 2, 0);
    grid.addLayout(buttons, 3, 0, 1, 3);
    grid.addWidget(m_position, 0, 1, 2, 1, Qt::AlignRight | Qt::AlignVCenter);
    grid.addWidget(m_positionUnit, 0, 2, 2, 1, Qt::AlignVCenter);
    grid.addWidget(m_velocity, 2, 1, 1, 2, Qt::AlignRight | Qt::AlignVCenter);
}

void PanelHead::arrangeNarrow(QGridLayout& grid, QHBoxLayout* what) {
    what->addStretch(1);
    QHBoxLayout* where = row({m_otherPosition, m_work});
    m_work->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    where->addStretch(1);
    where->addWidget(m_position);
    where->addWidget(m_positionUnit);
    QHBoxLayout* more = row({m_current});
    more->addWidget(m_home, 1);
    more->addWidget(m_travel);
    if (m_limitStop != nullptr)
        more->addWidget(m_limitStop);
    auto* all = new FlowLayout(look::gridUnit(this));
    for (const Sign& sign : {m_limits[0], m_limits[1], m_power})
        all->addLayout(row({sign.glyph, sign.word}));
    auto* buttons = new FlowLayout(look::gridUnit(this) / 2);
    for (const Command* command : {m_enable, m_stopSmoothly, m_motorOff, m_stopAbruptly, m_stopHere})
        if (command != nullptr)
            buttons->addWidget(command->button());
    grid.addLayout(what, 1, 0);
    grid.addWidget(m_meaning, 2, 0);
    grid.addLayout(where, 3, 0);
    grid.addWidget(m_velocity, 4, 0, Qt::AlignRight);
    grid.addLayout(all, 5, 0);
    grid.addLayout(more, 6, 0);
    grid.addLayout(buttons, 7, 0);
}

Command* PanelHead::addCommand(const QString& icon, const QString& text, const QString& objectName,
                               const QString& accessibleName, const Intent& intent, const QKeySequence& key) {
    return new Command({m_context.named(objectName), icon, text, accessibleName, key}, this,
                       [this, intent] { m_context.ask(intent); });
}

PanelHead::Sign PanelHead::newSign(const QString& objectName, const QString& meaning) {
    Sign sign{new GlyphLabel(this), new QLabel(this)};
    look::nameText(sign.word, m_context.named(objectName), meaning);
    sign.glyph->setToolTip(meaning);
    sign.word->setToolTip(meaning);
    return sign;
}

void PanelHead::refresh() {
    const ModuleState& module = m_context.state();
    const Activity activity = module.activity();
    look::setText(m_name, texts::moduleName(module.info.index));
    look::setText(m_type, Common::tr("%1, address %2")
                              .arg(texts::moduleType(module.info.identity))
                              .arg(module.info.address.value()));
    const auto procedure = m_context.runningProcedure();
    const bool driven = activity == Activity::Holding && procedure && movesAround(procedure->kind);
    look::setText(m_state, driven ? tr("Driven by a test") : texts::activity(activity));
    look::setText(m_meaning, module.lookedFor ? tr("Looking for modules… This is the last known state.")
                             : driven ? tr("The test moves the motor around the position that it held.")
                                      : texts::activityMeaning(module, m_context.scale()));
    look::setText(m_procedure, procedure ? u"▶ "_s + texts::procedureStage(*procedure) : QString());
    m_glyph->showActivity(activity);
    m_glyph->setToolTip(texts::activityMeaning(activity, module.info.identity.type));
    refreshPosition();
    refreshSigns();
    refreshCommands();
}

void PanelHead::refreshPosition() {
    const ModuleState& module = m_context.state();
    const AxisScale scale = m_context.scale();
    const StatusReport report = module.latest.value_or(StatusReport{});
    const std::optional<std::int32_t>& position = report.position;
    const std::optional<double> age = m_context.age();
    const QString unit = texts::unitOf(scale);
    const texts::Zero zero = module.home.workZero();
    const auto shown = position ? countedFrom(zero, *position) : std::nullopt;
    const QString number = !shown           ? u"–"_s
                           : scale.native() ? texts::grouped(static_cast<qint64>(*shown))
                                            : texts::fixedPosition(scale, *shown);
    look::setReadout(m_position, number);
    const QString unitAndAge = age ? unit + u", "_s + texts::age(*age, module.positionDoubtful()) : unit;
    const QString from = zero ? texts::from(*zero) : QString();
    m_position->setAccessibleName(!shown ? tr("Position unknown")
                                         : tr("Position %1 %2").arg(number, unitAndAge) +
                                               (zero ? u", "_s + from : QString()));
    look::setOld(m_position, age.has_value());
    look::setText(m_positionUnit, unitAndAge);
    look::setReadout(m_otherPosition, !position ? QString()
                                      : zero    ? tr("counter: %1").arg(texts::position(scale, *position))
                                                : texts::otherPosition(scale, *position));
    look::setText(m_work, !zero          ? QString()
                          : zero->counts ? u"◇ "_s + from
                                         : u"◇ "_s + tr("%1: not known").arg(from));
    m_work->setToolTip(texts::zeroInUse(zero));
    const auto velocity = age ? std::nullopt : module.speed.perSecond();
    look::setReadout(m_velocity, velocity ? texts::measuredVelocity(scale, *velocity) : u"–"_s);
}

void PanelHead::refreshSigns() {
    const ModuleState& module = m_context.state();
    const auto& latest = module.latest;
    std::array<std::optional<bool>, 2> limits;
    std::optional<bool> power;
    if (latest && isServo()) {
        const servo::StatusByte status = latest->servoStatus();
        const servo::IoControl io = module.io.value_or(servo::IoControl{});
        // The level of an output is no limit, nor is that of a pin that may be one.
        const bool known = module.limitPinsKnown();
        limits = {known && io.limit1IsInput ? std::optional(status.limit1()) : std::nullopt,
                  known && io.limit2IsInput ? std::optional(status.limit2()) : std::nullopt};
        power = status.powerOn();
    } else if (latest) {
        if (latest->aux)
            limits = {(*latest->aux & 0x08U) != 0, (*latest->aux & 0x10U) != 0};  // DS-S 5.2, inputs byte
        power = latest->stepperStatus().powerOn();
    }
    for (std::size_t i = 0; i < limits.size(); ++i) {
        m_limits[i].glyph->showBit(limits[i]);
        look::setText(m_limits[i].word, (!limits[i]   ? tr("Limit %1 –")
                                         : *limits[i] ? tr("Limit %1 high")
                                                      : tr("Limit %1 low"))
                                            .arg(i + 1));
    }
    m_power.glyph->showBit(power);
    look::setText(m_power.word, !power ? tr("Power –") : *power ? tr("Power") : tr("No power"));
    QString current;
    if (latest && latest->analog)
        current = texts::analog(m_context.settings().analog, *latest->analog);
    if (isServo() && module.currentWasLimited())
        current = tr("Current was limited: %1").arg(current);
    else if (!current.isEmpty())
        current = isServo() ? tr("Current %1").arg(current) : Common::tr("A/D %1").arg(current);
    look::setReadout(m_current, current);
    const auto& home = module.home.place();
    look::setText(m_home, texts::home(home, module.home.workZero(), m_context.scale()));
    m_home->setToolTip(
        texts::homeMeaning(home, module.home.workZero(), module.latestTime, m_context.scale()));
    look::setText(m_travel, texts::travelSign(module, m_context.scale()));
    m_travel->setToolTip(texts::travelState(module, m_context.scale()));
    if (m_limitStop != nullptr) {
        const HomeWatch::State watch = module.homing.state();
        const bool stops = module.homing.stops() && !LimitStopBox::isReplaced(m_context);
        look::setText(m_limitStop, !stops                               ? QString()
                                   : watch == HomeWatch::State::Armed   ? tr("● Limit stop armed")
                                   : watch == HomeWatch::State::Tripped ? tr("▲ Limit stop tripped")
                                                                        : QString());
    }
}

void PanelHead::refreshCommands() {
    const ModuleState& module = m_context.state();
    const bool on = module.driveOn() && (module.isStepper() || module.amplifierEnabled == true);
    m_enable->setPossible(
        !on         ? m_context.reasonNow(IntentKind::Enable)
        : isServo() ? tr("The servo is already on.")
                    : tr("The amplifier is already on."),
        isServo()
            ? tr("Switches the amplifier on, holds the motor in place and clears the sticky bits: the position error bit is set while the servo is off.")
            : tr("Switches the amplifier on and holds the motor in place."));
    const QString stop = m_context.reasonFor(IntentKind::StopMotion);
    m_stopSmoothly->setPossible(stop, tr("Slows down with the present acceleration, then holds."));
    m_stopAbruptly->setPossible(stop, tr("Stops at once, then holds."));
    if (m_stopHere != nullptr)
        m_stopHere->setPossible(
            m_context.reasonFor(IntentKind::StopHere),
            tr("In motion, stops at once, as Stop abruptly does. At rest, holds the position that the motor has at this moment, without a profile."));
    m_motorOff->setPossible(
        m_context.reasonFor(IntentKind::MotorOff),
        isServo()
            ? Common::tr("Switches servo and amplifier off: the motor is free to turn, and a load may fall.")
            : tr("Stops at once and switches the amplifier off: the motor is free to turn, and a load may fall."));
}

}  // namespace nmc
