// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/mainwindow.h"

#include <QAction>
#include <QClipboard>
#include <QCloseEvent>
#include <QDockWidget>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QWindow>
#include <algorithm>
#include <set>
#include <utility>

#include "widgets/axes/axespage.h"
#include "widgets/chain/chainmenu.h"
#include "widgets/chain/chainview.h"
#include "widgets/common/apitexts.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/focuskeeper.h"
#include "widgets/common/form.h"
#include "widgets/common/lazydock.h"
#include "widgets/common/look.h"
#include "widgets/common/palettes.h"
#include "widgets/common/requests.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/help/manualwindow.h"
#include "widgets/help/problemreport.h"
#include "widgets/help/reportdialog.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/mainwindow/bell.h"
#include "widgets/mainwindow/colourchoice.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/escfilter.h"
#include "widgets/mainwindow/inputfilters.h"
#include "widgets/mainwindow/linkbar.h"
#include "widgets/mainwindow/menus.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/mainwindow/otherwindows.h"
#include "widgets/mainwindow/paletteentries.h"
#include "widgets/mainwindow/pendant.h"
#include "widgets/mainwindow/pressfilter.h"
#include "widgets/mainwindow/ribbons.h"
#include "widgets/mainwindow/settingskeys.h"
#include "widgets/mainwindow/startpage.h"
#include "widgets/mainwindow/tuningfiles.h"
#include "widgets/messages/banner.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagemodel.h"
#include "widgets/messages/messagepanel.h"
#include "widgets/monitor/monitordock.h"
#include "widgets/panels/command.h"
#include "widgets/panels/modulepage.h"
#include "widgets/panels/modulepanel.h"
#include "widgets/paths/pathspage.h"
#include "widgets/response/responsedock.h"
#include "widgets/scope/scopefiles.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/scope/scopepresets.h"
#include "widgets/sequences/sequencesdock.h"
#include "widgets/simulator/simulatordock.h"

namespace nmc {

using namespace Qt::StringLiterals;
using namespace settingskeys;

namespace {

constexpr int kPrepareInterval = 100;  // ms
constexpr int kReportedPackets = 500;

// In lines of text.
constexpr int kLowestScope = 12;
constexpr int kTitleBar = 3;  ///< above the window; its true height is known only once it is shown

}  // namespace

MainWindow::MainWindow(QSettings& settings, QWidget* parent)
    : QMainWindow(parent),
      m_settings(settings),
      m_requests(new Requests(this)),
      m_model(new MessageModel(this)),
      m_colours(new ColourChoice(settings, this)),
      m_focus(new FocusKeeper(*this)),
      m_machineMenu(new MachineMenu(this)),
      m_chainMenu(new ChainMenu(m_session.machine(), m_session.link(), *m_requests, this)) {
    look::name(this, u"mainWindow"_s, tr("NMC Panel"));
    look::adoptReadable(this);
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks |
                   QMainWindow::AllowTabbedDocks);
    installInputFilters(this);  // before the first combo box accepts the focus from the wheel
    m_panel = new ModulePanel(*m_requests, this);
    setCentralWidget(m_panel);
    buildDocks();
    m_pendant = new Pendant(*this, *m_panel);
    m_operator = new OperatorLock(settings, this);
    m_bell = new Bell(settings, this);
    buildTop();
    m_linkBar = new LinkBar(this);
    setStatusBar(m_linkBar);
    connectParts();
    showSession();
    showSelected();
    showOperator();
    restoreLayout();
    if (!m_settings.value(kSafetyRead, false).toBool())
        showMessage(texts::safety());
}

MainWindow::~MainWindow() {
    // A field that has the focus loses it during destruction and reports the value typed into it. By then,
    // this object is no longer a MainWindow. What it is reported to must be the last child that is deleted.
    m_requests->blockSignals(true);
    m_requests->setParent(nullptr);
    m_requests->setParent(this);
    for (QObject* child : findChildren<QObject*>())
        child->disconnect(this);
    qApp->disconnect(this);
}

