// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QObject>
#include <QStringList>
#include <functional>

#include "widgets/scope/scopesetup.h"

class QMenu;

namespace nmc {

/// Arrangements of the scope that the user has named, and the menu in which they are saved, chosen and
/// removed. GUI thread.
class ScopePresets : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 30;

    /// `present`: what a new preset is made of.
    ScopePresets(std::function<ScopeSetup()> present, QWidget* panel);

    [[nodiscard]] QMenu* menu() const { return m_menu; }
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

    std::function<ScopeSetup()> m_present;
    QWidget* m_panel;
    QMenu* m_menu;
    QMenu* m_removes;
    QMap<QString, ScopeSetup> m_presets;
};

}  // namespace nmc
