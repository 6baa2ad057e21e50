// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "bus/types.h"

namespace nmc::bus {

/// Asymmetric trust (link.md 2.4): one reply is enough to warn or to stop; two in a row, of different length,
/// are needed to permit. What permits is: standstill, power on, a limit or the E-stop input released, homing
/// over. Until the second reply, such a bit is passed on unchanged. One object per module. Pure.
class Trust {
public:
    explicit Trust(const ModuleIdentity& module) : m_module(module) {}

    /// The report as it may be believed and displayed; empty for the very first one, which alone permits
    /// nothing.
    [[nodiscard]] std::optional<StatusReport> confirm(const StatusReport& report);
    /// The next reply does not follow the last one without a doubt in between.
    void interrupt() { m_last.reset(); }
    /// A command that may move the motor is sent: standstill must be proved again.
    void expectMotion();

private:
    struct Permits {
        std::uint8_t status = 0;
        std::uint8_t aux = 0;
    };
    struct Last {
        Permits permits;
        std::size_t length = 0;
    };
    [[nodiscard]] Permits permitsOf(const StatusReport& report) const;

    ModuleIdentity m_module;
    bool m_first = true;  ///< no report yet; the first one alone permits nothing
    Permits m_granted;
    std::optional<Last> m_last;
};

}  // namespace nmc::bus
