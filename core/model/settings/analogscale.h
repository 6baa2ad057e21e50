// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace nmc {

/// What the A/D value stands for: `perCount` of `unit` ("A", "V") each, from `atZero` on.
struct AnalogScale {
    double perCount = 5.0 / 255.0;  ///< 0 to 5 V on the input (DS-V 3)
    double atZero = 0.0;
    std::string unit = "V";

    bool operator==(const AnalogScale&) const = default;
};

}  // namespace nmc
