// SPDX-License-Identifier: GPL-3.0-or-later
// Work offsets in the whole program: nothing is sent for them, typed positions lead to the right place, and
// they are in the machine file.
#include <gmock/gmock.h>

#include "link/files/machineio.h"
#include "model/machinefile/machinefile.h"
#include "tests/support/changes.h"
#include "tests/support/hand.h"
#include "widgets/machine/machinemenu.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing::ElementsAre;
using testing_support::changes;
using testing_support::Hand;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// 400 counts are 1 mm. The servo holds where its counter is 0, and home is there.
class WorkOffsetSession : public testing::Test {
protected:
    void SetUp() override {
        panel.window().resize(1'500, 1'000);
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(panel.makeReady());
        AxisSettings axis = panel.composition().machine().axis(ModuleIndex(0));
        axis.unit = {UnitKind::Millimetres, 400.0, ""};
        emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
        panel.ask(intent::SaveAsHome{});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
        ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
    }
    void call(const QString& number, const QString& name) {
        ASSERT_NO_FATAL_FAILURE(hand.type(u"Number for the present position"_s, number));
        ASSERT_NO_FATAL_FAILURE(hand.type(u"Name of the work offset"_s, name));
        ASSERT_NO_FATAL_FAILURE(hand.click(u"Call this position"_s));
    }
    [[nodiscard]] QString head() { return panel.window().findChild<QLabel*>(u"positionLabel"_s)->text(); }
    [[nodiscard]] bool reads(double millimetres) {
        return panel.waitFor([&] { return std::abs(QLocale::c().toDouble(head()) - millimetres) < 0.05; });
    }
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
    Hand hand{panel};
};

TEST_F(WorkOffsetSession, SendsNothingAndTypedPositionsCountFromIt) {
    const QJsonArray before = changes(sim);
    const HomeFact::Place home = *panel.module().home.place();
    ASSERT_NO_FATAL_FAILURE(call(u"10"_s, u"A"_s));
    EXPECT_TRUE(reads(10)) << head().toStdString();
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Clear work offset"_s));
    EXPECT_TRUE(reads(0)) << head().toStdString();
    ASSERT_NO_FATAL_FAILURE(hand.choose(u"the counter"_s, u"A"_s));
    EXPECT_TRUE(reads(10)) << head().toStdString();
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim), before);
    EXPECT_EQ(panel.module().home.place(), home);
    EXPECT_LT(std::abs(sim.state(1)[u"position"_s].toInt()), 20);
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Goal position"_s, u"12"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Go to the position"_s));
    const auto position = [&] { return sim.state(1)[u"position"_s].toInt(); };
    // 2 mm farther than what is called 10 mm, at counter 0.
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(position() - 800) < 20 && !moves(sim); })) << position();
    EXPECT_TRUE(reads(12)) << head().toStdString();

    // A typed goal stays the same place when the counter is set to 0 here: it is 3 mm away.
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Goal position"_s, u"15"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Zero here: set the present position to 0"_s));
    ASSERT_TRUE(panel.waitFor([&] { return std::abs(position()) < 20; })) << position();
    EXPECT_TRUE(reads(12)) << head().toStdString();
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Go to the position"_s));
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(position() - 1'200) < 20 && !moves(sim); }))
        << position();
    EXPECT_TRUE(reads(15)) << head().toStdString();
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(WorkOffsetSession, IsInTheMachineFileAndNotKnownAfterAPowerFailure) {
    ASSERT_NO_FATAL_FAILURE(call(u"10"_s, u"A"_s));
    ASSERT_NO_FATAL_FAILURE(call(u"-2.5"_s, u"B"_s));
    EXPECT_TRUE(panel.waitFor([&] { return head().startsWith(u'\u2212'); })) << head().toStdString();
    QTemporaryDir folder;
    const QString file = folder.filePath(u"mill.json"_s);
    hand.strike(Qt::CTRL | Qt::SHIFT | Qt::Key_S);
    ASSERT_NO_FATAL_FAILURE(hand.chooseFile(file));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.window().machineMenu().file().saving; }));
    const auto read = parseMachine(readFile(file, kMaxMachineFile).value_or(""));
    ASSERT_TRUE(read);
    // Home was saved and read back within a few counts of 0.
    const std::int32_t off = panel.module().latest->position.value_or(0);
    ASSERT_EQ(read->machine.axes.at(0).workOffsets.size(), 2U);
    EXPECT_EQ(read->machine.axes[0].workOffsets[0].name, "A");
    EXPECT_NEAR(read->machine.axes[0].workOffsets[0].counts, off - 4'000, 20);
    EXPECT_NEAR(read->machine.axes[0].workOffsets[1].counts, off + 1'000, 20);

    (void)sim.control(u"power-cycle all"_s);
    EXPECT_TRUE(panel.waitFor([&] { return head() == u"–"_s; })) << head().toStdString();
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().hasRestarted; }));
    EXPECT_EQ(panel.module().home.workZero(),
              (WorkZero{panel.composition().machine().axis(ModuleIndex(0)).workOffsets.at(1), {}}));
}

TEST_F(WorkOffsetSession, OfAFileIsNotInUseByItself) {
    Machine machine = panel.composition().machine();
    machine.axes.at(0).workOffsets = {{"A", 4'000}};
    QTemporaryDir folder;
    const QString file = folder.filePath(u"mill.json"_s);
    ASSERT_TRUE(writeFile(file, writeMachine(machine)));
    ASSERT_NO_FATAL_FAILURE(call(u"0"_s, u"A"_s));
    EXPECT_TRUE(reads(0));
    emit panel.window().machineMenu().openRequested(file);
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Apply"_s));
    ASSERT_TRUE(panel.waitFor(
        [&] { return panel.composition().machine().axes.at(0).workOffsets.front().counts == 4'000; }));
    EXPECT_TRUE(panel.waitFor([&] { return head() == u"–"_s; })) << "A is another place now";
    ASSERT_NO_FATAL_FAILURE(hand.choose(u"Positions count from this work offset"_s, u"A"_s));
    EXPECT_TRUE(panel.waitFor([&] { return head().startsWith(u"\u221210.0"_s); })) << head().toStdString();
}

}  // namespace
}  // namespace nmc
