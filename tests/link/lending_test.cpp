// SPDX-License-Identifier: GPL-3.0-or-later
// A program at the terminal at which the line is lent: a real terminal, in real threads.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <numeric>
#include <random>

#include "link/connection/lentterminal.h"
#include "link/connection/wakeup.h"
#include "tests/link/hurriedclock.h"
#include "tests/link/looprig.h"
#include "tests/support/gains.h"
#include "tests/support/port.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// Raw bytes in place of the simulator's, once that is wanted.
struct Raw {
    std::atomic<bool> on = false;
    std::mutex mutex;
    Bytes toHost, fromHost;
};
class RawTransport : public SimulatorTransport {
public:
    explicit RawTransport(std::shared_ptr<Raw> raw)
        : SimulatorTransport(servoChain(1)), m_raw(std::move(raw)) {}
    tl::expected<void, PortError> send(ByteSpan bytes) override {
        if (!m_raw->on)
            return SimulatorTransport::send(bytes);
        const std::scoped_lock lock(m_raw->mutex);
        m_raw->fromHost.insert(m_raw->fromHost.end(), bytes.begin(), bytes.end());
        return {};
    }
    tl::expected<Bytes, PortError> receive(std::optional<TimePoint> until, int wakeFd) override {
        if (m_raw->on) {
            const std::scoped_lock lock(m_raw->mutex);
            if (!m_raw->toHost.empty())
                return std::exchange(m_raw->toHost, {});
        }
        return SimulatorTransport::receive(until, wakeFd);
    }

private:
    std::shared_ptr<Raw> m_raw;  ///< the loop runs until the fixture ends, after the test
};

class LineLentAt : public testing::Test, public LoopRig {
protected:
    void onTurn() override { hurriedclock::allow(200ms); }
    void SetUp() override {
        hurriedclock::allow(0ms);
        fs::remove(path);
    }
    /// Behind it, the loop is waited for.
    void TearDown() override {
        fs::remove(path);
        hurriedclock::allow(1h);
    }

    [[nodiscard]] bool is(LineLent::State state) {
        return waitUntil([&] { return last<LineLent>() != nullptr && last<LineLent>()->state == state; });
    }
    void lend() {
        ASSERT_TRUE(waitFor<bus::ChainFound>());
        // By then, all are known to be at rest.
        ASSERT_TRUE(waitUntil([&] { return count<bus::Sample>() > 10; }));
        loop.requestBox().change([&](auto& pending) { pending.lendAt = path; });
        ASSERT_TRUE(is(LineLent::State::Waiting));
    }
    /// What the program receives in answer to this.
    Bytes exchange(Port& port, const Bytes& bytes, std::size_t length) {
        port.write(bytes);
        Bytes answer;
        EXPECT_TRUE(waitUntil([&] {
            const Bytes more = port.read(length, 0);
            answer.insert(answer.end(), more.begin(), more.end());
            return answer.size() >= length;
        }));
        return answer;
    }

    const std::string path = testing::TempDir() + "lent-" + std::to_string(::getpid());
    const Bytes kNop{0xAA, 1, 0x0E, 0x0F};
};

TEST_F(LineLentAt, AProgramHasTheLineUntilItCloses) {
    openSimulator(simulatorConfig(), servoChain(2));
    ASSERT_NO_FATAL_FAILURE(lend());
    {
        Port port(path);
        const Bytes answer = exchange(port, {0xAA, 1, 0x13, 0x20, 0x34}, 4);
        // Type 0, version 4: status 19 (move done, power, servo off), and the sum.
        EXPECT_EQ(answer, (Bytes{0x19, 0, 4, 0x1D}));
        ASSERT_TRUE(is(LineLent::State::InUse));
        ASSERT_TRUE(waitUntil([&] { return count<bus::Sample>() > 0; }));
    }
    ASSERT_TRUE(is(LineLent::State::Left));
    EXPECT_FALSE(fs::exists(fs::symlink_status(path)));
    ASSERT_TRUE(waitUntil([&] { return count<bus::ChainFound>() == 2; }));
    EXPECT_TRUE(last<bus::ChainFound>()->attached) << "nothing was reset";
}

