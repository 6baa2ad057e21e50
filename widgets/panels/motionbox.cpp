// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/motionbox.h"

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <cmath>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/words.h"
#include "widgets/panels/holdbutton.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
// Counts per tick: about 1950, 980 and 490 counts/s at the fastest servo rate; a slow turn of a common
// encoder.
constexpr double kFirstVelocity = 1.0;
constexpr double kFirstRunVelocity = 0.5;
constexpr double kFirstHoldVelocity = 0.25;
constexpr double kFirstAcceleration = 0.002;
constexpr int kVelocityDecimals = 4;
constexpr int kAccelerationDecimals = 5;
/// 16.16 fixed point (DS-V 4.4).
constexpr double kFixedPoint = 65536.0;
constexpr double kLargest = 32767.0;
constexpr double kSmallest = 1.0 / kFixedPoint;

std::uint32_t toFixed(double value) {
    return static_cast<std::uint32_t>(std::llround(value * kFixedPoint));
}
}  // namespace

MotionBox::MotionBox(QWidget* parent)
    : QGroupBox(tr("Motion"), parent),
      m_whyNot([](Request) { return std::optional(Refusal::NotConnected); }) {
    look::name(this, u"motionBox"_s, tr("Motion"));
    build();
    connectControls();
    resetSpeeds();
}

MotionBox::Quantity MotionBox::addQuantity(QGridLayout* grid, int line, const QString& label,
                                           const QString& objectName, const QString& accessibleName,
                                           bool acceleration) {
    Quantity quantity;
    quantity.acceleration = acceleration;
    quantity.field = new NumberField(acceleration ? kAccelerationDecimals : kVelocityDecimals, this);
    const QString unit = acceleration ? texts::unitAcceleration() : texts::unitVelocity();
    look::name(quantity.field, objectName, accessibleName);
    quantity.field->setWords(accessibleName, unit);
    quantity.field->setRange(kSmallest, kLargest);
    quantity.field->setSingleStep(acceleration ? 0.0005 : 0.05);
    quantity.field->setMeaning(
        acceleration ? tr("How fast the velocity changes. More than 0 to %1 %2.").arg(kLargest).arg(unit)
                     : tr("How fast the motor turns. More than 0 to %1 %2.").arg(kLargest).arg(unit));
    quantity.perSecond = look::newMutedLabel({}, this);
    quantity.perSecond->setObjectName(objectName + u"PerSecond"_s);
    quantity.perSecond->setFont(look::tabular(font()));
    auto* name = new QLabel(label, this);
    name->setBuddy(quantity.field);
    grid->addWidget(name, line, 0);
    grid->addWidget(quantity.field, line, 1);
    grid->addWidget(new QLabel(unit, this), line, 2);
    grid->addWidget(quantity.perSecond, line, 3);
    connect(quantity.field, &NumberField::edited, this, [this] {
        // What is held was asked for at another speed.
        endHold();
        refresh();
    });
    return quantity;
}

void MotionBox::addTitle(QGridLayout* grid, int line, const QString& text, const QString& remark) {
    auto* title = new QLabel(text, this);
    QFont bold = font();
    bold.setBold(true);
    title->setFont(bold);
    grid->addWidget(title, line, 0);
    auto* explanation = look::newMutedLabel(remark, this);
    grid->addWidget(explanation, line, 1, 1, 4);
}

