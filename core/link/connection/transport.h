// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/bytes.h"
#include "base/time.h"
#include "link/ports/porterror.h"

namespace nmc {

/// The connection to a chain: a serial port, one behind a network, or the simulator in this process. It lives
/// entirely in the bus thread, which has no event loop: receive() is the only place to wait. An error is
/// final; the transport is then discarded.
class Transport {
public:
    using Received = tl::expected<std::vector<std::uint8_t>, PortError>;

    Transport() = default;
    virtual ~Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;

    virtual tl::expected<void, PortError> open() = 0;
    virtual tl::expected<void, PortError> setBaud(std::uint32_t baud) = 0;
    /// Passes the bytes to the port immediately; does not wait until they are sent.
    virtual tl::expected<void, PortError> send(ByteSpan bytes) = 0;
    virtual void discardInput() = 0;

    /// Waits for bytes, for `until`, or for `wakeFd` to become readable (it is not read), whichever comes
    /// first. Returns an empty vector when nothing arrived.
    virtual Received receive(std::optional<TimePoint> until, int wakeFd) = 0;

    /// The descriptor that a signal handler may write to when the process crashes; -1 where there is none.
    [[nodiscard]] virtual int fd() const { return -1; }

    /// The bytes that must be written to fd() so that the chain receives these at this rate, unless a driver
    /// sets it.
    [[nodiscard]] virtual std::vector<std::uint8_t> onWire(ByteSpan bytes, std::uint32_t /*baud*/) const {
        return {bytes.begin(), bytes.end()};
    }
    /// setBaud() does nothing: the rate is set elsewhere.
    [[nodiscard]] virtual bool hasFixedRate() const { return false; }
    /// The delay of the connection as measured by open(); 0: not measured.
    [[nodiscard]] virtual Duration latency() const { return {}; }

    /// Answers one control line of the simulator with one line of JSON (sim/control.h). Returns nothing for a
    /// port, because a program cannot change what is on the bench.
    virtual std::optional<std::string> control(std::string_view /*line*/) { return std::nullopt; }
};

}  // namespace nmc
