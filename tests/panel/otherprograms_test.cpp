// SPDX-License-Identifier: GPL-3.0-or-later
// What other programs may do at the panel's socket, and what they learn of it (docs/api.md).
#include <QJsonArray>
#include <algorithm>
#include <random>
#include <vector>

#include "model/intent/jog.h"
#include "tests/panel/otherprograms.h"
#include "widgets/common/requests.h"
#include "widgets/common/words.h"
#include "widgets/messages/messagemodel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using Json = testing_support::OtherProgram::Json;
using testing_support::moves;
using testing_support::OtherProgram;
using testing_support::OtherPrograms;
using testing_support::RuntimeFolder;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

TEST_F(OtherPrograms, ReadWithoutAsking) {
    OtherProgram client(panel, path());
    client.hello();
    const Json state = client.call("state")["result"];
    EXPECT_EQ(state["phase"], "connected");
    EXPECT_EQ(state["modules"].size(), 2U);
    EXPECT_EQ(state["modules"][0]["type"], "servo");
    EXPECT_EQ(state["modules"][0]["position"], 0.0);
    EXPECT_TRUE(state["modules"][0]["home"].is_null());
    EXPECT_TRUE(state["control"].is_null());
    EXPECT_EQ(client.call("state", {{"axis", 2}})["result"], state["modules"][1]);
    EXPECT_EQ(client.call("state", {{"axis", 3}})["error"]["data"]["reason"], "AxisUnknown");
    EXPECT_TRUE(ribbon().contains(u"Connected: 1."_s)) << ribbon().toStdString();
}

TEST_F(OtherPrograms, MustSayHelloInAProtocolThatIsSpokenHere) {
    OtherProgram client(panel, path());
    EXPECT_EQ(client.call("state")["error"]["data"]["reason"], "HelloFirst");
    EXPECT_EQ(client.call("hello", {{"protocol", "2.0"}, {"program", "new"}})["error"]["data"]["reason"],
              "OtherProtocol");
    EXPECT_TRUE(
        client.call("hello", {{"protocol", "1.7"}, {"program", "new"}, {"unheard_of", 1}}).contains("result"))
        << "a later minor version, and what it adds, is no obstacle";
}

TEST_F(OtherPrograms, MoveNothingWithoutControl) {
    OtherProgram client(panel, path());
    client.hello();
    for (const char* method : {"enable", "zero", "go_home", "home", "clear_sticky_bits"})
        EXPECT_EQ(client.call(method, {{"axis", 1}})["error"]["data"]["reason"], "NoControl") << method;
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["error"]["data"]["reason"], "NoControl");
    EXPECT_EQ(client.call("jog", {{"axis", 1}, {"velocity", 1}})["error"]["data"]["reason"], "NoControl");
    EXPECT_FALSE(sim.isOn(0));
}

TEST_F(OtherPrograms, MoveWhereTheyWantOnceTheUserAgrees) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_TRUE(ribbon().contains(u"\"scan.py\" may move motors"_s)) << ribbon().toStdString();
    EXPECT_EQ(client.call("state")["result"]["control"], "scan.py");
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["result"]["accepted"], true);
    const Json rest = client.call("wait", {{"axis", 1}})["result"];
    EXPECT_EQ(rest["moving"], false);
    EXPECT_NEAR(rest["position"].get<double>(), 500, 2);
    EXPECT_EQ(client.call("move_by", {{"axis", 1}, {"by", -200}, {"velocity", 2}})["result"]["accepted"],
              true);
    EXPECT_NEAR(client.call("wait", {{"axis", 1}})["result"]["position"].get<double>(), 300, 2);
    EXPECT_EQ(sim.violations(), "");
}

