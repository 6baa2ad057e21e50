// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recordingcontroller.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "link/clock.h"
#include "widgets/common/dates.h"
#include "widgets/common/requests.h"
#include "widgets/common/texts.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {

namespace {

constexpr int kClockMs = 500;

}  // namespace

RecordingController::RecordingController(MainWindow& window, const BusStore& store, FileWriter::Disk disk)
    : m_window(window), m_store(store), m_files(std::move(disk)) {
    ScopeFiles& files = window.scopeFiles();
    connect(&files, &ScopeFiles::recordRequested, this, &RecordingController::start);
    connect(&files, &ScopeFiles::recordingEndRequested, this, &RecordingController::end);
    connect(&window.requests(), &Requests::save, this, &RecordingController::save);
    connect(&files, &ScopeFiles::openRequested, this, [this](const QString& path) { load(path, false); });
    connect(&files, &ScopeFiles::underRequested, this, [this](const QString& path) { load(path, true); });
    connect(&files, &ScopeFiles::openingCancelled, this, [this, &files] {
        m_loader.cancel();
        files.showOpening({});
    });
    connect(&m_loader, &RecordingLoader::progressed, this, [this, &files](double share) {
        files.showOpening(ScopeFiles::Opening{m_loader.path(), share});
    });
    connect(&m_loader, &RecordingLoader::loaded, this, &RecordingController::loaded);
    connect(&m_loader, &RecordingLoader::failed, this, [this, &files](const FileError& error) {
        files.showOpening({});
        m_window.showMessage(texts::recordingNotOpened(error));
    });

    connect(&store, &BusStore::linkChanged, this, &RecordingController::look);
    connect(&m_writer, &RecordingWriter::failed, this, &RecordingController::failed);
    connect(&m_writer, &RecordingWriter::finished, this, [this](qint64 /*bytes*/, double seconds) {
        showRecording();
        m_window.showMessage(texts::recordingEnded(m_writer.path(), seconds));
        startNext();
    });
    m_clock.setInterval(kClockMs);
    connect(&m_clock, &QTimer::timeout, this, &RecordingController::showRecording);
    showRecording();
}

// ---- recording ----

void RecordingController::start(const QString& path) {
    if (m_writer.isRecording())
        return;
    // The chain may have gone while the file was chosen.
    if (m_store.link().modules.empty()) {
        m_window.showMessage(texts::recordingNotBegun(path));
        return;
    }
    if (m_writer.isBusy()) {
        m_next = path;
        return;
    }
    m_window.endMessage(texts::key::kRecording);
    m_writer.start(path);
    m_bytes = 0;
    m_started = monotonicNow();
    m_zero = m_store.history().zero().value_or(m_started);
    writeHead();
    m_clock.start();
    showRecording();
}

void RecordingController::startNext() {
    if (const QString next = std::exchange(m_next, {}); !next.isEmpty())
        start(next);
}

void RecordingController::writeHead() {
    const LinkState& link = m_store.link();
    const History& history = m_store.history();
    std::string text =
        recordingHead(recordingHeader(m_window.scopeModules(), QString::fromStdString(link.port),
                                      link.simulated, m_zero, dateOf(m_zero, m_started)));
    const History present = history.cut(m_started, m_started);
    for (const GainsChange& change : present.gains())
        appendGains(text, change, m_zero);
    write(std::move(text));
    m_historyZero = history.zero();
    m_gainsWritten = history.gains().size();
    m_written.clear();
    for (std::size_t i = 0; i < history.modules(); ++i)
        m_written.push_back(history.module(ModuleIndex(static_cast<std::uint8_t>(i)))->count());
}

void RecordingController::look() {
    m_window.scopeFiles().showConnected(!m_store.link().modules.empty());
    if (!m_writer.isRecording())
        return;
    if (isOfThisChain())
        writeNews();
    else
        end();
}

bool RecordingController::isOfThisChain() {
    const History& history = m_store.history();
    if (!m_historyZero)
        m_historyZero = history.zero();
    return history.zero() == m_historyZero && history.modules() == m_written.size();
}

void RecordingController::writeNews() {
    const History& history = m_store.history();
    std::string text;
    for (; m_gainsWritten < history.gains().size(); ++m_gainsWritten)
        appendGains(text, history.gains()[m_gainsWritten], m_zero);
    std::vector<std::pair<ModuleIndex, ScopeSample>> samples;
    for (std::size_t i = 0; i < m_written.size(); ++i) {
        const ModuleIndex module(static_cast<std::uint8_t>(i));
        history.module(module)->visitSince(
            m_written[i], [&](const ScopeSample& sample) { samples.emplace_back(module, sample); });
        m_written[i] = history.module(module)->count();
    }
    std::stable_sort(samples.begin(), samples.end(),
                     [](const auto& a, const auto& b) { return a.second.time < b.second.time; });
    for (const auto& [module, sample] : samples)
        appendRow(text, module, sample, m_zero);
    write(std::move(text));
}

void RecordingController::note(const QString& text) {
    if (!m_writer.isRecording())
        return;
    std::string line;
    appendNote(line, text.toStdString(), monotonicNow(), m_zero);
    write(std::move(line));
}

void RecordingController::write(std::string text) {
    m_bytes += static_cast<qint64>(text.size());
    m_writer.append(std::move(text));
}

void RecordingController::take(const StoreEvent& event) {
    if (std::holds_alternative<PortClosed>(event))
        end();
}

void RecordingController::end() {
    if (m_writer.isRecording() && isOfThisChain())
        writeNews();
    m_writer.stop();
    showRecording();
}

void RecordingController::showRecording() {
    if (m_writer.isRecording())
        return m_window.scopeFiles().showRecording(
            ScopeFiles::Recording{m_writer.path(), toSeconds(monotonicNow() - m_started), m_bytes});
    m_clock.stop();
    m_window.scopeFiles().showRecording({});
}

void RecordingController::failed(const RecordingFailure& failure) {
    const Message message = texts::recordingFailed(m_writer.path(), failure);
    startNext();
    showRecording();
    m_window.showMessage(message);
}

// ---- files ----

void RecordingController::load(const QString& path, bool under) {
    m_under = under;
    m_loader.start(path);
}

void RecordingController::loaded(std::shared_ptr<LoadedRecording> recording) {
    m_window.scopeFiles().showOpening({});
    if (recording->problem)
        m_window.showMessage(texts::recordingCut(recording->path, *recording->problem, recording->samples));
    else if (recording->samples == 0)
        m_window.showMessage(texts::recordingWithoutSamples(recording->path));
    else
        m_window.endMessage(texts::key::kOpenedRecording);
    if (recording->samples == 0)
        return;
    auto record = std::make_shared<const ScopeRecord>(
        recordOf(QFileInfo(recording->path).fileName(), recording->header, std::move(recording->history)));
    if (m_under)
        m_window.showUnder(std::move(record));
    else
        m_window.showRecord(std::move(record));
}

void RecordingController::save(const QString& path, const FileWriter::Content& content) {
    m_files.write(path, content, [this, path](const FileWriter::Result& result) {
        if (result)
            m_window.endMessage(texts::key::kNotExported);
        m_window.showMessage(result ? texts::exported(path) : texts::notExported(result.error()));
    });
}

}  // namespace nmc
