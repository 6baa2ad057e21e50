// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/detailsbox.h"

#include <QLabel>

#include "model/module/stepperdefaults.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString modeName(StepperMode mode) {
    switch (mode) {
        case StepperMode::Stopped:
            return DetailsBox::tr("stopped");
        case StepperMode::Trapezoidal:
            return DetailsBox::tr("trapezoidal profile");
        case StepperMode::VelocityProfile:
            return DetailsBox::tr("velocity profile");
        case StepperMode::UnprofiledWithStop:
            return DetailsBox::tr("unprofiled, with stop");
        case StepperMode::Unprofiled:
            return DetailsBox::tr("unprofiled, without stop");
        case StepperMode::Unknown:
            return DetailsBox::tr("moving, commanded by another program");
    }
    return {};
}

}  // namespace

DetailsBox::DetailsBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_grid(new FormGrid(this, 2, {.ends = 1, .across = 1.5})),
      m_bytes(new FlowLayout(look::gridUnit(this) * 4)) {
    look::name(this, m_context.named(u"detailsBox"_s), Common::tr("Details"));
    m_grid->setColumnStretch(1, 1);
    m_grid->addWide(m_bytes);
    m_grid->addGap(1);
    if (m_context.state().isStepper())
        addStepper();
    else
        addServo();
    m_saveHome = new Command({.name = m_context.named(u"saveHomeButton"_s),
                              .icon = u"home"_s,
                              .text = Common::tr("Save as home"),
                              .accessible = Common::tr("Save as home: the present position")},
                             this, [this] { m_context.ask(intent::SaveAsHome{}); });
    m_grid->addGap(1);
    m_grid->addWide(new FlowLayout(look::gridUnit(this), {m_first->button(), m_saveHome->button()}));
    m_grid->end();
    m_context.whenSeen(this, [this] { refresh(); });
}

void DetailsBox::addServo() {
    m_first = new Command({.name = u"clearStickyButton"_s,
                           .icon = u"eraser"_s,
                           .text = tr("Clear stic&ky bits"),
                           .accessible = tr("Clear sticky bits of the status")},
                          this, [this] { m_context.ask(intent::ClearStickyBits{}); });
    m_status = addBits(
        Common::tr("Status byte"), servo::kStatusBitNames,
        {tr("The move has ended; in velocity mode the goal velocity is reached."),
         Common::tr("The module received a garbled command and did not carry it out."),
         tr("The current limit was reached. Stays set until you clear the sticky bits."),
         tr("Motor power is present."),
         tr("The position error exceeded its limit, or the servo is off. Stays set until you clear the sticky bits."),
         Common::tr("Limit switch 1."), Common::tr("Limit switch 2."),
         Common::tr("Waiting for the home position.")});
    const bool path = hasPathBuffer(m_context.state().info.identity);
    m_aux = addBits(
        tr("Auxiliary byte"), path ? servo::kCmcAuxBitNames : servo::kAuxBitNames,
        {tr("The complement of the encoder's index."),
         tr("The 32-bit position has wrapped. Stays set until you clear the sticky bits."),
         tr("The servo is on."), tr("The first acceleration phase of the move has ended."),
         tr("The constant phase of the move has ended."),
         tr("A servo tick took too long; typically not serious. Stays set until you clear the sticky bits."),
         Common::tr("The motor follows the points of a path."), QString()});
    addAnalog(tr("A/D (motor current)"));
    addValue(tr("Velocity reported by the chip"), u"chipVelocityLabel"_s, [](const StatusReport& report) {
        return report.velocity ? texts::grouped(*report.velocity) + u' ' + texts::unitVelocity() : QString();
    });
    if (path) {
        addValue(tr("Position error reported by the chip"), u"chipErrorLabel"_s,
                 [](const StatusReport& report) {
                     return report.positionError
                                ? texts::grouped(*report.positionError) + u' ' + texts::unitCounts()
                                : QString();
                 });
        addValue(tr("Path points left"), u"pathPointsLabel"_s, [](const StatusReport& report) {
            return report.pathPoints ? QString::number(*report.pathPoints) : QString();
        });
    }
    addEnd(tr(", auxiliary %1"));
}

void DetailsBox::addStepper() {
    m_first = new Command({.name = u"stepperZeroHereButton"_s,
                           .icon = u"eraser"_s,
                           .text = tr("&Zero here"),
                           .accessible = Common::tr("Zero here: set the present position to 0")},
                          this, [this] { m_context.ask(intent::ResetPosition{}); });
    m_status = addBits(
        Common::tr("Status byte"), stepper::kStatusBitNames,
        {tr("The module is sending step pulses."),
         Common::tr("The module received a garbled command and did not carry it out."),
         tr("The driver is enabled (AMP_EN is high)."), tr("Motor power is present (PWR_SENSE is high)."),
         tr("The motor has reached its commanded speed."), tr("Runs with a ramp: velocity profile mode."),
         tr("Moves to a position with a ramp: trapezoidal profile mode."),
         Common::tr("Waiting for the home position.")});
    m_aux = addBits(
        tr("Inputs byte"), stepper::kInputBitNames,
        {tr("High stops the motor, unless it is ignored."), tr("General purpose input."),
         tr("General purpose input."), tr("High blocks counting up, unless it is ignored."),
         tr("High blocks counting down, unless it is ignored."), tr("For homing."), QString(), QString()});
    addValue(tr("Mode"), u"modeLabel"_s,
             [this](const StatusReport& /*report*/) { return modeName(m_context.state().stepper.mode()); });
    addValue(tr("Timer count"), u"timerLabel"_s, [this](const StatusReport& report) {
        return report.timerCount ? timer(*report.timerCount) : QString();
    });
    addAnalog(Common::tr("A/D (temperature)"));
    addEnd(tr(", inputs %1"));
}

