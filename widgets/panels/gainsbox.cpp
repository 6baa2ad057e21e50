// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/gainsbox.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPointer>
#include <QUndoStack>

#include "model/intent/gainsplan.h"
#include "model/settings/startinggains.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kTrySeconds = 10;
}  // namespace

/// An edit of the fields, which never reaches the motor. Edits of the same field in a row are merged into
/// one.
class GainsBox::Edit : public QUndoCommand {
public:
    Edit(GainsBox& box, std::optional<Gain> gain, Texts before, Texts after)
        : m_box(box), m_gain(gain), m_before(std::move(before)), m_after(std::move(after)) {}

    void undo() override { m_box.show(m_before); }
    void redo() override { m_box.show(m_after); }
    [[nodiscard]] int id() const override { return m_gain ? static_cast<int>(*m_gain) : -1; }
    bool mergeWith(const QUndoCommand* other) override {
        m_after = static_cast<const Edit*>(other)->m_after;
        return true;
    }

private:
    GainsBox& m_box;
    std::optional<Gain> m_gain;
    Texts m_before;
    Texts m_after;
};

GainsBox::GainsBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_hint(new QLabel(this)), m_edits(new QUndoStack(this)) {
    look::name(this, u"gainsBox"_s, tr("Gains"));
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit / 2);
    grid->setVerticalSpacing(unit / 3);
    int line = 0;
    for (Gain gain : kAllGains) {
        addRow(gain, line++, grid);
        if (gain == Gain::Cl)
            addSense(line++, grid);
    }
    addButtons(line++, grid);
    m_hint->setObjectName(u"gainsHint"_s);
    m_hint->setWordWrap(true);
    m_hint->setTextFormat(Qt::PlainText);
    // Below the buttons: the hint appears and disappears, and nothing may move under the pointer.
    grid->addWidget(m_hint, ++line, 0, 1, 4);
    grid->setRowStretch(line + 1, 1);
    grid->setColumnStretch(3, 1);
    m_kept = m_context.settings().gains;
    m_sent = m_context.state().gains;
    fillIn(textsOf(m_kept ? m_kept : m_sent));
    m_before = shown();
    connect(m_edits, &QUndoStack::indexChanged, this, &GainsBox::refreshUndo);
    m_context.whenSeen(this, [this] { showModule(); });
}

GainsBox::~GainsBox() {
    // While the undo stack is destroyed, it still emits indexChanged.
    m_edits->disconnect(this);
}

void GainsBox::fillIn(const Texts& texts) {
    for (Row& row : m_rows)
        row.field->showText(texts[static_cast<std::size_t>(row.gain)]);
}

bool GainsBox::used(Gain gain) const {
    return gain != Gain::Db || m_context.state().info.identity.version >= servo::kDeadbandVersion;
}

void GainsBox::addRow(Gain gain, int line, QGridLayout* grid) {
    Row& row = rowOf(gain);
    const QString letters = gainLetters(gain);
    row.gain = gain;
    row.label = new QLabel(this);
    row.field = new NumberField(0, this);
    look::name(row.field, letters.toLower() + u"Field"_s, u"%1, %2"_s.arg(letters, gainName(gain)));
    const ValueRange range = gainRange(gain);
    row.field->setRange(static_cast<double>(range.min), static_cast<double>(range.max));
    row.field->setWords(letters, {});
    row.field->setDigits(8);
    row.field->setMeaning(gainMeaning(gain));
    row.field->setPlaceholderText(tr("unknown"));
    row.label->setToolTip(gainMeaning(gain));
    row.label->setBuddy(row.field);
    row.remark = look::newMutedLabel({}, this);
    row.remark->setObjectName(letters.toLower() + u"Remark"_s);
    row.state = look::newMutedLabel({}, this);
    row.state->setObjectName(letters.toLower() + u"State"_s);
    grid->addWidget(row.label, line, 0);
    grid->addWidget(row.field, line, 1);
    grid->addWidget(row.remark, line, 2);
    grid->addWidget(row.state, line, 3);
    connect(row.field, &NumberField::edited, this, [this, gain] { edited(gain); });
    connect(row.field, &NumberField::returnPressed, this, [this] {
        if (m_apply->isEnabled())
            apply();
    });
}

