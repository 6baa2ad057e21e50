// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/simulator/modulebench.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QJsonArray>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "protocol/iocommands.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr double kMaxCounts = 2'000'000'000;
/// Distance of a new hard stop from the shaft: five turns.
constexpr double kTravel = 10'000;
constexpr int kPins = 12;
constexpr int kPinsInARow = 4;

/// A stepper's pins are in an object of their own.
QJsonValue stateValue(const QJsonObject& state, const QString& name) {
    return state.contains(name) ? state[name] : state["inputs"_L1].toObject()[name];
}

QGridLayout* newPage(QTabWidget& tabs, const QString& title) {
    auto* page = new QWidget(&tabs);
    const int unit = look::gridUnit(&tabs);
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(unit, unit / 2, unit, 0);
    grid->setHorizontalSpacing(unit / 2);
    grid->setVerticalSpacing(unit / 3);
    tabs.addTab(page, title);
    return grid;
}

}  // namespace

ModuleBench::ModuleBench(ModuleType type, QWidget* parent)
    : QTabWidget(parent),
      m_type(type),
      m_prefix(type == ModuleType::Stepper ? u"sim_step_"_s
               : type == ModuleType::Io    ? u"sim_io_"_s
                                           : u"sim_servo_"_s) {
    look::name(this, m_prefix + u"bench"_s, tr("Simulated module controls"));
    setDocumentMode(true);
    tabBar()->setObjectName(m_prefix + u"pages"_s);
    tabBar()->setAccessibleName(tr("Pages of the simulated module"));
    if (type == ModuleType::Io) {
        buildPins();
    } else {
        buildSwitches();
        buildMechanics();
    }
}

QAbstractButton* ModuleBench::addSwitch(QGridLayout& grid, const QString& name, const QString& text,
                                        const QString& meaning) {
    auto* box = form::newCheck({m_prefix + name + u"Box"_s, text, {}, meaning}, grid.parentWidget());
    grid.addWidget(box, grid.rowCount(), 0, 1, 3, Qt::AlignLeft);
    connect(box, &QAbstractButton::clicked, this, [this, name](bool on) { set(name, on ? u"1"_s : u"0"_s); });
    m_switches.append({name, box, meaning});
    return box;
}

QAbstractButton* ModuleBench::addButton(QGridLayout& grid, int column, const QString& objectName,
                                        const QString& text, const QString& meaning) {
    auto* button = form::newPush({m_prefix + objectName, text, {}, meaning}, grid.parentWidget());
    grid.addWidget(button, column == 0 ? grid.rowCount() : grid.rowCount() - 1, column);
    return button;
}

void ModuleBench::buildSwitches() {
    QGridLayout& grid = *newPage(*this, tr("Switches"));
    const QString pin = tr("Closed while checked.");
    addSwitch(grid, u"power"_s, Common::tr("Motor power"), tr("The motor's supply, not the module's."));
    if (m_type == ModuleType::Stepper) {
        addSwitch(grid, u"limit1"_s, tr("Limit switch 1, forward"), pin);
        addSwitch(grid, u"limit2"_s, tr("Limit switch 2, reverse"), pin);
        addSwitch(grid, u"home_switch"_s, Common::tr("Home switch"), pin);
        addSwitch(grid, u"estop"_s, Common::tr("E-stop input"), pin);
        addSwitch(grid, u"in1"_s, tr("Input 1"), pin);
        addSwitch(grid, u"in2"_s, tr("Input 2"), pin);
        addRow(grid, {.name = u"analog"_s,
                      .label = Common::tr("A/D input"),
                      .unit = Common::tr("of 255"),
                      .meaning = tr("The A/D reading of the temperature sensor."),
                      .max = 255,
                      .step = 1,
                      .sliderMax = 255});
    } else {
        addSwitch(grid, u"limit1"_s, tr("Limit switch 1"), pin);
        addSwitch(grid, u"limit2"_s, tr("Limit switch 2"), pin);
        addSwitch(grid, u"index"_s, tr("Encoder index"), tr("Stays until the shaft moves."));
        addRow(grid, {.name = u"analog"_s,
                      .label = tr("Set the A/D input by hand"),
                      .unit = Common::tr("of 255"),
                      .meaning = tr("If cleared, the A/D input reads the motor current."),
                      .max = 255,
                      .none = u"auto"_s});
    }
    buildCable(grid);
    grid.setRowStretch(grid.rowCount(), 1);
    grid.setColumnStretch(0, 1);
}

