// SPDX-License-Identifier: GPL-3.0-or-later
// Every bit of a chip's motion commands has a control on the Expert page, and every control there is one: the
// control bytes of DS-V 5.2 and DS-S 5.1, as printed.
#include "tests/model/stepperfixture.h"
#include "windowtest.h"

namespace nmc {
namespace {

using testing_support::clickOn;
using testing_support::Stepper;

/// What one action does to the first data byte.
struct Bit {
    QString control;
    int choice;  ///< index in a list; -1: a check box
    std::uint8_t mask;
    std::uint8_t value;
};

constexpr int kBox = -1;

const std::vector<Bit> kServoBits{
    {u"expertLoadPositionLoaded"_s, kBox, 0x01, 0x01},
    {u"expertLoadVelocityLoaded"_s, kBox, 0x02, 0x02},
    {u"expertLoadAccelerationLoaded"_s, kBox, 0x04, 0x04},
    {u"expertLoadPwmLoaded"_s, kBox, 0x08, 0x08},
    {u"expertLoadMode"_s, 0, 0x30, 0x10},
    {u"expertLoadMode"_s, 1, 0x30, 0x30},
    {u"expertLoadMode"_s, 2, 0x30, 0x00},
    {u"expertLoadReverse"_s, kBox, 0x40, 0x40},
    {u"expertLoadNow"_s, kBox, 0x80, 0x80},
    {u"expertStopAmplifier"_s, kBox, 0x01, 0x00},  // initially checked
    {u"expertStopManner"_s, 0, 0x1E, 0x00},
    {u"expertStopManner"_s, 1, 0x1E, 0x02},
    {u"expertStopManner"_s, 2, 0x1E, 0x04},
    {u"expertStopManner"_s, 3, 0x1E, 0x08},
    {u"expertStopManner"_s, 4, 0x1E, 0x10},
    {u"expertHomingLimit1"_s, kBox, 0x01, 0x01},
    {u"expertHomingLimit2"_s, kBox, 0x02, 0x02},
    {u"expertHomingIndex"_s, kBox, 0x08, 0x08},
    {u"expertHomingPositionError"_s, kBox, 0x40, 0x40},
    {u"expertHomingCurrentLimit"_s, kBox, 0x80, 0x80},
    {u"expertHomingManner"_s, 0, 0x34, 0x00},
    {u"expertHomingManner"_s, 1, 0x34, 0x10},
    {u"expertHomingManner"_s, 2, 0x34, 0x20},
    {u"expertHomingManner"_s, 3, 0x34, 0x04},
};

const std::vector<Bit> kStepBits{
    {u"expertLoadPositionLoaded"_s, kBox, 0x01, 0x01},
    {u"expertLoadSpeedLoaded"_s, kBox, 0x02, 0x02},
    {u"expertLoadAccelerationLoaded"_s, kBox, 0x04, 0x04},
    {u"expertLoadTimerLoaded"_s, kBox, 0x08, 0x08},
    {u"expertLoadReverse"_s, kBox, 0x10, 0x10},
    {u"expertLoadNow"_s, kBox, 0x80, 0x80},
    {u"expertStopAmplifier"_s, kBox, 0x01, 0x00},
    {u"expertStopManner"_s, 0, 0x0C, 0x00},
    {u"expertStopManner"_s, 1, 0x0C, 0x04},
    {u"expertStopManner"_s, 2, 0x0C, 0x08},
    {u"expertHomingLimit1"_s, kBox, 0x01, 0x01},
    {u"expertHomingLimit2"_s, kBox, 0x02, 0x02},
    {u"expertHomingHomeSwitch"_s, kBox, 0x08, 0x08},
    {u"expertHomingManner"_s, 0, 0x34, 0x00},
    {u"expertHomingManner"_s, 1, 0x34, 0x10},
    {u"expertHomingManner"_s, 2, 0x34, 0x20},
    {u"expertHomingManner"_s, 3, 0x34, 0x04},
};

class Expert : public WindowTest {
protected:
    Expert() { window->resize(1500, 1100); }

    void showStepper(const Stepper& stepper) { window->showLink(connectedTo({stepper.module})); }

