// SPDX-License-Identifier: GPL-3.0-or-later
// What hosts do with a terminal besides communicating. Time is stepped, so that the scheduler has no
// influence.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "tests/conformance/terminalhost.h"

namespace nmc {
namespace {

using namespace terminal;

/// Resident memory in bytes.
std::size_t memory(const SimProcess& sim) {
    std::size_t pages = 0;
    std::ifstream("/proc/" + std::to_string(sim.pid()) + "/statm") >> pages >> pages;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// A named pipe for the standard error of a process.
class NamedPipe {
public:
    NamedPipe() : m_path(testing::TempDir() + "nmc-said-" + std::to_string(::getpid())) {
        ::unlink(m_path.c_str());
        if (::mkfifo(m_path.c_str(), S_IRUSR | S_IWUSR) != 0)
            throw std::runtime_error("mkfifo");
        m_fd = ::open(m_path.c_str(), O_RDWR | O_CLOEXEC);
    }
    ~NamedPipe() {
        ::close(m_fd);
        ::unlink(m_path.c_str());
    }
    NamedPipe(const NamedPipe&) = delete;
    NamedPipe& operator=(const NamedPipe&) = delete;

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Reads until `words` have arrived; returns false if nothing arrives any more.
    bool waitUntilSaid(const std::string& words) {
        while (m_said.find(words) == std::string::npos) {
            pollfd readable{m_fd, POLLIN, 0};
            std::array<char, 512> buffer{};
            if (::poll(&readable, 1, kPatienceMs) != 1)
                return false;
            const auto got = ::read(m_fd, buffer.data(), buffer.size());
            if (got <= 0)
                return false;
            m_said.append(buffer.data(), static_cast<std::size_t>(got));
        }
        return true;
    }

private:
    std::string m_path;
    std::string m_said;
    int m_fd = -1;
};

TEST(Terminal, ReadyIsSaidWhenTheFirstModuleListens) {
    const std::vector<std::string> deafForLong{"--reset-dead-time", "500"};
    Host host(deafForLong);
    EXPECT_EQ(host.answer(kSetAddress), kIdle);
    EXPECT_EQ(host.sim.control("stats")["bytes_unheard"], 0);

    SimProcess inRealTime("servo", deafForLong);
    Port port(inRealTime.terminal());
    port.write(kSetAddress);
    Bytes answer = port.read(1, kPatienceMs);
    answer.push_back(port.read(1, kPatienceMs).at(0));
    EXPECT_EQ(answer, kIdle);
}

TEST(Terminal, WhatIsSentInTheDeadTimeOfAResetIsCountedAsUnheard) {
    Host host({"--reset-dead-time", "500"});
    ASSERT_EQ(host.answer(kSetAddress), kIdle);
    host.write(kResetAll);
    host.pass(0.1);
    EXPECT_TRUE(host.answer(kSetAddress).empty());
    EXPECT_EQ(host.sim.control("stats")["bytes_unheard"], kSetAddress.size());
    host.pass(0.5);
    EXPECT_EQ(host.answer(kSetAddress), kIdle);
    EXPECT_EQ(host.sim.control("stats")["bytes_unheard"], kSetAddress.size());
}

TEST(Terminal, AHostMayCloseItAndComeBack) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    host.write(kAllTo115200);
    host.setRate(B115200);
    host.pass(0.02);
    ASSERT_TRUE(host.answers(kNop));
    host.hangUp();
    host.comeBack();
    EXPECT_EQ(host.rate(), speed_t{B115200}) << "a terminal keeps its rate";
    EXPECT_TRUE(host.answers(kNop));
    EXPECT_EQ(host.sim.state(1)["address"], 1);
}

TEST(Terminal, WhatAHostHasWrittenBeforeItHangsUpTakesNoMoreWireTime) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    const double before = host.sim.control("time")["time"];
    // 1000 nulls are 521 ms at 19 200 Bd, and the command takes another 2 ms; nothing of this is lost.
    Bytes burst(1000, 0);
    burst.insert(burst.end(), kNopToAll.begin(), kNopToAll.end());
    host.write(burst);
    host.hangUp();
    host.comeBack();
    EXPECT_EQ(host.answer(kNop), kIdle) << "no old bytes come before it";
    EXPECT_EQ(host.nops(), 2U);
    const double now = host.sim.control("time")["time"];
    EXPECT_NEAR(now - before, 1004 * 10.0 / 19'200 + 0.1, 1e-3) << "the line's time, and that of the answer";
    EXPECT_EQ(host.sim.control("stats")["violation_count"], 0);
}

TEST(Terminal, AnswersThatAHostDidNotReadBeforeItHangsUpAreGone) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    host.write({0xAA, 0x01, 0x13, 0x20, 0x34});  // type and version: four bytes
    host.pass(0.1);
    host.hangUp();
    host.comeBack();
    EXPECT_EQ(host.answer(kNop), kIdle);
}

TEST(Terminal, InRealTimeAHostThatHangsUpAndComesBackIsAnsweredAtOnce) {
    SimProcess sim("servo");
    std::optional<Port> port(sim.terminal());
    port->write(kSetAddress);
    while (sim.state(1)["address"] != 1) {
    }
    port->write(Bytes(60'000, 0));  // 31 s
    port.reset();
    port.emplace(sim.terminal());
    port->write(kNop);
    Bytes answer = port->read(1, kPatienceMs);
    ASSERT_FALSE(answer.empty());
    answer.push_back(port->read(1, kPatienceMs).at(0));
    EXPECT_EQ(answer, kIdle);
    EXPECT_GE(sim.control("time")["time"], 31.0);
}

TEST(Terminal, BytesThatAreStillLeavingKeepTheRateTheyWereWrittenAt) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    // 500 nulls are 260 ms at 19 200 Bd; they are read at once.
    Bytes bytes(500, 0);
    bytes.insert(bytes.end(), kNop.begin(), kNop.end());
    host.write(bytes);
    host.setRate(B115200);
    host.pass(0.2);
    EXPECT_EQ(host.nops(), 0U);
    host.pass(0.1);
    EXPECT_EQ(host.nops(), 1U);
    host.setRate(B19200);
    EXPECT_TRUE(host.answersAfterAFlood(kNop));
}

TEST(Terminal, AHostThatHangsUpInAPacketLeavesAModuleThatWaitsForTheRest) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    host.write({0xAA, 0x01, 0x74});
    host.hangUp();
    host.comeBack();
    EXPECT_TRUE(host.answer(kNop).empty()) << "these are four of the eight missing bytes";
    host.answer(Bytes(30, 0));  // the rest, which makes a wrong sum, and more
    EXPECT_TRUE(host.answers(kNop));
    EXPECT_EQ(host.sim.control("stats")["modules"][0]["executed"].contains("load_trajectory"), false);
}

TEST(Terminal, AMegabyteOfRepliesThatNobodyReadsHarmsNothing) {
    // Read Status with everything, and nulls for longer than a tick (0.52 ms each at 19 200 Bd) after it.
    const Bytes query{0xAA, 0x01, 0x13, 0x3F, 0x53, 0, 0};
    constexpr unsigned kQueries = 65'536;  // of 16 bytes each
    constexpr unsigned kAtOnce = 2'048;
    ::setenv("ASAN_OPTIONS", "quarantine_size_mb=1", 0);  // quarantined memory would count as well
    Host host({"--unpaced"});
    ASSERT_TRUE(host.answers(kSetAddress));
    Bytes queries;
    for (unsigned i = 0; i < kAtOnce; ++i)
        queries.insert(queries.end(), query.begin(), query.end());
    std::size_t before = 0;
    for (unsigned asked = 0; asked < kQueries; asked += kAtOnce) {
        host.write(queries);
        host.pass(0.53e-3 * static_cast<double>(queries.size()));
        if (asked == 0)
            before = memory(host.sim);
    }
    EXPECT_GE(host.sim.control("time")["sent"], 1'000'000);
    EXPECT_LT(memory(host.sim), before + 2'000'000);
    EXPECT_TRUE(host.answersAfterAFlood(kNop));
}

Bytes command(unsigned address, unsigned code, const Bytes& data) {
    Bytes bytes{0xAA, static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(code)};
    unsigned sum = address + code;
    for (const std::uint8_t value : data) {
        bytes.push_back(value);
        sum += value;
    }
    bytes.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
    return bytes;
}

TEST(Terminal, OptionsTakeTheirValueBehindASpaceOrAnEqualsSign) {
    const std::string link = testing::TempDir() + "nmc-options-" + std::to_string(::getpid());
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--chain", "step,servo@2", "--link", link, "--seed", "3", "--speed", "2"},
          std::vector<std::string>{"--chain=step,servo@2", "--link=" + link, "--seed=3", "--speed=2"}}) {
        SimProcess sim("servo", options);
        EXPECT_EQ(sim.state(1)["type"], "step");
        EXPECT_EQ(sim.state(2)["version"], 2);
        const Port throughTheLink(link);
    }
}

