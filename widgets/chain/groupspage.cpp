// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/groupspage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <set>

#include "widgets/common/doctortexts.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr std::uint8_t kNoGroup = 0xFF;  // everybody's
constexpr std::uint8_t kFirstGroup = 0x81;
constexpr std::uint8_t kLastGroup = 0x88;  // more than enough for 32 modules
constexpr int kUnknown = -1;
enum Column { Name, Group, Leader, Load };
}  // namespace

GroupsPage::GroupsPage(QWidget* parent) : QWidget(parent) {
    look::name(this, u"groupsPage"_s, tr("Groups"));
    const int unit = look::gridUnit(this);
    auto* remark =
        look::newMutedLabel(tr("A module listens to one group besides its own address. A command to "
                               "a group is carried out by all its members in the same tick; its "
                               "leader, if it has one, answers for them."),
                            this);
    remark->setWordWrap(true);
    m_none = look::newMutedLabel(tr("No modules yet: connect first."), this);
    m_none->setObjectName(u"noGroupsLabel"_s);
    m_grid = new QGridLayout;
    m_grid->setHorizontalSpacing(unit * 2);
    m_grid->setVerticalSpacing(unit / 2);
    m_grid->setColumnStretch(Load, 1);

    m_group = new QComboBox(this);
    look::name(m_group, u"groupBox"_s, tr("Group to be commanded"));
    m_group->setToolTip(tr("Which group the two buttons are for."));
    m_name = new QLineEdit(this);
    look::name(m_name, u"groupNameField"_s, tr("Name of the group"));
    m_name->setMaxLength(40);
    m_name->setPlaceholderText(tr("Name"));
    m_start = new QPushButton(icons::tinted(u"player-play"_s), tr("St&art loaded moves"), this);
    look::name(m_start, u"groupStartButton"_s, tr("Start the loaded moves of this group"));
    m_saveHome = new QPushButton(icons::tinted(u"home"_s), tr("Save &home"), this);
    look::name(m_saveHome, u"groupHomeButton"_s, tr("Save the present positions of this group as home"));
    auto* commands = new QHBoxLayout;
    commands->setSpacing(unit);
    commands->addWidget(m_group);
    commands->addWidget(m_name, 1);
    commands->addWidget(m_start);
    commands->addWidget(m_saveHome);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit, unit, unit);
    layout->setSpacing(unit);
    layout->addWidget(remark);
    layout->addWidget(m_none);
    layout->addLayout(m_grid);
    layout->addLayout(commands);
    layout->addStretch(1);
    connect(m_group, &QComboBox::currentIndexChanged, this, &GroupsPage::refreshCommands);
    connect(m_name, &QLineEdit::editingFinished, this, &GroupsPage::nameGroup);
    connect(m_start, &QPushButton::clicked, this,
            [this] { command(bus::GroupCommand::Action::StartMotion); });
    connect(m_saveHome, &QPushButton::clicked, this,
            [this] { command(bus::GroupCommand::Action::SaveAsHome); });
    showLink({}, {});
}

void GroupsPage::addMember() {
    const std::size_t row = m_members.size();
    const int number = static_cast<int>(row) + 1;
    Member member;
    member.name = new QLabel(this);
    member.group = new QComboBox(this);
    look::name(member.group, u"group%1Box"_s.arg(number), tr("Group of module %1").arg(number));
    member.group->setToolTip(tr("The group this module listens to. Sent at once; nothing moves."));
    member.group->addItem(texts::groupName(kNoGroup), kNoGroup);
    for (int group = kFirstGroup; group <= kLastGroup; ++group)
        member.group->addItem(titleOf(group), group);
    member.leader = new QCheckBox(tr("leads"), this);
    look::name(member.leader, u"leader%1Box"_s.arg(number), tr("Module %1 leads its group").arg(number));
    member.load = look::newMutedLabel({}, this);
    member.load->setObjectName(u"load%1Label"_s.arg(number));
    m_grid->addWidget(member.name, number, Name);
    m_grid->addWidget(member.group, number, Group);
    m_grid->addWidget(member.leader, number, Leader);
    m_grid->addWidget(member.load, number, Load);
    connect(member.group, &QComboBox::activated, this, [this, row] { changed(row); });
    connect(member.leader, &QCheckBox::clicked, this, [this, row] { changed(row); });
    m_members.push_back(member);
}

void GroupsPage::showMember(const Member& row, const ModuleState& module) {
    const auto& place = module.info.group;
    look::setText(row.name, texts::moduleName(module.info.index));
    const QSignalBlocker groupBlocker(row.group);
    const QSignalBlocker leaderBlocker(row.leader);
    int index = row.group->findData(place ? place->group : kUnknown);
    if (index < 0) {
        const QString text = place ? titleOf(place->group) : tr("unknown");
        row.group->addItem(text, place ? place->group : kUnknown);
        index = row.group->count() - 1;
    }
    row.group->setCurrentIndex(index);
    row.leader->setChecked(place && place->leader);
    const bool connected = m_link.phase == LinkPhase::Connected && !module.silent && !module.hasRestarted;
    const auto refusal = whyNotTold(m_link);
    const QString reason = !connected ? texts::refusal(Refusal::Silent)
                           : refusal  ? texts::refusal(*refusal)
                                      : QString();
    look::setPossible(row.group, reason,
                      tr("The group this module listens to. Sent at once; nothing moves."));
    look::setPossible(row.leader,
                      !reason.isEmpty()                   ? reason
                      : place && place->group != kNoGroup ? QString()
                                                          : tr("Choose a group first."),
                      tr("This module answers for its group; a group has one leader at most."));
    look::setText(row.load, module.loadWaiting ? tr("move loaded") : QString());
}