void MainWindow::buildTop() {
    // One widget above everything: STOP ALL is never covered, hidden or moved by a layout.
    auto* top = new QWidget(this);
    auto* menuBar = new QMenuBar(top);
    // A menu bar shown by the desktop would keep Esc to itself.
    menuBar->setNativeMenuBar(false);
    look::name(menuBar, u"menuBar"_s, tr("Menus"));
    m_bar = new ConnectionBar(top);
    m_start = new StartPage(*m_bar, m_panel);
    fillMenus(*menuBar, *this, m_settings);
    m_ribbons = new Ribbons(*m_requests, *m_operator, *m_pendant, top);
    m_banner = new Banner(*m_model, top);
    form::fill(top, form::newColumn(top, {menuBar, m_bar, m_ribbons->column(), m_banner}, 0));
    setMenuWidget(top);
    setMinimumWidth(m_bar->minimumSizeHint().width());
    QWidget::setTabOrder(m_bar, m_chain);
}

void MainWindow::connectParts() {
    connect(&m_session, &Session::phaseChanged, this, &MainWindow::showPhase);
    connect(&m_session, &Session::changed, this, &MainWindow::showModules);
    connect(&m_session, &Session::aged, this, [this] {
        m_chain->showLink(m_session.link(), m_session.machine(), m_session.procedures());
        if (const ModuleState* module = m_session.selected();
            module != nullptr && m_session.viewOf(*module).age)
            showSelected();
    });
    connect(m_pendant, &Pendant::changed, this, &MainWindow::showPendant);
    connect(m_pendant, &Pendant::stopRequested, this, &MainWindow::requestStop);
    connect(m_sequences, &SequencesDock::ended, m_bell, &Bell::ring);
    connect(m_operator, &OperatorLock::changed, this, &MainWindow::showOperator);
    connect(&m_session, &Session::disconnectRequested, this, &MainWindow::disconnectRequested);
    connect(m_bar, &ConnectionBar::connectRequested, this,
            [this](const QString& port, quint32 baud, bool readOnly) {
                m_settings.setValue(kLastPort, port);
                m_settings.setValue(kLastBaud, baud);
                emit connectRequested(port, baud, readOnly);
            });
    connect(m_bar, &ConnectionBar::disconnectRequested, this, &MainWindow::askBeforeDisconnect);
    connect(m_bar, &ConnectionBar::stopAllRequested, this, &MainWindow::requestStop);
    connect(m_requests, &Requests::restart, this, &MainWindow::askBeforeRestart);
    connect(m_machineMenu, &MachineMenu::shown, this, &MainWindow::showSession);
    connect(m_machineMenu, &MachineMenu::shown, this, &MainWindow::reviewQuestions);
    // Queued: by then it is settled which window has the focus.
    connect(qApp, &QGuiApplication::focusWindowChanged, this, &MainWindow::reviewQuestions,
            Qt::QueuedConnection);
    connect(new EscFilter(this), &EscFilter::pressed, this, &MainWindow::requestStop);
    connect(new PressFilter(m_bar->stopButton(), this), &PressFilter::pressed, this,
            &MainWindow::requestStop);
    connect(new OtherWindows(this), &OtherWindows::opened, this, &MainWindow::endHold);

    connect(m_chain, &ChainView::moduleSelected, &m_session, &Session::select);
    connect(&m_session, &Session::selectionChanged, this, &MainWindow::showSelected);
    connect(&m_preparing, &QTimer::timeout, this, &MainWindow::preparePage);
    connect(
        m_panel, &ModulePanel::pageChanged, this, [this] { makeRoomForMotions(0); }, Qt::QueuedConnection);
    connect(m_simulator, &SimulatorDock::wantedChanged, this,
            [this](bool wanted) { m_settings.setValue(m_layouts->key(kSimulatorOpen), wanted); });
    connect(m_scope, &ScopePanel::setupChanged, this,
            [this](const ScopeSetup& setup) { m_settings.setValue(m_layouts->key(kScope), setup.toText()); });
    m_scope->presets().showPresets(m_settings.value(kScopePresets).toStringList());
    connect(&m_scope->presets(), &ScopePresets::presetsChanged, this,
            [this](const QStringList& presets) { m_settings.setValue(kScopePresets, presets); });
    connect(m_banner, &Banner::actionTriggered, this, &MainWindow::takeMessageAction);
    connect(m_banner, &Banner::allWanted, this, [this](const QString& key) {
        showDockOf(*m_messages);
        m_messages->reveal(key);
    });
    connect(&m_messages->list(), &MessageList::actionTriggered, this, &MainWindow::takeMessageAction);
}

