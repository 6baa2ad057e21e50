// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <QTime>
#include <functional>
#include <optional>
#include <vector>

#include "bus/exchangerecord.h"
#include "bus/types.h"
#include "link/files/machineio.h"
#include "link/guardian/guardianproblem.h"
#include "link/ports/porterror.h"
#include "model/machinefile/fileproblem.h"
#include "model/machinefile/machinecompare.h"
#include "model/module/modulestate.h"
#include "model/procedure/procedure.h"
#include "model/settings/axisscale.h"
#include "widgets/common/message.h"
#include "widgets/common/words.h"

namespace nmc {

struct PacketSession;
struct RecordingFailure;
struct RecordingProblem;

/// THE table of sentences for events: window, log and command line all take them from here.
namespace texts {

// ---- the port and the link ----
[[nodiscard]] Message portProblem(const PortError& error);
[[nodiscard]] Message connectFailed(const bus::ConnectFailed& failed, const QString& port);
/// `lastName`: the user's name of the last module that answered, may be empty.
[[nodiscard]] Message fewerThanExpected(int found, int expected, const QString& lastName = {});
/// One of the chain that was known here does not answer at its address; `answering` others do.
[[nodiscard]] Message moduleMissing(ModuleIndex module, int answering);
/// What is there cannot be taken as the chain while motors move: it is looked for anew then.
[[nodiscard]] Message chainNotAccepted();
[[nodiscard]] Message connected(const bus::ChainFound& found, const QString& port);
[[nodiscard]] Message echoNoticed(const QString& port);
[[nodiscard]] Message repliesInPieces(const QString& port, int gapMs);
/// A module without an address answers beside the chain.
[[nodiscard]] Message unaddressed();
[[nodiscard]] Message disconnected(const QString& port);
/// Something else was to be looked at.
[[nodiscard]] Message openAlready();
[[nodiscard]] Message linkLost(const QString& port, const std::vector<ModuleIndex>& moving);
/// The link was given up, or is doubtful.
[[nodiscard]] Message badLink(const bus::HealthChanged& health);
[[nodiscard]] Message slowAdapter(int updatesPerSecond, int latencyMs);
/// What "How" answers; `file` holds the timer.
[[nodiscard]] Message latencyCure(const QString& file);
[[nodiscard]] Message adapterBack(const QString& port, bool sameSerial);
[[nodiscard]] Message differentAdapter(const QString& port);

// ---- the chain as a whole ----
[[nodiscard]] Message groupFailed(const bus::GroupFinished& finished);
[[nodiscard]] Message groupToldToStop(const bus::GroupFinished& finished);
[[nodiscard]] Message rateChanged(const bus::RateChanged& changed);
[[nodiscard]] Message rateNotChanged(const bus::RateChangeFailed& failed);

// ---- one module ----
[[nodiscard]] Message moduleUnresponsive(ModuleIndex module, double secondsSinceAnswer, bool wasMoving);
[[nodiscard]] Message restarted(const bus::ModuleRestarted& restarted, int modulesInChain);
[[nodiscard]] Message readdressed(const bus::Readdressed& readdressed);
[[nodiscard]] Message addressChanged(const bus::AddressChanged& changed);
[[nodiscard]] Message notReaddressed(const bus::ReaddressFailed& failed);
[[nodiscard]] Message refused(const bus::CommandRefused& refused);
[[nodiscard]] Message garbled(ModuleIndex module);
[[nodiscard]] Message motionSuspect(const bus::MotionSuspect& suspect);
/// Another host is on the line.
[[nodiscard]] Message foreignTraffic(const bus::ForeignTraffic& traffic);
[[nodiscard]] Message foreignMotion(const bus::ForeignMotion& motion);
[[nodiscard]] Message operationFailed(const bus::OperationFinished& finished);
/// `limit`: the position error limit in force, where it is known.
/// `cause`: what the advice is made for.
[[nodiscard]] Message tripped(ModuleIndex module, std::optional<int> limit,
                              TripCause cause = TripCause::Unknown);
[[nodiscard]] Message powerLost(ModuleIndex module);
/// PIC-SERVO: too much current.
[[nodiscard]] Message currentLimited(ModuleIndex module);
/// A servo that is to hold, and swings.
[[nodiscard]] Message swings(const ModuleState& module);
/// A limit switch closed while the motor moved, and nobody had asked for that. `limit`: 1 or 2.
[[nodiscard]] Message limitClosed(const ModuleState& module, int limit);
/// A limit stop that was armed has stopped the motor.
[[nodiscard]] Message limitStopTripped(ModuleIndex module, const HomeWatch& watch);
/// PIC-STEP: the motor stays on.
[[nodiscard]] Message estopActive(ModuleIndex module);
/// A PIC-STEP switched its motor off; `activity` says why, and each cause is another message.
[[nodiscard]] Message amplifierWentOff(ModuleIndex module, Activity activity);
[[nodiscard]] Message holdExpired(ModuleIndex module);
/// A request that the chip does not allow now, for a log or a command line; the window greys the control out.
[[nodiscard]] Message notPossible(ModuleIndex module, const QString& reason);
/// What would have run on beyond a limit of travel was told to stop.
[[nodiscard]] Message stoppedBeforeLimit(ModuleIndex module);

// ---- what is the case ----
/// All that is wrong with the modules of this connection: each message is there as long as its cause. Pure.
/// `runs`: a procedure runs with that module, which itself tells the chip to stop at a limit.
[[nodiscard]] std::vector<Message> standing(const LinkState& link, TimePoint now,
                                            const std::function<bool(ModuleIndex)>& runs = {});

// ---- procedures (homing, moves by N) ----
/// Nothing where it ended as its user asked, or by a stop.
[[nodiscard]] std::optional<Message> procedureEnded(const ProcedureReport& report, const AxisScale& scale);
/// Where it is, or how it ended: "Searching"...
[[nodiscard]] QString procedureStage(const ProcedureReport& report);
/// Why it ended, one sentence.
[[nodiscard]] QString procedureFailure(ProcedureFailure failure);
/// The same of a step, a square wave or a frequency response, with what to do.
[[nodiscard]] QString loopTestFailure(ProcedureFailure failure);
/// What a direction check has found, and what to do about it; plain text.
[[nodiscard]] QString directionFound(const DirectionFound& found);

// ---- what the scope keeps ----
/// The message with "Show the last 2 s" before its other buttons.
[[nodiscard]] Message withRecord(Message message);
/// Of what was kept around an incident: its headline and when it was.
[[nodiscard]] QString recordTitle(const QString& headline, const QTime& when);
/// What a stop of all motors is called there.
[[nodiscard]] QString stopOfAll();

// ---- stopping, closing, safety ----
/// `stopped`: motors moved, and were stopped while the panel was frozen.
[[nodiscard]] Message panelFroze(double seconds, bool stopped);
[[nodiscard]] Message machineSlept(double seconds, bool stopped);
/// A session before ended without a stop; `file` is what it has left. `toldByGuardian`: the modules that its
/// guardian has told to stop, where it had to.
[[nodiscard]] Message endedWhileMoving(const std::vector<ModuleIndex>& modules, const QString& port,
                                       const QString& file,
                                       const std::optional<std::vector<ModuleIndex>>& toldByGuardian = {});
/// The session before ended so, and its guardian told these modules to stop.
[[nodiscard]] Message guardianStoppedBefore(const std::vector<ModuleIndex>& modules);
/// This one stood still, and goes on.
[[nodiscard]] Message guardianStopped();
[[nodiscard]] Message guardianMissing(GuardianProblem problem);
/// `file`: where they belong.
[[nodiscard]] Message settingsNotSaved(const QString& file);
/// Of the log of messages.
[[nodiscard]] Message messagesNotKept(const FileError& error);
/// "1 stopped and holding, 2 were off, 22 ms." `modules`: what is known of them by now.
[[nodiscard]] Message stopResult(const bus::StopFinished& finished, const std::vector<ModuleState>& modules);
/// There were modules, and each is known to have stopped.
[[nodiscard]] bool allStopped(const bus::StopFinished& finished);
/// Goes behind the headline of the message that told of the stop: "It has stopped."
[[nodiscard]] QString stopConfirmed(const bus::OwedStopConfirmed& confirmed);
/// "reaches 5 of 5"
[[nodiscard]] QString stopReach(int reachable, int modules);
[[nodiscard]] QString closing(int movingMotors);
[[nodiscard]] QString stoppingBeforeClose();
[[nodiscard]] QString beforeRestart(int movingMotors);
[[nodiscard]] Message safety();
/// It blocks nothing, and may be behind the window by now.
[[nodiscard]] Message questionWaits(const QString& title, const QString& text);

// ---- the built-in simulator ----
/// What became of a control line, over its answer.
[[nodiscard]] QString simulatorDid(const QString& line);
[[nodiscard]] QString simulatorRefused(const QString& line);
[[nodiscard]] QString simulatorTold(const QString& line);

// ---- the packet monitor ----
/// What became of an exchange; a rejected one says why.
[[nodiscard]] QString verdict(const bus::ExchangeRecord& record);
/// Why a reply with a right sum was not believed; finishes "rejected: ".
[[nodiscard]] QString rejection(bus::Rejection rejection);
[[nodiscard]] QString purpose(bus::Purpose purpose);
/// "Module 1", "Group FF", "Address 3", or a dash.
[[nodiscard]] QString packetTarget(const bus::ExchangeRecord& record);
/// What stands above the lines of a saved text.
[[nodiscard]] QString packetTextHead(const PacketSession& session, quint64 dropped);
[[nodiscard]] QString packetGap();

// ---- the machine file ----
/// ""mill.json" line 12: Kp is 40000; the module takes 0 to 32767."
[[nodiscard]] QString fileProblem(const QString& file, const FileProblem& problem);
/// Without its folder; "unsaved changes" for what no file has.
[[nodiscard]] QString machineFileName(const QString& path);
[[nodiscard]] Message machineNotOpened(const QString& file, const FileProblem& problem);
[[nodiscard]] Message machineNotOpened(const FileError& error);
[[nodiscard]] Message machineNotSaved(const FileError& error);
/// What was to be written would not be read again.
[[nodiscard]] Message machineNotSaved(const QString& file, const FileProblem& problem);
/// What was applied of a file, and to how many modules something was sent.
[[nodiscard]] Message machineOpened(const QString& file, int parts, int sent);
/// The file says what is there already.
[[nodiscard]] Message machineSame(const QString& file);
/// Another session has left work; `machine` is its name or its file's, may be empty.
[[nodiscard]] Message unsavedWorkLeft(const QString& machine);
[[nodiscard]] Message unsavedWorkDamaged(const FileProblem& problem);
[[nodiscard]] Message unsavedWorkNotKept(const FileError& error);
/// The question before unsaved work gives way to something else.
[[nodiscard]] QString notSaved(const QString& machine);
/// Why the window does not close yet.
[[nodiscard]] QString beingSaved(const QString& machine);
[[nodiscard]] QString machinePart(MachinePart part);
/// `reversed`: of an axis whose lowest position is the chip's highest.
[[nodiscard]] QString machineField(const QString& key, bool reversed = false);
/// What stands in the file, or what there is now; `unknown` for what is neither.
[[nodiscard]] QString machineValue(const FieldDifference& field, const std::optional<FieldValue>& value,
                                   const AxisScale& scale, const QString& unknown);
/// What applying it does, or why it cannot be applied.
[[nodiscard]] QString machineApplying(const Difference& difference);
/// Why nothing can be sent while motors move.
[[nodiscard]] QString notSentWhileMoving(int movingMotors);

// ---- recordings, and what is exported ----
[[nodiscard]] Message recordingEnded(const QString& path, double seconds);
/// `seconds`: how long it went on.
[[nodiscard]] Message recordingFailed(const QString& path, const RecordingFailure& failure, double seconds);
/// ""mill.csv" line 12: position is "x", which is not a number."
[[nodiscard]] QString recordingProblem(const QString& file, const RecordingProblem& problem);
/// It was read only as far as there was no problem; `samples` of it are shown.
[[nodiscard]] Message recordingCut(const QString& path, const RecordingProblem& problem, quint64 samples);
[[nodiscard]] Message recordingWithoutSamples(const QString& path);
[[nodiscard]] Message recordingNotOpened(const FileError& error);
[[nodiscard]] Message exported(const QString& path);
[[nodiscard]] Message notExported(const FileError& error);

// ---- step responses that are kept ----
[[nodiscard]] Message runsNotRead(const QString& path, const FileProblem& problem);
[[nodiscard]] Message runsNotRead(const FileError& error);
[[nodiscard]] Message runsNotKept(const FileError& error);

// ---- the command line ----
[[nodiscard]] QString unknownPort(const QString& name, const QStringList& known);
[[nodiscard]] QString badBaud(const QString& text);
[[nodiscard]] QString badChain(const QString& chain, const QString& reason);
[[nodiscard]] QString unknownOption(const QString& option);
[[nodiscard]] QString readOnlyWithoutPort();
[[nodiscard]] QString noDisplay();

/// The keys of messages that end: for MainWindow::endMessage().
namespace key {
[[nodiscard]] QString question();
/// Of a stop of all that went well, until something moves again.
[[nodiscard]] QString stopped();
[[nodiscard]] QString port();
[[nodiscard]] QString link();
[[nodiscard]] QString badLink();
[[nodiscard]] QString unaddressed();
[[nodiscard]] QString silent(ModuleIndex module);
[[nodiscard]] QString refused(ModuleIndex module);
[[nodiscard]] QString garbled(ModuleIndex module);
/// How its last procedure ended, until the next begins.
[[nodiscard]] QString procedure(ModuleIndex module);
[[nodiscard]] QString tripped(ModuleIndex module);
[[nodiscard]] QString power(ModuleIndex module);
[[nodiscard]] QString current(ModuleIndex module);
[[nodiscard]] QString restarted(ModuleIndex module);
[[nodiscard]] QString stop();
[[nodiscard]] QString gone();
[[nodiscard]] QString endedWhileMoving(const QString& file);
[[nodiscard]] QString safety();
[[nodiscard]] QString machineFile();
[[nodiscard]] QString unsavedWork();
[[nodiscard]] QString recording();
[[nodiscard]] QString openedRecording();
[[nodiscard]] QString exported();
[[nodiscard]] QString runs();
[[nodiscard]] QString runsNotKept();
}  // namespace key

}  // namespace texts
}  // namespace nmc
