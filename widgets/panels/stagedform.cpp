// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stagedform.h"

#include <QCheckBox>
#include <QLabel>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

/// An edit of the fields, which never reaches the motor. Edits of the same field in a row are merged into
/// one.
class StagedForm::Edit : public QUndoCommand {
public:
    Edit(StagedForm& form, std::optional<std::size_t> field, Contents before, Contents after)
        : m_form(form), m_field(field), m_before(std::move(before)), m_after(std::move(after)) {}

    void undo() override { m_form.show(m_before); }
    void redo() override { m_form.show(m_after); }
    [[nodiscard]] int id() const override { return m_field ? static_cast<int>(*m_field) : -1; }
    bool mergeWith(const QUndoCommand* other) override {
        m_after = static_cast<const Edit*>(other)->m_after;
        return true;
    }

private:
    StagedForm& m_form;
    std::optional<std::size_t> m_field;
    Contents m_before;
    Contents m_after;
};

StagedForm::StagedForm(ModuleContext& context, const Words& words, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_words(words),
      m_hint(form::newParagraph(context.named(words.what.toLower() + u"Hint"_s), {}, this)) {}

StagedForm::~StagedForm() {
    // While the undo stack is destroyed, it still emits indexChanged.
    m_edits.disconnect(this);
}

// ---- rows ----

void StagedForm::add(FormGrid* grid, const Row& row, Field field) {
    field.label = form::newLabel(row.label, field.control);
    field.label->setToolTip(row.meaning);
    field.remark = look::newMutedLabel({}, this, row.object + u"Remark"_s);
    field.state = look::newMutedLabel({}, this, row.object + u"State"_s);
    if (field.number == nullptr) {
        field.remark->hide();
        grid->addWidget(field.control, grid->row(), 1, 1, 2);
        grid->addLine({field.label, nullptr, nullptr, field.state});
    } else if (auto* quantity = qobject_cast<QuantityField*>(field.control)) {
        quantity->otherView()->hide();
        grid->addLine({field.label, quantity, form::newLine(this, {quantity->unitLabel(), {field.remark, 1}}),
                       field.state});
    } else {
        grid->addLine({field.label, field.control, field.remark, field.state});
    }
    if (field.number != nullptr)
        field.number->setPlaceholderText(tr("unknown"));
    m_fields.push_back(std::move(field));
}

void StagedForm::addField(FormGrid* grid, const Row& row, NumberField* control) {
    add(grid, row,
        {.control = control,
         .number = control,
         .value = [control]() -> std::optional<int> {
             const auto number = control->value();
             return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
         },
         .show =
             [control](const std::optional<int>& value) {
                 if (value)
                     control->showValue(*value);
                 else
                     control->showNothing();
             }});
    connect(control, &NumberField::edited, this, [this, number = m_fields.size() - 1] { edited(number); });
}

void StagedForm::addField(FormGrid* grid, const Row& row, QuantityField* control,
                          std::function<std::optional<int>()> value,
                          std::function<void(const std::optional<int>&)> show) {
    add(grid, row,
        {.control = control, .number = control, .value = std::move(value), .show = std::move(show)});
    connect(control, &QuantityField::nativeEdited, this,
            [this, number = m_fields.size() - 1] { edited(number); });
}

void StagedForm::addField(FormGrid* grid, const Row& row, QComboBox* control) {
    control->setPlaceholderText(tr("unknown"));
    add(grid, row,
        {.control = control,
         .value = [control]() -> std::optional<int> {
             return control->currentIndex() < 0 ? std::nullopt
                                                : std::optional(control->currentData().toInt());
         },
         .show =
             [control](const std::optional<int>& value) {
                 control->setCurrentIndex(value ? control->findData(*value) : -1);
             }});
    connect(control, &QComboBox::activated, this, [this, number = m_fields.size() - 1] { edited(number); });
}

void StagedForm::addField(FormGrid* grid, const Row& row, QCheckBox* control) {
    add(grid, row,
        {.control = control,
         .value = [control] { return std::optional(control->isChecked() ? 1 : 0); },
         .show = [control](const std::optional<int>& value) { control->setChecked(value == 1); }});
    connect(control, &QCheckBox::clicked, this, [this, number = m_fields.size() - 1] { edited(number); });
}

void StagedForm::buildCommands() {
    m_undo = new Command({.name = m_context.named(u"undo%1Button"_s.arg(m_words.what)),
                          .icon = u"arrow-back-up"_s,
                          .text = Common::tr("Undo"),
                          .accessible = m_words.undo,
                          .key = QKeySequence::Undo},
                         this, [this] { m_edits.undo(); });
    m_redo = new Command({.name = m_context.named(u"redo%1Button"_s.arg(m_words.what)),
                          .icon = u"arrow-forward-up"_s,
                          .text = Common::tr("Redo"),
                          .accessible = m_words.redo,
                          .key = QKeySequence::Redo},
                         this, [this] { m_edits.redo(); });
    m_revert = new Command({.name = m_context.named(u"revert%1Button"_s.arg(m_words.what)),
                            .icon = u"repeat"_s,
                            .text = tr("Revert"),
                            .accessible = m_words.revert,
                            .key = Qt::CTRL | Qt::Key_R},
                           this, [this] {
                               fillIn(contentsOf(m_sent));
                               edited(std::nullopt);
                           });
}

void StagedForm::begin(Command& apply) {
    for (const Field& field : m_fields)
        if (field.number != nullptr)
            connect(field.number, &NumberField::returnPressed, &apply, &Command::act);
    m_kept = kept();
    m_sent = sent();
    fillIn(contentsOf(m_kept ? m_kept : m_sent));
    m_before = contents();
    connect(&m_edits, &QUndoStack::indexChanged, this, &StagedForm::refreshUndo);
    m_context.whenSeen(this, [this] { showModule(); });
}

// ---- contents of the fields ----

StagedForm::Values StagedForm::entered() const {
    Values values;
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        values.push_back(used(i) ? m_fields[i].value() : std::nullopt);
    return values;
}

StagedForm::Contents StagedForm::contents() const {
    Contents contents;
    for (const Field& field : m_fields)
        if (const auto value = field.value())
            contents.push_back({value, {}});
        else
            contents.push_back({{}, field.number != nullptr ? field.number->text() : QString()});
    return contents;
}

/// What the fields contain when they show these values, or none.
StagedForm::Contents StagedForm::contentsOf(const std::optional<Values>& values) const {
    Contents contents;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const bool check = qobject_cast<QCheckBox*>(m_fields[i].control) != nullptr;
        const auto value = values ? values->at(i) : std::nullopt;
        contents.push_back({value ? value : check ? std::optional(0) : std::nullopt, {}});
    }
    return contents;
}

