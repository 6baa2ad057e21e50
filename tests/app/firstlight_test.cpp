// SPDX-License-Identifier: GPL-3.0-or-later
// The program's main job, through its window and by object name: find a chain, set gains, enable, go to a
// position, and stop with Esc - on the simulator in this process, and over a pseudo-terminal that nmcsim
// serves.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/composition.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/turnto.h"
#include "widgets/panels/holdbutton.h"

namespace nmc {
namespace {

using testing_support::NmcsimProcess;

/// The whole program without main(), with settings of its own.
class Panel {
public:
    Panel()
        : m_settings(m_directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat),
          m_composition(m_settings) {}

    void start(const QString& port, std::uint32_t baud) { m_composition.show({port, baud, false}); }

    template <typename Widget = QWidget>
    Widget& find(const char* name) {
        auto* widget = m_composition.window().findChild<Widget*>(QLatin1String(name));
        if (widget == nullptr)
            throw std::runtime_error(std::string("there is no ") + name);
        testing_support::turnTo(*widget);
        return *widget;
    }
    void type(const char* field, const QString& text) {
        auto& edit = find<QLineEdit>(field);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        EXPECT_EQ(edit.text(), text) << field << " visible " << edit.isVisible() << " enabled "
                                     << edit.isEnabled();
    }
    void click(const char* button) {
        auto& widget = find<QAbstractButton>(button);
        ASSERT_TRUE(widget.isEnabled()) << button << ": " << widget.toolTip().toStdString();
        QTest::mouseClick(&widget, Qt::LeftButton);
    }
    /// On the mark itself: a check box as wide as its row is not one all over.
    void tick(const char* box) {
        auto& widget = find<QAbstractButton>(box);
        QTest::mouseClick(&widget, Qt::LeftButton, {}, {widget.height() / 2, widget.height() / 2});
    }
    bool waitUntilEnabled(const char* button) {
        return QTest::qWaitFor([&] { return find<QAbstractButton>(button).isEnabled(); }, 20'000);
    }
    void selectModule(int row) {
        auto& list = find<QAbstractItemView>("chainList");
        list.setCurrentIndex(list.model()->index(row, 0));
    }
    template <typename Predicate>
    bool waitFor(Predicate predicate, int patienceMs = 20'000) {
        return QTest::qWaitFor(predicate, patienceMs);
    }
    [[nodiscard]] std::size_t modules() const { return m_composition.store().link().modules.size(); }
    [[nodiscard]] const ModuleState& module(std::uint8_t index) const {
        return *m_composition.store().module(ModuleIndex(index));
    }
    [[nodiscard]] const ModuleHistory& history(std::uint8_t index) const {
        return *m_composition.store().history().module(ModuleIndex(index));
    }
    [[nodiscard]] bool found(std::size_t count) const {
        return m_composition.store().link().phase == LinkPhase::Connected && modules() == count;
    }
    MainWindow& window() { return m_composition.window(); }

    void setGainsAndEnable() {
        const std::pair<const char*, int> gains[] = {{"kpField", 200},   {"kdField", 2'000}, {"kiField", 20},
                                                     {"ilField", 200},   {"olField", 255},   {"clField", 0},
                                                     {"elField", 8'000}, {"srField", 1},     {"dbField", 0}};
        for (const auto& [field, value] : gains)
            type(field, QString::number(value));
        ASSERT_TRUE(waitUntilEnabled("applyGainsButton"))
            << find<QAbstractButton>("applyGainsButton").toolTip().toStdString();
        click("applyGainsButton");
        ASSERT_TRUE(waitUntilEnabled("enableButton"));
        click("enableButton");
        ASSERT_TRUE(waitUntilEnabled("goButton"));
    }
    void goTo(int counts) {
        type("goalField", QString::number(counts));
        type("velocityField", QStringLiteral("8"));
        type("accelerationField", QStringLiteral("0.02"));
        click("goButton");
    }
    /// 20 000 counts at 8 counts/tick and 0.02 counts/tick^2, and back again half-way, where Esc stops it.
    void moveAndStop() {
        goTo(20'000);
        ASSERT_TRUE(waitFor([&] { return module(1).activity() == Activity::AtSpeed; }));
        ASSERT_TRUE(waitFor(
            [&] { return !module(1).moving() && std::abs(*module(1).latest->position - 20'000) <= 5; }));
        ASSERT_TRUE(waitUntilEnabled("goButton"));
        goTo(0);
        ASSERT_TRUE(waitFor([&] { return module(1).activity() == Activity::AtSpeed; }));
        QTest::keyClick(&find<QLineEdit>("goalField"), Qt::Key_Escape);
        ASSERT_TRUE(waitFor([&] {
            return find<QLabel>("stopResultLabel").text().contains(QLatin1String("stopped and holding"));
        }));
        ASSERT_TRUE(waitFor([&] { return module(1).activity() == Activity::Holding; }));
        EXPECT_GT(*module(1).latest->position, 1'000);
    }
    /// The trace rises from 0 to the goal, and the calculated error settles with the motor.
    void expectHonestTraces() {
        double highest = 0;
        int all = 0;
        int small = 0;
        double worst = 0;
        for (const ScopeSample& sample : history(1).samples(TimePoint::min(), TimePoint::max())) {
            highest = std::max(highest, static_cast<double>(sample.position));
            if (!sample.errorKnown())
                continue;
            const double error = std::abs(static_cast<double>(sample.error));
            ++all;
            small += error < 60 ? 1 : 0;
            worst = std::max(worst, error);
        }
        EXPECT_NEAR(highest, 20'000, 50);
        // With these gains the motor lags some 25 counts at 8 counts/tick, and the sample's own time is
        // uncertain by half a tick, which is another 4. A machine that is busy with something else delays a
        // byte now and then, and such a sample is off by as much as the motor went meanwhile.
        EXPECT_GT(all, 100);
        EXPECT_GT(small, all * 9 / 10);
        EXPECT_GT(worst, 5);
    }

private:
    QTemporaryDir m_directory;
    QSettings m_settings;
    Composition m_composition;
};

TEST(FirstLight, MovesAMotorOfTheBuiltInSimulator) {
    Panel panel;
    panel.start(QStringLiteral("simulator=servo,servo,servo@1"), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(3); }));
    EXPECT_EQ(panel.module(2).info.identity.version, 1);
    EXPECT_TRUE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    panel.selectModule(1);
    panel.setGainsAndEnable();
    if (HasFatalFailure())
        return;
    panel.moveAndStop();
    panel.expectHonestTraces();
}

TEST(FirstLight, TheSimulatorDockSetsTheBenchWhileItRuns) {
    Panel panel;
    panel.start(QStringLiteral("simulator=servo,servo"), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(2); }));
    panel.selectModule(1);
    ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>("sim_servo_powerBox").isChecked(); }))
        << "as shipped the motor has its power";
    panel.tick("sim_servo_limit1Box");
    EXPECT_TRUE(panel.waitFor([&] { return panel.module(1).latest->servoStatus().limit1(); }));
    EXPECT_TRUE(
        panel.waitFor([&] { return panel.find<QLabel>("bit_limit1").text() == QLatin1String("on"); }));
    EXPECT_FALSE(panel.module(0).latest->servoStatus().limit1());
    panel.tick("sim_servo_powerBox");
    EXPECT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::NoPower; }));
    EXPECT_TRUE(panel.waitFor(
        [&] { return panel.find<QLabel>("simAnswerHead").text() == QLatin1String("Done: set 2 power 0"); }));
    EXPECT_NE(panel.module(0).activity(), Activity::NoPower);
}

class FirstLightOnATerminal : public testing::TestWithParam<std::uint32_t> {};

TEST_P(FirstLightOnATerminal, MovesAMotorWithoutAViolation) {
    NmcsimProcess sim(QStringLiteral("servo,servo,servo@1"));
    Panel panel;
    panel.start(sim.terminal(), GetParam());
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(3); }));
    EXPECT_TRUE(panel.window().windowTitle().startsWith(QLatin1String("NMC Panel")));
    EXPECT_FALSE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    panel.selectModule(1);
    panel.setGainsAndEnable();
    if (HasFatalFailure())
        return;
    panel.moveAndStop();
    panel.expectHonestTraces();
    const QJsonObject state = sim.state(2);
    EXPECT_TRUE(state[QStringLiteral("servo_on")].toBool());
    EXPECT_EQ(state[QStringLiteral("gains")].toObject()[QStringLiteral("kd")].toInt(), 2'000);
    EXPECT_FALSE(sim.state(1)[QStringLiteral("servo_on")].toBool());
    EXPECT_EQ(sim.violations(), "");
}

INSTANTIATE_TEST_SUITE_P(Rates, FirstLightOnATerminal, testing::Values(19'200U, 115'200U));

TEST(FirstLight, HoldToMoveMovesOnlyWhileItIsHeld) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    Panel panel;
    panel.start(sim.terminal(), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(2); }));
    panel.selectModule(1);
    panel.setGainsAndEnable();
    auto& button = panel.find<QAbstractButton>("holdForwardButton");
    QTest::mousePress(&button, Qt::LeftButton);
    // At 0.25 counts/tick the 250 ms that one press alone lasts are 122 counts: the window must have re-armed
    // it.
    EXPECT_TRUE(panel.waitFor([&] { return *panel.module(1).latest->position > 200; }));
    QTest::mouseRelease(&button, Qt::LeftButton);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(1).activity() == Activity::Holding; }));
    EXPECT_EQ(sim.violations(), "");
}

