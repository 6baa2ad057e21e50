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

#include "widgets/common/askdialog.h"
#include "widgets/common/doctortexts.h"
#include "widgets/common/form.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr std::uint8_t kNoGroup = 0xFF;     // the group of all modules
constexpr std::uint8_t kFirstGroup = 0x81;  // 80 comes last, because hosts begin with 81
constexpr std::uint8_t kLastGroup = 0xFE;
constexpr std::uint8_t kOtherGroup = 0x80;
constexpr int kUnknown = -1;
constexpr int kFirstAddress = 1;
constexpr int kLastAddress = 0x7F;
}  // namespace

GroupsPage::GroupsPage(Requests& requests, QWidget* parent) : QWidget(parent), m_requests(requests) {
    look::name(this, u"groupsPage"_s, Common::tr("Groups"));
    const int unit = look::gridUnit(this);
    QLabel* remark = form::newRemark(
        tr("A module listens to one group besides its own address. All members carry out a group command in the same tick; the leader, if any, answers for them, and the panel then checks each member. Status requests go to single modules."),
        this);
    m_none = look::newMutedLabel(tr("No modules yet: connect first."), this, u"noGroupsLabel"_s);
    m_addressReason = form::newParagraph(u"addressReason"_s, {}, this);
    m_addressReason->hide();
    m_grid = new QGridLayout;
    m_grid->setHorizontalSpacing(unit * 2);
    m_grid->setVerticalSpacing(unit / 2);
    m_grid->setColumnStretch(Load, 1);

    m_group = form::newChoice(
        {u"groupBox"_s, tr("Group to command"), {}, tr("The group that the buttons act on.")}, this);
    // It is empty when the page is shown for the first time without groups.
    m_group->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_name = form::newText({u"groupNameField"_s, tr("Name of the group"), 40, {}, Common::tr("Name")}, this);
    using enum bus::GroupCommand::Action;
    m_start = newCommand(tr("St&art loaded moves"), u"groupStartButton"_s,
                         tr("Start loaded moves of this group"), StartMotion);
    m_start->setIcon(icons::tinted(u"player-play"_s));
    m_saveHome = newCommand(tr("Save &home"), u"groupHomeButton"_s,
                            tr("Save home: the present positions of this group"), SaveAsHome);
    m_saveHome->setIcon(icons::tinted(u"home"_s));
    m_stopSmoothly = newCommand(tr("Stop s&moothly"), u"groupStopSmoothlyButton"_s,
                                tr("Stop smoothly: this group"), StopSmoothly);
    m_stopAbruptly = newCommand(tr("Stop at &once"), u"groupStopAbruptlyButton"_s,
                                tr("Stop at once: this group"), StopAbruptly);
    m_motorOff =
        newCommand(tr("Motors o&ff"), u"groupMotorOffButton"_s, tr("Motors off in this group"), MotorOff);
    m_clear = newCommand(tr("C&lear sticky bits"), u"groupClearButton"_s,
                         tr("Clear sticky bits of this group"), ClearStickyBits);
    m_reset = form::newPush(
        {u"groupResetButton"_s, tr("Set &position to 0…"), tr("Set position to 0 for this group")}, this);
    m_reset->setAutoDefault(false);
    connect(m_reset, &QPushButton::clicked, this, &GroupsPage::askBeforeReset);
    auto* first = form::newLine(this, {m_group, {m_name, 1}, m_start});
    auto* stops = form::newLine(this, {m_stopSmoothly, m_stopAbruptly, m_motorOff, nullptr});
    auto* others = form::newLine(this, {m_saveHome, m_reset, m_clear, nullptr});
    form::fill(
        this, form::newColumn(this, {remark, m_none, m_grid, m_addressReason, first, stops, others, nullptr}),
        1);
    connect(m_group, &QComboBox::currentIndexChanged, this, &GroupsPage::refreshCommands);
    connect(m_name, &QLineEdit::editingFinished, this, &GroupsPage::nameGroup);
    showLink({}, {});
}

QPushButton* GroupsPage::newCommand(const QString& text, const QString& objectName,
                                    const QString& accessibleName, bus::GroupCommand::Action action) {
    auto* button = form::newPush({objectName, text, accessibleName}, this);
    button->setAutoDefault(false);  // Enter confirms addresses and names
    connect(button, &QPushButton::clicked, this, [this, action] { command(action); });
    return button;
}

