// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <optional>

#include "protocol/servocommands.h"

namespace nmc {

enum class Gain : std::uint8_t { Kp, Kd, Ki, Il, Ol, Cl, El, Sr, Db };
inline constexpr std::array<Gain, 9> kAllGains{Gain::Kp, Gain::Kd, Gain::Ki, Gain::Il, Gain::Ol,
                                               Gain::Cl, Gain::El, Gain::Sr, Gain::Db};

/// The value of one gain; empty only for a deadband that was not sent.
[[nodiscard]] std::optional<int> gainOf(const servo::SetGain& gains, Gain gain);
void setGain(servo::SetGain& gains, Gain gain, int value);

struct GainFacts {
    QString letters;  ///< "Kp": those of the data sheet
    QString name;     ///< "Position gain"
    ValueRange range{};
    QString meaning;  ///< what it does, and what the data sheet advises (DS-V 4.3, 5.2)
};
[[nodiscard]] GainFacts gainFacts(Gain gain);
[[nodiscard]] QString gainLetters(Gain gain);
/// What a value means: "1 953 Hz", "off"; empty if the number is enough.
[[nodiscard]] QString gainRemark(Gain gain, int value);
/// 0, or the least value that the chip accepts.
[[nodiscard]] int zeroValue(Gain gain);

/// Those of Kp, Kd, Ki, OL and SR that change to more than twice or less than half, with both values: with
/// the servo on, such a change needs a confirmation.
[[nodiscard]] QStringList largeSteps(const servo::SetGain& from, const servo::SetGain& to);

/// Which A/D values mean overcurrent; the chip distinguishes them by the parity of CL (DS-V 4.5).
enum class CurrentSense : std::uint8_t { Off, Above, Below };
[[nodiscard]] CurrentSense currentSense(int cl);
/// The CL of that sense nearest to `cl`; for Below, 254 if `cl` is 0.
[[nodiscard]] int currentLimit(CurrentSense sense, int cl);

}  // namespace nmc
