// SPDX-License-Identifier: MIT
#include "link/files/recordingwriter.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <cassert>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "link/clock.h"
#include "link/files/inbackground.h"
#include "link/guardian/descriptor.h"

namespace nmc {

struct DiskProblem {
    RecordingProblemKind what = RecordingProblemKind::Other;
    int number = 0;  ///< errno
};

namespace {

DiskProblem problemOf(int number) {
    switch (number) {
        case ENOENT:
        case ENOTDIR:
            return {RecordingProblemKind::NoFolder, number};
        case EISDIR:
        case ENXIO:  // a FIFO without a reader
            return {RecordingProblemKind::NotAFile, number};
        case EACCES:
        case EPERM:
            return {RecordingProblemKind::NoPermission, number};
        case EROFS:
            return {RecordingProblemKind::ReadOnly, number};
        case ENOSPC:
        case EDQUOT:
            return {RecordingProblemKind::NoSpace, number};
        case EFBIG:
            return {RecordingProblemKind::FileTooLarge, number};
    }
    return {RecordingProblemKind::Other, number};
}

/// Blocks SIGPIPE and SIGXFSZ, which terminate the program by default; the error code is enough.
class WriteSignalsBlocked {
public:
    WriteSignalsBlocked() {
        sigemptyset(&m_signals);
        sigaddset(&m_signals, SIGPIPE);
        sigaddset(&m_signals, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
    }
    ~WriteSignalsBlocked() {
        const timespec now{};
        while (sigtimedwait(&m_signals, nullptr, &now) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }
    WriteSignalsBlocked(const WriteSignalsBlocked&) = delete;
    WriteSignalsBlocked& operator=(const WriteSignalsBlocked&) = delete;

private:
    sigset_t m_signals{};
    sigset_t m_before{};
};

/// Flushes all data to the disk.
std::optional<DiskProblem> flushFile(int fd) {
    // EINVAL means that this is not a plain file, which has nothing to flush.
    if (fdatasync(fd) != 0 && errno != EINVAL)
        return problemOf(errno);
    struct stat status {};
    if (fstat(fd, &status) == 0 && status.st_nlink == 0)
        return DiskProblem{RecordingProblemKind::Removed};
    return std::nullopt;
}

}  // namespace

/// One recording: the data shared by the GUI thread and the background. At most one background thread works
/// on it at a time, and none while nothing is waiting.
class RecordingWriter::Job : public std::enable_shared_from_this<Job> {
public:
    Job(std::string path, std::size_t limit, RecordingWriter& owner)
        : m_path(std::move(path)), m_limit(limit), m_owner(&owner) {}

    // ---- GUI thread ----

    /// Opens the file.
    void begin() { workOn(std::unique_lock(m_mutex)); }
    /// Returns false when too much is already waiting for the disk.
    bool push(std::string text) {
        std::unique_lock lock(m_mutex);
        if (m_ended)
            return true;  // the owner is about to be informed of the reason
        if (m_waiting + text.size() > m_limit)
            return false;
        m_waiting += text.size();
        m_queue.push_back(std::move(text));
        workOn(std::move(lock));
        return true;
    }
    void flush() {
        std::unique_lock lock(m_mutex);
        m_flushing = true;
        workOn(std::move(lock));
    }
    void stop() {
        std::unique_lock lock(m_mutex);
        m_stopping = true;
        workOn(std::move(lock));
    }
    bool waitForEnd(std::chrono::milliseconds patience) {
        std::unique_lock lock(m_mutex);
        return m_atAnEnd.wait_for(lock, patience, [this] { return m_ended; });
    }
    /// The rest is no longer waited for. The job ends as soon as the disk allows it.
    void abandon() {
        std::unique_lock lock(m_mutex);
        m_abandoned = true;
        m_owner = nullptr;
        workOn(std::move(lock));
    }
    [[nodiscard]] bool ended() const { return guarded(m_ended); }
    [[nodiscard]] std::optional<DiskProblem> problem() const { return guarded(m_problem); }
    [[nodiscard]] qint64 written() const { return guarded(m_written); }

private:
    /// A copy of a member that the mutex guards.
    template <typename T>
    [[nodiscard]] T guarded(const T& member) const {
        const std::scoped_lock lock(m_mutex);
        return member;
    }
    void workOn(std::unique_lock<std::mutex> lock) {
        if (m_ended || std::exchange(m_busy, true))
            return;
        lock.unlock();
        inBackground([job = shared_from_this()] { job->work(); });
    }

    // ---- background ----

    /// Works until nothing is waiting, or the recording ends.
    void work();
    std::optional<DiskProblem> carryOut(const std::vector<std::string>& texts, bool flushing);
    std::optional<DiskProblem> write(std::string_view text);
    void noteWritten(std::string_view text) {
        const std::scoped_lock lock(m_mutex);
        if (const std::size_t end = text.rfind('\n'); end != std::string_view::npos)
            m_wholeLines = m_written + static_cast<qint64>(end) + 1;
        m_waiting -= text.size();
        m_written += static_cast<qint64>(text.size());
    }
    /// Removes a row that the disk has accepted only in part: part of a number would be a different number.
    void dropPartOfLine() {
        // The lock is not held here: only this thread writes m_wholeLines, and no other thread should wait
        // for a slow disk.
        if (ftruncate(m_file.get(), m_wholeLines) != 0)
            return;
        const std::scoped_lock lock(m_mutex);
        m_written = m_wholeLines;
    }

