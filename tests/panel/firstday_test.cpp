// SPDX-License-Identifier: GPL-3.0-or-later
// The mistakes of a first day, one after the other in one session: each is reported in a sentence, none moves
// a motor or loses anything, and after each the work goes on. Controls are found by the names that a screen
// reader says.
#include "tests/support/hand.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using testing_support::Hand;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class FirstDay : public testing::Test {
protected:
    void TearDown() override { texts::setModuleNames({}); }
    bool said(const QString& words) {
        return panel.waitFor([&] { return panel.count(words) > 0; });
    }
    [[nodiscard]] std::string all() { return panel.headlines().join(u'\n').toStdString(); }
    void connectTo(const VirtualChain& chain, std::size_t modules) {
        panel.askFor(chain.terminal());
        ASSERT_TRUE(panel.waitFor([&] {
            return panel.connected() && panel.composition().store().link().modules.size() == modules;
        })) << all();
    }

    QTemporaryDir folder;
    VirtualChain nobody{std::vector<ModuleIdentity>{}};
    VirtualChain sim{u"servo,servo,step"_s};
    // Nobody can write to this place.
    VirtualPanel panel{u"/proc/nmc/panel.ini"_s, VirtualPanel::noAdapters(), folder.path()};
    Hand hand{panel};
};

TEST_F(FirstDay, EachMistakeIsSaidAndMovesNothing) {
    panel.start();
    panel.window().resize(1'280, 800);
    EXPECT_TRUE(said(u"Settings cannot be saved"_s));

    // A port on which something else does not answer, and one whose adapter is not plugged in.
    panel.askFor(nobody.terminal());
    ASSERT_TRUE(said(u"no module answered"_s)) << all();
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Disconnect"_s));
    ASSERT_TRUE(said(u"Disconnected from"_s));
    EXPECT_EQ(panel.count(u"No stop was confirmed"_s), 0) << "there were no modules to stop";
    sim.unplug();
    panel.askFor(sim.terminal());
    ASSERT_TRUE(said(u"not found"_s)) << all();
    sim.plugIn();
    // Another program has the port open.
    sim.setInUse(true);
    panel.askFor(sim.terminal());
    ASSERT_TRUE(said(u"is used by another program"_s)) << all();
    sim.setInUse(false);

    // The wrong rate: another program has left the chain at a different one.
    for (const char* packet : {"AA 00 21 01 FF 21", "AA 00 21 02 FF 22", "AA 00 21 03 FF 23",  // Set Address
                               "AA FF 1A 14 2D"})  // Set Baud Rate of all, divisor 20: 57 600 Bd
        sim.tell(std::string("foreign ") + packet);
    ASSERT_NO_FATAL_FAILURE(connectTo(sim, 3));
    EXPECT_EQ(panel.standing(u"not found"_s), nullptr) << "it has been found since";

    // A machine file that was edited by hand.
    const QString broken = folder.filePath(u"mill.json"_s);
    {
        QFile file(broken);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{\"format\": \"nmc-panel-machine\",\n\"version\": 1,\n\"axes\": [{\"name\": }]}\n");
    }
    hand.fromMenu(u"Open machine"_s);
    ASSERT_NO_FATAL_FAILURE(hand.chooseFile(broken));
    ASSERT_TRUE(said(u"\"mill.json\" line 3"_s)) << all();
    EXPECT_TRUE(panel.composition().machine().axes.empty() ||
                panel.composition().machine().axes.at(0).name.empty());

    // Encoder channels A and B are swapped: the check finds this before the servo is ever on.
    std::ignore = sim.control(u"fault module 2 reverse"_s);
    panel.select(1);
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Direction check"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Pulse motor"_s));
    ASSERT_TRUE(said(u"is reversed. Do not enable it."_s)) << all();
    EXPECT_FALSE(sim.state(2)[u"servo_on"_s].toBool());

    // A stepper without motor power.
    std::ignore = sim.control(u"set 3 power 0"_s);
    panel.select(2);
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Parameters"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Starting values"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Apply parameters"_s));
    EXPECT_TRUE(panel.waitFor([&] {
        return hand.find<QAbstractButton>(u"Enable amplifier"_s)->toolTip().contains(u"power"_s);
    })) << hand.find<QAbstractButton>(u"Enable amplifier"_s)->toolTip().toStdString();
    EXPECT_FALSE(hand.find<QAbstractButton>(u"Hold to move forward"_s)->isEnabled());

    // After all that, the first motor still runs and stops.
    panel.select(0);
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Run forward"_s));
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));

    // The disk is full: this ends the recording, but not the motion.
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Scope"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Record"_s));
    const QString full = folder.filePath(u"run.csv"_s);
    ASSERT_TRUE(QFile::link(u"/dev/full"_s, full));
    ASSERT_NO_FATAL_FAILURE(hand.chooseFile(full));
    ASSERT_TRUE(said(u"stopped: the disk is full"_s)) << all();
    EXPECT_TRUE(moves(sim));
    ASSERT_NE(hand.find<QAbstractButton>(u"Record"_s), nullptr);

    hand.strike(Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc
