// SPDX-License-Identifier: MIT
#include "model/machinefile/machinefile.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "model/machinefile/fieldreader.h"
#include "model/machinefile/fieldwriter.h"
#include "model/sequence/sequencecheck.h"

namespace nmc {

namespace {

using Kind = FileProblem::Kind;

/// Finds travel limits that leave no room between them.
std::optional<FileProblem> crossedLimits(const Machine& machine, const JsonValue& file) {
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const TravelSettings& travel = machine.axes[i].travel;
        if (travel.lowest && travel.highest && *travel.lowest >= *travel.highest)
            return FileProblem{.kind = Kind::LimitsCrossed,
                               .line = file.find("axes")->items[i].find("travel")->line,
                               .field = "travel"};
    }
    return std::nullopt;
}

/// Finds a work offset without a name, or with that of another one.
std::optional<FileProblem> offsetProblem(const Machine& machine, const JsonValue& file) {
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        std::set<std::string> names;
        for (const WorkOffset& offset : machine.axes[i].workOffsets)
            if (offset.name.empty() || !names.insert(offset.name).second)
                return FileProblem{.kind = offset.name.empty() ? Kind::NameMissing : Kind::NameTwice,
                                   .line = file.find("axes")->items[i].find("work_offsets")->line,
                                   .field = "work_offsets",
                                   .found = layout::quoted(offset.name)};
    }
    return std::nullopt;
}

/// Finds contradictions between groups.
std::optional<FileProblem> groupProblem(const Machine& machine, const JsonValue& file) {
    std::array<bool, layout::kMaxAxes> taken{};
    for (std::size_t i = 0; i < machine.groups.size(); ++i) {
        const GroupSettings& group = machine.groups[i];
        const int line = file.find("groups")->items[i].line;
        for (std::size_t k = 0; k < i; ++k)
            if (machine.groups[k].address == group.address)
                return FileProblem{.kind = Kind::AddressTwice,
                                   .line = line,
                                   .field = "address",
                                   .found = std::to_string(group.address)};
        for (const ModuleIndex member : group.members)
            if (std::exchange(taken[member.value()], true))
                return FileProblem{.kind = Kind::ModuleTwice,
                                   .line = line,
                                   .field = "modules",
                                   .found = std::to_string(member.value() + 1)};
        if (group.leader && std::ranges::find(group.members, *group.leader) == group.members.end())
            return FileProblem{.kind = Kind::LeaderNotInGroup, .line = line, .field = "leader"};
    }
    return std::nullopt;
}

using From = SequenceProblem::Kind;

/// The contradictions that a program can have by itself.
constexpr std::array kOfProgram{std::pair{From::NoName, Kind::NameMissing},
                                std::pair{From::NameTwice, Kind::NameTwice},
                                std::pair{From::AxisTwice, Kind::AxisTwice},
                                std::pair{From::NoSuchPoint, Kind::NoSuchPoint},
                                std::pair{From::NoSuchSequence, Kind::NoSuchSequence},
                                std::pair{From::CallsItself, Kind::CallsItself},
                                std::pair{From::RepeatsBelow, Kind::RepeatsBelow}};

/// Finds contradictions between points and sequences, with the line of the point, the sequence or its row.
std::optional<FileProblem> programProblem(const Machine& machine, const JsonValue& file) {
    const Program& program = machine.program;
    const auto problem = contradiction(program);
    if (!problem)
        return std::nullopt;
    const auto* const row = std::ranges::find(kOfProgram, problem->kind, &std::pair<From, Kind>::first);
    const bool ofName = problem->kind == From::NoName || problem->kind == From::NameTwice;
    const std::string field = problem->ofPoint ? "points" : "sequences";
    const std::vector<JsonValue>& items = file.find(field)->items;
    const auto lineOf = [&] {
        if (problem->ofPoint || ofName)
            return items[problem->row].line;
        const auto sequence = program.sequence(problem->sequence) - program.sequences.data();
        return items[static_cast<std::size_t>(sequence)].find("rows")->items[problem->row].line;
    };
    return FileProblem{.kind = row != kOfProgram.end() ? row->second : Kind::NameMissing,
                       .line = lineOf(),
                       .field = field,
                       .found = problem->module ? std::to_string(problem->module->value() + 1)
                                                : layout::quoted(problem->name)};
}

/// An axis must occur only once in the order.
std::optional<FileProblem> orderProblem(const Machine& machine, const JsonValue& file) {
    for (std::size_t i = 0; i < machine.homeOrder.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (machine.homeOrder[k] == machine.homeOrder[i])
                return FileProblem{.kind = Kind::AxisTwice,
                                   .line = file.find("home_order")->items[i].line,
                                   .field = "home_order",
                                   .found = std::to_string(machine.homeOrder[i].value() + 1)};
    return std::nullopt;
}

}  // namespace

tl::expected<ParsedMachine, FileProblem> parseMachine(std::string_view text) {
    const auto file = layout::parsed(text, kMaxMachineFile, layout::kFormat, layout::kVersion);
    if (!file)
        return tl::unexpected(file.error());
    Machine machine;
    std::optional<FileProblem> problem;
    layout::FieldReader reader(*file, problem);
    layout::fields(reader, machine);
    for (const auto& check : {groupProblem, programProblem, orderProblem, crossedLimits, offsetProblem})
        if (!problem)
            problem = check(machine, *file);
    if (problem)
        return tl::unexpected(*problem);
    return ParsedMachine{std::move(machine), {std::string(text)}};
}

// ---- writing ----

std::string writeMachine(const Machine& machine, const UnknownKeys& unknown) {
    auto file = layout::FieldWriter::Json::parse(unknown.text, nullptr, false);
    if (!file.is_object())
        file = layout::FieldWriter::Json::object();
    file["format"] = layout::kFormat;
    file["version"] = layout::kVersion;
    layout::FieldWriter writer(file);
    layout::fields(writer, machine);
    return layout::fileText(file);
}

}  // namespace nmc
