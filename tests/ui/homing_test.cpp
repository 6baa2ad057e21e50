// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/intent/homingplan.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/homingbox.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Homing : public WindowTest {
protected:
    void open() { find(u"homingBox"_s); }
    void show(const Servo& servo = {}) {
        showServo(servo);
        open();
    }
    /// Shows a servo whose status byte or settings were changed by `change`.
    template <typename Change>
    void showChanged(const Servo& servo, Change change) {
        ModuleState module = servo.state();
        change(module);
        window->showLink(connectedTo({module}));
        open();
    }
    HomingRecipe kept() { return machine.axes.at(0).homing.value(); }
    QString reason(const QString& control) {
        EXPECT_FALSE(button(control)->isEnabled()) << control.toStdString();
        EXPECT_EQ(button(control)->toolTip(), button(control)->accessibleDescription());
        return button(control)->toolTip();
    }
    void report(ProcedureStage stage, std::optional<ProcedureFailure> failure = {},
                std::optional<std::int32_t> home = {}) {
        ProcedureReport r;
        r.kind = ProcedureKind::Homing;
        r.stage = stage;
        r.failure = failure;
        r.home = home;
        window->showProcedure(r);
    }

    QSignalSpy intents{&window->requests(), &Requests::intent};
    QSignalSpy edits{&window->requests(), &Requests::axisEdited};
};

/// Its end came while the page was not shown, and then another procedure.
TEST_F(Homing, OneThatIsLongOverDoesNotRun) {
    showServos({{}, {}});
    open();
    report(ProcedureStage::Searching);
    EXPECT_FALSE(button(u"homeButton"_s)->isEnabled());
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setCurrentIndex(list->model()->index(1, 0));
    report(ProcedureStage::Done);
    ProcedureReport steps;
    steps.kind = ProcedureKind::MoveBy;
    steps.stage = ProcedureStage::Done;
    window->showProcedure(steps);
    list->setCurrentIndex(list->model()->index(0, 0));
    open();
    EXPECT_EQ(button(u"homeButton"_s)->toolTip().toStdString().find("is running"), std::string::npos);
    EXPECT_TRUE(field(u"homingVelocityField"_s)->isEnabled());
}

