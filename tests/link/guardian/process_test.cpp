// SPDX-License-Identifier: GPL-3.0-or-later
// The guardian as a process: what it does when its panel dies, stands still, continues, or ends normally.
// nmcsim is the witness.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <fstream>
#include <set>

#include "link/guardian/guardian.h"
#include "link/guardian/guardreport.h"
#include "tests/link/guardian/guardhost.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::IsEmpty;

class GuardianProcess : public testing::TestWithParam<std::uint32_t> {
protected:
    void SetUp() override {
        chain.setGoing();
        host.emplace(chain, chain.sim().terminal(), folder.file());
        ASSERT_EQ(host->ready(), "ready");
        ASSERT_NO_FATAL_FAILURE(host->guardMotion());
    }

    ReportFolder folder;
    Chain chain{GetParam()};
    std::optional<GuardHost> host;
};

TEST_P(GuardianProcess, StopsTheMotorOfAPanelThatWasKilled) {
    host->die();
    EXPECT_TRUE(chain.stops());
    EXPECT_TRUE(chain.sim().state(1)["servo_on"].get<bool>()) << "it holds";
    EXPECT_FALSE(chain.sim().state(2)["servo_on"].get<bool>()) << "what was off stays off";
    EXPECT_TRUE(host->guardIsGone());
    const auto reports = takeGuardReports(folder.path());
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_THAT(reports[0].modules, ElementsAre(1));
}

TEST_P(GuardianProcess, StopsItAlsoWhenThePortWasAtAnotherRate) {
    ASSERT_EQ(host->ask("rate 57600"), "ok");
    host->die();
    EXPECT_TRUE(chain.stops());
}

TEST_P(GuardianProcess, StopsTheMotorOfAPanelThatStandsStillAndTellsItAfterwards) {
    ASSERT_EQ(host->ask("timely"), "ok");
    host->send(SIGSTOP);
    EXPECT_TRUE(chain.stops());
    host->send(SIGCONT);
    ASSERT_EQ(host->ask("steady"), "ok");
    EXPECT_EQ(host->ask("alive?"), "yes");
    EXPECT_EQ(host->ask("stopped?"), "yes");
    EXPECT_EQ(host->ask("stopped?"), "no") << "reported once";
    EXPECT_THAT(takeGuardReports(folder.path()), IsEmpty()) << "the next start does not report it again";
    // It has armed itself again, and stops the motor a second time.
    ASSERT_NO_FATAL_FAILURE(chain.setGoing());
    ASSERT_EQ(host->ask("timely"), "ok");
    host->send(SIGSTOP);
    EXPECT_TRUE(chain.stops());
    host->send(SIGCONT);
    EXPECT_EQ(host->ask("stopped?"), "yes");
}

TEST_P(GuardianProcess, StopsTheMotorWhoseLoopHangsWhileTheProcessLives) {
    ASSERT_EQ(host->ask("timely"), "ok");
    ASSERT_EQ(host->ask("neglect"), "ok");
    EXPECT_TRUE(chain.stops());
    ASSERT_EQ(host->ask("move"), "ok");
    EXPECT_EQ(host->ask("stopped?"), "yes");
}

TEST_P(GuardianProcess, IsGoneAndHasSentNothingWhenThePanelEndedInOrder) {
    const int before = chain.received();
    ASSERT_EQ(host->ask("end"), "ok");
    EXPECT_NE(::kill(host->guard(), 0), 0) << "it is gone before the port is closed";
    host.reset();
    EXPECT_EQ(chain.received(), before);
    EXPECT_GT(chain.velocity(), 7.9);
    EXPECT_THAT(takeGuardReports(folder.path()), IsEmpty());
}

