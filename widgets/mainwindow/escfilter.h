// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for Esc and reports it on press, wherever the focus is: in fields, lists,
/// dialogs, menus, popups. The key is passed on: it still closes a menu or a dialog.
class EscFilter : public QObject {
    Q_OBJECT

public:
    explicit EscFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// Once for each press; auto-repeat is ignored.
    void pressed();

private:
    /// The present press was reported. The filter sees each press several times: as shortcut override, for
    /// the window, and for each parent that receives it.
    bool m_told = false;
};

}  // namespace nmc
