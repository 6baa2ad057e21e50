// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/repeatabilitybox.h"

#include <QLabel>
#include <cmath>

#include "model/intent/homingplan.h"
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
constexpr std::array kInputs{&HomingRecipe::onHomeSwitch, &HomingRecipe::onLimit1, &HomingRecipe::onLimit2,
                             &HomingRecipe::onIndex};
constexpr int kHomeSwitch = 0;  ///< index in kInputs
constexpr int kIndex = 3;
constexpr unsigned kFirstTimes = 10;
constexpr double kFastest = 50'000.0;  ///< steps/s; a servo's limit is lower
}  // namespace

RepeatabilityBox::RepeatabilityBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(tr("Repeatability and backlash"), parent),
      m_context(context),
      m_measure(new Command({.name = m_context.named(u"measureRepeatabilityButton"_s),
                             .text = tr("Measure"),
                             .accessible = tr("Measure repeatability and backlash")},
                            this, [this] { m_context.ask(wanted()); })),
      m_end(new Command({.name = m_context.named(u"endRepeatabilityButton"_s),
                         .text = Common::tr("Cancel"),
                         .accessible = tr("Cancel measuring the repeatability")},
                        this, [this] { m_context.ask(intent::CancelProcedure{}); })),
      m_use(new Command({.name = m_context.named(u"useBacklashButton"_s),
                         .text = tr("Use as backlash"),
                         .accessible = tr("Use as backlash of the axis")},
                        this, [this] { use(); })),
      m_result(form::newParagraph(m_context.named(u"repeatabilityResult"_s),
                                  tr("Result of the repeatability measurement"), this)) {
    look::name(this, m_context.named(u"repeatabilityBox"_s), tr("Repeatability and backlash"));
    buildFields();
    m_context.whenSeen(this, [this] { refresh(); });
}

void RepeatabilityBox::buildFields() {
    const ModuleIdentity chip = m_context.state().info.identity;
    QList<form::Option> inputs{{Common::tr("Limit 1"), 1}, {Common::tr("Limit 2"), 2}};
    if (chip.type == ModuleType::Stepper)
        inputs.prepend({Common::tr("Home switch"), kHomeSwitch});
    else
        inputs.append({Common::tr("Index"), kIndex});
    m_input = form::newChoice(
        {.name = m_context.named(u"repeatabilityInputBox"_s),
         .accessible = tr("Approach this input"),
         .options = inputs,
         .meaning = tr(
             "The motor approaches it from both sides. Direction, acceleration, search distance and time limit are those of the search for home.")},
        this);
    m_velocity = form::newQuantity(
        {.kind = QuantityField::Kind::Velocity,
         .name = m_context.named(u"repeatabilityVelocityField"_s),
         .accessible = tr("Velocity of the approach"),
         .words = Common::tr("Velocity"),
         .min = 1.0 / kFixedPointOne,
         .max = kFastest,
         .meaning = tr("Slower is more exact: the chip may read its inputs only once per servo tick.")},
        this);
    m_velocity->setScale(m_context.scale());
    m_velocity->showNative(firstRecipe(chip).velocity);
    m_times = form::newNumber({.name = m_context.named(u"repeatabilityTimesField"_s),
                               .accessible = tr("Times from each side"),
                               .min = kFewestApproaches,
                               .max = kMostApproaches,
                               .digits = 4,
                               .meaning = tr("Number of approaches from each side.")},
                              this);
    m_times->showValue(kFirstTimes);
    auto* grid = new FormGrid(this);
    grid->addRow(tr("Approach"), m_input);
    grid->addRow(Common::tr("Velocity"), m_velocity);
    grid->addRow(tr("Times"), m_times, {new QLabel(tr("from each side"), this)});
    grid->addWide(form::newLine(this, {nullptr, m_use->button(), m_end->button(), m_measure->button()}));
    grid->addWide(m_result);
    connect(m_input, &QComboBox::currentIndexChanged, this, &RepeatabilityBox::refresh);
    connect(m_velocity, &QuantityField::nativeEdited, this, &RepeatabilityBox::refresh);
    connect(m_times, &NumberField::edited, this, &RepeatabilityBox::refresh);
}

bool RepeatabilityBox::running() const {
    return m_context.runs(ProcedureKind::Repeatability);
}

intent::MeasureRepeatability RepeatabilityBox::wanted() const {
    const HomingRecipe search =
        m_context.settings().homing.value_or(firstRecipe(m_context.state().info.identity));
    HomingRecipe recipe{.reverse = search.reverse,
                        .velocity = m_velocity->native().value_or(0.0),
                        .acceleration = search.acceleration,
                        .travelLimit = search.travelLimit,
                        .timeLimit = search.timeLimit};
    recipe.*kInputs.at(form::chosen<std::size_t>(m_input)) = true;
    return {recipe, static_cast<unsigned>(m_times->value().value_or(0.0))};
}

