// SPDX-License-Identifier: GPL-3.0-or-later
// The calculated command position in real time: the worker and QSerialPort on a pseudo-terminal at 115 200
// Bd, and the simulator in another thread of this process, which has the same clock. The requirement itself
// is tested in virtual time, in tests/model/commandtruth_test.cpp: on a busy machine the simulator accepts
// commands late, as no module does.
#include <QCoreApplication>
#include <QTest>
#include <cstdio>
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

/// A simulated servo on a terminal, with a log of its command position at each answer.
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

class Follower {
public:
    Follower() {
        m_worker.open([this] { return std::make_unique<SerialTransport>(m_servo.terminal()); },
                      bus::EngineConfig{115'200});
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
    /// Carries out the steps, and continues until this many more samples have been compared.
    [[nodiscard]] bool follow(std::vector<bus::Order> steps, std::size_t samples) {
        m_worker.ask(bus::Operation{bus::OperationId(++m_operations), std::move(steps)});
        if (!waitFor<bus::OperationFinished>())
            return false;
        const std::size_t enough = m_comparison.figures.samples() + samples;
        return QTest::qWaitFor(
            [&] {
                follow();
                return m_comparison.figures.samples() >= enough;
            },
            20'000);
    }
    [[nodiscard]] const Comparison& figures() const { return m_comparison.figures; }

private:
    void follow() {
        for (const WorkerEvent& event : m_worker.takeEvents()) {
            const auto* busEvent = std::get_if<bus::Event>(&event);
            if (busEvent == nullptr)
                continue;
            m_comparison.take(*busEvent);
            m_last.push_back(*busEvent);
        }
    }

    CommandComparison m_comparison;
    TrueServo m_servo{m_comparison.truth};
    BusWorker m_worker;
    std::vector<bus::Event> m_last;
    std::uint32_t m_operations = 0;
};

std::vector<bus::Order> runAt(std::uint32_t velocity, bool reverse) {
    servo::LoadTrajectory load;
    load.profile = servo::ProfileMode::Velocity;
    load.velocity = CountsPerTick(velocity);
    load.acceleration = CountsPerTickSquared(1'311);
    load.reverse = reverse;
    load.startNow = true;
    return {step(0, load)};
}

}  // namespace
}  // namespace nmc

int main(int argc, char** argv) {
    using namespace nmc;
    const QCoreApplication application(argc, argv);
    Follower follower;
    const bool whole =
        follower.waitFor<bus::ChainFound>() && follower.follow(gainsAndEnable(0), 1) &&
        follower.follow(move(0, 5'000), 400) && follower.follow(runAt(4 << 16, true), 200) &&
        follower.follow(runAt(3 << 16, false), 200) &&
        follower.follow({step(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})}, 100) &&
        follower.follow(move(0, 0), 300);
    if (!whole) {
        std::fputs("truth_bench: the servo did not answer\n", stderr);
        return 1;
    }
    follower.figures().print("truth: pseudo-terminal at 115 200 Bd");
    std::printf("truth: %zu samples without a command position, %zu without a truth\n",
                follower.figures().unknown(), follower.figures().unmatched());
}
