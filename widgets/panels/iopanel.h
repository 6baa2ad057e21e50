// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulepage.h"

namespace nmc {

/// Everything one PIC-I/O can be asked for: its pins at the left; A/D, PWM, counter and details beside them.
class IoPanel : public ModulePage {
    Q_OBJECT

public:
    explicit IoPanel(const PanelView& view, QWidget* parent = nullptr);
};

}  // namespace nmc
