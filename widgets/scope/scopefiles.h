// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/scope/scopeexport.h"

class QAction;
class QLabel;
class QPushButton;

namespace nmc {

class Requests;

/// The file functions of the scope: recording to a file, opening one, showing one under the live traces, and
/// exporting. Asks for file names and shows the progress, in a row for each activity; other classes carry
/// them out.
class ScopeFiles : public QWidget {
    Q_OBJECT

public:
    struct Recording {
        QString path;
        double seconds = 0;
        qint64 bytes = 0;
    };
    struct Opening {
        QString path;
        double share = 0;  ///< 0 to 1
    };

    ScopeFiles(Requests& requests, QWidget* panel);

    [[nodiscard]] QAction* recordAction() const { return m_record; }
    [[nodiscard]] QAction* openAction() const { return m_open; }
    [[nodiscard]] QAction* underAction() const { return m_under; }
    [[nodiscard]] ScopeExport& exporting() { return m_export; }

    /// True if there is something to record.
    void showConnected(bool connected);
    /// Shows the recording in progress; empty: none.
    void showRecording(const std::optional<Recording>& recording);
    /// Shows the file that is being opened; empty: none.
    void showOpening(const std::optional<Opening>& opening);
    /// Shows the title of the recording under the live traces; empty: none.
    void showUnder(const QString& title);

signals:
    /// If the file exists, the user has agreed to replace it.
    void recordRequested(const QString& path);
    void recordingEndRequested();
    void openRequested(const QString& path);
    void underRequested(const QString& path);
    /// The recording is to be moved by a share of the visible time; later is positive.
    void underMoved(double share);
    void underRemoved();
    void openingCancelled();

private:
    struct Row {
        QWidget* widget = nullptr;
        QLabel* label = nullptr;
        QPushButton* button = nullptr;
    };
    Row addRow(const QString& name, const QString& title, const QString& verb, const QString& meaning);
    void showRecordAction();
    void recordOrEnd();
    [[nodiscard]] static QStringList filters();
    void choose(const QString& objectName, const QString& title, void (ScopeFiles::*wanted)(const QString&));
    void addMoveButton(const QString& objectName, const QString& text, const QString& meaning, double share);

    QWidget* m_panel;
    ScopeExport m_export;
    QAction* m_record;
    QAction* m_open;
    QAction* m_under;
    Row m_recordingRow;
    Row m_openingRow;
    Row m_underRow;
    bool m_recording = false;
    bool m_connected = false;
    QString m_folder;
};

}  // namespace nmc