    /// Returns "expertLoad" for "expertLoadMode".
    static QString boxOf(const QString& control) {
        for (const QString& box : {u"expertLoad"_s, u"expertStop"_s, u"expertHoming"_s})
            if (control.startsWith(box))
                return box;
        return {};
    }
    QByteArray bytes(const QString& box) { return QByteArray::fromHex(text(box + u"Bytes"_s).toLatin1()); }
    void choose(const QString& control, int choice) {
        auto* list = find<QComboBox>(control);
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Home);
        for (int i = 0; i < choice; ++i)
            QTest::keyClick(list, Qt::Key_Down);
        ASSERT_EQ(list->currentIndex(), choice) << control.toStdString();
    }
    void act(const Bit& bit) {
        if (bit.choice == kBox)
            clickOn(*find<QCheckBox>(bit.control));
        else
            choose(bit.control, bit.choice);
    }
    void expectEveryBit(const std::vector<Bit>& bits) {
        for (const Bit& bit : bits) {
            SCOPED_TRACE(bit.control.toStdString() + " " + std::to_string(bit.choice));
            const auto before = static_cast<std::uint8_t>(bytes(boxOf(bit.control)).at(3));
            act(bit);
            const auto after = static_cast<std::uint8_t>(bytes(boxOf(bit.control)).at(3));
            EXPECT_EQ(after & bit.mask, bit.value);
            EXPECT_EQ(after & ~bit.mask, before & ~bit.mask) << "another bit has changed";
            if (bit.choice == kBox)
                act(bit);
        }
        for (const auto* control : find(u"expertBox"_s)->findChildren<QWidget*>()) {
            const bool chooses = qobject_cast<const QCheckBox*>(control) != nullptr ||
                                 qobject_cast<const QComboBox*>(control) != nullptr;
            EXPECT_TRUE(!chooses ||
                        std::any_of(bits.begin(), bits.end(),
                                    [&](const Bit& bit) { return bit.control == control->objectName(); }))
                << control->objectName().toStdString() << " is in no data sheet";
        }
    }
    QByteArray sent(int number = 0) {
        if (intents.size() <= number)
            return {};
        const auto intent = intents.at(number).at(1).value<Intent>();
        const auto& command = std::get<intent::Direct>(intent).command;
        const Payload payload = std::visit([](const auto& chip) { return encode(chip); }, command);
        const PacketBytes packet = toPacket({BusAddress(1), payload});
        return {reinterpret_cast<const char*>(packet.data()), static_cast<qsizetype>(packet.size())};
    }

    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(Expert, ReachesEveryBitOfAServo) {
    showServo();
    expectEveryBit(kServoBits);
    EXPECT_EQ(intents.size(), 0) << "setting up a command sends nothing";
}

TEST_F(Expert, ReachesEveryBitOfAStepper) {
    showStepper(Stepper::holding());
    expectEveryBit(kStepBits);
    EXPECT_EQ(intents.size(), 0);
}

/// The example of DS-V 5.2 Load Trajectory: "the command byte would be 0x94, the control byte would be 0x15".
TEST_F(Expert, SendsTheDataSheetsExample) {
    showServo();
    clickOn(*find<QCheckBox>(u"expertLoadPositionLoaded"_s));
    type(u"expertLoadPosition"_s, u"1000"_s);
    clickOn(*find<QCheckBox>(u"expertLoadAccelerationLoaded"_s));
    type(u"expertLoadAcceleration"_s, u"2"_s);
    click(u"expertLoadButton"_s);
    EXPECT_EQ(sent().toHex(' ').toUpper(), "AA 01 94 15 E8 03 00 00 02 00 00 00 97");
}

TEST_F(Expert, CapturesHomeWithoutAStop) {
    showServo();
    clickOn(*find<QCheckBox>(u"expertHomingIndex"_s));
    click(u"expertHomingButton"_s);
    EXPECT_EQ(sent().toHex(' ').toUpper(), "AA 01 19 08 22");
    EXPECT_TRUE(text(u"expertHomingMeaning"_s).contains(u"The motion goes on"_s));
}

/// Motor off with AMP_EN, as set at first: 0x03 (DS-V 5.2); 01 + 17 + 03 = 1B.
TEST_F(Expert, AStopDoesNotWaitForAnAnswer) {
    showServo();
    clickOn(*find<QCheckBox>(u"expertHomingIndex"_s));
    click(u"expertHomingButton"_s);
    ASSERT_EQ(intents.size(), 1);
    ASSERT_FALSE(button(u"expertHomingButton"_s)->isEnabled()) << "the module has not answered yet";
    choose(u"expertStopManner"_s, 0);
    EXPECT_FALSE(button(u"expertStopButton"_s)->isEnabled()) << "AMP_EN alone is no stop";
    choose(u"expertStopManner"_s, 4);
    EXPECT_FALSE(button(u"expertStopButton"_s)->isEnabled()) << "at a position: that is a move";
    choose(u"expertStopManner"_s, 1);
    EXPECT_TRUE(button(u"expertStopButton"_s)->isEnabled());
    click(u"expertStopButton"_s);
    EXPECT_EQ(sent(1).toHex(' ').toUpper(), "AA 01 17 03 1B");
}

TEST_F(Expert, DoesNotStartATrapezoidWithItsLoad) {
    showServo();
    clickOn(*find<QCheckBox>(u"expertLoadNow"_s));
    EXPECT_FALSE(button(u"expertLoadButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"expertLoadButton"_s)->toolTip().isEmpty());
    choose(u"expertLoadMode"_s, 1);
    EXPECT_FALSE(button(u"expertLoadButton"_s)->isEnabled()) << "no acceleration was ever loaded";
    clickOn(*find<QCheckBox>(u"expertLoadAccelerationLoaded"_s));
    type(u"expertLoadAcceleration"_s, u"131"_s);
    EXPECT_TRUE(button(u"expertLoadButton"_s)->isEnabled());
}

TEST_F(Expert, DoesNotStartAMoveOfAStepperWithItsLoad) {
    showStepper(Stepper::holding());
    clickOn(*find<QCheckBox>(u"expertLoadPositionLoaded"_s));
    clickOn(*find<QCheckBox>(u"expertLoadNow"_s));
    EXPECT_FALSE(button(u"expertLoadButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"expertLoadButton"_s)->toolTip().contains(u"then choose Start"_s));
}

TEST_F(Expert, SaysWhichNumberIsWrong) {
    showServo();
    clickOn(*find<QCheckBox>(u"expertLoadPwmLoaded"_s));
    type(u"expertLoadPwm"_s, u"256"_s);
    EXPECT_FALSE(button(u"expertLoadButton"_s)->isEnabled());
    EXPECT_TRUE(text(u"expertLoadMeaning"_s).contains(u"255"_s));
}

/// Table 4: from a trapezoid, the timer count alone keeps the position; with a speed it becomes a ramp.
TEST_F(Expert, NamesTheModeOfTable4) {
    Stepper stepper = Stepper::holding();
    stepper::LoadTrajectory move = Stepper::trapezoid(900);
    move.startNow = true;
    stepper.was(move);
    stepper.says(testing_support::kStepPower | testing_support::kAmplifier | testing_support::kMoving |
                 testing_support::kTrapezoidalMode);
    showStepper(stepper);
    clickOn(*find<QCheckBox>(u"expertLoadNow"_s));
    EXPECT_FALSE(button(u"expertLoadButton"_s)->isEnabled()) << "it needs a timer count";
    clickOn(*find<QCheckBox>(u"expertLoadTimerLoaded"_s));
    EXPECT_TRUE(text(u"expertLoadMeaning"_s).contains(u"continues to its position"_s));
    EXPECT_TRUE(button(u"expertLoadButton"_s)->isEnabled());
    clickOn(*find<QCheckBox>(u"expertLoadSpeedLoaded"_s));
    EXPECT_TRUE(text(u"expertLoadMeaning"_s).contains(u"A ramp"_s));
    clickOn(*find<QCheckBox>(u"expertLoadPositionLoaded"_s));
    EXPECT_FALSE(button(u"expertLoadButton"_s)->isEnabled()) << "a goal cannot change in motion";
}

TEST_F(Expert, ResetsAModuleAfterAQuestion) {
    showServo();
    click(u"resetModuleButton"_s);
    EXPECT_EQ(intents.size(), 0) << "it asks first";
    click(u"resetModuleCancel"_s);
    EXPECT_EQ(intents.size(), 0);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    click(u"resetModuleButton"_s);
    click(u"resetModuleGo"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::ResetModule>(intents.at(0).at(1).value<Intent>()));
}

TEST_F(Expert, AQuestionThatWaitsIsNamedInTheBanner) {
    showServo();
    click(u"resetModuleButton"_s);
    ASSERT_TRUE(QTest::qWaitForWindowActive(find(u"resetModuleQuestion"_s), testing_support::kPatienceMs));
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), testing_support::kPatienceMs));
    ASSERT_TRUE(eventually([this] { return find(u"banner"_s)->isVisible(); }));
    EXPECT_EQ(text(u"bannerHeadline"_s), u"A question is waiting for your answer: Reset module"_s);
}

/// The page that has asked no longer follows its module.
TEST_F(Expert, WithdrawsTheQuestionWhenAnotherModuleIsSelected) {
    showServos({{}, {}});
    click(u"resetModuleButton"_s);
    const QPointer<QWidget> question = find(u"resetModuleQuestion"_s);
    ASSERT_TRUE(question->isVisible());
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    EXPECT_TRUE(question == nullptr || !question->isVisible());
}

TEST_F(Expert, WithdrawsTheQuestionWhenTheMotorMoves) {
    showServo();
    click(u"resetModuleButton"_s);
    EXPECT_TRUE(find(u"resetModuleQuestion"_s)->isVisible());
    showServo({.moveDone = false, .millisecond = 20});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(window->findChild<QDialog*>(u"resetModuleQuestion"_s), nullptr);
    EXPECT_FALSE(button(u"resetModuleButton"_s)->isEnabled());
}

}  // namespace
}  // namespace nmc
