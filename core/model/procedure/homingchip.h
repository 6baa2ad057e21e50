// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bus/types.h"
#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// What can end a search for home.
struct HomeConditions {
    bool limit1 = false;
    bool limit2 = false;
    bool index = false;
    bool positionError = false;
    bool currentLimit = false;
    bool homeSwitch = false;

    [[nodiscard]] bool any() const {
        return limit1 || limit2 || index || positionError || currentLimit || homeSwitch;
    }
    bool operator==(const HomeConditions&) const = default;
};

/// What a search has to know of either chip's status.
struct HomingLook {
    TimePoint time;
    std::int32_t position = 0;
    bool on = false;       ///< servo or amplifier
    bool moving = false;   ///< servo: on its way to the goal velocity or position; not that it turns
    bool waiting = false;  ///< for home
    HomeConditions active{};
};

/// Says to a PIC-SERVO or a PIC-STEP what a home search wants of it, and reads what it says: the differences
/// between the two are here only. Pure.
class HomingChip {
public:
    using Orders = std::vector<bus::Order>;
    struct Motion {
        bool reverse = false;
        double velocity = 0.0;  ///< native; what is sent is never faster
        double acceleration = 0.0;
    };

    explicit HomingChip(const ModuleState& module);

    /// Nothing before the first whole status.
    [[nodiscard]] std::optional<HomingLook> look(const ModuleState& module) const;
    /// The chip stops by itself when home is found; otherwise the host must.
    [[nodiscard]] bool stopsByItself() const;
    /// A limit input ends a motion, as on a PIC-STEP; a servo's motion in velocity mode has no end.
    [[nodiscard]] bool stopsMotionItself() const { return m_identity.type == ModuleType::Stepper; }

    /// Finding home switches the motor off, one way or another.
    [[nodiscard]] bool goesOff(const HomingRecipe& recipe) const;

    [[nodiscard]] Orders clearStickyBits() const;
    [[nodiscard]] Orders run(const Motion& motion) const;
    /// From now on the chip looks for home.
    [[nodiscard]] Orders watch(const HomeConditions& conditions, HomingRecipe::Stop stop) const;
    /// The same, then run.
    [[nodiscard]] Orders search(const HomeConditions& conditions, HomingRecipe::Stop stop,
                                const Motion& motion) const;
    [[nodiscard]] Orders stop(HomingRecipe::Stop manner) const;
    /// Does not look for home any more.
    [[nodiscard]] Orders disarm() const;
    [[nodiscard]] Orders enable() const;
    [[nodiscard]] Orders goTo(std::int32_t position, const Motion& motion) const;
    [[nodiscard]] Orders zero() const;
    /// A status with home in it; `second`: in a reply of another length.
    [[nodiscard]] Orders read(bool second) const;

private:
    template <typename... Commands>
    [[nodiscard]] Orders orders(Commands... commands) const;
    [[nodiscard]] std::uint8_t speed(double stepsPerSecond) const;
    [[nodiscard]] std::uint8_t accelerationTime(double stepsPerSecondSquared) const;

    ModuleIndex m_module;
    ModuleIdentity m_identity;
    double m_speedUnit = 25.0;  ///< PIC-STEP: steps/s of speed 1
    bool m_offOnLimit = false;  ///< PIC-STEP
};

}  // namespace nmc
