// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/modelbox.h"

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <algorithm>

#include "model/intent/looptestplan.h"
#include "model/tuning/nextsteps.h"
#include "widgets/common/form.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/words.h"
#include "widgets/response/modelwords.h"
#include "widgets/response/responseform.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kSliderSteps = 100;
constexpr int kMotorLines = 5;
constexpr int kSuggestionLines = 5;
}  // namespace

ModelBox::ModelBox(const std::vector<KeptResponse>& runs, ResponseForm& form, Requests& requests,
                   QWidget* parent)
    : QWidget(parent), m_form(form), m_runs(runs), m_requests(requests), m_margin(LoopWish{}.phaseMargin) {
    look::name(this, u"modelBox"_s, tr("Motor model"));
    m_identify = new QPushButton(icons::tinted(u"wand"_s), tr("Find motor model"), this);
    look::name(m_identify, u"identifyButton"_s, tr("Find motor model from the steps"));
    m_motor = form::newParagraph(u"motorModel"_s, tr("Motor model found"), this, kMotorLines);
    m_fill =
        form::newPush({u"fillSuggestedButton"_s, tr("Fill in"), tr("Fill in the suggested gains")}, this);
    m_suggested = form::newParagraph(u"suggestedGains"_s, tr("Suggested gains"), this, kSuggestionLines);
    auto* grid = new FormGrid(this, 2, {.sides = 0.5, .across = form::kUsual});
    // A separate button: Find sends nothing, and clicking it twice must not move a motor.
    m_steps = new QPushButton(icons::tinted(u"player-play"_s), {}, this);
    m_steps->setObjectName(u"stepAndFindButton"_s);
    connect(m_steps, &QPushButton::clicked, this, [this] { m_form.step(nextSteps()); });
    connect(&m_form, &ResponseForm::edited, this, &ModelBox::refreshButtons);
    grid->addWide(form::newLine(this, {m_identify, m_steps, nullptr}, form::kUsual));
    grid->addWide(m_motor);
    m_stiffness = newSlider(
        u"stiffnessSlider"_s, tr("Stiff"),
        tr("How fast the motor follows. Far right: as fast as noise, output limit and stability permit."),
        LoopWish{}.stiffness);
    m_damping = newSlider(u"dampingSlider"_s, tr("Damped"), tr("Damping. Far right: no overshoot."),
                          LoopWish{}.damping);
    m_noise = newSlider(u"noiseSlider"_s, tr("Loud"),
                        tr("How much encoder noise may drive the motor through Kd."), LoopWish{}.noise);
    for (QSlider* slider : {m_stiffness, m_damping, m_noise})
        grid->addRow(slider->accessibleName(), slider)->setToolTip(slider->toolTip());
    m_phase = new NumberField(0, this);
    look::name(m_phase, u"phaseMarginField"_s, tr("Phase margin"));
    m_phase->setWords(tr("The phase margin"), tr("°"));
    m_phase->setRange(kMinPhaseMargin, kMaxPhaseMargin);
    m_phase->setMeaning(tr(
        "How far the suggested loop is from oscillating, at least. 30°: fast, rings. 45° to 60°: moderate."));
    m_phase->showValue(m_margin);
    m_phase->setDigits(3);
    auto* atLeast = form::newLine(this, {m_phase, new QLabel(tr("° at least"), this), nullptr}, form::kUsual);
    grid->addTitled(tr("Phase margin"), atLeast)->setBuddy(m_phase);
    connect(m_phase, &NumberField::edited, this, [this] {
        if (const auto margin = m_phase->value()) {
            m_margin = *margin;
            suggest();
        }
    });
    grid->addWide(m_suggested);
    grid->addWide(form::newLine(this, {m_fill, nullptr}));
    grid->end();
    grid->setColumnStretch(1, 1);
    connect(m_identify, &QPushButton::clicked, this, [this] {
        if (m_servo)
            find(*m_servo);
    });
    connect(m_fill, &QPushButton::clicked, this, [this] {
        if (m_suggestion.gains)
            emit m_requests.stageGains(*m_suggestion.gains);
    });
    refresh();
}

