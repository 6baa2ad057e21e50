// SPDX-License-Identifier: GPL-3.0-or-later
// The property of issue 13: at any byte of any session call stop all; afterwards the simulator's truth and
// the report agree. Three hundred sessions; ten thousand with NMC_SESSIONS=10000 (scripts/test nightly); one
// alone, with what went over the wire, with NMC_SESSION_SEED=number.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "tests/sessions/plan.h"

namespace nmc::test {

namespace {

constexpr unsigned kShares = 10;  ///< so that each ends in good time under a sanitizer, and on two cores
constexpr unsigned kTold = 5;     ///< that broke the oath, in full

[[nodiscard]] std::uint64_t number(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

void print(const Rig& rig) {
    for (const WireItem& item : rig.wire)
        std::printf("%.6f s %6u Bd: %s\n", toSeconds(item.time.time_since_epoch()), item.baud,
                    item.packet.empty() ? (std::to_string(item.nulls) + " nulls").c_str()
                                        : toHex(item.packet).c_str());
}

/// What one session breaks.
[[nodiscard]] std::vector<std::string> run(std::uint64_t seed, bool aloud) {
    const Plan plan = makePlan(seed);
    Rig rig(plan.world);
    carryOut(plan, rig);
    if (aloud)
        print(rig);
    return rig.complaints;
}

[[nodiscard]] std::string inFull(std::uint64_t seed, const std::vector<std::string>& complaints) {
    std::string text = toText(makePlan(seed));
    for (const std::string& complaint : complaints)
        text += "\n    " + complaint;
    return text + "\n    alone: NMC_SESSION_SEED=" + std::to_string(seed);
}

class Sessions : public testing::TestWithParam<unsigned> {};

TEST_P(Sessions, KeepTheOathOfTheStop) {
    if (const std::uint64_t alone = number("NMC_SESSION_SEED", 0); alone != 0) {
        if (alone % kShares != GetParam())
            return;
        const auto complaints = run(alone, true);
        EXPECT_TRUE(complaints.empty()) << inFull(alone, complaints);
        return;
    }
    const std::uint64_t sessions = number("NMC_SESSIONS", 300);
    std::map<std::string, unsigned> kinds;  // the first word of the first complaint: the line of the oath
    unsigned broken = 0;
    for (std::uint64_t seed = 1; seed <= sessions; ++seed) {
        if (seed % kShares != GetParam())
            continue;
        const auto complaints = run(seed, false);
        if (complaints.empty())
            continue;
        ++kinds[complaints.front().substr(0, complaints.front().find(':'))];
        if (++broken <= kTold)
            ADD_FAILURE() << inFull(seed, complaints);
        else
            std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), complaints.front().c_str());
    }
    for (const auto& [kind, n] : kinds)
        std::printf("%u broke first of all: %s\n", n, kind.c_str());
    EXPECT_EQ(broken, 0U);
}

INSTANTIATE_TEST_SUITE_P(Shares, Sessions, testing::Range(0U, kShares));

}  // namespace

}  // namespace nmc::test
