// SPDX-License-Identifier: GPL-3.0-or-later
// Compares what the two data sheets let a host say with the controls of the window, in both directions: each
// command and each bit of a command has a control, and each control of a panel that sends something is in the
// table.
#include <array>
#include <span>

#include "protocol/commandtable.h"
#include "tests/model/stepperfixture.h"
#include "widgets/common/lazydock.h"
#include "widgets/paths/pathspage.h"
#include "windowtest.h"

namespace nmc {
namespace {

using testing_support::Stepper;

struct Cell {
    CommandCode code;
    std::uint8_t bits;  ///< of the control byte; 0: the command itself, or a number in it
    QString control;    ///< empty: no control, the panel sends it automatically
};

using enum CommandCode;

/// Commands for a group or for the chain, with any panel (DS-V 4.1).
const std::vector<Cell> kChainCells{
    {ResetPosition, 0, u"groupResetButton"_s},
    {SetAddress, 0, u"address1Box"_s},
    {SetAddress, 0, u"group1Box"_s},
    {SetAddress, 0, u"leader1Box"_s},
    {StartMotion, 0, u"groupStartButton"_s},
    {StopMotor, 0, u"groupStopSmoothlyButton"_s},
    {StopMotor, 0, u"groupStopAbruptlyButton"_s},
    {StopMotor, 0, u"groupMotorOffButton"_s},
    {SetBaud, 0, u"chainRateBox"_s},
    {SetBaud, 0, u"chainDivisorBox"_s},
    {SetBaud, 0, u"changeRateButton"_s},
    {SaveAsHome, 0, u"groupHomeButton"_s},
    {HardReset, 0, u"restartChainButton"_s},
    {DefineStatus, 0, {}},
    {ReadStatus, 0, {}},
    {Nop, 0, {}},
};

const std::vector<Cell> kServoCells{
    {ResetPosition, 0, u"zeroHereButton"_s},
    {LoadTrajectory, 0x01, u"expertLoadPositionLoaded"_s},
    {LoadTrajectory, 0x02, u"expertLoadVelocityLoaded"_s},
    {LoadTrajectory, 0x04, u"expertLoadAccelerationLoaded"_s},
    {LoadTrajectory, 0x08, u"expertLoadPwmLoaded"_s},
    {LoadTrajectory, 0x30, u"expertLoadMode"_s},
    {LoadTrajectory, 0x40, u"expertLoadReverse"_s},
    {LoadTrajectory, 0x80, u"expertLoadNow"_s},
    {LoadTrajectory, 0, u"expertLoadButton"_s},
    {LoadTrajectory, 0, u"goButton"_s},
    {LoadTrajectory, 0, u"loadButton"_s},
    {LoadTrajectory, 0, u"goHomeButton"_s},
    {LoadTrajectory, 0, u"runForwardButton"_s},
    {LoadTrajectory, 0, u"runReverseButton"_s},
    {LoadTrajectory, 0, u"holdForwardButton"_s},
    {LoadTrajectory, 0, u"holdReverseButton"_s},
    {LoadTrajectory, 0, u"pwmForwardButton"_s},
    {LoadTrajectory, 0, u"pwmReverseButton"_s},
    {StartMotion, 0, u"startButton"_s},
    {SetGain, 0, u"kpField"_s},
    {SetGain, 0, u"kdField"_s},
    {SetGain, 0, u"kiField"_s},
    {SetGain, 0, u"ilField"_s},
    {SetGain, 0, u"olField"_s},
    {SetGain, 0, u"clField"_s},
    {SetGain, 0, u"clSenseBox"_s},
    {SetGain, 0, u"elField"_s},
    {SetGain, 0, u"srField"_s},
    {SetGain, 0, u"dbField"_s},
    {SetGain, 0, u"applyGainsButton"_s},
    {StopMotor, 0x01, u"expertStopAmplifier"_s},
    {StopMotor, 0x1E, u"expertStopManner"_s},
    {StopMotor, 0, u"expertStopButton"_s},
    {StopMotor, 0, u"enableButton"_s},
    {StopMotor, 0, u"stopSmoothlyButton"_s},
    {StopMotor, 0, u"stopAbruptlyButton"_s},
    {StopMotor, 0, u"stopHereButton"_s},
    {StopMotor, 0, u"motorOffButton"_s},
    {StopMotor, 0, u"pwmOffButton"_s},
    {StopMotor, 0, u"amplifierBox"_s},
    {IoControl, 0x05, u"limit1UseBox"_s},
    {IoControl, 0x0A, u"limit2UseBox"_s},
    {SetHoming, 0x01, u"expertHomingLimit1"_s},
    {SetHoming, 0x02, u"expertHomingLimit2"_s},
    {SetHoming, 0x08, u"expertHomingIndex"_s},
    {SetHoming, 0x34, u"expertHomingManner"_s},
    {SetHoming, 0x40, u"expertHomingPositionError"_s},
    {SetHoming, 0x80, u"expertHomingCurrentLimit"_s},
    {SetHoming, 0, u"expertHomingButton"_s},
    {SetHoming, 0, u"homeButton"_s},
    {SetHoming, 0, u"armLimitStopButton"_s},
    {SetHoming, 0, u"disarmLimitStopButton"_s},
    {ClearStickyBits, 0, u"clearStickyButton"_s},
    {ClearStickyBits, 0, u"groupClearButton"_s},
    {SaveAsHome, 0, u"saveHomeButton"_s},
    {HardReset, 0, u"resetModuleButton"_s},
};

/// What CMC and SC have in addition; what only one of them has follows (docs/family.md).
const std::vector<Cell> kLaterCells{
    {LoadTrajectory, 0, u"expertLoadRelative"_s},
    {ResetPosition, 0x03, u"expertResetHow"_s},
    {ResetPosition, 0, u"expertResetButton"_s},
    {AddPathPoints, 0, u"runPathButton"_s},
};
const std::vector<Cell> kCmcCells{
    {StopMotor, 0x20, u"expertStopAdvanced"_s},
    {IoControl, 0x40, u"ioFastPathBox"_s},
};
const std::vector<Cell> kScCells{
    {IoControl, 0x0C, u"limitProtectionBox"_s},
    {IoControl, 0x10, u"threePhaseBox"_s},
    {IoControl, 0x20, u"antiphaseBox"_s},
    {IoControl, 0x40, u"fastPathBox"_s},
    {IoControl, 0x80, u"stepperInputBox"_s},
    {IoControl, 0, u"applyAmplifierButton"_s},
    {SetGain, 0, u"stepMultiplierField"_s},
    {SetGain, 0, u"setMultiplierButton"_s},
    // Step and direction, limit protection, 3-phase and antiphase are saved as they are.
    {HardReset, 0xF1, u"saveConfigurationButton"_s},
    {HardReset, 0x02, u"saveAddressBox"_s},
    {HardReset, 0x04, u"saveAmplifierBox"_s},
    {HardReset, 0x08, u"saveServoBox"_s},
    {HardReset, 0, u"eraseConfigurationButton"_s},
};

const std::vector<Cell> kStepCells{
    {ResetPosition, 0, u"stepperZeroHereButton"_s},
    {LoadTrajectory, 0x01, u"expertLoadPositionLoaded"_s},
    {LoadTrajectory, 0x02, u"expertLoadSpeedLoaded"_s},
    {LoadTrajectory, 0x04, u"expertLoadAccelerationLoaded"_s},
    {LoadTrajectory, 0x08, u"expertLoadTimerLoaded"_s},
    {LoadTrajectory, 0x10, u"expertLoadReverse"_s},
    {LoadTrajectory, 0x80, u"expertLoadNow"_s},
    {LoadTrajectory, 0, u"expertLoadButton"_s},
    // The target modes of DS-S Table 4; each load is checked for the modes from which it is allowed.
    {LoadTrajectory, 0, u"stepperModeTrapezoidal"_s},
    {LoadTrajectory, 0, u"stepperModeProfile"_s},
    {LoadTrajectory, 0, u"stepperModeTimedMove"_s},
    {LoadTrajectory, 0, u"stepperModeTimedRun"_s},
    {LoadTrajectory, 0, u"stepperGoButton"_s},
    {LoadTrajectory, 0, u"stepperGoHomeButton"_s},
    {LoadTrajectory, 0, u"stepperRunForwardButton"_s},
    {LoadTrajectory, 0, u"stepperRunReverseButton"_s},
    {LoadTrajectory, 0, u"stepperHoldForwardButton"_s},
    {LoadTrajectory, 0, u"stepperHoldReverseButton"_s},
    {LoadTrajectory, 0, u"stepperLoadOnlyBox"_s},
    {StartMotion, 0, u"stepperStartLoadedButton"_s},
    {SetGain, 0x03, u"stepperSpeedModeField"_s},
    {SetGain, 0x04, u"stepperIgnoreLimitsField"_s},
    {SetGain, 0x08, u"stepperIgnoreEstopField"_s},
    {SetGain, 0x10, u"stepperMotorOffOnStopField"_s},
    {SetGain, 0, u"stepperMinimumSpeedField"_s},
    {SetGain, 0, u"stepperRunCurrentField"_s},
    {SetGain, 0, u"stepperHoldCurrentField"_s},
    {SetGain, 0, u"stepperThermalLimitField"_s},
    {SetGain, 0, u"stepperApplyParametersButton"_s},
    {StopMotor, 0x01, u"expertStopAmplifier"_s},
    {StopMotor, 0x0C, u"expertStopManner"_s},
    {StopMotor, 0, u"expertStopButton"_s},
    {StopMotor, 0, u"stepperEnableButton"_s},
    {StopMotor, 0, u"stepperStopSmoothlyButton"_s},
    {StopMotor, 0, u"stepperStopAbruptlyButton"_s},
    {StopMotor, 0, u"stepperMotorOffButton"_s},
    {IoControl, 0x01, u"stepperOutput1Box"_s},
    {IoControl, 0x02, u"stepperOutput2Box"_s},
    {IoControl, 0x04, u"stepperOutput3Box"_s},
    {IoControl, 0x08, u"stepperOutput4Box"_s},
    {IoControl, 0x10, u"stepperOutput5Box"_s},
    {IoControl, 0, u"stepperSetOutputsButton"_s},
    {SetHoming, 0x01, u"expertHomingLimit1"_s},
    {SetHoming, 0x02, u"expertHomingLimit2"_s},
    {SetHoming, 0x08, u"expertHomingHomeSwitch"_s},
    {SetHoming, 0x34, u"expertHomingManner"_s},
    {SetHoming, 0, u"expertHomingButton"_s},
    {SetHoming, 0, u"stepperHomeButton"_s},
    {SaveAsHome, 0, u"stepperSaveHomeButton"_s},
    {HardReset, 0, u"resetModuleButton"_s},
};

/// These send several commands of the table one after the other, or only tell the panel something.
const QSet<QString> kMadeOfCells{u"moveByForwardButton"_s, u"moveByReverseButton"_s,
                                 u"directionCheckButton"_s, u"declarePositionButton"_s,
                                 u"doubtPositionButton"_s};

/// The bits that a control byte has (DS-V 5.2, DS-S 5.1).
struct Bits {
    CommandCode code;
    unsigned mask;
};
constexpr std::array kServoMasks{Bits{LoadTrajectory, 0xFF}, Bits{StopMotor, 0x1F}, Bits{IoControl, 0x0F},
                                 Bits{SetHoming, 0xFF}};
constexpr std::array kStepMasks{Bits{LoadTrajectory, 0x9F}, Bits{SetGain, 0x1F}, Bits{StopMotor, 0x0D},
                                Bits{IoControl, 0x1F}, Bits{SetHoming, 0x3F}};

constexpr std::array kCmcMasks{Bits{LoadTrajectory, 0xFF}, Bits{StopMotor, 0x3F}, Bits{IoControl, 0x4F},
                               Bits{SetHoming, 0xFF}, Bits{ResetPosition, 0x03}};
constexpr std::array kScMasks{Bits{LoadTrajectory, 0xFF}, Bits{StopMotor, 0x1F},     Bits{IoControl, 0xFC},
                              Bits{SetHoming, 0xFF},      Bits{ResetPosition, 0x03}, Bits{HardReset, 0xFF}};

[[nodiscard]] std::vector<Cell> together(std::vector<Cell> cells,
                                         std::initializer_list<const std::vector<Cell>*> others) {
    for (const auto* other : others)
        cells.insert(cells.end(), other->begin(), other->end());
    return cells;
}
/// Without the pins of I/O Control, which are inputs on an SC.
[[nodiscard]] std::vector<Cell> withoutPins(std::vector<Cell> cells) {
    std::erase_if(cells, [](const Cell& cell) { return cell.code == IoControl; });
    return cells;
}

class Cells : public WindowTest {
protected:
    Cells() {
        window->resize(1500, 1100);
        for (const char* action : {"chainDoctorAction", "groupsAction", "rateAction"})
            window->findChild<QAction*>(QLatin1StringView(action))->trigger();
        window->paths().open();
    }

