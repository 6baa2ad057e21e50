// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "model/intent/intent.h"
#include "model/module/modulestate.h"
#include "model/sequence/sequencewalk.h"
#include "model/settings/machine.h"

/// What is wrong with points and sequences, before anything moves. Pure.
namespace nmc {

/// Why a program is none, or a sequence cannot be started now; the window's texts have a sentence for each.
struct SequenceProblem {
    enum class Kind : std::uint8_t {
        // Of the program by itself; a machine file that has one is refused.
        NoName,          ///< of a point or a sequence
        NameTwice,       ///< `name`
        AxisTwice,       ///< `module`, in point `name`
        NoSuchPoint,     ///< `name`
        NoSuchSequence,  ///< `name`
        CallsItself,     ///< sequence `name`, here or through others
        RepeatsBelow,    ///< it goes back to itself or to a row below
        // Of this machine, as it is now.
        NoRows,
        NoAxes,           ///< point `name` has none
        NoSuchModule,     ///< `module` is not in the chain
        Refused,          ///< `module`, for `refusal`
        TaughtElsewhere,  ///< point `name`: `module` was taught before its home was known, and now it is
        NoRecipe,         ///< `module` has not been told how to find home
        NoSuchPin,        ///< `module` does not have it
        NotAnInput,       ///< a limit pin, or one of a PIC-I/O, that is an output
        NotAnOutput,      ///< a limit pin, or one of a PIC-I/O, that is an input
        OutputsUnknown,   ///< `module` was not told its outputs, or their directions, in this connection
        // Of starting in the middle: what a run from the top would have done before that row.
        Unreachable,  ///< a repeat for ever stands above
        NotThere,     ///< `module` does not stand where the rows above leave it: at point `name`, or its home
        NotSet,       ///< output `output` of `module` is not as the rows above leave it
    };
    Kind kind = Kind::NoRows;
    std::string sequence{};
    std::size_t row = 0;
    bool ofPoint = false;  ///< `row` is the point's place among the points
    std::optional<ModuleIndex> module{};
    std::string name{};
    std::optional<Refusal> refusal{};
    unsigned output = 0;

    bool operator==(const SequenceProblem&) const = default;
};

/// What points and sequences say of each other; the first that cannot be.
[[nodiscard]] std::optional<SequenceProblem> contradiction(const Program& program);

/// Everything that keeps a sequence from being run from this row of it on, in the order of the rows.
/// `modules`: of the chain that is connected.
[[nodiscard]] std::vector<SequenceProblem> whyNotRun(const std::string& sequence, std::size_t row,
                                                     const Machine& machine,
                                                     const std::vector<ModuleState>& modules);

/// The machine with a sequence of one row that moves to this point, all axes at once; nobody can type its
/// name.
inline const std::string kMoveToPoint = "\n";
[[nodiscard]] Machine withMoveTo(Machine machine, const std::string& point);
/// Of the sequence with a row for each axis that is to find its home.
inline const std::string kHomeAll = "\n\n";
/// Those that have a recipe, in the order that the machine keeps.
[[nodiscard]] std::vector<ModuleIndex> axesToHome(const Machine& machine,
                                                  const std::vector<ModuleState>& modules);

/// What the rows above one leave behind, whatever was before: a fresh run comes to that row so.
struct EntryState {
    struct Place {
        std::string point;  ///< empty: its home
        PointAxis axis;
        bool operator==(const Place&) const = default;
    };
    std::map<ModuleIndex, Place> places;
    std::map<std::pair<ModuleIndex, unsigned>, bool> outputs;
    std::set<ModuleIndex> homed;
    bool reached = true;  ///< false: a repeat for ever stands above

    bool operator==(const EntryState&) const = default;
};
[[nodiscard]] EntryState entryState(const Machine& machine, const std::string& sequence, std::size_t row);

/// The counter's value of a place on an axis as it is now.
[[nodiscard]] tl::expected<std::int32_t, Refusal> goalOf(const PointAxis& axis, const ModuleState& module);
/// What the panel's own "Go to" would ask for, at that share of the axis's velocity.
[[nodiscard]] tl::expected<Intent, Refusal> moveIntent(const PointAxis& axis, unsigned percent,
                                                       const ModuleState& module,
                                                       const AxisSettings& settings);
/// Nothing: the module has no such pin, or it is an output.
[[nodiscard]] std::optional<bool> readPin(InputPin pin, const ModuleState& module);
/// Of 255. Nothing: the module has no such input.
[[nodiscard]] std::optional<unsigned> readAnalog(unsigned input, const ModuleState& module);
/// Whether what is waited for is there.
[[nodiscard]] bool isMet(const action::WaitForInput& wait, const ModuleState& module);
[[nodiscard]] bool isMet(const action::WaitForAnalog& wait, const ModuleState& module);
/// Otherwise NoSuchPin, NotAnOutput, or OutputsUnknown: it is told with the others, as they are.
[[nodiscard]] tl::expected<Intent, SequenceProblem::Kind> outputIntent(const action::SetOutput& set,
                                                                       const ModuleState& module);
[[nodiscard]] intent::Home homeIntent(const AxisSettings& settings);
/// Where the chosen axes stand; an axis whose position is not known is left out.
[[nodiscard]] std::vector<PointAxis> teach(const std::vector<ModuleIndex>& axes,
                                           const std::vector<ModuleState>& modules);

}  // namespace nmc
