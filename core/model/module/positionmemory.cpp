// SPDX-License-Identifier: MIT
#include "model/module/positionmemory.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "bus/standstill.h"

namespace nmc {

namespace {

using Json = nlohmann::json;
using Number = std::int64_t;

constexpr std::size_t kMostModules = 32;

/// The name of a number of an axis in the file, with its bounds.
struct Field {
    const char* key;
    Number min;
    Number max;
};
constexpr Number kMin = std::numeric_limits<std::int32_t>::min();
constexpr Number kMax = std::numeric_limits<std::int32_t>::max();
constexpr Field kModule{"module", 1, kMostModules};
constexpr Field kType{"type", 0, 255};
constexpr Field kVersion{"version", 0, 255};
constexpr Field kFromHome{"from_home", kMin, kMax};
constexpr Field kCounter{"counter", kMin, kMax};
constexpr Field kSaved{"home_saved", 0, 1};
constexpr Field kSeen{"seen", 0, std::numeric_limits<Number>::max()};
constexpr Field kMoving{"moving", 0, 1};

/// Reads the numbers of one axis; right() is false once a number is missing or out of bounds.
class MemoryReader {
public:
    explicit MemoryReader(const Json& object) : m_object(object) {}
    Number operator()(const Field& field) {
        const auto value = m_object.is_object() ? m_object.find(field.key) : m_object.end();
        const bool right = value != m_object.end() && value->is_number_integer() &&
                           value->get<Number>() >= field.min && value->get<Number>() <= field.max;
        m_right = m_right && right;
        return right ? value->get<Number>() : 0;
    }
    [[nodiscard]] bool right() const { return m_right; }

private:
    const Json& m_object;
    bool m_right = true;
};

}  // namespace

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
        if (!isLive(link, module) || !module.latest || !module.latest->position)
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
    const auto before = m_remembered.find(index);
    const auto& place = module.home.place();
    if (!place && !module.home.offered()) {
        if (before != m_remembered.end())
            m_remembered.erase(before);  // from here on, it would be a guess
        return;
    }
    const std::int32_t position = *module.latest->position;
    RememberedPosition news;
    if (before != m_remembered.end())
        news = before->second;
    if (place && place->verified())
        news.source = place->source;
    news.identity = module.info.identity;
    const bool sameMotion = before != m_remembered.end() && news.moving == module.moving();
    news.moving = module.moving();
    const std::int32_t fromHome = countsBetween(place ? place->counts : *module.home.offered(), position);
    const bool samePlaces = before != m_remembered.end() && samePlace(news.fromHome, fromHome) &&
                            samePlace(news.counter, position);
    // A moving axis is recorded where it comes to rest, and a servo at rest hunts.
    if (sameMotion && (news.moving || samePlaces) && news == before->second)
        return;
    news.fromHome = fromHome;
    news.counter = position;
    news.seen = now;
    m_remembered[index] = news;
}

std::string writeRemembered(const RememberedChain& chain) {
    Json list = Json::array();
    for (const auto& [module, axis] : chain.positions)
        list.push_back({{kModule.key, module.value() + 1},
                        {kType.key, static_cast<int>(axis.identity.type)},
                        {kVersion.key, axis.identity.version},
                        {kFromHome.key, axis.fromHome},
                        {kCounter.key, axis.counter},
                        {kSaved.key, axis.source == HomeFact::Source::Saved ? 1 : 0},
                        {kSeen.key, axis.seen},
                        {kMoving.key, axis.moving ? 1 : 0}});
    return Json{{"machine", chain.machine}, {"positions", list}}.dump(1) + '\n';
}

RememberedChain readRemembered(std::string_view text) {
    const Json file = Json::parse(text, nullptr, false);
    if (!file.is_object() || !file.contains("machine") || !file["machine"].is_string() ||
        !file.contains("positions") || !file["positions"].is_array() ||
        file["positions"].size() > kMostModules)
        return {};
    RememberedChain chain{file["machine"].get<std::string>(), {}};
    for (const Json& item : file["positions"]) {
        MemoryReader read(item);
        const ModuleIndex module(static_cast<std::uint8_t>(read(kModule) - 1));
        RememberedPosition axis;
        axis.identity = {static_cast<ModuleType>(read(kType)), static_cast<std::uint8_t>(read(kVersion))};
        axis.fromHome = static_cast<std::int32_t>(read(kFromHome));
        axis.counter = static_cast<std::int32_t>(read(kCounter));
        axis.source = read(kSaved) != 0 ? HomeFact::Source::Saved : HomeFact::Source::Search;
        axis.seen = read(kSeen);
        axis.moving = read(kMoving) != 0;
        if (!read.right())
            return {};
        chain.positions[module] = axis;
    }
    return chain;
}

}  // namespace nmc
