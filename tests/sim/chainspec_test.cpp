// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/chainspec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nmc::sim {
namespace {

using testing::HasSubstr;

TEST(ChainSpec, ServosHaveVersion4UnlessTheySayOtherwise) {
    const auto chain = parseChain("servo, servo@1,servo@3");
    ASSERT_TRUE(chain);
    ASSERT_EQ(chain->size(), 3U);
    EXPECT_EQ((*chain)[0], (ModuleIdentity{ModuleType::Servo, 4}));
    EXPECT_EQ((*chain)[1], (ModuleIdentity{ModuleType::Servo, 1}));
    EXPECT_EQ((*chain)[2], (ModuleIdentity{ModuleType::Servo, 3}));
}

TEST(ChainSpec, AnErrorNamesTheItemAndWhatIsAllowed) {
    for (const std::string item : {"motor", "servo@0", "servo@6", "servo@9", "servo@11", "servo@", "servo@44",
                                   "servo@04", "Servo", "servo@x", "io@2", "adc"}) {
        const auto chain = parseChain("servo," + item);
        ASSERT_FALSE(chain) << item;
        EXPECT_THAT(chain.error(), HasSubstr("'" + item + "'"));
        EXPECT_THAT(chain.error(), HasSubstr("servo@4"));
    }
}

TEST(ChainSpec, ASteppersOnlyVersionIsOne) {
    const auto chain = parseChain("step,servo,step@1");
    ASSERT_TRUE(chain);
    EXPECT_EQ((*chain)[0], (ModuleIdentity{ModuleType::Stepper, 1}));
    EXPECT_EQ((*chain)[1], (ModuleIdentity{ModuleType::Servo, 4}));
    EXPECT_EQ((*chain)[2], (ModuleIdentity{ModuleType::Stepper, 1}));
    for (const std::string item : {"step@0", "step@2", "step@4", "step@", "steps"}) {
        const auto refused = parseChain("servo," + item);
        ASSERT_FALSE(refused) << item;
        EXPECT_THAT(refused.error(), HasSubstr("'" + item + "'"));
        EXPECT_THAT(refused.error(), HasSubstr("step@1"));
    }
}

TEST(ChainSpec, KnowsTheRestOfTheFamily) {
    const auto chain = parseChain("servo@5,servo@10,io,io@1");
    ASSERT_TRUE(chain);
    EXPECT_EQ((*chain)[0], (ModuleIdentity{ModuleType::Servo, 5}));
    EXPECT_EQ((*chain)[1], (ModuleIdentity{ModuleType::Servo, 10}));
    EXPECT_EQ((*chain)[2], (ModuleIdentity{ModuleType::Io, 1}));
    EXPECT_EQ((*chain)[3], (ModuleIdentity{ModuleType::Io, 1}));
}

TEST(ChainSpec, RefusesAnEmptyChainAndAnEmptyItem) {
    for (const char* text : {"", "  ", ",", "servo,", "servo,,servo"}) {
        const auto chain = parseChain(text);
        ASSERT_FALSE(chain) << text;
        EXPECT_THAT(chain.error(), HasSubstr("empty"));
    }
}

TEST(ChainSpec, TakesThirtyTwoModulesAndNoMore) {
    std::string text = "servo";
    for (int i = 1; i < 32; ++i)
        text += ",servo";
    ASSERT_TRUE(parseChain(text));
    EXPECT_EQ(parseChain(text)->size(), 32U);
    const auto chain = parseChain(text + ",servo@2");
    ASSERT_FALSE(chain);
    EXPECT_THAT(chain.error(), HasSubstr("'servo@2'"));
    EXPECT_THAT(chain.error(), HasSubstr("32"));
}

}  // namespace
}  // namespace nmc::sim
