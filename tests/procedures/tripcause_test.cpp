// SPDX-License-Identifier: GPL-3.0-or-later
// What a trip is attributed to, on motors that trip for a reason known to the simulator.
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Input = sim::Input;

class ATrip : public testing::Test {
protected:
    [[nodiscard]] bool trips() {
        return bench.bus.runUntil(
            [&] {
                bench.take();
                return bench.module().switchedItselfOff;
            },
            30s);
    }
    [[nodiscard]] bool run(std::uint32_t velocity, bool reverse) {
        return bench.perform(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(velocity), CountsPerTickSquared(6'554), reverse}});
    }
    static constexpr std::uint32_t kOnePerTick = 65'536;
    ServoBench bench;
};

TEST_F(ATrip, OfAReversedEncoderIsToldApart) {
    for (const bool reverse : {false, true}) {
        SCOPED_TRACE(reverse);
        ServoBench own;
        ASSERT_TRUE(own.connect());
        own.settle();
        own.fault(sim::FaultKind::Reverse);
        ASSERT_TRUE(own.perform(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 400, 1, std::uint8_t{0}}}));
        ASSERT_TRUE(own.perform(intent::Enable{}));
        ASSERT_TRUE(own.module().servoOn()) << "friction holds it";
        std::ignore = own.perform(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(kOnePerTick), CountsPerTickSquared(6'554), reverse}});
        own.settle();
        ASSERT_TRUE(own.module().switchedItselfOff);
        EXPECT_EQ(own.module().tripCause, TripCause::Reversed);
    }
}

/// A load of 0.02 N·m pulls it off the count that it holds, and the loop adds to that.
TEST_F(ATrip, OfAReversedEncoderAsSoonAsItIsEnabled) {
    ASSERT_TRUE(bench.connect());
    bench.settle();
    bench.fault(sim::FaultKind::Reverse);
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 400, 1, std::uint8_t{0}}}));
    const auto steps = plan(intent::Enable{}, bench.module());
    ASSERT_TRUE(steps);
    bench.set(Input::Load, 0.02);
    std::ignore = bench.bus.perform(*steps);
    ASSERT_TRUE(trips());
    EXPECT_EQ(bench.module().tripCause, TripCause::Reversed);
}

TEST_F(ATrip, OfAJam) {
    ASSERT_TRUE(bench.enable(400));
    bench.fault(sim::FaultKind::Stall);
    ASSERT_TRUE(run(kOnePerTick, false));
    ASSERT_TRUE(trips());
    EXPECT_EQ(bench.module().tripCause, TripCause::Jam);
}

TEST_F(ATrip, OfAJamOnTheWay) {
    ASSERT_TRUE(bench.enable(400));
    ASSERT_TRUE(run(kOnePerTick, true));
    bench.bus.runFor(2s);
    bench.take();
    bench.fault(sim::FaultKind::Stall);
    ASSERT_TRUE(trips());
    EXPECT_EQ(bench.module().tripCause, TripCause::Jam);
}

TEST_F(ATrip, AtAHardStopBehindALimitSwitch) {
    ASSERT_TRUE(bench.enable(400));
    bench.putSwitch(Input::Limit2, 1'900, false);
    bench.set(Input::TravelMax, 2'000);
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::Trapezoid{Counts(4'000), CountsPerTick(kOnePerTick), CountsPerTickSquared(6'554)}}));
    ASSERT_TRUE(trips());
    EXPECT_EQ(bench.module().tripCause, TripCause::Limit2);
}

/// A quarter of 24 V turns it at 158 rad/s at most, which is 25.7 counts/tick: half of what is commanded.
TEST_F(ATrip, OfAMotorThatCannotKeepUp) {
    ASSERT_TRUE(bench.enable(400));
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{200, 2'000, 20, 200, 64, 0, 400, 1, std::uint8_t{0}}}));
    ASSERT_TRUE(run(50 * kOnePerTick, false));
    ASSERT_TRUE(trips());
    EXPECT_EQ(bench.module().tripCause, TripCause::Behind);
}

TEST_F(ATrip, OfAMotorThatIsTurnedByHandLongAfterIsNotJudged) {
    ASSERT_TRUE(bench.enable(400));
    bench.bus.runFor(5s);
    bench.set(Input::Load, 2.0);
    ASSERT_TRUE(trips());
    EXPECT_EQ(bench.module().tripCause, TripCause::Unknown);
}

}  // namespace
}  // namespace nmc::test