TEST_F(Homing, WhatIsShownIsSentAndKept) {
    show();
    click(u"onLimit1Box"_s);
    click(u"onLimit2Box"_s);
    click(u"thenIndexBox"_s);
    click(u"homingForwardButton"_s);
    type(u"homingVelocityField"_s, u"1,25"_s);
    type(u"homingIndexVelocityField"_s, u"0.05"_s);
    type(u"homingAccelerationField"_s, u"0.01"_s);
    type(u"homingTravelField"_s, u"12000"_s);
    type(u"homingTimeField"_s, u"7,5"_s);
    click(u"homingSmoothlyButton"_s);
    click(u"makeZeroBox"_s);
    click(u"homeButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto home = std::get<intent::Home>(intents.at(0).at(1).value<Intent>());
    EXPECT_FALSE(home.recipe.onLimit1);
    EXPECT_TRUE(home.recipe.onLimit2);
    EXPECT_TRUE(home.recipe.thenIndex);
    EXPECT_FALSE(home.recipe.reverse);
    EXPECT_EQ(home.recipe.velocity, 1.25);
    EXPECT_EQ(home.recipe.indexVelocity, 0.05);
    EXPECT_EQ(home.recipe.acceleration, 0.01);
    EXPECT_EQ(home.recipe.travelLimit, 12'000);
    EXPECT_EQ(home.recipe.timeLimit, 7.5);
    EXPECT_EQ(home.recipe.stop, HomingRecipe::Stop::Smoothly);
    EXPECT_TRUE(home.recipe.goToHome);
    EXPECT_FALSE(home.recipe.makeZero);
    EXPECT_EQ(kept(), home.recipe);
    EXPECT_EQ(home.tolerance, 1) << "in counts";
}

TEST_F(Homing, ShowingEmitsNothing) {
    show();
    const auto before = edits.size();
    machine.axes.resize(1);
    HomingRecipe recipe = firstRecipe({ModuleType::Servo, 4});
    recipe.onIndex = true;
    recipe.velocity = 2.5;
    machine.axes[0].homing = recipe;
    window->showMachine(machine);
    EXPECT_TRUE(button(u"onIndexBox"_s)->isChecked());
    EXPECT_EQ(field(u"homingVelocityField"_s)->value(), 2.5);
    machine.axes[0].unit = {UnitKind::Turns, 2'000.0, {}};
    window->showMachine(machine);
    EXPECT_EQ(edits.size(), before);
    EXPECT_EQ(intents.size(), 0);
    // 2.5 counts/tick at 1953.125 ticks/s and 2 000 counts/turn
    EXPECT_NEAR(field(u"homingVelocityField"_s)->value().value_or(0), 2.4414, 0.0001);
    click(u"homeButton"_s);
    EXPECT_EQ(std::get<intent::Home>(intents.at(0).at(1).value<Intent>()).recipe.velocity, 2.5);
}

TEST_F(Homing, WhatIsBeingTypedIsNotOverwrittenByAStatus) {
    show();
    type(u"homingTravelField"_s, u"12x"_s);
    show({.millisecond = 20});
    EXPECT_EQ(field(u"homingTravelField"_s)->text(), u"12x"_s);
    EXPECT_EQ(reason(u"homeButton"_s), field(u"homingTravelField"_s)->problemText());
    EXPECT_EQ(text(u"homingHint"_s), field(u"homingTravelField"_s)->problemText());
    type(u"homingTravelField"_s, u"12"_s);
    EXPECT_TRUE(button(u"homeButton"_s)->isEnabled());
}

/// 40 000 is too many counts per tick, but not too many turns of 1000 counts per second.
TEST_F(Homing, SearchesWithWhatIsShownInAnotherUnit) {
    show();
    type(u"homingVelocityField"_s, u"40000"_s);
    EXPECT_EQ(reason(u"homeButton"_s), field(u"homingVelocityField"_s)->problemText());
    machine.axes[0].unit = {UnitKind::Turns, 1'000.0, {}};
    window->showMachine(machine);
    EXPECT_EQ(field(u"homingVelocityField"_s)->value(), 7'812.5) << "4000 counts/tick, the last valid number";
    click(u"homeButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(std::get<intent::Home>(intents.at(0).at(1).value<Intent>()).recipe.velocity, 4'000.0);
}

TEST_F(Homing, SaysWhyItIsNotPossible) {
    show({.on = false});
    EXPECT_EQ(reason(u"homeButton"_s), texts::refusal(Refusal::ServoOff));
    show({.power = false});
    EXPECT_EQ(reason(u"homeButton"_s), texts::refusal(Refusal::NoPower));
    show({.moveDone = false});
    EXPECT_EQ(reason(u"homeButton"_s), texts::refusal(Refusal::Moving));
    show();
    click(u"onLimit1Box"_s);
    EXPECT_EQ(reason(u"homeButton"_s), texts::refusal(Refusal::NothingToFind));
    EXPECT_FALSE(button(u"cancelHomingButton"_s)->isEnabled());
    LinkState link = connectedTo({Servo{}.state()});
    link.phase = LinkPhase::Lost;
    window->showLink(link);
    EXPECT_EQ(reason(u"homeButton"_s), texts::refusal(Refusal::NotConnected));
}

TEST_F(Homing, APositionErrorLeavesNoChoiceOfStop) {
    show();
    click(u"onPositionErrorBox"_s);
    EXPECT_TRUE(button(u"homingMotorOffButton"_s)->isChecked());
    EXPECT_TRUE(reason(u"homingAbruptlyButton"_s).contains(u"switches the servo off"_s));
    click(u"onPositionErrorBox"_s);
    EXPECT_TRUE(button(u"homingAbruptlyButton"_s)->isChecked()) << "the earlier choice is back";
    EXPECT_TRUE(button(u"homingAbruptlyButton"_s)->isEnabled());
}

TEST_F(Homing, ZeroNeedsHomeToBeGoneTo) {
    show();
    click(u"goToHomeBox"_s);
    EXPECT_TRUE(reason(u"makeZeroBox"_s).contains(u"Needs Go to home"_s));
    EXPECT_FALSE(text(u"homingStagesLabel"_s).contains(u"zero"_s));
}

TEST_F(Homing, TheIndexCannotComeTwice) {
    show();
    click(u"onIndexBox"_s);
    EXPECT_FALSE(reason(u"thenIndexBox"_s).isEmpty());
    EXPECT_FALSE(field(u"homingIndexVelocityField"_s)->isEnabled());
}

TEST_F(Homing, OldChipsAreStoppedByThePanelAndThatIsSaid) {
    for (const int version : {1, 2, 3, 4}) {
        show({.index = 0, .version = static_cast<std::uint8_t>(version), .millisecond = version});
        EXPECT_EQ(button(u"homingAbruptlyButton"_s)->toolTip().contains(u"the panel stops it"_s), version < 3)
            << version;
        EXPECT_EQ(button(u"armLimit1Box"_s)->isEnabled(), version >= 3) << version;
    }
}

TEST_F(Homing, U07_ADoubleClickIsOneSearch) {
    show();
    QTest::mouseClick(button(u"homeButton"_s), Qt::LeftButton);
    QTest::mouseDClick(button(u"homeButton"_s), Qt::LeftButton);
    EXPECT_EQ(intents.size(), 1);
}

TEST_F(Homing, ShowsItsCourseAndCancelNeverWaits) {
    show();
    click(u"homeButton"_s);
    report(ProcedureStage::Searching);
    EXPECT_TRUE(text(u"homingStagesLabel"_s).startsWith(u"▶\u00A0Searching"_s));
    EXPECT_EQ(text(u"homingResultLabel"_s), u"Searching"_s);
    EXPECT_FALSE(button(u"onLimit2Box"_s)->isEnabled());
    for (const QString& locked : {u"homingVelocityField"_s, u"homingTimeField"_s}) {
        EXPECT_FALSE(field(locked)->isEnabled());
        EXPECT_EQ(field(locked)->toolTip(), u"A search for home is running."_s) << locked.toStdString();
    }
    EXPECT_FALSE(button(u"armLimitStopButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"homeButton"_s)->isEnabled());
    click(u"cancelHomingButton"_s);
    ASSERT_EQ(intents.size(), 2) << "although the module has not answered since the first click";
    EXPECT_TRUE(std::holds_alternative<intent::CancelProcedure>(intents.at(1).at(1).value<Intent>()));
    report(ProcedureStage::GoingHome, {}, 512);
    EXPECT_TRUE(text(u"homingStagesLabel"_s).contains(u"✓\u00A0Verifying"_s));
    EXPECT_TRUE(text(u"homingStagesLabel"_s).contains(u"▶\u00A0Going"_s));
    report(ProcedureStage::Done, {}, 512);
    EXPECT_EQ(text(u"homingResultLabel"_s), u"Done: home was at 512 counts."_s);
    EXPECT_FALSE(button(u"cancelHomingButton"_s)->isEnabled());
    report(ProcedureStage::Failed, ProcedureFailure::LinkSuspect);
    EXPECT_TRUE(
        text(u"homingResultLabel"_s).contains(texts::procedureFailure(ProcedureFailure::LinkSuspect)));
    EXPECT_FALSE(text(u"homingResultLabel"_s).contains(u"Done"_s));
}

TEST_F(Homing, WhatIsSetForTheNextSearchWasNotDoneByTheLast) {
    show();
    report(ProcedureStage::Searching);
    report(ProcedureStage::Done, {}, 512);
    const QString course = text(u"homingStagesLabel"_s);
    EXPECT_TRUE(course.startsWith(u"✓\u00A0Searching"_s)) << course.toStdString();
    click(u"thenIndexBox"_s);
    EXPECT_EQ(text(u"homingStagesLabel"_s), course);
    report(ProcedureStage::Searching);
    EXPECT_EQ(text(u"homingStagesLabel"_s).count(u'▶'), 1);
    EXPECT_EQ(text(u"homingStagesLabel"_s).count(u"Searching"_s), 2) << "for the index, too";
}

TEST_F(Homing, ReadsOutWhatTheSearchSays) {
    show();
    click(u"homeButton"_s);
    report(ProcedureStage::Searching);
    const auto spoken = [this](const QString& label) {
        return QAccessible::queryAccessibleInterface(find<QLabel>(label))->text(QAccessible::Name);
    };
    EXPECT_EQ(spoken(u"homingResultLabel"_s), u"Searching"_s);
    EXPECT_TRUE(spoken(u"homingStagesLabel"_s).contains(u"Searching"_s));
    EXPECT_EQ(spoken(u"limitStopState"_s), text(u"limitStopState"_s));
}

TEST_F(Homing, EachModuleHasItsOwn) {
    showServos({{.index = 0}, {.index = 1}});
    open();
    click(u"onIndexBox"_s);
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setCurrentIndex(list->model()->index(1, 0));
    EXPECT_FALSE(button(u"onIndexBox"_s)->isChecked());
    list->setCurrentIndex(list->model()->index(0, 0));
    EXPECT_TRUE(button(u"onIndexBox"_s)->isChecked());
}

// ---- the limit stop ----

TEST_F(Homing, TheLimitStopIsArmedAsChosen) {
    show();
    EXPECT_TRUE(text(u"limitStopState"_s).startsWith(u"○ Not armed"_s));
    EXPECT_FALSE(button(u"disarmLimitStopButton"_s)->isEnabled());
    click(u"armLimit1Box"_s);
    click(u"armSmoothlyButton"_s);
    click(u"armLimitStopButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto arm = std::get<intent::ArmLimitStop>(intents.at(0).at(1).value<Intent>());
    EXPECT_FALSE(arm.onLimit1);
    EXPECT_TRUE(arm.onLimit2);
    EXPECT_EQ(arm.manner, HomingRecipe::Stop::Smoothly);
}

TEST_F(Homing, TheLimitStopShowsItsState) {
    const auto armed = [](ModuleState& module) {
        servo::SetHoming homing;
        homing.onLimit2Change = homing.stopAbruptly = true;
        module.apply(bus::CommandExecuted{module.info.index, module.latestTime, ServoCommand(homing)});
        bus::Sample sample{module.info.index, module.latestTime + std::chrono::milliseconds(5),
                           *module.latest};
        sample.report.status |= 0x80U;
        module.apply(sample);
    };
    showChanged({}, armed);
    EXPECT_EQ(text(u"limitStopState"_s), u"● Armed: stops at limit 2, once."_s);
    EXPECT_TRUE(button(u"disarmLimitStopButton"_s)->isEnabled());
    showChanged({}, [&](ModuleState& module) {
        armed(module);
        bus::Sample sample{module.info.index, module.latestTime + std::chrono::milliseconds(5),
                           *module.latest};
        sample.report.status = static_cast<std::uint8_t>(sample.report.status & 0x7FU);
        module.apply(sample);
    });
    EXPECT_TRUE(text(u"limitStopState"_s).startsWith(u"▲ Tripped by limit 2;"_s));
    showChanged({}, [](ModuleState& module) { module.latest->status |= 0x80U; });
    EXPECT_TRUE(text(u"limitStopState"_s).startsWith(u"?"_s)) << "this panel has not requested it";
}

TEST_F(Homing, ALimitThatIsActiveIsNotArmed) {
    showChanged({}, [](ModuleState& module) { module.latest->status |= 0x20U; });
    EXPECT_EQ(reason(u"armLimitStopButton"_s), texts::refusal(Refusal::LimitActive));
    click(u"armLimit1Box"_s);
    EXPECT_TRUE(button(u"armLimitStopButton"_s)->isEnabled());
    click(u"armLimit2Box"_s);
    EXPECT_FALSE(button(u"armLimitStopButton"_s)->isEnabled()) << "none is selected";
}

// ---- homing of a stepper ----

TEST(StepperHoming, HasTheChipsOwnConditionsAndNamesOfItsOwn) {
    ModuleState module;
    module.info = {ModuleIndex(0), BusAddress(1), {ModuleType::Stepper, 1}};
    bus::Sample sample{module.info.index, TimePoint(std::chrono::seconds(1)), {}};
    sample.report.items = StatusItems(StatusItems::Position | StatusItems::Inputs);
    sample.report.status = 0x0C;  // power, amplifier
    sample.report.position = 0;
    sample.report.aux = std::uint8_t{0};
    module.apply(sample);
    const ModuleState anyUnsent = module;
    stepper::SetParameters parameters;
    parameters.speedMode = stepper::SpeedMode::X2;
    module.apply(bus::CommandExecuted{module.info.index, sample.time, StepperCommand(parameters)});
    const AxisSettings settings;
    PanelView view{module, settings};
    view.connected = true;
    Requests requests;
    ModuleContext context(view, requests);
    HomingBox box(context, nullptr);
    box.show();
    QSignalSpy intents(&requests, &Requests::intent);
    auto* home = box.findChild<QAbstractButton*>(u"stepperHomeButton"_s);
    ASSERT_NE(home, nullptr);
    EXPECT_TRUE(home->isEnabled()) << home->toolTip().toStdString();
    EXPECT_NE(box.findChild<QAbstractButton*>(u"stepperOnHomeSwitchBox"_s), nullptr);
    EXPECT_EQ(box.findChild<QAbstractButton*>(u"stepperOnIndexBox"_s), nullptr);
    EXPECT_EQ(box.findChild<QWidget*>(u"limitStopBox"_s), nullptr);
    auto* velocity = box.findChild<NumberField*>(u"stepperHomingVelocityField"_s);
    auto* acceleration = box.findChild<NumberField*>(u"stepperHomingAccelerationField"_s);
    const auto type = [](NumberField* field, const QString& words) {
        field->selectAll();
        QTest::keyClicks(field, words);
    };
    type(velocity, u"49"_s);
    EXPECT_FALSE(home->isEnabled()) << "speed 1 of mode 2x is 50 steps/s, which would be faster";
    type(velocity, u"50"_s);
    type(acceleration, u"800001"_s);
    EXPECT_FALSE(home->isEnabled()) << "at most one unit of 200 steps/s every 0.25 ms (DS-S 4.2)";
    type(acceleration, u"800000"_s);
    QTest::mouseClick(home, Qt::LeftButton);
    ASSERT_EQ(intents.size(), 1);
    const auto recipe = std::get<intent::Home>(intents.at(0).at(1).value<Intent>()).recipe;
    EXPECT_TRUE(recipe.onHomeSwitch);
    EXPECT_EQ(recipe.velocity, 50.0);
    EXPECT_EQ(recipe.acceleration, 800'000.0);
    PanelView other{anyUnsent, settings};
    other.connected = true;
    context.show(other);
    EXPECT_EQ(home->toolTip(), texts::refusal(Refusal::ParametersUnknown));
    AxisSettings reversed;
    reversed.unit = {UnitKind::Millimetres, -100.0, {}};
    PanelView turned{module, reversed};
    turned.connected = true;
    context.show(turned);
    auto* limit = box.findChild<QAbstractButton*>(u"stepperOnLimit1Box"_s);
    ASSERT_NE(limit, nullptr);
    EXPECT_EQ(limit->text(), u"Limit 1 (reverse)"_s);
    EXPECT_EQ(limit->accessibleName(), limit->text());
}

// ---- words ----

TEST(ProcedureTexts, EachFailureSaysWhatItMeansForTheMotor) {
    constexpr std::array kFailures{ProcedureFailure::SwitchActive,   ProcedureFailure::NotFound,
                                   ProcedureFailure::TravelLimit,    ProcedureFailure::TimeLimit,
                                   ProcedureFailure::LinkSuspect,    ProcedureFailure::ModuleUnresponsive,
                                   ProcedureFailure::WentOff,        ProcedureFailure::Refused,
                                   ProcedureFailure::ReadingsDiffer, ProcedureFailure::NotAtHome};
    QSet<QString> headlines;
    for (const ProcedureFailure failure : kFailures) {
        ProcedureReport report;
        report.module = ModuleIndex(2);
        report.stage = ProcedureStage::Failed;
        report.failure = failure;
        report.offHome = 4;
        const auto message = texts::procedureEnded(report, AxisScale::servo({}, 1));
        ASSERT_TRUE(message);
        EXPECT_NE(message->severity, Severity::Normal);
        EXPECT_TRUE(message->headline.startsWith(u"Module 3 "_s)) << message->headline.toStdString();
        EXPECT_TRUE(
            message->headline.contains(QRegularExpression(u"stop|at rest|unknown|free to turn|holds"_s)))
            << message->headline.toStdString();
        EXPECT_FALSE(message->body.isEmpty());
        EXPECT_FALSE(texts::procedureFailure(failure).isEmpty());
        headlines.insert(message->headline);
    }
    EXPECT_EQ(headlines.size(), static_cast<qsizetype>(kFailures.size()));
}

TEST(ProcedureTexts, AZeroThatIsRefusedNamesTheBoxesToChange) {
    ProcedureReport report;
    report.stage = ProcedureStage::Failed;
    report.failure = ProcedureFailure::NotAtHome;
    report.offHome = -4;
    const auto message = texts::procedureEnded(report, AxisScale::servo({}, 1));
    ASSERT_TRUE(message);
    EXPECT_TRUE(message->body.startsWith(u"Friction holds it 4 counts off home"_s))
        << message->body.toStdString();
    EXPECT_TRUE(message->body.contains(u"Ki and IL on the Gains page"_s));
    EXPECT_TRUE(message->body.contains(u"\"Set position to 0\" on the Homing page"_s));
    report.stage = ProcedureStage::Done;
    report.failure.reset();
    report.home = -1'000;
    EXPECT_EQ(texts::procedureEnded(report, AxisScale::servo({}, 1))->body,
              u"It is at rest 4 counts from home; its position there is 0."_s);
}

TEST(ProcedureTexts, EachRefusalHasASentenceOfItsOwn) {
    QSet<QString> sentences;
    constexpr std::array kRefusals{Refusal::NothingToFind, Refusal::NoSearchLimits,    Refusal::LimitActive,
                                   Refusal::LimitIsOutput, Refusal::ParametersUnknown, Refusal::StepTooShort};
    for (const Refusal refusal : kRefusals)
        sentences.insert(texts::refusal(refusal));
    EXPECT_EQ(sentences.size(), static_cast<qsizetype>(kRefusals.size()));
    EXPECT_FALSE(sentences.contains(QString()));
}

TEST(ProcedureTexts, AnEndThatWasAskedForIsNoNews) {
    ProcedureReport report;
    report.stage = ProcedureStage::Cancelled;
    EXPECT_FALSE(texts::procedureEnded(report, AxisScale::servo({}, 1)));
    report.kind = ProcedureKind::MoveBy;
    report.stage = ProcedureStage::Done;
    EXPECT_FALSE(texts::procedureEnded(report, AxisScale::servo({}, 1)));
    report.kind = ProcedureKind::Homing;
    report.home = -2'500;
    const auto message = texts::procedureEnded(report, AxisScale::servo({UnitKind::Turns, 1'000.0, {}}, 1));
    ASSERT_TRUE(message);
    EXPECT_TRUE(message->headline.contains(u"−2.5 turns"_s)) << message->headline.toStdString();
}

}  // namespace
}  // namespace nmc