void GroupsPage::showLink(const LinkState& link, const std::vector<GroupSettings>& groups) {
    m_link = link;
    m_groups = groups;
    while (m_members.size() < link.modules.size())
        addMember();
    for (std::size_t i = 0; i < m_members.size(); ++i) {
        const bool there = i < link.modules.size();
        for (QWidget* widget :
             {static_cast<QWidget*>(m_members[i].name), static_cast<QWidget*>(m_members[i].group),
              static_cast<QWidget*>(m_members[i].leader), static_cast<QWidget*>(m_members[i].load)})
            widget->setVisible(there);
        if (there)
            showMember(m_members[i], link.modules[i]);
    }
    m_none->setVisible(link.modules.empty());
    offerGroups();
    showNames();
    refreshCommands();
}

QString GroupsPage::nameOf(int group) const {
    const auto named = std::find_if(m_groups.begin(), m_groups.end(),
                                    [group](const GroupSettings& g) { return g.address == group; });
    return named != m_groups.end() ? QString::fromStdString(named->name) : QString();
}

QString GroupsPage::titleOf(int group) const {
    const QString title = texts::groupName(static_cast<std::uint8_t>(group));
    const QString name = nameOf(group);
    return name.isEmpty() ? title : title + u" \""_s + name + u'"';
}

/// Wherever a group is offered.
void GroupsPage::showNames() {
    std::vector<QComboBox*> boxes{m_group};
    for (const Member& member : m_members)
        boxes.push_back(member.group);
    for (QComboBox* box : boxes)
        for (int i = 0; i < box->count(); ++i)
            if (const int group = box->itemData(i).toInt(); group != kUnknown)
                box->setItemText(i, titleOf(group));
}

void GroupsPage::nameGroup() {
    const QVariant group = m_group->currentData();
    const QString name = m_name->text().simplified();
    if (group.isValid() && name != nameOf(group.toInt()))
        emit groupNamed(static_cast<quint8>(group.toInt()), name);
}

/// The groups in use, in order.
void GroupsPage::offerGroups() {
    std::set<std::uint8_t> used;
    for (const ModuleState& module : m_link.modules)
        if (module.info.group && module.info.group->group != kNoGroup)
            used.insert(module.info.group->group);
    std::set<std::uint8_t> offered;
    for (int i = 0; i < m_group->count(); ++i)
        offered.insert(static_cast<std::uint8_t>(m_group->itemData(i).toInt()));
    if (used == offered)
        return;
    const QSignalBlocker blocker(m_group);
    const QVariant chosen = m_group->currentData();
    m_group->clear();
    for (const std::uint8_t group : used)
        m_group->addItem(titleOf(group), group);
    m_group->setCurrentIndex(qMax(0, m_group->findData(chosen)));
}

QString GroupsPage::whyNotStart(std::uint8_t group) const {
    for (const ModuleState& module : m_link.modules) {
        if (!module.info.group || module.info.group->group != group)
            continue;
        if (const auto refusal = whyNot(Request::StartLoaded, module))
            return tr("%1: %2").arg(texts::moduleName(module.info.index), texts::refusal(*refusal));
    }
    return {};
}

void GroupsPage::refreshCommands() {
    const bool any = m_group->count() > 0 && m_link.phase == LinkPhase::Connected;
    const QString none = tr("No module is in a group yet.");
    const auto refusal = whyNotTold(m_link);
    const QString notTold = refusal ? texts::refusal(*refusal) : QString();
    const auto group = static_cast<std::uint8_t>(m_group->currentData().toInt());
    look::setPossible(
        m_start, any ? whyNotStart(group) : none,
        tr("Starts the moves that all members have loaded, in the same tick. Withheld unless every "
           "member has confirmed its load."));
    look::setPossible(
        m_saveHome, any ? notTold : none,
        tr("Each member captures its present position as home, in the same tick. Nothing moves."));
    m_group->setEnabled(any);
    look::setPossible(m_name,
                      m_group->count() == 0 ? none
                      : m_link.rights       ? notTold
                                            : QString(),
                      tr("What you call this group. Kept with the machine; nothing is sent."));
    if (!m_name->hasFocus())
        m_name->setText(nameOf(group));
}

void GroupsPage::changed(std::size_t row) {
    const Member& member = m_members[row];
    const int group = member.group->currentData().toInt();
    if (group == kUnknown || row >= m_link.modules.size())
        return;
    const bool leader = member.leader->isChecked() && group != kNoGroup;
    emit groupChangeRequested({m_link.modules[row].info.index, {static_cast<std::uint8_t>(group), leader}});
}

void GroupsPage::command(bus::GroupCommand::Action action) {
    emit groupCommandRequested({static_cast<std::uint8_t>(m_group->currentData().toInt()), action});
}

}  // namespace nmc
