// SPDX-License-Identifier: GPL-3.0-or-later
// A PIC-I/O, through the window and by object name; the oracle is what the simulator knows about its pins.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::clickOn;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class IoModulePage : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal())); }
    void makeOutput(const char* direction) {
        auto& box = panel.find<QComboBox>(direction);
        ASSERT_TRUE(panel.waitFor([&] { return box.isEnabled(); }));
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_Down);
        ASSERT_TRUE(panel.waitFor([&] { return box.currentIndex() == 1 && box.isEnabled(); })) << direction;
    }
    void strike(const char* name) {
        auto& box = panel.find<QCheckBox>(name);
        ASSERT_TRUE(panel.waitFor([&] { return box.isEnabled(); })) << name;
        clickOn(box);
    }
    [[nodiscard]] bool reads(const char* label, const QString& words) {
        return panel.waitFor([&] { return panel.find<QLabel>(label).text() == words; });
    }

    VirtualChain sim{QStringLiteral("io")};
    VirtualPanel panel;
};

TEST_F(IoModulePage, StopAllTakesLowWhatTheMachineWantsLowAndLeavesTheRest) {
    for (const char* direction : {"pin1Direction", "pin2Direction"})
        ASSERT_NO_FATAL_FAILURE(makeOutput(direction));
    ASSERT_NO_FATAL_FAILURE(strike("pin1Box"));
    ASSERT_TRUE(reads("pin1Level", QStringLiteral("high")));
    ASSERT_NO_FATAL_FAILURE(strike("pin2Box"));
    ASSERT_TRUE(reads("pin2Level", QStringLiteral("high")));
    ASSERT_NO_FATAL_FAILURE(strike("pin1OffAtStop"));
    ASSERT_TRUE(panel.answersFor(0.2));  // until the bus thread has it
    EXPECT_EQ(sim.violations(), "");     // a stop overtakes what is in progress
    panel.click("stopAllButton");
    EXPECT_TRUE(reads("pin1Level", QStringLiteral("low")));
    EXPECT_TRUE(panel.answersFor(0.2));
    EXPECT_TRUE(reads("pin2Level", QStringLiteral("high")));
}

/// The stop is sent and confirmed before the window hears of the chain.
TEST_F(IoModulePage, AStopOfALostLineTakesItLowWhileTheWindowIsBusy) {
    const auto high = [this] { return sim.state(1)[QStringLiteral("pins")].toArray()[0].toBool(); };
    ASSERT_NO_FATAL_FAILURE(makeOutput("pin1Direction"));
    ASSERT_NO_FATAL_FAILURE(strike("pin1Box"));
    ASSERT_TRUE(reads("pin1Level", QStringLiteral("high")));
    ASSERT_NO_FATAL_FAILURE(strike("pin1OffAtStop"));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    panel.pressEsc();
    ASSERT_TRUE(high());
    sim.plugIn();
    emit panel.window().connectRequested(sim.terminal(), 115'200, false);
    panel.freeze(std::chrono::seconds(3));
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    EXPECT_TRUE(panel.waitFor([&] { return !high(); }));
}

TEST_F(IoModulePage, WhatItsInputsReadIsShown) {
    EXPECT_TRUE(sim.control(QStringLiteral("set 1 in 5 1")).contains(QStringLiteral("ok")));
    EXPECT_TRUE(reads("pin5Level", QStringLiteral("high")));
    EXPECT_TRUE(sim.control(QStringLiteral("set 1 analog 2 255")).contains(QStringLiteral("ok")));
    EXPECT_TRUE(reads("analog2Value", QStringLiteral("5 V (255 of 255)")));
}

}  // namespace
}  // namespace nmc
