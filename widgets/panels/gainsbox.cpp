// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/gainsbox.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QUndoStack>

#include "model/settings/startinggains.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

/// A change of what stands in the fields; it never reaches the motor. Typing in one field is one of them.
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

GainsBox::GainsBox(QWidget* parent) : QWidget(parent), m_hint(new QLabel(this)) {
    look::name(this, u"gainsBox"_s, tr("Gains"));
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
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
    // Below the buttons: it comes and goes, and nothing may move under the pointer.
    grid->addWidget(m_hint, ++line, 0, 1, 4);
    grid->setRowStretch(line + 1, 1);
    grid->setColumnStretch(3, 1);
    m_before = shown();
}

GainsBox::~GainsBox() {
    // On their way out they tell that nothing can be undone any more.
    for (QUndoStack* stack : std::as_const(m_undoStacks))
        stack->disconnect(this);
}

void GainsBox::addRow(Gain gain, int line, QGridLayout* grid) {
    Row& row = rowOf(gain);
    const QString letters = gainLetters(gain);
    row.gain = gain;
    row.label = new QLabel(u"%1  %2"_s.arg(letters, gainName(gain)), this);
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
}

void GainsBox::addSense(int line, QGridLayout* grid) {
    m_sense = new QComboBox(this);
    look::name(m_sense, u"clSenseBox"_s, tr("Sense of the current limit"));
    for (const CurrentSense sense : {CurrentSense::Off, CurrentSense::Above, CurrentSense::Below})
        m_sense->addItem(currentSenseName(sense), static_cast<int>(sense));
    m_sense->setToolTip(
        tr("Whether a large or a small A/D value means too much current. The chip tells them "
           "apart by odd and even numbers."));
    grid->addWidget(m_sense, line, 1, 1, 2);
    connect(m_sense, &QComboBox::activated, this, [this] { chooseSense(m_sense->currentData().toInt()); });
}

QPushButton* GainsBox::newButton(const QString& icon, const QString& text, const QString& objectName,
                                 const QString& name, const QString& toolTip) {
    auto* button = new QPushButton(icons::tinted(icon), text, this);
    look::name(button, objectName, name);
    button->setToolTip(toolTip);
    return button;
}

void GainsBox::addButtons(int line, QGridLayout* grid) {
    m_undo =
        newButton(u"arrow-back-up"_s, tr("Undo"), u"undoGainsButton"_s, tr("Undo the last edit of a gain"),
                  tr("Takes back the last edit in these fields (Ctrl+Z). Sends nothing."));
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo = newButton(u"arrow-forward-up"_s, tr("Redo"), u"redoGainsButton"_s, tr("Redo the edit of a gain"),
                       tr("Makes the edit again that was undone (Ctrl+Shift+Z). Sends nothing."));
    m_redo->setShortcut(QKeySequence::Redo);
    m_revert = newButton(u"repeat"_s, tr("Revert"), u"revertGainsButton"_s,
                         tr("Revert the gains to what was sent"), {});
    m_revert->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    m_zero =
        newButton(u"eraser"_s, tr("All zero"), u"zeroGainsButton"_s, tr("Fill in zero for all gains"),
                  tr("Fills the fields with 0, where tuning begins. Sends nothing; once applied, the motor "
                     "does not hold any more (Ctrl+0)."));
    m_zero->setShortcut(Qt::CTRL | Qt::Key_0);
    m_fill = newButton(u"wand"_s, tr("Start&ing values"), u"fillGainsButton"_s, tr("Fill in starting values"),
                       tr("Fills the fields with values to begin tuning with. Sends nothing."));
    m_apply = newButton(u"send"_s, tr("&Apply gains"), u"applyGainsButton"_s, tr("Apply all gains"), {});
    auto* step = newButton(u"player-play"_s, tr("Step response…"), u"openStepResponseButton"_s,
                           tr("Open the step response"),
                           tr("Opens the place where a small step shows how the motor follows (F9)."));
    connect(step, &QPushButton::clicked, this, &GainsBox::stepResponseWanted);
    const int unit = look::gridUnit(this);
    const auto addLine = [&](int at, std::initializer_list<QPushButton*> left,
                             std::initializer_list<QPushButton*> right) {
        auto* buttons = new QHBoxLayout;
        buttons->setSpacing(unit);
        buttons->setContentsMargins(0, unit / 2, 0, 0);
        for (QPushButton* button : left)
            buttons->addWidget(button);
        buttons->addStretch(1);
        for (QPushButton* button : right)
            buttons->addWidget(button);
        grid->addLayout(buttons, at, 0, 1, 4);
    };
    addLine(line, {m_fill, m_zero}, {m_undo, m_redo});
    addLine(line + 1, {step}, {m_revert, m_apply});
    connect(m_apply, &QPushButton::clicked, this, &GainsBox::apply);
    connect(m_revert, &QPushButton::clicked, this, &GainsBox::revert);
    connect(m_fill, &QPushButton::clicked, this, [this] { stage(startingGains(m_settings.unit)); });
    connect(m_zero, &QPushButton::clicked, this, [this] { fill(zeroValue); });
    connect(m_undo, &QPushButton::clicked, this, [this] { undoStack().undo(); });
    connect(m_redo, &QPushButton::clicked, this, [this] { undoStack().redo(); });
}