/// Shows the pendant mode, and the axis that it moves.
void MainWindow::showPendant() {
    auto refusal = whyInaccessible(m_session.link());
    if (!refusal || refusal == Refusal::OperatorMode)
        refusal = whyNoChain(m_session.link());
    m_pendant->showModule(refusal ? texts::refusal(*refusal)
                          : m_panel->page() == nullptr
                              ? tr("No module can be moved. Connect a motor module first.")
                              : QString());
    m_ribbons->showPendant(m_session.selected());
}

void MainWindow::showPrograms(const ProgramsShown& programs) {
    m_chainMenu->showPrograms(programs.on);
    m_ribbons->showPrograms(programs);
}

void MainWindow::askForControl(const QString& program, const std::function<bool()>& stands,
                               const std::function<void(bool may)>& decided) {
    AskDialog& dialog = AskDialog::ask(
        {.name = u"programControlQuestion"_s,
         .title = Common::tr("Other programs"),
         .text =
             [program, stands] {
                 return stands()
                            ? tr("Let the program \"%1\" move motors? Esc, STOP ALL or any command of yours ends that.")
                                  .arg(program)
                            : QString();
             },
         .stay = tr("Refuse"),
         .stayName = u"refuseControlButton"_s},
        {{tr("Let it move motors"), u"grantControlButton"_s, [decided] { decided(true); }}}, this);
    // Queued: the choice that closes the dialog is carried out after this.
    connect(
        &dialog, &QDialog::finished, this, [decided] { decided(false); }, Qt::QueuedConnection);
}

void MainWindow::showOperator() {
    m_machineMenu->setLocked(m_operator->isLocked());
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        look::adoptReadable(this);
}

bool MainWindow::focusNextPrevChild(bool next) {
    return !m_focus->leave() && (m_focus->resume(next) || QMainWindow::focusNextPrevChild(next));
}

void MainWindow::showLink(const LinkState& state) {
    m_session.setLink(state);
}

void MainWindow::showPhase(LinkPhase before) {
    const LinkState& link = m_session.link();
    if (before == LinkPhase::Disconnected && m_session.isOpen()) {
        m_panel->forgetModules();
        if (ResponsePage* page = m_response->builtPage())
            page->forgetModules();
        m_loopTests->forgetModules();
    }
    if (before != link.phase && link.phase == LinkPhase::Connecting) {
        m_panel->resetSpeeds();
        if (AxesPage* page = m_axes->builtPage())
            page->forgetModules();
    }
    if (link.phase == LinkPhase::Connected)
        m_preparing.start(kPrepareInterval);
    showSession();
    reviewMessages();
}

void MainWindow::reviewMessages() {
    m_reviewedFor = m_session.link().rights;
    m_model->review(m_session.link());
}

void MainWindow::showModules() {
    const LinkState& link = m_session.link();
    m_bar->showLink(link);
    if (m_session.movingMotors() > 0)
        endMessage(texts::key::kStopped);  // no longer true
    m_linkBar->showLink(link);
    for (const ModuleState& module : link.modules)
        m_panel->dropReplaced(module.info);
    m_simulator->showLink(link);
    m_monitor->showLink(link);
    m_messages->offerModules(static_cast<int>(link.modules.size()));
    m_chain->showLink(link, m_session.machine(), m_session.procedures());
    m_chainMenu->refresh();
    if (m_reviewedFor != link.rights)
        reviewMessages();
    showAllAxes();
    showSelected();
}

