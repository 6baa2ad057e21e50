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
    QString name;  ///< "Module 2", or the user's
    ModuleIdentity identity;
    AxisScale scale;
    AnalogScale analog;
    std::optional<TravelRange> travel{};  ///< its limits, while they are in force
    PinSettings pins{};                   ///< PIC-I/O: names, and the scales of its A/D values

    [[nodiscard]] bool isIo() const { return identity.type == ModuleType::Io; }
    /// What one of its A/D values means.
    [[nodiscard]] AnalogScale analogOf(ScopeSignal signal) const {
        const auto input = analogInputOf(signal);
        return isIo() && input ? PinSettings::of(pins.analog, *input).scale : analog;
    }
    [[nodiscard]] LinearScale scaleOf(ScopeSignal signal) const {
        if (analogInputOf(signal))
            return {analogOf(signal).perCount, analogOf(signal).atZero};
        if (signal == ScopeSignal::Pwm || signal == ScopeSignal::Counter || signal == ScopeSignal::CountRate)
            return {};
        return {scale.position(1.0), 0.0};
    }
    /// In its samples there is nothing else in the place of this signal: a PIC-I/O has no motor, and the
    /// others have no more than one A/D input and no counter.
    [[nodiscard]] bool has(ScopeSignal signal) const {
        return isIo() ? signal == ScopeSignal::Analog || isOfIo(signal) : !isOfIo(signal);
    }
    /// A PIC-STEP follows its steps: it has no position error, no control filter, and its A/D value is no
    /// motor current (DS-S 5.2).
    [[nodiscard]] bool reports(ScopeSignal signal) const {
        if (!has(signal))
            return false;
        return identity.type != ModuleType::Stepper ||
               (!isCalculated(signal) && signal != ScopeSignal::Analog);
    }
    /// What is drawn across the strip of a signal, in the unit it is shown in.
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

/// A signal in a strip; no module: that of the module that is selected in the window.
struct SignalRef {
    std::optional<ModuleIndex> module;
    ScopeSignal signal = ScopeSignal::Position;
    auto operator<=>(const SignalRef&) const = default;
};

}  // namespace nmc
