// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>

namespace nmc {

/// Runs work that a disk may delay indefinitely in the background, one job at a time. All members belong to
/// the GUI thread.
class BackgroundJob : public QObject {
    Q_OBJECT

public:
    using Cancelled = std::atomic<bool>;
    /// Runs in another thread. Shared data must belong to both the thread and the owner, because a job that
    /// does not end soon after its owner is left running.
    using Work = std::function<void(const Cancelled& cancelled)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    /// Must not be called while isBusy(). ended() follows, unless the job is cancelled.
    void start(Work work);
    /// The result is no longer wanted. The job may keep running until it notices.
    void cancel();
    [[nodiscard]] bool isBusy() const { return m_shared != nullptr; }

signals:
    /// Never emitted from within a call.
    void ended();

private:
    struct Shared;
    static constexpr std::chrono::milliseconds kPatience{3'000};

    void take();

    std::shared_ptr<Shared> m_shared;  ///< shared with the thread
};

}  // namespace nmc
