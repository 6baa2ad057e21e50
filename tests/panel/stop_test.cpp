// SPDX-License-Identifier: GPL-3.0-or-later
// STOP ALL and Esc in the whole program, whatever is open: the simulated motor stops.
#include <functional>

#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

struct Open {
    const char* name;
    std::function<void(MainWindow&)> open;
};
void PrintTo(const Open& open, std::ostream* out) {
    *out << open.name;
}

class StopWhile : public testing::TestWithParam<Open> {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
        GetParam().open(panel.window());
    }
    /// The window has the focus again where a question went together with its connection.
    void pressEsc() {
        QWindow* focus = QGuiApplication::focusWindow();
        if (const QWidget* popup = QApplication::activePopupWidget())
            focus = popup->windowHandle();
        QTest::keyPress(focus != nullptr ? focus : panel.window().windowHandle(), Qt::Key_Escape);
    }
    bool stops() {
        return panel.waitFor([this] { return !moves(sim); });
    }
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;
};

TEST_P(StopWhile, ItIsOpenAPressOnStopAllStopsTheMotor) {
    auto* stop = panel.window().findChild<QWidget*>(QStringLiteral("stopAllButton"));
    const QPoint global = stop->mapToGlobal(stop->rect().center());
    if (QWidget* popup = QApplication::activePopupWidget()) {
        // A popup grabs the pointer, wherever the pointer is.
        const QPoint local = popup->mapFromGlobal(global);
        QMouseEvent press(QEvent::MouseButtonPress, local, local, global, Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(popup->windowHandle(), &press);
    } else {
        QTest::mousePress(panel.window().windowHandle(), Qt::LeftButton, {},
                          panel.window().mapFromGlobal(global));
    }
    EXPECT_TRUE(stops());
}

TEST_P(StopWhile, ItIsOpenEscStopsTheMotor) {
    pressEsc();
    EXPECT_TRUE(stops());
}

TEST_P(StopWhile, ItIsOpenEscStopsTheMotorOnceTheLineIsBack) {
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    pressEsc();
    ASSERT_TRUE(moves(sim));
    sim.plugIn();
    emit panel.window().connectRequested(sim.terminal(), 115'200, false);
    EXPECT_TRUE(stops());
}

void trigger(MainWindow& window, const char* action) {
    window.findChild<QAction*>(QLatin1String(action))->trigger();
}

INSTANTIATE_TEST_SUITE_P(
    U10, StopWhile,
    testing::Values(
        Open{"TheRestartIsAskedAbout", [](MainWindow& w) { trigger(w, "restartNetworkAction"); }},
        Open{"ClosingIsAskedAbout", [](MainWindow& w) { w.close(); }},
        Open{"AFileIsChosen", [](MainWindow& w) { trigger(w, "openMachineAction"); }},
        Open{"AMenuIsOpen",
             [](MainWindow& w) {
                 w.findChild<QMenu*>(QStringLiteral("viewMenu"))->popup(w.mapToGlobal(QPoint(20, 40)));
             }},
        Open{"AListIsOpen",
             [](MainWindow& w) { w.findChild<QComboBox*>(QStringLiteral("scopeWindowBox"))->showPopup(); }}),
    [](const auto& open) { return std::string(open.param.name); });

/// When Esc is pressed.
enum class Pressed { BeforeThePortGoes, BeforeThePanelKnows, OnceThePanelKnows, AfterAFailedRetry };

class StopOnALostLine : public testing::TestWithParam<Pressed> {};

TEST_P(StopOnALostLine, StopsTheMotorOnceTheLineIsBack) {
    const Pressed when = GetParam();
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    if (when == Pressed::BeforeThePortGoes)
        panel.pressEsc();
    sim.unplug();
    if (when == Pressed::BeforeThePanelKnows)
        panel.pressEsc();
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("was unplugged")) == 1; }));
    ASSERT_TRUE(moves(sim));
    const QString waits = QStringLiteral("No stop can be sent now");
    if (when == Pressed::AfterAFailedRetry) {
        panel.askFor(sim.terminal());
        ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    }
    if (when == Pressed::OnceThePanelKnows || when == Pressed::AfterAFailedRetry) {
        panel.pressEsc();
        EXPECT_NE(panel.standing(waits), nullptr);
    }
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_EQ(panel.count(QStringLiteral("Bd. Modules 1 and 2 were commanded to stop.")), 1);
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("Module 1 has stopped.")) == 1; }));
    EXPECT_TRUE(panel.module().servoOn()) << "it holds";
    EXPECT_EQ(panel.standing(waits), nullptr);
}
INSTANTIATE_TEST_SUITE_P(PortGone, StopOnALostLine,
                         testing::Values(Pressed::BeforeThePortGoes, Pressed::BeforeThePanelKnows,
                                         Pressed::OnceThePanelKnows, Pressed::AfterAFailedRetry));

TEST(LostLine, StopsTheMotorAfterAnotherPortWasOpenMeanwhile) {
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualChain other{QStringLiteral("servo")};
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    panel.pressEsc();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(other.terminal()));
    EXPECT_EQ(panel.count(QStringLiteral("were commanded to stop")), 0) << "nobody stopped these";
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST(LostLine, StopsTheMotorOnlyOnceCommandsAreAllowedAgain) {
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    panel.pressEsc();
    sim.plugIn();
    emit panel.window().connectRequested(sim.terminal(), 115'200, true);
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_TRUE(moves(sim)) << "nothing is sent";
    const QString waits = QStringLiteral("No stop can be sent now");
    EXPECT_NE(panel.standing(waits), nullptr);
    EXPECT_EQ(panel.standing(QStringLiteral("was unplugged")), nullptr);
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_EQ(panel.standing(waits), nullptr);
}

/// The module was given another address in this connection.
TEST(LostLine, StopsAModuleAtItsPresentAddress) {
    VirtualChain sim{QStringLiteral("servo")};
    VirtualPanel panel;
    panel.composition().show({sim.terminal(), 115'200, false});
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    panel.composition().worker().ask(Readdress{ModuleIndex(0), BusAddress(9)});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().info.address == BusAddress(9); }));
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    sim.unplug();
    panel.pressEsc();
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("was unplugged")) == 1; }));
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST(LostLine, LeavesAMotorRunningThatNobodyStopped) {
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_TRUE(moves(sim));
    EXPECT_EQ(panel.count(QStringLiteral("commanded to stop")), 0);
}

}  // namespace
}  // namespace nmc
