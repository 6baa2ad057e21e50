// SPDX-License-Identifier: GPL-3.0-or-later
// H-12, F-39, F-40: the changes that opening a file would make; nothing is changed or sent that was not
// chosen.
#include "model/machinefile/machinecompare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/model/anymachine.h"
#include "tests/model/machines.h"
#include "tests/support/modules.h"

namespace nmc {

inline void PrintTo(const PartId& id, std::ostream* out) {
    *out << (id.module ? id.module->value() + 1 : 0) << '/' << static_cast<int>(id.part);
}

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing_support::ids;
using testing_support::kFirst;
using testing_support::kSecond;
using testing_support::mill;

ModuleState moduleOf(std::uint8_t index, ModuleType type, std::uint8_t version, bool on = false) {
    ModuleState module;
    module.info = {ModuleIndex(index), BusAddress(static_cast<std::uint8_t>(index + 1)), {type, version}};
    StatusReport report;
    report.status = 0x09;  // power, move done
    report.position = 0;
    report.aux = static_cast<std::uint8_t>(on ? 0x04 : 0x00);
    module.latest = report;
    return module;
}
/// The chain that mill() is for.
std::vector<ModuleState> millChain() {
    return {moduleOf(0, ModuleType::Servo, 4), moduleOf(1, ModuleType::Stepper, 1)};
}

const Difference* row(const std::vector<Difference>& rows, PartId id) {
    for (const Difference& difference : rows)
        if (difference.id == id)
            return &difference;
    return nullptr;
}
/// True if anything is sent to this module.
bool goesTo(ModuleIndex module, const std::vector<ModuleIntent>& sent) {
    return std::any_of(sent.begin(), sent.end(),
                       [module](const ModuleIntent& s) { return s.module == module; });
}
std::vector<PartId> all(const std::vector<Difference>& rows) {
    return ids(rows);
}

TEST(MachineCompare, WithoutModulesEqualMachinesDoNotDiffer) {
    EXPECT_THAT(compare(mill(), mill(), {}), IsEmpty());
}

TEST(MachineCompare, NamesTheFieldsThatDifferAndNoOthers) {
    Machine now = mill();
    now.axes[0].gains->kp = 150;
    now.axes[0].gains->db.reset();
    now.axes[1].name = "Table";
    const auto rows = compare(mill(), now, {});
    ASSERT_THAT(ids(rows),
                ElementsAre(PartId{kFirst, MachinePart::Gains}, PartId{kSecond, MachinePart::AxisName}));
    ASSERT_EQ(rows[0].fields.size(), 2U);
    EXPECT_EQ(rows[0].fields[0].key, "Kp");
    EXPECT_EQ(rows[0].fields[0].file, FieldValue(200.0));
    EXPECT_EQ(rows[0].fields[0].now, FieldValue(150.0));
    EXPECT_EQ(rows[0].fields[1].key, "DB");
    EXPECT_EQ(rows[0].fields[1].now, std::nullopt);
    EXPECT_EQ(rows[0].applying, Applying::KeepsUnsent) << "there is no module to send it to";
    EXPECT_EQ(rows[1].fields[0].file, FieldValue(std::string("Drehteller ä")));
    EXPECT_EQ(rows[1].applying, Applying::ChangesPanel);
}

/// Key, quantity and file's value of each field of the row, in the order of the table.
std::vector<std::tuple<std::string, Quantity, FieldValue>> shown(const Difference* row) {
    std::vector<std::tuple<std::string, Quantity, FieldValue>> fields;
    if (row != nullptr)
        for (const FieldDifference& field : row->fields)
            fields.emplace_back(field.key, field.quantity, field.file.value_or("–"));
    return fields;
}

/// 0 means that a field was never set, except for places and gains.
TEST(MachineCompare, AFieldsQuantityTellsItsUnitAndItsKeyDoesNot) {
    using testing::FieldsAre;
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper}) {
        Machine file;
        AxisSettings& axis = file.axes.emplace_back();
        axis.expected = ModuleIdentity{type, 1};
        axis.unit = {UnitKind::Turns, 2'000.0, ""};
        axis.motion = {8.0, 0.02, 0.0, 0.0, 0.0, 1'000.0};
        axis.travel = {-5, 0, 4.0};
        axis.workOffsets = {{"A", 0}};
        axis.homing.emplace().timeLimit = 30.0;
        axis.gains = servo::SetGain{200, 2'000, 0, 200, 255, 0, 8'000, 1, std::nullopt, std::nullopt};
        const auto rows = compare(file, {}, {});
        const auto fields = [&rows](MachinePart part) { return shown(row(rows, {kFirst, part})); };
        EXPECT_THAT(fields(MachinePart::Unit),
                    ElementsAre(FieldsAre("kind", Quantity::Plain, FieldValue("turns")),
                                FieldsAre("counts_per_unit", Quantity::Plain, FieldValue(2'000.0))));
        EXPECT_THAT(fields(MachinePart::Motion),
                    ElementsAre(FieldsAre("velocity", Quantity::Velocity, FieldValue(8.0)),
                                FieldsAre("acceleration", Quantity::Acceleration, FieldValue(0.02)),
                                FieldsAre("step", Quantity::Distance, FieldValue(1'000.0))));
        EXPECT_THAT(fields(MachinePart::Travel),
                    ElementsAre(FieldsAre("lowest", Quantity::Place, FieldValue(-5.0)),
                                FieldsAre("highest", Quantity::Place, FieldValue(0.0)),
                                FieldsAre("fastest", Quantity::Velocity, FieldValue(4.0))));
        EXPECT_THAT(fields(MachinePart::WorkOffsets),
                    ElementsAre(FieldsAre("offset A", Quantity::Place, FieldValue(0.0))));
        EXPECT_THAT(fields(MachinePart::Homing),
                    testing::Contains(FieldsAre("time_limit", Quantity::Seconds, FieldValue(30.0))));
        EXPECT_THAT(fields(MachinePart::Gains),
                    testing::IsSupersetOf({FieldsAre("Ki", Quantity::Plain, FieldValue(0.0)),
                                           FieldsAre("EL_counts", Quantity::Plain, FieldValue(8'000.0))}));
    }
}

TEST(MachineCompare, TheChipOfAnAxisIsNoDifferenceOfItsNumbers) {
    Machine stepper;
    stepper.axes.emplace_back().motion = {8.0, 0.02, 4.0, 0.5, 2.0, 1000.0};
    Machine servo = stepper;
    stepper.axes[0].expected = ModuleIdentity{ModuleType::Stepper, 1};
    servo.axes[0].expected = ModuleIdentity{ModuleType::Servo, 5};
    EXPECT_THAT(ids(compare(stepper, servo, {})), ElementsAre(PartId{kFirst, MachinePart::Hardware}));
}

TEST(MachineCompare, GroupsPointsAndSequencesAreEachOneText) {
    using testing::FieldsAre;
    Machine file = testing_support::taughtMill();
    file.program.points.push_back({"Nowhere", {}});
    const auto rows = compare(file, {}, {});
    EXPECT_THAT(shown(row(rows, {{}, MachinePart::Groups})),
                ElementsAre(FieldsAre("group129", Quantity::Plain, FieldValue("Table: 1, 2")),
                            FieldsAre("leader129", Quantity::Plain, FieldValue(2.0))));
    EXPECT_THAT(
        shown(row(rows, {{}, MachinePart::Program})),
        ElementsAre(
            FieldsAre("point Pick ä", Quantity::Plain,
                      FieldValue("module 1, counts -1500, from_home yes; module 2, counts 40, from_home no")),
            FieldsAre("point Place", Quantity::Plain,
                      FieldValue("module 1, counts 2147483647, from_home yes")),
            FieldsAre("point Nowhere", Quantity::Plain, FieldValue("-")),
            FieldsAre("sequence Main", Quantity::Plain,
                      FieldValue("home, module 1; "
                                 "move to, point Pick ä, together no, waits yes, percent 100; "
                                 "set output, module 2, output 5, on yes; wait, seconds 0.25; "
                                 "wait for input, module 2, input home switch, active no, timeout_s 3.5; "
                                 "move to, point Place, together yes, waits no, percent 7; "
                                 "wait for arrival; repeat, from_row 2, times 0")),
            FieldsAre("sequence Twice", Quantity::Plain,
                      FieldValue("call, sequence Main; repeat, from_row 1, times 2"))));
    EXPECT_THAT(shown(row(rows, {{}, MachinePart::HomeOrder})),
                ElementsAre(FieldsAre("home_order", Quantity::Plain, FieldValue("2, 1"))));
}

TEST(MachineCompare, PinsThatWereSetAreNamedOneByOne) {
    Machine file;
    file.axes.resize(1);
    file.axes[0].pins.emplace();
    PinSettings::in(file.axes[0].pins->pins, 2) = {"Lamp", true, false};
    PinSettings::in(file.axes[0].pins->analog, 1).name = "Pressure";
    const auto rows = compare(file, Machine{}, {});
    ASSERT_THAT(ids(rows), ElementsAre(PartId{kFirst, MachinePart::PinNames}));
    ASSERT_EQ(rows[0].fields.size(), 2U);
    EXPECT_EQ(rows[0].fields[0].key, "IO3");
    EXPECT_EQ(rows[0].fields[0].file, FieldValue(std::string("name Lamp, asks yes, off_at_stop no")));
    EXPECT_FALSE(rows[0].fields[0].now) << "it was never set";
    EXPECT_EQ(rows[0].fields[1].key, "AD2");
    EXPECT_EQ(rows[0].fields[1].file, FieldValue(std::string("Pressure")));
    EXPECT_EQ(applied(file, Machine{}, {}, ids(rows)), file);
}

TEST(MachineCompare, TheScaleOfAnInputIsAFieldOfItsOwn) {
    Machine file;
    PinSettings::in(file.axes.emplace_back().pins.emplace().analog, 1).scale = {0.5, 1.0, "bar"};
    EXPECT_THAT(shown(row(compare(file, {}, {}), {kFirst, MachinePart::PinNames})),
                ElementsAre(testing::FieldsAre("AD2 scale", Quantity::Plain,
                                               FieldValue("per_count 0.5, at_zero 1, unit bar"))));
}

TEST(MachineCompare, GroupsAreSentIfAModuleIsInAnother) {
    const PartId groups{{}, MachinePart::Groups};
    auto modules = millChain();
    EXPECT_EQ(row(compare(mill(), {}, modules), groups)->applying, Applying::Sends) << "nobody knows where";
    EXPECT_THAT(sendings(mill(), {}, modules, {groups}), IsEmpty()) << "no command to one module";
    modules[0].info.group = bus::GroupPlace{0x81, false};
    modules[1].info.group = bus::GroupPlace{0x81, true};
    EXPECT_EQ(row(compare(mill(), {}, modules), groups)->applying, Applying::ChangesPanel);
    EXPECT_EQ(row(compare(mill(), {}, {}), groups)->applying, Applying::ChangesPanel);
}

TEST(MachineCompare, GroupsThatTheModulesHaveLostAreOfferedAgain) {
    using testing::FieldsAre;
    const PartId groups{{}, MachinePart::Groups};
    auto modules = millChain();
    for (ModuleState& module : modules)
        module.info.group = bus::GroupPlace{};  // as after a restart
    const auto rows = compare(mill(), mill(), modules);
    ASSERT_NE(row(rows, groups), nullptr);
    EXPECT_EQ(row(rows, groups)->applying, Applying::Sends);
    EXPECT_THAT(shown(row(rows, groups)),
                ElementsAre(FieldsAre("group129", Quantity::Plain, FieldValue("Table: 1, 2")),
                            FieldsAre("leader129", Quantity::Plain, FieldValue(2.0))));
    modules[0].info.group = bus::GroupPlace{0x81, false};
    modules[1].info.group = bus::GroupPlace{0x81, true};
    EXPECT_EQ(row(compare(mill(), mill(), modules), groups), nullptr);
    EXPECT_EQ(row(compare(mill(), mill(), {}), groups), nullptr);
}

TEST(MachineCompare, PointsAndSequencesGoTogether) {
    Machine now = testing_support::taughtMill();
    std::get<action::Wait>(now.program.sequences[0].rows[3]).seconds = 0.5;
    now.homeOrder.clear();
    const auto rows = compare(testing_support::taughtMill(), now, {});
    ASSERT_THAT(ids(rows), ElementsAre(PartId{{}, MachinePart::Program}, PartId{{}, MachinePart::HomeOrder}));
    ASSERT_EQ(rows[0].fields.size(), 1U) << "the rest is the same";
    EXPECT_EQ(rows[0].fields[0].key, "sequence Main");
    const Machine taken = applied(testing_support::taughtMill(), now, {}, {{{}, MachinePart::Program}});
    EXPECT_EQ(taken.program, testing_support::taughtMill().program);
    EXPECT_TRUE(taken.homeOrder.empty());
}

TEST(MachineCompare, GainsAreComparedWithWhatWasSentNotWithWhatWasTyped) {
    auto modules = millChain();
    const PartId gains{kFirst, MachinePart::Gains};
    {
        const auto rows = compare(mill(), mill(), modules);
        ASSERT_NE(row(rows, gains), nullptr) << "entered, but never sent in this connection";
        EXPECT_EQ(row(rows, gains)->applying, Applying::Sends);
        EXPECT_EQ(row(rows, gains)->fields.size(), 9U);
        EXPECT_EQ(row(rows, gains)->fields[0].now, std::nullopt) << "unknown";
    }
    modules[0].gains = mill().axes[0].gains;
    EXPECT_EQ(row(compare(mill(), mill(), modules), gains), nullptr);
    modules[0].gains->kp = 7;
    EXPECT_EQ(row(compare(mill(), mill(), modules), gains)->fields[0].now, FieldValue(7.0));
    modules[0].gains = mill().axes[0].gains;
    EXPECT_EQ(row(compare(mill(), {}, modules), gains)->applying, Applying::ChangesPanel)
        << "the module has them, the fields do not";
}

TEST(MachineCompare, AnOldServoHasNoDeadbandToDiffer) {
    Machine file = mill();
    file.axes.resize(1);
    file.axes[0].expected = ModuleIdentity{ModuleType::Servo, 3};
    auto module = moduleOf(0, ModuleType::Servo, 3);
    module.gains = file.axes[0].gains;
    module.gains->db.reset();
    module.io = file.axes[0].io;
    EXPECT_EQ(row(compare(file, file, {module}), {kFirst, MachinePart::Gains}), nullptr);
}

/// An SC with these gains and a known I/O Control: 3-phase.
ModuleState scWith(const servo::SetGain& gains, bool fastPath) {
    ModuleState module = moduleOf(0, ModuleType::Servo, 10);
    module.gains = gains;
    module.scIo = servo::ScIoControl{.threePhase = true, .fastPath = fastPath};
    return module;
}
Machine scMachine(std::optional<std::uint8_t> multiplier, std::optional<bool> fastPath) {
    Machine file;
    file.axes.resize(1);
    file.axes[0].expected = ModuleIdentity{ModuleType::Servo, 10};
    file.axes[0].gains = servo::SetGain{100, 1'000, 0, 0, 255, 0, 2'000, 1, std::uint8_t{0}, multiplier};
    file.axes[0].fastPath = fastPath;
    return file;
}

TEST(MachineCompare, TheStepMultiplierOfAnScIsComparedAndSent) {
    const Machine file = scMachine(std::uint8_t{5}, {});
    const PartId gains{kFirst, MachinePart::Gains};
    const ModuleState module = scWith(*scMachine(std::uint8_t{2}, {}).axes[0].gains, false);
    const auto rows = compare(file, file, {module});
    ASSERT_NE(row(rows, gains), nullptr);
    ASSERT_EQ(row(rows, gains)->fields.size(), 1U);
    EXPECT_EQ(row(rows, gains)->fields[0].key, "SM");
    EXPECT_EQ(row(rows, gains)->fields[0].now, FieldValue(2.0));
    const auto sent = sendings(file, file, {module}, {gains});
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(std::get<intent::ApplyGains>(sent[0].intent).gains.sm, 5);
}

TEST(MachineCompare, AFileWithoutAStepMultiplierLeavesItAsItIs) {
    const Machine file = scMachine({}, {});
    const ModuleState module = scWith(*scMachine(std::uint8_t{2}, {}).axes[0].gains, false);
    EXPECT_EQ(row(compare(file, file, {module}), {kFirst, MachinePart::Gains}), nullptr);
}

/// Each I/O Control command applies every bit, so the other bits are sent as the module has them.
TEST(MachineCompare, FastPathOfAnScGoesWithTheRestOfItsAmplifierAsItIs) {
    const Machine file = scMachine({}, true);
    const PartId io{kFirst, MachinePart::Io};
    const ModuleState module = scWith(*file.axes[0].gains, false);
    const auto rows = compare(file, file, {module});
    ASSERT_NE(row(rows, io), nullptr);
    EXPECT_EQ(row(rows, io)->applying, Applying::Sends);
    const auto sent = sendings(file, file, {module}, {io});
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(std::get<intent::ControlSc>(sent[0].intent).io,
              (servo::ScIoControl{.threePhase = true, .fastPath = true}));
    EXPECT_EQ(row(compare(file, file, {scWith(*file.axes[0].gains, true)}), io), nullptr)
        << "the module already has it";
}

TEST(MachineCompare, FastPathOfAnScWaitsWhileItsAmplifierIsNotKnown) {
    const Machine file = scMachine({}, true);
    const PartId io{kFirst, MachinePart::Io};
    ModuleState module = scWith(*file.axes[0].gains, false);
    module.scIo.reset();
    const auto rows = compare(file, {}, {module});
    ASSERT_NE(row(rows, io), nullptr);
    EXPECT_EQ(row(rows, io)->applying, Applying::KeepsUnsent);
    EXPECT_THAT(sendings(file, {}, {module}, all(rows)),
                testing::Each(testing::Field(&ModuleIntent::intent,
                                             testing::VariantWith<intent::ApplyGains>(testing::_))));
    EXPECT_EQ(applied(file, {}, {module}, all(rows)).axes[0].fastPath, true);
}

TEST(MachineCompare, NothingIsTickedThatIsSentToAServoThatIsOn) {
    auto modules = millChain();
    modules[0] = moduleOf(0, ModuleType::Servo, 4, true);
    const auto rows = compare(mill(), {}, modules);
    EXPECT_FALSE(row(rows, {kFirst, MachinePart::Gains})->wanted);
    EXPECT_FALSE(row(rows, {kFirst, MachinePart::Io})->wanted);
    EXPECT_TRUE(row(rows, {kFirst, MachinePart::AxisName})->wanted);
}

TEST(MachineCompare, WhatWasShownHoldsUntilItWouldBeSentOtherwise) {
    auto modules = millChain();
    const PartId gains{kFirst, MachinePart::Gains};
    const auto shown = compare(mill(), {}, modules);
    const auto stillHolds = [&](const std::vector<PartId>& chosen) {
        return stillHold(shown, compare(mill(), {}, modules), chosen);
    };
    EXPECT_TRUE(stillHolds(all(shown)));
    modules[0] = moduleOf(0, ModuleType::Servo, 4, true);
    EXPECT_FALSE(stillHolds({gains})) << "its motor is on";
    EXPECT_TRUE(stillHolds({{kFirst, MachinePart::AxisName}}));
    modules = millChain();
    modules[0].silent = true;
    EXPECT_FALSE(stillHolds({gains})) << "it would not get them";
    modules[0] = millChain()[0];
    modules[0].gains = mill().axes[0].gains;
    EXPECT_FALSE(stillHolds({gains})) << "it has them already";
}

TEST(MachineCompare, ASilentModuleIsSentNothingAndSaysWhy) {
    auto modules = millChain();
    modules[0].silent = true;
    const auto rows = compare(mill(), {}, modules);
    EXPECT_EQ(row(rows, {kFirst, MachinePart::Gains})->applying, Applying::KeepsUnsent);
    EXPECT_EQ(row(rows, {kFirst, MachinePart::Gains})->refusal, Refusal::Unresponsive);
    EXPECT_FALSE(goesTo(kFirst, sendings(mill(), {}, modules, all(rows))));
}

TEST(MachineCompare, AStepperIsSentItsParametersAndNothingOfAServo) {
    const auto modules = millChain();
    const PartId parameters{kSecond, MachinePart::Parameters};
    const auto rows = compare(mill(), mill(), modules);
    ASSERT_NE(row(rows, parameters), nullptr) << "never sent in this connection";
    EXPECT_EQ(row(rows, parameters)->applying, Applying::Sends);
    const auto sent = sendings(mill(), mill(), modules, {parameters});
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].module, kSecond);
    EXPECT_EQ(std::get<stepperintent::SetParameters>(sent[0].intent).parameters, *mill().axes[1].parameters);

    Machine gainsForAStepper = mill();
    gainsForAStepper.axes[1].expected.reset();
    gainsForAStepper.axes[1].gains = mill().axes[0].gains;
    EXPECT_THAT(sendings(gainsForAStepper, {}, modules, {{kSecond, MachinePart::Gains}}), IsEmpty());
}

// ---- other hardware ----

TEST(MachineCompare, AnAxisForAnotherTypeOrVersionCannotBeApplied) {
    for (const ModuleState& other : {moduleOf(0, ModuleType::Stepper, 4), moduleOf(0, ModuleType::Servo, 3),
                                     moduleOf(0, ModuleType(7), 4)}) {
        auto modules = millChain();
        modules[0] = other;
        const auto rows = compare(mill(), {}, modules);
        const Difference* hardware = row(rows, {kFirst, MachinePart::Hardware});
        ASSERT_NE(hardware, nullptr);
        EXPECT_EQ(hardware->applying, Applying::OtherHardware);
        EXPECT_FALSE(hardware->possible());
        EXPECT_EQ(hardware->fields[0].file, FieldValue(std::string("PIC-SERVO v4")));
        for (const Difference& difference : rows)
            EXPECT_TRUE(difference.id.module != kFirst || &difference == hardware);
        std::vector<PartId> chosen = all(rows);
        chosen.push_back({kFirst, MachinePart::Gains});
        chosen.push_back({kFirst, MachinePart::AxisName});
        const Machine machine = applied(mill(), {}, modules, chosen);
        EXPECT_EQ(machine.axes[0], AxisSettings{}) << "whatever was chosen";
        EXPECT_EQ(machine.axes[1], mill().axes[1]);
        EXPECT_FALSE(goesTo(kFirst, sendings(mill(), {}, modules, chosen)));
    }
}

/// The axis of the file is for a PIC-SERVO; so far, it was for a PIC-STEP.
TEST(MachineCompare, NoNumberOfOneTypeOfModuleIsJoinedWithThoseOfAnother) {
    const Machine file = testing_support::taughtMill();
    Machine now;
    AxisSettings& axis = now.axes.emplace_back();
    axis.name = "Table";
    axis.expected = ModuleIdentity{ModuleType::Stepper, 1};
    axis.motion.velocity = 2'000;
    axis.travel.fastest = 3'000;
    now.program.points = {{"Pick", {{kFirst, 30'000, false}, {kSecond, 7, false}}}};
    const auto rows = compare(file, now, {});
    const PartId hardware{kFirst, MachinePart::Hardware};
    ASSERT_NE(row(rows, hardware), nullptr);
    EXPECT_TRUE(row(rows, hardware)->possible());
    EXPECT_EQ(row(rows, hardware)->fields[0].file, FieldValue(std::string("PIC-SERVO v4")));
    EXPECT_EQ(row(rows, hardware)->fields[0].now, FieldValue(std::string("PIC-STEP v1")));
    EXPECT_EQ(applied(file, now, {}, {}).axes[0], now.axes[0]) << "not even its type";

    const Machine some = applied(file, now, {}, {{kFirst, MachinePart::Unit}});
    AxisSettings expected;
    expected.name = "Table";
    expected.expected = file.axes[0].expected;
    expected.unit = file.axes[0].unit;
    EXPECT_EQ(some.axes[0], expected);
    EXPECT_EQ(some.program.points[0].axes, (std::vector<PointAxis>{{kSecond, 7, false}}))
        << "30 000 steps are no place of a servo";
    EXPECT_EQ(applied(file, now, {}, all(rows)), file);

    const Machine taught = applied(file, now, {}, {{{}, MachinePart::Program}});
    EXPECT_EQ(taught.axes[0], now.axes[0]);
    for (const Point& point : taught.program.points)
        for (const PointAxis& place : point.axes)
            EXPECT_NE(place.module, kFirst) << "nor is a place of a servo one of a stepper";
}

TEST(MachineCompare, NumbersOfWhichAFileNamesNoTypeDoNotTakeItFromOthers) {
    Machine file;
    file.axes.resize(1);
    file.axes[0].unit = {UnitKind::Turns, 2'000.0, {}};
    Machine now;
    now.axes.emplace_back().expected = ModuleIdentity{ModuleType::Stepper, 1};
    now.axes[0].motion.velocity = 2'000;
    const PartId unit{kFirst, MachinePart::Unit};
    EXPECT_EQ(applied(file, now, {}, {unit}).axes[0].expected, now.axes[0].expected);
    EXPECT_EQ(applied(file, now, {}, all(compare(file, now, {}))), file);
}

TEST(MachineCompare, MoreAxesThanModulesAreKeptAndFewerLeaveTheOthersAlone) {
    auto modules = millChain();
    modules.pop_back();
    const auto rows = compare(mill(), {}, modules);
    EXPECT_EQ(row(rows, {kSecond, MachinePart::Hardware})->applying, Applying::NotThere);
    EXPECT_EQ(applied(mill(), {}, modules, all(rows)).axes[1], mill().axes[1]);

    Machine shorter = mill();
    shorter.axes.resize(1);
    shorter.groups.clear();
    const auto fewer = compare(shorter, mill(), millChain());
    EXPECT_EQ(row(fewer, {kSecond, MachinePart::Hardware})->applying, Applying::NotInFile);
    EXPECT_EQ(applied(shorter, mill(), millChain(), all(fewer)).axes[1], mill().axes[1]);
}

// ---- applying ----

TEST(MachineCompare, ApplyingEverythingWithoutModulesMakesItTheFilesMachine) {
    EXPECT_TRUE(rc::check([] {
        const Machine file = testing_support::anyMachine();
        const Machine now = testing_support::anyMachine();
        RC_ASSERT(applied(file, now, {}, all(compare(file, now, {}))) == file);
        RC_ASSERT(compare(file, file, {}).empty());
    }));
}

TEST(MachineCompare, ApplyingNothingChangesNoValueAndSendsNothing) {
    EXPECT_TRUE(rc::check([] {
        const Machine file = testing_support::anyMachine();
        Machine now = testing_support::anyMachine();
        const auto modules = millChain();
        RC_ASSERT(sendings(file, now, modules, {}).empty());
        Machine after = applied(file, now, modules, {});
        // Only the expected modules are taken over, and of those no other type.
        for (std::size_t i = 0; i < std::min(now.axes.size(), after.axes.size()); ++i)
            if (now.axes[i].expected && after.axes[i].expected)
                RC_ASSERT(now.axes[i].expected->type == after.axes[i].expected->type);
        for (AxisSettings& axis : after.axes)
            axis.expected.reset();
        for (AxisSettings& axis : now.axes)
            axis.expected.reset();
        after.axes.resize(8);
        now.axes.resize(8);
        RC_ASSERT(after == now);
    }));
}

TEST(MachineCompare, OnlyTheChosenPartsAreTakenAndSent) {
    const auto modules = millChain();
    const std::vector<PartId> chosen{{kFirst, MachinePart::Gains}, {kFirst, MachinePart::Unit}};
    const Machine machine = applied(mill(), {}, modules, chosen);
    EXPECT_EQ(machine.axes[0].gains, mill().axes[0].gains);
    EXPECT_EQ(machine.axes[0].unit, mill().axes[0].unit);
    EXPECT_EQ(machine.axes[0].name, "");
    EXPECT_EQ(machine.axes[0].io, std::nullopt);
    EXPECT_EQ(machine.baud, 0U);
    const auto sent = sendings(mill(), {}, modules, chosen);
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].module, kFirst);
    EXPECT_EQ(std::get<intent::ApplyGains>(sent[0].intent).gains, *mill().axes[0].gains);
}

TEST(MachineCompare, NothingThatIsSentMovesOrEnables) {
    EXPECT_TRUE(rc::check([] {
        const Machine file = testing_support::anyMachine();
        auto modules = millChain();
        for (std::uint8_t i = 2; i < 6; ++i)
            modules.push_back(moduleOf(i, ModuleType::Servo, i, testing_support::coin()));
        for (const ModuleIntent& sent : sendings(file, {}, modules, all(compare(file, {}, modules))))
            RC_ASSERT(std::holds_alternative<intent::ApplyGains>(sent.intent) ||
                      std::holds_alternative<intent::ControlIo>(sent.intent) ||
                      std::holds_alternative<stepperintent::SetParameters>(sent.intent));
    }));
}

TEST(MachineCompare, WhatIsSavedSaysWhichModulesItIsFor) {
    Machine machine;
    machine.axes.resize(1);
    machine.axes[0].expected = ModuleIdentity{ModuleType::Servo, 2};
    const Machine saved = withChain(machine, millChain(), 57'600);
    ASSERT_EQ(saved.axes.size(), 2U);
    EXPECT_EQ(saved.axes[0].expected, (ModuleIdentity{ModuleType::Servo, 2})) << "as it was set before";
    EXPECT_EQ(saved.axes[1].expected, (ModuleIdentity{ModuleType::Stepper, 1}));
    EXPECT_EQ(saved.baud, 57'600U);
    EXPECT_EQ(withChain({}, {}, 19'200), Machine{});
    auto lent = millChain();
    lent[1].info.identity = kUnheardModule;
    EXPECT_EQ(withChain(machine, lent, 57'600).axes[1].expected, std::nullopt) << "its type was not heard";
}

}  // namespace
}  // namespace nmc
