// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/motionbox.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <limits>

#include "model/intent/moveforecast.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/homewords.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/quantitygrid.h"
#include "widgets/panels/servodefaults.h"

namespace nmc {

using namespace Qt::StringLiterals;
using quantitygrid::kButtonColumn;

namespace {
enum GoalKind { Absolute, Relative };
constexpr double kMostCounts = std::numeric_limits<std::int32_t>::max();
}  // namespace

MotionBox::MotionBox(QWidget* parent) : QGroupBox(parent) {
    look::name(this, u"motionBox"_s, tr("Motion"));
    build();
    connectControls();
    refresh();
}

QuantityField* MotionBox::addQuantity(QGridLayout* grid, int line, const QString& label,
                                      const QString& objectName, const QString& accessibleName,
                                      double MotionSettings::*part) {
    const bool acceleration = part == &MotionSettings::acceleration;
    const auto kind = acceleration ? QuantityField::Kind::Acceleration : QuantityField::Kind::Velocity;
    auto* field = new QuantityField(kind, this);
    field->setName(objectName, accessibleName);
    field->setQuantity(accessibleName);
    field->setNativeRange(servodefaults::kSmallest, servodefaults::kLargest);
    field->setNativeStep(acceleration ? 0.0005 : 0.05);
    field->setMeaning(acceleration
                          ? tr("How fast the velocity changes. Used by every kind of motion here, and by a "
                               "smooth stop.")
                          : tr("How fast the motor turns."));
    quantitygrid::addRow(grid, line, label, field);
    connect(field, &QuantityField::nativeEdited, this, [this, field, part] { keep(*field, part); });
    return field;
}

void MotionBox::build() {
    QGridLayout* grid = quantitygrid::newGrid(this);
    int line = 0;
    buildMove(grid, line);
    grid->setRowMinimumHeight(line++, look::gridUnit(this));
    buildRun(grid, line);
    m_hint = new ElidedLabel(1, this);
    m_hint->setObjectName(u"motionHint"_s);
    grid->addWidget(m_hint, line++, 0, 1, quantitygrid::kColumns);
}

void MotionBox::buildMove(QGridLayout* grid, int& line) {
    quantitygrid::addTitle(grid, line++, tr("Go to"), tr("from standstill, with a trapezoidal profile"));
    m_goal = new QuantityField(QuantityField::Kind::Position, this);
    m_goal->setName(u"goalField"_s, tr("Goal position"));
    m_goal->setQuantity(tr("The goal position"));
    m_goal->setNativeRange(static_cast<double>(servo::kPositionRange.min),
                           static_cast<double>(servo::kPositionRange.max));
    m_goal->setNativeStep(100);
    m_goal->setMeaning(tr("Where to go. Enter starts the move."));
    quantitygrid::addRow(grid, line, tr("&Position"), m_goal);
    m_goalKind = new QComboBox(this);
    look::name(m_goalKind, u"goalKindBox"_s, tr("Position or distance"));
    m_goalKind->addItem(tr("position"), Absolute);
    m_goalKind->addItem(tr("distance from here"), Relative);
    m_goalKind->setToolTip(
        tr("Whether the number is a position, or a distance from where the motor is now."));
    grid->addWidget(m_goalKind, line++, kButtonColumn);
    m_velocity = addQuantity(grid, line++, tr("Ve&locity"), u"velocityField"_s, tr("Velocity of the move"),
                             &MotionSettings::velocity);
    m_acceleration = addQuantity(grid, line++, tr("Acceleratio&n"), u"accelerationField"_s,
                                 tr("Acceleration"), &MotionSettings::acceleration);
    m_forecast = look::newMutedLabel({}, this);
    m_forecast->setObjectName(u"forecastLabel"_s);
    grid->addWidget(m_forecast, line++, 1, 1, quantitygrid::kColumns - 1);

    const auto newButton = [this](const QString& icon, const QString& text, const QString& objectName,
                                  const QString& name) {
        auto* button = new QPushButton(icons::tinted(icon), text, this);
        look::name(button, objectName, name);
        return button;
    };
    m_zero =
        newButton(u"eraser"_s, tr("&Zero here"), u"zeroHereButton"_s, tr("Make the present position zero"));
    m_goHome = newButton(u"home"_s, tr("Go home"), u"goHomeButton"_s, tr("Go to the home position"));
    m_load = newButton(u"download"_s, tr("Load"), u"loadButton"_s, tr("Load the move, start it later"));
    m_start = newButton(u"player-play"_s, tr("Start"), u"startButton"_s, tr("Start the loaded move"));
    m_go = newButton(u"arrow-bar-to-right"_s, tr("&Go"), u"goButton"_s, tr("Go to the position"));
    m_goHome->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_G);
    m_load->setShortcut(Qt::CTRL | Qt::Key_D);
    m_start->setShortcut(Qt::CTRL | Qt::Key_G);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(look::gridUnit(this));
    buttons->addWidget(m_zero);
    buttons->addWidget(m_goHome);
    buttons->addStretch(1);
    buttons->addWidget(m_load);
    buttons->addWidget(m_start);
    buttons->addWidget(m_go);
    grid->addLayout(buttons, line++, 0, 1, quantitygrid::kColumns);
}

