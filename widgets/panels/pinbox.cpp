// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/pinbox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include "model/settings/pinsof.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

/// The level that the output was set to, or that it has if that is unknown; empty for an input.
std::optional<bool> outputOf(const ModuleState& module, unsigned pin) {
    const auto inputs = module.pins.inputs;
    if (!inputs || bitOf(*inputs, pin))
        return std::nullopt;
    const auto level = module.latest.value_or(StatusReport{}).pins;
    return bitOf(module.pins.outputs.value_or(level.value_or(0)), pin);
}

}  // namespace

PinBox::PinBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_allInputs(new Command(
          {.name = u"pinsAllInputsButton"_s, .icon = u"send"_s, .text = tr("Make all pins inputs")}, this,
          [this] { m_context.ask(iointent::SetDirection{io::kAllPins}); })),
      m_hint(form::newRemark({}, this, u"pinsHint"_s)) {
    look::name(this, u"pinBox"_s, Common::tr("Pins"));
    const int unit = look::gridUnit(this);
    auto* grid = new FoldingGrid(this, FoldingGrid::Kind::Table);
    grid->setContentsMargins(unit, unit / 2, unit, unit / 2);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    build(*grid);
    m_context.whenSeen(this, [this] { showModule(); });
}

void PinBox::build(QGridLayout& grid) {
    const std::array<QString, 7> headings{
        tr("Pin"),       tr("Direction"),          tr("Level"), tr("Output"), Common::tr("Name"),
        tr("Ask first"), Common::tr("Off at stop")};
    for (int i = 0; i < static_cast<int>(headings.size()); ++i)
        grid.addWidget(look::newMutedLabel(headings.at(static_cast<std::size_t>(i)), this), 0, i);
    for (unsigned i = 0; i < io::kPins; ++i)
        buildPin(grid, i);
    const int below = static_cast<int>(io::kPins) + 1;
    grid.addLayout(form::newLine(this, {m_allInputs->button(), nullptr}), below, 0, 1, 7);
    grid.addWidget(m_hint, below + 1, 0, 1, 7);
    grid.setColumnStretch(Name, 1);
    grid.setRowStretch(below + 2, 1);
}

void PinBox::buildPin(QGridLayout& grid, unsigned number) {
    Pin& pin = m_pins.at(number);
    const QString digits = QString::number(number + 1);
    const QString label = u"IO"_s + digits;
    const int row = static_cast<int>(number) + 1;
    pin.direction =
        form::newChoice({.name = u"pin%1Direction"_s.arg(digits),
                         .accessible = tr("Direction of %1").arg(label),
                         .options = {{Common::tr("input")}, {tr("output")}, {Common::tr("? unknown")}}},
                        this);
    pin.glyph = new GlyphLabel(this);
    pin.level = new QLabel(this);
    pin.level->setObjectName(u"pin%1Level"_s.arg(digits));
    pin.high = form::newCheck({.name = u"pin%1Box"_s.arg(digits),
                               .text = Common::tr("high"),
                               .accessible = tr("high: output %1").arg(label)},
                              this);
    pin.name = newNameField(u"pin%1Name"_s.arg(digits), Common::tr("Name of %1").arg(label), this);
    pin.asks = form::newCheck({.name = u"pin%1Asks"_s.arg(digits),
                               .text = {},
                               .accessible = tr("Ask first before %1 changes").arg(label)},
                              this);
    pin.offAtStop = form::newCheck({.name = u"pin%1OffAtStop"_s.arg(digits),
                                    .text = {},
                                    .accessible = tr("Take %1 low on STOP ALL").arg(label)},
                                   this);

    grid.addWidget(form::newLabel(label, pin.direction), row, Label);
    grid.addWidget(pin.direction, row, Direction);
    grid.addLayout(form::newLine(this, {pin.glyph, pin.level, nullptr}, 0.5), row, Level);
    grid.addWidget(pin.high, row, High);
    grid.addWidget(pin.name, row, Name);
    grid.addWidget(pin.asks, row, Asks, Qt::AlignHCenter);
    grid.addWidget(pin.offAtStop, row, OffAtStop, Qt::AlignHCenter);

    connect(pin.direction, &QComboBox::activated, this,
            [this, number](int choice) { setDirection(number, choice); });
    connect(pin.high, &QCheckBox::clicked, this, [this, number](bool high) { setOutput(number, high); });
    const auto edit = [this, number](const auto& change) {
        m_context.edit(
            [number, change](AxisSettings& axis) { change(PinSettings::in(editPins(axis).pins, number)); });
    };
    connect(pin.name, &QLineEdit::textEdited, this, [edit](const QString& text) {
        edit([text = text.toStdString()](OutputSettings& output) { output.name = text; });
    });
    connect(pin.asks, &QCheckBox::clicked, this,
            [edit](bool on) { edit([on](OutputSettings& output) { output.asks = on; }); });
    connect(pin.offAtStop, &QCheckBox::clicked, this,
            [edit](bool on) { edit([on](OutputSettings& output) { output.offAtStop = on; }); });
}