void ModuleBench::buildPins() {
    QGridLayout& grid = *newPage(*this, Common::tr("Pins"));
    auto* pins = new QGridLayout;
    grid.addLayout(pins, 0, 0, 1, 3);
    for (int pin = 0; pin < kPins; ++pin) {
        const QString text = u"IO%1"_s.arg(pin + 1);
        auto* box = new QCheckBox(text, grid.parentWidget());
        look::name(box, m_prefix + u"pin%1Box"_s.arg(pin + 1), tr("%1: level").arg(text));
        pins->addWidget(box, pin / kPinsInARow, pin % kPinsInARow);
        connect(box, &QAbstractButton::clicked, this,
                [this, pin](bool on) { set(u"in"_s, u"%1 %2"_s.arg(pin + 1).arg(on ? 1 : 0)); });
        m_pins.append(box);
    }
    for (int input = 1; input <= io::kAnalogInputs; ++input)
        addRow(grid, {.name = u"analog%1"_s.arg(input),
                      .label = Common::tr("A/D %1").arg(input),
                      .unit = Common::tr("of 255"),
                      .meaning = tr("255 is 5 V."),
                      .max = 255,
                      .step = 1,
                      .sliderMax = 255});
    const auto addValue = [&](const QString& objectName, const QString& text, const QString& meaning) {
        auto* label = new QLabel(text, grid.parentWidget());
        auto* value = new QLabel(u"–"_s, grid.parentWidget());
        look::nameText(value, m_prefix + objectName, text);
        label->setToolTip(meaning);
        value->setFont(look::tabular(font()));
        const int row = grid.rowCount();
        grid.addWidget(label, row, 0);
        grid.addWidget(value, row, 1, 1, 2);
        return value;
    };
    m_pwm = addValue(u"pwm"_s, tr("PWM 1 and 2"), tr("The module's PWM outputs, 0 to 255."));
    m_count = addValue(u"count"_s, tr("Timer or counter"), tr("The module's own count."));
    buildCable(grid);
    grid.setRowStretch(grid.rowCount(), 1);
    grid.setColumnStretch(0, 1);
}

void ModuleBench::showPins(const QJsonObject& state) {
    const QJsonArray levels = state["pins"_L1].toArray();
    const QJsonArray inputs = state["is_input"_L1].toArray();
    for (int pin = 0; pin < m_pins.size(); ++pin) {
        m_pins[pin]->setChecked(levels[pin].toBool());
        look::setPossible(m_pins[pin],
                          inputs[pin].toBool() ? QString() : tr("An output: the module sets its level."),
                          tr("High while checked."));
    }
    const QJsonArray analog = state["analog"_L1].toArray();
    for (int input = 0; input < m_rows.size(); ++input)
        m_rows[input]->showValue(analog[input]);
    const QJsonArray pwm = state["pwm"_L1].toArray();
    look::setText(m_pwm, tr("%1 and %2").arg(pwm[0].toInt()).arg(pwm[1].toInt()));
    const QString mode = state["timer_mode"_L1].toString();
    const QString count = texts::grouped(state["count"_L1].toInteger());
    look::setText(m_count, mode == "off"_L1     ? tr("off, %1").arg(count)
                           : mode == "timer"_L1 ? tr("timer, %1").arg(count)
                                                : tr("counter, %1").arg(count));
}

void ModuleBench::buildCable(QGridLayout& grid) {
    m_addressBroken = form::newCheck(
        {m_prefix + u"addressBrokenBox"_s, tr("ADDR line broken towards the host")}, grid.parentWidget());
    m_addressBroken->setToolTip(tr(
        "The line is broken between this module and the next one towards the host, which then gets no address."));
    grid.addWidget(m_addressBroken, grid.rowCount(), 0, 1, 3);
    connect(m_addressBroken, &QAbstractButton::clicked, this,
            [this](bool broken) { say(broken ? u"break"_s : u"mend"_s); });

    auto* buttons = new QGridLayout;
    grid.addLayout(buttons, grid.rowCount(), 0, 1, 3);
    connect(addButton(*buttons, 0, u"powerCycleButton"_s, tr("Power-cycle"),
                      tr("Switches this module off and on: it loses its address and gains.")),
            &QAbstractButton::clicked, this, [this] { say(u"power-cycle"_s); });
    connect(addButton(*buttons, 1, u"powerCycleAllButton"_s, tr("Power-cycle all"),
                      tr("Switches all modules off and on: they lose their addresses and gains.")),
            &QAbstractButton::clicked, this, [this] { emit lineEntered(u"power-cycle all"_s); });
    if (m_type != ModuleType::Servo)
        return;
    connect(addButton(*buttons, 0, u"overrunButton"_s, tr("Late tick"),
                      tr("Makes one servo tick take too long: servo_overrun.")),
            &QAbstractButton::clicked, this, [this] { set(u"servo_overrun"_s, u"1"_s); });
}

