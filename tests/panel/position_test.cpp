// SPDX-License-Identifier: GPL-3.0-or-later
// The last position of an axis is offered after its module has lost power, in the window.
#include <atomic>
#include <functional>
#include <utility>
#include <vector>

#include "app/positionkeeper.h"
#include "link/files/machineio.h"
#include "tests/support/hand.h"
#include "widgets/machine/machinemenu.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::Hand;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class PositionKept : public testing::Test {
protected:
    /// Saves home where the servo is, and moves it 5 000 counts away from there.
    void leaveAt5000(VirtualPanel& panel) {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(panel.enable());
        panel.ask(intent::SaveAsHome{});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
        ASSERT_NO_FATAL_FAILURE(moveTo(panel, 5'000));
        ASSERT_TRUE(panel.answersFor(0.3));
    }
    /// Moves the servo to this distance from home, in counts, and waits until it rests there.
    static void moveTo(VirtualPanel& panel, std::int32_t fromHome) {
        const std::int32_t goal = panel.module().home.place()->counts + fromHome;
        panel.ask(intent::Move{
            servomotion::Trapezoid{Counts(goal), CountsPerTick(8 << 16), CountsPerTickSquared(6'554)}});
        ASSERT_TRUE(panel.waitFor([&] {
            return !panel.module().moving() && std::abs(*panel.module().latest->position - goal) < 5;
        }));
    }
    /// Takes the power of all modules away and restores it.
    void power() { (void)sim.control(u"power-cycle all"_s); }
    [[nodiscard]] static QString head(VirtualPanel& panel) {
        return panel.window().findChild<QLabel*>(u"homeState"_s)->text();
    }
    VirtualChain sim{u"servo,servo"_s};
    QTemporaryDir folder;
    const QString offer = u"from home when last seen"_s;
};

TEST_F(PositionKept, IsOfferedAfterAPowerOffAndIsNotVerifiedUntilHomeIsSavedAgain) {
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
        panel.disconnect();
        ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    }
    power();
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(offer) != nullptr; }))
        << panel.headlines().join(u" | "_s).toStdString();
    EXPECT_FALSE(panel.module().home.place().has_value()) << "it is never restored automatically";
    EXPECT_EQ(head(panel), u"Home: unknown"_s);
    ASSERT_TRUE(panel.press(offer, u"Restore home"_s));
    ASSERT_TRUE(panel.module().home.place().has_value());
    // It stood at 5 000, within 4 counts, and its position is saved again from 5 counts on; its counter
    // started at 0 there.
    EXPECT_NEAR(panel.module().home.place()->counts, -5'000, 4 + 5);
    EXPECT_TRUE(panel.waitFor([&] { return head(panel).endsWith(u"not verified"_s); }))
        << head(panel).toStdString();
    EXPECT_EQ(panel.standing(offer), nullptr);
    panel.ask(intent::SaveAsHome{});
    EXPECT_TRUE(panel.waitFor([&] {
        const auto& place = panel.module().home.place();
        return place && place->verified();
    }));
    EXPECT_TRUE(panel.waitFor([&] { return !head(panel).contains(u"not verified"_s); }));
}

TEST_F(PositionKept, WhatIsForgottenIsNotOfferedAgain) {
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
    }
    power();
    {
        VirtualPanel panel({}, {}, folder.path());
        panel.start();
        ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
        ASSERT_TRUE(panel.waitFor([&] { return panel.standing(offer) != nullptr; }));
        ASSERT_TRUE(panel.press(offer, u"Discard"_s));
        EXPECT_EQ(panel.standing(offer), nullptr);
        ASSERT_TRUE(panel.answersFor(1.0));
    }
    power();
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(offer), 0);
}

TEST_F(PositionKept, OneThatMovedWhenItsPowerWentIsNotOffered) {
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
        panel.ask(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(8 << 16), CountsPerTickSquared(1'311), false}});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() == Activity::AtSpeed; }));
        power();
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().silent || !panel.connected(); }));
    }
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(offer), 0);
}

