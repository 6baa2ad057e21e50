// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/intent/intent.h"
#include "model/settings/machine.h"

/// Determines what opening a machine file would change, before anything is changed. Pure.
namespace nmc {

/// A unit that is applied, or not, as a whole.
enum class MachinePart : std::uint8_t {
    MachineName,
    Rate,
    Groups,   ///< sent to the modules
    Program,  ///< points and sequences, which belong together
    HomeOrder,
    OperatorRights,
    Hardware,  ///< the module that the file is for
    AxisName,
    Unit,
    Motion,
    Travel,
    Backlash,
    Arrival,
    Homing,
    LimitStop,
    WorkOffsets,
    Analog,
    PinNames,
    AccelerationTime,
    Gains,       ///< sent to the module
    Io,          ///< sent to the module
    Parameters,  ///< sent to the module
};

/// Identifies a part of the machine, or of one axis.
struct PartId {
    std::optional<ModuleIndex> module{};
    MachinePart part = MachinePart::MachineName;
    bool operator==(const PartId&) const = default;
};

/// The physical quantity of a number, which determines the unit it is shown in.
enum class Quantity : std::uint8_t { Plain, Distance, Place, Velocity, Acceleration, Seconds };

using FieldValue = std::variant<bool, double, std::string>;

struct FieldDifference {
    std::string key;  ///< without a unit: "Kp", "velocity"
    Quantity quantity = Quantity::Plain;
    std::optional<FieldValue> file{};  ///< empty: not in the file
    std::optional<FieldValue> now{};   ///< empty: unknown, or not set

    bool operator==(const FieldDifference&) const = default;
};

/// The effect of applying a part.
enum class Applying : std::uint8_t {
    ChangesPanel,   ///< only what the panel displays and stores; nothing is sent
    Sends,          ///< also sent to the module
    KeepsUnsent,    ///< goes into the fields and waits there: not connected, or `refusal`
    NotInFile,      ///< no effect: the module is not in the file, and stays as it is
    OtherHardware,  ///< no effect: the file's axis is for another type or version
    NotThere,       ///< the module does not answer; its names and values are kept for when it does
};

struct Difference {
    PartId id;
    std::vector<FieldDifference> fields;
    Applying applying = Applying::ChangesPanel;
    std::optional<Refusal> refusal{};  ///< the precondition that prevents sending it now
    /// Ticked by default: everything possible, except what would be sent to a module that is on.
    bool wanted = true;
    AxisScale scale{};  ///< the scale in which the numbers are shown

    [[nodiscard]] bool possible() const {
        return applying == Applying::ChangesPanel || applying == Applying::Sends ||
               applying == Applying::KeepsUnsent;
    }
    bool operator==(const Difference&) const = default;
};

/// Returns the differences in the order of the machine's modules. `modules`: the connected ones; empty: none.
[[nodiscard]] std::vector<Difference> compare(const Machine& file, const Machine& now,
                                              const std::vector<ModuleState>& modules);

/// True if the chosen rows of a table that was shown are still the same: what they change, and whether that
/// is sent to a module, which may have been switched on since.
[[nodiscard]] bool stillHold(const std::vector<Difference>& shown, const std::vector<Difference>& now,
                             const std::vector<PartId>& chosen);

/// Returns `now` with the chosen parts of the file. Parts of axes for other hardware stay as they are. An
/// axis that changes to another type of module is reset (usable()) if any part of it is chosen, since no
/// number fits both, and removed from the points that are for the other type.
[[nodiscard]] Machine applied(const Machine& file, const Machine& now,
                              const std::vector<ModuleState>& modules, const std::vector<PartId>& chosen);

struct ModuleIntent {
    ModuleIndex module;
    Intent intent;
};
/// Returns what applying the chosen parts would send, by the same rules; a part that cannot be sent now sends
/// nothing. Groups are sent as groupChanges().
[[nodiscard]] std::vector<ModuleIntent> sendings(const Machine& file, const Machine& now,
                                                 const std::vector<ModuleState>& modules,
                                                 const std::vector<PartId>& chosen);

/// Fills in what the connected chain reports about itself where the user has set nothing: the expected
/// modules, as far as their types were heard, and the rate. Used for saving.
[[nodiscard]] Machine withChain(Machine machine, const std::vector<ModuleState>& modules, std::uint32_t baud);

}  // namespace nmc
