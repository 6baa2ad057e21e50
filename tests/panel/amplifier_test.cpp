// SPDX-License-Identifier: GPL-3.0-or-later
// The Amplifier page of an SC, used with mouse and keys; the oracle is what the simulator knows about the
// module.
#include "tests/support/gains.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class AmplifierPage : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal())); }
    void press(const char* name) {
        auto& button = panel.find<QAbstractButton>(name);
        ASSERT_TRUE(panel.waitFor([&] { return button.isEnabled(); })) << button.toolTip().toStdString();
        QTest::mouseClick(&button, Qt::LeftButton, {}, {button.height() / 2, button.height() / 2});
    }
    /// As long as nothing is selected, the first press selects the first option.
    void chooseLimits(int option) {
        auto& box = panel.find<QComboBox>("limitProtectionBox");
        box.setFocus();
        for (int i = box.currentIndex(); i < option; ++i)
            QTest::keyClick(&box, Qt::Key_Down);
        ASSERT_EQ(box.currentIndex(), option);
    }
    [[nodiscard]] QString mark(const char* setting) {
        return panel.find<QLabel>((std::string(setting) + "State").c_str()).toolTip();
    }
    void apply() {
        ASSERT_NO_FATAL_FAILURE(press("applyAmplifierButton"));
        ASSERT_NO_FATAL_FAILURE(press("applyAmplifierQuestionGo"));
        ASSERT_TRUE(panel.waitFor(
            [&] { return panel.find<QLabel>("amplifierState").text().startsWith(u"✓ Applied"_s); }));
    }
    void enableAndRun() {
        panel.ask(intent::ApplyGains{testing_support::kGains});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains && !panel.module().awaited; }));
        panel.ask(intent::Enable{});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn() && !panel.module().awaited; }));
        panel.ask(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}});
        ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    }
    [[nodiscard]] QString headlines() {
        QStringList all;
        for (const QLabel* label : panel.window().findChildren<QLabel*>())
            if (label->isVisible())
                all << label->text();
        return all.join(u'\n');
    }
    VirtualChain sim{u"servo@10"_s};
    VirtualPanel panel;
};

TEST_F(AmplifierPage, AClosedLimitStopsTheMotorAndItIsShownAtRest) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(1));
    ASSERT_NO_FATAL_FAILURE(apply());
    ASSERT_NO_FATAL_FAILURE(enableAndRun());
    (void)sim.control(u"set 1 limit1 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_EQ(panel.module().activity(), Activity::Holding);
    EXPECT_TRUE(panel.waitFor(
        [&] { return headlines().contains(u"Limit switch 1 of module 1 stopped its motor."_s); }));
    // Forward is refused before anything is sent; reverse is not.
    const auto forward = plan(
        intent::Move{servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}},
        panel.module());
    ASSERT_FALSE(forward);
    EXPECT_EQ(forward.error(), Refusal::LimitClosed);
    panel.ask(
        intent::Move{servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), true}});
    EXPECT_TRUE(panel.waitFor([&] { return moves(sim); }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(AmplifierPage, ALimitThatSwitchesOffIsToldAsTheCause) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(2));
    ASSERT_NO_FATAL_FAILURE(apply());
    ASSERT_NO_FATAL_FAILURE(enableAndRun());
    (void)sim.control(u"set 1 limit1 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().switchedItselfOff; }));
    EXPECT_TRUE(panel.waitFor([&] {
        return headlines().contains(u"Limit switch 1 closed, and module 1 switched its motor off."_s);
    }));
}

TEST_F(AmplifierPage, WhatTheLimitInputsDoIsUnknownUntilItIsChosen) {
    ASSERT_NO_FATAL_FAILURE(press("antiphaseBox"));
    const auto& apply = panel.find<QAbstractButton>("applyAmplifierButton");
    EXPECT_FALSE(apply.isEnabled());
    EXPECT_TRUE(apply.toolTip().contains(u"Choose what the limit inputs do."_s))
        << apply.toolTip().toStdString();
    ASSERT_NO_FATAL_FAILURE(chooseLimits(0));
    EXPECT_TRUE(panel.waitFor([&] { return apply.isEnabled(); }));
}

TEST_F(AmplifierPage, EverySettingShowsWhetherItWasSent) {
    for (const char* setting : {"limitProtection", "threePhase", "antiphase", "stepperInput", "fastPath"})
        EXPECT_EQ(mark(setting), u"? unknown"_s) << setting;
    ASSERT_NO_FATAL_FAILURE(press("antiphaseBox"));
    EXPECT_EQ(mark("antiphase"), u"● not sent"_s);
    EXPECT_EQ(mark("threePhase"), u"? unknown"_s);
    ASSERT_NO_FATAL_FAILURE(chooseLimits(1));
    ASSERT_NO_FATAL_FAILURE(apply());
    for (const char* setting : {"limitProtection", "threePhase", "antiphase", "stepperInput", "fastPath"})
        EXPECT_EQ(mark(setting), u"✓ sent"_s) << setting;
}

TEST_F(AmplifierPage, AnEditCanBeUndoneAndReverted) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(1));
    ASSERT_NO_FATAL_FAILURE(apply());
    const auto& threePhase = panel.find<QAbstractButton>("threePhaseBox");
    ASSERT_NO_FATAL_FAILURE(press("threePhaseBox"));
    EXPECT_EQ(mark("threePhase"), u"● not sent"_s);
    ASSERT_NO_FATAL_FAILURE(press("undoAmplifierButton"));
    EXPECT_FALSE(threePhase.isChecked());
    EXPECT_EQ(mark("threePhase"), u"✓ sent"_s);
    ASSERT_NO_FATAL_FAILURE(press("redoAmplifierButton"));
    EXPECT_TRUE(threePhase.isChecked());
    ASSERT_NO_FATAL_FAILURE(press("revertAmplifierButton"));
    EXPECT_FALSE(threePhase.isChecked());
    EXPECT_FALSE(sim.state(1)[u"three_phase"_s].toBool());
}

