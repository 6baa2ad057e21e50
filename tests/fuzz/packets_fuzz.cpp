// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a packet log, and as packets: a log that was read is read the same again after it was written,
// anything else is refused with a sentence, and whatever the bytes are, they are described.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "model/packets/packetfile.h"
#include "protocol/describe.h"
#include "tests/support/packetfilereader.h"

namespace {

void require(bool condition) {
    if (!condition)
        std::abort();
}

void readAgain(const nmc::PacketFile& file) {
    nmc::PacketLog log;
    log.begin(file.session);
    for (const nmc::PacketEntry& entry : file.entries) {
        if (entry.afterGap)
            log.interrupt();
        log.append(entry.record);
    }
    const std::string text = nmc::writePacketFile(log);
    const auto again = nmc::parsePacketFile(text);
    require(again.has_value() && again->entries.size() == file.entries.size());
    for (std::size_t i = 0; i < file.entries.size(); ++i) {
        require(again->entries[i].afterGap == file.entries[i].afterGap);
        require(again->entries[i].record.command == file.entries[i].record.command);
        require(again->entries[i].record.reply == file.entries[i].record.reply);
        require(again->entries[i].record.sent == file.entries[i].record.sent);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const nmc::ByteSpan bytes(data, size);
    const std::string text(bytes.begin(), bytes.end());
    if (const auto file = nmc::parsePacketFile(text))
        readAgain(*file);
    else
        require(file.error().ends_with('.'));
    const nmc::StatusItems items(bytes.empty() ? std::uint8_t{0} : bytes[0]);
    using nmc::ModuleType;
    for (const nmc::ModuleIdentity& module :
         {nmc::ModuleIdentity{ModuleType::Servo, 4}, nmc::ModuleIdentity{ModuleType::Servo, 10},
          nmc::ModuleIdentity{ModuleType::Stepper, 1}, nmc::ModuleIdentity{ModuleType::Io, 1}}) {
        require(nmc::describeCommand(module, bytes).empty() == bytes.empty());
        require(nmc::describeReply(module, items, bytes).empty() == bytes.empty());
    }
    return 0;
}
