// SPDX-License-Identifier: MIT
#include "link/files/machineio.h"

#include <QFileInfo>
#include <QSaveFile>
#include <cerrno>

namespace nmc {

namespace {

/// Builds the error from what the system and Qt report about an operation that has just failed.
FileError errorOf(const QFileDevice& file, const QString& path, int number) {
    FileError error{FileErrorKind::Other, path, file.errorString()};
    if (number == ENOENT)
        error.trouble = FileErrorKind::NotThere;
    else if (number == EROFS)
        error.trouble = FileErrorKind::ReadOnly;
    else if (number == ENOSPC || number == EDQUOT || file.error() == QFileDevice::ResourceError)
        error.trouble = FileErrorKind::NoSpace;
    else if (number == EACCES || number == EPERM || file.error() == QFileDevice::PermissionsError)
        error.trouble = FileErrorKind::NoPermission;
    return error;
}

}  // namespace

tl::expected<std::unique_ptr<QFile>, FileError> openToRead(const QString& path) {
    const QFileInfo info(path);
    if (info.exists() && !info.isFile())
        return tl::unexpected(FileError{FileErrorKind::NotAFile, path});
    auto file = std::make_unique<QFile>(path);
    errno = 0;
    if (!file->open(QIODevice::ReadOnly))
        return tl::unexpected(errorOf(*file, path, errno));
    return file;
}

tl::expected<std::string, FileError> readFile(const QString& path, std::size_t limit) {
    const auto file = openToRead(path);
    if (!file)
        return tl::unexpected(file.error());
    errno = 0;
    const QByteArray bytes = (*file)->read(static_cast<qint64>(limit) + 1);
    if ((*file)->error() != QFileDevice::NoError)
        return tl::unexpected(errorOf(**file, path, errno));
    if (static_cast<std::size_t>(bytes.size()) > limit)
        return tl::unexpected(FileError{FileErrorKind::TooLarge, path});
    return bytes.toStdString();
}

tl::expected<void, FileError> writeFile(const QString& path, std::string_view content) {
    const QFileInfo info(path);
    if (info.exists() && !info.isFile())
        return tl::unexpected(FileError{FileErrorKind::NotAFile, path});
    if (!QFileInfo(info.absolutePath()).isDir())
        return tl::unexpected(FileError{FileErrorKind::NoFolder, path});
    if (info.exists() && !info.isWritable())
        return tl::unexpected(FileError{FileErrorKind::NoPermission, path});
    QSaveFile file(path);
    errno = 0;
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(errorOf(file, path, errno));
    errno = 0;
    file.write(content.data(), static_cast<qint64>(content.size()));
    if (!file.commit())
        return tl::unexpected(errorOf(file, path, errno));
    return {};
}

}  // namespace nmc
