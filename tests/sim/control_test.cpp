// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

class Control : public testing::Test {
protected:
    Control() : wire("servo,servo@2") { wire.address(2); }
    nlohmann::json say(std::string_view line, const std::optional<Pace>& pace = {}) {
        const std::string answer = handleControlLine(wire.chain, line, wire.now, pace);
        EXPECT_EQ(answer.find('\n'), std::string::npos);
        return nlohmann::json::parse(answer);
    }
    std::string errorOf(std::string_view line) {
        const auto answer = say(line);
        EXPECT_EQ(answer.size(), 1U) << line;
        return answer.value("error", "");
    }
    HostWire wire;
};

TEST_F(Control, StateTellsTheTruthAboutAModule) {
    wire.gains(gainData(200, 2000, 20, 300, 255, 101, 4000, 2, 7));
    wire.servoOn();
    wire.command(1, 0x57, {0x11, 50, 0, 0, 0});
    wire.wait(milliseconds(300));
    const auto s = say("state 1");
    EXPECT_EQ(s["module"], 1);
    EXPECT_EQ(s["type"], "servo");
    EXPECT_EQ(s["version"], 4);
    EXPECT_EQ(s["address"], 1);
    EXPECT_EQ(s["group"], 255);
    EXPECT_EQ(s["leader"], false);
    EXPECT_EQ(s["baud"], 19531);
    EXPECT_DOUBLE_EQ(s["time"], toSeconds(wire.now.time_since_epoch()));
    EXPECT_NEAR(s["tick"].get<double>(), toSeconds(wire.now.time_since_epoch()) / 512e-6, 1.0);
    EXPECT_EQ(s["command_position"], 50.0);
    EXPECT_NEAR(s["position"].get<int>(), 50, 3);
    EXPECT_EQ(s["position_error"].get<double>(), 50.0 - s["position"].get<int>());
    EXPECT_EQ(s["servo_on"], true);
    EXPECT_EQ(s["amp_enabled"], true);
    EXPECT_EQ(s["power"], true);
    EXPECT_EQ(s["mode"], "stop-here");
    EXPECT_EQ(s["home"], 0);
    EXPECT_EQ(s["limit1"], false);
    EXPECT_EQ(s["gains"], (nlohmann::json{{"kp", 200},
                                          {"kd", 2000},
                                          {"ki", 20},
                                          {"il", 300},
                                          {"ol", 255},
                                          {"cl", 101},
                                          {"el", 4000},
                                          {"sr", 2},
                                          {"db", 7}}));
    for (const char* key : {"velocity", "pwm", "current_limit_adjustment", "limit2", "index"})
        EXPECT_TRUE(s.contains(key)) << key;
    EXPECT_EQ(say("state 2")["version"], 2);
    EXPECT_EQ(say("state 2")["mode"], "pwm");
}

// DS-V 5.2: velocities are "in units of counts per servo tick", which SR 4 makes four times as long.
TEST_F(Control, StateTellsVelocitiesPerServoTick) {
    wire.enableAmplifier();
    wire.pwm(40);
    wire.wait(milliseconds(300));
    const double perTick = say("state 1")["velocity"].get<double>();
    ASSERT_GT(perTick, 10);
    wire.gains(gainData(0, 0, 0, 0, 0, 0, 0, 4, 0));
    wire.waitTicks(60);
    const auto s = say("state 1");
    EXPECT_NEAR(s["velocity"].get<double>(), 4 * perTick, 0.1 * perTick);
    EXPECT_NEAR(s["velocity"].get<double>(), s["command_velocity"].get<double>(), 1.1)
        << "with the servo off, the command follows the motor";
}

// DS-V 5.2, 5.3: move done 01, power 08, position error 10, limit 1 20, home in progress 80.
TEST_F(Control, StateTellsTheStatusThatTheHostWouldGet) {
    EXPECT_EQ(say("state 1")["status"], 0x19);
    EXPECT_EQ(say("state 1")["auxiliary"], 0x00) << "the index pin is high";
    EXPECT_EQ(say("state 1")["status_items"], 0);
    wire.command(1, 0x12, {0x2F});
    wire.command(1, 0x13, {0x10});
    say("set 1 limit1 1");
    say("set 1 servo_overrun 1");
    wire.waitTicks(2);
    auto s = say("state 1");
    EXPECT_EQ(s["status_items"], 0x2F) << "Read Status applies only once";
    EXPECT_EQ(s["status"], 0x39);
    EXPECT_EQ(s["auxiliary"], 0x20);
    EXPECT_EQ(
        s["sticky"],
        (nlohmann::json{
            {"overcurrent", false}, {"pos_error", true}, {"pos_wrap", false}, {"servo_overrun", true}}));
    wire.command(1, 0x0B);
    EXPECT_EQ(say("state 1")["sticky"]["servo_overrun"], false);
    EXPECT_EQ(say("state 2")["status"], 0x19) << "module 2 is not affected";
}

