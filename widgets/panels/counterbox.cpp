// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/counterbox.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

#include "widgets/common/foldinggrid.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

enum Mode { Off, Timer, Counter };

/// IO12 to IO1, most significant first, as binary numbers are written.
QString levels(std::uint16_t pins) {
    return u"%1"_s.arg(pins, static_cast<int>(io::kPins), 2, QChar(u'0'));
}

}  // namespace

CounterBox::CounterBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_mode(new QComboBox(this)),
      m_prescaler(new QComboBox(this)),
      m_set(new Command({.name = u"setTimerButton"_s,
                         .icon = u"send"_s,
                         .text = tr("Set and restart"),
                         .accessible = tr("Set and restart the timer or counter")},
                        this, [this] { setMode(); })),
      m_count(new QLabel(this)),
      m_rate(look::newMutedLabel({}, this)),
      m_latched(new QLabel(this)),
      m_synchInput(new Command({.name = u"synchInputButton"_s,
                                .icon = {},
                                .text = tr("Latch inputs"),
                                .accessible = tr("Latch inputs and counter at the same time")},
                               this, [this] { m_context.ask(iointent::SynchInput{}); })),
      m_outputs(new NumberField(0, this)),
      m_store(new Command({.name = u"storeOutputsButton"_s,
                           .icon = u"download"_s,
                           .text = tr("Store"),
                           .accessible = tr("Store outputs for later")},
                          this, [this] { store(); })),
      m_synchOutput(new Command({.name = u"synchOutputButton"_s,
                                 .icon = u"send"_s,
                                 .text = tr("Apply"),
                                 .accessible = tr("Apply the stored outputs")},
                                this, [this] { m_context.ask(iointent::SynchOutput{}); })),
      m_stored(look::newMutedLabel({}, this)) {
    look::name(this, u"counterBox"_s, tr("Counter and synchronous I/O"));
    const int unit = look::gridUnit(this);
    auto* grid = new FoldingGrid(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 2);
    buildTimer(*grid);
    grid->setRowMinimumHeight(4, unit);
    buildSynch(*grid, 5);
    grid->setRowStretch(12, 1);
    grid->setColumnStretch(3, 1);
    m_context.whenSeen(this, [this] { refresh(); });
}

void CounterBox::buildTimer(QGridLayout& grid) {
    look::name(m_mode, u"timerModeBox"_s, tr("Counter source"));
    m_mode->addItems({tr("off"), tr("timer, 5 MHz"), tr("counter of rising edges on IO10")});
    look::name(m_prescaler, u"timerPrescalerBox"_s, tr("Prescaler"));
    m_prescaler->addItems(
        {tr("every edge"), tr("every 2nd edge"), tr("every 4th edge"), tr("every 8th edge")});
    look::nameText(m_count, u"counterValue"_s, tr("Count"));
    m_count->setFont(look::tabular(look::scaled(font(), 1.5)));
    m_rate->setObjectName(u"counterRate"_s);
    auto* mode = new QLabel(tr("Count"), this);
    mode->setBuddy(m_mode);
    grid.addWidget(mode, 0, 0);
    grid.addWidget(m_mode, 0, 1, 1, 2);
    auto* prescaler = new QLabel(tr("Counts"), this);
    prescaler->setBuddy(m_prescaler);
    grid.addWidget(prescaler, 1, 0);
    grid.addWidget(m_prescaler, 1, 1, 1, 2);
    grid.addWidget(m_set->button(), 2, 1);
    grid.addWidget(m_count, 3, 1);
    grid.addWidget(m_rate, 3, 2, 1, 2);
}

void CounterBox::buildSynch(QGridLayout& grid, int row) {
    look::nameText(m_latched, u"latchedInputs"_s, tr("Latched values"));
    m_latched->setFont(look::tabular(font()));
    grid.addWidget(new QLabel(tr("Latched"), this), row, 0);
    grid.addWidget(m_synchInput->button(), row, 1);
    grid.addWidget(m_latched, row, 2, 1, 2);
    look::name(m_outputs, u"storedOutputsField"_s, tr("Outputs to store"));
    m_outputs->setRange(0, io::kAllPins);
    m_outputs->setWords(tr("Outputs to store"), {});
    m_outputs->setMeaning(tr("Add up the outputs: IO1 is 1, IO2 is 2, IO3 is 4, up to IO12, which is 2048."));
    m_outputs->setDigits(5);
    m_outputs->showValue(0);
    auto* outputs = new QLabel(tr("Outputs"), this);
    outputs->setBuddy(m_outputs);
    grid.addWidget(outputs, row + 1, 0);
    grid.addWidget(m_outputs, row + 1, 1);
    for (std::size_t i = 0; i < m_pwm.size(); ++i) {
        const QString label = u"PWM"_s + QString::number(i + 1);
        m_pwm.at(i) = new NumberField(0, this);
        look::name(m_pwm.at(i), u"storedPwm%1Field"_s.arg(i + 1), tr("%1 to store").arg(label));
        m_pwm.at(i)->setRange(0, 255);
        m_pwm.at(i)->setWords(label, {});
        m_pwm.at(i)->setDigits(5);
        m_pwm.at(i)->showValue(0);
        auto* name = new QLabel(label, this);
        name->setBuddy(m_pwm.at(i));
        grid.addWidget(name, row + 2 + static_cast<int>(i), 0);
        grid.addWidget(m_pwm.at(i), row + 2 + static_cast<int>(i), 1);
    }
    m_stored->setObjectName(u"storedOutputs"_s);
    grid.addWidget(m_store->button(), row + 4, 1);
    grid.addWidget(m_stored, row + 4, 2, 1, 2);
    grid.addWidget(m_synchOutput->button(), row + 5, 1);
    for (NumberField* field : {m_outputs, m_pwm[0], m_pwm[1]})
        connect(field, &NumberField::edited, this, &CounterBox::refresh);
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

QString CounterBox::rate() const {
    const ModuleState& module = m_context.state();
    const auto& timer = module.pins.timer;
    if (!timer)
        return tr("Counter source unknown: another program has set it.");
    if (!timer->enable)
        return tr("off");
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
