// SPDX-License-Identifier: GPL-3.0-or-later
// A panel that is killed in the middle of a command: the motor stops, whatever the module makes of the part
// that it received.
#include <gtest/gtest.h>

#include "tests/link/guardian/guardhost.h"
#include "tests/support/gains.h"

namespace nmc {
namespace {

using namespace testing_support;

class LastExchange : public testing::TestWithParam<std::uint32_t> {
protected:
    /// Kills the panel after each prefix of the packet.
    void cutEverywhere(const Payload& payload) {
        Chain chain(GetParam());
        const std::vector<std::uint8_t> packet = Chain::packet(payload);
        for (std::size_t cut = 0; cut <= packet.size(); ++cut) {
            ASSERT_NO_FATAL_FAILURE(chain.setGoing());
            GuardHost host(chain, chain.sim().terminal(), folder.file());
            ASSERT_NO_FATAL_FAILURE(host.guardMotion());
            if (cut > 0)
                host.write({packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(cut)});
            host.die();
            EXPECT_TRUE(chain.stops()) << "after " << cut << " bytes";
            EXPECT_TRUE(host.guardIsGone());
            EXPECT_LT(chain.velocity(), 0.01) << "after " << cut << " bytes, and it stays stopped";
        }
    }

    ReportFolder folder;
};

TEST_P(LastExchange, AStartOfAnotherMotion) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(4 << 16);
    load.acceleration = CountsPerTickSquared(65'536);
    load.profile = servo::ProfileMode::Velocity;
    load.reverse = true;
    load.startNow = true;
    cutEverywhere(encode(load));
}

TEST_P(LastExchange, TheLongestCommand) {
    cutEverywhere(encode(testing_support::kGains));
}

INSTANTIATE_TEST_SUITE_P(H02, LastExchange, testing::Values(19'200U, 115'200U));

}  // namespace
}  // namespace nmc