void MainWindow::showSession() {
    const LinkState& link = m_session.link();
    const QString port = texts::portName(QString::fromStdString(link.port));
    const bool open = m_session.isOpen();
    const bool simulated = open && link.simulated;
    const bool readOnly = open && link.readOnly;
    QString title = simulated ? tr("NMC Panel - Simulator")
                    : open    ? tr("NMC Panel - %1").arg(port)
                              : tr("NMC Panel");
    if (readOnly)
        title = tr("%1 (read-only)").arg(title);
    const QString machine = m_machineMenu->titlePart();
    // A title without a machine has no place for the mark of changes.
    setWindowModified(false);
    setWindowTitle(machine.isEmpty() ? title : title + u" - "_s + machine);
    setWindowModified(m_machineMenu->file().modified);
    m_ribbons->showSession(m_session);
}

QString MainWindow::nothingText() const {
    switch (m_session.link().phase) {
        case LinkPhase::Disconnected:
            break;  // the start page says what to do
        case LinkPhase::Connecting:
            return texts::link(m_session.link());
        case LinkPhase::Connected:
        case LinkPhase::Lost:
            return Common::tr("No module");
    }
    return {};
}

/// Prepares one page at a time, and only while nothing moves, so that nothing has to wait, least of all a
/// stop. The page is then ready when its module is selected for the first time.
void MainWindow::preparePage() {
    if (m_session.movingMotors() > 0)
        return;
    for (const ModuleState& module : m_session.link().modules)
        if (m_panel->prepare(m_session.viewOf(module)))
            return;
    m_preparing.stop();
}

void MainWindow::showSelected() {
    if (const ModuleState* module = m_session.selected()) {
        m_chain->showSelected(module->info.index);
        m_chainMenu->showSelected(module->info.index);
        const PanelView view = m_session.viewOf(*module);
        m_panel->showModule(view);
        m_response->showModule(view);
        m_loopTests->showModule(view);
    } else {
        // The menu may be open, with commands of a module that is gone.
        if (auto* menu = findChild<QMenu*>(u"moduleMenu"_s))
            menu->close();
        if (!m_session.isOpen())
            m_panel->showInstead(*m_start);
        else
            m_panel->showNothing(nothingText(), m_session.link().phase == LinkPhase::Connecting);
        m_response->showNothing();
        m_loopTests->showNothing();
    }
    m_simulator->showSelected(selectedModule());
    showPendant();
    // Without a connection, the scope still shows the last samples, and whose they are.
    if (const LinkState& link = m_session.link(); !link.modules.empty()) {
        m_scope->showModules(m_session.scopeModules(), selectedModule());
        m_scope->showSession(QString::fromStdString(link.port), link.simulated);
    }
    reviewQuestions();
}

std::optional<ModuleIndex> MainWindow::selectedModule() const {
    const ModuleState* module = m_session.selected();
    return module != nullptr ? std::optional(module->info.index) : std::nullopt;
}

void MainWindow::showFigures(const LinkFigures& figures) {
    m_linkBar->showFigures(figures);
    m_monitor->showFigures(figures);
}

void MainWindow::showMachine(const Machine& machine) {
    std::set<ModuleIndex> edited;
    for (const ModuleState& module : m_session.link().modules)
        if (machine.axis(module.info.index) != m_session.machine().axis(module.info.index))
            edited.insert(module.info.index);
    m_session.setMachine(machine);
    for (const ModuleState& module : m_session.link().modules)
        if (edited.contains(module.info.index))
            m_panel->keepUpToDate(m_session.viewOf(module));
    m_operator->showRights(machine.operatorRights);
}

