// SPDX-License-Identifier: GPL-3.0-or-later
// The table of all axes: hold, step, enable and home any of them from one place.
#include "model/settings/machine.h"
#include "widgets/axes/axespage.h"
#include "widgets/common/requests.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Axes : public WindowTest {
protected:
    Axes() {
        window->resize(1'500, 1'100);
        QObject::connect(&window->requests(), &Requests::hold, window.get(),
                         [this](const bus::HoldToMove& hold) { holds.push_back(hold); });
        QObject::connect(
            &window->requests(), &Requests::intent, window.get(),
            [this](ModuleIndex module, const Intent& intent) { asked.emplace_back(module, intent); });
        QObject::connect(&window->requests(), &Requests::homeOrderEdited, window.get(),
                         [this](const std::vector<ModuleIndex>& order) {
                             machine.homeOrder = order;
                             window->showMachine(machine);
                         });
        showServos({{}, {.position = 1'234}, {.on = false}});
        QTest::keyClick(window->windowHandle(), Qt::Key_F4);
    }
    std::vector<bus::HoldToMove> holds;
    std::vector<std::pair<ModuleIndex, Intent>> asked;
};

TEST_F(Axes, ShowWhereEachStandsAndWhatItDoes) {
    EXPECT_TRUE(find(u"axesPage"_s)->isVisible());
    EXPECT_EQ(text(u"axisPosition2"_s), u"1\u202F234 counts"_s);
    EXPECT_EQ(text(u"axisState1"_s), u"Holding"_s);
    EXPECT_EQ(text(u"axisState3"_s), u"Servo off"_s);
    EXPECT_FALSE(button(u"axisHoldForwardButton3"_s)->isEnabled());
    EXPECT_FALSE(button(u"axisHoldForwardButton3"_s)->toolTip().isEmpty()) << "it gives the reason";
}

TEST_F(Axes, SayThatAPositionIsOld) {
    LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1, .position = 1'234}.state()});
    link.phase = LinkPhase::Lost;
    window->showLink(link);
    EXPECT_EQ(text(u"axisPosition2"_s), u"1\u202F234 counts, out of date"_s);
    EXPECT_TRUE(find<QLabel>(u"axisPosition2"_s)->font().strikeOut());
    showServos({{}, {.position = 1'234}});
    EXPECT_EQ(text(u"axisPosition2"_s), u"1\u202F234 counts"_s);
    EXPECT_FALSE(find<QLabel>(u"axisPosition2"_s)->font().strikeOut());
}

TEST_F(Axes, AreReadOutAsTheyAreNamedNow) {
    EXPECT_EQ(button(u"axisHoldForwardButton2"_s)->accessibleName(), u"Hold to move Module 2 forward"_s);
    machine.axes.resize(2);
    machine.axes[1].name = "lift";
    window->showMachine(machine);
    EXPECT_EQ(button(u"axisHoldForwardButton2"_s)->accessibleName(),
              u"Hold to move Module 2 \"lift\" forward"_s);
    EXPECT_EQ(button(u"axisStepReverseButton2"_s)->accessibleName(), u"Step Module 2 \"lift\" in reverse"_s);
    EXPECT_EQ(find<QLabel>(u"axisPosition2"_s)->accessibleDescription(), u"Position of Module 2 \"lift\""_s);
    EXPECT_EQ(button(u"axisHomeEarlierButton2"_s)->accessibleName(),
              u"Home: – Home Module 2 \"lift\" one place earlier"_s);
}

TEST_F(Axes, AreHeldSlowlyOrFast) {
    QTest::mousePress(button(u"axisHoldReverseButton2"_s), Qt::LeftButton);
    ASSERT_EQ(holds.size(), 1U);
    EXPECT_EQ(holds[0].module, ModuleIndex(1));
    EXPECT_TRUE(holds[0].reverse);
    EXPECT_EQ(holds[0].velocity.value(), 65'536U / 4) << "a quarter of a count per tick until it is set";
    QSignalSpy released(&window->requests(), &Requests::holdReleased);
    QTest::mouseRelease(button(u"axisHoldReverseButton2"_s), Qt::LeftButton);
    EXPECT_EQ(released.size(), 1);
    click(u"jogFastButton"_s);
    QTest::mousePress(button(u"axisHoldForwardButton1"_s), Qt::LeftButton);
    ASSERT_EQ(holds.size(), 2U);
    EXPECT_EQ(holds[1].velocity.value(), 65'536U * 2) << "max jog speed";
    EXPECT_GT(holds[1].press, holds[0].press);
    QTest::keyClick(window->windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(released.size(), 2) << "Esc ends what is held here, too";
}

TEST_F(Axes, AnotherConnectionIsSlowAgain) {
    click(u"jogFastButton"_s);
    LinkState connecting;
    connecting.phase = LinkPhase::Connecting;
    connecting.connection = 2;
    window->showLink(connecting);
    showServo();
    QTest::mousePress(button(u"axisHoldForwardButton1"_s), Qt::LeftButton);
    ASSERT_EQ(holds.size(), 1U);
    EXPECT_EQ(holds[0].velocity.value(), 65'536U / 4);
}

TEST_F(Axes, StepByTheChosenSizeInTheirOwnUnit) {
    machine.axes.resize(2);
    machine.axes[1].unit = {UnitKind::Millimetres, 200.0, ""};
    window->showMachine(machine);
    find<QComboBox>(u"jogStepBox"_s)->setCurrentIndex(2);  // 0.1
    EXPECT_FALSE(button(u"axisStepForwardButton1"_s)->isEnabled()) << "a tenth of a count is not possible";
    click(u"axisStepReverseButton2"_s);
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(asked[0].first, ModuleIndex(1));
    EXPECT_EQ(std::get<intent::MoveBy>(asked[0].second).moves.counts, -20) << "a tenth of a millimetre";
}

/// A . or , between the groups of digits would be read as the decimal mark, which both are here.
TEST_F(Axes, NameASizeInThousandsAsItIsWrittenElsewhere) {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    Requests requests;
    const AxesPage page(requests);
    QLocale::setDefault(QLocale::c());
    const auto* sizes = page.findChild<QComboBox*>(u"jogStepBox"_s);
    ASSERT_NE(sizes, nullptr);
    EXPECT_EQ(sizes->itemText(0), u"0,001 units"_s);
    EXPECT_EQ(sizes->itemText(6), u"1\u202F000 units"_s);
}

TEST_F(Axes, EnableAllThatAreOff) {
    click(u"enableAllButton"_s);
    ASSERT_EQ(asked.size(), 1U) << "the others are on";
    EXPECT_EQ(asked[0].first, ModuleIndex(2));
    EXPECT_TRUE(std::holds_alternative<intent::Enable>(asked[0].second));
    showServos({{}, {}, {}});
    EXPECT_FALSE(button(u"enableAllButton"_s)->isEnabled());
}

TEST_F(Axes, HomeAllInTheOrderThatTheMachineKeeps) {
    EXPECT_FALSE(button(u"homeAllButton"_s)->isEnabled()) << "no axis has a homing recipe";
    HomingRecipe recipe;
    recipe.onLimit1 = true;
    machine.axes.resize(2);
    machine.axes[0].homing = machine.axes[1].homing = recipe;
    window->showMachine(machine);
    EXPECT_EQ(button(u"axisHomeEarlierButton2"_s)->text(), u"Home: 2."_s);
    click(u"axisHomeEarlierButton2"_s);
    EXPECT_EQ(machine.homeOrder, (std::vector{ModuleIndex(1), ModuleIndex(0)}));
    EXPECT_EQ(button(u"axisHomeEarlierButton2"_s)->text(), u"Home: 1."_s);
    QSignalSpy homes(&window->requests(), &Requests::homeAll);
    click(u"homeAllButton"_s);
    EXPECT_EQ(homes.size(), 1);
}

/// The third axis may be a Z axis, which has to be out of the way before the others are homed.
TEST_F(Axes, KeepThePlaceOfAnAbsentOneInTheOrder) {
    HomingRecipe recipe;
    recipe.onLimit1 = true;
    machine.axes.resize(3);
    for (AxisSettings& axis : machine.axes)
        axis.homing = recipe;
    machine.homeOrder = {ModuleIndex(2), ModuleIndex(0), ModuleIndex(1)};
    window->showMachine(machine);
    showServos({{}, {}});
    EXPECT_EQ(button(u"axisHomeEarlierButton2"_s)->text(), u"Home: 2."_s);
    click(u"axisHomeEarlierButton2"_s);
    EXPECT_EQ(machine.homeOrder, (std::vector{ModuleIndex(2), ModuleIndex(1), ModuleIndex(0)}));
    showServos({{}, {}, {}});
    EXPECT_EQ(button(u"axisHomeEarlierButton3"_s)->text(), u"Home: 1."_s);
}

}  // namespace
}  // namespace nmc