void GainsBox::addSense(int line, QGridLayout* grid) {
    m_sense = new QComboBox(this);
    look::name(m_sense, u"clSenseBox"_s, tr("Sense of the current limit"));
    for (const CurrentSense sense : {CurrentSense::Off, CurrentSense::Above, CurrentSense::Below})
        m_sense->addItem(currentSenseName(sense), static_cast<int>(sense));
    m_sense->setToolTip(tr(
        "Whether a high or a low A/D value means overcurrent. The chip tells them apart by odd and even numbers."));
    grid->addWidget(m_sense, line, 1, 1, 3, Qt::AlignLeft);
    connect(m_sense, &QComboBox::activated, this, [this] { chooseSense(m_sense->currentData().toInt()); });
}

void GainsBox::addButtons(int line, QGridLayout* grid) {
    m_undo = new Command({.name = u"undoGainsButton"_s,
                          .icon = u"arrow-back-up"_s,
                          .text = tr("Undo"),
                          .accessible = tr("Undo the last edit of a gain"),
                          .key = QKeySequence::Undo},
                         this, [this] { m_edits->undo(); });
    m_redo = new Command({.name = u"redoGainsButton"_s,
                          .icon = u"arrow-forward-up"_s,
                          .text = tr("Redo"),
                          .accessible = tr("Redo the edit of a gain"),
                          .key = QKeySequence::Redo},
                         this, [this] { m_edits->redo(); });
    m_revert = new Command({.name = u"revertGainsButton"_s,
                            .icon = u"repeat"_s,
                            .text = tr("Revert"),
                            .accessible = tr("Revert the gains to those last sent"),
                            .key = Qt::CTRL | Qt::Key_R},
                           this, [this] { revert(); });
    auto* zero = new Command({.name = u"zeroGainsButton"_s,
                              .icon = u"eraser"_s,
                              .text = tr("All zero"),
                              .accessible = tr("All zero: fill in 0 for all gains"),
                              .key = Qt::CTRL | Qt::Key_0},
                             this, [this] { fill(zeroValue); });
    zero->setPossible(
        {},
        tr("Fills the fields with 0, to start tuning. Sends nothing. Once applied, the motor no longer holds."));
    auto* start = new Command({.name = u"fillGainsButton"_s,
                               .icon = u"wand"_s,
                               .text = tr("Start&ing values"),
                               .accessible = tr("Starting values: fill in")},
                              this, [this] { stage(startingGains(m_context.settings().unit)); });
    start->setPossible({}, tr("Fills in values to start tuning with. Sends nothing."));
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
                          .icon = {},
                          .text = tr("Keep them"),
                          .accessible = tr("Keep them: the gains being tried")},
                         this, [this] { m_context.ask(intent::KeepGains{}); });
    auto* step = new Command({.name = u"openStepResponseButton"_s,
                              .icon = u"player-play"_s,
                              .text = tr("Step response…"),
                              .accessible = tr("Step response: open")},
                             this, [this] { emit responseWanted(); });
    step->setPossible({},
                      tr("Opens the step response, which shows how the motor follows a small step (F9)."));
    m_buttons = {start, zero, m_undo, m_redo, step, m_revert, m_apply, m_try, m_keep};
    m_buttonGrid = new QGridLayout;
    m_buttonGrid->setSpacing(look::gridUnit(this) / 2);
    m_buttonGrid->setContentsMargins(0, look::gridUnit(this) / 2, 0, 0);
    grid->addLayout(m_buttonGrid, line, 0, 1, 4);
    nameRows(false);
    arrange(false);
}

