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
class PacketModel;
class PacketView;
class PacketLog;
struct PacketSession;

/// Every exchange with time, bytes, meaning and verdict; and the counters of the link. It wants records only
/// while it can be seen and is not paused, so that it costs nothing when closed.
class PacketMonitor : public QWidget {
    Q_OBJECT

public:
    explicit PacketMonitor(QWidget* parent = nullptr);

    /// A connection is being opened: the packets of the one before are forgotten.
    void begin(const PacketSession& session);
    /// What was recorded since the last call; once a frame.
    void showPackets(std::vector<bus::ExchangeRecord> records);
    /// How many modules there are to choose from.
    void offerModules(int count);
    /// Once a second.
    void showFigures(const LinkFigures& figures);

    /// Somebody can see it: not so behind another dock's tab.
    void setSeen(bool seen);
    [[nodiscard]] bool recording() const { return m_recording; }
    [[nodiscard]] const PacketLog& log() const;

signals:
    void recordingChanged(bool recording);
    /// Everything that is kept: a replayable log when the name ends in .nmclog, else a text.
    void saveRequested(const QString& path, const nmc::FileContent& content);

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