void ModuleBench::buildMechanics() {
    QGridLayout& grid = *newPage(*this, tr("Mechanics"));
    const QString unit = m_type == ModuleType::Stepper ? texts::unitSteps() : texts::unitCounts();
    if (m_type != ModuleType::Stepper) {
        // The default motor stalls at 0.8 N·m and has 0.004 N·m of friction: the sliders have the range that
        // is useful for tuning, the fields have the rest.
        addRow(grid, {.name = u"load"_s,
                      .label = tr("Load torque"),
                      .unit = tr("N·m"),
                      .meaning = tr("External torque; positive values turn the shaft in reverse."),
                      .decimals = 4,
                      .min = -100,
                      .max = 100,
                      .step = 0.005,
                      .sliderMin = -0.3,
                      .sliderMax = 0.3});
        addRow(grid, {.name = u"inertia"_s,
                      .label = tr("Inertia"),
                      .unit = tr("10⁻⁶ kg·m²"),
                      .meaning = tr("Moment of inertia of rotor and load."),
                      .decimals = 2,
                      .scale = 1e-6,
                      .min = 1,
                      .max = 100'000'000,
                      .step = 1,
                      .sliderMin = 1,
                      .sliderMax = 200});
        addRow(grid, {.name = u"friction"_s,
                      .label = tr("Friction"),
                      .unit = tr("N·m"),
                      .meaning = tr("Dry friction; it also holds the shaft at rest."),
                      .decimals = 4,
                      .max = 100,
                      .step = 0.001,
                      .sliderMax = 0.1});
    }
    const auto addPlace = [&](const QString& name, const QString& label, const QString& meaning) {
        addRow(grid, {.name = name,
                      .label = label,
                      .unit = unit,
                      .meaning = meaning,
                      .min = -kMaxCounts,
                      .max = kMaxCounts,
                      .step = 1'000,
                      .none = u"none"_s});
    };
    addPlace(
        u"travel_min"_s, tr("Stop, reverse"),
        tr("A hard stop at the reverse end of travel. It cannot be set past the present shaft position."));
    addPlace(
        u"travel_max"_s, tr("Stop, forward"),
        tr("A hard stop at the forward end of travel. It cannot be set past the present shaft position."));
    m_limitsAutomatic =
        form::newCheck({m_prefix + u"limitsBox"_s, tr("Limit switches at the stops")}, grid.parentWidget());
    m_limitsAutomatic->setToolTip(
        tr("The limit switches close at the ends of travel and cannot be set by hand."));
    grid.addWidget(m_limitsAutomatic, grid.rowCount(), 0, 1, 3);
    connect(m_limitsAutomatic, &QAbstractButton::clicked, this,
            [this](bool on) { set(u"limits"_s, on ? u"auto"_s : u"manual"_s); });
    if (m_type == ModuleType::Stepper)
        addPlace(u"home_switch_at"_s, tr("Home switch at"),
                 tr("The home switch is closed forward of this position. If cleared, set it by hand."));
    grid.setRowStretch(grid.rowCount(), 1);
    grid.setColumnStretch(0, 1);
}

void ModuleBench::addRow(QGridLayout& grid, BenchQuantity quantity) {
    auto* row = new BenchRow(std::move(quantity), m_prefix, grid.parentWidget());
    row->addTo(grid);
    connect(row, &BenchRow::entered, this, [this](const QString& name, const QString& value) {
        // A PIC-I/O has three A/D inputs: "analog2" is "analog 2" in a control line.
        if (m_type == ModuleType::Io)
            set(u"analog"_s, name.last(1) + u' ' + value);
        else
            set(name, value);
    });
    m_rows.append(row);
}

void ModuleBench::set(const QString& name, const QString& value) {
    emit lineEntered(u"set %1 %2 %3"_s.arg(m_number).arg(name, value));
}

void ModuleBench::say(const QString& verb) {
    emit lineEntered(u"%1 %2"_s.arg(verb).arg(m_number));
}

void ModuleBench::setModule(int number) {
    if (m_number == number)
        return;
    m_number = number;
    for (BenchRow* row : m_rows)
        row->forget();
}

void ModuleBench::showState(const QJsonObject& state) {
    m_addressBroken->setChecked(state["addr_broken"_L1].toBool());
    if (m_type == ModuleType::Io)
        return showPins(state);
    const bool limitsAutomatic = state["limits"_L1].toString() == "auto"_L1;
    const bool homeAutomatic = state["home_switch_at"_L1].isDouble();
    const QString homeSwitch = m_type == ModuleType::Stepper ? u"home_switch"_s : u"limit1"_s;
    m_limitsAutomatic->setChecked(limitsAutomatic);
    for (const Switch& one : m_switches) {
        one.box->setChecked(stateValue(state, one.name).toBool());
        const bool follows =
            (limitsAutomatic && one.name.startsWith("limit"_L1)) || (homeAutomatic && one.name == homeSwitch);
        look::setPossible(one.box, follows ? tr("Follows the motor's position: see Mechanics.") : QString(),
                          one.meaning);
    }
    const double shaft =
        std::round(stateValue(state, state.contains("shaft"_L1) ? u"shaft"_s : u"position"_s).toDouble());
    for (BenchRow* row : m_rows) {
        if (row->name() == "travel_min"_L1)
            row->setProposal(shaft - kTravel);
        else if (row->name() == "travel_max"_L1)
            row->setProposal(shaft + kTravel);
        else if (row->name() == "home_switch_at"_L1)
            row->setProposal(shaft);
        else if (row->name() == "analog"_L1)
            row->setProposal(state["analog"_L1].toDouble());
        // The A/D input of a servo reads the motor current unless it was set by hand.
        const QString key =
            row->name() == "analog"_L1 && m_type != ModuleType::Stepper ? u"analog_input"_s : row->name();
        row->showValue(state[key]);
    }
}

}  // namespace nmc