void GainsBox::fitInto(int width) {
    if (!m_narrow)
        m_wideWidth = minimumSizeHint().width();
    const bool narrow = width < m_wideWidth;
    int names = 0;
    for (const Row& row : m_rows)
        names = qMax(names, row.label->fontMetrics().horizontalAdvance(fullName(row.gain)));
    const int unit = look::gridUnit(this);
    const int field = m_rows.front().field->sizeHint().width() + 2 * unit;
    nameRows(width < names + qMax(field, m_sense->sizeHint().width()) + 2 * unit);
    if (narrow == m_narrow)
        return;
    arrange(narrow);
    refresh();
}

QString GainsBox::fullName(Gain gain) {
    return u"%1  %2"_s.arg(gainLetters(gain), gainName(gain));
}

void GainsBox::nameRows(bool letters) {
    for (const Row& row : m_rows)
        look::setText(row.label, letters ? gainLetters(row.gain) : fullName(row.gain));
}

/// In a narrow column, marks replace words, and the buttons need more lines. The first line has what a first
/// session needs: a low window shows no more than that without scrolling.
void GainsBox::arrange(bool narrow) {
    m_narrow = narrow;
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

GainsBox::Texts GainsBox::shown() const {
    Texts texts;
    for (const Row& row : m_rows)
        texts[static_cast<std::size_t>(row.gain)] = row.field->text();
    return texts;
}

GainsBox::Texts GainsBox::textsOf(const std::optional<servo::SetGain>& gains) const {
    Texts texts;
    for (const Row& row : m_rows)
        if (const auto value = gains ? gainOf(*gains, row.gain) : std::nullopt)
            texts[static_cast<std::size_t>(row.gain)] = NumberField::format(*value, 0);
    return texts;
}

void GainsBox::show(const Texts& texts) {
    fillIn(texts);
    m_before = texts;
    keep();
    refresh();
}

void GainsBox::edited(std::optional<Gain> gain) {
    const Texts after = shown();
    if (after != m_before)
        m_edits->push(new Edit(*this, gain, m_before, after));
}

/// Keeps complete gains with the axis.
void GainsBox::keep() {
    m_typed = shown() != textsOf(m_sent);
    const std::optional<servo::SetGain> gains = entered();
    if (!gains || gains == m_kept)
        return;
    m_kept = gains;
    m_context.edit([gains](AxisSettings& axis) { axis.gains = gains; });
}

void GainsBox::fill(const std::function<std::optional<int>(Gain)>& value) {
    for (Row& row : m_rows)
        if (const std::optional<int> now = value(row.gain))
            row.field->showValue(*now);
    edited(std::nullopt);
}

void GainsBox::stage(const servo::SetGain& gains) {
    fill([&gains](Gain gain) { return gainOf(gains, gain); });
}

void GainsBox::revert() {
    fillIn(textsOf(m_sent));
    edited(std::nullopt);
}

void GainsBox::chooseSense(int sense) {
    NumberField* field = rowOf(Gain::Cl).field;
    const int now = static_cast<int>(field->value().value_or(0.0));
    field->showValue(currentLimit(static_cast<CurrentSense>(sense), now));
    edited(std::nullopt);
}

void GainsBox::showModule() {
    const auto& kept = m_context.settings().gains;
    std::optional<servo::SetGain> sent = m_context.state().gains;
    if (sent && m_tried && tries())
        sent->ol = m_tried->ol;          // it was lowered by the trial, not by the user
    const bool opened = kept != m_kept;  // another machine file replaces what was typed
    if (opened || sent != m_sent) {
        m_kept = kept;
        m_sent = sent;
        if (opened || !m_typed)
            fillIn(textsOf(kept ? kept : sent));
        if (opened && m_typed)
            edited(std::nullopt);  // so that Undo brings it back
        m_before = shown();
        m_typed = m_typed && !opened && m_before != textsOf(sent);
    }
    refresh();
}

std::optional<servo::SetGain> GainsBox::entered() const {
    servo::SetGain gains;
    // The step multiplier of an SC, which is set on its Amplifier page.
    if (const auto& known = m_kept ? m_kept : m_sent)
        gains.sm = known->sm;
    for (const Row& row : m_rows) {
        if (!used(row.gain))
            continue;
        const std::optional<double> value = row.field->value();
        if (!value.has_value())
            return std::nullopt;
        setGain(gains, row.gain, static_cast<int>(*value));
    }
    return gains;
}

QString GainsBox::trouble() const {
    for (const Row& row : m_rows)
        if (used(row.gain) && row.field->problem() != NumberField::Problem::None)
            return row.field->problemText();
    return {};
}

void GainsBox::apply() {
    const std::optional<servo::SetGain> gains = entered();
    if (!gains)
        return;
    const bool live = m_context.state().servoOn();
    const QStringList steps = live && m_sent ? largeSteps(*m_sent, *gains) : QStringList();
    if (steps.isEmpty())
        m_context.ask(intent::ApplyGains{*gains});
    else
        askBeforeLargeStep(*gains, steps);
}

/// The servo is on, so new gains take effect at once: a large change may make the motor jump or oscillate.
void GainsBox::askBeforeLargeStep(const servo::SetGain& gains, const QStringList& steps) {
    // The question stays while the gains in the fields and those of the module are the ones that it compares,
    // and the Gains page is visible.
    const auto text = [self = QPointer(this), gains, steps, before = m_sent] {
        const bool stands = self && self->parentWidget()->isVisible() &&
                            before == self->m_context.state().gains && self->entered() == gains &&
                            self->m_context.state().servoOn() &&
                            !self->m_context.whyNot(IntentKind::ApplyGains);
        return stands
                   ? tr("The servo is on, and this is a large change: %1. The motor may jump or oscillate.")
                         .arg(steps.join(u", "_s))
                   : QString();
    };
    const auto go = [self = QPointer(this), gains] {
        if (self)
            self->m_context.ask(intent::ApplyGains{gains});
    };
    AskDialog::ask({.name = u"largeStepDialog"_s,
                    .title = tr("Gains while the servo is on"),
                    .text = text,
                    .stay = tr("&Cancel"),
                    .stayName = u"cancelLargeStepButton"_s,
                    .stayIsDefault = true},
                   {{tr("&Apply these gains"), u"applyLargeStepButton"_s, go}}, window());
}

// ---- display ----

void GainsBox::refreshRow(Row& row) {
    const bool visible = used(row.gain);
    for (QWidget* widget : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.field),
                            static_cast<QWidget*>(row.remark), static_cast<QWidget*>(row.state)})
        widget->setVisible(visible && !(m_narrow && widget == row.remark));
    const std::optional<double> value = row.field->value();
    QString remark = value.has_value() ? gainRemark(row.gain, static_cast<int>(*value)) : QString();
    if (row.gain == Gain::Cl && value.value_or(0.0) != 0.0)
        remark = u"= "_s + texts::analog(m_context.settings().analog, static_cast<int>(*value));
    look::setText(row.remark, remark);
    const std::optional<int> sent = m_sent.has_value() ? gainOf(*m_sent, row.gain) : std::nullopt;
    Known known = Known::Edited;
    if (row.field->problem() == NumberField::Problem::Empty && !sent.has_value())
        known = Known::Unknown;
    else if (sent.has_value() && value.has_value() && static_cast<int>(*value) == *sent)
        known = Known::Sent;
    // A shape followed by words: a check mark for sent, a dot for an edit, a question mark for unknown.
    QString state;
    switch (known) {
        case Known::Unknown:
            state = tr("? unknown");
            break;
        case Known::Sent:
            state = tr("✓ sent");
            break;
        case Known::Edited:
            state = tr("● not sent");
            break;
    }
    look::setText(row.state, m_narrow ? state.section(u' ', 0, 0) : state);
    if (row.state->toolTip() != state)
        row.state->setToolTip(state);
    QFont font = this->font();
    font.setBold(known == Known::Edited);
    if (row.state->font().bold() != font.bold())
        row.state->setFont(font);
}

