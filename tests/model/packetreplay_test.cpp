// SPDX-License-Identifier: GPL-3.0-or-later
// A log that was saved and read back is replayed to a fresh chain: the same commands get the same replies.
#include <gtest/gtest.h>

#include "model/packets/packetfile.h"
#include "tests/support/packetfilereader.h"
#include "tests/support/packetreplay.h"
#include "tests/support/virtualbus.h"

namespace nmc {
namespace {

using test::VirtualBus;

/// Records the traffic of a virtual bus.
class Tap {
public:
    explicit Tap(VirtualBus& bus) : m_bus(bus) {
        m_log.begin({"test", "2025-06-01T12:00:00.000Z", "simulator", true, TimePoint{}});
        bus.onCommand = [this](std::vector<std::uint8_t>& command) {
            finish();
            m_record.emplace();
            m_record->number = ++m_number;
            m_record->sent = m_bus.now;
            m_record->baud = m_bus.hostBaud;
            m_record->command = command;
        };
        bus.losesByte = [this](std::uint8_t byte) {
            if (m_record)
                m_record->reply.push_back(byte);
            return false;
        };
    }

    const PacketLog& log() {
        finish();
        return m_log;
    }

private:
    void finish() {
        if (!m_record)
            return;
        m_record->ended = m_bus.now;
        m_log.append(*std::exchange(m_record, std::nullopt));
    }

    VirtualBus& m_bus;
    PacketLog m_log;
    std::optional<bus::ExchangeRecord> m_record;
    std::uint64_t m_number = 0;
};

/// A session with a bit of everything: finding the chain, gains, a move, polls, a stop.
void runSession(VirtualBus& bus) {
    ASSERT_TRUE(bus.connect());
    servo::LoadTrajectory load;
    load.position = Counts(2'000);
    load.velocity = CountsPerTick(8 << 16);
    load.acceleration = CountsPerTickSquared(1'311);
    const ModuleIndex one(1);
    ASSERT_EQ(
        bus.perform(
            {{one, ServoCommand(servo::SetGain{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{0}})},
             {one, ServoCommand(servo::StopMotor{true, servo::StopManner::Abruptly, {}})},
             {one, ServoCommand(load)},
             {one, ServoCommand(StartMotion{})}}),
        bus::Outcome::Done);
    bus.runFor(std::chrono::seconds(2));
    ASSERT_NEAR(bus.servo(1).position, 2'000, 5);
    ASSERT_TRUE(bus.stopAll().has_value());
}

TEST(PacketReplay, ASavedSessionGetsTheSameRepliesFromAFreshChain) {
    const auto modules = test::servos(3);
    bus::EngineConfig config;
    config.baud = 115'200;
    VirtualBus bus(modules, config);
    Tap tap(bus);
    ASSERT_NO_FATAL_FAILURE(runSession(bus));

    const auto file = parsePacketFile(writePacketFile(tap.log()));
    ASSERT_TRUE(file.has_value()) << file.error();
    ASSERT_GT(file->entries.size(), 500U);
    sim::Chain fresh(modules);
    const auto replies = test::replay(*file, fresh);
    std::size_t answered = 0;
    for (std::size_t i = 0; i < replies.size(); ++i) {
        EXPECT_EQ(toHex(replies[i]), toHex(file->entries[i].record.reply))
            << "exchange " << i + 1 << ": " << toHex(file->entries[i].record.command);
        answered += replies[i].empty() ? 0U : 1U;
    }
    EXPECT_GT(answered, 500U);
    EXPECT_NEAR(fresh.snapshot(ModuleIndex(1), bus.now).servo.position, 2'000, 5);
}

TEST(PacketReplay, WhatTheEngineRecordsIsEverythingAndCanBeReplayed) {
    const auto modules = test::servos(3);
    bus::EngineConfig config;
    config.baud = 115'200;
    VirtualBus bus(modules, config);
    bus.engine.setRecording(true);
    ASSERT_NO_FATAL_FAILURE(runSession(bus));
    PacketLog log;
    log.begin({"test", "2025-06-01T12:00:00.000Z", "simulator", true, TimePoint{}});
    std::string recorded;
    for (bus::ExchangeRecord& record : bus.engine.takeRecords()) {
        recorded += toHex(record.command) + ' ';
        log.append(std::move(record));
    }
    std::string sent;
    for (const VirtualBus::Sent& send : bus.sent)
        sent += send.hex() + ' ';
    // The last exchange may still be in progress.
    EXPECT_EQ(recorded, sent.substr(0, recorded.size())) << "every byte that was sent is in one record";
    EXPECT_LT(sent.size() - recorded.size(), 3 * kMaxPacket);
    const auto file = parsePacketFile(writePacketFile(log));
    ASSERT_TRUE(file.has_value()) << file.error();
    sim::Chain fresh(modules);
    const auto replies = test::replay(*file, fresh);
    for (std::size_t i = 0; i < replies.size(); ++i) {
        EXPECT_FALSE(file->entries[i].afterGap);
        // An exchange that was overtaken by a stop was cut short, and some expect no reply.
        const bus::ExchangeRecord& record = file->entries[i].record;
        if (record.end != bus::ReplyResult::Abandoned && record.end != bus::ReplyResult::NotAsked) {
            EXPECT_EQ(toHex(replies[i]), toHex(record.reply)) << "exchange " << i + 1;
        }
    }
}

}  // namespace
}  // namespace nmc
