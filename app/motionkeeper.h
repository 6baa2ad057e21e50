// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/messagecontroller.h"
#include "app/motionmarker.h"
#include "app/portcontroller.h"
#include "link/command/commander.h"

namespace nmc {

/// Records which motors this session moves, and reports those that other sessions have left moving, together
/// with what their guardians did about them. GUI thread.
class MotionKeeper : public QObject {
    Q_OBJECT

public:
    /// `folder`: of the records.
    MotionKeeper(const QString& folder, const FileWriter::Disk& disk, BusStore& store, Commander& commander,
                 MessageController& messages, QObject* parent = nullptr);

    /// `owns`: this session is responsible for what moves there.
    void begin(const ConnectTarget& target, bool owns);
    /// Call for every event.
    void take(const StoreEvent& event);

    /// `guardFolder`: where guardians have reported.
    void reportSessionsBefore(const QString& guardFolder);
    /// What the message with this key reports; null: it is about something else, or is over.
    [[nodiscard]] const MotionMarker::Left* reportedBy(const QString& key) const;
    /// The user has checked the motors that the message with this key reports.
    void lookedAt(const QString& key);

private:
    void endMessages(const QStringList& files);

    MotionMarker m_marker;
    const BusStore& m_store;
    MessageController& m_messages;
};

}  // namespace nmc
