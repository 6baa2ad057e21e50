// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/wire.h"

#include <algorithm>

namespace nmc::test {

namespace {

constexpr std::uint8_t kHeaderByte = 0xAA;
constexpr std::size_t kShortest = 4;  // header, address, command, checksum

}  // namespace

std::optional<CommandCode> WireItem::code() const {
    if (packet.size() < kShortest)
        return std::nullopt;
    return static_cast<CommandCode>(packet[2] & 0x0FU);
}

std::vector<WireItem> itemsOf(ByteSpan bytes, TimePoint time, std::uint32_t baud) {
    std::vector<WireItem> items;
    for (std::size_t at = 0; at < bytes.size();) {
        WireItem item{time, baud, {}, 0, 0};
        if (bytes[at] == kHeaderByte) {
            const std::size_t announced = at + 2 < bytes.size() ? bytes[at + 2] >> 4U : 0U;
            const std::size_t end = std::min(at + kShortest + announced, bytes.size());
            item.packet.assign(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                               bytes.begin() + static_cast<std::ptrdiff_t>(end));
            at = end;
        } else {
            for (; at < bytes.size() && bytes[at] != kHeaderByte; ++at)
                ++item.nulls;
        }
        items.push_back(std::move(item));
    }
    return items;
}

}  // namespace nmc::test
