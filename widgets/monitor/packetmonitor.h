// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "bus/exchangerecord.h"
#include "model/module/linkstate.h"
#include "widgets/common/filedialog.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class CounterTable;
class PacketLog;
class PacketModel;
struct PacketSession;
class PacketView;
class Requests;

/// Shows every exchange with time, bytes, meaning and verdict, and the counters of the link. It requests
/// records only while it can be seen and is not paused, so that it costs nothing when closed.
class PacketMonitor : public QWidget {
    Q_OBJECT

public:
    explicit PacketMonitor(Requests& requests, QWidget* parent = nullptr);

    /// Call when a connection is being opened; discards the packets of the previous one.
    void begin(const PacketSession& session);
    /// Adds what was recorded since the last call, which is once per frame.
    void showPackets(std::vector<bus::ExchangeRecord> records);
    /// Offers this many modules to filter by, or more if it has offered more.
    void offerModules(int count);
    /// Called once a second.
    void showFigures(const LinkFigures& figures);

    /// `seen`: the monitor can be seen, and is not behind another dock's tab.
    void setSeen(bool seen);
    [[nodiscard]] bool recording() const { return m_recording; }
    [[nodiscard]] const PacketLog& log() const;

signals:
    void recordingChanged(bool recording);

private:
    void buildControls();
    void buildContent();
    QPushButton* newButton(const QString& objectName, const QString& text, const QString& toolTip,
                           const QKeySequence& shortcut);
    void applyFilter();
    void pause(bool paused);
    void updateRecording();
    void copy();
    void chooseFile();
    void showSummary();

    Requests& m_requests;
    PacketModel* m_model;
    PacketView* m_view;
    CounterTable* m_counters;
    QComboBox* m_module;
    QComboBox* m_kind;
    QPushButton* m_pause = nullptr;
    QPushButton* m_clear = nullptr;
    QPushButton* m_copy = nullptr;
    QPushButton* m_save = nullptr;
    QLabel* m_summary;
    bool m_seen = false;
    bool m_recording = false;
};

}  // namespace nmc