/// Quitting stops the motor, which is then known to be at rest.
TEST_F(PositionKept, OneThatWasStoppedByQuittingIsOffered) {
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
        panel.ask(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(8 << 16), CountsPerTickSquared(1'311), false}});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() == Activity::AtSpeed; }));
        panel.composition().stopAndQuit();
        ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    }
    const int rests = sim.state(1)[u"position"_s].toInt();
    power();
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(offer) != nullptr; }));
    ASSERT_TRUE(panel.press(offer, u"Restore home"_s));
    // The counter started at 0 where the motor rests; home was at 0.
    EXPECT_NEAR(panel.module().home.place()->counts, -rests, 4 + 5);
}

TEST_F(PositionKept, ThatOfAnotherPanelReplacesWhatThisOneRemembers) {
    const auto isClosed = [](VirtualPanel& panel) {
        panel.disconnect();
        return panel.waitFor([&] { return !panel.composition().worker().isOpen(); });
    };
    VirtualPanel panel({}, {}, folder.path());
    ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
    ASSERT_TRUE(isClosed(panel));
    {
        VirtualPanel another({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(another.startAt(sim.terminal()));
        another.ask(intent::SaveAsHome{});
        ASSERT_TRUE(another.waitFor([&] { return another.module().home.place().has_value(); }));
        ASSERT_TRUE(another.answersFor(1.0)) << "a rest is kept half a second later";
        ASSERT_TRUE(isClosed(another));
    }
    power();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(offer) != nullptr; }));
    ASSERT_TRUE(panel.press(offer, u"Restore home"_s));
    // It was at home, and its counter started at 0 there. It had been within 4 counts of its goal when home
    // was saved, and afterwards; its position is saved again from 5 counts on.
    EXPECT_NEAR(panel.module().home.place()->counts, 0, 4 + 4 + 5);
}

