// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "widgets/panels/modulecontext.h"

class QLabel;
class QLineEdit;

namespace nmc {

class GlyphLabel;

/// Head of the page of a PIC-I/O: what module it is, the name that the user gives it, and whether it answers.
class IoHead : public QFrame {
    Q_OBJECT

public:
    IoHead(ModuleContext& context, QWidget* parent);

private:
    void refresh();

    ModuleContext& m_context;
    GlyphLabel* m_glyph;
    QLabel* m_module;
    QLabel* m_type;
    QLabel* m_state;
    QLabel* m_meaning;
    QLineEdit* m_name;
};

}  // namespace nmc