TEST_F(Control, StateTellsWhatAHomeSearchWaitsForAndWhatItWillDo) {
    const nlohmann::json none = nlohmann::json::array();
    EXPECT_EQ(say("state 1")["homing"], false);
    EXPECT_EQ(say("state 1")["homing_conditions"], none);
    wire.command(1, 0x19, {0x01 | 0x08 | 0x40 | 0x80 | 0x20});
    auto s = say("state 1");
    EXPECT_EQ(s["homing"], true);
    EXPECT_EQ(s["homing_conditions"], nlohmann::json({"limit1", "index", "position_error", "current_limit"}));
    EXPECT_EQ(s["homing_stop"], "smooth");
    say("set 1 limit1 1");
    wire.waitTicks(2);
    s = say("state 1");
    EXPECT_EQ(s["homing"], false);
    EXPECT_EQ(s["homing_conditions"], none) << "found";
    EXPECT_EQ(s["homing_stop"], "none");

    wire.command(2, 0x19, {0x12});
    EXPECT_EQ(say("state 2")["homing_conditions"], nlohmann::json({"limit2"}));
    EXPECT_EQ(say("state 2")["homing_stop"], "none") << "version 2 leaves that to the host";
}

TEST_F(Control, StateTellsASteppersParametersAndHomeSearch) {
    wire = HostWire("step");
    wire.address(1);
    auto s = say("state 1");
    EXPECT_TRUE(s["parameters"].is_null()) << "they must be set before any motion";
    EXPECT_EQ(s["status"], 0x08);
    wire.command(1, 0x56, {0x1E, 3, 200, 80, 5});
    const nlohmann::json parameters{
        {"speed_mode", 2},    {"ignore_limits", true},  {"ignore_estop", true},  {"motor_off_on_stop", true},
        {"minimum_speed", 3}, {"running_current", 200}, {"holding_current", 80}, {"thermal_limit", 5}};
    EXPECT_EQ(say("state 1")["parameters"], parameters);

    // In motion the speed mode and the minimum speed stay (DS-S 5.1).
    wire.command(1, 0x17, {0x01});
    wire.command(1, 0x34, {0x86, 20, 1});
    wire.waitTicks(10);
    wire.command(1, 0x56, {0x03, 9, 100, 40, 0});
    s = say("state 1");
    EXPECT_EQ(s["moving"], true);
    EXPECT_EQ(s["parameters"], (nlohmann::json{{"speed_mode", 2},
                                               {"ignore_limits", false},
                                               {"ignore_estop", false},
                                               {"motor_off_on_stop", false},
                                               {"minimum_speed", 3},
                                               {"running_current", 100},
                                               {"holding_current", 40},
                                               {"thermal_limit", 0}}));
    wire.command(1, 0x19, {0x1A});
    s = say("state 1");
    EXPECT_EQ(s["homing_conditions"], nlohmann::json({"limit2", "home_switch"}));
    EXPECT_EQ(s["homing_stop"], "abrupt");
    say("set 1 in2 1");
    EXPECT_EQ(say("state 1")["inputs_byte"], 0x04);
}

TEST_F(Control, SetReachesTheInputsAndTheLoad) {
    for (const char* line :
         {"set 1 limit1 1", "set 1 limit2 1", "set 1 index 0", "set 1 power 0", "set 1 analog 77",
          "set 1 load -0.25", "set 1 inertia 2.5e-5", "set 1 friction 0.01", "set 1 travel_min -1000",
          "set 1 travel_max 1000", "set 1 limits manual"})
        EXPECT_EQ(say(line), (nlohmann::json{{"ok", true}})) << line;
    const auto s = say("state 1");
    EXPECT_EQ(s["limit1"], true);
    EXPECT_EQ(s["limit2"], true);
    EXPECT_EQ(s["index"], false);
    EXPECT_EQ(s["power"], false);
    EXPECT_EQ(s["analog"], 77);
    say("set 1 analog auto");
    EXPECT_EQ(say("state 1")["analog"], 0);
    say("set 1 limits auto");
    EXPECT_EQ(say("state 1")["limit1"], false) << "away from the stop";
    EXPECT_EQ(say("state 2")["limit1"], false) << "module 2 is not affected";
}