TEST_F(LineLentAt, OpeningAndClosingItWithoutAByteDoesNotEndIt) {
    openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_NO_FATAL_FAILURE(lend());
    { const Port looks(path); }
    Port port(path);
    EXPECT_EQ(exchange(port, {0xAA, 1, 0x13, 0x20, 0x34}, 4).size(), 4U);
    EXPECT_TRUE(is(LineLent::State::InUse));
}

TEST_F(LineLentAt, EveryByteValuePassesBothWaysUnchanged) {
    const auto raw = std::make_shared<Raw>();
    openTransport<RawTransport>(simulatorConfig(), raw);
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path);
    ASSERT_EQ(exchange(port, {0xAA, 1, 0x13, 0x20, 0x34}, 4).size(), 4U);
    raw->on = true;
    Bytes bytes(1'024);
    std::mt19937 random(1);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random() & 0xFFU); });
    std::iota(bytes.begin(), bytes.begin() + 256, std::uint8_t{0});
    {
        const std::scoped_lock lock(raw->mutex);
        raw->toHost = bytes;
    }
    for (std::size_t at = 0; at < bytes.size(); at += 64)
        port.write({bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    bytes.begin() + static_cast<std::ptrdiff_t>(at + 64)});
    Bytes received;
    EXPECT_TRUE(waitUntil([&] {
        const Bytes more = port.read(bytes.size(), 0);
        received.insert(received.end(), more.begin(), more.end());
        const std::scoped_lock lock(raw->mutex);
        return received.size() >= bytes.size() && raw->fromHost.size() >= bytes.size();
    }));
    EXPECT_EQ(received, bytes) << received.size();
    const std::scoped_lock lock(raw->mutex);
    EXPECT_EQ(raw->fromHost, bytes) << raw->fromHost.size();
}

TEST_F(LineLentAt, TheRateOfTheProgramIsFollowed) {
    openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path);
    port.write({0xAA, 0xFF, 0x1A, 20, 0x2D});  // Set Baud to all
    port.setRate(B57600);
    ASSERT_TRUE(is(LineLent::State::InUse));
    Bytes later(64, 0);  // 11 ms, in which the modules switch
    later.insert(later.end(), {0xAA, 1, 0x13, 0x20, 0x34});
    EXPECT_EQ(exchange(port, later, 4), (Bytes{0x19, 0, 4, 0x1D}));
    ASSERT_TRUE(waitFor<bus::ModulesSeen>());
    EXPECT_EQ(last<bus::ModulesSeen>()->baud, 57'600U);
}

TEST_F(LineLentAt, StopAllHoldsTheProgramOffUntilItIsLetThrough) {
    openSimulator(simulatorConfig(), servoChain(2));
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path);
    // Heavy traffic: the next command as soon as one is answered.
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(exchange(port, {0xAA, 1, 0x13, 0x20, 0x34}, 4).size(), 4U);
    port.write({0xAA, 1});  // the beginning of a packet
    loop.stopAll();
    ASSERT_TRUE(waitFor<bus::StopFinished>());
    EXPECT_EQ(last<bus::StopFinished>()->stopped.size(), 2U);
    ASSERT_TRUE(is(LineLent::State::HeldOff));
    port.flush();
    port.write(kNop);
    loop.stopAll();  // by its end, that was taken from the terminal
    ASSERT_TRUE(waitUntil([&] { return count<bus::StopFinished>() == 2; }));
    loop.requestBox().change([](auto& pending) { pending.letThrough = true; });
    ASSERT_TRUE(is(LineLent::State::InUse));
    EXPECT_EQ(exchange(port, {0xAA, 1, 0x13, 0x20, 0x34}, 4), (Bytes{0x19, 0, 4, 0x1D}))
        << "and nothing else was answered";
}

TEST_F(LineLentAt, TheUserEndsIt) {
    openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path);
    ASSERT_EQ(exchange(port, {0xAA, 1, 0x13, 0x20, 0x34}, 4).size(), 4U);
    loop.requestBox().change([](auto& pending) { pending.stopLending(); });
    ASSERT_TRUE(is(LineLent::State::Ended));
    EXPECT_FALSE(fs::exists(fs::symlink_status(path)));
    ASSERT_TRUE(waitUntil([&] { return count<bus::ChainFound>() == 2; }));
    loop.ask(servoOperation(1, {servo::StopMotor{true, servo::StopManner::Abruptly, {}}}));
    ASSERT_TRUE(waitFor<bus::OperationFinished>());
    EXPECT_EQ(last<bus::OperationFinished>()->outcome, bus::Outcome::Done);
}

