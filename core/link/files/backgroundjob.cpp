// SPDX-License-Identifier: MIT
#include "link/files/backgroundjob.h"

#include <cassert>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "link/files/inbackground.h"

namespace nmc {

struct BackgroundJob::Shared {
    Work work;
    Cancelled cancelled = false;
    std::mutex mutex;
    std::condition_variable changed;
    // Guarded by the mutex:
    BackgroundJob* owner;
    bool over = false;

    Shared(Work todo, BackgroundJob& wanted) : work(std::move(todo)), owner(&wanted) {}

    void run() {
        work(cancelled);
        work = nullptr;  // releases what it shares
        const std::scoped_lock lock(mutex);
        over = true;
        changed.notify_all();
        if (owner != nullptr)
            QMetaObject::invokeMethod(owner, &BackgroundJob::take, Qt::QueuedConnection);
    }
    void forgetOwner() {
        cancelled = true;
        const std::scoped_lock lock(mutex);
        owner = nullptr;
    }
    [[nodiscard]] bool isOver() {
        const std::scoped_lock lock(mutex);
        return over;
    }
    void waitForEnd(std::chrono::milliseconds patience) {
        std::unique_lock lock(mutex);
        changed.wait_for(lock, patience, [this] { return over; });
    }
};

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}

BackgroundJob::~BackgroundJob() {
    if (!m_shared)
        return;
    m_shared->forgetOwner();
    m_shared->waitForEnd(kPatience);
}

void BackgroundJob::start(Work work) {
    assert(!isBusy());
    m_shared = std::make_shared<Shared>(std::move(work), *this);
    inBackground([run = m_shared] { run->run(); });
}

void BackgroundJob::cancel() {
    if (!m_shared)
        return;
    m_shared->forgetOwner();
    m_shared.reset();
}

void BackgroundJob::take() {
    // A cancelled job may have announced its end before.
    if (!m_shared || !m_shared->isOver())
        return;
    m_shared.reset();
    emit ended();
}

}  // namespace nmc
