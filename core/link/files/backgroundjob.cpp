// SPDX-License-Identifier: MIT
#include "link/files/backgroundjob.h"

#include <cassert>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace nmc {

struct BackgroundJob::Run {
    Work work;
    Cancelled cancelled = false;
    std::mutex mutex;
    std::condition_variable changed;
    // Under the mutex:
    BackgroundJob* owner;
    bool over = false;

    Run(Work todo, BackgroundJob& wanted) : work(std::move(todo)), owner(&wanted) {}

    void run() {
        work(cancelled);
        work = nullptr;  // with what it shares
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
    bool waitForEnd(std::chrono::milliseconds patience) {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, patience, [this] { return over; });
    }
};

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}

BackgroundJob::~BackgroundJob() {
    if (!m_run)
        return;
    m_run->forgetOwner();
    if (m_run->waitForEnd(kPatience))
        m_thread.join();
    else
        m_thread.detach();
}

void BackgroundJob::start(Work work) {
    assert(!isBusy());
    m_run = std::make_shared<Run>(std::move(work), *this);
    m_thread = std::thread([run = m_run] { run->run(); });
}

void BackgroundJob::cancel() {
    if (!m_run)
        return;
    m_run->forgetOwner();
    m_run.reset();
    m_thread.detach();
}

void BackgroundJob::take() {
    // One that was cancelled may have announced its end before.
    if (!m_run || !m_run->isOver())
        return;
    m_thread.join();
    m_run.reset();
    emit ended();
}

}  // namespace nmc