void GroupsPage::addMember() {
    const std::size_t row = m_members.size();
    const int number = static_cast<int>(row) + 1;
    Member member;
    member.name = new QLabel(this);
    member.address = new NumberField(0, this);
    look::name(member.address, u"address%1Box"_s.arg(number), tr("Address of module %1").arg(number));
    member.address->setRange(kFirstAddress, kLastAddress);
    member.address->setDigits(5);
    member.address->setWords(tr("The address"), {});
    member.addressLabel = form::newLabel(tr("address"), member.address);
    member.group = form::newChoice({u"group%1Box"_s.arg(number), tr("Group of module %1").arg(number)}, this);
    member.group->addItem(texts::groupName(kNoGroup), kNoGroup);
    for (int group = kFirstGroup; group <= kLastGroup; ++group)
        member.group->addItem(titleOf(group), group);
    member.group->addItem(titleOf(kOtherGroup), kOtherGroup);
    member.leader = new QCheckBox(tr("leader"), this);
    look::name(member.leader, u"leader%1Box"_s.arg(number), tr("Leader of its group: module %1").arg(number));
    member.load = look::newMutedLabel({}, this, u"load%1Label"_s.arg(number));
    m_grid->addWidget(member.name, number, Name);
    m_grid->addWidget(member.addressLabel, number, AddressLabel);
    m_grid->addWidget(member.address, number, Address);
    m_grid->addWidget(member.group, number, Group);
    m_grid->addWidget(member.leader, number, Leader);
    m_grid->addWidget(member.load, number, Load);
    connect(member.address, &NumberField::editingFinished, this, [this, row] { readdress(row); });
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
    auto refusal = whyNoChain(m_link);
    if (!refusal && (module.silent || module.hasRestarted))
        refusal = module.notAsked ? Refusal::NotAsked : Refusal::Unresponsive;
    if (!refusal)
        refusal = whyInaccessible(m_link);
    const QString reason = refusal ? texts::refusal(*refusal) : QString();
    look::setPossible(row.group, reason,
                      tr("The group that this module listens to. Sent at once; nothing moves."));
    look::setPossible(row.leader,
                      !reason.isEmpty()                   ? reason
                      : place && place->group != kNoGroup ? QString()
                                                          : tr("Choose a group first."),
                      tr("This module answers for its group. A group has at most one leader."));
    row.address->setPossible(
        !reason.isEmpty() ? reason : whyNotAddress(module),
        tr("The address of this module, 1 to 127. Press Enter to send it. Position, gains and group are kept."));
    if (!row.address->hasFocus())
        row.address->showValue(module.info.address.value());
    look::setText(row.load, module.loadWaiting   ? tr("move loaded")
                            : module.pins.stored ? tr("outputs stored")
                                                 : QString());
}

void GroupsPage::showLink(const LinkState& link, const std::vector<GroupSettings>& groups) {
    const bool renamed = m_groups != groups;
    m_link = link;
    m_groups = groups;
    while (m_members.size() < link.modules.size())
        addMember();
    for (std::size_t i = 0; i < m_members.size(); ++i) {
        const Member& row = m_members[i];
        const bool there = i < link.modules.size();
        for (QWidget* widget : std::initializer_list<QWidget*>{row.name, row.addressLabel, row.address,
                                                               row.group, row.leader, row.load})
            widget->setVisible(there);
        if (there)
            showMember(row, link.modules[i]);
    }
    // The reason is about an address that is being typed; without the focus, its field shows the present one.
    if (std::ranges::none_of(m_members, [](const Member& row) { return row.address->hasFocus(); }))
        m_addressReason->hide();
    m_none->setVisible(link.modules.empty());
    offerGroups();
    if (renamed)
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

/// Updates the names wherever a group is offered.
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
        emit m_requests.groupNamed(static_cast<quint8>(group.toInt()), name);
}

/// Offers the groups in use, in order.
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
    // What is being typed is a name for the group that was chosen.
    if (m_group->currentData() != chosen)
        m_name->setText(nameOf(group()));
}

std::uint8_t GroupsPage::group() const {
    return static_cast<std::uint8_t>(m_group->currentData().toInt());
}

QString GroupsPage::whyNotAll(IntentKind kind) const {
    for (const ModuleState& module : m_link.modules) {
        if (!module.info.group || module.info.group->group != group())
            continue;
        // A PIC-I/O has no home, and latches its inputs instead.
        const bool latches = module.isIo() && kind == IntentKind::SaveAsHome;
        if (const auto refusal = whyNot(latches ? IntentKind::ControlIo : kind, module))
            return Common::tr("%1: %2").arg(texts::moduleName(module.info.index),
                                            module.isIo() && *refusal == Refusal::NothingLoaded
                                                ? tr("Store its outputs first.")
                                                : texts::refusal(*refusal));
    }
    return {};
}

