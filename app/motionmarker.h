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

/// Remembers on disk which motors move, or may, as long as they do: a program that is killed cannot stop
/// them, and the next one can at least say so. Each connection of each program has a file of its own; those
/// of programs that are gone are found by the next start, and stay until their modules were seen at rest or
/// the user has looked. Writes only when something changes, and waits for no disk. GUI thread.
class MotionMarker {
public:
    /// What moved when a session ended without a word, or when its port was unplugged.
    struct Left {
        QString file;
        QString port;
        quint32 baud = 0;
        std::set<ModuleIndex> modules{};
        qint64 process = 0;       ///< whose session that was
        unsigned connection = 0;  ///< of that process, counted from 1
    };

    /// `folder` need not be there; it is made when something moves.
    explicit MotionMarker(QString folder, FileWriter::Disk disk = writeFile);

    [[nodiscard]] const std::vector<Left>& left() const { return m_left; }
    /// Of the connection that this process had last; none: it had nothing moving then.
    [[nodiscard]] const Left* lastOf(qint64 process) const;

    /// A port is being opened. `owns`: what moves there is this session's business. Where it is not, in the
    /// simulator or where the panel only looks, nothing is written, and nothing that others have left is over
    /// by being seen.
    void begin(const QString& port, quint32 baud, bool owns);
    /// A chain was found at it.
    void found(TimePoint now) { m_foundAt = now; }
    /// Before what may move these is sent; until it ends it counts as motion.
    void asked(bus::OperationId id, const std::vector<ModuleIndex>& modules);
    void ended(bus::OperationId id, TimePoint now);
    /// The same for evidence of a hold.
    void held(ModuleIndex module, TimePoint now);
    /// Files of those whose modules have all been seen at rest since: they are over.
    [[nodiscard]] QStringList update(const LinkState& link);
    /// These were seen at rest after a stop; the same.
    [[nodiscard]] QStringList stopped(const std::vector<ModuleIndex>& modules);
    /// The user has looked at the motors.
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
