// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/packetmonitor.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QTabWidget>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/monitor/countertable.h"
#include "widgets/monitor/packetmodel.h"
#include "widgets/monitor/packetsaving.h"
#include "widgets/monitor/packetview.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// The item data of "Errors only" in the kind box; other kinds are a PacketKind.
constexpr int kErrorsOnly = 100;
}  // namespace

PacketMonitor::PacketMonitor(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_model(new PacketModel(this)),
      m_view(new PacketView(*m_model, this)),
      m_counters(new CounterTable(this)),
      m_module(form::newChoice(
          {u"packetModuleBox"_s, tr("Filter packets by module"), {{Common::tr("All modules"), {}}}}, this)),
      m_kind(form::newChoice(
          {u"packetKindBox"_s, tr("Filter packets by kind"), {{Common::tr("All kinds"), -1}}}, this)),
      m_summary(look::newMutedLabel({}, this, u"packetSummary"_s)) {
    look::name(this, u"packetMonitor"_s, tr("Packet monitor"));
    buildControls();
    buildContent();
    connect(m_module, &QComboBox::currentIndexChanged, this, &PacketMonitor::applyFilter);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &PacketMonitor::applyFilter);
    connect(m_pause, &QPushButton::toggled, this, &PacketMonitor::pause);
    connect(m_clear, &QPushButton::clicked, this, [this] {
        m_model->clear();
        showSummary();
    });
    connect(m_copy, &QPushButton::clicked, this, &PacketMonitor::copy);
    connect(m_view, &PacketView::copyRequested, this, &PacketMonitor::copy);
    connect(m_save, &QPushButton::clicked, this, &PacketMonitor::chooseFile);
    showSummary();
}

QPushButton* PacketMonitor::newButton(const QString& objectName, const QString& text, const QString& toolTip,
                                      const QKeySequence& shortcut) {
    auto* button =
        form::newPush({objectName, text, {}, toolTip.arg(shortcut.toString(QKeySequence::NativeText))}, this);
    button->setShortcut(shortcut);
    return button;
}

void PacketMonitor::buildControls() {
    m_module->setToolTip(tr("Shows only packets of one module (Ctrl+M)."));
    m_module->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_kind->setToolTip(tr("Shows only packets of one kind (Ctrl+T)."));
    m_kind->addItem(tr("Polls"), static_cast<int>(PacketKind::Poll));
    m_kind->addItem(Common::tr("Commands"), static_cast<int>(PacketKind::Command));
    m_kind->addItem(tr("Stops"), static_cast<int>(PacketKind::Stop));
    m_kind->addItem(tr("Connecting and link"), static_cast<int>(PacketKind::Link));
    m_kind->addItem(tr("Errors only"), kErrorsOnly);
    m_pause = newButton(u"packetPause"_s, Common::tr("Pause"),
                        tr("Stops recording; packets shown stay (%1)."), Qt::CTRL | Qt::SHIFT | Qt::Key_P);
    m_pause->setCheckable(true);
    m_clear = newButton(u"packetClear"_s, tr("Clear"), tr("Clears the packets shown (%1)."),
                        Qt::CTRL | Qt::SHIFT | Qt::Key_K);
    m_copy = newButton(u"packetCopy"_s, tr("Copy"),
                       tr("Copies the selected rows as text, or all rows if none is selected (%1)."),
                       Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    m_save = newButton(u"packetSave"_s, Common::tr("Save as…"),
                       tr("Saves all recorded packets as text, or as a log that can be replayed (%1)."),
                       Qt::CTRL | Qt::Key_E);
    for (auto& [key, box] : {std::pair{Qt::Key_M, m_module}, std::pair{Qt::Key_T, m_kind}})
        connect(new QShortcut(QKeySequence(Qt::CTRL | key), this), &QShortcut::activated, box,
                [box = box] { box->setFocus(Qt::ShortcutFocusReason); });
}

void PacketMonitor::buildContent() {
    const int unit = look::gridUnit(this);
    auto* controls = new FlowLayout(unit / 2, {m_module, m_kind, m_pause, m_clear, m_copy, m_save});
    controls->setContentsMargins(unit / 2, unit / 3, unit / 2, unit / 3);
    auto* packets = new QWidget(this);
    form::fill(packets, form::newColumn(packets, {controls, {m_view, 1}}, 0));
    auto* tabs = new QTabWidget(this);
    look::name(tabs, u"monitorTabs"_s, tr("Packets and counters"));
    tabs->setDocumentMode(true);
    tabs->addTab(packets, tr("Packets"));
    tabs->addTab(m_counters, tr("Counters"));
    m_summary->setMargin(unit / 3);
    tabs->setCornerWidget(m_summary);
    form::fill(this, form::newColumn(this, {tabs}));
}

void PacketMonitor::begin(const PacketSession& session) {
    m_model->begin(session);
    m_counters->showStatistics({});
    showSummary();
}

void PacketMonitor::showPackets(std::vector<bus::ExchangeRecord> records) {
    if (records.empty())
        return;
    m_view->append(std::move(records));
    showSummary();
}

const PacketLog& PacketMonitor::log() const {
    return m_model->log();
}

void PacketMonitor::setSeen(bool seen) {
    m_seen = seen;
    updateRecording();
}

void PacketMonitor::offerModules(int count) {
    form::offerModules(m_module, 1, count);
}

void PacketMonitor::showFigures(const LinkFigures& figures) {
    m_counters->showStatistics(figures.counters);
}

void PacketMonitor::applyFilter() {
    PacketFilter filter;
    if (m_module->currentIndex() > 0)
        filter.module = ModuleIndex(static_cast<std::uint8_t>(m_module->currentIndex() - 1));
    const int kind = m_kind->currentData().toInt();
    filter.onlyErrors = kind == kErrorsOnly;
    if (kind >= 0 && kind != kErrorsOnly)
        filter.kind = static_cast<PacketKind>(kind);
    m_model->setFilter(filter);
    m_view->scrollToBottom();
    showSummary();
}

void PacketMonitor::pause(bool paused) {
    m_pause->setText(paused ? tr("Resume") : Common::tr("Pause"));
    m_pause->setAccessibleName(m_pause->text());
    m_pause->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_P);  // a new text removes the shortcut
    updateRecording();
    showSummary();
}

void PacketMonitor::updateRecording() {
    const bool recording = m_seen && !m_pause->isChecked();
    if (recording == m_recording)
        return;
    m_recording = recording;
    if (recording)
        m_model->interrupt();
    emit recordingChanged(recording);
}

void PacketMonitor::copy() {
    const QString text = m_view->selectedText();
    if (!text.isEmpty())
        QGuiApplication::clipboard()->setText(text);
}

void PacketMonitor::chooseFile() {
    askWhereToSave(
        this,
        {.objectName = u"packetSaveDialog"_s,
         .title = tr("Save packets"),
         .filters = {Common::tr("Text (*.txt)"), tr("Replayable log (*%1)").arg(kPacketLogSuffix)},
         .proposed = u"packets"_s},
        [this](const QString& path) { emit m_requests.save(path, packetFile(m_model->log(), path)); });
}

void PacketMonitor::showSummary() {
    const PacketLog& log = m_model->log();
    QString text =
        tr("%1 of %2 shown")
            .arg(texts::grouped(m_model->rowCount()), texts::grouped(static_cast<qint64>(log.size())));
    if (log.dropped() > 0)
        text = tr("%1, %2 older dropped").arg(text, texts::grouped(static_cast<qint64>(log.dropped())));
    if (m_pause->isChecked())
        text = tr("%1, paused").arg(text);
    look::setText(m_summary, text);
}

}  // namespace nmc
