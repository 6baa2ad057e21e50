// SPDX-License-Identifier: GPL-3.0-or-later
// Work offsets: what the present position is called, and every place where a position is then read or typed.
#include "tests/model/stepperfixture.h"
#include "tests/support/motionof.h"
#include "widgets/chain/chainmodel.h"
#include "windowtest.h"

namespace nmc {
namespace {

using testing::ElementsAre;

const QString kNothing = u"–"_s;

/// 100 counts are 1 mm. The servo stands 25 mm from home, which is where its counter is 0.
class WorkOffsets : public WindowTest {
protected:
    WorkOffsets() {
        window->resize(1500, 1100);
        machine.axes.resize(1);
        machine.axes[0].unit = {UnitKind::Millimetres, 100.0, ""};
        window->showMachine(machine);
        // As the store does.
        QObject::connect(&window->requests(), &Requests::workOffset, window.get(),
                         [this](ModuleIndex, const std::optional<WorkOffset>& offset,
                                const std::optional<std::int32_t>& home) {
                             module.home.useWork(offset, home);
                             show();
                         });
        module.home.found(0, module.latestTime);
        show();
    }
    void show() {
        module.travel = machine.axes[0].travel;
        window->showLink(connectedTo({module}));
    }
    void call(const QString& number, const QString& name) {
        type(u"calledField"_s, number);
        auto* field = find<QLineEdit>(u"calledNameField"_s);
        field->setFocus();
        QTest::keyClicks(field, name);
    }
    /// Calls the present position 10 mm of fixture A, whose 0 is 15 mm from home.
    void callFixture() {
        call(u"10"_s, u"fixture A"_s);
        click(u"callButton"_s);
    }
    QString whyNot(const QString& name) {
        auto* control = button(name);
        EXPECT_FALSE(control->isEnabled()) << name.toStdString();
        return control->toolTip();
    }
    [[nodiscard]] std::int32_t goal() {
        EXPECT_FALSE(intents.isEmpty());
        return test::motionOf<servomotion::Trapezoid>(
                   std::get<intent::Move>(intents.last().at(1).value<Intent>()))
            .position.value();
    }
    QModelIndex listed() { return find<QListView>(u"chainList"_s)->model()->index(0, 0); }

