// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/gainsmeaning.h"

#include <QCoreApplication>

#include "base/time.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
class Gains {
    Q_DECLARE_TR_FUNCTIONS(Gains)
};

/// Visits the field of `gains` that holds `gain`; kAllGains is in the order of the fields.
void visit(auto& gains, Gain gain, const auto& visitor) {
    std::size_t place = 0;
    servo::forEachGain(gains, [&](const std::string& /*name*/, auto& field, ValueRange /*range*/) {
        if (place++ == static_cast<std::size_t>(gain))
            visitor(field);
    });
}
}  // namespace

std::optional<int> gainOf(const servo::SetGain& gains, Gain gain) {
    std::optional<int> result;
    visit(gains, gain, [&result](const auto& field) { result = field; });
    return result;
}

void setGain(servo::SetGain& gains, Gain gain, int value) {
    visit(gains, gain, [value]<typename T>(T& field) { field = static_cast<T>(value); });
}

GainFacts gainFacts(Gain gain) {
    switch (gain) {
        case Gain::Kp:
            return {
                u"Kp"_s, Gains::tr("Position gain"), servo::kGainRange,
                Gains::tr(
                    "Kp, position gain: output per count of position error. Set Kd first; then raise Kp with small, fast test moves until the motor starts to overshoot, and back off a little.")};
        case Gain::Kd:
            return {
                u"Kd"_s, Gains::tr("Derivative gain"), servo::kGainRange,
                Gains::tr(
                    "Kd, derivative gain: damping. Start here, with Kp and Ki at 0: raise Kd until the motor starts to hum, then back off a little.")};
        case Gain::Ki:
            return {
                u"Ki"_s, Gains::tr("Integral gain"), servo::kGainRange,
                Gains::tr(
                    "Ki, integral gain: removes the steady-state error that Kp and Kd leave. Set IL to 16000 first, then raise Ki until the error settles fast enough. Adds some overshoot.")};
        case Gain::Il:
            return {
                u"IL"_s, Gains::tr("Integration limit"), servo::kGainRange,
                Gains::tr(
                    "IL, integration limit: limits the integral of the error. Last, lower it to the smallest value that still removes the steady-state error. 0 clears the integral.")};
        case Gain::Ol:
            return {
                u"OL"_s, Gains::tr("Output limit"), servo::kByteRange,
                Gains::tr(
                    "OL, output limit: the largest PWM value; 255 is 100 %. Use 127 for a 12 V motor on a 24 V supply.")};
        case Gain::Cl:
            return {
                u"CL"_s, Common::tr("Current limit"), servo::kByteRange,
                Gains::tr(
                    "CL, current limit, compared with the A/D value. 0: off. Odd: limits while the A/D value is above CL. Even: limits while it is below CL.")};
        case Gain::El:
            return {
                u"EL"_s, Gains::tr("Position error limit"), servo::kPositionErrorRange,
                Gains::tr(
                    "EL, position error limit in counts: the servo switches off when the error exceeds it, for example after a collision or a stall.")};
        case Gain::Sr:
            return {
                u"SR"_s, Gains::tr("Servo rate divisor"), servo::kServoRateRange,
                Gains::tr(
                    "SR, servo rate divisor: one servo tick is SR × 0.512 ms. A slower rate damps heavy loads with less Kd. Changing SR changes the meaning of every velocity and acceleration.")};
        case Gain::Db:
            return {
                u"DB"_s, Gains::tr("Deadband compensation"), servo::kByteRange,
                Gains::tr(
                    "DB, deadband compensation: added to every PWM value except 0, for amplifiers with a deadband near zero. Version 4 and later.")};
    }
    return {};
}

QString gainLetters(Gain gain) {
    return gainFacts(gain).letters;
}

QString gainRemark(Gain gain, int value) {
    switch (gain) {
        case Gain::Kp:
        case Gain::Kd:
        case Gain::Ki:
        case Gain::Il:
        case Gain::Db:
            return {};
        case Gain::Ol:
            return Gains::tr("%1 %").arg(qRound(value * 100.0 / 255.0));
        case Gain::Cl:
            if (value == 0)
                return Common::tr("off");
            return value % 2 != 0 ? Gains::tr("A/D above") : Gains::tr("A/D below");
        case Gain::El:
            return texts::unitCounts();
        case Gain::Sr:
            return Common::tr("%1 Hz").arg(texts::readout(ticksPerSecond(value), 4));
    }
    return {};
}

int zeroValue(Gain gain) {
    return static_cast<int>(gainFacts(gain).range.min);
}

QStringList largeSteps(const servo::SetGain& from, const servo::SetGain& to) {
    QStringList steps;
    for (const Gain gain : {Gain::Kp, Gain::Kd, Gain::Ki, Gain::Ol, Gain::Sr}) {
        const int before = gainOf(from, gain).value_or(0);
        const int after = gainOf(to, gain).value_or(0);
        if (after > 2 * before || before > 2 * after)
            steps << Gains::tr("%1 from %2 to %3").arg(gainLetters(gain)).arg(before).arg(after);
    }
    return steps;
}

CurrentSense currentSense(int cl) {
    if (cl == 0)
        return CurrentSense::Off;
    return cl % 2 != 0 ? CurrentSense::Above : CurrentSense::Below;
}

int currentLimit(CurrentSense sense, int cl) {
    constexpr int kLargestEven = 254;
    switch (sense) {
        case CurrentSense::Off:
            return 0;
        case CurrentSense::Above:
            return cl | 1;
        case CurrentSense::Below:
            return cl == 0 ? kLargestEven : cl - cl % 2 == 0 ? 2 : cl - cl % 2;
    }
    return 0;
}

}  // namespace nmc
