// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <set>
#include <vector>

#include "app/messagecontroller.h"
#include "app/portcontroller.h"
#include "link/command/commander.h"
#include "link/files/filewriter.h"

namespace nmc {

/// Records on disk which motors move, or may move, as long as they do: a program that is killed cannot stop
/// them, but the next one can at least report it, together with what the guardian did about them. Each
/// connection of each program has a file of its own; those of programs that are gone are found at the next
/// start, and remain until their modules were seen at rest or the user has checked. Writes only when
/// something changes, and never waits for a disk. GUI thread.
class MotionKeeper : public QObject {
    Q_OBJECT

public:
    /// What was moving when a session ended abruptly, or when its port was unplugged.
    struct Left {
        QString file;
        QString port;
        quint32 baud = 0;
        std::set<ModuleIndex> modules{};
        std::vector<int> addresses{};  ///< of all modules of the chain, in order; empty: from 1 on
        qint64 process = 0;            ///< the process of that session
        unsigned connection = 0;       ///< within that process, counted from 1
    };

    /// `folder` need not exist; it is created when something moves.
    MotionKeeper(QString folder, FileWriter::Disk disk, BusStore& store, Commander& commander,
                 MessageController& messages);

    /// A port is being opened. `owns`: this session is responsible for what moves there. If not, in the
    /// simulator or on a read-only connection, nothing is written, and other sessions' entries are not
    /// removed when their motors are seen at rest.
    void begin(const ConnectTarget& target, bool owns);
    /// Call for every event.
    void take(const StoreEvent& event);

    /// Reports what other sessions left moving. `guardFolder`: where guardians have reported.
    void reportSessionsBefore(const QString& guardFolder);
    /// What the message with this key reports; null: it is about something else, or is over.
    [[nodiscard]] const Left* reportedBy(const QString& key) const;
    /// The user has checked the motors that the message with this key reports.
    void lookedAt(const QString& key);

private:
    [[nodiscard]] const Left* lastOf(qint64 process) const;
    void asked(bus::OperationId id, const std::vector<ModuleIndex>& modules);
    void ended(bus::OperationId id);
    void held(ModuleIndex module);
    void look();
    void stopped(const std::vector<ModuleIndex>& modules);
    [[nodiscard]] bool moves(const ModuleState& module) const;
    void write(const std::set<ModuleIndex>& moving);
    void forgetOver();

    QString m_folder;
    FileWriter m_files;
    const BusStore& m_store;
    MessageController& m_messages;
    std::vector<Left> m_left;
    Left m_own;
    bool m_owns = true;
    unsigned m_connections = 0;
    TimePoint m_foundAt;
    std::map<bus::OperationId, std::vector<ModuleIndex>> m_pending;  ///< count as motion until they end
    std::map<ModuleIndex, TimePoint> m_askedAt;
};

}  // namespace nmc
