// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/windowupdater.h"

#include "link/clock.h"
#include "widgets/monitor/monitordock.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/simulator/simulatordock.h"

namespace nmc {

namespace {

constexpr int kQuietFrameMs = 25;  ///< the plots' time goes on when nothing is reported
constexpr int kFiguresIntervalMs = 1'000;
constexpr int kReadableMs = 100;  ///< ten numbers a second can be followed by eye

}  // namespace

WindowUpdater::WindowUpdater(MainWindow& window, BusStore& store, BusWorker& worker, Commander& commander,
                             FlightController& flight)
    : m_window(window), m_store(store), m_worker(worker), m_commander(commander), m_flight(flight) {
    m_linkTimer.setSingleShot(true);
    connect(&m_linkTimer, &QTimer::timeout, this, &WindowUpdater::showLink);
    connect(&m_store, &BusStore::linkChanged, this, &WindowUpdater::showLinkSoon);
    m_frameTimer.setSingleShot(true);
    connect(&m_frameTimer, &QTimer::timeout, this, &WindowUpdater::showFrame);
    // Frames of a timer of their own would wake the thread once more for each report. The frame has a turn of
    // its own, so that a key is not kept waiting by both.
    connect(&m_store, &BusStore::linkChanged, this, [this] {
        if (m_frames)
            m_frameTimer.start(0);
    });
    connect(&m_window.scope(), &ScopePanel::frameWanted, this, &WindowUpdater::showFrameSoon);
    m_figuresTimer.setInterval(kFiguresIntervalMs);
    connect(&m_figuresTimer, &QTimer::timeout, this, &WindowUpdater::showFigures);
}

void WindowUpdater::begin() {
    m_frames = true;
    m_frameTimer.start(0);
    m_figuresTimer.start();
}

void WindowUpdater::catchUp() {
    if (m_linkTimer.isActive())
        showLink();
}

void WindowUpdater::take(const StoreEvent& event) {
    if (std::holds_alternative<bus::ChainFound>(event))
        m_watched.clear();  // the bus has forgotten it
    if (const auto* answer = std::get_if<SimulatorAnswered>(&event))
        m_window.simulator().showAnswer(QString::fromStdString(answer->line),
                                        QByteArray::fromStdString(answer->json));
    if (!std::holds_alternative<PortClosed>(event))
        return;
    m_window.monitor().showPackets(m_worker.takeRecords());
    m_flight.keepAll();
    m_frames = false;
    m_frameTimer.stop();
    // The last reported values continue to age.
    if (!m_store.link().unplugged)
        m_figuresTimer.stop();
    m_window.showFigures({});
}

/// Statuses arrive faster than numbers can be read, but changes of a module's activity and requests are shown
/// at once, because controls depend on them.
void WindowUpdater::showLinkSoon() {
    const qint64 since = m_linkShown.isValid() ? m_linkShown.elapsed() : kReadableMs;
    if (since >= kReadableMs || m_shown != Shown(m_store.link()))
        showLink();
    else if (!m_linkTimer.isActive())
        m_linkTimer.start(kReadableMs - static_cast<int>(since));
}

void WindowUpdater::showLink() {
    m_linkTimer.stop();
    m_linkShown.start();
    m_shown = Shown(m_store.link());
    m_window.showLink(m_store.link());
}

WindowUpdater::Shown::Shown(const LinkState& link)
    : phase(link.phase), connection(link.connection), lent(link.lent) {
    for (const ModuleState& module : link.modules)
        modules.push_back({module.activity(), module.awaited, module.gains});
}

void WindowUpdater::showFrame() {
    m_window.monitor().showPackets(m_worker.takeRecords());
    std::set<ModuleIndex> watched = m_window.watchedModules();
    for (const ModuleIndex module : m_commander.sequences().parts())
        watched.insert(module);  // its arrival is awaited
    if (watched != m_watched) {
        m_watched = watched;
        m_worker.watch({watched.begin(), watched.end()});
    }
    // When no more data arrives, time stops where the data ended.
    const History& history = m_store.history();
    const TimePoint now = m_worker.isOpen() ? monotonicNow() : history.end().value_or(TimePoint{});
    m_flight.keep(now);
    // A newer frame would only be computed twice for the strips that still wait to be painted.
    if (!m_frames || !m_window.scope().isPainting())
        m_window.showHistory(history, now);
    if (m_frames)
        m_frameTimer.start(kQuietFrameMs);
}

void WindowUpdater::showFrameSoon() {
    if (!m_frames)
        QTimer::singleShot(0, this, &WindowUpdater::showFrame);
}

void WindowUpdater::showFigures() {
    if (!m_worker.isOpen())
        return m_window.showTime(monotonicNow());
    const LinkFigures figures = m_store.pullFigures(monotonicNow());
    m_window.showFigures(figures);
    // Those of a program that has the line say nothing about the adapter.
    if (m_store.link().phase == LinkPhase::Connected && !m_store.link().lent)
        emit ratesMeasured(figures);
}

}  // namespace nmc
