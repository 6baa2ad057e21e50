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

/// Records what the modules report to a file, opens such files in the scope, and saves the window's exports.
/// Never blocks the panel on a disk. GUI thread.
class RecordingController : public QObject {
    Q_OBJECT

public:
    RecordingController(MainWindow& window, const BusStore& store, FileWriter::Disk disk = writeFile);

    /// Adds a note for readers of the recording.
    void note(const QString& text);
    /// Call for every event: the recording ends with the connection.
    void take(const StoreEvent& event);

private:
    void end();
    void start(const QString& path);
    void look();
    [[nodiscard]] bool isOfThisChain();
    /// Begins the recording that waits for the end of the last one, if one does.
    void startNext();
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
    QString m_next;  ///< begins when the disk has taken the previous recording; empty: none
    RecordingLoader m_loader;
    bool m_under = false;  ///< the file being loaded is shown under the live traces
    FileWriter m_files;
    QTimer m_clock;    ///< updates the display of a recording
    TimePoint m_zero;  ///< the origin of the scope's time
    TimePoint m_started;
    std::optional<TimePoint> m_historyZero;  ///< of the history being recorded
    std::vector<std::uint64_t> m_written;  ///< number of samples already written or to be skipped, by module
    std::size_t m_gainsWritten = 0;
    qint64 m_bytes = 0;
};

}  // namespace nmc
