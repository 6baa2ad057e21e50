// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/texts.h"

#include "widgets/common/apitexts.h"
#include "widgets/common/pathtexts.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/common/unitwords.h"
#include "windowtest.h"

namespace nmc {
namespace {

template <typename Enum>
Enum next(Enum value) {
    return static_cast<Enum>(static_cast<int>(value) + 1);
}

QStringList verbs(const Message& message) {
    QStringList list;
    for (const Message::Action& action : message.actions)
        list << action.text;
    return list;
}

// The table of interface.md, row by row.

TEST(Texts, NoPermission) {
    const Message m = texts::portProblem({PortProblem::NoPermission, "/dev/ttyUSB0", "dialout", "anna", {}});
    EXPECT_EQ(m.headline, u"Your user account has no permission to use /dev/ttyUSB0."_s);
    EXPECT_EQ(
        m.body,
        u"It belongs to the group dialout. Run sudo usermod -aG dialout anna, then log out and in again."_s);
    EXPECT_EQ(verbs(m), (QStringList{u"Copy command"_s, u"Choose another port"_s, u"Use simulator"_s}));
}

TEST(Texts, InUse) {
    const Message m = texts::portProblem({PortProblem::InUse, "/dev/ttyUSB0", {}, {}, {}});
    EXPECT_EQ(m.headline, u"/dev/ttyUSB0 is used by another program."_s);
    EXPECT_EQ(m.body, u"Close it and try again."_s);
    EXPECT_TRUE(verbs(m).contains(u"Retry"_s));
}

TEST(Texts, APortThatAPanelHasIsUsedThroughThatPanel) {
    PortError error;
    error.problem = PortProblem::InUse;
    error.port = "/dev/ttyUSB0";
    error.program = "nmcpanel";
    error.pid = 800;
    const Message m = texts::portProblem(error);
    EXPECT_EQ(m.headline, u"/dev/ttyUSB0 is used by nmcpanel (pid 800)."_s);
    EXPECT_TRUE(m.body.contains(u"Let programs in"_s) && m.body.contains(u"--port"_s))
        << m.body.toStdString();
}

TEST(Texts, Gone) {
    texts::setModuleNames({{}, {}, u"Z axis"_s});
    const PortError gone{PortProblem::Gone, "/dev/ttyUSB0", {}, {}, {}, {ModuleIndex(0), ModuleIndex(2)}};
    const Message m = texts::portProblem(gone);
    texts::setModuleNames({});
    EXPECT_EQ(m.headline,
              u"The adapter at /dev/ttyUSB0 was unplugged. Motor state unknown: Module 1 and Module 3 "
              "\"Z axis\" were moving."_s);
    EXPECT_EQ(m.body, u"Use the hardware stop if needed, then plug the adapter in again."_s);
    EXPECT_EQ(m.severity, Severity::Fault);
}

TEST(Texts, NoModule) {
    EXPECT_EQ(texts::connectFailed({bus::ConnectFailure::NobodyAnswers, {}, 19200, true}, u"tcp://lab:4000"_s)
                  .headline,
              u"The port is open, but no module answered (19 200 Bd tried)."_s);
    const Message m =
        texts::connectFailed({bus::ConnectFailure::NobodyAnswers, {}, 115200}, u"/dev/ttyUSB0"_s);
    EXPECT_EQ(m.headline,
              u"The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried)."_s);
    EXPECT_EQ(
        m.body,
        u"Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. If another program left the chain at an unusual baud rate, restart the network."_s);
    EXPECT_EQ(verbs(m), (QStringList{u"Scan again"_s, u"Restart the network…"_s, u"Use simulator"_s}));
}

TEST(Texts, FewerThanExpected) {
    const Message m = texts::fewerThanExpected(3, 5, u"Z axis"_s);
    EXPECT_EQ(m.headline, u"3 of 5 modules answered."_s);
    EXPECT_EQ(m.body,
              u"Numbering starts at the far end, so look at the next module towards the PC after module 3 "
              u"\"Z axis\": "
              "its power first, then the plug between the two."_s);
    EXPECT_EQ(verbs(m), (QStringList{u"Scan again"_s, u"Work with 3"_s}));
}

TEST(Texts, Refused) {
    const Message m = texts::refused({ModuleIndex(1), 1});
    EXPECT_EQ(m.headline, u"Module 2 received a garbled command and did not carry it out."_s);
    EXPECT_EQ(m.body, u"Sending again (1 of 3). Usually noise on the cable."_s);
}

TEST(Texts, Garbled) {
    const Message m = texts::garbled(ModuleIndex(1));
    EXPECT_EQ(m.headline, u"The answer from module 2 was garbled."_s);
    EXPECT_EQ(
        m.body,
        u"The command may or may not have been carried out; the panel is reading the position again."_s);
}

TEST(Texts, BadLink) {
    const Message m = texts::badLink({bus::LinkHealth::Lost, 14, 200, {}});
    EXPECT_EQ(m.headline, u"The link is unreliable: 14 of the last 200 exchanges failed."_s);
    EXPECT_EQ(
        m.body,
        u"Motors were commanded to stop. Until answers have been correct for 2 s, only presence queries are sent; then the panel looks for the modules again. Try a lower baud rate, a shorter cable, or termination at both ends."_s);
    EXPECT_EQ(verbs(m), QStringList{u"Reconnect"_s});
    const Message one = texts::badLink({bus::LinkHealth::Marginal, 5, 60, ModuleIndex(2)});
    EXPECT_EQ(one.headline, u"The link to module 3 is marginal: 5 of its last 60 exchanges failed."_s);
    EXPECT_EQ(one.severity, Severity::Attention);
}

/// What is named would be taken: 9.765625, and not 9.766.
TEST(Texts, AProgramIsToldTheRangeOfANumber) {
    using Kind = api::Problem::Kind;
    EXPECT_EQ(texts::apiProblem({Kind::FieldWrong, "kp", {}, api::NumberRange{0, 32'767}}),
              u"The parameter \"kp\" must be from 0 to 32767 here."_s);
    EXPECT_EQ(
        texts::apiProblem({Kind::FieldWrong, "velocity", {}, api::NumberRange{0.5, 9.765625, "mm/s", true}}),
        u"The parameter \"velocity\" must be from 0.5 to 9.765625 mm/s here, in either direction. 9.765625 mm/s is the max jog speed of the axis."_s);
}

/// What looks like a place mark in a name is part of the name.
TEST(Texts, NamesAreTakenAsTheyAre) {
    texts::setModuleNames({u"50%2"_s});
    const QString link = texts::badLink({bus::LinkHealth::Marginal, 5, 60, ModuleIndex(0)}).headline;
    const QString silent = texts::moduleUnresponsive(ModuleIndex(0), 1.2, true).headline;
    const QString trip = texts::tripped(ModuleIndex(0), 400).headline;
    const QString address = texts::addressChanged({ModuleIndex(0), BusAddress(77)}).headline;
    texts::setModuleNames({});
    EXPECT_EQ(link, u"The link to module 1 \"50%2\" is marginal: 5 of its last 60 exchanges failed."_s);
    EXPECT_TRUE(silent.startsWith(u"Module 1 \"50%2\" has not answered for 1.2 s."_s))
        << silent.toStdString();
    EXPECT_TRUE(trip.startsWith(u"Module 1 \"50%2\" switched its servo off"_s)) << trip.toStdString();
    EXPECT_TRUE(address.startsWith(u"Module 1 \"50%2\" now has address 77."_s)) << address.toStdString();
    EXPECT_EQ(texts::drawingProblem({DrawingProblem::Kind::Endless, "Drill 50%1", 2, {}}),
              u"Drill 50%1, row 3: A path cannot repeat forever."_s);
}

TEST(Texts, SlowAdapter) {
    const Message m = texts::slowAdapter(58, 16);
    EXPECT_EQ(
        m.headline,
        u"Updates are slow (58 per second) because the USB adapter waits 16 ms before passing data on."_s);
    EXPECT_EQ(m.body, u"Set its latency timer to 1 ms."_s);
}

TEST(Texts, ErrorTrip) {
    const Message m = texts::tripped(ModuleIndex(0), 400);
    EXPECT_EQ(
        m.headline,
        u"Module 1 switched its servo off because the motor was more than 400 counts from where it should be."_s);
    EXPECT_EQ(m.body, u"Check for a jam, or raise EL on the Gains page."_s);
    EXPECT_EQ(verbs(m), QStringList{u"Clear and stay off"_s});
}

TEST(Texts, ErrorTripAdvisesByItsCause) {
    const auto advice = [](TripCause cause) { return texts::tripped(ModuleIndex(0), 400, cause).body; };
    EXPECT_TRUE(advice(TripCause::Reversed).contains(u"direction check on the Axis page"_s));
    EXPECT_TRUE(advice(TripCause::Jam).contains(u"a jam, a brake or a hard stop"_s));
    EXPECT_TRUE(advice(TripCause::Limit1).startsWith(u"Limit switch 1 closed"_s));
    EXPECT_TRUE(advice(TripCause::Limit2).startsWith(u"Limit switch 2 closed"_s));
    EXPECT_TRUE(advice(TripCause::Behind).contains(u"could not keep up"_s));
}

TEST(Texts, Power) {
    const Message m = texts::powerLost(ModuleIndex(0));
    EXPECT_EQ(m.headline, u"Module 1 has no motor power, so its servo is off."_s);
    EXPECT_EQ(m.body, u"It stays off when power returns."_s);
}

TEST(Texts, ABadFileSaysWhoseRangeItIs) {
    const auto said = [](bool ofModule) {
        return texts::fileProblem(u"mill.json"_s, {.kind = FileProblem::Kind::OutOfRange,
                                                   .line = 12,
                                                   .field = "Kp",
                                                   .found = "40000",
                                                   .max = 32'767,
                                                   .ofModule = ofModule});
    };
    EXPECT_EQ(said(true), u"\"mill.json\" line 12: Kp is 40000; the module accepts 0 to 32767."_s);
    EXPECT_EQ(said(false), u"\"mill.json\" line 12: Kp is 40000; it must be 0 to 32767."_s);
}

TEST(Texts, Restarted) {
    const Message m = texts::restarted({ModuleIndex(1), false}, 3);
    EXPECT_EQ(m.headline, u"Module 2 restarted: its position and gains are lost."_s);
    EXPECT_EQ(
        m.body,
        u"Its motor is off. Module 3 may not answer until module 2 has its address again. You can assign just its address: the other modules keep their positions and gains."_s);
    EXPECT_EQ(verbs(m), (QStringList{u"Assign the address of module 2"_s, u"Restart the network…"_s}));
    EXPECT_FALSE(texts::restarted({ModuleIndex(2), false}, 3).body.contains(u"may not answer"_s))
        << "there is no module nearer the PC";
    EXPECT_EQ(verbs(texts::restarted({ModuleIndex(2), true}, 3)),
              (QStringList{u"Scan again"_s, u"Restart the network…"_s}))
        << "at another rate the chain has to be found again first";
    EXPECT_TRUE(texts::restarted({ModuleIndex(2), true}, 3).body.contains(u"sending has stopped"_s));
}

/// This has happened: a PIC-I/O was said to have lost its gains, and its motor to be off.
TEST(Texts, ARestartSaysWhatThatTypeOfModuleHasLost) {
    static constexpr ModuleIndex kSecond(1);
    const Message io = texts::restarted({kSecond, false}, 2, ModuleType::Io);
    EXPECT_EQ(io.headline,
              u"Module 2 restarted: its pins are inputs again, and its outputs release what they drove."_s);
    EXPECT_TRUE(io.body.startsWith(u"Set its outputs again once it has its address. You can assign"_s))
        << io.body.toStdString();
    const Message stepper = texts::restarted({kSecond, false}, 2, ModuleType::Stepper);
    EXPECT_EQ(stepper.headline, u"Module 2 restarted: its position and parameters are lost."_s);
    EXPECT_TRUE(stepper.body.startsWith(u"Its motor is off."_s));
    const auto back = [](ModuleType type) {
        return texts::readdressed({{kSecond, BusAddress(2), {type, 1}}});
    };
    EXPECT_TRUE(back(ModuleType::Servo).headline.endsWith(u"its position is 0, and it has no gains."_s));
    EXPECT_TRUE(back(ModuleType::Stepper).body.contains(u"Apply its parameters and home it"_s));
    EXPECT_EQ(back(ModuleType::Io).headline,
              u"Module 2 has its address again. Its pins are inputs, and its outputs drive nothing."_s);
    for (const Message& m : {io, back(ModuleType::Io), texts::moduleMissing(kSecond, 1, ModuleType::Io),
                             texts::moduleUnresponsive(kSecond, 1.5, false, ModuleType::Io)})
        EXPECT_FALSE(m.headline.contains(u"motor"_s, Qt::CaseInsensitive)) << m.headline.toStdString();
    for (const Activity activity : {Activity::Restarted, Activity::Unresponsive})
        EXPECT_FALSE(texts::activityMeaning(activity, ModuleType::Io).contains(u"motor"_s));
}

/// This has happened: it was not said which input was waited for, nor for which level.
TEST(Texts, AWaitThatTimedOutSaysWhatItWaitedFor) {
    static constexpr ModuleIndex kFourth(3);
    const auto said = [](SequenceEnd end, const Action& awaited) {
        SequenceReport report;
        report.stage = SequenceStage::Over;
        report.places = {{"Main", 0}};
        report.end = end;
        report.module = kFourth;
        report.awaited = awaited;
        return texts::sequenceState(report);
    };
    const auto analog = [&said](bool above) {
        return said(SequenceEnd::AnalogTimeout, action::WaitForAnalog{kFourth, 1, above, 100, 10});
    };
    const auto input = [&said](InputPin pin, bool active) {
        return said(SequenceEnd::InputTimeout, action::WaitForInput{kFourth, pin, active, 2.5});
    };
    EXPECT_EQ(analog(true),
              u"Ended: Main, row 1. A/D 1 of Module 4 did not rise above 100 of 255 within 10 s."_s);
    EXPECT_TRUE(analog(false).contains(u"did not fall below 100 of 255"_s));
    EXPECT_TRUE(input(InputPin::Io1, true).endsWith(u"IO1 of Module 4 did not become high within 2.5 s."_s));
    EXPECT_TRUE(input(InputPin::Io1, false).contains(u"did not become low"_s));
    EXPECT_TRUE(input(InputPin::In1, true).contains(u"IN1 of Module 4 did not become active"_s));
    EXPECT_TRUE(input(InputPin::In1, false).contains(u"did not become inactive"_s));
}

TEST(Texts, Closing) {
    EXPECT_EQ(texts::closing(2), u"2 motors are moving. They will be stopped before the port closes."_s);
    EXPECT_EQ(texts::closing(1), u"1 motor is moving. It will be stopped before the port closes."_s);
}

TEST(Texts, StopBeforeAndAfter) {
    EXPECT_EQ(texts::stopReach(5, 5), u"reaches 5 of 5"_s);
    std::vector<ModuleIndex> five;
    for (std::uint8_t i = 0; i < 5; ++i)
        five.emplace_back(i);
    // One holds, one was driven by a PWM value, two had been off before, and two have no motor.
    std::vector<ModuleState> modules;
    for (int i = 0; i < 6; ++i)
        modules.push_back(Servo{.index = i, .on = i == 0}.state());
    modules[4].info.identity = modules[5].info.identity = {ModuleType::Io, 1};
    std::vector<ModuleIndex> six = five;
    six.emplace_back(5);
    const std::vector<ModuleIndex> off{six[2], six[3]};
    EXPECT_EQ(
        texts::stopResult({six, {}, {}, {}, fromSeconds(0.021), off}, modules).headline,
        u"1 stopped and holding, 1 switched off, 2 were off, 2 I/O modules in their stop state, 21 ms."_s);
    EXPECT_EQ(
        texts::stopResult({{five.begin(), five.begin() + 4}, {ModuleIndex(2)}, {}, {}, {}}, modules).headline,
        u"4 of 5 stopped. Module 3 does not answer: use the hardware stop."_s);
}

TEST(Texts, AStopThatIsNotConfirmedSendsToTheHardwareStop) {
    const ModuleIndex one(0);
    const ModuleIndex two(1);
    const ModuleIndex three(2);
    const auto said = [](const bus::StopFinished& finished) {
        EXPECT_FALSE(texts::allStopped(finished, {}));
        const Message message = texts::stopResult(finished, {});
        EXPECT_EQ(message.severity, Severity::Fault);
        EXPECT_EQ(message.key, texts::key::kStop);
        return message.headline;
    };
    EXPECT_EQ(
        said({{one, three}, {}, {two}, {}, {}}),
        u"2 of 3 stopped. Module 2 was commanded to stop but was not seen at rest: use the hardware stop."_s);
    EXPECT_EQ(said({{one}, {three}, {two}, {}, {}}),
              u"1 of 3 stopped. Module 3 does not answer. Module 2 was commanded to stop but was not seen at "
              u"rest: use the hardware stop."_s);
    EXPECT_EQ(said({{one}, {}, {two, three}, {}, {}}),
              u"1 of 3 stopped. Modules 2 and 3 were commanded to stop but were not seen at rest: use the "
              u"hardware stop."_s);
    EXPECT_EQ(said({{}, {one, two}, {}, {}, {}}),
              u"No stop was confirmed. Modules 1 and 2 do not answer: use the hardware stop."_s);
    EXPECT_EQ(
        said({{}, {}, {one}, {}}),
        u"No stop was confirmed. Module 1 was commanded to stop but was not seen at rest: use the hardware stop."_s);
    EXPECT_EQ(said({}), u"No stop was confirmed. No module is known: use the hardware stop."_s);
}

/// This has happened: the panel knew that the module had restarted, and sent the user to the hardware stop.
TEST(Texts, AModuleThatHasRestartedIsNotMissingAfterAStop) {
    const ModuleIndex one(0);
    const ModuleIndex two(1);
    const ModuleIndex three(2);
    std::vector<ModuleState> modules{Servo{}.state(), Servo{.index = 1}.state(),
                                     Servo{.index = 2, .on = false}.state()};
    modules[0].restarted();
    const bus::StopFinished stop{{two, three}, {one}, {}, {}, fromSeconds(0.412), {three}};
    EXPECT_TRUE(texts::allStopped(stop, modules));
    const Message message = texts::stopResult(stop, modules);
    EXPECT_EQ(message.headline,
              u"1 stopped and holding, 1 was off, 412 ms. Module 1 is off after a restart."_s);
    EXPECT_EQ(message.severity, Severity::Normal) << "the message about the restart comes first";
    const bus::StopFinished alone{{}, {one}, {}, {}, {}};
    EXPECT_EQ(texts::stopResult(alone, modules).headline, u"Module 1 is off after a restart."_s);
    const bus::StopFinished worse{{two}, {one, three}, {}, {}, {}};
    EXPECT_FALSE(texts::allStopped(worse, modules));
    EXPECT_EQ(texts::stopResult(worse, modules).headline,
              u"1 of 3 stopped. Module 1 is off after a restart. Module 3 does not answer: use the "
              u"hardware stop."_s);
}

TEST(Texts, NothingHasStoppedBeforeItIsConfirmed) {
    using Reason = bus::MotionSuspect::Reason;
    using Ended = bus::HoldExpired::Reason;
    bus::HealthChanged lost{bus::LinkHealth::Lost, 14, 200, {}};
    bus::GroupFinished half{bus::OperationId(1), bus::Outcome::NoAnswer, bus::GroupCommand{}, {}, true};
    for (const Message& m : {texts::holdExpired({ModuleIndex(0), Ended::Expired}),
                             texts::holdExpired({ModuleIndex(0), Ended::NoAnswer}),
                             texts::holdExpired({ModuleIndex(0), Ended::NotPossible}),
                             texts::holdExpired({ModuleIndex(0), Ended::GoalChanged}),
                             texts::motionSuspect({ModuleIndex(0), Reason::WrongWay, 5}),
                             texts::motionSuspect({ModuleIndex(0), Reason::Overshot, 5}),
                             texts::motionSuspect({ModuleIndex(0), Reason::Frozen, 5}), texts::badLink(lost),
                             texts::restarted({ModuleIndex(0), true}, 2), texts::groupFailed(half),
                             texts::machineSlept(60, true), texts::panelFroze(3, true)}) {
        const QString words = m.headline + u' ' + m.body;
        EXPECT_TRUE(words.contains(u"commanded to "_s)) << words.toStdString();
        for (const QString& deed : {u"was stopped"_s, u"were stopped"_s, u"switched off:"_s, u" ended"_s})
            EXPECT_FALSE(words.contains(deed)) << words.toStdString();
    }
    EXPECT_EQ(texts::stopConfirmed({ModuleIndex(1), bus::StopCause::HoldExpired}), u"It has stopped."_s);
    EXPECT_EQ(texts::stopConfirmed({ModuleIndex(1), bus::StopCause::GroupHalfStarted}),
              u"Module 2 has stopped."_s);
}

TEST(Texts, NoStopIsClaimedForAJogThatDidNotStart) {
    using Reason = bus::HoldExpired::Reason;
    EXPECT_EQ(texts::holdExpired({ModuleIndex(0), Reason::NoAnswer, false}).headline,
              u"Module 1 did not confirm the command to jog. Nothing was started."_s);
    EXPECT_EQ(texts::holdExpired({ModuleIndex(0), Reason::NotPossible, false}).headline,
              u"Module 1 cannot jog in its present state. Nothing was started."_s);
}

/// A name may look like a place marker.
TEST(Texts, NamesAreShownAsTheyAre) {
    EXPECT_EQ(texts::machineOpened(u"/home/anna/50%1.json"_s, 3, 0).headline,
              u"\"50%1.json\" is open. Settings applied: 3."_s);
    EXPECT_EQ(texts::analogReading({.perCount = 1, .unit = "%1"}, 7), u"7 %1 (7 of 255)"_s);
}

/// What another host has loaded is not known, but need not be 0.
TEST(Texts, NoVelocityOrAccelerationIsCalledZeroThatMayBeUnknown) {
    EXPECT_TRUE(texts::refusal(Refusal::NoVelocity).startsWith(u"The velocity is 0 or unknown"_s));
    EXPECT_TRUE(texts::refusal(Refusal::NoAcceleration).startsWith(u"The acceleration is 0 or unknown"_s));
}

/// Also of those that are not expected there.
TEST(Texts, EveryFailureOfEveryProcedureHasWords) {
    for (auto kind = ProcedureKind::Homing; kind <= ProcedureKind::Repeatability; kind = next(kind))
        for (auto failure = ProcedureFailure::SwitchActive; failure <= ProcedureFailure::Bounced;
             failure = next(failure)) {
            ProcedureReport report;
            report.kind = kind;
            report.stage = ProcedureStage::Failed;
            report.failure = failure;
            const auto message = texts::procedureEnded(report, AxisScale::servo({}, 1));
            ASSERT_TRUE(message);
            EXPECT_TRUE(message->headline.contains(u"1"_s))
                << static_cast<int>(kind) << static_cast<int>(failure);
            EXPECT_FALSE(message->body.isEmpty())
                << static_cast<int>(kind) << ' ' << static_cast<int>(failure);
        }
}

TEST(Texts, LinkMessagesSayStoppedMovingOrUnknown) {
    for (const Message& m :
         {texts::linkLost(u"/dev/ttyUSB0"_s, {}), texts::linkLost(u"/dev/ttyUSB0"_s, {ModuleIndex(0)}),
          texts::moduleUnresponsive(ModuleIndex(0), 1.2, true),
          texts::moduleUnresponsive(ModuleIndex(0), 1.2, false),
          texts::portProblem({PortProblem::Gone, "/dev/ttyUSB0", {}, {}, {}}),
          texts::operationFailed({bus::OperationId(1), bus::Outcome::NoAnswer, ModuleIndex(0), 0})})
        EXPECT_TRUE(m.headline.contains(u"unknown"_s)) << m.headline.toStdString();
}

TEST(Texts, NoModuleHasBeenSilentForNoTime) {
    const QString headline = texts::moduleUnresponsive(ModuleIndex(0), 0.02, false).headline;
    EXPECT_TRUE(headline.startsWith(u"Module 1 has not answered for 0.1 s."_s)) << headline.toStdString();
}

TEST(Texts, WhatIsRememberedSaysHowItsHomeWasDetermined) {
    const auto body = [](HomeFact::Source source) {
        RememberedPosition last;
        last.source = source;
        return texts::positionRemembered({ModuleIndex(0), 0, last}, AxisScale::servo({}, 1)).body;
    };
    EXPECT_TRUE(body(HomeFact::Source::Search).contains(u"; a search had found home."_s));
    EXPECT_TRUE(body(HomeFact::Source::Saved).contains(u"; home had been saved."_s));
    EXPECT_TRUE(body(HomeFact::Source::Declared).contains(u"; the position had been confirmed."_s));
}

/// No blame, no drama.
TEST(Texts, NoForbiddenWords) {
    QStringList all;
    const auto add = [&all](const Message& m) { all << m.headline + u' ' + m.body; };
    for (int p = 0; p <= static_cast<int>(PortProblem::Other); ++p)
        add(texts::portProblem({static_cast<PortProblem>(p), "/dev/ttyUSB0", {}, {}, {}}));
    for (int f = 0; f <= static_cast<int>(bus::ConnectFailure::Garbled); ++f)
        add(texts::connectFailed({static_cast<bus::ConnectFailure>(f), {ModuleIndex(1)}, 115200},
                                 u"/dev/ttyUSB0"_s));
    for (int o = 0; o <= static_cast<int>(bus::Outcome::Cancelled); ++o)
        add(texts::operationFailed(
            {bus::OperationId(1), static_cast<bus::Outcome>(o), ModuleIndex(0), 0x17}));
    for (int r = 0; r <= static_cast<int>(Refusal::TooFar); ++r) {
        all << texts::refusal(static_cast<Refusal>(r));
        EXPECT_FALSE(all.back().isEmpty()) << r;
    }
    for (int a = 0; a <= static_cast<int>(Activity::WentOff); ++a) {
        EXPECT_FALSE(texts::activity(static_cast<Activity>(a)).isEmpty()) << a;
        all << texts::activity(static_cast<Activity>(a)) << texts::activityMeaning(static_cast<Activity>(a));
    }
    all << texts::unknownPort(u"x"_s, {u"/dev/ttyUSB0"_s}) << texts::badBaud(u"4800"_s)
        << texts::badChain(u"x"_s, u"y"_s) << texts::safety().body << texts::noDisplay();
    for (int a = 0; a <= static_cast<int>(Activity::WentOff); ++a)
        add(texts::amplifierWentOff(ModuleIndex(0), static_cast<Activity>(a)));
    for (int p = 0; p <= static_cast<int>(GuardianProblem::Ended); ++p)
        add(texts::guardianMissing(static_cast<GuardianProblem>(p)));
    add(texts::guardianStopped());
    add(texts::guardianStoppedBefore({ModuleIndex(0), ModuleIndex(2)}));
    for (QString& sentence : all) {
        // The only thing with this name (interface.md, "Stop").
        sentence.remove(u"E-stop input"_s);
        for (const QString& word :
             {u"invalid"_s, u"illegal"_s, u"fatal"_s, u"!"_s, u"dead-man"_s, u"E-stop"_s})
            EXPECT_FALSE(sentence.contains(word, Qt::CaseInsensitive)) << sentence.toStdString();
        EXPECT_FALSE(sentence.contains(u"%"_s)) << "an argument is missing: " << sentence.toStdString();
    }
}

TEST(Texts, EachStateHasAWordOfItsOwn) {
    QStringList words;
    for (int a = 0; a <= static_cast<int>(Activity::WentOff); ++a)
        words << texts::activity(static_cast<Activity>(a));
    EXPECT_EQ(words.removeDuplicates(), 0);
}

TEST(Texts, ServoOffIsNotAFault) {
    EXPECT_EQ(texts::activity(Activity::ServoOff), u"Servo off"_s);
    EXPECT_EQ(severityOf(Activity::ServoOff), Severity::Normal);
}

TEST(Texts, ReadoutsAreGroupedAndSigned) {
    EXPECT_EQ(texts::grouped(0), u"0"_s);
    EXPECT_EQ(texts::grouped(-1234567), u"\u22121\u202f234\u202f567"_s);
    EXPECT_EQ(texts::fixed(1e22, 0), u"10"_s + u"\u202f000"_s.repeated(7)) << "more than 64 bits";
    EXPECT_EQ(texts::readout(1953.125), u"1\u202f953"_s);
    EXPECT_EQ(texts::readout(0.5), u"0.5"_s);
    EXPECT_EQ(texts::readout(-0.5), u"\u22120.5"_s);
    EXPECT_EQ(texts::readout(0), u"0"_s);
    EXPECT_EQ(texts::readout(-1e-9), u"0"_s) << "it has six decimals";
    EXPECT_EQ(texts::readout(999.99), u"1\u202f000"_s);
}

}  // namespace
}  // namespace nmc
