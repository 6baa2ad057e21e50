// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes on the line of a simulated chain: no crash, no unbounded memory, the same answer every time.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "protocol/baud.h"
#include "sim/chain.h"

namespace {

std::vector<std::uint8_t> answerOf(nmc::ByteSpan input) {
    nmc::sim::Chain chain(
        {{nmc::ModuleType::Servo, 4}, {nmc::ModuleType::Stepper, 1}, {nmc::ModuleType::Servo, 1}});
    nmc::TimePoint now{};
    now += std::chrono::milliseconds(20);  // past the dead time after power-up
    std::vector<std::uint8_t> answer;
    const auto listen = [&] {
        chain.advanceTo(now);
        for (const nmc::sim::HostByte& byte : chain.takeHostBytes())
            answer.push_back(byte.value);
    };
    // A byte of 0x55 is a pause in which an answer can come, followed by its length in ms.
    for (std::size_t i = 0; i < input.size(); ++i) {
        if (input[i] == 0x55 && i + 1 < input.size()) {
            now += std::chrono::milliseconds(input[++i]);
            listen();
            continue;
        }
        chain.hostSends(input.subspan(i, 1), now);
        now += nmc::byteTimeAtBaud(nmc::kPowerUpBaud);
    }
    now += std::chrono::milliseconds(100);
    listen();
    return answer;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 2'000)
        return 0;  // longer inputs find nothing new and are slow
    const nmc::ByteSpan input{data, size};
    const std::vector<std::uint8_t> answer = answerOf(input);
    // Three modules, one answer at a time, at most 16 bytes each for four bytes heard.
    if (answer.size() > 8 * (size + 1) || answer != answerOf(input))
        std::abort();
    return 0;
}
