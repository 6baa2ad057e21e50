// SPDX-License-Identifier: MIT
#include "link/ports/portlist.h"

#include <QSerialPortInfo>
#include <QStringList>
#include <algorithm>

namespace nmc {

QList<PortEntry> serialPorts() {
    QList<QSerialPortInfo> infos = QSerialPortInfo::availablePorts();
    std::ranges::stable_sort(infos, [](const QSerialPortInfo& a, const QSerialPortInfo& b) {
        return a.hasVendorIdentifier() && !b.hasVendorIdentifier();
    });
    QList<PortEntry> ports;
    for (const QSerialPortInfo& info : infos) {
        QStringList words;
        for (const QString& word : {info.manufacturer(), info.description()})
            if (!word.isEmpty() && !words.contains(word))
                words << word;
        ports.append({info.systemLocation(), words.join(QLatin1Char(' ')), info.serialNumber(),
                      info.vendorIdentifier(), info.productIdentifier()});
    }
    return ports;
}

}  // namespace nmc
