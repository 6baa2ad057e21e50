// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "model/module/linkstate.h"
#include "model/procedure/procedure.h"
#include "model/scope/history.h"
#include "model/settings/machine.h"
#include "widgets/common/texts.h"
#include "widgets/mainwindow/layouts.h"
#include "widgets/mainwindow/session.h"
#include "widgets/scope/scoperecord.h"

class QDockWidget;
class QMenu;
class QSettings;

namespace nmc {

class AxesPage;
class Banner;
class Bell;
class ChainView;
class ColourChoice;
class CommandPalette;
class ConnectionBar;
class FocusKeeper;
class LinkBar;
class ChainMenu;
class MachineMenu;
class ManualWindow;
class MessageModel;
class MessagePanel;
class ModulePanel;
class MonitorDock;
class PathsPage;
class OperatorLock;
class Pendant;
class Requests;
class Ribbons;
class ScopeFiles;
class ScopePanel;
class LoopTestsDock;
class SequencesDock;
class SimulatorDock;
class StartPage;
class ResponseDock;
struct ProgramsShown;
template <typename Page>
class PageDock;

// Closed initially; their content is built when it is first seen.
using AxesDock = PageDock<AxesPage>;
using PathsDock = PageDock<PathsPage>;

/// The panel's window. Values in, intents out: it has no access to the bus, a thread or a port. Every
/// show...() is idempotent and emits nothing, except that a hold that is no longer possible ends and reports
/// that.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `settings` stores geometry and layout, the last port, and whether the safety note was read; it must
    /// outlive the window.
    explicit MainWindow(QSettings& settings, QWidget* parent = nullptr);
    ~MainWindow() override;

    void showLink(const LinkState& state);
    /// Call once a second.
    void showFigures(const LinkFigures& figures);
    /// Shows what the modules have reported so far. Call at most 60 times a second, and after
    /// ScopePanel::frameWanted().
    void showHistory(const History& history, TimePoint now);
    /// Updates the age of the last reports; showHistory() does so, too, while a port is open.
    void showTime(TimePoint now);
    /// Shows a record in the scope instead of the live samples, until the user goes back; opens the scope if
    /// it is closed.
    void showRecord(std::shared_ptr<const ScopeRecord> record);
    /// Shows a record in the scope under the live traces; opens the scope if it is closed.
    void showUnder(std::shared_ptr<const ScopeRecord> record);
    /// How the scope reads the modules of this connection, or of the last one.
    [[nodiscard]] const std::vector<ScopeModule>& scopeModules() const;
    /// Shows what the user has entered about the machine: names, units, and values stored for each axis.
    void showMachine(const Machine& machine);
    void showPrograms(const ProgramsShown& programs);
    /// Asks the user whether the program may move motors, for as long as `stands`; `decided` may be called
    /// after that.
    void askForControl(const QString& program, const std::function<bool()>& stands,
                       const std::function<void(bool may)>& decided);
    /// Shows the progress or the result of a procedure of any module.
    void showProcedure(const ProcedureReport& report);
    /// Shows a message about a new cause, or about the same one again: repeats are counted.
    void showMessage(const Message& message);
    /// More is known about a cause that is shown already. This is not a repeat, and has no effect if the
    /// cause has ended or is hidden.
    void amendMessage(const Message& message);
    /// The cause has ended.
    void endMessage(const QString& key);
    /// `record`: as in Message. Returns the message that it shows.
    Message showStopResult(const bus::StopFinished& finished, unsigned record = 0);
    /// The bus has ended the hold: the button is released, and must be pressed again.
    void endHold();

    /// What the user requests anywhere in the window.
    [[nodiscard]] Requests& requests() { return *m_requests; }
    /// Port, rate, and the buttons that connect.
    [[nodiscard]] ConnectionBar& connectionBar() { return *m_bar; }
    /// The machine's file: its part of the File menu, its dialogs, and the name in the title.
    [[nodiscard]] MachineMenu& machineMenu() { return *m_machineMenu; }
    [[nodiscard]] ChainMenu& chainMenu() { return *m_chainMenu; }
    [[nodiscard]] Bell& bell() { return *m_bell; }
    [[nodiscard]] ColourChoice& colours() { return *m_colours; }
    [[nodiscard]] OperatorLock& operatorLock() { return *m_operator; }
    [[nodiscard]] MessagePanel& messages() { return *m_messages; }
    /// All messages of this session.
    [[nodiscard]] const MessageModel& messageModel() const { return *m_model; }
    /// Points and sequences: editing, preview, running.
    [[nodiscard]] SequencesDock& sequences() { return *m_sequences; }
    /// Paths of CMC and SC: opening, drawing, running.
    [[nodiscard]] PathsDock& paths() { return *m_paths; }
    [[nodiscard]] ResponseDock& stepResponses() { return *m_response; }
    [[nodiscard]] LoopTestsDock& loopTests() { return *m_loopTests; }
    /// All axes at once.
    [[nodiscard]] AxesDock& axes() { return *m_axes; }
    /// The switches and loads of the built-in simulator.
    [[nodiscard]] SimulatorDock& simulator() { return *m_simulator; }
    /// The packets on the line.
    [[nodiscard]] MonitorDock& monitor() { return *m_monitor; }
    [[nodiscard]] ScopePanel& scope() { return *m_scope; }
    /// Recording, opening a recording, and exporting.
    [[nodiscard]] ScopeFiles& scopeFiles();
    /// Empty while there is no module.
    [[nodiscard]] std::optional<ModuleIndex> selectedModule() const;

