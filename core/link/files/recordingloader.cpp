// SPDX-License-Identifier: MIT
#include "link/files/recordingloader.h"

#include <atomic>
#include <limits>
#include <utility>

namespace nmc {

namespace {

constexpr qint64 kPiece = 256 << 10;  ///< bytes
constexpr int kProgressMs = 100;
/// A recording may contain rows of any module, even if its header does not mention the module.
constexpr std::size_t kModules = std::numeric_limits<std::uint8_t>::max();

/// More than anyone sends; the limit keeps a file from using memory without bound.
constexpr std::size_t kMaxGains = 10'000;

}  // namespace

/// The data that the thread fills.
struct RecordingLoader::Reading {
    LoadedRecording result;
    std::optional<FileError> error{};
    std::atomic<double> share = 0.0;

    void read(const BackgroundJob::Cancelled& cancelled);
};

void RecordingLoader::Reading::read(const BackgroundJob::Cancelled& cancelled) {
    const auto file = openToRead(result.path);
    if (!file) {
        error = file.error();
        return;
    }
    RecordingReader reader(
        {[this](ModuleIndex module, const ScopeSample& sample) { result.history.append(module, sample); },
         [this](const GainsChange& change) {
             if (result.history.gains().size() < kMaxGains)
                 result.history.noteGains(change);
         }});
    const qint64 size = (*file)->size();
    for (qint64 done = 0; !cancelled;) {
        const QByteArray piece = (*file)->read(kPiece);
        if ((*file)->error() != QFileDevice::NoError) {
            error = FileError{FileErrorKind::Other, result.path, (*file)->errorString()};
            return;
        }
        done += piece.size();
        if (size > 0)
            share = std::min(1.0, static_cast<double>(done) / static_cast<double>(size));
        if (piece.isEmpty() || !reader.feed({piece.constData(), static_cast<std::size_t>(piece.size())}))
            break;
    }
    result.problem = reader.finish();
    result.header = reader.header();
    result.samples = reader.samples();
}

RecordingLoader::RecordingLoader(QObject* parent) : QObject(parent) {
    m_progress.setInterval(kProgressMs);
    connect(&m_progress, &QTimer::timeout, this, [this] { emit progressed(m_reading->share); });
    connect(&m_job, &BackgroundJob::ended, this, &RecordingLoader::end);
}

void RecordingLoader::start(const QString& path) {
    cancel();
    m_path = path;
    m_reading = std::make_shared<Reading>();
    m_reading->result.path = path;
    m_reading->result.history = History(kModules);
    m_progress.start();
    m_job.start(
        [reading = m_reading](const BackgroundJob::Cancelled& cancelled) { reading->read(cancelled); });
}

void RecordingLoader::cancel() {
    m_progress.stop();
    m_job.cancel();
    m_reading.reset();
}

void RecordingLoader::end() {
    m_progress.stop();
    const std::shared_ptr<Reading> reading = std::exchange(m_reading, nullptr);
    if (reading->error)
        emit failed(*reading->error);
    else
        // Deleted together with the last reference.
        emit loaded(std::shared_ptr<LoadedRecording>(reading, &reading->result));
}

}  // namespace nmc
