// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responseform.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "model/intent/gainsplan.h"
#include "model/intent/looptestplan.h"
#include "model/module/servodefaults.h"
#include "model/response/responserecord.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/form.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/panels/gainsmeaning.h"
#include "widgets/response/holdfirstbutton.h"
#include "widgets/response/responsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kFirstRecord = 0.5;  ///< s
constexpr double kNarrowestBand = 0.1, kWidestBand = 50.0;
constexpr int kStepDigits = 6;            ///< width of each field
constexpr double kWidestWindow = 10'000;  ///< counts
constexpr double kLongestDwell = 2.0;     ///< s
constexpr double kFirstRounds = 3;
}  // namespace

ResponseForm::ResponseForm(Requests& requests, QWidget* parent)
    : QWidget(parent), m_requests(requests), m_lastBand(kFirstBand) {
    look::name(this, u"responseForm"_s, tr("Settings of the next step"));
    auto* grid = new FormGrid(this, 4, {.sides = 0, .ends = 0, .across = 1});
    buildFields(grid);
    buildMoveFields(grid);
    buildButton(grid);
    showMethod();
    refresh();
}

void ResponseForm::buildFields(FormGrid* grid) {
    m_distance = form::newQuantity(
        {.kind = QuantityField::Kind::Position,
         .name = u"responseDistanceField"_s,
         .accessible = tr("Distance of the step response"),
         .words = tr("The distance of the step"),
         .min = -kLongestStep,
         .max = kLongestStep,
         .digits = kStepDigits,
         .meaning = tr(
             "How far the command goes; negative: reverse. Small steps show the tuning of the servo, large ones the limits of the amplifier.")},
        this);
    m_distance->showNative(kFirstStep);
    m_method =
        form::newChoice({u"responseMethodBox"_s, Common::tr("Method: how the command jumps"), {}}, this);
    for (const ResponseMethod method :
         {ResponseMethod::Profile, ResponseMethod::StopHere, ResponseMethod::Move}) {
        m_method->addItem(texts::responseMethod(method), static_cast<int>(method));
        m_method->setItemData(m_method->count() - 1, texts::responseMethodMeaning(method), Qt::ToolTipRole);
    }
    m_method->setToolTip(texts::responseMethodMeaning(ResponseMethod::Profile) + u"\n"_s +
                         texts::responseMethodMeaning(ResponseMethod::StopHere) + u"\n"_s +
                         texts::responseMethodMeaning(ResponseMethod::Move));
    m_method->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_method->setMinimumContentsLength(12);
    m_record = form::newNumber(
        {.name = u"responseRecordField"_s,
         .accessible = tr("The record"),
         .unit = Common::tr("s"),
         .min = kShortestRecord,
         .max = kLongestRecord,
         .decimals = 2,
         .digits = kStepDigits,
         .meaning = tr(
             "How long to record after the step, or after the end of a move. Then the motor is commanded to hold.")},
        this);
    m_record->showValue(kFirstRecord);
    m_band = form::newNumber(
        {.name = u"responseBandField"_s,
         .accessible = tr("The settling band"),
         .unit = tr("% of the step"),
         .min = kNarrowestBand,
         .max = kWidestBand,
         .decimals = 1,
         .digits = kStepDigits,
         .meaning = tr(
             "The motor has settled when it stays this close to its goal. At least one count. Applies to all runs.")},
        this);
    m_band->showValue(kFirstBand);
    grid->addRow(tr("Distance"), m_distance);
    grid->addTitled(Common::tr("Method"), m_method)->setBuddy(m_method);
    grid->addRow(tr("Record"), m_record, {new QLabel(Common::tr("s"), this)});
    auto* percent = new QLabel(tr("% of the step"), this);
    m_forSteps = {grid->addRow(tr("Settling band"), m_band, {percent}), m_band, percent};
    connect(m_distance, &QuantityField::nativeEdited, this, &ResponseForm::edited);
    connect(m_method, &QComboBox::currentIndexChanged, this, &ResponseForm::showMethod);
    connect(m_method, &QComboBox::currentIndexChanged, this, &ResponseForm::edited);
    connect(m_record, &NumberField::edited, this, &ResponseForm::edited);
    connect(this, &ResponseForm::edited, this, &ResponseForm::refresh);
    connect(m_band, &NumberField::edited, this, &ResponseForm::takeJudgement);
}