TEST_F(Control, StateTellsWhatWasSet) {
    auto s = say("state 1");
    EXPECT_EQ(s["load"], 0.0);
    EXPECT_EQ(s["inertia"], 1.7e-5);
    EXPECT_EQ(s["friction"], 0.004);
    EXPECT_TRUE(s["travel_min"].is_null() && s["travel_max"].is_null()) << s;
    EXPECT_TRUE(s["analog_input"].is_null());
    EXPECT_EQ(s["limits"], "manual");
    EXPECT_EQ(s["addr_broken"], false);
    for (const char* line :
         {"set 1 load -0.25", "set 1 inertia 2.5e-5", "set 1 friction 0.01", "set 1 travel_min -1000",
          "set 1 travel_max 2000", "set 1 limits auto", "set 1 analog 77", "break 1"})
        say(line);
    s = say("state 1");
    EXPECT_EQ(s["load"], -0.25);
    EXPECT_EQ(s["inertia"], 2.5e-5);
    EXPECT_EQ(s["friction"], 0.01);
    EXPECT_EQ(s["travel_min"], -1000.0);
    EXPECT_EQ(s["travel_max"], 2000.0);
    EXPECT_EQ(s["analog_input"], 77);
    EXPECT_EQ(s["limits"], "auto");
    EXPECT_EQ(s["addr_broken"], true);
    say("set 1 travel_max none");
    say("mend 1");
    EXPECT_TRUE(say("state 1")["travel_max"].is_null());
    EXPECT_EQ(say("state 1")["addr_broken"], false);
    EXPECT_EQ(say("state 2")["load"], 0.0) << "module 2 is not affected";
}

TEST_F(Control, StateTellsWhatASteppersShaftWorks) {
    wire = HostWire("step");
    auto s = say("state 1");
    for (const char* key : {"travel_min", "travel_max", "home_switch_at"})
        EXPECT_TRUE(s[key].is_null()) << key;
    EXPECT_EQ(s["limits"], "manual");
    EXPECT_EQ(s["addr_broken"], false);
    for (const char* line :
         {"set 1 travel_min -100", "set 1 travel_max 200", "set 1 limits auto", "set 1 home_switch_at 50"})
        say(line);
    s = say("state 1");
    EXPECT_EQ(s["travel_min"], -100);
    EXPECT_EQ(s["travel_max"], 200);
    EXPECT_EQ(s["limits"], "auto");
    EXPECT_EQ(s["home_switch_at"], 50);
}

TEST_F(Control, AnErrorNamesWhatIsAllowedAndChangesNothing) {
    const auto before = say("state 1");
    EXPECT_THAT(errorOf("set 1 limit1 2"), HasSubstr("0 or 1"));
    EXPECT_THAT(errorOf("set 1 limit1 0.5"), HasSubstr("0 or 1"));
    EXPECT_THAT(errorOf("set 1 limit1 high"), HasSubstr("0 or 1"));
    EXPECT_THAT(errorOf("set 1 analog 256"), HasSubstr("0 to 255 or auto"));
    EXPECT_THAT(errorOf("set 1 inertia 0"), HasSubstr("kg·m²"));
    EXPECT_THAT(errorOf("set 1 inertia nan"), HasSubstr("kg·m²"));
    EXPECT_THAT(errorOf("set 1 friction -1"), HasSubstr("N·m"));
    EXPECT_THAT(errorOf("set 1 load inf"), HasSubstr("N·m"));
    EXPECT_THAT(errorOf("set 1 limits on"), HasSubstr("auto or manual"));
    EXPECT_THAT(errorOf("set 1 estop 1"), HasSubstr("travel_max"));
    EXPECT_THAT(errorOf("set 1 power"), HasSubstr("set N NAME VALUE"));
    EXPECT_THAT(errorOf("set 3 power 1"), HasSubstr("1 to 2"));
    EXPECT_THAT(errorOf("state 0"), HasSubstr("1 to 2"));
    EXPECT_THAT(errorOf("state one"), HasSubstr("1 to 2"));
    EXPECT_THAT(errorOf("state"), HasSubstr("state N"));
    EXPECT_THAT(errorOf("power-cycle 9"), HasSubstr("all"));
    EXPECT_THAT(errorOf("break 0"), HasSubstr("1 to 2"));
    EXPECT_THAT(errorOf("stats 1"), HasSubstr("stats"));
    for (const char* line : {"", "  ", "hello", "quit", "\xff\xfe"})
        EXPECT_THAT(errorOf(line), HasSubstr("state N, set N NAME VALUE, power-cycle N|all, break N, mend N, "
                                             "fault ..., fault clear, faults, foreign BYTES, stats, stats "
                                             "clear, time, help"));
    EXPECT_EQ(say("state 1"), before);
}

