// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the parts of the table of texts share; for widgets/common/*texts.cpp and *words.cpp only.

#include <QCoreApplication>

#include "widgets/common/texts.h"

namespace nmc::texts {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(Texts)
};

[[nodiscard]] Message::Action retry();
[[nodiscard]] Message::Action scanAgain();
[[nodiscard]] Message::Action useSimulator();
[[nodiscard]] Message::Action choosePort();
[[nodiscard]] Message::Action restartNetwork();
[[nodiscard]] Message::Action connectFully();
[[nodiscard]] Message::Action lookFirst();
/// Why a file was not read or written, and what to do.
[[nodiscard]] QString fileProblem(const FileError& error);
/// The number that determines singular or plural in a sentence about these modules.
[[nodiscard]] inline int howMany(const std::vector<ModuleIndex>& modules) {
    return static_cast<int>(modules.size());
}
/// The number as it would be typed into a file.
[[nodiscard]] inline QString plainNumber(double number) {
    return QString::number(number, 'g', 12);
}
/// What a module of this type has lost by a restart.
[[nodiscard]] QString lostByRestart(ModuleIndex module, ModuleType type);
/// The words of a message.
struct Words {
    QString headline;
    QString body;
    Severity severity = Severity::Attention;
};
/// A message about one module; `what` makes its key.
[[nodiscard]] Message about(const QString& what, ModuleIndex module, const Words& words,
                            const QList<Message::Action>& actions = {});
/// True if the motor is free to turn, or its state is unknown.
[[nodiscard]] constexpr bool freeOrUnknown(ProcedureFailure failure) {
    using enum ProcedureFailure;
    return failure == WentOff || failure == Unstable || failure == ModuleUnresponsive;
}
/// What is known about the motors when the link has failed.
[[nodiscard]] QString movingSentence(const std::vector<ModuleIndex>& moving);

}  // namespace nmc::texts
