// SPDX-License-Identifier: MIT
#include "link/ports/latencytimer.h"

#include <QFile>
#include <QFileInfo>

namespace nmc {

QString latencyTimerFile(const QString& port, const QString& root) {
    // A name below /dev/serial/by-id is resolved to the name that the driver uses.
    const QString path = QFileInfo(port).canonicalFilePath();
    return root + QStringLiteral("/bus/usb-serial/devices/") +
           QFileInfo(path.isEmpty() ? port : path).fileName() + QStringLiteral("/latency_timer");
}

std::optional<Duration> latencyTimerOf(const QString& port, const QString& root) {
    constexpr int kLongest = 255;
    QFile file(latencyTimerFile(port, root));
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    bool isNumber = false;
    const int ms = file.readAll().trimmed().toInt(&isNumber);
    if (!isNumber || ms < 0 || ms > kLongest)
        return std::nullopt;
    return std::chrono::milliseconds(ms);
}

}  // namespace nmc
