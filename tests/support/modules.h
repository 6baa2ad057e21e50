// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/strong.h"
#include "protocol/moduletype.h"

/// Names that many tests use for modules: by what they are, and by their place in the chain.
namespace nmc::testing_support {

inline constexpr ModuleIdentity kServo{ModuleType::Servo, 4};  ///< of the first data sheet
inline constexpr ModuleIdentity kCmc{ModuleType::Servo, 5};
inline constexpr ModuleIdentity kSc{ModuleType::Servo, 10};
inline constexpr ModuleIdentity kStep{ModuleType::Stepper, 1};
inline constexpr ModuleIdentity kIo{ModuleType::Io, 1};

inline constexpr ModuleIndex kFirst{0};
inline constexpr ModuleIndex kSecond{1};
inline constexpr ModuleIndex kThird{2};

}  // namespace nmc::testing_support
