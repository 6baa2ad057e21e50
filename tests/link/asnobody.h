// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

namespace nmc::testing_support {

/// The superuser may do everything; tests of what is not allowed are somebody else meanwhile.
class AsNobody {
public:
    AsNobody() : m_root(geteuid() == 0) {
        if (m_root)
            m_changed = seteuid(65'534) == 0;
    }
    ~AsNobody() {
        if (m_changed) [[maybe_unused]]
            const int back = seteuid(0);
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

private:
    bool m_root;
    bool m_changed = false;
};

}  // namespace nmc::testing_support
