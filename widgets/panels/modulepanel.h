// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QStackedWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;

namespace nmc {

class GenericPanel;
class ModulePage;
class ServoPanel;

/// The middle of the window: the panel that fits the selected module, or what to do when there is none.
class ModulePanel : public QStackedWidget {
    Q_OBJECT

public:
    explicit ModulePanel(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const PanelView& view);
    /// No module: `text` says why and what to do.
    void showNothing(const QString& text);
    /// A new connection: nothing that was typed, found or remembered for the modules of the last one is left.
    void forgetModules();
    /// The chain is looked for anew: low speeds again.
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);
    /// Into the fields of the PIC-SERVO that is shown; sends nothing.
    void stageGains(const servo::SetGain& gains);

signals:
    void stepResponseWanted();
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// On press and every 100 ms while held.
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// The user changed what the panel knows of an axis; nothing is sent by that.
    void settingsEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

private:
    /// Built when the first module of its kind is shown: a window is there at once without them.
    [[nodiscard]] ModulePage& servo();
    [[nodiscard]] ModulePage& stepper();
    void adopt(ModulePage* page);
    /// Only the page in sight decides how much room is needed.
    void bringUp(QWidget* page);

    QLabel* m_empty;
    GenericPanel* m_generic;
    ServoPanel* m_servo = nullptr;
    ModulePage* m_stepper = nullptr;
    QList<ModulePage*> m_pages;  ///< those that were built
    std::optional<int> m_holdInterval;
};

}  // namespace nmc
