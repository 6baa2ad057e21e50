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

namespace nmc {

struct DiskProblem {
    RecordingProblemKind what = RecordingProblemKind::Other;
    int number = 0;  ///< errno
};

namespace {

using namespace std::chrono_literals;

constexpr Duration kBetweenFlushes = 1s;

DiskProblem problemOf(int number) {
    switch (number) {
        case ENOENT:
        case ENOTDIR:
            return {RecordingProblemKind::NoFolder, number};
        case EISDIR:
        case ENXIO:  // a FIFO that nobody reads
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

/// They end the whole program by default; an error code is enough.
void blockWriteSignals() {
    sigset_t ignored;
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    sigaddset(&ignored, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &ignored, nullptr);
}

class Descriptor {
public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    ~Descriptor() {
        if (m_fd >= 0)
            ::close(m_fd);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int fd() const { return m_fd; }

private:
    int m_fd;
};

/// Onto the disk.
std::optional<DiskProblem> flush(int fd) {
    // EINVAL: what is not a plain file has nothing to flush.
    if (fdatasync(fd) != 0 && errno != EINVAL)
        return problemOf(errno);
    struct stat status {};
    if (fstat(fd, &status) == 0 && status.st_nlink == 0)
        return DiskProblem{RecordingProblemKind::Removed};
    return std::nullopt;
}

}  // namespace

/// One recording: what the GUI thread and the writing thread share.
class RecordingWriter::Job {
public:
    Job(std::string path, std::size_t limit, RecordingWriter& owner)
        : m_path(std::move(path)), m_limit(limit), m_owner(&owner) {}

    // ---- GUI thread ----

    /// False: too much waits for the disk already.
    bool push(std::string text) {
        const std::scoped_lock lock(m_mutex);
        if (m_ended)
            return true;  // the owner is about to hear why
        if (m_waiting + text.size() > m_limit)
            return false;
        m_waiting += text.size();
        m_queue.push_back(std::move(text));
        m_changed.notify_all();
        return true;
    }
    void stop() {
        const std::scoped_lock lock(m_mutex);
        m_stopping = true;
        m_changed.notify_all();
    }
    bool waitForEnd(std::chrono::milliseconds patience) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, patience, [this] { return m_ended; });
    }
    /// Nobody waits for the rest any more. The thread ends as soon as the disk lets it.
    void abandon() {
        const std::scoped_lock lock(m_mutex);
        m_abandoned = true;
        m_owner = nullptr;
        m_changed.notify_all();
    }
    [[nodiscard]] bool ended() const {
        const std::scoped_lock lock(m_mutex);
        return m_ended;
    }
    [[nodiscard]] std::optional<DiskProblem> problem() const {
        const std::scoped_lock lock(m_mutex);
        return m_problem;
    }
    [[nodiscard]] qint64 written() const {
        const std::scoped_lock lock(m_mutex);
        return m_written;
    }

    // ---- writing thread ----

    void run() {
        blockWriteSignals();
        const auto problem = record();
        const std::scoped_lock lock(m_mutex);
        m_problem = problem;
        m_ended = true;
        m_changed.notify_all();
        if (m_owner != nullptr)
            QMetaObject::invokeMethod(m_owner, &RecordingWriter::threadEnded, Qt::QueuedConnection);
    }

private:
    std::optional<DiskProblem> record();
    std::optional<DiskProblem> write(int fd, std::string_view text);
    /// Waits for text or the end, until `flushAt` at most; true when nothing will follow.
    bool next(std::vector<std::string>& texts, std::optional<TimePoint> flushAt);
    void noteWritten(std::string_view text) {
        const std::scoped_lock lock(m_mutex);
        if (const std::size_t end = text.rfind('\n'); end != std::string_view::npos)
            m_wholeLines = m_written + static_cast<qint64>(end) + 1;
        m_waiting -= text.size();
        m_written += static_cast<qint64>(text.size());
    }
    /// A row whose end the disk has not taken goes: what is left of a number would be another number.
    void dropPartOfLine(int fd) {
        // Only this thread writes it; and the disk may take its time, for which nobody is to wait.
        if (ftruncate(fd, m_wholeLines) != 0)
            return;
        const std::scoped_lock lock(m_mutex);
        m_written = m_wholeLines;
    }
    [[nodiscard]] bool abandoned() const {
        const std::scoped_lock lock(m_mutex);
        return m_abandoned;
    }

    const std::string m_path;
    const std::size_t m_limit;
    qint64 m_wholeLines = 0;  ///< of what is written; the writing thread's own
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    // All below: under the mutex.
    RecordingWriter* m_owner;
    std::vector<std::string> m_queue;
    std::size_t m_waiting = 0;  ///< bytes that are not written yet, queued or not
    qint64 m_written = 0;
    bool m_stopping = false;
    bool m_abandoned = false;
    bool m_ended = false;
    std::optional<DiskProblem> m_problem;
};

std::optional<DiskProblem> RecordingWriter::Job::record() {
    // Without O_NONBLOCK a FIFO that nobody reads would never open.
    const Descriptor file(
        ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666));
    if (file.fd() < 0)
        return problemOf(errno);
    std::optional<TimePoint> flushAt;  // nothing: the disk has everything
    for (bool last = false; !last;) {
        std::vector<std::string> texts;
        last = next(texts, flushAt);
        for (const std::string& text : texts)
            if (const auto problem = write(file.fd(), text)) {
                dropPartOfLine(file.fd());
                return problem;
            }
        if (!texts.empty() && !flushAt)
            flushAt = monotonicNow() + kBetweenFlushes;
        if (flushAt && (last || monotonicNow() >= *flushAt)) {
            if (const auto problem = flush(file.fd()))
                return problem;
            flushAt.reset();
        }
    }
    return std::nullopt;
}

bool RecordingWriter::Job::next(std::vector<std::string>& texts, std::optional<TimePoint> flushAt) {
    std::unique_lock lock(m_mutex);
    const auto something = [this] { return !m_queue.empty() || m_stopping || m_abandoned; };
    if (flushAt)
        m_changed.wait_for(lock, *flushAt - monotonicNow(), something);
    else
        m_changed.wait(lock, something);
    texts.swap(m_queue);
    return m_stopping || m_abandoned;
}

std::optional<DiskProblem> RecordingWriter::Job::write(int fd, std::string_view text) {
    while (!text.empty()) {
        if (abandoned())
            return DiskProblem{RecordingProblemKind::TooSlow};
        const ssize_t count = ::write(fd, text.data(), text.size());
        if (count >= 0) {
            noteWritten(text.substr(0, static_cast<std::size_t>(count)));
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN) {
            pollfd room{fd, POLLOUT, 0};
            constexpr int kLookAgainMs = 100;  // whether somebody still waits for it
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
}

RecordingWriter::~RecordingWriter() {
    if (!m_job)
        return;
    m_job->stop();
    if (m_job->waitForEnd(m_limits.toClose)) {
        m_thread.join();
    } else {
        m_job->abandon();
        m_thread.detach();
    }
}

void RecordingWriter::start(const QString& path) {
    assert(!isBusy());
    m_path = path;
    m_started = monotonicNow();
    m_finishing = false;
    m_job = std::make_shared<Job>(QFile::encodeName(path).toStdString(), m_limits.queue, *this);
    m_thread = std::thread([job = m_job] { job->run(); });
}

void RecordingWriter::append(std::string text) {
    if (isRecording() && !text.empty() && !m_job->push(std::move(text)))
        giveUp();
}

void RecordingWriter::stop() {
    if (!isRecording())
        return;
    m_finishing = true;
    m_recorded = monotonicNow() - m_started;
    m_job->stop();
    m_patience.start();
}

void RecordingWriter::threadEnded() {
    // A job that was given up may have announced its end before.
    if (!m_job || !m_job->ended())
        return;
    m_thread.join();
    m_patience.stop();
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
    m_thread.detach();
    m_patience.stop();
    const RecordingFailure failure{RecordingProblemKind::TooSlow, {}, m_job->written()};
    m_job.reset();
    QMetaObject::invokeMethod(
        this, [this, failure] { emit failed(failure); }, Qt::QueuedConnection);
}

}  // namespace nmc
