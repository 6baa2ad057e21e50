// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runkeeper.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "model/machinefile/axisremoval.h"
#include "widgets/common/requests.h"
#include "widgets/common/texts.h"
#include "widgets/response/responsedock.h"

namespace nmc {

namespace {

const QString kSuffix = QLatin1Char('.') + QLatin1String(kRunFileSuffix.data(), kRunFileSuffix.size());

/// Runs in another thread, like the functions below.
[[nodiscard]] std::vector<KeptResponse> runsIn(const QString& path) {
    const auto text = readFile(path, kMaxRunFile);
    auto runs = text ? readResponses(*text) : tl::unexpected(FileProblem{});
    return runs ? std::move(*runs) : std::vector<KeptResponse>{};
}

[[nodiscard]] bool mayBeReplaced(const QString& path) {
    const auto text = readFile(path, kMaxRunFile);
    return text ? readResponses(*text).has_value() : text.error().trouble == FileErrorKind::NotThere;
}

[[nodiscard]] bool setAside(const QString& path) {
    for (int number = 1; number < 100; ++number)
        if (QFile::rename(path, path + QStringLiteral(".unread-%1").arg(number)))
            return true;
    return false;
}

FileWriter::Disk sparing(FileWriter::Disk disk) {
    return [disk = std::move(disk)](const QString& path, std::string_view content) -> FileWriter::Result {
        QDir().mkpath(QFileInfo(path).path());
        if (!mayBeReplaced(path) && !setAside(path))
            return tl::unexpected(FileError{FileErrorKind::NoPermission, path});
        return disk(path, content);
    };
}

/// Finds the axis by the name it had then, even if its place in the chain has changed.
[[nodiscard]] ModuleIndex moduleOf(const KeptResponse& run, const Machine& machine) {
    const auto isIt = [&run](const AxisSettings& axis) { return axis.name == run.axisName; };
    if (run.axisName.empty() || std::ranges::count_if(machine.axes, isIt) != 1)
        return run.run.module;
    const auto axis = std::ranges::find_if(machine.axes, isIt);
    return ModuleIndex(static_cast<std::uint8_t>(axis - machine.axes.begin()));
}

}  // namespace

RunKeeper::RunKeeper(QString folder, MainWindow& window, FileWriter::Disk disk)
    : m_folder(std::move(folder)), m_window(window), m_files(sparing(std::move(disk))) {
    connect(&window.requests(), &Requests::storeRuns, this, &RunKeeper::keep);
    connect(&m_loading, &BackgroundJob::ended, this, &RunKeeper::loaded);
}

QString RunKeeper::pathFor(const QString& machineFile) const {
    const QFileInfo info(machineFile);
    return machineFile.isEmpty() ? QDir(m_folder).filePath(QStringLiteral("no-machine-file") + kSuffix)
                                 : info.absoluteDir().filePath(info.completeBaseName() + kSuffix);
}

void RunKeeper::open(const QString& file, const Machine& machine) {
    m_loading.cancel();
    m_path = pathFor(file);
    m_known.clear();
    m_window.stepResponses().clearRuns();
    m_reading = std::make_shared<Reading>(Reading{m_path, machine, {}, {}, {}});
    load();
}

/// Not before what is still to be written is in the file.
void RunKeeper::load() {
    if (!m_reading || m_loading.isBusy() || m_files.isBusy(m_reading->path))
        return;
    m_loading.start([into = m_reading](const BackgroundJob::Cancelled& /*cancelled*/) {
        const auto text = readFile(into->path, kMaxRunFile);
        if (!text) {
            if (text.error().trouble != FileErrorKind::NotThere)
                into->error = text.error();
        } else if (auto runs = readResponses(*text)) {
            into->runs = std::move(*runs);
        } else {
            into->problem = runs.error();
        }
    });
}

void RunKeeper::loaded() {
    const std::shared_ptr<Reading> read = std::exchange(m_reading, nullptr);
    if (read->problem)
        m_window.showMessage(texts::runsNotRead(read->path, *read->problem));
    else if (read->error)
        m_window.showMessage(texts::runsNotRead(*read->error));
    else
        m_window.endMessage(texts::key::kRuns);
    std::vector<KeptResponse> runs;
    for (KeptResponse& run : read->runs) {
        std::optional<ModuleIndex> module = moduleOf(run, read->machine);
        for (const std::vector<ModuleIndex>& modules : read->leftOut)
            module = module ? indexWithout(modules, *module) : std::nullopt;
        // The id is that of the run as it is in the file; what this session has written is already listed.
        if (!module || !m_known.insert(idOf(run)).second)
            continue;
        run.run.module = *module;
        runs.push_back(std::move(run));
    }
    if (runs.empty())
        return;
    m_window.stepResponses().showKept(std::move(runs));
    if (!read->leftOut.empty())
        keep();            // with the new numbers
    moveFrom(read->path);  // the machine may have got another file meanwhile
}

void RunKeeper::follow(const QString& file) {
    moveFrom(std::exchange(m_path, pathFor(file)));
}

void RunKeeper::moveFrom(const QString& before) {
    if (before == m_path)
        return;
    keep();
    // Runs in the data folder belong to a machine without a file, which this one no longer is.
    if (before == pathFor({}))
        m_files.write(
            before, [before, gone = m_known] { return writeResponses(together({}, runsIn(before), gone)); },
            [this](const FileWriter::Result& /*result*/) { load(); });
}

void RunKeeper::leaveOut(const std::vector<ModuleIndex>& modules) {
    if (m_reading)
        m_reading->leftOut.push_back(modules);
    std::vector<KeptResponse> left;
    for (KeptResponse& run : m_window.stepResponses().runs())
        if (const auto index = indexWithout(modules, run.run.module)) {
            run.run.module = *index;
            left.push_back(std::move(run));
        } else {
            m_known.erase(idOf(run));
        }
    m_window.stepResponses().clearRuns();
    m_window.stepResponses().showKept(std::move(left));
    if (!m_window.stepResponses().runs().empty())
        keep();
}

void RunKeeper::keep() {
    std::vector<KeptResponse> runs = m_window.stepResponses().runs();
    std::set<std::string> gone = m_known;
    for (const KeptResponse& run : runs) {
        m_known.insert(idOf(run));
        gone.erase(idOf(run));
    }
    m_files.write(
        m_path,
        [path = m_path, runs = std::move(runs), gone] {
            return writeResponses(together(runs, runsIn(path), gone));
        },
        [this](const FileWriter::Result& result) { onWritten(result); });
}

void RunKeeper::onWritten(const FileWriter::Result& result) {
    if (result)
        m_window.endMessage(texts::key::kRunsNotKept);
    else if (!m_failed)
        m_window.showMessage(texts::runsNotKept(result.error()));
    m_failed = !result;
    load();
}

}  // namespace nmc
