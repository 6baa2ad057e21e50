// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bus/types.h"
#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// The conditions that can end a search for home.
struct HomeConditions {
    bool limit1 = false;
    bool limit2 = false;
    bool index = false;
    bool positionError = false;
    bool currentLimit = false;
    bool homeSwitch = false;

    bool operator==(const HomeConditions&) const = default;
};

/// The information that a search needs from the status of either chip.
struct HomingLook {
    TimePoint time;
    std::int32_t position = 0;
    bool on = false;       ///< servo or amplifier
    bool moving = false;   ///< servo: approaching the goal velocity or position; not whether it turns
    bool waiting = false;  ///< searching for home
    HomeConditions active{};
};

/// Composes the orders of a home search for a PIC-SERVO or a PIC-STEP, and reads their status: all
/// differences between the two are in this class. Pure.
class HomingChip {
public:
    using Orders = std::vector<bus::Order>;
    struct Motion {
        bool reverse = false;
        double velocity = 0.0;  ///< native; the value sent is never faster
        double acceleration = 0.0;
    };

    explicit HomingChip(const ModuleState& module);

    /// Returns nothing before the first complete status.
    [[nodiscard]] std::optional<HomingLook> look(const ModuleState& module) const;
    /// True when a limit input ends a motion, as on a PIC-STEP; a servo's motion in velocity mode does not
    /// end.
    [[nodiscard]] bool stopsMotionItself() const { return m_identity.type == ModuleType::Stepper; }

    /// True when finding home switches the motor off in one way or another.
    [[nodiscard]] bool goesOff(const HomingRecipe& recipe) const;

    [[nodiscard]] Orders clearStickyBits() const;
    /// `goal`: where it ends; without one, it does not end.
    [[nodiscard]] Orders run(const Motion& motion, std::optional<std::int32_t> goal = {}) const;
    /// Starts the chip's search for home.
    [[nodiscard]] Orders watch(const HomeConditions& conditions, HomingRecipe::Stop stop) const;
    /// Starts the chip's search for home and then the motion.
    [[nodiscard]] Orders search(const HomeConditions& conditions, HomingRecipe::Stop stop,
                                const Motion& motion) const;
    [[nodiscard]] Orders stop(HomingRecipe::Stop manner) const;
    /// Ends the chip's search for home.
    [[nodiscard]] Orders disarm() const;
    [[nodiscard]] Orders enable() const;
    [[nodiscard]] Orders zero() const;
    /// Reads a status that includes home; `second`: in a reply of different length.
    [[nodiscard]] Orders read(bool second) const;

private:
    template <typename... Commands>
    [[nodiscard]] Orders orders(const Commands&... commands) const;
    [[nodiscard]] std::uint8_t speed(double stepsPerSecond) const;
    [[nodiscard]] std::uint8_t accelerationTime(double stepsPerSecondSquared) const;

    ModuleIndex m_module;
    ModuleIdentity m_identity;
    double m_speedUnit = 25.0;  ///< PIC-STEP: steps/s of speed 1
    bool m_offOnLimit = false;  ///< PIC-STEP
};

}  // namespace nmc
