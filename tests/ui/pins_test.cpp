// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of a PIC-I/O, by mouse and keys. IO1 and IO2 are outputs, and IO1 and IO12 read high.
#include <QAbstractItemView>
#include <QSignalSpy>

#include "scopehistory.h"
#include "widgets/scope/scopeplot.h"
#include "widgets/scope/statuslane.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Pins : public WindowTest {
protected:
    Pins() {
        module.info = {ModuleIndex(0), BusAddress(1), {ModuleType::Io, 1}};
        told(io::SetDirection{0x0FFC});
        told(io::SetOutput{0x0001});
        latch(0x0801, 0);
        QObject::connect(&window->requests(), &Requests::axisEdited,
                         [this](ModuleIndex, const AxisSettings& axis) { edited = axis; });
    }
    void told(const IoCommand& command) {
        module.apply(bus::CommandExecuted{ModuleIndex(0), TimePoint{}, command});
    }
    void latch(std::uint16_t pins, int millisecond) {
        bus::Sample sample;
        sample.time = TimePoint(std::chrono::seconds(1) + std::chrono::milliseconds(millisecond));
        sample.report.items = StatusItems(0x1F);
        sample.report.pins = pins;
        sample.report.analogs = {std::uint8_t{0}, std::uint8_t{102}, std::uint8_t{255}};
        sample.report.counter = 5'000'000;
        module.apply(sample);
        show();
    }
    void show() { window->showLink(connectedTo({module})); }
    void strike(const QString& box) {
        auto* check = find<QCheckBox>(box);
        QTest::mouseClick(check, Qt::LeftButton, {}, {check->height() / 2, check->height() / 2});
    }
    template <typename Asked>
    Asked only() {
        EXPECT_EQ(intents.size(), 1);
        if (intents.empty())
            return {};
        return std::get<Asked>(intents.takeFirst().at(1).template value<Intent>());
    }
    /// Sets what the machine file says about this pin.
    void settings(std::size_t pin, const OutputSettings& output) {
        machine.axes.resize(1);
        machine.axes[0].pins.emplace();
        PinSettings::in(machine.axes[0].pins->pins, pin) = output;
        window->showMachine(machine);
        show();
    }

    ModuleState module;
    AxisSettings edited;
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

/// Otherwise the next status would take back what an operator types or clicks there.
TEST_F(Pins, AreSwitchedByAnOperatorButNotSetUp) {
    module.rights = OperatorRights{.outputs = true};
    show();
    EXPECT_TRUE(button(u"pin1Box"_s)->isEnabled()) << button(u"pin1Box"_s)->toolTip().toStdString();
    for (const QString& locked : {u"pin1Name"_s, u"pin1Asks"_s, u"pin1OffAtStop"_s, u"ioNameField"_s}) {
        EXPECT_FALSE(find(locked)->isEnabled()) << locked.toStdString();
        EXPECT_TRUE(find(locked)->toolTip().contains(u"operator mode"_s)) << locked.toStdString();
    }
}

TEST_F(Pins, SayWhatTheyReadAndWhichWayTheyGo) {
    EXPECT_EQ(text(u"ioStateLabel"_s), u"Ready"_s);
    EXPECT_EQ(text(u"pin1Level"_s), u"high"_s);
    EXPECT_EQ(text(u"pin2Level"_s), u"low"_s);
    EXPECT_EQ(text(u"pin12Level"_s), u"high"_s);
    EXPECT_EQ(find<QComboBox>(u"pin1Direction"_s)->currentText(), u"output"_s);
    EXPECT_EQ(find<QComboBox>(u"pin3Direction"_s)->currentText(), u"input"_s);
    EXPECT_FALSE(find<QCheckBox>(u"pin3Box"_s)->isEnabled()) << "it is an input";
    latch(0x0800, 20);
    EXPECT_EQ(text(u"pin1Level"_s), u"low, set high"_s);
}

