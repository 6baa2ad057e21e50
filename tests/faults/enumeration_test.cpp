// SPDX-License-Identifier: GPL-3.0-or-later
// Thirty-two modules, and one fault at one byte while they are given their addresses: either the addresses
// are unique and the count is right, or the chain is refused. Every byte of every packet and of every reply
// is tried with NMC_ENUMERATION_STRIDE=1 (scripts/test nightly), only some of them in the other tiers.
#include <gtest/gtest.h>

#include <set>

#include "tests/faults/faultybus.h"
#include "tests/support/campaign.h"

namespace nmc::test {

namespace {

using namespace bus;

constexpr std::uint8_t kModules = 32;

enum class Damage : std::uint8_t { Drop, Dup, Flip };
enum class Way : std::uint8_t { ToModules, ToHost };

struct Case {
    Damage damage;
    Way way;
    bool restart;

    friend void PrintTo(const Case& c, std::ostream* stream) {
        static constexpr std::array kDamages{"Drop", "Dup", "Flip"};
        *stream << kDamages.at(static_cast<std::size_t>(c.damage))
                << (c.way == Way::ToModules ? "ToModules" : "ToHost")
                << (c.restart ? "AtRestart" : "AtConnect");
    }
};

/// A search during which the byte with this number is damaged; beyond the last byte, none is.
class Attempt {
public:
    Attempt(const Case& c, std::size_t strikeAt) : m_strikeAt(strikeAt) {
        if (c.way == Way::ToModules)
            bus.onCommand = [this, &c](std::vector<std::uint8_t>& command) {
                std::vector<std::uint8_t> arrives;
                for (std::uint8_t byte : command) {
                    const unsigned copies = damaged(c.damage, byte);
                    arrives.insert(arrives.end(), copies, byte);
                }
                command = arrives;
            };
        else
            bus.onHostByte = [this, &c](std::uint8_t& byte) { return damaged(c.damage, byte); };
        found = c.restart ? bus.restart() : bus.connect();
    }

    FaultyBus bus{servos(kModules)};
    bool found = false;
    std::size_t bytes = 0;

private:
    unsigned damaged(Damage damage, std::uint8_t& byte) {
        if (bytes++ != m_strikeAt)
            return 1;
        if (damage == Damage::Flip)
            byte = static_cast<std::uint8_t>(byte ^ (1U << m_strikeAt % 8));
        return damage == Damage::Drop ? 0 : damage == Damage::Dup ? 2 : 1;
    }

    std::size_t m_strikeAt;
};

void expectUniqueAddresses(Attempt& attempt) {
    std::set<int> addresses;
    for (std::uint8_t i = 0; i < kModules; ++i)
        addresses.insert(attempt.bus.chain.snapshot(ModuleIndex(i), attempt.bus.now).address);
    EXPECT_EQ(addresses.size(), std::size_t{kModules});
    EXPECT_GE(*addresses.begin(), 1);
    EXPECT_LE(*addresses.rbegin(), kModules + 1)
        << "a number that was not heard to be taken is not sent again";
    const auto found = attempt.bus.last<ChainFound>();
    ASSERT_EQ(found->modules.size(), std::size_t{kModules});
    for (const ModuleInfo& info : found->modules) {
        EXPECT_EQ(info.address.value(), attempt.bus.chain.snapshot(info.index, attempt.bus.now).address);
        EXPECT_EQ(info.identity, (ModuleIdentity{ModuleType::Servo, 4}));
    }
}

class Enumeration : public testing::TestWithParam<Case> {};

TEST_P(Enumeration, GivesUniqueAddressesOrRefuses) {
    const std::size_t bytes = Attempt(GetParam(), SIZE_MAX).bytes;
    ASSERT_GT(bytes, 100U);
    // A search after a restart of the chain takes four times as long.
    const std::uint64_t stride = campaignSize("NMC_ENUMERATION_STRIDE", GetParam().restart ? 11 : 3);
    unsigned tried = 0;
    unsigned refused = 0;
    for (std::size_t at = 0; at < bytes && !HasFailure(); at += stride) {
        SCOPED_TRACE("byte " + std::to_string(at));
        Attempt attempt(GetParam(), at);
        ++tried;
        if (attempt.found) {
            expectUniqueAddresses(attempt);
        } else {
            ++refused;
            EXPECT_EQ(attempt.bus.count<ConnectFailed>(), 1U) << "the chain must be found or refused";
        }
    }
    std::printf("%zu bytes, %u tried, %u refused\n", bytes, tried, refused);
    EXPECT_LE(refused, tried / 4) << "one wrong byte is no reason to give up";
}

INSTANTIATE_TEST_SUITE_P(
    OneByte, Enumeration,
    testing::Values(Case{Damage::Drop, Way::ToModules, false}, Case{Damage::Drop, Way::ToModules, true},
                    Case{Damage::Dup, Way::ToModules, false}, Case{Damage::Dup, Way::ToModules, true},
                    Case{Damage::Flip, Way::ToModules, false}, Case{Damage::Flip, Way::ToModules, true},
                    Case{Damage::Drop, Way::ToHost, false}, Case{Damage::Drop, Way::ToHost, true},
                    Case{Damage::Dup, Way::ToHost, false}, Case{Damage::Dup, Way::ToHost, true},
                    Case{Damage::Flip, Way::ToHost, false}, Case{Damage::Flip, Way::ToHost, true}),
    testing::PrintToStringParamName());

}  // namespace

}  // namespace nmc::test
