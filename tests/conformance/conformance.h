// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "tests/conformance/rig.h"

namespace nmc::conformance {

/// A statement of a data sheet, tested in both places. The name of a test begins with the statement's number
/// in the statements-*.md files beside this one.
class Statement : public testing::TestWithParam<Place> {
protected:
    /// Makes a fresh chain, to which `rig` then refers.
    void make(const std::string& chain, const std::vector<std::string>& options = {}) {
        rig = makeRig(GetParam(), chain, options);
    }
    std::unique_ptr<Rig> rig;
};

[[nodiscard]] inline std::string nameOf(const testing::TestParamInfo<Place>& info) {
    return info.param == Place::InProcess ? "InProcess" : "Terminal";
}

inline const auto kPlaces = testing::Values(Place::InProcess, Place::Terminal);

}  // namespace nmc::conformance