TEST_F(Pins, AnOutputIsSwitchedByAClickAndShowsWhatWasConfirmed) {
    strike(u"pin2Box"_s);
    const auto set = only<iointent::SetOutput>();
    EXPECT_EQ(set.pin, 1U);
    EXPECT_TRUE(set.high);
    EXPECT_FALSE(find<QCheckBox>(u"pin2Box"_s)->isChecked());
    told(io::SetOutput{0x0003});
    latch(0x0803, 20);
    EXPECT_TRUE(find<QCheckBox>(u"pin2Box"_s)->isChecked());
}

TEST_F(Pins, ADirectionIsChosenByKeys) {
    auto* direction = find<QComboBox>(u"pin3Direction"_s);
    direction->setFocus();
    QTest::keyClick(direction, Qt::Key_Down);
    EXPECT_EQ(only<iointent::SetDirection>().inputs, 0x0FF8);
}

/// The last choice is "? unknown", which is shown until the directions are known; the first is "input".
TEST_F(Pins, OnlyAnotherDirectionIsARequest) {
    auto* direction = find<QComboBox>(u"pin3Direction"_s);
    direction->setFocus();
    QTest::keyClick(direction, Qt::Key_End);
    EXPECT_EQ(direction->currentText(), u"input"_s);
    const QSignalSpy chosen(direction, &QComboBox::activated);
    QTest::keyClick(direction, Qt::Key_Space);
    QTest::keyClick(direction->view(), Qt::Key_Return);
    EXPECT_EQ(chosen.count(), 1) << "the list was opened, and left with Enter";
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Pins, WhatAnotherProgramHasLeftIsUnknownUntilAllAreInputs) {
    module.attached();
    latch(0x0801, 20);
    EXPECT_EQ(find<QComboBox>(u"pin1Direction"_s)->currentText(), u"? unknown"_s);
    EXPECT_FALSE(find<QCheckBox>(u"pin1Box"_s)->isEnabled());
    click(u"pinsAllInputsButton"_s);
    EXPECT_EQ(only<iointent::SetDirection>().inputs, 0x0FFF);
}

TEST_F(Pins, OneThatAsksIsSwitchedOnlyByTheAnswer) {
    settings(1, {"Pump", true, false});
    strike(u"pin2Box"_s);
    EXPECT_EQ(intents.size(), 0);
    auto* question = window->findChild<QDialog*>(u"outputDialog"_s);
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->findChild<QLabel*>(u"closeText"_s)->text(), u"Switch Pump (IO2) on?"_s);
    EXPECT_FALSE(question->isModal()) << "STOP ALL stays within reach";
    QTest::mouseClick(question->findChild<QAbstractButton*>(u"switchOutputButton"_s), Qt::LeftButton);
    EXPECT_EQ(only<iointent::SetOutput>().pin, 1U);
}

TEST_F(Pins, OneThatAsksIsMadeAnInputOnlyByTheAnswerWhileItIsHigh) {
    settings(0, {"Lamp", true, false});
    PinSettings::in(machine.axes[0].pins->pins, 1) = {"Pump", true, false};
    window->showMachine(machine);
    auto* low = find<QComboBox>(u"pin2Direction"_s);
    low->setFocus();
    QTest::keyClick(low, Qt::Key_Up);
    EXPECT_EQ(only<iointent::SetDirection>().inputs, 0x0FFE) << "the level of IO2 does not change";
    latch(0x0801, 20);  // it answers
    auto* high = find<QComboBox>(u"pin1Direction"_s);
    high->setFocus();
    QTest::keyClick(high, Qt::Key_Up);
    EXPECT_EQ(intents.size(), 0);
    auto* question = window->findChild<QDialog*>(u"outputDialog"_s);
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->findChild<QLabel*>(u"closeText"_s)->text(), u"Switch Lamp (IO1) off?"_s);
    QTest::mouseClick(question->findChild<QAbstractButton*>(u"switchOutputButton"_s), Qt::LeftButton);
    EXPECT_EQ(only<iointent::SetDirection>().inputs, 0x0FFD);
}

