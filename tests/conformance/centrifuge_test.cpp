// SPDX-License-Identifier: GPL-3.0-or-later
// The host of a laboratory centrifuge with one PIC-SERVO and one PIC-I/O, on nmcsim's terminal, using only
// POSIX. It sends its whole start-up in one go, which works only if bytes take their time on the line and a
// module that was reset is deaf for a while; it sends a frame with a wrong sum; it uses code 20 for 57 600
// Bd; and it accepts only the status byte 09 as rest.
#include <gtest/gtest.h>

#include "tests/conformance/fieldhost.h"

namespace nmc {
namespace {

using namespace field;

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
    Centrifuge() : sim(std::string(GetParam()) + ",io", {"--stepped"}), wire(sim) {}

    /// Sends 420 bytes without waiting for anything: nulls, Hard Reset, both addresses, and nulls for the
    /// time between them; at 19 200 Bd they take 0.22 s.
    void preamble() {
        const Bytes bytes = Bytes(100, 0) + packet(kEveryone, 0x0F) + Bytes(60, 0) +
                            packet(0, 0x21, {kServo, kEveryone}) + Bytes(40, 0) +
                            packet(0, 0x21, {kIo, kEveryone}) + Bytes(204, 0);
        ASSERT_EQ(bytes.size(), 420U);
        wire.exchange(bytes, 0.4);
    }
    /// Sends `bytes` and returns the answer, which must have this length and the right sum.
    Bytes answered(const Bytes& bytes, std::size_t length) {
        Bytes reply = wire.exchange(bytes);
        if (reply.size() != length || !sumIsRight(reply))
            throw std::runtime_error("a reply of " + std::to_string(reply.size()) + " bytes");
        return reply;
    }
    /// Sends a command and returns the answer, which must not be a refusal.
    Bytes ask(unsigned address, unsigned command, const Bytes& data, std::size_t length) {
        Bytes reply = answered(packet(address, command, data), length);
        EXPECT_EQ(reply.front() & 0x02U, 0U);
        return reply;
    }
    unsigned status() { return ask(kServo, 0x0E, {}, 2).front(); }
    void waitForRest() {
        for (int i = 0; i < kPatience; ++i)
            if (status() == 0x09)
                return;
        FAIL() << "the status byte never is 09: " << status();
    }

    Sim sim;
    Wire wire;
};

TEST_P(Centrifuge, RunsUpHomesAndComesToRest) {
    preamble();
    EXPECT_EQ(ask(kServo, 0x13, {0x20}, 4).at(1), 0U);
    EXPECT_EQ(ask(kIo, 0x13, {0x20}, 4).at(1), 2U);

    // Gains with a wrong sum: refused, and not carried out.
    const Bytes gains{40, 0, 200, 0, 0, 0, 0, 0, 255, 0, 0xFF, 0x3F, 5, 0};
    Bytes wrong = packet(kServo, 0xE6, gains);
    wrong.back() ^= 0x10U;
    EXPECT_EQ(answered(wrong, 2).front() & 0x02U, 0x02U);
    EXPECT_EQ(sim.state(1)["gains"]["kp"], 0);

    wire.exchange(packet(kEveryone, 0x1A, {20}));
    wire.setRate(B57600);

    ask(kIo, 0x20, {0xFF, 0x0F}, 2);
    EXPECT_EQ(sim.state(2)["is_input"], nlohmann::json(std::vector<bool>(12, true)));
    EXPECT_EQ(ask(kServo, 0x13, {0x1F}, 14).size(), 14U);
    EXPECT_EQ(ask(kIo, 0x13, {0x1F}, 11).size(), 11U);

    ask(kServo, 0xE6, gains, 2);
    EXPECT_EQ(sim.state(1)["gains"]["sr"], 5);
    ask(kServo, 0x17, {0x05}, 2);  // amplifier and servo on
    ask(kServo, 0x0B, {}, 2);
    waitForRest();

    // Home on the index with a smooth stop: 20 counts per tick and 1 count per tick squared, with ticks of
    // five times 0.512 ms.
    ask(kServo, 0x19, {0x28}, 2);
    EXPECT_EQ(status() & 0x80U, 0x80U);
    ask(kServo, 0x94, {0xB6, 0, 0, 20, 0, 0, 0, 1, 0}, 2);
    for (int i = 0; (status() & 0x80U) != 0; ++i)
        ASSERT_LT(i, kPatience) << "no index";
    waitForRest();
    const Bytes reply = ask(kServo, 0x13, {0x1F}, 14);
    const std::int32_t home = sim.state(1)["home"];
    EXPECT_EQ(reply.at(9) | reply.at(10) << 8U, home & 0xFFFF);
    EXPECT_GT(sim.state(1)["position"].get<int>(), home) << "it stopped after the index";
    EXPECT_EQ(sim.state(1)["command_velocity"], 0.0);
}

TEST_P(Centrifuge, ReadsAllEightItemsFromEveryServo) {
    preamble();
    // A host that takes every servo for an SC gets 19 bytes from an SC, and only 16 from others.
    const bool isSc = std::string(GetParam()) == "servo@10";
    const Bytes reply = ask(kServo, 0x13, {0xFF}, isSc ? 19 : 16);
    EXPECT_EQ(reply.at(14), isSc ? 10U : 4U);
    EXPECT_EQ(ask(kIo, 0x13, {0xFF}, 19).size(), 19U);
}

INSTANTIATE_TEST_SUITE_P(Servos, Centrifuge, testing::Values("servo", "servo@10"),
                         [](const auto& of) { return std::string(of.param) == "servo" ? "V4" : "Sc"; });

}  // namespace
}  // namespace nmc
