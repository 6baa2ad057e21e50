// SPDX-License-Identifier: GPL-3.0-or-later
// The chain that was connected when the panel last ran: what is remembered, and what the next run makes of
// it.
#include "app/knownchain.h"

#include <gtest/gtest.h>

#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class KnownChain : public testing::Test {
protected:
    /// A run of the panel with the settings of the previous one.
    void run(const QString& port) {
        panel = std::make_unique<VirtualPanel>(directory.filePath(QStringLiteral("panel.ini")));
        panel->start();
        ASSERT_NO_FATAL_FAILURE(panel->connectTo(port));
    }
    void end() { panel.reset(); }
    [[nodiscard]] const std::vector<ModuleState>& modules() const {
        return panel->composition().store().link().modules;
    }
    bool comes(const QString& words) {
        return panel->waitFor([&] { return panel->standing(words) != nullptr; });
    }
    std::string told() { return panel->headlines().join(QLatin1Char('\n')).toStdString(); }

    QTemporaryDir directory;
    VirtualChain sim{QStringLiteral("servo,servo,step")};
    std::unique_ptr<VirtualPanel> panel;
};

TEST_F(KnownChain, AModuleThatWasPowerCycledMeanwhileIsNamedAndNoneTakesItsPlace) {
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    ASSERT_EQ(modules().size(), 3U);
    end();
    (void)sim.control(QStringLiteral("power-cycle 2"));
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    ASSERT_EQ(modules().size(), 3U);
    EXPECT_TRUE(modules()[2].isStepper()) << "Z is in its old place";
    EXPECT_EQ(modules()[2].info.address, BusAddress(3));
    ASSERT_TRUE(comes(QStringLiteral("Module 2 restarted"))) << told();
    ASSERT_TRUE(panel->press(QStringLiteral("Module 2 restarted"), QStringLiteral("address")));
    EXPECT_TRUE(comes(QStringLiteral("Module 2 has its address again"))) << told();
    EXPECT_EQ(sim.state(2)[QStringLiteral("address")].toInt(), 2);
}

TEST_F(KnownChain, AModuleThatWasTakenOutOnPurposeIsForgotten) {
    const QString missing = QStringLiteral("Module 2 of this chain does not answer");
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    end();
    (void)sim.control(QStringLiteral("fault module 2 silent"));
    for (const bool first : {true, false}) {
        ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
        if (first) {
            ASSERT_EQ(modules().size(), 3U);
            ASSERT_TRUE(comes(missing)) << told();
            EXPECT_EQ(panel->count(QStringLiteral("does not answer")), 1) << "reported once";
            ASSERT_TRUE(panel->press(missing, QStringLiteral("Work with 2")));
            ASSERT_TRUE(panel->waitFor([&] { return panel->connected() && modules().size() == 2; }))
                << told();
        }
        ASSERT_TRUE(panel->answersFor(0.3));
        EXPECT_EQ(modules().size(), 2U);
        EXPECT_TRUE(modules()[1].isStepper());
        EXPECT_EQ(panel->standing(missing), nullptr) << told();
        end();
    }
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(KnownChain, OneThatIsLongerThanBeforeIsTakenAsItIs) {
    {
        QSettings settings(directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat);
        rememberChain(settings, sim.terminal(), {{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}}});
    }
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    EXPECT_EQ(modules().size(), 3U);
    EXPECT_EQ(knownChain(panel->settings(), sim.terminal()).size(), 3U);
}

TEST_F(KnownChain, IsRememberedByPort) {
    QSettings settings(directory.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
    const std::vector<bus::ModuleInfo> chain{
        {ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}},
        {ModuleIndex(1), BusAddress(77), {ModuleType::Stepper, 1}},
        {ModuleIndex(2), BusAddress(3), {ModuleType::Servo, 4}},  // addresses need not be in order
    };
    rememberChain(settings, QStringLiteral("/dev/ttyUSB0"), chain);
    EXPECT_EQ(knownChain(settings, QStringLiteral("/dev/ttyUSB0")), chain);
    EXPECT_TRUE(knownChain(settings, QStringLiteral("/dev/ttyUSB1")).empty());
}

TEST_F(KnownChain, ARateThatNoLookTriesIsRemembered) {
    QSettings settings(directory.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
    const QString port = QStringLiteral("/dev/ttyUSB0");
    rememberRate(settings, port, 250'000);
    EXPECT_EQ(knownRate(settings, port), 250'000U);
    rememberRate(settings, port, 57'600);
    EXPECT_EQ(knownRate(settings, port), 0U) << "each search tries it anyway";
    settings.setValue(QStringLiteral("chainRate/_dev_ttyUSB0"), QStringLiteral("4000"));
    EXPECT_EQ(knownRate(settings, port), 0U) << "1 250 000 / 256 = 4883 is the slowest";
}

TEST_F(KnownChain, WhatIsNoneOfOursIsIgnored) {
    QSettings settings(directory.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
    QString many;
    for (int i = 1; i <= 33; ++i)
        many += QStringLiteral("%1/0/4 ").arg(i);
    for (const QVariant& foreign :
         {QVariant(3), QVariant(QStringLiteral("1/0/4 1/0/4")), QVariant(QStringLiteral("0/0/4")),
          QVariant(QStringLiteral("128/0/4")), QVariant(QStringLiteral("1/256/4")),
          QVariant(QStringLiteral("1/0/256")), QVariant(QStringLiteral("1/0")),
          QVariant(QStringLiteral("1/0/4;2/0/4")), QVariant(QStringLiteral("1/0/-4")), QVariant(many),
          QVariant(QByteArray(1 << 20, '1')),
          QVariant(QStringList{QStringLiteral("1/0/4"), QStringLiteral("2/0/4")})}) {
        settings.setValue(QStringLiteral("chain/x"), foreign);
        EXPECT_TRUE(knownChain(settings, QStringLiteral("x")).empty())
            << foreign.toString().left(40).toStdString();
    }
}

}  // namespace
}  // namespace nmc