/// The disk carries out the last request first.
TEST_F(PositionKept, IsReadOnlyWhenWhatIsLeftOutIsNotInTheFileAnyMore) {
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
    }
    const QString positions = folder.filePath(u"positions"_s);
    const auto kept = [&positions] {
        const QFileInfoList files = QDir(positions).entryInfoList(QDir::Files);
        return readRemembered(readFile(files.value(0).filePath(), 10'000).value_or("")).positions.size();
    };
    ASSERT_EQ(kept(), 1U);
    std::vector<std::function<void()>> waits;
    setBackground([&waits](std::function<void()> work) { waits.push_back(std::move(work)); });
    {
        BusWorker worker;
        BusStore store(worker);
        store.begin(sim.terminal(), false, 115'200, false);
        PositionKeeper keeper(positions, store);
        keeper.begin(sim.terminal(), true);
        keeper.leaveOut({ModuleIndex(0)});
        keeper.begin(sim.terminal(), true);
        while (!waits.empty()) {
            const std::function<void()> last = std::move(waits.back());
            waits.pop_back();
            last();
            QCoreApplication::processEvents();
        }
        setBackground([](const std::function<void()>& work) { work(); });
        keeper.setMachine("mill");  // so that there is something to write at its end
    }
    EXPECT_EQ(kept(), 0U);
}

/// A disk that is full from when the servo rests at 5 000 counts.
class PositionOnAFullDisk : public PositionKept {
protected:
    /// Fills the disk, and moves the servo to 8 000 counts away from home.
    void fillAndMove(VirtualPanel& panel) {
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
        ASSERT_TRUE(panel.answersFor(1.0)) << "a rest is kept half a second later";
        ASSERT_EQ(QDir(folder.filePath(u"positions"_s)).entryList(QDir::Files).size(), 1);
        full = true;
        ASSERT_NO_FATAL_FAILURE(moveTo(panel, 8'000));
        ASSERT_TRUE(panel.answersFor(2.0));
        EXPECT_EQ(panel.count(u"positions of the axes are not saved"_s), 1) << "it is tried more often";
    }
    std::atomic<bool> full = false;
    const FileWriter::Disk disk = [this](const QString& path, std::string_view content) {
        return full ? FileWriter::Result(tl::unexpected(FileError{FileErrorKind::NoSpace, path}))
                    : writeFile(path, content);
    };
};

TEST_F(PositionOnAFullDisk, IsNotOfferedFromWhereTheAxisWasBefore) {
    {
        VirtualPanel panel({}, {}, folder.path(), disk);
        ASSERT_NO_FATAL_FAILURE(fillAndMove(panel));
    }
    power();
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(offer), 0);
}

TEST_F(PositionOnAFullDisk, IsWrittenOnceThereIsRoom) {
    {
        VirtualPanel panel({}, {}, folder.path(), disk);
        ASSERT_NO_FATAL_FAILURE(fillAndMove(panel));
        full = false;
        ASSERT_TRUE(panel.answersFor(1.0));
    }
    power();
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(offer) != nullptr; }));
    ASSERT_TRUE(panel.press(offer, u"Restore home"_s));
    // It stood at 8 000, within 4 counts, and its position is saved again from 5 counts on; its counter
    // started at 0 there.
    EXPECT_NEAR(panel.module().home.place()->counts, -8'000, 4 + 5);
}

/// Positions are kept for the chain at a port, whichever file the machine was in when it last moved.
class PositionOfAMachine : public PositionKept {
protected:
    /// "press" is saved while the servo stands at 5 000; then the modules lose power.
    void leavePressAt5000() {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(leaveAt5000(panel));
        Hand hand(panel);
        hand.strike(Qt::CTRL | Qt::Key_S);
        ASSERT_NO_FATAL_FAILURE(hand.chooseFile(press));
        ASSERT_TRUE(panel.waitFor([&] { return panel.composition().machine().name == "press"; }));
        Machine other;
        other.name = "mill";
        ASSERT_TRUE(writeFile(mill, writeMachine(other)).has_value());
        power();
    }
    /// Connects to the chain, and waits for the offer. The rate is the one at which a restarted module
    /// listens, so that it can get its address again.
    void begin(VirtualPanel& panel) {
        panel.composition().show({sim.terminal(), 19'200, false});
        ASSERT_TRUE(panel.waitFor([&] { return panel.standing(offer) != nullptr; }));
    }
    void open(VirtualPanel& panel, const QString& file, const char* name) {
        emit panel.window().machineMenu().openRequested(file);
        Hand hand(panel);
        ASSERT_NO_FATAL_FAILURE(hand.click(u"Apply"_s));
        ASSERT_TRUE(panel.waitFor([&] { return panel.composition().machine().name == name; }));
    }
    const QString press = folder.filePath(u"press.json"_s);
    const QString mill = folder.filePath(u"mill.json"_s);
};

TEST_F(PositionOfAMachine, IsOfferedUnlessAnotherMachineIsOpened) {
    ASSERT_NO_FATAL_FAILURE(leavePressAt5000());
    VirtualPanel panel({}, {}, folder.path());
    ASSERT_NO_FATAL_FAILURE(begin(panel));
    ASSERT_NO_FATAL_FAILURE(open(panel, press, "press"));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_NE(panel.standing(offer), nullptr) << "it is the same machine";
    ASSERT_NO_FATAL_FAILURE(open(panel, mill, "mill"));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(panel.standing(offer), nullptr) << "that machine has never been seen here";
}

TEST_F(PositionOfAMachine, IsNotOfferedToAnotherWhoseModuleWasSilentWhenItWasOpened) {
    ASSERT_NO_FATAL_FAILURE(leavePressAt5000());
    VirtualPanel panel({}, {}, folder.path());
    ASSERT_NO_FATAL_FAILURE(begin(panel));
    (void)sim.control(u"power-cycle 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().silent; }));
    ASSERT_NO_FATAL_FAILURE(open(panel, mill, "mill"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"Module 1 restarted"_s) != nullptr; }));
    ASSERT_TRUE(panel.press(u"Module 1 restarted"_s, u"Assign the address of module 1"_s));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module().silent; }));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.standing(offer), nullptr);
}

}  // namespace
}  // namespace nmc