void StagedForm::fillIn(const Contents& contents) {
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (contents[i].text.isEmpty())
            m_fields[i].show(contents[i].value);
        else
            m_fields[i].number->showText(contents[i].text);
}

void StagedForm::show(const Contents& contents) {
    fillIn(contents);
    m_before = contents;
    m_typed = contents != contentsOf(m_sent);
    if (const Values values = entered(); complete() && values != m_kept) {
        m_kept = values;
        keep();
    }
    refresh();
}

void StagedForm::edited(std::optional<std::size_t> field) {
    if (const Contents after = contents(); after != m_before)
        m_edits.push(new Edit(*this, field, m_before, after));
}

void StagedForm::fill(const Values& values) {
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (values[i])
            m_fields[i].show(values[i]);
    edited(std::nullopt);
}

void StagedForm::showModule() {
    const auto kept = this->kept();
    const auto sent = this->sent();
    const bool opened = kept != m_kept;  // another machine file replaces what was typed
    if (opened || sent != m_sent) {
        m_kept = kept;
        m_sent = sent;
        if (opened || !m_typed)
            fillIn(contentsOf(kept ? kept : sent));
        if (opened && m_typed)
            edited(std::nullopt);  // so that Undo brings it back
        m_before = contents();
        m_typed = m_typed && !opened && m_before != contentsOf(sent);
    }
    refresh();
}

bool StagedForm::complete() const {
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (used(i) && !m_fields[i].value())
            return false;
    return true;
}

bool StagedForm::unknown() const {
    return !m_sent && contents() == contentsOf(std::nullopt);
}

QString StagedForm::trouble() const {
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (const NumberField* number = m_fields[i].number; number != nullptr && used(i))
            if (const QString problem = number->problemText(); !problem.isEmpty())
                return problem;
    return {};
}

// ---- display ----

void StagedForm::fitInto(int width) {
    if (!m_narrow)
        m_wideWidth = minimumSizeHint().width();
    if (const bool narrow = width < m_wideWidth; narrow != m_narrow) {
        m_narrow = narrow;
        arrange();
        refresh();
    }
}

void StagedForm::showMark(QLabel* label, Mark mark) const {
    const QString words = mark == Mark::Unknown ? Common::tr("? unknown")
                          : mark == Mark::Sent  ? tr("✓ sent")
                                                : tr("● not sent");
    look::setText(label, m_narrow ? words.section(u' ', 0, 0) : words);
    if (label->toolTip() != words)
        label->setToolTip(words);
    if (const bool bold = mark == Mark::Edited; label->font().bold() != bold) {
        QFont font = label->font();
        font.setBold(bold);
        label->setFont(font);
    }
}

void StagedForm::refreshRow(std::size_t number) {
    const Field& field = m_fields[number];
    const bool visible = used(number);
    for (QWidget* widget :
         {static_cast<QWidget*>(field.label), field.control, static_cast<QWidget*>(field.state)})
        widget->setVisible(visible);
    field.remark->setVisible(visible && field.number != nullptr);
    const auto value = field.value();
    const auto sent = m_sent ? m_sent->at(number) : std::nullopt;
    look::setText(field.remark, remark(number, value));
    // An unticked box is no value as long as nothing is known.
    const bool check = field.number == nullptr && qobject_cast<QCheckBox*>(field.control) != nullptr;
    const bool kept = m_kept && m_kept->at(number);
    const bool empty =
        check ? value == 0 && !kept : !value && (field.number == nullptr || field.number->text().isEmpty());
    showMark(field.state, !sent && empty           ? Mark::Unknown
                          : value && value == sent ? Mark::Sent
                                                   : Mark::Edited);
}

void StagedForm::refreshUndo() {
    const QString locked = m_context.whyLocked();
    const auto reason = [&locked](bool possible, const QString& otherwise) {
        return !locked.isEmpty() ? locked : possible ? QString() : otherwise;
    };
    m_undo->setPossible(reason(m_edits.canUndo(), Common::tr("Nothing to undo.")),
                        tr("Undoes the last edit in these fields. Sends nothing."));
    m_redo->setPossible(reason(m_edits.canRedo(), Common::tr("Nothing to redo.")),
                        tr("Redoes the edit that was undone. Sends nothing."));
    m_revert->setPossible(reason(contents() != contentsOf(m_sent), tr("No changes to apply.")),
                          m_sent ? m_words.sentOnes : m_words.none);
}

void StagedForm::refresh() {
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        refreshRow(i);
    refreshRest();
    refreshUndo();
}

}  // namespace nmc
