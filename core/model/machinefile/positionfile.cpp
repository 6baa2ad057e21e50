// SPDX-License-Identifier: MIT
#include "model/machinefile/positionfile.h"

#include "model/machinefile/fieldreader.h"
#include "model/machinefile/fieldwriter.h"

namespace nmc {

// The layout of the file, defined once for reading and writing, as in model/machinefile/machinelayout.h.
namespace layout {

namespace {
constexpr Bounds kCounter{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
constexpr Bounds kTime{0, 1e15};

struct Axis {
    ModuleIndex module;
    RememberedPosition last{};
};
struct Positions {
    std::string machine;
    std::vector<Axis> axes{};
};
}  // namespace

template <typename Form, As<Axis> T>
void fields(Form& form, T& axis) {
    auto& [module, last] = axis;
    auto& [identity, fromHome, counter, source, seen, moving] = last;
    auto type = static_cast<std::uint8_t>(identity.type);
    int saved = source == HomeFact::Source::Saved ? 1 : 0;
    int moves = moving ? 1 : 0;
    form.module("module", module);
    form.whole("type", type, {0, 255});
    form.whole("version", identity.version, {0, 255});
    form.whole("from_home", fromHome, kCounter);
    form.whole("counter", counter, kCounter);
    form.whole("home_saved", saved, {0, 1});
    form.whole("seen", seen, kTime);
    form.whole("moving", moves, {0, 1});
    if constexpr (!std::is_const_v<T>) {
        identity.type = static_cast<ModuleType>(type);
        source = saved == 1 ? HomeFact::Source::Saved : HomeFact::Source::Search;
        moving = moves == 1;
    }
}

template <typename Form, As<Positions> T>
void fields(Form& form, T& file) {
    form.text("machine", file.machine);
    form.list("positions", file.axes, kMaxAxes);
}

}  // namespace layout

std::string writeRemembered(const RememberedChain& chain) {
    layout::Positions all{chain.machine};
    for (const auto& [module, last] : chain.positions)
        all.axes.push_back({module, last});
    return layout::fileText(layout::written(all));
}

RememberedChain readRemembered(std::string_view text) {
    const auto file = parseJson(text);
    if (!file || file->find("machine") == nullptr || file->find("positions") == nullptr)
        return {};
    std::optional<FileProblem> problem;
    layout::Positions read;
    layout::FieldReader reader(*file, problem);
    layout::fields(reader, read);
    if (problem)
        return {};
    RememberedChain chain{read.machine, {}};
    for (const layout::Axis& axis : read.axes)
        chain.positions[axis.module] = axis.last;
    return chain;
}

}  // namespace nmc
