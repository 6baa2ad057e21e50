// SPDX-License-Identifier: MIT
#include "module/modulecommand.h"

namespace nmc {

Payload payloadOf(const ModuleCommand& command) {
    return visitCommand([](const auto& own) { return encode(own); }, command);
}

}  // namespace nmc
