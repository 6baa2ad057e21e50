// SPDX-License-Identifier: GPL-3.0-or-later
// Random users of the whole program (issue 14). NMC_MONKEY: number of acts for each seed; NMC_MONKEY_SEED:
// only this seed.
#include <gtest/gtest.h>

#include "tests/monkey/monkey.h"
#include "tests/support/campaign.h"

namespace nmc::monkey {
namespace {

constexpr int kSeeds = 6;

/// Counts what the users have met.
struct Met {
    unsigned motions = 0;
    unsigned stopsInMotion = 0;
    unsigned strikes = 0;
};

Met play(int seed, int acts) {
    Monkey monkey(static_cast<std::uint64_t>(seed));
    for (int i = 0; i < acts; ++i) {
        if (monkey.act())
            continue;
        for (const std::string& complaint : monkey.oath().complaints())
            ADD_FAILURE() << complaint;
        ADD_FAILURE() << "NMC_MONKEY_SEED=" << seed << ", after these acts:\n" << monkey.story();
        break;
    }
    return {monkey.motions(), monkey.stopsInMotion(), monkey.strikes()};
}

TEST(Monkey, BreaksNothing) {
    const auto acts = static_cast<int>(test::campaignSize("NMC_MONKEY", 200));
    if (const int seed = qEnvironmentVariableIntValue("NMC_MONKEY_SEED"); seed > 0) {
        const Met met = play(seed, acts);
        std::printf("%u motions, %u stopped with all, %u strikes\n", met.motions, met.stopsInMotion,
                    met.strikes);
        return;
    }
    Met met;
    for (int seed = 1; seed <= kSeeds && !HasFailure(); ++seed) {
        const Met one = play(seed, acts);
        met.motions += one.motions;
        met.stopsInMotion += one.stopsInMotion;
        met.strikes += one.strikes;
    }
    // Otherwise there was nothing to break.
    EXPECT_GT(met.motions, 0U);
    EXPECT_GT(met.stopsInMotion, 0U);
    EXPECT_GT(met.strikes, 0U);
}

}  // namespace
}  // namespace nmc::monkey
