// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/motionkeeper.h"

#include <algorithm>
#include <map>
#include <optional>

#include "link/clock.h"
#include "link/guardian/guardreport.h"
#include "widgets/common/texts.h"

namespace nmc {

MotionKeeper::MotionKeeper(const QString& folder, const FileWriter::Disk& disk, BusStore& store,
                           Commander& commander, MessageController& messages, QObject* parent)
    : QObject(parent), m_marker(folder, disk), m_store(store), m_messages(messages) {
    connect(&store, &BusStore::linkChanged, this, [this] { endMessages(m_marker.update(m_store.link())); });
    connect(&commander, &Commander::aboutToMove, this,
            [this](bus::OperationId id, const std::vector<ModuleIndex>& modules) {
                m_marker.asked(id, modules);
            });
    connect(&commander, &Commander::aboutToHold, this,
            [this](ModuleIndex module) { m_marker.held(module, monotonicNow()); });
}

void MotionKeeper::begin(const ConnectTarget& target, bool owns) {
    m_marker.begin(target.port, target.baud, owns);
}

void MotionKeeper::take(const StoreEvent& event) {
    if (const auto* operation = std::get_if<bus::OperationFinished>(&event))
        m_marker.ended(operation->id, monotonicNow());
    else if (const auto* group = std::get_if<bus::GroupFinished>(&event))
        m_marker.ended(group->id, monotonicNow());
    else if (std::holds_alternative<bus::ChainFound>(event))
        m_marker.found(monotonicNow());
    else if (const auto* stop = std::get_if<bus::StopFinished>(&event))
        endMessages(m_marker.stopped(stop->stopped));
    else if (const auto* confirmed = std::get_if<bus::OwedStopConfirmed>(&event))
        endMessages(m_marker.stopped({confirmed->module}));
}

void MotionKeeper::endMessages(const QStringList& files) {
    for (const QString& file : files)
        m_messages.end(texts::key::endedWhileMoving(file));
}

void MotionKeeper::reportSessionsBefore(const QString& guardFolder) {
    std::map<QString, std::vector<ModuleIndex>> stoppedByGuardian;
    for (const GuardReport& report : takeGuardReports(guardFolder.toStdString())) {
        std::vector<ModuleIndex> modules;
        for (const std::uint8_t address : report.modules)
            modules.emplace_back(static_cast<std::uint8_t>(address - 1));
        if (const MotionMarker::Left* left = m_marker.lastOf(report.process))
            stoppedByGuardian[left->file] = std::move(modules);
        else
            m_messages.report(texts::guardianStoppedBefore(modules));
    }
    for (const MotionMarker::Left& left : m_marker.left()) {
        const auto stopped = stoppedByGuardian.find(left.file);
        m_messages.report(texts::endedWhileMoving(
            {left.modules.begin(), left.modules.end()}, left.port, left.file,
            stopped != stoppedByGuardian.end() ? std::optional(stopped->second) : std::nullopt));
    }
}

const MotionMarker::Left* MotionKeeper::reportedBy(const QString& key) const {
    const auto found = std::ranges::find_if(m_marker.left(), [&key](const MotionMarker::Left& left) {
        return texts::key::endedWhileMoving(left.file) == key;
    });
    return found != m_marker.left().end() ? &*found : nullptr;
}

void MotionKeeper::lookedAt(const QString& key) {
    if (const MotionMarker::Left* left = reportedBy(key))
        m_marker.forget(QString(left->file));
}

}  // namespace nmc
