// SPDX-License-Identifier: GPL-3.0-or-later
// nmcguard: stops the motors of a panel that no longer can (link/guardian/guardian.h). Started by the panel.
#include <cstdio>

#include "link/guardian/guard.h"

int main(int argc, char** argv) {
    const nmc::GuardEnd end = argc == 2 ? nmc::runGuard(argv[1]) : nmc::GuardEnd::NotStarted;
    if (end == nmc::GuardEnd::NotStarted)
        std::fprintf(stderr, "nmcguard is part of nmcpanel, which starts it by itself.\n");
    return static_cast<int>(end);
}
