// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulepage.h"

namespace nmc {

/// The page of a PIC-I/O: its pins at the left; A/D, PWM and counter beside them.
class IoPanel : public ModulePage {
    Q_OBJECT

public:
    IoPanel(const PanelView& view, Requests& requests);
};

}  // namespace nmc