TEST_F(Control, AHardStopCannotBePutBeyondTheShaftNorALimitSetThatFollowsIt) {
    EXPECT_THAT(errorOf("set 1 travel_min 5"), HasSubstr("allowed is up to that"));
    EXPECT_THAT(errorOf("set 1 travel_max -5"), HasSubstr("allowed is from that on"));
    say("set 1 limits auto");
    EXPECT_THAT(errorOf("set 1 limit1 1"), HasSubstr("limits manual"));
    say("set 1 travel_min 0");
    EXPECT_EQ(say("state 1")["limit1"], true);
    say("set 1 travel_min none");
    EXPECT_EQ(say("state 1")["limit1"], false);
    say("set 1 limits manual");
    say("set 1 load_play 40");
    say("set 1 home_switch_at 0");
    EXPECT_THAT(errorOf("set 1 limit1 0"), HasSubstr("home_switch_at none first"));
    EXPECT_EQ(say("state 1")["limit1"], true);
    EXPECT_EQ(say("state 1")["home_switch_at"], 0);
    EXPECT_EQ(say("state 1")["load_play"], 40);
    say("set 1 limit2 1");
    EXPECT_EQ(say("state 1")["limit2"], true);
}

TEST_F(Control, AServoOverrunSetsItsStickyBitUntilTheHostClearsIt) {
    EXPECT_EQ(wire.report().auxiliary & 0x20U, 0U);
    EXPECT_THAT(errorOf("set 1 servo_overrun 0"), HasSubstr("allowed is 1"));
    EXPECT_EQ(say("set 1 servo_overrun 1"), (nlohmann::json{{"ok", true}}));
    EXPECT_EQ(wire.report().auxiliary & 0x20U, 0x20U);
    wire.waitTicks(100);
    EXPECT_EQ(wire.report().auxiliary & 0x20U, 0x20U) << "sticky";
    EXPECT_EQ(wire.report(2).auxiliary & 0x20U, 0U);
    wire.command(1, 0x0B);
    EXPECT_EQ(wire.report().auxiliary & 0x20U, 0U);
}

TEST_F(Control, AStepperHasItsOwnStateAndInputs) {
    wire = HostWire("servo,step");
    wire.address(2);
    for (const char* line : {"set 2 estop 1", "set 2 in1 1", "set 2 in2 1", "set 2 home_switch 1",
                             "set 2 limit1 1", "set 2 limit2 1", "set 2 power 0", "set 2 analog 77"})
        EXPECT_EQ(say(line), (nlohmann::json{{"ok", true}})) << line;
    const auto s = say("state 2");
    EXPECT_EQ(s["type"], "step");
    EXPECT_EQ(s["version"], 1);
    EXPECT_EQ(s["address"], 2);
    EXPECT_EQ(s["mode"], "stopped");
    EXPECT_EQ(s["moving"], false);
    EXPECT_EQ(s["step_rate"], 0.0);
    EXPECT_EQ(s["position"], 0);
    EXPECT_EQ(s["shaft"], 0);
    EXPECT_EQ(s["outputs"], 0x10);
    EXPECT_EQ(s["current_limit"], 0);
    EXPECT_EQ(s["power"], false);
    EXPECT_EQ(s["analog"], 77);
    for (const char* pin : {"estop", "in1", "in2", "home_switch", "limit1", "limit2"})
        EXPECT_EQ(s["inputs"][pin], true) << pin;
    for (const char* key : {"gains", "pwm", "servo_on", "position_error"})
        EXPECT_FALSE(s.contains(key)) << key;
}

