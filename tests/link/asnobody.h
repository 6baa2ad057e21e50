// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

namespace nmc::testing_support {

/// Root may do everything, so tests of what is not permitted run as another user while this object exists.
class AsNobody {
public:
    AsNobody() : m_root(::geteuid() == 0) {
        if (m_root && ::seteuid(65'534) != 0)
            ADD_FAILURE() << "cannot become nobody";
    }
    ~AsNobody() {
        if (m_root && ::seteuid(0) != 0)
            ADD_FAILURE() << "cannot become root again";
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

private:
    bool m_root;
};

}  // namespace nmc::testing_support
