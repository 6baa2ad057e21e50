// SPDX-License-Identifier: MIT
#include "link/ports/portuser.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <optional>

namespace nmc {

namespace {

struct LockFile {
    QString path;
    qint64 pid = 0;
};

QString firstLine(const QString& path) {
    QFile file(path);
    constexpr qint64 kEnough = 256;
    return file.open(QIODevice::ReadOnly) ? QString::fromLocal8Bit(file.readLine(kEnough)).trimmed()
                                          : QString();
}

/// A lock file is named after the name under which a program opened the port; all of them begin with the
/// process number.
std::optional<LockFile> lockFileOf(const QString& path, const PortUserPlaces& places) {
    for (QString name : {path, QFileInfo(path).canonicalFilePath()}) {
        if (name.startsWith(QLatin1String("/dev/")))
            name.remove(0, 5);
        name.replace(QLatin1Char('/'), QLatin1Char('_'));
        for (const QString& folder : places.lockFolders) {
            const QString file = folder + QStringLiteral("/LCK..") + name;
            if (!name.isEmpty() && QFileInfo::exists(file))
                return LockFile{file, firstLine(file).section(QLatin1Char(' '), 0, 0).toLongLong()};
        }
    }
    return std::nullopt;
}

bool lives(qint64 pid, const PortUserPlaces& places) {
    return pid > 0 && QFileInfo::exists(places.proc + QStringLiteral("/%1").arg(pid));
}

QString programOf(qint64 pid, const PortUserPlaces& places) {
    return firstLine(places.proc + QStringLiteral("/%1/comm").arg(pid));
}

/// True when the process has the terminal open and is not the one that serves it from the other end.
bool uses(const QString& process, dev_t device) {
    bool found = false;
    const QDir files(process + QStringLiteral("/fd"));
    for (const QString& name : files.entryList(QDir::Files | QDir::System | QDir::Hidden)) {
        // The link target is read before the link is followed: a file on a dead network drive would not
        // respond.
        const QString target = QFile::symLinkTarget(files.filePath(name));
        if (target == QLatin1String("/dev/ptmx") || target == QLatin1String("/dev/pts/ptmx"))
            return false;
        struct stat info {};
        found = found || (target.startsWith(QLatin1String("/dev/")) &&
                          ::stat(target.toLocal8Bit().constData(), &info) == 0 && S_ISCHR(info.st_mode) &&
                          info.st_rdev == device);
    }
    return found;
}

std::optional<qint64> processWith(const QString& path, const PortUserPlaces& places) {
    struct stat info {};
    if (::stat(path.toLocal8Bit().constData(), &info) != 0)
        return std::nullopt;
    for (const QString& name : QDir(places.proc).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const qint64 pid = name.toLongLong();
        if (pid > 0 && pid != ::getpid() && uses(places.proc + QLatin1Char('/') + name, info.st_rdev))
            return pid;
    }
    return std::nullopt;
}

bool someFolderIsWritable(const PortUserPlaces& places) {
    for (const QString& folder : places.lockFolders)
        if (QFileInfo info(folder); info.isDir() && info.isReadable() && info.isWritable())
            return true;
    return false;
}

QString ownerOf(const QString& file) {
    struct stat info {};
    if (::stat(file.toLocal8Bit().constData(), &info) != 0)
        return {};
    const passwd* entry = ::getpwuid(info.st_uid);
    return entry != nullptr ? QString::fromLocal8Bit(entry->pw_name) : QString::number(info.st_uid);
}

}  // namespace

QString devicePath(const QString& port) {
    return port.startsWith(QLatin1Char('/')) ? port : QStringLiteral("/dev/") + port;
}

PortError whyBusy(const QString& port, const PortUserPlaces& places) {
    PortError error;
    error.problem = PortProblem::InUse;
    error.port = port.toStdString();
    const QString path = devicePath(port);
    const auto lock = lockFileOf(path, places);
    if (lock && lives(lock->pid, places)) {
        error.pid = lock->pid == ::getpid() ? 0 : lock->pid;
    } else if (const auto pid = processWith(path, places)) {
        error.pid = *pid;
    } else if (lock) {
        error.problem = PortProblem::StaleLock;
        error.lockFile = lock->path.toStdString();
        error.user = ownerOf(lock->path).toStdString();
    } else if (!someFolderIsWritable(places)) {
        error.problem = PortProblem::NoLockFolder;
        error.lockFile = places.lockFolders.value(0).toStdString();
    }
    if (error.pid != 0)
        error.program = programOf(error.pid, places).toStdString();
    return error;
}

}  // namespace nmc
