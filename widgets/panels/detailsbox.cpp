// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/detailsbox.h"

#include <QLabel>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
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
    : StatusTable(context, parent),
      m_clear(new Command({.name = u"clearStickyButton"_s,
                           .icon = u"eraser"_s,
                           .text = tr("Clear stic&ky bits"),
                           .accessible = tr("Clear sticky bits of the status")},
                          this, [this] { m_context.ask(intent::ClearStickyBits{}); })) {
    look::name(this, u"detailsBox"_s, Common::tr("Details"));
    addBits(Byte::First, Common::tr("Status byte"), servo::kStatusBitNames, servoStatusMeaning);
    const bool path = hasPathBuffer(context.state().info.identity);
    addBits(Byte::Second, tr("Auxiliary byte"), path ? servo::kCmcAuxBitNames : servo::kAuxBitNames,
            auxMeaning);
    addAnalog(tr("A/D (motor current)"));
    m_velocity = addValue(tr("Velocity reported by the chip"), u"chipVelocityLabel"_s);
    if (path) {
        m_error = addValue(tr("Position error reported by the chip"), u"chipErrorLabel"_s);
        m_points = addValue(tr("Path points left"), u"pathPointsLabel"_s);
    }
    addEnd(*m_clear);
    m_context.whenSeen(this, [this] { refresh(); });
}

void DetailsBox::refresh() {
    showStatus(tr(", auxiliary %1"));
    const QString dash = u"–"_s;
    const StatusReport report = m_context.state().latest.value_or(StatusReport{});
    look::setText(m_velocity,
                  report.velocity ? texts::grouped(*report.velocity) + u' ' + texts::unitVelocity() : dash);
    if (m_error != nullptr) {
        look::setText(m_error, report.positionError
                                   ? texts::grouped(*report.positionError) + u' ' + texts::unitCounts()
                                   : dash);
        look::setText(m_points, report.pathPoints ? QString::number(*report.pathPoints) : dash);
    }
    m_clear->setPossible(m_context.reasonNow(IntentKind::ClearStickyBits),
                         tr("Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing."));
}

}  // namespace nmc