QString RepeatabilityBox::whyNotNow() const {
    if (running())
        return tr("The measurement is running.");
    for (const NumberField* field : {static_cast<NumberField*>(m_velocity), m_times})
        if (const QString problem = field->problemText(); !problem.isEmpty())
            return problem;
    const QString reason = m_context.reasonFor(wanted());
    return reason.isEmpty() ? m_context.whyBusy() : reason;
}

double RepeatabilityBox::offered() const {
    return std::ceil(m_found->backlash + m_found->uncertainty);
}

QString RepeatabilityBox::whyNotUsed() const {
    if (running())
        return tr("The measurement is running.");
    if (!m_found)
        return tr("Measure first.");
    if (m_report->edges.index)
        return tr("An index does not show the backlash of the load.");
    if (m_found->backlash <= m_found->uncertainty)
        return tr("No backlash was found that exceeds its uncertainty.");
    if (m_context.settings().backlash.distance == offered())
        return tr("The axis has this backlash.");
    return m_context.whyLocked();
}

void RepeatabilityBox::use() {
    m_context.edit([counts = offered()](AxisSettings& axis) { axis.backlash.distance = counts; });
    refresh();
}

QString RepeatabilityBox::state() const {
    if (!m_report)
        return u"○ "_s + tr("Not measured in this connection.");
    if (m_report->failure)
        return u"▲ "_s + texts::repeatabilityFailure(*m_report->failure);
    const bool done = m_report->stage == ProcedureStage::Done;
    return (done ? u"✓ "_s : running() ? u"▶ "_s : u"○ "_s) + texts::procedureStage(*m_report);
}

QString RepeatabilityBox::amount(double counts) const {
    const AxisScale scale = m_context.scale();
    const QString text = texts::fixed(scale.distance(counts), texts::positionDecimals(scale) + 1) + u' ' +
                         texts::unitOf(scale);
    const QString unit = scale.steps() ? texts::unitSteps() : texts::unitCounts();
    return scale.native() ? text : u"%1 (%2 %3)"_s.arg(text, texts::fixed(counts, 1), unit);
}

QStringList RepeatabilityBox::found() const {
    if (!m_found)
        return {};
    const EdgeCaptures& edges = m_report->edges;
    const auto line = [this](const QString& text, const EdgeSpread& spread, std::size_t times) {
        return text.arg(texts::position(m_context.scale(), spread.mean), amount(spread.deviation),
                        amount(spread.range), texts::grouped(static_cast<qint64>(times)));
    };
    const bool turned = m_context.scale().reversed();
    const QString forward = tr("Forward, %4 times: mean %1, standard deviation %2, range %3");
    const QString reverse = tr("Reverse, %4 times: mean %1, standard deviation %2, range %3");
    QStringList lines{line(turned ? reverse : forward, m_found->forward, edges.forward.size()),
                      line(turned ? forward : reverse, m_found->reverse, edges.reverse.size())};
    const QString words = edges.index ? tr("Difference: %1 ± %2") : tr("Backlash: %1 ± %2");
    lines << words.arg(amount(m_found->backlash), amount(m_found->uncertainty));
    if (edges.index)
        lines << tr(
            "The index is on the encoder's own shaft: this shows how well a capture repeats, not the backlash of the load.");
    else if (m_found->backlash < -m_found->uncertainty)
        lines << tr("Below zero, so this is not backlash. The switch may bounce.");
    else
        lines << tr(
            "Includes the hysteresis of the switch itself. Only with the encoder on the motor and the switch on the load does it show the backlash between them.");
    if (edges.perReading > 1.0)
        lines << tr("The motor moves up to %1 between two readings of the inputs. Measure more slowly.")
                     .arg(amount(edges.perReading));
    return lines;
}

void RepeatabilityBox::refresh() {
    m_report = m_context.connected() ? m_context.procedure(ProcedureKind::Repeatability) : std::nullopt;
    m_found = m_report ? repeatabilityOf(m_report->edges) : std::nullopt;
    m_velocity->setScale(m_context.scale());
    m_measure->setPossible(
        whyNotNow(),
        tr("Moves the motor to and fro across the switch or index, and reads where it was captured."));
    m_end->setPossible(running() ? QString() : tr("No measurement is running."),
                       tr("Stops the motor smoothly; what was captured stays."));
    const QString reason = whyNotUsed();
    m_use->setPossible(
        reason,
        reason.isEmpty()
            ? tr("Makes %1 the backlash of the axis (Axis page): what was measured, with its uncertainty. Sends nothing.")
                  .arg(amount(offered()))
            : QString());
    look::setText(m_result, (QStringList{state()} + found()).join(u'\n'));
}

}  // namespace nmc
