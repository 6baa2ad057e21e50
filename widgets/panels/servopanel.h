// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/firststep.h"
#include "widgets/panels/modulepage.h"

class QTabWidget;

namespace nmc {

class FirstSteps;
class GainsBox;

/// The page of a PIC-SERVO. The motions are always visible, except where there is very little room; the rest
/// is on the tabs beside them.
class ServoPanel : public ModulePage {
    Q_OBJECT

public:
    ServoPanel(const PanelView& view, Requests& requests);

    /// Fills the gains into the fields and shows these; sends nothing.
    void stageGains(const servo::SetGain& gains);
    /// Takes the controls for the first steps into account, too, while these are shown.
    [[nodiscard]] int spareHeight() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void revealTuning() override;
    void showPlaceOf(FirstStep step);

    QTabWidget* m_pages;
    GainsBox* m_gains;
    FirstSteps* m_steps;
};

}  // namespace nmc
