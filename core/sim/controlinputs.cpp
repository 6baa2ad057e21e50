// SPDX-License-Identifier: MIT
#include "sim/controlinputs.h"

#include <cmath>

#include "sim/controlwords.h"

namespace nmc::sim {

namespace {

using Word = InputRow::Word;
using Done = tl::expected<void, std::string>;
using Words = std::span<const std::string_view>;

constexpr Chips kAny{"any", [](const ModuleIdentity& one) { return one.type != ModuleType::Io; }};
constexpr Chips kServo{"servo", [](const ModuleIdentity& one) { return one.type == ModuleType::Servo; }};
constexpr Chips kStepper{"step", [](const ModuleIdentity& one) { return one.type == ModuleType::Stepper; }};
constexpr Chips kSc{"servo@10", isSc};
constexpr Chips kIo{"io", [](const ModuleIdentity& one) { return one.type == ModuleType::Io; }};

[[nodiscard]] constexpr InputRow pin(std::string_view name, Input input, Chips chips,
                                     std::string_view meaning) {
    return {name, input, chips, "0 or 1", 0, 1, true, {}, meaning};
}

/// A number, or one of `count` numbers of this name.
[[nodiscard]] constexpr InputRow numeric(std::string_view name, Input input, Chips chips,
                                         std::string_view allowed, double min, double max, bool whole,
                                         std::string_view meaning, unsigned count = 0) {
    return {name, input, chips, allowed, min, max, whole, {}, meaning, count};
}

/// A parameter of a PIC-SERVO's motor, amplifier or encoder.
[[nodiscard]] constexpr InputRow ofMotor(std::string_view name, Input input, std::string_view allowed,
                                         double min, double max, bool whole, std::string_view meaning) {
    return numeric(name, input, kServo, allowed, min, max, whole, meaning);
}

/// A shaft position.
[[nodiscard]] constexpr InputRow place(std::string_view name, Input input, Chips chips,
                                       std::string_view meaning) {
    return {name,   input, chips, "-1e12 to 1e12 counts or none", -1e12, 1e12, true, {Word{"none", {}}},
            meaning};
}

[[nodiscard]] constexpr InputRow limits(Chips chips, std::string_view meaning) {
    return {"limits", Input::Limits,
            chips,    "auto or manual",
            0,        -1,
            true,     {Word{"auto", 1.0}, Word{"manual", 0.0}},
            meaning};
}

// These bounds keep the plant's arithmetic sound; a motor of this class is far inside them.
constexpr std::array kInputs{
    pin("limit1", Input::Limit1, kServo, "pin LIMIT1, 1 is high, as in status bit 5"),
    pin("limit1", Input::Limit1, kStepper, "forward limit switch, 1 is high: no motion forward"),
    pin("limit2", Input::Limit2, kServo, "pin LIMIT2, 1 is high, as in status bit 6"),
    pin("limit2", Input::Limit2, kStepper, "reverse limit switch, 1 is high: no motion in reverse"),
    pin("index", Input::Index, kServo,
        "pin INDEX, 1 is high (auxiliary bit 0 is then 0; of an SC: 1), until the shaft moves on"),
    pin("power", Input::Power, kServo, "motor power: 1 is on, 0 turns the servo off"),
    pin("power", Input::Power, kStepper, "pin PWR_SENSE: 1 is on, 0 lowers AMP_EN and stops"),
    InputRow{"analog",
             Input::Analog,
             kServo,
             "0 to 255 or auto",
             0,
             255,
             true,
             {Word{"auto", {}}},
             "what the A/D converter reads; auto: the motor's current"},
    numeric("analog", Input::Analog, kStepper, "0 to 255", 0, 255, true,
            "what the A/D converter reads; below the thermal limit the motor is off"),
    ofMotor("load", Input::Load, "-100 to 100 N·m", -100, 100, false,
            "torque on the shaft; positive turns it in reverse"),
    ofMotor("inertia", Input::Inertia, "1e-6 to 100 kg·m²", 1e-6, 100, false, "of the rotor with its load"),
    ofMotor("friction", Input::Friction, "0 to 100 N·m", 0, 100, false, "dry friction, against any motion"),
    ofMotor("play", Input::Play, "0 to 10000 counts", 0, 10'000, true,
            "that the shaft turns before the encoder turns with it"),
    ofMotor("counts_per_turn", Input::CountsPerTurn, "4 to 1000000", 4, 1e6, true,
            "edges of the encoder in a turn of the shaft"),
    ofMotor("deadband", Input::Deadband, "0 to 254", 0, 254, true,
            "of the amplifier: PWM counts that put nothing out; 255 is full output still"),
    ofMotor("gain", Input::Gain, "0.1 to 100000 counts/s", 0.1, 1e5, false,
            "speed for a PWM count, without friction and deadband"),
    ofMotor("encoder_noise", Input::EncoderNoise, "0 to 100 counts", 0, 100, false,
            "rms of what the encoder is off by, anew each tick"),
    ofMotor("elastic_inertia", Input::ElasticInertia, "0 to 100 kg·m²", 0, 100, false,
            "of a second mass, on a spring; 0: none"),
    ofMotor("resonance", Input::Resonance, "1 to 400 Hz", 1, 400, false,
            "at which shaft and second mass swing against each other"),
    place("travel_min", Input::TravelMin, kAny, "hard stop, not above the shaft"),
    place("travel_max", Input::TravelMax, kAny, "hard stop, not below the shaft"),
    limits(kServo, "auto: limit1 is 1 at travel_min and limit2 at travel_max, of an SC the other way round"),
    limits(kStepper, "auto: limit1 is 1 at travel_max and limit2 at travel_min"),
    numeric("servo_overrun", Input::ServoOverrun, kServo, "1", 1, 1, true,
            "makes one servo tick take too long"),
    pin("estop", Input::Estop, kStepper, "E-stop, 1 is high: stops"),
    pin("in1", Input::In1, kStepper, "pin IN1, 1 is high"),
    pin("in2", Input::In2, kStepper, "pin IN2, 1 is high"),
    pin("home_switch", Input::HomeSwitch, kStepper, "home switch, 1 is high"),
    place("home_switch_at", Input::HomeSwitchAt, kAny,
          "the home switch (of a servo, at LIMIT1) is 1 from this load position on forward; none: as set"),
    numeric("load_play", Input::LoadPlay, kAny, "0 to 10000 counts", 0, 10'000, true,
            "that the encoder (a stepper's shaft) turns before the load with the home switch turns"),
    numeric("steps", Input::Pulses, kSc, "-32768 to 32767", -32768, 32767, true,
            "number of pulses at the step input; negative: reverse"),
    numeric("vsense", Input::VoltSense, kSc, "0 to 5 V", 0, 5, false,
            "what it senses of the supply: power is on from 0.9 to 4.5 V"),
    numeric("in", Input::Pin, kIo, "0 or 1", 0, 1, true, "pin K of 1 to 12, 1 is high", 12),
    numeric("analog", Input::Analog, kIo, "0 to 255", 0, 255, true, "what A/D input K of 1 to 3 reads", 3),
};

/// Parses a word of the line; returns nothing when the row does not allow it.
std::optional<Word> valueOf(const InputRow& row, std::string_view text) {
    for (const Word& word : row.words)
        if (!text.empty() && word.text == text)
            return word;
    const auto value = numberIn<double>(text);
    // This form of the comparison also refuses NaN.
    if (!value || !(*value >= row.min && *value <= row.max) || (row.whole && *value != std::floor(*value)))
        return std::nullopt;
    return Word{text, value};
}

/// The surroundings of a module, servo or stepper.
struct Surroundings {
    double shaft = 0;
    bool limitsAutomatic = false;
    std::optional<Input> homeSwitch{};  ///< the pin that follows home_switch_at
};

Surroundings surroundings(const ModuleSnapshot& s) {
    if (s.stepper)
        return {static_cast<double>(s.stepper->shaft), s.stepper->limitsAutomatic,
                s.stepper->homeSwitchAt ? std::optional(Input::HomeSwitch) : std::nullopt};
    return {s.servo.shaftCounts, s.servo.limitsAutomatic,
            s.servo.homeSwitchAt ? std::optional(Input::Limit1) : std::nullopt};
}

/// The reason why the module's present state forbids a value that is in range; empty when nothing does.
std::string conflict(const Surroundings& now, Input input, std::optional<double> value) {
    const auto shaft = [&now] { return "the shaft is at " + std::to_string(now.shaft) + " counts"; };
    if ((input == Input::Limit1 || input == Input::Limit2) && now.limitsAutomatic)
        return "the limit switches follow the travel; use limits manual first";
    if (input == now.homeSwitch)
        return "the home switch follows the shaft; use home_switch_at none first";
    if (input == Input::TravelMin && value && *value > now.shaft)
        return shaft() + "; allowed is up to that, or none";
    if (input == Input::TravelMax && value && *value < now.shaft)
        return shaft() + "; allowed is from that on, or none";
    return {};
}

/// `words`: the value, preceded by a number where there are several inputs of that name.
Done setInput(Chain& chain, ModuleIndex module, const InputRow& row, Words words, TimePoint now) {
    const std::string name(row.name);
    if (words.size() != (row.count == 0 ? 1U : 2U))
        return tl::unexpected("wrong number of words for set; allowed is set N " +
                              (row.count == 0 ? "NAME VALUE" : name + " K VALUE"));
    const unsigned which = row.count == 0 ? 0 : numberIn<unsigned>(words[0]).value_or(0);
    if (which > row.count || (row.count > 0 && which == 0))
        return tl::unexpected("no " + name + ' ' + quoted(words[0]) + "; allowed is 1 to " +
                              std::to_string(row.count));
    const std::string_view text = words.back();
    const std::optional<Word> word = valueOf(row, text);
    if (!word)
        return tl::unexpected(name + " cannot be " + quoted(text) + "; allowed is " +
                              std::string(row.allowed));
    const Surroundings around = surroundings(chain.snapshot(module, now));
    if (const std::string why = conflict(around, row.input, word->value); !why.empty())
        return tl::unexpected(why);
    chain.set(module, row.input, word->value, now, which);
    return {};
}

}  // namespace

std::span<const InputRow> inputTable() {
    return kInputs;
}

Done setInput(Chain& chain, ModuleIndex module, Words words, TimePoint now) {
    const ModuleIdentity identity = chain.identity(module);
    std::string names;
    for (const InputRow& row : kInputs) {
        if (!row.chips.include(identity))
            continue;
        if (row.name == words[0])
            return setInput(chain, module, row, words.subspan(1), now);
        names += std::string(names.empty() ? "" : ", ") + std::string(row.name);
    }
    const std::string_view who = identity.type == ModuleType::Stepper ? "a stepper"
                                 : identity.type == ModuleType::Io    ? "a PIC-I/O"
                                                                      : "a servo";
    return tl::unexpected(std::string(who) + " has no input " + quoted(words[0]) + "; allowed are " + names);
}

}  // namespace nmc::sim
