// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about groups and about the chain's rate: what they mean for the motors comes first.
#include "widgets/common/texts.h"
#include "windowtest.h"

namespace nmc {
namespace {

using bus::MemberOutcome;
using GroupAction = bus::GroupCommand::Action;
using RateFailure = bus::RateChangeFailed::Reason;

bus::GroupFinished start(bus::Outcome outcome, std::vector<bus::GroupMember> members, bool stopped = false) {
    return {bus::OperationId(1), outcome, bus::GroupCommand{0x81, GroupAction::StartMotion},
            std::move(members), stopped};
}

TEST(ChainTexts, GroupStartedInPart) {
    const Message m = texts::groupFailed(start(bus::Outcome::NoAnswer,
                                               {{ModuleIndex(0), MemberOutcome::Done},
                                                {ModuleIndex(1), MemberOutcome::NotDone},
                                                {ModuleIndex(2), MemberOutcome::Done}},
                                               true));
    EXPECT_EQ(m.headline, u"2 of 3 modules of group 81 started. All of them were commanded to stop."_s);
    EXPECT_TRUE(m.body.startsWith(u"Carried out by: 1 and 3. Not carried out by: 2."_s))
        << m.body.toStdString();
    EXPECT_EQ(m.severity, Severity::Fault);
}

TEST(ChainTexts, GroupOfWhichNobodyStarted) {
    const Message m =
        texts::groupFailed(start(bus::Outcome::NoAnswer, {{ModuleIndex(0), MemberOutcome::NotDone},
                                                          {ModuleIndex(1), MemberOutcome::NotDone}}));
    EXPECT_EQ(m.headline, u"No module of group 81 started. Nothing was moved."_s);
}

TEST(ChainTexts, GroupStartThatCannotBeTold) {
    const Message m =
        texts::groupFailed(start(bus::Outcome::NoAnswer, {{ModuleIndex(0), MemberOutcome::Done},
                                                          {ModuleIndex(1), MemberOutcome::Unknown}}));
    EXPECT_EQ(m.headline, u"Not all modules of group 81 confirmed their start."_s);
}

TEST(ChainTexts, GroupStartWithheld) {
    const Message m =
        texts::groupFailed(start(bus::Outcome::Forbidden, {{ModuleIndex(2), MemberOutcome::Withheld}}));
    EXPECT_EQ(m.headline, u"Module 3 blocks the command to group 81. Nothing was sent."_s);
    EXPECT_EQ(m.severity, Severity::Attention);
    EXPECT_EQ(texts::groupFailed(start(bus::Outcome::Forbidden, {})).headline,
              u"Group 81 is empty. Nothing was sent."_s);
}

bus::GroupFinished command(GroupAction action, bus::Outcome outcome, std::vector<bus::GroupMember> members) {
    return {bus::OperationId(1), outcome, bus::GroupCommand{0x81, action}, std::move(members), false};
}

TEST(ChainTexts, GroupThatIsToldToStop) {
    const std::vector<bus::GroupMember> both{{ModuleIndex(0), MemberOutcome::Done},
                                             {ModuleIndex(2), MemberOutcome::Done}};
    EXPECT_EQ(
        texts::groupCommandedToStop(command(GroupAction::StopSmoothly, bus::Outcome::Done, both)).headline,
        u"Group 81 was commanded to stop: module 1 and 3."_s);
    EXPECT_EQ(texts::groupCommandedToStop(command(GroupAction::MotorOff, bus::Outcome::Done, both)).headline,
              u"Group 81 was commanded to switch its motors off: module 1 and 3."_s);
    EXPECT_EQ(texts::stopConfirmed({ModuleIndex(2), bus::StopCause::GroupStop}), u"Module 3 has stopped."_s);
}

TEST(ChainTexts, GroupWhoseZeroIsNotCertain) {
    const Message m = texts::groupFailed(
        command(GroupAction::ResetPosition, bus::Outcome::NoAnswer,
                {{ModuleIndex(0), MemberOutcome::Done}, {ModuleIndex(1), MemberOutcome::NotDone}}));
    EXPECT_EQ(m.headline, u"Not all modules of group 81 confirmed setting their position to 0."_s);
    EXPECT_TRUE(m.body.startsWith(u"Carried out by: 1. Not carried out by: 2."_s)) << m.body.toStdString();
}

/// This has happened: neither the reason nor the remedy was said.
TEST(ChainTexts, AGroupWithAPicIoThatDoesNotLeadIsToldToLetItLead) {
    ModuleState io;
    io.info = {ModuleIndex(3), BusAddress(4), {ModuleType::Io, 1}, bus::GroupPlace{0x81, false}};
    const bus::GroupFinished saved =
        command(GroupAction::SaveAsHome, bus::Outcome::NoAnswer,
                {{ModuleIndex(0), MemberOutcome::Done}, {ModuleIndex(3), MemberOutcome::Unknown}});
    const QString remedy = u"make it the leader of the group."_s;
    const Message m = texts::groupFailed(saved, {io});
    EXPECT_EQ(m.headline, u"Not all modules of group 81 confirmed saving home."_s);
    EXPECT_TRUE(m.body.endsWith(remedy)) << m.body.toStdString();
    io.info.group->leader = true;
    EXPECT_FALSE(texts::groupFailed(saved, {io}).body.contains(remedy));
    io.info = {ModuleIndex(3), BusAddress(4), {ModuleType::Servo, 10}, bus::GroupPlace{0x81, false}};
    EXPECT_FALSE(texts::groupFailed(saved, {io}).body.contains(remedy));
}

TEST(ChainTexts, AddressThatIsTaken) {
    const Message m = texts::notReaddressed({ModuleIndex(1), bus::ReaddressFailed::Reason::Taken});
    EXPECT_EQ(m.headline, u"Could not assign the address of module 2. No motor was moved."_s);
    EXPECT_TRUE(m.body.contains(u"1 to 127"_s));
    EXPECT_EQ(texts::addressChanged({ModuleIndex(1), BusAddress(77)}).headline,
              u"Module 2 now has address 77. Position, gains and group are unchanged."_s);
}

TEST(ChainTexts, AddressThatAnotherModuleWouldTake) {
    const Message m = texts::notReaddressed({ModuleIndex(1), bus::ReaddressFailed::Reason::Unaddressed});
    EXPECT_TRUE(m.body.startsWith(u"Another module without an address would take it. "_s))
        << m.body.toStdString();
    EXPECT_EQ(m.actions.size(), 2);
}

TEST(ChainTexts, RateThatAModuleDidNotHear) {
    const Message m = texts::rateNotChanged({RateFailure::NotHeard, 115'200, 19'200, {ModuleIndex(1)}, {}});
    EXPECT_EQ(m.headline,
              u"Could not change the baud rate: the chain stays at 19 200 Bd. No motor was moved."_s);
    EXPECT_TRUE(m.body.startsWith(
        u"Module 2 did not answer at 115 200 Bd, so all modules went back to the old rate."_s))
        << m.body.toStdString();
    const Message lost =
        texts::rateNotChanged({RateFailure::NotHeard, 115'200, 19'200, {ModuleIndex(1)}, {ModuleIndex(1)}});
    EXPECT_EQ(lost.headline,
              u"Module 2 has not answered since the baud rate changed. No motor was moving."_s);
    EXPECT_EQ(lost.severity, Severity::Fault);
    EXPECT_EQ(lost.actions.size(), 2);
}

TEST(ChainTexts, RateForAll) {
    EXPECT_EQ(texts::rateChanged({57'600}).headline,
              u"All modules now run at 57 600 Bd. Positions and gains are unchanged."_s);
}

/// It may have been by the stop of a single module, even of one outside the group, or by no stop at all.
TEST(ChainTexts, AGroupCommandThatWasCancelledIsNotSaidToBeReplacedByAStop) {
    const Message m = texts::groupFailed(start(bus::Outcome::Cancelled, {}));
    EXPECT_EQ(m.headline, u"The command to group 81 was cancelled."_s);
    EXPECT_TRUE(m.body.isEmpty()) << m.body.toStdString();
}

TEST(ChainTexts, HaveNoForbiddenWords) {
    QStringList all;
    for (const RateFailure reason :
         {RateFailure::NoSuchRate, RateFailure::PortCannot, RateFailure::NotNow, RateFailure::Missing,
          RateFailure::GroupsUnknown, RateFailure::Leader, RateFailure::NotHeard, RateFailure::Interrupted}) {
        const Message m = texts::rateNotChanged({reason, 57'600, 19'200, {ModuleIndex(1)}, {}});
        EXPECT_FALSE(m.body.isEmpty());
        all << m.headline << m.body;
    }
    const bus::GroupFinished change{bus::OperationId(1),
                                    bus::Outcome::Forbidden,
                                    bus::GroupChange{ModuleIndex(1), {0x81, true}},
                                    {},
                                    false};
    const bus::GroupFinished home{bus::OperationId(1),
                                  bus::Outcome::NoAnswer,
                                  bus::GroupCommand{0x81, GroupAction::SaveAsHome},
                                  {{ModuleIndex(0), MemberOutcome::Unknown}},
                                  false};
    for (const auto& finished : {change, home, start(bus::Outcome::Cancelled, {})})
        all << texts::groupFailed(finished).headline << texts::groupFailed(finished).body;
    for (const QString& text : all)
        for (const QString& word : {u"invalid"_s, u"illegal"_s, u"fatal"_s, u"error"_s, u"!"_s, u"%"_s})
            EXPECT_FALSE(text.contains(word, Qt::CaseInsensitive)) << text.toStdString();
}

}  // namespace
}  // namespace nmc
