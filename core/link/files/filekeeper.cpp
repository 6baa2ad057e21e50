// SPDX-License-Identifier: MIT
#include "link/files/filekeeper.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <thread>

#include "link/files/machineio.h"

namespace nmc {

struct FileKeeper::Queue {
    struct File {
        QString path;
        std::optional<std::string> content;  ///< empty: it goes
    };

    explicit Queue(Write toDisk) : writeFile(std::move(toDisk)) {}

    const Write writeFile;
    std::mutex mutex;
    std::condition_variable changed;
    // Under the mutex:
    std::list<File> waiting;
    bool busy = false;
    bool ends = false;

    void put(File file) {
        const std::scoped_lock lock(mutex);
        waiting.remove_if([&file](const File& older) { return older.path == file.path; });
        waiting.push_back(std::move(file));
        changed.notify_all();
    }

    void run() {
        std::unique_lock lock(mutex);
        while (true) {
            changed.wait(lock, [this] { return !waiting.empty() || ends; });
            if (waiting.empty())
                return;
            const File file = std::move(waiting.front());
            waiting.pop_front();
            busy = true;
            lock.unlock();
            carryOut(file);
            lock.lock();
            busy = false;
            changed.notify_all();
        }
    }

    void carryOut(const File& file) const {
        if (!file.content) {
            QFile::remove(file.path);
            return;
        }
        QDir().mkpath(QFileInfo(file.path).path());
        writeFile(file.path, *file.content);
    }
};

FileKeeper::FileKeeper()
    : FileKeeper([](const QString& path, const std::string& content) { (void)writeFile(path, content); }) {}

FileKeeper::FileKeeper(Write write) : m_queue(std::make_shared<Queue>(std::move(write))) {
    // Not joined: a disk that does not answer holds up no program that wants to end.
    std::thread([queue = m_queue] { queue->run(); }).detach();
}

FileKeeper::~FileKeeper() {
    finish();
    const std::scoped_lock lock(m_queue->mutex);
    m_queue->ends = true;
    m_queue->changed.notify_all();
}

void FileKeeper::write(const QString& path, std::string content) {
    m_queue->put({path, std::move(content)});
}

void FileKeeper::remove(const QString& path) {
    m_queue->put({path, std::nullopt});
}

bool FileKeeper::finish(std::chrono::milliseconds patience) {
    std::unique_lock lock(m_queue->mutex);
    return m_queue->changed.wait_for(lock, patience,
                                     [this] { return m_queue->waiting.empty() && !m_queue->busy; });
}

}  // namespace nmc
