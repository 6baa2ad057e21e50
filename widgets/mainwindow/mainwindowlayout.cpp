// SPDX-License-Identifier: GPL-3.0-or-later
// The window's docks: their initial arrangements, and those in which the user left them.
#include <QAction>
#include <QDockWidget>
#include <QResizeEvent>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>

#include "widgets/axes/axesdock.h"
#include "widgets/chain/chainview.h"
#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/mainwindow/monitorplace.h"
#include "widgets/mainwindow/settingskeys.h"
#include "widgets/messages/banner.h"
#include "widgets/messages/messagepanel.h"
#include "widgets/monitor/monitordock.h"
#include "widgets/panels/modulepage.h"
#include "widgets/panels/modulepanel.h"
#include "widgets/paths/pathsdock.h"
#include "widgets/response/responsedock.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/sequences/sequencesdock.h"
#include "widgets/simulator/simulatordock.h"

namespace nmc {

using namespace Qt::StringLiterals;
using namespace settingskeys;

namespace {
// In lines of text.
constexpr int kStepResponseWidth = 58;
constexpr int kPathsWidth = 52;
constexpr int kSequencesWidth = 62;
constexpr int kLeastMessagesWidth = 18;
constexpr int kSequencesHeight = 24;
constexpr int kLowestScope = 12;
constexpr int kColumnWidth = 22;  ///< beside the plots
constexpr int kTitleBar = 3;      ///< above the window; its true height is known only once it is shown
}  // namespace

QDockWidget* MainWindow::addDock(const QString& objectName, const QString& title, QWidget* content,
                                 Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    look::name(dock, objectName, title);
    dock->setWidget(content);
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                      QDockWidget::DockWidgetFloatable);
    addDockWidget(area, dock);
    m_docks.append(dock);
    return dock;
}

void MainWindow::showDockOf(const QWidget& content) {
    for (QDockWidget* dock : m_docks)
        if (dock->isAncestorOf(&content)) {
            dock->show();
            dock->raise();
        }
}

void MainWindow::buildDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_chain = new ChainView(this);
    m_scope = new ScopePanel(*m_requests, this);
    m_scope->setSetup(ScopeSetup::fromText(m_settings.value(kScope).toString()));
    m_messages = new MessagePanel(*m_requests, this);
    addDock(u"chainDock"_s, tr("Modules"), m_chain, Qt::LeftDockWidgetArea);
    m_scopeDock = addDock(u"scopeDock"_s, tr("Scope"), scrolled(m_scope), Qt::BottomDockWidgetArea);
    QDockWidget* messages =
        addDock(u"messagesDock"_s, tr("Messages"), scrolled(m_messages), Qt::BottomDockWidgetArea);
    addSimulatorDock();
    m_monitor = new MonitorDock(*m_requests, this);
    placeMonitor(*this, *m_monitor, *messages, *m_scopeDock);
    m_docks.append(m_monitor);
    addResponseDock(*m_scopeDock, *messages);
    m_docks.append(m_response);
    addLoopTestsDock(*m_scopeDock, *messages);
    m_docks.append(m_loopTests);
    addMotionDocks(*m_scopeDock, *messages);
    m_layouts = new Layouts(*this, m_settings, [this](Layouts::Kind kind) { arrangeDocks(kind); });
    connect(m_layouts, &Layouts::chosen, this, &MainWindow::showLayout);
    m_stepNow = new QAction(tr("Step"), this);
    m_stepNow->setObjectName(u"stepNowAction"_s);
    m_stepNow->setShortcut(Qt::SHIFT | Qt::Key_F9);
    addAction(m_stepNow);
    connect(m_stepNow, &QAction::triggered, this, &MainWindow::stepNow);
    // Last, because anything added afterwards would undo it.
    const int em = fontMetrics().height();
    resizeDocks({m_docks.front()}, {em * 15}, Qt::Horizontal);
    resizeDocks({m_scopeDock, messages}, {em * 43, em * 22}, Qt::Horizontal);
    resizeDocks({m_scopeDock}, {em * 23}, Qt::Vertical);
}

void MainWindow::addResponseDock(QDockWidget& scope, QDockWidget& messages) {
    m_response = new ResponseDock(*m_requests, this);
    tabifyDockWidget(&scope, m_response);
    m_response->hide();
    connect(m_panel, &ModulePanel::responseWanted, m_response, &ResponseDock::open);
    // Queued: until then, the layout does not know that the dock is visible.
    connect(
        m_response, &ResponseDock::roomWanted, this,
        [this, &messages] { makeRoomBeside(messages, *m_response, kStepResponseWidth); },
        Qt::QueuedConnection);
    connect(m_response, &ResponseDock::opened, this, &MainWindow::showSelected);
    connect(m_response, &ResponseDock::gainsWanted, m_panel, &ModulePanel::stageGains);
}

