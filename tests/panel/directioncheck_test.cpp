// SPDX-License-Identifier: GPL-3.0-or-later
// From a servo about which nothing is known to its first homing, with the whole program and the simulator;
// and one whose encoder is reversed.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class FirstSession : public testing::Test {
protected:
    void begin() {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        panel.window().resize(1'500, 1'100);  // all of the panel is visible
    }
    void show(const char* page) { panel.find(page); }
    QString text(const char* label) { return panel.find<QLabel>(label).text(); }
    void click(const char* name) {
        const auto ready = [&] {
            auto* button = panel.window().findChild<QAbstractButton*>(QLatin1String(name));
            if (button != nullptr)
                testing_support::turnTo(*button);
            // Visible and laid out: a user can click it.
            return button != nullptr && !button->visibleRegion().isEmpty() && button->isEnabled();
        };
        ASSERT_TRUE(panel.waitFor(ready)) << name;
        QTest::mouseClick(panel.window().findChild<QAbstractButton*>(QLatin1String(name)), Qt::LeftButton);
    }
    void check() {
        show("axisBox");
        click("directionCheckButton");
        click("startDirectionCheckButton");
    }
    void expectOff() {
        const QJsonObject truth = sim.state(1);
        EXPECT_FALSE(truth[u"servo_on"_s].toBool());
        EXPECT_FALSE(truth[u"amp_enabled"_s].toBool());
        EXPECT_EQ(truth[u"pwm"_s].toInt(), 0);
    }

    VirtualChain sim{u"servo,servo"_s};
    VirtualPanel panel;
};

TEST_F(FirstSession, ChecksEnablesAndHomesWithStartingValues) {
    ASSERT_NO_FATAL_FAILURE(begin());
    for (const QString& line :
         {u"set 1 travel_min -700"_s, u"set 1 travel_max 9000"_s, u"set 1 limits auto"_s})
        std::ignore = sim.control(line);
    ASSERT_NO_FATAL_FAILURE(check());
    ASSERT_TRUE(panel.waitFor([&] { return text("directionCheckState").startsWith(u"✓"_s); }))
        << text("directionCheckState").toStdString();
    expectOff();
    show("gainsBox");
    click("fillGainsButton");
    click("applyGainsButton");
    click("enableButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn(); }));
    show("homingBox");
    click("homeButton");
    ASSERT_TRUE(panel.waitFor([&] { return text("homingResultLabel").contains(u"Done"_s); }))
        << text("homingResultLabel").toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 2);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(FirstSession, FindsAReversedEncoderBeforeItRunsAway) {
    ASSERT_NO_FATAL_FAILURE(begin());
    std::ignore = sim.control(u"fault module 1 reverse"_s);
    ASSERT_NO_FATAL_FAILURE(check());
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"is reversed. Do not enable it."_s) != nullptr; }))
        << text("directionCheckState").toStdString();
    expectOff();
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(FirstSession, StopAllEndsTheCheckAndLeavesTheMotorOff) {
    ASSERT_NO_FATAL_FAILURE(begin());
    std::ignore = sim.control(u"fault module 1 stall"_s);
    ASSERT_NO_FATAL_FAILURE(check());
    ASSERT_TRUE(panel.waitFor([&] { return text("directionCheckState").startsWith(u"▶"_s); }));
    panel.pressStopAll();
    ASSERT_TRUE(panel.waitFor([&] { return text("directionCheckState").startsWith(u"○"_s); }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_TRUE(panel.waitFor([&] { return !sim.state(1)[u"amp_enabled"_s].toBool(); }));
    expectOff();
}

TEST_F(FirstSession, ATripOfAReversedEncoderSaysSo) {
    ASSERT_NO_FATAL_FAILURE(begin());
    std::ignore = sim.control(u"fault module 1 reverse"_s);
    show("gainsBox");
    click("fillGainsButton");
    click("applyGainsButton");
    click("enableButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn(); }));
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(6'554), false}});
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"switched its servo off"_s) != nullptr; }));
    EXPECT_TRUE(panel.standing(u"switched its servo off"_s)->message().body.contains(u"probably reversed"_s))
        << panel.standing(u"switched its servo off"_s)->message().body.toStdString();
}

}  // namespace
}  // namespace nmc
