// SPDX-License-Identifier: GPL-3.0-or-later
// What a crash sends, and at which rate: the port may be at another rate than the chain.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "link/connection/crashburst.h"
#include "link/ports/linerate.h"
#include "link/terminal/ptyserver.h"

namespace nmc {
namespace {

class CrashAt : public testing::TestWithParam<std::uint32_t> {};

TEST_P(CrashAt, TheRateOfTheChainWhateverThePortIsAt) {
    const auto terminal = PtyServer::create({});  // at 19 200
    ASSERT_TRUE(terminal);
    const std::vector<std::uint8_t> stop{0x00, 0x00, 0xAA, 0x01, 0x17, 0x05, 0x1D, 0x00};
    const pid_t panel = ::fork();
    if (panel == 0) {
        const int port = ::open(terminal->path().c_str(), O_RDWR | O_NOCTTY);
        crashburst::installHandlers();
        crashburst::arm(port, stop, GetParam());
        std::abort();
    }
    int status = 0;
    ::waitpid(panel, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT) << "the crash must not be hidden";
    EXPECT_EQ(lineRate(terminal->fd()), GetParam());
    std::vector<std::uint8_t> twice = stop;
    twice.insert(twice.end(), stop.begin(), stop.end());
    EXPECT_EQ(toHex(terminal->read()), toHex(twice));
}

INSTANTIATE_TEST_SUITE_P(H03, CrashAt, testing::Values(9'600U, 19'200U, 57'600U, 115'200U));

}  // namespace
}  // namespace nmc
