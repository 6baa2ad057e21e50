// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "model/intent/travel.h"
#include "model/scope/history.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"
#include "widgets/scope/tracedrawing.h"

namespace nmc {

/// How the scope reads the samples of one module.
struct ScopeModule {
    QString name;  ///< "Module 2", or the user's name for it
    ModuleIdentity identity;
    AxisScale scale;
    AnalogScale analog;
    std::optional<TravelRange> travel{};  ///< its travel limits, while they are in force
    PinSettings pins{};                   ///< PIC-I/O: names, and the scales of its A/D values

    [[nodiscard]] bool isIo() const { return identity.type == ModuleType::Io; }
    /// Scale of one of its A/D values.
    [[nodiscard]] AnalogScale analogOf(ScopeSignal signal) const {
        const auto input = infoOf(signal).analogInput;
        return isIo() && input ? PinSettings::of(pins.analog, *input).scale : analog;
    }
    [[nodiscard]] LinearScale scaleOf(ScopeSignal signal) const {
        switch (infoOf(signal).unit) {
            case SignalInfo::Unit::Position:
            case SignalInfo::Unit::Velocity:
            case SignalInfo::Unit::Acceleration:
                return {scale.position(1.0), 0.0};
            case SignalInfo::Unit::Analog:
                return {analogOf(signal).perCount, analogOf(signal).atZero};
            case SignalInfo::Unit::Pwm:
            case SignalInfo::Unit::Count:
            case SignalInfo::Unit::CountRate:
                break;
        }
        return {};
    }
    /// True if its samples contain this signal and not another one in its place: a PIC-I/O has no motor, and
    /// the other modules have only one A/D input and no counter.
    [[nodiscard]] bool has(ScopeSignal signal) const {
        return infoOf(signal).owner != (isIo() ? SignalInfo::Owner::Motor : SignalInfo::Owner::Io);
    }
    /// True if the signal is meaningful for this module: a PIC-STEP always follows its steps, so it has no
    /// position error and no control filter, and its A/D value is not a motor current (DS-S 5.2).
    [[nodiscard]] bool reports(ScopeSignal signal) const {
        const SignalInfo& info = infoOf(signal);
        return has(signal) && (identity.type != ModuleType::Stepper ||
                               (!info.calculated && info.unit != SignalInfo::Unit::Analog));
    }
    /// Travel limits to draw across the strip of a signal, in the unit in which it is shown.
    [[nodiscard]] std::vector<double> limitsOf(ScopeSignal signal) const {
        std::vector<double> limits;
        if (travel && (signal == ScopeSignal::Position || signal == ScopeSignal::Command))
            for (const auto& limit : {travel->lowest, travel->highest})
                if (limit)
                    limits.push_back(scaleOf(signal)(*limit));
        return limits;
    }
    bool operator==(const ScopeModule&) const = default;
};

/// A signal in a strip; if `module` is empty, that of the module selected in the window.
struct SignalRef {
    std::optional<ModuleIndex> module;
    ScopeSignal signal = ScopeSignal::Position;
    auto operator<=>(const SignalRef&) const = default;
};

}  // namespace nmc
