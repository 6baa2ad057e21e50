// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a packet, as a payload and as a reply: nothing is read beyond their end, and what was
// understood is encoded as it was read.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "protocol/commands.h"
#include "protocol/frame.h"
#include "protocol/status.h"
#include "tests/support/pathwords.h"

namespace {

void expect(bool condition) {
    if (!condition)
        std::abort();
}

/// One of each layout.
constexpr std::array<nmc::ModuleIdentity, 6> kModules{{{nmc::ModuleType::Servo, 1},
                                                       {nmc::ModuleType::Servo, 4},
                                                       {nmc::ModuleType::Servo, 5},
                                                       {nmc::ModuleType::Servo, 10},
                                                       {nmc::ModuleType::Io, 1},
                                                       {nmc::ModuleType::Stepper, 1}}};

/// A word that is a point is encoded as it was decoded, except for the sign of zero.
void expectWholePath(const nmc::ServoCommand& command) {
    const auto* add = std::get_if<nmc::servo::AddPathPoints>(&command);
    if (add == nullptr)
        return;
    for (const std::uint16_t word : add->words())
        for (const bool fastPath : {false, true})
            if (const auto point = nmc::test::fromPathWord(word, fastPath); point && point->counts != 0)
                expect(nmc::servo::toPathWord(*point, fastPath) == word);
}

void decodePacket(nmc::ByteSpan bytes) {
    const auto frame = nmc::parsePacket(bytes);
    if (!frame)
        return;
    const nmc::PacketBytes again = nmc::toPacket(*frame);
    expect(nmc::toHex(again) == nmc::toHex(bytes));
    for (const nmc::ModuleIdentity& module : kModules)
        if (const auto command = nmc::decodeServoCommand(module, frame->payload)) {
            expect(nmc::decodeServoCommand(module, nmc::encode(*command)) == command);
            expectWholePath(*command);
        }
    if (const auto command = nmc::decodeIoCommand(frame->payload))
        expect(nmc::decodeIoCommand(nmc::encode(*command)) == command);
    if (const auto command = nmc::decodeStepCommand(frame->payload))
        expect(nmc::decodeStepCommand(nmc::encode(*command)) == command);
}

void decodeReply(nmc::ByteSpan bytes) {
    if (bytes.empty())
        return;
    const nmc::StatusItems items(bytes[0]);
    for (const nmc::ModuleIdentity& module : kModules)
        if (const auto report = nmc::decodeStatus(module, items, bytes.subspan(1)))
            expect(bytes.size() - 1 == nmc::replyLength(module, items) && report->status == bytes[1]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    decodePacket({data, size});
    decodeReply({data, size});
    return 0;
}
