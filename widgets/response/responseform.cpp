// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responseform.h"

#include <QComboBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>

#include "model/intent/gainsplan.h"
#include "model/intent/looptestplan.h"
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
constexpr int kStepDigits = 6;  ///< width of each field
}  // namespace

ResponseForm::ResponseForm(Requests& requests, QWidget* parent)
    : QWidget(parent), m_requests(requests), m_lastBand(kFirstBand) {
    look::name(this, u"responseForm"_s, tr("Settings of the next step"));
    auto* grid = new FormGrid(this, 4, {.sides = 0, .ends = 0, .across = 1});
    buildFields(grid);
    buildButton(grid);
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
             "How far the command jumps; negative: reverse. Small steps show the tuning of the servo, large ones the limits of the amplifier.")},
        this);
    m_distance->showNative(kFirstStep);
    m_method =
        form::newChoice({u"responseMethodBox"_s, Common::tr("Method: how the command jumps"), {}}, this);
    for (const ResponseMethod method : {ResponseMethod::Profile, ResponseMethod::StopHere}) {
        m_method->addItem(texts::responseMethod(method), static_cast<int>(method));
        m_method->setItemData(m_method->count() - 1, texts::responseMethodMeaning(method), Qt::ToolTipRole);
    }
    m_method->setToolTip(texts::responseMethodMeaning(ResponseMethod::Profile) + u"\n"_s +
                         texts::responseMethodMeaning(ResponseMethod::StopHere));
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
         .meaning = tr("How long to record after the step. Then the motor is commanded to hold.")},
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
    grid->addRow(tr("Settling band"), m_band, {new QLabel(tr("% of the step"), this)});
    connect(m_distance, &QuantityField::nativeEdited, this, &ResponseForm::edited);
    connect(m_method, &QComboBox::currentIndexChanged, this, &ResponseForm::edited);
    connect(m_record, &NumberField::edited, this, &ResponseForm::edited);
    connect(this, &ResponseForm::edited, this, &ResponseForm::refresh);
    connect(m_band, &NumberField::edited, this, [this] {
        if (const auto band = m_band->value()) {
            m_lastBand = *band;
            emit bandEdited(*band);
        }
    });
}

void ResponseForm::buildButton(FormGrid* grid) {
    m_step = new QPushButton(icons::tinted(u"player-play"_s), tr("Step"), this);
    look::name(m_step, u"responseButton"_s, tr("Step and record"));
    m_state = look::newMutedLabel({}, parentWidget());
    m_state->setObjectName(u"responseState"_s);
    m_state->setWordWrap(true);
    m_hold = new HoldFirstButton(u"responseHoldButton"_s, m_requests, this);
    const int line = grid->rowCount();
    grid->addWidget(m_step, line, 0);
    grid->addWidget(m_hold, line, 1, 1, 3, Qt::AlignLeft);
    connect(m_step, &QPushButton::clicked, this, [this] { step(); });
}

void ResponseForm::showModule(const PanelView& view) {
    m_module = view.module;
    m_connected = view.connected;
    m_report.reset();
    if (view.procedure != nullptr && makesSteps(view.procedure->kind))
        m_report = *view.procedure;
    m_staged = view.settings.gains;
    m_distance->setScale(view.scale());
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

std::optional<intent::StepResponse> ResponseForm::entered() const {
    const auto distance = this->distance();
    const auto record = m_record->value();
    if (!distance || !record)
        return std::nullopt;
    return intent::StepResponse{*distance, form::chosen<ResponseMethod>(m_method), *record};
}

std::optional<Refusal> ResponseForm::refusal(const std::vector<std::int32_t>& series) const {
    const auto step = entered();
    if (!m_module || !step)
        return std::nullopt;
    return series.empty() ? nmc::whyNot(*step, *m_module)
                          : nmc::whyNot(intent::StepSeries{*step, series}, *m_module);
}

QString ResponseForm::whyNotNow(const std::vector<std::int32_t>& series) const {
    if (!m_connected || !m_module)
        return texts::refusal(Refusal::NotConnected);
    if (m_report && !m_report->over())
        return tr("A step is already running.");
    for (const NumberField* field : {static_cast<NumberField*>(m_distance), m_record})
        if (const QString problem = field->problemText(); !problem.isEmpty())
            return problem;
    const auto refusal = this->refusal(series);
    return refusal ? texts::refusal(*refusal) : QString();
}

void ResponseForm::refresh() {
    const QString reason = whyNotNow();
    look::setPossible(
        m_step, reason,
        tr("The motor jumps by this distance, then holds. Make sure that everything it drives can move freely (Shift+F9)."));
    m_hold->showFor(m_module, refusal());
    const bool runs = m_report && !m_report->over();
    const bool failed = reason.isEmpty() && m_report && m_report->failure;
    look::setText(m_state, runs     ? texts::procedureStage(*m_report)
                           : failed ? texts::loopTestFailure(*m_report->failure)
                                    : reason);
}

void ResponseForm::step(const std::vector<std::int32_t>& series) {
    const auto step = entered();
    if (!step || !whyNotNow(series).isEmpty())
        return;
    if (unsentGains().isEmpty())
        ask(m_module->info.index, *step, series);
    else
        askWhichGains(*step, series);
}

void ResponseForm::ask(ModuleIndex module, const intent::StepResponse& step,
                       const std::vector<std::int32_t>& series) {
    emit m_requests.intent(module, series.empty() ? Intent(step) : intent::StepSeries{step, series});
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

void ResponseForm::askWhichGains(const intent::StepResponse& step, const std::vector<std::int32_t>& series) {
    const auto ask = [self = QPointer(this), index = m_module->info.index,
                      series](const intent::StepResponse& wanted) {
        return [self, index, wanted, series] {
            if (self)
                self->ask(index, wanted, series);
        };
    };
    const auto text = [self = QPointer(this), index = m_module->info.index, before = unsentGains(), series] {
        const bool stands = self && self->m_module && self->m_module->info.index == index &&
                            self->unsentGains() == before && self->whyNotNow(series).isEmpty();
        return stands ? tr("Some gains in the fields were not sent: %1. Which gains should the step use?")
                            .arg(before)
                      : QString();
    };
    intent::StepResponse applied = step;
    applied.gains = m_staged;
    AskDialog::ask({.name = u"stepGainsDialog"_s,
                    .title = tr("Gains not sent"),
                    .text = text,
                    .stay = tr("&Cancel"),
                    .stayName = u"cancelStepButton"_s},
                   {{tr("&Apply and step"), u"applyAndStepButton"_s, ask(applied)},
                    {tr("Step with &present gains"), u"stepWithoutButton"_s, ask(step)}},
                   window());
}

}  // namespace nmc
