// SPDX-License-Identifier: GPL-3.0-or-later
// The box for repeatability and backlash: what it asks for, shows and offers.
#include "model/intent/homingplan.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

class RepeatabilityPage : public WindowTest {
protected:
    void show(const Servo& servo = {}) {
        showServo(servo);
        find(u"repeatabilityBox"_s);
    }
    /// Three captures per direction, 30 counts apart but for the half counts.
    void report(ProcedureStage stage, EdgeCaptures edges = captures(),
                std::optional<ProcedureFailure> failure = {}) {
        ProcedureReport r;
        r.kind = ProcedureKind::Repeatability;
        r.stage = stage;
        r.failure = failure;
        r.round = 2;
        r.rounds = 3;
        r.edges = std::move(edges);
        window->showProcedure(r);
    }
    static EdgeCaptures captures() {
        EdgeCaptures edges;
        edges.forward = {1'031, 1'032, 1'030};
        edges.reverse = {1'000, 1'000, 1'000};
        edges.perReading = 0.5;
        return edges;
    }
    QString result() { return text(u"repeatabilityResult"_s); }
    QString reason(const QString& control) {
        EXPECT_FALSE(button(control)->isEnabled()) << control.toStdString();
        return button(control)->toolTip();
    }
    intent::MeasureRepeatability asked() {
        EXPECT_EQ(intents.size(), 1);
        return std::get<intent::MeasureRepeatability>(intents.takeLast().at(1).value<Intent>());
    }

    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(RepeatabilityPage, AsksForOneInputWithTheSearchSettingsOfTheAxis) {
    show();
    EXPECT_TRUE(result().contains(u"Not measured"_s));
    type(u"homingTravelField"_s, u"1200"_s);
    type(u"homingAccelerationField"_s, u"0.03"_s);
    type(u"homingTimeField"_s, u"7"_s);
    click(u"homingForwardButton"_s);
    click(u"onLimit2Box"_s);  // for home, not for this
    pick(u"repeatabilityInputBox"_s, u"Index"_s);
    type(u"repeatabilityVelocityField"_s, u"0.25"_s);
    type(u"repeatabilityTimesField"_s, u"20"_s);
    click(u"measureRepeatabilityButton"_s);
    const auto index = asked();
    HomingRecipe expected;
    expected.onIndex = true;
    expected.reverse = false;
    expected.velocity = 0.25;
    expected.acceleration = 0.03;
    expected.travelLimit = 1'200;
    expected.timeLimit = 7;
    EXPECT_EQ(index.recipe, expected);
    EXPECT_EQ(index.times, 20U);
    show({.millisecond = 20});
    pick(u"repeatabilityInputBox"_s, u"Limit 2"_s);
    click(u"measureRepeatabilityButton"_s);
    EXPECT_TRUE(asked().recipe.onLimit2);
}

TEST_F(RepeatabilityPage, SaysWhyItIsNotPossible) {
    const QString measure = u"measureRepeatabilityButton"_s;
    show({.on = false});
    EXPECT_EQ(reason(measure), texts::refusal(Refusal::ServoOff));
    show({.moveDone = false, .millisecond = 10});
    EXPECT_EQ(reason(measure), texts::refusal(Refusal::Moving));
    show({.millisecond = 20});
    for (const QString& times : {u"1"_s, u"101"_s, u"x"_s, u""_s}) {
        type(u"repeatabilityTimesField"_s, times);
        EXPECT_EQ(reason(measure), field(u"repeatabilityTimesField"_s)->problemText());
    }
    type(u"repeatabilityTimesField"_s, u"2"_s);
    type(u"repeatabilityVelocityField"_s, u"0"_s);
    EXPECT_EQ(reason(measure), field(u"repeatabilityVelocityField"_s)->problemText());
    type(u"repeatabilityVelocityField"_s, u"2"_s);
    EXPECT_TRUE(button(measure)->isEnabled());
    machine.axes.resize(1);
    machine.axes[0].travel.fastest = 1.0;
    window->showMachine(machine);
    EXPECT_TRUE(reason(measure).contains(u"highest velocity"_s)) << reason(measure).toStdString();
    EXPECT_EQ(reason(u"useBacklashButton"_s), u"Measure first."_s);
    EXPECT_FALSE(button(u"endRepeatabilityButton"_s)->isEnabled());
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(RepeatabilityPage, ShowsSpreadAndBacklashAndOffersIt) {
    QSignalSpy edits{&window->requests(), &Requests::axisEdited};
    show();
    report(ProcedureStage::Searching);
    EXPECT_TRUE(result().startsWith(u"▶ Searching, 2 of 3"_s)) << result().toStdString();
    report(ProcedureStage::Reading);
    EXPECT_TRUE(result().startsWith(u"▶ Reading the captured position, 2 of 3"_s)) << result().toStdString();
    EXPECT_FALSE(button(u"measureRepeatabilityButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"useBacklashButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"armLimitStopButton"_s)->isEnabled()) << "the chip has one watch";
    click(u"endRepeatabilityButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::CancelProcedure>(intents.at(0).at(1).value<Intent>()));
    report(ProcedureStage::Done);
    const QStringList lines = result().split(u'\n');
    ASSERT_EQ(lines.size(), 5) << result().toStdString();
    EXPECT_EQ(lines[0], u"✓ Done"_s);
    EXPECT_EQ(
        lines[1],
        u"Forward, 3 times: mean 1\u202F030.75 counts, standard deviation 1.0 counts, range 2.0 counts"_s);
    EXPECT_TRUE(lines[2].startsWith(u"Reverse, 3 times: mean"_s)) << lines[2].toStdString();
    // 31 - 0.5, and 1 + 0.5 + 2.776 / sqrt(3)
    EXPECT_EQ(lines[3], u"Backlash: 30.5 counts ± 3.1 counts"_s);
    EXPECT_TRUE(lines[4].contains(u"hysteresis of the switch"_s)) << lines[4].toStdString();
    click(u"useBacklashButton"_s);
    ASSERT_EQ(edits.size(), 1);
    EXPECT_EQ(edits.at(0).at(1).value<AxisSettings>().backlash.distance, 34);
    EXPECT_EQ(reason(u"useBacklashButton"_s), u"The axis has this backlash."_s);
}

TEST_F(RepeatabilityPage, ShowsTheUnitOfTheAxisWithCounts) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, -400.0, {}};
    window->showMachine(machine);
    show();
    report(ProcedureStage::Done);
    const QStringList lines = result().split(u'\n');
    EXPECT_TRUE(lines[1].startsWith(u"Reverse, 3 times: mean −2.5"_s))
        << "on a reversed axis, the chip's forward is the user's reverse: " << lines[1].toStdString();
    EXPECT_TRUE(lines[1].contains(u"range 0.0050 mm (2.0 counts)"_s)) << lines[1].toStdString();
    EXPECT_TRUE(lines[3].startsWith(u"Backlash: 0.076"_s)) << lines[3].toStdString();
    EXPECT_TRUE(lines[3].contains(u" mm (30.5 counts) ± "_s)) << lines[3].toStdString();
}

TEST_F(RepeatabilityPage, SaysWhatADifferenceDoesNotShow) {
    show();
    EdgeCaptures edges = captures();
    edges.index = true;
    report(ProcedureStage::Done, edges);
    EXPECT_TRUE(result().contains(u"Difference: 30.5"_s)) << result().toStdString();
    EXPECT_TRUE(result().contains(u"not the backlash of the load"_s)) << result().toStdString();
    EXPECT_TRUE(reason(u"useBacklashButton"_s).contains(u"index"_s));
    edges = captures();
    std::swap(edges.forward, edges.reverse);
    report(ProcedureStage::Done, edges);
    EXPECT_TRUE(result().contains(u"not backlash"_s)) << result().toStdString();
    EXPECT_TRUE(reason(u"useBacklashButton"_s).contains(u"exceeds its uncertainty"_s));
    edges = captures();
    edges.perReading = 40;
    report(ProcedureStage::Done, edges);
    EXPECT_TRUE(result().contains(u"moves up to 40.0 counts between two readings"_s))
        << result().toStdString();
    EXPECT_FALSE(button(u"useBacklashButton"_s)->isEnabled());
}

TEST_F(RepeatabilityPage, SaysHowItEndedAndKeepsWhatWasCaptured) {
    show();
    report(ProcedureStage::Failed, captures(), ProcedureFailure::TravelLimit);
    EXPECT_TRUE(result().startsWith(u"▲ The switch or index did not change"_s)) << result().toStdString();
    EXPECT_TRUE(result().contains(u"Backlash: 30.5"_s)) << result().toStdString();
    report(ProcedureStage::Cancelled, {});
    EXPECT_EQ(result(), u"○ Cancelled"_s);
    EXPECT_TRUE(button(u"measureRepeatabilityButton"_s)->isEnabled());
    QSet<QString> bodies;
    for (const auto failure :
         {ProcedureFailure::TravelLimit, ProcedureFailure::SoftLimit, ProcedureFailure::NotFound,
          ProcedureFailure::Bounced, ProcedureFailure::LinkSuspect, ProcedureFailure::WentOff,
          ProcedureFailure::Refused, ProcedureFailure::ReadingsDiffer,
          ProcedureFailure::ModuleUnresponsive}) {
        ProcedureReport ended;
        ended.kind = ProcedureKind::Repeatability;
        ended.stage = ProcedureStage::Failed;
        ended.failure = failure;
        const auto message = texts::procedureEnded(ended, AxisScale::servo({}, 1));
        ASSERT_TRUE(message);
        EXPECT_EQ(message->headline, u"Module 1 did not finish its approaches."_s);
        EXPECT_TRUE(message->body.contains(
            QRegularExpression(u"stopped|at rest|commanded to stop|free to turn|unknown"_s)))
            << message->body.toStdString();
        bodies.insert(message->body);
    }
    EXPECT_EQ(bodies.size(), 9);
}

TEST_F(RepeatabilityPage, AStepperIsApproachedAtItsHomeSwitch) {
    ModuleState module;
    module.info.identity = {ModuleType::Stepper, 1};
    module.info.address = BusAddress(1);
    bus::Sample sample;
    sample.report.status = 0;
    sample.report.position = 0;
    sample.report.aux = std::uint8_t(0);
    sample.report.analog = std::uint8_t(200);
    module.apply(sample);
    window->showLink(connectedTo({module}));
    EXPECT_EQ(find<QComboBox>(u"stepperRepeatabilityInputBox"_s)->currentText(), u"Home switch"_s);
    EXPECT_EQ(find<QComboBox>(u"stepperRepeatabilityInputBox"_s)->findText(u"Index"_s), -1);
    EXPECT_FALSE(button(u"stepperMeasureRepeatabilityButton"_s)->isEnabled());
}

}  // namespace
}  // namespace nmc
