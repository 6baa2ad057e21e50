// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/motionkeeper.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <optional>
#include <utility>

#include "app/makingfolders.h"
#include "link/clock.h"
#include "link/guardian/guardreport.h"
#include "protocol/moduletype.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

using namespace std::chrono_literals;

constexpr qint64 kMaxMarkerBytes = 4'096;
/// A status latched this long after a command shows the effect of the command.
constexpr Duration kShows = 200ms;
/// A motor that another session left moving is detected within this time (ModuleState::attached).
constexpr Duration kLooked = 1'500ms;

/// The start time of a process in the kernel's ticks; empty: it is gone. A process ID may be reused, but not
/// with the same start time.
std::optional<QByteArray> startOf(qint64 process) {
    QFile stat(QStringLiteral("/proc/%1/stat").arg(process));
    if (!stat.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QByteArray text = stat.readAll();
    // The program name, in parentheses, may contain anything. It is followed by the state and 18 more fields.
    const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
    if (fields.size() < 20 || fields[0] == "Z")
        return std::nullopt;
    return fields[19];
}

const QRegularExpression kName(QStringLiteral(R"(^moving-(\d+)-(\d+)-(\d+)\.json$)"));

bool isOfALiveProcess(const QString& name) {
    const QRegularExpressionMatch match = kName.match(name);
    return startOf(match.captured(1).toLongLong()) == match.captured(2).toLatin1();
}

std::optional<MotionKeeper::Left> read(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QJsonObject json = QJsonDocument::fromJson(file.read(kMaxMarkerBytes)).object();
    MotionKeeper::Left left{path, json[QStringLiteral("port")].toString(),
                            static_cast<quint32>(json[QStringLiteral("baud")].toInt())};
    const QRegularExpressionMatch name = kName.match(QFileInfo(path).fileName());
    left.process = name.captured(1).toLongLong();
    left.connection = name.captured(3).toUInt();
    for (const QJsonValue& number : json[QStringLiteral("modules")].toArray())
        if (const int n = number.toInt(); n >= 1 && n <= kMaxModules)
            left.modules.insert(ModuleIndex(static_cast<std::uint8_t>(n - 1)));
    for (const QJsonValue& address : json[QStringLiteral("addresses")].toArray())
        left.addresses.push_back(address.toInt());
    return left.modules.empty() ? std::nullopt : std::optional(left);
}

ModuleIndex moduleAt(std::uint8_t address, const std::vector<int>& addresses) {
    const auto found = std::ranges::find(addresses, address);
    return ModuleIndex(
        static_cast<std::uint8_t>(found != addresses.end() ? found - addresses.begin() : address - 1));
}

/// A port may have several names.
bool isSamePort(const QString& a, const QString& b) {
    const QString target = QFileInfo(a).canonicalFilePath();
    return a == b || (!target.isEmpty() && target == QFileInfo(b).canonicalFilePath());
}

}  // namespace

MotionKeeper::MotionKeeper(QString folder, FileWriter::Disk disk, BusStore& store, Commander& commander,
                           MessageController& messages)
    : m_folder(std::move(folder)),
      m_files(makingFolders(std::move(disk))),
      m_store(store),
      m_messages(messages) {
    for (const QString& name : QDir(m_folder).entryList(QDir::Files, QDir::Name))
        if (kName.match(name).hasMatch() && !isOfALiveProcess(name))
            if (auto left = read(QDir(m_folder).filePath(name)))
                m_left.push_back(std::move(*left));
    connect(&store, &BusStore::linkChanged, this, &MotionKeeper::look);
    connect(&commander, &Commander::aboutToMove, this, &MotionKeeper::asked);
    connect(&commander, &Commander::aboutToHold, this, &MotionKeeper::held);
}

const MotionKeeper::Left* MotionKeeper::lastOf(qint64 process) const {
    const Left* last = nullptr;
    for (const Left& left : m_left)
        if (left.process == process && (last == nullptr || left.connection > last->connection))
            last = &left;
    return last;
}

void MotionKeeper::begin(const ConnectTarget& target, bool owns) {
    // Motors that the previous connection left moving are treated like those that another session left.
    if (!m_own.modules.empty())
        m_left.push_back(m_own);
    const qint64 process = QCoreApplication::applicationPid();
    const QString name = QStringLiteral("moving-%1-%2-%3.json")
                             .arg(process)
                             .arg(QString::fromLatin1(startOf(process).value_or("0")))
                             .arg(++m_connections);
    m_own = {QDir(m_folder).filePath(name), target.port, target.baud};
    m_owns = owns;
    m_pending.clear();
    m_askedAt.clear();
}

void MotionKeeper::take(const StoreEvent& event) {
    if (const auto* operation = std::get_if<bus::OperationFinished>(&event))
        ended(operation->id);
    else if (const auto* group = std::get_if<bus::GroupFinished>(&event))
        ended(group->id);
    else if (std::holds_alternative<bus::ChainFound>(event))
        m_foundAt = monotonicNow();
    else if (const auto* stop = std::get_if<bus::StopFinished>(&event))
        stopped(stop->stopped);
    else if (const auto* confirmed = std::get_if<bus::OwedStopConfirmed>(&event))
        stopped({confirmed->module});
}

