// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "scopehistory.h"
#include "tests/support/choosefile.h"
#include "widgets/common/requests.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/scope/scopeplot.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/tracedefinition.h"
#include "windowtest.h"

namespace nmc {
namespace {

/// Samples of module 1 every 10 ms, with 1 s in a picture, of which 0.2 s are from before the trigger.
class Trigger : public WindowTest {
protected:
    Trigger() {
        showServos({{}, {}});
        choose(u"scopeWindowBox"_s, u"1 s"_s);
        click(u"scopeTriggerButton"_s);
    }
    void choose(const QString& box, const QString& item) {
        auto* combo = find<QComboBox>(box);
        const int row = combo->findText(item);
        ASSERT_GE(row, 0) << item.toStdString();
        combo->setCurrentIndex(row);
        emit combo->activated(row);
    }
    /// Adds samples up to `end`, with a frame every 50 ms.
    template <typename Fill>
    void run(double end, const Fill& fill) {
        for (; m_next <= end * 100 + 0.5; ++m_next) {
            const double t = m_next / 100.0;
            fill(t, made.add(t, 0));
            if (m_next % 5 == 0)
                window->showHistory(made.history(), HandMadeHistory::at(t));
        }
    }
    ScopeStrips& strips() { return *find<ScopeStrips>(u"scopeStrips"_s); }
    QString state() { return text(u"triggerStateLabel"_s); }
    [[nodiscard]] bool paused() { return button(u"scopePauseButton"_s)->isChecked(); }
    void expectShown(double left, double right) {
        EXPECT_TRUE(paused());
        EXPECT_NEAR(strips().time().left(), left, 1e-6);
        EXPECT_NEAR(strips().time().right(), right, 1e-6);
    }