    const std::string m_path;
    const std::size_t m_limit;
    // Used only by the background thread:
    Descriptor m_file;
    qint64 m_wholeLines = 0;  ///< bytes written up to the last complete line
    mutable std::mutex m_mutex;
    std::condition_variable m_atAnEnd;
    // Everything below is guarded by the mutex.
    RecordingWriter* m_owner;
    std::vector<std::string> m_queue;
    std::size_t m_waiting = 0;  ///< bytes not yet written, queued or in progress
    qint64 m_written = 0;
    bool m_busy = false;
    bool m_flushing = false;
    bool m_stopping = false;
    bool m_abandoned = false;
    bool m_ended = false;
    std::optional<DiskProblem> m_problem;
};

void RecordingWriter::Job::work() {
    const WriteSignalsBlocked blocked;
    std::unique_lock lock(m_mutex);
    while (true) {
        const std::vector<std::string> texts = std::exchange(m_queue, {});
        const bool last = m_stopping || m_abandoned;
        const bool flushing = std::exchange(m_flushing, false) || last;
        lock.unlock();
        const auto problem = carryOut(texts, flushing);
        const bool ends = last || problem;
        if (ends)
            m_file.reset();
        lock.lock();
        if (ends) {
            m_problem = problem;
            m_ended = true;
            m_atAnEnd.notify_all();
            if (m_owner != nullptr)
                QMetaObject::invokeMethod(m_owner, &RecordingWriter::take, Qt::QueuedConnection);
            return;
        }
        if (m_queue.empty() && !m_flushing && !m_stopping && !m_abandoned) {
            m_busy = false;
            return;
        }
    }
}

std::optional<DiskProblem> RecordingWriter::Job::carryOut(const std::vector<std::string>& texts,
                                                          bool flushing) {
    if (!m_file.valid()) {
        // Without O_NONBLOCK, opening a FIFO without a reader would block forever.
        m_file = Descriptor(
            ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666));
        if (!m_file.valid())
            return problemOf(errno);
    }
    for (const std::string& text : texts)
        if (const auto problem = write(text)) {
            dropPartOfLine();
            return problem;
        }
    return flushing ? flushFile(m_file.get()) : std::nullopt;
}

std::optional<DiskProblem> RecordingWriter::Job::write(std::string_view text) {
    while (!text.empty()) {
        if (guarded(m_abandoned))
            return DiskProblem{RecordingProblemKind::TooSlow};
        const ssize_t count = ::write(m_file.get(), text.data(), text.size());
        if (count >= 0) {
            noteWritten(text.substr(0, static_cast<std::size_t>(count)));
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN) {
            pollfd room{m_file.get(), POLLOUT, 0};
            constexpr int kLookAgainMs = 100;  // interval of checks whether the job was abandoned
            ::poll(&room, 1, kLookAgainMs);
        } else if (errno != EINTR) {
            return problemOf(errno);
        }
    }
    return std::nullopt;
}

// ---- the owner ----

RecordingWriter::RecordingWriter(Limits limits, QObject* parent) : QObject(parent), m_limits(limits) {
    m_patience.setSingleShot(true);
    m_patience.setInterval(m_limits.toFinish);
    connect(&m_patience, &QTimer::timeout, this, &RecordingWriter::giveUp);
    m_flush.setSingleShot(true);
    m_flush.setInterval(m_limits.toFlush);
    connect(&m_flush, &QTimer::timeout, this, [this] {
        if (m_job)
            m_job->flush();
    });
}

RecordingWriter::~RecordingWriter() {
    if (!m_job)
        return;
    m_job->stop();
    if (!m_job->waitForEnd(m_limits.toClose))
        m_job->abandon();
}

void RecordingWriter::start(const QString& path) {
    assert(!isBusy());
    m_path = path;
    m_started = monotonicNow();
    m_finishing = false;
    m_job = std::make_shared<Job>(QFile::encodeName(path).toStdString(), m_limits.queue, *this);
    m_job->begin();
}

void RecordingWriter::append(std::string text) {
    if (!isRecording() || text.empty())
        return;
    if (!m_job->push(std::move(text)))
        giveUp();
    else if (!m_flush.isActive())
        m_flush.start();
}

void RecordingWriter::stop() {
    if (!isRecording())
        return;
    m_finishing = true;
    m_recorded = monotonicNow() - m_started;
    m_patience.start();
    m_job->stop();
}

void RecordingWriter::take() {
    // An abandoned job may have announced its end before.
    if (!m_job || !m_job->ended())
        return;
    m_patience.stop();
    m_flush.stop();
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    if (const auto problem = job->problem())
        emit failed({problem->what, problem->number != 0 ? qt_error_string(problem->number) : QString(),
                     job->written()});
    else
        emit finished(job->written(), toSeconds(m_recorded));
}

void RecordingWriter::giveUp() {
    if (!m_job || m_job->ended())
        return;
    m_job->abandon();
    m_patience.stop();
    m_flush.stop();
    const RecordingFailure failure{RecordingProblemKind::TooSlow, {}, m_job->written()};
    m_job.reset();
    QMetaObject::invokeMethod(
        this, [this, failure] { emit failed(failure); }, Qt::QueuedConnection);
}

}  // namespace nmc
