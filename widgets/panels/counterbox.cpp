// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/counterbox.h"

#include <QLabel>

#include "model/settings/pinsof.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/command.h"
#include "widgets/panels/pinbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

enum Mode { Off, Timer, Counter };

constexpr int kCounterDigits = 5;  // width of a field

/// IO12 to IO1, most significant first, as binary numbers are written.
QString levels(std::uint16_t pins) {
    return u"%1"_s.arg(pins, static_cast<int>(io::kPins), 2, QChar(u'0'));
}

}  // namespace

CounterBox::CounterBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_mode(form::newChoice(
          {.name = u"timerModeBox"_s,
           .accessible = tr("Counter source"),
           .options = {{Common::tr("off")}, {tr("timer, 5 MHz")}, {tr("counter of rising edges on IO10")}}},
          this)),
      m_prescaler(form::newChoice({.name = u"timerPrescalerBox"_s,
                                   .accessible = tr("Prescaler"),
                                   .options = {{tr("every edge")},
                                               {tr("every 2nd edge")},
                                               {tr("every 4th edge")},
                                               {tr("every 8th edge")}}},
                                  this)),
      m_set(new Command({.name = u"setTimerButton"_s,
                         .icon = u"send"_s,
                         .text = tr("Set and restart"),
                         .accessible = tr("Set and restart the timer or counter")},
                        this, [this] { setMode(); })),
      m_count(new QLabel(this)),
      m_rate(look::newMutedLabel({}, this, u"counterRate"_s)),
      m_latched(new QLabel(this)),
      m_synchInput(new Command({.name = u"synchInputButton"_s,
                                .text = tr("Latch inputs"),
                                .accessible = tr("Latch inputs and counter at the same time")},
                               this, [this] { m_context.ask(iointent::SynchInput{}); })),
      m_outputs(form::newNumber(
          {.name = u"storedOutputsField"_s,
           .accessible = tr("Outputs to store"),
           .max = io::kAllPins,
           .digits = kCounterDigits,
           .meaning = tr("Add up the outputs: IO1 is 1, IO2 is 2, IO3 is 4, up to IO12, which is 2048.")},
          this)),
      m_store(new Command({.name = u"storeOutputsButton"_s,
                           .icon = u"download"_s,
                           .text = tr("Store"),
                           .accessible = tr("Store outputs for later")},
                          this, [this] { store(); })),
      m_synchOutput(new Command({.name = u"synchOutputButton"_s,
                                 .icon = u"send"_s,
                                 .text = tr("Apply"),
                                 .accessible = tr("Apply the stored outputs")},
                                this, [this] { apply(); })),
      m_stored(look::newMutedLabel({}, this, u"storedOutputs"_s)) {
    look::name(this, u"counterBox"_s, tr("Counter and synchronous I/O"));
    auto* grid = new FormGrid(this, 4, {.ends = 1, .across = 1, .down = 0.5});
    buildTimer(*grid);
    grid->addGap(1);
    buildSynch(*grid);
    grid->end();
    m_context.whenSeen(this, [this] { refresh(); });
}

void CounterBox::buildTimer(FormGrid& grid) {
    look::nameText(m_count, u"counterValue"_s, tr("Count"));
    m_count->setFont(look::tabular(look::scaled(font(), 1.5)));
    for (const auto& [text, choice] : {std::pair(tr("Count"), m_mode), {tr("Counts"), m_prescaler}}) {
        grid.addWidget(form::newLabel(text, choice), grid.row(), 0);
        grid.addWide(choice, 1);
    }
    grid.addLine({nullptr, m_set->button()});
    grid.addLine({nullptr, m_count, {m_rate, 1}});
}

void CounterBox::buildSynch(FormGrid& grid) {
    look::nameText(m_latched, u"latchedInputs"_s, tr("Latched values"));
    m_latched->setFont(look::tabular(font()));
    grid.addLine({new QLabel(tr("Latched"), this), m_synchInput->button(), {m_latched, 1}});
    grid.addRow(Common::tr("Outputs"), m_outputs);
    for (std::size_t i = 0; i < m_pwm.size(); ++i) {
        const QString label = u"PWM"_s + QString::number(i + 1);
        m_pwm.at(i) = form::newNumber({.name = u"storedPwm%1Field"_s.arg(i + 1),
                                       .accessible = tr("%1 to store").arg(label),
                                       .words = label,
                                       .max = 255,
                                       .digits = kCounterDigits},
                                      this);
        grid.addRow(label, m_pwm.at(i));
    }
    grid.addLine({nullptr, m_store->button(), {m_stored, 1}});
    grid.addLine({nullptr, m_synchOutput->button()});
    for (NumberField* field : {m_outputs, m_pwm[0], m_pwm[1]}) {
        field->showValue(0);
        connect(field, &NumberField::edited, this, &CounterBox::refresh);
    }
}