DetailsBox::Bits DetailsBox::addBits(const QString& title, const std::array<std::string_view, 8>& names,
                                     const std::array<QString, 8>& meanings) {
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(unit * 2 / 3);
    grid->setVerticalSpacing(unit / 3);
    m_bytes->addLayout(grid);
    grid->addWidget(form::newHeading(title, this), 0, 0, 1, 3);
    Bits bits;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty())
            continue;
        const QString name = QString::fromLatin1(names[i].data(), static_cast<qsizetype>(names[i].size()));
        bits[i].glyph = new GlyphLabel(this);
        auto* label = new QLabel(name, this);
        bits[i].value =
            look::newMutedLabel(u"–"_s, this, m_context.named(u"bit_"_s) + QString(name).replace(u' ', u'_'));
        for (QWidget* widget : std::initializer_list<QWidget*>{bits[i].glyph, label, bits[i].value})
            widget->setToolTip(meanings[i]);
        const int line = static_cast<int>(i) + 1;
        grid->addWidget(bits[i].glyph, line, 0, Qt::AlignCenter);
        grid->addWidget(label, line, 1);
        grid->addWidget(bits[i].value, line, 2);
    }
    return bits;
}

QLabel* DetailsBox::addValue(const QString& label, const QString& objectName, const Reading& reading) {
    auto* name = new QLabel(label, this);
    auto* value = new QLabel(this);
    value->setObjectName(m_context.named(objectName));
    value->setFont(look::tabular(font()));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_grid->addLine({name, value});
    m_values.push_back({value, reading});
    return value;
}

void DetailsBox::addAnalog(const QString& label) {
    addValue(label, u"analogLabel"_s, [this](const StatusReport& report) {
        return texts::analogReading(m_context.settings().analog, report.analog);
    });
}

void DetailsBox::addEnd(const QString& aux) {
    addValue(Common::tr("Home register"), u"homeLabel"_s, [this](const StatusReport& report) {
        return report.home ? texts::position(m_context.scale(), *report.home) : QString();
    })->setToolTip(texts::homeRegisterMeaning());
    addValue(Common::tr("Raw"), u"rawLabel"_s, [aux](const StatusReport& report) {
        const QString status = Common::tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        return report.aux ? status + aux.arg(*report.aux, 2, 16, QChar(u'0')) : status;
    });
}

QString DetailsBox::timer(std::uint16_t count) const {
    const ModuleState& module = m_context.state();
    // At rest, the count is left from the last motion.
    if (!module.stepper.parameters || !module.moving())
        return texts::grouped(count);
    const double rate = StepperSpeed(module.stepper.parameters->speedMode).ofCount(count);
    return tr("%1 = %2").arg(texts::grouped(count), texts::stepsPerSecond(rate, m_context.scale()));
}

void DetailsBox::refresh() {
    const ModuleState& module = m_context.state();
    const std::optional<StatusReport>& latest = module.latest;
    showBits(m_status, latest ? std::optional(latest->status) : std::nullopt);
    showBits(m_aux, latest ? latest->aux : std::nullopt);
    for (const auto& [label, reading] : m_values) {
        const QString text = latest ? reading(*latest) : QString();
        look::setText(label, text.isEmpty() ? u"–"_s : text);
    }
    if (module.isStepper())
        m_first->setPossible(m_context.reasonNow(IntentKind::ResetPosition),
                             texts::zeroMeaning(module, m_context.scale()));
    else
        m_first->setPossible(
            m_context.reasonNow(IntentKind::ClearStickyBits),
            tr("Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing."));
    m_saveHome->setPossible(m_context.reasonNow(IntentKind::SaveAsHome),
                            Common::tr("Saves the present position as home. The motor does not move."));
}

void DetailsBox::showBits(const Bits& bits, std::optional<std::uint8_t> byte) {
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i].glyph == nullptr)
            continue;
        const auto set = byte ? std::optional((unsigned{*byte} >> i & 1U) != 0) : std::nullopt;
        bits[i].glyph->showBit(set);
        look::setText(bits[i].value, !set ? u"–"_s : *set ? Common::tr("on") : Common::tr("off"));
    }
}

}  // namespace nmc
