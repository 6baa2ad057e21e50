// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/gainsbox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

GainsBox::GainsBox(QWidget* parent)
    : QWidget(parent),
      m_hint(new QLabel(this)),
      m_apply(new QPushButton(tr("&Apply gains"), this)),
      m_revert(new QPushButton(tr("Revert"), this)),
      m_fill(new QPushButton(tr("Start&ing values"), this)) {
    look::name(this, u"gainsBox"_s, tr("Gains"));
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    int line = 0;
    for (Gain gain : kAllGains)
        addRow(gain, line++, grid);
    m_hint->setObjectName(u"gainsHint"_s);
    m_hint->setWordWrap(true);
    m_hint->setTextFormat(Qt::PlainText);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->setContentsMargins(0, unit / 2, 0, 0);
    buttons->addWidget(m_fill);
    buttons->addStretch(1);
    buttons->addWidget(m_revert);
    buttons->addWidget(m_apply);
    grid->addLayout(buttons, line++, 0, 1, 4);
    // Below the buttons: it comes and goes, and nothing may move under the pointer.
    grid->addWidget(m_hint, line++, 0, 1, 4);
    grid->setRowStretch(line, 1);
    grid->setColumnStretch(3, 1);

    look::name(m_apply, u"applyGainsButton"_s, tr("Apply all gains"));
    look::name(m_revert, u"revertGainsButton"_s, tr("Revert the gains to what was sent"));
    look::name(m_fill, u"fillGainsButton"_s, tr("Fill in starting values"));
    m_apply->setIcon(icons::tinted(u"send"_s));
    m_fill->setIcon(icons::tinted(u"wand"_s));
    m_revert->setIcon(icons::tinted(u"arrow-back-up"_s));
    m_fill->setToolTip(tr("Fills the fields with values to begin tuning with. Sends nothing."));
    m_revert->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    connect(m_apply, &QPushButton::clicked, this, &GainsBox::apply);
    connect(m_revert, &QPushButton::clicked, this, &GainsBox::revert);
    connect(m_fill, &QPushButton::clicked, this, &GainsBox::fillIn);
}

void GainsBox::addRow(Gain gain, int line, QGridLayout* grid) {
    Row& row = m_rows[static_cast<std::size_t>(gain)];
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
    row.state = look::newMutedLabel({}, this);
    row.state->setObjectName(letters.toLower() + u"State"_s);
    grid->addWidget(row.label, line, 0);
    grid->addWidget(row.field, line, 1);
    grid->addWidget(row.remark, line, 2);
    grid->addWidget(row.state, line, 3);
    connect(row.field, &NumberField::edited, this, [this] {
        keepDraft();
        refresh();
    });
}

void GainsBox::keepDraft() {
    if (!m_module.has_value())
        return;
    Draft& draft = m_drafts[m_module->value()];
    for (const Row& row : m_rows)
        draft[static_cast<std::size_t>(row.gain)] = row.field->text();
}

void GainsBox::showModule(const ModuleState& module, std::optional<Refusal> refused) {
    const bool other = m_module != module.info.index;
    const bool newlySent = m_sent != module.gains;
    m_module = module.info.index;
    m_sent = module.gains;
    m_refused = refused;
    m_live = module.servoOn();
    m_hasDeadband = module.info.identity.version >= servo::kDeadbandVersion;
    if (other) {
        const auto draft = m_drafts.constFind(module.info.index.value());
        for (Row& row : m_rows) {
            const QSignalBlocker blocker(row.field);
            row.field->showNothing();
            if (draft == m_drafts.constEnd())
                continue;
            NumberField::Problem problem = NumberField::Problem::None;
            const QString& text = (*draft)[static_cast<std::size_t>(row.gain)];
            if (const auto value = NumberField::parse(text, true, &problem))
                row.field->showValue(*value);
        }
        if (draft == m_drafts.constEnd() && m_sent.has_value())
            revert();
    } else if (newlySent && m_sent.has_value() && !m_drafts.contains(module.info.index.value())) {
        revert();
    }
    refresh();
}

void GainsBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void GainsBox::fillIn() {
    for (Row& row : m_rows)
        row.field->showValue(startingValue(row.gain));
    keepDraft();
    refresh();
}

void GainsBox::revert() {
    if (m_module.has_value())
        m_drafts.remove(m_module->value());
    for (Row& row : m_rows) {
        const std::optional<int> value = m_sent.has_value() ? gainOf(*m_sent, row.gain) : std::nullopt;
        if (value.has_value())
            row.field->showValue(*value);
        else
            row.field->showNothing();
    }
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
    if (const std::optional<servo::SetGain> gains = entered())
        emit applyRequested(*gains);
}

void GainsBox::refreshRow(Row& row) {
    const bool shown = used(row.gain);
    for (QWidget* widget : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.field),
                            static_cast<QWidget*>(row.remark), static_cast<QWidget*>(row.state)})
        widget->setVisible(shown);
    const std::optional<double> value = row.field->value();
    look::setText(row.remark, value.has_value() ? gainRemark(row.gain, static_cast<int>(*value)) : QString());
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

void GainsBox::refresh() {
    for (Row& row : m_rows)
        refreshRow(row);
    const QString problem = trouble();
    const bool anything = !problem.isEmpty() && !entered().has_value();
    bool empty = true;
    for (const Row& row : m_rows)
        empty = empty && (!used(row.gain) || row.field->problem() == NumberField::Problem::Empty);
    look::setText(
        m_hint, empty
                    ? tr("Gains cannot be read back from the module. Until you apply them they are unknown.")
                    : problem);
    m_hint->setVisible(anything);
    QString reason;
    if (m_refused.has_value())
        reason = texts::refusal(*m_refused);
    else if (m_busy)
        reason = tr("Waiting for the module's answer.");
    else
        reason = problem;
    m_apply->setEnabled(reason.isEmpty());
    m_apply->setToolTip(!reason.isEmpty() ? reason
                        : m_live ? tr("Sends all gains at once. The servo is on: they act immediately.")
                                 : tr("Sends all gains at once. The motor does not move."));
    m_apply->setAccessibleDescription(m_apply->toolTip());
    const QString text = m_live ? tr("&Apply gains, live") : tr("&Apply gains");
    if (m_apply->text() != text)
        m_apply->setText(text);
    m_revert->setEnabled(m_module.has_value() && m_drafts.contains(m_module->value()));
    m_revert->setToolTip(m_sent.has_value()
                             ? tr("Back to the gains that were sent. Sends nothing.")
                             : tr("Empties the fields: no gains have been sent yet. Sends nothing."));
}

}  // namespace nmc
