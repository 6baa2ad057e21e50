// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/module/linkstate.h"
#include "model/settings/machine.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace nmc {

class NumberField;
class Requests;

/// Shows and sets the address of each module, the group that it listens to, and the leader of a group. Sends
/// commands that a whole group carries out in the same tick: start the loaded moves, stop, save home, set the
/// position to 0, clear sticky bits (DS-V 4.1).
class GroupsPage : public QWidget {
    Q_OBJECT

public:
    explicit GroupsPage(Requests& requests, QWidget* parent = nullptr);

    /// Emits nothing.
    void showLink(const LinkState& link, const std::vector<GroupSettings>& groups);

private:
    enum Column { Name, AddressLabel, Address, Group, Leader, Load };
    struct Member {
        QLabel* name = nullptr;
        QLabel* addressLabel = nullptr;
        NumberField* address = nullptr;
        QComboBox* group = nullptr;
        QCheckBox* leader = nullptr;
        QLabel* load = nullptr;
    };
    void addMember();
    void showMember(const Member& row, const ModuleState& module);
    void changed(std::size_t row);
    void readdress(std::size_t row);
    [[nodiscard]] QString whyNotAddress(const ModuleState& module) const;
    void command(bus::GroupCommand::Action action);
    void offerGroups();
    void showNames();
    void nameGroup();
    [[nodiscard]] QString nameOf(int group) const;
    /// "Group 81 "Table""
    [[nodiscard]] QString titleOf(int group) const;
    void refreshCommands();
    /// The member that cannot do this now, and why; empty if all members can.
    [[nodiscard]] QString whyNotAll(IntentKind kind) const;
    [[nodiscard]] QString questionBeforeReset() const;
    void askBeforeReset();
    [[nodiscard]] std::uint8_t group() const;
    [[nodiscard]] QPushButton* newCommand(const QString& text, const QString& objectName,
                                          const QString& accessibleName, bus::GroupCommand::Action action);

    Requests& m_requests;
    std::vector<Member> m_members;
    QGridLayout* m_grid = nullptr;
    QLabel* m_none = nullptr;
    QLabel* m_addressReason = nullptr;
    QComboBox* m_group = nullptr;
    QLineEdit* m_name = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_saveHome = nullptr;
    QPushButton* m_stopSmoothly = nullptr;
    QPushButton* m_stopAbruptly = nullptr;
    QPushButton* m_motorOff = nullptr;
    QPushButton* m_clear = nullptr;
    QPushButton* m_reset = nullptr;
    LinkState m_link;
    std::vector<GroupSettings> m_groups;
};

}  // namespace nmc
