// SPDX-License-Identifier: MIT
#include "link/files/daylog.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <map>
#include <mutex>
#include <utility>

namespace nmc {

namespace {

/// Removes the oldest files, so that there is room for one more. Their names sort by date.
void makeRoom(const QDir& folder) {
    QStringList files = folder.entryList({QStringLiteral("messages-*-*-*.log")}, QDir::Files, QDir::Name);
    while (files.size() >= DayLog::kMaxFiles) {
        const QString oldest = folder.filePath(files.takeFirst());
        QFile::remove(oldest);
        QFile::remove(oldest + QStringLiteral(".old"));
    }
}

}  // namespace

struct DayLog::Waiting {
    std::mutex mutex;
    std::map<QString, std::string> lines;  ///< by file; guarded by the mutex

    /// The next thread to reach the disk takes all lines.
    std::string take(const QString& path) {
        const std::scoped_lock lock(mutex);
        return std::exchange(lines[path], {});
    }
};

DayLog::DayLog(QString folder, Append append, QObject* parent)
    : QObject(parent),
      m_folder(std::move(folder)),
      m_waiting(std::make_shared<Waiting>()),
      m_files(std::move(append)) {}

QString DayLog::file(const QDateTime& now) const {
    return QDir(m_folder).filePath(QStringLiteral("messages-%1.log").arg(now.date().toString(Qt::ISODate)));
}

void DayLog::write(const std::string& line, const QDateTime& now) {
    const QString path = file(now);
    {
        const std::scoped_lock lock(m_waiting->mutex);
        m_waiting->lines[path] += line + '\n';
    }
    m_files.write(
        path, [waiting = m_waiting, path] { return waiting->take(path); },
        [this, path](const FileWriter::Result& result) {
            const bool before = std::exchange(m_failed, !result);
            if (result)
                emit kept(path);
            else if (!before)
                emit failed(result.error());
        });
}

FileWriter::Result DayLog::appendToFile(const QString& path, std::string_view lines) {
    const QFileInfo info(path);
    const QDir folder = info.dir();
    folder.mkpath(QStringLiteral("."));
    if (info.size() + static_cast<qint64>(lines.size()) > kMostBytes) {
        QFile::remove(path + QStringLiteral(".old"));
        QFile::rename(path, path + QStringLiteral(".old"));
    }
    // Before it is there: with a clock that was set back, it would be the oldest.
    if (!QFileInfo::exists(path))
        makeRoom(folder);
    QFile file(path);
    const auto bytes = static_cast<qint64>(lines.size());
    if (!file.open(QIODevice::WriteOnly | QIODevice::Append) || file.write(lines.data(), bytes) != bytes ||
        !file.flush())
        return tl::unexpected(FileError{FileErrorKind::Other, path, file.errorString()});
    return {};
}

}  // namespace nmc
