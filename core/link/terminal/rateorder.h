// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "link/terminal/ptyserver.h"
#include "sim/receiver.h"

namespace nmc {

/// Decides which bytes a host wrote before it set its present rate: a pseudo-terminal does not keep the
/// order.
class RateOrder {
public:
    /// The number of those bytes; all, if the rate is still `baud`. If the host did both in quick succession,
    /// the kernel reports only which came first; the rate change is then assumed to follow a Set Baud or Hard
    /// Reset. If the kernel reports nothing, the bytes are assumed to have the old rate when that is the
    /// modules'.
    [[nodiscard]] std::size_t beforeNewRate(const HostActs& acts, std::uint32_t baud, bool modulesHaveIt);

private:
    /// Returns the number of `bytes` up to the end of the last Set Baud or Hard Reset among them; 0 if there
    /// is none.
    std::size_t endOfLastRateCommand(ByteSpan bytes);

    sim::Receiver m_monitor;  ///< receives the host's bytes regardless of rates
    /// The host's last command was Set Baud or Hard Reset, and it has not set a rate since.
    bool m_sentRateCommand = false;
};

}  // namespace nmc
