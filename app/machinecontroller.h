// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSettings>
#include <QTimer>
#include <optional>

#include "link/connection/busstore.h"
#include "link/files/unsavedwork.h"
#include "model/intent/intent.h"
#include "model/machinefile/axiscopy.h"
#include "model/machinefile/machinefile.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// The machine as defined by the user, and its file. Opening a file shows what it would change; only what the
/// user then chooses is applied and sent. Unsaved work is stored every few seconds and offered again at the
/// next start. Writing never blocks the panel. GUI thread.
class MachineController : public QObject {
    Q_OBJECT

public:
    /// `unsavedFolder`: holds unsaved work; empty: beside the settings.
    MachineController(QSettings& settings, MainWindow& window, const BusStore& store,
                      const QString& unsavedFolder, const FileWriter::Disk& disk = writeFile);
    ~MachineController() override;

    [[nodiscard]] const Machine& machine() const { return m_machine; }

    /// Shows the machine, opens `file`, and offers the unsaved work of an earlier session. Without a file
    /// that can be read, operator mode goes on with the machine with which it was left.
    void start(const std::optional<QString>& file);
    /// The user has changed an axis in its panel.
    void edit(ModuleIndex module, const AxisSettings& settings);
    void editProgram(const Program& program);
    void editHomeOrder(const std::vector<ModuleIndex>& order);
    /// A setting that belongs to the machine was sent; it is recorded, because it cannot be read back.
    void noteSent(ModuleIndex module, const Intent& intent);
    /// The user has moved a module to another group, or out of all groups.
    void noteGroup(const bus::GroupChange& change);
    void nameGroup(quint8 group, const QString& name);
    /// Operator mode begins, with this machine.
    void setOperatorRights(const OperatorRights& rights);
    /// Makes these modules the expected ones (withModules()); those in `gone`, which no row of a sequence
    /// uses, are out of the chain. Also in operator mode, which may have begun since the user asked for it:
    /// everything else takes the modules to have their new numbers.
    void acceptChain(const std::vector<ModuleIdentity>& there, const std::vector<ModuleIndex>& gone = {});
    /// Restores the unsaved work of an earlier session.
    void restoreWork();
    void discardWork() { m_unsaved.dropLeft(); }

    /// Shows what the file would change.
    void open(const QString& path);
    /// Shows what the copy would change.
    void copy(const AxisCopy& copy);

signals:
    void machineChanged();
    /// Another machine was loaded from this file; empty: it has none.
    void taken(const QString& file);
    /// The present machine now has this file.
    void hasFile(const QString& file);
    /// The user has ticked it and pressed Apply.
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// The user has ticked a change of groups and pressed Apply.
    void groupChangeRequested(const nmc::bus::GroupChange& change);

private:
    /// A file that was read, or a copy, that awaits the user's choice.
    struct Pending {
        QString path;
        ParsedMachine content;
        bool restored = false;  ///< unsaved work, which is not in any file
        std::vector<ModuleIdentity> chain;
        std::optional<AxisCopy> copy{};   ///< then there is no file
        QString inFile{};                 ///< hash of the text in the file
        std::vector<Difference> shown{};  ///< the rows of the table
    };

    /// Empty if the file cannot be read, which the window then shows.
    [[nodiscard]] std::optional<Pending> read(const QString& path);
    /// Shows what the file would change; in operator mode, loads it whole.
    void openAtStart(const QString& path);
    /// Loads the machine with which operator mode was left, if it is known. Call while nothing is connected.
    void goOnInOperatorMode();
    /// Keeps the machine for goOnInOperatorMode() of the next session.
    void keepForOperator();
    /// The unsaved work of an earlier session, which there must be.
    [[nodiscard]] tl::expected<Pending, FileProblem> leftWork() const;
    void beginNew();
    /// `before`: hash of the only text of the file that may be replaced; empty: any.
    void save(const QString& path, const QString& before);
    /// `asked`: the machine at the time of the request; `text` and `written`: the content of the file on
    /// success.
    void saved(const QString& path, const Machine& asked, const std::string& text,
               const ParsedMachine& written, const FileWriter::Result& result);
    /// Shows the table of differences, or that there are none.
    void showPending();
    /// What applying the file or the copy would change now.
    [[nodiscard]] std::vector<Difference> differences() const;
    /// The user has changed axes, points or sequences: this implies that the present chain is the expected
    /// one, unless one is; then it does so for the modules concerned (forModules()).
    void changeAxes(Machine edited);
    void apply(const std::vector<PartId>& chosen);
    void take(const Pending& from, Machine machine, bool whole);
    void followLink();
    void keepUnsaved();
    void dropRestored();
    void changed();
    void showFile();
    void remember(const QString& path);
    /// True in operator mode, in which the machine must not be changed.
    [[nodiscard]] bool locked() const;
    [[nodiscard]] bool modified() const { return m_saved != m_machine; }
    /// Only modules that can be sent commands.
    [[nodiscard]] std::vector<ModuleState> modules() const;
    [[nodiscard]] std::vector<ModuleIdentity> chain() const;

    QSettings& m_settings;
    MainWindow& m_window;
    const BusStore& m_store;
    UnsavedWork m_unsaved;
    FileWriter m_files;
    Machine m_machine;
    std::optional<Machine> m_saved{Machine{}};  ///< as in the file; empty: not in any file
    UnknownKeys m_unknown;
    QString m_path;
    QString m_inFile;  ///< hash of the text read from the file or written to it last; empty: not known
    QString m_saving;  ///< the file being written; empty: none
    std::optional<Pending> m_pending;
    QTimer m_keepTimer;
    bool m_keepFailed = false;  ///< the message about it has been shown
    /// Holds all of an earlier session's work, which is removed once this session has stored it.
    bool m_restored = false;
};

}  // namespace nmc
