// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "link/connection/busstore.h"
#include "link/files/filewriter.h"
#include "link/files/recordingloader.h"
#include "link/files/recordingwriter.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Writes what the modules say to a file from now on, opens such files in the scope, and saves what the
/// window exports. No disk holds up the panel. GUI thread.
class RecordingController : public QObject {
    Q_OBJECT

public:
    RecordingController(MainWindow& window, const BusStore& store, FileWriter::Disk disk = writeFile,
                        QObject* parent = nullptr);

    /// Something has happened that a reader of the recording should know of.
    void note(const QString& text);
    /// Nothing more will come.
    void end();

private:
    void start(const QString& path);
    void look();
    [[nodiscard]] bool isOfThisChain();
    void writeHead();
    void writeNews();
    void showRecording();
    void failed(const RecordingFailure& failure);
    void load(const QString& path, bool under);
    void loaded(std::shared_ptr<LoadedRecording> recording);
    void save(const QString& path, const FileWriter::Content& content);
    void write(std::string text);

    MainWindow& m_window;
    const BusStore& m_store;
    RecordingWriter m_writer;
    RecordingLoader m_loader;
    bool m_under = false;  ///< what is being loaded goes under the live traces
    FileWriter m_files;
    QTimer m_clock;    ///< of what is shown of a recording
    TimePoint m_zero;  ///< as the scope counts its time
    TimePoint m_started;
    std::optional<TimePoint> m_historyZero;  ///< of the history that is being recorded
    std::vector<std::uint64_t> m_written;    ///< samples that need not be, by module
    std::size_t m_gainsWritten = 0;
    qint64 m_bytes = 0;
};

}  // namespace nmc