void PinBox::setDirection(unsigned pin, int choice) {
    const ModuleState& module = m_context.state();
    // An input drives nothing; an output drives the level that is set, or else the one that is read.
    const bool high =
        choice == Output && module.latest && bitOf(module.pins.levels(*module.latest).value_or(0), pin);
    // Neither "unknown" nor the present direction requests anything.
    if (const auto inputs = module.pins.inputs; inputs && choice == (bitOf(*inputs, pin) ? Output : Input))
        switchOutput(pin, high, [this, pin] {
            return iointent::SetDirection{
                static_cast<std::uint16_t>(m_context.state().pins.inputs.value_or(0) ^ (1U << pin))};
        });
    refresh();  // the box shows what was confirmed, not what was selected
}

void PinBox::setOutput(unsigned pin, bool high) {
    switchOutput(pin, high, [pin, high] { return iointent::SetOutput{pin, high}; });
    refresh();
}

void PinBox::switchOutput(unsigned pin, bool high, const std::function<Intent()>& request) {
    const auto go = [this, request] { m_context.ask(request()); };
    if (!PinSettings::of(pinsOf(m_context.settings()).pins, pin).asks ||
        question(m_context, pin, high).isEmpty())
        return go();
    const auto text = [this, pin, high] {
        const bool possible = isVisible() && !m_context.whyNot(IntentKind::SetOutputs);
        return possible ? question(m_context, pin, high) : QString();
    };
    askFirst(this, text, high ? tr("&Switch on") : tr("&Switch off"), go);
}

QString PinBox::question(const ModuleContext& context, unsigned pin, bool high) {
    if (outputOf(context.state(), pin).value_or(false) == high)
        return {};
    const auto& pins = pinsOf(context.settings()).pins;
    const QString given = QString::fromStdString(PinSettings::of(pins, pin).name);
    const QString label = u"IO"_s + QString::number(pin + 1);
    const QString name = given.isEmpty() ? label : Common::tr("%1 (%2)").arg(given, label);
    return high ? tr("Switch %1 on?").arg(name) : tr("Switch %1 off?").arg(name);
}

void PinBox::askFirst(QWidget* owner, const std::function<QString()>& text, const QString& verb,
                      const std::function<void()>& go) {
    AskDialog::ask(
        {.name = u"outputDialog"_s, .title = tr("Output"), .text = text, .stayName = u"cancelOutputButton"_s},
        {{verb, u"switchOutputButton"_s, go}}, owner);
}

void PinBox::showModule() {
    showSettings();
    refresh();
}

void PinBox::showSettings() {
    const PinSettings& settings = pinsOf(m_context.settings());
    const QString locked = m_context.whyLocked();
    for (unsigned i = 0; i < io::kPins; ++i) {
        const OutputSettings output = PinSettings::of(settings.pins, i);
        const Pin& pin = m_pins.at(i);
        showUnlessTyped(pin.name, output.name);
        pin.asks->setChecked(output.asks);
        pin.offAtStop->setChecked(output.offAtStop);
        setNameLocked(pin.name, locked);
        look::setPossible(pin.asks, locked, tr("Asks before the panel switches this output."));
        look::setPossible(pin.offAtStop, locked,
                          tr("STOP ALL takes this output low. If cleared, the output stays as it is."));
    }
}

void PinBox::refresh() {
    for (unsigned i = 0; i < io::kPins; ++i)
        refreshPin(i);
    const bool known = m_context.state().pins.inputs.has_value();
    m_allInputs->setVisible(!known);
    m_allInputs->setPossible(m_context.reasonNow(IntentKind::ControlIo),
                             tr("Makes all twelve pins inputs: outputs release what they drive."));
    look::setText(
        m_hint,
        known
            ? QString()
            : tr("Another program set up this module, so its pin directions are unknown. Make all pins inputs to start over."));
}

void PinBox::refreshPin(unsigned number) {
    const ModuleState& module = m_context.state();
    const Pin& pin = m_pins.at(number);
    const auto inputs = module.pins.inputs;
    const auto level = module.latest.value_or(StatusReport{}).pins;
    const auto output = outputOf(module, number);
    const bool high = bitOf(level.value_or(0), number);
    const bool differs = output && level && *output != high;

    const QSignalBlocker direction(pin.direction);
    pin.direction->setCurrentIndex(!inputs ? Unknown : output ? Output : Input);
    QString reason = m_context.reasonNow(IntentKind::ControlIo);
    if (reason.isEmpty() && !inputs)
        reason = tr("Pin directions unknown. Make all pins inputs first.");
    look::setPossible(pin.direction, reason,
                      tr("Input: the module reads this pin. Output: it drives this pin."));

    const bool old = m_context.age().has_value();
    pin.glyph->showBit(level && !old ? std::optional(high) : std::nullopt);
    look::setText(pin.level, !level    ? u"–"_s
                             : differs ? high ? tr("high, set low") : tr("low, set high")
                             : high ? Common::tr("high")
                                       : Common::tr("low"));
    look::setOld(pin.level, old);
    const QSignalBlocker box(pin.high);
    pin.high->setChecked(output.value_or(false));
    QString why = m_context.reasonNow(IntentKind::SetOutputs);
    if (why.isEmpty() && !output)
        why = inputs ? tr("This pin is an input.") : tr("Pin directions unknown.");
    look::setPossible(pin.high, why, Common::tr("Switches this output at once."));
}

}  // namespace nmc
