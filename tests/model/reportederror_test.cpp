// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the calculated position error with the one that a PIC-SERVO SC reports itself (docs/family.md).
#include <gtest/gtest.h>

#include "model/scope/commandposition.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

struct Tally {
    std::size_t known = 0;
    std::size_t inside = 0;
};

/// The report has whole counts, while the command position has a fraction.
constexpr double kRounding = 1.0;

Tally compare(const std::vector<bus::Event>& events) {
    CommandPosition command;
    Tally tally;
    for (const bus::Event& event : events) {
        if (const auto* executed = std::get_if<bus::CommandExecuted>(&event))
            command.apply(*executed);
        const auto* sample = std::get_if<bus::Sample>(&event);
        if (sample == nullptr)
            continue;
        command.apply(*sample);
        const auto estimate = command.at(sample->time, sample->late);
        if (!estimate || !sample->report.position || !sample->report.positionError)
            continue;
        const double reported = *sample->report.position + *sample->report.positionError;
        ++tally.known;
        if (reported >= estimate->low - kRounding && reported <= estimate->high + kRounding)
            ++tally.inside;
    }
    return tally;
}

class ReportedError : public testing::TestWithParam<std::uint32_t> {};

TEST_P(ReportedError, IsWithinTheCalculatedBand) {
    bus::EngineConfig config;
    config.baud = GetParam();
    VirtualBus bus({{ModuleType::Servo, 10}}, config);
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), bus::Outcome::Done);
    for (const std::int32_t goal : {2'000, -3'000, 100, 20'000, 0}) {
        ASSERT_EQ(bus.perform({loadMove(0, goal), start(0)}), bus::Outcome::Done);
        bus.runFor(8s);
    }
    const Tally tally = compare(bus.events);
    EXPECT_GT(tally.known, 2'000U);
    EXPECT_GE(static_cast<double>(tally.inside), 0.999 * static_cast<double>(tally.known))
        << tally.inside << " of " << tally.known;
}
INSTANTIATE_TEST_SUITE_P(Rates, ReportedError, testing::Values(19'200U, 115'200U));

}  // namespace
}  // namespace nmc::test
