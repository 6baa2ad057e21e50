// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/modelwords.h"

#include <QCoreApplication>
#include <cmath>

#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/gainsmeaning.h"
#include "widgets/response/responsewords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {
class ModelTexts {
    Q_DECLARE_TR_FUNCTIONS(ModelTexts)
};

Measured inMilliseconds(const Measured& seconds) {
    return {seconds.value * 1e3, seconds.doubt * 1e3};
}
}  // namespace

QStringList motorFound(const Identified& found) {
    const MotorModel& motor = found.motor;
    QStringList lines{
        ModelTexts::tr("Gain %1").arg(plusMinus(motor.gain, ModelTexts::tr("counts/s per PWM count"))),
        ModelTexts::tr("Time constant %1")
            .arg(plusMinus(inMilliseconds(motor.timeConstant), Common::tr("ms"))),
        ModelTexts::tr("Friction %1").arg(plusMinus(motor.friction, ModelTexts::tr("of 255 PWM"))),
        ModelTexts::tr("Load %1").arg(plusMinus(motor.load, ModelTexts::tr("of 255 PWM"))),
        ModelTexts::tr("Model error %1 counts RMS; encoder and timing account for %2.")
            .arg(readout(found.missed, 2), readout(found.expected, 2))};
    const auto isThere = [](const Measured& measured) { return measured.value > 2 * measured.doubt; };
    if (isThere(motor.deadband))
        lines.insert(3, ModelTexts::tr("Amplifier deadband %1")
                            .arg(plusMinus(motor.deadband, ModelTexts::tr("of 255 PWM"))));
    if (isThere(motor.play))
        lines.insert(3, ModelTexts::tr("Play %1").arg(plusMinus(motor.play, ModelTexts::tr("counts"))));
    if (motor.rigidUpTo && *motor.rigidUpTo < kHighestResonance)
        lines << ModelTexts::tr("A resonance above %1 Hz would not show; the margins allow for one.")
                     .arg(std::lround(*motor.rigidUpTo));
    if (!motor.isSure())
        lines << ModelTexts::tr(
            "Uncertain: step once more. Until then the suggested gains are conservative.");
    return lines;
}

QString motorNotFound(IdentifyFailure failure) {
    switch (failure) {
        case IdentifyFailure::TooFewSamples:
            return ModelTexts::tr("Too few samples. Record for longer, or raise the baud rate.");
        case IdentifyFailure::DoesNotMove:
            return ModelTexts::tr(
                "The shaft did not move. Check motor power and brake, or use a larger step.");
        case IdentifyFailure::WrongWay:
            return ModelTexts::tr(
                "The shaft moved away from its goal. Check the direction on the Axis page.");
        case IdentifyFailure::Oscillates:
            return ModelTexts::tr("The motor keeps oscillating. Lower Kp or raise Kd, then step again.");
        case IdentifyFailure::NotExplained:
            return ModelTexts::tr(
                "The model does not fit the step. Check for backlash, an elastic belt, a hard stop or a current limit.");
        case IdentifyFailure::Play:
            return ModelTexts::
                tr("The motor probably has more than %1 counts of play: that much motion is lost at each reversal. Take up the play between motor and encoder.")
                    .arg(kMostPlay);
        case IdentifyFailure::Obstacle:
            return ModelTexts::tr(
                "The motor stopped abruptly short of its goal. Something is in its way: a hard stop, or its load. Clear the way, or step in the other direction.");
        case IdentifyFailure::GainUnclear:
            return ModelTexts::tr(
                "These steps do not determine the motor gain. Add a larger step, so that the motor gets close to a steady speed.");
        case IdentifyFailure::TimeConstantUnclear:
            return ModelTexts::tr(
                "These steps do not determine the time constant. Repeat the step, or raise the baud rate.");
    }
    return {};
}

QString gainsInShort(const servo::SetGain& gains) {
    QStringList parts;
    for (const Gain gain : kAllGains)
        if (const auto value = gainOf(gains, gain))
            parts << u"%1 %2"_s.arg(gainLetters(gain)).arg(*value);
    return parts.join(u", "_s);
}

QStringList predicted(const Prediction& prediction) {
    QStringList lines{ModelTexts::tr("Overshoot %1, settling %2")
                          .arg(responseOvershoot(prediction.overshoot), responseTime(prediction.settling)),
                      ModelTexts::tr("Steady-state error %1 counts").arg(plusMinus(prediction.errorAtRest))};
    if (prediction.unsettled > kSeldom)
        lines << ModelTexts::tr("In %1 of 100 cases the motor stops too far from its goal.")
                     .arg(std::lround(prediction.unsettled * 100));
    const QString phase = plusMinus(prediction.phaseMargin);
    lines << (prediction.gainMargin ? ModelTexts::tr("Phase margin %1°, gain margin %2")
                                          .arg(phase, plusMinus(*prediction.gainMargin))
                                    : ModelTexts::tr("Phase margin %1°").arg(phase));
    return lines;
}

}  // namespace nmc::texts
