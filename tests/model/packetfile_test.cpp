// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/packets/packetfile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "packetrecords.h"
#include "tests/support/packetfilereader.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::StartsWith;

PacketSession simulatedSession() {
    return {"NMC Panel 0.3.0", "2025-06-01T12:00:00.000Z", "simulator", true, TimePoint{}};
}

/// Two exchanges and a gap, written by hand from the format's description.
const std::string kFile =
    "# nmcpanel packet log 1\n"
    "# program NMC Panel 0.3.0\n"
    "# started 2025-06-01T12:00:00.000Z\n"
    "# port simulator\n"
    "# simulated yes\n"
    "# dropped 0\n"
    "# time_us took_us purpose module baud type:items verdict >command <reply\n"
    "#\n"
    "100.000 25000.000 connect - 19200 0:00 not_asked >AAFF0F0E <\n"
    "gap\n"
    "12034567.000 1450.000 poll 1 115200 0:05 rejected:home_changed >AA01130519 <09D204000000FEFFDC\n";

std::string changed(const std::string& from, const std::string& to) {
    std::string text = kFile;
    text.replace(text.find(from), from.size(), to);
    return text;
}

std::string errorOf(const std::string& text) {
    const auto file = parsePacketFile(text);
    return file ? "read without complaint" : file.error();
}

TEST(PacketFile, IsWrittenAsDescribed) {
    PacketLog log;
    log.begin(simulatedSession());
    log.append(resetRecord(1, 100));
    auto poll = pollRecord(9, 12'034'567);
    poll.reply = {0x09, 0xD2, 0x04, 0x00, 0x00, 0x00, 0xFE, 0xFF, 0xDC};
    poll.end = bus::ReplyResult::Rejected;
    poll.rejection = bus::Rejection::HomeChanged;
    log.append(poll);
    EXPECT_EQ(writePacketFile(log), kFile);
}

