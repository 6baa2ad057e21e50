// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/commands.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace nmc {
namespace {

template <typename T>
T inRange(ValueRange range) {
    return static_cast<T>(*rc::gen::inRange<std::int64_t>(range.min, range.max + 1));
}

template <typename T, typename Make>
std::optional<T> maybe(Make make) {
    return *rc::gen::arbitrary<bool>() ? std::optional<T>(make()) : std::nullopt;
}

bool flag() {
    return *rc::gen::arbitrary<bool>();
}

template <typename Command>
void expectRoundTrip(const Command& command) {
    const auto decoded = decode<Command>(encode(command));
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(*decoded == command);
}

RC_GTEST_PROP(ServoLoadTrajectory, DecodesToWhatWasEncoded, ()) {
    servo::LoadTrajectory load;
    load.position = maybe<Counts>([] { return Counts(inRange<std::int32_t>(servo::kPositionRange)); });
    load.velocity =
        maybe<CountsPerTick>([] { return CountsPerTick(inRange<std::uint32_t>(servo::kVelocityRange)); });
    load.acceleration = maybe<CountsPerTickSquared>(
        [] { return CountsPerTickSquared(inRange<std::uint32_t>(servo::kVelocityRange)); });
    load.pwm = maybe<std::uint8_t>([] { return inRange<std::uint8_t>(servo::kByteRange); });
    load.servo = flag();
    load.profile = flag() ? servo::ProfileMode::Velocity : servo::ProfileMode::Trapezoidal;
    load.reverse = flag();
    load.startNow = flag();
    expectRoundTrip(load);
}

RC_GTEST_PROP(StepperLoadTrajectory, DecodesToWhatWasEncoded, ()) {
    stepper::LoadTrajectory load;
    load.position = maybe<Counts>([] { return Counts(inRange<std::int32_t>(stepper::kPositionRange)); });
    load.speed = maybe<std::uint8_t>([] { return inRange<std::uint8_t>(stepper::kSpeedRange); });
    load.accelerationTime =
        maybe<std::uint8_t>([] { return inRange<std::uint8_t>(stepper::kAccelerationTimeRange); });
    load.timer = maybe<stepper::TimerCount>([] {
        return stepper::TimerCount{inRange<std::uint16_t>(stepper::kTimerCountRange),
                                   inRange<std::uint8_t>(stepper::kNearestSpeedRange)};
    });
    load.reverse = flag();
    load.startNow = flag();
    expectRoundTrip(load);
}

RC_GTEST_PROP(ServoSetGain, DecodesToWhatWasEncoded, ()) {
    servo::SetGain gains;
    gains.kp = inRange<std::uint16_t>(servo::kGainRange);
    gains.kd = inRange<std::uint16_t>(servo::kGainRange);
    gains.ki = inRange<std::uint16_t>(servo::kGainRange);
    gains.il = inRange<std::uint16_t>(servo::kGainRange);
    gains.ol = inRange<std::uint8_t>(servo::kByteRange);
    gains.cl = inRange<std::uint8_t>(servo::kByteRange);
    gains.el = inRange<std::uint16_t>(servo::kPositionErrorRange);
    gains.sr = inRange<std::uint8_t>(servo::kServoRateRange);
    gains.db = maybe<std::uint8_t>([] { return inRange<std::uint8_t>(servo::kByteRange); });
    expectRoundTrip(gains);
}

RC_GTEST_PROP(ServoBits, IoControlAndHomingDecodeToWhatWasEncoded, ()) {
    expectRoundTrip(servo::IoControl{flag(), flag(), flag(), flag()});
    servo::SetHoming homing{flag(), flag(), flag(), flag(), flag(), false, false, false};
    const int stop = *rc::gen::inRange(0, 4);
    homing.motorOff = stop == 1;
    homing.stopAbruptly = stop == 2;
    homing.stopSmoothly = stop == 3;
    expectRoundTrip(homing);
}

RC_GTEST_PROP(ServoStop, DecodesToWhatWasEncoded, ()) {
    servo::StopMotor stop;
    stop.amplifierEnable = flag();
    stop.manner = static_cast<servo::StopManner>(*rc::gen::inRange(0, 5));
    if (stop.manner == servo::StopManner::Here)
        stop.here = Counts(*rc::gen::arbitrary<std::int32_t>());
    expectRoundTrip(stop);
}

RC_GTEST_PROP(LaterServoCommands, DecodeToWhatWasEncoded, ()) {
    expectRoundTrip(servo::SetPosition{Counts(*rc::gen::arbitrary<std::int32_t>())});
    expectRoundTrip(servo::HardReset{flag(), flag(), flag(), flag(), flag(), flag(), flag(), flag()});
    servo::ScIoControl control{static_cast<servo::LimitStop>(*rc::gen::inRange(0, 3)), flag(), flag(), flag(),
                               false};
    expectRoundTrip(control);
    control.limitStop = servo::LimitStop::None;
    control.stepAndDirection = true;
    expectRoundTrip(control);
}

RC_GTEST_PROP(IoCommands, DecodeToWhatWasEncoded, ()) {
    const auto pins = [] { return *rc::gen::inRange<std::uint16_t>(0, 0x1000); };
    const auto byte = [] { return *rc::gen::arbitrary<std::uint8_t>(); };
    expectRoundTrip(io::SetDirection{pins()});
    expectRoundTrip(io::SetPwm{byte(), byte()});
    expectRoundTrip(io::SetOutput{pins()});
    expectRoundTrip(io::SetSynchOutput{pins(), byte(), byte()});
    expectRoundTrip(io::SetTimerMode{flag(), flag(), static_cast<io::Prescaler>(*rc::gen::inRange(0, 4))});
}

RC_GTEST_PROP(StepperCommands, DecodeToWhatWasEncoded, ()) {
    expectRoundTrip(stepper::SetParameters{
        static_cast<stepper::SpeedMode>(*rc::gen::inRange(0, 4)), flag(), flag(), flag(),
        inRange<std::uint8_t>(stepper::kSpeedRange), inRange<std::uint8_t>(stepper::kByteRange),
        inRange<std::uint8_t>(stepper::kByteRange), inRange<std::uint8_t>(stepper::kByteRange)});
    expectRoundTrip(stepper::StopMotor{flag(), static_cast<stepper::StopManner>(*rc::gen::inRange(0, 3))});
    expectRoundTrip(stepper::SetOutputs{static_cast<std::uint8_t>(*rc::gen::inRange(0, 32))});
    expectRoundTrip(stepper::SetHoming{flag(), flag(), flag(), flag(), false, false});
    expectRoundTrip(stepper::SetHoming{flag(), flag(), flag(), false, false, flag()});
}

RC_GTEST_PROP(Decoders, NeverReadBeyondAnyPayload,
              (std::uint8_t version, std::uint8_t code, std::vector<std::uint8_t> bytes)) {
    bytes.resize(bytes.size() % (kMaxData + 1));
    const Payload payload{static_cast<CommandCode>(code & 0xFU), DataBytes(bytes)};
    const auto asServo = decodeServoCommand({ModuleType::Servo, version}, payload);
    const auto asIo = decodeIoCommand(payload);
    const auto asStep = decodeStepCommand(payload);
    if (asServo)
        RC_ASSERT(encode(*asServo).code == payload.code);
    if (asIo)
        RC_ASSERT(encode(*asIo).code == payload.code);
    if (asStep)
        RC_ASSERT(encode(*asStep).code == payload.code);
}

RC_GTEST_PROP(Packets, ParseToTheFrameTheyWereMadeFrom,
              (std::uint8_t address, std::uint8_t code, std::vector<std::uint8_t> data)) {
    data.resize(data.size() % (kMaxData + 1));
    const Frame frame{BusAddress(address), {static_cast<CommandCode>(code & 0xFU), DataBytes(data)}};
    const auto parsed = parsePacket(toPacket(frame));
    RC_ASSERT(parsed.has_value());
    RC_ASSERT(*parsed == frame);
}

TEST(SetGain, IsThirteenBytesWithoutAndFourteenWithDeadband) {
    servo::SetGain gains;
    EXPECT_EQ(encode(gains).commandByte(), 0xD6);  // DS-V 5.2: 0xD6 for versions 1, 2 and 3
    gains.db = std::uint8_t{0};
    EXPECT_EQ(encode(gains).commandByte(), 0xE6);  // 0xE6 for version 4
}

TEST(SetGain, PutsEveryValueAtItsDataSheetPlace) {
    const servo::SetGain gains{0x0102, 0x0304, 0x0506, 0x0708, 0x09, 0x0A, 0x0B0C, 0x0D, std::uint8_t{0x0E}};
    EXPECT_EQ(toHex(encode(gains).data), "02 01 04 03 06 05 08 07 09 0A 0C 0B 0D 0E");
}

TEST(SetGain, IgnoresAFifteenthByte) {
    DataBytes data{1, 0, 2, 0, 3, 0, 4, 0, 5, 6, 7, 0, 8, 9, 0xFF};
    const auto gains = decode<servo::SetGain>({CommandCode::SetGain, data});
    ASSERT_TRUE(gains.has_value());
    EXPECT_EQ(gains->db, 9);
}

TEST(SetGain, RefusesWhatTheDataSheetDoesNotAllow) {
    servo::SetGain gains;
    gains.kp = 0x8000;
    EXPECT_FALSE(decode<servo::SetGain>(encode(gains)).has_value());
    gains = {};
    gains.el = 0x4000;
    EXPECT_FALSE(decode<servo::SetGain>(encode(gains)).has_value());
    gains = {};
    gains.sr = 0;
    EXPECT_FALSE(decode<servo::SetGain>(encode(gains)).has_value());
}

TEST(LoadTrajectory, RefusesDataThatItsControlByteDoesNotAnnounce) {
    EXPECT_FALSE(decode<servo::LoadTrajectory>({CommandCode::LoadTrajectory, {0x11, 1, 2, 3}}).has_value());
    EXPECT_FALSE(decode<servo::LoadTrajectory>({CommandCode::LoadTrajectory, {0x10, 1}}).has_value());
    EXPECT_FALSE(decode<stepper::LoadTrajectory>({CommandCode::LoadTrajectory, {0x08, 1, 2}}).has_value());
}

// DS-S 5.1 gives the nearest integer speed no range. At 1x, 10 steps/s are 0.4 of a speed unit of 25, and
// their count is 65 536 - 62 500 + 2 = 3 038, 0BDE (DS-S 4.1).
TEST(LoadTrajectory, TakesATimerCountWhoseNearestSpeedIsZero) {
    const auto load = decode<stepper::LoadTrajectory>({CommandCode::LoadTrajectory, {0x88, 0xDE, 0x0B, 0}});
    ASSERT_TRUE(load.has_value());
    EXPECT_EQ(load->timer, (stepper::TimerCount{3'038, 0}));
    EXPECT_FALSE(
        decode<stepper::LoadTrajectory>({CommandCode::LoadTrajectory, {0x88, 0xDE, 0x0B, 251}}).has_value());
}

TEST(StopMotor, TakesOnlyOneMannerAtATime) {
    EXPECT_FALSE(decode<servo::StopMotor>({CommandCode::StopMotor, {0x0C}}).has_value());
    EXPECT_FALSE(decode<stepper::StopMotor>({CommandCode::StopMotor, {0x0C}}).has_value());
}

TEST(StepperCommandBits, AreWhereTheDataSheetPutsThem) {
    // DS-S 5.1: speed mode 1x = 11, limits off bit 2, E-stop off bit 3, motor off bit 4.
    const stepper::SetParameters parameters{stepper::SpeedMode::X1, true, true, true, 10, 200, 50, 70};
    EXPECT_EQ(toHex(encode(parameters).data), "1F 0A C8 32 46");
    EXPECT_EQ(encode(parameters).commandByte(), 0x56);
    EXPECT_EQ(toHex(encode(stepper::StopMotor{true, stepper::StopManner::Smoothly}).data), "09");
    EXPECT_EQ(toHex(encode(stepper::StopMotor{false, stepper::StopManner::Abruptly}).data), "04");
    EXPECT_EQ(toHex(encode(stepper::SetOutputs{0x10}).data), "10");
    EXPECT_EQ(toHex(encode(stepper::SetHoming{true, false, true, false, true, false}).data), "19");
    stepper::LoadTrajectory load;
    load.timer = stepper::TimerCount{0xFE0C, 50};
    load.reverse = load.startNow = true;
    EXPECT_EQ(toHex(encode(load).data), "98 0C FE 32");
}

TEST(IoCommandBits, AreWhereTheFamilyPagePutsThem) {
    // IO1 and IO12; bits 0 enable, 1 counter, 5 and 4 prescaler.
    EXPECT_EQ(toHex(encode(io::SetDirection{0x0801}).data), "01 08");
    EXPECT_EQ(toHex(encode(io::SetOutput{0x0FFF}).data), "FF 0F");
    EXPECT_EQ(toHex(encode(io::SetSynchOutput{0x0102, 3, 4}).data), "02 01 03 04");
    EXPECT_EQ(toHex(encode(io::SetPwm{7, 8}).data), "07 08");
    EXPECT_EQ(toHex(encode(io::SetTimerMode{true, false, io::Prescaler::X8}).data), "31");
    EXPECT_EQ(toHex(encode(io::SetTimerMode{true, true, io::Prescaler::X2}).data), "13");
    EXPECT_EQ(encode(io::SynchOutput{}).commandByte(), 0x05);
    EXPECT_EQ(encode(io::SynchInput{}).commandByte(), 0x0C);
    EXPECT_EQ(decode<io::SetDirection>({CommandCode::ResetPosition, {0, 0xF1}})->inputs, 0x0100);
}

TEST(ScCommandBits, AreWhereTheFamilyPagePutsThem) {
    servo::ScIoControl control;
    control.limitStop = servo::LimitStop::MotorOff;
    EXPECT_EQ(toHex(encode(control).data), "04");
    control.limitStop = servo::LimitStop::Abruptly;
    control.antiphase = control.fastPath = true;
    EXPECT_EQ(toHex(encode(control).data), "68");
    EXPECT_EQ(toHex(encode(servo::HardReset{true, false, false, false, false, true, false, true}).data),
              "A1");
    servo::StopMotor stop;
    stop.advancedFeatures = true;
    EXPECT_EQ(toHex(encode(stop).data), "20");
    servo::IoControl first;
    first.fastPath = true;
    EXPECT_EQ(toHex(encode(first).data), "4C");
    servo::LoadTrajectory load;
    load.relative = true;
    EXPECT_EQ(toHex(encode(load).data), "50");
}

TEST(ScIoControl, RefusesStepAndDirectionWithALimitStop) {
    for (const DataBytes& control : {DataBytes{0x84}, DataBytes{0x88}, DataBytes{0x0C}})
        EXPECT_FALSE(decode<servo::ScIoControl>({CommandCode::IoControl, control}).has_value());
}

TEST(AddPathPoints, TakesWholePointsOnly) {
    EXPECT_FALSE(decode<servo::AddPathPoints>({CommandCode::AddPathPoints, {1, 2, 3}}).has_value());
    EXPECT_FALSE(decode<servo::AddPathPoints>({CommandCode::AddPathPoints,
                                               DataBytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}})
                     .has_value());
    const std::vector<servo::PathPoint> eight(8);
    EXPECT_FALSE(servo::AddPathPoints::of(eight, false).has_value());
}

TEST(SetAddress, ClearsBit7ForALeaderAndReadsItBackAsTheGroup) {
    const auto leader = decode<SetAddress>({CommandCode::SetAddress, {5, 0x02}});
    ASSERT_TRUE(leader.has_value());
    EXPECT_EQ(leader->group, BusAddress(0x82));
    EXPECT_TRUE(leader->leader);
}

TEST(ParsePacket, NamesWhatIsWrong) {
    const auto error = [](std::initializer_list<std::uint8_t> bytes) {
        return parsePacket(ByteBuffer<32>(bytes)).error();
    };
    EXPECT_EQ(error({0xAA, 0x01, 0x0E}), FrameError::TooShort);
    EXPECT_EQ(error({0xAB, 0x01, 0x0E, 0x0F}), FrameError::NoHeader);
    EXPECT_EQ(error({0xAA, 0x01, 0x1E, 0x1F}), FrameError::LengthMismatch);
    EXPECT_EQ(error({0xAA, 0x01, 0x0E, 0x10}), FrameError::Checksum);
}

}  // namespace
}  // namespace nmc
