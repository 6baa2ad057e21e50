// SPDX-License-Identifier: GPL-3.0-or-later
// What a user sees who runs the program for the first time: what to connect to, and how to make the motor
// move.
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/panels/holdbutton.h"
#include "windowtest.h"

namespace nmc {
namespace {

class StartPageTest : public WindowTest {
protected:
    QSignalSpy connects{window.get(), &MainWindow::connectRequested};
    QString needs(const QString& choice) { return text(choice + u"Needs"_s); }
};

TEST_F(StartPageTest, OffersPortAndSimulatorEachWithWhatItNeeds) {
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, u"FT232R"_s}});
    EXPECT_TRUE(button(u"startSerialButton"_s)->isVisible());
    EXPECT_EQ(text(u"startSerialButtonTitle"_s), u"Connect to /dev/ttyUSB0"_s);
    EXPECT_TRUE(needs(u"startSerialButton"_s).contains(u"FT232R, 115 200 Bd"_s));
    EXPECT_TRUE(needs(u"startSerialButton"_s).contains(u"powered"_s));
    EXPECT_TRUE(needs(u"startSimulatorButton"_s).contains(u"no hardware"_s));
    EXPECT_EQ(button(u"startSimulatorButton"_s)->accessibleName(), u"Start the simulator"_s);
    EXPECT_EQ(button(u"startSimulatorButton"_s)->accessibleDescription(), needs(u"startSimulatorButton"_s));
}

TEST_F(StartPageTest, ConnectsToWhatItSays) {
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}, {u"/dev/ttyS0"_s, {}}});
    EXPECT_TRUE(needs(u"startSerialButton"_s).contains(u"Other ports"_s));
    click(u"startSerialButton"_s);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.takeFirst(), (QVariantList{u"/dev/ttyUSB0"_s, 115200U, false}));
    click(u"startSimulatorButton"_s);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.takeFirst(), (QVariantList{u"simulator"_s, 115200U, false}));
}

TEST_F(StartPageTest, TakesPortAndRateFromTheListAbove) {
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}, {u"/dev/ttyS0"_s, {}}});
    auto* ports = find<QComboBox>(u"portBox"_s);
    ports->setFocus();
    QTest::keyClick(ports, Qt::Key_Down);
    auto* rates = find<QComboBox>(u"baudBox"_s);
    rates->setFocus();
    QTest::keyClick(rates, Qt::Key_Home);
    EXPECT_EQ(text(u"startSerialButtonTitle"_s), u"Connect to /dev/ttyS0"_s);
    button(u"startSerialButton"_s)->setFocus();
    QTest::keyClick(button(u"startSerialButton"_s), Qt::Key_Space);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.at(0).at(0), u"/dev/ttyS0"_s);
    EXPECT_EQ(connects.at(0).at(1), rates->currentData());
    EXPECT_TRUE(needs(u"startSerialButton"_s).contains(u" Bd"_s));
}

/// The user may know a path that is not listed.
TEST_F(StartPageTest, WithoutAnyPortSaysSoAndOpensTheList) {
    window->connectionBar().showPorts({});
    EXPECT_TRUE(needs(u"startSerialButton"_s).contains(u"No serial port found"_s));
    click(u"startSerialButton"_s);
    EXPECT_TRUE(connects.isEmpty());
    QWidget* list = QApplication::activePopupWidget();
    ASSERT_NE(list, nullptr);
    list->close();
    window->connectionBar().showPorts({{u"/dev/ttyUSB3"_s, {}}});
    EXPECT_EQ(text(u"startSerialButtonTitle"_s), u"Connect to /dev/ttyUSB3"_s)
        << "it was plugged in in the meantime";
}

TEST_F(StartPageTest, KeepsTheSimulatedChainThatWasAskedFor) {
    window->connectionBar().choosePort(u"simulator=servo,io"_s, 0);
    click(u"startSimulatorButton"_s);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.at(0).at(0), u"simulator=servo,io"_s);
}

