// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses in the whole program, by object name, with the simulator, which knows what the motor did.
#include "tests/support/virtualpanel.h"
#include "widgets/response/responsepage.h"
#include "widgets/response/responseplot.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class StepResponsePlace : public testing::Test {
protected:
    /// Connects, sends gains, enables the servo, and shows the page.
    void begin() {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        applyGains(200, 2'000);
        panel.ask(intent::Enable{});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn(); }));
        click("openStepResponseButton");
        ASSERT_TRUE(panel.waitFor([&] { return panel.find<QWidget>("responsePage").isVisible(); }));
        click("responseHoldButton");
    }
    void applyGains(std::uint16_t kp, std::uint16_t kd) {
        const servo::SetGain gains{kp, kd, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
        panel.ask(intent::ApplyGains{gains});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains == gains; }));
    }
    void click(const char* name) {
        ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>(name).isEnabled(); }))
            << name << ": " << panel.find<QAbstractButton>(name).toolTip().toStdString();
        testing_support::clickOn(panel.find<QAbstractButton>(name));
    }
    [[nodiscard]] const std::vector<KeptResponse>& runs() {
        return panel.find<ResponsePage>("responsePage").runs();
    }
    void step() {
        panel.step([this] {
            click("responseButton");
            EXPECT_FALSE(panel.find<QAbstractButton>("responseButton").isEnabled()) << "one at a time";
            goal += 100;
        });
    }
    /// How many statuses of a module were received while that step was recorded.
    [[nodiscard]] std::size_t statusesOf(std::uint8_t module, const ResponseTaken& step) {
        const ModuleHistory* history = panel.composition().store().history().module(ModuleIndex(module));
        return history == nullptr ? 0
                                  : history->countBetween(step.at, step.at + fromSeconds(step.record),
                                                          ScopeSignal::Position);
    }
    QString result(int row, int column) {
        return panel.find<QTableWidget>("responseResults").item(row, column)->text();
    }

    VirtualChain sim{u"servo,servo,servo"_s};
    VirtualPanel panel;
    int goal = 0;  ///< counts, of the last step
};

TEST_F(StepResponsePlace, TwoRunsAreComparedAndTheFirstOnesGainsComeBackUnsent) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(step());
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), goal, 3);
    EXPECT_TRUE(sim.state(1)[u"servo_on"_s].toBool()) << "it holds there";
    const KeptResponse& first = runs().front();
    EXPECT_TRUE(first.run.metrics.rise);
    EXPECT_TRUE(first.run.metrics.settling);
    ASSERT_TRUE(first.run.metrics.steadyError);
    EXPECT_NEAR(first.run.metrics.steadyError->value, 0, 3);
    // Three modules share the line; nearly all of it is used for this one.
    EXPECT_GT(statusesOf(0, first.run.taken), 10 * statusesOf(1, first.run.taken));
    ASSERT_TRUE(first.run.pwm);
    // (200 x 100 + 2000 x 100 - 20 x 200) / 256 is 843, far above the limit.
    EXPECT_EQ(result(12, 0), u"limited to 255"_s);
    EXPECT_TRUE(result(1, 0).contains(u"±"_s) && result(1, 0).endsWith(u"ms"_s))
        << result(1, 0).toStdString();

    applyGains(200, 600);
    ASSERT_NO_FATAL_FAILURE(step());
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), goal, 3);
    const QString firstNumber = QString::number(runs().front().number);
    EXPECT_EQ(result(0, 0), QString::number(runs()[1].number));
    EXPECT_EQ(result(0, 1), firstNumber);
    ASSERT_TRUE(runs()[1].run.metrics.overshoot);
    EXPECT_GT(runs()[1].run.metrics.overshoot->value, runs()[0].run.metrics.overshoot->value + 5)
        << "this run has a third of the damping";
    EXPECT_TRUE(
        panel.find<ResponsePlot>("responsePlot").legendText(1).startsWith(u"B: run "_s + firstNumber));

    panel.find<QTableWidget>("responseRunTable").setCurrentCell(1, 2);
    click("responseUseGainsButton");
    EXPECT_EQ(panel.find<QLineEdit>("kdField").text(), u"2000"_s);
    EXPECT_EQ(panel.find<QLabel>("kdState").text(), u"● not sent"_s);
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(panel.module().gains->kd, 600) << "the module still has its gains";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(StepResponsePlace, AStopEndsItWithoutARun) {
    ASSERT_NO_FATAL_FAILURE(begin());
    panel.type("responseRecordField", u"3"_s);
    click("responseButton");
    ASSERT_TRUE(panel.waitFor([&] { return sim.state(1)[u"position"_s].toInt() > 80; }));
    click("stopAllButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>("responseButton").isEnabled(); }))
        << panel.find<QAbstractButton>("responseButton").toolTip().toStdString();
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_TRUE(runs().empty());
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(StepResponsePlace, AServoThatSwingsUpIsStoppedAndSaidSo) {
    ASSERT_NO_FATAL_FAILURE(begin());
    applyGains(3'000, 0);
    click("responseButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(u"Module 1"_s) > 0 && !panel.module().servoOn(); }));
    EXPECT_EQ(panel.count(u"was switched off and is free to turn: it kept oscillating"_s) +
                  panel.count(u"did not complete its step: its motor switched itself off"_s),
              1);
    EXPECT_TRUE(runs().empty());
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc
