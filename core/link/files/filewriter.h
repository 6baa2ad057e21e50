// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "link/files/machineio.h"

namespace nmc {

/// Writes and removes files while nobody waits for the disk. Of one file, things are done in the order that
/// was asked for, and of what waits only the last; no file waits for another, which may be on a disk that
/// does not answer. All members belong to one thread, and only finish() waits.
class FileWriter : public QObject {
    Q_OBJECT

public:
    using Result = tl::expected<void, FileError>;
    /// Called in another thread, as is the disk.
    using Content = std::function<std::string()>;
    /// All of it or nothing.
    using Disk = std::function<Result(const QString& path, std::string_view content)>;
    /// Never from within a call, nor of what gave way to something later.
    using Told = std::function<void(const Result& result)>;

    /// `disk`: for tests, one that behaves otherwise.
    explicit FileWriter(Disk disk = writeFile);
    /// As finish(); what the disk has not taken by then is left behind. Nobody is told any more.
    ~FileWriter() override;

    void write(const QString& path, Content content, Told told = {});
    void remove(const QString& path);
    /// Until everything is on the disk. False: not within that time.
    bool finish(std::chrono::milliseconds patience = kPatience);

private:
    struct Files;
    static constexpr std::chrono::milliseconds kPatience{3'000};

    std::shared_ptr<Files> m_files;  ///< shared with the threads
};

}  // namespace nmc
