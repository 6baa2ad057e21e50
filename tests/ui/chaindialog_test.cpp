// SPDX-License-Identifier: GPL-3.0-or-later
#include "module/profiledload.h"
#include "widgets/chain/chainmenu.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

class ChainWindow : public WindowTest {
protected:
    void open(const char* action) { window->findChild<QAction*>(QLatin1StringView(action))->trigger(); }
    [[nodiscard]] QString cell(int row, int column) {
        return find<QTableWidget>(u"chainTable"_s)->item(row, column)->text();
    }
    void expect(std::size_t modules) {
        machine.axes.resize(modules);
        for (AxisSettings& axis : machine.axes)
            axis.expected = ModuleIdentity{ModuleType::Servo, 4};
        window->showMachine(machine);
    }
    void showGrouped(std::vector<std::optional<bus::GroupPlace>> places) {
        std::vector<ModuleState> modules;
        for (std::size_t i = 0; i < places.size(); ++i) {
            modules.push_back(Servo{.index = static_cast<int>(i)}.state());
            modules.back().info.group = places[i];
        }
        link = connectedTo(std::move(modules));
        window->showLink(link);
    }
    LinkState link;
    QSignalSpy changes{&window->requests(), &Requests::groupChange};
    QSignalSpy commands{&window->requests(), &Requests::groupCommand};
    QSignalSpy rates{&window->requests(), &Requests::rate};
};

TEST_F(ChainWindow, TheDoctorNamesThePlaceToLookAt) {
    expect(4);
    machine.axes[1].name = "Z axis";
    window->showMachine(machine);
    showServos({{}, {}});
    open("chainDoctorAction");
    EXPECT_EQ(text(u"chainFinding"_s), u"2 of 4 modules answered."_s);
    EXPECT_TRUE(text(u"chainAdvice"_s).contains(u"towards the PC after Module 2 \"Z axis\""_s))
        << text(u"chainAdvice"_s).toStdString();
    EXPECT_EQ(cell(0, 4), u"OK"_s);
    EXPECT_EQ(cell(2, 2), u"PIC-SERVO v4"_s);
    EXPECT_EQ(cell(2, 3), u"–"_s);
    EXPECT_EQ(cell(3, 4), u"missing"_s);
}

TEST_F(ChainWindow, TheDoctorNumbersTheModulesWhateverTheirAddressesAre) {
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{}});
    link.modules[0].info.address = BusAddress(40);
    window->showLink(link);
    open("chainDoctorAction");
    EXPECT_EQ(find<QTableWidget>(u"chainTable"_s)->horizontalHeaderItem(0)->text(), u"Module"_s);
    EXPECT_EQ(cell(0, 0), u"1"_s);
    EXPECT_EQ(cell(1, 0), u"2"_s);
}