    void expectEachHasItsControl(const ModuleIdentity& module, const std::vector<Cell>& own) {
        for (const CommandRow& row : commandTable(module)) {
            const auto isIt = [&](const Cell& cell) { return cell.code == row.code; };
            EXPECT_TRUE(std::any_of(own.begin(), own.end(), isIt) ||
                        std::any_of(kChainCells.begin(), kChainCells.end(), isIt))
                << row.name << " is in no row";
        }
        for (const auto* cells : {&own, &kChainCells})
            for (const Cell& cell : *cells)
                EXPECT_TRUE(cell.control.isEmpty() || window->findChild<QObject*>(cell.control) != nullptr)
                    << cell.control.toStdString() << " is not in the window";
    }
    static void expectEachBit(const std::vector<Cell>& cells, std::span<const Bits> bits) {
        for (const Bits& byte : bits) {
            unsigned reached = 0;
            for (const Cell& cell : cells)
                if (cell.code == byte.code)
                    reached |= cell.bits;
            EXPECT_EQ(reached, byte.mask) << "command " << static_cast<int>(byte.code);
        }
    }
    /// Presses each control of the panel that can be pressed, and checks whether this sends something.
    void expectEachSenderInTheTable(const std::vector<Cell>& cells) {
        const auto sent = [this] { return intents.size() + holds.size(); };
        unsigned senders = 0;
        for (QWidget* control : find(u"modulePanel"_s)->findChildren<QWidget*>()) {
            auto* press = qobject_cast<QAbstractButton*>(control);
            auto* list = qobject_cast<QComboBox*>(control);
            const QString name = control->objectName();
            if ((press == nullptr && list == nullptr) || name.isEmpty() || name.startsWith(u"qt_"_s))
                continue;
            testing_support::turnTo(*control);
            if (!control->isEnabled() || !control->isVisible())
                continue;
            const auto before = sent();
            if (list != nullptr) {
                list->setFocus();
                QTest::keyClick(list, list->currentIndex() == 0 ? Qt::Key_Down : Qt::Key_Up);
            } else {
                QTest::mouseClick(press, Qt::LeftButton, {}, {press->height() / 2, press->height() / 2});
            }
            if (sent() == before)
                continue;
            ++senders;
            EXPECT_TRUE(kMadeOfCells.contains(name) ||
                        std::any_of(cells.begin(), cells.end(),
                                    [&](const Cell& cell) { return cell.control == name; }))
                << name.toStdString() << " sends what is in no row";
        }
        EXPECT_GE(senders, 5U) << "otherwise nothing was tried";
    }

