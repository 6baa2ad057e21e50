// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nmc::testing_support {

/// From now on, every test in which Qt warns fails. To be called after InitGoogleTest().
void failOnQtWarnings();

}  // namespace nmc::testing_support