void MotionBox::buildRun(QGridLayout* grid, int& line) {
    quantitygrid::addTitle(grid, line++, tr("Run"),
                           tr("until it is stopped; the velocity may change on the way"));
    m_runVelocity = addQuantity(grid, line, tr("Vel&ocity"), u"runVelocityField"_s, tr("Velocity of running"),
                                &MotionSettings::runVelocity);
    m_runReverse = new QPushButton(icons::tinted(u"arrow-left"_s), tr("Run &reverse"), this);
    look::name(m_runReverse, u"runReverseButton"_s, tr("Run in reverse until stopped"));
    m_runForward = new QPushButton(icons::tinted(u"arrow-right"_s), tr("R&un forward"), this);
    look::name(m_runForward, u"runForwardButton"_s, tr("Run forward until stopped"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(look::gridUnit(this));
    buttons->addWidget(m_runReverse);
    buttons->addWidget(m_runForward);
    grid->addLayout(buttons, line++, kButtonColumn);
}

void MotionBox::connectControls() {
    connect(m_goal, &QuantityField::nativeEdited, this, [this] {
        if (const auto counts = m_goal->native(); counts && m_module)
            m_goals[m_module->info.index.value()] = {*counts, relative()};
        refresh();
    });
    connect(m_goalKind, &QComboBox::currentIndexChanged, this, [this] {
        if (m_module)
            m_goals[m_module->info.index.value()].relative = relative();
        refresh();
    });
    connect(m_goal, &QuantityField::returnPressed, m_go, &QPushButton::click);
    connect(m_go, &QPushButton::clicked, this, [this] { move(false); });
    connect(m_load, &QPushButton::clicked, this, [this] { move(true); });
    connect(m_start, &QPushButton::clicked, this, [this] { emit intentRequested(intent::StartLoaded{}); });
    connect(m_goHome, &QPushButton::clicked, this, &MotionBox::goHome);
    connect(m_zero, &QPushButton::clicked, this, [this] { emit intentRequested(intent::ResetPosition{}); });
    connect(m_runForward, &QPushButton::clicked, this, [this] { run(false); });
    connect(m_runReverse, &QPushButton::clicked, this, [this] { run(true); });
    connect(m_acceleration, &QuantityField::nativeEdited, this, &MotionBox::accelerationEdited);
}

bool MotionBox::relative() const {
    return m_goalKind->currentData().toInt() == Relative;
}

std::optional<CountsPerTickSquared> MotionBox::acceleration() const {
    const auto value = m_acceleration->native();
    return value ? std::optional(CountsPerTickSquared(servodefaults::toFixed(*value))) : std::nullopt;
}

std::optional<CountsPerTick> MotionBox::velocity() const {
    const auto value = m_velocity->native();
    return value ? std::optional(CountsPerTick(servodefaults::toFixed(*value))) : std::nullopt;
}

/// What the user types is kept with the axis; what is no value stays in its field.
void MotionBox::keep(const QuantityField& field, double MotionSettings::*part) {
    const auto typed = field.native();
    if (typed)
        m_settings.motion.*part = *typed;
    refresh();
    if (typed && m_module)
        emit settingsEdited([part, typed](AxisSettings& axis) { axis.motion.*part = *typed; });
}

void MotionBox::forgetGoals() {
    m_goals.clear();
    if (m_module)
        showGoal();
    refresh();
}

void MotionBox::showGoal() {
    const Goal goal = m_goals.value(m_module->info.index.value());
    const QSignalBlocker blocker(m_goalKind);
    m_goalKind->setCurrentIndex(goal.relative ? Relative : Absolute);
    m_goal->showNative(goal.counts);
}

void MotionBox::showModule(const PanelView& view) {
    const bool another = !m_module || m_module->info.index != view.module.info.index;
    const MotionSettings before = servodefaults::motionOf(m_settings);
    m_module = view.module;
    m_settings = view.settings;
    m_connected = view.connected;
    const MotionSettings motion = servodefaults::motionOf(m_settings);
    for (QuantityField* field : {m_goal, m_velocity, m_acceleration, m_runVelocity})
        field->setScale(view.scale());
    if (another) {
        showGoal();
        m_velocity->showNative(motion.velocity);
        m_acceleration->showNative(motion.acceleration);
        m_runVelocity->showNative(motion.runVelocity);
    } else {
        quantitygrid::follow(m_velocity, motion.velocity, before.velocity);
        quantitygrid::follow(m_acceleration, motion.acceleration, before.acceleration);
        quantitygrid::follow(m_runVelocity, motion.runVelocity, before.runVelocity);
    }
    refresh();
}

void MotionBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

QString MotionBox::reasonFor(Request request, std::initializer_list<const QuantityField*> fields) const {
    if (!m_connected || !m_module)
        return texts::refusal(Refusal::NotConnected);
    if (const std::optional<Refusal> refusal = whyNot(request, *m_module))
        return texts::refusal(*refusal);
    for (const QuantityField* field : fields) {
        if (field->problem() == NumberField::Problem::None)
            continue;
        if (field->problem() == NumberField::Problem::OutOfRange &&
            field->text().trimmed().startsWith(u'0') && field != m_goal)
            return texts::refusal(field == m_acceleration ? Refusal::NoAcceleration : Refusal::NoVelocity);
        return field->problemText();
    }
    return {};
}

std::optional<intent::GoTo> MotionBox::entered() const {
    const auto goal = m_goal->native();
    const auto velocity = m_velocity->native();
    const auto acceleration = this->acceleration();
    if (!goal || !velocity || !acceleration || !m_module)
        return std::nullopt;
    double counts = *goal;
    if (relative()) {
        if (!m_module->latest || !m_module->latest->position)
            return std::nullopt;
        counts += *m_module->latest->position;
    }
    if (std::abs(counts) > kMostCounts)
        return std::nullopt;
    return intent::GoTo{Counts(static_cast<std::int32_t>(counts)),
                        CountsPerTick(servodefaults::toFixed(*velocity)), *acceleration};
}

void MotionBox::refreshForecast() {
    QString text;
    const auto velocity = m_velocity->native();
    const auto acceleration = m_acceleration->native();
    if (const auto goTo = entered(); goTo && m_module->latest && m_module->latest->position) {
        const AxisScale& scale = m_velocity->scale();
        const double way = static_cast<double>(goTo->position.value()) - *m_module->latest->position;
        const MoveForecast move = forecast(way, *velocity, *acceleration, scale.perSecond());
        const QString seconds = tr("%1 s").arg(texts::readout(move.seconds, 3));
        const QString peak =
            texts::readout(scale.velocity(move.peakVelocity), 3) + u' ' + texts::velocityUnitOf(scale);
        text = move.triangular ? tr("Takes %1, peak %2: too short to reach its velocity").arg(seconds, peak)
                               : tr("Takes %1, peak %2").arg(seconds, peak);
        if (way == 0.0)
            text = tr("It is there already");
    }
    look::setText(m_forecast, text);
}

void MotionBox::refresh() {
    refreshForecast();
    const QString waiting = m_busy ? tr("Waiting for the module's answer.") : QString();
    const auto possible = [&waiting](QWidget* button, const QString& reason, const QString& meaning) {
        look::setPossible(button, reason.isEmpty() ? waiting : reason, meaning);
    };
    QString move = reasonFor(Request::Move, {m_goal, m_velocity, m_acceleration});
    if (move.isEmpty() && !entered())
        move = tr("The goal is beyond the range of positions.");
    possible(m_go, move, tr("Starts the move to the position, and holds there."));
    possible(
        m_load, move,
        tr("Loads the move and does not start it: Start does, or the start of the module's group (Ctrl+D)."));
    possible(m_start, reasonFor(Request::StartLoaded, {}), tr("Starts the move that was loaded (Ctrl+G)."));
    possible(m_goHome, reasonFor(Request::GoHome, {m_velocity, m_acceleration}),
             tr("Goes to home (Ctrl+Shift+G)."));
    possible(m_zero, reasonFor(Request::ResetPosition, {}),
             m_module ? texts::zeroMeaning(*m_module, m_goal->scale()) : QString());
    const QString run = reasonFor(Request::Run, {m_runVelocity, m_acceleration});
    possible(m_runForward, run, tr("Runs forward until it is stopped."));
    possible(m_runReverse, run, tr("Runs in reverse until it is stopped."));

    QString hint;
    for (const QuantityField* field : {m_goal, m_velocity, m_acceleration, m_runVelocity})
        if (hint.isEmpty())
            hint = field->problemText();
    look::setText(m_hint, hint);
}

void MotionBox::move(bool later) {
    const auto goTo = entered();
    if (!m_go->isEnabled() || !goTo)
        return;
    emit intentRequested(later ? Intent(intent::LoadMove{*goTo}) : Intent(*goTo));
}

void MotionBox::goHome() {
    const auto velocity = m_velocity->native();
    const auto acceleration = this->acceleration();
    if (!m_goHome->isEnabled() || !velocity || !acceleration)
        return;
    emit intentRequested(intent::GoHome{CountsPerTick(servodefaults::toFixed(*velocity)), *acceleration});
}

void MotionBox::run(bool reverse) {
    const auto velocity = m_runVelocity->native();
    const auto acceleration = this->acceleration();
    if (!velocity || !acceleration)
        return;
    emit intentRequested(
        intent::RunAtVelocity{CountsPerTick(servodefaults::toFixed(*velocity)), *acceleration, reverse});
}

}  // namespace nmc