TEST_F(ChainWindow, OfAnotherModuleTheDoctorSaysThatItIsUsedWithTheSettingsOfItsPlace) {
    expect(2);
    machine.axes[0].expected = ModuleIdentity{ModuleType::Servo, 3};
    machine.axes[0].unit = {UnitKind::Turns, 2'000.0, {}};
    window->showMachine(machine);
    showServos({{.position = 500}, {}});
    EXPECT_EQ(text(u"positionLabel"_s), u"0.2500"_s) << "in the unit that was set for the other one";
    open("chainDoctorAction");
    EXPECT_EQ(text(u"chainFinding"_s), u"Module 1 is not the expected module."_s);
    EXPECT_TRUE(text(u"chainAdvice"_s)
                    .startsWith(u"Name, unit, limits, speeds and points of the expected module are used"_s))
        << text(u"chainAdvice"_s).toStdString();
}

TEST_F(ChainWindow, TheNumbersOfAnotherTypeOfModuleAreNeitherShownNorUsedNorReplaced) {
    AxisSettings& axis = machine.axes.emplace_back();
    axis.name = "Table";
    axis.expected = ModuleIdentity{ModuleType::Stepper, 1};
    axis.unit = {UnitKind::Millimetres, 200.0, {}};
    axis.motion.velocity = 2'000;
    axis.travel.fastest = 3'000;
    const Machine before = machine;
    window->showMachine(machine);
    showServo({.position = 500});
    EXPECT_EQ(text(u"positionLabel"_s), u"500"_s) << "counts";
    EXPECT_EQ(*field(u"velocityField"_s)->value(), 1.0) << "counts/tick, as for any servo that is new";
    EXPECT_FALSE(button(u"goButton"_s)->isEnabled());
    EXPECT_EQ(button(u"goButton"_s)->toolTip(), texts::refusal(Refusal::OtherType));
    EXPECT_FALSE(find<QLineEdit>(u"axisNameField"_s)->isEnabled());
    type(u"velocityField"_s, u"0.25"_s);
    EXPECT_EQ(machine, before) << "a number of this module is none of the other";
    open("chainDoctorAction");
    EXPECT_EQ(text(u"chainFinding"_s), u"Module 1 \"Table\" is not the expected module."_s);
    EXPECT_TRUE(text(u"chainAdvice"_s).contains(u"another type of module, so they are not used"_s))
        << text(u"chainAdvice"_s).toStdString();

    machine.axes[0].expected = ModuleIdentity{ModuleType::Servo, 4};
    window->showMachine(machine);
    EXPECT_EQ(text(u"positionLabel"_s), u"2.500"_s) << "500 counts at 200 counts/mm";
    EXPECT_TRUE(find<QLineEdit>(u"axisNameField"_s)->isEnabled());
}

TEST_F(ChainWindow, AnotherTypeOfModuleIsOnlyReportedWhereNothingIsSetUpForTheExpectedOne) {
    AxisSettings& axis = machine.axes.emplace_back();
    axis.name = "Table";
    axis.expected = ModuleIdentity{ModuleType::Stepper, 1};
    window->showMachine(machine);
    showServo({.position = 500});
    EXPECT_NE(button(u"goButton"_s)->toolTip(), texts::refusal(Refusal::OtherType));
    EXPECT_TRUE(find<QLineEdit>(u"axisNameField"_s)->isEnabled());
    open("chainDoctorAction");
    EXPECT_EQ(text(u"chainFinding"_s), u"Module 1 \"Table\" is not the expected module."_s);
    EXPECT_TRUE(text(u"chainAdvice"_s).contains(u"check these settings"_s))
        << text(u"chainAdvice"_s).toStdString();
}

TEST_F(ChainWindow, WhatIsThereCanBeTakenAsExpected) {
    expect(2);
    showServos({{}});
    open("chainDoctorAction");
    QSignalSpy accepted(&window->requests(), &Requests::acceptChain);
    QSignalSpy scans(&window->requests(), &Requests::scan);
    click(u"acceptChainButton"_s);
    click(u"scanButton"_s);
    EXPECT_EQ(accepted.size(), 1);
    EXPECT_EQ(scans.size(), 1);
    expect(1);
    EXPECT_FALSE(button(u"acceptChainButton"_s)->isEnabled());
    EXPECT_EQ(text(u"chainFinding"_s), u"Chain OK: 1 module."_s);
}

TEST_F(ChainWindow, OfAChainThatNobodyHasDescribedTheDoctorSaysSo) {
    showServos({{}, {}, {}});
    open("chainDoctorAction");
    EXPECT_EQ(text(u"chainFinding"_s), u"This chain is new: it has 3 modules."_s);
    EXPECT_TRUE(text(u"chainAdvice"_s).contains(u"labels"_s));
    EXPECT_EQ(cell(2, 4), u"new"_s);
    EXPECT_TRUE(button(u"acceptChainButton"_s)->isEnabled());
}

TEST_F(ChainWindow, ARestartAsksFirst) {
    showServos({{}});
    QSignalSpy restarts(window.get(), &MainWindow::restartNetworkRequested);
    open("chainDoctorAction");
    click(u"restartChainButton"_s);
    EXPECT_EQ(restarts.size(), 0);
    EXPECT_NE(find(u"restartDialog"_s), nullptr);
    click(u"cancelRestartButton"_s);
    EXPECT_EQ(restarts.size(), 0);
}

TEST_F(ChainWindow, AModuleJoinsAGroupAndLeadsIt) {
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{}});
    open("groupsAction");
    auto* group = find<QComboBox>(u"group2Box"_s);
    EXPECT_EQ(group->currentText(), u"no group"_s);
    EXPECT_FALSE(button(u"leader2Box"_s)->isEnabled());
    group->setFocus();
    QTest::keyClick(group, Qt::Key_Down);
    ASSERT_EQ(changes.size(), 1);
    EXPECT_EQ(changes.at(0).at(0).value<bus::GroupChange>(),
              (bus::GroupChange{ModuleIndex(1), {0x81, false}}));
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{0x81, false}});
    auto* leader = button(u"leader2Box"_s);
    QTest::mouseClick(leader, Qt::LeftButton, {}, {leader->height() / 2, leader->height() / 2});
    ASSERT_EQ(changes.size(), 2);
    EXPECT_EQ(changes.at(1).at(0).value<bus::GroupChange>(),
              (bus::GroupChange{ModuleIndex(1), {0x81, true}}));
}

