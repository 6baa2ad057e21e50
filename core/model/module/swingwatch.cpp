// SPDX-License-Identifier: MIT
#include "model/module/swingwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace nmc {

namespace {

constexpr Duration kWindow = std::chrono::milliseconds(1'000);
constexpr Duration kMinSpan = std::chrono::milliseconds(800);
constexpr Duration kBetween = std::chrono::milliseconds(200);
/// At slow polling, readings reach back beyond the window to keep this many.
constexpr std::ptrdiff_t kFewestReadings = 12;
constexpr std::size_t kFewestForRate = 16;
/// Counts to either side: friction and Ki make even a well-tuned servo creep by a few.
constexpr double kMinAmplitude = 8.0;
/// A swing below this fraction of that in the previous half second is dying down by itself.
constexpr double kStays = 0.7;
/// Hunting: each turn must exceed the jitter of an encoder between two counts, and two full cycles must be
/// seen.
constexpr std::int64_t kTurnedBy = 3;
constexpr std::size_t kTurnsKept = 4;
constexpr double kShortestHalf = 0.1, kLongestHalf = 10.0;  // s
/// Without a turn for this many half periods, the motor has come to rest.
constexpr double kOverdue = 2.5;
/// The share of the variance that a single sine must explain.
constexpr double kOneRate = 0.5;

/// Half the distance from the lowest to the highest position.
template <typename Readings>
double reach(const Readings& begin, const Readings& end) {
    const auto [low, high] =
        std::minmax_element(begin, end, [](const auto& a, const auto& b) { return a.position < b.position; });
    return (static_cast<double>(high->position) - static_cast<double>(low->position)) / 2.0;
}

/// Counts the changes from one side to the other, by at least `gate` to either.
int turns(const std::vector<double>& off, double gate) {
    int count = 0, side = 0;
    for (const double one : off) {
        const int here = one > gate ? 1 : one < -gate ? -1 : side;
        count += here != side && side != 0 ? 1 : 0;
        side = here;
    }
    return count;
}

struct Sine {
    double hertz = 0.0;
    double amplitude = 0.0;
    double share = 0.0;  ///< of the variance
};

/// Finds the best-fitting sine about the mean among frequencies from `from` in steps of `step` (least
/// squares; the times are uneven). From one frequency to the next, each reading's phasor is rotated by
/// multiplication: computing sines and cosines anew would block the window.
Sine bestSine(const std::vector<double>& seconds, const std::vector<double>& off, double from, double to,
              double step) {
    struct Turning {
        double c, s, byC, byS;
    };
    std::vector<Turning> readings;
    double yy = 0;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        const double first = 2.0 * std::numbers::pi * from * seconds[i];
        const double by = 2.0 * std::numbers::pi * step * seconds[i];
        readings.push_back({std::cos(first), std::sin(first), std::cos(by), std::sin(by)});
        yy += off[i] * off[i];
    }
    Sine best;
    for (double hertz = from; hertz < to && yy > 0; hertz += step) {
        double cc = 0, cs = 0, ss = 0, cy = 0, sy = 0;
        for (std::size_t i = 0; i < readings.size(); ++i) {
            auto& [c, s, byC, byS] = readings[i];
            cc += c * c;
            cs += c * s;
            ss += s * s;
            cy += c * off[i];
            sy += s * off[i];
            const double on = c * byC - s * byS;
            s = s * byC + c * byS;
            c = on;
        }
        const double det = cc * ss - cs * cs;
        if (det <= 1e-9 * cc * ss)
            continue;
        const double a = (cy * ss - sy * cs) / det;
        const double b = (sy * cc - cy * cs) / det;
        if (const double share = (a * cy + b * sy) / yy; share > best.share)
            best = {hertz, std::hypot(a, b), share};
    }
    return best;
}

}  // namespace

void SwingWatch::forget() {
    m_turns.clear();
    m_farthest.reset();
    m_readings.clear();
    m_swing.reset();
    m_lookedInto = {};
}