TEST_P(GuardianProcess, SendsNothingWhenNothingIsLeftToStop) {
    const int before = chain.received();
    ASSERT_EQ(host->ask("arm 0"), "ok");
    host->die();
    EXPECT_TRUE(host->guardIsGone());
    EXPECT_EQ(chain.received(), before);
    EXPECT_THAT(takeGuardReports(folder.path()), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(H02, GuardianProcess, testing::Values(19'200U, 115'200U));

class OneGuardian : public GuardianProcess {};
INSTANTIATE_TEST_SUITE_P(H02, OneGuardian, testing::Values(19'200U));

TEST_P(OneGuardian, OutlivesWhatEndsAProcessGroup) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
        ::kill(host->guard(), signal);
    EXPECT_EQ(host->ask("alive?"), "yes");
    EXPECT_NE(::getsid(host->guard()), ::getsid(host->process().pid()));
    host->die();
    EXPECT_TRUE(chain.stops());
}

TEST_P(OneGuardian, HasThePortTheMemoryTheChannelAndNothingElseOfThePanel) {
    const std::string process = "/proc/" + std::to_string(host->guard());
    std::set<std::string> descriptors;
    for (const auto& entry : std::filesystem::directory_iterator(process + "/fd"))
        descriptors.insert(entry.path().filename());
    EXPECT_THAT(descriptors, testing::UnorderedElementsAre("0", "1", "2", "3", "4", "5", "6"));
    EXPECT_EQ(std::filesystem::read_symlink(process + "/fd/3"), chain.sim().terminal());
    std::ifstream status(process + "/status");
    const std::string text((std::istreambuf_iterator<char>(status)), {});
    EXPECT_NE(text.find("SigBlk:\t0000000000000000"), std::string::npos) << text;
}

TEST_P(OneGuardian, ThatIsKilledIsMissedAndThePanelGoesOn) {
    ::kill(host->guard(), SIGKILL);
    EXPECT_TRUE(comesTrue([&] { return host->ask("alive?") == "no"; }));
    EXPECT_EQ(host->ask("arm 19200 AA 01 17 05 1D"), "ok");
    EXPECT_EQ(host->ask("rest"), "ok");
    EXPECT_EQ(host->ask("move"), "ok");
    EXPECT_EQ(host->ask("end"), "ok");
    EXPECT_GT(chain.velocity(), 7.9);
}

TEST_P(OneGuardian, EndsWithThePort) {
    chain.sim().control("quit");
    EXPECT_TRUE(host->guardIsGone());
    EXPECT_EQ(host->ask("alive?"), "no");
    EXPECT_EQ(host->ask("end"), "ok");
}

TEST_P(OneGuardian, KeepsTheLockUntilItHasSpoken) {
    const int spoken = chain.received() + 3 * static_cast<int>(chain.burst().size());
    host->die();
    // Another panel gets the port only when the guardian has finished.
    const int other = ::open(chain.sim().terminal().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_GE(other, 0);
    EXPECT_TRUE(comesTrue([&] { return ::flock(other, LOCK_EX | LOCK_NB) == 0; }));
    // The kernel hands the bytes over in a thread of its own.
    EXPECT_TRUE(comesTrue([&] { return chain.received() >= spoken; }));
    EXPECT_TRUE(chain.stops());
    EXPECT_EQ(chain.received(), spoken) << "nothing is sent after that";
    ::close(other);
}

TEST_P(OneGuardian, NeverWritesToAPortWhoseLockIsSomebodyElses) {
    const int before = chain.received();
    ASSERT_EQ(host->ask("unlock"), "ok");
    const int other = ::open(chain.sim().terminal().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
    host->die();
    EXPECT_TRUE(host->guardIsGone());
    EXPECT_EQ(chain.received(), before);
    EXPECT_GT(chain.velocity(), 7.9);
    EXPECT_THAT(takeGuardReports(folder.path()), IsEmpty());
    ::close(other);
}

TEST_P(OneGuardian, RefusesABurstThatDoesNotFitWholeAndThenHasNone) {
    const std::vector<std::uint8_t> tooMuch(StopBurst::kCapacity + 1, 0);
    EXPECT_EQ(host->ask("arm 19200 " + toHex(tooMuch)), "refused");
}

TEST(TwoPanels, AtTwoPortsAreGuardedEachForItself) {
    const ReportFolder folder;
    Chain one;
    Chain two;
    one.setGoing();
    two.setGoing();
    GuardHost first(one, one.sim().terminal(), folder.file());
    GuardHost second(two, two.sim().terminal(), folder.path() + "/guardian-2.report");
    ASSERT_NO_FATAL_FAILURE(first.guardMotion());
    ASSERT_NO_FATAL_FAILURE(second.guardMotion());
    first.die();
    EXPECT_TRUE(one.stops());
    EXPECT_TRUE(first.guardIsGone());
    EXPECT_GT(two.velocity(), 7.9);
    EXPECT_EQ(second.ask("stopped?"), "no");
    second.ask("end");
}

TEST(NoGuardian, IsSaidWithTheReason) {
    const ReportFolder folder;
    Chain chain;
    const auto problem = [&](const std::string& program) {
        GuardHost host(chain, chain.sim().terminal(), folder.file(), program);
        return host.ask("start");
    };
    const auto says = [](GuardianProblem which) {
        return "problem " + std::to_string(static_cast<int>(which));
    };
    EXPECT_EQ(problem("/no/such/nmcguard"), says(GuardianProblem::Missing));
    EXPECT_EQ(problem("/bin/false"), says(GuardianProblem::WrongVersion));
    const std::string notForUs = folder.path() + "/nmcguard";
    std::ofstream(notForUs) << "#!/bin/sh\n";
    ASSERT_EQ(::chmod(notForUs.c_str(), 0600), 0);
    EXPECT_EQ(problem(notForUs), says(GuardianProblem::NotPermitted));
}

}  // namespace
}  // namespace nmc
