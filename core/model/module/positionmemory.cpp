// SPDX-License-Identifier: MIT
#include "model/module/positionmemory.h"

#include "bus/standstill.h"

namespace nmc {

namespace {
constexpr std::int64_t kSettles = 2;  ///< s
}

void PositionMemory::found(const std::vector<bus::ModuleInfo>& modules, bool attached) {
    m_new.clear();
    for (const bus::ModuleInfo& module : modules)
        m_new[module.index] = attached ? Counter::GoesOn : Counter::Began;
}

std::vector<PositionMemory::Offer> PositionMemory::look(const LinkState& link, std::int64_t now) {
    std::vector<Offer> offers;
    for (const ModuleState& module : link.modules) {
        const ModuleIndex index = module.info.index;
        // A jump has withdrawn the axis's home, so what is remembered is dropped as well.
        if (module.positionDoubtful() && !module.home.place() && !module.home.offered())
            m_remembered.erase(index);
        if (!isLive(link, module) || !module.position())
            continue;
        const auto justFound = m_new.find(index);
        if (justFound == m_new.end()) {
            follow(module, now);
            continue;
        }
        if (const auto home = homeOf(module, justFound->second))
            offers.push_back({index, *home, m_remembered.at(index)});
        m_new.erase(justFound);
    }
    return offers;
}

std::optional<std::int32_t> PositionMemory::homeOf(const ModuleState& module, Counter counter) const {
    const auto remembered = m_remembered.find(module.info.index);
    if (remembered == m_remembered.end())
        return std::nullopt;
    const RememberedPosition& last = remembered->second;
    if (last.moving || last.identity != module.info.identity || module.home.place())
        return std::nullopt;
    if (counter == Counter::Began)
        return countsBetween(last.fromHome, 0);
    if (module.moving() || !samePlace(last.counter, *module.latest->position))
        return std::nullopt;
    return countsBetween(last.fromHome, last.counter);
}

void PositionMemory::follow(const ModuleState& module, std::int64_t now) {
    const ModuleIndex index = module.info.index;
    const auto& place = module.home.place();
    const auto home = place ? std::optional(place->counts) : module.home.offered();
    if (!home) {
        m_remembered.erase(index);  // from here on, it would be a guess
        return;
    }
    const std::int32_t position = *module.latest->position;
    const auto before = m_remembered.find(index);
    const bool known = before != m_remembered.end();
    RememberedPosition news = known ? before->second : RememberedPosition{};
    if (place && place->verified())
        news.source = place->source;
    news.identity = module.info.identity;
    const bool sameMotion = known && news.moving == module.moving();
    news.moving = module.moving();
    const std::int32_t fromHome = countsBetween(*home, position);
    const bool samePlaces = known && samePlace(news.fromHome, fromHome) && samePlace(news.counter, position);
    // A moving axis is recorded where it comes to rest, and once more when it has settled there: a servo
    // reports the end of a motion while it still approaches its goal. After that, it hunts.
    const bool settles = samePlaces && sameMotion && !news.moving;
    const auto since = m_settling.find(index);
    const bool settled = settles && since != m_settling.end() && now - since->second >= kSettles;
    if (settled)
        m_settling.erase(since);
    else if (!settles)
        m_settling[index] = now;
    if (sameMotion && (news.moving || samePlaces) && !settled && news == before->second)
        return;
    news.fromHome = fromHome;
    news.counter = position;
    news.seen = now;
    m_remembered[index] = news;
}

}  // namespace nmc