TEST_F(Pins, OneThatAsksIsMadeAHighOutputOnlyByTheAnswer) {
    settings(2, {"Clamp", true, false});
    told(io::SetOutput{0x0005});
    latch(0x0805, 20);
    auto* direction = find<QComboBox>(u"pin3Direction"_s);
    direction->setFocus();
    QTest::keyClick(direction, Qt::Key_Down);
    EXPECT_EQ(intents.size(), 0);
    auto* question = window->findChild<QDialog*>(u"outputDialog"_s);
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->findChild<QLabel*>(u"closeText"_s)->text(), u"Switch Clamp (IO3) on?"_s);
    QTest::mouseClick(question->findChild<QAbstractButton*>(u"switchOutputButton"_s), Qt::LeftButton);
    EXPECT_EQ(only<iointent::SetDirection>().inputs, 0x0FF8);
}

TEST_F(Pins, TheQuestionIsAboutTheOutputThatWasStruckLast) {
    settings(1, {"Pump", true, false});
    PinSettings::in(machine.axes[0].pins->pins, 0) = {"Lamp", true, false};
    window->showMachine(machine);
    strike(u"pin2Box"_s);
    strike(u"pin1Box"_s);
    auto* question = window->findChild<QDialog*>(u"outputDialog"_s);
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->findChild<QLabel*>(u"closeText"_s)->text(), u"Switch Lamp (IO1) off?"_s);
    QTest::mouseClick(question->findChild<QAbstractButton*>(u"switchOutputButton"_s), Qt::LeftButton);
    const auto set = only<iointent::SetOutput>();
    EXPECT_EQ(set.pin, 0U);
    EXPECT_FALSE(set.high);
}

TEST_F(Pins, TheQuestionStandsWhileOtherPinsChange) {
    settings(1, {"Pump", true, false});
    strike(u"pin2Box"_s);
    const QPointer<QDialog> question = window->findChild<QDialog*>(u"outputDialog"_s);
    ASSERT_NE(question, nullptr);
    latch(0x0C01, 20);  // an input went high
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->isVisible());
    told(io::SetOutput{0x0003});
    latch(0x0C03, 30);
    EXPECT_TRUE(question == nullptr || !question->isVisible()) << "it has been switched on otherwise";
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Pins, WhatIsTypedBesideThemIsKeptAndSendsNothing) {
    find<QLineEdit>(u"pin4Name"_s)->setFocus();
    QTest::keyClicks(find<QLineEdit>(u"pin4Name"_s), u"Lamp"_s);
    ASSERT_TRUE(edited.pins.has_value());
    EXPECT_EQ(PinSettings::of(edited.pins->pins, 3).name, "Lamp");
    strike(u"pin4OffAtStop"_s);
    EXPECT_EQ(PinSettings::offAtStop(edited.pins->pins), 0x0008);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Pins, AnalogInputsHaveScalesOfTheirOwn) {
    EXPECT_EQ(text(u"analog2Value"_s), u"2 V (102 of 255)"_s);  // 102 / 255 of 5 V
    type(u"analog2PerCount"_s, u"0.5"_s);
    ASSERT_TRUE(edited.pins.has_value());
    EXPECT_EQ(PinSettings::of(edited.pins->analog, 1).scale.perCount, 0.5);
    EXPECT_EQ(find<QLineEdit>(u"analog2Unit"_s)->toolTip(), u"The unit of the value."_s);
}

TEST_F(Pins, APwmOutputIsSentByEnter) {
    type(u"ioPwm2Field"_s, u"128"_s);
    QTest::keyClick(field(u"ioPwm2Field"_s), Qt::Key_Return);
    const auto set = only<iointent::SetPwm>();
    EXPECT_EQ(set.output, 1U);
    EXPECT_EQ(set.value, 128);
}

TEST_F(Pins, APwmOutputThatIsUnknownIsNotSwitchedOffWithTheOther) {
    module.attached();
    latch(0x0801, 20);
    EXPECT_EQ(text(u"ioPwm1State"_s), u"? unknown"_s);
    type(u"ioPwm2Field"_s, u"128"_s);
    QTest::keyClick(field(u"ioPwm2Field"_s), Qt::Key_Return);
    EXPECT_EQ(intents.size(), 0);
    type(u"ioPwm1Field"_s, u"7"_s);
    QTest::keyClick(field(u"ioPwm1Field"_s), Qt::Key_Return);
    const auto set = only<iointent::SetPwm>();
    EXPECT_EQ(set.output, 0U);
    EXPECT_EQ(set.value, 7);
    EXPECT_EQ(set.other, std::uint8_t{128});
}