TEST_F(LineLentAt, ClosingTheConnectionStopsTheMotorsOfTheProgram) {
    openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_TRUE(waitFor<bus::ChainFound>());
    loop.ask(servoOperation(
        1, {testing_support::kGains, servo::StopMotor{true, servo::StopManner::Abruptly, {}}}));
    ASSERT_TRUE(waitFor<bus::OperationFinished>());
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path);
    // Velocity mode, at once.
    const Bytes reply = exchange(port, {0xAA, 1, 0x94, 0xB6, 0, 0, 1, 0, 0x99, 0x19, 0, 0, 0xFE}, 10);
    EXPECT_EQ(reply.front() & 0x02U, 0U);
    loop.close();
    ASSERT_TRUE(waitFor<PortClosed>());
    EXPECT_EQ(last<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_FALSE(fs::exists(fs::symlink_status(path)));
}

TEST_F(LineLentAt, NothingIsOverwritten) {
    openSimulator(simulatorConfig(), servoChain(1));
    ASSERT_TRUE(waitFor<bus::ChainFound>());
    std::ofstream(path) << "mine";
    loop.requestBox().change([&](auto& pending) { pending.lendAt = path; });
    ASSERT_TRUE(waitFor<LendingProblem>());
    EXPECT_EQ(last<LendingProblem>()->kind, LendingProblem::Kind::Taken);
    EXPECT_EQ(fs::file_size(path), 4U);
    fs::remove(path);
    fs::create_symlink(testing::TempDir(), path);
    loop.requestBox().change([&](auto& pending) { pending.lendAt = path; });
    ASSERT_TRUE(waitUntil([&] { return count<LendingProblem>() == 2; }));
    EXPECT_TRUE(fs::is_symlink(path)) << "a link that leads somewhere may be in use";
    loop.requestBox().change([&](auto& pending) { pending.lendAt = path + "/no/such/folder/x"; });
    ASSERT_TRUE(waitUntil([&] { return count<LendingProblem>() == 3; }));
    EXPECT_EQ(last<LendingProblem>()->kind, LendingProblem::Kind::System);
}

/// Otherwise the bus thread would not be woken by a stop.
TEST(LentTerminal, IsNotMadeWithoutADescriptorToWaitFor) {
    const std::string path = testing::TempDir() + "lent-few-" + std::to_string(::getpid());
    const Wakeup wakeup;
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit few{128, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
    std::vector<int> taken;
    for (int fd = 0; (fd = ::open("/dev/null", O_RDONLY | O_CLOEXEC)) >= 0;)
        taken.push_back(fd);
    // It needs 6: both ends of a terminal, two watches, what these are collected in, and the wait.
    for (int left = 0; left <= 6 && !taken.empty(); ++left) {
        const auto lent = LentTerminal::create(path, 19'200, wakeup.fd());
        EXPECT_TRUE(lent ? lent->waitFd() >= 0 : lent.error().kind == LendingProblem::Kind::System) << left;
        ::close(taken.back());
        taken.pop_back();
    }
    for (const int fd : taken)
        ::close(fd);
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
}

TEST_F(LineLentAt, NotWhileAMotorMoves) {
    openSimulator(simulatorConfig(115'200), servoChain(1));
    ASSERT_TRUE(waitFor<bus::ChainFound>());
    loop.ask(runOn(1));
    ASSERT_TRUE(waitFor<bus::OperationFinished>());
    loop.requestBox().change([&](auto& pending) { pending.lendAt = path; });
    ASSERT_TRUE(waitFor<LendingProblem>());
    EXPECT_EQ(last<LendingProblem>()->kind, LendingProblem::Kind::NotNow);
    EXPECT_FALSE(fs::exists(path)) << "and the terminal is gone";
}

}  // namespace
}  // namespace nmc
