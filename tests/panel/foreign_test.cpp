// SPDX-License-Identifier: GPL-3.0-or-later
// What comes over the line apart from answers: packets of another host, and an adapter's echo.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// Another program on the same line: it sends these bytes to module 2, with header and checksum. Polls of the
/// panel may disturb it, so the test sends everything again until the module obeys, as such programs do.
void otherHostSends(VirtualChain& sim, const QByteArray& hex) {
    const QByteArray bytes = QByteArray::fromHex(hex);
    quint8 sum = 0;
    for (const char byte : bytes)
        sum = static_cast<quint8>(sum + static_cast<quint8>(byte));
    const QByteArray packet = '\xAA' + bytes + static_cast<char>(sum);
    (void)sim.control(QStringLiteral("foreign ") + QString::fromLatin1(packet.toHex(' ')));
}

double commandVelocity(VirtualChain& sim) {
    return sim.state(2)[QStringLiteral("command_velocity")].toDouble();
}

class AnotherHost : public testing::Test {
protected:
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;
};

TEST_F(AnotherHost, ThatStartsAModuleIsToldOfAtOnceAndItsMotionEndsByTheButtonInTheMessage) {
    panel.composition().show({sim.terminal(), 115'200, false});
    const auto rests = [&] {
        const ModuleState* second = panel.composition().store().module(ModuleIndex(1));
        return panel.connected() && second != nullptr && second->activity() == Activity::ServoOff;
    };
    ASSERT_TRUE(panel.waitFor(rests));
    ASSERT_TRUE(panel.answersFor(0.5));
    ASSERT_TRUE(panel.waitFor([&] {
        otherHostSends(sim, "02 E6 C8 00 D0 07 14 00 C8 00 FF 00 40 1F 01 00");  // the gains of simulator.md
        otherHostSends(sim, "02 17 05");                                         // servo on
        otherHostSends(sim, "02 94 B6 00 00 04 00 8F 02 00 00");  // velocity mode at 4 counts/tick, start now
        return commandVelocity(sim) > 0;
    }));
    const QString told = QStringLiteral("Module 2 moves without a command from this panel.");
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(told) != nullptr; }))
        << panel.headlines().join(QLatin1Char('\n')).toStdString();
    EXPECT_GT(commandVelocity(sim), 0) << "its motion is left alone";

    auto* stop = panel.window().findChild<QPushButton*>(QStringLiteral("bannerAction_stopAll"));
    ASSERT_NE(stop, nullptr);
    QTest::mouseClick(stop, Qt::LeftButton);
    EXPECT_TRUE(panel.waitFor([&] { return commandVelocity(sim) == 0; }));
    EXPECT_TRUE(panel.waitFor([&] { return panel.standing(told) == nullptr; }));
}

TEST_F(AnotherHost, ThatAsksQuestionsIsToldOfAndEndsTheMotionOfThisPanel) {
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    sim.tell("fault bus foreign on=nop t=10ms..40ms");
    const QString told =
        QStringLiteral("Another host is sending on this line. Module 1 was commanded to stop.");
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(told) > 0; }))
        << panel.headlines().join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(panel.waitFor([&] { return !sim.driven(0); }));
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("Module 1 has stopped.")) > 0; }));
}

TEST(AnAdapterThatEchoes, IsToldOfOnceAndDoesNoHarm) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    sim.tell("fault bus echo");
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    EXPECT_EQ(panel.count(QStringLiteral("echoes everything it sends. The panel ignores the echo.")), 1);
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_Escape);
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("1 stopped and holding")) == 1; }));
    EXPECT_FALSE(sim.driven(0));
    EXPECT_EQ(sim.violations(), "");
}

TEST(AnAdapterThatEchoes, IsNoModule) {
    VirtualChain sim(QStringLiteral("servo"));
    sim.tell("fault bus echo");
    sim.tell("fault bus silent");
    VirtualPanel panel;
    panel.composition().show({sim.terminal(), 115'200, false});
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("Only the adapter's echo")) == 1; }));
}

}  // namespace
}  // namespace nmc
