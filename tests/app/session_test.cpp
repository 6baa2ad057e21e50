// SPDX-License-Identifier: GPL-3.0-or-later
// What the program reports after a crash, or when it cannot do what it usually does.
#include <gtest/gtest.h>

#include "link/guardian/guardreport.h"
#include "tests/support/panel.h"

namespace nmc {
namespace {

using testing_support::IntentPanel;

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
        EXPECT_EQ(next.count(QStringLiteral("its guardian commanded modules 1 and 3 to stop")), 1)
            << next.headlines().join(QLatin1Char('\n')).toStdString();
    }
    IntentPanel oneAfter(settings);
    oneAfter.start();
    EXPECT_EQ(oneAfter.count(QStringLiteral("guardian")), 0);
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
