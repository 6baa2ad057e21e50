// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QSettings;

namespace nmc {

/// Menu View, Colours: which palette the program has. The one that was chosen last is in force from the
/// start.
class ColourChoice : public QObject {
    Q_OBJECT

public:
    /// `settings` keeps the choice, and must outlive it.
    ColourChoice(QSettings& settings, QObject* parent);

    /// Of one group, in the order of look::Colours.
    [[nodiscard]] const QList<QAction*>& actions() const { return m_actions; }

private:
    QList<QAction*> m_actions;
};

}  // namespace nmc