TEST_F(Control, ANameOfTheOtherKindOfModuleIsAnErrorThatNamesWhatIsAllowed) {
    wire = HostWire("servo,step");
    for (const char* line : {"set 2 load 1", "set 2 friction 0", "set 2 index 1", "set 2 servo_overrun 1"})
        EXPECT_THAT(errorOf(line), HasSubstr("allowed are limit1, limit2, power, analog, travel_min, "
                                             "travel_max, limits, estop, in1, in2, home_switch, "
                                             "home_switch_at"));
    EXPECT_THAT(errorOf("set 2 analog auto"), HasSubstr("0 to 255"));
    for (const char* line : {"set 1 estop 1", "set 1 in1 1", "set 1 home_switch 1"})
        EXPECT_THAT(errorOf(line), HasSubstr("allowed are limit1, limit2, index, power, analog, load, "
                                             "inertia, friction, play, counts_per_turn, deadband, gain, "
                                             "encoder_noise, elastic_inertia, resonance, travel_min, "
                                             "travel_max, limits, servo_overrun, home_switch_at, load_play"));
}

TEST_F(Control, PinsAndAdInputsOfAPicIoHaveNumbers) {
    wire.chain = Chain(parseChain("io,servo@10").value());
    EXPECT_EQ(say("set 1 in 12 1"), nlohmann::json({{"ok", true}}));
    EXPECT_EQ(say("set 1 analog 3 200"), nlohmann::json({{"ok", true}}));
    const auto s = say("state 1");
    EXPECT_EQ(s["type"], "io");
    EXPECT_EQ(s["pins"][11], true);
    EXPECT_EQ(s["pins"][0], false);
    EXPECT_EQ(s["analog"], nlohmann::json({0, 0, 200}));
    EXPECT_FALSE(s.contains("position"));

    EXPECT_THAT(errorOf("set 1 in 13 1"), HasSubstr("allowed is 1 to 12"));
    EXPECT_THAT(errorOf("set 1 in 0 1"), HasSubstr("allowed is 1 to 12"));
    EXPECT_THAT(errorOf("set 1 in x 1"), HasSubstr("allowed is 1 to 12"));
    EXPECT_THAT(errorOf("set 1 analog 4 1"), HasSubstr("allowed is 1 to 3"));
    EXPECT_THAT(errorOf("set 1 in 1 2"), HasSubstr("0 or 1"));
    EXPECT_THAT(errorOf("set 1 in 1"), HasSubstr("set N in K VALUE"));
    EXPECT_THAT(errorOf("set 1 limit1 1"), HasSubstr("allowed are in, analog"));
    EXPECT_THAT(errorOf("set 2 limit1 1 1"), HasSubstr("set N NAME VALUE"));
    EXPECT_THAT(errorOf("set 1 in 1 1 1"), HasSubstr("wrong number of words"));
}

TEST_F(Control, AnScHasItsOwnInputsAndState) {
    wire.chain = Chain(parseChain("servo@10,servo@4").value());
    EXPECT_EQ(say("set 1 vsense 4.75"), nlohmann::json({{"ok", true}}));
    const auto s = say("state 1");
    EXPECT_EQ(s["version"], 10);
    EXPECT_EQ(s["vsense"], 4.75);
    EXPECT_EQ(s["power"], false);
    EXPECT_EQ(s["saved"], nullptr);
    EXPECT_EQ(s["limit_stop"], "none");
    EXPECT_THAT(errorOf("set 1 vsense 5.1"), HasSubstr("0 to 5 V"));
    EXPECT_THAT(errorOf("set 1 steps 40000"), HasSubstr("32767"));
    EXPECT_THAT(errorOf("set 2 steps 1"), HasSubstr("no input"));
    EXPECT_FALSE(say("state 2").contains("path_points"));
}

TEST_F(Control, PowerCycleBreakAndMendReachTheAddressLine) {
    EXPECT_EQ(say("power-cycle all"), (nlohmann::json{{"ok", true}}));
    wire.wait(milliseconds(10));
    EXPECT_EQ(say("state 1")["address"], 0);
    say("break 1");
    wire.address(1);
    EXPECT_TRUE(wire.command(0, 0x0E).empty());
    say("mend 1");
    EXPECT_EQ(wire.command(0, 0x21, {2, 0xFF}).size(), 2U);
    say("power-cycle 2");
    EXPECT_EQ(say("state 2")["address"], 0);
    EXPECT_EQ(say("state 1")["address"], 1);
}