// ---- what stands in the fields ----

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
    for (Row& row : m_rows)
        row.field->showText(texts[static_cast<std::size_t>(row.gain)]);
    m_before = texts;
    keep();
    refresh();
}

QUndoStack& GainsBox::undoStack() {
    QUndoStack*& stack = m_undoStacks[m_module ? m_module->value() : -1];
    if (stack == nullptr) {
        stack = new QUndoStack(this);
        connect(stack, &QUndoStack::indexChanged, this, &GainsBox::refreshUndo);
    }
    return *stack;
}

void GainsBox::edited(std::optional<Gain> gain) {
    const Texts after = shown();
    if (after != m_before)
        undoStack().push(new Edit(*this, gain, m_before, after));
}

/// Drafts live here; gains that are whole are kept with the axis as well.
void GainsBox::keep() {
    if (!m_module)
        return;
    const Texts texts = shown();
    const std::optional<servo::SetGain> gains = entered();
    const bool changed = gains && gains != m_settings.gains;
    if (changed)
        m_settings.gains = gains;
    if (texts == textsOf(m_sent))
        m_drafts.remove(m_module->value());
    else
        m_drafts[m_module->value()] = {texts, m_settings.gains};
    if (changed)
        emit settingsEdited([gains](AxisSettings& axis) { axis.gains = gains; });
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
    const Texts texts = textsOf(m_sent);
    for (Row& row : m_rows)
        row.field->showText(texts[static_cast<std::size_t>(row.gain)]);
    edited(std::nullopt);
}

void GainsBox::chooseSense(int sense) {
    NumberField* field = rowOf(Gain::Cl).field;
    const int now = static_cast<int>(field->value().value_or(0.0));
    field->showValue(currentLimit(static_cast<CurrentSense>(sense), now));
    edited(std::nullopt);
}

void GainsBox::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    const bool another = m_module != module.info.index;
    const bool news = another || m_sent != module.gains || m_settings.gains != view.settings.gains;
    m_module = module.info.index;
    m_sent = module.gains;
    m_settings = view.settings;
    m_refused = view.whyNot(Request::ApplyGains);
    m_live = module.servoOn();
    m_hasDeadband = module.info.identity.version >= servo::kDeadbandVersion;
    if (news) {
        const int index = module.info.index.value();
        const auto typed = m_drafts.constFind(index);
        const bool overtaken = typed != m_drafts.constEnd() && typed->axis != m_settings.gains;
        if (overtaken)
            m_drafts.remove(index);
        const auto draft = m_drafts.constFind(index);
        const bool sentNow = !another && m_sent && shown() == textsOf(m_sent);
        const Texts texts = draft != m_drafts.constEnd() && !sentNow ? draft->texts
                            : m_settings.gains                       ? textsOf(m_settings.gains)
                                                                     : textsOf(m_sent);
        if (texts != shown())
            for (Row& row : m_rows)
                row.field->showText(texts[static_cast<std::size_t>(row.gain)]);
        if (overtaken && !another)
            edited(std::nullopt);  // what was typed comes back by Undo
        m_before = shown();
        if (m_before == textsOf(m_sent))
            m_drafts.remove(index);
    }
    refresh();
}

void GainsBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

std::optional<servo::SetGain> GainsBox::entered() const {
    servo::SetGain gains;
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
    if (m_refused.has_value() || m_busy)
        return;
    const std::optional<servo::SetGain> gains = entered();
    if (!gains)
        return;
    const QStringList steps = m_live && m_sent ? largeSteps(*m_sent, *gains) : QStringList();
    if (steps.isEmpty())
        emit applyRequested(*gains);
    else
        askBeforeLargeStep(*gains, steps);
}