TEST_F(Pins, AnOperatorWithOutputsSetsThePwmAndNothingElseOfItsPage) {
    told(io::SetPwm{0, 0});
    module.rights = OperatorRights{.outputs = true};
    show();
    for (const char* locked :
         {"ioPwm1Name", "ioPwm1OffAtStop", "analog1Name", "analog1Unit", "analog1PerCount", "analog1AtZero"})
        EXPECT_FALSE(find(QLatin1String(locked))->isEnabled()) << locked;
    type(u"ioPwm1Field"_s, u"7"_s);
    QTest::keyClick(field(u"ioPwm1Field"_s), Qt::Key_Return);
    EXPECT_EQ(only<iointent::SetPwm>().value, 7);
    module.rights->outputs = false;
    show();
    EXPECT_FALSE(field(u"ioPwm1Field"_s)->isEnabled());
}

TEST_F(Pins, TheTimerCountsFiveMillionASecond) {
    find<QComboBox>(u"timerModeBox"_s)->setFocus();
    QTest::keyClick(find<QComboBox>(u"timerModeBox"_s), Qt::Key_Down);
    click(u"setTimerButton"_s);
    const auto set = only<iointent::SetTimer>();
    EXPECT_TRUE(set.mode.enable);
    EXPECT_FALSE(set.mode.counter);
    told(set.mode);
    latch(0x0801, 20);
    EXPECT_EQ(text(u"counterRate"_s), u"= 1 s"_s);
}

TEST_F(Pins, WhatIsStoredIsPutOutLater) {
    EXPECT_FALSE(button(u"synchOutputButton"_s)->isEnabled());
    type(u"storedOutputsField"_s, u"5"_s);
    click(u"storeOutputsButton"_s);
    const auto store = only<iointent::StoreOutputs>();
    EXPECT_EQ(store.outputs, (io::SetSynchOutput{5, 0, 0}));
    told(store.outputs);
    latch(0x0801, 20);
    click(u"synchOutputButton"_s);
    (void)only<iointent::SynchOutput>();
}

/// IO1 is high already, IO2 is low, and IO3 is an input.
TEST_F(Pins, StoredOutputsThatAskAreAppliedOnlyByTheAnswer) {
    settings(0, {"Lamp", true, false});
    PinSettings::in(machine.axes[0].pins->pins, 2) = {"Valve", true, false};
    window->showMachine(machine);
    told(io::SetSynchOutput{0x0007, 0, 0});
    latch(0x0801, 20);
    click(u"synchOutputButton"_s);
    (void)only<iointent::SynchOutput>();
    PinSettings::in(machine.axes[0].pins->pins, 1) = {"Pump", true, false};
    window->showMachine(machine);
    told(io::SetSynchOutput{0x0006, 0, 0});
    latch(0x0801, 30);
    click(u"synchOutputButton"_s);
    EXPECT_EQ(intents.size(), 0);
    auto* question = window->findChild<QDialog*>(u"outputDialog"_s);
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->findChild<QLabel*>(u"closeText"_s)->text(),
              u"Switch Lamp (IO1) off?\nSwitch Pump (IO2) on?"_s);
    QTest::mouseClick(question->findChild<QAbstractButton*>(u"switchOutputButton"_s), Qt::LeftButton);
    (void)only<iointent::SynchOutput>();
}

TEST_F(Pins, ASilentModuleTakesNothing) {
    module.silent = true;
    show();
    EXPECT_FALSE(find<QCheckBox>(u"pin2Box"_s)->isEnabled());
    EXPECT_FALSE(find<QComboBox>(u"pin3Direction"_s)->isEnabled());
    EXPECT_EQ(text(u"ioStateLabel"_s), u"No answer"_s);
}

