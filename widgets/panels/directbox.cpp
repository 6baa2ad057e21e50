// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/directbox.h"

#include <QCheckBox>
#include <QLabel>

#include "model/intent/directplan.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

bool DirectBox::Value::sent() const {
    return loaded == nullptr || loaded->isChecked();
}

double DirectBox::Value::value() const {
    return field->value().value_or(0);
}

DirectBox::DirectBox(ModuleContext& context, const Spec& spec, QWidget* parent)
    : QGroupBox(spec.title, parent),
      m_context(context),
      m_name(spec.name),
      m_grid(new FoldingGrid(this)),
      m_meaning(form::newParagraph(named(u"Meaning"_s), tr("What the chip will do"), this)),
      m_bytes(look::newMutedLabel({}, this)),
      m_send(new Command(
          {.name = named(u"Button"_s), .text = spec.send, .accessible = tr("%1 as set here").arg(spec.send)},
          this, [this] { m_context.ask(intent::Direct{m_command()}); })) {
    look::name(this, named(u"Box"_s), spec.title);
    look::nameText(m_bytes, named(u"Bytes"_s), tr("Command bytes"));
    m_bytes->setFont(look::tabular(font()));
    m_bytes->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_grid->setHorizontalSpacing(look::gridUnit(this));
    m_grid->setVerticalSpacing(look::gridUnit(this) / 3);
    m_grid->setColumnStretch(1, 1);
}

QString DirectBox::named(const QString& name) const {
    return m_name + name;
}

void DirectBox::addRow(QWidget* left, QWidget* right) {
    const int row = m_grid->rowCount();
    if (right == nullptr)
        return m_grid->addWidget(left, row, 0, 1, 2);
    m_grid->addWidget(left, row, 0);
    m_grid->addWidget(right, row, 1, Qt::AlignLeft);
}

QCheckBox* DirectBox::addFlag(const QString& name, const QString& text) {
    auto* box = form::newCheck(
        {.name = named(name), .text = text, .meaning = tr("A bit of %1: %2").arg(title(), text)}, this);
    connect(box, &QCheckBox::toggled, this, &DirectBox::refresh);
    addRow(box, nullptr);
    return box;
}

QComboBox* DirectBox::addChoice(const QString& name, const QString& label, const QStringList& choices) {
    auto* box = form::newChoice(
        {.name = named(name), .accessible = label, .meaning = tr("Bits of %1: %2").arg(title(), label)},
        this);
    box->addItems(choices);
    connect(box, &QComboBox::currentIndexChanged, this, &DirectBox::refresh);
    addRow(form::newLabel(label, box), box);
    return box;
}

DirectBox::Value DirectBox::addValue(const QString& name, const QString& text, double min, double max,
                                     bool optional) {
    Value value;
    value.field = form::newNumber({.name = named(name),
                                   .accessible = text,
                                   .min = min,
                                   .max = max,
                                   .digits = 9,
                                   .meaning = tr("Data of %1: %2").arg(title(), text)},
                                  this);
    value.field->showValue(std::max(min, 0.0));
    connect(value.field, &NumberField::edited, this, &DirectBox::refresh);
    QWidget* left = nullptr;
    if (optional) {
        value.loaded =
            form::newCheck({.name = named(name) + u"Loaded"_s,
                            .text = text,
                            .accessible = tr("%1: load").arg(text),
                            .meaning = tr("If cleared, the chip keeps the previously loaded value.")},
                           this);
        connect(value.loaded, &QCheckBox::toggled, value.field, &QWidget::setEnabled);
        connect(value.loaded, &QCheckBox::toggled, this, &DirectBox::refresh);
        value.field->setEnabled(false);
        left = value.loaded;
    } else {
        left = form::newLabel(text, value.field);
    }
    addRow(left, value.field);
    m_values.push_back(value);
    return value;
}

void DirectBox::setCommand(std::function<ModuleCommand()> command,
                           std::function<QString(const ModuleCommand&)> meaning) {
    m_command = std::move(command);
    m_tell = std::move(meaning);
    addRow(m_meaning, nullptr);
    m_grid->addLayout(form::newLine(this, {{m_bytes, 1}, m_send->button()}), m_grid->rowCount(), 0, 1, 2);
    m_context.whenSeen(this, [this] { refresh(); });
}

QString DirectBox::problem() const {
    for (const Value& value : m_values)
        if (value.sent() && value.field->problem() != NumberField::Problem::None)
            return value.field->problemText();
    return {};
}

void DirectBox::refresh() {
    if (!m_command)
        return;
    const ModuleCommand command = m_command();
    const auto meaning = m_tell(command);
    QString reason = problem();
    const auto refusal = m_context.connected() ? whyNotDirect(command, m_context.state())
                                               : std::optional(Refusal::NotConnected);
    if (reason.isEmpty() && refusal)
        reason = texts::refusal(*refusal);
    look::setText(m_meaning, reason.isEmpty() ? meaning : reason);
    const Payload payload = std::visit([](const auto& chip) { return encode(chip); }, command);
    const PacketBytes packet = toPacket({m_context.state().info.address, payload});
    QByteArray bytes(reinterpret_cast<const char*>(packet.data()), static_cast<qsizetype>(packet.size()));
    look::setText(m_bytes, problem().isEmpty() ? QString::fromLatin1(bytes.toHex(' ').toUpper()) : QString());
    if (reason.isEmpty() && !isStop(intent::Direct{command}))
        reason = m_context.whyBusy();
    m_send->setPossible(reason, meaning);
}

}  // namespace nmc
