// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "link/connection/transport.h"
#include "sim/chain.h"

namespace nmc {

/// The built-in simulator in place of a port: a simulated chain paced in real time, in the bus thread.
class SimulatorTransport : public Transport {
public:
    explicit SimulatorTransport(std::vector<ModuleIdentity> modules, sim::ChainOptions options = {});

    tl::expected<void, PortError> open() override;
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override;
    tl::expected<void, PortError> send(ByteSpan bytes) override;
    void discardInput() override;
    Received receive(std::optional<TimePoint> until, int wakeFd) override;
    std::optional<std::string> control(std::string_view line) override;

private:
    [[nodiscard]] TimePoint chainTime(TimePoint t) const { return TimePoint(t - m_powerUp); }
    [[nodiscard]] std::vector<std::uint8_t> arrived();

    sim::Chain m_chain;
    TimePoint m_powerUp;  ///< the chain's time 0 on the monotonic clock
};

}  // namespace nmc
