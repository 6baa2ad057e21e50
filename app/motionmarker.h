// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <vector>

#include "model/module/linkstate.h"

namespace nmc {

/// Remembers on disk which motors move, as long as they do: a program that is killed cannot stop them, and
/// the next one can at least say so. Writes only when something changes. GUI thread.
class MotionMarker {
public:
    explicit MotionMarker(QSettings& settings);

    /// What moved when the session before ended without a word.
    [[nodiscard]] const std::vector<ModuleIndex>& left() const { return m_left; }
    void update(const LinkState& link);
    /// The session ends in order.
    void clear();

private:
    void write(const std::vector<ModuleIndex>& moving);

    QSettings& m_settings;
    std::vector<ModuleIndex> m_left;
    std::vector<ModuleIndex> m_written;
};

}  // namespace nmc
