// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the two data sheets.
#include "tests/fuzz/commandsession.h"

namespace {

constexpr std::array kNames{"limit1",  "limit2",   "index",      "power",      "analog", "load",
                            "inertia", "friction", "travel_min", "limits",     "estop",  "home_switch",
                            "in1",     "in2",      "travel_max", "temperature"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    nmc::fuzz::runTwice("servo,step,servo@1,servo@3", kNames, {data, size});
    return 0;
}
