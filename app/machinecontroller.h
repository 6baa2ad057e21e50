// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSettings>
#include <QTimer>
#include <optional>

#include "link/connection/busstore.h"
#include "link/files/unsavedwork.h"
#include "model/intent/intent.h"
#include "model/machinefile/machinefile.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// The machine that the user has told the panel about, and its file. Opening a file shows what it would
/// change; only what the user then chooses is taken, and sent. Unsaved work is kept every few seconds, and
/// offered again at the next start. Nothing that is written holds up the panel. GUI thread.
class MachineController : public QObject {
    Q_OBJECT

public:
    /// `unsavedFolder`: where unsaved work is kept; empty: beside the settings.
    MachineController(QSettings& settings, MainWindow& window, const BusStore& store,
                      const QString& unsavedFolder, const FileWriter::Disk& disk = writeFile,
                      QObject* parent = nullptr);
    ~MachineController() override;

    [[nodiscard]] const Machine& machine() const { return m_machine; }

    /// Shows the machine, and offers what an earlier session has left.
    void start();
    /// The user has changed an axis in its panel.
    void edit(ModuleIndex module, const AxisSettings& settings);
    void editProgram(const Program& program);
    void editHomeOrder(const std::vector<ModuleIndex>& order);
    /// Something was sent that belongs to the machine: it cannot be read back, so it is remembered.
    void noteSent(ModuleIndex module, const Intent& intent);
    /// The user has put a module into another group, or out of all.
    void noteGroup(const bus::GroupChange& change);
    void nameGroup(quint8 group, const QString& name);
    void setOperatorRights(const OperatorRights& rights);
    /// These modules are the expected ones from now on.
    void acceptChain(const std::vector<ModuleIdentity>& there);
    /// What an earlier session has left.
    void restoreWork();
    void discardWork() { m_unsaved.dropLeft(); }

    void open(const QString& path);

signals:
    void machineChanged();
    /// Another machine is here, of this file; empty: it has none.
    void taken(const QString& file);
    /// The machine that is here has this file from now on.
    void hasFile(const QString& file);
    /// The user has ticked it and pressed Apply.
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// The same, of the groups.
    void groupChangeRequested(const nmc::bus::GroupChange& change);

private:
    /// A file that was read, and waits for the user's choice.
    struct Pending {
        QString path;
        ParsedMachine content;
        bool restored = false;  ///< unsaved work, which no file has
        std::vector<ModuleIdentity> chain;
    };

    void wire();
    void beginNew();
    void save(const QString& path);
    /// `asked`: the machine when that was asked for; `written`: what the file holds if it worked.
    void saved(const QString& path, const Machine& asked, const ParsedMachine& written,
               const FileWriter::Result& result);
    void showPending();
    void apply(const std::vector<PartId>& chosen);
    void take(const Pending& from, Machine machine, bool whole);
    void followLink();
    void keepUnsaved();
    void dropRestored();
    void changed();
    void showFile();
    void remember(const QString& path);
    /// It stays as it is: operator mode.
    [[nodiscard]] bool locked() const;
    [[nodiscard]] bool modified() const { return m_saved != m_machine; }
    /// Only those that can be spoken to.
    [[nodiscard]] std::vector<ModuleState> modules() const;
    [[nodiscard]] std::vector<ModuleIdentity> chain() const;

    QSettings& m_settings;
    MainWindow& m_window;
    const BusStore& m_store;
    UnsavedWork m_unsaved;
    FileWriter m_files;
    Machine m_machine;
    std::optional<Machine> m_saved{Machine{}};  ///< as the file has it; empty: no file has it
    UnknownKeys m_unknown;
    QString m_path;
    QString m_saving;  ///< to that file; empty: nothing is being saved
    std::optional<Pending> m_pending;
    QTimer m_keepTimer;
    bool m_keepFailed = false;  ///< and was told
    bool m_restored = false;    ///< what an earlier session has left, which goes when this one has kept it
};

}  // namespace nmc
