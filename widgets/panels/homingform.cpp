// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/homingform.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QRadioButton>
#include <QSignalBlocker>
#include <utility>

#include "model/intent/homingplan.h"
#include "model/machinefile/machinelayout.h"
#include "model/module/servodefaults.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
using Stop = HomingRecipe::Stop;
constexpr std::array kStops{Stop::Abruptly, Stop::Smoothly, Stop::Off};

constexpr int kFieldDigits = 8;
}  // namespace

HomingForm::HomingForm(ModuleType type, QWidget* parent) : QWidget(parent), m_type(type) {
    look::name(this, named(u"homingForm"_s), tr("Search for home"));
    auto* grid = new FormGrid(this, 4, {.sides = 0, .ends = 0});
    buildConditions(grid);
    buildMotion(grid);
    buildEnd(grid);
    const double slowest = type == ModuleType::Stepper ? 25.0 : servodefaults::kSmallest;
    showChip(type == ModuleType::Stepper ? AxisScale::step({}) : AxisScale::servo({}, 1), {type, 0}, slowest);
    showRecipe(firstRecipe({type, 0}));
}

QString HomingForm::named(const QString& name) const {
    return look::nameFor(m_type, name);
}

QWidget* HomingForm::row(const QList<QWidget*>& widgets) {
    auto* holder = new QWidget(this);
    auto* layout = new FlowLayout(look::gridUnit(this) * 3 / 2, holder);
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
    return holder;
}

QAbstractButton* HomingForm::addBox(const QString& name, const QString& text, Flag flag,
                                    const QString& meaning) {
    auto* box = form::newCheck({.name = named(name), .text = text}, this);
    m_boxes.append({box, flag, meaning});
    connect(box, &QCheckBox::toggled, this, [this, flag](bool on) {
        m_recipe.*flag = on;
        applyEdit();
    });
    return box;
}

void HomingForm::buildConditions(FormGrid* grid) {
    QList<QWidget*> conditions;
    const QString change = tr(
        "Home is where this switch changes. If it is active at the start, the motor first backs off in the other direction.");
    if (m_type == ModuleType::Stepper) {
        conditions << addBox(u"onHomeSwitchBox"_s, Common::tr("Home switch"), &HomingRecipe::onHomeSwitch,
                             change)
                   << addBox(u"onLimit1Box"_s, tr("Limit 1 (forward)"), &HomingRecipe::onLimit1, change)
                   << addBox(u"onLimit2Box"_s, tr("Limit 2 (reverse)"), &HomingRecipe::onLimit2, change);
        grid->addTitled(tr("Home is at"), row(conditions));
        return;
    }
    conditions
        << addBox(u"onLimit1Box"_s, Common::tr("Limit 1"), &HomingRecipe::onLimit1, change)
        << addBox(u"onLimit2Box"_s, Common::tr("Limit 2"), &HomingRecipe::onLimit2, change)
        << addBox(u"onIndexBox"_s, Common::tr("Index"), &HomingRecipe::onIndex,
                  tr("Home is at the encoder's index, which comes once per turn."))
        << addBox(
               u"onPositionErrorBox"_s, Common::tr("Position error"), &HomingRecipe::onPositionError,
               tr("Home is at a hard stop: the motor runs against it until the position error limit switches the servo off. Sticky bits are cleared first. The servo is switched on again only to continue to the index or to home."))
        << addBox(
               u"onCurrentLimitBox"_s, Common::tr("Current limit"), &HomingRecipe::onCurrentLimit,
               tr("Home is at a hard stop: the motor runs against it until the current limit is reached. On its own, it takes effect only at full speed; combined with other conditions, from the start, so the starting current must stay below it. Sticky bits are cleared first."));
    grid->addTitled(tr("Home is at"), row(conditions));
    grid->addTitled(
        QString(),
        addBox(
            u"thenIndexBox"_s, tr("then at the index, going back"), &HomingRecipe::thenIndex,
            tr("The conditions above find the approximate place; a second, slower search finds the index, which is more exact.")));
}

