// SPDX-License-Identifier: GPL-3.0-or-later
// faults.md H-02: connected read-only, through the whole window, at a chain that another program has set
// going.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QJsonArray>

#include "tests/support/leaverunning.h"
#include "tests/support/virtualpanel.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class H02_ReadOnly : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(testing_support::leaveRunning(sim, 1, 4)); }

    /// As `nmcpanel --port ... --read-only` does.
    void look() {
        panel.composition().show({sim.terminal(), 19'200, false, false, true});
        ASSERT_TRUE(panel.waitFor([&] { return looks() && panel.module().latest.has_value(); }));
    }
    [[nodiscard]] bool looks() { return panel.connected() && panel.composition().store().link().readOnly; }
    void click(const char* button) {
        auto* widget = panel.window().findChild<QAbstractButton*>(QLatin1String(button));
        ASSERT_NE(widget, nullptr) << button;
        QTest::mouseClick(widget, Qt::LeftButton);
    }
    [[nodiscard]] bool ribbon() {
        return panel.window().findChild<QWidget*>(QStringLiteral("readOnlyRibbon"))->isVisible();
    }
    /// How often module 1 has carried out what, but for questions.
    QJsonObject carriedOut() {
        const QJsonArray modules = sim.control(QStringLiteral("stats"))[QStringLiteral("modules")].toArray();
        QJsonObject commands = modules[0].toObject()[QStringLiteral("executed")].toObject();
        for (const char* question : {"nop", "read_status"})
            commands.remove(QLatin1String(question));
        return commands;
    }

    VirtualChain sim{QStringLiteral("servo")};
    VirtualPanel panel;
};

TEST_F(H02_ReadOnly, StopAllStopsAndTheConnectionStaysReadOnly) {
    ASSERT_NO_FATAL_FAILURE(look());
    EXPECT_TRUE(ribbon());
    EXPECT_TRUE(sim.driven(0));
    QTest::keyClick(&panel.window(), Qt::Key_Escape);
    EXPECT_TRUE(panel.waitFor([&] { return !sim.driven(0); }));
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("1 stopped and holding")) == 1; }));
    EXPECT_TRUE(looks());
    EXPECT_TRUE(ribbon());
}

TEST_F(H02_ReadOnly, WhatIsAskedForIsRefusedWithTheReason) {
    ASSERT_NO_FATAL_FAILURE(look());
    const QJsonObject before = carriedOut();
    panel.ask(intent::MotorOff{});
    EXPECT_TRUE(
        panel.waitFor([&] { return panel.count(QStringLiteral("Module 1 cannot do this now")) == 1; }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(carriedOut(), before);
    EXPECT_TRUE(sim.driven(0));
    EXPECT_TRUE(panel.markers().isEmpty()) << "that motion is nobody's here";
}

TEST_F(H02_ReadOnly, ScanningAgainLooksAgainAndConnectFullyGoesOn) {
    ASSERT_NO_FATAL_FAILURE(look());
    panel.window().findChild<QAction*>(QStringLiteral("scanAction"))->trigger();
    ASSERT_TRUE(panel.waitFor([&] { return panel.chainsFound() == 2; }));
    ASSERT_TRUE(panel.waitFor([&] { return looks(); }));
    ASSERT_NO_FATAL_FAILURE(click("connectFullyButton"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected() && !looks(); }));
    EXPECT_FALSE(ribbon());
    EXPECT_EQ(panel.composition().store().link().port, sim.terminal().toStdString());
}

TEST_F(H02_ReadOnly, IsNotRememberedAtTheNextConnect) {
    ASSERT_NO_FATAL_FAILURE(look());
    ASSERT_NO_FATAL_FAILURE(click("disconnectButton"));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    EXPECT_FALSE(ribbon());
    ASSERT_NO_FATAL_FAILURE(click("connectButton"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    EXPECT_FALSE(looks());
}

TEST_F(H02_ReadOnly, TheMachineIsNamedAndRecordedAsEver) {
    ASSERT_NO_FATAL_FAILURE(look());
    QTemporaryDir directory;
    const QString file = directory.filePath(QStringLiteral("look.csv"));
    emit panel.window().scopeFiles().recordRequested(file);
    AxisSettings axis;
    axis.name = "X axis";
    emit panel.window().axisEdited(ModuleIndex(0), axis);
    EXPECT_EQ(texts::moduleName(ModuleIndex(0)), QStringLiteral("Module 1 \"X axis\""));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_TRUE(panel.waitFor([&] { return QFileInfo(file).size() > 0; }));
    texts::setModuleNames({});
}

}  // namespace
}  // namespace nmc
