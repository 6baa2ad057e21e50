// SPDX-License-Identifier: GPL-3.0-or-later
// The program's main job: find a chain, set gains, enable, go to a position, hold to move, and stop with Esc;
// and what it reports if there is no chain, or another one.
#include "tests/support/virtualpanel.h"
#include "widgets/panels/holdbutton.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace std::chrono_literals;

class FirstLight : public testing::Test {
protected:
    void connectTo(const VirtualChain& chain, std::size_t modules) {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(chain.terminal()));
        ASSERT_EQ(panel.composition().store().link().modules.size(), modules);
    }
    /// Clicks the mark itself: a check box as wide as its row does not react everywhere.
    void tick(const char* box) { testing_support::clickOn(panel.find<QAbstractButton>(box)); }
    bool says(const char* label, const char* words) {
        return panel.waitFor([&] { return panel.find<QLabel>(label).text().contains(QLatin1String(words)); });
    }

    VirtualChain sim{QStringLiteral("servo,servo,servo@1"), QStringLiteral("simulator=servo,servo,servo@1")};
    VirtualChain two{QStringLiteral("servo,servo")};
    VirtualPanel panel;
};

/// Moves 20 000 counts at 8 counts/tick and 0.02 counts/tick^2, and then back, until Esc stops it on the way.
TEST_F(FirstLight, AMotorMovesAndItsTraceIsHonest) {
    ASSERT_NO_FATAL_FAILURE(connectTo(sim, 3));
    EXPECT_EQ(panel.module(2).info.identity.version, 1);
    EXPECT_TRUE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    ASSERT_NO_FATAL_FAILURE(panel.makeReady(1));
    ASSERT_NO_FATAL_FAILURE(panel.goTo(20'000));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::AtSpeed; }));
    ASSERT_TRUE(panel.waitFor([&] {
        return !panel.module(1).moving() && std::abs(*panel.module(1).latest->position - 20'000) <= 5;
    }));
    ASSERT_NO_FATAL_FAILURE(panel.goTo(0));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::AtSpeed; }));
    QTest::keyClick(&panel.find<QLineEdit>("goalField"), Qt::Key_Escape);
    ASSERT_TRUE(says("stopResultLabel", "stopped and holding"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::Holding; }));
    EXPECT_GT(*panel.module(1).latest->position, 1'000);

    double highest = 0;
    int all = 0;
    int small = 0;
    double worst = 0;
    const ModuleHistory& history = *panel.composition().store().history().module(ModuleIndex(1));
    for (const ScopeSample& sample : history.samples(TimePoint::min(), TimePoint::max())) {
        highest = std::max(highest, static_cast<double>(sample.position));
        if (!sample.errorKnown())
            continue;
        const double error = std::abs(static_cast<double>(sample.error));
        ++all;
        small += error < 60 ? 1 : 0;
        worst = std::max(worst, error);
    }
    EXPECT_NEAR(highest, 20'000, 50);
    // The lag is 25 counts at 8 counts/tick, and the time of a sample is uncertain by half a tick, which is
    // another 4 counts.
    EXPECT_GT(all, 100);
    EXPECT_EQ(small, all);
    EXPECT_GT(worst, 5);
}

TEST_F(FirstLight, TheSimulatorDockSetsTheBenchWhileItRuns) {
    ASSERT_NO_FATAL_FAILURE(connectTo(sim, 3));
    panel.select(1);
    ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>("sim_servo_powerBox").isChecked(); }))
        << "initially, the motor has power";
    tick("sim_servo_limit1Box");
    EXPECT_TRUE(panel.waitFor([&] { return panel.module(1).latest->servoStatus().limit1(); }));
    EXPECT_TRUE(says("bit_limit1", "on"));
    EXPECT_FALSE(panel.module(0).latest->servoStatus().limit1());
    tick("sim_servo_powerBox");
    EXPECT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::NoPower; }));
    EXPECT_TRUE(says("simAnswerHead", "Done: set 2 power 0"));
    EXPECT_NE(panel.module(0).activity(), Activity::NoPower);
}

