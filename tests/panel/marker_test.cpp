// SPDX-License-Identifier: GPL-3.0-or-later
// A file records which motors move; if one is left behind, the next program reports what it means.
#include "link/guardian/guardreport.h"
#include "tests/support/leaverunning.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

const QString kEnded = QStringLiteral("The last session ended while motor 1 was moving.");

class LeftMark : public testing::Test {
protected:
    void leave(const QString& name, const QByteArray& content) {
        QFile file(home.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    /// Leaves a file like that of a killed program whose number no process has: there are none above 2^22.
    void leave(const VirtualChain& sim) {
        leave(QStringLiteral("moving-4194305-2-3.json"),
              R"({"port":")" + sim.terminal().toUtf8() + R"(","baud":19200,"modules":[1]})");
    }
    [[nodiscard]] static bool stays(VirtualPanel& panel) { return panel.standing(kEnded) != nullptr; }

    QTemporaryDir home;
};

TEST_F(LeftMark, IsSaidAtTheNextStartUntilTheMotorWasSeenAtRest) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualChain other(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(testing_support::leaveRunning(sim, 1, 4));
    ASSERT_NO_FATAL_FAILURE(leave(sim));
    {
        VirtualPanel idle({}, {}, home.path());
        idle.start();
        ASSERT_TRUE(stays(idle));
        EXPECT_TRUE(idle.standing(kEnded)->message().body.contains(sim.terminal()));
    }
    VirtualPanel next({}, {}, home.path());
    next.start();
    ASSERT_TRUE(stays(next)) << "reporting it once is not enough";
    ASSERT_NO_FATAL_FAILURE(next.connectTo(other.terminal()));
    ASSERT_TRUE(next.answersFor(2.0));
    EXPECT_TRUE(stays(next)) << "that is another port";
    next.connectTo(sim.terminal());
    ASSERT_TRUE(next.waitFor([&] {
        return next.connected() && next.composition().store().link().port == sim.terminal().toStdString();
    }));
    next.pressStopAll();
    EXPECT_TRUE(next.waitFor([&] { return !stays(next); }));
    EXPECT_FALSE(sim.driven(0));
    VirtualPanel last({}, {}, home.path());
    last.start();
    EXPECT_FALSE(stays(last));
}

TEST_F(LeftMark, IsOverWhenTheUserHasLooked) {
    const VirtualChain sim(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(leave(sim));
    for (const bool first : {true, false}) {
        VirtualPanel next({}, {}, home.path());
        next.start();
        ASSERT_EQ(stays(next), first);
        if (!first)
            break;
        auto* looked = next.window().findChild<QAbstractButton*>(QStringLiteral("bannerAction_lookedAt"));
        ASSERT_NE(looked, nullptr);
        QTest::mouseClick(looked, Qt::LeftButton);
        EXPECT_FALSE(stays(next));
    }
}

TEST_F(LeftMark, WithWhatTheGuardianDidCanBeLookedAt) {
    VirtualChain sim(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(testing_support::leaveRunning(sim, 1, 4));
    ASSERT_NO_FATAL_FAILURE(leave(sim));
    // As its guardian writes it: the stop of module 1 (DS-V 5.2).
    const std::vector<std::uint8_t> stop{0, 0xAA, 0x01, 0x17, 0x05, 0x1D, 0};
    ASSERT_TRUE(writeGuardReport(home.filePath(QStringLiteral("guardian-4194305.report")).toStdString(),
                                 *StopBurst::of(stop, 19'200)));
    VirtualPanel next(home.filePath(QStringLiteral("next.ini")), {}, home.path());
    next.start();
    const QString told = QStringLiteral("its guardian commanded module 1 to stop");
    ASSERT_NE(next.standing(told), nullptr);
    EXPECT_EQ(next.count(kEnded), 0) << "one event gives one message";
    ASSERT_TRUE(next.press(told, QStringLiteral("Look first")));
    ASSERT_TRUE(next.waitFor([&] { return next.connected() && next.module().latest.has_value(); }));
    EXPECT_TRUE(next.composition().store().link().readOnly);
    ASSERT_TRUE(next.answersFor(2.0));
    EXPECT_NE(next.standing(told), nullptr) << "watching does not settle it";
    ASSERT_TRUE(next.press(told, QStringLiteral("Look first")));
    EXPECT_NE(next.standing(QStringLiteral("A port is already open")), nullptr);
    EXPECT_TRUE(next.connected()) << "closing the port for that might stop motors";
    ASSERT_TRUE(next.press(told, QStringLiteral("I have checked")));
    EXPECT_EQ(next.standing(told), nullptr);
}

/// The guardian knows addresses only.
TEST_F(LeftMark, NamesModulesByTheirPlaceWhateverTheirAddressesAre) {
    leave(QStringLiteral("moving-4194305-2-3.json"),
          R"({"port":"/dev/ttyUSB0","baud":19200,"modules":[2],"addresses":[1,40]})");
    const std::vector<std::uint8_t> stop{0, 0xAA, 0x28, 0x17, 0x05, 0x44, 0};  // of address 40 (DS-V 5.2)
    ASSERT_TRUE(writeGuardReport(home.filePath(QStringLiteral("guardian-4194305.report")).toStdString(),
                                 *StopBurst::of(stop, 19'200)));
    VirtualPanel next(home.filePath(QStringLiteral("next.ini")), {}, home.path());
    next.start();
    EXPECT_NE(next.standing(QStringLiteral("its guardian commanded module 2 to stop")), nullptr);
}

TEST_F(LeftMark, ThatWasTamperedWithIsNoDanger) {
    leave(QStringLiteral("moving-1-2-3.json"), R"({"port":"x","modules":[0,33,-1,"x",null]})");
    leave(QStringLiteral("moving-1-2-4.json"), R"({"port":7,"modules":{}})");
    leave(QStringLiteral("moving-1-2-5.json"), QByteArray(1 << 20, '['));
    leave(QStringLiteral("moving-99999999999999999999-2-5.json"), "");
    leave(QStringLiteral("moving-x.json"), R"({"port":"x","modules":[1]})");
    VirtualPanel panel({}, {}, home.path());
    panel.start();
    EXPECT_EQ(panel.count(QStringLiteral("last session")), 0);
}

TEST(MotionMark, IsAskedForBeforeTheCommandAndGoneWhenTheMotorStands) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    EXPECT_EQ(panel.markers().size(), 1);
    panel.click("stopAbruptlyButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.markers().isEmpty(); }));
    // The file is there whatever is known about the motor: no time has passed.
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(8 << 16), CountsPerTickSquared(1'311), false}});
    ASSERT_EQ(panel.markers().size(), 1);
    EXPECT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.markers().size(), 1);
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return panel.markers().isEmpty(); }));
}

TEST(PortGone, WithAMotorMovingIsNotOverBecauseSomebodyTriedAgain) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    const QString gone = QStringLiteral("Module 1 was moving");
    sim.unplug();
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(gone) != nullptr; }));
    for (int i = 0; i < 2; ++i) {
        const qsizetype before = panel.headlines().size();
        QTest::mouseClick(panel.window().findChild<QAbstractButton*>(QStringLiteral("bannerAction_retry")),
                          Qt::LeftButton);
        ASSERT_TRUE(panel.waitFor([&] {
            return !panel.composition().worker().isOpen() && (i > 0 || panel.headlines().size() > before);
        }));
        EXPECT_NE(panel.standing(gone), nullptr);
        EXPECT_EQ(panel.markers().size(), 1) << "the motor that moved is not forgotten either";
    }
}

}  // namespace
}  // namespace nmc
