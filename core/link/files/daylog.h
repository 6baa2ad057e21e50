// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "link/files/filewriter.h"

class QDateTime;

namespace nmc {

/// A log that outlives the session: one file per day, "messages-2026-11-22.log", of which the last 30 are
/// kept. A file that grows too large is started afresh, and its previous content is kept as ".old". Several
/// programs may write to the same file. All members belong to one thread, which never waits for the disk.
class DayLog : public QObject {
    Q_OBJECT

public:
    /// Called in another thread.
    using Append = FileWriter::Disk;
    static constexpr int kMaxFiles = 30;
    static constexpr qint64 kMostBytes = 4'000'000;

    /// `folder` need not exist. `append`: a disk with different behaviour, for tests.
    explicit DayLog(QString folder, Append append = appendToFile, QObject* parent = nullptr);

    [[nodiscard]] QString file(const QDateTime& now) const;
    /// Writes a line, given without its line end.
    void write(const std::string& line, const QDateTime& now);
    bool finish() { return m_files.finish(); }

    /// Creates the folder and makes room for the file.
    [[nodiscard]] static FileWriter::Result appendToFile(const QString& path, std::string_view lines);

signals:
    /// Lines were written to this file.
    void kept(const QString& path);
    /// Emitted once, until writing works again: the lines were lost.
    void failed(const nmc::FileError& error);

private:
    struct Waiting;

    QString m_folder;
    std::shared_ptr<Waiting> m_waiting;  ///< shared with the writer's thread
    bool m_failed = false;
    FileWriter m_files;
};

}  // namespace nmc
