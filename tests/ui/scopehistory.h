// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scope/history.h"

namespace nmc {

/// Samples made by hand, at seconds since some zero, at which the first must be.
class HandMadeHistory {
public:
    static TimePoint at(double seconds) {
        return TimePoint(std::chrono::seconds(1000)) + fromSeconds(seconds);
    }

    explicit HandMadeHistory(std::size_t modules = 1) : m_history(modules) {}

    ScopeSample& add(double seconds, std::int32_t position) {
        flush();
        m_next = ScopeSample{};
        m_next.time = at(seconds);
        m_next.position = position;
        m_waiting = true;
        return m_next;
    }
    void addTo(int module, double seconds, std::int32_t position) {
        flush();
        ScopeSample sample;
        sample.time = at(seconds);
        sample.position = position;
        m_history.append(ModuleIndex(static_cast<std::uint8_t>(module)), sample);
    }
    void noteGains(double seconds, const servo::SetGain& gains) {
        m_history.noteGains({ModuleIndex(0), at(seconds), gains});
    }
    const History& history() {
        flush();
        return m_history;
    }

private:
    void flush() {
        if (m_waiting)
            m_history.append(ModuleIndex(0), m_next);
        m_waiting = false;
    }
    History m_history;
    ScopeSample m_next;
    bool m_waiting = false;
};

}  // namespace nmc