/// The gains on trial are temporary, and their output limit is lowered.
TEST_F(OtherPrograms, SetGainsWithinATrialOverThoseFromBefore) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    servo::SetGain gains = *panel.module().gains;
    gains.kp = 250;
    emit panel.window().requests().intent(ModuleIndex(0), intent::TryGains{gains, 10.0});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains->kp == 250; }));
    ASSERT_NO_FATAL_FAILURE(control(client)) << "the user's trial has ended it";
    EXPECT_EQ(client.call("set_gains", {{"axis", 1}, {"kd", 1'800}})["result"]["accepted"], true);
    gains.kp = 200;
    gains.kd = 1'800;
    EXPECT_TRUE(panel.waitFor([&] { return panel.module().gains == gains; }));
}

/// 100 counts from where it was called 0, not from 5000.
TEST_F(OtherPrograms, MoveFromWhereTheirLastRequestHasLeftTheMotor) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 5'000}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    int zero = client.request("zero", {{"axis", 1}});
    int move = client.request("move_by", {{"axis", 1}, {"by", 100}});
    const int wait = client.request("wait", {{"axis", 1}});
    EXPECT_EQ(client.answer(zero)["result"]["accepted"], true);
    EXPECT_EQ(client.answer(move)["result"]["accepted"], true);
    EXPECT_NEAR(client.answer(wait)["result"]["position"].get<double>(), 100, 10);
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 100, 10);

    move = client.request("move_by", {{"axis", 1}, {"by", 100'000}});
    zero = client.request("zero", {{"axis", 1}});
    EXPECT_EQ(client.answer(move)["result"]["accepted"], true);
    EXPECT_TRUE(client.answer(zero).contains("error")) << "it moves by then";
    EXPECT_EQ(sim.violations(), "");
}

/// What is requested next waits for the answer to the first request, and no time passes on the bus until a
/// test waits.
TEST_F(OtherPrograms, RequestNothingMoreThanAStopOrTheUserLetsThem) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    const auto request = [&] {
        client.request("clear_sticky_bits", {{"axis", 1}});
        return client.request("move_by", {{"axis", 1}, {"by", 100'000}});
    };
    const int first = request();
    const int stop = client.request("stop", {{"axis", 1}});
    EXPECT_EQ(client.answer(first)["error"]["data"]["reason"], "NotCarriedOut");
    EXPECT_EQ(client.answer(stop)["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));

    client.arrived().clear();
    const int second = request();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !client.arrived().empty(); }));
    EXPECT_EQ(client.arrived().size(), 1U);
    emit panel.window().requests().intent(ModuleIndex(1), intent::ClearStickyBits{});
    EXPECT_EQ(client.answer(second)["error"]["data"]["reason"], "NotCarriedOut");
    EXPECT_TRUE(panel.answersFor(0.5));
    EXPECT_FALSE(moves(sim));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 10);
}

/// The axis needs half a second within 20 counts of its goal.
TEST_F(OtherPrograms, WaitUntilTheMotorHasStayedWithinTheToleranceOfItsAxis) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    AxisSettings axis = panel.composition().machine().axes.at(0);
    axis.arrival = {20, 0.5};
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    ASSERT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["result"]["accepted"], true);
    const int waits = client.request("wait", {{"axis", 1}});
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module().moving(); }));
    const TimePoint ended = virtualtime::now();
    EXPECT_EQ(client.answer(waits)["result"]["moving"], false);
    EXPECT_GE(virtualtime::now() - ended, std::chrono::milliseconds(450));
}

TEST_F(OtherPrograms, AreRefusedInTheWordsOfTheWindow) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(control(client));
    const Json error = client.call("move", {{"axis", 1}, {"to", 500}})["error"];
    EXPECT_EQ(error["data"]["reason"], "ServoOff");
    EXPECT_EQ(error["message"], texts::refusal(Refusal::ServoOff).toStdString());
    EXPECT_EQ(client.call("move", {{"axis", 7}, {"to", 500}})["error"]["data"]["reason"], "AxisUnknown");
    EXPECT_EQ(client.call("move", {{"axis", 1}})["error"]["data"]["reason"], "FieldMissing");
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", "far"}})["error"]["data"]["reason"], "FieldWrong");
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 3e9}})["error"]["data"]["reason"], "GoalOutOfRange");
    EXPECT_EQ(client.call("dance")["error"]["data"]["reason"], "NoMethod");
}

TEST_F(OtherPrograms, LearnFromWaitWhatFailed) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 1'000'000}})["result"]["accepted"], true);
    const int waits = client.request("wait", {{"axis", 1}});
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    const int moves = client.request("move_by", {{"axis", 1}, {"by", 50}});
    EXPECT_EQ(client.answer(moves)["error"]["data"]["reason"], "Moving");
    EXPECT_EQ(client.call("stop", {{"axis", 1}})["result"]["accepted"], true);
    EXPECT_TRUE(client.answer(waits).contains("result")) << "the move was begun, and then stopped on request";
    EXPECT_EQ(client.call("move_by", {{"axis", 1}, {"by", 100'000}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().moving(); }));
    EXPECT_EQ(client.call("stop")["result"]["sent"], true);
    EXPECT_EQ(client.call("wait", {{"axis", 1}})["error"]["data"]["reason"], "NotCarriedOut")
        << "repeated moves are a procedure, which the stop cancelled";
}

TEST_F(OtherPrograms, MayStopOneMotorWhileTheChainIsSearchedFor) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 1'000'000}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    panel.composition().worker().connectAgain();
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().store().link().looking; }));
    EXPECT_EQ(client.call("move_by", {{"axis", 1}, {"by", 5}})["error"]["data"]["reason"], "NoControl");
    EXPECT_EQ(client.call("stop", {{"axis", 1}})["result"]["accepted"], true);
    EXPECT_TRUE(panel.composition().store().link().looking);
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST_F(OtherPrograms, AreNotToldThatTheyHaveStoppedTheirMovesThemselves) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move_by", {{"axis", 1}, {"by", 100'000}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
    EXPECT_EQ(client.call("stop", {{"axis", 1}})["result"]["accepted"], true);
    const Json rest = client.call("wait", {{"axis", 1}});
    ASSERT_TRUE(rest.contains("result")) << rest.dump();
    EXPECT_LT(rest["result"]["position"].get<double>(), 90'000);
}

TEST_F(OtherPrograms, LearnFromWaitThatTheUserInterruptedTheirMove) {
    for (const bool stopsAll : {true, false}) {
        OtherProgram client(panel, path());
        ASSERT_NO_FATAL_FAILURE(ready(client));
        EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 1'000'000}})["result"]["accepted"], true);
        const int one = client.request("wait", {{"axis", 1}});
        const int all = client.request("wait");
        ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
        if (stopsAll)
            panel.pressStopAll();
        else
            panel.ask(intent::StopSmoothly{});
        EXPECT_EQ(client.answer(one)["error"]["data"]["reason"], "NotCarriedOut") << stopsAll;
        EXPECT_EQ(client.answer(all)["error"]["data"]["reason"], "NotCarriedOut") << stopsAll;
    }
}

