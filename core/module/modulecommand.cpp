// SPDX-License-Identifier: MIT
#include "module/modulecommand.h"

namespace nmc {

Payload payloadOf(const ModuleCommand& command) {
    return visitCommand([](const auto& own) { return own.encode(); }, command);
}

}  // namespace nmc
