// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/travelbox.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>

#include "model/machinefile/machinelayout.h"
#include "model/module/servodefaults.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kLimitDigits = 8;         // width of each field
constexpr double kLongestArrival = 60;  // s
}  // namespace

TravelBox::TravelBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(Common::tr("Travel and speed limits"), parent), m_context(context) {
    look::name(this, m_context.named(u"travelBox"_s), Common::tr("Travel and speed limits"));
    auto* grid = new FormGrid(this, 5, {.across = 0.5, .down = 0.5});
    buildLimit(grid, Lowest);
    buildLimit(grid, Highest);
    buildFastest(grid);
    buildBacklash(grid);
    if (!m_context.state().isStepper())
        buildArrival(grid);
    m_hint = form::newParagraph(m_context.named(u"travelHint"_s), {}, this);
    m_state = form::newParagraph(m_context.named(u"travelState"_s), tr("State of the travel limits"), this);
    grid->addWide(m_hint);
    grid->addWide(m_state);
    buildWord(grid);
    grid->setColumnStretch(3, 1);
    m_context.whenSeen(this, [this] { showModule(); });
}

void TravelBox::buildLimit(FormGrid* grid, Limit limit) {
    const bool lowest = limit == Lowest;
    const QString name = texts::machineField(lowest ? u"lowest"_s : u"highest"_s);
    QuantityField* field = form::newQuantity(
        {.kind = QuantityField::Kind::Position,
         .name = m_context.named(lowest ? u"lowestField"_s : u"highestField"_s),
         .accessible = name,
         .min = layout::kPlace.min,
         .max = layout::kPlace.max,
         .step = 100,
         .digits = kLimitDigits,
         .meaning = tr("Counted from home. No motion passes it while home is known. Empty: no limit.")},
        this);
    m_limits[limit] = field;
    m_here[limit] =
        new Command({.name = m_context.named(lowest ? u"lowestHereButton"_s : u"highestHereButton"_s),
                     .text = tr("Here"),
                     .accessible = lowest ? tr("Here: make the present position the lowest")
                                          : tr("Here: make the present position the highest")},
                    this, [this, limit] { takePosition(limit); });
    grid->addRow(name, field, {m_here[limit]->button()});
    connect(field, &QuantityField::nativeEdited, this, &TravelBox::refresh);
    // Only when editing has finished: a limit is in force at once and stops a motor beyond it, which half of
    // a number must not do.
    connect(field, &QuantityField::editingFinished, this, &TravelBox::keep);
}

void TravelBox::buildFastest(FormGrid* grid) {
    m_fastest = form::newQuantity(
        {.kind = QuantityField::Kind::Velocity,
         .name = m_context.named(u"fastestField"_s),
         .accessible = Common::tr("Highest velocity"),
         .digits = kLimitDigits,
         .meaning = tr("Limits moves, runs, steps, jog and homing. Empty: the module's maximum.")},
        this);
    grid->addRow(Common::tr("Highest velocity"), m_fastest);
    connect(m_fastest, &QuantityField::nativeEdited, this, &TravelBox::refresh);
    connect(m_fastest, &QuantityField::editingFinished, this, &TravelBox::keep);
}

void TravelBox::buildBacklash(FormGrid* grid) {
    m_backlash = form::newQuantity(
        {.kind = QuantityField::Kind::Distance,
         .name = m_context.named(u"backlashField"_s),
         .accessible = Common::tr("Backlash"),
         .min = 1,
         .max = layout::kPlace.max,
         .digits = kLimitDigits,
         .meaning = tr(
             "Slightly more than the play between motor and load. A move from the other side overshoots its goal by this distance and comes back. Empty: none.")},
        this);
    m_side = form::newChoice(
        {.name = m_context.named(u"backlashSideBox"_s),
         .accessible = tr("Approach direction of every goal"),
         .options = {{tr("from below"), false}, {tr("from above"), true}},
         .meaning = tr(
             "Go, Go home, steps, points and sequences approach their goals from this side. Loaded moves and paths go straight to theirs.")},
        this);
    grid->addRow(Common::tr("Backlash"), m_backlash, {m_side});
    connect(m_backlash, &QuantityField::nativeEdited, this, &TravelBox::keepBacklash);
    connect(m_side, &QComboBox::currentIndexChanged, this, &TravelBox::keepBacklash);
}

void TravelBox::keepBacklash() {
    BacklashSettings backlash = m_context.settings().backlash;
    if (usable(*m_backlash))
        backlash.distance = m_backlash->native().value_or(0.0);
    backlash.fromAbove = m_context.chipReverse(m_side->currentData().toBool());
    m_shownBacklash = backlash;
    m_context.edit([backlash](AxisSettings& axis) { axis.backlash = backlash; });
    refresh();
}

