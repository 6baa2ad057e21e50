// SPDX-License-Identifier: MIT
#include "sim/chainspec.h"

#include <algorithm>
#include <array>

namespace nmc::sim {

namespace {

constexpr std::string_view kAllowed =
    "allowed is a comma list of 1 to 32 of servo, servo@1, servo@2, servo@3, servo@4, step and step@1";

struct Kind {
    std::string_view name;
    ModuleType type;
    char lastVersion;  ///< the one simulated when none is named
};
constexpr std::array kKinds{Kind{"servo", ModuleType::Servo, '4'}, Kind{"step", ModuleType::Step, '1'}};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string quoted(std::string_view item) {
    return "'" + std::string(item) + "'";
}

tl::expected<ModuleIdentity, std::string> parseItem(std::string_view item) {
    const std::size_t at = item.find('@');
    const std::string_view name = item.substr(0, at);
    if (item.empty())
        return tl::unexpected("An item of the chain is empty; " + std::string(kAllowed) + ".");
    const auto kind =
        std::find_if(kKinds.begin(), kKinds.end(), [name](const Kind& k) { return k.name == name; });
    if (kind == kKinds.end())
        return tl::unexpected("Unknown item " + quoted(item) + " in the chain; " + std::string(kAllowed) +
                              ".");
    const std::string_view version =
        at == std::string_view::npos ? std::string_view(&kind->lastVersion, 1) : item.substr(at + 1);
    if (version.size() != 1 || version[0] < '1' || version[0] > kind->lastVersion)
        return tl::unexpected("There is no such version as in item " + quoted(item) + "; " +
                              std::string(kAllowed) + ".");
    return ModuleIdentity{kind->type, static_cast<std::uint8_t>(version[0] - '0')};
}

}  // namespace

tl::expected<std::vector<ModuleIdentity>, std::string> parseChain(std::string_view text) {
    if (trimmed(text).empty())
        return tl::unexpected("The chain is empty; " + std::string(kAllowed) + ".");
    std::vector<ModuleIdentity> modules;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const std::string_view item = trimmed(text.substr(begin, comma - begin));
        const auto module = parseItem(item);
        if (!module)
            return tl::unexpected(module.error());
        if (modules.size() == kMaxModules)
            return tl::unexpected("The chain has more than 32 modules, item " + quoted(item) +
                                  " is one too many; " + std::string(kAllowed) + ".");
        modules.push_back(*module);
        begin = comma + 1;
    }
    return modules;
}

}  // namespace nmc::sim
