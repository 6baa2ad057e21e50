// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <memory>
#include <string>

#include "base/time.h"

namespace nmc {

/// Why a recording ended before it was told to.
enum class RecordingProblemKind : std::uint8_t {
    NoFolder,  ///< the folder it should be in is not there
    NotAFile,  ///< a folder, or a pipe that nobody reads
    NoPermission,
    ReadOnly,  ///< the disk, for everybody
    NoSpace,
    FileTooLarge,  ///< for the file system, as 4 GiB are on a USB stick
    Removed,       ///< somebody has deleted it meanwhile
    TooSlow,       ///< the disk does not take data as fast as they come
    Other,         ///< detail holds the system's own words
};

struct RecordingFailure {
    RecordingProblemKind trouble = RecordingProblemKind::Other;
    QString detail{};  ///< the system's own words
    qint64 bytes = 0;  ///< written before; they stay in the file
};

/// Writes text to a file as it comes, in the background: no disk, however slow, full or gone, makes the
/// GUI thread wait. What has come is with the operating system at once and on the disk within a second or
/// two. One recording at a time. All members belong to the GUI thread, and signals come there, never from
/// within a call.
class RecordingWriter : public QObject {
    Q_OBJECT

public:
    struct Limits {
        std::size_t queue = 32U << 20U;              ///< bytes that may wait for the disk
        std::chrono::milliseconds toFlush{1'000};    ///< what has come onto the disk
        std::chrono::milliseconds toFinish{30'000};  ///< after stop()
        std::chrono::milliseconds toClose{3'000};    ///< in the destructor
    };

    explicit RecordingWriter(QObject* parent = nullptr) : RecordingWriter(Limits(), parent) {}
    explicit RecordingWriter(Limits limits, QObject* parent = nullptr);
    /// Ends the recording, waiting a little for the disk to take what is still in the queue.
    ~RecordingWriter() override;

    /// Replaces the file that may be there. Not while isBusy(). failed() or finished() follows, once.
    void start(const QString& path);
    /// More text. Passed over when nothing is being recorded.
    void append(std::string text);
    /// Writes what waits, and finishes.
    void stop();

    /// Takes text: from start() to stop() or failed().
    [[nodiscard]] bool isRecording() const { return m_job != nullptr && !m_finishing; }
    /// From start() to finished() or failed().
    [[nodiscard]] bool isBusy() const { return m_job != nullptr; }
    [[nodiscard]] const QString& path() const { return m_path; }

signals:
    /// After stop(): all of it is on the disk. `seconds`: from start() to stop().
    void finished(qint64 bytes, double seconds);
    void failed(const nmc::RecordingFailure& failure);

private:
    class Job;

    void take();
    void giveUp();

    Limits m_limits;
    QString m_path;
    std::shared_ptr<Job> m_job;  ///< shared with the background, where it may have to be left behind
    QTimer m_patience;
    QTimer m_flush;
    bool m_finishing = false;
    TimePoint m_started;
    Duration m_recorded{};
};

}  // namespace nmc
