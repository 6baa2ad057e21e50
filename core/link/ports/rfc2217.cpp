// SPDX-License-Identifier: MIT
#include "link/ports/rfc2217.h"

#include <array>

namespace nmc {

namespace {

// RFC 854
constexpr std::uint8_t kSe = 240, kSb = 250, kWill = 251, kWont = 252, kDo = 253, kDont = 254, kIac = 255;
// RFC 856, RFC 858 and RFC 2217
constexpr std::uint8_t kBinary = 0, kSuppressGoAhead = 3, kComPort = 44;
// RFC 2217, commands of the client; the server's answer to one is 100 more.
constexpr std::uint8_t kSetBaud = 1, kSetDataSize = 2, kSetParity = 3, kSetStopSize = 4, kSetControl = 5,
                       kPurgeData = 12, kAnswer = 100;
constexpr std::uint8_t kEightBits = 8, kNoParity = 1, kOneStopBit = 1, kNoFlowControl = 1, kReceiveBuffer = 1;

/// The longest answer is that of the rate; servers may also send texts, which are ignored.
constexpr std::size_t kLongestSubnegotiation = 64;

[[nodiscard]] bool isVerb(std::uint8_t byte) {
    return byte >= kWill && byte <= kDont;
}

}  // namespace

Rfc2217::Rfc2217() {
    say({kIac, kWill, kComPort});
    for (const std::uint8_t option : {kBinary, kSuppressGoAhead})
        say({kIac, kWill, option, kIac, kDo, option});
    for (const auto& [command, value] : {std::pair{kSetDataSize, kEightBits},
                                         {kSetParity, kNoParity},
                                         {kSetStopSize, kOneStopBit},
                                         {kSetControl, kNoFlowControl}})
        say(ofPort(command, {&value, 1}));
}

std::vector<std::uint8_t> Rfc2217::encoded(ByteSpan bytes) {
    std::vector<std::uint8_t> wire;
    wire.reserve(bytes.size() + 4);
    for (const std::uint8_t byte : bytes) {
        wire.push_back(byte);
        if (byte == kIac)
            wire.push_back(kIac);
    }
    return wire;
}

std::vector<std::uint8_t> Rfc2217::ofPort(std::uint8_t command, ByteSpan value) {
    std::vector<std::uint8_t> text{kIac, kSb, kComPort, command};
    const std::vector<std::uint8_t> data = encoded(value);
    text.insert(text.end(), data.begin(), data.end());
    text.insert(text.end(), {kIac, kSe});
    return text;
}

std::vector<std::uint8_t> Rfc2217::settingBaud(std::uint32_t baud) {
    const std::array<std::uint8_t, 4> value{
        static_cast<std::uint8_t>(baud >> 24U), static_cast<std::uint8_t>(baud >> 16U),
        static_cast<std::uint8_t>(baud >> 8U), static_cast<std::uint8_t>(baud)};
    return ofPort(kSetBaud, value);
}

void Rfc2217::setBaud(std::uint32_t baud) {
    m_baud.reset();
    say(settingBaud(baud));
}

void Rfc2217::purgeInput() {
    say(ofPort(kPurgeData, {&kReceiveBuffer, 1}));
}

std::vector<std::uint8_t> Rfc2217::take(ByteSpan received) {
    std::vector<std::uint8_t> data;
    for (const std::uint8_t byte : received) {
        switch (m_state) {
            case State::Data:
                if (byte == kIac)
                    m_state = State::Command;
                else
                    data.push_back(byte);
                break;
            case State::Command:
                m_state = State::Data;
                if (byte == kIac) {
                    data.push_back(kIac);
                } else if (isVerb(byte)) {
                    m_verb = byte;
                    m_state = State::Option;
                } else if (byte == kSb) {
                    m_subnegotiation.clear();
                    m_state = State::Subnegotiation;
                }
                break;
            case State::Option:
                answer(m_verb, byte);
                m_state = State::Data;
                break;
            case State::Subnegotiation:
                if (byte == kIac)
                    m_state = State::SubnegotiationCommand;
                else if (m_subnegotiation.size() < kLongestSubnegotiation)
                    m_subnegotiation.push_back(byte);
                break;
            case State::SubnegotiationCommand:
                m_state = byte == kSe ? State::Data : State::Subnegotiation;
                if (byte == kSe)
                    takeSubnegotiation();
                else if (byte == kIac && m_subnegotiation.size() < kLongestSubnegotiation)
                    m_subnegotiation.push_back(kIac);
                break;
        }
    }
    return data;
}

/// What was asked for needs no answer; everything else is declined.
void Rfc2217::answer(std::uint8_t verb, std::uint8_t option) {
    const bool asked = option == kBinary || option == kSuppressGoAhead;
    if (option == kComPort && (verb == kDo || verb == kDont))
        m_agreed = verb == kDo;
    else if (verb == kDo && !asked && m_answered.emplace(verb, option).second)
        say({kIac, kWont, option});
    else if (verb == kWill && !asked && m_answered.emplace(verb, option).second)
        say({kIac, kDont, option});
}

void Rfc2217::takeSubnegotiation() {
    const auto& text = m_subnegotiation;
    if (text.size() != 6 || text[0] != kComPort || text[1] != kSetBaud + kAnswer)
        return;
    m_baud = static_cast<std::uint32_t>(text[2]) << 24U | static_cast<std::uint32_t>(text[3]) << 16U |
             static_cast<std::uint32_t>(text[4]) << 8U | static_cast<std::uint32_t>(text[5]);
}

}  // namespace nmc
