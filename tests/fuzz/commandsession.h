// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Well-formed commands with any contents, the world around the modules, and time: these reach what lies
// behind the checksum. No crash, no unbounded memory, the same history every time.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/baud.h"
#include "sim/chain.h"
#include "sim/chainspec.h"
#include "sim/control.h"

namespace nmc::fuzz {

using std::chrono::milliseconds;

/// The fuzzer's bytes, one after the other; zeros after the end.
class Input {
public:
    explicit Input(nmc::ByteSpan bytes) : m_bytes(bytes) {}
    [[nodiscard]] bool atEnd() const { return m_at >= m_bytes.size(); }
    std::uint8_t next() { return atEnd() ? std::uint8_t{0} : m_bytes[m_at++]; }
    template <typename T, std::size_t N>
    T oneOf(const std::array<T, N>& values) {
        return values[next() % N];
    }

private:
    nmc::ByteSpan m_bytes;
    std::size_t m_at = 0;
};

inline constexpr std::array kWords{"0", "1", "auto", "none", "manual", "255", "1e-6", "-100", "100", "nan"};
inline constexpr std::array kRates{19'200U, 115'200U, 57'600U, 9'600U, 1U, 4'000'000U};

/// `Names` are what `set` is tried with.
template <typename Names>
class Session {
public:
    Session(std::string_view chain, const Names& names)
        : m_chain(nmc::sim::parseChain(chain).value()), m_names(names) {}

    /// Returns everything that was seen: what a host hears, and the answers to control lines.
    std::string run(nmc::ByteSpan bytes) {
        Input input(bytes);
        wait(20);  // past the dead time after power-up
        for (unsigned i = 1; i <= m_chain.moduleCount(); ++i) {
            command({0, 0x21, static_cast<std::uint8_t>(i), 0xFF});
            wait(5);
        }
        while (!input.atEnd())
            step(input);
        wait(100);
        for (std::size_t i = 1; i <= m_chain.moduleCount(); ++i)
            say("state " + std::to_string(i));
        say("stats");
        return std::move(m_seen);
    }

private:
    void step(Input& input) {
        const std::string module = " " + std::to_string(1 + input.next() % m_chain.moduleCount());
        switch (input.next() % 16) {
            case 0:
                return say("power-cycle" + module);
            case 1:
                return say("break" + module);
            case 2:
                return say("mend" + module);
            case 3: {
                const std::string name = input.oneOf(m_names);
                return say("set" + module + " " + name + " " + input.oneOf(kWords));
            }
            case 4: {
                const std::string name = input.oneOf(m_names);
                const int value = input.next() - 128;
                return say("set" + module + " " + name + " " +
                           std::to_string(value * (1 << input.next() % 16)));
            }
            case 5:
                return m_chain.setHostBaud(input.oneOf(kRates));
            case 6:
                return wait(input.next());
            case 7:
                m_chain.hostSends(std::array{input.next()}, m_now);
                return;
            default:
                break;
        }
        // Address, command byte, data; the address is mostly one that exists.
        const std::uint8_t address = input.next();
        std::vector<std::uint8_t> body{address < 0xC0 ? static_cast<std::uint8_t>(address % 6) : address,
                                       input.next()};
        for (int i = body[1] >> 4; i > 0; --i)
            body.push_back(input.next());
        command(body);
        wait(input.next() / 4);
    }

    void command(std::vector<std::uint8_t> body) {
        body.push_back(nmc::sum8(body));
        body.insert(body.begin(), 0xAA);
        m_chain.hostSends(body, m_now);
    }
    void wait(int ms) {
        m_now += milliseconds(ms);
        m_chain.advanceTo(m_now);
        for (const nmc::sim::HostByte& byte : m_chain.takeHostBytes())
            m_seen += static_cast<char>(byte.value);
    }
    void say(const std::string& line) { m_seen += handleControlLine(m_chain, line, m_now); }

    nmc::sim::Chain m_chain;
    const Names& m_names;
    nmc::TimePoint m_now;
    std::string m_seen;
};

/// The history must be the same every time. A step takes two bytes or more; its answer is at most 19 bytes
/// from each module, or a line. Then come the states and the violations, of which the log keeps a limited
/// number.
template <typename Names>
void runTwice(std::string_view chain, const Names& names, nmc::ByteSpan input) {
    if (input.size() > 1'000)
        return;  // longer inputs find nothing new and are slow
    const std::string seen = Session(chain, names).run(input);
    if (seen.size() > 300'000 + 200 * input.size() || seen != Session(chain, names).run(input))
        std::abort();
}

}  // namespace nmc::fuzz
