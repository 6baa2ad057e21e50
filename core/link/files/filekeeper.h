// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace nmc {

/// Small files that are kept up to date while nobody waits for the disk: written and removed in a thread of
/// its own, in the order that was asked for; of one file only what was asked for last. All members belong to
/// one thread, and only finish() waits.
class FileKeeper {
public:
    /// In the thread. All of it or nothing; its folder is there.
    using Write = std::function<void(const QString& path, const std::string& content)>;

    FileKeeper();
    /// To a disk that behaves otherwise.
    explicit FileKeeper(Write write);
    /// As finish(); what the disk has not taken by then is left behind.
    ~FileKeeper();
    FileKeeper(const FileKeeper&) = delete;
    FileKeeper& operator=(const FileKeeper&) = delete;

    /// All of it or nothing; its folder is made. A failure is nobody's news: what was there before stays.
    void write(const QString& path, std::string content);
    void remove(const QString& path);
    /// Until everything is on the disk. False: not within that time.
    bool finish(std::chrono::milliseconds patience = kPatience);

private:
    struct Queue;
    static constexpr std::chrono::milliseconds kPatience{3'000};

    std::shared_ptr<Queue> m_queue;  ///< shared with the thread
};

}  // namespace nmc
