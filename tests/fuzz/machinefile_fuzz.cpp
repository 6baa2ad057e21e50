// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a machine file: what was read is the same after it was written, and writing it again changes
// nothing; anything else is refused with the number of an existing line.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "model/machinefile/machinefile.h"

namespace {

void require(bool condition) {
    if (!condition)
        std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    const auto parsed = nmc::parseMachine(text);
    if (!parsed) {
        require(parsed.error().line >= 1 &&
                parsed.error().line <= 1 + std::count(text.begin(), text.end(), '\n'));
        return 0;
    }
    const std::string once = nmc::writeMachine(parsed->machine, parsed->unknown);
    const auto again = nmc::parseMachine(once);
    require(again.has_value() && again->machine == parsed->machine);
    require(nmc::writeMachine(again->machine, again->unknown) == once);
    return 0;
}
