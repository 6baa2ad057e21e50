// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFileInfo>
#include <utility>

#include "link/files/filewriter.h"

namespace nmc {

/// Creates the folder of a file if it is missing, and then writes with `disk`.
[[nodiscard]] inline FileWriter::Disk makingFolders(FileWriter::Disk disk) {
    return [disk = std::move(disk)](const QString& path, std::string_view content) {
        QDir().mkpath(QFileInfo(path).path());
        return disk(path, content);
    };
}

}  // namespace nmc