TEST(PacketFile, IsReadAsDescribed) {
    const auto file = parsePacketFile(kFile);
    ASSERT_TRUE(file.has_value()) << file.error();
    EXPECT_EQ(file->session, simulatedSession());
    ASSERT_EQ(file->entries.size(), 2U);
    const bus::ExchangeRecord& reset = file->entries[0].record;
    EXPECT_EQ(reset.sent, TimePoint(std::chrono::microseconds(100)));
    EXPECT_EQ(reset.ended - reset.sent, std::chrono::milliseconds(25));
    EXPECT_EQ(reset.purpose, bus::Purpose::Connect);
    EXPECT_FALSE(reset.module.has_value());
    EXPECT_EQ(reset.baud, 19'200U);
    EXPECT_EQ(reset.command, (std::vector<std::uint8_t>{0xAA, 0xFF, 0x0F, 0x0E}));
    EXPECT_TRUE(reset.reply.empty());
    const PacketEntry& poll = file->entries[1];
    EXPECT_TRUE(poll.afterGap);
    EXPECT_EQ(poll.record.module, ModuleIndex(0));
    EXPECT_EQ(poll.record.layout, (bus::ReplyLayout{{ModuleType::Servo, 0}, StatusItems(0x05)}));
    EXPECT_EQ(poll.record.end, bus::ReplyResult::Rejected);
    EXPECT_EQ(poll.record.rejection, bus::Rejection::HomeChanged);
    EXPECT_EQ(poll.record.reply.size(), 9U);
}

TEST(PacketFile, SaysWhetherItWasSimulatedAndWhatIsMissing) {
    PacketLog log(1);
    PacketSession session = simulatedSession();
    session.simulated = false;
    log.begin(session);
    log.append(pollRecord(1));
    log.append(pollRecord(2));
    const auto file = parsePacketFile(writePacketFile(log));
    ASSERT_TRUE(file.has_value()) << file.error();
    EXPECT_FALSE(file->session.simulated);
    EXPECT_EQ(file->dropped, 1U);
}

TEST(PacketFile, EveryDamageIsRefusedAndNamesItsLine) {
    EXPECT_EQ(errorOf(""), "The file is empty.");
    EXPECT_EQ(errorOf(changed("log 1", "log 2")), "Line 1: this is not a packet log of this version.");
    EXPECT_EQ(errorOf("\x7F"
                      "ELF\n"),
              "Line 1: this is not a packet log of this version.");
    EXPECT_EQ(errorOf(changed("# program", "# projram")), "Line 2: \"# program …\" is missing.");
    EXPECT_EQ(errorOf(changed("simulated yes", "simulated Yes")), "Line 5: simulated is neither yes nor no.");
    EXPECT_EQ(errorOf(changed("dropped 0", "dropped -1")), "Line 6: dropped is not a number.");
    EXPECT_THAT(errorOf(changed("took_us", "took_ms")), StartsWith("Line 7: "));
    EXPECT_EQ(errorOf(changed("#\n100", "100")), "Line 8: \"#\" is missing.");
    EXPECT_EQ(errorOf(changed(" <\n", "\n")), "Line 9: an exchange has 9 fields, this line has 8.");
    EXPECT_EQ(errorOf(changed("connect - ", "connect  - ")),
              "Line 9: an exchange has 9 fields, this line has 10.");
    EXPECT_EQ(errorOf(changed("100.000 ", "100.00 ")),
              "Line 9: a time is not microseconds with three decimals.");
    EXPECT_EQ(errorOf(changed("100.000 ", "-1.000 ")),
              "Line 9: a time is not microseconds with three decimals.");
    EXPECT_EQ(errorOf(changed("100.000 ", "9999999999999999999.000 ")),
              "Line 9: a time is not microseconds with three decimals.");
    EXPECT_EQ(errorOf(changed("connect", "conect")), "Line 9: the purpose is not known.");
    EXPECT_EQ(errorOf(changed(" 19200", " 19k2")), "Line 9: the rate is not a number.");
    EXPECT_EQ(errorOf(changed(" 0:00", " 000")), "Line 9: the layout of the reply has no colon.");
    EXPECT_EQ(errorOf(changed(" 0:00", " 0:0")),
              "Line 9: the layout of the reply is not a type number and a mask of two hexadecimal digits.");
    EXPECT_EQ(errorOf(changed("not_asked", "notasked")), "Line 9: the verdict is not known.");
    EXPECT_EQ(errorOf(changed("not_asked", "not_asked:uniform")),
              "Line 9: the rule behind the verdict is not known.");
    EXPECT_EQ(errorOf(changed(">AAFF", "AAFF")), "Line 9: the command does not begin with >.");
    EXPECT_EQ(errorOf(changed("gap", "gab")), "Line 10: an exchange has 9 fields, this line has 1.");
    EXPECT_EQ(errorOf(changed("gap", "gap\ngap")), "Line 11: a gap stands between two exchanges.");
    EXPECT_EQ(errorOf(kFile + "gap\n"), "Line 12: a gap stands between two exchanges.");
    EXPECT_EQ(errorOf(changed("poll 1", "poll 0")),
              "Line 11: the module is neither a number from 1 to 255 nor -.");
    EXPECT_EQ(errorOf(changed("home_changed", "home")), "Line 11: the rule behind the verdict is not known.");
    EXPECT_EQ(errorOf(changed("FEFFDC", "FEFFD")), "Line 11: the reply is not hexadecimal.");
    EXPECT_EQ(errorOf(changed("FEFFDC", "FEFFDX")), "Line 11: the reply is not hexadecimal.");
    EXPECT_EQ(errorOf(changed("FEFFDC\n", "FEFFDC\r\n")), "Line 11: the reply is not hexadecimal.");
    EXPECT_EQ(errorOf(kFile.substr(0, kFile.size() - 1)), "Line 11: the file ends within this line.");
    EXPECT_EQ(errorOf(kFile + "\n"), "Line 12: an exchange has 9 fields, this line has 1.");
}

TEST(PacketFile, LimitsWhatItReads) {
    EXPECT_EQ(errorOf(changed("<09D2", "<" + std::string(8'194, '0'))),
              "Line 11: the reply is longer than 4096 bytes.");
    EXPECT_EQ(errorOf(changed("<09D2", "<" + std::string(20'000, '0'))),
              "Line 11: the line is longer than 20000 bytes.");
    EXPECT_EQ(errorOf(std::string((16U << 20U) + 1, '#')), "The file is longer than 16 MiB.");
}

TEST(PacketFile, KeepsAPortsNameOnItsLine) {
    PacketLog log;
    PacketSession session = simulatedSession();
    session.port = "a\nb";
    log.begin(session);
    const auto file = parsePacketFile(writePacketFile(log));
    ASSERT_TRUE(file.has_value()) << file.error();
    EXPECT_EQ(file->session.port, "a?b");
}

bus::ExchangeRecord anyRecord(std::uint64_t number) {
    bus::ExchangeRecord record;
    record.number = number;
    record.sent = TimePoint(Duration(*rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000)));
    record.ended = record.sent + Duration(*rc::gen::inRange<std::int64_t>(0, 1'000'000'000));
    record.purpose = static_cast<bus::Purpose>(*rc::gen::inRange(0, 8));
    record.baud = *rc::gen::arbitrary<std::uint32_t>();
    if (*rc::gen::arbitrary<bool>())
        record.module = ModuleIndex(*rc::gen::inRange<std::uint8_t>(0, 32));
    record.command = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
    record.reply = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
    record.layout = {
        {static_cast<ModuleType>(*rc::gen::arbitrary<std::uint8_t>()), *rc::gen::arbitrary<std::uint8_t>()},
        StatusItems(*rc::gen::arbitrary<std::uint8_t>())};
    record.end = static_cast<bus::ReplyResult>(*rc::gen::inRange(0, 8));
    if (record.end == bus::ReplyResult::Rejected)
        record.rejection = static_cast<bus::Rejection>(*rc::gen::inRange(0, 16));
    return record;
}

RC_GTEST_PROP(PacketFile, WhatIsWrittenIsReadBack, ()) {
    PacketLog log;
    log.begin(simulatedSession());
    const auto count = *rc::gen::inRange<std::uint64_t>(0, 20);
    for (std::uint64_t i = 1; i <= count; ++i) {
        if (*rc::gen::inRange(0, 4) == 0)
            log.interrupt();
        log.append(anyRecord(i));
    }
    const auto file = parsePacketFile(writePacketFile(log));
    RC_ASSERT(file.has_value());
    RC_ASSERT(file->entries.size() == log.size());
    for (std::uint64_t i = 0; i < log.size(); ++i) {
        const PacketEntry& was = log.at(log.first() + i);
        const PacketEntry& is = file->entries[i];
        RC_ASSERT(is.afterGap == was.afterGap);
        RC_ASSERT(is.record.sent == was.record.sent);
        RC_ASSERT(is.record.ended == was.record.ended);
        RC_ASSERT(is.record.purpose == was.record.purpose);
        RC_ASSERT(is.record.baud == was.record.baud);
        RC_ASSERT(is.record.module == was.record.module);
        RC_ASSERT(is.record.command == was.record.command);
        RC_ASSERT(is.record.reply == was.record.reply);
        RC_ASSERT(is.record.layout == was.record.layout);
        RC_ASSERT(is.record.end == was.record.end);
        RC_ASSERT(is.record.rejection == was.record.rejection);
    }
}

RC_GTEST_PROP(PacketFile, AnyOtherByteIsReadOrRefusedButNeverMore, (std::uint8_t byte)) {
    std::string text = kFile;
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = static_cast<char>(byte);
    const auto file = parsePacketFile(text);
    const bool right = file ? file->entries.size() <= 2 : file.error().starts_with("Line ");
    RC_ASSERT(right);
}

}  // namespace
}  // namespace nmc
