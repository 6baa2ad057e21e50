// SPDX-License-Identifier: GPL-3.0-or-later
// A laboratory centrifuge's host, one PIC-SERVO and one PIC-I/O, in real time on nmcsim's terminal: nothing
// but POSIX. It sends its whole start-up in one go, which works only where bytes take their time on the wire
// and a module that was reset is deaf for a while; it sends a frame with a wrong sum; it uses code 20 for
// 57 600 Bd, and asks again where that costs a byte; and it takes no status byte but 09 for rest.
#include <gtest/gtest.h>

#include <chrono>
#include <optional>

#include "tests/conformance/fieldhost.h"
#include "tests/support/port.h"
#include "tests/support/simprocess.h"

namespace nmc {
namespace {

using namespace field;
using testing_support::Port;
using testing_support::SimProcess;

constexpr unsigned kServo = 1, kIo = 2;

Bytes packet(unsigned address, unsigned command, const Bytes& data = {}) {
    Bytes bytes{0xAA, static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(command)};
    bytes.insert(bytes.end(), data.begin(), data.end());
    unsigned sum = address + command;
    for (const std::uint8_t byte : data)
        sum += byte;
    bytes.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
    return bytes;
}

bool sumIsRight(const Bytes& reply) {
    unsigned sum = 0;
    for (std::size_t i = 0; i + 1 < reply.size(); ++i)
        sum += reply[i];
    return (sum & 0xFFU) == reply.back();
}

class Centrifuge : public testing::TestWithParam<const char*> {
protected:
    Centrifuge() : sim(std::string(GetParam()) + ",io"), port(sim.terminal()) { port.setRate(B19200); }

    /// 420 bytes without waiting for anything: nulls, Hard Reset, both addresses, and nulls for the time
    /// between them; at 19 200 Bd they take 0.22 s.
    void preamble() {
        const Bytes bytes = Bytes(100, 0) + packet(kEveryone, 0x0F) + Bytes(60, 0) +
                            packet(0, 0x21, {kServo, kEveryone}) + Bytes(40, 0) +
                            packet(0, 0x21, {kIo, kEveryone}) + Bytes(204, 0);
        ASSERT_EQ(bytes.size(), 420U);
        port.write(bytes);
        discard(400);
    }
    void discard(int ms) {
        while (!port.read(256, ms).empty()) {
        }
    }
    std::optional<Bytes> once(const Bytes& bytes, std::size_t length) {
        port.write(bytes);
        Bytes reply;
        while (reply.size() < length) {
            const Bytes more = port.read(length - reply.size(), 100);
            if (more.empty())
                break;
            reply.insert(reply.end(), more.begin(), more.end());
        }
        if (reply.size() == length && sumIsRight(reply))
            return reply;
        port.write(Bytes(20, 0));
        discard(50);
        return std::nullopt;
    }
    /// Until it is answered and not refused.
    Bytes ask(unsigned address, unsigned command, const Bytes& data, std::size_t length) {
        for (int i = 0; i < 20; ++i)
            if (const auto reply = once(packet(address, command, data), length);
                reply && (reply->front() & 0x02U) == 0)
                return *reply;
        throw std::runtime_error("module " + std::to_string(address) + " does not answer");
    }
    unsigned status() { return ask(kServo, 0x0E, {}, 2).front(); }
    void waitForRest() {
        for (const auto start = Clock::now(); Clock::now() < start + kPatience;)
            if (status() == 0x09)
                return;
        FAIL() << "the status byte never is 09: " << status();
    }

    SimProcess sim;
    Port port;
};

TEST_P(Centrifuge, RunsUpHomesAndComesToRest) {
    preamble();
    EXPECT_EQ(ask(kServo, 0x13, {0x20}, 4).at(1), 0U);
    EXPECT_EQ(ask(kIo, 0x13, {0x20}, 4).at(1), 2U);

    // Gains with a wrong sum: refused, and not carried out.
    const Bytes gains{40, 0, 200, 0, 0, 0, 0, 0, 255, 0, 0xFF, 0x3F, 5, 0};
    Bytes wrong = packet(kServo, 0xE6, gains);
    wrong.back() ^= 0x10U;
    const auto refused = once(wrong, 2);
    ASSERT_TRUE(refused.has_value());
    EXPECT_EQ(refused->front() & 0x02U, 0x02U);
    EXPECT_EQ(sim.state(1)["gains"]["kp"], 0);

    port.write(packet(kEveryone, 0x1A, {20}));
    port.setRate(B57600);
    discard(20);

    ask(kIo, 0x20, {0xFF, 0x0F}, 2);
    EXPECT_EQ(sim.state(2)["is_input"], nlohmann::json(std::vector<bool>(12, true)));
    EXPECT_EQ(ask(kServo, 0x13, {0x1F}, 14).size(), 14U);
    EXPECT_EQ(ask(kIo, 0x13, {0x1F}, 11).size(), 11U);

    ask(kServo, 0xE6, gains, 2);
    EXPECT_EQ(sim.state(1)["gains"]["sr"], 5);
    ask(kServo, 0x17, {0x05}, 2);  // amplifier and servo on
    ask(kServo, 0x0B, {}, 2);
    waitForRest();

    // Home on the index with a smooth stop: 20 counts and 1 count per tick and tick, of five times 0.512 ms.
    ask(kServo, 0x19, {0x28}, 2);
    EXPECT_EQ(status() & 0x80U, 0x80U);
    ask(kServo, 0x94, {0xB6, 0, 0, 20, 0, 0, 0, 1, 0}, 2);
    for (const auto start = Clock::now(); (status() & 0x80U) != 0;)
        ASSERT_LT(Clock::now(), start + kPatience) << "no index";
    waitForRest();
    const Bytes reply = ask(kServo, 0x13, {0x1F}, 14);
    const std::int32_t home = sim.state(1)["home"];
    EXPECT_EQ(reply.at(9) | reply.at(10) << 8U, home & 0xFFFF);
    EXPECT_GT(sim.state(1)["position"].get<int>(), home) << "it stopped behind the index";
    EXPECT_EQ(sim.state(1)["command_velocity"], 0.0);
}

TEST_P(Centrifuge, ReadsAllEightItemsFromEveryServo) {
    preamble();
    // A host that takes every servo for an SC gets its 19 bytes from one, and the 16 that there are else.
    const bool isSc = std::string(GetParam()) == "servo@10";
    const Bytes reply = ask(kServo, 0x13, {0xFF}, isSc ? 19 : 16);
    EXPECT_EQ(reply.at(14), isSc ? 10U : 4U);
    EXPECT_EQ(ask(kIo, 0x13, {0xFF}, 19).size(), 19U);
}

INSTANTIATE_TEST_SUITE_P(Servos, Centrifuge, testing::Values("servo", "servo@10"),
                         [](const auto& of) { return std::string(of.param) == "servo" ? "V4" : "Sc"; });

}  // namespace
}  // namespace nmc
