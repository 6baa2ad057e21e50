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
#include "model/intent/travel.h"
#include "model/module/linkstate.h"
#include "model/module/modulestate.h"
#include "model/sequence/sequencewalk.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

/// Finds what is wrong with points and sequences before anything moves. Pure.
namespace nmc {

/// Why a program is invalid, or a sequence cannot be started now. The window's texts have a sentence for
/// each.
struct SequenceProblem {
    enum class Kind : std::uint8_t {
        // Problems of the program itself; a machine file that has one is refused.
        NoName,          ///< of a point or a sequence
        NameTwice,       ///< `name`
        AxisTwice,       ///< `module`, in point `name`
        NoSuchPoint,     ///< `name`
        NoSuchSequence,  ///< `name`
        CallsItself,     ///< sequence `name`, directly or through others
        RepeatsBelow,    ///< a repeat goes back to itself or to a row below
        // Problems with this machine in its present state.
        NoRows,
        NoAxes,           ///< point `name` has none
        NoSuchModule,     ///< `module` is not in the chain
        Refused,          ///< `module`, because of `refusal`
        TaughtElsewhere,  ///< point `name`: `module` was taught with home unknown, but it is known by then
        NoRecipe,         ///< `module` has no homing recipe
        NoSuchPin,        ///< `module` has no such pin
        NotAnInput,       ///< a limit pin or a PIC-I/O pin that is an output
        NotAnOutput,      ///< a limit pin or a PIC-I/O pin that is an input
        OutputsUnknown,   ///< `module` was not sent its outputs, or their directions, in this connection
        // Problems with a start in the middle: what a run from the top would have done before that row.
        Unreachable,  ///< an endless repeat precedes the row
        NotThere,     ///< `module` is not where the rows above leave it: at point `name`, or at its home
        NotSet,       ///< output `output` of `module` is not as the rows above leave it
    };
    Kind kind = Kind::NoRows;
    std::string sequence{};
    std::size_t row = 0;
    bool ofPoint = false;  ///< `row` is the index of a point
    std::optional<ModuleIndex> module{};
    std::string name{};
    std::optional<Refusal> refusal{};
    /// The limit that is the reason for `refusal`, and how the user reads positions of the axis.
    struct Travel {
        TravelProblem problem;
        std::optional<WorkZero> zero;
        AxisScale scale;
        bool operator==(const Travel&) const = default;
    };
    std::optional<Travel> travel{};
    unsigned output = 0;

    bool operator==(const SequenceProblem&) const = default;
};

/// The first error within or between points and sequences, independent of the machine; empty if none.
[[nodiscard]] std::optional<SequenceProblem> contradiction(const Program& program);

/// All problems that prevent the sequence from being run from this row on, in the order of the rows.
/// `modules`: those of the connected chain.
[[nodiscard]] std::vector<SequenceProblem> whyNotRun(const std::string& sequence, std::size_t row,
                                                     const Machine& machine,
                                                     const std::vector<ModuleState>& modules);

/// Returns the machine with this place among its points, where it replaces one of the same name.
[[nodiscard]] Machine withPlace(Machine machine, const Point& place);
/// Name of the sequence that withMoveTo() adds; it cannot be typed.
inline const std::string kMoveToPoint = "\n";
/// Returns the machine with an additional sequence, whose only row moves all axes to this point at once.
[[nodiscard]] Machine withMoveTo(Machine machine, const std::string& point);
/// Name of the sequence with a row for each axis to be homed; it cannot be typed.
inline const std::string kHomeAll = "\n\n";
/// The axes that have a homing recipe, in the machine's order (Machine::homeOrder).
[[nodiscard]] std::vector<ModuleIndex> axesToHome(const Machine& machine,
                                                  const std::vector<ModuleState>& modules);

/// The state in which a run from the top reaches a row: what the rows above leave behind, whatever the state
/// before them.
struct EntryState {
    struct Place {
        std::string point;  ///< empty: the axis's home
        PointAxis axis;
        bool operator==(const Place&) const = default;
    };
    std::map<ModuleIndex, Place> places;
    std::map<std::pair<ModuleIndex, unsigned>, bool> outputs;
    std::set<ModuleIndex> homed;
    bool reached = true;  ///< false: an endless repeat precedes the row
};
[[nodiscard]] EntryState entryState(const Machine& machine, const std::string& sequence, std::size_t row);

/// True if the axis was taught with home unknown, and home is known now: the counter may have been set since.
[[nodiscard]] bool taughtElsewhere(const PointAxis& axis, const ModuleState& module);
/// The counter value of a point on this axis, in the axis's present state.
[[nodiscard]] tl::expected<std::int32_t, Refusal> goalOf(const PointAxis& axis, const ModuleState& module);
/// What the panel's own "Go to" would request, at this percentage of the axis's velocity.
[[nodiscard]] tl::expected<Intent, Refusal> moveIntent(const PointAxis& axis, unsigned percent,
                                                       const ModuleState& module,
                                                       const AxisSettings& settings);
/// A move straight to its goal.
struct Leg {
    std::int32_t goal = 0;
    Intent intent;
};
/// A leg does not turn round itself.
[[nodiscard]] Plan planLeg(const Leg& leg, const ModuleState& module);
/// The move of an axis to a point as it begins now: straight there or, where it has to take up the backlash,
/// to where it turns round beyond the point (model/intent/backlash.h).
struct PointMove {
    std::int32_t goal = 0;  ///< of `orders`
    Orders orders;
    std::optional<Leg> then{};  ///< back to the point, when the motor has arrived where it turns round
};
[[nodiscard]] tl::expected<PointMove, Refusal> planMove(const PointAxis& axis, unsigned percent,
                                                        const ModuleState& module,
                                                        const AxisSettings& settings);
/// The level of an input; empty if the module has no such pin or the pin is an output, or before its first
/// status.
[[nodiscard]] std::optional<bool> readPin(InputPin pin, const ModuleState& module);
/// The value of an analog input, 0..255; empty if the module has no such input, or before its first status.
[[nodiscard]] std::optional<unsigned> readAnalog(unsigned input, const ModuleState& module);
/// True if the condition that the row waits for is met.
[[nodiscard]] bool isMet(const action::WaitForInput& wait, const ModuleState& module);
[[nodiscard]] bool isMet(const action::WaitForAnalog& wait, const ModuleState& module);
/// The error is NoSuchPin, NotAnOutput or OutputsUnknown. An output is sent together with the others, which
/// keep their state.
[[nodiscard]] tl::expected<Intent, SequenceProblem::Kind> outputIntent(const action::SetOutput& set,
                                                                       const ModuleState& module);
[[nodiscard]] intent::Home homeIntent(const AxisSettings& settings);
/// The present positions of these axes; an axis whose position is unknown, doubtful or out of date
/// (isLive()), or that of another type of module, is left out.
[[nodiscard]] std::vector<PointAxis> teach(const std::vector<ModuleIndex>& axes, const LinkState& link);

}  // namespace nmc