TEST(FirstLight, AHoldThatEndedInAStallIsOverUntilTheButtonWasUp) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    Panel panel;
    panel.start(sim.terminal(), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(2); }));
    panel.selectModule(0);
    panel.setGainsAndEnable();
    auto& button = panel.find<HoldButton>("holdForwardButton");
    const auto moving = [&] { return sim.state(1)[QStringLiteral("command_velocity")].toDouble() != 0.0; };
    QTest::mousePress(&button, Qt::LeftButton);
    ASSERT_TRUE(panel.waitFor(moving));
    // The window does not turn its event loop until the bus has ended the hold: the button is still down.
    QTimer::singleShot(0, &button, [&] {
        QElapsedTimer patience;
        patience.start();
        while (moving() && patience.elapsed() < 20'000) {
        }
    });
    ASSERT_TRUE(panel.waitFor([&] { return !button.isHeld(); })) << "it shows that it is not held any more";
    EXPECT_FALSE(button.isDown());
    const TimePoint until = panel.module(0).latestTime + std::chrono::seconds(1);
    bool movedAgain = false;
    ASSERT_TRUE(panel.waitFor([&] {
        movedAgain = movedAgain || moving();
        return panel.module(0).latestTime >= until;
    }));
    EXPECT_FALSE(movedAgain);
    QTest::mouseRelease(&button, Qt::LeftButton);
    QTest::mousePress(&button, Qt::LeftButton);
    EXPECT_TRUE(panel.waitFor(moving)) << "pressed anew";
    QTest::mouseRelease(&button, Qt::LeftButton);
    EXPECT_TRUE(panel.waitFor([&] { return !moving(); }));
}

