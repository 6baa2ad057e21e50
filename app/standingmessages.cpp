// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/standingmessages.h"

#include <algorithm>

namespace nmc {

template <typename Over>
QStringList StandingMessages::end(Over over) {
    QStringList keys;
    std::erase_if(m_standing, [&](const auto& entry) {
        const bool ends = over(entry.second);
        if (ends)
            keys << entry.first;
        return ends;
    });
    return keys;
}

QStringList StandingMessages::look(const LinkState& link) {
    return end([&](const Standing& s) {
        if (s.stands == nullptr)
            return false;
        const auto module =
            std::ranges::find(link.modules, *s.module, [](const ModuleState& m) { return m.info.index; });
        return module == link.modules.end() || !s.stands(*module);
    });
}

QStringList StandingMessages::obeyed(ModuleIndex module) {
    return end([&](const Standing& s) { return s.stands == nullptr && s.module == module; });
}

QStringList StandingMessages::chainFound() {
    return end([](const Standing& s) { return s.stands == nullptr; });
}

QStringList StandingMessages::connectionEnded() {
    return end([](const Standing& s) { return !s.outlivesConnection; });
}

}  // namespace nmc
