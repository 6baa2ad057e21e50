// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/stepperfixture.h"
#include "tests/support/motionof.h"
#include "widgets/chain/chainmodel.h"
#include "widgets/common/look.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Axis : public WindowTest {
protected:
    Axis() { showServo({.position = 500}); }
    void showPage(const QString& page) {
        auto* pages = find<QTabWidget>(u"servoPages"_s);
        for (int i = 0; i < pages->count(); ++i)
            if (pages->tabText(i) == page)
                pages->setCurrentIndex(i);
    }
    /// Shows values in turns of 2000 counts.
    void readInTurns() {
        showPage(u"Axis"_s);
        choose(u"axisUnitBox"_s, u"turns"_s);
        type(u"countsPerUnitField"_s, u"2000"_s);
    }
    void choose(const QString& box, const QString& entry) {
        auto* combo = find<QComboBox>(box);
        combo->setCurrentIndex(combo->findText(entry));
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(Axis, ItsNameStandsEverywhere) {
    showPage(u"Axis"_s);
    auto* name = find<QLineEdit>(u"axisNameField"_s);
    QTest::keyClicks(name, u"Z axis"_s);
    EXPECT_EQ(text(u"moduleName"_s), u"Module 1 \"Z axis\""_s);
    EXPECT_EQ(machine.axes.front().name, "Z axis");
    const QModelIndex row = find<QAbstractItemView>(u"chainList"_s)->model()->index(0, 0);
    EXPECT_EQ(row.data(ChainModel::Title).toString(), u"Z axis"_s) << "its number is shown on the wire";
    EXPECT_TRUE(row.data(Qt::AccessibleTextRole).toString().startsWith(u"Module 1 \"Z axis\""_s));
    EXPECT_EQ(name->text(), u"Z axis"_s);
    QTest::keyClick(name, Qt::Key_Space);
    EXPECT_EQ(machine.axes.front().name, "Z axis") << "programs and path files would not find it by its name";
    EXPECT_EQ(name->text(), u"Z axis "_s) << "another word may follow";
}

TEST_F(Axis, SaysThatAnotherAxisHasTheSameName) {
    showServos({{}, {}});
    machine.axes.resize(2);
    machine.axes[1].name = "Z axis";
    window->showMachine(machine);
    showPage(u"Axis"_s);
    auto* name = find<QLineEdit>(u"axisNameField"_s);
    auto* hint = find<QLabel>(u"axisHint"_s);
    QTest::keyClicks(name, u"Z"_s);
    EXPECT_FALSE(hint->isVisible());
    QTest::keyClicks(name, u" axis"_s);
    EXPECT_TRUE(hint->isVisible());
    EXPECT_EQ(hint->text(), u"Axis 2 has the same name, so programs can call neither by it."_s);
    name->clear();
    QTest::keyClicks(name, u"Y"_s);
    EXPECT_FALSE(hint->isVisible());
}

TEST_F(Axis, U05_AnotherUnitKeepsEveryAmountAndSendsNothing) {
    type(u"goalField"_s, u"3000"_s);
    type(u"velocityField"_s, u"1"_s);
    readInTurns();
    EXPECT_EQ(text(u"positionLabel"_s), u"0.2500"_s);
    EXPECT_EQ(text(u"positionUnit"_s), u"turns"_s);
    EXPECT_EQ(text(u"otherPosition"_s), u"= 500 counts"_s);
    EXPECT_EQ(field(u"goalField"_s)->value(), 1.5);
    EXPECT_EQ(text(u"goalFieldPerSecond"_s), u"= 3\u202f000 counts"_s);
    // 1 count/tick is 1953.125 counts/s.
    EXPECT_DOUBLE_EQ(*field(u"velocityField"_s)->value(), 0.97656);
    EXPECT_EQ(text(u"velocityFieldUnit"_s), u"turns/s"_s);
    EXPECT_EQ(text(u"velocityFieldPerSecond"_s), u"= 1 counts/tick"_s);
    EXPECT_EQ(intents.size(), 0);
    // The value that was typed is sent, not the rounded one that is shown.
    click(u"goButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto go = test::motionOf<servomotion::Trapezoid>(intents.at(0).at(1).value<Intent>());
    EXPECT_EQ(go.position.value(), 3000);
    EXPECT_EQ(go.velocity.value(), 65536U);
}

TEST_F(Axis, CountsDropTheCountsPerUnit) {
    readInTurns();
    choose(u"axisUnitBox"_s, u"native counts"_s);
    choose(u"axisUnitBox"_s, u"turns"_s);
    EXPECT_EQ(machine.axes.front().unit.countsPerUnit, 1.0);
    EXPECT_EQ(field(u"countsPerUnitField"_s)->value(), 1.0);
}

TEST_F(Axis, ValuesAreTypedInTheUsersUnit) {
    readInTurns();
    type(u"goalField"_s, u"-0,75"_s);
    type(u"velocityField"_s, u"0.9765625"_s);
    click(u"goButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto go = test::motionOf<servomotion::Trapezoid>(intents.at(0).at(1).value<Intent>());
    EXPECT_EQ(go.position.value(), -1500);
    EXPECT_EQ(go.velocity.value(), 65536U);
}

TEST_F(Axis, WhatIsBeingTypedIsNotTouched) {
    readInTurns();
    type(u"velocityField"_s, u"1."_s);
    EXPECT_EQ(field(u"velocityField"_s)->text(), u"1."_s);
    type(u"velocityField"_s, u"0.50"_s);
    EXPECT_EQ(field(u"velocityField"_s)->text(), u"0.50"_s);
    type(u"velocityField"_s, u"x"_s);
    showServo({.position = 501});
    EXPECT_EQ(field(u"velocityField"_s)->text(), u"x"_s);
}

TEST_F(Axis, HoldToMoveHasACapThatIsRaisedElsewhere) {
    type(u"holdVelocityField"_s, u"2.5"_s);
    EXPECT_FALSE(button(u"holdForwardButton"_s)->isEnabled());
    EXPECT_TRUE(text(u"jogHint"_s).contains(u"to 2 counts/tick"_s)) << text(u"jogHint"_s).toStdString();
    showPage(u"Axis"_s);
    type(u"holdCapField"_s, u"4"_s);
    type(u"holdVelocityField"_s, u"2.5"_s);
    EXPECT_TRUE(button(u"holdForwardButton"_s)->isEnabled());
}

TEST_F(Axis, TheAnalogValueIsReadInItsOwnScale) {
    showPage(u"Axis"_s);
    type(u"analogPerCountField"_s, u"0.02"_s);
    type(u"analogAtZeroField"_s, u"-1"_s);
    auto* unit = find<QLineEdit>(u"analogUnitField"_s);
    unit->selectAll();
    QTest::keyClicks(unit, u"A"_s);
    ModuleState module = Servo{}.state();
    module.latest->analog = std::uint8_t(125);
    window->showLink(connectedTo({module}));
    EXPECT_EQ(text(u"analogValue"_s), u"1.5 A (125 of 255)"_s);  // -1 + 125 x 0.02
}

// ---- the same page for both chips ----

class AxisOfEach : public Axis, public testing::WithParamInterface<ModuleType> {
protected:
    AxisOfEach() {
        ModuleState module = Servo{}.state();
        if (GetParam() == ModuleType::Stepper)
            module = testing_support::Stepper::holding().module;
        window->showLink(connectedTo({module}));
    }
    static QString named(const QString& name) { return look::nameFor(GetParam(), name); }
    QLineEdit* edit(const QString& name) { return find<QLineEdit>(named(name)); }
};

TEST_P(AxisOfEach, ASymbolMayHaveSpaces) {
    choose(named(u"axisUnitBox"_s), u"custom unit"_s);
    QTest::keyClicks(edit(u"axisSymbolField"_s), u"ml per s"_s);
    EXPECT_EQ(edit(u"axisSymbolField"_s)->text(), u"ml per s"_s);
    EXPECT_EQ(machine.axes.at(0).unit.ownSymbol, "ml per s");
    QTest::keyClick(edit(u"axisSymbolField"_s), Qt::Key_Space);
    EXPECT_EQ(machine.axes.at(0).unit.ownSymbol, "ml per s") << "a space at its end does not belong to it";
}

TEST_P(AxisOfEach, NamingItKeepsTheAnalogScaleToTheLastDigit) {
    machine.axes.resize(1);
    machine.axes[0].analog = {5.0 / 255, 1.0 / 3, "V"};
    window->showMachine(machine);
    QTest::keyClicks(edit(u"axisNameField"_s), u"Z axis"_s);
    EXPECT_EQ(machine.axes.at(0).name, "Z axis");
    EXPECT_EQ(machine.axes.at(0).analog.perCount, 5.0 / 255);
    EXPECT_EQ(machine.axes.at(0).analog.atZero, 1.0 / 3);
}

INSTANTIATE_TEST_SUITE_P(Chips, AxisOfEach, testing::Values(ModuleType::Servo, ModuleType::Stepper),
                         [](const auto& chip) {
                             return chip.param == ModuleType::Servo ? "Servo" : "Stepper";
                         });

/// 500 lines are 2000 counts per turn; after a 2 : 1 gear and with a screw of 5 mm, that is 800 counts per
/// millimetre.
TEST_F(Axis, ItsUnitIsWorkedOutFromLabels) {
    showPage(u"Axis"_s);
    click(u"workOutUnitButton"_s);
    EXPECT_EQ(find<QDialog>(u"unitDialog"_s)->windowTitle(), u"Module 1: Calculate the unit"_s);
    choose(u"unitDialogKind"_s, u"linear, in millimetres"_s);
    type(u"unitDialogLines"_s, u"500"_s);
    type(u"unitDialogMotorTurns"_s, u"2"_s);
    type(u"unitDialogTravel"_s, u"5"_s);
    EXPECT_EQ(text(u"unitDialogResult"_s), u"1 mm is 800 counts. The smallest step is 0.00125 mm."_s);
    EXPECT_NE(machine.axis(ModuleIndex(0)).unit.kind, UnitKind::Millimetres)
        << "not before its button is clicked";
    click(u"unitDialogUse"_s);
    EXPECT_EQ(machine.axis(ModuleIndex(0)).unit, (AxisUnit{UnitKind::Millimetres, 800, {}}));
    EXPECT_EQ(text(u"positionUnit"_s), u"mm"_s);
    EXPECT_EQ(text(u"otherPosition"_s), u"= 500 counts"_s) << "the position itself has not changed";
    EXPECT_EQ(intents.size(), 0);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(window->findChild<QDialog*>(u"unitDialog"_s), nullptr);
}

/// 500 lines are 2000 counts.
TEST_F(Axis, ItsUnitIsReadWholeInEachOfItsKinds) {
    showPage(u"Axis"_s);
    click(u"workOutUnitButton"_s);
    const auto* result = find<QLabel>(u"unitDialogResult"_s);
    choose(u"unitDialogKind"_s, u"rotary, in turns"_s);
    EXPECT_TRUE(result->text().startsWith(u"1 turn is "_s)) << result->text().toStdString();
    EXPECT_TRUE(result->text().endsWith(u"The smallest step is 0.0005 turns."_s))
        << result->text().toStdString();
    choose(u"unitDialogKind"_s, u"linear, in millimetres"_s);
    QApplication::processEvents();
    EXPECT_GE(result->height(), result->heightForWidth(result->width())) << result->width();
}

/// Its dialog stays open while another module is selected; a file may give the axis other limits meanwhile.
TEST_F(Axis, ItsUnitTakesNothingElseBack) {
    showServos({{}, {}});
    showPage(u"Axis"_s);
    click(u"workOutUnitButton"_s);
    choose(u"unitDialogKind"_s, u"linear, in millimetres"_s);
    type(u"unitDialogLines"_s, u"500"_s);
    type(u"unitDialogMotorTurns"_s, u"2"_s);
    type(u"unitDialogTravel"_s, u"5"_s);
    auto* use = button(u"unitDialogUse"_s);
    ASSERT_NE(use, nullptr);
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setCurrentIndex(list->model()->index(1, 0));
    machine.axes.resize(2);
    machine.axes[0].travel.highest = 4'000;
    machine.axes[0].travel.fastest = 0.5;
    window->showMachine(machine);
    QTest::mouseClick(use, Qt::LeftButton);
    EXPECT_EQ(machine.axis(ModuleIndex(0)).unit, (AxisUnit{UnitKind::Millimetres, 800, {}}));
    EXPECT_EQ(machine.axis(ModuleIndex(0)).travel.highest, 4'000);
    EXPECT_EQ(machine.axis(ModuleIndex(0)).travel.fastest, 0.5);
}

/// The lines of its encoder, times four, would be taken for the steps of a stepper.
TEST_F(Axis, ItsUnitIsNotGivenToAnotherModuleAtItsPlace) {
    showServos({{}, {}});
    showPage(u"Axis"_s);
    click(u"workOutUnitButton"_s);
    const QPointer<QDialog> dialog = find<QDialog>(u"unitDialog"_s);
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setCurrentIndex(list->model()->index(1, 0));
    ASSERT_FALSE(dialog.isNull()) << "it stays open while another module is selected";
    ModuleState unheard = Servo{}.state();
    unheard.info.identity = kUnheardModule;
    window->showLink(connectedTo({unheard, Servo{.index = 1}.state()}));
    EXPECT_FALSE(dialog.isNull()) << "it may be the same module";
    window->showLink(connectedTo({testing_support::Stepper::holding().module, Servo{.index = 1}.state()}));
    EXPECT_TRUE(dialog.isNull());
    EXPECT_EQ(machine.axis(ModuleIndex(0)).unit, AxisUnit{});
}

TEST_F(Axis, AUnitIsNotTakenFromHalfALabel) {
    showPage(u"Axis"_s);
    click(u"workOutUnitButton"_s);
    choose(u"unitDialogKind"_s, u"rotary, in turns"_s);
    type(u"unitDialogLines"_s, u"0"_s);
    EXPECT_FALSE(button(u"unitDialogUse"_s)->isEnabled());
    EXPECT_EQ(text(u"unitDialogResult"_s), u"Enter a number above 0 in each field."_s);
    click(u"unitDialogCancel"_s);
    EXPECT_EQ(machine.axis(ModuleIndex(0)).unit, AxisUnit{});
}

}  // namespace
}  // namespace nmc
