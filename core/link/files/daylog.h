// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "link/files/filewriter.h"

class QDateTime;

namespace nmc {

/// A text that outlives the session: one file for each day, "messages-2026-11-22.log", the last 30 of them.
/// One that has grown too large is begun anew, and what was in it kept as ".old". Several programs may write
/// to the same one. All members belong to one thread, which waits for no disk.
class DayLog : public QObject {
    Q_OBJECT

public:
    /// Called in another thread.
    using Append = FileWriter::Disk;
    static constexpr int kMaxFiles = 30;
    static constexpr qint64 kMostBytes = 4'000'000;

    /// `folder` need not be there. `append`: for tests, a disk that behaves otherwise.
    explicit DayLog(QString folder, Append append = appendToFile, QObject* parent = nullptr);

    [[nodiscard]] QString file(const QDateTime& now) const;
    /// A line, without its end.
    void write(const std::string& line, const QDateTime& now);
    bool finish() { return m_files.finish(); }

    /// Makes the folder, and the room.
    [[nodiscard]] static FileWriter::Result appendToFile(const QString& path, std::string_view lines);

signals:
    /// Once, until it works again: what was written is lost.
    void failed(const nmc::FileError& error);

private:
    struct Waiting;

    QString m_folder;
    std::shared_ptr<Waiting> m_waiting;  ///< shared with the writer's thread
    bool m_failed = false;
    FileWriter m_files;
};

}  // namespace nmc
