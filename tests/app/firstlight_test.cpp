// SPDX-License-Identifier: GPL-3.0-or-later
// The program's main job, through its window and by object name: find a chain, set gains, enable, set out
// for a position, and stop with Esc - on the simulator in this process, and over a pseudo-terminal that
// nmcsim serves.
#include <gtest/gtest.h>

#include "tests/support/panel.h"

namespace nmc {
namespace {

using testing_support::IntentPanel;
using testing_support::NmcsimProcess;

/// Moves the second servo so far, at 8 counts/tick and 0.02 counts/tick^2, that no pause of this computer
/// brings it to its goal, and stops it with Esc. That a motor reaches its goal is tested where no guardian
/// can stop it because this computer gave the panel no time (tests/panel, SerialPath).
void moveAndStop(IntentPanel& panel) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady(1));
    ASSERT_NO_FATAL_FAILURE(panel.goTo(-40'000'000));
    ASSERT_TRUE(panel.waitFor([&] { return *panel.module(1).latest->position < -50; }));
    QTest::keyClick(&panel.find("goalField"), Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] {
        return panel.find<QLabel>("stopResultLabel").text().contains(QLatin1String("stopped and holding"));
    }));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::Holding; }));
    EXPECT_GT(*panel.module(1).latest->position, -39'000'000);
}

TEST(FirstLight, MovesAMotorOfTheBuiltInSimulator) {
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startAt(QStringLiteral("simulator=servo,servo,servo@1")));
    ASSERT_EQ(panel.composition().store().link().modules.size(), 3U);
    EXPECT_EQ(panel.module(2).info.identity.version, 1);
    EXPECT_TRUE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    moveAndStop(panel);
}

TEST(FirstLightOnATerminal, MovesAMotorWithoutAViolation) {
    NmcsimProcess sim(QStringLiteral("servo,servo,servo@1"));
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
    ASSERT_EQ(panel.composition().store().link().modules.size(), 3U);
    EXPECT_TRUE(panel.window().windowTitle().startsWith(QLatin1String("NMC Panel")));
    EXPECT_FALSE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    EXPECT_EQ(panel.count(QStringLiteral("guardian")), 0) << "a guardian that works is not mentioned";
    ASSERT_NO_FATAL_FAILURE(moveAndStop(panel));
    const QJsonObject state = sim.state(2);
    EXPECT_TRUE(state[QStringLiteral("servo_on")].toBool());
    EXPECT_EQ(state[QStringLiteral("gains")].toObject()[QStringLiteral("kd")].toInt(), 2'000);
    EXPECT_FALSE(sim.state(1)[QStringLiteral("servo_on")].toBool());
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc
