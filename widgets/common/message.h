// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

#include "model/module/linkstate.h"

namespace nmc {

Q_NAMESPACE

/// What a button of a message does.
enum class MessageAction : std::uint8_t {
    Retry,
    Readdress,
    ScanAgain,
    UseSimulator,
    ChoosePort,   ///< done by the window
    CopyCommand,  ///< likewise
    WorkWith,
    How,
    ClearAndStayOff,
    SwitchOff,
    GainsBefore,
    RestartNetwork,  ///< the window asks before it
    Reconnect,
    ConnectOffered,  ///< an adapter that is back
    StopAll,         ///< the window's
    Understood,      ///< likewise
    LookedAt,        ///< at motors that a session left moving
    RestoreWork,
    DiscardWork,
    ShowRecord,
    LookFirst,  ///< connects read-only
    ConnectFully,
    TakePosition,    ///< that was remembered of an axis
    ForgetPosition,  ///< likewise
    ShowQuestion,    ///< the window's
};
Q_ENUM_NS(MessageAction)

/// Something to tell the user: one cause, whose repeats are counted under its key (interface.md, "Words").
struct Message {
    struct Action {
        MessageAction id;
        QString text;      ///< a verb that finishes the sentence
        QString reason{};  ///< why it does not act now, but may again: operator mode
    };
    QString key{};
    std::optional<ModuleIndex> module{};  ///< that it is about
    Severity severity = Severity::Normal;
    QString headline{};  ///< what it means for the motor or the job
    QString body{};      ///< the likely cause, then what to do now
    QList<Action> actions{};
    QString command{};  ///< what "Copy command" copies
    QString details{};  ///< the system's own words, raw bytes
    /// It is the case until it is ended; what is not is an event, and old news after a while.
    bool stands = false;
    /// What was told before under this key gives way to it, whatever it said.
    bool replaces = false;
    /// LinkState::connection when it was shown, by which the window knows whom a button would act on; 0: it
    /// was shown without a connection.
    std::uint32_t connection = 0;

    [[nodiscard]] bool offers(MessageAction action) const;
};

/// The one place that decides whether a button may act: what tells modules something, or is about the chain
/// that is there, acts in the message's own connection only, as long as that is open; and what tells modules
/// something but a stop, not in one that only looks.
[[nodiscard]] bool mayAct(const Message& message, MessageAction action, const LinkState& link);
/// The message without the buttons that may not act; such a button never may again. What is not left to an
/// operator stays, and says so.
[[nodiscard]] Message withoutImpossible(Message message, const LinkState& link);
/// "retry": what the object name of its button ends with.
[[nodiscard]] QString objectName(MessageAction action);

}  // namespace nmc
