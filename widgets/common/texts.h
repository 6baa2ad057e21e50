// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
struct RowPlace;

/// The only table of sentences about events; window, log and command line all use it.
namespace texts {

// ---- the port and the link ----
[[nodiscard]] Message portProblem(const PortError& error);
[[nodiscard]] Message connectFailed(const bus::ConnectFailed& failed, const QString& port);
/// `lastName`: the user's name for the last module that answered; may be empty.
[[nodiscard]] Message fewerThanExpected(int found, int expected, const QString& lastName = {});
/// A module of the known chain does not answer at its address; `answering` others do.
[[nodiscard]] Message moduleMissing(ModuleIndex module, int answering, ModuleType type = ModuleType::Servo);
/// A missing module cannot be forgotten while motors move, because the chain would be searched for again.
[[nodiscard]] Message chainNotAccepted();
/// A missing module cannot be forgotten while the row sets, homes or waits for it.
[[nodiscard]] Message moduleStillUsed(const RowPlace& row, ModuleIndex module, bool otherType);
/// `knownAgain`: what this connection has sent to each of the modules is known and still holds.
[[nodiscard]] Message connected(const bus::ChainFound& found, const QString& port, bool knownAgain = false);
[[nodiscard]] Message echoNoticed(const QString& port);
[[nodiscard]] Message repliesInPieces(const QString& port, int gapMs);
/// A module without an address answers, in addition to the chain.
[[nodiscard]] Message unaddressed();
[[nodiscard]] Message disconnected(const QString& port);
/// The user wants to look at another port first, but one is already open.
[[nodiscard]] Message openAlready();
[[nodiscard]] Message linkLost(const QString& port, const std::vector<ModuleIndex>& moving);
/// The link is given up as unreliable, or is doubtful.
[[nodiscard]] Message badLink(const bus::HealthChanged& health);
[[nodiscard]] Message slowAdapter(int updatesPerSecond, int latencyMs);
/// The answer to "Show how"; `file` contains the latency timer.
[[nodiscard]] Message latencyCure(const QString& file);
[[nodiscard]] Message adapterBack(const QString& port, bool sameSerial);
[[nodiscard]] Message differentAdapter(const QString& port);

// ---- the chain as a whole ----
/// `modules`: those of the chain.
[[nodiscard]] Message groupFailed(const bus::GroupFinished& finished,
                                  const std::vector<ModuleState>& modules = {});
[[nodiscard]] Message groupCommandedToStop(const bus::GroupFinished& finished);
[[nodiscard]] Message rateChanged(const bus::RateChanged& changed);
[[nodiscard]] Message rateNotChanged(const bus::RateChangeFailed& failed);

// ---- one module ----
[[nodiscard]] Message moduleUnresponsive(ModuleIndex module, double secondsSinceAnswer, bool wasMoving,
                                         ModuleType type = ModuleType::Servo);
[[nodiscard]] Message restarted(const bus::ModuleRestarted& restarted, int modulesInChain,
                                ModuleType type = ModuleType::Servo);
[[nodiscard]] Message readdressed(const bus::Readdressed& readdressed);
[[nodiscard]] Message addressChanged(const bus::AddressChanged& changed);
[[nodiscard]] Message notReaddressed(const bus::ReaddressFailed& failed);
[[nodiscard]] Message refused(const bus::CommandRefused& refused);
[[nodiscard]] Message garbled(ModuleIndex module);
[[nodiscard]] Message motionSuspect(const bus::MotionSuspect& suspect);
/// Another host is sending on the line.
[[nodiscard]] Message foreignTraffic(const bus::ForeignTraffic& traffic);
[[nodiscard]] Message foreignMotion(const bus::ForeignMotion& motion);
[[nodiscard]] Message operationFailed(const bus::OperationFinished& finished);
/// `limit`: the position error limit in force, if known. `cause`: determines the advice.
[[nodiscard]] Message tripped(ModuleIndex module, std::optional<int> limit,
                              TripCause cause = TripCause::Unknown);
[[nodiscard]] Message powerLost(ModuleIndex module);
/// PIC-SERVO: the motor current was limited.
[[nodiscard]] Message currentLimited(ModuleIndex module);
/// A limit switch closed unexpectedly while the motor was moving. `limit`: 1 or 2.
[[nodiscard]] Message limitClosed(const ModuleState& module, int limit);
/// A PIC-STEP has switched its motor off; `activity` is the cause, and each cause has its own message.
[[nodiscard]] Message amplifierWentOff(ModuleIndex module, Activity activity);
[[nodiscard]] Message holdExpired(const bus::HoldExpired& expired);
/// A request is not possible now; where the window can, it disables the control instead.
[[nodiscard]] Message notPossible(ModuleIndex module, const QString& reason);
/// A motion that would have continued beyond a travel limit was sent a stop.
[[nodiscard]] Message stoppedBeforeLimit(ModuleIndex module);

// ---- states ----
/// Everything that is wrong with the modules of this connection; each message lasts as long as its cause.
/// Pure. `runs`: true if a procedure is running with the module, since procedures themselves use the chip's
/// stop at a limit.
[[nodiscard]] std::vector<Message> standing(const LinkState& link, TimePoint now,
                                            const std::function<bool(ModuleIndex)>& runs = {});

// ---- procedures (homing, moves by N) ----
/// The message about a procedure that has ended; empty if there is nothing to report, as after a cancelled
/// one.
[[nodiscard]] std::optional<Message> procedureEnded(const ProcedureReport& report, const AxisScale& scale);
/// The stage of a procedure, or how it ended: "Searching"...
[[nodiscard]] QString procedureStage(const ProcedureReport& report);
/// Why a procedure has failed, and what state it leaves.
[[nodiscard]] QString procedureFailure(ProcedureFailure failure);
/// The same for approaches of a switch or an index.
[[nodiscard]] QString repeatabilityFailure(ProcedureFailure failure);
/// Why a square wave, a frequency response or another loop test has failed, and what to do.
[[nodiscard]] QString loopTestFailure(ProcedureFailure failure);
/// What a direction check has found, and what to do about it; plain text.
[[nodiscard]] QString directionFound(const DirectionFound& found);

// ---- records of the scope ----
/// Returns the message with "Show the last 2 s" before its other buttons.
[[nodiscard]] Message withRecord(Message message);
/// The record of the message was dropped for newer ones; `most` are kept.
[[nodiscard]] Message recordNotKept(std::size_t most);
/// The title of a record kept around an incident: its headline and its time.
[[nodiscard]] QString recordTitle(const QString& headline, const QTime& when);
/// The headline of a record kept around a stop of all motors.
[[nodiscard]] QString stopOfAll();

// ---- stopping, closing, safety ----
/// `stopped`: motors were moving, and were stopped while the panel was frozen.
[[nodiscard]] Message panelFroze(double seconds, bool stopped);
[[nodiscard]] Message machineSlept(double seconds, bool stopped);
/// An earlier session ended without stopping its motors; `file` is the mark that it left.
/// `stoppedByGuardian`: the modules that its guardian sent a stop, if it had to.
[[nodiscard]] Message endedWhileMoving(const std::vector<ModuleIndex>& modules, const QString& port,
                                       const QString& file,
                                       const std::optional<std::vector<ModuleIndex>>& stoppedByGuardian = {});
/// An earlier session ended without stopping its motors, and its guardian sent these modules a stop.
[[nodiscard]] Message guardianStoppedBefore(const std::vector<ModuleIndex>& modules);
/// This session stalled and goes on; meanwhile, its guardian sent the motors a stop.
[[nodiscard]] Message guardianStopped();
[[nodiscard]] Message guardianMissing(GuardianProblem problem);
/// `file`: the settings file.
[[nodiscard]] Message settingsNotSaved(const QString& file);
/// The log of messages cannot be written.
[[nodiscard]] Message messagesNotKept(const FileError& error);
/// The positions of the axes, from which home is offered after a restart, cannot be written.
[[nodiscard]] Message positionsNotKept(const FileError& error);
/// A stop was requested after the port had gone.
[[nodiscard]] Message stopWaits();
/// "1 stopped and holding, 2 were off, 22 ms." `modules`: their present state.
[[nodiscard]] Message stopResult(const bus::StopFinished& finished, const std::vector<ModuleState>& modules);
/// True if there were modules, and each is known to have stopped, or is off because it has restarted.
[[nodiscard]] bool allStopped(const bus::StopFinished& finished, const std::vector<ModuleState>& modules);
/// "Modules 1, 2 were commanded to stop."
[[nodiscard]] QString commandedToStop(const std::vector<ModuleIndex>& modules);
/// Appended to the headline of the message that reported the stop: "It has stopped."
[[nodiscard]] QString stopConfirmed(const bus::OwedStopConfirmed& confirmed);
/// "reaches 5 of 5"
[[nodiscard]] QString stopReach(int reachable, int modules);
[[nodiscard]] QString closing(int movingMotors);
[[nodiscard]] QString stoppingBeforeClose();
[[nodiscard]] QString beforeRestart(int movingMotors);
[[nodiscard]] Message safety();
/// A question waits for an answer; since it blocks nothing, it may be hidden behind the window.
[[nodiscard]] Message questionWaits(const QString& title, const QString& text);

// ---- the built-in simulator ----
/// The result of a control line, shown above its answer.
[[nodiscard]] QString simulatorDid(const QString& line);
[[nodiscard]] QString simulatorRefused(const QString& line);
[[nodiscard]] QString simulatorAnswered(const QString& line);

// ---- the packet monitor ----
/// The result of an exchange, with the reason if it was rejected.
[[nodiscard]] QString verdict(const bus::ExchangeRecord& record);
/// Why a reply with a correct checksum was rejected; follows "rejected: ".
[[nodiscard]] QString rejection(bus::Rejection rejection);
[[nodiscard]] QString purpose(bus::Purpose purpose);
/// "Module 1", "Group FF", "Address 3", or a dash.
[[nodiscard]] QString packetTarget(const bus::ExchangeRecord& record);
/// The head of packets saved as text.
[[nodiscard]] QString packetTextHead(const PacketSession& session, quint64 dropped);
[[nodiscard]] QString packetGap();

// ---- the machine file ----
/// ""mill.json" line 12: Kp is 40000; the module takes 0 to 32767."
[[nodiscard]] QString fileProblem(const QString& file, const FileProblem& problem);
/// The name of a file without its folder; "unsaved changes" if there is no file.
[[nodiscard]] QString machineFileName(const QString& path);
[[nodiscard]] Message machineNotOpened(const QString& file, const FileProblem& problem);
[[nodiscard]] Message machineNotOpened(const FileError& error);
[[nodiscard]] Message machineNotSaved(const FileError& error);
/// The file was not written, because it could not have been opened again.
[[nodiscard]] Message machineNotSaved(const QString& file, const FileProblem& problem);
/// `parts`: how many settings of the file were applied. `sent`: how many commands were sent.
[[nodiscard]] Message machineOpened(const QString& file, int parts, int sent);
[[nodiscard]] Message axisCopied(ModuleIndex from, int parts, int sent);
/// Nothing was applied, because motors move or, if none does, because the table did not hold any more and is
/// shown anew.
[[nodiscard]] Message machineNotApplied(int movingMotors);
/// The file does not differ from the present settings.
[[nodiscard]] Message machineSame(const QString& file);
/// An earlier session left unsaved changes; `machine` is the name of the machine or of its file, and may be
/// empty.
[[nodiscard]] Message unsavedWorkLeft(const QString& machine);
[[nodiscard]] Message unsavedWorkDamaged(const FileProblem& problem);
[[nodiscard]] Message unsavedWorkNotKept(const FileError& error);
/// The question to be answered before the user leaves unsaved changes.
[[nodiscard]] QString notSaved(const QString& machine);
/// Why the window does not close yet.
[[nodiscard]] QString beingSaved(const QString& machine);
[[nodiscard]] QString machinePart(MachinePart part);
/// `reversed`: the lowest position of the axis is the chip's highest.
[[nodiscard]] QString machineField(const QString& key, bool reversed = false);
/// A value from the file, or the present one; `unknown` if there is none.
[[nodiscard]] QString machineValue(const FieldDifference& field, const std::optional<FieldValue>& value,
                                   const AxisScale& scale, const QString& unknown);
/// What applying a difference does, or why it cannot be applied.
[[nodiscard]] QString machineApplying(const Difference& difference);
/// Why nothing can be sent while motors move.
[[nodiscard]] QString notSentWhileMoving(int movingMotors);

// ---- recordings and exports ----
/// No chain is connected.
[[nodiscard]] Message recordingNotBegun(const QString& path);
[[nodiscard]] Message recordingEnded(const QString& path, double seconds);
[[nodiscard]] Message recordingFailed(const QString& path, const RecordingFailure& failure);
/// ""mill.csv" line 12: position is "x", which is not a number."
[[nodiscard]] QString recordingProblem(const QString& file, const RecordingProblem& problem);
/// The recording was read only up to the problem; `samples` of it are shown.
[[nodiscard]] Message recordingCut(const QString& path, const RecordingProblem& problem, quint64 samples);
[[nodiscard]] Message recordingWithoutSamples(const QString& path);
[[nodiscard]] Message recordingNotOpened(const FileError& error);
[[nodiscard]] Message exported(const QString& path);
[[nodiscard]] Message notExported(const FileError& error);

// ---- saved step responses ----
[[nodiscard]] Message runsNotRead(const QString& path, const FileProblem& problem);
[[nodiscard]] Message runsNotRead(const FileError& error);
[[nodiscard]] Message runsNotKept(const FileError& error);

// ---- the command line ----
[[nodiscard]] QString unknownPort(const QString& name, const QStringList& known);
[[nodiscard]] QString badBaud(const QString& text);
[[nodiscard]] QString badChain(const QString& chain, const QString& reason);
[[nodiscard]] QString unknownOption(const QString& option);
[[nodiscard]] QString badServe();
[[nodiscard]] QString readOnlyWithoutPort();
[[nodiscard]] QString noDisplay();

/// The key of a message about one module.
[[nodiscard]] QString ofModule(const QString& what, ModuleIndex module);
/// Keys of messages that end, for MainWindow::endMessage().
namespace key {
inline const QString kQuestion = QStringLiteral("question");
/// A successful stop of all motors, until something moves again.
inline const QString kStopped = QStringLiteral("stopped");
inline const QString kPort = QStringLiteral("port");
inline const QString kSlowAdapter = QStringLiteral("slowAdapter");
inline const QString kLink = QStringLiteral("link");
inline const QString kBadLink = QStringLiteral("badLink");
inline const QString kUnaddressed = QStringLiteral("unaddressed");
inline const QString kStop = QStringLiteral("stop");
inline const QString kStopWaits = QStringLiteral("stopWaits");
inline const QString kGone = QStringLiteral("gone");
[[nodiscard]] QString endedWhileMoving(const QString& file);
inline const QString kSafety = QStringLiteral("safety");
inline const QString kMachineFile = QStringLiteral("machineFile");
inline const QString kNotApplied = QStringLiteral("notApplied");
inline const QString kMessageLog = QStringLiteral("messageLog");
inline const QString kUnsavedWork = QStringLiteral("unsavedWork");
inline const QString kRecording = QStringLiteral("recording");
inline const QString kOpenedRecording = QStringLiteral("openedRecording");
inline const QString kExported = QStringLiteral("exported");
inline const QString kNotExported = QStringLiteral("notExported");
inline const QString kRuns = QStringLiteral("runs");
inline const QString kRunsNotKept = QStringLiteral("runsNotKept");
// The next ones are about one module: ofModule() adds its number.
inline const QString kSilent = QStringLiteral("silent");
/// How the module's last procedure ended, until the next one begins.
inline const QString kProcedure = QStringLiteral("procedure");
/// The offer to restore home from where the axis was last seen.
inline const QString kPosition = QStringLiteral("position");
}  // namespace key

}  // namespace texts
}  // namespace nmc
