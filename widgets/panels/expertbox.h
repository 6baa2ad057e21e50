// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/panels/modulecontext.h"

namespace nmc {

class Command;

/// The commands of a chip that are needed least often: its motion commands bit by bit, as the data sheet
/// names them, in native numbers (DS-V 5.2, DS-S 5.1). Each shows what the chip will do, and the bytes.
class ExpertBox : public QWidget {
    Q_OBJECT

public:
    ExpertBox(ModuleContext& context, QWidget* parent);

private:
    void askBeforeReset();
    void refresh();

    ModuleContext& m_context;
    Command* m_reset;
};

}  // namespace nmc
