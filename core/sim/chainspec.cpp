// SPDX-License-Identifier: MIT
#include "sim/chainspec.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "sim/controlwords.h"

namespace nmc::sim {

namespace {

constexpr std::string_view kAllowed =
    "allowed is a comma list of 1 to 32 of servo, servo@1, servo@2, servo@3, servo@4, servo@5, servo@10, "
    "step, step@1, io and io@1";

struct ModuleWord {
    std::string_view name;
    ModuleType type;
    std::uint8_t usualVersion;  ///< the version simulated when none is given
};
constexpr std::array kKinds{ModuleWord{"servo", ModuleType::Servo, 4},
                            ModuleWord{"step", ModuleType::Stepper, 1}, ModuleWord{"io", ModuleType::Io, 1}};

tl::expected<ModuleIdentity, std::string> parseItem(std::string_view item) {
    const std::size_t at = item.find('@');
    const std::string_view name = item.substr(0, at);
    if (item.empty())
        return tl::unexpected("An item of the chain is empty; " + std::string(kAllowed) + ".");
    const auto* const kind = std::ranges::find(kKinds, name, &ModuleWord::name);
    if (kind == kKinds.end())
        return tl::unexpected("Unknown item " + quoted(item) + " in the chain; " + std::string(kAllowed) +
                              ".");
    ModuleIdentity module{kind->type, kind->usualVersion};
    if (at == std::string_view::npos)
        return module;
    const std::string_view version = item.substr(at + 1);
    module.version = numberIn<std::uint8_t>(version).value_or(0);
    if (std::to_string(module.version) != version || !isKnown(module))
        return tl::unexpected("Unknown version in item " + quoted(item) + "; " + std::string(kAllowed) + ".");
    return module;
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