void MotionBox::build() {
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 2);
    int line = 0;

    addTitle(grid, line++, tr("Go to"), tr("from standstill, with a trapezoidal profile"));
    m_goal = new NumberField(0, this);
    look::name(m_goal, u"goalField"_s, tr("Goal position"));
    m_goal->setRange(static_cast<double>(servo::kPositionRange.min),
                     static_cast<double>(servo::kPositionRange.max));
    m_goal->setWords(tr("The goal position"), texts::unitCounts());
    m_goal->setSingleStep(100);
    m_goal->setMeaning(tr("Where to go, in encoder counts. Enter starts the move."));
    auto* goalLabel = new QLabel(tr("&Position"), this);
    goalLabel->setBuddy(m_goal);
    m_go = new QPushButton(icons::tinted(u"arrow-bar-to-right"_s), tr("&Go"), this);
    look::name(m_go, u"goButton"_s, tr("Go to the position"));
    grid->addWidget(goalLabel, line, 0);
    grid->addWidget(m_goal, line, 1);
    grid->addWidget(new QLabel(texts::unitCounts(), this), line, 2);
    grid->addWidget(m_go, line++, 4);
    m_velocity =
        addQuantity(grid, line++, tr("Ve&locity"), u"velocityField"_s, tr("Velocity of the move"), false);
    m_acceleration =
        addQuantity(grid, line++, tr("Acceleratio&n"), u"accelerationField"_s, tr("Acceleration"), true);
    m_acceleration.field->setMeaning(m_acceleration.field->toolTip() + u"\n"_s +
                                     tr("Used by every kind of motion here, and by a smooth stop."));

    grid->setRowMinimumHeight(line++, unit);
    addTitle(grid, line++, tr("Run"), tr("until it is stopped"));
    m_runVelocity =
        addQuantity(grid, line, tr("Vel&ocity"), u"runVelocityField"_s, tr("Velocity of running"), false);
    m_runReverse = new QPushButton(icons::tinted(u"arrow-left"_s), tr("Run &reverse"), this);
    look::name(m_runReverse, u"runReverseButton"_s, tr("Run in reverse until stopped"));
    m_runForward = new QPushButton(icons::tinted(u"arrow-right"_s), tr("R&un forward"), this);
    look::name(m_runForward, u"runForwardButton"_s, tr("Run forward until stopped"));
    auto* runButtons = new QHBoxLayout;
    runButtons->setSpacing(unit);
    runButtons->addWidget(m_runReverse);
    runButtons->addWidget(m_runForward);
    grid->addLayout(runButtons, line++, 4);

    grid->setRowMinimumHeight(line++, unit);
    addTitle(grid, line++, tr("Hold to move"), tr("moves only while a button, or Space on it, is held"));
    m_holdVelocity =
        addQuantity(grid, line, tr("Velocit&y"), u"holdVelocityField"_s, tr("Velocity while held"), false);
    m_holdReverse = new HoldButton(this);
    m_holdReverse->setIcon(icons::tinted(u"hand-stop"_s));
    m_holdReverse->setText(tr("◂ Hold"));
    look::name(m_holdReverse, u"holdReverseButton"_s, tr("Move in reverse while held"));
    m_holdForward = new HoldButton(this);
    m_holdForward->setIcon(icons::tinted(u"hand-stop"_s));
    m_holdForward->setText(tr("Hold ▸"));
    look::name(m_holdForward, u"holdForwardButton"_s, tr("Move forward while held"));
    auto* holdButtons = new QHBoxLayout;
    holdButtons->setSpacing(unit);
    holdButtons->addWidget(m_holdReverse);
    holdButtons->addWidget(m_holdForward);
    grid->addLayout(holdButtons, line++, 4);

    m_hint = new QLabel(this);
    m_hint->setObjectName(u"motionHint"_s);
    m_hint->setWordWrap(true);
    m_hint->setTextFormat(Qt::PlainText);
    grid->addWidget(m_hint, line++, 0, 1, 5);
    grid->setRowStretch(line, 1);
    grid->setColumnStretch(3, 1);
}

void MotionBox::connectControls() {
    connect(m_goal, &NumberField::edited, this, &MotionBox::refresh);
    connect(m_goal, &NumberField::returnPressed, m_go, &QPushButton::click);
    connect(m_go, &QPushButton::clicked, this, &MotionBox::go);
    connect(m_runForward, &QPushButton::clicked, this, [this] { run(false); });
    connect(m_runReverse, &QPushButton::clicked, this, [this] { run(true); });
    connect(m_holdForward, &HoldButton::held, this, [this] { hold(false); });
    connect(m_holdReverse, &HoldButton::held, this, [this] { hold(true); });
    for (HoldButton* button : {m_holdForward, m_holdReverse})
        connect(button, &HoldButton::holdEnded, this, &MotionBox::holdReleased);
}

std::array<NumberField*, 5> MotionBox::fields() const {
    return {m_goal, m_velocity.field, m_acceleration.field, m_runVelocity.field, m_holdVelocity.field};
}

void MotionBox::resetSpeeds() {
    endHold();
    m_drafts.clear();
    m_velocity.field->showValue(kFirstVelocity);
    m_acceleration.field->showValue(kFirstAcceleration);
    m_runVelocity.field->showValue(kFirstRunVelocity);
    m_holdVelocity.field->showValue(kFirstHoldVelocity);
    m_goal->showValue(0);
    refresh();
}

void MotionBox::endHold() {
    m_holdForward->endHold();
    m_holdReverse->endHold();
}

void MotionBox::setHoldInterval(int milliseconds) {
    m_holdForward->setInterval(milliseconds);
    m_holdReverse->setInterval(milliseconds);
}

