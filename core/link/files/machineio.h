// SPDX-License-Identifier: MIT
#pragma once

#include <QFile>
#include <QString>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace nmc {

/// Why a file could not be read or written.
enum class FileErrorKind : std::uint8_t {
    NotThere,
    NoFolder,  ///< the folder of the file does not exist
    NotAFile,  ///< a folder or a device
    NoPermission,
    ReadOnly,  ///< the disk is read-only for everybody
    NoSpace,
    TooLarge,
    ChangedElsewhere,  ///< the file does not hold any more what was read from it, or written last
    Other,             ///< detail holds the system's message
};

struct FileError {
    FileErrorKind trouble = FileErrorKind::Other;
    QString path;
    QString detail{};
};

/// Opens a plain file for reading; anything else might never end, or block when opened. Any thread.
[[nodiscard]] tl::expected<std::unique_ptr<QFile>, FileError> openToRead(const QString& path);

/// Reads the whole file, if it has at most `limit` bytes. Blocks as long as the disk does; any thread.
[[nodiscard]] tl::expected<std::string, FileError> readFile(const QString& path, std::size_t limit);

/// Writes all of the content or nothing: if this fails, an existing file stays unchanged. Blocks as long as
/// the disk does; any thread.
[[nodiscard]] tl::expected<void, FileError> writeFile(const QString& path, std::string_view content);

}  // namespace nmc
