// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/scope/scopeexport.h"

class QAction;
class QLabel;
class QPushButton;

namespace nmc {

/// The scope and files: recording to one, opening one, laying one under the live traces, and what is
/// exported. It asks for names and says how it goes, in a row for each thing that goes on; others do it.
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

    explicit ScopeFiles(QWidget* panel);

    [[nodiscard]] QAction* recordAction() const { return m_record; }
    [[nodiscard]] QAction* openAction() const { return m_open; }
    [[nodiscard]] QAction* underAction() const { return m_under; }
    [[nodiscard]] ScopeExport& exporting() { return m_export; }

    /// There is something to be recorded.
    void showConnected(bool connected);
    /// What is being recorded; nothing: no recording.
    void showRecording(const std::optional<Recording>& recording);
    /// What is being opened; nothing: no file.
    void showOpening(const std::optional<Opening>& opening);
    /// What lies under the live traces; empty: nothing.
    void showUnder(const QString& title);

signals:
    /// The user has agreed that the file is replaced.
    void recordRequested(const QString& path);
    void recordingEndRequested();
    void openRequested(const QString& path);
    void underRequested(const QString& path);
    /// By a share of the time that is seen; later is positive.
    void underMoved(double share);
    void underRemoved();
    void openingCancelled();
    void saveRequested(const QString& path, const nmc::FileContent& content);
    /// One page, by the system's usual printer.
    void printRequested(const QByteArray& pdf);

private:
    struct Row {
        QWidget* widget = nullptr;
        QLabel* label = nullptr;
        QPushButton* button = nullptr;
    };
    Row addRow(const QString& name, const QString& title, const QString& verb, const QString& meaning);
    void showRecordAction();
    void recordOrEnd();
    void chooseToRecord();
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