void MainWindow::showProcedure(const ProcedureReport& report) {
    const auto before = m_session.procedures().find(report.module);
    const bool ran = before != m_session.procedures().end() && !before->second.over();
    using enum ProcedureKind;
    const bool ofAMove = report.kind == MoveBy || report.kind == Approach || report.kind == ChangeMotion;
    if (ran && report.over() && !ofAMove)
        m_bell->ring();
    m_session.setProcedure(report);
}

ScopeFiles& MainWindow::scopeFiles() {
    return m_scope->files();
}

Message MainWindow::ofThisConnection(Message message) const {
    message.connection = m_session.isOpen() ? m_session.link().connection : 0;
    return withoutImpossible(std::move(message), m_session.link());
}

void MainWindow::showMessage(const Message& news) {
    const Message message = ofThisConnection(news);
    m_model->report(message);
    if (message.severity == Severity::Fault)
        m_bell->ring();
}

void MainWindow::amendMessage(const Message& news) {
    m_model->amend(ofThisConnection(news));
    if (news.key == texts::key::kStop)
        m_bar->showStopResult(news.headline);
}

void MainWindow::endMessage(const QString& key) {
    m_model->end(key);
}

void MainWindow::takeMessageAction(const Message& message, MessageAction action) {
    if (!mayAct(message, action, m_session.link()))
        return;  // its connection may have gone while the button was held down
    if (action == MessageAction::CopyCommand) {
        QGuiApplication::clipboard()->setText(message.command);
    } else if (action == MessageAction::ChoosePort) {
        m_bar->openPorts();
    } else if (action == MessageAction::RestartNetwork) {
        return askBeforeRestart();  // the message stays until that is done
    } else if (action == MessageAction::StopAll) {
        requestStop();
        endMessage(message.key);
    } else if (action == MessageAction::ShowQuestion) {
        if (AskDialog* question = AskDialog::waiting(*this))
            question->comeForward();
    } else if (action == MessageAction::Understood) {
        m_settings.setValue(kSafetyRead, true);
        endMessage(message.key);
    }
    emit messageAction(message, action);
}

void MainWindow::requestStop() {
    if (!m_session.link().hasChain())
        return;
    endHold();
    emit stopAllRequested();
    if (!m_session.isOpen())
        showMessage(texts::stopWaits());
}

Message MainWindow::showStopResult(const bus::StopFinished& finished, unsigned record) {
    Message result = texts::stopResult(finished, m_session.link().modules);
    m_bar->showStopResult(result.headline);
    const bool all = texts::allStopped(finished, m_session.link().modules);
    if (all)
        endMessage(texts::key::kStop);
    result.record = record;
    if (record != 0)
        result = texts::withRecord(result);
    showMessage(result);
    m_session.stopFinished(all);
    return result;
}

void MainWindow::showAllAxes() {
    m_sequences->showSession(m_session.link(), m_session.machine());
    if (m_paths->seen())
        m_paths->page().showSession(m_session.link(), m_session.machine(), m_session.procedures());
    if (!m_axes->seen())
        return;
    std::vector<PanelView> views;
    for (const ModuleState& module : m_session.link().modules)
        views.push_back(m_session.viewOf(module));
    m_axes->page().showModules(views, m_session.machine());
}

void MainWindow::endHold() {
    m_panel->endHold();
    if (AxesPage* page = m_axes->builtPage())
        page->endHold();
}

// ---- docks and layouts ----

QDockWidget* MainWindow::newDock(const QString& objectName, const QString& title, QWidget* content) {
    auto* dock = new QDockWidget(title, this);
    look::name(dock, objectName, title);
    dock->setWidget(content);
    return dock;
}