void MotionBox::showModule(const ModuleState& module, const WhyNot& whyNot) {
    if (m_module != module.info.index) {
        endHold();
        const std::array<NumberField*, 5> all = fields();
        if (m_module.has_value()) {
            Draft& old = m_drafts[m_module->value()];
            for (std::size_t i = 0; i < all.size(); ++i)
                old.texts[i] = all[i]->text();
        }
        m_module = module.info.index;
        const auto draft = m_drafts.constFind(module.info.index.value());
        const std::array<double, 5> first{0, kFirstVelocity, kFirstAcceleration, kFirstRunVelocity,
                                          kFirstHoldVelocity};
        for (std::size_t i = 0; i < all.size(); ++i) {
            NumberField::Problem problem = NumberField::Problem::None;
            const auto value = draft == m_drafts.constEnd()
                                   ? first[i]
                                   : NumberField::parse(draft->texts[i], false, &problem);
            all[i]->showValue(value.value_or(first[i]));
        }
    }
    m_servoRate = module.gains.has_value() ? qMax<int>(1, module.gains->sr) : 1;
    m_whyNot = whyNot;
    refresh();
}

void MotionBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

QString MotionBox::reasonFor(Request request, std::initializer_list<const NumberField*> fields) const {
    if (const std::optional<Refusal> refusal = m_whyNot(request))
        return texts::refusal(*refusal);
    for (const NumberField* field : fields) {
        if (field->problem() == NumberField::Problem::None)
            continue;
        if (field->problem() == NumberField::Problem::OutOfRange &&
            field->text().trimmed().startsWith(u'0') && field != m_goal)
            return texts::refusal(field == m_acceleration.field ? Refusal::NoAcceleration
                                                                : Refusal::NoVelocity);
        return field->problemText();
    }
    return {};
}

void MotionBox::refreshConversions() {
    for (const Quantity& quantity : {m_velocity, m_acceleration, m_runVelocity, m_holdVelocity}) {
        const std::optional<double> value = quantity.field->value();
        QString text = u"–"_s;
        if (value.has_value())
            text = u"= "_s + (quantity.acceleration ? texts::countsPerSecondSquared(*value, m_servoRate)
                                                    : texts::countsPerSecond(*value, m_servoRate));
        look::setText(quantity.perSecond, text);
    }
}

void MotionBox::refresh() {
    refreshConversions();
    const NumberField* acceleration = m_acceleration.field;
    const QString waiting = m_busy ? tr("Waiting for the module's answer.") : QString();
    const auto possible = [&waiting](QWidget* button, const QString& reason, const QString& meaning) {
        look::setPossible(button, reason.isEmpty() ? waiting : reason, meaning);
    };
    possible(m_go, reasonFor(Request::Move, {m_goal, m_velocity.field, acceleration}),
             tr("Starts the move to the position, and holds there."));
    const QString run = reasonFor(Request::Run, {m_runVelocity.field, acceleration});
    possible(m_runForward, run, tr("Runs forward until it is stopped."));
    possible(m_runReverse, run, tr("Runs in reverse until it is stopped."));
    // Not while waiting for an answer: a hold that is under way must not be cut off by its own commands.
    const QString hold = reasonFor(Request::Hold, {m_holdVelocity.field, acceleration});
    look::setPossible(m_holdForward, hold, tr("Moves forward while it is held, then stops."));
    look::setPossible(m_holdReverse, hold, tr("Moves in reverse while it is held, then stops."));

    QString hint;
    for (const NumberField* field : fields())
        if (hint.isEmpty())
            hint = field->problemText();
    look::setText(m_hint, hint);
    m_hint->setVisible(!hint.isEmpty());
}

void MotionBox::go() {
    const auto goal = m_goal->value();
    const auto velocity = m_velocity.field->value();
    const auto acceleration = m_acceleration.field->value();
    if (!m_go->isEnabled() || !goal || !velocity || !acceleration)
        return;
    emit intentRequested(intent::GoTo{Counts(static_cast<std::int32_t>(*goal)),
                                      CountsPerTick(toFixed(*velocity)),
                                      CountsPerTickSquared(toFixed(*acceleration))});
}

void MotionBox::run(bool reverse) {
    const auto velocity = m_runVelocity.field->value();
    const auto acceleration = m_acceleration.field->value();
    if (!velocity || !acceleration)
        return;
    emit intentRequested(intent::RunAtVelocity{CountsPerTick(toFixed(*velocity)),
                                               CountsPerTickSquared(toFixed(*acceleration)), reverse});
}

void MotionBox::hold(bool reverse) {
    const auto velocity = m_holdVelocity.field->value();
    const auto acceleration = m_acceleration.field->value();
    if (!velocity || !acceleration || !m_module.has_value())
        return;
    emit holdRequested({*m_module, CountsPerTick(toFixed(*velocity)),
                        CountsPerTickSquared(toFixed(*acceleration)), reverse});
}

}  // namespace nmc
