// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/axisbox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <cmath>

#include "model/module/servodefaults.h"
#include "model/settings/axisscale.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/directioncheckbox.h"
#include "widgets/panels/travelbox.h"
#include "widgets/panels/unitdialog.h"
#include "widgets/panels/workbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kLongestAxisUnit = 12;
constexpr int kScaleDecimals = 6;
constexpr double kLargestAnalog = 1e6;

/// Shows a text that is kept elsewhere, without disturbing the one being typed: after a trailing space,
/// another word may follow.
void showText(QLineEdit* field, const std::string& text) {
    if (const QString shown = QString::fromStdString(text); field->text().trimmed() != shown.trimmed()) {
        const QSignalBlocker blocker(field);
        field->setText(shown);
    }
}

void showNumber(NumberField* field, double value, std::optional<double> before) {
    if (!before || (value != *before && field->value() != value))
        field->showValue(value);
}

}  // namespace

AxisBox::AxisBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_type(context.state().info.identity.type) {
    look::name(this, m_context.named(u"axisBox"_s), Common::tr("Axis"));
    build();
    connectControls();
    m_context.whenSeen(this, [this] { showModule(); });
}

NumberField* AxisBox::addNumber(QFormLayout* form, const QString& label, const QString& objectName,
                                double largest, const QString& meaning) {
    QString name = label;
    auto* field = form::newNumber({.name = m_context.named(objectName),
                                   .accessible = name.remove(u'&'),
                                   .min = -largest,
                                   .max = largest,
                                   .decimals = kScaleDecimals,
                                   .meaning = meaning},
                                  this);
    form->addRow(label, field);
    return field;
}

void AxisBox::build() {
    const int unit = look::gridUnit(this);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(unit, unit, unit, unit);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    form->setHorizontalSpacing(unit);
    form->setVerticalSpacing(unit / 2);
    m_name = form::newText({.name = m_context.named(u"axisNameField"_s),
                            .accessible = tr("Name of the axis"),
                            .maxLength = kMaxNameLength,
                            .meaning = tr("The name of this axis in the list, in messages and in files."),
                            .example = tr("For example: Z axis")},
                           this);
    form->addRow(tr("N&ame"), m_name);
    m_unit = form::newChoice(
        {.name = m_context.named(u"axisUnitBox"_s),
         .accessible = tr("Unit of the axis"),
         .options = {{tr("native counts"), static_cast<int>(UnitKind::Native)},
                     {Common::tr("turns"), static_cast<int>(UnitKind::Turns)},
                     {tr("degrees"), static_cast<int>(UnitKind::Degrees)},
                     {tr("millimetres"), static_cast<int>(UnitKind::Millimetres)},
                     {tr("custom unit"), static_cast<int>(UnitKind::Own)}},
         .meaning = tr(
             "The unit for positions and speeds. Changing it keeps every physical value and sends nothing.")},
        this);
    form->addRow(tr("Un&it"), m_unit);
    m_countsPerUnit = addNumber(form, tr("Counts in 1 unit"), u"countsPerUnitField"_s, kMaxCountsPerUnit,
                                tr("Counts or steps per unit."));
    m_countsPerUnit->setRange(kMinCountsPerUnit, kMaxCountsPerUnit);
    m_countsPerUnitLabel = qobject_cast<QLabel*>(form->labelForField(m_countsPerUnit));
    m_reversed = form::newCheck(
        {.name = m_context.named(u"axisReversedBox"_s),
         .text = tr("reversed: forward counts down"),
         .meaning = tr(
             "Reverses positions, directions and travel limits of this axis on the screen. Sends nothing.")},
        this);
    form->addRow(QString(), m_reversed);
    auto* workOut = new QPushButton(tr("Calculate…"), this);
    look::name(workOut, m_context.named(u"workOutUnitButton"_s),
               tr("Calculate the unit from encoder, gear and screw"));
    workOut->setToolTip(tr("Calculates the unit from the data of encoder, gear and screw. Sends nothing."));
    connect(workOut, &QPushButton::clicked, this, &AxisBox::workOutUnit);
    form->addRow(QString(), workOut);
    m_symbol = form::newText({.name = m_context.named(u"axisSymbolField"_s),
                              .accessible = tr("Symbol of the unit"),
                              .maxLength = kLongestAxisUnit,
                              .meaning = tr("Shown after the numbers, for example µl.")},
                             this);
    form->addRow(tr("Symbol"), m_symbol);
    m_symbolLabel = qobject_cast<QLabel*>(form->labelForField(m_symbol));
    if (m_type == ModuleType::Servo)  // where a user looks in the first session
        form->addRow(new DirectionCheckBox(m_context, this));
    m_holdCap = form::newQuantity(
        {.kind = QuantityField::Kind::Velocity,
         .name = m_type == ModuleType::Servo ? u"holdCapField"_s : u"stepperAxisHoldCapField"_s,
         .accessible = Common::tr("Max jog speed"),
         .meaning = tr("Jog is never faster than this.")},
        this);
    auto* cap = form::newLine(this, {m_holdCap, m_holdCap->unitLabel(), m_holdCap->otherView(), nullptr});
    form->addRow(tr("Max &jog speed"), cap);
    qobject_cast<QLabel*>(form->labelForField(cap))->setBuddy(m_holdCap);
    form->setRowVisible(cap, m_type == ModuleType::Servo);
    m_analogPerCount = addNumber(
        form, tr("A/D scale, per count"), u"analogPerCountField"_s, kLargestAnalog,
        tr("The value of one A/D count, for example 5 V / 255, or amperes from the amplifier's current sense."));
    m_analogAtZero = addNumber(form, tr("A/D at &0"), u"analogAtZeroField"_s, kLargestAnalog,
                               Common::tr("The value at an A/D reading of 0."));
    m_analogUnit = form::newText({.name = m_context.named(u"analogUnitField"_s),
                                  .accessible = tr("Unit of the A/D value"),
                                  .maxLength = kLongestAxisUnit,
                                  .meaning = tr("A, V, or whatever the A/D input measures.")},
                                 this);
    form->addRow(tr("A/D unit"), m_analogUnit);
    m_hint = form::newParagraph(m_context.named(u"axisHint"_s), {}, this);
    form->addRow(m_hint);
    form->addRow(new WorkBox(m_context, this));
    form->addRow(new TravelBox(m_context, this));
}

