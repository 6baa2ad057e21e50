// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopepanel.h"

#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/scope/cursortable.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/signalsdialog.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kKeyZoom = 1.5;
constexpr double kKeyPan = 0.1;  ///< of what is seen
}  // namespace

ScopePanel::ScopePanel(QWidget* parent)
    : QWidget(parent),
      m_layout(new QVBoxLayout(this)),
      m_bar(new QHBoxLayout),
      m_window(new QComboBox(this)),
      m_which(look::newMutedLabel({}, this)),
      m_recordLabel(new QLabel(this)),
      m_back(new QToolButton(this)) {
    look::name(this, u"scopePanel"_s, tr("Scope"));
    const int unit = look::gridUnit(this);
    m_layout->setContentsMargins(unit, unit / 2, unit, 0);
    m_layout->setSpacing(0);
    m_bar->setSpacing(unit);
    m_layout->addLayout(m_bar);
    buildBar();
    m_layout->addStretch(0);
}

QAction* ScopePanel::newAction(const QString& objectName, const QString& text, const QString& meaning,
                               const QList<QKeySequence>& keys) {
    auto* action = new QAction(text, this);
    action->setObjectName(objectName);
    action->setToolTip(meaning);
    action->setShortcuts(keys);
    // Plain letters and arrows belong to the plots only while these have the focus.
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_menuActions << action;
    return action;
}

QToolButton* ScopePanel::addButton(QAction* action, const QString& objectName) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(action->icon().isNull() ? Qt::ToolButtonTextOnly
                                                       : Qt::ToolButtonTextBesideIcon);
    look::name(button, objectName, action->text());
    m_bar->addWidget(button);
    return button;
}

void ScopePanel::buildBar() {
    for (const int seconds : {1, 2, 5, 10, 30, 60, 300, 600})
        m_window->addItem(seconds < 120 ? tr("%1 s").arg(seconds) : tr("%1 min").arg(seconds / 60), seconds);
    look::name(m_window, u"scopeWindowBox"_s, tr("Time shown by the scope"));
    m_window->setToolTip(tr("How much time the scope shows."));
    connect(m_window, &QComboBox::activated, this, &ScopePanel::setWidth);
    auto* label = new QLabel(tr("Sho&w"), this);
    label->setBuddy(m_window);
    m_bar->addWidget(label);
    m_bar->addWidget(m_window);

    m_pause = newAction(u"scopePauseAction"_s, tr("Pause"),
                        tr("Holds the picture still (Ctrl+P). Samples are still recorded."),
                        {QKeySequence(Qt::CTRL | Qt::Key_P)});
    m_pause->setShortcutContext(Qt::WindowShortcut);
    m_pause->setCheckable(true);
    m_pause->setIcon(icons::tinted(u"player-pause"_s));
    connect(m_pause, &QAction::triggered, this, &ScopePanel::setPaused);
    addAction(m_pause);
    addButton(m_pause, u"scopePauseButton"_s);

    m_cursors = newAction(u"scopeCursorsAction"_s, tr("Cursors"),
                          tr("Two cursors to measure with: drag them (C)."), {QKeySequence(Qt::Key_C)});
    m_cursors->setCheckable(true);
    connect(m_cursors, &QAction::triggered, this, &ScopePanel::setCursorsShown);
    addButton(m_cursors, u"scopeCursorsButton"_s);

    m_lane =
        newAction(u"scopeLaneAction"_s, tr("Status bits"),
                  tr("The status bits of the selected module over time (B)."), {QKeySequence(Qt::Key_B)});
    m_lane->setCheckable(true);
    connect(m_lane, &QAction::triggered, this, [this](bool shown) {
        ScopeSetup setup = m_setup;
        setup.lane = shown;
        change(setup);
    });
    addButton(m_lane, u"scopeLaneButton"_s);

    QAction* choose =
        newAction(u"scopeSignalsAction"_s, tr("Signals…"),
                  tr("Which signals of which modules stand in which strip (S)."), {QKeySequence(Qt::Key_S)});
    connect(choose, &QAction::triggered, this, &ScopePanel::chooseSignals);
    addButton(choose, u"scopeSignalsButton"_s);

    m_back->setText(tr("Back to live"));
    m_back->setToolTip(tr("Shows what the modules say now."));
    look::name(m_back, u"scopeLiveButton"_s, tr("Back to live"));
    connect(m_back, &QToolButton::clicked, this, &ScopePanel::backToLive);
    m_bar->addWidget(m_which);
    m_bar->addWidget(m_recordLabel, 1);
    m_bar->addWidget(m_back);
    m_recordLabel->setObjectName(u"scopeRecordLabel"_s);
    m_recordLabel->hide();
    m_back->hide();
    m_bar->addStretch(1);
    buildMoves();
    setSetup(m_setup);
}

