// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QTabWidget;
class QWidget;

namespace nmc {

/// Where the focus of a window goes when the control that has it is disabled or hidden. Qt hands it to the
/// next control, which may be the one that drives the other way; here it goes nowhere. It comes back when the
/// control can be used again and nothing else was chosen meanwhile, and Tab goes on from there.
class FocusKeeper : public QObject {
    Q_OBJECT

public:
    /// Belongs to `window`, whose focusNextPrevChild() asks it first.
    explicit FocusKeeper(QWidget& window);

    /// True when what has the focus can keep it no longer: it was let go, and nothing else may take it.
    /// False: it is somebody's Tab.
    bool leave();
    /// A Tab while nothing has the focus. False when there is no place to go on from.
    bool resume(bool forward);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_window;
    QPointer<QWidget> m_left;  ///< what had the focus when it could keep it no longer
};

/// Who turns a page has the focus on its tab, not on whatever the page has to press.
void keepFocusOnTabs(QTabWidget& pages);

}  // namespace nmc
