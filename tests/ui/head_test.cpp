// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown above everything else of a module, whatever is scrolled or selected below it.
#include "tests/model/stepperfixture.h"
#include "widgets/chain/chainmodel.h"
#include "windowtest.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;

using testing_support::Stepper;

class Head : public WindowTest {
protected:
    ModuleState turning(int countsPer100Ms) {
        ModuleState module = Servo{.moveDone = false}.state();
        for (int i = 1; i <= 3; ++i) {
            bus::Sample sample{module.info.index, TimePoint(std::chrono::milliseconds(1000 + 100 * i)),
                               *module.latest};
            sample.report.position = countsPer100Ms * i;
            module.apply(sample);
        }
        return module;
    }
    QString listed() {
        return find<QListView>(u"chainList"_s)
            ->model()
            ->index(0, 0)
            .data(ChainModel::ActivityText)
            .toString();
    }
};

TEST_F(Head, StaysInViewWhereThePageScrolls) {
    window->resize(800, 600);
    showServo();
    auto* bar = find<QScrollArea>(u"panelScroll"_s)->verticalScrollBar();
    bar->setValue(bar->maximum());
    EXPECT_GT(bar->maximum(), 0);
    for (const QString& name : {u"stateLabel"_s, u"positionLabel"_s, u"velocityLabel"_s,
                                u"stopSmoothlyButton"_s, u"motorOffButton"_s})
        EXPECT_FALSE(find(name)->visibleRegion().isEmpty()) << name.toStdString();
}

/// True if not one pixel of it is cut off, by the window or by a scroll area.
bool isWhole(const QWidget& widget) {
    return widget.visibleRegion().boundingRect() == widget.rect() &&
           widget.width() >= widget.sizeHint().width();
}

TEST_F(Head, AllMotionsAreInViewOnASmallLaptop) {
    window->resize(1280, 800);
    showServo();
    for (int i = 0; i < 5; ++i)
        QApplication::processEvents();
    for (const QString& name : {u"goButton"_s, u"goHomeButton"_s, u"runForwardButton"_s,
                                u"runReverseButton"_s, u"holdForwardButton"_s, u"holdReverseButton"_s,
                                u"moveByForwardButton"_s, u"moveByReverseButton"_s, u"moveByEndButton"_s})
        EXPECT_TRUE(isWhole(*find(name))) << name.toStdString();
}

TEST_F(Head, TheScopeGetsBackWhatItGaveToTheMotions) {
    const auto settle = [] {
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
    };
    window->resize(1456, 952);
    showServo();
    settle();
    const int high = find(u"scopeDock"_s)->height();
    window->resize(1456, 720);
    settle();
    EXPECT_LT(find(u"scopeDock"_s)->height(), high);
    window->resize(1456, 952);
    settle();
    EXPECT_GE(find(u"scopeDock"_s)->height(), high);
}

TEST_F(Head, NothingThatStopsOrTellsIsCutInTheSmallestWindow) {
    window->resize(800, 600);
    showServo();
    window->showFigures({.exchangesPerSecond = 1'234,
                         .wireShare = 0.98,
                         .errorsPerSecond = 12.5,
                         .errors = 1234567,
                         .meanRoundTripMs = 12.5});
    for (int i = 0; i < 5; ++i)
        QApplication::processEvents();
    EXPECT_LE(window->width(), 800);
    EXPECT_TRUE(isWhole(*find(u"stopAllButton"_s)));
    for (const QString& name : {u"rateLabel"_s, u"errorLabel"_s, u"roundTripLabel"_s})
        EXPECT_TRUE(!find(name)->isVisible() || isWhole(*find(name))) << name.toStdString();
    EXPECT_TRUE(find(u"rateLabel"_s)->isVisible());
    // In such a window, the motions have their own page, which is the first.
    EXPECT_TRUE(find(u"goButton"_s)->isVisible());
    EXPECT_EQ(find<QTabWidget>(u"servoPages"_s)->currentIndex(), 0);
}

TEST_F(Head, SaysHowFastTheShaftTurnsInTheUsersUnit) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 100.0, {}};
    window->showMachine(machine);
    window->showLink(connectedTo({turning(-250)}));  // -2500 counts/s
    EXPECT_EQ(text(u"velocityLabel"_s), u"\u221225.0 mm/s"_s);
}