QSlider* ModelBox::newSlider(const QString& objectName, const QString& text, const QString& meaning,
                             double first) {
    auto* slider = new QSlider(Qt::Horizontal, this);
    look::name(slider, objectName, text);
    slider->setToolTip(meaning);
    slider->setRange(0, kSliderSteps);
    slider->setValue(qRound(first * kSliderSteps));
    slider->setPageStep(kSliderSteps / 10);
    connect(slider, &QSlider::valueChanged, this, &ModelBox::suggest);
    return slider;
}

std::vector<const KeptResponse*> ModelBox::runsOf(std::optional<ModuleIndex> module) const {
    std::vector<const KeptResponse*> mine;
    for (const KeptResponse& kept : m_runs)
        if (module == kept.run.module && !kept.earlier && !kept.run.taken.isMove())
            mine.push_back(&kept);
    if (mine.size() > kMaxRuns)
        mine.erase(mine.begin(), mine.end() - kMaxRuns);
    return mine;
}

const ModelBox::Found* ModelBox::found(std::optional<ModuleIndex> module) const {
    const auto entry = module ? m_found.find(*module) : m_found.end();
    return entry != m_found.end() ? &entry->second : nullptr;
}

std::vector<std::int32_t> ModelBox::nextSteps() const {
    std::vector<std::int32_t> made;
    const std::vector<const KeptResponse*> mine = runsOf(m_servo);
    for (const KeptResponse* kept : mine)
        made.push_back(kept->run.taken.goal - kept->run.taken.from);
    const Found* found = this->found();
    const bool unsure = found != nullptr && found->motor && !found->motor->motor.isSure();
    if (unsure && informative(made) && mine.back()->number == found->from)
        return {nextStep(made)};
    return stepSeries(m_form.distance().value_or(0));
}

void ModelBox::find(ModuleIndex module) {
    const std::vector<const KeptResponse*> its = runsOf(module);
    if (its.empty())
        return;
    if (m_looking) {
        m_waiting.insert(module);
        return;
    }
    std::vector<ResponseRecord> runs;
    for (const KeptResponse* kept : its)
        runs.push_back(kept->run);
    m_looking = Looking{module, its.back()->number};
    m_found.erase(module);
    suggest();
    emit m_requests.identify(module, runs);
}

void ModelBox::showMotor(ModuleIndex module, const FoundMotor& found) {
    if (!m_looking || m_looking->module != module)
        return;  // it is of the last connection
    m_found.insert_or_assign(module, Found{found, m_looking->from});
    m_looking.reset();
    suggest();
    while (!m_looking && !m_waiting.empty())
        find(m_waiting.extract(m_waiting.begin()).value());
}

void ModelBox::forget() {
    m_found.clear();
    m_looking.reset();
    m_waiting.clear();
    suggest();
}

void ModelBox::showModule(const PanelView& view) {
    const auto servo = view.module.isServo() ? std::optional(view.module.info.index) : std::nullopt;
    const bool news = servo != m_servo || view.gains() != m_gains;
    m_servo = servo;
    m_gains = view.gains();
    m_locked = texts::whyLocked(view.module);
    if (news)
        suggest();
    else
        refreshButtons();
}

void ModelBox::showNothing() {
    if (!m_servo)
        return;
    m_servo.reset();
    m_gains.reset();
    suggest();
}

void ModelBox::showRuns() {
    suggest();
}

void ModelBox::renumber(int by) {
    for (auto& [module, found] : m_found)
        found.from += by;
    if (m_looking)
        m_looking->from += by;
}

