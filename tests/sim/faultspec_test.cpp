// SPDX-License-Identifier: GPL-3.0-or-later
// The grammar of `fault` lines (simulator.md, Faults).
#include "sim/faultspec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace nmc::sim::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<ModuleIdentity> kChain{
    {ModuleType::Servo, 4}, {ModuleType::Servo, 1}, {ModuleType::Stepper, 1}, {ModuleType::Io, 2}};

tl::expected<FaultSpec, std::string> parse(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    const std::vector<std::string_view> views(words.begin(), words.end());
    return parseFault(views, kChain);
}

std::string refusal(const std::string& line) {
    const auto spec = parse(line);
    return spec ? "accepted" : spec.error();
}

TEST(FaultSpec, ReadsEveryOption) {
    const auto spec = parse("module 2,1 flip status on=read_status p=0.25 n=3 at=1.5 for=200ms bit=9");
    ASSERT_TRUE(spec) << spec.error();
    EXPECT_EQ(spec->kind, FaultKind::Flip);
    EXPECT_THAT(spec->modules, ElementsAre(1, 0));
    EXPECT_FALSE(spec->sides.command);
    EXPECT_TRUE(spec->sides.status);
    EXPECT_EQ(spec->command, CommandCode::ReadStatus);
    EXPECT_EQ(spec->probability, 0.25);
    EXPECT_EQ(spec->count, 3U);
    EXPECT_EQ(spec->at, TimePoint(milliseconds(1500)));
    EXPECT_EQ(spec->lasts, milliseconds(200));
    EXPECT_EQ(spec->bit, 9U);
    EXPECT_EQ(spec->text, "module 2,1 flip status on=read_status p=0.25 n=3 at=1.5 for=200ms bit=9");
}

TEST(FaultSpec, WithoutOptionsStrikesEveryFrameEitherWayForEver) {
    const auto spec = parse("bus drop");
    ASSERT_TRUE(spec) << spec.error();
    EXPECT_THAT(spec->modules, IsEmpty());
    EXPECT_TRUE(spec->sides.command);
    EXPECT_TRUE(spec->sides.status);
    EXPECT_EQ(spec->probability, 1.0);
    EXPECT_FALSE(spec->command || spec->count || spec->at || spec->lasts || spec->bit);
}

TEST(FaultSpec, TimesAreSecondsOrHaveAUnit) {
    const auto spec = parse("bus delay t=300us..0.002");
    ASSERT_TRUE(spec) << spec.error();
    EXPECT_EQ(spec->least, microseconds(300));
    EXPECT_EQ(spec->most, milliseconds(2));
    const auto alike = parse("bus delay t=2s");
    ASSERT_TRUE(alike) << alike.error();
    EXPECT_EQ(alike->least, seconds(2));
    EXPECT_EQ(alike->most, seconds(2));
}

TEST(FaultSpec, EveryKindIsAcceptedOnItsTargets) {
    for (const char* kind :
         {"drop", "dup", "flip", "collide", "truncate", "garbage", "overrun", "delay t=1ms..2ms", "silent",
          "cksum", "ignore=set_baud", "mute rx", "mute tx", "powercycle", "definestat"}) {
        EXPECT_TRUE(parse(std::string("bus ") + kind)) << refusal(std::string("bus ") + kind);
        EXPECT_TRUE(parse(std::string("module 3 ") + kind)) << refusal(std::string("module 3 ") + kind);
    }
    for (const char* kind : {"noise", "break", "echo", "foreign"}) {
        EXPECT_TRUE(parse(std::string("bus ") + kind)) << refusal(std::string("bus ") + kind);
        EXPECT_THAT(refusal(std::string("module 1 ") + kind), HasSubstr("is the bus's, not a module's"));
    }
    for (const char* kind : {"stuck", "stall", "reverse"}) {
        EXPECT_TRUE(parse(std::string("module 1 ") + kind)) << refusal(std::string("module 1 ") + kind);
        EXPECT_THAT(refusal(std::string("bus ") + kind), HasSubstr("allowed is module K"));
    }
    EXPECT_TRUE(parse("module 1,2 sameaddr"));
}

TEST(FaultSpec, RefusesWithTheReasonWhatCannotBe) {
    EXPECT_THAT(refusal(""), HasSubstr("allowed are bus, module K"));
    EXPECT_THAT(refusal("wire drop"), HasSubstr("allowed are bus, module K"));
    EXPECT_THAT(refusal("module 5 drop"), HasSubstr("no module '5'; allowed is 1 to 4"));
    EXPECT_THAT(refusal("module 0 drop"), HasSubstr("no module '0'"));
    EXPECT_THAT(refusal("module 1, drop"), HasSubstr("no module ''"));
    EXPECT_THAT(refusal("module drop"), HasSubstr("no module 'drop'"));
    EXPECT_THAT(refusal("bus"), HasSubstr("no kind of fault ''; allowed are drop dup flip"));
    EXPECT_THAT(refusal("bus drip"), HasSubstr("no kind of fault 'drip'"));
    EXPECT_THAT(refusal("bus drop=3"), HasSubstr("no kind of fault 'drop=3'"));
    EXPECT_THAT(refusal("bus drop p=2"), HasSubstr("p cannot be '2'; allowed is 0 to 1"));
    EXPECT_THAT(refusal("bus drop p=nan"), HasSubstr("allowed is 0 to 1"));
    EXPECT_THAT(refusal("bus drop n=0"), HasSubstr("from 1 on"));
    EXPECT_THAT(refusal("bus drop n=-1"), HasSubstr("from 1 on"));
    EXPECT_THAT(refusal("bus drop for=soon"), HasSubstr("for cannot be 'soon'"));
    EXPECT_THAT(refusal("bus drop at=-1"), HasSubstr("at cannot be '-1'"));
    EXPECT_THAT(refusal("bus drop bit=1"), HasSubstr("drop does not go with bit="));
    EXPECT_THAT(refusal("bus flip bit=152"), HasSubstr("allowed is 0 to 151"));
    EXPECT_THAT(refusal("bus delay"), HasSubstr("needs t=A..B"));
    EXPECT_THAT(refusal("bus delay t=3ms..2ms"), HasSubstr("t cannot be"));
    EXPECT_THAT(refusal("bus delay cmd t=1ms"), HasSubstr("it strikes replies"));
    EXPECT_THAT(refusal("bus overrun status"), HasSubstr("it strikes commands"));
    EXPECT_THAT(refusal("bus echo p=0.5"), HasSubstr("echo does not go with p="));
    EXPECT_THAT(refusal("bus echo cmd"), HasSubstr("it has no side"));
    EXPECT_THAT(refusal("bus mute"), HasSubstr("mute rx"));
    EXPECT_THAT(refusal("bus ignore"), HasSubstr("ignore=<command>"));
    EXPECT_THAT(refusal("bus drop on=jump"),
                HasSubstr("knows no command 'jump'; allowed are reset_position"));
    EXPECT_THAT(refusal("module 3 drop on=set_gain"), HasSubstr("no command 'set_gain'"));
    EXPECT_THAT(refusal("bus foreign on=load_trajectory"), HasSubstr("nop"));
    EXPECT_THAT(refusal("module 1 sameaddr"), HasSubstr("two modules"));
    EXPECT_THAT(refusal("module 3 stall"), HasSubstr("module 3 is a stepper, which has no feedback"));
    EXPECT_THAT(refusal("module 4 stall"), HasSubstr("module 4 is a PIC-I/O, which has no motor"));
    EXPECT_THAT(refusal("bus drop twice"), HasSubstr("cannot read 'twice'"));
}

}  // namespace
}  // namespace nmc::sim::test
