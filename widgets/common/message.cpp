// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/message.h"

#include <QMetaEnum>
#include <algorithm>

#include "model/intent/rights.h"
#include "widgets/common/words.h"

namespace nmc {

bool Message::offers(MessageAction action) const {
    return std::any_of(actions.begin(), actions.end(), [action](const Action& a) { return a.id == action; });
}

namespace {

/// What an action requires besides its message.
struct Needs {
    bool ownChain = false;              ///< the chain that the message is about
    bool noOtherChain = false;          ///< nothing was connected to since
    bool sending = false;               ///< a connection that is not read-only
    bool machine = false;               ///< it changes the machine or the chain, which an operator may not do
    std::optional<IntentKind> right{};  ///< the right that an operator needs, as for the same control
};

Needs needsOf(MessageAction action) {
    switch (action) {
        case MessageAction::Readdress:
        case MessageAction::RestartNetwork:
            return {.ownChain = true, .sending = true, .machine = true};
        case MessageAction::ClearAndStayOff:
            return {.ownChain = true, .sending = true, .right = IntentKind::ClearStickyBits};
        case MessageAction::SwitchOff:
            return {.ownChain = true, .sending = true};
        case MessageAction::GainsBefore:
            return {.ownChain = true, .sending = true, .right = IntentKind::ApplyGains};
        case MessageAction::TakePosition:
            return {.ownChain = true, .sending = true, .right = IntentKind::SaveAsHome};
        case MessageAction::ForgetPosition:
            return {.ownChain = true, .right = IntentKind::SaveAsHome};
        case MessageAction::WorkWith:
            return {.ownChain = true, .machine = true};
        case MessageAction::StopAll:
            return {.ownChain = true};
        case MessageAction::RestoreWork:
        case MessageAction::DiscardWork:
            return {.machine = true};
        case MessageAction::ScanAgain:
        case MessageAction::Reconnect:
            return {.noOtherChain = true};
        case MessageAction::Retry:
        case MessageAction::UseSimulator:
        case MessageAction::ChoosePort:
        case MessageAction::CopyCommand:
        case MessageAction::How:
        case MessageAction::ConnectOffered:
        case MessageAction::Understood:
        case MessageAction::LookedAt:
        case MessageAction::ShowRecord:
        case MessageAction::LookFirst:
        case MessageAction::ConnectFully:
        case MessageAction::ShowQuestion:
            break;
    }
    return {};
}

bool isLeft(MessageAction action, const OperatorRights& rights) {
    const Needs needs = needsOf(action);
    return !needs.machine && (!needs.right || allows(rights, *needs.right));
}

}  // namespace

bool mayAct(const Message& message, MessageAction action, const LinkState& link) {
    const Needs needs = needsOf(action);
    const bool last = message.connection == link.connection;
    return (!needs.ownChain || (last && link.isOpen())) && (!needs.noOtherChain || last) &&
           (!needs.sending || (!link.readOnly && !link.lent));
}

Message withoutImpossible(Message message, const LinkState& link) {
    message.actions.removeIf([&](const Message::Action& a) { return !mayAct(message, a.id, link); });
    for (Message::Action& action : message.actions)
        action.reason = link.rights && !isLeft(action.id, *link.rights)
                            ? texts::refusal(Refusal::OperatorMode)
                            : QString();
    return message;
}

QString objectName(MessageAction action) {
    QString name =
        QString::fromLatin1(QMetaEnum::fromType<MessageAction>().valueToKey(static_cast<int>(action)));
    name.front() = name.front().toLower();
    return name;
}

}  // namespace nmc