TEST_F(OtherPrograms, LearnFromWaitThatTheUserEndedTheirRepeatedMoves) {
    for (const Intent& ends : {Intent(intent::StopSmoothly{}), Intent(intent::CancelProcedure{})}) {
        OtherProgram client(panel, path());
        ASSERT_NO_FATAL_FAILURE(ready(client));
        EXPECT_EQ(client.call("move_by", {{"axis", 1}, {"by", 100'000}})["result"]["accepted"], true);
        const int waits = client.request("wait", {{"axis", 1}});
        ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
        panel.ask(ends);
        EXPECT_EQ(client.answer(waits)["error"]["data"]["reason"], "NotCarriedOut") << ends.index();
    }
}

/// At 1 count per tick of 0.512 ms, the search gives up after 1.5 s: the switch never closes.
TEST_F(OtherPrograms, LearnFromWaitThatTheirSearchFailedWhileTheUserMovedAnotherMotor) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    ASSERT_NO_FATAL_FAILURE(enable(client, 2));
    AxisSettings axis = panel.composition().machine().axes.at(0);
    axis.homing = HomingRecipe{
        .onLimit1 = true, .velocity = 1, .acceleration = 0.02, .travelLimit = 3'000, .timeLimit = 100};
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    Program program;
    program.points.push_back({"b", {{ModuleIndex(1), 1'000, false}}});
    emit panel.window().requests().programEdited(program);
    EXPECT_EQ(client.call("home", {{"axis", 1}})["result"]["accepted"], true);
    const int waits = client.request("wait", {{"axis", 1}});
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
    emit panel.window().requests().goToPoint("b");
    EXPECT_FALSE(client.notification("control_lost").is_null());
    EXPECT_EQ(client.answer(waits)["error"]["data"]["reason"], "NotCarriedOut");
}

TEST_F(OtherPrograms, WaitForAllAxesAndTheSequence) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["result"]["accepted"], true);
    const Json rest = client.call("wait")["result"]["modules"][0];
    EXPECT_NEAR(rest["position"].get<double>(), 500, 2);
    EXPECT_EQ(rest["unit"], "counts");
    EXPECT_EQ(rest["gains"]["kd"], 2'000) << "as set by ready()";

    Program program;
    program.points.push_back({"far", {{ModuleIndex(0), 100'000, false}}});
    emit panel.window().requests().programEdited(program);
    EXPECT_EQ(client.call("go_to_point", {{"name", "far"}})["result"]["accepted"], true);
    const int waits = client.request("wait");
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    EXPECT_EQ(client.call("stop")["result"]["sent"], true);
    EXPECT_EQ(client.answer(waits)["error"]["data"]["reason"], "NotCarriedOut");
}

/// An input that must be active already: its row has no time to wait.
TEST_F(OtherPrograms, LearnFromWaitThatASequenceHasEndedAsSoonAsItBegan) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(control(client));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    Program program;
    program.sequences.push_back({"check", {action::WaitForInput{ModuleIndex(0), InputPin::Limit1, true, 0}}});
    emit panel.window().requests().programEdited(program);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(client.call("start_sequence", {{"name", "check"}})["result"]["accepted"], true);
        EXPECT_EQ(client.call("wait")["error"]["data"]["reason"], "NotCarriedOut");
        EXPECT_EQ(client.call("set_gains", kGains)["result"]["accepted"], true);
        EXPECT_TRUE(client.call("wait").contains("result")) << "the gains were set";
    }
}

TEST_F(OtherPrograms, AreNotToldThatAMoveWasCancelledWhichTheyHaveFollowedUpThemselves) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    Program program;
    program.points.push_back({"far", {{ModuleIndex(0), 1'000, false}}});
    emit panel.window().requests().programEdited(program);
    const auto move = [&](int to) {
        EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", to}})["result"]["accepted"], true);
        EXPECT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    };
    move(500);
    EXPECT_EQ(client.call("go_to_point", {{"name", "far"}})["result"]["accepted"], true);
    const Json all = client.call("wait");
    ASSERT_TRUE(all.contains("result")) << all.dump();
    EXPECT_NEAR(all["result"]["modules"][0]["position"].get<double>(), 1'000, 2);
    EXPECT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));

    move(500);
    EXPECT_EQ(client.call("jog", {{"axis", 1}, {"velocity", 1}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
    const Json jogged = client.call("wait", {{"axis", 1}});
    EXPECT_TRUE(jogged.contains("result")) << jogged.dump();
}

TEST_F(OtherPrograms, AreNotToldThatMovesWereCancelledWhichTheirJogHasReplaced) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move_by", {{"axis", 1}, {"by", 100'000}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
    EXPECT_EQ(client.call("jog", {{"axis", 1}, {"velocity", 1}})["result"]["accepted"], true);
    const Json jogged = client.call("wait", {{"axis", 1}});
    ASSERT_TRUE(jogged.contains("result")) << jogged.dump();
    EXPECT_LT(jogged["result"]["position"].get<double>(), 90'000);
}

TEST_F(OtherPrograms, AreNotToldThatAMoveWasCancelledWhichWasDone) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    panel.ask(
        intent::Move{servomotion::Trapezoid{Counts(700), CountsPerTick(65'536), CountsPerTickSquared(131)}});
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    const Json moved = client.call("wait", {{"axis", 1}});
    ASSERT_TRUE(moved.contains("result")) << moved.dump();
    EXPECT_NEAR(moved["result"]["position"].get<double>(), 700, 5);

    ASSERT_NO_FATAL_FAILURE(control(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait").contains("result"));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    const Json found = client.call("wait", {{"axis", 1}});
    EXPECT_TRUE(found.contains("result")) << found.dump();
}

TEST_F(OtherPrograms, WaitForTheEndOfAStopThatWouldCancelWhatComesNext) {
    OtherProgram client(panel, path());
    client.hello();
    const int stop = client.request("stop");
    const int wait = client.request("wait");
    // No time passes on the bus here.
    ASSERT_TRUE(QTest::qWaitFor([&] { return !client.arrived().empty(); }));
    EXPECT_EQ(client.arrived().size(), 1U) << "every motor is at rest, so nothing else delays the answer";
    EXPECT_EQ(client.answer(stop)["result"]["sent"], true);
    EXPECT_TRUE(client.answer(wait).contains("result"));
}

TEST_F(OtherPrograms, AreNotToldThatAllMotorsRestWhileOneHasNotConfirmedAStop) {
    OtherProgram client(panel, path());
    client.hello();
    const auto falls = [&](bool silent) {
        sim.tell(silent ? "fault module 2 mute tx" : "fault clear");
        return panel.waitFor([&] { return panel.module(1).silent == silent; });
    };
    ASSERT_TRUE(falls(true));
    EXPECT_TRUE(client.call("wait").contains("result")) << "it has moved none of them";
    const int stop = client.request("stop");
    const int wait = client.request("wait");
    EXPECT_EQ(client.answer(stop)["result"]["sent"], true);
    EXPECT_EQ(client.answer(wait)["error"]["data"]["reason"], "Unresponsive");
    OtherProgram next(panel, path());
    next.hello();
    EXPECT_EQ(next.call("wait")["error"]["data"]["reason"], "Unresponsive") << "whoever has requested it";
    ASSERT_TRUE(falls(false));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module(1).stopUnconfirmed; }));
    ASSERT_TRUE(falls(true));
    EXPECT_TRUE(client.call("wait").contains("result")) << "it has confirmed the stop";
}

TEST_F(OtherPrograms, WaitNoLongerForAStopOnceTheLineIsLost) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    ASSERT_EQ(client.call("jog", {{"axis", 1}, {"velocity", 2}})["result"]["accepted"], true);
    const int stop = client.request("stop");
    const int wait = client.request("wait");
    sim.unplug();
    EXPECT_EQ(client.answer(stop)["result"]["sent"], true);
    EXPECT_EQ(client.answer(wait)["error"]["data"]["reason"], "NotConnected");
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(client.call("wait").contains("result"));
    EXPECT_FALSE(moves(sim)) << "the stop was sent again";
}

/// The bus thread has ended, and refuses what is requested until the window hears of that.
TEST_F(OtherPrograms, MayRequestAMoveOfALineThatWasLostJustNow) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    sim.unplug();
    while (sim.open())
        panel.freeze(std::chrono::milliseconds(1));
    const int move = client.request("move", {{"axis", 1}, {"to", 500}});
    // No time passes in the window here.
    ASSERT_TRUE(QTest::qWaitFor([&] { return !client.arrived().empty(); }));
    EXPECT_EQ(client.answer(move)["result"]["accepted"], true) << "the window has not heard of it yet";
    EXPECT_EQ(client.call("wait")["error"]["data"]["reason"], "NotConnected");
}

/// The stop is not over when the line is lost, and no program is let in at that time.
TEST_F(OtherPrograms, WaitForNoStopOfALineThatWasLostBeforeTheyCame) {
    OtherProgram client(panel, path());
    client.hello();
    const int stop = client.request("stop");
    // No time passes on the bus here.
    ASSERT_TRUE(QTest::qWaitFor([&] { return !client.arrived().empty(); }));
    EXPECT_EQ(client.answer(stop)["result"]["sent"], true);
    auto* letIn = panel.window().findChild<QAction*>(u"letProgramsInAction"_s);
    letIn->trigger();
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    letIn->trigger();
    OtherProgram next(panel, path());
    next.hello();
    EXPECT_TRUE(next.call("wait").contains("result"));
}

TEST_F(OtherPrograms, WaitUntilHomeIsKnown) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 300}})["result"]["accepted"], true);
    EXPECT_TRUE(client.call("wait", {{"axis", 1}})["result"]["home"].is_null());
    EXPECT_EQ(client.call("set_home", {{"axis", 1}})["result"]["accepted"], true);
    EXPECT_NEAR(client.call("wait", {{"axis", 1}})["result"]["home"].get<double>(), 300, 2)
        << "the chip has been asked where that is";
}

TEST_F(OtherPrograms, GetNoControlThatTheUserRefuses) {
    OtherProgram client(panel, path());
    client.hello();
    const int asked = client.request("request_control");
    ASSERT_NO_FATAL_FAILURE(decide("refuseControlButton"));
    const Json answer = client.answer(asked)["result"];
    EXPECT_EQ(answer["granted"], false);
    EXPECT_EQ(answer.value("reason", ""), "Refused");
    EXPECT_EQ(client.call("enable", {{"axis", 1}})["error"]["data"]["reason"], "NoControl");
}

TEST_F(OtherPrograms, LeaveNoMotorMovingWithoutTheControlThatTheyWantedItFor) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    emit panel.window().requests().intent(ModuleIndex(1), intent::ClearStickyBits{});
    EXPECT_FALSE(client.notification("control_lost").is_null());
    const int asked = client.request("request_control", {{"on_disconnect", "finish"}});
    ASSERT_NO_FATAL_FAILURE(decide("refuseControlButton"));
    ASSERT_EQ(client.answer(asked)["result"]["granted"], false);
    EXPECT_TRUE(moves(sim));
    client.vanish();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_LT(*panel.module().latest->position, 900'000);
}

TEST_F(OtherPrograms, HaveControlOneAtATime) {
    OtherProgram first(panel, path()), second(panel, path());
    first.hello("first");
    second.hello("second");
    const int asked = first.request("request_control");
    ASSERT_TRUE(panel.waitFor(
        [&] { return panel.window().findChild<QAbstractButton*>(u"grantControlButton"_s) != nullptr; }));
    EXPECT_EQ(second.call("request_control")["result"]["reason"], "Asking");
    ASSERT_NO_FATAL_FAILURE(decide("grantControlButton"));
    ASSERT_EQ(first.answer(asked)["result"]["granted"], true);
    const Json inUse = second.call("request_control")["result"];
    EXPECT_EQ(inUse["granted"], false);
    EXPECT_EQ(inUse.value("reason", ""), "InUse");
    EXPECT_TRUE(first.call("release_control").contains("result"));
    ASSERT_NO_FATAL_FAILURE(control(second));
    EXPECT_EQ(first.call("enable", {{"axis", 1}})["error"]["data"]["reason"], "NoControl");
}

TEST_F(OtherPrograms, LearnWhoHasControlWhereverTheStateIs) {
    OtherProgram first(panel, path()), second(panel, path());
    first.hello("first");
    ASSERT_NO_FATAL_FAILURE(control(first));
    const Json hello = second.call("hello", {{"protocol", "1.1"}, {"program", "second"}});
    EXPECT_EQ(hello["result"]["chain"]["control"], "first");
    EXPECT_TRUE(second.call("subscribe", {{"state", true}}).contains("result"));
    EXPECT_EQ(second.notification("state")["params"]["control"], "first");
    EXPECT_EQ(second.call("state")["result"]["control"], "first");
}

TEST_F(OtherPrograms, LoseControlByEsc) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 100'000}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_Escape);
    EXPECT_TRUE(client.notification("control_lost")["params"].contains("reason"));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 0}})["error"]["data"]["reason"], "NoControl");
}

TEST_F(OtherPrograms, LoseControlByACommandOfTheUser) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    emit panel.window().requests().intent(ModuleIndex(1), intent::ClearStickyBits{});
    EXPECT_FALSE(client.notification("control_lost").is_null());
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 0}})["error"]["data"]["reason"], "NoControl");
}

