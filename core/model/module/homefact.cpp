// SPDX-License-Identifier: MIT
#include "model/module/homefact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bus/standstill.h"
#include "module/commandfacts.h"

namespace nmc {

namespace {

/// An older position does not show where the motor was when its counter was set to 0.
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
    if (!m_offered)
        return;
    loseOrigin();
    m_place = Place{*m_offered, time, Source::Remembered};
    m_offered.reset();
}

void HomeFact::restarted() {
    loseOrigin();
    HomeFact unknown;
    unknown.m_work = std::move(m_work);
    unknown.m_lost = m_lost;
    *this = std::move(unknown);
}

std::optional<WorkZero> HomeFact::workZero() const {
    if (!m_work)
        return std::nullopt;
    const double zero = counts().value_or(0) + static_cast<double>(m_work->offset.counts);
    return WorkZero{m_work->offset, m_work->known ? std::optional(zero) : std::nullopt};
}

std::optional<WorkOffset> HomeFact::workOffset(const std::string& name, std::int32_t position,
                                               double called) const {
    const double zero = std::round(position - static_cast<double>(counts().value_or(0)) - called);
    if (std::abs(zero) > std::numeric_limits<std::int32_t>::max())
        return std::nullopt;
    return WorkOffset{name, static_cast<std::int32_t>(zero)};
}

void HomeFact::useWork(const std::optional<WorkOffset>& offset, const std::optional<std::int32_t>& home) {
    if (!offset)
        m_work.reset();
    else if (home == counts())
        m_work = Work{*offset};
}

void HomeFact::keepWork(const std::vector<WorkOffset>& offsets) {
    if (m_place && m_work && std::ranges::find(offsets, m_work->offset) == offsets.end())
        m_work->known = false;
}

void HomeFact::forget() {
    loseOrigin();
    m_place.reset();
    m_offered.reset();
    m_saved.reset();
    m_reading.reset();
}

void HomeFact::apply(const bus::CommandExecuted& executed) {
    if (is<SaveAsHome>(executed.command)) {
        forget();
        m_saved = executed.time;
    } else if (setsCounter(executed.command)) {
        counterMoved(executed.time, shift(executed.command));
    }
}

std::optional<std::int32_t> HomeFact::shift(const ModuleCommand& command) const {
    if (!m_latest)
        return std::nullopt;
    if (is<servo::ResetRelativeToHome>(command))
        return m_register ? std::optional(countsBetween(*m_register, 0)) : std::nullopt;
    std::int32_t to = 0;
    if (const auto* set = getIf<servo::SetPosition>(command))
        to = set->position.value();
    return countsBetween(m_latest->position, to);
}

void HomeFact::counterMoved(TimePoint time, std::optional<std::int32_t> by) {
    if (!m_place)
        loseOrigin();
    const bool stood = m_latest && m_latest->still && m_latest->time < time && time - m_latest->time < kFresh;
    if (!stood || !by)
        forget();
    const auto move = [&](std::int32_t counts) { return countsBetween(countsBetween(*by, 0), counts); };
    if (m_place)
        m_place->counts = move(m_place->counts);
    if (m_offered)
        m_offered = move(*m_offered);
    m_saved.reset();
    m_latest.reset();
}

void HomeFact::apply(const bus::Sample& sample) {
    if (sample.jumped)
        forget();
    if (sample.report.position) {
        const std::int32_t position = *sample.report.position;
        m_latest = Reading{sample.time, position, m_latest && samePlace(m_latest->position, position)};
    }
    if (sample.report.home)
        m_register = sample.report.home;
    // The reply to the command itself may have been composed before the command took effect.
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
