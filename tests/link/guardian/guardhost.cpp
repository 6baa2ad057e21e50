// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/link/guardian/guardhost.h"

#include <fstream>

namespace nmc::testing_support {

bool GuardHost::isZombie(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const auto name = text.rfind(") ");
    return name == std::string::npos || text[name + 2] == 'Z';
}

}  // namespace nmc::testing_support
