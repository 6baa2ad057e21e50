// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepdetailsbox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/glyphs.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/stepdefaults.h"
#include "widgets/panels/stepwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString statusMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        StepDetailsBox::tr("Step pulses are coming."),
        StepDetailsBox::tr("The module could not read the last command; it was not carried out."),
        StepDetailsBox::tr("The driver is enabled (AMP_EN is high)."),
        StepDetailsBox::tr("Motor power is present (PWR_SENSE is high)."),
        StepDetailsBox::tr("The motor has the speed that was asked for."),
        StepDetailsBox::tr("Runs with a ramp: velocity profile mode."),
        StepDetailsBox::tr("Moves to a position with a ramp: trapezoidal profile mode."),
        StepDetailsBox::tr("Waiting for the home position.")};
    return meanings[bit];
}

QString inputMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{StepDetailsBox::tr("High stops the motor, unless it is ignored."),
                                          StepDetailsBox::tr("General purpose input."),
                                          StepDetailsBox::tr("General purpose input."),
                                          StepDetailsBox::tr("High blocks forward, unless it is ignored."),
                                          StepDetailsBox::tr("High blocks reverse, unless it is ignored."),
                                          StepDetailsBox::tr("For homing."),
                                          QString(),
                                          QString()};
    return meanings[bit];
}

QString bitName(std::string_view name) {
    return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

QString modeName(bus::StepMode mode) {
    switch (mode) {
        case bus::StepMode::Stopped:
            return StepDetailsBox::tr("stopped");
        case bus::StepMode::Trapezoidal:
            return StepDetailsBox::tr("trapezoidal profile");
        case bus::StepMode::VelocityProfile:
            return StepDetailsBox::tr("velocity profile");
        case bus::StepMode::UnprofiledWithStop:
            return StepDetailsBox::tr("unprofiled, with stop");
        case bus::StepMode::Unprofiled:
            return StepDetailsBox::tr("unprofiled, without stop");
        case bus::StepMode::Unknown:
            return StepDetailsBox::tr("moving as another program told it to");
    }
    return {};
}

}  // namespace

StepDetailsBox::StepDetailsBox(QWidget* parent)
    : QWidget(parent),
      m_zero(new QPushButton(icons::tinted(u"home"_s), tr("&Zero here"), this)),
      m_saveHome(new QPushButton(tr("Save as home"), this)) {
    look::name(this, u"stepDetailsBox"_s, tr("Details"));
    look::name(m_zero, u"stepZeroHereButton"_s, tr("Make the present position zero"));
    look::name(m_saveHome, u"stepSaveHomeButton"_s, tr("Save the present position as home"));
    m_saveHome->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_H));
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    addBits(grid, 0, tr("Status byte"), false);
    addBits(grid, 3, tr("Inputs byte"), true);
    int line = 9;
    grid->setRowMinimumHeight(line++, unit);
    m_mode = addValue(grid, line++, tr("Mode"), u"stepModeLabel"_s);
    m_timer = addValue(grid, line++, tr("Timer count"), u"stepTimerLabel"_s);
    m_analog = addValue(grid, line++, tr("A/D (temperature)"), u"stepAnalogLabel"_s);
    m_home = addValue(grid, line++, tr("Home position"), u"stepHomeLabel"_s);
    m_raw = addValue(grid, line++, tr("Raw"), u"stepRawLabel"_s);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addWidget(m_zero);
    buttons->addWidget(m_saveHome);
    buttons->addStretch(1);
    grid->setRowMinimumHeight(line++, unit);
    grid->addLayout(buttons, line++, 0, 1, 6);
    grid->setRowStretch(line, 1);
    grid->setColumnStretch(2, 1);
    grid->setColumnStretch(5, 1);
    connect(m_zero, &QPushButton::clicked, this, [this] { emit intentRequested(intent::ResetPosition{}); });
    connect(m_saveHome, &QPushButton::clicked, this, [this] { emit intentRequested(intent::SaveAsHome{}); });
    refresh();
}

