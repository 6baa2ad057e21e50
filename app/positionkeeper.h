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
#include "model/module/positionmemory.h"

namespace nmc {

/// Keeps on disk where the axes at a port are, and offers it to modules that have forgotten it, unless the
/// machine is known to be another one by now. Waits for no disk. GUI thread.
class PositionKeeper : public QObject {
    Q_OBJECT

public:
    /// `folder` need not be there.
    PositionKeeper(QString folder, BusStore& store, FileWriter::Disk disk = writeFile,
                   QObject* parent = nullptr);
    /// Keeps what came to rest last: a program that stops its motors and ends does so within a moment.
    ~PositionKeeper() override { keep(); }

    /// A port is being opened. `owns`: its axes are this session's business; else nothing is kept.
    void begin(const QString& port, bool owns);
    /// The name of the machine that the panel has; empty: none. What was remembered of another is withdrawn.
    void setMachine(const std::string& name);
    void found(const bus::ChainFound& found);
    void restarted(ModuleIndex module) { m_memory.restarted(module); }
    /// With every news of the link.
    void look();

signals:
    /// The module's home is offered by now.
    void offered(const nmc::PositionMemory::Offer& offer);
    /// The user has taken it or not, or it does not hold any more.
    void over(nmc::ModuleIndex module);

private:
    void loaded();
    void begin();
    void keep();
    [[nodiscard]] RememberedChain toKeep() const;
    [[nodiscard]] bool isOfAnother() const;

    QString m_folder;
    BusStore& m_store;
    FileWriter m_files;
    QString m_file;  ///< of this connection; empty: it keeps nothing
    PositionMemory m_memory;
    RememberedChain m_kept;  ///< as the file has it
    std::string m_machine;
    std::vector<ModuleIndex> m_offered;
    QTimer m_keepTimer;
    std::shared_ptr<std::string> m_read;  ///< shared with the job
    bool m_loaded = false;
    bool m_looking = false;
    std::optional<bus::ChainFound> m_found;  ///< before it was loaded
    BackgroundJob m_loading;
};

}  // namespace nmc
