// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopepanel.h"

#include <QBoxLayout>
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/cursorpanel.h"
#include "widgets/scope/scopebar.h"
#include "widgets/scope/scopefiles.h"
#include "widgets/scope/scopemoves.h"
#include "widgets/scope/scopepresets.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/signalsdialog.h"
#include "widgets/scope/triggercontrol.h"
#include "widgets/scope/triggerrecords.h"
#include "widgets/scope/underlay.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Seconds before and after an event that are visible at first: "Show the last 2 s".
constexpr double kBeforeEvent = 2.0;
constexpr double kBehindEvent = 0.5;
/// Milliseconds by which the date differs from the time that has passed since the first sample. Less is left
/// alone: the clock may be set, or this thread may be late.
constexpr qint64 kSuspended = 60'000;
/// Height, in lines of text, that strips and readings need one below the other.
constexpr int kEnoughRows = 32;
}  // namespace

ScopePanel::ScopePanel(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_layout(new QVBoxLayout(this)),
      m_bar(new ScopeBar(this)),
      m_files(new ScopeFiles(requests, this)),
      m_trigger(new TriggerControl(new TriggerBar(this))),
      m_records(new TriggerRecords(requests, &m_trigger->bar())),
      m_presets(new ScopePresets([this] { return visibleSetup(); }, this)) {
    look::name(this, u"scopePanel"_s, Common::tr("Scope"));
    setAcceptDrops(true);
    const int unit = look::gridUnit(this);
    m_layout->setContentsMargins(unit, unit / 2, unit, 0);
    m_layout->setSpacing(0);
    m_layout->addWidget(m_bar);
    m_layout->addWidget(m_files);
    m_trigger->bar().addControls(m_records);
    m_layout->addWidget(&m_trigger->bar());
    m_trigger->setShown(false);
    connectBar();
    addFileButtons();
    m_menuActions = m_bar->menuActions() +
                    newScopeMoves(this, [this](const std::function<void(ScopeStrips&)>& how) { move(how); });
    m_layout->addStretch(0);
    setSetup(m_setup);
}

ScopePanel::~ScopePanel() = default;

template <typename T>
void ScopePanel::set(T ScopeSetup::*part, const T& value) {
    ScopeSetup setup = m_setup;
    setup.*part = value;
    change(setup);
}

void ScopePanel::connectBar() {
    connect(m_bar, &ScopeBar::widthChosen, this, &ScopePanel::setWidth);
    connect(m_bar, &ScopeBar::pauseRequested, this, &ScopePanel::setPaused);
    connect(m_bar, &ScopeBar::cursorsRequested, this, &ScopePanel::setCursorsShown);
    connect(m_bar, &ScopeBar::laneRequested, this, [this](bool shown) { set(&ScopeSetup::lane, shown); });
    connect(m_bar, &ScopeBar::signalsRequested, this, &ScopePanel::chooseSignals);
    connect(m_bar, &ScopeBar::liveRequested, this, &ScopePanel::backToLive);
    connect(m_bar, &ScopeBar::triggerRequested, m_trigger, &TriggerControl::setShown);
    connect(m_trigger, &TriggerControl::restarted, this, &ScopePanel::restartTrigger);
    connect(m_trigger, &TriggerControl::completed, this, [this](const History& history) {
        m_records->take(history, *m_trigger->picture(), m_modules, m_origin);
    });
    connect(m_presets, &ScopePresets::setupChosen, this, [this](const ScopeSetup& setup) {
        change(setup);
        showWidth();  // the user may have zoomed since it was last set
    });
}

void ScopePanel::addFileButtons() {
    connect(m_files, &ScopeFiles::underMoved, this, &ScopePanel::moveUnder);
    connect(m_files, &ScopeFiles::underRemoved, this, &ScopePanel::removeUnder);
    ScopeExport& exporting = m_files->exporting();
    connect(&exporting, &ScopeExport::frameWanted, this, &ScopePanel::touch);
    QAction* action = exporting.menu()->menuAction();
    action->setToolTip(tr("Exports the visible samples or a picture."));
    QToolButton* button = m_bar->addButton(action, u"scopeExportButton"_s);
    button->setPopupMode(QToolButton::InstantPopup);
    m_bar->addButton(m_files->recordAction(), u"scopeRecordButton"_s);
    QAction* presets = m_presets->menu()->menuAction();
    presets->setToolTip(tr("Saves and restores arrangements of the scope by name."));
    m_bar->addButton(presets, u"scopePresetsButton"_s)->setPopupMode(QToolButton::InstantPopup);
}

void ScopePanel::buildStrips() {
    if (m_strips != nullptr)
        return;
    m_strips = new ScopeStrips(this);
    m_strips->addActions(m_menuActions);
    m_strips->setSetup(m_setup);
    m_strips->time().setWidth(m_setup.seconds);
    m_bar->showTime(m_strips->time());
    connect(m_strips, &ScopeStrips::timeChanged, this, &ScopePanel::showTime);
    connect(m_strips, &ScopeStrips::resized, this, &ScopePanel::touch);
    connect(m_strips, &ScopeStrips::cursorMoved, this, &ScopePanel::moveCursor);
    connect(m_strips, &ScopeStrips::everythingWanted, this, [this] {
        m_everythingWanted = true;
        touch();
    });
    connect(m_strips, &ScopeStrips::heightsChosen, this,
            [this](const auto& heights) { set(&ScopeSetup::heights, heights); });
    m_stripsAndReadings = new QBoxLayout(QBoxLayout::TopToBottom);
    m_stripsAndReadings->addWidget(m_strips, 1);
    m_layout->addLayout(m_stripsAndReadings, 1);
    applyModules();
}

/// Called when cursors are first shown.
void ScopePanel::buildReadings() {
    m_readings = new CursorPanel(this);
    m_readings->setUnfolded(m_setup.readings);
    connect(m_readings, &CursorPanel::unfoldRequested, this,
            [this](bool unfolded) { set(&ScopeSetup::readings, unfolded); });
    connect(m_readings, &CursorPanel::frameWanted, this, &ScopePanel::touch);
    m_stripsAndReadings->addWidget(m_readings);
    placeReadings();
}

/// Places the readings below the strips, or beside them where the strips would become too low.
void ScopePanel::placeReadings() {
    if (m_readings == nullptr)
        return;
    const int room = parentWidget() != nullptr ? parentWidget()->height() : height();
    const bool below = !m_setup.readings || room >= kEnoughRows * fontMetrics().height();
    m_stripsAndReadings->setDirection(below ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_readings->setBeside(!below);
    m_readings->setMaximumWidth(below ? QWIDGETSIZE_MAX : width() * 2 / 5);  // the rest needs scrolling
}

void ScopePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeReadings();
}

void ScopePanel::showEvent(QShowEvent* event) {
    buildStrips();
    touch();
    QWidget::showEvent(event);
}

// ---- the arrangement ----

void ScopePanel::setSetup(const ScopeSetup& setup) {
    const ScopeSetup before = std::exchange(m_setup, setup);
    m_bar->showSetup(setup);
    if (setup.seconds != before.seconds)
        showWidth();
    if (setup.custom != before.custom)
        applyModules();
    if (m_strips != nullptr) {
        m_strips->setSetup(setup);
        if (m_readings != nullptr)
            m_readings->setUnfolded(setup.readings);
        placeReadings();
    }
    touch();
}

void ScopePanel::change(const ScopeSetup& setup) {
    setSetup(setup);
    emit setupChanged(m_setup);
}

/// The setup with the time that is visible, to which the user may have zoomed.
ScopeSetup ScopePanel::visibleSetup() const {
    ScopeSetup setup = m_setup;
    if (m_strips != nullptr)
        setup.seconds = m_strips->time().width();
    return setup;
}

void ScopePanel::chooseSignals() {
    if (findChild<SignalsDialog*>() != nullptr)
        return;
    auto* dialog = new SignalsDialog(m_setup, m_record ? m_record->modules : m_modules, this);
    connect(dialog, &SignalsDialog::setupChosen, this, &ScopePanel::change);
    dialog->open();
}

void ScopePanel::addLaneBits(QMenu& menu) {
    if (m_strips == nullptr || !m_strips->selected() ||
        m_strips->selected()->value() >= m_strips->modules().size())
        return;
    const ScopeModule& module = m_strips->modules()[m_strips->selected()->value()];
    const ModuleType type = module.identity.type;
    QMenu* bits = menu.addMenu(tr("Bits of the lane"));
    const std::vector<ScopeBit> shown = m_setup.bitsOf(type);
    for (const ScopeBit& bit : laneBits(module.identity)) {
        QAction* action = bits->addAction(texts::bitName(bit, module).replace(u'&', u"&&"_s));
        action->setCheckable(true);
        action->setChecked(std::find(shown.begin(), shown.end(), bit) != shown.end());
        connect(action, &QAction::toggled, this, [this, bit, type](bool wanted) {
            ScopeSetup setup = m_setup;
            std::vector<ScopeBit> chosen = setup.bitsOf(type);
            std::erase(chosen, bit);
            if (wanted)
                chosen.push_back(bit);
            setup.bits[type] = chosen;
            setup.lane = true;
            change(setup);
        });
    }
}

void ScopePanel::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    look::name(&menu, u"scopeMenu"_s, Common::tr("Scope"));
    menu.addActions(m_menuActions);
    addLaneBits(menu);
    menu.addSeparator();
    menu.addMenu(m_files->exporting().menu());
    menu.addAction(m_files->recordAction());
    menu.addAction(m_files->openAction());
    menu.addAction(m_files->underAction());
    menu.exec(event->globalPos());
}

