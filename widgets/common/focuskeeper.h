// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QTabWidget;
class QWidget;

namespace nmc {

/// Handles the focus of a window when the control that has it is disabled or hidden. Qt would pass it to the
/// next control, which may be the one that drives the other way; with this class, nothing gets it. It returns
/// when the control is enabled again and nothing else has been focused meanwhile, and Tab continues from
/// there.
class FocusKeeper : public QObject {
    Q_OBJECT

public:
    /// Belongs to `window`, whose focusNextPrevChild() first calls leave() and resume().
    explicit FocusKeeper(QWidget& window);

    /// If the focused control can no longer keep the focus, releases it and returns true: nothing else may
    /// take it. Returns false if the user pressed Tab.
    bool leave();
    /// Handles Tab while nothing has the focus. Returns false if there is no place to continue from.
    bool resume(bool forward);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_window;
    QPointer<QWidget> m_left;  ///< the control that could no longer keep the focus
};

/// When the user turns a page, moves the focus to the tab bar instead of a button on the new page; if there
/// is no tab bar, nothing gets it.
void keepFocusOnTabs(QTabWidget& pages);

}  // namespace nmc