TEST(FirstLight, AClosedTerminalIsSaidAndTheSimulatorIsOneClickAway) {
    Panel panel;
    {
        NmcsimProcess sim(QStringLiteral("servo"));
        panel.start(sim.terminal(), 19'200);
        ASSERT_TRUE(panel.waitFor([&] { return panel.found(1); }));
    }
    ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>("connectButton").isEnabled(); }));
    EXPECT_TRUE(panel.find<QLabel>("bannerHeadline").text().contains(QLatin1String("/dev/pts/")));
    EXPECT_EQ(panel.modules(), 0U);
}

TEST(FirstLight, AChainThatHasBecomeShorterIsSaid) {
    const QString link = QStringLiteral("/tmp/nmc-shorter-%1").arg(QCoreApplication::applicationPid());
    Panel panel;
    for (const int modules : {3, 2}) {
        const QString chain = QStringList(modules, QStringLiteral("servo")).join(QLatin1Char(','));
        NmcsimProcess sim(chain, {QStringLiteral("--link"), link});
        panel.start(link, 115'200);
        ASSERT_TRUE(panel.waitFor([&] { return panel.found(static_cast<std::size_t>(modules)); }));
        panel.click("disconnectButton");
        ASSERT_TRUE(panel.waitFor([&] { return panel.modules() == 0; }));
    }
    EXPECT_TRUE(
        panel.find<QLabel>("bannerHeadline").text().contains(QLatin1String("2 of 3 modules answered")))
        << panel.find<QLabel>("bannerHeadline").text().toStdString();
}

TEST(FirstLight, NobodyAnsweringIsSaidWithWhatToDo) {
    NmcsimProcess sim(QStringLiteral("servo"),
                      {QStringLiteral("--reset-dead-time"), QStringLiteral("10000")});
    ASSERT_TRUE(sim.control(QStringLiteral("power-cycle all"))[QStringLiteral("ok")].toBool());
    Panel panel;
    panel.start(sim.terminal(), 19'200);
    ASSERT_TRUE(panel.waitFor([&] {
        return panel.find<QLabel>("bannerHeadline").text().contains(QLatin1String("no module answered"));
    }));
    EXPECT_TRUE(panel.find<QAbstractButton>("bannerAction_scanAgain").isEnabled());
    EXPECT_TRUE(panel.find<QAbstractButton>("bannerAction_useSimulator").isEnabled());
    // The simulator is one click away.
    panel.click("bannerAction_useSimulator");
    EXPECT_TRUE(panel.waitFor([&] { return panel.found(3); }));
}

}  // namespace
}  // namespace nmc