TEST_F(ChainWindow, AGroupStartIsWithheldUntilEachMemberHasLoaded) {
    showGrouped({bus::GroupPlace{0x81, true}, bus::GroupPlace{0x81, false}, bus::GroupPlace{}});
    const auto load = [&](std::size_t i) {
        ModuleState& module = link.modules[i];
        module.apply(bus::CommandExecuted{
            module.info.index, module.latestTime,
            ServoCommand(profiledLoad(CountsPerTick(65'536), CountsPerTickSquared(131), 750))});
        window->showLink(link);
    };
    open("groupsAction");
    EXPECT_FALSE(button(u"groupStartButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"groupStartButton"_s)->toolTip().startsWith(u"Module 1:"_s));
    load(0);
    EXPECT_TRUE(button(u"groupStartButton"_s)->toolTip().startsWith(u"Module 2:"_s));
    load(1);
    EXPECT_EQ(text(u"load2Label"_s), u"move loaded"_s);
    click(u"groupStartButton"_s);
    click(u"groupHomeButton"_s);
    ASSERT_EQ(commands.size(), 2);
    EXPECT_EQ(commands.at(0).at(0).value<bus::GroupCommand>(),
              (bus::GroupCommand{0x81, bus::GroupCommand::Action::StartMotion}));
    EXPECT_EQ(commands.at(1).at(0).value<bus::GroupCommand>(),
              (bus::GroupCommand{0x81, bus::GroupCommand::Action::SaveAsHome}));
}

/// The machine has a PIC-STEP as module 2, so its home is in steps. A PIC-I/O has none, and latches its
/// inputs.
TEST_F(ChainWindow, AGroupIsNotToldToSaveHomeWithAnotherTypeOfModule) {
    machine.axes.resize(2);
    machine.axes[1].motion.velocity = 2'000;
    window->showMachine(machine);
    showGrouped({bus::GroupPlace{0x81, false}, bus::GroupPlace{0x81, false}, bus::GroupPlace{0x81, false}});
    link.modules[2].info.identity = {ModuleType::Io, 1};
    window->showLink(link);
    open("groupsAction");
    EXPECT_TRUE(button(u"groupHomeButton"_s)->isEnabled());
    machine.axes[1].expected = ModuleIdentity{ModuleType::Stepper, 1};
    window->showMachine(machine);
    EXPECT_FALSE(button(u"groupHomeButton"_s)->isEnabled());
    EXPECT_EQ(button(u"groupHomeButton"_s)->toolTip(), u"Module 2: "_s + texts::refusal(Refusal::OtherType));
}

TEST_F(ChainWindow, AGroupIsToldToStopAndToClear) {
    using enum bus::GroupCommand::Action;
    showGrouped({bus::GroupPlace{0x90, false}, bus::GroupPlace{0x90, false}, bus::GroupPlace{}});
    open("groupsAction");
    std::vector<bus::GroupCommand> wanted;
    for (const auto& [name, action] : {std::pair(u"groupStopSmoothlyButton"_s, StopSmoothly),
                                       {u"groupStopAbruptlyButton"_s, StopAbruptly},
                                       {u"groupMotorOffButton"_s, MotorOff},
                                       {u"groupClearButton"_s, ClearStickyBits}}) {
        click(name);
        wanted.push_back({0x90, action});
    }
    ASSERT_EQ(commands.size(), qsizetype{4});
    for (qsizetype i = 0; i < 4; ++i)
        EXPECT_EQ(commands.at(i).at(0).value<bus::GroupCommand>(), wanted[static_cast<std::size_t>(i)]);
    link.phase = LinkPhase::Connecting;
    link.looking = true;
    window->showLink(link);
    EXPECT_TRUE(button(u"groupStopAbruptlyButton"_s)->isEnabled()) << "nor does a search keep it off";
    EXPECT_FALSE(button(u"groupClearButton"_s)->isEnabled());
    link.phase = LinkPhase::Connected;
    link.looking = false;
    link.rights = OperatorRights{};
    window->showLink(link);
    EXPECT_TRUE(button(u"groupStopAbruptlyButton"_s)->isEnabled()) << "a stop is never locked";
    EXPECT_FALSE(button(u"groupHomeButton"_s)->isEnabled());
    link.readOnly = true;
    window->showLink(link);
    EXPECT_FALSE(button(u"groupStopAbruptlyButton"_s)->isEnabled());
}

TEST_F(ChainWindow, AQuestionOfAPageThatWaitsIsNamedInTheBanner) {
    showGrouped({bus::GroupPlace{0x81, false}, bus::GroupPlace{0x81, false}});
    open("groupsAction");
    click(u"groupResetButton"_s);
    ASSERT_TRUE(QTest::qWaitForWindowActive(find(u"groupResetDialog"_s), testing_support::kPatienceMs));
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), testing_support::kPatienceMs));
    ASSERT_TRUE(eventually([this] { return find(u"banner"_s)->isVisible(); }));
    EXPECT_EQ(text(u"bannerHeadline"_s), u"A question is waiting for your answer: Set positions to 0"_s);
}

TEST_F(ChainWindow, ANewZeroOfAGroupAsksFirstAndOnlyAtRest) {
    showGrouped({bus::GroupPlace{0x81, false}, bus::GroupPlace{0x81, false}});
    open("groupsAction");
    click(u"groupResetButton"_s);
    EXPECT_EQ(commands.size(), 0);
    ASSERT_NE(find(u"groupResetDialog"_s), nullptr);
    click(u"cancelGroupResetButton"_s);
    EXPECT_EQ(commands.size(), 0);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    click(u"groupResetButton"_s);
    click(u"confirmGroupResetButton"_s);
    ASSERT_EQ(commands.size(), 1);
    EXPECT_EQ(commands.at(0).at(0).value<bus::GroupCommand>(),
              (bus::GroupCommand{0x81, bus::GroupCommand::Action::ResetPosition}));
    const std::vector<ModuleState> moving{Servo{.moveDone = false}.state()};
    link.modules[1].latest = moving[0].latest;
    window->showLink(link);
    EXPECT_FALSE(button(u"groupResetButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"groupResetButton"_s)->toolTip().startsWith(u"Module 2:"_s))
        << button(u"groupResetButton"_s)->toolTip().toStdString();
}

TEST_F(ChainWindow, AnyGroupOfTheDataSheetsCanBeChosen) {
    showGrouped({bus::GroupPlace{}});
    open("groupsAction");
    auto* group = find<QComboBox>(u"group1Box"_s);
    EXPECT_GE(group->findData(0x80), 0);
    EXPECT_GE(group->findData(0xFE), 0);
    EXPECT_EQ(group->count(), 128) << "80 to FE, and none";
}

TEST_F(ChainWindow, AModuleGetsAnotherAddressWithEnter) {
    QSignalSpy addresses(&window->requests(), &Requests::address);
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{}});
    open("groupsAction");
    auto* field = find<NumberField>(u"address2Box"_s);
    EXPECT_EQ(field->value(), 2);
    field->window()->activateWindow();
    ASSERT_TRUE(eventually([&] { return field->isActiveWindow(); }));
    const auto enter = [&](const QString& text, Qt::Key key) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, key);
    };
    enter(u"1"_s, Qt::Key_Return);
    EXPECT_EQ(addresses.size(), 0);
    EXPECT_EQ(window->findChild<QLabel*>(u"addressReason"_s)->text(),
              u"Address 1 is used by Module 1. Nothing was sent."_s);
    enter(u"77"_s, Qt::Key_Tab);
    EXPECT_EQ(addresses.size(), 0) << "nothing is sent without Enter";
    EXPECT_EQ(field->value(), 2);
    enter(u"77"_s, Qt::Key_Return);
    ASSERT_EQ(addresses.size(), 1);
    EXPECT_EQ(addresses.at(0).at(0).value<ModuleIndex>(), ModuleIndex(1));
    EXPECT_EQ(addresses.at(0).at(1).value<BusAddress>(), BusAddress(77));
    EXPECT_FALSE(window->findChild<QLabel*>(u"addressReason"_s)->isVisible());
    showGrouped({std::nullopt});
    EXPECT_FALSE(find(u"address1Box"_s)->isEnabled()) << "its group would change";
}

TEST_F(ChainWindow, WhyAnAddressWasNotSentIsSaidWhileItIsTyped) {
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{}});
    open("groupsAction");
    auto* field = find<NumberField>(u"address2Box"_s);
    field->window()->activateWindow();
    ASSERT_TRUE(QTest::qWaitFor([&] { return field->isActiveWindow(); }));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, u"1"_s);
    QTest::keyClick(field, Qt::Key_Return);
    const auto* reason = window->findChild<QLabel*>(u"addressReason"_s);
    window->showLink(link);
    EXPECT_TRUE(reason->isVisible());
    window->showLink({});
    window->showLink(link);
    EXPECT_FALSE(reason->isVisible()) << "it was about an address typed in the connection before";
}

