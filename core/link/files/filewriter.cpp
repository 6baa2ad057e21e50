// SPDX-License-Identifier: MIT
#include "link/files/filewriter.h"

#include <QFile>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "link/files/inbackground.h"

namespace nmc {

struct FileWriter::Files : std::enable_shared_from_this<Files> {
    struct Wanted {
        Content content;  ///< empty: the file is removed
        Done done;
    };

    Files(Disk toDisk, QObject& writer) : disk(std::move(toDisk)), owner(&writer) {}

    const Disk disk;
    std::mutex mutex;
    std::condition_variable changed;
    // Guarded by the mutex:
    QObject* owner;
    std::map<QString, std::optional<Wanted>> next;  ///< files that a thread is working on, with the next
                                                    ///< request for each

    void put(const QString& path, Wanted wanted) {
        std::unique_lock lock(mutex);
        const auto [file, idle] = next.try_emplace(path);
        file->second = std::move(wanted);
        lock.unlock();
        if (idle)
            inBackground([files = shared_from_this(), path] { files->carryOut(path); });
    }

    void carryOut(const QString& path) {
        std::unique_lock lock(mutex);
        while (std::optional<Wanted> wanted = std::exchange(next[path], std::nullopt)) {
            lock.unlock();
            Result result;
            if (!wanted->content)
                QFile::remove(path);
            else if (const auto content = wanted->content())
                result = disk(path, *content);
            else
                result = tl::unexpected(content.error());
            lock.lock();
            if (owner != nullptr && wanted->done)
                QMetaObject::invokeMethod(
                    owner, [done = std::move(wanted->done), result] { done(result); }, Qt::QueuedConnection);
        }
        next.erase(path);
        changed.notify_all();
    }
};

FileWriter::FileWriter(Disk disk) : m_files(std::make_shared<Files>(std::move(disk), *this)) {}

FileWriter::~FileWriter() {
    finish();
    const std::scoped_lock lock(m_files->mutex);
    m_files->owner = nullptr;
}

void FileWriter::write(const QString& path, Content content, Done done) {
    m_files->put(path, {std::move(content), std::move(done)});
}

void FileWriter::remove(const QString& path) {
    m_files->put(path, {});
}

bool FileWriter::isBusy(const QString& path) const {
    const std::scoped_lock lock(m_files->mutex);
    return m_files->next.contains(path);
}

bool FileWriter::finish(std::chrono::milliseconds patience) {
    std::unique_lock lock(m_files->mutex);
    return m_files->changed.wait_for(lock, patience, [this] { return m_files->next.empty(); });
}

}  // namespace nmc
