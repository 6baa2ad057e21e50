// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/packets/packetlog.h"

#include <gtest/gtest.h>

#include "packetrecords.h"

namespace nmc {
namespace {

using namespace testing_support;
using bus::Purpose;
using bus::ReplyResult;

TEST(PacketLog, LetsTheOldestGoAndCountsThem) {
    PacketLog log(3);
    for (std::uint64_t i = 1; i <= 5; ++i)
        log.append(pollRecord(i));
    EXPECT_EQ(log.size(), 3U);
    EXPECT_EQ(log.dropped(), 2U);
    EXPECT_EQ(log.first(), 2U);
    EXPECT_EQ(log.end(), 5U);
    EXPECT_EQ(log.at(2).record.number, 3U);
    EXPECT_EQ(log.at(4).record.number, 5U);
}

TEST(PacketLog, IsBoundedInBytesToo) {
    // 5 and 8 bytes each: three make 39.
    PacketLog log(1'000, 40);
    for (std::uint64_t i = 1; i <= 10; ++i)
        log.append(pollRecord(i));
    EXPECT_EQ(log.size(), 3U);
    EXPECT_EQ(log.dropped(), 7U);
}

TEST(PacketLog, CutsWhatNoModuleCouldSend) {
    PacketLog log;
    bus::ExchangeRecord noise = resetRecord(1);
    noise.reply.assign(1'000'000, 0x55);
    log.append(noise);
    EXPECT_EQ(log.at(log.first()).record.reply.size(), 4'096U);
}

TEST(PacketLog, MarksWhatIsMissing) {
    PacketLog log;
    for (const std::uint64_t number : {1U, 2U, 5U, 6U})
        log.append(pollRecord(number));
    log.interrupt();
    log.append(pollRecord(7));
    log.append(pollRecord(8));
    std::vector<bool> gaps;
    for (std::uint64_t i = log.first(); i < log.end(); ++i)
        gaps.push_back(log.at(i).afterGap);
    EXPECT_EQ(gaps, (std::vector<bool>{false, false, true, false, true, false}));
}

TEST(PacketLog, AnotherConnectionBeginsEmpty) {
    PacketLog log(2);
    for (std::uint64_t i = 1; i <= 3; ++i)
        log.append(pollRecord(i));
    PacketSession session;
    session.simulated = true;
    log.begin(session);
    EXPECT_TRUE(log.empty());
    EXPECT_EQ(log.dropped(), 0U);
    EXPECT_TRUE(log.session().simulated);
    log.append(pollRecord(1));
    EXPECT_FALSE(log.at(log.first()).afterGap);
}

TEST(PacketFilter, SortsExchangesByWhatTheyAreFor) {
    EXPECT_EQ(kindOf(Purpose::Poll), PacketKind::Poll);
    for (const Purpose purpose : {Purpose::Operation, Purpose::Check, Purpose::Hold})
        EXPECT_EQ(kindOf(purpose), PacketKind::Command);
    EXPECT_EQ(kindOf(Purpose::Stop), PacketKind::Stop);
    for (const Purpose purpose : {Purpose::Connect, Purpose::Challenge, Purpose::Flush})
        EXPECT_EQ(kindOf(purpose), PacketKind::Link);
}

TEST(PacketFilter, PassesAModuleAKindOrErrors) {
    const auto poll = pollRecord(1, 0, 1);
    const auto stop = with(pollRecord(2), Purpose::Stop, ReplyResult::Unresponsive);
    EXPECT_TRUE(PacketFilter{}.passes(poll));
    PacketFilter module;
    module.module = ModuleIndex(1);
    EXPECT_TRUE(module.passes(poll));
    EXPECT_FALSE(module.passes(stop));
    EXPECT_FALSE(module.passes(resetRecord(3)));
    PacketFilter kind;
    kind.kind = PacketKind::Stop;
    EXPECT_FALSE(kind.passes(poll));
    EXPECT_TRUE(kind.passes(stop));
    PacketFilter errors;
    errors.onlyErrors = true;
    EXPECT_FALSE(errors.passes(poll));
    EXPECT_TRUE(errors.passes(stop));
}

TEST(PacketFilter, AStopThatOvertookAndAnExpectedSilenceAreNoErrors) {
    EXPECT_FALSE(wentWrong(with(pollRecord(1), Purpose::Poll, ReplyResult::Abandoned)));
    EXPECT_FALSE(wentWrong(resetRecord(1)));
    auto answered = resetRecord(1);
    answered.reply = {0x00};
    EXPECT_TRUE(wentWrong(answered));
    for (const ReplyResult end : {ReplyResult::Refused, ReplyResult::Unresponsive, ReplyResult::Partial,
                                  ReplyResult::BadChecksum, ReplyResult::Rejected})
        EXPECT_TRUE(wentWrong(with(pollRecord(1), Purpose::Poll, end)));
}

TEST(PacketText, IsOneLineForPeople) {
    EXPECT_EQ(packetLine(pollRecord(1, 12'034'567), TimePoint{}, "accepted"),
              "12.034567 s  module 1  115200 Bd  > AA 01 13 05 19  (Read Status: position, velocity)  "
              "< 09 D2 04 00 00 FE FF DC  (position 1234, velocity 2, move_done power_on)  accepted");
    EXPECT_EQ(packetLine(resetRecord(1), TimePoint{}, "no answer expected"),
              "0.000000 s  group FF  19200 Bd  > AA FF 0F 0E  (Hard Reset)  no answer expected");
}

TEST(PacketText, NamesTheTargetAsFarAsItIsKnown) {
    auto record = resetRecord(1);
    record.command = {0xAA, 0x00, 0x21, 0x01, 0xFF, 0x21};
    EXPECT_EQ(packetTarget(record), "address 0");
    record.command.assign(16, 0);
    EXPECT_EQ(packetTarget(record), "-");
    record.module = ModuleIndex(4);
    EXPECT_EQ(packetTarget(record), "module 5");
}

TEST(PacketText, DoesNotReadMeaningIntoBytesNobodyAskedFor) {
    auto record = resetRecord(1);
    EXPECT_EQ(packetReplyMeaning(record), "");
    record.reply = {0x09, 0x09};
    EXPECT_EQ(packetReplyMeaning(record), "2 bytes");
}

TEST(PacketText, CountsTimeFromWhereItIsTold) {
    const TimePoint zero{std::chrono::seconds(10)};
    EXPECT_EQ(packetTime(zero + std::chrono::microseconds(5), zero), "0.000005");
    EXPECT_EQ(packetTime(zero - std::chrono::milliseconds(1'500), zero), "-1.500000");
}

}  // namespace
}  // namespace nmc