TEST_F(Head, SaysNoSpeedOfWhatDoesNotAnswer) {
    ModuleState module = turning(250);
    module.silent = true;
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"velocityLabel"_s), u"–"_s);
}

TEST_F(Head, ShowsLimitsAndPower) {
    ModuleState module = Servo{}.state();
    module.latest->status |= 0x20;  // limit 1 (DS-V 5.3)
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"headLimit1"_s), u"Limit 1 high"_s);
    EXPECT_EQ(text(u"headLimit2"_s), u"Limit 2 low"_s);
    EXPECT_EQ(text(u"headPower"_s), u"Power"_s);
    showServo({.power = false});
    EXPECT_EQ(text(u"headPower"_s), u"No power"_s);
}

TEST_F(Head, ShowsNoLimitWhereThePinIsAnOutput) {
    ModuleState module = Servo{}.state();
    module.io = servo::IoControl{.limit1IsInput = false};
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"headLimit1"_s), u"Limit 1 –"_s);
}

/// In a chain that was found running, another host may have made it one (DS-V 5.2).
TEST_F(Head, ShowsNoLimitWhereThePinMayBeAnOutput) {
    ModuleState module = Servo{}.state();
    module.latest->status |= 0x20;  // limit 1 (DS-V 5.3)
    module.attached();
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"headLimit1"_s), u"Limit 1 –"_s);
    EXPECT_EQ(text(u"headLimit2"_s), u"Limit 2 –"_s);
    module.apply(
        bus::CommandExecuted{module.info.index, module.latestTime, ServoCommand(servo::IoControl{})});
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"headLimit1"_s), u"Limit 1 high"_s);
    EXPECT_EQ(text(u"headLimit2"_s), u"Limit 2 low"_s);
}

TEST_F(Head, ShowsAnArmedLimitStop) {
    ModuleState module = Servo{}.state();
    servo::SetHoming arm;
    arm.onLimit1Change = true;
    arm.stopAbruptly = true;
    module.apply(bus::CommandExecuted{module.info.index, module.latestTime, ServoCommand(arm)});
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"headLimitStop"_s), u"● Limit stop armed"_s);
}

TEST_F(Head, AndTheListShowARunningProcedure) {
    showServo();
    ProcedureReport report;
    report.stage = ProcedureStage::Searching;
    window->showProcedure(report);
    EXPECT_TRUE(text(u"procedureLabel"_s).contains(u"Searching"_s));
    EXPECT_TRUE(listed().startsWith(u"Searching"_s)) << listed().toStdString();
    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    EXPECT_TRUE(text(u"procedureLabel"_s).isEmpty());
    EXPECT_FALSE(listed().startsWith(u"Searching"_s));
}

TEST_F(Head, OfAStepperShowsItsInputs) {
    Stepper stepper = Stepper::holding();
    stepper.module.latest->aux = std::uint8_t{0x08};  // limit 1 (DS-S 5.2)
    window->showLink(connectedTo({stepper.module}));
    EXPECT_EQ(text(u"stepperHeadLimit1"_s), u"Limit 1 high"_s);
    EXPECT_EQ(text(u"stepperHeadLimit2"_s), u"Limit 2 low"_s);
}

TEST_F(Head, AndTheListKeepTheLastPositionStruckOutWhenTheAdapterIsUnplugged) {
    const ModuleState module = Servo{.position = 1234}.state();
    window->showLink(connectedTo({module}));
    LinkState gone;
    gone.port = "/dev/ttyUSB0";
    gone.unplugged = true;
    window->showLink(gone);
    EXPECT_EQ(text(u"positionLabel"_s), u"1\u202f234"_s);
    EXPECT_TRUE(find<QLabel>(u"positionLabel"_s)->font().strikeOut());
    const QAbstractItemModel* list = find<QListView>(u"chainList"_s)->model();
    EXPECT_EQ(list->index(0, 0).data(ChainModel::Position).toString(), u"1\u202f234"_s);
    EXPECT_TRUE(list->index(0, 0).data(ChainModel::PositionIsOld).toBool());
    EXPECT_FALSE(button(u"stopSmoothlyButton"_s)->isEnabled());
    window->showTime(module.latestTime + std::chrono::milliseconds(1300));
    EXPECT_EQ(text(u"positionUnit"_s), u"counts, 1.3 s old"_s);
    window->showTime(module.latestTime + std::chrono::milliseconds(2300));
    EXPECT_EQ(text(u"positionUnit"_s), u"counts, 2.3 s old"_s);
    // The next connection knows nothing about it.
    LinkState next;
    next.port = "/dev/ttyUSB0";
    next.phase = LinkPhase::Connecting;
    window->showLink(next);
    EXPECT_EQ(window->selectedModule(), std::nullopt);
}

