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

/// What could be read of a recording. The history takes no more memory than a live one: of a long file the
/// old samples are there in a coarser form.
struct LoadedRecording {
    QString path;
    RecordingHeader header;
    History history;
    std::uint64_t samples = 0;
    std::optional<RecordingProblem> problem{};  ///< where reading ended
};

/// Reads a recording of any size in a thread of its own. One at a time; GUI thread; signals never come from
/// within a call.
class RecordingLoader : public QObject {
    Q_OBJECT

public:
    explicit RecordingLoader(QObject* parent = nullptr);

    /// loaded() or failed() follows, unless another is started or this one is cancelled.
    void start(const QString& path);
    void cancel();
    [[nodiscard]] bool isBusy() const { return m_job.isBusy(); }
    [[nodiscard]] const QString& path() const { return m_path; }

signals:
    /// 0 to 1, a few times a second.
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