TEST_F(OtherPrograms, LoseControlWhenTheUserLetsASequenceGoOn) {
    Program program;
    program.points.push_back({"far", {{ModuleIndex(0), 100'000, false}}});
    emit panel.window().requests().programEdited(program);
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("go_to_point", {{"name", "far"}})["result"]["accepted"], true);
    const int waits = client.request("wait");
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    emit panel.window().requests().resumeSequence();
    EXPECT_FALSE(client.notification("control_lost").is_null());
    EXPECT_TRUE(moves(sim));
    emit panel.window().requests().stopSequence();
    EXPECT_EQ(client.answer(waits)["error"]["data"]["reason"], "NotCarriedOut")
        << "it has begun it, whoever has ended it";

    ASSERT_NO_FATAL_FAILURE(control(client));
    emit panel.window().requests().stepSequence();
    EXPECT_FALSE(client.notification("control_lost").is_null());
}

/// As before the computer sleeps.
TEST_F(OtherPrograms, LoseControlByAStopThatNobodyRequested) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(control(client));
    panel.composition().worker().stopAll();
    EXPECT_FALSE(client.notification("control_lost").is_null());
}

TEST_F(OtherPrograms, WaitForALimitedNumberOfThings) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    for (int i = 0; i < 64; ++i)
        client.request("wait", {{"axis", 1}});
    EXPECT_EQ(client.call("wait", {{"axis", 1}})["error"]["data"]["reason"], "TooMany");
    int last = 0;
    for (int i = 0; i < 1 + 64 + 1; ++i)
        last = client.request("clear_sticky_bits", {{"axis", 1}});
    // No time passes on the bus here, so the first is not over, and 64 wait for it.
    ASSERT_TRUE(QTest::qWaitFor([&] { return client.arrived().size() >= 2; }));
    EXPECT_EQ(client.answer(last)["error"]["data"]["reason"], "TooMany");
}

TEST_F(OtherPrograms, LoseControlByTheButton) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(control(client));
    panel.click("endProgramControlButton");
    EXPECT_FALSE(client.notification("control_lost").is_null());
}

