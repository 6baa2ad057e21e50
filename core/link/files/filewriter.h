// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "link/files/machineio.h"

namespace nmc {

/// Writes and removes files without making the caller wait for the disk. The operations on one file are
/// carried out in order, and of those waiting only the last; no file waits for another, which may be on a
/// disk that does not respond. All members belong to one thread, and only finish() waits.
class FileWriter : public QObject {
    Q_OBJECT

public:
    using Result = tl::expected<void, FileError>;
    /// What to write, or why nothing is written. Called in another thread, like Disk.
    using Content = std::function<tl::expected<std::string, FileError>()>;
    /// Writes all of the content or nothing.
    using Disk = std::function<Result(const QString& path, std::string_view content)>;
    /// Never called from within a call, nor for a request that was replaced by a later one.
    using Done = std::function<void(const Result& result)>;

    /// `disk`: a disk with different behaviour, for tests.
    explicit FileWriter(Disk disk = writeFile);
    /// Waits like finish(); what has not been written by then is left behind. No callbacks follow.
    ~FileWriter() override;

    void write(const QString& path, Content content, Done done = {});
    void remove(const QString& path);
    /// True while something is to be done to the file; for a request with `done`, until just before that.
    [[nodiscard]] bool isBusy(const QString& path) const;
    /// Waits until everything has been written. Returns false when the time is up before.
    bool finish(std::chrono::milliseconds patience = kPatience);

private:
    struct Files;
    static constexpr std::chrono::milliseconds kPatience{3'000};

    std::shared_ptr<Files> m_files;  ///< shared with the threads
};

}  // namespace nmc