    /// The modules that the panel, the scope and the dock of all axes show.
    [[nodiscard]] std::set<ModuleIndex> watchedModules() const;

    /// Closes the window for good: after closeConfirmed(), when the motors are known to have stopped or can
    /// no longer be reached.
    void finishClose();
    [[nodiscard]] Layouts& layouts() { return *m_layouts; }
    /// Returns the chosen layout to its initial arrangement.
    void resetLayout();
    /// Restarts the network if the user confirms it.
    void askBeforeRestart();
    /// Fills the menu with the commands of the selected module, in its present state.
    void fillModuleMenu(QMenu& menu);
    [[nodiscard]] ManualWindow& manual();
    /// Shows everything that helps to find out what went wrong, for reading and saving.
    void openProblemReport();
    /// Opens the palette, in which every command of the window can be found by its words.
    void openPalette();

signals:
    /// `readOnly`: requested each time, never remembered.
    void connectRequested(const QString& port, quint32 baud, bool readOnly = false);
    void disconnectRequested();
    /// The user has confirmed that positions and gains are lost.
    void restartNetworkRequested();
    void stopAllRequested();
    /// The user chose to stop and close; stopAllRequested() was emitted before. The owner answers with
    /// finishClose().
    void closeConfirmed();
    /// The user has pressed an available button of a message; the window has already done what it can do
    /// itself.
    void messageAction(const nmc::Message& message, nmc::MessageAction action);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    /// Handles keys that nothing else in the window has accepted.
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    [[nodiscard]] QMenu* createPopupMenu() override { return nullptr; }

private:
    void buildTop();
    void buildDocks();
    void showLayout(Layouts::Kind kind);
    void stepNow();
    void connectParts();
    [[nodiscard]] QDockWidget* newDock(const QString& objectName, const QString& title, QWidget* content);
    void showDockOf(const QWidget& content);
    void showAllAxes();
    void makeRoomForMotions(int higher);
    void restoreLayout();
    void showSession();
    void showModules();
    void showSelected();
    void preparePage();
    void showPhase(LinkPhase before);
    void showPendant();
    void showOperator();
    void reviewMessages();
    void requestStop();
    void askBeforeDisconnect();
    void reviewQuestions();
    void askBeforeStopping(const QString& name, const QString& stopText, const std::function<void()>& go);
    [[nodiscard]] Message ofThisConnection(Message message) const;
    void takeMessageAction(const Message& message, MessageAction action);
    [[nodiscard]] QString nothingText() const;

    QSettings& m_settings;
    Requests* m_requests;
    MessageModel* m_model;
    ColourChoice* m_colours;
    Session m_session;
    FocusKeeper* m_focus;
    MachineMenu* m_machineMenu;
    ChainMenu* m_chainMenu;
    ConnectionBar* m_bar = nullptr;
    Ribbons* m_ribbons = nullptr;
    Pendant* m_pendant = nullptr;
    OperatorLock* m_operator = nullptr;
    QString m_waiting;                            ///< title of the waiting question that the banner shows
    std::optional<OperatorRights> m_reviewedFor;  ///< rights for which the messages' buttons were reviewed
    Bell* m_bell = nullptr;
    Banner* m_banner = nullptr;
    ModulePanel* m_panel = nullptr;
    StartPage* m_start = nullptr;
    ChainView* m_chain = nullptr;
    ScopePanel* m_scope = nullptr;
    QDockWidget* m_scopeDock = nullptr;  ///< contains m_scope
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
    Layouts* m_layouts = nullptr;
    QTimer m_preparing;
    int m_scopeGave = 0;  ///< height that the scope gave to the motions, in pixels
    bool m_mayClose = false;
    bool m_workMayWait = false;  ///< the user has just agreed to close with unsaved work
};

}  // namespace nmc
