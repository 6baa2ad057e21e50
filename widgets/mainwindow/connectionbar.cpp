// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/connectionbar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "link/ports/networkline.h"
#include "protocol/baud.h"
#include "widgets/common/accessibility.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/form.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/mainwindow/stopbutton.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kStopResultLines = 3;  // the stop button is higher than that

/// The names of such ports say what they are, though no list of ports can have them.
bool explainsItself(const QString& port) {
    return port.startsWith(kSimulatorPort) || isNetworkName(port.toStdString());
}
}  // namespace

PortBox::PortBox(QWidget* parent) : QComboBox(parent) {
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setCompleter(nullptr);  // it would choose a port other than the one that was typed
}

ConnectionBar::ConnectionBar(QWidget* parent)
    : QFrame(parent),
      m_port(new PortBox(this)),
      m_baud(new QComboBox(this)),
      m_connect(new QPushButton(icons::tinted(u"plug-connected"_s), tr("&Connect"), this)),
      m_readOnly(look::newAction(this, u"connectReadOnlyAction"_s, tr("Connect read-&only"))),
      m_moreWays(new QToolButton(this)),
      m_disconnect(new QPushButton(icons::tinted(u"plug-connected-x"_s), tr("&Disconnect"), this)),
      m_stopResult(new ElidedLabel(kStopResultLines, this)),
      m_stop(new StopButton(this)) {
    look::name(this, u"connectionBar"_s, tr("Connection and stop"));
    look::name(m_port, u"portBox"_s, tr("Port"));
    look::name(m_port->lineEdit(), u"portField"_s, tr("Port"));
    look::name(m_baud, u"baudBox"_s, Common::tr("Baud rate"));
    look::name(m_connect, u"connectButton"_s, tr("Connect"));
    look::name(m_moreWays, u"moreWaysButton"_s, tr("Other ways to connect"));
    look::name(m_disconnect, u"disconnectButton"_s, tr("Disconnect"));
    auto* ways = new QMenu(this);
    look::name(ways, u"moreWaysMenu"_s, m_moreWays->accessibleName());
    ways->setToolTipsVisible(true);
    ways->addAction(m_readOnly);
    m_moreWays->setArrowType(Qt::DownArrow);
    m_moreWays->setFocusPolicy(Qt::StrongFocus);
    m_moreWays->setFixedHeight(m_connect->sizeHint().height());
    // Not setMenu(), which draws an arrow of its own.
    connect(m_moreWays, &QToolButton::clicked, this,
            [this, ways] { ways->popup(m_moreWays->mapToGlobal(m_moreWays->rect().bottomLeft())); });
    m_stopResult->setObjectName(u"stopResultLabel"_s);
    m_stopResult->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_port->setMinimumContentsLength(26);
    m_port->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_port->setMinimumWidth(fontMetrics().height() * 9);  // so that STOP ALL need not give way
    for (const BaudRow& row : kBaudRows)
        m_baud->addItem(QString::number(row.nominal), row.nominal);
    m_baud->setCurrentIndex(m_baud->findText(u"115200"_s));

    const int unit = look::gridUnit(this);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(unit, unit / 2, unit, unit / 2);
    layout->setSpacing(unit);
    layout->addWidget(form::newLabel(tr("Por&t"), m_port));
    layout->addWidget(m_port);
    layout->addWidget(form::newLabel(tr("Baud"), m_baud));
    layout->addWidget(m_baud);
    layout->addWidget(new QLabel(tr("Bd"), this));
    layout->addSpacing(unit);
    layout->addLayout(form::newLine(this, {m_connect, m_moreWays}, 0));
    layout->addWidget(m_disconnect);
    layout->addSpacing(unit);
    layout->addWidget(m_stopResult, 1);
    layout->addWidget(m_stop);

    connect(m_port, &PortBox::aboutToOpen, this, &ConnectionBar::portsRequested);
    connect(m_port, &QComboBox::activated, this, [this] { m_chosen = port(); });
    connect(m_port->lineEdit(), &QLineEdit::returnPressed, m_connect, &QAbstractButton::click);
    connect(m_port, &QComboBox::currentTextChanged, this, &ConnectionBar::choiceChanged);
    connect(m_baud, &QComboBox::currentIndexChanged, this, &ConnectionBar::choiceChanged);
    connect(m_connect, &QPushButton::clicked, this, [this] { requestConnect(false); });
    connect(m_readOnly, &QAction::triggered, this, [this] { requestConnect(true); });
    connect(m_disconnect, &QPushButton::clicked, this, &ConnectionBar::disconnectRequested);
    connect(m_stop, &QAbstractButton::pressed, this, &ConnectionBar::stopAllRequested);
    fillPorts();
    showLink({});
}

void ConnectionBar::requestConnect(bool readOnly) {
    m_chosen = port();
    if (m_chosen.isEmpty())
        return openPorts();
    emit connectRequested(port(), baud(), readOnly);
}