/// What the wheel and the mouse can do, for the keyboard.
void ScopePanel::buildMoves() {
    const auto add = [this](const QString& objectName, const QString& text, const QList<QKeySequence>& keys,
                            auto&& move) {
        connect(newAction(objectName, text, text, keys), &QAction::triggered, this, [this, move] {
            if (m_strips == nullptr)
                return;
            move(*m_strips);
            showTime();
        });
    };
    const auto zoom = [](double factor) {
        return [factor](ScopeStrips& strips) {
            strips.time().zoom(factor, (strips.time().left() + strips.time().right()) / 2);
        };
    };
    const auto pan = [](double share) {
        return [share](ScopeStrips& strips) { strips.time().pan(share * strips.time().width()); };
    };
    add(u"scopeZoomInAction"_s, tr("Zoom in"), {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal)},
        zoom(1 / kKeyZoom));
    add(u"scopeZoomOutAction"_s, tr("Zoom out"), {QKeySequence(Qt::Key_Minus)}, zoom(kKeyZoom));
    add(u"scopeBackAction"_s, tr("Earlier"), {QKeySequence(Qt::Key_Left)}, pan(-kKeyPan));
    add(u"scopeForwardAction"_s, tr("Later"), {QKeySequence(Qt::Key_Right)}, pan(kKeyPan));
    add(u"scopePresentAction"_s, tr("To the present"), {QKeySequence(Qt::Key_End)},
        [](ScopeStrips& strips) { strips.time().roll(); });
    add(u"scopeUpAction"_s, tr("Values up"), {QKeySequence(Qt::Key_Up)},
        [](ScopeStrips& strips) { strips.panValues(kKeyPan); });
    add(u"scopeDownAction"_s, tr("Values down"), {QKeySequence(Qt::Key_Down)},
        [](ScopeStrips& strips) { strips.panValues(-kKeyPan); });
    add(u"scopeValuesInAction"_s, tr("Zoom values in"), {QKeySequence(Qt::CTRL | Qt::Key_Plus)},
        [](ScopeStrips& strips) { strips.zoomValues(1 / kKeyZoom); });
    add(u"scopeValuesOutAction"_s, tr("Zoom values out"), {QKeySequence(Qt::CTRL | Qt::Key_Minus)},
        [](ScopeStrips& strips) { strips.zoomValues(kKeyZoom); });
    add(u"scopeFitAction"_s, tr("Fit the values"), {QKeySequence(Qt::Key_A)},
        [](ScopeStrips& strips) { strips.fitValues(); });
    add(u"scopeEverythingAction"_s, tr("Show everything"), {QKeySequence(Qt::Key_Home)},
        [](ScopeStrips& strips) { emit strips.everythingWanted(); });
}

void ScopePanel::buildStrips() {
    if (m_strips != nullptr)
        return;
    m_strips = new ScopeStrips(this);
    m_strips->addActions(m_menuActions);
    m_strips->setSetup(m_setup);
    m_strips->time().setWidth(m_setup.seconds);
    connect(m_strips, &ScopeStrips::timeChanged, this, &ScopePanel::showTime);
    connect(m_strips, &ScopeStrips::cursorMoved, this, &ScopePanel::moveCursor);
    connect(m_strips, &ScopeStrips::everythingWanted, this, [this] {
        m_everythingWanted = true;
        touch();
    });
    m_table = new CursorTable(this);
    m_table->hide();
    auto* row = new QHBoxLayout;
    row->addWidget(m_strips, 1);
    row->addWidget(m_table);
    m_layout->addLayout(row, 1);
    applyModules();
}

void ScopePanel::showEvent(QShowEvent* event) {
    buildStrips();
    touch();
    QWidget::showEvent(event);
}

// ---- what is arranged ----

void ScopePanel::setSetup(const ScopeSetup& setup) {
    m_setup = setup;
    m_lane->setChecked(setup.lane);
    m_window->setCurrentIndex(m_window->findData(qRound(setup.seconds)));
    if (m_strips != nullptr)
        m_strips->setSetup(setup);
    touch();
}