void GroupsPage::refreshCommands() {
    const auto noChain = whyNoChain(m_link);
    const bool stoppable = m_group->count() > 0 && !whyNoStop(m_link);
    const bool any = stoppable && !noChain;
    const QString none =
        noChain ? texts::refusal(*noChain) : tr("No groups yet. Add modules to a group first.");
    const auto refusal = whyInaccessible(m_link);
    const QString inaccessible = refusal ? texts::refusal(*refusal) : QString();
    look::setPossible(
        m_start, any ? whyNotAll(IntentKind::StartLoaded) : none,
        tr("Starts the loaded moves of all members in the same tick. Available once every member has confirmed its load."));
    look::setPossible(
        m_saveHome,
        !any                      ? none
        : !inaccessible.isEmpty() ? inaccessible
                                  : whyNotAll(IntentKind::SaveAsHome),
        tr("Saves the present position of each member as home, in the same tick. Nothing moves."));
    look::setPossible(m_reset, any ? whyNotAll(IntentKind::ResetPosition) : none,
                      tr("Makes the present position of each member 0. Asks first."));
    look::setPossible(m_clear, any ? whyNotAll(IntentKind::ClearStickyBits) : none,
                      tr("Clears the sticky fault bits of each member. PIC-SERVO only."));
    // Motors may always be stopped, by operators and during a search.
    const QString notStopped = !stoppable        ? none
                               : m_link.readOnly ? texts::refusal(Refusal::ReadOnly)
                                                 : QString();
    look::setPossible(
        m_stopSmoothly, notStopped,
        tr("Every member that is on slows down and holds. Repeated until all are seen at rest."));
    look::setPossible(
        m_stopAbruptly, notStopped,
        tr("Every member that is on stops at once and holds. Repeated until all are seen at rest."));
    look::setPossible(
        m_motorOff, notStopped,
        tr("Switches every member off: motors coast, and loads may fall. Repeated until all are seen at rest."));
    AskDialog::reviewAll(*this);
    m_group->setEnabled(stoppable);
    look::setPossible(m_name,
                      m_group->count() == 0 ? none
                      : m_link.rights       ? inaccessible
                                            : QString(),
                      tr("The name of this group. Saved with the machine; nothing is sent."));
    if (!m_name->hasFocus())
        m_name->setText(nameOf(group()));
}

QString GroupsPage::questionBeforeReset() const {
    if (m_group->count() == 0 || !whyNotAll(IntentKind::ResetPosition).isEmpty())
        return {};
    std::vector<ModuleIndex> members;
    for (const ModuleState& module : m_link.modules)
        if (module.info.group && module.info.group->group == group())
            members.push_back(module.info.index);
    return tr("The present position of each motor of %1 becomes 0: module %2. Home, limits and taught points then refer to different positions.")
        .arg(titleOf(group()), texts::listOfModules(members));
}

void GroupsPage::askBeforeReset() {
    // Only the group that the question is about may be reset.
    const auto asked = group();
    AskDialog::ask({.name = u"groupResetDialog"_s,
                    .title = tr("Set positions to 0"),
                    .text = [this, asked] { return asked == group() ? questionBeforeReset() : QString(); },
                    .stayName = u"cancelGroupResetButton"_s},
                   {{tr("&Set positions to 0"), u"confirmGroupResetButton"_s,
                     [this] { command(bus::GroupCommand::Action::ResetPosition); }}},
                   this, this);
}

void GroupsPage::changed(std::size_t row) {
    const Member& member = m_members[row];
    const int group = member.group->currentData().toInt();
    if (group == kUnknown || row >= m_link.modules.size())
        return;
    const bool leader = member.leader->isChecked() && group != kNoGroup;
    emit m_requests.groupChange({m_link.modules[row].info.index, {static_cast<std::uint8_t>(group), leader}});
}

/// Checks the same as the engine, which also queries the new address.
QString GroupsPage::whyNotAddress(const ModuleState& module) const {
    if (!module.info.group)
        return tr("Its group is unknown and would change with the address. Choose a group first, or none.");
    const bool moves = std::any_of(m_link.modules.begin(), m_link.modules.end(),
                                   [](const ModuleState& other) { return other.moving(); });
    return moves ? tr("A motor is moving. Stop all motors to change addresses.") : QString();
}

/// Sends the new address after Enter. If the field has lost the focus instead, it shows the present address
/// again.
void GroupsPage::readdress(std::size_t row) {
    const NumberField* field = m_members[row].address;
    if (row >= m_link.modules.size())
        return;
    const bus::ModuleInfo& info = m_link.modules[row].info;
    if (!field->hasFocus())
        return showMember(m_members[row], m_link.modules[row]);
    const auto value = field->value();
    const BusAddress wanted(static_cast<std::uint8_t>(value.value_or(0)));
    const auto taken =
        std::find_if(m_link.modules.begin(), m_link.modules.end(), [&](const ModuleState& other) {
            return other.info.index != info.index && other.info.address == wanted;
        });
    QString reason;
    if (!value)
        reason = field->problemText();
    else if (taken != m_link.modules.end())
        reason = tr("Address %1 is used by %2. Nothing was sent.")
                     .arg(wanted.value())
                     .arg(texts::moduleName(taken->info.index));
    m_addressReason->setText(reason);
    m_addressReason->setVisible(!reason.isEmpty());
    if (reason.isEmpty() && wanted != info.address)
        emit m_requests.address(info.index, wanted);
}

void GroupsPage::command(bus::GroupCommand::Action action) {
    emit m_requests.groupCommand({group(), action});
}

}  // namespace nmc
