// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/time.h"

namespace nmc::conformance {

using Bytes = std::vector<std::uint8_t>;

/// One servo tick (DS-V 3.1: 1953.12 Hz).
inline constexpr Duration kTick = std::chrono::microseconds(512);

/// A simulated chain and the host's port to it, in virtual time: nothing happens except in wait(). Offers
/// what a host can do, and control lines for what only a test bench has: switches, loads and the true state.
class Rig {
public:
    virtual ~Rig() = default;

    /// Bytes leave the host's port from now on, back to back.
    virtual void send(const Bytes& bytes) = 0;
    /// Lets time pass; returns what has arrived since the last call.
    virtual Bytes wait(Duration time) = 0;
    virtual void setBaud(unsigned baud) = 0;
    /// Sends one control line of simulator.md and returns its answer.
    virtual nlohmann::json control(const std::string& line) = 0;

    void waitTicks(int ticks) { wait(kTick * ticks); }
    /// Sends `bytes` and returns the answer within 20 ms, which is enough for the longest at 19 200 Bd.
    Bytes exchange(const Bytes& bytes);
    /// Sends a command packet with its sum and returns the answer; `command` is the whole command byte.
    Bytes command(unsigned address, unsigned command, const Bytes& data = {});
    /// Assigns the addresses 1, 2 ... to the modules, in group FF without a leader.
    void address(unsigned count);
    nlohmann::json state(int module = 1) { return control("state " + std::to_string(module)); }
    /// Sends a control line that must succeed.
    void must(const std::string& line);
    /// The kinds of the violations so far.
    std::vector<std::string> violations() { return kinds("violations"); }
    /// The kinds of the remarks so far.
    std::vector<std::string> remarks() { return kinds("remarks"); }

private:
    std::vector<std::string> kinds(const char* list);
};

/// A packet with its sum, made independently of the program's code.
[[nodiscard]] Bytes packet(unsigned address, unsigned command, const Bytes& data = {});
/// The 8-bit sum of `bytes`, as the byte that follows them.
[[nodiscard]] Bytes sumOf(const Bytes& bytes);
/// `value` in `count` bytes, least significant first.
[[nodiscard]] Bytes little(std::uint32_t value, int count);
[[nodiscard]] Bytes operator+(Bytes left, const Bytes& right);

// Fields of an answer, which begins with its status byte; 0 and a test failure if it is too short.
[[nodiscard]] unsigned byteAt(const Bytes& answer, std::size_t at);
[[nodiscard]] unsigned wordAt(const Bytes& answer, std::size_t at);
[[nodiscard]] std::int32_t longAt(const Bytes& answer, std::size_t at);

/// Where the chain is simulated: the scenarios are the same.
enum class Place { InProcess, Terminal };

/// A chain that has just been switched on, past the time in which a module is deaf. `options` are nmcsim's,
/// by their long names: "--enable-faults" and the like.
[[nodiscard]] std::unique_ptr<Rig> makeRig(Place place, const std::string& chain,
                                           const std::vector<std::string>& options = {});

}  // namespace nmc::conformance
