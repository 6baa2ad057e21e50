// SPDX-License-Identifier: GPL-3.0-or-later
// The box of the direction check: what it asks, sends and shows.
#include "widgets/common/texts.h"
#include "windowtest.h"

namespace nmc {
namespace {

using Verdict = DirectionVerdict;

class DirectionBox : public WindowTest {
protected:
    void show(const Servo& servo = {.on = false, .gains = false}) {
        showServo(servo);
        find(u"axisBox"_s);
    }
    void report(ProcedureStage stage, std::optional<DirectionFound> found = {}, unsigned round = 1) {
        ProcedureReport r;
        r.kind = ProcedureKind::DirectionCheck;
        r.stage = stage;
        r.round = round;
        r.rounds = 2;
        r.direction = found;
        if (stage == ProcedureStage::Failed)
            r.failure = ProcedureFailure::TravelLimit;
        window->showProcedure(r);
    }
    QString state() { return text(u"directionCheckState"_s); }
    QString question() { return find(u"directionCheckDialog"_s)->findChild<QLabel*>(u"closeText"_s)->text(); }

    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(DirectionBox, AsksBeforeTheMotorIsPushed) {
    show();
    EXPECT_TRUE(state().contains(u"before you enable"_s)) << state().toStdString();
    const auto* label = find<QLabel>(u"directionCheckState"_s);
    EXPECT_GE(label->minimumHeight(), 4 * label->fontMetrics().lineSpacing()) << "beside the plots";
    click(u"directionCheckButton"_s);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_TRUE(question().contains(u"Module 1"_s)) << question().toStdString();
    EXPECT_TRUE(question().contains(u"25 %"_s)) << "64 of 255";
    EXPECT_TRUE(question().contains(u"10 counts"_s));
    EXPECT_TRUE(question().contains(u"250 counts"_s)) << "an eighth of 2 000";
    click(u"startDirectionCheckButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(std::get<intent::CheckDirection>(intents.at(0).at(1).value<Intent>()).reach, 250);
}

TEST_F(DirectionBox, NoIsNo) {
    show();
    click(u"directionCheckButton"_s);
    click(u"stayDirectionCheckButton"_s);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(DirectionBox, TheQuestionIsWithdrawnWhenTheServoComesOn) {
    show();
    click(u"directionCheckButton"_s);
    EXPECT_TRUE(find(u"directionCheckDialog"_s)->isVisible());
    showServo({.on = true, .millisecond = 10});
    EXPECT_TRUE(
        eventually([this] { return window->findChild<QWidget*>(u"directionCheckDialog"_s) == nullptr; }));
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(DirectionBox, SaysWhyItIsNotPossible) {
    const auto reason = [this] {
        EXPECT_FALSE(button(u"directionCheckButton"_s)->isEnabled());
        return button(u"directionCheckButton"_s)->toolTip();
    };
    show({.on = true});
    EXPECT_EQ(reason(), u"The servo is on. Switch the motor off first."_s);
    show({.on = false, .power = false, .millisecond = 10});
    EXPECT_TRUE(reason().contains(u"power"_s)) << reason().toStdString();
    window->showLink(LinkState{});
    EXPECT_EQ(window->findChild<QWidget*>(u"directionCheckButton"_s), nullptr);
}

TEST_F(DirectionBox, CanBeCancelledWhileItRuns) {
    show();
    EXPECT_FALSE(button(u"cancelDirectionCheckButton"_s)->isEnabled());
    report(ProcedureStage::Moving);
    EXPECT_EQ(state(), u"▶ Driving it forward."_s);
    EXPECT_FALSE(button(u"directionCheckButton"_s)->isEnabled());
    report(ProcedureStage::Moving, {}, 2);
    EXPECT_EQ(state(), u"▶ Driving it in reverse."_s);
    click(u"cancelDirectionCheckButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::CancelProcedure>(intents.at(0).at(1).value<Intent>()));
    report(ProcedureStage::Cancelled);
    EXPECT_TRUE(state().contains(u"Not checked"_s));
}

TEST_F(DirectionBox, SaysWhatWasFoundAndWhatToDo) {
    show();
    report(ProcedureStage::Done, DirectionFound{Verdict::Reversed, -20, 20, 12, false, false});
    EXPECT_TRUE(state().startsWith(u"▲ "_s));
    EXPECT_TRUE(state().contains(u"Swap the two motor leads, or encoder A and B"_s));
    report(ProcedureStage::Done, DirectionFound{Verdict::Right, 20, -20, 12, false, false});
    EXPECT_TRUE(state().startsWith(u"✓ "_s));
    report(ProcedureStage::Failed);
    EXPECT_TRUE(state().contains(u"Inconclusive"_s));
}

TEST_F(DirectionBox, AVerdictIsOfItsModuleAndItsConnection) {
    show();
    report(ProcedureStage::Done, DirectionFound{Verdict::Right, 20, -20, 12, false, false});
    ASSERT_TRUE(state().startsWith(u"✓ "_s));
    LinkState connecting;
    connecting.phase = LinkPhase::Connecting;
    window->showLink(connecting);
    show({.on = false, .gains = false, .millisecond = 10});
    EXPECT_FALSE(state().contains(u"OK"_s));
}

TEST(DirectionTexts, EachVerdictHasWordsOfItsOwn) {
    QSet<QString> headlines, sentences;
    constexpr std::array kVerdicts{Verdict::Right,       Verdict::Reversed, Verdict::NoMovement,
                                   Verdict::LimitClosed, Verdict::NoPower,  Verdict::Unclear};
    for (const Verdict verdict : kVerdicts) {
        ProcedureReport report;
        report.module = ModuleIndex(2);
        report.kind = ProcedureKind::DirectionCheck;
        report.stage = ProcedureStage::Done;
        report.direction = DirectionFound{verdict, 0, 0, 64, false, true};
        const auto message = texts::procedureEnded(report, AxisScale::servo({}, 1));
        ASSERT_TRUE(message);
        EXPECT_TRUE(message->headline.startsWith(u"Module 3"_s));
        EXPECT_EQ(message->severity, verdict == Verdict::Right ? Severity::Normal : Severity::Attention);
        EXPECT_EQ(message->body, texts::directionFound(*report.direction));
        headlines.insert(message->headline);
        sentences.insert(message->body);
    }
    EXPECT_EQ(headlines.size(), static_cast<qsizetype>(kVerdicts.size()));
    EXPECT_EQ(sentences.size(), static_cast<qsizetype>(kVerdicts.size()));
}

TEST(DirectionTexts, AJamMentionsTheLimitThatIsActiveAndTheStrongestPush) {
    DirectionFound found{Verdict::NoMovement, 0, 0, 64, false, false};
    EXPECT_TRUE(texts::directionFound(found).contains(u"25 %"_s));
    EXPECT_FALSE(texts::directionFound(found).contains(u"limit"_s));
    found.limit1 = true;
    EXPECT_TRUE(texts::directionFound(found).contains(u"A limit switch is active"_s));
    found = {Verdict::LimitClosed, 0, 0, 8, false, true};
    EXPECT_TRUE(texts::directionFound(found).startsWith(u"Limit switch 2"_s));
}

TEST(DirectionTexts, EachEndWithoutAVerdictSaysThatTheMotorIsOff) {
    QSet<QString> bodies;
    constexpr std::array kFailures{ProcedureFailure::TravelLimit, ProcedureFailure::NotStill,
                                   ProcedureFailure::LinkSuspect, ProcedureFailure::ModuleUnresponsive,
                                   ProcedureFailure::Refused};
    for (const ProcedureFailure failure : kFailures) {
        ProcedureReport report;
        report.kind = ProcedureKind::DirectionCheck;
        report.stage = ProcedureStage::Failed;
        report.failure = failure;
        const auto message = texts::procedureEnded(report, AxisScale::servo({}, 1));
        ASSERT_TRUE(message);
        const bool silent = failure == ProcedureFailure::ModuleUnresponsive;
        EXPECT_TRUE(message->headline.contains(silent ? u"unknown"_s : u"off"_s))
            << message->headline.toStdString();
        EXPECT_FALSE(message->body.isEmpty());
        bodies.insert(message->body);
    }
    EXPECT_EQ(bodies.size(), static_cast<qsizetype>(kFailures.size()));
}

}  // namespace
}  // namespace nmc