QuantityField* ResponseForm::newPaceField(const QString& objectName, const QString& name,
                                          const QString& meaning, QuantityField::Kind kind, double step) {
    auto* field = form::newQuantity({.kind = kind,
                                     .name = objectName,
                                     .accessible = name,
                                     .min = servodefaults::kSmallest,
                                     .max = servodefaults::kLargest,
                                     .step = step,
                                     .digits = kStepDigits,
                                     .meaning = meaning},
                                    this);
    connect(field, &QuantityField::nativeEdited, this, &ResponseForm::edited);
    return field;
}

void ResponseForm::buildMoveFields(FormGrid* grid) {
    m_velocity =
        newPaceField(u"responseVelocityField"_s, tr("Velocity of the move"),
                     tr("The velocity of the move. Until you type one, it is that of moves to a position."),
                     QuantityField::Kind::Velocity, 0.05);
    m_acceleration = newPaceField(
        u"responseAccelerationField"_s, tr("Acceleration of the move"),
        tr("The acceleration of the move. Until you type one, it is that of moves to a position."),
        QuantityField::Kind::Acceleration, 0.0005);
    m_rounds = form::newNumber({.name = u"responseRoundsField"_s,
                                .accessible = tr("Moves there and back"),
                                .min = 1,
                                .max = kMaxMoves,
                                .digits = kStepDigits,
                                .meaning = tr("How often it moves there and back. Each move is recorded.")},
                               this);
    m_rounds->showValue(kFirstRounds);
    m_window = form::newQuantity(
        {.kind = QuantityField::Kind::Distance,
         .name = u"responseWindowField"_s,
         .accessible = tr("Settling window"),
         .min = 1,
         .max = kWidestWindow,
         .digits = kStepDigits,
         .meaning = tr(
             "The motor has settled when it stays this close to its goal for the dwell. At least one count. Applies to all moves.")},
        this);
    m_window->showNative(m_lastWindow.counts);
    m_dwell = form::newNumber(
        {.name = u"responseDwellField"_s,
         .accessible = tr("Dwell"),
         .unit = Common::tr("s"),
         .min = 0,
         .max = kLongestDwell,
         .decimals = 3,
         .digits = kStepDigits,
         .meaning =
             tr("How long it must stay in the window. The settling time ends where the dwell begins.")},
        this);
    m_dwell->showValue(m_lastWindow.dwell);
    for (const auto& [label, field] :
         {std::pair{Common::tr("Velocity"), m_velocity},
          std::pair{Common::tr("Acceleration"), m_acceleration}, std::pair{tr("Window"), m_window}}) {
        QWidget* control = field;  // without its value in the other unit, because the form is often narrow
        field->otherView()->hide();
        m_forMoves.insert(m_forMoves.end(),
                          {grid->addRow(label, control, {field->unitLabel()}), field, field->unitLabel()});
    }
    auto* seconds = new QLabel(Common::tr("s"), this);
    m_forMoves.insert(m_forMoves.end(), {grid->addRow(tr("Dwell"), m_dwell, {seconds}), m_dwell, seconds});
    m_forMoves.insert(m_forMoves.end(), {grid->addRow(tr("There and back"), m_rounds), m_rounds});
    connect(m_rounds, &NumberField::edited, this, &ResponseForm::edited);
    connect(m_window, &QuantityField::nativeEdited, this, &ResponseForm::takeJudgement);
    connect(m_dwell, &NumberField::edited, this, &ResponseForm::takeJudgement);
}

bool ResponseForm::moves() const {
    return form::chosen<ResponseMethod>(m_method) == ResponseMethod::Move;
}

void ResponseForm::showMethod() {
    for (QWidget* widget : m_forSteps)
        widget->setVisible(!moves());
    for (QWidget* widget : m_forMoves)
        widget->setVisible(moves());
    m_distance->setNativeRange(moves() ? static_cast<double>(servo::kPositionRange.min) : -kLongestStep,
                               moves() ? static_cast<double>(servo::kPositionRange.max) : kLongestStep);
}

