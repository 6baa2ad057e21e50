// SPDX-License-Identifier: GPL-3.0-or-later
// The window's docks, and what they show in each layout.
#include <QAction>
#include <QDockWidget>
#include <QLayout>
#include <QResizeEvent>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>

#include "widgets/axes/axesdock.h"
#include "widgets/chain/chainview.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sharedwords.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/mainwindow.h"
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
constexpr int kLowestScope = 12;
constexpr int kTitleBar = 3;  ///< above the window; its true height is known only once it is shown
}  // namespace

QDockWidget* MainWindow::newDock(const QString& objectName, const QString& title, QWidget* content) {
    auto* dock = new QDockWidget(title, this);
    look::name(dock, objectName, title);
    dock->setWidget(content);
    return dock;
}

void MainWindow::showDockOf(const QWidget& content) {
    for (QDockWidget* dock : m_layouts->docks())
        if (dock->isAncestorOf(&content)) {
            dock->show();
            dock->raise();
        }
}

void MainWindow::buildDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_layouts = new Layouts(*this, m_settings);
    m_chain = new ChainView(this);
    m_scope = new ScopePanel(*m_requests, this);
    m_scopeDock = newDock(u"scopeDock"_s, Common::tr("Scope"), scrolled(m_scope));
    m_messages = new MessagePanel(*m_model, *m_requests, this);
    m_simulator = new SimulatorDock(this);
    m_monitor = new MonitorDock(*m_requests, this);
    m_response = new ResponseDock(*m_requests, this);
    m_loopTests = new LoopTestsDock(*m_requests, this);
    m_sequences = new SequencesDock(*m_requests, this);
    m_paths = new PathsDock(*m_requests, this);
    m_axes = new AxesDock(*m_requests, this);
    for (QDockWidget* dock : std::initializer_list<QDockWidget*>{
             newDock(u"chainDock"_s, tr("Modules"), m_chain), m_scopeDock,
             newDock(u"messagesDock"_s, Common::tr("Messages"), scrolled(m_messages)), m_simulator, m_monitor,
             m_response, m_loopTests, m_sequences, m_paths, m_axes})
        m_layouts->add(*dock);
    connect(m_layouts, &Layouts::chosen, this, &MainWindow::showLayout);
    connect(m_panel, &ModulePanel::responseWanted, m_response, &ResponseDock::open);
    connect(m_response, &ResponseDock::opened, this, &MainWindow::showSelected);
    connect(m_requests, &Requests::stageGains, m_panel, &ModulePanel::stageGains);
    connect(m_loopTests, &LoopTestsDock::opened, this, &MainWindow::showSelected);
    connect(m_requests, &Requests::showRun, this, &MainWindow::showResponse);
    connect(m_loopTests, &LoopTestsDock::reportWanted, this, &MainWindow::chooseReportFile);
    connect(m_requests, &Requests::saveFrequencies, this, &MainWindow::saveFrequencies);
    for (LazyDock* dock : std::initializer_list<LazyDock*>{m_sequences, m_paths, m_axes})
        connect(dock, &LazyDock::opened, this, &MainWindow::showAllAxes);
    m_stepNow = new QAction(tr("Step"), this);
    m_stepNow->setObjectName(u"stepNowAction"_s);
    m_stepNow->setShortcut(Qt::SHIFT | Qt::Key_F9);
    addAction(m_stepNow);
    connect(m_stepNow, &QAction::triggered, this, &MainWindow::stepNow);
}

/// If the window is low, the scope gives way to the controls that move the motor, as far as it remains
/// readable. When the window becomes higher, the scope gets the height gained and the height that it gave
/// before, as far as nothing else needs it.
void MainWindow::makeRoomForMotions(int higher) {
    layout()->activate();
    ModulePage* page = m_panel->page();
    if (page == nullptr || !m_scopeDock->isVisible() ||
        dockWidgetArea(m_scopeDock) != Qt::BottomDockWidgetArea)
        return;
    const int least = fontMetrics().height() * kLowestScope;
    const int most = m_scopeDock->height() + m_scopeGave + qMax(0, higher);
    const int wanted =
        qBound(qMin(least, m_scopeDock->height()), m_scopeDock->height() + page->spareHeight(), most);
    if (wanted != m_scopeDock->height()) {
        m_scopeGave = qMax(0, m_scopeGave + m_scopeDock->height() - wanted);
        resizeDocks({m_scopeDock}, {wanted}, Qt::Vertical);
    }
    // Queued: the page has its new size only then.
    QMetaObject::invokeMethod(page, &ModulePage::dropScrollBar, Qt::QueuedConnection);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    // Queued: the contents of the window have their new size only then.
    if (const int before = event->oldSize().width(); before > 0 && before != width())
        QMetaObject::invokeMethod(
            this, [this, wider = width() - before] { m_layouts->keepColumn(wider); }, Qt::QueuedConnection);
    const int higher = event->oldSize().height() > 0 ? height() - event->oldSize().height() : 0;
    QMetaObject::invokeMethod(
        this, [this, higher] { makeRoomForMotions(higher); }, Qt::QueuedConnection);
}

void MainWindow::restoreLayout() {
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

void MainWindow::resetLayout() {
    m_settings.remove(m_layouts->key(kSimulatorOpen));
    m_layouts->reset();
}

void MainWindow::showLayout(Layouts::Kind kind) {
    const bool tune = kind == Layouts::Kind::Tune;
    m_simulator->setWanted(
        m_settings.value(m_layouts->key(kSimulatorOpen), m_layouts->opens(*m_simulator)).toBool());
    m_scope->setSetup(ScopeSetup::fromText(m_settings.value(m_layouts->key(kScope)).toString(),
                                           tune ? ScopeSetup::forTuning() : ScopeSetup::usual()));
    if (tune) {
        m_panel->setFoot(m_response->page().lendForm());
    } else {
        m_panel->setFoot(nullptr);
        m_response->takeFormBack();
    }
    showSelected();
    // Queued: the docks have their sizes only then.
    QMetaObject::invokeMethod(
        this, [this] { makeRoomForMotions(0); }, Qt::QueuedConnection);
}

/// Makes a step, from anywhere in the window. It moves the motor, so its form must be visible.
void MainWindow::stepNow() {
    if (!m_response->page().lends())
        m_response->open();
    if (const ModuleState* module = m_session.selected())
        m_response->page().showModule(m_session.viewOf(*module));
    else
        m_response->page().showNothing();
    m_response->page().step();
}

}  // namespace nmc
