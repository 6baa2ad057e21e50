// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/intent/intent.h"
#include "model/settings/machine.h"

/// What opening a machine file would change, before anything is changed. Pure.
namespace nmc {

/// What is applied, or not, as one.
enum class MachinePart : std::uint8_t {
    MachineName,
    Rate,
    Groups,
    Program,  ///< points and sequences, which belong together
    HomeOrder,
    OperatorRights,
    Hardware,  ///< which module the file is for; applying changes nothing
    AxisName,
    Unit,
    Motion,
    Travel,
    Backlash,
    Homing,
    LimitStop,
    Analog,
    PinNames,
    AccelerationTime,
    Gains,       ///< sent
    Io,          ///< sent
    Parameters,  ///< sent
};

/// A part of the machine, or of one axis.
struct PartId {
    std::optional<ModuleIndex> module{};
    MachinePart part = MachinePart::MachineName;
    bool operator==(const PartId&) const = default;
};

/// What a number is of, for the unit it is shown in.
enum class Quantity : std::uint8_t { Plain, Distance, Place, Velocity, Acceleration, Seconds };

using FieldValue = std::variant<bool, double, std::string>;

struct FieldDifference {
    std::string key;  ///< without a unit: "Kp", "velocity"
    Quantity quantity = Quantity::Plain;
    std::optional<FieldValue> file{};  ///< empty: not in the file
    std::optional<FieldValue> now{};   ///< empty: unknown, or not set
};

/// What applying a part does.
enum class Applying : std::uint8_t {
    ChangesPanel,   ///< only what the panel shows and knows; nothing is sent
    Sends,          ///< the module is told, too
    KeepsUnsent,    ///< it goes into the fields and waits there: not connected, or `refusal`
    NotInFile,      ///< nothing: the module is not in the file, and stays as it is
    OtherHardware,  ///< nothing: the file's axis is for another type or version
    NotThere,       ///< the module does not answer; its names and values are kept for when it does
};

struct Difference {
    PartId id;
    std::vector<FieldDifference> fields;
    Applying applying = Applying::ChangesPanel;
    std::optional<Refusal> refusal{};  ///< why it would not be sent now
    /// Ticked at first: everything that is possible, but nothing that is sent to a module that is on.
    bool wanted = true;
    AxisScale scale{};  ///< what the numbers are shown in

    [[nodiscard]] bool possible() const {
        return applying == Applying::ChangesPanel || applying == Applying::Sends ||
               applying == Applying::KeepsUnsent;
    }
};

/// In the order of the machine's modules. `modules`: what is connected; empty: nothing.
[[nodiscard]] std::vector<Difference> compare(const Machine& file, const Machine& now,
                                              const std::vector<ModuleState>& modules);

/// `now` with the chosen parts of the file. Parts of axes that are for other hardware stay as they are.
[[nodiscard]] Machine applied(const Machine& file, const Machine& now,
                              const std::vector<ModuleState>& modules, const std::vector<PartId>& chosen);

struct ModuleIntent {
    ModuleIndex module;
    Intent intent;
};
/// What the chosen parts send, by the same rules; a part that cannot be sent now sends nothing.
[[nodiscard]] std::vector<ModuleIntent> sendings(const Machine& file, const Machine& now,
                                                 const std::vector<ModuleState>& modules,
                                                 const std::vector<PartId>& chosen);

/// The machine with what the connected chain says of itself where the user has not said anything: which
/// modules are expected, and the rate. To be saved.
[[nodiscard]] Machine withChain(Machine machine, const std::vector<ModuleState>& modules, std::uint32_t baud);

}  // namespace nmc
