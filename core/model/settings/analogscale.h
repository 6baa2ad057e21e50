// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace nmc {

/// The meaning of an A/D value: `atZero` plus `perCount` of `unit` ("A", "V") per count.
struct AnalogScale {
    double perCount = 5.0 / 255.0;  ///< 0 to 5 V on the input (DS-V 3)
    double atZero = 0.0;
    std::string unit = "V";

    bool operator==(const AnalogScale&) const = default;
};

}  // namespace nmc
