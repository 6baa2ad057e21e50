// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "link/ports/linktypes.h"
#include "model/intent/intent.h"
#include "model/module/linkstate.h"
#include "model/packets/packetlog.h"
#include "model/procedure/procedure.h"
#include "model/scope/history.h"
#include "model/settings/machine.h"
#include "widgets/common/filedialog.h"
#include "widgets/common/texts.h"
#include "widgets/mainwindow/commandpalette.h"
#include "widgets/mainwindow/layouts.h"
#include "widgets/mainwindow/session.h"
#include "widgets/panels/panelview.h"
#include "widgets/scope/scoperecord.h"

class QDockWidget;
class QMenu;
class QSettings;

namespace nmc {

class AxesDock;
class Banner;
class Bell;
class ChainView;
class ColourChoice;
class ConnectionBar;
class FocusKeeper;
class LinkBar;
class ChainMenu;
class MachineMenu;
class ManualWindow;
class MessagePanel;
class ModulePanel;
class MonitorDock;
class PathsDock;
class OperatorLock;
class Pendant;
class Ribbon;
class ScopeFiles;
class ScopePanel;
class LoopTestsDock;
struct TuningReport;
class SequencesDock;
class SimulatorDock;
class StartPage;
class ResponseDock;
struct KeptResponse;

/// The panel's window. Values in, intents out: it never sees the bus, a thread or a port. Every show...() is
/// idempotent and emits nothing (but a hold that loses its ground ends, and says so).
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `settings` keeps geometry and layout, the last port, and whether the safety note was read; it must
    /// outlive the window.
    explicit MainWindow(QSettings& settings, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// The serial ports there are; the simulator is added by the window.
    void showPorts(const QList<PortEntry>& ports);
    /// Puts a port (listed or not) and a rate into the tool bar; 0 keeps the rate. Does not connect.
    void choosePort(const QString& port, quint32 baud);
    void showLink(const LinkState& state);
    /// Once a second.
    void showFigures(const LinkFigures& figures);
    /// What the modules have said so far, at most 60 times a second, and after scopeFrameWanted().
    void showHistory(const History& history, TimePoint now);
    /// How old what was said last is by now; showHistory() tells as well, while a port is open.
    void showTime(TimePoint now);
    /// In the scope, instead of what is live, until the user goes back; opens the scope if it is closed.
    void showRecord(std::shared_ptr<const ScopeRecord> record);
    /// The same below what is live.
    void showUnder(std::shared_ptr<const ScopeRecord> record);
    /// How the scope reads the modules that are there, or were last.
    [[nodiscard]] const std::vector<ScopeModule>& scopeModules() const;
    /// What the user has told about the machine: names, units, values kept for each axis.
    void showMachine(const Machine& machine);
    /// How a procedure of some module goes, or went.
    void showProcedure(const ProcedureReport& report);
    /// A step response that was made; the list of runs gives it its number.
    void showResponse(const KeptResponse& run);
    /// A new cause, or the same again: repeats are counted.
    void showMessage(const Message& message);
    /// More is known of a cause that is told already: no repeat, and nothing where it is over or hidden.
    void amendMessage(const Message& message);
    /// The cause is gone.
    void endMessage(const QString& key);
    void showStopResult(const bus::StopFinished& finished);
    /// The built-in simulator's answer, in JSON, to a line of simulatorLineEntered().
    void showSimulatorAnswer(const QString& line, const QByteArray& json);
    /// A connection is being opened: the packet monitor forgets the one before.
    void beginPackets(const PacketSession& session);
    /// What was recorded since the last call, once a frame while packetRecordingWanted().
    void showPackets(std::vector<bus::ExchangeRecord> records);
    /// The bus has ended what is held: the button comes up, and must be pressed anew.
    void endHold();
    /// How often a held button says so; 100 ms.
    void setHoldInterval(int milliseconds);

    /// The machine's file: its part of the File menu, its dialogs, and the name in the title.
    [[nodiscard]] MachineMenu& machineMenu() { return *m_machineMenu; }
    [[nodiscard]] ChainMenu& chainMenu() { return *m_chainMenu; }
    [[nodiscard]] Bell& bell() { return *m_bell; }
    [[nodiscard]] ColourChoice& colours() { return *m_colours; }
    [[nodiscard]] OperatorLock& operatorLock() { return *m_operator; }
    [[nodiscard]] MessagePanel& messages() { return *m_messages; }
    /// Points and sequences: edited, foreseen, run.
    [[nodiscard]] SequencesDock& sequences() { return *m_sequences; }
    /// Paths of CMC and SC: opened, drawn, run.
    [[nodiscard]] PathsDock& paths() { return *m_paths; }
    [[nodiscard]] ResponseDock& stepResponses() { return *m_response; }
    [[nodiscard]] LoopTestsDock& loopTests() { return *m_loopTests; }
    /// All axes at once.
    [[nodiscard]] AxesDock& axes() { return *m_axes; }
    /// Recording, opening a recording, and what is exported.
    [[nodiscard]] ScopeFiles& scopeFiles();
    /// Empty while there is no module.
    [[nodiscard]] std::optional<ModuleIndex> selectedModule() const;

    /// Those that panel and scope show.
    [[nodiscard]] std::vector<ModuleIndex> watchedModules() const;

    /// Closes for good: after closeConfirmed(), when the motors are known to be stopped or there is no more
    /// hope.
    void finishClose();
    [[nodiscard]] Layouts& layouts() { return *m_layouts; }
    /// As it stands at first.
    void resetLayout();
    /// Restarts the network if the user confirms it.
    void askBeforeRestart();
    /// Connects to the port in the tool bar, and only looks.
    void connectReadOnly();
    /// What the selected module can be told, as it is now.
    void fillModuleMenu(QMenu& menu);
    /// The manual, at "keys.md", or at what is said there of this widget.
    void openManual(const QString& page);
    void openManualAt(const QWidget* widget);
    /// Everything that helps to find out what went wrong, to be read, and saved.
    void openProblemReport();
    /// Every command of the window, to be found by its words.
    void openPalette();

signals:
    /// `readOnly`: asked for each time, never remembered.
    void connectRequested(const QString& port, quint32 baud, bool readOnly = false);
    /// To the port that is open read-only.
    void connectFullyRequested();
    void disconnectRequested();
    /// The user has confirmed that positions and gains are lost.
    void restartNetworkRequested();
    void stopAllRequested();
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// On press and every 100 ms while held; each press has a number of its own.
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// The user changed what the panel knows of an axis; nothing is sent by that.
    void axisEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);
    /// A control line for the built-in simulator; only while attached to it.
    void simulatorLineEntered(const QString& line);
    /// The packet monitor wants every exchange from now on, or no more.
    void packetRecordingWanted(bool wanted);
    /// The scope is to show something else, whether anything came in or not: showHistory() soon.
    void scopeFrameWanted();
    /// Packets, step responses, or what the scope shows; the user has agreed that the file is replaced.
    void saveRequested(const QString& path, const nmc::FileContent& content);
    /// The port list is about to be opened.
    void portsRequested();
    void moduleSelected(nmc::ModuleIndex module);
    /// The user chose to stop and close; stopAllRequested() went before. The owner answers with
    /// finishClose().
    void closeConfirmed();
    /// A button of a message that may act; what the window can do itself is done already.
    void messageAction(const nmc::Message& message, nmc::MessageAction action);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    /// What nothing in the window has taken.
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    [[nodiscard]] QMenu* createPopupMenu() override { return nullptr; }

private:
    [[nodiscard]] ManualWindow& manual();
    void buildCentre();
    void buildTop();
    void buildRibbons(QWidget* top);
    void buildDocks();
    void arrangeDocks(Layouts::Kind kind);
    void giveRoomToPlots();
    void keepColumn(int wider);
    void showLayout(Layouts::Kind kind);
    [[nodiscard]] static QString simulatorOpen(Layouts::Kind kind);
    void stepNow();
    void connectParts();
    QDockWidget* addDock(const QString& objectName, const QString& title, QWidget* content,
                         Qt::DockWidgetArea area);
    void showDockOf(const QWidget& content);
    void addSimulatorDock();
    void addResponseDock(QDockWidget& scope, QDockWidget& messages);
    void makeRoomBeside(QDockWidget& messages, QDockWidget& dock, int lines);
    void makeRoomForSequences(QDockWidget& messages);
    [[nodiscard]] std::optional<TuningReport> tuningReport();
    void chooseReportFile();
    void addLoopTestsDock(QDockWidget& scope, QDockWidget& messages);
    void addMotionDocks(QDockWidget& scope, QDockWidget& messages);
    void saveFrequencies(const QString& path, const QDateTime& measured);
    void showAllAxes();
    void makeRoomForSimulator();
    void makeRoomForMotions(int higher);
    void restoreLayout();
    void saveLayout();
    void showSafetyOnce();
    void showSession();
    void showModules();
    void showSelected();
    void preparePage();
    void addModuleEntries(std::vector<CommandPalette::Entry>& entries);
    void addOtherModules(std::vector<CommandPalette::Entry>& entries);
    void showPhase(LinkPhase before);
    void showScopeModules();
    void showPendant();
    void showOperator();
    void reviewMessages();
    void requestStop();
    void askBeforeDisconnect();
    void reviewQuestions();
    void askBeforeStopping(const QString& name, const QString& stopText, const std::function<void()>& go);
    [[nodiscard]] Message ofThisConnection(Message message) const;
    void takeMessageAction(const Message& message, MessageAction action);
    [[nodiscard]] const ModuleState* selectedState() const { return m_session.module(selectedModule()); }
    [[nodiscard]] QString nothingText() const;

