// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/problemreport.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QGuiApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QStringList>
#include <QSysInfo>

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QStringList aboutProgram() {
    QStringList lines{
        u"NMC Panel %1, Qt %2"_s.arg(QCoreApplication::applicationVersion(), QLatin1StringView(qVersion())),
        u"%1, %2 %3, %4"_s.arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(),
                               QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture()),
        u"Window system %1, locale %2, system's locale %3"_s.arg(QGuiApplication::platformName(),
                                                                 QLocale().name(), QLocale::system().name())};
    for (const QScreen* screen : QGuiApplication::screens())
        lines << u"Screen %1x%2, scale %3"_s.arg(screen->size().width())
                     .arg(screen->size().height())
                     .arg(screen->devicePixelRatio());
    return lines;
}

QString phaseName(LinkPhase phase) {
    switch (phase) {
        case LinkPhase::Disconnected:
            return u"disconnected"_s;
        case LinkPhase::Connecting:
            return u"connecting"_s;
        case LinkPhase::Connected:
            return u"connected"_s;
        case LinkPhase::Lost:
            return u"link lost"_s;
    }
    return {};
}

QString adapterLine(const PortEntry& port) {
    const QString usb =
        port.vendor == 0
            ? QString()
            : u", USB %1:%2"_s.arg(port.vendor, 4, 16, QChar(u'0')).arg(port.product, 4, 16, QChar(u'0'));
    return u"Port %1: %2%3"_s.arg(port.name, port.description.isEmpty() ? u"-"_s : port.description, usb);
}

QStringList aboutPort(const ProblemFacts& facts) {
    const LinkState& link = facts.link;
    QStringList lines;
    for (const PortEntry& port : facts.ports)
        lines << adapterLine(port);
    const QString port = link.port.empty() ? u"no port yet"_s : QString::fromStdString(link.port);
    lines << u"Connection %1: %2, %3 Bd, %4%5%6"_s.arg(
                 QString::number(link.connection), port, QString::number(link.baud), phaseName(link.phase),
                 link.simulated ? u", simulated"_s : QString(), link.readOnly ? u", read-only"_s : QString())
          << u"%1 exchanges/s, %2 errors, mean round trip %3 ms"_s.arg(facts.figures.exchangesPerSecond)
                 .arg(facts.figures.errors)
                 .arg(facts.figures.meanRoundTripMs);
    return lines;
}

QString typeName(ModuleType type) {
    const std::string_view name = familyName(type);
    return name.empty() ? u"type %1"_s.arg(static_cast<int>(type)) : QString::fromUtf8(name);
}

QString gainsOf(const servo::SetGain& gains) {
    return u"Kp %1, Kd %2, Ki %3, IL %4, OL %5, CL %6, EL %7, SR %8, DB %9"_s.arg(gains.kp)
        .arg(gains.kd)
        .arg(gains.ki)
        .arg(gains.il)
        .arg(gains.ol)
        .arg(gains.cl)
        .arg(gains.el)
        .arg(gains.sr)
        .arg(gains.db ? QString::number(*gains.db) : u"-"_s);
}

QStringList aboutChain(const LinkState& link) {
    QStringList lines;
    for (const ModuleState& module : link.modules) {
        QStringList words{u"Module %1: %2, version %3, address %4"_s.arg(module.info.index.value() + 1)
                              .arg(typeName(module.info.identity.type))
                              .arg(module.info.identity.version)
                              .arg(module.info.address.value())};
        if (module.latest)
            words << u"status %1"_s.arg(module.latest->status, 2, 16, QChar(u'0'));
        if (module.latest && module.latest->position)
            words << u"position %1"_s.arg(*module.latest->position);
        if (module.silent)
            words << (module.notAsked ? u"not asked"_s : u"does not answer"_s);
        if (module.hasRestarted)
            words << u"has restarted"_s;
        if (module.isServo())
            words << (module.gains ? gainsOf(*module.gains) : u"gains unknown"_s);
        lines << words.join(u", ");
    }
    return lines;
}

/// Raw bytes, such as the geometry of a window, mean nothing to a reader.
QString settingText(const QVariant& value) {
    if (value.typeId() == QMetaType::QByteArray)
        return u"(%1 bytes)"_s.arg(value.toByteArray().size());
    return value.typeId() == QMetaType::QStringList ? value.toStringList().join(u", ") : value.toString();
}

QStringList aboutSettings(const QSettings& settings) {
    QStringList lines;
    for (const QString& key : settings.allKeys()) {
        const bool secret = key == u"operator/pin" || key == u"operator/salt";
        lines << key + u" = "_s + (secret ? u"(left out)"_s : settingText(settings.value(key)));
    }
    return lines;
}

QString reportSection(const QString& title, const QString& text, const QString& otherwise) {
    return u"\n== %1 ==\n%2\n"_s.arg(title, text.isEmpty() ? otherwise : text.trimmed());
}

}  // namespace

QString withoutHomes(QString text) {
    static const QRegularExpression anybodys(u"/home/[^/\\s\"',;:]+"_s);
    const QString own = QDir::homePath();
    if (own.size() > 1)
        text.replace(QRegularExpression(QRegularExpression::escape(own) + u"(?![\\w-])"_s), u"~"_s);
    return text.replace(anybodys, u"~"_s);
}

QString problemReport(const ProblemFacts& facts) {
    const QString none = u"none"_s;
    const QString made = QDateTime::currentDateTime().toString(Qt::ISODate);
    return withoutHomes(
        u"Report of a problem with NMC Panel, %1\n\nWhat I did, what happened, what I expected:\n\n"_s.arg(
            made) +
        reportSection(u"Program and system"_s, aboutProgram().join(u'\n'), none) +
        reportSection(u"Port and adapter"_s, aboutPort(facts).join(u'\n'), none) +
        reportSection(u"Chain"_s, aboutChain(facts.link).join(u'\n'), u"no module"_s) +
        reportSection(u"Messages"_s, facts.messages, none) +
        reportSection(u"Settings"_s, aboutSettings(facts.settings).join(u'\n'), none) +
        reportSection(
            u"Packets"_s, facts.packets,
            u"None were recorded: the packet monitor was closed. Open it, do it again, report then."_s));
}

}  // namespace nmc