void ResponseForm::takeJudgement() {
    m_lastBand = m_band->value().value_or(m_lastBand);
    m_lastWindow = {m_window->native().value_or(m_lastWindow.counts),
                    m_dwell->value().value_or(m_lastWindow.dwell)};
    emit judgementEdited();
}

void ResponseForm::buildButton(FormGrid* grid) {
    m_step = new QPushButton(icons::tinted(u"player-play"_s), tr("Step"), this);
    look::name(m_step, u"responseButton"_s, tr("Step and record"));
    m_state = form::newRemark({}, parentWidget(), u"responseState"_s);
    m_hold = new HoldFirstButton(u"responseHoldButton"_s, m_requests, this);
    const int line = grid->rowCount();
    grid->addWidget(m_step, line, 0);
    grid->addWidget(m_hold, line, 1, 1, 3, Qt::AlignLeft);
    connect(m_step, &QPushButton::clicked, this, [this] { step(); });
}

void ResponseForm::showModule(const PanelView& view) {
    m_module = view.module;
    m_module->gains = view.gains();
    m_connected = view.connected;
    m_report.reset();
    if (view.procedure != nullptr && makesSteps(view.procedure->kind))
        m_report = *view.procedure;
    m_staged = view.settings.gains;
    for (QuantityField* field : {m_distance, m_velocity, m_acceleration, m_window})
        field->setScale(view.scale());
    m_velocity->setNativeRange(servodefaults::kSmallest, servodefaults::fastest(view.module.info.identity));
    const MotionSettings before = std::exchange(m_motion, servodefaults::motionOf(view.settings));
    m_velocity->follow(m_motion.velocity, before.velocity);
    m_acceleration->follow(m_motion.acceleration, before.acceleration);
    refresh();
}

void ResponseForm::showNothing() {
    m_module.reset();
    m_report.reset();
    m_connected = false;
    refresh();
}

std::optional<std::int32_t> ResponseForm::distance() const {
    const auto distance = m_distance->native();
    return distance ? std::optional(static_cast<std::int32_t>(*distance)) : std::nullopt;
}

std::vector<const NumberField*> ResponseForm::fieldsInUse() const {
    std::vector<const NumberField*> fields{m_distance, m_record};
    if (moves())
        fields.insert(fields.end(), {m_velocity, m_acceleration, m_rounds});
    return fields;
}

std::optional<intent::StepSeries> ResponseForm::entered(const std::vector<std::int32_t>& series) const {
    const auto distance = this->distance();
    const auto record = m_record->value();
    if (!distance || !record)
        return std::nullopt;
    intent::StepSeries wanted{{*distance, form::chosen<ResponseMethod>(m_method), *record}, series};
    if (!series.empty() || !moves()) {
        if (series.empty())
            wanted.counts = {*distance};
        else if (moves())
            wanted.each.method = ResponseMethod::Profile;  // a motor is identified from steps
        wanted.each.counts = wanted.counts.front();
        return wanted;
    }
    const auto velocity = m_velocity->native();
    const auto acceleration = m_acceleration->native();
    const auto rounds = m_rounds->value();
    if (!velocity || !acceleration || !rounds)
        return std::nullopt;
    wanted.each.pace = {CountsPerTick(servodefaults::toFixed(*velocity)),
                        CountsPerTickSquared(servodefaults::toFixed(*acceleration))};
    for (int i = 0; i < static_cast<int>(*rounds); ++i)
        wanted.counts.insert(wanted.counts.end(), {*distance, -*distance});
    return wanted;
}

std::optional<Refusal> ResponseForm::refusal(const std::vector<std::int32_t>& series) const {
    const auto wanted = entered(series);
    return m_module && wanted ? nmc::whyNot(*wanted, *m_module) : std::nullopt;
}

QString ResponseForm::whyNotNow(const std::vector<std::int32_t>& series) const {
    if (!m_connected || !m_module)
        return texts::refusal(Refusal::NotConnected);
    if (m_report && !m_report->over())
        return tr("A step or move is already running.");
    for (const NumberField* field : fieldsInUse())
        if (const QString problem = field->problemText(); !problem.isEmpty())
            return problem;
    const auto refusal = this->refusal(series);
    return refusal ? texts::refusal(*refusal) : QString();
}

