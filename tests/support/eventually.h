// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include "tests/support/patience.h"

namespace nmc::testing_support {

/// Handles events until the predicate holds; false if it never does.
template <typename Predicate>
[[nodiscard]] bool eventually(Predicate predicate) {
    return QTest::qWaitFor(predicate, kPatienceMs);
}

}  // namespace nmc::testing_support
