// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>

namespace nmc {

/// Work that a disk may hold up for as long as it likes, in the background, one piece at a time. All members
/// belong to the GUI thread.
class BackgroundJob : public QObject {
    Q_OBJECT

public:
    using Cancelled = std::atomic<bool>;
    /// Runs in another thread: what it shares with the owner must belong to both, because it is left behind
    /// when it does not end soon after the owner has.
    using Work = std::function<void(const Cancelled& cancelled)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    /// Not while isBusy(). ended() follows, unless it is cancelled.
    void start(Work work);
    /// Nobody wants to know any more. It may go on for as long as it takes to notice.
    void cancel();
    [[nodiscard]] bool isBusy() const { return m_shared != nullptr; }

signals:
    /// Never from within a call.
    void ended();

private:
    struct Shared;
    static constexpr std::chrono::milliseconds kPatience{3'000};

    void take();

    std::shared_ptr<Shared> m_shared;  ///< shared with the thread
};

}  // namespace nmc
