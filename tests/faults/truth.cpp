// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bus/steps.h"

namespace nmc::test {

using namespace std::chrono_literals;

namespace {

/// Time for which moments are remembered: replies that are later than this are beyond any quarantine.
constexpr Duration kRemembered = 2s;
/// The time of a sample is known to within half a tick (types.h); the chip's counter is at most one tick old.
constexpr Duration kUncertain = 2 * kServoTick;
/// Minimum time between two moments: a tick is 512 us.
constexpr Duration kApart = 200us;
constexpr int kCount = 1;

}  // namespace

struct Truth::Around {
    std::int32_t least = INT32_MAX;
    std::int32_t most = INT32_MIN;
    double slowest = std::numeric_limits<double>::infinity();  ///< counts per tick
    bool limitAlwaysClosed = true;
    bool neverPower = true;

    void add(const Moment& m) {
        least = std::min(least, m.position);
        most = std::max(most, m.position);
        slowest = std::min(slowest, m.speed);
        limitAlwaysClosed = limitAlwaysClosed && m.limit1;
        neverPower = neverPower && !m.power;
    }
};

Truth::Truth(VirtualBus& bus) : m_bus(bus) {
    m_history.resize(bus.chain.moduleCount());
    m_seen = bus.events.size();
    bus.onTime = [this] { remember(); };
    remember();
}

Truth::~Truth() {
    m_bus.onTime = nullptr;
}

std::int32_t Truth::placeOf(std::uint8_t module) {
    const int apart = (module + 1) / 2 * 20'000;
    return module % 2 == 1 ? apart : -apart;
}

bool Truth::spreadOut(VirtualBus& bus) {
    const auto isThere = [&](std::uint8_t i) {
        return bus.chain.identity(ModuleIndex(i)).type != ModuleType::Servo ||
               (std::abs(bus.servo(i).position - placeOf(i)) <= 5 && bus.servo(i).commandVelocity == 0);
    };
    for (std::uint8_t i = 0; i < bus.chain.moduleCount(); ++i) {
        if (isThere(i))
            continue;
        servo::LoadTrajectory load;
        load.position = Counts(placeOf(i));
        load.velocity = CountsPerTick(40 * 65'536);
        load.acceleration = CountsPerTickSquared(65'536 / 8);
        if (bus.perform({toServo(i, load), start(i)}) != bus::Outcome::Done)
            return false;
    }
    const auto there = [&] {
        for (std::uint8_t i = 0; i < bus.chain.moduleCount(); ++i)
            if (!isThere(i))
                return false;
        return true;
    };
    return bus.runUntil(there, 20s);
}

void Truth::remember() {
    for (std::uint8_t i = 0; i < m_history.size(); ++i) {
        auto& history = m_history[i];
        if (!history.empty() && m_bus.now - history.back().time < kApart)
            continue;
        const sim::ModuleSnapshot module = m_bus.chain.snapshot(ModuleIndex(i), m_bus.now);
        const sim::ServoSnapshot& servo = module.servo;
        if (module.stepper) {
            history.push_back({m_bus.now, module.stepper->position, 0, false, true});
        } else {
            const double speed = std::min(std::abs(servo.commandVelocity), std::abs(servo.velocity));
            history.push_back({m_bus.now, servo.position, speed, servo.limit1, servo.power});
        }
        while (m_bus.now - history.front().time > kRemembered)
            history.pop_front();
    }
    look();
}

void Truth::look() {
    for (; m_seen < m_bus.events.size(); ++m_seen)
        if (const auto* sample = std::get_if<bus::Sample>(&m_bus.events[m_seen]))
            check(*sample);
}

void Truth::lookAndForget() {
    look();
    m_bus.events.clear();
    m_seen = 0;
}

Truth::Around Truth::around(std::uint8_t module, TimePoint time) const {
    const auto& history = m_history[module];
    const auto before = [](const Moment& m, TimePoint t) { return m.time < t; };
    auto it = std::lower_bound(history.begin(), history.end(), time - kUncertain, before);
    if (it != history.begin())
        --it;
    Around found;
    for (; it != history.end(); ++it) {
        found.add(*it);
        if (it->time > time + kUncertain)
            break;
    }
    return found;
}

void Truth::check(const bus::Sample& sample) {
    ++m_samples;
    const std::uint8_t module = sample.module.value();
    const Around truth = around(module, sample.time);
    const StatusReport& said = sample.report;
    if (said.position && (*said.position < truth.least - kCount || *said.position > truth.most + kCount))
        complain(m_wrong, sample,
                 "position " + std::to_string(*said.position) + ", was " + std::to_string(truth.least) +
                     " to " + std::to_string(truth.most));
    if (m_bus.chain.identity(sample.module).type != ModuleType::Servo)
        return;
    const servo::StatusByte status = said.servoStatus();
    const bool saysStill = status.moveDone() && said.velocity && *said.velocity == 0;
    if (saysStill && truth.slowest > 1.5)
        complain(m_wrongPermissions, sample, "stands still, at " + std::to_string(truth.slowest));
    if (!status.limit1() && truth.limitAlwaysClosed)
        complain(m_wrongPermissions, sample, "limit 1 released");
    if (status.powerOn() && truth.neverPower)
        complain(m_wrongPermissions, sample, "power is there");
}

void Truth::complain(std::uint64_t& counter, const bus::Sample& sample, const std::string& what) {
    ++counter;
    if (m_first.empty())
        m_first = "module " + std::to_string(int{sample.module.value()}) + " at " +
                  std::to_string(toSeconds(sample.time.time_since_epoch())) + " s, items " +
                  toHex(std::vector<std::uint8_t>{sample.report.items.mask()}) + ": " + what;
}

void Truth::expectAllTrue() {
    look();
    EXPECT_GT(m_samples, 0U);
    EXPECT_EQ(m_wrong, 0U) << "of " << m_samples << " samples; the first: " << m_first;
    EXPECT_EQ(m_wrongPermissions, 0U) << m_first;
}

}  // namespace nmc::test
