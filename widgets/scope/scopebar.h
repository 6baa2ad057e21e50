// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QWidget>

#include "widgets/scope/scopesetup.h"
#include "widgets/scope/timewindow.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace nmc {

class FlowLayout;

/// The scope's tool bar: how much time is shown, and what else is shown besides the traces. It also names the
/// selected module.
class ScopeBar : public QWidget {
    Q_OBJECT

public:
    explicit ScopeBar(QWidget* parent);

    /// The actions of this bar's own buttons, for a context menu and for the shortcuts of the plots.
    [[nodiscard]] const QList<QAction*>& menuActions() const { return m_menuActions; }
    /// Adds a button to the left of the module's name.
    QToolButton* addButton(QAction* action, const QString& objectName);

    void showSetup(const ScopeSetup& setup);
    void showTime(const TimeWindow& time);
    void showCursors(bool shown);
    void showWhich(const QString& module);
    /// Shows the title of the record that is displayed instead of the live samples; empty: none.
    void showRecord(const QString& title);

signals:
    void widthChosen(double seconds);
    void pauseRequested(bool paused);
    void cursorsRequested(bool shown);
    void laneRequested(bool shown);
    void signalsRequested();
    void triggerRequested(bool shown);
    void liveRequested();

private:
    QAction* newAction(const QString& objectName, const QString& text, const QString& meaning,
                       const QKeySequence& key);
    void buildWindowBox();
    void buildButtons();
    [[nodiscard]] QWidget* newRecordRow();

    QList<QAction*> m_menuActions;  ///< filled while the actions below are created
    FlowLayout* m_buttons;
    QComboBox* m_window;
    QLabel* m_which;
    QLabel* m_record;
    QWidget* m_recordRow;
    QAction* m_pause;
    QAction* m_cursors;
    QAction* m_lane;
};

}  // namespace nmc
