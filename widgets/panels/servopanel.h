// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/firststep.h"
#include "widgets/panels/modulepage.h"

class QTabWidget;

namespace nmc {

class FirstSteps;
class GainsBox;

/// Everything one PIC-SERVO can be asked for. Motion and jog are always in sight; the rest shares the pages
/// beside them.
class ServoPanel : public ModulePage {
    Q_OBJECT

public:
    explicit ServoPanel(const PanelView& view, QWidget* parent = nullptr);

    /// Into the fields, in sight; sends nothing.
    void stageGains(const servo::SetGain& gains);
    /// With what the first steps are done by, for as long as they are there.
    [[nodiscard]] int spareHeight() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitPages(int width) override;
    void revealTuning() override;
    void showPlaceOf(FirstStep step);

    QTabWidget* m_pages;
    GainsBox* m_gains;
    FirstSteps* m_steps;
};

}  // namespace nmc