    QSignalSpy intents{&window->requests(), &Requests::intent};
    QSignalSpy holds{&window->requests(), &Requests::hold};
};

TEST_F(Cells, EachOfThePicServoSheetHasItsControl) {
    showServo();
    expectEachHasItsControl({ModuleType::Servo, 4}, kServoCells);
    expectEachBit(kServoCells, kServoMasks);
}

TEST_F(Cells, EachOfACmcHasItsControl) {
    showServo({.version = 5});
    const auto cells = together(kServoCells, {&kLaterCells, &kCmcCells});
    expectEachHasItsControl({ModuleType::Servo, 5}, cells);
    expectEachBit(cells, kCmcMasks);
}

TEST_F(Cells, EachOfAnScHasItsControl) {
    showServo({.version = 10});
    const auto cells = together(withoutPins(kServoCells), {&kLaterCells, &kScCells});
    expectEachHasItsControl({ModuleType::Servo, 10}, cells);
    expectEachBit(cells, kScMasks);
}

TEST_F(Cells, WhateverSendsSomethingToAnScIsInTheTable) {
    showServo({.version = 10});
    expectEachSenderInTheTable(together(kServoCells, {&kLaterCells, &kScCells}));
}

TEST_F(Cells, EachOfThePicStepSheetHasItsControl) {
    window->showLink(connectedTo({Stepper::holding().module}));
    expectEachHasItsControl({ModuleType::Stepper, 1}, kStepCells);
    expectEachBit(kStepCells, kStepMasks);
}

TEST_F(Cells, WhateverSendsSomethingToAServoIsInTheTable) {
    showServo();
    expectEachSenderInTheTable(kServoCells);
}

TEST_F(Cells, WhateverSendsSomethingToAStepperIsInTheTable) {
    window->showLink(connectedTo({Stepper::holding().module}));
    expectEachSenderInTheTable(kStepCells);
}

}  // namespace
}  // namespace nmc
