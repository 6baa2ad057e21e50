// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/positionkeeper.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

#include "app/makingfolders.h"
#include "model/machinefile/axisremoval.h"

namespace nmc {

namespace {

constexpr std::size_t kMaxPositionBytes = 16'384;
/// Delay between a change of position, for example of a shaft turned by hand, and storing it.
constexpr int kKeepPositionsAfterMs = 500;

QString fileOf(const QString& folder, const QString& port) {
    const QByteArray name =
        QCryptographicHash::hash(port.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
    return QDir(folder).filePath(QStringLiteral("positions-%1.json").arg(QLatin1String(name)));
}

/// A file that cannot be replaced is removed: home would be offered from where the axes were before. A full
/// disk does not prevent that.
FileWriter::Disk replacingOrRemoving(FileWriter::Disk disk) {
    return [disk = makingFolders(std::move(disk))](const QString& path, std::string_view content) {
        const FileWriter::Result result = disk(path, content);
        if (!result)
            QFile::remove(path);
        return result;
    };
}

bool startsMoving(const RememberedPositions& now, const RememberedPositions& kept) {
    return std::ranges::any_of(now, [&kept](const auto& axis) {
        const auto before = kept.find(axis.first);
        return axis.second.moving && (before == kept.end() || !before->second.moving);
    });
}

}  // namespace

PositionKeeper::PositionKeeper(QString folder, BusStore& store, FileWriter::Disk disk)
    : m_folder(std::move(folder)), m_store(store), m_files(replacingOrRemoving(std::move(disk))) {
    m_keepTimer.setSingleShot(true);
    m_keepTimer.setInterval(kKeepPositionsAfterMs);
    connect(&m_keepTimer, &QTimer::timeout, this, &PositionKeeper::keep);
    connect(&m_loading, &BackgroundJob::ended, this, &PositionKeeper::loaded);
    connect(&m_store, &BusStore::linkChanged, this, &PositionKeeper::look);
}

void PositionKeeper::begin(const QString& port, bool owns) {
    keep();
    m_loading.cancel();
    m_found.reset();
    const QString file = owns ? fileOf(m_folder, port) : QString();
    m_memory = {};
    // The positions that this session has stored may not be on disk yet. Otherwise, another session may have
    // stored newer ones there.
    if (file == m_file && m_loaded && (m_failed || m_files.isBusy(m_file)))
        return begin();
    m_file = file;
    m_kept = {};
    m_loaded = false;
    load();
}

/// Not before what is still to be written is in the file.
void PositionKeeper::load() {
    if (m_file.isEmpty() || m_loaded || m_loading.isBusy() || m_files.isBusy(m_file))
        return;
    m_read = std::make_shared<std::string>();
    m_loading.start([into = m_read, path = m_file](const BackgroundJob::Cancelled& /*cancelled*/) {
        if (auto text = readFile(path, kMaxPositionBytes))
            *into = std::move(*text);
    });
}

void PositionKeeper::begin() {
    if (!isOfAnother())
        m_memory.begin(m_kept.positions);
}

bool PositionKeeper::isOfAnother() const {
    return !m_machine.empty() && !m_kept.machine.empty() && m_machine != m_kept.machine;
}

void PositionKeeper::setMachine(const std::string& name) {
    m_machine = name;
    if (!isOfAnother())
        return;
    m_memory.begin({});  // a module that is silent now gets no offer when it answers
    // Each offer that is withdrawn is removed from m_offered.
    const std::vector<ModuleIndex> offered = m_offered;
    for (const ModuleIndex module : offered)
        m_store.dropHome(module);
}

void PositionKeeper::leaveOut(const std::vector<ModuleIndex>& modules) {
    const auto left = [modules](const RememberedPositions& all) {
        RememberedPositions kept;
        for (const auto& [module, position] : all)
            if (const auto index = indexWithout(modules, module))
                kept[*index] = position;
        return kept;
    };
    if (m_loaded) {
        m_memory.begin(left(m_memory.remembered()));
        return keep();
    }
    // What this session does not track, because it only looks on, is in the file alone.
    const QString file = fileOf(m_folder, QString::fromStdString(m_store.link().port));
    m_loading.cancel();  // its module numbers are those of before
    m_files.write(
        file,
        [file, left] {
            RememberedChain chain = readRemembered(readFile(file, kMaxPositionBytes).value_or(std::string()));
            chain.positions = left(chain.positions);
            return writeRemembered(chain);
        },
        [this](const FileWriter::Result& result) { written(result); });
}

void PositionKeeper::loaded() {
    m_kept = readRemembered(*m_read);
    m_loaded = true;
    begin();
    if (m_found)
        m_memory.found(m_found->modules, m_found->attached);
    look();
}

void PositionKeeper::take(const StoreEvent& event) {
    if (const auto* chain = std::get_if<bus::ChainFound>(&event))
        found(*chain);
    else if (const auto* readdressed = std::get_if<bus::Readdressed>(&event))
        m_memory.restarted(readdressed->module.index);
    else if (std::holds_alternative<bus::StopFinished>(event))
        look();  // the port may be closed at once, after which nothing is known any more
}

void PositionKeeper::found(const bus::ChainFound& found) {
    if (m_loaded)
        m_memory.found(found.modules, found.attached);
    else
        m_found = found;
}

void PositionKeeper::look() {
    // Changing the store also triggers this function.
    if (m_file.isEmpty() || !m_loaded || m_looking)
        return;
    const QScopedValueRollback<bool> looking(m_looking, true);
    const auto offers = m_memory.look(m_store.link(), QDateTime::currentSecsSinceEpoch());
    for (const PositionMemory::Offer& offer : offers) {
        m_offered.push_back(offer.module);
        m_store.offerHome(offer.module, offer.home);
        emit offered(offer);
    }
    std::erase_if(m_offered, [this](ModuleIndex module) {
        const ModuleState* state = m_store.module(module);
        const bool gone = state == nullptr || !state->home.offered();
        if (gone)
            emit over(module);
        return gone;
    });
    if (startsMoving(m_memory.remembered(), m_kept.positions))
        keep();
    else if ((m_failed || toKeep() != m_kept) && !m_keepTimer.isActive())
        m_keepTimer.start();
}

RememberedChain PositionKeeper::toKeep() const {
    return {m_machine.empty() ? m_kept.machine : m_machine, m_memory.remembered()};
}

void PositionKeeper::keep() {
    m_keepTimer.stop();
    if (m_file.isEmpty() || !m_loaded || (!m_failed && toKeep() == m_kept))
        return;
    m_kept = toKeep();
    m_files.write(
        m_file, [chain = m_kept] { return writeRemembered(chain); },
        [this](const FileWriter::Result& result) { written(result); });
}

void PositionKeeper::written(const FileWriter::Result& result) {
    if (!std::exchange(m_failed, !result) && !result)
        emit failed(result.error());
    load();
}

}  // namespace nmc
