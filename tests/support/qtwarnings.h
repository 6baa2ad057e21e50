// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nmc::testing_support {

/// From now on a Qt warning that a test did not announce fails it. After InitGoogleTest().
void failOnQtWarnings();

}  // namespace nmc::testing_support
