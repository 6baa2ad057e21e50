// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/unitdialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kCountsPerLine = 4;  // DS-V 3: all edges of both channels
constexpr double kLargestEntry = 1e6;
constexpr int kDecimals = 6;
constexpr int kResultLines = 2;  // kept free when a row is added above them
}  // namespace

UnitDialog::UnitDialog(ModuleContext& context, QWidget* parent)
    : QDialog(parent), m_context(context), m_form(new QFormLayout(this)) {
    // It stays open while the page of another module is shown.
    const QString title =
        Common::tr("%1: %2").arg(texts::moduleName(context.state().info.index), tr("Calculate the unit"));
    look::name(this, u"unitDialog"_s, title);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    m_kind =
        form::newChoice({.name = u"unitDialogKind"_s,
                         .accessible = tr("Type of axis"),
                         .options = {{tr("rotary, in turns"), static_cast<int>(UnitKind::Turns)},
                                     {tr("rotary, in degrees"), static_cast<int>(UnitKind::Degrees)},
                                     {tr("linear, in millimetres"), static_cast<int>(UnitKind::Millimetres)}},
                         .meaning = tr("The unit to display for this axis.")},
                        this);
    m_form->addRow(tr("The axis"), m_kind);
    if (m_context.state().isStepper()) {
        m_perTurn = addField(u"unitDialogSteps"_s, tr("Full steps per motor turn"), 200,
                             tr("200 for a motor with 1.8 degrees per step."));
        m_microsteps = addField(u"unitDialogMicrosteps"_s, tr("Microsteps per full step"), 1,
                                tr("As set on the driver; 1 for full steps, 2 for half steps."));
    } else {
        m_perTurn = addField(u"unitDialogLines"_s, tr("Encoder lines per turn"), 500,
                             tr("As on its label: lines, CPR or PPR. The chip counts four per line."));
    }
    m_motorTurns = addField(u"unitDialogMotorTurns"_s, tr("Gear: motor turns"), 1,
                            tr("For a 50 : 1 gear, enter 50; without a gear, 1."));
    m_outputTurns =
        addField(u"unitDialogOutputTurns"_s, tr("Gear: output turns"), 1, tr("For a 50 : 1 gear, enter 1."));
    m_travel = addField(
        u"unitDialogTravel"_s, tr("Travel per output turn (mm)"), 5,
        tr("Lead screw: pitch times starts. Belt: pulley teeth times belt pitch. Rack: pinion teeth times rack pitch."));
    m_result = form::newParagraph(u"unitDialogResult"_s, tr("Calculated unit"), this, kResultLines);
    m_form->addRow(m_result);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    look::name(buttons->button(QDialogButtonBox::Cancel), u"unitDialogCancel"_s, Common::tr("Cancel"));
    m_use = buttons->addButton(tr("Use this unit"), QDialogButtonBox::AcceptRole);
    look::name(m_use, u"unitDialogUse"_s, tr("Use this unit"));
    m_form->addRow(buttons);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &UnitDialog::refresh);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_use, &QPushButton::clicked, this, &UnitDialog::take);
    if (const int now = m_kind->findData(static_cast<int>(m_context.settings().unit.kind)); now >= 0)
        m_kind->setCurrentIndex(now);
    refresh();
}

NumberField* UnitDialog::addField(const QString& name, const QString& label, double value,
                                  const QString& meaning) {
    auto* field = form::newNumber({.name = name,
                                   .accessible = label,
                                   .min = 1 / kLargestEntry,
                                   .max = kLargestEntry,
                                   .decimals = kDecimals,
                                   .meaning = meaning},
                                  this);
    field->showValue(value);
    connect(field, &NumberField::edited, this, &UnitDialog::refresh);
    m_form->addRow(label, field);
    return field;
}

UnitKind UnitDialog::kind() const {
    return form::chosen<UnitKind>(m_kind);
}

DriveTrain UnitDialog::drive() const {
    const auto number = [](const NumberField* field) { return field->value().value_or(0); };
    const double each = m_microsteps != nullptr ? number(m_microsteps) : kCountsPerLine;
    return {number(m_perTurn) * each, number(m_motorTurns), number(m_outputTurns), number(m_travel)};
}

void UnitDialog::refresh() {
    m_form->setRowVisible(m_travel, kind() == UnitKind::Millimetres);
    const auto counts = countsPerUnit(kind(), drive());
    QString text = tr("Enter a number above 0 in each field.");
    if (counts) {
        const AxisUnit unit{kind(), *counts, {}};
        const AxisScale scale =
            m_context.state().isStepper() ? AxisScale::step(unit) : AxisScale::servo(unit, 1);
        const QString symbol = texts::unitOf(scale);
        const QString native = m_context.state().isStepper() ? Common::tr("steps") : tr("counts");
        text = tr("1 %1 is %2 %3. The smallest step is %4 %5.")
                   .arg(kind() == UnitKind::Turns ? tr("turn") : symbol, texts::readout(*counts, 6), native,
                        texts::readout(1 / *counts, 7), symbol);
    }
    look::setText(m_result, text);
    look::setPossible(m_use, counts ? QString() : text,
                      tr("Sets this unit for the axis. Keeps every physical value and sends nothing."));
}

void UnitDialog::take() {
    if (const auto counts = countsPerUnit(kind(), drive()))
        // The sign is kept: the drive train does not determine the direction.
        m_context.edit([chosen = kind(), counts = *counts](AxisSettings& axis) {
            axis.unit.kind = chosen;
            axis.unit.countsPerUnit = std::copysign(counts, axis.unit.countsPerUnit);
        });
    close();
}

}  // namespace nmc
