// SPDX-License-Identifier: GPL-3.0-or-later
// One signal over another, compared with closed forms.
#include "model/scope/xycurve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nmc {
namespace {

/// A circle of radius 100 once a second: x every 5 ms, and y between its samples. A chord of 5 ms deviates
/// from the circle by 100 (1 - cos(pi 0.005)) = 0.012.
TEST(XyCurve, TwoSinesMakeACircle) {
    std::vector<SignalPoint> x, y;
    for (int i = 0; i <= 400; ++i) {
        const double at = i * 0.005;
        x.push_back({at, 100 * std::cos(2 * M_PI * at), i > 0});
        const double between = at + 0.002;
        y.push_back({between, 100 * std::sin(2 * M_PI * between), i > 0});
    }
    const auto curve = xyCurve(x, y);
    ASSERT_EQ(curve.size(), 400U) << "no x follows the last y";
    for (std::size_t i = 0; i < curve.size(); ++i) {
        EXPECT_NEAR(std::hypot(curve[i].x, curve[i].y), 100, 0.013) << i;
        EXPECT_EQ(curve[i].joined, i > 0) << i;
    }
}

TEST(XyCurve, TakesSamplesAtTheSameTimeAsTheyAre) {
    const std::vector<SignalPoint> x{{0, 1, false}, {1, 2, true}};
    const std::vector<SignalPoint> y{{0, 10, false}, {1, 20, true}};
    EXPECT_EQ(xyCurve(x, y), (std::vector<XyPoint>{{1, 10, false}, {2, 20, true}}));
}

/// x is missing between 1 and 2 s: nothing is known at 1.5 s, and the line does not cross the gap.
TEST(XyCurve, HasAGapWhereEitherSignalHasOne) {
    const std::vector<SignalPoint> x{{0, 0, false}, {1, 1, true}, {2, 2, false}, {3, 3, true}};
    const std::vector<SignalPoint> y{{0.5, 5, false}, {1.5, 15, true}, {2.5, 25, true}, {2.75, 27, false}};
    EXPECT_EQ(xyCurve(x, y), (std::vector<XyPoint>{{0.5, 5, false}, {2.5, 25, false}, {2.75, 27, false}}));
    const std::vector<SignalPoint> rare{{0.25, 2, false}, {2.5, 25, true}};
    EXPECT_EQ(xyCurve(x, rare), (std::vector<XyPoint>{{0.25, 2, false}, {2.5, 25, false}}))
        << "the gap of x lies between two points of y";
}

TEST(XyCurve, OfNothingIsNothing) {
    EXPECT_TRUE(xyCurve({}, {{0, 1, false}}).empty());
    EXPECT_TRUE(xyCurve({{0, 1, false}}, {}).empty());
}

}  // namespace
}  // namespace nmc
