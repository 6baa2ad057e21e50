// SPDX-License-Identifier: MIT
#include "bus/sinerun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nmc::bus {

namespace {

/// The middle of the time in which the module may have latched it: a reply that began early narrows it. All
/// queries of a sine follow a reply at once, and so fall on the same part of a tick.
[[nodiscard]] TimePoint latched(const ReplyEnd& end) {
    return end.latched + std::min(end.late, Duration{}) / 2;
}

}  // namespace

SineRun::SineRun(const Sine& sine, const ModuleCommand& centre)
    : m_sine(sine),
      m_command(std::get<servo::StopMotor>(std::get<ServoCommand>(centre))),
      m_centre(m_command.here.value()) {}

ModuleCommand SineRun::commandAt(TimePoint now) {
    m_began = m_began.value_or(now);
    // However late the last command is, it goes no farther than planned.
    const double seconds = toSeconds(std::min(now - *m_began, m_sine.lasts));
    const double off = m_sine.velocity * seconds +
                       m_sine.amplitude * std::sin(2 * std::numbers::pi * m_sine.frequency * seconds);
    m_command.here = Counts(m_centre + static_cast<std::int32_t>(std::lround(off)));
    return ServoCommand(m_command);
}

void SineRun::notePoll(const ReplyEnd& end) {
    look(end.report);
    if (end.report.position)
        m_record.polls.push_back({latched(end), *end.report.position});
}

/// As everywhere, a single report is enough to stop (link.md 2.4). The reply to the first command may have
/// been composed before the command took effect.
void SineRun::look(const StatusReport& report) {
    const servo::StatusByte status = report.servoStatus();
    if (!m_first) {
        m_first = status;
        return;
    }
    const bool off = report.aux && !servo::AuxByte{*report.aux}.servoOn();
    const bool tripped = status.positionError() && !m_first->positionError();
    const bool stopped = !status.homeInProgress() && m_first->homeInProgress();
    m_endedByChip = m_endedByChip || off || !status.powerOn() || tripped || stopped;
}

void SineRun::note(const ReplyEnd& end) {
    look(end.report);
    m_record.commands.push_back({latched(end), m_command.here.value()});
    if (end.report.position)
        m_record.answers.push_back({latched(end), *end.report.position});
    // Spaced by the golden ratio: evenly spread, and never repeating.
    double whole = 0.0;
    const double part = std::modf(static_cast<double>(m_record.commands.size()) * std::numbers::phi, &whole);
    const Duration spacing = kShortest + fromSeconds(toSeconds(kSpread) * part);
    m_due = std::max(end.sent + spacing, end.arrived + (end.arrived - end.sent));
}

}  // namespace nmc::bus