QString GainsBox::hint() const {
    bool empty = true;
    for (const Row& row : m_rows)
        empty = empty && (!used(row.gain) || row.field->problem() == NumberField::Problem::Empty);
    if (empty)
        return tr("Gains cannot be read back from the module. They are unknown until you apply them.");
    if (const QString problem = trouble(); !problem.isEmpty())
        return problem;
    const auto rate = rowOf(Gain::Sr).field->value();
    if (!m_sent || !rate || static_cast<int>(*rate) == m_sent->sr)
        return {};
    return tr("Changing SR from %2 to %1 changes the servo tick, and with it the meaning of every velocity and acceleration in counts per tick.")
        .arg(static_cast<int>(*rate))
        .arg(m_sent->sr);
}

void GainsBox::refreshApply(const QString& problem) {
    const bool live = m_context.state().servoOn();
    const QString reason = m_context.reasonNow(IntentKind::ApplyGains);
    m_apply->setPossible(reason.isEmpty() ? problem : reason,
                         live ? tr("Sends all gains at once. The servo is on: they take effect immediately.")
                              : tr("Sends all gains at once. The motor does not move."));
    m_apply->setText(live ? tr("&Apply live") : tr("&Apply gains"));
    m_apply->button()->setAccessibleName(live ? tr("Apply live: all gains") : tr("Apply gains: all"));
}