void SwingWatch::look(TimePoint time, std::int32_t position) {
    if (!m_readings.empty() && time <= m_readings.back().time)
        return;
    m_readings.push_back({time, position});
    watchTurns(m_readings.back());
    auto kept = m_readings.begin();
    while (time - kept->time > kWindow && m_readings.end() - kept > kFewestReadings)
        ++kept;
    m_readings.erase(m_readings.begin(), kept);
    if (time - m_lookedInto < kBetween || time - m_readings.front().time < kMinSpan)
        return;
    m_lookedInto = time;
    m_swing = lookInto();
    if (!m_swing)
        m_swing = hunting(time);
}

void SwingWatch::watchTurns(const Reading& reading) {
    if (!m_farthest) {
        m_farthest = reading;
        return;
    }
    const std::int64_t on = std::int64_t{reading.position} - m_farthest->position;
    if (m_forward ? on >= 0 : on <= 0) {
        if (on != 0)
            m_farthest = reading;
        return;
    }
    if (std::abs(on) < kTurnedBy)
        return;
    m_turns.push_back(*m_farthest);
    if (m_turns.size() > kTurnsKept)
        m_turns.erase(m_turns.begin());
    m_farthest = reading;
    m_forward = !m_forward;
}

std::optional<SwingWatch::Swing> SwingWatch::hunting(TimePoint now) const {
    if (m_turns.size() < kTurnsKept)
        return std::nullopt;
    const double halves = static_cast<double>(m_turns.size() - 1);
    const double half = toSeconds(m_turns.back().time - m_turns.front().time) / halves;
    double gone = 0;
    for (std::size_t i = 1; i < m_turns.size(); ++i)
        gone += std::abs(static_cast<double>(m_turns[i].position) - m_turns[i - 1].position);
    const double amplitude = gone / halves / 2;
    const bool goesOn = toSeconds(now - m_turns.back().time) < kOverdue * half;
    if (!goesOn || half < kShortestHalf || half > kLongestHalf)
        return std::nullopt;
    return Swing{amplitude, 0.5 / half, true};
}

std::optional<SwingWatch::Swing> SwingWatch::lookInto() const {
    if (std::ssize(m_readings) < kFewestReadings)
        return std::nullopt;
    const auto middle = m_readings.begin() + static_cast<std::ptrdiff_t>(m_readings.size() / 2);
    const double now = reach(middle, m_readings.end());
    const double before = reach(m_readings.begin(), middle);
    if (now < kMinAmplitude || before < kMinAmplitude || now < kStays * before)
        return std::nullopt;
    double mean = 0;
    for (const Reading& one : m_readings)
        mean += one.position;
    mean /= static_cast<double>(m_readings.size());
    // A creep to one side is not a swing: the position must cross from side to side repeatedly.
    std::vector<double> seconds, off;
    for (const Reading& one : m_readings) {
        off.push_back(one.position - mean);
        seconds.push_back(toSeconds(one.time - m_readings.front().time));
    }
    if (turns(off, now / 3) < 3)
        return std::nullopt;
    if (m_readings.size() < kFewestForRate)
        return Swing{now, std::nullopt};
    const double span = seconds.back();
    const double between = span / static_cast<double>(seconds.size() - 1);
    // Coarse search first, then to a quarter of the window's frequency resolution.
    const double fine = 0.25 / span;
    const double lowest = 1.5 / span;
    const double highest = 0.45 / between;
    const Sine near = bestSine(seconds, off, lowest, highest, 2 * fine);
    const Sine best = bestSine(seconds, off, std::max(lowest, near.hertz - fine),
                               std::min(highest, near.hertz + 1.5 * fine), fine);
    if (best.share < kOneRate)
        return Swing{now, std::nullopt};
    return Swing{best.amplitude, best.hertz};
}

}  // namespace nmc
