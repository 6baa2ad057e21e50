// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QObject>
#include <QStringList>

#include "widgets/scope/scopesetup.h"

class QMenu;

namespace nmc {

/// Arrangements of the scope that the user has named, and the menu in which they are saved, chosen and
/// removed. GUI thread.
class ScopePresets : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 30;

    explicit ScopePresets(QWidget* panel);

    [[nodiscard]] QMenu* menu() const { return m_menu; }
    /// What a new preset is made of.
    void showSetup(const ScopeSetup& setup) { m_setup = setup; }
    /// Each name, followed by its setup as text.
    void showPresets(const QStringList& presets);

signals:
    void setupChosen(const nmc::ScopeSetup& setup);
    /// As for showPresets(), to be kept between sessions.
    void presetsChanged(const QStringList& presets);

private:
    void fillMenu();
    void askForName();
    void changed();

    QWidget* m_panel;
    QMenu* m_menu;
    QMenu* m_removes;
    ScopeSetup m_setup;
    QMap<QString, ScopeSetup> m_presets;
};

}  // namespace nmc
