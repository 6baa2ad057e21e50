// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/gainsbox.h"

#include <QLabel>

#include "model/intent/gainsplan.h"
#include "model/settings/startinggains.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kTrySeconds = 10;
}  // namespace

GainsBox::GainsBox(ModuleContext& context, QWidget* parent)
    : StagedForm(context,
                 {.what = u"Gains"_s,
                  .undo = tr("Undo the last edit of a gain"),
                  .redo = tr("Redo the last undone edit of a gain"),
                  .revert = tr("Revert the gains to those last sent"),
                  .sentOnes = tr("Restores the gains last sent. Sends nothing."),
                  .none = tr("Clears the fields: no gains have been sent yet. Sends nothing.")},
                 parent) {
    look::name(this, u"gainsBox"_s, Common::tr("Gains"));
    auto* grid = new FormGrid(this, 4, {.ends = 1, .across = 0.5});
    for (const Gain gain : kAllGains) {
        const GainFacts facts = gainFacts(gain);
        const QString object = facts.letters.toLower();
        const QString meaning =
            facts.meaning + u'\n' + tr("Range: %1 to %2.").arg(facts.range.min).arg(facts.range.max);
        addField(grid, {object, fullName(gain), meaning},
                 form::newNumber({.name = object + u"Field"_s,
                                  .accessible = u"%1, %2"_s.arg(facts.letters, facts.name),
                                  .words = facts.letters,
                                  .min = static_cast<double>(facts.range.min),
                                  .max = static_cast<double>(facts.range.max),
                                  .digits = 8,
                                  .meaning = meaning},
                                 this));
        if (gain == Gain::Cl)
            addSense(grid);
    }
    addButtons(grid);
    // Below the buttons: the hint appears and disappears, and nothing may move under the pointer.
    grid->addWide(hint());
    grid->end();
    begin(*m_apply);
}

void GainsBox::addSense(FormGrid* grid) {
    m_sense = form::newChoice(
        {.name = u"clSenseBox"_s,
         .accessible = tr("Sense of the current limit"),
         .options = {{tr("no current limit"), static_cast<int>(CurrentSense::Off)},
                     {tr("limits above (odd)"), static_cast<int>(CurrentSense::Above)},
                     {tr("limits below (even)"), static_cast<int>(CurrentSense::Below)}},
         .meaning = tr(
             "Whether a high or a low A/D value means overcurrent. The chip distinguishes them by odd and even values.")},
        this);
    grid->addWidget(m_sense, grid->row(), 1, 1, 3, Qt::AlignLeft);
    grid->addLine({});
    connect(m_sense, &QComboBox::activated, this, &GainsBox::chooseSense);
}

void GainsBox::addButtons(FormGrid* grid) {
    buildCommands();
    m_zero = new Command({.name = u"zeroGainsButton"_s,
                          .icon = u"eraser"_s,
                          .text = tr("All zero"),
                          .accessible = tr("All zero: fill in 0 for all gains"),
                          .key = Qt::CTRL | Qt::Key_0},
                         this, [this] { fillWith(zeroValue); });
    m_start = new Command({.name = u"fillGainsButton"_s,
                           .icon = u"wand"_s,
                           .text = Common::tr("Start&ing values"),
                           .accessible = Common::tr("Starting values: fill in")},
                          this, [this] { stage(startingGains(context().settings().unit)); });
    m_apply = new Command({.name = u"applyGainsButton"_s,
                           .icon = u"send"_s,
                           .text = tr("&Apply gains"),
                           .accessible = tr("Apply gains: all")},
                          this, [this] { apply(); });
    m_try = new Command({.name = u"tryGainsButton"_s,
                         .icon = u"wand"_s,
                         .text = tr("Try for %1 s").arg(kTrySeconds),
                         .accessible = tr("Try for %1 s: these gains").arg(kTrySeconds)},
                        this, [this] { tryThem(); });
    m_keep = new Command({.name = u"keepGainsButton"_s,
                          .text = tr("Keep gains"),
                          .accessible = tr("Keep gains: those being tried")},
                         this, [this] { context().ask(intent::KeepGains{}); });
    auto* step = new Command({.name = u"openStepResponseButton"_s,
                              .icon = u"player-play"_s,
                              .text = tr("Step response…"),
                              .accessible = tr("Step response: open")},
                             this, [this] { emit responseWanted(); });
    step->setPossible({},
                      tr("Opens the step response, which shows how the motor follows a small step (F9)."));
    m_buttons = {m_start,         m_zero,  undoCommand(), redoCommand(), step,
                 revertCommand(), m_apply, m_try,         m_keep};
    m_buttonGrid = new QGridLayout;
    m_buttonGrid->setSpacing(look::gridUnit(this) / 2);
    m_buttonGrid->setContentsMargins(0, look::gridUnit(this) / 2, 0, 0);
    grid->addWide(m_buttonGrid);
    arrange();
}

