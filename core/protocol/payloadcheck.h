// SPDX-License-Identifier: MIT
#pragma once

// Shared by the command decoders; not for others.

#include <optional>

#include "protocol/commanderror.h"
#include "protocol/frame.h"

namespace nmc::detail {

/// What is wrong with a payload that should have this code and this many data bytes.
[[nodiscard]] inline std::optional<CommandError> checkPayload(const Payload& payload, CommandCode code,
                                                              std::size_t minData, std::size_t maxData) {
    if (payload.code != code)
        return CommandError::WrongCode;
    if (payload.data.size() < minData || payload.data.size() > maxData)
        return CommandError::Length;
    return std::nullopt;
}

/// The byte with bit i set where flag i is.
template <typename... Flags>
[[nodiscard]] constexpr std::uint8_t packBits(Flags... flags) {
    unsigned bits = 0;
    unsigned bit = 1;
    ((bits |= flags ? bit : 0U, bit <<= 1U), ...);
    return static_cast<std::uint8_t>(bits);
}

[[nodiscard]] constexpr bool bitOf(std::uint8_t byte, unsigned bit) {
    return (unsigned{byte} >> bit & 1U) != 0;
}

/// Takes multi-byte values off the front of a payload's data. The caller has checked the length.
class DataReader {
public:
    explicit DataReader(ByteSpan data) : m_rest(data) {}
    template <std::integral T>
    [[nodiscard]] T take() {
        const T value = readLittleEndian<T>(m_rest);
        m_rest = m_rest.subspan(sizeof(T));
        return value;
    }

private:
    ByteSpan m_rest;
};

}  // namespace nmc::detail
