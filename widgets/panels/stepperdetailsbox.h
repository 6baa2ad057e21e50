// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/statustable.h"

namespace nmc {

/// Every status bit of a PIC-STEP by its data sheet name, the other status items, and the raw bytes.
class StepperDetailsBox : public StatusTable {
    Q_OBJECT

public:
    StepperDetailsBox(ModuleContext& context, QWidget* parent);

private:
    void refresh();
    [[nodiscard]] QString timer() const;

    QLabel* m_mode = nullptr;
    QLabel* m_timer = nullptr;
    Command* m_zero;
};

}  // namespace nmc
