// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/knownchain.h"

#include <QRegularExpression>
#include <QStringList>
#include <set>

#include "protocol/baud.h"
#include "protocol/moduletype.h"

namespace nmc {

namespace {

constexpr unsigned kLastAddress = 0x7F;
constexpr unsigned kLastByte = 0xFF;

/// Address, type and version of one module: "2/0/4".
const QRegularExpression kEntry(QStringLiteral(R"(^(\d{1,3})/(\d{1,3})/(\d{1,3})$)"));

QString keyOf(const QString& port, const QString& what = QStringLiteral("chain/")) {
    return what + QString(port).replace(QLatin1Char('/'), QLatin1Char('_'));
}

QString rateKeyOf(const QString& port) {
    return keyOf(port, QStringLiteral("chainRate/"));
}

}  // namespace

std::vector<bus::ModuleInfo> knownChain(const QSettings& settings, const QString& port) {
    const QStringList entries =
        settings.value(keyOf(port)).toString().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (entries.size() > kMaxModules)
        return {};
    std::vector<bus::ModuleInfo> chain;
    std::set<unsigned> taken;
    for (const QString& entry : entries) {
        const QRegularExpressionMatch match = kEntry.match(entry);
        const unsigned address = match.captured(1).toUInt();
        const unsigned type = match.captured(2).toUInt();
        const unsigned version = match.captured(3).toUInt();
        if (!match.hasMatch() || address == 0 || address > kLastAddress || type > kLastByte ||
            version > kLastByte || !taken.insert(address).second)
            return {};
        const ModuleIndex index(static_cast<std::uint8_t>(chain.size()));
        chain.push_back({index,
                         BusAddress(static_cast<std::uint8_t>(address)),
                         {static_cast<ModuleType>(type), static_cast<std::uint8_t>(version)}});
    }
    return chain;
}

void rememberChain(QSettings& settings, const QString& port, const std::vector<bus::ModuleInfo>& chain) {
    QStringList entries;
    for (const bus::ModuleInfo& module : chain)
        entries << QStringLiteral("%1/%2/%3")
                       .arg(module.address.value())
                       .arg(static_cast<unsigned>(module.identity.type))
                       .arg(module.identity.version);
    settings.setValue(keyOf(port), entries.join(QLatin1Char(' ')));
}

std::uint32_t knownRate(const QSettings& settings, const QString& port) {
    const std::uint32_t baud = settings.value(rateKeyOf(port)).toUInt();
    return findBrd(baud) ? baud : 0;
}

void rememberRate(QSettings& settings, const QString& port, std::uint32_t baud) {
    if (findBaud(baud))
        settings.remove(rateKeyOf(port));
    else
        settings.setValue(rateKeyOf(port), baud);
}

}  // namespace nmc