void ResponseForm::refresh() {
    const QString reason = whyNotNow();
    m_step->setText(moves() ? tr("Move") : tr("Step"));
    m_step->setAccessibleName(moves() ? tr("Move and record") : tr("Step and record"));
    look::setPossible(
        m_step, reason,
        moves()
            ? tr("The motor moves there and back, then holds. Make sure that everything it drives can move freely (Shift+F9).")
            : tr("The motor jumps by this distance, then holds. Make sure that everything it drives can move freely (Shift+F9)."));
    m_hold->showFor(m_module, refusal());
    const bool runs = m_report && !m_report->over();
    const bool failed = reason.isEmpty() && m_report && m_report->failure;
    look::setText(m_state, runs     ? texts::procedureStage(*m_report)
                           : failed ? texts::loopTestFailure(*m_report->failure)
                                    : reason);
}

void ResponseForm::step(const std::vector<std::int32_t>& series) {
    const auto wanted = entered(series);
    if (!wanted || !whyNotNow(series).isEmpty())
        return;
    if (unsentGains().isEmpty())
        ask(m_module->info.index, *wanted, series.empty());
    else
        askWhichGains(*wanted, series);
}

void ResponseForm::ask(ModuleIndex module, const intent::StepSeries& wanted, bool own) {
    const bool alone = own && wanted.counts.size() == 1;
    emit m_requests.intent(module, alone ? Intent(wanted.each) : wanted);
}

/// The gains in the fields that differ from those of the module; empty if there are none.
QString ResponseForm::unsentGains() const {
    if (!m_module || !m_module->gains || !m_staged)
        return {};
    const servo::SetGain staged = gainsFor(*m_module, *m_staged);
    QStringList differ;
    for (const Gain gain : kAllGains) {
        const auto wanted = gainOf(staged, gain);
        const auto has = gainOf(*m_module->gains, gain);
        if (wanted && has && wanted != has)
            differ << tr("%1 %2 instead of %3").arg(gainLetters(gain)).arg(*wanted).arg(*has);
    }
    return differ.join(u", "_s);
}

/// What the fields say of this pace, in ticks of another length.
ServoPace ResponseForm::atServoRate(const ServoPace& pace, int servoRate) const {
    const AxisScale& shown = m_velocity->scale();
    const AxisScale then = AxisScale::servo(shown.unit(), servoRate);
    const auto velocity = shown.velocity(toCounts(pace.velocity));
    const auto acceleration = shown.acceleration(toCounts(pace.acceleration));
    if (!velocity || !acceleration)
        return pace;
    const double fastest = servodefaults::fastest(m_module->info.identity);
    return {CountsPerTick(servodefaults::toFixed(std::min(*then.nativeVelocity(*velocity), fastest))),
            CountsPerTickSquared(servodefaults::toFixed(
                std::min(*then.nativeAcceleration(*acceleration), servodefaults::kLargest)))};
}

void ResponseForm::askWhichGains(const intent::StepSeries& wanted, const std::vector<std::int32_t>& series) {
    const ModuleIndex index = m_module->info.index;
    const auto go = [this, index, own = series.empty()](const intent::StepSeries& steps) {
        return [this, index, steps, own] { ask(index, steps, own); };
    };
    const auto text = [this, index, before = unsentGains(), series, wanted] {
        const bool stands = m_module && m_module->info.index == index && unsentGains() == before &&
                            entered(series) == wanted && whyNotNow(series).isEmpty();
        return stands ? tr("Some gains in the fields were not sent: %1. Which gains should the step use?")
                            .arg(before)
                      : QString();
    };
    intent::StepSeries applied = wanted;
    applied.each.gains = m_staged;
    applied.each.pace = atServoRate(wanted.each.pace, m_staged->sr);
    AskDialog::ask({.name = u"stepGainsDialog"_s,
                    .title = tr("Gains not sent"),
                    .text = text,
                    .stay = tr("&Cancel"),
                    .stayName = u"cancelStepButton"_s,
                    .goIsDefault = true},
                   {{tr("&Apply and step"), u"applyAndStepButton"_s, go(applied)},
                    {tr("Step with &present gains"), u"stepWithoutButton"_s, go(wanted)}},
                   this);
}

}  // namespace nmc
