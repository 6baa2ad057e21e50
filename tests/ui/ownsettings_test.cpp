// SPDX-License-Identifier: GPL-3.0-or-later
// What is typed into the panel of a module is kept for that module, and nothing else is: showing a module
// changes nothing.
#include "ownsettings.h"

namespace nmc {
namespace {

TEST_F(OwnSettings, SelectingAModuleWritesNothing) {
    openPage(u"Axis"_s);
    typeOver(u"axisNameField"_s, u"X"_s);
    QTest::keyClick(find(u"axisNameField"_s), Qt::Key_Tab);
    choose(u"axisUnitBox"_s, u"millimetres"_s);
    typeOver(u"countsPerUnitField"_s, u"2000"_s);
    openPage(u"Homing"_s);
    ASSERT_TRUE(press(u"homingForwardButton"_s));
    const Machine typed = machine;
    ASSERT_EQ(typed.axes[0].name, "X");
    ASSERT_EQ(typed.axes[0].unit, (AxisUnit{UnitKind::Millimetres, 2'000.0, {}}));
    ASSERT_FALSE(typed.axes[0].homing.value().reverse);
    for (const int module : {1, 0, 1, 0}) {
        clickModule(module);
        EXPECT_EQ(writeMachine(machine), writeMachine(typed)) << module;
    }
    openPage(u"Axis"_s);
    EXPECT_EQ(find<QLineEdit>(u"axisNameField"_s)->text(), u"X"_s);
    EXPECT_EQ(text(u"positionUnit"_s), u"mm"_s);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(OwnSettings, NamingAnAxisKeepsItsNameAndNothingElse) {
    openPage(u"Axis"_s);
    typeOver(u"axisNameField"_s, u"X"_s);
    AxisSettings named;
    named.name = "X";
    EXPECT_EQ(machine.axes[0], named) << "neither initial nor rounded numbers of other fields are kept";
}

}  // namespace
}  // namespace nmc
