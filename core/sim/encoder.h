// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc::sim {

/// The PIC-ENC's 16-bit up/down counter and the servo chip's extension of it to 32 bits (DS-V 4.2).
class Encoder {
public:
    /// The most edges that the PIC-ENC can follow: 500 000 per second (DS-V 3.2), times 512 us.
    static constexpr std::int64_t kMaxEdgesPerTick = 256;
    /// CMC and SC have their own counter, which follows up to their maximum velocity (docs/family.md).
    static constexpr std::int64_t kLaterMaxEdgesPerTick = 1280;
    explicit Encoder(std::int64_t maxEdgesPerTick = kMaxEdgesPerTick) : m_maxEdges(maxEdgesPerTick) {}

    /// Called once per maximum-rate tick with the shaft's true position in counts. Edges that come too fast
    /// are lost.
    void read(std::int64_t shaft);
    /// Reset Position: sets the counter and its extension to this value.
    void setPosition(std::int32_t position);
    void reset() { setPosition(0); }

    [[nodiscard]] std::int32_t position() const { return m_position; }
    [[nodiscard]] bool wrapped() const { return m_wrapped; }
    void clearWrapped() { m_wrapped = false; }
    /// While reversed, the encoder counts down when the shaft turns forwards.
    void setReversed(bool reversed) { m_reversed = reversed; }

private:
    std::int64_t m_maxEdges;
    std::int64_t m_shaft = 0;
    std::int32_t m_position = 0;
    std::uint16_t m_counter = 0;
    std::uint16_t m_lastRead = 0;
    bool m_wrapped = false;
    bool m_reversed = false;
};

}  // namespace nmc::sim