TEST_F(FirstLight, HoldToMoveMovesOnlyWhileItIsHeld) {
    ASSERT_NO_FATAL_FAILURE(connectTo(two, 2));
    ASSERT_NO_FATAL_FAILURE(panel.makeReady(1));
    auto& button = panel.find<QAbstractButton>("holdForwardButton");
    QTest::mousePress(&button, Qt::LeftButton);
    // One press alone lasts for 250 ms, which at 0.25 counts/tick is 122 counts: the window must have
    // re-armed it.
    EXPECT_TRUE(panel.waitFor([&] { return *panel.module(1).latest->position > 200; }));
    QTest::mouseRelease(&button, Qt::LeftButton);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::Holding; }));
    EXPECT_EQ(two.violations(), "");
}

TEST_F(FirstLight, AHoldThatEndedInAStallIsOverUntilTheButtonWasUp) {
    ASSERT_NO_FATAL_FAILURE(connectTo(two, 2));
    ASSERT_NO_FATAL_FAILURE(panel.makeReady(0));
    auto& button = panel.find<HoldButton>("holdForwardButton");
    QTest::mousePress(&button, Qt::LeftButton);
    ASSERT_TRUE(panel.waitFor([&] { return two.driven(0); }));
    // The bus ends the hold after 250 ms, while the button is still down.
    panel.freeze(500ms);
    EXPECT_FALSE(two.driven(0));
    ASSERT_TRUE(panel.waitFor([&] { return !button.isHeld(); })) << "it shows that it is no longer held";
    EXPECT_FALSE(button.isDown());
    const TimePoint until = panel.module(0).latestTime + 1s;
    bool movedAgain = false;
    ASSERT_TRUE(panel.waitFor([&] {
        movedAgain = movedAgain || two.driven(0);
        return panel.module(0).latestTime >= until;
    }));
    EXPECT_FALSE(movedAgain);
    QTest::mouseRelease(&button, Qt::LeftButton);
    QTest::mousePress(&button, Qt::LeftButton);
    EXPECT_TRUE(panel.waitFor([&] { return two.driven(0); })) << "it was pressed again";
    QTest::mouseRelease(&button, Qt::LeftButton);
    EXPECT_TRUE(panel.waitFor([&] { return !two.driven(0); }));
}

TEST_F(FirstLight, AClosedTerminalIsSaidAndConnectingIsOneClickAway) {
    ASSERT_NO_FATAL_FAILURE(connectTo(two, 2));
    two.unplug();
    ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>("connectButton").isEnabled(); }));
    EXPECT_TRUE(panel.find<QLabel>("bannerHeadline").text().contains(two.terminal()));
    EXPECT_TRUE(panel.composition().store().link().modules.empty());
}

TEST(FirstLightAgain, AChainThatHasBecomeShorterIsSaid) {
    std::optional<VirtualChain> sim;
    VirtualPanel panel;
    for (const int modules : {3, 2}) {
        sim.emplace(QStringList(modules, QStringLiteral("servo")).join(QLatin1Char(',')),
                    QStringLiteral("/dev/ttyUSB0"));
        panel.composition().show({sim->terminal(), 115'200, false});
        const auto& found = panel.composition().store().link().modules;
        ASSERT_TRUE(panel.waitFor(
            [&] { return panel.connected() && found.size() == static_cast<std::size_t>(modules); }));
        panel.click("disconnectButton");
        ASSERT_TRUE(panel.waitFor([&] { return found.empty() && !sim->open(); }));
    }
    const QString headline = panel.window().findChild<QLabel*>(QStringLiteral("bannerHeadline"))->text();
    EXPECT_TRUE(headline.contains(QLatin1String("2 of 3 modules answered"))) << headline.toStdString();
}

TEST_F(FirstLight, NobodyAnsweringIsSaidAndTheSimulatorIsOneClickAway) {
    VirtualChain builtIn(QStringLiteral("servo,servo,step"), QStringLiteral("simulator"));
    two.tell("fault bus silent");
    VirtualPanel other;
    other.composition().show({two.terminal(), 19'200, false});
    ASSERT_TRUE(other.waitFor([&] { return other.standing(QStringLiteral("no module answered")); }));
    const auto button = [&other](const char* name) {
        return other.window().findChild<QAbstractButton*>(QLatin1String(name));
    };
    EXPECT_TRUE(button("bannerAction_scanAgain")->isEnabled());
    QTest::mouseClick(button("bannerAction_useSimulator"), Qt::LeftButton);
    EXPECT_TRUE(other.waitFor(
        [&] { return other.connected() && other.composition().store().link().modules.size() == 3; }));
}

}  // namespace
}  // namespace nmc
