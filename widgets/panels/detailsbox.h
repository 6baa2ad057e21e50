// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/statustable.h"

namespace nmc {

/// Every status bit of a PIC-SERVO by its data sheet name, the other status items, and the raw bytes.
class DetailsBox : public StatusTable {
    Q_OBJECT

public:
    DetailsBox(ModuleContext& context, QWidget* parent);

private:
    void refresh();

    QLabel* m_velocity;
    QLabel* m_error = nullptr;  ///< CMC and SC only, like m_points
    QLabel* m_points = nullptr;
    Command* m_clear;
};

}  // namespace nmc
