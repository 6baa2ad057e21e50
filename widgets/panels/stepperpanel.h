// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulepage.h"

namespace nmc {

/// The page of a PIC-STEP. The motions are always visible, except where there is very little room;
/// parameters, inputs and outputs, homing, axis, details and expert commands are on the tabs beside them.
class StepperPanel : public ModulePage {
    Q_OBJECT

public:
    StepperPanel(const PanelView& view, Requests& requests);
};

}  // namespace nmc