void CounterBox::setMode() {
    io::SetTimerMode mode;
    mode.enable = m_mode->currentIndex() != Off;
    mode.counter = m_mode->currentIndex() == Counter;
    mode.prescaler = static_cast<io::Prescaler>(m_prescaler->currentIndex());
    m_context.ask(iointent::SetTimer{mode});
}

void CounterBox::store() {
    const auto outputs = m_outputs->value();
    const auto pwm1 = m_pwm[0]->value();
    const auto pwm2 = m_pwm[1]->value();
    if (outputs && pwm1 && pwm2)
        m_context.ask(
            iointent::StoreOutputs{{static_cast<std::uint16_t>(*outputs), static_cast<std::uint8_t>(*pwm1),
                                    static_cast<std::uint8_t>(*pwm2)}});
}

void CounterBox::apply() {
    const auto go = [this] { m_context.ask(iointent::SynchOutput{}); };
    if (questions().isEmpty())
        return go();
    const auto text = [this] {
        const bool possible = isVisible() && !m_context.whyNot(IntentKind::SetOutputs);
        return possible ? questions() : QString();
    };
    PinBox::askFirst(this, text, tr("Apply"), go);
}

QString CounterBox::questions() const {
    QStringList each;
    const IoRegisters& pins = m_context.state().pins;
    for (unsigned pin = 0; pins.stored && pins.inputs && pin < io::kPins; ++pin)
        if (!bitOf(*pins.inputs, pin) && PinSettings::of(pinsOf(m_context.settings()).pins, pin).asks)
            each << PinBox::question(m_context, pin, bitOf(pins.stored->outputs, pin));
    each.removeAll(QString());
    return each.join(u'\n');
}

QString CounterBox::rate() const {
    const ModuleState& module = m_context.state();
    const auto& timer = module.pins.timer;
    if (!timer)
        return tr("Counter source unknown: another program has set it.");
    if (!timer->enable)
        return Common::tr("off");
    if (m_context.age())
        return {};  // what is derived from an old count is not current either
    const double each = divisor(timer->prescaler);
    if (!timer->counter)
        return module.latest && module.latest->counter
                   ? tr("= %1 s").arg(texts::readout(*module.latest->counter * each / io::kTimerHz, 6))
                   : QString();
    const auto perSecond = module.counting.perSecond();
    return perSecond ? tr("%1 Hz on IO10").arg(texts::readout(*perSecond * each, 4)) : QString();
}

void CounterBox::refresh() {
    const ModuleState& module = m_context.state();
    const StatusReport report = module.latest.value_or(StatusReport{});
    look::setReadout(m_count, report.counter ? texts::grouped(static_cast<qint64>(*report.counter)) : u"–"_s);
    look::setOld(m_count, m_context.age().has_value());
    look::setText(m_rate, rate());
    QString latched;
    if (report.latchedPins && report.latchedCounter)
        latched = tr("IO12 to IO1: %1, count %2")
                      .arg(levels(*report.latchedPins),
                           texts::grouped(static_cast<qint64>(*report.latchedCounter)));
    look::setText(m_latched, latched);
    const QString control = m_context.reasonNow(IntentKind::ControlIo);
    const QString outputs = m_context.reasonNow(IntentKind::SetOutputs);
    m_set->setPossible(control, tr("Sends the settings above. The count restarts at 0."));
    m_synchInput->setPossible(control,
                              tr("Latches all pins and the count at the same moment, and reads them."));
    QString problem = outputs;
    for (const NumberField* field : {m_outputs, m_pwm[0], m_pwm[1]})
        if (problem.isEmpty())
            problem = field->problemText();
    m_store->setPossible(problem,
                         tr("Sends these values to the module, which keeps them until you apply them."));
    const auto& stored = module.pins.stored;
    m_synchOutput->setPossible(!outputs.isEmpty() ? outputs
                               : stored           ? QString()
                                                  : tr("Store outputs first."),
                               tr("Applies the stored pin levels and PWM values at the same moment."));
    look::setText(m_stored, stored ? tr("stored: %1, PWM %2 and %3")
                                         .arg(levels(stored->outputs))
                                         .arg(static_cast<int>(stored->pwm1))
                                         .arg(static_cast<int>(stored->pwm2))
                                   : QString());
}

}  // namespace nmc