    ModuleState module = Servo{.position = 2'500}.state();
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(WorkOffsets, AreCalledByWhatThePositionIsAndKeptWithTheAxis) {
    callFixture();
    EXPECT_THAT(machine.axes[0].workOffsets, ElementsAre(WorkOffset{"fixture A", 1'500}));
    EXPECT_EQ(text(u"positionLabel"_s), u"10.00"_s);
    EXPECT_EQ(text(u"headWork"_s), u"◇ from \"fixture A\""_s);
    EXPECT_EQ(text(u"otherPosition"_s), u"counter: 25 mm"_s);
    EXPECT_EQ(text(u"homeState"_s), u"Home: −15 mm from \"fixture A\""_s);
    EXPECT_EQ(find<QLabel>(u"positionLabel"_s)->accessibleName(), u"Position 10.00 mm, from \"fixture A\""_s);
    EXPECT_TRUE(intents.isEmpty());
    click(u"workClearButton"_s);
    EXPECT_EQ(text(u"positionLabel"_s), u"25.00"_s);
    EXPECT_EQ(text(u"headWork"_s), QString());
    EXPECT_EQ(text(u"otherPosition"_s), u"= 2\u202f500 counts"_s);
    EXPECT_EQ(text(u"homeState"_s), u"Home: 0 mm"_s);
    EXPECT_EQ(machine.axes[0].workOffsets.size(), 1U) << "it is still there to be chosen";
    pick(u"workChoice"_s, u"fixture A"_s);
    EXPECT_EQ(text(u"positionLabel"_s), u"10.00"_s);
    click(u"workDeleteButton"_s);
    EXPECT_EQ(text(u"positionLabel"_s), u"25.00"_s);
    EXPECT_TRUE(machine.axes[0].workOffsets.empty());
    EXPECT_TRUE(intents.isEmpty());
}

TEST_F(WorkOffsets, OnAReversedAxisCountTheOtherWay) {
    machine.axes[0].unit.countsPerUnit = -100.0;
    window->showMachine(machine);
    EXPECT_EQ(text(u"positionLabel"_s), u"−25.00"_s);
    callFixture();
    EXPECT_EQ(machine.axes[0].workOffsets.front().counts, 3'500);
    EXPECT_EQ(text(u"positionLabel"_s), u"10.00"_s);
    type(u"goalField"_s, u"12"_s);
    click(u"goButton"_s);
    EXPECT_EQ(goal(), 2'300);
}

TEST_F(WorkOffsets, AreWhatATypedGoalCountsFrom) {
    type(u"goalField"_s, u"30"_s);
    callFixture();
    EXPECT_EQ(field(u"goalField"_s)->text(), u"15"_s) << "still the same place";
    EXPECT_EQ(text(u"goalFieldPerSecond"_s), u"from \"fixture A\""_s);
    click(u"goButton"_s);
    EXPECT_EQ(goal(), 3'000);
    type(u"goalField"_s, u"7.5"_s);
    click(u"workClearButton"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"22.5"_s);
    window->showLink(connectedTo({Servo{.position = 2'500, .millisecond = 10}.state()}));
    click(u"goButton"_s);
    EXPECT_EQ(goal(), 2'250);
}

TEST_F(WorkOffsets, ADistanceCountsFromWhereTheMotorIs) {
    callFixture();
    type(u"goalField"_s, u"4"_s);
    find<QComboBox>(u"goalKindBox"_s)->setCurrentIndex(1);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"4"_s);
    EXPECT_EQ(text(u"goalFieldPerSecond"_s), u"= 400 counts"_s);
    click(u"goButton"_s);
    EXPECT_EQ(goal(), 2'900);
    find<QComboBox>(u"goalKindBox"_s)->setCurrentIndex(0);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"4"_s);
    click(u"workClearButton"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"19"_s) << "15 + 4";
}

TEST_F(WorkOffsets, LimitsCountFromHomeAndEverySentenceSaysFromWhere) {
    type(u"highestField"_s, u"40"_s);
    QTest::keyClick(field(u"highestField"_s), Qt::Key_Return);
    callFixture();
    EXPECT_EQ(field(u"highestField"_s)->text(), u"40"_s);
    EXPECT_EQ(machine.axes[0].travel.highest, 4'000);
    EXPECT_EQ(find(u"highestField"_s)->accessibleName(), u"Highest position, from home"_s);
    EXPECT_EQ(text(u"travelState"_s), u"● In force: not above 25 mm from \"fixture A\"."_s);
    type(u"goalField"_s, u"26"_s);
    EXPECT_EQ(
        whyNot(u"goButton"_s),
        u"That is beyond the travel limits: the highest position is 25 mm from \"fixture A\" (Axis page)."_s);
    EXPECT_EQ(button(u"nearestGoalButton"_s)->text(), u"Use 25 mm from \"fixture A\""_s);
    click(u"nearestGoalButton"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"25"_s);
    click(u"goButton"_s);
    EXPECT_EQ(goal(), 4'000);
}

/// No number is better than a wrong one.
TEST_F(WorkOffsets, ThatAreNotKnownAnyMoreShowNoPositionAndTakeNone) {
    callFixture();
    type(u"goalField"_s, u"12"_s);
    module.restarted();
    module.home.found(0, module.latestTime);
    show();
    EXPECT_EQ(text(u"positionLabel"_s), kNothing);
    EXPECT_EQ(find<QLabel>(u"positionLabel"_s)->accessibleName(), u"Position unknown"_s);
    EXPECT_EQ(text(u"headWork"_s), u"◇ from \"fixture A\": not known"_s);
    EXPECT_EQ(text(u"otherPosition"_s), u"counter: 25 mm"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), QString());
    EXPECT_TRUE(find<QComboBox>(u"workChoice"_s)->currentText().isEmpty());
    const QString where = u"It is not known any more where \"fixture A\" is."_s;
    EXPECT_TRUE(text(u"workHint"_s).startsWith(where));
    EXPECT_TRUE(text(u"motionHint"_s).startsWith(where));
    EXPECT_EQ(listed().data(ChainModel::Position), u"◇ – mm"_s);
    pick(u"workChoice"_s, u"fixture A"_s);
    EXPECT_EQ(text(u"positionLabel"_s), u"10.00"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), QString()) << "12 mm was another place";
    EXPECT_EQ(text(u"workHint"_s), QString());
}

TEST_F(WorkOffsets, AreMarkedInTheListAndInTheTableOfAllAxes) {
    QTest::keyClick(window->windowHandle(), Qt::Key_F4);
    EXPECT_EQ(listed().data(ChainModel::Position), u"25.00 mm"_s);
    EXPECT_TRUE(listed().data(ChainModel::HomeIsKnown).toBool());
    EXPECT_EQ(text(u"axisPosition1"_s), u"25.00 mm"_s);
    callFixture();
    EXPECT_EQ(listed().data(ChainModel::Position), u"◇ 10.00 mm"_s);
    EXPECT_FALSE(listed().data(ChainModel::HomeIsKnown).toBool()) << "it does not count from home";
    EXPECT_TRUE(
        listed()
            .data(Qt::AccessibleTextRole)
            .toString()
            .contains(
                u"position ◇ 10.00 mm. Positions count from \"fixture A\". Home: −15 mm from \"fixture A\""_s));
    EXPECT_EQ(text(u"axisPosition1"_s), u"◇ 10.00 mm"_s);
    EXPECT_EQ(find<QLabel>(u"axisPosition1"_s)->toolTip(), u"Positions count from \"fixture A\"."_s);
}

TEST_F(WorkOffsets, WithoutAHomeLastForTheSessionAndAreNotKept) {
    module.home.forget();
    show();
    EXPECT_TRUE(text(u"workHint"_s).startsWith(u"Home is unknown: an offset lasts only until"_s));
    callFixture();
    EXPECT_EQ(text(u"positionLabel"_s), u"10.00"_s);
    EXPECT_TRUE(machine.axes[0].workOffsets.empty());
    EXPECT_EQ(find<QComboBox>(u"workChoice"_s)->currentText(), u"fixture A"_s);
    EXPECT_EQ(whyNot(u"workDeleteButton"_s), u"Choose the work offset first."_s) << "there is none to delete";
    machine.axes[0].workOffsets = {{"fixture B", 0}};
    window->showMachine(machine);
    EXPECT_FALSE(find<QComboBox>(u"workChoice"_s)->isEnabled()) << "it counts from home";
    click(u"workClearButton"_s);
    EXPECT_EQ(text(u"positionLabel"_s), u"25.00"_s);
}

TEST_F(WorkOffsets, WhatCannotBeCalledIsSaidAndChangesNothing) {
    callFixture();
    const std::vector<WorkOffset> before = machine.axes[0].workOffsets;
    EXPECT_TRUE(whyNot(u"callButton"_s).startsWith(u"Enter a name"_s));
    call(u"3"_s, u"fixture A"_s);
    EXPECT_TRUE(whyNot(u"callButton"_s).startsWith(u"Another work offset of this axis has this name."_s));
    EXPECT_EQ(text(u"workHint"_s), whyNot(u"callButton"_s));
    QTest::keyClick(find<QLineEdit>(u"calledNameField"_s), Qt::Key_Return);
    call(u"-21474830"_s, u"B"_s);
    EXPECT_TRUE(whyNot(u"callButton"_s).startsWith(u"With this number, the work offset would be outside"_s))
        << "2147483000 + 2500 counts";
    type(u"calledField"_s, u"x"_s);
    EXPECT_TRUE(whyNot(u"callButton"_s).contains(u"must be a number"_s));
    type(u"calledField"_s, u"3"_s);
    EXPECT_TRUE(button(u"callButton"_s)->isEnabled());
    module.latest->position.reset();
    show();
    EXPECT_EQ(whyNot(u"callButton"_s), u"The position is unknown."_s);
    EXPECT_EQ(machine.axes[0].workOffsets, before);
    window->showLink({});
    EXPECT_TRUE(intents.isEmpty());
}

TEST_F(WorkOffsets, InOperatorModeStayAsTheyAre) {
    callFixture();
    module.rights = OperatorRights{};
    show();
    for (const QString& name : {u"workClearButton"_s, u"workDeleteButton"_s, u"callButton"_s})
        EXPECT_TRUE(whyNot(name).startsWith(u"Not allowed in operator mode."_s)) << name.toStdString();
    EXPECT_FALSE(find<QComboBox>(u"workChoice"_s)->isEnabled());
    EXPECT_EQ(text(u"positionLabel"_s), u"10.00"_s);
}

TEST_F(WorkOffsets, AStepperHasTheSamePage) {
    testing_support::Stepper stepper = testing_support::Stepper::holding();
    stepper.module.home.found(0, stepper.time);
    machine.axes[0] = {};
    machine.axes[0].workOffsets = {{"fixture A", 400}};
    window->showMachine(machine);
    stepper.module.home.useWork(machine.axes[0].workOffsets.front(), 0);
    window->showLink(connectedTo({stepper.module}));
    EXPECT_EQ(find<QComboBox>(u"stepperWorkChoice"_s)->currentText(), u"fixture A"_s);
    EXPECT_EQ(text(u"stepperGoalFieldPerSecond"_s), u"from \"fixture A\""_s);
    type(u"stepperGoalField"_s, u"-150"_s);
    click(u"stepperGoButton"_s);
    const auto move = test::motionOf<steppermotion::Trapezoid>(
        std::get<intent::Move>(intents.last().at(1).value<Intent>()));
    EXPECT_EQ(move.position, 250);
    type(u"stepperGoalField"_s, u"50"_s);
    find<QAbstractButton>(u"stepperRelativeBox"_s)->setChecked(true);
    EXPECT_EQ(field(u"stepperGoalField"_s)->text(), u"50"_s);
    EXPECT_EQ(text(u"stepperGoalFieldPerSecond"_s), QString());
}

}  // namespace
}  // namespace nmc