bool GainsBox::tries() const {
    const auto running = m_context.runningProcedure();
    return running && running->kind == ProcedureKind::TryGains;
}

void GainsBox::tryThem() {
    m_tried = entered();
    if (m_tried)
        m_context.ask(intent::TryGains{*m_tried, kTrySeconds});
}

void GainsBox::refreshTry(const QString& problem) {
    const std::optional<servo::SetGain> gains = entered();
    const auto refused =
        gains ? whyNot(intent::TryGains{*gains, kTrySeconds}, m_context.state()) : std::nullopt;
    QString reason = m_context.reasonNow(IntentKind::ApplyGains);
    if (reason.isEmpty())
        reason = !problem.isEmpty() ? problem
                 : tries()          ? tr("These gains are already being tried.")
                 : refused          ? texts::refusal(*refused)
                 : gains == m_sent  ? tr("The module already has these gains.")
                                    : QString();
    m_try->setPossible(
        reason,
        tr("Sends these gains and restores the previous ones after %1 s unless you keep them, or at once if the motor starts to oscillate.")
            .arg(kTrySeconds));
    m_keep->setPossible(tries() ? QString() : tr("No gains are being tried."),
                        tr("Keeps the gains that are being tried."));
}

void GainsBox::refreshUndo() {
    m_undo->setPossible(m_edits->canUndo() ? QString() : tr("Nothing to undo."),
                        tr("Undoes the last edit in these fields. Sends nothing."));
    m_redo->setPossible(m_edits->canRedo() ? QString() : tr("Nothing to redo."),
                        tr("Redoes the edit that was undone. Sends nothing."));
    m_revert->setPossible(shown() != textsOf(m_sent) ? QString() : tr("No changes to apply."),
                          m_sent ? tr("Restores the gains last sent. Sends nothing.")
                                 : tr("Clears the fields: no gains have been sent yet. Sends nothing."));
}

void GainsBox::refresh() {
    for (Row& row : m_rows)
        refreshRow(row);
    const auto limit = rowOf(Gain::Cl).field->value();
    m_sense->setEnabled(limit.has_value() || rowOf(Gain::Cl).field->text().isEmpty());
    m_sense->setCurrentIndex(
        m_sense->findData(static_cast<int>(currentSense(static_cast<int>(limit.value_or(0.0))))));
    const QString hint = this->hint();
    look::setText(m_hint, hint);
    m_hint->setVisible(!hint.isEmpty());
    refreshApply(trouble());
    refreshTry(trouble());
    refreshUndo();
}

}  // namespace nmc
