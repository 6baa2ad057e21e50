// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopebar.h"

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <cmath>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ScopeBar::ScopeBar(QWidget* parent)
    : QWidget(parent),
      m_buttons(new FlowLayout(look::gridUnit(this) / 2)),
      m_window(new QComboBox(this)),
      m_which(look::newMutedLabel({}, this)),
      m_record(new QLabel(this)),
      m_recordRow(new QWidget(this)),
      m_pause(newAction(u"scopePauseAction"_s, Common::tr("Pause"),
                        tr("Freezes the display (Ctrl+P). Recording of samples continues."),
                        QKeySequence(Qt::CTRL | Qt::Key_P))),
      m_cursors(newAction(u"scopeCursorsAction"_s, Common::tr("Cursors"),
                          tr("Shows two cursors to measure with: drag them (C)."), QKeySequence(Qt::Key_C))),
      m_lane(newAction(u"scopeLaneAction"_s, tr("Status bits"),
                       tr("Shows the status bits of the selected module over time (B)."),
                       QKeySequence(Qt::Key_B))) {
    form::fill(this, form::newColumn(this, {m_buttons, newRecordRow()}, 0));
    buildWindowBox();
    buildButtons();
}

QAction* ScopeBar::newAction(const QString& objectName, const QString& text, const QString& meaning,
                             const QKeySequence& key) {
    QAction* action = look::newAction(this, objectName, text, meaning, key);
    // Plain letters and arrow keys act on the plots only while these have the focus.
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_menuActions << action;
    return action;
}

QToolButton* ScopeBar::addButton(QAction* action, const QString& objectName) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(action->icon().isNull() ? Qt::ToolButtonTextOnly
                                                       : Qt::ToolButtonTextBesideIcon);
    look::name(button, objectName, action->text());
    connect(action, &QAction::changed, button,
            [button] { button->setAccessibleName(button->defaultAction()->text()); });
    m_buttons->insertWidget(m_buttons->count() - 1, button);
    return button;
}

void ScopeBar::buildWindowBox() {
    for (const int seconds : {1, 2, 5, 10, 30, 60, 300, 600})
        m_window->addItem(seconds < 120 ? tr("%1 s").arg(seconds) : tr("%1 min").arg(seconds / 60), seconds);
    look::name(m_window, u"scopeWindowBox"_s, tr("Time shown by the scope"));
    m_window->setToolTip(tr("Sets how much time the scope shows."));
    connect(m_window, &QComboBox::activated, this,
            [this](int index) { emit widthChosen(m_window->itemData(index).toDouble()); });
    m_buttons->addWidget(form::newLabel(tr("Sho&w"), m_window));
    m_buttons->addWidget(m_window);
    m_buttons->addWidget(m_which);
}

void ScopeBar::buildButtons() {
    m_pause->setShortcutContext(Qt::WindowShortcut);
    m_pause->setCheckable(true);
    m_pause->setIcon(icons::tinted(u"player-pause"_s));
    connect(m_pause, &QAction::triggered, this, &ScopeBar::pauseRequested);
    addAction(m_pause);
    addButton(m_pause, u"scopePauseButton"_s);

    m_cursors->setCheckable(true);
    connect(m_cursors, &QAction::triggered, this, &ScopeBar::cursorsRequested);
    addButton(m_cursors, u"scopeCursorsButton"_s);

    m_lane->setCheckable(true);
    connect(m_lane, &QAction::triggered, this, &ScopeBar::laneRequested);
    addButton(m_lane, u"scopeLaneButton"_s);

    QAction* choose = newAction(u"scopeSignalsAction"_s, tr("Signals…"),
                                tr("Selects signals for the strips (S)."), QKeySequence(Qt::Key_S));
    connect(choose, &QAction::triggered, this, &ScopeBar::signalsRequested);
    addButton(choose, u"scopeSignalsButton"_s);

    QAction* trigger =
        newAction(u"scopeTriggerAction"_s, Common::tr("Trigger"),
                  tr("Waits for a signal or a status bit, and holds the picture around it (T)."),
                  QKeySequence(Qt::Key_T));
    trigger->setCheckable(true);
    connect(trigger, &QAction::toggled, this, &ScopeBar::triggerRequested);
    addButton(trigger, u"scopeTriggerButton"_s);
}

/// A row of its own, because titles are long.
QWidget* ScopeBar::newRecordRow() {
    auto* back = new QToolButton(this);
    back->setText(tr("Back to live"));
    back->setToolTip(tr("Returns to the live display."));
    look::name(back, u"scopeLiveButton"_s, tr("Back to live"));
    connect(back, &QToolButton::clicked, this, &ScopeBar::liveRequested);
    look::name(m_record, u"scopeRecordLabel"_s, tr("Source of the picture"));
    m_record->setWordWrap(true);
    m_recordRow->setLayout(form::newLine(this, {back, {m_record, 1}}, form::kUsual));
    m_recordRow->layout()->setContentsMargins(0, look::gridUnit(this) / 2, 0, 0);
    m_recordRow->hide();
    return m_recordRow;
}

void ScopeBar::showSetup(const ScopeSetup& setup) {
    m_lane->setChecked(setup.lane);
}

void ScopeBar::showTime(const TimeWindow& time) {
    m_pause->setChecked(!time.rolls());
    constexpr double kSame = 1e-6;  // s: moving the window along rounds its width
    const int whole = qRound(time.width());
    m_window->setCurrentIndex(std::abs(time.width() - whole) < kSame ? m_window->findData(whole) : -1);
    m_window->setPlaceholderText(texts::stretch(time.width()));
}

void ScopeBar::showCursors(bool shown) {
    m_cursors->setChecked(shown);
}

void ScopeBar::showWhich(const QString& module) {
    look::setText(m_which, module);
}

void ScopeBar::showRecord(const QString& title) {
    look::setText(m_record, title);
    m_recordRow->setVisible(!title.isEmpty());
}

}  // namespace nmc
