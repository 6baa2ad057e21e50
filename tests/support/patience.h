// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nmc::testing_support {

/// How long a test waits for what must come. It asserts nothing about time: it ends a test that would hang
/// before ctest ends its whole suite, and is so long that a computer may stand still meanwhile.
inline constexpr int kPatienceMs = 120'000;

}  // namespace nmc::testing_support