TEST_F(Control, StatsCountWhatHappened) {
    wire.command(1, 0x0E);
    wire.command(1, 0x0E);
    Bytes wrong = packet(2, 0x0E);
    wrong.back() ^= 1;
    wire.exchange(wrong);
    wire.command(2, 0x0D);
    const auto s = say("stats");
    // Two addresses, two nops, the wrong one and the unknown one were answered with two bytes each.
    EXPECT_EQ(s["exchanges"], 6);
    EXPECT_EQ(s["bytes_out"], 12);
    EXPECT_EQ(s["bytes_in"], 2 * 6 + 4 * 4);
    EXPECT_EQ(s["modules"][0]["module"], 1);
    EXPECT_EQ(s["modules"][0]["executed"], (nlohmann::json{{"set_address", 1}, {"nop", 2}}));
    EXPECT_EQ(s["modules"][0]["replies"], 3);
    EXPECT_EQ(s["modules"][0]["replies_dropped"], 0);
    EXPECT_EQ(s["modules"][0]["bytes_garbled"], 0);
    EXPECT_EQ(s["modules"][1]["checksum_errors"], 1);
    ASSERT_EQ(s["violations"].size(), 1U);
    EXPECT_EQ(s["violations"][0]["module"], 2);
    EXPECT_EQ(s["violations"][0]["kind"], "unknown_command");
    EXPECT_EQ(s["violations"][0]["bytes"], "AA 02 0D 0F");
    EXPECT_GT(s["violations"][0]["time"], 0.01);
}

TEST_F(Control, StatsAreClearedOnRequest) {
    wire.command(1, 0x0E);
    wire.command(2, 0x0D);
    EXPECT_THAT(errorOf("stats all"), HasSubstr("stats clear"));
    EXPECT_EQ(say("stats clear"), (nlohmann::json{{"ok", true}}));
    auto s = say("stats");
    for (const char* key :
         {"exchanges", "bytes_in", "bytes_out", "bytes_unheard", "bytes_lost", "violation_count"})
        EXPECT_EQ(s[key], 0) << key;
    EXPECT_TRUE(s["violations"].empty());
    EXPECT_TRUE(s["modules"][0]["executed"].empty());
    EXPECT_EQ(s["modules"][0]["replies"], 0);
    wire.command(1, 0x0E);
    s = say("stats");
    EXPECT_EQ(s["exchanges"], 1);
    EXPECT_EQ(s["modules"][0]["executed"], (nlohmann::json{{"nop", 1}}));
    EXPECT_EQ(say("state 1")["address"], 1) << "only the counts are cleared, not the chain";
}

TEST_F(Control, HelpListsEveryKindOfViolation) {
    std::vector<std::string> kinds;
    const auto help = say("help");
    for (const auto& row : help["violations"]) {
        kinds.push_back(row["kind"]);
        EXPECT_FALSE(row["meaning"].get<std::string>().empty()) << kinds.back();
        EXPECT_THAT(controlHelp(), HasSubstr("  " + kinds.back() + " "));
    }
    EXPECT_THAT(kinds,
                testing::ElementsAre("command_in_flight", "command_overwritten", "trapezoid_in_motion",
                                     "reset_in_motion", "reply_collision", "wrong_length", "unknown_command",
                                     "stop_bits", "out_of_range", "reserved_bits", "set_baud_single",
                                     "unsupported", "mode_transition", "direction_change", "path_overflow",
                                     "parameters_not_set", "velocity_not_loaded"));
}

/// The row of `help` for one `set` name and one kind of module.
nlohmann::json inputOf(const nlohmann::json& help, std::string_view module, std::string_view name) {
    for (const auto& row : help["set"])
        if (row["name"] == name && (row["module"] == module || row["module"] == "any"))
            return row;
    return {};
}

