// SPDX-License-Identifier: MIT
#include "sim/familystate.h"

namespace nmc::sim {

namespace {

using Json = nlohmann::ordered_json;

/// Lists the pins, IO1 first.
Json pinList(std::uint16_t mask) {
    Json pins = Json::array();
    for (unsigned pin = 0; pin < 12; ++pin)
        pins.push_back((unsigned{mask} >> pin & 1U) != 0);
    return pins;
}

}  // namespace

Json ioJson(const IoSnapshot& io) {
    return {{"pins", pinList(io.levels)},
            {"is_input", pinList(io.directions)},
            {"outputs", pinList(io.outputs)},
            {"analog", io.analog},
            {"pwm", io.pwm},
            {"stored_outputs", pinList(io.storedOutputs)},
            {"stored_pwm", io.storedPwm},
            {"timer_mode", !io.counting   ? "off"
                           : io.countsPin ? "counter"
                                          : "timer"},
            {"prescaler", io.prescaler},
            {"count", io.count},
            {"latched_pins", pinList(io.latchedPins)},
            {"latched_count", io.latchedCount}};
}

Json laterServoJson(const ModuleIdentity& module, const ServoSnapshot& servo) {
    const LaterServoSnapshot& s = *servo.later;
    Json json{{"pwm_exact", s.pwm},
              {"path_points", s.pathPoints},
              {"path_mode", s.pathMode},
              {"fast_path", s.fastPath},
              {"advanced_features", s.advancedFeatures}};
    if (!isSc(module))
        return json;
    json.update({{"vsense", s.voltSense},
                 {"limit_stop", s.limitStopsOff        ? "off"
                                : s.limitStopsAbruptly ? "abrupt"
                                                       : "none"},
                 {"three_phase", s.threePhase},
                 {"antiphase", s.antiphase},
                 {"step_and_direction", s.stepAndDirection},
                 {"step_multiplier", servo.gains.sm},
                 {"saved", s.saved ? Json(*s.saved) : Json(nullptr)}});
    return json;
}

}  // namespace nmc::sim
