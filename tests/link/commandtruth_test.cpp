// SPDX-License-Identifier: GPL-3.0-or-later
// The calculated command position in real time: the worker and QSerialPort on a pseudo-terminal at 115 200
// Bd, the simulator in another thread of this process, which has the same clock. The machine may be as late
// as it likes: a sample that is late says so, and its band is wider.
#include <gtest/gtest.h>

#include <QTest>
#include <thread>

#include "link/clock.h"
#include "link/connection/busworker.h"
#include "link/connection/serialtransport.h"
#include "link/connection/wakeup.h"
#include "link/terminal/ptyserver.h"
#include "link/terminal/simserver.h"
#include "tests/link/connection.h"
#include "tests/support/commandtruth.h"

namespace nmc {
namespace {

using namespace testing_support;

/// A simulated servo on a terminal, and what its command position was each time it answered.
class TrueServo {
public:
    explicit TrueServo(LatchLog& truth) {
        auto terminal = PtyServer::create({});
        if (!terminal)
            throw std::runtime_error(terminal.error());
        m_path = QString::fromStdString(terminal->path());
        sim::ChainOptions options;
        options.onExecuted = [this, &truth](ModuleIndex, const sim::ModuleSnapshot& module) {
            truth.add(module, m_began);
        };
        sim::Chain chain({{ModuleType::Servo, 4}}, options);
        m_began = monotonicNow();
        m_server.emplace(std::move(chain), std::move(*terminal), Pacing{}, -1, -1);
        m_thread = std::thread([this] { m_server->run(m_stop.fd()); });
    }
    ~TrueServo() {
        m_stop.wake();
        m_thread.join();
    }
    TrueServo(const TrueServo&) = delete;
    TrueServo& operator=(const TrueServo&) = delete;

    [[nodiscard]] const QString& terminal() const { return m_path; }

private:
    QString m_path;
    Wakeup m_stop;
    TimePoint m_began;
    std::optional<SimServer> m_server;
    std::thread m_thread;
};

class CommandTruthInRealTime : public testing::Test {
protected:
    void SetUp() override {
        const bus::EngineConfig config{115'200};
        m_worker.open([this] { return std::make_unique<SerialTransport>(m_servo.terminal()); }, config);
        ASSERT_TRUE(waitFor<bus::ChainFound>());
        ASSERT_TRUE(perform(gainsAndEnable(0)));
    }

    void follow() {
        for (const WorkerEvent& event : m_worker.takeEvents()) {
            const auto* busEvent = std::get_if<bus::Event>(&event);
            if (busEvent == nullptr)
                continue;
            m_comparison.take(*busEvent);
            m_last.push_back(*busEvent);
        }
    }
    template <typename Event>
    [[nodiscard]] bool waitFor() {
        m_last.clear();
        return QTest::qWaitFor(
            [this] {
                follow();
                return std::any_of(m_last.begin(), m_last.end(), [](const bus::Event& event) {
                    return std::holds_alternative<Event>(event);
                });
            },
            20'000);
    }
    [[nodiscard]] bool perform(std::vector<bus::Order> steps) {
        m_worker.submit({bus::OperationId(++m_operations), std::move(steps)});
        if (!waitFor<bus::OperationFinished>())
            return false;
        for (const bus::Event& event : m_last)
            if (const auto* finished = std::get_if<bus::OperationFinished>(&event))
                return finished->outcome == bus::Outcome::Done;
        return false;
    }
    /// Until so many more samples have been compared.
    [[nodiscard]] bool watch(std::size_t samples) {
        const std::size_t enough = m_comparison.figures.samples() + samples;
        return QTest::qWaitFor(
            [&] {
                follow();
                return m_comparison.figures.samples() >= enough;
            },
            20'000);
    }

    CommandComparison m_comparison;
    TrueServo m_servo{m_comparison.truth};
    BusWorker m_worker;
    std::vector<bus::Event> m_last;
    std::uint32_t m_operations = 0;
};

TEST_F(CommandTruthInRealTime, LiesWithinTheBand) {
    const auto velocity = [](std::uint32_t raw, bool reverse) {
        servo::LoadTrajectory load;
        load.profile = servo::ProfileMode::Velocity;
        load.velocity = CountsPerTick(raw);
        load.acceleration = CountsPerTickSquared(1'311);
        load.reverse = reverse;
        load.startNow = true;
        return load;
    };
    ASSERT_TRUE(perform(move(0, 5'000)));
    ASSERT_TRUE(watch(400));
    ASSERT_TRUE(perform({testing_support::step(0, velocity(4 << 16, true))}));
    ASSERT_TRUE(watch(200));
    ASSERT_TRUE(perform({testing_support::step(0, velocity(3 << 16, false))}));
    ASSERT_TRUE(watch(200));
    ASSERT_TRUE(perform({testing_support::step(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})}));
    ASSERT_TRUE(watch(100));
    ASSERT_TRUE(perform(move(0, 0)));
    ASSERT_TRUE(watch(300));

    m_comparison.figures.print("pseudo-terminal at 115 200 Bd");
    EXPECT_GE(m_comparison.figures.inside(), 0.99);
    EXPECT_EQ(m_comparison.figures.unknown(), 0U);
    EXPECT_LE(m_comparison.figures.unmatched(), m_comparison.figures.samples() / 100);
}

}  // namespace
}  // namespace nmc
