// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "model/intent/travel.h"
#include "model/scope/customsignal.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"
#include "widgets/scope/signalref.h"

namespace nmc {

/// A signal that the user has defined, as it is shown for one module.
struct CustomTrace {
    QString name, unit;
    double step = 1;  ///< in its unit, in which its values are meaningful; CustomSignal counts these steps
    CustomSignal signal{};
    bool operator==(const CustomTrace&) const = default;
};

/// How the scope reads the samples of one module.
struct ScopeModule {
    QString name;  ///< "Module 2", or the user's name for it
    ModuleIdentity identity;
    AxisScale scale;
    AnalogScale analog;
    std::optional<TravelRange> travel{};  ///< its travel limits, while they are in force
    PinSettings pins{};                   ///< PIC-I/O: names, and the scales of its A/D values
    /// The user's, as far as their parts are there.
    std::array<std::optional<CustomTrace>, kCustomSignals> custom{};

    [[nodiscard]] bool isIo() const { return identity.type == ModuleType::Io; }
    /// Scale of one of its A/D values.
    [[nodiscard]] AnalogScale analogOf(ScopeSignal signal) const {
        const auto input = infoOf(signal).analogInput;
        return isIo() && input ? PinSettings::of(pins.analog, *input).scale : analog;
    }
    /// Null unless the signal is one of the user's that can be shown.
    [[nodiscard]] const CustomTrace* customOf(ScopeSignal signal) const {
        const auto index = customIndex(signal);
        return index && custom[*index] ? &*custom[*index] : nullptr;
    }
    [[nodiscard]] LinearScale scaleOf(ScopeSignal signal) const {
        switch (infoOf(signal).unit) {
            case SignalInfo::Unit::Position:
            case SignalInfo::Unit::Velocity:
            case SignalInfo::Unit::Acceleration:
                return {scale.position(1.0), 0.0};
            case SignalInfo::Unit::Analog:
                return {analogOf(signal).perCount, analogOf(signal).atZero};
            case SignalInfo::Unit::Custom:
                return {customOf(signal) != nullptr ? customOf(signal)->step : 1.0, 0.0};
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
        if (customIndex(signal))
            return customOf(signal) != nullptr;
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

}  // namespace nmc
