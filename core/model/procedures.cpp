// SPDX-License-Identifier: MIT
#include "model/procedures.h"

#include "model/changemotion.h"

namespace nmc {

std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module) {
    if (const auto* change = std::get_if<stepintent::ChangeMotion>(&intent))
        return std::make_unique<ChangeMotion>(module.info.index, change->motion);
    return nullptr;
}

}  // namespace nmc
