// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/underlay.h"

namespace nmc {

bool Underlay::follow(const History& live, std::optional<ModuleIndex> module, TimePoint now,
                      const std::vector<ModuleSignal>& shown, std::vector<CustomSignal> custom) {
    if (module != m_module) {
        forget();
        m_recorded = {};
        m_module = module;
    }
    if (!m_laid)
        m_laid = now;
    const bool motions = followMotions(live);
    TimePoint below = *m_record->history.end();
    TimePoint above = *m_laid;
    if (m_recorded.first() && m_live.last()) {
        below = *m_recorded.first();
        above = *m_live.last();
    }
    m_zero = below - (above + m_shift - live.zero().value_or(above));
    std::erase_if(custom, [this](const CustomSignal& how) {
        return !has(how.first.of) || (how.second && !has(how.second->of));
    });
    m_derived.want(shown, custom);
    return m_derived.follow(m_record->history) && motions;
}

/// Of the user's signals, the parts count.
bool Underlay::has(const ModuleSignal& of) const {
    const std::vector<ScopeModule>& modules = m_record->modules;
    return customIndex(of.signal) || of.module.value() >= modules.size() ||
           modules[of.module.value()].has(of.signal);
}

bool Underlay::followMotions(const History& live) {
    if (!m_module)
        return true;
    const ModuleHistory* recorded = m_record->history.module(*m_module);
    const ModuleHistory* present = live.module(*m_module);
    const bool all = recorded == nullptr || m_recorded.first() || m_recorded.follow(*recorded);
    return (present == nullptr || m_live.follow(*present)) && all;
}

void Underlay::forget() {
    m_live = {};
    m_laid.reset();
}

}  // namespace nmc
