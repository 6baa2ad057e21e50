// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/api/apimethods.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "base/enumname.h"
#include "model/api/apirecording.h"
#include "model/api/apistate.h"
#include "recordings.h"

namespace nmc {
namespace {

using api::Json;
using Kind = api::Problem::Kind;

/// A chain of a PIC-SERVO with servo rate 1 and a PIC-STEP, of which nothing is known but that they are
/// there.
struct Chain {
    LinkState link{};
    Machine machine;

    Chain() {
        link.phase = LinkPhase::Connected;
        link.modules.resize(2);
        link.modules[0].info = {ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}};
        link.modules[0].servoRate = 1;
        link.modules[1].info = {ModuleIndex(1), BusAddress(2), {ModuleType::Stepper, 1}};
        machine.axes.resize(2);
        machine.axes[0].name = "X";
    }
    [[nodiscard]] auto call(const char* method, const Json& parameters) const {
        return api::callOf(*api::findMethod(method), parameters, link, machine);
    }
    template <typename T>
    [[nodiscard]] T intentOf(const char* method, const Json& parameters) const {
        return std::get<T>(std::get<Intent>(call(method, parameters).value().what));
    }
    [[nodiscard]] servomotion::Trapezoid moveOf(const Json& parameters) const {
        const auto move = intentOf<intent::Move>("move", parameters);
        return std::get<servomotion::Trapezoid>(std::get<ServoMotion>(move.motion));
    }
};

TEST(ApiMethods, AreDescribedWithTheirParameters) {
    const Json list = api::describe()["methods"];
    ASSERT_EQ(list.size(), api::methods().size());
    const auto find = [](const Json& all, const char* name) {
        for (const Json& one : all)
            if (one["name"] == name)
                return one;
        return Json();
    };
    const Json move = find(list, "move");
    EXPECT_EQ(move["needs"], "control");
    EXPECT_EQ(find(move["parameters"], "to")["kind"], "position");
    EXPECT_EQ(find(move["parameters"], "to")["required"], true);
    EXPECT_EQ(find(list, "stop")["needs"], "stop");
    // Ranges of Set Gain: DS-V 5.1.
    const Json gains = find(list, "set_gains")["parameters"];
    EXPECT_EQ(find(gains, "kp")["max"], 32'767);
    EXPECT_EQ(find(gains, "ol")["max"], 255);
    EXPECT_EQ(find(gains, "sr")["min"], 1);
    EXPECT_EQ(find(gains, "db")["max"], 255);
}

TEST(ApiMethods, AreOnTheirPage) {
    std::ifstream file(API_PAGE);
    const std::string page(std::istreambuf_iterator<char>(file), {});
    const Json all = api::describe();
    for (const Json& method : all["methods"]) {
        std::string fields;
        for (const Json& field : method["parameters"])
            fields += (fields.empty() ? "`" : ", `") + field["name"].get<std::string>() + '`';
        const std::string row = "| `" + method["name"].get<std::string>() + "` | " +
                                method["needs"].get<std::string>() + " | " + fields +
                                (fields.empty() ? "| " : " | ") + method["text"].get<std::string>() + " |\n";
        EXPECT_NE(page.find(row), std::string::npos) << row;
    }
}

/// The problem of a line with these parameters.
std::optional<api::Problem> problemOf(const char* method, const Json& parameters) {
    const auto request = api::readRequest(Json{{"id", 1}, {"method", method}, {"params", parameters}}.dump());
    return request ? std::nullopt : std::optional(request.error().problem);
}

TEST(ApiMethods, TakeParametersOfTheirTypesOnly) {
    EXPECT_EQ(problemOf("move", {{"axis", 1}, {"to", 5}}), std::nullopt);
    EXPECT_EQ(problemOf("move", {{"axis", 1}}), (api::Problem{Kind::FieldMissing, "to"}));
    EXPECT_EQ(problemOf("move", {{"axis", 1.5}, {"to", 5}}), (api::Problem{Kind::FieldWrong, "axis"}));
    EXPECT_EQ(problemOf("move", {{"axis", 1}, {"to", true}}), (api::Problem{Kind::FieldWrong, "to"}));
    EXPECT_EQ(problemOf("move", {{"axis", 1}, {"to", Json::array({5})}}),
              (api::Problem{Kind::FieldWrong, "to"}));
    EXPECT_EQ(problemOf("move", {{"axis", 1}, {"to", 1e300}}), (api::Problem{Kind::FieldWrong, "to"}));
    EXPECT_EQ(problemOf("set_gains", {{"axis", 1}, {"kp", 32'768}}),
              (api::Problem{Kind::FieldWrong, "kp", {}, api::NumberRange{0, 32'767}}))
        << "DS-V 5.1";
    EXPECT_EQ(problemOf("set_gains", {{"axis", 1}, {"sr", 0}}),
              (api::Problem{Kind::FieldWrong, "sr", {}, api::NumberRange{1, 255}}));
    EXPECT_EQ(problemOf("set_gains", {{"axis", 1}, {"kp", 5.5}}), (api::Problem{Kind::FieldWrong, "kp"}))
        << "it is in the range";
    EXPECT_EQ(problemOf("dance", Json::object()), (api::Problem{Kind::NoMethod}));
}

TEST(ApiMethods, LeaveOutParametersThatAreNotKnown) {
    const auto request = api::readRequest(R"({"method": "stop", "params": {"axis": 1, "later": [[[[1]]]]}})");
    ASSERT_TRUE(request);
    EXPECT_EQ(request->parameters, (Json{{"axis", 1}}));
    EXPECT_TRUE(request->id.is_null());
    EXPECT_EQ(request->method, api::findMethod("stop"));
}

TEST(ApiMethods, AreNotWhatIsNoRequest) {
    const auto kindOf = [](const char* line) { return api::readRequest(line).error().problem.kind; };
    EXPECT_EQ(kindOf(""), Kind::NotJson);
    EXPECT_EQ(kindOf("{\"method\": \"stop\"} {"), Kind::NotJson);
    for (const char* line : {"5", "[]", "{}", R"({"method": 5})", R"({"method": "stop", "params": [1]})",
                             R"({"method": "stop", "id": [1]})", R"({"method": "stop", "id": true})"})
        EXPECT_EQ(kindOf(line), Kind::InvalidRequest) << line;
    for (const char* line : {R"({"method": "dance", "id": "a"})", R"({"method": 5, "id": "a"})",
                             R"({"method": "stop", "params": [1], "id": "a"})"})
        EXPECT_EQ(api::readRequest(line).error().id, "a") << line;
}

TEST(ApiMethods, FindAnAxisByNameOrNumber) {
    const Chain chain;
    EXPECT_EQ(api::axisOf({{"axis", "X"}}, chain.link, chain.machine).value(), ModuleIndex(0));
    EXPECT_EQ(api::axisOf({{"axis", 2}}, chain.link, chain.machine).value(), ModuleIndex(1));
    for (const Json& axis :
         {Json("Y"), Json(0), Json(3), Json(-1), Json(""), Json(18'446'744'073'709'551'615U)})
        EXPECT_EQ(api::axisOf({{"axis", axis}}, chain.link, chain.machine).error().kind, Kind::AxisUnknown)
            << axis;
}

TEST(ApiMethods, SayThatThereIsNoChainRatherThanNoAxis) {
    EXPECT_EQ(api::axisOf({{"axis", 1}}, LinkState{}, Machine{}).error().refusal, Refusal::NotConnected);
}

TEST(ApiMethods, MoveNeitherOfTwoAxesWithOneName) {
    Chain chain;
    chain.machine.axes[1].name = "X";
    EXPECT_EQ(chain.call("enable", {{"axis", "X"}}).error().kind, Kind::AxisAmbiguous);
    EXPECT_EQ(chain.call("enable", {{"axis", 2}}).value().module, ModuleIndex(1));
}

/// 400 counts per mm, forward being the chip's reverse. A tick is 0.512 ms: 10 mm/s are 4 000 counts/s, 2.048
/// counts per tick; 100 mm/s² are 40 000 counts/s², 40 000 x 0.000512² = 0.01048576 counts per tick squared.
TEST(ApiMethods, SpeakTheUnitsOfTheAxis) {
    Chain chain;
    chain.machine.axes[0].unit = {UnitKind::Millimetres, -400};
    chain.machine.axes[0].motion.holdCap = 3;
    const auto move = chain.moveOf({{"axis", "X"}, {"to", 12.5}, {"velocity", 10}, {"acceleration", 100}});
    EXPECT_EQ(move.position, Counts(-5'000));
    EXPECT_EQ(move.velocity, CountsPerTick(134'218));         // 2.048 x 65 536 = 134 217.7
    EXPECT_EQ(move.acceleration, CountsPerTickSquared(687));  // 0.01048576 x 65 536 = 687.2
    const auto by = chain.intentOf<intent::MoveBy>("move_by", {{"axis", 1}, {"by", 1}});
    EXPECT_EQ(by.moves.counts, -400);
    EXPECT_EQ(by.moves.rounds, 1U);
    const auto forward =
        std::get<bus::HoldToMove>(chain.call("jog", {{"axis", 1}, {"velocity", 10}}).value().what);
    EXPECT_TRUE(forward.reverse) << "the chip's direction";
    EXPECT_EQ(forward.velocity, CountsPerTick(134'218));
    EXPECT_FALSE(
        std::get<bus::HoldToMove>(chain.call("jog", {{"axis", 1}, {"velocity", -10}}).value().what).reverse);
}

TEST(ApiMethods, UseTheVelocityOfTheAxisIfNoneIsGiven) {
    Chain chain;
    chain.machine.axes[0].motion.velocity = 3;
    chain.machine.axes[0].motion.acceleration = 0.5;
    const auto move = chain.moveOf({{"axis", 1}, {"to", 100}});
    EXPECT_EQ(move.velocity, CountsPerTick(3 * 65'536));
    EXPECT_EQ(move.acceleration, CountsPerTickSquared(32'768));
    EXPECT_EQ(chain.moveOf({{"axis", 1}, {"to", 100}, {"velocity", 2}}).velocity, CountsPerTick(2 * 65'536));
}

/// 2 counts per tick and 1 000 steps/s until the user has set another limit.
TEST(ApiMethods, JogNoFasterThanTheButtonsOfTheWindow) {
    Chain chain;
    const auto isRefused = [&](int axis, double velocity) {
        const auto call = chain.call("jog", {{"axis", axis}, {"velocity", velocity}});
        return !call && call.error().kind == Kind::FieldWrong && call.error().field == "velocity";
    };
    EXPECT_FALSE(isRefused(1, -2));
    EXPECT_TRUE(isRefused(1, -2.01));
    EXPECT_FALSE(isRefused(2, 1'000));
    EXPECT_TRUE(isRefused(2, 1'001));
    chain.machine.axes[0].motion.holdCap = 0.5;
    EXPECT_FALSE(isRefused(1, 0.5));
    EXPECT_TRUE(isRefused(1, 0.51));
    // 400 counts per mm: 1.25 mm/s are 500 counts/s, 0.256 counts per tick of 0.512 ms.
    chain.machine.axes[0].unit = {UnitKind::Millimetres, 400};
    chain.machine.axes[0].motion.holdCap = 0.256;
    EXPECT_FALSE(isRefused(1, 1.24));
    EXPECT_TRUE(isRefused(1, 1.26));
}

/// 16.16 fixed point, and 1 to 250 times 25 steps/s times the speed multiplier (DS-S 4.3).
TEST(ApiMethods, MoveAtNoVelocityThatTheChipDoesNotHave) {
    Chain chain;
    const auto isRefused = [&](const char* method, int axis, double velocity) {
        const auto call = chain.call(method, {{"axis", axis}, {"to", 1}, {"velocity", velocity}});
        return !call && call.error().kind == Kind::FieldWrong && call.error().field == "velocity";
    };
    EXPECT_FALSE(isRefused("move", 1, 1.0 / 65'536));
    EXPECT_TRUE(isRefused("move", 1, 0.7 / 65'536));
    chain.link.modules[1].stepper.parameters = stepper::SetParameters{.speedMode = stepper::SpeedMode::X2};
    EXPECT_FALSE(isRefused("move", 2, 50));
    EXPECT_TRUE(isRefused("move", 2, 49));
    EXPECT_FALSE(isRefused("move", 2, 12'500));
    EXPECT_TRUE(isRefused("move", 2, 12'501));
    // Below the lowest speed of a profile, it would be at that speed (DS-S 5.1): 4 times 50 steps/s.
    chain.link.modules[1].stepper.parameters->minimumProfileSpeed = 4;
    EXPECT_FALSE(isRefused("jog", 2, -200));
    EXPECT_TRUE(isRefused("jog", 2, -199));
    EXPECT_FALSE(isRefused("move", 2, 200));
    EXPECT_TRUE(isRefused("move", 2, 199));
    // 200 steps are 3 degrees: 3 degrees/s are as slow as that, however they are rounded.
    chain.machine.axes[1].unit = {UnitKind::Degrees, 200.0 / 3.0};
    EXPECT_FALSE(isRefused("jog", 2, 3));
    EXPECT_TRUE(isRefused("jog", 2, 2.9));
}

/// In 8x, a unit of speed is 200 steps/s (DS-S 4.3).
TEST(ApiMethods, MoveAStepperNoFasterThanItWasAsked) {
    Chain chain;
    chain.link.modules[1].stepper.parameters = stepper::SetParameters{.speedMode = stepper::SpeedMode::X8};
    const auto speedOf = [&](double velocity) {
        const auto move =
            chain.intentOf<intent::Move>("move", {{"axis", 2}, {"to", 1}, {"velocity", velocity}});
        return std::get<steppermotion::Trapezoid>(std::get<StepperMotion>(move.motion)).speed;
    };
    EXPECT_EQ(speedOf(310), 1);
    EXPECT_EQ(speedOf(399), 1);
    EXPECT_EQ(speedOf(400), 2);
    EXPECT_EQ(speedOf(50'000), 250);
}

/// In the units of the axis. 2 counts per tick until the user has set another limit, 32 767 at most; in 2x, 1
/// to 250 times 50 steps/s (DS-S 4.3). 400 counts per mm, and 1 000 000 / 512 = 1 953.125 ticks/s: 2 counts
/// per tick are 3 906.25 counts/s, 9.765625 mm/s; 1 / 65 536 of one are 0.000074505805969238 mm/s.
TEST(ApiMethods, NameTheRangeOfANumber) {
    Chain chain;
    const auto rangeOf = [&](const char* method, const Json& parameters) {
        const auto call = chain.call(method, parameters);
        return call ? std::nullopt : call.error().range;
    };
    EXPECT_EQ(rangeOf("jog", {{"axis", 1}, {"velocity", 9}}),
              (api::NumberRange{1.0 / 65'536, 2, "counts/tick", true}));
    const Json backwards{{"axis", 1}, {"to", 1}, {"velocity", -1}};
    EXPECT_EQ(rangeOf("move", backwards), (api::NumberRange{1.0 / 65'536, 32'767, "counts/tick"}));
    const Json abrupt{{"axis", 1}, {"to", 1}, {"acceleration", 40'000}};
    EXPECT_EQ(rangeOf("move", abrupt), (api::NumberRange{1.0 / 65'536, 32'767, "counts/tick2"}));
    chain.link.modules[1].stepper.parameters = stepper::SetParameters{.speedMode = stepper::SpeedMode::X2};
    const Json slow{{"axis", 2}, {"to", 1}, {"velocity", 1}};
    EXPECT_EQ(rangeOf("move", slow), (api::NumberRange{50, 12'500, "steps/s"}));
    chain.machine.axes[0].unit = {UnitKind::Millimetres, 400};
    const auto jogged = rangeOf("jog", {{"axis", 1}, {"velocity", 10}});
    ASSERT_TRUE(jogged);
    EXPECT_NEAR(jogged->max, 9.765625, 1e-9);
    EXPECT_NEAR(jogged->min, 7.4505805969238e-5, 1e-15);
    EXPECT_EQ(jogged->unit, "mm/s");
}

TEST(ApiMethods, RefuseWhatCannotBeMeant) {
    Chain chain;
    const auto kindOf = [&](const char* method, const Json& parameters) {
        return chain.call(method, parameters).error();
    };
    EXPECT_EQ(kindOf("move", {{"axis", 1}, {"to", 3e9}}).refusal, Refusal::GoalOutOfRange);
    EXPECT_EQ(kindOf("move", {{"axis", 1}, {"to", 1}, {"velocity", -1}}).kind, Kind::FieldWrong);
    EXPECT_EQ(kindOf("move", {{"axis", 1}, {"to", 1}, {"velocity", 40'000}}).kind, Kind::FieldWrong);
    EXPECT_EQ(kindOf("move", {{"axis", 1}, {"to", 1}, {"acceleration", 0}}).kind, Kind::FieldWrong);
    EXPECT_EQ(kindOf("jog", {{"axis", 1}, {"velocity", 0}}).kind, Kind::FieldWrong);
    EXPECT_EQ(kindOf("jog", {{"axis", 2}, {"velocity", 100}}).refusal, Refusal::ParametersUnknown);
    EXPECT_EQ(kindOf("home", {{"axis", 1}}).refusal, Refusal::NothingToFind);
    EXPECT_EQ(kindOf("set_gains", {{"axis", 1}, {"kp", 1}}).kind, Kind::FieldMissing) << "no gains are known";
    chain.machine.axes[0].unit = {UnitKind::Millimetres, 400};
    chain.link.modules[0].servoRate.reset();
    EXPECT_EQ(kindOf("move", {{"axis", 1}, {"to", 1}, {"velocity", 1}}).refusal, Refusal::ServoRateUnknown);
}

TEST(ApiMethods, SetOnlyWhatIsAnOutput) {
    Chain chain;
    chain.link.modules.emplace_back().info = {ModuleIndex(2), BusAddress(3), {ModuleType::Io, 1}};
    ModuleState& io = chain.link.modules[2];
    chain.machine.axes.resize(3);
    const auto set = [&](int axis, int output) {
        return chain.call("set_output", {{"axis", axis}, {"output", output}, {"high", true}});
    };
    EXPECT_EQ(set(3, 2).error().kind, Kind::NotAnOutput) << "after power-up, all pins are inputs";
    const Json direction{{"axis", 3}, {"input", false}, {"pin", 2}};
    EXPECT_EQ(chain.intentOf<iointent::SetDirection>("set_direction", direction).inputs, 0xFFD);
    io.pins.inputs = std::uint16_t{0xFFD};
    EXPECT_EQ(
        chain.intentOf<iointent::SetOutput>("set_output", {{"axis", 3}, {"output", 2}, {"high", true}}).pin,
        1U);
    EXPECT_EQ(
        chain.intentOf<iointent::SetDirection>("set_direction", {{"axis", 3}, {"input", true}, {"pin", 2}})
            .inputs,
        0xFFF);
    io.pins.inputs.reset();
    EXPECT_EQ(set(3, 2).error().kind, Kind::OutputsUnknown);
    EXPECT_EQ(chain.call("set_direction", direction).error().kind, Kind::OutputsUnknown);
    EXPECT_EQ(chain.call("set_direction", {{"axis", 3}, {"input", false}}).error().kind, Kind::FieldMissing)
        << "all pins at once only become inputs";
    EXPECT_EQ(chain.intentOf<iointent::SetDirection>("set_direction", {{"axis", 3}, {"input", true}}).inputs,
              0xFFF);
    EXPECT_EQ(chain.call("set_direction", {{"axis", 1}, {"input", true}}).error().refusal,
              Refusal::NotAnIoModule);
    const Json pwm{{"axis", 3}, {"output", 2}, {"value", 255}};
    EXPECT_EQ(chain.intentOf<iointent::SetPwm>("set_pwm", pwm).output, 1U);
    io.pins.pwm.reset();
    EXPECT_EQ(chain.call("set_pwm", pwm).error().kind, Kind::OutputsUnknown)
        << "one command sets both, so the other one would be switched off";
    Json both = pwm;
    both["other"] = 9;
    const auto setBoth = chain.intentOf<iointent::SetPwm>("set_pwm", both);
    EXPECT_EQ(setBoth.value, 255);
    EXPECT_EQ(setBoth.other, std::uint8_t{9});
    EXPECT_EQ(set(1, 1).error().kind, Kind::NotAnOutput) << "limit 1 is an input";
    EXPECT_EQ(set(2, 6).error().kind, Kind::FieldWrong);
    // OUT5 is high after power-up, the rest low (DS-S 2.3).
    EXPECT_EQ(
        chain.intentOf<stepperintent::SetOutputs>("set_output", {{"axis", 2}, {"output", 1}, {"high", true}})
            .outputs,
        0x11);
}

TEST(ApiMethods, ChangeOnlyTheGainsThatAreGiven) {
    Chain chain;
    chain.link.modules[0].gains = servo::SetGain{100, 1'000, 10, 50, 255, 0, 2'000, 1, std::uint8_t{0}};
    const servo::SetGain gains =
        chain.intentOf<intent::ApplyGains>("set_gains", {{"axis", 1}, {"kd", 1'500}, {"db", 7}}).gains;
    EXPECT_EQ(gains.kp, 100);
    EXPECT_EQ(gains.kd, 1'500);
    EXPECT_EQ(gains.el, 2'000);
    EXPECT_EQ(gains.db, std::uint8_t{7});
}

/// DB came with version 4 (DS-V 5.2), SM with the SC, which takes it behind DB only.
TEST(ApiMethods, SetNoGainThatWouldNotBeSent) {
    Chain chain;
    ModuleState& module = chain.link.modules[0];
    module.gains = servo::SetGain{100, 1'000, 10, 50, 255, 0, 2'000, 1, {}};
    const auto set = [&](const Json& gains) { return chain.call("set_gains", gains); };
    const Json db{{"axis", 1}, {"db", 7}}, sm{{"axis", 1}, {"sm", 3}},
        both{{"axis", 1}, {"db", 7}, {"sm", 3}};
    ASSERT_FALSE(set(sm));
    EXPECT_EQ(set(sm).error().refusal, Refusal::VersionLacksIt);
    module.info.identity.version = 3;
    ASSERT_FALSE(set(db));
    EXPECT_EQ(set(db).error().refusal, Refusal::VersionLacksIt);
    module.info.identity.version = kScVersion;
    ASSERT_FALSE(set(sm));
    EXPECT_EQ(set(sm).error(), (api::Problem{Kind::FieldMissing, "db"}));
    EXPECT_EQ(chain.intentOf<intent::ApplyGains>("set_gains", both).gains.sm, std::uint8_t{3});
}

TEST(ApiMethods, NeedAllGainsWhileNoneAreKnown) {
    const Chain chain;
    const Json all{{"axis", 1}, {"kp", 1}, {"kd", 2}, {"ki", 3}, {"il", 4},
                   {"ol", 5},   {"cl", 6}, {"el", 7}, {"sr", 8}};
    const servo::SetGain gains = chain.intentOf<intent::ApplyGains>("set_gains", all).gains;
    EXPECT_EQ(gains.kp, 1);
    EXPECT_EQ(gains.el, 7);
    EXPECT_EQ(gains.sr, 8);
    EXPECT_FALSE(gains.db) << "may be left out (DS-V 5.1)";
}

/// In the order in which Set Gain has them (DS-V 5.1).
TEST(ApiMethods, NameAllGainsThatAreMissing) {
    const Chain chain;
    EXPECT_EQ(chain.call("set_gains", {{"axis", 1}, {"kp", 1}, {"ol", 5}, {"db", 0}}).error(),
              (api::Problem{Kind::FieldMissing, "kd, ki, il, cl, el, sr"}));
}

TEST(ApiMethods, SayThatItIsTheWrongModuleRatherThanWhatIsMissingOrTooLarge) {
    Chain chain;
    EXPECT_EQ(chain.call("set_gains", {{"axis", 2}, {"kp", 5}}).error().refusal, Refusal::NotAServo);
    chain.link.modules[1].info.identity = {ModuleType::Io, 1};
    EXPECT_EQ(chain.call("set_gains", {{"axis", 2}, {"kp", 5}}).error().refusal, Refusal::NotAServo);
    EXPECT_EQ(chain.call("jog", {{"axis", 2}, {"velocity", 1e6}}).error().refusal, Refusal::NoMotor);
}

TEST(ApiMethods, ReportWhatIsNotKnownAsNull) {
    const Chain chain;
    const Json state = api::stateOf(chain.link, chain.machine);
    EXPECT_EQ(state["phase"], "connected");
    const Json& servo = state["modules"][0];
    EXPECT_EQ(servo["name"], "X");
    EXPECT_EQ(servo["type"], "servo");
    for (const char* value : {"position", "counts", "counts_per_second", "home", "goal"})
        EXPECT_TRUE(servo[value].is_null()) << value;
    EXPECT_EQ(state["modules"][1]["type"], "stepper");
}

TEST(ApiMethods, ReportUnitsAndTheGainsThatAreKnown) {
    Chain chain;
    EXPECT_TRUE(api::stateOf(chain.link, chain.machine)["modules"][0]["gains"].is_null());
    chain.link.modules[0].gains = servo::SetGain{100, 1'000, 0, 0, 255, 0, 2'000, 3, {}};
    chain.machine.axes[0].unit = {UnitKind::Millimetres, 100.0};
    const Json modules = api::stateOf(chain.link, chain.machine)["modules"];
    EXPECT_EQ(modules[0]["unit"], "mm");
    EXPECT_EQ(modules[0]["velocity_unit"], "mm/s");
    EXPECT_EQ(modules[1]["unit"], "steps");
    EXPECT_EQ(modules[1]["velocity_unit"], "steps/s");
    EXPECT_EQ(modules[0]["gains"], (Json{{"kp", 100},
                                         {"kd", 1'000},
                                         {"ki", 0},
                                         {"il", 0},
                                         {"ol", 255},
                                         {"cl", 0},
                                         {"el", 2'000},
                                         {"sr", 3}}))
        << "without the deadband, which is optional (DS-V 5.1)";
    chain.machine.axes[0].unit = {UnitKind::Own, -100.0, "drops"};
    chain.link.modules[0].latest.emplace().position = 0;
    const Json reversed = api::stateOf(chain.link, chain.machine)["modules"][0];
    EXPECT_EQ(reversed["unit"], "drops");
    EXPECT_EQ(reversed["position"].dump(), "0.0") << "not -0.0";
    chain.machine.axes[0].unit = {UnitKind::Own, 1.0, "counts"};
    EXPECT_EQ(api::stateOf(chain.link, chain.machine)["modules"][0]["velocity_unit"], "counts/s");
    chain.machine.axes[0].unit = {};
    EXPECT_EQ(api::stateOf(chain.link, chain.machine)["modules"][0]["velocity_unit"], "counts/tick");
}

TEST(ApiMethods, ReportInputsAndOutputs) {
    Chain chain;
    chain.link.modules.emplace_back().info = {ModuleIndex(2), BusAddress(3), {ModuleType::Io, 1}};
    EXPECT_TRUE(api::stateOf(chain.link, chain.machine)["modules"][0]["inputs"]["limit1"].is_null());
    StatusReport report;
    report.status = 0x28;  // limit 1 and power (DS-V 5.3)
    report.analog = std::uint8_t{51};
    chain.link.modules[0].latest = report;
    report.status = 0x08;             // power (DS-S 5.2)
    report.aux = std::uint8_t{0x21};  // E-stop and home switch
    chain.link.modules[1].latest = report;
    report = {};
    report.pins = std::uint16_t{0x805};
    report.analogs = {std::uint8_t{0}, std::uint8_t{100}, std::nullopt};
    report.counter = 70'000U;
    chain.link.modules[2].latest = report;
    chain.link.modules[2].pins.inputs = std::uint16_t{0x7FF};
    chain.link.modules[2].pins.pwm = {std::uint8_t{7}, std::uint8_t{255}};
    chain.machine.axes.resize(3);
    chain.machine.axes[2].pins = PinSettings{{{"valve"}}, {}, {{}, {"pressure", {0.5, -10, "kPa"}}}};
    const Json modules = api::stateOf(chain.link, chain.machine)["modules"];
    EXPECT_EQ(modules[0]["inputs"], (Json{{"limit1", true}, {"limit2", false}, {"power", true}}));
    // 5 V are 255 counts.
    EXPECT_DOUBLE_EQ(modules[0]["analog"][0]["value"].get<double>(), 1.0);
    EXPECT_EQ(modules[1]["inputs"], (Json{{"estop", true},
                                          {"in1", false},
                                          {"in2", false},
                                          {"limit1", false},
                                          {"limit2", false},
                                          {"home", true},
                                          {"power", true}}));
    const Json& io = modules[2];
    ASSERT_EQ(io["pins"].size(), 12U);
    EXPECT_EQ(io["pins"][0], (Json{{"number", 1}, {"name", "valve"}, {"input", true}, {"high", true}}));
    EXPECT_EQ(io["pins"][1], (Json{{"number", 2}, {"name", ""}, {"input", true}, {"high", false}}));
    EXPECT_EQ(io["pins"][11], (Json{{"number", 12}, {"name", ""}, {"input", false}, {"high", true}}));
    EXPECT_EQ(
        io["analog"][1],
        (Json{
            {"name", "pressure"}, {"value", 40.0}, {"unit", "kPa"}, {"per_count", 0.5}, {"at_zero", -10.0}}));
    EXPECT_TRUE(io["analog"][2]["value"].is_null());
    EXPECT_EQ(io["pwm"], (Json{7, 255}));
    EXPECT_EQ(io["counter"], 70'000);
}

/// A PIC-SERVO with an A/D scale of its own, and a PIC-I/O.
api::ApiRecording apiRecording() {
    Chain chain;
    chain.link.modules[1].info.identity = {ModuleType::Io, 1};
    chain.machine.axes[0].analog = {0.25, -1.5, "A"};
    chain.machine.axes[1].pins = PinSettings{{{"valve"}}, {}, {{}, {"pressure", {0.5, -10, "kPa"}}}};
    return {api::stateOf(chain.link, chain.machine), "test", "now"};
}

TEST(ApiRecording, HoldsWhatTheScopeWouldSave) {
    api::ApiRecording recording = apiRecording();
    const auto read = testing_support::readRecording(
        recording.head() + recording.rowsOf(Json::parse(R"({"missed": 0, "modules": [
            {"axis": 1, "rows": [[1.5, -7, 2, null, 9, 4, 51, true, null]]},
            {"axis": 2, "rows": [[1.75, 3000000000, 100, 200, 5, 8, 52, false, true]]}]})")));
    EXPECT_FALSE(read.problem);
    ASSERT_EQ(read.samples.size(), 2U);
    const ScopeSample& servo = read.samples[0].second;
    EXPECT_EQ(servo.position, -7);
    EXPECT_EQ(servo.error, 2.0F);
    EXPECT_EQ(servo.analog, 51);
    EXPECT_TRUE(servo.gapBefore);
    const ScopeSample& io = read.samples[1].second;
    EXPECT_TRUE(io.io && io.counted && !io.gapBefore);
    EXPECT_EQ(io.counter(), 3'000'000'000U);
    EXPECT_EQ(io.analog, 52);
    EXPECT_EQ(io.error, 100.0F) << "A/D 2";
    EXPECT_EQ(io.velocity, 200.0F) << "A/D 3";
    EXPECT_EQ(toSeconds(io.time - servo.time), 0.25);
    EXPECT_EQ(read.header.modules[0].analog, (AnalogScale{0.25, -1.5, "A"}));
    EXPECT_EQ(PinSettings::of(read.header.modules[1].pins.pins, 0).name, "valve");
    EXPECT_EQ(PinSettings::of(read.header.modules[1].pins.analog, 1),
              (AnalogInput{"pressure", {0.5, -10, "kPa"}}));
}

TEST(ApiRecording, TakesAnOwnUnitThatIsCalledCountsForWhatItIs) {
    Chain chain;
    chain.machine.axes[0].unit = {UnitKind::Own, 10.0, "counts"};
    api::ApiRecording recording(api::stateOf(chain.link, chain.machine), "test", "now");
    const auto read = testing_support::readRecording(
        recording.head() + recording.rowsOf(Json::parse(R"({"missed": 0, "modules": [
            {"axis": 1, "rows": [[0, 0, null, null, 0, 0, 0, false, null]]}]})")));
    EXPECT_EQ(read.header.modules[0].unit, chain.machine.axes[0].unit);
}

TEST(ApiRecording, EndsWithItsChain) {
    api::ApiRecording recording = apiRecording();
    const auto samples = [](int axis, double time) {
        return Json::parse(R"({"missed": 0, "modules": [{"axis": )" + std::to_string(axis) +
                           R"(, "rows": [[)" + std::to_string(time) +
                           R"(, 0, null, null, 0, 0, 0, false, false]]}]})");
    };
    EXPECT_TRUE(recording.isOfThisChain(samples(1, 5)));
    EXPECT_FALSE(recording.isOfThisChain(samples(3, 5))) << "it has two modules";
    (void)recording.rowsOf(samples(1, 5));
    EXPECT_TRUE(recording.isOfThisChain(samples(1, 5.1)));
    EXPECT_TRUE(recording.isOfThisChain(samples(2, 4.9))) << "another module";
    EXPECT_FALSE(recording.isOfThisChain(samples(1, 0))) << "times begin anew";
}

TEST(ApiRecording, HasAGapInEachModuleWhereSamplesWereMissed) {
    api::ApiRecording recording = apiRecording();
    std::string text = recording.head();
    for (const char* message :
         {R"({"missed": 0, "modules": [{"axis": 1, "rows": [[0, 0, null, null, 0, 0, 0, false, null]]},
                                    {"axis": 2, "rows": [[0, 0, 0, 0, 0, 0, 0, false, false]]}]})",
          R"({"missed": 40, "modules": [{"axis": 1, "rows": [[5, 0, null, null, 0, 0, 0, false, null],
                                                                                   [5.1, 0, null, null, 0, 0, 0, false, null]]},
                                    {"axis": 2, "rows": [[5, 0, 0, 0, 0, 0, 0, false, false]]}]})"})
        text += recording.rowsOf(Json::parse(message));
    std::vector<bool> gaps;
    for (const auto& [module, sample] : testing_support::readRecording(text).samples)
        gaps.push_back(sample.gapBefore);
    EXPECT_EQ(gaps, (std::vector{false, false, true, false, true}));
}

TEST(EnumName, IsTheNameInTheSource) {
    EXPECT_EQ(enumName<Refusal::TooFar>(Refusal::NotConnected), "NotConnected");
    EXPECT_EQ(enumName<Refusal::TooFar>(Refusal::NeedsStop), "NeedsStop");
    EXPECT_EQ(enumName<Activity::Ready>(Activity::Ready), "Ready");
}

}  // namespace
}  // namespace nmc