void MainWindow::addLoopTestsDock(QDockWidget& scope, QDockWidget& messages) {
    m_loopTests = new LoopTestsDock(*m_requests, this);
    tabifyDockWidget(&scope, m_loopTests);
    m_loopTests->hide();
    // Queued: until then, the layout does not know that the dock is visible.
    connect(
        m_loopTests, &LoopTestsDock::roomWanted, this,
        [this, &messages] { makeRoomBeside(messages, *m_loopTests, kStepResponseWidth); },
        Qt::QueuedConnection);
    connect(m_loopTests, &LoopTestsDock::opened, this, &MainWindow::showSelected);
    connect(m_loopTests, &LoopTestsDock::runKept, this,
            [this](const KeptResponse& run) { showResponse(run); });
    connect(m_loopTests, &LoopTestsDock::reportWanted, this, &MainWindow::chooseReportFile);
    connect(m_loopTests, &LoopTestsDock::frequenciesWanted, this, &MainWindow::saveFrequencies);
}

/// Adds these docks behind the scope's tab, closed.
void MainWindow::addMotionDocks(QDockWidget& scope, QDockWidget& messages) {
    m_sequences = new SequencesDock(this);
    m_paths = new PathsDock(*m_requests, this);
    m_axes = new AxesDock(*m_requests, this);
    for (QDockWidget* dock : {static_cast<QDockWidget*>(m_sequences), static_cast<QDockWidget*>(m_paths),
                              static_cast<QDockWidget*>(m_axes)}) {
        tabifyDockWidget(&scope, dock);
        dock->hide();
        m_docks.append(dock);
    }
    connect(m_sequences, &SequencesDock::opened, this, &MainWindow::showAllAxes);
    connect(
        m_sequences, &SequencesDock::roomWanted, this, [this, &messages] { makeRoomForSequences(messages); },
        Qt::QueuedConnection);
    connect(m_paths, &PathsDock::opened, this, &MainWindow::showAllAxes);
    connect(
        m_paths, &PathsDock::roomWanted, this,
        [this, &messages] { makeRoomBeside(messages, *m_paths, kPathsWidth); }, Qt::QueuedConnection);
    connect(m_axes, &AxesDock::opened, this, &MainWindow::showAllAxes);
}

/// Widens a dock at the expense of the messages beside it.
void MainWindow::makeRoomBeside(QDockWidget& messages, QDockWidget& dock, int lines) {
    const int line = fontMetrics().height();
    const int wanted = line * lines;
    const bool beside = dockWidgetArea(&dock) == dockWidgetArea(&messages) && messages.isVisible();
    if (!beside || dock.width() >= wanted)
        return;
    const int both = dock.width() + messages.width();
    const int taken = qMin(wanted, qMax(both / 2, both - line * kLeastMessagesWidth));
    resizeDocks({&dock, &messages}, {taken, both - taken}, Qt::Horizontal);
}

/// Makes room for a few rows of the table above its buttons.
void MainWindow::makeRoomForSequences(QDockWidget& messages) {
    makeRoomBeside(messages, *m_sequences, kSequencesWidth);
    const int wanted = qMin(fontMetrics().height() * kSequencesHeight, height() / 2);
    if (dockWidgetArea(m_sequences) == Qt::BottomDockWidgetArea && m_sequences->height() < wanted)
        resizeDocks({m_sequences}, {wanted}, Qt::Vertical);
}

void MainWindow::addSimulatorDock() {
    // Below the list of modules, whose lower half is empty for most chains, so that nothing else has to give
    // way.
    m_simulator = new SimulatorDock(this);
    addDockWidget(Qt::LeftDockWidgetArea, m_simulator);
    m_docks.append(m_simulator);
    // Queued: until then, the layout does not know that the dock is visible again.
    connect(m_simulator, &SimulatorDock::shown, this, &MainWindow::makeRoomForSimulator,
            Qt::QueuedConnection);
}

void MainWindow::makeRoomForSimulator() {
    // Meanwhile, the list of modules has taken all the room, and would keep more than it needs.
    QDockWidget* chain = m_docks.front();
    if (dockWidgetArea(chain) != dockWidgetArea(m_simulator) || !chain->isVisible())
        return;
    const int both = chain->height() + m_simulator->height();
    const int wanted = qMin(m_simulator->wantedHeight(), both * 3 / 4);
    resizeDocks({chain, m_simulator}, {both - wanted, wanted}, Qt::Vertical);
}