void HomingForm::buildMotion(FormGrid* grid) {
    m_reverse = form::newRadio({.name = named(u"homingReverseButton"_s),
                                .text = tr("Reverse"),
                                .accessible = tr("Reverse: search direction")},
                               this);
    m_forward = form::newRadio({.name = named(u"homingForwardButton"_s),
                                .text = tr("Forward"),
                                .accessible = tr("Forward: search direction")},
                               this);
    auto* directions = new QButtonGroup(this);
    directions->addButton(m_reverse);
    directions->addButton(m_forward);
    connect(m_reverse, &QAbstractButton::toggled, this, [this](bool on) {
        m_recipe.reverse = on != m_reversed;
        applyEdit();
    });
    grid->addTitled(tr("Direction"), row({m_reverse, m_forward}));

    using Kind = QuantityField::Kind;
    addQuantity(grid, Kind::Velocity, u"homingVelocityField"_s, Common::tr("Velocity"),
                &HomingRecipe::velocity,
                tr("Maximum velocity for searching, backing off and going to home."));
    if (m_type != ModuleType::Stepper)
        addQuantity(grid, Kind::Velocity, u"homingIndexVelocityField"_s, tr("Index velocity"),
                    &HomingRecipe::indexVelocity,
                    tr("Velocity of the second search, for the index. Slower is more exact."));
    addQuantity(grid, Kind::Acceleration, u"homingAccelerationField"_s, Common::tr("Acceleration"),
                &HomingRecipe::acceleration, tr("Also used for smooth stops."));
    addQuantity(grid, Kind::Distance, u"homingTravelField"_s, tr("Search distance"),
                &HomingRecipe::travelLimit,
                tr("A search, or backing off, stops and fails after this distance."));
    m_timeLimit = form::newNumber({.name = named(u"homingTimeField"_s),
                                   .accessible = tr("Time limit of a search"),
                                   .words = Common::tr("Time limit"),
                                   .unit = u"s"_s,
                                   .min = 0.1,
                                   .max = layout::kSeconds.max,
                                   .decimals = 1,
                                   .digits = kFieldDigits},
                                  this);
    grid->addRow(Common::tr("Time limit"), m_timeLimit, {new QLabel(u"s"_s, this)});
    connect(m_timeLimit, &NumberField::edited, this, [this] {
        m_recipe.timeLimit = m_timeLimit->value().value_or(m_recipe.timeLimit);
        applyEdit();
    });
}

void HomingForm::addQuantity(FormGrid* grid, QuantityField::Kind kind, const QString& name,
                             const QString& text, Number value, const QString& meaning) {
    auto* field = form::newQuantity({.kind = kind,
                                     .name = named(name),
                                     .accessible = tr("%1 of the search for home").arg(text),
                                     .words = text,
                                     .digits = kFieldDigits,
                                     .meaning = meaning},
                                    this);
    m_quantities.append({field, value, grid->addRow(text, field), meaning});
    connect(field, &QuantityField::nativeEdited, this, [this, field, value] {
        m_recipe.*value = field->native().value_or(m_recipe.*value);
        applyEdit();
    });
}

void HomingForm::buildEnd(FormGrid* grid) {
    const std::array names{u"homingAbruptlyButton"_s, u"homingSmoothlyButton"_s, u"homingMotorOffButton"_s};
    const std::array texts{Common::tr("Abruptly"), Common::tr("Smoothly"), Common::tr("Motor off")};
    const std::array accessible{tr("Abruptly: stop at home"), tr("Smoothly: stop at home"),
                                tr("Motor off at home")};
    auto* group = new QButtonGroup(this);
    QList<QWidget*> stops;
    for (std::size_t i = 0; i < kStops.size(); ++i) {
        m_stops[i] = form::newRadio({named(names[i]), texts[i], accessible[i]}, this);
        group->addButton(m_stops[i]);
        stops << m_stops[i];
        connect(m_stops[i], &QAbstractButton::toggled, this, [this, i](bool on) {
            if (!on)
                return;
            m_recipe.stop = kStops[i];
            applyEdit();
        });
    }
    grid->addTitled(tr("Stop there"), row(stops));
    grid->addTitled(
        tr("Then"),
        row({addBox(
                 u"goToHomeBox"_s, tr("Go to home"), &HomingRecipe::goToHome,
                 tr("The motor stops past home; this moves it back. If the search has switched the servo or amplifier off, it is switched on again.")),
             addBox(u"makeZeroBox"_s, tr("Set position to 0"), &HomingRecipe::makeZero,
                    tr("Once the motor is at home, its position becomes 0."))}));
}

void HomingForm::showRecipe(const HomingRecipe& recipe) {
    m_recipe = recipe;
    for (const Quantity& quantity : m_quantities)
        quantity.field->showNative(m_recipe.*quantity.value);
    m_timeLimit->showValue(m_recipe.timeLimit);
    refresh();
}