void ModelBox::suggest() {
    m_suggestion = {};
    m_fitted.clear();
    m_about.reset();
    const int id = ++m_asked;
    if (const Found* found = this->found(); found != nullptr && found->motor) {
        const auto last = std::ranges::find(m_runs, found->from, &KeptResponse::number);
        if (last != m_runs.end()) {
            const auto part = [](const QSlider* slider) {
                return static_cast<double>(slider->value()) / kSliderSteps;
            };
            m_about = found->from;
            m_fitted = found->motor->runs.back();
            emit m_requests.suggest(
                {id,
                 found->motor->motor,
                 {part(m_stiffness), part(m_damping), part(m_noise),
                  found->motor->motor.isSure() ? m_margin : std::max(m_margin, kCarefulPhaseMargin)},
                 m_gains.value_or(last->run.taken.gains),
                 last->run.taken,
                 last->run.bandPercent});
        }
    }
    refresh();
    emit curvesChanged();
}

bool ModelBox::suggesting() const {
    return m_about && m_suggestion.id != m_asked;
}

void ModelBox::showSuggestion(const Suggestion& suggestion) {
    if (suggestion.id != m_asked)
        return;
    m_suggestion = suggestion;
    refresh();
    emit curvesChanged();
}

const Prediction* ModelBox::prediction() const {
    return m_suggestion.prediction ? &*m_suggestion.prediction : nullptr;
}

void ModelBox::refresh() {
    look::setPossible(
        m_identify,
        m_looking                 ? tr("The motor model is being calculated.")
        : runsOf(m_servo).empty() ? tr("Record a step with this module first.")
                                  : QString(),
        tr("Calculates the motor model from up to %1 recent steps of this module. Sends nothing.")
            .arg(kMaxRuns));
    refreshButtons();
    for (QSlider* slider : {m_stiffness, m_damping, m_noise})
        slider->setEnabled(found() != nullptr && found()->motor.has_value());
    m_phase->setEnabled(m_noise->isEnabled());
    showWords();
}

void ModelBox::refreshButtons() {
    look::setPossible(m_fill,
                      !m_locked.isEmpty()  ? m_locked
                      : m_suggestion.gains ? QString()
                      : suggesting()       ? tr("The suggested gains are being calculated.")
                                           : tr("No suggested gains. Find the motor model first."),
                      tr("Copies the suggested gains to the Gains page. Sends nothing."));
    const std::vector<std::int32_t> steps = nextSteps();
    const bool one = steps.size() == 1;
    const QString words =
        one ? tr("Step once more and find model") : tr("Step %1 times and find model").arg(steps.size());
    m_steps->setText(words);
    m_steps->setAccessibleName(words);
    look::setPossible(
        m_steps, m_form.whyNotNow(steps),
        one ? tr("The motor jumps once more, as far as before; the model is then found from the recent steps. Make sure that everything it drives can move freely.")
            : tr("The motor jumps by the distance of the step and back, then twice as far and back, but no farther than %1 and %2 counts; the model is then found from these steps. Make sure that everything it drives can move freely.")
                  .arg(kLongestStep / 2)
                  .arg(kLongestStep));
}

QStringList ModelBox::motorWords(ModuleIndex module) const {
    const Found* found = this->found(module);
    return found != nullptr && found->motor ? texts::motorFound(*found->motor) : QStringList();
}

void ModelBox::showWords() {
    const Found* found = this->found();
    look::setText(m_motor, m_looking && m_looking->module == m_servo ? tr("Calculating the motor model…")
                           : found == nullptr                        ? QString()
                           : found->motor ? texts::motorFound(*found->motor).join(u'\n')
                                          : texts::motorNotFound(found->motor.error()));
    QString words;
    if (m_suggestion.gains && m_suggestion.prediction)
        words = texts::gainsInShort(*m_suggestion.gains) + u'\n' +
                texts::predicted(*m_suggestion.prediction).join(u'\n');
    else if (found != nullptr && found->motor)
        words = suggesting() ? tr("Calculating the suggested gains…")
                : m_about    ? tr("No gains keep this motor stable and quiet.")
                             : tr("The run behind this model was removed. Find the motor model again.");
    look::setText(m_suggested, words);
}

}  // namespace nmc
