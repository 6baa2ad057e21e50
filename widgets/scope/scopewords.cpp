// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopewords.h"

#include <array>
#include <cmath>

#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

namespace {

/// In a sample, the auxiliary byte of an SC is in the terms of the other servos (servo::toAuxByte).
std::string_view sheetName(const ScopeBit& bit, const ModuleIdentity& module) {
    const auto index = static_cast<std::size_t>(bit.bit);
    if (module.type == ModuleType::Io) {
        static constexpr std::array<std::string_view, io::kPins> kPinNames{
            "IO1", "IO2", "IO3", "IO4", "IO5", "IO6", "IO7", "IO8", "IO9", "IO10", "IO11", "IO12"};
        return bit.number() < kPinNames.size() ? kPinNames.at(bit.number()) : std::string_view{};
    }
    const bool aux = bit.byte == ScopeBit::Byte::Aux;
    if (module.type == ModuleType::Stepper)
        return (aux ? stepper::kInputBitNames : stepper::kStatusBitNames)[index];
    if (!aux)
        return servo::kStatusBitNames[index];
    return (hasPathBuffer(module) ? servo::kCmcAuxBitNames : servo::kAuxBitNames)[index];
}

}  // namespace

namespace texts {

QString signalName(ScopeSignal signal) {
    switch (signal) {
        case ScopeSignal::Position:
            return Common::tr("position");
        case ScopeSignal::Command:
            return ScopeTexts::tr("command, calculated");
        case ScopeSignal::Error:
            return ScopeTexts::tr("error, calculated");
        case ScopeSignal::Velocity:
            return ScopeTexts::tr("velocity");
        case ScopeSignal::Analog:
            return Common::tr("A/D");
        case ScopeSignal::Acceleration:
            return ScopeTexts::tr("acceleration");
        case ScopeSignal::Pwm:
            return ScopeTexts::tr("PWM, calculated");
        case ScopeSignal::Analog2:
            return ScopeTexts::tr("A/D 2");
        case ScopeSignal::Analog3:
            return ScopeTexts::tr("A/D 3");
        case ScopeSignal::Counter:
            return ScopeTexts::tr("count");
        case ScopeSignal::CountRate:
            return ScopeTexts::tr("count rate");
        case ScopeSignal::Custom1:
        case ScopeSignal::Custom2:
        case ScopeSignal::Custom3:
        case ScopeSignal::Custom4:
            return ScopeTexts::tr("custom trace %1").arg(*customIndex(signal) + 1);
    }
    return {};
}

QString signalName(ScopeSignal signal, const ScopeModule& module) {
    if (const CustomTrace* custom = module.customOf(signal))
        return custom->name;
    if (signal == ScopeSignal::Error && hasPathBuffer(module.identity))
        return ScopeTexts::tr("error, reported");
    const auto input = infoOf(signal).analogInput;
    if (!module.isIo() || !input)
        return signalName(signal);
    const std::string name = PinSettings::of(module.pins.analog, *input).name;
    return name.empty() ? Common::tr("A/D %1").arg(*input + 1) : QString::fromStdString(name);
}

QString signalUnit(ScopeSignal signal, const ScopeModule& module) {
    switch (infoOf(signal).unit) {
        case SignalInfo::Unit::Position:
            return unitOf(module.scale);
        case SignalInfo::Unit::Velocity:
            return measuredVelocityUnitOf(module.scale);
        case SignalInfo::Unit::Acceleration:
            return Common::tr("%1/s²").arg(unitOf(module.scale));
        case SignalInfo::Unit::Analog:
            return QString::fromStdString(module.analogOf(signal).unit);
        case SignalInfo::Unit::Pwm:
            return Common::tr("of 255");
        case SignalInfo::Unit::Count:
            return ScopeTexts::tr("counts");
        case SignalInfo::Unit::CountRate:
            return ScopeTexts::tr("counts/s");
        case SignalInfo::Unit::Custom:
            return module.customOf(signal) != nullptr ? module.customOf(signal)->unit : QString();
    }
    return {};
}

double signalStep(ScopeSignal signal, const ScopeModule& module) {
    const double one = std::abs(module.scaleOf(signal).factor);
    // A tenth of a count for calculated positions and what is filtered, whole counts for values that were
    // reported or are always whole.
    return signal == ScopeSignal::Command || signal == ScopeSignal::Error || customIndex(signal) ? one / 10
                                                                                                 : one;
}

int decimalsAt(double step) {
    return step > 0 ? qBound(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), 9) : 0;
}

QString numberAt(double value, double step) {
    return fixed(value, decimalsAt(step));
}

QString stretch(double seconds) {
    return std::abs(seconds) < 1 ? Common::tr("%1 ms").arg(readout(seconds * 1e3))
                                 : ScopeTexts::tr("%1 s").arg(readout(seconds));
}

QString bitName(const ScopeBit& bit, const ModuleIdentity& module) {
    const std::string_view name = sheetName(bit, module);
    return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

QString bitName(const ScopeBit& bit, const ScopeModule& module) {
    const std::string name =
        module.isIo() ? PinSettings::of(module.pins.pins, bit.number()).name : std::string();
    return name.empty() ? bitName(bit, module.identity) : QString::fromStdString(name);
}

}  // namespace texts

std::vector<ScopeBit> laneBits(const ModuleIdentity& module) {
    std::vector<ScopeBit> bits;
    for (const ScopeBit::Byte byte : {ScopeBit::Byte::Status, ScopeBit::Byte::Aux})
        for (std::uint8_t bit = 0; bit < 8; ++bit)
            if (const ScopeBit one{byte, bit}; !sheetName(one, module).empty())
                bits.push_back(one);
    return bits;
}

std::vector<ScopeBit> usualLaneBits(ModuleType type) {
    constexpr auto kStatus = ScopeBit::Byte::Status;
    constexpr auto kAux = ScopeBit::Byte::Aux;
    if (type == ModuleType::Io)
        return laneBits({type});
    if (type == ModuleType::Stepper)  // moving, power; E-stop, limits, home switch
        return {{kStatus, 0}, {kStatus, 3}, {kAux, 0}, {kAux, 3}, {kAux, 4}, {kAux, 5}};
    // move_done, power_on, servo_on, pos_error, limits
    return {{kStatus, 0}, {kStatus, 3}, {kAux, 2}, {kStatus, 4}, {kStatus, 5}, {kStatus, 6}};
}

}  // namespace nmc