/// The dragged file; empty unless there is exactly one.
static QString droppedFile(const QMimeData& data) {
    return data.urls().size() == 1 ? data.urls().front().toLocalFile() : QString();
}

void ScopePanel::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFile(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void ScopePanel::dropEvent(QDropEvent* event) {
    emit m_files->openRequested(droppedFile(*event->mimeData()));
}

// ---- the visible time ----

void ScopePanel::move(const std::function<void(ScopeStrips&)>& how) {
    if (m_strips == nullptr)
        return;
    how(*m_strips);
    showTime();
}

void ScopePanel::setPaused(bool paused) {
    move([paused](ScopeStrips& strips) { paused ? strips.time().stand() : strips.time().roll(); });
}

void ScopePanel::setWidth(double seconds) {
    set(&ScopeSetup::seconds, seconds);
    showWidth();  // the user may have zoomed since it was last set
}

/// Makes the width of the setup the visible one.
void ScopePanel::showWidth() {
    move([this](ScopeStrips& strips) { strips.time().setWidth(m_setup.seconds); });
    m_trigger->setWindow(m_setup.seconds);
}

/// Shows the present window of time in the controls.
void ScopePanel::showTime() {
    m_bar->showTime(m_strips->time());
    if (m_record == nullptr)
        m_trigger->setWindow(m_strips->time().width());
    touch();
}

void ScopePanel::setCursorsShown(bool shown) {
    if (m_strips == nullptr)
        return;
    if (shown)
        m_strips->placeCursors();
    else
        m_strips->showCursors({});
    m_bar->showCursors(shown);
    if (shown && m_readings == nullptr)
        buildReadings();
    if (m_readings != nullptr)
        m_readings->setVisible(shown);
    touch();
}

void ScopePanel::moveCursor(int cursor, double seconds) {
    if (!m_strips->cursors())
        return;
    CursorTimes times = *m_strips->cursors();
    times[static_cast<std::size_t>(cursor)] = seconds;
    m_strips->showCursors(times);
    touch();
}

void ScopePanel::touch() {
    m_touched = true;
    emit frameWanted();
}

// ---- what is shown ----

void ScopePanel::showModules(std::vector<ScopeModule> modules, std::optional<ModuleIndex> selected) {
    if (modules == m_modules && selected == m_selected)
        return;
    m_modules = std::move(modules);
    m_selected = selected;
    applyModules();
}

void ScopePanel::applyModules() {
    m_trigger->showModules(withTraces(m_modules, m_setup.custom), m_selected);
    const std::vector<ScopeModule> modules =
        withTraces(m_record ? m_record->modules : m_modules, m_setup.custom);
    std::optional<ModuleIndex> selected = m_record && m_record->module ? m_record->module : m_selected;
    if (m_record && (!selected || selected->value() >= modules.size()) && !modules.empty())
        selected = ModuleIndex(0);
    m_bar->showWhich(selected && selected->value() < modules.size() ? modules[selected->value()].name
                                                                    : QString());
    if (m_strips != nullptr)
        m_strips->setModules(modules, selected);
    touch();
}

void ScopePanel::showSession(const QString& port, bool simulated) {
    m_origin.port = port;
    m_origin.simulated = simulated;
}

void ScopePanel::showHistory(const History& history, TimePoint now) {
    if (history.zero() != m_zero) {
        m_zero = history.zero();
        m_another = true;
        m_origin.zero = {};
    }
    // While the computer is suspended, the dates go on, but not the time of the samples. Without a
    // connection, that has ended.
    const qint64 zero =
        QDateTime::currentMSecsSinceEpoch() - qRound64(toSeconds(now - m_zero.value_or(now)) * 1e3);
    const bool goesOn = history.end() != now;
    if (!m_origin.zero.isValid() || (goesOn && qAbs(m_zeroMs - zero) > kSuspended)) {
        m_zeroMs = zero;
        m_origin.zero = QDateTime::fromMSecsSinceEpoch(zero);
    }
    m_trigger->follow(history, now, m_origin.zero);
    if (m_strips == nullptr || (!isVisible() && !m_files->exporting().isDue()))
        return;
    if (m_record != nullptr) {
        if (m_touched)
            draw(m_record->history, toSeconds(*m_record->history.end() - *m_record->history.zero()));
        return;
    }
    if (std::exchange(m_another, false)) {
        m_strips->forget();
        if (m_under)
            m_under->forget();
        showTime();
    }
    showTrigger();
    if (m_touched || m_strips->time().rolls())
        drawLive(history, now);
}

std::set<ModuleIndex> ScopePanel::watchedModules() const {
    const std::vector<ModuleIndex> shown = m_setup.fixedModules();
    std::set<ModuleIndex> watched(shown.begin(), shown.end());
    for (const ModuleIndex module : m_trigger->modules())
        watched.insert(module);
    return watched;
}

bool ScopePanel::isPainting() const {
    return m_strips != nullptr && m_strips->isPainting();
}

void ScopePanel::drawLive(const History& history, TimePoint now) {
    m_strips->showUnder(m_under.get());
    const bool whole = !m_under || m_under->follow(history, m_selected, now, m_strips->shownSignals(),
                                                   m_strips->customSignals());
    draw(history, toSeconds(now - m_zero.value_or(now)));
    m_strips->showUnder(nullptr);
    if (!whole)
        touch();
}

void ScopePanel::showTrigger() {
    m_strips->showLevel(m_trigger->level());
    const auto picture = m_trigger->picture();
    if (picture && picture != m_picture) {
        m_strips->time().show(toSeconds(picture->from - *m_zero), toSeconds(picture->to - *m_zero));
        m_strips->showMarker(toSeconds(*m_trigger->firedAt() - *m_zero));
        showTime();
    }
    m_picture = picture;
}

void ScopePanel::restartTrigger() {
    if (m_strips == nullptr || m_record != nullptr)
        return;
    m_strips->showMarker({});
    m_strips->time().roll();
    showTime();
}

void ScopePanel::draw(const History& history, double now) {
    m_touched = false;
    if (m_everythingWanted) {
        m_everythingWanted = false;
        m_strips->showEverything(history);
        showTime();
        m_touched = false;
    }
    m_strips->showFrame(history, now);
    const bool upToDate =
        m_readings == nullptr || !m_readings->isVisible() || m_readings->showReadings(*m_strips, history);
    if (!upToDate || m_strips->isBehind())
        touch();
    const QString title = m_record  ? m_record->title
                          : m_under ? Common::tr("Overlay: %1").arg(m_under->record().title)
                                    : QString();
    m_files->exporting().take(*m_strips, history, now, m_record ? m_record->origin : m_origin, title);
}

void ScopePanel::showRecord(std::shared_ptr<const ScopeRecord> record) {
    if (record == nullptr || record->history.empty())
        return;
    m_record = std::move(record);
    buildStrips();
    m_strips->forget();
    m_strips->showLevel({});
    m_everythingWanted = !m_record->event;
    if (m_record->event) {
        const double at = toSeconds(*m_record->event - *m_record->history.zero());
        m_strips->showMarker(at);
        m_strips->time().show(at - kBeforeEvent, at + kBehindEvent);
    }
    m_bar->showRecord(m_record->origin.simulated ? tr("%1 (simulator)").arg(m_record->title)
                                                 : m_record->title);
    applyModules();
    showTime();
}

void ScopePanel::backToLive() {
    if (m_record == nullptr)
        return;
    m_record.reset();
    m_bar->showRecord({});
    m_picture.reset();
    m_strips->forget();
    applyModules();
    showWidth();  // that of the record was not chosen for the live samples
}

// ---- the recording under the live traces ----

void ScopePanel::showUnder(std::shared_ptr<const ScopeRecord> record) {
    if (record == nullptr || record->history.empty())
        return;
    m_files->showUnder(record->origin.simulated ? tr("%1 (simulator)").arg(record->title) : record->title);
    m_under = std::make_unique<Underlay>(std::move(record));
    backToLive();
    touch();
}

void ScopePanel::removeUnder() {
    m_under.reset();
    m_files->showUnder({});
    touch();
}

void ScopePanel::moveUnder(double share) {
    if (m_under && m_strips != nullptr)
        m_under->shift(share * m_strips->time().width());
    touch();
}

}  // namespace nmc
