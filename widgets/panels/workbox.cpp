// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/workbox.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <utility>

#include "model/machinefile/machinelayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/common/workwords.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kMaxOffsetName = 20;
}  // namespace

WorkBox::WorkBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(Common::tr("Work offsets"), parent), m_context(context) {
    look::name(this, m_context.named(u"workBox"_s), Common::tr("Work offsets"));
    auto* grid = new FormGrid(this, 5, {.across = 0.5, .down = 0.5});
    buildChoice(grid);
    buildCall(grid);
    m_hint = form::newParagraph(m_context.named(u"workHint"_s), {}, this);
    grid->addWide(m_hint);
    m_context.whenSeen(this, [this] { showModule(); });
}

void WorkBox::buildChoice(FormGrid* grid) {
    m_choice = form::newChoice(
        {.name = m_context.named(u"workChoice"_s), .accessible = tr("Positions count from this work offset")},
        this);
    m_clear = new Command({.name = m_context.named(u"workClearButton"_s),
                           .text = tr("Clear"),
                           .accessible = tr("Clear work offset: positions count by the counter")},
                          this, [this] { choose({}); });
    m_delete = new Command({.name = m_context.named(u"workDeleteButton"_s),
                            .text = tr("Delete"),
                            .accessible = tr("Delete work offset")},
                           this, [this] { remove(); });
    grid->addTitled(tr("Count from"),
                    form::newLine(this, {{m_choice, 1}, m_clear->button(), m_delete->button()}))
        ->setBuddy(m_choice);
    // Not when the choice follows the module.
    connect(m_choice, &QComboBox::activated, this, [this](int index) {
        choose(index == 0 ? std::string() : m_choice->currentText().toStdString());
    });
}

void WorkBox::buildCall(FormGrid* grid) {
    m_called = form::newQuantity(
        {.kind = QuantityField::Kind::Position,
         .name = m_context.named(u"calledField"_s),
         .accessible = tr("Number for the present position"),
         .min = layout::kPlace.min,
         .max = layout::kPlace.max,
         .step = 100,
         .digits = 8,
         .meaning = tr("What the present position is to be called, in the unit of the axis.")},
        this);
    m_called->showNative(0);
    m_name = form::newText({.name = m_context.named(u"calledNameField"_s),
                            .accessible = tr("Name of the work offset"),
                            .maxLength = kMaxOffsetName,
                            .meaning = tr("The name by which you choose it later."),
                            .example = tr("For example: fixture A")},
                           this);
    m_call = new Command({.name = m_context.named(u"callButton"_s),
                          .text = tr("Call this position"),
                          .accessible = tr("Call this position: make a work offset")},
                         this, [this] { call(); });
    grid->addRow(tr("This position is"), m_called);
    grid->addTitled(Common::tr("Name"), form::newLine(this, {{m_name, 1}, m_call->button()}))
        ->setBuddy(m_name);
    connect(m_called, &QuantityField::nativeEdited, this, &WorkBox::refresh);
    connect(m_name, &QLineEdit::textEdited, this, &WorkBox::refresh);
    connect(m_name, &QLineEdit::returnPressed, m_call, &Command::act);
}

const WorkOffset* WorkBox::kept(const std::string& name) const {
    const auto& offsets = m_context.settings().workOffsets;
    const auto found = std::ranges::find(offsets, name, &WorkOffset::name);
    return found != offsets.end() ? &*found : nullptr;
}

void WorkBox::choose(const std::string& name) {
    if (const WorkOffset* offset = kept(name))
        m_context.useWorkOffset(*offset);
    else if (name.empty())
        m_context.useWorkOffset(std::nullopt);
}

void WorkBox::remove() {
    const auto zero = m_context.state().home.workZero();
    if (!zero)
        return;
    m_context.useWorkOffset(std::nullopt);
    m_context.edit([name = zero->offset.name](AxisSettings& axis) {
        std::erase_if(axis.workOffsets, [&name](const WorkOffset& offset) { return offset.name == name; });
    });
}

