// SPDX-License-Identifier: MIT
#include "bus/ownmotion.h"

#include <cstdlib>

#include "module/commandfacts.h"

namespace nmc::bus {

void OwnMotion::onSent(const ModuleCommand& command) {
    if (isQuestion(command))
        return;
    m_commanded = true;
    m_still.reset();
}

bool OwnMotion::onReport(const StatusReport& report, TimePoint latched, bool mayMove) {
    if (!report.position)
        return false;
    if (m_still.look(latched, *report.position, mayMove || showsMotion(m_type, report))) {
        m_rested = true;
        m_commanded = false;
        m_place = *report.position;
    }
    const bool others = m_rested && !m_commanded && underPower(report);
    m_looks = others ? m_looks + 1 : 0;
    if (m_looks < kLooks)
        return false;
    m_rested = false;
    return true;
}

bool OwnMotion::underPower(const StatusReport& report) const {
    if (m_type == ModuleType::Stepper)
        return report.stepperStatus().moving();
    if (m_type != ModuleType::Servo || !report.aux || !servo::AuxByte{*report.aux}.servoOn())
        return false;
    const std::int64_t gone = countsBetween(m_place, *report.position);
    return !report.servoStatus().moveDone() ||
           (report.velocity.value_or(0) != 0 && std::abs(gone) > kGivesWay);
}

}  // namespace nmc::bus