void MainWindow::showDockOf(const QWidget& content) {
    for (QDockWidget* dock : m_layouts->docks())
        if (dock->isAncestorOf(&content))
            m_layouts->open(*dock);
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
    m_paths =
        new PathsDock(u"pathsDock"_s, PathsPage::tr("Paths"), Qt::SHIFT | Qt::Key_F3, *m_requests, this);
    m_axes = new AxesDock(u"axesDock"_s, AxesPage::tr("All axes"), Qt::Key_F4, *m_requests, this);
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
    connect(m_requests, &Requests::showRun, m_response, &ResponseDock::showRun);
    connect(m_loopTests, &LoopTestsDock::reportWanted, this,
            [this] { saveTuningReport(m_session, *m_response, *m_loopTests, *m_requests, this); });
    for (LazyDock* dock : std::initializer_list<LazyDock*>{m_sequences, m_paths, m_axes})
        connect(dock, &LazyDock::opened, this, &MainWindow::showAllAxes);
    QAction* step = look::newAction(this, u"stepNowAction"_s, tr("Step"), {}, Qt::SHIFT | Qt::Key_F9);
    addAction(step);
    connect(step, &QAction::triggered, this, &MainWindow::stepNow);
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
        if (ResponsePage* page = m_response->builtPage())
            page->takeFormBack();
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

// ---- the scope ----

const std::vector<ScopeModule>& MainWindow::scopeModules() const {
    return m_scope->modules();
}

void MainWindow::showHistory(const History& history, TimePoint now) {
    m_scope->showHistory(history, now);
    if (m_session.isOpen())
        showTime(now);
}

void MainWindow::showTime(TimePoint now) {
    m_session.setNow(now);
}

void MainWindow::showRecord(std::shared_ptr<const ScopeRecord> record) {
    showDockOf(*m_scope);
    m_scope->showRecord(std::move(record));
}

void MainWindow::showUnder(std::shared_ptr<const ScopeRecord> record) {
    showDockOf(*m_scope);
    m_scope->showUnder(std::move(record));
}

std::set<ModuleIndex> MainWindow::watchedModules() const {
    std::set<ModuleIndex> watched = m_scope->watchedModules();
    if (m_axes->seen())
        for (const ModuleState& module : m_session.link().modules)
            watched.insert(module.info.index);
    if (const std::optional<ModuleIndex> selected = selectedModule())
        watched.insert(*selected);
    return watched;
}

// ---- the Module menu and the palette ----

void MainWindow::fillModuleMenu(QMenu& menu) {
    menu.clear();
    ModulePage* page = m_panel->page();
    if (page == nullptr) {
        menu.addAction(Common::tr("No module"))->setEnabled(false);
        return;
    }
    page->context().catchUp();
    // Commands whose box is not visible are not updated otherwise, so this continues while the menu is open.
    auto* open = new QObject(page);
    connect(&menu, &QMenu::aboutToHide, open, &QObject::deleteLater);
    connect(&page->context(), &ModuleContext::changed, open, [page] { page->context().catchUp(); });
    const QWidget* box = nullptr;
    for (Command* command : page->commands()) {
        if (!command->isVisible())
            continue;
        if (box != nullptr && box != command->box())
            menu.addSeparator();
        box = command->box();
        menu.addAction(command);
    }
    menu.addSeparator();
    menu.addAction(m_pendant->action());
}

void MainWindow::openPalette() {
    if (m_palette == nullptr)
        m_palette = new CommandPalette(this);
    m_palette->showEntries(
        paletteEntries(*m_panel, m_session, m_pendant->action(), *findChild<QMenuBar*>(u"menuBar"_s)));
}

/// Where digits are typed with Shift (AZERTY), Qt does not recognise Ctrl with a digit's key as Ctrl+1,
/// although that is what the user means.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    constexpr quint32 kKeyOf1 = 10;  // on X11 and Wayland: the kernel's KEY_1 plus 8
    constexpr quint32 kDigits = 8;
    const quint32 above1 = event->nativeScanCode() - kKeyOf1;
    if (event->modifiers() != Qt::ControlModifier || event->isAutoRepeat() || above1 >= kDigits)
        return QMainWindow::keyPressEvent(event);
    const QKeySequence wanted(QKeyCombination(Qt::CTRL, static_cast<Qt::Key>(Qt::Key_1 + above1)));
    for (QAction* action : findChildren<QAction*>())
        if (action->isEnabled() && action->shortcut() == wanted)
            return action->trigger();
}