void WorkBox::call() {
    const auto offset = called();
    if (!offset)
        return;
    m_name->clear();
    if (m_context.state().home.place())
        m_context.edit([&offset](AxisSettings& axis) { axis.workOffsets.push_back(*offset); });
    m_context.useWorkOffset(offset);
}

std::optional<WorkOffset> WorkBox::called() const {
    const auto& latest = m_context.state().latest;
    const auto number = m_called->native();
    if (!latest || !latest->position || !number)
        return std::nullopt;
    return m_context.state().home.workOffset(m_name->text().trimmed().toStdString(), *latest->position,
                                             *number);
}

QString WorkBox::whyLocked() const {
    return m_context.connected() ? m_context.whyLocked() : texts::refusal(Refusal::NotConnected);
}

QString WorkBox::whyNotCalled() const {
    const ModuleState& module = m_context.state();
    if (const QString reason = whyLocked(); !reason.isEmpty())
        return reason;
    if (m_context.age() || !module.latest || !module.latest->position)
        return texts::refusal(Refusal::PositionUnknown);
    if (module.moving())
        return tr("The motor is moving. Stop it first, and call its position then.");
    if (!m_called->native())
        return m_called->problemText();
    const QString name = m_name->text().trimmed();
    if (name.isEmpty())
        return tr("Enter a name for the work offset, for example of a fixture.");
    if (kept(name.toStdString()) != nullptr)
        return tr("Another work offset of this axis has this name. Delete that one, or enter another name.");
    if (m_context.settings().workOffsets.size() >= kMaxWorkOffsets)
        return tr("This axis has as many work offsets as it can have. Delete one first.");
    return called() ? QString()
                    : tr("With this number, the work offset would be outside the position range.");
}

void WorkBox::showModule() {
    m_called->setScale(m_context.scale());
    showChoice();
    refresh();
}

void WorkBox::showChoice() {
    const auto zero = m_context.state().home.workZero();
    QStringList names{tr("the counter")};
    for (const WorkOffset& offset : m_context.settings().workOffsets)
        names << QString::fromStdString(offset.name);
    const QString used = zero ? QString::fromStdString(zero->offset.name) : QString();
    if (zero && zero->counts && kept(zero->offset.name) == nullptr)
        names << used;  // for this session only
    if (std::exchange(m_names, names) != names) {
        m_choice->clear();
        m_choice->addItems(names);
    }
    m_choice->setPlaceholderText(tr("%1: not known").arg(used));
    m_choice->setCurrentIndex(!zero ? 0 : zero->counts ? static_cast<int>(names.lastIndexOf(used)) : -1);
}

void WorkBox::refresh() {
    const ModuleState& module = m_context.state();
    const bool homed = module.home.place().has_value();
    const auto zero = module.home.workZero();
    const QString locked = whyLocked();
    look::setPossible(
        m_choice, locked.isEmpty() && !homed ? texts::refusal(Refusal::HomeUnknown) : locked,
        tr("Where the positions on the screen count from. Nothing moves, and nothing is sent."));
    m_clear->setPossible(zero ? locked : tr("No work offset is in use."),
                         tr("Positions count by the counter again. Nothing moves."));
    m_delete->setPossible(
        zero && kept(zero->offset.name) != nullptr ? locked : tr("Choose the work offset first."),
        tr("Deletes the work offset from the machine. Nothing moves."));
    const QString reason = whyNotCalled();
    m_call->setPossible(reason, tr("Positions then count from there. Nothing moves; counter and home stay."));
    const bool toSay = !reason.isEmpty() && !m_name->text().isEmpty();
    QString hint = zero && !zero->counts ? texts::zeroInUse(zero) : toSay ? reason : QString();
    if (hint.isEmpty() && !homed)
        hint =
            tr("Home is unknown: an offset lasts only until home or the counter changes, and is not kept.");
    look::setText(m_hint, hint);
    m_hint->setVisible(!hint.isEmpty());
}

}  // namespace nmc
