// SPDX-License-Identifier: GPL-3.0-or-later
// How much faster than real time a full chain runs; the goal is 100 for 32 moving servos on one core.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/chain.h"
#include "sim/chainspec.h"

namespace {

using nmc::TimePoint;
using nmc::sim::Chain;

class BenchHost {
public:
    explicit BenchHost(unsigned servos, const std::string& version = "", const std::string& others = "",
                       unsigned other = 0)
        : m_chain(chainOf(servos, version, others, other)) {
        m_now += std::chrono::milliseconds(20);
        for (unsigned i = 1; i <= servos + other; ++i)
            send({0, 0x21, byte(i), 0xFF});
        // Kp 200, Kd 2000, Ki 20, IL 200, OL 255, no current limit, EL 16383, SR 1, no deadband.
        send({0xFF, 0xE6, 200, 0, 0xD0, 0x07, 20, 0, 200, 0, 255, 0, 0xFF, 0x3F, 1, 0});
        send({0xFF, 0x17, 0x05});
    }

    void goTo115200() {
        send({0xFF, 0x1A, 10});
        m_chain.setHostBaud(115'200);
    }

    /// Adds the checksum and waits for the answer.
    void send(std::vector<std::uint8_t> body) {
        unsigned sum = 0;
        for (const std::uint8_t b : body)
            sum += b;
        body.push_back(byte(sum));
        body.insert(body.begin(), 0xAA);
        m_chain.hostSends(body, m_now);
        while (const auto next = m_chain.nextEvent()) {
            m_now = *next;
            m_chain.advanceTo(m_now);
        }
        static_cast<void>(m_chain.takeHostBytes());
    }
    void run(nmc::Duration time) {
        m_now += time;
        m_chain.advanceTo(m_now);
    }
    [[nodiscard]] TimePoint now() const { return m_now; }

private:
    static std::uint8_t byte(unsigned value) { return static_cast<std::uint8_t>(value & 0xFFU); }
    static Chain chainOf(unsigned servos, const std::string& version, const std::string& others,
                         unsigned other) {
        std::string spec = "servo" + version;
        for (unsigned i = 1; i < servos; ++i)
            spec += ",servo" + version;
        for (unsigned i = 0; i < other; ++i)
            spec += "," + others;
        return Chain(nmc::sim::parseChain(spec).value());
    }

    Chain m_chain;
    TimePoint m_now;
};

void report(benchmark::State& state, nmc::Duration simulated) {
    state.counters["sim_s_per_s"] =
        benchmark::Counter(nmc::toSeconds(simulated), benchmark::Counter::kIsRate);
}

/// Servos at 5 counts per tick, with nothing on the line.
void MovingServosInVelocityMode(benchmark::State& state) {
    BenchHost host(static_cast<unsigned>(state.range(0)));
    host.send({0xFF, 0x94, 0xB6, 0, 0, 5, 0, 0, 1, 0, 0});
    const TimePoint begin = host.now();
    for (auto _ : state)
        host.run(std::chrono::seconds(1));
    report(state, host.now() - begin);
}
BENCHMARK(MovingServosInVelocityMode)->Arg(1)->Arg(32)->Unit(benchmark::kMillisecond);

/// Trapezoidal moves to and fro, mostly accelerating and decelerating.
void MovingServosInTrapezoidalMode(benchmark::State& state) {
    BenchHost host(static_cast<unsigned>(state.range(0)));
    const TimePoint begin = host.now();
    std::uint8_t goal = 0;
    for (auto _ : state) {
        goal = goal == 0 ? 0x40 : 0;  // 16 384 counts
        host.send({0xFF, 0xD4, 0x97, 0, goal, 0, 0, 0, 0, 20, 0, 0x00, 0x06, 0, 0});
        host.run(std::chrono::seconds(1));
    }
    report(state, host.now() - begin);
}
BENCHMARK(MovingServosInTrapezoidalMode)->Arg(32)->Unit(benchmark::kMillisecond);

/// Moving servos, each of which is queried for everything in turn at 115 200 Bd without a pause.
void PolledMovingServos(benchmark::State& state) {
    const auto servos = static_cast<unsigned>(state.range(0));
    BenchHost host(servos);
    host.goTo115200();
    host.send({0xFF, 0x94, 0xB6, 0, 0, 5, 0, 0, 1, 0, 0});
    const TimePoint begin = host.now();
    for (auto _ : state)
        for (unsigned i = 1; i <= servos; ++i)
            host.send({static_cast<std::uint8_t>(i), 0x13, 0x1F});
    report(state, host.now() - begin);
}
BENCHMARK(PolledMovingServos)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

/// The aim is below 15 s: an hour of a bus with eight servos at 115 200 Bd, one exchange after the other, for
/// the position, velocity and auxiliary byte of each in turn, while all of them move.
void AnHourOfEightPolledServos(benchmark::State& state) {
    constexpr unsigned kServos = 8;
    for (auto _ : state) {
        BenchHost host(kServos);
        host.goTo115200();
        host.send({0xFF, 0x94, 0xB6, 0, 0, 5, 0, 0, 1, 0, 0});
        const TimePoint end = host.now() + std::chrono::hours(1);
        for (std::uint8_t i = 0; host.now() < end; i = static_cast<std::uint8_t>((i + 1) % kServos))
            host.send({static_cast<std::uint8_t>(i + 1), 0x13, 0x0D});
    }
}
BENCHMARK(AnHourOfEightPolledServos)->Iterations(1)->Unit(benchmark::kSecond);

/// The aim is 100: eight moving PIC-SERVO SC and eight PIC-I/O with their timers on, each of which is queried
/// for all eight items in turn at 115 200 Bd without a pause.
void PolledScAndIo(benchmark::State& state) {
    constexpr unsigned kOfEach = 8;
    BenchHost host(kOfEach, "@10", "io", kOfEach);
    host.goTo115200();
    for (unsigned i = 1; i <= kOfEach; ++i) {
        host.send({static_cast<std::uint8_t>(i), 0x94, 0xB6, 0, 0, 5, 0, 0, 1, 0, 0});
        host.send({static_cast<std::uint8_t>(i + kOfEach), 0x18, 0x01});
    }
    const TimePoint begin = host.now();
    for (auto _ : state)
        for (unsigned i = 1; i <= 2 * kOfEach; ++i)
            host.send({static_cast<std::uint8_t>(i), 0x13, 0xFF});
    report(state, host.now() - begin);
}
BENCHMARK(PolledScAndIo)->Unit(benchmark::kMillisecond);

}  // namespace
