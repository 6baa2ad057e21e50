// SPDX-License-Identifier: GPL-3.0-or-later
// A limit stop that is armed for each motion, in the whole program, checked with the simulated motor.
#include "tests/support/virtualpanel.h"
#include "widgets/mainwindow/operatorlock.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class ArmedLimits : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(panel.enable());
    }
    void TearDown() override { texts::setModuleNames({}); }
    [[nodiscard]] const HomeWatch& watch() { return panel.module().homing; }
    [[nodiscard]] QString said() {
        auto* label = panel.window().findChild<QLabel*>(u"limitStopState"_s);
        testing_support::turnTo(*label);
        return label->text();
    }
    bool armed() {
        return panel.waitFor([&] { return watch().state() == HomeWatch::State::Armed && watch().stops(); });
    }
    /// Clicks the box itself, because its row is wider.
    void tick(const char* name, bool on = true) {
        auto* box = panel.window().findChild<QAbstractButton*>(QLatin1String(name));
        testing_support::turnTo(*box);
        ASSERT_TRUE(panel.waitFor([&] { return box->isEnabled(); })) << box->toolTip().toStdString();
        if (box->isChecked() != on)
            QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
        ASSERT_EQ(box->isChecked(), on) << name;
    }
    void armEachMotion(const char* condition) {
        tick(condition);
        tick("armEachMotionBox");
        ASSERT_TRUE(armed());
        EXPECT_TRUE(panel.waitFor([&] { return said().startsWith(u"● Armed: stops at "_s); }))
            << said().toStdString();
    }
    void run() {
        ASSERT_TRUE(panel.waitFor([&] { return !panel.module().awaited; }));
        panel.ask(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}});
        ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    }
    [[nodiscard]] double shaft() { return sim.state(1)[u"shaft"_s].toDouble(); }
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
};

TEST_F(ArmedLimits, TheChipStopsAtTheSwitchAndIsArmedAgain) {
    ASSERT_NO_FATAL_FAILURE(tick("armLimit2Box", false));
    ASSERT_NO_FATAL_FAILURE(armEachMotion("armLimit1Box"));
    ASSERT_NO_FATAL_FAILURE(run());
    (void)sim.control(u"set 1 limit1 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_TRUE(panel.waitFor([&] { return watch().state() == HomeWatch::State::Tripped; }));
    EXPECT_TRUE(panel.waitFor([&] { return said().startsWith(u"▲ Tripped by limit 1"_s); }))
        << said().toStdString();
    const double rest = shaft();
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NEAR(shaft(), rest, 2);
    (void)sim.control(u"set 1 limit1 0"_s);
    ASSERT_TRUE(armed()) << "it was armed automatically, once the switch had opened";
    ASSERT_NO_FATAL_FAILURE(run());
    (void)sim.control(u"set 1 limit1 1"_s);
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); })) << "it stopped again";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ArmedLimits, WithoutItTheSwitchAloneStopsNothing) {
    ASSERT_NO_FATAL_FAILURE(run());
    (void)sim.control(u"set 1 limit1 1"_s);
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_TRUE(moves(sim));
}

/// The motor must be able to leave the one switch, on its way to the other.
TEST_F(ArmedLimits, TheOtherLimitIsArmedWhileTheMotorStandsOnOne) {
    const auto watches = [this](bool limit1, bool limit2) {
        return panel.waitFor([&] {
            return watch().state() == HomeWatch::State::Armed && watch().onLimit1() == limit1 &&
                   watch().onLimit2() == limit2;
        });
    };
    const QString tripped = u"The limit stop of module 1 stopped its motor"_s;
    ASSERT_NO_FATAL_FAILURE(armEachMotion("armLimit2Box"));
    ASSERT_TRUE(watches(true, true)) << "both are chosen at first";
    (void)sim.control(u"set 1 limit1 1"_s);
    ASSERT_TRUE(watches(false, true));
    EXPECT_TRUE(panel.waitFor([&] { return said() == u"● Armed: stops at limit 2, once."_s; }))
        << said().toStdString();
    EXPECT_TRUE(panel.waitFor([&] { return panel.standing(tripped) != nullptr; }))
        << "the motor still stands on the switch";
    ASSERT_NO_FATAL_FAILURE(run());
    (void)sim.control(u"set 1 limit2 1"_s);
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_TRUE(panel.waitFor([&] { return watch().state() == HomeWatch::State::Tripped; }));
    (void)sim.control(u"set 1 limit1 0"_s);
    (void)sim.control(u"set 1 limit2 0"_s);
    EXPECT_TRUE(watches(true, true));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ArmedLimits, AnOperatorMovesNothingUnarmed) {
    ASSERT_NO_FATAL_FAILURE(tick("armLimit2Box", false));
    ASSERT_NO_FATAL_FAILURE(armEachMotion("armLimit1Box"));
    panel.window().findChild<QAction*>(u"operatorAction"_s)->trigger();
    for (const char* name : {"operatorPinField", "operatorPinAgainField"})
        QTest::keyClicks(panel.window().findChild<QLineEdit*>(QLatin1String(name)), u"4711"_s);
    panel.click("operatorBeginButton");
    ASSERT_TRUE(panel.window().operatorLock().isLocked());
    // A window that loses the focus ends what is held: wait until the dialog has lost it before anything is
    // held.
    ASSERT_TRUE(panel.waitFor([&] { return QApplication::activeWindow() == nullptr; }));
    panel.window().activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel.window()));
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(armed()) << round;
        QAbstractButton* forward = nullptr;
        ASSERT_NO_FATAL_FAILURE(panel.reach("holdForwardButton", forward));
        QTest::mousePress(forward, Qt::LeftButton);
        ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
        (void)sim.control(u"set 1 limit1 1"_s);
        EXPECT_TRUE(
            panel.waitFor([&] { return !moves(sim) && watch().state() == HomeWatch::State::Tripped; }));
        QTest::mouseRelease(forward, Qt::LeftButton);
        (void)sim.control(u"set 1 limit1 0"_s);
    }
}

TEST_F(ArmedLimits, APositionErrorStopsIt) {
    panel.ask(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 200, 1, std::uint8_t{0}}});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains->el == 200; }));
    tick("armMotorOffButton");
    ASSERT_NO_FATAL_FAILURE(armEachMotion("armPositionErrorBox"));
    ASSERT_NO_FATAL_FAILURE(run());
    (void)sim.control(u"set 1 friction 1"_s);  // N m, more than the motor can overcome
    EXPECT_TRUE(panel.waitFor([&] { return !panel.module().servoOn() && !moves(sim); }));
    EXPECT_TRUE(panel.waitFor([&] { return watch().state() == HomeWatch::State::Tripped; }));
}

}  // namespace
}  // namespace nmc
