// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// A path of one PIC-SERVO CMC or SC, or of a group (docs/paths.md). The bus sends the points and keeps the
/// buffers filled (bus/pathtask.h), so that the path continues while this thread is busy. The procedure
/// requests the path, reports its progress as ProcedureReport::path, and stops it when it is no longer
/// wanted. It belongs to the first axis; the bus stops the others together with that one.
class PathRun : public Procedure {
public:
    /// `wanted` must be possible now.
    PathRun(const intent::FollowPath& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next afterLastWord(const ModuleState& module, TimePoint now) override;
    void whileItLasts(const ModuleState& module) override { look(module); }

    void look(const ModuleState& module);

    std::shared_ptr<const bus::PathPlan> m_plan;
};

}  // namespace nmc
