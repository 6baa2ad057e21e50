// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says about a motor, compared with what the simulated motor does.
#include "app/news.h"
#include "tests/model/servofixture.h"
#include "tests/support/gains.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class Truth : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim)); }
    QString label(const char* name) {
        auto* found = panel.window().findChild<QLabel*>(QLatin1String(name));
        testing_support::turnTo(*found);
        return found->text();
    }
    bool saysSoon(const char* state) {
        return panel.waitFor([&] { return label("stateLabel") == QLatin1String(state); });
    }

    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;
};

TEST_F(Truth, AMotorThatWasStoppedWhileItWasSilentIsNotAtSpeedWhenItIsBack) {
    (void)sim.control(QStringLiteral("fault module 1 silent"));
    ASSERT_TRUE(saysSoon("No answer"));
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("use the hardware stop")) > 0; }));
    (void)sim.control(QStringLiteral("fault clear"));
    EXPECT_TRUE(saysSoon("Holding")) << label("stateLabel").toStdString();
    EXPECT_FALSE(panel.module().moving());
    const QString stopped = QStringLiteral("use the hardware stop. Module 1 has stopped.");
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(stopped) == 1; }));
    EXPECT_TRUE(label("stopResultLabel").endsWith(stopped)) << label("stopResultLabel").toStdString();
}

TEST_F(Truth, AShaftThatALoadDrivesIsNotCalledFine) {
    panel.click("stopAbruptlyButton");
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    (void)sim.control(QStringLiteral("set 1 load 0.02"));
    panel.click("motorOffButton");
    ASSERT_TRUE(saysSoon("Off, but turning")) << label("stateLabel").toStdString();
    EXPECT_FALSE(label("stateMeaning").contains(QLatin1String("This is normal")));
    (void)sim.control(QStringLiteral("set 1 load 0"));
    EXPECT_TRUE(saysSoon("Servo off"));
}

TEST_F(Truth, OvercurrentIsSaid) {
    panel.click("stopAbruptlyButton");
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    // A limit below any reading: it is odd, so A/D > CL is an overcurrent.
    panel.ask(intent::ApplyGains{{200, 2'000, 20, 200, 255, 1, 8'000, 1, std::uint8_t{0}}});
    (void)sim.control(QStringLiteral("set 1 analog 200"));
    ASSERT_TRUE(saysSoon("Overcurrent")) << label("stateLabel").toStdString();
    EXPECT_EQ(panel.count(QStringLiteral("Overcurrent")), 1);
    panel.ask(intent::ApplyGains{testing_support::kGains});
    panel.click("clearStickyButton");
    EXPECT_TRUE(saysSoon("Holding")) << label("stateLabel").toStdString();
}

/// This has happened: Scan again said that the gains were unknown, although they were kept and shown as sent.
TEST(ChainFoundAgain, SaysThatGainsAreUnknownOnlyIfTheyAre) {
    using namespace testing_support;
    LinkState link;
    link.phase = LinkPhase::Connected;
    link.modules = {holdingServo()};
    bus::ChainFound found;
    found.modules = {link.modules.front().info};
    found.attached = true;
    EXPECT_EQ(newsOf(found, link).at(0).message.body,
              QStringLiteral("The modules carry on with what they were doing."));
    link.modules.push_back(servoModule());
    EXPECT_TRUE(newsOf(found, link).at(0).message.body.contains(QLatin1String("Gains are unknown")));
}

/// This has happened: after a stop, a busy computer was said to freeze while a motor moved, for minutes.
TEST(Freezes, AreNotReportedOfMotorsThatAreNotKnownToMove) {
    using namespace testing_support;
    const PanelFroze froze{std::chrono::seconds(1), false};
    LinkState link;
    link.phase = LinkPhase::Connected;
    link.modules = {holdingServo()};
    ModuleState& module = link.modules.front();
    EXPECT_TRUE(newsOf(froze, link).empty());
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(sampleOf(1.1, kPower, kServoOn, 50));
    EXPECT_EQ(newsOf(froze, link).size(), 1U);
    link.phase = LinkPhase::Lost;
    EXPECT_TRUE(newsOf(froze, link).empty()) << "its report is not renewed any more";
    EXPECT_EQ(newsOf(PanelFroze{std::chrono::seconds(3), true}, link).size(), 1U);
    link.phase = LinkPhase::Connected;
    module.silent = true;
    EXPECT_TRUE(newsOf(froze, link).empty());
    module.silent = false;
    module.confirmedAtRest();
    EXPECT_TRUE(newsOf(froze, link).empty());
}

}  // namespace
}  // namespace nmc
