// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulecontext.h"
#include "widgets/panels/statustable.h"

namespace nmc {

class Command;

/// Every status bit of a PIC-SERVO by its data sheet name, the other status items, and the raw bytes.
class DetailsBox : public StatusTable {
    Q_OBJECT

public:
    DetailsBox(ModuleContext& context, QWidget* parent);

private:
    void refresh();

    ModuleContext& m_context;
    QLabel* m_analog;
    QLabel* m_velocity;
    QLabel* m_error = nullptr;  ///< CMC and SC only, like m_points
    QLabel* m_points = nullptr;
    QLabel* m_home;
    QLabel* m_raw;
    Command* m_clear;
    Command* m_saveHome;
};

}  // namespace nmc
