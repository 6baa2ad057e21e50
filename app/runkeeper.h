// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "link/files/backgroundjob.h"
#include "link/files/filewriter.h"
#include "model/machinefile/responsestore.h"
#include "model/settings/machine.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Stores the step responses of a machine in a file beside its own, "mill.runs" beside "mill.json", or in the
/// data folder while it has no file, and shows them again when the machine is opened. A file that cannot be
/// read is never overwritten, but set aside. Never waits for a disk. GUI thread.
class RunKeeper : public QObject {
    Q_OBJECT

public:
    /// `folder` need not exist.
    RunKeeper(QString folder, MainWindow& window, FileWriter::Disk disk = writeFile);

    /// Another machine was loaded; `file`: the machine's file; empty: it has none.
    void open(const QString& file, const Machine& machine);
    /// The present machine now has this file, and its runs move along.
    void follow(const QString& file);
    /// These modules are out of the chain, so that those after them have other numbers from now on. Their
    /// runs stay in the file.
    void leaveOut(const std::vector<ModuleIndex>& modules);

private:
    struct Reading {
        QString path;
        Machine machine;
        std::vector<KeptResponse> runs;
        std::optional<FileError> error;
        std::optional<FileProblem> problem;
        std::vector<std::vector<ModuleIndex>> leftOut{};  ///< in the meantime, one after the other
    };

    [[nodiscard]] QString pathFor(const QString& machineFile) const;
    void load();
    void loaded();
    void moveFrom(const QString& before);
    void keep();
    void onWritten(const FileWriter::Result& result);

    QString m_folder;
    MainWindow& m_window;
    FileWriter m_files;
    QString m_path;
    std::set<std::string> m_known;       ///< all runs listed since the machine was loaded
    bool m_failed = false;               ///< the message about it has been shown
    std::shared_ptr<Reading> m_reading;  ///< shared with the job; null: what is in the file is listed
    BackgroundJob m_loading;
};

}  // namespace nmc
