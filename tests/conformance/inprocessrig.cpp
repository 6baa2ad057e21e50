// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/inprocessrig.h"

#include <stdexcept>

#include "sim/chainspec.h"
#include "sim/control.h"

namespace nmc::conformance {

namespace {

/// The options of nmcsim that concern the chain.
sim::ChainOptions chainOptions(const std::vector<std::string>& options) {
    sim::ChainOptions result;
    for (const std::string& option : options) {
        if (option == "--unpaced")
            result.unpaced = true;
        else if (option == "--enable-faults")
            result.enableFaults = true;
        else if (option == "--deaf-when-addr-in-rises")
            result.deafWhenAddressInputRises = true;
        else
            throw std::invalid_argument(option);
    }
    return result;
}

}  // namespace

InProcessRig::InProcessRig(const std::string& chain, const std::vector<std::string>& options)
    : m_chain(sim::parseChain(chain).value(), chainOptions(options)) {}

Bytes InProcessRig::wait(Duration time) {
    m_now += time;
    m_chain.advanceTo(m_now);
    Bytes bytes;
    for (const sim::HostByte& byte : m_chain.takeHostBytes())
        bytes.push_back(byte.value);
    return bytes;
}

nlohmann::json InProcessRig::control(const std::string& line) {
    return nlohmann::json::parse(sim::handleControlLine(m_chain, line, m_now));
}

}  // namespace nmc::conformance
