// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/ports/networkline.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using Protocol = NetworkLine::Protocol;

TEST(NetworkLine, HasAProtocolAHostAndAPort) {
    EXPECT_EQ(parseNetworkLine("tcp://bench:4001"), (NetworkLine{Protocol::Raw, "bench", 4'001}));
    EXPECT_EQ(parseNetworkLine("rfc2217://10.0.0.7:23"), (NetworkLine{Protocol::Rfc2217, "10.0.0.7", 23}));
    EXPECT_EQ(parseNetworkLine("tcp://[fe80::1%eth0]:65535"),
              (NetworkLine{Protocol::Raw, "fe80::1%eth0", 65'535}));
}

TEST(NetworkLine, IsNothingElse) {
    for (const char* name : {"", "tcp", "/dev/ttyUSB0", "simulator", "http://bench:80", "TCP://bench:1"}) {
        EXPECT_FALSE(isNetworkName(name)) << name;
        EXPECT_FALSE(parseNetworkLine(name)) << name;
    }
    for (const char* name :
         {"tcp://", "tcp://bench", "tcp://bench:", "tcp://:4001", "tcp://bench:0", "tcp://bench:65536",
          "tcp://bench:-1", "tcp://bench:40x", "tcp://bench:4001/", "tcp://be nch:4001",
          "tcp://user@bench:4001", "tcp://fe80::1:4001", "tcp://[bench]:4001", "tcp://[]:4001",
          "tcp://[::1:4001", "rfc2217://bench:4001?x"}) {
        EXPECT_TRUE(isNetworkName(name)) << name;
        EXPECT_FALSE(parseNetworkLine(name)) << name;
    }
}

}  // namespace
}  // namespace nmc
