// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulecontext.h"
#include "widgets/panels/statustable.h"

namespace nmc {

class Command;

/// Every status bit of a PIC-STEP by its data sheet name, the other status items, and the raw bytes.
class StepperDetailsBox : public StatusTable {
    Q_OBJECT

public:
    StepperDetailsBox(ModuleContext& context, QWidget* parent);

private:
    void refresh();
    [[nodiscard]] QString timer() const;

    ModuleContext& m_context;
    QLabel* m_mode = nullptr;
    QLabel* m_timer = nullptr;
    QLabel* m_analog = nullptr;
    QLabel* m_home = nullptr;
    QLabel* m_raw = nullptr;
    Command* m_zero;
    Command* m_saveHome;
};

}  // namespace nmc