void GainsBox::fitInto(int width) {
    StagedForm::fitInto(width);
    int names = 0;
    for (const Gain gain : kAllGains)
        names = qMax(names, fontMetrics().horizontalAdvance(fullName(gain)));
    const int unit = look::gridUnit(this);
    const int controls =
        qMax(fieldOf(Gain::Kp).control->sizeHint().width() + 2 * unit, m_sense->sizeHint().width());
    // If there is very little room, letters replace names.
    const bool letters = width < names + controls + 2 * unit;
    for (const Gain gain : kAllGains)
        look::setText(fieldOf(gain).label, letters ? gainLetters(gain) : fullName(gain));
}

QString GainsBox::fullName(Gain gain) {
    const GainFacts facts = gainFacts(gain);
    return u"%1  %2"_s.arg(facts.letters, facts.name);
}

/// In a narrow column, marks replace words, and the buttons need more lines. The first line has what a first
/// session needs: a low window shows no more than that without scrolling.
void GainsBox::arrange() {
    const bool narrow = this->narrow();
    struct Place {
        int line, column;
    };
    constexpr std::array<Place, 9> kWidePlaces{
        {{0, 0}, {0, 1}, {2, 3}, {2, 4}, {1, 0}, {0, 3}, {0, 4}, {1, 3}, {1, 4}}};
    constexpr std::array<Place, 9> kNarrowPlaces{
        {{0, 0}, {2, 0}, {3, 0}, {3, 1}, {4, 0}, {2, 1}, {0, 1}, {1, 0}, {1, 1}}};
    m_buttonGrid->setSpacing(look::gridUnit(this) / 3);
    const int side = look::gridUnit(this) / 2;
    layout()->setContentsMargins(side, look::gridUnit(this) / (narrow ? 3 : 1), side, 0);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const Place& place = narrow ? kNarrowPlaces[i] : kWidePlaces[i];
        // In a narrow column, the last button has a line to itself.
        const int columns = narrow && place.line == 4 ? 2 : 1;
        m_buttonGrid->addWidget(m_buttons[i]->button(), place.line, place.column, 1, columns);
    }
    m_buttonGrid->setColumnStretch(2, 1);
}

// ---- contents of the fields ----

bool GainsBox::used(std::size_t field) const {
    return kAllGains.at(field) != Gain::Db ||
           context().state().info.identity.version >= servo::kDeadbandVersion;
}

std::optional<StagedForm::Values> GainsBox::valuesOf(const std::optional<servo::SetGain>& gains) const {
    if (!gains)
        return std::nullopt;
    Values values;
    for (std::size_t i = 0; i < kAllGains.size(); ++i)
        values.push_back(used(i) ? gainOf(*gains, kAllGains.at(i)) : std::nullopt);
    return values;
}

std::optional<StagedForm::Values> GainsBox::kept() const {
    return valuesOf(context().settings().gains);
}

std::optional<servo::SetGain> GainsBox::sentGains() const {
    std::optional<servo::SetGain> gains = context().state().gains;
    if (gains && m_tried && tries())
        gains->ol = m_tried->ol;  // it was lowered by the trial, not by the user
    return gains;
}

std::optional<StagedForm::Values> GainsBox::sent() const {
    return valuesOf(sentGains());
}

std::optional<servo::SetGain> GainsBox::gains() const {
    if (!complete())
        return std::nullopt;
    servo::SetGain gains;
    // The step multiplier of an SC, which is set on its Amplifier page.
    if (const auto& known = context().settings().gains ? context().settings().gains : context().state().gains)
        gains.sm = known->sm;
    const Values values = entered();
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            setGain(gains, kAllGains.at(i), *values[i]);
    return gains;
}

void GainsBox::keep() {
    context().edit([gains = gains()](AxisSettings& axis) { axis.gains = gains; });
}

void GainsBox::fillWith(const std::function<std::optional<int>(Gain)>& value) {
    Values values;
    for (const Gain gain : kAllGains)
        values.push_back(value(gain));
    fill(values);
}

void GainsBox::stage(const servo::SetGain& gains) {
    fillWith([&gains](Gain gain) { return gainOf(gains, gain); });
}

void GainsBox::chooseSense() {
    Values values(kAllGains.size());
    const int now = fieldOf(Gain::Cl).value().value_or(0);
    values.at(static_cast<std::size_t>(Gain::Cl)) = currentLimit(form::chosen<CurrentSense>(m_sense), now);
    fill(values);
}

void GainsBox::apply() {
    const std::optional<servo::SetGain> gains = this->gains();
    if (!gains)
        return;
    const auto sent = sentGains();
    const QStringList steps = sent ? largeSteps(*sent, *gains) : QStringList();
    if (context().state().servoOn() && (!sent || !steps.isEmpty()))
        askBeforeLargeStep(*gains, steps);
    else
        context().ask(intent::ApplyGains{*gains});
}