TEST_F(StartPageTest, IsGoneWhileAPortIsOpen) {
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}});
    showServo();
    EXPECT_FALSE(find(u"startPage"_s)->isVisible());
    window->showLink({});
    EXPECT_TRUE(find(u"startPage"_s)->isVisible());
    LinkState connecting;
    connecting.phase = LinkPhase::Connecting;
    window->showLink(connecting);
    EXPECT_FALSE(find(u"startPage"_s)->isVisible());
}

TEST_F(StartPageTest, IsWholeInASmallWindow) {
    window->connectionBar().showPorts({{u"/dev/serial/by-id/usb-FTDI_FT232R_USB_UART_A9007UX1-if00-port0"_s,
                                        u"FTDI FT232R USB UART, on the machine's left side"_s}});
    window->resize(800, 600);
    for (int i = 0; i < 5; ++i)
        QApplication::processEvents();
    for (const QString& name : {u"startSerialButton"_s, u"startSimulatorButton"_s}) {
        const auto* choice = button(name);
        EXPECT_GE(choice->height(), choice->heightForWidth(choice->width())) << name.toStdString();
        EXPECT_FALSE(choice->visibleRegion().isEmpty()) << name.toStdString();
    }
}

// ---- from gains to motion ----

class FirstStepsTest : public WindowTest {
protected:
    FirstStepsTest() {
        // Reports the outcome of an intent, as the program does.
        QObject::connect(&window->requests(), &Requests::intent, window.get(),
                         [this](ModuleIndex, const Intent& intent) {
                             if (const auto* apply = std::get_if<intent::ApplyGains>(&intent))
                                 module.apply(executed(apply->gains));
                         });
        show();
    }
    [[nodiscard]] static bus::CommandExecuted executed(const ServoCommand& command) {
        return {ModuleIndex(0), TimePoint(std::chrono::milliseconds(1500)), command};
    }
    void show() { window->showLink(connectedTo({module})); }
    void switchOn() {
        module.apply(executed(servo::StopMotor{true, servo::StopManner::Abruptly, {}}));
        for (const int millisecond : {1600, 1610, 1620}) {
            bus::Sample sample;
            sample.module = ModuleIndex(0);
            sample.time = TimePoint(std::chrono::milliseconds(millisecond));
            sample.report.status = 0x09;  // move done, power (DS-V 5.3)
            sample.report.aux = std::uint8_t(0x04);
            module.apply(sample);
        }
        show();
    }
    void run() {
        servo::LoadTrajectory load;
        load.velocity = CountsPerTick(1000);
        load.acceleration = CountsPerTickSquared(100);
        load.profile = servo::ProfileMode::Velocity;
        load.startNow = true;
        module.apply(executed(load));
        show();
    }
    /// Docks make room for the page, and the page for its strip.
    static void settle() {
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
    }
    bool stripIsThere() { return window->findChild<QWidget*>(u"firstSteps"_s)->isVisible(); }
    /// The step with the arrow, of which there is only one.
    QString next() {
        QString found;
        for (int i = 1; i <= 4; ++i)
            if (const QString words = text(u"firstStep%1"_s.arg(i)); words.startsWith(u'▸')) {
                EXPECT_TRUE(found.isEmpty());
                found = words;
            }
        return found;
    }
    ModuleState module = Servo{.on = false, .gains = false}.state();
};

TEST_F(FirstStepsTest, LeadFromUnknownGainsToAMotionAndAreGone) {
    EXPECT_EQ(next(), u"▸ 1. Fill in gains"_s);
    click(u"fillGainsButton"_s);
    EXPECT_EQ(next(), u"▸ 2. Apply gains"_s);
    EXPECT_EQ(text(u"firstStep1"_s), u"✓ Fill in gains"_s);
    click(u"applyGainsButton"_s);
    show();
    EXPECT_EQ(next(), u"▸ 3. Enable servo"_s);
    switchOn();
    EXPECT_EQ(next(), u"▸ 4. Jog"_s);
    run();
    EXPECT_FALSE(stripIsThere());
}