/// This has happened: the page of a module that had restarted showed its last levels as if they were live.
TEST_F(Pins, WhatASilentModuleReportedLastIsStruckOut) {
    const QStringList values{u"pin1Level"_s, u"pin2Level"_s, u"analog2Value"_s, u"counterValue"_s};
    const auto struckOut = [this](const QString& value) { return find<QLabel>(value)->font().strikeOut(); };
    for (const QString& value : values)
        EXPECT_FALSE(struckOut(value)) << value.toStdString();
    const QString live = text(u"ioStateMeaning"_s);
    module.silent = true;
    show();
    for (const QString& value : values)
        EXPECT_TRUE(struckOut(value)) << value.toStdString();
    EXPECT_EQ(text(u"pin1Level"_s), u"high"_s) << "the last level stays to be read";
    EXPECT_TRUE(text(u"ioStateMeaning"_s).contains(u"Last answer: "_s));
    module.restarted();
    show();
    EXPECT_TRUE(struckOut(u"pin1Level"_s));
    EXPECT_FALSE(find<QCheckBox>(u"pin1Box"_s)->isChecked());
    module.silent = false;
    module.hasRestarted = false;
    latch(0, 20);
    for (const QString& value : values)
        EXPECT_FALSE(struckOut(value)) << value.toStdString();
    EXPECT_EQ(text(u"ioStateMeaning"_s), live);
}

/// A/D 2 is in bar, with 0.5 bar per count above -10 bar; it rises by one count every 10 ms.
TEST_F(Pins, AreOnTheScopeByTheNamesOfTheMachine) {
    machine.axes.resize(1);
    PinSettings& pins = machine.axes[0].pins.emplace();
    PinSettings::in(pins.pins, 8).name = "Door";
    PinSettings::in(pins.analog, 1) = {"Pressure", {0.5, -10, "bar"}};
    window->showMachine(machine);
    show();
    HandMadeHistory made;
    for (int i = 0; i <= 100; ++i) {
        ScopeSample& sample = made.add(i / 100.0, 0);
        sample.io = true;
        sample.error = static_cast<float>(i);
        sample.velocity = 0;
    }
    click(u"scopeSignalsButton"_s);
    auto* dialog = find<QDialog>(u"scopeSignalsDialog"_s);
    QTest::keyClicks(dialog->findChild<QLineEdit*>(u"scopeSignalsFilter"_s), u"pressure"_s);
    const auto* table = dialog->findChild<QTreeWidget*>(u"scopeSignalsTable"_s);
    const QTreeWidgetItem* named = table->topLevelItem(1);
    QStringList seen, hidden;
    for (int i = 0; i < named->childCount(); ++i)
        (named->child(i)->isHidden() ? hidden : seen) << named->child(i)->text(0);
    EXPECT_EQ(seen, QStringList{u"Pressure"_s});
    EXPECT_EQ(hidden, (QStringList{u"A/D 1"_s, u"A/D 3"_s, u"count"_s, u"count rate"_s}));
    dialog->reject();
    for (int i = 0; i < 3; ++i) {
        window->showHistory(made.history(), HandMadeHistory::at(1));
        QApplication::processEvents();
    }
    EXPECT_FALSE(find<ScopePlot>(u"scopePlot3"_s)->traces().empty());
    QStringList legend;
    for (std::size_t i = 0; i < find<ScopePlot>(u"scopePlot3"_s)->traces().size(); ++i)
        legend << find<ScopePlot>(u"scopePlot3"_s)->legendText(i);
    ASSERT_EQ(legend.size(), 3) << legend.join(u'|').toStdString();
    EXPECT_TRUE(legend[1].startsWith(u"Pressure, bar"_s)) << legend[1].toStdString();
    EXPECT_GE(find<ScopePlot>(u"scopePlot3"_s)->valueRange().max, 40) << "100 x 0.5 bar - 10 bar";
    EXPECT_LE(find<ScopePlot>(u"scopePlot3"_s)->valueRange().min, -10);
    const auto* lane = find<StatusLane>(u"scopeStatusLane"_s);
    EXPECT_EQ(lane->bits().size(), 12U);
}

}  // namespace
}  // namespace nmc
