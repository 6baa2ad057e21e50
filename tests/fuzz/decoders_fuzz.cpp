// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a packet, as a payload and as a reply: nothing is read that is not there, and what was
// understood encodes to what it was read from.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "protocol/commands.h"
#include "protocol/frame.h"
#include "protocol/status.h"

namespace {

void expect(bool condition) {
    if (!condition)
        std::abort();
}

void decodePacket(nmc::ByteSpan bytes) {
    const auto frame = nmc::parsePacket(bytes);
    if (!frame)
        return;
    const nmc::PacketBytes again = nmc::toPacket(*frame);
    expect(nmc::toHex(again) == nmc::toHex(bytes));
    if (const auto command = nmc::decodeServoCommand(frame->payload))
        expect(nmc::decodeServoCommand(nmc::encode(*command)) == command);
    if (const auto command = nmc::decodeStepCommand(frame->payload))
        expect(nmc::decodeStepCommand(nmc::encode(*command)) == command);
}

void decodeReply(nmc::ByteSpan bytes) {
    if (bytes.empty())
        return;
    const nmc::StatusItems items(bytes[0]);
    for (const nmc::ModuleType type : {nmc::ModuleType::Servo, nmc::ModuleType::Step})
        if (const auto report = nmc::decodeStatus(type, items, bytes.subspan(1)))
            expect(bytes.size() - 1 == nmc::replyLength(type, items) && report->status == bytes[1]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    decodePacket({data, size});
    decodeReply({data, size});
    return 0;
}