TEST_F(AmplifierPage, AnEditIsKeptWhileTheModuleReportsOnlyItsStatus) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(2));
    ASSERT_NO_FATAL_FAILURE(press("stepperInputBox"));
    EXPECT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(panel.find<QComboBox>("limitProtectionBox").currentIndex(), 2);
    EXPECT_TRUE(panel.find<QAbstractButton>("stepperInputBox").isChecked());
}

TEST_F(AmplifierPage, NothingIsSentWithoutAYes) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(0));
    ASSERT_NO_FATAL_FAILURE(press("threePhaseBox"));
    ASSERT_NO_FATAL_FAILURE(press("applyAmplifierButton"));
    ASSERT_NO_FATAL_FAILURE(press("applyAmplifierQuestionCancel"));
    EXPECT_TRUE(panel.answersFor(0.3));
    EXPECT_FALSE(sim.state(1)[u"three_phase"_s].toBool());
    EXPECT_FALSE(panel.module().scIo);
}

TEST_F(AmplifierPage, AQuestionIsAboutWhatThePageSaysWhenItIsAnswered) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(0));
    ASSERT_NO_FATAL_FAILURE(press("threePhaseBox"));
    ASSERT_NO_FATAL_FAILURE(press("applyAmplifierButton"));
    ASSERT_NO_FATAL_FAILURE(press("threePhaseBox"));
    ASSERT_NO_FATAL_FAILURE(press("antiphaseBox"));
    ASSERT_NO_FATAL_FAILURE(apply());
    EXPECT_FALSE(sim.state(1)[u"three_phase"_s].toBool());
    EXPECT_TRUE(sim.state(1)[u"antiphase"_s].toBool());
    const auto told = [this] {
        return panel.window().findChild<QDialog*>(u"saveConfigurationQuestion"_s)->accessibleDescription();
    };
    ASSERT_NO_FATAL_FAILURE(press("saveServoBox"));
    ASSERT_NO_FATAL_FAILURE(press("saveConfigurationButton"));
    EXPECT_TRUE(told().contains(u"driven right after power-up"_s)) << told().toStdString();
    ASSERT_NO_FATAL_FAILURE(press("saveServoBox"));
    EXPECT_FALSE(told().contains(u"driven right after power-up"_s)) << told().toStdString();
}

TEST_F(AmplifierPage, WhatIsSavedComesBackAtPowerUp) {
    ASSERT_NO_FATAL_FAILURE(chooseLimits(0));
    ASSERT_NO_FATAL_FAILURE(press("antiphaseBox"));
    ASSERT_NO_FATAL_FAILURE(apply());
    ASSERT_NO_FATAL_FAILURE(press("saveAddressBox"));
    ASSERT_NO_FATAL_FAILURE(press("saveConfigurationButton"));
    ASSERT_NO_FATAL_FAILURE(press("saveConfigurationQuestionGo"));
    EXPECT_TRUE(panel.waitFor([&] { return !panel.module().scIo && !panel.module().silent; }))
        << "what it was sent is forgotten with the reset";
    (void)sim.control(u"power-cycle 1"_s);
    EXPECT_TRUE(panel.waitFor([&] { return sim.state(1)[u"antiphase"_s].toBool(); }));
    EXPECT_EQ(sim.state(1)[u"address"_s].toInt(), 1) << "it restored its address by itself";
}

}  // namespace
}  // namespace nmc
