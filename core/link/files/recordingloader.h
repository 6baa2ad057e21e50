// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QTimer>
#include <memory>
#include <optional>

#include "link/files/backgroundjob.h"
#include "link/files/machineio.h"
#include "model/recording/recordingreader.h"
#include "model/scope/history.h"

namespace nmc {

/// The part of a recording that could be read. The history takes no more memory than a live one: the old
/// samples of a long file are kept at lower resolution.
struct LoadedRecording {
    QString path;
    RecordingHeader header;
    History history;
    std::uint64_t samples = 0;
    std::optional<RecordingProblem> problem{};  ///< the reason why reading ended early
};

/// Reads a recording of any size in its own thread. One at a time; GUI thread; signals are never emitted from
/// within a call.
class RecordingLoader : public QObject {
    Q_OBJECT

public:
    explicit RecordingLoader(QObject* parent = nullptr);

    /// loaded() or failed() follows, unless another load is started or this one is cancelled.
    void start(const QString& path);
    void cancel();
    [[nodiscard]] bool isBusy() const { return m_job.isBusy(); }
    [[nodiscard]] const QString& path() const { return m_path; }

signals:
    /// Progress from 0 to 1, a few times a second.
    void progressed(double share);
    void loaded(std::shared_ptr<nmc::LoadedRecording> recording);
    void failed(const nmc::FileError& error);

private:
    struct Reading;

    void end();

    BackgroundJob m_job;
    QTimer m_progress;
    QString m_path;
    std::shared_ptr<Reading> m_reading;
};

}  // namespace nmc