void AxisBox::workOutUnit() {
    auto* dialog = findChild<UnitDialog*>();
    if (dialog == nullptr)
        dialog = new UnitDialog(m_context, this);
    look::showInFront(dialog);
}

UnitKind AxisBox::kind() const {
    return form::chosen<UnitKind>(m_unit);
}

void AxisBox::showModule() {
    const AxisSettings& settings = m_context.settings();
    const auto before = [this](auto part) {
        return m_shown ? std::optional<double>(part(*m_shown)) : std::nullopt;
    };
    showText(m_name, settings.name);
    {
        const QSignalBlocker blocker(m_unit);
        form::choose(m_unit, settings.unit.kind);
    }
    showNumber(m_countsPerUnit, std::abs(settings.unit.countsPerUnit),
               before([](const AxisSettings& axis) { return std::abs(axis.unit.countsPerUnit); }));
    {
        const QSignalBlocker blocker(m_reversed);
        m_reversed->setChecked(settings.unit.countsPerUnit < 0);
    }
    showText(m_symbol, settings.unit.ownSymbol);
    m_holdCap->setScale(m_context.scale());
    m_holdCap->setNativeRange(servodefaults::kSmallest,
                              servodefaults::fastest(m_context.state().info.identity));
    const double cap = servodefaults::motionOf(settings).holdCap;
    if (!m_shown)
        m_holdCap->showNative(cap);
    else  // the value being typed is kept
        m_holdCap->follow(cap, servodefaults::motionOf(*m_shown).holdCap);
    showNumber(m_analogPerCount, settings.analog.perCount,
               before([](const AxisSettings& axis) { return axis.analog.perCount; }));
    showNumber(m_analogAtZero, settings.analog.atZero,
               before([](const AxisSettings& axis) { return axis.analog.atZero; }));
    showText(m_analogUnit, settings.analog.unit);
    m_shown = settings;
    refresh();
}

