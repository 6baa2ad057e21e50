// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/iobox.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>

#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
enum Use { Input, OutputLow, OutputHigh };

Use useOf(const servo::IoControl& io, int pin) {
    if (pin == 0 ? io.limit1IsInput : io.limit2IsInput)
        return Input;
    return (pin == 0 ? io.limit1Output : io.limit2Output) ? OutputHigh : OutputLow;
}
}  // namespace

IoBox::IoBox(ModuleContext& context, QWidget* parent) : QWidget(parent), m_context(context) {
    look::name(this, u"ioBox"_s, tr("Limits and I/O"));
    auto* grid = new FormGrid(this, 4, {.ends = 1, .across = 1, .down = 0.5});
    m_pins[0] = addPin(grid, 1);
    m_pins[1] = addPin(grid, 2);
    if (const ModuleIdentity& module = context.state().info.identity;
        hasPathBuffer(module) && !isSc(module)) {
        m_fastPath = form::newCheck({.name = u"ioFastPathBox"_s, .text = Common::tr("Fast path")}, this);
        connect(m_fastPath, &QCheckBox::clicked, this, [this] {
            m_fastPath->setTristate(false);  // once chosen, it is not unknown again
            control();
        });
        grid->addWide(m_fastPath);
    }
    m_index = addInput(grid, Common::tr("Index"), u"indexValue"_s,
                       tr("The encoder's index pulse, once per turn with most encoders."));
    m_power = addInput(grid, Common::tr("Motor power"), u"powerValue"_s,
                       tr("Without motor power the servo switches off, and stays off when power returns."));
    m_analog = new QLabel(u"–"_s, this);
    m_analog->setObjectName(u"analogValue"_s);
    m_analog->setFont(look::tabular(font()));
    m_analog->setToolTip(
        tr("The A/D input; with most amplifiers, the motor current. Set its scale on the Axis page."));
    grid->addLine({new QLabel(Common::tr("A/D"), this), nullptr, {m_analog, 1}});
    m_amplifier =
        form::newCheck({.name = u"amplifierBox"_s, .text = tr("Amplifier enabled (&AMP_EN)")}, this);
    grid->addWide(m_amplifier);
    m_usualRemark =
        isSc(context.state().info.identity)
            ? tr("The Amplifier page sets what the module does when a limit closes.")
            : tr("On this chip, a limit switch alone does not stop the motor. Arm a limit stop on the Homing page.");
    m_remark = form::newRemark({}, this, u"limitRemark"_s);
    grid->addWide(m_remark);
    grid->end();
    connect(m_amplifier, &QCheckBox::clicked, this, [this](bool enable) {
        refresh();  // the box follows the module, not the click
        m_context.ask(intent::SetAmplifier{enable});
    });
    m_context.whenSeen(this, [this] { showModule(); });
}

IoBox::Pin IoBox::addPin(FormGrid* grid, int number) {
    Pin pin;
    pin.use = form::newChoice({.name = u"limit%1UseBox"_s.arg(number),
                               .accessible = tr("Limit %1: input or output").arg(number),
                               .options = {{Common::tr("input"), Input},
                                           {tr("output, low"), OutputLow},
                                           {tr("output, high"), OutputHigh}}},
                              this);
    pin.use->setPlaceholderText(Common::tr("? unknown"));
    pin.glyph = new GlyphLabel(this);
    pin.value = new QLabel(u"–"_s, this);
    pin.value->setObjectName(u"limit%1Value"_s.arg(number));
    grid->addRow(number == 1 ? tr("Limit &1") : tr("Limit &2"), pin.use, {pin.glyph, pin.value});
    connect(pin.use, &QComboBox::activated, this, &IoBox::control);
    return pin;
}

IoBox::Indicator IoBox::addInput(FormGrid* grid, const QString& label, const QString& objectName,
                                 const QString& meaning) {
    auto* name = new QLabel(label, this);
    const Indicator input{.glyph = new GlyphLabel(this), .value = new QLabel(u"–"_s, this)};
    input.value->setObjectName(objectName);
    for (QWidget* part : std::initializer_list<QWidget*>{name, input.glyph, input.value})
        part->setToolTip(meaning);
    grid->addLine({name, nullptr, input.glyph, input.value});
    return input;
}