TEST_F(Head, AServoThatHoldsAndSwingsSaysSo) {
    ModuleState module = Servo{.held = true}.state();
    // 12.5 Hz; the sine in a square wave of 8 samples is 1 / (2 sin 22.5 degrees) = 1.31 of its height.
    for (int i = 0; i < 200; ++i) {
        bus::Sample sample{module.info.index, TimePoint(std::chrono::milliseconds(2'000 + 10 * i)),
                           *module.latest};
        sample.report.position = i % 8 < 4 ? 200 : -200;
        module.apply(sample);
    }
    window->showLink(connectedTo({module}));
    const QString said = text(u"stateMeaning"_s);
    const QRegularExpression words(u"^Oscillating ± (\\d+) counts at about ([\\d.]+) Hz$"_s);
    const auto numbers = words.match(said);
    ASSERT_TRUE(numbers.hasMatch()) << said.toStdString();
    EXPECT_NEAR(numbers.captured(1).toDouble(), 261, 5);
    EXPECT_NEAR(numbers.captured(2).toDouble(), 12.5, 0.6);
    EXPECT_TRUE(listed().contains(u"Holding, oscillating"_s)) << listed().toStdString();
}

/// Held at 0 by Kp 100 and an integral of Ki 80, IL 50: at 24 counts this requires (2400 + 4000) / 256 = 25
/// PWM counts, at 400 counts 171.
TEST_F(Head, SaysHowFarAServoIsOffThePositionItShouldHold) {
    const auto standAt = [this](std::int32_t position, std::uint8_t ol) {
        ModuleState module = Servo{.held = true}.state();
        module.gains = servo::SetGain{100, 1'000, 80, 50, ol, 0, 4'000, 1, std::uint8_t{0}};
        const TimePoint from = module.latestTime + SwingWatch::kCalm;
        for (int i = 0; i < 3; ++i) {
            bus::Sample sample{module.info.index, from + std::chrono::milliseconds(10 * i), *module.latest};
            sample.report.position = position;
            module.apply(sample);
        }
        window->showLink(connectedTo({module}));
    };
    standAt(1, 127);
    EXPECT_EQ(text(u"stateMeaning"_s), u"The motor holds its position."_s);
    EXPECT_TRUE(listed().contains(u"Holding"_s) && !listed().contains(u"off"_s));
    standAt(-24, 127);
    EXPECT_TRUE(text(u"stateMeaning"_s).startsWith(u"24 counts off the position to hold: friction"_s));
    EXPECT_TRUE(listed().contains(u"Holding, 24 counts off"_s)) << listed().toStdString();
    standAt(400, 127);
    EXPECT_TRUE(text(u"stateMeaning"_s).startsWith(u"400 counts off the position to hold, and pushing"_s));
    EXPECT_TRUE(listed().contains(u"Holding, pushing at OL"_s)) << listed().toStdString();
    standAt(400, 255);
    EXPECT_TRUE(listed().contains(u"Holding, 400 counts off"_s)) << listed().toStdString();
}

TEST_F(Head, AServoThatATestDrivesIsNotSaidToHold) {
    ModuleState module = Servo{.held = true}.state();
    window->showLink(connectedTo({module}));
    ProcedureReport report;
    report.kind = ProcedureKind::FrequencyResponse;
    report.stage = ProcedureStage::Moving;
    window->showProcedure(report);
    EXPECT_EQ(text(u"stateLabel"_s), u"Driven by a test"_s);
    EXPECT_EQ(text(u"stateMeaning"_s), u"The test moves the motor around the position that it held."_s);
    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    EXPECT_EQ(text(u"stateMeaning"_s), u"The motor holds its position."_s);
}

TEST_F(Head, AServoWithoutKpIsNotSaidToHold) {
    ModuleState module = Servo{}.state();
    module.gains->kp = 0;
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"stateMeaning"_s), u"Kp is 0: the servo brakes the motor but holds no position."_s);
}

}  // namespace
}  // namespace nmc
