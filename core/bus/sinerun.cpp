// SPDX-License-Identifier: MIT
#include "bus/sinerun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nmc::bus {

SineRun::SineRun(const Sine& sine, const ModuleCommand& centre)
    : m_sine(sine),
      m_command(std::get<servo::StopMotor>(std::get<ServoCommand>(centre))),
      m_centre(m_command.here.value()) {}

ModuleCommand SineRun::commandAt(TimePoint now) {
    m_began = m_began.value_or(now);
    const double turns = m_sine.frequency * toSeconds(now - *m_began);
    const double off = m_sine.amplitude * std::sin(2 * std::numbers::pi * turns);
    m_command.here = Counts(m_centre + static_cast<std::int32_t>(std::lround(off)));
    return ServoCommand(m_command);
}

void SineRun::note(const ReplyEnd& end) {
    m_record.commands.push_back({end.latched, m_command.here.value()});
    if (end.report.position)
        m_record.answers.push_back({end.latched, *end.report.position});
    // By the golden ratio: evenly spread, and never the same again.
    double whole = 0.0;
    const double part = std::modf(static_cast<double>(m_record.commands.size()) * std::numbers::phi, &whole);
    const Duration spacing = kShortest + fromSeconds(toSeconds(kSpread) * part);
    m_due = std::max(end.sent + spacing, end.arrived + (end.arrived - end.sent));
}

}  // namespace nmc::bus