// ---- questions before closing and stopping ----

void MainWindow::askBeforeStopping(const QString& name, const QString& stopText,
                                   const std::function<void()>& go) {
    AskDialog::ask({.name = name,
                    .title = tr("Motors are moving"),
                    .text = m_session.whileOpen(texts::closing),
                    .stayName = u"stayButton"_s,
                    .goIsDefault = true},
                   {{stopText, u"stopAndCloseButton"_s,
                     [this, go] {
                         emit stopAllRequested();
                         go();
                     }}},
                   this);
}

void MainWindow::askBeforeDisconnect() {
    if (!m_session.leavingStopsMotors())
        emit disconnectRequested();
    else
        askBeforeStopping(u"disconnectDialog"_s, tr("&Stop and disconnect"),
                          [this] { m_session.disconnectWhenStopped(); });
}

/// Shows a waiting question in the banner, where the user may look meanwhile. It is not an event for the list
/// of messages.
void MainWindow::reviewQuestions() {
    AskDialog::reviewAll(*this);
    const AskDialog* question = AskDialog::waiting(*this);
    const QString title = question != nullptr ? question->windowTitle() : QString();
    if (std::exchange(m_waiting, title) == title)
        return;
    if (question != nullptr)
        m_banner->setNotice(texts::questionWaits(title, question->text()));
    else
        m_banner->setNotice({});
}

void MainWindow::askBeforeRestart() {
    if (whyInaccessible(m_session.link()))
        return;
    AskDialog::ask({.name = u"restartDialog"_s,
                    .title = tr("Restart the network"),
                    .text = m_session.whileOpen(texts::beforeRestart),
                    .stayName = u"cancelRestartButton"_s},
                   {{tr("&Restart the network: positions and gains are lost"), u"restartButton"_s,
                     [this] { emit restartNetworkRequested(); }}},
                   this);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool moving = !m_mayClose && m_session.leavingStopsMotors();
    const MachineFile& file = m_machineMenu->file();
    const bool unsaved = !m_mayClose && !m_workMayWait && (file.modified || file.saving);
    if (!moving && !unsaved) {
        endHold();
        m_settings.setValue(kGeometry, saveGeometry());
        m_layouts->save();
        event->accept();
        return;
    }
    event->ignore();
    if (moving)
        askBeforeStopping(u"closeDialog"_s, tr("&Stop and close"), [this] {
            m_bar->showStopResult(texts::stoppingBeforeClose());
            emit closeConfirmed();
        });
    else
        m_machineMenu->askBeforeClose([this] {
            // Motors may have been started since the question was asked.
            m_workMayWait = true;
            close();
            m_workMayWait = false;
        });
}

void MainWindow::finishClose() {
    m_mayClose = true;
    close();
}

// ---- manual and problem report ----

/// Creates the window, which reads the manual's pages, when it is first opened; it remembers what the user
/// has read.
ManualWindow& MainWindow::manual() {
    auto* manual = findChild<ManualWindow*>();
    return manual != nullptr ? *manual : *new ManualWindow(Manual(), this);
}

void MainWindow::openProblemReport() {
    auto* dialog = findChild<ReportDialog*>();
    if (dialog == nullptr) {
        const QString report = problemReport(
            {m_settings, m_session.link(), m_monitor->figures(), m_bar->ports(),
             m_monitor->lastPackets(kReportedPackets),
             QString::fromStdString(messageText({m_model->entries().begin(), m_model->entries().end()}))});
        dialog = new ReportDialog(report, *m_requests, this);
    }
    look::showInFront(dialog);
}

}  // namespace nmc
