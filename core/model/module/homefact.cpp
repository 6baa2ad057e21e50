// SPDX-License-Identifier: MIT
#include "model/module/homefact.h"

#include <utility>

#include "bus/standstill.h"

namespace nmc {

namespace {

/// An older position does not tell where the motor stood when its counter was set to 0.
constexpr Duration kFresh = std::chrono::seconds(2);

}  // namespace

void HomeFact::found(std::int32_t counts, TimePoint time) {
    forget();
    m_place = Place{counts, time, Source::Search};
}

void HomeFact::declare(TimePoint time) {
    forget();
    m_place = Place{0, time, Source::Declared};
}

void HomeFact::offer(std::int32_t counts) {
    if (!m_place && !m_saved)
        m_offered = counts;
}

void HomeFact::takeOffer(TimePoint time) {
    if (m_offered)
        m_place = Place{*m_offered, time, Source::Remembered};
    m_offered.reset();
}

void HomeFact::forget() {
    m_place.reset();
    m_offered.reset();
    m_saved.reset();
    m_reading.reset();
}

void HomeFact::apply(const bus::CommandExecuted& executed) {
    if (bus::is<SaveAsHome>(executed.command)) {
        forget();
        m_saved = executed.time;
    } else if (bus::is<ResetPosition>(executed.command)) {
        counterReset(executed.time);
    }
}

void HomeFact::counterReset(TimePoint time) {
    const bool stood = m_look && m_look->still && m_look->time < time && time - m_look->time < kFresh;
    if (!stood)
        forget();
    if (m_place)
        m_place->counts = countsBetween(m_look->position, m_place->counts);
    if (m_offered)
        m_offered = countsBetween(m_look->position, *m_offered);
    m_saved.reset();
    m_look.reset();
}

void HomeFact::apply(const bus::Sample& sample) {
    if (sample.jumped)
        forget();
    if (sample.report.position) {
        const std::int32_t position = *sample.report.position;
        m_look = Look{sample.time, position, m_look && samePlace(m_look->position, position)};
    }
    // The answer to the command itself may have been put together before it took effect.
    if (!m_saved || sample.time <= *m_saved || !sample.report.home)
        return;
    const auto before = std::exchange(m_reading, sample.report.home);
    if (before != m_reading)
        return;
    m_place = Place{*m_reading, *m_saved, Source::Saved};
    m_saved.reset();
    m_reading.reset();
}

}  // namespace nmc
