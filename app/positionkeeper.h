// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>

#include "link/connection/busstore.h"
#include "link/files/backgroundjob.h"
#include "link/files/filewriter.h"
#include "model/machinefile/positionfile.h"

namespace nmc {

/// Stores the positions of the axes at a port on disk, and offers them to modules that have lost theirs,
/// unless the machine is known to be a different one. Never waits for a disk. GUI thread.
class PositionKeeper : public QObject {
    Q_OBJECT

public:
    /// `folder` need not exist.
    PositionKeeper(QString folder, BusStore& store, FileWriter::Disk disk = writeFile);
    /// Stores the final rest position: a program that stops its motors and ends does so within a moment.
    ~PositionKeeper() override { keep(); }

    /// A port is being opened. `owns`: this session is responsible for its axes; otherwise their positions
    /// are not stored.
    void begin(const QString& port, bool owns);
    /// The name of the panel's machine; empty: none. Offers from another machine are withdrawn.
    void setMachine(const std::string& name);
    /// These modules are out of the chain at the port that was open last, so that those after them have other
    /// numbers from now on.
    void leaveOut(const std::vector<ModuleIndex>& modules);
    /// Call for every event.
    void take(const StoreEvent& event);

signals:
    /// The module's home is now offered.
    void offered(const nmc::PositionMemory::Offer& offer);
    /// The user has accepted or declined the offer, or it no longer holds.
    void over(nmc::ModuleIndex module);
    /// Emitted once, until writing works again: the positions are not on disk.
    void failed(const nmc::FileError& error);

private:
    void load();
    void found(const bus::ChainFound& found);
    void look();
    void loaded();
    void begin();
    void keep();
    void written(const FileWriter::Result& result);
    [[nodiscard]] RememberedChain toKeep() const;
    [[nodiscard]] bool isOfAnother() const;

    QString m_folder;
    BusStore& m_store;
    FileWriter m_files;
    QString m_file;  ///< of this connection; empty: nothing is stored
    PositionMemory m_memory;
    RememberedChain m_kept;  ///< as in the file, unless m_failed
    std::string m_machine;
    std::vector<ModuleIndex> m_offered;
    QTimer m_keepTimer;
    std::shared_ptr<std::string> m_read;  ///< shared with the job
    bool m_loaded = false;
    bool m_failed = false;  ///< the last write; it is tried again, and the failure has been reported
    bool m_looking = false;
    std::optional<bus::ChainFound> m_found;  ///< reported before the file was loaded
    BackgroundJob m_loading;
};

}  // namespace nmc
