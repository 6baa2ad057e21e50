// SPDX-License-Identifier: GPL-3.0-or-later
// Home searches of all kinds on a line that loses and garbles bytes: a position reported as home is home, and
// after a failure or a cancel the motor stands still.
#include <array>
#include <random>

#include "model/intent/homingplan.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Stop = HomingRecipe::Stop;

class Campaign : public testing::TestWithParam<unsigned> {
protected:
    [[nodiscard]] bool chance(double probability) {
        return std::uniform_real_distribution<>(0.0, 1.0)(random) < probability;
    }
    [[nodiscard]] int between(int low, int high) {
        return std::uniform_int_distribution<>(low, high)(random);
    }
    [[nodiscard]] HomingRecipe anyRecipe() {
        HomingRecipe recipe = slowRecipe();
        recipe.onLimit1 = true;
        recipe.onIndex = chance(0.2);
        recipe.thenIndex = chance(0.3);
        recipe.indexVelocity = 0.25;
        recipe.stop = static_cast<Stop>(between(0, 2));
        recipe.goToHome = chance(0.7);
        recipe.makeZero = chance(0.7);
        recipe.travelLimit = chance(0.1) ? 300 : 5'000;
        return recipe;
    }
    /// Loses or changes bytes on their way to the host and to the module, each with about this probability.
    void invalidate(ServoBench& bench, double probability) {
        bench.bus.onHostByte = [this, probability](std::uint8_t& byte) {
            if (chance(probability))
                byte = static_cast<std::uint8_t>(byte ^ (1U << between(0, 7)));
            return chance(probability) ? 0U : 1U;
        };
        // At most one bit changes: with two, the checksum may still match, which no host can notice.
        bench.bus.onCommand = [this, probability](std::vector<std::uint8_t>& command) {
            if (chance(5 * probability))
                command[static_cast<std::size_t>(between(0, static_cast<int>(command.size()) - 1))] ^=
                    static_cast<std::uint8_t>(1U << between(0, 7));
            else if (chance(probability))
                command.pop_back();
        };
    }
    static constexpr std::array<std::uint8_t, 6> kVersions{1, 2, 3, 4, kPathVersion, kScVersion};
    std::mt19937 random;
};

TEST_P(Campaign, NothingIsHomeThatIsNot) {
    unsigned done = 0;
    for (unsigned i = 0; i < 25; ++i) {
        const unsigned seed = GetParam() * 1'000 + i;
        SCOPED_TRACE("seed " + std::to_string(seed));
        random.seed(seed);
        ServoBench bench(kVersions.at(static_cast<std::size_t>(between(0, 5))));
        bench.watchesSpeed = true;
        const double at = chance(0.2) ? between(50, 400) : between(-1'500, -100);
        bench.putSwitch(sim::Input::Limit1, at, true);
        ASSERT_TRUE(bench.enable());
        const HomingRecipe recipe = effective(anyRecipe(), bench.module().info.identity);
        bench.begin(intent::Home{recipe});
        ASSERT_NE(bench.procedure, nullptr);
        constexpr std::array kBad{0.0, 0.0002, 0.0005, 0.002, 0.005};
        invalidate(bench, kBad[static_cast<std::size_t>(between(0, 4))]);
        if (chance(0.3)) {
            const int turns = between(0, 300);
            bench.onTurn = [n = 0, turns](Procedure& run) mutable {
                if (++n == turns)
                    run.cancel();
            };
        }
        const ProcedureReport report = bench.goOn(120);
        bench.bus.onHostByte = nullptr;
        bench.bus.onCommand = nullptr;
        bench.bus.runFor(3s);
        bench.take();
        const auto truth = bench.truth();
        EXPECT_EQ(truth.commandVelocity, 0);
        EXPECT_NEAR(truth.velocity, 0, 0.05);
        EXPECT_LE(bench.fastest, 0.5);
        const bool zeroed = bench.bus.sends("AA 01 00") > 0;
        EXPECT_TRUE(!zeroed || recipe.makeZero);
        if (report.stage == ProcedureStage::Done) {
            ++done;
            // The register of the chip itself shows what was really captured.
            EXPECT_EQ(*report.home, truth.home);
            const bool index = recipe.thenIndex;
            if (!recipe.onIndex && !index) {
                EXPECT_NEAR(*report.home, at, 2.5);
            }
            if (index) {
                EXPECT_NEAR(std::remainder(*report.home, 2'000.0), 0, 1.0);
            }
            if (recipe.makeZero) {
                EXPECT_NEAR(truth.shaftCounts - truth.position, *report.home, 2.5);
                EXPECT_NEAR(truth.position, 0, 2);
            } else if (recipe.goToHome) {
                EXPECT_NEAR(truth.position, *report.home, 5);
            }
            EXPECT_TRUE(truth.servoOn || recipe.stop == Stop::Off);
        } else {
            EXPECT_TRUE(report.over());
            EXPECT_TRUE(!report.failure || report.stage == ProcedureStage::Failed);
        }
    }
    RecordProperty("done", static_cast<int>(done));
    EXPECT_GT(done, 5U) << "fewer successes would prove little";
}

INSTANTIATE_TEST_SUITE_P(Seeds, Campaign, testing::Range(1U, 9U));

}  // namespace
}  // namespace nmc::test
