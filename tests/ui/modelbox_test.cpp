// SPDX-License-Identifier: GPL-3.0-or-later
// The Model page: what it requests, what it shows of the answers, and which answers no longer count.
#include "responserecords.h"
#include "widgets/common/requests.h"
#include "widgets/response/responsedock.h"

namespace nmc {
namespace {

class ModelPage : public WindowTest {
protected:
    ModelPage() {
        window->resize(1500, 1100);
        Servo servo;
        servo.held = true;
        showServos({servo, Servo{.index = 1}});
        window->findChild<QAction*>(u"tuneLayoutAction"_s)->trigger();
        settle();
    }
    static void settle() {
        for (int i = 0; i < 3; ++i)
            QCoreApplication::processEvents();
    }
    ResponseDock& dock() { return window->stepResponses(); }
    ModelBox& model() { return dock().page().model(); }
    [[nodiscard]] static Identified motor() {
        Identified found;
        found.motor.gain = {788, 8};
        found.motor.timeConstant = {0.0129, 0.0002};
        found.motor.friction = {1.2, 0.3};
        found.motor.load = {0, 1};
        found.runs.push_back({{0.0, 500.0}, {0.01, 590.0}, {0.02, 600.0}});
        return found;
    }
    [[nodiscard]] Suggestion answerTo(const SuggestionTask& task) {
        Suggestion suggestion{task.id, someGains(), {}};
        suggestion.gains->kp = 321;
        suggestion.prediction = predict(task.motor, *suggestion.gains, 500, 600, 0.1, 2.0);
        return suggestion;
    }
    [[nodiscard]] SuggestionTask task() {
        EXPECT_FALSE(tasks.isEmpty());
        return tasks.isEmpty() ? SuggestionTask{} : tasks.last().at(0).value<SuggestionTask>();
    }
    void find() {
        window->stepResponses().showRun(ramp());
        click(u"identifyButton"_s);
        model().showMotor(ModuleIndex(0), motor());
    }
    /// The counts of the steps that were requested last.
    [[nodiscard]] std::vector<std::int32_t> steppedBy() {
        const Intent intent = intents.isEmpty() ? Intent{} : intents.last().at(1).value<Intent>();
        const auto* series = std::get_if<intent::StepSeries>(&intent);
        return series != nullptr ? series->counts : std::vector<std::int32_t>{};
    }
    void showStepBy(int counts) {
        KeptResponse run = ramp(counts);
        run.run.taken.goal = run.run.taken.from + counts;
        window->stepResponses().showRun(run);
    }
    /// A motor whose gain is known to 21 %.
    [[nodiscard]] static Identified uncertain() {
        Identified found = motor();
        found.motor.gain.doubt = 165;
        return found;
    }
    void findUncertain() {
        click(u"identifyButton"_s);
        model().showMotor(ModuleIndex(0), uncertain());
    }
    using WindowTest::find;
    QSignalSpy wanted{&window->requests(), &Requests::identify};
    QSignalSpy tasks{&window->requests(), &Requests::suggest};
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(ModelPage, LooksIntoTheLastFiveRunsOfTheSelectedModule) {
    EXPECT_FALSE(button(u"identifyButton"_s)->isEnabled());
    window->stepResponses().showRun(ramp(100, 1));
    EXPECT_FALSE(button(u"identifyButton"_s)->isEnabled()) << "the run is of another module";
    for (int i = 0; i < 7; ++i)
        window->stepResponses().showRun(ramp(100 + i));
    click(u"identifyButton"_s);
    ASSERT_EQ(wanted.size(), 1);
    const auto runs = wanted.at(0).at(1).value<std::vector<ResponseRecord>>();
    ASSERT_EQ(runs.size(), 5U);
    EXPECT_EQ(runs.front().points.back().position, 602);
    EXPECT_EQ(runs.back().points.back().position, 606);
    EXPECT_FALSE(button(u"identifyButton"_s)->isEnabled()) << "the search is in progress";
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(ModelPage, ShowsTheMotorAndFillsInWhatIsSuggested) {
    find();
    EXPECT_TRUE(text(u"motorModel"_s).startsWith(u"Gain 788 ± 8 counts/s per PWM count"_s))
        << text(u"motorModel"_s).toStdString();
    EXPECT_TRUE(text(u"motorModel"_s).contains(u"Time constant 12.9 ± 0.2 ms"_s));
    EXPECT_FALSE(button(u"fillSuggestedButton"_s)->isEnabled());
    model().showSuggestion(answerTo(task()));
    EXPECT_TRUE(text(u"suggestedGains"_s).startsWith(u"Kp 321"_s));
    click(u"fillSuggestedButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 321);
    EXPECT_EQ(intents.size(), 0) << "nothing is sent";
}

/// A deadband and play are shown if there are any; about a resonance, it shows what these steps cannot tell.
TEST_F(ModelPage, SaysWhatIsBetweenTheChipAndTheLoad) {
    find();
    EXPECT_FALSE(text(u"motorModel"_s).contains(u"deadband"_s));
    EXPECT_FALSE(text(u"motorModel"_s).contains(u"Play"_s));
    Identified found = motor();
    found.motor.deadband = {8, 0.3};
    found.motor.play = {3, 0.4};
    found.motor.rigidUpTo = 79.3;
    click(u"identifyButton"_s);
    model().showMotor(ModuleIndex(0), found);
    for (const auto& part : {u"Amplifier deadband 8.0 ± 0.3 of 255 PWM"_s, u"Play 3.0 ± 0.4 counts"_s,
                             u"A resonance above 79 Hz would not show"_s})
        EXPECT_TRUE(text(u"motorModel"_s).contains(part)) << text(u"motorModel"_s).toStdString();
}

TEST_F(ModelPage, SaysHowSureAPredictionIs) {
    find();
    SuggestionTask asked = task();
    asked.motor.friction = {11, 9};
    Suggestion answer = answerTo(asked);
    answer.prediction->overshoot = {4.3, 2.0};
    answer.prediction->settling = {7.9e-3, 3e-3};
    answer.prediction->unsettled = 0.2;
    answer.prediction->errorAtRest = {0, 4};
    answer.prediction->phaseMargin = {46, 9};
    answer.prediction->gainMargin = Measured{3.2, 0.6};
    model().showSuggestion(answer);
    const QString words = text(u"suggestedGains"_s);
    for (const auto& part : {u"Overshoot 4 ± 2 %, settling 8 ± 3 ms"_s, u"Steady-state error 0 ± 4 counts"_s,
                             u"In 20 of 100 cases"_s, u"Phase margin 46 ± 9°, gain margin 3.2 ± 0.6"_s})
        EXPECT_TRUE(words.contains(part)) << part.toStdString() << " in " << words.toStdString();
}

TEST_F(ModelPage, SaysThatItStepsFourTimesBeforeItDoes) {
    const QAbstractButton* steps = button(u"stepAndFindButton"_s);
    EXPECT_EQ(steps->text(), u"Step 4 times and find model"_s);
    EXPECT_TRUE(steps->accessibleName().startsWith(steps->text()));
    EXPECT_TRUE(steps->toolTip().contains(u"twice as far"_s));
    EXPECT_TRUE(steps->toolTip().contains(u"no farther than 1000 and 2000 counts"_s));
    EXPECT_EQ(intents.size(), 0);
    type(u"responseDistanceField"_s, u"150"_s);
    type(u"responseRecordField"_s, u"0.4"_s);
    click(u"stepAndFindButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(steppedBy(), (std::vector<std::int32_t>{150, -150, 300, -300}));
    EXPECT_EQ(std::get<intent::StepSeries>(intents.last().at(1).value<Intent>()).each.record, 0.4);
}

/// 910 + 91 + 4 is less than the error limit of 2000 counts, but 2 x 910 + 182 + 4 is more.
TEST_F(ModelPage, SaysWhyItCannotStepFourTimes) {
    Servo servo;
    servo.held = true;
    std::vector<ModuleState> modules{servo.state(), Servo{.index = 1}.state()};
    modules.front().gains->el = 2'000;
    window->showLink(connectedTo(modules));
    settle();
    type(u"responseDistanceField"_s, u"910"_s);
    EXPECT_TRUE(button(u"responseButton"_s)->isEnabled()) << "a single step is possible";
    EXPECT_FALSE(button(u"stepAndFindButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"stepAndFindButton"_s)->toolTip().contains(u"twice as far"_s));
    type(u"responseDistanceField"_s, u"900"_s);
    EXPECT_TRUE(button(u"stepAndFindButton"_s)->isEnabled()) << "1800 + 180 + 4";
}

/// Steps there and back by 100, then by 200: both directions, and two sizes. If the motor is still uncertain,
/// they continue in this order.
TEST_F(ModelPage, StepsOnceMoreWhereAllThatLeavesTheMotorUncertain) {
    for (const int made : {100, -100, 200})
        showStepBy(made);
    int made = -200;
    for (const int next : {100, -100, 200, -200}) {
        showStepBy(made);
        findUncertain();
        EXPECT_EQ(button(u"stepAndFindButton"_s)->text(), u"Step once more and find model"_s);
        click(u"stepAndFindButton"_s);
        EXPECT_EQ(steppedBy(), std::vector<std::int32_t>{next});
        made = next;
    }
    click(u"identifyButton"_s);
    model().showMotor(ModuleIndex(0), motor());
    EXPECT_EQ(button(u"stepAndFindButton"_s)->text(), u"Step 4 times and find model"_s)
        << "this motor is certain";
}

/// One step, or several equal ones, are not enough to continue from.
TEST_F(ModelPage, StepsFourTimesWhereTheStepsWereTooFewOrAlike) {
    for (int i = 0; i < 3; ++i) {
        showStepBy(100);
        findUncertain();
        EXPECT_EQ(button(u"stepAndFindButton"_s)->text(), u"Step 4 times and find model"_s);
    }
}

/// Suggested gains are careful until the motor is known.
TEST_F(ModelPage, IsCarefulWhereTheMotorIsUncertain) {
    for (const int made : {100, -100, 200, -200})
        showStepBy(made);
    findUncertain();
    EXPECT_TRUE(text(u"motorModel"_s).contains(u"Uncertain"_s));
    EXPECT_EQ(task().wish.phaseMargin, 60);
    click(u"identifyButton"_s);
    EXPECT_EQ(intents.size(), 0) << "a second click moves nothing";
    model().showMotor(ModuleIndex(0), motor());
    EXPECT_EQ(task().wish.phaseMargin, 45);
}

/// Two series may end at nearly the same time.
TEST_F(ModelPage, FindsTheMotorThatWasWantedWhileItLookedForAnother) {
    window->stepResponses().showRun(ramp());
    window->stepResponses().showRun(ramp(100, 1));
    model().find(ModuleIndex(0));
    model().find(ModuleIndex(1));
    ASSERT_EQ(wanted.size(), 1);
    model().showMotor(ModuleIndex(0), motor());
    ASSERT_EQ(wanted.size(), 2);
    EXPECT_TRUE(wanted.at(1).at(0).value<ModuleIndex>() == ModuleIndex(1));
    model().showMotor(ModuleIndex(1), motor());
    EXPECT_EQ(wanted.size(), 2);
    EXPECT_FALSE(model().motorWords(ModuleIndex(1)).isEmpty());
}

TEST_F(ModelPage, SuggestsWithThePhaseMarginThatIsChosen) {
    find();
    EXPECT_EQ(task().wish.phaseMargin, 45);
    type(u"phaseMarginField"_s, u"55"_s);
    EXPECT_EQ(task().wish.phaseMargin, 55);
}

TEST_F(ModelPage, OnlyTheAnswerToTheLatestQuestionCounts) {
    find();
    const SuggestionTask first = task();
    auto* slider = find<QSlider>(u"stiffnessSlider"_s);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageDown);
    ASSERT_NE(task().id, first.id);
    EXPECT_LT(task().wish.stiffness, first.wish.stiffness);
    model().showSuggestion(answerTo(first));
    EXPECT_EQ(text(u"suggestedGains"_s), u"Calculating the suggested gains…"_s);
    EXPECT_EQ(button(u"fillSuggestedButton"_s)->toolTip(), u"The suggested gains are being calculated."_s);
    model().showSuggestion(answerTo(task()));
    EXPECT_TRUE(text(u"suggestedGains"_s).startsWith(u"Kp 321"_s));
    Suggestion none;
    QTest::keyClick(slider, Qt::Key_PageDown);
    none.id = task().id;
    model().showSuggestion(none);
    EXPECT_TRUE(text(u"suggestedGains"_s).startsWith(u"No gains keep"_s));
    EXPECT_FALSE(button(u"fillSuggestedButton"_s)->isEnabled());
}

TEST_F(ModelPage, EachFailureHasASentenceOfItsOwn) {
    QSet<QString> sentences;
    for (const auto failure :
         {IdentifyFailure::TooFewSamples, IdentifyFailure::DoesNotMove, IdentifyFailure::WrongWay,
          IdentifyFailure::Oscillates, IdentifyFailure::NotExplained, IdentifyFailure::Play,
          IdentifyFailure::Obstacle, IdentifyFailure::GainUnclear, IdentifyFailure::TimeConstantUnclear}) {
        window->stepResponses().showRun(ramp());
        click(u"identifyButton"_s);
        model().showMotor(ModuleIndex(0), tl::unexpected(failure));
        sentences << text(u"motorModel"_s);
    }
    EXPECT_EQ(sentences.size(), 9);
    EXPECT_FALSE(sentences.contains(QString()));
    EXPECT_TRUE(tasks.isEmpty());
}

/// They are in effect for some seconds only, and with less output than was requested.
TEST_F(ModelPage, GainsThatAreTriedSuggestNoOthers) {
    find();
    const auto asked = tasks.count();
    ProcedureReport report;
    report.kind = ProcedureKind::TryGains;
    report.stage = ProcedureStage::Trying;
    report.gains = someGains();
    window->showProcedure(report);
    Servo servo;
    servo.held = true;
    std::vector<ModuleState> modules{servo.state(), Servo{.index = 1}.state()};
    modules.front().gains->ol = 63;
    window->showLink(connectedTo(modules));
    settle();
    EXPECT_EQ(tasks.count(), asked);
    modules.front().gains = someGains();
    modules.front().gains->kp = 321;  // other gains have arrived in the meantime
    window->showLink(connectedTo(modules));
    settle();
    EXPECT_EQ(tasks.count(), asked);
    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    settle();
    EXPECT_EQ(tasks.count(), asked + 1);
    EXPECT_EQ(task().now.kp, 321);
}

/// Another module was looked at in the meantime.
TEST_F(ModelPage, WhileOthersAreTriedItSuggestsFromTheGainsFromBefore) {
    find();
    ProcedureReport report;
    report.kind = ProcedureKind::TryGains;
    report.stage = ProcedureStage::Trying;
    report.gains = someGains();
    window->showProcedure(report);
    std::vector<ModuleState> modules{Servo{.held = true}.state(), Servo{.index = 1}.state()};
    modules.front().gains->ol = 63;
    window->showLink(connectedTo(modules));
    settle();
    const auto asked = tasks.count();
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    for (const int module : {1, 0}) {
        chain->setCurrentIndex(chain->model()->index(module, 0));
        settle();
    }
    EXPECT_EQ(tasks.count(), asked + 1);
    EXPECT_EQ(task().now.ol, someGains().ol);
}

TEST_F(ModelPage, AMotorOfTheLastConnectionThatComesLateIsNotShown) {
    window->stepResponses().showRun(ramp());
    click(u"identifyButton"_s);
    window->showLink(LinkState{});
    showServo();
    settle();
    model().showMotor(ModuleIndex(0), motor());
    EXPECT_TRUE(text(u"motorModel"_s).isEmpty());
    window->stepResponses().showRun(ramp());
    EXPECT_TRUE(button(u"identifyButton"_s)->isEnabled()) << "it is not waited for any more";
}

/// The simulator, for example, and then a real motor at the same place in its chain.
TEST_F(ModelPage, TakesNoRunsOfAnEarlierConnection) {
    window->stepResponses().showRun(ramp(100));
    window->stepResponses().showRun(ramp(110));
    find<QTableWidget>(u"responseRunTable"_s)->setCurrentCell(0, 2);
    click(u"responseRemoveButton"_s);
    window->showLink(LinkState{});
    showServo();
    settle();
    click(u"responsePutBackButton"_s);
    EXPECT_EQ(window->stepResponses().runs().size(), 2U);
    EXPECT_FALSE(button(u"identifyButton"_s)->isEnabled());
    window->stepResponses().showRun(ramp(120));
    click(u"identifyButton"_s);
    ASSERT_EQ(wanted.size(), 1);
    const auto runs = wanted.at(0).at(1).value<std::vector<ResponseRecord>>();
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs.front().points.back().position, 620);
}

/// The file may be read late. The runs in it come first, so that the numbers of the others change.
TEST_F(ModelPage, StaysWithItsRunWhenStoredOnesAreListedBeforeIt) {
    find();
    KeptResponse stored = ramp();
    stored.number = 1;
    stored.run.taken.goal = 550;
    dock().showKept({stored});
    EXPECT_EQ(task().taken.goal, 600);
}

/// The first run of the machine that is opened then has the number of the run from which the model was found.
TEST_F(ModelPage, IsForgottenWithTheRunsOfItsMachine) {
    find();
    const auto asked = tasks.size();
    dock().clearRuns();
    EXPECT_TRUE(text(u"motorModel"_s).isEmpty());
    KeptResponse other = ramp(120, 1);
    other.number = 1;
    other.earlier = true;
    dock().showKept({other});
    EXPECT_EQ(tasks.size(), asked) << "nothing is suggested from it";
}

TEST_F(ModelPage, IsOfOneModuleAndOneConnection) {
    find();
    EXPECT_FALSE(text(u"motorModel"_s).isEmpty());
    window->showLink(LinkState{});
    showServo();
    settle();
    EXPECT_TRUE(text(u"motorModel"_s).isEmpty());
}

}  // namespace
}  // namespace nmc