TEST_F(OtherPrograms, StopWithoutHelloAndWithoutControl) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    OtherProgram other(panel, path());
    EXPECT_EQ(other.call("stop")["result"]["sent"], true);
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_FALSE(client.notification("control_lost").is_null());
    EXPECT_EQ(panel.count(u"Program \"?\": stop {}"_s), 1);
}

TEST_F(OtherPrograms, AreNotToldThatAStopWasSentWhichIsOnlySentLater) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    EXPECT_EQ(client.call("stop")["error"]["data"]["reason"], "NotConnected");
    ASSERT_TRUE(moves(sim));
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST_F(OtherPrograms, LeaveNoMotorMovingWhenTheyVanish) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    client.vanish();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_LT(*panel.module().latest->position, 900'000);
    EXPECT_EQ(panel.module().activity(), Activity::Holding);
}

/// It hears nothing for a while, so the stop has to be sent again.
TEST_F(OtherPrograms, LeaveNoMotorMovingWhoseModuleIsSilentWhenTheyVanish) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    sim.tell("fault module 1 mute tx");
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().silent; }));
    client.vanish();
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(u"Program \"scan.py\" has disconnected"_s) == 1; }));
    EXPECT_EQ(panel.count(u"the motors that it moved are stopped"_s), 1);
    EXPECT_TRUE(moves(sim));
    sim.tell("fault clear");
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().silent; }));
    EXPECT_LT(*panel.module().latest->position, 900'000);
}

