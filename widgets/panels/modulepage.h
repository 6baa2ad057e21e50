// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QLayout;
class QTabWidget;

namespace nmc {

/// What the panels of both chips have in common: clicks become intents of the module that is shown, one at a
/// time until it has spoken again; stops never wait.
class ModulePage : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const PanelView& view);
    /// A new connection: low speeds again.
    virtual void resetSpeeds() = 0;
    virtual void endHold() = 0;
    virtual void setHoldInterval(int milliseconds) = 0;

signals:
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// What the panel knows of the axis was changed by hand; nothing is sent by that.
    void settingsEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

protected:
    /// The head above; motions in sight at the left, the pages beside them.
    void layOut(QWidget* head, QLayout* motions, QTabWidget* pages);
    void pass(const Intent& intent);
    /// Done to the settings of the module that is shown. While it is being shown nobody edits: what a box
    /// says then is not the user's.
    void passEdit(const SettingsEdit& edit);
    virtual void showBoxes(const PanelView& view) = 0;
    virtual void setBusy(bool busy) = 0;

private:
    ModuleIndex m_module;
    AxisSettings m_settings;  ///< of m_module
    bool m_showing = false;
    TimePoint m_latestTime;
    /// A click that was passed on, until what it asked for has ended and the module has spoken again: a
    /// double click is one command, and a status that was on its way ends nothing.
    std::optional<TimePoint> m_askedAt;
};

}  // namespace nmc
