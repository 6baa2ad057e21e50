// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/detailsbox.h"

#include <QLabel>

#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString servoStatusMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        DetailsBox::tr("The move has ended; in velocity mode the goal velocity is reached."),
        Common::tr("The module received a garbled command and did not carry it out."),
        DetailsBox::tr("The current limit was reached. Stays set until you clear the sticky bits."),
        DetailsBox::tr("Motor power is present."),
        DetailsBox::tr(
            "The position error exceeded its limit, or the servo is off. Stays set until you clear the sticky bits."),
        Common::tr("Limit switch 1."),
        Common::tr("Limit switch 2."),
        Common::tr("Waiting for the home position.")};
    return meanings[bit];
}

QString auxMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        DetailsBox::tr("The complement of the encoder's index."),
        DetailsBox::tr("The 32-bit position has wrapped. Stays set until you clear the sticky bits."),
        DetailsBox::tr("The servo is on."),
        DetailsBox::tr("The first acceleration phase of the move has ended."),
        DetailsBox::tr("The constant phase of the move has ended."),
        DetailsBox::tr(
            "A servo tick took too long; typically not serious. Stays set until you clear the sticky bits."),
        Common::tr("The motor follows the points of a path."),
        QString()};
    return meanings[bit];
}

}  // namespace

DetailsBox::DetailsBox(ModuleContext& context, QWidget* parent)
    : StatusTable(parent),
      m_context(context),
      m_clear(new Command({.name = u"clearStickyButton"_s,
                           .icon = u"eraser"_s,
                           .text = tr("Clear stic&ky bits"),
                           .accessible = tr("Clear sticky bits of the status")},
                          this, [this] { m_context.ask(intent::ClearStickyBits{}); })),
      m_saveHome(new Command({.name = u"saveHomeButton"_s,
                              .icon = u"home"_s,
                              .text = Common::tr("Save as home"),
                              .accessible = Common::tr("Save as home: the present position")},
                             this, [this] { m_context.ask(intent::SaveAsHome{}); })) {
    look::name(this, u"detailsBox"_s, Common::tr("Details"));
    addBits(Byte::First, Common::tr("Status byte"), servo::kStatusBitNames, servoStatusMeaning, u"bit_"_s);
    const bool path = hasPathBuffer(context.state().info.identity);
    addBits(Byte::Second, tr("Auxiliary byte"), path ? servo::kCmcAuxBitNames : servo::kAuxBitNames,
            auxMeaning, u"bit_"_s);
    m_analog = addValue(tr("A/D (motor current)"), u"analogLabel"_s);
    m_velocity = addValue(tr("Velocity reported by the chip"), u"chipVelocityLabel"_s);
    if (path) {
        m_error = addValue(tr("Position error reported by the chip"), u"chipErrorLabel"_s);
        m_points = addValue(tr("Path points left"), u"pathPointsLabel"_s);
    }
    m_home = addValue(Common::tr("Home register"), u"homeLabel"_s);
    m_home->setToolTip(texts::homeRegisterMeaning());
    m_raw = addValue(Common::tr("Raw"), u"rawLabel"_s);
    addButtons({m_clear->button(), m_saveHome->button()});
    m_context.whenSeen(this, [this] { refresh(); });
}

void DetailsBox::refresh() {
    const QString dash = u"–"_s;
    const std::optional<StatusReport>& latest = m_context.state().latest;
    const StatusReport report = latest.value_or(StatusReport{});
    showBits(Byte::First, latest ? std::optional(report.status) : std::nullopt);
    showBits(Byte::Second, report.aux);
    look::setText(m_analog,
                  report.analog ? texts::analogReading(m_context.settings().analog, *report.analog) : dash);
    look::setText(m_velocity,
                  report.velocity ? texts::grouped(*report.velocity) + u' ' + texts::unitVelocity() : dash);
    look::setText(m_home, report.home ? texts::position(m_context.scale(), *report.home) : dash);
    if (m_error != nullptr) {
        look::setText(m_error, report.positionError
                                   ? texts::grouped(*report.positionError) + u' ' + texts::unitCounts()
                                   : dash);
        look::setText(m_points, report.pathPoints ? QString::number(*report.pathPoints) : dash);
    }
    QString raw = dash;
    if (latest) {
        raw = Common::tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        if (report.aux)
            raw += tr(", auxiliary %1").arg(*report.aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
    m_clear->setPossible(m_context.reasonNow(IntentKind::ClearStickyBits),
                         tr("Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing."));
    m_saveHome->setPossible(m_context.reasonNow(IntentKind::SaveAsHome),
                            Common::tr("Saves the present position as home. The motor does not move."));
}

}  // namespace nmc
