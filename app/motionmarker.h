// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <set>
#include <vector>

#include "link/files/filewriter.h"
#include "model/module/linkstate.h"

namespace nmc {

/// Records on disk which motors move, or may move, as long as they do: a program that is killed cannot stop
/// them, but the next one can at least report it. Each connection of each program has a file of its own;
/// those of programs that are gone are found at the next start, and remain until their modules were seen at
/// rest or the user has checked. Writes only when something changes, and never waits for a disk. GUI thread.
class MotionMarker {
public:
    /// What was moving when a session ended abruptly, or when its port was unplugged.
    struct Left {
        QString file;
        QString port;
        quint32 baud = 0;
        std::set<ModuleIndex> modules{};
        qint64 process = 0;       ///< the process of that session
        unsigned connection = 0;  ///< within that process, counted from 1
    };

    /// `folder` need not exist; it is created when something moves.
    explicit MotionMarker(QString folder, FileWriter::Disk disk = writeFile);

    [[nodiscard]] const std::vector<Left>& left() const { return m_left; }
    /// The last connection of this process; null: it had nothing moving then.
    [[nodiscard]] const Left* lastOf(qint64 process) const;

    /// A port is being opened. `owns`: this session is responsible for what moves there. If not, in the
    /// simulator or on a read-only connection, nothing is written, and other sessions' entries are not
    /// removed when their motors are seen at rest.
    void begin(const QString& port, quint32 baud, bool owns);
    /// A chain was found at the port.
    void found(TimePoint now) { m_foundAt = now; }
    /// Call before sending a command that may move these modules; until it ends, it counts as motion.
    void asked(bus::OperationId id, const std::vector<ModuleIndex>& modules);
    void ended(bus::OperationId id, TimePoint now);
    /// The module is held in motion, which counts as motion until a later status.
    void held(ModuleIndex module, TimePoint now);
    /// Returns the files whose modules have all been seen at rest since; these are removed.
    [[nodiscard]] QStringList update(const LinkState& link);
    /// These modules were seen at rest after a stop; returns the files that are removed as a result.
    [[nodiscard]] QStringList stopped(const std::vector<ModuleIndex>& modules);
    /// The user has checked the motors.
    void forget(const QString& file);

private:
    [[nodiscard]] bool moves(const ModuleState& module) const;
    void write(const std::set<ModuleIndex>& moving);
    [[nodiscard]] QStringList forgetOver();

    QString m_folder;
    FileWriter m_files;
    std::vector<Left> m_left;
    Left m_own;
    bool m_owns = true;
    unsigned m_connections = 0;
    TimePoint m_foundAt;
    std::map<bus::OperationId, std::vector<ModuleIndex>> m_pending;
    std::map<ModuleIndex, TimePoint> m_askedAt;
};

}  // namespace nmc