void TravelBox::buildArrival(FormGrid* grid) {
    m_tolerance = form::newQuantity(
        {.kind = QuantityField::Kind::Distance,
         .name = u"arrivalToleranceField"_s,
         .accessible = tr("Arrival tolerance"),
         .min = 1,
         .max = layout::kPlace.max,
         .digits = kLimitDigits,
         .meaning = tr(
             "Sequences, and programs that wait, go on when the motor has stayed this close to its goal for the time beside it. Empty: when it stands still.")},
        this);
    m_duration = form::newNumber({.name = u"arrivalDurationField"_s,
                                  .accessible = tr("Time within the arrival tolerance"),
                                  .unit = Common::tr("s"),
                                  .min = layout::kSeconds.min,
                                  .max = kLongestArrival,
                                  .decimals = 2,
                                  .digits = 5,
                                  .meaning = tr("How long the motor must stay within the tolerance.")},
                                 this);
    grid->addRow(tr("Arrival within"), m_tolerance,
                 {form::newLine(this, {form::newLabel(tr("for"), m_duration), m_duration,
                                       new QLabel(Common::tr("s"), this)})});
    connect(m_tolerance, &QuantityField::nativeEdited, this, &TravelBox::keepArrival);
    connect(m_duration, &NumberField::edited, this, &TravelBox::keepArrival);
}

void TravelBox::keepArrival() {
    ArrivalSettings arrival = m_context.settings().arrival;
    if (usable(*m_tolerance))
        arrival.tolerance = m_tolerance->native().value_or(0.0);
    if (usable(*m_duration))
        arrival.seconds = m_duration->value().value_or(0.0);
    m_shownArrival = arrival;
    m_context.edit([arrival](AxisSettings& axis) { axis.arrival = arrival; });
    refresh();
}

void TravelBox::buildWord(FormGrid* grid) {
    m_declare = new Command({.name = m_context.named(u"declarePositionButton"_s),
                             .text = tr("Confirm position…"),
                             .accessible = tr("Confirm position as correct")},
                            this, [this] { askToDeclare(); });
    m_doubt = new Command({.name = m_context.named(u"doubtPositionButton"_s),
                           .text = tr("Position in doubt"),
                           .accessible = tr("Position in doubt: it may be wrong")},
                          this, [this] { m_context.ask(intent::DeclarePosition{false}); });
    grid->addWide(form::newLine(this, {nullptr, m_doubt->button(), m_declare->button()}));
}

/// On a reversed axis, the lowest position is the chip's highest.
std::optional<std::int32_t>& TravelBox::of(TravelSettings& travel, Limit limit) const {
    return (limit == Lowest) != m_context.scale().reversed() ? travel.lowest : travel.highest;
}

bool TravelBox::usable(const NumberField& field) {
    return field.value() || field.problem() == NumberField::Problem::Empty;
}

std::vector<QuantityField*> TravelBox::quantities() const {
    std::vector<QuantityField*> fields{m_limits[Lowest], m_limits[Highest], m_fastest, m_backlash};
    if (m_tolerance != nullptr)
        fields.push_back(m_tolerance);
    return fields;
}

bool TravelBox::crossed() const {
    const auto lowest = m_limits[Lowest]->native();
    const auto highest = m_limits[Highest]->native();
    const AxisScale scale = m_context.scale();
    return lowest && highest && scale.position(*lowest) >= scale.position(*highest);
}

/// True if home is within the travel limits, but less than the backlash away from the one beyond which a move
/// to it would turn round.
bool TravelBox::homeIsOutOfReach() const {
    const TravelSettings& travel = m_context.settings().travel;
    const BacklashSettings& backlash = m_context.settings().backlash;
    const auto& limit = backlash.fromAbove ? travel.highest : travel.lowest;
    if (!limit)
        return false;
    const double room = backlash.fromAbove ? *limit : -static_cast<double>(*limit);
    return room >= 0 && room < backlash.distance;
}

/// Keeps typed values with the axis. A value that makes no sense stays in its field only, and the previous
/// one stays in force.
void TravelBox::keep() {
    const bool makesSense = usable(*m_limits[Lowest]) && usable(*m_limits[Highest]) && !crossed();
    TravelSettings travel = m_context.settings().travel;
    for (const Limit limit : {Lowest, Highest})
        if (const auto native = m_limits[limit]->native(); makesSense)
            of(travel, limit) = native ? std::optional(static_cast<std::int32_t>(*native)) : std::nullopt;
    if (usable(*m_fastest))
        travel.fastest = m_fastest->native().value_or(0.0);
    m_shown = travel;
    m_context.edit([travel](AxisSettings& axis) { axis.travel = travel; });
    refresh();
}

