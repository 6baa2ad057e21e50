// SPDX-License-Identifier: MIT
#pragma once

#include <QList>

#include "link/ports/linktypes.h"

namespace nmc {

/// The serial ports of this machine with their descriptions, the most likely ones (USB adapters) first. Takes
/// 3 ms.
[[nodiscard]] QList<PortEntry> serialPorts();

}  // namespace nmc
