// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStackedWidget>
#include <array>

#include "widgets/panels/panelview.h"

class QLabel;

namespace nmc {

class GenericPanel;
class ModulePage;
class ServoPanel;
class StepPanel;

/// The middle of the window: the panel that fits the selected module, or what to do when there is none.
class ModulePanel : public QStackedWidget {
    Q_OBJECT

public:
    explicit ModulePanel(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const PanelView& view);
    /// No module: `text` says why and what to do.
    void showNothing(const QString& text);
    /// A new connection: low speeds again.
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);

signals:
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// On press and every 100 ms while held.
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// The user changed what the panel knows of an axis; nothing is sent by that.
    void settingsEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

private:
    [[nodiscard]] std::array<ModulePage*, 2> pages() const;
    /// Only the page in sight decides how much room is needed.
    void bringUp(QWidget* page);

    QLabel* m_empty;
    ServoPanel* m_servo;
    StepPanel* m_stepper;
    GenericPanel* m_generic;
};

}  // namespace nmc
