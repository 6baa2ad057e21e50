// SPDX-License-Identifier: GPL-3.0-or-later
// The program ends, hangs, or cannot do what it is used to: what becomes of the motors, and what is said.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTimer>
#include <csignal>

#include "app/unixsignals.h"
#include "link/guardian/guardreport.h"
#include "tests/support/panel.h"

namespace nmc {
namespace {

using testing_support::IntentPanel;
using testing_support::moves;
using testing_support::NmcsimProcess;

const QString kServo = QStringLiteral("servo");

class Signals : public testing::TestWithParam<int> {};

TEST_P(Signals, StopTheMotorsAndEndTheProgram) {
    NmcsimProcess sim(kServo);
    IntentPanel panel;
    const UnixSignals system(panel.composition().worker());
    QObject::connect(&system, &UnixSignals::terminationAsked, &panel.composition(),
                     &Composition::stopAndQuit);
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    std::raise(GetParam());
    EXPECT_TRUE(panel.waitFor([&] { return !panel.window().isVisible(); }));
    EXPECT_FALSE(panel.composition().worker().isOpen());
    EXPECT_FALSE(moves(sim));
    EXPECT_TRUE(sim.state(1)[QStringLiteral("servo_on")].toBool());
    EXPECT_TRUE(panel.markers().isEmpty());
}

INSTANTIATE_TEST_SUITE_P(H04, Signals, testing::Values(SIGTERM, SIGINT, SIGHUP));

TEST(H04_Signal, StopsTheMotorsWhileTheGuiThreadIsBlocked) {
    NmcsimProcess sim(kServo);
    IntentPanel panel;
    const UnixSignals system(panel.composition().worker());
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    bool stopped = false;
    QTimer::singleShot(0, [&] {
        // Below Heartbeat::kStopAfter, which would stop them as well.
        QElapsedTimer clock;
        clock.start();
        std::raise(SIGTERM);
        while (!stopped && clock.elapsed() < 1'900)
            stopped = !moves(sim);
    });
    EXPECT_TRUE(panel.waitFor([&] { return stopped; }));
    EXPECT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); })) << "and it closed";
}

TEST(H04_EndOfSession, StopsTheMotorsAndEndsTheProgramWithoutAQuestion) {
    NmcsimProcess sim(kServo);
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    // Only the platform can make a session manager, and nobody here looks into it.
    alignas(QObject) std::byte manager[sizeof(QObject)]{};
    emit qApp->commitDataRequest(reinterpret_cast<QSessionManager&>(manager));
    EXPECT_TRUE(panel.waitFor([&] { return !panel.window().isVisible(); }));
    EXPECT_FALSE(panel.composition().worker().isOpen());
    EXPECT_FALSE(moves(sim));
}

TEST(H01_FrozenPanel, SaysSoInTheMessageList) {
    NmcsimProcess sim(kServo);
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    bool stopped = false;
    QTimer::singleShot(0, [&] {
        QElapsedTimer limit;
        limit.start();
        while (!stopped && limit.elapsed() < 20'000)
            stopped = !moves(sim);
    });
    ASSERT_TRUE(panel.waitFor([&] { return stopped; }));
    EXPECT_TRUE(panel.waitFor([&] {
        return panel.count(QStringLiteral("motors were told to stop after 2 s")) == 1;
    })) << panel.headlines().join(QLatin1Char('\n')).toStdString();
}

TEST(H02_Guardian, WhatItHadToDoIsSaidAtTheNextStartOnce) {
    QTemporaryDir directory;
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    // As a guardian writes it: the stops of modules 1 and 3 (DS-V 5.2).
    const std::vector<std::uint8_t> stops{0,    0xAA, 0x01, 0x17, 0x05, 0x1D, 0,
                                          0xAA, 0x03, 0x17, 0x05, 0x1F, 0};
    ASSERT_TRUE(writeGuardReport(directory.filePath(QStringLiteral("guardian-1.report")).toStdString(),
                                 *StopBurst::of(stops, 19'200)));
    {
        IntentPanel next(settings);
        next.start();
        EXPECT_EQ(next.count(QStringLiteral("its guardian told modules 1 and 3 to stop")), 1)
            << next.headlines().join(QLatin1Char('\n')).toStdString();
    }
    IntentPanel oneAfter(settings);
    oneAfter.start();
    EXPECT_EQ(oneAfter.count(QStringLiteral("guardian")), 0);
}

TEST(H02_Guardian, IsThereWithoutAWordOnAPort) {
    NmcsimProcess sim(kServo);
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    EXPECT_EQ(panel.count(QStringLiteral("guardian")), 0);
}

TEST(H18_ReadOnlyHome, IsSaidOnceAndTheProgramRuns) {
    IntentPanel panel(QStringLiteral("/proc/nmc/panel.ini"));  // nobody can write there
    panel.start();
    EXPECT_EQ(panel.count(QStringLiteral("Settings cannot be saved")), 1);
    EXPECT_TRUE(panel.window().isVisible());
    IntentPanel other;
    other.start();
    EXPECT_EQ(other.count(QStringLiteral("Settings cannot be saved")), 0);
}

}  // namespace
}  // namespace nmc