TEST_F(OtherPrograms, LeaveNoMotorMovingThatOnlyTheyHaveCommanded) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    emit panel.window().requests().intent(ModuleIndex(1), intent::ClearStickyBits{});
    EXPECT_FALSE(client.notification("control_lost").is_null());
    EXPECT_TRUE(moves(sim)) << "a command to another motor";
    client.vanish();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
}

TEST_F(OtherPrograms, DoNotStopWhatTheUserMovesWhenTheyVanish) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 10}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}});
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    client.vanish();
    EXPECT_TRUE(panel.answersFor(1));
    EXPECT_TRUE(moves(sim));
    EXPECT_TRUE(panel.module().moving());
}

TEST_F(OtherPrograms, LeaveNoMotorMovingAlthoughTheUserMovesAnotherOne) {
    Program program;
    program.points.push_back({"b", {{ModuleIndex(1), 1'000, false}}});
    emit panel.window().requests().programEdited(program);
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(setGoing(client));
    ASSERT_NO_FATAL_FAILURE(enable(client, 2));
    emit panel.window().requests().goToPoint("b");
    EXPECT_FALSE(client.notification("control_lost").is_null());
    EXPECT_TRUE(moves(sim));
    client.vanish();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_LT(*panel.module().latest->position, 900'000);
}

TEST_F(OtherPrograms, DoNotStopTheSequenceOfAnotherOneWhenTheyVanish) {
    OtherProgram first(panel, path()), second(panel, path());
    second.hello("second");
    ASSERT_NO_FATAL_FAILURE(ready(first));
    EXPECT_TRUE(first.call("release_control").contains("result"));
    Program program;
    program.points.push_back({"far", {{ModuleIndex(0), 100'000, false}}});
    emit panel.window().requests().programEdited(program);
    ASSERT_NO_FATAL_FAILURE(control(second));
    EXPECT_EQ(second.call("go_to_point", {{"name", "far"}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim) && panel.module().moving(); }));
    first.vanish();
    EXPECT_TRUE(panel.answersFor(1));
    EXPECT_TRUE(moves(sim));
    second.vanish();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_LT(*panel.module().latest->position, 90'000);
}

TEST_F(OtherPrograms, MayLetTheirMovesFinish) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_TRUE(client.call("release_control").contains("result"));
    ASSERT_NO_FATAL_FAILURE(control(client, {{"on_disconnect", "finish"}}));
    EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 3'000}})["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    client.vanish();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_NEAR(*panel.module().latest->position, 3'000, 2);
}

/// A jog is evidence for 250 ms, as a held button is; calls sooner than that keep it up.
TEST_F(OtherPrograms, JogOnlyWhileTheySaySo) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    const Json jog{{"axis", 1}, {"velocity", 0.5}};
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true);
        panel.answersFor(0.05);
    }
    panel.answersFor(0.1);
    EXPECT_TRUE(moves(sim)) << "150 ms after the last call";
    const auto before = *panel.module().latest->position;
    EXPECT_GT(before, 0);
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); }));
    EXPECT_EQ(panel.count(texts::holdExpired({ModuleIndex(0)}).headline), 1);
    EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true) << "as another press";
    EXPECT_TRUE(panel.waitFor([&] { return moves(sim); }));
    EXPECT_EQ(sim.violations(), "");
}

/// 0.25 s are 488 ticks of 0.512 ms. At 0.002 counts per tick squared, 0.5 counts per tick are reached after
/// 250 of them and 62 counts.
TEST_F(OtherPrograms, WaitForTheEndOfAJogThatHasNotBegun) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(ready(client));
    const int jog = client.request("jog", {{"axis", 1}, {"velocity", 0.5}});
    const int wait =
        client.request("wait", {{"axis", 1}});  // both are read before any time passes on the bus
    EXPECT_EQ(client.answer(jog)["result"]["accepted"], true);
    const Json rest = client.answer(wait);
    ASSERT_TRUE(rest.contains("result")) << rest.dump();
    EXPECT_FALSE(moves(sim));
    EXPECT_GT(rest["result"]["position"].get<double>(), 50);
}

