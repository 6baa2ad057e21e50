// SPDX-License-Identifier: GPL-3.0-or-later
// Points and sequences as values: their editing, the order of their rows, contradictions, the reasons why a
// sequence cannot be run, and the state that its rows leave. Expected values are calculated by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/sequence/sequencecheck.h"
#include "model/sequence/sequenceedit.h"
#include "tests/support/motionof.h"

namespace nmc {
namespace {

using SequenceFault = SequenceProblem::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr ModuleIndex kX{0};
constexpr ModuleIndex kY{1};

ModuleState servoAt(std::uint8_t index, std::int32_t position, bool on = true) {
    ModuleState module;
    module.info = {
        ModuleIndex(index), BusAddress(static_cast<std::uint8_t>(index + 1)), {ModuleType::Servo, 4}};
    StatusReport report;
    report.status = 0x09;  // power, move done
    report.position = position;
    report.aux = static_cast<std::uint8_t>(on ? 0x04 : 0x00);
    module.latest = report;
    return module;
}
ModuleState homed(ModuleState module, std::int32_t home) {
    module.home.found(home, TimePoint{});
    return module;
}
Program twoPoints() {
    return {{{"Pick", {{kX, 1'000, true}, {kY, -200, true}}}, {"Place", {{kX, 5'000, true}}}},
            {{"Main", {action::MoveTo{"Pick"}, action::MoveTo{"Place"}}}}};
}
Machine machineOf(Program program) {
    Machine machine;
    machine.program = std::move(program);
    return machine;
}
std::vector<ModuleState> chain() {
    return {homed(servoAt(0, 300), 100), homed(servoAt(1, 0), 0)};
}
std::vector<SequenceFault> kinds(const std::vector<SequenceProblem>& problems) {
    std::vector<SequenceFault> all;
    for (const SequenceProblem& problem : problems)
        all.push_back(problem.kind);
    return all;
}

LinkState linkOf(std::vector<ModuleState> modules) {
    LinkState link;
    link.phase = LinkPhase::Connected;
    link.modules = std::move(modules);
    return link;
}

TEST(Teaching, CountsFromHomeWhereHomeIsKnown) {
    const LinkState link = linkOf({homed(servoAt(0, 1'300), 300), servoAt(1, -50)});
    EXPECT_THAT(teach({kX, kY}, link), ElementsAre(PointAxis{kX, 1'000, true}, PointAxis{kY, -50, false}));
}

TEST(Teaching, LeavesOutWhatIsNotKnown) {
    LinkState link = linkOf({servoAt(0, 5), servoAt(1, 6)});
    link.modules[0].silent = true;
    link.modules[1].latest->position.reset();
    EXPECT_THAT(teach({kX, kY, ModuleIndex(7)}, link), IsEmpty());
}

/// The position of X has jumped, which may be that of another module; Y was last heard 10 s ago.
TEST(Teaching, LeavesOutWhatIsDoubtfulOrOld) {
    LinkState link = linkOf({servoAt(0, 5), servoAt(1, 6)});
    EXPECT_EQ(teach({kX, kY}, link).size(), 2U);
    bus::Sample jump;
    jump.module = kX;
    jump.time = TimePoint(std::chrono::seconds(10));
    jump.report = *link.modules[0].latest;
    jump.jumped = true;
    link.modules[0].apply(jump);
    link.now = jump.time;
    EXPECT_THAT(teach({kX, kY}, link), IsEmpty());
}

/// The machine has a PIC-STEP as X, so its points are in steps.
TEST(Teaching, LeavesOutAnotherTypeOfModule) {
    LinkState link = linkOf({servoAt(0, 5), servoAt(1, 6)});
    link.modules[0].expected = ModuleIdentity{ModuleType::Stepper, 1};
    link.modules[1].expected = ModuleIdentity{ModuleType::Servo, 1};
    EXPECT_THAT(teach({kX, kY}, link), ElementsAre(PointAxis{kY, 6, false}));
}

TEST(Goals, AreHomePlusWhatWasTaught) {
    EXPECT_EQ(goalOf({kX, 1'000, true}, homed(servoAt(0, 0), -250)), 750);
    EXPECT_EQ(goalOf({kX, 1'000, false}, servoAt(0, 0)), 1'000);
    EXPECT_EQ(goalOf({kX, 1'000, true}, servoAt(0, 0)).error(), Refusal::HomeUnknown);
    EXPECT_EQ(goalOf({kX, 0x7FFFFFFF, true}, homed(servoAt(0, 0), 1)).error(), Refusal::GoalOutOfRange);
    EXPECT_EQ(goalOf({kX, -0x7FFFFFFF, true}, homed(servoAt(0, 0), -1)).error(), Refusal::GoalOutOfRange);
}

TEST(Goals, AreGoneToAtAShareOfTheAxisVelocity) {
    AxisSettings axis;
    axis.motion.velocity = 2.0;
    axis.motion.acceleration = 0.5;
    const auto wanted = moveIntent({kX, 10, false}, 25, servoAt(0, 0), axis);
    ASSERT_TRUE(wanted.has_value());
    const auto move = test::motionOf<servomotion::Trapezoid>(*wanted);
    EXPECT_EQ(move.velocity.value(), 32'768U) << "half a count per tick";
    EXPECT_EQ(move.acceleration.value(), 32'768U);
}

TEST(Goals, AreNotGoneToAtTheVelocityOfAnotherTypeOfModule) {
    AxisSettings axis;
    axis.expected = ModuleIdentity{ModuleType::Stepper, 1};
    axis.motion.velocity = 2'000;  // steps/s
    ModuleState module = servoAt(0, 0);
    const auto wanted = moveIntent({kX, 10, false}, 100, module, usable(axis, module.info.identity));
    ASSERT_TRUE(wanted.has_value());
    const auto move = test::motionOf<servomotion::Trapezoid>(*wanted);
    EXPECT_EQ(move.velocity.value(), 65'536U) << "one count per tick, until something else is set";
    module.expected = axis.expected;
    EXPECT_EQ(planMove({kX, 10, false}, 100, module, axis).error(), Refusal::OtherType)
        << "nor anywhere, until the module is accepted";
}

/// The axis must arrive from below, with 50 counts of play.
TEST(Goals, AreGoneToInTwoLegsWhereAMoveTurnsRound) {
    ModuleState module = servoAt(0, 0);
    module.backlash = {50, false};
    const auto loaded = [](const Orders& orders) {
        return std::get<servo::LoadTrajectory>(std::get<ServoCommand>(orders.at(0).command)).position;
    };
    const auto down = planMove({kX, -1'000, false}, 100, module, {});
    ASSERT_TRUE(down.has_value());
    EXPECT_EQ(down->goal, -1'050);
    EXPECT_EQ(loaded(down->orders), Counts(-1'050));
    ASSERT_TRUE(down->then);
    EXPECT_EQ(down->then->goal, -1'000);
    const auto back = planLeg(*down->then, module);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(loaded(*back), Counts(-1'000));
    const auto up = planMove({kX, 1'000, false}, 100, module, {});
    ASSERT_TRUE(up.has_value());
    EXPECT_EQ(loaded(up->orders), Counts(1'000));
    EXPECT_FALSE(up->then);
    EXPECT_EQ(planMove({kX, -0x7FFFFFFF, false}, 100, module, {}).error(), Refusal::GoalOutOfRange);
}

TEST(SequenceEdit, RepeatsFollowTheirRow) {
    Sequence sequence{"S", {action::Wait{1}, action::Wait{2}, action::Repeat{1, 3}}};
    insertRow(sequence, 0, action::Wait{0});
    EXPECT_EQ(sequence.rows[3], Action(action::Repeat{2, 3}));
    insertRow(sequence, 2, action::Wait{9});
    EXPECT_EQ(sequence.rows[4], Action(action::Repeat{3, 3})) << "still the row that waits 2 s";
    removeRow(sequence, 0);
    EXPECT_EQ(sequence.rows[3], Action(action::Repeat{2, 3}));
    removeRow(sequence, 2);
    EXPECT_THAT(sequence.rows, ElementsAre(Action(action::Wait{1}), Action(action::Wait{9})))
        << "nothing was left to repeat";
}

TEST(SequenceEdit, MovingARowKeepsWhatIsRepeated) {
    Sequence sequence{"S", {action::Wait{1}, action::Wait{2}, action::Wait{3}, action::Repeat{0, 2}}};
    ASSERT_TRUE(moveRow(sequence, 0, 2));
    EXPECT_THAT(sequence.rows, ElementsAre(Action(action::Wait{2}), Action(action::Wait{3}),
                                           Action(action::Wait{1}), Action(action::Repeat{2, 2})));
    const Sequence before = sequence;
    EXPECT_FALSE(moveRow(sequence, 3, 1)) << "the repeat would be above the row that it repeats";
    EXPECT_FALSE(moveRow(sequence, 2, 3));
    EXPECT_FALSE(moveRow(sequence, 4, 0)) << "there is no such row";
    EXPECT_FALSE(moveRow(sequence, 0, 4));
    EXPECT_EQ(sequence, before);
    ASSERT_TRUE(moveRow(sequence, 2, 0));
    EXPECT_EQ(sequence.rows[3], Action(action::Repeat{0, 2}));
}

TEST(SequenceEdit, ANewNameIsOneEverywhere) {
    Program program = twoPoints();
    program.sequences.push_back({"Twice", {action::Call{"Main"}}});
    renamePoint(program, "Pick", "Fetch");
    renameSequence(program, "Main", "Once");
    EXPECT_FALSE(contradiction(program));
    EXPECT_EQ(program.points[0].name, "Fetch");
    EXPECT_EQ(userOfPoint(program, "Fetch"), (RowPlace{"Once", 0}));
    EXPECT_EQ(userOfSequence(program, "Once"), (RowPlace{"Twice", 0}));
    EXPECT_EQ(userOfPoint(program, "Pick"), std::nullopt);
    EXPECT_EQ(freeName(program.points, "Fetch"), "Fetch 2");
}

TEST(SequenceWalk, GoesBackAndIntoCallsAndOutOfThem) {
    Program program;
    program.sequences = {{"Main", {action::Call{"Part"}, action::Repeat{0, 2}, action::Wait{3}}},
                         {"Part", {action::Wait{1}, action::Repeat{0, 2}, action::Call{"Nothing"}}},
                         {"Nothing", {}}};
    std::vector<std::pair<std::string, std::size_t>> way;
    std::vector<RowPlace> places{RowPlace{"Main"}};
    for (; rowAt(program, places.back()) != nullptr; goOn(program, places)) {
        ASSERT_LT(way.size(), 100U);
        way.emplace_back(places.back().sequence, places.back().row);
    }
    const std::pair<std::string, std::size_t> call{"Main", 0}, wait{"Part", 0}, again{"Part", 1},
        nothing{"Part", 2}, twice{"Main", 1}, last{"Main", 2};
    EXPECT_THAT(way, ElementsAre(call, wait, again, wait, again, nothing, twice, call, wait, again, wait,
                                 again, nothing, twice, last));
    EXPECT_EQ(places, std::vector{(RowPlace{"Main", 3})}) << "every round was counted";
}

TEST(SequenceWalk, CountsTheRoundsOfARepeatForEver) {
    Program program;
    program.sequences = {{"Main", {action::Wait{1}, action::Repeat{0, 0}}}};
    std::vector<RowPlace> places{RowPlace{"Main"}};
    for (int row = 0; row < 2 * 7; ++row)
        goOn(program, places);
    EXPECT_EQ(places, std::vector{(RowPlace{"Main", 0, {{1, 7}}})});
}

TEST(SequenceWalk, EachSequenceIsGoneIntoOnce) {
    Program program;
    program.sequences = {{"Main", {action::Call{"Part"}, action::Wait{1}, action::Call{"Part"}}},
                         {"Part", {action::Wait{2}, action::Wait{3}}}};
    EXPECT_THAT(rowsFrom(program, {"Main", 0}),
                ElementsAre(RowPlace{"Main", 0}, RowPlace{"Part", 0}, RowPlace{"Part", 1},
                            RowPlace{"Main", 1}, RowPlace{"Main", 2}));
    EXPECT_THAT(rowsAbove(program, {"Main", 3}),
                ElementsAre(RowPlace{"Main", 2}, RowPlace{"Part", 1}, RowPlace{"Part", 0},
                            RowPlace{"Main", 1}, RowPlace{"Main", 0}))
        << "as they were run the last time";
    EXPECT_THAT(rowsAbove(program, {"Main", 0}), IsEmpty());
}

TEST(SequenceWalk, RepeatsLeadAboveThePlaceWhereARunBegins) {
    Program program;
    program.sequences = {{"Main",
                          {action::Wait{0}, action::Wait{1}, action::Wait{2}, action::Repeat{1, 2},
                           action::Repeat{0, 3}, action::Wait{5}}}};
    EXPECT_THAT(rowsFrom(program, {"Main", 2}),
                ElementsAre(RowPlace{"Main", 2}, RowPlace{"Main", 3}, RowPlace{"Main", 1},
                            RowPlace{"Main", 4}, RowPlace{"Main", 0}, RowPlace{"Main", 5}));
    program.sequences[0].rows[4] = action::Repeat{0, 1};
    EXPECT_THAT(rowsFrom(program, {"Main", 4}), ElementsAre(RowPlace{"Main", 4}, RowPlace{"Main", 5}))
        << "once in all is not again";
}

TEST(Contradiction, NamesItsRow) {
    EXPECT_FALSE(contradiction(twoPoints()));
    Program program = twoPoints();
    program.sequences[0].rows.push_back(action::MoveTo{"Nowhere"});
    EXPECT_EQ(contradiction(program),
              (SequenceProblem{
                  .kind = SequenceFault::NoSuchPoint, .sequence = "Main", .row = 2, .name = "Nowhere"}));
    program = twoPoints();
    program.points[1].name = "Pick";
    EXPECT_EQ(contradiction(program)->kind, SequenceFault::NameTwice);
    program = twoPoints();
    program.points[0].axes.push_back({kX, 0, true});
    EXPECT_EQ(contradiction(program)->kind, SequenceFault::AxisTwice);
    program = twoPoints();
    program.sequences[0].rows.insert(program.sequences[0].rows.begin(), action::Repeat{0, 2});
    EXPECT_EQ(contradiction(program)->kind, SequenceFault::RepeatsBelow);
}

TEST(Contradiction, ASequenceNeverLeadsToItself) {
    Program program;
    program.sequences = {
        {"A", {action::Wait{1}, action::Call{"B"}}}, {"B", {action::Call{"C"}}}, {"C", {action::Wait{1}}}};
    EXPECT_FALSE(contradiction(program));
    program.sequences[2].rows.push_back(action::Call{"A"});
    const auto problem = contradiction(program);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->kind, SequenceFault::CallsItself);
    EXPECT_EQ(problem->sequence, "A");
    EXPECT_EQ(problem->row, 1U);
    program.sequences[2].rows[1] = action::Call{"C"};
    EXPECT_EQ(contradiction(program)->kind, SequenceFault::CallsItself);
}

TEST(WhyNotRun, NothingOnAMachineThatIsReady) {
    EXPECT_THAT(whyNotRun("Main", 0, machineOf(twoPoints()), chain()), IsEmpty());
}

TEST(WhyNotRun, NamesEachRowAndAxis) {
    std::vector<ModuleState> modules{homed(servoAt(0, 300, false), 100)};
    const auto problems = whyNotRun("Main", 0, machineOf(twoPoints()), modules);
    ASSERT_THAT(kinds(problems),
                ElementsAre(SequenceFault::Refused, SequenceFault::NoSuchModule, SequenceFault::Refused));
    EXPECT_EQ(problems[0].refusal, Refusal::ServoOff);
    EXPECT_EQ(problems[1].module, kY);
    EXPECT_EQ(problems[2].row, 1U);
}

TEST(WhyNotRun, ACalledSequenceWithoutRowsIsNamedOnce) {
    Program program = twoPoints();
    program.sequences = {{"Main", {action::Call{"Nothing"}, action::Call{"Nothing"}}}, {"Nothing", {}}};
    const auto problems = whyNotRun("Main", 0, machineOf(program), chain());
    ASSERT_THAT(kinds(problems), ElementsAre(SequenceFault::NoRows));
    EXPECT_EQ(problems[0].sequence, "Nothing");
}

TEST(WhyNotRun, PointsBeyondTheChipAndWithoutHome) {
    Program program = twoPoints();
    program.points[0].axes[0].counts = 0x7FFFFFFF;
    auto problems = whyNotRun("Main", 0, machineOf(program), chain());
    ASSERT_EQ(kinds(problems), std::vector{SequenceFault::Refused});
    EXPECT_EQ(problems[0].refusal, Refusal::GoalOutOfRange);

    auto modules = chain();
    modules[0].home.forget();
    problems = whyNotRun("Main", 0, machineOf(twoPoints()), modules);
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].refusal, Refusal::HomeUnknown);

    program = twoPoints();
    program.points[1].axes[0].fromHome = false;
    EXPECT_EQ(kinds(whyNotRun("Main", 0, machineOf(program), chain())),
              std::vector{SequenceFault::TaughtElsewhere});
}

/// X arrives from above: at Place, 5 000 from home, it turns round at 5 050.
TEST(WhyNotRun, TheWayRoundLeavesTheTravelLimits) {
    auto modules = chain();
    modules[0].backlash = {50, true};
    modules[0].travel.highest = 5'050;
    EXPECT_THAT(whyNotRun("Main", 0, machineOf(twoPoints()), modules), IsEmpty());
    modules[0].travel.highest = 5'049;
    const auto problems = whyNotRun("Main", 0, machineOf(twoPoints()), modules);
    ASSERT_EQ(kinds(problems), std::vector{SequenceFault::Refused});
    EXPECT_EQ(problems[0].refusal, Refusal::BeyondTravel);
    EXPECT_EQ(problems[0].row, 1U);
}

/// X stands at home, where it need not move; when it comes back from Away, it turns round 50 below.
TEST(WhyNotRun, EachRowIsJudgedFromWhereTheRowsAboveLeaveTheAxis) {
    Program program;
    program.points = {{"Home", {{kX, 0, true}}}, {"Away", {{kX, 1'000, true}}}};
    program.sequences = {{"Main", {action::MoveTo{"Home"}, action::MoveTo{"Away"}, action::MoveTo{"Home"}}}};
    std::vector<ModuleState> modules{homed(servoAt(0, 100), 100)};
    modules[0].backlash = {50, false};
    modules[0].travel.lowest = -50;
    EXPECT_THAT(whyNotRun("Main", 0, machineOf(program), modules), IsEmpty());
    modules[0].travel.lowest = -49;
    const auto problems = whyNotRun("Main", 0, machineOf(program), modules);
    ASSERT_EQ(kinds(problems), std::vector{SequenceFault::Refused});
    EXPECT_EQ(problems[0].refusal, Refusal::BeyondTravel);
    EXPECT_EQ(problems[0].row, 2U);
}

TEST(WhyNotRun, ASequenceMayFindTheHomeThatItsPointsCountFrom) {
    Program program = twoPoints();
    insertRow(program.sequences[0], 0, action::Home{kX});
    Machine machine = machineOf(program);
    machine.axes.resize(1);
    auto modules = chain();
    modules[0].home.forget();
    EXPECT_EQ(kinds(whyNotRun("Main", 0, machine, modules)), std::vector{SequenceFault::NoRecipe});
    HomingRecipe recipe;
    recipe.onLimit1 = true;
    recipe.velocity = recipe.acceleration = recipe.travelLimit = recipe.timeLimit = 1.0;
    machine.axes[0].homing = recipe;
    EXPECT_THAT(whyNotRun("Main", 0, machine, modules), IsEmpty());
}

TEST(WhyNotRun, RowsAboveTheFirstOneCountIfARepeatGoesBackToThem) {
    Program program = twoPoints();
    program.sequences[0].rows = {action::Home{kX}, action::MoveTo{"Pick"}, action::Repeat{0, 2}};
    const auto problems = whyNotRun("Main", 1, machineOf(program), chain());
    ASSERT_EQ(kinds(problems), std::vector{SequenceFault::NoRecipe});
    EXPECT_EQ(problems[0].row, 0U);
    program.sequences[0].rows.pop_back();
    EXPECT_THAT(whyNotRun("Main", 1, machineOf(program), chain()), IsEmpty());
}

TEST(WhyNotRun, PinsThatAreNotThere) {
    Program program;
    program.sequences = {{"Pins",
                          {action::WaitForInput{kX, InputPin::Limit1, true, 1},
                           action::WaitForInput{kX, InputPin::In1, true, 1}, action::SetOutput{kX, 1, true},
                           action::SetOutput{kX, 4, true}}}};
    EXPECT_EQ(kinds(whyNotRun("Pins", 0, machineOf(program), chain())),
              (std::vector{SequenceFault::NoSuchPin, SequenceFault::NotAnOutput, SequenceFault::NoSuchPin}))
        << "limit 1 is an input unless it is set as an output";
    auto found = chain();
    found[0].attached();
    EXPECT_THAT(kinds(whyNotRun("Pins", 0, machineOf(program), found)),
                testing::Contains(SequenceFault::OutputsUnknown));
    auto modules = chain();
    modules[0].io = servo::IoControl{false, false, false, true};
    EXPECT_EQ(kinds(whyNotRun("Pins", 0, machineOf(program), modules)),
              (std::vector{SequenceFault::NotAnInput, SequenceFault::NoSuchPin, SequenceFault::NoSuchPin}));
}

constexpr ModuleIndex kBox{0};

/// IO1 is high, IO12 low; A/D 2 reads 100. All pins except IO3 are inputs.
ModuleState picIo() {
    ModuleState module;
    module.info = {kBox, BusAddress(1), {ModuleType::Io, 1}};
    StatusReport report;
    report.pins = 0x0001;
    report.analogs = {0, 100, 255};
    module.latest = report;
    module.apply(bus::CommandExecuted{kBox, TimePoint{}, IoCommand(io::SetDirection{0x0FFB})});
    return module;
}

TEST(PicIoRows, PinsReadAsTheyAreAndOutputsAreNoInputs) {
    EXPECT_EQ(readPin(InputPin::Io1, picIo()), true);
    EXPECT_EQ(readPin(InputPin::Io12, picIo()), false);
    EXPECT_EQ(readPin(InputPin::Io3, picIo()), std::nullopt);
    EXPECT_EQ(readPin(InputPin::Limit1, picIo()), std::nullopt);
    EXPECT_EQ(readPin(InputPin::Io1, servoAt(0, 0)), std::nullopt);
}

TEST(PicIoRows, AnAnalogValueIsWaitedForOnItsSide) {
    using action::WaitForAnalog;
    EXPECT_TRUE(isMet(WaitForAnalog{kBox, 2, true, 99}, picIo()));
    EXPECT_FALSE(isMet(WaitForAnalog{kBox, 2, true, 100}, picIo())) << "above means more than";
    EXPECT_FALSE(isMet(WaitForAnalog{kBox, 2, false, 100}, picIo()));
    EXPECT_TRUE(isMet(WaitForAnalog{kBox, 2, false, 101}, picIo()));
    EXPECT_FALSE(isMet(WaitForAnalog{kBox, 1, true, 0}, picIo())) << "the other input";
}

TEST(PicIoRows, AnOutputIsToldWithTheOthersAsTheyAre) {
    const auto wanted = outputIntent({kBox, 3, true}, picIo());
    ASSERT_TRUE(wanted.has_value());
    const auto steps = plan(*wanted, picIo());
    ASSERT_TRUE(steps.has_value());
    EXPECT_EQ(std::get<IoCommand>((*steps)[0].command), IoCommand(io::SetOutput{0x0005}));
}

TEST(PicIoRows, WhatItDoesNotHaveIsSaidBeforeARun) {
    const auto problems = [](Action row, const ModuleState& module) {
        return kinds(whyNotRun("Main", 0, machineOf({{}, {{"Main", {std::move(row)}}}}), {module}));
    };
    EXPECT_THAT(problems(action::WaitForInput{kBox, InputPin::Io1}, picIo()), IsEmpty());
    EXPECT_THAT(problems(action::WaitForInput{kBox, InputPin::Io3}, picIo()),
                ElementsAre(SequenceFault::NotAnInput));
    EXPECT_THAT(problems(action::WaitForInput{kBox, InputPin::In1}, picIo()),
                ElementsAre(SequenceFault::NoSuchPin));
    EXPECT_THAT(problems(action::SetOutput{kBox, 3, true}, picIo()), IsEmpty());
    EXPECT_THAT(problems(action::SetOutput{kBox, 4, true}, picIo()), ElementsAre(SequenceFault::NotAnOutput));
    EXPECT_THAT(problems(action::WaitForAnalog{kBox, 1}, picIo()), IsEmpty());
    EXPECT_THAT(problems(action::WaitForAnalog{kX, 1}, servoAt(0, 0)), ElementsAre(SequenceFault::NoSuchPin));
    ModuleState found = picIo();
    found.attached();
    EXPECT_THAT(problems(action::SetOutput{kBox, 3, true}, found),
                ElementsAre(SequenceFault::OutputsUnknown));
}

TEST(EntryStates, AreWhatTheRowsAboveLeave) {
    Program program = twoPoints();
    program.sequences[0].rows = {action::MoveTo{"Pick"}, action::SetOutput{kY, 2, true}, action::Repeat{0, 5},
                                 action::MoveTo{"Place"}, action::SetOutput{kY, 2, false}};
    program.sequences.push_back({"Outer", {action::Call{"Main"}, action::Wait{1}}});
    const Machine machine = machineOf(program);
    const EntryState middle = entryState(machine, "Main", 3);
    EXPECT_EQ(middle.places.at(kX).point, "Pick");
    EXPECT_EQ(middle.places.at(kY).axis.counts, -200);
    EXPECT_TRUE(middle.outputs.at({kY, 2U}));
    const EntryState behind = entryState(machine, "Outer", 1);
    EXPECT_EQ(behind.places.at(kX).point, "Place");
    EXPECT_FALSE(behind.outputs.at({kY, 2U}));
    EXPECT_TRUE(behind.reached);
}

TEST(EntryStates, StartInTheMiddleOnlyWhereAFreshRunWouldBe) {
    const Machine machine = machineOf(twoPoints());
    auto modules = chain();  // X is 200 from home, Pick is 1 000
    const auto problems = whyNotRun("Main", 1, machine, modules);
    ASSERT_EQ(kinds(problems), (std::vector{SequenceFault::NotThere, SequenceFault::NotThere}));
    EXPECT_EQ(problems[0].module, kX);
    EXPECT_EQ(problems[0].name, "Pick");
    modules = {homed(servoAt(0, 1'102), 100), homed(servoAt(1, -200), 0)};
    EXPECT_THAT(whyNotRun("Main", 1, machine, modules), IsEmpty()) << "a servo rests within its friction";
    Machine elsewhere = machine;
    elsewhere.program.points[0].axes[0] = {kX, 1'102, false};
    EXPECT_EQ(kinds(whyNotRun("Main", 1, elsewhere, modules)), std::vector{SequenceFault::TaughtElsewhere})
        << "the counter says 1 102, but where that is has changed since";
    Machine forEver = machine;
    insertRow(forEver.program.sequences[0], 1, action::Repeat{0, 0});
    EXPECT_EQ(kinds(whyNotRun("Main", 2, forEver, modules)), std::vector{SequenceFault::Unreachable});
    modules[0].latest->position = 1'100 - 0x7FFFFFFF - 1;
    EXPECT_THAT(kinds(whyNotRun("Main", 1, machine, modules)), testing::Contains(SequenceFault::NotThere))
        << "nowhere is farther away, and 32 bits have no positive number for it";
}

TEST(EntryStates, TheLastCallIsTheOneThatCounts) {
    Program program = twoPoints();
    program.sequences = {{"Fetch", {action::MoveTo{"Pick"}, action::SetOutput{kY, 1, true}}},
                         {"Main",
                          {action::Call{"Fetch"}, action::MoveTo{"Place"}, action::SetOutput{kY, 1, false},
                           action::Call{"Fetch"}, action::Wait{1}}}};
    const EntryState before = entryState(machineOf(program), "Main", 3);
    EXPECT_EQ(before.places.at(kX).point, "Place");
    EXPECT_EQ(before.places.at(kY).point, "Pick");
    EXPECT_FALSE(before.outputs.at({kY, 1U}));
    const EntryState behind = entryState(machineOf(program), "Main", 4);
    EXPECT_EQ(behind.places.at(kX).point, "Pick");
    EXPECT_TRUE(behind.outputs.at({kY, 1U}));
}

/// Without a move to home, the axis stops wherever its switch was found, and is no longer where a row above
/// had moved it.
TEST(EntryStates, ASearchForHomeLeavesItsAxisAnywhere) {
    Program program = twoPoints();
    program.sequences = {{"Search", {action::Home{kX}}},
                         {"Direct", {action::MoveTo{"Pick"}, action::Home{kX}, action::Wait{1}}},
                         {"Called", {action::MoveTo{"Pick"}, action::Call{"Search"}, action::Wait{1}}}};
    Machine machine = machineOf(program);
    machine.axes.resize(1);
    HomingRecipe recipe;
    recipe.goToHome = false;
    machine.axes[0].homing = recipe;
    for (const char* sequence : {"Direct", "Called"}) {
        const EntryState entry = entryState(machine, sequence, 2);
        EXPECT_FALSE(entry.places.contains(kX)) << sequence;
        EXPECT_EQ(entry.places.at(kY).point, "Pick") << sequence;
        EXPECT_THAT(entry.homed, ElementsAre(kX)) << sequence;
    }
    machine.axes[0].homing->goToHome = true;
    EXPECT_EQ(entryState(machine, "Called", 2).places.at(kX), (EntryState::Place{"", {kX, 0, true}}));
}

/// A tree of calls that would take longer than the universe to go through.
TEST(EntryStates, DoNotGoThroughACallTwice) {
    Program program;
    for (int i = 0; i < 50; ++i) {
        const Action next = i == 49 ? Action(action::Wait{1}) : Action(action::Call{std::to_string(i + 1)});
        program.sequences.push_back({std::to_string(i), {next, next}});
    }
    EXPECT_FALSE(contradiction(program));
    EXPECT_TRUE(entryState(machineOf(program), "0", 2).reached);
    EXPECT_THAT(modulesOf(program, "0"), IsEmpty());
}

}  // namespace
}  // namespace nmc