/// The servo is on, so new gains take effect at once: a large change may make the motor jump or oscillate.
/// `steps` is empty if the gains of the module are unknown, so that any change may be large.
void GainsBox::askBeforeLargeStep(const servo::SetGain& gains, const QStringList& steps) {
    // The question stays while the gains in the fields and those of the module are the ones that it compares,
    // and the Gains page is visible.
    const auto text = [this, gains, steps, before = context().state().gains] {
        const bool stands = parentWidget()->isVisible() && before == context().state().gains &&
                            this->gains() == gains && context().state().servoOn() &&
                            !context().whyNot(IntentKind::ApplyGains);
        if (!stands)
            return QString();
        return steps.isEmpty()
                   ? tr("The servo is on, and the gains in the module are unknown, so this may be a large change. The motor may jump or oscillate.")
                   : tr("The servo is on, and this is a large change: %1. The motor may jump or oscillate.")
                         .arg(steps.join(u", "_s));
    };
    const auto go = [this, gains] { context().ask(intent::ApplyGains{gains}); };
    AskDialog::ask({.name = u"largeStepDialog"_s,
                    .title = tr("Gains while the servo is on"),
                    .text = text,
                    .stayName = u"cancelLargeStepButton"_s},
                   {{tr("&Apply these gains"), u"applyLargeStepButton"_s, go}}, this);
}

// ---- display ----

QString GainsBox::remark(std::size_t field, const std::optional<int>& value) const {
    const Gain gain = kAllGains.at(field);
    if (narrow())
        return {};
    if (gain == Gain::Cl && value.value_or(0) != 0)
        return u"= "_s + texts::analog(context().settings().analog, *value);
    return value ? gainRemark(gain, *value) : QString();
}

QString GainsBox::hintText() const {
    if (unknown())
        return tr("Gains cannot be read back from the module. They are unknown until you apply them.");
    if (const QString problem = trouble(); !problem.isEmpty())
        return problem;
    const auto rate = fieldOf(Gain::Sr).value();
    const auto& sent = context().state().gains;
    if (!sent || !rate || *rate == sent->sr)
        return {};
    return tr("Changing SR from %2 to %1 changes the servo tick, and with it the meaning of every velocity and acceleration in counts per tick.")
        .arg(*rate)
        .arg(sent->sr);
}

void GainsBox::refreshApply(const QString& problem) {
    const bool live = context().state().servoOn();
    const QString reason = context().reasonNow(IntentKind::ApplyGains);
    m_apply->setPossible(reason.isEmpty() ? problem : reason,
                         live ? tr("Sends all gains at once. The servo is on: they take effect immediately.")
                              : tr("Sends all gains at once. The motor does not move."));
    m_apply->setText(live ? tr("&Apply live") : tr("&Apply gains"));
    m_apply->button()->setAccessibleName(live ? tr("Apply live: all gains") : tr("Apply gains: all"));
}

bool GainsBox::tries() const {
    const auto running = context().runningProcedure();
    return running && running->tries();
}

void GainsBox::tryThem() {
    m_tried = gains();
    if (m_tried)
        context().ask(intent::TryGains{*m_tried, kTrySeconds});
}

void GainsBox::refreshTry(const QString& problem) {
    const std::optional<servo::SetGain> gains = this->gains();
    const auto refused =
        gains ? whyNot(intent::TryGains{*gains, kTrySeconds}, context().state()) : std::nullopt;
    QString reason = context().reasonNow(IntentKind::ApplyGains);
    if (reason.isEmpty())
        reason = !problem.isEmpty()                 ? problem
                 : tries()                          ? tr("These gains are already being tried.")
                 : refused                          ? texts::refusal(*refused)
                 : gains == context().state().gains ? tr("The module already has these gains.")
                                                    : QString();
    m_try->setPossible(
        reason,
        tr("Sends these gains and restores the previous ones after %1 s unless you keep them, or at once if the motor starts to oscillate.")
            .arg(kTrySeconds));
    const auto running = context().runningProcedure();
    const bool sent = running && running->stage == ProcedureStage::Trying;
    m_keep->setPossible(sent ? context().reasonFor(intent::KeepGains{}) : tr("No gains are being tried."),
                        tr("Keeps the gains that are being tried."));
}

void GainsBox::refreshRest() {
    const Field& limit = fieldOf(Gain::Cl);
    m_sense->setEnabled(limit.value() || limit.number->text().isEmpty());
    form::choose(m_sense, currentSense(limit.value().value_or(0)));
    const QString text = hintText();
    look::setText(hint(), text);
    hint()->setVisible(!text.isEmpty());
    const QString locked = context().whyLocked();
    m_zero->setPossible(
        locked,
        tr("Fills the fields with 0, to start tuning. Sends nothing. Once applied, the motor no longer holds."));
    m_start->setPossible(locked, tr("Fills in values to start tuning with. Sends nothing."));
    refreshApply(trouble());
    refreshTry(trouble());
}

}  // namespace nmc
