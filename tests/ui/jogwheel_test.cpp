// SPDX-License-Identifier: GPL-3.0-or-later
// Jog wheels and 3-axis mice: nothing moves unless a button is held, and whatever takes a hand away stops it.
#include "widgets/gamepad/jogwheel.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "tests/support/eventually.h"
#include "tests/support/virtualwheel.h"

namespace nmc {
namespace {

using testing_support::eventually;
using testing_support::VirtualInput;
using testing_support::VirtualWheel;

class JogWheels : public testing::Test {
protected:
    [[nodiscard]] QList<double> pushes() const {
        QList<double> shares;
        for (const auto& one : m_pushed)
            shares << one.at(0).toDouble();
        return shares;
    }
    [[nodiscard]] int detents() const {
        int sum = 0;
        for (const auto& one : m_turned)
            sum += one.at(0).toInt();
        return sum;
    }
    /// Pushes the ring while a button is held.
    void pushWith(VirtualWheel& device) {
        wheel.setOn(true);
        device.press();
        device.push(4);
    }
    JogWheel wheel{nullptr};
    QSignalSpy m_pushed{&wheel, &JogWheel::pushed};
    QSignalSpy m_turned{&wheel, &JogWheel::turned};
    QSignalSpy released{&wheel, &JogWheel::released};
    QSignalSpy stops{&wheel, &JogWheel::stopPressed};
    QSignalSpy changes{&wheel, &JogWheel::changed};
};

TEST_F(JogWheels, AnotherInputDeviceIsNoJogWheel) {
    for (const auto& [vendor, product] : {std::pair("046d", "c31c"), {"0b33", "1000"}}) {  // keyboard, mouse
        const VirtualInput other(vendor, product);
        wheel.setOn(true);
        EXPECT_FALSE(wheel.isThere());
        EXPECT_FALSE(wheel.isForbidden());
        wheel.setOn(false);
    }
}

TEST_F(JogWheels, TheRingMovesAtASpeedWhileAButtonIsHeld) {
    VirtualWheel device;
    wheel.setOn(true);
    ASSERT_TRUE(wheel.isThere());
    EXPECT_EQ(changes.size(), 1);
    device.push(3);
    device.push(0);
    EXPECT_TRUE(pushes().empty()) << "no button is held";
    device.press();
    device.push(3);
    device.push(7);
    device.push(-7);
    EXPECT_EQ(pushes(), (QList<double>{3.0 / 7, 1, -1}));
    EXPECT_EQ(released.size(), 0);
    device.push(0);
    EXPECT_EQ(released.size(), 1);
    EXPECT_EQ(m_turned.size(), 0);
}

TEST_F(JogWheels, ARingThatIsOutAlreadyMovesNothing) {
    VirtualWheel device;
    wheel.setOn(true);
    device.push(5);
    device.press();
    device.push(6);
    EXPECT_TRUE(pushes().empty());
    device.push(0);
    device.push(6);
    EXPECT_EQ(pushes().size(), 1);
}

TEST_F(JogWheels, TheButtonEndsWhatItBegan) {
    VirtualWheel device;
    wheel.setOn(true);
    device.press();
    device.push(2);
    device.release();
    EXPECT_EQ(released.size(), 1);
    device.press();
    device.push(4);
    EXPECT_EQ(pushes().size(), 1) << "the ring has not been at its centre";
    EXPECT_EQ(released.size(), 1);
}

TEST_F(JogWheels, TheWheelCountsDetentsAcrossItsZero) {
    VirtualWheel device(253);
    wheel.setOn(true);
    device.turn(1);
    EXPECT_EQ(m_turned.size(), 0) << "no button is held";
    device.press();
    device.turn(5);
    EXPECT_EQ(detents(), 5) << "from 254 by 0 to 3";
    device.turn(-5);
    EXPECT_EQ(detents(), 0);
    device.release();
    EXPECT_EQ(released.size(), 1);
    device.turn(2);
    EXPECT_EQ(detents(), 0);
}

TEST_F(JogWheels, TheMiddleButtonStopsAllAndMovesNothing) {
    VirtualWheel device;
    pushWith(device);
    device.press(VirtualWheel::kMiddleButton);
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(released.size(), 1);
    device.push(5);
    device.turn(1);
    device.release(VirtualWheel::kMiddleButton);
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(pushes().size(), 1) << "only after the ring has been at its centre";
    EXPECT_EQ(m_turned.size(), 0);
}

TEST_F(JogWheels, UnpluggedInMotionItStopsAndAnotherIsFound) {
    {
        VirtualWheel device;
        pushWith(device);
        device.unplug();
        EXPECT_EQ(released.size(), 1);
        EXPECT_FALSE(wheel.isThere());
        EXPECT_EQ(changes.size(), 2);
    }
    VirtualWheel another;
    EXPECT_TRUE(eventually([this] { return wheel.isThere(); }));
    another.push(4);
    EXPECT_EQ(pushes().size(), 1) << "the button of the first one is forgotten";
}

TEST_F(JogWheels, ReportsThatWereLostEndTheMotion) {
    VirtualWheel device;
    pushWith(device);
    device.report({}, SYN_DROPPED);
    EXPECT_EQ(released.size(), 1);
    device.push(5);
    EXPECT_EQ(pushes().size(), 1) << "whether the button is still held is unknown";
}

TEST_F(JogWheels, SwitchedOffItEndsTheMotionAndReadsNothing) {
    VirtualWheel device;
    pushWith(device);
    wheel.setOn(false);
    EXPECT_EQ(released.size(), 1);
    EXPECT_FALSE(wheel.isThere());
    device.push(0);
    device.push(4);
    EXPECT_EQ(pushes().size(), 1);
}

TEST_F(JogWheels, ThatMayNotBeReadAreSaidToBeThere) {
    VirtualWheel device;
    ASSERT_EQ(chmod(device.path().constData(), 0), 0);
    const bool isRoot = geteuid() == 0;
    // Root may read everything.
    ASSERT_EQ(isRoot ? seteuid(65'534) : 0, 0);
    wheel.setOn(true);
    ASSERT_EQ(isRoot ? seteuid(0) : 0, 0);
    EXPECT_TRUE(wheel.isForbidden());
    EXPECT_FALSE(wheel.isThere());
}

/// Its reports of translation and rotation alternate.
TEST_F(JogWheels, TheCapOfAThreeAxisMouseMovesAtASpeed) {
    VirtualInput mouse("046d", "c626");
    wheel.setOn(true);
    ASSERT_TRUE(wheel.isThere());
    mouse.report({{EV_KEY, BTN_0, 1}});
    mouse.report({{EV_REL, REL_X, 35}, {EV_REL, REL_Y, 300}});
    EXPECT_TRUE(pushes().empty()) << "hardly to the side";
    // Two reports without a pause between them, which would mean that the cap is back.
    mouse.report({{EV_REL, REL_X, 175}, {EV_REL, REL_Y, 10}, {EV_SYN, SYN_REPORT, 0}, {EV_REL, REL_RX, 20}});
    EXPECT_EQ(pushes().last(), 0.5);
    EXPECT_EQ(released.size(), 0);
    mouse.report({{EV_REL, REL_X, 0}, {EV_REL, REL_Y, 10}});
    EXPECT_EQ(released.size(), 1);
    mouse.report({{EV_REL, REL_X, -400}});
    EXPECT_EQ(pushes().last(), -1);
    EXPECT_TRUE(eventually([this] { return released.size() == 2; }))
        << "back at its centre, it reports nothing";
    mouse.report({{EV_KEY, BTN_1, 1}});
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(JogWheels, ACapOfWhichTheKernelReportsPositionsIsHeldUntilItIsBack) {
    VirtualInput mouse("256f", "c635");
    wheel.setOn(true);
    mouse.report({{EV_KEY, BTN_0, 1}});
    mouse.report({{EV_ABS, ABS_X, -350}});
    EXPECT_EQ(pushes(), QList<double>{-1});
    // Timers fire in the order of their ends: one that released the cap would have come before this one.
    QTimer later;
    later.setSingleShot(true);
    later.start(300);
    ASSERT_TRUE(eventually([&later] { return !later.isActive(); }));
    EXPECT_EQ(released.size(), 0);
    mouse.report({{EV_ABS, ABS_X, 0}});
    EXPECT_EQ(released.size(), 1);
}

}  // namespace
}  // namespace nmc
