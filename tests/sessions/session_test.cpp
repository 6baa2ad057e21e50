// SPDX-License-Identifier: GPL-3.0-or-later
// The property of issue 13: after a stop of all modules at any byte of any session, the simulator's truth and
// the report agree. And that of H-02: a session on a read-only connection changes nothing. Three hundred
// sessions; ten thousand with NMC_SESSIONS=10000 (scripts/test nightly); a single one, with all that went
// over the wire, with NMC_SESSION_SEED=number.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>

#include "tests/sessions/plan.h"
#include "tests/support/campaign.h"

namespace nmc::test {

namespace {

constexpr unsigned kShares = 10;  ///< so that each ends in good time under a sanitizer, and on two cores
constexpr unsigned kTold = 5;     ///< number of failed sessions that are printed in full

void print(const Rig& rig) {
    for (const WireItem& item : rig.wire)
        std::printf("%.6f s %6u Bd: %s\n", toSeconds(item.time.time_since_epoch()), item.baud,
                    item.packet.empty() ? (std::to_string(item.nulls) + " nulls").c_str()
                                        : toHex(item.packet).c_str());
}

struct Outcome {
    std::vector<std::string> complaints;
    std::set<std::string> situations;
};
[[nodiscard]] Outcome run(const Plan& plan, bool aloud) {
    Rig rig(plan.world);
    carryOut(plan, rig);
    if (aloud)
        print(rig);
    return {rig.complaints, rig.situations};
}

[[nodiscard]] std::string inFull(const Plan& plan, const std::vector<std::string>& complaints) {
    std::string text = toText(plan);
    for (const std::string& complaint : complaints)
        text += "\n    " + complaint;
    return text + "\n    alone: NMC_SESSION_SEED=" + std::to_string(plan.seed);
}

/// Counts the situations in which stops were requested, and the kinds of violation, by the first word of the
/// first complaint.
class Sessions : public testing::TestWithParam<unsigned> {
protected:
    using Maker = Plan (*)(std::uint64_t seed);

    void holdAll(Maker make) {
        if (const std::uint64_t alone = campaignSize("NMC_SESSION_SEED", 0); alone != 0) {
            if (alone % kShares != GetParam())
                return;
            const Plan plan = make(alone);
            const auto complaints = run(plan, true).complaints;
            EXPECT_TRUE(complaints.empty()) << inFull(plan, complaints);
            return;
        }
        const std::uint64_t sessions = campaignSize("NMC_SESSIONS", 300);
        for (std::uint64_t seed = 1; seed <= sessions; ++seed)
            if (seed % kShares == GetParam())
                hold(make(seed));
        summarise();
    }

private:
    void hold(const Plan& plan) {
        const Outcome outcome = run(plan, false);
        for (const std::string& situation : outcome.situations)
            ++m_situations[situation];
        if (outcome.complaints.empty())
            return;
        const std::string& first = outcome.complaints.front();
        ++m_kinds[first.substr(0, first.find(':'))];
        if (++m_broken <= kTold)
            ADD_FAILURE() << inFull(plan, outcome.complaints);
        else
            std::printf("seed %llu: %s\n", static_cast<unsigned long long>(plan.seed), first.c_str());
    }
    void summarise() const {
        for (const auto& [situation, n] : m_situations)
            std::printf("%u stops came upon %s\n", n, situation.c_str());
        for (const auto& [kind, n] : m_kinds)
            std::printf("%u broke first of all: %s\n", n, kind.c_str());
        EXPECT_EQ(m_broken, 0U);
    }

    std::map<std::string, unsigned> m_situations;
    std::map<std::string, unsigned> m_kinds;
    unsigned m_broken = 0;
};

TEST_P(Sessions, KeepTheOathOfTheStop) {
    holdAll(makePlan);
}

/// H-02.
TEST_P(Sessions, ChangeNothingWhereTheyAreReadOnly) {
    holdAll(makeReadOnlyPlan);
}

INSTANTIATE_TEST_SUITE_P(Shares, Sessions, testing::Range(0U, kShares));

}  // namespace

}  // namespace nmc::test