    QSettings& m_settings;
    ColourChoice* m_colours;
    Session m_session;
    FocusKeeper* m_focus;
    MachineMenu* m_machineMenu;
    ChainMenu* m_chainMenu;
    ConnectionBar* m_bar = nullptr;
    Ribbon* m_simulatorRibbon = nullptr;
    Ribbon* m_readOnlyRibbon = nullptr;
    Ribbon* m_pendantRibbon = nullptr;
    Ribbon* m_operatorRibbon = nullptr;
    Pendant* m_pendant = nullptr;
    OperatorLock* m_operator = nullptr;
    QString m_waiting;                            ///< the title of the question that the banner tells of
    std::optional<OperatorRights> m_reviewedFor;  ///< as the messages' buttons are
    Bell* m_bell = nullptr;
    Banner* m_banner = nullptr;
    ModulePanel* m_panel = nullptr;
    StartPage* m_start = nullptr;
    ChainView* m_chain = nullptr;
    ScopePanel* m_scope = nullptr;
    QDockWidget* m_scopeDock = nullptr;  ///< its place
    MessagePanel* m_messages = nullptr;
    SimulatorDock* m_simulator = nullptr;
    MonitorDock* m_monitor = nullptr;
    ResponseDock* m_response = nullptr;
    LoopTestsDock* m_loopTests = nullptr;
    SequencesDock* m_sequences = nullptr;
    PathsDock* m_paths = nullptr;
    AxesDock* m_axes = nullptr;
    LinkBar* m_linkBar = nullptr;
    CommandPalette* m_palette = nullptr;
    QList<QDockWidget*> m_docks;
    QByteArray m_firstState;
    Layouts* m_layouts = nullptr;
    QAction* m_stepNow = nullptr;
    QTimer m_preparing;
    int m_scopeGave = 0;  ///< pixels of height, to the motions
    bool m_mayClose = false;
    bool m_workMayWait = false;  ///< unsaved, as the user has just agreed
};

}  // namespace nmc
