// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "model/module/positionmemory.h"

namespace nmc {

/// What is remembered about the chain at one port.
struct RememberedChain {
    std::string machine;  ///< name of the machine; empty: it had none
    RememberedPositions positions;
    bool operator==(const RememberedChain&) const = default;
};

/// Converts to and from the text of a file; any other text reads as an empty chain.
[[nodiscard]] std::string writeRemembered(const RememberedChain& chain);
[[nodiscard]] RememberedChain readRemembered(std::string_view text);

}  // namespace nmc