void MotionKeeper::asked(bus::OperationId id, const std::vector<ModuleIndex>& modules) {
    m_pending[id] = modules;
    std::set<ModuleIndex> moving = m_own.modules;
    moving.insert(modules.begin(), modules.end());
    write(moving);
}

void MotionKeeper::ended(bus::OperationId id) {
    const auto pending = m_pending.find(id);
    if (pending == m_pending.end())
        return;
    for (const ModuleIndex module : pending->second)
        m_askedAt[module] = monotonicNow();
    m_pending.erase(pending);
}

void MotionKeeper::held(ModuleIndex module) {
    m_askedAt[module] = monotonicNow();
    std::set<ModuleIndex> moving = m_own.modules;
    moving.insert(module);
    write(moving);
}

bool MotionKeeper::moves(const ModuleState& module) const {
    const ModuleIndex index = module.info.index;
    for (const auto& [id, modules] : m_pending)
        if (std::ranges::find(modules, index) != modules.end())
            return true;
    const auto asked = m_askedAt.find(index);
    if (asked != m_askedAt.end() && module.latestTime < asked->second + kShows)
        return true;
    return module.stillMoves() || (module.silent && m_own.modules.count(index) != 0);
}

void MotionKeeper::look() {
    const LinkState& link = m_store.link();
    // Without modules nothing new is known: unplugging a port does not stop any motor.
    if (!m_owns || link.modules.empty())
        return;
    std::set<ModuleIndex> moving;
    for (const ModuleState& module : link.modules)
        if (moves(module))
            moving.insert(module.info.index);
    write(moving);
    for (Left& left : m_left)
        if (isSamePort(left.port, QString::fromStdString(link.port)))
            for (const ModuleState& module : link.modules)
                if (isLive(link, module) && !moves(module) && module.latestTime > m_foundAt + kLooked)
                    left.modules.erase(module.info.index);
    forgetOver();
}

/// Ends what is reported of modules that have all been seen at rest.
void MotionKeeper::forgetOver() {
    std::erase_if(m_left, [this](const Left& left) {
        const bool over = left.modules.empty();
        if (over) {
            m_files.remove(left.file);
            m_messages.end(texts::key::endedWhileMoving(left.file));
        }
        return over;
    });
}

void MotionKeeper::stopped(const std::vector<ModuleIndex>& modules) {
    std::set<ModuleIndex> moving = m_own.modules;
    for (const ModuleIndex module : modules) {
        moving.erase(module);
        m_askedAt.erase(module);
        for (Left& left : m_left)
            if (isSamePort(left.port, m_own.port))
                left.modules.erase(module);
    }
    write(moving);
    forgetOver();
}

void MotionKeeper::write(const std::set<ModuleIndex>& moving) {
    if (!m_owns || moving == m_own.modules)
        return;
    m_own.modules = moving;
    if (moving.empty()) {
        m_files.remove(m_own.file);
        return;
    }
    QJsonArray numbers;
    for (const ModuleIndex module : moving)
        numbers.append(module.value() + 1);
    QJsonArray addresses;
    for (const ModuleState& module : m_store.link().modules)
        addresses.append(module.info.address.value());
    const QJsonObject json{{QStringLiteral("port"), m_own.port},
                           {QStringLiteral("baud"), static_cast<qint64>(m_own.baud)},
                           {QStringLiteral("modules"), numbers},
                           {QStringLiteral("addresses"), addresses}};
    m_files.write(m_own.file,
                  [json] { return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString(); });
}

void MotionKeeper::reportSessionsBefore(const QString& guardFolder) {
    std::map<QString, std::vector<ModuleIndex>> stoppedByGuardian;
    for (const GuardReport& report : takeGuardReports(guardFolder.toStdString())) {
        const Left* left = lastOf(report.process);
        std::vector<ModuleIndex> modules;
        for (const std::uint8_t address : report.modules)
            modules.push_back(moduleAt(address, left != nullptr ? left->addresses : std::vector<int>{}));
        if (left != nullptr)
            stoppedByGuardian[left->file] = std::move(modules);
        else
            m_messages.report(texts::guardianStoppedBefore(modules));
    }
    for (const Left& left : m_left) {
        const auto stopped = stoppedByGuardian.find(left.file);
        m_messages.report(texts::endedWhileMoving(
            {left.modules.begin(), left.modules.end()}, left.port, left.file,
            stopped != stoppedByGuardian.end() ? std::optional(stopped->second) : std::nullopt));
    }
}

const MotionKeeper::Left* MotionKeeper::reportedBy(const QString& key) const {
    const auto found = std::ranges::find_if(
        m_left, [&key](const Left& left) { return texts::key::endedWhileMoving(left.file) == key; });
    return found != m_left.end() ? &*found : nullptr;
}

void MotionKeeper::lookedAt(const QString& key) {
    for (Left& left : m_left)
        if (texts::key::endedWhileMoving(left.file) == key)
            left.modules.clear();
    forgetOver();
}

}  // namespace nmc