/// If the window is low, the scope gives way to the controls that move the motor, as far as it remains
/// readable. When the window becomes higher, the scope gets the height gained and the height that it gave
/// before, as far as nothing else needs it.
void MainWindow::makeRoomForMotions(int higher) {
    layout()->activate();
    const ModulePage* page = m_panel->page();
    if (page == nullptr || !m_scopeDock->isVisible() ||
        dockWidgetArea(m_scopeDock) != Qt::BottomDockWidgetArea)
        return;
    const int least = fontMetrics().height() * kLowestScope;
    const int most = m_scopeDock->height() + m_scopeGave + qMax(0, higher);
    const int wanted =
        qBound(qMin(least, m_scopeDock->height()), m_scopeDock->height() + page->spareHeight(), most);
    if (wanted == m_scopeDock->height())
        return;
    m_scopeGave = qMax(0, m_scopeGave + m_scopeDock->height() - wanted);
    resizeDocks({m_scopeDock}, {wanted}, Qt::Vertical);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    // Queued: the contents of the window have their new size only then.
    if (const int before = event->oldSize().width(); before > 0 && before != width())
        QMetaObject::invokeMethod(
            this, [this, wider = width() - before] { keepColumn(wider); }, Qt::QueuedConnection);
    const int higher = event->oldSize().height() > 0 ? height() - event->oldSize().height() : 0;
    QMetaObject::invokeMethod(
        this, [this, higher] { makeRoomForMotions(higher); }, Qt::QueuedConnection);
}

void MainWindow::restoreLayout() {
    m_firstState = saveState();
    const QSize room = screen()->availableSize();
    const int em = fontMetrics().height();
    resize(qMin(em * 104, room.width()), qMin(em * 68, room.height() - em * kTitleBar));
    restoreGeometry(m_settings.value(kGeometry).toByteArray());
    m_layouts->restore();
    m_simulator->showLink(m_session.link());
    const QString port = m_settings.value(kLastPort).toString();
    if (!port.isEmpty())
        m_bar->choosePort(port, m_settings.value(kLastBaud).toUInt());
}

void MainWindow::saveLayout() {
    m_settings.setValue(kGeometry, saveGeometry());
    m_layouts->save();
}

QString MainWindow::simulatorOpen(Layouts::Kind kind) {
    return kind == Layouts::Kind::Tune ? kSimulatorOpen + u"/tune"_s : kSimulatorOpen;
}

/// Puts the docks into the initial arrangement of a layout.
void MainWindow::arrangeDocks(Layouts::Kind kind) {
    restoreState(m_firstState);
    const bool tune = kind == Layouts::Kind::Tune;
    const bool chain = kind == Layouts::Kind::Chain;
    const QDockWidget* messages = findChild<QDockWidget*>(u"messagesDock"_s);
    for (QDockWidget* dock : m_docks)
        dock->setVisible(dock == m_simulator       ? dock->isVisible()
                         : dock == m_response      ? tune
                         : dock == m_monitor       ? chain
                         : dock == m_scopeDock     ? !chain
                         : dock == messages        ? !tune
                         : dock == m_docks.front() ? !tune
                                                   : false);
    if (tune)
        giveRoomToPlots();
    if (chain)
        resizeDocks({m_monitor}, {height() / 2}, Qt::Vertical);
}

void MainWindow::resetLayout() {
    m_settings.remove(simulatorOpen(m_layouts->kind()));
    m_layouts->reset();
}

/// Puts the plots at the left, one above the other; other docks that are opened appear to the right of the
/// gains.
void MainWindow::giveRoomToPlots() {
    for (QDockWidget* dock : m_docks)
        if (dock != m_scopeDock && dock != m_response && dock != m_loopTests) {
            const bool shown = !dock->isHidden();
            addDockWidget(Qt::RightDockWidgetArea, dock);
            dock->setVisible(shown);
        }
    addDockWidget(Qt::LeftDockWidgetArea, m_scopeDock);
    splitDockWidget(m_scopeDock, m_response, Qt::Vertical);
    const bool testing = !m_loopTests->isHidden();
    tabifyDockWidget(m_response, m_loopTests);
    m_loopTests->setVisible(testing);
    const int column = fontMetrics().height() * kColumnWidth;
    resizeDocks({m_scopeDock}, {qMax(column, width() - column)}, Qt::Horizontal);
    resizeDocks({m_scopeDock, m_response}, {height() * 2, height() * 3}, Qt::Vertical);
}

/// Gives the plots the width that the window has gained.
void MainWindow::keepColumn(int wider) {
    if (m_layouts->kind() == Layouts::Kind::Tune && dockWidgetArea(m_scopeDock) == Qt::LeftDockWidgetArea &&
        m_scopeDock->isVisible())
        resizeDocks({m_scopeDock}, {qMax(1, m_scopeDock->width() + wider)}, Qt::Horizontal);
}

void MainWindow::showLayout(Layouts::Kind kind) {
    const bool tune = kind == Layouts::Kind::Tune;
    m_simulator->setWanted(m_settings.value(simulatorOpen(kind), !tune).toBool());
    m_banner->setCompact(tune);
    if (tune) {
        m_panel->setFoot(m_response->page().lendForm());
    } else {
        m_panel->setFoot(nullptr);
        m_response->takeFormBack();
    }
    showSelected();
}

/// Makes a step, from anywhere in the window. It moves the motor, so its form must be visible.
void MainWindow::stepNow() {
    if (!m_response->page().lends())
        m_response->open();
    if (const ModuleState* module = selectedState())
        m_response->page().showModule(m_session.viewOf(*module));
    else
        m_response->page().showNothing();
    m_response->page().step();
}

}  // namespace nmc
