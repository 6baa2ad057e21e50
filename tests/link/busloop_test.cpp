// SPDX-License-Identifier: GPL-3.0-or-later
// The bus loop in real threads, without Qt, so that the thread sanitizer can watch it. Only the clock is
// replaced.
#include "link/connection/busloop.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <atomic>
#include <map>
#include <thread>

#include "tests/link/hurriedclock.h"
#include "tests/link/looprig.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;

/// Time hurries only so far that the beats of this thread still arrive in time; while this thread waits for
/// that of the loop, as far as it likes.
class HurriedRig : public LoopRig {
public:
    explicit HurriedRig(std::size_t samples = BusChannel::kSamples) : LoopRig(samples) {
        hurriedclock::allow(0ms);
    }
    ~HurriedRig() override { hurriedclock::allow(1h); }
    HurriedRig(const HurriedRig&) = delete;
    HurriedRig& operator=(const HurriedRig&) = delete;
    void onTurn() override { hurriedclock::allow(200ms); }
    void onWaiting(bool waits) override { hurriedclock::allow(waits ? Duration(1h) : Duration::zero()); }
};

TEST(BusLoop, RunsAChainAndStopsItsMotorsBeforeItCloses) {
    HurriedRig rig;
    rig.openSimulator(simulatorConfig(115'200), servoChain(2));
    ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
    EXPECT_EQ(rig.last<bus::ChainFound>()->modules.size(), 2U);
    EXPECT_EQ(rig.last<bus::ChainFound>()->baud, 115'200U);
    rig.loop.ask(runOn(1));
    ASSERT_TRUE(rig.waitFor<bus::OperationFinished>());
    EXPECT_EQ(rig.last<bus::OperationFinished>()->outcome, bus::Outcome::Done);
    rig.loop.close();
    ASSERT_TRUE(rig.waitFor<PortClosed>());
    EXPECT_FALSE(rig.last<PortClosed>()->error.has_value());
    ASSERT_NE(rig.last<bus::StopFinished>(), nullptr);
    EXPECT_EQ(rig.last<bus::StopFinished>()->stopped.size(), 2U);
    EXPECT_FALSE(rig.loop.isOpen());
    EXPECT_TRUE(std::holds_alternative<PortClosed>(rig.events().back())) << "it is the last event";
}

TEST(BusLoop, CanBeOpenedAgainAndDestroyedWhileOpen) {
    HurriedRig rig;
    for (std::size_t modules = 1; modules <= 3; ++modules) {
        rig.openSimulator(simulatorConfig(), servoChain(modules));
        ASSERT_TRUE(rig.waitUntil([&] {
            const auto* found = rig.last<bus::ChainFound>();
            return found != nullptr && found->modules.size() == modules;
        }));
    }
    EXPECT_EQ(rig.count<PortClosed>(), 0U)
        << "each connection replaced the one before, whose end is not reported";
}

/// The stops are owed to the modules until a connection has confirmed them.
TEST(BusLoop, PassesTheStopsOnThatItCouldNotSendWithoutADescriptor) {
    HurriedRig rig;
    bus::EngineConfig config = simulatorConfig();
    config.unconfirmed.push_back({{ModuleIndex(0), BusAddress(1), servoChain(1).front()}, StopManner::Off});
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none{0, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    rig.openSimulator(config, servoChain(1));
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    ASSERT_TRUE(rig.waitFor<PortClosed>());
    const PortClosed& closed = *rig.last<PortClosed>();
    EXPECT_EQ(closed.error->problem, PortProblem::TooManyFiles);
    ASSERT_EQ(closed.unconfirmed.size(), 1U);
    EXPECT_EQ(closed.unconfirmed[0].module.address, BusAddress(1));
    EXPECT_EQ(closed.unconfirmed[0].manner, StopManner::Off);
}

/// Closes the loop when it is destroyed, while the loop waits for its thread in order to open the next
/// connection.
class LastWord : public SimulatorTransport {
public:
    template <typename... Arguments>
    explicit LastWord(BusLoop* loop, Arguments... arguments)
        : SimulatorTransport(std::move(arguments)...), m_loop(*loop) {}
    ~LastWord() override { m_loop.close(); }

private:
    BusLoop& m_loop;
};

/// A signal may arrive at any moment, and its stop concerns whatever is connected then.
TEST(BusLoop, ACloseThatComesWhileItOpensIsNotForgotten) {
    HurriedRig rig;
    rig.openTransport<LastWord>(simulatorConfig(), &rig.loop, servoChain(1));
    ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
    rig.openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_TRUE(rig.waitFor<PortClosed>());
    rig.openSimulator(simulatorConfig(), servoChain(2));
    EXPECT_TRUE(rig.waitUntil([&] {
        const auto* found = rig.last<bus::ChainFound>();
        return found != nullptr && found->modules.size() == 2;
    })) << "the close applies only once";
}

TEST(BusLoop, EveryRequestOfEveryThreadEndsOnce) {
    constexpr std::uint32_t kEach = 400;
    constexpr std::uint32_t kThreads = 4;
    HurriedRig rig;
    rig.openSimulator(simulatorConfig(115'200), servoChain(1));
    ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
    std::array<std::thread, kThreads> threads;
    for (std::uint32_t t = 0; t < kThreads; ++t)
        threads[t] = std::thread([&rig, t] {
            for (std::uint32_t i = 0; i < kEach; ++i) {
                rig.loop.ask(servoOperation(t * kEach + i, {Nop{}}));
                if (i % 100 == 0)
                    rig.loop.stopAll();
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count<bus::OperationFinished>() == kEach * kThreads; }));
    rig.loop.close();
    ASSERT_TRUE(rig.waitFor<PortClosed>());
    std::map<std::uint32_t, int> ends;
    for (const WorkerEvent& event : rig.events())
        if (const auto* finished = LoopRig::as<bus::OperationFinished>(event))
            ++ends[finished->id.value()];
    EXPECT_EQ(ends.size(), kEach * kThreads);
    for (const auto& [id, times] : ends)
        EXPECT_EQ(times, 1) << "operation " << id;
}

/// A listener that falls behind misses samples, and nothing else.
TEST(BusLoop, KeepsNewsForAListenerWhoFallsBehind) {
    constexpr std::size_t kSamples = 8;
    HurriedRig rig(kSamples);
    rig.openSimulator(simulatorConfig(115'200), servoChain(1));
    const auto drops = [&rig](std::size_t samples) {
        while (rig.loop.droppedSamples() < samples)
            rig.onTurn();
    };
    drops(100);
    rig.loop.ask(servoOperation(7, {Nop{}}));
    drops(rig.loop.droppedSamples() + 100);
    const auto& events = rig.events();
    EXPECT_TRUE(std::holds_alternative<PortOpened>(events.front()));
    EXPECT_EQ(rig.count<bus::ChainFound>(), 1U);
    EXPECT_EQ(rig.count<bus::OperationFinished>(), 1U);
    EXPECT_LE(rig.count<bus::Sample>(), kSamples);
    EXPECT_TRUE(LoopRig::as<bus::Sample>(events.back())) << "the newest sample comes last";
}

TEST(BusLoop, TellsOnceThatTheMachineSleptAndStopsTheMotors) {
    std::atomic<Duration::rep> asleep{0};
    HurriedRig rig;
    rig.loop.setSleepClock([&asleep] { return Duration(asleep.load()); });
    rig.openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
    rig.loop.ask(runOn(1));
    ASSERT_TRUE(rig.waitFor<bus::OperationFinished>());
    asleep = Duration(2h).count();
    ASSERT_TRUE(rig.waitFor<ComputerSlept>());
    EXPECT_EQ(rig.last<ComputerSlept>()->length, 2h);
    ASSERT_TRUE(rig.waitFor<bus::StopFinished>());
    EXPECT_EQ(rig.last<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_EQ(rig.count<ComputerSlept>(), 1U);
}

/// Presses STOP at the moment when the last byte of an answer arrives, and keeps the commands that are sent
/// from then on. The length of an answer is known from the previous answer to the same packet.
class StopWithAnAnswer : public SimulatorTransport {
public:
    StopWithAnAnswer(LoopRig& rig, std::atomic<bool>& armed, std::vector<std::uint8_t>& commands)
        : SimulatorTransport(servoChain(2)), m_rig(rig), m_armed(armed), m_commands(commands) {}

    tl::expected<void, PortError> send(ByteSpan bytes) override {
        if (m_pressed && bytes.size() > 2 && bytes[0] == 0xAA)  // and not the nulls ahead of it
            m_commands.push_back(bytes[2]);
        m_answers[m_sent] = m_heard;
        m_sent.assign(bytes.begin(), bytes.end());
        m_heard = 0;
        return SimulatorTransport::send(bytes);
    }
    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override {
        auto bytes = SimulatorTransport::receive(until, wakeFd);
        m_heard += bytes ? bytes->size() : 0;
        const auto known = m_answers.find(m_sent);
        if (m_armed && !m_pressed && known != m_answers.end() && known->second == m_heard && m_heard > 0) {
            m_pressed = true;
            m_rig.loop.stopAll();
        }
        return bytes;
    }

private:
    LoopRig& m_rig;
    std::atomic<bool>& m_armed;
    std::vector<std::uint8_t>& m_commands;
    std::map<std::vector<std::uint8_t>, std::size_t> m_answers;
    std::vector<std::uint8_t> m_sent;
    std::size_t m_heard = 0;
    bool m_pressed = false;
};

TEST(BusLoop, SendsNothingBeforeAStopThatCameWithAnAnswer) {
    std::atomic<bool> armed{false};
    std::vector<std::uint8_t> commands;
    HurriedRig rig;
    rig.loop.open([&] { return std::make_unique<StopWithAnAnswer>(rig, armed, commands); },
                  simulatorConfig());
    ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
    rig.loop.ask(runOn(1));
    ASSERT_TRUE(rig.waitFor<bus::OperationFinished>());
    armed = true;
    ASSERT_TRUE(rig.waitFor<bus::StopFinished>());
    rig.loop.close();
    ASSERT_TRUE(rig.waitFor<PortClosed>());
    ASSERT_FALSE(commands.empty());
    EXPECT_EQ(commands.front(), 0x17) << "Stop Motor (DS-V 5.2)";
}

// ---- guards ----

/// What is reported to a guard and what is sent to the port, in one sequence.
struct Told {
    enum class What { Begin, Arm, Send, End } what;
    std::vector<std::uint8_t> bytes{};
    std::uint32_t baud = 0;
    bool moving = false;
};

class Diary : public LoopGuard {
public:
    void begin(int) override { note({Told::What::Begin}); }
    void arm(ByteSpan burst, std::uint32_t baud, bool moving) override {
        m_moving = moving;
        note({Told::What::Arm, {burst.begin(), burst.end()}, baud, moving});
    }
    News beat(TimePoint now) override {
        m_beat = now;
        return {};
    }
    void end() override { note({Told::What::End}); }

    void note(Told told) {
        const std::scoped_lock lock(m_mutex);
        m_all.push_back(std::move(told));
    }
    std::vector<Told> all() const {
        const std::scoped_lock lock(m_mutex);
        return m_all;
    }
    // Called in the bus thread.
    [[nodiscard]] bool moving() const { return m_moving; }
    [[nodiscard]] TimePoint lastBeat() const { return m_beat; }

private:
    mutable std::mutex m_mutex;
    std::vector<Told> m_all;
    bool m_moving = false;
    TimePoint m_beat;
};

/// The simulator, which also writes to the diary, and counts the waits that are too long for a guard.
class WatchedTransport : public SimulatorTransport {
public:
    WatchedTransport(Diary& diary, std::atomic<int>& longWaits, std::atomic<int>& waits)
        : SimulatorTransport(servoChain(1)), m_diary(diary), m_longWaits(longWaits), m_waits(waits) {}

    tl::expected<void, PortError> send(ByteSpan bytes) override {
        m_diary.note({Told::What::Send, {bytes.begin(), bytes.end()}});
        return SimulatorTransport::send(bytes);
    }
    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override {
        if (m_diary.moving()) {
            ++m_waits;
            if (!until || *until > m_diary.lastBeat() + LoopGuard::kBeatEvery)
                ++m_longWaits;
        }
        return SimulatorTransport::receive(until, wakeFd);
    }

private:
    Diary& m_diary;
    std::atomic<int>& m_longWaits;
    std::atomic<int>& m_waits;
};

class GuardedLoop : public testing::Test {
protected:
    /// Runs a motor for a while, stops it and closes.
    void live() {
        rig.loop.addGuard(diary);
        rig.loop.open([this] { return std::make_unique<WatchedTransport>(diary, longWaits, waits); },
                      simulatorConfig(115'200));
        ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
        rig.loop.ask(runOn(1));
        ASSERT_TRUE(rig.waitUntil([this] { return waits > 30; }));
        rig.loop.close();
        ASSERT_TRUE(rig.waitFor<PortClosed>());
    }

    Diary diary;
    std::atomic<int> longWaits{0};
    std::atomic<int> waits{0};
    HurriedRig rig;
};

TEST_F(GuardedLoop, IsArmedAtTheRateOfTheChainBeforeTheMotorIsOn) {
    ASSERT_NO_FATAL_FAILURE(live());
    bool armed = false;
    for (const Told& told : diary.all()) {
        if (told.what == Told::What::Arm && !told.bytes.empty()) {
            armed = true;
            EXPECT_EQ(told.baud, 115'200U);
        }
        // Stop Motor with AMP_EN, which enables the motor (DS-V 5.2).
        const bool enables = told.what == Told::What::Send && told.bytes.size() > 3 &&
                             told.bytes[2] == 0x17 && (told.bytes[3] & 0x01U) != 0;
        EXPECT_FALSE(enables && !armed) << "in between, nothing could stop the motor";
    }
    EXPECT_TRUE(armed);
}

/// A guard that reports once that it used the line while motors moved, as a guardian does when the loop
/// stands still.
class Stepped : public LoopGuard {
public:
    void begin(int) override {}
    void arm(ByteSpan, std::uint32_t, bool) override {}
    News beat(TimePoint) override { return {m_spoke.exchange(false)}; }
    void end() override {}
    void speak() { m_spoke = true; }

private:
    std::atomic<bool> m_spoke{false};
};

TEST(SteppedIn, GuardHasTheLoopStopTheMotorsItselfAndIsTold) {
    Stepped guard;
    HurriedRig rig;
    rig.loop.addGuard(guard);
    rig.openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_TRUE(rig.waitFor<bus::ChainFound>());
    rig.loop.ask(runOn(1));
    ASSERT_TRUE(rig.waitFor<bus::OperationFinished>());
    guard.speak();
    ASSERT_TRUE(rig.waitFor<bus::StopFinished>());
    EXPECT_EQ(rig.last<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_EQ(rig.count<GuardianStopped>(), 1U);
}

TEST_F(GuardedLoop, IsToldWhenAMotorMovesAndWhenItStands) {
    ASSERT_NO_FATAL_FAILURE(live());
    const std::vector<Told> all = diary.all();
    EXPECT_EQ(all.front().what, Told::What::Begin);
    EXPECT_EQ(all.back().what, Told::What::End);
    std::vector<bool> moving;
    for (const Told& told : all)
        if (told.what == Told::What::Arm && (moving.empty() || moving.back() != told.moving))
            moving.push_back(told.moving);
    ASSERT_GE(moving.size(), 2U);
    EXPECT_FALSE(moving.back()) << "the stop was confirmed before the port was closed";
}

TEST_F(GuardedLoop, IsBeatenEveryFiftyMillisecondsWhileAnythingMoves) {
    ASSERT_NO_FATAL_FAILURE(live());
    EXPECT_GT(waits, 30);
    EXPECT_EQ(longWaits, 0);
}

}  // namespace
}  // namespace nmc
