// SPDX-License-Identifier: GPL-3.0-or-later
// The leaky bucket of link.md 2.5: +10, -1, 30, 100; and the distinction between a silent module and a dead
// line.
#include "bus/health.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "bus/silence.h"

namespace nmc::test {

namespace {

using namespace bus;

void wrong(Health& health, int times) {
    for (int i = 0; i < times; ++i)
        health.wrong();
}
void good(Health& health, int times) {
    for (int i = 0; i < times; ++i)
        health.good();
}

TEST(Health, IsGoodAtFirst) {
    const Health health;
    EXPECT_EQ(health.level(), LinkHealth::Good);
    EXPECT_EQ(health.exchanges(), 0U);
}

TEST(Health, BecomesDoubtfulAtThirty) {
    Health health;
    wrong(health, 2);
    EXPECT_EQ(health.level(), LinkHealth::Good);
    health.wrong();
    EXPECT_EQ(health.level(), LinkHealth::Marginal);
}

TEST(Health, CountsAGoodExchangeAsATenthOfAWrongOne) {
    Health health;
    wrong(health, 2);
    health.good();
    health.wrong();
    EXPECT_EQ(health.level(), LinkHealth::Good) << "29";
    health.wrong();
    EXPECT_EQ(health.level(), LinkHealth::Marginal) << "39";
}

TEST(Health, StaysDoubtfulUntilTheBucketIsEmpty) {
    Health health;
    wrong(health, 3);
    good(health, 29);
    EXPECT_EQ(health.level(), LinkHealth::Marginal);
    health.good();
    EXPECT_EQ(health.level(), LinkHealth::Good);
}

TEST(Health, DoesNotSaveUpGoodExchanges) {
    Health health;
    good(health, 10'000);
    wrong(health, 3);
    EXPECT_EQ(health.level(), LinkHealth::Marginal);
}

TEST(Health, IsLostAtAHundredForGood) {
    Health health;
    wrong(health, 9);
    good(health, 1);
    health.wrong();
    EXPECT_EQ(health.level(), LinkHealth::Marginal) << "99";
    health.wrong();
    EXPECT_EQ(health.level(), LinkHealth::Lost);
    good(health, 10'000);
    EXPECT_EQ(health.level(), LinkHealth::Lost);
}

TEST(Health, LooksBackOnTwoHundredExchanges) {
    Health health;
    wrong(health, 2);
    good(health, 100);
    EXPECT_EQ(health.exchanges(), 102U);
    EXPECT_EQ(health.wrongLately(), 2U);
    good(health, 99);
    EXPECT_EQ(health.exchanges(), 200U);
    EXPECT_EQ(health.wrongLately(), 1U);
    good(health, 1);
    EXPECT_EQ(health.wrongLately(), 0U);
}

RC_GTEST_PROP(Health, IsLostExactlyOnceTheBucketHasHeldAHundred, (std::vector<bool> exchanges)) {
    Health health;
    int bucket = 0;
    bool lost = false;
    for (const bool isWrong : exchanges) {
        isWrong ? health.wrong() : health.good();
        bucket = isWrong ? bucket + 10 : bucket > 0 ? bucket - 1 : 0;
        lost = lost || bucket >= 100;
        RC_ASSERT((health.level() == LinkHealth::Lost) == lost);
        RC_ASSERT(lost || bucket < 30 || health.level() == LinkHealth::Marginal);
        RC_ASSERT(lost || bucket > 0 || health.level() == LinkHealth::Good);
    }
}

TEST(SilenceOfTheLine, IsLikelyOnceThreeModulesInARowAreSilent) {
    Silence silence;
    silence.onSilence(ModuleIndex(0));
    silence.onSilence(ModuleIndex(1));
    silence.onSilence(ModuleIndex(1));
    EXPECT_FALSE(silence.likelyDead());
    silence.onSilence(ModuleIndex(5));
    EXPECT_TRUE(silence.likelyDead());
    EXPECT_TRUE(silence.asked(ModuleIndex(5)));
    EXPECT_FALSE(silence.asked(ModuleIndex(4)));
    silence.heard();
    EXPECT_FALSE(silence.likelyDead()) << "a single byte shows that it is alive";
    EXPECT_FALSE(silence.asked(ModuleIndex(5)));
}

TEST(SilenceOfTheLine, IsCertainOnceEveryModuleAndFourQuestionsAreSilent) {
    Silence two;
    two.onSilence(ModuleIndex(0));
    two.onSilence(ModuleIndex(1));
    two.onSilence(ModuleIndex(0));
    EXPECT_FALSE(two.dead(2)) << "only three queries";
    two.onSilence(ModuleIndex(1));
    EXPECT_TRUE(two.dead(2));
    EXPECT_FALSE(two.dead(3)) << "the third module has not been queried";
    Silence one;
    for (int i = 0; i < 10; ++i)
        one.onSilence(ModuleIndex(0));
    EXPECT_FALSE(one.dead(1)) << "with a single module, it is the module that is silent";
}

TEST(SilenceOfTheLine, TellsThirtyTwoModulesApart) {
    Silence silence;
    for (std::uint8_t i = 0; i < 31; ++i)
        silence.onSilence(ModuleIndex(i));
    EXPECT_FALSE(silence.dead(32));
    silence.onSilence(ModuleIndex(31));
    EXPECT_TRUE(silence.dead(32));
}

}  // namespace

}  // namespace nmc::test
