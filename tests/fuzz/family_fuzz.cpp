// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of PIC-SERVO CMC and SC and of PIC-I/O.
#include "tests/fuzz/commandsession.h"

namespace {

constexpr std::array kNames{"limit1", "limit2", "limits",   "travel_max", "vsense", "steps",
                            "load",   "index",  "in 1",     "in 10",      "in 12",  "in 13",
                            "analog", "power",  "analog 1", "analog 3"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    nmc::fuzz::runTwice("servo@10,io,servo@5,servo@10", kNames, {data, size});
    return 0;
}
