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

/// Why a recording ended before stop() was called.
enum class RecordingProblemKind : std::uint8_t {
    NoFolder,  ///< the folder of the file does not exist
    NotAFile,  ///< a folder, or a pipe without a reader
    NoPermission,
    ReadOnly,  ///< the disk is read-only for everybody
    NoSpace,
    FileTooLarge,  ///< exceeds the limit of the file system, such as 4 GiB on a USB stick
    Removed,       ///< deleted by somebody during the recording
    TooSlow,       ///< the disk does not accept data as fast as it arrives
    Other,         ///< detail holds the system's message
};

struct RecordingFailure {
    RecordingProblemKind trouble = RecordingProblemKind::Other;
    QString detail{};  ///< the system's message
    qint64 bytes = 0;  ///< number of bytes written before the failure; they stay in the file
};

/// Writes text to a file as it arrives, in the background: no disk, however slow, full or gone, makes the GUI
/// thread wait. The text reaches the operating system immediately and the disk within a second or two. One
/// recording at a time. All members belong to the GUI thread; signals are emitted there, and never from
/// within a call.
class RecordingWriter : public QObject {
    Q_OBJECT

public:
    struct Limits {
        std::size_t queue = 32U << 20U;              ///< bytes that may wait for the disk
        std::chrono::milliseconds toFlush{1'000};    ///< time until new text is flushed to the disk
        std::chrono::milliseconds toFinish{30'000};  ///< limit after stop()
        std::chrono::milliseconds toClose{3'000};    ///< limit in the destructor
    };

    explicit RecordingWriter(QObject* parent = nullptr) : RecordingWriter(Limits(), parent) {}
    explicit RecordingWriter(Limits limits, QObject* parent = nullptr);
    /// Ends the recording, waiting a short time for the disk to accept what is still in the queue.
    ~RecordingWriter() override;

    /// Replaces an existing file. Must not be called while isBusy(). failed() or finished() follows, once.
    void start(const QString& path);
    /// Appends text; ignored when no recording is in progress.
    void append(std::string text);
    /// Writes what is waiting and ends the recording.
    void stop();

    /// True while text is accepted: from start() to stop() or failed().
    [[nodiscard]] bool isRecording() const { return m_job != nullptr && !m_finishing; }
    /// True from start() to finished() or failed().
    [[nodiscard]] bool isBusy() const { return m_job != nullptr; }
    [[nodiscard]] const QString& path() const { return m_path; }

signals:
    /// Emitted after stop(), when everything is on the disk. `seconds`: from start() to stop().
    void finished(qint64 bytes, double seconds);
    void failed(const nmc::RecordingFailure& failure);

private:
    class Job;

    void take();
    void giveUp();

    Limits m_limits;
    QString m_path;
    std::shared_ptr<Job> m_job;  ///< shared with the background, where it may be left behind
    QTimer m_patience;
    QTimer m_flush;
    bool m_finishing = false;
    TimePoint m_started;
    Duration m_recorded{};
};

}  // namespace nmc
