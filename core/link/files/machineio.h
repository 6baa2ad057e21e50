// SPDX-License-Identifier: MIT
#pragma once

#include <QFile>
#include <QString>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace nmc {

/// Why a file was not read or written.
enum class FileErrorKind : std::uint8_t {
    NotThere,
    NoFolder,  ///< the folder it should be in is not there
    NotAFile,  ///< a folder, a device
    NoPermission,
    ReadOnly,  ///< the disk, for everybody
    NoSpace,
    TooLarge,
    Other,  ///< detail holds the system's own words
};

struct FileError {
    FileErrorKind trouble = FileErrorKind::Other;
    QString path;
    QString detail{};
};

/// A plain file, open for reading: what is none may never end, or never begin. Any thread.
[[nodiscard]] tl::expected<std::unique_ptr<QFile>, FileError> openToRead(const QString& path);

/// The whole file, if it has not more than `limit` bytes. Blocks as long as the disk does; any
/// thread.
[[nodiscard]] tl::expected<std::string, FileError> readFile(const QString& path, std::size_t limit);

/// All of it or nothing: a file that was there before is as it was when this fails. Blocks, too; any
/// thread.
[[nodiscard]] tl::expected<void, FileError> writeFile(const QString& path, std::string_view content);

}  // namespace nmc
