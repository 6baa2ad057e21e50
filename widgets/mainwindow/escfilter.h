// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for Esc and tells it on press, wherever the focus is: fields, lists,
/// dialogs, menus, popups. The key goes on its way: a menu or a dialog still closes by it.
class EscFilter : public QObject {
    Q_OBJECT

public:
    explicit EscFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// Once for each press; auto-repeat is ignored.
    void pressed();

private:
    /// One press passes here several times: as shortcut override, for the window, for each parent that takes
    /// it.
    bool m_told = false;
};

}  // namespace nmc
