// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "link/api/apiserverproblem.h"
#include "link/terminal/linelent.h"
#include "model/api/apimethods.h"
#include "model/module/linkstate.h"
#include "widgets/common/message.h"

namespace nmc {

/// What the window shows of other programs that use the chain.
struct ProgramsShown {
    bool on = false;      ///< they may connect
    QString path{};       ///< the socket; empty while there is none
    bool failed = false;  ///< there is none although a port is open
    int connected = 0;
    QString inControl{};  ///< the one that may move motors; empty: none
};

}  // namespace nmc

/// What is said about other programs: to the user, and to them (docs/api.md).
namespace nmc::texts {

/// Why a call is not possible.
[[nodiscard]] QString apiProblem(const api::Problem& problem);
/// The refusal that a program without the right to move motors gets.
[[nodiscard]] QString noControl();
[[nodiscard]] QString helloFirst();
[[nodiscard]] QString otherProtocol(const QString& theirs, const QString& ours);

/// A request was not carried out to the end.
[[nodiscard]] QString wasCancelled();
/// A motor does not stay within its tolerance of the goal.
[[nodiscard]] QString didNotSettle();

/// Why a program has lost the right to move motors.
enum class ControlLost : std::uint8_t { Stopped, TakenBack, Commanded, Disconnected };
[[nodiscard]] QString controlLost(ControlLost why);

[[nodiscard]] Message apiClosed(const ApiServerProblem& problem);
[[nodiscard]] Message programConnected(const QString& program);
/// `stops`: motors that it had moved are stopped.
[[nodiscard]] Message programGone(const QString& program, bool stops);
/// A program has requested something of a motor; `call` is the method with its parameters.
[[nodiscard]] Message programCalled(const QString& program, const QString& call);

/// What has become of the line that is lent to a program (docs/lending.md).
[[nodiscard]] Message lineLent(const LineLent& lent);
[[nodiscard]] Message notLent(const LendingProblem& problem);
/// The bar over the window while it is lent.
[[nodiscard]] QString lentTo(const LentLine& lent);

}  // namespace nmc::texts