void HomingForm::showChip(const AxisScale& scale, const ModuleIdentity& chip, double speedUnit) {
    m_version = chip.version;
    m_reversed = scale.reversed();
    for (const Box& box : m_boxes) {
        if (m_type == ModuleType::Stepper && box.flag == &HomingRecipe::onLimit1)
            box.button->setText(m_reversed ? tr("Limit 1 (reverse)") : tr("Limit 1 (forward)"));
        else if (m_type == ModuleType::Stepper && box.flag == &HomingRecipe::onLimit2)
            box.button->setText(m_reversed ? tr("Limit 2 (forward)") : tr("Limit 2 (reverse)"));
        else
            continue;
        box.button->setAccessibleName(box.button->text());
    }
    for (const Quantity& quantity : m_quantities) {
        const bool velocity =
            quantity.value == &HomingRecipe::velocity || quantity.value == &HomingRecipe::indexVelocity;
        double most = velocity ? servodefaults::fastest(chip) : servodefaults::kLargest;
        double least = servodefaults::kSmallest;
        if (quantity.value == &HomingRecipe::travelLimit) {
            least = 1.0;
            most = layout::kDistance.max;
        } else if (m_type == ModuleType::Stepper) {
            // A request below the slowest speed of the chip would run faster than requested.
            least = velocity ? speedUnit : 1.0;
            most = velocity ? 250.0 * speedUnit : layout::kMaxStepAcceleration;
        }
        const bool valid = quantity.field->native().has_value();
        quantity.field->setScale(scale);
        quantity.field->setNativeRange(least, most);
        // A number that was beyond the range of before is not in the recipe, although it is a value now.
        if (!valid && quantity.field->native())
            quantity.field->showNative(m_recipe.*quantity.value);
    }
    refresh();
}

void HomingForm::setLocked(const QString& reason) {
    if (std::exchange(m_locked, reason) != reason)
        showRecipe(m_recipe);  // a number that is not finished would stay so
}

bool HomingForm::uses(Number value) const {
    return value != &HomingRecipe::indexVelocity || effective(m_recipe, {m_type, 0}).thenIndex;
}

QString HomingForm::problemText() const {
    for (const Quantity& quantity : m_quantities)
        if (uses(quantity.value) && quantity.field->problem() != NumberField::Problem::None)
            return quantity.field->problemText();
    return m_timeLimit->problem() != NumberField::Problem::None ? m_timeLimit->problemText() : QString();
}

void HomingForm::applyEdit() {
    refresh();
    emit edited();
}

void HomingForm::refresh() {
    for (const Box& box : m_boxes) {
        const QSignalBlocker blocker(box.button);
        box.button->setChecked(m_recipe.*box.flag);
        QString reason = m_locked;
        if (reason.isEmpty() && box.flag == &HomingRecipe::thenIndex && m_recipe.onIndex)
            reason = tr("The first search already finds the index.");
        if (reason.isEmpty() && box.flag == &HomingRecipe::makeZero && !m_recipe.goToHome)
            reason = tr("Needs Go to home, because the position at which the motor rests becomes 0.");
        look::setPossible(box.button, reason, box.meaning);
    }
    {
        // Both are blocked: checking one unchecks the other, which would emit toggled, too.
        const QSignalBlocker forward(m_forward);
        const QSignalBlocker reverse(m_reverse);
        (m_recipe.reverse != m_reversed ? m_reverse : m_forward)->setChecked(true);
    }
    for (QAbstractButton* button : {m_forward, m_reverse})
        look::setPossible(button, m_locked, tr("The search direction, in which the switch closes."));
    for (const Quantity& quantity : m_quantities) {
        quantity.field->setMeaning(m_locked.isEmpty() ? quantity.meaning : m_locked);
        quantity.field->setEnabled(m_locked.isEmpty() && uses(quantity.value));
        quantity.label->setEnabled(quantity.field->isEnabled());
    }
    m_timeLimit->setPossible(m_locked, tr("A search stops and fails after this time."));
    refreshStops();
}

void HomingForm::refreshStops() {
    const Stop stop = effective(m_recipe, {m_type, 0}).stop;
    QString reason = m_locked;
    if (reason.isEmpty() && m_recipe.onPositionError && m_type == ModuleType::Servo)
        reason = tr("A position error switches the servo off.");
    const bool hostStops =
        m_type == ModuleType::Servo && m_version > 0 && m_version < servo::kAutoStopVersion;
    const QString who =
        hostStops
            ? tr(" This chip version does not stop the motor by itself: the panel stops it, a few hundredths of a second later.")
            : tr(" The chip stops it by itself.");
    const std::array meanings{tr("At home the motor stops at once and holds."),
                              tr("At home the motor slows down, stops past it and holds."),
                              tr("At home the motor is switched off and is free to turn.")};
    for (std::size_t i = 0; i < kStops.size(); ++i) {
        const QSignalBlocker blocker(m_stops[i]);
        m_stops[i]->setChecked(kStops[i] == stop);
        look::setPossible(m_stops[i], reason, meanings[i] + who);
    }
}

}  // namespace nmc