void AxisBox::connectControls() {
    // Each field edits only its own part: the value in another one may be rounded or incomplete.
    const auto keepText = [this](QLineEdit* field, auto part) {
        connect(field, &QLineEdit::textEdited, this, [this, part](const QString& text) {
            edit([part, typed = text.trimmed().toStdString()](AxisSettings& axis) { part(axis) = typed; });
        });
    };
    const auto keepNumber = [this](NumberField* field, auto part) {
        connect(field, &NumberField::edited, this, [this, field, part] {
            edit([part, typed = field->value()](AxisSettings& axis) {
                part(axis) = typed.value_or(part(axis));
            });
        });
    };
    keepText(
        m_name, [](AxisSettings & axis) -> auto& { return axis.name; });
    keepText(
        m_analogUnit, [](AxisSettings & axis) -> auto& { return axis.analog.unit; });
    keepText(
        m_symbol, [](AxisSettings & axis) -> auto& { return axis.unit.ownSymbol; });
    const auto keepScale = [this] {
        edit([typed = m_countsPerUnit->value(), reversed = m_reversed->isChecked()](AxisSettings& axis) {
            const double counts = typed.value_or(std::abs(axis.unit.countsPerUnit));
            axis.unit.countsPerUnit = reversed ? -counts : counts;
        });
    };
    connect(m_countsPerUnit, &NumberField::edited, this, keepScale);
    connect(m_reversed, &QCheckBox::toggled, this, keepScale);
    keepNumber(
        m_analogPerCount, [](AxisSettings & axis) -> auto& { return axis.analog.perCount; });
    keepNumber(
        m_analogAtZero, [](AxisSettings & axis) -> auto& { return axis.analog.atZero; });
    connect(m_unit, &QComboBox::currentIndexChanged, this, [this] {
        if (kind() == UnitKind::Native)
            m_countsPerUnit->showValue(1.0);  // as below, for the unit that is chosen next
        edit([chosen = kind()](AxisSettings& axis) {
            axis.unit.kind = chosen;
            if (chosen == UnitKind::Native)
                axis.unit.countsPerUnit = 1.0;
        });
    });
    connect(m_holdCap, &QuantityField::nativeEdited, this, [this] {
        edit([typed = m_holdCap->native()](AxisSettings& axis) {
            axis.motion.holdCap = typed.value_or(axis.motion.holdCap);
        });
    });
}

void AxisBox::edit(const SettingsEdit& change) {
    if (m_shown)
        change(*m_shown);
    m_context.edit(change);
    refresh();
}

void AxisBox::refresh() {
    const UnitKind unit = kind();
    const bool own = unit == UnitKind::Own;
    m_symbol->setVisible(own);
    m_symbolLabel->setVisible(own);
    m_countsPerUnit->setVisible(unit != UnitKind::Native);
    m_countsPerUnitLabel->setVisible(unit != UnitKind::Native);
    m_reversed->setVisible(unit != UnitKind::Native);
    AxisUnit shown = m_context.settings().unit;
    shown.kind = unit;
    const bool steps = m_context.scale().steps();
    const AxisScale scale = steps ? AxisScale::step(shown) : AxisScale::servo(shown, 1);
    const QString counts = steps ? texts::unitSteps() : texts::unitCounts();
    const QString label = tr("%1 in 1 %2").arg(counts, texts::unitOf(scale));
    look::setText(m_countsPerUnitLabel, label);
    m_countsPerUnit->setWords(label, {});
    m_countsPerUnit->setAccessibleName(label);
    QString hint;
    for (const NumberField* field : {m_countsPerUnit, m_analogPerCount, m_analogAtZero})
        if (hint.isEmpty() && !field->isHidden())
            hint = field->problemText();
    if (hint.isEmpty())
        hint = m_holdCap->problemText();
    if (hint.isEmpty() && m_context.namesake())
        hint = tr("Axis %1 has the same name, so programs can call neither by it.")
                   .arg(m_context.namesake()->value() + 1);
    look::setText(m_hint, hint);
    m_hint->setVisible(!hint.isEmpty());
}

}  // namespace nmc