/// The motor is under control of these gains at this moment: a large step may make it jump or swing.
void GainsBox::askBeforeLargeStep(const servo::SetGain& gains, const QStringList& steps) {
    // What was asked about, to the module it was asked for, on top of the gains that it was compared with.
    const auto text = [this, gains, steps, module = m_module, before = m_sent] {
        const bool same = module == m_module && before == m_sent && entered() == gains;
        const bool inSight = parentWidget()->isVisible();  // the module, on whichever page
        return same && inSight && m_live && !m_refused
                   ? tr("The servo is on, and this is a large step: %1. The motor may jump or swing.")
                         .arg(steps.join(u", "_s))
                   : QString();
    };
    AskDialog::ask({.name = u"largeStepDialog"_s,
                    .title = tr("Gains while the servo is on"),
                    .text = text,
                    .stay = tr("&Cancel"),
                    .stayName = u"cancelLargeStepButton"_s,
                    .stayIsDefault = true},
                   {{tr("&Apply these gains"), u"applyLargeStepButton"_s,
                     [this, gains] { emit applyRequested(gains); }}},
                   window());
}

// ---- how it looks ----

void GainsBox::refreshRow(Row& row) {
    const bool visible = used(row.gain);
    for (QWidget* widget : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.field),
                            static_cast<QWidget*>(row.remark), static_cast<QWidget*>(row.state)})
        widget->setVisible(visible);
    const std::optional<double> value = row.field->value();
    QString remark = value.has_value() ? gainRemark(row.gain, static_cast<int>(*value)) : QString();
    if (row.gain == Gain::Cl && value.value_or(0.0) != 0.0)
        remark = u"= "_s + texts::analog(m_settings.analog, static_cast<int>(*value));
    look::setText(row.remark, remark);
    const std::optional<int> sent = m_sent.has_value() ? gainOf(*m_sent, row.gain) : std::nullopt;
    Known known = Known::Edited;
    if (row.field->problem() == NumberField::Problem::Empty && !sent.has_value())
        known = Known::Unknown;
    else if (sent.has_value() && value.has_value() && static_cast<int>(*value) == *sent)
        known = Known::Sent;
    // Shape, then word: a check for sent, a dot for an edit, a question mark for what nobody knows.
    QString state;
    switch (known) {
        case Known::Unknown:
            state = tr("? unknown");
            break;
        case Known::Sent:
            state = tr("✓ sent");
            break;
        case Known::Edited:
            state = tr("● edited, not sent");
            break;
    }
    look::setText(row.state, state);
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
        return tr("Gains cannot be read back from the module. Until you apply them they are unknown.");
    if (const QString problem = trouble(); !problem.isEmpty())
        return problem;
    const auto rate = rowOf(Gain::Sr).field->value();
    if (!m_sent || !rate || static_cast<int>(*rate) == m_sent->sr)
        return {};
    return tr("SR %1 instead of %2 changes the servo tick: every velocity and acceleration in counts per "
              "tick "
              "means another speed then.")
        .arg(static_cast<int>(*rate))
        .arg(m_sent->sr);
}

void GainsBox::refreshApply(const QString& problem) {
    QString reason;
    if (m_refused.has_value())
        reason = texts::refusal(*m_refused);
    else if (m_busy)
        reason = tr("Waiting for the module's answer.");
    else
        reason = problem;
    look::setPossible(m_apply, reason,
                      m_live ? tr("Sends all gains at once. The servo is on: they act immediately.")
                             : tr("Sends all gains at once. The motor does not move."));
    const QString text = m_live ? tr("&Apply gains, live") : tr("&Apply gains");
    if (m_apply->text() != text)
        m_apply->setText(text);
}

void GainsBox::refreshUndo() {
    const QUndoStack& stack = undoStack();
    m_undo->setEnabled(stack.canUndo());
    m_redo->setEnabled(stack.canRedo());
    m_revert->setEnabled(m_module.has_value() && shown() != textsOf(m_sent));
    m_revert->setToolTip(m_sent.has_value()
                             ? tr("Back to the gains that were sent. Sends nothing.")
                             : tr("Empties the fields: no gains have been sent yet. Sends nothing."));
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
    refreshUndo();
}

}  // namespace nmc
