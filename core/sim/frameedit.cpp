// SPDX-License-Identifier: MIT
#include "sim/frameedit.h"

#include "sim/line.h"

namespace nmc::sim {

namespace {

constexpr unsigned kBits = 8;

std::uint8_t mask(unsigned bit) {
    return static_cast<std::uint8_t>(1U << bit);
}

/// Two wrong bits of the same weight leave the sum right when they change in opposite directions, or when one
/// of them belongs to the sum itself and changes in the same direction; the carry of bit 7 is lost anyway.
std::optional<FrameEdit> collision(const FrameInSight& frame, Random& random) {
    struct Pair {
        std::size_t one, other;
        unsigned bit;
    };
    if (frame.bytes.size() < frame.length)
        return std::nullopt;
    std::vector<Pair> pairs;
    const auto isLength = [&](std::size_t i, unsigned bit) {
        return frame.isPacket && i == kCommandByteAt && bit >= 4;
    };
    const std::size_t last = frame.length - 1;
    for (std::size_t i = std::max<std::size_t>(frame.first, frame.isPacket ? 1 : 0); i < last; ++i)
        for (std::size_t j = i + 1; j <= last; ++j)
            for (unsigned bit = 0; bit < kBits; ++bit) {
                const bool alike = ((frame.bytes[i] ^ frame.bytes[j]) & mask(bit)) == 0;
                const bool keepsSum = bit == kBits - 1 || alike == (j == last);
                if (keepsSum && !isLength(i, bit) && !isLength(j, bit))
                    pairs.push_back({i, j, bit});
            }
    if (pairs.empty())
        return std::nullopt;
    const Pair pair = pairs[random.below(pairs.size())];
    FrameEdit edit;
    edit.at[pair.one].flips = edit.at[pair.other].flips = mask(pair.bit);
    return edit;
}

}  // namespace

std::vector<std::uint8_t> FrameEdit::applied(ByteSpan frame) const {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < frame.size(); ++i)
        bytes.insert(bytes.end(), at[i].copies, static_cast<std::uint8_t>(frame[i] ^ at[i].flips));
    return bytes;
}

std::optional<FrameEdit> makeEdit(FaultKind kind, const FrameInSight& frame, std::optional<unsigned> bit,
                                  Random& random) {
    if (kind == FaultKind::Collide)
        return collision(frame, random);
    const auto indexFrom = [&](std::size_t first) { return first + random.below(frame.length - first); };
    FrameEdit edit;
    if (kind == FaultKind::Drop) {
        edit.at[indexFrom(frame.first)].copies = 0;
    } else if (kind == FaultKind::Dup) {
        edit.at[indexFrom(frame.first)].copies = 2;
    } else if (kind == FaultKind::Flip) {
        const std::size_t which = bit ? *bit / kBits : indexFrom(frame.first);
        if (which < frame.first || which >= frame.length)
            return std::nullopt;
        edit.at[which].flips = mask(bit ? *bit % kBits : static_cast<unsigned>(random.below(kBits)));
    } else if (kind == FaultKind::Truncate) {
        for (std::size_t i = indexFrom(std::max<std::size_t>(frame.first, 1)); i < frame.length; ++i)
            edit.at[i].copies = 0;
    } else if (kind == FaultKind::Garbage) {
        for (std::size_t i = frame.first; i < frame.length; ++i)
            edit.at[i].flips = static_cast<std::uint8_t>(random.below(256));
    } else if (kind == FaultKind::Overrun) {
        // The byte after the lost one reports the overrun, so it must exist.
        const std::size_t from = std::max<std::size_t>(frame.first, 1);
        const std::size_t lost = from + random.below(frame.length - 1 - from);
        edit.at[lost].copies = 0;
        edit.at[lost + 1].error = true;
    }
    return edit;
}

}  // namespace nmc::sim