void TravelBox::takePosition(Limit limit) {
    const ModuleState& module = m_context.state();
    if (!module.home.place() || !module.latest || !module.latest->position)
        return;
    m_limits[limit]->showNative(countsBetween(module.home.place()->counts, *module.latest->position));
    keep();
}

void TravelBox::askToDeclare() {
    // The question stays as long as the Axis page is visible and the command is possible.
    const auto text = [this] {
        const bool stands = parentWidget()->isVisible() && m_declare->isEnabled();
        return stands ? texts::declareQuestion(m_context.state(), m_context.scale()) : QString();
    };
    const auto go = [this] { m_context.ask(intent::DeclarePosition{true}); };
    AskDialog::ask({.name = u"declarePositionDialog"_s,
                    .title = tr("Confirm the position"),
                    .text = text,
                    .stayName = u"stayDeclareButton"_s},
                   {{tr("Position &is right"), u"positionIsRightButton"_s, go}}, this);
}

void TravelBox::showField(QuantityField& field, std::optional<double> native) {
    if (field.native() == native && field.problem() != NumberField::Problem::OutOfRange)
        return;
    if (native)
        field.showNative(*native);
    else
        field.showNothing();
}

void TravelBox::showModule() {
    const AxisScale scale = m_context.scale();
    const bool turned = scale.reversed() != m_fastest->scale().reversed();
    for (QuantityField* field : quantities())
        field->setScale(scale);
    const bool steps = m_context.state().isStepper();
    m_fastest->setNativeRange(
        steps ? 1.0 : servodefaults::kSmallest,
        steps ? layout::kMaxStepSpeed : servodefaults::fastest(m_context.state().info.identity));
    // The value being typed is kept.
    TravelSettings travel = m_context.settings().travel;
    if (m_shown != travel || turned) {
        for (const Limit limit : {Lowest, Highest})
            showField(*m_limits[limit], of(travel, limit));
        showField(*m_fastest, travel.fastest > 0 ? std::optional(travel.fastest) : std::nullopt);
        m_shown = travel;
    }
    const BacklashSettings& backlash = m_context.settings().backlash;
    if (m_shownBacklash != backlash || turned) {
        showField(*m_backlash, backlash.distance > 0 ? std::optional(backlash.distance) : std::nullopt);
        const QSignalBlocker blocker(m_side);
        m_side->setCurrentIndex(m_context.chipReverse(backlash.fromAbove) ? 1 : 0);
        m_shownBacklash = backlash;
    }
    const ArrivalSettings& arrival = m_context.settings().arrival;
    if (m_tolerance != nullptr && (m_shownArrival != arrival || turned)) {
        showField(*m_tolerance, arrival.tolerance > 0 ? std::optional(arrival.tolerance) : std::nullopt);
        m_duration->showValue(arrival.seconds);
        m_shownArrival = arrival;
    }
    refresh();
}

void TravelBox::refresh() {
    const ModuleState& module = m_context.state();
    QString hint;
    for (const QuantityField* field : quantities())
        if (hint.isEmpty() && !usable(*field))
            hint = field->problemText();
    if (hint.isEmpty() && m_duration != nullptr && !usable(*m_duration))
        hint = m_duration->problemText();
    if (hint.isEmpty() && crossed())
        hint = tr("The lowest position must be below the highest. The old value is kept.");
    if (hint.isEmpty() && homeIsOutOfReach())
        hint = tr(
            "With this backlash, no move can end at home: it would reverse beyond the limit. Move the limit away from home, or change the backlash or its direction.");
    look::setText(m_hint, hint);
    m_hint->setVisible(!hint.isEmpty());
    look::setText(m_state, texts::travelState(module, m_context.scale()));
    QString noPlace;
    if (!m_context.connected())
        noPlace = texts::refusal(Refusal::NotConnected);
    else if (!module.home.place())
        noPlace = texts::refusal(Refusal::HomeUnknown);
    else if (m_context.age() || !module.latest || !module.latest->position)
        noPlace = texts::refusal(Refusal::PositionUnknown);
    m_here[Lowest]->setPossible(noPlace, tr("Sets the lowest position to the present position."));
    m_here[Highest]->setPossible(noPlace, tr("Sets the highest position to the present position."));
    m_declare->setPossible(m_context.reasonNow(IntentKind::DeclarePosition),
                           tr("Confirms that the position is right: home is at position 0. Asks first."));
    QString certain = m_context.reasonNow(IntentKind::DeclarePosition);
    if (certain.isEmpty() && !module.home.place())
        certain = texts::refusal(Refusal::HomeUnknown);
    m_doubt->setPossible(
        certain, tr("Marks home as unknown. The travel limits are not in force until home is known again."));
}

}  // namespace nmc
