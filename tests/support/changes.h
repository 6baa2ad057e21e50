// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

namespace nmc::testing_support {

/// What each module of a simulator has carried out so far apart from mere queries, as counted by the
/// simulator.
template <typename Simulator>
[[nodiscard]] QJsonArray changes(Simulator& sim) {
    QJsonArray changes;
    for (const QJsonValue& module :
         sim.control(QStringLiteral("stats"))[QStringLiteral("modules")].toArray()) {
        QJsonObject executed = module[QStringLiteral("executed")].toObject();
        executed.remove(QStringLiteral("nop"));
        executed.remove(QStringLiteral("read_status"));
        changes.append(executed);
    }
    return changes;
}

}  // namespace nmc::testing_support