void IoBox::show(const IoBox::Indicator& input, std::optional<bool> set, const QString& on,
                 const QString& off) {
    input.glyph->showBit(set);
    look::setText(input.value, !set ? u"–"_s : *set ? on : off);
}

void IoBox::showModule() {
    const bool known = m_context.state().limitPinsKnown();
    if (known || !m_choosing)
        showUses(known);
    m_choosing = !known;
    refresh();
}

void IoBox::showUses(bool known) {
    const servo::IoControl io = m_context.state().io.value_or(servo::IoControl{});
    for (int i = 0; i < 2; ++i) {
        QComboBox* use = m_pins[static_cast<std::size_t>(i)].use;
        const QSignalBlocker blocker(use);
        if (known)
            form::choose(use, useOf(io, i));
        else
            use->setCurrentIndex(-1);
    }
    if (m_fastPath == nullptr)
        return;
    m_fastPath->setTristate(!known);
    m_fastPath->setCheckState(!known ? Qt::PartiallyChecked : io.fastPath ? Qt::Checked : Qt::Unchecked);
}

void IoBox::control() {
    // The command sets all of it, and nothing may change unasked.
    for (const Pin& pin : m_pins)
        if (pin.use->currentIndex() < 0)
            return;
    if (m_fastPath != nullptr && m_fastPath->checkState() == Qt::PartiallyChecked)
        return;
    servo::IoControl io;
    const auto use = [this](std::size_t pin) { return form::chosen<Use>(m_pins[pin].use); };
    io.limit1IsInput = use(0) == Input;
    io.limit1Output = use(0) == OutputHigh;
    io.limit2IsInput = use(1) == Input;
    io.limit2Output = use(1) == OutputHigh;
    io.fastPath = m_fastPath != nullptr && m_fastPath->isChecked();
    m_choosing = false;  // it remains unknown until the module has confirmed it
    m_context.ask(intent::ControlIo{io});
}

void IoBox::refresh() {
    const ModuleState& module = m_context.state();
    const auto status = [&](auto bit) {
        return module.latest ? std::optional(bit(module.latest->servoStatus())) : std::nullopt;
    };
    const std::array<std::optional<bool>, 2> limits{status([](auto s) { return s.limit1(); }),
                                                    status([](auto s) { return s.limit2(); })};
    const QString io = m_context.reasonNow(IntentKind::ControlIo);
    const QString unknown =
        module.limitPinsKnown()
            ? QString()
            : tr("Another program set up this module, so its pin directions are unknown. Nothing is sent until all are chosen.");
    const auto meaning = [&unknown](const QString& usual) { return unknown.isEmpty() ? usual : unknown; };
    for (std::size_t i = 0; i < m_pins.size(); ++i) {
        show({m_pins[i].glyph, m_pins[i].value}, limits[i], Common::tr("high"), Common::tr("low"));
        look::setPossible(m_pins[i].use, io,
                          meaning(tr("Makes the pin an input, or an output with this level. Sent at once.")));
    }
    if (m_fastPath != nullptr)
        look::setPossible(m_fastPath, io,
                          meaning(tr("Path points at 60 and 120 Hz instead of 30 and 60 Hz. Sent at once.")));
    look::setText(m_remark, unknown.isEmpty() ? m_usualRemark : unknown + u' ' + m_usualRemark);
    std::optional<bool> index;
    if (module.latest && module.latest->aux)
        index = !servo::AuxByte{*module.latest->aux}.indexComplement();
    show(m_index, index, tr("at the index"), tr("not at the index"));
    show(m_power, status([](auto s) { return s.powerOn(); }), tr("present"), tr("missing"));
    const StatusReport report = module.latest.value_or(StatusReport{});
    look::setText(m_analog, texts::analogReading(m_context.settings().analog, report.analog));
    const QSignalBlocker blocker(m_amplifier);
    const auto amplifier = module.amplifierEnabled;
    m_amplifier->setTristate(!amplifier);
    m_amplifier->setCheckState(!amplifier ? Qt::PartiallyChecked : *amplifier ? Qt::Checked : Qt::Unchecked);
    look::setPossible(
        m_amplifier, m_context.reasonNow(IntentKind::SetAmplifier),
        tr("Switches only the amplifier's enable line; the servo stays as it is. When off, the motor gets no current, whatever the servo does."));
}

}  // namespace nmc
