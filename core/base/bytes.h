// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>

namespace nmc {

using ByteSpan = std::span<const std::uint8_t>;

/// A byte string of fixed capacity that never allocates. Calling push_back beyond the capacity is a
/// programming error.
template <std::size_t Capacity>
class ByteBuffer {
public:
    constexpr ByteBuffer() = default;
    constexpr ByteBuffer(std::initializer_list<std::uint8_t> bytes) {
        for (std::uint8_t b : bytes)
            push_back(b);
    }
    constexpr explicit ByteBuffer(ByteSpan bytes) { append(bytes); }

    constexpr void push_back(std::uint8_t b) {
        assert(m_size < Capacity);
        m_bytes[m_size++] = b;
    }
    constexpr void append(ByteSpan bytes) {
        for (std::uint8_t b : bytes)
            push_back(b);
    }
    /// Appends as many of the bytes as there is room for.
    constexpr void appendWhatFits(ByteSpan bytes) {
        append(bytes.first(std::min(bytes.size(), Capacity - m_size)));
    }
    /// Appends `value` least significant byte first, the byte order of everything on this bus.
    template <std::integral T>
    constexpr void appendLittleEndian(T value) {
        auto rest = static_cast<std::make_unsigned_t<T>>(value);
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            push_back(static_cast<std::uint8_t>(rest & 0xFFU));
            if constexpr (sizeof(T) > 1)
                rest = static_cast<std::make_unsigned_t<T>>(rest >> 8U);
        }
    }
    constexpr void clear() { m_size = 0; }

    [[nodiscard]] constexpr std::size_t size() const { return m_size; }
    [[nodiscard]] constexpr bool empty() const { return m_size == 0; }
    [[nodiscard]] constexpr std::uint8_t operator[](std::size_t i) const { return m_bytes[i]; }
    [[nodiscard]] constexpr const std::uint8_t* data() const { return m_bytes.data(); }
    [[nodiscard]] constexpr const std::uint8_t* begin() const { return m_bytes.data(); }
    [[nodiscard]] constexpr const std::uint8_t* end() const { return m_bytes.data() + m_size; }

    friend constexpr bool operator==(const ByteBuffer& a, const ByteBuffer& b) {
        return std::ranges::equal(a, b);
    }

private:
    std::array<std::uint8_t, Capacity> m_bytes{};
    std::size_t m_size = 0;
};

/// Reads a T from the first sizeof(T) bytes, least significant byte first. The span must be long enough.
template <std::integral T>
[[nodiscard]] constexpr T readLittleEndian(ByteSpan bytes) {
    assert(bytes.size() >= sizeof(T));
    std::uint64_t value = 0;
    for (std::size_t i = sizeof(T); i-- > 0;)
        value = value << 8U | bytes[i];
    return static_cast<T>(static_cast<std::make_unsigned_t<T>>(value));
}

/// The bus checksum: the 8-bit sum of the bytes.
[[nodiscard]] constexpr std::uint8_t sum8(ByteSpan bytes) {
    return static_cast<std::uint8_t>(std::accumulate(bytes.begin(), bytes.end(), 0U) & 0xFFU);
}

/// "AA 01 0E 0F": upper-case hexadecimal, one space between bytes.
[[nodiscard]] inline std::string toHex(ByteSpan bytes) {
    static constexpr char kDigits[] = "0123456789ABCDEF";
    std::string text;
    text.reserve(bytes.size() * 3);
    for (std::uint8_t b : bytes) {
        if (!text.empty())
            text += ' ';
        text += kDigits[b >> 4U];
        text += kDigits[b & 0xFU];
    }
    return text;
}

}  // namespace nmc
