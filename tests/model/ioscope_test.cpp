// SPDX-License-Identifier: GPL-3.0-or-later
// The status replies of a PIC-I/O as the scope keeps them: samples, spans and recordings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/recording/widerecording.h"
#include "model/scope/derivedsignals.h"
#include "model/scope/scopefeed.h"
#include "recordings.h"
#include "servofixture.h"

namespace nmc {
namespace {

using testing::HasSubstr;
using testing_support::atSeconds;
using testing_support::readRecording;

constexpr ModuleIndex kBox(0);

struct Reply {
    double seconds = 0;
    std::uint16_t pins = 0;
    std::optional<std::array<std::uint8_t, 3>> analogs{};
    std::optional<std::uint32_t> counter{};
};

bus::Sample asSample(const Reply& reply) {
    StatusReport report;
    report.pins = reply.pins;
    for (std::size_t i = 0; reply.analogs && i < 3; ++i)
        report.analogs.at(i) = reply.analogs->at(i);
    report.counter = reply.counter;
    return {kBox, atSeconds(reply.seconds), report};
}

ScopeSample taken(ScopeFeed& feed, const Reply& reply) {
    const auto made = feed.take(asSample(reply));
    EXPECT_TRUE(made.has_value());
    return made.value_or(ScopeSample{});
}

bool pin(const ScopeSample& sample, unsigned number) {
    const auto bit = static_cast<std::uint8_t>((number - 1) % 8);
    return isSet(sample, {number > 8 ? ScopeBit::Byte::Aux : ScopeBit::Byte::Status, bit});
}

TEST(IoScope, AReplyIsASampleOfPinsValuesAndCounter) {
    ScopeFeed feed;
    const ScopeSample sample = taken(feed, {1, 0x0A05, {{10, 20, 255}}, 4'000'000'000});
    for (unsigned number = 1; number <= 12; ++number)
        EXPECT_EQ(pin(sample, number), number == 1 || number == 3 || number == 10 || number == 12) << number;
    EXPECT_EQ(valueOf(sample, ScopeSignal::Analog), 10);
    EXPECT_EQ(valueOf(sample, ScopeSignal::Analog2), 20);
    EXPECT_EQ(valueOf(sample, ScopeSignal::Analog3), 255);
    EXPECT_EQ(valueOf(sample, ScopeSignal::Counter), 4'000'000'000.0);
    EXPECT_EQ(valueOf(sample, ScopeSignal::CountRate), std::nullopt);
}

TEST(IoScope, WhatAReplyDoesNotHaveStandsAsItWas) {
    ScopeFeed feed;
    EXPECT_TRUE(taken(feed, {1, 0x0001, {{10, 20, 30}}, 7}).counted);
    const ScopeSample brief = taken(feed, {1.01, 0x0002});
    EXPECT_FALSE(brief.counted);
    EXPECT_FALSE(brief.gapBefore);
    EXPECT_TRUE(pin(brief, 2));
    EXPECT_EQ(valueOf(brief, ScopeSignal::Analog2), 20);
    EXPECT_EQ(valueOf(brief, ScopeSignal::Counter), 7);
    EXPECT_TRUE(taken(feed, {2, 0x0002}).gapBefore) << "a hundred usual intervals later";
}

/// At 2^31 a signed number would become negative; the counter simply counts on.
TEST(IoScope, CountsBeyondTheMiddleOfTheirRangeKeepTheirOrder) {
    ScopeFeed feed;
    ModuleHistory history;
    for (int i = 0; i < 16; ++i)
        history.append(taken(feed, {1 + i * 0.01, 0, {}, 0x7FFF'FFF8U + static_cast<unsigned>(i)}));
    std::vector<ScopeSpan::Extremes> seen;
    history.visit(atSeconds(0), atSeconds(10), std::chrono::seconds(1),
                  [&](const ScopeSpan& span) { seen.push_back(span.extremes(ScopeSignal::Counter)); });
    ASSERT_EQ(seen.size(), 1U) << "all of them in one span";
    EXPECT_EQ(seen[0].low, 2'147'483'640.0);
    EXPECT_EQ(seen[0].high, 2'147'483'655.0);
    EXPECT_TRUE(seen[0].lowFirst);
}

std::vector<ScopeSample> rateOf(const std::vector<Reply>& replies) {
    ScopeFeed feed;
    History history(1);
    for (const Reply& reply : replies)
        history.append(kBox, taken(feed, reply));
    DerivedSignals signals;
    signals.want({{kBox, ScopeSignal::CountRate}});
    EXPECT_TRUE(signals.follow(history));
    return signals.source(history, {kBox, ScopeSignal::CountRate})
        .samples->samples(TimePoint::min(), TimePoint::max());
}

/// 5 counts in 10 ms, contained in every second reply, across the wrap at 32 bits.
TEST(IoScope, TheRateIsThatOfTheCountsAndNotOfTheReplies) {
    std::vector<Reply> replies;
    for (int i = 0; i < 60; ++i) {
        Reply& reply = replies.emplace_back(Reply{1 + i * 0.01});
        if (i % 2 == 0)
            reply.counter = 0xFFFF'FFC0U + static_cast<unsigned>(5 * i);
    }
    const auto rates = rateOf(replies);
    ASSERT_EQ(rates.size(), 25U) << "from 100 ms on, of 30 replies with a count";
    for (const ScopeSample& rate : rates)
        EXPECT_NEAR(rate.error, 500, 0.01);
}

TEST(IoScope, ACounterThatWasClearedHasNoRateAcrossThat) {
    std::vector<Reply> replies;
    for (int i = 0; i < 40; ++i)
        replies.push_back(
            {1 + i * 0.02, 0, {}, static_cast<std::uint32_t>(i < 20 ? 1'000'000 + 10 * i : 10 * i)});
    const auto rates = rateOf(replies);
    EXPECT_GT(rates.size(), 25U) << "from 100 ms on, before and after it";
    for (const ScopeSample& rate : rates)
        EXPECT_NEAR(rate.error, 500, 0.01) << toSeconds(rate.time - TimePoint{});
}

RecordingHeader ioHeader() {
    RecordingHeader head = testing_support::recordingHeader();
    PinSettings pins;
    PinSettings::in(pins.pins, 2).name = "Door";
    PinSettings::in(pins.analog, 0).scale = {0.5, 0, "V"};
    PinSettings::in(pins.analog, 1) = {"Pressure", {0.5, -10, "bar"}};
    PinSettings::in(pins.analog, 2).scale = {0.25, 0, "V"};
    head.modules = {{kBox, {ModuleType::Io, 1}, "Box", {}, {0.5, 0, "V"}, pins}};
    return head;
}

ScopeSample oneSample() {
    ScopeFeed feed;
    ScopeSample sample = taken(feed, {0.5, 0x0A05, {{10, 20, 30}}, 0xFFFF'FFFEU});
    sample.gapBefore = false;
    return sample;
}

TEST(IoScope, IsRecordedAndReadAgain) {
    std::string row;
    appendRow(row, kBox, oneSample(), TimePoint{});
    EXPECT_EQ(row, "1,0.500000000,-2,,,,,,10,5,10,0,20,30,1\n");
    const auto read = readRecording(recordingHead(ioHeader()) + row);
    EXPECT_FALSE(read.problem.has_value());
    ASSERT_EQ(read.samples.size(), 1U);
    const ScopeSample& sample = read.samples[0].second;
    EXPECT_TRUE(sample.io);
    EXPECT_TRUE(sample.counted);
    EXPECT_EQ(sample.counter(), 0xFFFF'FFFEU);
    EXPECT_EQ(valueOf(sample, ScopeSignal::Analog3), 30);
    EXPECT_EQ(read.header.modules, ioHeader().modules);
    std::string again;
    appendRow(again, kBox, sample, TimePoint{});
    EXPECT_EQ(again, row);
}

TEST(IoScope, AValueThatIsNoByteIsRefused) {
    const auto read = readRecording(recordingHead(ioHeader()) + "1,0.5,-2,,,,,,10,5,10,0,256,30,1\n");
    ASSERT_TRUE(read.problem.has_value());
    EXPECT_EQ(read.problem->kind, RecordingProblem::Kind::OutOfRange);
    EXPECT_EQ(read.problem->field, "analog2");
}

/// A recording that was written before PIC-I/O modules were supported.
TEST(IoScope, ARecordingWithoutItsColumnsOpens) {
    const auto read = readRecording(
        "# NMC Panel recording 1\n"
        "module,time_s,position,velocity_per_s,command,error,error_low,error_high,analog,status,aux,gap\n"
        "1,0.5,1024,,1024.5,0.5,0,1,17,9,4,0\n");
    EXPECT_FALSE(read.problem.has_value());
    ASSERT_EQ(read.samples.size(), 1U);
    EXPECT_FALSE(read.samples[0].second.io);
    EXPECT_EQ(read.samples[0].second.position, 1'024);
    EXPECT_EQ(read.samples[0].second.error, 0.5F);
}

/// 20 x 0.5 bar - 10 bar; IO1, IO3, IO10 and IO12 are 1 + 4 + 512 + 2048.
TEST(IoScope, AWideRecordingHasTheMachinesNamesAndUnits) {
    History history(1);
    history.append(kBox, oneSample());
    const std::string text = wideRecordingOf(ioHeader(), history);
    EXPECT_EQ(text,
              "time_s,module1_Box/AD1_V,module1_Box/Pressure_bar,module1_Box/AD3_V,module1_Box/count,"
              "module1_Box/count_rate_per_s,module1_Box/pins_IO3_Door,about/program_NMC_Panel_0.6.0,"
              "about/started_2026-11-21T21:21:02.123+01:00,about/port_simulator,"
              "about/simulated_yes_(no_real_motor_moved)\n"
              "0.500000000,5,0,7.5,4294967294,,2565,,,,\n");
}

}  // namespace
}  // namespace nmc