void ScopePanel::change(const ScopeSetup& setup) {
    setSetup(setup);
    emit setupChanged(m_setup);
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
    const ModuleType type = m_strips->modules()[m_strips->selected()->value()].identity.type;
    QMenu* bits = menu.addMenu(tr("Bits of the lane"));
    const std::vector<ScopeBit> shown = m_setup.bitsOf(type);
    for (const ScopeBit& bit : laneBits(type)) {
        QAction* action = bits->addAction(texts::bitName(bit, type));
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
    look::name(&menu, u"scopeMenu"_s, tr("Scope"));
    menu.addActions(m_menuActions);
    addLaneBits(menu);
    menu.exec(event->globalPos());
}

// ---- the time that is seen ----

bool ScopePanel::paused() const {
    return m_pause->isChecked();
}

void ScopePanel::setPaused(bool paused) {
    if (m_strips == nullptr)
        return;
    if (paused)
        m_strips->time().stand();
    else
        m_strips->time().roll();
    showTime();
}

void ScopePanel::setWidth(int index) {
    ScopeSetup setup = m_setup;
    setup.seconds = m_window->itemData(index).toDouble();
    if (m_strips != nullptr)
        m_strips->time().setWidth(setup.seconds);
    change(setup);
}

/// The controls tell what the window of time has become.
void ScopePanel::showTime() {
    const TimeWindow& time = m_strips->time();
    m_pause->setChecked(!time.rolls());
    const int index = m_window->findData(qRound(time.width()));
    m_window->setCurrentIndex(index >= 0 && time.width() >= 1 ? index : -1);
    m_window->setPlaceholderText(texts::stretch(time.width()));
    touch();
}

void ScopePanel::setCursorsShown(bool shown) {
    if (m_strips == nullptr)
        return;
    const TimeWindow& time = m_strips->time();
    m_strips->showCursors(
        shown ? std::optional(CursorTimes{time.left() + time.width() / 3, time.left() + time.width() * 2 / 3})
              : std::nullopt);
    m_cursors->setChecked(shown);
    m_table->setVisible(shown);
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

void ScopePanel::showModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected) {
    const bool another = selected != m_selected;
    m_modules = modules;
    m_selected = selected;
    if (another && !m_record && m_strips != nullptr) {
        m_strips->time().roll();
        showTime();
    }
    applyModules();
}

void ScopePanel::applyModules() {
    const std::vector<ScopeModule>& modules = m_record ? m_record->modules : m_modules;
    std::optional<ModuleIndex> selected = m_record && m_record->module ? m_record->module : m_selected;
    if (m_record && (!selected || selected->value() >= modules.size()) && !modules.empty())
        selected = ModuleIndex(0);
    look::setText(m_which, selected && selected->value() < modules.size() ? modules[selected->value()].name
                                                                          : QString());
    if (m_strips != nullptr)
        m_strips->setModules(modules, selected);
}

void ScopePanel::showHistory(const History& history, TimePoint now) {
    if (m_strips == nullptr || !isVisible())
        return;
    if (m_record != nullptr) {
        if (m_touched)
            draw(m_record->history, toSeconds(*m_record->history.end() - *m_record->history.zero()));
        return;
    }
    if (history.zero() != m_zero) {
        m_zero = history.zero();
        m_strips->forget();
        showTime();
    }
    if (m_touched || m_strips->time().rolls())
        draw(history, toSeconds(now - m_zero.value_or(now)));
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
    if (m_table->isVisible())
        m_table->showReadings(*m_strips, history);
}

void ScopePanel::showRecord(std::shared_ptr<const ScopeRecord> record) {
    if (record == nullptr || record->history.empty())
        return;
    m_record = std::move(record);
    window()->raise();
    buildStrips();
    m_strips->forget();
    m_everythingWanted = true;
    m_recordLabel->setText(m_record->simulated ? tr("%1 (simulator)").arg(m_record->title) : m_record->title);
    m_recordLabel->setVisible(true);
    m_back->setVisible(true);
    applyModules();
    showTime();
}

void ScopePanel::backToLive() {
    if (m_record == nullptr)
        return;
    m_record.reset();
    m_recordLabel->setVisible(false);
    m_back->setVisible(false);
    m_zero.reset();
    m_strips->forget();
    applyModules();
    showTime();
}

}  // namespace nmc