    HandMadeHistory made{2};

private:
    int m_next = 0;
};

/// 100 counts/s from 3 s on.
void ramp(double t, ScopeSample& sample) {
    sample.position = t < 3 ? 0 : static_cast<std::int32_t>(std::lround((t - 3) * 100));
}

/// At rest, apart from a move from 3 to 4 s.
void oneMove(double t, ScopeSample& sample) {
    sample.status = t > 2.995 && t < 3.995 ? 0x08 : 0x09;
    sample.velocity = t > 2.995 && t < 3.995 ? 500.0F : 0.0F;
}

TEST_F(Trigger, SingleHoldsThePictureAroundTheCrossing) {
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    run(3.4, ramp);
    EXPECT_EQ(state(), u"waiting"_s);
    EXPECT_FALSE(paused());
    run(4.0, ramp);
    EXPECT_TRUE(state().startsWith(u"triggered "_s)) << state().toStdString();
    EXPECT_TRUE(state().endsWith(u"more samples to come"_s));
    run(6.0, ramp);
    expectShown(3.5 - 0.2, 3.5 + 0.8);
    EXPECT_TRUE(QRegularExpression(u"^triggered \\d\\d:\\d\\d:\\d\\d\\.\\d{3}$"_s).match(state()).hasMatch())
        << state().toStdString();
}

TEST_F(Trigger, WaitsForAStatusBit) {
    choose(u"triggerSourceBox"_s, u"move_done"_s);
    choose(u"triggerConditionBox"_s, u"becomes 0"_s);
    EXPECT_FALSE(find(u"triggerLevelField"_s)->isVisible());
    choose(u"triggerModeBox"_s, u"Single"_s);
    run(6.0, oneMove);
    expectShown(3.0 - 0.2, 3.0 + 0.8);
}

TEST_F(Trigger, WaitsForAVelocityWithAnotherShareBefore) {
    choose(u"triggerSourceBox"_s, u"velocity"_s);
    type(u"triggerLevelField"_s, u"250"_s);
    choose(u"triggerConditionBox"_s, u"falls to"_s);
    type(u"triggerBeforeField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    run(6.0, oneMove);
    // From 500 at 3.99 s to 0 at 4.00 s.
    expectShown(3.995 - 0.5, 3.995 + 0.5);
}

/// Four pictures and two files: the third replaces the first. A picture has the samples of 1 s, 101 of them
/// where both ends have one.
TEST_F(Trigger, EachPictureIsSavedAndTheLastOnesAreKept) {
    const QTemporaryDir folder;
    QSignalSpy saved(&window->requests(), &Requests::save);
    click(u"triggerSaveBox"_s);
    EXPECT_FALSE(find<QCheckBox>(u"triggerSaveBox"_s)->isChecked()) << "no folder yet";
    testing_support::chooseFile(*find<QFileDialog>(u"triggerFolderDialog"_s), folder.path());
    EXPECT_TRUE(find<QCheckBox>(u"triggerSaveBox"_s)->isChecked());
    type(u"triggerKeepField"_s, u"2"_s);
    QTest::keyClick(field(u"triggerKeepField"_s), Qt::Key_Return);
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Normal"_s);
    // A pulse every 3 s.
    run(13, [](double t, ScopeSample& sample) { sample.position = std::fmod(t, 3.0) > 2.0 ? 100 : 0; });
    ASSERT_EQ(saved.size(), 4);
    QStringList names;
    for (const auto& one : saved)
        names << one.at(0).toString().right(15);
    EXPECT_EQ(names, (QStringList{u"trigger 001.csv"_s, u"trigger 002.csv"_s, u"trigger 001.csv"_s,
                                  u"trigger 002.csv"_s}));
    EXPECT_TRUE(saved.at(0).at(0).toString().startsWith(folder.path()));
    const std::string content = saved.at(0).at(1).value<FileContent>()();
    EXPECT_TRUE(content.starts_with("# NMC Panel recording 1\n"));
    EXPECT_NEAR(static_cast<double>(std::ranges::count(content, '\n') - std::ranges::count(content, '#')),
                101, 2);
    EXPECT_TRUE(text(u"triggerSavedLabel"_s).startsWith(u"4 taken for"_s));

    click(u"triggerSaveBox"_s);
    run(20, [](double t, ScopeSample& sample) { sample.position = std::fmod(t, 3.0) > 2.0 ? 100 : 0; });
    EXPECT_EQ(saved.size(), 4);
}

TEST_F(Trigger, AnotherNumberOfKeptPicturesBeginsAnotherSeries) {
    const QTemporaryDir folder;
    QSignalSpy saved(&window->requests(), &Requests::save);
    click(u"triggerSaveBox"_s);
    testing_support::chooseFile(*find<QFileDialog>(u"triggerFolderDialog"_s), folder.path());
    const auto keep = [this](const QString& pictures) {
        type(u"triggerKeepField"_s, pictures);
        QTest::keyClick(field(u"triggerKeepField"_s), Qt::Key_Return);
    };
    keep(u"2"_s);
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Normal"_s);
    const auto pulses = [](double t, ScopeSample& sample) {
        sample.position = std::fmod(t, 3.0) > 2.0 ? 100 : 0;
    };
    run(7, pulses);
    ASSERT_EQ(saved.size(), 2);
    keep(u"1000"_s);
    run(10, pulses);
    ASSERT_EQ(saved.size(), 3);
    EXPECT_TRUE(saved.at(2).at(0).toString().endsWith(u"trigger 001.csv"_s)) << "2, not the usual 20";
    keep(u"4"_s);
    run(13, pulses);
    ASSERT_EQ(saved.size(), 4);
    EXPECT_TRUE(saved.at(3).at(0).toString().endsWith(u"trigger 001.csv"_s)) << "the first of four";
    EXPECT_TRUE(text(u"triggerSavedLabel"_s).startsWith(u"1 taken for"_s));
}

TEST_F(Trigger, ASinglePictureIsSavedOnce) {
    const QTemporaryDir folder;
    QSignalSpy saved(&window->requests(), &Requests::save);
    click(u"triggerSaveBox"_s);
    testing_support::chooseFile(*find<QFileDialog>(u"triggerFolderDialog"_s), folder.path());
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    run(10, ramp);
    EXPECT_EQ(saved.size(), 1);
}

TEST_F(Trigger, ArmWaitsForTheNextOne) {
    choose(u"triggerSourceBox"_s, u"move_done"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    const auto often = [](double t, ScopeSample& sample) {
        sample.status = std::fmod(t, 2.0) > 0.995 ? 0x09 : 0x08;
    };
    run(2.5, often);
    expectShown(1.0 - 0.2, 1.0 + 0.8);
    click(u"triggerArmButton"_s);
    EXPECT_FALSE(paused());
    run(5.0, often);
    expectShown(3.0 - 0.2, 3.0 + 0.8);
}

TEST_F(Trigger, NormalGoesOnByItself) {
    choose(u"triggerSourceBox"_s, u"move_done"_s);
    choose(u"triggerModeBox"_s, u"Normal"_s);
    const auto often = [](double t, ScopeSample& sample) {
        sample.status = std::fmod(t, 4.0) > 0.995 ? 0x09 : 0x08;
    };
    run(3.5, often);
    expectShown(1.0 - 0.2, 1.0 + 0.8);
    run(7.5, often);
    expectShown(5.0 - 0.2, 5.0 + 0.8);
}

/// A picture is as long as the one that was visible when the trigger was armed, or has been since then; the
/// range of values is kept as well.
TEST_F(Trigger, KeepsTheZoomThatIsSet) {
    choose(u"triggerSourceBox"_s, u"move_done"_s);
    choose(u"triggerModeBox"_s, u"Normal"_s);
    const auto often = [](double t, ScopeSample& sample) {
        sample.status = std::fmod(t, 4.0) > 0.995 ? 0x09 : 0x08;
    };
    run(0.5, often);
    auto* plot = find<ScopePlot>(u"scopePlot1"_s);
    const auto wheel = [&](int notches, Qt::KeyboardModifiers modifiers) {
        const QPoint at = plot->plotArea().center().toPoint();
        QWheelEvent event(at, plot->mapToGlobal(at), {}, {0, notches * 120}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(plot, &event);
    };
    wheel(1, {});  // 0.8 s
    wheel(3, Qt::ControlModifier);
    run(0.7, often);
    const AxisRange::Range values = plot->valueRange();
    run(3.5, often);
    expectShown(1.0 - 0.2 * 0.8, 1.0 + 0.8 * 0.8);
    wheel(1, {});  // 0.64 s: the picture that is there stays, and the next one is as long
    EXPECT_NEAR(strips().time().width(), 0.64, 1e-6);
    run(7.5, often);
    expectShown(5.0 - 0.2 * 0.64, 5.0 + 0.8 * 0.64);
    EXPECT_EQ(plot->valueRange(), values);
}

TEST_F(Trigger, OffGoesBackToThePresent) {
    choose(u"triggerSourceBox"_s, u"move_done"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    run(6.0, oneMove);
    ASSERT_TRUE(paused());
    choose(u"triggerModeBox"_s, u"Off"_s);
    EXPECT_FALSE(paused());
    run(6.1, oneMove);
    EXPECT_EQ(state(), QString());
    EXPECT_FALSE(button(u"triggerArmButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"triggerArmButton"_s)->toolTip().contains(u"mode"_s));
}

TEST_F(Trigger, OutOfSightItIsOff) {
    choose(u"triggerSourceBox"_s, u"move_done"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    click(u"scopeTriggerButton"_s);
    EXPECT_FALSE(find(u"triggerBar"_s)->isVisible());
    run(6.0, oneMove);
    EXPECT_FALSE(paused());
}

TEST_F(Trigger, WithoutALevelItCannotBeArmed) {
    choose(u"triggerModeBox"_s, u"Single"_s);
    type(u"triggerLevelField"_s, {});
    EXPECT_FALSE(button(u"triggerArmButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"triggerArmButton"_s)->toolTip().isEmpty());
    run(6.0, ramp);
    EXPECT_FALSE(paused());
}

TEST_F(Trigger, TheLevelStaysTheSameInAnotherUnit) {
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 100.0, {}};
    window->showMachine(machine);
    EXPECT_EQ(field(u"triggerLevelField"_s)->value(), 0.5);
    run(6.0, ramp);
    expectShown(3.5 - 0.2, 3.5 + 0.8);
}

/// Half a millimetre of one module is not half a count of another.
TEST_F(Trigger, TheLevelIsOfNoOtherModuleInAnotherUnit) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 100.0, {}};
    window->showMachine(machine);
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    ASSERT_EQ(window->selectedModule(), ModuleIndex(1));
    EXPECT_EQ(field(u"triggerLevelField"_s)->value(), 0) << "which is the same in any unit";
    QTest::keyClick(list, Qt::Key_Up);
    type(u"triggerLevelField"_s, u"0.5"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    ASSERT_EQ(window->selectedModule(), ModuleIndex(1));
    EXPECT_EQ(field(u"triggerLevelField"_s)->text(), QString());
    EXPECT_FALSE(button(u"triggerArmButton"_s)->isEnabled());
}

TEST_F(Trigger, OffersTheSignalsOfTheSelectedModuleAndOfEachByItsName) {
    auto* sources = find<QComboBox>(u"triggerSourceBox"_s);
    EXPECT_EQ(sources->itemText(0), u"position"_s);
    EXPECT_GE(sources->findText(u"Module 1: position"_s), 0);
    EXPECT_GE(sources->findText(u"Module 2: velocity"_s), 0);
    EXPECT_GE(sources->findText(u"Module 2: move_done"_s), 0);
}

TEST_F(Trigger, WaitsForTheModuleThatIsNamedWhicheverIsSelected) {
    auto* sources = find<QComboBox>(u"triggerSourceBox"_s);
    choose(u"triggerSourceBox"_s, u"Module 2: velocity"_s);
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    ASSERT_EQ(window->selectedModule(), ModuleIndex(1));
    run(0.5, oneMove);
    EXPECT_EQ(sources->currentText(), u"Module 2: velocity"_s);
    EXPECT_EQ(field(u"triggerLevelField"_s)->value(), 50);
    EXPECT_EQ(state(), u"waiting"_s);
}

TEST_F(Trigger, StaysWithItsModuleIfTheSelectedOneHasNoSuchSignal) {
    ModuleState pins = Servo{.index = 1}.state();
    pins.info.identity = {ModuleType::Io, 1};
    window->showLink(connectedTo({Servo{}.state(), pins}));
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Normal"_s);
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    ASSERT_EQ(window->selectedModule(), ModuleIndex(1));
    run(0.5, oneMove);
    EXPECT_EQ(find<QComboBox>(u"triggerSourceBox"_s)->currentText(), u"Module 1: position"_s);
    EXPECT_EQ(field(u"triggerLevelField"_s)->value(), 50);
    EXPECT_EQ(state(), u"waiting"_s);
}

TEST_F(Trigger, IsOffOnceWhatItWaitsForIsGone) {
    choose(u"triggerSourceBox"_s, u"Module 2: move_done"_s);
    choose(u"triggerModeBox"_s, u"Normal"_s);
    run(0.5, oneMove);
    ASSERT_EQ(state(), u"waiting"_s);
    showServo();
    run(1, oneMove);
    EXPECT_EQ(find<QComboBox>(u"triggerModeBox"_s)->currentText(), u"Off"_s);
    EXPECT_EQ(state(), QString());
}

TEST_F(Trigger, HasItsModulePolledLikeThoseThatAreShown) {
    EXPECT_EQ(window->watchedModules(), std::set{ModuleIndex(0)});
    choose(u"triggerSourceBox"_s, u"Module 2: move_done"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    EXPECT_EQ(window->watchedModules(), (std::set{ModuleIndex(0), ModuleIndex(1)}));
    choose(u"triggerModeBox"_s, u"Off"_s);
    EXPECT_EQ(window->watchedModules(), std::set{ModuleIndex(0)});
}

/// Starts at 3 s with 20 000 counts/s^2. At this moment, the parabola over five samples shows half of it.
void speedsUp(double t, ScopeSample& sample) {
    const auto hundredths = std::lround((t - 3) * 100);
    sample.position = t < 3 ? 0 : static_cast<std::int32_t>(hundredths * hundredths);
}

TEST_F(Trigger, WaitsForAnAccelerationInTheAxisUnit) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 100.0, {}};
    window->showMachine(machine);
    pick(u"triggerSourceBox"_s, u"acceleration"_s);
    const QList<QLabel*> labels = find(u"triggerBar"_s)->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text() == u"mm/s²"_s;
    }));
    type(u"triggerLevelField"_s, u"100"_s);
    pick(u"triggerModeBox"_s, u"Single"_s);
    run(2.0, speedsUp);
    click(u"triggerArmButton"_s);
    EXPECT_EQ(state(), u"waiting"_s);
    run(3.8, speedsUp);
    EXPECT_TRUE(state().endsWith(u"more samples to come"_s)) << state().toStdString();
    run(6.0, speedsUp);
    expectShown(3.0 - 0.2, 3.0 + 0.8);
}

/// 20 counts for 1 s are 39 062 in the sum over ticks of 0.512 ms, of which IL leaves 100 times 256: a PWM of
/// 100 that remains, but would be 0 if calculated only from the samples since the trigger was set.
TEST_F(Trigger, WaitsForThePwmThatThePlotShows) {
    made.noteGains(0, {0, 0, 256, 100, 255, 0, 16'000, 1, std::uint8_t{0}});
    const auto pushed = [](double t, ScopeSample& sample) {
        sample.aux = 0x04;  // servo on
        sample.error = sample.errorLow = sample.errorHigh = t > 0.995 && t < 1.995 ? 20.0F : 0.0F;
    };
    run(3.0, pushed);
    pick(u"triggerSourceBox"_s, u"PWM, calculated"_s);
    type(u"triggerLevelField"_s, u"99"_s);
    pick(u"triggerConditionBox"_s, u"is above"_s);
    pick(u"triggerModeBox"_s, u"Single"_s);
    run(5.0, pushed);
    expectShown(3.0 - 0.2, 3.0 + 0.8);
}

/// The trace falls by 100 a second, and by half of that with the other definition.
TEST_F(Trigger, WaitsForWhatTheUserHasDefinedAndForItsNewDefinition) {
    auto* panel = find<ScopePanel>(u"scopePanel"_s);
    ScopeSetup setup = panel->setup();
    setup.custom[0] = TraceDefinition{u"lead"_s, u"ct"_s, {{{}, ScopeSignal::Position}, -1}};
    panel->setSetup(setup);
    pick(u"triggerSourceBox"_s, u"lead"_s);
    type(u"triggerLevelField"_s, u"-150"_s);
    pick(u"triggerConditionBox"_s, u"falls to"_s);
    pick(u"triggerModeBox"_s, u"Single"_s);
    const auto ramp = [](double t, ScopeSample& sample) {
        sample.position = static_cast<std::int32_t>(std::lround(100 * t));
    };
    run(1.4, ramp);
    EXPECT_EQ(state(), u"waiting"_s);
    run(2.6, ramp);
    expectShown(1.5 - 0.2, 1.5 + 0.8);
    setup.custom[0]->first.factor = -0.5;
    panel->setSetup(setup);
    run(2.7, ramp);
    EXPECT_EQ(state(), u"waiting"_s) << "it waits again for the new definition";
    run(4.2, ramp);
    expectShown(3.0 - 0.2, 3.0 + 0.8);
}

/// The picture of another chain is neither completed with the samples of this one nor shown over them.
TEST_F(Trigger, WaitsAgainWhenAnotherChainIsConnected) {
    const QTemporaryDir folder;
    QSignalSpy saved(&window->requests(), &Requests::save);
    click(u"triggerSaveBox"_s);
    testing_support::chooseFile(*find<QFileDialog>(u"triggerFolderDialog"_s), folder.path());
    type(u"triggerLevelField"_s, u"50"_s);
    choose(u"triggerModeBox"_s, u"Single"_s);
    // Two seconds at rest.
    const auto connectAnother = [this](double from) {
        made = HandMadeHistory{2};
        for (int i = 0; i <= 200; ++i)
            made.add(from + i / 100.0, 0);
        window->showHistory(made.history(), HandMadeHistory::at(from + 2));
    };
    run(3.6, ramp);
    EXPECT_TRUE(state().endsWith(u"more samples to come"_s)) << state().toStdString();
    connectAnother(10);
    EXPECT_EQ(state(), u"waiting"_s);
    EXPECT_FALSE(paused());
    EXPECT_EQ(saved.size(), 0);
    for (int i = 5; i <= 300; ++i) {
        made.add(12 + i / 100.0, i < 100 ? 0 : i - 100);
        if (i % 5 == 0)
            window->showHistory(made.history(), HandMadeHistory::at(12 + i / 100.0));
    }
    expectShown(3.5 - 0.2, 3.5 + 0.8);
    EXPECT_EQ(saved.size(), 1);
    connectAnother(20);
    EXPECT_EQ(state(), u"waiting"_s);
    EXPECT_FALSE(paused());
    EXPECT_EQ(saved.size(), 1);
}

TEST_F(Trigger, OffersWhatIsMadeOfSamplesOnlyWhereItCanBe) {
    const auto* sources = find<QComboBox>(u"triggerSourceBox"_s);
    EXPECT_GE(sources->findText(u"acceleration"_s), 0);
    EXPECT_GE(sources->findText(u"PWM, calculated"_s), 0);
    EXPECT_GE(sources->findText(u"Module 2: acceleration"_s), 0);
    EXPECT_EQ(sources->findText(u"count rate"_s), -1);
    const auto show = [this](ModuleType type) {
        ModuleState module = Servo{}.state();
        module.info.identity = {type, 1};
        window->showLink(connectedTo({module}));
    };
    show(ModuleType::Stepper);
    EXPECT_GE(sources->findText(u"acceleration"_s), 0);
    EXPECT_EQ(sources->findText(u"PWM, calculated"_s), -1) << "a stepper has no PWM";
    show(ModuleType::Io);
    EXPECT_GE(sources->findText(u"count rate"_s), 0);
    EXPECT_EQ(sources->findText(u"acceleration"_s), -1);
}

}  // namespace
}  // namespace nmc
