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

/// What changes the machine or the chain is not left to an operator; the rest is as for the controls.
bool isLeft(MessageAction action, const OperatorRights& rights) {
    switch (action) {
        case MessageAction::Readdress:
        case MessageAction::RestartNetwork:
        case MessageAction::WorkWith:
        case MessageAction::RestoreWork:
        case MessageAction::DiscardWork:
            return false;
        case MessageAction::TakePosition:
        case MessageAction::ForgetPosition:
            return allows(rights, Request::SaveAsHome);
        case MessageAction::ClearAndStayOff:
            return allows(rights, Request::ClearStickyBits);
        case MessageAction::StopAll:
        case MessageAction::Retry:
        case MessageAction::ScanAgain:
        case MessageAction::UseSimulator:
        case MessageAction::ChoosePort:
        case MessageAction::CopyCommand:
        case MessageAction::How:
        case MessageAction::Reconnect:
        case MessageAction::ConnectOffered:
        case MessageAction::Understood:
        case MessageAction::LookedAt:
        case MessageAction::ShowRecord:
        case MessageAction::LookFirst:
        case MessageAction::ConnectFully:
            break;
    }
    return true;
}

}  // namespace

bool mayAct(const Message& message, MessageAction action, const LinkState& link) {
    const bool own = link.phase != LinkPhase::Disconnected && message.connection == link.connection;
    switch (action) {
        case MessageAction::Readdress:
        case MessageAction::ClearAndStayOff:
        case MessageAction::SwitchOff:
        case MessageAction::GainsBefore:
        case MessageAction::RestartNetwork:
        case MessageAction::TakePosition:
            return own && !link.readOnly;
        case MessageAction::StopAll:
        case MessageAction::WorkWith:
        case MessageAction::ForgetPosition:
            return own;
        case MessageAction::Retry:
        case MessageAction::ScanAgain:
        case MessageAction::UseSimulator:
        case MessageAction::ChoosePort:
        case MessageAction::CopyCommand:
        case MessageAction::How:
        case MessageAction::Reconnect:
        case MessageAction::ConnectOffered:
        case MessageAction::Understood:
        case MessageAction::LookedAt:
        case MessageAction::RestoreWork:
        case MessageAction::DiscardWork:
        case MessageAction::ShowRecord:
        case MessageAction::LookFirst:
        case MessageAction::ConnectFully:
            break;
    }
    return true;
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