/// The search waits until the other motor stands; a jog that begins meanwhile would end that wait.
TEST_F(OtherPrograms, DoNotKeepTheUserFromASearchByAJogThatGoesOn) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    ASSERT_NO_FATAL_FAILURE(enable(client, 2));
    ASSERT_EQ(client.call("move_by", {{"axis", 2}, {"by", 100'000}})["result"]["accepted"], true);
    const Json jog{{"axis", 1}, {"velocity", 0.5}};
    ASSERT_EQ(client.call("jog", jog)["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor(
        [&] { return moves(sim) && panel.composition().store().module(ModuleIndex(1))->moving(); }));
    ASSERT_EQ(client.call("jog", jog)["result"]["accepted"], true);
    panel.window().findChild<QAction*>(u"scanAction"_s)->trigger();
    for (int i = 0; i < 100 && panel.chainsFound() < 2; ++i) {
        client.call("jog", jog);
        panel.answersFor(0.05);
    }
    EXPECT_EQ(panel.chainsFound(), 2);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(OtherPrograms, AreToldWhyAJogHasEndedByItself) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    const Json jog{{"axis", 1}, {"velocity", 0.5}};
    Json answer = client.call("jog", jog);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    ASSERT_TRUE(sim.control(u"set 1 power 0"_s).contains(u"ok"_s));
    for (int i = 0; i < 50 && answer.contains("result"); ++i) {
        panel.answersFor(0.05);
        answer = client.call("jog", jog);
    }
    EXPECT_EQ(answer["error"]["data"]["reason"], "ServoOff") << answer.dump();
}

TEST_F(OtherPrograms, AreToldThatAnotherOneHasStoppedTheirJog) {
    OtherProgram client(panel, path()), other(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(ready(client));
    const Json jog{{"axis", 1}, {"velocity", 0.5}};
    EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true);
    EXPECT_EQ(other.call("stop", {{"axis", 1}})["result"]["accepted"], true);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(client.call("jog", jog)["error"]["data"]["reason"], "NotCarriedOut");
        ASSERT_TRUE(panel.answersFor(0.1));
    }
    EXPECT_FALSE(moves(sim));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true) << "as another press";
    EXPECT_TRUE(panel.waitFor([&] { return moves(sim); }));
}

/// The motor is on its way to the limit that applied at first.
TEST_F(OtherPrograms, AreToldThatAnotherTravelLimitHasEndedTheirJog) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("set_home", {{"axis", 1}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    AxisSettings axis = panel.composition().machine().axes.at(0);
    axis.travel.highest = 50'000;
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    const Json jog{{"axis", 1}, {"velocity", 0.5}};
    EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    Json answer = client.call("jog", jog);
    axis.travel.highest = 40'000;
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    for (int i = 0; i < 10 && answer.contains("result"); ++i) {
        ASSERT_TRUE(panel.answersFor(0.05));
        answer = client.call("jog", jog);
    }
    EXPECT_EQ(answer["error"]["data"]["reason"], "NotCarriedOut") << answer.dump();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

/// The bus ends a press by its own clock, perhaps just before a call that is in time by the panel's.
TEST_F(OtherPrograms, AreToldThatTheirJogHasExpiredBeforeACallThatWasInTime) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    const Json jog{{"axis", 1}, {"velocity", 0.5}};
    ASSERT_EQ(client.call("jog", jog)["result"]["accepted"], true);
    const std::uint32_t press = nextPress() - 1;
    const auto expire = [&](std::uint32_t which) {
        emit const_cast<BusStore&>(panel.composition().store())
            .happened(bus::HoldExpired{.module = ModuleIndex(0), .press = which});
    };
    expire(press - 1);
    EXPECT_EQ(client.call("jog", jog)["result"]["accepted"], true) << "that was an earlier press";
    expire(press);
    EXPECT_EQ(client.call("jog", jog)["error"]["data"]["reason"], "NotCarriedOut");
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST_F(OtherPrograms, AreToldWhichLimitKeepsThemFromJogging) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(ready(client));
    EXPECT_EQ(client.call("set_home", {{"axis", 1}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    AxisSettings axis = panel.composition().machine().axes.at(0);
    axis.travel.highest = 2;
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    const Json error = client.call("jog", {{"axis", 1}, {"velocity", 1}})["error"];
    EXPECT_EQ(error["data"]["reason"], "AtTravelEnd");
    EXPECT_EQ(error["message"].get<std::string>().find("Highest position reached: "), 0U) << error.dump();
}

TEST_F(OtherPrograms, EndAJogByAStopAndNothingIsSaidOfAHoldThatExpired) {
    OtherProgram client(panel, path());
    ASSERT_NO_FATAL_FAILURE(ready(client));
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(client.call("jog", {{"axis", 1}, {"velocity", 0.5}})["result"]["accepted"], true);
        panel.answersFor(0.05);
    }
    EXPECT_TRUE(client.call("stop", {{"axis", 1}}).contains("result"));
    EXPECT_EQ(client.call("wait", {{"axis", 1}})["result"]["moving"], false);
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(texts::holdExpired({ModuleIndex(0)}).headline), 0);
}

class OtherProgramsAtAllTypes : public OtherPrograms {
protected:
    OtherProgramsAtAllTypes() : OtherPrograms(u"servo,step,io"_s) {}
};

/// The modules have kept their addresses, so nothing is known of what they were sent before.
TEST_F(OtherProgramsAtAllTypes, WaitForModulesThatWereFoundAsTheyWere) {
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return !sim.open(); }));
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    OtherProgram client(panel, path());
    client.hello();
    EXPECT_TRUE(client.call("wait").contains("result"));
    EXPECT_TRUE(client.call("wait", {{"axis", 2}}).contains("result"));
}

