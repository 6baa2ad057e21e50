// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that are sent to a PIC-I/O for each intent. Bit 0 is IO1.
#include "model/intent/intent.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

class PicIo : public testing::Test {
protected:
    PicIo() {
        module.info = {ModuleIndex(1), BusAddress(2), {ModuleType::Io, 1}};
        report.items = StatusItems(StatusItems::Pins);
        report.pins = 0x0801;  // IO1 and IO12 are high
        module.latest = report;
    }
    void executed(const IoCommand& command) {
        module.apply(bus::CommandExecuted{ModuleIndex(1), TimePoint{}, command});
    }
    [[nodiscard]] std::vector<IoCommand> planned(const Intent& intent) {
        const auto steps = plan(intent, module);
        EXPECT_TRUE(steps.has_value()) << (steps ? -1 : static_cast<int>(steps.error()));
        std::vector<IoCommand> commands;
        for (const bus::Order& step : steps.value_or(std::vector<bus::Order>{}))
            commands.push_back(std::get<IoCommand>(step.command));
        return commands;
    }
    [[nodiscard]] std::optional<Refusal> refused(const Intent& intent) {
        const auto steps = plan(intent, module);
        return steps ? std::nullopt : std::optional(steps.error());
    }
    using Commands = std::vector<IoCommand>;

    ModuleState module;
    StatusReport report;
};

TEST_F(PicIo, OneOutputChangesAndTheOthersStayAsTheyWereTold) {
    executed(io::SetDirection{0x0FF0});
    executed(io::SetOutput{0x0003});
    EXPECT_EQ(planned(iointent::SetOutput{2, true}), Commands{io::SetOutput{0x0007}});
    EXPECT_EQ(planned(iointent::SetOutput{0, false}), Commands{io::SetOutput{0x0002}});
}

TEST_F(PicIo, AsLongAsNothingWasToldTheLevelsThatItReadsAreKept) {
    EXPECT_EQ(planned(iointent::SetOutput{2, true}), Commands{io::SetOutput{0x0805}});
    module.latest.reset();
    EXPECT_EQ(refused(iointent::SetOutput{2, true}), Refusal::Unresponsive);
}

/// It is not documented whether the chip keeps a level that is set while the pin is an input. Sent before and
/// after, the new output has its level at once in either case.
TEST_F(PicIo, APinThatBecomesAnOutputIsToldItsLevelBeforeAndAfter) {
    EXPECT_EQ(planned(iointent::SetDirection{0x0FFE}),
              (Commands{io::SetOutput{0x0801}, io::SetDirection{0x0FFE}, io::SetOutput{0x0801}}));
}

TEST_F(PicIo, OnePwmOutputChangesAndTheOtherStays) {
    EXPECT_EQ(planned(iointent::SetPwm{1, 200}), Commands{(io::SetPwm{0, 200})});
    executed(io::SetPwm{10, 200});
    EXPECT_EQ(planned(iointent::SetPwm{0, 0}), Commands{(io::SetPwm{0, 200})});
    EXPECT_EQ(planned(iointent::SetPwm{0, 0, std::uint8_t{9}}), Commands{(io::SetPwm{0, 200})});
    module.attached();
    EXPECT_EQ(planned(iointent::SetPwm{0, 5, std::uint8_t{9}}), Commands{(io::SetPwm{5, 9})});
}

TEST_F(PicIo, WhatIsLatchedIsRead) {
    EXPECT_EQ(planned(iointent::SynchInput{}), (Commands{io::SynchInput{}, ReadStatus{StatusItems(0xC0)}}));
}

TEST_F(PicIo, WhatWasStoredIsWhatItPutsOut) {
    executed(io::SetSynchOutput{0x0010, 1, 2});
    EXPECT_EQ(module.pins.outputs, std::nullopt);
    executed(io::SynchOutput{});
    EXPECT_EQ(module.pins.outputs, 0x0010);
    EXPECT_EQ(module.pins.pwm, (std::array<std::uint8_t, 2>{1, 2}));
}

TEST_F(PicIo, FoundAsAnotherHostLeftItNothingIsKnownButWhatItReads) {
    module.attached();
    EXPECT_EQ(module.pins.inputs, std::nullopt);
    EXPECT_EQ(module.pins.pwm, std::nullopt);
    EXPECT_EQ(planned(iointent::SetOutput{2, true}), Commands{io::SetOutput{0x0805}});
    executed(io::SetDirection{io::kAllPins});
    module.restarted();
    EXPECT_EQ(module.pins.inputs, io::kAllPins) << "after power-up all are inputs";
}

TEST_F(PicIo, HasNoMotor) {
    EXPECT_EQ(refused(intent::Enable{}), Refusal::NoMotor);
    EXPECT_EQ(refused(intent::StopAbruptly{}), Refusal::NoMotor);
    EXPECT_EQ(whyNot(IntentKind::Home, module), Refusal::NoMotor);
    EXPECT_FALSE(module.moving());
    EXPECT_EQ(module.activity(), Activity::Ready);
}

TEST_F(PicIo, AnOperatorSwitchesOutputsOnlyWhereThatIsHis) {
    module.rights = OperatorRights{};
    EXPECT_EQ(refused(iointent::SetOutput{2, true}), Refusal::OperatorMode);
    module.rights->outputs = true;
    EXPECT_EQ(refused(iointent::SetOutput{2, true}), std::nullopt);
    EXPECT_EQ(refused(iointent::SetDirection{0}), Refusal::OperatorMode);
}

TEST_F(PicIo, OthersTakeNothingOfIt) {
    module.info.identity = {ModuleType::Servo, 4};
    EXPECT_EQ(refused(iointent::SetOutput{2, true}), Refusal::NotAnIoModule);
    module.info.identity = {ModuleType::Stepper, 1};
    EXPECT_EQ(refused(iointent::SynchOutput{}), Refusal::NotAnIoModule);
    module.info.identity = {ModuleType::Io, 7};
    EXPECT_NE(refused(iointent::SetOutput{2, true}), std::nullopt) << "an unknown version";
}

TEST_F(PicIo, ItsGroupStartsOnceItsOutputsAreStored) {
    EXPECT_EQ(whyNot(IntentKind::StartLoaded, module), Refusal::NothingLoaded);
    executed(io::SetSynchOutput{0x0003, 0, 0});
    EXPECT_EQ(whyNot(IntentKind::StartLoaded, module), std::nullopt);
    module.silent = true;
    EXPECT_EQ(whyNot(IntentKind::StartLoaded, module), Refusal::Unresponsive);
}

}  // namespace
}  // namespace nmc