void StepDetailsBox::addBits(QGridLayout* grid, int column, const QString& title, bool inputs) {
    auto* heading = new QLabel(title, this);
    QFont bold = font();
    bold.setBold(true);
    heading->setFont(bold);
    grid->addWidget(heading, 0, column, 1, 3);
    const auto& names = inputs ? step::kInputBitNames : step::kStatusBitNames;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const QString name = bitName(names[i]);
        if (name.isEmpty())
            continue;
        Bit& bit = (inputs ? m_inputs : m_status)[i];
        bit.glyph = new GlyphLabel(this);
        bit.glyph->showBit(std::nullopt);
        auto* label = new QLabel(name, this);
        bit.value = look::newMutedLabel(u"–"_s, this);
        bit.value->setObjectName(u"stepBit_"_s + QString(name).replace(u' ', u'_'));
        const QString meaning = inputs ? inputMeaning(i) : statusMeaning(i);
        for (QWidget* widget : {static_cast<QWidget*>(bit.glyph), static_cast<QWidget*>(label),
                                static_cast<QWidget*>(bit.value)})
            widget->setToolTip(meaning);
        const int line = static_cast<int>(i) + 1;
        grid->addWidget(bit.glyph, line, column, Qt::AlignCenter);
        grid->addWidget(label, line, column + 1);
        grid->addWidget(bit.value, line, column + 2);
    }
}

QLabel* StepDetailsBox::addValue(QGridLayout* grid, int line, const QString& label,
                                 const QString& objectName) {
    grid->addWidget(new QLabel(label, this), line, 0, 1, 3);
    auto* value = new QLabel(u"–"_s, this);
    value->setObjectName(objectName);
    value->setFont(look::tabular(font()));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(value, line, 3, 1, 3);
    return value;
}

void StepDetailsBox::showBit(const Bit& bit, std::optional<bool> set) {
    if (bit.glyph == nullptr)
        return;
    bit.glyph->showBit(set);
    look::setText(bit.value, !set.has_value() ? u"–"_s : *set ? tr("on") : tr("off"));
}

void StepDetailsBox::showModule(const PanelView& view) {
    const std::optional<StatusReport>& report = view.module.latest;
    const auto bitOf = [](const std::optional<std::uint8_t>& byte, std::size_t bit) {
        return byte ? std::optional((unsigned{*byte} >> bit & 1U) != 0) : std::nullopt;
    };
    for (std::size_t i = 0; i < 8; ++i) {
        showBit(m_status[i], bitOf(report ? std::optional(report->status) : std::nullopt, i));
        showBit(m_inputs[i], bitOf(report ? report->aux : std::nullopt, i));
    }
    showValues(view);
    m_whyNotZero = view.whyNot(Request::ResetPosition);
    m_whyNotHome = view.whyNot(Request::SaveAsHome);
    refresh();
}

void StepDetailsBox::showValues(const PanelView& view) {
    const QString dash = u"–"_s;
    const StatusReport report = view.module.latest.value_or(StatusReport{});
    look::setText(m_mode, view.module.latest ? modeName(view.module.stepper.mode()) : dash);
    QString timer = dash;
    if (report.timerCount) {
        timer = texts::grouped(*report.timerCount);
        if (view.module.stepper.parameters()) {
            const double rate =
                StepSpeed(view.module.stepper.parameters()->speedMode).ofCount(*report.timerCount);
            timer = tr("%1, stands for %2").arg(timer, texts::stepsPerSecond(rate, view.scale()));
        }
    }
    look::setText(m_timer, timer);
    look::setText(m_analog,
                  report.analog ? texts::analogReading(view.settings.analog, *report.analog) : dash);
    look::setText(m_home, report.home ? texts::position(view.scale(), *report.home) : dash);
    QString raw = dash;
    if (view.module.latest) {
        raw = tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        if (report.aux)
            raw += tr(", inputs %1").arg(*report.aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
}

void StepDetailsBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void StepDetailsBox::refresh() {
    const auto reason = [this](const std::optional<Refusal>& refusal) {
        return refusal  ? texts::refusal(*refusal)
               : m_busy ? tr("Waiting for the module's answer.")
                        : QString();
    };
    look::setPossible(m_zero, reason(m_whyNotZero),
                      tr("Makes the present position 0. The motor does not move."));
    look::setPossible(m_saveHome, reason(m_whyNotHome),
                      tr("Keeps the present position as home. The motor does not move."));
}

}  // namespace nmc