TEST_F(Control, HelpListsEveryNameOfSetWithItsRangeAndPolarity) {
    wire = HostWire("servo,step");
    const auto help = say("help");
    for (const auto& [number, module] : {std::pair{"1", "servo"}, std::pair{"2", "step"}}) {
        // The names that the error of an unknown one lists.
        std::string names = errorOf(std::string("set ") + number + " nothing 0");
        names = names.substr(names.find("allowed are ") + 12) + ", ";
        for (std::size_t end = 0; (end = names.find(", ")) != std::string::npos; names.erase(0, end + 2)) {
            const auto row = inputOf(help, module, names.substr(0, end));
            ASSERT_FALSE(row.is_null()) << module << " " << names;
            EXPECT_FALSE(row["meaning"].get<std::string>().empty()) << row;
            EXPECT_THAT(errorOf(std::string("set ") + number + " " + names.substr(0, end) + " x"),
                        HasSubstr("allowed is " + row["allowed"].get<std::string>()));
        }
    }
    EXPECT_EQ(inputOf(help, "step", "limit1")["meaning"],
              "forward limit switch, 1 is high: no motion forward");
    EXPECT_EQ(inputOf(help, "servo", "power")["allowed"], "0 or 1");
    EXPECT_THAT(controlHelp(), HasSubstr("no motion in reverse"));
    EXPECT_EQ(help["lines"][0]["line"], "state N");
}

TEST_F(Control, LimitsThatFollowTheTravelAreWhereHelpSaysThatTheyAre) {
    for (const auto& [chip, atTravelMin] :
         {std::pair{"servo@4", "limit1"}, std::pair{"servo@10", "limit2"}}) {
        wire = HostWire(chip);
        for (const char* line : {"set 1 travel_min 0", "set 1 travel_max 1000", "set 1 limits auto"})
            EXPECT_EQ(errorOf(line), "");
        const auto truth = say("state 1");
        for (const char* name : {"limit1", "limit2"})
            EXPECT_EQ(truth[name], name == std::string(atTravelMin)) << chip << " " << name;
    }
    EXPECT_EQ(inputOf(say("help"), "servo", "limits")["meaning"],
              "auto: limit1 is 1 at travel_min and limit2 at travel_max, of an SC the other way round");
}

TEST_F(Control, StatsListRemarksBesideViolations) {
    wire.command(1, 0x17, {0x06});
    const auto stats = say("stats");
    EXPECT_EQ(stats["violation_count"], 0);
    ASSERT_EQ(stats["remarks"].size(), 1U);
    EXPECT_EQ(stats["remarks"][0]["kind"], "stop_bits");
    EXPECT_EQ(stats["remarks"][0]["bytes"], "AA 01 17 06 1E");
}

TEST_F(Control, BytesThatNoModuleListensToAreCounted) {
    EXPECT_EQ(say("stats")["bytes_unheard"], 0);
    say("power-cycle 2");
    wire.command(1, 0x0E);
    EXPECT_EQ(say("stats")["bytes_unheard"], 0) << "module 1 listens";
    say("power-cycle all");
    wire.exchange(Bytes(7, 0));  // 3.6 ms of the 8 in which a module is deaf
    EXPECT_EQ(say("stats")["bytes_unheard"], 7);
}

TEST_F(Control, AnotherHostsBytesAreHexadecimalAndNeedFaultsEnabled) {
    EXPECT_THAT(errorOf("foreign"), HasSubstr("no bytes"));
    for (const char* wrong : {"foreign AG", "foreign A", "foreign AA02", "foreign 0x1"})
        EXPECT_THAT(errorOf(wrong), HasSubstr("no byte ")) << wrong;
    EXPECT_THAT(errorOf("foreign AA 02 0E 10"), HasSubstr("--enable-faults"));
}

TEST_F(Control, TimeHasTheTicksAndTheCallersPace) {
    wire.wait(milliseconds(5120) - wire.now.time_since_epoch());
    const auto t = say("time", Pace{0.25, 0.0001, 7, 9, 2, 0.05});
    EXPECT_EQ(t, (nlohmann::json{{"time", 5.12},
                                 {"ticks", 10000},
                                 {"lag", 0.25},
                                 {"late_p99", 0.0001},
                                 {"received", 7},
                                 {"sent", 9},
                                 {"stalls", 2},
                                 {"longest_stall", 0.05}}));
    const auto s = say("stats", Pace{0.25, 0.0001, 7, 9, 2, 0.05});
    EXPECT_EQ(s["stalls"], 2);
    EXPECT_EQ(s["longest_stall"], 0.05);
}

TEST_F(Control, WhereNothingPacesTheChainNothingIsSaidOfIt) {
    wire.wait(milliseconds(5120) - wire.now.time_since_epoch());
    EXPECT_EQ(say("time"), (nlohmann::json{{"time", 5.12}, {"ticks", 10000}}));
    const auto s = say("stats");
    EXPECT_FALSE(s.contains("stalls"));
    EXPECT_FALSE(s.contains("longest_stall"));
}

}  // namespace
}  // namespace nmc::sim::test