void ConnectionBar::fillPorts() {
    QList<PortEntry> wanted = m_ports;
    const auto lists = [&wanted](const QString& name) {
        return std::ranges::any_of(wanted, [&name](const PortEntry& e) { return e.name == name; });
    };
    if (!lists(kSimulatorPort))
        wanted.append({kSimulatorPort, {}});
    if (!m_chosen.isEmpty() && !lists(m_chosen))
        wanted.append({m_chosen, explainsItself(m_chosen) ? QString() : tr("not listed")});

    const QSignalBlocker blocker(m_port);
    const bool typing = m_port->lineEdit()->isModified();
    const QString typed = m_port->currentText();
    m_port->clear();
    for (const PortEntry& entry : wanted) {
        const bool simulator = entry.name == kSimulatorPort;
        const QString description =
            simulator && entry.description.isEmpty() ? tr("no hardware needed") : entry.description;
        const QString name = texts::portName(entry.name);
        m_port->addItem(description.isEmpty() ? name : tr("%1  (%2)").arg(name, description), entry.name);
    }
    m_port->setCurrentIndex(qMax(0, m_port->findData(m_chosen)));
    if (typing) {
        m_port->setEditText(typed);
        m_port->lineEdit()->setModified(true);
    }
    emit choiceChanged();
}

void ConnectionBar::showPorts(const QList<PortEntry>& ports) {
    const bool same = std::ranges::equal(ports, m_ports, [](const PortEntry& a, const PortEntry& b) {
        return a.name == b.name && a.description == b.description;
    });
    if (same)
        return;
    m_ports = ports;
    fillPorts();
}

void ConnectionBar::choosePort(const QString& port, quint32 baud) {
    m_chosen = port;
    m_port->lineEdit()->setModified(false);
    fillPorts();
    const QSignalBlocker blocker(m_baud);
    const int index = m_baud->findData(baud);
    if (index >= 0)
        m_baud->setCurrentIndex(index);
    emit choiceChanged();
}

void ConnectionBar::connectTo(const QString& port) {
    choosePort(port, baud());
    requestConnect(false);
}

PortEntry ConnectionBar::serialPort() const {
    const QString chosen = port();
    for (const PortEntry& entry : m_ports)
        if (entry.name == chosen)
            return entry;
    if (!chosen.isEmpty() && !chosen.startsWith(kSimulatorPort))
        return {chosen, {}};
    return m_ports.isEmpty() ? PortEntry{} : m_ports.front();
}

QString ConnectionBar::simulator() const {
    return m_chosen.startsWith(kSimulatorPort) ? m_chosen : kSimulatorPort;
}

const QWidget& ConnectionBar::stopButton() const {
    return *m_stop;
}

QString ConnectionBar::port() const {
    const QString typed = m_port->currentText().trimmed();
    for (int i = 0; i < m_port->count(); ++i)
        if (const QString listed = m_port->itemData(i).toString();
            typed == m_port->itemText(i) || typed == texts::portName(listed))
            return listed;
    return typed;
}

quint32 ConnectionBar::baud() const {
    return m_baud->currentData().toUInt();
}

void ConnectionBar::openPorts() {
    m_port->setFocus();
    m_port->showPopup();
}

void ConnectionBar::showLink(const LinkState& state) {
    const bool open = state.isOpen();
    const QString busy = tr("Disconnect first.");
    const QString whyNot = open ? busy : QString();
    look::setPossible(m_connect, whyNot, Common::tr("Opens the port and looks for modules. Nothing moves."));
    look::setPossible(m_moreWays, whyNot, tr("Other ways to connect."));
    m_readOnly->setEnabled(!open);
    m_readOnly->setToolTip(
        open ? busy
             : tr("Opens the port and only reads: only status requests are sent. STOP ALL still works."));
    look::setPossible(m_disconnect, open ? QString() : tr("No port is open."), tr("Closes the port."));
    look::setPossible(m_port, whyNot, tr("The serial port of the modules, or the simulator."));
    look::setPossible(
        m_baud, whyNot,
        tr("The baud rate for a chain without addresses; a chain that has them keeps its rate."));
    m_stop->setEnabled(state.hasChain());
    const auto modules = static_cast<int>(state.modules.size());
    const auto reachable = static_cast<int>(std::ranges::count_if(
        state.modules, [](const ModuleState& m) { return !m.silent && hasStop(m.info.identity.type); }));
    // While the chain is not polled, it is unknown which modules a stop reaches.
    const bool asked = modules > 0 && state.phase == LinkPhase::Connected;
    const QString reach = asked ? texts::stopReach(reachable, modules) : Common::tr("goes to all modules");
    m_stop->showReach(open ? reach : state.hasChain() ? Common::tr("waits for the port") : QString());
    // The result of the last stop is out of date once something moves again or the port is closed.
    const bool moving =
        std::ranges::any_of(state.modules, [](const ModuleState& m) { return m.stillMoves(); });
    const QString seen = u"%1 %2"_s.arg(static_cast<int>(state.phase)).arg(moving);
    if (seen != m_linkSeen) {
        m_linkSeen = seen;
        if (moving || !open) {
            m_stopResult->clear();
            m_stopResult->setAccessibleName({});
        }
    }
}

void ConnectionBar::showStopResult(const QString& text) {
    look::setText(m_stopResult, text);
    accessibility::announce(*m_stopResult, text);
}

}  // namespace nmc