/// One command sets all pins, so each is planned from what the one before has left.
TEST_F(OtherProgramsAtAllTypes, SetSeveralPinsWithoutWaiting) {
    OtherProgram client(panel, path());
    client.hello();
    ASSERT_NO_FATAL_FAILURE(control(client));
    std::vector<int> requests;
    for (const int pin : {1, 2})
        requests.push_back(client.request("set_direction", {{"axis", 3}, {"input", false}, {"pin", pin}}));
    for (const int pin : {1, 2})
        requests.push_back(client.request("set_output", {{"axis", 3}, {"output", pin}, {"high", true}}));
    for (const int request : requests)
        EXPECT_EQ(client.answer(request)["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 3}}).contains("result"));
    const QJsonObject io = sim.state(3);
    for (const int pin : {0, 1}) {
        EXPECT_FALSE(io[u"is_input"_s].toArray().at(pin).toBool()) << pin;
        EXPECT_TRUE(io[u"pins"_s].toArray().at(pin).toBool()) << pin;
    }
}

/// Whatever arrives, it is answered or its sender is cut off, and nothing moves.
TEST_F(OtherPrograms, SurviveNonsense) {
    std::mt19937 random(7);
    const auto place = [&random](qsizetype size) {
        return static_cast<qsizetype>(random() % static_cast<unsigned>(size));
    };
    const QByteArray right = R"({"jsonrpc":"2.0","id":1,"method":"move","params":{"axis":1,"to":100}})";
    for (int round = 0; round < 200; ++round) {
        OtherProgram client(panel, path());
        for (int i = 0; i < 50; ++i) {
            QByteArray line = right;
            for (int change = 0; change < 1 + i % 5; ++change)
                line[place(line.size())] = static_cast<char>(random() % 256);
            line.truncate(place(line.size() + 1));
            line.replace('\n', ' ');
            client.write(line);
        }
        const int last = client.request("stop");
        EXPECT_EQ(client.answer(last)["result"]["sent"], true);
        for (const Json& line : client.arrived())
            EXPECT_TRUE(line.contains("error")) << line.dump();
    }
    OtherProgram client(panel, path());
    client.write(QByteArray(static_cast<qsizetype>(ApiServer::kLongestLine) + 10, 'x'));
    EXPECT_TRUE(client.cutOff());
    ASSERT_EQ(client.arrived().size(), 1U);
    EXPECT_EQ(client.arrived()[0]["error"]["data"]["reason"], "LineTooLong");
    EXPECT_FALSE(moves(sim));
    EXPECT_FALSE(sim.isOn(0));
}

TEST_F(OtherPrograms, MayNestAndPadTheirParameters) {
    OtherProgram client(panel, path());
    for (const char* method : {"stop", "motor_off", "hello", "dance"}) {
        QByteArray line = R"({"jsonrpc":"2.0","id":1,"method":")" + QByteArray(method) +
                          R"(","params":{"axis":1,"protocol":"1.0","program":"x","padding":)";
        line += QByteArray(32'000, '[') + QByteArray(32'000, ']') + "}}";
        client.write(line);
        EXPECT_FALSE(client.answer(1).is_null()) << method;
    }
    for (const QString& headline : panel.headlines())
        EXPECT_LT(headline.size(), 200) << headline.toStdString();
}

TEST_F(OtherPrograms, AreCutOffWhenTheUserKeepsThemOut) {
    OtherProgram client(panel, path());
    client.hello();
    panel.window().findChild<QAction*>(u"letProgramsInAction"_s)->trigger();
    EXPECT_TRUE(client.cutOff());
    EXPECT_FALSE(QFile::exists(path()));
}

TEST_F(OtherPrograms, AreKeptOutOnceWhereAnotherPanelLetsThemIn) {
    QAction* action = panel.window().findChild<QAction*>(u"letProgramsInAction"_s);
    action->trigger();
    ApiServer other;
    ASSERT_TRUE(other.listen(path()));
    action->trigger();
    EXPECT_TRUE(panel.answersFor(1));
    const auto& entries = panel.window().messageModel().entries();
    const auto entry = std::ranges::find_if(entries, [](const MessageEntry& each) {
        return each.message.headline == u"Other programs cannot connect."_s;
    });
    ASSERT_NE(entry, entries.end());
    EXPECT_EQ(entry->count, 1);
}

/// A folder that others may enter.
TEST_F(OtherPrograms, AreNoLongerSaidToBeKeptOutOnceTheUserKeepsThemOut) {
    QAction* action = panel.window().findChild<QAction*>(u"letProgramsInAction"_s);
    const QString headline = u"Other programs cannot connect."_s;
    const QString folder = QFileInfo(path()).path();
    action->trigger();
    using enum QFileDevice::Permission;
    ASSERT_TRUE(QFile::setPermissions(
        folder, ReadOwner | WriteOwner | ExeOwner | ReadGroup | ExeGroup | ReadOther | ExeOther));
    action->trigger();
    EXPECT_TRUE(panel.waitFor([&] { return panel.standing(headline) != nullptr; }));
    EXPECT_EQ(ribbon(), u"PROGRAMS — none can connect now."_s);
    action->trigger();
    EXPECT_TRUE(panel.waitFor([&] { return panel.standing(headline) == nullptr; }));
}

}  // namespace
}  // namespace nmc
