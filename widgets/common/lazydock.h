// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QKeySequence>

namespace nmc {

/// A dock whose content is built when it is seen for the first time. Its key shows it, brings it to the front
/// where it stands behind another's tab, and closes it where it is seen.
class LazyDock : public QDockWidget {
    Q_OBJECT

public:
    /// In front, whatever is beside it.
    void open();
    [[nodiscard]] bool seen() const { return m_seen; }

signals:
    /// The user wants it, and it may have too little room.
    void roomWanted();
    /// It can be seen, and what it shows may be old.
    void opened();

protected:
    LazyDock(const QString& objectName, const QString& title, const QKeySequence& key, QWidget* parent);

    /// The content, unless it is there.
    virtual void build() = 0;

private:
    bool m_seen = false;
    bool m_wasSeen = false;  ///< before what is under way
};

}  // namespace nmc
