// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QSettings;

namespace nmc {

/// The menu View, Colours, which chooses the palette of the program. The last choice is in force from the
/// start.
class ColourChoice : public QObject {
    Q_OBJECT

public:
    /// `settings` stores the choice, and must outlive the menu.
    ColourChoice(QSettings& settings, QObject* parent);

    /// Actions of one group, in the order of look::Colours.
    [[nodiscard]] const QList<QAction*>& actions() const { return m_actions; }

private:
    QList<QAction*> m_actions;
};

}  // namespace nmc
