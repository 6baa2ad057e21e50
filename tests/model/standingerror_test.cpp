// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/standingerror.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using namespace std::chrono_literals;

/// A shaft that rests at 0 between its motions.
struct RestingShaft {
    StandingError error;
    TimePoint now{};

    /// The narrower band that a rest yields for a command position in the band `command`, after a motion that
    /// began in the band `before`.
    std::optional<CommandEstimate> rest(const CommandEstimate& before, const CommandEstimate& command) {
        error.leave(before);
        std::optional<CommandEstimate> narrower;
        for (int look = 0; look < 4; ++look, now += Standstill::kFor)
            if (const auto found = error.look(now, 0, false, command))
                narrower = found;
        return narrower;
    }
};

constexpr CommandEstimate kFirstBand{-2, -2.5, -1.5};

TEST(StandingError, TakesBackWhatAMotionAddsBeyondTheFarthest) {
    RestingShaft shaft;
    EXPECT_FALSE(shaft.rest({-2, -2, -2}, kFirstBand)) << "no rest before to compare with";
    const auto narrower = shaft.rest(kFirstBand, {-2, -3, -1});
    ASSERT_TRUE(narrower);
    EXPECT_DOUBLE_EQ(narrower->low, -2.5);
    EXPECT_DOUBLE_EQ(narrower->high, -1);
}

/// Load and friction may have changed since the shaft deviated most; the motion has added 0.1 in either
/// direction.
TEST(StandingError, KeepsADoubtThatIsNotOfTheMotions) {
    RestingShaft shaft;
    EXPECT_FALSE(shaft.rest({-2, -2, -2}, kFirstBand));
    const auto narrower = shaft.rest({-2, -6, 2}, {-2, -6.1, 2.1});
    ASSERT_TRUE(narrower);
    EXPECT_NEAR(narrower->low, -5.9, 1e-9);
    EXPECT_NEAR(narrower->high, 2.1, 1e-9);
}

}  // namespace
}  // namespace nmc