TEST_F(ChainWindow, AnyDivisorGivesItsRate) {
    showServos({{}});
    open("rateAction");
    auto* rate = find<QComboBox>(u"chainRateBox"_s);
    auto* divisor = find<NumberField>(u"chainDivisorBox"_s);
    EXPECT_FALSE(divisor->isVisible());
    rate->setFocus();
    QTest::keyClick(rate, Qt::Key_End);
    ASSERT_TRUE(divisor->isVisible());
    EXPECT_EQ(divisor->value(), 10) << "the present rate: 1 250 000 / 11";
    EXPECT_FALSE(button(u"changeRateButton"_s)->isEnabled());
    divisor->setFocus();
    divisor->selectAll();
    QTest::keyClicks(divisor, u"4"_s);
    EXPECT_EQ(text(u"chainDivisorRate"_s), u"= 250\u202f000 Bd"_s);
    click(u"changeRateButton"_s);
    ASSERT_EQ(rates.size(), 1);
    EXPECT_EQ(rates.at(0).at(0).toUInt(), 250'000U);
    link = connectedTo({Servo{}.state()});
    link.baud = 250'000;
    window->showLink(link);
    EXPECT_EQ(rate->currentText(), u"Other…"_s);
    EXPECT_EQ(divisor->value(), 4);
    EXPECT_EQ(text(u"chainRateLabel"_s), u"The chain runs at 250\u202f000 Bd."_s);
}

TEST_F(ChainWindow, AnUnknownGroupIsSaidToBeUnknown) {
    showGrouped({std::nullopt});
    open("groupsAction");
    EXPECT_EQ(find<QComboBox>(u"group1Box"_s)->currentText(), u"unknown"_s);
    EXPECT_EQ(changes.size(), 0);
}

TEST_F(ChainWindow, TheRateChangesAtStandstillOnly) {
    showServos({{}});
    open("rateAction");
    EXPECT_EQ(text(u"chainRateLabel"_s), u"The chain runs at 115\u202f200 Bd."_s);
    EXPECT_FALSE(button(u"changeRateButton"_s)->isEnabled());
    auto* rate = find<QComboBox>(u"chainRateBox"_s);
    rate->setCurrentIndex(rate->findData(57'600));
    showServos({{.moveDone = false}});
    EXPECT_FALSE(button(u"changeRateButton"_s)->isEnabled());
    showServos({{.millisecond = 10}});
    click(u"changeRateButton"_s);
    ASSERT_EQ(rates.size(), 1);
    EXPECT_EQ(rates.at(0).at(0).toUInt(), 57'600U);
}

TEST_F(ChainWindow, ARateChangeThatWouldBeRefusedIsGreyedWithItsReason) {
    const auto reason = [this] {
        auto* rate = find<QComboBox>(u"chainRateBox"_s);
        rate->setCurrentIndex(rate->findData(57'600));
        EXPECT_EQ(button(u"changeRateButton"_s)->isEnabled(), text(u"chainRateReason"_s).isEmpty());
        return text(u"chainRateReason"_s);
    };
    open("rateAction");
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{}});
    EXPECT_EQ(reason(), QString());
    showGrouped({bus::GroupPlace{}, std::nullopt});
    EXPECT_TRUE(reason().endsWith(u"may miss the change: 2. Set their group on the Groups page, or none."_s))
        << reason().toStdString();
    showGrouped({bus::GroupPlace{0x81, true}, bus::GroupPlace{0x81, false}});
    EXPECT_TRUE(reason().endsWith(u"Groups page: 1."_s)) << reason().toStdString();
    showGrouped({bus::GroupPlace{}, bus::GroupPlace{}});
    link.modules[1].silent = true;
    window->showLink(link);
    EXPECT_TRUE(reason().endsWith(u"at the old baud rate: 2."_s)) << reason().toStdString();
    link.phase = LinkPhase::Lost;
    window->showLink(link);
    EXPECT_FALSE(reason().isEmpty());
    link.phase = LinkPhase::Connected;
    link.modules[1].silent = false;
    link.readOnly = true;
    window->showLink(link);
    EXPECT_TRUE(reason().contains(u"read-only"_s));
}

TEST_F(ChainWindow, AGroupHasTheNameThatItIsGiven) {
    QSignalSpy names(&window->requests(), &Requests::groupNamed);
    showGrouped({bus::GroupPlace{0x81, false}, bus::GroupPlace{0x82, false}});
    open("groupsAction");
    auto* groups = find<QComboBox>(u"groupBox"_s);
    groups->setFocus();
    QTest::keyClick(groups, Qt::Key_Down);
    auto* field = find<QLineEdit>(u"groupNameField"_s);
    field->setFocus();
    QTest::keyClicks(field, u"Table"_s);
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_EQ(names.size(), 1);
    EXPECT_EQ(names.at(0).at(0).toUInt(), 0x82U);
    EXPECT_EQ(names.at(0).at(1).toString(), u"Table"_s);
    machine.groups = {{0x82, "Table", {ModuleIndex(1)}, {}}};
    window->showMachine(machine);
    EXPECT_EQ(find<QComboBox>(u"group2Box"_s)->currentText(), u"Group 82 \"Table\""_s);
    EXPECT_EQ(groups->currentText(), u"Group 82 \"Table\""_s);
    EXPECT_EQ(find<QComboBox>(u"group1Box"_s)->currentText(), u"Group 81"_s);
    groups->setFocus();
    QTest::keyClick(groups, Qt::Key_Up);
    EXPECT_EQ(field->text(), QString());
}

/// This has happened: the box was made before there were groups, and their last digit was cut.
TEST_F(ChainWindow, AGroupThatIsMadeLaterIsReadInFull) {
    showGrouped({bus::GroupPlace{}});
    open("groupsAction");
    auto* groups = find<QComboBox>(u"groupBox"_s);
    QApplication::processEvents();
    showGrouped({bus::GroupPlace{0x81, false}});
    QApplication::processEvents();
    ASSERT_EQ(groups->currentText(), u"Group 81"_s);
    QStyleOptionComboBox option;
    option.initFrom(groups);
    option.editable = false;
    const QRect room =
        groups->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, groups);
    EXPECT_GE(room.width(), groups->fontMetrics().horizontalAdvance(groups->currentText()));
}

TEST_F(ChainWindow, ANameBeingTypedGoesToNoOtherGroup) {
    QSignalSpy names(&window->requests(), &Requests::groupNamed);
    showGrouped({bus::GroupPlace{0x81, false}, bus::GroupPlace{0x82, false}});
    open("groupsAction");
    auto* groups = find<QComboBox>(u"groupBox"_s);
    groups->setFocus();
    QTest::keyClick(groups, Qt::Key_Down);
    auto* field = find<QLineEdit>(u"groupNameField"_s);
    ASSERT_TRUE(QTest::qWaitForWindowActive(field->window()));
    field->setFocus();
    QTest::keyClicks(field, u"Table"_s);
    showGrouped({bus::GroupPlace{0x81, false}, bus::GroupPlace{}});
    ASSERT_EQ(groups->currentText(), u"Group 81"_s);
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(names.size(), 0) << "it was meant for group 82, which nobody is in any more";
    EXPECT_EQ(field->text(), QString());
}

TEST_F(ChainWindow, TheLongestChainFitsALowScreenAndScrolls) {
    std::vector<std::optional<bus::GroupPlace>> places(32, bus::GroupPlace{});
    showGrouped(places);
    open("groupsAction");
    auto* dialog = find(u"chainDialog"_s);
    EXPECT_LE(dialog->minimumSizeHint().height(), 768 - 64) << "less what a desktop uses itself";
    EXPECT_LE(dialog->height(), 768 - 64);
    dialog->resize(dialog->width(), 500);
    EXPECT_EQ(dialog->height(), 500);
    auto* last = find<QComboBox>(u"group32Box"_s);
    auto* scroll = find<QScrollArea>(u"groupsPageScroll"_s);
    EXPECT_GT(scroll->verticalScrollBar()->maximum(), 0);
    scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
    EXPECT_FALSE(last->visibleRegion().isEmpty());
}

TEST_F(ChainWindow, ItsKeysActWhileItHasTheFocus) {
    showServos({{}});
    open("groupsAction");
    auto* dialog = find<QDialog>(u"chainDialog"_s);
    ASSERT_TRUE(QTest::qWaitForWindowActive(dialog, testing_support::kPatienceMs));
    auto* pages = dialog->findChild<QTabWidget*>(u"chainPages"_s);
    QTest::keyClick(dialog, Qt::Key_F8);
    EXPECT_EQ(pages->currentIndex(), 2);
    QTest::keyClick(dialog, Qt::Key_F6);
    EXPECT_EQ(pages->currentIndex(), 0);
    QSignalSpy scans(&window->requests(), &Requests::scan);
    QTest::keyClick(dialog, Qt::Key_F5);
    EXPECT_EQ(scans.size(), 1);
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), testing_support::kPatienceMs));
    QTest::keyClick(window.get(), Qt::Key_F7);
    EXPECT_EQ(pages->currentIndex(), 1);
}

TEST_F(ChainWindow, EscStopsTheMotorsFromHereToo) {
    showServos({{}});
    open("groupsAction");
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    QTest::keyClick(find(u"chainDialog"_s), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

}  // namespace
}  // namespace nmc
