// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "model/intent/intent.h"
#include "model/module/linkstate.h"
#include "model/settings/machine.h"

/// The methods that other programs may call (docs/api.md): their table, from which `describe` is made, and
/// what each asks of which module. Values are in the units that the user has chosen for the axis. Pure.
namespace nmc::api {

using Json = nlohmann::ordered_json;

/// Major and minor version of the interface, as `hello` states it.
inline constexpr auto kProtocol = "1.1";

/// Gains as the parameters of set_gains; null if they are not known.
[[nodiscard]] Json gainsOf(const std::optional<servo::SetGain>& gains);

/// What a number may be.
struct NumberRange {
    double min;
    double max;
    std::string unit{};     ///< as in the state; empty if it has none
    bool isJogged = false;  ///< in either direction; `max` is the max jog speed of the axis
    bool operator==(const NumberRange&) const = default;
};

/// Why a call is not possible.
struct Problem {
    enum class Kind : std::uint8_t {
        NotJson,
        InvalidRequest,  ///< JSON, but not a request
        NoMethod,
        FieldMissing,
        FieldWrong,  ///< it has another type, or is out of its range
        AxisUnknown,
        AxisAmbiguous,    ///< several axes have this name
        SequenceUnknown,  ///< or point
        NotAnOutput,      ///< the pin is an input
        OutputsUnknown,   ///< or their directions: they were not sent in this connection
        Refused,
    };
    Kind kind;
    std::string field{};                 ///< its name; names with ", " between them if several are missing
    std::optional<Refusal> refusal{};    ///< only for Refused
    std::optional<NumberRange> range{};  ///< of a number that has one, for FieldWrong
    bool operator==(const Problem&) const = default;
};

[[nodiscard]] inline Problem refused(Refusal refusal) {
    return {Problem::Kind::Refused, {}, refusal};
}

/// What a method asks of one module.
struct Call {
    ModuleIndex module;
    std::variant<Intent, bus::HoldToMove> what;
};

/// The parameters of a call about one axis (apimethods.cpp).
struct AxisCall;

/// What a client needs to call a method.
enum class Access : std::uint8_t {
    Read,     ///< nothing
    Control,  ///< the right to move motors, which one client at a time may have
    Stop,     ///< nothing; it passes every queue
};

/// One parameter of a method.
struct Field {
    enum class Kind : std::uint8_t { Axis, Position, Distance, Velocity, Acceleration, Whole, Flag, Text };
    std::string name;
    Kind kind;
    bool required;
    std::string text;
    std::optional<ValueRange> range{};  ///< of a whole number
};

struct Method {
    std::string name;
    Access access;
    std::string text;
    std::vector<Field> fields{};
    /// What it asks of the module; null unless it commands one axis.
    tl::expected<Call, Problem> (AxisCall::*make)() const = nullptr;
};

[[nodiscard]] const std::vector<Method>& methods();
/// Null if there is no such method.
[[nodiscard]] const Method* findMethod(std::string_view name);
/// The table, for `describe`.
[[nodiscard]] Json describe();

/// What a program has requested: a method with the parameters that it knows, which have their types. Others
/// are left out.
struct Request {
    Json id;  ///< null: the program wants no answer
    const Method* method = nullptr;
    Json parameters = Json::object();
};
struct BadRequest {
    Json id;
    Problem problem;
};
/// Reads a line, whatever it holds.
[[nodiscard]] tl::expected<Request, BadRequest> readRequest(std::string_view line);

/// The module that the parameter "axis" means, by its number from 1 or by its name. Without a chain, none can
/// be meant.
[[nodiscard]] tl::expected<ModuleIndex, Problem> axisOf(const Json& parameters, const LinkState& link,
                                                        const Machine& machine);

/// The call of a method that has `make`. The parameters are those of a Request. Whether it is possible now is
/// for plan() to say.
[[nodiscard]] tl::expected<Call, Problem> callOf(const Method& method, const Json& parameters,
                                                 const LinkState& link, const Machine& machine);

}  // namespace nmc::api
