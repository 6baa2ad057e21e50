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
    CopyCommand,  ///< done by the window
    WorkWith,
    How,
    ClearAndStayOff,
    SwitchOff,
    GainsBefore,
    RestartNetwork,  ///< the window asks first
    Reconnect,
    ConnectOffered,  ///< connects to the adapter that was found
    StopAll,         ///< done by the window
    Understood,      ///< done by the window
    LookedAt,        ///< the user has checked motors that a session left moving
    RestoreWork,
    DiscardWork,
    ShowRecord,
    LookFirst,  ///< connects read-only
    ConnectFully,
    TakePosition,    ///< restores home from the remembered position of an axis
    ForgetPosition,  ///< discards the remembered position
    ShowQuestion,    ///< done by the window
};
Q_ENUM_NS(MessageAction)

/// A message to the user about one cause; repeats are counted under its key (interface.md, "Words").
struct Message {
    struct Action {
        MessageAction id;
        QString text;      ///< a verb phrase
        QString reason{};  ///< why it is disabled for now: operator mode

        bool operator==(const Action&) const = default;
    };
    /// How it relates to the previous message with the same key if their headlines differ. With the same
    /// headline, it is always a repeat.
    enum class Relation : std::uint8_t {
        NewCause,  ///< ends the previous message, which stays in the list
        Repeat,    ///< says the same in other words, such as another number of milliseconds
        Update,    ///< a later state of the same thing: replaces the previous message, and is not counted
    };
    QString key{};
    std::optional<ModuleIndex> module{};  ///< the module that it is about
    Severity severity = Severity::Normal;
    QString headline{};  ///< what it means for the motor or the job
    QString body{};      ///< the likely cause, then what to do now
    QList<Action> actions{};
    QString command{};    ///< what "Copy command" copies
    QString details{};    ///< the system's own message, or raw bytes
    unsigned record = 0;  ///< what "Show the last 2 s" shows (app/flightcontroller.h); 0: nothing
    /// True for a state, which lasts until the message is ended; false for an event, which is old news after
    /// a while.
    bool stands = false;
    Relation relation = Relation::NewCause;
    /// LinkState::connection when it was shown, so that its buttons act on that connection only; 0: it was
    /// shown without a connection.
    std::uint32_t connection = 0;

    [[nodiscard]] bool offers(MessageAction action) const;
    bool operator==(const Message&) const = default;
};

/// The only place that decides whether a button may act. A button that sends to modules or concerns the chain
/// acts only in the connection of its message, while that is open; one that looks for the chain, also after
/// that, until there is another connection; one that sends anything but a stop does not act in a read-only
/// connection.
[[nodiscard]] bool mayAct(const Message& message, MessageAction action, const LinkState& link);
/// Returns the message without the buttons that may not act, and never may again. Buttons that an operator
/// may not use stay, with the reason.
[[nodiscard]] Message withoutImpossible(Message message, const LinkState& link);
/// The end of the object name of its button: "retry".
[[nodiscard]] QString objectName(MessageAction action);

}  // namespace nmc
