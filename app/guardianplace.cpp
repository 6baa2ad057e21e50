// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardianplace.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "link/guardian/guardreport.h"

namespace nmc {

QString guardFolder(const QSettings& settings) {
    return QFileInfo(settings.fileName()).absolutePath();
}

GuardianPlace guardianPlace(const QSettings& settings) {
    const QString folder = guardFolder(settings);
    QDir().mkpath(folder);
    const QString program =
        QCoreApplication::applicationDirPath() + QStringLiteral("/" NMC_GUARD_FOLDER "/nmcguard");
    return {QDir::cleanPath(program).toStdString(), guardReportFile(folder.toStdString())};
}

}  // namespace nmc