TEST(Terminal, AControlLineThatIsTooLongIsRefusedAsAWhole) {
    Host host;
    // If a part of it were read as a line of its own, the end would set the load.
    for (const std::size_t blanks : {4'096U, 5'000U, 70'000U}) {
        auto answer = host.sim.control("stats" + std::string(blanks, ' ') + "\rset 1 load 0.02");
        EXPECT_EQ(answer["error"], "too long a line; allowed are 4096 bytes") << blanks;
        EXPECT_EQ(host.sim.state(1)["load"], 0.0);
    }
    EXPECT_EQ(host.sim.control("set 1 load " + std::string(4'081, ' ') + "0.02")["ok"], true) << "4096 bytes";
}

TEST(Terminal, ASimulatorThatIsNotLetRunSaysSo) {
    SimProcess sim("servo");
    Port port(sim.terminal());
    const unsigned before = sim.control("time")["stalls"];
    ::kill(sim.pid(), SIGSTOP);
    int status = 0;
    ASSERT_EQ(::waitpid(sim.pid(), &status, WUNTRACED), sim.pid());
    ASSERT_TRUE(WIFSTOPPED(status));
    EXPECT_TRUE(port.read(1, 50).empty());  // for 50 ms
    ::kill(sim.pid(), SIGCONT);
    EXPECT_GT(sim.control("time")["stalls"], before);
    EXPECT_GE(sim.control("stats")["longest_stall"], 0.05);
    Host stepped;
    stepped.pass(1.0);
    EXPECT_EQ(stepped.sim.control("stats")["stalls"], 0) << "nothing is late where nothing is paced";
}

TEST(Terminal, OnlyALineThatIsObeyedRestartsAMeasurement) {
    SimProcess sim("servo");
    Port port(sim.terminal());
    port.write(kSetAddress);
    for (std::size_t i = 0; i < kIdle.size(); ++i)
        ASSERT_FALSE(port.read(1, kPatienceMs).empty());
    for (const char* refused : {"time now", "times"})
        EXPECT_TRUE(sim.control(refused).contains("error")) << refused;
    EXPECT_GT(sim.control("  time ")["lag"], 0.0) << "a byte never arrives before it is due";
    EXPECT_EQ(sim.control("time")["lag"], 0.0) << "nothing has been sent since";

    ::kill(sim.pid(), SIGSTOP);
    int status = 0;
    ASSERT_EQ(::waitpid(sim.pid(), &status, WUNTRACED), sim.pid());
    EXPECT_TRUE(port.read(1, 50).empty());  // for 50 ms
    ::kill(sim.pid(), SIGCONT);
    const double longest = sim.control("time")["longest_stall"];
    ASSERT_GE(longest, 0.05);
    EXPECT_TRUE(sim.control("stats clear all").contains("error"));
    EXPECT_GE(sim.control("stats")["longest_stall"], longest);
    EXPECT_EQ(sim.control("stats  clear")["ok"], true);
    EXPECT_NE(sim.control("stats")["longest_stall"], longest);
}

TEST(Terminal, ASimulationThatCannotKeepUpSaysSoAndStillAnswers) {
    // 32 moving servos at a thousand times real time are too much for any machine.
    constexpr int kServos = 32;
    std::string chain = "servo";
    for (int i = 1; i < kServos; ++i)
        chain += ",servo";
    NamedPipe errors;
    SimProcess sim(chain, {"--speed", "1000"}, errors.path());
    Port port(sim.terminal());
    for (int i = 1; i <= kServos; ++i) {
        port.write(command(0, 0x21, {static_cast<std::uint8_t>(i), 0xFF}));
        while (sim.state(i)["address"] == 0) {
        }
    }
    // To all: gains, amplifier and servo on, velocity mode.
    const std::array<std::pair<const char*, Bytes>, 3> toAll{
        {{"set_gain", command(0xFF, 0xE6, {200, 0, 0xD0, 7, 0, 0, 0, 0, 255, 0, 0xFF, 0x3F, 1, 0})},
         {"stop_motor", command(0xFF, 0x17, {0x05})},
         {"load_trajectory", command(0xFF, 0x94, {0xB6, 0, 0, 5, 0, 0, 1, 0, 0})}}};
    for (const auto& [name, bytes] : toAll) {
        port.write(bytes);
        while (!sim.control("stats")["modules"][kServos - 1]["executed"].contains(name)) {
        }
    }
    EXPECT_TRUE(errors.waitUntilSaid("s behind real time; use fewer modules or a lower --speed.\n"));
    const double before = sim.control("time")["time"];
    for (int i = 1; i <= kServos; ++i)
        EXPECT_TRUE(sim.control("set " + std::to_string(i) + " power 0")["ok"]);
    EXPECT_GT(sim.control("time")["time"], before);
    EXPECT_TRUE(errors.waitUntilSaid("nmcsim: caught up with real time.\n"));
}

}  // namespace
}  // namespace nmc
