// SPDX-License-Identifier: GPL-3.0-or-later
// What hosts do to a terminal besides talking, in real time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/support/port.h"
#include "tests/support/simprocess.h"

namespace nmc {
namespace {

using testing_support::Port;
using testing_support::SimProcess;
using Bytes = std::vector<std::uint8_t>;

const Bytes kNop{0xAA, 0x01, 0x0E, 0x0F};
const Bytes kSetAddress{0xAA, 0x00, 0x21, 0x01, 0xFF, 0x21};
const Bytes kIdle{0x19, 0x19};

void pause(int ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

/// What is answered, up to `count` bytes; a tenth of a second of silence is the end.
Bytes answer(Port& port, const Bytes& command, std::size_t count = 2) {
    port.flush();
    port.write(command);
    Bytes all;
    while (all.size() < count) {
        const Bytes more = port.read(count - all.size(), 100);
        if (more.empty())
            break;
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

/// As hosts do it: with nulls, and again when there was no answer.
bool answers(Port& port, const Bytes& command, const Bytes& wanted = kIdle) {
    for (int i = 0; i < 20; ++i) {
        if (answer(port, command, wanted.size()) == wanted)
            return true;
        port.write(Bytes(30, 0));
        pause(50);
    }
    return false;
}

void waitUntilHeard(SimProcess& sim, std::size_t bytes) {
    while (sim.control("time")["received"] < bytes)
        pause(1);
}

unsigned nops(SimProcess& sim) {
    return sim.control("stats")["modules"][0]["executed"].value("nop", 0U);
}

/// Resident memory in bytes.
std::size_t memory(const SimProcess& sim) {
    std::size_t pages = 0;
    std::ifstream("/proc/" + std::to_string(sim.pid()) + "/statm") >> pages >> pages;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

TEST(Terminal, AHostThatNeverSetsARateIsUnderstood) {
    SimProcess sim("servo");
    Port port(sim.terminal());
    EXPECT_EQ(port.rate(), speed_t{B19200});
    EXPECT_TRUE(answers(port, kSetAddress));
    EXPECT_EQ(sim.control("stats")["modules"][0]["bytes_garbled"], 0);
}

TEST(Terminal, AHostThatChooses38400IsTakenAtItsWord) {
    SimProcess sim("servo");
    Port port(sim.terminal());
    ASSERT_TRUE(answers(port, kSetAddress));
    port.setRate(B38400);
    EXPECT_TRUE(answer(port, kNop).empty()) << "the module is at 19 200 Bd";
    port.setRate(B19200);
    ASSERT_TRUE(answers(port, kNop));
    port.write({0xAA, 0xFF, 0x1A, 32, 0x39});
    port.setRate(B38400);
    pause(20);
    EXPECT_TRUE(answers(port, kNop));
    EXPECT_EQ(sim.state(1)["baud"], 37'879) << "1 250 000 / 33";
}

TEST(Terminal, ANewRateIsNoticedWithoutABytesHelp) {
    SimProcess sim("servo");
    Port port(sim.terminal());
    ASSERT_TRUE(answers(port, kSetAddress));
    // Nothing but Set Baud at 115 200 Bd, and back at once.
    port.write({0xAA, 0xFF, 0x1A, 10, 0x23});
    port.setRate(B115200);
    pause(200);
    EXPECT_EQ(sim.state(1)["baud"], 113'636);
    port.write({0xAA, 0xFF, 0x1A, 63, 0x58});
    port.setRate(B19200);
    pause(50);
    EXPECT_TRUE(answers(port, kNop));
    EXPECT_EQ(sim.control("stats")["modules"][0]["bytes_garbled"], 0);
}

TEST(Terminal, AHostMayCloseItAndComeBack) {
    SimProcess sim("servo");
    {
        Port port(sim.terminal());
        ASSERT_TRUE(answers(port, kSetAddress));
        port.write({0xAA, 0xFF, 0x1A, 10, 0x23});
        port.setRate(B115200);
        pause(20);
        ASSERT_TRUE(answers(port, kNop));
    }
    Port port(sim.terminal());
    EXPECT_EQ(port.rate(), speed_t{B115200}) << "as a terminal keeps it";
    EXPECT_TRUE(answers(port, kNop));
    EXPECT_EQ(sim.state(1)["address"], 1);
}

TEST(Terminal, BytesThatAreStillLeavingKeepTheRateTheyWereWrittenAt) {
    SimProcess sim("servo");
    Port port(sim.terminal());
    ASSERT_TRUE(answers(port, kSetAddress));
    const std::size_t before = sim.control("time")["received"];
    // 500 nulls are 260 ms at 19 200 Bd; read they are at once.
    Bytes bytes(500, 0);
    bytes.insert(bytes.end(), kNop.begin(), kNop.end());
    port.write(bytes);
    waitUntilHeard(sim, before + bytes.size());
    port.setRate(B115200);
    for (int i = 0; i < 100 && nops(sim) == 0; ++i)
        pause(20);
    EXPECT_EQ(nops(sim), 1U);
    port.setRate(B19200);
    EXPECT_TRUE(answers(port, kNop));
}

TEST(Terminal, AHostThatHangsUpInAPacketLeavesAModuleThatWaitsForTheRest) {
    SimProcess sim("servo");
    {
        Port port(sim.terminal());
        ASSERT_TRUE(answers(port, kSetAddress));
        const std::size_t before = sim.control("time")["received"];
        port.write({0xAA, 0x01, 0x74});
        waitUntilHeard(sim, before + 3);
    }
    Port port(sim.terminal());
    EXPECT_TRUE(answer(port, kNop).empty()) << "four of the eight bytes that are wanted";
    EXPECT_TRUE(answers(port, kNop));
    EXPECT_EQ(sim.control("stats")["modules"][0]["executed"].contains("load_trajectory"), false);
}

TEST(Terminal, AMegabyteOfRepliesThatNobodyReadsHarmsNothing) {
    // Read Status with everything, and nulls for longer than a tick (0.52 ms each at 19 200 Bd) behind it.
    const Bytes query{0xAA, 0x01, 0x13, 0x3F, 0x53, 0, 0};
    constexpr unsigned kQueries = 65'536;  // of 16 bytes each
    constexpr unsigned kAtOnce = 2'048;
    SimProcess sim("servo", {"--unpaced", "--speed", "1000"});
    Port port(sim.terminal());
    ASSERT_TRUE(answers(port, kSetAddress));
    Bytes queries;
    for (unsigned i = 0; i < kAtOnce; ++i)
        queries.insert(queries.end(), query.begin(), query.end());
    std::size_t before = 0;
    for (unsigned asked = 0; asked < kQueries; asked += kAtOnce) {
        const std::size_t wanted = sim.control("stats")["bytes_in"].get<std::size_t>() + queries.size();
        port.write(queries);
        while (sim.control("stats")["bytes_in"] < wanted)
            pause(1);
        if (asked == 0)
            before = memory(sim);
    }
    EXPECT_GE(sim.control("time")["sent"], 1'000'000);
    EXPECT_LT(memory(sim), before + 2'000'000);
    port.flush();
    pause(50);
    EXPECT_TRUE(answers(port, kNop));
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

TEST(Terminal, ASimulationThatCannotKeepUpSaysSoAndStillAnswers) {
    // 32 moving servos at a thousand times real time are too much for any machine.
    constexpr int kServos = 32;
    std::string chain = "servo";
    for (int i = 1; i < kServos; ++i)
        chain += ",servo";
    const std::string errors = testing::TempDir() + "nmc-lag-" + std::to_string(::getpid());
    SimProcess sim(chain, {"--speed", "1000"}, errors);
    const auto said = [&] {
        std::ifstream file(errors);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const auto waitUntilSaid = [&](const char* words) {
        for (int i = 0; i < 6'000 && said().find(words) == std::string::npos; ++i)
            pause(10);
        return said().find(words) != std::string::npos;
    };
    Port port(sim.terminal());
    for (std::uint8_t i = 1; sim.state(kServos)["address"] == 0; ++i)
        answer(port, command(0, 0x21, {i, 0xFF}));
    // To all: gains, amplifier and servo on, velocity mode.
    for (const Bytes& bytes :
         {command(0xFF, 0xE6, {200, 0, 0xD0, 7, 0, 0, 0, 0, 255, 0, 0xFF, 0x3F, 1, 0}),
          command(0xFF, 0x17, {0x05}), command(0xFF, 0x94, {0xB6, 0, 0, 5, 0, 0, 1, 0, 0})}) {
        port.write(bytes);
        pause(50);
    }
    EXPECT_TRUE(waitUntilSaid("s behind real time; use fewer modules or a lower --speed.\n"));
    const double before = sim.control("time")["time"];
    for (int i = 1; i <= kServos; ++i)
        EXPECT_TRUE(sim.control("set " + std::to_string(i) + " power 0")["ok"]);
    EXPECT_GT(sim.control("time")["time"], before);
    EXPECT_TRUE(waitUntilSaid("nmcsim: caught up with real time.\n"));
    ::unlink(errors.c_str());
}

}  // namespace
}  // namespace nmc