TEST_F(FirstStepsTest, MoveNothingUnderThePointerWhenTheyGo) {
    window->resize(900, 640);
    settle();
    click(u"fillGainsButton"_s);
    click(u"applyGainsButton"_s);
    switchOn();
    auto* hold = find(u"holdForwardButton"_s);
    settle();
    const QPoint before = hold->mapToGlobal(QPoint());
    run();
    settle();
    ASSERT_FALSE(stripIsThere());
    EXPECT_EQ(hold->mapToGlobal(QPoint()), before);
    // Nobody presses anything while the window is being resized.
    auto* page = window->findChild<QWidget*>(u"panelScroll"_s);
    const int low = page->height();
    window->resize(901, 640);
    settle();
    EXPECT_GT(page->height(), low);
}

TEST_F(FirstStepsTest, ComeBackWhenTheModuleHasLostItsGains) {
    click(u"fillGainsButton"_s);
    click(u"applyGainsButton"_s);
    switchOn();
    run();
    module.restarted();
    module.hasRestarted = false;
    show();
    EXPECT_EQ(next(), u"▸ 2. Apply gains"_s) << "the fields still contain them";
}

TEST_F(FirstStepsTest, ShowWhereTheNextIsDone) {
    find<QTabWidget>(u"servoPages"_s)->setCurrentIndex(3);
    const auto* fill = window->findChild<QWidget*>(u"fillGainsButton"_s);
    EXPECT_FALSE(fill->isVisible());
    QSignalSpy intents(&window->requests(), &Requests::intent);
    QTest::mouseClick(window->findChild<QWidget*>(u"firstStepButton"_s), Qt::LeftButton);
    EXPECT_TRUE(fill->isVisible());
    EXPECT_TRUE(eventually([fill] { return QToolTip::text() == fill->toolTip(); }));
    EXPECT_TRUE(intents.isEmpty());
}

TEST_F(FirstStepsTest, ScrollToWhereTheNextIsDone) {
    window->resize(1'280, 540);
    click(u"fillGainsButton"_s);
    settle();
    const auto* apply = find(u"applyGainsButton"_s);
    for (QScrollArea* area : window->findChildren<QScrollArea*>())
        area->verticalScrollBar()->setValue(0);
    ASSERT_NE(apply->visibleRegion(), QRegion(apply->rect())) << "otherwise there is nothing to scroll";
    QTest::mouseClick(window->findChild<QWidget*>(u"firstStepButton"_s), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return apply->visibleRegion() == QRegion(apply->rect()); }));
}

TEST_F(FirstStepsTest, AreNotForWhoMayOnlyLook) {
    EXPECT_TRUE(stripIsThere());
    LinkState link = connectedTo({module});
    link.readOnly = true;
    link.modules[0].readOnly = true;
    window->showLink(link);
    EXPECT_FALSE(stripIsThere());
}

TEST_F(FirstStepsTest, AreNotForAServoThatHasMoved) {
    module = Servo{}.state();
    run();
    EXPECT_FALSE(stripIsThere());
}

/// In a window of its initial size, with all its bars.
TEST_F(FirstStepsTest, NeedNoScroll) {
    window->resize(1456, 952);
    LinkState link = connectedTo({module});
    link.simulated = true;
    window->showLink(link);
    settle();
    for (const char* name : {"kpField", "fillGainsButton", "applyGainsButton", "enableButton",
                             "holdForwardButton", "firstStepButton"}) {
        const auto* widget = window->findChild<QWidget*>(QLatin1String(name));
        EXPECT_EQ(widget->visibleRegion().boundingRect(), widget->rect()) << name;
    }
}

TEST_F(FirstStepsTest, NameTheNextOneOnlyBesidePlots) {
    QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
    for (int i = 0; i < 5; ++i)
        QApplication::processEvents();
    EXPECT_TRUE(find(u"firstStep1"_s)->isVisible());
    EXPECT_FALSE(window->findChild<QWidget*>(u"firstStep2"_s)->isVisible());
    EXPECT_TRUE(find(u"firstSteps"_s)->accessibleDescription().contains(u"Step 1 of 4: Fill in gains"_s));
}

}  // namespace
}  // namespace nmc
